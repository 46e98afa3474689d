// What a panel answers to its strain, and to the curvature of its middle plane where it bends by its layers: the sum
// over its layers and its points.
//
// A section whose neutral axis moves stretches its middle plane, by more where it is curved more. The mean strain of a
// panel cannot follow, so that a panel which bends by its layers has strains of its own at its points, A_k times seven
// numbers, which do no work on membrane forces of the five forms that a panel has (Simo and Rifai 1990, enhanced
// assumed strain). They are found so that its membrane forces are of these forms.
// Where the search ends without them, PanelResponse::left says so; the energy balance lacks the work of what is left.
#pragma once

#include <array>
#include <cstdint>

#include "panel/membrane.h"
#include "panel/sheet.h"

namespace hinge::panel {

inline constexpr std::uint8_t all_layers = 255;  ///< a bit for each

/// How the middle plane is curved at each point, in the sheet's axes: [k11, k22, 2 k12], 1/m. Positive where the side
/// that the normal points to is hollow: a layer at the height z has the strain of the middle plane less z times this.
using Curvatures = std::array<Vec3, 4>;

inline constexpr int own_strains = 7;
using Mat37 = Eigen::Matrix<double, 3, own_strains>;
struct OwnStrains {
    std::array<Mat37, 4> at;      ///< A_k, of each point
    Mat3 elastic = Mat3::Zero();  ///< the sheet's membrane stiffness, N/m
};
OwnStrains own_strains_of(const Sheet& sheet, const Shape& quadrilateral);

/// Stiffness of a panel: of its mean strain and p (5) and of the curvature at each of its points (3 each).
using Mat17 = Eigen::Matrix<double, 17, 17>;

struct PanelResponse {
    Resultants resultants;
    std::array<Vec3, 4> moment{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< of each point, N m^2/m
    Mat5 tangent = Mat5::Zero();                  ///< d(resultants)/d(mean strain, p); not where it bends by its layers
    double stored = 0, dissipated = 0, used = 0;  ///< J, J, part of the ultimate strain
    std::array<double, most_layers> stored_in{};  ///< each layer, J
    std::uint8_t tears = 0;                       ///< layers that reach their ultimate strain
    double left = 0;                              ///< part of the membrane forces that is not of the five forms
};

/// Of a panel that bends by its layers; nothing of one that does not.
struct Bending {
    const Curvatures* curved = nullptr;
    const OwnStrains* own = nullptr;
    Mat17* tangent = nullptr;  ///< null: not asked for
};

/// What its layers keep, point by point; a panel that bends by its layers, then its own strains: history_size numbers.
int history_size(const Sheet& sheet, const Shape& shape);

/// `gone`: layers that carry nothing; what they keep stays as it is.
PanelResponse respond(const Sheet& sheet, const Shape& shape, const Placed& at, std::uint8_t gone, bool with_tangent,
                      const Bending& bending, const double* before, double* after);

/// Adds what a stiffness D of the section at a point, N/m, is to the panel.
void add_point(const Point& point, const Mat3& D, Mat5& sum);
/// Stiffness of a panel whose points have the same section, without strains of its own: an upper bound.
Mat17 stiffest(const Shape& shape, const SectionTangent& section);

}  // namespace hinge::panel

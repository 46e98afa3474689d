// Fracture criteria: strains of an element against limits (eq 16); rotations of hinges and elongations of members.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

#include "core/types.h"

namespace hinge::beam {

/// Strains that are compared with fracture limits.
struct FractureStrains {
    double curvature_x, curvature_y;  ///< 1/m
    double axial;                     ///< -
    double twist;                     ///< 1/m
    double shear_x = 0, shear_y = 0;  ///< -, of directions x and y
};

/// Strains of the whole element as in eq 16, the same at every section. d: deformation of the element (timoshenko.h),
/// elastic and plastic; L: its length, m. Without shear.
inline FractureStrains fracture_strains(const Vec6& d, double L) {
    return {(d[1] - d[0]) / L, (d[3] - d[2]) / L, d[4] / L, d[5] / L};
}

/// Rotation of the hinge at end 1 or 2 about x (plane 0) or y (plane 1), rad; positive like the curvature. plastic: the
/// plastic part of d.
inline double hinge_rotation(const Vec6& plastic, int end, int plane) {
    return end == 1 ? -plastic[2 * plane] : plastic[2 * plane + 1];
}

/// Strains of the section at end 1 or 2. Its curvatures are the elastic ones plus the rotation of its own hinge over
/// the element's length, without the hinge at the other end. The other strains are the element's.
inline FractureStrains section_strains(const Vec6& elastic, const Vec6& plastic, double L, int end) {
    FractureStrains e = fracture_strains(elastic + plastic, L);
    e.curvature_x = (elastic[1] - elastic[0] + hinge_rotation(plastic, end, 0)) / L;
    e.curvature_y = (elastic[3] - elastic[2] + hinge_rotation(plastic, end, 1)) / L;
    return e;
}

/// Adds the shear strains from the forces p of an element (timoshenko.h): Q / (G A), with Q_y = dM_x/dz and Q_x =
/// dM_y/dz as means over the element. They are elastic, since shear is not part of the yield surface (eq 14).
inline void add_shear(FractureStrains& e, const Vec6& p, double GAx, double GAy, double L) {
    e.shear_y = (p[0] + p[1]) / (L * GAy);
    e.shear_x = (p[2] + p[3]) / (L * GAx);
}

/// Fracture limits. An infinite limit is not tested. A hinge has no length of its own, so where hinges form the limits
/// of strain follow the length of the elements. The last three do not; they are not in the paper.
struct FractureLimits {
    double curvature_x = std::numeric_limits<double>::infinity();   ///< 1/m, either sign
    double curvature_y = std::numeric_limits<double>::infinity();   ///< 1/m, either sign
    double axial_strain = std::numeric_limits<double>::infinity();  ///< -, either sign unless tension_only
    double shear_strain = std::numeric_limits<double>::infinity();  ///< -, either direction, either sign
    bool tension_only = false;
    double hinge_rotation_x = std::numeric_limits<double>::infinity();  ///< rad, plastic, either sign
    double hinge_rotation_y = std::numeric_limits<double>::infinity();  ///< rad, plastic, either sign
    double elongation = std::numeric_limits<double>::infinity();        ///< m, plastic, of a member; in tension

    bool no_strains() const {
        return std::isinf(curvature_x) && std::isinf(curvature_y) && std::isinf(axial_strain) &&
               std::isinf(shear_strain);
    }
    bool no_hinges() const {
        return std::isinf(hinge_rotation_x) && std::isinf(hinge_rotation_y) && std::isinf(elongation);
    }
    bool none() const { return no_strains() && no_hinges(); }
};

/// Eq 16: true if one of the ratios kappa_x/kappa_fx, kappa_y/kappa_fy, eps_z/eps_fz has reached 1, or (not in the
/// paper) a shear strain has reached its limit.
inline bool reached(const FractureStrains& e, const FractureLimits& limit) {
    return std::abs(e.curvature_x) >= limit.curvature_x || std::abs(e.curvature_y) >= limit.curvature_y ||
           (limit.tension_only ? e.axial : std::abs(e.axial)) >= limit.axial_strain ||
           std::max(std::abs(e.shear_x), std::abs(e.shear_y)) >= limit.shear_strain;
}

/// The limit that was reached; rule: the script's own rule decided.
enum class Limit : std::uint8_t {
    rule,
    curvature_x,
    curvature_y,
    axial_strain,
    shear_strain,
    hinge_rotation_x,
    hinge_rotation_y,
    elongation
};
inline constexpr const char* limit_names[] = {"rule",         "curvature_x",      "curvature_y",      "axial_strain",
                                              "shear_strain", "hinge_rotation_x", "hinge_rotation_y", "elongation"};

/// The strain with the largest ratio to its limit.
struct LimitReached {
    Limit which = Limit::rule;
    double strain = 0, limit = 0;  ///< 1/m of a curvature, rad of a rotation, m of an elongation, else -
};
inline LimitReached most_beyond(const FractureStrains& e, const FractureLimits& limit) {
    const double shear = std::abs(e.shear_x) > std::abs(e.shear_y) ? e.shear_x : e.shear_y;
    const LimitReached terms[] = {{Limit::curvature_x, e.curvature_x, limit.curvature_x},
                                  {Limit::curvature_y, e.curvature_y, limit.curvature_y},
                                  {Limit::axial_strain, e.axial, limit.axial_strain},
                                  {Limit::shear_strain, shear, limit.shear_strain}};
    const auto share = [&](const LimitReached& t) {
        const bool signed_strain = t.which == Limit::axial_strain && limit.tension_only;
        return (signed_strain ? t.strain : std::abs(t.strain)) / t.limit;
    };
    return *std::max_element(std::begin(terms), std::end(terms),
                             [&](const auto& a, const auto& b) { return share(a) < share(b); });
}

/// The limit that the rotation of a hinge about x and y (rad) has reached, the one with the larger ratio; `rule`:
/// neither.
inline LimitReached rotation_reached(const double (&rotation)[2], const FractureLimits& limit) {
    const double x = std::abs(rotation[0]) / limit.hinge_rotation_x, y = std::abs(rotation[1]) / limit.hinge_rotation_y;
    if (!(x >= 1 || y >= 1)) return {};
    if (y > x) return {Limit::hinge_rotation_y, rotation[1], limit.hinge_rotation_y};
    return {Limit::hinge_rotation_x, rotation[0], limit.hinge_rotation_x};
}

}  // namespace hinge::beam

// What a panel is made of: layers that share its strain. Each has a law of its own in plane stress.
//
// Strains are [e11, e22, 2 e12] in the axes of the sheet, stresses [s11, s22, s12]; both per width of the panel, N/m.
// The panel gives Green's strain E = (F^T F - I)/2 and takes the second Piola-Kirchhoff stress, its partner in work.
// Solid layers and concrete have their laws between the stretch U - I, U^2 = I + 2 E, and its partner; bars between
// their own stretch and their force. In small displacement all of these are the linear strain.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/types.h"
#include "panel/bend.h"
#include "panel/stretch.h"

namespace hinge::panel {

enum class LayerKind : std::uint8_t {
    solid,     ///< steel: elastic, yields by von Mises' criterion
    concrete,  ///< carries compression alone, in the directions of principal strain
    bars       ///< reinforcement, or the ribs of a deck: carries along one direction
};

/// Part of a layer that lies at a height above the panel's middle plane.
struct Level {
    double z = 0;     ///< m
    double part = 1;  ///< of the layer
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.z, s.part);
    }
};

/// A layer over the whole panel. Its hardening is isotropic and linear.
struct Layer {
    LayerKind kind = LayerKind::solid;
    double thickness = 0;                                       ///< m; of bars their area per width, m^2/m
    double E = 0;                                               ///< Pa
    double poisson = 0;                                         ///< of solid layers
    double strength = std::numeric_limits<double>::infinity();  ///< Pa: yield stress, of concrete its compressive one
    double hardening = 0;                                       ///< Pa, of stress over plastic strain
    double ultimate = std::numeric_limits<double>::infinity();  ///< strain that tears it: of bars their stretch, of
                                                                ///< solid layers the equivalent plastic strain
    Vec3 direction = {1, 0, 0};        ///< of bars at an angle a to the sheet's x axis: [cos^2 a, sin^2 a, sin a cos a]
    std::vector<Level> levels = {{}};  ///< one, or several through its thickness where the panel bends by its layers

    /// Elastic stiffness, N/m; that of concrete under compression.
    Mat3 elastic() const;
    int history_size() const;
    bool is_elastic() const {
        return kind != LayerKind::concrete && !std::isfinite(strength) && !std::isfinite(ultimate);
    }

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.kind, s.thickness, s.E, s.poisson, s.strength, s.hardening, s.ultimate, s.direction, s.levels);
    }
};

/// Stiffness of the section at a point, N/m, N and N m: membrane forces by strain, moments by curvature, and each by
/// the other.
struct SectionTangent {
    Mat3 membrane = Mat3::Zero(), coupling = Mat3::Zero(), bending = Mat3::Zero();
    void add(const Mat3& of_layer, double z) {
        membrane += of_layer, coupling -= z * of_layer, bending += z * z * of_layer;
    }
};

inline constexpr std::size_t most_layers = 8;  ///< of a sheet

struct Sheet {
    std::vector<Layer> layers;
    double mass = 0;  ///< kg/m^2
    BendingLaw bending = {};
    bool bends_by_layers = false;  ///< the strain of a layer is that of the middle plane and of its curvature
    SectionTangent elastic() const;
    Sheet linear() const;      ///< without yielding, cracks and tearing: concrete carries tension too
    double poisson() const;    ///< of the stiffest solid layer; 0 where there is none
    double thickness() const;  ///< m, of the thickest layer other than bars; 0 where there is none
    double stiffness() const;  ///< E t of the stiffest layer, N/m
    int history_size() const;
    bool is_elastic() const;
    bool has_bars_alone() const;
    bool has_solid() const;

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.layers, s.mass, s.bending, s.bends_by_layers);
    }
};

/// What a layer answers to a strain.
struct Response {
    Vec3 stress = Vec3::Zero();   ///< N/m
    Mat3 tangent = Mat3::Zero();  ///< N/m; of d(stress)/d(strain)
    double stored = 0;            ///< J/m^2
    double dissipated = 0;        ///< J/m^2, since `before`
    double used = 0;              ///< part of what tears it
};

/// Kinematics of a strain that layers share.
struct Strained {
    /// `large`: from Green's strain; else `strain` is linear. Without `stretches`: for bars alone.
    Strained(const Vec3& strain, bool large, bool stretches = true);
    Vec3 green;
    bool large;
    HalfOf half;   ///< of U, where it is large
    Vec3 stretch;  ///< U - I
};

/// The response of a layer, and what it keeps: history_size numbers before the step and after it.
Response respond(const Layer& layer, const Strained& at, const double* before, double* after, bool with_tangent);

}  // namespace hinge::panel

// The laws of sections and of materials that there are.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>
#include <optional>

#include "section/plastic_domain.h"
#include "section/potential_law.h"

namespace hinge::beam {

/// Eq 14. `strength`: fully plastic resultants of the section.
std::unique_ptr<const SectionLaw> paper_law(const YieldSurface& strength, SectionMaterial material = {});

/// What of a section carries shear forces, and is weakened by them.
struct ShearCarried {
    bool whole = false;                    ///< all of it: solid sections and pipes
    PlasticDomain::Walls::Polygons walls;  ///< else: its walls along x and along y
};
/// The exact interaction of N, Mx and My. `strength`: Mx0, My0 (N m), N0 (N), Mz0 (N m); Mz0 may be infinite. `shear`:
/// with what shear forces take off (EN 1993-1-1 6.2.8); null: without.
std::unique_ptr<const SectionLaw> exact_law(std::shared_ptr<const PlasticDomain> domain, const Vec4& strength,
                                            SectionMaterial material = {}, const ShearCarried* shear = nullptr);

/// A section that carries axial force of one sign (section/laws/one_way.cpp). `sign`: 1 tension only, -1 compression
/// only; `N0`: axial force at which it yields, N, infinite for none. Its bending and torsion are elastic.
std::unique_ptr<const SectionLaw> one_way_law(int sign, double N0);

/// Stress beyond yield (section/laws/hardening.cpp). Pa.
struct Hardening {
    double kinematic = 0;   ///< plastic modulus by which the yield surface moves
    double saturation = 0;  ///< back stress that it comes to (Armstrong and Frederick); 0: it moves on
    double isotropic = 0;   ///< plastic modulus by which it grows
};
/// Plastic modulus of a material whose stress grows beyond yield with the slope `tangent` over the whole strain, Pa.
inline double plastic_modulus_of(double tangent, double E) { return tangent / (1 - tangent / E); }
/// Raises InputError unless all are finite and not negative.
std::shared_ptr<const MaterialLaw> hardening_law(const Hardening& hardening, double yield_stress);

/// Strength of a hinge at the end of a member over its plastic rotation (section/laws/backbone.cpp).
struct Backbone {
    struct Point {
        double rotation, strength;  ///< largest plastic rotation so far, rad; factor on the fully plastic resultants
    };
    std::vector<Point> points;     ///< the first one at 0 rad; straight between two, constant beyond the last
    double wear = 0;               ///< plastic work over My that takes all strength, rad; 0: cycles do not wear it
    std::string interaction = "";  ///< of the sections that it is made for: "paper", "exact", "" for any
    double residual = 0;           ///< factor on the fully plastic resultants below which wear takes nothing
    bool wears_stiffness = false;  ///< wear takes stiffness in unloading, too
};
/// Raises InputError unless the rotations begin at 0 and rise, and all strengths are 0.01 or more.
std::shared_ptr<const MaterialLaw> backbone_law(const Backbone& backbone);
/// Plastic flow of a section in a step, and what it makes of the section (section/laws/own_law.cpp).
struct SectionFlow {
    double x = 0, y = 0, N = 0, z = 0;  ///< rotations about x and y (rad), elongation (m), twist (rad)
    double strain = 0;                  ///< growth of the mean plastic strain of the part that yields, >= 0
    bool at_end = true;                 ///< at an end of the member; false: within it
};
struct SectionAnswer {
    double strength = 1;               ///< factor on all fully plastic resultants, above 0
    Vec4 back = Vec4::Zero();          ///< Mx, My (N m), N (N), Mz (N m): the middle of the yield surface
    std::vector<double> history = {};  ///< at the end of the step; empty: as at its start
};
/// `history`: at the start of the step. It may be asked any number of times in a step, and must answer alike.
using SectionRule =
    std::function<std::vector<SectionAnswer>(std::span<const SectionFlow> flows, const double* history)>;
/// It is called by one thread, in every round of the return of an element that flows. `variables`: number of history
/// variables of the function, 0 at first.
std::shared_ptr<const MaterialLaw> own_law(SectionRule rule, int variables);
/// That of such a law; null of another.
const Backbone* backbone_of(const MaterialLaw& law);

/// Factor on the yield stress at a plastic strain rate (section/laws/strain_rate.cpp): Cowper and Symonds, 1 + (rate /
/// D)^(1/q), or Johnson and Cook, 1 + C ln(rate / reference) well beyond the reference rate. Rates in 1/s.
struct StrainRate {
    double D = 0, q = 0;          ///< of Cowper and Symonds; 0: not they
    double C = 0, reference = 0;  ///< of Johnson and Cook
};
/// Raises InputError unless the numbers of one of the two are above 0.
std::shared_ptr<const MaterialLaw> strain_rate_law(const StrainRate& rate);

/// Hot steel at a temperature (section/laws/hot_curve.cpp): parts of the declared yield stress and E.
struct HotCurvePoint {
    double temperature;                     ///< degrees Celsius
    double yield, proportional, stiffness;  ///< k_y, k_p, k_E of EN 1993-1-2, table 3.1
};
/// Straight between two points. E and yield_stress in Pa. Raises InputError unless the temperatures rise and an ellipse
/// leads from each proportional limit to the yield stress at a strain of 2 %.
std::shared_ptr<const MaterialLaw> hot_curve_law(std::vector<HotCurvePoint> points, double E, double yield_stress);

}  // namespace hinge::beam

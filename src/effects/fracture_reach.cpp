#include "effects/fracture_reach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "state/hinges.h"

namespace hinge {
namespace {

double resultant(double w) { return w > 0 ? 1 / std::sqrt(w) : std::numeric_limits<double>::infinity(); }

/// Part of EI that stays: no section bends by four times its yield curvature without flowing.
constexpr double least_bending = 0.25;

/// Upper bounds of an element's elastic strains: curvatures, 1/m, axial and shear strain.
struct ElasticBound {
    double curvature[2], axial, shear;
};

/// Whether limits alone could be reached by elastic strain within `bound` on top of the plastic one.
bool within_reach(const FractureRule& rule, double length, const Vec6& plastic, const ElasticBound& bound) {
    const auto out_of_reach = [&](const beam::FractureStrains& stays) {
        return rule.curvature_x > std::abs(stays.curvature_x) + bound.curvature[0] &&
               rule.curvature_y > std::abs(stays.curvature_y) + bound.curvature[1] &&
               rule.axial_strain > std::abs(stays.axial) + bound.axial && rule.shear_strain > bound.shear;
    };
    if (rule.strain_measure == FractureRule::StrainMeasure::element)
        return !out_of_reach(beam::fracture_strains(plastic, length));
    return !(out_of_reach(beam::section_strains(Vec6::Zero(), plastic, length, 1)) &&
             out_of_reach(beam::section_strains(Vec6::Zero(), plastic, length, 2)));
}

/// The elastic shear force is at most that between two fully plastic moments.
double most_shear(const Element& e) {
    return 2 * (1 + 1e-6) / e.length *
           std::max(resultant(e.yield.x) / e.rigidity.GAy, resultant(e.yield.y) / e.rigidity.GAx);
}

}  // namespace

bool ever_within_reach(const FractureRule& rule, const Element& e, const Vec6& plastic, bool p_delta) {
    if (rule.no_strains() && !rule.hook) return false;
    if (e.yield.elastic()) return !rule.plastic_only;
    if (rule.plastic_only) return false;
    const auto elastic = [](double w, double rigidity) { return (1 + 1e-6) * resultant(w) / rigidity; };
    ElasticBound bound = {{elastic(e.yield.x, e.rigidity.EIx), elastic(e.yield.y, e.rigidity.EIy)},
                          elastic(e.yield.n, e.rigidity.EA),
                          most_shear(e)};
    if (p_delta) {
        const beam::PairKind<double> pair = pair_kind_of(e);
        for (int plane : {0, 1}) {
            const beam::StabilityFunctions<double> of = beam::stability_functions(pair, plane, -resultant(e.yield.n));
            bound.curvature[plane] /= std::max(least_bending, std::min(of.S, of.A));
            bound.axial += 0.5 * std::abs(of.S1) * std::pow(bound.curvature[plane] * e.length, 2);
        }
    }
    return within_reach(rule, e.length, plastic, bound);
}

bool now_within_reach(const FractureRule& rule, const Element& e, const Vec6& plastic, const Vec6& force,
                      const Vec6& of_partner) {
    constexpr double near = 2, fall = 0.21, slope = 0.28;  // |dS/dp| up to p = 2
    const auto larger = [](double a, double b) { return std::max(std::abs(a), std::abs(b)); };
    const double P = std::max(0.0, -std::min(force[4], of_partner[4]));
    const double shear = std::isfinite(rule.shear_strain) ? most_shear(e) : 0;
    ElasticBound bound = {{0, 0}, larger(force[4], of_partner[4]) / e.rigidity.EA, shear};
    for (int plane : {0, 1}) {
        const double EI = plane == 0 ? e.rigidity.EIx : e.rigidity.EIy,
                     GA = plane == 0 ? e.rigidity.GAy : e.rigidity.GAx, softer = 1 / (1 - std::min(P / GA, 0.9)),
                     p = softer * P * e.length * e.length / EI;
        if (!(p <= near)) return true;
        const double moment = std::max(larger(force[2 * plane], force[2 * plane + 1]),
                                       larger(of_partner[2 * plane], of_partner[2 * plane + 1]));
        bound.curvature[plane] = (1 + 1e-6) * moment / EI / (1 - fall * p);
        bound.axial += 0.5 * slope * std::pow(softer * bound.curvature[plane] * e.length, 2);
    }
    return within_reach(rule, e.length, plastic, bound);
}

}  // namespace hinge

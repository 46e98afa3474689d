#include "effects/shear_strength.h"

#include <algorithm>
#include <cmath>

#include "section/section_outline.h"

namespace hinge {
namespace {

constexpr double most_lost = 0.98;  ///< of the strength of what carries the shear force, so that a section keeps some
constexpr double least_v0 = 1e-3;   ///< what torsion leaves of V0 at least
constexpr double most_shear = 1e3;  ///< of V0: more is not told apart

}  // namespace

ShearStrength::ShearStrength(const Structure& structure) {
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        const Element& e = structure.elements()[i];
        const MemberData& member = structure.model().members()[e.member];
        const Section& s = *member.section;
        Scales scales;
        scales.section = &s;
        const bool steel = !(s.outline && s.outline->concrete());
        if (steel && e.law && !e.yield.elastic() && std::isfinite(member.material->yield_stress)) {
            const ShearProperties shear = shear_properties(s);
            const double tau = member.material->yield_stress / std::sqrt(3.0);
            const double M[2] = {e.yield.x, e.yield.y};
            scales.wave = e.length * std::sqrt(member.material->density / member.material->G);
            scales.torsion = std::sqrt(e.yield.z);
            for (int axis : {0, 1}) {
                const double V0 = tau * shear.area[1 - axis];
                if (V0 > 0 && std::isfinite(V0) && M[axis] > 0)
                    scales.v[axis] = 1 / (V0 * e.length), scales.m[axis] = std::sqrt(M[axis]),
                    scales.share[axis] = shear.share[1 - axis];
            }
        }
        scales_.push_back(scales);
        if (e.law && e.law->takes_shear()) weakened_.push_back(int(i));
    }
}

/// The mean shear force of the element: what its bending moment changes by, over its length.
ShearStrength::Shear ShearStrength::shear_of(const Workspace& w, int index, int axis) const {
    const Scales& of = scales_[index];
    const Vec6& p = w.state.force[index];
    const double* f = w.assembly.fixed_end(index).moment + 2 * axis;
    const double a = p[2 * axis] + f[0], b = p[2 * axis + 1] + f[1], strength = heat_of(w.state.heat, index).strength;
    return {of.v[axis] / strength * std::abs(a + b), of.m[axis] / strength * std::max(std::abs(a), std::abs(b))};
}

/// Mz / Mz0, and what it leaves of V0.
double ShearStrength::torsion_of(const Workspace& w, int index) const {
    const double strength = heat_of(w.state.heat, index).strength;
    return std::abs(w.state.force[index][5]) * scales_[index].torsion / strength;
}
double ShearStrength::v0_left(int index, double torsion) const {
    return torsion > 0 ? std::max(least_v0, shear_left_by_torsion(*scales_[index].section, torsion)) : 1;
}

namespace {

/// rho of a section that flows. Its shear force follows its moment, 1 - rho share of M0: the rho at which both agree.
/// `v`: V / V0 beside `rho`.
double settled(double v, double share, double rho) {
    const auto v_at = [&](double other) { return v * (1 - other * share) / (1 - rho * share); };
    double low = 0, high = most_lost;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (lost_by_shear(v_at(middle)) > middle ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

void ShearStrength::weaken(const Workspace& w, const Step& step, State& state) const {
    auto flows = w.yielding.begin();
    for (const int index : weakened_) {
        const beam::SectionLaw& law = *w.structure.elements()[index].law;
        while (flows != w.yielding.end() && flows->element < index) ++flows;
        const bool flowing = flows != w.yielding.end() && flows->element == index;
        const int sections = w.structure.conventional() ? 1 : 2;
        const double follows = w.goes_by_load_factor() ? 1 : -std::expm1(-step.dt / scales_[index].wave);
        double* history = &state.history[w.structure.history_at(index)];
        const double left = v0_left(index, torsion_of(w, index));
        for (int s = 0; s < sections; ++s, history += law.history_size()) {
            double rho[2];
            for (int axis : {0, 1}) {
                const double v = std::min(most_shear, shear_of(w, index, axis).v / left),
                             share = scales_[index].share[axis], before = law.lost_by_shear(axis == 0, history);
                if (share < 0 || !(v > 0)) rho[axis] = 0;
                else if (flowing && flows->flow.lambda[s] > 0) rho[axis] = settled(v, share, before);
                else rho[axis] = std::min(most_lost, lost_by_shear(v));
            }
            for (int axis : {0, 1}) {
                const double before = law.lost_by_shear(axis == 0, history);
                rho[axis] = before + follows * (rho[axis] - before);
            }
            law.set_shear(rho[1], rho[0], history);
        }
    }
}

}  // namespace hinge

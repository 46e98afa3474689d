#include "effects/shear_strength.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "section/section_outline.h"
#include "effects/axial_strength.h"
#include "model/member_text.h"

namespace hinge {
namespace {

constexpr double most_lost = 0.98;   ///< of the strength of what carries the shear force, so that a section keeps some
constexpr double least_v0 = 1e-3;    ///< what torsion leaves of V0 at least
constexpr double most_shear = 1e3;   ///< of V0: more is not told apart
constexpr long every = 10;           ///< steps of dynamics between looks at sections that do not flow
constexpr double small_shear = 0.5;  ///< of V0: up to that it takes nothing from the moment, EN 1993-1-1 6.2.8(2)

}  // namespace

double moment_left_by_shear(double v, double share) { return 1 - lost_by_shear(v) * share; }

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

void ShearStrength::look(const Workspace& w, const Step& step) {
    if (!w.is_due_every(every))
        for (const PlasticIncrement& y : w.yielding) look_at(w, step, y.element);
    else
        for (int i = 0; i < int(scales_.size()); ++i) look_at(w, step, i);
}

/// The mean shear force of the element: what its bending moment changes by, over its length.
ShearStrength::Shear ShearStrength::shear_of(const Workspace& w, int index, int axis) const {
    const Scales& of = scales_[index];
    const Vec6& p = w.state.force[index];
    const double* f = w.assembly.fixed_end(index).moment + 2 * axis;
    const double a = p[2 * axis] + f[0], b = p[2 * axis + 1] + f[1], strength = heat_of(w.state.heat, index).strength;
    return {of.v[axis] / strength * std::abs(a + b), of.m[axis] / strength * std::max(std::abs(a), std::abs(b))};
}

void ShearStrength::look_at(const Workspace& w, const Step& step, int index) {
    const double t = torsion_of(w, index), left = v0_left(index, t);
    for (int axis : {0, 1})
        if (const Shear at = shear_of(w, index, axis); at.v > small_shear * left)
            compare(w, step, index, axis, at.v / left, at.m, t);
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

void ShearStrength::compare(const Workspace& w, const Step& step, int index, int axis, double v, double m,
                            double torsion) {
    if (w.state.broken[index]) return;
    const bool taken = w.structure.elements()[index].law->takes_shear();  // then the moment cannot be too large
    const double share = scales_[index].share[axis], left = taken || share < 0 ? 1 : moment_left_by_shear(v, share);
    double excess = 0;
    const double within = std::min(m, 1.0);  // hardening, or an end beyond the hinge of an element, is not for shear
    if (is_unsafe(within, left)) excess = within - left;
    if (is_unsafe(v, 1)) excess = std::max(excess, v - 1);
    if (!(excess > 0)) return;
    const int member = w.structure.elements()[index].member;
    if (unsafe_.empty()) unsafe_.assign(w.structure.model().members().size(), 0);
    unsafe_[member] = 1;
    if (excess > worst_.excess + alike_moment) worst_ = {v, m, left, excess, w.reached(step), torsion, index, axis};
}

void ShearStrength::check_run(const Workspace& w, std::vector<RunWarning>& list) const {
    if (worst_.element < 0) return;
    const Model& model = w.structure.model();
    const int member = w.structure.elements()[worst_.element].member;
    const long others = std::count(unsafe_.begin(), unsafe_.end(), 1) - 1;
    const std::string along = worst_.axis == 0 ? "y" : "x", about = worst_.axis == 0 ? "x" : "y";
    std::string text = member_text(model, member) + ", section " + model.members()[member].section->kind +
                       ", carries V / V0 = " + number_text(worst_.v, 2) + " along " + along + " and " +
                       number_text(worst_.m, 2) + " of M" + about + "0 " +
                       (w.goes_by_load_factor() ? "at load factor " + number_text(worst_.at, 4)
                                                : "at t = " + number_text(worst_.at, 4) + " s");
    if (worst_.torsion > 0.01) text += ", with what Mz / Mz0 = " + number_text(worst_.torsion, 2) + " takes from V0";
    text += is_unsafe(std::min(worst_.m, 1.0), worst_.left)
                ? ": EN 1993-1-1 6.2.8 leaves " + number_text(worst_.left, 2) + " of M" + about +
                      "0 beside that shear force"
                : ": more than its plastic shear strength";
    if (others > 0) text += ", and so do " + count_text(others, "more member") + " beyond what they can carry";
    const Element& e = w.structure.elements()[worst_.element];
    const char* advice = e.law->takes_shear()
                             ? "sections keep their strength in shear beyond that: this run finds too high a strength; "
                               "give such members a section that carries it, or a fracture rule on their shear"
                         : shear_carried(*model.members()[member].section)
                             ? "its law of sections takes no strength for shear forces: this run finds too high a "
                               "strength; give hinge.model, or the section, interaction = \"exact with shear\""
                             : "its law of sections takes no strength for shear forces: this run finds too high a "
                               "strength; give such members a section with a smaller strength, or a fracture rule on "
                               "their shear";
    list.push_back({text, advice, member});
}

bool ShearStrength::fits(const Structure& structure) const {
    const int n = int(structure.elements().size());
    return worst_.element >= -1 && worst_.element < n && (worst_.axis == 0 || worst_.axis == 1) &&
           (unsafe_.empty() || unsafe_.size() == structure.model().members().size());
}

}  // namespace hinge

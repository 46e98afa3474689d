// An end of an element that can flow: what a search for the plastic flow of sections moves.
#pragma once

#include <cmath>

#include "section/flow_problem.h"
#include "section/section_law.h"

namespace hinge::beam {

inline constexpr double flow_tolerance = 2e-13;  ///< of the trial forces: what a section's equilibrium may be off

using SectionRows = Eigen::Matrix<double, 4, 6>;

/// What a section has flowed in the step.
struct FlowSoFar {
    double strain = 0;  ///< growth of its mean plastic strain
    Vec4 e = Vec4::Zero();
};

/// A section that can flow, and how far it has.
struct FlowingEnd {
    double n1, n2;                ///< of the section's moments, from those at the element's ends
    Vec4 per;                     ///< 1 over the strength
    Vec4 by_loads;                ///< normalised fixed-end part
    Vec4 fixed;                   ///< that, less the back resultants at the start
    Vec4 k;                       ///< stiffness against its own flow
    Vec4 hardens = Vec4::Zero();  ///< what e adds to the back resultants
    MaterialLaw::Turned turned;   ///< factor that follows the rotation, at the end of the round before
    const double *history = nullptr, *own = nullptr;  ///< own: the variables of the law itself
    MaterialLaw::Moment moment{0, room_temperature};
    Vec4 e = Vec4::Zero();
    mutable Vec4 known_at = Vec4::Zero();  ///< the e, not zero, of which the search knows D(e) and its derivatives
    mutable WorkOfFlow known;              ///< those
    mutable int evaluations = 0;           ///< of D(e) so far

    FlowingEnd() = default;
    FlowingEnd(double r, const Vec4& per_strength, const Stiffness& of)
        : n1(-(1 - r) / 2), n2((1 + r) / 2), per(per_strength), by_loads(Vec4::Zero()), fixed(Vec4::Zero()) {
        k << n1 * n1 * of.x11 + 2 * n1 * n2 * of.x12 + n2 * n2 * of.x22,
            n1 * n1 * of.y11 + 2 * n1 * n2 * of.y12 + n2 * n2 * of.y22, of.axial, of.twist;
        k = k.cwiseProduct(per.cwiseProduct(per));
        for (int c = 0; c < 4; ++c)
            if (per[c] == 0) k[c] = 1;
    }
    /// `so_far`: of the round before.
    FlowingEnd(double r, const Stiffness& of, const SectionConditions& at, int section, const FlowProblem& problem,
               const FlowSoFar& so_far)
        : FlowingEnd(r, problem.per_strength, of) {
        by_loads = per.cwiseProduct(resultants(at.fixed_end->at(r), r));
        set_history(at, section, problem, so_far);
    }
    /// What the material adds after a flow of `so_far`.
    void set_history(const SectionConditions& at, int section, const FlowProblem& problem, const FlowSoFar& so_far) {
        moment = {at.dt, at.temperature};
        history = at.history_of(section, problem.history_size), own = problem.own(history);
        turned = problem.turned(history, so_far.e, so_far.strain * problem.material.zone.energy);
        Vec4 back = Vec4::Zero();
        hardens.setZero();
        problem.add_back(history, so_far.strain, so_far.e, back, hardens);
        fixed = by_loads - back;
    }
    bool flows() const { return !e.isZero(0); }
    void knows(const Vec4& at, const WorkOfFlow& work) const { known_at = at, known = work; }
    /// Normalised resultants, with the fixed-end part and less the back resultants at the start, of the element forces.
    Vec4 carries(const Vec6& p) const {
        return per.cwiseProduct(Vec4(n1 * p[0] + n2 * p[1], n1 * p[2] + n2 * p[3], p[4], p[5])) + fixed;
    }
    Vec6 plastic() const {
        const Vec4 s = per.cwiseProduct(e);
        return (Vec6() << n1 * s[0], n2 * s[0], n1 * s[1], n2 * s[1], s[2], s[3]).finished();
    }
    SectionRows rows() const {
        SectionRows B = SectionRows::Zero();
        B(0, 0) = n1 * per[0], B(0, 1) = n2 * per[0], B(1, 2) = n1 * per[1], B(1, 3) = n2 * per[1];
        B(2, 4) = per[2], B(3, 5) = per[3];
        return B;
    }
};

/// Phi(D) + e.C e / 2 in the place of D.
void harden(const FlowProblem& problem, const FlowingEnd& end, const Vec4& e, WorkOfFlow& w);
/// q and the curvature alone, and that with the slope of the factor that follows the rotation.
void harden_and_turn(const FlowProblem& problem, const FlowingEnd& end, const Vec4& e, WorkOfFlow& w);

/// What an end of work D at e resists at t e along its ray, times e, and the slope of that over t.
MaterialLaw::Factor resistance_on_ray(const FlowProblem& problem, const FlowingEnd& end, double D, double t);
/// The t above 0 at which force - t stiffness is resistance(t), a MaterialLaw::Factor, from `t` on; 0: there is none.
/// `off_by`: what of the force may be left.
template <class Resistance>
double find_on_ray(double force, double stiffness, double t, double off_by, Resistance resistance) {
    constexpr int most_steps = 100;
    if (!(force - resistance(0).value > 0)) return 0;
    double low = 0, high = force / stiffness;  // what is left is above 0 at low, and not above at high
    t = t > 0 && t < high ? t : 0.5 * high;
    for (int i = 0; i < most_steps && high - low > 1e-15 * high; ++i) {
        const MaterialLaw::Factor f = resistance(t);
        const double off = force - t * stiffness - f.value;
        (off > 0 ? low : high) = t;
        const double next = t - off / (-stiffness - f.slope);
        if (std::abs(off) <= off_by * force) break;
        t = next > low && next < high ? next : 0.5 * (low + high);
    }
    return t;
}

/// What section `section` has flowed in the step, where its material needs that.
FlowSoFar flow_so_far(const FlowProblem& problem, const ElementFlow& flow, int section, const double* history);

/// Growth of the mean plastic strain of a section in the step.
double mean_strain(const FlowProblem& problem, const ElementFlow& flow, int section, const double* history);

/// Adds what an end has flowed to the flow of its element.
FlowSoFar add_flow(const FlowProblem& problem, const FlowingEnd& end, int section, ElementFlow& out);

/// Whether q, less the back resultants, is outside of the yield surface at the start of the step
/// (PlasticWork::outside).
bool is_beyond(const FlowProblem& problem, const FlowingEnd& end, const Vec4& q, Vec4& direction);

}  // namespace hinge::beam

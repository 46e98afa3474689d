// Elastic part of the rate of an element's deformation, of which damping in proportion to its stiffness makes forces.
//
// An element that does not flow has the rates d' = B v of its nodes. Of one that flows in a step of length dt, with the
// deformation D and the plastic deformation P of the step, the mean elastic rate is (D - P) / dt. The rate where the
// step ends differs from the mean by o = d' - D / dt, half a step of acceleration. Its elastic part is what is left of
// o without the direction of flow:
//
//   e' = (D - P) / dt + o - theta (P . k o) / (P . k P) P,    theta = (P . k P) / (P . k D), between 0 and 1
//
// Where all deformation is flow, e' is zero whatever the acceleration is, and where flow begins or ends e' is
// continuous. So it is of second order in dt, as d' is.
#pragma once

#include <algorithm>
#include <vector>

#include "state/hinges.h"

namespace hinge {

/// Of an element that flows: k e' = steady + (k - q q^T) d'.
struct ElasticRate {
    int element;
    bool unknown = false;        ///< it flowed when the run began; e' is taken as zero
    Vec6 steady = Vec6::Zero();  ///< N m/s and N/s, in the places of p
    Vec6 q = Vec6::Zero();
    Vec6 mean = Vec6::Zero();  ///< q of long steps; mean mean^T D / dt is in `steady`

    Vec6 forces(const beam::Stiffness& k, const Vec6& rate) const {
        if (unknown) return Vec6::Zero();
        return steady + k.times(rate) - q * q.dot(rate);
    }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.element, s.unknown, s.steady, s.q);
    }
};

/// That of an element in a rising list, or null.
inline const ElasticRate* find_rate(const std::vector<ElasticRate>& rates, int element) {
    const auto at = std::lower_bound(rates.begin(), rates.end(), element,
                                     [](const ElasticRate& r, int e) { return r.element < e; });
    return at != rates.end() && at->element == element ? &*at : nullptr;
}

/// True for flow that is only known to go on: that of the step before, where nothing has moved yet (flowing_on).
inline bool only_begins(const PlasticIncrement& y) {
    return y.flow.yields() && std::max(y.flow.lambda[0], y.flow.lambda[1]) <= 1e-300;
}

/// In steps shorter than beta / 50 a part of (d' - d'_before) / 2 along P stays in e', which grows to all of it: forces
/// that are many times those of the springs would vanish at once where flow begins, and be there again where it ends,
/// from step to step. It acts as an inertia of beta k dt / 2 across the hinge, and is of first order in dt.
constexpr double rests_on_mean = 50;

/// Of the flow `y` between the state and the pose. `beta`: of damping, s. `as`: takes `mean` from there, for an element
/// that may flow in this iteration and not in the next, whose share theta would turn to and fro with it.
inline ElasticRate elastic_rate(const Structure& structure, const State& state, const Configuration& pose,
                                const PlasticIncrement& y, double dt, double beta, const ElasticRate* as = nullptr) {
    ElasticRate of{y.element};
    const beam::Stiffness k = stiffness_now(structure, state, y.element);
    const Vec6& P = y.flow.plastic;
    const Vec6 kP = k.times(P);
    const double square = P.dot(kP);
    const bool moved = !only_begins(y);
    const Vec6 D =
        moved ? Vec6(element_deformation(structure, y.element, pose) - element_deformation(structure, y.element, state))
              : Vec6(Vec6::Zero());
    if (as) {
        of.mean = as->mean;
    } else if (square > 0) {
        const double both = kP.dot(D), theta = moved && both > square ? square / both : 1;
        of.mean = std::sqrt(theta / square) * kP;
    }
    if (!of.mean.isZero(0)) {
        const Element& e = structure.elements()[y.element];
        const Vec6 rate = deformation_rates(element_frame(structure, y.element, pose), state.velocity[e.node[0]],
                                            state.velocity[e.node[1]]);
        const double part = std::min(1.0, rests_on_mean * dt / beta);
        of.q = std::sqrt(0.5 * (1 + part)) * of.mean;
        of.steady -= 0.5 * (1 - part) * of.mean * of.mean.dot(rate);
    }
    // k (D - P) / dt - (k - mean mean^T) D / dt
    if (moved) of.steady += (of.mean * of.mean.dot(D) - kP) / dt;
    return of;
}

}  // namespace hinge

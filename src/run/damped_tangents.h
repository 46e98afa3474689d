// Derivative of the forces of damping by stiffness of elements that flow, for the effective stiffness.
//
// An element that flows and has no rate of its own in Workspace::elastic_rates is damped by its whole rate: c k d'.
// With e' of state/elastic_rate.h the forces are c k e'. Over a step d changes by beta dt^2, d' by gamma dt times what
// the acceleration changes by; P by k^-1 (k - D_p) times the change of d. In units of beta dt^2 that is
//
//   c / dt D_p + c (gamma / (beta dt) - 1 / dt) (k - q q^T) + c / dt (mean mean^T - q q^T)
#pragma once

#include "algebra/effective_stiffness.h"
#include "effects/workspace.h"
#include "state/elastic_rate.h"

namespace hinge {

class DampedTangents {
public:
    DampedTangents(const Workspace& w, const Scheme& scheme, std::vector<ElementDamping> damping)
        : w_(w), scheme_(scheme), damping_(std::move(damping)) {}

    /// Adds it to the tangents `given` of elements that flow, or whose partner does. The one of a partner that does not
    /// flow is elastic; their common block has half of both.
    void add(std::vector<ElementTangent>& given) const {
        for (std::size_t i = 0; i < given.size() && !damping_.empty(); ++i) {
            ElementTangent& g = given[i];
            const double c = damping_[g.element].of_stiffness;
            if (c == 0) continue;
            g.own = with_damping(g.own, g.element, c);
            const int flowing =
                (rate_of(g.element) ? 1 : 0) + (rate_of(w_.structure.elements()[g.element].partner) ? 1 : 0);
            g.partner *= 1 + 0.5 * flowing * c / w_.assembly.step();
            g.with_damping = true;
        }
    }
    /// Of one that flows by itself.
    Mat6 with_damping(const Mat6& tangent, const PlasticIncrement& y) const {
        const double c = damping_.empty() ? 0 : damping_[y.element].of_stiffness;
        return c == 0 ? tangent : with_damping(tangent, y.element, c);
    }

private:
    /// d(d') / d(d), 1/s.
    double rate() const { return scheme_.gamma / (scheme_.beta * w_.assembly.step()); }
    Mat6 k_of(int element) const { return stiffness_now(w_.structure, w_.state, element).matrix(); }
    Mat6 with_damping(const Mat6& tangent, int element, double c) const {
        const ElasticRate* flow = rate_of(element);
        if (!flow) return tangent + c * rate() * k_of(element);
        const double dt = w_.assembly.step();
        const Mat6 q = flow->q * flow->q.transpose(), mean = flow->mean * flow->mean.transpose();
        return (1 + c / dt) * tangent + c * (rate() - 1 / dt) * (k_of(element) - q) + c / dt * (mean - q);
    }
    const ElasticRate* rate_of(int element) const { return find_rate(w_.elastic_rates, element); }

    const Workspace& w_;
    const Scheme scheme_;
    const std::vector<ElementDamping> damping_;
};

}  // namespace hinge

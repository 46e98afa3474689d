// Derivative of the forces of damping by stiffness of elements that flow, for the effective stiffness.
//
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
    void add(std::vector<ElementTangent>& given, const std::vector<PlasticIncrement>& yielding) const {
        for (std::size_t i = 0; i < given.size() && !damping_.empty(); ++i) {
            ElementTangent& g = given[i];
            const double c = damping_[g.element].of_stiffness;
            if (c == 0) continue;
            const PlasticIncrement* y = find(yielding, g.element);
            g.own = y ? with_damping(g.own, *y, c) : Mat6(g.own + c * rate() * k_of(g.element));
            const bool partner_flows = y && find(yielding, w_.structure.elements()[g.element].partner);
            g.partner *= 1 + (partner_flows ? 1 : 0.5) * c / w_.assembly.step();
            g.with_damping = true;
        }
    }
    /// Of one that flows by itself.
    Mat6 with_damping(const Mat6& tangent, const PlasticIncrement& y) const {
        const double c = damping_.empty() ? 0 : damping_[y.element].of_stiffness;
        return c == 0 ? tangent : with_damping(tangent, y, c);
    }

private:
    /// d(d') / d(d), 1/s.
    double rate() const { return scheme_.gamma / (scheme_.beta * w_.assembly.step()); }
    Mat6 k_of(int element) const { return stiffness_now(w_.structure, w_.state, element).matrix(); }
    Mat6 with_damping(const Mat6& tangent, const PlasticIncrement& y, double c) const {
        const double dt = w_.assembly.step();
        const ElasticRate flow = elastic_rate(w_.structure, w_.state, w_.trial, y, dt, c);
        const Mat6 q = flow.q * flow.q.transpose(), mean = flow.mean * flow.mean.transpose();
        return (1 + c / dt) * tangent + c * (rate() - 1 / dt) * (k_of(y.element) - q) + c / dt * (mean - q);
    }
    static const PlasticIncrement* find(const std::vector<PlasticIncrement>& yielding, int element) {
        const auto at = std::lower_bound(yielding.begin(), yielding.end(), element,
                                         [](const PlasticIncrement& y, int e) { return y.element < e; });
        return at != yielding.end() && at->element == element ? &*at : nullptr;
    }

    const Workspace& w_;
    const Scheme scheme_;
    const std::vector<ElementDamping> damping_;
};

}  // namespace hinge

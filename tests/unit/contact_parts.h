// What the tests of contact are made of: bars that move, two that cross.
#pragma once

#include "contact/member_contacts.h"
#include "helpers.h"

namespace hinge::contact {

using namespace hinge::test;

/// A structure of bars for Contact: nodes, their motion, and a step that just moves them.
struct Scene {
    std::vector<Vec3> x;
    std::vector<Quat> q;
    std::vector<Vec6> v;
    std::vector<Bar> bars;

    int node(const Vec3& at, const Vec3& velocity = Vec3::Zero()) {
        x.push_back(at);
        q.push_back(Quat::Identity());
        Vec6 w = Vec6::Zero();
        w.head<3>() = velocity;
        v.push_back(w);
        return static_cast<int>(x.size()) - 1;
    }
    Bar& bar(int a, int b, double radius = 0.025, double stiffness = 5e8) {
        Bar bar;
        bar.element = static_cast<int>(bars.size());
        bar.node[0] = a;
        bar.node[1] = b;
        bar.radius = radius;
        bar.stiffness = stiffness;
        bars.push_back(bar);
        return bars.back();
    }
    /// A member of n elements.
    void member(const Vec3& from, const Vec3& to, int n, const Vec3& velocity = Vec3::Zero()) {
        int last = node(from, velocity);
        for (int i = 1; i <= n; ++i) {
            const int next = node(from + (to - from) * i / n, velocity);
            bar(last, next);
            last = next;
        }
    }
    Motion motion() const { return {x, q, v}; }
    void move(double dt) {
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += dt * v[i].head<3>();
            q[i] = (exponential(dt * v[i].tail<3>()) * q[i]).normalized();
        }
    }
    std::vector<Vec6> forces(Contact& contact) const {
        std::vector<Vec6> f(x.size(), Vec6::Zero());
        contact.add_internal_forces(x, q, f);
        return f;
    }
};

/// Two members of two elements, mid over mid at `angle`, `gap` apart, the upper one coming down.
inline Scene crossing(double speed, double gap, double angle = pi / 2, const Vec3& offset = Vec3::Zero()) {
    Scene s;
    s.member({-0.5, 0, 0}, {0.5, 0, 0}, 2);
    const Vec3 d(0.5 * std::cos(angle), 0.5 * std::sin(angle), 0), c = offset + Vec3(0, 0, gap);
    s.member(c - d, c + d, 2, {0, 0, -speed});
    return s;
}

}  // namespace hinge::contact

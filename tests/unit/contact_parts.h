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
        v.push_back((Vec6() << velocity, Vec3::Zero()).finished());
        return int(x.size()) - 1;
    }
    Bar& bar(int a, int b, double radius = 0.025, double stiffness = 5e8) {
        Bar& bar = bars.emplace_back();
        bar.element = int(bars.size()) - 1;
        bar.node[0] = a, bar.node[1] = b;
        bar.radius = radius, bar.stiffness = stiffness;
        return bar;
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
    /// How many pairs are bound; `changed`: the bars are not those of before.
    int detect(Contact& contact, double dt, double time, bool changed = false) const {
        return contact.detect(bars, changed, motion(), dt, time);
    }
    /// In so many steps, each followed by a move.
    int detect_and_move(Contact& contact, double dt, int steps, double time = 0) {
        int bound = 0;
        for (int i = 0; i < steps; ++i, move(dt)) bound += detect(contact, dt, time + i * dt);
        return bound;
    }
    /// The upper member of a crossing.
    void lift_to(double z) {
        for (int n = 3; n < 6; ++n) x[n].z() = z;
    }
    void lift(double by) {
        for (int n = 3; n < 6; ++n) x[n].z() += by;
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

// ---- two bars of four nodes

/// Places and rotations with degree of freedom c of node n moved by h.
inline void nudge(std::vector<Vec3>& x, std::vector<Quat>& q, int n, int c, double h) {
    if (c < 3) x[n][c] += h;
    else q[n] = exponential(h * Vec3::Unit(c - 3)) * q[n];
}

/// The stiffness that `add` gives to pairs of nodes.
template <class Add>
Eigen::MatrixXd gathered(Add add) {
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(24, 24);
    add([&](int a, int b, const Mat12& m) {
        CHECK(a != b);
        CHECK(largest_entry(m - m.transpose()) == 0);
        const int node[2] = {a, b};
        for (int r : {0, 1})
            for (int c : {0, 1}) k.block<6, 6>(6 * node[r], 6 * node[c]) += m.block<6, 6>(6 * r, 6 * c);
    });
    return k;
}

/// The slope of forces at the nodes, by differences; forces(n, c, h): after a nudge.
template <class Forces>
Eigen::MatrixXd slope_of(Forces forces, double h) {
    Eigen::MatrixXd d(24, 24);
    for (int n = 0; n < 4; ++n)
        for (int c = 0; c < 6; ++c) {
            const std::vector<Vec6> up = forces(n, c, h), down = forces(n, c, -h);
            for (int r = 0; r < 4; ++r) d.block<6, 1>(6 * r, 6 * n + c) = (up[r] - down[r]) / (2 * h);
        }
    return d;
}

/// The sum of forces, and that of moments about the origin.
inline std::pair<Vec3, Vec3> sums_of(const std::vector<Vec3>& x, const std::vector<Vec6>& f) {
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    for (std::size_t n = 0; n < x.size(); ++n)
        force += f[n].head<3>(), moment += f[n].tail<3>() + x[n].cross(f[n].head<3>());
    return {force, moment};
}

}  // namespace hinge::contact

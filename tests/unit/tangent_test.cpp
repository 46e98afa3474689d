// The element's tangent against finite differences of its forces.
#include "beam/tangent.h"

#include "beam/timoshenko.h"
#include "section/yield.h"
#include "helpers.h"

using namespace hinge;
using namespace hinge::beam;
using namespace hinge::test;

namespace {

struct Nodes {
    Vec3 x[2];
    Quat q[2];
    Vec3 turn[2] = {Vec3::Zero(), Vec3::Zero()};  // small displacement

    Nodes moved(int component, double by) const {
        Nodes n = *this;
        const int i = component / 6, c = component % 6;
        if (c < 3) {
            n.x[i][c] += by;
        } else {
            n.q[i] = exponential(by * Vec3::Unit(c - 3)) * n.q[i];
            n.turn[i][c - 3] += by;
        }
        return n;
    }
};

/// One element with made-up numbers of one order of magnitude, so that a difference quotient is good to nine digits.
struct Sample {
    Rigidity c;
    double L, s;
    Quat axes;
    Nodes start, now;
    Stiffness k;
    YieldSurface yield;  // none: elastic
    double sections[2] = {-1, 1};
    bool large;

    Sample(Dice& dice, bool large_displacement, double deform) : large(large_displacement) {
        c.EIx = dice(50, 200);
        c.EIy = dice(50, 200);
        c.EA = dice(5e3, 2e4);
        c.GJ = dice(50, 200);
        c.GAx = dice(2e3, 5e3);
        c.GAy = dice(2e3, 5e3);
        L = dice(0.8, 1.6);
        s = dice(-1, 1);
        axes = dice.rotation();
        k = stiffness(c, L, s);
        start.x[0] = dice.vector(1);
        start.x[1] = start.x[0] + axes * Vec3(0, 0, L);
        start.q[0] = start.q[1] = Quat::Identity();
        now = start;
        const Quat turn = large ? dice.rotation() : Quat::Identity();
        for (int i = 0; i < 2; ++i) {
            now.x[i] = turn * start.x[i] + dice.vector(0.3 * deform);
            now.turn[i] = dice.vector(deform);
            now.q[i] = exponential(now.turn[i]) * turn;
        }
    }

    beam::ElementFrame<double> placement(const Nodes& n) const {
        const auto quad = [](const Quat& q) { return Quadruple<double>{q.w(), q.x(), q.y(), q.z()}; };
        const Vec3 chord = large ? Vec3(n.x[1] - n.x[0]) : Vec3(start.x[1] - start.x[0]);
        const Quat none = Quat::Identity();
        return place<double>({chord.x(), chord.y(), chord.z()}, quad(large ? n.q[0] : none),
                             quad(large ? n.q[1] : none), quad(axes));
    }
    Vec6 deformation_of(const Nodes& n) const {
        Vec6 d;
        if (large) {
            deformation(placement(n), L, d.data());
        } else {
            const Mat3 to_local = axes.toRotationMatrix().transpose();
            Vec12 u;
            u << to_local * (n.x[0] - start.x[0]), to_local * n.turn[0], to_local * (n.x[1] - start.x[1]),
                to_local * n.turn[1];
            d = linear_deformation(L) * u;
        }
        return d;
    }
    ReturnMapResult forces(const Nodes& n) const {
        const Vec6 trial = k.times(deformation_of(n));
        if (yield.elastic()) {
            ReturnMapResult f;
            f.p = trial;
            return f;
        }
        return return_to_surface(trial, k, yield, sections, 2);
    }
    Vec12 at_nodes(const Nodes& n) const {
        const Vec6 p = forces(n).p;
        Vec12 f;
        if (large) {
            const auto out = nodal_forces(placement(n), p.data());
            f << out.force[0].x, out.force[0].y, out.force[0].z, out.moment[0].x, out.moment[0].y, out.moment[0].z,
                out.force[1].x, out.force[1].y, out.force[1].z, out.moment[1].x, out.moment[1].y, out.moment[1].z;
        } else {
            f = linear_deformation(L).transpose() * p;
            for (int b = 0; b < 4; ++b) f.segment<3>(3 * b) = (axes * Vec3(f.segment<3>(3 * b))).eval();
        }
        return f;
    }
    /// Difference quotient of at_nodes; empty when another set of ends flows at one of the points.
    bool differences(Mat12& K) const {
        const double h = 1e-6;
        const ReturnMapResult here = forces(now);
        for (int j = 0; j < 12; ++j) {
            const Nodes ahead = now.moved(j, h), behind = now.moved(j, -h);
            for (const ReturnMapResult& f : {forces(ahead), forces(behind)})
                for (int i = 0; i < 2; ++i) {
                    REQUIRE((f.lambda[i] >= 0 && here.lambda[i] >= 0));
                    if ((f.lambda[i] > 0) != (here.lambda[i] > 0)) return false;
                }
            K.col(j) = (at_nodes(ahead) - at_nodes(behind)) / (2 * h);
        }
        return true;
    }
    Mat12 analytic(bool geometric = true) const {
        const ReturnMapResult f = forces(now);
        Mat6 dp = k.matrix();
        if (!yield.elastic()) {
            const bool active[2] = {f.lambda[0] > 0, f.lambda[1] > 0};
            dp = plastic_tangent(f.p, k, yield, sections, f.lambda, active, 2);
        }
        if (large) return tangent(placement(now), f.p, dp, geometric);
        return linear_tangent(axes.toRotationMatrix().transpose(), L, dp);
    }
};

YieldSurface random_surface(Dice& dice) {
    const auto limit = [&](double about) { return 1 / std::pow(about * dice(0.5, 2), 2); };
    return {limit(30), limit(20), limit(100), limit(15)};
}

void compare(bool large, bool plastic, double deform, const std::string& name) {
    Dice dice(large ? 11 : 12);
    double worst = 0, without_geometric = 0;
    int flowing[3] = {0, 0, 0};
    for (int trial = 0; trial < 400; ++trial) {
        Sample sample(dice, large, deform);
        if (plastic) sample.yield = random_surface(dice);
        Mat12 K;
        if (!sample.differences(K)) continue;
        const ReturnMapResult f = sample.forces(sample.now);
        const int ends = (f.lambda[0] > 0) + (f.lambda[1] > 0);
        ++flowing[ends];
        if (plastic && ends == 0) continue;
        const double error = (sample.analytic() - K).norm() / K.norm();
        worst = largest_of(worst, error);
        if (large) without_geometric = largest_of(without_geometric, (sample.analytic(false) - K).norm() / K.norm());
    }
    CHECK_FIGURE("tangent against differences, " + name, worst, 1e-6);
    if (large) CHECK(without_geometric > 1e-3);  // the initial-stress part is there
    if (plastic) {
        CHECK(flowing[1] > 20);  // both kinds of flow occurred
        CHECK(flowing[2] > 20);
    }
}

}  // namespace

TEST_CASE("small displacement, elastic: tangent against finite differences (1e-6)") {
    compare(false, false, 0.2, "small, elastic");
}
TEST_CASE("small displacement, plastic at one end and at both (1e-6)") { compare(false, true, 0.4, "small, plastic"); }
TEST_CASE("large displacement, elastic, end rotations near zero (1e-6)") {
    compare(true, false, 0.01, "large, elastic, small strain");
}
TEST_CASE("large displacement, elastic, end rotations to 1 rad (1e-6)") { compare(true, false, 0.6, "large, elastic"); }
TEST_CASE("large displacement, plastic at one end and at both (1e-6)") { compare(true, true, 0.4, "large, plastic"); }

TEST_CASE(
    "the elastic tangent without initial stress is symmetric and leaves rigid motions free (1e-12, 1e-11: rounding)") {
    Dice dice(13);
    for (int trial = 0; trial < 50; ++trial) {
        const Sample sample(dice, true, 0.3);
        const Mat12 K = sample.analytic(false);
        CHECK((K - K.transpose()).norm() <= 1e-12 * K.norm());
        Eigen::Matrix<double, 12, 6> rigid;
        for (int i = 0; i < 2; ++i) {
            rigid.block<3, 3>(6 * i, 0).setIdentity();
            rigid.block<3, 3>(6 * i + 3, 0).setZero();
            rigid.block<3, 3>(6 * i, 3) = -skew(sample.now.x[i]);
            rigid.block<3, 3>(6 * i + 3, 3).setIdentity();
        }
        CHECK((K * rigid).norm() <= 1e-11 * K.norm());
    }
}

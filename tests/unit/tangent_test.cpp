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

    Nodes moved(const Vec12& by) const {
        Nodes n = *this;
        for (int i : {0, 1}) {
            n.x[i] += by.segment<3>(6 * i);
            n.q[i] = exponential(by.segment<3>(6 * i + 3)) * q[i];
            n.turn[i] += by.segment<3>(6 * i + 3);
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
        c = random_rigidity(dice, {100, 100, 1e4, 100, 3e3, 3e3});
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
            f << eigen(out.force[0]), eigen(out.moment[0]), eigen(out.force[1]), eigen(out.moment[1]);
        } else {
            f = linear_deformation(L).transpose() * p;
            for (int b = 0; b < 4; ++b) f.segment<3>(3 * b) = (axes * Vec3(f.segment<3>(3 * b))).eval();
        }
        return f;
    }
    /// Difference quotient of at_nodes; none when another set of ends flows at one of the points.
    bool by_differences(Mat12& K) const {
        const ReturnMapResult here = forces(now);
        bool same = true;
        const auto at = [&](const Vec12& by) {
            const ReturnMapResult f = forces(now.moved(by));
            for (int i : {0, 1}) {
                REQUIRE((f.lambda[i] >= 0 && here.lambda[i] >= 0));
                same = same && (f.lambda[i] > 0) == (here.lambda[i] > 0);
            }
            return at_nodes(now.moved(by));
        };
        K = differences(at, Vec12(Vec12::Zero()), Vec12(Vec12::Constant(1e-6)));
        return same;
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
        if (!sample.by_differences(K)) continue;
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

TEST_CASE("small displacement: tangent against finite differences, plastic at one end and at both too (1e-6)") {
    compare(false, false, 0.2, "small, elastic");
    compare(false, true, 0.4, "small, plastic");
}
TEST_CASE("large displacement: the same, with end rotations near zero and to 1 rad") {
    compare(true, false, 0.01, "large, elastic, small strain");
    compare(true, false, 0.6, "large, elastic");
    compare(true, true, 0.4, "large, plastic");
}

TEST_CASE("the elastic tangent without initial stress is symmetric and leaves rigid motions free (rounding)") {
    Dice dice(13);
    for (int trial = 0; trial < 50; ++trial) {
        const Sample sample(dice, true, 0.3);
        const Mat12 K = sample.analytic(false);
        CHECK((K - K.transpose()).norm() <= 1e-12 * K.norm());
        Eigen::Matrix<double, 12, 6> rigid;
        for (int i = 0; i < 2; ++i) {
            rigid.block<6, 6>(6 * i, 0).setIdentity();
            rigid.block<3, 3>(6 * i, 3) = -skew(sample.now.x[i]);
        }
        CHECK((K * rigid).norm() <= 1e-11 * K.norm());
    }
}

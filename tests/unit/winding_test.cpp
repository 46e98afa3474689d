// An element that is wound up by any number of turns, or folded: deformation, nodal forces, tangent.
#include "beam/winding.h"

#include "beam/tangent.h"
#include "beam/timoshenko.h"
#include "helpers.h"

using namespace hinge;
using namespace hinge::beam;
using namespace hinge::test;

namespace {

Quat about_z(double angle) { return Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ())); }

struct Ends {
    Vec3 chord;
    Quat q[2];
    Ends moved(const Vec12& by) const {
        Ends n = *this;
        n.chord += by.segment<3>(6) - by.head<3>();
        for (int i : {0, 1}) n.q[i] = exponential(by.segment<3>(6 * i + 3)) * q[i];
        return n;
    }
};

Winding winding(const Vec3& chord, const Quat (&q)[2], const Quat& axes, double L, double last) {
    Winding w;
    w.chord = {chord.x(), chord.y(), chord.z()};
    for (int i : {0, 1}) w.node[i] = quad(q[i]);
    w.axes = quad(axes);
    w.L = L, w.last = last;
    return w;
}

/// An element whose ends are twisted against each other by `twist` and then rotated at random by up to `bend` each.
struct Sample {
    double L = 1.3, last = 0;
    Quat axes = Quat::Identity();
    Ends now;
    Stiffness k;
    Vec6 plastic = Vec6::Zero();

    Sample(Dice& dice, double twist, double bend) : last(twist) {
        const Rigidity c = random_rigidity(dice, {100, 100, 1e3, 100, 300, 300});
        k = stiffness(c, L, dice(-1, 1));
        axes = dice.rotation();
        const Quat turn = dice.rotation();
        const double first = dice(-1, 1) * std::abs(twist);
        now.chord = turn * (axes * Vec3(0, 0, L)) + dice.vector(0.1);

        for (int i : {0, 1})
            now.q[i] = turn * exponential(dice.vector(bend)) * axes * about_z(first + i * twist) * axes.conjugate();
        for (double& part : plastic) part = dice(-0.1, 0.1);
        plastic[5] = twist + dice(-0.3, 0.3);
    }
    Winding at(const Ends& n) const {
        Winding w = winding(n.chord, n.q, axes, L, last);
        wind(w);
        return w;
    }
    Vec6 deformation_at(const Ends& n) const {
        const Winding w = at(n);
        return Eigen::Map<const Vec6>(w.d);
    }
    Vec6 p(const Ends& n) const { return k.times(deformation_at(n) - plastic); }
    double energy(const Ends& n) const { return 0.5 * (deformation_at(n) - plastic).dot(p(n)); }
    Vec12 at_nodes(const Ends& n) const { return rates(at(n)).transpose() * p(n); }
};

void against_differences(const std::string& name, double twist, double bend, double least_share, double most_share) {
    Dice dice(31);
    double force = 0, stiffness = 0, material = 0;
    int used = 0;
    for (int trial = 0; trial < 100; ++trial) {
        const Sample s(dice, twist, bend);
        const double share = s.at(s.now).share;
        if (!(share >= least_share && share <= most_share)) continue;
        ++used;
        const Vec12 here = Vec12::Zero(), h = Vec12::Constant(3e-6);
        const auto energy = [&](const Vec12& by) { return Eigen::Matrix<double, 1, 1>(s.energy(s.now.moved(by))); };
        const Vec12 f = differences(energy, here, h).transpose();
        const Mat12 K = differences([&](const Vec12& by) { return s.at_nodes(s.now.moved(by)); }, here, h);
        const Mat6 k = s.k.matrix();
        force = largest_of(force, (s.at_nodes(s.now) - f).norm() / f.norm());
        stiffness = largest_of(stiffness, (tangent(s.at(s.now), s.p(s.now), k, true) - K).norm() / K.norm());
        const auto T = rates(s.at(s.now));
        material = largest_of(material, (tangent(s.at(s.now), s.p(s.now), k, false) - T.transpose() * k * T).norm());
    }
    CHECK(used >= 20);
    CHECK_FIGURE("forces against differences of the energy, " + name, force, 1e-6);
    CHECK_FIGURE("tangent against differences of the forces, " + name, stiffness, 1e-6);
    CHECK_FIGURE("tangent without initial stress, " + name, material, 1e-9);
}

}  // namespace

TEST_CASE("wound by 3.3 turns: forces and tangent against finite differences (1e-6)") {
    against_differences("3.3 turns", 3.3 * 2 * pi, 0.4, 1, 1);
    against_differences("-3.3 turns", -3.3 * 2 * pi, 0.4, 1, 1);
    against_differences("half a turn", pi, 0.4, 1, 1);
    against_differences("six turns", 6 * 2 * pi, 0.4, 1, 1);
}

TEST_CASE("in the range of passage, 120 to 150 degrees: forces and tangent against finite differences (1e-6)") {
    against_differences("135 degrees", 0.75 * pi, 0.2, 0.01, 0.99);
    against_differences("-135 degrees", -0.75 * pi, 0.2, 0.01, 0.99);
    against_differences("folded", 0, 1.6, 0.01, 0.99);
    against_differences("an end near half a turn", 0.9, 3.1, 0.01, 0.99);
}

TEST_CASE("ends that turn on towards half a turn: the deformation does not jump") {
    Dice dice(34);
    double jump = 0;
    int far = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const Sample s(dice, dice(-1.5, 1.5), 0.5);
        const Vec3 axis[2] = {dice.vector(1).normalized(), dice.vector(1).normalized()};
        const double step = 1e-3;
        Vec6 before = s.deformation_at(s.now);
        for (int i = 1; i < 3000; ++i) {
            Ends there = s.now;
            for (int e : {0, 1}) there.q[e] = exponential(i * step * axis[e]) * there.q[e];
            const Winding w = s.at(there);
            if (w.open < 0.1 || std::abs(w.twist) > 2) break;
            const Vec6 now = s.deformation_at(there);
            jump = largest_of(jump, (now - before).norm() / step);
            before = now;
            far += w.share > 0;
        }
    }
    CHECK(far > 1000);
    CHECK_FIGURE("change of the deformation over that of the angle", jump, 100);
}

TEST_CASE("a rigid rotation of a wound element strains nothing (1e-12)") {
    Dice dice(32);
    double worst = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const Sample s(dice, dice(-40, 40), 0.5);
        const Quat turn = dice.rotation();
        Ends rotated = s.now;
        rotated.chord = turn * s.now.chord;
        for (Quat& q : rotated.q) q = turn * q;
        if (!(s.at(s.now).share > 0)) continue;
        worst = largest_of(worst, largest_entry(s.deformation_at(rotated) - s.deformation_at(s.now)));
        const Winding a = s.at(s.now), b = s.at(rotated);
        worst = largest_of(worst, (turn * eigen(a.frame.y) - eigen(b.frame.y)).norm());
    }
    CHECK_FIGURE("deformation by a rigid rotation", worst, 1e-12);
}

TEST_CASE("wound up from rest to ten turns, a little bent: no number jumps, and the twist is counted") {
    Dice dice(33);
    const Quat bend[2] = {exponential(dice.vector(0.1)), exponential(dice.vector(0.1))};

    const Vec3 chord(0.02, -0.03, 1.1);
    Vec6 before = Vec6::Zero();
    double last = 0, jump = 0, count = 0, first_difference = 0;
    const int steps = 20000;
    for (int i = 0; i <= steps; ++i) {
        const double angle = 10 * 2 * pi * i / steps;
        const Quat q[2] = {bend[0], bend[1] * about_z(angle)};
        Winding w = winding(chord, q, Quat::Identity(), 1, last);
        const bool wound = wind(w);
        Vec6 d;
        beam::ElementFrame<double> near = place<double>(w.chord, w.node[0], w.node[1], w.axes);
        if (wound) d = Eigen::Map<const Vec6>(w.d);
        else deformation(near, w.L, d.data());
        if (!wound) {
            Vec6 own = Eigen::Map<const Vec6>(w.d);
            first_difference = largest_of(first_difference, largest_entry(own - d));
        }
        if (i > 0) jump = largest_of(jump, largest_entry(d - before) / (10 * 2 * pi / steps));
        count = largest_of(count, std::abs(d[5] - angle));
        before = d;
        last = std::abs(w.twist) > remembered_twist ? w.twist : 0;
    }
    CHECK_FIGURE("largest rate of a deformation by the winding angle", jump, 1.1);
    CHECK_FIGURE("twist against the winding angle, rad (the ends are bent by up to 0.17 rad each)", count, 0.35);
    CHECK_FIGURE("what corotation.h finds below the passage, against what is found here", first_difference, 1e-13);
    CHECK(before[5] == Approx(20 * pi).margin(0.35));
}

TEST_CASE("a wound bar bends as one whose sections lie as its middle one does (1e-12)") {
    for (const double turns : {0.5, 1.0, 2.25}) {
        const double twist = turns * 2 * pi;
        const Vec3 slope[2] = {{0.1, 0.2, 0}, {-0.15, 0.05, 0}};  // swings from the chord, in space
        const Quat q[2] = {exponential(slope[0]), exponential(slope[1]) * about_z(twist)};
        Winding w = winding(Vec3::UnitZ(), q, Quat::Identity(), 1, twist);
        REQUIRE(wind(w));
        const Mat3 to_middle = about_z(0.5 * twist).toRotationMatrix().transpose();
        for (int e : {0, 1}) {
            const Vec3 wanted = to_middle * slope[e];
            CHECK(std::abs(w.d[e] - wanted.x()) <= 1e-12);
            CHECK(std::abs(w.d[2 + e] - wanted.y()) <= 1e-12);
        }
        CHECK(std::abs(w.d[5] - twist) <= 1e-12);
    }
}

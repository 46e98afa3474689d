// Panels: their strains in rigid rotation, their forces as the derivative of their energy, their laws, their bending.
#include "panel/bend.h"
#include "panel/membrane.h"
#include "panel/response.h"
#include "panel/sheet.h"

#include <numbers>

#include "helpers.h"

using namespace hinge;
using namespace hinge::test;
using panel::Layer;
using panel::LayerKind;

namespace {

using Places = std::vector<Vec3>;

Places quadrilateral(Dice& dice) {
    Places x = {{0, 0, 0}, {2, 0.2, 0}, {2.3, 1.6, 0}, {-0.2, 1.2, 0}};
    for (Vec3& p : x) p += Vec3(dice(-0.1, 0.1), dice(-0.1, 0.1), dice(-0.1, 0.1)) + Vec3(20, -30, 10);
    return x;
}

Quat turn(Dice& dice) {
    return Quat(Eigen::AngleAxisd(dice(0, 3), Vec3(dice(-1, 1), dice(-1, 1), dice(-1, 1)).normalized()));
}

Places minus(const Places& a, const Places& b) {
    Places d;
    for (std::size_t i = 0; i < a.size(); ++i) d.push_back(a[i] - b[i]);
    return d;
}

Layer layer(LayerKind kind, double strength) {
    Layer l;
    l.kind = kind, l.thickness = 0.01, l.E = 200e9, l.poisson = 0.3, l.strength = strength, l.hardening = 2e9;
    l.direction = {0.8, 0.2, 0.4};
    return l;
}

/// Energy that a strain brings, J/m^2, and its response, from what was kept before.
panel::Response answer(const Layer& l, const Vec3& strain, bool large, const std::vector<double>& before) {
    std::vector<double> after(before.size());
    return panel::respond(l, panel::Strained(strain, large), before.data(), after.data(), true);
}

}  // namespace

TEST_CASE("a panel that rotates as a rigid body has no strain") {
    Dice dice(7);
    for (int round = 0; round < 200; ++round) {
        Places x = quadrilateral(dice);
        if (round % 3 == 0) x.pop_back();
        const panel::Shape shape = panel::shape_of(x, Vec3(1, 0.3, 0), 0.3);
        REQUIRE(shape.area > 0);
        const Quat R = turn(dice);
        Places moved;
        for (const Vec3& p : x) moved.push_back(R * p + Vec3(3, 4, 5));
        const panel::Placed at = panel::place(shape, minus(moved, x), true);
        CHECK(largest_entry(at.strain) < 1e-13 * 40);
        CHECK(largest_entry(at.p) < 1e-13 * 40);
    }
}

TEST_CASE("a panel whose nodes move linearly has that strain at all points") {
    Dice dice(8);
    for (int round = 0; round < 50; ++round) {
        Places x = quadrilateral(dice);
        for (Vec3& p : x) p.z() = 0;
        const panel::Shape shape = panel::shape_of(x, Vec3::UnitX(), 0.3);
        Mat3 F = Mat3::Identity();
        for (int i : {0, 1})
            for (int j : {0, 1}) F(i, j) += dice(-0.2, 0.2);
        Places moved;
        for (const Vec3& p : x) moved.push_back(turn(dice) * (F * p));
        const Mat3 E = 0.5 * (F.transpose() * F - Mat3::Identity());
        const Quat R = turn(dice);
        for (std::size_t i = 0; i < x.size(); ++i) moved[i] = R * (F * x[i]);
        const panel::Placed at = panel::place(shape, minus(moved, x), true);
        CHECK(largest_entry(at.strain - Vec3(E(0, 0), E(1, 1), 2 * E(0, 1))) < 1e-12);
        CHECK(largest_entry(at.p) < 1e-12);
        double area = 0, share = 0;
        for (int k = 0; k < 4; ++k) area += shape.point[k].area, share += shape.share[k];
        CHECK(area == Approx(shape.area).epsilon(1e-12));
        CHECK(share == Approx(shape.area).epsilon(1e-12));
    }
}

TEST_CASE("the stress of a layer is the derivative of its energy, and its tangent that of the stress") {
    Dice dice(9);
    for (const LayerKind kind : {LayerKind::solid, LayerKind::concrete, LayerKind::bars})
        for (const bool large : {false, true}) {
            int rough = 0;
            for (int round = 0; round < 50; ++round) {
                const Layer elastic = layer(kind, 1e30), yields = layer(kind, 100e6);
                const std::vector<double> fresh(std::size_t(elastic.history_size()), 0);
                const Vec3 e = 0.003 * Vec3(dice(-1, 1), dice(-1, 1), dice(-1, 1));
                const double h = 1e-8;
                const panel::Response at = answer(elastic, e, large, fresh), flowed = answer(yields, e, large, fresh);
                Vec3 slope;
                Mat3 change;
                for (int k = 0; k < 3; ++k) {
                    const Vec3 by = h * Vec3::Unit(k);
                    slope[k] =
                        (answer(elastic, e + by, large, fresh).stored - answer(elastic, e - by, large, fresh).stored) /
                        (2 * h);
                    change.col(k) =
                        (answer(yields, e + by, large, fresh).stress - answer(yields, e - by, large, fresh).stress) /
                        (2 * h);
                }
                const double size = elastic.E * elastic.thickness;
                CHECK(largest_entry(slope - at.stress) < 1e-8 * size);
                rough += !(largest_entry(change - flowed.tangent) < 1e-5 * size);
            }
            CHECK(rough <= 1);  // a difference may lie across a corner of the law
        }
}

TEST_CASE("a panel of layers: its forces and moments are the derivative of its energy, its stiffness that of these") {
    Dice dice(21);
    int rough = 0;
    for (int round = 0; round < 60; ++round) {
        const bool cracks = round % 2 == 1;
        panel::Sheet sheet;
        sheet.bends_by_layers = true;
        for (const double z : {-0.04, 0.01, 0.05}) {  // not symmetrical: strain and curvature belong together
            Layer l = layer(cracks && z > 0 ? LayerKind::concrete : LayerKind::solid, 1e30);
            l.thickness *= 1 + 20 * std::abs(z), l.levels = {{z - 0.002, 0.4}, {z + 0.003, 0.6}};
            sheet.layers.push_back(l);
        }
        const panel::Shape shape = panel::shape_of(quadrilateral(dice), Vec3(1, 0.3, 0), 0.3);
        const panel::OwnStrains own = panel::own_strains_of(sheet, shape);
        const std::vector<double> fresh(std::size_t(panel::history_size(sheet, shape)), 0);
        panel::Placed at;
        at.large = false;
        panel::Curvatures curved;
        using Vec17 = Eigen::Matrix<double, 17, 1>;
        Vec17 start;
        for (int k = 0; k < 17; ++k) start[k] = (k < 3 ? 1e-3 : k < 5 ? 1e-3 : 2e-2) * dice(-1, 1);
        panel::Mat17 tangent;
        const auto ask = [&](const Vec17& u, panel::Mat17* K) {
            at.strain = u.head<3>(), at.p = u.segment<2>(3);
            for (int k = 0; k < 4; ++k) curved[std::size_t(k)] = u.segment<3>(5 + 3 * k);
            std::vector<double> after(fresh.size());
            return panel::respond(sheet, shape, at, 0, K != nullptr, {&curved, &own, K}, fresh.data(), after.data());
        };
        const auto forces = [&](const panel::PanelResponse& r) {
            Vec17 f;
            f << r.resultants.mean, r.resultants.varying, r.moment[0], r.moment[1], r.moment[2], r.moment[3];
            return f;
        };
        const panel::PanelResponse here = ask(start, &tangent);
        CHECK(here.left < 1e-5);
        const Vec17 f = forces(here);
        Vec17 slope;
        panel::Mat17 change;
        for (int k = 0; k < 17; ++k) {
            const double h = k < 5 ? 1e-7 : 1e-6;
            const panel::PanelResponse up = ask(start + h * Vec17::Unit(k), nullptr),
                                       down = ask(start - h * Vec17::Unit(k), nullptr);
            slope[k] = (up.stored - down.stored) / (2 * h);
            change.col(k) = (forces(up) - forces(down)) / (2 * h);
        }
        CHECK(largest_entry(slope - f) < 1e-4 * largest_entry(f));
        const double off = largest_entry(change - tangent) / largest_entry(tangent);
        rough += !(off < (cracks ? 1e-2 : 2e-3));  // the section is given a thousandth of its elastic stiffness
    }
    CHECK(rough <= 3);  // a difference may lie across a corner of the law
}

TEST_CASE("a plate that yields has von Mises' strength, and dissipates what it does not store") {
    const Layer plate = layer(LayerKind::solid, 250e6);
    std::vector<double> before(std::size_t(plate.history_size()), 0), after = before;
    double work = 0, dissipated = 0;
    Vec3 stress = Vec3::Zero(), strain = Vec3::Zero();
    panel::Response r;
    Dice dice(10);
    Vec3 way = Vec3::Zero();
    for (int step = 0; step < 4000; ++step) {
        if (step % 500 == 0) way = 1e-5 * Vec3(dice(-1, 1), dice(-1, 1), dice(-1, 1));
        strain += way;
        r = panel::respond(plate, panel::Strained(strain, false), before.data(), after.data(), false);
        work += 0.5 * (stress + r.stress).dot(way);
        dissipated += r.dissipated;
        stress = r.stress;
        before = after;
        const Vec3 s = stress / plate.thickness;
        const double mises = std::sqrt(s[0] * s[0] + s[1] * s[1] - s[0] * s[1] + 3 * s[2] * s[2]);
        CHECK(mises <= (plate.strength + plate.hardening * after[3]) * (1 + 1e-10));
    }
    CHECK(after[3] > 0.01);
    CHECK(work == Approx(r.stored + dissipated).epsilon(1e-10));
}

TEST_CASE("forces of a panel do the work of its strain, and their derivative is the stiffness") {
    Dice dice(11);
    for (int round = 0; round < 20; ++round) {
        Places x = quadrilateral(dice);
        if (round % 3 == 0) x.pop_back();
        const panel::Shape s = panel::shape_of(x, Vec3(1, 0.3, 0), 0.2);
        const Quat R = turn(dice);
        Places u;
        for (const Vec3& p : x) u.push_back(R * p - p + 0.1 * Vec3(dice(-1, 1), dice(-1, 1), dice(-1, 1)));
        const panel::Resultants r{{1e3 * dice(-1, 1), 2e3, 3e3}, {400, -500}};
        const panel::Mat5 none = panel::Mat5::Zero();
        const auto work = [&](const Places& moved) {
            const panel::Placed at = panel::place(s, moved, true);
            return r.mean.dot(at.strain) + r.varying.dot(at.p);
        };
        const auto forces = [&](const Places& moved) {
            Places f(4, Vec3::Zero());
            panel::add_forces(s, panel::place(s, moved, true), r, f);
            return f;
        };
        const Places f = forces(u);
        std::vector<Mat3> K(16, Mat3::Zero());
        panel::for_each_stiffness(s, panel::place(s, u, true), r, none, [&](int a, int b, const Mat3& k) {
            K[std::size_t(4 * a + b)] = k, K[std::size_t(4 * b + a)] = k.transpose();
        });
        Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
        for (std::size_t i = 0; i < x.size(); ++i) sum += f[i], moment += (x[i] + u[i]).cross(f[i]);
        CHECK(largest_entry(sum) < 1e-9);
        CHECK(largest_entry(moment) < 1e-8);
        const double h = 1e-5;
        for (std::size_t j = 0; j < x.size(); ++j)
            for (int c = 0; c < 3; ++c) {
                Places up = u, down = u;
                up[j][c] += h, down[j][c] -= h;
                CHECK(std::abs((work(up) - work(down)) / (2 * h) - f[j][c]) < 1e-4);
                const Places fu = forces(up), fd = forces(down);
                for (std::size_t i = 0; i < x.size(); ++i)
                    CHECK(largest_entry((fu[i] - fd[i]) / (2 * h) - K[4 * i + j].col(c)) < 1e-4);
            }
    }
}

namespace {

/// Nine panels in a square, skewed a little.
struct Floor {
    Places x;
    std::vector<std::array<int, 4>> corners;
    std::vector<panel::Corners> panels;
    explicit Floor(double skew) {
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) x.push_back({i + skew * j, 1.1 * j, 0});
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i) corners.push_back({4 * j + i, 4 * j + i + 1, 4 * j + i + 5, 4 * j + i + 4});
        for (const auto& c : corners) panels.push_back({c, 1.1, 0.3});
    }
};

}  // namespace

TEST_CASE("bends have the curvature of a quadratic surface, in skewed panels too") {
    for (const double skew : {0.0, 0.3}) {
        const Floor floor(skew);
        const Vec3 k(0.02, -0.03, 0.01);  // w,xx w,yy w,xy
        Places u;
        for (const Vec3& p : floor.x)
            u.push_back({0, 0, 0.5 * k[0] * p.x() * p.x() + 0.5 * k[1] * p.y() * p.y() + k[2] * p.x() * p.y()});
        int inside = 0;
        for (const panel::Bend& b : panel::bends_of(floor.panels, floor.x)) {
            if (b.around.size() != 4) continue;
            ++inside;
            Places at, moved;
            for (const int n : b.nodes) at.push_back(floor.x[std::size_t(n)]), moved.push_back(u[std::size_t(n)]);
            const Vec3 curvature = b.to_frame * panel::bent(b, at, moved, false).derivative;
            CHECK(curvature[0] + curvature[1] == Approx(k[0] + k[1]).epsilon(1e-12));
            const double det = curvature[0] * curvature[1] - 0.25 * curvature[2] * curvature[2];
            CHECK(det == Approx(k[0] * k[1] - k[2] * k[2]).epsilon(1e-12));
        }
        CHECK(inside == 4);
    }
}

TEST_CASE("bends do not change where a floor moves as a rigid body, and their forces have no resultant") {
    const Floor floor(0.1);
    Dice dice(12);
    Places bent_to;
    const Quat R = turn(dice);
    for (const Vec3& p : floor.x) bent_to.push_back(R * (p + Vec3(0, 0, 0.1 * std::sin(p.x() + 2 * p.y()))));
    for (const panel::Bend& b : panel::bends_of(floor.panels, floor.x)) {
        Places flat, at;
        for (const int n : b.nodes) flat.push_back(R * floor.x[std::size_t(n)]), at.push_back(bent_to[std::size_t(n)]);
        CHECK(largest_entry(panel::bent(b, flat, flat, true).derivative) < 1e-13);
        const panel::Bent now = panel::bent(b, at, at, true);
        const panel::Gradient G = panel::gradient(b, now, at, true);
        const double h = 1e-6;
        for (int c = 0; c < 3; ++c) {
            Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
            for (std::size_t j = 0; j < at.size(); ++j) {
                const Vec3 f = G.block<1, 3>(c, 3 * int(j)).transpose();
                sum += f, moment += at[j].cross(f);
                for (int k = 0; k < 3; ++k) {
                    Places up = at, down = at;
                    up[j][k] += h, down[j][k] -= h;
                    const double slope =
                        (panel::bent(b, up, up, true).derivative[c] - panel::bent(b, down, down, true).derivative[c]) /
                        (2 * h);
                    CHECK(std::abs(slope - f[k]) < 1e-7);
                }
            }
            CHECK(largest_entry(sum) < 1e-13);
            CHECK(largest_entry(moment) < 1e-12);
        }
        const Vec3 moments(0.7, -0.3, 0.4);
        Places forces(at.size(), Vec3::Zero());
        panel::add_forces(b, now, at, true, moments, forces);
        for (std::size_t j = 0; j < at.size(); ++j)
            CHECK(largest_entry(forces[j] - G.block<3, 3>(0, 3 * int(j)).transpose() * moments) < 1e-13);
    }
}

TEST_CASE("principal moments keep within the plastic ones, and the tangent is the derivative") {
    const panel::BendingLaw law{1e6, 0.2, 2e4, 1e4};
    Dice dice(13);
    for (int round = 0; round < 200; ++round) {
        const Vec3 k = 0.03 * Vec3(dice(-1, 1), dice(-1, 1), dice(-1, 1));
        const double before[panel::bending_history] = {};
        double after[panel::bending_history];
        const panel::BendingResponse at = panel::bend(law, k, before, after);
        const double middle = 0.5 * (at.moment[0] + at.moment[1]),
                     half = std::hypot(0.5 * (at.moment[0] - at.moment[1]), at.moment[2]);
        CHECK(middle + half <= law.sagging * (1 + 1e-12));
        CHECK(middle - half >= -law.hogging * (1 + 1e-12));
        CHECK(at.dissipated >= 0);
        const double h = 1e-9;
        Mat3 change;
        for (int c = 0; c < 3; ++c)
            change.col(c) = (panel::bend(law, k + h * Vec3::Unit(c), before, after).moment -
                             panel::bend(law, k - h * Vec3::Unit(c), before, after).moment) /
                            (2 * h);
        CHECK(largest_entry(change - at.tangent) < 1e-4 * law.stiffness);
    }
}

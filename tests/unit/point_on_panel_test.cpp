// Where a point stands over a panel, and the law by which it presses on it.
#include "contact/point_on_panel.h"
#include "contact/press_law.h"

#include "helpers.h"

using namespace hinge;
using namespace hinge::test;
using contact::Foot;

namespace {

using Places = std::vector<Vec3>;

Places corners(Dice& dice, int n) {
    Places x = {{0, 0, 0}, {2, 0.2, 0}, {2.3, 1.6, 0}, {-0.2, 1.2, 0}};
    x.resize(std::size_t(n));
    for (Vec3& p : x) p += Vec3(dice(-0.1, 0.1), dice(-0.1, 0.1), dice(-0.1, 0.1)) + Vec3(20, -30, 10);
    return x;
}
Vec3 place_of(const Places& x, const Foot& foot) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < x.size(); ++i) sum += foot.share[i] * x[i];
    return sum;
}

}  // namespace

TEST_CASE("the foot of a point is perpendicular below it, and as high as it was put") {
    Dice dice(3);
    for (int k = 0; k < 400; ++k) {
        const int n = k % 4 == 0 ? 3 : 4;
        const Places x = corners(dice, n);
        const double at[2] = {n == 3 ? dice(0.05, 0.45) : dice(-0.9, 0.9), n == 3 ? dice(0.05, 0.45) : dice(-0.9, 0.9)};
        const Foot there = contact::surface_at(x, at);
        const double height = dice(-0.3, 0.3);
        const Foot foot = contact::foot_of(x, place_of(x, there) + height * there.normal);
        CHECK(std::abs(foot.at[0] - at[0]) < 1e-9);
        CHECK(std::abs(foot.at[1] - at[1]) < 1e-9);
        CHECK(std::abs(foot.height - height) < 1e-10);
        CHECK(foot.beyond < 0);
        CHECK(std::abs(foot.share[0] + foot.share[1] + foot.share[2] + foot.share[3] - 1) < 1e-12);
        const double out[2] = {n == 3 ? 1.2 : 1.5, 0.1};
        const Foot rim = contact::surface_at(x, out);
        CHECK(contact::foot_of(x, place_of(x, rim)).beyond > 0);
    }
}

TEST_CASE("the slope of the normal is its derivative") {
    Dice dice(5);
    for (int k = 0; k < 50; ++k) {
        Places x = corners(dice, k % 4 == 0 ? 3 : 4);
        const double at[2] = {0.3, 0.2};
        const Vec3 direction(dice(-1, 1), dice(-1, 1), dice(-1, 1));
        const Foot foot = contact::surface_at(x, at);
        for (std::size_t i = 0; i < x.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                constexpr double by = 1e-6;
                Places more = x, less = x;
                more[i][c] += by, less[i][c] -= by;
                const double change =
                    direction.dot(contact::surface_at(more, at).normal - contact::surface_at(less, at).normal) /
                    (2 * by);
                CHECK(std::abs(contact::slope_of_normal(foot, direction, i)[c] - change) < 1e-8);
            }
    }
}

TEST_CASE("what goes along with a panel that rotates has the same place on it") {
    Dice dice(7);
    for (int k = 0; k < 50; ++k) {
        const Places x = corners(dice, 4);
        const Quat turn(Eigen::AngleAxisd(dice(0, 3), Vec3(dice(-1, 1), dice(-1, 1), dice(-1, 1)).normalized()));
        Places turned = x;
        for (Vec3& p : turned) p = turn * p;
        const double at[2] = {-0.4, 0.6};
        const Vec3 v(dice(-1, 1), dice(-1, 1), dice(-1, 1));
        CHECK((contact::carried(v, contact::surface_at(x, at), contact::surface_at(turned, at)) - turn * v).norm() <
              1e-12);
    }
}

TEST_CASE("a mass goes back with the restitution's part of its speed, at any speed") {
    for (const double restitution : {1.0, 0.8, 0.5, 0.3, contact::least_restitution})
        for (const double speed : {0.01, 1.0, 30.0}) {
            constexpr double k = 1e6, mass = 10, dt = 1e-7;
            const double a = contact::damping_for(restitution);
            double g = 0, v = speed, fastest = 0, lost = 0;
            contact::Press before;
            for (bool first = true; first || g > 0; first = false) {
                const double to = g + dt * v;
                const contact::Press now = contact::press(k, a, to, v, fastest, dt);
                lost += contact::Press::lost(before, now, to - g);
                fastest = now.fastest, g = to, before = now;
                v -= dt * now.force / mass;
            }
            CHECK(std::abs(-v - restitution * speed) < 2e-3 * speed);
            CHECK(std::abs(lost - 0.5 * mass * (speed * speed - v * v)) < 2e-3 * mass * speed * speed);
        }
}

// The search for plastic flow by itself, without a law of a section: an ellipsoid, whose work D(e) = |e| is known,
// under random forces.
#include "section/flow_problem.h"

#include "beam/timoshenko.h"
#include "helpers.h"
#include "section/flow_end.h"
#include "section/flow_return.h"

using namespace hinge;
using namespace hinge::beam;
using namespace hinge::test;

namespace {

constexpr double ends[2] = {-1, 1};

/// The unit sphere of normalised resultants.
class Sphere : public PlasticWork {
public:
    double potential(const Vec4& e, const double*, Vec4& q, Mat4& curvature) const override {
        const double D = e.norm();
        q = e / D, curvature = (Mat4::Identity() - q * q.transpose()) / D;
        return D;
    }
    Vec4 direction(const Vec4& q) const override { return q; }
    bool outside(const Vec4& q, const double*, Vec4& direction) const override {
        return direction = q, q.norm() > 1 + 1e-12;
    }
};

struct OneElement {
    Sphere sphere;
    Vec4 strength{1.2e5, 0.6e5, 2e6, 0.4e5};
    FlowProblem problem{sphere, strength, {}, false, 0};
    Stiffness k;
    Vec6 trial;

    OneElement(Dice& dice, double size) {
        k = stiffness({2e7, 7e6, 1.5e9, 4e6, 3e8, 3e8}, dice(1, 5), dice(-1, 1));
        for (int i = 0; i < 6; ++i) trial[i] = size * dice(-1, 1) * strength[i < 4 ? i / 2 : i - 2];
    }
    double utilisation(const Vec6& p, int end) const {
        return resultants(p, ends[end]).cwiseProduct(problem.per_strength).norm();
    }
};

}  // namespace

TEST_CASE("flow: forces are on the surface where a section flows and within it elsewhere", "[flow]") {
    Dice dice(3);
    for (int i = 0; i < 300; ++i) {
        const OneElement of(dice, dice(0.2, 5));
        const ElementFlow flow = find_flow(of.problem, of.trial, of.k, ends, 2, {}, nullptr);
        REQUIRE(flow.converged);
        CHECK((flow.p - (of.trial - of.k.times(flow.plastic))).norm() <= 1e-12 * of.trial.norm());
        Vec6 plastic = Vec6::Zero();
        for (int end : {0, 1}) {
            const double g = of.utilisation(flow.p, end);
            CHECK(g <= 1 + 1e-10);
            if (!(flow.lambda[end] > 0)) continue;
            CHECK(g == Approx(1).epsilon(1e-10));
            FlowingEnd flowing(ends[end], of.problem.per_strength, of.k);
            flowing.e = of.problem.normalised(flow.section[end]);
            plastic += flowing.plastic();
            const Vec4 normal = flowing.carries(flow.p);  // of the sphere
            CHECK((flowing.e.normalized() - normal.normalized()).norm() <= 1e-9);
        }
        CHECK((plastic - flow.plastic).norm() <= 1e-12 * (1e-9 + flow.plastic.norm()));
    }
}

TEST_CASE("flow: the tangent is the slope of the forces", "[flow]") {
    Dice dice(5);
    int tested = 0;
    for (int i = 0; i < 60; ++i) {
        const OneElement of(dice, 3);
        const ElementFlow flow = find_flow(of.problem, of.trial, of.k, ends, 2, {}, nullptr);
        if (!flow.yields()) continue;
        const Mat6 K = of.k.matrix(), slope_of_flow = tangent_of_element(of.problem, flow, of.k, ends, 2, {});
        for (int c = 0; c < 6; ++c) {
            const double step = 1e-5 * of.strength[c < 4 ? c / 2 : c - 2] / K(c, c);
            const auto at = [&](double by) {
                return find_flow(of.problem, of.trial + by * K.col(c), of.k, ends, 2, {}, &flow);
            };
            const ElementFlow less = at(-step), more = at(step);
            if ((less.lambda[0] > 0) != (more.lambda[0] > 0) || (less.lambda[1] > 0) != (more.lambda[1] > 0))
                continue;  // the slope jumps
            CHECK(((more.p - less.p) / (2 * step) - slope_of_flow.col(c)).norm() <= 1e-4 * K.col(c).norm());
            ++tested;
        }
    }
    CHECK(tested > 100);
}

TEST_CASE("flow: a surface that nothing reaches leaves the trial as it is", "[flow]") {
    Dice dice(7);
    const OneElement of(dice, 0.2);
    const ElementFlow flow = find_flow(of.problem, of.trial, of.k, ends, 2, {}, nullptr);
    CHECK(flow.converged);
    CHECK(!flow.flows());
    CHECK(flow.p == of.trial);
}

// Members that carry tension alone or compression alone: the return, its energy and its tangent.
#include <optional>

#include "beam/timoshenko.h"
#include "helpers.h"
#include "section/laws/laws.h"

using namespace hinge;
using namespace hinge::beam;
using namespace hinge::test;

namespace {

constexpr double ends[2] = {-1, 1}, middle[1] = {0};

Stiffness element() { return stiffness({3e4, 2e4, 8e7, 1e4, 1e7, 1e7}, 1.5, 0.3); }

/// An element whose deformation a test prescribes, step by step.
struct Driven {
    const SectionLaw& law;
    int sections = 2;
    Stiffness k = element();
    Vec6 plastic = Vec6::Zero(), p = Vec6::Zero();
    double history[2] = {0, 0};

    ReturnMapResult look(const Vec6& d) const {
        const SectionConditions at{no_fixed_end, history, 0};
        const Vec6 trial = k.times(d - plastic);
        const double* r = sections == 2 ? ends : middle;
        if (law.surely_elastic(trial, r, sections, at)) {
            ReturnMapResult same;
            same.p = trial;
            return same;
        }
        return law.return_to_surface(trial, k, r, sections, at);
    }
    ReturnMapResult to(const Vec6& d) {
        const ReturnMapResult flow = look(d);
        plastic += flow.plastic, p = flow.p;
        for (int i = 0; i < sections; ++i) law.commit(flow, i, 0, history + i);
        return flow;
    }
    double N(double elongation) { return to(elongation * Vec6::Unit(4)).p[4]; }
    double slack() const { return law.slack(history); }
};

}  // namespace

// 1e-12: a few roundings of forces of k |d|. The increments of the slack add up 5000 times: 1e-11.
TEST_CASE("one way: on a random path N follows the elongation alone, and slack takes no work") {
    for (int sign : {1, -1}) {
        const auto law = one_way_law(sign, infinite);
        Driven bar{*law};
        Dice dice(7);
        const double size = 0.01, k = bar.k.axial;
        double d = 0, N = 0, work = 0, moved = 0, off = 0, of_slack = 0, dissipated = 0;
        const auto go = [&](double to) {
            Vec6 whole = Vec6::Zero();
            whole[4] = to, whole[0] = dice(-0.01, 0.01), whole[3] = dice(-0.01, 0.01), whole[5] = dice(-0.01, 0.01);
            const ReturnMapResult flow = bar.to(whole);
            work += 0.5 * (N + flow.p[4]) * (to - d), moved += std::abs(0.5 * (N + flow.p[4]) * (to - d));
            N = flow.p[4], d = to;
            CHECK(sign * N >= 0);
            CHECK(!flow.yields());
            const Vec6 elastic = bar.k.times(whole);
            for (int c : {0, 1, 2, 3, 5}) off = largest_of(off, std::abs(flow.p[c] - elastic[c]) / 1e4);
            off = largest_of(off, std::abs(N - sign * largest_of(0.0, sign * k * d)) / (k * size));
            of_slack = largest_of(of_slack, std::abs(bar.slack() - (sign * d < 0 ? d : 0)) / size);
            dissipated = largest_of(dissipated, std::abs(flow.dissipation));
        };
        for (int i = 0; i < 5000; ++i) {
            const double next = dice(-size, size);
            if (next * d < 0) go(0);  // the force is linear in the elongation on either side of 0
            go(next);
        }
        go(0);
        CHECK(off < 1e-11);
        CHECK(of_slack < 1e-11);
        CHECK(dissipated == 0);
        CHECK(std::abs(work) < 1e-10 * moved);
    }
}

// Yield moves the length at which the member carries again: N = k (d - y), at least 0, where y is the most by which d
// has ever been beyond N0 / k.
TEST_CASE("one way: a member that yields keeps its elongation apart from its slack") {
    for (int sign : {1, -1})
        for (int sections : {1, 2}) {
            const double N0 = 2e5;
            const auto law = one_way_law(sign, N0);
            Driven bar{*law};
            bar.sections = sections;
            Dice dice(8);
            const double k = bar.k.axial;
            double y = 0, dissipated = 0, off = 0;
            int flowed = 0;
            for (int i = 0; i < 3000; ++i) {
                const double most = 4e-3 + 1e-5 * i, d = dice(-most, most);
                const ReturnMapResult flow = bar.to(sign * d * Vec6::Unit(4));
                const double before = y;
                y = largest_of(y, d - N0 / k);
                const double N = largest_of(0.0, k * (d - y));
                off = largest_of(off, std::abs(sign * flow.p[4] - N) / N0);
                off = largest_of(off, std::abs(flow.dissipation - N0 * (y - before)) / (N0 * N0 / k));
                CHECK(flow.dissipation >= 0);
                CHECK(flow.yields() == (flow.dissipation > 0));
                dissipated += flow.dissipation, flowed += flow.yields();
            }
            CHECK(off < 1e-9);
            CHECK(flowed > 10);
            CHECK(std::abs(dissipated / (N0 * y) - 1) < 1e-9);
        }
}

TEST_CASE("one way: the tangent is that of differences, on either side of each kink") {
    const double N0 = 2e5;
    int kinds[3] = {0, 0, 0};  // slack, elastic after slack, yields
    for (int sign : {1, -1}) {
        const auto law = one_way_law(sign, N0);
        Dice dice(9);
        double off = 0;
        std::optional<Driven> element;
        for (int i = 0; i < 4000; ++i) {
            if (i % 20 == 0) element.emplace(*law);  // before it has yielded so far that it is always slack
            Driven& bar = *element;
            Vec6 d;
            for (int c = 0; c < 6; ++c) d[c] = dice(-0.01, 0.01);
            const double h = 1e-7;
            const ReturnMapResult flow = bar.look(d);
            const double n = sign * flow.p[4], way = 2 * bar.k.axial * h,
                         to_carry = d[4] - bar.plastic[4] + bar.slack(),
                         yielded = sign * bar.k.axial * (flow.plastic[4] - flow.slack);
            const bool at_kink = flow.yields() ? yielded < way
                                 : n > 0       ? n < way || n > N0 - way
                                               : sign * bar.k.axial * to_carry > -way;
            if (!at_kink && flow.flows()) {
                const Mat6 K = law->tangent(flow, bar.k, ends, 2, {no_fixed_end, bar.history}),
                           by_differences =
                               differences([&](const Vec6&to) { return bar.look(to).p; }, d, Vec6(Vec6::Constant(h)));
                off = largest_of(off, (K - by_differences).norm() / bar.k.matrix().norm());
                ++kinds[flow.yields() ? 2 : n > 0 ? 1 : 0];
            }
            bar.to(d);
        }
        CHECK(off < 1e-6);
    }
    for (int count : kinds) CHECK(count > 20);
}

TEST_CASE("one way: its screen passes no force but zero, and its utilisation counts the sign") {
    const auto cable = one_way_law(1, 2e5), strut = one_way_law(-1, 2e5), bare = one_way_law(1, infinite);
    for (const double N : {1e-30, -1e-30, 1.0, -1e9})
        CHECK(beam::yield_function(Vec6(N * Vec6::Unit(4)), 0.0, cable->screen()) > 1);
    CHECK(beam::yield_function(Vec6(Vec6::Zero()), 0.0, cable->screen()) <= 1);
    CHECK(cable->yield_function({0, 0, 1e5, 0}) == 0.25);
    CHECK(cable->yield_function({0, 0, -1e5, 0}) == 0);
    CHECK(strut->yield_function({0, 0, -1e5, 0}) == 0.25);
    CHECK(bare->yield_function({0, 0, 1e5, 0}) == 0);
    CHECK(!cable->forms_pairs());
}

TEST_CASE("one way: a force that is not a number is not found") {
    const auto law = one_way_law(1, infinite);
    Vec6 trial = Vec6::Zero();
    trial[4] = std::nan("");
    CHECK(!law->return_to_surface(trial, element(), ends, 2, no_fixed_end).converged);
}

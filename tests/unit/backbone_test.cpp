// The backbone of a hinge: strength over plastic rotation, on eq 14 and on the exact interaction.

#include "core/errors.h"
#include "driven_element.h"

using namespace hinge;
using namespace hinge::beam;
using namespace hinge::test;
using namespace hinge::test::element;

namespace {

/// Yields at 1.1, cap of 1.2 at 0.03 rad, falls to 0.4 at 0.12 rad, nothing left from 0.2 rad on.
const Backbone example = {{{0, 1.1}, {0.03, 1.2}, {0.12, 0.4}, {0.2, 0.4}, {0.201, 0.01}}, 0};

double by_hand(double rotation) {
    if (rotation <= 0.03) return 1.1 + 0.1 * rotation / 0.03;
    if (rotation <= 0.12) return 1.2 - 0.8 * (rotation - 0.03) / 0.09;
    if (rotation <= 0.2) return 0.4;
    return 0.4 - 0.39 * std::min(1.0, (rotation - 0.2) / 0.001);
}

double work_by_hand(double from, double to, int parts) {
    double sum = 0;
    for (int j = 0; j < parts; ++j) sum += by_hand(from + (to - from) * (j + 0.5) / parts) * (to - from) / parts;
    return sum;
}

/// Rotation of node 2 about x, node 1 held: hinges at both ends, with a moment that is larger at end 2.
Vec6 turned(double by) { return by * Vec6::Unit(1); }

Driven begun(const SectionLaw& law, bool first_end = true) {
    Driven element(law);
    for (int s : {0, 1}) law.start(s == 1 || first_end, element.history.data() + s * law.history_size());
    return element;
}

}  // namespace

TEST_CASE("backbone: the moment over the plastic rotation is that of the points, whatever the steps") {
    for (const bool exact : {false, true})
        for (const int steps : {11, 230}) {
            const auto law = law_with({backbone_law(example)}, exact);
            Driven beam = begun(*law);
            double off = 0, work = 0, area = 0, before = 0;
            for (int i = 1; i <= steps; ++i) {
                const ReturnMapResult flow = beam.to(turned(0.23 * i / steps));
                const double rotation = beam.plastic[1];
                off = largest_of(off, rotation > 0 ? std::abs(beam.p[1] / strength[0] - by_hand(rotation)) : 0);
                // the other end flows too: its part by its own rotation
                work += flow.dissipation;
                area += work_by_hand(before, rotation, 1000);
                before = rotation;
            }
            CHECK(beam.converged);
            CHECK(before > 0.201);
            CHECK_FIGURE("moment over Mp", off, 1e-10);
            const double other = work_by_hand(0, std::abs(beam.plastic[0]), 10000);
            // the drop over 0.001 rad is within one step: 1e-3
            CHECK(work / strength[0] == Approx(area + other).epsilon(2e-3));
        }
}

TEST_CASE("backbone: a cycle within the largest rotation keeps the strength, and wear takes its part") {
    for (const double wear : {0.0, 1.5}) {
        Backbone b = example;
        b.wear = wear;
        const auto law = law_with({backbone_law(b)}, true);
        Driven beam = begun(*law);
        double work = 0, off = 0, before = 0, from = 0;
        for (const double to : {0.07, -0.07, 0.07, -0.07, 0.07}) {
            for (int i = 1; i <= 400; ++i) {
                const ReturnMapResult flow = beam.to(turned(from + (to - from) * i / 400));
                const double moment = std::abs(beam.p[1]) / strength[0];
                // trapezoids, but for the first flow of each half cycle
                if (flow.lambda[1] > 0)
                    work += 0.5 * (moment + (before > 0 ? before : moment)) * std::abs(flow.section[1][0]);
                before = flow.lambda[1] > 0 ? moment : 0;
                const double largest = beam.history[std::size_t(law->history_size()) + 3],
                             wanted = by_hand(largest) * (wear > 0 ? std::sqrt(1 - work / 1.1 / wear) : 1);
                if (flow.lambda[1] > 0) off = largest_of(off, std::abs(moment - wanted));
            }
            from = to;
        }
        CHECK(beam.converged);
        CHECK(work > 0.1);
        CHECK_FIGURE("moment over Mp", off, wear > 0 ? 1e-3 : 1e-10);  // the work of the test is of steps
    }
}

TEST_CASE("backbone: sections inside of a member keep the greatest strength") {
    const auto law = law_with({backbone_law(example)}, false);
    Driven beam = begun(*law, false);
    beam.to(turned(0.2));
    CHECK(beam.converged);
    // end 2 alone has flowed
    CHECK(beam.plastic[0] == 0);
    CHECK(beam.plastic[1] > 0.1);
    Driven other = begun(*law, false);
    other.to(-0.5 * Vec6::Unit(0));
    CHECK(-other.p[0] / strength[0] == Approx(1.2).epsilon(1e-10));
}

// The first state of equilibrium on the way down: 1e-8, as without a backbone. Steps of any size.
TEST_CASE("backbone: random paths are found, and dissipation is never negative") {
    Dice dice(91);
    RandomPaths paths;
    for (int path = 0; path < 100; ++path) {
        Backbone b;
        b.points = {{0, dice(0.8, 1.3)}};
        for (int i = 0, n = 1 + dice.pick(4); i < n; ++i) {
            // a rise as steep as the elastic member is left out: some rounds do not end there, and say so
            const Backbone::Point last = b.points.back();
            const double next = dice(0.05, 1.3);
            b.points.push_back({last.rotation + std::exp(dice(next > last.strength ? -4 : -7, -1)), next});
        }
        if (dice.pick(2)) b.wear = std::exp(dice(-1, 2));
        MaterialLaws laws = {backbone_law(b)};
        if (dice.pick(3) == 0) laws.push_back(hardening_law({E / 100, 0, 0}, fy));
        const auto law = law_with(laws, dice.pick(2));
        Driven element = begun(*law);
        paths.walk(element, dice);
    }
    paths.check(10000);
}

// The second route is the yield function with what the step has left in the history: 1 where a section flows.
TEST_CASE("backbone: the ends of a pair come to the strength of the rotation that they come to") {
    Dice dice(17);
    double off = 0, beyond = 0;
    long lost = 0, flowing = 0, steps = 0;
    for (int path = 0; path < 200; ++path) {
        Backbone of;
        of.points = {{0, 1}, {0.02, dice(1, 1.2)}, {0.06, dice(0.5, 1)}, {0.2, 0.4}};
        if (dice.pick(2)) of.wear = dice(0.5, 4);
        MaterialLaws laws = {backbone_law(of)};
        if (dice.pick(3) == 0) laws.push_back(hardening_law({E / 100, dice.pick(2) * 0.2 * fy, 0}, fy));
        const auto law = law_with(laws, dice.pick(2));
        DrivenPair pair(*law);
        Vec6 way[2];
        for (Vec6& one : way)
            one = (Vec6() << dice.vector(0.003), dice(-0.003, 0.003), dice(-1e-4, 1e-4), dice(-1e-3, 1e-3)).finished();
        for (int step = 0; step < 40; ++step) {
            if (step % 13 == 12)
                for (Vec6& one : way) one *= -1;
            ReturnMapResult flow[2];
            ++steps;
            if (!pair.move(way, 0, flow)) {
                ++lost;
                break;
            }
            for (int i : {0, 1})
                for (int s : {0, 1}) {
                    const double f = law->yield_function(resultants(flow[i].p, ends[s]), pair.section(i, s)) - 1;
                    beyond = largest_of(beyond, f);
                    if (flow[i].lambda[s] > 0) off = largest_of(off, std::abs(f)), ++flowing;
                }
        }
    }
    CHECK(flowing > 5000);
    CHECK(lost < 0.002 * steps);
    CHECK_FIGURE("f - 1 where a section flows", off, 1e-7);
    CHECK_FIGURE("f - 1 anywhere", beyond, 1e-7);
}

// 1e-6 of the elastic stiffness, in bending about one axis: beside other resultants the tangent leaves out a part that
// is not symmetric.
TEST_CASE("backbone: the tangent against differences") {
    const auto law = law_with({backbone_law(example)}, true);
    double off = 0;
    for (const double to : {0.02, 0.06, 0.1, 0.15}) {
        Driven beam = begun(*law);
        beam.to(turned(0.8 * to));
        const ReturnMapResult flow = beam.returned(turned(to));
        REQUIRE(flow.flows());
        const Mat6 D = beam.tangent(flow);
        const double h = 1e-7;
        const Vec6 difference = (beam.returned(turned(to + h)).p - beam.returned(turned(to - h)).p) / (2 * h);
        for (int i : {0, 1}) off = largest_of(off, std::abs(D(i, 1) - difference[i]) / beam.k.x22);
    }
    CHECK_FIGURE("tangent", off, 1e-6);
}

TEST_CASE("backbone: what is not one is refused") {
    for (const Backbone& wrong :
         {Backbone{{}, 0}, Backbone{{{0.1, 1}}, 0}, Backbone{{{0, 1}, {0.1, 1}, {0.1, 0.5}}, 0},
          Backbone{{{0, 1}, {0.1, 0}}, 0}, Backbone{{{0, 1}}, -1}, Backbone{{{0, 1}, {0.1, std::nan("")}}, 0}})
        CHECK_THROWS_AS(backbone_law(wrong), InputError);
}

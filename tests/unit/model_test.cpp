// What a model declares, and what is computed from it before anything moves: start velocities, and which of several
// contact rules two members meet by.
#include "helpers.h"

using namespace hinge;
using namespace hinge::test;

TEST_CASE("model: nodes inside a member whose both ends were given a velocity start in proportion to these") {
    Frame frame;
    frame.elements = 4;
    const Vec3 from(1, 2, 3), to(3, 1, 2);
    const int a = frame.node(from), b = frame.node(to), c = frame.node(0, 0, 9);
    frame.member(a, b);
    frame.member(c, a);  // its own inner nodes come behind those of the first
    const Vec3 va(1, -2, 3), wa(4, 5, -6), vb(-9, 8, 7), wb(6, -5, 2);
    frame.model->set_velocity(a, va, wa);
    frame.model->set_velocity(b, vb, wb);
    const auto structure = frame.build();
    const std::vector<Vec6> v = structure->initial_velocity();
    REQUIRE(v.size() == 9);
    REQUIRE(initial_state(*structure).velocity == v);
    for (int i = 0; i < 3; ++i) {
        const double t = 0.25 * (i + 1);
        CHECK((structure->position()[3 + i] - (from + t * (to - from))).norm() < 1e-14);
        CHECK((v[3 + i].head<3>() - (va + t * (vb - va))).norm() < 1e-14);
        CHECK((v[3 + i].tail<3>() - (wa + t * (wb - wa))).norm() < 1e-14);
        CHECK(v[6 + i].isZero(0));  // the third node was given none
    }
}

TEST_CASE("model: a bar that starts to rotate about one of its ends has the momenta and the energy of a rigid one") {
    Frame frame;
    const double length = 2, w = 5;
    const int a = frame.node(0, 0, 0), b = frame.node(length, 0, 0);
    frame.elements = 6;
    frame.member(a, b);
    const Vec3 spin(0, 0, w);
    frame.model->set_velocity(a, Vec3::Zero(), spin);
    frame.model->set_velocity(b, spin.cross(Vec3(length, 0, 0)), spin);
    const auto structure = frame.build();
    const State state = initial_state(*structure);
    const Momentum now = momentum(*structure, state);
    const double m = 7850 * 0.05 * 0.05 * length, own = 7850 * std::pow(0.05, 4) / 12 * length;
    const double about_end = m * length * length / 3 + own;
    CHECK_FIGURE("mass", off(now.mass, m), 1e-12);
    CHECK_FIGURE("momentum", (now.linear - Vec3(0, 0.5 * m * w * length, 0)).norm() / (0.5 * m * w * length), 1e-12);
    CHECK_FIGURE("angular momentum", (now.angular - about_end * spin).norm() / (about_end * w), 1e-12);
    CHECK_FIGURE("kinetic energy", off(kinetic_energy(*structure, state), 0.5 * about_end * w * w), 1e-12);
}

namespace {

/// A bar that comes down on another, aslant, by rules over both (groups 0: the lower, 1: the upper).
std::uint64_t after_impact(const std::vector<ContactRule>& rules, long* bound = nullptr) {
    Frame frame;
    for (const char* name : {"lower", "upper"}) frame.model->group(name);
    frame.groups = {0};
    frame.member(frame.node(-0.5, 0, 0), frame.node(0.5, 0, 0));
    frame.groups = {1};
    const int c = frame.node(0.1, -0.5, 0.055), d = frame.node(0.1, 0.5, 0.055);
    frame.member(c, d);
    for (const int n : {c, d}) frame.model->set_velocity(n, {5, 3, -20}, Vec3::Zero());
    for (const ContactRule& rule : rules) add_contact(*frame.model, rule);
    Dynamics run = dynamics(frame.build(), {.dt = 1e-5, .duration = 2e-3});
    complete(run);
    if (bound) *bound = contact_of(run.state())->counts().bound;
    return hash(run.state());
}

}  // namespace

TEST_CASE("model: of contact rules that overlap the last one of the members' groups counts, else the last of all") {
    Frame frame;
    for (const char* name : {"a", "b", "c"}) frame.model->group(name);
    const auto member_in = [&](std::vector<int> groups) {
        frame.groups = std::move(groups);
        return frame.member(frame.node(0, 0, 0), frame.node(1, 0, 0));
    };
    const int in_a = member_in({0}), in_b = member_in({1}), in_ab = member_in({0, 1}), in_c = member_in({2}),
              in_none = member_in({});
    const auto add = [&](std::vector<int> groups, bool between) {
        add_contact(*frame.model, {.groups = std::move(groups), .between = between});
    };
    const auto both_ways = [&](int m, int n) {
        const auto& rules = contact_rules(*frame.model);
        const MemberData &one = frame.model->members()[m], &other = frame.model->members()[n];
        CHECK(contact_rule(rules, one, other) == contact_rule(rules, other, one));
        return contact_rule(rules, one, other);
    };
    add({0, 1}, false);  // 0: within a and b
    CHECK(both_ways(in_a, in_a) == 0);
    CHECK(both_ways(in_a, in_b) == 0);
    CHECK(both_ways(in_a, in_c) == -1);
    CHECK_FALSE(can_collide(contact_rules(*frame.model), frame.model->members()[in_c]));
    add({1}, false);  // 1: within b, part of the one before
    CHECK(both_ways(in_b, in_ab) == 1);
    CHECK(both_ways(in_a, in_b) == 0);
    add({0, 2}, true);  // 2: between a and c
    CHECK(both_ways(in_a, in_c) == 2);
    CHECK(both_ways(in_ab, in_c) == 2);
    CHECK(both_ways(in_a, in_ab) == 0);
    CHECK(both_ways(in_b, in_b) == 1);
    CHECK(both_ways(in_b, in_c) == -1);
    CHECK(can_collide(contact_rules(*frame.model), frame.model->members()[in_c]));
    CHECK_FALSE(can_collide(contact_rules(*frame.model), frame.model->members()[in_none]));
    const int members[] = {in_a, in_b, in_ab, in_c, in_none};
    std::vector<int> of_groups;
    for (const int m : members)
        for (const int n : members) of_groups.push_back(both_ways(m, n));
    for (const int all : {3, 4}) {  // the later one, for all pairs without a rule of their groups
        add({}, false);
        std::size_t pair = 0;
        for (const int m : members)
            for (const int n : members) {
                CHECK(both_ways(m, n) == (of_groups[pair] < 0 ? all : of_groups[pair]));
                ++pair;
            }
    }
}

TEST_CASE("model: of two contact rules the one that counts gives the bits that it gives alone") {
    const ContactRule smooth = surface(0), rough = surface(0.5);
    ContactRule between = rough;
    between.groups = {0, 1}, between.between = true;
    long bound = 0;
    const std::uint64_t by_smooth = after_impact({smooth}, &bound), by_rough = after_impact({rough});
    REQUIRE(bound > 0);
    REQUIRE(by_smooth != by_rough);
    CHECK(after_impact({smooth, rough}) == by_rough);
    CHECK(after_impact({rough, smooth}) == by_smooth);
    CHECK(after_impact({smooth, between}) == by_rough);
    CHECK(after_impact({between, smooth}) == by_rough);
    between.groups = {0, 0};  // declared last, but not for these two
    CHECK(after_impact({smooth, between}) == by_smooth);
}

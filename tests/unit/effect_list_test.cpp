// The lists of effects that the stages of a run walk: who is in which role, in the order of effects/list.inc.
#include "effects/effect_list.h"

#include <set>

#include "effects/all_effects.h"

#include "effect_bench.h"

using namespace hinge;
using namespace hinge::test;

namespace {

using Names = std::vector<std::string>;

template <class Role>
Names names(const RoleList<Role>& list) {
    Names of;
    for (const auto& each : list) of.push_back(each.effect->name());
    return of;
}

/// A steel column with weight and a load at its head.
Frame column() {
    Frame frame;
    frame.material = steel(235e6);
    const int top = frame.node(0, 0, 3);
    frame.member(frame.foot(0, 0, 0), top);
    set_gravity(*frame.model, {0, 0, -9.80665});
    frame.load(top, {1, 0, 0});
    return frame;
}

/// The effects of it; `breaks`: with rules of fracture and contact.
template <class Check>
void with_effects(bool dynamic, bool breaks, Check check) {
    const Frame frame = column();
    if (breaks) add_fracture(*frame.model, {}), add_contact(*frame.model, {});
    Bench bench(frame.build(), {.dynamic = dynamic, .dt = 1e-3});
    check(EffectList(bench.w, bench.run));
}

}  // namespace

TEST_CASE("each role lists its effects in the order in which they act", "[effects]") {
    with_effects(true, true, [](const EffectList& list) {
        CHECK(names(list.loads) == Names{"loads", "gravity", "broken members"});
        CHECK(names(list.forces) == Names{"contact"});
        CHECK(names(list.section_forces) == Names{"gravity", "bow"});
        CHECK(names(list.breakers) == Names{"fracture", "contact"});
        CHECK(names(list.break_listeners) == Names{"gravity", "fracture", "broken members", "contact"});
        CHECK(names(list.sleepers) == Names{"plasticity", "contact"});
        CHECK(list.any(&EffectTraits::forces_vanish));
        CHECK(!list.any(&EffectTraits::calls_script));
        CHECK(any_of(list.section_forces, &SectionForceSource::has_fixed_ends));
        CHECK(!any_of(list.forces, &Force::has_blocks));
    });
}

TEST_CASE("what a run does not call for is in none of its lists", "[effects]") {
    with_effects(false, false, [](const EffectList& list) {
        CHECK(names(list.loads) == Names{"loads", "gravity"});
        CHECK(list.forces.empty());
        CHECK(list.breakers.empty());
        CHECK(list.contact_laws.empty());
        CHECK(list.rest_keepers.empty());
        CHECK(!list.any(&EffectTraits::forces_vanish));
    });
}

TEST_CASE("an effect that is left out takes itself out of a model", "[effects]") {
    const Frame frame = column();
    add_fracture(*frame.model, {{.axial_strain = 0.1}});
    add_contact(*frame.model, surface(0.3));
    const auto active = [&](const std::string& without) {
        auto copy = std::make_shared<Model>(*frame.model);
        leave_out(without, *copy);
        std::set<std::string> names;
        for (const PlanLine& line : plan_of(Structure(copy), {.dynamic = true}))
            if (line.active) names.insert(line.name);
        return names;
    };
    const std::set<std::string> all = active("no effect of this name");
    const std::vector<std::string> optional = optional_effects();
    for (const char* name : {"gravity", "large displacement", "plasticity", "fracture", "contact", "friction"}) {
        INFO(name);
        CHECK(std::count(optional.begin(), optional.end(), name) == 1);
        CHECK(all.count(name) == 1);
        std::set<std::string> wanted = all;
        wanted.erase(name);
        if (std::string(name) == "large displacement") wanted.erase("geometric stiffness");  // a part of it
        if (std::string(name) == "contact") wanted.erase("friction");
        CHECK(active(name) == wanted);
    }
    CHECK(std::count(optional.begin(), optional.end(), "inertia") == 0);
}

TEST_CASE("statics has no effect that acts in dynamics only, and its plan says why", "[effects]") {
    with_effects(false, true, [](const EffectList& list) {
        CHECK(names(list.loads) == Names{"loads", "gravity"});
        CHECK(list.forces.empty());
        CHECK(list.breakers.empty());
    });
    const Frame frame = column();
    add_contact(*frame.model, {});
    for (const bool dynamic : {false, true}) {
        const std::vector<PlanLine> plan = plan_of(Structure(frame.model), {.dynamic = dynamic});
        const auto line = std::find_if(plan.begin(), plan.end(), [](const auto& l) { return l.name == "contact"; });
        REQUIRE(line != plan.end());
        CHECK(line->active == dynamic);
        CHECK(line->because == (dynamic ? "model:contact" : "declared by model:contact, but acts in dynamics only"));
    }
}

// The lists of effects that the stages of a run walk: who is in which role, in the order of effects/list.inc.
#include "effects/effect_list.h"

#include "helpers.h"

using namespace hinge;
using namespace hinge::test;

namespace {

/// A run that nothing is asked of.
class NoRun : public Host {
public:
    void stiffness_changed(int) override {}
    void blocks_changed(const ConfigurationView&) override {}
    void set_offset_mass(int, const Mat6&) override {}
    void leave_out(const std::vector<int>&) override {}
    void accelerations_anew() override {}
    void mass_changed(int) override {}
    ImpulseResponse respond(const std::vector<Vec6>&) override { return {}; }
    void change_steady_load(int, const Vec3&) override {}
    void reached(const std::vector<Reached>&) override {}
    void note_activation(const std::string&, bool, const std::string&) override {}
    void keep_from_rest(const Bodies&, std::vector<char>&) override {}
    void count_break() override {}
    bool has_effective_stiffness() const override { return true; }
};

using Names = std::vector<std::string>;

template <class Role>
Names names(const RoleList<Role>& list) {
    Names of;
    for (const auto& each : list) of.push_back(each.effect->name());
    return of;
}

/// The effects of a steel column with weight and a load; `breaks`: with rules of fracture and contact.
template <class Check>
void with_effects(bool dynamic, bool breaks, Check check) {
    Frame frame;
    frame.material = steel(235e6);
    const int foot = frame.foot(0, 0, 0, 63), top = frame.foot(0, 0, 3, 0);
    frame.member(foot, top);
    frame.model->set_gravity({0, 0, -9.80665});
    NodalLoad load;
    load.node = top, load.force = {1, 0, 0};
    frame.model->add_load(load);
    if (breaks) frame.model->add_fracture({}), frame.model->add_contact({});
    const auto structure = frame.build();
    State state = initial_state(*structure);
    ThreadPool pool;
    ElementAssembly assembly(*structure, pool, true);
    std::unordered_map<int, Vec6> reaction;
    RunKind kind;
    kind.dynamic = dynamic, kind.dt = 1e-3;
    Workspace w{*structure, state, pool,     assembly, kind, {}, configuration_of(state), 1, {}, {}, {}, state.force,
                {},         {},    reaction, {},       {},   {}};
    NoRun run;
    check(EffectList(w, run));
}

}  // namespace

TEST_CASE("each role lists its effects in the order in which they act", "[effects]") {
    with_effects(true, true, [](const EffectList& list) {
        CHECK(names(list.loads) == Names{"loads", "gravity", "broken members"});
        CHECK(names(list.forces) == Names{"contact"});
        CHECK(names(list.section_forces) == Names{"gravity"});
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

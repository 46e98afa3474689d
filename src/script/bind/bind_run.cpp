// A run as an object of a script: its steps and methods.
#include "effects/contact.h"
#include <algorithm>
#include <cstring>

#include "core/text.h"
#include "record/chain.h"
#include "advice/check.h"
#include "record/element_events.h"
#include "script/bind/run_fields.h"
#include "advice/plan.h"
#include "record/summary.h"
#include "record/told_warnings.h"
#include "script/lua/probe_list.h"
#include "record/recording.h"
#include "record/snapshot.h"
#include "run/dynamics.h"
#include "state/group_momentum.h"
#include "run/statics.h"
#include "script/bind/modules.h"
#include "script/bind/run_box.h"
#include "script/bind/snapshot_box.h"
#include "script/bind/bind_checkpoint.h"
#include "script/lua/interrupts.h"

namespace hinge::script {

std::shared_ptr<ScriptRun> last_run(const ScriptContext& c) {
    return std::static_pointer_cast<ScriptRun>(c.runs.last);  // a script makes no others
}

int make_run(lua_State* L, std::shared_ptr<Run> run, std::shared_ptr<ScriptModel> model, int every,
             std::vector<Warning> likely_mistakes) {
    if (!model->closed_at.empty())
        throw InputError("the model was closed at " + model->closed_at + " while a run of it was being made");
    model->take_elements(run->structure().model());
    auto record = std::make_shared<ScriptRun>();
    record->run = std::move(run);
    record->model = std::move(model);
    record->every = every;
    record->likely_mistakes = std::move(likely_mistakes);
    const auto c = context(L);
    const auto last = last_run(*c);
    record_run(*c, record);
    if (last && !last->model->closed_at.empty()) {  // it was kept for the summary alone
        if (last->run) write_happenings(*last);
        last->run.reset();
    }
    record->asked_at = where(L);
    if (c->mode.planning)
        if (const std::string plan = c->mode.checking ? checked_run(*record) : plan_of(*record, effects_of(*record));
            c->messages.described.insert(plan).second) {
            std::printf("%s", plan.c_str());
            if (!c->mode.checking) {
                std::printf("\n");
            } else {
                const std::string summary = checked_model(*record);
                const auto [known, fresh] = c->messages.described_at.try_emplace(summary, record->asked_at);
                if (fresh) std::printf("%s\n", summary.c_str());
                else
                    std::printf("  the same model as that of the run made at %s, with the same warnings\n\n",
                                known->second.c_str());
            }
        }
    look_over(*c, *record);
    push<RunBox>(L, record);
    hold_registry(L, *record->model);
    push_registry(L, *record->model);
    lua_pushvalue(L, -2);
    lua_setfield(L, -2, "latest");
    lua_pop(L, 1);
    std::erase_if(record->model->runs, [](const auto& r) { return r.expired(); });
    record->model->runs.push_back(record);
    tell_collector(L, 2000 * record->run->structure().elements().size());
    tell_of_run(L);
    return 1;
}

namespace {

/// What a script does between the steps of its run.
class ScriptHooks : public StepHooks {
public:
    ScriptHooks(lua_State* L, std::shared_ptr<ScriptRun> record) : L_(L), record_(std::move(record)) {}

    void before_step(RunRecord& r) override {
        run_is_under_way(true);
        mind_interrupts(L_, *context(L_), r);
    }
    void after_step(RunRecord& r) override {
        for (const LuaFunction& f : std::vector<LuaFunction>(record_->on_step)) {  // one may add another
            f.push(L_);
            push<RunBox>(L_, record_);
            hold_registry(L_, *record_->model);
            call_hook(L_, f, 1, 0, [&] {
                return "run:on_step after step " + std::to_string(r.run->steps_done()) + ", which is done";
            });
        }
    }

private:
    lua_State* L_;
    std::shared_ptr<ScriptRun> record_;
};

/// While it lasts the run's own functions may not change its model.
class LockedModel {
public:
    explicit LockedModel(ScriptModel& model) : model_(model) { model_.lock(true); }
    ~LockedModel() { model_.lock(false); }

private:
    ScriptModel& model_;
};

}  // namespace

bool advance(lua_State* L, const std::shared_ptr<ScriptRun>& record) {
    const auto c = context(L);
    c->running = L;
    ScriptHooks hooks(L, record);
    std::optional<LockedModel> lock;
    if (!record->stepping) lock.emplace(*record->model);
    const bool more = hinge::record_step(c, record, hooks);
    if (record->closed) run_is_under_way(false);
    return more;
}

namespace {

// ---- methods ------------------------------------------------------------------------------------------------------

int next_step(lua_State* L) {
    if (!find<RunBox>(L, lua_upvalueindex(1))) throw InputError("run:steps: the run was collected");
    const auto record = run_argument(L, lua_upvalueindex(1), "run:steps: the run");
    const auto& r = *record;
    if (!advance(L, record)) return lua_pushnil(L), 1;
    lua_pushvalue(L, lua_upvalueindex(2));
    lua_pushinteger(L, r.run->steps_done());
    lua_setfield(L, -2, "index");
    lua_pushnumber(L, r.run->state().time);
    lua_setfield(L, -2, "time");
    lua_pushnumber(L, r.run->state().factor);
    lua_setfield(L, -2, "factor");
    return 1;
}

int steps(lua_State* L) {
    self<RunBox>(L, "run:steps");
    lua_pushvalue(L, 1);
    lua_createtable(L, 0, 3);  // one table, filled anew at each step
    lua_pushcclosure(L, guarded<next_step>, 2);
    return 1;
}

int step(lua_State* L) {
    const auto r = self<RunBox>(L, "run:step").value;
    return lua_pushboolean(L, advance(L, r)), 1;
}

int finish(lua_State* L) {
    const auto r = self<RunBox>(L, "run:finish").value;
    while (advance(L, r)) {}
    lua_settop(L, 1);
    return 1;
}

int on_step(lua_State* L) {
    const auto r = self<RunBox>(L, "run:on_step").value;
    if (!lua_isfunction(L, 2))
        throw InputError("run:on_step: takes a function of the run, called after each step; got " + show(L, 2));
    if (r->closed || r->run->verdict() != Verdict::running)
        throw InputError("run:on_step: the run is over (" + std::string(name(r->run->verdict())) +
                         "), so no step follows that would call it");
    r->on_step.emplace_back(L, 2, *r->model);
    lua_settop(L, 1);
    return 1;
}

int stop(lua_State* L) {
    const auto r = self<RunBox>(L, "run:stop").value;
    r->run->stop();
    tell_findings(*context(L), *r);
    return 0;
}

/// The quantity of a probe by its name, and where that is a drift its height.
void read_quantity(Options& o, const ScriptRun& r, Probe& p) {
    lua_State* L = o.L();
    o.push_item(1);
    const std::string what = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
    const bool drift = what == "drift_x" || what == "drift_y";
    std::vector<std::string> names = node_quantities();
    const auto at = std::find(names.begin(), names.end(), drift ? "u" + what.substr(6) : what);
    const int index = int(at - names.begin());
    if (at == names.end()) {
        names.insert(names.end(), {"drift_x", "drift_y"});
        throw InputError("run:probe: quantity is " + show(L, -1) +
                         "; must be one of ux uy uz rx ry rz (displacement), vx .. vrz (velocity), ax .. arz "
                         "(acceleration), fx fy fz mx my mz (reaction), drift_x drift_y" +
                         did_you_mean(what, names));
    }
    lua_pop(L, 1);
    p.quantity = Probe::Quantity(index / 6);
    p.component = index % 6;
    const bool relative = o.push_field("relative_to") != LUA_TNIL;
    if (relative) p.relative_to = node_of_run(L, -1, r, "run:probe: field 'relative_to'");
    lua_pop(L, 1);
    if (relative && p.quantity == Probe::Quantity::reaction)
        o.complain("relative_to", "given beside '" + what + "'", "a reaction is of one node; leave one of the two out");
    if (relative && p.relative_to == p.node)
        o.complain("relative_to", "the same node", "must be another one than 'node'");
    if (drift && !relative)
        throw InputError("run:probe: field 'relative_to' is missing; '" + what + "' takes a node of the floor below");
    if (const auto height = o.maybe_number("height", "m", Range::positive)) {
        if (!drift) o.complain("height", show(*height) + " m", "belongs to drift_x and drift_y");
        p.height = *height;
    } else if (drift) {
        const auto& nodes = r.run->structure().position();
        p.height = std::abs(nodes[std::size_t(p.node)].z() - nodes[std::size_t(p.relative_to)].z());
        if (!(p.height > 0))
            throw InputError("run:probe: both nodes are " + number_text(nodes[std::size_t(p.node)].z()) +
                             " m high, so '" + what + "' has no height to divide by; give height = m");
    }
    if (const auto name = o.text("name")) {
        p.name = *name;
        return;
    }
    p.name = "node" + std::to_string(p.node + 1) + "_" + what;
    if (relative) p.name += "_to_node" + std::to_string(p.relative_to + 1);
}

int probe(lua_State* L) {
    const auto r = self<RunBox>(L, "run:probe").value;
    Options o(L, 2, "run:probe");
    auto p = std::make_shared<Probe>();
    o.push_field("node");
    p->node = node_of_run(L, -1, *r, "run:probe: field 'node'");
    lua_pop(L, 1);
    read_quantity(o, *r, *p);
    if (p->quantity == Probe::Quantity::reaction) must_be_fixed_in(*r, p->node, "run:probe: field 'node'");
    o.finish(1);
    if (p->name.find_first_of(",\n\"") != std::string::npos)
        o.complain("name", "'" + p->name + "'",
                   "it heads a column of history.csv and may not hold a comma, quote or line break");
    if (r->started)
        throw InputError("run:probe: the run has begun (step " + std::to_string(r->run->steps_done()) +
                         "); ask for probes before its first step");
    std::vector<std::string> columns = {"time", "factor", "energy_error"};
    for (const AccountInfo& account : r->run->accounts()) columns.emplace_back(account.name);
    for (const auto& other : r->probes) columns.push_back(other->name);
    if (std::find(columns.begin(), columns.end(), p->name) != columns.end())
        o.complain("name", "'" + p->name + "'",
                   "there is a column of history.csv with that name already; give the probe another one");
    p->time.push_back(abscissa(*r->run));
    p->value.push_back(value_of(*r->run, *p));
    r->probes.push_back(p);
    push<ProbeBox>(L, p);
    return 1;
}

int count(lua_State* L) {
    const auto& r = *self<RunBox>(L, "run:count").value;
    Options o(L, 2, "run:count");
    int group = -1;
    if (o.push_field("group") != LUA_TNIL)
        group = group_argument(L, -1, "run:count: field 'group'", *r.model, &r.run->structure().model());
    lua_pop(L, 1);
    const std::string state = o.word("state", {"broken", "yielded", "elastic", "touched"}, "");
    if (state.empty())
        throw InputError(
            "run:count: field 'state' is missing; must be one of 'broken', 'yielded', 'elastic', 'touched'");
    o.finish();
    const Run::Counts c = r.run->count_members(group);
    lua_pushinteger(L, state == "broken"    ? c.broken
                       : state == "yielded" ? c.yielded
                       : state == "elastic" ? c.elastic
                                            : c.touched);
    return 1;
}

int run_momentum(lua_State* L) {
    const auto& r = *self<RunBox>(L, "run:momentum").value;
    const int group =
        lua_isnoneornil(L, 2) ? -1 : group_argument(L, 2, "run:momentum: group", *r.model, &r.run->structure().model());
    const GroupMomentum m = momentum_of_group(r.run->structure(), r.run->state(), group);
    lua_createtable(L, 0, 4);
    lua_pushnumber(L, m.kinetic), lua_setfield(L, -2, "kinetic");
    lua_pushnumber(L, m.mass), lua_setfield(L, -2, "mass");
    push_array(L, m.linear.data(), 3), lua_setfield(L, -2, "linear");
    push_array(L, m.angular.data(), 3), lua_setfield(L, -2, "angular");
    return 1;
}

int run_snapshot(lua_State* L) {
    const auto& record = self<RunBox>(L, "run:snapshot").value;
    const auto& run = record->run;
    push<SnapshotBox>(L, make_snapshot(*run), run->share_structure(), record->model);
    tell_collector(L, 200 * run->structure().elements().size());
    return 1;
}

int text(lua_State* L) {
    const auto& box = self_or_gone<RunBox>(L, "tostring");
    if (const std::string since = gone(box); !since.empty())
        return lua_pushstring(L, (name_of(box) + since).c_str()), 1;
    const Run& run = *box.value->run;
    char t[160];
    std::snprintf(t, sizeof t, "%s run: %s at step %ld of %ld, t = %.6g s", run.kind(), name(verdict_of(*box.value)),
                  run.steps_done(), run.planned_steps(), run.state().time);
    return lua_pushstring(L, t), 1;
}

int probe_fields(lua_State* L) {
    const std::string key = key_argument(L);
    const Probe& p = *self<ProbeBox>(L, "probe." + key).value;
    if (key == "time" || key == "value") return push_probe_list(L, key == "time");
    if (key == "name") lua_pushstring(L, p.name.c_str());
    else if (key == "unit") lua_pushstring(L, unit_of(p));
    else if (key == "last") lua_pushnumber(L, p.value.back());
    else if (key == "max") lua_pushnumber(L, *std::max_element(p.value.begin(), p.value.end()));
    else if (key == "min") lua_pushnumber(L, *std::min_element(p.value.begin(), p.value.end()));
    else refuse_field(L, "probe", key);
    return 1;
}

int probe_text(lua_State* L) {
    const Probe& p = *self<ProbeBox>(L, "tostring").value;
    return lua_pushstring(L, ("probe " + p.name + ": " + count_text(long(p.value.size()), "value") + ", the last " +
                              show(p.value.back()))
                                 .c_str()),
           1;
}

}  // namespace

void open_run(lua_State* L) {
    static const luaL_Reg none[] = {{nullptr, nullptr}};
    static const luaL_Reg methods[] = {{"steps", guarded<takes<"run:steps", 1, steps>>},
                                       {"step", guarded<takes<"run:step", 1, step>>},
                                       {"finish", guarded<takes<"run:finish", 1, finish>>},
                                       {"stop", guarded<takes<"run:stop", 1, stop>>},
                                       {"probe", guarded<takes<"run:probe", 2, probe>>},
                                       {"on_step", guarded<takes<"run:on_step", 2, on_step>>},
                                       {"count", guarded<takes<"run:count", 2, count>>},
                                       {"momentum", guarded<takes<"run:momentum", 2, run_momentum>>},
                                       {"snapshot", guarded<takes<"run:snapshot", 1, run_snapshot>>},
                                       {nullptr, nullptr}};
    make_metatable(L, RunBox::lua_name, methods, guarded<run_fields>, collect<RunBox>, guarded<text>, nullptr);
    make_metatable(L, ProbeBox::lua_name, none, guarded<probe_fields>, collect<ProbeBox>, guarded<probe_text>, nullptr);
    name_run_fields(L);
    name_fields(L, ProbeBox::lua_name, {"time", "value", "last", "max", "min", "name", "unit"});
    make_metatable(L, SnapshotBox::lua_name, none, nullptr, collect<SnapshotBox>, nullptr, nullptr);
}

}  // namespace hinge::script

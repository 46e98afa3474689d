// A run in a script's hands: its steps, and what can be read of it.
#include <algorithm>
#include <cstring>

#include "script/plan.h"
#include "script/recording.h"
#include "script/still.h"

namespace hinge::script {

int make_run(lua_State* L, std::shared_ptr<Run> run, std::shared_ptr<Model> model, int every) {
    auto record = std::make_shared<RunRecord>();
    record->run = std::move(run);
    record->model = std::move(model);
    record->every = every;
    const auto c = context(L);
    c->record = record;
    ++c->runs;
    record->asked_at = where(L);
    if (c->planning)
        if (const std::string plan = plan_of(*record); c->described.find(plan) == std::string::npos) {
            c->described += plan;
            std::printf("%s\n", plan.c_str());
        }
    push<RunBox>(L, record);
    hold_anchor(L, *record->model);
    tell_collector(L, 2000 * record->run->structure().elements().size());
    return 1;
}

namespace {

// ---- methods ------------------------------------------------------------------------------------------------------

int next_step(lua_State* L) {
    const auto* box = find<RunBox>(L, lua_upvalueindex(1));
    if (!box) throw InputError("run:steps: the run was collected");
    const auto record = box->value;
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

int stop(lua_State* L) {
    self<RunBox>(L, "run:stop").value->run->stop();
    return 0;
}

int node_of(lua_State* L, int index, const RunRecord& r, const char* what) {
    const int n = node_argument(L, index, what, r.model.get()).index;
    if (n >= int(r.run->structure().model().nodes().size()))
        throw InputError(std::string(what) + " is node " + std::to_string(n + 1) + ", declared after this run was made");
    return n;
}

template <class Read>
int six(lua_State* L, const char* what, Read read) {
    const auto& r = *self<RunBox>(L, what).value;
    const Vec6 v = read(*r.run, node_of(L, 2, r, what));
    for (int i = 0; i < 6; ++i) lua_pushnumber(L, v[i]);
    return 6;
}
int displacement(lua_State* L) { return six(L, "run:displacement: node", [](const Run& r, int n) { return r.displacement(n); }); }
int velocity(lua_State* L) { return six(L, "run:velocity: node", [](const Run& r, int n) { return r.state().velocity[n]; }); }
int acceleration(lua_State* L) { return six(L, "run:acceleration: node", [](const Run& r, int n) { return r.state().acceleration[n]; }); }
int reaction(lua_State* L) { return six(L, "run:reaction: node", [](const Run& r, int n) { return r.reaction(n); }); }

int position(lua_State* L) {
    const auto& r = *self<RunBox>(L, "run:position").value;
    const int n = node_of(L, 2, r, "run:position: node");
    const Vec3 x = r.run->structure().position()[n] + r.run->state().displacement[n];
    for (int i = 0; i < 3; ++i) lua_pushnumber(L, x[i]);
    return 3;
}

int probe(lua_State* L) {
    const auto r = self<RunBox>(L, "run:probe").value;
    Options o(L, 2, "run:probe");
    auto p = std::make_shared<Probe>();
    o.push_field("node");
    p->node = node_of(L, -1, *r, "run:probe: field 'node'");
    o.push_item(1);
    const std::string what = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
    std::vector<std::string> names;
    for (const char* stem : {"u", "v", "a", "f"})
        for (int c = 0; c < 6; ++c) names.push_back((c < 3 ? std::string(stem) : std::string(*stem == 'u' ? "r" : *stem == 'f' ? "m" : std::string(stem) + "r")) + "xyz"[c % 3]);
    const auto at = std::find(names.begin(), names.end(), what);
    if (at == names.end())
        throw InputError("run:probe: quantity is " + show(L, -1) + "; must be one of ux uy uz rx ry rz (displacement), vx .. vrz (velocity), ax .. arz (acceleration), fx fy fz mx my mz (reaction)" + did_you_mean(what, names));
    lua_pop(L, 2);
    const int index = int(at - names.begin());
    p->quantity = Probe::Quantity(index / 6);
    p->component = index % 6;
    p->name = o.text("name").value_or("node" + std::to_string(p->node + 1) + "_" + what);
    o.finish(1);
    if (p->name.find_first_of(",\n\"") != std::string::npos) o.complain("name", "'" + p->name + "'", "it heads a column of history.csv and may not hold a comma, quote or line break");
    if (r->started) throw InputError("run:probe: the run has begun (step " + std::to_string(r->run->steps_done()) + "); ask for probes before its first step");
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
    if (o.push_field("group") != LUA_TNIL) group = group_argument(L, -1, "run:count: field 'group'", *r.model);
    lua_pop(L, 1);
    const std::string state = o.word("state", {"broken", "yielded", "elastic", "touched"}, "");
    if (state.empty()) throw InputError("run:count: field 'state' is missing; must be one of 'broken', 'yielded', 'elastic', 'touched'");
    o.finish();
    const Run::Counts c = r.run->count_members(group);
    lua_pushinteger(L, state == "broken" ? c.broken : state == "yielded" ? c.yielded : state == "elastic" ? c.elastic : c.touched);
    return 1;
}

/// Elements of the member that an argument names: first and one past the last.
std::pair<int, int> elements_of(lua_State* L, int index, const RunRecord& r, const char* what) {
    auto* m = find<MemberBox>(L, index);
    if (!m) throw InputError(std::string(what) + ": member is " + show(L, index) + "; must be one made by model:member");
    if (m->model != r.model) throw InputError(std::string(what) + ": the member belongs to another model");
    if (m->index >= int(r.run->structure().model().members().size()))
        throw InputError(std::string(what) + ": member " + std::to_string(m->index + 1) + " was declared after this run was made");
    const auto& elements = r.run->structure().elements();
    int first = 0;
    while (first < int(elements.size()) && elements[first].member != m->index) ++first;
    int end = first;
    while (end < int(elements.size()) && elements[end].member == m->index) ++end;
    return {first, end};
}

/// Section resultants at both ends of the member, as tables with N, Mx, My, Mz, Qx, Qy and f_y.
int forces(lua_State* L) {
    const auto& r = *self<RunBox>(L, "run:forces").value;
    const auto [first, end] = elements_of(L, 2, r, "run:forces");
    for (const auto& [index, side] : {std::pair{first, -1.0}, std::pair{end - 1, 1.0}}) {
        const Element& e = r.run->structure().elements()[index];
        const Vec6& p = r.run->state().force[index];
        const std::pair<const char*, double> values[] = {
            {"N", p[4]}, {"Mx", beam::moment_at(p[0], p[1], side)}, {"My", beam::moment_at(p[2], p[3], side)}, {"Mz", p[5]},
            {"Qy", (p[0] + p[1]) / e.length}, {"Qx", -(p[2] + p[3]) / e.length}, {"f_y", r.run->state().broken[index] ? 0.0 : beam::yield_function(p, side, e.yield)}};
        lua_createtable(L, 0, 7);
        for (const auto& [name, v] : values) lua_pushnumber(L, v), lua_setfield(L, -2, name);
    }
    return 2;
}

/// "elastic", "yielded" or "broken", and f_y now.
int member_state(lua_State* L) {
    const auto& r = *self<RunBox>(L, "run:state").value;
    const auto [first, end] = elements_of(L, 2, r, "run:state");
    bool broken = false, yielded = false;
    double f = 0;
    for (int e = first; e < end; ++e) {
        broken |= r.run->state().broken[e] != 0;
        yielded |= r.run->state().yielded[e] != 0;
        f = std::max(f, r.run->yield_value(e));
    }
    lua_pushstring(L, broken ? "broken" : yielded ? "yielded" : "elastic");
    lua_pushnumber(L, f);
    return 2;
}

/// run:read("f_y", group): one number a member of the group, in the order they were declared.
int read(lua_State* L) {
    const auto& r = *self<RunBox>(L, "run:read").value;
    static const std::vector<std::string> names = {"f_y", "N", "broken", "yielded", "touched", "plastic_work", "member", "x", "y", "z"};
    const std::string what = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
    const int quantity = int(std::find(names.begin(), names.end(), what) - names.begin());
    if (quantity == int(names.size()))
        throw InputError("run:read: quantity is " + show(L, 2) + "; must be one of 'f_y', 'N', 'broken', 'yielded', 'touched', 'plastic_work', 'member', 'x', 'y', 'z'" + did_you_mean(what, names));
    const int group = lua_isnoneornil(L, 3) ? -1 : group_argument(L, 3, "run:read: group", *r.model);
    const State& state = r.run->state();
    const auto& elements = r.run->structure().elements();
    std::vector<double> values;
    for (std::size_t i = 0; i < elements.size();) {
        const std::size_t first = i;
        const int member = elements[i].member;
        double largest = 0, sum = 0;
        Vec3 middle = Vec3::Zero();
        for (; i < elements.size() && elements[i].member == member; ++i) {
            switch (quantity) {
                case 0: largest = std::max(largest, r.run->yield_value(int(i))); break;
                case 2: largest = std::max(largest, double(state.broken[i] != 0)); break;
                case 3: largest = std::max(largest, double(state.yielded[i] != 0)); break;
                case 4: largest = std::max(largest, double(state.touched[i] != 0)); break;
                case 5: sum += state.plastic_work[i]; break;
                default: break;
            }
        }
        if (group >= 0 && !r.run->structure().in_group(int(first), group)) continue;
        for (int n : {elements[first].node[0], elements[i - 1].node[1]}) middle += 0.5 * (r.run->structure().position()[n] + state.displacement[n]);
        // N: the mean of the member's elements that are whole; a broken one carries none
        double n_sum = 0;
        int whole = 0;
        for (std::size_t k = first; k < i; ++k)
            if (!state.broken[k]) n_sum += state.force[k][4], ++whole;
        const double value[] = {largest, whole == int(i - first) ? n_sum / whole : 0.0, largest, largest, largest, sum, member + 1.0, middle.x(), middle.y(), middle.z()};
        values.push_back(value[quantity]);
    }
    push_array(L, values.data(), int(values.size()));
    return 1;
}

int run_momentum(lua_State* L) {
    const auto& r = *self<RunBox>(L, "run:momentum").value;
    const Momentum m = momentum(r.run->structure(), r.run->state());
    lua_createtable(L, 0, 3);
    lua_pushnumber(L, m.mass), lua_setfield(L, -2, "mass");
    push_array(L, m.linear.data(), 3), lua_setfield(L, -2, "linear");
    push_array(L, m.angular.data(), 3), lua_setfield(L, -2, "angular");
    return 1;
}

int run_still(lua_State* L) {
    const auto& run = self<RunBox>(L, "run:still").value->run;
    push<StillBox>(L, make_still(*run), run->share_structure());
    tell_collector(L, 200 * run->structure().elements().size());
    return 1;
}

void push_energy(lua_State* L, const Energy& e) {
    const std::pair<const char*, double> values[] = {
        {"initial", e.initial}, {"kinetic", e.kinetic}, {"gravity", e.gravity}, {"elastic", e.elastic}, {"plastic", e.plastic}, {"fracture", e.fracture},
        {"fracture_elastic", e.fracture_elastic}, {"fracture_kinetic", e.fracture_kinetic}, {"contact", e.contact}, {"contact_stored", e.contact_stored},
        {"contact_released", e.contact_released}, {"work", e.work}, {"remainder", e.remainder}};
    lua_createtable(L, 0, 13);
    for (const auto& [name, v] : values) lua_pushnumber(L, v), lua_setfield(L, -2, name);
}

int fields(lua_State* L) {
    const auto& r = *self<RunBox>(L, "run").value;
    const Run& run = *r.run;
    const std::string key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : show(L, 2);
    lua_pushvalue(L, 2);
    if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) return 1;
    if (key == "time") lua_pushnumber(L, run.state().time);
    else if (key == "factor") lua_pushnumber(L, run.state().factor);
    else if (key == "index") lua_pushinteger(L, run.steps_done());
    else if (key == "planned_steps") lua_pushinteger(L, run.planned_steps());
    else if (key == "verdict") lua_pushstring(L, name(run.verdict()));
    else if (key == "reason") lua_pushstring(L, run.reason().c_str());
    else if (key == "kind") lua_pushstring(L, run.kind());
    else if (key == "energy") push_energy(L, run.energy());
    else if (key == "worst_remainder") lua_pushnumber(L, r.worst_remainder);
    else if (key == "wall_seconds") lua_pushnumber(L, r.wall);
    else if (key == "hash") lua_pushstring(L, [&] { char t[20]; std::snprintf(t, sizeof t, "%016llx", (unsigned long long)hash(run.state())); return std::string(t); }().c_str());
    else if (key == "contacts") {
        lua_createtable(L, 0, 2);
        lua_pushinteger(L, run.state().contact ? run.state().contact->counts().bound : 0), lua_setfield(L, -2, "bound");
        lua_pushinteger(L, run.state().contact ? run.state().contact->counts().released : 0), lua_setfield(L, -2, "released");
    } else if (key == "counts") {
        const auto* d = dynamic_cast<const Dynamics*>(&run);
        const auto* s = dynamic_cast<const Statics*>(&run);
        const Operator::Counts c = d ? d->operator_counts() : s ? s->operator_counts() : Operator::Counts{};
        lua_createtable(L, 0, 7);
        lua_pushinteger(L, c.built), lua_setfield(L, -2, "element_builds");
        lua_pushinteger(L, c.iterations), lua_setfield(L, -2, "cg_iterations");
        lua_pushinteger(L, c.solves), lua_setfield(L, -2, "solves");
        lua_pushinteger(L, c.factorisations), lua_setfield(L, -2, "factorisations");
        lua_pushinteger(L, d ? d->element_updates() : s ? s->element_updates() : 0), lua_setfield(L, -2, "element_updates");
        lua_pushinteger(L, run.state().contact ? run.state().contact->counts().pair_tests : 0), lua_setfield(L, -2, "pair_tests");
        lua_pushinteger(L, run.state().contact ? run.state().contact->counts().list_builds : 0), lua_setfield(L, -2, "pair_lists");
    } else if (key == "wakings") {
        lua_newtable(L);
        int i = 0;
        for (const Run::Waking& w : run.wakings()) {
            lua_createtable(L, 0, 4);
            lua_pushnumber(L, w.time), lua_setfield(L, -2, "time");
            lua_pushstring(L, w.effect.c_str()), lua_setfield(L, -2, "effect");
            lua_pushboolean(L, w.awake), lua_setfield(L, -2, "awake");
            lua_pushstring(L, w.why.c_str()), lua_setfield(L, -2, "why");
            lua_rawseti(L, -2, ++i);
        }
    } else if (key == "fastest") {
        const auto* d = dynamic_cast<const Dynamics*>(&run);
        if (!d || d->fastest().node < 0) return lua_pushnil(L), 1;
        lua_createtable(L, 0, 4);
        lua_pushnumber(L, d->fastest().speed), lua_setfield(L, -2, "speed");
        lua_pushnumber(L, d->fastest().time), lua_setfield(L, -2, "time");
        lua_pushstring(L, run.structure().node_name(d->fastest().node).c_str()), lua_setfield(L, -2, "node");
    } else if (key == "stages") {
        lua_newtable(L);
        int i = 0;
        for (const StageTime& s : run.stage_times()) {
            lua_createtable(L, 0, 2);
            lua_pushstring(L, s.name), lua_setfield(L, -2, "name");
            lua_pushnumber(L, s.seconds), lua_setfield(L, -2, "seconds");
            lua_rawseti(L, -2, ++i);
        }
    } else {
        static const std::vector<std::string> names = {"time", "factor", "index", "planned_steps", "verdict", "reason", "kind", "energy", "worst_remainder", "wall_seconds", "hash", "contacts", "counts", "fastest", "stages", "wakings",
                                                       "steps", "step", "finish", "stop", "displacement", "velocity", "acceleration", "reaction", "position", "probe", "count", "forces", "state", "read", "momentum", "still"};
        throw InputError("run has no field or method '" + key + "'" + did_you_mean(key, names));
    }
    return 1;
}

int text(lua_State* L) {
    const Run& run = *self<RunBox>(L, "tostring").value->run;
    char t[160];
    std::snprintf(t, sizeof t, "%s run: %s at step %ld of %ld, t = %.6g s", run.kind(), name(run.verdict()), run.steps_done(), run.planned_steps(), run.state().time);
    return lua_pushstring(L, t), 1;
}

int probe_fields(lua_State* L) {
    const Probe& p = *self<ProbeBox>(L, "probe").value;
    const std::string key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : show(L, 2);
    if (key == "time" || key == "value") {
        const auto& v = key == "time" ? p.time : p.value;
        push_array(L, v.data(), int(v.size()));
    } else if (key == "name") lua_pushstring(L, p.name.c_str());
    else if (key == "last") lua_pushnumber(L, p.value.back());
    else if (key == "max") lua_pushnumber(L, *std::max_element(p.value.begin(), p.value.end()));
    else if (key == "min") lua_pushnumber(L, *std::min_element(p.value.begin(), p.value.end()));
    else throw InputError("probe has no field '" + key + "'" + did_you_mean(key, {"time", "value", "name", "last", "max", "min"}));
    return 1;
}

}  // namespace

void open_run(lua_State* L) {
    static const luaL_Reg none[] = {{nullptr, nullptr}};
    static const luaL_Reg methods[] = {
        {"steps", guarded<steps>}, {"step", guarded<step>}, {"finish", guarded<finish>}, {"stop", guarded<stop>}, {"displacement", guarded<displacement>},
        {"velocity", guarded<velocity>}, {"acceleration", guarded<acceleration>}, {"reaction", guarded<reaction>}, {"position", guarded<position>},
        {"probe", guarded<probe>}, {"count", guarded<count>}, {"forces", guarded<forces>}, {"state", guarded<member_state>}, {"read", guarded<read>}, {"momentum", guarded<run_momentum>},
        {"still", guarded<run_still>}, {nullptr, nullptr}};
    make_metatable(L, RunBox::lua_name, methods, guarded<fields>, collect<RunBox>, guarded<text>, nullptr);
    make_metatable(L, ProbeBox::lua_name, none, guarded<probe_fields>, collect<ProbeBox>, nullptr, nullptr);
    make_metatable(L, StillBox::lua_name, none, nullptr, collect<StillBox>, nullptr, nullptr);
}

}  // namespace hinge::script

// model:load and model:move: external loads and support motions, over time or as functions of the state.
#include <cmath>

#include "effects/loads.h"
#include "effects/moving_supports.h"
#include "script/bind/model_methods.h"
#include "script/bind/run_box.h"

namespace hinge::script {
/// A quantity over time in a field of the options: a function, or points between which it is linear. `each`: what a
/// point has beside its time. Empty where the field is absent.
History read_history(Options& o, const char* field, const std::string& each, const Model& model, bool jumps) {
    const int type = o.push_field(field);
    lua_State* L = o.L();
    if (type == LUA_TNIL) return lua_pop(L, 1), History{};
    if (type == LUA_TFUNCTION) {
        LuaFunction f(L, -1, model);
        lua_pop(L, 1);
        return History([f, who = o.function(), field = std::string(field)](double t) {
            lua_State* running = f.running();
            f.push(running);
            lua_pushnumber(running, t);
            call_hook(running, f, 1, 1, [&] { return who + ", field '" + field + "', t = " + show(t) + " s"; });
            const bool good = lua_type(running, -1) == LUA_TNUMBER && std::isfinite(lua_tonumber(running, -1));
            const double v = lua_tonumber(running, -1);
            const std::string shown = good ? "" : show(running, -1);
            lua_pop(running, 1);
            if (!good)
                throw HookError(f.place() + ": " + who + ": the function in field '" + field + "' returned " + shown +
                                " at t = " + show(t) + " s; it must return a finite number");
            return v;
        });
    }
    const std::string shown = show(L, -1);
    if (type != LUA_TTABLE) {
        lua_pop(L, 1);
        o.complain(field, shown, "must be a function of time (s) or a table of {time, " + each + "} pairs");
    }
    std::vector<std::pair<double, double>> points;
    const int table = lua_gettop(L);
    for (lua_Integer i = 1, n = list_length(L, table, o.function() + ": field '" + field + "'"); i <= n; ++i) {
        double pair[2];
        lua_rawgeti(L, table, i);
        bool good = lua_istable(L, -1) && lua_rawlen(L, -1) == 2;
        for (int k = 0; good && k < 2; ++k) {
            good = lua_rawgeti(L, -1, k + 1) == LUA_TNUMBER;
            pair[k] = lua_tonumber(L, -1);
            lua_pop(L, 1);
        }
        lua_pop(L, 1);
        if (!good)
            o.complain(field, "wrong at point " + std::to_string(i), "each point must be {time in s, " + each + "}");
        if (!std::isfinite(pair[0]) || !std::isfinite(pair[1]))
            o.complain(field, "not finite at point " + std::to_string(i), "times and values must be finite");
        const bool again = !points.empty() && pair[0] == points.back().first;
        if (!points.empty() && (pair[0] < points.back().first || (again && !jumps)))
            o.complain(field, "out of order at point " + std::to_string(i) + " (time " + show(pair[0]) + " s)",
                       jumps ? "times must rise, or be equal where it jumps" : "times must rise");
        if (again && points.size() > 1 && points[points.size() - 2].first == pair[0])
            o.complain(field, "three times at " + show(pair[0]) + " s",
                       "a jump is two points: up to its time, and from there on");
        points.push_back({pair[0], pair[1]});
    }
    lua_pop(L, 1);
    if (points.empty()) o.complain(field, "empty", "give at least one {time, " + each + "}");
    return History(std::move(points));
}

namespace {

/// The run of this model that is inside a step.
std::shared_ptr<ScriptRun> stepping_run(const ScriptModel& model) {
    for (const auto& run : model.runs)
        if (auto record = run.lock(); record && record->stepping) return record;
    return nullptr;
}

/// A force or moment that is a function of time and of the run: three numbers, or a table of three.
std::function<Vec3(double)> read_acting(Options& o, const char* field, const char* unit,
                                        const std::shared_ptr<ScriptModel>& m) {
    lua_State* L = o.L();
    const bool given = o.push_field(field) == LUA_TFUNCTION;
    if (!given) return lua_pop(L, 1), nullptr;
    const LuaFunction f(L, -1, *m);
    lua_pop(L, 1);
    return [f, who = o.function() + ": the function in field '" + field + "'", unit,
            model = std::weak_ptr<ScriptModel>(m)](double t) {
        lua_State* running = f.running();
        const int top = lua_gettop(running);
        f.push(running);
        lua_pushnumber(running, t);
        const auto own = model.lock();
        if (const auto record = own ? stepping_run(*own) : nullptr) {
            push<RunBox>(running, record);
            hold_registry(running, *own);
        } else {
            lua_pushnil(running);
        }
        call_hook(running, f, 2, 3, [&] { return who + ", t = " + show(t) + " s"; });
        Vec3 v;
        try {
            if (lua_istable(running, top + 1)) {
                v = read_triple(running, top + 1, who, unit);
            } else {
                for (int i = 0; i < 3; ++i) {
                    if (lua_type(running, top + 1 + i) != LUA_TNUMBER ||
                        !std::isfinite(lua_tonumber(running, top + 1 + i)))
                        throw InputError(who + " returned " + show(running, top + 1 + i) + " as value " +
                                         std::to_string(i + 1) + " at t = " + show(t) +
                                         " s; it must return three finite numbers in " + unit +
                                         ", or a table of three");
                    v[i] = lua_tonumber(running, top + 1 + i);
                }
            }
        } catch (const InputError& e) {
            lua_settop(running, top);
            throw HookError(f.place() + ": " + e.what());
        }
        lua_settop(running, top);
        return v;
    };
}

}  // namespace

int add_load(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:load").value;
    Options o(L, 2, "model:load");
#define HINGE_LOAD_ON(target, function, ...) \
    if (o.has(#target)) return function(L);
#include "script/bind/load_targets.inc"
#undef HINGE_LOAD_ON
    std::vector<std::string> fields = {"node", "force", "moment", "history", "case"}, others;
#define HINGE_LOAD_ON(target, function, ...) \
    for (const char* field : {#target __VA_OPT__(, ) __VA_ARGS__}) others.push_back(field);
#include "script/bind/load_targets.inc"
#undef HINGE_LOAD_ON
    fields.insert(fields.end(), others.begin(), others.end());
    o.expect(fields);
    for (const std::string& field : others)
        if (o.has(field.c_str())) o.complain(field, "given", "belongs to a load on '" + others[0] + "', not on a node");
    NodalLoad load;
    o.push_field("node");
    load.node = node_argument(L, -1, "model:load: field 'node'", m.get()).index;
    lua_pop(L, 1);
    load.force_rule = read_acting(o, "force", "N", m);
    load.moment_rule = read_acting(o, "moment", "N m", m);
    const auto force = load.force_rule ? std::nullopt : o.triple("force", "N"),
               moment = load.moment_rule ? std::nullopt : o.triple("moment", "N m");
    if (!force && !moment && !load.follows_state())
        throw InputError(
            "model:load: neither 'force' (N) nor 'moment' (N m) is given; give {x, y, z}, or a function of time and "
            "the run");
    load.force = force.value_or(Vec3::Zero());
    load.moment = moment.value_or(Vec3::Zero());
    load.history = read_history(o, "history", "factor", *m, true);
    load.load_case = case_of(o, *m);
    if (load.history && !force && !moment)
        o.complain("history", "given", "is a factor of numbers; a force that is a function has its own");
    const bool has_points = load.history.points() != nullptr;
    const int number = hinge::add_load(*m, std::move(load));
    if (has_points) m->ask("load " + std::to_string(number), where(L));
    if (!m->asked(loads_effect)) m->ask(loads_effect, where(L));
    push_load(L, m, number);
    return 1;
}

int move_support(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:move").value;
    Options o(L, 2, "model:move");
    o.expect({"node", "x", "y", "z", "rx", "ry", "rz"});
    std::vector<int> nodes;
    if (o.push_field("node") == LUA_TTABLE)
        for (lua_Integer i = 1, n = list_length(L, -1, "model:move: field 'node'"); i <= n; ++i) {
            lua_rawgeti(L, -1, i);
            nodes.push_back(node_argument(L, -1, "model:move: field 'node', item " + std::to_string(i), m.get()).index);
            lua_pop(L, 1);
        }
    else nodes.push_back(node_argument(L, -1, "model:move: field 'node'", m.get()).index);
    lua_pop(L, 1);
    if (nodes.empty()) o.complain("node", "an empty list", "must be a node, or a list of them");
    History path[6];
    const char* axes[] = {"x", "y", "z", "rx", "ry", "rz"};
    bool any = false;
    for (int c = 0; c < 6; ++c)
        any |= bool(path[c] = read_history(o, axes[c], c < 3 ? "displacement in m" : "rotation in rad", *m, false));
    if (!any)
        throw InputError(
            "model:move: none of 'x', 'y', 'z', 'rx', 'ry', 'rz' is given; give a displacement in m, or a rotation in "
            "rad, over time: a function or {{time, displacement}, ...}");
    for (const int n : nodes)
        for (int c = 0; c < 6; ++c)
            for (const SupportMotion& other : m->declared<SupportMotion>(moving_supports_effect))
                if (path[c] && other.node == n && other.component == c)
                    throw InputError("model:move: node " + std::to_string(n + 1) + " is moved " +
                                     (c < 3 ? "along " : "about ") + "xyz"[c % 3] + " already");
    for (const int n : nodes)
        for (int c = 0; c < 6; ++c)
            if (path[c]) add_motion(*m, {n, c, path[c]});
    for (const int n : nodes) m->ask("motion of node " + std::to_string(n), where(L));
    m->ask("ground", where(L));
    return 0;
}

}  // namespace hinge::script

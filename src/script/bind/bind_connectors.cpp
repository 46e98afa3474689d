// model:connector: springs, dashpots, curves and laws of the script between two nodes, or a node and the ground; and
// the results of a connector in a run.
#include "effects/connectors.h"

#include "script/bind/model_methods.h"
#include "script/bind/run_box.h"

namespace hinge::script {

struct ConnectorBox {
    static constexpr const char* lua_name = "hinge.connector";
    std::shared_ptr<ScriptModel> model;
    int index;
};
std::string name_of(const ConnectorBox& c) { return "connector " + std::to_string(c.index + 1); }

namespace {

constexpr const char* directions[] = {"x", "y", "z", "rx", "ry", "rz"};

/// A field that is a table by direction: read(direction, options of the table, their name in messages).
template <class F>
void each_direction(Options& o, const char* field, const char* of, F read) {
    lua_State* L = o.L();
    const int type = o.push_field(field);
    if (type == LUA_TTABLE) {
        Options inner(L, lua_gettop(L), "model:connector: field '" + std::string(field) + "'");
        inner.expect({"x", "y", "z", "rx", "ry", "rz"});
        for (int k = 0; k < 6; ++k)
            if (inner.has(directions[k])) read(k, inner);
    } else if (type != LUA_TNIL) {
        o.complain(field, show(L, -1), std::string("must be a table of ") + of + " by direction: x, y, z, rx, ry, rz");
    }
    lua_pop(L, 1);
}

std::vector<std::pair<double, double>> read_curve(Options& o, int k) {
    lua_State* L = o.L();
    const char* field = directions[k];
    const std::string point_is = k < 3 ? "{deformation in m, force in N}" : "{deformation in rad, moment in N m}";
    const int type = o.push_field(field);
    if (type != LUA_TTABLE) o.complain(field, show(L, -1), "must be a table of points " + point_is);
    std::vector<std::pair<double, double>> curve;
    const int table = lua_gettop(L);
    for (lua_Integer i = 1, n = lua_rawlen(L, table); i <= n; ++i) {
        const std::string here = "point " + std::to_string(i);
        double pair[2] = {0, 0};
        bool good = lua_rawgeti(L, table, i) == LUA_TTABLE;
        for (int c = 0; good && c < 2; ++c) {
            good = lua_rawgeti(L, -1, c + 1) == LUA_TNUMBER;
            pair[c] = lua_tonumber(L, -1);
            lua_pop(L, 1);
        }
        lua_pop(L, 1);
        if (!good || !std::isfinite(pair[0]) || !std::isfinite(pair[1]))
            o.complain(field, "wrong at " + here, "each point must be " + point_is + ", finite");
        if (!curve.empty() && pair[0] <= curve.back().first)
            o.complain(field, "out of order at " + here, "deformations must rise");
        curve.push_back({pair[0], pair[1]});
    }
    lua_pop(L, 1);
    if (curve.size() < 2) o.complain(field, std::to_string(curve.size()) + " points", "give at least two " + point_is);
    if (curve[0].first > 0 || (curve[0].first == 0 && curve[0].second != 0) || curve.back().first <= 0)
        o.complain(field, "from " + show(curve[0].first) + " to " + show(curve.back().first),
                   "a curve begins with {0, 0} and then holds for both signs, or reaches from below 0 to above 0");
    return curve;
}

/// `yield` needs stiffness, and `ultimate` needs yield, in the same direction.
void read_limits(Options& o, const Connector& c, const char* field, const char* straight, const char* turning,
                 ConnectorLimits& limits) {
    const bool ultimate = &limits == &c.ultimate;
    o.read_table(field, ultimate ? "{ xy = 6e-3 }" : "{ xy = 60e3 }", [&](Options& in) {
        in.expect({"x", "y", "z", "rx", "ry", "rz", "xy"});
        for (int k = 0; k < 6; ++k) {
            const auto given = in.maybe_number(directions[k], k < 3 ? straight : turning, Range::positive);
            if (!given) continue;
            limits.each[k] = *given;
            if (ultimate ? !std::isfinite(c.yield.each[k]) : !(c.stiffness[k] > 0))
                in.complain(directions[k], show(*given),
                            ultimate ? "does not yield in that direction: give it in 'yield' too"
                                     : "has no stiffness in that direction, which could yield");
        }
        const auto both = in.maybe_number("xy", straight, Range::positive);
        if (!both) return;
        limits.xy = *both;
        if (ultimate && !std::isfinite(c.yield.xy))
            in.complain("xy", show(*both), "x and y do not yield together: give 'xy' in 'yield' too");
        if (!ultimate && !(c.stiffness[0] > 0 && c.stiffness[0] == c.stiffness[1]))
            in.complain("xy", show(*both), "needs the same stiffness along x and y, above 0");
        if (!ultimate && (std::isfinite(c.yield.each[0]) || std::isfinite(c.yield.each[1])))
            in.complain("xy", show(*both), "is given beside x or y; give one of them");
    });
}

[[noreturn]] void refuse_result(const std::string& who, const std::string& what) {
    throw HookError(who + " returned " + what +
                    "; it must return a finite number (N, or N m) and, if it keeps a state, a table of finite numbers "
                    "by name");
}

/// The state is a table for Lua and numbers for the engine, so that a step can be taken back and a run kept.
ConnectorLaw law_of(const LuaFunction& f, int k, int number) {
    return [f, k, number](double deformation, double rate, double dt, LawState& state) {
        lua_State* L = f.running();
        const int top = lua_gettop(L);
        f.push(L);
        lua_pushnumber(L, deformation);
        lua_pushnumber(L, rate);
        lua_createtable(L, 0, int(state.size()));
        for (const auto& [name, value] : state) lua_pushnumber(L, value), lua_setfield(L, -2, name.c_str());
        lua_pushnumber(L, dt);
        const std::string law = "the law of " + std::string(directions[k]) + " of connector " + std::to_string(number);
        call_hook(L, f, 4, 2, [&] { return law; });
        const std::string who = f.place() + ": " + law;
        const bool good = lua_type(L, top + 1) == LUA_TNUMBER && std::isfinite(lua_tonumber(L, top + 1));
        const double force = lua_tonumber(L, top + 1);
        std::string wrong = good ? "" : show(L, top + 1);
        if (good && lua_istable(L, top + 2)) {
            state.clear();
            lua_pushnil(L);
            while (lua_next(L, top + 2)) {
                if (lua_type(L, -2) != LUA_TSTRING || lua_type(L, -1) != LUA_TNUMBER ||
                    !std::isfinite(lua_tonumber(L, -1))) {
                    wrong = "a state with " + show(L, -2) + " = " + show(L, -1);
                    break;
                }
                std::size_t length = 0;
                const char* name = lua_tolstring(L, -2, &length);
                state[std::string(name, length)] = lua_tonumber(L, -1);
                lua_pop(L, 1);
            }
        } else if (good && !lua_isnil(L, top + 2)) {
            wrong = show(L, top + 2) + " for the state";
        }
        lua_settop(L, top);
        if (!wrong.empty()) refuse_result(who, wrong);
        return force;
    };
}

/// The connector as it is in a run, null where the run was made before it was declared; and its declaration.
struct AskedConnector {
    std::shared_ptr<ScriptRun> record;
    const ConnectorNow* now;
};
AskedConnector asked(lua_State* L, const char* method) {
    const std::string function = std::string("connector:") + method;
    const auto& c = self<ConnectorBox>(L, function);
    AskedConnector a;
    a.record = run_to_read(L, function, *c.model);
    const auto* all = a.record->run->state().data.find<ConnectorsNow>(connectors_effect);
    if (!all || c.index >= int(all->list.size()))
        throw InputError(function + ": the run made at " + a.record->asked_at + " does without " + name_of(c) +
                         ": it was made before the connector was declared, or leaves connectors out");
    a.now = &all->list[c.index];
    return a;
}

int push_six(lua_State* L, const Vec6& v) {
    for (int k = 0; k < 6; ++k) lua_pushnumber(L, v[k]);
    return 6;
}
int deformation(lua_State* L) { return push_six(L, asked(L, "deformation").now->deformation); }
int force(lua_State* L) {
    const AskedConnector a = asked(L, "force");
    return push_six(L, a.now->broken ? Vec6(Vec6::Zero()) : a.now->force);
}
int broken(lua_State* L) {
    const AskedConnector a = asked(L, "broken");
    if (a.now->broken) lua_pushnumber(L, a.now->broken_at);
    else lua_pushboolean(L, 0);
    return 1;
}
int fields_of_connector(lua_State* L) {
    if (push_method(L)) return 1;
    const std::string key = key_argument(L);
    self<ConnectorBox>(L, "connector." + key);
    refuse_field(L, "connector", key);
}
int text_of_connector(lua_State* L) {
    const auto& c = self_or_gone<ConnectorBox>(L, "tostring");
    lua_pushstring(L, (name_of(c) + gone(c)).c_str());
    return 1;
}

void make_connector_metatable(lua_State* L) {
    const bool there = luaL_getmetatable(L, ConnectorBox::lua_name) != LUA_TNIL;
    lua_pop(L, 1);
    if (there) return;
    static const luaL_Reg methods[] = {{"deformation", guarded<takes<"connector:deformation", 2, deformation>>},
                                       {"force", guarded<takes<"connector:force", 2, force>>},
                                       {"broken", guarded<takes<"connector:broken", 2, broken>>},
                                       {nullptr, nullptr}};
    make_metatable(L, ConnectorBox::lua_name, methods, guarded<fields_of_connector>, collect<ConnectorBox>,
                   guarded<text_of_connector>, nullptr);
}

}  // namespace

int add_connector(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:connector").value;
    Options o(L, 2, "model:connector");
    o.expect({"ground", "axes", "stiffness", "damping", "curve", "law", "capacity", "yield", "ultimate"}, 2);
    Connector c;
    const bool ground = o.flag("ground", false);
    int nodes[2] = {-1, -1};
    for (int i = 0; i < 2; ++i) {
        const bool given = o.push_item(i + 1) != LUA_TNIL;
        if (i == 0 || !ground)
            nodes[i] = node_argument(L, -1, "model:connector: node " + std::to_string(i + 1), m.get()).index;
        else if (given) o.complain("ground", "true", "joins one node to the ground; two nodes are given");
        lua_pop(L, 1);
    }
    c.a = ground ? -1 : nodes[0];
    c.b = ground ? nodes[0] : nodes[1];
    if (c.a == c.b)
        throw InputError("model:connector: both nodes are node " + std::to_string(c.b + 1) +
                         "; give two, or one and ground = true");
    c.axes = o.axes("axes");
    const auto unit = [](int k, const char* straight, const char* turning) { return k < 3 ? straight : turning; };
    each_direction(o, "stiffness", "stiffnesses (N/m, N m/rad)", [&](int k, Options& in) {
        c.stiffness[k] = in.number(directions[k], unit(k, "N/m", "N m/rad"), Range::not_negative);
    });
    each_direction(o, "damping", "dashpots (N s/m, N m s/rad)", [&](int k, Options& in) {
        c.damping[k] = in.number(directions[k], unit(k, "N s/m", "N m s/rad"), Range::not_negative);
    });
    each_direction(o, "curve", "curves", [&](int k, Options& in) { c.curve[k] = read_curve(in, k); });
    bool laws = false;
    const int number = int(m->declared<Connector>(connectors_effect).size()) + 1;
    each_direction(o, "law", "functions (deformation, rate, state, dt)", [&](int k, Options& in) {
        if (in.push_field(directions[k]) != LUA_TFUNCTION)
            in.complain(directions[k], show(L, -1), "must be a function (deformation, rate, state, dt)");
        c.law[k] = law_of(LuaFunction(L, -1, *m), k, number);
        laws = true;
        lua_pop(L, 1);
    });
    each_direction(o, "capacity", "forces (N, N m)", [&](int k, Options& in) {
        c.capacity[k] = in.number(directions[k], unit(k, "N", "N m"), Range::positive);
    });
    read_limits(o, c, "yield", "N", "N m", c.yield);
    read_limits(o, c, "ultimate", "m", "rad", c.ultimate);
    bool acts = laws || !c.stiffness.isZero(0) || !c.damping.isZero(0);
    for (const auto& curve : c.curve) acts = acts || !curve.empty();
    if (!acts)
        throw InputError(
            "model:connector: it would do nothing; give 'stiffness' (N/m, N m/rad), 'damping' (N s/m, N m s/rad), "
            "'curve' or 'law', such as stiffness = { x = 1e6 }");
    for (int k = 0; k < 6; ++k)
        if (std::isfinite(c.capacity[k]) && c.stiffness[k] == 0 && c.damping[k] == 0 && c.curve[k].empty() && !c.law[k])
            o.complain("capacity", std::string("given for ") + directions[k],
                       "nothing acts in that direction, so it never breaks there");
    m->declare(connectors_effect, std::move(c));
    m->ask(connectors_effect, where(L));
    make_connector_metatable(L);
    push<ConnectorBox>(L, m, number - 1);
    hold_registry(L, *m);
    return 1;
}

}  // namespace hinge::script

#include "script/bind/changed_runs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "effects/fracture.h"
#include "effects/removal.h"
#include "model/model.h"
#include "record/chain.h"
#include "run/dynamics.h"
#include "script/bind/run_box.h"
#include "script/lua/lua_calls.h"

namespace hinge::script {
namespace {

const char* const changes = "hinge.changed_runs";

/// The members' materials are changed by four different parts, so that members which are alike do not stay so: what
/// hangs on their being equal shows.
constexpr std::array<double, 4> parts = {1, -1, 0.5, -0.5};

/// A number of the table of core.change_runs; `usual` where there is none.
double change(lua_State* L, const char* name, double usual) {
    double value = usual;
    if (lua_getfield(L, LUA_REGISTRYINDEX, changes) == LUA_TTABLE) {
        lua_getfield(L, -1, name);
        if (lua_isnumber(L, -1)) value = lua_tonumber(L, -1);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return value;
}

/// An even number where the formulation has pairs, at least one element or one pair.
int changed_elements(const Model& model, int elements, double factor) {
    const int least = model.options().formulation == Formulation::asi_gauss ? 2 : 1;
    return std::max(least, least * int(std::lround(elements * factor / least)));
}

/// Offsets of the nodes inside a bent member, for another number of elements: straight between those there were.
std::vector<Vec3> offsets_anew(const std::vector<Vec3>& inner, int elements) {
    const auto at = [&](int i) -> Vec3 {
        return i <= 0 || i > int(inner.size()) ? Vec3(Vec3::Zero()) : inner[std::size_t(i) - 1];
    };
    std::vector<Vec3> all;
    for (int i = 1; i < elements; ++i) {
        const double place = double(i) * double(inner.size() + 1) / elements;
        const int before = int(place);
        all.push_back(at(before) + (place - before) * (at(before + 1) - at(before)));
    }
    return all;
}

/// A member of the run's own copy of a model, which nobody else has.
MemberData& member_of_copy(Model& copy, int i) { return const_cast<MemberData&>(copy.members()[std::size_t(i)]); }

/// core.change_runs{ elements =, step =, control =, strength =, options = function(kind, options) } or (nil).
int change_runs(lua_State* L) {
    lua_settop(L, 1);
    lua_setfield(L, LUA_REGISTRYINDEX, changes);
    return 0;
}

bool is_removed(const Model& model, int member) {
    const auto& groups = model.members()[std::size_t(member)].groups;
    return std::ranges::any_of(model.declared<Removal>(removal_effect), [&](const Removal& r) {
        return r.group < 0 ? r.member == member : std::ranges::find(groups, r.group) != groups.end();
    });
}

/// core.facts(run): { elements =, members = how many, broken = numbers of the members that have broken, without those
/// that the script removes, groups = { number = the first group of such a member }, strain_limits = true if a limit of
/// fracture is a strain, which goes with the length of elements, verdict =, asked = whether the script has read it, dt
/// = the step that was asked for (s) or nil }. This does not count as reading it.
int facts(lua_State* L) {
    const auto r = run_argument(L, 1, "facts: this");
    const Structure& structure = r->run->structure();
    const Model& model = structure.model();
    lua_createtable(L, 0, 8);
    if (const Dynamics* d = r->run->dynamics()) lua_pushnumber(L, d->settings().dt), lua_setfield(L, -2, "dt");
    lua_pushstring(L, name(verdict_of(*r))), lua_setfield(L, -2, "verdict");
    lua_pushboolean(L, context(L)->runs.asked.count(r->number) > 0), lua_setfield(L, -2, "asked");
    lua_pushinteger(L, lua_Integer(structure.elements().size())), lua_setfield(L, -2, "elements");
    lua_pushinteger(L, lua_Integer(model.members().size())), lua_setfield(L, -2, "members");
    lua_newtable(L), lua_newtable(L);
    int n = 0, last = -1;
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        const int member = structure.elements()[i].member;
        if (member == last || r->run->state().broken[i] == 0 || is_removed(model, member)) continue;
        last = member;
        lua_pushinteger(L, member + 1), lua_rawseti(L, -3, ++n);
        const auto& groups = model.members()[std::size_t(member)].groups;
        lua_pushstring(L, groups.empty() ? "" : model.groups()[std::size_t(groups[0])].c_str());
        lua_rawseti(L, -2, member + 1);
    }
    lua_setfield(L, -3, "groups"), lua_setfield(L, -2, "broken");
    const auto& rules = fracture_rules(model);
    lua_pushboolean(L, std::ranges::any_of(rules, [](const FractureRule& rule) { return !rule.no_strains(); }));
    lua_setfield(L, -2, "strain_limits");
    return 1;
}

}  // namespace

bool models_change(lua_State* L) {
    const bool any = lua_getfield(L, LUA_REGISTRYINDEX, changes) == LUA_TTABLE;
    lua_pop(L, 1);
    return any;
}

void change_options(lua_State* L, const char* kind) {
    lua_settop(L, 2);
    if (lua_getfield(L, LUA_REGISTRYINDEX, changes) == LUA_TTABLE && lua_getfield(L, -1, "options") == LUA_TFUNCTION) {
        lua_pushstring(L, kind);
        lua_pushvalue(L, 2);
        must_be_ok(L, lua_pcall(L, 2, 1, 0));
        if (lua_istable(L, -1)) lua_replace(L, 2);
    }
    lua_settop(L, 2);
}

void change_model(lua_State* L, Model& copy) {
    if (const double factor = change(L, "elements", 1); factor != 1)
        for (int i = 0; i < int(copy.members().size()); ++i) {
            MemberData& m = member_of_copy(copy, i);
            m.elements = changed_elements(copy, m.elements, factor);
            if (!m.inner.empty()) m.inner = offsets_anew(m.inner, m.elements);
        }
    if (const double part = change(L, "strength", 0); part != 0) {
        std::map<std::pair<std::shared_ptr<const Material>, int>, std::shared_ptr<const Material>> changed;
        for (int i = 0; i < int(copy.members().size()); ++i) {
            auto& material = member_of_copy(copy, i).material;
            auto& other = changed[{material, i % int(parts.size())}];
            if (!other) {
                Material m = *material;
                const double by = 1 + part * parts[std::size_t(i) % parts.size()];
                m.E *= by, m.G *= by, m.yield_stress *= by;
                other = std::make_shared<const Material>(std::move(m));
            }
            material = other;
        }
    }
}

void change_steps(lua_State* L, DynamicSettings& s) {
    if (s.controlled_by_default) s.step_control *= change(L, "control", 1);
    double factor = change(L, "step", 1);
    if (s.explicit_steps()) factor = std::min(factor, 1.0);  // longer ones are not stable
    if (!s.chosen || factor == 1) return;
    s.dt = s.duration / std::max(1.0, std::ceil(s.duration / (s.dt * factor) - 1e-9));
}

void add_changed_runs(lua_State* L) {
    static const luaL_Reg functions[] = {
        {"change_runs", guarded<change_runs>}, {"facts", guarded<facts>}, {nullptr, nullptr}};
    luaL_setfuncs(L, functions, 0);
}

}  // namespace hinge::script

// model:fracture and model:contact: what a script may say of what breaks and what touches.
#include <algorithm>
#include <cmath>

#include "script/objects.h"

namespace hinge::script {
namespace {

FractureHook read_fracture_hook(lua_State* L, int index, const std::shared_ptr<Model>& m) {
    LuaFunction f(L, index, *m);
    std::weak_ptr<Model> model = m;
    return [f, model](const SectionView& s) {
        lua_State* L = f.running();
        f.push(L);
        lua_createtable(L, 0, 20);
        const std::pair<const char*, double> numbers[] = {
            {"time", s.time}, {"step", s.step}, {"member", s.member + 1.0}, {"element", s.element + 1.0}, {"end", double(s.end)},
            {"curvature_x", s.curvature_x}, {"curvature_y", s.curvature_y}, {"axial_strain", s.axial_strain}, {"twist", s.twist},
            {"Mx", s.Mx}, {"My", s.My}, {"N", s.N}, {"Mz", s.Mz}, {"f_y", s.f_y}, {"plastic_work", s.plastic_work}};
        for (const auto& [name, value] : numbers) lua_pushnumber(L, value), lua_setfield(L, -2, name);
        lua_pushboolean(L, s.plastic);
        lua_setfield(L, -2, "plastic");
        if (const auto own = model.lock(); own && !own->members()[s.member].groups.empty()) {
            lua_pushstring(L, own->groups()[own->members()[s.member].groups[0]].c_str());
            lua_setfield(L, -2, "group");
        }
        call_hook(L, f, 1, 1);
        const bool breaks = lua_toboolean(L, -1);
        lua_pop(L, 1);
        return breaks;
    };
}

}  // namespace

int fracture_rule(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:fracture").value;
    FractureRule rule;
    if (lua_isfunction(L, 2)) {
        rule.hook = read_fracture_hook(L, 2, m);
    } else {
        if (!lua_istable(L, 2)) throw InputError("model:fracture: takes a table of limits or a function, got " + show(L, 2));
        Options o(L, 2, "model:fracture");
        const auto take = [&](const char* field, const char* unit, double& limit) {
            if (const auto v = o.maybe_number(field, unit, Range::positive)) limit = *v;
        };
        take("curvature_x", "1/m", rule.curvature_x);
        take("curvature_y", "1/m", rule.curvature_y);
        take("axial_strain", "", rule.axial_strain);
        rule.tension_only = o.flag("tension_only", false);
        const int type = o.push_field("rule");
        if (type == LUA_TFUNCTION) rule.hook = read_fracture_hook(L, -1, m);
        else if (type != LUA_TNIL) o.complain("rule", show(L, -1), "must be a function of a section that returns true where it breaks");
        lua_pop(L, 1);
        if (o.push_field("group") != LUA_TNIL) rule.group = group_argument(L, -1, "model:fracture: field 'group'", *m);
        lua_pop(L, 1);
        o.finish();
        if (!rule.hook && !std::isfinite(rule.curvature_x) && !std::isfinite(rule.curvature_y) && !std::isfinite(rule.axial_strain))
            throw InputError("model:fracture: no limit is given; give curvature_x, curvature_y (1/m), axial_strain, or a function");
    }
    m->add_fracture(std::move(rule));
    m->ask("fracture", where(L));
    return 0;
}

int contact_rule(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:contact").value;
    Options o(L, 2, "model:contact", true);
    ContactRule rule;
    contact::ContactSettings& c = rule.settings;
    const bool gap = o.word("rule", {"surface", "gap"}, "surface") == "gap";
    c.rule = gap ? contact::ContactRuleKind::gap : contact::ContactRuleKind::surface;
    c.stiffness = o.number("stiffness", "N/m", Range::positive, c.stiffness);
    c.friction = o.number("friction", "", Range::not_negative, c.friction);
    c.reach = o.number("reach", "", Range::positive, c.reach);
    c.flatness = o.number("flatness", "m^3", Range::positive, c.flatness);
    c.binding_time = o.number("binding_time", "s", Range::positive, c.binding_time);
    c.letter = o.flag("letter", c.letter);
    c.sleep = o.flag("sleep", c.sleep);
    c.hold_until_parting = o.word("release", {"parting", "time"}, c.letter ? "time" : "parting") == "parting";
    for (const char* field : {"stiffness", "friction"})
        if (gap && o.has(field)) o.complain(field, "given", "belongs to rule 'surface'; rule is 'gap'");
    for (const char* field : {"reach", "flatness", "binding_time", "letter", "release"})
        if (!gap && o.has(field)) o.complain(field, "given", "belongs to rule 'gap'; rule is 'surface', the default");
    const int type = o.push_field("groups");
    if (type == LUA_TTABLE)
        for (lua_Integer i = 1, n = lua_rawlen(L, -1); i <= n; ++i) {
            lua_rawgeti(L, -1, i);
            rule.groups.push_back(group_argument(L, -1, "model:contact: field 'groups', item " + std::to_string(i), *m));
            lua_pop(L, 1);
        }
    else if (type != LUA_TNIL) o.complain("groups", show(L, -1), "must be a table of groups or their names");
    lua_pop(L, 1);
    o.finish();
    m->set_contact(std::move(rule));
    m->ask("contact", where(L));
    return 0;
}

}  // namespace hinge::script

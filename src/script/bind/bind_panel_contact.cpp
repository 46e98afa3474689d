// model:panel_contact: panels that points of other panels and of members press on.
#include "contact/press_law.h"
#include "effects/panel_contact.h"
#include "script/bind/model_methods.h"
#include "script/bind/run_box.h"
#include "script/bind/value_box.h"

namespace hinge::script {

struct PanelContactBox {
    static constexpr const char* lua_name = "hinge.panel_contact";
    std::shared_ptr<ScriptModel> model;
};
std::string name_of(const PanelContactBox&) { return "the contact of panels"; }

namespace {

int pressing(lua_State* L) {
    const std::string function = "panel_contact:pressing";
    const auto& box = self<PanelContactBox>(L, function);
    const std::shared_ptr<ScriptRun> record = run_to_read(L, function, *box.model);
    PanelPress sum;
    if (record->run->state().data.find<PanelContactNow>(panel_contact_effect))
        sum = pressing_on_panels(record->run->structure(), record->run->state());
    lua_pushinteger(L, sum.points), lua_pushnumber(L, sum.force), lua_pushnumber(L, sum.depth);
    return 3;
}
int text_of_contact(lua_State* L) {
    const auto& box = self_or_gone<PanelContactBox>(L, "tostring");
    lua_pushstring(L, (name_of(box) + gone(box)).c_str());
    return 1;
}
int fields_of_contact(lua_State* L) {
    if (push_method(L)) return 1;
    refuse_field(L, "panel_contact", key_argument(L));
}

void make_contact_metatable(lua_State* L) {
    const bool there = luaL_getmetatable(L, PanelContactBox::lua_name) != LUA_TNIL;
    lua_pop(L, 1);
    if (there) return;
    static const luaL_Reg methods[] = {{"pressing", guarded<takes<"panel_contact:pressing", 2, pressing>>},
                                       {nullptr, nullptr}};
    make_metatable(L, PanelContactBox::lua_name, methods, guarded<fields_of_contact>, collect<PanelContactBox>,
                   guarded<text_of_contact>, nullptr);
}

}  // namespace

int declare_panel_contact(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:panel_contact").value;
    Options o(L, 2, "model:panel_contact", true);
    o.expect({"stiffness", "restitution", "friction", "members"});
    PanelContactRule rule;
    rule.stiffness = o.number("stiffness", "N/m", Range::positive, rule.stiffness);
    if (constexpr double most = 1e15; rule.stiffness > most)
        o.complain("stiffness", show(rule.stiffness) + " N/m", "must be at most " + show(most) + " N/m");
    rule.restitution = o.number("restitution", "", Range::positive, rule.restitution);
    if (!(rule.restitution >= contact::least_restitution && rule.restitution <= 1))
        o.complain("restitution", show(rule.restitution),
                   "must be " + show(contact::least_restitution) +
                       " to 1: the part of its speed with which a point comes out of a panel");
    rule.friction = o.number("friction", "", Range::not_negative, rule.friction);
    rule.members = o.flag("members", rule.members);
    if (!m->declared<PanelContactRule>(panel_contact_effect).empty())
        throw InputError("model:panel_contact: it is declared already, at " + m->asked_at(panel_contact_effect) +
                         "; one call holds for all panels of a model");
    m->declare(panel_contact_effect, rule);
    m->ask(panel_contact_effect, where(L));
    make_contact_metatable(L);
    push<PanelContactBox>(L, m);
    hold_registry(L, *m);
    return 1;
}

}  // namespace hinge::script

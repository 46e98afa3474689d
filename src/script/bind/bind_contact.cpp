// model:contact: members that may touch, contact rules, and callbacks of the script.
#include "effects/contact.h"
#include "script/bind/model_methods.h"

namespace hinge::script {
namespace {

/// The numbers of a rule, as far as they are given; `c` has the others. `gap`: which of the two rules it is.
void read_numbers(Options& o, bool gap, contact::ContactSettings& c) {
    c.rule = gap ? contact::ContactRuleKind::gap : contact::ContactRuleKind::surface;
    c.stiffness = o.number("stiffness", "N/m", Range::positive, c.stiffness);
    c.friction = o.number("friction", "", Range::not_negative, c.friction);
    c.contact_length = o.number("contact_length", "", Range::positive, c.contact_length);
    c.coplanarity_tolerance = o.number("coplanarity_tolerance", "m^3", Range::positive, c.coplanarity_tolerance);
    c.binding_time = o.number("binding_time", "s", Range::positive, c.binding_time);
    c.as_printed = o.flag("as_printed", c.as_printed);
    const char* sign_of_f = c.signed_f ? "as printed" : "absolute";
    c.signed_f = o.word("sign_of_f", {"absolute", "as printed"}, sign_of_f) == "as printed";
    if (c.signed_f && !c.as_printed && o.has("sign_of_f"))
        o.complain("sign_of_f", "'as printed'", "belongs to as_printed = true");
    c.hold_until_parting =
        o.word("release", {"parting", "time"}, c.as_printed || !c.hold_until_parting ? "time" : "parting") == "parting";
    for (const char* field : {"stiffness", "friction"})
        if (gap && o.has(field)) o.complain(field, "given", "belongs to rule 'surface'; rule is 'gap'");
    for (const char* field :
         {"contact_length", "coplanarity_tolerance", "binding_time", "as_printed", "sign_of_f", "release"})
        if (!gap && o.has(field)) o.complain(field, "given", "belongs to rule 'gap'; rule is 'surface', the default");
}

bool reads_gap(Options& o, bool otherwise) {
    return o.word("rule", {"surface", "gap"}, otherwise ? "gap" : "surface") == "gap";
}

/// The function in a field, if there is one.
std::optional<LuaFunction> function_in(Options& o, const char* field, const char* allowed, const Model& m) {
    lua_State* L = o.L();
    std::optional<LuaFunction> f;
    const int type = o.push_field(field);
    if (type == LUA_TFUNCTION) f.emplace(L, -1, m);
    else if (type != LUA_TNIL) o.complain(field, show(L, -1), allowed);
    lua_pop(L, 1);
    return f;
}

/// Of two members, whether they meet at all, and by what numbers.
void read_pairs(const LuaFunction& f, const std::shared_ptr<ScriptModel>& m, ContactRule& rule) {
    rule.pairs = [f, model = std::weak_ptr<ScriptModel>(m), usual = rule.settings](
                     int a, int b) -> std::optional<contact::ContactSettings> {
        lua_State* L = f.running();
        const auto own = model.lock();
        if (!own) return usual;
        const std::string pair = "members " + std::to_string(a + 1) + " and " + std::to_string(b + 1);
        f.push(L);
        push_handle<MemberBox>(L, own, a);
        push_handle<MemberBox>(L, own, b);
        call_hook(L, f, 2, 1, [&] { return "contact rule, " + pair; });
        std::optional<contact::ContactSettings> found = usual;
        const std::string who = f.place() + ": model:contact: the function 'pairs' for " + pair;
        try {
            if (lua_istable(L, -1)) {
                Options o(L, lua_gettop(L), who);
                o.expect({"rule", "stiffness", "friction", "contact_length", "coplanarity_tolerance", "binding_time",
                          "as_printed", "sign_of_f", "release"});
                read_numbers(o, reads_gap(o, usual.rule == contact::ContactRuleKind::gap), *found);
            } else if (lua_isboolean(L, -1) && !lua_toboolean(L, -1)) {
                found.reset();
            } else if (!lua_isnil(L, -1) && !lua_isboolean(L, -1)) {
                throw InputError(who + " returned " + show(L, -1) +
                                 "; it must return nil or true for the rule's own numbers, false where the two never "
                                 "meet, or a table of other numbers");
            }
        } catch (const InputError& e) {
            lua_pop(L, 1);
            throw HookError(e.what());
        }
        lua_pop(L, 1);
        return found;
    };
}

std::function<void(const contact::ContactEvent&, int, int)> telling(const LuaFunction& f, const char* name,
                                                                    const std::shared_ptr<ScriptModel>& m) {
    return [f, name, model = std::weak_ptr<ScriptModel>(m)](const contact::ContactEvent& event, int a, int b) {
        const auto own = model.lock();
        if (!own) return;
        lua_State* L = f.running();
        f.push(L);
        lua_createtable(L, 0, 5);
        lua_pushnumber(L, event.time), lua_setfield(L, -2, "time");
        push_handle<MemberBox>(L, own, a), lua_setfield(L, -2, "a");
        push_handle<MemberBox>(L, own, b), lua_setfield(L, -2, "b");
        lua_pushinteger(L, event.element[0] + 1), lua_setfield(L, -2, "element_a");
        lua_pushinteger(L, event.element[1] + 1), lua_setfield(L, -2, "element_b");
        call_hook(L, f, 1, 0, [&] {
            return std::string(name) + ", members " + std::to_string(a + 1) + " and " + std::to_string(b + 1);
        });
    };
}

}  // namespace

int contact_rule(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:contact").value;
    Options o(L, 2, "model:contact", true);
    o.expect({"rule", "groups", "between", "stiffness", "friction", "binding_time", "release", "contact_length",
              "coplanarity_tolerance", "sleep", "as_printed", "sign_of_f", "pairs", "on_contact", "on_release"});
    ContactRule rule;
    read_numbers(o, reads_gap(o, false), rule.settings);
    rule.settings.sleep = o.flag("sleep", rule.settings.sleep);
    for (const char* field : {"groups", "between"}) {
        const int type = o.push_field(field);
        if (type != LUA_TNIL && type != LUA_TTABLE)
            o.complain(field, show(L, -1), "must be a table of groups or their names");
        const std::string list = "model:contact: field '" + std::string(field) + "'";
        const lua_Integer n = type == LUA_TTABLE ? list_length(L, -1, list) : 0;
        if (type == LUA_TTABLE && n == 0) o.complain(field, "an empty list", "no members would meet; leave it out");
        for (lua_Integer i = 1; i <= n; ++i) {
            lua_rawgeti(L, -1, i);
            rule.groups.push_back(group_argument(
                L, -1, "model:contact: field '" + std::string(field) + "', item " + std::to_string(i), *m));
            lua_pop(L, 1);
        }
        lua_pop(L, 1);
    }
    rule.between = o.has("between");
    if (rule.between && o.has("groups"))
        o.complain(
            "between", "given beside groups",
            "groups: both members are in one of them; between = { one, other }: one in each; give one of the two");
    if (rule.between && rule.groups.size() != 2)
        o.complain("between", std::to_string(rule.groups.size()) + " groups",
                   "must be two, such as { 'aircraft', 'building' }");
    if (const auto f = function_in(o, "pairs", "must be a function of two members", *m)) read_pairs(*f, m, rule);
    if (const auto f = function_in(o, "on_contact", "must be a function of an event", *m))
        rule.on_contact = telling(*f, "on_contact", m);
    if (const auto f = function_in(o, "on_release", "must be a function of an event", *m))
        rule.on_release = telling(*f, "on_release", m);
    add_contact(*m, std::move(rule));
    m->ask(contact_effect, where(L));
    return 0;
}

}  // namespace hinge::script

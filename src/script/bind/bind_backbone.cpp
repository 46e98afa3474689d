// hinge.backbone: strength of a member's ends over their plastic rotation.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/text.h"
#include "section/laws/laws.h"
#include "script/bind/material_laws.h"
#include "record/recording.h"
#include "script/bind/modules.h"
#include "script/bind/value_box.h"
#include "script/lua/model_registry.h"
#include "script/lua/options.h"

namespace hinge::script {
namespace {

constexpr double least = 0.01;  ///< of the fully plastic resultants: the strength that is always left
constexpr double drop = 0.001;  ///< rad, over which the strength falls at the ultimate rotation

using Points = std::vector<beam::Backbone::Point>;

Points read_backbone(Options& o) {
    lua_State* L = o.L();
    if (lua_type(L, -1) != LUA_TTABLE)
        o.complain("points", show(L, -1), "must be a list of points { rotation (rad), strength }");
    Points points;
    const std::string what = o.function() + ": field 'points'";
    for (lua_Integer i = 1, n = list_length(L, -1, what); i <= n; ++i) {
        const auto number = [&](int k) {
            if (lua_type(L, -1) != LUA_TTABLE) return std::nan("");
            lua_rawgeti(L, -1, k);
            const double x = lua_type(L, -1) == LUA_TNUMBER ? lua_tonumber(L, -1) : std::nan("");
            lua_pop(L, 1);
            return x;
        };
        lua_rawgeti(L, -1, i);
        const beam::Backbone::Point p{number(1), number(2)};
        lua_pop(L, 1);
        const auto refuse = [&](const std::string& need) {
            throw InputError(what + "[" + std::to_string(i) + "]: " + need);
        };
        if (!std::isfinite(p.rotation) || !std::isfinite(p.strength))
            refuse("must be { rotation (rad), strength }, the strength as a part of the fully plastic moment");
        if (points.empty() && p.rotation != 0)
            refuse("the first plastic rotation is " + show(p.rotation) + " rad; it must be 0: there the end yields");
        if (!points.empty() && !(p.rotation > points.back().rotation))
            refuse("the plastic rotation is " + show(p.rotation) + " rad; it must be more than that before, " +
                   show(points.back().rotation) + " rad");
        if (p.strength < least)
            refuse("the strength is " + show(p.strength) +
                   "; it must be 0.01 or more. A member that loses all of it "
                   "is broken: that is for a fracture rule");
        points.push_back(p);
    }
    if (points.empty()) o.complain("points", "empty", "give at least one point { 0, strength }");
    return points;
}

/// From the numbers by which hinge models are published.
Points points_of_numbers(Options& o) {
    const double yield = o.number("yield", "", Range::positive, 1),
                 at_cap = o.number("cap_rotation", "rad", Range::positive),
                 cap = o.number("cap_strength", "", Range::positive, yield),
                 residual = o.number("residual", "", Range::not_negative, 0);
    const auto fall = o.maybe_number("post_cap_rotation", "rad", Range::positive),
               ultimate = o.maybe_number("ultimate_rotation", "rad", Range::positive);
    for (const auto& [field, x] : {std::pair("yield", yield), std::pair("cap_strength", cap)})
        if (x < least) o.complain(field, show(x), "must be 0.01 or more, a part of the fully plastic moment");
    Points points = {{0, yield}, {at_cap, cap}};
    const double left = std::max(least, residual * yield);
    if (left > cap)
        o.complain("residual", show(residual), "is a part of the strength at yield, and more than cap_strength");
    if (o.has("residual") && !fall) o.complain("residual", show(residual), "needs post_cap_rotation (rad) beside it");
    const double at_residual = fall ? at_cap + *fall * (1 - left / cap) : at_cap;
    if (fall && left < cap) points.push_back({at_residual, left});
    if (ultimate) {
        if (!(*ultimate > at_cap))
            o.complain("ultimate_rotation", show(*ultimate) + " rad", "must be more than cap_rotation");
        if (*ultimate < points.back().rotation) {  // before the residual strength is reached
            points.back() = {*ultimate, cap * (1 - (*ultimate - at_cap) / *fall)};
        } else if (*ultimate > points.back().rotation) {
            points.push_back({*ultimate, points.back().strength});
        }
        if (points.back().strength > least) points.push_back({*ultimate + drop, least});
    }
    return points;
}

int backbone(lua_State* L) {
    Options o(L, 1, "hinge.backbone");
    o.expect({"points", "yield", "cap_rotation", "cap_strength", "post_cap_rotation", "residual", "ultimate_rotation",
              "wear", "stiffness_wear", "interaction"});
    beam::Backbone b;
    if (o.push_field("points") != LUA_TNIL) {
        b.points = read_backbone(o);
        for (const char* field : {"yield", "cap_rotation", "cap_strength", "post_cap_rotation", "ultimate_rotation"})
            if (o.has(field)) o.complain(field, "given beside points", "give the one or the other");
    }
    lua_pop(L, 1);
    if (b.points.empty()) b.points = points_of_numbers(o);
    b.wear = o.number("wear", "rad", Range::positive, 0);
    b.residual = o.number("residual", "", Range::not_negative, 0) * b.points.front().strength;
    b.wears_stiffness = o.flag("stiffness_wear", false);
    if (b.wears_stiffness && b.wear == 0) o.complain("stiffness_wear", "true", "needs wear (rad) beside it");
    const std::string interaction = o.word("interaction", {"any", "paper", "exact"}, "any");
    if (interaction != "any") b.interaction = interaction;
    o.finish();
    push<BackboneBox>(L, beam::backbone_law(b));
    return 1;
}

int backbone_fields(lua_State* L) {
    const beam::Backbone& b = *beam::backbone_of(*self<BackboneBox>(L, "backbone").value);
    const std::string key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
    if (key == "wear") return b.wear > 0 ? lua_pushnumber(L, b.wear) : lua_pushnil(L), 1;
    if (key == "stiffness_wear") return lua_pushboolean(L, b.wears_stiffness), 1;
    if (key == "residual")
        return b.residual > 0 ? lua_pushnumber(L, b.residual / b.points.front().strength) : lua_pushnil(L), 1;
    if (key == "interaction") return lua_pushstring(L, b.interaction.empty() ? "any" : b.interaction.c_str()), 1;
    if (key != "points")
        throw InputError("backbone has no field '" + key + "'" +
                         did_you_mean(key, {"points", "wear", "stiffness_wear", "residual", "interaction"}));
    lua_createtable(L, int(b.points.size()), 0);
    for (std::size_t i = 0; i < b.points.size(); ++i) {
        lua_createtable(L, 2, 0);
        lua_pushnumber(L, b.points[i].rotation);
        lua_rawseti(L, -2, 1);
        lua_pushnumber(L, b.points[i].strength);
        lua_rawseti(L, -2, 2);
        lua_rawseti(L, -2, lua_Integer(i) + 1);
    }
    return 1;
}

int backbone_text(lua_State* L) {
    const std::string text = self<BackboneBox>(L, "tostring").value->words();
    lua_pushlstring(L, text.data(), text.size());
    return 1;
}

int same_backbone(lua_State* L) {
    const BackboneBox *a = find<BackboneBox>(L, 1), *b = find<BackboneBox>(L, 2);
    lua_pushboolean(L, a && b && a->value == b->value);
    return 1;
}

constexpr int most_variables = 32;  ///< of the history of a law

constexpr const char* who_law = "model:member: the function in field 'law'";

/// Reads `count` numbers of the list at the top of the stack, which is taken off.
void read_numbers(lua_State* L, int count, double* out, const LuaFunction& f, const char* what) {
    bool good = lua_type(L, -1) == LUA_TTABLE;
    for (int i = 0; good && i < count; ++i) {
        lua_rawgeti(L, -1, i + 1);
        good = lua_type(L, -1) == LUA_TNUMBER && std::isfinite(out[i] = lua_tonumber(L, -1));
        lua_pop(L, 1);
    }
    if (!good)
        throw HookError(f.place() + ": " + who_law + ": the " + what + " that it returned is " + show(L, -1) +
                        "; it must be a list of " + std::to_string(count) + " finite numbers");
    lua_pop(L, 1);
}

double checked_strength(lua_State* L, const LuaFunction& f, const beam::SectionFlow& flow) {
    const double strength = lua_type(L, -1) == LUA_TNUMBER ? lua_tonumber(L, -1) : std::nan("");
    if (!(std::isfinite(strength) && strength >= least))
        throw HookError(f.place() + ": " + who_law + " returned " + show(L, -1) +
                        " at a growth of the mean plastic strain of " + show(flow.strain) +
                        "; it must return a number of 0.01 or more, the strength over the fully plastic one");
    lua_pop(L, 1);
    return strength;
}

/// The back resultants at the top of the stack, which are taken off; nil: 0.
Vec4 back_of(lua_State* L, const LuaFunction& f) {
    if (lua_isnil(L, -1)) return lua_pop(L, 1), Vec4(Vec4::Zero());
    Vec4 back;
    read_numbers(L, 4, back.data(), f, "back resultants");
    return back;
}
/// The history variables there; nil: none, as they were.
std::vector<double> history_of(lua_State* L, int variables, const LuaFunction& f) {
    if (lua_isnil(L, -1)) return lua_pop(L, 1), std::vector<double>();
    std::vector<double> out(std::size_t(variables), 0.0);
    read_numbers(L, variables, out.data(), f, "history");
    return out;
}

void push_history(lua_State* L, int variables, const double* history) {
    lua_createtable(L, variables, 0);
    for (int i = 0; i < variables; ++i) lua_pushnumber(L, history[i]), lua_rawseti(L, -2, i + 1);
}

constexpr std::pair<const char*, double beam::SectionFlow::*> flow_fields[] = {{"x", &beam::SectionFlow::x},
                                                                               {"y", &beam::SectionFlow::y},
                                                                               {"N", &beam::SectionFlow::N},
                                                                               {"z", &beam::SectionFlow::z},
                                                                               {"strain", &beam::SectionFlow::strain}};

/// One call of the function for each flow.
std::vector<beam::SectionAnswer> ask_law(const LuaFunction& f, int variables, std::span<const beam::SectionFlow> flows,
                                         const double* history) {
    lua_State* L = f.running();
    std::vector<beam::SectionAnswer> answers;
    for (const beam::SectionFlow& flow : flows) {
        f.push(L);
        lua_createtable(L, 0, int(std::size(flow_fields)) + 1);
        for (const auto& [name, field] : flow_fields) lua_pushnumber(L, flow.*field), lua_setfield(L, -2, name);
        lua_pushboolean(L, flow.at_end), lua_setfield(L, -2, "at_end");
        push_history(L, variables, history);
        call_hook(L, f, 2, 3, [] { return who_law; });
        beam::SectionAnswer answer;
        answer.history = history_of(L, variables, f);
        answer.back = back_of(L, f);
        answer.strength = checked_strength(L, f, flow);
        answers.push_back(std::move(answer));
    }
    return answers;
}

/// One call for all flows: `count`, `at_end`, and an array for each other field. It returns an array of strengths, and
/// nil or an array of back resultants, and of history variables.
std::vector<beam::SectionAnswer> ask_batch(const LuaFunction& f, int variables,
                                           std::span<const beam::SectionFlow> flows, const double* history) {
    lua_State* L = f.running();
    const int count = int(flows.size());
    f.push(L);
    lua_createtable(L, 0, int(std::size(flow_fields)) + 2);
    lua_pushinteger(L, count), lua_setfield(L, -2, "count");
    lua_pushboolean(L, flows[0].at_end), lua_setfield(L, -2, "at_end");
    for (const auto& [name, field] : flow_fields) {
        lua_createtable(L, count, 0);
        for (int i = 0; i < count; ++i) lua_pushnumber(L, flows[std::size_t(i)].*field), lua_rawseti(L, -2, i + 1);
        lua_setfield(L, -2, name);
    }
    push_history(L, variables, history);
    call_hook(L, f, 2, 3, [] { return who_law; });
    static const char* const what[] = {"strengths", "back resultants", "histories"};
    for (int i = 0; i < 3; ++i)
        if (const int type = lua_type(L, i - 3); type != LUA_TTABLE && (i == 0 || type != LUA_TNIL))
            throw HookError(f.place() + ": " + who_law + " returned " + show(L, i - 3) + " as " + what[i] +
                            "; it must be an array with an item for each flow" + (i == 0 ? "" : ", or nil"));
    std::vector<beam::SectionAnswer> answers(flows.size());
    for (int i = 0; i < count; ++i) {
        const auto item = [&](int of) {
            if (lua_isnil(L, of - 3)) lua_pushnil(L);
            else lua_rawgeti(L, of - 3, i + 1);
        };
        beam::SectionAnswer& answer = answers[std::size_t(i)];
        item(0), answer.strength = checked_strength(L, f, flows[std::size_t(i)]);
        item(1), answer.back = back_of(L, f);
        item(2), answer.history = history_of(L, variables, f);
    }
    lua_pop(L, 3);
    return answers;
}

}  // namespace

std::shared_ptr<const beam::MaterialLaw> read_own_law(Options& member, const std::shared_ptr<Model>& model) {
    lua_State* L = member.L();
    const int type = member.push_field("law");
    if (type == LUA_TNIL) return lua_pop(L, 1), nullptr;
    const auto law_of = [](LuaFunction f, int variables, bool batch = false) {
        return beam::own_law(
            [f = std::move(f), variables, batch](std::span<const beam::SectionFlow> flows, const double* history) {
                return batch ? ask_batch(f, variables, flows, history) : ask_law(f, variables, flows, history);
            },
            variables);
    };
    std::shared_ptr<const beam::MaterialLaw> law;
    if (type == LUA_TFUNCTION) {
        law = law_of(LuaFunction(L, -1, *model), 0);
    } else if (type == LUA_TTABLE) {
        Options o(L, lua_gettop(L), member.function() + ": field 'law'");
        o.expect({"variables", "step", "batch"});
        const int variables = o.integer("variables", 0, 0);
        if (variables > most_variables)
            o.complain("variables", std::to_string(variables), "must be from 0 to " + std::to_string(most_variables));
        const bool batch = o.has("batch");
        if (batch && o.has("step")) o.complain("batch", "given beside step", "give one of the two");
        if (o.push_field(batch ? "batch" : "step") != LUA_TFUNCTION)
            o.complain(batch ? "batch" : "step", show(L, -1),
                       batch ? "must be a function(flows, history) that returns an array of strengths"
                             : "must be a function(flow, history) that returns a strength");
        law = law_of(LuaFunction(L, -1, *model), variables, batch);
        lua_pop(L, 1);
        o.finish();
    } else {
        member.complain("law", show(L, -1),
                        "must be a function(flow, history), or { variables =, step = function(flow, history) }");
    }
    lua_pop(L, 1);
    return law;
}

void open_backbone(lua_State* L, int module) {
    static const luaL_Reg none[] = {{nullptr, nullptr}};
    make_metatable(L, BackboneBox::lua_name, none, guarded<backbone_fields>, collect<BackboneBox>,
                   guarded<backbone_text>, same_backbone);
    name_fields(L, BackboneBox::lua_name, {"points", "wear", "stiffness_wear", "residual", "interaction"});
    lua_pushcfunction(L, (guarded<takes<"hinge.backbone", 1, backbone>>));
    lua_setfield(L, module, "backbone");
}

}  // namespace hinge::script

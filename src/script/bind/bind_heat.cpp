// model:heat: the temperature of members. model:prestress: members that were made too short or too long.
#include <cmath>

#include "effects/heat.h"
#include "script/bind/model_methods.h"

namespace hinge::script {

namespace {

constexpr double least_left = 1e-3;  ///< of stiffness and strength: what is lost is for model:fracture

/// Points { temperature, value } of field `name` of the table on top.
HeatProperties::Points read_points(Options& o, const char* name, double smallest) {
    lua_State* L = o.L();
    const std::string what = o.function() + ": field 'properties." + name + "'";
    lua_getfield(L, -1, name);
    if (lua_type(L, -1) != LUA_TTABLE)
        throw InputError(what + " is " + show(L, -1) + "; must be a list of points { degrees Celsius, value }");
    HeatProperties::Points points;
    for (lua_Integer i = 1, n = list_length(L, -1, what); i <= n; ++i) {
        double pair[2] = {NAN, NAN};
        lua_rawgeti(L, -1, i);
        for (int k = 0; lua_istable(L, -1) && k < 2; ++k) {
            if (lua_rawgeti(L, -1, k + 1) == LUA_TNUMBER) pair[k] = lua_tonumber(L, -1);
            lua_pop(L, 1);
        }
        lua_pop(L, 1);
        const auto refuse = [&](const std::string& need) {
            throw InputError(what + "[" + std::to_string(i) + "]: " + need);
        };
        if (!std::isfinite(pair[0]) || !std::isfinite(pair[1])) refuse("must be { degrees Celsius, value }");
        if (!points.empty() && !(pair[0] > points.back().first))
            refuse("the temperature is " + show(pair[0]) + "; it must be more than that before, " +
                   show(points.back().first));
        if (!(pair[1] >= smallest))
            refuse("the value is " + show(pair[1]) + "; it must be " + show(smallest) +
                   " or more, a part of that of the declared material");
        points.push_back({pair[0], pair[1]});
    }
    lua_pop(L, 1);
    if (points.size() < 2) throw InputError(what + " has fewer than two points");
    return points;
}

/// Those of steel where none are given.
std::shared_ptr<const HeatProperties> read_properties(Options& o) {
    lua_State* L = o.L();
    if (o.push_field("properties") == LUA_TNIL) {
        lua_pop(L, 1);
        luaL_getsubtable(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
        lua_getfield(L, -1, "hinge");
        lua_getfield(L, -1, "heat");  // its file is read when it is first asked for
        lua_getfield(L, -1, "steel");
        lua_call(L, 0, 1);
        lua_replace(L, -4), lua_pop(L, 2);
    }
    if (lua_type(L, -1) != LUA_TTABLE)
        o.complain("properties", show(L, -1),
                   "must be what hinge.heat.steel() returns, or a table with 'stiffness', 'strength' and 'elongation'");
    auto properties = std::make_shared<HeatProperties>();
    properties->stiffness = read_points(o, "stiffness", least_left);
    properties->strength = read_points(o, "strength", least_left);
    properties->elongation = read_points(o, "elongation", -1);
    lua_pop(L, 1);
    if (!(properties->least() < properties->most()))
        o.complain("properties", "without a common range", "stiffness, strength and elongation must overlap");
    return properties;
}

bool is_over_time(Options& o, const char* field) {
    const int type = o.push_field(field);
    lua_pop(o.L(), 1);
    return type == LUA_TFUNCTION || type == LUA_TTABLE;
}

/// What the middle and both sides of the section may not leave.
void must_be_in_range(Options& o, const Heating& h, double temperature, const std::string& which) {
    const double half = 0.5 * std::max(std::abs(h.across[0]), std::abs(h.across[1]));
    const HeatProperties& p = *h.properties;
    if (temperature - half >= p.least() && temperature + half <= p.most()) return;
    o.complain("temperature", show(temperature) + " degrees Celsius" + which,
               "the properties are known from " + show(p.least()) + " to " + show(p.most()) +
                   (half > 0 ? ", and both sides of the section must be in that range" : ""));
}

}  // namespace

void read_members(Options& o, const ScriptModel& model, int& member, int& group) {
    lua_State* L = o.L();
    if (o.has("member") && o.has("group")) o.complain("group", "given beside member", "give one of the two");
    if (o.push_field("member") != LUA_TNIL)
        member = member_argument(L, -1, o.function() + ": field 'member'", &model).index;
    lua_pop(L, 1);
    if (o.push_field("group") != LUA_TNIL) group = group_argument(L, -1, o.function() + ": field 'group'", model);
    lua_pop(L, 1);
}

int heat_members(lua_State* L) {
    auto& model = self<ModelBox>(L, "model:heat").value;
    Options o(L, 2, "model:heat");
    o.expect({"member", "group", "temperature", "across_y", "across_x", "properties", "case"});
    Heating h;
    read_members(o, *model, h.member, h.group);
    h.properties = read_properties(o);
    const char* sides[] = {"across_y", "across_x"};
    for (int side : {0, 1}) {
        if (is_over_time(o, sides[side]))
            h.across_history[side] = read_history(o, sides[side], "difference of temperature in K", *model, false);
        else h.across[side] = o.number(sides[side], "K", Range::any, 0);
    }
    h.load_case = case_of(o, *model);
    if (is_over_time(o, "temperature")) {
        h.history = read_history(o, "temperature", "temperature in degrees Celsius", *model, false);
        if (const auto* points = h.history.points())
            for (const auto& [time, temperature] : *points)
                must_be_in_range(o, h, temperature, " at " + show(time) + " s");
    } else {
        h.temperature = o.number("temperature", "degrees Celsius", Range::any);
        must_be_in_range(o, h, h.temperature, "");
    }
    if (h.load_case >= 0 && h.varies())
        o.complain("case", "given", "is for numbers; a temperature over time acts in dynamics alone");
    const auto& members = model->members();
    for (std::size_t m = 0; m < members.size(); ++m) {
        const auto& in = members[m].groups;
        const bool heated =
            h.member >= 0 ? int(m) == h.member : h.group < 0 || std::find(in.begin(), in.end(), h.group) != in.end();
        const double size[2] = {members[m].section->depth, members[m].section->width};
        for (int side : {0, 1})
            if (heated && (h.across[side] != 0 || h.across_history[side]) && !(size[side] > 0))
                o.complain(
                    sides[side], "given",
                    "needs a section with a size: give 'size' = { width, depth } in m to the section of member " +
                        std::to_string(m + 1));
    }
    h.asked_at = where(L);
    model->declare(heat_effect, std::move(h));
    model->ask(heat_effect, where(L));
    return 0;
}

/// model:prestress { member = | group =, strain = | force =, case = }
int prestress_members(lua_State* L) {
    auto& model = self<ModelBox>(L, "model:prestress").value;
    Options o(L, 2, "model:prestress");
    o.expect({"member", "group", "strain", "force", "case"});
    Prestress p;
    read_members(o, *model, p.member, p.group);
    if (p.member < 0 && p.group < 0)
        throw InputError("model:prestress: field 'member' is missing; give a member, or group = a group");
    const auto strain = o.maybe_number("strain", "", Range::any), force = o.maybe_number("force", "N", Range::any);
    if (!strain == !force)
        throw InputError(std::string("model:prestress: ") +
                         (strain ? "both 'strain' and 'force' are" : "neither 'strain' nor 'force' is") +
                         " given; give strain, the part of its length by which the member was made too long (below 0: "
                         "too short), or force (N), which it would have between ends that do not move");
    p.strain = strain.value_or(0), p.force = force.value_or(0);
    if (std::abs(p.strain) > 0.1) o.complain("strain", show(p.strain), "must be between -0.1 and 0.1");
    p.load_case = case_of(o, *model);
    model->declare(prestress_effect, p);
    model->ask(prestress_effect, where(L));
    return 0;
}

}  // namespace hinge::script

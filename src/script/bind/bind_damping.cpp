// model:damping: Rayleigh damping, by its coefficients or by ratios at two periods.
#include "effects/damping.h"
#include "script/bind/model_methods.h"

namespace hinge::script {
namespace {

/// The two numbers of the list in a field; `may_be_one`: a number in its place stands for both.
void read_two(Options& o, const char* field, const char* unit, bool may_be_one, double (&to)[2]) {
    lua_State* L = o.L();
    const std::string list = may_be_one ? "must be a number or two, such as 0.02 or { 0.02, 0.05 }"
                                        : "must be two numbers in " + std::string(unit) + ", such as { 1.2, 0.1 }";
    const int type = o.push_field(field);
    const std::string shown = show(L, -1);
    if (may_be_one && type == LUA_TNUMBER) {
        to[0] = to[1] = lua_tonumber(L, -1);
    } else {
        if (type == LUA_TTABLE) list_length(L, -1, o.function() + ": field '" + field + "'");
        if (type != LUA_TTABLE || lua_rawlen(L, -1) != 2) lua_pop(L, 1), o.complain(field, shown, list);
        for (int i : {0, 1}) {
            const bool number = lua_rawgeti(L, -1, i + 1) == LUA_TNUMBER;
            to[i] = lua_tonumber(L, -1);
            const std::string item = show(L, -1);
            lua_pop(L, 1);
            if (!number) lua_pop(L, 1), o.complain(field, "{ ..., " + item + ", ... }", list);
        }
    }
    lua_pop(L, 1);
}

std::string with(double value, const char* unit) { return show(value) + (*unit ? " " : "") + unit; }

/// Both of `ratio` and `periods`, in the place of the coefficients.
Damping read_ratios(Options& o) {
    for (const char* field : {"alpha", "beta"})
        if (o.has(field)) o.complain(field, "given", "give alpha and beta, or ratio and periods, not both");
    if (!o.has("periods"))
        o.complain("periods", "missing", "must be the two periods in s at which the ratio holds, such as { 1.2, 0.1 }");
    if (!o.has("ratio"))
        o.complain("ratio", "missing", "must be the part of critical damping at the two periods, such as 0.02");
    double ratio[2], period[2];
    read_two(o, "ratio", "", true, ratio);
    read_two(o, "periods", "s", false, period);
    for (double z : ratio)
        if (!(z >= 0 && z < 1))
            o.complain("ratio", show(z), "must be a part of critical damping, at least 0 and below 1, such as 0.02");
    for (double T : period)
        if (!(T > 0 && std::isfinite(T))) o.complain("periods", with(T, "s"), "must be positive numbers in s");
    if (period[0] == period[1] && ratio[0] != ratio[1])
        o.complain("periods", "twice " + with(period[0], "s"), "two ratios need two periods that differ");
    Damping d = rayleigh(ratio, period);
    if (!std::isfinite(d.alpha) || !std::isfinite(d.beta))
        o.complain("periods", "{ " + show(period[0]) + ", " + show(period[1]) + " } s",
                   "the coefficients that follow from them are not finite");
    if (d.alpha < 0 || d.beta < 0)
        o.complain("ratio", "{ " + show(ratio[0]) + ", " + show(ratio[1]) + " }",
                   "at these periods they ask for alpha = " + with(d.alpha, "1/s") + ", beta = " + with(d.beta, "s") +
                       ", and a negative one would add energy; bring the ratios or the periods closer to each other");
    for (int i : {0, 1}) d.ratio[i] = ratio[i], d.period[i] = period[i];
    return d;
}

}  // namespace

int add_damping(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:damping").value;
    Options o(L, 2, "model:damping");
    o.expect({"alpha", "beta", "ratio", "periods", "group", "joints"});
    Damping d;
    if (o.has("ratio") || o.has("periods")) {
        d = read_ratios(o);
    } else {
        if (!o.has("alpha") && !o.has("beta"))
            throw InputError(
                "model:damping: none of 'alpha', 'beta', 'ratio' is given; give alpha in 1/s and beta in s, or ratio "
                "and periods");
        d.alpha = o.number("alpha", "1/s", Range::not_negative, 0);
        d.beta = o.number("beta", "s", Range::not_negative, 0);
    }
    if (o.push_field("group") != LUA_TNIL) d.group = group_argument(L, -1, "model:damping: field 'group'", *m);
    lua_pop(L, 1);
    d.joints = o.flag("joints", true);
    m->declare(damping_effect, d);
    m->ask(damping_effect, where(L));
    lua_pushnumber(L, d.alpha);
    lua_pushnumber(L, d.beta);
    return 2;
}

}  // namespace hinge::script

#include "script/lua/options.h"

#include <algorithm>
#include <cmath>

#include "script/lua/probe_list.h"

namespace hinge::script {

Options::Options(lua_State* L, int index, std::string function, bool may_be_absent)
    : L_(L), index_(lua_absindex(L, index)), function_(std::move(function)) {
    if (lua_isnoneornil(L, index) && may_be_absent) index_ = 0;
    else if (!lua_istable(L, index)) throw InputError(function_ + ": takes a table of options, got " + show(L, index));
}

void Options::complain(const std::string& field, const std::string& value, const std::string& allowed) const {
    throw FieldError(function_, field, value + "; " + allowed);
}

int Options::push_field(const char* field) {
    known_.push_back(field);
    if (index_ == 0) return lua_pushnil(L_), LUA_TNIL;
    lua_pushstring(L_, field);
    return lua_rawget(L_, index_);
}

int Options::push_item(int i) {
    if (index_ == 0) return lua_pushnil(L_), LUA_TNIL;
    return lua_rawgeti(L_, index_, i);
}

bool Options::has(const char* field) {
    const bool there = push_field(field) != LUA_TNIL;
    lua_pop(L_, 1);
    return there;
}

std::optional<double> Options::read_number(const char* field, const char* unit, Range range) {
    const int type = push_field(field);
    if (type == LUA_TNIL) return lua_pop(L_, 1), std::nullopt;
    const std::string u = *unit ? std::string(" ") + unit : "", text = show(L_, -1);
    if (type != LUA_TNUMBER) {
        lua_pop(L_, 1);
        complain(field, text, "must be a number" + (*unit ? std::string(" in ") + unit : ""));
    }
    const double v = lua_tonumber(L_, -1);
    lua_pop(L_, 1);
    if (std::isnan(v))
        complain(field, "not a number (nan)", "must be a finite number" + (*unit ? std::string(" in ") + unit : ""));
    if (!std::isfinite(v)) complain(field, text + u, "must be finite");
    if (range == Range::positive && !(v > 0)) complain(field, text + u, "must be above 0" + u);
    if (range == Range::not_negative && !(v >= 0)) complain(field, text + u, "must be 0" + u + " or above");
    return v;
}

double Options::number(const char* field, const char* unit, Range range) {
    if (const auto v = read_number(field, unit, range)) return *v;
    throw InputError(function_ + ": field '" + std::string(field) + "' is missing; give a number" +
                     (*unit ? std::string(" in ") + unit : ""));
}

double Options::number(const char* field, const char* unit, Range range, double fallback) {
    return read_number(field, unit, range).value_or(fallback);
}
std::optional<double> Options::maybe_number(const char* field, const char* unit, Range range) {
    return read_number(field, unit, range);
}

int Options::integer(const char* field, int least, int fallback) {
    const auto v = read_number(field, "", Range::any);
    if (!v) return fallback;
    if (*v != std::floor(*v) || *v < least || *v > 2e9)
        complain(field, show(*v), "must be a whole number, " + std::to_string(least) + " or above");
    return int(*v);
}

bool Options::flag(const char* field, bool fallback) {
    const int type = push_field(field);
    const std::string text = show(L_, -1);
    const bool value = lua_toboolean(L_, -1);
    lua_pop(L_, 1);
    if (type == LUA_TNIL) return fallback;
    if (type != LUA_TBOOLEAN) complain(field, text, "must be true or false");
    return value;
}

std::optional<Vec3> Options::triple(const char* field, const char* unit) {
    if (push_field(field) == LUA_TNIL) return lua_pop(L_, 1), std::nullopt;
    const Vec3 v = read_triple(L_, -1, function_ + ": field '" + field + "'", unit);
    lua_pop(L_, 1);
    return v;
}

Mat3 Options::axes(const char* field) {
    Mat3 axes = Mat3::Identity();
    const int type = push_field(field);
    if (type == LUA_TTABLE) {
        const std::string what = function_ + ": field '" + field + "'";
        Options given(L_, lua_gettop(L_), what);
        given.expect({"x", "y"});
        const Vec3 x = given.triple("x", "").value_or(Vec3(Vec3::Zero())),
                   y = given.triple("y", "").value_or(Vec3(Vec3::Zero()));
        const Vec3 z = x.cross(y);
        if (!(z.norm() > 1e-6 * x.norm() * y.norm()))
            throw InputError(what +
                             ": x and y must both be given, and not along one line: x is kept, y is taken square to "
                             "it, and z is square to both");
        axes.col(0) = x.normalized();
        axes.col(2) = z.normalized();
        axes.col(1) = axes.col(2).cross(axes.col(0));
    } else if (type != LUA_TNIL) {
        complain(field, show(L_, -1), "must be { x = {x, y, z}, y = {x, y, z} }");
    }
    lua_pop(L_, 1);
    return axes;
}

std::optional<std::string> Options::text(const char* field) {
    const int type = push_field(field);
    const std::string shown = show(L_, -1);
    const std::string value = type == LUA_TSTRING ? lua_tostring(L_, -1) : "";
    lua_pop(L_, 1);
    if (type == LUA_TNIL) return std::nullopt;
    if (type != LUA_TSTRING) complain(field, shown, "must be a string");
    return value;
}

std::string Options::word(const char* field, const std::vector<std::string>& allowed, const std::string& fallback) {
    const auto value = text(field);
    if (!value) return fallback;
    if (std::find(allowed.begin(), allowed.end(), *value) != allowed.end()) return *value;
    std::string list;
    for (const auto& a : allowed) list += (list.empty() ? "'" : ", '") + a + "'";
    complain(field, "'" + *value + "'", "must be one of " + list + did_you_mean(*value, allowed));
}

void Options::finish(int items_allowed) {
    if (index_ == 0) return;
    std::string problem;
    lua_pushnil(L_);
    while (lua_next(L_, index_)) {
        lua_pop(L_, 1);
        if (lua_type(L_, -1) == LUA_TSTRING) {
            const std::string key = lua_tostring(L_, -1);
            if (std::find(known_.begin(), known_.end(), key) == known_.end()) {
                std::string list;
                for (const auto& k : known_) list += (list.empty() ? "" : ", ") + k;
                problem =
                    function_ + ": unknown field '" + key + "'" + did_you_mean(key, known_) + "; it takes " + list;
            }
        } else if (const double i = lua_type(L_, -1) == LUA_TNUMBER ? lua_tonumber(L_, -1) : -1;
                   !(i >= 1 && i <= items_allowed)) {
            problem = function_ + ": item [" + show(L_, -1) + "] is not expected";
        }
        if (!problem.empty()) {
            lua_pop(L_, 1);
            throw InputError(problem);
        }
    }
}

Vec3 read_triple(lua_State* L, int index, const std::string& what, const char* unit) {
    index = lua_absindex(L, index);
    const std::string u = *unit ? std::string(" in ") + unit : "";
    if (!lua_istable(L, index)) throw InputError(what + " is " + show(L, index) + "; must be a table {x, y, z}" + u);
    Vec3 v;
    for (int i = 0; i < 3; ++i) {
        const int type = lua_rawgeti(L, index, i + 1);
        const std::string text = show(L, -1);
        v[i] = lua_tonumber(L, -1);
        lua_pop(L, 1);
        if (type != LUA_TNUMBER)
            throw InputError(what + ": component " + std::string(1, "xyz"[i]) + " is " + text + "; must be a number" +
                             u);
        if (!std::isfinite(v[i]))
            throw InputError(what + ": component " + std::string(1, "xyz"[i]) + " is " +
                             (std::isnan(v[i]) ? "not a number (nan)" : text) + "; must be finite");
    }
    if (lua_rawlen(L, index) > 3)
        throw InputError(what + " has " + std::to_string(lua_rawlen(L, index)) + " items; must be {x, y, z}" + u);
    lua_pushnil(L);
    while (lua_next(L, index)) {
        lua_pop(L, 1);
        if (lua_isinteger(L, -1) && lua_tointeger(L, -1) >= 1 && lua_tointeger(L, -1) <= 3) continue;
        throw InputError(what + " has " + (lua_type(L, -1) == LUA_TSTRING ? "a field " : "an item ") + show(L, -1) +
                         "; must be {x, y, z}" + u + " and nothing else");
    }
    return v;
}

std::vector<double> numbers_in(lua_State* L, lua_Integer i, int count) {
    std::vector<double> numbers(count, NAN);
    lua_rawgeti(L, -1, i);
    for (int k = 0; lua_istable(L, -1) && k < count; ++k) {
        if (lua_rawgeti(L, -1, k + 1) == LUA_TNUMBER) numbers[k] = lua_tonumber(L, -1);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return numbers;
}

lua_Integer list_length(lua_State* L, int index, const std::string& what) {
    index = lua_absindex(L, index);
    fill_probe_list(L, index);
    const lua_Integer n = lua_Integer(lua_rawlen(L, index));
    lua_Integer found = 0;
    lua_pushnil(L);
    while (lua_next(L, index)) {
        lua_pop(L, 1);
        if (!lua_isinteger(L, -1) || lua_tointeger(L, -1) < 1 || lua_tointeger(L, -1) > n)
            throw InputError(what + " holds " + (lua_type(L, -1) == LUA_TSTRING ? "a field " : "an item ") +
                             show(L, -1) + ", which is not one of its items 1 to " + std::to_string(n));
        ++found;
    }
    if (found != n)
        throw InputError(what + " has " + std::to_string(n - found) + " of its " + std::to_string(n) +
                         " items missing (nil)");
    return n;
}

}  // namespace hinge::script

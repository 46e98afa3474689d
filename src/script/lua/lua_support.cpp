#include "script/lua/lua_support.h"

#include "script/bind/probe_list.h"

#include <algorithm>
#include <cctype>
#include <cstring>

#include "core/files.h"
#include "script/lua/interrupts.h"

namespace hinge::script {
namespace {

const char library_key = 0;

std::string library_folder(lua_State* L) {
    lua_rawgetp(L, LUA_REGISTRYINDEX, &library_key);
    const char* text = lua_tostring(L, -1);
    std::string folder = text ? text : "";
    lua_pop(L, 1);
    return folder;
}

}  // namespace

void set_library_folder(lua_State* L, const std::string& folder) {
    lua_pushlstring(L, folder.data(), folder.size());
    lua_rawsetp(L, LUA_REGISTRYINDEX, &library_key);
}

std::string where(lua_State* L) {
    const std::string library = "@" + library_folder(L);
    lua_Debug frame;
    for (int level = 0; lua_getstack(L, level, &frame); ++level) {
        if (!lua_getinfo(L, "Sl", &frame) || frame.currentline <= 0) continue;
        if (library.size() > 1 && std::strncmp(frame.source, library.c_str(), library.size()) == 0) continue;
        return std::string(frame.short_src) + ":" + std::to_string(frame.currentline);
    }
    return "";
}

namespace {

/// Leaves what was caught on the stack as a Lua error's value.
void explain_caught(lua_State* L) {
    std::string message;
    try {
        throw;
    } catch (const LuaErrorOnStack&) {
        return;
    } catch (const std::length_error&) {  // more of something than there can be
        throw std::bad_alloc();
    } catch (const std::bad_alloc&) { throw; } catch (const HookError& e) {
        message = e.what();
        note_error(L, message, "hook");
    } catch (const Interrupted& e) {
        message = *e.what() ? e.what() : ended_halfway(L);
        note_error(L, message, "interrupted");
    } catch (const WriteError& e) {
        message = e.what();
        note_error(L, message, "outside", e.path, e.why);
    } catch (const OutsideError& e) {
        message = e.what();
        note_error(L, message, "outside");
    } catch (const std::exception& e) {
        message = e.what();
        const std::string place = where(L);
        if (!place.empty()) message = place + ": " + message;
        const auto* field = dynamic_cast<const FieldError*>(&e);
        note_error(L, message, "input", field ? field->field : "", field ? field->why : "");
    }
    lua_pushlstring(L, message.data(), message.size());
}

}  // namespace

int guarded_call(lua_State* L, Body body) {
    try {
        return body(L);
    } catch (...) {
        try {
            explain_caught(L);
        } catch (...) {
            ::lua_pushstring(L, "not enough memory");  // Lua has this one ready, and knows it for what it is
        }
    }
    return lua_error(L);
}

namespace {

/// Small letters, without blanks, hyphens and underscores.
std::string plain(const std::string& word) {
    std::string letters;
    for (unsigned char c : word)
        if (!std::isspace(c) && c != '_' && c != '-') letters += char(std::tolower(c));
    return letters;
}

/// Letters to change, add, leave out or swap with their neighbour.
std::size_t distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before.swap(last), last.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({row[j - 1] + 1, last[j] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row[b.size()];
}

}  // namespace

std::string did_you_mean(const std::string& typed, const std::vector<std::string>& names) {
    const std::string word = plain(typed);
    const std::string* best = nullptr;
    std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string& n : names) {
        const std::string name = plain(n);
        if (const std::size_t d = distance(word, name); d < least && d < name.size()) least = d, best = &n;
    }
    return best ? " (did you mean '" + *best + "'?)" : "";
}

std::string show(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.10g", value);
    return text;
}

std::string show(lua_State* L, int index) {
    switch (lua_type(L, index)) {
        case LUA_TNONE:
        case LUA_TNIL: return "nil";
        case LUA_TBOOLEAN: return lua_toboolean(L, index) ? "true" : "false";
        case LUA_TNUMBER: return show(lua_tonumber(L, index));
        case LUA_TSTRING: return "'" + std::string(lua_tostring(L, index)) + "'";
        case LUA_TTABLE: return "a table";
        case LUA_TFUNCTION: return "a function";
        case LUA_TUSERDATA:
            if (luaL_getmetafield(L, index, "__name") == LUA_TSTRING) {
                std::string name = lua_tostring(L, -1);
                lua_pop(L, 1);
                return "a " + name;
            }
            return "a userdata";
        default: return std::string("a ") + luaL_typename(L, index);
    }
}

int taking(lua_State* L, const char* name, int most, Body body) {
    const int own = std::strchr(name, ':') ? most - 1 : most;
    for (int i = most + 1; i <= lua_gettop(L); ++i)
        if (!lua_isnil(L, i))
            throw InputError(std::string(name) + ": takes " +
                             (own == 0   ? "no argument"
                              : own == 1 ? "one argument"
                                         : std::to_string(own) + " arguments") +
                             ", got also " + show(L, i) +
                             (own == 1 && lua_isnumber(L, i) && lua_isnumber(L, i + 1)
                                  ? "; several numbers go into one table, { x, y, z }"
                                  : ""));
    return body(L);
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

void make_metatable(lua_State* L, const char* name, const luaL_Reg* methods, lua_CFunction fields, lua_CFunction gc,
                    lua_CFunction to_string, lua_CFunction equal) {
    luaL_newmetatable(L, name);
    const auto set = [&](const char* event, lua_CFunction f) {
        if (f) lua_pushcfunction(L, f), lua_setfield(L, -2, event);
    };
    set("__gc", gc);
    set("__tostring", to_string);
    set("__eq", equal);
    lua_newtable(L);
    luaL_setfuncs(L, methods, 0);
    lua_pushvalue(L, -1);
    lua_setfield(L, -3, "methods");
    if (fields) {
        lua_pushcclosure(L, fields, 1);  // the methods are its upvalue
    }
    lua_setfield(L, -2, "__index");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_pop(L, 1);
}

void add_methods(lua_State* L, const char* name, const luaL_Reg* methods) {
    luaL_getmetatable(L, name);
    lua_getfield(L, -1, "methods");
    luaL_setfuncs(L, methods, 0);
    lua_pop(L, 2);
}

std::string key_argument(lua_State* L) { return lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : show(L, 2); }

bool push_method(lua_State* L) {
    lua_pushvalue(L, 2);
    if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) return true;
    lua_pop(L, 1);
    return false;
}

void refuse_field(lua_State* L, const char* object, const std::string& key) {
    std::vector<std::string> names;
    if (luaL_getmetafield(L, 1, "fields") == LUA_TTABLE)
        for (lua_Integer i = 1, n = lua_rawlen(L, -1); i <= n; ++i) {
            lua_rawgeti(L, -1, i);
            names.push_back(lua_tostring(L, -1));
            lua_pop(L, 1);
        }
    const auto methods = names.size();
    lua_pushnil(L);
    while (lua_next(L, lua_upvalueindex(1))) {
        lua_pop(L, 1);
        names.push_back(lua_tostring(L, -1));
    }
    std::sort(names.begin() + long(methods), names.end());
    std::string list;
    for (const auto& n : names) list += (list.empty() ? "" : ", ") + n;
    throw InputError(std::string(object) + " has no field or method '" + key + "'" + did_you_mean(key, names) +
                     "; it has " + list);
}

void name_fields(lua_State* L, const char* name, const std::vector<const char*>& fields) {
    luaL_getmetatable(L, name);
    lua_newtable(L);
    for (const char* field : fields) lua_pushstring(L, field), lua_rawseti(L, -2, lua_Integer(lua_rawlen(L, -2)) + 1);
    lua_setfield(L, -2, "fields");
    lua_pop(L, 1);
}

Options::Options(lua_State* L, int index, std::string function, bool may_be_absent)
    : L_(L), index_(lua_absindex(L, index)), function_(std::move(function)) {
    if (lua_isnoneornil(L, index) && may_be_absent) index_ = 0;
    else if (!lua_istable(L, index)) throw InputError(function_ + ": takes a table of options, got " + show(L, index));
}

void Options::complain(const std::string& field, const std::string& value, const std::string& allowed) const {
    throw FieldError(function_ + ": field '" + field + "' is ", field, value + "; " + allowed);
}

int Options::push_field(const char* field) {
    known_.push_back(field);
    if (index_ == 0) return lua_pushnil(L_), LUA_TNIL;
    lua_pushstring(L_, field);
    if (const int type = lua_rawget(L_, index_); type != LUA_TNIL) return type;
    for (const auto& [name, before] : former_)
        if (name == field) return lua_pop(L_, 1), lua_pushstring(L_, before.c_str()), lua_rawget(L_, index_);
    return LUA_TNIL;
}

void Options::former_name(const char* field, const char* before) {
    if (index_ == 0) return;
    const bool now = has(field);
    lua_pushstring(L_, before);
    const bool then = lua_rawget(L_, index_) != LUA_TNIL;
    lua_pop(L_, 1);
    if (now && then)
        throw InputError(function_ + ": field '" + before + "' is the older name of '" + field +
                         "', and both are given; leave it out");
    former_.emplace_back(field, before);
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
    const auto former = former_words_.find(field);
    if (former != former_words_.end() && former->second.second == *value) return former->second.first;
    std::string list;
    for (const auto& a : allowed) list += (list.empty() ? "'" : ", '") + a + "'";
    complain(field, "'" + *value + "'", "must be one of " + list + did_you_mean(*value, allowed));
}

void Options::former_word(const char* field, const char* word, const char* before) {
    former_words_[field] = {word, before};
}

void Options::finish(int items_allowed) {
    if (index_ == 0) return;
    std::string problem;
    lua_pushnil(L_);
    while (lua_next(L_, index_)) {
        lua_pop(L_, 1);
        if (lua_type(L_, -1) == LUA_TSTRING) {
            const std::string key = lua_tostring(L_, -1);
            const bool former =
                std::any_of(former_.begin(), former_.end(), [&](const auto& f) { return f.second == key; });
            if (!former && std::find(known_.begin(), known_.end(), key) == known_.end()) {
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

void push_array(lua_State* L, const double* values, int n) {
    lua_createtable(L, n, 0);
    for (int i = 0; i < n; ++i) {
        lua_pushnumber(L, values[i]);
        ::lua_rawseti(L, -2, i + 1);
    }
}

}  // namespace hinge::script

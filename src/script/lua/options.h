// Arguments of a script's calls: tables of named options, lists and triples of numbers.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "core/suggestion.h"
#include "core/types.h"
#include "script/lua/lua_support.h"

namespace hinge::script {

enum class Range { any, positive, not_negative };

/// Reads a table of named options; every complaint names function, field, value, unit and what is allowed.
class Options {
public:
    /// `index`: the table; absent is an empty table when `may_be_absent`.
    Options(lua_State* L, int index, std::string function, bool may_be_absent = false);

    double number(const char* field, const char* unit, Range range);  ///< must be there
    double number(const char* field, const char* unit, Range range, double fallback);
    std::optional<double> maybe_number(const char* field, const char* unit, Range range);
    int integer(const char* field, int least, int fallback);
    bool flag(const char* field, bool fallback);
    std::optional<Vec3> triple(const char* field, const char* unit);
    std::optional<std::string> text(const char* field);
    /// One of the given words.
    std::string word(const char* field, const std::vector<std::string>& allowed, const std::string& fallback);
    /// { x = {x, y, z}, y = {x, y, z} }: unit vectors, x as given, y made square to it. Columns x y z; absent: global.
    Mat3 axes(const char* field);
    bool has(const char* field);
    /// Pushes the field's raw value (nil if absent) and counts it as known.
    int push_field(const char* field);
    int push_item(int i);
    /// A field that is a table of options: read(them). `such_as`: an example of it, for the error. False where it is
    /// not given.
    template <class F>
    bool read_table(const char* field, const char* such_as, F read) {
        const int type = push_field(field);
        if (type == LUA_TTABLE) {
            Options inner(L_, lua_gettop(L_), function_ + ": field '" + field + "'");
            read(inner);
        } else if (type != LUA_TNIL) {
            complain(field, show(L_, -1), std::string("must be a table, such as ") + such_as);
        }
        lua_pop(L_, 1);
        return type == LUA_TTABLE;
    }
    /// Raises an error for a field that is none of these, before any missing field is reported.
    void expect(std::vector<std::string> fields, int items_allowed = 0) {
        known_ = std::move(fields), finish(items_allowed);
    }
    /// Raises an error for a field that was never read.
    void finish(int items_allowed = 0);

    [[noreturn]] void complain(const std::string& field, const std::string& value, const std::string& allowed) const;
    const std::string& function() const { return function_; }
    lua_State* L() const { return L_; }

private:
    std::optional<double> read_number(const char* field, const char* unit, Range range);
    lua_State* L_;
    int index_;  // 0: absent
    std::string function_;
    std::vector<std::string> known_;
};

/// Reads {x, y, z} at `index`, or throws naming `what`.
Vec3 read_triple(lua_State* L, int index, const std::string& what, const char* unit);

/// The number of items of the list at `index`: a table with items 1 to n and nothing else, or it throws naming `what`.
lua_Integer list_length(lua_State* L, int index, const std::string& what);
/// The first `count` numbers of the list at place i of the list on top of the stack; not a number where there is none.
std::vector<double> numbers_in(lua_State* L, lua_Integer i, int count);

}  // namespace hinge::script

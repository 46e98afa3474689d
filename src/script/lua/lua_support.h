// The boundary to Lua: errors, values from scripts, and C++ objects in userdata.
//
// Lua's errors are longjmps, so none may start while a C++ destructor is pending. Every function that Lua calls is
// wrapped by `guarded`: it catches C++ exceptions, leaves the catch, and only then raises. Inside, arguments are read
// with calls that do not raise, wrong input is thrown as InputError, and lua_calls.h has Lua's lack of memory thrown as
// std::bad_alloc.
#pragma once

#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "core/errors.h"
#include "core/types.h"
#include "script/lua/lua_calls.h"

namespace hinge::script {

/// Runs body(L) and turns what it throws into a Lua error at the script's own line.
using Body = int (*)(lua_State*);
int guarded_call(lua_State* L, Body body);
template <Body body>
int guarded(lua_State* L) {
    return guarded_call(L, body);
}

/// "script.lua:12" for the innermost level outside the hinge library, or "" when there is none.
std::string where(lua_State* L);

/// Stores the kind of error of a message (see core.error_kind), and what it is about: the file that could not be
/// written, or the field of wrong input.
void note_error(lua_State* L, const std::string& message, const char* kind, const std::string& about = "",
                const std::string& why = "");

/// The folder of the Lua library; its chunks are skipped by `where`.
void set_library_folder(lua_State* L, const std::string& folder);

std::string show(lua_State* L, int index);  ///< a value as an error message shows it
std::string show(double value);

// ---- objects ------------------------------------------------------------------------------------------------------

/// The T in the userdata at `index`, or null. T declares `static constexpr const char* lua_name`.
template <class T>
T* find(lua_State* L, int index) {
    return static_cast<T*>(luaL_testudata(L, index, T::lua_name));
}

template <class T, class... Args>
T* push(lua_State* L, Args&&... args) {
    void* room = lua_newuserdatauv(L, sizeof(T), 1);
    T* object = new (room) T{std::forward<Args>(args)...};
    luaL_setmetatable(L, T::lua_name);
    return object;
}

/// Destroys the T of a userdata, which no function accepts after that: a script may call this by hand
/// (debug.getmetatable), or a finalizer revive the userdata.
template <class T>
int collect(lua_State* L) {
    T* object = find<T>(L, 1);
    if (!object) return 0;
    lua_pushnil(L);
    lua_setmetatable(L, 1);
    object->~T();
    return 0;
}

/// Raises an error if the object of a handle is gone; model_box.h defines it for the handles.
inline void refuse_gone(const auto&, const std::string&) {}

template <class T>
T& self_or_gone(lua_State* L, const std::string& function) {
    if (T* object = find<T>(L, 1)) return *object;
    throw InputError(function + ": called on " + show(L, 1) + "; write object" +
                     (function.find(':') != std::string::npos ? ":method(...)" : ".field") + " on a " + T::lua_name);
}

template <class T>
T& self(lua_State* L, const std::string& function) {
    T& object = self_or_gone<T>(L, function);
    refuse_gone(object, function);
    return object;
}

/// Makes T's metatable with methods, __gc, __index falling back from methods to `fields`.
void make_metatable(lua_State* L, const char* name, const luaL_Reg* methods, lua_CFunction fields,
                    lua_CFunction collect, lua_CFunction to_string, lua_CFunction equal);

/// Registers the fields of its objects, for refuse_field, Tab at the prompt, and the test of lua/hinge/words.
void name_fields(lua_State* L, const char* name, const std::vector<const char*>& fields);
/// Methods for a metatable that make_metatable made.
void add_methods(lua_State* L, const char* name, const luaL_Reg* methods);

/// For a metatable's `fields`: the key as text; true if it is a method, which is then pushed; and the error if it is
/// neither.
std::string key_argument(lua_State* L);
bool push_method(lua_State* L);
[[noreturn]] void refuse_field(lua_State* L, const char* object, const std::string& key);

/// Calls body; refuses more than `most` arguments (an object with its `:` counts).
int taking(lua_State* L, const char* name, int most, Body body);
template <std::size_t n>
struct Name {
    char text[n];
    constexpr Name(const char (&from)[n]) {
        for (std::size_t i = 0; i < n; ++i) text[i] = from[i];
    }
};
template <Name name, int most, Body body>
int takes(lua_State* L) {
    return taking(L, name.text, most, body);
}

void push_array(lua_State* L, const double* values, int n);

}  // namespace hinge::script

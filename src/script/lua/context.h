// The context in which a script runs: one per Lua state.
#pragma once

#include <csignal>
#include <memory>
#include <string>

#include "record/context.h"
#include "script/lua/lua_support.h"

namespace hinge::script {

struct ScriptContext : Context {
    /// Ctrl-C and SIGTERM.
    struct Signals {
        volatile std::sig_atomic_t interrupted = 0;  ///< the signal that came: the run under way ends with an error
        bool ends_on_signals = false;                ///< the program ends as well; false: the prompt goes on
        int exit_status = 3;  ///< after such an end: 3 with a checkpoint written, else 128 and the signal
    };
    /// The error that the engine raised last, to tell its kind from its text.
    struct Errors {
        std::string last;
        const char* kind = "";   ///< "input", "outside", "interrupted", "hook"
        std::string about, why;  ///< the file that could not be written, or the field of wrong input; why; else ""
    };
    lua_State* running = nullptr;  ///< the thread that entered the engine last; hooks are called on it
    std::string library;           ///< folder of the Lua library
    std::string picture_module;    ///< path of the output module
    Signals signals;
    Errors errors;
    std::size_t unseen = 0;  ///< bytes that objects took outside Lua since the last full collection
};
std::shared_ptr<ScriptContext> context(lua_State* L);  ///< throws InputError while Lua is being closed
bool has_context(lua_State* L);
void set_context(lua_State* L, std::shared_ptr<ScriptContext> c);

/// Lua's collector sees a handle, not the megabytes behind it: each 16 MB that new objects took outside Lua make it
/// collect all.
void tell_collector(lua_State* L, std::size_t bytes);

}  // namespace hinge::script

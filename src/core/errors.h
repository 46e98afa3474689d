// Exceptions of the engine, by source of the error: input, system, script function, interrupt.
#pragma once

#include <stdexcept>
#include <string>

namespace hinge {

/// Wrong input: the message names field, value, unit and what is allowed. Raised at the script's line.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Wrong value of a field of `what`: "what: field 'depth' is 0 m; must be above 0 m".
struct FieldError : InputError {
    FieldError(const std::string& what, const std::string& its_field, const std::string& its_why)
        : InputError(what + ": field '" + its_field + "' is " + its_why), field(its_field), why(its_why) {}
    std::string field, why;
};

/// A system call failed (a full disk, an unreadable file). The message names a remedy.
struct OutsideError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A script's function failed inside a step; the step is undone. The message is Lua's own, with its line.
struct HookError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The program was interrupted (Ctrl-C, SIGTERM). The message gives the progress of the run and how to resume it.
struct Interrupted : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace hinge

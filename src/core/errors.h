// What went wrong, told apart by whose fault it is.
#pragma once

#include <stdexcept>
#include <string>

namespace hinge {

/// Wrong input: the message names field, value, unit and what is allowed. Raised at the script's line.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The world outside failed (a full disk, an unreadable file). The message says what to do next.
struct OutsideError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A script's function failed inside a step; the step is undone. The message is Lua's own, with its line.
struct HookError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Somebody asked the program to end (Ctrl-C, SIGTERM). The message says how far the run is and how to go on.
struct Interrupted : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace hinge

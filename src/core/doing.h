// Names the long operation under way, for the message after an interrupt (Ctrl-C, SIGTERM).
#pragma once

#include <csignal>

namespace hinge {

/// Marks, for its lifetime, an operation of the script's thread during which interrupts are not checked.
class Doing {
public:
    /// `operation`: its name, which must outlive the mark; `amount` and `unit`: of the work, 0 for none.
    explicit Doing(const char* operation, long amount = 0, const char* unit = "")
        : what(operation), of(unit), size(amount), outer_(now) {
        now = this;
    }
    ~Doing() { now = outer_; }
    Doing(const Doing&) = delete;
    Doing& operator=(const Doing&) = delete;

    const char *const what, *const of;
    const long size;
    static inline const Doing* volatile now = nullptr;  ///< the innermost operation under way, or null

private:
    const Doing* const outer_;
};

/// The signal that asked the program to end, 0 for none. Operations that can be abandoned then throw Interrupted.
inline volatile std::sig_atomic_t asked_to_end = 0;

}  // namespace hinge

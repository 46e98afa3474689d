// What takes long just now, for whoever asks the program to end meanwhile.
#pragma once

#include <csignal>

namespace hinge {

/// While it lives, the script's thread is busy with this and does not look whether it is to end.
class Doing {
public:
    /// `what` outlives it; `size` of how many `of`, 0 for none.
    explicit Doing(const char* what, long size = 0, const char* of = "") : what(what), of(of), size(size), outer_(now) {
        now = this;
    }
    ~Doing() { now = outer_; }
    Doing(const Doing&) = delete;
    Doing& operator=(const Doing&) = delete;

    const char *const what, *const of;
    const long size;
    static inline const Doing* volatile now = nullptr;  ///< the innermost

private:
    const Doing* const outer_;
};

/// The signal that asks the program to end, 0 for none. Work that may be left halfway ends then with Interrupted.
inline volatile std::sig_atomic_t asked_to_end = 0;

}  // namespace hinge

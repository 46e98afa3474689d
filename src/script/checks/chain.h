// Runs that go on from one another (from =): a chain is as good as its weakest run.
#pragma once

#include "script/lua/objects.h"

namespace hinge::script {

/// Of a run that did not come to the end that the script asked for, or that goes on from such a run: which run, how far
/// it came, where it was made. "" for others, and where allow_failed = true accepts it.
std::string weak_link(const RunRecord& r);

/// Whether it goes on from a run that did not come to its end, and nothing accepts that.
inline bool is_weak(const RunRecord& r) { return !r.weak.empty() && !r.weak_allowed; }

/// How a run went. One that has ended has failed if a run that it goes on from did not come to its end.
Verdict verdict_of(const RunRecord& r);

/// The first run that has failed and of which the script has never asked how it went, but for the last run; "" for
/// none.
std::string unasked_failure(const Context& c);

/// What a new run takes over from the one that it goes on from, and the field allow_failed.
class Chain {
public:
    /// Tells that the run before did not come to its end. `before`: null for none.
    Chain(Options& o, const RunRecord* before);
    /// Gives it to the run on top of the stack; returns 1.
    int keep(lua_State* L);

private:
    std::string weak_;
    bool allowed_ = false;
};

}  // namespace hinge::script

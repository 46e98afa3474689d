// What a run takes over from the run that it goes on from (from =), and the field allow_failed.
#pragma once

#include "record/chain.h"
#include "script/bind/run_box.h"

namespace hinge::script {

/// Data that a new run inherits from the run that it continues, and the field allow_failed.
class Chain {
public:
    /// Warns if the run before did not reach its end. `before`: null for none.
    Chain(Options& o, const RunRecord* before);
    /// Stores the data in the run on top of the stack; returns 1.
    int keep(lua_State* L);

private:
    std::string weak_;
    bool allowed_ = false;
};

}  // namespace hinge::script

// Observer of runs in progress (hinge run --live). Called on the thread of the run, between its steps; changes nothing
// of a run, and throws nothing.
#pragma once

#include <chrono>
#include <string>

namespace hinge {

struct Context;
struct RunRecord;

struct RunObserver {
    virtual ~RunObserver() = default;
    /// A run is about to take its first step. `history`: the heading of history.csv, and the rows that a checkpoint
    /// had.
    virtual void begun(const RunRecord& run, const std::string& history) = 0;
    /// A row of its history.csv, with the line's end.
    virtual void row(const RunRecord& run, const std::string& row) = 0;
    /// The run has taken a step. `over`: it takes no more.
    virtual void stepped(const Context& context, const RunRecord& run, bool over,
                         std::chrono::steady_clock::time_point now) = 0;
    /// The process was forked: nothing is observed in the child.
    virtual void forked() = 0;
};

}  // namespace hinge

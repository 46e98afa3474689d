// The role of what observes a run as it goes and changes nothing: advice (advice/).
#pragma once

#include "core/archive.h"
#include "effects/workspace.h"

namespace hinge {

class Run;

/// Is called by the run that it is attached to (Run::attach).
class Watch {
public:
    virtual ~Watch() = default;
    /// A step has become the state; in statics an equilibrium on the way of a step. Elements that break in it are not
    /// broken yet. Run::workspace has what flowed.
    virtual void after_commit(const Run& run, const Step& step) { (void)run, (void)step; }
    /// A step that was asked for is done, or has failed (Run::verdict).
    virtual void after_step(const Run& run) { (void)run; }
    /// The run has completed or failed in that step.
    virtual void finish(const Run& run) { (void)run; }

    /// Its part of a checkpoint, which only a run with the same watches reads.
    virtual void save(Writer& to) const { (void)to; }
    virtual void restore(Reader& from) { (void)from; }
    /// Whether what was read fits the run.
    virtual bool fits(const Run& run) const { return (void)run, true; }
    /// Whether it goes on where one run goes on as another (Dynamics::go_on_as); false: it begins with the run.
    virtual bool goes_on() const { return true; }
};

}  // namespace hinge

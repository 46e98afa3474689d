// Watches that warn, and the warnings of a run.
#pragma once

#include <memory>

#include "advice/warning.h"
#include "run/run.h"

namespace hinge {

/// The warnings that the advisers of a run have given as it went.
class WarningLog : public Watch {
public:
    void add(Warning w) { list_.push_back(std::move(w)); }
    const std::vector<Warning>& list() const { return list_; }
    void save(Writer& to) const override { to(list_); }
    void restore(Reader& from) override { from(list_); }
    bool goes_on() const override { return false; }

private:
    std::vector<Warning> list_;
};

/// Looks for one thing in a run. It warns once as the run goes (WarningLog), or of the run as a whole.
class Adviser : public Watch {
public:
    /// Adds what is to be said of the run as a whole, up to now.
    virtual void list_findings(const Run& run, std::vector<Warning>& list) const { (void)run, (void)list; }
    /// What may help a run that has failed: "; dt = 1e-05 holds: tried from ..."; "" for nothing.
    virtual std::string remedy(const Run& run) const { return (void)run, ""; }
};

/// Whether a check that is made now and then is due after this step: in dynamics twenty times in a run, every hundredth
/// step or more often, and at its end; in statics after each step. Not where the run has failed.
bool is_time_to_check(const Run& run);

#define HINGE_ADVISER(make) std::unique_ptr<Adviser> make(const Run& run, WarningLog& log);
#include "advice/advisers.inc"
#undef HINGE_ADVISER

/// Attaches all advisers that a run needs. Whoever makes a run calls it once, before the first step.
void advise(Run& run);

/// What the advisers have warned of as the run went, each once, in that order; empty without advisers.
const std::vector<Warning>& warnings_of(const Run& run);

/// What they find in the run as a whole, up to now.
std::vector<Warning> findings_of(const Run& run);

/// Why the run failed, and what may help; or what is to be said of its end. "" for nothing.
std::string reason_with_advice(const Run& run);

}  // namespace hinge

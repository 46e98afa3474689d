#include "advice/chain.h"

#include "core/text.h"
#include "advice/check.h"
#include "run/statics.h"

namespace hinge::script {
namespace {

/// "at 0.29 of its load", "at t = 0.12 s, in step 41 of 100"
std::string how_far(const Run& run) {
    const auto* s = dynamic_cast<const Statics*>(&run);
    if (!s)
        return "at t = " + number_text(run.state().time, 4) + " s, after " + std::to_string(run.steps_done()) + " of " +
               count_text(run.planned_steps(), "step");
    switch (s->settings().control) {
        case Control::arc:
            return "at load factor " + number_text(run.state().factor, 3) + " of " +
                   number_text(s->settings().target, 3);
        case Control::displacement: return "at " + number_text(s->part_done(), 3) + " of its way";
        default: return "at " + number_text(run.state().factor, 3) + " of its load";
    }
}

/// What kept the run itself from its end; "" for nothing.
std::string own_end(const RunRecord& r) {
    const auto* s = dynamic_cast<const Statics*>(r.run.get());
    if (r.run->verdict() == Verdict::failed) return "failed ";
    if (s && s->limit()) return "ended at its limit load, ";
    if (s && s->short_of_target()) return "ended ";
    return "";
}

/// Whether the script has never read how it went; the last run's failure is the verdict.
bool is_unasked(const Context& c, const FailedRun& f) {
    return !(c.runs.last && f.number == c.runs.last->number) && c.runs.asked.count(f.number) == 0;
}

}  // namespace

std::string weak_link(const RunRecord& r) {
    if (const std::string end = own_end(r); !end.empty()) {
        const std::string why = r.run->brief_reason();
        return std::string(r.run->kind()) + " run " + std::to_string(r.number) + ", which " + end + how_far(*r.run) +
               (r.asked_at.empty() ? "" : " (made at " + r.asked_at + ")") + (why.empty() ? "" : ": " + why);
    }
    return is_weak(r) ? r.weak : "";
}

Verdict verdict_of(const RunRecord& r) {
    const Verdict own = r.run->verdict();
    const bool ended = own == Verdict::completed || own == Verdict::stopped;
    return ended && is_weak(r) ? Verdict::failed : own;
}

std::string reason_of(const RunRecord& r) {
    const std::string reason = r.run->reason();
    if (r.run->verdict() != Verdict::failed && is_weak(r))
        return "goes on from " + r.weak + "; allow_failed = true of model:" + r.run->kind() + " accepts that";
    if (r.run->verdict() != Verdict::failed || !r.of_units) return reason;
    const Warning& w = *r.of_units;
    return reason + "; the cause may be what the warning" + (w.asked_at.empty() ? "" : " at " + w.asked_at) +
           " says: " + w.what;
}

std::string cause_of(const RunRecord& r) {
    if (const RunFailure* own = r.run->failure()) return word(own->what.cause);
    return verdict_of(r) == Verdict::failed ? "from_failed_run" : "";
}

std::string unasked_cause(const Context& c) {
    for (const FailedRun& f : c.runs.failed)
        if (is_unasked(c, f)) return f.cause;
    return "";
}

std::string unasked_failure(const Context& c) {
    const FailedRun* first = nullptr;
    int more = 0;
    for (const FailedRun& f : c.runs.failed) {
        if (!is_unasked(c, f)) continue;
        if (!first) first = &f;
        else ++more;
    }
    if (!first) return "";
    return first->text + (more > 0 ? "; so did " + count_text(more, "more run") : "") +
           "; the script never asked how that went (run.verdict)";
}

Chain::Chain(Options& o, const RunRecord* before) : allowed_(o.flag("allow_failed", false)) {
    if (!before && o.has("allow_failed"))
        o.complain("allow_failed", allowed_ ? "true" : "false",
                   "has no meaning without from =, the run that this one goes on from; leave it out");
    Context& c = *context(o.L());
    if (!before || c.mode.planning) return;
    weak_ = weak_link(*before);
    if (weak_.empty()) return;
    if (allowed_) c.runs.asked.insert(before->number);
    Warning w;
    w.what = "this run goes on from " + weak_;
    w.advice = allowed_
                   ? "allow_failed = true accepts that"
                   : "so this one counts as failed too; look at run.verdict first, or accept it: allow_failed = true";
    w.asked_at = where(o.L());
    tell(c, w);
}

int Chain::keep(lua_State* L) {
    RunRecord& r = *find<RunBox>(L, -1)->value;
    r.weak = std::move(weak_), r.weak_allowed = allowed_;
    return 1;
}

}  // namespace hinge::script

#include "record/chain.h"

#include "core/text.h"
#include "advice/adviser.h"

namespace hinge {
namespace {

/// What kept the run itself from its end; "" for nothing.
std::string own_end(const RunRecord& r) {
    if (r.run->verdict() == Verdict::failed) return "failed ";
    if (r.run->limit()) return "ended at its limit load, ";
    if (r.run->short_of_target()) return "ended ";
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
        return std::string(r.run->kind()) + " run " + std::to_string(r.number) + ", which " + end + r.run->way_done() +
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
    const std::string reason = reason_with_advice(*r.run);
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

}  // namespace hinge

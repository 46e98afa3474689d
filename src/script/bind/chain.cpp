#include "script/bind/chain.h"

#include "record/told_warnings.h"

namespace hinge::script {

Chain::Chain(Options& o, const RunRecord* before) : allowed_(o.flag("allow_failed", false)) {
    if (!before && o.has("allow_failed"))
        o.complain("allow_failed", allowed_ ? "true" : "false",
                   "has no meaning without from =, the run that this one goes on from; leave it out");
    Context& c = *context(o.L());
    if (!before || c.mode.planning) return;
    weak_ = weak_link(*before);
    if (weak_.empty()) return;
    if (allowed_) c.runs.asked.insert(before->number);
    Warning w{.kind = Warning::Kind::chain};
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

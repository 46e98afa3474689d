#include "run/run.h"

#include <algorithm>

#include "core/rotation.h"

namespace hinge {

const char* name(Verdict v) {
    switch (v) {
        case Verdict::running: return "running";
        case Verdict::completed: return "completed";
        case Verdict::stopped: return "stopped";
        default: return "failed";
    }
}

Run::Run(std::shared_ptr<const Structure> structure, State start)
    : structure_(std::move(structure)),
      state_(std::move(start)),
      ledger_(*structure_, state_),
      first_step_(state_.step) {}

void Run::stop() {
    if (verdict_ == Verdict::running) verdict_ = Verdict::stopped, reason_ = "stopped by the script";
}

void Run::fail(std::string why) {
    verdict_ = Verdict::failed;
    reason_ = std::move(why);
}

Vec6 Run::displacement(int node) const {
    Vec6 d;
    d.head<3>() = state_.displacement[node];
    if (structure_->large()) {
        d.tail<3>() = rotation_vector(state_.rotation[node]);
    } else {
        d.tail<3>() = state_.turn[node];
    }
    return d;
}

Vec6 Run::reaction(int node) const {
    const auto at = reaction_.find(node);
    return at == reaction_.end() ? Vec6(Vec6::Zero()) : at->second;
}

double Run::yield_value(int element) const {
    if (state_.broken[element]) return 0;
    const Element& e = structure_->elements()[element];
    if (structure_->conventional()) return beam::yield_function(state_.force[element], 0, e.yield);
    return std::max(beam::yield_function(state_.force[element], -1, e.yield),
                    beam::yield_function(state_.force[element], 1, e.yield));
}

Run::Counts Run::count_members(int group) const {
    Counts counts;
    const auto& elements = structure_->elements();
    for (std::size_t i = 0; i < elements.size();) {
        const int member = elements[i].member;
        bool broken = false, yielded = false, touched = false;
        const std::size_t first = i;
        for (; i < elements.size() && elements[i].member == member; ++i) {
            broken |= state_.broken[i] != 0;
            yielded |= state_.yielded[i] != 0;
            touched |= state_.touched[i] != 0;
        }
        if (group >= 0 && !structure_->in_group(int(first), group)) continue;
        counts.touched += touched;
        ++(broken ? counts.broken : yielded ? counts.yielded : counts.elastic);
    }
    return counts;
}

}  // namespace hinge

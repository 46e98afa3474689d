// Branches of equilibria beside the path: where a step has leapt to one, and where the structure itself leans over to
// one on which members that were slack hold it.
#include <algorithm>
#include <cmath>

#include "core/rotation.h"
#include "run/statics.h"

namespace hinge {
namespace {

/// A step that, so often in a row, ends on another branch however near the state comes to it, has no path of its own.
constexpr int most_branches_left = 20;

/// Motions along the unstable mode from which the leaning equilibrium is looked for, as parts of the structure's size.
constexpr double leans_by[] = {1e-3, 1e-4, 1e-5, 1e-6};

}  // namespace

/// The nearest one is kept, in case that no equilibrium is found before it.
void Statics::note_unheld() {
    if (path_->kind() != Control::load || instability()) return;
    if (unheld_ && unheld_->factor > state_.factor && unheld_->factor <= w_.factor) return;
    unheld_ = {w_.factor, w_.trial.displacement, w_.trial.rotation};
}

/// Where short steps find no equilibrium, one that cannot be held and that a longer step has found tells how the
/// structure gives way. Returns the increment to it.
std::optional<double> Statics::reach_unheld() {
    if (!unheld_ || instability() || !(unheld_->factor > state_.factor)) return {};
    to_unheld_ = unheld_->factor - state_.factor;
    if (try_step(*path_, to_unheld_) == Found::unstable) return to_unheld_;
    return {};
}

/// Displacements from the state to an equilibrium.
std::vector<Vec6> Statics::way_to(const Equilibrium& there) const {
    std::vector<Vec6> way(there.displacement.size());
    for (std::size_t i = 0; i < way.size(); ++i)
        way[i] << there.displacement[i] - state_.displacement[i],
            rotation_vector(there.rotation[i] * state_.rotation[i].conjugate());
    return way;
}

/// Whether the step has leapt to another branch, and a part of it leads on along the structure's own.
bool Statics::goes_on_before_leap(double part) const {
    return stability_.has_left_branch() && part >= StepHalving::smallest && branches_left_ < most_branches_left;
}

/// Elements of members that carry one sign of N alone, and have none.
std::vector<int> Statics::slack_elements() const {
    std::vector<int> list;
    const auto& members = structure_->model().members();
    for (std::size_t i = 0; i < structure_->elements().size(); ++i)
        if (members[std::size_t(structure_->elements()[i].member)].carries != Carries::both && !state_.broken[i] &&
            w_.force[i][4] == 0)
            list.push_back(int(i));
    return list;
}

/// A bay whose crossed rods are slack stands upright only if it is perfect. It leans over until one of them is taut, by
/// what the loads have shortened it, and is held there. Goes on from that equilibrium where it is found, to the side of
/// the positive axis first. False where nothing slack would hold the structure.
bool Statics::leans_on_slack_members() {
    const Instability upright = *instability();
    const double increment = upright.beyond - state_.factor;
    if (upright.node < 0 || slack_elements().empty() || try_step(*path_, increment) != Found::unstable) return false;
    const std::vector<int> slack = slack_elements();
    const std::vector<Vec6> to = newton_.result().displacements;
    std::vector<Vec6> mode = tangent_.negative_mode();
    if (mode[std::size_t(upright.node)][upright.component] < 0)
        for (Vec6& v : mode) v = -v;
    for (const double side : {1.0, -1.0})
        for (const double part : leans_by) {
            std::vector<Vec6> start = to;
            for (std::size_t i = 0; i < start.size(); ++i) start[i] += side * part * problem_.reach * mode[i];
            if (!newton_.find(*path_, increment, 0, start) || !stability_.can_be_held()) continue;
            const double moved = newton_.result().displacements[std::size_t(upright.node)][upright.component] -
                                 to[std::size_t(upright.node)][upright.component];
            const auto holds = std::find_if(slack.begin(), slack.end(), [&](int e) { return w_.force[e][4] != 0; });
            if (holds == slack.end() || !(side * moved > 0)) continue;
            note({.kind = Notice::Kind::leans,
                  .node = upright.node,
                  .component = upright.component,
                  .member = structure_->elements()[std::size_t(*holds)].member,
                  .from = upright.factor});
            stability_.forget_instability();
            commit({path_.get(), increment});
            return true;
        }
    return false;
}

}  // namespace hinge

#include "run/stability_monitor.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/text.h"
#include "run/step_halving.h"

namespace hinge {
namespace {

/// A step that takes no more iterations has not snapped.
constexpr int quick = 4;

/// When the load of a snapped step is taken off, the structure does not come back within this part of the step.
constexpr double comes_back = 1e-2;

/// Displacements by a step that differ by more than this part of them from those that its tangent gives: a leap.
constexpr double leaps_by = 0.1;

/// An eigenvalue that passes zero is, in the bracket of an instability, so near to it: of the first one where the run
/// begins, at least, and in parts of the bracket's width over the load factor. Others have not passed it.
constexpr double near_zero = 1e-3, near_zero_by_width = 30;

/// A step of load after which the structure has moved so many times as far as such a load moved it at first, and by
/// this part of its size, has passed a plateau or a snap.
constexpr double far_times = 30, far_part = 3e-3;

}  // namespace

StabilityMonitor::StabilityMonitor(const StaticProblem& problem, StaticTangent& tangent, Newton& newton)
    : problem_(problem), w_(problem.w), tangent_(tangent), newton_(newton) {}

void StabilityMonitor::begin(bool unsymmetric) {
    if (unsymmetric) first_eigenvalue_ = tangent_.smallest_eigenvalue();
    if (w_.structure.large()) modes_at_start_ = most_modes_ = most_free_modes_ = tangent_.negative_modes_of_matrix();
    newton_.set_modes_at_start(modes_at_start_);
}

// ---- of each try ----------------------------------------------------------------------------------------------------

/// Under load control an equilibrium that Newton's method came to by way of unstable tangents may lie beyond a snap.
Found StabilityMonitor::judge(PathControl& control, double increment, double hinge_stiffness) {
    modes_ = count_modes(hinge_stiffness);
    free_modes_ = count_free_modes(control);
    if (modes_ > modes_at_start_) return Found::unstable;
    may_have_snapped_ =
        control.kind() == Control::load && (newton_.passed_unstable() || !unloading_returns(control, increment));
    return may_have_snapped_ && !problem_.settings.past_unstable ? Found::nothing : Found::stable;
}

bool StabilityMonitor::can_be_held() {
    modes_ = free_modes_ = count_modes(0);
    return modes_ <= modes_at_start_;
}

/// Of the tangent at the trial equilibrium. With small displacement it never has other ones than at the start.
int StabilityMonitor::count_modes(double hinge_stiffness) {
    if (!w_.structure.large()) return modes_at_start_;
    if (!tangent_.renew(1, hinge_stiffness)) return most_modes_ + 1;
    tangent_.holds_for_trial();
    counted_ = tangent_.negative_modes();
    return std::max(counted_ - driven_, 0);
}

/// Those that the control leaves.
int StabilityMonitor::count_free_modes(const PathControl& control) {
    if (!control.can_stabilise() || modes_ <= modes_at_start_ || !newton_.find_response()) return modes_;
    return modes_ - control.stabilised_modes(newton_.result().response);
}

/// True if an elastic structure comes back to where it was when the load of the step that was tried is taken off again.
/// If not, the step has snapped. Tried where Newton's method took long, as it does over a snap. Cracks need not close
/// when the load is taken off.
bool StabilityMonitor::unloading_returns(PathControl& control, double increment) {
    if (!w_.structure.large() || newton_.result().iterations <= quick || newton_.yields()) return true;
    if (problem_.effects.any(&EffectTraits::cracks)) return true;
    const NewtonResult result = newton_.result();
    const Configuration arrived = w_.trial;
    const std::vector<Vec3> rotation_step = w_.rotation_step;
    const double factor = w_.factor;
    const bool found = newton_.find_from_trial(control, -increment);
    double off = 0, way = 0;
    for (std::size_t i = 0; i < arrived.displacement.size(); ++i) {
        off = std::max(off, (w_.trial.displacement[i] - w_.state.displacement[i]).norm());
        way = std::max(way, (arrived.displacement[i] - w_.state.displacement[i]).norm());
    }
    w_.trial = arrived, w_.rotation_step = rotation_step, w_.factor = factor;
    newton_.recover();  // effects have the forces of this place again: a connector keeps that of its law
    w_.yielding.clear();
    newton_.set_result(result);
    return !newton_.passed_unstable() && (!found || off <= comes_back * way);
}

void StabilityMonitor::accept_branching(const PathControl& control) {
    if (!has_left_path(control)) return;
    most_free_modes_ = free_modes_;
    if (!branching_) branching_ = w_.state.factor;
}

/// The tangent at the trial gives displacements that belong to its branch. Where Newton's method has leapt there, the
/// displacements of the step have a part that does not become smaller with the step.
bool StabilityMonitor::is_leap(const std::vector<Vec6>& moved, double increment, double part) const {
    const std::vector<Vec6> rate = newton_.path_rate();
    if (rate.empty()) return true;
    double off = 0, most = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        off += (moved[i] - increment * rate[i]).head<3>().squaredNorm();
        most += moved[i].head<3>().squaredNorm();
    }
    return !(off <= part * part * most);
}

bool StabilityMonitor::follows_tangent(double increment) const {
    return !is_leap(newton_.result().displacements, increment, leaps_by);
}

/// Not where a panel that was flat has sagged by less than the tangent at the start asked for: there the tangent at the
/// end gives a third of the way, by any step.
bool StabilityMonitor::may_have_leapt(double increment) const {
    constexpr double far_off = 0.5;
    const NewtonResult& step = newton_.result();
    if (!w_.structure.large() || !w_.yielding.empty()) return false;
    if (step.asked > 0 && dot_translations(step.displacements, step.displacements) <= step.asked * step.asked)
        return false;
    return is_leap(step.displacements, increment, far_off);
}

// ---- where the structure becomes unstable ---------------------------------------------------------------------------

double StabilityMonitor::locate_instability(const PathControl& control, double increment, const Try& try_step) {
    Instability found;
    double stable = 0, unstable = increment;
    std::vector<Vec6> held(w_.external.size(), Vec6::Zero());  // displacements of the step to the last stable one
    found.factor = w_.state.factor;
    const bool arc = control.kind() == Control::arc;
    const double close = arc ? 1e-4 * increment : 0.1 * StepHalving::smallest;
    bool at_unstable = true;
    while (unstable - stable > close) {
        const double middle = 0.5 * (stable + unstable);
        const Found there = try_step(middle);
        at_unstable = there == Found::unstable;
        if (there == Found::stable) stable = middle, found.factor = w_.factor, held = newton_.result().displacements;
        else unstable = middle;
    }
    // and the first equilibrium beyond: there may be none close to it
    for (double gap = unstable - stable; !at_unstable; gap *= 2) {
        const double part = std::min(stable + gap, increment);
        at_unstable = try_step(part) == Found::unstable || part == increment;
    }
    found.beyond = w_.factor;
    found.count = std::max(1, new_modes());
    const bool in_pairs = new_modes() > 0 && new_modes() % 2 == 0;
    const double width = (found.beyond - found.factor) / std::max(std::abs(found.beyond), 1e-300);
    const double near = first_eigenvalue_ * std::max(near_zero, near_zero_by_width * std::abs(width));
    found_driven_ = in_pairs && tangent_.nearest_negative() > near && first_eigenvalue_ > 0 ? new_modes() : 0;
    describe(tangent_.negative_mode(), found);
    for (std::size_t i = 0; i < held.size(); ++i) held[i] = newton_.result().displacements[i] - held[i];
    left_branch_ = control.kind() == Control::load && is_leap(held, found.beyond - found.factor, leaps_by);
    instability_ = found;
    try_step(increment);
    return stable;
}

/// The largest motion of the mode, and the members that drive it.
void StabilityMonitor::describe(const std::vector<Vec6>& mode, Instability& found) const {
    double most = 0;
    for (std::size_t i = 0; i < mode.size(); ++i)
        for (int c = 0; c < 6; ++c)
            if (const double size = std::abs(mode[i][c]) * (c < 3 ? 1 : problem_.mean_length); size > most)
                most = size, found.node = int(i), found.component = c;
    if (found.node < 0 && tangent_.overloaded_member() >= 0) found.members.assign(1, tangent_.overloaded_member());
    else find_driving_members(mode, found);
}

/// Those that compression drives on as they bend or, where that is less than half of what drives the motion, those that
/// all their forces drive on.
void StabilityMonitor::find_driving_members(const std::vector<Vec6>& mode, Instability& found) const {
    std::map<int, double> by_compression, by_all_forces;
    double of_compression = 0, of_all_forces = 0;
    for (std::size_t i = 0; i < w_.structure.elements().size(); ++i) {
        if (w_.state.broken[i]) continue;
        const Element& e = w_.structure.elements()[i];
        const auto place = [&](int n) -> Vec3 { return w_.structure.position()[n] + w_.trial.displacement[n]; };
        const Vec3 along = (place(e.node[1]) - place(e.node[0])).normalized();
        Vec3 across = mode[e.node[1]].head<3>() - mode[e.node[0]].head<3>();
        across -= across.dot(along) * along;
        const double drive = -w_.force[i][4] / e.length * across.squaredNorm();
        by_compression[e.member] += drive;
        of_compression += std::max(drive, 0.0);
        Eigen::Matrix<double, 12, 1> ends;
        ends << mode[e.node[0]], mode[e.node[1]];
        const ElementFrame frame = element_frame(w_.structure, int(i), w_.trial);
        const double all = -ends.dot(element_tangent(frame, w_.force[i], Mat6::Zero(), true) * ends);
        by_all_forces[e.member] += all;
        of_all_forces += all;
    }
    found.by_compression = of_compression >= 0.5 * of_all_forces;
    std::vector<std::pair<double, int>> by_drive;
    for (const auto& [member, drive] : found.by_compression ? by_compression : by_all_forces)
        if (drive > 0) by_drive.emplace_back(-drive, member);
    std::sort(by_drive.begin(), by_drive.end());
    for (const auto& [drive, member] : by_drive)
        if (found.members.size() < 3 && drive <= 0.5 * by_drive[0].first) found.members.push_back(member);
}

std::string text_of(const Instability& i, const Structure& structure) {
    const bool close = std::abs(i.beyond - i.factor) <= 1e-3 * std::abs(i.factor);
    std::string text = "the structure becomes unstable " +
                       (close ? "at load factor " + number_text(i.factor)
                              : "between load factors " + number_text(i.factor) + " and " + number_text(i.beyond)) +
                       (i.count > 1 ? ", in " + std::to_string(i.count) + " ways" : "");
    if (i.node >= 0) text += ": " + structure.node_name(i.node) + " gives way, " + component_name(i.component);
    for (std::size_t k = 0; k < i.members.size(); ++k)
        text += (k > 0 ? (k + 1 == i.members.size() ? " and " : ", ")
                       : std::string(i.by_compression ? ", by compression of member" : ", by bending of member") +
                             (i.members.size() > 1 ? "s " : " ")) +
                std::to_string(i.members[k] + 1);
    if (i.node < 0 && !i.members.empty())
        text += ", beyond Euler's load between clamped ends: two elements cannot show that, four can";
    return text;
}

// ---- snaps ----------------------------------------------------------------------------------------------------------

/// Whether a run stops at a plateau or a snap, or passes it, is a matter of its steps. So it is where Newton's method
/// has come by unstable tangents, and the run goes on all the same.
std::optional<Notice> StabilityMonitor::find_snap(double increment) {
    if (snap_told_ || !w_.structure.large()) return {};
    const std::vector<Vec6>& moved = newton_.result().displacements;
    std::size_t node = 0;
    int component = 0;
    double most = 0, square = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        square += moved[i].head<3>().squaredNorm();
        for (int c = 0; c < 3; ++c)
            if (const double size = std::abs(moved[i][c]); size > most) most = size, node = i, component = c;
    }
    const double times = std::sqrt(square) / (increment * newton_.first_softness());
    const bool far = times > far_times && most > far_part * problem_.reach;
    if (!far && !may_have_snapped_) return {};
    snap_told_ = true;
    return Notice{.kind = far ? Notice::Kind::snap : Notice::Kind::left_branch,
                  .node = int(node),
                  .component = component,
                  .value = moved[node][component],
                  .times = times,
                  .from = w_.state.factor,
                  .to = w_.factor,
                  .plastic = newton_.yields()};
}

}  // namespace hinge

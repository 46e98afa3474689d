// What a static run says of where it came to a limit: by what motion the structure gives way, in which members, and
// what can go on past it.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/text.h"
#include "run/statics.h"

namespace hinge {
namespace {

/// A structure that answers the load so many times as softly as it did at first is at a limit point.
constexpr double soft = 10;
constexpr std::size_t most_named = 3;

}  // namespace

/// By what motion the structure gives way, and in which members, where the tangent has just been factorised: those
/// that compression drives on as they bend or, where that is less than half of what drives the motion, those that all
/// their forces drive on.
void Statics::describe_mode() {
    Instability& found = *instability_;
    const std::vector<Vec6> mode = effective_->negative_mode();
    double most = 0;
    for (std::size_t i = 0; i < mode.size(); ++i)
        for (int c = 0; c < 6; ++c)
            if (const double size = std::abs(mode[i][c]) * (c < 3 ? 1 : mean_length_); size > most)
                most = size, found.node = int(i), found.component = c;
    if (found.node < 0 && pressed_ >= 0) {
        found.members.assign(1, pressed_);
        return;
    }
    std::map<int, double> by_compression, by_all_forces;
    double of_compression = 0, of_all_forces = 0;
    for (std::size_t i = 0; i < structure_->elements().size(); ++i) {
        if (state_.broken[i]) continue;
        const Element& e = structure_->elements()[i];
        const auto place = [&](int n) -> Vec3 { return structure_->position()[n] + w_.trial.displacement[n]; };
        const Vec3 along = (place(e.node[1]) - place(e.node[0])).normalized();
        Vec3 across = mode[e.node[1]].head<3>() - mode[e.node[0]].head<3>();
        across -= across.dot(along) * along;
        const double drive = -w_.force[i][4] / e.length * across.squaredNorm();
        by_compression[e.member] += drive;
        of_compression += std::max(drive, 0.0);
        Eigen::Matrix<double, 12, 1> ends;
        ends << mode[e.node[0]], mode[e.node[1]];
        const ElementFrame placed = element_frame(*structure_, int(i), w_.trial);
        const double all = -ends.dot(element_tangent(placed, w_.force[i], Mat6::Zero(), true) * ends);
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

const char* Statics::component_name(int component) {
    static const char* const name[] = {"ux", "uy", "uz", "rx", "ry", "rz"};
    return name[component];
}

std::string Statics::instability_text() const {
    if (!instability_) return {};
    const Instability& i = *instability_;
    const bool close = std::abs(i.beyond - i.factor) <= 1e-3 * std::abs(i.factor);
    std::string text = "the structure becomes unstable " +
                       (close ? "at load factor " + number_text(i.factor)
                              : "between load factors " + number_text(i.factor) + " and " + number_text(i.beyond)) +
                       (i.count > 1 ? ", in " + std::to_string(i.count) + " ways" : "");
    if (i.node >= 0) text += ": " + structure_->node_name(i.node) + " gives way, " + component_name(i.component);
    for (std::size_t k = 0; k < i.members.size(); ++k)
        text += (k > 0 ? (k + 1 == i.members.size() ? " and " : ", ")
                       : std::string(i.by_compression ? ", by compression of member" : ", by bending of member") +
                             (i.members.size() > 1 ? "s " : " ")) +
                std::to_string(i.members[k] + 1);
    if (i.node < 0 && !i.members.empty())
        text += ", beyond Euler's load between clamped ends: two elements cannot show that, four can";
    return text;
}

/// Control by arc length: whether the step that was tried has come to the load factor where the run ends, or past it.
bool Statics::passes_target() const {
    const double to = settings_.target;
    return (state_.factor < to && trial_factor_ >= to) || (state_.factor > to && trial_factor_ <= to);
}

/// A step of load that moves the structure many times as far as such a load did at first has come past a plateau or a
/// snap: whether a run stops there, is a matter of its steps. So it is where Newton's iteration has come by tangents
/// that cannot be held, and the run goes on all the same.
void Statics::note_leap(double increment, double before) {
    constexpr double far = 30, seen = 3e-3;  // times as at first, of the structure's size
    if (leap_told_ || settings_.control != Control::load || !structure_->large()) return;
    std::size_t node = 0;
    int component = 0;
    double most = 0, square = 0;
    for (std::size_t i = 0; i < last_move_.size(); ++i) {
        square += last_move_[i].head<3>().squaredNorm();
        for (int c = 0; c < 3; ++c)
            if (const double size = std::abs(last_move_[i][c]); size > most) most = size, node = i, component = c;
    }
    const double times = std::sqrt(square) / (increment * first_softness_);
    const bool leap = times > far && most > seen * reach_;
    if (!leap && !doubtful_) return;
    leap_told_ = true;
    std::string what = "between load factors " + number_text(before) + " and " + number_text(trial_factor_) + " ";
    what += leap ? component_name(component) + (" of " + structure_->node_name(int(node))) + " changes by " +
                       number_text(last_move_[node][component], 3) + " m, and the structure moves " +
                       number_text(std::round(times), 9) + " times as far as under such a load at first"
                 : std::string("the run may have leapt to another branch of equilibria");
    const bool plastic = !hinges_.empty() || !w_.yielding.empty();
    const std::string advice =
        "a limit load may lie there, or a snap, at which a static run with other steps may end; control by "
        "displacement "
        "or arc length follows the path";
    warn(RunWarning{
        what, advice + (plastic ? ", displacement = 'small' gives the plastic limit load whatever the steps" : ""),
        -1});
}

/// What is to be said of a run that has completed.
void Statics::tell_end() {
    if (branching_)
        reason_ = "beyond a branching point at load factor " + number_text(*branching_) +
                  ": these equilibria cannot be held, not even where they are driven";
    else if (settings_.control == Control::arc && !at_target_)
        reason_ = count_text(settings_.steps, "step") + " of arc length " + (settings_.steps == 1 ? "has" : "have") +
                  " not come to load factor " + number_text(settings_.target) + ": it is " + number_text(state_.factor);
    else if (settings_.past_unstable && instability_)
        reason_ = "the run went on past load factor " + number_text(instability_->factor) +
                  ", where the structure becomes unstable; its state at the end " +
                  (modes_ > modes_at_start_
                       ? "cannot be held: there are " + count_text(modes_ - modes_at_start_, "way") +
                             " to move that nothing resists"
                       : std::string("can be held, but another may be the one that the structure goes to"));
}

/// Where a step has ended: whether a pair is pressed so much that moments of loads along it are missed.
void Statics::look_at_pairs() {
    warn(pairs_.missed_moments(
        *structure_, state_, [this](int node) -> Vec3 { return load_at(std::size_t(node), state_.factor).head<3>(); },
        [this](int element) { return largest_moment(element); }, "at load factor " + number_text(state_.factor)));
}

/// Where the last try was given up: the node that the loads move most, if that is far more than they did at first, and
/// the members with plastic hinges there. "" where the structure is as stiff as ever.
std::string Statics::limit_point() const {
    const double answers = softness();
    if (!(answers > soft * first_softness_) || !std::isfinite(answers)) return "";
    int node = 0, component = 0;
    double most = 0;
    for (std::size_t i = 0; i < response_.size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (const double size = std::abs(response_[i][c]); size > most) most = size, node = int(i), component = c;
    std::vector<int> members;
    for (const PlasticIncrement& y : w_.yielding) members.push_back(structure_->elements()[y.element].member);
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    std::string text =
        ": a limit load, where " + structure_->node_name(node) + " gives way, " + component_name(component);
    for (std::size_t i = 0; i < std::min(members.size(), most_named); ++i)
        text += (i > 0                 ? ", "
                 : members.size() == 1 ? ", with plastic hinges in member "
                                       : ", with plastic hinges in members ") +
                std::to_string(members[i] + 1);
    if (members.size() > most_named) text += " and " + std::to_string(members.size() - most_named) + " more";
    return text;
}

/// No equilibrium is found from where the state is, or only one that cannot be held: why that may be, and what can be
/// done about it. Under load control that is the first of other kinds of control that goes on from there: by the
/// displacement that gives way, or by arc length.
std::string Statics::advice_at_end() {
    if (settings_.control == Control::load) {
        if (settings_.to_limit && substeps_ > 0) return {};  // it has what it asked for
        const bool unstable = instability_ && !settings_.past_unstable;
        const int nodes = int(structure_->model().nodes().size());
        int node = -1, component = 0;
        double most = 0;
        // where it is unstable and as stiff as ever, nothing leads from its path to another: a branching point
        const bool branches = unstable && !(softness() > soft * first_softness_);
        if (unstable && instability_->node < nodes && instability_->component < 3)
            node = instability_->node, component = instability_->component;
        for (int i = 0; node < 0 && !branches && i < nodes; ++i)
            for (int c = 0; c < 3; ++c)
                if (const double size = std::abs(response_[std::size_t(i)][c]); std::isfinite(size) && size > most)
                    most = size, node = i, component = c;
        const std::string where =
            unstable ? ". Beyond it load control finds equilibria that cannot be held" : limit_point();
        if (unstable && instability_->node < 0) return where;  // instability_text says what shows it
        const std::string what = where.empty() ? ": a limit load, a mechanism or a snap" : where;
        const StaticSettings asked = settings_;
        const double way = way_, arc = last_arc_, begun = state_.factor;
        const auto arrives = [&](Control control) {
            settings_.control = control;
            return try_step(1) != Found::nothing && std::abs(trial_factor_ - begun) <= std::max(1.0, std::abs(begun));
        };
        std::string on;
        if (node >= 0) {
            settings_.node = node, settings_.component = component;
            const double along = response_[std::size_t(node)][component] < 0 ? -1 : 1;
            for (const double part : {1e-3, 1e-4, 1e-5}) {
                way_ = along * part * reach_;
                if (!on.empty() || !arrives(Control::displacement)) continue;
                on = std::string("control by ") + component_name(component) + " of " + structure_->node_name(node) +
                     " goes on past it: tried over " + number_text(1e3 * part * reach_, 2) + " mm";
            }
        }
        last_arc_ = 0;
        if (on.empty() && !branches && arrives(Control::arc)) on = "control by arc length goes on past it: tried";
        if (on.empty() && branches)
            on = "a small load that moves it that way, as an imperfection, shows how it gives way";
        settings_ = asked, way_ = way, last_arc_ = arc;
        if (on.empty()) on = "model:dynamic with from = and allow_failed = true follows what comes after it in time";
        return what + "; " + on;
    }
    if (settings_.control == Control::arc)
        return ": the path turns too sharply or ends there; more steps make a shorter arc";
    const int n = settings_.node, c = settings_.component;
    const std::string driven = std::string(component_name(c)) + " of " + structure_->node_name(n);
    w_.trial = configuration_of(state_);
    recover();
    w_.yielding = hinges_;
    SolverSettings direct;
    direct.direct = true;
    if (renew_and_factorise(1)) {
        std::vector<Vec6> unit_load = w_.external;
        for (std::size_t i = 0; i < unit_load.size(); ++i)
            for (int k = 0; k < 6; ++k)
                if (held_[i] >> k & 1) unit_load[i][k] = 0;
        double most = 0;
        const bool solved = effective_->solve(unit_load, response_, direct).converged;
        const auto size = [&](std::size_t i, int k) { return std::abs(response_[i][k]) * (k < 3 ? 1 : mean_length_); };
        for (std::size_t i = 0; solved && i < response_.size(); ++i)
            for (int k = 0; k < 6; ++k) most = std::max(most, size(i, k));
        if (solved && size(n, c) <= 1e-9 * most)
            return ": the loads do not move " + driven + ", which is to be driven; drive what they move";
    }
    return ", where " + driven + " is " + number_text(displacement(n)[c]) + (c < 3 ? " m" : " rad") +
           ": it would have to turn back there, or the structure comes apart in another way; drive what goes on moving "
           "one way, or control by arc length";
}

}  // namespace hinge

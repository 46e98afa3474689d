// The end of a static run: what it says of a limit load, and which control goes on past it.
#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "run/arc_length_control.h"
#include "run/displacement_control.h"
#include "run/statics.h"

namespace hinge {
namespace {

/// A structure that answers the load so many times as softly as it did at first is at a limit point.
constexpr double soft = 10;

/// Displacement control that is tried beyond a limit load moves a node by these parts of the structure's size.
constexpr double tried_parts[] = {1e-3, 1e-4, 1e-5};

/// A translation of a node: component 0..2, ux uy uz.
struct Translation {
    int node = -1, component = 0;
};

/// The largest one of all nodes.
Translation largest_translation(const std::vector<Vec6>& displacements) {
    Translation largest{0, 0};
    double most = 0;
    for (std::size_t i = 0; i < displacements.size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (const double size = std::abs(displacements[i][c]); size > most) most = size, largest = {int(i), c};
    return largest;
}

/// The larger one of the first node that moves, of `nodes`; node -1 for none.
Translation first_translation(const std::vector<Vec6>& displacements, int nodes) {
    Translation first;
    double most = 0;
    for (int i = 0; first.node < 0 && i < nodes; ++i)
        for (int c = 0; c < 3; ++c)
            if (const double size = std::abs(displacements[std::size_t(i)][c]); std::isfinite(size) && size > most)
                most = size, first = {i, c};
    return first;
}

}  // namespace

/// Completed where the script asked for that and there was a way to it, else failed.
void Statics::end_at_limit(const Failure& why) {
    RunFailure failure{why, remarks_at_limit()};
    if (const Failure of_element = assembly_.failure()) {
        failure.remarks.push_back({Remark::Kind::of_element, of_element});
        return fail(std::move(failure));
    }
    if (!settings().to_limit || substeps_ == 0) return fail(std::move(failure));
    verdict_ = Verdict::completed;
    failure_ = {why};
    limit_ = true;
}

std::string Statics::text_of_cause(const Failure& failure) const {
    return failure.cause == Cause::unstable ? instability_text() : Run::text_of_cause(failure);
}

/// What is to be said of a run that has completed; "" for nothing.
std::string Statics::reason_at_end() const {
    if (limit_) return "limit load: " + text_of_cause(failure_.what);
    if (stability_.branching())
        return "beyond a branching point at load factor " + number_text(*stability_.branching()) +
               ": these equilibria cannot be held, not even where they are driven";
    if (path_->short_of_target())
        return count_text(settings().steps, "step") + " of arc length " + (settings().steps == 1 ? "has" : "have") +
               " not come to load factor " + number_text(settings().target) + ": it is " + number_text(state_.factor);
    if (!settings().past_unstable || !instability()) return {};
    const int ways = stability_.new_modes();
    return "the run went on past load factor " + number_text(instability()->factor) +
           ", where the structure becomes unstable; its state at the end " +
           (ways > 0 ? "cannot be held: there are " + count_text(ways, "way") + " to move that nothing resists"
                     : std::string("can be held, but another may be the one that the structure goes to"));
}

/// True where the last try was given up if the loads move the structure far more than they did at first.
bool Statics::is_soft() const { return newton_.softness() > soft * newton_.first_softness(); }

/// Where the last try was given up: the node that the loads move most, and the members with plastic hinges there. None
/// where the structure is as stiff as ever.
std::optional<Remark> Statics::limit_point() const {
    if (!is_soft() || !std::isfinite(newton_.softness())) return {};
    const Translation most = largest_translation(newton_.result().response);
    Remark point{Remark::Kind::limit_point, {.node = most.node, .component = most.component}};
    std::vector<int>& members = point.members;
    for (const PlasticIncrement& y : w_.yielding) members.push_back(structure_->elements()[y.element].member);
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    return point;
}

/// No equilibrium is found from where the state is, or only one that cannot be held: why that may be, and what can be
/// done about it.
std::vector<Remark> Statics::remarks_at_limit() {
    switch (path_->kind()) {
        case Control::load: return remarks_under_load();
        case Control::arc: return {{Remark::Kind::path_turns}, {Remark::Kind::shorter_arc}};
        default: return remarks_when_driven();
    }
}

std::vector<Remark> Statics::remarks_under_load() {
    if (settings().to_limit && substeps_ > 0) return {};  // it has what it asked for
    const bool unstable = instability() && !settings().past_unstable;
    const Remark where = unstable ? Remark{Remark::Kind::load_control_ends}
                                  : limit_point().value_or(Remark{Remark::Kind::limit_or_snap});
    if (unstable && instability()->node < 0) return {where};  // instability_text says what shows it
    return {where, control_that_goes_on(unstable)};
}

/// The first of other kinds of control that goes on from the state: by the displacement that gives way, or by arc
/// length. Where the structure is unstable and as stiff as ever no other path leads on from the loads': a branching
/// point.
Remark Statics::control_that_goes_on(bool unstable) {
    const bool branches = unstable && !is_soft();
    const int steps = settings().steps, nodes = int(structure_->model().nodes().size());
    const double begun = state_.factor;
    const auto arrives = [&](PathControl&& control) {
        return try_step(control, 1) != Found::nothing && std::abs(w_.factor - begun) <= std::max(1.0, std::abs(begun));
    };
    Translation driven;
    if (unstable && instability()->node < nodes && instability()->component < 3)
        driven = {instability()->node, instability()->component};
    else if (!branches) driven = first_translation(newton_.result().response, nodes);
    if (driven.node >= 0) {
        const double along = newton_.result().response[std::size_t(driven.node)][driven.component] < 0 ? -1 : 1;
        for (const double part : tried_parts)
            if (arrives(DisplacementControl(steps, driven.node, driven.component, along * part * problem_.reach)))
                return {Remark::Kind::drive_displacement,
                        {.node = driven.node, .component = driven.component, .value = part * problem_.reach}};
    }
    if (branches) return {Remark::Kind::imperfection};
    if (arrives(ArcLengthControl(steps, settings().target, halving_.size(), newton_.result().displacements)))
        return {Remark::Kind::arc_length};
    return {Remark::Kind::follow_in_time};
}

/// Displacement control: the loads do not move what is driven, or it would have to turn back.
std::vector<Remark> Statics::remarks_when_driven() {
    const int n = settings().node, c = settings().component;
    w_.trial = state_;
    forces_.recover();
    w_.yielding = newton_.hinges();
    if (tangent_.renew(1)) {
        std::vector<Vec6> load = w_.external, response(load.size(), Vec6::Zero());
        for (std::size_t i = 0; i < load.size(); ++i) load[i] = problem_.without_supported(i, load[i]);
        const bool solved = tangent_.solve(load, response);
        const auto size = [&](std::size_t i, int k) {
            return std::abs(response[i][k]) * (k < 3 ? 1 : problem_.mean_length);
        };
        double most = 0;
        for (std::size_t i = 0; solved && i < response.size(); ++i)
            for (int k = 0; k < 6; ++k) most = std::max(most, size(i, k));
        if (solved && size(std::size_t(n), c) <= 1e-9 * most)
            return {{Remark::Kind::not_moved, {.node = n, .component = c}}, {Remark::Kind::drive_what_moves}};
    }
    return {{Remark::Kind::would_turn_back, {.node = n, .component = c, .value = displacement(n)[c]}},
            {Remark::Kind::drive_one_way}};
}

std::string Statics::way_done() const {
    switch (settings().control) {
        case Control::arc:
            return "at load factor " + number_text(state_.factor, 3) + " of " + number_text(settings().target, 3);
        case Control::displacement: return "at " + number_text(part_done(), 3) + " of its way";
        default: return "at " + number_text(state_.factor, 3) + " of its load";
    }
}

}  // namespace hinge

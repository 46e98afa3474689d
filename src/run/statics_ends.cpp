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
constexpr std::size_t most_named = 3;

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
void Statics::end_at_limit(const std::string& why) {
    const std::string advice = advice_at_limit();
    if (const std::string of_element = assembly_.failure(); !of_element.empty())
        return fail(why + advice + "; " + of_element);
    if (!settings().to_limit || substeps_ == 0) return fail(why + advice);
    verdict_ = Verdict::completed;
    reason_ = "limit load: " + why;
    limit_ = true;
}

/// What is to be said of a run that has completed; "" for nothing.
std::string Statics::reason_at_end() const {
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

/// A pair of elements that is pressed so much that it misses moments of the loads along it.
void Statics::warn_of_missed_moments() {
    warn(pairs_.missed_moments(
        *structure_, state_,
        [this](int node) -> Vec3 { return forces_.load(std::size_t(node), state_.factor).head<3>(); },
        [this](int element) { return largest_moment(element); }, "at load factor " + number_text(state_.factor)));
    warn(pairs_.missed_tension(
        *structure_, state_,
        [this](int node) -> Vec3 { return forces_.load(std::size_t(node), state_.factor).head<3>(); },
        "at load factor " + number_text(state_.factor)));
}

/// A run whose results are all 0, since a load or a load case was forgotten.
void Statics::warn_if_nothing_acts() {
    for (std::size_t i = 0; i < state_.displacement.size(); ++i)
        if (!displacement(int(i)).isZero(0) || !forces_.load(i, state_.factor).isZero(0)) return;
    for (const Vec6& p : state_.force)
        if (!p.isZero(0)) return;
    warn(RunWarning{"nothing acts in this run: no load, no weight, no settlement, no heat",
                    "declare a load with model:load, or the weight with model:gravity, and see that its load case is "
                    "among those of the run"});
}

/// True where the last try was given up if the loads move the structure far more than they did at first.
bool Statics::is_soft() const { return newton_.softness() > soft * newton_.first_softness(); }

/// Where the last try was given up: the node that the loads move most, and the members with plastic hinges there. ""
/// where the structure is as stiff as ever.
std::string Statics::limit_point() const {
    if (!is_soft() || !std::isfinite(newton_.softness())) return "";
    const Translation most = largest_translation(newton_.result().response);
    std::vector<int> members;
    for (const PlasticIncrement& y : w_.yielding) members.push_back(structure_->elements()[y.element].member);
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    std::string text =
        ": a limit load, where " + structure_->node_name(most.node) + " gives way, " + component_name(most.component);
    for (std::size_t i = 0; i < std::min(members.size(), most_named); ++i)
        text += (i > 0                 ? ", "
                 : members.size() == 1 ? ", with plastic hinges in member "
                                       : ", with plastic hinges in members ") +
                std::to_string(members[i] + 1);
    if (members.size() > most_named) text += " and " + std::to_string(members.size() - most_named) + " more";
    return text;
}

/// No equilibrium is found from where the state is, or only one that cannot be held: why that may be, and what can be
/// done about it.
std::string Statics::advice_at_limit() {
    switch (path_->kind()) {
        case Control::load: return advice_under_load();
        case Control::arc: return ": the path turns too sharply or ends there; more steps make a shorter arc";
        default: return advice_when_driven();
    }
}

std::string Statics::advice_under_load() {
    if (settings().to_limit && substeps_ > 0) return {};  // it has what it asked for
    const bool unstable = instability() && !settings().past_unstable;
    std::string where = unstable ? ". Beyond it load control finds equilibria that cannot be held" : limit_point();
    if (unstable && instability()->node < 0) return where;  // instability_text says what shows it
    return (where.empty() ? ": a limit load, a mechanism or a snap" : where) + "; " + control_that_goes_on(unstable);
}

/// The first of other kinds of control that goes on from the state: by the displacement that gives way, or by arc
/// length. Where the structure is unstable and as stiff as ever no other path leads on from the loads': a branching
/// point.
std::string Statics::control_that_goes_on(bool unstable) {
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
                return std::string("control by ") + component_name(driven.component) + " of " +
                       structure_->node_name(driven.node) + " goes on past it: tried over " +
                       number_text(1e3 * part * problem_.reach, 2) + " mm";
    }
    if (branches) return "a small load that moves it that way, as an imperfection, shows how it gives way";
    if (arrives(ArcLengthControl(steps, settings().target, halving_.size(), newton_.result().displacements)))
        return "control by arc length goes on past it: tried";
    return "model:dynamic with from = and allow_failed = true follows what comes after it in time";
}

/// Displacement control: the loads do not move what is driven, or it would have to turn back.
std::string Statics::advice_when_driven() {
    const int n = settings().node, c = settings().component;
    const std::string driven = std::string(component_name(c)) + " of " + structure_->node_name(n);
    w_.trial = configuration_of(state_);
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
            return ": the loads do not move " + driven + ", which is to be driven; drive what they move";
    }
    return ", where " + driven + " is " + number_text(displacement(n)[c]) + (c < 3 ? " m" : " rad") +
           ": it would have to turn back there, or the structure comes apart in another way; drive what goes on moving "
           "one way, or control by arc length";
}

}  // namespace hinge

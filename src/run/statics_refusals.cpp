// What statics refuses before it begins: mechanisms, and control that has nothing to do.
#include "algebra/modes.h"
#include "core/errors.h"
#include "core/text.h"
#include "run/statics.h"

namespace hinge {
namespace {

/// Displacement control that would change what it drives by no more than this part of it has nowhere to go.
constexpr double same_place = 1e-9;

/// Whether supports leave some body of the structure a motion as if it were rigid.
bool moves_freely(const Structure& structure, const State& state) {
    const auto bodies = nodes_of(find_bodies(structure, state));
    return std::any_of(bodies.begin(), bodies.end(),
                       [&](const auto& nodes) { return !free_motions(structure, nodes).empty(); });
}

}  // namespace

/// Of the body that the node is part of, where supports hold it, but not in all ways: where it is held, and how it can
/// move. A member that spins about its own line gives way inside; what does not hold it is its foot.
std::string Statics::loosely_held_body(int node) const {
    for (const std::vector<int>& body : nodes_of(find_bodies(*structure_, state_))) {
        if (!std::binary_search(body.begin(), body.end(), node)) continue;
        std::vector<int> supports;
        for (int n : body) {
            if (problem_.held[n] != structure_->held()[n]) return "";  // held for this run alone
            if (structure_->fixed()[n]) supports.push_back(n);
        }
        const auto motions = free_motions(*structure_, body);
        if (supports.empty() || motions.empty()) return "";
        std::string text = "a mechanism: what is supported at " + structure_->node_name(supports[0]);
        if (supports.size() > 1) text += " and " + count_text(long(supports.size()) - 1, "more node");
        return text + " can " + ways_to_move(*structure_, supports, motions);
    }
    return "";
}

/// By the elastic stiffness. Where a run goes on from one that yields, rounding may have an end flow again at once, and
/// hinges are no mechanism of the structure.
void Statics::refuse_mechanism() {
    std::vector<PlasticIncrement> flows;
    flows.swap(w_.yielding);
    tangent_.renew(1);
    flows.swap(w_.yielding);
    const int loose = tangent_.factors().loosest_degree_of_freedom(1e-12);
    if (loose < 0) return;
    static const char* way[] = {"move along x",   "move along y",   "move along z",
                                "rotate about x", "rotate about y", "rotate about z"};
    if (structure_->has_panels_alone(loose / 6))
        throw InputError(structure_->node_name(loose / 6) + " can " + way[loose % 6] +
                         " without resistance: panels alone join it. They resist along their surface as their layers "
                         "do, and across it where they bend (field 'bending') or are in tension already; a row of "
                         "supports is an axis that they turn about. Give bending, support it, or begin with dynamics");
    bool supported = false;
    for (std::uint8_t h : structure_->fixed()) supported |= h != 0;
    if (!moves_freely(*structure_, state_)) {  // rounding hides what resists
        const Element* stiffest = nullptr;
        double most = 0;
        for (int i : structure_->elements_at(loose / 6)) {
            const Element& e = structure_->elements()[i];
            const beam::Rigidity& r = e.rigidity;
            const double ratio = std::max(r.GAx / r.EIy, r.GAy / r.EIx) * e.length * e.length;
            if (ratio > most) most = ratio, stiffest = &e;
        }
        throw InputError("what resists that " + structure_->node_name(loose / 6) + " can " + way[loose % 6] +
                         " is lost in rounding: stiffnesses that meet there differ by more than 12 orders of "
                         "magnitude. " +
                         (most > 1e8 ? "The shear stiffness G A_s of member " + std::to_string(stiffest->member + 1) +
                                           " is " + number_text(most, 2) +
                                           " times EI / L^2 of its elements; a million times is as good as rigid: "
                                           "give it a smaller shear area"
                                     : std::string("Make the stiffest of them softer: a million times the others is as "
                                                   "good as rigid")));
    }
    if (const std::string body = loosely_held_body(loose / 6); !body.empty())
        throw InputError(body + " without resistance; fix what it may not do with model:fix, or fixed_group = a group");
    throw InputError(structure_->node_name(loose / 6) + " can " + way[loose % 6] + " without resistance: " +
                     (supported ? "the structure, or a part of it, is a mechanism or not supported against it"
                                : "the model has no supports, so it can move as a rigid body") +
                     "; statics needs supports that stop every rigid-body mode (model:fix, or fixed_group = a group)");
}

/// Displacement and arc length find the load factor that keeps the structure where they drive it: that of loads,
/// settlements and heat.
void Statics::refuse_idle_loads() const {
    if (settings().control == Control::load || !forces_.support_rates().empty() || forces_.are_heated()) return;
    for (std::size_t i = 0; i < w_.external.size(); ++i)
        for (int c = 0; c < 6; ++c)
            if (w_.external[i][c] != 0 && !(problem_.held[i] >> c & 1)) return;
    throw InputError(std::string("control by ") + (settings().control == Control::arc ? "arc length" : "displacement") +
                     " scales the loads that are declared, and none acts on a node that can move; declare the load "
                     "that is to do it with model:load or model:gravity, of any size");
}

/// Displacement control: from where the run begins to the target, m or rad.
double Statics::way_to_target() const {
    if (settings().control != Control::displacement) return 0;
    const int n = settings().node, c = settings().component;
    const double here = displacement(n)[c], to = settings().target;
    if (std::abs(to - here) <= same_place * std::max(std::abs(to), std::abs(here)))
        throw InputError("control: to = " + number_text(to) + (c < 3 ? " m" : " rad") + " is where " +
                         component_name(c) + " of " + structure_->node_name(n) +
                         " is already; 'to' is the displacement that run:displacement gives, not one that this run "
                         "adds to it");
    return to - here;
}

std::unique_ptr<PathControl> Statics::make_path() const {
    refuse_idle_loads();
    return make_path_control(settings(), way_to_target());
}

}  // namespace hinge

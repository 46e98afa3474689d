// Members that carry tension or compression alone: loads along them where they are slack.
#include <algorithm>
#include <cmath>

#include "advice/adviser.h"
#include "core/text.h"
#include "effects/effect_list.h"

namespace hinge {
namespace {

/// Part of the largest axial force of a structure that half of the load along a slack element may be.
constexpr double least_missed = 0.05;

/// The inertia of a slack element along itself, over the half of the load along it that is told to be missing.
constexpr double most_inertia = 0.1;

/// The sense in which an element carries axial force alone, if that is one: 1 tension, -1 compression; else 0.
int one_sense(const Structure& structure, int element) {
    switch (structure.model().members()[std::size_t(structure.elements()[std::size_t(element)].member)].carries) {
        case Carries::tension: return 1;
        case Carries::compression: return -1;
        default: return 0;
    }
}

/// N, of an element's mass at the larger one of its ends' accelerations along it; 0 in statics.
double inertia_along(const Workspace& w, int element) {
    if (!w.kind.dynamic) return 0;
    const Element& e = w.structure.elements()[std::size_t(element)];
    const auto place = [&](int end) -> Vec3 {
        return w.structure.position()[e.node[end]] + w.state.displacement[e.node[end]];
    };
    const Vec3 axis = (place(1) - place(0)).normalized();
    double most = 0;
    for (int node : e.node) most = std::max(most, std::abs(axis.dot(w.state.acceleration[node].head<3>())));
    return e.mass() * most;
}

/// A slack element has no axial force in its middle, but its nodes take half each of a load along it. The half at the
/// slack end presses on the node there, in the place of hanging from the other end: N of the part that carries is too
/// small by that. In dynamics where it does not move along itself: else its inertia carries a part of the load.
void warn_of_slack_ends(const Workspace& w, std::vector<Warning>& list) {
    double largest = 0, most = 0;
    int worst = -1;
    for (int e = 0; e < int(w.state.force.size()); ++e) {
        if (w.state.broken[e]) continue;
        const double N = w.state.force[e][4];
        const beam::FixedEnd& loads = w.assembly.fixed_end(e);
        largest = std::max({largest, std::abs(N + loads.N[0]), std::abs(N + loads.N[1])});
        const int sense = N == 0 ? one_sense(w.structure, e) : 0;
        const double missed = sense == 0 ? 0 : -std::min(sense * loads.N[0], sense * loads.N[1]);
        if (missed > (1 + 1e-9) * most && !(inertia_along(w, e) > most_inertia * missed)) most = missed, worst = e;
    }
    if (worst < 0 || !(most > least_missed * largest)) return;
    const int member = w.structure.elements()[std::size_t(worst)].member,
              elements = w.structure.model().members()[std::size_t(member)].elements,
              enough = 2 * int(std::ceil(0.5 * elements * most / (least_missed * largest)));
    const char* sense = one_sense(w.structure, worst) > 0 ? "tension" : "compression";
    list.push_back({Warning::Kind::elements,
                    "member " + std::to_string(member + 1) + " carries " + sense +
                        " alone, and where it is slack half of the load along an element, " + number_text(most, 3) +
                        " N, presses on its node, in the place of hanging from the part that carries: N there and the "
                        "reaction at its end are too small by that",
                    "elements = " + std::to_string(enough) + " for that member make it " +
                        number_text(most * elements / enough, 2) + " N",
                    line_of_member(w.structure.model(), member)});
}

class SlackEnds : public Adviser {
public:
    void list_findings(const Run& run, std::vector<Warning>& list) const override {
        warn_of_slack_ends(run.workspace(), list);
    }
};

}  // namespace

std::unique_ptr<Adviser> advise_of_slack_ends(const Run& run, WarningLog&) {
    if (!run.effect_list().has("plasticity")) return nullptr;
    return std::make_unique<SlackEnds>();
}

}  // namespace hinge

// Bodies that fell below the lowest support where no ground is declared that they could land on, and of
// columns that fell over to below their own support.
#include <algorithm>
#include <cmath>
#include <limits>

#include "advice/adviser.h"
#include "core/text.h"
#include "effects/declared.h"
#include "effects/ground.h"
#include "effects/joined_bodies.h"
#include "model/member_text.h"

namespace hinge {
namespace {

/// Whether a support that holds these degrees of freedom (bits) holds in a direction in which gravity acts.
bool carries(std::uint8_t held, const Vec3& gravity) {
    for (int c : {0, 1, 2})
        if (gravity[c] != 0 && held >> c & 1) return true;
    return false;
}

/// Reads the state alone.
class FallenBodies : public Adviser {
public:
    explicit FallenBodies(const Workspace& w) : w_(w) {}

    void list_findings(const Run&, std::vector<Warning>& list) const override {
        const Vec3 gravity = *declared_gravity(w_.structure.model()), down = gravity.normalized();
        const double lowest = lowest_support(gravity);
        const Bodies bodies = joined_bodies(w_.structure, w_.state);
        const std::vector<char> carried = carried_bodies(w_.structure, w_.state, bodies, gravity);
        std::vector<Body> of(bodies.count);
        for (std::size_t n = 0; n < bodies.of_node.size(); ++n) {
            if (bodies.of_node[n] < 0 || w_.state.gone[n]) continue;
            Body& body = of[bodies.of_node[n]];
            const double depth = w_.structure.position()[n].dot(down);
            ++body.nodes;
            body.began += depth, body.now += depth + w_.state.displacement[n].dot(down);
            body.speed += w_.state.velocity[n].head<3>().dot(down);
        }
        for (std::size_t e = 0; e < w_.structure.elements().size(); ++e) {
            const Element& element = w_.structure.elements()[e];
            const int b = bodies.of_node[element.node[0]];
            if (w_.state.broken[e] || b < 0) continue;
            if (of[b].member < 0) of[b].member = element.member;
            of[b].has_ground = of[b].has_ground || lands(element.member);
        }
        warn_of_bodies(of, carried, lowest, gravity.norm(), list);
        warn_of_columns(down, list);
    }

private:
    /// A body, with its mean depth along gravity, m times the number of its nodes.
    struct Body {
        int nodes = 0, member = -1;
        double began = 0, now = 0;
        double speed = 0;  ///< downwards, m/s times the number of its nodes
        bool has_ground = false;
    };

    /// Depth of the lowest node that is held in a direction in which gravity acts, m.
    double lowest_support(const Vec3& gravity) const {
        double lowest = -std::numeric_limits<double>::infinity();
        const auto take = [&](std::size_t n) {
            lowest = std::max(lowest, w_.structure.position()[n].dot(gravity.normalized()));
        };
        for (std::size_t n = 0; n < w_.state.held.size(); ++n)
            if (carries(w_.state.held[n], gravity)) take(n);
        for (const NodeLink& link : node_links(w_.structure.model()))
            if (link.a < 0) take(std::size_t(link.b));
        return lowest;
    }
    /// Columns that stood on a support within 45 degrees of upright and whose heads are now below it, by more than
    /// their half depth: they went through the ground that they stood on.
    void warn_of_columns(const Vec3& down, std::vector<Warning>& list) const {
        const Model& model = w_.structure.model();
        std::vector<char> broken(model.members().size(), 0);
        std::vector<double> radius(model.members().size(), 0);
        for (std::size_t e = 0; e < w_.structure.elements().size(); ++e) {
            const Element& element = w_.structure.elements()[e];
            radius[std::size_t(element.member)] = element.radius;
            if (w_.state.broken[e]) broken[std::size_t(element.member)] = 1;
        }
        int count = 0, worst = -1;
        double deepest = 0;
        for (std::size_t m = 0; m < model.members().size(); ++m) {
            if (broken[m] || lands(int(m))) continue;
            const double depth = below_its_support(model.members()[m], down);
            if (!(depth > radius[m])) continue;
            ++count;
            if (depth > deepest) deepest = depth, worst = int(m);
        }
        if (worst < 0) return;
        const std::string others = count > 1 ? " and " + count_text(count - 1, "more member") : "";
        list.push_back(
            {Warning::Kind::contact,
             member_text(model, worst) + others + " fell over, to " + number_text(deepest, 3) +
                 " m below the support that " +
                 (count > 1 ? "they stood on, and no ground is for them" : "it stood on, and no ground is for it"),
             "model:ground {} catches what falls", line_of_member(model, worst)});
    }
    /// How far the head of a column is below its support now, m; negative for what was no column on a support.
    double below_its_support(const MemberData& member, const Vec3& down) const {
        const auto& nodes = w_.structure.model().nodes();
        for (const int end : {0, 1}) {
            const std::size_t foot = std::size_t(member.node[end]), head = std::size_t(member.node[1 - end]);
            const Vec3 up = nodes[head].position - nodes[foot].position;
            if ((nodes[foot].fixed & 7) != 7 || (nodes[head].fixed & 7) == 7 || !(-up.dot(down) > 0.7 * up.norm()))
                continue;
            return (up + w_.state.displacement[head] - w_.state.displacement[foot]).dot(down);
        }
        return -1;
    }
    /// Whether a ground is for this member.
    bool lands(int member) const {
        const auto& planes = w_.structure.model().declared<GroundPlane>(ground_effect);
        const auto& groups = w_.structure.model().members()[member].groups;
        return std::any_of(planes.begin(), planes.end(), [&](const GroundPlane& p) {
            return p.group < 0 || std::find(groups.begin(), groups.end(), p.group) != groups.end();
        });
    }
    /// What lies on members that sag is below their supports, too, but does not fall: free fall from the supports down
    /// to this depth has a speed of sqrt(2 g depth) at least.
    static bool falls(double speed, double depth, double g) { return speed > 0.5 * std::sqrt(2 * g * depth); }
    void warn_of_bodies(const std::vector<Body>& bodies, const std::vector<char>& carried, double lowest,
                        double gravity, std::vector<Warning>& list) const {
        int count = 0, worst = -1;
        double deepest = 0;
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            const Body& body = bodies[b];
            if (carried[b] || body.has_ground || body.member < 0) continue;
            const double began = body.began / body.nodes - lowest, now = body.now / body.nodes - lowest;
            if (!(began <= 0 && now > 0) || !falls(body.speed / body.nodes, now, gravity)) continue;
            ++count;
            if (now > deepest) deepest = now, worst = body.member;
        }
        if (worst < 0) return;
        const bool any = !w_.structure.model().declared<GroundPlane>(ground_effect).empty();
        list.push_back({Warning::Kind::contact,
                        (count == 1 ? "a body fell" : std::to_string(count) + " bodies fell") +
                            " below the lowest support, that of " + member_text(w_.structure.model(), worst) + " by " +
                            number_text(deepest, 3) + " m at the end, and " +
                            (any ? "no ground is for them" : "no ground is declared"),
                        "model:ground {} catches what falls; model:contact lets it land on other members",
                        line_of_member(w_.structure.model(), worst)});
    }

    const Workspace& w_;
};

bool joins_ground(const Model& model) {
    const std::vector<NodeLink> links = node_links(model);
    return std::any_of(links.begin(), links.end(), [](const NodeLink& link) { return link.a < 0; });
}

bool may_fall_below_supports(const Structure& s) {
    const Model& model = s.model();
    const auto gravity = declared_gravity(model);
    const auto& planes = model.declared<GroundPlane>(ground_effect);
    const bool for_all = std::any_of(planes.begin(), planes.end(), [](const GroundPlane& p) { return p.group < 0; });
    return gravity && !gravity->isZero(0) && !for_all &&
           (std::any_of(model.nodes().begin(), model.nodes().end(),
                        [&](const NodeData& n) { return carries(n.fixed, *gravity); }) ||
            joins_ground(model));
}

}  // namespace

std::unique_ptr<Adviser> advise_of_fallen_bodies(const Run& run, WarningLog&) {
    if (!run.workspace().kind.dynamic || !may_fall_below_supports(run.structure())) return nullptr;
    return std::make_unique<FallenBodies>(run.workspace());
}

}  // namespace hinge

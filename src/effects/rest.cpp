// Bodies at rest take no part in a step until something reaches them. A body is at rest from the start where it does
// not move and its forces are in balance, and later where it lies on the ground and hardly moves any more. Panels join
// nodes to a body as members do. Bodies that lie on each other (Effect::lie_together) rest together, where one of them
// lies on the ground or is made of panels that are held: the contacts between them stay as they are. All of them take
// part again when one is reached.
//
// What lies on the ground has lost its motion to friction and to the ground's damping, but for vibrations along its
// members that nothing damps. It comes to rest when, for ten times as long as it would take to fall by the half depth r
// of its members and panels,
//
//   no node moves by more than a five hundredth of r, of panels a hundredth, or rotates by a five hundredth of a
//   radian, and
//   the kinetic energy is below a thousandth of m g r, which would lift it by r.
//
// By hand, the end of a bar of 1.5 m and r = 50 mm that topples from a hundredth of a degree moves 28 times as far in
// that time, and a plate of 1 m and r = 10 mm on its edge three times as far. A bent bar that rolls onto its back and
// down again hardly moves for a third of it. The kinetic energy that the body still has goes to the account of the
// ground, or where no ground is declared to that of contact of panels.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/rotation.h"
#include "core/text.h"
#include "effects/declared.h"
#include "effects/kinds.h"
#include "effects/panel_contact.h"
#include "effects/panels.h"
#include "state/breaking.h"
#include "state/node_mass.h"

namespace hinge {
namespace {

/// A body begins at rest if what is out of balance in it is less than this part of what holds it: a static run leaves
/// 1e-8 or so. Moments count as forces at the ends of its longest element.
constexpr double balanced = 1e-6;

constexpr double falls = 10;           ///< in which a body must lie still, each by the half depth of its members
constexpr double half_of_edge = 0.01;  ///< the half depth of a panel without thickness, over its shortest edge
constexpr double still_part = 0.002;   ///< of the half depth: how far a member may move in that time; rad
constexpr double still_panel = 0.01;   ///< the same of a panel: plates that lie on plates sway on friction's springs
constexpr double still_energy = 1e-3;  ///< over m g r
constexpr int looks = 8;               ///< in that time

class Rest : public Effect, public RestKeeper {
public:
    /// A run of the energy-momentum method leaves no body at rest.
    Rest(Workspace& w, Host& host) : Effect("rest", w, host, {.mean_forces = true}) {
        const std::optional<Vec3> g = declared_gravity(w.structure.model());
        const Model& model = w.structure.model();
        has_ground_ = !declared_planes(model).empty();
        find_half_depths();
        const bool on_panels = !panels_.empty() && !model.declared<PanelContactRule>(panel_contact_effect).empty();
        if (!g || !(has_ground_ || on_panels)) return;
        gravity_ = g->norm();
        double least = 0;
        const auto take = [&](double radius) {
            if (radius > 0 && !(least > 0 && least < radius)) least = radius;
        };
        for (const Element& e : w.structure.elements()) take(e.radius);
        for (const double half : half_) take(half);
        if (gravity_ > 0) between_looks_ = time_still(least) / looks;
    }

    /// Puts to rest every body that does not move, that nothing will move but contact, and whose forces are in balance.
    void started(const std::vector<Vec6>& out_of_balance) override {
        const State& s = w_.state;
        const auto& elements = w_.structure.elements();
        const Bodies bodies = bodies_now();
        std::vector<char> rests(bodies.count, 1);
        std::vector<double> out(bodies.count, 0), holding(bodies.count, 0), arm(bodies.count, 0);
        for (std::size_t e = 0; e < elements.size(); ++e)
            if (!s.broken[e]) {
                double& longest = arm[bodies.of_node[elements[e].node[0]]];
                longest = std::max(longest, elements[e].length);
            }
        for (std::size_t n = 0; n < bodies.of_node.size(); ++n) {
            const int b = bodies.of_node[n];
            if (b < 0) continue;
            if (!s.velocity[n].isZero(0)) rests[b] = 0;
            const auto size = [&](const Vec6& f) {
                return f.head<3>().squaredNorm() + f.tail<3>().squaredNorm() / (arm[b] * arm[b]);
            };
            out[b] += size(out_of_balance[n]);
            holding[b] += size(w_.external[n]);
            if (const auto r = w_.reaction.find(int(n)); r != w_.reaction.end()) holding[b] += size(r->second);
        }
        host_.keep_from_rest(bodies, rests);
        for (int b = 0; b < bodies.count; ++b)
            if (!(out[b] <= balanced * balanced * holding[b])) rests[b] = 0;
        const std::vector<int> pile = piles(bodies);
        keep_whole(pile, rests);
        put_to_rest(bodies, pile, rests, "at rest until something reaches them");
    }

    /// Looks now and then which bodies lie still.
    void after_commit(const Step& step) override {
        if (!(between_looks_ > 0) || step.end() < next_look_) return;
        next_look_ = step.end() + between_looks_;
        const Bodies bodies = bodies_now();
        const std::vector<int> pile = piles(bodies);
        std::vector<char> lies = may_lie(bodies, pile);
        if (none(lies)) return watched_.clear();
        host_.keep_from_rest(bodies, lies);
        keep_whole(pile, lies);
        keep_still(bodies, step.end(), lies);
        keep_whole(pile, lies);
        if (none(lies)) return;
        const double before = kinetic_energy(w_.structure, w_.state);
        for (std::size_t n = 0; n < bodies.of_node.size(); ++n)
            if (const int b = bodies.of_node[n]; b >= 0 && lies[b]) {
                w_.state.velocity[n].setZero();
                if (!w_.weighted.empty()) w_.weighted[n].setZero();
            }
        w_.state.accumulated[has_ground_ ? "ground_dissipated" : "panel_contact_lost"] +=
            before - kinetic_energy(w_.structure, w_.state);
        put_to_rest(bodies, pile, lies, has_ground_ ? "came to rest on the ground" : "came to rest");
    }

    /// A body at rest that something reaches, or that breaks, takes part again.
    void reached(const std::vector<Reached>& list) override {
        std::vector<int>& resting = w_.resting;
        if (resting.empty()) return;
        const auto& elements = w_.structure.elements();
        std::vector<int> woken;
        for (const Reached& r : list) {
            const int b = resting[r.node >= 0 ? r.node : elements[r.element].node[0]];
            if (b < 0 || std::find(woken.begin(), woken.end(), b) != woken.end()) continue;
            woken.push_back(b);
            host_.note_activation(
                "body", true,
                std::string("it was at rest; ") + r.how + " at " +
                    (r.node >= 0 ? w_.structure.node_name(r.node) : w_.structure.element_name(r.element)));
        }
        if (woken.empty()) return;
        const auto wakes = [&](int node) {
            return resting[node] >= 0 && std::find(woken.begin(), woken.end(), resting[node]) != woken.end();
        };
        for (std::size_t e = 0; e < elements.size(); ++e)
            if (!w_.state.broken[e] && wakes(elements[e].node[0])) w_.assembly.activate(int(e));
        for (int n = 0; n < int(resting.size()); ++n)
            if (wakes(n)) {
                w_.external[n] = weight_[n];
                weight_.erase(n);
                resting[n] = -1;
                if (w_.state.held[n]) w_.supported.push_back(n);
            }
        std::sort(w_.supported.begin(), w_.supported.end());
        if (weight_.empty()) resting.clear();
        changed();
    }

    void save(Writer& to) const override { to(w_.resting, weight_, next_look_, watched_); }
    void restore(Reader& from) override { from(w_.resting, weight_, next_look_, watched_); }
    bool restored(std::span<const State* const>) override {
        const int nodes = int(w_.structure.position().size());
        for (const auto& [node, weight] : weight_)
            if (node < 0 || node >= nodes) return false;
        if (!w_.resting.empty() && int(w_.resting.size()) != nodes) return false;
        if (!watched_.empty() && int(watched_.size()) != nodes) return false;
        host_.rest_changed();
        return true;
    }

private:
    /// Where a node was when its body last moved.
    struct Watched {
        double since = -1;  ///< s; negative: not looked at yet
        Vec3 displacement = Vec3::Zero();
        Quat rotation = Quat::Identity();
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.since, s.displacement, s.rotation);
        }
    };

    static bool none(const std::vector<char>& of) {
        return std::none_of(of.begin(), of.end(), [](char c) { return c; });
    }
    void find_half_depths() {
        half_.assign(panels_.empty() ? 0 : w_.structure.position().size(), 0);
        for (const Panel& p : panels_) {
            double half = 0.5 * p.sheet->thickness(), edge = std::numeric_limits<double>::infinity();
            for (std::size_t k = 0; k < p.nodes.size(); ++k)
                edge = std::min(edge, (w_.structure.position()[std::size_t(p.nodes[k])] -
                                       w_.structure.position()[std::size_t(p.nodes[(k + 1) % p.nodes.size()])])
                                          .norm());
            if (!(half > 0)) half = half_of_edge * edge;
            for (const int n : p.nodes) half_[std::size_t(n)] = std::max(half_[std::size_t(n)], half);
        }
    }
    /// Joins those of several sets that belong together: the first of each, of all.
    static void join(std::vector<int>& first, int a, int b) {
        const auto root = [&](int i) {
            while (first[std::size_t(i)] != i) i = first[std::size_t(i)] = first[std::size_t(first[std::size_t(i)])];
            return i;
        };
        a = root(a), b = root(b);
        first[std::size_t(std::max(a, b))] = std::min(a, b);
    }
    static std::vector<int> first_of_each(std::vector<int> first) {
        for (std::size_t i = 0; i < first.size(); ++i)
            first[i] = first[std::size_t(first[i])];  // the lower ones are done
        return first;
    }
    static std::vector<int> each_alone(int count) {
        std::vector<int> first(std::size_t(count), 0);
        std::iota(first.begin(), first.end(), 0);
        return first;
    }

    /// Bodies that whole elements and panels connect, numbered by their first nodes.
    Bodies bodies_now() const {
        Bodies bodies = find_bodies(w_.structure, w_.state);
        if (panels_.empty()) return bodies;
        std::vector<int> first = each_alone(bodies.count);
        const PanelsNow& now = *panels_now(w_.state);
        for (std::size_t i = 0; i < panels_.size(); ++i) {
            const int b = bodies.of_node[std::size_t(panels_[i].nodes[0])];
            if (b < 0 || is_torn(now, panels_[i], i)) continue;
            for (const int n : panels_[i].nodes)
                if (const int other = bodies.of_node[std::size_t(n)]; other >= 0) join(first, b, other);
        }
        first = first_of_each(std::move(first));
        std::vector<int> number(first.size(), 0);
        for (std::size_t b = 0, next = 0; b < first.size(); ++b)
            number[b] = first[b] == int(b) ? int(next++) : number[std::size_t(first[b])];
        bodies.count = 0;
        for (int& b : bodies.of_node)
            if (b >= 0) b = number[std::size_t(b)], bodies.count = std::max(bodies.count, b + 1);
        return bodies;
    }
    /// Of each body, the first of those that lie on each other.
    std::vector<int> piles(const Bodies& bodies) const {
        BodyPairs pairs;
        host_.lie_together(bodies, pairs);
        std::vector<int> first = each_alone(bodies.count);
        for (const auto& [a, b] : pairs)
            if (a >= 0 && b >= 0) join(first, a, b);
        return first_of_each(std::move(first));
    }
    /// Leaves the piles of which all bodies are marked.
    static void keep_whole(const std::vector<int>& pile, std::vector<char>& marked) {
        std::vector<char> whole(pile.size(), 1);
        for (std::size_t b = 0; b < pile.size(); ++b)
            if (!marked[b]) whole[std::size_t(pile[b])] = 0;
        for (std::size_t b = 0; b < pile.size(); ++b) marked[b] = whole[std::size_t(pile[b])];
    }
    /// The bodies of piles that something holds up, none of which rests. What has supports is followed, unless it
    /// consists of panels all of whose nodes are held.
    std::vector<char> may_lie(const Bodies& bodies, const std::vector<int>& pile) const {
        std::vector<char> held_up(std::size_t(bodies.count), 0), has_supports(held_up), may_move(held_up),
            rests(held_up);
        host_.hold_up(bodies, held_up);
        for (std::size_t n = 0; n < bodies.of_node.size(); ++n) {
            const int b = bodies.of_node[n];
            if (b < 0) continue;
            const bool of_panels = w_.structure.has_panels_alone(int(n));
            const int held = of_panels ? w_.state.held[n] & 7 : w_.state.held[n];
            if (held) has_supports[b] = 1;
            if (!of_panels || held != 7) may_move[b] = 1;
            if (w_.rests(int(n))) rests[b] = 1;
        }
        std::vector<char> carried(std::size_t(bodies.count), 0), lies(carried);
        for (std::size_t b = 0; b < pile.size(); ++b)
            if (held_up[b] || (has_supports[b] && !may_move[b])) carried[pile[b]] = 1;
        for (std::size_t b = 0; b < pile.size(); ++b)
            lies[b] = carried[pile[b]] && !rests[b] && !(has_supports[b] && may_move[b]);
        keep_whole(pile, lies);
        return lies;
    }
    double time_still(double radius) const { return falls * std::sqrt(2 * radius / gravity_); }

    Quat rotation_of(std::size_t node) const {
        return w_.structure.large() ? w_.state.rotation[node]
                                    : rotated(w_.state.small_rotation[node], Quat::Identity());
    }

    /// Leaves those of the bodies that have not moved for long enough. Where one has moved, it is watched from now on.
    void keep_still(const Bodies& bodies, double now, std::vector<char>& lies) {
        const State& s = w_.state;
        watched_.resize(bodies.of_node.size());
        struct Body {
            double radius = 0, still = 0, weight = 0, energy = 0, moved = 0, rotated = 0;
            bool is_new = false;
        };
        std::vector<Body> all(bodies.count);
        for (std::size_t e = 0; e < w_.structure.elements().size(); ++e) {
            const Element& element = w_.structure.elements()[e];
            const int b = bodies.of_node[element.node[s.broken[e] == 1 ? 1 : 0]];  // which carries what is left of it
            if (b < 0 || !lies[b]) continue;
            all[b].radius = std::max(all[b].radius, element.radius);
            all[b].still = still_part * all[b].radius;
            if (s.broken[e]) continue;
            all[b].weight += element.mass() * gravity_;
            all[b].energy += kinetic_energy(w_.structure, s, int(e), axes_of(element_frame(w_.structure, int(e), s)));
        }
        for (std::size_t n = 0; n < s.offset_mass.size(); ++n) {
            const int b = bodies.of_node[n];
            if (b < 0 || !lies[b] || s.offset_mass[n].mass == 0) continue;
            all[b].weight += s.offset_mass[n].mass * gravity_;
            all[b].energy +=
                0.5 * s.velocity[n].dot(offset_mass_in_space(s.offset_mass[n], s.rotation[n]) * s.velocity[n]);
        }
        for (std::size_t n = 0; n < watched_.size(); ++n) {
            const int b = bodies.of_node[n];
            if (b < 0 || !lies[b]) continue;
            const Watched& at = watched_[n];
            Body& body = all[b];
            if (at.since < 0) body.is_new = true;
            if (!half_.empty()) {
                body.radius = std::max(body.radius, half_[n]);
                body.still = std::max(body.still, still_panel * half_[n]);
            }
            body.moved = std::max(body.moved, (s.displacement[n] - at.displacement).norm());
            body.rotated = std::max(body.rotated, rotation_of(n).angularDistance(at.rotation));
        }
        for (std::size_t n = 0; n < watched_.size(); ++n) {
            const int b = bodies.of_node[n];
            if (b < 0 || !lies[b]) {
                watched_[n] = {};
                continue;
            }
            const Body& body = all[b];
            const bool moves = body.is_new || !(body.radius > 0) || !(body.moved <= body.still) ||
                               !(body.rotated <= still_part) ||
                               !(body.energy <= still_energy * body.weight * body.radius);
            if (moves) watched_[n] = {now, s.displacement[n], rotation_of(n)};
        }
        for (std::size_t n = 0; n < watched_.size(); ++n) {
            const int b = bodies.of_node[n];
            if (b >= 0 && lies[b] && now - watched_[n].since < time_still(all[b].radius)) lies[b] = 0;
        }
    }

    /// Takes bodies out of the steps to come.
    void put_to_rest(const Bodies& bodies, const std::vector<int>& pile, const std::vector<char>& rests,
                     const char* what) {
        if (none(rests)) return;
        std::vector<int>& resting = w_.resting;
        const int others = resting.empty() ? 0 : 1 + *std::max_element(resting.begin(), resting.end());
        resting.resize(bodies.of_node.size(), -1);
        const auto comes_to_rest = [&](int node) {
            const int b = bodies.of_node[node];
            return b >= 0 && rests[b];
        };
        for (int n = 0; n < int(resting.size()); ++n) {
            if (!comes_to_rest(n)) continue;
            resting[n] = others + pile[std::size_t(bodies.of_node[n])];
            w_.state.acceleration[n].setZero();
            weight_[n] = w_.external[n];
            w_.external[n].setZero();
        }
        const long count = std::count_if(rests.begin(), rests.end(), [](char r) { return r != 0; });
        long still = 0, panels = 0;
        const auto& elements = w_.structure.elements();
        for (std::size_t e = 0; e < elements.size(); ++e) {
            if (!comes_to_rest(elements[e].node[0])) continue;
            ++still;
            if (!w_.state.broken[e]) w_.assembly.deactivate(int(e));
        }
        for (const Panel& p : panels_) panels += comes_to_rest(p.nodes[0]);
        std::string of = still > 0 || panels == 0 ? count_text(still, "element") : "";
        if (panels > 0) of += (of.empty() ? "" : " and ") + count_text(panels, "panel");
        host_.note_activation(count == 1 ? "body" : std::to_string(count) + " bodies", false, of + " " + what);
        std::erase_if(w_.supported, comes_to_rest);
        changed();
    }
    void changed() {
        host_.rest_changed();
        if (!panels_.empty()) host_.blocks_changed(w_.state);
    }

    const std::vector<Panel>& panels_ = w_.structure.model().declared<Panel>(panels_effect);
    std::vector<double> half_;  ///< of each node, half the thickness of its panels, m; empty without panels
    bool has_ground_ = false;
    double gravity_ = 0, between_looks_ = 0;  ///< m/s^2; s, 0: nothing can come to rest later
    double next_look_ = 0;                    ///< s
    std::vector<Watched> watched_;            ///< of each node; empty: nothing lies on the ground
    std::unordered_map<int, Vec6> weight_;    ///< F of the nodes at rest
};

}  // namespace

EffectKind rest_kind() {
    return {.name = "rest",
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                if (!w.kind.rest) return nullptr;
                return std::make_unique<Rest>(w, host);
            },
            .dynamic_only = true};
}

}  // namespace hinge

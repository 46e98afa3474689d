// Bodies at rest take no part in a step until something reaches them. A body is at rest from the start where it does
// not move and its forces are in balance, and later where it lies on the ground and hardly moves any more.
//
// What lies on the ground has lost its motion to friction and to the ground's damping, but for vibrations along its
// members that nothing damps. It comes to rest when, for ten times as long as it would take to fall by the half depth r
// of its members,
//
//   no node moves by more than a five hundredth of r, or rotates by as many radians, and
//   the kinetic energy is below a thousandth of m g r, which would lift it by r.
//
// By hand, the end of a bar of 1.5 m and r = 50 mm that topples from a hundredth of a degree moves 28 times as far in
// that time. A bent bar that rolls onto its back and down again hardly moves for a third of it. The kinetic energy that
// the body still has goes to the account of the ground.
#include <algorithm>
#include <cmath>

#include "core/rotation.h"
#include "core/text.h"
#include "effects/declared.h"
#include "effects/kinds.h"
#include "state/breaking.h"
#include "state/node_mass.h"

namespace hinge {
namespace {

/// A body begins at rest if what is out of balance in it is less than this part of what holds it: a static run leaves
/// 1e-8 or so. Moments count as forces at the ends of its longest element.
constexpr double balanced = 1e-6;

constexpr double falls = 10;           ///< in which a body must lie still, each by the half depth of its members
constexpr double still_part = 0.002;   ///< of the half depth: how far it may move in that time; rad
constexpr double still_energy = 1e-3;  ///< over m g r
constexpr int looks = 8;               ///< in that time

class Rest : public Effect, public RestKeeper {
public:
    /// A run of the energy-momentum method leaves no body at rest.
    Rest(Workspace& w, Host& host) : Effect("rest", w, host, {.mean_forces = true}) {
        const std::optional<Vec3> g = declared_gravity(w.structure.model());
        if (!g || declared_planes(w.structure.model()).empty()) return;
        gravity_ = g->norm();
        double least = 0;
        for (const Element& e : w.structure.elements())
            if (e.radius > 0 && !(least > 0 && least < e.radius)) least = e.radius;
        if (gravity_ > 0) between_looks_ = time_still(least) / looks;
    }

    /// Puts to rest every body that does not move, that nothing will move but contact, and whose forces are in balance.
    void started(const std::vector<Vec6>& out_of_balance) override {
        const State& s = w_.state;
        const auto& elements = w_.structure.elements();
        const Bodies bodies = find_bodies(w_.structure, s);
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
        put_to_rest(bodies, rests, "at rest until something reaches them");
    }

    /// Looks now and then which bodies lie still.
    void after_commit(const Step& step) override {
        if (!(between_looks_ > 0) || step.end() < next_look_) return;
        next_look_ = step.end() + between_looks_;
        const Bodies bodies = find_bodies(w_.structure, w_.state);
        std::vector<char> lies(bodies.count, 0);
        host_.hold_up(bodies, lies);
        for (std::size_t n = 0; n < bodies.of_node.size(); ++n)
            if (const int b = bodies.of_node[n]; b >= 0 && (w_.state.held[n] || w_.rests(int(n)))) lies[b] = 0;
        if (none(lies)) return watched_.clear();
        host_.keep_from_rest(bodies, lies);
        keep_still(bodies, step.end(), lies);
        if (none(lies)) return;
        const double before = kinetic_energy(w_.structure, w_.state);
        for (std::size_t n = 0; n < bodies.of_node.size(); ++n)
            if (const int b = bodies.of_node[n]; b >= 0 && lies[b]) {
                w_.state.velocity[n].setZero();
                if (!w_.weighted.empty()) w_.weighted[n].setZero();
            }
        w_.state.accumulated["ground_dissipated"] += before - kinetic_energy(w_.structure, w_.state);
        put_to_rest(bodies, lies, "came to rest on the ground");
    }

    /// A body at rest that something reaches, or that breaks, takes part again.
    void reached(const std::vector<Reached>& list) override {
        std::vector<int>& resting = w_.resting;
        if (resting.empty()) return;
        const auto& elements = w_.structure.elements();
        std::vector<int> woken;
        for (const Reached& r : list) {
            const int b = resting[elements[r.element].node[0]];
            if (b < 0 || std::find(woken.begin(), woken.end(), b) != woken.end()) continue;
            woken.push_back(b);
            host_.note_activation(
                "body", true, std::string("it was at rest; ") + r.how + " at " + w_.structure.element_name(r.element));
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
        host_.rest_changed();
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
            double radius = 0, weight = 0, energy = 0, moved = 0, rotated = 0;
            bool is_new = false;
        };
        std::vector<Body> all(bodies.count);
        for (std::size_t e = 0; e < w_.structure.elements().size(); ++e) {
            const Element& element = w_.structure.elements()[e];
            const int b = bodies.of_node[element.node[s.broken[e] == 1 ? 1 : 0]];  // which carries what is left of it
            if (b < 0 || !lies[b]) continue;
            all[b].radius = std::max(all[b].radius, element.radius);
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
            const bool moves = body.is_new || !(body.radius > 0) || !(body.moved <= still_part * body.radius) ||
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
    void put_to_rest(const Bodies& bodies, const std::vector<char>& rests, const char* what) {
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
            resting[n] = others + bodies.of_node[n];
            w_.state.acceleration[n].setZero();
            weight_[n] = w_.external[n];
            w_.external[n].setZero();
        }
        const long count = std::count_if(rests.begin(), rests.end(), [](char r) { return r != 0; });
        const auto& elements = w_.structure.elements();
        long still = 0;
        for (std::size_t e = 0; e < elements.size(); ++e) {
            if (!comes_to_rest(elements[e].node[0])) continue;
            ++still;
            if (!w_.state.broken[e]) w_.assembly.deactivate(int(e));
        }
        host_.note_activation(count == 1 ? "body" : std::to_string(count) + " bodies", false,
                              count_text(still, "element") + " " + what);
        std::erase_if(w_.supported, comes_to_rest);
        host_.rest_changed();
    }

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

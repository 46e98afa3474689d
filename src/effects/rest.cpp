// Bodies at rest take no part in a step until something reaches them.
#include <algorithm>

#include "core/text.h"
#include "effects/kinds.h"

namespace hinge {
namespace {

/// A body is at rest if what is out of balance in it is less than this part of what holds it: a static run leaves 1e-8
/// or so. Moments count as forces at the ends of its longest element.
constexpr double balanced = 1e-6;

class Rest : public Effect, public RestKeeper {
public:
    /// A run of the energy-momentum method leaves no body at rest.
    Rest(Workspace& w, Host& host) : Effect("rest", w, host, {.mean_forces = true}) {}

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
        if (std::none_of(rests.begin(), rests.end(), [](char r) { return r; })) return;

        std::vector<int>& resting = w_.resting;
        resting.assign(bodies.of_node.size(), -1);
        for (std::size_t n = 0; n < resting.size(); ++n) {
            const int b = bodies.of_node[n];
            if (b < 0 || !rests[b]) continue;
            resting[n] = b;
            w_.state.acceleration[n].setZero();
            weight_[int(n)] = w_.external[n];
            w_.external[n].setZero();
        }
        const int count = int(std::count(rests.begin(), rests.end(), 1));
        long still = 0;
        for (const Element& e : elements) still += resting[e.node[0]] >= 0;
        host_.note_activation(count == 1 ? "body" : std::to_string(count) + " bodies", false,
                              count_text(still, "element") + " at rest until something reaches them");
        std::erase_if(w_.supported, [&](int n) { return resting[n] >= 0; });
        for (std::size_t e = 0; e < elements.size(); ++e)
            if (!s.broken[e] && resting[elements[e].node[0]] >= 0) w_.assembly.deactivate(int(e));
        host_.leave_out(resting);
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
        host_.leave_out(resting);
        if (weight_.empty()) resting.clear();
    }

    void save(Writer& to) const override { to(w_.resting, weight_); }
    void restore(Reader& from) override { from(w_.resting, weight_); }
    bool restored(std::span<const State* const>) override {
        const int nodes = int(w_.structure.position().size());
        for (const auto& [node, weight] : weight_)
            if (node < 0 || node >= nodes) return false;
        if (!w_.resting.empty() && int(w_.resting.size()) != nodes) return false;
        host_.leave_out(w_.resting);
        return true;
    }

private:
    std::unordered_map<int, Vec6> weight_;  ///< F of the nodes at rest
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

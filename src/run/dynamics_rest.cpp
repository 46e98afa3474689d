// Dynamics, what is left alone: bodies at rest until something reaches them, and when an effect has something to do.
#include <algorithm>
#include <cmath>

#include "state/bodies.h"
#include "run/dynamics.h"

namespace hinge {
namespace {

/// A body is at rest if what is out of balance in it is less than this part of what holds it: a static run leaves 1e-8
/// or so. Moments count as forces at the ends of its longest element.
constexpr double balanced = 1e-6;

/// Steps without anything to do after which an effect is said to sleep.
constexpr long quiet_steps = 100;

}  // namespace

/// Puts to rest every body that does not move, that nothing will move but contact, and whose forces are in balance.
/// Called with nodal_ as find_acceleration left it: what is out of balance.
void Dynamics::let_rest() {
    const Bodies bodies = find_bodies(*structure_, state_);
    std::vector<char> rests(bodies.count, 1);
    std::vector<double> out(bodies.count, 0), holding(bodies.count, 0), arm(bodies.count, 0);
    for (std::size_t e = 0; e < structure_->elements().size(); ++e)
        if (!state_.broken[e]) {
            const Element& element = structure_->elements()[e];
            double& longest = arm[bodies.of_node[element.node[0]]];
            longest = std::max(longest, element.length);
        }
    for (std::size_t n = 0; n < bodies.of_node.size(); ++n) {
        const int b = bodies.of_node[n];
        if (b < 0) continue;
        if (!state_.velocity[n].isZero(0) || (!state_.offset_mass.empty() && state_.offset_mass[n].mass > 0))
            rests[b] = 0;
        const auto size = [&](const Vec6& f) {
            return f.head<3>().squaredNorm() + f.tail<3>().squaredNorm() / (arm[b] * arm[b]);
        };
        out[b] += size(nodal_[n]);
        holding[b] += size(external_[n]);
        if (const auto r = reaction_.find(int(n)); r != reaction_.end()) holding[b] += size(r->second);
    }
    for (const Moved& m : moved_)
        if (bodies.of_node[m.node] >= 0) rests[bodies.of_node[m.node]] = 0;
    for (const NodalLoad& load : structure_->model().loads())
        if ((load.history || load.follows_state()) && bodies.of_node[load.node] >= 0)
            rests[bodies.of_node[load.node]] = 0;
    for (const contact::SurfaceContact& t :
         state_.contact ? state_.contact->surface_contacts() : std::vector<contact::SurfaceContact>{})
        for (int e : t.element) rests[bodies.of_node[structure_->elements()[e].node[0]]] = 0;
    for (const contact::Tie& t : state_.contact ? state_.contact->ties() : std::vector<contact::Tie>{})
        for (int e : t.element) rests[bodies.of_node[structure_->elements()[e].node[0]]] = 0;
    for (int b = 0; b < bodies.count; ++b)
        if (!(out[b] <= balanced * balanced * holding[b])) rests[b] = 0;
    if (std::none_of(rests.begin(), rests.end(), [](char r) { return r; })) return;

    resting_.assign(bodies.of_node.size(), -1);
    for (std::size_t n = 0; n < resting_.size(); ++n) {
        const int b = bodies.of_node[n];
        if (b < 0 || !rests[b]) continue;
        resting_[n] = b;
        state_.acceleration[n].setZero();
        weight_at_rest_[int(n)] = external_[n];
        external_[n].setZero();
    }
    const int count = int(std::count(rests.begin(), rests.end(), 1));
    long elements = 0;
    for (const Element& e : structure_->elements()) elements += resting_[e.node[0]] >= 0;
    note_waking(count == 1 ? "body" : std::to_string(count) + " bodies", false,
                std::to_string(elements) + " elements at rest until something reaches them");
    std::erase_if(held_nodes_, [&](int n) { return resting_[n] >= 0; });
    for (std::size_t e = 0; e < structure_->elements().size(); ++e)
        if (!state_.broken[e] && resting_[structure_->elements()[e].node[0]] >= 0) sweep_.drop(int(e));
    if (effective_) effective_->leave_out(resting_);
}

/// A body at rest that something reaches, or that breaks, takes part again.
void Dynamics::wake_bodies() {
    if (resting_.empty()) return;
    std::vector<int> woken;
    const auto heed = [&](int e, const char* what) {
        const int b = resting_[structure_->elements()[e].node[0]];
        if (b < 0 || std::find(woken.begin(), woken.end(), b) != woken.end()) return;
        woken.push_back(b);
        note_waking("body", true, std::string("it was at rest; ") + what + " at " + structure_->element_name(e));
    };
    const auto heed_pairs = [&](const auto& pairs) {
        for (const auto& pair : pairs)
            for (int e : pair.element) heed(e, "reached");
    };
    for (const auto& [element, end] : to_break_) heed(element, "broken");
    if (with_contact()) heed_pairs(state_.contact->surface_contacts()), heed_pairs(state_.contact->ties());
    if (woken.empty()) return;
    const auto wakes = [&](int node) {
        return resting_[node] >= 0 && std::find(woken.begin(), woken.end(), resting_[node]) != woken.end();
    };
    for (std::size_t e = 0; e < structure_->elements().size(); ++e)
        if (!state_.broken[e] && wakes(structure_->elements()[e].node[0])) sweep_.raise(int(e));
    for (int n = 0; n < int(resting_.size()); ++n)
        if (wakes(n)) {
            external_[n] = weight_at_rest_[n];
            weight_at_rest_.erase(n);
            resting_[n] = -1;
            if (state_.held[n]) held_nodes_.push_back(n);
        }
    std::sort(held_nodes_.begin(), held_nodes_.end());
    if (effective_) effective_->leave_out(resting_);
    if (weight_at_rest_.empty()) resting_.clear();
}

void Dynamics::note_waking(std::string effect, bool awake, std::string why) {
    if (wakings_.size() < 1000) wakings_.push_back({state_.time, std::move(effect), awake, std::move(why)});
}

/// Called once a step for each effect that can sleep; `busy`: it had something to do.
template <class Why>
void Dynamics::watch(Sleeper& s, bool busy, Why why) {
    if (busy) {
        if (!s.awake) note_waking(s.effect, true, why());
        s.awake = true;
        s.quiet = 0;
    } else if (s.awake && ++s.quiet >= quiet_steps) {
        s.awake = false;
        note_waking(s.effect, false, "nothing to do for " + std::to_string(quiet_steps) + " steps");
    }
}

void Dynamics::watch_effects() {
    if (with_contact()) {
        const contact::Contact& c = *state_.contact;
        const contact::Nearest& nearest = c.nearest();
        const bool looked = nearest.element[0] >= 0;
        watch(contact_sleeper_, looked || !c.idle(), [&] {
            if (!looked) return std::string("members bound or touching");
            char text[64];
            std::snprintf(text, sizeof text, "2 bodies within %.2g m: ", std::max(0.0, nearest.distance));
            return text + structure_->element_name(nearest.element[0]) + " and " +
                   structure_->element_name(nearest.element[1]);
        });
    }
    if (can_yield())
        watch(plasticity_sleeper_, !yielding_.empty(), [&] {
            return std::to_string(yielding_.size()) +
                   (yielding_.size() == 1 ? " element flows: " : " elements flow: ") +
                   structure_->element_name(yielding_[0].element);
        });
}

}  // namespace hinge

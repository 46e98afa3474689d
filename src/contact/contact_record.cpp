// Saves and restores the state of contact for a step that is undone, and checks a state read from a checkpoint.
#include <algorithm>

#include "contact/member_contacts.h"

namespace hinge::contact {

void Contact::save_step() {
    noting_ = true;
    before_.all_but_pairs = all_but_pairs();
    before_.changed.clear();
    before_.listed_anew = false;
}

void Contact::roll_back() {
    all_but_pairs() = before_.all_but_pairs;
    if (before_.listed_anew) candidates_ = before_.candidates, test_at_ = before_.test_at;
    for (auto c = before_.changed.rbegin(); c != before_.changed.rend(); ++c)
        candidates_[c->place] = c->pair, test_at_[c->place] = c->test_at;
    before_.changed.clear();
    before_.listed_anew = false;
}

void Contact::note_pair(std::size_t place) {
    if (noting_ && !before_.listed_anew) before_.changed.push_back({place, candidates_[place], test_at_[place]});
}

void Contact::note_list() {
    if (!noting_ || before_.listed_anew) return;
    before_.listed_anew = true;
    before_.candidates = candidates_, before_.test_at = test_at_;
}

bool Contact::makes_sense(int nodes, int elements, int bars) const {
    const auto within = [](int i, int count) { return i >= 0 && i < count; };
    const auto node = [&](int i) { return within(i, nodes); };
    const auto pair = [&](const auto& of) {
        return within(of.element[0], elements) && within(of.element[1], elements);
    };
    const auto ends = [&](const auto& of) {
        return std::all_of(of.end, of.end + 4, [&](const End& end) { return node(end.node); });
    };
    const auto rule = [&](const auto& of) { return within(of.rule, int(rules_.size())); };
    return last_.size() == nodes_.size() && test_at_.size() == candidates_.size() &&
           std::all_of(nodes_.begin(), nodes_.end(), node) &&
           std::all_of(arms_.begin(), arms_.end(), [&](const ArmEnd& arm) { return node(arm.end.node); }) &&
           std::all_of(events_.begin(), events_.end(), pair) &&
           std::all_of(ties_.begin(), ties_.end(), [&](const Tie& b) { return pair(b) && ends(b) && rule(b); }) &&
           std::all_of(surface_contacts_.begin(), surface_contacts_.end(),
                       [&](const SurfaceContact& t) { return pair(t) && ends(t); }) &&
           std::all_of(candidates_.begin(), candidates_.end(), [&](const Candidate& c) {
               return pair(c) && rule(c) && within(c.bar[0], bars) && within(c.bar[1], bars) && within(int(c.state), 3);
           });
}

}  // namespace hinge::contact

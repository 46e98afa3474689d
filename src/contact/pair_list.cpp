// The list of pairs that are tested for contact, and the distance travelled after which it is rebuilt.
#include <algorithm>
#include <cmath>

#include "contact/bar_ends.h"
#include "contact/broad_phase.h"

namespace hinge::contact {

namespace {

bool share_node(const Bar& a, const Bar& b) {
    return a.meets_at(0) == b.meets_at(0) || a.meets_at(0) == b.meets_at(1) || a.meets_at(1) == b.meets_at(0) ||
           a.meets_at(1) == b.meets_at(1);
}

std::vector<int> order_by_element(const std::vector<Bar>& bars) {
    std::vector<int> order(bars.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = int(i);
    std::sort(order.begin(), order.end(), [&](int p, int q) { return bars[p].element < bars[q].element; });
    return order;
}

// How far any end may travel before the list is rebuilt, m. The margin is about a hundred steps of the fastest end,
// so that the list's cost is spread over them, but no longer than half an element, so that the list stays short.
//
// The margin's numbers change what it costs, never what is found: all runs below gave the same bits. 100 steps: the
// first 0.06 s of Case I list 93 times and measure 78,000 pairs for the lists and 149,000 in steps; with 25 steps 107
// times, 59,000 and 136,000, with 400 54 times, 468,000 and 188,000. At least 0.05 of an element: slow debris
// (scripts/08_debris.lua) lists 101 times, without it 816, at 0.2 26 with more than half as many pairs again. At most a
// half: tests/hard (125 runs of contacts and breaking, 1 to 8 times a scene's step) lists 676 times, at 0.12 1654, at 2
// 523. At least two steps: where an end crosses elements in few steps (64 and 256 times a scene's step) 171 lists, 199
// with one.
double margin_for(const std::vector<Bar>& bars, const Motion& motion, double foreseen) {
    double total = 0;
    for (const Bar& bar : bars) total += length(point(bar.end(0), motion), point(bar.end(1), motion));
    const double mean = bars.empty() ? 0.0 : total / int(bars.size());
    return std::max(2 * foreseen, std::min(std::max(100 * foreseen, 0.05 * mean), 0.5 * mean));
}

/// Whether a pair that was not seen before is in contact already: a joint, or members that cross in one.
bool touches_at_first(const ContactSettings& rule, double contact_distance, const BarPair& two,
                      const Closest& closest) {
    if (rule.rule == ContactRuleKind::surface)
        return closest.distance < (1 - 1e-6) * contact_distance;  // resting on each other is apart
    return closest.distance <= contact_distance || coplanar(two, rule.coplanarity_tolerance, rule.signed_f);
}

}  // namespace

void Contact::list_ends(const std::vector<Bar>& bars, const Motion& motion) {
    nodes_.clear();
    arms_.clear();
    for (const Bar& bar : bars)
        for (const End& end : {bar.end(0), bar.end(1)}) {
            if (has_arm(end)) arms_.push_back({end, point(end, motion)});
            else nodes_.push_back(end.node);
        }
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    last_.clear();
    for (int node : nodes_) last_.push_back(motion.position[node]);
}

Contact::SquaredWay Contact::follow_arms(const Motion& motion) {
    SquaredWay most;
    for (ArmEnd& arm : arms_) {
        const Vec3 x = point(arm.end, motion);
        const double way = (x - arm.last).squaredNorm(), speed = velocity(arm.end, motion).squaredNorm();
        if (!(way + speed < never)) most = {never, never};
        most = {std::max(most.gone, way), std::max(most.fast, speed)};
        arm.last = x;
    }
    return most;
}

// All pairs whose bars could come into contact before anything has travelled a margin. What is known of a pair that
// was in the list before is kept.
void Contact::list_pairs(const std::vector<Bar>& bars, const Motion& motion, double foreseen, bool first_sight,
                         const PairRule& rule_of) {
    ++counts_.list_builds;
    const std::vector<int> order = order_by_element(bars);
    margin_ = margin_for(bars, motion, foreseen);
    listed_at_ = travelled_;
    const std::vector<Box> boxes = boxes_with_margin(bars, order, motion);

    note_list();
    std::vector<Candidate> former;
    former.swap(candidates_);
    test_at_.clear();
    auto next = former.begin();  // both lists are sorted by element numbers
    const auto before = [](const Candidate& p, const Candidate& q) {
        return p.element[0] < q.element[0] || (p.element[0] == q.element[0] && p.element[1] < q.element[1]);
    };
    for (const IndexPair& pair :
         overlapping(boxes, [&](int a, int b) { return !share_node(bars[order[a]], bars[order[b]]); })) {
        const Bar &a = bars[order[pair.a]], &b = bars[order[pair.b]];
        Candidate candidate{
            {a.element, b.element}, {order[pair.a], order[pair.b]}, PairState::free, 0, a.radius + b.radius};
        while (next != former.end() && before(*next, candidate)) ++next;
        const Candidate* known = next != former.end() && !before(candidate, *next) ? &*next : nullptr;
        if (known) candidate.rule = known->rule;
        else if (rule_of) candidate.rule = rule_of(a.element, b.element);
        if (candidate.rule >= 0) list_pair(candidate, known, place(a, b, motion), first_sight);
    }
    mark_bound_pairs();
}

// A box around each bar, in the order given: two that do not overlap cannot meet before a margin is travelled.
std::vector<Box> Contact::boxes_with_margin(const std::vector<Bar>& bars, const std::vector<int>& order,
                                            const Motion& motion) const {
    std::vector<Box> boxes(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Bar& bar = bars[order[i]];
        const Vec3 p = point(bar.end(0), motion), q = point(bar.end(1), motion);
        double pad = 0;
        for (const ContactSettings& rule : rules_)  // by eq 18 the axes are no further apart than C_l (L_c + L_i) / 4
            pad =
                std::max(pad, rule.as_printed ? 0.25 * std::min(rule.contact_length, 1e9) * length(p, q) : bar.radius);
        pad += margin_;
        boxes[i] = {p.cwiseMin(q).array() - pad, p.cwiseMax(q).array() + pad};
    }
    return boxes;
}

// Adds a pair to the list unless it is too far apart. `known`: the pair in the list before, null for a new one.
void Contact::list_pair(Candidate candidate, const Candidate* known, const BarPair& two, bool first_sight) {
    const Closest closest = closest_points(two);
    const double far = farness(candidate, two, closest);
    if (far > 2 * margin_) return;
    if (known) {
        candidate.state = known->state;
        candidate.normal = known->normal;
    } else if (first_sight && far <= 0 &&
               touches_at_first(rules_[candidate.rule], candidate.contact_distance, two, closest)) {
        candidate.state = PairState::joined;
    }
    observe(candidate, two, closest);
    candidates_.push_back(candidate);
    test_at_.push_back(candidate.state == PairState::bound ? never : travelled_ + 0.5 * std::abs(far));
    if (candidate.state == PairState::free && far <= 0) test_at_.back() = travelled_;
}

// Pairs that are in contact are not tested until they are free.
void Contact::mark_bound_pairs() {
    const auto mark = [&](const int element[2]) {
        std::size_t i = 0;
        if (Candidate* pair = find(element, &i)) {
            pair->state = PairState::bound;
            test_at_[i] = never;
        }
    };
    for (const Tie& tie : ties_) mark(tie.element);
    for (const SurfaceContact& contact : surface_contacts_) mark(contact.element);
}

}  // namespace hinge::contact

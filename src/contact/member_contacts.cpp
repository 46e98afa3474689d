#include "contact/member_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "contact/bar_ends.h"
#include "contact/gap_rule.h"

namespace hinge::contact {

namespace {

constexpr double unforeseen = 1e-6;  ///< of the contact distance: a depth with which no foreseen contact begins

Released held_by(const Tie& tie) {
    Released held{tie.energy, false, {}, {}, {}};
    for (int i = 0; i < 4; ++i) {
        const double at = tie.at[i / 2], share = i % 2 == 0 ? 1 - at : at;
        held.end[i] = tie.end[i];
        held.force[i] = tie.force[i];
        held.opening[i] = (i < 2 ? -share : share) * tie.normal_now;
    }
    return held;
}

/// Ends, joints and chain of one of the two bars of a contact.
void place_on(SurfaceContact& contact, int side, const Bar& bar) {
    contact.chain[side] = bar.chain >= 0 ? bar.chain : -2 - bar.element;
    for (int e : {0, 1}) {
        contact.end[2 * side + e] = bar.end(e);
        contact.joint[2 * side + e] = has_arm(bar.end(e)) ? -1 : bar.meets_at(e);
    }
}

}  // namespace

int Contact::rule(const ContactSettings& settings) {
    const auto at = std::find(rules_.begin(), rules_.end(), settings);
    if (at != rules_.end()) return static_cast<int>(at - rules_.begin());
    rules_.push_back(settings);
    return static_cast<int>(rules_.size()) - 1;
}

int Contact::detect(const std::vector<Bar>& bars, bool changed, const Motion& motion, double dt, double time,
                    const PairRule& rule_of) {
    const bool sleep = std::all_of(rules_.begin(), rules_.end(), [](const ContactSettings& r) { return r.sleep; });
    const bool first_sight = changed || !seen_;
    if (first_sight) list_ends(bars, motion);
    seen_ = true;
    now_ = time;

    // How far anything has gone, and will go. A motion that is not finite is the step's business, not ours.
    const double foreseen =
        advance([&](int n) { return motion.position[n]; }, [&](int n) { return motion.velocity[n]; },
                [](int) { return true; }, follow_arms(motion), dt);
    if (!std::isfinite(foreseen)) {
        seen_ = false;
        return 0;
    }
    if (first_sight || !sleep || travelled_ - listed_at_ + foreseen > margin_)
        list_pairs(bars, motion, foreseen, first_sight, rule_of);

    end_surface_contacts();
    nearest_ = {};
    int bound = 0;
    const double horizon = sleep ? travelled_ + foreseen : std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < test_at_.size(); ++i)
        if (test_at_[i] <= horizon) bound += test_pair(i, bars, motion, dt, time);
    group_contacts(surface_contacts_);
    report_surface_events();
    return bound;
}

// One event for each contact of two members, whatever pairs of elements press. Every contact with an end event has a
// begin event, also one that begins or ends between two steps; of two that become one, one gets an end event.
void Contact::report_surface_events() {
    const auto tell = [&](const int element[2], bool begins) {
        ++(begins ? counts_.bound : counts_.released);
        events_.push_back({now_, {element[0], element[1]}, begins});
    };
    for (std::size_t first = 0; first < surface_contacts_.size(); ++first) {
        if (surface_contacts_[first].group != int(first)) continue;
        SurfaceContact* deepest = nullptr;
        int told[2] = {-1, -1};
        for (int i = int(first); i >= 0; i = surface_contacts_[i].next) {
            SurfaceContact& c = surface_contacts_[i];
            if (c.depth > 0 && (!deepest || c.depth > deepest->depth)) deepest = &c;
            if (c.told[0] < 0) continue;
            if (told[0] < 0) std::copy(c.told, c.told + 2, told);
            else tell(c.told, false);
            c.told[0] = c.told[1] = -1;
        }
        if (!deepest) {
            if (told[0] >= 0) tell(told, false);
            continue;
        }
        if (told[0] < 0) tell(deepest->element, true);
        std::copy(told[0] < 0 ? deepest->element : told, (told[0] < 0 ? deepest->element : told) + 2, deepest->told);
    }
}

void Contact::update_surface_contacts(std::vector<SurfaceContact>& contacts, const std::vector<Vec3>& position,
                                      const std::vector<Quat>& rotation) const {
    for (SurfaceContact& contact : contacts) measure_penetration(contact, position, rotation);
    for (int i = 0; i < int(contacts.size()); ++i)
        if (contacts[i].group == i) share_depth(contacts, i);
    for (SurfaceContact& contact : contacts) update_friction(contact, position, rotation);
}

// How much closer the two must come before the rule can apply to them: half of it is the least way one end must go.
// Negative when it applies already.
double Contact::farness(const Candidate& pair, const BarPair& two, const Closest& closest) const {
    const ContactSettings& rule = rules_[pair.rule];
    if (!rule.as_printed) return closest.distance - pair.contact_distance;
    if (std::isinf(rule.contact_length)) return -1;
    const double lengths = length(two.a[0], two.a[1]) + length(two.b[0], two.b[1]);
    // Each of the four distances and both lengths change by at most twice what an end travels.
    const double far = (spread(two) - rule.contact_length * lengths) / (4 + 2 * rule.contact_length);
    return far > 0 && closest.distance <= pair.contact_distance ? 0.0
                                                                : far;  // in contact is not apart, whatever eq 18 says
}

// What the two bars' position tells to remember: that they are apart, and in which direction from a the bar b is. While
// they are in contact the direction may only rotate, not flip: a bar that has passed through is on the wrong side.
void Contact::observe(Candidate& pair, const BarPair& two, const Closest& closest) const {
    const double far = farness(pair, two, closest);
    if (pair.state == PairState::joined && far > 0) pair.state = PairState::free;
    // nearer than this a direction is rounding; 1e-9 to 1e-4 of the contact distance, 0 to 1e-7 of the lengths: the
    // same in tests/hard
    const double cutting =
        1e-6 * pair.contact_distance + 1e-9 * (length(two.a[0], two.a[1]) + length(two.b[0], two.b[1]));
    if (closest.distance <= cutting) return;
    const Vec3 direction = closest.between / closest.distance;
    if (closest.distance > pair.contact_distance || direction.dot(pair.normal) > 0) pair.normal = direction;
}

bool Contact::test_pair(std::size_t i, const std::vector<Bar>& bars, const Motion& motion, double dt, double time) {
    ++counts_.pair_tests;
    note_pair(i);
    Candidate& pair = candidates_[i];
    const ContactSettings& rule = rules_[pair.rule];
    const Bar &a = bars[pair.bar[0]], &b = bars[pair.bar[1]];
    const BarPair two = place(a, b, motion);
    const Closest closest = closest_points(two);
    observe(pair, two, closest);
    const double far = farness(pair, two, closest);
    test_at_[i] = travelled_;
    if (pair.state == PairState::joined) {
        test_at_[i] -= 0.5 * far;
        return false;
    }
    if (far > 0) test_at_[i] += 0.5 * far;
    if (const double apart = closest.distance - pair.contact_distance;
        a.body != b.body && (nearest_.element[0] < 0 || apart < nearest_.distance))
        nearest_ = {{pair.element[0], pair.element[1]}, apart};

    const Moving moving{two,
                        {{dt * velocity(a.end(0), motion), dt * velocity(a.end(1), motion)},
                         {dt * velocity(b.end(0), motion), dt * velocity(b.end(1), motion)}}};
    if (rule.rule == ContactRuleKind::surface) {
        if (closest.distance - moving.closing_bound() > pair.contact_distance) return false;
        if (far > 0 && !first_meeting(moving, closest, pair.normal, {never, never, pair.contact_distance}).found)
            return false;
        watch(pair, a, b, motion, two);
        test_at_[i] = never;
        return true;
    }
    const RuleNumbers numbers{rule.contact_length, rule.coplanarity_tolerance, pair.contact_distance, rule.signed_f};
    const Meeting meeting = rule.as_printed ? printed_meeting(moving, closest, pair.normal, numbers)
                                            : first_meeting(moving, closest, pair.normal, numbers);
    if (!meeting.found) return false;
    bind(pair, a, b, motion, meeting, time);
    test_at_[i] = never;
    events_.push_back({time + meeting.tau * dt, {pair.element[0], pair.element[1]}, true});
    return true;
}

void Contact::bind(Candidate& pair, const Bar& a, const Bar& b, const Motion& motion, const Meeting& meeting,
                   double time) {
    pair.state = PairState::bound;
    Tie tie;
    tie.element[0] = a.element;
    tie.element[1] = b.element;
    tie.rule = pair.rule;
    tie.since = time;
    tie.normal = tie.normal_now = meeting.direction;
    tie.at[0] = meeting.s;
    tie.at[1] = meeting.t;
    Vec3 at[4];
    for (int i = 0; i < 4; ++i) {
        tie.end[i] = i < 2 ? a.end(i) : b.end(i - 2);
        at[i] = point(tie.end[i], motion);
    }
    const double shortest = rules_[pair.rule].shortest_gap * 0.5 * (length(at[0], at[1]) + length(at[2], at[3]));
    for (int g = 0; g < 4; ++g) {
        tie.gap[g].rest = at[gap_b(g)] - at[gap_a(g)];
        tie.gap[g].stiffness = gap_stiffness(a.stiffness, b.stiffness, tie.gap[g].rest.norm(), shortest);
    }
    ties_.push_back(tie);
    ++counts_.bound;
}

Contact::Candidate* Contact::find(const int element[2], std::size_t* place) {
    const std::array<int, 2> wanted{element[0], element[1]};
    const auto it = std::lower_bound(candidates_.begin(), candidates_.end(), wanted,
                                     [](const Candidate& c, const std::array<int, 2>& w) {
                                         return c.element[0] < w[0] || (c.element[0] == w[0] && c.element[1] < w[1]);
                                     });
    if (it == candidates_.end() || it->element[0] != wanted[0] || it->element[1] != wanted[1]) return nullptr;
    *place = static_cast<std::size_t>(it - candidates_.begin());
    return &*it;
}

// The pair is free again, and remembers from which side it came.
void Contact::set_free(const int element[2], const Vec3& normal) {
    std::size_t i = 0;
    if (Candidate* pair = find(element, &i)) {
        note_pair(i);
        pair->state = PairState::free;
        pair->normal = normal;
        test_at_[i] = travelled_;
    }
}

void Contact::end_tie(const Tie& tie) {
    counts_.energy_released += tie.energy;
    events_.push_back({now_, {tie.element[0], tie.element[1]}, false});
    set_free(tie.element, tie.normal_now);
}

void Contact::watch(Candidate& pair, const Bar& a, const Bar& b, const Motion& motion, const BarPair& two) {
    pair.state = PairState::bound;
    SurfaceContact contact;
    const Bar* bars[2] = {&a, &b};
    for (int i = 0; i < 2; ++i) {
        contact.element[i] = bars[i]->element;
        contact.radius[i] = bars[i]->radius;
        place_on(contact, i, *bars[i]);
    }
    contact.length[0] = length(two.a[0], two.a[1]), contact.length[1] = length(two.b[0], two.b[1]);
    const auto member_length = [&](int i) { return bars[i]->length > 0 ? bars[i]->length : contact.length[i]; };
    const ContactSettings& rule = rules_[pair.rule];
    contact.stiffness = rule.stiffness > 0
                            ? rule.stiffness
                            : surface_stiffness(a.stiffness, b.stiffness, 0.5 * (member_length(0) + member_length(1)),
                                                pair.contact_distance);
    contact.friction = rule.friction;
    contact.normal_before = pair.normal;
    contact::update(contact, motion.position, motion.rotation);
    // an impulse in the last step has led them into each other: no work was done for what that would store
    if (contact.penetration > unforeseen * pair.contact_distance) {
        contact.level = contact.penetration;
        contact::update(contact, motion.position, motion.rotation);
    }
    contact::end_step(contact, motion.position, motion.rotation);
    surface_contacts_.push_back(contact);
}

// Pairs that have parted are free again.
void Contact::end_surface_contacts() {
    std::erase_if(surface_contacts_, [&](const SurfaceContact& contact) {
        if (contact.penetration_before > 0) return false;
        set_free(contact.element, contact.normal_before);
        return true;
    });
}

Contact::StepResult Contact::end_step(double time, double dt, const std::vector<Vec3>& position,
                                      const std::vector<Quat>& rotation, std::vector<Vec6>& impulse) {
    now_ = time;
    StepResult out;
    const auto add_missed = [&](double work) {
        out.missed = out.missed || work != 0;
        out.work += work;
    };
    for (int i = 0; i < int(surface_contacts_.size()); ++i) {
        if (surface_contacts_[i].group != i) continue;
        if (surface_contacts_[i].next >= 0) add_missed(missed_by_group(surface_contacts_, i, dt, rotation, impulse));
        else add_missed(missed_impulse(surface_contacts_[i], dt, rotation, impulse));
    }
    for (SurfaceContact& contact : surface_contacts_) {
        out.heat += contact.heat;
        contact::end_step(contact, position, rotation);
    }
    for (int i = 0; i < int(surface_contacts_.size()); ++i) {
        const SurfaceContact& first = surface_contacts_[i];
        if (first.group == i && first.friction > 0 && (first.next >= 0 || first.share != 1))
            out.heat += share_slip(surface_contacts_, i);
    }
    report_surface_events();
    return out;
}

double Contact::drop(int element) {
    double energy = 0;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < ties_.size(); ++i) {
        const Tie& tie = ties_[i];
        if (tie.element[0] == element || tie.element[1] == element) {
            energy += tie.energy;
            ++counts_.dropped;
            end_tie(tie);
        } else {
            ties_[kept++] = ties_[i];
        }
    }
    ties_.resize(kept);
    stored_ -= energy;
    return energy;
}

// Element by element, as a bar's ends change places when it breaks at its first one.
void Contact::follow_broken(const std::vector<Bar>& bars, const std::vector<Vec3>& position,
                            const std::vector<Quat>& rotation) {
    for (SurfaceContact& contact : surface_contacts_) {
        for (const Bar& bar : bars)
            for (int i = 0; i < 2; ++i)
                if (bar.element == contact.element[i]) place_on(contact, i, bar);  // group stays until the next step
    }
    std::vector<Vec3> slip;
    for (const SurfaceContact& contact : surface_contacts_) slip.push_back(contact.slip_before);
    update_surface_contacts(surface_contacts_, position, rotation);
    for (std::size_t i = 0; i < slip.size(); ++i) {
        surface_contacts_[i].slip = slip[i];
        contact::end_step(surface_contacts_[i], position, rotation);
    }
    report_surface_events();
}

double Contact::release(double time, std::vector<Released>* released) {
    now_ = time;
    double energy = 0;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < ties_.size(); ++i) {
        Tie& tie = ties_[i];
        const ContactSettings& rule = rules_[tie.rule];
        const double age = (time - tie.since) / rule.binding_time;
        tie.energy_peak = std::max(tie.energy_peak, tie.energy);
        bool due = age >= 1 - 1e-9;
        if (due && rule.hold_until_parting && age < rule.longest_hold) {
            // At the bottom of a swing, a low one, and not while the bars still press on towards the other side.
            const bool swung_back = tie.falling && tie.energy >= tie.energy_before;
            const bool low = tie.energy <= rule.parting_energy * tie.energy_peak;
            // nothing left; with 0, 1e-4 or 1e-2 as many of 125 runs of tests/hard keep their bounds, 116
            const bool spent = tie.energy <= 1e-3 * tie.energy_peak;
            const bool closing = tie.opening < tie.opening_before;
            due = ((swung_back && low) || spent) && !closing;
        }
        tie.falling = tie.energy < tie.energy_before;
        tie.energy_before = tie.energy;
        tie.opening_before = tie.opening;
        if (due) {
            energy += tie.energy;
            ++counts_.released;
            end_tie(tie);
            if (released) released->push_back(held_by(tie)), released->back().springs_back = rule.hold_until_parting;
        } else {
            if (kept != i) ties_[kept] = tie;
            ++kept;
        }
    }
    ties_.resize(kept);
    stored_ -= energy;
    return energy;
}

void Contact::add_internal_forces(const std::vector<Vec3>& position, const std::vector<Quat>& rotation,
                                  std::vector<Vec6>& force) {
    stored_ = 0;
    for (Tie& tie : ties_) {
        add_tie_forces(tie, position, rotation, force);
        stored_ += tie.energy;
    }
    update_surface_contacts(surface_contacts_, position, rotation);
    for (const SurfaceContact& contact : surface_contacts_) {
        add_contact_forces(contact, rotation, force);
        stored_ += contact.energy;
    }
}

// A slip that moved by less than 1/100 of the penetration is settled. Of 125 runs of tests/hard 116 keep their bounds
// with 1/10, 1/100 and 1/1000, which ask for 53, 67 and 110 more iterations, and 115 if a slip is never looked at.
bool Contact::unsettled(const std::vector<Vec3>& position, const std::vector<Quat>& rotation) const {
    std::vector<SurfaceContact> now = surface_contacts_;
    update_surface_contacts(now, position, rotation);
    for (std::size_t i = 0; i < now.size(); ++i) {
        const SurfaceContact& was = surface_contacts_[i];
        if ((was.depth > 0) != (now[i].depth > 0) ||
            (now[i].slip - was.slip).norm() > 0.01 * std::max(0.0, now[i].penetration))
            return true;
    }
    return false;
}

void Contact::add_stiffness(const std::vector<Vec3>& position, const std::vector<Quat>& rotation,
                            const AddStiffness& add) const {
    for (const Tie& tie : ties_) add_tie_stiffness(tie, position, rotation, add);
    for (int i = 0; i < int(surface_contacts_.size()); ++i) {
        const SurfaceContact& first = surface_contacts_[i];
        if (first.group != i) continue;
        if (first.next >= 0) add_shared_stiffness(surface_contacts_, i, rotation, add);
        else add_contact_stiffness(first, rotation, add);
    }
}

}  // namespace hinge::contact

// Contact between moving bars: detection of pairs, contact forces, and release.
//
// Rule `surface`: bars that are closer than the sum of their half depths press on each other (surface_contact.h). Rule
// `gap` (eqs 17-19, figs 6-7): elements whose axes come to lie in one plane, close enough together and approaching, are
// bound by four gap elements, node to node, for a binding time (gap_rule.h says when, tie.h how). broad_phase.h finds
// the candidate pairs.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <tuple>
#include <vector>

#include "contact/tie.h"
#include "contact/segments.h"
#include "contact/shared_spring.h"
#include "core/types.h"

namespace hinge::contact {

struct BarPair;
struct Box;
struct Meeting;

/// Contact geometry of an element, or of the remains of a broken one. At most one bar per element.
struct Bar {
    int element = -1;
    int body = 0;             ///< the body that it belongs to
    int node[2] = {-1, -1};   ///< the nodes of its two ends
    int joint[2] = {-1, -1};  ///< the nodes to which joints join its ends; -1: no joint
    Vec3 arm = Vec3::Zero();  ///< m, of the second end, as in End: the free end of a broken element
    double radius = 0;        ///< m, half the depth of the member
    double stiffness = 0;     ///< EA of the member, N
    double length = 0;        ///< m, of the member; 0: of the bar itself
    int chain = -1;           ///< unbroken run of elements of one member that it belongs to; -1: a chain of its own

    /// Bars that meet at one node do not touch each other.
    int meets_at(int i) const { return joint[i] >= 0 ? joint[i] : node[i]; }
    End end(int i) const { return {node[i], i == 1 ? arm : Vec3::Zero()}; }
};

/// Present position of the nodes, and their predicted motion over the coming step.
struct Motion {
    const std::vector<Vec3>& position;  ///< m
    const std::vector<Quat>& rotation;  ///< of each node since it was declared, of unit length
    const std::vector<Vec6>& velocity;  ///< m/s and rad/s, in space: the predicted mean over the step
};

inline constexpr double never = std::numeric_limits<double>::infinity();  ///< a distance that no end travels

/// Kinds of contact rule: gap elements of the paper, or surfaces that press on each other.
enum class ContactRuleKind : int { gap, surface };

/// Parameters of a contact rule.
struct ContactSettings {
    ContactRuleKind rule = ContactRuleKind::gap;

    bool sleep = true;  ///< pairs are tested only when they could have met; false: all pairs at every step

    // surface
    double stiffness = 0;  ///< N/m; 0: of the two members, see surface_stiffness
    double friction = 0;   ///< Coulomb's coefficient

    // gap
    double contact_length = 1.8;  ///< C_l of eq 18 (the paper's value). At 1.8 a bar shorter than 1/8 of the other
                                  ///< never meets it at mid length, than 1/4 near an end, nor do bars end on. Infinite:
                                  ///< eq 18 always holds, the half depths decide
    double coplanarity_tolerance = 3e-4;  ///< alpha of eq 19, m^3 (the paper's value)
    double binding_time = 0.5e-3;         ///< s (the paper's value)
    bool as_printed = false;  ///< eqs 17-19 as printed, looked at only where a step begins; otherwise swept over the
                              ///< step, and the axes must also come within the sum of the half depths
    bool signed_f = false;    ///< eq 19 as printed, f <= alpha with the sign of f; otherwise |f| <= alpha
    bool hold_until_parting = true;  ///< after its binding time a tie stays until the bars part and its stored energy
                                     ///< is at a low minimum, and what is left springs back as an impulse; false: cut
                                     ///< at the binding time, what it stores is gone
    double parting_energy =
        0.1;  ///< how low: part of the most it has stored. Two elastic beams (fig 13; 26 variants of speed, angle,
              ///< offset and support) had on average 40 % of their energy in ties cut at 0.5 ms, 28 % at the
              ///< first minimum whatever its height, 13 / 5.5 % at 0.2 / 0.1 of the peak; below that they stick
    double longest_hold = 20;  ///< binding times after which a tie is released whatever it carries: 10 ms is longer
                               ///< than such an impact lasts; 40 changed nothing, with 10 some ties were cut while full
    double shortest_gap =
        0.5;  ///< of the mean length of the two elements: gap elements shorter than this are as stiff as
              ///< this, half an element, so that no gap brings in a frequency above the elements' own

    bool operator==(const ContactSettings&) const = default;
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.rule, s.sleep, s.stiffness, s.friction, s.contact_length, s.coplanarity_tolerance, s.binding_time,
          s.as_printed, s.signed_f, s.hold_until_parting, s.parting_energy, s.longest_hold, s.shortest_gap);
    }
};

/// Index of the contact rule for two elements; -1: no contact.
using PairRule = std::function<int(int element_a, int element_b)>;

/// Numbers of contacts and tests, and the energy released, since the start.
struct ContactCounts {
    long bound = 0, released = 0, dropped = 0;  ///< ties made, or contacts begun; released; lost with a broken
                                                ///< element
    long pair_tests = 0, list_builds = 0;
    double energy_released = 0;  ///< J, stored in ties when they were released or dropped

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.bound, s.released, s.dropped, s.pair_tests, s.list_builds, s.energy_released);
    }
};

/// The nearest pair of elements of different bodies that was tested in a step.
struct Nearest {
    int element[2] = {-1, -1};
    double distance = 0;
};  ///< m, between their surfaces

/// Beginning or end of a contact: rule gap, of two elements; rule surface, of two members, named by the elements that
/// were deepest in each other when it began.
struct ContactEvent {
    double time;  ///< s; when bound, the moment of contact within the step
    int element[2];
    bool bound;  ///< else released

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.time, s.element, s.bound);
    }
};

/// Energy and forces of a tie at its release.
struct Released {
    double energy = 0;          ///< J
    bool springs_back = false;  ///< hold_until_parting
    End end[4];
    Vec3 force[4];    ///< N, its resisting force at each end
    Vec3 opening[4];  ///< derivative of the bars' distance by the position of each end
};

/// Contact of a run: finds pairs, binds them or lets them press, computes the forces, releases them. A copy has all its
/// state.
///
/// A step calls: detect; add_internal_forces and add_stiffness as often as needed; add_internal_forces at the end of
/// the step, release and settle; drop for elements that broke. A step that may be undone begins with save_step. A tie
/// starts without force, but ends with one: an integrator that carries accelerations from step to step must compute
/// them anew after a release or a drop, or the tie's force acts for half a step more.
class Contact {
public:
    explicit Contact(ContactSettings settings) : Contact(std::vector<ContactSettings>{settings}) {}
    explicit Contact(std::vector<ContactSettings> rules) : rules_(std::move(rules)) {}

    /// Returns the index of the rule with these settings; adds it if there is none.
    int rule(const ContactSettings& settings);

    /// Finds the pairs that come into contact over the coming step [time, time + dt] and binds them, in order of their
    /// element numbers. `bars` is the current list of bars; `changed` says that it differs from the last call
    /// (something broke). Pairs that share a node never bind; nor do pairs in contact when they are first seen, until
    /// they have parted. Returns the number of pairs newly bound. `rule_of` is called once for each pair that comes
    /// near; without it the first rule applies to all.
    int detect(const std::vector<Bar>& bars, bool changed, const Motion& motion, double dt, double time,
               const PairRule& rule_of = {});

    /// detect for a step in which nothing can come into contact, where that is known without looking at pairs: true.
    /// False: detect must be called. Of a node: place, m, its mean velocity over the step, m/s and rad/s, and whether
    /// it moves at all.
    template <class Place, class Velocity, class Moves>
    bool passes(Place place, Velocity velocity, Moves moves, double dt, double time);

    /// Removes the ties of an element that broke. Returns the energy released, J.
    double drop(int element);

    /// Transfers the surface contacts of elements that broke to their remains, which lie in the same place. Nothing is
    /// released.
    void follow_broken(const std::vector<Bar>& bars, const std::vector<Vec3>& position,
                       const std::vector<Quat>& rotation);

    /// Releases the ties that are due at `time`. Call it once per accepted step, after its last add_internal_forces: it
    /// compares energies with those of the previous call. Returns the energy released, J; `released` receives energy
    /// and forces of each tie.
    double release(double time, std::vector<Released>* released = nullptr);

    /// Result of end_step: `work` of the missed impulses, J, and `heat` of friction in the step, J.
    struct StepResult {
        bool missed = false;
        double work = 0, heat = 0;
    };
    /// Rule surface: ends a step at the positions of the last add_internal_forces. Adds the impulses that the step
    /// missed (surface_contact.h) to `impulse`.
    StepResult end_step(double time, double dt, const std::vector<Vec3>& position, const std::vector<Quat>& rotation,
                        std::vector<Vec6>& impulse);

    /// Adds the resisting forces + dU/du of ties and surface contacts to `force`, and stores the energies.
    void add_internal_forces(const std::vector<Vec3>& position, const std::vector<Quat>& rotation,
                             std::vector<Vec6>& force);

    /// True if the tangent of the last add_internal_forces is not valid for these positions: a contact has opened or
    /// closed, or friction has changed by more than 1 % of the pressure.
    bool unsettled(const std::vector<Vec3>& position, const std::vector<Quat>& rotation) const;

    /// Adds the stiffness of every tie at these positions, and of every surface contact as at the last
    /// add_internal_forces.
    void add_stiffness(const std::vector<Vec3>& position, const std::vector<Quat>& rotation,
                       const AddStiffness& add) const;

    double stored_energy() const { return stored_; }  ///< J, as of the last add_internal_forces
    bool idle() const { return ties_.empty() && surface_contacts_.empty(); }
    const std::vector<ContactSettings>& rules() const { return rules_; }
    const ContactCounts& counts() const { return counts_; }
    const std::vector<Tie>& ties() const { return ties_; }  ///< in the order in which they were made
    const std::vector<SurfaceContact>& surface_contacts() const {
        return surface_contacts_;
    }                                                    ///< pairs in contact, or that might be in this step
    const Nearest& nearest() const { return nearest_; }  ///< in the last detect; {-1, -1}: none was looked at
    int candidates() const { return static_cast<int>(candidates_.size()); }

    /// Events since the log was last cleared.
    const std::vector<ContactEvent>& events() const { return events_; }
    void clear_events() { events_.clear(); }

    /// Saves the state at the start of a step that may be undone. roll_back restores it; release_step accepts the step
    /// and ends the recording of changes.
    void save_step();
    void roll_back();
    void release_step() { noting_ = false; }

    static constexpr bool in_state_hash = false;  ///< the hash of a state is that of its arrays
    /// Lists all data on which later steps depend (core/archive.h).
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.rules_, s.counts_, s.ties_, s.surface_contacts_, s.stored_, s.events_, s.seen_, s.now_, s.travelled_,
          s.listed_at_, s.margin_, s.nodes_, s.last_, s.arms_, s.candidates_, s.test_at_);
    }
    /// True if data read from a checkpoint fit a structure with so many nodes, elements and bars: no index exceeds
    /// them.
    bool makes_sense(int nodes, int elements, int bars) const;

private:
    enum class PairState : int {
        free,   ///< may bind
        bound,  ///< by a tie, or by a surface contact
        joined  ///< in contact when first seen: a joint, or members that cross in one; free once they have parted
    };
    struct Candidate {
        int element[2];
        int bar[2];  ///< places in the list of bars
        PairState state;
        int rule;
        double contact_distance;     ///< sum of the half depths, m
        Vec3 normal = Vec3::Zero();  ///< unit direction from a to b when they last were clearly apart

        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.element, s.bar, s.state, s.rule, s.contact_distance, s.normal);
        }
    };
    struct ArmEnd {
        End end;
        Vec3 last;
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.end, s.last);
        }
    };

    /// The longest way of some ends: m^2 since the last step, m^2/s^2 ahead; `never` where one is not finite.
    struct SquaredWay {
        double gone = 0, fast = 0;
    };

    void list_ends(const std::vector<Bar>& bars, const Motion& motion);
    template <class Place, class Velocity, class Moves>
    double advance(Place place, Velocity velocity, Moves moves, const SquaredWay& of_arms, double dt);
    SquaredWay follow_arms(const Motion& motion);
    void list_pairs(const std::vector<Bar>& bars, const Motion& motion, double foreseen, bool first_sight,
                    const PairRule& rule_of);
    std::vector<Box> boxes_with_margin(const std::vector<Bar>& bars, const std::vector<int>& order,
                                       const Motion& motion) const;
    void list_pair(Candidate candidate, const Candidate* known, const BarPair& two, bool first_sight);
    void mark_bound_pairs();
    double farness(const Candidate& pair, const BarPair& two, const Closest& closest) const;
    void observe(Candidate& pair, const BarPair& two, const Closest& closest) const;
    bool test_pair(std::size_t i, const std::vector<Bar>& bars, const Motion& motion, double dt, double time);
    void bind(Candidate& pair, const Bar& a, const Bar& b, const Motion& motion, const Meeting& meeting, double time);
    void watch(Candidate& pair, const Bar& a, const Bar& b, const Motion& motion, const BarPair& two);
    void end_tie(const Tie& tie);
    void end_surface_contacts();
    void update_surface_contacts(std::vector<SurfaceContact>& contacts, const std::vector<Vec3>& position,
                                 const std::vector<Quat>& rotation) const;
    void report_surface_events();
    void set_free(const int element[2], const Vec3& normal);
    Candidate* find(const int element[2], std::size_t* place);
    void note_pair(std::size_t place);
    void note_list();

    std::vector<ContactSettings> rules_;
    ContactCounts counts_;
    std::vector<Tie> ties_;
    std::vector<SurfaceContact> surface_contacts_;
    Nearest nearest_;
    double stored_ = 0;  ///< J, as of the last add_internal_forces
    std::vector<ContactEvent> events_;

    // Tests are scheduled by distance travelled, not by time: between two tests nothing comes closer by more than twice
    // the way of the fastest point, at any speed.
    bool seen_ = false;
    double now_ = 0;                     ///< s, the time of the last call
    double travelled_ = 0;               ///< m, sum over the steps of the longest way of any end
    double listed_at_ = 0;               ///< travelled_ when the list was made
    double margin_ = 0;                  ///< m, how far any end may travel before the list is rebuilt
    std::vector<int> nodes_;             ///< nodes in which bars end, sorted
    std::vector<Vec3> last_;             ///< where they were
    std::vector<ArmEnd> arms_;           ///< virtual ends
    std::vector<Candidate> candidates_;  ///< sorted by element numbers
    std::vector<double> test_at_;        ///< of each candidate: the value of travelled_ before which it cannot touch

    // Data to undo a step: of the many pairs only those that it changed, unless it rebuilt the list.
    auto all_but_pairs() {
        return std::tie(rules_, counts_, ties_, surface_contacts_, nearest_, stored_, events_, seen_, now_, travelled_,
                        listed_at_, margin_, nodes_, last_, arms_);
    }
    struct Before {
        std::tuple<std::vector<ContactSettings>, ContactCounts, std::vector<Tie>, std::vector<SurfaceContact>, Nearest,
                   double, std::vector<ContactEvent>, bool, double, double, double, double, std::vector<int>,
                   std::vector<Vec3>, std::vector<ArmEnd>>
            all_but_pairs;
        struct Changed {
            std::size_t place;
            Candidate pair;
            double test_at;
        };
        std::vector<Changed> changed;
        bool listed_anew = false;
        std::vector<Candidate> candidates;
        std::vector<double> test_at;
    };
    bool noting_ = false;
    Before before_;
};

// Adds the longest way of any end since the last call to travelled_, and returns the longest way ahead.
template <class Place, class Velocity, class Moves>
double Contact::advance(Place place, Velocity velocity, Moves moves, const SquaredWay& of_arms, double dt) {
    // by turns: in a single one each comparison waits for the one before
    double gone[2] = {of_arms.gone, 0}, fast[2] = {of_arms.fast, 0};
    bool wild = !(of_arms.gone + of_arms.fast < never);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (!moves(nodes_[i])) continue;
        const Vec3 x = place(nodes_[i]);
        const Vec6 v = velocity(nodes_[i]);
        const double way = (x - last_[i]).squaredNorm(), speed = v.head<3>().squaredNorm();
        wild = wild || !(way + speed < never);
        gone[i % 2] = std::max(gone[i % 2], way);
        fast[i % 2] = std::max(fast[i % 2], speed);
        last_[i] = x;
    }
    if (wild) return never;
    travelled_ += std::sqrt(std::max(gone[0], gone[1]));
    return std::sqrt(std::max(fast[0], fast[1])) * dt;
}

template <class Place, class Velocity, class Moves>
bool Contact::passes(Place place, Velocity velocity, Moves moves, double dt, double time) {
    const auto sleeps = [](const ContactSettings& r) { return r.sleep; };
    if (!seen_ || !idle() || !arms_.empty() || !std::all_of(rules_.begin(), rules_.end(), sleeps)) return false;
    const double foreseen = advance(place, velocity, moves, {}, dt), horizon = travelled_ + foreseen;
    if (!(travelled_ - listed_at_ + foreseen <= margin_)) return false;
    if (std::any_of(test_at_.begin(), test_at_.end(), [&](double at) { return at <= horizon; })) return false;
    nearest_ = {}, now_ = time;
    return true;
}

}  // namespace hinge::contact

// Members whose elements are too long for the blows that they took.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "advice/adviser.h"
#include "contact/member_contacts.h"
#include "core/text.h"
#include "effects/contact.h"
#include "effects/effect_list.h"
#include "model/member_text.h"

namespace hinge {
namespace {

constexpr double counts_from = 0.1;       ///< of the largest impulse: members that got less do not count
constexpr double most_part_missed = 0.4;  ///< of a moment, that goes unsaid
constexpr double at_joint = 0.1;          ///< of a member's length: a blow so near to its end is at the joint
constexpr int enough_elements = 8;        ///< elements of a member that yields between its joints

double quarter_wave(double speed, double tau) { return 0.5 * std::sqrt(std::numbers::pi * tau * speed); }

/// Compares the elements of struck members with the bending wave that a blow sends out.
///
/// A blow that lasts tau has the frequency omega = pi / tau. At it a beam carries bending waves of the length
///   lambda = 2 pi sqrt(sqrt(EI / rho A) / omega) = 2 sqrt(pi tau sqrt(EI / rho A)).
/// Elements longer than lambda / 4 answer with the lumps of their nodes in the place of the wave: of a mass that falls
/// on a beam, against the modal series, the energy and the momentum passed are right to 2 % with elements up to lambda
/// / 4, to 10 % up to 1.5 times that, and off by 14 % at 1.8, 40 % at 3 times (tests/script/effects/contact_test.lua).
/// Of EI the smaller one counts: the shorter wave.
///
/// A member that is struck between its joints and yields there forms its hinge at a node, beside the place of the blow:
/// its plastic work may be far off with few elements.
class StruckMembers : public Adviser {
public:
    explicit StruckMembers(const Structure& structure);
    /// Adds what contacts have passed in the step.
    void after_commit(const Run& run, const Step& step) override;
    /// One warning, of the member whose elements are longest beside its wave. Members that got less than a tenth of the
    /// largest impulse do not count, nor those that got more than half of theirs by blows that last long enough. Where
    /// none has: one of the member with the fewest elements that yielded where it was struck between its joints; else
    /// one of the member that misses most of the moment of blows inside its elements.
    void list_findings(const Run& run, std::vector<Warning>& list) const override;

    void save(Writer& to) const override { to(struck_); }
    void restore(Reader& from) override { from(struck_); }
    bool fits(const Run&) const override {
        return std::all_of(struck_.begin(), struck_.end(),
                           [this](const Struck& s) { return s.member >= 0 && s.member < int(element_.size()); });
    }

private:
    /// Blows that a member took, and the one that goes on.
    struct Struck {
        int member = -1;
        double since = -1, last = -1, impulse_now = 0;  ///< s, s, N s
        double impulse = 0, brief = 0;                  ///< N s, of all blows, of those too brief for its elements
        double brief_time = 0;                          ///< N s s, impulse times duration of the brief ones
        double missed = 0, moment = 0;  ///< N m s, over time: moments F a b / l, and those at the ends of its element
        double between = 0;             ///< N s, of blows between its joints

        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.member, s.since, s.last, s.impulse_now, s.impulse, s.brief, s.brief_time, s.missed, s.moment,
              s.between);
        }
    };
    struct Blow {
        double impulse = 0, missed = 0, moment = 0;  ///< N s, N m s, N m s, of one step
        double between = 0;                          ///< N s, away from the member's joints
    };
    void add(int member, const Blow& blow, double time, double dt);
    void end_blow(Struck& of) const;
    const Struck* most_missed(const std::vector<Struck>& ended, double largest) const;
    Warning warning_of_waves(const Structure& structure, const Struck& worst, int count) const;
    /// Of one that yielded with few elements; false where there is none.
    bool warn_of_hinges(const Structure& structure, const State& state, const std::vector<Struck>& ended,
                        double largest, std::vector<Warning>& list) const;
    Warning warning_of_place(const Structure& structure, const Struck& worst) const;

    std::vector<double> wave_speed_;  ///< sqrt(EI / rho A) of each member, m^2/s
    std::vector<double> element_;     ///< m, its longest element
    std::vector<double> length_;      ///< m, of each member
    std::vector<double> from_;        ///< m, where each element begins on its member
    std::vector<Struck> struck_;      ///< sorted by member
};

StruckMembers::StruckMembers(const Structure& structure)
    : wave_speed_(structure.model().members().size(), 0.0),
      element_(wave_speed_.size(), 0.0),
      length_(wave_speed_.size(), 0.0) {
    for (const Element& e : structure.elements()) {
        wave_speed_[e.member] = std::sqrt(std::min(e.rigidity.EIx, e.rigidity.EIy) / e.rigidity.rhoA);
        element_[e.member] = std::max(element_[e.member], e.length);
        from_.push_back(length_[e.member]);
        length_[e.member] += e.length;
    }
}

void StruckMembers::after_commit(const Run& run, const Step& step) {
    const contact::Contact& contact = *contact_of(run.state());
    if (contact.idle()) return;
    const Structure& structure = run.structure();
    const State& state = run.state();
    const double dt = step.dt;
    std::map<int, Blow> blows;
    const auto note = [&](const int element[2], const double at[2], double impulse) {
        for (int side : {0, 1}) {
            const Element& e = structure.elements()[element[side]];
            const Vec6& f = state.force[element[side]];
            const double s = std::clamp(at[side], 0.0, 1.0);
            Blow& blow = blows[e.member];
            const double place = from_[element[side]] + s * e.length, whole = length_[e.member];
            if (std::min(place, whole - place) > at_joint * whole) blow.between += impulse;
            blow.impulse += impulse;
            blow.missed += impulse * s * (1 - s) * e.length;
            blow.moment = std::max(blow.moment, dt * std::max(std::hypot(f[0], f[2]), std::hypot(f[1], f[3])));
        }
    };
    for (const contact::SurfaceContact& c : contact.surface_contacts())
        if (c.depth_before > 0) note(c.element, c.at, c.stiffness * c.depth_before * dt);
    for (const contact::Tie& tie : contact.ties()) note(tie.element, tie.at, (tie.force[0] + tie.force[1]).norm() * dt);
    for (const auto& [member, blow] : blows) add(member, blow, step.end(), dt);
}

// A blow ends where a step passes without contact of the member.
void StruckMembers::add(int member, const Blow& blow, double time, double dt) {
    auto at = std::lower_bound(struck_.begin(), struck_.end(), member,
                               [](const Struck& s, int wanted) { return s.member < wanted; });
    if (at == struck_.end() || at->member != member) at = struck_.insert(at, Struck{member});
    if (at->since >= 0 && time - at->last > 1.5 * dt) end_blow(*at);
    if (at->since < 0) at->since = time - dt;
    at->last = time;
    at->impulse_now += blow.impulse;
    at->missed += blow.missed;
    at->moment += blow.moment;
    at->between += blow.between;
}

void StruckMembers::end_blow(Struck& of) const {
    const double tau = of.last - of.since;
    of.impulse += of.impulse_now;
    if (element_[of.member] > quarter_wave(wave_speed_[of.member], tau)) {
        of.brief += of.impulse_now;
        of.brief_time += of.impulse_now * tau;
    }
    of.since = -1, of.impulse_now = 0;
}

void StruckMembers::list_findings(const Run& run, std::vector<Warning>& list) const {
    const Structure& structure = run.structure();
    std::vector<Struck> ended = struck_;
    double largest = 0;
    for (Struck& s : ended) {
        if (s.since >= 0) end_blow(s);
        largest = std::max(largest, s.impulse);
    }
    const Struck* worst = nullptr;
    int count = 0;
    double least = 0;
    for (const Struck& s : ended) {
        if (!(s.impulse > 0 && s.impulse >= counts_from * largest && s.brief > 0.5 * s.impulse)) continue;
        const double ratio = element_[s.member] / quarter_wave(wave_speed_[s.member], s.brief_time / s.brief);
        ++count;
        if (ratio > least) least = ratio, worst = &s;
    }
    if (worst) list.push_back(warning_of_waves(structure, *worst, count));
    else if (warn_of_hinges(structure, run.state(), ended, largest, list)) return;
    else if (const Struck* missing = most_missed(ended, largest)) list.push_back(warning_of_place(structure, *missing));
}

Warning StruckMembers::warning_of_waves(const Structure& structure, const Struck& worst, int count) const {
    const double tau = worst.brief_time / worst.brief, quarter = quarter_wave(wave_speed_[worst.member], tau);
    const int now = structure.model().members()[worst.member].elements,
              wanted = 2 * int(std::ceil(0.5 * now * element_[worst.member] / quarter));
    return {Warning::Kind::elements,
            member_text(structure.model(), worst.member) +
                (count > 1 ? " and " + std::to_string(count - 1) + " more were" : " was") + " struck for " +
                number_text(1e3 * tau, 2) + " ms, and the bending wave of that is " + number_text(4 * quarter, 2) +
                " m long: elements of " + number_text(element_[worst.member], 2) +
                " m are longer than a quarter of it, so momentum and energy passed may be off by 10 % and more",
            "elements = " + std::to_string(wanted) + " of the members that are struck",
            line_of_member(structure.model(), worst.member)};
}

/// The one that misses the largest part; none where all miss less than 40 %.
const StruckMembers::Struck* StruckMembers::most_missed(const std::vector<Struck>& ended, double largest) const {
    const Struck* most = nullptr;
    double part = most_part_missed;
    for (const Struck& s : ended) {
        if (!(s.impulse > 0 && s.impulse >= counts_from * largest && s.missed > 0)) continue;
        if (const double of = s.missed / (s.missed + s.moment); of > part) part = of, most = &s;
    }
    return most;
}

Warning StruckMembers::warning_of_place(const Structure& structure, const Struck& worst) const {
    const double part = worst.missed / (worst.missed + worst.moment);
    return {Warning::Kind::elements,
            member_text(structure.model(), worst.member) + " was struck between the nodes of its elements, which are " +
                number_text(element_[worst.member], 2) + " m long: what the blow bends there itself is missing, " +
                number_text(std::round(100 * part), 3) +
                " % of the moment, so momentum and energy passed may be off by 5 % and more",
            "a node where it is struck, or elements = " +
                std::to_string(2 * structure.model().members()[worst.member].elements) + " of it",
            line_of_member(structure.model(), worst.member)};
}

bool StruckMembers::warn_of_hinges(const Structure& structure, const State& state, const std::vector<Struck>& ended,
                                   double largest, std::vector<Warning>& list) const {
    const auto& members = structure.model().members();
    std::vector<char> yielded(members.size(), 0);
    for (std::size_t e = 0; e < state.yielded.size(); ++e)
        if (state.yielded[e]) yielded[structure.elements()[e].member] = 1;
    int worst = -1, count = 0;
    for (const Struck& s : ended) {
        if (!(s.between >= counts_from * largest && s.between > 0.5 * s.impulse) || !yielded[s.member] ||
            members[s.member].elements >= enough_elements)
            continue;
        ++count;
        if (worst < 0 || members[s.member].elements < members[worst].elements) worst = s.member;
    }
    if (worst < 0) return false;
    const int now = members[worst].elements;
    list.push_back(
        {Warning::Kind::elements,
         member_text(structure.model(), worst) + " with " + count_text(now, "element") +
             (count > 1 ? " and " + std::to_string(count - 1) + " more were" : " was") +
             " struck between its joints and yielded: hinges form at nodes, so its plastic work may be far off, " +
             "whatever the energy error says",
         "elements = " + std::to_string(enough_elements) + " of the members that are struck",
         line_of_member(structure.model(), worst)});
    return true;
}

}  // namespace

std::unique_ptr<Adviser> advise_of_struck_members(const Run& run, WarningLog&) {
    if (!run.effect_list().has(contact_effect)) return nullptr;
    return std::make_unique<StruckMembers>(run.structure());
}

}  // namespace hinge

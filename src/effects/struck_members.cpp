#include "effects/struck_members.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "model/member_text.h"

namespace hinge {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double counts_from = 0.1;       ///< of the largest impulse: members that got less do not count
constexpr double most_part_missed = 0.4;  ///< of a moment, that goes unsaid
constexpr double at_joint = 0.1;          ///< of a member's length: a blow so near to its end is at the joint
constexpr int enough_elements = 8;        ///< elements of a member that yields between its joints

double quarter_wave(double speed, double tau) { return 0.5 * std::sqrt(pi * tau * speed); }

}  // namespace

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

void StruckMembers::add_step(const Structure& structure, const State& state, const contact::Contact& contact,
                             double time, double dt) {
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
    for (const auto& [member, blow] : blows) add(member, blow, time, dt);
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

void StruckMembers::check_run(const Structure& structure, const State& state, std::vector<RunWarning>& list) const {
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
    else if (warn_of_hinges(structure, state, ended, largest, list)) return;
    else if (const Struck* missing = most_missed(ended, largest)) list.push_back(warning_of_place(structure, *missing));
}

RunWarning StruckMembers::warning_of_waves(const Structure& structure, const Struck& worst, int count) const {
    const double tau = worst.brief_time / worst.brief, quarter = quarter_wave(wave_speed_[worst.member], tau);
    const int now = structure.model().members()[worst.member].elements,
              wanted = 2 * int(std::ceil(0.5 * now * element_[worst.member] / quarter));
    return {member_text(structure.model(), worst.member) +
                (count > 1 ? " and " + std::to_string(count - 1) + " more were" : " was") + " struck for " +
                number_text(1e3 * tau, 2) + " ms, and the bending wave of that is " + number_text(4 * quarter, 2) +
                " m long: elements of " + number_text(element_[worst.member], 2) +
                " m are longer than a quarter of it, so momentum and energy passed may be off by 10 % and more",
            "elements = " + std::to_string(wanted) + " of the members that are struck", worst.member};
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

RunWarning StruckMembers::warning_of_place(const Structure& structure, const Struck& worst) const {
    const double part = worst.missed / (worst.missed + worst.moment);
    return {member_text(structure.model(), worst.member) + " was struck between the nodes of its elements, which are " +
                number_text(element_[worst.member], 2) + " m long: what the blow bends there itself is missing, " +
                number_text(std::round(100 * part), 3) +
                " % of the moment, so momentum and energy passed may be off by 5 % and more",
            "a node where it is struck, or elements = " +
                std::to_string(2 * structure.model().members()[worst.member].elements) + " of it",
            worst.member};
}

bool StruckMembers::warn_of_hinges(const Structure& structure, const State& state, const std::vector<Struck>& ended,
                                   double largest, std::vector<RunWarning>& list) const {
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
        {member_text(structure.model(), worst) + " with " + count_text(now, "element") +
             (count > 1 ? " and " + std::to_string(count - 1) + " more were" : " was") +
             " struck between its joints and yielded: hinges form at nodes, so its plastic work may be far off, " +
             "whatever the energy error says",
         "elements = " + std::to_string(enough_elements) + " of the members that are struck", worst});
    return true;
}

}  // namespace hinge

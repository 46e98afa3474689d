#include "effects/struck_members.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "model/member_text.h"

namespace hinge {
namespace {

constexpr double pi = 3.14159265358979323846;

double quarter_wave(double speed, double tau) { return 0.5 * std::sqrt(pi * tau * speed); }

}  // namespace

StruckMembers::StruckMembers(const Structure& structure)
    : wave_speed_(structure.model().members().size(), 0.0), element_(wave_speed_.size(), 0.0) {
    for (const Element& e : structure.elements()) {
        wave_speed_[e.member] = std::sqrt(std::min(e.rigidity.EIx, e.rigidity.EIy) / e.rigidity.rhoA);
        element_[e.member] = std::max(element_[e.member], e.length);
    }
}

void StruckMembers::add_step(const Structure& structure, const contact::Contact& contact, double time, double dt) {
    std::map<int, double> impulses;
    const auto note = [&](const int element[2], double impulse) {
        for (int side : {0, 1}) impulses[structure.elements()[element[side]].member] += impulse;
    };
    for (const contact::SurfaceContact& c : contact.surface_contacts())
        if (c.depth_before > 0) note(c.element, c.stiffness * c.depth_before * dt);
    for (const contact::Tie& tie : contact.ties()) note(tie.element, (tie.force[0] + tie.force[1]).norm() * dt);
    for (const auto& [member, impulse] : impulses) add(member, impulse, time, dt);
}

// A blow ends where a step passes without contact of the member.
void StruckMembers::add(int member, double impulse, double time, double dt) {
    auto at = std::lower_bound(struck_.begin(), struck_.end(), member,
                               [](const Struck& s, int wanted) { return s.member < wanted; });
    if (at == struck_.end() || at->member != member) at = struck_.insert(at, Struck{member});
    if (at->since >= 0 && time - at->last > 1.5 * dt) end_blow(*at);
    if (at->since < 0) at->since = time - dt;
    at->last = time;
    at->impulse_now += impulse;
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

void StruckMembers::check_run(const Structure& structure, std::vector<RunWarning>& list) const {
    std::vector<Struck> ended = struck_;
    double largest = 0;
    for (Struck& s : ended) {
        if (s.since >= 0) end_blow(s);
        largest = std::max(largest, s.impulse);
    }
    int worst = -1, count = 0;
    double least = 0, worst_tau = 0;
    for (const Struck& s : ended) {
        if (!(s.impulse > 0 && s.impulse >= 0.1 * largest && s.brief > 0.5 * s.impulse)) continue;
        const double tau = s.brief_time / s.brief,
                     ratio = element_[s.member] / quarter_wave(wave_speed_[s.member], tau);
        ++count;
        if (ratio > least) least = ratio, worst = s.member, worst_tau = tau;
    }
    if (worst < 0) return;
    const double quarter = quarter_wave(wave_speed_[worst], worst_tau);
    const int now = structure.model().members()[worst].elements,
              wanted = 2 * int(std::ceil(0.5 * now * element_[worst] / quarter));
    list.push_back({member_text(structure.model(), worst) +
                        (count > 1 ? " and " + std::to_string(count - 1) + " more were" : " was") + " struck for " +
                        number_text(1e3 * worst_tau, 2) + " ms, and the bending wave of that is " +
                        number_text(4 * quarter, 2) + " m long: elements of " + number_text(element_[worst], 2) +
                        " m are longer than a quarter of it, so momentum and energy passed may be off by 10 % and "
                        "more",
                    "elements = " + std::to_string(wanted) + " of the members that are struck", worst});
}

}  // namespace hinge

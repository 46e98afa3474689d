// What pairs of elements cannot show of a beam that is compressed: between clamped ends their middle node does not bend
// out (beam/beam_column.h).
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <numbers>

#include "beam/beam_column.h"
#include "advice/adviser.h"
#include "core/text.h"
#include "run/dynamics.h"
#include "run/pair_compression.h"
#include "run/statics.h"
#include "state/configuration.h"
#include "state/hinges.h"

namespace hinge {
namespace {

/// Where weight acts at the nodes alone (weight = "nodes") the ends rotate too little under it, so that N acts on too
/// small a bow: the moment in the middle of a pinned pair lacks so much of itself times p, and the moment at a clamped
/// end so much of n / (1 - n) times P L / 8, n = N / N_clamped, P: the load in the middle. Both were found against 32
/// elements, within a tenth, up to 0.9 N_E and 0.75 N_clamped.
constexpr double missed_of_span = 0.2, missed_of_end = 0.82;
constexpr double most_missed = 0.05;  ///< of a pair's largest moment, that goes unsaid
constexpr double negligible = 1e-3;   ///< of N i: a moment that adds less than 0.2 % to the stress by N

/// The moments of loads between the ends follow N as far as p = 6 (effects/clamped_member.h, beam/pair_bow.h). What an
/// even load q has beyond that at clamped ends, of q L^2/12: 3 (1 - u cot u) / u^2, u^2 = p.
double of_even_load(double p) {
    const double u = std::sqrt(p);
    return 3 * (1 - u / std::tan(u)) / p;
}

/// What p makes of the moment that an even load has in the middle between clamped ends, over that without N:
/// 6 (u / sin u - 1) / u^2, u^2 = p.
double amplification(double p) {
    const double u = std::sqrt(p);
    return 6 * (u / std::sin(u) - 1) / p;
}

/// What the moment M in the middle lacks with weight = "nodes", N m: no more than between pinned ends, whose moment is
/// 1 / cos u times that without N. `by_load`: P l of the load P on the middle node.
double of_span(double p, double M, double by_load) {
    constexpr double pinned = 0.25 * std::numbers::pi * std::numbers::pi;
    const double most = p < pinned ? (1 / std::cos(std::sqrt(p)) - 1) * by_load : p * M;
    return missed_of_span * std::min(p * M, most);
}

/// Shortening of a pair between its ends by the bow of an even load q, over its length l of one element: half of what
/// Q^2 H'(p) + 2 K Q F'(p) is, with Q = q l^3 / EI, K the rotation of both ends, C of beam/beam_column.h,
///   F = (1 - C) / p,  H = (F - 1/3) / p
double shortened_by_load(double p, double Q, double K) {
    if (std::abs(p) < 0.02) return 0.5 * (Q * Q * 2 / 945 + 2 * K * Q / 45);
    const auto F = [](double at) {
        const double u = std::sqrt(std::abs(at));
        return (1 - (at > 0 ? u / std::tan(u) : u / std::tanh(u))) / at;
    };
    const auto H = [&](double at) { return (F(at) - 1.0 / 3) / at; };
    const double h = 1e-3 * std::abs(p);
    return 0.5 * (Q * Q * (H(p + h) - H(p - h)) + 2 * K * Q * (F(p + h) - F(p - h))) / (2 * h);
}

/// Whether something may hold an end of a member: a support there, or another member. A node that is free to go there
/// gives way, so that the sag makes no tension.
bool may_be_held(const Structure& structure, int node, int member) {
    constexpr std::uint8_t translations = 0b111;
    const auto at = structure.elements_at(node);
    return std::popcount<unsigned>(structure.fixed()[node] & translations) == 3 ||
           std::any_of(at.begin(), at.end(), [&](int i) { return structure.elements()[i].member != member; });
}
bool both_ends_may_be_held(const Structure& structure, int element) {
    const int member = structure.elements()[element].member;
    const auto& nodes = structure.model().members()[member].node;
    return may_be_held(structure, nodes[0], member) && may_be_held(structure, nodes[1], member);
}

/// What p_delta = "chord" misses: N acts on the chords of the elements, not on their bow of M l^2 / 8 EI, M: mean
/// moment of an element of the length l. As N bends the member further, it grows to 1 / (1 - N / N_E) of that; N_E: of
/// the length over which the member bends to one side. Two elements miss 2.6 times as much: their middle node moves
/// less than a beam's. In a pinned member under an even load the moments lack 0.41 N / (N_E - N) with two elements,
/// 0.05 with four, 0.013 with eight; this says 0.40, 0.07 and 0.02.
constexpr double most_missed_by_chord = 0.1;  ///< of the largest moment, that goes unsaid
constexpr double missed_by_two = 2.6;

struct MissedByChord {
    int element = -1;
    double force = 0, part = most_missed_by_chord;
};

double mean_moment(const Vec6& force, int plane) { return 0.5 * (force[2 * plane + 1] - force[2 * plane]); }

MissedByChord missed_by_chord(const Structure& structure, const State& state) {
    constexpr double euler = std::numbers::pi * std::numbers::pi, most_amplified = 0.9;
    MissedByChord worst;
    const std::vector<MemberData>& members = structure.model().members();
    std::vector<std::array<double, 4>> bent(members.size(), {0, 0, 0, 0});  // m, about x and y, to each side
    const auto bent_to = [&](int element, int plane) -> double& {
        return bent[std::size_t(structure.elements()[std::size_t(element)].member)]
                   [std::size_t(2 * plane + (mean_moment(state.force[std::size_t(element)], plane) > 0))];
    };
    for (int i = 0; i < int(structure.elements().size()); ++i)
        for (int plane : {0, 1}) bent_to(i, plane) += structure.elements()[std::size_t(i)].length;
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        const Element& e = structure.elements()[i];
        const Vec6& f = state.force[i];
        const double N = -f[4];
        if (state.broken[i] || !(N > 0)) continue;
        const double times = members[std::size_t(e.member)].elements == 2 ? missed_by_two : 1;
        for (int plane : {0, 1}) {
            const double EI = (plane == 0 ? e.rigidity.EIx : e.rigidity.EIy) * heat_of(state.heat, int(i)).stiffness,
                         n = N * std::pow(bent_to(int(i), plane), 2) / (euler * EI),
                         most = std::max(std::abs(f[2 * plane + 1]), std::abs(f[2 * plane])),
                         lacks = times * N * e.length * e.length / (8 * EI) * std::abs(mean_moment(f, plane)) /
                                 (1 - std::min(n, most_amplified));
            if (!(lacks > negligible * N * std::sqrt(EI / e.rigidity.EA))) continue;
            if (const double part = lacks / (most + lacks); part > worst.part) worst = {int(i), N, part};
        }
    }
    return worst;
}

std::string whole_percent(double part) { return number_text(std::round(100 * part), 3) + " %"; }

/// What compression a pair cannot show, each told once in a run.
class PairWarnings : public Adviser {
public:
    explicit PairWarnings(WarningLog& log) : log_(log) {}
    void after_step(const Run& run) override;
    void save(Writer& to) const override { to(euler_told_, moments_told_, tension_told_, stiffness_told_); }
    void restore(Reader& from) override { from(euler_told_, moments_told_, tension_told_, stiffness_told_); }
    bool goes_on() const override { return false; }

private:
    using LoadOn = std::function<Vec3(int)>;  ///< force on a node, N
    /// Compression beyond Euler's load between clamped ends.
    void warn_beyond_euler(const Run& run);
    /// Compression beyond p' = 6, where a pair is stiffer than the beam (beam/beam_column.h): held by stiff joints, it
    /// buckles at a load that is 1 % too high at 0.66 of that between clamped ends, 15 % at 0.87.
    void warn_of_stiffness(const Run& run);
    /// Moments that lack what the loads along the pair make of its compression: they would bend out the middle node.
    void warn_of_moments(const Run& run, const LoadOn& load_on);
    void warn_of_chords(const Run& run);
    /// Tension that loads between the nodes of a pair make by its sag, if its ends are held apart: a pair bows by the
    /// rotations of its ends alone.
    void warn_of_tension(const Run& run, const LoadOn& load_on);
    void warn(const Run& run, int member, std::string what, std::string advice) {
        log_.add({Warning::Kind::elements, std::move(what), std::move(advice),
                  line_of_member(run.structure().model(), member)});
    }

    WarningLog& log_;
    bool euler_told_ = false, moments_told_ = false, tension_told_ = false, stiffness_told_ = false;
};

PairCompression compression_of(const Run& run, int first) {
    return pair_compression(run.structure(), run.state(), run.state().force, first);
}

/// "at t = 0.1 s", "at load factor 0.5"
std::string place_of(const Run& run) {
    const State& state = run.state();
    if (run.workspace().goes_by_load_factor()) return "at load factor " + number_text(state.factor);
    return "at t = " + number_text(state.time, 4) + " s";
}

/// About x and about y, the larger one of either end, N m.
Eigen::Vector2d largest_moment(const Run& run, int element) {
    const SectionForces a = run.section_forces(element, -1), b = run.section_forces(element, 1);
    return {std::max(std::abs(a.Mx), std::abs(b.Mx)), std::max(std::abs(a.My), std::abs(b.My))};
}

/// Dynamics: F on a middle node, and what loads between nodes pass on to it: the jump that they make in the shear
/// forces.
Vec3 load_in_dynamics(const Run& run, int node) {
    const Structure& structure = run.structure();
    double jump[2] = {0, 0};
    const auto at = structure.elements_at(node);
    for (int i : at) {
        const Element& e = structure.elements()[i];
        const double side = e.node[1] == node ? 1 : -1;
        const SectionForces whole = run.section_forces(i, side);
        const Vec6& p = run.state().force[i];
        jump[0] -= side * (whole.Qx + (p[2] + p[3]) / e.length);
        jump[1] -= side * (whole.Qy - (p[0] + p[1]) / e.length);
    }
    const Mat3 axes = axes_of(element_frame(structure, at[0], run.state()));
    return run.workspace().external[node].head<3>() + jump[0] * axes.col(0) + jump[1] * axes.col(1);
}

void PairWarnings::after_step(const Run& run) {
    if (!is_time_to_check(run)) return;
    if (const auto* statics = run.statics()) {
        const LoadOn load_on = [&](int node) -> Vec3 { return statics->load_on(node).head<3>(); };
        warn_of_moments(run, load_on);
        warn_of_tension(run, load_on);
        return warn_of_stiffness(run);
    }
    if (!run.structure().large()) return;
    warn_beyond_euler(run);
    warn_of_moments(run, [&](int node) { return load_in_dynamics(run, node); });
    // Of slow motion alone: under a blow, or as it falls, a member does not sag as it would at rest.
    constexpr double slow = 0.2;
    warn_of_tension(run, [&](int node) -> Vec3 {
        const Element& e = run.structure().elements()[run.structure().elements_at(node)[0]];
        const Vec3 load = load_in_dynamics(run, node), inertia = e.mass() * run.state().acceleration[node].head<3>();
        return inertia.norm() <= slow * load.norm() ? load : Vec3(Vec3::Zero());
    });
}

void PairWarnings::warn_of_stiffness(const Run& run) {
    const Structure& structure = run.structure();
    constexpr double from = 0.65;
    if (stiffness_told_ || !structure.large()) return;
    for (int i = 0; i + 1 < int(structure.elements().size()); i += 2) {
        if (!(compression_of(run, i).most() > from)) continue;
        stiffness_told_ = true;
        const int member = structure.elements()[std::size_t(i)].member,
                  elements = structure.model().members()[std::size_t(member)].elements;
        return warn(run, member,
                    "member " + std::to_string(member + 1) + " is compressed beyond " + number_text(from, 2) +
                        " of the load at which " + (elements == 2 ? "it" : "a pair of its elements") +
                        " buckles between clamped ends; two elements are stiffer there than a member is, and a "
                        "load at which it buckles comes out up to 15 % too high",
                    "give it elements = " + std::to_string(2 * elements));
    }
}

void PairWarnings::warn_beyond_euler(const Run& run) {
    if (euler_told_) return;
    const Structure& structure = run.structure();
    double worst = 1;
    int at = -1;
    for (std::size_t i = 0; i + 1 < structure.elements().size(); i += 2)
        if (const double part = compression_of(run, int(i)).most(); part > worst) worst = part, at = int(i);
    if (at < 0) return;
    euler_told_ = true;
    const int member = structure.elements()[at].member;
    const double N = compression_of(run, at).force;
    const bool two = structure.model().members()[member].elements == 2;
    warn(run, member,
         "member " + std::to_string(member + 1) + " is compressed by " + number_text(N, 4) + " N " + place_of(run) +
             ", and " + (two ? "" : "a pair of its elements ") + "buckles between clamped ends at " +
             number_text(N / worst, 4) + " N",
         "where that lasts it bends out: two elements cannot show that, four can");
}

void PairWarnings::warn_of_chords(const Run& run) {
    const Structure& structure = run.structure();
    const MissedByChord worst = missed_by_chord(structure, run.state());
    if (worst.element < 0) return;
    moments_told_ = true;
    const int member = structure.elements()[worst.element].member;
    const bool chord = structure.model().options().p_delta == PDelta::chord;
    warn(run, member,
         "member " + std::to_string(member + 1) + " is compressed by " + number_text(worst.force, 4) + " N " +
             place_of(run) + ", which acts on the chords of its " +
             std::to_string(structure.model().members()[member].elements) + " elements, not on their bow" +
             (chord ? " (p_delta = \"chord\")" : "") + ": its moments are some " + whole_percent(worst.part) +
             " too small, more so as it is compressed further, and its limit load is too high",
         std::string(chord ? "p_delta = \"member\"" : "formulation = \"asi-gauss\"") +
             ", or twice as many elements, which have a quarter of that");
}

void PairWarnings::warn_of_moments(const Run& run, const LoadOn& load_on) {
    const Structure& structure = run.structure();
    if (moments_told_ || !structure.large()) return;
    if (!structure.p_delta()) return warn_of_chords(run);
    constexpr double clamped = std::numbers::pi * std::numbers::pi;
    const bool at_nodes = structure.model().options().weight == Weight::nodes;
    const double least = at_nodes ? 0.03 : beam::pair_most / clamped;
    double worst = most_missed;
    int at = -1;
    for (std::size_t i = 0; i + 1 < structure.elements().size(); i += 2) {
        const PairCompression by = compression_of(run, int(i));
        if (!(by.most() > least) || by.most() >= 1) continue;
        const Element& e = structure.elements()[i];
        const Vec3 load = load_on(e.node[1]);
        if (load.isZero(0)) continue;
        const Mat3 axes = axes_of(element_frame(structure, int(i), run.state()));
        const Eigen::Vector2d has = largest_moment(run, int(i)).cwiseMax(largest_moment(run, int(i) + 1));
        for (int plane : {0, 1}) {  // bending about x is by loads along y
            const double n = by.part[plane], EI = plane == 0 ? e.rigidity.EIx : e.rigidity.EIy;
            if (n <= least) continue;
            const double by_N = at_nodes ? missed_of_end * n / (1 - n) / 4
                                         : (of_even_load(clamped * n) - of_even_load(beam::pair_most)) / 3;
            const double by_load = std::abs(axes.col(1 - plane).dot(load)) * e.length,
                         lacks = std::max(by_N * by_load, at_nodes ? of_span(clamped * n, has[plane], by_load) : 0.0);
            if (!(lacks > negligible * by.force * std::sqrt(EI / e.rigidity.EA))) continue;
            if (const double part = lacks / (has[plane] + lacks); part > worst) worst = part, at = int(i);
        }
    }
    if (at < 0) return;
    moments_told_ = true;
    const int member = structure.elements()[at].member;
    const PairCompression by = compression_of(run, at);
    warn(run, member,
         "member " + std::to_string(member + 1) + " has loads between its nodes and is compressed by " +
             number_text(by.force, 4) + " N " + place_of(run) + ", " + whole_percent(by.most()) +
             " of what buckles a pair of its elements between clamped ends, where such loads make " +
             number_text(amplification(clamped * by.most()), 2) +
             " times the moment in the middle that they make without compression: its moments are some " +
             whole_percent(worst) + " too small, and more so as it is compressed further",
         "two elements cannot show that, four can");
}

void PairWarnings::warn_of_tension(const Run& run, const LoadOn& load_on) {
    const Structure& structure = run.structure();
    const State& state = run.state();
    if (tension_told_ || !structure.p_delta()) return;
    constexpr double negligible_strain = 2e-5, most_part = 0.05, most_p = 2.4;
    double worst = most_part, force = 0;
    int at = -1;
    for (std::size_t i = 0; i + 1 < structure.elements().size(); i += 2) {
        const Element& e = structure.elements()[i];
        if (e.partner != int(i) + 1 || state.broken[i] || state.broken[i + 1]) continue;
        const Vec3 load = load_on(e.node[1]);
        if (load.isZero(0) || !both_ends_may_be_held(structure, int(i))) continue;
        const Mat3 axes = axes_of(element_frame(structure, int(i), state));
        const double N = 0.5 * (state.force[i][4] + state.force[i + 1][4]), l = e.length;
        double strain = 0;
        for (int plane : {0, 1}) {
            const double EI = plane == 0 ? e.rigidity.EIx : e.rigidity.EIy;
            const double across = axes.col(1 - plane).dot(load), Q = across * l * l / EI;
            double K = 0;
            for (const int k : {0, 1}) {
                const Vec6 d = element_deformation(structure, int(i) + k, state) - state.plastic[i + k];
                K += 0.5 * (d[2 * plane + 1] - d[2 * plane]);
            }
            // a load along y, and one against x, makes positive moments in the span
            strain += shortened_by_load(std::min(-N * l * l / EI, most_p), (plane == 0 ? 1 : -1) * Q, K);
        }
        if (!(std::abs(strain) > negligible_strain)) continue;
        const double missed = e.rigidity.EA * strain, part = std::abs(missed) / (std::abs(N) + std::abs(missed));
        if (part > worst) worst = part, force = missed, at = int(i);
    }
    if (at < 0) return;
    tension_told_ = true;
    const int member = structure.elements()[at].member;
    warn(run, member,
         "member " + std::to_string(member + 1) + " sags under the loads between its nodes " + place_of(run) +
             ": if its ends are held apart, up to " + number_text(std::abs(force), 2) +
             " N of tension by that sag are missing",
         "two elements cannot show that, eight can");
}

}  // namespace

std::unique_ptr<Adviser> advise_of_pairs(const Run&, WarningLog& log) { return std::make_unique<PairWarnings>(log); }

}  // namespace hinge

#include "run/pressed_pairs.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "beam/beam_column.h"
#include "core/text.h"
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

std::string percent(double part) { return number_text(std::round(100 * part), 3) + " %"; }

}  // namespace

PairCompression pressed(const Structure& structure, const State& state, const std::vector<Vec6>& force, int first) {
    constexpr double clamped = std::numbers::pi * std::numbers::pi;  // p'
    const Element& e = structure.elements()[first];
    if (e.partner != first + 1 || state.broken[first] || state.broken[first + 1] || structure.conventional()) return {};
    const double N = -0.5 * (force[first][4] + force[first + 1][4]);
    const beam::PairKind<double> k = pair_kind_of(e, heat_of(state.heat, first));
    const auto part = [&](int plane) { return N * k.c[plane] * (1 + clamped * k.shear[plane].flexible) / clamped; };
    return {N, {part(0), part(1)}};
}

std::optional<RunWarning> PressedPairs::stiffer_than_beam(const Structure& structure, const State& state) {
    constexpr double from = 0.65;
    if (stiffness_told_ || !structure.large()) return {};
    for (int i = 0; i + 1 < int(structure.elements().size()); i += 2) {
        if (!(pressed(structure, state, state.force, i).most() > from)) continue;
        stiffness_told_ = true;
        const int member = structure.elements()[std::size_t(i)].member,
                  elements = structure.model().members()[std::size_t(member)].elements;
        return RunWarning{"member " + std::to_string(member + 1) + " is compressed beyond " + number_text(from, 2) +
                              " of the load at which " + (elements == 2 ? "it" : "a pair of its elements") +
                              " buckles between clamped ends; two elements are stiffer there than a member is, and a "
                              "load at which it buckles comes out up to 15 % too high",
                          "give it elements = " + std::to_string(2 * elements), member};
    }
    return {};
}

std::optional<RunWarning> PressedPairs::beyond_euler(const Structure& structure, const State& state,
                                                     const std::string& where) {
    if (euler_told_ || !structure.large()) return {};
    double worst = 1;
    int at = -1;
    for (std::size_t i = 0; i + 1 < structure.elements().size(); i += 2)
        if (const double part = pressed(structure, state, state.force, int(i)).most(); part > worst)
            worst = part, at = int(i);
    if (at < 0) return {};
    euler_told_ = true;
    const int member = structure.elements()[at].member;
    const double N = pressed(structure, state, state.force, at).force;
    const bool two = structure.model().members()[member].elements == 2;
    return RunWarning{"member " + std::to_string(member + 1) + " is compressed by " + number_text(N, 4) + " N " +
                          where + ", and " + (two ? "" : "a pair of its elements ") +
                          "buckles between clamped ends at " + number_text(N / worst, 4) + " N",
                      "where that lasts it bends out: two elements cannot show that, four can", member};
}

std::optional<RunWarning> PressedPairs::missed_moments(const Structure& structure, const State& state,
                                                       const std::function<Vec3(int)>& load_on,
                                                       const std::function<Eigen::Vector2d(int)>& largest_moment,
                                                       const std::string& where) {
    if (moments_told_ || !structure.large()) return {};
    if (!structure.p_delta()) {
        const MissedByChord worst = missed_by_chord(structure, state);
        if (worst.element < 0) return {};
        moments_told_ = true;
        const int member = structure.elements()[worst.element].member;
        const bool chord = structure.model().options().p_delta == PDelta::chord;
        return RunWarning{"member " + std::to_string(member + 1) + " is compressed by " + number_text(worst.force, 4) +
                              " N " + where + ", which acts on the chords of its " +
                              std::to_string(structure.model().members()[member].elements) +
                              " elements, not on their bow" + (chord ? " (p_delta = \"chord\")" : "") +
                              ": its moments are some " + percent(worst.part) +
                              " too small, more so as it is compressed further, and its limit load is too high",
                          std::string(chord ? "p_delta = \"member\"" : "formulation = \"asi-gauss\"") +
                              ", or twice as many elements, which have a quarter of that",
                          member};
    }
    constexpr double clamped = std::numbers::pi * std::numbers::pi;
    const bool at_nodes = structure.model().options().weight == Weight::nodes;
    const double least = at_nodes ? 0.03 : beam::pair_most / clamped;
    double worst = most_missed;
    int at = -1;
    for (std::size_t i = 0; i + 1 < structure.elements().size(); i += 2) {
        const PairCompression by = pressed(structure, state, state.force, int(i));
        if (!(by.most() > least) || by.most() >= 1) continue;
        const Element& e = structure.elements()[i];
        const Vec3 load = load_on(e.node[1]);
        if (load.isZero(0)) continue;
        const Mat3 axes = axes_of(element_frame(structure, int(i), state));
        const Eigen::Vector2d has = largest_moment(int(i)).cwiseMax(largest_moment(int(i) + 1));
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
    if (at < 0) return {};
    moments_told_ = true;
    const int member = structure.elements()[at].member;
    const PairCompression by = pressed(structure, state, state.force, at);
    return RunWarning{"member " + std::to_string(member + 1) + " has loads between its nodes and is compressed by " +
                          number_text(by.force, 4) + " N " + where + ", " + percent(by.most()) +
                          " of what buckles a pair of its elements between clamped ends, where such loads make " +
                          number_text(amplification(clamped * by.most()), 2) +
                          " times the moment in the middle that they make without compression: its moments are some " +
                          percent(worst) + " too small, and more so as it is compressed further",
                      "two elements cannot show that, four can", member};
}

std::optional<RunWarning> PressedPairs::missed_tension(const Structure& structure, const State& state,
                                                       const std::function<Vec3(int)>& load_on,
                                                       const std::string& where) {
    if (tension_told_ || !structure.p_delta()) return {};
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
    if (at < 0) return {};
    tension_told_ = true;
    const int member = structure.elements()[at].member;
    return RunWarning{"member " + std::to_string(member + 1) + " sags under the loads between its nodes " + where +
                          ": if its ends are held apart, up to " + number_text(std::abs(force), 2) +
                          " N of tension by that sag are missing",
                      "two elements cannot show that, eight can", member};
}

}  // namespace hinge

// The stages of the assembly for eight elements at once: deformation, elastic forces, return to the yield surface,
// forces at the nodes, inertia, and the elements whose stiffness is out of date. What few elements need is in
// assembly_rare.cpp.
#include <algorithm>
#include <bit>

#include "beam/pair_return.h"
#include "core/built.h"
#include "state/element_block.h"
#include "state/gather.h"
#include "state/hinges.h"

namespace hinge {

using beam::Quadruple;
using beam::Triple;

namespace {

/// What bending counts for, against rotation, in the rebuilding of a pair's tangent: it couples N with moments, by
/// kappa l/r / 6 of their own stiffnesses. A portal of l/r = 70 to 100 whose feet stop at once has an energy error of
/// 1e-6 of the work so, and of 5e-5 where bending counts as rotation does.
constexpr double bending_counts = 1.0 / 64;

/// Turns the nodes' rotations to those of the elements' ends (state/turned_ends.h), of the eight from `element` on.
[[gnu::noinline]] void turn(Quadruple<Lanes> (&end)[2], const std::vector<TurnedEnds>& turned, int element) {
    for (int e : {0, 1}) {
        Lanes by[4];
        for (int i = 0; i < lane_count; ++i)
            for (int c = 0; c < 4; ++c)
                by[c][i] = turned[std::min(std::size_t(element + i), turned.size() - 1)].by[e][c];
        end[e] = beam::product(end[e], {by[0], by[1], by[2], by[3]});
    }
}

/// Small displacement: the frame of the start, and the deformation to first order.
beam::ElementFrame<Lanes> start_placement(const Quadruple<Lanes>& axes, const Lanes& length) {
    const Lanes zero = {}, one = spread(1.0, length);
    beam::ElementFrame<Lanes> p;
    p.frame = beam::rotated_triad(axes, {one, zero, zero, zero});
    p.length = length;
    p.theta[0] = p.theta[1] = {zero, zero, zero};
    p.y[0] = p.y[1] = {zero, one, zero};
    p.y_mean_y = one;
    p.y_mean_z = zero;
    return p;
}

void linear_deformation(const beam::ElementFrame<Lanes>& p, const Triple<Lanes>& relative,
                        const Triple<Lanes>& rotation1, const Triple<Lanes>& rotation2, Lanes d[6]) {
    const auto& f = p.frame;  // d in the place of the strains of eqs 7b, 10b and 12b
    const Lanes u = dot(f.x, relative) / p.length, v = dot(f.y, relative) / p.length;
    d[0] = dot(f.x, rotation1) + v;
    d[1] = dot(f.x, rotation2) + v;
    d[2] = dot(f.y, rotation1) - u;
    d[3] = dot(f.y, rotation2) - u;
    d[4] = dot(f.z, relative);
    d[5] = dot(f.z, rotation2) - dot(f.z, rotation1);
}

/// Which of the eight elements from `element` on have yielded, a bit each.
unsigned that_yielded(const State& state, int element) {
    unsigned bits = 0;
    for (int i = 0; i < lane_count && element + i < int(state.yielded.size()); ++i)
        bits |= unsigned(state.yielded[element + i] != 0) << i;
    return bits;
}

/// Which of the eight elements from `element` on are weakened by shear forces, a bit each.
[[gnu::noinline]] unsigned that_are_sheared(const Structure& structure, const State& state, int element) {
    unsigned bits = 0;
    for (int i = 0; i < lane_count && element + i < int(structure.elements().size()); ++i) {
        const beam::SectionLaw* law = structure.elements()[element + i].law;
        for (const double end : {-1, 1}) {
            const double* history =
                law && law->takes_shear() ? section_history(structure, state, element + i, end) : nullptr;
            if (history && (law->lost_by_shear(false, history) > 0 || law->lost_by_shear(true, history) > 0))
                bits |= 1u << i;
            if (structure.conventional()) break;
        }
    }
    return bits;
}

/// Whether one of the eight elements from `element` on has a twist to be remembered.
bool any_remembered(const std::vector<double>& twist, int element) {
    const auto from = twist.begin() + std::min(std::size_t(element), twist.size());
    return std::any_of(from, from + std::min<std::ptrdiff_t>(lane_count, twist.end() - from),
                       [](double t) { return t != 0; });
}

}  // namespace

/// What the forces of pairs have beyond those of their elements by themselves, where both are whole.
[[gnu::always_inline]] inline void ElementAssembly::add_pair_forces(const beam::PairKind<Lanes>& kind, unsigned whole,
                                                                    const Lanes (&d)[6], Lanes (&p)[6]) {
    Lanes kappa[2] = {d[1] - d[0], d[3] - d[2]};
    if (whole != (1u << lane_count) - 1)
        for (int i = 0; i < lane_count; ++i)
            if ((whole >> (i & ~1) & 3) != 3) kappa[0][i] = kappa[1][i] = 0;
    Lanes sum[2], difference[2];
    for (int plane : {0, 1}) {
        const Lanes other = neighbours(kappa[plane]);
        sum[plane] = kappa[plane] + other, difference[plane] = kappa[plane] - other;
    }
    const Lanes mean = (d[4] + neighbours(d[4])) / 2;
    const beam::PairForces<Lanes> beyond = beam::pair_forces(kind, mean, sum, difference);
    for (int plane : {0, 1}) {
        p[2 * plane] -= beyond.moment[plane];
        p[2 * plane + 1] += beyond.moment[plane];
    }
    p[4] += beyond.N;
}

/// Frame and deformation of the eight elements from `element` on, at `pose` (eqs 7b, 10b and 12b). Returns which are
/// wound, a bit each.
template <bool large>
[[gnu::always_inline]] inline unsigned ElementAssembly::deform(const Block& b, int element, const State& state,
                                                               const Configuration& pose, EightFrames& place,
                                                               Lanes (&d)[6], Found& found) const {
    const Kind& kind = *b.kind;
    const Triple<Lanes> u1 = gather(pose.displacement, b.node[0]), u2 = gather(pose.displacement, b.node[1]);
    const Quadruple<Lanes> axes = {kind.axes[0], kind.axes[1], kind.axes[2], kind.axes[3]};
    if constexpr (large) {
        const Triple<Lanes> chord = Triple<Lanes>{b.chord[0], b.chord[1], b.chord[2]} + (u2 - u1);
        Quadruple<Lanes> node_turn[2] = {gather(pose.rotation, b.node[0]), gather(pose.rotation, b.node[1])};
        if (!state.turned.empty()) turn(node_turn, state.turned, element);
        place = beam::place(chord, node_turn[0], node_turn[1], axes);
        beam::deformation(place, kind.length, d);
        const Lanes rotated = dot(place.theta[0], place.theta[0]) + dot(place.theta[1], place.theta[1]);
        if (!any_not_below(rotated, beam::far_rotation) && !any_remembered(state.twist, element)) return 0;
        found.frame = place.frame;
        for (int c = 0; c < 6; ++c) found.d[c] = d[c];
        const unsigned wound = find_wound(b, element, rotated, state, pose, found);
        place.frame = found.frame;
        for (int c = 0; c < 6; ++c) d[c] = found.d[c];
        return wound;
    } else {
        place = start_placement(axes, kind.length);
        linear_deformation(place, u2 - u1, gather(pose.small_rotation, b.node[0]),
                           gather(pose.small_rotation, b.node[1]), d);
        return 0;
    }
}

/// Eqs 3, 7c and 12c: p = k (d - d_p). Afterwards d is the elastic deformation.
[[gnu::always_inline]] inline void ElementAssembly::elastic_forces(const Kind& kind, int element, const State& state,
                                                                   Lanes (&d)[6], Lanes (&p)[6]) {
    Lanes plastic[lane_count];
    transpose_rows<6>(state.plastic[element].data(), std::min(lane_count, int(state.plastic.size()) - element),
                      plastic);
    for (int c = 0; c < 6; ++c) d[c] -= plastic[c];
    p[0] = kind.k[0] * d[0] + kind.k[1] * d[1];
    p[1] = kind.k[1] * d[0] + kind.k[2] * d[1];
    p[2] = kind.k[3] * d[2] + kind.k[4] * d[3];
    p[3] = kind.k[4] * d[2] + kind.k[5] * d[3];
    p[4] = kind.k[6] * d[4];
    p[5] = kind.k[7] * d[5];
}

/// Eqs 4 and 14: where the yield function is above 1 the forces return to the surface (eq 10c).
template <bool p_delta>
[[gnu::always_inline]] inline void ElementAssembly::yield(const Block& b, int element, const State& state,
                                                          const ElementHeats& heat, const Lanes (&d)[6], Lanes (&p)[6],
                                                          Found& found) const {
    const Kind& kind = *b.kind;
    double section[2];
    const int section_count = sections(section);
    Lanes f[2];
    const Lanes shared = kind.yield[2] * p[4] * p[4] + kind.yield[3] * p[5] * p[5];
    for (int s = 0; s < section_count; ++s) {
        const Lanes mx = (section[s] - 1) / 2 * p[0] + (section[s] + 1) / 2 * p[1],
                    my = (section[s] - 1) / 2 * p[2] + (section[s] + 1) / 2 * p[3];
        f[s] = kind.yield[0] * mx * mx + kind.yield[1] * my * my + shared;
    }
    if (!fixed_ends_.empty()) add_fixed_ends(element, kind, p, f);
    if (!heat.empty()) weaken(element, heat, f);
    unsigned asked = kind.moves_surface ? that_yielded(state, element) : 0;
    if (kind.takes_shear) asked |= that_are_sheared(structure_, state, element);
    if (asked || any_above(f[0], 1) || (section_count == 2 && any_above(f[1], 1)))
        return_lanes<p_delta>(b, element, asked, state, heat, f, d, p, found);
}

/// Eq 10c: the return to the yield surface of those of the eight elements for which f is above 1, and of those `asked`.
template <bool p_delta>
[[gnu::always_inline]] inline void ElementAssembly::return_lanes(const Block& b, int element, unsigned asked,
                                                                 const State& state, const ElementHeats& heats,
                                                                 const Lanes (&f)[2], const Lanes (&d)[6],
                                                                 Lanes (&p)[6], Found& found) const {
    const Kind& kind = *b.kind;
    double section[2];
    const int section_count = sections(section);
    for (int i = 0; i < lane_count; ++i) {
        if (!(b.whole >> i & 1)) continue;
        if (!(asked >> i & 1) && f[0][i] <= 1 && (section_count == 1 || f[1][i] <= 1)) continue;
        if (stops_at_unreturned_ && found.unreturned >= 0) return;
        const Element& e = structure_.elements()[element + i];
        Vec6 trial;
        for (int c = 0; c < 6; ++c) trial[c] = p[c][i];
        if (!trial.allFinite()) continue;  // the step names the culprit
        if (p_delta && b.whole >> (i ^ 1) & 1 && e.forms_pairs) {
            return_pair(element, i & ~1, kind, state, heats, d, p, found);
            i |= 1;
            continue;
        }
        if (no_section_flows(element, i, state, heats, p)) continue;
        const ElementHeat& heat = heat_of(heats, element + i);
        const beam::Stiffness k = heat.stiffness * kind.stiffness(i);
        found.yielding.push_back(
            {element + i,
             law_now(e, heat)->return_to_surface(
                 trial, kind.wears_stiffness ? in_series(k, springs_of(structure_, state, element + i, heat)) : k,
                 section, section_count, conditions(state, element + i))});
        const beam::ReturnMapResult& flow = found.yielding.back().flow;
        if (!flow.converged && found.unreturned < 0) found.unreturned = element + i;
        for (int c = 0; c < 6; ++c) p[c][i] = flow.p[c];
        if (!flow.flows()) found.yielding.pop_back();
    }
}

/// Adds the inertia of the pose's accelerations and its gyroscopic moments to the nodal forces.
template <bool large, bool cubic, bool p_delta>
[[gnu::always_inline]] inline void ElementAssembly::add_inertia(const Block& b, const Configuration& pose,
                                                                const EightFrames& place, unsigned wound,
                                                                beam::NodalForces<Lanes>& out) {
    const Kind& kind = *b.kind;
    const Lanes two = spread(2.0, kind.mass), none = {};
    const Motion m1 = gather_motion(pose.acceleration, b.node[0]), m2 = gather_motion(pose.acceleration, b.node[1]);
    const Triple<Lanes>&a1 = m1.linear, &a2 = m2.linear;
    const auto local = [&](const Triple<Lanes>& v) {
        return Triple<Lanes>{dot(place.frame.x, v), dot(place.frame.y, v), dot(place.frame.z, v)};
    };
    const auto space = [&](const Triple<Lanes>& v) {
        return v.x * place.frame.x + v.y * place.frame.y + v.z * place.frame.z;
    };
    out.force[0] = out.force[0] + kind.mass * (two * a1 + a2);
    out.force[1] = out.force[1] + kind.mass * (a1 + two * a2);
    Triple<Lanes> w1 = {none, none, none}, w2 = w1;
    if constexpr (large) {
        w1 = local(gather(pose.velocity, b.node[0], 3));
        w2 = local(gather(pose.velocity, b.node[1], 3));
    }
    const Triple<Lanes> s1 = local(m1.angular), s2 = local(m2.angular);
    if constexpr (p_delta) {
        const Lanes J[3] = {kind.rotary[0], kind.rotary[1], kind.rotary[2]};
        const beam::Spins of = {
            {w1, w2}, {s1, s2}, local(gather(pose.velocity, b.node[1]) - gather(pose.velocity, b.node[0]))};
        const beam::NodalForces<Lanes> more =
            beam::turning_inertia(place, wound, J, cubic ? kind.more_rotary : nullptr, of);
        for (int e : {0, 1}) {
            out.force[e] = out.force[e] + space(more.force[e]);
            out.moment[e] = out.moment[e] + space(more.moment[e]);
        }
    } else {
        const Triple<Lanes> h1 = beam::rotary_force(kind.rotary, w1, s1), h2 = beam::rotary_force(kind.rotary, w2, s2);
        const Triple<Lanes> g1 = space(h1), g2 = space(h2);
        out.moment[0] = out.moment[0] + two * g1 + g2;
        out.moment[1] = out.moment[1] + g1 + two * g2;
    }
    if constexpr (!cubic) return;
    out.force[0] = out.force[0] + (kind.more[0] * a1 + kind.more_across * a2);
    out.force[1] = out.force[1] + (kind.more_across * a1 + kind.more[1] * a2);
    if constexpr (p_delta) return;
    const Lanes across1[3] = {kind.more_rotary[0], kind.more_rotary[0], none},
                across2[3] = {kind.more_rotary[1], kind.more_rotary[1], none};
    out.moment[0] = out.moment[0] + space(beam::rotary_force(across1, w1, s1));
    out.moment[1] = out.moment[1] + space(beam::rotary_force(across2, w2, s2));
}

/// Element by element again: nodal forces to the nodes, p to the list of all elements.
[[gnu::always_inline]] inline void ElementAssembly::scatter(const Block& b, int element,
                                                            const beam::NodalForces<Lanes>& out, const Lanes (&p)[6],
                                                            std::vector<Vec6>& nodal, std::vector<Vec6>& force) {
    Lanes row[2][lane_count],
        by_end[2][lane_count] = {
            {out.force[0].x, out.force[0].y, out.force[0].z, out.moment[0].x, out.moment[0].y, out.moment[0].z},
            {out.force[1].x, out.force[1].y, out.force[1].z, out.moment[1].x, out.moment[1].y, out.moment[1].z}};
    for (int e : {0, 1}) transpose(by_end[e], row[e]);
    for (int i = 0; i < lane_count; ++i)
        for (int e = 0; e < 2 && b.whole >> i & 1; ++e) {
            const int place = shared_index_.empty() ? -1 : shared_index_[2 * (element + i) + e];
            if (place < 0) add_six(nodal[b.node[e][i]].data(), row[e][i]);
            else store_row<6>(shared_forces_[place].data(), row[e][i]);
        }
    const Lanes forces[lane_count] = {p[0], p[1], p[2], p[3], p[4], p[5]};
    transpose(forces, row[0]);
    for (int i = 0; i < lane_count; ++i)
        if (b.whole >> i & 1) store_row<6>(force[element + i].data(), row[0][i]);
}

/// Lists the elements whose frame has rotated too far since their stiffness was built, or that have bent too much.
template <bool p_delta>
[[gnu::always_inline]] inline void ElementAssembly::find_rotated(const Block& b, int block, const EightFrames& place,
                                                                 const Lanes (&d)[6], Found& found) const {
    const Kind& kind = *b.kind;
    const Lanes* built = &built_[(p_delta ? 8 : 6) * std::size_t(block)];
    const auto square = [](const Triple<Lanes>& now, const Lanes* then) {
        const Triple<Lanes> way = now - Triple<Lanes>{then[0], then[1], then[2]};
        return dot(way, way);
    };
    Lanes rotation_squared = square(place.frame.z, built) + square(place.frame.y, built + 3);
    if constexpr (p_delta) {  // the tangent follows the bending, too
        const Lanes bent[2] = {d[1] - d[0] - built[6], d[3] - d[2] - built[7]};
        const Lanes slender = bending_counts * kind.pair.axial * kind.pair.length;  // times c: (l/r)^2
        for (int plane : {0, 1})
            rotation_squared = rotation_squared + slender * kind.pair.c[plane] * bent[plane] * bent[plane];
    }
    if (!any_above(rotation_squared, rotation_limit_)) return;
    for (int i = 0; i < lane_count; ++i)
        if (rotation_squared[i] > rotation_limit_ && b.whole >> i & 1) found.rotated.push_back(block * lane_count + i);
}

template <bool large, ElementAssembly::Mass mass, bool p_delta>
void ElementAssembly::run_blocks(int first, int end, const State& state, const Configuration& pose,
                                 std::vector<Vec6>& nodal, std::vector<Vec6>& force, Found& found) {
    const bool watching = watching_;
    for (int block = first; block < end; ++block) {
        const Block& b = blocks_[block];
        if (!b.whole) continue;
        const int element = block * lane_count;
        EightFrames place;
        Lanes d[6], p[6];
        const unsigned wound = deform<large>(b, element, state, pose, place, d, found);
        if (!pose.heat.empty()) take_off_heat(element, pose.heat, d);
        elastic_forces(*b.kind, element, state, d, p);
        if constexpr (p_delta) add_pair_forces(b.kind->pair, b.whole, d, p);
        if (b.kind->wears_stiffness) add_springs(b, element, state, d, p);
        if (!pose.heat.empty()) soften(element, pose.heat, p);
        if (built::plasticity && b.kind->can_yield) yield<p_delta>(b, element, state, pose.heat, d, p, found);

        beam::NodalForces<Lanes> out = beam::nodal_forces(place, p);  // eq 1: they do the work of p
        if (wound) {
            found.out = out;
            for (int c = 0; c < 6; ++c) found.p[c] = p[c];
            found.take_forces(wound);
            out = found.out;
        }
        if constexpr (mass != Mass::none) add_inertia<large, mass == Mass::cubic, p_delta>(b, pose, place, wound, out);
        scatter(b, element, out, p, nodal, force);
        if (large && watching) find_rotated<p_delta>(b, block, place, d, found);
    }
}

/// run_blocks for this structure's mass.
template <bool large, bool p_delta>
ElementAssembly::Stages ElementAssembly::choose_stages() const {
    return !inertia_            ? &ElementAssembly::run_blocks<large, Mass::none, p_delta>
           : structure_.cubic() ? &ElementAssembly::run_blocks<large, Mass::cubic, p_delta>
                                : &ElementAssembly::run_blocks<large, Mass::linear, p_delta>;
}

void ElementAssembly::run(const State& state, const Configuration& pose, std::vector<Vec6>& nodal,
                          std::vector<Vec6>& force, std::vector<PlasticIncrement>& yielding) {
    if (pool_.threads() > 1 && shared_index_.empty()) share_out();
    found_.resize((blocks_.size() + piece - 1) / piece);
    const auto chosen = structure_.large()
                            ? structure_.p_delta() ? choose_stages<true, true>() : choose_stages<true, false>()
                            : choose_stages<false, false>();
    pool_.share(int(blocks_.size()), piece, [&](int first, int end, int i) {
        found_[i].yielding.clear();
        found_[i].rotated.clear();
        found_[i].far.clear();
        found_[i].folded = found_[i].unreturned = -1;
        (this->*chosen)(first, end, state, pose, nodal, force, found_[i]);
    });
    pool_.share(int(shared_.size()), 8 * piece, [&](int first, int end, int) {
        for (int i = first; i < end; ++i)
            for (int k = shared_[i].first; k < shared_[i].end; ++k) nodal[shared_[i].node] += shared_forces_[k];
    });
    yielding.clear();
    rotated_.clear();
    far_.clear();
    folded_ = unreturned_ = -1;
    for (const Found& f : found_) {
        yielding.insert(yielding.end(), f.yielding.begin(), f.yielding.end());
        rotated_.insert(rotated_.end(), f.rotated.begin(), f.rotated.end());
        far_.insert(far_.end(), f.far.begin(), f.far.end());
        folded_ = std::max(folded_, f.folded);
        if (unreturned_ < 0) unreturned_ = f.unreturned;
    }
    for (const Block& b : blocks_) updates_ += std::popcount(b.whole);
}

}  // namespace hinge

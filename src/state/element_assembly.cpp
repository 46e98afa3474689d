#include "state/element_assembly.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>

#include "beam/pair_return.h"
#include "beam/mass.h"
#include "beam/tangent.h"
#include "beam/turning_inertia.h"
#include "core/built.h"
#include "state/hinges.h"
#include "state/turned_ends.h"

namespace hinge {

using beam::Quadruple;
using beam::Triple;

/// Elements 8 i to 8 i + 7, in that order.
struct ElementAssembly::Block {
    int node[2][lane_count];
    Lanes chord[3];
    const Kind* kind;
    unsigned whole;  // a bit for each that is not broken
};

/// What blocks of the same eight sections, lengths and directions share: in a regular frame, nearly all of them.
struct ElementAssembly::Kind {
    Lanes length, axes[4];                       // w x y z
    Lanes k[8];                                  // x11 x12 x22 y11 y12 y22 axial twist
    Lanes yield[4];                              // x y n z
    Lanes mass, rotary[3];                       // rho A L/6, rho I L/6: the linear mass
    Lanes more[2], more_across, more_rotary[2];  // what the cubic mass has beyond it
    beam::PairKind<Lanes> pair;                  // what N does to the bending of pairs
    bool can_yield;

    beam::Stiffness stiffness(int i) const {
        return {k[0][i], k[1][i], k[2][i], k[3][i], k[4][i], k[5][i], k[6][i], k[7][i]};
    }
};

struct ElementAssembly::Found {
    std::vector<PlasticIncrement> yielding;
    std::vector<int> rotated, far;
    int folded = -1, unreturned = -1;
    // of a block with wound elements
    beam::Winding winding[lane_count];
    beam::Triad<Lanes> frame;
    Lanes d[6], p[6];
    beam::NodalForces<Lanes> out;

    static void put(Triple<Lanes>& lanes, int i, const Triple<double>& of_element) {
        lanes.x[i] = of_element.x, lanes.y[i] = of_element.y, lanes.z[i] = of_element.z;
    }
    /// Nodal forces of the wound elements, from p.
    [[gnu::noinline]] void take_forces(unsigned which) {
        for (int i = 0; i < lane_count; ++i) {
            if (!(which >> i & 1)) continue;
            Vec6 of_element;
            for (int c = 0; c < 6; ++c) of_element[c] = p[c][i];
            const Vec12 f = beam::rates(winding[i]).transpose() * of_element;
            for (int end : {0, 1}) {
                put(out.force[end], i, {f[6 * end], f[6 * end + 1], f[6 * end + 2]});
                put(out.moment[end], i, {f[6 * end + 3], f[6 * end + 4], f[6 * end + 5]});
            }
        }
    }
};

/// 1 + cos of the angle between a wound element's end and its chord, below which its bending angle has no direction:
/// 177 degrees.
constexpr double least_open = 1e-3;

/// What bending counts for, against rotation, in the rebuilding of a pair's tangent: it couples N with moments, by
/// kappa l/r / 6 of their own stiffnesses. A portal of l/r = 70 to 100 whose feet stop at once has an energy error of
/// 1e-6 of the work so, and of 5e-5 where bending counts as rotation does.
constexpr double bending_counts = 1.0 / 64;

/// Blocks that one thread takes at a time.
constexpr int piece = 64;

ElementAssembly::ElementAssembly(const Structure& structure, ThreadPool& pool, bool inertia)
    : structure_(structure), pool_(pool), inertia_(inertia) {}

ElementAssembly::~ElementAssembly() = default;

int ElementAssembly::sections(double* r) const {
    if (structure_.conventional()) return r[0] = 0, 1;
    return r[0] = -1, r[1] = 1, 2;
}

void ElementAssembly::mark_built(int element, const State& state, const Configuration& pose) {
    if (!watching_) return;
    const ElementFrame place = element_frame(structure_, element, pose);
    const Mat3 frame = axes_of(place);
    const int i = element % lane_count;
    Lanes* built = &built_[built_stride() * std::size_t(element / lane_count)];
    for (int c = 0; c < 3; ++c) built[c][i] = frame(c, 2), built[3 + c][i] = frame(c, 1);
    if (!structure_.p_delta()) return;
    const Vec6 d = element_deformation(structure_, element, pose, place) - state.plastic[element];
    built[6][i] = d[1] - d[0], built[7][i] = d[3] - d[2];
}

void ElementAssembly::watch_rotation(double tolerance) {
    watching_ = true;
    rotation_limit_ = tolerance * tolerance;
    built_.assign(built_stride() * blocks_.size(), Lanes{});
}

void ElementAssembly::take_up(const State& state) {
    const int count = int(state.broken.size());
    blocks_.resize((count + lane_count - 1) / lane_count);
    kinds_.clear();
    std::map<std::array<const void*, lane_count>, const Kind*> known;
    for (int block = 0; block < int(blocks_.size()); ++block) {
        Block& b = blocks_[block];
        b.whole = 0;
        std::array<const void*, lane_count> alike;
        bool as_declared = true;
        int index[lane_count];
        for (int i = 0; i < lane_count; ++i) {
            index[i] = std::min(block * lane_count + i,
                                count - 1);  // a short block repeats its last element and drops the copies
            const Element& e = structure_.elements()[index[i]];
            alike[i] = &e.stiffness;
            as_declared = as_declared && state.point[index[i]] == e.s;
            b.node[0][i] = e.node[0];
            b.node[1][i] = e.node[1];
            for (int c = 0; c < 3; ++c) b.chord[c][i] = e.chord[c];
            if (block * lane_count + i < count && !state.broken[index[i]]) b.whole |= 1u << i;
        }
        if (as_declared) {
            const Kind*& kind = known[alike];
            if (!kind) kind = &add_kind(state, index);
            b.kind = kind;
        } else {
            b.kind = &add_kind(state, index);
        }
    }
}

const ElementAssembly::Kind& ElementAssembly::add_kind(const State& state, const int* index) {
    kinds_.emplace_back();
    Kind& kind = kinds_.back();
    kind.can_yield = false;
    for (int i = 0; i < lane_count; ++i) {
        const Element& e = structure_.elements()[index[i]];
        const beam::Stiffness k = stiffness_now(structure_, state, index[i]);
        kind.length[i] = e.length;
        const double q[4] = {e.axes.w(), e.axes.x(), e.axes.y(), e.axes.z()};
        for (int c = 0; c < 4; ++c) kind.axes[c][i] = q[c];
        const double ks[8] = {k.x11, k.x12, k.x22, k.y11, k.y12, k.y22, k.axial, k.twist};
        for (int c = 0; c < 8; ++c) kind.k[c][i] = ks[c];
        const double w[4] = {e.yield.x, e.yield.y, e.yield.n, e.yield.z};
        for (int c = 0; c < 4; ++c) kind.yield[c][i] = w[c];
        kind.mass[i] = e.mass() / 6;
        const Vec3 rotary = beam::rotary_inertia(e.rigidity) * (e.length / 6);
        for (int c = 0; c < 3; ++c) kind.rotary[c][i] = rotary[c];
        const beam::Inertia linear = beam::linear_inertia(e.rigidity, e.length), whole = structure_.inertia(index[i]);
        for (int end : {0, 1}) {
            kind.more[end][i] = whole.own[end] - linear.own[end];
            kind.more_rotary[end][i] = whole.rotary[end].x() - linear.rotary[end].x();
        }
        kind.more_across[i] = whole.across - linear.across;
        if (structure_.p_delta()) {
            const beam::PairKind<double> pair = pair_kind_of(e);
            kind.pair.axial[i] = pair.axial, kind.pair.length[i] = pair.length;
            for (int plane : {0, 1}) kind.pair.b[plane][i] = pair.b[plane], kind.pair.c[plane][i] = pair.c[plane];
        }
        kind.can_yield |= !e.yield.elastic();
    }
    return kind;
}

void ElementAssembly::raise(int element) { blocks_[element / lane_count].whole |= 1u << element % lane_count; }

void ElementAssembly::drop(int element) {
    blocks_[element / lane_count].whole &= ~(1u << element % lane_count);
    if (place_.empty()) return;
    for (int e : {0, 1})
        if (const int place = place_[2 * element + e]; place >= 0) left_[place].setZero();
}

std::vector<std::uint8_t> ElementAssembly::taking_part() const {
    std::vector<std::uint8_t> whole;
    for (const Block& b : blocks_) whole.push_back(std::uint8_t(b.whole));
    return whole;
}

std::vector<double> ElementAssembly::frames() const {
    const auto* first = reinterpret_cast<const double*>(built_.data());
    return {first, first + built_.size() * lane_count};
}

/// False, and nothing has changed, where somebody would take part who is broken or not there.
bool ElementAssembly::take_part(const std::vector<std::uint8_t>& whole, const std::vector<double>& built) {
    if (whole.size() != blocks_.size() || built.size() != built_.size() * lane_count) return false;
    for (std::size_t i = 0; i < whole.size(); ++i)
        if (whole[i] & ~blocks_[i].whole) return false;
    for (std::size_t i = 0; i < whole.size(); ++i) blocks_[i].whole = whole[i];
    std::copy(built.begin(), built.end(), reinterpret_cast<double*>(built_.data()));
    for (Vec6& l : left_) l.setZero();
    return true;
}

namespace {

/// Three numbers of each node, from the given one of its numbers on.
template <class T>
[[gnu::always_inline]] inline Triple<Lanes> gather(const std::vector<T>& from, const int* node, int offset = 0) {
    Lanes v[lane_count];
    pick_rows<3>(from.data()->data() + offset, node, sizeof(T) / sizeof(double), v);
    return {v[0], v[1], v[2]};
}

[[gnu::always_inline]] inline Quadruple<Lanes> gather(const std::vector<Quat>& from, const int* node) {
    Lanes v[lane_count];
    pick_rows<4>(from.data()->coeffs().data(), node, 4, v);  // x y z w
    return {v[3], v[0], v[1], v[2]};
}

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

struct Motion {
    Triple<Lanes> linear, angular;
};
[[gnu::always_inline]] inline Motion gather_motion(const std::vector<Vec6>& from, const int* node) {
    Lanes v[lane_count];
    pick_rows<6>(from.data()->data(), node, 6, v);
    return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
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

/// Whether one of the eight elements from `element` on has a twist to be remembered.
bool any_remembered(const std::vector<double>& twist, int element) {
    const auto from = twist.begin() + std::min(std::size_t(element), twist.size());
    return std::any_of(from, from + std::min<std::ptrdiff_t>(lane_count, twist.end() - from),
                       [](double t) { return t != 0; });
}

/// Whether an end has turned past half a turn against its element since its plastic deformation came about: then the
/// measure, which ends at half a turn, has gone over to the other side, and the elastic part would be a whole turn off.
bool turned_over(const double (&bent)[4], const Vec6& plastic) {
    for (int e : {0, 1}) {
        const double x = bent[e], y = bent[2 + e], angle = std::hypot(x, y), over = 1 - 2 * std::numbers::pi / angle;
        const auto off = [&](double times) { return std::hypot(times * x - plastic[e], times * y - plastic[2 + e]); };
        if (angle > 0 && off(over) < off(1)) return true;
    }
    return false;
}

}  // namespace

/// Which elements of the block are wound, a bit each; puts their frame and deformation in the place of those found.
[[gnu::noinline]] unsigned ElementAssembly::find_wound(const Block& b, int element, const Lanes& rotated,
                                                       const State& state, const Configuration& pose,
                                                       Found& found) const {
    unsigned wound = 0;
    for (int i = 0; i < lane_count; ++i) {
        const int index = element + i;
        if (!(b.whole >> i & 1)) continue;
        if (rotated[i] < beam::far_rotation && (state.twist.empty() || state.twist[index] == 0)) continue;
        const Element& e = structure_.elements()[index];
        found.far.push_back(index);
        beam::Winding& w = found.winding[i];
        w = winding_of(e, index, pose);
        const bool is_wound = beam::wind(w);
        double bent[4];
        for (int c = 0; c < 4; ++c) bent[c] = is_wound ? w.d[c] : found.d[c][i];
        if (turned_over(bent, state.plastic[index])) found.folded = found.unreturned = index;
        if (!is_wound) continue;
        wound |= 1u << i;
        if (w.open < least_open) found.folded = index;
        Found::put(found.frame.x, i, w.frame.x);
        Found::put(found.frame.y, i, w.frame.y);
        Found::put(found.frame.z, i, w.frame.z);
        for (int c = 0; c < 6; ++c) found.d[c][i] = w.d[c];
    }
    return wound;
}

/// An element's twist is remembered from a third of a turn on: below, it can be told from the nodes' rotations alone.
std::vector<int> ElementAssembly::keep_turns(State& state, Configuration& trial) const {
    std::vector<int> turned;
    if (far_.empty() && state.twist.empty()) return turned;
    const auto keep = [&](int index) {
        const Element& e = structure_.elements()[index];
        beam::Winding w = winding_of(e, index, state);
        beam::wind(w);
        const bool far = std::abs(w.twist) > beam::remembered_twist && !state.broken[index];
        if (far && state.twist.empty()) state.twist.assign(state.broken.size(), 0);
        if (!state.twist.empty()) state.twist[index] = far ? w.twist : 0;
    };
    for (int index : far_)
        if (state.twist.empty() || state.twist[index] == 0) keep(index);
    for (std::size_t i = 0; i < state.twist.size(); ++i)
        if (state.twist[i] != 0) keep(int(i));
    for (int index : far_)
        if (turn_ends(structure_, state, index)) turned.push_back(index);
    trial.twist = state.twist;
    if (!turned.empty()) trial.turned = state.turned;
    return turned;
}

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

/// f_y at each section anew, of the eight elements from `element` on, with what loads between the nodes do there.
[[gnu::noinline]] void ElementAssembly::add_fixed_ends(int element, const Kind& kind, const Lanes (&p)[6],
                                                       Lanes (&f)[2]) const {
    static_assert(sizeof(beam::FixedEnd) == 8 * sizeof(double));
    Lanes fixed[lane_count];
    transpose_rows<8>(fixed_ends_[element].moment, std::min(lane_count, int(fixed_ends_.size()) - element), fixed);
    double section[2];
    const int section_count = sections(section);
    for (int s = 0; s < section_count; ++s) {
        const double n1 = (1 - section[s]) / 2, n2 = (1 + section[s]) / 2;
        const Lanes mx = n2 * (p[1] + fixed[1]) - n1 * (p[0] + fixed[0]),
                    my = n2 * (p[3] + fixed[3]) - n1 * (p[2] + fixed[2]), n = p[4] + n1 * fixed[4] + n2 * fixed[5],
                    mz = p[5] + n1 * fixed[6] + n2 * fixed[7];
        f[s] = kind.yield[0] * mx * mx + kind.yield[1] * my * my + kind.yield[2] * n * n + kind.yield[3] * mz * mz;
    }
}

/// The return to the yield surface of a pair, the first of which is lane i.
[[gnu::noinline]] void ElementAssembly::return_pair(int element, int i, const Kind& kind, const Lanes (&d)[6],
                                                    Lanes (&p)[6], Found& found) const {
    beam::Stiffness k[2];
    Vec6 elastic[2];
    const beam::YieldSurface* surface[2];
    for (int j : {0, 1}) {
        const int at = i + j;
        k[j] = kind.stiffness(at);
        for (int c = 0; c < 6; ++c) elastic[j][c] = d[c][at];
        surface[j] = &structure_.elements()[element + at].yield;
    }
    beam::ReturnMapResult flow[2];
    const beam::FixedEnd* fixed = fixed_ends_.empty() ? beam::no_fixed_ends : &fixed_ends_[element + i];
    const bool converged = beam::return_to_surface(pair_kind_of(structure_.elements()[element + i]), k, elastic,
                                                   surface, flow, return_tolerance_, fixed);
    if (!converged && found.unreturned < 0) found.unreturned = element + i;
    for (int j : {0, 1}) {
        for (int c = 0; c < 6; ++c) p[c][i + j] = flow[j].p[c];
        if (flow[j].flows()) found.yielding.push_back({element + i + j, flow[j]});
    }
}

template <bool large, bool inertia, bool cubic, bool p_delta>
void ElementAssembly::run_blocks(int first, int end, const State& state, const Configuration& pose,
                                 std::vector<Vec6>& nodal, std::vector<Vec6>& force, Found& found) {
    double section[2];
    const int section_count = sections(section);
    const bool watching = watching_;
    for (int block = first; block < end; ++block) {
        const Block& b = blocks_[block];
        if (!b.whole) continue;
        const Kind& kind = *b.kind;
        const int element = block * lane_count;
        const Triple<Lanes> u1 = gather(pose.displacement, b.node[0]), u2 = gather(pose.displacement, b.node[1]);
        const Quadruple<Lanes> axes = {kind.axes[0], kind.axes[1], kind.axes[2], kind.axes[3]};
        beam::ElementFrame<Lanes> place;
        Lanes d[6];
        unsigned wound = 0;
        if constexpr (large) {
            const Triple<Lanes> chord = Triple<Lanes>{b.chord[0], b.chord[1], b.chord[2]} + (u2 - u1);
            Quadruple<Lanes> end[2] = {gather(pose.rotation, b.node[0]), gather(pose.rotation, b.node[1])};
            if (!state.turned.empty()) turn(end, state.turned, element);
            place = beam::place(chord, end[0], end[1], axes);
            beam::deformation(place, kind.length, d);
            const Lanes rotated = dot(place.theta[0], place.theta[0]) + dot(place.theta[1], place.theta[1]);
            if (any_not_below(rotated, beam::far_rotation) || any_remembered(state.twist, element)) {
                found.frame = place.frame;
                for (int c = 0; c < 6; ++c) found.d[c] = d[c];
                wound = find_wound(b, element, rotated, state, pose, found);
                place.frame = found.frame;
                for (int c = 0; c < 6; ++c) d[c] = found.d[c];
            }
        } else {
            place = start_placement(axes, kind.length);
            linear_deformation(place, u2 - u1, gather(pose.small_rotation, b.node[0]),
                               gather(pose.small_rotation, b.node[1]), d);
        }

        // elastic forces, eqs 3, 7c and 12c: p = k (d - d_p)
        Lanes plastic[lane_count];
        transpose_rows<6>(state.plastic[element].data(), std::min(lane_count, int(state.plastic.size()) - element),
                          plastic);
        for (int c = 0; c < 6; ++c) d[c] -= plastic[c];
        Lanes p[6] = {kind.k[0] * d[0] + kind.k[1] * d[1],
                      kind.k[1] * d[0] + kind.k[2] * d[1],
                      kind.k[3] * d[2] + kind.k[4] * d[3],
                      kind.k[4] * d[2] + kind.k[5] * d[3],
                      kind.k[6] * d[4],
                      kind.k[7] * d[5]};

        if constexpr (p_delta) add_pair_forces(kind.pair, b.whole, d, p);

        // yield, eqs 4 and 14: where the function is above 1, return to the surface (eq 10c)
        if (built::plasticity && kind.can_yield) {
            Lanes f[2];
            const Lanes shared = kind.yield[2] * p[4] * p[4] + kind.yield[3] * p[5] * p[5];
            for (int s = 0; s < section_count; ++s) {
                const Lanes mx = (section[s] - 1) / 2 * p[0] + (section[s] + 1) / 2 * p[1],
                            my = (section[s] - 1) / 2 * p[2] + (section[s] + 1) / 2 * p[3];
                f[s] = kind.yield[0] * mx * mx + kind.yield[1] * my * my + shared;
            }
            if (!fixed_ends_.empty()) add_fixed_ends(element, kind, p, f);
            if (any_above(f[0], 1) || (section_count == 2 && any_above(f[1], 1)))
                for (int i = 0; i < lane_count; ++i) {
                    if (!(b.whole >> i & 1) || (f[0][i] <= 1 && (section_count == 1 || f[1][i] <= 1))) continue;
                    const Element& e = structure_.elements()[element + i];
                    Vec6 trial;
                    for (int c = 0; c < 6; ++c) trial[c] = p[c][i];
                    if (!trial.allFinite()) continue;  // the step names the culprit
                    if (p_delta && b.whole >> (i ^ 1) & 1) {
                        return_pair(element, i & ~1, kind, d, p, found);
                        i |= 1;
                        continue;
                    }
                    found.yielding.push_back(
                        {element + i, beam::return_to_surface(trial, kind.stiffness(i), e.yield, section, section_count,
                                                              fixed_end(element + i))});
                    const beam::ReturnMapResult& flow = found.yielding.back().flow;
                    if (!flow.converged && found.unreturned < 0) found.unreturned = element + i;
                    for (int c = 0; c < 6; ++c) p[c][i] = flow.p[c];
                }
        }

        beam::NodalForces<Lanes> out = beam::nodal_forces(place, p);  // eq 1: they do the work of p
        if (wound) {
            found.out = out;
            for (int c = 0; c < 6; ++c) found.p[c] = p[c];
            found.take_forces(wound);
            out = found.out;
        }

        if constexpr (inertia) {
            const Lanes two = spread(2.0, kind.mass);
            const Motion m1 = gather_motion(pose.acceleration, b.node[0]),
                         m2 = gather_motion(pose.acceleration, b.node[1]);
            const Triple<Lanes>&a1 = m1.linear, &a2 = m2.linear;
            out.force[0] = out.force[0] + kind.mass * (two * a1 + a2);
            out.force[1] = out.force[1] + kind.mass * (a1 + two * a2);
            const auto local = [&](const Triple<Lanes>& v) {
                return Triple<Lanes>{dot(place.frame.x, v), dot(place.frame.y, v), dot(place.frame.z, v)};
            };
            const Lanes none = {};
            Triple<Lanes> w1 = {none, none, none}, w2 = w1;
            if constexpr (large) {
                w1 = local(gather(pose.velocity, b.node[0], 3));
                w2 = local(gather(pose.velocity, b.node[1], 3));
            }
            const Triple<Lanes> s1 = local(m1.angular), s2 = local(m2.angular);
            const auto space = [&](const Triple<Lanes>& v) {
                return v.x * place.frame.x + v.y * place.frame.y + v.z * place.frame.z;
            };
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
                const Triple<Lanes> h1 = beam::rotary_force(kind.rotary, w1, s1),
                                    h2 = beam::rotary_force(kind.rotary, w2, s2);
                const Triple<Lanes> g1 = space(h1), g2 = space(h2);
                out.moment[0] = out.moment[0] + two * g1 + g2;
                out.moment[1] = out.moment[1] + g1 + two * g2;
            }
            if constexpr (cubic) {
                out.force[0] = out.force[0] + (kind.more[0] * a1 + kind.more_across * a2);
                out.force[1] = out.force[1] + (kind.more_across * a1 + kind.more[1] * a2);
                if constexpr (!p_delta) {
                    const Lanes across1[3] = {kind.more_rotary[0], kind.more_rotary[0], none},
                                across2[3] = {kind.more_rotary[1], kind.more_rotary[1], none};
                    out.moment[0] = out.moment[0] + space(beam::rotary_force(across1, w1, s1));
                    out.moment[1] = out.moment[1] + space(beam::rotary_force(across2, w2, s2));
                }
            }
        }

        // element by element again
        Lanes row[2][lane_count],
            by_end[2][lane_count] = {
                {out.force[0].x, out.force[0].y, out.force[0].z, out.moment[0].x, out.moment[0].y, out.moment[0].z},
                {out.force[1].x, out.force[1].y, out.force[1].z, out.moment[1].x, out.moment[1].y, out.moment[1].z}};
        for (int e : {0, 1}) transpose(by_end[e], row[e]);
        for (int i = 0; i < lane_count; ++i)
            for (int e = 0; e < 2 && b.whole >> i & 1; ++e) {
                const int place = place_.empty() ? -1 : place_[2 * (element + i) + e];
                if (place < 0) add_six(nodal[b.node[e][i]].data(), row[e][i]);
                else store_row<6>(left_[place].data(), row[e][i]);
            }
        const Lanes forces[lane_count] = {p[0], p[1], p[2], p[3], p[4], p[5]};
        transpose(forces, row[0]);
        for (int i = 0; i < lane_count; ++i)
            if (b.whole >> i & 1) store_row<6>(force[element + i].data(), row[0][i]);
        if (large && watching) {
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
            if (any_above(rotation_squared, rotation_limit_))
                for (int i = 0; i < lane_count; ++i)
                    if (rotation_squared[i] > rotation_limit_ && b.whole >> i & 1) found.rotated.push_back(element + i);
        }
    }
}

/// Which nodes have elements in more than one piece.
void ElementAssembly::share_out() {
    place_.assign(2 * structure_.elements().size(), -1);
    const auto piece_of = [](int element) { return element / (piece * lane_count); };
    for (int node = 0; node < int(structure_.position().size()); ++node) {
        const std::span<const int> at = structure_.elements_at(node);
        if (at.empty() || piece_of(at.front()) == piece_of(at.back())) continue;
        const int first = int(left_.size());
        for (int e : at) {
            place_[2 * e + (structure_.elements()[e].node[0] == node ? 0 : 1)] = int(left_.size());
            left_.push_back(Vec6::Zero());
        }
        shared_.push_back({node, first, int(left_.size())});
    }
}

void ElementAssembly::run(const State& state, const Configuration& pose, std::vector<Vec6>& nodal,
                          std::vector<Vec6>& force, std::vector<PlasticIncrement>& yielding) {
    if (pool_.threads() > 1 && place_.empty()) share_out();
    found_.resize((blocks_.size() + piece - 1) / piece);
    pool_.share(int(blocks_.size()), piece, [&](int first, int end, int i) {
        found_[i].yielding.clear();
        found_[i].rotated.clear();
        found_[i].far.clear();
        found_[i].folded = found_[i].unreturned = -1;
        const auto go_over = [&]<bool large>() {
            const auto choose = [&]<bool p_delta>() {
                return !inertia_            ? &ElementAssembly::run_blocks<large, false, false, p_delta>
                       : structure_.cubic() ? &ElementAssembly::run_blocks<large, true, true, p_delta>
                                            : &ElementAssembly::run_blocks<large, true, false, p_delta>;
            };
            const auto run_blocks_of = large && structure_.p_delta() ? choose.template operator()<large>()
                                                                     : choose.template operator()<false>();
            (this->*run_blocks_of)(first, end, state, pose, nodal, force, found_[i]);
        };
        structure_.large() ? go_over.operator()<true>() : go_over.operator()<false>();
    });
    pool_.share(int(shared_.size()), 8 * piece, [&](int first, int end, int) {
        for (int i = first; i < end; ++i)
            for (int k = shared_[i].first; k < shared_[i].end; ++k) nodal[shared_[i].node] += left_[k];
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

std::string ElementAssembly::failure() const {
    if (folded_ >= 0) {
        // a hinge that turns so far would have broken; what is elastic bends less in shorter elements
        const bool unbroken =
            inertia_ && !structure_.elements()[folded_].yield.elastic() && structure_.model().fracture().empty();
        return "an end of " + structure_.element_name(folded_) +
               " has folded back against the element itself, by 177 degrees or more; " +
               (unbroken ? "a rule of fracture (model:fracture) may help" : "more elements a member may help");
    }
    if (unreturned_ >= 0)
        return "the plastic flow of " + structure_.element_name(unreturned_) +
               " was not found: its forces are too far beyond the yield surface for one step";
    return {};
}

}  // namespace hinge

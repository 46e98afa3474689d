#include "effects/loaded_member.h"

#include <algorithm>
#include <cmath>

namespace hinge {
namespace {

/// Rotation of two nodes' axes by a change of the nodes' places and rotations: that of the chord, and about it the
/// mean of the nodes. 3 x 12. `span`: of the chord, m.
Eigen::Matrix<double, 3, 12> rotation_of_axes(const Vec3& span) {
    const Vec3 z = span.normalized();
    Eigen::Matrix<double, 3, 12> by;
    by.block<3, 3>(0, 6) = skew(z) / span.norm();
    by.block<3, 3>(0, 0) = -by.block<3, 3>(0, 6);
    by.block<3, 3>(0, 3) = by.block<3, 3>(0, 9) = 0.5 * z * z.transpose();
    return by;
}

/// Subtracts from the stiffness what the forces on two nodes change by when the axes that carry them rotate.
void add_rotating(const int node[2], const Vec3& span, const Vec6 f[2], Blocks& blocks) {
    const Eigen::Matrix<double, 3, 12> by = rotation_of_axes(span);
    Mat12 K;
    for (int end : {0, 1}) {
        K.middleRows<3>(6 * end) = skew(f[end].head<3>()) * by;
        K.middleRows<3>(6 * end + 3) = skew(f[end].tail<3>()) * by;
    }
    blocks.stiffness(node[0], node[1], K);
}

LoadedMember loaded_member(const Workspace& w, const MemberLoad& load, int declared, const MemberEnds& member,
                           const MemberEnds& ends, const std::vector<Portion>& parts) {
    const int first = ends.first, n = ends.count, all = member.count;
    const Element& e = w.structure.elements()[first];
    LoadedMember l{ends, member, declared, {}, load.axes == LoadAxes::local, load.history, {}, {}, {}};
    l.held = load.held, l.on_node = is_on_node(load, all);
    l.may_jump = load.history && load.history.may_jump_in(steep * w.kind.dt);
    if (l.may_jump) l.over.kept = l.over.begin = l.over.end = load.history.from(w.state.time);
    const double begin = double(first - member.first) / all;
    for (int of : {0, 1}) {
        if (!load.spread()) break;
        const double xi = begin + double(of * n) / all;
        const auto at_end = [&](int end) { return force_per_length(load, end, e.chord.normalized()); };
        l.spread[of] = (1 - xi) * at_end(0) + xi * at_end(1);
    }
    if (load.spread() && load.is_partial() && w.structure.p_delta() && e.forms_pairs) {
        l.pieces =
            portions_of_pair(load, begin, double(n) / all,
                             w.structure.model().members()[load.member].elements * e.length, e.chord.normalized());
        for (Vec3& q : l.spread) q.setZero();
    }
    if (!load.spread()) {
        l.at = std::clamp((load.at - begin) * all / n, 0.0, 1.0);
        l.point = load.force[0], l.couple = load.moment[0];
    }
    l.shares.resize(n);
    for (int end_of : {0, 1})
        for (int plane : {0, 1}) l.of_force[end_of][plane].setZero(), l.of_moment[end_of][plane].setZero();
    const ClampedMember clamped(w.structure, first, first + n);
    for (const Portion& p : parts) {
        const double lever[2] = {1 - p.eta, p.eta};
        for (int i : {0, 1}) {
            l.shares[p.element].force[i] += lever[i] * p.force;
            l.shares[p.element].moment[i] += lever[i] * p.moment;
        }
        for (int of : {0, 1})
            for (int plane : {0, 1}) {
                const int to = 6 * of + 3 + plane;
                const auto passed_on = [&](int direction) {
                    return lever[0] * clamped.arrives(p.element, direction, to) +
                           lever[1] * clamped.arrives(p.element + 1, direction, to);
                };
                l.of_force[of][plane] += (clamped.of_force(of, plane, p.xi) - passed_on(1 - plane)) * p.force;
                l.of_moment[of][plane] += (clamped.of_moment(of, plane, p.xi) - passed_on(3 + plane)) * p.moment;
            }
    }
    return l;
}

}  // namespace

void LoadedMember::drop() {
    std::fill(shares.begin(), shares.end(), LoadShare());
    for (int end : {0, 1})
        for (int plane : {0, 1}) of_force[end][plane].setZero(), of_moment[end][plane].setZero();
    for (int end : {0, 1}) spread[end].setZero();
    point.setZero(), couple.setZero(), pieces.clear(), sums.reset();
    dropped = true;
}

bool LoadedMember::merge(const LoadedMember& other) {
    const auto simple = [](const LoadedMember& l) { return l.at < 0 && !l.local && !l.history; };
    if (!simple(*this) || !simple(other) || ends.first != other.ends.first || ends.count != other.ends.count ||
        held != other.held)
        return false;
    merged.push_back(other.declared);
    for (std::size_t i = 0; i < shares.size(); ++i)
        for (int end : {0, 1}) {
            shares[i].force[end] += other.shares[i].force[end];
            shares[i].moment[end] += other.shares[i].moment[end];
        }
    for (int end : {0, 1}) {
        for (int plane : {0, 1})
            of_force[end][plane] += other.of_force[end][plane], of_moment[end][plane] += other.of_moment[end][plane];
        spread[end] += other.spread[end];
    }
    pieces.insert(pieces.end(), other.pieces.begin(), other.pieces.end());
    return true;
}

void LoadedMember::sum_up() {
    if (pieces.empty() ||
        std::any_of(pieces.begin(), pieces.end(), [](const Portion& p) { return !p.moment.isZero(0); }))
        return;
    sums = std::make_unique<PairForces>();
    for (const Portion& p : pieces) sums->add(p.force, 2 * p.xi - 1);
}

std::vector<LoadedMember> loaded_members(const Workspace& w, const MemberLoad& load, int declared, int first, int end) {
    std::vector<LoadedMember> list;
    const Element& e = w.structure.elements()[first];
    const int n = end - first, at_once = w.structure.p_delta() && e.forms_pairs ? 2 : n;
    const std::vector<Portion> all = portions(load, n, n * e.length, e.chord.normalized());
    for (int k = 0; k < n; k += at_once) {
        std::vector<Portion> here;
        for (Portion p : all) {
            if (p.element < k || p.element >= k + at_once) continue;
            p.element -= k, p.xi = (p.xi * n - k) / at_once;
            here.push_back(p);
        }
        if (!here.empty()) list.push_back(loaded_member(w, load, declared, {first, n}, {first + k, at_once}, here));
    }
    return list;
}

void find_moments(const Workspace& w, const LoadedMember& l, double factor, const Pose& at, Vec3 m[2]) {
    m[0].setZero(), m[1].setZero();
    if (!l.ends.whole(w.state)) return;
    const Mat3 axes = l.ends.axes(w.structure, at);
    for (int end : {0, 1}) m[end] = factor * end_moment(l, end, axes);
}
void add_fixed_end(const Workspace& w, const LoadedMember& l, int element, double factor, const Pose& at,
                   const Vec3 m[2], const CompressionMoments& by_N, beam::FixedEnd& to) {
    const LoadShare& share = l.shares[element - l.ends.first];
    const Vec3 along = l.local ? Vec3(0, 0, 1) : direction_of(w.structure, element, at);
    const double own_part = l.on_node ? 0 : factor;
    const bool twists = own_part != 0 && (!share.moment[0].isZero(0) || !share.moment[1].isZero(0));
    const Mat3 to_element = l.local || !twists ? Mat3(Mat3::Identity())
                                               : Mat3(axes_of(element_frame(w.structure, element, at)).transpose());
    for (int end : {0, 1}) {
        const double side = end == 0 ? 1 : -1;  // the section balances what its node got
        const Vec3 there = l.ends.moment_at(element, end, m),
                   own = twists ? Vec3(side * factor * (to_element * share.moment[end])) : Vec3(Vec3::Zero());
        to.add(end, there.x() + own.x(), there.y() + own.y(), side * own_part * along.dot(share.force[end]), own.z());
    }
    if (!l.ends.whole(w.state)) return;
    for (int end = 0; end < 2 && by_N.counts; ++end) {
        const Vec3 there = by_N.pair.moment_at(element, end, by_N.m);
        to.add(end, there.x(), there.y(), 0, 0);
        if (by_N.is_middle(element, end)) to.add(end, by_N.middle[0], by_N.middle[1], 0, 0);
    }
}

CompressionMoments compression_moments(const Workspace& w, const LoadedMember& l, double factor, const Pose& at,
                                       const std::vector<Vec6>& force) {
    CompressionMoments is{false, l.ends};
    const bool between = l.at < 0 || (l.at > 0 && l.at < 1);
    if (!w.structure.p_delta() || l.ends.count != 2 || !between) return is;
    const PressedPair by_N(w.structure, l.ends.first, force, w.trial.heat);
    if (!by_N.counts()) return is;
    is.counts = true;
    is.chord = is.pair.chord(w.structure, at);
    const auto across = [&](const Vec3& f, int plane) {
        return factor * (l.local ? f[1 - plane] : is.chord.axes.col(1 - plane).dot(f));
    };
    const auto add_point = [&](int plane, double at_part, const Vec3& point, const Vec3& couple) {
        const double P = across(point, plane), x = 2 * at_part - 1,
                     M = factor * (l.local ? couple[plane] : is.chord.axes.col(plane).dot(couple));
        if (P != 0) {
            for (int of : {0, 1}) is.m[of][plane] += P * by_N.of_force(of, plane, x);
            is.middle[plane] += P * by_N.middle_of_force(plane, x);
        }
        if (M == 0) return;
        for (int of : {0, 1}) is.m[of][plane] += M * by_N.of_couple(of, plane, x);
        is.middle[plane] += M * by_N.middle_of_couple(plane, x);
    };
    for (int plane : {0, 1}) {
        if (l.sums && by_N.is_mild(plane)) {
            const Vec3 along = factor * (l.local ? Vec3(Vec3::Unit(1 - plane)) : Vec3(is.chord.axes.col(1 - plane)));
            double ends[2] = {0, 0};
            by_N.add_forces(plane, *l.sums, along, ends, is.middle[plane]);
            for (int of : {0, 1}) is.m[of][plane] += ends[of];
        } else {
            for (const Portion& p : l.pieces) add_point(plane, p.xi, p.force, p.moment);
        }
        if (l.at >= 0) add_point(plane, l.at, l.point, l.couple);
        const double q[2] = {across(l.spread[0], plane), across(l.spread[1], plane)};
        if (q[0] == 0 && q[1] == 0) continue;
        for (int of : {0, 1}) is.m[of][plane] += by_N.of_spread(of, plane, q);
        is.middle[plane] += by_N.middle_of_spread(plane, 0.5 * (q[0] + q[1]));
    }
    return is;
}

Vec3 end_moment(const LoadedMember& l, int end, const Mat3& axes) {
    Vec3 m = Vec3::Zero();
    for (int plane : {0, 1}) {
        const Vec3 &f = l.of_force[end][plane], &c = l.of_moment[end][plane];
        m[plane] = l.local ? f[1 - plane] + c[plane] : axes.col(1 - plane).dot(f) + axes.col(plane).dot(c);
    }
    return m;
}

void add_derivative(const Workspace& w, const LoadedMember& l, const Pose& at, double factor, Blocks& blocks) {
    const auto& elements = w.structure.elements();
    const auto place = [&](int node) { return Vec3(w.structure.position()[node] + at.displacement[node]); };
    for (std::size_t i = 0; i < l.shares.size(); ++i) {
        const int element = l.ends.first + int(i);
        if (w.state.broken[element]) continue;
        const int* node = elements[element].node;
        const Mat3 to_space = factor * axes_of(element_frame(w.structure, element, at));
        Vec6 f[2];
        for (int end : {0, 1}) f[end] << to_space * l.shares[i].force[end], to_space * l.shares[i].moment[end];
        add_rotating(node, place(node[1]) - place(node[0]), f, blocks);
    }
    if (!l.ends.whole(w.state)) return;
    const MemberEnds::Chord chord = l.ends.chord(w.structure, at);
    const int node[2] = {elements[l.ends.first].node[0], elements[l.ends.first + l.ends.count - 1].node[1]};
    Vec3 m[2];
    for (int end : {0, 1}) m[end] = factor * (chord.axes * end_moment(l, end, chord.axes));
    Vec6 f[2];
    l.ends.pass_on(w.structure, chord.span, m, [&](int n, const Vec6& force) { f[n == node[1]] = force; });
    add_rotating(node, chord.span, f, blocks);
}

}  // namespace hinge

#include "sim/sweep.h"

#include "beam/mass.h"

namespace hinge {

using beam::Lanes;
using beam::pick;
using beam::lane_count;
using beam::Placement;
using beam::Quadruple;
using beam::Triple;

struct Sweep::Block {
    int count;
    int element[lane_count], node[2][lane_count];
    Lanes length, chord[3], axes[4];   // axes: w x y z
    Lanes k[8];                        // x11 x12 x22 y11 y12 y22 axial twist
    Lanes yield[4];                    // x y n z
    Lanes mass, rotary[3];             // rho A L/6, rho I L/6
    bool can_yield;
};

struct Sweep::Found {
    std::vector<Yielding> yielding;
    std::vector<int> turned;
};

/// Blocks that one thread takes at a time.
constexpr int piece = 64;

Sweep::Sweep(const Structure& structure, Team& team, bool inertia) : structure_(structure), team_(team), inertia_(inertia) {}

Sweep::~Sweep() = default;

int Sweep::sections(double* r) const {
    if (structure_.conventional()) return r[0] = 0, 1;
    return r[0] = -1, r[1] = 1, 2;
}

void Sweep::mark_built(int element, const Mat3& frame) {
    if (watching_) built_[element] = {frame.col(2), frame.col(1)};
}

void Sweep::take_up(const State& state) {
    blocks_.clear();
    std::vector<int> whole;
    for (std::size_t i = 0; i < state.broken.size(); ++i)
        if (!state.broken[i]) whole.push_back(int(i));
    for (std::size_t first = 0; first < whole.size(); first += lane_count) {
        Block b{};
        b.count = int(std::min<std::size_t>(lane_count, whole.size() - first));
        b.can_yield = false;
        for (int i = 0; i < lane_count; ++i) {
            const int index = whole[first + std::min(i, b.count - 1)];  // a short block repeats its last element and drops the copies
            const Element& e = structure_.elements()[index];
            const beam::Stiffness k = state.point[index] == e.s ? e.stiffness : beam::stiffness(e.rigidity, e.length, state.point[index]);
            b.element[i] = index;
            b.node[0][i] = e.node[0];
            b.node[1][i] = e.node[1];
            b.length[i] = e.length;
            for (int c = 0; c < 3; ++c) b.chord[c][i] = e.chord[c];
            const double q[4] = {e.axes.w(), e.axes.x(), e.axes.y(), e.axes.z()};
            for (int c = 0; c < 4; ++c) b.axes[c][i] = q[c];
            const double ks[8] = {k.x11, k.x12, k.x22, k.y11, k.y12, k.y22, k.axial, k.twist};
            for (int c = 0; c < 8; ++c) b.k[c][i] = ks[c];
            const double w[4] = {e.yield.x, e.yield.y, e.yield.n, e.yield.z};
            for (int c = 0; c < 4; ++c) b.yield[c][i] = w[c];
            b.mass[i] = e.rigidity.rhoA * e.length / 6;
            const Vec3 rotary = beam::rotary_inertia(e.rigidity) * (e.length / 6);
            for (int c = 0; c < 3; ++c) b.rotary[c][i] = rotary[c];
            b.can_yield |= !e.yield.elastic();
        }
        blocks_.push_back(b);
    }
}

namespace {

template <class T>
Triple<Lanes> gather(const std::vector<T>& from, const int* node, int offset = 0) {
    const double* first = from.data()->data() + offset;
    constexpr int stride = sizeof(T) / sizeof(double);
    return {pick(first, node, stride), pick(first + 1, node, stride), pick(first + 2, node, stride)};
}

Quadruple<Lanes> gather(const std::vector<Quat>& from, const int* node) {
    const double* first = from.data()->coeffs().data();  // x y z w
    return {pick(first + 3, node, 4), pick(first, node, 4), pick(first + 1, node, 4), pick(first + 2, node, 4)};
}

/// Small displacement: the frame of the start, and the deformation to first order.
Placement<Lanes> start_placement(const Quadruple<Lanes>& axes, const Lanes& length) {
    const Lanes zero = {}, one = beam::spread(1.0, length);
    Placement<Lanes> p;
    p.frame = beam::turned_triad(axes, {one, zero, zero, zero});
    p.length = length;
    p.theta[0] = p.theta[1] = {zero, zero, zero};
    p.y[0] = p.y[1] = {zero, one, zero};
    p.y_mean_y = one;
    p.y_mean_z = zero;
    return p;
}

void linear_deformation(const Placement<Lanes>& p, const Triple<Lanes>& relative, const Triple<Lanes>& turn1, const Triple<Lanes>& turn2, Lanes d[6]) {
    const auto& f = p.frame;
    const Lanes u = dot(f.x, relative) / p.length, v = dot(f.y, relative) / p.length;
    d[0] = dot(f.x, turn1) + v;
    d[1] = dot(f.x, turn2) + v;
    d[2] = dot(f.y, turn1) - u;
    d[3] = dot(f.y, turn2) - u;
    d[4] = dot(f.z, relative);
    d[5] = dot(f.z, turn2) - dot(f.z, turn1);
}

/// Rotary inertia of a spin w and its rate a in the frame: J a + w x J w, per share of mass.
Triple<Lanes> rotary_force(const Lanes* J, const Triple<Lanes>& w, const Triple<Lanes>& a) {
    const Triple<Lanes> h = {J[0] * w.x, J[1] * w.y, J[2] * w.z};
    return Triple<Lanes>{J[0] * a.x, J[1] * a.y, J[2] * a.z} + cross(w, h);
}

}  // namespace

template <bool large, bool inertia>
void Sweep::run_blocks(int first, int end, const State& state, const Pose& pose, std::vector<Vec6>& nodal, std::vector<Vec6>& force, Found& found) {
    double section[2];
    const int section_count = sections(section);
    const bool alone = reach_.empty(), watching = watching_;
    for (int block = first; block < end; ++block) {
        const Block& b = blocks_[block];
        const Triple<Lanes> u1 = gather(pose.displacement, b.node[0]), u2 = gather(pose.displacement, b.node[1]);
        const Quadruple<Lanes> axes = {b.axes[0], b.axes[1], b.axes[2], b.axes[3]};
        Placement<Lanes> place;
        Lanes d[6];
        if constexpr (large) {
            const Triple<Lanes> chord = Triple<Lanes>{b.chord[0], b.chord[1], b.chord[2]} + (u2 - u1);
            place = beam::place(chord, gather(pose.rotation, b.node[0]), gather(pose.rotation, b.node[1]), axes);
            beam::deformation(place, b.length, d);
        } else {
            place = start_placement(axes, b.length);
            linear_deformation(place, u2 - u1, gather(pose.turn, b.node[0]), gather(pose.turn, b.node[1]), d);
        }

        // elastic forces: p = k (d - d_p)
        for (int c = 0; c < 6; ++c) d[c] -= pick(state.plastic.data()->data() + c, b.element, 6);
        Lanes p[6] = {b.k[0] * d[0] + b.k[1] * d[1], b.k[1] * d[0] + b.k[2] * d[1],
                      b.k[3] * d[2] + b.k[4] * d[3], b.k[4] * d[2] + b.k[5] * d[3], b.k[6] * d[4], b.k[7] * d[5]};

        // yield: return to the surface of eq 14
        if (b.can_yield) {
            Lanes f[2];
            const Lanes shared = b.yield[2] * p[4] * p[4] + b.yield[3] * p[5] * p[5];
            for (int s = 0; s < section_count; ++s) {
                const Lanes mx = (section[s] - 1) / 2 * p[0] + (section[s] + 1) / 2 * p[1], my = (section[s] - 1) / 2 * p[2] + (section[s] + 1) / 2 * p[3];
                f[s] = b.yield[0] * mx * mx + b.yield[1] * my * my + shared;
            }
            if (beam::any_above(f[0], 1) || (section_count == 2 && beam::any_above(f[1], 1)))
                for (int i = 0; i < b.count; ++i) {
                    if (f[0][i] <= 1 && (section_count == 1 || f[1][i] <= 1)) continue;
                    const Element& e = structure_.elements()[b.element[i]];
                    const beam::Stiffness k = {b.k[0][i], b.k[1][i], b.k[2][i], b.k[3][i], b.k[4][i], b.k[5][i], b.k[6][i], b.k[7][i]};
                    Vec6 trial;
                    for (int c = 0; c < 6; ++c) trial[c] = p[c][i];
                    if (!trial.allFinite()) continue;  // the step names the culprit
                    found.yielding.push_back({b.element[i], beam::return_to_surface(trial, k, e.yield, section, section_count)});
                    for (int c = 0; c < 6; ++c) p[c][i] = found.yielding.back().flow.p[c];
                }
        }

        beam::NodalForces<Lanes> out = beam::nodal_forces(place, p);

        if constexpr (inertia) {
            const Lanes two = beam::spread(2.0, b.mass);
            const Triple<Lanes> a1 = gather(pose.acceleration, b.node[0], 0), a2 = gather(pose.acceleration, b.node[1], 0);
            out.force[0] = out.force[0] + b.mass * (two * a1 + a2);
            out.force[1] = out.force[1] + b.mass * (a1 + two * a2);
            const auto local = [&](const Triple<Lanes>& v) { return Triple<Lanes>{dot(place.frame.x, v), dot(place.frame.y, v), dot(place.frame.z, v)}; };
            const Lanes none = {};
            Triple<Lanes> w1 = {none, none, none}, w2 = w1;
            if constexpr (large) {
                w1 = local(gather(pose.velocity, b.node[0], 3));
                w2 = local(gather(pose.velocity, b.node[1], 3));
            }
            const Triple<Lanes> h1 = rotary_force(b.rotary, w1, local(gather(pose.acceleration, b.node[0], 3)));
            const Triple<Lanes> h2 = rotary_force(b.rotary, w2, local(gather(pose.acceleration, b.node[1], 3)));
            const auto space = [&](const Triple<Lanes>& v) { return v.x * place.frame.x + v.y * place.frame.y + v.z * place.frame.z; };
            const Triple<Lanes> g1 = space(h1), g2 = space(h2);
            out.moment[0] = out.moment[0] + two * g1 + g2;
            out.moment[1] = out.moment[1] + g1 + two * g2;
        }

        for (int i = 0; i < b.count; ++i) {
            for (int end = 0; end < 2; ++end) {
                Vec6& n = alone ? nodal[b.node[end][i]] : reach_[2 * b.element[i] + end];
                if (!alone) n.setZero();
                n[0] += out.force[end].x[i]; n[1] += out.force[end].y[i]; n[2] += out.force[end].z[i];
                n[3] += out.moment[end].x[i]; n[4] += out.moment[end].y[i]; n[5] += out.moment[end].z[i];
            }
            Vec6& q = force[b.element[i]];
            for (int c = 0; c < 6; ++c) q[c] = p[c][i];
            if (large && watching) {
                const auto& built = built_[b.element[i]];
                const Vec3 z(place.frame.z.x[i], place.frame.z.y[i], place.frame.z.z[i]), y(place.frame.y.x[i], place.frame.y.y[i], place.frame.y.z[i]);
                if ((z - built[0]).squaredNorm() + (y - built[1]).squaredNorm() > turn_limit_) found.turned.push_back(b.element[i]);
            }
        }
    }
}

/// Each node adds up what its elements left, in the order in which one thread would have.
void Sweep::add_up(const State& state, std::vector<Vec6>& nodal) {
    team_.share(int(nodal.size()), 8 * piece, [&](int first, int end, int) {
        for (int i = first; i < end; ++i)
            for (int e : structure_.elements_at()[i])
                if (!state.broken[e]) nodal[i] += reach_[2 * e + (structure_.elements()[e].node[0] == i ? 0 : 1)];
    });
}

void Sweep::run(const State& state, const Pose& pose, std::vector<Vec6>& nodal, std::vector<Vec6>& force, std::vector<Yielding>& yielding) {
    if (team_.threads() > 1) reach_.resize(2 * structure_.elements().size());
    found_.resize((blocks_.size() + piece - 1) / piece);
    team_.share(int(blocks_.size()), piece, [&](int first, int end, int i) {
        found_[i].yielding.clear();
        found_[i].turned.clear();
        if (structure_.large())
            inertia_ ? run_blocks<true, true>(first, end, state, pose, nodal, force, found_[i]) : run_blocks<true, false>(first, end, state, pose, nodal, force, found_[i]);
        else
            inertia_ ? run_blocks<false, true>(first, end, state, pose, nodal, force, found_[i]) : run_blocks<false, false>(first, end, state, pose, nodal, force, found_[i]);
    });
    if (!reach_.empty()) add_up(state, nodal);
    yielding.clear();
    turned_.clear();
    for (const Found& f : found_) {
        yielding.insert(yielding.end(), f.yielding.begin(), f.yielding.end());
        turned_.insert(turned_.end(), f.turned.begin(), f.turned.end());
    }
    for (const Block& b : blocks_) updates_ += b.count;
}

beam::Placement<double> place_element(const Structure& structure, int index, const Pose& pose) {
    const Element& e = structure.elements()[index];
    const auto quad = [](const Quat& q) { return Quadruple<double>{q.w(), q.x(), q.y(), q.z()}; };
    if (structure.large()) {
        const Vec3 chord = e.chord + (pose.displacement[e.node[1]] - pose.displacement[e.node[0]]);
        return beam::place<double>({chord.x(), chord.y(), chord.z()}, quad(pose.rotation[e.node[0]]), quad(pose.rotation[e.node[1]]), quad(e.axes));
    }
    return beam::place<double>({e.chord.x(), e.chord.y(), e.chord.z()}, {1, 0, 0, 0}, {1, 0, 0, 0}, quad(e.axes));
}

Vec6 element_deformation(const Structure& structure, int index, const Pose& pose) {
    Vec6 d;
    const Element& e = structure.elements()[index];
    if (structure.large()) {
        beam::deformation(place_element(structure, index, pose), e.length, d.data());
        return d;
    }
    const Mat3 axes = e.axes.toRotationMatrix().transpose();
    Vec12 u;
    u << axes * pose.displacement[e.node[0]], axes * pose.turn[e.node[0]], axes * pose.displacement[e.node[1]], axes * pose.turn[e.node[1]];
    return beam::linear_deformation(e.length) * u;
}

}  // namespace hinge

#include "effects/clamped_member.h"

#include <algorithm>
#include <cmath>

#include "beam/pair_bow.h"
#include "beam/tangent.h"
#include "state/hinges.h"

namespace hinge {
namespace {

/// The closed form of a Timoshenko beam that bends in one plane, shear flexibility phi = 12 EI/(GA L^2): where end 1 or
/// 2 alone rotates by one, the deflection over the length and the section's rotation at xi (0 to 1). By Betti's law
/// they are the fixed-end moments of a unit force or moment that acts there.
double deflection(int end, double xi, double phi) {
    const double bow = 0.5 * phi * (xi - xi * xi);
    return (end == 0 ? xi * (1 - xi) * (1 - xi) + bow : -xi * xi * (1 - xi) - bow) / (1 + phi);
}
double rotation(int end, double xi, double phi) {
    return (end == 0 ? (1 - xi) * (1 - 3 * xi + phi) : xi * (3 * xi - 2 + phi)) / (1 + phi);
}

/// Bending about x deflects along -y where it rotates, bending about y along x.
constexpr double sign[2] = {-1, 1};

}  // namespace

const double gauss_point[3] = {0.5 - 0.5 * std::sqrt(0.6), 0.5, 0.5 + 0.5 * std::sqrt(0.6)};
const double gauss_weight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};

std::vector<std::pair<int, int>> elements_of_members(const Structure& s) {
    std::vector<std::pair<int, int>> of(s.model().members().size());
    for (int i = 0; i < int(s.elements().size()); ++i) {
        auto& [first, end] = of[s.elements()[i].member];
        if (end == 0) first = i;
        end = i + 1;
    }
    return of;
}

ClampedMember::ClampedMember(const Structure& s, int first, int end) : n_(end - first) {
    const Element& e = s.elements()[first];
    length_ = n_ * e.length;
    phi_[0] = 12 * e.rigidity.EIx / (e.rigidity.GAy * length_ * length_);
    phi_[1] = 12 * e.rigidity.EIy / (e.rigidity.GAx * length_ * length_);
    if (n_ < 2) return;
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(6 * (n_ + 1), 6 * (n_ + 1));
    for (int i = 0; i < n_; ++i) {
        const Element& part = s.elements()[first + i];
        K.block<12, 12>(6 * i, 6 * i) += beam::linear_tangent(Mat3::Identity(), part.length, part.stiffness.matrix());
    }
    const int inner = 6 * (n_ - 1);
    Eigen::MatrixXd to_ends(inner, 12);
    to_ends << K.block(6, 0, inner, 6), K.block(6, 6 * n_, inner, 6);
    carried_ = -K.block(6, 6, inner, inner).ldlt().solve(to_ends);
}

double ClampedMember::of_force(int end, int plane, double xi) const {
    return sign[plane] * length_ * deflection(end, xi, phi_[plane]);
}
double ClampedMember::of_moment(int end, int plane, double xi) const { return rotation(end, xi, phi_[plane]); }

MemberEnds::Chord MemberEnds::chord(const Structure& s, const Pose& at) const {
    const Element &a = s.elements()[first], &b = s.elements()[first + count - 1];
    Vec3 span = double(count) * a.chord;
    if (!s.large()) return {a.axes.toRotationMatrix(), span};
    span += at.displacement[b.node[1]] - at.displacement[a.node[0]];
    const auto quad = [](const Quat& q) { return beam::Quadruple<double>{q.w(), q.x(), q.y(), q.z()}; };
    return {axes_of(beam::place<double>({span.x(), span.y(), span.z()}, quad(end_rotation(a, first, 0, at)),
                                        quad(end_rotation(b, first + count - 1, 1, at)), quad(a.axes))),
            span};
}

Mat3 MemberEnds::axes(const Structure& s, const Pose& at) const {
    const Element &a = s.elements()[first], &b = s.elements()[first + count - 1];
    if (!s.large()) return a.axes.toRotationMatrix();
    const Vec3 start = a.axes * Vec3::UnitY(),
               z = (double(count) * a.chord + at.displacement[b.node[1]] - at.displacement[a.node[0]]).normalized();
    Vec3 y = end_rotation(a, first, 0, at) * start + end_rotation(b, first + count - 1, 1, at) * start;
    y -= z.dot(y) * z;
    const double size = y.norm();
    if (!(size > 0.1)) return chord(s, at).axes;  // ends that point apart
    Mat3 axes;
    axes.col(1) = y / size, axes.col(2) = z, axes.col(0) = axes.col(1).cross(z);
    return axes;
}

void MemberEnds::add_section_forces(int element, int end, double length, const Vec3 m[2], SectionForces& forces) const {
    const Vec3 there = moment_at(element, end, m), sum = (m[0] + m[1]) / length;
    forces.Mx += there.x(), forces.My += there.y();
    forces.Qx += sum.y(), forces.Qy -= sum.x();
}

PressedPair::PressedPair(const Structure& s, int first, const std::vector<Vec6>& force, const ElementHeats& heat)
    : l_(0), p_{0, 0}, more_{0, 0} {
    const Element& e = s.elements()[first];
    if (!s.p_delta() || e.partner != first + 1 || first + 1 >= int(force.size()) || !e.forms_pairs) return;
    l_ = e.length;
    const double N = 0.5 * (force[first][4] + force[first + 1][4]) / heat_of(heat, first).stiffness;
    if (!std::isfinite(N)) return;  // a step that has failed
    const beam::PairKind<double> kind = pair_kind_of(e);
    for (int plane : {0, 1}) {
        p_[plane] = counted(beam::pressed_pair(kind, plane, -N));
        more_[plane] = kind.shear[plane].flexible * p_[plane];
    }
}

namespace {

/// (1 - A) / p, for A of beam/beam_column.h.
double fall_of_A(double p) {
    return p < beam::pair_least ? (1 - beam::stability_functions(p).A) / p : (231 - 6 * p) / (3465 + p * (p - 189));
}

}  // namespace

PairForces::PairForces() {
    for (int k = 0; k < terms; ++k) even[k].setZero(), odd[k].setZero(), side[k].setZero();
}

void PairForces::add(const Vec3& force, double x) {
    double power = 1;
    for (int k = 0; k < terms; ++k) {
        even[k] += power * force, odd[k] += power * x * force, side[k] += power * std::abs(x) * force;
        power *= x * x;
    }
}

double PressedPair::of_even(int plane, double q) const {
    const double p = p_[plane];
    if (p == 0) return 0;
    const double fall = fall_of_A(p) * p;  // 1 / A - 1 = fall / (1 - fall)
    const double by_shear = more_[plane] * (1 / (1 - fall) - 3 * beam::arm_of_pair);
    return sign[plane] * l_ * l_ / 3 * q * (fall / (1 - fall) + by_shear);
}

double PressedPair::of_spread(int end, int plane, const double (&q)[2]) const {
    const double p = p_[plane];
    if (p == 0) return 0;
    const double mean = 0.5 * (q[0] + q[1]), half = 0.5 * (q[1] - q[0]), even = of_even(plane, mean);
    return (end == 0 ? even : -even) - sign[plane] * l_ * l_ * half * (fall_of_A(p) - 1.0 / 15);
}

double PressedPair::of_force(int end, int plane, double x) const {
    const double p = p_[plane];
    if (p == 0) return 0;
    const double u = std::sqrt(std::abs(p));
    double symmetric, antisymmetric;
    if (p > 0) {
        symmetric = (std::cos(u * x) - std::cos(u)) / (u * std::sin(u));
        antisymmetric = (std::sin(u * x) - x * std::sin(u)) / (u * std::cos(u) - std::sin(u));
    } else {
        symmetric = (std::cosh(u) - std::cosh(u * x)) / (u * std::sinh(u));
        antisymmetric = (std::sinh(u * x) - x * std::sinh(u)) / (u * std::cosh(u) - std::sinh(u));
    }
    symmetric += more_[plane] * (symmetric - beam::arm_of_pair * 2 * (1 - std::abs(x))) - 0.5 * (1 - x * x);
    antisymmetric -= 0.5 * x * (x * x - 1);
    return sign[plane] * l_ * 0.5 * (end == 0 ? symmetric + antisymmetric : antisymmetric - symmetric);
}

void PressedPair::add_forces(int plane, const PairForces& of, const Vec3& across, double (&ends)[2],
                             double& middle) const {
    const double p = p_[plane];
    if (p == 0) return;
    // sums of f cos u x, of f sin(u x) / u and of f sin(u |x|) / u, with cosh and sinh in tension; cos u and sin(u) / u
    double cosine = 0, odd = 0, side = 0, C = 0, S = 0, even_part = 1, odd_part = 1;
    for (int k = 0; k < PairForces::terms; ++k) {
        cosine += even_part * across.dot(of.even[k]), C += even_part;
        odd += odd_part * across.dot(of.odd[k]), side += odd_part * across.dot(of.side[k]), S += odd_part;
        even_part *= -p / ((2 * k + 1) * (2 * k + 2)), odd_part *= -p / ((2 * k + 2) * (2 * k + 3));
    }
    const double all = across.dot(of.even[0]), first = across.dot(of.odd[0]), inward = all - across.dot(of.side[0]);
    double symmetric = (cosine - all * C) / (p * S), antisymmetric = (odd - first * S) / (C - S);
    const double bow = 0.5 * ((all - C * cosine - p * S * side + cosine - all * C) / (p * S) - inward);
    symmetric += more_[plane] * (symmetric - beam::arm_of_pair * 2 * inward) - 0.5 * (all - across.dot(of.even[1]));
    antisymmetric -= 0.5 * (across.dot(of.odd[1]) - first);
    ends[0] += sign[plane] * l_ * 0.5 * (symmetric + antisymmetric);
    ends[1] += sign[plane] * l_ * 0.5 * (antisymmetric - symmetric);
    middle -= sign[plane] * (1 + more_[plane]) * l_ * bow;
}

double PressedPair::of_couple(int end, int plane, double x) const {
    const double p = p_[plane];
    if (p == 0) return 0;
    const double u = std::sqrt(std::abs(p));
    const auto sine = [&](double z) { return p > 0 ? std::sin(u * z) : std::sinh(u * z); };
    const auto cosine = [&](double z) { return p > 0 ? std::cos(u * z) : std::cosh(u * z); };
    const double side = x > 0   ? 1
                        : x < 0 ? -1
                                : 0,
                 symmetric = x - sine(x) / sine(1) + more_[plane] * (2 * beam::arm_of_pair * side - sine(x) / sine(1)),
                 antisymmetric = (u * cosine(x) - sine(1)) / (u * cosine(1) - sine(1)) - 0.5 * (3 * x * x - 1);
    return 0.5 * (end == 0 ? symmetric + antisymmetric : antisymmetric - symmetric);
}

double PressedPair::middle_of_spread(int plane, double q) const {
    return p_[plane] == 0 ? 0 : -sign[plane] * (1 + more_[plane]) * q * l_ * l_ * beam::bow_of_even_load(p_[plane]);
}
double PressedPair::middle_of_force(int plane, double x) const {
    return p_[plane] == 0 ? 0 : -sign[plane] * (1 + more_[plane]) * l_ * beam::bow_of_force(p_[plane], x);
}
double PressedPair::middle_of_couple(int plane, double x) const {
    return p_[plane] == 0 ? 0 : -(1 + more_[plane]) * beam::bow_of_couple(p_[plane], x);
}

Vec3 direction_of(const Structure& s, int element, const Pose& at) {
    const Element& e = s.elements()[element];
    return (s.large() ? chord_of(e, at.displacement) : e.chord).normalized();
}

void add_share(double side, const Vec3& force, const Vec3& moment, SectionForces& forces) {
    forces.Qx -= side * force.x(), forces.Qy -= side * force.y(), forces.N -= side * force.z();
    forces.Mx -= side * moment.x(), forces.My -= side * moment.y(), forces.Mz -= side * moment.z();
}

}  // namespace hinge

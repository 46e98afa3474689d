#include "beam/potential_law.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace hinge::beam {
namespace {

constexpr double enough = 1e-12;       ///< of the trial forces: what a section's equilibrium may be off
constexpr double still_enough = 1e-9;  ///< where rounding leaves no more
constexpr int most_steps = 100, most_sweeps = 200;
constexpr double least_damping = 1e-13;  ///< of the elastic stiffness: N may flow at either end
constexpr double at_the_start = 1e-9;    ///< lambda over that of the flow found: a flow that begins (flowing_on)
constexpr double stiff = 1e6;            ///< over the elastic stiffness: the second derivatives of D where flow begins

using Rows = Eigen::Matrix<double, 4, 6>;

}  // namespace

/// A section that can flow, and how far it has.
struct PotentialLaw::End {
    double n1, n2;  ///< of the section's moments, from those at the element's ends
    Vec4 per;       ///< 1 over the strength
    Vec4 fixed;     ///< normalised fixed-end part
    Vec4 k;         ///< stiffness against its own flow
    Vec4 e = Vec4::Zero();

    End() = default;
    End(double r, const Vec4& per_strength, const Stiffness& of, const FixedEnd& fixed_end)
        : n1(-(1 - r) / 2), n2((1 + r) / 2), per(per_strength) {
        fixed = per.cwiseProduct(resultants(fixed_end.at(r), r));
        k << n1 * n1 * of.x11 + 2 * n1 * n2 * of.x12 + n2 * n2 * of.x22,
            n1 * n1 * of.y11 + 2 * n1 * n2 * of.y12 + n2 * n2 * of.y22, of.axial, of.twist;
        k = k.cwiseProduct(per.cwiseProduct(per));
        for (int c = 0; c < 4; ++c)
            if (per[c] == 0) k[c] = 1;
    }
    bool flows() const { return !e.isZero(0); }
    /// Normalised resultants, with the fixed-end part, of the element forces p.
    Vec4 carries(const Vec6& p) const {
        return per.cwiseProduct(Vec4(n1 * p[0] + n2 * p[1], n1 * p[2] + n2 * p[3], p[4], p[5])) + fixed;
    }
    Vec6 plastic() const {
        const Vec4 s = per.cwiseProduct(e);
        return (Vec6() << n1 * s[0], n2 * s[0], n1 * s[1], n2 * s[1], s[2], s[3]).finished();
    }
    Rows rows() const {
        Rows B = Rows::Zero();
        B(0, 0) = n1 * per[0], B(0, 1) = n2 * per[0], B(1, 2) = n1 * per[1], B(1, 3) = n2 * per[1];
        B(2, 4) = per[2], B(3, 5) = per[3];
        return B;
    }
};

PotentialLaw::PotentialLaw(const YieldSurface& screen, const Vec4& strength)
    : SectionLaw(screen), per_strength_(strength.cwiseInverse()) {}

/// The least of e.k e / 2 - trial.e + D(e); `e`: where the search starts, 0 if nothing is known. False: not found.
bool PotentialLaw::one_end(const Vec4& k, const Vec4& trial, Vec4& e) const {
    if (!e.isZero(0) && descend(k, trial, e) == Search::found) return true;
    e = direction(trial);
    if (descend(k, trial, e) == Search::found) return true;
    if (!outside(trial, e)) return e.setZero(), true;
    if (!e.allFinite()) return e.setZero(), false;
    const Search search = descend(k, trial, e);
    if (search == Search::not_below) e.setZero();  // on the surface, but for rounding
    if (search != Search::lost) return true;
    e = trial;
    return descend(k, trial, e) == Search::found;
}

/// Down from e. not_below: no flow along e has less than none.
PotentialLaw::Search PotentialLaw::descend(const Vec4& k, const Vec4& trial, Vec4& e) const {
    Vec4 q;
    Mat4 bend;
    // along a ray the least is known: t = (trial.e - D(e)) / (e.k e)
    const auto along_ray = [&](Vec4& v, double D, Mat4& curvature) {
        const double stiffness = v.dot(k.cwiseProduct(v)), t = (trial.dot(v) - D) / stiffness;
        if (!(t > 0)) return false;
        v *= t, curvature /= t;
        return true;
    };
    if (!along_ray(e, potential(e, q, bend), bend)) return Search::not_below;
    const double size = 1 + trial.norm();
    double G = 0.5 * e.dot(k.cwiseProduct(e)) - trial.dot(e) + q.dot(e), damping = 0;
    for (int i = 0; i < most_steps; ++i) {
        const Vec4 off = trial - k.cwiseProduct(e) - q;
        const double missed = off.norm();
        if (missed <= enough * size) return Search::found;
        bool fell = false;
        for (int tries = 0; tries < 40 && !fell; ++tries) {
            Mat4 H = bend;
            H.diagonal() += (1 + damping) * k;
            Vec4 next = e + H.llt().solve(off), there;
            Mat4 bent;
            if (!next.allFinite() || next.isZero(0)) break;
            const double D = potential(next, there, bent);
            along_ray(next, D, bent);
            const double G_next = 0.5 * next.dot(k.cwiseProduct(next)) - trial.dot(next) + there.dot(next),
                         left = (trial - k.cwiseProduct(next) - there).norm();
            if (G_next < G || (missed < 1e-4 * size && left < 0.95 * missed)) {
                fell = true, e = next, q = there, bend = bent, G = G_next;
                damping = damping < 1e-3 ? 0 : 0.1 * damping;
            } else {
                damping = damping == 0 ? 1e-2 : 8 * damping;
            }
        }
        if (!fell) return missed <= still_enough * size ? Search::found : Search::lost;
    }
    return Search::lost;
}

/// Both ends, from what one of them does by itself: each in turn, and Newton's method on both.
bool PotentialLaw::both_ends(const Vec6& trial, const Stiffness& k, End (&ends)[2]) const {
    const Mat6 stiffness = k.matrix();
    const auto forces = [&] { return Vec6(trial - k.times(ends[0].plastic() + ends[1].plastic())); };
    const double size = 1 + ends[0].carries(trial).norm() + ends[1].carries(trial).norm();
    Eigen::Matrix<double, 8, 8> K;
    for (int i : {0, 1})
        for (int j : {0, 1}) K.block<4, 4>(4 * i, 4 * j) = ends[i].rows() * stiffness * ends[j].rows().transpose();
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        for (int i : {1, 0}) {
            End& end = ends[i];
            if (!one_end(end.k, end.carries(trial - k.times(ends[1 - i].plastic())), end.e)) return false;
        }
        // of the other end, for that of the first has changed since
        Vec6 p = forces();
        Vec4 q[2];
        Mat4 bend[2];
        double G = 0, missed = 0;
        Eigen::Matrix<double, 8, 1> off;
        const auto look = [&] {
            const Vec6 plastic = ends[0].plastic() + ends[1].plastic();
            p = trial - k.times(plastic);
            G = 0.5 * plastic.dot(k.times(plastic)) - trial.dot(plastic);
            for (int i : {0, 1}) {
                const double D = potential(ends[i].e, q[i], bend[i]);
                G += D - ends[i].fixed.dot(ends[i].e);
                off.segment<4>(4 * i) = ends[i].carries(p) - q[i];
            }
            missed = off.norm();
        };
        if (!ends[0].flows() || !ends[1].flows()) {
            const int i = ends[0].flows() ? 0 : 1;
            Vec4 direction;
            if (!ends[i].flows()) return true;
            potential(ends[i].e, q[i], bend[i]);
            if ((ends[i].carries(p) - q[i]).norm() <= enough * size && !outside(ends[1 - i].carries(p), direction))
                return true;
            continue;
        }
        look();
        double damping = least_damping;
        for (int step = 0; step < most_steps && missed > enough * size; ++step) {
            const Vec4 before[2] = {ends[0].e, ends[1].e};
            const double G_before = G, missed_before = missed;
            Eigen::Matrix<double, 8, 8> H = K;
            for (int i : {0, 1}) H.block<4, 4>(4 * i, 4 * i) += bend[i];
            const Eigen::Matrix<double, 8, 1> down = off;
            bool fell = false;
            for (int tries = 0; tries < 12 && !fell; ++tries) {
                Eigen::Matrix<double, 8, 8> damped = H;
                damped.diagonal() += damping * K.diagonal();
                const Eigen::Matrix<double, 8, 1> way = damped.ldlt().solve(down);
                for (int i : {0, 1}) ends[i].e = before[i] + way.segment<4>(4 * i);
                if (way.allFinite() && ends[0].flows() && ends[1].flows()) {
                    look();
                    fell = G < G_before || (missed_before < 1e-4 * size && missed < 0.95 * missed_before);
                }
                damping = fell ? std::max(least_damping, 0.01 * damping) : 30 * damping;
            }
            if (!fell) {
                for (int i : {0, 1}) ends[i].e = before[i];
                look();
                break;
            }
        }
        if (missed <= enough * size || (sweep > 20 && missed <= still_enough * size)) return true;
    }
    return false;
}

ElementFlow PotentialLaw::find(const Vec6& trial, const Stiffness& k, const double* sections, int n,
                               const FixedEnd& fixed_end, const ElementFlow* before) const {
    ElementFlow out;
    out.p = trial;
    End ends[2];
    Vec4 trials[2];
    for (int i = 0; i < n; ++i) {
        ends[i] = End(sections[i], per_strength_, k, fixed_end);
        trials[i] = ends[i].carries(trial);
    }
    if (!trials[0].allFinite() || (n == 2 && !trials[1].allFinite())) return out.converged = false, out;
    const int first = n == 2 && trials[1].norm() > trials[0].norm() ? 1 : 0;
    const auto start = [&](int i) {
        if (before && before->lambda[i] > 0) ends[i].e = before->section[i].cwiseQuotient(per_strength_);
        for (int c = 0; c < 4; ++c)
            if (per_strength_[c] == 0) ends[i].e[c] = 0;
    };
    start(first);
    out.converged = one_end(ends[first].k, trials[first], ends[first].e);
    if (out.converged && n == 2) {
        End& other = ends[1 - first];
        Vec4 direction;
        if (outside(other.carries(trial - k.times(ends[first].plastic())), direction)) {
            start(1 - first);
            out.converged = both_ends(trial, k, ends);
        }
    }
    for (int i = 0; i < n; ++i) {
        if (!ends[i].flows()) continue;
        Vec4 q;
        Mat4 bend;
        out.plastic += ends[i].plastic();
        out.lambda[i] = 0.5 * potential(ends[i].e, q, bend);
        out.section[i] = per_strength_.cwiseProduct(ends[i].e);
    }
    if (out.flows()) out.p = trial - k.times(out.plastic);
    return out;
}

ElementFlow PotentialLaw::return_alone(const Vec6& trial, const Stiffness& k, const FixedEnd& fixed_end,
                                       const ElementFlow& before) const {
    constexpr double ends[2] = {-1, 1};
    return find(trial, k, ends, 2, fixed_end, &before);
}

ReturnMapResult PotentialLaw::return_to_surface(const Vec6& trial, const Stiffness& k, const double* sections, int n,
                                                const FixedEnd& fixed_end) const {
    ReturnMapResult out;
    static_cast<ElementFlow&>(out) = find(trial, k, sections, n, fixed_end, nullptr);
    out.dissipation = out.p.dot(out.plastic) + work_of(fixed_end, out, sections, n, fixed_end);
    return out;
}

double PotentialLaw::work_of(const FixedEnd& part, const ElementFlow& flow, const double* sections, int n,
                             const FixedEnd&) const {
    double work = 0;
    for (int i = 0; i < n; ++i)
        if (flow.lambda[i] > 0) work += resultants(part.at(sections[i]), sections[i]).dot(flow.section[i]);
    return work;
}

/// The second derivatives of D at the flow of a section; `stiffest`: the largest stiffness against it. False: none
/// flow.
bool PotentialLaw::curvature_of(const ElementFlow& flow, int section, double stiffest, Mat4& out) const {
    if (!(flow.lambda[section] > 0)) return false;
    Vec4 e = flow.section[section].cwiseQuotient(per_strength_), q;
    for (int c = 0; c < 4; ++c)
        if (per_strength_[c] == 0) e[c] = 0;
    const double found = 0.5 * potential(e, q, out), largest = out.cwiseAbs().maxCoeff();
    if (flow.lambda[section] < at_the_start * found && largest > 0) out *= std::max(1.0, stiff * stiffest / largest);
    return true;
}

namespace {

/// K - K B^T (B K B^T + D'')^-1 B K: the tangent where the n sections of B flow. Where N may flow at either of two
/// ends, the matrix in the middle is singular, and what is left of it is damped.
template <int n, int size>
Eigen::Matrix<double, size, size> reduced(const Eigen::Matrix<double, size, size>& K,
                                          const Eigen::Matrix<double, 16, size>& rows, const Mat4 (&bend)[4]) {
    constexpr int height = 4 * n;
    const Eigen::Matrix<double, height, size> BK = rows.template topRows<height>() * K;
    Eigen::Matrix<double, height, height> H = BK * rows.template topRows<height>().transpose();
    for (int i = 0; i < n; ++i) H.template block<4, 4>(4 * i, 4 * i) += bend[i];
    for (int i = 0; i < height; ++i) {
        if (H(i, i) == 0) H(i, i) = 1;  // of infinite strength
        else H(i, i) *= 1 + least_damping;
    }
    return K - BK.transpose() * H.ldlt().solve(BK);
}

template <int size>
Eigen::Matrix<double, size, size> reduced(int n, const Eigen::Matrix<double, size, size>& K,
                                          const Eigen::Matrix<double, 16, size>& rows, const Mat4 (&bend)[4]) {
    switch (n) {
        case 0: return K;
        case 1: return reduced<1>(K, rows, bend);
        case 2: return reduced<2>(K, rows, bend);
        case 3: return reduced<3>(K, rows, bend);
        default: return reduced<4>(K, rows, bend);
    }
}

}  // namespace

Mat6 PotentialLaw::tangent(const ElementFlow& flow, const Stiffness& k, const double* sections, int n,
                           const FixedEnd&) const {
    const Mat6 K = k.matrix();
    Eigen::Matrix<double, 16, 6> B;
    Mat4 bend[4];
    int count = 0;
    for (int i = 0; i < n; ++i) {
        const End end(sections[i], per_strength_, k, no_fixed_end);
        if (!curvature_of(flow, i, end.k.maxCoeff(), bend[count])) continue;
        B.middleRows<4>(4 * count++) = end.rows();
    }
    return reduced<6>(count, K, B, bend);
}

Mat12 PotentialLaw::pair_tangent(const Mat12& elastic, const ElementFlow* const (&flow)[2], const FixedEnd*) const {
    Eigen::Matrix<double, 16, 12> B;
    Mat4 bend[4];
    int count = 0;
    for (int i : {0, 1})
        for (int s = 0; flow[i] && s < 2; ++s) {
            const Rows own = End(s == 0 ? -1 : 1, per_strength_, {}, no_fixed_end).rows();
            const Mat6 K = elastic.block<6, 6>(6 * i, 6 * i);
            if (!curvature_of(*flow[i], s, (own * K * own.transpose()).diagonal().maxCoeff(), bend[count])) continue;
            B.middleRows<4>(4 * count).setZero();
            B.block<4, 6>(4 * count++, 6 * i) = own;
        }
    return reduced<12>(count, elastic, B, bend);
}

}  // namespace hinge::beam

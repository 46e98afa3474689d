#include "section/yield.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hinge::beam {

Mat6 yield_matrix(double r, const YieldSurface& w) {
    const double n1 = -(1 - r) / 2, n2 = (1 + r) / 2;
    Mat6 A = Mat6::Zero();
    A.block<2, 2>(0, 0) << w.x * n1 * n1, w.x * n1 * n2, w.x * n1 * n2, w.x * n2 * n2;
    A.block<2, 2>(2, 2) << w.y * n1 * n1, w.y * n1 * n2, w.y * n1 * n2, w.y * n2 * n2;
    A(4, 4) = w.n;
    A(5, 5) = w.z;
    return A;
}

namespace {

/// One section: in the section's own resultants the stiffness is diagonal, so the multiplier is the root of one convex,
/// falling function, and Newton from zero comes to it from one side.
double one_multiplier(const Vec6& trial, const Stiffness& k, double r, const YieldSurface& w) {
    const double n1 = -(1 - r) / 2, n2 = (1 + r) / 2;
    const double c[4] = {2 * w.x * (n1 * n1 * k.x11 + 2 * n1 * n2 * k.x12 + n2 * n2 * k.x22),
                         2 * w.y * (n1 * n1 * k.y11 + 2 * n1 * n2 * k.y12 + n2 * n2 * k.y22), 2 * w.n * k.axial,
                         2 * w.z * k.twist};
    const double mx = n1 * trial[0] + n2 * trial[1], my = n1 * trial[2] + n2 * trial[3];
    const double g[4] = {w.x * mx * mx, w.y * my * my, w.n * trial[4] * trial[4], w.z * trial[5] * trial[5]};
    double lambda = 0;
    for (int i = 0; i < 60; ++i) {
        double f = -1, slope = 0;
        for (int j = 0; j < 4; ++j) {
            const double a = 1 / (1 + lambda * c[j]), b = g[j] * a * a;
            f += b;
            slope -= 2 * c[j] * a * b;
        }
        if (f <= 4e-16 || slope == 0) break;
        const double next = lambda - f / slope;
        if (next == lambda) break;
        lambda = next;
    }
    return lambda;
}

/// F + 2 sum lambda A: what the forces' return to the surface adds to the flexibility.
Mat6 softened(const Mat6& F, const Mat6* A, const double* lambda, int n) {
    Mat6 S = F;
    for (int i = 0; i < n; ++i) S += 2 * lambda[i] * A[i];
    return S;
}

/// S^-1 d, decoupled into bending about x, about y, N and Mz.
Vec6 solve_in_blocks(const Mat6& S, const Vec6& d) {
    Vec6 p;
    p.segment<2>(0) = S.block<2, 2>(0, 0).inverse() * d.segment<2>(0);
    p.segment<2>(2) = S.block<2, 2>(2, 2).inverse() * d.segment<2>(2);
    p[4] = d[4] / S(4, 4);
    p[5] = d[5] / S(5, 5);
    return p;
}

/// p for given multipliers, s: the fixed-end part: (F + 2 sum lambda A) p = F trial - 2 sum lambda A s.
Vec6 relaxed(const Vec6& d_trial, const Mat6& F, const Mat6* A, const Vec6* s, const double* lambda, int n) {
    Vec6 right = d_trial;
    for (int i = 0; i < n; ++i) right -= 2 * lambda[i] * (A[i] * s[i]);
    return solve_in_blocks(softened(F, A, lambda, n), right);
}

constexpr double f_tolerance = 1e-8;  ///< of f; rounding leaves some 1e-11 after a trial of 1e4 times the strength

/// The multipliers of both ends at once. They maximise the concave dual
///   g(l) = min over p of (p - trial)^T F (p - trial) / 2 + sum l_i (f_i(p + s_i) - 1),  l >= 0,  dg/dl_i = f_i - 1.
class BothEnds {
public:
    BothEnds(const Vec6& trial, const Stiffness& k, const YieldSurface& w, const double* sections, const Vec6* s)
        : trial_(trial),
          F_(k.flexibility()),
          d_trial_(F_ * trial),
          A_{yield_matrix(sections[0], w), yield_matrix(sections[1], w)},
          s_(s) {
        const Vec6 apart = s[0] - s[1];
        feasible_ = w.n * apart[4] * apart[4] + w.z * apart[5] * apart[5] < 4;
    }

    /// From given multipliers. False: there is no answer, or none that rounding leaves within f_tolerance.
    bool solve(double* lambda) const {
        newton(lambda);
        if (off(lambda) <= f_tolerance) return true;
        // N and Mz are those of both ends but for loads between them: more than twice the strength, and no forces of
        // the element keep both ends within their surfaces
        if (!feasible_) return false;
        one_in_the_other(lambda);
        return off(lambda) <= f_tolerance;
    }

private:
    struct At {
        Vec6 p;
        double f[2], g;
    };
    At at(const double* l) const {
        At x;
        x.p = relaxed(d_trial_, F_, A_, s_, l, 2);
        const Vec6 away = x.p - trial_;
        x.g = 0.5 * away.dot(F_ * away);
        for (int i = 0; i < 2; ++i) {
            const Vec6 whole = x.p + s_[i];
            x.f[i] = whole.dot(A_[i] * whole) - 1, x.g += l[i] * x.f[i];
        }
        return x;
    }
    /// By how much the conditions l >= 0, f <= 0, l f = 0 are missed.
    double off(const double* l) const {
        const At x = at(l);
        double most = 0;
        for (int i = 0; i < 2; ++i) {
            const double miss = l[i] > 0 ? std::abs(x.f[i]) : x.f[i];
            if (!(miss <= most)) most = miss;  // one that is not a number stays
        }
        return most;
    }
    /// d f_i / d l_j, negative: h = { h00, h11, h01 } without the sign.
    void slopes(const double* lambda, const Vec6& p, double* h) const {
        const Mat6 S = softened(F_, A_, lambda, 2);
        Vec6 a[2], Sa[2];
        for (int i = 0; i < 2; ++i) {
            a[i] = 2 * A_[i] * (p + s_[i]);
            Sa[i] = solve_in_blocks(S, a[i]);
        }
        h[0] = a[0].dot(Sa[0]), h[1] = a[1].dot(Sa[1]), h[2] = a[0].dot(Sa[1]);
    }
    void newton(double* lambda) const;
    void one_in_the_other(double* lambda) const;

    Vec6 trial_;
    Mat6 F_;
    Vec6 d_trial_;
    Mat6 A_[2];
    const Vec6* s_;
    bool feasible_;
};

/// Newton's method on the multipliers that are free to move, each step shortened until g rises. Where one of them comes
/// to zero on the way, the step that is left need not raise g, and the method may stop short of the answer.
void BothEnds::newton(double* lambda) const {
    At now = at(lambda);
    for (int iteration = 0; iteration < 200; ++iteration) {
        const bool free[2] = {lambda[0] > 0 || now.f[0] > 0, lambda[1] > 0 || now.f[1] > 0};
        if ((!free[0] || std::abs(now.f[0]) < 1e-13) && (!free[1] || std::abs(now.f[1]) < 1e-13)) return;
        double h[3];
        slopes(lambda, now.p, h);
        const double h00 = h[0], h11 = h[1], h01 = h[2], det = h00 * h11 - h01 * h01;
        double step[2] = {0, 0};
        if (free[0] && free[1] && det > 1e-13 * h00 * h11) {
            step[0] = (h11 * now.f[0] - h01 * now.f[1]) / det;
            step[1] = (h00 * now.f[1] - h01 * now.f[0]) / det;
        } else {
            const int i = free[0] && (!free[1] || std::abs(now.f[0]) * h11 >= std::abs(now.f[1]) * h00) ? 0 : 1;
            step[i] = now.f[i] / (i == 0 ? h00 : h11);
        }
        bool rises = false;
        for (double share = 1; share > 1e-12 && !rises; share /= 2) {
            double next[2], slope = 0;
            for (int i = 0; i < 2; ++i)
                next[i] = std::max(0.0, lambda[i] + share * step[i]), slope += now.f[i] * (next[i] - lambda[i]);
            const At there = at(next);
            const auto off = [&](const At& x) {
                return std::max(free[0] ? std::abs(x.f[0]) : 0.0, free[1] ? std::abs(x.f[1]) : 0.0);
            };
            rises = (next[0] != lambda[0] || next[1] != lambda[1]) && slope >= 0 &&
                    (there.g >= now.g + 1e-4 * slope ||
                     (off(now) < 1e-3 && off(there) < 0.5 * off(now)));  // near the top g no longer tells
            if (rises) lambda[0] = next[0], lambda[1] = next[1], now = there;
        }
        if (!rises) return;
    }
}

/// The root of a falling function, F(l) = 1 from F(0) > 1, for F and its slope: Newton's method on 1 / sqrt(F), which
/// is a straight line for one resultant alone, within what is known to hold the root.
template <class Function>
double falling_root(Function F_and_slope, double start) {
    double low = 0, high = std::numeric_limits<double>::infinity(), l = start;
    for (int i = 0; i < 200; ++i) {
        const auto [F, slope] = F_and_slope(l);
        if (!std::isfinite(F) || std::abs(F - 1) < 1e-15) break;
        (F > 1 ? low : high) = l;
        double next = l + (1 - 1 / std::sqrt(F)) * 2 * F * std::sqrt(F) / -slope;
        if (!(next > low && next < high)) {
            if (std::isinf(high)) next = l > 0 ? 16 * l : 1;
            else next = low > 0 ? std::sqrt(low) * std::sqrt(high) : high / 16;
            if (!(next > low && next < high)) next = low + (high - low) / 2;
        }
        if (next == l || !(next > low && next < high)) break;
        l = next;
    }
    return l;
}

/// The multiplier of one end as the root of f there, with that of the other end found for each value: both functions
/// fall all the way, so that no step must be compared by g.
void BothEnds::one_in_the_other(double* lambda) const {
    const auto inner = [&](double l1) {
        const double none[2] = {0, l1};
        if (at(none).f[0] <= 0) return 0.0;
        return falling_root(
            [&](double l0) {
                const double l[2] = {l0, l1};
                const At x = at(l);
                double h[3];
                slopes(l, x.p, h);
                return std::pair(x.f[0] + 1, -h[0]);
            },
            0);
    };
    const auto outer = [&](double l1) {
        const double l[2] = {inner(l1), l1};
        const At x = at(l);
        double h[3];
        slopes(l, x.p, h);
        return std::pair(x.f[1] + 1, l[0] > 0 && h[0] > 0 ? h[2] * h[2] / h[0] - h[1] : -h[1]);
    };
    lambda[1] = outer(0).first <= 1 ? 0 : falling_root(outer, 0);
    lambda[0] = inner(lambda[1]);
}

}  // namespace

Vec6 yield_gradient(const Vec6& p, double r, const YieldSurface& w) {
    const double n1 = -(1 - r) / 2, n2 = (1 + r) / 2;
    const double mx = 2 * w.x * (n1 * p[0] + n2 * p[1]), my = 2 * w.y * (n1 * p[2] + n2 * p[3]);
    return (Vec6() << n1 * mx, n2 * mx, n1 * my, n2 * my, 2 * w.n * p[4], 2 * w.z * p[5]).finished();
}

ReturnMapResult return_to_surface(const Vec6& trial, const Stiffness& k, const YieldSurface& w, const double* sections,
                                  int n, const FixedEnd& fixed_end) {
    ReturnMapResult flow;
    flow.p = trial;
    Vec6 s[2];
    for (int i = 0; i < n; ++i) s[i] = fixed_end.at(sections[i]);
    const auto f_at = [&](const Vec6& p, int i) { return yield_function(Vec6(p + s[i]), sections[i], w); };
    int worst = 0;
    double f = f_at(trial, 0);
    for (int i = 1; i < n; ++i)
        if (const double other = f_at(trial, i); other > f) f = other, worst = i;
    if (f <= 1) return flow;  // eq 4; beyond it eq 10c
    flow.lambda[worst] = one_multiplier(trial + s[worst], k, sections[worst], w);
    const auto find_forces = [&] {
        Mat6 A[2];
        for (int i = 0; i < n; ++i) A[i] = yield_matrix(sections[i], w);
        const Mat6 F = k.flexibility();
        flow.p = relaxed(F * trial, F, A, s, flow.lambda, n);
    };
    find_forces();
    if (n == 2 && f_at(flow.p, 1 - worst) > 1 + 1e-13) {
        flow.converged = BothEnds(trial, k, w, sections, s).solve(flow.lambda);
        find_forces();
    } else {
        flow.converged = f_at(flow.p, worst) <= 1 + f_tolerance;
    }
    for (int i = 0; i < n; ++i)
        if (flow.lambda[i] > 0) flow.plastic += flow.lambda[i] * yield_gradient(flow.p + s[i], sections[i], w);
    flow.dissipation = flow.p.dot(flow.plastic) + work_of(fixed_end, flow, w, sections, n, fixed_end);
    return flow;
}

double work_of(const FixedEnd& part, const ElementFlow& flow, const YieldSurface& w, const double* sections, int n,
               const FixedEnd& fixed_end) {
    double work = 0;
    for (int i = 0; i < n; ++i) {
        if (!(flow.lambda[i] > 0)) continue;
        const Vec6 gradient = yield_gradient(flow.p + fixed_end.at(sections[i]), sections[i], w);
        work += flow.lambda[i] * part.at(sections[i]).dot(gradient);
    }
    return work;
}

Mat6 plastic_tangent(const Vec6& p, const Stiffness& k, const YieldSurface& w, const double* sections,
                     const double* lambda, const bool* active, int n, const FixedEnd& fixed_end) {
    Mat6 S = k.flexibility();
    Eigen::Matrix<double, 6, 2> a;
    int count = 0;
    for (int i = 0; i < n; ++i) {
        if (!active[i]) continue;
        S += 2 * lambda[i] * yield_matrix(sections[i], w);
        a.col(count++) = yield_gradient(p + fixed_end.at(sections[i]), sections[i], w);
    }
    // eq 10a: D_p = X - X a (a^T X a)^-1 a^T X
    Mat6 X = Mat6::Zero();  // S^-1: bending about x, about y, N and Mz do not mix
    X.block<2, 2>(0, 0) = S.block<2, 2>(0, 0).inverse();
    X.block<2, 2>(2, 2) = S.block<2, 2>(2, 2).inverse();
    X(4, 4) = 1 / S(4, 4);
    X(5, 5) = 1 / S(5, 5);
    if (count == 0) return X;
    const Eigen::Matrix<double, 6, 2> Xa = X * a;
    if (count == 2) {
        const Eigen::Matrix2d H = a.transpose() * Xa;
        if (H.determinant() > 1e-10 * H(0, 0) * H(1, 1)) return X - Xa * H.inverse() * Xa.transpose();
    }
    return X - Xa.col(0) * Xa.col(0).transpose() / a.col(0).dot(Xa.col(0));
}

}  // namespace hinge::beam

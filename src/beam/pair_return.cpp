#include "beam/pair_return.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace hinge::beam {
namespace {

constexpr double ends[2] = {-1, 1};
/// p up to which U counts as convex: S is 0.03 there, and 0 at 3.5.
constexpr double convex_up_to = 3.3;
constexpr int most_rounds = 12;     ///< of the convex case; they end after three to five
constexpr double slow = 0.5;        ///< a round that leaves more than this of the change before it is not convergence
constexpr int most_descents = 400;  ///< of the case that is not convex
/// Where F has fallen by less than this part of U(trial) in so many rounds, and a round changes little, its floor is
/// flat: flow that moves from one element to the other, or round a section alike in both planes, is worth no energy.
constexpr double flat_fall = 1e-5, flat_change = 1e-3;
constexpr int flat_rounds = 30;

/// The larger of p in the two planes at axial force N.
double pressed(const PairKind<double>& k, double N) { return -N * std::max(k.c[0], k.c[1]); }

/// One element's flow so far, in the numbers of its hinges.
struct Hinges {
    Vec6 p = Vec6::Zero();        ///< forces on the surface
    Vec6 plastic = Vec6::Zero();  ///< in d of timoshenko.h
    double lambda[2] = {0, 0};    ///< as ReturnMapResult::lambda
    bool converged = true;
};

/// The multiplier at one end, where the others do not flow: the root of a convex, falling function of lambda. Newton's
/// method comes to it from the left, from any start.
///   c  what lambda takes off each resultant, relative to it;  g  the parts of f_y at lambda = 0
double multiplier(const double (&c)[4], const double (&g)[4], double lambda) {
    for (int i = 0; i < 60; ++i) {
        double f = -1, slope = 0;
        for (int j = 0; j < 4; ++j) {
            const double a = 1 / (1 + lambda * c[j]), b = g[j] * a * a;
            f += b;
            slope -= 2 * c[j] * a * b;
        }
        if (std::abs(f) <= 1e-13 || slope == 0) break;
        lambda = std::max(0.0, lambda - f / slope);
    }
    return lambda;
}

/// f_y at end j of the forces p.
double f_y(const Vec6& p, int j, const YieldSurface& w, const FixedEnd& fixed) {
    const double mx = p[j] + fixed.moment[j], my = p[2 + j] + fixed.moment[2 + j], n = p[4] + fixed.N[j],
                 mz = p[5] + fixed.Mz[j];
    return w.x * mx * mx + w.y * my * my + w.n * n * n + w.z * mz * mz;
}

/// The point of one element's surface nearest to `trial` in the energy norm of `k`; `before`: where the multipliers
/// start from.
Hinges return_alone(const Vec6& trial, const Stiffness& k, const YieldSurface& w, const FixedEnd& fixed,
                    const Hinges& before) {
    Hinges out;
    out.p = trial;
    const double f[2] = {f_y(trial, 0, w, fixed), f_y(trial, 1, w, fixed)};
    const int j = f[1] > f[0] ? 1 : 0;
    if (!(f[j] > 1)) return out;
    const double kx = j == 0 ? k.x11 : k.x22, ky = j == 0 ? k.y11 : k.y22;
    const double c[4] = {2 * w.x * kx, 2 * w.y * ky, 2 * w.n * k.axial, 2 * w.z * k.twist};
    double r[4] = {trial[j] + fixed.moment[j], trial[2 + j] + fixed.moment[2 + j], trial[4] + fixed.N[j],
                   trial[5] + fixed.Mz[j]};
    const double g[4] = {w.x * r[0] * r[0], w.y * r[1] * r[1], w.n * r[2] * r[2], w.z * r[3] * r[3]};
    const double lambda = multiplier(c, g, before.lambda[1 - j] == 0 ? before.lambda[j] : 0);
    for (int i = 0; i < 4; ++i) r[i] /= 1 + lambda * c[i];
    const double rate[4] = {2 * lambda * w.x * r[0], 2 * lambda * w.y * r[1], 2 * lambda * w.n * r[2],
                            2 * lambda * w.z * r[3]};
    out.plastic[j] = rate[0], out.plastic[2 + j] = rate[1], out.plastic[4] = rate[2], out.plastic[5] = rate[3];
    out.p -= k.times(out.plastic);
    out.lambda[j] = lambda;
    if (f_y(out.p, 1 - j, w, fixed) <= 1 + 1e-13) return out;
    const ReturnMapResult both = return_to_surface(trial, k, w, ends, 2, fixed);
    out.p = both.p, out.plastic = both.plastic, out.converged = both.converged;
    out.lambda[0] = both.lambda[0], out.lambda[1] = both.lambda[1];
    return out;
}

/// A pair whose return is looked for.
class PairReturn {
public:
    PairReturn(const PairKind<double>& k, const Stiffness (&of)[2], const Vec6 (&d)[2],
               const YieldSurface* const (&w)[2], const FixedEnd* fixed, double tolerance)
        : k_(k), of_(of), d_(d), w_(w), fixed_(fixed), tolerance_(tolerance) {}

    bool find(ReturnMapResult (&flow)[2]) {
        At now = at(no_flow_, no_flow_);
        const double trial = pressed(k_, now.N);
        bool converged = false, convex = trial <= convex_up_to;
        At end = now;
        if (convex) {
            converged = go_rounds(end);
            convex = pressed(k_, end.N) <= convex_up_to;
        }
        double snapped = 0;
        if (!convex || !converged) {
            end = now;
            converged = descend(end);
            snapped = lost_by_snap(now, end);
        }
        for (int i : {0, 1}) {
            ReturnMapResult& f = flow[i];
            f.p = end.p[i], f.plastic = end.of[i].plastic, f.elastic = d_[i] - f.plastic;
            f.converged = converged;
            for (int j : {0, 1}) f.lambda[j] = end.of[i].lambda[j];
            f.dissipation = f.p.dot(f.plastic) + fixed_work(i, end.of[i]);
        }
        const int flows = flow[0].flows() ? 0 : 1;
        if (flow[flows].flows()) flow[flows].dissipation += snapped;
        return converged;
    }

private:
    struct At {
        Hinges of[2];
        Vec6 p[2];  ///< dU/dd at d - plastic
        double N;
    };

    At at(const Hinges& one, const Hinges& two) const {
        At a{{one, two}, {}, 0};
        const Vec6 elastic[2] = {d_[0] - one.plastic, d_[1] - two.plastic};
        const Vec12 beyond = pair_forces(k_, elastic[0], elastic[1], &a.N);
        for (int i : {0, 1}) a.p[i] = of_[i].times(elastic[i]) + beyond.segment<6>(6 * i);
        return a;
    }
    double energy(const At& a) const {
        const Vec6 elastic[2] = {d_[0] - a.of[0].plastic, d_[1] - a.of[1].plastic};
        return pair_energy(k_, elastic[0], elastic[1]) + 0.5 * elastic[0].dot(of_[0].times(elastic[0])) +
               0.5 * elastic[1].dot(of_[1].times(elastic[1]));
    }
    /// D(x), less what the fixed-end parts do.
    static double dissipation(const At& a) { return a.of[0].p.dot(a.of[0].plastic) + a.of[1].p.dot(a.of[1].plastic); }
    static double work(const At& a) { return a.p[0].dot(a.of[0].plastic) + a.p[1].dot(a.of[1].plastic); }
    /// What U loses beyond the work of the flow, J: 0 where the forces fall to the surface along a straight line, as
    /// they do in short steps. There the steps' own rule counts that work rightly.
    double lost_by_snap(const At& trial, const At& end) const {
        constexpr double straight = 0.25;
        const double lost = energy(trial) - energy(end) - work(end);
        double by_line = 0;
        for (int i : {0, 1}) by_line += 0.5 * (trial.p[i] - end.p[i]).dot(end.of[i].plastic);
        return lost > by_line + straight * std::abs(by_line) ? lost : 0;
    }
    double fixed_work(int i, const Hinges& h) const {
        if (!(h.lambda[0] > 0) && !(h.lambda[1] > 0)) return 0;
        ReturnMapResult flow;
        flow.p = h.p, flow.lambda[0] = h.lambda[0], flow.lambda[1] = h.lambda[1];
        return work_of(fixed_[i], flow, *w_[i], ends, 2, fixed_[i]);
    }

    /// What a pair's element has of the pair's bending stiffness, without its partner's part in it.
    void own_stiffness(double N, Stiffness (&out)[2]) const {
        for (int i : {0, 1}) out[i] = of_[i];
        for (int plane : {0, 1}) {
            const StabilityFunctions<double> at = stability_functions(-k_.c[plane] * N);
            const double more = k_.b[plane] * (std::max(0.1, 0.5 * (at.S + at.A)) - 1);
            for (int i : {0, 1}) add_bending(out[i], plane, more);
        }
    }
    static void add_bending(Stiffness& k, int plane, double more) {
        (plane == 0 ? k.x11 : k.y11) += more;
        (plane == 0 ? k.x12 : k.y12) -= more;
        (plane == 0 ? k.x22 : k.y22) += more;
    }

    /// The size of a change of both plastic deformations against the elastic ones, in the energy norm of `k`.
    double size(const At& a, const At& b, const Stiffness (&k)[2]) const {
        double change = 0, whole = 0;
        for (int i : {0, 1}) {
            const Vec6 off = b.of[i].plastic - a.of[i].plastic, elastic = d_[i] - b.of[i].plastic;
            change += off.dot(k[i].times(off));
            whole += elastic.dot(k[i].times(elastic));
        }
        return std::sqrt(change / whole);
    }

    At round(const At& from, const Stiffness (&k)[2]) const {
        Hinges next[2];
        for (int i : {0, 1})
            next[i] = return_alone(from.p[i] + k[i].times(from.of[i].plastic), k[i], *w_[i], fixed_[i], from.of[i]);
        return at(next[0], next[1]);
    }

    /// The convex case. False: it has not converged.
    bool go_rounds(At& now) const {
        Stiffness k[2];
        own_stiffness(now.N, k);
        double last = std::numeric_limits<double>::infinity();
        for (int i = 0; i < most_rounds; ++i) {
            const At next = round(now, k);
            const double change = size(now, next, k);
            now = next;
            if (!now.of[0].converged || !now.of[1].converged) return false;
            if (change <= tolerance_) return true;
            if (i > 0 && !(change < slow * last)) return false;
            last = change;
        }
        return false;
    }

    /// Stiffnesses of the two elements that no change of the pair's deformation exceeds by much: what couples N with
    /// the bending of both (N = EA/l (e + bow)) is shared out between them. `firmer`: 1, and more where that is not
    /// enough.
    void stiffness_above(const At& a, double firmer, Stiffness (&out)[2]) const {
        double bow[2][2], together = 0, least = std::numeric_limits<double>::infinity(), flexible = 1, most[2];
        const PairShapeNumbers y = shape_of(d_[0] - a.of[0].plastic, d_[1] - a.of[1].plastic);
        for (int plane : {0, 1}) {
            const StabilityFunctions<double> at = stability_functions(-k_.c[plane] * a.N);
            const double sum = at.S1 * y.sum[plane], difference = at.A1 * y.difference[plane];
            bow[plane][0] = 0.25 * k_.length * std::abs(sum + difference);  // d(bow)/d(kappa)
            bow[plane][1] = 0.25 * k_.length * std::abs(sum - difference);
            together += bow[plane][0] + bow[plane][1];
            flexible -= 0.125 * k_.axial * k_.length * k_.c[plane] *
                        (at.S2 * y.sum[plane] * y.sum[plane] + at.A2 * y.difference[plane] * y.difference[plane]);
            most[plane] = std::max(0.1, std::max(at.S, at.A));
            least = std::min(least, k_.b[plane] * most[plane]);
        }
        const double axial = 2 * k_.axial / flexible, share = std::min(1.0, std::sqrt(axial / least) * together);
        for (int i : {0, 1}) {
            out[i] = of_[i];
            out[i].axial *= firmer * (1 + share);
            for (int plane : {0, 1}) {
                const double coupled = share > 0 ? axial * (1 + 1 / share) * bow[plane][i] * together : 0;
                add_bending(out[i], plane, k_.b[plane] * (firmer * most[plane] - 1) + firmer * coupled);
            }
        }
    }

    /// The case that is not convex: F falls from step to step. False: it has not converged.
    bool descend(At& now) const {
        double F = energy(now), firmer = 1, stretch = 1, fell = 0, marked = F, changed = 0;
        const double scale = std::max(std::abs(F), std::numeric_limits<double>::min());
        for (int i = 0; i < most_descents; ++i) {
            if (i > 0 && i % flat_rounds == 0) {
                if (marked - F <= flat_fall * scale && changed <= flat_change) return true;
                marked = F;
            }
            Stiffness k[2];
            At next;
            double change = 0, there = 0;
            for (;; firmer *= 2) {
                if (firmer > 1e12) return i > 0 && fell <= flat_fall * scale;  // rounding hides what F still falls by
                stiffness_above(now, firmer, k);
                next = round(now, k);
                if (!next.of[0].converged || !next.of[1].converged) return false;
                change = size(now, next, k);
                there = energy(next) + dissipation(next);
                if (there <= F + 1e-13 * scale) break;
            }
            if (firmer * change <= tolerance_) return now = next, true;
            if (i > 2 && i % 3 == 0) {
                const At jump = newton(now, next, k);
                const double F_jump = energy(jump) + dissipation(jump);
                if (F_jump <= there) next = jump, there = F_jump;
            }
            if (i > 2 && i % 3 == 1) {
                const At jump = farther(now, next, stretch, k);
                const double F_jump = energy(jump) + dissipation(jump);
                stretch = F_jump < there ? 4 * stretch : std::max(1.0, 0.25 * stretch);
                if (F_jump < there) next = jump, there = F_jump;
            }
            fell = F - there, changed = firmer * change;
            now = next, F = there;
            firmer = std::max(1.0, 0.7 * firmer);
        }
        return false;
    }

    /// A round from farther on in the direction of the last one: where U is nearly flat, as where flow moves from one
    /// element to the other, rounds creep.
    At farther(const At& now, const At& next, double times, const Stiffness (&k)[2]) const {
        At from = next;
        for (int i : {0, 1}) from.of[i].plastic += times * (next.of[i].plastic - now.of[i].plastic);
        return round(at(from.of[0], from.of[1]), k);
    }

    /// Newton's method for x = round(x), and a round from where it leads.
    At newton(const At& now, const At& next, const Stiffness (&k)[2]) const {
        // d(next)/d(now) = k^-1 (1 - D k^-1) (k - H);  H: stiffness of the pair, D: tangents of the elements by
        // themselves
        PairMatrix H = pair_stiffness(k_, d_[0] - now.of[0].plastic, d_[1] - now.of[1].plastic);
        for (int i : {0, 1}) H.block<6, 6>(6 * i, 6 * i) += of_[i].matrix() - k[i].matrix();
        PairMatrix J = PairMatrix::Identity();
        Vec12 off;
        for (int i : {0, 1}) {
            off.segment<6>(6 * i) = next.of[i].plastic - now.of[i].plastic;
            const double* lambda = next.of[i].lambda;
            const bool active[2] = {lambda[0] > 0, lambda[1] > 0};
            if (!active[0] && !active[1]) continue;
            const Mat6 F = k[i].flexibility(),
                       D = plastic_tangent(next.of[i].p, k[i], *w_[i], ends, lambda, active, 2, fixed_[i]);
            J.block<6, 12>(6 * i, 0) += (F - F * D * F) * H.block<6, 12>(6 * i, 0);
        }
        const Vec12 step = J.partialPivLu().solve(off);
        At from = now;
        if (step.allFinite())
            for (int i : {0, 1}) from.of[i].plastic += step.segment<6>(6 * i);
        return round(at(from.of[0], from.of[1]), k);
    }

    const PairKind<double>& k_;
    const Stiffness (&of_)[2];
    const Vec6 (&d_)[2];
    const YieldSurface* const (&w_)[2];
    const FixedEnd* fixed_;
    double tolerance_;
    inline static const Hinges no_flow_{};
};

}  // namespace

bool return_to_surface(const PairKind<double>& k, const Stiffness (&of)[2], const Vec6 (&d)[2],
                       const YieldSurface* const (&w)[2], ReturnMapResult (&flow)[2], double tolerance,
                       const FixedEnd* fixed_end) {
    return PairReturn(k, of, d, w, fixed_end, tolerance).find(flow);
}

PairMatrix pair_tangent(const PairKind<double>& k, const Stiffness (&of)[2], const Vec6 (&elastic)[2],
                        const YieldSurface* const (&w)[2], const ReturnMapResult* const (&flow)[2],
                        const FixedEnd* fixed_end) {
    PairMatrix H = pair_stiffness(k, elastic[0], elastic[1]);
    for (int i : {0, 1}) H.block<6, 6>(6 * i, 6 * i) += of[i].matrix();
    if (!flow[0] && !flow[1]) return H;
    PairMatrix F = H.inverse();
    Eigen::Matrix<double, 12, Eigen::Dynamic, 0, 12, 4> a(12, 0);
    for (int i : {0, 1})
        for (int s = 0; flow[i] && s < 2; ++s) {
            if (!(flow[i]->lambda[s] > 0)) continue;
            F.block<6, 6>(6 * i, 6 * i) += 2 * flow[i]->lambda[s] * yield_matrix(ends[s], *w[i]);
            a.conservativeResize(12, a.cols() + 1);
            a.rightCols<1>().setZero();
            a.rightCols<1>().segment<6>(6 * i) = yield_gradient(flow[i]->p + fixed_end[i].at(ends[s]), ends[s], *w[i]);
        }
    const PairMatrix X = F.inverse();  // eq 10a, of the pair
    if (a.cols() == 0) return X;
    const Eigen::Matrix<double, 12, Eigen::Dynamic, 0, 12, 4> Xa = X * a;
    const Eigen::MatrixXd h = a.transpose() * Xa;
    return X - Xa * h.completeOrthogonalDecomposition().pseudoInverse() * Xa.transpose();
}

}  // namespace hinge::beam

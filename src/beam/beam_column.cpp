#include "beam/beam_column.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <limits>

namespace hinge::beam {
namespace {

/// What a pair's energy beyond its elements' depends on: mean extension, and for each plane sum and difference of what
/// the two elements bend by.
using Modes = Eigen::Matrix<double, 5, 1>;

Eigen::Matrix<double, 5, 12> to_modes() {
    Eigen::Matrix<double, 5, 12> G = Eigen::Matrix<double, 5, 12>::Zero();
    G(0, 4) = G(0, 10) = 0.5;
    for (int plane : {0, 1})
        for (int element : {0, 1})
            for (int end : {0, 1}) {
                const int column = 6 * element + 2 * plane + end, sign = end == 0 ? -1 : 1;
                G(1 + 2 * plane, column) = sign;
                G(2 + 2 * plane, column) = element == 0 ? sign : -sign;
            }
    return G;
}

Modes modes_of(const Vec6& d1, const Vec6& d2) {
    Modes y;
    y[0] = 0.5 * (d1[4] + d2[4]);
    for (int plane : {0, 1}) {
        const double kappa1 = d1[2 * plane + 1] - d1[2 * plane], kappa2 = d2[2 * plane + 1] - d2[2 * plane];
        y[1 + 2 * plane] = kappa1 + kappa2;
        y[2 + 2 * plane] = kappa1 - kappa2;
    }
    return y;
}

PairForces<double> forces_of(const PairKind<double>& k, const Modes& y) {
    const double sum[2] = {y[1], y[3]}, difference[2] = {y[2], y[4]};
    return pair_forces<double>(k, y[0], sum, difference);
}

/// In the places of the two elements' p.
Vec12 on_both(const PairForces<double>& f) {
    Vec12 p = Vec12::Zero();
    p[4] = p[10] = f.N;
    for (int plane : {0, 1}) {
        const double second = 2 * f.symmetric[plane] - f.moment[plane];
        p[2 * plane] = -f.moment[plane], p[2 * plane + 1] = f.moment[plane];
        p[6 + 2 * plane] = -second, p[7 + 2 * plane] = second;
    }
    return p;
}

}  // namespace

PairKind<double> pair_kind(const Rigidity& c, double L) {
    return {c.EA / L, L, {c.EIx / L, c.EIy / L}, {L * L / c.EIx, L * L / c.EIy}};
}

double pair_energy(const PairKind<double>& k, const Vec6& d1, const Vec6& d2) {
    const Modes y = modes_of(d1, d2);
    const double N = forces_of(k, y).N_whole, off = N - k.axial * y[0];
    double U = -off * off / k.axial;  // 2 N e - N^2 l/EA - e^2 EA/l
    for (int plane : {0, 1}) {
        const PairNumbers<double> of = pair_numbers(-k.c[plane] * N);
        const double sum = y[1 + 2 * plane], difference = y[2 + 2 * plane];
        U += 0.25 * k.b[plane] * ((of.S - 1) * sum * sum + (of.A - 1) * difference * difference);
    }
    return U;
}

Vec12 pair_forces(const PairKind<double>& k, const Vec6& d1, const Vec6& d2) {
    return on_both(forces_of(k, modes_of(d1, d2)));
}

PairMatrix pair_stiffness(const PairKind<double>& k, const Vec6& d1, const Vec6& d2) {
    const Modes y = modes_of(d1, d2);
    const double N = forces_of(k, y).N_whole;
    Eigen::Matrix<double, 5, 5> H = Eigen::Matrix<double, 5, 5>::Zero();
    Modes with_N = Modes::Zero();  // d2/dN dy
    with_N[0] = 2;
    double N_N = -2 / k.axial;
    for (int plane : {0, 1}) {
        const PairNumbers<double> of = pair_numbers(-k.c[plane] * N);
        const double b = k.b[plane], c = k.c[plane], sum = y[1 + 2 * plane], difference = y[2 + 2 * plane];
        H(1 + 2 * plane, 1 + 2 * plane) = 0.5 * b * (of.S - 1);
        H(2 + 2 * plane, 2 + 2 * plane) = 0.5 * b * (of.A - 1);
        with_N[1 + 2 * plane] = -0.5 * b * c * of.S1 * sum;
        with_N[2 + 2 * plane] = -0.5 * b * c * of.A1 * difference;
        N_N += 0.25 * b * c * c * (of.S2 * sum * sum + of.A2 * difference * difference);
    }
    H -= with_N * with_N.transpose() / N_N;
    H(0, 0) -= 2 * k.axial;
    static const Eigen::Matrix<double, 5, 12> G = to_modes();
    return G.transpose() * H * G;
}

namespace {

/// Stiffnesses of the two elements by themselves that no change of the pair's deformation exceeds by much: what couples
/// N with the bending of both (N = EA/l (e + bow)) is shared out between them.
void no_softer(const PairKind<double>& k, const Modes& y, double N, const Stiffness (&of)[2], Stiffness (&out)[2]) {
    double bow[2][2], together = 0, least = std::numeric_limits<double>::infinity(), flexible = 1, most[2];
    for (int plane : {0, 1}) {
        const PairNumbers<double> at = pair_numbers(-k.c[plane] * N);
        const double sum = at.S1 * y[1 + 2 * plane], difference = at.A1 * y[2 + 2 * plane];
        bow[plane][0] = 0.25 * k.length * std::abs(sum + difference);  // d(bow)/d(kappa)
        bow[plane][1] = 0.25 * k.length * std::abs(sum - difference);
        together += bow[plane][0] + bow[plane][1];
        flexible -= 0.125 * k.axial * k.length * k.c[plane] *
                    (at.S2 * y[1 + 2 * plane] * y[1 + 2 * plane] + at.A2 * y[2 + 2 * plane] * y[2 + 2 * plane]);
        most[plane] = std::max(0.1, std::max(at.S, at.A));
        least = std::min(least, k.b[plane] * most[plane]);
    }
    const double axial = 2 * k.axial / flexible, share = std::min(1.0, std::sqrt(axial / least) * together);
    for (int i : {0, 1}) {
        out[i] = of[i];
        out[i].axial *= 1 + share;
        for (int plane : {0, 1}) {
            const double coupled = share > 0 ? axial * (1 + 1 / share) * bow[plane][i] * together : 0;
            const double more = k.b[plane] * (most[plane] - 1) + coupled;
            (plane == 0 ? out[i].x11 : out[i].y11) += more;
            (plane == 0 ? out[i].x12 : out[i].y12) -= more;
            (plane == 0 ? out[i].x22 : out[i].y22) += more;
        }
    }
}

}  // namespace

void return_to_surface(const PairKind<double>& k, const Stiffness (&of)[2], const Vec6 (&d)[2],
                       const YieldSurface* const (&w)[2], const double* sections, int n, Flow (&flow)[2],
                       double tolerance, const FixedEnd* fixed_end) {
    // In rounds: each element returns by itself, from the forces that the elastic deformations of the round before give
    // the pair. Far beyond the surface they begin where the elements would be without their partner. Where rounds are
    // slow (slender elements, bent far), Newton's method goes on.
    constexpr double far = 4, near = 0.9, slow = 0.3;
    Stiffness alone[2];
    const auto f_y = [&](const Vec6& p, int i, int s) {
        return yield_function(Vec6(p + fixed_end[i].at(sections[s])), sections[s], *w[i]);
    };
    struct Trial {
        Vec6 elastic[2], p[2], off[2];  ///< `off`: what the return leaves less `elastic`
        Flow flow[2];
        double size;  ///< of `off`, against the elastic deformation, in the energy norm
    };
    bool flows[2] = {true, true};
    const auto forces = [&](Trial& t) {
        const PairForces<double> now = forces_of(k, modes_of(t.elastic[0], t.elastic[1]));
        const Vec12 beyond = on_both(now);
        for (int i : {0, 1}) t.p[i] = of[i].times(t.elastic[i]) + beyond.segment<6>(6 * i);
        return now.N_whole;
    };
    const auto go_round = [&](Trial& t) {
        double change = 0, whole = 0;
        for (int i : {0, 1}) {
            if (flows[i]) {
                t.flow[i] = return_to_surface(t.p[i] + alone[i].times(d[i] - t.elastic[i]), alone[i], *w[i], sections,
                                              n, fixed_end[i]);
            } else {
                t.flow[i] = {};
                t.flow[i].p = t.p[i];
            }
            t.off[i] = d[i] - t.flow[i].plastic - t.elastic[i];
            change += t.off[i].dot(alone[i].times(t.off[i]));
            whole += t.elastic[i].dot(alone[i].times(t.elastic[i]));
        }
        t.size = std::sqrt(change / whole);
    };
    Trial now{{d[0], d[1]}, {}, {}, {}, 0};
    double N = forces(now), worst = 0;
    for (int i : {0, 1}) {
        double f = 0;
        for (int s = 0; s < n; ++s) f = std::max(f, f_y(now.p[i], i, s));
        flows[i] = !(f <= near);  // an element that is nowhere near its surface keeps its deformation
        worst = f <= worst ? worst : f;
    }
    if (!(worst < far)) {
        flows[0] = flows[1] = true;
        for (int i : {0, 1})
            now.elastic[i] =
                d[i] - return_to_surface(of[i].times(d[i]), of[i], *w[i], sections, n, fixed_end[i]).plastic;
        N = forces(now);
    }
    no_softer(k, modes_of(now.elastic[0], now.elastic[1]), N, of, alone);
    go_round(now);
    double last = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 100; ++round) {
        if (now.size <= tolerance) {
            bool more = false;  // a partner that turned out to flow as well
            for (int i : {0, 1})
                for (int s = 0; s < n && !flows[i]; ++s)
                    if (f_y(now.p[i], i, s) > 1) flows[i] = more = true;
            if (!more) break;
        }
        Vec12 step;
        step << now.off[0], now.off[1];
        if (round > 2 && now.size > slow * last) {
            // d(off)/d(elastic) = -k^-1 (1 - D k^-1) (H - k) - 1, k: of the elements alone, D: their tangents
            PairMatrix H = pair_stiffness(k, now.elastic[0], now.elastic[1]), J = -PairMatrix::Identity();
            for (int i : {0, 1}) H.block<6, 6>(6 * i, 6 * i) += of[i].matrix() - alone[i].matrix();
            for (int i : {0, 1}) {
                const bool active[2] = {now.flow[i].lambda[0] > 0, now.flow[i].lambda[1] > 0};
                if (!active[0] && !active[1]) continue;
                const Mat6 F = alone[i].matrix().inverse(),
                           D = plastic_tangent(now.flow[i].p, alone[i], *w[i], sections, now.flow[i].lambda, active, n,
                                               fixed_end[i]);
                J.block<6, 12>(6 * i, 0) -= (F - F * D * F) * H.block<6, 12>(6 * i, 0);
            }
            const Vec12 newton = J.partialPivLu().solve(-step);
            if (newton.allFinite()) step = newton;
        }
        last = now.size;
        Trial best = now;
        for (double share = 1; share > 1e-3; share /= 2) {
            Trial next = now;
            for (int i : {0, 1}) next.elastic[i] += share * step.segment<6>(6 * i);
            N = forces(next);
            if (round % 8 == 7) no_softer(k, modes_of(next.elastic[0], next.elastic[1]), N, of, alone);
            go_round(next);
            if (share == 1 || next.size < best.size) best = next;
            if (next.size < now.size) break;
        }
        now = best;
    }
    for (int i : {0, 1}) flow[i] = now.flow[i], flow[i].elastic = d[i] - now.flow[i].plastic;
}

PairMatrix pair_tangent(const PairKind<double>& k, const Stiffness (&of)[2], const Vec6 (&elastic)[2],
                        const YieldSurface* const (&w)[2], const double* sections, int n, const Flow* const (&flow)[2],
                        const FixedEnd* fixed_end) {
    PairMatrix H = pair_stiffness(k, elastic[0], elastic[1]);
    for (int i : {0, 1}) H.block<6, 6>(6 * i, 6 * i) += of[i].matrix();
    if (!flow[0] && !flow[1]) return H;
    PairMatrix F = H.inverse();
    Eigen::Matrix<double, 12, Eigen::Dynamic> a(12, 0);
    for (int i : {0, 1})
        for (int s = 0; flow[i] && s < n; ++s) {
            if (!(flow[i]->lambda[s] > 0)) continue;
            F.block<6, 6>(6 * i, 6 * i) += 2 * flow[i]->lambda[s] * yield_matrix(sections[s], *w[i]);
            a.conservativeResize(12, a.cols() + 1);
            a.rightCols<1>().setZero();
            a.rightCols<1>().segment<6>(6 * i) =
                yield_gradient(flow[i]->p + fixed_end[i].at(sections[s]), sections[s], *w[i]);
        }
    const PairMatrix X = F.inverse();  // eq 10a, of the pair
    if (a.cols() == 0) return X;
    const Eigen::Matrix<double, 12, Eigen::Dynamic> Xa = X * a;
    const Eigen::MatrixXd h = a.transpose() * Xa;
    return X - Xa * h.completeOrthogonalDecomposition().pseudoInverse() * Xa.transpose();
}

}  // namespace hinge::beam

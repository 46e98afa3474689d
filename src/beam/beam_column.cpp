#include "beam/beam_column.h"

namespace hinge::beam {
namespace {

/// Modes on which the additional energy of a pair depends: mean extension, and for each plane sum and difference of the
/// bending of its two elements.
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
    PairKind<double> k = {c.EA / L, L, {c.EIx / L, c.EIy / L}, {L * L / c.EIx, L * L / c.EIy}, {}};
    const double GA[2] = {c.GAy, c.GAx};
    for (int plane : {0, 1}) k.shear[plane] = pair_shear(1 / (k.c[plane] * GA[plane]));
    return k;
}

double pair_energy(const PairKind<double>& k, const Vec6& d1, const Vec6& d2) {
    const Modes y = modes_of(d1, d2);
    const double N = forces_of(k, y).N_whole, off = N - k.axial * y[0];
    double U = -off * off / k.axial;  // 2 N e - N^2 l/EA - e^2 EA/l
    for (int plane : {0, 1}) {
        const StabilityFunctions<double> of = stability_functions(k, plane, N);
        const double sum = y[1 + 2 * plane], difference = y[2 + 2 * plane];
        U += 0.25 * k.b[plane] * ((of.S - 1) * sum * sum + (of.A - 1) * difference * difference);
    }
    return U;
}

PairShapeNumbers shape_of(const Vec6& d1, const Vec6& d2) {
    const Modes y = modes_of(d1, d2);
    return {{y[1], y[3]}, {y[2], y[4]}};
}

Vec12 pair_forces(const PairKind<double>& k, const Vec6& d1, const Vec6& d2, double* N) {
    const PairForces<double> f = forces_of(k, modes_of(d1, d2));
    if (N) *N = f.N_whole;
    return on_both(f);
}

PairMatrix pair_stiffness(const PairKind<double>& k, const Vec6& d1, const Vec6& d2, double N) {
    const Modes y = modes_of(d1, d2);
    Eigen::Matrix<double, 5, 5> H = Eigen::Matrix<double, 5, 5>::Zero();
    Modes with_N = Modes::Zero();  // d2/dN dy
    with_N[0] = 2;
    double N_N = -2 / k.axial;
    for (int plane : {0, 1}) {
        const StabilityFunctions<double> of = stability_functions(k, plane, N);
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
    // lazyProduct: at this size plain loops beat the packed product
    const Eigen::Matrix<double, 5, 12> HG = H.lazyProduct(G);
    return G.transpose().lazyProduct(HG);
}

PairMatrix pair_stiffness(const PairKind<double>& k, const Vec6& d1, const Vec6& d2) {
    return pair_stiffness(k, d1, d2, forces_of(k, modes_of(d1, d2)).N_whole);
}

}  // namespace hinge::beam

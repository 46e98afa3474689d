#include "beam/elastic_pair.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

namespace hinge::beam {
namespace {

constexpr int most_steps = 60;
constexpr double still_quick = 0.1;  ///< a step that is more than this part of the one before: then K is computed anew
// of the last step, of one near the end, and of what may be left, in the energy norm, over that of the elements
constexpr double found = 1e-7, close = 1e-3, exact = 1e-13;

using Few = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 8, 1>;
using FewSquare = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 8, 8>;

/// The components of (d1, d2) that have a spring, and the compliances of these.
struct Sprung {
    int at[8], count = 0;
    Few compliance;

    explicit Sprung(const EndSprings (&springs)[2]) {
        double c[8];
        for (int i : {0, 1}) {
            const Vec6 of = springs[i].compliance();
            for (int j = 0; j < 4; ++j)
                if (of[j] > 0) c[count] = of[j], at[count++] = 6 * i + j;
        }
        compliance = Eigen::Map<Few>(c, count);
    }
    Few of(const Vec12& p) const {
        Few out(count);
        for (int i = 0; i < count; ++i) out[i] = p[at[i]];
        return out;
    }
    FewSquare of(const PairMatrix& K) const {
        FewSquare out(count, count);
        for (int i = 0; i < count; ++i)
            for (int j = 0; j < count; ++j) out(i, j) = K(at[i], at[j]);
        return out;
    }
};

/// Energy, forces and stiffness of the elements and of the pair, at their own deformations.
double energy(const ElasticPair& pair, const Vec12& d) {
    double sum = pair_energy(pair.kind, d.head<6>(), d.tail<6>());
    for (int i : {0, 1}) sum += 0.5 * d.segment<6>(6 * i).dot(pair.of[i].times(d.segment<6>(6 * i)));
    return sum;
}
Vec12 forces(const ElasticPair& pair, const Vec12& d, double* N = nullptr) {
    Vec12 p = pair_forces(pair.kind, d.head<6>(), d.tail<6>(), N);
    for (int i : {0, 1}) p.segment<6>(6 * i) += pair.of[i].times(d.segment<6>(6 * i));
    return p;
}
PairMatrix own_matrix(const ElasticPair& pair) {
    PairMatrix K = PairMatrix::Zero();
    for (int i : {0, 1}) K.block<6, 6>(6 * i, 6 * i) = pair.of[i].matrix();
    return K;
}

Vec12 both(const Vec6& d1, const Vec6& d2) { return (Vec12() << d1, d2).finished(); }

}  // namespace

Stiffness in_series(const Stiffness& k, const EndSprings& springs) {
    if (!springs.any()) return k;
    const auto bend = [](double& k11, double& k12, double& k22, const double(&c)[2]) {
        // (k^-1 + c)^-1 = (1 + k c)^-1 k
        const double det = k11 * k22 - k12 * k12, a = 1 + k11 * c[0], b = 1 + k22 * c[1];
        const double by = 1 / (a * b - k12 * k12 * c[0] * c[1]);
        k11 = by * (k11 + det * c[1]), k22 = by * (k22 + det * c[0]), k12 *= by;
    };
    Stiffness out = k;
    bend(out.x11, out.x12, out.x22, springs.x);
    bend(out.y11, out.y12, out.y22, springs.y);
    return out;
}

/// Newton's method for the least U over t. Where U is not convex (p > 3.5, pair_return.h), a step by the stiffness of
/// the elements alone leads down too, if it is short enough.
bool ElasticPair::take_off_springs(Vec6& d1, Vec6& d2) const {
    if (!has_springs()) return true;
    const Sprung sprung(springs);
    const Vec12 d = both(d1, d2);
    const FewSquare firm = sprung.of(own_matrix(*this)), rigid = sprung.compliance.cwiseInverse().asDiagonal();
    const auto at = [&](const Few& t) {
        Vec12 own = d;
        for (int i = 0; i < sprung.count; ++i) own[sprung.at[i]] -= t[i];
        return own;
    };
    const auto whole = [&](const Few& t) { return energy(*this, at(t)) + 0.5 * t.dot(rigid * t); };
    Few t = (firm + rigid).llt().solve(sprung.of(forces(*this, d)));
    double scale = std::numeric_limits<double>::min(), before = 0;  // of the energy; the size of the step before
    Eigen::LLT<FewSquare> factor;
    for (int i : {0, 1}) scale += 0.5 * d.segment<6>(6 * i).dot(of[i].times(d.segment<6>(6 * i)));
    for (int step = 0; step < most_steps; ++step) {
        const Vec12 own = at(t);
        const Few off = sprung.of(forces(*this, own)) - rigid * t;
        Few way = off;
        double size = 0;
        const auto solve = [&] { way = factor.solve(off), size = std::sqrt(off.dot(way) / scale); };
        bool fresh = step == 0;
        if (!fresh) solve(), fresh = !(size <= still_quick * before);
        if (fresh) {
            const PairMatrix K = own_matrix(*this) + pair_stiffness(kind, own.head<6>(), own.tail<6>());
            factor.compute(sprung.of(K) + rigid);
            if (factor.info() != Eigen::Success) factor.compute(firm + rigid);
            solve();
        }
        const double left = fresh ? 0 : size * size / before;  // by a step with a K that is not of this t
        before = size;
        if (!std::isfinite(size)) return false;
        if (size <= found && left <= exact) {
            const Vec12 last = at(t + way);
            d1 = last.head<6>(), d2 = last.tail<6>();
            return true;
        }
        if (size > close) {  // else rounding hides what U falls by
            const double U = whole(t);
            for (int halved = 0; !(whole(t + way) <= U); ++halved, way *= 0.5)
                if (halved == 40) return false;
        }
        t += way;
    }
    return false;
}

double ElasticPair::energy_beyond(const Vec6& d1, const Vec6& d2) const {
    if (!has_springs()) return pair_energy(kind, d1, d2);
    Vec6 own1 = d1, own2 = d2;
    if (!take_off_springs(own1, own2)) return std::numeric_limits<double>::quiet_NaN();
    const Vec12 d = both(d1, d2), own = both(own1, own2), t = d - own;
    double sum = energy(*this, own);
    for (int i : {0, 1}) {
        const Vec6 c = springs[i].compliance();
        for (int j = 0; j < 4; ++j)
            if (c[j] > 0) sum += 0.5 * t[6 * i + j] * t[6 * i + j] / c[j];
        sum -= 0.5 * d.segment<6>(6 * i).dot(of[i].times(d.segment<6>(6 * i)));
    }
    return sum;
}

ElasticPair::At ElasticPair::at(const Vec6& d1, const Vec6& d2) const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    At at = {{d1, d2}, Vec12::Constant(none), none};
    if (!has_springs()) at.beyond = pair_forces(kind, d1, d2, &at.N);
    else if (take_off_springs(at.own[0], at.own[1]))
        at.beyond = forces(*this, both(at.own[0], at.own[1]), &at.N) - both(of[0].times(d1), of[1].times(d2));
    return at;
}

/// With springs (K^-1 + c e e^T)^-1, one spring after the other.
PairMatrix ElasticPair::stiffness_beyond(const At& at) const {
    if (!has_springs()) return pair_stiffness(kind, at.own[0], at.own[1], at.N);
    const PairMatrix own = own_matrix(*this);
    PairMatrix K = own + pair_stiffness(kind, at.own[0], at.own[1], at.N);
    const Sprung sprung(springs);
    for (int i = 0; i < sprung.count; ++i) {
        const Vec12 column = K.col(sprung.at[i]);
        const double c = sprung.compliance[i];
        K -= (c / (1 + c * column[sprung.at[i]])) * column * column.transpose();
    }
    return K - own;
}

}  // namespace hinge::beam

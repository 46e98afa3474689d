// The bending of a pair under axial force: against the stability functions of the exact beam-column, its forces and
// stiffness against finite differences of its energy, and its return to the yield surface.
#include <Eigen/LU>

#include "beam/pair_return.h"
#include "section/laws/laws.h"
#include "helpers.h"

using namespace hinge;
using namespace hinge::beam;
using namespace hinge::test;

namespace {

/// u cot u, u^2 = p; v coth v in tension.
double stability(double p) {
    const double u = std::sqrt(std::abs(p));
    return p > 0 ? u / std::tan(u) : u / std::tanh(u);
}

struct SomePair : ElasticPair {
    Vec6 d[2];
    Vec12 forces() const { return forces(d[0], d[1]); }
    Vec12 forces(const Vec12& both) const { return forces(both.head<6>(), both.tail<6>()); }
    Vec12 forces(const Vec6& d1, const Vec6& d2) const {
        Vec12 p = forces_beyond(d1, d2);
        p.head<6>() += of[0].times(d1);
        p.tail<6>() += of[1].times(d2);
        return p;
    }
    PairMatrix stiffness() const {
        PairMatrix K = stiffness_beyond(d[0], d[1]);
        for (int i : {0, 1}) K.block<6, 6>(6 * i, 6 * i) += of[i].matrix();
        return K;
    }
    double energy(const Vec6& d1, const Vec6& d2) const {
        return energy_beyond(d1, d2) + 0.5 * d1.dot(of[0].times(d1)) + 0.5 * d2.dot(of[1].times(d2));
    }
    /// Springs at some of the ends, from much stiffer than the elements to much softer.
    void soften(Dice& dice) {
        for (EndSprings& s : springs)
            for (int end : {0, 1}) {
                const double softness = dice.pick(3) == 0 ? 0 : std::exp(dice(-4, 3));
                s.x[end] = softness / kind.b[0], s.y[end] = softness / kind.b[1];
            }
    }
};

/// Slender elements, bent by up to `bent`, rad, with a mean extension of up to p = `most`.
SomePair some_pair(Dice& dice, double bent, double most) {
    const Rigidity c = random_rigidity(dice, {1e5, 1e5, 5e8, 7e4, 1.6e8, 1.6e8});
    const double L = dice(0.5, 2);
    SomePair pair{{pair_kind(c, L), {stiffness(c, L, gauss_point), stiffness(c, L, -gauss_point)}}, {}};
    const double e = dice(-most, most) / (pair.kind.axial * pair.kind.c[0]);
    for (int i : {0, 1}) {
        Vec6& d = pair.d[i];
        d[4] = e * dice(0.8, 1.2);
        d[5] = dice(-0.02, 0.02);
        for (int plane : {0, 1}) {
            const double a = i == 0 ? (1 - gauss_point) / 2 : (1 + gauss_point) / 2;  // hardly any shear
            d[2 * plane] = dice(-bent, bent);
            d[2 * plane + 1] = (dice(-1, 1) * 1e-3 * bent - a * d[2 * plane]) / (1 - a);
        }
    }
    return pair;
}

}  // namespace

TEST_CASE("beam-column: the pair's two numbers are the stability functions") {
    double worst = 0, at_ends = 0;
    for (double p = -7.2; p <= 6; p += 0.0101) {
        const StabilityFunctions<double> f = stability_functions(p);
        const double C = stability(p);
        const double error = largest_of(std::abs(f.S - pair_sag * p - C), std::abs(3 * f.A / (p / (1 - C)) - 1));
        double& most = p < 4.5 ? worst : at_ends;
        most = largest_of(most, error);
    }
    CHECK_FIGURE("stability functions, p from -7.2 to 4.5", worst, 2.6e-5);
    CHECK_FIGURE("stability functions, up to 6", at_ends, 3.1e-4);
    CHECK(stability_functions(0.0).S == 1);
    CHECK(stability_functions(0.0).A == 1);
}

TEST_CASE("beam-column: S and A fall ever faster without a jump; with shear they are those of p / (1 - s p)") {
    double value = 0, slope = 0, curvature = 0, jump = 0, last_S1 = 0, last_A1 = 0;
    for (const double shear : {0.0, 0.003, 0.03, 0.5}) {
        const double h = 1e-4;
        const PairShear<double> of = pair_shear(shear);
        const auto at = [&](double p) { return stability_functions(p, of); };
        for (double p = -40; p <= (shear > 0 ? 8 : 40); p += 0.0101) {
            const StabilityFunctions<double> f = at(p), less = at(p - h), more = at(p + h);
            if (p > of.least && p < of.most) {
                const StabilityFunctions<double> softer = stability_functions(p / (1 - shear * p));
                value = largest_of(value, std::abs(f.S - softer.S), std::abs(f.A - softer.A));
            }
            if (p > -39) CHECK((f.S1 <= last_S1 + 1e-12 && f.A1 <= last_A1 + 1e-12));
            last_S1 = f.S1, last_A1 = f.A1;
            const StabilityFunctions<double> next = at(p + 1e-5);
            jump = largest_of(jump, std::abs(next.S - f.S - 1e-5 * f.S1) / (1 + std::abs(f.S2) + std::abs(next.S2)),
                              std::abs(next.A - f.A - 1e-5 * f.A1) / (1 + std::abs(f.A2) + std::abs(next.A2)));
            if (std::abs(p - of.least) < 2 * h || std::abs(p - of.most) < 2 * h) continue;  // S2 and A2 jump there
            slope = largest_of(slope, std::abs((more.S - less.S) / (2 * h) - f.S1) / (1 + std::abs(f.S1)),
                               std::abs((more.A - less.A) / (2 * h) - f.A1) / (1 + std::abs(f.A1)));
            curvature = largest_of(curvature, std::abs((more.S1 - less.S1) / (2 * h) - f.S2) / (1 + std::abs(f.S2)),
                                   std::abs((more.A1 - less.A1) / (2 * h) - f.A2) / (1 + std::abs(f.A2)));
        }
    }
    CHECK_FIGURE("S and A against those of p / (1 - s p)", value, 1e-13);
    CHECK_FIGURE("jump of S and A from their slopes, over their bends", jump, 1e-9);
    CHECK_FIGURE("slopes of S and A by differences", slope, 1e-4);
    CHECK_FIGURE("second derivatives of S and A by differences", curvature, 1e-4);
}

TEST_CASE("beam-column: N solves its equation, however far the pair is bent and pressed") {
    Dice dice(11);
    double worst = 0;
    for (int trial = 0; trial < 200000; ++trial) {
        const SomePair pair = some_pair(dice, 1, 1);
        const PairKind<double>& k = pair.kind;
        const double e = dice(-10, 10) / (k.axial * k.c[0]), size = std::pow(10, dice(-3, 0));
        const double sum[2] = {dice(-size, size), dice(-size, size)},
                     difference[2] = {dice(-size, size), dice(-size, size)};
        const auto beyond = [&](double N) {  // N - EA/l (e + bow(N)), which grows with N
            double bow = 0;
            for (int plane : {0, 1}) {
                const StabilityFunctions<double> of = stability_functions(k, plane, N);
                bow -= k.length / 8 * (of.S1 * sum[plane] * sum[plane] + of.A1 * difference[plane] * difference[plane]);
            }
            return N - k.axial * (e + bow);
        };
        double low = -1e10, high = 1e10;
        for (int i = 0; i < 100; ++i) (beyond(0.5 * (low + high)) > 0 ? high : low) = 0.5 * (low + high);
        const double N = pair_forces(k, e, sum, difference).N_whole;
        worst = largest_of(worst, std::abs(N - low) / (std::abs(low) + 1e-3 / k.c[0]));
    }
    CHECK_FIGURE("N by halving and by Newton's method", worst, 1e-6);
}

TEST_CASE("beam-column: eight at once are the same bits as one at a time") {
    Dice dice(3);
    for (int round = 0; round < 200; ++round) {
        PairKind<Lanes> kind{};
        Lanes e{}, sum[2] = {}, difference[2] = {};
        for (int i = 0; i < lane_count; i += 2) {  // lanes 2 i and 2 i + 1 are the elements of one pair
            kind.axial[i] = dice(1e7, 1e9), kind.length[i] = dice(0.5, 2);
            e[i] = dice(-2e-3, 2e-3);
            for (int plane : {0, 1}) {
                kind.b[plane][i] = dice(1e4, 1e6), kind.c[plane][i] = kind.length[i] / kind.b[plane][i];
                const PairShear<double> shear = pair_shear(dice(0, 0.2));
                put(kind.shear[plane], i, shear), put(kind.shear[plane], i + 1, shear);
                sum[plane][i] = dice(-0.3, 0.3), difference[plane][i] = dice(-0.3, 0.3);
            }
            kind.axial[i + 1] = kind.axial[i], kind.length[i + 1] = kind.length[i], e[i + 1] = e[i];
            for (int plane : {0, 1}) {
                kind.b[plane][i + 1] = kind.b[plane][i], kind.c[plane][i + 1] = kind.c[plane][i];
                sum[plane][i + 1] = sum[plane][i], difference[plane][i + 1] = -difference[plane][i];
            }
        }
        const PairForces<Lanes> many = pair_forces(kind, e, sum, difference);
        for (int i = 0; i < lane_count; ++i) {
            const double of_one[2] = {sum[0][i], sum[1][i]}, less[2] = {difference[0][i], difference[1][i]};
            const auto shear_of = [&](int plane) {
                const PairShear<Lanes>& all = kind.shear[plane];
                return PairShear<double>{all.flexible[i], all.least[i], all.most[i]};
            };
            const PairKind<double> own{kind.axial[i],
                                       kind.length[i],
                                       {kind.b[0][i], kind.b[1][i]},
                                       {kind.c[0][i], kind.c[1][i]},
                                       {shear_of(0), shear_of(1)}};
            const PairForces<double> one = pair_forces<double>(own, e[i], of_one, less);
            CHECK(many.N[i] == one.N);
            for (int plane : {0, 1}) CHECK(many.moment[plane][i] == one.moment[plane]);
        }
    }
}

TEST_CASE("beam-column: forces and stiffness are the derivatives of the energy") {
    Dice dice(7);
    double of_energy = 0, of_forces = 0, symmetric = 0;
    for (int n = 0; n < 400; ++n) {
        SomePair pair = some_pair(dice, n % 2 ? 0.02 : 0.3, n < 200 ? 5 : 3);
        if (n >= 200) pair.soften(dice);
        const Vec12 p = pair.forces();
        const PairMatrix K = pair.stiffness();
        Vec12 d, h = Vec12::Constant(1e-5);
        d << pair.d[0], pair.d[1];
        h[4] = h[10] = 1e-7;
        const Vec12 slope =
            differences(
                [&](const Vec12& at) { return Eigen::Matrix<double, 1, 1>(pair.energy(at.head<6>(), at.tail<6>())); },
                d, h)
                .transpose();
        const PairMatrix by_differences = differences([&](const Vec12& at) { return pair.forces(at); }, d, h);
        const Vec12 k = K.diagonal().cwiseAbs();
        Vec12 stiff = k;
        for (int i : {0, 1}) stiff.segment<6>(6 * i) += pair.of[0].matrix().diagonal();
        const Vec12 scale = stiff.cwiseSqrt().cwiseInverse();
        of_energy = largest_of(of_energy, largest_entry((slope - p).cwiseQuotient((1e5 * k).cwiseSqrt())));
        of_forces =
            largest_of(of_forces, largest_entry(scale.asDiagonal() * (by_differences - K) * scale.asDiagonal()));
        symmetric = largest_of(symmetric, largest_entry(K - K.transpose()) / largest_entry(K));
    }
    CHECK_FIGURE("forces", of_energy, 1e-6);
    CHECK_FIGURE("stiffness", of_forces, 1e-6);
    CHECK_FIGURE("symmetry", symmetric, 1e-15);
}

TEST_CASE("beam-column: springs at the ends are in series with the pair") {
    Dice dice(17);
    double of_element = 0, of_pair = 0, moments = 0;
    for (int n = 0; n < 400; ++n) {
        SomePair pair = some_pair(dice, n % 2 ? 0.02 : 0.3, 3);
        const SomePair rigid = pair;
        pair.soften(dice);
        Vec12 c;
        c << pair.springs[0].compliance(), pair.springs[1].compliance();
        // each element by itself, and the pair without deformation, by their flexibilities
        for (int i : {0, 1}) {
            const Mat6 k = in_series(pair.of[i], pair.springs[i]).matrix(),
                       F = pair.of[i].matrix().inverse() + Mat6(c.segment<6>(6 * i).asDiagonal());
            of_element = largest_of(of_element, largest_entry(k * F - Mat6::Identity()));
        }
        SomePair still = pair, still_rigid = rigid;
        for (int i : {0, 1}) still.d[i].setZero(), still_rigid.d[i].setZero();
        const PairMatrix flexible = still_rigid.stiffness().inverse() + PairMatrix(c.asDiagonal());
        of_pair = largest_of(of_pair, largest_entry(still.stiffness() * flexible - PairMatrix::Identity()));
        // the springs turn by c m, and what is left of d has these forces
        Vec6 own[2] = {pair.d[0], pair.d[1]};
        REQUIRE(pair.take_off_springs(own[0], own[1]));
        const Vec12 p = pair.forces();
        Vec12 turned;
        turned << pair.d[0] - own[0], pair.d[1] - own[1];
        moments = largest_of(moments, largest_entry(turned - c.cwiseProduct(p)) / largest_entry(pair.d[0]));
        moments = largest_of(moments, largest_entry(rigid.forces(own[0], own[1]) - p) / largest_entry(p));
    }
    CHECK_FIGURE("an element with springs", of_element, 1e-9);
    CHECK_FIGURE("a pair with springs", of_pair, 1e-9);
    CHECK_FIGURE("moments of springs", moments, 1e-9);
}

TEST_CASE("beam-column: the return to the yield surface ends on it, with forces of what is left elastic") {
    Dice dice(11);
    double law = 0, surface = 0, tangent = 0;
    int flows = 0, both = 0, columns = 0, unsure = 0;
    for (int n = 0; n < 600; ++n) {
        SomePair pair = some_pair(dice, 0.03, n % 2 ? 2 : 4);
        if (n >= 400) pair.soften(dice);
        const Vec12 start = pair.forces();
        const Vec6 p0 = start.segment<6>(6 * dice.pick(2));
        const double m = largest_of(p0[0] * p0[0], p0[1] * p0[1], p0[2] * p0[2], p0[3] * p0[3]);
        const YieldSurface w = {dice(0.2, 1) / m, dice(0.2, 1) / m, dice(0, 0.5) / (p0[4] * p0[4]),
                                0.1 / (p0[5] * p0[5])};
        const auto of_section = paper_law(w);
        const double far = n % 4 < 2 ? 1.1 : 3;  // how far the trial is beyond
        const Vec6 trial[2] = {far * pair.d[0], far * pair.d[1]};
        ReturnMapResult flow[2];
        beam::return_to_surface(pair, trial, *of_section, flow, 1e-13);
        const Vec6 elastic[2] = {trial[0] - flow[0].plastic, trial[1] - flow[1].plastic};
        const Vec12 p = pair.forces(elastic[0], elastic[1]);
        bool flowing[2];
        for (int i : {0, 1}) {
            law = largest_of(law, largest_entry(p.segment<6>(6 * i) - flow[i].p) / largest_entry(flow[i].p));
            const double f = largest_of(yield_function(flow[i].p, -1.0, w), yield_function(flow[i].p, 1.0, w));
            flowing[i] = !flow[i].plastic.isZero(0);
            surface = largest_of(surface, flowing[i] ? std::abs(f - 1) : f - 1);
            CHECK(flow[i].dissipation >= 0);
        }
        flows += flowing[0] || flowing[1], both += flowing[0] && flowing[1];
        const ElementFlow* given[2] = {flowing[0] ? &flow[0] : nullptr, flowing[1] ? &flow[1] : nullptr};
        const PairMatrix K = pair_tangent(pair, elastic, *of_section, given);
        // Central differences with steps of h; `same` is false where a corner of the surface lies between.
        bool same = true;
        const auto differences = [&](int i, double h) {
            Vec12 column = Vec12::Zero();
            for (int side : {1, -1}) {
                Vec6 there[2] = {trial[0], trial[1]};
                there[i / 6][i % 6] += side * h;
                ReturnMapResult moved[2];
                beam::return_to_surface(pair, there, *of_section, moved, 1e-13);
                for (int e : {0, 1}) {
                    column.segment<6>(6 * e) += side * moved[e].p / (2 * h);
                    for (int s : {0, 1}) same = same && (moved[e].lambda[s] > 0) == (flow[e].lambda[s] > 0);
                }
            }
            return column;
        };
        for (int i = 0; i < 12; ++i) {
            const double h = i % 6 == 4 ? 1e-10 : 1e-8;
            same = true;
            const Vec12 column = differences(i, h), wider = differences(i, 4 * h);
            if (!same) continue;
            ++columns;
            const Mat6 own = pair.of[0].matrix();
            const Vec12 scale = (own(i % 6, i % 6) * own.diagonal().replicate<2, 1>()).cwiseSqrt();
            // how far the two steps differ; how far the tangent is from the shorter one
            const double spread = largest_entry((column - wider).cwiseQuotient(scale)),
                         off = largest_entry((column - K.col(i)).cwiseQuotient(scale));
            // Where the energy is flat to rounding the return ends a little beside, and differences say nothing.
            if (spread > 1e-5) ++unsure;
            else tangent = largest_of(tangent, off);
        }
    }
    CHECK(flows > 200);
    CHECK(both > 50);
    CHECK_FIGURE("on the surface", surface, 1e-10);
    CHECK_FIGURE("forces", law, 1e-10);
    CHECK(columns > 2000);
    CHECK(unsure < columns / 100);
    CHECK_FIGURE("tangent", tangent, 1e-5);
}

namespace {

/// A pair of an H section of slenderness 20 to 300, and a deformation up to `beyond` times that of first yield, between
/// tension of half of N0 and compression of `beyond` N0.
struct YieldingPair {
    SomePair pair;
    YieldSurface w;
    YieldingPair(Dice& dice, double beyond) {
        const double depth = dice(0.1, 0.4), A = depth * depth * dice(0.1, 0.3), rx = 0.42 * depth,
                     ry = depth * dice(0.2, 0.42), L = 0.5 * ry * dice(20, 300), E = 206e9, stress = dice(235e6, 450e6);
        const double EIx = E * A * rx * rx;
        const Rigidity c{EIx, E * A * ry * ry, E * A, 0.01 * EIx, 80e9 * A * dice(0.3, 0.8), 80e9 * A * dice(0.3, 0.8)};
        pair = {{pair_kind(c, L), {stiffness(c, L, gauss_point), stiffness(c, L, -gauss_point)}}, {}};
        const double limit[2] = {2.3 * A * rx * rx / depth * stress, 3 * A * ry * ry / depth * stress}, N0 = A * stress;
        w = {1 / (limit[0] * limit[0]), 1 / (limit[1] * limit[1]), 1 / (N0 * N0), 0};
        const double e = -dice(-0.5, beyond) * N0 / pair.kind.axial;
        for (int i : {0, 1}) {
            const double s = i == 0 ? gauss_point : -gauss_point;
            pair.d[i].setZero();
            pair.d[i][4] = e * dice(0.9, 1.1);
            for (int plane : {0, 1}) {
                const double kappa = dice(-beyond, beyond) * limit[plane] / pair.kind.b[plane],
                             sheared = dice(-beyond, beyond) * limit[plane] / L / (plane ? c.GAx : c.GAy);
                pair.d[i][2 * plane] = sheared - (1 + s) / 2 * kappa;
                pair.d[i][2 * plane + 1] = sheared + (1 - s) / 2 * kappa;
            }
        }
    }
};

}  // namespace

TEST_CASE("beam-column: flow takes no more than the elastic energy that it frees, however slender the pair") {
    Dice dice(5);
    int returns = 0, unconverged = 0, pressed = 0;
    double beyond_surface = 0, off_law = 0;
    for (int n = 0; n < 40000; ++n) {
        YieldingPair y(dice, n % 4 == 0 ? 2 : 1.2);
        if (n % 4 == 1) y.pair.soften(dice);
        const auto of_section = paper_law(y.w);
        const Vec12 trial = y.pair.forces();
        double f = 0;
        for (int i : {0, 1})
            for (double r : {-1.0, 1.0}) f = largest_of(f, yield_function(Vec6(trial.segment<6>(6 * i)), r, y.w));
        if (f <= 1) continue;
        ++returns;
        ReturnMapResult flow[2];
        const double tolerance = n % 8 == 0 ? 1e-9 : 1e-4;
        const bool converged = return_to_surface(y.pair, y.pair.d, *of_section, flow, tolerance);
        unconverged += !converged;
        const double before = y.pair.energy(y.pair.d[0], y.pair.d[1]),
                     after = y.pair.energy(flow[0].elastic, flow[1].elastic);
        CHECK(flow[0].dissipation >= 0);
        CHECK(flow[1].dissipation >= 0);
        CHECK(flow[0].dissipation + flow[1].dissipation <= before - after + 1e-9 * before);
        const Vec12 p = y.pair.forces(flow[0].elastic, flow[1].elastic);
        const double N = y.pair.at(flow[0].elastic, flow[1].elastic).N;
        pressed += -N * largest_of(y.pair.kind.c[0], y.pair.kind.c[1]) > 3.5;
        for (int i : {0, 1}) {
            off_law = largest_of(off_law, largest_entry(p.segment<6>(6 * i) - flow[i].p) / largest_entry(flow[i].p));
            for (double r : {-1.0, 1.0})
                if (converged) beyond_surface = largest_of(beyond_surface, yield_function(flow[i].p, r, y.w) - 1);
        }
    }
    CHECK(returns > 30000);
    CHECK(pressed > 2000);  // where U is not convex
    CHECK(unconverged == 0);
    CHECK_FIGURE("forces against dU/dd of what is left elastic", off_law, 1e-12);
    CHECK_FIGURE("f_y - 1", beyond_surface, 0.02);
}

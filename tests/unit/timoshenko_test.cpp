// The element against closed forms: K = L B^T D B, the pair of asi-gauss elements as an exact Timoshenko member, and
// how far off midpoint integration is.
#include <Eigen/LU>

#include "beam/timoshenko.h"
#include "helpers.h"

using namespace hinge;
using namespace hinge::test;

namespace {

beam::Rigidity some_rigidity(Dice& dice) { return random_rigidity(dice, {1e5, 1e5, 5e8, 7e4, 1.6e8, 1.6e8}); }

/// A member skew in space with a section that bends differently about x and y, as a cantilever held at one of its ends.
struct Skew : Frame {
    Vec3 along = Vec3(0.3, 0.7, -0.4).normalized(), from = Vec3(1, -2, 0.5);
    double L = 1.7;
    int end[2];
    Mat3 axes;  ///< columns: local x y z
    std::shared_ptr<Section> oblong = square(0.05);

    Skew(Formulation formulation, int count, int held) : Frame(small_displacement(formulation)) {
        oblong->Ix *= 1.7;
        oblong->Iy *= 0.6;
        oblong->shear_area_y *= 0.4;  // shear shows: a tenth of the deflection at least
        oblong->shear_area_x *= 0.01;
        section = oblong;
        elements = count;
        const Vec3 up(0.2, 0.1, 1);
        end[0] = node(from);
        end[1] = node(from + L * along);
        model->fix(end[held], 63);
        member(end[0], end[1], up);
        axes.col(2) = along;
        axes.col(0) = up.cross(along).normalized();
        axes.col(1) = along.cross(axes.col(0));
    }

    /// Flexibility of the free end, local axes, 6 x 6: [u v w tx ty tz] from [Fx Fy Fz Mx My Mz]. `held`: the end that
    /// is held. `midpoint_elements`: 0 for the closed form; n for midpoint integration, whose bending part is short by
    /// L (Mb - Ma)^2 / (12 n^2 EI).
    Mat6 flexibility(int held, int midpoint_elements) const {
        const double E = material->E, G = material->G, EIx = E * oblong->Ix, EIy = E * oblong->Iy;
        const double part = midpoint_elements ? 1 - 0.25 / (midpoint_elements * midpoint_elements) : 1;
        const double side = held == 0 ? 1 : -1;  // the free end lies along +z or -z of the held one
        Mat6 f = Mat6::Zero();
        f(0, 0) = part * L * L * L / (3 * EIy) + L / (G * oblong->shear_area_x);
        f(1, 1) = part * L * L * L / (3 * EIx) + L / (G * oblong->shear_area_y);
        f(2, 2) = L / (E * oblong->area);
        f(3, 3) = L / EIx;
        f(4, 4) = L / EIy;
        f(5, 5) = L / (G * oblong->J);
        f(0, 4) = f(4, 0) = side * L * L / (2 * EIy);
        f(1, 3) = f(3, 1) = -side * L * L / (2 * EIx);
        return f;
    }

    /// The same by the engine: six static runs.
    Mat6 measured(int held) const {
        Mat6 turn = Mat6::Zero(), f;
        turn.block<3, 3>(0, 0) = turn.block<3, 3>(3, 3) = axes;
        for (int c = 0; c < 6; ++c) {
            auto loaded = std::make_shared<Model>(*model);
            const Vec6 force = 1000 * turn.col(c);
            add_load(*loaded, {end[1 - held], force.head<3>(), force.tail<3>(), {}});

            const auto run = statics(std::make_shared<Structure>(loaded), {.steps = 1});
            REQUIRE(run->verdict() == Verdict::completed);
            f.col(c) = turn.transpose() * run->displacement(end[1 - held]) / 1000;
        }
        return f;
    }
};

/// The largest entry of the difference, entries brought to one unit by a length.
double difference(Mat6 a, Mat6 b, double length) {
    for (Mat6* m : {&a, &b}) {
        m->bottomRows<3>() *= length;
        m->rightCols<3>() *= length;
    }
    const Vec6 scale = b.diagonal().cwiseSqrt().cwiseInverse();
    return largest_entry(scale.asDiagonal() * (a - b) * scale.asDiagonal());
}

/// B(s) of eq 2, 6 x 12: generalised strains [kx ky ez kz gx gy] (1/m, 1/m, -, 1/m, -, -) from the nodal displacements
/// [u v w tx ty tz] of node 1 and node 2 in local axes, s in -1..1.
Eigen::Matrix<double, 6, 12> strain_displacement(double L, double s) {
    Eigen::Matrix<double, 6, 12> B = Eigen::Matrix<double, 6, 12>::Zero();
    const double n1 = (1 - s) / 2, n2 = (1 + s) / 2;
    const int differs[] = {3, 4, 2, 5, 0, 1};  // what each strain is the derivative of
    for (int row = 0; row < 6; ++row) B(row, differs[row]) = -1 / L, B(row, 6 + differs[row]) = 1 / L;
    B(4, 4) = -n1, B(4, 10) = -n2;
    B(5, 3) = n1, B(5, 9) = n2;
    return B;
}

/// The stress-strain matrix [D_e] of eq 3 for the strains of strain_displacement.
Vec6 elastic_moduli(const beam::Rigidity& c) { return (Vec6() << c.EIx, c.EIy, c.EA, c.GJ, c.GAx, c.GAy).finished(); }

}  // namespace

TEST_CASE("K = L B(s)^T D B(s) is the stiffness seen from the chord, for any s (1e-13: rounding)") {
    Dice dice(1);
    double worst = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const beam::Rigidity c = some_rigidity(dice);
        const double L = dice(0.2, 3), s = dice(-1, 1);
        const auto B = strain_displacement(L, s);
        const auto T = beam::linear_deformation(L);
        const Mat12 by_B = L * B.transpose() * elastic_moduli(c).asDiagonal() * B;
        const Mat12 by_chord = T.transpose() * beam::stiffness(c, L, s).matrix() * T;
        worst = largest_of(worst, (by_B - by_chord).norm() / by_B.norm());
    }
    CHECK_FIGURE("K = L B^T D B against the stiffness seen from the chord", worst, 1e-13);
}

TEST_CASE("the solution of k(s) d = p is its inverse (1e-9: k is badly conditioned by shear)") {
    Dice dice(3);
    double worst = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const beam::Stiffness k = beam::stiffness(some_rigidity(dice), dice(0.2, 3), dice(-1, 1));
        Vec6 d;
        for (double& x : d) x = dice(-1e-3, 1e-3);
        worst = largest_of(worst, (k.solve(k.times(d)) - d).norm() / d.norm());
    }
    CHECK_FIGURE("k.solve(k d) = d", worst, 1e-9);
}

TEST_CASE("two asi-gauss elements are the closed-form Timoshenko member, at both ends, skew in space (1e-9)") {
    for (int held : {0, 1})
        for (int count : {2, 4, 6}) {
            const Skew member(Formulation::asi_gauss, count, held);
            CHECK_FIGURE("asi-gauss, " + std::to_string(count) + " elements, held at end " + std::to_string(held + 1),
                         difference(member.measured(held), member.flexibility(held, 0), member.L), 1e-9);
        }
}

TEST_CASE("two asi-gauss elements condensed to their ends are the closed-form 12 x 12 stiffness (1e-9)") {
    Dice dice(4);
    double worst = 0, without = 0;
    for (int trial = 0; trial < 100; ++trial) {
        const beam::Rigidity c = some_rigidity(dice);
        const double L = dice(0.5, 3);
        // exact: the six deformation modes of a Timoshenko member, k = inverse of their flexibility
        const auto bending = [&](double EI, double GA) {
            Eigen::Matrix2d f;
            f << 1 / (3 * EI), -1 / (6 * EI), -1 / (6 * EI), 1 / (3 * EI);
            f = L * f + Eigen::Matrix2d::Constant(1 / (L * GA));
            return Eigen::Matrix2d(f.inverse());
        };
        Mat6 k = Mat6::Zero();
        k.block<2, 2>(0, 0) = bending(c.EIx, c.GAy);
        k.block<2, 2>(2, 2) = bending(c.EIy, c.GAx);
        k(4, 4) = c.EA / L;
        k(5, 5) = c.GJ / L;
        const auto T = beam::linear_deformation(L);
        const Mat12 exact = T.transpose() * k * T;

        const auto condensed = [&](double s) {
            Eigen::MatrixXd K = Eigen::MatrixXd::Zero(18, 18);  // end 1, middle, end 2
            const auto half = beam::linear_deformation(L / 2);
            K.block<12, 12>(0, 0) += half.transpose() * beam::stiffness(c, L / 2, s).matrix() * half;
            K.block<12, 12>(6, 6) += half.transpose() * beam::stiffness(c, L / 2, -s).matrix() * half;
            std::vector<int> ends = {0, 1, 2, 3, 4, 5, 12, 13, 14, 15, 16, 17}, middle = {6, 7, 8, 9, 10, 11};
            return Mat12(K(ends, ends) - K(ends, middle) * K(middle, middle).inverse() * K(middle, ends));
        };
        worst = largest_of(worst, (condensed(beam::gauss_point) - exact).norm() / exact.norm());
        without = largest_of(without, (condensed(0) - exact).norm() / exact.norm());
    }
    CHECK_FIGURE("two asi-gauss elements, condensed, against the closed form", worst, 1e-9);
    CHECK(without > 1e-3);  // midpoint integration is not exact
}

TEST_CASE("midpoint integration, cantilever: the bending part of the deflection is short by 1/(4 n^2) (1e-9)") {
    for (Formulation f : {Formulation::conventional, Formulation::asi})
        for (int count : {1, 2, 3, 4, 8}) {
            const Skew member(f, count, 0);
            CHECK_FIGURE(std::string(f == Formulation::asi ? "asi" : "conventional") + ", cantilever of " +
                             std::to_string(count) + " elements",
                         difference(member.measured(0), member.flexibility(0, count), member.L), 1e-9);
        }
}

TEST_CASE("midpoint integration, end moments: the flexibility is short by L (Mb - Ma)^2 / (12 n^2 EI) (1e-9)") {
    Dice dice(5);
    for (int count : {1, 2, 4, 8})
        for (int trial = 0; trial < 3; ++trial) {
            const double L = 0.9, Ma = dice(-1, 1) * 1000,
                         Mb = dice(-1, 1) * 1000;  // as the section's moments at the two ends
            Frame frame(small_displacement(Formulation::conventional));
            frame.elements = count;
            const int a = frame.foot(0, 0, 0, 0b001111),
                      b = frame.foot(L, 0, 0, 0b000111);  // rotates about z; held against torsion at a
            frame.member(a, b);
            frame.load(a, Vec3::Zero(), {0, 0, -Ma});
            frame.load(b, Vec3::Zero(), {0, 0, Mb});
            const auto run = statics(frame.build());
            const double EI = frame.material->E * frame.section->Iy,
                         GA = frame.material->G * frame.section->shear_area_x;
            const double twice_energy = Mb * run->displacement(b)[5] - Ma * run->displacement(a)[5];
            const double exact = L / (3 * EI) * (Ma * Ma + Ma * Mb + Mb * Mb) + (Mb - Ma) * (Mb - Ma) / (L * GA);
            CHECK_FIGURE("end moments, " + std::to_string(count) + " elements",
                         off(twice_energy, exact - L * (Mb - Ma) * (Mb - Ma) / (12 * count * count * EI)), 1e-9);
        }
}

TEST_CASE("a cantilever of 50 mm square steel, 1 m: 3.112854 mm/kN (1e-6: the digits of tests/references.md 10)") {
    Frame frame(small_displacement());
    const int a = frame.foot(0, 0, 0), b = frame.node(1, 0, 0);
    frame.member(a, b);
    frame.load(b, {0, 0, -1000});
    const auto run = statics(frame.build());
    CHECK_FIGURE("Timoshenko cantilever, mm/kN", off(-1000 * run->displacement(b)[2], 3.112854), 1e-6);
    CHECK_FIGURE("its reaction", off(run->reaction(a)[2], 1000), 1e-9);
    CHECK_FIGURE("its moment", off(-run->reaction(a)[4], 1000), 1e-9);
}

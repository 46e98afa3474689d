// What an axial force changes in the fixed-end moments of a pair of elements: forces as series in p against each force
// by itself.
#include "effects/clamped_member.h"

#include "helpers.h"

using namespace hinge;
using namespace hinge::test;

namespace {

struct Pair : Frame {
    std::shared_ptr<const Structure> structure;
    Pair() {
        section = square(0.1);
        elements = 2;
        member(foot(0, 0, 0), node(4, 0, 0));
        structure = std::make_shared<const Structure>(model);
    }
    /// With p = -N l^2 / EI, before the softening by shear.
    PressedPair with(double p) const {
        const Element& e = structure->elements()[0];
        std::vector<Vec6> force(2, Vec6::Zero());
        for (Vec6& f : force) f[4] = -p * e.rigidity.EIx / (e.length * e.length);
        return {*structure, 0, force, ElementHeats()};
    }
};

}  // namespace

TEST_CASE("forces on a pressed pair as series are those of each force") {
    const Pair pair;
    Dice dice(3);
    PairForces sums;
    std::vector<std::pair<Vec3, double>> forces;
    for (int i = 0; i < 40; ++i) {
        forces.emplace_back(Vec3(dice(-1, 1), dice(-1, 1), dice(-1, 1)), dice(-1, 1));
        sums.add(forces.back().first, forces.back().second);
    }
    for (const double p : {-6.0, -1.0, -0.05, 0.05, 0.5, 2.0, 5.9}) {
        const PressedPair by_N = pair.with(p);
        REQUIRE(by_N.counts());
        const Vec3 across = Vec3(0.3, -0.8, 0.5).normalized();
        for (int plane : {0, 1}) {
            REQUIRE(by_N.is_mild(plane));
            double ends[2] = {0, 0}, middle = 0, wanted[2] = {0, 0}, wanted_middle = 0;
            by_N.add_forces(plane, sums, across, ends, middle);
            for (const auto& [f, x] : forces) {
                for (int end : {0, 1}) wanted[end] += across.dot(f) * by_N.of_force(end, plane, x);
                wanted_middle += across.dot(f) * by_N.middle_of_force(plane, x);
            }
            INFO("p " << p << ", plane " << plane);
            const double size = largest_of(std::abs(wanted[0]), std::abs(wanted[1]), std::abs(wanted_middle));
            REQUIRE(size > 0);
            for (int end : {0, 1}) CHECK(std::abs(ends[end] - wanted[end]) < 1e-10 * size);
            CHECK(std::abs(middle - wanted_middle) < 1e-10 * size);
        }
    }
    CHECK_FALSE(pair.with(-20).is_mild(0));
}

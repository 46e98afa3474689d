// The law of a section that heat has weakened: it is the law that was declared with less strength.
#include "section/softened_law.h"
#include "beam/timoshenko.h"
#include "helpers.h"
#include "section/laws/laws.h"

using namespace hinge;
using namespace hinge::beam;
using namespace hinge::test;

namespace {

constexpr double ends[2] = {-1, 1};

struct Case {
    Stiffness k;
    Vec6 p;
    FixedEnd loads;
    YieldSurface surface;
    double strength;
};

Case random_case(Dice& dice) {
    Case c;
    const double Mx = dice(1e4, 1e6), My = dice(1e4, 1e6), N = dice(1e5, 1e7), Mz = dice(1e4, 1e6);
    c.surface = {1 / (Mx * Mx), 1 / (My * My), 1 / (N * N), 1 / (Mz * Mz)};
    const double EIx = dice(1e6, 1e8), EIy = dice(1e6, 1e8), EA = dice(1e8, 1e10), GJ = dice(1e5, 1e7);
    const Rigidity r{EIx, EIy, EA, GJ, 0.2 * EA, 0.2 * EA};
    c.k = stiffness(r, dice(0.5, 5), dice(-1, 1));
    const double size = dice(0.1, 5);
    c.p << size * dice(-1, 1) * Mx, size * dice(-1, 1) * Mx, size * dice(-1, 1) * My, size * dice(-1, 1) * My,
        size * dice(-1, 1) * N, size * dice(-1, 1) * Mz;
    c.loads.add(0, dice(-0.1, 0.1) * Mx, 0, dice(-0.1, 0.1) * N, 0);
    c.strength = dice(0.02, 1);
    return c;
}

/// The surface where all fully plastic resultants are `part` of those.
YieldSurface weaker(const YieldSurface& w, double part) {
    const double by = 1 / (part * part);
    return {by * w.x, by * w.y, by * w.n, by * w.z};
}

/// The largest part by which two things differ.
template <class A>
double off(const A& a, const A& b) {
    return (a - b).norm() / (1e-300 + b.norm());
}

}  // namespace

TEST_CASE("a softened law is the law of the softer material: return, work and tangent", "[section_law][heat]") {
    Dice dice(5);
    double forces = 0, flows = 0, works = 0, tangents = 0, loads = 0;
    int flowed = 0, lost = 0;
    for (int i = 0; i < 5000; ++i) {
        const Case c = random_case(dice);
        const auto declared = paper_law(c.surface), soft = paper_law(weaker(c.surface, c.strength));
        const SoftenedLaw law(*declared, c.strength);
        const SectionConditions at(c.loads);
        const ReturnMapResult a = law.return_to_surface(c.p, c.k, ends, 2, at),
                              b = soft->return_to_surface(c.p, c.k, ends, 2, at);
        CHECK(a.converged == b.converged);
        CHECK((a.lambda[0] > 0) == (b.lambda[0] > 0));
        forces = largest_of(forces, off(a.p, b.p));
        CHECK(law.yield_function(resultants(c.p, 1)) == Approx(soft->yield_function(resultants(c.p, 1))));
        if (!b.converged) ++lost;
        if (!b.yields() || !b.converged) continue;
        ++flowed;
        // a flow that is small beside the elastic deformation is a difference of two forces
        const Vec6 elastic = c.k.solve(c.p);
        const double energy = elastic.dot(c.p);
        flows = largest_of(flows, (a.plastic - b.plastic).norm() / elastic.norm());
        works = largest_of(works, std::abs(a.dissipation - b.dissipation) / energy);
        tangents = largest_of(tangents, off(law.tangent(a, c.k, ends, 2, at), soft->tangent(b, c.k, ends, 2, at)));
        const double of_loads = soft->work_of(c.loads, b, ends, 2, at);
        loads = largest_of(loads, std::abs(law.work_of(c.loads, a, ends, 2, at) - of_loads) / energy);
    }
    CHECK(flowed > 2000);
    CHECK(lost < 100);  // both laws say of the same trials that they have found no return
    // both are solved to 1e-13 of the surface, by multipliers of other sizes
    CHECK(forces < 1e-9);
    CHECK(flows < 1e-8);
    CHECK(works < 1e-8);
    CHECK(tangents < 1e-7);
    CHECK(loads < 1e-8);
}

TEST_CASE("a law at full strength is the law itself", "[section_law][heat]") {
    Dice dice(6);
    const Case c = random_case(dice);
    const auto declared = paper_law(c.surface);
    CHECK(&*LawAt(*declared, 1) == declared.get());
    CHECK(&*LawAt(*declared, 0.5) != declared.get());
}

// Random elements whose sections have the exact interaction, of steel and of concrete, for the tests of laws.
#pragma once

#include <map>

#include "beam/timoshenko.h"
#include "helpers.h"
#include "outlines.h"
#include "section/laws/laws.h"

namespace hinge::test::sections {

using namespace beam;

inline constexpr double ends[2] = {-1, 1}, middle[1] = {0};
inline constexpr double fy = 235e6;

inline std::shared_ptr<const PlasticDomain> domain_of(int kind) {
    static std::map<int, std::shared_ptr<const PlasticDomain>> made;
    auto& known = made[kind];
    if (known) return known;
    Outline rectangular;
    rectangular.polygons = {rectangle(0.2, 0.3)};
    const Outline all[] = {rectangular, h_outline(0.3, 0.3, 0.011, 0.019), pipe_outline(0.15, 0.14),
                           angle_outline(0.2, 0.3, 0.02)};
    return known = std::make_shared<PlasticDomain>(all[kind]);
}

struct Trial {
    std::shared_ptr<const PlasticDomain> domain;
    std::unique_ptr<const SectionLaw> law;
    Vec4 strength;
    Stiffness k;
    Vec6 p;
    /// Forces of up to `size` times the strength, some of them 0.
    void load(Dice& dice, double size, double twist) {
        for (int i = 0; i < 6; ++i) {
            const double limit = i < 4 ? strength[i / 2] : i == 4 ? strength[2] : twist;
            p[i] = dice.pick(4) ? size * dice(-1, 1) * limit : 0;
        }
    }
};

/// An element of one of the shapes, and forces up to several times its strength.
inline Trial random_trial(Dice& dice, double largest) {
    Trial t;
    t.domain = domain_of(dice.pick(4));
    const double A = t.domain->area(), E = 206e9, G = E / 2.6;
    t.strength << fy * t.domain->moduli()[0], fy * t.domain->moduli()[1], fy * A,
        dice.pick(3) ? fy / std::sqrt(3.0) * 0.2 * A * std::sqrt(A) : infinite;
    t.law = exact_law(t.domain, t.strength);
    Rigidity c;
    c.EIx = E * A * 0.012 * dice(0.5, 1.5), c.EIy = E * A * 0.006 * dice(0.5, 1.5), c.EA = E * A, c.GJ = G * 0.003 * A;
    c.GAx = c.GAy = G * A * dice(0.3, 0.8);
    t.k = stiffness(c, dice(0.5, 6), dice(-1, 1));
    t.load(dice, std::exp(dice(-1, largest)), 0.3 * fy * A * std::sqrt(A));
    return t;
}

/// Concrete with bars: four in the corners, two layers of a beam, a round column, a few bars at any place, one bar.
/// From 5 on the same by their ultimate states.
inline std::shared_ptr<const PlasticDomain> concrete_of(int kind) {
    static std::map<int, std::shared_ptr<const PlasticDomain>> made;
    auto& known = made[kind];
    if (known) return known;
    Outline o;
    Reinforcement c;
    c.concrete = 28.5e6;
    if (kind >= 5) c.strains = ConcreteStrains{};
    kind %= 5;
    const auto bar = [&](double x, double y, double diameter) {
        c.bars.push_back({{x, y}, pi / 4 * diameter * diameter, 500e6, 400e6});
    };
    if (kind == 2) o.circles = {{{0, 0}, 0.25, false}};
    else o.polygons = {rectangle(0.3, 0.5)};
    if (kind == 0)
        for (int i = 0; i < 4; ++i) bar(i % 2 ? 0.1 : -0.1, i / 2 ? 0.2 : -0.2, 0.025);
    if (kind == 1)
        for (int i = 0; i < 7; ++i)
            bar(i < 3 ? 0.1 * (i - 1) : 0.07 * (i - 4.5), i < 3 ? 0.2 : -0.2, i < 3 ? 0.012 : 0.025);
    if (kind == 2)
        for (int i = 0; i < 8; ++i) bar(0.2 * std::cos(i * pi / 4), 0.2 * std::sin(i * pi / 4), 0.02);
    if (kind == 3) bar(0.1, 0.21, 0.02), bar(-0.03, -0.2, 0.03), bar(-0.12, 0.05, 0.016);
    if (kind == 4) bar(0, 0, 0.03);
    return known = std::make_shared<PlasticDomain>(o, &c);
}

/// An element of concrete, and forces up to several times its strength.
inline Trial random_concrete(Dice& dice, double largest) {
    Trial t;
    t.domain = concrete_of(dice.pick(10));
    const double A = 0.15, E = 33e9, G = E / 2.4;
    t.strength << t.domain->strength(), dice.pick(3) ? 1e5 : infinite;
    t.law = exact_law(t.domain, t.strength);
    const Rigidity c{
        E * A * 0.02 * dice(0.3, 1), E * A * 0.01 * dice(0.3, 1), E * A, G * 0.01 * A, G * A * 5 / 6, G * A * 5 / 6};
    t.k = stiffness(c, dice(0.5, 6), dice(-1, 1));
    t.load(dice, std::exp(dice(-2, largest)), 1e5);
    return t;
}

}  // namespace hinge::test::sections

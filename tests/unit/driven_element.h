// An element of a rectangular section whose deformation a test prescribes, step by step.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "beam/timoshenko.h"
#include "helpers.h"
#include "section/laws/laws.h"

namespace hinge::test::element {

using namespace hinge::beam;

inline constexpr double ends[2] = {-1, 1};
inline constexpr double fy = 250e6, E = 200e9, b = 0.1, h = 0.2, A = b * h, Ix = b * h * h * h / 12,
                        Iy = h * b * b * b / 12, J = 4e-5, length = 1.5;

inline const std::shared_ptr<const PlasticDomain> rectangle = [] {
    Outline o;
    o.polygons = {{{{-b / 2, -h / 2}, {b / 2, -h / 2}, {b / 2, h / 2}, {-b / 2, h / 2}}}};
    return std::make_shared<PlasticDomain>(o);
}();

inline const Vec4 strength(fy* b* h* h / 4, fy* h* b* b / 4, fy* A, 0.5 * fy * b * b * h / 2);

inline PlasticZone zone_of(double yields) {
    PlasticZone zone;
    zone.energy = fy * A * yields;
    zone.per_modulus = Vec4(Ix, Iy, A, J / 3).cwiseQuotient(strength.cwiseProduct(strength)) / yields;
    return zone;
}

inline std::unique_ptr<const SectionLaw> law_with(const MaterialLaws& laws, bool exact) {
    SectionMaterial material{laws, zone_of(length / 2)};
    if (exact) return exact_law(rectangle, strength, std::move(material));
    const Vec4 w = strength.cwiseProduct(strength).cwiseInverse();
    return paper_law({w[0], w[1], w[2], w[3]}, std::move(material));
}

inline Stiffness elastic(double s = 0) {
    Rigidity c;
    c.EIx = E * Ix, c.EIy = E * Iy, c.EA = E * A, c.GJ = E / 2.6 * J, c.GAx = c.GAy = E / 2.6 * A * 5 / 6;
    return stiffness(c, length, s);
}

/// An element whose deformation a test prescribes, step by step.
struct Driven {
    const SectionLaw& law;
    Stiffness k = elastic();
    Vec6 plastic = Vec6::Zero(), p = Vec6::Zero();
    std::vector<double> history;
    double temperature = room_temperature;
    bool converged = true;

    explicit Driven(const SectionLaw& of) : law(of), history(2 * std::size_t(of.history_size())) {}
    double stored() const {
        double sum = 0;
        for (int s : {0, 1}) sum += law.stored(history.data() + s * law.history_size());
        return sum;
    }
    SectionConditions conditions(double dt = 0) const {
        SectionConditions at{no_fixed_end, history.data(), dt};
        at.temperature = temperature;
        return at;
    }
    ReturnMapResult to(const Vec6& d, double dt = 0) {
        const ReturnMapResult flow = law.return_to_surface(k.times(d - plastic), k, ends, 2, conditions(dt));
        for (int s : {0, 1})
            if (law.history_size() > 0) law.commit(flow, s, dt, history.data() + s * law.history_size());
        plastic += flow.plastic, p = flow.p;
        converged = converged && flow.converged;
        return flow;
    }
};

inline Vec6 stretched(double by) { return (Vec6() << 0, 0, 0, 0, by, 0).finished(); }
/// Constant curvature about x.
inline Vec6 bent(double by) { return (Vec6() << -by / 2, by / 2, 0, 0, 0, 0).finished(); }

/// Times `size` what yields the element by itself, some parts 0.
inline Vec6 random_deformation(Dice& dice, double size) {
    const Stiffness k = elastic();
    const double scale[6] = {strength[0] / k.x11, strength[0] / k.x22,   strength[1] / k.y11,
                             strength[1] / k.y22, strength[2] / k.axial, strength[3] / k.twist};
    Vec6 d;
    for (int i = 0; i < 6; ++i) d[i] = dice.pick(4) ? size * scale[i] * dice(-1, 1) : 0;
    return d;
}

}  // namespace hinge::test::element

// An element of a rectangular section whose deformation a test prescribes, step by step.
#pragma once

#include "beam/pair_return.h"
#include "helpers.h"
#include "outlines.h"
#include "section/laws/laws.h"

namespace hinge::test::element {

using namespace hinge::beam;

inline constexpr double ends[2] = {-1, 1};
inline constexpr double fy = 250e6, E = 200e9, b = 0.1, h = 0.2, A = b * h, Ix = b * h * h * h / 12,
                        Iy = h * b * b * b / 12, J = 4e-5, length = 1.5;

inline const std::shared_ptr<const PlasticDomain> rectangle = [] {
    Outline o;
    o.polygons = {test::rectangle(b, h)};
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
    const double GA = E / 2.6 * A * 5 / 6;
    return stiffness({E * Ix, E * Iy, E * A, E / 2.6 * J, GA, GA}, length, s);
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
    /// What the deformation d would lead to.
    ReturnMapResult returned(const Vec6& d, double dt = 0) const {
        return law.return_to_surface(k.times(d - plastic), k, ends, 2, conditions(dt));
    }
    Mat6 tangent(const ReturnMapResult& flow, double dt = 0) const {
        return law.tangent(flow, k, ends, 2, conditions(dt));
    }
    ReturnMapResult to(const Vec6& d, double dt = 0) {
        const ReturnMapResult flow = returned(d, dt);
        for (int s : {0, 1})
            if (law.history_size() > 0) law.commit(flow, s, dt, history.data() + s * law.history_size());
        plastic += flow.plastic, p = flow.p;
        converged = converged && flow.converged;
        return flow;
    }
};

/// The same of the two elements of a pair, between points of Gauss.
struct DrivenPair {
    const SectionLaw& law;
    std::vector<double> history;
    SectionConditions at[2];
    ElasticPair pair;
    Vec6 d[2] = {Vec6::Zero(), Vec6::Zero()}, plastic[2] = {Vec6::Zero(), Vec6::Zero()};

    /// The outer ends are those of the member.
    explicit DrivenPair(const SectionLaw& of)
        : law(of),
          history(4 * std::size_t(of.history_size())),
          pair{kind(), {elastic(gauss_point), elastic(-gauss_point)}} {
        for (int i : {0, 1}) {
            at[i].history = section(i, 0);
            for (int s : {0, 1}) law.start(i == s, section(i, s));
        }
    }
    DrivenPair(const DrivenPair&) = delete;
    static PairKind<double> kind() {
        const double GA = E / 2.6 * A * 5 / 6;
        return pair_kind({E * Ix, E * Iy, E * A, E / 2.6 * J, GA, GA}, length);
    }
    double* section(int element, int s) { return history.data() + (2 * element + s) * law.history_size(); }
    /// Moves both elements on, by `flow`. False: it is not found, and nothing has changed.
    bool move(const Vec6 (&by)[2], double dt, ReturnMapResult (&flow)[2]) {
        const Vec6 trial[2] = {d[0] + by[0] - plastic[0], d[1] + by[1] - plastic[1]};
        for (SectionConditions& of : at) of.dt = dt;
        if (!return_to_surface(pair, trial, law, flow, 1e-11, at)) return false;
        for (int i : {0, 1}) {
            d[i] += by[i], plastic[i] += flow[i].plastic;
            for (int s : {0, 1}) law.commit(flow[i], s, dt, section(i, s));
        }
        return true;
    }
};

inline Vec6 stretched(double by) { return by * Vec6::Unit(4); }
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

/// What steps of any size show: how far forces are from the surface as the committed history has it, where a section
/// flows, or beyond it; and the least dissipation, plastic work less what is stored, as a part.
struct RandomPaths {
    double off = 0, least = 0;
    long flows = 0, lost = 0;

    void walk(Driven& element, Dice& dice, bool heats = false) {
        Vec6 d = Vec6::Zero();
        double step = 0.1;
        for (int i = 0; i < 200; ++i) {
            if (dice.pick(10) == 0) step = std::exp(dice(-6, 3));
            if (heats && dice.pick(5) == 0) element.temperature = dice(20, 500);
            d += random_deformation(dice, step);
            const double stored = element.stored();
            const ReturnMapResult flow = element.to(d);
            lost += !flow.converged, flows += flow.flows();
            least = smallest_of(
                least, (flow.dissipation - (element.stored() - stored)) / (1 + std::abs(flow.dissipation) + stored));
            for (int s : {0, 1}) {
                const double* history = element.history.data() + s * element.law.history_size();
                const double f =
                    element.law.yield_function(resultants(flow.p, ends[s]), history, element.temperature) - 1;
                off = largest_of(off, flow.lambda[s] > 0 ? std::abs(f) : f);
            }
        }
    }
    /// 1e-8, as without a law of the material.
    void check(long least_flows) const {
        CHECK(flows > least_flows);
        CHECK(lost == 0);
        CHECK_FIGURE("beyond the surface", off, 1e-8);
        CHECK_FIGURE("negative dissipation", -least, 1e-10);
    }
};

}  // namespace hinge::test::element

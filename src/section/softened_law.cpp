#include "section/softened_law.h"

namespace hinge::beam {
namespace {

FixedEnd times(double factor, FixedEnd f) {
    for (double& m : f.moment) m *= factor;
    for (int i : {0, 1}) f.N[i] *= factor, f.Mz[i] *= factor;
    return f;
}

/// Conditions at a temperature, with the fixed-end forces times a factor.
class ScaledConditions {
public:
    ScaledConditions(double factor, const SectionConditions& at, double temperature)
        : fixed_end_(times(factor, *at.fixed_end)), at_(fixed_end_, at.history, at.dt) {
        at_.temperature = temperature, at_.held = at.held;
    }
    ScaledConditions(const ScaledConditions&) = delete;
    operator const SectionConditions&() const { return at_; }

private:
    FixedEnd fixed_end_;
    SectionConditions at_;
};

/// Forces and works of a flow times a factor; its deformations stay.
template <class Flow>
Flow times(double factor, Flow f) {
    f.p *= factor;
    for (double& half_work : f.lambda) half_work *= factor;
    f.path_work *= factor, f.potential *= factor;
    if constexpr (std::is_same_v<Flow, ReturnMapResult>) f.dissipation *= factor;
    return f;
}

}  // namespace

SoftenedLaw::SoftenedLaw(const SectionLaw& law, double strength, double temperature)
    : SectionLaw(law.screen()), law_(law), strength_(strength), temperature_(temperature) {}

bool SoftenedLaw::surely_elastic(const Vec6& p, const double* sections, int n, const SectionConditions& at) const {
    return law_.surely_elastic(p / strength_, sections, n, ScaledConditions(1 / strength_, at, temperature_));
}

ReturnMapResult SoftenedLaw::return_to_surface(const Vec6& trial, const Stiffness& k, const double* sections, int n,
                                               const SectionConditions& at) const {
    const double up = 1 / strength_;
    return times(strength_,
                 law_.return_to_surface(up * trial, up * k, sections, n, ScaledConditions(up, at, temperature_)));
}

ElementFlow SoftenedLaw::return_alone(const Vec6& trial, const Stiffness& k, const SectionConditions& at,
                                      const ElementFlow& before) const {
    const double up = 1 / strength_;
    return times(strength_,
                 law_.return_alone(up * trial, up * k, ScaledConditions(up, at, temperature_), times(up, before)));
}

bool SoftenedLaw::next_round(const ElementFlow& flow, const SectionConditions& at, double tolerance,
                             HeldRound& held) const {
    const double up = 1 / strength_;
    return law_.next_round(times(up, flow), ScaledConditions(up, at, temperature_), tolerance, held);
}

double SoftenedLaw::work_of(const FixedEnd& part, const ElementFlow& flow, const double* sections, int n,
                            const SectionConditions& at) const {
    const double up = 1 / strength_;
    return strength_ *
           law_.work_of(times(up, part), times(up, flow), sections, n, ScaledConditions(up, at, temperature_));
}

Mat6 SoftenedLaw::tangent(const ElementFlow& flow, const Stiffness& k, const double* sections, int n,
                          const SectionConditions& at) const {
    const double up = 1 / strength_;
    return strength_ * law_.tangent(times(up, flow), up * k, sections, n, ScaledConditions(up, at, temperature_));
}

Mat12 SoftenedLaw::pair_tangent(const Mat12& elastic, const ElementFlow* const (&flow)[2],
                                const SectionConditions* at) const {
    const double up = 1 / strength_;
    ElementFlow scaled[2];
    const ElementFlow* flows[2] = {nullptr, nullptr};
    for (int i : {0, 1})
        if (flow[i]) scaled[i] = times(up, *flow[i]), flows[i] = &scaled[i];
    const ScaledConditions first(up, at[0], temperature_), second(up, at[1], temperature_);
    const SectionConditions both[2] = {first, second};
    return strength_ * law_.pair_tangent(up * elastic, flows, both);
}

}  // namespace hinge::beam

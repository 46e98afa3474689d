// The law of a section whose strength is a part of that of the declared material, as heat leaves it.
#pragma once

#include <optional>

#include "section/section_law.h"

namespace hinge::beam {

/// Another law at a temperature, with all its stresses times `strength`, hardening and backbone with them. Forces and
/// stiffnesses are divided by it before that law is asked; deformations, and with them the history, are the same.
class SoftenedLaw : public SectionLaw {
public:
    SoftenedLaw(const SectionLaw& law, double strength, double temperature = room_temperature);

    const char* name() const override { return law_.name(); }
    bool forms_pairs() const override { return law_.forms_pairs(); }
    double slack(const double* history) const override { return law_.slack(history); }
    double yield_function(const Vec4& q, const double* history = nullptr, double = room_temperature) const override {
        return law_.yield_function(q / strength_, history, temperature_);
    }
    bool surely_elastic(const Vec6& p, const double* sections, int n, const SectionConditions& at) const override;
    ReturnMapResult return_to_surface(const Vec6& trial, const Stiffness& k, const double* sections, int n,
                                      const SectionConditions& at) const override;
    ElementFlow return_alone(const Vec6& trial, const Stiffness& k, const SectionConditions& at,
                             const ElementFlow& before) const override;
    bool in_rounds() const override { return law_.in_rounds(); }
    bool next_round(const ElementFlow& flow, const SectionConditions& at, double tolerance,
                    HeldRound& held) const override;
    double work_of(const FixedEnd& part, const ElementFlow& flow, const double* sections, int n,
                   const SectionConditions& at) const override;
    Mat6 tangent(const ElementFlow& flow, const Stiffness& k, const double* sections, int n,
                 const SectionConditions& at) const override;
    Mat12 pair_tangent(const Mat12& elastic, const ElementFlow* const (&flow)[2],
                       const SectionConditions* at) const override;

private:
    const SectionLaw& law_;
    double strength_, temperature_;
};

/// A law at such a strength and temperature (degrees Celsius); the law itself where it has all its strength and is not
/// heated.
class LawAt {
public:
    LawAt(const SectionLaw& law, double strength, double temperature = room_temperature) : law_(&law) {
        if (strength != 1 || temperature != room_temperature) law_ = &softened_.emplace(law, strength, temperature);
    }
    LawAt(const LawAt&) = delete;
    const SectionLaw* operator->() const { return law_; }
    const SectionLaw& operator*() const { return *law_; }

private:
    std::optional<SoftenedLaw> softened_;
    const SectionLaw* law_;
};

}  // namespace hinge::beam

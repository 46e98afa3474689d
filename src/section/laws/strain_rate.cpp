// Effect of the strain rate: the yield stress times 1 + (rate / D)^(1/q) (Cowper and Symonds 1957), or times
// 1 + C ln(rate / reference) (Johnson and Cook 1983), with ln(x) taken as ln(1 + x^2) / 2. That has no corner at the
// reference rate, below which it tends to 0; at ten times that rate it is 0.005 more. The rate is that of the section's
// mean plastic strain, over the part of the element that yields with it. Statics has none.
#include <cmath>

#include "core/errors.h"
#include "core/text.h"
#include "section/laws/laws.h"

namespace hinge::beam {
namespace {

class CowperSymonds : public MaterialLaw {
public:
    CowperSymonds(double D, double q) : D_(D), q_(q) {}
    const char* name() const override { return "strain rate"; }
    std::string words() const override {
        return "strain rate (Cowper and Symonds, D = " + number_text(D_) + " 1/s, q = " + number_text(q_) + ")";
    }
    void save(Writer& to) const override { to(D_, q_, 0.0, 0.0); }
    bool follows_rate() const override { return true; }
    Factor factor(const double*, double strain, const Moment& at) const override {
        const double dt = at.dt;
        if (!(dt > 0 && strain > 0)) return {};
        const double more = std::pow(strain / (dt * D_), 1 / q_);
        return {1 + more, more / (q_ * strain)};
    }
    Integrals integrals(double strain, double dt) const override {
        if (!(dt > 0 && strain > 0)) return {};
        const double more = std::pow(strain / (dt * D_), 1 / q_);
        return {more * strain / (1 + 1 / q_), more * strain * strain / (2 + 1 / q_)};
    }

private:
    double D_, q_;
};

class JohnsonCook : public MaterialLaw {
public:
    JohnsonCook(double C, double reference) : C_(C), reference_(reference) {}
    const char* name() const override { return "strain rate"; }
    std::string words() const override {
        return "strain rate (Johnson and Cook, C = " + number_text(C_) + " beyond " + number_text(reference_) + " 1/s)";
    }
    void save(Writer& to) const override { to(0.0, 0.0, C_, reference_); }
    bool follows_rate() const override { return true; }
    Factor factor(const double*, double strain, const Moment& at) const override {
        const double dt = at.dt;
        if (!(dt > 0 && strain > 0)) return {};
        const double x = strain / (dt * reference_), square = x * x;
        return {1 + C_ / 2 * std::log1p(square), C_ / strain * (square / (1 + square))};
    }
    Integrals integrals(double strain, double dt) const override {
        if (!(dt > 0 && strain > 0)) return {};
        const double unit = dt * reference_, x = strain / unit, log = std::log1p(x * x);
        return {C_ / 2 * unit * (x * log - 2 * (x - std::atan(x))), C_ / 4 * unit * unit * ((1 + x * x) * log - x * x)};
    }

private:
    double C_, reference_;
};

}  // namespace

std::shared_ptr<const MaterialLaw> strain_rate_law(const StrainRate& r) {
    const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
    if (positive(r.D) && positive(r.q)) return std::make_shared<CowperSymonds>(r.D, r.q);
    if (positive(r.C) && positive(r.reference)) return std::make_shared<JohnsonCook>(r.C, r.reference);
    throw InputError(
        "rate needs D (1/s) and q of Cowper and Symonds, or C and reference (1/s) of Johnson and Cook; all above 0");
}

}  // namespace hinge::beam

// Members that carry tension alone (cables, slender braces) or compression alone (props, bearings).
//
// With n the axial force in the sense that is carried and d the elongation in that sense, a member that does not yield
// has n = max(0, k d): where it would carry the other sign it changes its length without force, and it carries again at
// the length where it lost its force. That change of length, the slack u <= 0, is part of the plastic elongation and
// the law's history variable. In a step it changes by x, by the rules
//
//   n = n_trial - k x >= 0,    u + x <= 0,    n (u + x) = 0
//
// so that x is the smaller of n_trial / k and -u. Slack takes no work. Beyond N0 the member yields at constant n, and
// that elongation y is apart from the slack: it moves the length at which the member carries again.
//
// N is that in the middle of the element, without the fixed-end parts of loads along it, which differ in sign at its
// two ends. So half of the load of a slack element presses on the node at its slack end (plasticity.cpp warns). A law
// that is slack at n = q l / 2 would let all of it hang from the other end. But in dynamics inertia too decides what
// hangs from where: with that law a cable catches a mass with 15 % too much force.
//
// Bending and torsion are elastic, by the section's own stiffness: a slack member keeps a small stiffness
// across its axis, so that statics has an equilibrium to go to, and its masses have a shape. The elements do not form
// pairs whose bending depends on N: the stiffness that N gives across the axis is that of the chords of the elements.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/text.h"
#include "section/laws/laws.h"

namespace hinge::beam {
namespace {

/// Whether an axial force is admissible is asked for every force but zero.
constexpr YieldSurface all_forces = {0, 0, 1e200, 0};

class OneWay : public SectionLaw {
public:
    OneWay(int sign, double N0) : SectionLaw(all_forces), sign_(sign), N0_(N0) {}

    const char* name() const override { return sign_ > 0 ? "tension only" : "compression only"; }
    std::string words() const override {
        return name() + (std::isfinite(N0_) ? ", yields at " + number_text(N0_) + " N" : std::string());
    }
    bool forms_pairs() const override { return false; }

    /// The slack, m, with the sign of the elongation.
    int history_size() const override { return 1; }
    void commit(const ElementFlow& flow, int, double, double* history) const override { *history += flow.slack; }
    double slack(const double* history) const override { return *history; }

    double yield_function(const Vec4& q, const double*, double) const override {
        const double part = std::max(0.0, sign_ * q[2]) / N0_;
        return part * part;
    }
    bool surely_elastic(const Vec6& p, const double*, int, const SectionConditions& at) const override {
        const double n = sign_ * p[4];
        return n >= 0 && n <= N0_ && left(at) == 0;
    }

    ReturnMapResult return_to_surface(const Vec6& trial, const Stiffness& k, const double*, int count,
                                      const SectionConditions& at) const override {
        ReturnMapResult out;
        out.p = trial;
        const double n_trial = sign_ * trial[4], available = left(at), wanted = n_trial / k.axial;
        if (std::isnan(n_trial)) return out.converged = false, out;
        const double x = std::min(wanted, available);
        double n = wanted > available ? n_trial - k.axial * x : 0, y = 0;
        if (n > N0_) y = (n - N0_) / k.axial, n = N0_;
        out.slack = sign_ * x;
        out.plastic[4] = sign_ * (x + y);
        out.p[4] = sign_ * n;
        out.dissipation = n * y;
        for (int i = 0; i < count; ++i) {
            out.lambda[i] = 0.5 * out.dissipation / count;
            out.section[i][2] = sign_ * y / count;
        }
        return out;
    }
    ElementFlow return_alone(const Vec6& trial, const Stiffness& k, const SectionConditions& at,
                             const ElementFlow&) const override {
        constexpr double ends[2] = {-1, 1};
        return return_to_surface(trial, k, ends, 2, at);
    }
    double work_of(const FixedEnd&, const ElementFlow&, const double*, int, const SectionConditions&) const override {
        return 0;
    }
    /// No axial stiffness where it is slack or yields.
    Mat6 tangent(const ElementFlow& flow, const Stiffness& k, const double*, int,
                 const SectionConditions&) const override {
        Mat6 K = k.matrix();
        if (flow.yields() || (flow.slack != 0 && flow.p[4] == 0)) K(4, 4) = 0;
        return K;
    }
    Mat12 pair_tangent(const Mat12&, const ElementFlow* const (&)[2], const SectionConditions*) const override {
        throw std::logic_error("members that carry one sign of N form no pairs");
    }

private:
    /// Slack that the member gives back before it carries, m.
    double left(const SectionConditions& at) const { return at.history ? -sign_ * at.history[0] : 0; }

    int sign_;
    double N0_;
};

}  // namespace

std::unique_ptr<const SectionLaw> one_way_law(int sign, double N0) { return std::make_unique<OneWay>(sign, N0); }

}  // namespace hinge::beam

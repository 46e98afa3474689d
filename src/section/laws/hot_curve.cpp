// The stress of hot steel over its strain, EN 1993-1-2, 3.2.1 and figure 3.1: elastic up to the proportional limit,
// then a part of an ellipse up to the yield stress at a strain of 2 %, which it keeps. The yield surface of a section
// is that of the yield stress times the stress of the curve at the section's mean plastic strain so far, over the yield
// stress. In tension that is exact. In bending fibres strain unequally.
//
// What is declared as the yield stress is that at 2 %, at each temperature (k_y). Falls of the stress beyond a strain
// of 15 %, which the standard has too, are left out.
#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "section/laws/laws.h"

namespace hinge::beam {
namespace {

constexpr double yields_at = 0.02;  ///< strain where the ellipse ends
constexpr double upright = 1e-7;    ///< plastic strain up to which a chord stands for the ellipse, which begins upright
constexpr double short_way = 0.1;   ///< over the plastic strain where it begins: there Gauss and Legendre's points do
constexpr double place[5] = {0.04691007703066802, 0.23076534494715845, 0.5, 0.7692346550528415, 0.9530899229693319},
                 weight[5] = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444, 0.23931433524968324,
                              0.11846344252809454};
constexpr double straight = 1e-9;  ///< a proportional limit above 1 less this part of the yield stress: no ellipse

/// The curve of one temperature. Stresses are parts of its yield stress.
class Ellipse {
public:
    /// `proportional`: the proportional limit; `stiffness`: E over the yield stress.
    Ellipse(double proportional, double stiffness) : first_(proportional), E_(stiffness) {
        const double wide = yields_at - first_ / E_, high = 1 - first_;
        if (!(high > straight)) return;
        const double c = high * high / (wide * E_ - 2 * high);
        a2_ = wide * (wide + c / E_), b2_ = c * wide * E_ + c * c, low_ = first_ - c;
        chord_ = (on_ellipse(upright).value - first_) / upright;
    }
    /// The stress at a plastic strain, and its slope over that: the strain, (stress / E) + p, is put into the equation
    /// of the ellipse.
    MaterialLaw::Factor at(double p) const {
        if (a2_ == 0 || p >= yields_at - 1 / E_) return {1, 0};
        if (p < upright) return {first_ + p * chord_, chord_};
        return on_ellipse(p);
    }
    /// The mean stress from one plastic strain to another.
    double mean(double from, double to) const {
        const double last = yields_at - 1 / E_;
        if (a2_ == 0 || from >= last) return 1;
        if (to > last) return (mean(from, last) * (last - from) + (to - last)) / (to - from);
        if (to - from <= short_way * from || to <= upright) {  // the difference of two integrals would have few digits
            double sum = 0;
            for (int i = 0; i < 5; ++i) sum += weight[i] * at(from + place[i] * (to - from)).value;
            return sum;
        }
        if (from < upright) return (mean(from, upright) * (upright - from) + work(upright, to)) / (to - from);
        return work(from, to) / (to - from);
    }

private:
    /// Integral of the stress of the ellipse over the plastic strain: that over the strain, less the elastic part.
    double work(double from, double to) const {
        const double a = std::sqrt(a2_), per_t = std::sqrt(b2_) / a, first = on_ellipse(from).value,
                     last = on_ellipse(to).value;
        const auto area = [&](double t) {
            return 0.5 * (t * std::sqrt(std::max(0.0, a2_ - t * t)) + a2_ * std::asin(std::clamp(t / a, -1.0, 1.0)));
        };
        const double t1 = yields_at - from - first / E_, t2 = yields_at - to - last / E_;
        return low_ * (t1 - t2) + per_t * (area(t1) - area(t2)) - 0.5 * (last * last - first * first) / E_;
    }
    MaterialLaw::Factor on_ellipse(double p) const {
        const double u = yields_at - p - low_ / E_, A = a2_ / b2_ + 1 / (E_ * E_),
                     root = std::sqrt(std::max(0.0, u * u / (E_ * E_) - A * (u * u - a2_))), y = (u / E_ + root) / A;
        const double steepest = 1e3 * E_;  // it begins upright
        return {low_ + y, std::min(steepest, (u - y / E_) / std::max(root, 1e-300))};
    }

    double first_, E_, a2_ = 0, b2_ = 0, low_ = 0, chord_ = 0;
};

class HotCurveLaw : public MaterialLaw {
public:
    HotCurveLaw(std::vector<HotCurvePoint> points, double stiffness) : points_(std::move(points)), E_(stiffness) {
        // the ratio of two straight lines has no least value between their ends
        for (const HotCurvePoint& p : points_) least_ = std::min(least_, p.proportional / p.yield);
    }
    const char* name() const override { return "hot curve"; }
    std::string words() const override { return "curve of EN 1993-1-2"; }
    void save(Writer& to) const override {
        to(E_);
        for (const HotCurvePoint& p : points_) to(p.temperature, p.yield, p.proportional, p.stiffness);
    }
    int history_size() const override { return 1; }  ///< the mean plastic strain so far
    double initial() const override { return least_; }
    Factor factor(const double* history, double strain, const Moment& now) const override {
        return curve_at(now.temperature).at((history ? history[0] : 0) + strain);
    }
    double mean_factor(const double* history, double strain, const Moment& now) const override {
        const double before = history ? history[0] : 0;
        return curve_at(now.temperature).mean(before, before + strain);
    }
    void commit(const PlasticZone&, const Vec4&, double strain, double, double* history) const override {
        history[0] += strain;
    }

private:
    Ellipse curve_at(double temperature) const {
        const auto after = std::upper_bound(points_.begin(), points_.end(), temperature,
                                            [](double t, const HotCurvePoint& p) { return t < p.temperature; });
        const HotCurvePoint &b = after == points_.end() ? points_.back() : *after,
                            &a = after == points_.begin() ? b : *(after - 1);
        const double part = &a == &b ? 0 : (temperature - a.temperature) / (b.temperature - a.temperature);
        const auto between = [&](double x, double y) { return x + std::clamp(part, 0.0, 1.0) * (y - x); };
        const double yield = between(a.yield, b.yield);
        return {between(a.proportional, b.proportional) / yield, E_ * between(a.stiffness, b.stiffness) / yield};
    }

    std::vector<HotCurvePoint> points_;
    double E_, least_ = 1;
};

}  // namespace

std::shared_ptr<const MaterialLaw> hot_curve_law(std::vector<HotCurvePoint> points, double E, double yield_stress) {
    const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
    double last = -INFINITY;
    for (const HotCurvePoint& p : points) {
        if (!(std::isfinite(p.temperature) && p.temperature > last))
            throw InputError("hot_curve: its temperatures must rise from point to point");
        if (!(positive(p.yield) && positive(p.proportional) && positive(p.stiffness) && p.proportional <= p.yield))
            throw InputError(
                "hot_curve: yield, proportional and stiffness must be above 0, and proportional no more "
                "than yield");
        const double high = (p.yield - p.proportional) * yield_stress / (p.stiffness * E);
        if (!(yields_at - p.proportional * yield_stress / (p.stiffness * E) > 2 * high))
            throw InputError(
                "hot_curve: there is no ellipse up to a strain of 2 %: the yield stress is too large "
                "beside E");
        last = p.temperature;
    }
    if (points.empty()) throw InputError("hot_curve needs a point or more");
    return std::make_shared<HotCurveLaw>(std::move(points), E / yield_stress);
}

}  // namespace hinge::beam

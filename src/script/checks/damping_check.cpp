#include "script/checks/damping_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/text.h"
#include "effects/all_effects.h"
#include "effects/damping.h"

namespace hinge::script {
namespace {

/// Of what was asked for at two periods. Between them the ratio falls to 0.5 where one is 14 times the other.
constexpr double too_much = 1.5, too_little = 0.5;

/// The smallest and largest coefficients among a body's elements: its modes lie between.
struct FrequencyRange {
    double alpha[2] = {std::numeric_limits<double>::infinity(), 0}, beta[2] = {alpha[0], 0};
    double ratio(int side, double w) const { return 0.5 * (alpha[side] / w + beta[side] * w); }
};

/// Calls f(element) for the elements of the body that these nodes make up.
template <class F>
void for_each_element(const Structure& structure, const std::vector<int>& nodes, F f) {
    for (const int n : nodes)
        for (const int e : structure.elements_at(n))
            if (structure.elements()[e].node[0] == n) f(e);
}

FrequencyRange range_of(const Structure& structure, const std::vector<int>& nodes) {
    FrequencyRange range;
    const std::vector<ElementDamping> damping = damping_of(structure);
    if (damping.empty()) return {{0, 0}, {0, 0}};
    for_each_element(structure, nodes, [&](int e) {
        range.alpha[0] = std::min(range.alpha[0], damping[e].of_mass);
        range.alpha[1] = std::max(range.alpha[1], damping[e].of_mass);
        range.beta[0] = std::min(range.beta[0], damping[e].of_stiffness);
        range.beta[1] = std::max(range.beta[1], damping[e].of_stiffness);
    });
    return range;
}

std::string percent(double ratio) { return number_text(100 * ratio, 3); }

}  // namespace

std::string damping_ratios(const Structure& structure, const std::vector<int>& nodes,
                           const std::vector<double>& frequencies) {
    const FrequencyRange range = range_of(structure, nodes);
    if (frequencies.empty() || (range.alpha[1] == 0 && range.beta[1] == 0)) return "";
    std::string text;
    for (const double w : frequencies) {
        const std::string least = percent(range.ratio(0, w)), most = percent(range.ratio(1, w));
        text += (text.empty() ? "" : ", ") + (least == most ? most : least + " to " + most);
    }
    return "; damping ratios " + text + " %";
}

std::optional<Warning> damped_otherwise(const Structure& structure, const std::vector<int>& nodes,
                                        const std::vector<double>& frequencies, const std::string& body) {
    const std::vector<Damping>& declared = structure.model().declared<Damping>(damping_effect);
    if (declared.empty() || frequencies.empty()) return {};
    int by = -1;  // the one declaration that damps the body
    bool alike = true;
    for_each_element(structure, nodes, [&](int e) {
        int of = -1;
        for (int d = 0; d < int(declared.size()); ++d)
            if (declared[d].group < 0 || structure.in_group(e, declared[d].group)) of = d;
        alike = alike && of >= 0 && (by < 0 || by == of);
        by = of;
    });
    if (!alike || by < 0 || !(declared[by].period[0] > 0)) return {};
    const Damping& d = declared[by];
    const double w = frequencies[0], T = 2 * std::numbers::pi / w, has = 0.5 * (d.alpha / w + d.beta * w),
                 most = std::max(d.ratio[0], d.ratio[1]), least = std::min(d.ratio[0], d.ratio[1]);
    if (has <= too_much * most && has >= too_little * least) return {};
    const auto two = [](double a, double b) { return "{ " + number_text(a, 3) + ", " + number_text(b, 3) + " } s"; };
    const double low = std::min(d.period[0], d.period[1]), high = std::max(d.period[0], d.period[1]);
    const bool hertz = T < low && T >= 0.5 / high && T <= 2 / low;
    return Warning{
        "the longest natural period of the " + body + " is " + number_text(T, 3) +
            " s, where model:damping has a ratio of " + percent(has) + " %; it asks for " + percent(d.ratio[0]) +
            (most == least ? "" : " and " + percent(d.ratio[1])) + " % at the periods " + two(d.period[0], d.period[1]),
        hertz
            ? "are these frequencies in Hz? Then the periods are " + two(1 / d.period[0], 1 / d.period[1])
            : "give periods in s between which the modes of interest lie, the longest near " + number_text(T, 3) + " s",
        structure.model().asked_at(damping_effect)};
}

}  // namespace hinge::script

#include "advice/damping_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/text.h"
#include "effects/all_effects.h"
#include "effects/damping.h"

namespace hinge {
namespace {

/// Of what was asked for at two periods. Between them the ratio falls to 0.5 where one is 14 times the other.
constexpr double too_much = 1.5, too_little = 0.5;

/// Calls f(element) for the elements of the body that these nodes make up.
template <class F>
void for_each_element(const Structure& structure, const std::vector<int>& nodes, F f) {
    for (const int n : nodes)
        for (const int e : structure.elements_at(n))
            if (structure.elements()[e].node[0] == n) f(e);
}

std::string percent(double ratio) { return number_text(100 * ratio, 3); }

}  // namespace

std::string damping_ratios(const std::vector<DampedMode>& modes) {
    const auto damped = [](const DampedMode& m) { return m.ratio != 0; };
    if (std::none_of(modes.begin(), modes.end(), damped)) return "";
    std::string text;
    for (const DampedMode& m : modes) text += (text.empty() ? "" : ", ") + percent(m.ratio);
    return "; damping ratios " + text + " %";
}

std::optional<Warning> damped_otherwise(const Structure& structure, const std::vector<int>& nodes,
                                        const std::vector<DampedMode>& modes, const std::string& body) {
    const std::vector<Damping>& declared = structure.model().declared<Damping>(damping_effect);
    if (declared.empty() || modes.empty()) return {};
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
    const double T = 2 * std::numbers::pi / modes[0].frequency, has = modes[0].ratio,
                 most = std::max(d.ratio[0], d.ratio[1]), least = std::min(d.ratio[0], d.ratio[1]);
    if (has <= too_much * most && has >= too_little * least) return {};
    const auto two = [](double a, double b) { return "{ " + number_text(a, 3) + ", " + number_text(b, 3) + " } s"; };
    const double low = std::min(d.period[0], d.period[1]), high = std::max(d.period[0], d.period[1]);
    const bool hertz = T < low && T >= 0.5 / high && T <= 2 / low;
    return Warning{
        Warning::Kind::damping,
        "the longest natural period of the " + body + " is " + number_text(T, 3) +
            " s, where model:damping has a ratio of " + percent(has) + " %; it asks for " + percent(d.ratio[0]) +
            (most == least ? "" : " and " + percent(d.ratio[1])) + " % at the periods " + two(d.period[0], d.period[1]),
        hertz
            ? "are these frequencies in Hz? Then the periods are " + two(1 / d.period[0], 1 / d.period[1])
            : "give periods in s between which the modes of interest lie, the longest near " + number_text(T, 3) + " s",
        structure.model().asked_at(damping_effect)};
}

}  // namespace hinge

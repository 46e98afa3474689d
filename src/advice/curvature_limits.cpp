#include "advice/curvature_limits.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "effects/fracture.h"

namespace hinge {
namespace {

struct Lengths {
    double least = 0, most = 0;  ///< m
    bool yielded = false;
};

std::string as_rotation(const char* name, double limit, const Lengths& of) {
    const bool equal = of.most <= (1 + 1e-6) * of.least;
    const auto text = [](double least, double most, bool one) {
        return number_text(least, 3) + (one ? "" : " to " + number_text(most, 3));
    };
    return std::string(name) + " = " + number_text(limit, 3) + " 1/m is a hinge rotation of " +
           text(limit * of.least, limit * of.most, equal) + " rad over an element of " +
           text(of.least, of.most, equal) + " m";
}

}  // namespace

void name_curvature_limits(const Structure& structure, const State* state, std::vector<Warning>& list) {
    const auto& rules = fracture_rules(structure.model());
    if (std::none_of(rules.begin(), rules.end(), [](const FractureRule& r) {
            return std::isfinite(r.curvature_x) || std::isfinite(r.curvature_y);
        }))
        return;
    std::vector<Lengths> lengths(rules.size());
    int member = -1, rule = -1;
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        const Element& e = structure.elements()[i];
        if (e.member != member)
            member = e.member, rule = fracture_rule_of(rules, structure.model().members()[std::size_t(member)]);
        if (rule < 0 || !e.law) continue;
        Lengths& of = lengths[std::size_t(rule)];
        of.least = of.most > 0 ? std::min(of.least, e.length) : e.length;
        of.most = std::max(of.most, e.length);
        of.yielded = of.yielded || !state || state->yielded[i] != 0;
    }
    for (std::size_t i = 0; i < rules.size(); ++i) {
        const FractureRule& r = rules[i];
        const double limit = std::min(r.curvature_x, r.curvature_y);
        if (!lengths[i].yielded || !std::isfinite(limit)) continue;
        std::string text;
        if (std::isfinite(r.curvature_x)) text = as_rotation("curvature_x", r.curvature_x, lengths[i]);
        if (std::isfinite(r.curvature_y) && r.curvature_y != r.curvature_x)
            text += (text.empty() ? "" : ", and ") + as_rotation("curvature_y", r.curvature_y, lengths[i]);
        list.push_back({Warning::Kind::fracture,
                        "model:fracture" + (r.asked_at.empty() ? "" : " of " + r.asked_at) + ": " + text +
                            "; it follows the elements' length",
                        "limits that do not: hinge_rotation_x, hinge_rotation_y (rad)"});
    }
}

}  // namespace hinge

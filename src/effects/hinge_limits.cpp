#include "effects/hinge_limits.h"

#include <algorithm>
#include <cmath>

namespace hinge {
namespace {

/// Parts that differ by less than this are equal, for rounding not to choose what breaks: the first one does.
constexpr double equal_parts = 1e-6;

/// True if `other` is larger than `one` by more than rounding; of equal ones the first in order is the larger.
bool is_larger(double other, double one, bool first) {
    return first ? other >= (1 - equal_parts) * one : other > (1 + equal_parts) * one;
}

bool same_strength(const Element& a, const Element& b) {
    return a.yield.x == b.yield.x && a.yield.y == b.yield.y && a.yield.n == b.yield.n;
}

}  // namespace

const PlasticIncrement* HingeLimits::flow_of(int element) const {
    const auto at = std::lower_bound(w_.yielding.begin(), w_.yielding.end(), element,
                                     [](const PlasticIncrement& y, int e) { return y.element < e; });
    return at != w_.yielding.end() && at->element == element && at->flow.yields() ? &*at : nullptr;
}

bool HingeLimits::flows(int element, int end) const {
    const PlasticIncrement* y = flow_of(element);
    return y && (w_.structure.conventional() || y->flow.lambda[end - 1] > 0);
}

/// The element's part in the motion of the hinge at its end, with that of this step.
HingeMotion HingeLimits::own(int element, int end) const {
    HingeMotion out = motion_of(w_.structure, w_.state.data.find<HingeRecords>(hinge_records), element, end);
    if (!flows(element, end)) return out;
    const HingePart part = part_of(w_.structure, *flow_of(element), w_.structure.conventional() ? 0 : end);
    return out += {{part.rotation[0], part.rotation[1]}, part.elongation};
}

/// The element end that has the same hinge.
std::optional<HingeLimits::End> HingeLimits::other_side(int element, int end) const {
    if (w_.structure.conventional()) return {};
    const auto& elements = w_.structure.elements();
    const Element& e = elements[element];
    const int node = e.node[end - 1];
    const auto at = w_.structure.elements_at(node);
    if (at.size() != 2) return {};
    const int other = at[0] == element ? at[1] : at[0];
    const Element& o = elements[other];
    if (w_.state.broken[other]) return {};
    if (o.member != e.member && (rule_of(element) != rule_of(other) || !same_strength(e, o))) return {};
    return End{other, o.node[0] == node ? 1 : 2};
}

/// Rotation of the node against the element, in the axes of the start.
Vec3 HingeLimits::in_space(const HingeMotion& motion, const End& of) const {
    const double sign = of.end == 1 ? -1 : 1;
    return w_.structure.elements()[of.element].axes * Vec3(sign * motion.rotation[0], sign * motion.rotation[1], 0);
}

HingeLimits::Rotation HingeLimits::rotation(const End& of) const {
    const HingeMotion mine = own(of.element, of.end);
    Rotation out{{mine.rotation[0], mine.rotation[1]}};
    const std::optional<End> other = other_side(of.element, of.end);
    if (!other) return out;
    const HingeMotion theirs = own(other->element, other->end);
    const Element& e = w_.structure.elements()[of.element];
    if (w_.structure.elements()[other->element].member == e.member) {
        for (int plane : {0, 1}) out.sum[plane] += theirs.rotation[plane], out.shared[plane] = true;
        return out;
    }
    // Two members: a support may take part of the moment. About an axis that it holds, each side has a hinge of its
    // own, and so it is where the two sides bend against each other.
    Vec3 turned = -in_space(theirs, *other);
    for (int axis : {0, 1, 2})
        if (w_.structure.fixed()[std::size_t(e.node[of.end - 1])] >> (3 + axis) & 1) turned[axis] = 0;
    const Vec3 here = (of.end == 1 ? -1 : 1) * (e.axes.conjugate() * turned);
    for (int plane : {0, 1})
        if (here[plane] * out.sum[plane] > 0) out.sum[plane] += here[plane], out.shared[plane] = true;
    return out;
}

double HingeLimits::rotation(int element, int end, int plane) const { return rotation(End{element, end}).sum[plane]; }

/// The section that flows, else the one with the larger moment.
int HingeLimits::weaker_end(int element) const {
    if (const PlasticIncrement* y = flow_of(element); y && y->flow.lambda[0] != y->flow.lambda[1])
        return y->flow.lambda[0] > y->flow.lambda[1] || w_.structure.conventional() ? 1 : 2;
    const Vec6 p = w_.force[element] + w_.assembly.fixed_end(element).at(0);
    return p[0] * p[0] + p[2] * p[2] > p[1] * p[1] + p[3] * p[3] ? 1 : 2;
}

/// By the rotation of a hinge. Of two elements with a part in it the one with the larger part breaks.
std::optional<Break> HingeLimits::rotated(const End& at) const {
    const FractureRule& rule = *rule_of(at.element);
    const Rotation turned = rotation(at);
    const beam::LimitReached cause = beam::rotation_reached(turned.sum, rule);
    if (cause.which == beam::Limit::rule) return {};
    const bool shared = turned.shared[cause.which == beam::Limit::hinge_rotation_y];
    const std::optional<End> other = shared ? other_side(at.element, at.end) : std::nullopt;
    if (rule.plastic_only && !flows(at.element, at.end) && !(other && flows(other->element, other->end))) return {};
    const auto part = [&](const End& of) {
        const HingeMotion motion = own(of.element, of.end);
        return std::hypot(motion.rotation[0], motion.rotation[1]);
    };
    const bool others = other && is_larger(part(*other), part(at), other->element < at.element);
    const End& breaks = others ? *other : at;
    return Break{breaks.element, breaks.end, cause};
}

/// By the plastic elongation of what is whole of the member on both sides of the element. The element with the largest
/// part in it breaks.
std::optional<Break> HingeLimits::elongated(int element) const {
    const auto& elements = w_.structure.elements();
    const auto whole = [&](int e) {
        return e >= 0 && e < int(elements.size()) && elements[e].member == elements[element].member &&
               !w_.state.broken[e];
    };
    int first = element, longest = -1;
    while (whole(first - 1)) --first;
    double sum = 0, most = 0;
    bool flows_now = false;
    for (int e = first; whole(e); ++e) {
        HingeMotion motion = own(e, 1);
        if (!w_.structure.conventional()) motion += own(e, 2);
        sum += motion.elongation;
        flows_now = flows_now || flow_of(e);
        if (longest < 0 || is_larger(motion.elongation, most, false)) longest = e, most = motion.elongation;
    }
    const FractureRule& rule = *rule_of(element);
    if (!(sum >= rule.elongation) || (rule.plastic_only && !flows_now)) return {};
    return Break{longest, weaker_end(longest), {beam::Limit::elongation, sum, rule.elongation}};
}

void HingeLimits::add_reached(int element, std::vector<Break>& breaks, bool all) const {
    const FractureRule* rule = rule_of(element);
    if (!rule || rule->no_hinges()) return;
    const PlasticIncrement* y = flow_of(element);
    if (!y && !all) return;
    const auto add = [&](const std::optional<Break>& b) {
        const auto same = [&](const Break& known) { return known.element == b->element; };
        if (b && std::none_of(breaks.begin(), breaks.end(), same)) breaks.push_back(*b);
    };
    if (std::isfinite(rule->hinge_rotation_x) || std::isfinite(rule->hinge_rotation_y)) {
        if (w_.structure.conventional()) {
            add(rotated({element, weaker_end(element)}));
        } else {
            for (int end : {1, 2})
                if (all || y->flow.lambda[end - 1] > 0) add(rotated({element, end}));
        }
    }
    if (std::isfinite(rule->elongation) && (all || y->flow.plastic[4] > y->flow.slack)) add(elongated(element));
}

}  // namespace hinge

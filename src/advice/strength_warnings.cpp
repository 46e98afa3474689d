// Where a run finds members too strong: eq 14 beside an axial force, from a linear solution of the loads; loads where
// no hinge forms; heat without the curve of hot steel.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/text.h"
#include "advice/unsafe_strength.h"
#include "section/plastic_shape.h"
#include "effects/heat.h"
#include "effects/member_loads.h"
#include "model/member_text.h"
#include "advice/load_warnings.h"

namespace hinge {
namespace {

/// By how much the moment that eq 14 gives may be above the exact one before it is told, and by how many parts of M0.
/// A run warns from unsafe_excess on, of moments that it has reached.
constexpr double told_from = 0.05, told_moment = 0.02;

}  // namespace

std::vector<Warning> unsafe_eq14(const AdvisedRun& of, const LinearSolution& solution) {
    const Structure& declared = of.run->structure();
    if (!solution.run || !declared.can_yield()) return {};
    const Model& model = declared.model();
    const auto& elements = solution.run->structure().elements();
    double worst = 0, excess = 0, worst_n = 0;  // of M0, of the exact moment, of N0
    int worst_member = -1, worst_axis = 0, last = -1;
    int members = 0;
    for (int i = 0; i < int(elements.size()); ++i) {
        const int member = elements[i].member;
        const beam::YieldSurface& yield = declared.elements()[i].yield;
        const auto shape = PlasticShape::of(*model.members()[member].section);
        if (!shape || yield.n == 0 || !declared.elements()[i].law->ignores_shape()) continue;
        double n = 0;
        for (double side : {-1.0, 1.0})
            n = std::max(n, std::sqrt(yield.n) * std::abs(solution.run->section_forces(i, side).N));
        if (n >= 1) continue;  // it yields by N alone
        for (int axis : {0, 1}) {
            const double of_eq14 = std::sqrt(1 - n * n), exact = shape->moment(axis, n);
            if (!(of_eq14 > (1 + told_from) * exact && of_eq14 > exact + told_moment)) continue;
            if (last != member) last = member, ++members;
            if (of_eq14 - exact > worst + alike_moment) {
                worst = of_eq14 - exact, excess = of_eq14 / exact - 1;
                worst_n = n, worst_member = member, worst_axis = axis;
            }
        }
    }
    if (worst_member < 0) return {};
    const char* about = worst_axis == 0 ? "x" : "y";
    Warning w{.kind = Warning::Kind::strength};
    w.what = member_text(model, worst_member) + ", section " + model.members()[worst_member].section->kind +
             ", carries N / N0 = " + number_text(worst_n, 2) + " in a linear solution of the loads: beside that " +
             "N eq 14, interaction = \"paper\", gives it " + excess_text(excess) + " more bending strength about its " +
             about + " axis than it has";
    w.advice = "a run finds it too strong; leave that option out, or give \"exact\"";
    w.asked_at = model.asked_at("member " + std::to_string(worst_member + 1));
    w.more = members - 1, w.tells_of = members;
    return {w};
}

namespace {

/// The highest temperature of a declaration, degrees Celsius.
double hottest(const Heating& h) {
    double most = h.temperature;
    if (h.history && h.history.points())
        for (const auto& [time, temperature] : *h.history.points()) most = std::max(most, temperature);
    return most;
}

}  // namespace

std::vector<Warning> heated_without_curve(const Structure& s) {
    constexpr double hot = 200, keeps = 1.15, slender = 0.3;  // degrees Celsius; strength over stiffness; EN 1993-1-1
    const Model& model = s.model();
    const auto& list = model.declared<Heating>(heat_effect);
    int first = -1, members = 0, last = -1;
    double most = 0;
    for (const Element& e : s.elements()) {
        if (list.empty() || e.member == last) continue;  // all elements of a member are alike
        last = e.member;
        const int which = heating_of(model, e.member);
        if (which < 0 || !e.law || !e.law->keeps_strength() || e.yield.n == 0) continue;
        const HeatProperties& properties = *list[which].properties;
        const double T = hottest(list[which]), length = e.length * model.members()[e.member].elements,
                     euler = std::pow(std::numbers::pi / length, 2) * std::min(e.rigidity.EIx, e.rigidity.EIy);
        if (T < hot || 1 / std::sqrt(e.yield.n) < slender * slender * euler ||
            HeatProperties::at(T, properties.strength) < keeps * HeatProperties::at(T, properties.stiffness))
            continue;
        ++members;
        if (first < 0) first = e.member, most = T;
    }
    if (first < 0) return {};
    Warning w{.kind = Warning::Kind::strength};
    w.what = member_text(model, first) + " is heated to " + number_text(most) +
             " degrees Celsius, and is elastic up to its yield stress, that at a strain of 2 %: compressed, it would "
             "buckle at up to 80 degrees less than a run finds";
    w.advice = "give its material hot_curve = hinge.heat.curve()";
    w.asked_at = model.asked_at(heat_effect);
    w.more = members - 1, w.tells_of = members;
    return {w};
}

std::vector<Warning> loads_beside_hinges(const Structure& s) {
    constexpr double told_bump = 0.1;  // of the plastic moment: what the load adds to the moments at the element's ends
    constexpr int most = 20;           // elements that are advised
    const Model& model = s.model();
    std::vector<int> first(model.members().size(), -1);
    for (int i = 0; i < int(s.elements().size()); ++i)
        if (int& f = first[s.elements()[i].member]; f < 0) f = i;
    double worst = told_bump;
    int worst_member = -1, worst_elements = 0, members = 0;
    double worst_at = 0;
    std::vector<char> counted(first.size(), 0);
    for (const MemberLoad& l : model.declared<MemberLoad>(member_loads_effect)) {
        if (l.spread() || first[l.member] < 0) continue;
        const Element& e = s.elements()[first[l.member]];
        if (!e.law || e.yield.elastic()) continue;
        const int n = model.members()[l.member].elements;
        const double place = l.at * n, eta = place - std::floor(place);
        if (eta < 1e-6 || eta > 1 - 1e-6) continue;
        const Mat3 to_local =
            l.axes == LoadAxes::local ? Mat3(Mat3::Identity()) : Mat3(e.axes.toRotationMatrix().transpose());
        const Vec3 force = to_local * l.force[0] * (eta * (1 - eta) * e.length), moment = 0.5 * to_local * l.moment[0];
        const double bump = std::hypot(std::sqrt(e.yield.x) * (std::abs(force.y()) + std::abs(moment.x())),
                                       std::sqrt(e.yield.y) * (std::abs(force.x()) + std::abs(moment.y())));
        if (!(bump > told_bump)) continue;
        if (!counted[l.member]) counted[l.member] = 1, ++members;
        if (bump <= worst) continue;
        worst = bump, worst_member = l.member, worst_at = l.at, worst_elements = 0;
        for (int k = n; k <= most && worst_elements == 0; k += 2)
            if (std::abs(l.at * k - std::round(l.at * k)) < 1e-6) worst_elements = k;
    }
    if (worst_member < 0) return {};
    Warning w{.kind = Warning::Kind::strength};
    w.what = "the load at " + number_text(worst_at) + " of the length of " + member_text(model, worst_member) +
             " acts between the ends of its elements, where no hinge forms";
    w.advice = "a run may find it too strong; " +
               (worst_elements > 0 ? "give it elements = " + std::to_string(worst_elements) + ", or a node there"
                                   : std::string("end a member there, or give it more elements"));
    w.asked_at = model.asked_at("member " + std::to_string(worst_member + 1));
    w.more = members - 1, w.tells_of = members;
    return {w};
}

}  // namespace hinge

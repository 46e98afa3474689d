// Members whose axial force makes eq 14 unsafe, from a linear solution of the loads.
#include <cmath>

#include "core/text.h"
#include "effects/axial_strength.h"
#include "model/member_text.h"
#include "script/checks/load_warnings.h"

namespace hinge::script {
namespace {

/// By how much the moment that eq 14 gives may be above the exact one before it is told, and by how many parts of M0.
/// A run warns from unsafe_excess on, of moments that it has reached.
constexpr double told_from = 0.05, told_moment = 0.02;

}  // namespace

std::vector<Warning> unsafe_eq14(const RunRecord& record, const LinearSolution& solution) {
    const Structure& declared = record.run->structure();
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
    std::vector<Warning> list(1);
    Warning& w = list.front();
    w.what = member_text(model, worst_member) + ", section " + model.members()[worst_member].section->kind +
             ", carries N / N0 = " + number_text(worst_n, 2) + " in a linear solution of the loads: beside that " +
             "N eq 14, interaction = \"paper\", gives it " + excess_text(excess) + " more bending strength about its " +
             about + " axis than it has";
    w.advice = "a run finds it too strong; leave that option out, or give \"exact\"";
    w.asked_at = model.asked_at("member " + std::to_string(worst_member + 1));
    w.more = members - 1, w.tells_of = members;
    return list;
}

}  // namespace hinge::script

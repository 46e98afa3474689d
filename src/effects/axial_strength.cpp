#include "effects/axial_strength.h"

#include <cmath>

#include "core/text.h"
#include "model/member_text.h"

namespace hinge {
namespace {

constexpr long every = 10;  ///< steps of dynamics between looks at sections that do not flow
constexpr double least_n = unsafe_excess / (1 + unsafe_excess);  ///< of N0: below it 1 - n is more than M may be beyond

}  // namespace

std::string excess_text(double excess) { return number_text(std::round(100 * excess), 4) + " %"; }

AxialStrength::AxialStrength(const Structure& structure) {
    std::map<const Section*, int> known;
    for (const MemberData& m : structure.model().members()) {
        const auto [at, fresh] = known.try_emplace(m.section.get(), int(shapes_.size()));
        if (fresh) shapes_.push_back(PlasticShape::of(*m.section));
        shape_of_.push_back(shapes_[at->second] ? at->second : -1);
    }
}

void AxialStrength::look(const Workspace& w, const Step& step) {
    if (w.kind.dynamic && w.state.step % every != 0) {
        for (const PlasticIncrement& y : w.yielding) look_at(w, step, y.element);
        return;
    }
    for (int i = 0; i < int(w.structure.elements().size()); ++i) look_at(w, step, i);
}

void AxialStrength::look_at(const Workspace& w, const Step& step, int index) {
    const Element& e = w.structure.elements()[index];
    const int shape = shape_of_[e.member];
    if (shape < 0 || e.yield.n == 0 || w.state.broken[index] || !e.law->ignores_shape()) return;
    for (double r : {-1.0, 1.0}) {
        const Vec6 p = w.state.force[index] + w.assembly.fixed_end(index).at(r);
        const double n = std::sqrt(e.yield.n) * std::abs(p[4]);
        if (!(n > least_n && n < 1)) continue;
        const double m[2] = {std::sqrt(e.yield.x) * std::abs(beam::moment_at(p[0], p[1], r)),
                             std::sqrt(e.yield.y) * std::abs(beam::moment_at(p[2], p[3], r))};
        for (int axis : {0, 1}) {
            // a convex yield surface through n = 1 and m = 1 has at least m = 1 - n
            if (!(m[axis] > (1 + unsafe_excess) * (1 - n))) continue;
            const double exact = shapes_[shape]->moment(axis, n);
            if (!is_unsafe(m[axis], exact)) continue;
            if (unsafe_.empty()) unsafe_.assign(w.structure.model().members().size(), 0);
            unsafe_[e.member] = 1;
            if (m[axis] - exact > worst_.m - worst_.exact + alike_moment)
                worst_ = {n, m[axis], exact, w.reached(step), index, axis};
        }
    }
}

void AxialStrength::check_run(const Workspace& w, std::vector<RunWarning>& list) const {
    if (worst_.element < 0) return;
    const Model& model = w.structure.model();
    const int member = w.structure.elements()[worst_.element].member;
    const long others = std::count(unsafe_.begin(), unsafe_.end(), 1) - 1;
    const std::string axis = worst_.axis == 0 ? "x" : "y";
    list.push_back(
        {member_text(model, member) + ", section " + model.members()[member].section->kind + ", carries N / N0 = " +
             number_text(worst_.n, 2) + " and " + number_text(worst_.m, 2) + " of M" + axis + "0 " +
             (w.kind.dynamic ? "at t = " + number_text(worst_.at, 4) + " s"
                             : "at load factor " + number_text(worst_.at, 4)) +
             ": " + excess_text(worst_.m / worst_.exact - 1) + " more than its exact plastic moment beside that N" +
             (others > 0
                  ? ", and so do " + count_text(others, "more member") + " by more than " + excess_text(unsafe_excess)
                  : ""),
         "eq 14 is unsafe there, and the strength found is too high; give the section, or hinge.model, interaction = "
         "\"exact\"",
         member});
}

bool AxialStrength::fits(const Structure& structure) const {
    const int n = int(structure.elements().size());
    return worst_.element >= -1 && worst_.element < n && (worst_.axis == 0 || worst_.axis == 1) &&
           (unsafe_.empty() || unsafe_.size() == structure.model().members().size());
}

}  // namespace hinge

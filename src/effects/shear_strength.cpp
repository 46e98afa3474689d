#include "effects/shear_strength.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beam/plastic_domain.h"
#include "core/text.h"
#include "effects/axial_strength.h"
#include "model/member_text.h"

namespace hinge {
namespace {

constexpr long every = 10;           ///< steps of dynamics between looks at sections that do not flow
constexpr double small_shear = 0.5;  ///< of V0: up to that it takes nothing from the moment, EN 1993-1-1 6.2.8(2)

}  // namespace

ShearProperties shear_properties(const Section& s) {
    ShearProperties out{{s.shear_area_x, s.shear_area_y}};
    const double A = s.plastic_area, b = s.width, d = s.depth;
    const auto all_in_it = [&](double area) {
        for (int i : {0, 1}) out.area[i] = area, out.share[i] = 1;
    };
    if (s.kind == "solid" || s.kind == "round") all_in_it(A);
    if (s.kind == "pipe") all_in_it(2 * A / std::numbers::pi);
    if (s.kind == "h" && s.Zx > 0) {
        const double clear = d - 2 * s.flange;
        out.share[1] = s.web * clear * clear / 4 / s.Zx;
        out.share[0] = 1;  // the flanges carry the bending about y and the shear along x
    }
    if (s.kind == "box" && s.Zx > 0 && s.Zy > 0) {  // its hollow: plastic_shape.cpp
        const double hollow = b * d - A, clear = (b * d * d - 4 * s.Zx) / hollow, between = hollow / clear;
        out.share[1] = (b - between) * d * d / 4 / s.Zx;
        out.share[0] = (d - clear) * b * b / 4 / s.Zy;
    }
    return out;
}

double moment_left_by_shear(double v, double share) {
    if (!(v > small_shear)) return 1;
    const double rho = std::min(1.0, (2 * v - 1) * (2 * v - 1));
    return 1 - rho * share;
}

ShearStrength::ShearStrength(const Structure& structure) {
    for (const Element& e : structure.elements()) {
        const MemberData& member = structure.model().members()[e.member];
        const Section& s = *member.section;
        Scales scales;
        const bool steel = !(s.outline && s.outline->concrete());
        if (steel && e.law && !e.yield.elastic() && std::isfinite(member.material->yield_stress)) {
            const ShearProperties shear = shear_properties(s);
            const double tau = member.material->yield_stress / std::sqrt(3.0);
            const double M[2] = {e.yield.x, e.yield.y};
            for (int axis : {0, 1}) {
                const double V0 = tau * shear.area[1 - axis];
                if (V0 > 0 && std::isfinite(V0) && M[axis] > 0)
                    scales.v[axis] = 1 / (V0 * e.length), scales.m[axis] = std::sqrt(M[axis]),
                    scales.share[axis] = shear.share[1 - axis];
            }
        }
        scales_.push_back(scales);
    }
}

void ShearStrength::look(const Workspace& w, const Step& step) {
    if (!w.is_due_every(every))
        for (const PlasticIncrement& y : w.yielding) look_at(w, step, y.element);
    else
        for (int i = 0; i < int(scales_.size()); ++i) look_at(w, step, i);
}

/// The mean shear force of the element: what its bending moment changes by, over its length.
void ShearStrength::look_at(const Workspace& w, const Step& step, int index) {
    const Scales& of = scales_[index];
    const Vec6& p = w.state.force[index];
    for (int axis : {0, 1}) {
        const double* f = w.assembly.fixed_end(index).moment + 2 * axis;
        const double a = p[2 * axis] + f[0], b = p[2 * axis + 1] + f[1];
        if (!(of.v[axis] * std::abs(a + b) > small_shear)) continue;
        const double strength = heat_of(w.state.heat, index).strength;
        compare(w, step, index, axis, of.v[axis] / strength * std::abs(a + b),
                of.m[axis] / strength * std::max(std::abs(a), std::abs(b)));
    }
}

void ShearStrength::compare(const Workspace& w, const Step& step, int index, int axis, double v, double m) {
    if (w.state.broken[index]) return;
    const double share = scales_[index].share[axis], left = share < 0 ? 1 : moment_left_by_shear(v, share);
    double excess = 0;
    const double within = std::min(m, 1.0);  // hardening, or an end beyond the hinge of an element, is not for shear
    if (is_unsafe(within, left)) excess = within - left;
    if (is_unsafe(v, 1)) excess = std::max(excess, v - 1);
    if (!(excess > 0)) return;
    const int member = w.structure.elements()[index].member;
    if (unsafe_.empty()) unsafe_.assign(w.structure.model().members().size(), 0);
    unsafe_[member] = 1;
    if (excess > worst_.excess + alike_moment) worst_ = {v, m, left, excess, w.reached(step), index, axis};
}

void ShearStrength::check_run(const Workspace& w, std::vector<RunWarning>& list) const {
    if (worst_.element < 0) return;
    const Model& model = w.structure.model();
    const int member = w.structure.elements()[worst_.element].member;
    const long others = std::count(unsafe_.begin(), unsafe_.end(), 1) - 1;
    const std::string along = worst_.axis == 0 ? "y" : "x", about = worst_.axis == 0 ? "x" : "y";
    std::string text = member_text(model, member) + ", section " + model.members()[member].section->kind +
                       ", carries V / V0 = " + number_text(worst_.v, 2) + " along " + along + " and " +
                       number_text(worst_.m, 2) + " of M" + about + "0 " +
                       (w.goes_by_load_factor() ? "at load factor " + number_text(worst_.at, 4)
                                                : "at t = " + number_text(worst_.at, 4) + " s");
    text += is_unsafe(std::min(worst_.m, 1.0), worst_.left)
                ? ": EN 1993-1-1 6.2.8 leaves " + number_text(worst_.left, 2) + " of M" + about +
                      "0 beside that shear force"
                : ": more than its plastic shear strength";
    if (others > 0) text += ", and so do " + count_text(others, "more member") + " beyond what they can carry";
    list.push_back({text,
                    "no law of sections takes strength for shear forces: this run finds too high a strength; give such "
                    "members a section with a smaller strength, or a fracture rule on their shear",
                    member});
}

bool ShearStrength::fits(const Structure& structure) const {
    const int n = int(structure.elements().size());
    return worst_.element >= -1 && worst_.element < n && (worst_.axis == 0 || worst_.axis == 1) &&
           (unsafe_.empty() || unsafe_.size() == structure.model().members().size());
}

}  // namespace hinge

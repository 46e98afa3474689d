// Where eq 14 lets sections carry more bending beside their axial force than they can.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "advice/adviser.h"
#include "advice/unsafe_strength.h"
#include "core/text.h"
#include "effects/effect_list.h"
#include "model/member_text.h"
#include "section/plastic_shape.h"

namespace hinge {
namespace {

constexpr long axial_every = 10;  ///< steps of dynamics between looks at sections that do not flow
constexpr double least_n = unsafe_excess / (1 + unsafe_excess);  ///< of N0: below it 1 - n is more than M may be beyond
/// A convex yield surface through n = 1 and m = 1 has at least m = 1 - n: below this a moment is not unsafe.
double least_m(double n) { return (1 + unsafe_excess) * (1 - n); }

/// Follows the sections whose moment is beyond the exact plastic one beside their N (section/plastic_shape.h). Sections
/// of unknown shape are left out.
class AxialStrength : public Adviser {
public:
    explicit AxialStrength(const Structure& structure);

    /// All elements; in dynamics at every tenth step, else those that flowed.
    void after_commit(const Run& run, const Step& step) override;
    void list_findings(const Run& run, std::vector<Warning>& list) const override;
    void save(Writer& to) const override { to(worst_, unsafe_); }
    void restore(Reader& from) override { from(worst_, unsafe_); }
    bool fits(const Run& run) const override;

private:
    struct Found {
        double n = 0, m = 0, exact = 0;  ///< parts of N0 and M0
        double at = 0;                   ///< s, in statics the load factor
        int element = -1, axis = 0;
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.n, s.m, s.exact, s.at, s.element, s.axis);
        }
    };
    /// Parts of the axial and bending strength for 1 N and 1 N m: roots of the coefficients of eq 14.
    struct Scales {
        double n = 0, m[2] = {0, 0};  ///< 1/N, 1/(N m); n = 0: nothing to look at
    };
    Scales scale_of(const Workspace& w, int element) const;
    static bool may_exceed(const Scales& scale, const Vec6& p, const beam::FixedEnd& fixed);
    void compare_ends(const Workspace& w, const Step& step, int element);
    /// Compares a bending moment with the exact plastic one beside the axial force.
    void compare(const Workspace& w, const Step& step, int element, int axis, double n, double m);

    std::vector<std::optional<PlasticShape>> shapes_;
    std::vector<int> shape_of_;   ///< of each member
    std::vector<Scales> scales_;  ///< of each element: nothing else is read of an element with a small N
    Found worst_;
    UnsafeMembers unsafe_;
};

AxialStrength::AxialStrength(const Structure& structure) {
    std::map<const Section*, int> known;
    for (const MemberData& m : structure.model().members()) {
        const auto [at, fresh] = known.try_emplace(m.section.get(), int(shapes_.size()));
        if (fresh) shapes_.push_back(PlasticShape::of(*m.section));
        shape_of_.push_back(shapes_[at->second] ? at->second : -1);
    }
    for (const Element& e : structure.elements()) {
        const beam::YieldSurface& y = e.yield;
        const bool looked_at = shape_of_[e.member] >= 0 && e.law && e.law->ignores_shape() && e.law->keeps_strength();
        scales_.push_back(looked_at ? Scales{std::sqrt(y.n), {std::sqrt(y.x), std::sqrt(y.y)}} : Scales{});
    }
}

void AxialStrength::after_commit(const Run& run, const Step& step) {
    const Workspace& w = run.workspace();
    const auto check = [&](int i) {
        if (may_exceed(scale_of(w, i), w.state.force[i], w.assembly.fixed_end(i))) compare_ends(w, step, i);
    };
    if (!w.is_due_every(axial_every))
        for (const PlasticIncrement& y : w.yielding) check(y.element);
    else
        for (int i = 0; i < int(scales_.size()); ++i) check(i);
}

/// Of its strength now, which heat may have taken from.
AxialStrength::Scales AxialStrength::scale_of(const Workspace& w, int index) const {
    const Scales& s = scales_[index];
    const double strength = heat_of(w.state.heat, index).strength;
    return {s.n / strength, {s.m[0] / strength, s.m[1] / strength}};
}

/// Takes the largest of both ends and axes: for most elements that is all there is to do in a step.
bool AxialStrength::may_exceed(const Scales& scale, const Vec6& p, const beam::FixedEnd& fixed) {
    const double n = scale.n * (std::abs(p[4]) + std::max(std::abs(fixed.N[0]), std::abs(fixed.N[1])));
    if (!(n > least_n)) return false;
    const double* f = fixed.moment;
    const double Mx = std::max(std::abs(p[0] + f[0]), std::abs(p[1] + f[1]));
    const double My = std::max(std::abs(p[2] + f[2]), std::abs(p[3] + f[3]));
    return std::max(scale.m[0] * Mx, scale.m[1] * My) > least_m(n);
}

void AxialStrength::compare_ends(const Workspace& w, const Step& step, int index) {
    const Scales scale = scale_of(w, index);
    const Vec6& p = w.state.force[index];
    const beam::FixedEnd& fixed = w.assembly.fixed_end(index);
    for (int end : {0, 1}) {
        const double n = scale.n * std::abs(p[4] + fixed.N[end]);
        if (!(n > least_n && n < 1)) continue;
        for (int axis : {0, 1}) {
            const int i = 2 * axis + end;  // of the bending moment at this end in p
            const double m = scale.m[axis] * std::abs(p[i] + fixed.moment[i]);
            if (m > least_m(n)) compare(w, step, index, axis, n, m);
        }
    }
}

void AxialStrength::compare(const Workspace& w, const Step& step, int index, int axis, double n, double m) {
    if (w.state.broken[index]) return;
    const int member = w.structure.elements()[index].member;
    const double exact = shapes_[shape_of_[member]]->moment(axis, n);
    if (!is_unsafe(m, exact)) return;
    unsafe_.add(w.structure.model(), member);
    if (m - exact > worst_.m - worst_.exact + alike_moment) worst_ = {n, m, exact, w.reached(step), index, axis};
}

void AxialStrength::list_findings(const Run& run, std::vector<Warning>& list) const {
    if (worst_.element < 0) return;
    const Workspace& w = run.workspace();
    const Model& model = w.structure.model();
    const int member = w.structure.elements()[worst_.element].member;
    const long others = unsafe_.others();
    const std::string axis = worst_.axis == 0 ? "x" : "y";
    list.push_back(
        {Warning::Kind::strength,
         member_text(model, member) + ", section " + model.members()[member].section->kind +
             ", carries N / N0 = " + number_text(worst_.n, 2) + " and " + number_text(worst_.m, 2) + " of M" + axis +
             "0 " + when_text(w, worst_.at) + ": " + excess_text(worst_.m / worst_.exact - 1) +
             " more than its exact plastic moment beside that N" +
             (others > 0
                  ? ", and so do " + count_text(others, "more member") + " by more than " + excess_text(unsafe_excess)
                  : ""),
         "eq 14, interaction = \"paper\", is unsafe there: this run finds too high a strength; leave that option out, "
         "or give \"exact\"",
         line_of_member(model, member)});
}

bool AxialStrength::fits(const Run& run) const {
    const Structure& structure = run.structure();
    const int n = int(structure.elements().size());
    return worst_.element >= -1 && worst_.element < n && (worst_.axis == 0 || worst_.axis == 1) &&
           unsafe_.fits(structure.model());
}

}  // namespace

std::unique_ptr<Adviser> advise_of_axial_strength(const Run& run, WarningLog&) {
    if (!run.effect_list().has("plasticity")) return nullptr;
    return std::make_unique<AxialStrength>(run.structure());
}

}  // namespace hinge

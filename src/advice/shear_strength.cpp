// Where shear forces are beyond the plastic shear strength of sections, or take bending strength from sections that no
// law of sections takes into account.
#include <algorithm>
#include <cmath>

#include "advice/adviser.h"
#include "advice/unsafe_strength.h"
#include "core/text.h"
#include "effects/effect_list.h"
#include "effects/shear_strength.h"
#include "model/member_text.h"

namespace hinge {
namespace {

constexpr long shear_every = 10;     ///< steps of dynamics between looks at sections that do not flow
constexpr double small_shear = 0.5;  ///< of V0: up to that it takes nothing from the moment, EN 1993-1-1 6.2.8(2)

/// The bending strength that is left beside a shear force v = V / V0, in parts of that without it: EN 1993-1-1 6.2.8
/// (3). `share`: of the plastic modulus in what carries the shear force.
double moment_left_by_shear(double v, double share) { return 1 - lost_by_shear(v) * share; }

/// Follows sections whose shear force is beyond V0, or whose moment is beyond what that leaves.
class ShearExcess : public Adviser {
public:
    explicit ShearExcess(const Structure& structure) : strength_(structure) {}

    /// All elements; in dynamics at every tenth step, else those that flowed.
    void after_commit(const Run& run, const Step& step) override {
        const Workspace& w = run.workspace();
        if (!w.is_due_every(shear_every))
            for (const PlasticIncrement& y : w.yielding) check(w, step, y.element);
        else
            for (int i = 0; i < int(strength_.size()); ++i) check(w, step, i);
    }
    void list_findings(const Run& run, std::vector<Warning>& list) const override;
    void save(Writer& to) const override { to(worst_, unsafe_); }
    void restore(Reader& from) override { from(worst_, unsafe_); }
    bool fits(const Run& run) const override;

private:
    struct Found {
        double v = 0, m = 0, left = 1;  ///< parts of V0 and of M0
        double excess = 0;              ///< of V over V0, or of the moment over what is left; parts of V0 or M0
        double at = 0;                  ///< s, in statics the load factor
        double torsion = 0;             ///< part of Mz0, which takes from V0
        int element = -1, axis = 0;     ///< axis 0: bending about x, shear along y
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.v, s.m, s.left, s.excess, s.at, s.torsion, s.element, s.axis);
        }
    };
    void check(const Workspace& w, const Step& step, int element);
    void compare(const Workspace& w, const Step& step, int element, int axis, double v, double m, double torsion);

    ShearStrength strength_;
    Found worst_;
    UnsafeMembers unsafe_;
};

void ShearExcess::check(const Workspace& w, const Step& step, int index) {
    const double t = strength_.torsion_of(w, index), left = strength_.v0_left(index, t);
    for (int axis : {0, 1})
        if (const auto at = strength_.shear_of(w, index, axis); at.v > small_shear * left)
            compare(w, step, index, axis, at.v / left, at.m, t);
}

void ShearExcess::compare(const Workspace& w, const Step& step, int index, int axis, double v, double m,
                          double torsion) {
    if (w.state.broken[index]) return;
    const bool taken = w.structure.elements()[index].law->takes_shear();  // then the moment cannot be too large
    const double share = strength_.share(index, axis), left = taken || share < 0 ? 1 : moment_left_by_shear(v, share);
    double excess = 0;
    const double within = std::min(m, 1.0);  // hardening, or an end beyond the hinge of an element, is not for shear
    if (is_unsafe(within, left)) excess = within - left;
    if (is_unsafe(v, 1)) excess = std::max(excess, v - 1);
    if (!(excess > 0)) return;
    const int member = w.structure.elements()[index].member;
    unsafe_.add(w.structure.model(), member);
    if (excess > worst_.excess + alike_moment) worst_ = {v, m, left, excess, w.reached(step), torsion, index, axis};
}

void ShearExcess::list_findings(const Run& run, std::vector<Warning>& list) const {
    if (worst_.element < 0) return;
    const Workspace& w = run.workspace();
    const Model& model = w.structure.model();
    const int member = w.structure.elements()[worst_.element].member;
    const long others = unsafe_.others();
    const std::string along = worst_.axis == 0 ? "y" : "x", about = worst_.axis == 0 ? "x" : "y";
    std::string text = member_text(model, member) + ", section " + model.members()[member].section->kind +
                       ", carries V / V0 = " + number_text(worst_.v, 2) + " along " + along + " and " +
                       number_text(worst_.m, 2) + " of M" + about + "0 " + when_text(w, worst_.at);
    if (worst_.torsion > 0.01) text += ", with what Mz / Mz0 = " + number_text(worst_.torsion, 2) + " takes from V0";
    text += is_unsafe(std::min(worst_.m, 1.0), worst_.left)
                ? ": EN 1993-1-1 6.2.8 leaves " + number_text(worst_.left, 2) + " of M" + about +
                      "0 beside that shear force"
                : ": more than its plastic shear strength";
    if (others > 0) text += ", and so do " + count_text(others, "more member") + " beyond what they can carry";
    const Element& e = w.structure.elements()[worst_.element];
    const char* advice = e.law->takes_shear()
                             ? "sections keep their strength in shear beyond that: this run finds too high a strength; "
                               "give such members a section that carries it, or a fracture rule on their shear"
                         : shear_carried(*model.members()[member].section)
                             ? "its law of sections takes no strength for shear forces: this run finds too high a "
                               "strength; give hinge.model, or the section, interaction = \"exact with shear\""
                             : "its law of sections takes no strength for shear forces: this run finds too high a "
                               "strength; give such members a section with a smaller strength, or a fracture rule on "
                               "their shear";
    list.push_back({Warning::Kind::strength, text, advice, line_of_member(model, member)});
}

bool ShearExcess::fits(const Run& run) const {
    const Structure& structure = run.structure();
    const int n = int(structure.elements().size());
    return worst_.element >= -1 && worst_.element < n && (worst_.axis == 0 || worst_.axis == 1) &&
           unsafe_.fits(structure.model());
}

}  // namespace

std::unique_ptr<Adviser> advise_of_shear_strength(const Run& run, WarningLog&) {
    if (!run.effect_list().has("plasticity")) return nullptr;
    return std::make_unique<ShearExcess>(run.structure());
}

}  // namespace hinge

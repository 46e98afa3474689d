// Where eq 14 lets sections carry more bending beside their axial force than they can. Plasticity owns it.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "effects/reports.h"
#include "effects/workspace.h"
#include "section/plastic_shape.h"

namespace hinge {

/// By how much a moment may exceed the exact plastic moment beside N before it is told: up to that eq 14 is within the
/// scatter of yield stresses. Near N0, where both vanish, by how many parts of M0.
inline constexpr double unsafe_excess = 0.10, unsafe_moment = 0.05;
/// Parts of M0 that are no difference: of alike members the first is named on every processor.
inline constexpr double alike_moment = 1e-9;

/// Whether that is so of a moment m beside which the exact one is `exact`, both in parts of M0.
inline bool is_unsafe(double m, double exact) { return m > (1 + unsafe_excess) * exact && m > exact + unsafe_moment; }

/// "73 %"
std::string excess_text(double excess);

/// Follows the sections whose moment is beyond the exact plastic one beside their N (section/plastic_shape.h). Sections
/// of unknown shape are left out.
class AxialStrength {
public:
    explicit AxialStrength(const Structure& structure);

    /// At the end of a step: all elements; in dynamics at every tenth step, else those that flowed.
    void look(const Workspace& w, const Step& step);
    void check_run(const Workspace& w, std::vector<RunWarning>& list) const;
    /// False where what was read from a checkpoint does not fit the structure.
    bool fits(const Structure& structure) const;

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.worst_, s.unsafe_);
    }

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
    std::vector<Scales> scales_;  ///< of each element: the look reads nothing else of an element with a small N
    Found worst_;
    std::vector<char> unsafe_;  ///< members; empty while there is none
};

}  // namespace hinge

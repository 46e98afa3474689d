// Where shear forces take bending strength from sections that no law of sections takes into account. Plasticity owns
// it.
#pragma once

#include <optional>
#include <vector>

#include "effects/reports.h"
#include "effects/workspace.h"
#include "section/shear.h"

namespace hinge {

/// The bending strength that is left beside a shear force v = V / V0, in parts of that without it: EN 1993-1-1 6.2.8
/// (3). `share`: of the plastic modulus in what carries the shear force.
double moment_left_by_shear(double v, double share);

/// Follows sections whose shear force is beyond V0 = (shear area) fy / sqrt(3), or whose moment is beyond what that
/// leaves.
class ShearStrength {
public:
    explicit ShearStrength(const Structure& structure);

    /// At the end of a step: what shear forces take from sections whose law takes it (SectionLaw::takes_shear), for the
    /// step that follows. In dynamics it follows the shear force within the time of a shear wave through the element:
    /// what such a wave does is not for a rule of statics.
    void weaken(const Workspace& w, const Step& step, State& state) const;
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
    /// Of bending about x and about y.
    struct Scales {
        double v[2] = {0, 0}, m[2] = {0, 0};  ///< 1 / (V0 L) and 1 / M0, 1/(N m); v = 0: nothing to look at
        double share[2] = {-1, -1};
        const Section* section = nullptr;
        double torsion = 0;  ///< 1 / Mz0, 1/(N m)
        double wave = 0;     ///< time of a shear wave through the element, s
    };
    struct Shear {
        double v = 0, m = 0;  ///< shear force over V0, moment over M0
    };
    Shear shear_of(const Workspace& w, int element, int axis) const;
    void look_at(const Workspace& w, const Step& step, int element);
    double torsion_of(const Workspace& w, int index) const;
    double v0_left(int index, double torsion) const;
    void compare(const Workspace& w, const Step& step, int element, int axis, double v, double m, double torsion);

    std::vector<Scales> scales_;  ///< of each element
    std::vector<int> weakened_;   ///< elements whose law takes shear
    Found worst_;
    std::vector<char> unsafe_;  ///< members; empty while there is none
};

}  // namespace hinge

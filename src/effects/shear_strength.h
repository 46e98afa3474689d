// Where shear forces take bending strength from sections that no law of sections takes into account. Plasticity owns
// it.
#pragma once

#include <optional>
#include <vector>

#include "effects/reports.h"
#include "effects/workspace.h"

namespace hinge {

/// Plastic shear strength of a section, and how much of its bending strength depends on what carries the shear force.
struct ShearProperties {
    /// m^2 along x and along y: the shear area of the section; of a solid one the whole area, of a pipe 2 A / pi
    /// (EN 1993-1-1 6.2.6(3)).
    double area[2] = {0, 0};
    /// Part of the plastic modulus about y and about x that lies in that area: 1, or that of the webs of an H or a box
    /// whose sizes are known. Negative where it is not known.
    double share[2] = {-1, -1};
};
ShearProperties shear_properties(const Section& section);

/// The bending strength that is left beside a shear force v = V / V0, in parts of that without it: EN 1993-1-1 6.2.8
/// (3). `share`: of the plastic modulus in what carries the shear force.
double moment_left_by_shear(double v, double share);

/// Follows sections whose shear force is beyond V0 = (shear area) fy / sqrt(3), or whose moment is beyond what that
/// leaves.
class ShearStrength {
public:
    explicit ShearStrength(const Structure& structure);

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
        int element = -1, axis = 0;     ///< axis 0: bending about x, shear along y
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.v, s.m, s.left, s.excess, s.at, s.element, s.axis);
        }
    };
    /// Of bending about x and about y.
    struct Scales {
        double v[2] = {0, 0}, m[2] = {0, 0};  ///< 1 / (V0 L) and 1 / M0, 1/(N m); v = 0: nothing to look at
        double share[2] = {-1, -1};
    };
    void look_at(const Workspace& w, const Step& step, int element);
    void compare(const Workspace& w, const Step& step, int element, int axis, double v, double m);

    std::vector<Scales> scales_;  ///< of each element
    Found worst_;
    std::vector<char> unsafe_;  ///< members; empty while there is none
};

}  // namespace hinge

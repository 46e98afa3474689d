// Shear forces beside the plastic shear strength of sections, and what they take from sections whose law takes it.
// Plasticity owns the second.
#pragma once

#include <vector>

#include "effects/workspace.h"
#include "section/shear.h"

namespace hinge {

/// V0 = (shear area) fy / sqrt(3) of each element, and the forces of a state beside it.
class ShearStrength {
public:
    explicit ShearStrength(const Structure& structure);

    /// At the end of a step: what shear forces take from sections whose law takes it (SectionLaw::takes_shear), for the
    /// step that follows. In dynamics it follows the shear force within the time of a shear wave through the element:
    /// what such a wave does is not for a rule of statics.
    void weaken(const Workspace& w, const Step& step, State& state) const;
    struct Shear {
        double v = 0, m = 0;  ///< shear force over V0, moment over M0
    };
    /// Of an element, about axis 0 (x, shear along y) or 1.
    Shear shear_of(const Workspace& w, int element, int axis) const;
    double torsion_of(const Workspace& w, int element) const;  ///< Mz / Mz0
    double v0_left(int element, double torsion) const;         ///< part of V0 that such a torsion leaves
    double share(int element, int axis) const { return scales_[std::size_t(element)].share[axis]; }  ///< -1: none
    std::size_t size() const { return scales_.size(); }

private:
    /// Of bending about x and about y.
    struct Scales {
        double v[2] = {0, 0}, m[2] = {0, 0};  ///< 1 / (V0 L) and 1 / M0, 1/(N m); v = 0: nothing to look at
        double share[2] = {-1, -1};           ///< of the plastic modulus in what carries the shear force
        const Section* section = nullptr;
        double torsion = 0;  ///< 1 / Mz0, 1/(N m)
        double wave = 0;     ///< time of a shear wave through the element, s
    };
    std::vector<Scales> scales_;  ///< of each element
    std::vector<int> weakened_;   ///< elements whose law takes shear
};

}  // namespace hinge

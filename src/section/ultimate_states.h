// Ultimate states of a section of reinforced concrete: what it carries where its concrete crushes or all bars yield;
// and a smooth convex surface through them.
//
// Sections stay plane. In an ultimate state the strain at the pressed edge is `ultimate`; where all of the section is
// pressed, it is `peak` at the part 1 - peak / ultimate of the depth from that edge (EN 1992-1-1, 6.1 and figure 6.1).
// Bars have no limit of strain. Each direction and depth of the neutral axis gives one state: N, Mx and My by
// integration of the stresses over the outline less its bars, and over the bars.
//
// The surface: the support function of flow is
//
//   h(v) = centre . v + (sum of w_i max(0, q_i . v)^128)^(1/128)
//
// with q_i the states, about the centre, that do the most work on 1490 strains v_i, and weights w_i that make h(v_i)
// this work. It is convex and smooth for any weights. Its exponent rounds the surface by less than 1 %.
#pragma once

#include <vector>

#include "section/outline.h"

namespace hinge::beam {

/// The smooth surface through the ultimate states, by its support function.
class UltimateStates {
public:
    /// `outline`: its centroid is the origin.
    UltimateStates(const Outline& outline, const Reinforcement& concrete, const ConcreteStrains& strains);

    /// h(v); `point`: its gradient (Mx, My, N); `curvature`, unless null: its second derivatives. Forces are over
    /// `strength`, strains are what does work on them.
    double support(const Vec3& v, Vec3& point, Mat3* curvature = nullptr) const;
    const Vec3& strength() const { return strength_; }  ///< N m, N m, N

    /// Forces (Mx, My, N) of the state whose pressed edge is in the direction (cos angle, sin angle), at this depth of
    /// the neutral axis from it, m; N m and N.
    static Vec3 forces(const Outline& outline, const Reinforcement& concrete, const ConcreteStrains& strains,
                       double angle, double depth);

private:
    void fit(const std::vector<Vec3>& to, const std::vector<double>& work);
    void match_ends(double tension, double compression);
    void find_middles();

    std::vector<double> x_, y_, n_, weight_;  ///< whole blocks of eight
    std::vector<double> middle_[4];           ///< of each block: its middle, and the farthest of its points from there
    Vec3 strength_ = Vec3::Ones(), centre_ = Vec3::Zero();
};

}  // namespace hinge::beam

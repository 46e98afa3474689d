// Laws of sections that are given by the work of their flow.
//
// A section whose plastic deformation grows by e (rotations about x and y, elongation, twist) dissipates D(e), the
// greatest work q . e of resultants q within its yield surface. D is convex and, without rate, of the first degree; its
// gradient is the point of the surface whose normal is e. An implicit step of associated flow minimises
//
//   G(e) = (elastic energy of what is left of the deformation) + sum of D(e_i) over the sections
//
// which is convex, so that it has one least value, and a step down from any start leads there. This holds at corners of
// the surface too, where D has no curvature, and where an end does not flow: e_i = 0 is the tip of D.
//
// A law derives from PotentialLaw and says D, its two derivatives, and which way a section flows at first.
#pragma once

#include "beam/section_law.h"

namespace hinge::beam {

class PotentialLaw : public SectionLaw {
public:
    ReturnMapResult return_to_surface(const Vec6& trial, const Stiffness& k, const double* sections, int n,
                                      const FixedEnd& fixed_end) const override;
    ElementFlow return_alone(const Vec6& trial, const Stiffness& k, const FixedEnd& fixed_end,
                             const ElementFlow& before) const override;
    double work_of(const FixedEnd& part, const ElementFlow& flow, const double* sections, int n,
                   const FixedEnd& fixed_end) const override;
    Mat6 tangent(const ElementFlow& flow, const Stiffness& k, const double* sections, int n,
                 const FixedEnd& fixed_end) const override;
    Mat12 pair_tangent(const Mat12& elastic, const ElementFlow* const (&flow)[2],
                       const FixedEnd* fixed_end) const override;

protected:
    /// `strength`: Mx0, My0 (N m), N0 (N), Mz0 (N m); infinite: that resultant never yields the section. All that
    /// follows is normalised by it: q over the strength, e times the strength, J.
    PotentialLaw(const YieldSurface& screen, const Vec4& strength);

    /// D(e), J; `q`: its gradient; `curvature`: its second derivatives, 1/J. e is not zero.
    virtual double potential(const Vec4& e, Vec4& q, Mat4& curvature) const = 0;
    /// About the direction in which a section flows under q, not zero: where the search may start.
    virtual Vec4 direction(const Vec4& q) const = 0;
    /// Where q is outside of the yield surface: a direction e with q . e > D(e), and true. Else false. Where that is
    /// not found out: a direction that is not a number, and true.
    virtual bool outside(const Vec4& q, Vec4& direction) const = 0;

    Vec4 normalised(const Vec4& q) const { return q.cwiseProduct(per_strength_); }

private:
    struct End;
    ElementFlow find(const Vec6& trial, const Stiffness& k, const double* sections, int n, const FixedEnd& fixed_end,
                     const ElementFlow* before) const;
    enum class Search { found, not_below, lost };
    Search descend(const Vec4& k, const Vec4& trial, Vec4& e) const;
    bool one_end(const Vec4& k, const Vec4& trial, Vec4& e) const;
    bool both_ends(const Vec6& trial, const Stiffness& k, End (&ends)[2]) const;
    bool curvature_of(const ElementFlow& flow, int section, double stiffest, Mat4& out) const;

    Vec4 per_strength_;
};

}  // namespace hinge::beam

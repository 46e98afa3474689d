// What the plastic flow of a section is found from: the work of its plastic deformation, its strengths, its material.
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
// Hardening and rate change D to Phi(D(e)) + b . e + e . C e / 2. Phi is the integral of the factor on the strength
// over D, b the back resultants at the start of the step, and C e what the step adds to them. G is convex still, as
// long as the factor does not fall. A factor that follows the rotation of a hinge may fall: it is constant in a round
// of the search, and the next round takes it as it is where the round before led. From the start of the step the rounds
// come to the first state of equilibrium on the way down, since a weaker hinge turns farther. The ends of a pair are
// tried first with the factor of the flow that they have (flow_pair.cpp).
//
// Resultants q are normalised by the strengths, and e is the plastic deformation times these, J.
#pragma once

#include <memory>
#include <vector>

#include "section/material_law.h"

namespace hinge::beam {

using MaterialLaws = std::vector<std::shared_ptr<const MaterialLaw>>;

/// What the material adds to the law of a section; nothing where `laws` is empty.
struct SectionMaterial {
    MaterialLaws laws = {};
    PlasticZone zone = {};
};

/// The work D(e) of a section's plastic deformation, and the yield surface that belongs to it. `own`: history variables
/// of the law itself, on which the surface depends; null: they are 0.
class PlasticWork {
public:
    /// D(e), J; `q`: its gradient; `curvature`: its second derivatives, 1/J. e is not zero.
    virtual double potential(const Vec4& e, const double* own, Vec4& q, Mat4& curvature) const = 0;
    /// About the direction in which a section flows under q, not zero: where the search may start.
    virtual Vec4 direction(const Vec4& q) const = 0;
    /// Where q is outside of the yield surface: a direction e with q . e > D(e), and true. Else false. Where that is
    /// not found out: a direction that is not a number, and true.
    virtual bool outside(const Vec4& q, const double* own, Vec4& direction) const = 0;
    /// What the work of e on the way of a step is more than that of its last forces, J, where the law's own variables
    /// have changed since the step before. `work`: D(e).
    virtual double more_on_the_way(const Vec4& e, const double* own, double work) const {
        return (void)e, (void)own, (void)work, 0;
    }

protected:
    ~PlasticWork() = default;
};

/// Work of a plastic deformation e and its derivatives: D alone, or with what hardening and rate make of it.
struct WorkOfFlow {
    double value = 0, initial = 0;  ///< J; initial: D(e)
    Vec4 q = Vec4::Zero();
    Mat4 curvature = Mat4::Zero();
    void scale(double t) { value *= t, initial *= t, curvature /= t; }
    /// A small change of e, where this is D alone: the curvature stays.
    void step(const Vec4& way) {
        const Vec4 more = curvature * way;
        value = initial += (q + 0.5 * more).dot(way);
        q += more;
    }
};

/// The constant side of the search for the flow of sections of one law. Its functions evaluate the material's laws.
struct FlowProblem {
    using Moment = MaterialLaw::Moment;

    /// `strength`: Mx0, My0 (N m), N0 (N), Mz0 (N m); infinite: that resultant never yields the section.
    /// `remembers_flow`: four history variables keep the last e of each section, from which the next search starts.
    /// `own_variables`: number of history variables of the law itself.
    FlowProblem(const PlasticWork& of, const Vec4& strength, SectionMaterial with, bool remembers_flow,
                int own_variables);

    const PlasticWork& work;
    Vec4 per_strength;  ///< 1 over the strength
    SectionMaterial material;
    // where in the history the last e is, and the law's own variables; -1: nowhere
    int history_size = 0, flow_at = -1, own_at = -1;
    bool moves_surface = false, back_follows_strain = false, back_follows_flow = false, follows_rotation = false,
         follows_rate = false, wears_stiffness = false;

    bool keeps_strength() const { return material.laws.empty(); }
    /// True if the flow is found in rounds, each of which holds constant what follows the flow.
    bool in_rounds() const { return back_follows_strain || back_follows_flow || follows_rotation; }
    /// Where the law's own variables are in the history of a section; null where it has none.
    const double* own(const double* history) const { return history && own_at >= 0 ? history + own_at : nullptr; }

    /// D(e): all the work, without hardening.
    WorkOfFlow work_at(const Vec4& e, const double* own_variables) const;
    /// The product of the factors of all material laws. `history`: null for a section that has not flowed.
    MaterialLaw::Factor factor_at(const double* history, double strain, const Moment& at) const;
    /// The mean of the factor while the mean plastic strain grows by `strain`: that of the work (`of_work`), for which
    /// the rate is that of the whole step, or that of Phi.
    double mean_factor(const double* history, double strain, const Moment& at, bool of_work) const;
    /// The factor that follows the rotation, after a step with e that did `work` at the initial strength.
    MaterialLaw::Turned turned(const double* history, const Vec4& e, double work) const;
    double mean_turned(const double* history, const Vec4& e, double work) const;
    /// MaterialLaw::add_back and more_by_back of all material laws.
    void add_back(const double* history, double strain, const Vec4& e, Vec4& back, Vec4& modulus) const;
    double more_by_back(const double* history, double strain, const Vec4& e) const;
    /// Normalised resultants against a yield surface that neither moves nor grows.
    Vec4 relative(const Vec4& q, const double* history, const Moment& at) const;
    /// Plastic deformation of a section (ElementFlow::section), normalised.
    Vec4 normalised(const Vec4& flow) const;
};

}  // namespace hinge::beam

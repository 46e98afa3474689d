// Laws of sections that are given by the work of their flow, with what the material adds to them.
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
// come to the first state of equilibrium on the way down, since a weaker hinge turns farther.
//
// A law derives from PotentialLaw and says D, its two derivatives, and which way a section flows at first.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "section/material_law.h"
#include "section/section_law.h"

namespace hinge::beam {

using MaterialLaws = std::vector<std::shared_ptr<const MaterialLaw>>;

/// What the material adds to the law of a section; nothing where `laws` is empty.
struct SectionMaterial {
    MaterialLaws laws = {};
    PlasticZone zone = {};
};

class PotentialLaw : public SectionLaw {
public:
    std::string words() const override;
    bool keeps_strength() const override { return material_.laws.empty(); }
    bool calls_script() const override {
        return std::any_of(material_.laws.begin(), material_.laws.end(),
                           [](const auto& l) { return l->calls_script(); });
    }
    int history_size() const override { return history_size_; }
    bool moves_surface() const override { return moves_surface_; }
    void start(bool end_of_member, double* history) const override;
    void commit(const ElementFlow& flow, int section, double dt, double* history) const override;
    double stored(const double* history) const override;
    bool wears_stiffness() const override { return wears_stiffness_; }
    double softness(const double* history, const ElementFlow* flow, int section) const override;
    double yield_function(const Vec4& q, const double* history = nullptr,
                          double temperature = room_temperature) const override;
    bool surely_elastic(const Vec6& p, const double* sections, int n, const SectionConditions& at) const override;
    ReturnMapResult return_to_surface(const Vec6& trial, const Stiffness& k, const double* sections, int n,
                                      const SectionConditions& at) const override;
    ElementFlow return_alone(const Vec6& trial, const Stiffness& k, const SectionConditions& at,
                             const ElementFlow& before) const override;
    bool in_rounds() const override { return back_follows_strain_ || back_follows_flow_ || follows_rotation_; }
    bool next_round(const ElementFlow& flow, const SectionConditions& at, double tolerance,
                    HeldRound& held) const override;
    bool return_together(const PairElastic& pair, const SectionConditions* at, double tolerance,
                         ElementFlow (&flow)[2]) const override;
    double work_of(const FixedEnd& part, const ElementFlow& flow, const double* sections, int n,
                   const SectionConditions& at) const override;
    Mat6 tangent(const ElementFlow& flow, const Stiffness& k, const double* sections, int n,
                 const SectionConditions& at) const override;
    Mat12 pair_tangent(const Mat12& elastic, const ElementFlow* const (&flow)[2],
                       const SectionConditions* at) const override;

protected:
    /// `strength`: Mx0, My0 (N m), N0 (N), Mz0 (N m); infinite: that resultant never yields the section. All that
    /// follows is normalised by it: q over the strength, e times the strength, J.
    /// `remembers_flow`: four history variables keep the last e of each section, from which the next search starts.
    PotentialLaw(const YieldSurface& screen, const Vec4& strength, SectionMaterial material,
                 bool remembers_flow = false, int own_variables = 0);
    /// What the work of e on the way of a step is more than that of its last forces, J, where the law's own variables
    /// have changed since the step before. `work`: D(e).
    virtual double more_on_the_way(const Vec4& e, const double* own, double work) const {
        return (void)e, (void)own, (void)work, 0;
    }
    /// Where the law's own variables are in the history of a section; null where it has none.
    const double* own(const double* history) const { return history && own_at_ >= 0 ? history + own_at_ : nullptr; }
    int own_at() const { return own_at_; }

    // `own` of these: the law's own history variables, of which there are `own_variables`; null: they are 0.

    /// D(e), J; `q`: its gradient; `curvature`: its second derivatives, 1/J. e is not zero.
    virtual double potential(const Vec4& e, const double* own, Vec4& q, Mat4& curvature) const = 0;
    /// About the direction in which a section flows under q, not zero: where the search may start.
    virtual Vec4 direction(const Vec4& q) const = 0;
    /// Where q is outside of the yield surface: a direction e with q . e > D(e), and true. Else false. Where that is
    /// not found out: a direction that is not a number, and true.
    virtual bool outside(const Vec4& q, const double* own, Vec4& direction) const = 0;

    /// Yield function of normalised resultants.
    virtual double shape_function(const Vec4& q, const double* own) const = 0;
    /// True only if q is within the yield surface; cheap, and false says nothing.
    virtual bool surely_inside(const Vec4& q, const double* own) const = 0;

private:
    using Moment = MaterialLaw::Moment;
    struct End;
    struct Work;
    struct SoFar;
    SoFar so_far(const ElementFlow& flow, int section, const double* history) const;
    bool back_is_found(const End& end, const SectionConditions& at, int section, const SoFar& now,
                       const Vec6& trial) const;
    double more_by_back(const double* history, double strain, const Vec4& e) const;
    SoFar add_flow(const End& end, int section, ElementFlow& out) const;
    ElementFlow find_round(const Vec6& trial, const Stiffness& k, const double* sections, int n,
                           const SectionConditions& at, const ElementFlow* before, HeldRound& held,
                           bool* settled) const;
    ElementFlow find(const Vec6& trial, const Stiffness& k, const double* sections, int n, const SectionConditions& at,
                     const ElementFlow* before) const;
    bool find_ends(const Vec6& trial, const Stiffness& k, End (&ends)[2], int n, const ElementFlow* before) const;
    enum class Search { found, not_below, lost };
    Search descend(const End& end, const Vec4& trial, Vec4& e) const;
    bool one_end(const End& end, const Vec4& trial, Vec4& e) const;
    class Together;
    struct PairEnd;
    bool on_ray_of_pair(const PairElastic& pair, PairEnd* const (&flowing)[4], int count) const;
    template <int count>
    bool solve_pair(const PairElastic& pair, PairEnd* const (&flowing)[4], double tolerance, Vec6 (&p)[2]) const;
    bool alone(const Vec6& trial, const Stiffness& k, End (&ends)[2], int i) const;
    bool on_ray(End& end, const Vec4& q) const;
    bool starts(End& end, const Vec4& q) const;
    bool both_ends(const Vec6& trial, const Stiffness& k, End (&ends)[2]) const;
    bool beyond(const End& end, const Vec4& q, Vec4& direction) const;
    Work work_at(const Vec4& e, const double* own) const;
    bool along_ray(const End& end, const Vec4& trial, Vec4& e, Work& work) const;
    void harden(const End& end, const Vec4& e, Work& work) const;
    MaterialLaw::Factor factor_at(const double* history, double strain, const Moment& at) const;
    double mean_factor(const double* history, double strain, const Moment& at, bool of_work) const;
    double mean_strain(const ElementFlow& flow, int section, const double* history) const;
    MaterialLaw::Turned turned(const double* history, const Vec4& e, double work) const;
    bool curvature_of(const ElementFlow& flow, int section, const End& end, Mat4& out) const;
    Vec4 normalised_flow(const ElementFlow& flow, int section) const;
    Vec4 relative(const Vec4& q, const double* history, const Moment& at) const;

    Vec4 per_strength_;
    SectionMaterial material_;
    // where in the history the last e is, and the law's own variables; -1: nowhere
    int history_size_ = 0, flow_at_ = -1, own_at_ = -1;
    bool moves_surface_ = false, back_follows_strain_ = false, back_follows_flow_ = false, follows_rotation_ = false,
         wears_stiffness_ = false;
};

}  // namespace hinge::beam

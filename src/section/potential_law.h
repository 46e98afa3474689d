// Laws of sections that are given by the work of their flow (flow_problem.h), with what the material adds to them.
#pragma once

#include "section/flow_problem.h"
#include "section/section_law.h"

namespace hinge::beam {

/// A law of associated flow. A law derives from it and gives the functions of PlasticWork, and its yield function.
class PotentialLaw : public SectionLaw, protected PlasticWork {
public:
    std::string words() const override;
    bool keeps_strength() const override { return problem_.keeps_strength(); }
    bool calls_script() const override;
    int history_size() const override { return problem_.history_size; }
    bool moves_surface() const override { return problem_.moves_surface; }
    void start(bool end_of_member, double* history) const override;
    void commit(const ElementFlow& flow, int section, double dt, double* history) const override;
    double stored(const double* history) const override;
    bool wears_stiffness() const override { return problem_.wears_stiffness; }
    double softness(const double* history, const ElementFlow* flow, int section) const override;
    double yield_function(const Vec4& q, const double* history = nullptr,
                          double temperature = room_temperature) const override;
    bool surely_elastic(const Vec6& p, const double* sections, int n, const SectionConditions& at) const override;
    ReturnMapResult return_to_surface(const Vec6& trial, const Stiffness& k, const double* sections, int n,
                                      const SectionConditions& at) const override;
    ElementFlow return_alone(const Vec6& trial, const Stiffness& k, const SectionConditions& at,
                             const ElementFlow& before) const override;
    bool in_rounds() const override { return problem_.in_rounds(); }
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
    /// `screen`: SectionLaw; the rest: FlowProblem.
    PotentialLaw(const YieldSurface& screen, const Vec4& strength, SectionMaterial material,
                 bool remembers_flow = false, int own_variables = 0);
    const FlowProblem& problem() const { return problem_; }

    /// Yield function of normalised resultants. `own`: PlasticWork.
    virtual double shape_function(const Vec4& q, const double* own) const = 0;
    /// True only if q is within the yield surface; cheap, and false says nothing.
    virtual bool surely_inside(const Vec4& q, const double* own) const = 0;

private:
    FlowProblem problem_;
};

}  // namespace hinge::beam

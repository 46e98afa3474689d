// Newmark's beta method, one linear solution a step (paper, eq 15), or Newton's method; with Bossak's alpha.
//
// Eq 15 has M a' + K du = F - R_t with du = dt v + dt^2 ((1/2 - beta) a + beta a'). Here the part of du that is known
// when the step begins, dt v + dt^2 a / 2, is applied first and the stresses are recovered there, exactly; what is left
// to solve for is the change of the acceleration, (M + beta dt^2 K) da = F - R(predicted) - M a. For a linear structure
// this is eq 15 as printed; for one that rotates and yields, the force out of balance is not carried to the next step
// but balanced in this one. Steps longer than the fastest waves need are solved from du = 0 instead, as eq 15 is
// written (displacement predictor).
//
// With du = 0 supports that move start from where they were, as all nodes do. The first solution has their way over the
// step on its right side: (M + beta dt^2 K)_ff da_f = F - R - M a - K_fs du_s. In a trial with the supports moved and
// all else left behind, the elements beside them have strains of V dt / l, which the solution does not have; where
// members yield, they would flow there.
#pragma once

#include <unordered_map>

#include "algebra/massless.h"
#include "run/implicit_integrator.h"

namespace hinge {

class Newmark : public ImplicitIntegrator {
public:
    Newmark(Workspace& w, KeptMass& mass, Stages& stages, const DynamicSettings& settings);

    void prepare(const EffectList& effects) override;
    void begin(const EffectList& effects) override;
    void start_from_forces() override;
    void predict(const Step& step) override;
    void prescribed(const Step& step) override;
    void recovered(const Step& step) override;
    void solve(Step& step) override;
    bool correct(Step& step) override;
    bool may_go_on(const Step& step) const override { return iterations_ == 1 && step.iteration < most_unsettled; }
    void solved(const Step& step) override;
    bool recovers_last() const override { return displacement_predictor_; }
    void recovered_last() override;
    int correct_stage() override { return correct_stage_; }
    double dissipated(const Step& step) const override;
    void before_commit() override;
    void after_commit() override;

    double jump() const override { return jump_; }

    void save(Writer& to) const override;
    void restore(Reader& from) override;

private:
    /// Prescribed displacement over a step, m.
    struct Way {
        DegreeOfFreedom of;
        double length;
    };
    static constexpr int most_unsettled = 8;  ///< iterations that contact may ask for
    template <class Self, class A>
    static void fields(Self& s, A& a);
    void mark_yielding(bool begins);
    void renew_effective_stiffness();
    void solve_for_change(Step& step);
    void take_out_ways();
    void find_massless();
    void rotate_by_spins(double to_u);
    bool rotates_by_rounding(double to_u) const;

    const DynamicSettings& settings_;
    bool displacement_predictor_;
    int iterations_;
    double tolerance_;
    int yield_stage_ = -1, stiffness_stage_, solve_stage_, correct_stage_;
    std::vector<MasslessNode> massless_;
    std::vector<Vec6> loose_;        ///< F - R on what is massless, where forces have set in at once; empty: in balance
    bool massless_changes_ = false;  ///< elements or joints may break, and leave nodes without mass
    std::vector<Way> ways_;          ///< of supports over the step, with the displacement predictor
    std::vector<double> lumped_;     ///< kg, of each node: the weights of velocities and changes
    std::vector<Vec3> spin_;         ///< rad, of each node, in a correction of a long step
    std::vector<Quat> rotated_;      ///< and its rotation after it
    std::vector<Mat6> tangents_;     ///< of the elements that flow
    std::vector<int> was_yielding_;
    std::vector<PlasticIncrement> hinges_;  ///< of the last step, with the displacement predictor
    std::unordered_map<int, Mat6> built_;   ///< D_p in the effective stiffness, of the elements that have it there
    double first_change_ = 0;
    double rounding_ = 0;           ///< m: root of the sum of squares of corrections that are the coordinates' rounding
    double jump_ = 0, motion_ = 0;  ///< of the last step: dt |da| / |v|; sum of m v^2
};

}  // namespace hinge

// The energy-momentum method: implicit steps that conserve energy and momentum in rotations of any size.
//
// Over a step dt the equation of motion is (p' - p)/dt + f = F, with the momenta p of the nodes at its two ends and
// mean forces f and F; nodes move by their mean velocity. A node rotates by the Cayley vector c, 2 tan(angle/2) along
// the axis: every vector n that it carries moves by c x (n + n')/2, exactly. With W = R^T w the spin in the node's own
// axes, c = dt R (W + W')/2, so that a free body keeps its energy and its angular momentum (Simo and Wong, Int. J. Num.
// Meth. Eng. 31, 1991, ALGO_C1). The sections' rotary inertia turns with the nodes (MassKind::at_nodes).
//
// The deformation of an element depends on its chord x and on the axes n of its two nodes through their products alone:
// x.x, x.n and n.n, sixteen of them. Of a product a.b the change is exactly a_m.db + b_m.da with the means a_m, b_m of
// the two ends. So any forces on the products, carried to the nodes with the mean vectors, balance each other, and do
// exactly the work that they do on the products (Simo and Tarnow, J. Appl. Math. Phys. 43, 1992; Betsch and Steinmann,
// Int. J. Num. Meth. Eng. 54, 2002). The forces on the products are the mean p of the ends times the mean derivative of
// the deformation, and a correction along the change of the products that makes their work that of p on the deformation
// (Gonzalez, J. Nonlinear Sci. 6, 1996). What an element takes in over a step is then the change of its strain energy
// and what its hinges dissipate, (p + p')/2 . dd_p, never negative; to rounding, for steps of any length.
//
// Forces of effects, and loads, are the mean of the two ends; their accounts are counted so too (trapezium rule).
//
// Newton's method, with the effective stiffness M + dt^2/4 K of Newmark's method at the middle of the step.
#pragma once

#include "run/implicit_integrator.h"

namespace hinge {

class EnergyMomentum : public ImplicitIntegrator {
public:
    EnergyMomentum(Workspace& w, KeptMass& mass, Stages& stages, const DynamicSettings& settings);

    void begin(const EffectList& effects) override;
    void start_from_forces() override;
    void predict(const Step& step) override;
    void recovered(const Step& step) override;
    void solve(Step& step) override;
    bool correct(Step& step) override;
    bool recovers_last() const override { return true; }
    void recovered_last() override;
    int correct_stage() override { return correct_stage_; }
    void before_commit() override;
    void after_commit() override;

    void removed(int element) override;

    void save(Writer& to) const override;
    void restore(Reader& from) override;

private:
    static constexpr int products = 16;
    using Products = Eigen::Matrix<double, products, 1>;
    /// An element at one end of a step.
    struct AtEnd {
        Vec3 chord;    ///< m
        Mat3 axes[2];  ///< of its two nodes: columns, in space
        Vec6 d, p;     ///< deformation; forces on it
        Products s;    ///< products, without dimension
        ElementFrame place;
    };
    template <class Self, class A>
    static void fields(Self& s, A& a);
    AtEnd at_end(int element, const Pose& at) const;
    void find_node_inertia();
    void begin_elements();
    static Products on_products(const AtEnd& end, double L, const Vec6& p);
    double work_beyond_means(int first, const AtEnd (&b)[2]) const;
    double work_on_slack(int index) const;
    Vec12 mean_forces(int element, const AtEnd& b, double beyond) const;
    void find_elements_forces();
    void mark_changed(int iteration);
    void renew_effective_stiffness();
    void find_out_of_balance(Step& step);
    Vec6 momentum_of(int node, const std::vector<Vec6>& velocity, const Quat& rotation) const;

    const DynamicSettings& settings_;
    int most_iterations_;
    double tolerance_;
    int forces_stage_, stiffness_stage_, solve_stage_, correct_stage_;
    struct TranslationalMass {
        double own[2], across;
    };
    std::vector<TranslationalMass> mass_of_;    ///< of each element, kg
    std::vector<Mat3> rotary_;                  ///< of each node in its own axes: of its elements, kg m^2
    std::vector<Vec6> held_by_effects_, load_;  ///< forces of effects and loads where the step begins
    std::vector<Vec6> internal_;                ///< of the elements, where stresses were recovered last
    std::vector<AtEnd> first_;                  ///< of each element, where the step begins
    std::vector<Vec12> of_element_;             ///< mean forces of each element on its nodes
    std::vector<Vec6> momentum_;                ///< of each node where the step begins
    Configuration middle_;
    std::vector<char> has_turned_;
    std::vector<Mat3> built_;                       ///< frame of each element in the effective stiffness
    std::vector<int> flowing_;                      ///< elements of which the effective stiffness has a plastic tangent
    double step_ = 0;                               ///< s
    double floor_ = 0, first_size_ = 0, size_ = 0;  ///< J: energies of a correction
};

}  // namespace hinge

// Linear constraints between degrees of freedom: what is solved with them, against dense T^T A T; and what is refused.
#include <Eigen/Cholesky>
#include <map>
#include <numeric>

#include "algebra/mass_matrix.h"
#include "core/errors.h"
#include "helpers.h"

using namespace hinge;
using namespace hinge::test;

namespace {

/// Of one component on three nodes, and of all of a node on another one by an arm.
std::vector<LinearConstraint> constraints_of(const SpaceFrame& frame) {
    const int a = frame.top[0], b = frame.top[1], c = frame.top[2], d = frame.top[3];
    std::vector<LinearConstraint> list{{"test", {b, 0}, {{{a, 0}, 0.3}, {{c, 1}, 0.7}, {{a, 5}, -0.2}}},
                                       {"test", {b, 5}, {{{c, 5}, 1}}}};
    const Vec3 arm(0.1, -0.2, 0.3);
    for (int k = 0; k < 6; ++k) {
        list.push_back({"test", {d, k}, {{{a, k}, 1}}});
        for (int r = 0; k < 3 && r < 3; ++r) list.back().terms.push_back({{a, 3 + r}, Vec3::Unit(r).cross(arm)[k]});
    }
    return list;
}

/// T of the free degrees of freedom, which are these.
Eigen::MatrixXd dense_T(const std::vector<int>& free, const std::vector<LinearConstraint>& constraints) {
    std::map<int, int> row;
    for (int i = 0; i < int(free.size()); ++i) row[free[i]] = i;
    const auto at = [&](const DegreeOfFreedom& of) { return row.at(6 * of.node + of.component); };
    Eigen::MatrixXd T = Eigen::MatrixXd::Identity(free.size(), free.size());
    std::vector<int> left(free.size());
    std::iota(left.begin(), left.end(), 0);
    for (const LinearConstraint& c : constraints) {
        T(at(c.dependent), at(c.dependent)) = 0;
        for (const LinearConstraint::Term& term : c.terms) T(at(c.dependent), at(term.of)) += term.factor;
        std::erase(left, at(c.dependent));
    }
    return T(Eigen::all, left);
}

struct Case {
    SpaceFrame frame{small_displacement(), 0, infinite};
    std::shared_ptr<const Structure> structure;
    State state;
    std::vector<LinearConstraint> constraints;
    std::vector<Vec6> right;

    explicit Case(MassKind mass = MassKind::consistent)
        : structure(std::make_shared<const Structure>(frame.model, mass)),
          state(initial_state(*structure)),
          constraints(constraints_of(frame)),
          right(state.held.size()) {
        for (std::size_t i = 0; i < right.size(); ++i)
            for (int c = 0; c < 6; ++c) right[i][c] = state.held[i] >> c & 1 ? 0 : std::sin(1.0 + double(6 * i) + c);
    }
    /// The largest difference from the dense solution, as a part of its largest number.
    double off(const std::vector<Vec6>& x, double mass_factor, double stiffness_factor) const {
        std::vector<int> free;
        const Eigen::MatrixXd A = dense(*structure, mass_factor, stiffness_factor, &free),
                              T = dense_T(free, constraints);
        Eigen::VectorXd f(free.size());
        for (std::size_t i = 0; i < free.size(); ++i) f[i] = right[free[i] / 6][free[i] % 6];
        const Eigen::VectorXd wanted = T * (T.transpose() * A * T).ldlt().solve(T.transpose() * f);
        double worst = 0;
        for (std::size_t i = 0; i < free.size(); ++i)
            worst = largest_of(worst, std::abs(x[free[i] / 6][free[i] % 6] - wanted[i]));
        return worst / largest_entry(wanted);
    }
    double off_dense(MatrixStorage storage) const {
        const double m = 1, k = 1e-6;
        ThreadPool alone;
        EffectiveStiffness A(*structure, alone, m, k, false, storage);
        const Reduction reduction(*structure, state.held, constraints);
        A.set_reduction(&reduction);
        A.set_held(state.held);
        std::vector<int> all(structure->elements().size());
        std::iota(all.begin(), all.end(), 0);
        A.build(all, state, state, {});
        A.assemble();
        SolverSettings settings{.direct = storage == MatrixStorage::direct, .tolerance = 1e-12};
        std::vector<Vec6> x(right.size(), Vec6::Zero());
        REQUIRE(A.solve(right, x, settings).converged);
        return off(x, m, k);
    }
    double mass_off_dense() const {
        Mass mass(*structure, state);
        const Reduction reduction(*structure, state.held, constraints);
        mass.set_reduction(&reduction);
        std::vector<Vec6> x(right.size(), Vec6::Zero());
        REQUIRE(mass.solve(right, x, state, 1e-13).converged);
        return off(x, 1, 0);
    }
};

}  // namespace

TEST_CASE("solutions with constraints are those of the dense matrix") {
    CHECK_FIGURE("by factors", Case().off_dense(MatrixStorage::direct), 1e-9);
    CHECK_FIGURE("by conjugate gradients", Case().off_dense(MatrixStorage::iterative), 1e-8);
    CHECK_FIGURE("in single precision", Case().off_dense(MatrixStorage::single_precision), 1e-3);
    CHECK_FIGURE("consistent mass alone", Case().mass_off_dense(), 1e-9);
    CHECK_FIGURE("lumped mass alone", Case(MassKind::lumped).mass_off_dense(), 1e-9);
}

TEST_CASE("constraints that contradict each other are refused") {
    const Case c;
    const auto make = [&](std::vector<LinearConstraint> list) { Reduction(*c.structure, c.state.held, list); };
    const int a = c.frame.top[0], b = c.frame.top[1], held = c.frame.foot[0];
    CHECK_THROWS_WITH(make({{"test", {held, 0}, {{{a, 0}, 1}}}}), Catch::Contains("held by a support"));
    CHECK_THROWS_WITH(make({{"test", {a, 0}, {{{b, 0}, 1}}}, {"test", {a, 0}, {{{b, 1}, 1}}}}),
                      Catch::Contains("already depends"));
    CHECK_THROWS_WITH(make({{"test", {a, 0}, {{{b, 0}, 1}}}, {"test", {b, 0}, {{{a, 1}, 1}}}}),
                      Catch::Contains("depends on another node itself"));
}

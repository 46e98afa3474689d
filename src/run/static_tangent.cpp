#include "run/static_tangent.h"

#include <algorithm>
#include <set>

#include "core/doing.h"
#include "core/errors.h"
#include "run/constraints.h"
#include "run/effect_forces.h"
#include "run/pair_compression.h"
#include "run/yield_tangents.h"

namespace hinge {
namespace {

/// Minimum fraction of the elastic stiffness kept at hinges, in the tangent alone: it keeps the tangent from being
/// singular where hinges stand on both sides of a node, or make a second mechanism beside the one that is driven. Where
/// N and M yield together, a mechanism keeps a small stiffness of its own, because N moves along the yield surface. A
/// fraction that is larger than that lets Newton's method creep. So it falls with the out-of-balance force.
double hinge_regularisation(double off_balance) { return std::clamp(1e-3 * off_balance, 1e-9, 1e-4); }

std::unique_ptr<EffectiveStiffness> make_matrix(const StaticProblem& p, MatrixStorage storage) {
    auto matrix = std::make_unique<EffectiveStiffness>(p.w.structure, p.w.pool, 0.0, 1.0, true, storage);
    if (p.w.constraints) matrix->set_reduction(&p.w.constraints->reduction());
    matrix->set_held(p.held);
    return matrix;
}

}  // namespace

StaticTangent::StaticTangent(const StaticProblem& problem, StaticForces& forces, Stages& stages)
    : problem_(problem),
      w_(problem.w),
      forces_(forces),
      matrix_(make_matrix(problem, MatrixStorage::direct)),
      stages_(stages),
      build_stage_(stages.add("stiffness")),
      factorise_stage_(stages.add("solve")) {}

void StaticTangent::keep_unsymmetric() {
    matrix_ = make_matrix(problem_, MatrixStorage::unsymmetric);
    unsymmetric_ = true;
    built_ = false;
}

/// Rising. With large displacement or heat all change, else those that yield or did when they were built.
std::vector<int> StaticTangent::elements_to_build() const {
    std::vector<int> list;
    if (w_.structure.large() || !w_.trial.heat.empty() || !built_) {
        for (std::size_t i = 0; i < w_.state.broken.size(); ++i)
            if (!w_.state.broken[i]) list.push_back(int(i));
        return list;
    }
    list = was_yielding_;
    for (const PlasticIncrement& y : w_.yielding) list.push_back(y.element);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
}

/// Those of yielded elements and their partners, with `hinge_stiffness` times the elastic stiffness.
std::vector<ElementTangent> StaticTangent::plastic_tangents(const std::vector<int>& elements, double hinge_stiffness) {
    std::vector<ElementTangent> given =
        given_tangents(w_.structure, w_.state, w_.trial, w_.assembly, elements, w_.yielding);
    forces_.find_yielding_by_load(given);
    std::size_t next = 0;
    was_yielding_.clear();
    for (const PlasticIncrement& y : w_.yielding) {
        const Element& e = w_.structure.elements()[y.element];
        const beam::Rigidity& r = e.rigidity;
        Vec6 bare;
        bare << r.EIx, r.EIx, r.EIy, r.EIy, r.EA, r.GJ;
        while (given[next].element < y.element) ++next;
        given[next].own += hinge_stiffness * bare.asDiagonal().toDenseMatrix() / e.length;
        was_yielding_.push_back(y.element);
    }
    return given;
}

bool StaticTangent::renew(double off_balance, double hinge_stiffness) {
    if (asked_to_end) throw Interrupted("");  // a static run is done anew
    stages_.timed(build_stage_, [&] {
        const std::vector<int> list = elements_to_build();
        const std::vector<ElementTangent> plastic =
            plastic_tangents(list, std::max(hinge_regularisation(off_balance), hinge_stiffness));
        w_.force.swap(w_.state.force);  // the tangent's initial-stress part reads the forces of now
        matrix_->build(list, w_.state, w_.trial, plastic);
        Blocks blocks = added_blocks(problem_.effects, w_.trial, 0);
        if (!forces_.support_rates().empty()) find_forces_of_supports(plastic, blocks);
        w_.force.swap(w_.state.force);
        if (w_.constraints) add_curvature_of_constraints(blocks);
        const bool has_blocks = !blocks.pairs.empty() || !blocks.nodes.empty();
        if (has_blocks || had_blocks_) matrix_->set_blocks(std::move(blocks));
        had_blocks_ = has_blocks;
        built_ = true;
        matrix_->assemble();
    });
    bool good = false;
    stages_.timed(factorise_stage_, [&] { good = matrix_->factorise(); });
    return good;
}

void StaticTangent::find_forces_of_supports(const std::vector<ElementTangent>& plastic, const Blocks& blocks) {
    const std::vector<Vec6>& rates = forces_.support_rates();
    const std::vector<Element>& elements = w_.structure.elements();
    forces_of_supports_.assign(rates.size(), Vec6::Zero());
    const auto add = [&](int a, int b, const Mat12& K) {
        Vec12 x;
        x << rates[std::size_t(a)], rates[std::size_t(b)];
        const Vec12 f = K * x;
        forces_of_supports_[std::size_t(a)] += f.head<6>(), forces_of_supports_[std::size_t(b)] += f.tail<6>();
    };
    std::set<int> near;  // those of moving supports, with their partners
    for (std::size_t n = 0; n < rates.size(); ++n) {
        if (rates[n].isZero(0)) continue;
        for (int e : w_.structure.elements_at(int(n)))
            for (int of : {e, elements[std::size_t(e)].partner})
                if (of >= 0 && !w_.state.broken[std::size_t(of)]) near.insert(of);
    }
    for (int i : near) {
        const Element& e = elements[std::size_t(i)];
        const ElementPart part = matrix_->part(i, w_.state, w_.trial, plastic);
        add(e.node[0], e.node[1], part.A);
        if (i % 2 != 0 || e.partner < 0 || part.bridge.isZero(0)) continue;
        Mat12 across = Mat12::Zero();
        across.topRightCorner<6, 6>() = part.bridge;
        across.bottomLeftCorner<6, 6>() = part.bridge.transpose();
        add(e.node[0], elements[std::size_t(e.partner)].node[1], across);
    }
    for (const Coupling& c : blocks.pairs) add(c.a, c.b, c.K);
}

/// Its symmetric part where the tangent is kept as a symmetric one.
void StaticTangent::add_curvature_of_constraints(Blocks& blocks) const {
    const std::size_t others = blocks.nodes.size();
    w_.constraints->add_curvature(w_.trial, blocks);
    for (std::size_t i = others; i < blocks.nodes.size() && !unsymmetric_; ++i)
        blocks.nodes[i].K = (0.5 * (blocks.nodes[i].K + blocks.nodes[i].K.transpose())).eval();
}

bool StaticTangent::solve(const std::vector<Vec6>& forces, std::vector<Vec6>& displacements) {
    SolverSettings direct;
    direct.direct = true;
    return matrix_->solve(forces, displacements, direct).converged;
}

bool StaticTangent::more_negative_modes(int known) {
    return matrix_->more_negative_modes(known) || (known == 0 && modes_within_pairs() > 0);
}

/// The middle node of a pair of elements cannot bend out between ends that are clamped, which is what a beam does from
/// four times Euler's load of the pair on. The tangent does not show it, so that it is counted here (as in Wittrick and
/// Williams, Q. J. Mech. Appl. Math. 24, 1971). Two elements have it in one member, four or more between its nodes.
int StaticTangent::modes_within_pairs() {
    int modes = 0;
    double worst = 1;
    overloaded_member_ = -1;
    for (std::size_t i = 0; i + 1 < w_.structure.elements().size(); i += 2) {
        for (const double part : pair_compression(w_.structure, w_.state, w_.force, int(i)).part) {
            if (!(part > 1)) continue;
            ++modes;
            if (part > worst) worst = part, overloaded_member_ = w_.structure.elements()[i].member;
        }
    }
    return modes;
}

bool StaticTangent::take_that_of_state() {
    const bool known = of_state_ && w_.yielding.empty();
    of_state_ = of_trial_ = false;
    return known;
}

}  // namespace hinge

// Members that end at joints and at nodes which follow others are condensed for conjugate gradients: the solution is
// that of factors, which condense nothing.
#include <numeric>

#include "helpers.h"

using namespace hinge;
using namespace hinge::test;

namespace {

/// A frame of two storeys; its beams have joints at both ends, at one or at none, and 2, 4 or 8 elements.
struct JointedFrame : Frame {
    std::vector<int> corners[3];
    JointedFrame(bool p_delta, int count) : Frame({.p_delta = p_delta ? PDelta::member : PDelta::chord}) {
        section = square(0.1);
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < 4; ++i)
                corners[k].push_back(k ? node(5.0 * (i % 2), 4.0 * (i / 2), 3.0 * k)
                                       : foot(5.0 * (i % 2), 4.0 * (i / 2), 0));
        for (int k = 1; k < 3; ++k) {
            elements = 2;
            for (int i = 0; i < 4; ++i) member(corners[k - 1][i], corners[k][i]);
            elements = count;
            int joints = 3;
            for (const auto& [a, b] : {std::pair(0, 1), std::pair(2, 3), std::pair(0, 2), std::pair(1, 3)})
                model->add_member({.node = {corners[k][a], corners[k][b]},
                                   .section = section,
                                   .material = material,
                                   .up = Vec3::UnitZ(),
                                   .elements = count,
                                   .joints = std::uint8_t(joints-- & 3)});
        }
    }
};

struct Case {
    JointedFrame frame;
    std::shared_ptr<const Structure> structure;
    State state;
    std::vector<LinearConstraint> constraints;
    Blocks springs;
    std::vector<Vec6> right;

    /// `floors`: those of each storey follow the first node along x, y and about z.
    Case(bool p_delta, int count, bool floors)
        : frame(p_delta, count), structure(frame.build()), state(initial_state(*structure)) {
        Dice dice(7);
        const auto follow = [&](int node, int component, int of) {
            LinearConstraint c{"test", {node, component}, {{{of, component}, 1}}};
            if (!floors || of % 4 == 0 || (component != 0 && component != 1)) return constraints.push_back(c);
            constraints.push_back(floor_of(of, component));  // the leader follows a floor's node itself
            constraints.back().dependent = {node, component};
        };
        for (int k = 1; floors && k < 3; ++k)
            for (int i = 1; i < 4; ++i)
                for (int c : {0, 1, 5}) constraints.push_back(floor_of(frame.corners[k][i], c));
        for (int m = 0; m < int(frame.model->members().size()); ++m)
            for (int end : {0, 1}) {
                if (!frame.model->members()[m].has_joint(end)) continue;
                const int node = structure->end_node(m, end), leader = frame.model->members()[m].node[end];
                for (int c : {0, 1, 2}) follow(node, c, leader);
                Mat12 K = Mat12::Zero();
                for (int c : {0, 1, 2}) {
                    const double k = c == 0 ? 5e4 : 1e9;  // two axes nearly rigid
                    K(3 + c, 3 + c) = K(9 + c, 9 + c) = k, K(3 + c, 9 + c) = K(9 + c, 3 + c) = -k;
                }
                springs.stiffness(leader, node, K);
            }
        for (std::size_t i = 0; i < state.held.size(); ++i) {
            right.emplace_back();
            right.back() << dice.vector(100), dice.vector(100);
            for (int c = 0; c < 6; ++c)
                if (state.held[i] >> c & 1) right[i][c] = 0;
        }
    }
    LinearConstraint floor_of(int node, int component) const {
        const int first = node - node % 4;
        const Vec3 arm = structure->position()[node] - structure->position()[first];
        LinearConstraint c{"test", {node, component}, {{{first, component}, 1}}};
        if (component < 2) c.terms.push_back({{first, 5}, component == 0 ? -arm.y() : arm.x()});
        return c;
    }

    std::vector<Vec6> solution(MatrixStorage storage, int* iterations = nullptr) const {
        ThreadPool alone;
        EffectiveStiffness A(*structure, alone, 1, 0.25 * 1e-3 * 1e-3, false, storage);
        const Reduction reduction(*structure, state.held, constraints);
        A.set_reduction(&reduction);
        A.set_held(state.held);
        A.set_blocks(springs);
        std::vector<int> all(structure->elements().size());
        std::iota(all.begin(), all.end(), 0);
        A.build(all, state, state, {});
        A.assemble();
        std::vector<Vec6> x(right.size(), Vec6::Constant(7));
        const SolveReport report = A.solve(right, x, {.direct = storage == MatrixStorage::direct, .tolerance = 1e-12});
        REQUIRE(report.converged);
        if (iterations) *iterations = report.iterations;
        return x;
    }
};

}  // namespace

TEST_CASE("tied members: conjugate gradients find what factors find, in few iterations") {
    for (const bool p_delta : {false, true})
        for (const bool floors : {false, true})
            for (const int count : {2, 4, 8}) {
                const Case c(p_delta, count, floors);
                int iterations = 0;
                const std::vector<Vec6> x = c.solution(MatrixStorage::iterative, &iterations),
                                        exact = c.solution(MatrixStorage::direct);
                double most = 0, off = 0;
                for (std::size_t i = 0; i < x.size(); ++i) {
                    most = largest_of(most, largest_entry(exact[i]));
                    off = largest_of(off, largest_entry(Vec6(x[i] - exact[i])));
                }
                INFO((p_delta ? "member" : "chord")
                     << ", floors " << floors << ", " << count << " elements: " << iterations << " iterations");
                CHECK(off < 1e-7 * most);  // factors of nearly rigid springs have 1e-16 times 1e9 / 1e2
                CHECK(iterations < 60);    // 23 to 37; 161 where members of eight elements were not condensed
            }
}

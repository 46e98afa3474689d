// M by itself: what an impulse does to the nodes. Needed whenever forces begin or end at once, and in every explicit step.
//
// Consistent (paper, after eq 15): the first solution, a run's start, goes over the elements and puts nothing together; a run that
// needs more keeps M by blocks (parts.h) and solves on its joints (condensed.h). Lumped: half of each element on each of its nodes, the rotary inertia the section's polar one about every axis, so
// that a node's spin needs no frame and no gyroscopic moment.
#pragma once

#include <memory>

#include "sim/condensed.h"
#include "sim/sweep.h"

namespace hinge {

class Mass {
public:
    /// Of all whole elements and the stubs, where `state` has them.
    Mass(const Structure& structure, const State& state);

    /// Takes up what these elements have become at `pose`, and where the stubs are now; broken elements weigh nothing but as stubs.
    void renew(const std::vector<int>& elements, const State& state, const Pose& pose);
    /// Stubs alone: where `pose` has turned them.
    void turn_stubs(const State& state, const Pose& pose);
    /// change = M^-1 impulse (N s, N m s -> m/s, rad/s), nothing where `state` holds a freedom. `tolerance`: of the residual,
    /// relative; lumped masses need none.
    void solve(const std::vector<Vec6>& impulse, std::vector<Vec6>& change, const State& state, double tolerance);

    /// Of a node without stubs: 1/kg, and the inverse of its rotary inertia, 1/(kg m^2); zero where no element is left.
    struct Inverse { double mass = 0; Mat3 rotary = Mat3::Zero(); };
    const std::vector<Inverse>& inverse() const { return inverse_; }
    /// Lumped: the same, a number for each freedom, zero where it is held.
    const std::vector<Vec6>& lumped_inverse() const { return lumped_inverse_; }
    /// Of the nodes with stubs: what their elements weigh, what their stubs weigh, and the inverse of both; 6x6 in space. The
    /// inverse is of the freedoms that are not held; one for those that are.
    struct Heavy { int node; Mat6 elements, stubs, inverse; };
    const std::vector<Heavy>& heavy() const { return heavy_; }

private:
    Mat12 matrix(int element) const;
    void keep_blocks(const State& state);
    void take_up_held(const State& state);
    void mark(int node);
    void solve_over_elements(std::vector<Vec6> r, std::vector<Vec6>& change, const State& state, double tolerance) const;
    void multiply(const std::vector<Vec6>& x, std::vector<Vec6>& y) const;
    void by_node(const std::vector<Vec6>& r, std::vector<Vec6>& z, const State& state) const;

    const Structure& structure_;
    struct Part { double mass = 0; double rotary[6] = {}; };    ///< kg and kg m^2: of rho A L/6 and rho I L/6 (xx xy xz yy yz zz), in space
    std::vector<Part> part_;                                    ///< consistent, of each element
    std::vector<Inverse> inverse_;                              ///< lumped: M^-1; consistent: of its blocks on the diagonal
    std::vector<Vec6> lumped_inverse_;
    struct Blocks { Parts parts; Condensed<double> condensed; std::vector<int> dirty; std::vector<char> is_dirty; };
    Team alone_;
    std::unique_ptr<Blocks> blocks_;
    bool solved_ = false;
    std::vector<Heavy> heavy_;                                  ///< in order of their nodes
};

}  // namespace hinge

// The sweep over the elements, eight at a time: deformation, forces, yield, and inertia, summed into the nodes.
#pragma once

#include <array>
#include <vector>

#include "beam/corotation.h"
#include "beam/yield.h"
#include "sim/state.h"

namespace hinge {

/// Where the nodes are tried to be, and how they move there.
struct Pose {
    std::vector<Vec3> displacement;
    std::vector<Quat> rotation;
    std::vector<Vec3> turn;
    std::vector<Vec6> velocity, acceleration;
};

/// What one element did on the way to the pose.
struct Yielding {
    int element;
    beam::Flow flow;
};

class Sweep {
public:
    /// `inertia`: add consistent-mass inertia and gyroscopic forces of the pose's acceleration and velocity.
    Sweep(const Structure& structure, bool inertia);
    ~Sweep();

    /// Takes up which elements are whole and where their points stand. Call after a break or a whole shift.
    void take_up(const State& state);

    /// Adds internal (and inertia) forces at `pose` to `nodal` (N, N m; what resists), writes p of each element to `force`,
    /// and lists the elements whose plastic deformation grows. Reads plastic deformation from `state`, changes nothing in it.
    void run(const State& state, const Pose& pose, std::vector<Vec6>& nodal, std::vector<Vec6>& force, std::vector<Yielding>& yielding);

    /// Elements whose frame has turned by more than `tolerance` (rad) since they were last marked. Filled by run.
    const std::vector<int>& turned() const { return turned_; }
    void watch_turning(double tolerance) { turn_limit_ = tolerance * tolerance; }
    /// Marks the present frame of the element at `pose` as the one its stiffness was built for.
    void mark_built(int element, const Mat3& frame);

    int sections(double* r) const;  ///< positions that can yield: both ends, or the middle (conventional)
    long updates() const { return updates_; }

private:
    struct Block;
    template <bool large, bool inertia>
    void run_blocks(const State&, const Pose&, std::vector<Vec6>&, std::vector<Vec6>&, std::vector<Yielding>&);

    const Structure& structure_;
    bool inertia_;
    std::vector<Block> blocks_;
    std::vector<std::array<Vec3, 2>> built_;  ///< frame z and y at the last build
    std::vector<int> turned_;
    double turn_limit_ = 1e300;
    long updates_ = 0;
};

/// Where one element is (for its tangent and for reading it).
beam::Placement<double> place_element(const Structure& structure, int element, const Pose& pose);
Vec6 element_deformation(const Structure& structure, int element, const Pose& pose);

}  // namespace hinge

// Assembly of the elements, eight at a time: deformation, forces, yield, and inertia, summed into the nodes.
#pragma once

#include <deque>
#include <vector>

#include "section/section_law.h"
#include "core/failure.h"
#include "core/thread_pool.h"
#include "state/configuration.h"

namespace hinge {

namespace beam {
template <class Real>
struct PairKind;
}

/// Plastic flow of one element between the state and the pose.
struct PlasticIncrement {
    int element;
    beam::ReturnMapResult flow;
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.element, s.flow);
    }
};

class ElementAssembly {
public:
    /// `inertia`: add consistent-mass inertia and gyroscopic forces of the pose's acceleration and velocity.
    ElementAssembly(const Structure& structure, ThreadPool& pool, bool inertia);
    ~ElementAssembly();

    /// Reads which elements are whole and where their integration points are. Call when a point has moved.
    void update_active(const State& state);
    void deactivate(int element);  ///< it broke, or rests
    void activate(int element);    ///< it no longer rests

    /// Adds internal (and inertia) forces at `pose` to `nodal` (N, N m; resisting), writes p of each element to
    /// `force`, and lists the elements whose plastic deformation grows. Reads plastic deformation from `state`, changes
    /// nothing in it.
    void run(const State& state, const Configuration& pose, std::vector<Vec6>& nodal, std::vector<Vec6>& force,
             std::vector<PlasticIncrement>& yielding);

    /// Fixed-end forces of each element from loads between its nodes, at the pose of the next call of run; empty if
    /// there are none.
    std::vector<beam::FixedEnd>& fixed_ends() { return fixed_ends_; }
    const beam::FixedEnd& fixed_end(int element) const {
        return fixed_ends_.empty() ? beam::no_fixed_end : fixed_ends_[element];
    }
    /// What the sections of an element have besides their forces in this step from `state`.
    beam::SectionConditions conditions(const State& state, int element) const {
        return {fixed_end(element), history_of(structure_, state, element), dt_};
    }
    /// Length of the step that run is asked for next, s; 0, the default: no time passes.
    void set_step(double dt) { dt_ = dt; }
    double step() const { return dt_; }

    /// Elements whose frame has rotated by more than `tolerance` (rad) since they were last marked, or, where bending
    /// follows the axial force, that have bent by more. Filled by run.
    const std::vector<int>& rotated() const { return rotated_; }
    void watch_rotation(double tolerance);
    /// Saves the winding of elements and the turns of their ends by hinges in the state, whose nodes are at the pose of
    /// the last run, and in the trial pose of the next step. Returns the elements whose ends have new axes.
    std::vector<int> save_turns(State& state, Configuration& trial) const;
    /// An element of which an end points backwards along its chord, where a bending angle has no direction; -1 when
    /// there is none. Filled by run; large displacement.
    int folded() const { return folded_; }
    /// An element whose return to its yield surface has not converged; -1 when there is none. Filled by run.
    int unreturned() const { return unreturned_; }
    /// Reason why a step cannot continue, if it cannot: an element has folded, or the return of one to its yield
    /// surface has not converged. Filled by run. `nothing_breaks`: in a run in which elements could break, no rule lets
    /// them.
    Failure failure(bool nothing_breaks = false) const;
    /// Records the frame of the element at `pose` as the one of its stiffness.
    void mark_built(int element, const State& state, const Configuration& pose);

    /// Tolerance of the plastic flow of pairs (pair_return.h), as a part of the elastic deformation. Newton's method
    /// needs forces without steps, 1e-9, the default. Where a step is solved once 1e-4 is enough: the forces follow
    /// from the elastic part, whatever the tolerance.
    void set_return_tolerance(double tolerance) { return_tolerance_ = tolerance; }

    /// Whether run leaves out other returns near one that has not converged, which may take long as well: its results
    /// are then of no use. Statics.
    void stop_at_unreturned() { stops_at_unreturned_ = true; }

    int sections(double* r) const;  ///< positions that can yield: both ends, or the middle (conventional)
    long updates() const { return updates_; }

    /// Fields of a checkpoint, read after update_active: active elements, and the frames of the last builds.
    template <class A>
    static void fields(const ElementAssembly& s, A& a) {
        a(s.active_bits(), s.frames(), s.updates_);
    }
    template <class A>
    static void fields(ElementAssembly& s, A& a) {
        std::vector<std::uint8_t> whole;
        std::vector<double> built;
        a(whole, built, s.updates_);
        a.must(s.restore_active(whole, built));
    }

private:
    struct Block;
    struct Kind;
    const Kind& add_kind(const State& state, const int* index);
    struct Found;  ///< results of one piece of the assembly
    unsigned find_wound(const Block& b, int element, const Lanes& rotated, const State&, const Configuration&,
                        Found& found) const;
    static void add_pair_forces(const beam::PairKind<Lanes>& kind, unsigned whole, const Lanes (&d)[6], Lanes (&p)[6]);
    void add_fixed_ends(int element, const Kind& kind, const Lanes (&p)[6], Lanes (&f)[2]) const;
    bool no_section_flows(int element, int i, const State&, const ElementHeats&, const Lanes (&p)[6]) const;
    void return_pair(int element, int i, const Kind& kind, const State&, const ElementHeats&, const Lanes (&d)[6],
                     Lanes (&p)[6], Found& found) const;
    static void take_off_heat(int element, const ElementHeats&, Lanes (&d)[6]);
    static void soften(int element, const ElementHeats&, Lanes (&p)[6]);
    void add_springs(const Block& b, int element, const State&, const Lanes (&d)[6], Lanes (&p)[6]) const;
    static void weaken(int element, const ElementHeats&, Lanes (&f)[2]);
    // the stages for eight elements, in this order (assembly_stages.cpp)
    enum class Mass : char { none, linear, cubic };
    using EightFrames = beam::ElementFrame<Lanes>;
    using Stages = void (ElementAssembly::*)(int first, int end, const State&, const Configuration&,
                                             std::vector<Vec6>& nodal, std::vector<Vec6>& force, Found&);
    template <bool large, bool p_delta>
    Stages choose_stages() const;
    template <bool large, Mass mass, bool p_delta>
    void run_blocks(int first, int end, const State&, const Configuration&, std::vector<Vec6>& nodal,
                    std::vector<Vec6>& force, Found& found);
    template <bool large>
    unsigned deform(const Block& b, int element, const State&, const Configuration&, EightFrames& place, Lanes (&d)[6],
                    Found& found) const;
    static void elastic_forces(const Kind& kind, int element, const State&, Lanes (&d)[6], Lanes (&p)[6]);
    template <bool p_delta>
    void yield(const Block& b, int element, const State&, const ElementHeats&, const Lanes (&d)[6], Lanes (&p)[6],
               Found& found) const;
    template <bool p_delta>
    void return_lanes(const Block& b, int element, unsigned asked, const State&, const ElementHeats&,
                      const Lanes (&f)[2], const Lanes (&d)[6], Lanes (&p)[6], Found& found) const;
    template <bool large, bool cubic, bool p_delta>
    static void add_inertia(const Block& b, const Configuration& pose, const EightFrames& place, unsigned wound,
                            beam::NodalForces<Lanes>& out);
    void scatter(const Block& b, int element, const beam::NodalForces<Lanes>& out, const Lanes (&p)[6],
                 std::vector<Vec6>& nodal, std::vector<Vec6>& force);
    template <bool p_delta>
    void find_rotated(const Block& b, int block, const EightFrames& place, const Lanes (&d)[6], Found& found) const;

    void share_out();
    std::vector<std::uint8_t> active_bits() const;  ///< a byte a block, a bit for each of its elements
    std::vector<double> frames() const;
    bool restore_active(const std::vector<std::uint8_t>& whole, const std::vector<double>& built);

    const Structure& structure_;
    ThreadPool& pool_;
    bool inertia_;
    std::vector<Block> blocks_;
    std::deque<Kind> kinds_;
    std::vector<beam::FixedEnd> fixed_ends_;
    std::vector<Found> found_;
    // several threads: forces of elements of several pieces on one node are stored apart and added up afterwards
    struct Shared {
        int node, first, end;
    };
    std::vector<Shared> shared_;     ///< range in shared_forces_ of each such node, in the order of its elements
    std::vector<int> shared_index_;  ///< of each element's two ends: in shared_forces_; -1: node of one piece
    std::vector<Vec6> shared_forces_;
    std::size_t built_stride() const { return structure_.p_delta() ? 8 : 6; }
    std::vector<Lanes> built_;  ///< of each block: frame z and y at the last build, and bending of its elements then
    std::vector<int> rotated_;
    std::vector<int> far_;
    int folded_ = -1, unreturned_ = -1;
    bool stops_at_unreturned_ = false;
    double return_tolerance_ = 1e-9, dt_ = 0;
    double rotation_limit_ = 1e300;
    bool watching_ = false;
    long updates_ = 0;
};

}  // namespace hinge

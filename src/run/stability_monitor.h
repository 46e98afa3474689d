// Stability of the equilibria that a static run finds: where the structure becomes unstable, whether a step has snapped
// to another branch of equilibria, and whether displacement control has left its path.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>

#include "run/newton.h"
#include "run/notice.h"

namespace hinge {

/// Where a run came past a limit point or a branching point: its tangent has more negative eigenvalues than where the
/// run began, and the equilibria beyond cannot be held at constant load.
struct Instability {
    double factor = 0, beyond = 0;  ///< load factors of the last equilibrium before it and of the first one after
    int count = 0;                  ///< ways of moving that are not resisted; the most so far
    int node = -1, component = 0;   ///< the largest motion of the first of these (0..5: ux uy uz rx ry rz)
    bool by_compression = true;     ///< or, where moments drive it, as a beam that turns over sideways, by bending
    std::vector<int> members;       ///< that this drives on in it, the first one most; at most three
};

/// "the structure becomes unstable at load factor 0.4: ..."
std::string text_of(const Instability& instability, const Structure& structure);

/// What a try to find the next equilibrium has come to.
enum class Found { nothing, stable, unstable };

class StabilityMonitor {
public:
    StabilityMonitor(const StaticProblem& problem, StaticTangent& tangent, Newton& newton);
    /// Counts the negative eigenvalues of the tangent where the run begins. `unsymmetric`: it will be.
    void begin(bool unsymmetric);

    /// Another equilibrium is tried.
    void begin_try() { may_have_snapped_ = false; }
    /// Whether the equilibrium that Newton's method has found can be held as far as that could be where the run began,
    /// and, under load control, whether it lies on the path: `nothing` where the step has snapped to another branch.
    Found judge(PathControl& control, double increment, double hinge_stiffness);

    /// Whether the trial can be held as far as the equilibrium where the run began.
    bool can_be_held();

    /// True if displacement control leaves the equilibrium more negative eigenvalues than any before: it is that of
    /// another branch, or lies beyond a branching point of the path.
    bool has_left_path(const PathControl& control) const {
        return control.can_stabilise() && free_modes_ > most_free_modes_;
    }
    /// True if condition and equilibrium leave no more negative eigenvalues than any before.
    bool is_on_path() const { return free_modes_ <= most_free_modes_; }
    /// Takes an equilibrium beyond a branching point as that of the path.
    void accept_branching(const PathControl& control);

    /// Under load control: true if the trial lies as far from the state as its own tangent says of such a load, so that
    /// no leap has brought it there.
    bool follows_tangent(double increment) const;
    /// Of large displacements without yielding: true if the trial lies so far from where its own tangent leads that it
    /// may be on another branch.
    bool may_have_leapt(double increment) const;

    /// Number of negative eigenvalues at the trial; and whether no equilibrium before had so many.
    int modes() const { return modes_; }
    bool has_more_modes() const { return modes_ > most_modes_; }
    /// Tries to find an equilibrium so far beyond the state.
    using Try = std::function<Found(double increment)>;
    /// Finds the load factor at which the structure becomes unstable, within a step that has ended beyond it. Returns
    /// the largest increment whose equilibrium is stable; the trial is then the whole step again.
    double locate_instability(const PathControl& control, double increment, const Try& try_step);
    /// Under load control: true if the two equilibria between which locate_instability has found it are far from each
    /// other. The second one is then on another branch, and the structure itself need not be unstable there.
    bool has_left_branch() const { return left_branch_; }
    void forget_instability() { instability_.reset(); }
    /// True if the eigenvalues that it has found did not pass zero. Under applied moments two complex ones may become
    /// real below zero; the equilibrium has not given way.
    bool are_driven() const { return found_driven_ > 0; }
    /// From now on they do not count.
    void accept_driven() { driven_ += found_driven_, found_driven_ = 0; }
    /// The trial has become the state.
    void commit() { driven_ = std::min(driven_, counted_); }
    /// Takes so many negative eigenvalues as those of the path.
    void accept_modes(int modes) { most_modes_ = modes; }
    void count_ways(int modes) { instability_->count = modes - modes_at_start_; }

    /// Under load control: whether the step that was tried may have snapped; once in a run.
    std::optional<Notice> find_snap(double increment);

    const std::optional<Instability>& instability() const { return instability_; }
    const std::optional<double>& branching() const { return branching_; }  ///< load factor
    /// Ways of moving that nothing resists at the trial, beside those where the run began.
    int new_modes() const { return modes_ - modes_at_start_; }

private:
    int count_modes(double hinge_stiffness);
    int count_free_modes(const PathControl& control);
    bool is_leap(const std::vector<Vec6>& moved, double increment, double part) const;
    bool unloading_returns(PathControl& control, double increment);
    void describe(const std::vector<Vec6>& mode, Instability& found) const;
    void find_driving_members(const std::vector<Vec6>& mode, Instability& found) const;

    const StaticProblem& problem_;
    Workspace& w_;
    StaticTangent& tangent_;
    Newton& newton_;
    int modes_at_start_ = 0, modes_ = 0, most_modes_ = 0;  ///< negative eigenvalues of the tangent: first, last, most
    int free_modes_ = 0, most_free_modes_ = 0;  ///< of the last and the most, those that displacement control leaves
    int counted_ = 0, driven_ = 0, found_driven_ = 0;  ///< all at the trial; those of them that did not pass zero
    double first_eigenvalue_ = 0;    ///< the one next to zero where the run begins; 0: the tangent stays symmetric
    bool may_have_snapped_ = false;  ///< the trial may lie on another branch of equilibria
    bool snap_told_ = false;
    bool left_branch_ = false;  ///< has_left_branch
    std::optional<double> branching_;
    std::optional<Instability> instability_;
};

}  // namespace hinge

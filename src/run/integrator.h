// How a step gets from forces to motion: Newmark's method (newmark.h), the energy-momentum method
// (energy_momentum.h) or central differences (central_differences.h).
#pragma once

#include "algebra/effective_stiffness.h"
#include "algebra/mass_matrix.h"
#include "core/built.h"
#include "effects/effect_list.h"
#include "run/constraints.h"
#include "run/settings.h"
#include "run/stages.h"

namespace hinge {

/// M by itself, updated as elements rotate and break, for accelerations and impulses.
class KeptMass {
public:
    explicit KeptMass(const Workspace& w) : w_(w), is_stale_(w.state.broken.size(), 0) {}
    void changed(int element) {
        if (!is_stale_[element]) is_stale_[element] = 1, stale_.push_back(element);
    }
    /// Takes up what has changed, as it is at `pose`.
    Mass& renewed(const Configuration& pose) {
        is_stale_.assign(w_.state.broken.size(), 0);
        if (mass_) mass_->renew(stale_, w_.state, pose);
        else {
            mass_ = std::make_unique<Mass>(w_.structure, w_.state);
            if (w_.constraints) mass_->set_reduction(&w_.constraints->reduction());
        }
        stale_.clear();
        return *mass_;
    }
    Mass* now() const { return mass_.get(); }
    void drop() { mass_.reset(); }

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.stale_);
        if constexpr (A::reading) {
            for (int e : s.stale_) a.must(e >= 0 && std::size_t(e) < s.is_stale_.size());
            s.is_stale_.assign(s.is_stale_.size(), 0);
            for (int e : s.stale_) s.is_stale_[e] = 1;
        }
        if (s.mass_) a(*s.mass_);
    }

private:
    const Workspace& w_;
    std::unique_ptr<Mass> mass_;
    std::vector<int> stale_;
    std::vector<char> is_stale_;
};

/// Return tolerance of the assembly where a step is solved once (ElementAssembly::set_return_tolerance).
inline constexpr double one_solution = 1e-4;

class Integrator {
public:
    Integrator(Workspace& w, KeptMass& mass, Stages& stages) : w_(w), mass_(mass), stages_(stages) {}
    virtual ~Integrator() = default;

    /// Before the first acceleration is found.
    virtual void prepare(const EffectList& effects) { (void)effects; }
    /// The first acceleration is known.
    virtual void begin(const EffectList& effects) { (void)effects; }
    /// F and R where a step begins are in the workspace, with what effects resist; R lacks what `recovered` took out.
    virtual void start_from_forces() {}
    /// The trial pose from which the step is solved.
    virtual void predict(const Step& step) = 0;
    /// What is prescribed has been set in the trial pose, as it is at the end of the step.
    virtual void prescribed(const Step& step) { (void)step; }
    /// Stresses are recovered at the trial pose (before effects add theirs).
    virtual void recovered(const Step& step) { (void)step; }
    /// From forces to a change of the accelerations: eq 15.
    virtual void solve(Step& step) = 0;
    /// Adds what the change does over the step. True: once more (Newton).
    virtual bool correct(Step& step) = 0;
    virtual const std::vector<Vec6>& change() const = 0;
    /// Whether effects may ask for one more iteration.
    virtual bool may_go_on(const Step& step) const { return (void)step, false; }
    virtual void solved(const Step& step) { (void)step; }
    /// Whether stresses must be recovered once more where the solution has led; they have been.
    virtual bool recovers_last() const { return false; }
    virtual void recovered_last() {}
    /// The stage that correct belongs to.
    virtual int correct_stage() = 0;
    /// What a dissipative method took out of the step, J.
    virtual double dissipated(const Step& step) const { return (void)step, 0; }
    virtual void before_commit() {}
    virtual void after_commit() {}

    virtual void stiffness_changed(int element) { (void)element; }
    virtual void dt_changed(double dt) { (void)dt; }
    virtual void removed(int element) { (void)element; }
    virtual EffectiveStiffness* effective() { return nullptr; }
    /// By how much the energy balance at the end of the step may be off for a moment, J, and come back.
    virtual double swing() const { return 0; }
    /// dt |da| / |v| of the last step, weighted by mass.
    virtual double jump() const { return 0; }

    virtual void save(Writer& to) const = 0;
    virtual void restore(Reader& from) = 0;

    Fastest fastest;

protected:
    /// The supports' reactions: what they must add to hold their degrees of freedom.
    template <class Force>
    void take_reactions(Force force) {
        for (int n : w_.supported) {
            Vec6& r = w_.reaction[n];
            r.setZero();
            for (int c = 0; c < 6; ++c)
                if (w_.state.held[n] >> c & 1) r[c] = force(n, c);
        }
    }
    /// What is out of balance becomes what is solved for: reactions are taken out of it. False, and the step says which
    /// node, where it is no number; `sum`: of its squares.
    bool balance_supports(double sum, std::vector<Vec6>& right, Step& step) {
        if (!std::isfinite(sum)) return step.failure = find_culprit(), false;
        take_reactions([&](int n, int c) {
            const double r = -right[n][c];
            right[n][c] = 0;
            return r;
        });
        return true;
    }
    void begin_fastest(std::size_t pieces) { fastest_of_.assign(pieces, {}); }
    /// Takes up what each piece of the nodes found: squared speeds.
    void note_fastest(double time) {
        for (const Fastest& f : fastest_of_)
            if (f.speed > fastest.speed * fastest.speed) fastest = {std::sqrt(f.speed), f.node, time};
    }
    Failure find_culprit() const;
    Failure failure_of(const SolverSettings& solver, const SolveReport& report);
    Failure weakest_part();
    void move_to_rotated(int first, int end);

    Workspace& w_;
    KeptMass& mass_;
    Stages& stages_;
    std::vector<Fastest> fastest_of_;  ///< of each piece of the nodes, speeds squared
};

}  // namespace hinge

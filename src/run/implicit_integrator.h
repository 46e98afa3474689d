// What Newmark's method and the energy-momentum method share: the effective stiffness, the list of its elements that
// are to be built anew, and the scaling of Newton's corrections.
#pragma once

#include "run/damped_tangents.h"
#include "run/integrator.h"
#include "run/yield_tangents.h"

namespace hinge {

class ImplicitIntegrator : public Integrator {
public:
    void stiffness_changed(int element) override;
    void dt_changed(double dt) override;
    void removed(int element) override;
    EffectiveStiffness* effective() override { return effective_.get(); }
    const std::vector<Vec6>& change() const override { return change_; }

protected:
    /// `scheme`: of the effective stiffness (1 - alpha) M + gamma dt C + beta dt^2 K.
    ImplicitIntegrator(Workspace& w, KeptMass& mass, Stages& stages, const Scheme& scheme);

    /// Makes the effective stiffness for such steps; all whole elements are to be built.
    void make_effective_stiffness(const EffectList& effects, double dt, bool geometric, MatrixStorage storage);
    /// Sorts the elements that are to be built, without the broken ones.
    void sort_rebuild();
    /// Builds them with these tangents in the place of the elastic ones; effects that watch matrices read theirs. They
    /// stay listed.
    void build(const Configuration& at, const std::vector<ElementTangent>& given);
    void clear_rebuild();
    bool is_to_be_built(int element) const { return in_rebuild_[element] != 0; }

    /// Scales Newton's corrections down while they swing between two sets of hinges. `size`: the energy of a
    /// correction, or its square.
    void damp_corrections(int iteration, double size);

    bool are_elements(const std::vector<int>& list) const;
    void rebuild_was_read();  ///< from a checkpoint

    /// A correction with more than this part of the size of the one before is hardly smaller.
    static constexpr double swings = 0.25;

    const Scheme scheme_;
    std::unique_ptr<EffectiveStiffness> effective_;
    const DampedTangents damped_;  ///< of elements that flow
    std::vector<Vec6> right_;      ///< the right side of eq 15
    std::vector<Vec6> change_;     ///< of the acceleration
    std::vector<int> rebuild_;     ///< elements whose effective stiffness is to be built anew
    double damping_ = 1;           ///< factor of Newton's corrections
    double last_size_ = 0;         ///< of the last correction

    const EffectList* effects_ = nullptr;

private:
    std::vector<char> in_rebuild_;
};

}  // namespace hinge

// Services of a run for its effects: changes of velocity, waking of bodies, constraints.
#pragma once

#include <string>
#include <vector>

#include "beam/pair_bow.h"
#include "core/types.h"
#include "state/bodies.h"
#include "state/configuration.h"

namespace hinge {

/// change = M^-1 impulse, and the kinetic energy that x times it takes: square x^2 + linear x. Supports that move add x
/// by_supports to it.
struct ImpulseResponse {
    double square = 0, linear = 0, by_supports = 0;
    std::vector<Vec6> change;  ///< of the velocities
    /// By what the impulse is to be multiplied so that it takes `work`, J, from the motion: the root nearest to 1,
    /// where one lies between 0.5 and 1.5, else 1. In 125 runs of tests/hard 116 keep their bounds so, or if the root
    /// is always taken; 113 between 0.9 and 1.1 alone, 114 if it is never taken.
    double factor_for(double work) const;
};

/// An element that something reached in this step, or that broke: a body at rest that it belongs to takes part again.
struct Reached {
    int element;
    const char* how;
    int node = -1;  ///< in the place of an element, which is -1 then
};

class Host {
public:
    virtual ~Host() = default;
    /// The element's stiffness is not what the effective stiffness has of it.
    virtual void stiffness_changed(int element) = 0;
    /// The stiffness of forces has changed: Force::add_blocks is called for all effects, at that configuration.
    virtual void blocks_changed(const Pose& at) = 0;
    /// Mass that hangs rigidly on a node, 6 x 6 in space, in the effective stiffness.
    virtual void set_offset_mass(int node, const Mat6& mass) = 0;
    /// A force has vanished at once: the next step begins with a recomputed acceleration.
    virtual void accelerations_anew() = 0;
    /// Constraints have ended: the others are recomputed at the end of the step. Statics keeps its own.
    virtual void constraints_changed() = 0;
    /// Elements' part in M has changed.
    virtual void mass_changed(int element) = 0;
    /// Changes of velocity by an impulse, at the trial end of the step.
    virtual ImpulseResponse respond(const std::vector<Vec6>& impulse) = 0;
    /// F of a node changes for good: a weight is gone.
    virtual void change_steady_load(int node, const Vec3& force) = 0;
    /// Bodies at rest that these elements belong to take part again.
    virtual void reached(const std::vector<Reached>& elements) = 0;
    virtual void note_activation(const std::string& effect, bool awake, const std::string& why) = 0;
    /// Effect::keep_from_rest of all.
    virtual void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) = 0;
    /// Effect::hold_up of all.
    virtual void hold_up(const Bodies& bodies, std::vector<char>& held_up) = 0;
    /// Effect::lie_together of all.
    virtual void lie_together(const Bodies& bodies, BodyPairs& pairs) = 0;
    /// Workspace::resting is another one: the nodes of it that are not negative take no part in the solution, and all
    /// effects are told.
    virtual void rest_changed() = 0;
    /// Loads at points between the ends of a pair of elements (SectionForceSource::add_points of all).
    virtual std::vector<beam::BowPoint> points_on_pair(int first, int plane, const Pose& at, double factor) = 0;
    virtual void count_break() = 0;
    virtual bool has_effective_stiffness() const = 0;
};

}  // namespace hinge

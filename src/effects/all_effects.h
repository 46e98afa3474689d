// All effects that the engine knows, in the order in which they act in a step: a new one is a line in list.inc.
#pragma once

#include <string>
#include <initializer_list>
#include <vector>

#include "algebra/stable_step.h"
#include "effects/effect_kind.h"

namespace hinge {

const std::vector<EffectKind>& all_effects();

/// Damping of each element by all effects; empty without damping.
std::vector<ElementDamping> damping_of(const Structure& structure);
/// Damping in proportion to the stiffness of what joins these nodes (-1: the ground), s: the mean of what the elements
/// at them have for it. `damping`: of each element.
double joint_damping(const Structure& structure, const std::vector<ElementDamping>& damping,
                     std::initializer_list<int> nodes);

/// Whether elements may break in such a run: of a member, of any.
bool may_break(const Model& model, const RunKind& run, int member);
bool may_break(const Model& model, const RunKind& run);

/// The plan: effects that are simulated or left out, each with its reason.
std::vector<PlanLine> plan_of(const Structure& structure, const RunKind& kind);

/// Names of the effects that a run can do without, and what takes one out of the run's own copy of a model. Other names
/// change nothing.
std::vector<std::string> optional_effects();
void leave_out(const std::string& effect, Model& model);
/// Makes what the effects of a model declare linear (EffectKind::linear).
void make_linear(Model& model);

/// Counts the time of a stage, s, for the effect that names it (EffectKind::stages), where that is active.
void add_stage_time(const std::string& stage, double seconds, std::vector<PlanLine>& plan);

}  // namespace hinge

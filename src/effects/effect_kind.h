// A kind of effect before a run: its name, accounts, lines of the plan, and the function that makes it.
#pragma once

#include <memory>

#include "algebra/node_blocks.h"
#include "effects/declared.h"
#include "effects/reports.h"
#include "effects/workspace.h"
#include "state/energy.h"

namespace hinge {

class Effect;
class Host;
class Model;
class Structure;

struct EffectKind {
    const char* name;
    std::vector<AccountInfo> accounts = {};
    /// Its lines of the plan.
    std::vector<PlanLine> (*plan)(const Structure& structure, const RunKind& kind) = nullptr;
    /// The effect, or null where the scene does not call for it.
    std::unique_ptr<Effect> (*make)(Workspace& w, Host& host) = nullptr;
    /// It acts in dynamics only: statics does not make it, and its lines of the plan say so.
    bool dynamic_only = false;
    bool acts_in(const RunKind& run) const { return run.takes(dynamic_only); }
    /// Takes it out of a model, so that a run can do without it (leave_out in all_effects.h); null where none can.
    void (*leave_out)(Model& model) = nullptr;
    /// Makes what a model declares of it linear, without yielding, cracks and tearing; null where it is.
    void (*linear)(Model& model) = nullptr;
    /// Damping in proportion to each element's own matrices; empty for none. It goes into the elements' effective
    /// stiffness and shortens explicit steps. The forces are the effect's (Force::add_forces).
    std::vector<ElementDamping> (*damping)(const Structure& structure) = nullptr;
    /// Lists its declarations in a model.
    Declarer declarer = {};
    /// Whether what a model declares of it may break elements of a member.
    bool (*may_break)(const Model& model, int member) = nullptr;
    /// Largest part of the elements' stable step that it allows a default step of explicit steps; 1: any.
    double (*part_of_stable_step)(const Model& model) = nullptr;
    /// Stages of a step whose time counts for its first line of the plan.
    std::vector<const char*> stages = {};
};

}  // namespace hinge

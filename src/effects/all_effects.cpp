#include "effects/all_effects.h"

#include <algorithm>

#include "effects/kinds.h"

namespace hinge {

const std::vector<EffectKind>& all_effects() {
    static const std::vector<EffectKind> list = {
#define HINGE_EFFECT(name) name##_kind(),
#include "effects/list.inc"
#undef HINGE_EFFECT
    };
    return list;
}

std::vector<ElementDamping> damping_of(const Structure& structure) {
    std::vector<ElementDamping> sum;
    for (const EffectKind& kind : all_effects()) {
        if (!kind.damping) continue;
        const std::vector<ElementDamping> more = kind.damping(structure);
        sum.resize(std::max(sum.size(), more.size()));
        for (std::size_t e = 0; e < more.size(); ++e)
            sum[e].of_mass += more[e].of_mass, sum[e].of_stiffness += more[e].of_stiffness,
                sum[e].of_joints += more[e].of_joints;
    }
    return sum;
}

double joint_damping(const Structure& structure, const std::vector<ElementDamping>& damping,
                     std::initializer_list<int> nodes) {
    double sum = 0;
    int elements = 0;
    for (const int node : nodes)
        if (node >= 0 && !damping.empty())
            for (const int e : structure.elements_at(node)) sum += damping[e].of_joints, ++elements;
    return elements ? sum / elements : 0;
}

bool may_break(const Model& model, const RunKind& run, int member) {
    const auto& all = all_effects();
    return std::any_of(all.begin(), all.end(), [&](const EffectKind& kind) {
        return kind.may_break && kind.acts_in(run) && kind.may_break(model, member);
    });
}

bool may_break(const Model& model, const RunKind& run) {
    for (int m = 0; m < int(model.members().size()); ++m)
        if (may_break(model, run, m)) return true;
    return false;
}

std::vector<PlanLine> plan_of(const Structure& structure, const RunKind& kind) {
    std::vector<PlanLine> lines;
    for (const EffectKind& effect : all_effects()) {
        if (!effect.plan) continue;
        for (PlanLine& line : effect.plan(structure, kind)) {
            if (line.active && !effect.acts_in(kind))
                line.active = false, line.because = only_in_dynamics(line.because);
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

std::vector<std::string> optional_effects() {
    std::vector<std::string> names;
    for (const EffectKind& kind : all_effects())
        if (kind.leave_out) names.push_back(kind.name);
    return names;
}

void leave_out(const std::string& effect, Model& model) {
    for (const EffectKind& kind : all_effects())
        if (kind.leave_out && effect == kind.name) kind.leave_out(model);
}

void make_linear(Model& model) {
    for (const EffectKind& kind : all_effects())
        if (kind.linear) kind.linear(model);
}

void add_stage_time(const std::string& stage, double seconds, std::vector<PlanLine>& plan) {
    for (const EffectKind& kind : all_effects())
        if (std::find(kind.stages.begin(), kind.stages.end(), stage) != kind.stages.end())
            for (PlanLine& line : plan)
                if (line.active && line.name == kind.name) line.seconds += seconds;
}

}  // namespace hinge

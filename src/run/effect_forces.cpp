#include "run/effect_forces.h"

#include <algorithm>

namespace hinge {

Blocks added_blocks(const EffectList& effects, const Pose& at, double of_damping) {
    Blocks blocks(of_damping);
    add_blocks(effects, at, blocks);
    return blocks;
}

void add_blocks(const EffectList& effects, const Pose& at, Blocks& to) {
    for (const auto& force : effects.forces)
        if (force->has_blocks()) force->add_blocks(at, to);
}

void read_active(Workspace& w) {
    w.assembly.update_active(w.state);
    for (std::size_t e = 0; !w.resting.empty() && e < w.state.broken.size(); ++e)
        if (w.rests(w.structure.elements()[e].node[0])) w.assembly.deactivate(int(e));
    w.points_moved = false;
}

void find_fixed_ends(Workspace& w, const EffectList& effects, double factor) {
    std::vector<beam::FixedEnd>& all = w.assembly.fixed_ends();
    const bool asked = w.structure.can_yield() || any_of(effects.breakers, &Breaker::by_strain);
    if (!asked || !any_of(effects.section_forces, &SectionForceSource::has_fixed_ends)) return all.clear();
    all.resize(w.structure.elements().size());
    bool first = true;
    for (const auto& source : effects.section_forces) {
        if (!source->has_fixed_ends()) continue;
        if (first) source->set_fixed_ends(w.trial, factor, all);
        else source->add_fixed_ends(w.trial, factor, all);
        first = false;
    }
}

}  // namespace hinge

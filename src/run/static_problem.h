// What all parts of a static run share: the workspace, the effects, the settings, the supports, and the length and
// force scales of the structure.
#pragma once

#include "effects/effect_list.h"
#include "run/static_settings.h"

namespace hinge {

struct StaticProblem {
    StaticProblem(Workspace& workspace, const EffectList& all_effects, StaticSettings given);

    /// Sets the components of supported degrees of freedom to zero.
    Vec6 without_supported(std::size_t node, Vec6 v) const;

    Workspace& w;
    const EffectList& effects;
    const StaticSettings settings;
    const std::vector<std::uint8_t> held;  ///< by supports of the model and of this run, six bits a node
    double mean_length = 1;                ///< m, of the elements: a moment over it is compared with a force
    double reach = 1e-3;                   ///< m, largest coordinate of a node
    double rounding = 0;                   ///< N, out-of-balance force that rounding of the positions alone can make
};

/// Scalar product of two sets of nodal displacements; translations only, because rotations have another unit.
double dot_translations(const std::vector<Vec6>& a, const std::vector<Vec6>& b);

}  // namespace hinge

// Settings of a static run: how the load path is controlled, into how many steps it is divided, and when a step is in
// equilibrium.
#pragma once

#include <cstdint>
#include <vector>

#include "core/types.h"

namespace hinge {

enum class Control : std::uint8_t { load, displacement, arc };

struct StaticSettings {
    int steps = 10;  ///< load and displacement control: equal steps to factor 1, to `target`; arc: at most so many
    Control control = Control::load;
    int node = -1, component = 0;  ///< displacement control: what is driven (0..5: ux uy uz rx ry rz)
    double target = 1;    ///< at the end: the displacement (Run::displacement), m or rad; of arc length the load factor
    int iterations = 30;  ///< Newton iterations before a step is halved
    double tolerance =
        1e-9;  ///< out-of-balance force relative to the forces at work (moments over a mean element length)
    std::vector<std::uint8_t> held;  ///< extra supports for this run only (six bits a node), or empty
    bool past_unstable = false;      ///< load control goes on where the structure has become unstable
    bool to_limit = false;           ///< load control: a run that ends at a limit load has completed
    /// Displacement control: the shape along which the first step sets off, six numbers a node; empty: none.
    std::vector<Vec6> branch;
};

/// ux uy uz rx ry rz
const char* component_name(int component);

}  // namespace hinge

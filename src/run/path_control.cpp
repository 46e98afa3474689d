#include "run/path_control.h"

#include "run/arc_length_control.h"
#include "run/displacement_control.h"
#include "run/load_control.h"

namespace hinge {

std::unique_ptr<PathControl> make_path_control(const StaticSettings& s, double way) {
    switch (s.control) {
        case Control::displacement: return std::make_unique<DisplacementControl>(s.steps, s.node, s.component, way);
        case Control::arc: return std::make_unique<ArcLengthControl>(s.steps, s.target, 1.0 / s.steps);
        default: return std::make_unique<LoadControl>(s.steps);
    }
}

}  // namespace hinge

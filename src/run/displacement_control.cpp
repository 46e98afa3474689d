#include "run/displacement_control.h"

namespace hinge {

/// correction + d response = the rest of the step's way, for what is driven.
std::optional<double> DisplacementControl::factor_change(const PathIteration& at) {
    const auto driven = [&](const std::vector<Vec6>& v) { return v[node_][component_]; };
    const double way = at.increment * way_, response = driven(at.response);
    if (response == 0) return {};
    if (first_response_ == 0) first_response_ = response;
    return (way - driven(at.total) - driven(at.correction)) / response;
}

}  // namespace hinge

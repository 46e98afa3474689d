#include "run/arc_length_control.h"

#include <algorithm>
#include <cmath>

#include "run/static_problem.h"

namespace hinge {

std::optional<double> ArcLengthControl::factor_change(const PathIteration& at) {
    const double a = dot_translations(at.response, at.response);
    if (at.number == 1) {
        const double size = std::sqrt(a);
        if (unit_ == 0) unit_ = size * first_step_;
        const bool back = !direction_.empty() && dot_translations(direction_, at.response) < 0;
        return (back ? -1 : 1) * (unit_ * at.increment) / size;
    }
    // |total + correction + d response| = arc: of the two roots, the one that goes on
    const double arc = unit_ * at.increment;
    std::vector<Vec6> step(at.total.size());
    for (std::size_t i = 0; i < step.size(); ++i) step[i] = at.total[i] + at.correction[i];
    const double b = dot_translations(step, at.response), c = dot_translations(step, step) - arc * arc;
    const double discriminant = b * b - a * c;
    if (discriminant < 0) return {};
    const double along_step = dot_translations(at.total, step), along_load = dot_translations(at.total, at.response);
    const double r1 = (-b + std::sqrt(discriminant)) / a, r2 = (-b - std::sqrt(discriminant)) / a;
    return along_step + r1 * along_load >= along_step + r2 * along_load ? r1 : r2;
}

double ArcLengthControl::part_done(double factor, long steps) const {
    return at_target_ ? 1 : std::max(double(steps) / steps_, factor / target_);
}

}  // namespace hinge

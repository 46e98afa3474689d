// Whether the parts of a snapshot agree with each other, checked before anything walks its indices.
#include "output/snapshot_check.h"

#include "core/errors.h"

namespace hinge::output {

void check_snapshot(const Snapshot& snapshot) {
    const auto points = snapshot.points.size();
    if (!snapshot.is_virtual.empty() && snapshot.is_virtual.size() != points)
        throw InputError("snapshot: is_virtual has " + std::to_string(snapshot.is_virtual.size()) + " values for " +
                         std::to_string(points) + " points; give one for each, or none");
    if (!snapshot.displacement.empty() && snapshot.displacement.size() != points)
        throw InputError("snapshot: displacement has " + std::to_string(snapshot.displacement.size()) + " values for " +
                         std::to_string(points) + " points; give one for each, or none");
    if (!snapshot.held.empty() && snapshot.held.size() != points)
        throw InputError("snapshot: held has " + std::to_string(snapshot.held.size()) + " values for " +
                         std::to_string(points) + " points; give one for each, or none");
    const int groups = static_cast<int>(snapshot.groups.size());
    for (std::size_t i = 0; i < snapshot.bars.size(); ++i) {
        const Bar& bar = snapshot.bars[i];
        for (const int p : bar.point)
            if (p < 0 || static_cast<std::size_t>(p) >= points)
                throw InputError("snapshot: bar " + std::to_string(i) + " ends at point " + std::to_string(p) +
                                 "; there are points 0 to " + std::to_string(points) + " exclusive");
        if (bar.group < -1 || bar.group >= groups)
            throw InputError("snapshot: bar " + std::to_string(i) + " is in group " + std::to_string(bar.group) +
                             "; there are " + std::to_string(groups) + " groups, and -1 for none");
        if (bar.state > BarState::broken)
            throw InputError("snapshot: bar " + std::to_string(i) + " has state " +
                             std::to_string(static_cast<int>(bar.state)) + "; allowed are 0, 1 and 2");
    }
}

}  // namespace hinge::output

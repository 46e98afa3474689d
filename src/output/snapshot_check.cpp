// Checks that the parts of a snapshot are consistent, before its indices are used.
#include "output/snapshot_check.h"

#include "core/errors.h"

namespace hinge::output {

void check_snapshot(const Snapshot& snapshot) {
    const auto points = snapshot.points.size();
    const auto each = [&](const char* name, std::size_t values) {
        if (values != 0 && values != points)
            throw InputError(std::string("snapshot: ") + name + " has " + std::to_string(values) + " values for " +
                             std::to_string(points) + " points; give one for each, or none");
    };
    each("is_virtual", snapshot.is_virtual.size());
    each("displacement", snapshot.displacement.size());
    each("rotation", snapshot.rotation.size());
    each("held", snapshot.held.size());
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
        if (bar.shape < -1 || bar.shape >= static_cast<int>(snapshot.shapes.size()))
            throw InputError("snapshot: bar " + std::to_string(i) + " has section " + std::to_string(bar.shape) +
                             "; there are " + std::to_string(snapshot.shapes.size()) + " sections, and -1 for none");
    }
    const auto is_point = [&](int p) { return p >= 0 && static_cast<std::size_t>(p) < points; };
    for (const Bar& bar : snapshot.bars)
        for (const int n : bar.node)
            if (n != -1 && !is_point(n))
                throw InputError("snapshot: element " + std::to_string(bar.element) + " was declared to end at point " +
                                 std::to_string(n) + "; there are " + std::to_string(points));
    for (const auto& pair : snapshot.connected)
        for (const int n : pair)
            if (!is_point(n))
                throw InputError("snapshot: a connector joins point " + std::to_string(n) + "; there are " +
                                 std::to_string(points));
    for (const Panel& panel : snapshot.floors)
        for (const int n : panel.points)
            if (!is_point(n))
                throw InputError("snapshot: a floor has a corner at point " + std::to_string(n) + "; there are " +
                                 std::to_string(points));
    for (std::size_t i = 0; i < snapshot.loads.size(); ++i) {
        const Load& load = snapshot.loads[i];
        const bool on_point = load.point >= 0 && static_cast<std::size_t>(load.point) < points && load.bar < 0,
                   on_bar =
                       load.bar >= 0 && static_cast<std::size_t>(load.bar) < snapshot.bars.size() && load.point < 0;
        if (!on_point && !on_bar)
            throw InputError("snapshot: load " + std::to_string(i) + " acts neither on a point nor on a bar");
    }
}

}  // namespace hinge::output

#include "output/frame_box.h"

#include <algorithm>

#include "output/bars.h"
#include "output/framing.h"
#include "output/snapshot_check.h"

namespace hinge::output {

std::optional<std::array<double, 6>> frame_box(const Snapshot& snapshot, const View& view) {
    check_snapshot(snapshot);
    const std::vector<Vec> shown = without_strays(ends_of(choose_bars(snapshot, view)));
    if (shown.empty()) return {};
    std::array<double, 6> box = {shown[0][0], shown[0][0], shown[0][1], shown[0][1], shown[0][2], shown[0][2]};
    for (const Vec& p : shown)
        for (std::size_t c = 0; c < 3; ++c) {
            box[2 * c] = std::min(box[2 * c], p[c]);
            box[2 * c + 1] = std::max(box[2 * c + 1], p[c]);
        }
    return box;
}

}  // namespace hinge::output

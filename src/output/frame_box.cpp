#include "output/frame_box.h"

#include <algorithm>

#include "output/bars.h"
#include "output/diagram.h"
#include "output/framing.h"
#include "output/snapshot_check.h"

namespace hinge::output {
namespace {

/// Of all ends, how many may lie beyond each side: what flies away alone must not make the rest small in all of a film.
constexpr double beyond = 0.005;

std::array<double, 2> range(std::vector<double> values) {
    const auto skipped = static_cast<std::ptrdiff_t>(beyond * static_cast<double>(values.size()));
    const auto low = values.begin() + skipped, high = values.end() - 1 - skipped;
    std::nth_element(values.begin(), low, values.end());
    const double least = *low;
    std::nth_element(values.begin(), high, values.end());
    return {least, *high};
}

}  // namespace

FrameBox frame_box(const Snapshot& snapshot, const View& view) {
    check_snapshot(snapshot);
    const DrawnBars bars = choose_bars(snapshot, view);
    FrameBox found{{}, bars.scale, 0};
    std::vector<Vec> shown = without_strays(ends_of(bars.list));
    if (shown.empty()) return found;
    if (view.show >= Show::N) {
        const Diagram diagram = plan_diagram(bars.list, view.show, size_of(shown));
        add_points(shown, bars.list, diagram);
        found.largest = std::max(diagram.largest, -diagram.smallest);
    }
    if (view.ghost) add_start(shown, snapshot, bars.list);
    std::erase_if(shown, [](Vec p) { return !finite(p); });
    std::array<double, 6>& box = found.box.emplace();
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<double> values;
        for (const Vec& p : shown) values.push_back(p[c]);
        const auto [low, high] = range(std::move(values));
        box[2 * c] = low, box[2 * c + 1] = high;
    }
    return found;
}

}  // namespace hinge::output

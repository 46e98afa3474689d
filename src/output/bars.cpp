// The bars a view shows: chosen and sorted into colours.
#include "output/bars.h"

#include <algorithm>
#include <cmath>

namespace hinge::output {

const std::array<Colour, n_classes> class_colours = {
    {{54, 96, 176}, {82, 176, 214}, {92, 184, 112}, {240, 212, 72}, {243, 146, 44}, {212, 24, 32}, {22, 22, 26}}};

namespace {

constexpr double hinge_from = 0.999;  // f_y reaches 1 only up to the tolerance of the return

int colour_class(const Bar& bar) {
    if (bar.state == BarState::broken) return broken_class;
    if (bar.state == BarState::yielded || bar.yield >= hinge_from) return hinge_class;
    // Written so that a value that is not a number gives the lowest band.
    return bar.yield > 0 ? std::min(static_cast<int>(bar.yield * 5), hinge_class - 1) : 0;
}

}  // namespace

std::vector<DrawnBar> choose_bars(const Snapshot& snapshot, const View& view) {
    std::vector<DrawnBar> chosen;
    for (const Bar& bar : snapshot.bars) {
        if (view.leave_out_broken && bar.state == BarState::broken) continue;
        const Vec& a = snapshot.points[static_cast<std::size_t>(bar.point[0])];
        const Vec& b = snapshot.points[static_cast<std::size_t>(bar.point[1])];
        if (!finite(a) || !finite(b) || std::min(a[2], b[2]) < view.above) continue;
        chosen.push_back({a, b, std::isfinite(bar.width) ? bar.width / 2 : 0, colour_class(bar)});
    }
    return chosen;
}

std::vector<Vec> ends_of(std::span<const DrawnBar> bars) {
    std::vector<Vec> ends;
    ends.reserve(2 * bars.size());
    for (const DrawnBar& bar : bars) {
        ends.push_back(bar.a);
        ends.push_back(bar.b);
    }
    return ends;
}

}  // namespace hinge::output

// Selects the bars of a view and computes their drawn positions and changes of colour.
#include "output/bars.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"

namespace hinge::output {
namespace {

constexpr double seen_share = 0.05;  // of the structure's size: the largest displacement with scale = "auto"
constexpr double sharpest = 0.5;     // cosine: where a member bends by more, its elements end square

double square(double x) { return x * x; }

/// A cubic with values and slopes at both ends.
double hermite(double a, double slope_a, double b, double slope_b, double t) {
    return a * (1 + 2 * t) * square(1 - t) + slope_a * t * square(1 - t) + b * square(t) * (3 - 2 * t) +
           slope_b * square(t) * (t - 1);
}

/// The largest displacement is drawn as a twentieth of the structure, by a factor that is easy to read: 1, 2 or 5 times
/// a power of ten.
double visible_scale(const Snapshot& snapshot) {
    double most = 0;
    Vec low{}, high{};
    bool any = false;
    for (std::size_t i = 0; i < snapshot.points.size(); ++i) {
        if (!snapshot.is_virtual.empty() && snapshot.is_virtual[i]) continue;
        const Vec x = snapshot.points[i] - snapshot.displacement[i];
        if (!finite(x) || !finite(snapshot.displacement[i])) continue;
        most = std::max(most, length(snapshot.displacement[i]));
        for (int c = 0; c < 3; ++c) {
            low[c] = any ? std::min(low[c], x[c]) : x[c];
            high[c] = any ? std::max(high[c], x[c]) : x[c];
        }
        any = true;
    }
    if (!(most > 0)) return 1;
    const double wanted = seen_share * length(high - low) / most;
    if (wanted <= 1) return 1;
    const double power = std::pow(10, std::floor(std::log10(wanted)));
    return power * (wanted / power >= 5 ? 5 : wanted / power >= 2 ? 2 : 1);
}

Shape shape_of(const Snapshot& snapshot, const Bar& bar) {
    if (bar.shape >= 0) return snapshot.shapes[static_cast<std::size_t>(bar.shape)];
    const double side = std::isfinite(bar.width) ? bar.width : 0;
    return {Shape::rectangle, side, side, 0, 0};
}

/// The section's y axis across the bar; any direction across it where it is not known.
Vec up_across(const Bar& bar, Vec along) {
    Vec up = bar.up;
    if (!finite(up) || length(up) == 0) up = std::abs(along[2]) < 0.9 ? Vec{0, 0, 1} : Vec{0, 1, 0};
    Vec across = up - dot(up, along) * along;
    if (length(across) < 1e-6) across = cross(along, std::abs(along[0]) < 0.9 ? Vec{1, 0, 0} : Vec{0, 1, 0});
    return unit(across);
}

/// For each member, true if it is in one of the groups of the view.
std::vector<char> asked_for(const Snapshot& snapshot, const View& view) {
    int most = 0;
    for (const Bar& bar : snapshot.bars) most = std::max(most, bar.member);
    std::vector<char> asked(static_cast<std::size_t>(most) + 1, !view.groups);
    if (!view.groups) return asked;
    const auto wanted = [&](int group) {
        return std::find(view.groups->begin(), view.groups->end(), group) != view.groups->end();
    };
    for (const auto& [member, group] : snapshot.memberships)
        if (member >= 0 && member <= most && wanted(group)) asked[static_cast<std::size_t>(member)] = 1;
    return asked;
}

/// True if both ends of a bar were in the planes of the view at the start, up to 1 mm.
bool starts_in(const Snapshot& snapshot, const Bar& bar, const View& view) {
    for (const int end : {0, 1}) {
        const auto p = static_cast<std::size_t>(bar.node[end] >= 0 ? bar.node[end] : bar.point[end]);
        const Vec start =
            snapshot.displacement.empty() ? snapshot.points[p] : snapshot.points[p] - snapshot.displacement[p];
        for (std::size_t c = 0; c < 3; ++c)
            if (view.plane[c] && !(std::abs(start[c] - *view.plane[c]) <= 1e-3)) return false;
    }
    return true;
}

/// How far the member continues an element: its ends are cut halfway between both directions, so that no gap opens.
/// Where other members meet, they reach into the corner.
void join(const Snapshot& snapshot, std::vector<DrawnBar>& bars) {
    struct Meets {
        int bar, end;
    };
    std::vector<std::vector<Meets>> at(snapshot.points.size());
    for (std::size_t i = 0; i < bars.size(); ++i)
        for (int end : {0, 1})
            at[static_cast<std::size_t>(bars[i].bar->point[end])].push_back({static_cast<int>(i), end});
    for (const auto& meeting : at) {
        if (meeting.size() < 2) continue;
        for (const Meets& m : meeting) {
            DrawnBar& one = bars[static_cast<std::size_t>(m.bar)];
            double widest = 0;
            bool continued = false;
            for (const Meets& o : meeting) {
                const DrawnBar& other = bars[static_cast<std::size_t>(o.bar)];
                if (o.bar == m.bar) continue;
                if (other.bar->member != one.bar->member) {
                    widest = std::max(widest, std::min(other.shape.width, other.shape.depth) / 2);
                    continue;
                }
                const Vec mine = one.direction(m.end), theirs = other.direction(o.end);
                const double sign = m.end == o.end ? -1 : 1;
                if (sign * dot(mine, theirs) < sharpest) continue;
                one.cut[m.end] = unit(mine + sign * theirs);
                continued = true;
            }
            if (!continued) one.reach[m.end] = std::min(widest, 0.5 * one.length());
        }
    }
}

}  // namespace

std::vector<char> groups_of_view(const Snapshot& snapshot, const View& view) {
    std::vector<char> groups(snapshot.groups.size(), 0);
    const std::vector<char> asked = asked_for(snapshot, view);
    for (const Bar& bar : snapshot.bars)
        if (bar.group >= 0 && asked[static_cast<std::size_t>(bar.member)] && starts_in(snapshot, bar, view))
            groups[static_cast<std::size_t>(bar.group)] = 1;
    return groups;
}

Vec DrawnBar::at(double t) const {
    if (!curved) return a + t * (b - a);
    Vec p;
    for (int c = 0; c < 3; ++c) p[c] = hermite(a[c], tangent[0][c], b[c], tangent[1][c], t);
    return p;
}

Vec DrawnBar::direction(double t) const {
    if (!curved) return unit(b - a);
    const Vec d = (1 - t) * (1 - 3 * t) * tangent[0] + t * (3 * t - 2) * tangent[1] + 6 * t * (1 - t) * (b - a);
    return output::length(d) > 0 ? unit(d) : unit(b - a);
}

Vec drawn_at(const Snapshot& snapshot, std::size_t point, double scale) {
    const Vec& p = snapshot.points[point];
    return scale == 1 ? p : p + (scale - 1) * snapshot.displacement[point];
}

DrawnBars choose_bars(const Snapshot& snapshot, const View& view) {
    const bool moved = !snapshot.displacement.empty();
    if ((view.scale != 1 || view.ghost) && !moved && !snapshot.points.empty())
        throw InputError(
            "scale and ghost need displacements, which this frame does not have: an earlier version of "
            "hinge wrote it; run the script again");
    if (view.show >= Show::N && !moved && !snapshot.points.empty())
        throw InputError(
            "a diagram needs forces, which this frame does not have: an earlier version of hinge wrote "
            "it; run the script again");
    DrawnBars chosen{{}, view.scale != 0 ? view.scale : moved ? visible_scale(snapshot) : 1};
    const double scale = chosen.scale;
    const std::vector<char> asked = asked_for(snapshot, view);
    std::vector<std::vector<const Load*>> loads(snapshot.bars.size());
    for (const auto* list : {&snapshot.loads, &snapshot.weights})
        for (const Load& load : *list)
            if (load.bar >= 0) loads[static_cast<std::size_t>(load.bar)].push_back(&load);
    for (const Bar& bar : snapshot.bars) {
        if (bar.member >= 0 && !asked[static_cast<std::size_t>(bar.member)]) continue;
        if (view.leave_out_broken && bar.state == BarState::broken) continue;
        if (!starts_in(snapshot, bar, view)) continue;
        const auto p = static_cast<std::size_t>(bar.point[0]), q = static_cast<std::size_t>(bar.point[1]);
        const Vec a = drawn_at(snapshot, p, scale), b = drawn_at(snapshot, q, scale);
        if (!finite(a) || !finite(b) || std::min(snapshot.points[p][2], snapshot.points[q][2]) < view.above) continue;
        const double length = output::length(b - a);
        if (length == 0) continue;
        const Vec along = unit(b - a), up = up_across(bar, along);
        DrawnBar d{
            &bar,
            shape_of(snapshot, bar),
            a,
            b,
            up,
            {},
            {},
            {0, 0},
            false,
            {bar, length, unit(cross(up, along)), up, loads[static_cast<std::size_t>(&bar - &snapshot.bars[0])]}};
        if (scale != 1 && !snapshot.rotation.empty() && bar.state != BarState::broken) {
            const Vec start =
                (snapshot.points[q] - snapshot.displacement[q]) - (snapshot.points[p] - snapshot.displacement[p]);
            // Where it has a hinge, the element's end does not follow the rotation of its node.
            const auto turned = [&](std::size_t node) { return start + scale * cross(snapshot.rotation[node], start); };
            const bool free_a = bar.hinges & 1, free_b = bar.hinges & 2;
            d.tangent[0] = turned(p), d.tangent[1] = turned(q);
            if (free_a) d.tangent[0] = free_b ? b - a : 1.5 * (b - a) - 0.5 * d.tangent[1];
            if (free_b) d.tangent[1] = free_a ? b - a : 1.5 * (b - a) - 0.5 * d.tangent[0];
            d.curved = !(free_a && free_b) && finite(d.tangent[0]) && finite(d.tangent[1]);
        }
        d.cut[0] = d.direction(0), d.cut[1] = d.direction(1);
        chosen.list.push_back(d);
    }
    join(snapshot, chosen.list);
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

void add_start(std::vector<Vec>& to, const Snapshot& snapshot, std::span<const DrawnBar> bars) {
    for (const DrawnBar& bar : bars)
        for (const int p : bar.bar->point) to.push_back(drawn_at(snapshot, static_cast<std::size_t>(p), 0));
}

}  // namespace hinge::output

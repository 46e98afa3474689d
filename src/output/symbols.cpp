// Symbols in a scene: plastic hinges, supports, loads and the ground.
#include "output/symbols.h"

#include <vtkActor.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "output/hinge_marks.h"
#include "output/mesh.h"

namespace hinge::output {
namespace {

constexpr double largest_rotation = 0.2;  // rad, of the largest dot
constexpr int round = 16;                 // sides of circles

void shade(vtkActor* actor) {
    actor->GetProperty()->SetAmbient(0.45);
    actor->GetProperty()->SetDiffuse(0.62);
}

Actors shaded(const Mesh& mesh) {
    if (mesh.empty()) return {};
    auto actor = mesh.surface();
    shade(actor);
    return {actor};
}

}  // namespace

double dot_radius(double rotation, double unit) {
    if (!(rotation > 0)) rotation = 0;  // nor a number
    return unit * std::clamp(std::sqrt(rotation / largest_rotation), 0.22, 1.0);
}

double sign_size(std::span<const DrawnBar> bars, const Camera& camera, double share, double least, double most) {
    std::vector<double> lengths;
    for (const DrawnBar& bar : bars) lengths.push_back(bar.length() / camera.metres_per_pixel);
    if (lengths.empty()) return most;
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return std::clamp(share * *middle, least, most);
}

Actors hinge_actors(std::span<const DrawnBar> bars, const Camera& camera, double unit) {
    Mesh dots(camera.target), rims(camera.target);
    for (const DrawnBar& bar : bars) {
        if (bar.bar->state == BarState::broken || !bar.bar->hinges) continue;
        const bool compared = bar.bar->hinges & hinges_compared;
        const auto dot_at = [&](double t, double rotation) {
            const int band = compared ? band_at(*bar.bar, t == 1 ? 2 : 1) : 0;
            if (compared && band == 0) return;
            if (compared) rotation *= largest_rotation / most_of_limit;  // of its limit
            const Colour& colour = compared ? band_colour(band) : class_colours[plastic_class];
            const double pixel = camera.pixel_at(bar.at(t)), radius = dot_radius(rotation, unit) * pixel;
            // Beside the node, so that each of the members that meet there shows its own; before the member itself.
            const double inward = std::min(radius / bar.length(), 0.5);
            const double section = std::hypot(bar.shape.width, bar.shape.depth) / 2;
            const Vec p = camera.nearer(bar.at(t == 0 ? inward : t == 1 ? 1 - inward : t), section + radius);
            const int sides = radius > 8 * pixel ? 20 : 10;
            add_ball(dots, p, radius, sides, colour);
            add_ball(rims, p, radius + 1.3 * pixel, sides, ink);
        };
        if (bar.bar->hinges & 1) dot_at(0, bar.bar->rotation[0]);
        if (bar.bar->hinges & 2) dot_at(1, bar.bar->rotation[1]);
        if (bar.bar->hinges & 4) dot_at(0.5, std::max(bar.bar->rotation[0], bar.bar->rotation[1]));
    }
    if (dots.empty()) return {};
    auto rim = rims.surface();
    rim->GetProperty()->LightingOff();
    rim->GetProperty()->FrontfaceCullingOn();
    Actors actors = shaded(dots);
    actors.push_back(rim);
    return actors;
}

namespace {

/// Which of the six a plane model holds at all its nodes: one displacement and the two rotations that go with it, and
/// rotations that no node has.
int held_everywhere(const Snapshot& snapshot, std::size_t nodes) {
    int all = 63;
    for (std::size_t i = 0; i < nodes; ++i) all &= snapshot.held[i];
    if (all == 63) return 0;
    int out_of_plane = 0;
    for (const int plane : {1 | 16 | 32, 2 | 8 | 32, 4 | 8 | 16})
        if ((all & plane) == plane) out_of_plane |= plane & 7;
    const bool one = out_of_plane == 1 || out_of_plane == 2 || out_of_plane == 4;
    return (all & 56) | (one ? out_of_plane : 0);
}

/// Where a node was at the start.
Vec start_of(const Snapshot& snapshot, std::size_t node) {
    return snapshot.displacement.empty() ? snapshot.points[node] : snapshot.points[node] - snapshot.displacement[node];
}

}  // namespace

std::vector<Support> find_supports(const Snapshot& snapshot, std::span<const DrawnBar> bars, const View& view,
                                   double scale) {
    std::vector<Support> supports;
    if (snapshot.held.empty()) return supports;
    std::vector<const DrawnBar*> at(snapshot.points.size(), nullptr);
    for (const DrawnBar& bar : bars)
        for (const int p : bar.bar->point) at[static_cast<std::size_t>(p)] = &bar;
    // A node whose members have all broken off keeps its support, and one whose members are left out has none.
    std::vector<char> bare(snapshot.points.size(), !view.groups);
    for (const Bar& bar : snapshot.bars)
        for (const int p : bar.point) bare[static_cast<std::size_t>(p)] = 0;
    const std::size_t nodes =
        std::min(snapshot.declared > 0 ? static_cast<std::size_t>(snapshot.declared) : snapshot.points.size(),
                 snapshot.held.size());
    const int everywhere = held_everywhere(snapshot, nodes), moves = 7 & ~everywhere, turns = 56 & ~everywhere;
    const Vec down = unit(-1.0 * view.up);
    for (std::size_t i = 0; i < nodes; ++i) {
        const int held = snapshot.held[i] & ~everywhere;
        if (held == 0 || (!at[i] && !(bare[i] && snapshot.points[i][2] >= view.above))) continue;
        Support s{Support::rotations, drawn_at(snapshot, i, scale), down, {}, 0};
        if (!finite(s.at)) continue;
        s.x = across(down);
        if (at[i]) s.section = std::max(at[i]->shape.width, at[i]->shape.depth);
        if ((held & moves) == moves && (held & turns) == turns) {
            s.kind = Support::clamped;
            if (at[i]) {
                // Across the member as it stood at the start: it does not turn.
                const auto other =
                    static_cast<std::size_t>(at[i]->bar->point[0]) == i ? at[i]->bar->point[1] : at[i]->bar->point[0];
                const Vec out = start_of(snapshot, i) - start_of(snapshot, static_cast<std::size_t>(other));
                if (finite(out) && length(out) > 0) {
                    s.towards = unit(out);
                    const Vec beside = cross(at[i]->up, s.towards);
                    s.x = length(beside) > 0.1 ? unit(beside) : across(s.towards);
                }
            }
        } else if ((held & moves) == moves) {
            s.kind = Support::pinned;
        } else if (held & moves) {
            s.kind = Support::roller;
            const int axes[3] = {held & 1, held & 2, held & 4};
            const int upright = std::abs(down[2]) > 0.9 ? 2 : std::abs(down[1]) > 0.9 ? 1 : 0;
            if (!axes[upright])
                for (int c = 0; c < 3; ++c)
                    if (axes[c]) s.towards = {c == 0 ? -1.0 : 0, c == 1 ? -1.0 : 0, c == 2 ? -1.0 : 0};
        }
        supports.push_back(s);
    }
    return supports;
}

double support_size(const Support& s, double least) { return std::max(least, s.section); }

Actors support_actors(std::span<const Support> supports, const Camera& camera, double least) {
    Mesh mesh(camera.target);
    for (const Support& s : supports) {
        // A little larger than the member's section.
        const double em = support_size(s, least);
        const Vec p = s.at, to = s.towards;
        switch (s.kind) {
            case Support::clamped:  // a plate across the member, behind its end
                add_box(mesh, p + 0.16 * em * to, 0.8 * em * s.x, 0.8 * em * unit(cross(to, s.x)), 0.16 * em * to,
                        support_colour);
                break;
            case Support::pinned: add_cone(mesh, p, p + 1.1 * em * to, 0.62 * em, round, support_colour); break;
            case Support::roller: {
                add_cone(mesh, p, p + 0.8 * em * to, 0.5 * em, round, support_colour);
                const Vec side = std::abs(to[0]) < 0.5 ? Vec{1, 0, 0} : Vec{0, 0, 1};
                for (const double d : {-0.3, 0.3})
                    add_ball(mesh, p + 0.98 * em * to + d * em * side, 0.18 * em, round, support_colour);
                break;
            }
            case Support::rotations:
                add_box(mesh, p, {0.3 * em, 0, 0}, {0, 0.3 * em, 0}, {0, 0, 0.3 * em}, support_colour);
        }
    }
    return shaded(mesh);
}

namespace {

/// How far a bar's section stands out from its centreline in a direction of unit length, m.
double stands_out(const DrawnBar& bar, Vec direction) {
    const Vec along = bar.direction(0.5), x = bar.across(along);
    return std::abs(dot(direction, x)) * bar.shape.width / 2 + std::abs(dot(direction, bar.up)) * bar.shape.depth / 2;
}

}  // namespace

namespace {

/// Which arrows of a spread load on an element have their value beside them.
struct Labelled {
    bool first, middle, last;
};

/// A member has its load's value once where it is uniform, else those at its two ends: load k is of one of its
/// elements, and the loads of the others stand beside it.
Labelled labels_of(const Snapshot& snapshot, std::size_t k) {
    const auto goes_on = [&](const Load& a, const Load& b) {
        return a.kind == b.kind && b.at < 0 && b.bar == a.bar + 1 && a.to == 1 && b.from == 0 &&
               snapshot.bars[static_cast<std::size_t>(a.bar)].member ==
                   snapshot.bars[static_cast<std::size_t>(b.bar)].member;
    };
    std::size_t begin = k, end = k;
    while (begin > 0 && snapshot.loads[begin - 1].bar >= 0 && goes_on(snapshot.loads[begin - 1], snapshot.loads[begin]))
        --begin;
    while (end + 1 < snapshot.loads.size() && goes_on(snapshot.loads[end], snapshot.loads[end + 1])) ++end;
    const Vec from = snapshot.loads[begin].value[0], to = snapshot.loads[end].value[1];
    if (length(to - from) > 1e-6 * std::max(length(from), length(to))) return {k == begin, false, k == end};
    const std::size_t count = end - begin + 1, middle = begin + count / 2;
    return {k == middle && count % 2 == 0, k == middle && count % 2 == 1, false};
}

}  // namespace

std::vector<Arrow> load_arrows(const Snapshot& snapshot, std::span<const DrawnBar> bars, double scale, double size) {
    double most[2][2] = {{0, 0}, {0, 0}};  // of forces and moments, at points and spread
    const auto spread = [](const Load& l) { return l.bar >= 0 && l.at < 0; };
    for (const Load& l : snapshot.loads)
        for (int end : {0, 1}) most[l.kind][spread(l)] = std::max(most[l.kind][spread(l)], length(l.value[end]));
    std::vector<const DrawnBar*> drawn(snapshot.bars.size(), nullptr);
    for (const DrawnBar& bar : bars) drawn[static_cast<std::size_t>(bar.bar - snapshot.bars.data())] = &bar;
    std::vector<Arrow> arrows;
    std::vector<std::vector<const DrawnBar*>> at(snapshot.points.size());
    for (const DrawnBar& bar : bars)
        for (const int p : bar.bar->point) at[static_cast<std::size_t>(p)].push_back(&bar);
    const auto add = [&](const Load& l, Vec tip, Vec v, bool labelled, std::span<const DrawnBar* const> on) {
        const double full = most[l.kind][spread(l)], value = length(v);
        if (!finite(tip) || !(value > 1e-9 * full)) return;
        // A force ends at the surface of the member that it acts on.
        double outside = 0;
        for (const DrawnBar* bar : on) outside = std::max(outside, stands_out(*bar, (1 / value) * v));
        if (l.kind == Load::force) tip = tip - outside / value * v;
        const double long_ = size * (spread(l) ? 0.5 : 1) * (0.3 + 0.7 * value / full);
        arrows.push_back({tip - long_ / value * v, tip, l.kind == Load::moment, value, spread(l), labelled});
    };
    for (std::size_t k = 0; k < snapshot.loads.size(); ++k) {
        const Load& l = snapshot.loads[k];
        if (l.bar < 0) {
            const auto point = static_cast<std::size_t>(l.point);
            if (!at[point].empty()) add(l, drawn_at(snapshot, point, scale), l.value[0], true, at[point]);
            continue;
        }
        const DrawnBar* const bar = drawn[static_cast<std::size_t>(l.bar)];
        if (!bar) continue;
        if (l.at >= 0) {
            add(l, bar->at(l.at), l.value[0], true, {&bar, 1});
            continue;
        }
        const Labelled at_arrow = labels_of(snapshot, k);
        const int n = std::clamp(static_cast<int>(bar->length() / (0.45 * size)), 2, 8);
        for (int i = 0; i <= n; ++i) {
            const double t = static_cast<double>(i) / n;
            add(l, bar->at(l.from + t * (l.to - l.from)), (1 - t) * l.value[0] + t * l.value[1],
                (i == 0 && at_arrow.first) || (i == n / 2 && at_arrow.middle) || (i == n && at_arrow.last), {&bar, 1});
        }
    }
    return arrows;
}

namespace {

/// A moment: three quarters of a circle about its axis, with a head where it turns to (right-hand rule).
void add_turn(Mesh& mesh, const Arrow& a, double em) {
    constexpr int pieces = 24;
    const Vec axis = unit(a.tip - a.tail);
    const Vec u = across(axis), v = cross(axis, u);
    const double radius = std::min(0.45 * length(a.tip - a.tail), 1.6 * em), head = 0.7 * em;
    const auto at = [&](double share) {
        const double angle = 1.5 * std::numbers::pi * share - 0.75 * std::numbers::pi;
        return a.tip + radius * std::cos(angle) * u + radius * std::sin(angle) * v;
    };
    for (int i = 0; i < pieces; ++i)
        add_rod(mesh, at(1.0 * i / pieces), at((i + 1.0) / pieces), 0.07 * em, 8, load_colour);
    const Vec onward = unit(at(1) - at(1 - 1.0 / pieces));
    add_cone(mesh, at(1) + 0.7 * head * onward, at(1) - 0.3 * head * onward, 0.36 * head, round, load_colour);
}

}  // namespace

Actors load_actors(std::span<const Arrow> arrows, const Camera& camera, double em) {
    Mesh mesh(camera.target);
    for (const Arrow& a : arrows) {
        if (a.moment) {
            add_turn(mesh, a, em);
            continue;
        }
        const double whole = length(a.tip - a.tail);
        const Vec along = (1 / whole) * (a.tip - a.tail);
        const double head = std::min(a.spread ? 0.4 * em : 0.65 * em, 0.6 * whole), thick = a.spread ? 0.035 : 0.07;
        add_rod(mesh, a.tail, a.tip - 0.8 * head * along, thick * em, 8, load_colour);
        add_cone(mesh, a.tip, a.tip - head * along, 0.36 * head, round, load_colour);
    }
    return shaded(mesh);
}

void add_words(std::vector<Word>& to, std::span<const Arrow> arrows) {
    for (const Arrow& a : arrows) {
        if (!a.labelled) continue;
        const std::string name = std::string(a.moment ? "N m" : "N") + (a.spread ? "/m" : "");
        const Unit unit = unit_for(a.value, name);
        Word w{a.moment ? a.tip : a.tail, short_number(a.value / unit.size) + " " + unit.name, load_colour};
        w.size = 0.8, w.rank = 3, w.weight = a.value, w.away = a.moment ? Vec{0, 0, 3} : a.tail - a.tip;
        to.push_back(w);
    }
}

double largest_panel_force(const Snapshot& snapshot) {
    double most = 0;
    for (const Panel& p : snapshot.floors)
        if (p.has_forces && !p.torn) most = std::max({most, std::abs(p.force[0]), std::abs(p.force[1])});
    return most;
}

namespace {

/// From white to the colour of the larger force's sign.
Colour panel_colour(const Panel& panel, double most) {
    const double larger = std::abs(panel.force[0]) >= std::abs(panel.force[1]) ? panel.force[0] : panel.force[1];
    const Colour& to = larger >= 0 ? panel_tension : panel_compression;
    const double part = most > 0 ? std::sqrt(std::abs(larger) / most) : 0;
    Colour mixed;
    for (std::size_t c = 0; c < 3; ++c)
        mixed[c] = static_cast<std::uint8_t>(std::lround(panel_idle[c] + part * (to[c] - panel_idle[c])));
    return mixed;
}

}  // namespace

Actors floor_actors(const Snapshot& snapshot, std::span<const DrawnBar> bars, double scale, const Camera& camera) {
    std::vector<char> drawn(snapshot.points.size(), 0);
    for (const DrawnBar& bar : bars)
        for (const int p : bar.bar->point) drawn[static_cast<std::size_t>(p)] = 1;
    Mesh fill(camera.target), plates(camera.target), edges(camera.target);
    const bool is_part = bars.size() < snapshot.bars.size();
    const double most = largest_panel_force(snapshot);
    for (const Panel& panel : snapshot.floors) {
        const auto is_drawn = [&](int p) { return drawn[static_cast<std::size_t>(p)] != 0; };
        if (panel.points.size() < 3 || panel.torn) continue;
        // plates have nodes that are at no bar; of a part of the structure those are drawn that touch it
        if (panel.has_forces
                ? !bars.empty() && std::none_of(panel.points.begin(), panel.points.end(), is_drawn) && is_part
                : !std::all_of(panel.points.begin(), panel.points.end(), is_drawn))
            continue;
        const Colour colour = panel.has_forces ? panel_colour(panel, most) : floor_fill;
        std::vector<Vec> at;
        for (const int p : panel.points) at.push_back(drawn_at(snapshot, static_cast<std::size_t>(p), scale));
        const Vec normal = unit(cross(at[1] - at[0], at.back() - at[0]));
        std::vector<Mesh::Index> corners;
        for (const Vec& p : at) corners.push_back((panel.has_forces ? plates : fill).vertex(p, normal, colour));
        for (std::size_t i = 2; i < at.size(); ++i)
            (panel.has_forces ? plates : fill).triangle(corners[0], corners[i - 1], corners[i]);
        for (std::size_t i = 0; i < at.size(); ++i) edges.line(at[i], at[(i + 1) % at.size()], floor_edge);
    }
    Actors actors;
    for (const auto& [mesh, opacity] : {std::pair(&fill, 0.35), std::pair(&plates, 0.8)}) {
        if (mesh->empty()) continue;
        auto area = mesh->surface();
        area->GetProperty()->LightingOff();
        area->GetProperty()->SetOpacity(opacity);
        actors.push_back(area);
    }
    if (!actors.empty()) actors.push_back(edges.lines(1));
    return actors;
}

GroundPatch ground_under(const Plane& plane, std::span<const Vec> points) {
    GroundPatch g;
    g.origin = plane.point, g.normal = unit(plane.normal);
    g.x = unit(cross(std::abs(g.normal[1]) < 0.9 ? Vec{0, 1, 0} : Vec{1, 0, 0}, g.normal));
    g.y = cross(g.normal, g.x);
    for (int c : {0, 1}) g.low[c] = 1e300, g.high[c] = -1e300;
    for (const Vec& p : points) {
        const double at[2] = {dot(p - plane.point, g.x), dot(p - plane.point, g.y)};
        for (int c : {0, 1}) g.low[c] = std::min(g.low[c], at[c]), g.high[c] = std::max(g.high[c], at[c]);
    }
    const double part = std::max({g.high[0] - g.low[0], g.high[1] - g.low[1], 1e-3}) / 6;
    const double power = std::pow(10, std::floor(std::log10(part)));
    g.step = power * (part / power >= 5 ? 5 : part / power >= 2 ? 2 : 1);
    for (int c : {0, 1}) {
        g.low[c] = g.step * std::floor(g.low[c] / g.step - 0.25);
        g.high[c] = g.step * std::ceil(g.high[c] / g.step + 0.25);
    }
    return g;
}

Actors ground_actors(const GroundPatch& g, const Camera& camera) {
    Mesh fill(camera.target), grid(camera.target);
    const auto corners = g.corners();
    fill.quad(corners[0], corners[1], corners[2], corners[3], g.normal, ground_fill);
    const auto lines = [&](int c) { return static_cast<int>(std::lround((g.high[c] - g.low[c]) / g.step)); };
    for (int i = 0; i <= lines(0); ++i) {
        const double u = g.low[0] + i * g.step;
        grid.line(g.at(u, g.low[1]), g.at(u, g.high[1]), ground_line);
    }
    for (int i = 0; i <= lines(1); ++i) {
        const double v = g.low[1] + i * g.step;
        grid.line(g.at(g.low[0], v), g.at(g.high[0], v), ground_line);
    }
    auto area = fill.surface();
    area->GetProperty()->LightingOff();
    return {area, grid.lines(1)};
}

}  // namespace hinge::output

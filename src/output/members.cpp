// Draws bars as solids with their true sections, or as plain lines if there are very many.
#include "output/members.h"

#include <vtkActor.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "output/mesh.h"

namespace hinge::output {
namespace {

constexpr std::size_t few = 200, most_solids = 20000;  // bars; above that lines
constexpr double thinnest = 0.9;   // pixels, half a section's side: thinner bars would break up into dots
constexpr double with_detail = 7;  // pixels, an H's depth: smaller ones are drawn as the box around them
constexpr double halo = 1.2;       // pixels of white around a bar, to tell crossing bars apart
constexpr double haze = 0.18;      // share of white at the far end of the scene
constexpr int bends = 10;          // straight pieces of a curved bar

/// Colour with distance: far bars fade a little towards the paper.
class Haze {
public:
    Haze(const Camera& camera, std::span<const DrawnBar> bars) : camera_(camera) {
        std::vector<double> depths;
        for (const DrawnBar& bar : bars) depths.push_back(depth(bar.a));
        // A few bars need no help to be told apart, and keep the legend's colours.
        if (depths.size() <= few) return;
        // Strays at either end must not use up the range.
        const auto at = [&](double share) {
            const auto i = depths.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(depths.size() - 1));
            std::nth_element(depths.begin(), i, depths.end());
            return *i;
        };
        near_ = at(0.02);
        span_ = std::max(at(0.98) - near_, 1e-9);
    }
    Colour operator()(Vec p, Colour full) const {
        const double white_share = haze * std::clamp((depth(p) - near_) / span_, 0.0, 1.0);
        Colour out;
        for (int c = 0; c < 3; ++c)
            out[c] = static_cast<std::uint8_t>(std::lround(full[c] + white_share * (255 - full[c])));
        return out;
    }

private:
    double depth(Vec p) const { return dot(camera_.eye - p, camera_.back); }

    const Camera& camera_;
    double near_ = std::numeric_limits<double>::max(), span_ = 1;
};

using Outline = std::vector<std::array<double, 2>>;

/// Counter-clockwise, seen from the end of the bar. `pixels`: how deep it is in the picture.
Outline outline_of(const Shape& s, double pixels) {
    const double x = s.width / 2, y = s.depth / 2;
    if (s.kind == Shape::round) {
        const int sides = pixels < 5 ? 6 : pixels < 16 ? 12 : 36;
        Outline circle;
        for (int i = 0; i < sides; ++i) {
            const double angle = 2 * std::numbers::pi * i / sides;
            circle.push_back({x * std::cos(angle), y * std::sin(angle)});
        }
        return circle;
    }
    if (s.kind == Shape::h && pixels >= with_detail) {
        const double w = s.web / 2, f = y - s.flange;
        return {{-x, -y}, {x, -y}, {x, -f}, {w, -f}, {w, f},   {x, f},
                {x, y},   {-x, y}, {-x, f}, {-w, f}, {-w, -f}, {-x, -f}};
    }
    return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

Colour colour_of(const DrawnBar& bar, const View& view, double t) {
    if (view.show == Show::broken_in) {
        const auto member = static_cast<std::size_t>(bar.bar->member - 1);
        const int count = member < view.broken_in.size() ? view.broken_in[member] : 0;
        return share_colours[static_cast<std::size_t>(share_class(count, view.runs))];
    }
    if (view.show == Show::group && bar.bar->state != BarState::broken)
        return bar.bar->group < 0 ? plain_bar
                                  : group_colours[static_cast<std::size_t>(bar.bar->group) % std::size(group_colours)];
    const int is = bar.carries.class_at(t);
    return view.show == Show::yield || is == broken_class ? class_colours[static_cast<std::size_t>(is)] : plain_bar;
}

/// Where it bends or changes its colour.
std::vector<double> stations(const DrawnBar& bar, const View& view) {
    std::vector<double> at = view.show == Show::yield ? bar.carries.class_changes() : std::vector{0.0, 1.0};
    if (bar.curved) {
        for (int i = 1; i < bends; ++i) at.push_back(static_cast<double>(i) / bends);
        std::sort(at.begin(), at.end());
    }
    return at;
}

/// The section as it stands at a point of the bar.
class Ring {
public:
    Ring(const DrawnBar& bar, double t, const Outline& outline) {
        const Vec along = bar.direction(t);
        const Vec up = unit(bar.up - dot(bar.up, along) * along), across = unit(cross(up, along));
        Vec centre = bar.at(t);
        const int end = t == 0 ? 0 : 1;
        const bool at_end = t == 0 || t == 1;
        if (at_end) centre = centre + (t == 0 ? -1 : 1) * bar.reach[end] * along;
        for (const auto& [x, y] : outline) {
            const Vec out = x * across + y * up;
            // Moved along the bar into the plane that its end lies in.
            const double slide = at_end ? dot(out, bar.cut[end]) / dot(along, bar.cut[end]) : 0;
            points.push_back(centre + out - slide * along);
        }
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const auto& p = outline[i];
            const auto& q = outline[(i + 1) % outline.size()];
            const double dx = q[0] - p[0], dy = q[1] - p[1], size = std::hypot(dx, dy);
            normals.push_back(size > 0 ? dy / size * across - dx / size * up : across);
        }
        axis = along;
    }
    std::vector<Vec> points, normals;  ///< normal i: of the side from point i to the next
    Vec axis;
};

/// Sides between two rings. Round sections are shaded round.
void add_sides(Mesh& mesh, const Ring& from, const Ring& to, Colour at_from, Colour at_to, bool round) {
    const std::size_t n = from.points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n, before = (i + n - 1) % n;
        const Vec flat = from.normals[i];
        const Vec first = round ? unit(flat + from.normals[before]) : flat,
                  second = round ? unit(flat + from.normals[next]) : flat;
        const Mesh::Index a = mesh.vertex(from.points[i], first, at_from),
                          b = mesh.vertex(from.points[next], second, at_from),
                          c = mesh.vertex(to.points[next], second, at_to), d = mesh.vertex(to.points[i], first, at_to);
        mesh.triangle(a, b, c);
        mesh.triangle(a, c, d);
    }
}

void add_cap(Mesh& mesh, const Ring& ring, const Shape& shape, bool first, Colour colour) {
    const Vec normal = first ? -1.0 * ring.axis : ring.axis;
    std::vector<Mesh::Index> v;
    for (const Vec& p : ring.points) v.push_back(mesh.vertex(p, normal, colour));
    const auto face = [&](std::size_t i, std::size_t j, std::size_t k) {
        first ? mesh.triangle(v[i], v[k], v[j]) : mesh.triangle(v[i], v[j], v[k]);
    };
    if (shape.kind == Shape::h && v.size() == 12) {  // flange, web, flange
        face(0, 1, 2), face(0, 2, 11), face(10, 3, 4), face(10, 4, 9), face(8, 5, 6), face(8, 6, 7);
        return;
    }
    for (std::size_t i = 1; i + 1 < v.size(); ++i) face(0, i, i + 1);
}

std::vector<vtkSmartPointer<vtkActor>> solids(std::span<const DrawnBar> bars, const View& view, const Camera& camera) {
    const Haze haze_of(camera, bars);
    Mesh body(camera.target), edge(camera.target);
    for (const DrawnBar& bar : bars) {
        const double pixel = camera.pixel_at(bar.at(0.5));
        Shape shape = bar.shape;
        shape.width = std::max(shape.width, 2 * thinnest * pixel);
        shape.depth = std::max(shape.depth, 2 * thinnest * pixel);
        const Outline outline = outline_of(shape, shape.depth / pixel);
        const double around = 2 * halo * pixel;
        const Outline wider = outline_of({shape.kind == Shape::round ? Shape::round : Shape::rectangle,
                                          shape.width + around, shape.depth + around, 0, 0},
                                         shape.depth / pixel);
        const std::vector<double> at = stations(bar, view);
        const bool round = shape.kind == Shape::round;
        for (std::size_t i = 0; i + 1 < at.size(); ++i) {
            const Ring from(bar, at[i], outline), to(bar, at[i + 1], outline);
            const Colour colour = colour_of(bar, view, (at[i] + at[i + 1]) / 2);
            add_sides(body, from, to, haze_of(bar.at(at[i]), colour), haze_of(bar.at(at[i + 1]), colour), round);
            if (i == 0) add_cap(body, from, shape, true, haze_of(bar.a, colour));
            if (i + 2 == at.size()) add_cap(body, to, shape, false, haze_of(bar.b, colour));
        }
        const int pieces = bar.curved ? bends : 1;
        for (int i = 0; i < pieces; ++i)
            add_sides(edge, Ring(bar, static_cast<double>(i) / pieces, wider),
                      Ring(bar, static_cast<double>(i + 1) / pieces, wider), white, white, round);
    }
    auto solid = body.surface();
    solid->GetProperty()->SetAmbient(0.58);
    solid->GetProperty()->SetDiffuse(0.5);
    solid->GetProperty()->SetSpecular(0.08);
    solid->GetProperty()->SetSpecularPower(18);
    // Only the far sides of slightly fatter white bars: they show as an edge against whatever lies behind.
    auto outline = edge.surface();
    outline->GetProperty()->LightingOff();
    outline->GetProperty()->FrontfaceCullingOn();
    return {outline, solid};
}

std::vector<vtkSmartPointer<vtkActor>> lines(std::span<const DrawnBar> bars, const View& view, const Camera& camera) {
    const Haze haze_of(camera, bars);
    Mesh mesh(camera.target);
    double widths = 0;
    for (const DrawnBar& bar : bars) {
        const Colour colour = colour_of(bar, view, 0.5);
        mesh.line(mesh.vertex(bar.a, {}, haze_of(bar.a, colour)), mesh.vertex(bar.b, {}, haze_of(bar.b, colour)));
        widths += std::min(bar.shape.width, bar.shape.depth);
    }
    const double pixels = widths / static_cast<double>(bars.size()) / camera.metres_per_pixel;
    return {mesh.lines(std::clamp(pixels, 1.0, 3.0))};
}

}  // namespace

std::vector<vtkSmartPointer<vtkActor>> member_actors(std::span<const DrawnBar> bars, const View& view,
                                                     const Camera& camera) {
    if (bars.empty()) return {};
    return bars.size() <= most_solids ? solids(bars, view, camera) : lines(bars, view, camera);
}

vtkSmartPointer<vtkActor> ghost_actor(const Snapshot& snapshot, std::span<const DrawnBar> bars, const Camera& camera,
                                      double pixels) {
    Mesh mesh(camera.target);
    for (const DrawnBar& bar : bars) {
        if (bar.bar->state == BarState::broken) continue;
        mesh.line(drawn_at(snapshot, static_cast<std::size_t>(bar.bar->point[0]), 0),
                  drawn_at(snapshot, static_cast<std::size_t>(bar.bar->point[1]), 0), ghost_colour);
    }
    return mesh.empty() ? nullptr : mesh.lines(pixels);
}

}  // namespace hinge::output

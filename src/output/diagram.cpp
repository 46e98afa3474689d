// Diagrams of a resultant along the members.
#include "output/diagram.h"

#include <vtkActor.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "output/mesh.h"

namespace hinge::output {
namespace {

constexpr int pieces = 8;          // of a bar
constexpr double of_scene = 0.10;  // the largest value's height, of the scene's size
constexpr double of_member = 0.5;  // and at most of the longest bar's length

/// Positive values lie to this side.
Vec side_of(const DrawnBar& bar, Show which, double t) {
    const Vec along = bar.direction(t), x = bar.across(along);
    switch (which) {
        case Show::My: return -1.0 * x;
        case Show::Qx: return x;
        default: return unit(bar.up - dot(bar.up, along) * along);
    }
}

double value(const DrawnBar& bar, Show which, double t) { return bar.carries.at(which, t); }

/// Where along a bar the diagram is computed: from 0 to 1, on both sides of point loads, and where it is largest.
std::vector<double> stations(const DrawnBar& bar, Show which) {
    constexpr double beside = 1e-7;
    std::vector<double> at;
    for (int i = 0; i <= pieces; ++i) at.push_back(static_cast<double>(i) / pieces);
    for (const double t : bar.carries.jumps()) at.insert(at.end(), {t - beside, t + beside});
    std::sort(at.begin(), at.end());
    const std::vector<double> even = at;
    for (std::size_t i = 0; i + 1 < even.size(); ++i)
        if (even[i + 1] - even[i] > 3 * beside)
            for (const double t : bar.carries.peaks(which, even[i], even[i + 1])) at.push_back(t);
    std::sort(at.begin(), at.end());
    return at;
}

}  // namespace

const char* name_of(Show which) {
    static const char* const names[] = {"f_y", "groups", "broken in", "", "N", "Qx", "Qy", "Mx", "My", "Mz"};
    return names[static_cast<int>(which)];
}

const char* unit_of(Show which) { return which >= Show::Mx ? "N m" : "N"; }

Diagram plan_diagram(std::span<const DrawnBar> bars, Show which, double size, double full) {
    Diagram d{which};
    double longest = 0;
    for (const DrawnBar& bar : bars) {
        longest = std::max(longest, bar.length());
        for (const double t : stations(bar, which)) {
            const double v = value(bar, which, t);
            d.largest = std::max(d.largest, v);
            d.smallest = std::min(d.smallest, v);
        }
    }
    // What the forces leave of zero is noise, and must not be drawn as large as forces.
    double forces = 0;
    for (const DrawnBar& bar : bars)
        for (const Show s : {Show::N, Show::Qx, Show::Qy, Show::Mx, Show::My, Show::Mz})
            for (const double t : {0.0, 1.0}) {
                const bool moment = s >= Show::Mx;
                forces = std::max(forces, std::abs(value(bar, s, t)) / (moment ? bar.length() : 1));
            }
    const double most = std::max(d.largest, -d.smallest), noise = 1e-9 * forces * (which >= Show::Mx ? longest : 1);
    if (d.largest < 1e-9 * most) d.largest = 0;
    if (-d.smallest < 1e-9 * most) d.smallest = 0;
    if (most > noise) d.metres = std::min(of_scene * size, of_member * 2 * longest) / (full > 0 ? full : most);
    else d.largest = d.smallest = 0;
    return d;
}

void add_points(std::vector<Vec>& to, std::span<const DrawnBar> bars, const Diagram& d) {
    for (const DrawnBar& bar : bars)
        for (const double t : stations(bar, d.which))
            to.push_back(bar.at(t) + d.metres * value(bar, d.which, t) * side_of(bar, d.which, t));
}

std::vector<vtkSmartPointer<vtkActor>> diagram_actors(std::span<const DrawnBar> bars, const Diagram& d,
                                                      const Camera& camera, double line) {
    Mesh fill(camera.target), edge(camera.target);
    const auto piece = [&](const DrawnBar& bar, double t0, double v0, double t1, double v1) {
        const bool plus = v0 + v1 > 0;
        const Vec s0 = side_of(bar, d.which, t0), s1 = side_of(bar, d.which, t1), a = bar.at(t0), b = bar.at(t1),
                  c = b + d.metres * v1 * s1, e = a + d.metres * v0 * s0;
        fill.quad(a, b, c, e, bar.across(bar.direction(t0)), plus ? plus_fill : minus_fill);
        edge.line(camera.nearer(e, line * camera.pixel_at(e)), camera.nearer(c, line * camera.pixel_at(c)),
                  plus ? plus_line : minus_line);
    };
    const double least = 1e-6 * std::max(d.largest, -d.smallest);  // less is what rounding leaves of zero
    for (const DrawnBar& bar : bars) {
        if (bar.bar->state == BarState::broken) continue;
        const std::vector<double> at = stations(bar, d.which);
        for (std::size_t i = 0; i + 1 < at.size(); ++i) {
            edge.line(bar.at(at[i]), bar.at(at[i + 1]), diagram_axis);
            const double t0 = at[i], t1 = at[i + 1], v0 = value(bar, d.which, t0), v1 = value(bar, d.which, t1);
            if (std::max(std::abs(v0), std::abs(v1)) < least) continue;
            if (v0 * v1 < 0) {
                const double zero = t0 + (t1 - t0) * v0 / (v0 - v1);
                piece(bar, t0, v0, zero, 0);
                piece(bar, zero, 0, t1, v1);
            } else {
                piece(bar, t0, v0, t1, v1);
            }
        }
        for (const double t : {0.0, 1.0}) {
            const double v = value(bar, d.which, t);
            const Vec p = bar.at(t), q = p + d.metres * v * side_of(bar, d.which, t);
            if (std::abs(v) >= least) edge.line(p, q, v > 0 ? plus_line : minus_line);
        }
    }
    std::vector<vtkSmartPointer<vtkActor>> actors;
    if (fill.empty()) return actors;
    auto area = fill.surface();
    area->GetProperty()->LightingOff();
    actors.push_back(area);
    actors.push_back(edge.lines(line));
    return actors;
}

void add_words(std::vector<Word>& to, std::span<const DrawnBar> bars, const Diagram& d, const Camera& camera,
               double em) {
    struct Most {
        double v = 0;
        const DrawnBar* bar = nullptr;
        double t = 0;
    };
    std::map<int, std::array<Most, 2>> of;  // of each member the largest above zero, and below
    for (const DrawnBar& bar : bars) {
        if (bar.bar->state == BarState::broken) continue;
        for (const double t : stations(bar, d.which)) {
            const double v = value(bar, d.which, t);
            Most& most = of[bar.bar->member][v < 0];
            if (std::abs(v) > std::abs(most.v) * (1 + 1e-9)) most = {v, &bar, t};
        }
    }
    const double most = std::max(d.largest, -d.smallest);
    const Unit unit = unit_for(most, unit_of(d.which));
    const auto first = static_cast<std::ptrdiff_t>(to.size());
    const auto add = [&](const Most& m, double least) {
        if (!m.bar || std::abs(m.v) < least) return;
        const Vec p = camera.project(m.bar->a), q = camera.project(m.bar->b);
        if (std::hypot(q[0] - p[0], q[1] - p[1]) < 1.2 * em) return;
        const Vec side = side_of(*m.bar, d.which, m.t);
        Word w{m.bar->at(m.t) + d.metres * m.v * side, short_number(m.v / unit.size), m.v > 0 ? plus_line : minus_line};
        w.size = 0.8, w.rank = m.v == d.largest || m.v == d.smallest ? 4 : 2, w.weight = std::abs(m.v);
        w.away = m.v > 0 ? side : -1.0 * side;
        // Members that go on in each other have one value where they meet.
        const Vec here = camera.project(w.at);
        const auto same = [&](const Word& other) {
            const Vec there = camera.project(other.at);
            return other.text == w.text && std::hypot(here[0] - there[0], here[1] - there[1]) < 0.5 * em;
        };
        if (std::none_of(to.begin() + first, to.end(), same)) to.push_back(w);
    };
    const double shown = 1e-3 * most;
    for (const auto& [member, m] : of) {
        const bool above = std::abs(m[0].v) >= std::abs(m[1].v);
        add(m[!above], shown);
        add(m[above], std::max(shown, 0.1 * std::abs(m[!above].v)));
    }
}

}  // namespace hinge::output

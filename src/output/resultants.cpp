// Section forces along a bar, from the forces at its ends and the loads on it.
#include "output/resultants.h"

#include <algorithm>
#include <cmath>

#include "output/colours.h"

namespace hinge::output {
namespace {

constexpr double plastic_from = 0.999;  // f_y reaches 1 only up to the tolerance of the return

bool has_forces(const Bar& bar) { return bar.N0 > 0 || bar.Mx0 > 0 || bar.My0 > 0 || bar.Mz0 > 0; }

}  // namespace

Resultants::Resultants(const Bar& bar, double length, Vec x, Vec y, std::span<const Load* const> loads)
    : bar_(&bar),
      x_{{bar.Mx[0], bar.Mx[1]}, {bar.Qy[0], bar.Qy[1]}, 1, length},
      y_{{bar.My[0], bar.My[1]}, {bar.Qx[0], bar.Qx[1]}, -1, length},
      // Frames that hold no shear forces give the moments a straight course.
      sheared_(bar.Qx[0] != 0 || bar.Qx[1] != 0 || bar.Qy[0] != 0 || bar.Qy[1] != 0) {
    for (const Load* load : loads) {
        const bool is_force = load->kind == Load::force;
        const auto along = [&](const Vec& axis, int end) { return dot(load->value[end], axis); };
        // A force along y bends about x, a moment about x does, too.
        const auto add = [&](BarBending& to, const Vec& force_axis, const Vec& moment_axis) {
            const Vec& axis = is_force ? force_axis : moment_axis;
            if (load->at < 0 && load->is_partial()) {
                const double v[2] = {along(axis, 0), along(axis, 1)}, none = 0;
                to.parts.push_back({load->from,
                                    load->to,
                                    {is_force ? v[0] : none, is_force ? v[1] : none},
                                    {is_force ? none : v[0], is_force ? none : v[1]}});
            } else if (load->at < 0) {
                for (int end : {0, 1}) (is_force ? to.q : to.m)[end] += along(axis, end);
            } else {
                to.points.push_back(
                    {std::clamp(load->at, 0.0, 1.0), is_force ? along(axis, 0) : 0, is_force ? 0 : along(axis, 0)});
            }
        };
        add(x_, y, x);
        add(y_, x, y);
    }
    x_.close();
    y_.close();
    x_.compression = bar.compression[0], y_.compression = bar.compression[1];
}

double Resultants::at(Show which, double t) const {
    const auto straight = [&](const double(&m)[2]) { return m[0] + t * (m[1] - m[0]); };
    const auto slope = [&](const double(&m)[2]) { return (m[1] - m[0]) / x_.length; };
    switch (which) {
        case Show::N: return bar_->N;
        case Show::Mz: return bar_->Mz;
        case Show::Mx: return sheared_ || x_.compression != 0 ? x_.moment(t) : straight(x_.M);
        case Show::My: return sheared_ || y_.compression != 0 ? y_.moment(t) : straight(y_.M);
        case Show::Qx: return sheared_ ? y_.shear(t) : -slope(y_.M);
        case Show::Qy: return sheared_ ? x_.shear(t) : slope(x_.M);
        default: return 0;
    }
}

double Resultants::yield_at(double t) const {
    if (!has_forces(*bar_)) return bar_->yield;
    if (const auto& f = bar_->yield_along; f[0] >= 0) {
        const double course = f[0] * (1 - t) * (1 - 2 * t) + 4 * f[1] * t * (1 - t) + f[2] * t * (2 * t - 1);
        return std::clamp(course, 0.0, std::max({f[0], f[1], f[2]}));
    }
    const auto part = [](double force, double limit) { return limit > 0 ? (force / limit) * (force / limit) : 0; };
    const double f_y = part(bar_->N, bar_->N0) + part(at(Show::Mx, t), bar_->Mx0) + part(at(Show::My, t), bar_->My0) +
                       part(bar_->Mz, bar_->Mz0);
    // N is that of the end where it is larger. Between its ends a load or the axial force can bend it more than there.
    const bool bends_between = !jumps().empty() || x_.q[0] != 0 || x_.q[1] != 0 || y_.q[0] != 0 || y_.q[1] != 0 ||
                               x_.compression != 0 || y_.compression != 0;
    return std::min(f_y, bends_between ? 1.0 : bar_->yield);
}

int Resultants::class_at(double t) const {
    if (bar_->state == BarState::broken) return broken_class;
    const double f_y = yield_at(t);
    if (f_y >= plastic_from) return plastic_class;
    // Written so that a value that is not a number gives the lowest band.
    return f_y > 0 ? std::min(static_cast<int>(f_y * 5), plastic_class - 1) : 0;
}

std::vector<double> Resultants::class_changes() const {
    constexpr int samples = 16;
    std::vector<double> at{0};
    if (bar_->state != BarState::broken && has_forces(*bar_)) {
        int before = class_at(0);
        for (int i = 1; i <= samples; ++i) {
            const double t = static_cast<double>(i) / samples;
            const int now = class_at(t);
            if (now != before) {
                double low = t - 1.0 / samples, high = t;
                for (int k = 0; k < 6; ++k) {
                    const double middle = (low + high) / 2;
                    (class_at(middle) == before ? low : high) = middle;
                }
                at.push_back((low + high) / 2);
            }
            before = now;
        }
    }
    at.push_back(1);
    return at;
}

std::vector<double> Resultants::jumps() const {
    std::vector<double> at;
    for (const BarBending* b : {&x_, &y_}) {
        for (const BarBending::Point& p : b->points) at.push_back(p.t);
        for (const BarBending::Part& p : b->parts)
            for (const double t : {p.t0, p.t1})
                if (t > 0 && t < 1) at.push_back(t);
    }
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    return at;
}

// A cubic between point loads, as loads are linear along the bar.
std::vector<double> Resultants::peaks(Show which, double t0, double t1) const {
    double v[4];
    for (int i = 0; i < 4; ++i) v[i] = at(which, t0 + (t1 - t0) * i / 3);
    return peaks_of_cubic(v, t0, t1);
}

}  // namespace hinge::output

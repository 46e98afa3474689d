// Outlines of sections for the tests of their plastic domains.
#pragma once

#include "section/outline.h"

namespace hinge::test {

inline beam::Outline::Polygon rectangle(double b, double d, bool hole = false) {
    return {{{-b / 2, -d / 2}, {b / 2, -d / 2}, {b / 2, d / 2}, {-b / 2, d / 2}}, hole};
}

inline beam::Outline h_outline(double b, double d, double web, double flange) {
    const double x = b / 2, y = d / 2, w = web / 2, f = d / 2 - flange;
    beam::Outline o;
    o.polygons = {
        {{{-x, -y}, {x, -y}, {x, -f}, {w, -f}, {w, f}, {x, f}, {x, y}, {-x, y}, {-x, f}, {-w, f}, {-w, -f}, {-x, -f}}}};
    return o;
}

inline beam::Outline pipe_outline(double radius, double bore) {
    beam::Outline o;
    o.circles = {{Eigen::Vector2d::Zero(), radius, false}, {Eigen::Vector2d::Zero(), bore, true}};
    return o;
}

/// Without symmetry.
inline beam::Outline angle_outline(double b, double d, double t) {
    beam::Outline o;
    o.polygons = {{{{0, 0}, {b, 0}, {b, t}, {t, t}, {t, d}, {0, d}}}};
    o.move(-o.centroid());
    return o;
}

/// A point lies within the polygon of these corners: a ray from it crosses an odd number of sides.
inline bool within_polygon(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& at) {
    bool in = false;
    for (std::size_t i = 0, n = corners.size(); i < n; ++i) {
        const Eigen::Vector2d &a = corners[i], &b = corners[(i + 1) % n];
        if ((a.y() > at.y()) != (b.y() > at.y()) &&
            at.x() < a.x() + (at.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            in = !in;
    }
    return in;
}

}  // namespace hinge::test

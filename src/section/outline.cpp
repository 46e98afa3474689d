#include "section/outline.h"

#include <cmath>
#include <numbers>

namespace hinge::beam {

double signed_area(const std::vector<Eigen::Vector2d>& corners) {
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) twice += cross(corners[i], corners[(i + 1) % corners.size()]);
    return twice / 2;
}

Eigen::Vector2d signed_moments(const std::vector<Eigen::Vector2d>& corners) {
    Eigen::Vector2d six = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d &p = corners[i], &q = corners[(i + 1) % corners.size()];
        six += cross(p, q) * (p + q);
    }
    return six / 6;
}

double Outline::area() const {
    double sum = 0;
    for (const Polygon& p : polygons) sum += (p.hole ? -1 : 1) * std::abs(signed_area(p.corners));
    for (const Circle& c : circles) sum += (c.hole ? -1 : 1) * std::numbers::pi * c.radius * c.radius;
    return sum;
}

Eigen::Vector2d Outline::centroid() const {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Polygon& p : polygons)
        sum += (p.hole == (signed_area(p.corners) > 0) ? -1 : 1) * signed_moments(p.corners);
    for (const Circle& c : circles) sum += (c.hole ? -1 : 1) * std::numbers::pi * c.radius * c.radius * c.centre;
    return sum / area();
}

void Outline::move(const Eigen::Vector2d& by) {
    for (Polygon& p : polygons)
        for (Eigen::Vector2d& corner : p.corners) corner += by;
    for (Circle& c : circles) c.centre += by;
}

double Reinforcement::Bar::radius() const { return std::sqrt(area / std::numbers::pi); }

}  // namespace hinge::beam

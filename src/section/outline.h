// Outline of a cross-section, and the concrete and bars within it.
#pragma once

#include <optional>
#include <vector>

#include "core/types.h"

namespace hinge::beam {

/// Outline of a cross-section, m. Its axes go through the centroid of the area: x and y of the member.
struct Outline {
    struct Polygon {
        std::vector<Eigen::Vector2d> corners;  ///< in either direction of rotation
        bool hole = false;
    };
    struct Circle {
        Eigen::Vector2d centre = Eigen::Vector2d::Zero();
        double radius = 0;
        bool hole = false;
    };
    std::vector<Polygon> polygons;
    std::vector<Circle> circles;

    /// Area, m^2, and its centroid, m.
    double area() const;
    Eigen::Vector2d centroid() const;
    void move(const Eigen::Vector2d& by);
};

/// Stress of concrete over its compressive strain, over its strength: 1 - (1 - strain / peak)^exponent up to `peak`,
/// then 1 (EN 1992-1-1, 3.1.7); or a block: 1 from `block` on, and 0 below (ACI 318).
struct ConcreteStrains {
    double peak = 0.002, ultimate = 0.0035, exponent = 2;
    double block = 0;     ///< 0: no block
    double bars = 200e9;  ///< E of the bars, Pa
};

/// Strengths of concrete, none of them in tension, and of the bars in it. Pa, m^2, m.
struct Reinforcement {
    struct Bar {
        Eigen::Vector2d centre = Eigen::Vector2d::Zero();
        double area = 0, tension = 0, compression = 0;
        double radius() const;
    };
    double concrete = 0;    ///< compression
    std::vector<Bar> bars;  ///< each is stronger in compression than the concrete, and lies within the outline
    /// Its ultimate states bound the forces; without: ideal plasticity does.
    std::optional<ConcreteStrains> strains = {};
};

/// Area and first moments of a polygon, with the sign of its direction of rotation.
double signed_area(const std::vector<Eigen::Vector2d>& corners);
Eigen::Vector2d signed_moments(const std::vector<Eigen::Vector2d>& corners);

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace hinge::beam

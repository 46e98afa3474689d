// Camera of a picture: selects the points of a scene to show, and fits the camera to them.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace hinge::output {

using Vec = std::array<double, 3>;

inline Vec operator+(Vec a, Vec b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec operator-(Vec a, Vec b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec operator*(double s, Vec a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(Vec a, Vec b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec cross(Vec a, Vec b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(Vec a);
inline Vec unit(Vec a) { return (1 / length(a)) * a; }
bool finite(Vec a);
/// A unit vector perpendicular to `along`: horizontal if possible, else along y.
Vec across(Vec along);

/// The diagonal of the box around the points, m.
double size_of(std::span<const Vec> points);

/// Returns the points without strays, which are much farther from the middle than 98 % of all points.
std::vector<Vec> without_strays(std::span<const Vec> points);

struct Camera {
    Vec right, up, back;  ///< unit vectors; back points from the scene to the eye
    Vec eye, target;
    bool parallel;             ///< without perspective
    double view_angle;         ///< degrees, from the lower to the upper edge
    double nearest, farthest;  ///< drawn depths, m from the eye
    double metres_per_pixel;   ///< at the target; without perspective everywhere
    double width, height;      ///< pixels

    /// Position of p in pixels from the lower left corner, and its distance in front of the eye, m.
    Vec project(Vec p) const;
    /// Size of a pixel at p, m.
    double pixel_at(Vec p) const;
    /// The point moved towards the eye by `by`; its place in the picture stays the same.
    Vec nearer(Vec p, double by) const;
};

/// Fits a camera that looks along -`from` to all `points`, with a margin `reach` around them, in a picture of this many
/// pixels. Throws InputError when `from` is no direction.
Camera fit_camera(std::span<const Vec> points, double reach, Vec from, Vec up, bool parallel, int width, int height);

}  // namespace hinge::output

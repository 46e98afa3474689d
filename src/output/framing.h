// Where the eye stands: what of a scene a picture should show, and the camera that shows just that.
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
/// A direction across another one, of unit length: level where that is possible, else along y.
Vec across(Vec along);

/// The diagonal of the box around the points, m.
double size_of(std::span<const Vec> points);

/// The points without strays: those much farther from the middle than 98 % of all points are.
std::vector<Vec> without_strays(std::span<const Vec> points);

struct Camera {
    Vec right, up, back;  ///< unit vectors; back points from the scene to the eye
    Vec eye, target;
    bool parallel;             ///< without perspective
    double view_angle;         ///< degrees, from the lower to the upper edge
    double nearest, farthest;  ///< drawn depths, m from the eye
    double metres_per_pixel;   ///< at the target; without perspective everywhere
    double width, height;      ///< pixels

    /// Pixels from the lower left corner of what it shows, and how far in front of the eye, m.
    Vec project(Vec p) const;
    /// Metres of a pixel where p is.
    double pixel_at(Vec p) const;
    /// The point moved to the eye by so much: it stays where it is in the picture.
    Vec nearer(Vec p, double by) const;
};

/// The camera that looks along -`from` and just holds all `points`, and what lies within `reach` of them, in a picture
/// of this many pixels. Throws InputError when `from` is no direction.
Camera fit_camera(std::span<const Vec> points, double reach, Vec from, Vec up, bool parallel, int width, int height);

}  // namespace hinge::output

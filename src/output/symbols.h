// Signs in a scene: plastic hinges, supports, loads and the ground.
#pragma once

#include <span>
#include <vector>

#include <vtkSmartPointer.h>

#include "output/bars.h"
#include "output/words.h"

class vtkActor;

namespace hinge::output {

using Actors = std::vector<vtkSmartPointer<vtkActor>>;

/// Radius of a hinge's dot, in pixels, by its plastic rotation, rad: the area goes with the rotation between 0.01 and
/// 0.2 rad. `unit`: pixels of the largest.
double dot_radius(double rotation, double unit);

/// Pixels that are a share of the bars' typical length, but from `least` to `most`: signs are no larger than the scene
/// has room for.
double sign_size(std::span<const DrawnBar> bars, const Camera& camera, double share, double least, double most);

/// Dots where sections have ever been fully plastic, of whole elements.
Actors hinge_actors(std::span<const DrawnBar> bars, const Camera& camera, double unit);

/// What holds a node.
struct Support {
    /// All is held; the rotations are free; some displacements are free; only rotations are held.
    enum Kind { clamped, pinned, roller, rotations } kind;
    Vec at, towards, x;  ///< m; of unit length: to the side where it stands, and across that
    double section;      ///< m, the larger side of the member's section
};

/// What is held at all nodes out of the plane of a plane model does not count.
std::vector<Support> find_supports(const Snapshot& snapshot, std::span<const DrawnBar> bars, const View& view,
                                   double scale);

/// How large it is drawn, m; at least `least`.
double support_size(const Support& support, double least);

/// Plates, cones, cones on wheels, and cubes.
Actors support_actors(std::span<const Support> supports, const Camera& camera, double least);

/// Where a load acts, as arrows in the scene.
struct Arrow {
    Vec tail, tip;
    bool moment;
    double value;  ///< N, N m, N/m or N m/m
    bool spread, labelled;
};
/// `size`: length of the largest, m.
std::vector<Arrow> load_arrows(const Snapshot& snapshot, std::span<const DrawnBar> bars, double scale, double size);
Actors load_actors(std::span<const Arrow> arrows, const Camera& camera, double em);
void add_words(std::vector<Word>& to, std::span<const Arrow> arrows);

/// The part of a plane under and around the points.
struct GroundPatch {
    Vec origin, x, y, normal;      ///< x and y of unit length
    double low[2], high[2], step;  ///< m, along x and y, and of the grid
    Vec at(double u, double v) const { return origin + u * x + v * y; }
    std::array<Vec, 4> corners() const {
        return {at(low[0], low[1]), at(high[0], low[1]), at(high[0], high[1]), at(low[0], high[1])};
    }
};
GroundPatch ground_under(const Plane& plane, std::span<const Vec> points);
Actors ground_actors(const GroundPatch& patch, const Camera& camera);

}  // namespace hinge::output

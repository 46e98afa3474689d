// Symbols in a scene: plastic hinges, supports, loads and the ground.
#pragma once

#include <span>
#include <vector>

#include <vtkSmartPointer.h>

#include "output/bars.h"
#include "output/words.h"

class vtkActor;

namespace hinge::output {

using Actors = std::vector<vtkSmartPointer<vtkActor>>;

/// Radius of a hinge's dot, pixels, from its plastic rotation, rad: the area is proportional to it from 0.01 to 0.2
/// rad. `unit`: pixels of the largest.
double dot_radius(double rotation, double unit);

/// Size of symbols, pixels: a share of the bars' typical length, from `least` to `most`, so that they fit into the
/// scene.
double sign_size(std::span<const DrawnBar> bars, const Camera& camera, double share, double least, double most);

/// Dots at sections of whole elements that were ever fully plastic.
Actors hinge_actors(std::span<const DrawnBar> bars, const Camera& camera, double unit);

/// Support of a node.
struct Support {
    /// In order: all held; rotations free; some displacements free; only rotations held.
    enum Kind { clamped, pinned, roller, rotations } kind;
    Vec at, towards, x;  ///< m; unit vectors: towards the support, and across that
    double section;      ///< m, the larger side of the member's section
};

/// Finds the supports to draw. Restraints out of the plane, at all nodes of a plane model, do not count.
std::vector<Support> find_supports(const Snapshot& snapshot, std::span<const DrawnBar> bars, const View& view,
                                   double scale);

/// Drawn size of a support, m; at least `least`.
double support_size(const Support& support, double least);

/// Actors of supports: plates, cones, cones on wheels, and cubes.
Actors support_actors(std::span<const Support> supports, const Camera& camera, double least);

/// Arrow of a load in the scene.
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

/// Visible part of a ground plane, under and around the points.
struct GroundPatch {
    Vec origin, x, y, normal;      ///< x and y of unit length
    double low[2], high[2], step;  ///< m, along x and y, and of the grid
    Vec at(double u, double v) const { return origin + u * x + v * y; }
    std::array<Vec, 4> corners() const {
        return {at(low[0], low[1]), at(high[0], low[1]), at(high[0], high[1]), at(low[0], high[1])};
    }
};
/// The largest membrane force of a plate that has not torn, N/m; 0 without plates.
double largest_panel_force(const Snapshot& snapshot);
/// Panels of floors whose corners are all at drawn bars, and plates.
Actors floor_actors(const Snapshot& snapshot, std::span<const DrawnBar> bars, double scale, const Camera& camera);

GroundPatch ground_under(const Plane& plane, std::span<const Vec> points);
Actors ground_actors(const GroundPatch& patch, const Camera& camera);

}  // namespace hinge::output

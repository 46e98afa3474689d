// A triangle mesh, built triangle by triangle, and its actor for a renderer.
#pragma once

#include <vector>

#include <vtkSmartPointer.h>

#include "output/framing.h"
#include "output/colours.h"

class vtkActor;

namespace hinge::output {

/// Triangles and lines relative to `origin`, because single precision is visible far from zero.
class Mesh {
public:
    explicit Mesh(Vec origin) : origin_(origin) {}

    using Index = int;
    Index vertex(Vec p, Vec normal, Colour colour);
    void triangle(Index a, Index b, Index c) { cells_.insert(cells_.end(), {a, b, c}); }
    void line(Index a, Index b) { cells_.insert(cells_.end(), {a, b}); }
    void line(Vec a, Vec b, Colour colour) { line(vertex(a, {}, colour), vertex(b, {}, colour)); }
    /// Adds a flat quadrilateral: four corners in order, one normal.
    void quad(Vec a, Vec b, Vec c, Vec d, Vec normal, Colour colour);
    bool empty() const { return cells_.empty(); }

    vtkSmartPointer<vtkActor> surface() const;
    vtkSmartPointer<vtkActor> lines(double pixels) const;

private:
    vtkSmartPointer<vtkActor> actor(int corners) const;

    Vec origin_;
    std::vector<float> points_, normals_;
    std::vector<std::uint8_t> colours_;
    std::vector<Index> cells_;
};

/// Adds a shape made of triangles. `sides`: of its circles.
void add_box(Mesh& mesh, Vec centre, Vec half_x, Vec half_y, Vec half_z, Colour colour);
void add_cone(Mesh& mesh, Vec tip, Vec foot, double radius, int sides, Colour colour);
void add_rod(Mesh& mesh, Vec a, Vec b, double radius, int sides, Colour colour);
void add_ball(Mesh& mesh, Vec centre, double radius, int sides, Colour colour);

}  // namespace hinge::output

// A triangle mesh, built triangle by triangle, and its actor for a renderer.
#include "output/mesh.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hinge::output {
namespace {

/// A copy in an array of VTK, `parts` values a tuple.
template <class Array, class Value>
vtkSmartPointer<Array> array_of(const std::vector<Value>& values, int parts) {
    auto array = vtkSmartPointer<Array>::New();
    array->SetNumberOfComponents(parts);
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / parts);
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    return array;
}

/// Two directions across a third, of unit length.
std::array<Vec, 2> both_across(Vec along) {
    const Vec u = across(along);
    return {u, cross(unit(along), u)};
}

Vec around(const std::array<Vec, 2>& axes, int i, int sides) {
    const double angle = 2 * std::numbers::pi * i / sides;
    return std::cos(angle) * axes[0] + std::sin(angle) * axes[1];
}

}  // namespace

Mesh::Index Mesh::vertex(Vec p, Vec normal, Colour colour) {
    const Vec q = p - origin_;
    for (int c = 0; c < 3; ++c) {
        points_.push_back(static_cast<float>(q[c]));
        normals_.push_back(static_cast<float>(normal[c]));
        colours_.push_back(colour[c]);
    }
    return static_cast<Index>(points_.size() / 3) - 1;
}

void Mesh::quad(Vec a, Vec b, Vec c, Vec d, Vec normal, Colour colour) {
    const Index i = vertex(a, normal, colour), j = vertex(b, normal, colour), k = vertex(c, normal, colour),
                l = vertex(d, normal, colour);
    triangle(i, j, k);
    triangle(i, k, l);
}

vtkSmartPointer<vtkActor> Mesh::actor(int corners) const {
    const vtkNew<vtkPoints> points;
    points->SetData(array_of<vtkFloatArray>(points_, 3));
    std::vector<std::int32_t> starts;
    for (std::size_t i = 0; i <= cells_.size(); i += static_cast<std::size_t>(corners))
        starts.push_back(static_cast<std::int32_t>(i));
    const vtkNew<vtkCellArray> cells;
    cells->SetData(array_of<vtkTypeInt32Array>(starts, 1), array_of<vtkTypeInt32Array>(cells_, 1));
    const vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    if (corners == 3) {
        data->SetPolys(cells);
        data->GetPointData()->SetNormals(array_of<vtkFloatArray>(normals_, 3));
    } else {
        data->SetLines(cells);
    }
    data->GetPointData()->SetScalars(array_of<vtkUnsignedCharArray>(colours_, 3));
    const vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    auto made = vtkSmartPointer<vtkActor>::New();
    made->SetMapper(mapper);
    made->SetPosition(origin_[0], origin_[1], origin_[2]);
    return made;
}

vtkSmartPointer<vtkActor> Mesh::surface() const { return actor(3); }

vtkSmartPointer<vtkActor> Mesh::lines(double pixels) const {
    auto made = actor(2);
    made->GetProperty()->SetLineWidth(static_cast<float>(pixels));
    made->GetProperty()->LightingOff();
    return made;
}

void add_box(Mesh& mesh, Vec centre, Vec x, Vec y, Vec z, Colour colour) {
    const Vec axes[3] = {x, y, z};
    for (int a = 0; a < 3; ++a)
        for (const double side : {-1.0, 1.0}) {
            const Vec n = side * axes[a], u = axes[(a + 1) % 3], v = side * axes[(a + 2) % 3];
            if (length(n) == 0) continue;
            const Vec m = centre + n;
            mesh.quad(m - u - v, m + u - v, m + u + v, m - u + v, unit(n), colour);
        }
}

void add_cone(Mesh& mesh, Vec tip, Vec foot, double radius, int sides, Colour colour) {
    const Vec along = tip - foot, n = unit(along);
    const auto axes = both_across(along);
    const double slope = radius / length(along);
    for (int i = 0; i < sides; ++i) {
        const Vec p = around(axes, i, sides), q = around(axes, i + 1, sides);
        const Mesh::Index a = mesh.vertex(foot + radius * p, unit(p + slope * n), colour),
                          b = mesh.vertex(foot + radius * q, unit(q + slope * n), colour),
                          c = mesh.vertex(tip, unit(p + q + slope * n), colour);
        mesh.triangle(a, b, c);
        mesh.triangle(mesh.vertex(foot, -1.0 * n, colour), mesh.vertex(foot + radius * q, -1.0 * n, colour),
                      mesh.vertex(foot + radius * p, -1.0 * n, colour));
    }
}

void add_rod(Mesh& mesh, Vec a, Vec b, double radius, int sides, Colour colour) {
    const auto axes = both_across(b - a);
    for (int i = 0; i < sides; ++i) {
        const Vec p = around(axes, i, sides), q = around(axes, i + 1, sides);
        const Mesh::Index k = mesh.vertex(a + radius * p, p, colour), l = mesh.vertex(a + radius * q, q, colour),
                          m = mesh.vertex(b + radius * q, q, colour), n = mesh.vertex(b + radius * p, p, colour);
        mesh.triangle(k, l, m);
        mesh.triangle(k, m, n);
    }
}

void add_ball(Mesh& mesh, Vec centre, double radius, int sides, Colour colour) {
    const int rings = std::max(2, sides / 2);
    const auto at = [&](int ring, int i) {
        const double up = std::numbers::pi * (static_cast<double>(ring) / rings - 0.5);
        const double angle = 2 * std::numbers::pi * i / sides;
        return Vec{std::cos(up) * std::cos(angle), std::cos(up) * std::sin(angle), std::sin(up)};
    };
    std::vector<Mesh::Index> below, now;
    for (int ring = 0; ring <= rings; ++ring) {
        now.clear();
        for (int i = 0; i < sides; ++i) now.push_back(mesh.vertex(centre + radius * at(ring, i), at(ring, i), colour));
        for (int i = 0; ring > 0 && i < sides; ++i) {
            const int next = (i + 1) % sides;
            mesh.triangle(below[static_cast<std::size_t>(i)], below[static_cast<std::size_t>(next)],
                          now[static_cast<std::size_t>(next)]);
            mesh.triangle(below[static_cast<std::size_t>(i)], now[static_cast<std::size_t>(next)],
                          now[static_cast<std::size_t>(i)]);
        }
        std::swap(below, now);
    }
}

}  // namespace hinge::output

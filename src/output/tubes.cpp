// Bars made into shaded tubes, or into plain lines where there are very many.
#include "output/tubes.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hinge::output {
namespace {

constexpr std::size_t few = 200, many = 5000;  // bars; the fewer, the rounder each is drawn
constexpr std::size_t most_tubes = 20000;      // above that lines
constexpr double thinnest = 0.9;               // pixels, radius: thinner bars would break up into dots
constexpr double halo = 1.2;                   // pixels of white around a bar, to tell crossing bars apart
constexpr double haze = 0.18;                  // share of white at the far end of the scene

/// Colour with distance: far bars fade a little towards the paper.
class Haze {
public:
    Haze(const Camera& camera, std::span<const DrawnBar> bars) : camera_(camera) {
        std::vector<double> depths;
        for (const DrawnBar& bar : bars) depths.push_back(depth(bar.a));
        // A few bars need no help to be told apart, and keep the legend's colours.
        if (depths.size() <= few) return;
        // Strays at either end must not use up the range.
        const auto at = [&](double share) {
            const auto i = depths.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(depths.size() - 1));
            std::nth_element(depths.begin(), i, depths.end());
            return *i;
        };
        near_ = at(0.02);
        span_ = std::max(at(0.98) - near_, 1e-9);
    }
    Colour operator()(Vec p, int colour_class) const {
        const Colour& full = class_colours[static_cast<std::size_t>(colour_class)];
        const double white_share = haze * std::clamp((depth(p) - near_) / span_, 0.0, 1.0);
        Colour out;
        for (int c = 0; c < 3; ++c) out[c] = static_cast<std::uint8_t>(full[c] + white_share * (255 - full[c]) + 0.5);
        return out;
    }

private:
    double depth(Vec p) const { return dot(camera_.eye - p, camera_.back); }

    const Camera& camera_;
    double near_ = std::numeric_limits<double>::max(), span_ = 1;
};

/// A surface growing vertex by vertex. Relative to `origin`, because single precision would show far from zero.
class Mesh {
public:
    explicit Mesh(Vec origin) : origin_(origin) {
        normals_->SetName("normals");
        normals_->SetNumberOfComponents(3);
        colours_->SetName("colours");
        colours_->SetNumberOfComponents(3);
    }

    vtkIdType vertex(Vec p, Vec normal, Colour colour) {
        const Vec q = p - origin_;
        normals_->InsertNextTuple3(normal[0], normal[1], normal[2]);
        colours_->InsertNextTypedTuple(colour.data());
        return points_->InsertNextPoint(q.data());
    }
    void triangle(vtkIdType a, vtkIdType b, vtkIdType c) {
        const vtkIdType corners[3] = {a, b, c};
        cells_->InsertNextCell(3, corners);
    }
    void line(vtkIdType a, vtkIdType b) {
        const vtkIdType corners[2] = {a, b};
        cells_->InsertNextCell(2, corners);
    }

    vtkSmartPointer<vtkActor> actor(bool surface) const {
        const vtkNew<vtkPolyData> data;
        data->SetPoints(points_);
        surface ? data->SetPolys(cells_) : data->SetLines(cells_);
        if (surface) data->GetPointData()->SetNormals(normals_);
        data->GetPointData()->SetScalars(colours_);
        const vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(data);
        auto actor = vtkSmartPointer<vtkActor>::New();
        actor->SetMapper(mapper);
        actor->SetPosition(origin_[0], origin_[1], origin_[2]);
        return actor;
    }

private:
    Vec origin_;
    vtkNew<vtkPoints> points_;
    vtkNew<vtkFloatArray> normals_;
    vtkNew<vtkUnsignedCharArray> colours_;
    vtkNew<vtkCellArray> cells_;
};

/// A capsule: its round ends fill the corners where bars meet.
class TubeMaker {
public:
    /// `rings`: circles from an end's widest to its pole, the pole not counted.
    TubeMaker(int sides, int rings) : sides_(sides), rings_(rings) {
        for (int i = 0; i < sides; ++i) {
            const double angle = 2 * std::numbers::pi * i / sides;
            circle_.push_back({std::cos(angle), std::sin(angle)});
        }
    }

    void add(Mesh& mesh, const DrawnBar& bar, double radius, Colour at_a, Colour at_b) const {
        const double span = length(bar.b - bar.a);
        const Vec along = span > 0 ? (1 / span) * (bar.b - bar.a) : Vec{0, 0, 1};
        const Vec side = std::abs(along[2]) < 0.9 ? Vec{0, 0, 1} : Vec{1, 0, 0};
        const Vec across = cross(along, side);
        const Vec u = (1 / length(across)) * across, v = cross(along, u);
        const vtkIdType first = mesh.vertex(bar.a - radius * along, -1.0 * along, at_a) + 1;
        for (int i = rings_ - 1; i >= 0; --i) ring(mesh, bar.a, along, u, v, radius, -latitude(i), at_a);
        for (int i = 0; i < rings_; ++i) ring(mesh, bar.b, along, u, v, radius, latitude(i), at_b);
        const vtkIdType last = mesh.vertex(bar.b + radius * along, along, at_b) - sides_;
        close(mesh, first, first - 1, true);
        for (int band = 0; band < 2 * rings_ - 1; ++band) join(mesh, first + band * sides_);
        close(mesh, last, last + sides_, false);
    }

private:
    double latitude(int i) const { return std::numbers::pi / 2 * i / rings_; }

    void ring(Mesh& mesh, Vec centre, Vec along, Vec u, Vec v, double radius, double angle, Colour colour) const {
        const double out = std::cos(angle), forward = std::sin(angle);
        for (const auto& [c, s] : circle_) {
            const Vec normal = out * (c * u + s * v) + forward * along;
            mesh.vertex(centre + radius * normal, normal, colour);
        }
    }
    void join(Mesh& mesh, vtkIdType first) const {
        for (int i = 0; i < sides_; ++i) {
            const vtkIdType a = first + i, b = first + (i + 1) % sides_;
            mesh.triangle(a, b, b + sides_);
            mesh.triangle(a, b + sides_, a + sides_);
        }
    }
    void close(Mesh& mesh, vtkIdType first, vtkIdType pole, bool backward) const {
        for (int i = 0; i < sides_; ++i) {
            const vtkIdType a = first + i, b = first + (i + 1) % sides_;
            backward ? mesh.triangle(pole, b, a) : mesh.triangle(pole, a, b);
        }
    }

    int sides_, rings_;
    std::vector<std::array<double, 2>> circle_;
};

std::vector<vtkSmartPointer<vtkActor>> make_tubes(std::span<const DrawnBar> bars, const Camera& camera) {
    const std::size_t n = bars.size();
    const TubeMaker tubes = n <= few ? TubeMaker(36, 9) : n <= many ? TubeMaker(12, 2) : TubeMaker(6, 1);
    const Haze haze_of(camera, bars);
    Mesh body(camera.target), edge(camera.target);
    for (const DrawnBar& bar : bars) {
        const double radius = std::max(bar.radius, thinnest * camera.metres_per_pixel);
        tubes.add(body, bar, radius, haze_of(bar.a, bar.colour_class), haze_of(bar.b, bar.colour_class));
        tubes.add(edge, bar, radius + halo * camera.metres_per_pixel, white, white);
    }
    auto solid = body.actor(true);
    solid->GetProperty()->SetAmbient(0.34);
    solid->GetProperty()->SetDiffuse(0.72);
    solid->GetProperty()->SetSpecular(0.12);
    solid->GetProperty()->SetSpecularPower(18);
    // Only the far side of a slightly fatter white tube: it shows as an edge against whatever lies behind.
    auto outline = edge.actor(true);
    outline->GetProperty()->LightingOff();
    outline->GetProperty()->FrontfaceCullingOn();
    return {outline, solid};
}

std::vector<vtkSmartPointer<vtkActor>> make_lines(std::span<const DrawnBar> bars, const Camera& camera) {
    const Haze haze_of(camera, bars);
    Mesh mesh(camera.target);
    double widths = 0;
    for (const DrawnBar& bar : bars) {
        const vtkIdType a = mesh.vertex(bar.a, {}, haze_of(bar.a, bar.colour_class));
        mesh.line(a, mesh.vertex(bar.b, {}, haze_of(bar.b, bar.colour_class)));
        widths += 2 * bar.radius;
    }
    auto actor = mesh.actor(false);
    const double pixels = widths / static_cast<double>(bars.size()) / camera.metres_per_pixel;
    actor->GetProperty()->SetLineWidth(static_cast<float>(std::clamp(pixels, 1.0, 3.0)));
    actor->GetProperty()->LightingOff();
    return {actor};
}

}  // namespace

std::vector<vtkSmartPointer<vtkActor>> make_actors(std::span<const DrawnBar> bars, const Camera& camera) {
    if (bars.empty()) return {};
    return bars.size() <= most_tubes ? make_tubes(bars, camera) : make_lines(bars, camera);
}

}  // namespace hinge::output

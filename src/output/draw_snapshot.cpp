// A snapshot as a picture.
#include "output/draw_snapshot.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>

#include "core/errors.h"
#include "output/bars.h"
#include "output/caption.h"
#include "output/snapshot_check.h"
#include "output/tubes.h"
#include "output/window.h"

namespace hinge::output {
namespace {

std::vector<Vec> corners(const std::array<double, 6>& box) {
    std::vector<Vec> points;
    for (int i = 0; i < 8; ++i) points.push_back({box[i & 1], box[2 + (i >> 1 & 1)], box[4 + (i >> 2 & 1)]});
    for (const Vec& p : points)
        if (!finite(p))
            throw InputError("view.box must be six finite numbers: xmin, xmax, ymin, ymax, zmin, zmax in m");
    return points;
}

/// The median: one absurd width must not push the camera away.
double typical_radius(const std::vector<DrawnBar>& bars) {
    if (bars.empty()) return 0;
    std::vector<double> radii;
    for (const DrawnBar& bar : bars) radii.push_back(bar.radius);
    const auto half = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::nth_element(radii.begin(), half, radii.end());
    return *half;
}

void drop_out_of_sight(std::vector<DrawnBar>& bars, const Camera& camera) {
    const auto far = [&](Vec p) { return length(p - camera.eye) > camera.farthest; };
    std::erase_if(bars, [&](const DrawnBar& bar) { return far(bar.a) || far(bar.b); });
}

void set_camera(vtkRenderer* renderer, const Camera& camera) {
    vtkCamera* to = renderer->GetActiveCamera();
    to->SetPosition(camera.eye.data());
    to->SetFocalPoint(camera.target.data());
    to->SetViewUp(camera.up.data());
    to->SetViewAngle(camera.view_angle);
    to->SetClippingRange(camera.nearest, camera.farthest);
}

/// Light from above the eye's left shoulder, so that columns and beams take different shades.
void set_light(vtkRenderer* renderer) {
    const vtkNew<vtkLight> key;
    key->SetLightTypeToCameraLight();
    key->SetPosition(-0.7, 0.9, 1.6);
    key->SetFocalPoint(0, 0, 0);
    key->SetIntensity(1.0);
    renderer->AutomaticLightCreationOff();
    renderer->AddLight(key);
}

Pixels draw_pixels(const Snapshot& snapshot, const View& view) {
    check_size(view.width, view.height);
    check_snapshot(snapshot);
    std::vector<DrawnBar> bars = choose_bars(snapshot, view);
    const Margins margins = caption_margins(view);
    const int height = std::max(1, view.height - margins.top - margins.bottom);
    const std::vector<Vec> shown = view.box ? corners(*view.box) : without_strays(ends_of(bars));
    const Camera camera = fit_camera(shown, typical_radius(bars), view.from, view.up, view.width, height);
    drop_out_of_sight(bars, camera);

    const auto caption =
        sketch([&](Pen& pen) { draw_caption(pen, view, moment_text(snapshot), camera, bars.empty()); });
    const vtkNew<vtkRenderer> scene;
    scene->SetViewport(0, 1.0 * margins.bottom / view.height, 1, 1 - 1.0 * margins.top / view.height);
    for (const auto& actor : make_actors(bars, camera)) scene->AddActor(actor);
    set_camera(scene, camera);
    set_light(scene);
    vtkRenderer* const layers[] = {caption, scene};
    return take_pixels(view.width, view.height, layers);
}

}  // namespace

std::string draw_snapshot(const Snapshot& snapshot, const View& view) {
    return encode_png(draw_pixels(snapshot, view));
}

std::string draw_strip(int count, const Snapshot* const* snapshots, const View* views, int columns) {
    if (count < 1 || columns < 1) throw InputError("a strip needs at least one still and one column");
    const int rows = (count + columns - 1) / columns, width = views[0].width, height = views[0].height;
    columns = std::min(columns, count);
    check_size(columns * width, rows * height);
    Pixels strip{columns * width, rows * height, {}};
    strip.rgb.assign(3 * std::size_t(strip.width) * strip.height, 255);
    for (int i = 0; i < count; ++i) {
        View view = views[i];
        view.width = width;
        view.height = height;
        const Pixels one = draw_pixels(*snapshots[i], view);
        const int left = i % columns * width, low = (rows - 1 - i / columns) * height;
        for (int y = 0; y < height; ++y)
            std::copy_n(&one.rgb[3 * std::size_t(y) * width], 3 * width,
                        &strip.rgb[3 * (std::size_t(low + y) * strip.width + left)]);
    }
    return encode_png(strip);
}

}  // namespace hinge::output

// Draws a snapshot as a picture.
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
#include "output/diagram.h"
#include "output/members.h"
#include "output/snapshot_check.h"
#include "output/symbols.h"
#include "output/window.h"
#include "output/words.h"

namespace hinge::output {
namespace {

std::vector<Vec> corners(const std::array<double, 6>& box) {
    std::vector<Vec> points;
    points.reserve(8);
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
    radii.reserve(bars.size());
    for (const DrawnBar& bar : bars) radii.push_back(bar.half_size());
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
    to->SetParallelProjection(camera.parallel);
    to->SetParallelScale(camera.metres_per_pixel * camera.height / 2);
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

/// Numbers of nodes and members. Where there is no room for all, the nearest to the eye stay.
void add_numbers(std::vector<Word>& to, const Snapshot& snapshot, const std::vector<DrawnBar>& bars, const View& view,
                 double scale, const Camera& camera) {
    const auto nearness = [&](Vec p) { return -camera.project(p)[2]; };
    if (view.node_labels) {
        std::vector<char> seen(snapshot.points.size(), 0);
        for (const DrawnBar& bar : bars)
            for (const int p : bar.bar->point) {
                if (p >= snapshot.declared || seen[static_cast<std::size_t>(p)]) continue;
                seen[static_cast<std::size_t>(p)] = 1;
                Word w{drawn_at(snapshot, static_cast<std::size_t>(p), scale), std::to_string(p + 1)};
                w.size = 0.85, w.bold = true, w.rank = 1, w.weight = nearness(w.at);
                w.away = Vec{-1, -1, 1};
                to.push_back(w);
            }
    }
    if (view.member_labels) {
        std::vector<std::pair<int, std::size_t>> first;  // a member and its first bar here
        for (std::size_t i = 0; i < bars.size(); ++i) first.push_back({bars[i].bar->member, i});
        std::stable_sort(first.begin(), first.end(), [](auto a, auto b) { return a.first < b.first; });
        for (std::size_t i = 0; i < first.size();) {
            std::size_t end = i;
            while (end < first.size() && first[end].first == first[i].first) ++end;
            const DrawnBar& middle = bars[first[(i + end) / 2].second];
            Word w{(end - i) % 2 == 0 ? middle.a : middle.at(0.5), std::to_string(first[i].first)};
            w.size = 0.85, w.colour = member_number, w.weight = nearness(w.at);
            to.push_back(w);
            i = end;
        }
    }
}

/// The scene of a picture: what is drawn where, and its caption.
class Scene {
public:
    Scene(const Snapshot& snapshot, const View& view)
        : snapshot_(snapshot), view_(view), chosen_(choose_bars(snapshot, view)), bars_(chosen_.list) {
        em_ = text_size(view);
        std::vector<Vec> shown = view.box ? corners(*view.box) : without_strays(ends_of(bars_));
        fit(shown);
        drop_out_of_sight(bars_, camera_);
        const double size = size_of(shown);
        if (view.show >= Show::N) diagram_ = plan_diagram(bars_, view.show, size, view.largest);
        if (view.loads) arrows_ = load_arrows(snapshot, bars_, chosen_.scale, 0.11 * size);
        if (view.ground && !shown.empty())
            for (const Plane& plane : snapshot.ground) ground_.push_back(ground_under(plane, shown));
        if (view.supports) supports_ = find_supports(snapshot, bars_, view, chosen_.scale);
        // What stands beside the members needs room, too.
        if (!view.box) {
            const double least = least_support();
            for (const Support& s : supports_) {
                const double reach = 1.2 * support_size(s, least);
                for (const double side : {-0.7, 0.7}) shown.push_back(s.at + reach * s.towards + side * reach * s.x);
            }
            for (const GroundPatch& g : ground_)
                for (const Vec& p : g.corners()) shown.push_back(p);
            if (diagram_) add_points(shown, bars_, *diagram_);
            for (const Arrow& a : arrows_) shown.push_back(a.tail);
            if (view.ghost) add_start(shown, snapshot, bars_);
            std::erase_if(shown, [](Vec p) { return !finite(p); });
            fit(shown);
        }
        // Dots are of this run alone: they would be read as colours of all runs.
        const bool dots = view.hinges && view.show != Show::nothing && view.show != Show::broken_in;
        if (dots) dot_unit_ = sign_size(bars_, camera_, 0.3, 0.3 * em_, 0.8 * em_);
        add_numbers(words_, snapshot, bars_, view, chosen_.scale, camera_);
        if (shows_diagram()) add_words(words_, bars_, *diagram_, camera_, em_);
        add_words(words_, arrows_);
    }

    Pixels draw() {
        const CaptionInput input = this->caption_input();
        const auto caption = sketch([&](Pen& pen) { draw_caption(pen, input, camera_); });
        const auto words = sketch([&](Pen& pen) { draw_words(pen, words_, camera_, margins_.bottom, em_); });
        std::vector<vtkSmartPointer<vtkRenderer>> layers{caption};
        // The ground lies behind all else: it must not hide supports that reach into it.
        if (!ground_.empty()) {
            Actors actors;
            for (const GroundPatch& g : ground_) append(actors, ground_actors(g, camera_));
            layers.push_back(layer(actors));
        }
        layers.push_back(layer(scene_actors()));
        set_light(layers.back());
        // Members as wide as they are would hide a diagram that stands on their axes.
        if (shows_diagram()) {
            Actors actors = diagram_actors(bars_, *diagram_, camera_, std::max(1.0, em_ / 12));
            append(actors, mark_actors());
            layers.push_back(layer(actors));
            set_light(layers.back());
        }
        // The shape at the start lies over the members, which would hide it.
        if (view_.ghost)
            if (const auto lines = ghost_actor(snapshot_, bars_, camera_, std::max(1.0, em_ / 14)))
                layers.push_back(layer({lines}));
        if (!words_.empty()) layers.push_back(words);
        const std::vector<vtkRenderer*> plain(layers.begin(), layers.end());
        return take_pixels(view_.width, view_.height, plain);
    }

private:
    static void append(Actors& to, const Actors& more) { to.insert(to.end(), more.begin(), more.end()); }
    /// The scene between caption and title.
    vtkSmartPointer<vtkRenderer> layer(const Actors& actors) const {
        auto made = vtkSmartPointer<vtkRenderer>::New();
        made->SetViewport(0, 1.0 * margins_.bottom / view_.height, 1, 1 - 1.0 * margins_.top / view_.height);
        for (const auto& actor : actors) made->AddActor(actor);
        set_camera(made, camera_);
        return made;
    }
    CaptionInput caption_input() const {
        // Pictures with a box are one of several, and those have the same legend.
        const auto any = [&](auto test) {
            return std::any_of(bars_.begin(), bars_.end(), [&](const DrawnBar& b) { return test(*b.bar); });
        };
        const bool series = view_.box.has_value() && any([](const Bar& b) { return b.N0 > 0; });
        const bool joints = view_.box.has_value() && snapshot_.joints;
        const bool hinges =
            series || joints || any([](const Bar& b) { return b.hinges && b.state != BarState::broken; });
        const bool broken = series || any([](const Bar& b) { return b.state == BarState::broken; });
        std::vector<char> groups;
        if (view_.box) groups = groups_of_view(snapshot_, view_);
        else {
            groups.assign(snapshot_.groups.size(), 0);
            for (const DrawnBar& b : bars_)
                if (b.bar->group >= 0) groups[static_cast<std::size_t>(b.bar->group)] = 1;
        }
        return {view_,  snapshot_,     chosen_.scale, diagram_ ? &*diagram_ : nullptr, hinges ? dot_unit_ : 0,
                broken, bars_.empty(), groups};
    }
    void fit(const std::vector<Vec>& shown) {
        margins_ = caption_margins(caption_input());
        const int height = std::max(1, view_.height - margins_.top - margins_.bottom);
        camera_ = fit_camera(shown, typical_radius(bars_), view_.from, view_.up, view_.parallel, view_.width, height);
    }
    double least_support() const { return sign_size(bars_, camera_, 0.2, 0.3 * em_, em_) * camera_.metres_per_pixel; }
    Actors scene_actors() const {
        Actors actors = member_actors(bars_, view_, camera_);
        if (view_.floors) append(actors, floor_actors(snapshot_, bars_, chosen_.scale, camera_));
        append(actors, support_actors(supports_, camera_, least_support()));
        if (!shows_diagram()) append(actors, mark_actors());
        return actors;
    }
    bool shows_diagram() const { return diagram_ && !diagram_->empty(); }
    Actors mark_actors() const {
        Actors actors;
        if (dot_unit_ > 0) append(actors, hinge_actors(bars_, camera_, dot_unit_));
        append(actors, load_actors(arrows_, camera_, em_ * camera_.metres_per_pixel));
        return actors;
    }

    const Snapshot& snapshot_;
    const View& view_;
    DrawnBars chosen_;
    std::vector<DrawnBar>& bars_;
    double em_ = 0, dot_unit_ = 0;
    Camera camera_;
    Margins margins_;
    std::vector<GroundPatch> ground_;
    std::optional<Diagram> diagram_;
    std::vector<Arrow> arrows_;
    std::vector<Support> supports_;
    std::vector<Word> words_;
};

Pixels draw_pixels(const Snapshot& snapshot, const View& view) {
    check_size(view.width, view.height);
    check_snapshot(snapshot);
    return Scene(snapshot, view).draw();
}

}  // namespace

std::string draw_snapshot(const Snapshot& snapshot, const View& view) {
    return encode_png(draw_pixels(snapshot, view));
}

std::string draw_strip(int count, const Snapshot* const* snapshots, const View* views, int columns) {
    if (count < 1 || columns < 1) throw InputError("a strip needs at least one picture and one column");
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

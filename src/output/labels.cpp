// Words beside the points and bars of a panel, where they cover least.
#include "output/labels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hinge::output {
namespace {

struct Label {
    Pixel point;
    double clear;  ///< the radius of the dot there
    std::string words;
    double width, height;
    Box at{};
    double cost = 0;
    bool led = false;     ///< a thin line leads from it to its point
    bool may_go = false;  ///< where it finds no room
};

constexpr double pi = 3.14159265358979323846;

/// The point of a box that is nearest to p.
Pixel nearest(const Box& b, const Pixel& p) {
    return {static_cast<float>(std::clamp<double>(p[0], b.left, b.right)),
            static_cast<float>(std::clamp<double>(p[1], b.bottom, b.top))};
}

double distance(const Box& b, const Pixel& p) {
    const Pixel q = nearest(b, p);
    return std::hypot(q[0] - p[0], q[1] - p[1]);
}

class Placement {
public:
    Placement(const Axes& axes, const Curves& curves, const Box& legend, std::vector<Label> labels)
        : axes_(axes),
          legend_(legend),
          em_(axes.em()),
          labels_(std::move(labels)),
          places_(curves.places(0.5 * em_)),
          dots_(curves.drawn().dots) {
        cells_across_ = std::max(1, static_cast<int>((axes.frame().right - axes.frame().left) / cell()) + 1);
        cells_up_ = std::max(1, static_cast<int>((axes.frame().top - axes.frame().bottom) / cell()) + 1);
        cells_.resize(std::size_t(cells_across_) * cells_up_);
        for (const Pixel& p : places_) ++cells_[cell_at(p[0], p[1])];
    }

    /// Each finds its place after those before it; the later rounds mend what they could not know.
    std::vector<Label> placed() {
        for (int round = 0; round < 4; ++round)
            for (std::size_t i = 0; i < labels_.size(); ++i) place(i, round > 0);
        std::vector<Label> kept;
        for (const bool may_go : {false, true})
            for (const Label& label : labels_)
                if (label.may_go == may_go && (!may_go || finds_room(label, kept))) kept.push_back(label);
        return kept;
    }

private:
    double cell() const { return 0.5 * em_; }
    std::size_t cell_at(double x, double y) const {
        const int i = std::clamp(static_cast<int>((x - axes_.frame().left) / cell()), 0, cells_across_ - 1);
        const int k = std::clamp(static_cast<int>((y - axes_.frame().bottom) / cell()), 0, cells_up_ - 1);
        return std::size_t(k) * cells_across_ + i;
    }

    /// How many cells with something drawn a box covers.
    double drawn_under(const Box& b) const {
        double n = 0;
        for (double y = b.bottom; y < b.top + cell(); y += cell())
            for (double x = b.left; x < b.right + cell(); x += cell())
                n += cells_[cell_at(std::min(x, b.right), std::min(y, b.top))] > 0;
        return n;
    }

    bool finds_room(const Label& label, const std::vector<Label>& kept) const {
        const Box& b = label.at;
        if (outside(b) > 0 || shared_area(b, legend_) > 0) return false;
        for (const Dot& dot : dots_)
            if (b.holds(dot.at[0], dot.at[1], 0.5 * dot.radius)) return false;
        return std::ranges::none_of(kept, [&](const Label& other) { return shared_area(b, other.at) > 0; });
    }

    double outside(const Box& b) const {
        const Box& f = axes_.frame();
        const double right = legend_.left > f.right ? std::min(f.right + em_, legend_.left - 2) : f.right + em_;
        return std::max({0.0, f.left - b.left, b.right - right, f.bottom - b.bottom, b.top - f.top - em_});
    }

    double cost_of(std::size_t i, const Box& b, double away, bool all) const {
        const double area = em_ * em_;
        const double own = distance(b, labels_[i].point);
        double cost = 1.2 * away / em_ + 40 * outside(b) / em_ + 20 * shared_area(b, legend_) / area;
        cost += 0.45 * drawn_under(b);
        for (std::size_t k = 0; k < labels_.size(); ++k) {
            if (k == i) continue;
            const Pixel p = labels_[k].point;
            if (b.holds(p[0], p[1], labels_[k].clear)) cost += 4;
            else if (distance(b, p) < own) cost += 1.5;  // it would seem to be that point's
            if (all || k < i) cost += 12 * shared_area(b, labels_[k].at) / area;
        }
        return cost;
    }

    void place(std::size_t i, bool all) {
        Label& label = labels_[i];
        const double w = label.width, h = label.height;
        bool first = true;
        // To the right, above, ... : the places that readers look at first.
        constexpr std::array<double, 12> turns = {45, 0, 135, 315, 90, 180, 225, 270, 22, 68, 112, 338};
        for (const double away : {0.3, 0.9, 1.7, 2.7, 3.9, 5.3}) {
            for (std::size_t t = 0; t < turns.size(); ++t) {
                const double c = std::cos(turns[t] * pi / 180), s = std::sin(turns[t] * pi / 180);
                const double reach = label.clear + away * em_;
                const double x = label.point[0] + reach * c, y = label.point[1] + reach * s;
                const double left = x - (1 - std::clamp(1.4 * c, -1.0, 1.0)) / 2 * w;
                const double foot = y - (1 - std::clamp(1.4 * s, -1.0, 1.0)) / 2 * h;
                const Box box = {left, foot, left + w, foot + h};
                const double cost = cost_of(i, box, away * em_, all) + 0.04 * static_cast<double>(t);
                if (!first && cost >= label.cost) continue;
                first = false;
                label.at = box;
                label.cost = cost;
                label.led = distance(box, label.point) - label.clear > 0.7 * em_;
            }
        }
    }

    const Axes& axes_;
    Box legend_;
    double em_;
    std::vector<Label> labels_;
    std::vector<Pixel> places_;
    std::vector<Dot> dots_;
    int cells_across_, cells_up_;
    std::vector<int> cells_;  ///< how much is drawn in each cell of the frame
};

void draw_bar_labels(const Axes& axes, const Curves& curves, std::size_t series, TextStyle style) {
    const Series& s = axes.panel().series[series];
    const auto boxes = curves.bars(series);
    for (std::size_t i = 0; i < boxes.size() && i < s.labels.size(); ++i) {
        const Box& b = boxes[i];
        if (b.top <= b.bottom && b.right <= b.left) continue;
        const bool flat = lies(axes.panel()), back = (flat ? s.x[i] : s.y[i]) < 0;
        const double gap = 0.35 * axes.em();
        if (flat) {
            style.across = back ? 1 : 0;
            axes.pen().text(back ? b.left - gap : b.right + gap, (b.bottom + b.top) / 2, s.labels[i], style);
        } else {
            style.across = 0.5;
            style.upright = back ? 1 : 0;
            axes.pen().text((b.left + b.right) / 2, back ? b.bottom - gap / 2 : b.top + gap / 2, s.labels[i], style);
        }
    }
}

}  // namespace

void draw_labels(const Axes& axes, const Curves& curves, const Box& legend) {
    const TextStyle style = {.size = bar_label_size * axes.em()};
    std::vector<Label> labels;
    for (std::size_t k = 0; k < axes.panel().series.size(); ++k) {
        const Series& s = axes.panel().series[k];
        if (s.style == SeriesStyle::bars) {
            draw_bar_labels(axes, curves, k, style);
            continue;
        }
        for (std::size_t i = 0; i < s.labels.size() && i < s.x.size(); ++i) {
            if (s.labels[i].empty() || !drawable(axes.panel(), s, i)) continue;
            const Pixel p = axes.pixel(s.x[i], s.y[i]);
            if (!axes.frame().holds(p[0], p[1], 1)) continue;
            const auto [width, height] = axes.pen().size_of(s.labels[i], style);
            labels.push_back({.point = p,
                              .clear = curves.dot_radius(s),
                              .words = s.labels[i],
                              .width = width,
                              .height = std::max(height, style.size),
                              .may_go = s.faint});
        }
    }
    if (labels.empty()) return;
    const auto placed = Placement(axes, curves, legend, std::move(labels)).placed();
    for (const Label& label : placed)
        if (label.led)
            axes.pen().path({label.point, nearest(label.at, label.point)}, std::max(1.0, axes.em() / 22), faint_ink);
    for (const Label& label : placed) {
        axes.pen().box(label.at.left - 1, label.at.bottom, label.width + 2, label.height, white, 0.7);
        TextStyle own = style;
        if (label.may_go) own.colour = faint_ink;
        axes.pen().text(label.at.left, (label.at.bottom + label.at.top) / 2, label.words, own);
    }
}

}  // namespace hinge::output

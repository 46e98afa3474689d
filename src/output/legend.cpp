// The legend of a panel.
#include <algorithm>
#include <cmath>
#include <limits>

#include "output/labels.h"

namespace hinge::output {

Legend::Legend(const Axes& axes, const Curves& curves)
    : axes_(axes),
      curves_(curves),
      row_(1.45 * axes.em()),
      sample_(2.8 * axes.em()),
      pad_(0.6 * axes.em()),
      style_(axes.label()) {
    const auto& series = axes.panel().series;
    for (std::size_t i = 0; i < series.size(); ++i)
        if (!series[i].name.empty()) listed_.push_back(i);
    if (listed_.empty()) return;
    double widest = 0;
    for (const std::size_t i : listed_) widest = std::max(widest, axes.pen().size_of(series[i].name, style_)[0]);
    width_ = sample_ + 0.6 * axes.em() + widest + 2 * pad_;
    height_ = row_ * static_cast<double>(listed_.size()) + pad_;
}

Box Legend::best_corner(int& hidden) const {
    const double away = 0.8 * axes_.em();
    const Box& f = axes_.frame();
    const std::vector<Pixel> places = curves_.places(axes_.em());
    Box best;
    hidden = std::numeric_limits<int>::max();
    for (const double y : {f.top - height_ - 0.4 * axes_.em(), f.bottom + away})
        for (const double x : {f.right - width_ - away, f.left + away}) {
            const Box box = {x, y, x + width_, y + height_};
            const auto n =
                static_cast<int>(std::ranges::count_if(places, [&](const Pixel& p) { return box.holds(p[0], p[1]); }));
            if (n < hidden) hidden = n, best = box;
        }
    return best;
}

double Legend::room_beside() const {
    if (listed_.empty()) return 0;
    int hidden;
    best_corner(hidden);
    const Box& f = axes_.frame();
    const bool fits = height_ < f.top - f.bottom;
    return (hidden > 3 || !fits) && width_ < 0.45 * (f.right - f.left) ? width_ + 0.4 * axes_.em() : 0;
}

void Legend::place(bool beside) {
    if (listed_.empty()) return;
    int hidden;
    box_ = best_corner(hidden);
    if (!beside) return;
    const double x = axes_.frame().right + 0.6 * axes_.em(), top = axes_.frame().top - 0.4 * axes_.em();
    box_ = {x, top - height_, x + width_, top};
}

void Legend::draw() const {
    if (listed_.empty()) return;
    Pen& pen = axes_.pen();
    pen.box(box_.left, box_.bottom, width_, height_, white, 0.88);
    double middle = box_.top - pad_ / 2 - row_ / 2;
    for (const std::size_t i : listed_) {
        const double from = box_.left + pad_, to = from + sample_;
        curves_.draw_sample(i, from, to, middle);
        pen.text(to + 0.6 * axes_.em(), middle, axes_.panel().series[i].name, style_);
        middle -= row_;
    }
}

}  // namespace hinge::output

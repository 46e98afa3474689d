// The legend of a panel.
#include <algorithm>
#include <cmath>

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
    double widest = 0;
    for (const std::size_t i : listed_) widest = std::max(widest, axes.pen().size_of(series[i].name, style_)[0]);
    entry_ = sample_ + 0.6 * axes.em() + widest;
    width_ = entry_ + 2 * pad_;
    rows_ = listed_.size();
}

double Legend::height() const { return row_ * static_cast<double>(rows_) + pad_; }

/// Whether a box comes near to something drawn.
bool Legend::covers(const Drawn& drawn, const Box& box) const {
    const double near = 0.35 * axes_.em();
    const Box b = {box.left - near, box.bottom - near, box.right + near, box.top + near};
    return std::ranges::any_of(drawn.curves, [&](const auto& curve) { return crosses(curve, b); }) ||
           std::ranges::any_of(drawn.strips, [&](const Strip& strip) { return crosses(strip, b); }) ||
           std::ranges::any_of(drawn.boxes, [&](const Box& other) { return shared_area(b, other) > 0; }) ||
           std::ranges::any_of(drawn.dots, [&](const Dot& dot) { return b.holds(dot.at[0], dot.at[1], dot.radius); });
}

/// The place inside the frame that covers nothing: a corner, else as near to one as there is.
std::optional<Box> Legend::free_place() const {
    struct Candidate {
        double rank;
        Box box;
    };
    const double em = axes_.em(), away = 0.8 * em, high = height();
    const Box& f = axes_.frame();
    const double left = f.left + away, right = f.right - away - width_;
    const double foot = f.bottom + away, head = f.top - 0.4 * em - high;
    if (right < left || head < foot) return {};
    const auto steps = [&](double way) { return std::clamp(static_cast<int>(std::ceil(way / em)), 1, 40); };
    const int across = steps(right - left), up = steps(head - foot);
    std::vector<Candidate> all;
    for (int k = 0; k <= up; ++k)
        for (int i = 0; i <= across; ++i) {
            const double x = right - (right - left) * i / across, y = head - (head - foot) * k / up;
            const double way = std::hypot(std::min(right - x, x - left), std::min(head - y, y - foot)) / em;
            // Of corners that are alike: above right, above left, below right, below left.
            const double corner = (2 * x < left + right ? 0.01 : 0) + (2 * y < foot + head ? 0.02 : 0);
            all.push_back({way + corner, {x, y, x + width_, y + high}});
        }
    const Drawn drawn = curves_.drawn();
    for (Candidate& c : all)  // a line through the panel can be followed under a legend, but better is none
        if (std::ranges::any_of(drawn.lines, [&](const auto& line) { return crosses(line, c.box); })) c.rank += 6;
    std::ranges::stable_sort(all, {}, &Candidate::rank);
    const auto found = std::ranges::find_if(all, [&](const Candidate& c) { return !covers(drawn, c.box); });
    return found == all.end() ? std::nullopt : std::optional(found->box);
}

/// How many entries stand beside each other above the frame.
std::size_t Legend::columns_above() const {
    const double room = axes_.frame().right - axes_.frame().left - 2 * pad_, gap = axes_.em();
    return std::clamp(static_cast<std::size_t>(std::max(0.0, (room + gap) / (entry_ + gap))), std::size_t{1},
                      listed_.size());
}

bool Legend::goes_outside() {
    if (listed_.empty()) return false;
    const Box& f = axes_.frame();
    const Where before = where_;
    const bool fits_beside = width_ < 0.45 * (f.right - f.left) && height() < f.top - f.bottom;
    if (where_ == Where::inside) {
        if (const auto free = free_place()) return box_ = *free, false;
        where_ = fits_beside ? Where::beside : Where::above;
    } else if (where_ == Where::beside) {
        if (height() < f.top - f.bottom) return false;
        where_ = Where::above;
    }
    if (where_ == Where::beside) return true;
    const std::size_t columns = columns_above(), rows = (listed_.size() + columns - 1) / columns;
    const bool other = where_ != before || rows != rows_;
    rows_ = rows;
    return other;
}

double Legend::room_beside() const { return where_ == Where::beside ? width_ + 0.4 * axes_.em() : 0; }
double Legend::room_above() const { return where_ == Where::above ? height() + 0.2 * axes_.em() : 0; }

void Legend::place() {
    if (listed_.empty() || where_ == Where::inside) return;
    const Box& f = axes_.frame();
    if (where_ == Where::beside) {
        const double x = f.right + 0.6 * axes_.em(), top = f.top - 0.4 * axes_.em();
        box_ = {x, top - height(), x + width_, top};
    } else {
        const double foot = f.top + 0.4 * axes_.em() + axes_.room_for_scale();
        box_ = {f.left, foot, f.right, foot + height()};
    }
}

void Legend::draw() const {
    if (listed_.empty()) return;
    Pen& pen = axes_.pen();
    pen.box(box_.left, box_.bottom, box_.right - box_.left, height(), white, 0.88);
    const double room = std::max(axes_.em(), box_.right - box_.left - 2 * pad_ - sample_ - 0.6 * axes_.em());
    for (std::size_t k = 0; k < listed_.size(); ++k) {
        const double middle = box_.top - pad_ / 2 - (0.5 + static_cast<double>(k % rows_)) * row_;
        const double from = box_.left + pad_ + static_cast<double>(k / rows_) * (entry_ + axes_.em());
        curves_.draw_sample(listed_[k], from, from + sample_, middle);
        const Fitted name = fit(pen, axes_.panel().series[listed_[k]].name, style_, 1.01 * room);
        pen.text(from + sample_ + 0.6 * axes_.em(), middle, name.words, name.style);
    }
}

}  // namespace hinge::output

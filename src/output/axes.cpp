// The axes of one panel of a plot: ranges, marks, frame and the words around it.
#include "output/axes.h"

#include <algorithm>
#include <cmath>

namespace hinge::output {
namespace {

constexpr Colour grid = {226, 229, 233};
constexpr double longest_category = 14;  // em

bool has_bars(const Panel& panel) {
    return std::ranges::any_of(panel.series, [](const Series& s) { return s.style == SeriesStyle::bars; });
}

bool has_dots(const Panel& panel) {
    return std::ranges::any_of(panel.series, [](const Series& s) {
        return s.style == SeriesStyle::points || s.style == SeriesStyle::both || !s.labels.empty();
    });
}

bool within(const std::optional<std::array<double, 2>>& range, double v) {
    return !range || (v >= (*range)[0] && v <= (*range)[1]);
}

/// An axis that shows a range: the one given, or what is there with some room.
Axis axis_of(const std::optional<std::array<double, 2>>& range, Range extent, bool log, double padding, int wanted) {
    if (range) return make_fixed_axis((*range)[0], (*range)[1], log, wanted);
    if (extent.any()) return make_axis(extent.low, extent.high, log, padding, wanted);
    Axis empty;
    empty.log = log;
    empty.low = log ? 0.1 : 0;
    return empty;
}

}  // namespace

bool drawable(const Panel& panel, const Series& s, std::size_t i) {
    const auto good = [](double v, bool log) { return std::isfinite(v) && (!log || v > 0); };
    if (s.style == SeriesStyle::band)  // its lower edge may lie beneath a logarithmic axis
        return good(s.x[i], panel.log_x) && std::isfinite(s.y[i]) && good(s.high[i], panel.log_y);
    return good(s.x[i], panel.log_x) && good(s.y[i], panel.log_y);
}

double bar_spacing(const Panel& panel) {
    if (!panel.x_categories.empty() || !panel.y_categories.empty()) return 1;
    std::vector<double> places;
    for (const Series& s : panel.series)
        if (s.style == SeriesStyle::bars)
            for (std::size_t i = 0; i < s.x.size(); ++i)
                if (drawable(panel, s, i)) places.push_back(s.x[i]);
    std::ranges::sort(places);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
        if (places[i + 1] > places[i]) least = std::min(least, places[i + 1] - places[i]);
    return std::isfinite(least) ? least : 1;
}

Range x_extent(const Panel& panel) {
    Range extent;
    const double half = has_bars(panel) && !lies(panel) ? bar_spacing(panel) / 2 : 0;
    for (const Series& s : panel.series) {
        const double reach = s.style == SeriesStyle::bars ? half : 0;
        for (std::size_t i = 0; i < s.x.size(); ++i) {
            if (!drawable(panel, s, i) || !within(panel.y_range, s.y[i])) continue;
            extent.add(s.x[i] - reach);
            extent.add(s.x[i] + reach);
        }
        if (s.style == SeriesStyle::bars && lies(panel) && !panel.log_x) extent.add(0);
    }
    for (const ReferenceLine& line : panel.lines)
        if (line.upright && extent.any()) extent.add(line.at);
    return extent;
}

Fitted fit(Pen& pen, std::string words, TextStyle style, double room) {
    const double wide = pen.size_of(words, style)[0];
    if (wide <= room) return {std::move(words), style};
    style.size *= std::max(0.7, room / wide);
    const std::string dots = "\xE2\x80\xA6";
    if (pen.size_of(words, style)[0] <= 1.02 * room) return {std::move(words), style};
    while (words.size() > 1 && pen.size_of(words + dots, style)[0] > room) {
        while (words.size() > 1 && (static_cast<unsigned char>(words.back()) & 0xC0) == 0x80) words.pop_back();
        words.pop_back();
    }
    return {words + dots, style};
}

Axes::Axes(Pen& pen, const Panel& panel, double em, double width, double height, Range extent, bool words_below)
    : pen_(pen), panel_(panel), em_(em), words_below_(words_below), label_{.size = 0.92 * em} {
    set_ranges(width, height, extent);
    set_margins();
}

Range Axes::y_extent() const {
    Range extent;
    for (const bool all : {false, true}) {  // what the x axis shows, or all where it shows nothing
        for (const Series& s : panel_.series) {
            for (std::size_t i = 0; i < s.x.size(); ++i) {
                if (!drawable(panel_, s, i) || !(all || within(panel_.x_range, s.x[i]))) continue;
                if (!panel_.log_y || s.y[i] > 0) extent.add(s.y[i]);
                if (s.style == SeriesStyle::band) extent.add(s.high[i]);
            }
            if (s.style == SeriesStyle::bars && !lies(panel_) && !panel_.log_y) extent.add(0);
        }
        for (const ReferenceLine& line : panel_.lines)
            if (!line.upright && extent.any()) extent.add(line.at);
        if (extent.any()) break;
    }
    return extent;
}

/// The share of the width that the labels behind bars that lie need at each end.
double Axes::room_for_bar_labels(double width) const {
    const TextStyle style = {.size = bar_label_size * em_};
    double widest = 0;
    for (const Series& s : panel_.series)
        if (s.style == SeriesStyle::bars)
            for (const std::string& label : s.labels) widest = std::max(widest, pen_.size_of(label, style)[0] + em_);
    const double share = widest / std::max(0.6 * width, em_);
    return std::clamp(share / std::max(1 - 2 * share, 0.3), 0.04, 0.5);
}

void Axes::set_ranges(double width, double height, Range extent) {
    // Curves may run edge to edge; dots and the bars' ends must not be cut by the frame.
    const bool dots = has_dots(panel_);
    x_ = panel_.x_categories.empty() ? axis_of(panel_.x_range, extent, panel_.log_x,
                                               lies(panel_) ? room_for_bar_labels(width)
                                               : dots       ? 0.04
                                                            : 0,
                                               std::clamp(static_cast<int>(width / (8 * em_)), 2, 9))
                                     : make_category_axis(panel_.x_categories, false);
    y_ = panel_.y_categories.empty() ? axis_of(panel_.y_range, y_extent(), panel_.log_y, 0.06,
                                               std::clamp(static_cast<int>(height / (3.2 * em_)), 2, 8))
                                     : make_category_axis(panel_.y_categories, true);
    // Categories that do not fit beside each other are written upwards.
    if (!panel_.x_categories.empty()) {
        const double slot = (width - 6 * em_) / static_cast<double>(panel_.x_categories.size());
        turned_ = widest(x_) > slot - 0.5 * em_;
    }
    category_room_ = std::min(longest_category * em_, 0.45 * (lies(panel_) ? width : height));
}

double Axes::widest(const Axis& axis) const {
    double most = 0;
    for (const Tick& tick : axis.ticks) {
        TextStyle style = label_;
        style.power = tick.power;
        most = std::max(most, pen_.size_of(tick.label, style)[0]);
    }
    return most;
}

void Axes::set_margins() {
    const double numbers = lies(panel_) ? std::min(widest(y_), category_room_) : widest(y_);
    margins_.left = 1.2 * em_ + (panel_.y_label.empty() ? 0 : 1.9 * em_) + numbers + 0.6 * em_;
    margins_.right = 2 * em_;
    margins_.bottom = !words_below_ ? 0.9 * em_
                                    : (turned_ ? 1.4 * em_ + std::min(widest(x_), category_room_) : 2.4 * em_) +
                                          (panel_.x_label.empty() ? 0 : 1.7 * em_);
    margins_.top = (panel_.title.empty() ? 1.2 : 2.5) * em_ + room_for_scale();
}

void Axes::set_frame(const Box& frame, double left) {
    margins_.left = left;
    frame_ = {std::round(frame.left), std::round(frame.bottom), std::round(frame.right), std::round(frame.top)};
}

Pixel Axes::pixel(double x, double y) const {
    const auto share = [](const Axis& axis, double v) {
        return std::clamp(axis.log && v <= 0 ? -1e4 : axis.share(v), -1e4, 1e4);
    };
    return {static_cast<float>(frame_.left + share(x_, x) * (frame_.right - frame_.left)),
            static_cast<float>(frame_.bottom + share(y_, y) * (frame_.top - frame_.bottom))};
}

void Axes::tick_text(double x, double y, const Tick& tick, TextStyle style, double room) const {
    style.size = label_.size;
    style.power = tick.power;
    const Fitted fitted = fit(pen_, tick.label, style, room);
    pen_.text(x, y, fitted.words, fitted.style);
}

void Axes::draw_grid() const {
    for (const Tick& tick : x_.ticks) {
        const double x = std::round(pixel(tick.at, y_.low)[0]);
        if (!tick.label.empty() && panel_.x_categories.empty()) pen_.line(x, frame_.bottom, x, frame_.top, 1, grid);
    }
    for (const Tick& tick : y_.ticks) {
        const double y = std::round(pixel(x_.low, tick.at)[1]);
        if (!tick.label.empty() && panel_.y_categories.empty()) pen_.line(frame_.left, y, frame_.right, y, 1, grid);
    }
}

void Axes::draw_frame() const {
    const double line = std::max(1.0, em_ / 16);
    const auto reach = [&](const Tick& tick) { return (tick.label.empty() ? 0.2 : 0.38) * em_; };
    pen_.line(frame_.left, frame_.bottom, frame_.right, frame_.bottom, line, ink);
    pen_.line(frame_.left, frame_.bottom, frame_.left, frame_.top, line, ink);
    for (const Tick& tick : x_.ticks) {
        const double x = std::round(pixel(tick.at, y_.low)[0]);
        pen_.line(x, frame_.bottom, x, frame_.bottom - reach(tick), line, ink);
        if (!words_below_) continue;
        if (turned_) tick_text(x, frame_.bottom - 0.6 * em_, tick, {.across = 1, .upwards = true}, category_room_);
        else tick_text(x, frame_.bottom - 0.6 * em_, tick, {.across = 0.5, .upright = 1});
    }
    for (const Tick& tick : y_.ticks) {
        const double y = std::round(pixel(x_.low, tick.at)[1]);
        pen_.line(frame_.left, y, frame_.left - reach(tick), y, line, ink);
        tick_text(frame_.left - 0.6 * em_, y, tick, {.across = 1}, lies(panel_) ? category_room_ : unbounded);
    }
    const std::string times =
        "\xC3\x97"
        "10";
    if (!y_.scale.empty()) tick_text(frame_.left, frame_.top + 0.9 * em_, {0, times, y_.scale}, {});
    if (!x_.scale.empty() && words_below_)
        tick_text(frame_.right, frame_.bottom - 2.1 * em_, {0, times, x_.scale}, {.across = 1, .upright = 1});
}

void Axes::draw_words(double above) const {
    const double middle = (frame_.left + frame_.right) / 2, width = frame_.right - frame_.left + margins_.right;
    const auto put = [&](double x, double y, const std::string& words, TextStyle style, double room) {
        const Fitted fitted = fit(pen_, words, style, room);
        pen_.text(x, y, fitted.words, fitted.style);
    };
    put(middle, frame_.top + margins_.top + above - 1.2 * em_, panel_.title,
        {.size = 1.1 * em_, .bold = true, .across = 0.5}, width);
    if (words_below_)
        put(middle, frame_.bottom - margins_.bottom + 1.5 * em_, panel_.x_label, {.size = em_, .across = 0.5},
            width - (x_.scale.empty() ? 0 : 8 * em_));
    put(frame_.left - margins_.left + 1.5 * em_, (frame_.bottom + frame_.top) / 2, panel_.y_label,
        {.size = em_, .across = 0.5, .upwards = true}, frame_.top - frame_.bottom + margins_.bottom);
}

}  // namespace hinge::output

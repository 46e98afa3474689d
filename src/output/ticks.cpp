// Where an axis has its marks, and what stands beside them.
#include "output/ticks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace hinge::output {
namespace {

/// The round number 1, 2 or 5 times a power of ten nearest above `rough`, or a little below it.
double round_step(double rough) {
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (rough <= digit * power * 1.25) return digit * power;
    return 10 * power;
}

std::string fixed(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    if (std::string(text).find_first_not_of("-0.") == std::string::npos && text[0] == '-') return text + 1;
    // A true minus is as wide as a plus; the hyphen gets lost beside digits.
    return text[0] == '-' ? "\xE2\x88\x92" + std::string(text + 1) : text;
}

std::string signed_power(int power) { return fixed(power, 0); }

void linear_ticks(Axis& axis, int wanted) {
    const double step = round_step((axis.high - axis.low) / std::max(wanted, 2));
    const double largest = std::max(std::abs(axis.low), std::abs(axis.high));
    // Many zeros before or after the point go into one factor for all labels.
    const int magnitude = static_cast<int>(std::floor(std::log10(largest)));
    const int power = magnitude >= 5 || magnitude <= -4 ? magnitude - ((magnitude % 3) + 3) % 3 : 0;
    const double factor = std::pow(10.0, power);
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step / factor) - 1e-6)), 0, 12);
    if (power != 0) axis.scale = signed_power(power);
    const double slack = 1e-6 * step;
    // Counted, not summed: sums drift off the round values.
    for (double i = std::ceil((axis.low - slack) / step); i * step <= axis.high + slack; ++i)
        axis.ticks.push_back({i * step, fixed(i * step / factor, decimals), ""});
}

void log_ticks(Axis& axis, int wanted) {
    const int first = static_cast<int>(std::floor(std::log10(axis.low)));
    const int last = static_cast<int>(std::ceil(std::log10(axis.high)));
    const double decades = std::log10(axis.high / axis.low);
    const bool plain = decades < 2 && axis.low >= 9e-4 && axis.high <= 1.1e4;  // 2, 5, 10 read better than powers
    const int stride = std::max(1, static_cast<int>(std::ceil(decades / std::max(wanted, 2))));
    for (int power = first; power <= last; ++power) {
        for (int digit = 1; digit < 10; ++digit) {
            Tick tick{digit * std::pow(10.0, power), "", ""};
            if (!axis.shows(tick.at)) continue;
            const bool labelled = digit == 1 ? power % stride == 0 : decades < 2 && (digit == 2 || digit == 5);
            if (digit > 1 && stride > 1) continue;
            if (labelled && plain) {
                tick.label = fixed(tick.at, std::max(0, -power));
            } else if (labelled) {
                tick.label = digit == 1 ? "10"
                                        : std::to_string(digit) +
                                              "\xC2\xB7"
                                              "10";
                tick.power = signed_power(power);
            }
            axis.ticks.push_back(tick);
        }
    }
}

}  // namespace

double Axis::share(double value) const {
    return log ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

bool Axis::shows(double value) const {
    const double s = share(value);
    return s >= -1e-9 && s <= 1 + 1e-9;
}

Axis make_fixed_axis(double low, double high, bool log, int wanted) {
    Axis axis;
    axis.log = log;
    axis.low = low;
    axis.high = high;
    if (log) {
        log_ticks(axis, wanted);
        // Within a decade there may be no round number of the 1, 2, 5 kind to label.
        if (std::ranges::count_if(axis.ticks, [](const Tick& tick) { return !tick.label.empty(); }) >= 2) return axis;
        axis.ticks.clear();
    }
    linear_ticks(axis, wanted);
    return axis;
}

Axis make_axis(double low, double high, bool log, double padding, int wanted) {
    if (log) {
        if (high / low < 1.01) {
            low /= 2;
            high *= 2;
        }
        const double factor = std::pow(high / low, padding);
        return make_fixed_axis(low / factor, high * factor, true, wanted);
    }
    const double largest = std::max(std::abs(low), std::abs(high));
    // A constant: room around it, in proportion to its size.
    if (high - low <= 1e-9 * largest || high == low) {
        const double room = largest > 0 ? 0.1 * largest : 1;
        low -= room;
        high += room;
    }
    const double range = high - low;
    // Nothing is drawn below zero just to leave room.
    const bool from_zero = low >= 0 && low < 0.15 * range;
    const double first = from_zero ? 0 : low - padding * range;
    return make_fixed_axis(first, high <= 0 && -high < 0.15 * range ? 0 : high + padding * range, false, wanted);
}

Axis make_category_axis(const std::vector<std::string>& categories, bool downwards) {
    Axis axis;
    axis.low = 0.5;
    axis.high = static_cast<double>(categories.size()) + 0.5;
    if (downwards) std::swap(axis.low, axis.high);
    for (std::size_t i = 0; i < categories.size(); ++i)
        axis.ticks.push_back({static_cast<double>(i + 1), categories[i], ""});
    return axis;
}

}  // namespace hinge::output

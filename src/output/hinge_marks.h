// Hinges compared with limits, encoded for pictures in the unused bits of Bar::hinges.
#pragma once

#include <algorithm>
#include <cstdint>

#include "output/colours.h"
#include "output/picture.h"

namespace hinge::output {

/// Bit of a snapshot with limits: if a bar has it, only hinges with a limit have dots, and Bar::rotation is rotation
/// over limit.
constexpr std::uint8_t hinges_compared = 128;
/// Number of bands. Band 0: no limit; 1: up to half of it; 2: up to it; 3: beyond.
constexpr int hinge_bands = 3;
constexpr const char* hinge_band_names[hinge_bands] = {"to half", "to the limit", "beyond"};
constexpr double most_of_limit = 2;  ///< of the largest dot

constexpr int band_of(double of_limit) { return of_limit <= 0.5 ? 1 : of_limit <= 1 ? 2 : 3; }
constexpr std::uint8_t band_bits(int end, int band) { return std::uint8_t(band << (end == 2 ? 5 : 3)); }
constexpr int band_at(const Bar& bar, int end) { return bar.hinges >> (end == 2 ? 5 : 3) & 3; }
constexpr Colour band_colour(int band) {
    constexpr int classes[hinge_bands] = {1, 3, plastic_class};
    return class_colours[static_cast<std::size_t>(classes[band - 1])];
}
inline bool is_compared(const Snapshot& snapshot) {
    return std::any_of(snapshot.bars.begin(), snapshot.bars.end(),
                       [](const Bar& bar) { return (bar.hinges & hinges_compared) != 0; });
}

}  // namespace hinge::output

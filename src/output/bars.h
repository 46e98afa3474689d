// The bars a view shows: chosen and sorted into colours.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "output/framing.h"
#include "output/picture.h"
#include "output/sketch.h"

namespace hinge::output {

/// Colour classes: 0 to 4 are f_y in fifths, then a plastic hinge, then a fractured bar (paper, fig 17).
constexpr int hinge_class = 5, broken_class = 6, n_classes = 7;
extern const std::array<Colour, n_classes> class_colours;

struct DrawnBar {
    Vec a, b;
    double radius;
    int colour_class;
};

/// The bars of `still` that `view` asks for, without those whose ends are not finite.
std::vector<DrawnBar> choose_bars(const Snapshot& snapshot, const View& view);

std::vector<Vec> ends_of(std::span<const DrawnBar> bars);

}  // namespace hinge::output

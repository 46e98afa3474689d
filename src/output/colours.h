// The colours of pictures. Any two that represent f_y, and the black of broken elements, can be told apart by readers
// with normal sight, protanopia, deuteranopia and tritanopia: in CIE L*a*b* they are at least 20 apart in each, with
// the matrices of Machado, Oliveira and Fernandes (2009). tests/unit/colours_test.cpp computes that. The page of `hinge
// report` has the same colours (src/viewer/src/colouring.js).
#pragma once

#include <array>
#include <cstdint>

namespace hinge::output {

using Colour = std::array<std::uint8_t, 3>;

constexpr Colour ink = {34, 38, 44}, faint_ink = {110, 116, 124}, white = {255, 255, 255};

/// Colour classes: 0 to 4 are f_y in fifths, 5 is f_y = 1, a fully plastic section; then a broken element.
constexpr int plastic_class = 5, broken_class = 6, n_classes = 7;
constexpr std::array<Colour, n_classes> class_colours = {
    {{40, 66, 140}, {70, 136, 200}, {150, 212, 226}, {250, 214, 80}, {236, 126, 44}, {172, 20, 44}, {10, 10, 12}}};

/// Colours of groups, in their order; they repeat.
constexpr Colour group_colours[] = {{31, 119, 180}, {224, 134, 45},  {63, 155, 79},   {178, 58, 72},  {123, 94, 167},
                                    {140, 109, 77}, {208, 118, 171}, {127, 135, 144}, {166, 168, 50}, {42, 166, 181}};

/// Colours of members by the number of runs in which they broke, light to dark; the last is that of a broken element.
/// They can be told apart in grey, too: the lightness of any two differs by 15 or more (CIE L*).
constexpr int n_shares = 4;
constexpr std::array<Colour, n_shares> share_colours = {
    {{196, 202, 208}, {230, 132, 44}, {194, 48, 44}, class_colours[broken_class]}};

/// Colour class of what happened in `count` of several runs: 0 in none, 1 in fewer than half, 2 in half or more, 3 in
/// all.
constexpr int share_class(int count, int runs) { return count <= 0 ? 0 : count >= runs ? 3 : 2 * count < runs ? 1 : 2; }

constexpr Colour plain_bar = {168, 175, 184};  ///< members whose colour has no meaning
constexpr Colour member_number = {96, 102, 110};
constexpr Colour ghost_colour = {124, 130, 138};
constexpr Colour support_colour = {84, 92, 102};
constexpr Colour ground_fill = {243, 242, 238}, ground_line = {214, 212, 204};
constexpr Colour floor_fill = {104, 150, 186}, floor_edge = {150, 174, 196};
/// Plates by the larger of their principal forces: tension and compression, from what has none. Only the darkest two
/// are as far apart as the colours of f_y; the caption says which is which.
constexpr Colour panel_idle = {238, 240, 242}, panel_tension = {24, 96, 176}, panel_compression = {206, 92, 20};
constexpr Colour load_colour = {128, 44, 140};
constexpr Colour diagram_axis = {96, 102, 110};                          ///< the members' axes, base lines of diagrams
constexpr Colour plus_fill = {158, 200, 236}, plus_line = {0, 90, 160};  ///< a diagram above zero
constexpr Colour minus_fill = {250, 196, 150}, minus_line = {190, 72, 0};  ///< and below

}  // namespace hinge::output

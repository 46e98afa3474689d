// Labels at points of a scene: numbers of nodes and members, values of diagrams and loads.
#pragma once

#include <string>
#include <vector>

#include "output/framing.h"
#include "output/sketch.h"

namespace hinge::output {

struct Word {
    Vec at;  ///< its point, m
    std::string text;
    Colour colour = ink;
    double size = 1;       ///< times the size of plain text
    int rank = 0;          ///< where there is no room for all, those of high rank stay,
    double weight = 0;     ///< and among them those of large weight
    Vec away = {0, 0, 0};  ///< in the scene: direction from the point to the label; zero: on it
    bool bold = false;
};

/// Draws labels that do not cover each other; labels without room are left out. `low`: pixels below the scene. Returns
/// the number left out.
int draw_words(Pen& pen, const std::vector<Word>& words, const Camera& camera, double low, double em);

/// Text of a number with few digits: "43.9", "-0.0126".
std::string short_number(double value);

/// Display unit of numbers of this size: "kN" for largest = 4.39e4 and unit "N", and its divisor.
struct Unit {
    double size;
    std::string name;
};
Unit unit_for(double largest, const std::string& unit);

}  // namespace hinge::output

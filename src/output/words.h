// Words that stand at points of a scene: numbers of nodes and members, values of diagrams and loads.
#pragma once

#include <string>
#include <vector>

#include "output/framing.h"
#include "output/sketch.h"

namespace hinge::output {

struct Word {
    Vec at;  ///< where it belongs, m
    std::string text;
    Colour colour = ink;
    double size = 1;       ///< times the size of plain text
    int rank = 0;          ///< where there is no room for all, those of high rank stay,
    double weight = 0;     ///< and among them those of large weight
    Vec away = {0, 0, 0};  ///< in the scene: to which side of the point it stands; zero: on it
    bool bold = false;
};

/// Draws them where they do not cover each other; what has no room is left out. `low`: pixels below the scene.
/// Returns how many are left out.
int draw_words(Pen& pen, const std::vector<Word>& words, const Camera& camera, double low, double em);

/// A number with few digits: "43.9", "-0.0126".
std::string short_number(double value);

/// How numbers of this size are written: "kN" for largest = 4.39e4 and unit "N", and what they are divided by.
struct Unit {
    double size;
    std::string name;
};
Unit unit_for(double largest, const std::string& unit);

}  // namespace hinge::output

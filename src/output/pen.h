// Interface for two-dimensional drawing: text, lines and boxes in pixels from the lower left corner.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "output/colours.h"

namespace hinge::output {

using Pixel = std::array<float, 2>;

struct TextStyle {
    double size = 16;  ///< pixels
    Colour colour = ink;
    bool bold = false, italic = false;
    double across = 0;     ///< position of the given point in the text: 0 left, 0.5 middle, 1 right
    double upright = 0.5;  ///< 0 foot, 0.5 middle, 1 top
};

class Pen {
public:
    virtual ~Pen() = default;

    virtual void text(double x, double y, const std::string& words, const TextStyle& style) = 0;
    /// Width and height in pixels of words.
    virtual std::array<double, 2> size_of(const std::string& words, const TextStyle& style) = 0;
    virtual void path(const std::vector<Pixel>& points, double width, Colour colour) = 0;
    /// Draws a box aligned with whole pixels.
    virtual void box(double x, double y, double width, double height, Colour colour, double opacity = 1) = 0;
    virtual void dot(double x, double y, double radius, Colour colour) = 0;
    /// Draws a line. Horizontal and vertical ones are aligned with pixels, to be sharp.
    void line(double x0, double y0, double x1, double y1, double width, Colour colour);
};

}  // namespace hinge::output

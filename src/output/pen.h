// What flat drawings are drawn with: text, lines and boxes in pixels from the lower left corner.
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
    double across = 0;     ///< where the given point lies in the text: 0 left, 0.5 middle, 1 right
    double upright = 0.5;  ///< 0 foot, 0.5 middle, 1 top
    bool upwards = false;  ///< rotated to be read from the right
    std::string power{};   ///< smaller and higher, behind the words
};

/// How long the dashes of a curve and the gaps between them are, pixels; 0: none.
struct Dashes {
    double on = 0, off = 0;
};

class Pen {
public:
    virtual ~Pen() = default;

    virtual void text(double x, double y, const std::string& words, const TextStyle& style) = 0;
    /// Width and height in pixels of words that are not rotated.
    virtual std::array<double, 2> size_of(const std::string& words, const TextStyle& style) = 0;
    virtual void path(const std::vector<Pixel>& points, double width, Colour colour, Dashes dashes = {}) = 0;
    /// Laid on whole pixels.
    virtual void box(double x, double y, double width, double height, Colour colour, double opacity = 1) = 0;
    virtual void dot(double x, double y, double radius, Colour colour) = 0;
    /// What lies between two curves of as many points.
    virtual void strip(const std::vector<Pixel>& low, const std::vector<Pixel>& high, Colour colour,
                       double opacity) = 0;

    /// Level and upright lines are laid on whole pixels, to be sharp.
    void line(double x0, double y0, double x1, double y1, double width, Colour colour);
};

/// How large the power behind a text is, and how far its middle lies above that of the text, in its size.
inline constexpr double power_size = 0.7, power_height = 0.4;

}  // namespace hinge::output

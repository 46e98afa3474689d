// Flat drawing over a whole picture: text, lines and boxes in pixels from the lower left corner.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <vtkSmartPointer.h>

class vtkContext2D;
class vtkRenderer;

namespace hinge::output {

using Colour = std::array<std::uint8_t, 3>;

constexpr Colour ink = {34, 38, 44}, faint_ink = {110, 116, 124}, white = {255, 255, 255};

struct TextStyle {
    double size = 16;  ///< pixels
    Colour colour = ink;
    bool bold = false, italic = false;
    double across = 0;     ///< where the given point lies in the text: 0 left, 0.5 middle, 1 right
    double upright = 0.5;  ///< 0 foot, 0.5 middle, 1 top
    bool upwards = false;  ///< rotated to be read from the right
};

/// What a drawing function draws with.
class Pen {
public:
    explicit Pen(vtkContext2D& context) : context_(context) {}

    void text(double x, double y, const std::string& words, const TextStyle& style);
    /// Width and height in pixels.
    std::array<double, 2> size_of(const std::string& words, const TextStyle& style);
    /// Level and upright lines are laid on whole pixels, to be sharp.
    void line(double x0, double y0, double x1, double y1, double width, Colour colour);
    void path(const std::vector<std::array<float, 2>>& points, double width, Colour colour);
    /// Laid on whole pixels.
    void box(double x, double y, double width, double height, Colour colour, double opacity = 1);
    void dot(double x, double y, double radius, Colour colour);

private:
    vtkContext2D& context_;
};

/// A renderer that fills the picture with what `draw` draws.
vtkSmartPointer<vtkRenderer> sketch(std::function<void(Pen&)> draw);

}  // namespace hinge::output

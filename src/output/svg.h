// A pen that writes SVG: no display is needed, and words stay words.
#pragma once

#include <string>

#include "output/pen.h"

namespace hinge::output {

/// Text as it may stand in XML: markup escaped, what is no character of XML replaced.
std::string escaped(const std::string& text);

class SvgPen : public Pen {
public:
    SvgPen(int width, int height, const std::string& title);

    void text(double x, double y, const std::string& words, const TextStyle& style) override;
    std::array<double, 2> size_of(const std::string& words, const TextStyle& style) override;
    void path(const std::vector<Pixel>& points, double width, Colour colour, Dashes dashes) override;
    void box(double x, double y, double width, double height, Colour colour, double opacity) override;
    void dot(double x, double y, double radius, Colour colour) override;
    void strip(const std::vector<Pixel>& low, const std::vector<Pixel>& high, Colour colour, double opacity) override;

    /// The whole file.
    std::string file() const { return out_ + "</svg>\n"; }

private:
    double height_;  // SVG counts downwards
    std::string out_;
};

}  // namespace hinge::output

// What the tests of plots share: a plot as the text of its SVG, and what stands where in that.
#pragma once

#include <limits>
#include <regex>
#include <sstream>

#include "output_parts.h"

namespace hinge::output::test {

inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

inline hinge_plot plot_function() { return load<hinge_plot>("hinge_plot"); }

/// A file of a folder that is gone with it.
class File {
public:
    explicit File(const std::string& end) : path_(folder_ / ("a" + end)) {}
    const char* path() const { return path_.c_str(); }

private:
    Folder folder_;
    std::string path_;
};

inline std::string drawn(const Plot& plot, int width = 800, int height = 600) {
    const Folder folder;
    REQUIRE(test::plot(folder / "a.svg", plot, width, height) == "");
    return contents(folder / "a.svg");
}

inline Plot plot_of(std::vector<Series> series) {
    Plot plot;
    plot.panels.resize(1);
    plot.panels[0].series = std::move(series);
    return plot;
}

struct Point {
    double x, y;
};

/// The points of each polyline or polygon.
inline std::vector<std::vector<Point>> shapes(const std::string& svg, const std::string& tag) {
    std::vector<std::vector<Point>> all;
    for (std::size_t at = 0; (at = svg.find("<" + tag + " ", at)) != std::string::npos;) {
        at = svg.find(" points=\"", at) + 9;
        std::istringstream points(svg.substr(at, svg.find('"', at) - at));
        all.emplace_back();
        char comma;
        for (Point p; points >> p.x >> comma >> p.y;) all.back().push_back(p);
    }
    return all;
}

inline double attribute(const std::string& element, const std::string& name) {
    std::smatch match;
    REQUIRE(std::regex_search(element, match, std::regex(" " + name + "=\"(-?[0-9.]+)\"")));
    return std::stod(match[1]);
}

/// The element whose text is `words`.
inline std::string text_element(const std::string& svg, const std::string& words) {
    const std::regex element("<text ([^>]*)>([^<]*)");
    for (std::sregex_iterator i(svg.begin(), svg.end(), element), end; i != end; ++i)
        if ((*i)[2] == words) return (*i)[0];
    return "";
}

inline Point text_at(const std::string& svg, const std::string& words) {
    const std::string element = text_element(svg, words);
    INFO("text " << words);
    REQUIRE(element != "");
    return {attribute(element, "x"), attribute(element, "y")};
}

/// How far a value is outside a range.
inline double beyond(double v, double low, double high) {
    return v >= low && v <= high ? 0 : v < low ? low - v : v - high;
}

struct Rectangle {
    double x, y, width, height;
    std::string colour;
};

inline std::vector<Rectangle> rectangles(const std::string& svg, const std::string& colour) {
    std::vector<Rectangle> all;
    const std::regex element("<rect x[^>]*fill=\"" + colour + "\"[^>]*>");
    for (std::sregex_iterator i(svg.begin(), svg.end(), element), end; i != end; ++i) {
        const std::string e = (*i)[0];
        all.push_back({attribute(e, "x"), attribute(e, "y"), attribute(e, "width"), attribute(e, "height"), colour});
    }
    return all;
}

}  // namespace hinge::output::test

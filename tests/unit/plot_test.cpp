// Plots as SVG: what stands in the file, where it stands, and what none may hold.
#include <catch2/catch.hpp>

#include <dlfcn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "output/plot.h"

using namespace hinge::output;
namespace fs = std::filesystem;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

hinge_plot plot_function() {
    static void* module = ::dlopen(HINGE_OUTPUT_MODULE, RTLD_NOW | RTLD_LOCAL);
    REQUIRE(module);
    const auto function = reinterpret_cast<hinge_plot>(::dlsym(module, "hinge_plot"));
    REQUIRE(function);
    return function;
}

class File {
public:
    explicit File(const std::string& end) {
        std::string name = (fs::temp_directory_path() / "hinge-plot-XXXXXX").string();
        REQUIRE(::mkdtemp(name.data()));
        folder_ = name;
        path_ = name + "/a" + end;
    }
    ~File() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    const char* path() const { return path_.c_str(); }

private:
    std::string folder_, path_;
};

std::string drawn(const Plot& plot, int width = 800, int height = 600) {
    const File file(".svg");
    char error[512] = "";
    const int status = plot_function()(file.path(), plot, width, height, error, sizeof error);
    INFO(error);
    REQUIRE(status == 0);
    std::ifstream in(file.path(), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

Plot plot_of(std::vector<Series> series) {
    Plot plot;
    plot.panels.resize(1);
    plot.panels[0].series = std::move(series);
    return plot;
}

struct Point {
    double x, y;
};

/// The points of each polyline or polygon.
std::vector<std::vector<Point>> shapes(const std::string& svg, const std::string& tag) {
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

double attribute(const std::string& element, const std::string& name) {
    std::smatch match;
    REQUIRE(std::regex_search(element, match, std::regex(" " + name + "=\"(-?[0-9.]+)\"")));
    return std::stod(match[1]);
}

/// The element whose text is `words`.
std::string text_element(const std::string& svg, const std::string& words) {
    const std::regex element("<text ([^>]*)>([^<]*)");
    for (std::sregex_iterator i(svg.begin(), svg.end(), element), end; i != end; ++i)
        if ((*i)[2] == words) return (*i)[0];
    return "";
}

Point text_at(const std::string& svg, const std::string& words) {
    const std::string element = text_element(svg, words);
    INFO("text " << words);
    REQUIRE(element != "");
    return {attribute(element, "x"), attribute(element, "y")};
}

/// How far a value is outside a range.
double beyond(double v, double low, double high) { return v >= low && v <= high ? 0 : v < low ? low - v : v - high; }

struct Rectangle {
    double x, y, width, height;
    std::string colour;
};

std::vector<Rectangle> rectangles(const std::string& svg, const std::string& colour) {
    std::vector<Rectangle> all;
    const std::regex element("<rect x[^>]*fill=\"" + colour + "\"[^>]*>");
    for (std::sregex_iterator i(svg.begin(), svg.end(), element), end; i != end; ++i) {
        const std::string e = (*i)[0];
        all.push_back({attribute(e, "x"), attribute(e, "y"), attribute(e, "width"), attribute(e, "height"), colour});
    }
    return all;
}

}  // namespace

TEST_CASE("an SVG needs no display and starts none", "[plot]") {
    const File file(".svg"), picture(".png");
    const auto call = plot_function();
    const Plot plot = plot_of({{"a", {0, 1}, {0, 1}}});
    const pid_t child = ::fork();  // its environment is its own
    REQUIRE(child >= 0);
    if (child == 0) {
        ::unsetenv("DISPLAY");
        ::setenv("PATH", "/nowhere", 1);
        char error[512] = "";
        const bool svg = call(file.path(), plot, 400, 300, error, sizeof error) == 0;
        const bool png = call(picture.path(), plot, 400, 300, error, sizeof error) == 0;
        ::_exit(svg && !png ? 0 : 1);
    }
    int status = -1;
    REQUIRE(::waitpid(child, &status, 0) == child);
    CHECK(status == 0);
    CHECK(fs::exists(file.path()));
}

TEST_CASE("names are text in an SVG, never markup", "[plot]") {
    Plot plot = plot_of({{"<script>alert(1)</script> & \"b\"", {0, 1}, {0, 1}}});
    plot.title = "</title><g onload=\"x\">\x01\xFF\xC0\xAF";
    plot.panels[0].y_label = "\xCF\x83 < \xCF\x84";
    const std::string svg = drawn(plot);
    CHECK_THAT(svg, Catch::Contains("&lt;script&gt;alert(1)&lt;/script&gt; &amp; &quot;b&quot;</text>"));
    CHECK_THAT(svg, Catch::Contains("\xCF\x83 &lt; \xCF\x84</text>"));
    CHECK_THAT(svg, !Catch::Contains("<script") && !Catch::Contains("<g ") && !Catch::Contains("\x01"));
    CHECK_THAT(svg, !Catch::Contains("\xFF") && !Catch::Contains("\xC0"));
    CHECK_THAT(svg, Catch::Contains("font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\""));
    CHECK_THAT(svg, Catch::Contains("viewBox=\"0 0 800 600\"") && Catch::EndsWith("</svg>\n"));
    CHECK(drawn(plot) == svg);
}

TEST_CASE("a curve is cut at the ranges of the axes", "[plot]") {
    Plot plot = plot_of({{"", {0, 1}, {-100, 100}}, {"", {0.1, 0.3, 0.9}, {5, 5, 1e300}}, {"", {0.3, 0.4}, {50, 60}}});
    plot.panels[0].x_range = {0.2, 0.8};
    plot.panels[0].y_range = {-20, 20};
    const std::string svg = drawn(plot);
    const auto curves = shapes(svg, "polyline");
    REQUIRE(curves.size() == 2);
    const double left = text_at(svg, "0.2").x, right = text_at(svg, "0.8").x;
    const double foot = text_at(svg,
                                "\xE2\x88\x92"
                                "20")
                            .y,
                 middle = text_at(svg, "0").y, head = text_at(svg, "20").y;
    // From y = -20 to 20 the first one goes from x = 0.4 to 0.6.
    CHECK(curves[0].front().x == Approx(left + (right - left) / 3).margin(1));
    CHECK(curves[0].back().x == Approx(left + 2 * (right - left) / 3).margin(1));
    CHECK(curves[0].front().y - curves[0].back().y == Approx(foot - head).margin(1));
    CHECK(curves[1].front().x == Approx(left).margin(1));
    CHECK(curves[1].front().y - curves[1].back().y == Approx((middle - head) * 0.75).margin(1));
    for (const auto& curve : curves)
        for (const Point& p : curve) {
            CHECK(p.x >= left - 1);
            CHECK(p.x <= right + 1);
            CHECK(p.y >= curves[0].back().y - 1);
            CHECK(p.y <= curves[0].front().y + 1);
        }
}

TEST_CASE("values that are no numbers are gaps, and no number of the file", "[plot]") {
    Plot plot =
        plot_of({{"", {0, 1, 2, 3, 4}, {1, 2, no_number, 2, 1}}, {"", {0, 1, 2, 3}, {1, INFINITY, no_number, 2}}});
    plot.panels[0].series.push_back({"", {0, 1, 2, 3}, {0, 1, no_number, 1}, SeriesStyle::band, false, {2, 2, 2, 2}});
    plot.panels[0].series.push_back({"", {no_number, 1}, {1, no_number}, SeriesStyle::both, false, {}, {}, {"a", "b"}});
    plot.panels[0].series.push_back({"", {no_number, 1}, {1, no_number}, SeriesStyle::bars, false, {}, {}, {"a", "b"}});
    const std::string svg = drawn(plot);
    CHECK(shapes(svg, "polyline").size() == 2);  // the two sides of the first one's gap
    CHECK(text_element(svg, "a") == "");
    CHECK_THAT(svg, !Catch::Contains("nan") && !Catch::Contains("inf\""));
}

TEST_CASE("bars rise from zero to their values, side by side, over the names of their categories", "[plot]") {
    Plot plot = plot_of({{"one", {1, 2, 3}, {2, -1, 4}, SeriesStyle::bars, false, {}, {}, {"2.0", "-1.0", "4.0"}},
                         {"two", {1, 3}, {3, 1}, SeriesStyle::bars}});
    SECTION("upright") {
        plot.panels[0].x_categories = {"I", "II", "III"};
        const std::string svg = drawn(plot);
        auto blue = rectangles(svg, "#0072b2"), red = rectangles(svg, "#d55e00");
        REQUIRE(blue.size() == 4);  // the last one is in the legend
        REQUIRE(red.size() == 3);
        CHECK(blue[0].height == Approx(2 * blue[1].height).margin(2));
        CHECK(blue[2].height == Approx(4 * blue[1].height).margin(3));
        const double zero = blue[0].y + blue[0].height;
        CHECK(blue[1].y == Approx(zero).margin(1));  // below the line of zero
        CHECK(red[0].y + red[0].height == Approx(zero).margin(1));
        CHECK(red[0].x >= blue[0].x + blue[0].width);
        CHECK(red[0].x - blue[0].x == Approx(red[1].x - blue[2].x).margin(1));
        CHECK(text_at(svg, "I").x == Approx((blue[0].x + red[0].x + red[0].width) / 2).margin(2));
        CHECK(text_at(svg, "III").x == Approx((blue[2].x + red[1].x + red[1].width) / 2).margin(2));
        CHECK(text_at(svg, "2.0").y < blue[0].y);
        CHECK(text_at(svg, "-1.0").y > blue[1].y + blue[1].height);
    }
    SECTION("cut at the range of the axis") {
        plot.panels[0].x_categories = {"I", "II", "III"};
        plot.panels[0].y_range = {-2, 1};
        const auto blue = rectangles(drawn(plot), "#0072b2");
        REQUIRE(blue.size() == 4);
        CHECK(blue[0].height == Approx(blue[1].height).margin(1));  // one up, one down
        CHECK(blue[2].height == Approx(blue[1].height).margin(1));
    }
    SECTION("lying, the first one on top") {
        plot.panels[0].y_categories = {"I", "II", "III"};
        for (Series& s : plot.panels[0].series) std::swap(s.x, s.y);
        const std::string svg = drawn(plot);
        auto blue = rectangles(svg, "#0072b2");
        REQUIRE(blue.size() == 4);
        CHECK(blue[2].width == Approx(2 * blue[0].width).margin(2));
        CHECK(blue[1].x + blue[1].width == Approx(blue[0].x).margin(1));
        CHECK(blue[0].y < blue[1].y);
        CHECK(text_at(svg, "I").y < text_at(svg, "II").y);
        CHECK(text_at(svg, "4.0").x > blue[2].x + blue[2].width);
        CHECK(text_at(svg, "4.0").x + 25 < 800);
    }
}

TEST_CASE("names of categories that are too long to stand side by side are written upwards", "[plot]") {
    Plot plot = plot_of({{"", {1, 2}, {1, 2}, SeriesStyle::bars}});
    plot.panels[0].x_categories = {"short", "brief"};
    CHECK_THAT(text_element(drawn(plot), "short"), !Catch::Contains("rotate"));
    plot.panels[0].x_categories = {"a category of forty characters or nearly",
                                   "another one of forty characters, nearly"};
    CHECK_THAT(drawn(plot), Catch::Contains("rotate(-90"));
}

TEST_CASE("labels stand beside their points and do not cover each other", "[plot]") {
    Series s{"", {}, {}, SeriesStyle::points};
    for (int i = 0; i < 16; ++i) {  // pairs that are close to each other
        s.x.push_back(i / 2 % 4 + 0.04 * (i % 2));
        s.y.push_back(i / 8 + 0.02 * (i % 2));
        s.labels.push_back("setting " + std::to_string(100 + i));
    }
    const std::string svg = drawn(plot_of({s}), 1000, 800);
    std::vector<std::array<double, 4>> boxes;  // x, foot, width, height; SVG counts downwards
    std::vector<Point> dots;
    const std::regex circle("<circle[^>]*>");
    for (std::sregex_iterator i(svg.begin(), svg.end(), circle), end; i != end; ++i)
        dots.push_back({attribute((*i)[0], "cx"), attribute((*i)[0], "cy")});
    REQUIRE(dots.size() == 16);
    for (std::size_t i = 0; i < s.labels.size(); ++i) {
        const std::string element = text_element(svg, s.labels[i]);
        REQUIRE(element != "");
        const double size = attribute(element, "font-size"), x = attribute(element, "x"), y = attribute(element, "y");
        boxes.push_back({x, y, 5.9 * size, 0.73 * size});  // 11 characters, without what hangs below the line
        const double dx = beyond(dots[i].x, x, x + 5.9 * size), dy = beyond(dots[i].y, y - 0.73 * size, y);
        CHECK(std::hypot(dx, dy) < 4 * size);
        CHECK(x > 0);
        CHECK(x + 5.9 * size < 1000);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const auto &a = boxes[i], &b = boxes[k];
            const bool apart = a[0] >= b[0] + b[2] || b[0] >= a[0] + a[2] || a[1] - a[3] >= b[1] || b[1] - b[3] >= a[1];
            INFO(s.labels[i] << " and " << s.labels[k]);
            CHECK(apart);
        }
}

TEST_CASE("panels of a column line up, whatever stands beside their axes", "[plot]") {
    Plot plot;
    plot.title = "both";
    plot.panels.resize(2);
    plot.panels[0].series = {{"", {0, 1}, {0, 1}}};
    plot.panels[1].series = {{"", {0, 1}, {-123456.5, -123456}}};
    plot.panels[1].y_label = "N";
    plot.panels[0].x_label = plot.panels[1].x_label = "time";
    plot.panels[0].x_range = {0, 1};
    const auto edges = [&] {
        const auto curves = shapes(drawn(plot), "polyline");
        REQUIRE(curves.size() == 2);
        CHECK(curves[0].back().y < curves[1].back().y);
        CHECK(curves[0].front().x == curves[1].front().x);
        CHECK(curves[0].back().x == curves[1].back().x);
        return std::pair{curves[0].front().x, curves[0].back().x};
    };
    const auto plain = edges();
    SECTION("a legend that finds no corner stands beside one panel and narrows both") {
        Series filling{"all over", {}, {}, SeriesStyle::points};
        for (int i = 0; i < 2500; ++i) filling.x.push_back(i % 50 / 49.0), filling.y.push_back(i / 50 / 49.0);
        plot.panels[0].series.push_back(filling);
        CHECK(edges().second < plain.second - 50);
    }
    SECTION("one axis for both") {
        plot.share_x = true;
        plot.panels[0].x_range.reset();
        plot.panels[1].series[0].x = {0, 2};
        const std::string svg = drawn(plot);
        const auto curves = shapes(svg, "polyline");
        const double width = curves[1].back().x - curves[1].front().x;
        CHECK(curves[0].back().x - curves[0].front().x == Approx(width / 2).margin(1));
        CHECK(svg.find(">time<") == svg.rfind(">time<"));
    }
    SECTION("beside each other they have one foot") {
        plot.columns = 2;
        plot.panels[0].x_label.clear();
        plot.panels[0].series[0].y = plot.panels[1].series[0].y = {0, 1};
        const auto curves = shapes(drawn(plot), "polyline");
        CHECK(curves[0].front().y == curves[1].front().y);
        CHECK(curves[0].back().y == curves[1].back().y);
        CHECK(curves[0].back().x < curves[1].front().x);
    }
}

TEST_CASE("a long history stays a small file and keeps its extremes", "[plot]") {
    Series s{"", {}, {}};
    for (int i = 0; i < 300000; ++i) {
        s.x.push_back(i);
        s.y.push_back(i == 123456 ? 10 : std::sin(0.7 * i));
    }
    const std::string svg = drawn(plot_of({s}));
    CHECK(svg.size() < 60000);
    const auto curves = shapes(svg, "polyline");
    REQUIRE(curves.size() == 1);
    const auto lower = [](const Point& a, const Point& b) { return a.y < b.y; };
    const auto [top, foot] = std::minmax_element(curves[0].begin(), curves[0].end(), lower);
    const double two = text_at(svg, "2").y, eight = text_at(svg, "8").y;
    CHECK((foot->y - top->y) / (two - eight) == Approx(11 / 6.0).epsilon(0.01));
}

TEST_CASE("lines through a panel stand at their values and widen its axes", "[plot]") {
    Plot plot = plot_of({{"", {0, 10}, {0, 10}}});
    plot.panels[0].lines = {{"limit", 20, false}, {"impact", 5, true}, {"", -1, false}, {"", 16, true}};
    const std::string svg = drawn(plot);
    const auto lines = shapes(svg, "polyline");
    REQUIRE(lines.size() == 5);  // four lines and the curve
    CHECK(lines[0].front().y == lines[0].back().y);
    CHECK(lines[0].front().y - lines[2].front().y ==
          Approx(21 / 10.0 * (lines[4].back().y - lines[4].front().y)).epsilon(0.02));
    CHECK(lines[1].front().x == Approx((lines[4].front().x + lines[4].back().x) / 2).margin(1));
    CHECK(text_at(svg, "limit").y < lines[0].front().y);
    CHECK(std::abs(text_at(svg, "impact").x - lines[1].front().x) < 30);
    const double ten = lines[4].back().x - lines[4].front().x;
    CHECK(lines[3].front().x - lines[4].front().x == Approx(1.6 * ten).epsilon(0.01));
    CHECK(lines[3].front().x < 800);
}

TEST_CASE("eight colours follow the order of the series; the next eight are dashed", "[plot]") {
    std::vector<Series> series;
    for (double i = 0; i < 9; ++i) series.push_back({"", {0, 1}, {i, i + 1}});
    series[1].colour = Rgb8{1, 2, 3};
    const std::string svg = drawn(plot_of(series));
    CHECK_THAT(svg, Catch::Contains("stroke=\"#0072b2\"") && Catch::Contains("stroke=\"#010203\""));
    CHECK_THAT(svg, !Catch::Contains("#d55e00"));
    const std::regex dashed("stroke=\"(#[0-9a-f]*)\"[^>]*stroke-dasharray");
    std::smatch match;
    REQUIRE(std::regex_search(svg, match, dashed));
    CHECK(match[1] == "#0072b2");
    CHECK(std::distance(std::sregex_iterator(svg.begin(), svg.end(), dashed), {}) == 1);
}

TEST_CASE("what is too long for its place is written smaller, then cut", "[plot]") {
    Plot plot = plot_of({{"", {0, 1}, {0, 1}}});
    plot.title = "a title";
    const double size = attribute(text_element(drawn(plot), plot.title), "font-size");
    plot.title = std::string(60, 'n');
    CHECK(attribute(text_element(drawn(plot), plot.title), "font-size") < size);
    plot.title = std::string(200, 'n');
    CHECK(text_element(drawn(plot), plot.title) == "");
    CHECK_THAT(drawn(plot), Catch::Contains("nnn\xE2\x80\xA6</text>"));
}

TEST_CASE("panels with one x axis have the range that one of them was given", "[plot]") {
    Plot plot;
    plot.panels.resize(2);
    plot.share_x = true;
    for (Panel& panel : plot.panels) panel.series = {{"", {0, 2, 4, 10}, {0, 20, 40, 100}}};
    plot.panels[GENERATE(0, 1)].x_range = {2, 4};
    const std::string svg = drawn(plot);
    const auto curves = shapes(svg, "polyline");
    REQUIRE(curves.size() == 2);
    const double left = text_at(svg, "2.0").x, right = text_at(svg, "4.0").x;
    for (const auto& curve : curves) {
        CHECK(curve.front().x == Approx(left).margin(1));
        CHECK(curve.back().x == Approx(right).margin(1));
    }
    CHECK(curves[0].front().y - curves[0].back().y > 100);  // y from 2 to 4 fills its frame
}

namespace {

/// The white box of the legend: the rectangle before its first name.
Rectangle legend_box(const std::string& svg) {
    const auto boxes = rectangles(svg, "#ffffff");
    REQUIRE(boxes.size() == 1);
    return boxes[0];
}

/// Whether a curve passes through a box, looked at in steps of half a pixel.
bool passes(const std::vector<Point>& curve, const Rectangle& box) {
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const Point p = curve[i], q = curve[i + 1];
        const int n = 1 + int(2 * std::hypot(q.x - p.x, q.y - p.y));
        for (int k = 0; k <= n; ++k) {
            const double x = p.x + (q.x - p.x) * k / n, y = p.y + (q.y - p.y) * k / n;
            if (x > box.x && x < box.x + box.width && y > box.y && y < box.y + box.height) return true;
        }
    }
    return false;
}

}  // namespace

TEST_CASE("a legend covers no curve", "[plot]") {
    Plot plot = plot_of({{"first", {0, 10}, {0, 0}}, {"second", {0, 10}, {10, 10}}});
    const auto add = [&](std::vector<double> x, std::vector<double> y) {
        plot.panels[0].series.push_back({"", std::move(x), std::move(y)});
    };
    const auto curves_of = [](const std::string& svg) {
        auto all = shapes(svg, "polyline");
        const Rectangle box = legend_box(svg);
        std::erase_if(all, [&](const auto& c) {  // the samples in the legend
            return c.size() == 2 && c[0].y == c[1].y && c[0].x > box.x && c[1].x < box.x + box.width;
        });
        return all;
    };
    const auto uncovered = [&](const std::string& svg, std::size_t n) {
        const auto curves = curves_of(svg);
        CHECK(curves.size() == n);
        for (const auto& curve : curves) CHECK(!passes(curve, legend_box(svg)));
    };
    SECTION("though all corners are taken, by curves that are far from straight between their points") {
        add({0, 1.5, 3}, {10, 5, 10}), add({7, 8.5, 10}, {10, 5, 10});
        add({0, 1.5, 3}, {0, 5, 0}), add({7, 8.5, 10}, {0, 5, 0});
        const std::string svg = drawn(plot);
        uncovered(svg, 6);
        const double right = curves_of(svg)[0].back().x;
        CHECK(legend_box(svg).x + legend_box(svg).width < right);  // inside
    }
    SECTION("inside a band") {
        plot.panels[0].series.push_back({"", {0, 10}, {-1, 4}, SeriesStyle::band, false, {6, 11}});
        const std::string svg = drawn(plot);
        uncovered(svg, 2);
        const Rectangle box = legend_box(svg);
        const auto band = shapes(svg, "polygon").at(0);
        for (const double x : {box.x, box.x + box.width}) {
            const double share = (x - band[0].x) / (band[1].x - band[0].x);
            const double low = band[0].y + share * (band[1].y - band[0].y);
            const double high = band[3].y + share * (band[2].y - band[3].y);
            CHECK((box.y > low || box.y + box.height < high));
        }
    }
    std::vector<double> x, y;  // all over the frame
    for (int i = 0; i <= 60; ++i) x.push_back(i / 6.0), y.push_back(i % 2 ? 10 : 0);
    SECTION("at the right of a frame that is full") {
        add(x, y);
        const std::string svg = drawn(plot);
        uncovered(svg, 3);
        CHECK(legend_box(svg).x > curves_of(svg)[0].back().x);
        CHECK(legend_box(svg).x + legend_box(svg).width <= 800);
    }
    SECTION("above it where the names are long") {
        add(x, y);
        plot.title = "a title", plot.panels[0].series[0].name = std::string(40, 'n');
        const std::string svg = drawn(plot);
        uncovered(svg, 3);
        const Rectangle box = legend_box(svg);
        CHECK(box.y + box.height < curves_of(svg)[1].front().y);
        CHECK(box.y > text_at(svg, "a title").y);
    }
    SECTION("in the upper of two panels, which gets narrower for the lower one's") {
        plot.panels.push_back(plot.panels[0]);
        plot.panels[0].series = {{"up", {0, 5.8, 5.9, 10}, {0, 0, 10, 10}}, {"", {0, 5.7, 5.8, 10}, {-9, -9, -1, -1}}};
        plot.panels[1].series.push_back({"a name of some length", x, y});
        const std::string svg = drawn(plot, 420, 700);
        const auto boxes = rectangles(svg, "#ffffff");
        REQUIRE(boxes.size() == 2);
        for (const auto& curve : shapes(svg, "polyline"))
            if (curve.size() > 2)
                for (const Rectangle& box : boxes) CHECK(!passes(curve, box));
    }
}

TEST_CASE("points of a line that have no neighbour are dots", "[plot]") {
    const std::string svg = drawn(plot_of(
        {{"", {0, 1, 2, 3, 4, 5}, {1, no_number, 2, no_number, 3, 4}}, {"", {2.5}, {2.5}}, {"", {3, 3}, {1, 1}}}));
    const std::regex circle("<circle[^>]*>");
    std::vector<Point> dots;
    for (std::sregex_iterator i(svg.begin(), svg.end(), circle), end; i != end; ++i)
        dots.push_back({attribute((*i)[0], "cx"), attribute((*i)[0], "cy")});
    REQUIRE(dots.size() == 4);
    const auto x = [&](const char* mark) { return text_at(svg, mark).x; };
    CHECK(dots[0].x == Approx(x("0")).margin(1));
    CHECK(dots[1].x == Approx(x("2")).margin(1));
    CHECK(dots[2].x == Approx((x("2") + x("3")) / 2).margin(1));
    CHECK(dots[3].x == Approx(x("3")).margin(1));
    CHECK(dots[3].y == Approx(dots[0].y).margin(1));
}

TEST_CASE("labels of faint points are left out where there is no room, and only there", "[plot]") {
    Plot plot = plot_of({{"", {}, {}, SeriesStyle::points}, {"", {0, 10}, {0, 10}, SeriesStyle::points}});
    Series &strong = plot.panels[0].series[0], &faint = plot.panels[0].series[1];
    for (int i = 0; i < 3600; ++i) strong.x.push_back(0.1 * (i % 60) + 2), strong.y.push_back(0.1 * (i / 60 % 60) + 2);
    strong.labels = {"strong 0", "strong 1"};
    faint.x.push_back(5), faint.y.push_back(5);
    faint.labels = {"first", "second", "buried in the heap"};
    CHECK(text_element(drawn(plot), "buried in the heap") != "");
    faint.faint = true;
    const std::string svg = drawn(plot);
    for (const char* words : {"first", "second", "strong 0", "strong 1"}) CHECK(text_element(svg, words) != "");
    CHECK(text_element(svg, "buried in the heap") == "");
    CHECK_THAT(svg, !Catch::Contains("#d55e00"));  // a lighter red
}

// Plots as SVG: what stands in the file, where it stands, and what none may hold.
#include <sys/wait.h>

#include "plot_parts.h"

using namespace hinge::output;
using namespace hinge::output::test;

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

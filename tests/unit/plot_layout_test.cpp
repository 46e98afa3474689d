// Plots as SVG: where labels, legends, names and panels find their places.
#include "plot_parts.h"

using namespace hinge::output;
using namespace hinge::output::test;

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

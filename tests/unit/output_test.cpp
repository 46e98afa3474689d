// The output module, loaded as the program loads it: frames on disk, pictures, plots, and what it says when it cannot.
#include <limits>

#include "output_parts.h"

using namespace hinge::output;
using namespace hinge::output::test;

TEST_CASE("a snapshot comes back as it was written", "[output]") {
    const Folder folder;
    Snapshot snapshot = portal(6);

    SECTION("as it is") {}
    SECTION("bars without a group, and no groups at all") {
        snapshot.groups.clear();
        for (Bar& bar : snapshot.bars) bar.group = -1;
    }
    SECTION("odd names of groups") { snapshot.groups = {"", "a b <&\">", "\xCF\x84\xCE\xB1"}; }
    SECTION("no bars") { snapshot = Snapshot{}; }
    SECTION("of statics") { snapshot.factor = 0.625; }

    REQUIRE(write(folder / "a.vtp", snapshot) == "");
    Snapshot back;
    back.groups = {"left over"};
    REQUIRE(read(folder / "a.vtp", back) == "");
    check_same(snapshot, back);
    CHECK(back.factor == snapshot.factor);
    CHECK(folder.files() == 1);  // nothing is left beside it
}

TEST_CASE("a frame replaces an older one", "[output]") {
    const Folder folder;
    REQUIRE(write(folder / "a.vtp", portal(2)) == "");
    REQUIRE(write(folder / "a.vtp", portal(3)) == "");
    Snapshot back;
    REQUIRE(read(folder / "a.vtp", back) == "");
    CHECK(back.bars.size() == portal(3).bars.size());
}

TEST_CASE("the collection lists times and files", "[output]") {
    const Folder folder;
    const double times[] = {0, 0.0025};
    const char* const files[] = {"frames/0.vtp", "a&b.vtp"};
    const auto call = load<hinge_write_collection>("hinge_write_collection");
    const std::string path = folder / "frames.pvd";
    REQUIRE(said([&](char* e, int room) { return call(path.c_str(), 2, times, files, e, room); }) == "");
    const std::string text = contents(path);
    CHECK_THAT(text, Catch::Contains("type=\"Collection\""));
    CHECK_THAT(text, Catch::Contains("timestep=\"0.0025\""));
    CHECK_THAT(text, Catch::Contains("file=\"a&amp;b.vtp\""));
}

TEST_CASE("what cannot be written or read is said, with what to do", "[output]") {
    const Folder folder;
    Snapshot snapshot = portal(1);
    CHECK_THAT(write(folder / "none/a.vtp", snapshot),
               Catch::Contains("No such file or directory") && Catch::Contains("make the folder"));
    fs::create_directory(folder / "taken");
    CHECK_THAT(write(folder / "taken", snapshot), Catch::Contains("folder of that name is in the way"));
    CHECK(folder.files() == 1);
    CHECK_THAT(write("", snapshot), Catch::Contains("file name"));

    CHECK_THAT(read(folder / "a.vtp", snapshot), Catch::Contains("cannot read"));
    std::ofstream(folder / "text.vtp") << "no frame at all";
    CHECK_THAT(read(folder / "text.vtp", snapshot), Catch::Contains("not a VTP file"));

    snapshot.bars[0].point[1] = 99;
    CHECK_THAT(write(folder / "a.vtp", snapshot), Catch::Contains("bar 0 ends at point 99"));
    CHECK_THAT(render(folder / "a.png", snapshot, {}), Catch::Contains("bar 0 ends at point 99"));
}

TEST_CASE("a damaged frame is refused", "[output]") {
    const Folder folder;
    REQUIRE(write(folder / "a.vtp", portal(6)) == "");
    const std::string whole = contents(folder / "a.vtp");
    for (const double share : {0.1, 0.5, 0.9}) {
        const auto size = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
        std::ofstream(folder / "cut.vtp", std::ios::binary) << whole.substr(0, size);
        Snapshot back;
        CHECK_THAT(read(folder / "cut.vtp", back), Catch::Contains("cannot read"));
    }
}

TEST_CASE("a message is cut to the room there is", "[output]") {
    char error[8] = "xxxxxxx";
    const auto call = load<hinge_write_snapshot>("hinge_write_snapshot");
    CHECK(call("/nowhere/a.vtp", portal(1), error, 5) == 1);
    CHECK(std::string(error) == "cann");
    CHECK(call("/nowhere/a.vtp", portal(1), nullptr, 0) == 1);
}

TEST_CASE("a plot has the size asked for and its curves", "[output]") {
    const Folder folder;
    Plot what;
    what.title = "Energy";
    what.panels.resize(1);
    Panel& panel = what.panels[0];
    panel.x_label = "t [s]";
    panel.y_label = "J";
    Series line{"kinetic", {}, {}, SeriesStyle::line, false}, dots{"measured", {}, {}, SeriesStyle::points, false};
    for (int i = 1; i <= 50; ++i) {
        line.x.push_back(0.01 * i);
        line.y.push_back(1e6 * std::exp(-0.1 * i));
    }
    dots.x = {0.1, 0.2};
    dots.y = {5e5, std::numeric_limits<double>::quiet_NaN()};
    panel.series = {line, dots};

    SECTION("linear") {}
    SECTION("logarithmic") { panel.log_x = panel.log_y = true; }
    SECTION("dashed") { panel.series[0].dashed = true; }
    SECTION("within a decade") {
        panel.log_y = true;
        for (double& y : panel.series[0].y) y = 6e5 + 0.1 * y;
    }
    REQUIRE(plot(folder / "a.png", what, 500, 400) == "");
    const Image image = decode(contents(folder / "a.png"));
    CHECK(image.width == 500);
    CHECK(image.height == 400);
    CHECK(image.colours() > 50);
    CHECK(image.count([](Rgb c) { return c == Rgb{213, 94, 0}; }) > 10);
    std::set<std::size_t> columns;  // the curve runs across the picture; in the legend it is short
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        if (image.pixels[i][2] > image.pixels[i][0] + 70) columns.insert(i % image.width);
    CHECK(columns.size() > 200);
}

TEST_CASE("a plot of nothing is refused", "[output]") {
    const Folder folder;
    Plot what;
    CHECK_THAT(plot(folder / "a.png", what, 500, 400), Catch::Contains("nothing to draw"));
    what.panels.resize(1);
    Panel& panel = what.panels[0];
    CHECK_THAT(plot(folder / "a.png", what, 500, 400), Catch::Contains("nothing to draw"));
    panel.series = {{"a", {1, 2}, {1}}};
    CHECK_THAT(plot(folder / "a.png", what, 500, 400), Catch::Contains("2 x and 1 y"));
    panel.series = {{"a", {1}, {-1}}};
    panel.log_y = true;
    CHECK_THAT(plot(folder / "a.png", what, 500, 400), Catch::Contains("positive on a logarithmic axis"));
}

TEST_CASE("bands and bars of a plot are as large as their values, cut at its ranges", "[output]") {
    const Folder folder;
    Plot what;
    what.panels.resize(1);
    Panel& panel = what.panels[0];
    const auto blue_pixels = [&] {
        REQUIRE(plot(folder / "a.png", what, 500, 400) == "");
        // blue, or blue through which the white shines
        return double(decode(contents(folder / "a.png")).count([](Rgb c) { return c[2] > c[0] + 30; }));
    };
    SECTION("bars") {
        panel.x_categories = {"one", "two"};
        panel.y_range = {0, 4};
        panel.series = {{"", {1}, {2}, SeriesStyle::bars}};
        const double two = blue_pixels();
        REQUIRE(two > 1000);
        panel.series = {{"", {1, 2}, {1, 3}, SeriesStyle::bars}};
        CHECK(blue_pixels() / two == Approx(2).epsilon(0.03));
        panel.series = {{"", {1, 2}, {4, 99}, SeriesStyle::bars}};
        CHECK(blue_pixels() / two == Approx(4).epsilon(0.03));
    }
    SECTION("bands") {
        panel.x_range = {0, 1};
        panel.y_range = {0, 4};
        panel.series = {{"", {0, 1}, {1, 1}, SeriesStyle::band, false, {2, 2}}};
        const double one = blue_pixels();
        REQUIRE(one > 1000);
        panel.series[0].high = {3, 5};  // cut at 4 on its second half: 3 - 0.25
        CHECK(blue_pixels() / one == Approx(2.75).epsilon(0.03));
        panel.series[0].x = {-1, 2};  // what is beside the range is cut too: from 3.67 to 4, and 4
        CHECK(blue_pixels() / one == Approx(3 - 1 / 12.0).epsilon(0.03));
    }
}

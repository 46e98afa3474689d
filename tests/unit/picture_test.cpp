// Pictures: what they show of a snapshot, read from their pixels.
#include <sys/wait.h>

#include "output/colours.h"
#include "output_parts.h"

using namespace hinge::output;
using namespace hinge::output::test;

TEST_CASE("a picture has the size asked for and shows the bars", "[output]") {
    View view;
    view.width = 640, view.height = 480;
    view.title = "Portal";
    view.hinges = false;  // whose dots are red as well
    const Snapshot snapshot = portal(6);
    const Image image = picture(snapshot, view);
    CHECK(image.width == 640);
    CHECK(image.height == 480);
    CHECK(image.colours() > 200);
    CHECK(image.pixels.front() == Rgb{255, 255, 255});

    SECTION("the same bytes again") {
        const Folder folder;
        for (const char* name : {"a.png", "b.png"}) REQUIRE(render(folder / name, snapshot, view) == "");
        CHECK(contents(folder / "a.png") == contents(folder / "b.png"));
    }
    SECTION("f_y = 1 is red") {
        Snapshot yielded = snapshot;
        for (Bar& bar : yielded.bars) {
            bar.yield = 1, bar.N = bar.N0;
            for (int end : {0, 1}) bar.Mx[end] = bar.My[end] = bar.Qx[end] = bar.Qy[end] = 0;
            bar.Mz = 0;
        }
        CHECK(picture(yielded, view).count(is_red) > 3 * image.count(is_red));
    }
    SECTION("a view leaves bars out") {
        view.above = 1;
        CHECK(picture(snapshot, view).pixels != image.pixels);
        view.above = -1;
        view.leave_out_broken = true;
        CHECK(picture(snapshot, view).pixels != image.pixels);
    }
    SECTION("nothing to show is a picture too") {
        view.above = 100;
        picture(snapshot, view);
    }
    SECTION("bars that went astray or are not numbers do no harm") {
        Snapshot wild = snapshot;
        wild.points[0] = {1e30, 0, 0};
        wild.points[1] = {std::nan(""), 0, 0};
        picture(wild, view);
    }
}

TEST_CASE("a picture of statics shows the load factor, not a time", "[output]") {
    Snapshot now = portal(2), later = now;
    later.time = 2 * now.time;
    const auto same = [&] { return picture(now, {}).pixels == picture(later, {}).pixels; };
    CHECK(!same());
    now.factor = later.factor = 0.5;
    CHECK(same());
    later.factor = 0.75;
    CHECK(!same());
}

TEST_CASE("bars have the colour of their class: five of f_y, f_y = 1, a broken one's", "[output]") {
    // The legend's colours (paper, fig 17), dark blue to orange, red for f_y = 1, black. A bar's pixels are those in
    // which the picture differs from one without it; light and shade change their brightness, hardly their hue.
    View view;
    view.width = 320, view.height = 240;
    std::array<double, 3> classes[n_classes];
    for (int i = 0; i < n_classes; ++i)
        for (int k = 0; k < 3; ++k) classes[i][k] = class_colours[i][k];
    const int plastic = plastic_class, broken = broken_class;
    const auto drawn = [&](double yield, BarState state) {
        Snapshot snapshot;
        snapshot.points = {{0, 0, 0}, {1, 0, 0}};
        snapshot.is_virtual = {0, 0};
        snapshot.bars.push_back({{0, 1}, yield, state, -1, 1, 1, 0.3});
        const Image with = picture(snapshot, view);
        View nothing = view;
        nothing.box = {-0.3, 1.3, -0.3, 0.3, -0.3, 0.3};
        snapshot.bars.clear();
        return std::pair{with, picture(snapshot, nothing)};
    };
    const auto class_of = [&](double yield, BarState state) {
        const auto [with, without] = drawn(yield, state);
        std::array<double, 3> sum{};
        long n = 0;
        for (std::uint32_t y = with.height / 3; y < 2 * with.height / 3; ++y)  // beside title, axes and legend
            for (std::uint32_t x = with.width / 3; x < 2 * with.width / 3; ++x) {
                const Rgb c = with.pixels[y * with.width + x];
                if (c == without.pixels[y * with.width + x]) continue;
                ++n;
                for (int k = 0; k < 3; ++k) sum[k] += c[k];
            }
        REQUIRE(n > 500);
        const auto size = [](const std::array<double, 3>& c) { return std::hypot(c[0], c[1], c[2]); };
        if (size(sum) / double(n) < 60) return broken;
        int best = -1;
        double least = 1e9;
        for (int i = 0; i < broken; ++i) {
            double off = 0;
            for (int k = 0; k < 3; ++k) off += std::pow(sum[k] / size(sum) - classes[i][k] / size(classes[i]), 2);
            if (!(off >= least)) best = i, least = off;  // what is no number is no colour either
        }
        return best;
    };
    const std::pair<double, int> elastic[] = {{0, 0},     {0.19, 0},         {0.21, 1},     {0.39, 1}, {0.41, 2},
                                              {0.59, 2},  {0.61, 3},         {0.79, 3},     {0.81, 4}, {0.99, 4},
                                              {0.998, 4}, {0.9995, plastic}, {1.0, plastic}};
    for (const auto& [yield, colour] : elastic) {
        INFO("f_y " << yield);
        CHECK(class_of(yield, BarState::elastic) == colour);
    }
    CHECK(class_of(0.3, BarState::yielded) == 1);  // what it bears now; its hinges have dots
    CHECK(class_of(0.3, BarState::broken) == broken);
    CHECK(class_of(1.0, BarState::broken) == broken);
}

TEST_CASE("a view that makes no sense is refused", "[output]") {
    const Folder folder;
    View view;
    SECTION("direction") {
        view.from = {0, 0, 0};
        CHECK_THAT(render(folder / "a.png", portal(1), view), Catch::Contains("view.from"));
    }
    SECTION("size") {
        view.width = 0;
        CHECK_THAT(render(folder / "a.png", portal(1), view), Catch::Contains("0 x 1200"));
    }
    CHECK(folder.files() == 0);
}

TEST_CASE("one stray fragment does not widen the frame", "[output]") {
    Snapshot snapshot = portal(40);
    for (Bar& bar : snapshot.bars) bar.N0 = 0;  // no legend of hinges, which a picture with a box has
    snapshot.points.back() = {5000, 0, 0};
    View view;
    view.width = 320, view.height = 240;
    view.hinges = view.ground = view.supports = false;  // the frame is that of the bars alone
    const Image fitted = picture(snapshot, view);
    view.box = {0, 160, 0, 0, 0, 3};  // the portal without the fragment
    CHECK(picture(snapshot, view).pixels == fitted.pixels);
    view.box = {0, 5000, 0, 0, 0, 3};
    CHECK(picture(snapshot, view).pixels != fitted.pixels);
}

TEST_CASE("without any display the message says how to get one", "[output]") {
    const Folder folder;
    const auto call = load<hinge_render>("hinge_render");
    // In a child: the environment is its own, and so is the display it must look for anew.
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        ::unsetenv("DISPLAY");
        ::setenv("PATH", "/nowhere", 1);
        char error[512] = "";
        const int status = call((folder / "a.png").c_str(), portal(1), {}, error, sizeof error);
        const bool told = std::string(error).find("apt-get install xvfb") != std::string::npos;
        ::_exit(status == 1 && told ? 0 : 1);
    }
    int status = -1;
    REQUIRE(::waitpid(child, &status, 0) == child);
    CHECK(status == 0);
}

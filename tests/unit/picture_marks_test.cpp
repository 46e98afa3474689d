// What a picture shows of a beam, read from its pixels: its deformed shape, diagrams, hinges, sections, supports, loads
// and labels.

#include "helpers.h"
#include "output/colours.h"
#include "output/film.h"
#include "output_parts.h"

using namespace hinge::output;
using namespace hinge::output::test;
using hinge::test::largest_of, hinge::test::smallest_of;

namespace {

/// Bars along x from 0 to 10 m as one member, seen from the front without perspective: x is to the right, z upwards.
struct Beam {
    Snapshot snapshot;
    View view;
    explicit Beam(int bars = 1, double depth = 0.4) {
        for (int i = 0; i <= bars; ++i) snapshot.points.push_back({10.0 * i / bars, 0, 0});
        const auto n = snapshot.points.size();
        snapshot.is_virtual.assign(n, 0);
        snapshot.displacement.assign(n, {0, 0, 0});
        snapshot.rotation.assign(n, {0, 0, 0});
        snapshot.held.assign(n, 0);
        snapshot.declared = int(n);
        snapshot.shapes = {{Shape::rectangle, depth, depth, 0, 0}};
        for (int i = 0; i < bars; ++i) {
            Bar bar{{i, i + 1}, 0, BarState::elastic, -1, 1, i + 1, depth};
            bar.up = {0, 0, 1}, bar.shape = 0, bar.N0 = 1e6, bar.Mx0 = bar.My0 = bar.Mz0 = 1e5;
            snapshot.bars.push_back(bar);
        }
        view.width = 640, view.height = 480;
        view.from = {0, -1, 0}, view.parallel = true;
        view.box = {-1, 11, 0, 0, -4, 4};
    }
    Bar& bar() { return snapshot.bars[0]; }
    void moment(double both) { bar().Mx[0] = bar().Mx[1] = both; }
    /// Without title and legend, which lie above and below.
    Image draw() const {
        Image image = picture(snapshot, view);
        const std::size_t row = image.width;
        const int top = 60, bottom = 80;
        image.pixels = {image.pixels.begin() + long(top * row), image.pixels.end() - long(bottom * row)};
        image.height -= top + bottom;
        return image;
    }
};

/// Where pixels are that are nearer to a colour than 40 in each part: how many, and their middle and extent.
struct Spot {
    long n = 0;
    double x = 0, y = 0;  ///< their mean, pixels from the upper left corner
    double left = 1e9, right = -1, top = 1e9, bottom = -1;
};
Spot spot(const Image& image, Colour c, int near = 40) {
    Spot s;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        bool is = true;
        for (int k = 0; k < 3; ++k) is = is && std::abs(image.pixels[i][k] - c[k]) < near;
        if (!is) continue;
        const int x = int(i % image.width), y = int(i / image.width);
        ++s.n, s.x += x, s.y += y;
        s.left = smallest_of(s.left, x), s.right = largest_of(s.right, x);
        s.top = smallest_of(s.top, y), s.bottom = largest_of(s.bottom, y);
    }
    if (s.n > 0) s.x /= double(s.n), s.y /= double(s.n);
    return s;
}
bool is_white(Rgb c) { return c[0] > 250 && c[1] > 250 && c[2] > 250; }

}  // namespace

TEST_CASE("displacements are magnified by the scale", "[output]") {
    // The length of a beam in units of its depth of 2 m: how large a picture shows it depends on the words around it.
    Beam beam(1, 2);
    const auto length = [&](double scale) {
        beam.view.scale = scale;
        const Spot bar = spot(beam.draw(), class_colours[0], 60);
        return 2 * double(bar.right - bar.left + 1) / (bar.bottom - bar.top + 1);
    };
    CHECK(std::abs(length(1) - 10) < 0.15);
    beam.snapshot.displacement[1] = {-0.5, 0, 0};
    beam.snapshot.points[1] = {9.5, 0, 0};
    CHECK(std::abs(length(1) - 9.5) < 0.15);
    CHECK(std::abs(length(10) - 5) < 0.15);
    // The largest displacement as a twentieth of the structure's 10 m, by the next lower of 1, 2, 5, 10: by 5.
    beam.snapshot.displacement[1] = {-0.1, 0, 0};
    beam.snapshot.points[1] = {9.9, 0, 0};
    CHECK(std::abs(length(0) - 9.5) < 0.15);
}

TEST_CASE("a magnified member bends as its nodes have rotated", "[output]") {
    // Both ends turn by 0.01 against each other: the chord stays, the middle sags by L (ry1 - ry2) / 8.
    Beam beam(1, 0.2);
    beam.snapshot.rotation[0] = {0, 0.01, 0};
    beam.snapshot.rotation[1] = {0, -0.01, 0};
    beam.view.scale = 50;
    beam.view.hinges = false;
    const auto lowest = [&] {
        const Image image = beam.draw();
        const Spot bar = spot(image, class_colours[0], 60);
        double low = 0;
        for (std::uint32_t x = image.width / 2 - 3; x < image.width / 2 + 3; ++x)
            for (std::uint32_t y = 0; y < image.height; ++y)
                if (!is_white(image.pixels[y * image.width + x])) low = largest_of(low, double(y));
        return std::pair{low, (bar.right - bar.left) / 10.0};
    };
    beam.bar().hinges = 3;  // at both ends: then the ends turn, and the member stays straight
    const auto [straight, pixels_per_metre] = lowest();
    const auto sag = [&] { return (lowest().first - straight) / pixels_per_metre; };
    beam.bar().hinges = 0;
    CHECK(std::abs(sag() - 50 * 10 * 0.02 / 8) < 0.05);
    // A hinge at one end: its slope is minus half of the other's.
    beam.bar().hinges = 1;
    CHECK(std::abs(sag() - 50 * 10 * 0.015 / 8) < 0.05);
}

TEST_CASE("the start is drawn as lines in grey", "[output]") {
    // Lines of little more than a pixel: between their colour and the paper's.
    const Colour ghost_line = {(ghost_colour[0] + 255) / 2, (ghost_colour[1] + 255) / 2, (ghost_colour[2] + 255) / 2};
    Beam beam(1, 0.1);
    beam.snapshot.displacement[0] = beam.snapshot.displacement[1] = {0, 0, -2};
    for (auto& p : beam.snapshot.points) p[2] = -2;
    CHECK(spot(beam.draw(), ghost_line, 20).n < 10);
    beam.view.ghost = true;
    const Image image = beam.draw();
    const Spot ghost = spot(image, ghost_line, 20), now = spot(image, class_colours[0], 60);
    CHECK(ghost.n > 300);
    CHECK(now.y - ghost.y > 1.8 * (now.right - now.left) / 10.0);
    // Over a thick member that has hardly moved it shows all the same.
    Beam thick(1, 2);
    const Image alone = thick.draw();
    thick.view.ghost = true;
    CHECK(spot(thick.draw(), ghost_colour, 60).n > spot(alone, ghost_colour, 60).n + 300);
}

TEST_CASE("a moment is drawn on the side in tension", "[output]") {
    Beam beam;
    beam.view.show = Show::Mx;
    beam.moment(4e4);
    Image image = beam.draw();
    Spot bar = spot(image, plain_bar, 30);
    CHECK(spot(image, plus_fill, 12).n > 1000);
    CHECK(spot(image, plus_fill, 12).y < bar.y - 5);  // Mx > 0: the fibres towards y, here upwards, are in tension
    CHECK(spot(image, minus_fill, 12).n < 20);
    beam.moment(-4e4);
    image = beam.draw();
    CHECK(spot(image, minus_fill, 12).n > 1000);
    CHECK(spot(image, minus_fill, 12).y > bar.y + 5);
    SECTION("linear between its ends: half of the area") {
        const long full = spot(image, minus_fill, 12).n;
        beam.bar().Mx[1] = 0;
        const Spot half = spot(beam.draw(), minus_fill, 12);
        CHECK(half.n < 0.6 * double(full));
        CHECK(half.n > 0.3 * double(full));
        CHECK(half.x < image.width / 2.0 - 20);
    }
    SECTION("My of a horizontal beam lies across, and does not show from the front") {
        beam.view.show = Show::My;
        for (double& m : beam.bar().My) m = 4e4;
        CHECK(spot(beam.draw(), plus_fill, 12).n < 20);
        beam.view.from = {0, 0, 1}, beam.view.up = {0, 1, 0};
        beam.view.box = {-1, 11, -4, 4, 0, 0};
        // The section's x axis is up x along = z x x = y; My > 0 puts the side away from x in tension.
        const Image top = beam.draw();
        CHECK(spot(top, plus_fill, 12).y > spot(top, plain_bar, 30).y + 5);
    }
    SECTION("with shear forces as slopes it bends: M = q x (L - x) / 2") {
        Bar& b = beam.snapshot.bars[0];
        b.Mx[0] = b.Mx[1] = 0;
        b.Qy[0] = 1e4, b.Qy[1] = -1e4;
        const Spot sagging = spot(beam.draw(), plus_fill, 12);
        CHECK(sagging.n > 1000);
        CHECK(std::abs(sagging.x - image.width / 2.0) < 8);
    }
    SECTION("its size may be that of several pictures") {
        const long full = spot(image, minus_fill, 12).n;
        beam.view.largest = 8e4;
        CHECK(std::abs(double(spot(beam.draw(), minus_fill, 12).n) / double(full) - 0.5) < 0.1);
    }
    SECTION("a diagram of nothing says so") {
        beam.view.show = Show::N;
        const Image none = beam.draw();
        CHECK(spot(none, plus_fill, 12).n + spot(none, minus_fill, 12).n < 20);
    }
}

TEST_CASE("a diagram's largest value is that of the peak, not of a station near it", "[output]") {
    Beam beam;
    Bar& b = beam.snapshot.bars[0];
    const double q = 1e4, M0 = 6e4;  // M = M0 + Q0 z - q z^2 / 2, 10 m long
    b.Mx[0] = M0, b.Mx[1] = 0;
    b.Qy[0] = q * 5 - M0 / 10, b.Qy[1] = -q * 5 - M0 / 10;
    beam.snapshot.loads = {{Load::force, -1, 0, -1, {{0, 0, q}, {0, 0, q}}}};
    beam.view.show = Show::Mx;
    FrameBox found;
    REQUIRE(said([&](char* error, int room) {
                return load<hinge_frame_box>("hinge_frame_box")(beam.snapshot, beam.view, &found, error, room);
            }) == "");
    CHECK(found.largest == Approx(M0 + b.Qy[0] * b.Qy[0] / (2 * q)).epsilon(1e-9));
}

TEST_CASE("a diagram is drawn over members that are wider than it", "[output]") {
    Beam beam(1, 4);
    beam.moment(4e4);
    beam.view.show = Show::Mx;
    CHECK(spot(beam.draw(), plus_fill, 12).n > 1000);
}

TEST_CASE("a value of a diagram stands once where members go on in each other, and noise has none", "[output]") {
    Beam beam(2, 0.1);
    beam.view.show = Show::Mx;
    const auto words = [&] { return spot(beam.draw(), plus_line, 60).n + spot(beam.draw(), minus_line, 60).n; };
    // The largest value is where both bars meet.
    Bar &first = beam.snapshot.bars[0], &second = beam.snapshot.bars[1];
    first.Mx[0] = second.Mx[1] = 3.9e4, first.Mx[1] = second.Mx[0] = 4e4;
    const long one = words();
    second.member = 2;
    CHECK(std::abs(words() - one) < 8);  // pixels; a second number has more
    // A member whose moments are zero but for rounding has no number, whatever the sign of what is left.
    second.Mx[0] = second.Mx[1] = 9e-9;
    const long same_sign = words();
    second.Mx[1] = -8e-9;
    CHECK(words() - same_sign < 8);
}

TEST_CASE("f_y has its colours along the element", "[output]") {
    Beam beam;
    Bar& b = beam.snapshot.bars[0];
    b.Mx[0] = 0, b.Mx[1] = 1e5, b.yield = 1;
    const Image image = beam.draw();
    // f_y = (x / L)^2 with only Mx: 0.2 is reached at 0.447 L, 0.8 at 0.894 L.
    const Spot low = spot(image, class_colours[0], 35), high = spot(image, class_colours[4], 35);
    const double left = low.left, length = high.right - left;
    CHECK(std::abs((low.right - left) / length - std::sqrt(0.2)) < 0.02);
    CHECK(std::abs((high.left - left) / length - std::sqrt(0.8)) < 0.02);
}

TEST_CASE("hinges are dots at their ends, with an area that goes with the plastic rotation", "[output]") {
    Beam beam(1, 0.05);
    beam.bar().hinges = 1;
    const auto dot = [&](double rotation) {
        beam.bar().rotation[0] = rotation;
        return spot(beam.draw(), class_colours[plastic_class], 70);
    };
    const Spot small = dot(0.05), most = dot(0.2), more = dot(5);
    CHECK(double(most.n) / double(small.n) == Approx(4).epsilon(0.35));
    CHECK(more.n == most.n);
    CHECK(dot(std::nan("")).n > 0);
    const Image image = beam.draw();
    CHECK(small.x < 0.2 * image.width);
    beam.bar().hinges = 2;
    CHECK(spot(beam.draw(), class_colours[plastic_class], 70).x > 0.8 * image.width);
    beam.bar().hinges = 4;
    CHECK(std::abs(spot(beam.draw(), class_colours[plastic_class], 70).x - image.width / 2.0) < 5);
    beam.view.hinges = false;
    CHECK(spot(beam.draw(), class_colours[plastic_class], 70).n == 0);
}

TEST_CASE("sections are drawn in their true size and shape", "[output]") {
    // Seen along the beam: an H of depth 2 m, width 1 m, web 0.2 m, flange 0.2 m has 0.72 of 2 m2.
    Beam beam;
    beam.view.from = {-1, 0, 0};
    beam.view.box = {5, 5, -1.5, 1.5, -1.5, 1.5};
    const auto area = [&](Shape shape) {
        beam.snapshot.shapes[0] = shape;
        const Image image = beam.draw();
        return double(image.count([](Rgb c) { return c[2] > 80 && c[0] < 70 && c[1] < 90; }));
    };
    const double box = area({Shape::rectangle, 1, 2, 0, 0});
    CHECK(area({Shape::h, 1, 2, 0.2, 0.2}) / box == Approx((2 * 0.2 + 1.6 * 0.2) / 2).epsilon(0.08));
    CHECK(area({Shape::round, 2, 2, 0, 0}) / box == Approx(3.1416 / 2).epsilon(0.03));
    CHECK(area({Shape::rectangle, 2, 1, 0, 0}) / box == Approx(1).epsilon(0.02));
    beam.bar().up = {0, 1, 0};  // lying on its side
    CHECK(area({Shape::rectangle, 1, 2, 0, 0}) / box == Approx(1).epsilon(0.02));
    const Spot lying = spot(beam.draw(), class_colours[0], 45);
    CHECK(lying.right - lying.left > 1.8 * (lying.bottom - lying.top));
}

TEST_CASE("supports and the ground are drawn", "[output]") {
    Beam beam(2, 0.2);
    beam.view.supports = true;
    CHECK(spot(beam.draw(), support_colour).n < 5);
    const auto drawn = [&](std::uint8_t held) {
        beam.snapshot.held[0] = held;
        return spot(beam.draw(), support_colour);
    };
    CHECK(drawn(63).n > 20);               // a plate behind the end
    CHECK(drawn(63).y - drawn(7).y < -3);  // pinned: a cone below
    CHECK(drawn(4).n > 20);                // a roller
    CHECK(drawn(4).n != drawn(7).n);
    CHECK(drawn(1).x < drawn(4).x - 3);  // held along x: from the side
    SECTION("what is held at all nodes, as in a plane model, is no support") {
        const std::uint8_t plane = 2 | 8 | 32;
        const Spot pinned = drawn(7);
        beam.snapshot.held.assign(3, plane);
        CHECK(spot(beam.draw(), support_colour).n < 5);
        CHECK(drawn(plane | 7).n == pinned.n);
    }
    SECTION("what the ends of a beam have in common is no plane") {
        beam.snapshot.held = {7, 6, 6};
        CHECK(spot(beam.draw(), support_colour).n > 2.5 * double(drawn(6).n) / 3);
        beam.snapshot.held = {7 | 8, 0, 6};
        const Spot both = spot(beam.draw(), support_colour);
        CHECK(both.right - both.left > 0.9 * (spot(beam.draw(), class_colours[0], 60).right - both.left));
    }
    SECTION("a plate stays as the member stood at the start") {
        const Spot before = drawn(63);
        for (auto& p : beam.snapshot.points) p = {p[0] * 0.6, 0, p[0] * 0.8};
        for (std::size_t i = 0; i < 3; ++i) {
            const double x = 5.0 * double(i);
            beam.snapshot.displacement[i] = {beam.snapshot.points[i][0] - x, 0, beam.snapshot.points[i][2]};
        }
        beam.view.box = {-1, 11, 0, 0, -1, 9};
        const Spot after = drawn(63);
        CHECK(after.bottom - after.top > 0.6 * (before.bottom - before.top));
        CHECK(after.right - after.left < 0.5 * (after.bottom - after.top));
    }
    SECTION("a node whose member has broken off keeps it") {
        beam.snapshot.held[0] = 63;
        beam.snapshot.points.push_back({0.5, 0, -2});
        beam.snapshot.displacement.push_back({0.5, 0, -2});
        beam.snapshot.rotation.push_back({0, 0, 0});
        beam.snapshot.is_virtual.push_back(1), beam.snapshot.held.push_back(0);
        beam.bar().point[0] = 3, beam.bar().state = BarState::broken;
        const auto support = [&] {
            beam.view.supports = false;
            const Image without = beam.draw();
            beam.view.supports = true;
            return beam.draw().pixels != without.pixels;
        };
        CHECK(support());
        beam.snapshot.groups = {"another"}, beam.snapshot.bars[1].member = 2, beam.snapshot.memberships = {{2, 0}};
        beam.view.groups = {0};  // without the broken member
        CHECK(!support());
    }
    SECTION("the ground does not hide them") {
        beam.view.from = {0, -1, 0.5};
        const Spot without = drawn(7);
        beam.snapshot.ground = {{{0, 0, 0.5}, {0, 0, 1}}};
        CHECK(drawn(7).n > 0.8 * double(without.n));
    }

    SECTION("floors, where all corners are at drawn members") {
        beam.snapshot.points[1][1] = 6;  // out of the line of the others
        beam.snapshot.displacement[1][1] = 6;
        beam.snapshot.floors = {{{0, 1, 2}}};
        const auto differs = [&] {
            beam.view.floors = true;
            const Image with = beam.draw();
            beam.view.floors = false;
            const Image without = beam.draw();
            int n = 0;
            for (std::size_t i = 0; i < with.pixels.size(); ++i) n += with.pixels[i] != without.pixels[i];
            return n;
        };
        CHECK(differs() > 200);
        beam.snapshot.bars.resize(1);
        CHECK(differs() == 0);
    }
    SECTION("ground") {
        beam.view.from = {-0.3, -1, 0.4};
        beam.snapshot.ground = {{{0, 0, -1}, {0, 0, 1}}};
        CHECK(spot(beam.draw(), ground_fill, 6).n > 500);
        beam.view.ground = false;
        CHECK(spot(beam.draw(), ground_fill, 6).n < 20);
    }
}

TEST_CASE("loads are arrows that end at the member", "[output]") {
    Beam beam(2, 0.8);
    const auto drawn = [&](std::vector<Load> loads) {
        beam.snapshot.loads = std::move(loads);
        return spot(beam.draw(), load_colour, 50);
    };
    const Load down{Load::force, 1, -1, -1, {{0, 0, -5e3}, {0, 0, 0}}};
    CHECK(drawn({down}).n == 0);
    beam.view.loads = true;
    const Spot one = drawn({down});
    const Spot bar = spot(beam.draw(), class_colours[0], 60);
    CHECK(one.n > 30);
    CHECK(one.bottom <= bar.top + 5);
    CHECK(std::abs(one.x - bar.x) < 25);
    const Load up{Load::force, 1, -1, -1, {{0, 0, 5e3}, {0, 0, 0}}};
    CHECK(drawn({up}).top >= bar.bottom - 5);
    const Spot spread = drawn({{Load::force, -1, 0, -1, {{0, 0, -1e3}, {0, 0, -1e3}}}});
    CHECK(spread.right - spread.left > 0.35 * (bar.right - bar.left));
    CHECK(spread.right < (bar.left + bar.right) / 2.0 + 25);
    CHECK(drawn({{Load::moment, 1, -1, -1, {{0, 5e3, 0}, {0, 0, 0}}}}).n > 30);
    CHECK(drawn({{Load::force, 1, -1, -1, {{0, 0, 0}, {0, 0, 0}}}}).n == 0);
}

TEST_CASE("groups and the mode of colours change a picture", "[output]") {
    Beam beam(2, 0.2);
    const Image plain = beam.draw();
    SECTION("groups by colour") {
        beam.snapshot.groups = {"beams"};
        for (Bar& b : beam.snapshot.bars) b.group = 0;
        beam.view.show = Show::group;
        CHECK(spot(beam.draw(), group_colours[0], 60).n > 1000);
    }
    SECTION("only some groups") {
        beam.snapshot.groups = {"a", "b"};
        beam.snapshot.bars[1].member = 2;
        beam.snapshot.memberships = {{1, 0}, {2, 1}};
        beam.view.groups = {1};
        const Spot right = spot(beam.draw(), class_colours[0], 60);
        CHECK(right.left > plain.width / 2.0 - 25);
    }
    SECTION("nothing but the structure") {
        beam.view.show = Show::nothing;
        CHECK(spot(beam.draw(), plain_bar, 40).n > 1000);
    }
}

TEST_CASE("a frame without what a view needs is refused", "[output]") {
    const Folder folder;
    Beam beam;
    beam.snapshot.displacement.clear();
    SECTION("scale") { beam.view.scale = 2; }
    SECTION("ghost") { beam.view.ghost = true; }
    SECTION("diagram") { beam.view.show = Show::Mx; }
    CHECK_THAT(render(folder / "a.png", beam.snapshot, beam.view), Catch::Contains("which this frame does not have"));
    CHECK(folder.files() == 0);
}

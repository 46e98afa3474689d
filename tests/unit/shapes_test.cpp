// Sections by their dimensions, and outlines with bars: properties against those of the outline found another way, what
// the exact domain and the shape agree in, and what is refused.
#include "section/shapes.h"

#include "core/errors.h"
#include "helpers.h"
#include "section/section_outline.h"
#include "section/shear.h"

using namespace hinge;

namespace {

/// Area and second moments of an outline about its centroid, by the triangles from there to its sides.
Vec3 by_triangles(const beam::Outline& outline) {
    Vec3 sum = Vec3::Zero();
    for (const auto& p : outline.polygons)
        for (std::size_t k = 0; k < p.corners.size(); ++k) {
            const auto &a = p.corners[k], &b = p.corners[(k + 1) % p.corners.size()];
            const double twice = (p.hole ? -1 : 1) * (a.x() * b.y() - b.x() * a.y());  // counterclockwise
            const auto second = [](double x, double y) { return (x * x + x * y + y * y) / 12; };
            sum += twice * Vec3(0.5, second(a.y(), b.y()), second(a.x(), b.x()));
        }
    return sum;
}

const std::pair<const char*, Shape> all_polygons[] = {
    {"solid", solid_shape({0.2, 0.3})},
    {"box", box_shape({.width = 0.2, .depth = 0.3, .web = 0.01, .flange = 0.016, .r = 0.03})},
    {"h", h_shape({.depth = 0.3, .width = 0.3, .web = 0.011, .flange = 0.019, .r = 0.027})},
    {"tapered", tapered_h_shape({.depth = 0.3, .width = 0.13, .web = 0.011, .flange = 0.016})},
    {"channel", channel_shape({.depth = 0.2, .width = 0.075, .web = 0.0085, .flange = 0.0115, .r = 0.0115})},
    {"angle", angle_shape({.depth = 0.15, .width = 0.1, .thickness = 0.012, .r = 0.012, .r_toe = 0.005})},
    {"double angle", double_angle_shape({.depth = 0.1, .width = 0.08, .thickness = 0.01, .gap = 0.012})},
    {"tee", tee_shape({.depth = 0.15, .width = 0.3, .web = 0.011, .flange = 0.019, .r = 0.027})},
};

}  // namespace

TEST_CASE("shapes: properties are those of the outline about its centroid, plastic moduli those of the exact domain") {
    for (const auto& [name, shape] : all_polygons) {
        INFO(name);
        const Section s = make_section(shape);
        const Vec3 of = by_triangles(s.outline->outline());
        CHECK(s.area == Approx(of[0]).epsilon(1e-4));
        CHECK(s.Ix == Approx(of[1]).epsilon(1e-4));
        CHECK(s.Iy == Approx(of[2]).epsilon(1e-4));
        CHECK(s.outline->outline().centroid().norm() < 1e-12);
        CHECK(s.outline->domain()->area() == Approx(s.plastic_area).epsilon(1e-9));
        CHECK(s.outline->domain()->moduli()[0] == Approx(s.Zx).epsilon(1e-7));
        CHECK(s.outline->domain()->moduli()[1] == Approx(s.Zy).epsilon(1e-7));
        CHECK(s.J > 0);
        CHECK((s.shear_area_x > 0 && s.shear_area_x < s.area && s.shear_area_y > 0 && s.shear_area_y < s.area));
    }
}

TEST_CASE("shapes: a ring is that of its circles") {
    const Section s = make_section(pipe_shape(0.2, 0.01)), round = make_section(round_shape(0.2));
    CHECK(s.area == Approx(test::pi * 0.19 * 0.01));
    CHECK(round.Ix == Approx(test::pi * std::pow(0.1, 4) / 4));
    CHECK(s.J == Approx(2 * s.Ix));
    CHECK(s.outline->domain()->area() == Approx(s.area));
}

TEST_CASE("shapes: impossible dimensions name the field and the limit") {
    CHECK_THROWS_WITH(([] { h_shape({.depth = 0.3, .width = 0.2, .web = 0.3, .flange = 0.02}); })(),
                      Catch::Contains("section: field 'web' is 0.3 m; must be below the width, 0.2 m"));
    CHECK_THROWS_WITH(([] { box_shape({.width = 0.2, .depth = 0.2, .web = 0.01, .flange = 0.1}); })(),
                      Catch::Contains("field 'flange' is 0.1 m"));
    CHECK_THROWS_WITH(([] { pipe_shape(0.2, 0.1, "the pipe"); })(), Catch::Contains("the pipe: field 'thickness'"));
}

TEST_CASE("outline: what is no section is refused") {
    using beam::make_section_outline;
    beam::Outline line, hollow, two;
    line.polygons = {{{{0, 0}, {1, 1}, {2, 2}}}};
    CHECK_THROWS_WITH(([&] { make_section_outline(line); })(), Catch::Contains("polygon 1: its area is 0 m^2"));
    hollow.circles = {{{0, 0}, 0.1, false}, {{0, 0}, 0.2, true}};
    CHECK_THROWS_WITH(([&] { make_section_outline(hollow); })(), Catch::Contains("the area must be above 0"));
    two.polygons = {{{{0, 0}, {1, 1}}}};
    CHECK_THROWS_WITH(([&] { make_section_outline(two); })(), Catch::Contains("has 2 corners"));
}

TEST_CASE("outline: bars lie in the concrete and are as strong") {
    const Shape column = solid_shape({0.4, 0.4});
    const auto with = [&](std::vector<beam::Reinforcement::Bar> bars) {
        make_section(column, beam::Reinforcement{30e6, std::move(bars), {}});
    };
    const auto bar = [](double x, double y, double compression = 400e6) {
        return beam::Reinforcement::Bar{{x, y}, 3e-4, 500e6, compression};
    };
    CHECK_THROWS_WITH(with({}), Catch::Contains("field 'bars' is empty"));
    CHECK_THROWS_WITH(with({bar(0.15, 0.15), bar(0.199, 0)}),
                      Catch::Contains("bar 2 at {0.199, 0} m is not within the outline"));
    CHECK_THROWS_WITH(with({bar(0.15, 0.15), bar(0.155, 0.15)}),
                      Catch::Contains("bar 2 at {0.155, 0.15} m overlaps bar 1"));
    CHECK_THROWS_WITH(with({bar(0.15, 0.15, 20e6)}), Catch::Contains("bar 1: field 'compression' is 20000000 Pa"));
    CHECK_NOTHROW(with({bar(0.15, 0.15), bar(-0.15, 0.15), bar(0.15, -0.15), bar(-0.15, -0.15)}));
}

TEST_CASE("a section of concrete has the strengths of its domain") {
    std::vector<beam::Reinforcement::Bar> bars;
    for (double x : {-0.15, 0.15})
        for (double y : {-0.15, 0.15}) bars.push_back({{x, y}, 3e-4, 500e6, 400e6});
    const Section s = make_section(solid_shape({0.4, 0.4}), beam::Reinforcement{30e6, bars, {}});
    const double bars_area = 4 * 3e-4, N = 30e6 * (0.16 - bars_area) + bars_area * 400e6;
    CHECK(*s.given.N0 == Approx(N));
    CHECK(s.outline->axial_range()[1] == Approx(bars_area * 500e6));
    CHECK(*s.given.Mx0 == Approx(*s.given.My0));
    CHECK(s.outline->moments(0, 0)[0] == Approx(*s.given.Mx0));
}

TEST_CASE("an outline of another area, and exact interaction without one, are refused") {
    Section s = make_section(solid_shape({0.2, 0.2}));
    s.area *= 1.05;
    CHECK_THROWS_WITH(([&] { complete_section(s); })(), Catch::Contains("may differ by 2 %"));
    Section bare;
    bare.interaction = Interaction::exact;
    CHECK_THROWS_WITH(([&] { complete_section(bare, "the beam"); })(),
                      Catch::Contains("the beam: field 'interaction'"));
}

TEST_CASE("shear: the walls that carry it are within the outline, and their area is that of the web") {
    const Section s = make_section(h_shape({.depth = 0.3, .width = 0.3, .web = 0.011, .flange = 0.019}));
    const auto carried = shear_carried(s);
    REQUIRE(carried);
    beam::Outline web;
    web.polygons = carried->walls[1];
    CHECK(web.area() == Approx(shear_properties(s).area[1]));
    CHECK(lost_by_shear(0.5) == 0);
    CHECK(lost_by_shear(1) == 1);
}

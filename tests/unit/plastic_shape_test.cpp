// Exact plastic moments beside an axial force: against a section cut into strips, and what is no known shape.
#include "section/plastic_shape.h"

#include <functional>
#include <numbers>

#include "section/section_outline.h"
#include "helpers.h"
#include "model/model.h"

using namespace hinge;

namespace {

/// M / M0 at N / N0 = n of a section whose breadth at a distance from the axis is given, from thin strips.
double by_strips(const std::function<double(double)>& breadth, double height, double n) {
    constexpr int strips = 200000;
    const double t = height / strips;
    double area = 0, modulus = 0;
    for (int i = 0; i < strips; ++i)
        area += breadth((i + 0.5) * t) * t, modulus += breadth((i + 0.5) * t) * (i + 0.5) * t * t;
    double within = 0, moment = 0;
    for (int i = 0; i < strips; ++i) {
        within += breadth((i + 0.5) * t) * t;
        if (within > n * area) moment += breadth((i + 0.5) * t) * (i + 0.5) * t * t;
    }
    return moment / modulus;
}

Section h(double d, double b, double tw, double tf) {
    Section s;
    s.shape = "h", s.depth = d, s.width = b, s.web = tw, s.flange = tf;
    const double di = d - 2 * tf;
    s.area = s.plastic_area = 2 * b * tf + di * tw;
    s.Zx = b * tf * (d - tf) + tw * di * di / 4, s.Zy = tf * b * b / 2 + di * tw * tw / 4;
    return s;
}
Section box(double d, double b, double tw, double tf) {
    Section s;
    s.shape = "box", s.depth = d, s.width = b;
    const double di = d - 2 * tf, bi = b - 2 * tw;
    s.area = s.plastic_area = b * d - bi * di;
    s.Zx = (b * d * d - bi * di * di) / 4, s.Zy = (d * b * b - di * bi * bi) / 4;
    return s;
}
Section pipe(double D, double t) {
    Section s;
    s.shape = "pipe", s.depth = s.width = D;
    const double i = D - 2 * t;
    s.area = s.plastic_area = std::numbers::pi / 4 * (D * D - i * i);
    s.Zx = s.Zy = (D * D * D - i * i * i) / 6;
    return s;
}

}  // namespace

TEST_CASE("plastic moments beside an axial force follow from the section's strips") {
    const double d = 0.3, b = 0.2, tw = 0.012, tf = 0.02;
    const auto of_h = PlasticShape::of(h(d, b, tw, tf)), of_box = PlasticShape::of(box(d, b, tw, tf)),
               of_pipe = PlasticShape::of(pipe(d, tf));
    REQUIRE(of_h);
    REQUIRE(of_box);
    REQUIRE(of_pipe);
    const auto chord = [](double r, double y) { return y < r ? 2 * std::sqrt(r * r - y * y) : 0.0; };
    for (double n : {0.05, 0.2, 0.3, 0.6, 0.9, 0.99}) {
        // strips of h / 200000 miss the edge of one strip: n is off by at most 1e-5 of what it is
        const auto near = [&](double value, double wanted) { REQUIRE(std::abs(value - wanted) < 3e-5); };
        near(of_h->moment(0, n), by_strips([&](double y) { return y < d / 2 - tf ? tw : b; }, d / 2, n));
        near(of_h->moment(1, n), by_strips([&](double x) { return x < tw / 2 ? d : 2 * tf; }, b / 2, n));
        near(of_box->moment(0, n), by_strips([&](double y) { return y < d / 2 - tf ? 2 * tw : b; }, d / 2, n));
        near(of_box->moment(1, n), by_strips([&](double x) { return x < b / 2 - tw ? 2 * tf : d; }, b / 2, n));
        near(of_pipe->moment(0, n),
             by_strips([&](double y) { return chord(d / 2, y) - chord(d / 2 - tf, y); }, d / 2, n));
        REQUIRE(of_pipe->moment(1, -n) == of_pipe->moment(0, n));
    }
    for (int axis : {0, 1}) {
        REQUIRE(of_h->moment(axis, 0) == 1);
        REQUIRE(of_h->moment(axis, 1) == 0);
    }
}

TEST_CASE("a rectangle has 1 - n^2, about both axes") {
    Section s;
    s.shape = "solid", s.width = 0.1, s.depth = 0.2;
    s.plastic_area = 0.02, s.Zx = 0.1 * 0.04 / 4, s.Zy = 0.2 * 0.01 / 4;
    const auto shape = PlasticShape::of(s);
    REQUIRE(shape);
    for (int axis : {0, 1})
        for (double n : {0.0, 0.3, 0.6, 0.9}) REQUIRE(std::abs(shape->moment(axis, n) - (1 - n * n)) < 1e-12);
}

namespace {

Section with_outline(beam::Outline outline) {
    Section s;
    s.plastic_area = 0.01, s.Zx = s.Zy = 1e-4;
    s.outline = std::make_shared<const beam::SectionOutline>(std::move(outline));
    return s;
}

beam::Outline::Polygon rectangle(double b, double d, bool hole) {
    return {{{-b / 2, -d / 2}, {b / 2, -d / 2}, {b / 2, d / 2}, {-b / 2, d / 2}}, hole};
}

}  // namespace

TEST_CASE("an outline with two axes of symmetry has the plastic moments of its strips") {
    const double d = 0.3, b = 0.2, t = 0.02, r = 0.05;
    beam::Outline tube, bored;
    tube.polygons = {rectangle(b, d, false), rectangle(b - 2 * t, d - 2 * t, true)};
    bored.polygons = {rectangle(b, d, false)};
    bored.circles = {{Eigen::Vector2d::Zero(), r, true}};
    std::reverse(tube.polygons[0].corners.begin(), tube.polygons[0].corners.end());  // in either direction of rotation
    const auto of_tube = PlasticShape::of(with_outline(tube)), of_bored = PlasticShape::of(with_outline(bored)),
               of_box = PlasticShape::of(box(d, b, t, t));
    REQUIRE(of_tube);
    REQUIRE(of_bored);
    REQUIRE(of_box);
    const auto chord = [&](double y) { return y < r ? 2 * std::sqrt(r * r - y * y) : 0.0; };
    for (double n : {0.05, 0.3, 0.6, 0.9}) {
        for (int axis : {0, 1}) REQUIRE(std::abs(of_tube->moment(axis, n) - of_box->moment(axis, n)) < 1e-12);
        const auto near = [&](double value, double wanted) { REQUIRE(std::abs(value - wanted) < 3e-5); };  // as above
        near(of_bored->moment(0, n), by_strips([&](double y) { return b - chord(y); }, d / 2, n));
        near(of_bored->moment(1, n), by_strips([&](double x) { return d - chord(x); }, b / 2, n));
    }
    REQUIRE(of_tube->moment(0, 0) == 1);
    REQUIRE(of_tube->moment(0, 1) == 0);
}

TEST_CASE("an outline without two axes of symmetry has no known shape") {
    beam::Outline tee, off;
    tee.polygons = {{{{-0.1, 0}, {0.1, 0}, {0, 0.2}}}};
    off.polygons = {rectangle(0.2, 0.3, false)};
    off.circles = {{{0.01, 0}, 0.05, true}};
    REQUIRE(!PlasticShape::of(with_outline(tee)));
    REQUIRE(!PlasticShape::of(with_outline(off)));
}

TEST_CASE("a section that has not the moduli of its shape has no known one") {
    Section general;
    general.plastic_area = 0.01, general.Zx = general.Zy = 1e-4, general.width = general.depth = 0.1;
    REQUIRE(!PlasticShape::of(general));
    for (Section s : {h(0.3, 0.2, 0.01, 0.02), box(0.3, 0.2, 0.01, 0.02), pipe(0.3, 0.01)}) {
        REQUIRE(PlasticShape::of(s));
        s.Zy *= 1.001;
        REQUIRE(!PlasticShape::of(s));
    }
    Section bare = h(0.3, 0.2, 0.01, 0.02);
    bare.plastic_area = bare.Zx = bare.Zy = 0;
    REQUIRE(!PlasticShape::of(bare));
}

// Exact plastic moments beside an axial force by formulas: those of the exact interaction, which
// plastic_domain_test.cpp holds against fibres; and what is no known shape.
#include "section/plastic_shape.h"

#include "section/plastic_domain.h"
#include "section/section_outline.h"
#include "helpers.h"
#include "outlines.h"
#include "model/model.h"

using namespace hinge;
using namespace hinge::test;

namespace {

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
    s.area = s.plastic_area = pi / 4 * (D * D - i * i);
    s.Zx = s.Zy = (D * D * D - i * i * i) / 6;
    return s;
}

}  // namespace

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

beam::Outline tube(double b, double d, double web, double flange) {
    beam::Outline o;
    o.polygons = {rectangle(b, d), rectangle(b - 2 * web, d - 2 * flange, true)};
    return o;
}
beam::Outline bored(double b, double d, double x) {
    beam::Outline o;
    o.polygons = {rectangle(b, d)};
    o.circles = {{{x, 0}, 0.05, true}};
    return o;
}

Section with_outline(beam::Outline outline) {
    Section s;
    s.plastic_area = 0.01, s.Zx = s.Zy = 1e-4;
    s.outline = std::make_shared<const beam::SectionOutline>(std::move(outline));
    return s;
}

}  // namespace

TEST_CASE("plastic moments beside an axial force are those of the exact interaction") {
    const double d = 0.3, b = 0.2, tw = 0.012, tf = 0.02;
    beam::Outline backwards = tube(b, d, tw, tf);
    std::reverse(backwards.polygons[0].corners.begin(), backwards.polygons[0].corners.end());
    const std::pair<Section, beam::Outline> shapes[] = {{h(d, b, tw, tf), h_outline(b, d, tw, tf)},
                                                        {box(d, b, tw, tf), tube(b, d, tw, tf)},
                                                        {pipe(d, tf), pipe_outline(d / 2, d / 2 - tf)},
                                                        {with_outline(backwards), tube(b, d, tw, tf)},
                                                        {with_outline(bored(b, d, 0)), bored(b, d, 0)}};
    for (const auto& [section, outline] : shapes) {
        INFO(section.shape);
        const auto shape = PlasticShape::of(section);
        REQUIRE(shape);
        const beam::PlasticDomain domain(outline);
        for (int axis : {0, 1}) {
            for (double n : {0.05, 0.2, 0.3, 0.6, 0.9, 0.99, -0.6})
                CHECK(shape->moment(axis, n) == Approx(domain.contour(n, axis * pi / 2)[axis]).epsilon(1e-9));
            CHECK(shape->moment(axis, 0) == 1);
            CHECK(shape->moment(axis, 1) == 0);
        }
    }
}

TEST_CASE("an outline without two axes of symmetry has no known shape") {
    beam::Outline tee;
    tee.polygons = {{{{-0.1, 0}, {0.1, 0}, {0, 0.2}}}};

    REQUIRE(!PlasticShape::of(with_outline(tee)));
    REQUIRE(!PlasticShape::of(with_outline(bored(0.2, 0.3, 0.01))));
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

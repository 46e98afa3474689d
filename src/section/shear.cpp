#include "section/shear.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "section/section_outline.h"

namespace hinge {
namespace {

constexpr double no_fillets = 0.01;  ///< of the web's area: less is rounding of the sizes
constexpr double alike = 0.15;       ///< walls of one thickness: rounded corners make their mean thicknesses differ
constexpr double small_shear = 0.5;  ///< of V0: up to that it takes nothing from the moment, EN 1993-1-1 6.2.8(2)

/// The hollow of a box from its area and moduli: size across x and along y, m.
struct Hollow {
    double between, clear;
};
Hollow hollow_of(const Section& s) {
    const double b = s.width, d = s.depth, hollow = b * d - s.plastic_area, clear = (b * d * d - 4 * s.Zx) / hollow;
    return {hollow / clear, clear};
}

/// EN 1993-1-1 6.2.6(3) of an H: that of a rolled one, where `fillets` are left of its area, with their radius; else
/// that of the web. m, m^2.
double area_of_web(double web, double flange, double clear, double fillets) {
    if (!(fillets > no_fillets * web * clear)) return web * clear;
    const double r = std::sqrt(fillets / (4 - std::numbers::pi));
    return web * clear + fillets + (web + 2 * r) * flange;
}

beam::Outline::Polygon rectangle(double x0, double x1, double y0, double y1) {
    return {.corners = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

}  // namespace

ShearProperties shear_properties(const Section& s) {
    ShearProperties out{{s.shear_area_x, s.shear_area_y}};
    const double A = s.plastic_area, b = s.width, d = s.depth;
    const auto all_in_it = [&](double area) {
        for (int i : {0, 1}) out.area[i] = area, out.share[i] = 1;
    };
    if (!s.walls[1].empty() && s.Zx > 0) {
        double modulus = 0;  // about the axis through the centroid
        for (const Section::Wall& w : s.walls[1])
            modulus += (w.x1 - w.x0) * 0.5 * (w.y1 * std::abs(w.y1) - w.y0 * std::abs(w.y0));
        out.share[1] = std::min(1.0, modulus / s.Zx), out.share[0] = 1;
    }
    if (s.shape == "solid" || s.shape == "round") all_in_it(A);
    if (s.shape == "pipe") all_in_it(2 * A / std::numbers::pi);
    if (s.shape == "angle") out.share[0] = out.share[1] = 1;  // both legs carry the shear along either axis
    if (s.shape == "h" && s.Zx > 0) {
        const double clear = d - 2 * s.flange, flanges = 2 * b * s.flange;
        out.area[0] = flanges;
        out.area[1] = area_of_web(s.web, s.flange, clear, A - flanges - s.web * clear);
        out.share[1] = s.web * clear * clear / 4 / s.Zx;
        out.share[0] = 1;  // the flanges carry the bending about y and the shear along x
    }
    if (s.shape == "box" && s.Zx > 0 && s.Zy > 0) {  // its hollow: plastic_shape.cpp
        const auto [between, clear] = hollow_of(s);
        const double web = (b - between) / 2, flange = (d - clear) / 2;
        const bool rolled = std::abs(web - flange) < alike * web;
        out.area[0] = rolled ? A * b / (b + d) : 2 * flange * between;
        out.area[1] = rolled ? A * d / (b + d) : 2 * web * clear;
        out.share[1] = (b - between) * d * d / 4 / s.Zx;
        out.share[0] = (d - clear) * b * b / 4 / s.Zy;
    }
    return out;
}

std::optional<beam::ShearCarried> shear_carried(const Section& s) {
    if (!s.outline || s.outline->concrete()) return {};
    beam::ShearCarried out;
    for (const int axis : {0, 1})
        for (const Section::Wall& w : s.walls[axis]) out.walls[axis].push_back(rectangle(w.x0, w.x1, w.y0, w.y1));
    if (!out.walls[0].empty() || !out.walls[1].empty()) return out;
    const double b = s.width, d = s.depth;
    const auto both_sides = [&](int axis, double x0, double x1, double y0, double y1) {
        out.walls[axis].push_back(rectangle(x0, x1, y0, y1));
        out.walls[axis].push_back(rectangle(-x1, -x0, -y1, -y0));
    };
    for (const char* whole : {"solid", "round", "pipe", "angle"})
        if (s.shape == whole) return out.whole = true, out;
    if (s.shape == "h" && s.web > 0 && s.flange > 0) {
        const double inner = d / 2 - s.flange;
        out.walls[1].push_back(rectangle(-s.web / 2, s.web / 2, -inner, inner));
        both_sides(0, -b / 2, b / 2, inner, d / 2);
        return out;
    }
    if (s.shape == "box" && s.Zx > 0 && s.Zy > 0) {
        const Hollow h = hollow_of(s);
        both_sides(1, h.between / 2, b / 2, -h.clear / 2, h.clear / 2);
        both_sides(0, -h.between / 2, h.between / 2, h.clear / 2, d / 2);
        return out;
    }
    return {};
}

double lost_by_shear(double v) { return v > small_shear ? std::min(1.0, (2 * v - 1) * (2 * v - 1)) : 0; }

double shear_left_by_torsion(const Section& s, double t) {
    return s.shape == "h" ? std::sqrt(std::max(0.0, 1 - t / 1.25)) : std::max(0.0, 1 - t);
}

}  // namespace hinge

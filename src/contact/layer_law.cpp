#include "contact/layer_law.h"

#include <algorithm>

namespace hinge::contact {
namespace {

/// The part of 0 to 1 in which a linear function is above zero.
struct Range {
    double from = 0, to = 1;
    void cut(double first, double last) {
        if (first <= 0 && last <= 0) from = to = 0;
        else if (first <= 0) from = std::max(from, first / (first - last));
        else if (last <= 0) to = std::min(to, first / (first - last));
        if (to < from) to = from;
    }
};

/// Integrals of (1 - x)^2, (1 - x) x and x^2 over a range.
struct Products {
    double first, mixed, last;
    explicit Products(const Range& r) {
        const auto cube = [](double x) { return x * x * x; };
        first = (cube(1 - r.from) - cube(1 - r.to)) / 3;
        last = (cube(r.to) - cube(r.from)) / 3;
        mixed = (r.to * r.to - r.from * r.from) / 2 - last;
    }
    double of(const double (&f)[2]) const { return first * f[0] * f[0] + 2 * mixed * f[0] * f[1] + last * f[1] * f[1]; }
};

}  // namespace

LayerPress press(const LayerPiece& piece, const LayerPlace& at, double touching) {
    LayerPress out;
    const double rise = at.lean[0], s = piece.stiffness;
    const double side = piece.width * piece.length * (1 - rise * rise);
    const double(&o)[2] = at.overlap;
    const double p[2] = {s * o[0] + piece.damping * at.rate[0], s * o[1] + piece.damping * at.rate[1]};
    Range inside;
    inside.cut(o[0], o[1]);
    const Products in(inside);
    const double of_side = 0.5 * s * in.of(o);
    out.stored = side * of_side;
    out.leaning[0] = -2 * rise * piece.width * piece.length * of_side;
    out.elastic[0] = s * side * (in.first * o[0] + in.mixed * o[1]);
    out.elastic[1] = s * side * (in.mixed * o[0] + in.last * o[1]);
    Range pressed = inside;
    pressed.cut(p[0], p[1]);
    const Products by(pressed);
    out.force[0] = side * (by.first * p[0] + by.mixed * p[1]);
    out.force[1] = side * (by.mixed * p[0] + by.last * p[1]);
    Range carries;
    carries.cut(o[0] + touching, o[1] + touching);
    const Products slope(touching > 0 ? carries : pressed);
    out.area[0] = side * slope.first, out.area[1] = side * slope.mixed, out.area[2] = side * slope.last;
    for (int i : {0, 1}) {
        const double face = piece.end_area[i] * std::max(0.0, at.lean[i]);
        if (!(face > 0) || !(o[i] + touching > 0)) continue;
        const double depth = std::max(0.0, o[i]), energy = 0.5 * s * depth * depth;
        out.stored += face * energy;
        out.elastic[i] += face * s * depth;
        out.leaning[i] += piece.end_area[i] * energy;
        if (depth > 0) out.force[i] += face * std::max(0.0, p[i]);
        if (touching > 0 || p[i] > 0) out.area[2 * i] += face;
    }
    return out;
}

}  // namespace hinge::contact

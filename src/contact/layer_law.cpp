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

/// Integrals of (1 - x)^2, (1 - x) x and x^2 times the width over a range.
struct Products {
    double first, mixed, last;
    Products(const Range& r, const double (&taper)[2]) {
        const auto cube = [](double x) { return x * x * x; };
        first = (cube(1 - r.from) - cube(1 - r.to)) / 3;
        last = (cube(r.to) - cube(r.from)) / 3;
        mixed = (r.to * r.to - r.from * r.from) / 2 - last;
        if (taper[0] == 1 && taper[1] == 1) return;
        const auto fourth = [](double x) { return x * x * x * x; };
        const double cube_of_first = (fourth(1 - r.from) - fourth(1 - r.to)) / 4,
                     cube_of_last = (fourth(r.to) - fourth(r.from)) / 4;
        const double more_first = first - cube_of_first, more_last = last - cube_of_last;  // (1-x)^2 x, (1-x) x^2
        first = taper[0] * cube_of_first + taper[1] * more_first;
        mixed = taper[0] * more_first + taper[1] * more_last;
        last = taper[0] * more_last + taper[1] * cube_of_last;
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
    const Products in(inside, piece.taper);
    const double of_side = 0.5 * s * in.of(o);
    out.stored = side * of_side;
    out.leaning[0] = -2 * rise * piece.width * piece.length * of_side;
    out.elastic[0] = s * side * (in.first * o[0] + in.mixed * o[1]);
    out.elastic[1] = s * side * (in.mixed * o[0] + in.last * o[1]);
    Range pressed = inside;
    pressed.cut(p[0], p[1]);
    const Products by(pressed, piece.taper);
    out.force[0] = side * (by.first * p[0] + by.mixed * p[1]);
    out.force[1] = side * (by.mixed * p[0] + by.last * p[1]);
    Range carries;
    carries.cut(o[0] + touching, o[1] + touching);
    const Products slope(touching > 0 ? carries : pressed, piece.taper);
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

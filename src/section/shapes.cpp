#include "section/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/errors.h"
#include "core/text.h"
#include "section/polygon.h"
#include "section/section_outline.h"

namespace hinge {
namespace {

using beam::Corners;

constexpr double pi = std::numbers::pi;
double square(double x) { return x * x; }

void must_be_below(const std::string& what, const char* field, double value, double limit, const char* name) {
    if (value >= limit)
        throw FieldError(what, field,
                         number_text(value, 10) + " m; must be below " + name + ", " + number_text(limit, 10) + " m");
}

void must_be_at_most(const std::string& what, const char* field, double value, double limit, const char* name) {
    if (value > limit * (1 + 1e-12))
        throw FieldError(what, field,
                         number_text(value, 10) + " m; must be at most " + name + ", " + number_text(limit, 10) + " m");
}

/// What a corner of radius r takes from its square: area; distance of its centroid from both sides; own second moment.
struct Spandrel {
    double area, e, I;
};
Spandrel spandrel(double r) {
    return {(1 - pi / 4) * (r * r), r * (10 - 3 * pi) / (12 - 3 * pi),
            std::pow(r, 4) * (1.0 / 3 - pi / 16 - 1 / (9 * (4 - pi)))};
}

/// Torsion constant of a b x d rectangle: the series of the Prandtl stress function, m^4.
double torsion_of_rectangle(double b, double d) {
    const double a = std::max(b, d), c = std::min(b, d);
    double sum = 0;
    for (int n = 1; n <= 39; n += 2) {
        const double e = std::exp(-n * pi * a / c);
        sum = sum + (1 - e) / (1 + e) / std::pow(n, 5);  // tanh(n pi a / 2c)
    }
    return a * std::pow(c, 3) * (1.0 / 3 - 64 / std::pow(pi, 5) * c / a * sum);
}

/// Fully plastic torque over shear yield stress of a rectangle: Nadai's sand-heap analogy, m^3.
double sand_heap(double b, double d) {
    const double a = std::max(b, d), c = std::min(b, d);
    return c * c * (3 * a - c) / 6;
}

/// Cowper's factor of a web of height h and thickness t between two flanges of breadth b, at Poisson's ratio 0.
/// m: area of the flanges over that of the web or webs; heights and breadths between the walls' middle planes.
double flanged_shear_factor(double m, double b, double h) {
    const double n = b / h;
    return 10 * square(1 + 3 * m) / (12 + 72 * m + 150 * (m * m) + 90 * std::pow(m, 3) + 30 * (n * n) * (m + m * m));
}

/// Torsion constant of an H with root fillets: El Darwish and Johnston (1965). The circle in the joint of web and
/// flange has the diameter D.
double torsion_of_rolled_h(double b, double d, double tw, double tf, double r) {
    const double D = (square(tf + r) + (r + tw / 4) * tw) / (2 * r + tf), w = tw / tf, q = r / tf;
    const double alpha = -0.042 + 0.2204 * w + 0.1355 * q - 0.0865 * q * w - 0.0725 * (w * w);
    return (2 * b * std::pow(tf, 3) + (d - 2 * tf) * std::pow(tw, 3)) / 3 + 2 * alpha * std::pow(D, 4) -
           0.42 * std::pow(tf, 4);
}

/// Part of the torsion constant that a joint of two walls adds: alpha D^4 of El Darwish and Johnston (1965).
double joint_of_walls(double alpha, double tw, double tf, double r) {
    return alpha * std::pow(2 * (3 * r + tw + tf - std::sqrt(2 * (2 * r + tw) * (2 * r + tf))), 4);
}

/// Properties of one polygon about its centroid, in axes x and y that are principal ones.
Shape shape_of_polygon(const char* kind, Corners corners, const Corners& walls, const std::vector<double>& t) {
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Eigen::Vector2d& p : corners) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const beam::AreaMoments m = beam::moments_of(corners);
    Shape out;
    Section& s = out.section;
    s.kind = s.shape = kind;
    s.width = high.x() - low.x(), s.depth = high.y() - low.y();
    s.area = s.plastic_area = m.A, s.Ix = m.yy, s.Iy = m.xx;
    s.shear_area_x = beam::shear_area(walls, t, 0), s.shear_area_y = beam::shear_area(walls, t, 1);
    s.Zx = beam::plastic_modulus(corners, 1), s.Zy = beam::plastic_modulus(corners, 0);
    out.outline.polygons = {{std::move(corners)}};
    return out;
}

Shape ring_shape(const char* kind, double outer, double inner) {
    const double area = pi / 4 * (outer * outer - inner * inner),
                 I = pi / 64 * (std::pow(outer, 4) - std::pow(inner, 4)),
                 Z = (std::pow(outer, 3) - std::pow(inner, 3)) / 6, m = inner / outer, q = square(1 + m * m);
    Shape out;
    Section& s = out.section;
    s.kind = s.shape = kind;
    s.width = s.depth = outer;
    s.area = s.plastic_area = area, s.Ix = s.Iy = I, s.J = 2 * I;
    s.shear_area_x = s.shear_area_y = area * 6 * q / (7 * q + 20 * (m * m));
    s.Zx = s.Zy = Z, s.Zz = pi / 2 * Z;
    out.outline.circles = {{Eigen::Vector2d::Zero(), outer / 2, false}};
    if (inner > 0) out.outline.circles.push_back({Eigen::Vector2d::Zero(), inner / 2, true});
    return out;
}

}  // namespace

Section make_section(Shape shape, std::optional<beam::Reinforcement> concrete, const std::string& what) {
    Section s = std::move(shape.section);
    if (concrete) s.kind = s.shape = "concrete", s.plastic_area = s.Zx = s.Zy = s.Zz = 0;
    s.outline = beam::make_section_outline(std::move(shape.outline), std::move(concrete), what);
    complete_section(s, what);
    return s;
}

Shape solid_shape(const SolidSizes& size) {
    const double b = size.width, d = size.depth;
    Shape out;
    Section& s = out.section;
    s.kind = s.shape = "solid";
    s.width = b, s.depth = d, s.area = s.plastic_area = b * d;
    s.Ix = b * std::pow(d, 3) / 12, s.Iy = d * std::pow(b, 3) / 12, s.J = torsion_of_rectangle(b, d);
    s.shear_area_x = s.shear_area_y = 5.0 / 6 * b * d;
    s.Zx = b * (d * d) / 4, s.Zy = d * (b * b) / 4, s.Zz = sand_heap(b, d);
    out.outline.polygons = {{beam::rectangle(b, d)}};
    return out;
}

Shape box_shape(const BoxSizes& size, const std::string& what) {
    const double b = size.width, d = size.depth, tw = size.web, tf = size.flange, r = size.r;
    must_be_below(what, "web", tw, b / 2, "half the width");
    must_be_below(what, "flange", tf, d / 2, "half the depth");
    const double bi = b - 2 * tw, di = d - 2 * tf, bm = b - tw, dm = d - tf;
    must_be_at_most(what, "r", r, std::min(b, d) / 2, "half the smaller side");
    const double ri = size.r_inner.value_or(std::max(r - std::max(tw, tf), 0.0));
    must_be_at_most(what, "r_inner", ri, std::min(bi, di) / 2, "half the smaller clear side");
    const double diagonal = std::sqrt(tw * tw + tf * tf);  // the material at a corner is least along its diagonal
    if (diagonal <= (std::sqrt(2.0) - 1) * (r - ri))
        throw FieldError(what, "r",
                         number_text(r, 10) + " m; with walls of " + number_text(std::max(tw, tf), 10) +
                             " m and the inner radius " + number_text(ri, 10) + " m the corners are cut through");
    const Spandrel o = spandrel(r), i = spandrel(ri);
    const auto I = [&](double across, double along, double across_i, double along_i) {
        return (across * std::pow(along, 3) - across_i * std::pow(along_i, 3)) / 12 -
               4 * (o.I + o.area * square(along / 2 - o.e)) + 4 * (i.I + i.area * square(along_i / 2 - i.e));
    };
    const auto Z = [&](double across, double along, double across_i, double along_i) {
        return (across * (along * along) - across_i * (along_i * along_i)) / 4 - 4 * o.area * (along / 2 - o.e) +
               4 * i.area * (along_i / 2 - i.e);
    };
    const double rm = (r + ri) / 2, within = bm * dm - (4 - pi) * (rm * rm);
    const double across = 2 * (bm - 2 * rm), along = 2 * (dm - 2 * rm), corners = 2 * pi * rm;
    double J = 4 * (within * within) / (across / tf + along / tw + corners * 2 / (tw + tf));
    if (r > 0) J = J + (across * std::pow(tf, 3) + along * std::pow(tw, 3) + corners * std::pow((tw + tf) / 2, 3)) / 3;
    const double area = b * d - bi * di - 4 * (o.area - i.area), webs = 2 * dm * tw, flanges = 2 * bm * tf;
    Shape out;
    Section& s = out.section;
    s.kind = s.shape = "box";
    s.width = b, s.depth = d, s.area = s.plastic_area = area, s.Ix = I(b, d, bi, di), s.Iy = I(d, b, di, bi), s.J = J;
    s.shear_area_x = area * flanged_shear_factor(webs / flanges, dm, bm);
    s.shear_area_y = area * flanged_shear_factor(flanges / webs, bm, dm);
    s.Zx = Z(b, d, bi, di), s.Zy = Z(d, b, di, bi), s.Zz = 2 * within * std::min(tw, tf);
    out.outline.polygons = {{beam::rectangle(b, d, r)}, {beam::rectangle(bi, di, ri), true}};
    return out;
}

Shape h_shape(const HSizes& size, const std::string& what) {
    const double b = size.width, d = size.depth, tw = size.web, tf = size.flange, r = size.r;
    must_be_below(what, "web", tw, b, "the width");
    must_be_below(what, "flange", tf, d / 2, "half the depth");
    const double di = d - 2 * tf, dm = d - tf;
    must_be_at_most(what, "r", r, di / 2, "half the clear depth between the flanges");
    must_be_at_most(what, "r", r, (b - tw) / 2, "the flange's part beside the web");
    const double plates = 2 * b * tf + di * tw;
    const Spandrel fillet = spandrel(r);
    const double area = plates + 4 * fillet.area, x = b / 2, y = d / 2, w = tw / 2, f = di / 2;
    Shape out;
    Section& s = out.section;
    s.kind = s.shape = "h";
    s.width = b, s.depth = d, s.web = tw, s.flange = tf, s.area = s.plastic_area = area;
    s.Ix = (b * std::pow(d, 3) - (b - tw) * std::pow(di, 3)) / 12 + 4 * (fillet.I + fillet.area * square(f - fillet.e));
    s.Iy = (2 * tf * std::pow(b, 3) + di * std::pow(tw, 3)) / 12 + 4 * (fillet.I + fillet.area * square(w + fillet.e));
    s.J = r > 0 ? torsion_of_rolled_h(b, d, tw, tf, r) : (2 * b * std::pow(tf, 3) + di * std::pow(tw, 3)) / 3;
    s.shear_area_x = 5.0 / 6 * 2 * b * tf;
    s.shear_area_y = plates * flanged_shear_factor(2 * b * tf / (dm * tw), b, dm);
    s.Zx = b * tf * dm + tw * (di * di) / 4 + 4 * fillet.area * (f - fillet.e);
    s.Zy = tf * (b * b) / 2 + di * (tw * tw) / 4 + 4 * fillet.area * (w + fillet.e);
    s.Zz = 2 * sand_heap(b, tf) + di * (tw * tw) / 2;
    out.outline.polygons = {{beam::rounded({{-x, -y},
                                            {x, -y},
                                            {x, -f},
                                            {w, -f, r},
                                            {w, f, r},
                                            {x, f},
                                            {x, y},
                                            {-x, y},
                                            {-x, f},
                                            {-w, f, r},
                                            {-w, -f, r},
                                            {-x, -f}})}};
    return out;
}

Shape tapered_h_shape(const HSizes& size, const std::string& what) {
    const double x = size.width / 2, y = size.depth / 2, w = size.web / 2;
    const double half = (x - w) / 12;  // of what the thickness changes by
    const double root = y - size.flange - half, toe = y - size.flange + half;
    const Corners corners = {{-x, -y}, {x, -y}, {x, -toe}, {w, -root}, {w, root},   {x, toe},
                             {x, y},   {-x, y}, {-x, toe}, {-w, root}, {-w, -root}, {-x, -toe}};
    const beam::AreaMoments m = beam::moments_of(corners);
    Shape out = h_shape({size.depth, size.width, size.web, size.flange}, what);
    Section& s = out.section;
    s.area = s.plastic_area = m.A, s.Ix = m.yy, s.Iy = m.xx;
    s.Zx = beam::plastic_modulus(corners, 1), s.Zy = beam::plastic_modulus(corners, 0);
    out.outline.polygons = {{corners}};
    return out;
}

Shape channel_shape(const ChannelSizes& size, const std::string& what) {
    const double b = size.width, d = size.depth, tw = size.web, tf = size.flange, r = size.r, r_toe = size.r_toe,
                 flange_at = size.flange_at.value_or(b / 2);
    must_be_below(what, "web", tw, b, "the width");
    must_be_below(what, "flange_at", flange_at, b, "the width");
    const double root = tf + size.slope * (flange_at - tw), toe = tf + size.slope * (flange_at - b);
    must_be_below(what, "flange", root, d / 2, "half the depth at the web");
    if (toe <= 0) throw FieldError(what, "slope", number_text(size.slope, 10) + "; the flanges end before their toes");
    must_be_at_most(what, "r", r, d / 2 - root, "half the clear depth between the flanges");
    must_be_at_most(what, "r_toe", r_toe, toe, "the flange's thickness at its toe");
    must_be_at_most(what, "r", r, b - tw - r_toe, "the flange's part beside the web, less r_toe");
    const Corners corners = beam::rounded({{0, -d / 2},
                                           {b, -d / 2},
                                           {b, toe - d / 2, r_toe},
                                           {tw, root - d / 2, r},
                                           {tw, d / 2 - root, r},
                                           {b, d / 2 - toe, r_toe},
                                           {b, d / 2},
                                           {0, d / 2}});
    const beam::AreaMoments m = beam::moments_of(corners);
    const double cx = m.x / m.A, w = tw / tf, q = r / tf, y = (d - tf) / 2;
    const double alpha = -0.0908 + 0.2621 * w + 0.1231 * q - 0.0752 * w * q - 0.0945 * (w * w);
    Shape out = shape_of_polygon("channel", beam::moved(corners, cx, m.y / m.A),
                                 {{b - cx, -y}, {tw / 2 - cx, -y}, {tw / 2 - cx, y}, {b - cx, y}}, {tf, tw, tf});
    Section& s = out.section;
    s.J = (2 * b * std::pow(tf, 3) + (d - 2 * tf) * std::pow(tw, 3)) / 3 + 2 * joint_of_walls(alpha, tw, tf, r) -
          0.42 * std::pow(tf, 4);
    s.Zz = 2 * sand_heap(b, tf) + (d - 2 * tf) * (tw * tw) / 2;
    s.walls[0] = {{-cx, b - cx, d / 2 - tf, d / 2}, {-cx, b - cx, -d / 2, tf - d / 2}};
    s.walls[1] = {{-cx, tw - cx, tf - d / 2, d / 2 - tf}};
    return out;
}

Shape angle_shape(const AngleSizes& size, const std::string& what) {
    const double b = size.width, d = size.depth, t = size.thickness, r = size.r, r_toe = size.r_toe,
                 shorter = std::min(b, d);
    must_be_below(what, "thickness", t, shorter, "the shorter leg");
    must_be_at_most(what, "r_toe", r_toe, t, "the thickness");
    must_be_at_most(what, "r", r, shorter - t - r_toe, "the shorter leg's clear length, less r_toe");
    const Corners corners = beam::rounded({{0, 0}, {b, 0}, {b, t, r_toe}, {t, t, r}, {t, d, r_toe}, {0, d}});
    const beam::AreaMoments m = beam::moments_of(corners);
    const double cx = m.x / m.A, cy = m.y / m.A;
    const double Ixx = m.yy - m.A * (cy * cy), Iyy = m.xx - m.A * (cx * cx), Ixy = m.xy - m.A * cx * cy;
    double turn = 0.5 * std::atan2(-2 * Ixy, Ixx - Iyy);  // from the leg along x to the axis of the larger moment
    if (std::cos(turn) * cx + std::sin(turn) * cy < 0) turn = turn + pi;
    Shape out = shape_of_polygon("angle", beam::moved(corners, cx, cy, turn),
                                 beam::moved({{b, t / 2}, {t / 2, t / 2}, {t / 2, d}}, cx, cy, turn), {t, t});
    const double t3 = std::pow(t, 3);
    out.section.J =
        (b * t3 + (d - t) * t3) / 3 + joint_of_walls(0.0768 + 0.0479 * r / t, t, t, r) - 0.21 * std::pow(t, 4);
    out.section.Zz = sand_heap(b, t) + (d - t) * (t * t) / 2;
    return out;
}

Shape double_angle_shape(const DoubleAngleSizes& size, const std::string& what) {
    const double h = size.depth, b = size.width, t = size.thickness, gap = size.gap;
    must_be_below(what, "thickness", t, std::min(h, b), "a leg");
    const Corners one = {{0, -h}, {t, -h}, {t, -t}, {b, -t}, {b, 0}, {0, 0}};  // the right one, legs down and right
    const beam::AreaMoments m = beam::moments_of(one);
    const double cx = m.x / m.A + gap / 2, cy = m.y / m.A;
    const Corners right = beam::moved(one, -gap / 2, cy), own = beam::moved(one, m.x / m.A, cy);
    Corners left;
    for (auto p = right.rbegin(); p != right.rend(); ++p) left.emplace_back(-p->x(), p->y());
    const beam::AreaMoments c = beam::moments_of(own);
    Shape out;
    Section& s = out.section;
    s.kind = s.shape = "double angle";
    s.width = 2 * b + gap, s.depth = h, s.area = s.plastic_area = 2 * m.A;
    s.Ix = 2 * c.yy, s.Iy = 2 * (c.xx + m.A * (cx * cx)), s.J = 2 * ((h + b - t) * std::pow(t, 3) / 3);
    s.shear_area_x = 5.0 / 3 * b * t, s.shear_area_y = 5.0 / 3 * h * t;
    s.Zx = 2 * beam::plastic_modulus(own, 1), s.Zy = 2 * m.A * cx;
    s.Zz = 2 * (sand_heap(h, t) + (b - t) * (t * t) / 2);
    out.outline.polygons = {{right}, {left}};
    return out;
}

Shape tee_shape(const TeeSizes& size, const std::string& what) {
    const double b = size.width, h = size.depth, tw = size.web, tf = size.flange, r = size.r, low = tf - h;
    must_be_below(what, "web", tw, b, "the width");
    must_be_below(what, "flange", tf, h, "the depth");
    Corners corners = beam::rounded({{-tw / 2, low},
                                     {tw / 2, low},
                                     {tw / 2, 0, r},
                                     {b / 2, 0},
                                     {b / 2, tf},
                                     {-b / 2, tf},
                                     {-b / 2, 0},
                                     {-tw / 2, 0, r}});
    const beam::AreaMoments m = beam::moments_of(corners);
    corners = beam::moved(corners, 0, m.y / m.A);
    const beam::AreaMoments c = beam::moments_of(corners);
    Shape out;
    Section& s = out.section;
    s.kind = s.shape = "tee";
    s.width = b, s.depth = h, s.area = s.plastic_area = m.A, s.Ix = c.yy, s.Iy = c.xx;
    s.J = (b * std::pow(tf, 3) + (h - tf) * std::pow(tw, 3)) / 3;
    s.shear_area_x = 5.0 / 6 * b * tf, s.shear_area_y = 5.0 / 6 * h * tw;
    s.Zx = beam::plastic_modulus(corners, 1), s.Zy = beam::plastic_modulus(corners, 0);
    s.Zz = sand_heap(b, tf) + (h - tf) * (tw * tw) / 2;
    out.outline.polygons = {{corners}};
    return out;
}

Shape pipe_shape(double diameter, double thickness, const std::string& what) {
    must_be_below(what, "thickness", thickness, diameter / 2, "half the diameter");
    return ring_shape("pipe", diameter, diameter - 2 * thickness);
}

Shape round_shape(double diameter) { return ring_shape("round", diameter, 0); }

}  // namespace hinge

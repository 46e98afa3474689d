#include "section/ultimate_states.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/lanes.h"

namespace hinge::beam {
namespace {

constexpr int turns = 144, depths = 192;  ///< of the states that are looked at
constexpr int around = 48, belts = 32;    ///< of the strains that are fitted
constexpr int most_blocks = 192;
static_assert(around * (belts - 1) + 2 <= most_blocks * lane_count);
constexpr double exponent = 128;  ///< support: seven squares and seven roots
/// Where the norm has its middle, on the way from no force to the middle of N. Errors are parts of the work about that
/// point: near no force, small moments have small ones.
constexpr double middle_of_norm = 0.3;
constexpr int rounds = 20;
constexpr double step_of_weights = 0.7;  ///< of their logarithm; 1 would go too far, since strains share points
constexpr double counts = 0.77;          ///< of the largest work: 0.77^128 is rounding
constexpr double whole_turn = 2 * std::numbers::pi;

/// Gauss's points and weights for the mean from -1 to 1: exact for polynomials of degree 11.
constexpr double gauss[6][2] = {{-0.932469514203152, 0.0856622461895852}, {-0.661209386466265, 0.1803807865240693},
                                {-0.238619186083197, 0.2339569672863455}, {0.238619186083197, 0.2339569672863455},
                                {0.661209386466265, 0.1803807865240693},  {0.932469514203152, 0.0856622461895852}};

/// Strain over the distance t along a direction: `slope` (t - t of the neutral axis), compression positive.
struct Plane {
    double zero, slope;
    double at(double t) const { return slope * (t - zero); }
};

double stress_of(double strain, const ConcreteStrains& s) {
    if (s.block > 0) return strain >= s.block ? 1 : 0;
    if (strain <= 0) return 0;
    return strain >= s.peak ? 1 : 1 - std::pow(1 - strain / s.peak, s.exponent);
}

/// Integrals of f(t), over an outline, of 1, of t, and of s across t.
struct Integrals {
    double area = 0, along = 0, across = 0;
};

/// Breadth and first moment of a polygon at t, by the edges that it crosses; both have the sign of its sense of
/// rotation.
std::array<double, 2> cut(const std::vector<Eigen::Vector2d>& corners, double t) {
    std::array<double, 2> sum = {0, 0};
    for (std::size_t i = 0, count = corners.size(); i < count; ++i) {
        const Eigen::Vector2d &a = corners[i], &b = corners[(i + 1) % count];
        if ((a.x() > t) == (b.x() > t)) continue;
        const double s = a.y() + (t - a.x()) / (b.x() - a.x()) * (b.y() - a.y()), sign = b.x() > a.x() ? -1 : 1;
        sum[0] += sign * s, sum[1] += sign * s * s / 2;
    }
    return sum;
}

double rotation_of(const std::vector<Eigen::Vector2d>& corners) {
    double twice = 0;
    for (std::size_t i = 0, count = corners.size(); i < count; ++i) {
        const Eigen::Vector2d &a = corners[i], &b = corners[(i + 1) % count];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return twice > 0 ? 1 : -1;
}

template <class Stress>
void add_polygon(const std::vector<Eigen::Vector2d>& corners, double sign, const std::array<double, 2>& kinks,
                 const Stress& stress, Integrals& sum) {
    std::vector<double> at(kinks.begin(), kinks.end());
    double low = INFINITY, high = -INFINITY;
    for (const Eigen::Vector2d& c : corners)
        at.push_back(c.x()), low = std::min(low, c.x()), high = std::max(high, c.x());
    std::sort(at.begin(), at.end());
    sign *= rotation_of(corners);
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        const double from = std::clamp(at[i], low, high), length = std::clamp(at[i + 1], low, high) - from;
        if (!(length > 0)) continue;
        for (const auto& [place, weight] : gauss) {
            const double t = from + 0.5 * (1 + place) * length, of = sign * weight * length * stress(t);
            const auto [breadth, moment] = cut(corners, t);
            sum.area += of * breadth, sum.along += of * breadth * t, sum.across += of * moment;
        }
    }
}

/// Strips of a circle at equal steps of their angle are smooth at its edge.
template <class Stress>
void add_circle(const Eigen::Vector2d& centre, double radius, double sign, const std::array<double, 2>& kinks,
                const Stress& stress, Integrals& sum) {
    std::vector<double> at = {-std::numbers::pi / 2, 0, std::numbers::pi / 2};
    for (double kink : kinks) at.push_back(std::asin(std::clamp((kink - centre.x()) / radius, -1.0, 1.0)));
    std::sort(at.begin(), at.end());
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        const double length = at[i + 1] - at[i];
        if (!(length > 0)) continue;
        for (const auto& [place, weight] : gauss) {
            const double angle = at[i] + 0.5 * (1 + place) * length, c = std::cos(angle),
                         t = centre.x() + radius * std::sin(angle),
                         of = sign * weight * length * 2 * radius * radius * c * c * stress(t);
            sum.area += of, sum.along += of * t, sum.across += of * centre.y();
        }
    }
}

/// (Mx, My, N) of a force of compression at a place.
Vec3 pressed(double force, const Eigen::Vector2d& at) { return -force * Vec3(at.y(), -at.x(), 1); }

Vec3 all_yield(const Reinforcement& concrete) {
    Vec3 sum = Vec3::Zero();
    for (const Reinforcement::Bar& bar : concrete.bars) sum += pressed(-bar.tension * bar.area, bar.centre);
    return sum;
}

/// Unit strains all round: both ends of N, and belts between them, of which every second one is turned by half a step.
/// Eight in a row are neighbours, four of two belts, so that a block of points counts or does not.
std::vector<Vec3> strains_to_fit() {
    std::vector<Vec3> list;
    for (int belt = 1; belt < belts; belt += 2)
        for (int first = 0; first < around; first += 4)
            for (int of = belt; of < std::min(belt + 2, belts); ++of)
                for (int i = first; i < first + 4; ++i) {
                    const double up = std::numbers::pi * of / belts - std::numbers::pi / 2,
                                 angle = whole_turn * (i + 0.5 * (of % 2)) / around;
                    list.emplace_back(std::cos(up) * std::cos(angle), std::cos(up) * std::sin(angle), std::sin(up));
                }
    list.emplace_back(0, 0, 1);
    list.emplace_back(0, 0, -1);
    return list;
}

}  // namespace

Vec3 UltimateStates::forces(const Outline& outline, const Reinforcement& concrete, const ConcreteStrains& strains,
                            double angle, double depth) {
    const Eigen::Vector2d to(std::cos(angle), std::sin(angle)), side(-to.y(), to.x());
    const auto turned = [&](const Eigen::Vector2d& p) { return Eigen::Vector2d(p.dot(to), p.dot(side)); };
    double low = INFINITY, high = -INFINITY;
    for (const Outline::Polygon& p : outline.polygons)
        for (const Eigen::Vector2d& c : p.corners) low = std::min(low, c.dot(to)), high = std::max(high, c.dot(to));
    for (const Outline::Circle& c : outline.circles)
        low = std::min(low, c.centre.dot(to) - c.radius), high = std::max(high, c.centre.dot(to) + c.radius);
    const double whole = high - low, pivot = 1 - strains.peak / strains.ultimate;
    const Plane plane = {high - depth,
                         depth <= whole ? strains.ultimate / depth : strains.peak / (depth - pivot * whole)};
    const auto stress = [&](double t) { return concrete.concrete * stress_of(plane.at(t), strains); };
    const std::array<double, 2> kinks = {plane.zero + (strains.block > 0 ? strains.block / plane.slope : 0),
                                         plane.zero + strains.peak / plane.slope};
    Integrals sum;
    for (const Outline::Polygon& p : outline.polygons) {
        std::vector<Eigen::Vector2d> corners;
        for (const Eigen::Vector2d& c : p.corners) corners.push_back(turned(c));
        add_polygon(corners, p.hole ? -1 : 1, kinks, stress, sum);
    }
    for (const Outline::Circle& c : outline.circles)
        add_circle(turned(c.centre), c.radius, c.hole ? -1 : 1, kinks, stress, sum);
    Vec3 out(-(sum.along * to.y() + sum.across * side.y()), sum.along * to.x() + sum.across * side.x(), -sum.area);
    for (const Reinforcement::Bar& bar : concrete.bars) {
        const double t = bar.centre.dot(to), of_bar = strains.bars * plane.at(t);
        out += pressed((std::clamp(of_bar, -bar.tension, bar.compression) - stress(t)) * bar.area, bar.centre);
    }
    return out;
}

UltimateStates::UltimateStates(const Outline& outline, const Reinforcement& concrete, const ConcreteStrains& strains) {
    double reach = 0;
    for (const Outline::Polygon& p : outline.polygons)
        for (const Eigen::Vector2d& c : p.corners) reach = std::max(reach, c.norm());
    for (const Outline::Circle& c : outline.circles) reach = std::max(reach, c.centre.norm() + c.radius);
    const Vec3 tension = all_yield(concrete), compression = forces(outline, concrete, strains, 0, 1e6 * reach);
    std::vector<Vec3> states = {tension, compression};
    for (int i = 0; i < turns; ++i)
        for (int k = 0; k < depths; ++k)
            states.push_back(forces(outline, concrete, strains, whole_turn * i / turns,
                                    reach * std::tan(std::numbers::pi / 2 * (k + 0.5) / depths)));
    centre_ = middle_of_norm * 0.5 * (tension + compression);
    strength_.setZero();
    for (Vec3& q : states) q -= centre_, strength_ = strength_.cwiseMax(q.cwiseAbs());
    for (Vec3& q : states) q = q.cwiseQuotient(strength_);
    centre_ = centre_.cwiseQuotient(strength_);
    const std::vector<Vec3> to = strains_to_fit();
    std::vector<double> work;
    for (const Vec3& v : to) {
        const Vec3& most = *std::max_element(states.begin(), states.end(),
                                             [&](const Vec3& a, const Vec3& b) { return a.dot(v) < b.dot(v); });
        work.push_back(most.dot(v));
        x_.push_back(most[0]), y_.push_back(most[1]), n_.push_back(most[2]), weight_.push_back(0.1);
    }
    while (x_.size() % lane_count != 0)
        for (std::vector<double>* list : {&x_, &y_, &n_, &weight_}) list->push_back(0);
    find_middles();
    fit(to, work);
    match_ends(centre_[2] + work[work.size() - 2], centre_[2] - work.back());
}

void UltimateStates::find_middles() {
    for (std::vector<double>& list : middle_) list.clear();
    for (std::size_t i = 0; i < x_.size(); i += lane_count) {
        Vec3 middle = Vec3::Zero();
        double radius = 0;
        const auto at = [&](std::size_t k) { return Vec3(x_[k], y_[k], n_[k]); };
        for (std::size_t k = i; k < i + lane_count; ++k) middle += at(k) / lane_count;
        for (std::size_t k = i; k < i + lane_count; ++k) radius = std::max(radius, (at(k) - middle).norm());
        for (int c = 0; c < 3; ++c) middle_[c].push_back(middle[c]);
        middle_[3].push_back(radius);
    }
    while (middle_[0].size() % lane_count != 0)
        for (std::vector<double>& list : middle_) list.push_back(0);
}

/// The weights by which the surface has this work of the strains.
void UltimateStates::fit(const std::vector<Vec3>& to, const std::vector<double>& work) {
    std::vector<double> times(to.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < to.size(); ++i) {
            Vec3 point;
            const double h = support(to[i], point) - centre_.dot(to[i]);
            times[i] = std::pow(work[i] / h, step_of_weights * exponent);
        }
        for (std::size_t i = 0; i < to.size(); ++i) weight_[i] *= times[i];
    }
}

/// Stretches N so that both ends of the surface have the axial forces of the states.
void UltimateStates::match_ends(double tension, double compression) {
    Vec3 point;
    const double high = support({0, 0, 1}, point), low = -support({0, 0, -1}, point),
                 by = (tension - compression) / (high - low);
    for (double& n : n_) n *= by;
    centre_[2] = by * (centre_[2] - low) + compression;
    find_middles();
}

double UltimateStates::support(const Vec3& v, Vec3& point, Mat3* curvature) const {
    const auto load = [](const double* from) -> Lanes { return *reinterpret_cast<const LanesAnywhere*>(from); };
    const auto c = [](double a) { return spread(a, Lanes{}); };
    const Lanes vx = c(v[0]), vy = c(v[1]), vn = c(v[2]), none = c(0), size = c(v.norm());
    // of blocks: the work of their middles, and the most that one of their points may have
    const int blocks = int(x_.size()) / lane_count, of_blocks = int(middle_[0].size());
    double bound[most_blocks], largest = 0;
    for (int i = 0; i < of_blocks; i += lane_count) {
        const Lanes work = load(&middle_[0][i]) * vx + load(&middle_[1][i]) * vy + load(&middle_[2][i]) * vn,
                    most = work + load(&middle_[3][i]) * size;
        for (int k = 0; k < lane_count; ++k) bound[i + k] = most[k], largest = std::max(largest, work[k]);
    }
    const Lanes by = c(1 / largest), least = c(counts);
    // sums of w t^128; of w t^127 q; of w t^126 q q^T
    Lanes S = none, Gx = none, Gy = none, Gn = none, Hxx = none, Hxy = none, Hxn = none, Hyy = none, Hyn = none,
          Hnn = none;
    for (int block = 0; block < blocks; ++block) {
        if (bound[block] < counts * largest) continue;
        const int i = block * lane_count;
        const Lanes x = load(&x_[i]), y = load(&y_[i]), n = load(&n_[i]);
        const Lanes over = (x * vx + y * vy + n * vn) * by, t = over > least ? over : none;
        const Lanes t2 = t * t, t4 = t2 * t2, t8 = t4 * t4, t16 = t8 * t8, t32 = t16 * t16, t64 = t32 * t32;
        const Lanes to_126 = load(&weight_[i]) * t2 * t4 * t8 * t16 * t32 * t64, to_127 = to_126 * t;
        S += to_127 * t;
        Gx += to_127 * x, Gy += to_127 * y, Gn += to_127 * n;
        const Lanes of_x = to_126 * x, of_y = to_126 * y;
        Hxx += of_x * x, Hxy += of_x * y, Hxn += of_x * n, Hyy += of_y * y, Hyn += of_y * n, Hnn += to_126 * n * n;
    }
    const double sum = sum_of(S);
    double root = sum;
    for (int i = 0; i < 7; ++i) root = std::sqrt(root);
    const Vec3 slope = root / sum * Vec3(sum_of(Gx), sum_of(Gy), sum_of(Gn));
    point = centre_ + slope;
    if (curvature) {
        const double xx = sum_of(Hxx), xy = sum_of(Hxy), xn = sum_of(Hxn), yy = sum_of(Hyy), yn = sum_of(Hyn),
                     nn = sum_of(Hnn);
        Mat3& out = *curvature;
        out << xx, xy, xn, xy, yy, yn, xn, yn, nn;
        out = (exponent - 1) / (largest * root) * (root * root / sum * out - slope * slope.transpose());
    }
    return point.dot(v);
}

}  // namespace hinge::beam

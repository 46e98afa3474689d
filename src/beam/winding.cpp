#include "beam/winding.h"

#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>

namespace hinge::beam {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double far_twist = pi / 1.2;                ///< rad: 150 degrees, where the passage ends
constexpr double long_mean = 0.35, short_mean = 0.2;  ///< of the mean y axis: the passage for ends that fold
/// - cos of an end's rotation in the frame of corotation.h, 150 to 170 degrees: the passage before its rotation vector
/// turns over at 180.
constexpr double far_end = 0.86602540378443865, farthest_end = 0.98480775301220806;
constexpr int directions = 9;  ///< of the chord, of spin 1 and of spin 2, in space

/// A number and its derivatives. T is double, or itself a number with derivatives: then there are second ones.
template <class T>
struct Dual {
    T value{};
    std::array<T, directions> by{};
    Dual() = default;
    Dual(double v) : value(v) {}

    friend Dual operator+(const Dual& a, const Dual& b) {
        return made(a.value + b.value, [&](int i) { return a.by[i] + b.by[i]; });
    }
    friend Dual operator-(const Dual& a, const Dual& b) {
        return made(a.value - b.value, [&](int i) { return a.by[i] - b.by[i]; });
    }
    friend Dual operator*(const Dual& a, const Dual& b) {
        return made(a.value * b.value, [&](int i) { return a.value * b.by[i] + a.by[i] * b.value; });
    }
    friend Dual operator/(const Dual& a, const Dual& b) {
        const T one = T(1) / b.value, ratio = a.value * one;
        return made(ratio, [&](int i) { return one * (a.by[i] - ratio * b.by[i]); });
    }
    friend Dual sqrt(const Dual& a) {
        using std::sqrt;
        const T root = sqrt(a.value), slope = T(0.5) / root;
        return made(root, [&](int i) { return slope * a.by[i]; });
    }
    friend Dual sin(const Dual& a) {
        using std::cos, std::sin;
        const T slope = cos(a.value);
        return made(sin(a.value), [&](int i) { return slope * a.by[i]; });
    }
    friend Dual cos(const Dual& a) {
        using std::cos, std::sin;
        const T slope = sin(a.value);
        return made(cos(a.value), [&](int i) { return T(-1) * slope * a.by[i]; });
    }
    friend Dual atan2(const Dual& y, const Dual& x) {
        using std::atan2;
        const T one = T(1) / (x.value * x.value + y.value * y.value), of_y = one * x.value, of_x = one * y.value;
        return made(atan2(y.value, x.value), [&](int i) { return of_y * y.by[i] - of_x * x.by[i]; });
    }

private:
    template <class F>
    static Dual made(const T& value, F derivative) {
        Dual r;
        r.value = value;
        for (int i = 0; i < directions; ++i) r.by[i] = derivative(i);
        return r;
    }
};
using First = Dual<double>;
using Second = Dual<First>;

double plain(double a) { return a; }
template <class T>
double plain(const Dual<T>& a) {
    return plain(a.value);
}

template <class T>
Dual<T> spread(double a, const Dual<T>&) {  // as core/lanes.h has it for the kernels of corotation.h
    return a;
}
using hinge::spread;

template <class S>
struct Pose {
    Triple<S> chord;
    Triad<S> node[2];
};

/// Angle / sine of an angle of 0 to pi: sine_squared is its sine's square.
template <class S>
S angle_over_sine(const S& sine_squared, const S& cosine) {
    if (plain(cosine) > 0.98) {  // in powers of 1 - cosine
        S sum = 1, term = 1;
        for (int n = 0; n < 9; ++n) {
            term = term * (S(1) - cosine) * S((n + 1.0) / (2 * n + 3));
            sum = sum + term;
        }
        return sum;
    }
    using std::atan2, std::sqrt;
    const S sine = sqrt(sine_squared);
    return atan2(sine, cosine) / sine;
}

/// 0 at `from`, 1 at `to` and beyond it; first and second derivative without a jump.
template <class S>
S passage(const S& x, double from, double to) {
    const S t = (x - S(from)) * S(1 / (to - from));
    if (plain(t) <= 0) return 0;
    if (plain(t) >= 1) return 1;
    return t * t * t * (S(10) - t * (S(15) - S(6) * t));
}

template <class S>
struct Measured {
    S d[6];
    S share, twist;
    Triad<S> frame;  ///< of the measure of this file
    double open;
};

/// d[0] to d[3] and d[5] as corotation.h has them; y_mean: the mean y axis across the chord, not of length one.
template <class S>
Triad<S> near_measure(const Pose<S>& at, const Triple<S>& z, const Triple<S>& x_mean, const S& length, S d[6]) {
    Triad<S> f;
    f.z = z;
    f.x = (S(1) / length) * x_mean;
    f.y = cross(f.z, f.x);
    Triple<S> theta[2];
    for (int i = 0; i < 2; ++i) {
        const Triad<S>& n = at.node[i];
        const S half = 0.5;
        const Triple<S> v = {half * (dot(f.z, n.y) - dot(f.y, n.z)), half * (dot(f.x, n.z) - dot(f.z, n.x)),
                             half * (dot(f.y, n.x) - dot(f.x, n.y))};
        const S cosine = half * (dot(f.x, n.x) + dot(f.y, n.y) + dot(f.z, n.z) - S(1));
        theta[i] = angle_over_sine(dot(v, v), cosine) * v;
        d[i] = theta[i].x;
        d[2 + i] = theta[i].y;
    }
    d[5] = theta[1].z - theta[0].z;
    return f;
}

/// Twist from end 1 to end 2, on the turn nearest to `last`, and the frame that stands half way between the ends; how
/// far the ends are from pointing backwards.
template <class S>
void measure_twist(const Pose<S>& at, const Triple<S>& z, double last, Measured<S>& m) {
    using std::atan2, std::cos, std::sin, std::sqrt;
    // any axes across the chord, to measure the two twists from
    const double across[3] = {std::fabs(plain(z.x)), std::fabs(plain(z.y)), std::fabs(plain(z.z))};
    const bool use_x = across[0] <= across[1] && across[0] <= across[2], use_y = !use_x && across[1] <= across[2];
    const Triple<S> aside = {use_x ? 1.0 : 0.0, use_y ? 1.0 : 0.0, use_x || use_y ? 0.0 : 1.0};
    const Triple<S> gx0 = cross(aside, z);
    const Triple<S> gx = (S(1) / sqrt(dot(gx0, gx0))) * gx0, gy = cross(z, gx);
    S c[2], s[2];  // (1 + cos(swing)) times cosine and sine of the twist
    m.open = 2;
    for (int i = 0; i < 2; ++i) {
        const Triad<S>& n = at.node[i];
        c[i] = dot(gx, n.x) + dot(gy, n.y);
        s[i] = dot(gy, n.x) - dot(gx, n.y);
        m.open = std::fmin(m.open, 1 + plain(dot(z, n.z)));
    }
    const S twist = atan2(s[1] * c[0] - c[1] * s[0], c[1] * c[0] + s[1] * s[0]);
    m.twist = twist + S(2 * pi * std::round((last - plain(twist)) / (2 * pi)));
    const S middle = atan2(s[0], c[0]) + S(0.5) * m.twist;
    const S cosine = cos(middle), sine = sin(middle);
    m.frame.x = cosine * gx + sine * gy;
    m.frame.y = cross(z, m.frame.x);
    m.frame.z = z;
}

/// The share of the measure of corotation.h: 1 while the element is hardly twisted and its ends are not folded, 0 far
/// beyond. mean: squared length of the mean axis x_mean.
template <class S>
S share_of_near(const Pose<S>& at, const Triple<S>& z, const Triple<S>& x_mean, const S& mean, const S& twist) {
    using std::sqrt;
    const S one = 1;
    S near = (one - passage(plain(twist) < 0 ? S(-1) * twist : twist, remembered_twist, far_twist)) *
             (one - passage(mean, long_mean * long_mean, short_mean * short_mean));
    if (plain(near) > 0) {
        const Triple<S> x = (one / sqrt(mean)) * x_mean, y = cross(z, x);
        for (const Triad<S>& n : at.node)
            near = near *
                   (one - passage(S(-0.5) * (dot(x, n.x) + dot(y, n.y) + dot(z, n.z) - one), far_end, farthest_end));
    }
    return near;
}

/// Bending rotations of the ends against the chord, with the twist taken out.
template <class S>
void measure_swings(const Pose<S>& at, const Triple<S>& z, Measured<S>& m) {
    for (int i = 0; i < 2; ++i) {
        const Triple<S>& n = at.node[i].z;
        const S x = dot(m.frame.x, n), y = dot(m.frame.y, n), along = dot(z, n);
        const S factor = angle_over_sine(x * x + y * y, along);
        m.d[i] = S(-1) * factor * y;
        m.d[2 + i] = factor * x;
    }
}

template <class S>
Measured<S> measure(const Pose<S>& at, double L, double last) {
    using std::sqrt;
    Measured<S> m;
    const S length = sqrt(dot(at.chord, at.chord));
    const Triple<S> z = (S(1) / length) * at.chord;
    measure_twist(at, z, last, m);

    const Triple<S> y_mean = S(0.5) * (at.node[0].y + at.node[1].y), x_mean = cross(y_mean, z);
    const S mean = dot(x_mean, x_mean), one = 1;
    m.share = one - share_of_near(at, z, x_mean, mean, m.twist);

    const S left = one - m.share;
    measure_swings(at, z, m);
    m.d[4] = length - S(L);
    m.d[5] = m.twist;
    if (plain(m.share) < 1) {
        S d[6];
        const S mean_length = sqrt(mean);
        const Triad<S> frame = near_measure(at, z, x_mean, mean_length, d);
        for (int i : {0, 1, 2, 3, 5}) m.d[i] = m.share * m.d[i] + left * d[i];
        if constexpr (std::is_same_v<S, double>) {  // the frame passes as well
            const double angle = m.share * std::atan2(dot(frame.y, m.frame.x), dot(frame.x, m.frame.x));
            m.frame.x = std::cos(angle) * frame.x + std::sin(angle) * frame.y;
            m.frame.y = cross(z, m.frame.x);
        }
    }
    return m;
}

/// The pose moved by chord and spins: the numbers in `by` are zero, their derivatives are not.
template <class S>
Pose<S> moved(const Winding& w, const std::array<std::array<S, directions>, 2>& by, int times) {
    Pose<S> at;
    at.chord = {w.chord.x, w.chord.y, w.chord.z};
    Quadruple<S> node[2], axes = {w.axes.w, w.axes.x, w.axes.y, w.axes.z};
    for (int i = 0; i < 2; ++i) node[i] = {w.node[i].w, w.node[i].x, w.node[i].y, w.node[i].z};
    for (int k = 0; k < times; ++k) {  // one on top of the other
        at.chord = at.chord + Triple<S>{by[k][0], by[k][1], by[k][2]};
        for (int i = 0; i < 2; ++i) {
            const S half = 0.5;
            const S* spin = &by[k][3 + 3 * i];
            node[i] = product({S(1), half * spin[0], half * spin[1], half * spin[2]}, node[i]);
        }
    }
    for (int i = 0; i < 2; ++i) at.node[i] = rotated_triad(node[i], axes);
    return at;
}

/// Nodal degrees of freedom [u1 t1 u2 t2] from chord and spins, and the sign of each.
constexpr int from[12] = {0, 1, 2, 3, 4, 5, 0, 1, 2, 6, 7, 8};
constexpr double sign[12] = {-1, -1, -1, 1, 1, 1, 1, 1, 1, 1, 1, 1};

}  // namespace

bool wind(Winding& w) {
    const Measured<double> m = measure(moved<double>(w, {}, 0), w.L, w.last);
    w.share = m.share;
    w.twist = m.twist;
    w.frame = m.frame;
    w.open = m.open;
    for (int i = 0; i < 6; ++i) w.d[i] = m.d[i];
    return w.share > 0;
}

Eigen::Matrix<double, 6, 12> rates(const Winding& w) {
    std::array<std::array<First, directions>, 2> by{};
    for (int i = 0; i < directions; ++i) by[0][i].by[i] = 1;
    const Measured<First> m = measure(moved(w, by, 1), w.L, w.last);
    Eigen::Matrix<double, 6, 12> T;
    for (int r = 0; r < 6; ++r)
        for (int j = 0; j < 12; ++j) T(r, j) = sign[j] * m.d[r].by[from[j]];
    return T;
}

Mat12 tangent(const Winding& w, const Vec6& p, const Mat6& k, bool geometric) {
    if (!geometric) {
        const Eigen::Matrix<double, 6, 12> T = rates(w);
        return T.transpose() * (k * T);
    }
    std::array<std::array<Second, directions>, 2> by{};
    for (int i = 0; i < directions; ++i) by[0][i].by[i] = 1, by[1][i].value.by[i] = 1;
    const Measured<Second> m = measure(moved(w, by, 2), w.L, w.last);
    Eigen::Matrix<double, 6, 12> T;
    for (int r = 0; r < 6; ++r)
        for (int j = 0; j < 12; ++j) T(r, j) = sign[j] * m.d[r].value.by[from[j]];
    Mat12 K = T.transpose() * (k * T);
    for (int r = 0; r < 6; ++r)
        for (int i = 0; i < 12; ++i)
            for (int j = 0; j < 12; ++j) K(i, j) += p[r] * sign[i] * sign[j] * m.d[r].by[from[j]].by[from[i]];
    return K;
}

}  // namespace hinge::beam

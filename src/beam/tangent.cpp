#include "beam/tangent.h"

#include "beam/timoshenko.h"

namespace hinge::beam {
namespace {

using SpinRows = Eigen::Matrix<double, 3, 12>;

Vec3 eigen(const Triple<double>& a) { return {a.x, a.y, a.z}; }

/// eta'(t)/t for eta of inverse_tangent_coefficient, t^2 = q.
double inverse_tangent_slope(double q) {
    if (q < 0.09)
        return 1.0 / 360 +
               q * (1.0 / 7560 +
                    q * (1.0 / 201600 + q * (1.0 / 5987520 + q * (691.0 / 130767436800.0 + q / 6227020800.0))));
    const double t = std::sqrt(q), s = std::sin(t / 2);
    return (t * (t + std::sin(t)) - 8 * s * s) / (4 * q * q * s * s);
}

}  // namespace

Mat3 inverse_tangent(const Vec3& t) {
    const Mat3 S = skew(t);
    return Mat3::Identity() - 0.5 * S + inverse_tangent_coefficient(t.squaredNorm()) * S * S;
}

Mat3 inverse_tangent_derivative(const Vec3& t, const Vec3& m) {
    const double q = t.squaredNorm();
    return -0.5 * skew(m) +
           inverse_tangent_coefficient(q) * (t.dot(m) * Mat3::Identity() + t * m.transpose() - 2 * m * t.transpose()) +
           inverse_tangent_slope(q) * t.cross(t.cross(m)) * t.transpose();
}

namespace {

using Row = Eigen::Matrix<double, 1, 12>;
using Rates = Eigen::Matrix<double, 6, 12>;

/// Spin of the element's frame, in its own axes; columns [u1 t1 u2 t2].
struct FrameSpin {
    double slope;  ///< of the mean y axis: its z over its y component
    SpinRows spin;
};

[[gnu::always_inline]] inline FrameSpin frame_spin(const ElementFrame<double>& place) {
    const double l = place.length, py = place.y_mean_y;
    FrameSpin f{place.y_mean_z / py, SpinRows::Zero()};
    f.spin(0, 1) = 1 / l;
    f.spin(0, 7) = -1 / l;
    f.spin(1, 0) = -1 / l;
    f.spin(1, 6) = 1 / l;
    f.spin.row(2) = f.slope * f.spin.row(1);
    for (int i = 0; i < 2; ++i) {
        f.spin(2, 6 * i + 5) += place.y[i].y / (2 * py);
        f.spin(2, 6 * i + 4) -= place.y[i].z / (2 * py);
    }
    return f;
}

/// Spin of each node relative to the frame, H of its rotation vector, and the rate H spin of that vector.
struct NodeRotations {
    SpinRows relative[2], rate[2];
    Mat3 H[2];
};

[[gnu::always_inline]] inline NodeRotations node_rotations(const ElementFrame<double>& place, const SpinRows& spin) {
    NodeRotations n;
    for (int i = 0; i < 2; ++i) {
        n.relative[i] = -spin;
        n.relative[i].block<3, 3>(0, 6 * i + 3) += Mat3::Identity();
        n.H[i] = inverse_tangent(eigen(place.theta[i]));
        n.rate[i] = n.H[i] * n.relative[i];
    }
    return n;
}

/// T: the rates of the deformation d.
[[gnu::always_inline]] inline Rates deformation_rates(const NodeRotations& nodes) {
    Rates T;
    T.row(0) = nodes.rate[0].row(0);
    T.row(1) = nodes.rate[1].row(0);
    T.row(2) = nodes.rate[0].row(1);
    T.row(3) = nodes.rate[1].row(1);
    T.row(4).setZero();
    T(4, 2) = -1;
    T(4, 8) = 1;
    T.row(5) = nodes.rate[1].row(2) - nodes.rate[0].row(2);
    return T;
}

/// Adds the derivative of T^T at constant forces p: of the end forces, and of the moments at the nodes. dl: rate of the
/// length.
[[gnu::always_inline]] inline void add_geometric(Mat12& K, const ElementFrame<double>& place, const Vec6& p,
                                                 const FrameSpin& of, const NodeRotations& nodes, const Row& dl) {
    const double l = place.length, py = place.y_mean_y, slope = of.slope;
    const Vec3 m[2] = {{p[0], p[2], -p[5]}, {p[1], p[3], p[5]}};
    const Vec3 mu[2] = {nodes.H[0].transpose() * m[0], nodes.H[1].transpose() * m[1]};
    SpinRows dmu[2], dy[2];
    for (int i = 0; i < 2; ++i) {
        dmu[i] = inverse_tangent_derivative(eigen(place.theta[i]), m[i]) * nodes.rate[i];
        dy[i] = -skew(eigen(place.y[i])) * nodes.relative[i];
    }
    const Vec3 sum = mu[0] + mu[1];
    const SpinRows dsum = dmu[0] + dmu[1];
    const Row dpy = 0.5 * (dy[0].row(1) + dy[1].row(1)), dpz = 0.5 * (dy[0].row(2) + dy[1].row(2));
    const Row dslope = (dpz - slope * dpy) / py;
    const Vec3 end = {-(sum.y() + slope * sum.z()) / l, sum.x() / l, p[4]};
    SpinRows dend;
    dend.row(0) = -(dsum.row(1) + slope * dsum.row(2) + sum.z() * dslope) / l - end.x() / l * dl;
    dend.row(1) = dsum.row(0) / l - end.y() / l * dl;
    dend.row(2).setZero();
    const SpinRows force = dend - skew(end) * of.spin;
    K.block<3, 12>(0, 0) -= force;
    K.block<3, 12>(6, 0) += force;
    for (int i = 0; i < 2; ++i) {
        const double ay = place.y[i].y / (2 * py), az = place.y[i].z / (2 * py);
        const Vec3 n = mu[i] + Vec3(0, az * sum.z(), -ay * sum.z());
        SpinRows dn = dmu[i];
        dn.row(1) += az * dsum.row(2) + sum.z() * (0.5 * dy[i].row(2) - az * dpy) / py;
        dn.row(2) -= ay * dsum.row(2) + sum.z() * (0.5 * dy[i].row(1) - ay * dpy) / py;
        K.block<3, 12>(6 * i + 3, 0) += dn - skew(n) * of.spin;
    }
}

/// From the frame's axes to those of space.
[[gnu::always_inline]] inline void turn_to_space(Mat12& K, const ElementFrame<double>& place) {
    Mat3 E;
    E << eigen(place.frame.x), eigen(place.frame.y), eigen(place.frame.z);
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) {
            const Mat3 block = K.block<3, 3>(3 * r, 3 * c);
            K.block<3, 3>(3 * r, 3 * c) = E * block * E.transpose();
        }
}

}  // namespace

Mat12 tangent(const ElementFrame<double>& place, const Vec6& p, const Mat6& k, bool geometric) {
    const FrameSpin of = frame_spin(place);
    const NodeRotations nodes = node_rotations(place, of.spin);
    const Rates T = deformation_rates(nodes);
    // lazyProduct: at this size plain loops beat the packed product
    const Rates kT = k.lazyProduct(T);
    Mat12 K = T.transpose().lazyProduct(kT);
    if (geometric) add_geometric(K, place, p, of, nodes, T.row(4));
    turn_to_space(K, place);
    return K;
}

Mat12 linear_tangent(const Mat3& axes, double L, const Mat6& k) {
    Eigen::Matrix<double, 6, 12> T = linear_deformation(L);
    for (int b = 0; b < 4; ++b) T.block<6, 3>(0, 3 * b) = (T.block<6, 3>(0, 3 * b) * axes).eval();
    return T.transpose() * k * T;
}

}  // namespace hinge::beam

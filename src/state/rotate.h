// Updates all nodes' rotations by rotation vectors, and finds these vectors, eight at a time.
#pragma once

#include <vector>

#include "core/lanes.h"
#include "core/rotation.h"

namespace hinge {

/// Computes to[i] = rotated(by[i], from[i]) for first <= i < end, with the same bits.
inline void rotate_all(const std::vector<Vec3>& by, const std::vector<Quat>& from, std::vector<Quat>& to,
                       std::size_t first, std::size_t end) {
    constexpr int n = lane_count;
    const std::size_t whole = first + (end - first) / n * n;
    const auto c = [](double x) { return spread(x, Lanes{}); };
    for (std::size_t i = first; i < whole; i += n) {
        Lanes t[n], q[n];
        transpose_rows<3>(by[i].data(), n, t);
        const Lanes &tx = t[0], &ty = t[1], &tz = t[2];
        const Lanes h = c(0.25) * (tx * tx + ty * ty + tz * tz);
        if (any_not_below(h, 2e-4)) {
            for (int k = 0; k < n; ++k) to[i + k] = rotated(by[i + k], from[i + k]);
            continue;
        }
        const Lanes cosine = c(1) - h * (c(1.0 / 2) - h * (c(1.0 / 24) - h * c(1.0 / 720)));
        const Lanes s = c(0.5) - h * (c(1.0 / 12) - h * (c(1.0 / 240) - h * c(1.0 / 10080)));
        transpose_rows<4>(from[i].coeffs().data(), n, q);
        const Lanes &qx = q[0], &qy = q[1], &qz = q[2], &qw = q[3];
        const Lanes x = s * tx, y = s * ty, z = s * tz;
        const Lanes w = cosine * qw - x * qx - y * qy - z * qz, rx = cosine * qx + x * qw + y * qz - z * qy,
                    ry = cosine * qy - x * qz + y * qw + z * qx, rz = cosine * qz + x * qy - y * qx + z * qw;
        const Lanes scale = c(1.5) - c(0.5) * ((rx * rx + ry * ry) + (rz * rz + w * w));
        const Lanes rotation_by[n] = {scale * rx, scale * ry, scale * rz, scale * w};
        transpose(rotation_by, q);
        for (int k = 0; k < n; ++k) store_row<4>(to[i + k].coeffs().data(), q[k]);
    }
    for (std::size_t i = whole; i < end; ++i) to[i] = rotated(by[i], from[i]);
}

/// Computes by[i] = rotation_vector(to[i] * from[i].conjugate()), rad, for first <= i < end. Vectors below 0.06 rad are
/// computed by the series of the arcsine, which leaves 1e-18 of them out.
inline void find_rotations(const std::vector<Quat>& from, const std::vector<Quat>& to, std::vector<Vec3>& by,
                           std::size_t first, std::size_t end) {
    constexpr int n = lane_count;
    const std::size_t whole = first + (end - first) / n * n;
    const auto c = [](double x) { return spread(x, Lanes{}); };
    const auto one = [&](std::size_t i) { by[i] = rotation_vector(to[i] * from[i].conjugate()); };
    for (std::size_t i = first; i < whole; i += n) {
        Lanes f[n], t[n], out[n] = {};
        transpose_rows<4>(from[i].coeffs().data(), n, f);
        transpose_rows<4>(to[i].coeffs().data(), n, t);
        const Lanes w = t[3] * f[3] + t[0] * f[0] + t[1] * f[1] + t[2] * f[2];
        out[0] = t[0] * f[3] - t[3] * f[0] + t[2] * f[1] - t[1] * f[2];
        out[1] = t[1] * f[3] - t[3] * f[1] + t[0] * f[2] - t[2] * f[0];
        out[2] = t[2] * f[3] - t[3] * f[2] + t[1] * f[0] - t[0] * f[1];
        const Lanes h = out[0] * out[0] + out[1] * out[1] + out[2] * out[2];
        if (any_not_below(h, 1e-3)) {
            for (int k = 0; k < n; ++k) one(i + k);
            continue;
        }
        const Lanes sign = w < c(0) ? c(-2) : c(2);
        const Lanes times =
            sign * (c(1) + h * (c(1.0 / 6) +
                                h * (c(3.0 / 40) + h * (c(5.0 / 112) + h * (c(35.0 / 1152) + h * c(63.0 / 2816))))));
        for (int k = 0; k < 3; ++k) out[k] *= times;
        Lanes rows[n];
        transpose(out, rows);
        for (int k = 0; k < n; ++k) store_row<3>(by[i + k].data(), rows[k]);
    }
    for (std::size_t i = whole; i < end; ++i) one(i);
}

}  // namespace hinge

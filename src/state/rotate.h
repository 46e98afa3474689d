// Updates all nodes' rotations by rotation vectors, eight at a time.
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

}  // namespace hinge

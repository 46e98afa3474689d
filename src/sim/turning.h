// All nodes' rotations moved on by rotation vectors, eight at a time.
#pragma once

#include <vector>

#include "beam/lanes.h"
#include "core/rotation.h"

namespace hinge {

/// to[i] = turned(by[i], from[i]) for every i, with the same bits.
inline void turn_all(const std::vector<Vec3>& by, const std::vector<Quat>& from, std::vector<Quat>& to) {
    using beam::Lanes;
    constexpr int n = beam::lane_count;
    const std::size_t whole = by.size() / n * n;
    const auto c = [](double x) { return beam::spread(x, Lanes{}); };
    constexpr int in_row[n] = {0, 1, 2, 3, 4, 5, 6, 7};
    for (std::size_t i = 0; i < whole; i += n) {
        const double* v = by[i].data();
        const Lanes tx = beam::pick(v, in_row, 3), ty = beam::pick(v + 1, in_row, 3), tz = beam::pick(v + 2, in_row, 3);
        const Lanes h = c(0.25) * (tx * tx + ty * ty + tz * tz);
        if (beam::any_not_below(h, 2e-4)) {
            for (int k = 0; k < n; ++k) to[i + k] = turned(by[i + k], from[i + k]);
            continue;
        }
        const Lanes cosine = c(1) - h * (c(1.0 / 2) - h * (c(1.0 / 24) - h * c(1.0 / 720)));
        const Lanes s = c(0.5) - h * (c(1.0 / 12) - h * (c(1.0 / 240) - h * c(1.0 / 10080)));
        const double* q = from[i].coeffs().data();
        const Lanes qx = beam::pick(q, in_row, 4), qy = beam::pick(q + 1, in_row, 4), qz = beam::pick(q + 2, in_row, 4), qw = beam::pick(q + 3, in_row, 4);
        const Lanes x = s * tx, y = s * ty, z = s * tz;
        const Lanes w = cosine * qw - x * qx - y * qy - z * qz, rx = cosine * qx + x * qw + y * qz - z * qy,
                    ry = cosine * qy - x * qz + y * qw + z * qx, rz = cosine * qz + x * qy - y * qx + z * qw;
        const Lanes scale = c(1.5) - c(0.5) * ((rx * rx + ry * ry) + (rz * rz + w * w));
        double* out = to[i].coeffs().data();
        beam::put(out, in_row, 4, scale * rx);
        beam::put(out + 1, in_row, 4, scale * ry);
        beam::put(out + 2, in_row, 4, scale * rz);
        beam::put(out + 3, in_row, 4, scale * w);
    }
    for (std::size_t i = whole; i < by.size(); ++i) to[i] = turned(by[i], from[i]);
}

}  // namespace hinge

#include "effects/member_load_portions.h"

#include <algorithm>

#include "effects/clamped_member.h"

namespace hinge {
namespace {

constexpr double as_one = 1e-9;  ///< of an element's length: a load so near to a node acts on it

}  // namespace

Vec3 force_per_length(const MemberLoad& load, int end, const Vec3& along) {
    const Vec3& q = load.force[end];
    return load.axes != LoadAxes::projected || q.isZero(0) ? q : Vec3(q.cross(along).norm() / q.norm() * q);
}

Stretch stretch_of(const MemberLoad& load, double begin, double end, const Vec3& along) {
    Stretch s{std::max(begin, load.from), std::min(end, load.to), {}, {}};
    const Vec3 force[2] = {force_per_length(load, 0, along), force_per_length(load, 1, along)};
    const double place[2] = {s.from, s.to};
    for (int k : {0, 1}) {
        const double part = load.is_partial() ? (place[k] - load.from) / (load.to - load.from) : place[k];
        s.force[k] = (1 - part) * force[0] + part * force[1];
        s.moment[k] = (1 - part) * load.moment[0] + part * load.moment[1];
    }
    return s;
}

int element_at(double at, int n) { return std::min(n - 1, int(at * n + as_one)); }
double place_in(int element, double at, int n) {
    const double eta = at * n - element;
    return eta < as_one ? 0 : eta > 1 - as_one ? 1 : eta;
}
bool is_on_node(const MemberLoad& load, int n) {
    if (load.spread()) return false;
    const double eta = place_in(element_at(load.at, n), load.at, n);
    return eta == 0 || eta == 1;
}

std::vector<Portion> portions(const MemberLoad& load, int n, double length, const Vec3& along) {
    std::vector<Portion> list;
    if (!load.spread()) {
        const int element = element_at(load.at, n);
        list.push_back({element, place_in(element, load.at, n), load.at, load.force[0], load.moment[0]});
        return list;
    }
    if (load.is_partial()) {
        for (int i = 0; i < n; ++i) {
            const Stretch s = stretch_of(load, double(i) / n, (i + 1.0) / n, along);
            for (int k = 0; k < 3 && s.to > s.from; ++k) {
                const double part = gauss_point[k], xi = s.from + part * (s.to - s.from),
                             metres = gauss_weight[k] * length * (s.to - s.from);
                list.push_back({i, xi * n - i, xi, metres * ((1 - part) * s.force[0] + part * s.force[1]),
                                metres * ((1 - part) * s.moment[0] + part * s.moment[1])});
            }
        }
        return list;
    }
    const Vec3 force[2] = {force_per_length(load, 0, along), force_per_length(load, 1, along)};
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k) {
            const double xi = (i + gauss_point[k]) / n, part = gauss_weight[k] * length / n;
            list.push_back({i, gauss_point[k], xi, part * ((1 - xi) * force[0] + xi * force[1]),
                            part * ((1 - xi) * load.moment[0] + xi * load.moment[1])});
        }
    return list;
}

std::vector<Portion> portions_of_pair(const MemberLoad& load, double begin, double width, double length,
                                      const Vec3& along) {
    constexpr int rows = 3;
    std::vector<Portion> list;
    for (int i = 0; i < 2 * rows; ++i) {
        const double half = begin + width * (i / rows) / 2;
        const Stretch whole = stretch_of(load, half, half + width / 2, along);
        if (!(whole.to > whole.from)) continue;
        const double step = (whole.to - whole.from) / rows, from = whole.from + (i % rows) * step;
        const Stretch s = stretch_of(load, from, from + step, along);
        for (int k = 0; k < 3; ++k) {
            const double part = gauss_point[k], metres = gauss_weight[k] * length * (s.to - s.from);
            list.push_back({0, 0, (s.from + part * (s.to - s.from) - begin) / width,
                            metres * ((1 - part) * s.force[0] + part * s.force[1]),
                            metres * ((1 - part) * s.moment[0] + part * s.moment[1])});
        }
    }
    return list;
}

}  // namespace hinge

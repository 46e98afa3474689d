// Curves cut at the frame of a plot.
#include "output/clip.h"

#include <algorithm>
#include <cmath>

namespace hinge::output {
namespace {

Pixel between(const Pixel& p, const Pixel& q, double share) {
    return {static_cast<float>(p[0] + share * (double(q[0]) - p[0])),
            static_cast<float>(p[1] + share * (double(q[1]) - p[1]))};
}

/// The shares of the way from p to q between which it is inside (Liang and Barsky); false: nowhere.
bool inside(const Pixel& p, const Pixel& q, const Box& box, double& from, double& to) {
    from = 0, to = 1;
    const double dx = double(q[0]) - p[0], dy = double(q[1]) - p[1];
    const double way[4] = {-dx, dx, -dy, dy};
    const double room[4] = {p[0] - box.left, box.right - p[0], p[1] - box.bottom, box.top - p[1]};
    for (int i = 0; i < 4; ++i) {
        if (way[i] == 0) {
            if (room[i] < 0) return false;
        } else if (way[i] < 0) {
            from = std::max(from, room[i] / way[i]);
        } else {
            to = std::min(to, room[i] / way[i]);
        }
    }
    return from <= to;
}

}  // namespace

double shared_area(const Box& a, const Box& b) {
    const double w = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double h = std::min(a.top, b.top) - std::max(a.bottom, b.bottom);
    return w > 0 && h > 0 ? w * h : 0;
}

std::vector<std::vector<Pixel>> clip(const std::vector<Pixel>& curve, const Box& box) {
    std::vector<std::vector<Pixel>> pieces;
    bool open = false;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        double from, to;
        if (!inside(curve[i], curve[i + 1], box, from, to)) {
            open = false;
            continue;
        }
        if (!open) pieces.push_back({from > 0 ? between(curve[i], curve[i + 1], from) : curve[i]});
        pieces.back().push_back(to < 1 ? between(curve[i], curve[i + 1], to) : curve[i + 1]);
        open = to >= 1;
    }
    return pieces;
}

bool crosses(const std::vector<Pixel>& curve, const Box& box) {
    if (curve.size() == 1) return box.holds(curve[0][0], curve[0][1]);
    double from, to;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i)
        if (inside(curve[i], curve[i + 1], box, from, to)) return true;
    return false;
}

bool crosses(const Strip& strip, const Box& box) {
    for (std::size_t i = 0; i + 1 < strip.low.size(); ++i) {
        const std::size_t a = strip.low[i][0] <= strip.low[i + 1][0] ? i : i + 1, b = 2 * i + 1 - a;
        const double x[2] = {strip.low[a][0], strip.low[b][0]};
        const double from = std::max(x[0], box.left), to = std::min(x[1], box.right);
        if (from > to) continue;
        double low = box.top, high = box.bottom;
        for (const double at : {from, to}) {
            const double share = x[1] > x[0] ? (at - x[0]) / (x[1] - x[0]) : 0;
            const double p = strip.low[a][1] + share * (double(strip.low[b][1]) - strip.low[a][1]);
            const double q = strip.high[a][1] + share * (double(strip.high[b][1]) - strip.high[a][1]);
            low = std::min({low, p, q}), high = std::max({high, p, q});
        }
        if (low < box.top && high > box.bottom) return true;
    }
    return false;
}

Strip clip(const Strip& strip, const Box& box) {
    Strip cut;
    const auto add = [&](const Pixel& low, const Pixel& high) {
        const auto level = [&](float y) {
            return std::clamp(y, static_cast<float>(box.bottom), static_cast<float>(box.top));
        };
        cut.low.push_back({low[0], level(low[1])});
        cut.high.push_back({high[0], level(high[1])});
    };
    for (std::size_t i = 0; i + 1 < strip.low.size(); ++i) {
        const double x0 = strip.low[i][0], x1 = strip.low[i + 1][0];
        std::vector<double> shares = {0, 1};
        const auto cross = [&](double a, double b, double at) {
            const double share = (at - a) / (b - a);
            if (share > 0 && share < 1) shares.push_back(share);
        };
        cross(x0, x1, box.left);
        cross(x0, x1, box.right);
        for (const auto* edge : {&strip.low, &strip.high})
            for (const double y : {box.bottom, box.top}) cross((*edge)[i][1], (*edge)[i + 1][1], y);
        std::ranges::sort(shares);
        for (const double share : shares) {
            const Pixel low = between(strip.low[i], strip.low[i + 1], share),
                        high = between(strip.high[i], strip.high[i + 1], share);
            if (low[0] >= box.left - 0.01 && low[0] <= box.right + 0.01) add(low, high);
        }
    }
    return cut;
}

std::vector<Pixel> thin(const std::vector<Pixel>& curve) {
    std::vector<Pixel> kept;
    for (std::size_t i = 0; i < curve.size();) {
        const double column = std::floor(curve[i][0]);
        std::size_t end = i + 1, lowest = i, highest = i;
        for (; end < curve.size() && std::floor(curve[end][0]) == column; ++end) {
            if (curve[end][1] < curve[lowest][1]) lowest = end;
            if (curve[end][1] > curve[highest][1]) highest = end;
        }
        std::size_t last = curve.size();
        for (const std::size_t at : {i, std::min(lowest, highest), std::max(lowest, highest), end - 1})
            if (at != last) kept.push_back(curve[last = at]);
        i = end;
    }
    return kept;
}

}  // namespace hinge::output

#include "panel/bend.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/errors.h"
#include "panel/principal.h"

namespace hinge::panel {
namespace {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

constexpr double in_line = 0.9;  ///< minus the cosine of the angle of two sides that are one line

Vec3 normal_of(const std::array<int, 4>& corners, std::span<const Vec3> x) {
    const Vec3 &a = x[corners[0]], &b = x[corners[1]], &c = x[corners[2]];
    return corners[3] < 0 ? Vec3((b - a).cross(c - a)) : Vec3((c - a).cross(x[corners[3]] - b));
}

/// The panels at each node.
std::map<int, std::vector<int>> panels_at_nodes(std::span<const Corners> panels) {
    std::map<int, std::vector<int>> at;
    for (std::size_t p = 0; p < panels.size(); ++p)
        for (const int n : panels[p].nodes) at[n].push_back(int(p));
    return at;
}

/// Neighbours of a node in its panels, and those that lie on one line with it.
struct Lines {
    std::vector<std::array<int, 2>> list;
    int beside = -1;               ///< some neighbour
    std::size_t beside_count = 0;  ///< how many there are
};
Lines lines_at(int node, const std::vector<int>& at, std::span<const Corners> panels, std::span<const Vec3> place) {
    std::map<int, std::set<int>> of;  // of each neighbour, the panels that it is in
    for (const int p : at) {
        const auto& nodes = panels[p].nodes;
        const int n = int(nodes.size());
        const int k = int(std::find(nodes.begin(), nodes.end(), node) - nodes.begin());
        of[nodes[(k + 1) % n]].insert(p), of[nodes[(k + n - 1) % n]].insert(p);
    }
    Lines lines;
    lines.beside = of.begin()->first, lines.beside_count = of.size();
    for (auto a = of.begin(); a != of.end(); ++a)
        for (auto b = std::next(a); b != of.end(); ++b) {
            const bool apart =
                std::none_of(a->second.begin(), a->second.end(), [&](int p) { return b->second.count(p) > 0; });
            const Vec3 u = (place[a->first] - place[node]).normalized(),
                       v = (place[b->first] - place[node]).normalized();
            if (apart && u.dot(v) < -in_line) lines.list.push_back({a->first, b->first});
        }
    return lines;
}

class Maker {
public:
    Maker(int node, const std::vector<int>& at, std::span<const Corners> panels, std::span<const Vec3> place)
        : node_(node), panels_(panels), place_(place) {
        bend_.panels = at;
        index(node);
        Vec3 sum = Vec3::Zero();
        for (const int p : at) {
            std::array<int, 4> corners{-1, -1, -1, -1};
            for (std::size_t k = 0; k < panels[p].nodes.size(); ++k) corners[k] = index(panels[p].nodes[k]);
            // all of them look the way the first one does
            if (sum.dot(normal_of(corners, places())) < 0) std::swap(corners[1], corners[corners[3] < 0 ? 2 : 3]);
            bend_.around.push_back(corners);
            bend_.area += panels[p].area / double(panels[p].nodes.size());
            poisson_ += panels[p].poisson / double(at.size());
            sum += normal_of(corners, places());
        }
        normal_ = sum.normalized();
        lines_ = lines_at(node, at, panels, place);
    }

    /// Nothing where more than two lines meet, or where nothing bends.
    bool make() {
        const bool closed = lines_.beside_count == bend_.panels.size();
        if (closed && bend_.panels.size() > 2 && lines_.list.size() != 2)
            throw InputError("panels bend about node " + std::to_string(node_ + 1) + ", where " +
                             std::to_string(bend_.panels.size()) +
                             " meet, and their sides do not go on there in two lines, to 25 degrees: lay them out in "
                             "straighter rows, or give them bending = false");
        if (lines_.list.size() > 2) return false;
        const auto line = [&](std::size_t i) -> Vec3 { return place_[lines_.list[i][1]] - place_[lines_.list[i][0]]; };
        const Vec3 first = lines_.list.empty() ? Vec3(place_[lines_.beside] - place_[node_]) : line(0);
        const Vec3 e1 = (first - normal_.dot(first) * normal_).normalized(), e2 = normal_.cross(e1);
        bend_.frame << e1, e2, normal_;
        const auto flat = [&](const Vec3& v) { return Vec2(e1.dot(v), e2.dot(v)); };
        const bool both = lines_.list.size() == 2;
        const Vec2 s(1, 0), t = both ? Vec2(flat(line(1)).normalized()) : Vec2(0, 1);
        for (std::size_t i = 0; i < lines_.list.size(); ++i) add_line(i);
        const bool twists = add_mixed(s, t, flat);
        const double c = t[0], n = t[1];  // k_ss = k11, k_tt = c^2 k11 + n^2 k22 + 2 c n k12, k_st = c k11 + n k12
        Mat3& T = bend_.to_frame;
        if (!lines_.list.empty()) T(0, 0) = 1;
        if (twists) T.row(2) << -2 * c / n, 0, 2 / n;
        if (both) {
            T.row(1) << -c * c, 1, 0;
            T.row(1) = (T.row(1) - c * n * T.row(2)).eval() / (n * n);
        } else {
            T.row(1) = -poisson_ * T.row(0);  // an edge has no moment across it
        }
        const Bent start = bent(bend_, places(), places(), true);
        for (int k = 0; k < 3; ++k) bend_.start[k] = start.normal.dot(start.d[k]);
        return !T.isZero(0);
    }
    Bend take() { return std::move(bend_); }

private:
    std::vector<Vec3> places() const {
        std::vector<Vec3> list;
        for (const int n : bend_.nodes) list.push_back(place_[n]);
        return list;
    }
    int index(int node) {
        const auto at = std::find(bend_.nodes.begin(), bend_.nodes.end(), node);
        if (at != bend_.nodes.end()) return int(at - bend_.nodes.begin());
        bend_.nodes.push_back(node), bend_.weight.push_back({});
        return int(bend_.nodes.size()) - 1;
    }
    void add_line(std::size_t i) {
        const auto [a, b] = lines_.list[i];
        const double la = (place_[a] - place_[node_]).norm(), lb = (place_[b] - place_[node_]).norm();
        const double of_a = 2 / (la * (la + lb)), of_b = 2 / (lb * (la + lb));
        bend_.weight[index(a)][i] += of_a, bend_.weight[index(b)][i] += of_b;
        bend_.weight[0][i] -= of_a + of_b;
    }
    /// The mean of the quadrilaterals.
    template <class F>
    bool add_mixed(const Vec2& s, const Vec2& t, F flat) {
        constexpr double xi[4] = {-1, 1, 1, -1}, eta[4] = {-1, -1, 1, 1};
        double whole = 0;
        for (const int p : bend_.panels)
            if (panels_[p].nodes.size() == 4) whole += panels_[p].area;
        for (const int p : bend_.panels) {
            const auto& nodes = panels_[p].nodes;
            if (nodes.size() != 4) continue;
            Mat2 J = Mat2::Zero();
            for (int k = 0; k < 4; ++k) {
                const Vec2 at = flat(place_[nodes[k]] - place_[node_]);
                J.col(0) += 0.25 * xi[k] * at, J.col(1) += 0.25 * eta[k] * at;
            }
            const Mat2 G = J.inverse();  // rows: gradients of xi and eta
            const Vec2 gx = G.row(0).transpose(), gy = G.row(1).transpose();
            const double part = (gx.dot(s) * gy.dot(t) + gy.dot(s) * gx.dot(t)) * panels_[p].area / whole;
            Vec2 twisted = Vec2::Zero();
            for (int k = 0; k < 4; ++k) twisted += xi[k] * eta[k] * flat(place_[nodes[k]] - place_[node_]);
            for (int k = 0; k < 4; ++k) {
                const Vec2 b = 0.25 * (xi[k] * gx + eta[k] * gy);  // gradient of its shape function in the middle
                bend_.weight[index(nodes[k])][2] += part * 0.25 * (xi[k] * eta[k] - twisted.dot(b));
            }
        }
        return whole > 0;
    }

    int node_;
    std::span<const Corners> panels_;
    std::span<const Vec3> place_;
    Bend bend_;
    Vec3 normal_;
    double poisson_ = 0;
    Lines lines_;
};

/// Derivative of n . d by the places of the nodes, d constant: the normal rotates. f(j, derivative).
template <class F>
void for_each_turn(const Bend& bend, const Bent& at, std::span<const Vec3> places, const Vec3& d, F f) {
    const Vec3 g = (d - at.normal.dot(d) * at.normal) / at.sum.norm();
    for (const auto& k : bend.around) {
        const bool quad = k[3] >= 0;
        const Vec3 u = places[k[2]] - places[k[0]],
                   v = quad ? Vec3(places[k[3]] - places[k[1]]) : Vec3(places[k[1]] - places[k[0]]);
        if (quad) {  // u x v
            const Vec3 of_u = v.cross(g), of_v = g.cross(u);
            f(k[2], of_u), f(k[0], -of_u), f(k[3], of_v), f(k[1], -of_v);
        } else {  // v x u
            const Vec3 of_v = u.cross(g), of_u = g.cross(v);
            f(k[1], of_v), f(k[2], of_u), f(k[0], -of_u - of_v);
        }
    }
}

}  // namespace

std::vector<Bend> bends_of(std::span<const Corners> panels, std::span<const Vec3> place) {
    std::vector<Bend> list;
    for (const auto& [node, at] : panels_at_nodes(panels)) {
        Maker maker(node, at, panels, place);
        if (maker.make()) list.push_back(maker.take());
    }
    return list;
}

Bent bent(const Bend& bend, std::span<const Vec3> places, std::span<const Vec3> moved, bool large) {
    Bent at;
    at.sum.setZero();
    for (const auto& corners : bend.around) at.sum += normal_of(corners, places);
    at.normal = at.sum.normalized();
    for (int c = 0; c < 3; ++c) {
        at.d[c].setZero();
        for (std::size_t j = 0; j < bend.weight.size(); ++j) at.d[c] += bend.weight[j][c] * moved[j];
        at.derivative[c] = at.normal.dot(at.d[c]) - (large ? bend.start[c] : 0);
    }
    return at;
}

Gradient gradient(const Bend& bend, const Bent& at, std::span<const Vec3> places, bool large) {
    Gradient G(3, 3 * bend.nodes.size());
    for (int c = 0; c < 3; ++c)
        for (std::size_t j = 0; j < bend.nodes.size(); ++j)
            G.block<1, 3>(c, 3 * j) = bend.weight[j][c] * at.normal.transpose();
    if (!large) return G;
    for (int c = 0; c < 3; ++c)
        for_each_turn(bend, at, places, at.d[c],
                      [&](int j, const Vec3& v) { G.block<1, 3>(c, 3 * j) += v.transpose(); });
    return G;
}

void add_forces(const Bend& bend, const Bent& at, std::span<const Vec3> places, bool large, const Vec3& moment,
                std::span<Vec3> forces) {
    for (std::size_t j = 0; j < bend.nodes.size(); ++j) {
        const auto& w = bend.weight[j];
        forces[j] += (moment[0] * w[0] + moment[1] * w[1] + moment[2] * w[2]) * at.normal;
    }
    if (!large) return;
    const Vec3 sum = moment[0] * at.d[0] + moment[1] * at.d[1] + moment[2] * at.d[2];
    for_each_turn(bend, at, places, sum, [&](int j, const Vec3& v) { forces[std::size_t(j)] += v; });
}

BendingResponse bend(const BendingLaw& l, const Vec3& curvature, const double* before, double* after,
                     bool with_tangent) {
    const Eigen::Map<const Vec3> plastic(before), moment_before(before + 3);
    const Vec3 k = curvature - plastic;
    const double nu = l.poisson, D = l.stiffness;
    const Principal axes(k);
    double e[2] = {axes.middle + axes.half, axes.middle - axes.half}, flow[2] = {0, 0}, m[2] = {};
    const auto find = [&] {
        for (int i : {0, 1}) m[i] = D * (e[i] - flow[i] + nu * (e[1 - i] - flow[1 - i]));
    };
    const auto clamp = [&](double x) { return std::clamp(x, -l.hogging, l.sagging); };
    find();
    bool flows[2] = {clamp(m[0]) != m[0], clamp(m[1]) != m[1]};
    for (int i : {0, 1})  // one alone first, since it relieves the other
        if (flows[i] && !flows[1 - i]) {
            flow[i] = (m[i] - clamp(m[i])) / D;
            find();
            m[i] = clamp(m[i]);
            flows[1 - i] = clamp(m[1 - i]) != m[1 - i];
        }
    if (flows[0] && flows[1]) {
        const double to[2] = {clamp(m[0]), clamp(m[1])};
        flow[0] = flow[1] = 0;
        for (int i : {0, 1}) flow[i] = e[i] - (to[i] - nu * to[1 - i]) / (D * (1 - nu * nu));
        m[0] = to[0], m[1] = to[1];
    }
    BendingResponse r;
    Vec3 of[2], flowed = Vec3::Zero();
    for (int i : {0, 1}) {
        of[i] = axes.direction(i);
        r.moment += m[i] * of[i];
        flowed += flow[i] * Vec3(of[i][0], of[i][1], 2 * of[i][2]);
    }
    if (with_tangent) {
        Mat2 own = D * (Mat2() << 1, nu, nu, 1).finished();  // d(principal moment)/d(principal curvature)
        if (flows[0] && flows[1]) own.setZero();
        else
            for (int i : {0, 1})
                if (flows[i]) own.setZero(), own(1 - i, 1 - i) = D * (1 - nu * nu);
        for (int i : {0, 1})
            for (int j : {0, 1}) r.tangent += own(i, j) * of[i] * of[j].transpose();
        const Vec3 across = axes.across();
        const double shear = axes.half > 1e-12 ? (m[0] - m[1]) / (4 * axes.half) : 0.5 * D * (1 - nu);
        r.tangent += shear * across * across.transpose();
    }
    Eigen::Map<Vec3>(after, 3) = plastic + flowed;
    Eigen::Map<Vec3>(after + 3, 3) = r.moment;
    r.stored = 0.5 * r.moment.dot(k - flowed);
    r.dissipated = 0.5 * (moment_before + r.moment).dot(flowed);
    return r;
}

}  // namespace hinge::panel

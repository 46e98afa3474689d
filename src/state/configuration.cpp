#include "state/configuration.h"

#include <algorithm>

#include "beam/tangent.h"

namespace hinge {

using beam::Quadruple;

namespace {

Quadruple<double> quadruple(const Quat& q) { return {q.w(), q.x(), q.y(), q.z()}; }

Vec6 small_deformation(const Element& e, const Pose& at) {
    const Mat3 axes = e.axes.toRotationMatrix().transpose();
    Vec12 u;
    u << axes * at.displacement[e.node[0]], axes * at.small_rotation[e.node[0]], axes * at.displacement[e.node[1]],
        axes * at.small_rotation[e.node[1]];
    return beam::linear_deformation(e.length) * u;
}

}  // namespace

Vec3 chord_of(const Element& e, const std::vector<Vec3>& displacement) {
    return e.chord + (displacement[e.node[1]] - displacement[e.node[0]]);
}

Quat end_rotation(const Element& e, int index, int end, const Pose& at) {
    const Quat& node = at.rotation[e.node[end]];
    return at.turned.empty() ? node : node * at.turned[index].of(end);
}

beam::Winding winding_of(const Element& e, int index, const Pose& at) {
    beam::Winding w;
    const Vec3 chord = chord_of(e, at.displacement);
    w.chord = {chord.x(), chord.y(), chord.z()};
    for (int end : {0, 1}) w.node[end] = quadruple(end_rotation(e, index, end, at));
    w.axes = quadruple(e.axes);
    w.L = e.length;
    w.last = at.twist.empty() ? 0 : at.twist[index];
    return w;
}

Mat3 axes_of(const beam::ElementFrame<double>& p) {
    Mat3 axes;
    axes << p.frame.x.x, p.frame.y.x, p.frame.z.x, p.frame.x.y, p.frame.y.y, p.frame.z.y, p.frame.x.z, p.frame.y.z,
        p.frame.z.z;
    return axes;
}

ElementFrame element_frame(const Structure& structure, int index, const Pose& at) {
    const Element& e = structure.elements()[index];
    if (!structure.large())
        return {
            beam::place<double>({e.chord.x(), e.chord.y(), e.chord.z()}, {1, 0, 0, 0}, {1, 0, 0, 0}, quadruple(e.axes)),
            {}};
    const Vec3 chord = chord_of(e, at.displacement);
    ElementFrame p = {beam::place<double>({chord.x(), chord.y(), chord.z()}, quadruple(end_rotation(e, index, 0, at)),
                                          quadruple(end_rotation(e, index, 1, at)), quadruple(e.axes)),
                      {}};
    if (dot(p.theta[0], p.theta[0]) + dot(p.theta[1], p.theta[1]) < beam::far_rotation &&
        (at.twist.empty() || at.twist[index] == 0))
        return p;
    p.wound = winding_of(e, index, at);
    if (beam::wind(*p.wound)) p.frame = p.wound->frame;
    else p.wound.reset();
    return p;
}

Eigen::Matrix<double, 12, 6> forces_at_nodes(const ElementFrame& placement) {
    if (placement.wound) return beam::rates(*placement.wound).transpose();
    Eigen::Matrix<double, 12, 6> to_nodes;
    for (int i = 0; i < 6; ++i) {
        double p[6] = {};
        p[i] = 1;
        const beam::NodalForces<double> f = beam::nodal_forces(placement, p);
        for (int end : {0, 1})
            to_nodes.col(i).segment<6>(6 * end) << f.force[end].x, f.force[end].y, f.force[end].z, f.moment[end].x,
                f.moment[end].y, f.moment[end].z;
    }
    return to_nodes;
}

Vec6 deformation_rates(const ElementFrame& placement, const Vec6& first, const Vec6& second) {
    if (placement.wound) {
        Vec12 v;
        v << first, second;
        return beam::rates(*placement.wound) * v;
    }
    const beam::Triple<double> linear[2] = {{first[0], first[1], first[2]}, {second[0], second[1], second[2]}},
                               angular[2] = {{first[3], first[4], first[5]}, {second[3], second[4], second[5]}};
    Vec6 rate;
    beam::deformation_rates(placement, linear, angular, rate.data());
    return rate;
}

Vec12 nodal_forces(const ElementFrame& placement, const Vec6& p) {
    if (placement.wound) return beam::rates(*placement.wound).transpose() * p;
    double of_p[6];
    std::copy_n(p.data(), 6, of_p);
    const beam::NodalForces<double> f = beam::nodal_forces(placement, of_p);
    Vec12 out;
    for (int end : {0, 1})
        out.segment<6>(6 * end) << f.force[end].x, f.force[end].y, f.force[end].z, f.moment[end].x, f.moment[end].y,
            f.moment[end].z;
    return out;
}

Mat12 element_tangent(const ElementFrame& placement, const Vec6& p, const Mat6& k, bool geometric) {
    return placement.wound ? beam::tangent(*placement.wound, p, k, geometric)
                           : beam::tangent(placement, p, k, geometric);
}

Vec6 element_deformation(const Structure& structure, int index, const Pose& at) {
    return element_deformation(structure, index, at,
                               structure.large() ? element_frame(structure, index, at) : ElementFrame{});
}

Vec6 element_deformation(const Structure& structure, int index, const Pose& at, const ElementFrame& placement) {
    Vec6 d;
    const Element& e = structure.elements()[index];
    if (structure.large()) {
        if (placement.wound) std::copy_n(placement.wound->d, 6, d.data());
        else beam::deformation(placement, e.length, d.data());
    } else {
        d = small_deformation(e, at);
    }
    if (!at.heat.empty()) d -= at.heat[std::size_t(index)].deformation();
    return d;
}

}  // namespace hinge

// Joints of member ends, and between two nodes at one place: their declaration, and their state in a run.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "core/types.h"

namespace hinge {

inline constexpr const char* joints_effect = "joints";

/// Moment of a joint over the rotation of the member's end relative to its node, about one axis of the section.
struct JointAxis {
    static constexpr double infinite = std::numeric_limits<double>::infinity();
    double stiffness = infinite;  ///< N m/rad, elastic; infinite: rigid; 0: free
    /// Rotation (rad) and moment (N m), both rising from more than 0, with slopes that fall: the first point ends the
    /// elastic part. Beyond the last one the moment stays. Empty: elastic.
    std::vector<std::pair<double, double>> curve;
    double capacity = infinite;  ///< rad: the rotation, of either sign, at which the joint breaks

    bool is_free() const { return stiffness == 0; }
    bool is_spring() const { return stiffness > 0 && stiffness < infinite; }
    /// N m, the most that its curve has; infinite where it is elastic.
    double strength() const { return curve.empty() ? infinite : curve.back().second; }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.stiffness, s.curve, s.capacity);
    }
};

/// Properties of a joint: about x, y and z of the section; and the forces at which it breaks.
struct JointProperties {
    JointAxis axis[3];
    double tension = JointAxis::infinite;  ///< N, along the member
    double shear = JointAxis::infinite;    ///< N, across the member
    /// A tension T leaves 1 - T / tension of the curves of x and y: EN 1993-1-8, 6.2.7.1 (3).
    bool tension_weakens = false;

    bool can_break() const {
        return tension < JointAxis::infinite || shear < JointAxis::infinite || axis[0].capacity < JointAxis::infinite ||
               axis[1].capacity < JointAxis::infinite || axis[2].capacity < JointAxis::infinite;
    }
    bool is_linear() const { return axis[0].curve.empty() && axis[1].curve.empty() && axis[2].curve.empty(); }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.axis, s.tension, s.shear, s.tension_weakens);
    }
};

/// A joint at an end (0, 1) of a member, or between two nodes at one place (model:joint): then `to` stays at `from`,
/// and the axes are those of `from`.
struct Joint {
    int member, end;  ///< member -1: between nodes
    JointProperties is;
    int from = -1, to = -1;
    Mat3 axes = Mat3::Identity();  ///< columns x y z, of a joint between nodes

    bool is_between_nodes() const { return member < 0; }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.member, s.end, s.is, s.from, s.to, s.axes);
    }
};

/// A joint where the last step that was kept ended.
struct JointState {
    bool broken = false;
    double broken_at = 0;           ///< s
    Vec3 rotation = Vec3::Zero();   ///< of the member's end relative to the node, about x, y, z of the section, rad
    Vec3 moment = Vec3::Zero();     ///< N m, that the joint puts on the node
    Vec3 offset = Vec3::Zero();     ///< of rigid axes: the rotation without moment, rad
    double tension = 0, shear = 0;  ///< N
    std::vector<double> slid[3];    ///< rad: plastic rotation of each part of the curve
    double pull = 0;                ///< N: the tension that weakens, which follows that above with a delay
    double left = 1;                ///< part of the curves of x and y that it leaves
    Vec3 viscous = Vec3::Zero();    ///< N m: moment of damping about each axis, beside `moment`
    Vec3 elastic = Vec3::Ones();    ///< part of the rate of rotation that the springs had, the rest is slip
    int over = -1;  ///< what has reached its capacity: 0 to 2 a rotation, 3 tension, 4 shear; -1: nothing

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.broken, s.broken_at, s.rotation, s.moment, s.offset, s.tension, s.shear, s.slid, s.pull, s.left, s.viscous,
          s.elastic, s.over);
    }
};

struct JointStates {
    static constexpr bool in_state_hash = false;  ///< the hash of a state is that of its arrays
    std::vector<JointState> list;
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.list);
    }
};

}  // namespace hinge

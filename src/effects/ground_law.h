// The laws of the ground, and what they share: the ends of members that may touch a plane, and friction on it.
// The effect (ground.cpp) goes through those that a scene needs.
#pragma once

#include <memory>

#include "contact/layer_law.h"
#include "contact/pressed_point.h"
#include "effects/effect.h"
#include "effects/ground.h"

namespace hinge {

/// A node, the end of an element, or the free end of a broken element, which may touch a plane.
struct GroundEnd {
    int node = 0;
    Vec3 arm = Vec3::Zero();   ///< of the free end of a broken element: m, from the node in the node's own frame
    double radius = 0;         ///< h, half the depth of the members, m
    double stiffness = 0;      ///< of friction's spring, N/m
    bool left_out = false;     ///< began below the plane and has not left it yet
    double level = 0;          ///< m: depth where it began. There it is at rest, until it leaves the ground
    Vec3 slip = Vec3::Zero();  ///< e, m: stretch of friction's spring where a step begins

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.node, s.arm, s.radius, s.stiffness, s.left_out, s.level, s.slip);
    }
};

/// An end on a spring (ground_points.cpp).
struct GroundPoint {
    int plane = 0;
    int element = -1;  ///< broken: its free end; -1: a node
    GroundEnd end;
    double stiffness = 0;         ///< k, N/m
    double mass = 0;              ///< half of the elements at the node, kg
    double waits = 0;             ///< s: time left, after it came out, to wait for others of its body; 0: does not
    Vec3 dragged = Vec3::Zero();  ///< friction over pressure as it came out, along e
    double rubbed = 0;            ///< J: heat of friction since it came to touch, less what was given back

    // where a step begins
    double overlap = 0;                ///< o, m; negative: apart
    Vec3 place = Vec3::Zero();         ///< of the end, m
    Quat rotation = Quat::Identity();  ///< of the node

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.plane, s.element, s.end, s.stiffness, s.mass, s.waits, s.dragged, s.rubbed, s.overlap, s.place, s.rotation);
    }
};

/// An element over a layer (ground_layer.cpp).
struct GroundStrip {
    int plane = 0, element = 0;
    bool gone = false;  ///< with the node that carried it
    contact::LayerPiece piece;
    GroundEnd end[2];
    double area[2] = {0, 0};            ///< of the section, m^2
    bool has_face[2] = {false, false};  ///< the member ends there; `piece` follows once the end is off the ground
    Vec3 loss[2] = {Vec3::Zero(), Vec3::Zero()};  ///< force of the dashpots where a step begins, as it resists, N
    bool touches = false;                         ///< where a step begins
    double stored = 0;                            ///< J, there

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.plane, s.element, s.gone, s.piece.stiffness, s.piece.damping, s.piece.width, s.piece.length, s.piece.taper,
          s.piece.end_area, s.end, s.area, s.has_face, s.loss, s.touches, s.stored);
    }
};

/// A node of panels (ground_panels.cpp). Its end has the place, the level, and whether it is left out.
struct GroundPanelPoint {
    int plane = 0;
    GroundEnd end;
    double stiffness = 0, damping = 0;  ///< of contact::PressLaw
    contact::PressedPoint press;

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.plane, s.end, s.stiffness, s.damping, s.press);
    }
};

/// What the ground keeps from step to step.
struct GroundData {
    int planes = 0, nodes = 0;
    std::vector<GroundPoint> points;
    std::vector<GroundStrip> strips;
    std::vector<GroundPanelPoint> panels;
    static constexpr bool in_state_hash = false;  ///< the hash of a state is that of its arrays

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.planes, s.nodes, s.points, s.strips, s.panels);
    }
};

/// The number of points or strips that are pressed, at the last add_forces and at the one before.
struct PressedCount {
    int now = 0, before = 0;
    int first = 0;  ///< of those pressed, the first; not saved: a step finds it before it is read

    void begin() { before = now, now = 0; }
    void add(std::size_t i) {
        if (++now == 1) first = int(i);
    }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.now, s.before);
    }
};

/// A law by which planes of the ground press on members. The calls are those of the effect's roles (roles.h).
class GroundLaw {
public:
    explicit GroundLaw(Workspace& w)
        : w_(w), planes_(w.structure.model().declared<GroundPlane>(ground_effect)), large_(w.structure.large()) {}
    virtual ~GroundLaw() = default;

    /// Lists what may touch planes of this law, where the run begins.
    virtual void list(GroundData& to) const = 0;

    /// The step that is tried, before its forces are found.
    virtual void begin(const Step& step) { (void)step; }
    /// Adds the forces in the trial configuration, and counts what is pressed.
    virtual void add_forces(std::vector<Vec6>& resisting) = 0;
    virtual void add_blocks(Blocks& blocks) const = 0;
    virtual void add_stiffest(Blocks& most) const = 0;
    /// Whether something may touch a plane in the coming step.
    virtual bool touches_within(const Step& step) const = 0;
    virtual bool has_converged() const = 0;

    virtual void solved() {}
    virtual void end(const Step& step) { (void)step; }
    virtual double lost() const = 0;  ///< what the step dissipates, J
    virtual void before_commit() = 0;
    virtual void roll_back() {}
    virtual void acceleration_found() {}
    /// An element has broken; returns the energy lost by it, J.
    virtual double broke(const Break& b) = 0;

    /// Of Effect: a law clears the bodies that it can't let rest on it, or marks those that may.
    virtual void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const { (void)bodies, (void)rests; }
    virtual void hold_up(const Bodies& bodies, std::vector<char>& held_up) const { (void)bodies, (void)held_up; }
    virtual void rest_changed() {}
    virtual bool waits() const { return false; }  ///< for an impulse that is still to come
    /// Energy stored in the springs in such a state, J.
    virtual double stored(const State& state) const = 0;
    virtual std::string name_of_first() const = 0;  ///< of what is pressed
    virtual void restored() = 0;                    ///< the state is another one

    PressedCount pressed;

protected:
    GroundData& data() const { return *w_.state.data.find<GroundData>(ground_effect); }
    /// Whether a plane is declared for the member of that element.
    bool presses_on(int plane, int element) const {
        return planes_[plane].group < 0 || w_.structure.in_group(element, planes_[plane].group);
    }
    bool is_held(int node) const { return (w_.state.held[node] & 7) == 7; }

    /// Vector from the node to the end, m.
    template <class At>
    static Vec3 arm_of(const GroundEnd& end, const At& at) {
        return end.arm.isZero(0) ? Vec3(Vec3::Zero()) : Vec3(at.rotation[end.node] * end.arm);
    }
    template <class At>
    Vec3 place_of(const GroundEnd& end, const At& at, const Vec3& arm) const {
        return w_.structure.position()[end.node] + at.displacement[end.node] + arm;
    }
    /// o of an end at such a place, m.
    static double overlap_of(const GroundEnd& end, const GroundPlane& plane, const Vec3& place) {
        return end.radius - end.level - plane.normal.dot(place - plane.point);
    }
    /// From the node to the point of the surface that touches: in small displacement nodes have no rotation to follow.
    Vec3 surface(const GroundEnd& end, const GroundPlane& plane, const Vec3& arm) const {
        return large_ ? Vec3(arm - end.radius * plane.normal) : arm;
    }
    static Vec6 row_of(const Vec3& direction, const Vec3& arm) {
        Vec6 row;
        row << direction, arm.cross(direction);
        return row;
    }
    /// Adds a force and friction on an end to R.
    void add_force(const GroundEnd& end, const GroundPlane& plane, const Vec3& arm, const Vec3& push, const Vec3& slip,
                   std::vector<Vec6>& resisting) const;
    /// Adds the slope of a friction that sticks.
    void add_slope_of_friction(const GroundEnd& end, const GroundPlane& plane, const Vec3& arm, Mat6& K) const;
    /// What the surface moves along the plane as the end moves by `moved` and its node rotates.
    Vec3 moved_along(const GroundEnd& end, const GroundPlane& plane, Vec3 moved, const Quat& from,
                     const Quat& to) const;
    /// Whether the end may touch the plane in the coming step, as its velocity and acceleration foresee.
    bool touches_within(const GroundEnd& end, const GroundPlane& plane, const Step& step) const;
    /// What touches where the run begins is at rest there; what lies deeper is left out until it has left. Returns its
    /// depth there, m.
    double begin_at(GroundEnd& end, const GroundPlane& plane) const;

    Workspace& w_;
    const std::vector<GroundPlane>& planes_;

private:
    bool large_;  ///< displacement
};

/// Points on springs: planes with a stiffness or a restitution.
std::unique_ptr<GroundLaw> ground_points(Workspace& w, Host& host);
/// Points of panels, on all planes.
std::unique_ptr<GroundLaw> ground_panels(Workspace& w, Host& host);
/// Springs and dashpots per area: all other planes.
std::unique_ptr<GroundLaw> ground_layer(Workspace& w);

}  // namespace hinge

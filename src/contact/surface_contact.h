// Surface contact: two round bars press on each other where their axes come closest (the rule `surface`).
#pragma once

#include <array>
#include <vector>

#include "contact/end.h"
#include "contact/segments.h"

namespace hinge::contact {

/// Contact force between two bars that are closer than the sum of their half depths.
///
///   U = k/2 g^2 where g > 0, else 0:   g = h_a + h_b - n . (q - p)
///
/// That is of a pair of elements alone. Pairs that belong to one contact of two members share one spring
/// (shared_spring.h): there U = k/2 d g and the force is k d, with d <= g the depth that shared_spring.h gives.
///
/// p and q are the closest points of the two axes (s along a, t along b), n the unit vector from a to b on their common
/// normal. As s and t make the distance least they drop out of the derivative: a force k g n on b at q, the opposite on
/// a at p, shared by the nodes as the element's own displacement is. Both lie on one line, so that momentum and angular
/// momentum are conserved. n keeps the direction from which b came, so that axes that have passed each other still are
/// pushed back.
///
/// Coulomb friction is a spring e, also of stiffness k, between the touching points of the two surfaces, |k e| <= mu k
/// g. Beyond that limit the surfaces slide, and the difference becomes heat. The force acts at the surface, so bars can
/// roll. Pairs that share a spring share that of friction too: k w e and mu k d, with w the pair's share.
struct SurfaceContact {
    int element[2] = {-1, -1};
    int chain[2] = {-1, -1};          ///< of elements that continue each other, that they belong to
    int joint[4] = {-1, -1, -1, -1};  ///< nodes in which other bars may meet the ends; -1: free end
    double length[2] = {0, 0};        ///< m, of the two elements when the contact was first watched
    int group = -1, next = -1;        ///< first contact that it shares a spring with, and the next one; -1: none
    int told[2] = {-1, -1};           ///< elements of the event that told of the contact; -1: none has
    End end[4];                       ///< A1, A2, B1, B2
    double radius[2] = {0, 0};        ///< half depths, m
    double stiffness = 0;             ///< k, N/m
    double friction = 0;              ///< mu
    double level = 0;  ///< m: penetration at the start of a contact that was not predicted; no force up to it

    // as of the last update()
    double penetration = 0;       ///< g, m; negative: apart
    double depth = 0;             ///< d, m: force / k; the penetration itself where no other pair shares the spring
    double energy = 0;            ///< J
    double at[2] = {0, 0};        ///< s, t
    Vec3 normal = Vec3::Zero();   ///< n
    Vec3 slip = Vec3::Zero();     ///< e, m
    Vec3 between = Vec3::Zero();  ///< from the point of a that touched when the step began to that of b, m
    double heat = 0;              ///< J, by sliding since the last end_step()
    bool slides = false;

    // as of the last end_step(): where a step begins
    double penetration_before = 0, depth_before = 0;
    double share = 1;  ///< w, of the stiffness of friction
    double at_before[2] = {0, 0};
    Vec3 normal_before = Vec3::Zero();
    Vec3 slip_before = Vec3::Zero();
    Vec3 between_before = Vec3::Zero();  ///< q - p
    Quat rotation_before[4] = {Quat::Identity(), Quat::Identity(), Quat::Identity(),
                               Quat::Identity()};  ///< of the four nodes

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.element, s.chain, s.joint, s.length, s.group, s.next, s.told, s.end, s.radius, s.stiffness, s.friction,
          s.level, s.penetration, s.depth, s.energy, s.at, s.normal, s.slip, s.between, s.heat, s.slides,
          s.penetration_before, s.depth_before, s.share, s.at_before, s.normal_before, s.slip_before, s.between_before,
          s.rotation_before);
    }
};

/// A direction in the space of the four ends' nodes: how a length changes with their translations and rotations.
using Row = std::array<Vec6, 4>;
Row normal_row(const SurfaceContact& contact, const std::vector<Quat>& rotation);  ///< of n . (q - p)
/// Of the shift along `direction` between the points of the two surfaces that touched when the step began.
Row slip_row(const SurfaceContact& contact, const std::vector<Quat>& rotation, const Vec3& direction);
void add_row(const SurfaceContact& contact, const Row& row, double factor, std::vector<Vec6>& into);

/// Stiffness of a surface contact, k = EA / max(length, depths): EA the harmonic mean of the two members', length the
/// mean of the two members' (not of their elements', whose number is a matter of accuracy); depths = h_a + h_b. With
/// any number of elements it is no stiffer than an element along its axis.
double surface_stiffness(double ea_a, double ea_b, double length, double depths);

/// Signed distance n . (q - p) of two axes, m. Sets `closest` to their closest points and `normal` to n.
double signed_distance(const Vec3 (&point)[4], Closest& closest, Vec3& normal);

/// Updates penetration, energy and friction of a contact, with a spring of its own, for these positions.
void update(SurfaceContact& contact, const std::vector<Vec3>& position, const std::vector<Quat>& rotation);

/// Parts of update: first the penetration, then, once the depth is known, energy and friction.
void measure_penetration(SurfaceContact& contact, const std::vector<Vec3>& position, const std::vector<Quat>& rotation);
void update_friction(SurfaceContact& contact, const std::vector<Vec3>& position, const std::vector<Quat>& rotation);

/// Adds the resisting forces of the contact, + dU/du and friction, to `force`.
void add_contact_forces(const SurfaceContact& contact, const std::vector<Quat>& rotation, std::vector<Vec6>& force);

/// Adds the tangent k N N^T, N the derivative of the distance, and that of sticking friction; never negative. (Left
/// out: the rotation of n, which is g / (h_a + h_b) of it, and the slope of sliding friction, which is not symmetric.)
void add_contact_stiffness(const SurfaceContact& contact, const std::vector<Quat>& rotation, const AddStiffness& add);

/// Ends a step: the values "as of the last update()" become those at the start of the next step.
void end_step(SurfaceContact& contact, const std::vector<Vec3>& position, const std::vector<Quat>& rotation);

/// Corrects the impulse of a contact that began or ended within a step of length dt.
///
/// A step takes the mean of the forces at its two ends. The force that does just the work -(U1 - U0) is (U1 - U0) / (g1
/// - g0); the two are the same while g > 0. Where g changes its sign the difference, times dt, is an impulse that is
/// missing along n: it is added to `impulse`, and the work it does, J, is returned. Without it a contact costs up to
/// (omega dt)^2 / 4 of the energy.
double missed_impulse(const SurfaceContact& contact, double dt, const std::vector<Quat>& rotation,
                      std::vector<Vec6>& impulse);

}  // namespace hinge::contact

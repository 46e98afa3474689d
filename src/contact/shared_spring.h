// One contact of two members is one spring: pairs of elements that belong to one contact share it.
#pragma once

#include <vector>

#include "contact/surface_contact.h"

namespace hinge::contact {

/// Sets `group` and `next` of all contacts: which pairs of elements are one contact.
///
/// Pairs whose elements belong to the same two chains (unbroken runs of elements of one member) are one contact. So are
/// pairs of different chains that touch at a node in which the chains meet, within half the sum of the half depths, and
/// pairs that were one contact a step ago and overlap. Decided where a step begins, it holds throughout the step.
void group_contacts(std::vector<SurfaceContact>& contacts);

/// Part of the compliance that a pair has for itself. The rest is that of the spring which all pairs of a contact
/// share.
///
/// With y = sum of z over the n pairs that press, z_i = sqrt(k_i) d_i and gamma_i = sqrt(k_i) g_i:
///   gamma_i = eta z_i + (1 - eta) y,   z_i >= 0,   U = 1/2 sum gamma_i z_i,   dU/dg_i = k_i d_i
/// One pair alone has U = k/2 g^2. Equally deep pairs have n/(1 + (n - 1)(1 - eta)) of it, at most 1 / (1 - eta): one
/// spring, wherever elements end. U is convex in g with a continuous derivative, so force and energy go from pair to
/// pair without a jump as the point of contact slides past a node, and no pair pulls. A pair that is less deep than the
/// deepest by more than eta of it carries nothing. With eta = 0 the deepest pair alone would press: of two that lie
/// alongside each other one or the other, with a jump between two steps. 0.04: two, four, any number of equally deep
/// pairs have 1.02, 1.03, 1.042 of k, and what makes one deeper than the other meets k / (2 eta).
constexpr double own_part = 0.04;

/// Sets the depths of a group of contacts, whose penetrations are measured. `first` is its first contact.
void share_depth(std::vector<SurfaceContact>& contacts, int first);

/// Adds the tangent of a group of several contacts, as add_contact_stiffness does for one.
void add_shared_stiffness(const std::vector<SurfaceContact>& contacts, int first, const std::vector<Quat>& rotation,
                          const AddStiffness& add);

/// Adds the impulse that a step misses where the pairs that press have changed; see missed_impulse. The work missed is
///   U1 - U0 - 1/2 (f0 + f1) . (g1 - g0) = 1/2 sum k (d1 g0 - d0 g1),
/// and the impulses along the normals are in proportion to g1 - g0, so that they do just this work (Gonzalez' discrete
/// gradient). None exceeds what the contact's own forces give in the step.
/// Returns the work that they do, J.
double missed_by_group(const std::vector<SurfaceContact>& contacts, int first, double dt,
                       const std::vector<Quat>& rotation, std::vector<Vec6>& impulse);

/// At the end of a step: the pairs of a group get the mean slip, and as their shares of friction's spring those that
/// they have of the pressure. So friction's force goes along from pair to pair. Returns the energy lost, J, >= 0.
double share_slip(std::vector<SurfaceContact>& contacts, int first);

}  // namespace hinge::contact

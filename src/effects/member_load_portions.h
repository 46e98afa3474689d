// A load on a member, in portions on its elements.
#pragma once

#include <vector>

#include "effects/member_loads.h"

namespace hinge {

/// A part of a load, at a point of an element.
struct Portion {
    int element;     ///< of the member, 0 to n - 1
    double eta, xi;  ///< place in the element and in the member, 0 to 1
    Vec3 force, moment;
};

/// Of a spread load, per length of the member where it begins or ends; `along`: the member's direction at the start.
Vec3 force_per_length(const MemberLoad& load, int end, const Vec3& along);

/// The part of a spread load that lies between two places of a member: where, and its values there.
struct Stretch {
    double from, to;  ///< 0 to 1 of the member
    Vec3 force[2], moment[2];
};
Stretch stretch_of(const MemberLoad& load, double begin, double end, const Vec3& along);

/// The element at a place of a member of n elements, and the place in it, 0 to 1. Where two elements meet it is 0 of
/// the second one.
int element_at(double at, int n);
double place_in(int element, double at, int n);
/// True if a load acts on a node of the elements: then none of their sections has it between its ends.
bool is_on_node(const MemberLoad& load, int n);

/// A load on a member of n elements, m long: a spread one at the three Gauss points of each element.
std::vector<Portion> portions(const MemberLoad& load, int n, double length, const Vec3& along);
/// A spread load on a pair of elements from `begin`, `width` of a member of `length` m long: Gauss's rule with three
/// points on each of three stretches on either side of its middle.
std::vector<Portion> portions_of_pair(const MemberLoad& load, double begin, double width, double length,
                                      const Vec3& along);

}  // namespace hinge

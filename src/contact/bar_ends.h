// Position and velocity of the ends of bars.
#pragma once

#include "contact/member_contacts.h"
#include "contact/gap_rule.h"

namespace hinge::contact {

inline bool has_arm(const End& end) { return !end.arm.isZero(0); }

inline Vec3 point(const End& end, const Motion& motion) {
    const Vec3& x = motion.position[end.node];
    return has_arm(end) ? Vec3(x + motion.rotation[end.node] * end.arm) : x;
}

inline Vec3 velocity(const End& end, const Motion& motion) {
    const Vec6& v = motion.velocity[end.node];
    if (!has_arm(end)) return v.head<3>();
    return v.head<3>() + v.tail<3>().cross(motion.rotation[end.node] * end.arm);
}

/// The axes of two bars.
inline BarPair place(const Bar& a, const Bar& b, const Motion& motion) {
    return {{point(a.end(0), motion), point(a.end(1), motion)}, {point(b.end(0), motion), point(b.end(1), motion)}};
}

inline double length(const Vec3& p, const Vec3& q) { return (q - p).norm(); }

}  // namespace hinge::contact

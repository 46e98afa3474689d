// Where a point lies over a panel: the foot of the perpendicular from it to the panel's middle surface, which is
// bilinear between four corners and flat between three.
#pragma once

#include <array>
#include <span>

#include "core/types.h"

namespace hinge::contact {

struct Foot {
    double at[2] = {0, 0};           ///< -1 to 1 within four corners; of three, the parts of the second and third
    std::array<double, 4> share{};   ///< of each corner: the place of the foot is the sum of share times corner
    std::array<double, 4> slope[2];  ///< their derivatives by `at`
    Vec3 along[2] = {Vec3::Zero(), Vec3::Zero()};  ///< of the surface, its derivatives by `at`, m
    Vec3 normal = Vec3::UnitZ();                   ///< of unit length; the corners turn to the left about it
    double height = 0;                             ///< of the point over the foot, along the normal, m
    double beyond = 0;                             ///< how far the foot is out of the panel, as `at`; negative within
};

/// Of a point over three or four corners, m. Where the surface is so warped that no foot is found, `beyond` is
/// infinite.
Foot foot_of(std::span<const Vec3> corners, const Vec3& point);

/// The surface at a place of it that is kept, `at`, for corners that have moved: all but height and beyond.
Foot surface_at(std::span<const Vec3> corners, const double at[2]);

/// A vector that goes along with the panel from one position to another.
Vec3 carried(const Vec3& v, const Foot& from, const Foot& to);

/// The derivative of `direction . normal` by the place of a corner.
Vec3 slope_of_normal(const Foot& foot, const Vec3& direction, std::size_t corner);

}  // namespace hinge::contact

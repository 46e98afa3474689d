// The outline of a section with its concrete and bars, checked, and its exact strength.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "section/plastic_domain.h"

namespace hinge::beam {

/// An outline whose domain is computed when it is first asked for, and once.
class SectionOutline {
public:
    explicit SectionOutline(Outline outline, std::optional<Reinforcement> concrete = {})
        : outline_(std::move(outline)), concrete_(std::move(concrete)) {}
    const Outline& outline() const { return outline_; }
    const Reinforcement* concrete() const { return concrete_ ? &*concrete_ : nullptr; }  ///< null: it is of steel
    std::shared_ptr<const PlasticDomain> domain() const {
        std::call_once(once_, [this] { domain_ = std::make_shared<const PlasticDomain>(outline_, concrete()); });
        return domain_;
    }

    // Of concrete: its strengths are its own, N and N m.

    /// Least and largest axial force.
    std::array<double, 2> axial_range() const;
    /// Largest moment about x (axis 0) or y (axis 1) beside no axial force, of both signs.
    double largest_moment(int axis) const;
    /// Mx and My that the section carries beside the axial force N, for a curvature in the direction `angle` (rad; 0:
    /// about x).
    Eigen::Vector2d moments(double N, double angle) const;

private:
    Outline outline_;
    std::optional<Reinforcement> concrete_;
    mutable std::once_flag once_;
    mutable std::shared_ptr<const PlasticDomain> domain_;
};

/// Checks an outline and moves its centroid, with the bars, to the origin. Equal sections of concrete that are in use
/// share one object, since the domain of one takes up to 0.2 s. Throws InputError, whose message begins with `what`:
/// for a polygon of fewer than three corners, a part without area, holes as large as what they are in; for no bars, a
/// bar that is not within the outline, or in another, or weaker than the concrete; for strains out of range; for bars
/// that leave nearly no strength in some direction of N, Mx and My.
std::shared_ptr<const SectionOutline> make_section_outline(Outline outline, std::optional<Reinforcement> concrete = {},
                                                           const std::string& what = "section");

}  // namespace hinge::beam

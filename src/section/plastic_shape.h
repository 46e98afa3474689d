// The exact plastic strength of a cross-section's shape under bending and axial force, which eq 14 is compared with.
#pragma once

#include <memory>
#include <optional>

#include "core/types.h"

namespace hinge::beam {
class SectionOutline;
}

namespace hinge {

struct Section;

/// A doubly symmetric shape: a rectangle, a box, an H, a ring, or an outline. In bending with an axial force, a strip
/// along the axis of bending carries N at the yield stress, and the two parts beside it carry the moment.
class PlasticShape {
public:
    /// The shape of hinge.section.solid, box, h, pipe and round, or of an outline that is symmetric about x and y; none
    /// where only the properties of a section are known.
    static std::optional<PlasticShape> of(const Section& section);

    /// Fully plastic moment about x (axis 0) or about y (axis 1) at the axial force n = N / N0, over that without it.
    double moment(int axis, double n) const;

private:
    /// Breadth of the section at a distance from the axis: `inner` up to `step`, then `outer` up to `height`.
    struct Bands {
        double step = 0, height = 0, inner = 0, outer = 0;  ///< m
        double area() const { return 2 * (inner * step + outer * (height - step)); }
        double modulus() const { return inner * step * step + outer * (height - step) * (height + step); }
        double moment(double n) const;
    };
    static double moment_of_ring(double outer, double inner, double n);
    double moment_of_outline(int axis, double n) const;
    static std::optional<PlasticShape> by_sizes(const Section& section);

    std::shared_ptr<const beam::SectionOutline> outline_;  ///< null: one of the shapes below
    Bands bands_[2];                                       ///< for bending about x and about y
    double radius_ = 0, bore_ = 0;                         ///< m, of a ring; 0: none
};

}  // namespace hinge

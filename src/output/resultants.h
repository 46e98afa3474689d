// Section forces along a bar, from the forces at its ends and the loads on it.
#pragma once

#include <span>
#include <vector>

#include "core/bar_bending.h"
#include "output/framing.h"
#include "output/picture.h"

namespace hinge::output {

class Resultants {
public:
    /// `x`, `y`: the section's axes in space, of unit length. `loads`: those of the snapshot that act on the bar.
    Resultants(const Bar& bar, double length, Vec x, Vec y, std::span<const Load* const> loads);

    /// Value of one of N to Mz, N or N m, at a share t of the length, 0 to 1. Moments have the shear forces as slopes.
    double at(Show which, double t) const;
    /// f_y at t: of eq 14; of another law a parabola through its values at the ends and in the middle; or the larger of
    /// the ends' values if the snapshot has no forces.
    double yield_at(double t) const;
    /// Colour class at t.
    int class_at(double t) const;
    /// Positions of the changes of its colour class: rising, from 0 to 1.
    std::vector<double> class_changes() const;
    /// Positions between its ends where the shear force jumps, at point loads, or its slope, where spread loads begin
    /// and end.
    std::vector<double> jumps() const;
    /// Positions of extreme values of one of N to Mz strictly between t0 and t1, without a point load between them.
    std::vector<double> peaks(Show which, double t0, double t1) const;

private:
    const Bar* bar_;
    BarBending x_, y_;  ///< about the section's x axis: Mx, Qy; and about y: My, Qx
    bool sheared_;
};

}  // namespace hinge::output

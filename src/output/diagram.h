// Diagrams of a resultant along the members.
#pragma once

#include <span>
#include <vector>

#include <vtkSmartPointer.h>

#include "output/bars.h"
#include "output/words.h"

class vtkActor;

namespace hinge::output {

/// A diagram to draw. Moments are on the tension side: Mx along the section's y axis, My against its x axis. Qx lies
/// along x; N, Qy and Mz along y.
struct Diagram {
    Show which;
    double largest = 0, smallest = 0;  ///< N or N m, of all bars; 0 where none is above, or below, 0
    double metres = 0;                 ///< drawn per N or N m
    bool empty() const { return metres == 0; }
};

/// `size`: of the scene, m. `full`: the value, N or N m, that is drawn in full size; 0: the largest.
Diagram plan_diagram(std::span<const DrawnBar> bars, Show which, double size, double full = 0);

/// Adds the points of the diagram, so that the picture contains them.
void add_points(std::vector<Vec>& to, std::span<const DrawnBar> bars, const Diagram& diagram);

std::vector<vtkSmartPointer<vtkActor>> diagram_actors(std::span<const DrawnBar> bars, const Diagram& diagram,
                                                      const Camera& camera, double line);

/// Adds each member's largest values above and below zero; none for a member seen from its end. `em`: pixels, the size
/// of text.
void add_words(std::vector<Word>& to, std::span<const DrawnBar> bars, const Diagram& diagram, const Camera& camera,
               double em);

/// Name and unit of a quantity: "Mx", "kN m" and the like.
const char* name_of(Show which);
const char* unit_of(Show which);

}  // namespace hinge::output

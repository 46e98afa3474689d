// Bars made into solids of their true sections, or into plain lines where there are very many.
#pragma once

#include <span>
#include <vector>

#include <vtkSmartPointer.h>

#include "output/bars.h"

class vtkActor;

namespace hinge::output {

/// What to put into a renderer to see the bars.
std::vector<vtkSmartPointer<vtkActor>> member_actors(std::span<const DrawnBar> bars, const View& view,
                                                     const Camera& camera);

/// The shape at the start, as lines behind the rest.
vtkSmartPointer<vtkActor> ghost_actor(const Snapshot& snapshot, std::span<const DrawnBar> bars, const Camera& camera,
                                      double pixels);

}  // namespace hinge::output

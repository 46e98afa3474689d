// Draws bars as solids with their true sections, or as plain lines if there are very many.
#pragma once

#include <span>
#include <vector>

#include <vtkSmartPointer.h>

#include "output/bars.h"

class vtkActor;

namespace hinge::output {

/// Actors of the bars, for a renderer.
std::vector<vtkSmartPointer<vtkActor>> member_actors(std::span<const DrawnBar> bars, const View& view,
                                                     const Camera& camera);

/// Actor of the initial shape, as lines behind the rest.
vtkSmartPointer<vtkActor> ghost_actor(const Snapshot& snapshot, std::span<const DrawnBar> bars, const Camera& camera,
                                      double pixels);

}  // namespace hinge::output

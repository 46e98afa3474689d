// Bars made into shaded tubes, or into plain lines where there are very many.
#pragma once

#include <span>
#include <vector>

#include <vtkSmartPointer.h>

#include "output/bars.h"

class vtkActor;

namespace hinge::output {

/// What to put into a renderer to see the bars.
std::vector<vtkSmartPointer<vtkActor>> make_actors(std::span<const DrawnBar> bars, const Camera& camera);

}  // namespace hinge::output

// Panels that are plates, as polygons in the file of a snapshot, with their forces.
#pragma once

#include <vector>

#include "output/picture.h"

class vtkPolyData;

namespace hinge::output {

/// The bars of a snapshot, and one without any numbers for each plate: a row for each cell, lines first.
std::vector<Bar> rows_of_cells(const Snapshot& snapshot);

void add_plates(vtkPolyData* to, const Snapshot& snapshot);
void read_plates(vtkPolyData* from, Snapshot& snapshot);

}  // namespace hinge::output

// What a snapshot has beside points and bars, as lists in the field data of its file: sections, loads, floors, ground.
#pragma once

#include "output/picture.h"

class vtkFieldData;

namespace hinge::output {

void add_surroundings(vtkFieldData* to, const Snapshot& snapshot);
void read_surroundings(vtkFieldData* from, Snapshot& snapshot);

}  // namespace hinge::output

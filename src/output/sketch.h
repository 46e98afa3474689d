// Two-dimensional drawing over a whole picture, on VTK's canvas.
#pragma once

#include <functional>

#include <vtkSmartPointer.h>

#include "output/pen.h"

class vtkRenderer;

namespace hinge::output {

/// A renderer whose contents are drawn by `draw`, over the whole picture.
vtkSmartPointer<vtkRenderer> sketch(std::function<void(Pen&)> draw);

}  // namespace hinge::output

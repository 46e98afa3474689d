// Flat drawing over a whole picture, on VTK's canvas.
#pragma once

#include <functional>

#include <vtkSmartPointer.h>

#include "output/pen.h"

class vtkRenderer;

namespace hinge::output {

/// A renderer that fills the picture with what `draw` draws.
vtkSmartPointer<vtkRenderer> sketch(std::function<void(Pen&)> draw);

}  // namespace hinge::output

#include "output/png.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include "core/errors.h"
#include "output/quiet_vtk.h"

namespace hinge::output {

std::string encode_png(const Pixels& pixels) {
    const vtkNew<vtkUnsignedCharArray> bytes;
    bytes->SetNumberOfComponents(3);
    bytes->SetArray(const_cast<unsigned char*>(pixels.rgb.data()), static_cast<vtkIdType>(pixels.rgb.size()),
                    1);  // lent, not given
    const vtkNew<vtkImageData> image;
    image->SetDimensions(pixels.width, pixels.height, 1);
    image->GetPointData()->SetScalars(bytes);
    const vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->SetCompressionLevel(4);
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* result = writer->GetResult();
    if (writer->GetErrorCode() != 0 || !result) throw OutsideError("cannot encode the picture as PNG: out of memory?");
    return {reinterpret_cast<const char*>(result->GetPointer(0)),
            static_cast<std::size_t>(result->GetNumberOfValues())};
}

Pixels decode_png(const std::string& name) {
    const vtkNew<vtkPNGReader> reader;
    if (!reader->CanReadFile(name.c_str())) throw OutsideError("cannot read the picture " + name);
    reader->SetFileName(name.c_str());
    reader->Update();
    const std::string complaint = take_vtk_complaint();
    vtkImageData* image = reader->GetOutput();
    auto* bytes = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
    if (!complaint.empty() || !bytes || bytes->GetNumberOfComponents() != 3)
        throw OutsideError("cannot read the picture " + name + (complaint.empty() ? "" : ": " + complaint));
    const int* size = image->GetDimensions();
    const unsigned char* first = bytes->GetPointer(0);
    return {size[0], size[1], {first, first + bytes->GetNumberOfValues()}};
}

}  // namespace hinge::output

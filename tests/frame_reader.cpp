// What VTK's reader finds in a frame, as text: for the test of frames, which compares it with what the run says.
//
// frame_reader FRAME.vtp: a line "points N", "lines N", "polygons N", and one for each array:
//   field|point|cell <tab> name <tab> type <tab> components <tab> tuples <tab> smallest <tab> largest <tab> sum
// over all components that are numbers; of texts the first one in place of the numbers.
// frame_reader FRAME.vtp ARRAY ROW: that row, counted from 0, of an array of points or of cells.
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLGenericDataObjectReader.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

void tell(const char* where, vtkFieldData* data) {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
        vtkAbstractArray* array = data->GetAbstractArray(i);
        std::printf("%s\t%s\t%s\t%d\t%lld\t", where, array->GetName(), array->GetDataTypeAsString(),
                    array->GetNumberOfComponents(), static_cast<long long>(array->GetNumberOfTuples()));
        if (auto* numbers = vtkDataArray::SafeDownCast(array)) {
            double low = 0, high = 0, sum = 0;
            bool first = true;
            for (vtkIdType k = 0; k < numbers->GetNumberOfTuples(); ++k)
                for (int c = 0; c < numbers->GetNumberOfComponents(); ++c) {
                    const double v = numbers->GetComponent(k, c);
                    if (std::isnan(v)) continue;
                    low = first || v < low ? v : low, high = first || v > high ? v : high, sum += v;
                    first = false;
                }
            std::printf("%.9g\t%.9g\t%.9g\n", low, high, sum);
        } else if (auto* texts = vtkStringArray::SafeDownCast(array)) {
            std::printf("%s\n", texts->GetNumberOfValues() > 0 ? texts->GetValue(0).c_str() : "");
        } else {
            std::printf("?\n");
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    const vtkNew<vtkXMLGenericDataObjectReader> reader;
    reader->SetFileName(argc > 1 ? argv[1] : "");
    reader->Update();
    auto* data = vtkPolyData::SafeDownCast(reader->GetOutput());
    if (!data || reader->GetErrorCode() != 0) return 1;
    if (argc > 3) {
        auto* array = vtkDataArray::SafeDownCast(data->GetPointData()->GetAbstractArray(argv[2]));
        if (!array) array = vtkDataArray::SafeDownCast(data->GetCellData()->GetAbstractArray(argv[2]));
        if (!array) return 1;
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
            std::printf("%.9g ", array->GetComponent(std::atoi(argv[3]), c));
        return 0;
    }
    std::printf("points %lld\nlines %lld\npolygons %lld\n", static_cast<long long>(data->GetNumberOfPoints()),
                static_cast<long long>(data->GetNumberOfLines()), static_cast<long long>(data->GetNumberOfPolys()));
    double bounds[6];
    data->GetBounds(bounds);
    std::printf("bounds %.9g %.9g %.9g %.9g %.9g %.9g\n", bounds[0], bounds[1], bounds[2], bounds[3], bounds[4],
                bounds[5]);
    tell("field", data->GetFieldData());
    tell("point", data->GetPointData());
    tell("cell", data->GetCellData());
    return 0;
}

#include "output/snapshot_plates.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <limits>

namespace hinge::output {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// A number of a plate: how its array is named, and where it is.
struct PlateColumn {
    const char* name;
    double& (*of)(Panel&);
};
constexpr PlateColumn plate_columns[] = {
    {"n11 [N/m]", [](Panel& p) -> double& { return p.membrane[0]; }},
    {"n22 [N/m]", [](Panel& p) -> double& { return p.membrane[1]; }},
    {"n12 [N/m]", [](Panel& p) -> double& { return p.membrane[2]; }},
    {"principal 1 [N/m]", [](Panel& p) -> double& { return p.force[0]; }},
    {"principal 2 [N/m]", [](Panel& p) -> double& { return p.force[1]; }},
    {"used", [](Panel& p) -> double& { return p.used; }},
};
constexpr const char *panel_name = "panel", *torn_name = "torn";

Bar without_numbers() {
    Bar bar;
    bar.yield = bar.N = bar.Mz = bar.N0 = bar.Mx0 = bar.My0 = bar.Mz0 = no_number;
    for (const int end : {0, 1}) bar.Mx[end] = bar.My[end] = bar.Qx[end] = bar.Qy[end] = bar.rotation[end] = no_number;
    for (double& along : bar.yield_along) along = no_number;
    bar.group = -1, bar.member = bar.element = 0, bar.width = 0, bar.state = BarState::elastic;
    return bar;
}

}  // namespace

std::vector<Bar> rows_of_cells(const Snapshot& snapshot) {
    std::vector<Bar> rows = snapshot.bars;
    for (const Panel& p : snapshot.floors)
        if (p.has_forces) rows.push_back(without_numbers());
    return rows;
}

void add_plates(vtkPolyData* to, const Snapshot& snapshot) {
    std::vector<Panel> plates;
    for (const Panel& p : snapshot.floors)
        if (p.has_forces) plates.push_back(p);
    if (plates.empty()) return;
    const vtkNew<vtkCellArray> polygons;
    polygons->Use32BitStorage();
    for (const Panel& p : plates) {
        const std::vector<vtkIdType> corners(p.points.begin(), p.points.end());
        polygons->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
    }
    to->SetPolys(polygons);
    const std::size_t bars = snapshot.bars.size();
    const auto rows = static_cast<vtkIdType>(bars + plates.size());
    for (const PlateColumn& column : plate_columns) {
        const vtkNew<vtkFloatArray> array;
        array->SetName(column.name);
        array->SetNumberOfTuples(rows);
        for (std::size_t i = 0; i < std::size_t(rows); ++i)
            array->SetValue(static_cast<vtkIdType>(i),
                            static_cast<float>(i < bars ? no_number : column.of(plates[i - bars])));
        to->GetCellData()->AddArray(array);
    }
    const vtkNew<vtkIntArray> number;
    const vtkNew<vtkUnsignedCharArray> torn;
    number->SetName(panel_name), torn->SetName(torn_name);
    for (std::size_t i = 0; i < std::size_t(rows); ++i) {
        number->InsertNextValue(i < bars ? 0 : static_cast<int>(i - bars) + 1);
        torn->InsertNextValue(i >= bars && plates[i - bars].torn);
    }
    to->GetCellData()->AddArray(number);
    to->GetCellData()->AddArray(torn);
}

void read_plates(vtkPolyData* from, Snapshot& snapshot) {
    const vtkIdType bars = from->GetNumberOfLines(), plates = from->GetNumberOfPolys();
    const auto column_of = [&](const char* name) -> vtkDataArray* {
        auto* column = vtkDataArray::SafeDownCast(from->GetCellData()->GetAbstractArray(name));
        return column && column->GetNumberOfValues() == bars + plates ? column : nullptr;
    };
    for (vtkIdType i = 0; i < plates; ++i) {
        vtkIdType count = 0;
        const vtkIdType* corners = nullptr;
        from->GetPolys()->GetCellAtId(i, count, corners);
        Panel p;
        p.has_forces = true;
        for (vtkIdType k = 0; k < count; ++k) p.points.push_back(static_cast<int>(corners[k]));
        for (const PlateColumn& column : plate_columns)
            if (vtkDataArray* found = column_of(column.name)) column.of(p) = found->GetTuple1(bars + i);
        if (vtkDataArray* found = column_of(torn_name)) p.torn = found->GetTuple1(bars + i) != 0;
        snapshot.floors.push_back(p);
    }
}

}  // namespace hinge::output

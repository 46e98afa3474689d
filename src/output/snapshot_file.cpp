#include "output/snapshot_file.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSignedCharArray.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "output/framing.h"
#include "output/quiet_vtk.h"
#include "output/snapshot_check.h"
#include "output/snapshot_lists.h"
#include "output/snapshot_plates.h"

namespace hinge::output {
namespace {

/// One cell array: how it is filled from the bars, of which there is a row for each cell.
template <class Array, class Value>
void add_column(vtkFieldData* to, const char* name, const std::vector<Bar>& bars, Value value) {
    const vtkNew<Array> column;
    column->SetName(name);
    column->SetNumberOfTuples(static_cast<vtkIdType>(bars.size()));
    for (std::size_t i = 0; i < bars.size(); ++i) column->SetValue(static_cast<vtkIdType>(i), value(bars[i]));
    to->AddArray(column);
}

/// Vectors in single precision; nothing where there are none.
void add_vectors(vtkFieldData* to, const char* name, const std::vector<std::array<double, 3>>& vectors) {
    if (vectors.empty()) return;
    const vtkNew<vtkFloatArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(vectors.size()));
    float* at = array->GetPointer(0);
    for (const auto& v : vectors)
        for (const double c : v) *at++ = static_cast<float>(c);
    to->AddArray(array);
}

void add_points(vtkPolyData* data, const Snapshot& snapshot) {
    const auto n = static_cast<vtkIdType>(snapshot.points.size());
    const vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(n);
    const vtkNew<vtkUnsignedCharArray> is_virtual;
    is_virtual->SetName("is_virtual");
    is_virtual->SetNumberOfTuples(n);
    for (vtkIdType i = 0; i < n; ++i) {
        points->SetPoint(i, snapshot.points[i].data());
        is_virtual->SetValue(i, snapshot.is_virtual.empty() ? 0 : snapshot.is_virtual[i]);
    }
    data->SetPoints(points);
    data->GetPointData()->AddArray(is_virtual);
    add_vectors(data->GetPointData(), "displacement [m]", snapshot.displacement);
    add_vectors(data->GetPointData(), "rotation [rad]", snapshot.rotation);
    if (!snapshot.held.empty()) {
        const vtkNew<vtkUnsignedCharArray> held;
        held->SetName("held");
        held->SetNumberOfTuples(n);
        for (vtkIdType i = 0; i < n; ++i) held->SetValue(i, snapshot.held[i]);
        data->GetPointData()->AddArray(held);
    }
}

/// A bar's forces and what limits them: how each array is named, and which number of a bar it holds.
struct Column {
    const char* name;
    double& (*of)(Bar&);
};
constexpr Column force_columns[] = {
    {"N [N]", [](Bar& b) -> double& { return b.N; }},
    {"Mx 1 [N m]", [](Bar& b) -> double& { return b.Mx[0]; }},
    {"Mx 2 [N m]", [](Bar& b) -> double& { return b.Mx[1]; }},
    {"My 1 [N m]", [](Bar& b) -> double& { return b.My[0]; }},
    {"My 2 [N m]", [](Bar& b) -> double& { return b.My[1]; }},
    {"Mz [N m]", [](Bar& b) -> double& { return b.Mz; }},
    {"hinge rotation 1 [rad]", [](Bar& b) -> double& { return b.rotation[0]; }},
    {"hinge rotation 2 [rad]", [](Bar& b) -> double& { return b.rotation[1]; }},
    {"N0 [N]", [](Bar& b) -> double& { return b.N0; }},
    {"Mx0 [N m]", [](Bar& b) -> double& { return b.Mx0; }},
    {"My0 [N m]", [](Bar& b) -> double& { return b.My0; }},
    {"Mz0 [N m]", [](Bar& b) -> double& { return b.Mz0; }},
};

/// Where loads act on members.
constexpr Column shear_columns[] = {
    {"Qx 1 [N]", [](Bar& b) -> double& { return b.Qx[0]; }},
    {"Qx 2 [N]", [](Bar& b) -> double& { return b.Qx[1]; }},
    {"Qy 1 [N]", [](Bar& b) -> double& { return b.Qy[0]; }},
    {"Qy 2 [N]", [](Bar& b) -> double& { return b.Qy[1]; }},
};

/// Where the axial force acts on the bow of members.
constexpr Column compression_columns[] = {
    {"P L2/EIx", [](Bar& b) -> double& { return b.compression[0]; }},
    {"P L2/EIy", [](Bar& b) -> double& { return b.compression[1]; }},
};

/// Where bars were declared to end, where some have broken off.
constexpr const char* node_names[2] = {"node 1", "node 2"};

/// The sections' y axes, in parts of 127: a direction within half a degree needs no more.
constexpr const char* up_name = "up [1/127]";
void add_directions(vtkFieldData* to, const std::vector<Bar>& bars) {
    const vtkNew<vtkSignedCharArray> array;
    array->SetName(up_name);
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(bars.size()));
    signed char* at = array->GetPointer(0);
    for (const Bar& bar : bars)
        for (const double c : bar.up)
            *at++ = static_cast<signed char>(std::isfinite(c) ? std::lround(127 * std::clamp(c, -1.0, 1.0)) : 0);
    to->AddArray(array);
}

constexpr const char *along_name = "f_y along", *laws_name = "section laws";

/// f_y of laws that are not eq 14, along the bars; nothing where there is none.
void add_yield_along(vtkFieldData* to, const std::vector<Bar>& bars) {
    if (std::ranges::none_of(bars, [](const Bar& b) { return b.yield_along[0] >= 0; })) return;
    const vtkNew<vtkFloatArray> array;
    array->SetName(along_name);
    array->SetNumberOfComponents(3);
    for (const Bar& bar : bars) array->InsertNextTuple(bar.yield_along);
    to->AddArray(array);
}

constexpr const char *width_name = "width [m]", *old_width_name = "width";  // the latter in frames of earlier versions

void add_bars(vtkPolyData* data, const Snapshot& snapshot) {
    const std::vector<Bar> bars = rows_of_cells(snapshot);
    const vtkNew<vtkCellArray> lines;
    lines->Use32BitStorage();
    for (const Bar& bar : snapshot.bars) {
        const vtkIdType ends[2] = {bar.point[0], bar.point[1]};
        lines->InsertNextCell(2, ends);
    }
    data->SetLines(lines);
    vtkCellData* cells = data->GetCellData();
    add_column<vtkFloatArray>(cells, "f_y", bars, [](const Bar& b) { return static_cast<float>(b.yield); });
    add_column<vtkIntArray>(cells, "group", bars, [](const Bar& b) { return b.group; });
    add_column<vtkUnsignedCharArray>(cells, "state", bars,
                                     [](const Bar& b) { return static_cast<std::uint8_t>(b.state); });
    add_column<vtkIntArray>(cells, "member", bars, [](const Bar& b) { return b.member; });
    add_column<vtkIntArray>(cells, "element", bars, [](const Bar& b) { return b.element; });
    add_column<vtkFloatArray>(cells, width_name, bars, [](const Bar& b) { return static_cast<float>(b.width); });
    for (const Column& column : force_columns)
        add_column<vtkFloatArray>(cells, column.name, bars, [&](Bar b) { return static_cast<float>(column.of(b)); });
    // Elsewhere they are the slopes of the moments.
    const bool loaded = std::any_of(bars.begin(), bars.end(), [](const Bar& b) {
        return std::abs(b.Qx[0] - b.Qx[1]) + std::abs(b.Qy[0] - b.Qy[1]) >
               1e-6 * (std::abs(b.Qx[0]) + std::abs(b.Qx[1]) + std::abs(b.Qy[0]) + std::abs(b.Qy[1]));
    });
    for (const Column& column : shear_columns)
        if (loaded)
            add_column<vtkFloatArray>(cells, column.name, bars,
                                      [&](Bar b) { return static_cast<float>(column.of(b)); });
    for (const Column& column : compression_columns)
        if (std::any_of(bars.begin(), bars.end(), [&](Bar b) { return column.of(b) != 0; }))
            add_column<vtkFloatArray>(cells, column.name, bars,
                                      [&](Bar b) { return static_cast<float>(column.of(b)); });
    const bool any_broken =
        std::any_of(bars.begin(), bars.end(), [](const Bar& b) { return b.state == BarState::broken; });
    for (const int end : {0, 1})
        if (any_broken)
            add_column<vtkIntArray>(cells, node_names[end], bars, [&](const Bar& b) { return b.node[end]; });
    add_column<vtkUnsignedCharArray>(cells, "hinges", bars, [](const Bar& b) { return b.hinges; });
    add_column<vtkUnsignedCharArray>(cells, "touched", bars, [](const Bar& b) { return b.touched; });
    add_column<vtkIntArray>(cells, "section", bars, [](const Bar& b) { return b.shape; });
    add_directions(cells, bars);
    add_yield_along(cells, bars);
    cells->SetActiveScalars("f_y");
}

void add_field(vtkPolyData* data, const Snapshot& snapshot) {
    const vtkNew<vtkDoubleArray> time;
    time->SetName("TimeValue");
    time->InsertNextValue(snapshot.time);
    data->GetFieldData()->AddArray(time);
    if (snapshot.factor) {
        const vtkNew<vtkDoubleArray> factor;
        factor->SetName("LoadFactor");
        factor->InsertNextValue(*snapshot.factor);
        data->GetFieldData()->AddArray(factor);
    }
    const vtkNew<vtkStringArray> groups;
    groups->SetName("groups");
    for (const std::string& group : snapshot.groups) groups->InsertNextValue(group);
    data->GetFieldData()->AddArray(groups);
    const vtkNew<vtkIntArray> memberships;
    memberships->SetName("memberships");
    memberships->SetNumberOfComponents(2);
    for (const auto& [member, group] : snapshot.memberships) memberships->InsertNextTuple2(member, group);
    data->GetFieldData()->AddArray(memberships);
    if (!snapshot.connected.empty()) {
        const vtkNew<vtkIntArray> connected;
        connected->SetName("connected nodes");
        connected->SetNumberOfComponents(2);
        for (const auto& [a, b] : snapshot.connected) connected->InsertNextTuple2(a, b);
        data->GetFieldData()->AddArray(connected);
    }
    if (!snapshot.laws.empty()) {
        const vtkNew<vtkStringArray> laws;
        laws->SetName(laws_name);
        for (const std::string& law : snapshot.laws) laws->InsertNextValue(law);
        data->GetFieldData()->AddArray(laws);
    }
    add_surroundings(data->GetFieldData(), snapshot);
}

[[noreturn]] void not_ours(const std::string& name, const std::string& what) {
    throw InputError("cannot read " + name + ": " + what +
                     "; give a .vtp frame that hinge wrote, or run the script again");
}

template <class Array>
Array* find_array(vtkFieldData* in, const char* array, vtkIdType n, const std::string& name) {
    Array* found = Array::SafeDownCast(in->GetAbstractArray(array));
    if (!found) not_ours(name, std::string("it has no array ") + array);
    if (found->GetNumberOfValues() != n) not_ours(name, std::string("its array ") + array + " has the wrong length");
    return found;
}

void read_bars(vtkPolyData* data, Snapshot& snapshot, const std::string& name) {
    const vtkIdType n = data->GetNumberOfLines();
    const vtkIdType rows = data->GetNumberOfCells();
    if (rows != n + data->GetNumberOfPolys()) not_ours(name, "it has cells other than lines and polygons");
    vtkCellData* cells = data->GetCellData();
    auto* f_y = find_array<vtkDataArray>(cells, "f_y", rows, name);
    const auto* group = find_array<vtkIntArray>(cells, "group", rows, name);
    const auto* state = find_array<vtkUnsignedCharArray>(cells, "state", rows, name);
    const auto* member = find_array<vtkIntArray>(cells, "member", rows, name);
    const auto* element = find_array<vtkIntArray>(cells, "element", rows, name);
    auto* width =
        find_array<vtkDataArray>(cells, cells->HasArray(old_width_name) ? old_width_name : width_name, rows, name);
    snapshot.bars.reserve(static_cast<std::size_t>(n));
    for (vtkIdType i = 0; i < n; ++i) {
        vtkIdType count = 0;
        const vtkIdType* ends = nullptr;
        data->GetLines()->GetCellAtId(i, count, ends);
        if (count != 2) not_ours(name, "it has a line of other than two points");
        snapshot.bars.push_back({{static_cast<int>(ends[0]), static_cast<int>(ends[1])},
                                 f_y->GetTuple1(i),
                                 static_cast<BarState>(state->GetValue(i)),
                                 group->GetValue(i),
                                 member->GetValue(i),
                                 element->GetValue(i),
                                 width->GetTuple1(i)});
    }
}

/// n vectors; none where the frame does not have them.
std::vector<std::array<double, 3>> read_vectors(vtkFieldData* from, const char* name, vtkIdType n) {
    std::vector<std::array<double, 3>> vectors;
    auto* array = vtkDataArray::SafeDownCast(from->GetAbstractArray(name));
    if (!array || array->GetNumberOfComponents() != 3 || array->GetNumberOfTuples() != n) return vectors;
    vectors.resize(static_cast<std::size_t>(n));
    for (vtkIdType i = 0; i < n; ++i) array->GetTuple(i, vectors[static_cast<std::size_t>(i)].data());
    return vectors;
}

/// Fields that frames of earlier versions lack.
void read_forces(vtkPolyData* data, Snapshot& snapshot) {
    vtkCellData* cells = data->GetCellData();
    const auto n = static_cast<vtkIdType>(snapshot.bars.size());
    const vtkIdType rows = data->GetNumberOfCells();
    const auto each = [&](const char* name, auto set) {
        auto* column = vtkDataArray::SafeDownCast(cells->GetAbstractArray(name));
        if (!column || column->GetNumberOfValues() != rows) return;
        for (vtkIdType i = 0; i < n; ++i) set(snapshot.bars[i], column->GetTuple1(i));
    };
    for (const Column& column : force_columns)
        each(column.name, [&](Bar& bar, double value) { column.of(bar) = value; });
    for (const Column& column : shear_columns)
        each(column.name, [&](Bar& bar, double value) { column.of(bar) = value; });
    for (const Column& column : compression_columns)
        each(column.name, [&](Bar& bar, double value) { column.of(bar) = value; });
    for (Bar& bar : snapshot.bars)
        for (const int end : {0, 1})
            if (bar.state != BarState::broken) bar.node[end] = bar.point[end];
    for (const int end : {0, 1})
        each(node_names[end], [&](Bar& bar, double value) { bar.node[end] = static_cast<int>(value); });
    each("hinges", [](Bar& bar, double value) { bar.hinges = static_cast<std::uint8_t>(value); });
    each("touched", [](Bar& bar, double value) { bar.touched = static_cast<std::uint8_t>(value); });
    each("section", [](Bar& bar, double value) { bar.shape = static_cast<int>(value); });
    const auto up = read_vectors(cells, up_name, rows), along = read_vectors(cells, along_name, rows);
    for (std::size_t i = 0; i < snapshot.bars.size() && !up.empty(); ++i) snapshot.bars[i].up = (1 / 127.0) * up[i];
    for (std::size_t i = 0; i < snapshot.bars.size() && !along.empty(); ++i)
        std::ranges::copy(along[i], snapshot.bars[i].yield_along);
    auto* laws = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(laws_name));
    for (vtkIdType i = 0; laws && i < laws->GetNumberOfValues(); ++i) snapshot.laws.push_back(laws->GetValue(i));
    auto* members = vtkIntArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("memberships"));
    for (vtkIdType i = 0; members && i + 1 < members->GetNumberOfValues(); i += 2)
        snapshot.memberships.push_back({members->GetValue(i), members->GetValue(i + 1)});
    auto* connected = vtkIntArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("connected nodes"));
    for (vtkIdType i = 0; connected && i + 1 < connected->GetNumberOfValues(); i += 2)
        snapshot.connected.push_back({connected->GetValue(i), connected->GetValue(i + 1)});
}

void read_point_arrays(vtkPolyData* data, Snapshot& snapshot) {
    const vtkIdType n = data->GetNumberOfPoints();
    snapshot.displacement = read_vectors(data->GetPointData(), "displacement [m]", n);
    snapshot.rotation = read_vectors(data->GetPointData(), "rotation [rad]", n);
    auto* held = vtkUnsignedCharArray::SafeDownCast(data->GetPointData()->GetAbstractArray("held"));
    if (held && held->GetNumberOfValues() == n)
        for (vtkIdType i = 0; i < n; ++i) snapshot.held.push_back(held->GetValue(i));
}

}  // namespace

std::string encode_snapshot(const Snapshot& snapshot) {
    check_snapshot(snapshot);
    const vtkNew<vtkPolyData> data;
    add_points(data, snapshot);
    add_bars(data, snapshot);
    add_plates(data, snapshot);
    add_field(data, snapshot);

    const vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(data);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    // In half the time of zlib at level 1, and a third larger.
    writer->SetCompressorTypeToLZ4();
    writer->WriteToOutputStringOn();
    const bool written = writer->Write() != 0;
    const std::string complaint = take_vtk_complaint();
    if (!written || writer->GetErrorCode() != 0)
        throw OutsideError("cannot put the frame together" + (complaint.empty() ? "" : ": " + complaint));
    return writer->GetOutputString();
}

Snapshot decode_snapshot(const std::string& bytes, const std::string& name) {
    // No XML declaration: raw appended data are not XML, and VTK leaves it off.
    if (!bytes.starts_with("<VTKFile")) not_ours(name, "it is not a VTP file");
    const vtkNew<vtkXMLPolyDataReader> reader;
    reader->ReadFromInputStringOn();
    reader->SetInputString(bytes);
    reader->Update();
    const std::string complaint = take_vtk_complaint();
    if (reader->GetErrorCode() != 0 || !complaint.empty())
        not_ours(name, complaint.empty() ? "it is damaged" : "it is damaged (" + complaint + ")");

    vtkPolyData* data = reader->GetOutput();
    vtkFieldData* field = data->GetFieldData();
    Snapshot snapshot;
    snapshot.time = find_array<vtkDoubleArray>(field, "TimeValue", 1, name)->GetValue(0);
    if (field->GetAbstractArray("LoadFactor"))
        snapshot.factor = find_array<vtkDoubleArray>(field, "LoadFactor", 1, name)->GetValue(0);
    const vtkIdType n = data->GetNumberOfPoints();
    const auto* is_virtual = find_array<vtkUnsignedCharArray>(data->GetPointData(), "is_virtual", n, name);
    snapshot.points.resize(static_cast<std::size_t>(n));
    snapshot.is_virtual.resize(static_cast<std::size_t>(n));
    for (vtkIdType i = 0; i < n; ++i) {
        data->GetPoint(i, snapshot.points[i].data());
        snapshot.is_virtual[i] = is_virtual->GetValue(i);
    }
    read_point_arrays(data, snapshot);
    read_bars(data, snapshot, name);
    read_forces(data, snapshot);
    read_surroundings(field, snapshot);
    read_plates(data, snapshot);
    if (auto* groups = vtkStringArray::SafeDownCast(field->GetAbstractArray("groups")))
        for (vtkIdType i = 0; i < groups->GetNumberOfValues(); ++i) snapshot.groups.push_back(groups->GetValue(i));
    try {
        check_snapshot(snapshot);
    } catch (const InputError& e) { not_ours(name, e.what()); }
    return snapshot;
}

}  // namespace hinge::output

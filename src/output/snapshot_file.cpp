// Stills as VTP, and the collection that lets ParaView play them.
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
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <charconv>

#include "core/errors.h"
#include "output/quiet_vtk.h"
#include "output/snapshot_check.h"

namespace hinge::output {
namespace {

/// One cell array: how it is filled from the bars.
template <class Array, class Value>
void add_column(vtkFieldData* to, const char* name, const std::vector<Bar>& bars, Value value) {
    const vtkNew<Array> column;
    column->SetName(name);
    column->SetNumberOfTuples(static_cast<vtkIdType>(bars.size()));
    for (std::size_t i = 0; i < bars.size(); ++i) column->SetValue(static_cast<vtkIdType>(i), value(bars[i]));
    to->AddArray(column);
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
    if (!snapshot.displacement.empty()) {
        const vtkNew<vtkFloatArray> displacement;
        displacement->SetName("displacement [m]");
        displacement->SetNumberOfComponents(3);
        displacement->SetNumberOfTuples(n);
        for (vtkIdType i = 0; i < n; ++i) displacement->SetTuple(i, snapshot.displacement[i].data());
        data->GetPointData()->AddArray(displacement);
    }
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
    {"N0 [N]", [](Bar& b) -> double& { return b.N0; }},
    {"Mx0 [N m]", [](Bar& b) -> double& { return b.Mx0; }},
    {"My0 [N m]", [](Bar& b) -> double& { return b.My0; }},
    {"Mz0 [N m]", [](Bar& b) -> double& { return b.Mz0; }},
};

void add_bars(vtkPolyData* data, const std::vector<Bar>& bars) {
    const vtkNew<vtkCellArray> lines;
    for (const Bar& bar : bars) {
        const vtkIdType ends[2] = {bar.point[0], bar.point[1]};
        lines->InsertNextCell(2, ends);
    }
    data->SetLines(lines);
    vtkCellData* cells = data->GetCellData();
    add_column<vtkDoubleArray>(cells, "f_y", bars, [](const Bar& b) { return b.yield; });
    add_column<vtkIntArray>(cells, "group", bars, [](const Bar& b) { return b.group; });
    add_column<vtkUnsignedCharArray>(cells, "state", bars,
                                     [](const Bar& b) { return static_cast<std::uint8_t>(b.state); });
    add_column<vtkIntArray>(cells, "member", bars, [](const Bar& b) { return b.member; });
    add_column<vtkIntArray>(cells, "element", bars, [](const Bar& b) { return b.element; });
    add_column<vtkDoubleArray>(cells, "width", bars, [](const Bar& b) { return b.width; });
    for (const Column& column : force_columns)
        add_column<vtkFloatArray>(cells, column.name, bars, [&](Bar b) { return static_cast<float>(column.of(b)); });
    add_column<vtkUnsignedCharArray>(cells, "hinges", bars, [](const Bar& b) { return b.hinges; });
    add_column<vtkUnsignedCharArray>(cells, "touched", bars, [](const Bar& b) { return b.touched; });
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
    if (data->GetNumberOfCells() != n) not_ours(name, "it has cells other than lines");
    vtkCellData* cells = data->GetCellData();
    const auto* f_y = find_array<vtkDoubleArray>(cells, "f_y", n, name);
    const auto* group = find_array<vtkIntArray>(cells, "group", n, name);
    const auto* state = find_array<vtkUnsignedCharArray>(cells, "state", n, name);
    const auto* member = find_array<vtkIntArray>(cells, "member", n, name);
    const auto* element = find_array<vtkIntArray>(cells, "element", n, name);
    const auto* width = find_array<vtkDoubleArray>(cells, "width", n, name);
    snapshot.bars.reserve(static_cast<std::size_t>(n));
    for (vtkIdType i = 0; i < n; ++i) {
        vtkIdType count = 0;
        const vtkIdType* ends = nullptr;
        data->GetLines()->GetCellAtId(i, count, ends);
        if (count != 2) not_ours(name, "it has a line of other than two points");
        snapshot.bars.push_back({{static_cast<int>(ends[0]), static_cast<int>(ends[1])},
                                 f_y->GetValue(i),
                                 static_cast<BarState>(state->GetValue(i)),
                                 group->GetValue(i),
                                 member->GetValue(i),
                                 element->GetValue(i),
                                 width->GetValue(i)});
    }
}

/// What frames of earlier versions do not have.
void read_forces(vtkPolyData* data, Snapshot& snapshot) {
    vtkCellData* cells = data->GetCellData();
    const auto n = static_cast<vtkIdType>(snapshot.bars.size());
    const auto each = [&](const char* name, auto set) {
        auto* column = vtkDataArray::SafeDownCast(cells->GetAbstractArray(name));
        if (!column || column->GetNumberOfValues() != n) return;
        for (vtkIdType i = 0; i < n; ++i) set(snapshot.bars[i], column->GetTuple1(i));
    };
    for (const Column& column : force_columns)
        each(column.name, [&](Bar& bar, double value) { column.of(bar) = value; });
    each("hinges", [](Bar& bar, double value) { bar.hinges = static_cast<std::uint8_t>(value); });
    each("touched", [](Bar& bar, double value) { bar.touched = static_cast<std::uint8_t>(value); });
    auto* members = vtkIntArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("memberships"));
    for (vtkIdType i = 0; members && i + 1 < members->GetNumberOfValues(); i += 2)
        snapshot.memberships.push_back({members->GetValue(i), members->GetValue(i + 1)});
}

void read_point_arrays(vtkPolyData* data, Snapshot& snapshot) {
    const vtkIdType n = data->GetNumberOfPoints();
    auto* displacement = vtkDataArray::SafeDownCast(data->GetPointData()->GetAbstractArray("displacement [m]"));
    if (displacement && displacement->GetNumberOfValues() == 3 * n) {
        snapshot.displacement.resize(static_cast<std::size_t>(n));
        for (vtkIdType i = 0; i < n; ++i) displacement->GetTuple(i, snapshot.displacement[i].data());
    }
    auto* held = vtkUnsignedCharArray::SafeDownCast(data->GetPointData()->GetAbstractArray("held"));
    if (held && held->GetNumberOfValues() == n)
        for (vtkIdType i = 0; i < n; ++i) snapshot.held.push_back(held->GetValue(i));
}

std::string xml_text(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '"': out += "&quot;"; break;
            default: out += c;
        }
    }
    return out;
}

/// Shortest digits that read back as the same number, whatever the locale.
std::string shortest(double value) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

}  // namespace

std::string encode_snapshot(const Snapshot& snapshot) {
    check_snapshot(snapshot);
    const vtkNew<vtkPolyData> data;
    add_points(data, snapshot);
    add_bars(data, snapshot.bars);
    add_field(data, snapshot);

    const vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(data);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToZLib();
    // Higher levels take several times as long and save a few per cent.
    writer->SetCompressionLevel(1);
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
    if (auto* groups = vtkStringArray::SafeDownCast(field->GetAbstractArray("groups")))
        for (vtkIdType i = 0; i < groups->GetNumberOfValues(); ++i) snapshot.groups.push_back(groups->GetValue(i));
    try {
        check_snapshot(snapshot);
    } catch (const InputError& e) { not_ours(name, e.what()); }
    return snapshot;
}

std::string encode_collection(int n, const double* times, const char* const* files) {
    std::string text =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "  <Collection>\n";
    for (int i = 0; i < n; ++i)
        text += "    <DataSet timestep=\"" + shortest(times[i]) + "\" group=\"\" part=\"0\" file=\"" +
                xml_text(files[i]) + "\"/>\n";
    return text + "  </Collection>\n</VTKFile>\n";
}

}  // namespace hinge::output

#include "output/snapshot_lists.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>

namespace hinge::output {
namespace {

/// A list of rows of numbers in the field data; nothing where it is empty.
template <class Row>
void add_rows(vtkFieldData* to, const char* name, const std::vector<Row>& rows) {
    if (rows.empty()) return;
    const vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(static_cast<int>(rows[0].size()));
    for (const Row& row : rows) array->InsertNextTuple(row.data());
    to->AddArray(array);
}
template <std::size_t n>
std::vector<std::array<double, n>> read_rows(vtkFieldData* from, const char* name) {
    std::vector<std::array<double, n>> rows;
    auto* array = vtkDoubleArray::SafeDownCast(from->GetAbstractArray(name));
    if (!array || array->GetNumberOfComponents() != static_cast<int>(n)) return rows;
    rows.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
    for (std::size_t i = 0; i < rows.size(); ++i) array->GetTuple(static_cast<vtkIdType>(i), rows[i].data());
    return rows;
}

/// A number that stands for a whole one; -1 for what does not.
int whole(double value) { return value >= 0 && value < 2e9 ? static_cast<int>(value) : -1; }

// What each row of a list in the field data holds.
constexpr const char *sections_name = "sections: kind, width, depth, web, flange [m]",
                     *loads_name = "loads: kind, point, line, place, first and second vector",
                     *parts_name = "loads over a part of a line: load, from, to",
                     *floors_name = "floors: panel, point at a corner",
                     // in frames of earlier versions
                         *old_plates_name = "plates: panel, principal forces [N/m], torn",
                     *ground_name = "ground: point, normal [m]", *joints_name = "joints that can yield";

}  // namespace

void add_surroundings(vtkFieldData* to, const Snapshot& snapshot) {
    std::vector<std::array<double, 5>> sections;
    for (const Shape& s : snapshot.shapes)
        sections.push_back({static_cast<double>(s.kind), s.width, s.depth, s.web, s.flange});
    std::vector<std::array<double, 10>> loads;
    for (const Load& l : snapshot.loads)
        loads.push_back({static_cast<double>(l.kind), static_cast<double>(l.point), static_cast<double>(l.bar), l.at,
                         l.value[0][0], l.value[0][1], l.value[0][2], l.value[1][0], l.value[1][1], l.value[1][2]});
    std::vector<std::array<double, 3>> parts;
    for (std::size_t i = 0; i < snapshot.loads.size(); ++i)
        if (const Load& l = snapshot.loads[i]; l.is_partial()) parts.push_back({static_cast<double>(i), l.from, l.to});
    std::vector<std::array<double, 2>> floors;
    for (std::size_t i = 0; i < snapshot.floors.size(); ++i)
        if (const Panel& panel = snapshot.floors[i]; !panel.has_forces)  // plates are cells
            for (const int p : panel.points) floors.push_back({double(i), double(p)});
    std::vector<std::array<double, 6>> ground;
    for (const Plane& p : snapshot.ground)
        ground.push_back({p.point[0], p.point[1], p.point[2], p.normal[0], p.normal[1], p.normal[2]});
    add_rows(to, sections_name, sections);
    add_rows(to, loads_name, loads);
    add_rows(to, parts_name, parts);
    add_rows(to, floors_name, floors);
    add_rows(to, ground_name, ground);
    add_rows(to, "declared nodes", std::vector<std::array<double, 1>>{{static_cast<double>(snapshot.declared)}});
    if (snapshot.joints) add_rows(to, joints_name, std::vector<std::array<double, 1>>{{1}});
}

void read_surroundings(vtkFieldData* from, Snapshot& snapshot) {
    for (const auto& r : read_rows<5>(from, sections_name))
        snapshot.shapes.push_back({static_cast<Shape::Kind>(std::clamp(whole(r[0]), 0, 2)), r[1], r[2], r[3], r[4]});
    for (const auto& r : read_rows<10>(from, loads_name))
        snapshot.loads.push_back({r[0] == 1 ? Load::moment : Load::force,
                                  whole(r[1]),
                                  whole(r[2]),
                                  r[3],
                                  {{r[4], r[5], r[6]}, {r[7], r[8], r[9]}}});
    for (const auto& r : read_rows<3>(from, parts_name))
        if (const int i = whole(r[0]); i >= 0 && static_cast<std::size_t>(i) < snapshot.loads.size()) {
            Load& l = snapshot.loads[static_cast<std::size_t>(i)];
            l.from = std::clamp(r[1], 0.0, 1.0), l.to = std::clamp(r[2], l.from, 1.0);
        }
    double panel = -1;
    for (const auto& r : read_rows<2>(from, floors_name)) {
        if (snapshot.floors.empty() || r[0] != panel) snapshot.floors.emplace_back();
        panel = r[0], snapshot.floors.back().points.push_back(whole(r[1]));
    }
    for (const auto& r : read_rows<4>(from, old_plates_name))
        if (const int i = whole(r[0]); i >= 0 && static_cast<std::size_t>(i) < snapshot.floors.size()) {
            Panel& p = snapshot.floors[static_cast<std::size_t>(i)];
            p.has_forces = true, p.force[0] = r[1], p.force[1] = r[2], p.torn = r[3] != 0;
        }
    for (const auto& r : read_rows<6>(from, ground_name))
        snapshot.ground.push_back({{r[0], r[1], r[2]}, {r[3], r[4], r[5]}});
    for (const auto& r : read_rows<1>(from, "declared nodes")) snapshot.declared = std::max(0, whole(r[0]));
    for (const auto& r : read_rows<1>(from, joints_name)) snapshot.joints = r[0] != 0;
}

}  // namespace hinge::output

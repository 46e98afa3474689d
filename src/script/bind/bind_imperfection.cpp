// model:imperfection: a structure that is out of plumb, members that are bowed, or the shape of a mode. It changes the
// declared places of nodes, without stress.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/text.h"
#include "model/structure.h"
#include "script/bind/bow_columns.h"
#include "script/bind/mode_box.h"

namespace hinge::script {
namespace {

constexpr const char* call = "model:imperfection";
/// Elements of a member that follows a curve. The growth of the moment under compression is 5 % too small with eight.
constexpr int fewest = 8;
/// Part of the largest displacement of a mode that may be lost because the nodes of a member are too few for its shape.
constexpr double may_be_lost = 0.1;

/// The table on top of the stack, which is the value of a field.
Options standard_of(lua_State* L, const char* field, const char* fields) {
    return Options(L, -1, std::string(call) + ": field '" + field + "', which takes " + fields);
}

void displace(ScriptModel& m, int node, const Vec3& by) {
    m.displace(node, by);
    if (m.crooked.size() <= std::size_t(node)) m.crooked.resize(std::size_t(node) + 1, Vec3::Zero());
    m.crooked[std::size_t(node)] += by;
}

/// The lowest and the highest node, m.
std::pair<double, double> heights(const Model& m) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const NodeData& n : m.nodes()) low = std::min(low, n.position.z()), high = std::max(high, n.position.z());
    return {low, high};
}

/// phi of EN 1993-1-1:2005 (5.5): 1/200, less for high frames and for many columns in a row.
double sway_of_standard(Options& o, double height) {
    const int columns = o.integer("columns", 1, 1);
    const double of_height = std::clamp(2 / std::sqrt(height), 2.0 / 3, 1.0);
    return of_height * std::sqrt(0.5 * (1 + 1.0 / columns)) / 200;
}

void add_sway(Options& o, ScriptModel& m) {
    lua_State* L = o.L();
    if (m.nodes().empty()) throw InputError(std::string(call) + ": the model has no nodes yet; declare them first");
    const auto [low, high] = heights(m);
    const double base = o.number("base", "m", Range::any, low);
    double sway = 0;
    if (o.push_field("sway") == LUA_TTABLE) {
        Options of = standard_of(L, "sway", "standard and columns");
        of.expect({"standard", "columns"});
        of.word("standard", {"EN 1993-1-1"}, "EN 1993-1-1");
        if (!(high > base))
            o.complain("base", show(base) + " m", "must be below the highest node, at " + show(high) + " m");
        sway = sway_of_standard(of, high - base);
    } else {
        sway = o.number("sway", "", Range::any);
        if (!(std::abs(sway) < 0.2))
            o.complain("sway", show(sway), "is a part of the height, and must be between -0.2 and 0.2");
    }
    lua_pop(L, 1);
    const Vec3 to = o.triple("direction", "").value_or(Vec3(1, 0, 0));
    if (to.z() != 0 || !(to.norm() > 0))
        o.complain("direction", "{" + show(to.x()) + ", " + show(to.y()) + ", " + show(to.z()) + "}",
                   "must be horizontal, such as { 1, 0, 0 }: the heights are along z");
    for (std::size_t n = 0; n < m.nodes().size(); ++n)
        displace(m, int(n), sway * (m.nodes()[n].position.z() - base) * to.normalized());
}

/// e0 / L of EN 1993-1-1:2005, table 5.1.
double bow_of_standard(Options& o) {
    static const std::vector<std::string> curves = {"a0", "a", "b", "c", "d"};
    static constexpr double elastic[] = {350, 300, 250, 200, 150}, plastic[] = {300, 250, 200, 150, 100};
    const std::string curve = o.word("curve", curves, "");
    if (curve.empty())
        throw InputError(o.function() + ": field 'curve' is missing; must be 'a0', 'a', 'b', 'c' or 'd'");
    const auto row = std::find(curves.begin(), curves.end(), curve) - curves.begin();
    return 1 / (o.word("analysis", {"plastic", "elastic"}, "plastic") == "plastic" ? plastic : elastic)[row];
}

void must_have_elements(const Options& o, const Model& m, const BowedColumn& column, double bow) {
    int elements = 0;
    for (const ColumnPart& part : column.parts) {
        const MemberData& member = m.members()[std::size_t(part.member)];
        elements += member.elements_by == ElementsBy::undecided ? -10000 : member.elements;
    }
    if (elements >= fewest) return;
    const std::size_t count = column.parts.size();
    o.complain("bow", show(bow),
               "needs " + std::to_string(fewest) + " elements or more in each " +
                   (count > 1 ? "column, which members in line make up" : "member") +
                   ", given with the field 'elements'; member " + std::to_string(column.parts[0].member + 1) +
                   (count > 1 ? " and " + std::to_string(count - 1) + " in line with it have " : " has ") +
                   (elements < 0 ? "'auto'" : std::to_string(elements)));
}

/// Half a sine wave with `bow` times a column's length in its middle; across a member where it is now, out of plumb.
void bend(ScriptModel& m, const BowedColumn& column, double bow, int axis) {
    if (column.parts.size() == 1) {
        const int only = column.parts[0].member;
        const MemberData& member = m.members()[std::size_t(only)];
        const Vec3 span = m.nodes()[std::size_t(member.node[1])].position -
                          m.nodes()[std::size_t(member.node[0])].position,
                   along = axes_of(member, span) * Vec3::Unit(axis);
        return m.add_bow(only, std::copysign(bow, bow * along.dot(column.direction)) * span.norm() * along);
    }
    const Vec3 most = bow * column.length * column.direction;
    const auto wave = [](double at) { return std::sin(std::numbers::pi * at); };
    for (const ColumnPart& part : column.parts) {
        const MemberData& member = m.members()[std::size_t(part.member)];
        std::vector<Vec3> inner;
        for (int k = 1; k < member.elements; ++k) {
            const double t = double(k) / member.elements, at = part.begin + t * (part.end - part.begin);
            inner.push_back((wave(at) - (1 - t) * wave(part.begin) - t * wave(part.end)) * most);
        }
        if (!inner.empty()) m.add_offsets(part.member, inner);
        const int far = part.end > part.begin ? 1 : 0;  // each node once
        if (const double at = std::max(part.begin, part.end); at < 1) displace(m, member.node[far], wave(at) * most);
    }
}

void add_bow(Options& o, ScriptModel& m) {
    lua_State* L = o.L();
    double bow = 0;
    if (o.push_field("bow") == LUA_TTABLE) {
        Options of = standard_of(L, "bow", "curve and analysis");
        of.expect({"curve", "analysis"});
        bow = bow_of_standard(of);
    } else {
        bow = o.number("bow", "", Range::any);
    }
    lua_pop(L, 1);
    if (!(std::abs(bow) < 0.1))
        o.complain("bow", show(bow), "is a part of the member's length, and must be between -0.1 and 0.1");
    const int axis = o.word("axis", {"x", "y"}, "x") == "y" ? 1 : 0;
    int one = -1, group = -1;
    read_members(o, m, one, group);
    std::vector<int> chosen;
    for (int i = 0; i < int(m.members().size()); ++i) {
        const auto& in = m.members()[i].groups;
        if (one >= 0 ? i == one : group < 0 || std::find(in.begin(), in.end(), group) != in.end()) chosen.push_back(i);
    }
    if (chosen.empty()) throw InputError(std::string(call) + ": there is no such member yet; declare members first");
    std::vector<Vec3> straight;
    for (std::size_t n = 0; n < m.nodes().size(); ++n)
        straight.push_back(m.nodes()[n].position - (n < m.crooked.size() ? m.crooked[n] : Vec3(Vec3::Zero())));
    const bool opposite = o.word("sign", {"mode", "same"}, "mode") == "mode";
    const std::vector<BowedColumn> columns = bowed_columns(m, chosen, axis, opposite, straight);
    for (const BowedColumn& column : columns) must_have_elements(o, m, column, bow);
    for (const BowedColumn& column : columns) bend(m, column, bow, axis);
}

void add_mode(Options& o, ScriptModel& m) {
    lua_State* L = o.L();
    o.push_field("mode");
    const ModeBox* mode = find<ModeBox>(L, -1);
    if (!mode) o.complain("mode", show(L, -1), "must be a mode of run:modes or run:buckling");
    lua_pop(L, 1);
    if (mode->record->model.get() != &m) o.complain("mode", "a mode of another model", "must be one of this model");
    const double size = o.number("largest", "m", Range::any);
    const Structure& s = mode->record->run->structure();
    const std::size_t nodes = m.nodes().size();
    bool same = s.model().nodes().size() == nodes && s.model().members().size() == m.members().size();
    for (std::size_t i = 0; same && i < m.members().size(); ++i)
        same = m.members()[i].elements == s.model().members()[i].elements;
    if (!same)
        o.complain("mode", "a mode of a structure with " + std::to_string(s.elements().size()) + " elements",
                   "the model has changed since; find the mode again");
    double largest = 0;
    for (const Vec6& v : mode->shape) largest = std::max(largest, v.head<3>().norm());
    if (!(largest > 0)) o.complain("mode", "a mode in which no node moves", "give another one");
    const auto moved = [&](std::size_t node) -> Vec3 { return size / largest * mode->shape[node].head<3>(); };
    std::vector<std::vector<Vec3>> inside(m.members().size());
    for (std::size_t i = 0; i < m.members().size(); ++i) {
        const MemberData& member = m.members()[i];
        std::vector<Vec3> offsets;
        for (int k = 1; k < member.elements; ++k) {
            const double t = double(k) / member.elements;
            offsets.push_back(moved(std::size_t(s.inner_node(int(i), k))) - (1 - t) * moved(member.node[0]) -
                              t * moved(member.node[1]));
        }
        MemberData bent = member;
        bent.inner = offsets;
        for (int k = 1; k < member.elements; ++k)
            if ((bent.offset(k) - offsets[std::size_t(k) - 1]).norm() > may_be_lost * std::abs(size))
                o.complain("mode", "a mode in which member " + std::to_string(i + 1) + " bends",
                           "needs " + std::to_string(fewest) + " elements or more in that member; it has " +
                               std::to_string(member.elements));
        inside[i] = std::move(offsets);
    }
    for (std::size_t i = 0; i < inside.size(); ++i)
        if (!inside[i].empty()) m.add_offsets(int(i), inside[i]);
    for (std::size_t n = 0; n < nodes; ++n) displace(m, int(n), moved(n));
}

}  // namespace

/// model:imperfection { sway =, direction =, base = }, { bow =, axis =, member = | group = }, { mode =, largest = }
int add_imperfection(lua_State* L) {
    auto& m = self<ModelBox>(L, call).value;
    Options o(L, 2, call);
    o.expect({"sway", "direction", "base", "bow", "axis", "sign", "member", "group", "mode", "largest"});
    const char* const kinds[] = {"sway", "bow", "mode"};
    const char* kind = nullptr;
    for (const char* each : kinds) {
        if (!o.has(each)) continue;
        if (kind)
            o.complain(each, std::string("given beside ") + kind,
                       "give one of 'sway', 'bow' and 'mode', and call it again for another");
        kind = each;
    }
    if (!kind) throw InputError(std::string(call) + ": none of 'sway', 'bow' and 'mode' is given; give one");
    const std::pair<const char*, const char*> of[] = {{"direction", "sway"}, {"base", "sway"},  {"axis", "bow"},
                                                      {"sign", "bow"},       {"member", "bow"}, {"group", "bow"},
                                                      {"largest", "mode"}};
    for (const auto& [field, belongs_to] : of)
        if (o.has(field) && std::string_view(kind) != belongs_to)
            o.complain(field, std::string("given beside ") + kind, std::string("belongs to '") + belongs_to + "'");
    if (o.has("sway")) add_sway(o, *m);
    else if (o.has("bow")) add_bow(o, *m);
    else add_mode(o, *m);
    return 0;
}

}  // namespace hinge::script

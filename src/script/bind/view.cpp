// Reads the settings of a picture from a script.
#include "script/bind/view.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.h"

namespace hinge::script {
namespace {

using Direction = std::array<double, 3>;

/// From where a view of this name looks, where `up` is upwards: the front is what one sees looking along y, or, where y
/// is upwards, against z.
Direction named_direction(const std::string& name, const Direction& up) {
    const bool y_up = std::abs(up[1]) > std::abs(up[2]) && std::abs(up[1]) >= std::abs(up[0]);
    const bool x_up = !y_up && std::abs(up[0]) > std::abs(up[2]);
    const Direction front = y_up ? Direction{0, 0, 1} : Direction{0, -1, 0},
                    right = x_up ? Direction{0, 0, -1} : Direction{1, 0, 0};
    const auto sum = [&](double f, double r, double u) {
        Direction d;
        for (int c = 0; c < 3; ++c) d[c] = f * front[c] + r * right[c] + u * up[c];
        return d;
    };
    const double size = std::hypot(up[0], up[1], up[2]);
    if (name == "front") return front;
    if (name == "back") return sum(-1, 0, 0);
    if (name == "right") return right;
    if (name == "left") return sum(0, -1, 0);
    if (name == "top") return up;
    if (name == "iso") return sum(1, -1, 1 / size);  // the three axes are equally long
    return sum(1.4, -1, 0.55 / size);
}

output::Show show_of(const std::string& name) {
    static const std::pair<const char*, output::Show> all[] = {
        {"f_y", output::Show::yield},    {"group", output::Show::group}, {"broken", output::Show::broken_in},
        {"none", output::Show::nothing}, {"N", output::Show::N},         {"Qx", output::Show::Qx},
        {"Qy", output::Show::Qy},        {"Mx", output::Show::Mx},       {"My", output::Show::My},
        {"Mz", output::Show::Mz}};
    for (const auto& [word, show] : all)
        if (name == word) return show;
    return output::Show::yield;
}

void read_direction(Options& o, output::View& view) {
    const auto direction = [&](const char* name) {
        auto v = o.triple(name, "");
        if (v && v->isZero(0)) o.complain(name, "{0, 0, 0}", "must be a direction");
        return v;
    };
    if (const auto v = direction("up")) view.up = {v->x(), v->y(), v->z()};
    const std::string name = o.word("view", {"front", "back", "left", "right", "top", "iso", "perspective"}, "");
    const auto from = direction("from");
    if (!name.empty() && from)
        o.complain("from", "given beside view = '" + name + "'", "says where the eye is, too: give one of the two");
    if (from) view.from = {from->x(), from->y(), from->z()};
    if (from) return;
    view.from = named_direction(name, view.up);
    view.parallel = !name.empty() && name != "perspective";
    if (name == "top") view.up = view.from == std::array<double, 3>{0, 1, 0} ? Direction{0, 0, -1} : Direction{0, 1, 0};
}

constexpr const char* axis_names[3] = {"x", "y", "z"};

/// plane = { y = 0 } on top of the stack.
void read_planes(lua_State* L, const Options& o, output::View& view) {
    for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
        const std::string key = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : "";
        const auto axis = std::find(axis_names, axis_names + 3, key);
        if (axis == axis_names + 3 || lua_type(L, -1) != LUA_TNUMBER || !std::isfinite(lua_tonumber(L, -1)))
            o.complain("plane", "a field '" + key + "'",
                       "must be x, y or z with a number of metres, such as { y = 0 }");
        view.plane[std::size_t(axis - axis_names)] = lua_tonumber(L, -1);
    }
    if (std::ranges::none_of(view.plane, [](const auto& p) { return p.has_value(); }))
        o.complain("plane", "{}", "must have x, y or z, such as { y = 0 }");
}

/// Of each element where its ends were at the start along an axis, m.
std::vector<std::array<double, 2>> starts_along(const output::Snapshot& snapshot, std::size_t c) {
    std::vector<std::array<double, 2>> all;
    for (const output::Bar& bar : snapshot.bars) {
        const auto end = [&](int side) {
            const auto p = std::size_t(bar.node[side] >= 0 ? bar.node[side] : bar.point[side]);
            return snapshot.points[p][c] - (snapshot.displacement.empty() ? 0 : snapshot.displacement[p][c]);
        };
        all.push_back({end(0), end(1)});
    }
    return all;
}

/// Looks across the plane where nothing says from where. Where no member lies in it, the error names where some do.
void read_plane(lua_State* L, Options& o, output::View& view, const output::Snapshot& snapshot, bool directed) {
    if (o.push_field("plane") == LUA_TTABLE) read_planes(L, o, view);
    lua_pop(L, 1);
    static constexpr Direction from[3] = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
    for (std::size_t c = 0; c < 3; ++c) {
        if (!view.plane[c]) continue;
        if (!directed) {
            view.from = from[c], view.parallel = true;
            if (view.up[0] == 0 && view.up[1] == 0 && c == 2) view.up = {0, 1, 0};
        }
        const auto starts = starts_along(snapshot, c);
        const auto here = [&](const std::array<double, 2>& at) {
            return std::abs(at[0] - *view.plane[c]) <= 1e-3 && std::abs(at[1] - *view.plane[c]) <= 1e-3;
        };
        if (std::ranges::any_of(starts, here)) continue;
        std::set<double> there;  // to the millimetre
        for (const auto& [a, b] : starts)
            if (std::abs(a - b) <= 1e-3) there.insert(std::round(1e3 * a) / 1e3);
        std::string list;
        int named = 0;
        for (const double at : there)
            if (++named <= 6) list += (list.empty() ? "" : ", ") + number_text(at);
        const std::string axis = axis_names[c] + std::string(" = ");
        o.complain("plane", axis + number_text(*view.plane[c]) + " m, where no member lies",
                   list.empty() ? "must be a plane in which members lie"
                                : "must be a plane of members: " + axis + list + (named > 6 ? ", ..." : "") + " m");
    }
}

/// broken_in = { runs =, members = how many the structure has, count = { [member] = in how many runs it broke, ... } }
void read_broken_in(lua_State* L, Options& o, output::View& view, const output::Snapshot& snapshot) {
    if (o.push_field("broken_in") == LUA_TTABLE) {
        const auto field = [&](const char* name) {
            lua_getfield(L, -1, name);
            const int value = int(lua_tointeger(L, -1));
            lua_pop(L, 1);
            return value;
        };
        int members = 0;
        for (const output::Bar& bar : snapshot.bars) members = std::max(members, bar.member);
        if (field("members") != members)
            o.complain("show", "'broken'",
                       "is of a structure of " + std::to_string(field("members")) + " members, and this frame has " +
                           std::to_string(members));
        view.runs = field("runs");
        lua_getfield(L, -1, "count");
        for (int m = 1; m <= members; ++m) {
            lua_rawgeti(L, -1, m);
            view.broken_in.push_back(int(lua_tointeger(L, -1)));
            lua_pop(L, 1);
        }
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
}

void read_marks(lua_State* L, Options& o, output::View& view) {
    if (o.push_field("scale") == LUA_TSTRING) view.scale = 0;  // "auto"
    lua_pop(L, 1);
    if (view.scale != 0) view.scale = o.number("scale", "", Range::positive, 1);
    view.largest = o.number("largest", "N or N m", Range::positive, 0);
    view.show = show_of(o.word("show", {"f_y", "group", "broken", "none", "N", "Qx", "Qy", "Mx", "My", "Mz"}, "f_y"));
    view.ghost = o.flag("ghost", view.ghost);
    view.supports = o.flag("supports", view.supports);
    view.ground = o.flag("ground", view.ground);
    view.floors = o.flag("floors", view.floors);
    view.hinges = o.flag("hinges", view.hinges);
    view.loads = o.flag("loads", view.loads);
    if (o.push_field("labels") == LUA_TSTRING) {
        const std::string what = lua_tostring(L, -1);
        view.node_labels = what == "nodes", view.member_labels = what == "members";
    } else {
        view.node_labels = view.member_labels = lua_toboolean(L, -1);
    }
    lua_pop(L, 1);
}

void read_box(lua_State* L, Options& o, output::View& view) {
    if (o.push_field("box") == LUA_TTABLE) {
        view.box.emplace();
        for (int i = 0; i < 6; ++i) {
            lua_rawgeti(L, -1, i + 1);
            (*view.box)[i] = lua_tonumber(L, -1);
            lua_pop(L, 1);
        }
        for (int c : {0, 2, 4})
            if (!((*view.box)[c] <= (*view.box)[c + 1]))
                o.complain("box",
                           std::string("a smallest ") + "xyz"[c / 2] + " of " + number_text((*view.box)[c]) +
                               " m, above the largest, " + number_text((*view.box)[c + 1]) + " m",
                           "must be { xmin, xmax, ymin, ymax, zmin, zmax }");
    }
    lua_pop(L, 1);
}

/// The snapshot's number of the group on top of the stack; -1 where a frame that was read has none of that name.
int group_on_top(lua_State* L, const std::string& what, const output::Snapshot& snapshot, const SnapshotBox* box) {
    if (box) return group_argument(L, -1, what, *box->model, &box->structure->model());
    const std::string name = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
    const auto at = std::find(snapshot.groups.begin(), snapshot.groups.end(), name);
    return at != snapshot.groups.end() ? int(at - snapshot.groups.begin()) : -1;
}

void read_groups(lua_State* L, Options& o, output::View& view, const output::Snapshot& snapshot,
                 const SnapshotBox* box) {
    if (o.push_field("groups") == LUA_TTABLE) {
        view.groups.emplace();
        for (lua_Integer i = 1, n = lua_Integer(lua_rawlen(L, -1)); i <= n; ++i) {
            lua_rawgeti(L, -1, i);
            view.groups->push_back(
                group_on_top(L, "picture: field 'groups', item " + std::to_string(i), snapshot, box));
            lua_pop(L, 1);
        }
    }
    lua_pop(L, 1);
}

}  // namespace

output::View read_view(lua_State* L, int index, const output::Snapshot& snapshot, const SnapshotBox* box) {
    Options o(L, index, "picture", true);
    output::View view;
    view.width = o.integer("width", 1, view.width);
    view.height = o.integer("height", 1, view.height);
    const bool directed = o.has("view") || o.has("from");
    read_direction(o, view);
    read_plane(L, o, view, snapshot, directed);
    read_marks(L, o, view);
    read_broken_in(L, o, view, snapshot);
    view.leave_out_broken = o.flag("leave_out_broken", false);
    view.above = o.number("above", "m", Range::any, view.above);
    if (const auto t = o.text("title")) view.title = *t;
    read_box(L, o, view);
    read_groups(L, o, view, snapshot, box);
    o.finish();
    return view;
}

}  // namespace hinge::script

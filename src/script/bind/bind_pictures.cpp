// Pictures and frames of a run that a script draws.
#include <algorithm>
#include <cmath>

#include "output/film.h"
#include "output/hinge_marks.h"
#include "script/bind/drawing.h"
#include "record/folders.h"
#include "script/lua/picture_module.h"
#include "script/bind/view.h"
#include "script/bind/modules.h"
#include "script/bind/snapshot_box.h"
#include "record/snapshot.h"

namespace hinge::script {
namespace {

const SnapshotBox& snapshot_argument(lua_State* L, int index, const char* function) {
    if (auto* s = find<SnapshotBox>(L, index)) return *s;
    throw InputError(std::string(function) + ": takes a snapshot made by run:snapshot(), got " + show(L, index));
}
/// core.write_frame(snapshot): adds it to frames.pvd in the output folder.
int write_frame(lua_State* L) {
    const output::Snapshot& snapshot = snapshot_argument(L, 1, "write_frame").value;
    const auto c = context(L);
    const std::string folder = c->output.folder.empty() ? "." : c->output.folder;
    prepare_folder(*c, folder + "/frames/");
    auto& frames = c->output.frames;
    char file[48];
    std::snprintf(file, sizeof file, "frames/frame_%05zu.vtp", frames.size() + 1);
    draw(L, {.what = DrawingOrder::What::frame, .path = folder + "/" + file, .snapshots = {snapshot}});
    frames.push_back({snapshot.time, file});
    draw(L, {.what = DrawingOrder::What::collection, .path = folder + "/frames.pvd", .frames = frames});
    return 0;
}

/// The snapshot with what run:hinges said of its hinges and joints, { { element =, end =, ratio =, joint = }, ... } at
/// that place of the stack; as it is where there is nothing. A joint with a limit is shown though it never yielded.
output::Snapshot with_marks(lua_State* L, int index, const output::Snapshot& snapshot) {
    output::Snapshot marked = snapshot;
    if (!lua_istable(L, index)) return marked;
    for (output::Bar& bar : marked.bars) bar.hinges = std::uint8_t((bar.hinges & 7) | output::hinges_compared);
    for (lua_Integer i = 1, n = lua_Integer(lua_rawlen(L, index)); i <= n; ++i) {
        lua_rawgeti(L, index, i);
        const auto number = [&](const char* field) {
            lua_getfield(L, -1, field);
            const double value = lua_tonumber(L, -1);
            lua_pop(L, 1);
            return value;
        };
        const double element = number("element"), end = number("end"), ratio = number("ratio");
        lua_getfield(L, -1, "joint");
        const bool joint = lua_toboolean(L, -1) != 0;
        lua_pop(L, 2);
        if (!(element >= 1 && element <= double(marked.bars.size()))) continue;
        output::Bar& bar = marked.bars[std::size_t(element) - 1];
        bar.rotation[end == 2 ? 1 : 0] = ratio;
        bar.hinges |= output::band_bits(end == 2 ? 2 : 1, output::band_of(ratio));
        if (joint) marked.joints = true;
        if (joint) bar.hinges |= std::uint8_t(end == 2 ? 2 : 1);
    }
    return marked;
}

/// core.write_picture(snapshot, view, path, marks)
int write_picture(lua_State* L) {
    const SnapshotBox& box = snapshot_argument(L, 1, "write_picture");
    if (lua_type(L, 3) != LUA_TSTRING) throw InputError("write_picture: the path is " + show(L, 3) + "; give a string");
    const output::View view = read_view(L, 2, box.value, &box);
    const std::string path = lua_tostring(L, 3);
    prepare_folder(*context(L), path);
    draw(L, {.path = path, .snapshots = {with_marks(L, 4, box.value)}, .views = {view}});
    return 0;
}

/// core.write_strip(snapshots, views, columns, path, marks): as many views as snapshots; marks: of each, false for none
int write_strip(lua_State* L) {
    const char* file = luaL_checkstring(L, 4);  // these raise: nothing may be pending yet
    const int columns = int(luaL_checkinteger(L, 3));
    const std::string path = file;
    std::vector<output::Snapshot> marked;
    std::vector<output::View> views;
    for (lua_Integer i = 1, n = lua_rawlen(L, 1); i <= n; ++i) {
        lua_rawgeti(L, 1, i);
        lua_rawgeti(L, 2, i);
        const SnapshotBox& box = snapshot_argument(L, lua_absindex(L, -2), "write_strip");
        if (lua_istable(L, 5)) lua_rawgeti(L, 5, i);
        else lua_pushnil(L);
        marked.push_back(with_marks(L, lua_absindex(L, -1), box.value));
        lua_pop(L, 1);
        views.push_back(read_view(L, lua_absindex(L, -1), box.value, &box));
        lua_pop(L, 2);
    }
    prepare_folder(*context(L), path);
    draw(L, {.what = DrawingOrder::What::strip,
             .path = path,
             .snapshots = std::move(marked),
             .views = std::move(views),
             .columns = columns});
    return 0;
}

/// core.pieces(run): what a picture of the run is made of, with the mass on each node (figs 4 and 5). An element's mass
/// lies half on each of its nodes, a broken one's wholly on the node that carries it; its virtual node has none. With
/// the loads that act: N and N m, of a spread one per m at the two ends of its bar. With f_y along bars whose law is
/// not eq 14, and the laws of a structure that has such bars.
int pieces(lua_State* L) {
    const Run& run = *run_argument(L, 1, "pieces: the run")->run;
    const Structure& structure = run.structure();
    const output::Snapshot snapshot = make_snapshot(run);
    std::vector<double> mass(snapshot.points.size(), 0);
    for_each_weight(structure, run.state(), [&](int node, double weight) { mass[node] += weight; });
    for (std::size_t i = 0; i < run.state().offset_mass.size(); ++i) mass[i] += run.state().offset_mass[i].mass;
    const auto flag = [&](const char* name, bool v) { lua_pushboolean(L, v), lua_setfield(L, -2, name); };
    const auto number = [&](const char* name, double v) { lua_pushnumber(L, v), lua_setfield(L, -2, name); };
    const auto whole = [&](const char* name, lua_Integer v) { lua_pushinteger(L, v), lua_setfield(L, -2, name); };
    lua_createtable(L, 0, 3);
    lua_createtable(L, int(snapshot.points.size()), 0);
    for (std::size_t i = 0; i < snapshot.points.size(); ++i) {
        lua_createtable(L, 0, 6);
        number("x", snapshot.points[i][0]), number("y", snapshot.points[i][1]), number("z", snapshot.points[i][2]);
        number("mass", mass[i]);
        flag("virtual", snapshot.is_virtual[i]), flag("gone", i < run.state().gone.size() && run.state().gone[i]);
        lua_rawseti(L, -2, lua_Integer(i) + 1);
    }
    lua_setfield(L, -2, "nodes");
    lua_createtable(L, int(snapshot.bars.size()), 0);
    for (std::size_t i = 0; i < snapshot.bars.size(); ++i) {
        const output::Bar& bar = snapshot.bars[i];
        lua_createtable(L, 0, 6);
        whole("a", bar.point[0] + 1), whole("b", bar.point[1] + 1), whole("member", bar.member),
            whole("element", bar.element);
        flag("rigid", bar.state == output::BarState::broken), number("f_y", bar.yield);
        if (bar.yield_along[0] >= 0) {
            lua_createtable(L, 3, 0);
            for (int k = 0; k < 3; ++k) lua_pushnumber(L, bar.yield_along[k]), lua_rawseti(L, -2, k + 1);
            lua_setfield(L, -2, "f_y_along");
        }
        lua_rawseti(L, -2, lua_Integer(i) + 1);
    }
    lua_setfield(L, -2, "bars");
    lua_createtable(L, int(snapshot.loads.size()), 0);
    for (std::size_t i = 0; i < snapshot.loads.size(); ++i) {
        const output::Load& load = snapshot.loads[i];
        lua_createtable(L, 0, 5);
        whole("node", load.point + 1), whole("bar", load.bar + 1), number("at", load.at);
        flag("moment", load.kind == output::Load::moment);
        if (load.is_partial()) number("from", load.from), number("to", load.to);
        lua_createtable(L, 6, 0);
        for (int k = 0; k < 6; ++k) lua_pushnumber(L, load.value[k / 3][std::size_t(k % 3)]), lua_rawseti(L, -2, k + 1);
        lua_setfield(L, -2, "value");
        lua_rawseti(L, -2, lua_Integer(i) + 1);
    }
    lua_setfield(L, -2, "loads");
    lua_createtable(L, int(snapshot.laws.size()), 0);
    for (std::size_t i = 0; i < snapshot.laws.size(); ++i)
        lua_pushstring(L, snapshot.laws[i].c_str()), lua_rawseti(L, -2, lua_Integer(i) + 1);
    lua_setfield(L, -2, "laws");
    return 1;
}

/// A frame written before, and the view of it at that place of the stack.
std::pair<output::Snapshot, output::View> read_frame(lua_State* L, const char* file, int view) {
    char error[512] = "";
    std::pair<output::Snapshot, output::View> frame;
    must_work(picture_function<hinge_read_snapshot>(*context(L), "hinge_read_snapshot")(file, frame.first, error,
                                                                                        sizeof error),
              error);
    frame.second = read_view(L, view, frame.first, nullptr);
    return frame;
}

/// core.render_file(vtp, png, view): draws a frame written before.
int render_file(lua_State* L) {
    const char *from = luaL_checkstring(L, 1), *to = luaL_checkstring(L, 2);
    luaL_checktype(L, 3, LUA_TTABLE);
    char error[512] = "";
    const auto [snapshot, view] = read_frame(L, from, 3);
    must_work(picture_function<hinge_render>(*context(L), "hinge_render")(to, snapshot, view, error, sizeof error),
              error, to);
    return 0;
}

/// core.frame_box(vtp, view): of a picture of this frame { box = what it would show without stray fragments, { xmin,
/// xmax, ymin, ymax, zmin, zmax } in m, nil where that is nothing; scale = of displacements; largest = magnitude of the
/// diagram's values, N or N m; groups = the names of the frame's groups; statics = whether it has no time }.
int frame_box(lua_State* L) {
    const char* from = luaL_checkstring(L, 1);
    luaL_checktype(L, 2, LUA_TTABLE);
    char error[512] = "";
    output::FrameBox found;
    const auto [snapshot, view] = read_frame(L, from, 2);
    must_work(
        picture_function<hinge_frame_box>(*context(L), "hinge_frame_box")(snapshot, view, &found, error, sizeof error),
        error);
    lua_createtable(L, 0, 5);
    if (found.box) {
        lua_createtable(L, 6, 0);
        for (int i = 0; i < 6; ++i) lua_pushnumber(L, (*found.box)[std::size_t(i)]), lua_rawseti(L, -2, i + 1);
        lua_setfield(L, -2, "box");
    }
    lua_pushnumber(L, found.scale), lua_setfield(L, -2, "scale");
    lua_pushnumber(L, found.largest), lua_setfield(L, -2, "largest");
    lua_createtable(L, int(snapshot.groups.size()), 0);
    lua_Integer i = 0;
    for (const std::string& group : snapshot.groups)
        lua_pushlstring(L, group.data(), group.size()), lua_rawseti(L, -2, ++i);
    lua_setfield(L, -2, "groups");
    lua_pushboolean(L, snapshot.factor.has_value()), lua_setfield(L, -2, "statics");
    return 1;
}

}  // namespace

void open_pictures(lua_State* L, int module) {
    static const luaL_Reg functions[] = {{"write_frame", guarded<write_frame>},
                                         {"write_picture", guarded<write_picture>},
                                         {"write_strip", guarded<write_strip>},
                                         {"render_file", guarded<render_file>},
                                         {"frame_box", guarded<frame_box>},
                                         {"pieces", guarded<pieces>},
                                         {nullptr, nullptr}};
    lua_pushvalue(L, module);
    luaL_setfuncs(L, functions, 0);
    lua_pop(L, 1);
}

}  // namespace hinge::script

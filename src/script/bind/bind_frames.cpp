// core.pack_frames: the frames of a run, packed for a page.
#include "record/frame_pack.h"
#include "script/lua/picture_module.h"
#include "script/bind/modules.h"
#include "script/bind/snapshot_box.h"

namespace hinge::script {
namespace {

using output::Snapshot;

/// core.pack_frames(files, not_shown): what a page takes of these frames, those of the last one's model, as JSON, how
/// many they are, and what is wrong with those that cannot be read, { [index in files] = message }; `not_shown`: how
/// many others the run has, which the page is to tell. nil, 0, ... where there is none.
int pack_frames(lua_State* L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    const lua_Integer not_shown = luaL_optinteger(L, 2, 0);
    const auto c = context(L);
    std::vector<std::string> files;
    for (lua_Integer i = 1, n = lua_Integer(lua_rawlen(L, 1)); i <= n; ++i) {
        lua_rawgeti(L, 1, i);
        files.emplace_back(lua_tostring(L, -1) ? lua_tostring(L, -1) : "");
        lua_pop(L, 1);
    }
    std::vector<Snapshot> frames;
    lua_newtable(L);
    const int problems = lua_gettop(L);
    for (std::size_t i = 0; i < files.size(); ++i) {
        Snapshot s;
        char error[512] = "";
        if (picture_function<hinge_read_snapshot>(*c, "hinge_read_snapshot")(files[i].c_str(), s, error,
                                                                             sizeof error) == 0) {
            frames.push_back(std::move(s));
            continue;
        }
        lua_pushstring(L, error);
        lua_rawseti(L, problems, lua_Integer(i) + 1);
    }
    if (frames.empty()) return lua_pushnil(L), lua_pushinteger(L, 0), lua_pushvalue(L, problems), 3;
    std::vector<const Snapshot*> kept;
    for (const Snapshot& s : frames)
        if (same_model(s, frames.back())) kept.push_back(&s);
    Json j = packed_frames(kept, Packing::small);
    j["of_other_models"] = frames.size() - kept.size();
    j["not_shown"] = not_shown;
    const std::string text = j.dump(-1, ' ', false, Json::error_handler_t::replace);
    lua_pushlstring(L, text.data(), text.size());
    lua_pushinteger(L, lua_Integer(kept.size()));
    lua_pushvalue(L, problems);
    return 3;
}

/// core.base64(bytes): as a page takes a picture.
int base64_for_script(lua_State* L) {
    std::size_t size = 0;
    const char* bytes = luaL_checklstring(L, 1, &size);
    const std::string text = base64({bytes, size});
    return lua_pushlstring(L, text.data(), text.size()), 1;
}

}  // namespace

void open_frames(lua_State* L, int module) {
    static const luaL_Reg functions[] = {
        {"pack_frames", guarded<pack_frames>}, {"base64", guarded<base64_for_script>}, {nullptr, nullptr}};
    lua_pushvalue(L, module);
    luaL_setfuncs(L, functions, 0);
    lua_pop(L, 1);
}

}  // namespace hinge::script

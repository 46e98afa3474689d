// A C++ host: the engine without Lua, with a fracture rule in C++ and a run that is recorded in a folder; then a Lua
// state of the host's own, in which a script declares the same cantilever and is given the same rule.
//
// Run     see CMakeLists.txt here
// Shows   how to make a section, declare, step and record a model in C++, and how a script gets at C++ and the host at
//         its results
// Expect  twice the same line: the cantilever breaks after 6.2 ms. What the run leaves lies in the folder that is named
#include <cstdio>
#include <lua.hpp>
#include <memory>

#include "effects/fracture.h"
#include "effects/loads.h"
#include "record/recording.h"
#include "run/dynamics.h"
#include "section/shapes.h"

namespace {

/// The host's rule: a section breaks where the curvatures' sum of squares passes a limit, 1/m.
bool breaks(double curvature_x, double curvature_y) {
    return curvature_x * curvature_x + curvature_y * curvature_y > 0.12 * 0.12;
}

/// `folder`: for history.csv, events.csv and summary.json; "": nothing is written.
void engine_alone(const char* folder) {
    auto steel = std::make_shared<hinge::Material>();
    steel->E = 206e9, steel->G = 79e9, steel->density = 7850;
    const auto bar = std::make_shared<const hinge::Section>(
        hinge::make_section(hinge::box_shape({.width = 0.05, .depth = 0.05, .web = 0.008, .flange = 0.008})));

    auto model = std::make_shared<hinge::Model>(hinge::ModelOptions{});
    const int foot = model->add_node({0, 0, 0}), tip = model->add_node({1, 0, 0});
    model->fix(foot, 63);
    model->add_member({{foot, tip}, bar, steel, {0, 0, 1}, 2, {}});
    hinge::NodalLoad load{tip};
    load.force = {0, 0, -1e4};
    hinge::add_load(*model, load);
    hinge::FractureRule rule;
    rule.hook = [](const hinge::SectionView& s) { return breaks(s.strain.curvature_x, s.strain.curvature_y); };
    hinge::add_fracture(*model, rule);

    const auto structure = std::make_shared<const hinge::Structure>(model);
    hinge::DynamicSettings settings;
    settings.dt = 1e-5, settings.duration = 0.05;
    auto record = std::make_shared<hinge::RunRecord>();
    record->run = std::make_shared<hinge::Dynamics>(structure, hinge::initial_state(*structure), settings);
    record->probes.push_back(
        std::make_shared<hinge::Probe>(hinge::Probe{tip, hinge::Probe::Quantity::displacement, 2, "tip", {}, {}}));
    record->every = 10;
    auto context = std::make_shared<hinge::Context>();
    context->output.folder = folder;
    hinge::record_run(*context, record);
    const hinge::Run& run = *record->run;
    while (run.count_members(-1).broken == 0 && hinge::record_step(context, record)) {}
    hinge::write_summary(*context);
    std::printf("C++: %ld of 1 members broken at t = %.4f s, tip at %.9f m\n", run.count_members(-1).broken,
                run.state().time, run.displacement(tip)[2]);
}

int rule_for_scripts(lua_State* L) {
    lua_getfield(L, 1, "curvature_x");
    lua_getfield(L, 1, "curvature_y");
    lua_pushboolean(L, breaks(lua_tonumber(L, -2), lua_tonumber(L, -1)));
    return 1;
}

const char script[] = R"(
local hinge = require "hinge"
local rule = ...
local steel = hinge.material { E = 206e9, G = 79e9, density = 7850 }
local bar = hinge.section.box { width = 0.05, depth = 0.05, thickness = 0.008 }
local model = hinge.model()
local foot, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
model:fix(foot)
model:member { foot, tip, section = bar, material = steel, up = { 0, 0, 1 } }
model:load { node = tip, force = { 0, 0, -1e4 } }
model:fracture(rule)
local run = model:dynamic { dt = 1e-5, duration = 0.05 }
while run:count { state = "broken" } == 0 and run:step() do end
local _, _, z = run:displacement(tip)
return run:count { state = "broken" }, run.time, z
)";

/// `prefix`: where hinge is installed; leave it out when the module is on Lua's cpath already.
bool with_lua(const char* prefix) {
    lua_State* L = luaL_newstate();
    luaL_openlibs(L);
    if (prefix) {
        lua_getglobal(L, "package");
        lua_pushfstring(L, "%s/lib/lua/5.4/?.so", prefix);
        lua_setfield(L, -2, "cpath");
        lua_pop(L, 1);
    }
    bool ok = luaL_loadbuffer(L, script, sizeof script - 1, "=script") == LUA_OK;
    if (ok) {
        lua_pushcfunction(L, rule_for_scripts);
        ok = lua_pcall(L, 1, 3, 0) == LUA_OK;
    }
    if (ok)
        std::printf("Lua: %d of 1 members broken at t = %.4f s, tip at %.9f m\n", int(lua_tointeger(L, -3)),
                    lua_tonumber(L, -2), lua_tonumber(L, -1));
    else std::fprintf(stderr, "host: %s\n", lua_tostring(L, -1));
    lua_close(L);
    return ok;
}

}  // namespace

int main(int argc, char** argv) {
    engine_alone(argc > 2 ? argv[2] : "");
    return with_lua(argc > 1 ? argv[1] : nullptr) ? 0 : 1;
}

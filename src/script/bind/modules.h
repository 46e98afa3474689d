// What each file of the binding adds to hinge.core, the table at that place of the stack, and to the kinds of objects.
#pragma once

#include <lua.hpp>

namespace hinge::script {

void open_values(lua_State* L, int module);    ///< hinge.material, hinge.section
void open_backbone(lua_State* L, int module);  ///< hinge.backbone
void open_joints(lua_State* L, int module);    ///< hinge.joint
void open_model(lua_State* L, int module);     ///< hinge.model
void open_objects(lua_State* L);               ///< nodes, members, groups, loads
void open_cases(lua_State* L);
void open_run(lua_State* L);
void open_checkpoint(lua_State* L, int module);  ///< run:checkpoint, run:resume, hinge.resume
void open_floors(lua_State* L, int module);      ///< panels of model:floor
void open_modes(lua_State* L);                   ///< run:modes, run:buckling
void open_hinges(lua_State* L, int module);      ///< run:hinges (lua/hinge/results/hinges.lua)
void open_reading(lua_State* L);                 ///< results of runs, nodes and members
void open_output(lua_State* L, int module);      ///< summary and other files
void open_pictures(lua_State* L, int module);
void open_plots(lua_State* L, int module);
void open_frames(lua_State* L, int module);        ///< frames for a page
void open_film(lua_State* L, int module);          ///< shared data of hinge render
void open_measure(lua_State* L, int module);       ///< clock, memory, callback of every run
void open_processes(lua_State* L, int module);     ///< cases of a study
void open_interpreters(lua_State* L, int module);  ///< of other languages, behind walls
void open_walls(lua_State* L, int module);         ///< core.raise_walls and the like

}  // namespace hinge::script

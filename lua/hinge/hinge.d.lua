---@meta hinge
-- What a script can say, for editors that read LuaLS annotations. Nothing here runs.
--
-- Units are SI throughout: m, kg, s, N, Pa, rad. Wrong input raises an error at the script's own line that names the
-- function, the field, the value, its unit and what is allowed. What goes wrong in the physics or the numbers is a
-- result, never an error: see run.verdict. "eq" and "section" refer to Lynn and Isobe's paper on the ASI-Gauss
-- technique. Jobs, models and the report are in library.d.lua.
--
-- reference.lua makes reference.md from this. What is said of a class, an alias, a function or a field stands in the
-- lines above it, or behind a field where it is short; what is said of a parameter or a result, behind it and in lines
-- below that begin with `---` and two blanks. The fenced Lua above a function is its example: it runs as it stands,
-- after the lines at the top of reference.md; a test runs them all.

---@class hinge
---@field version string
---@field section hinge.sections the ready shapes, and any other by its properties
local hinge = {}

---@alias vec3 number[] three numbers { x, y, z }
---@alias hinge.component "ux"|"uy"|"uz"|"rx"|"ry"|"rz" displacement (m) or rotation vector (rad), in space

---Goes on from a checkpoint: run:resume(file).
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---swing:step()
---swing:checkpoint "swing.checkpoint"
---local again = model:dynamic { dt = 1e-4, duration = 0.01 }
---hinge.resume(again, "swing.checkpoint"):finish()
---```
---@param run hinge.run
---@param file string
---@return hinge.run
function hinge.resume(run, file) end

---An empty model.
---```lua
---local frame = hinge.model { elements_per_member = 4 }
---local linear = hinge.model { displacement = "small", plasticity = false }
---```
---@param options? hinge.model_options
---@return hinge.model
function hinge.model(options) end

---@class hinge.model_options
---where the one integration point of an element stands (section 2). asi-gauss (default): at the two Gauss points of a
---pair of elements while elastic, opposite the hinge once one forms; needs an even number of elements in a member. asi:
---in the middle while elastic. conventional: always in the middle
---@field formulation? "asi-gauss"|"asi"|"conventional"
---large (default): the geometry follows the motion (the paper's ULF), rotations and twist of any number of turns too.
---small: it stays as it was (TLF)
---@field displacement? "large"|"small"
---what goes to a hinge. plastic (default): the plastic strain's integration point alone, so the pair of
---elements keeps its exact elastic stiffness and the energy balance closes. whole: as the paper prints it (eqs 6,
---10). The elastic point goes to the hinge too, and its partner's point to the middle; forces stay continuous but the
---elastic energy jumps, which the energy error shows
---@field shift? "plastic"|"whole"
---where the axial force of an element acts in large displacement. member (default): on the element's chord, and on the
---bending of each pair of elements between its ends, by the stability functions of the exact beam-column
---(src/beam/beam_column.h). Elastic columns buckle at Euler's load to 0.1 % with two elements. One that is clamped at
---both ends and cannot sway needs four to bend out; statics counts that load with two, too, dynamics warns of it. What
---its compression adds to the moments of loads along it (0.7 N / N_clamped at first) takes four, too. chord: on the
---chord alone, as in the paper. Two elements a member then carry too much in compression: a pinned column 2.27 times
---Euler's load, a clamped one whose head sways 1.22 times; four elements 1.10 times each. member needs formulation
---asi-gauss, displacement large and shift plastic; without them the default is chord
---@field p_delta? "chord"|"member"
---how the weight of members acts. members (default): along them. It acts at the nodes of their elements, and a member's
---two end nodes get what that misses of the end moments of a load along it; `member:forces` has the part between the
---nodes, too. End forces and displacements of joints are then those of a load `q` of the same size: exact in elastic
---members with two elements in small displacement. nodes: at the nodes alone, as in the paper. The end moments of a
---clamped member of two elements are then 0.63 of w L^2 / 12, with four 0.91, and the shear forces at its ends 1/2 and
---3/4 of w L / 2. With mass cubic the nodes' weights give the end moments by themselves. In dynamics weight acts along
---the members of bodies that are carried: a support holds one of the body's nodes in a direction in which gravity acts,
---or a connector (broken or not) joins it to the ground or to such a body. What falls, and what lies on others or on
---model:ground, has weight at nodes alone: there inertia bends a member as little as weight does. So has a member with
---a broken element, and in dynamics one whose weight is beyond its plastic limit load between clamped ends,
---16 M_p / L^2
---@field weight? "members"|"nodes"
---linear (default): the paper's consistent mass of linear shape functions (after eq 15). cubic: the mass
---of a pair of asi-gauss elements in the cubic shape that its stiffness stands for; not in the paper,
---equally fast. Sway frequencies of slender frames with two elements a member are within 0.2 %, where linear has 1 to
---4 %; with stocky members they are less exact; a pinned member's own vibration is 5 % off with two elements and 0.2 %
---with four. Newmark's method and statics only, no fracture
---@field mass? "linear"|"cubic"
---@field plasticity? boolean default true; false lets nothing yield whatever the materials say
---default 2, the paper's. "auto": 2, and 4, 8 or 16 in members that a scene compresses or that yield between their
---ends. The first run decides, once for all runs of the model, from what is declared by then: one linear solution in
---statics, with all loads and gravity in full (every load case with factor 1; those with a history as at time 0, or in
---full where that is 0). Compression counts by what it takes from the bending stiffness. With p_delta = "member", the
---default, two elements have that exactly, and members from Euler's load on get four. Four go to a member where moments
---between its ends reach the fully plastic one, and to one with loads of its own that yields anywhere. Impacts, motions
---of supports, `hold` of a static run and loads that are functions of the run are not in it, and bodies that model:fix
---does not hold keep two. The solution is a direct one: 0.5 s for a cubic frame of 3400 members, 6 s for 11,000. hinge
---plan and summary.json say how many members got how many, and why. asi-gauss only
---@field elements_per_member? integer|"auto"
---of elements = "auto": by how much the bending stiffness of a compressed member may miss, as a part of that without
---compression, and near Euler's load the load at which it buckles; default 0.01
---@field elements_accuracy? number

---A linear elastic, perfectly plastic material.
---```lua
---local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = 325e6 }
---```
---@param options { E: number, nu?: number, G?: number, density?: number, yield_stress?: number }
---  E Pa; nu default 0.3; G Pa, in the place of nu, default E / (2 (1 + nu)); density kg/m^3, default 0, needed in
---  dynamics; yield_stress Pa, left out: never yields
---@return hinge.material
function hinge.material(options) end

---@class hinge.material read-only
---@field E number Pa
---@field G number Pa
---@field density number kg/m^3
---@field yield_stress number Pa; infinite: never yields

-- Sections -----------------------------------------------------------------------------------------------------------

---Cross-sections. Local z runs along the member, y is the direction of its `up`, x completes them. Width is measured
---along x, depth along y. Plastic resultants of eq 14: N0 = A fy, Mx0 = Zx fy, My0 = Zy fy, Mz0 = Zz fy / sqrt 3, with
---exact plastic moduli. Shear areas: Cowper (1966) with Poisson's ratio 0, which is 5/6 for a rectangle.
---@class hinge.sections
local section = {}

---Closed box. J and Mz0 by Bredt: 4 Am^2 / sum(length / t) and 2 Am t with the thinnest wall.
---```lua
---local column = hinge.section.box { width = 0.4, depth = 0.4, thickness = 0.022 }
---```
---@param options { width: number, depth: number, thickness?: number, web?: number, flange?: number }
---  outer sizes and walls, m; thickness for all walls, or web (the walls along y) and flange
---@return hinge.section
function section.box(options) end

---H (I, wide flange) with its web along y: Ix is the strong axis. J = sum b t^3 / 3; Mz0
---from the plates' heaps of sand.
---```lua
---local girder = hinge.section.h { depth = 0.4, width = 0.2, web = 0.008, flange = 0.013 }
---```
---@param options { depth: number, width: number, web: number, flange: number }
---  outer sizes and thicknesses, m; no fillets
---@return hinge.section
function section.h(options) end

---Round tube; all values exact.
---```lua
---local brace = hinge.section.pipe { diameter = 0.1143, thickness = 0.0045 }
---```
---@param options { diameter: number, thickness: number } outer diameter and wall, m
---@return hinge.section
function section.pipe(options) end

---Solid rectangle. J: series of the stress function (0.140577 b^4 for a square); Mz0: b^2 (3 d - b) / 6 with b <= d.
---```lua
---local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
---```
---@param options { width: number, depth: number } m
---@return hinge.section
function section.solid(options) end

---Solid circle.
---```lua
---local rod = hinge.section.round { diameter = 0.03 }
---```
---@param options { diameter: number } m
---@return hinge.section
function section.round(options) end

---Any section by its properties.
---```lua
---local hea200 = hinge.section.general { area = 53.8e-4, Ix = 36.9e-6, Iy = 13.4e-6, J = 0.21e-6,
---  plastic = { A = 53.8e-4, Zx = 429e-6, Zy = 204e-6 }, size = { width = 0.2, depth = 0.19 } }
---```
---@param options hinge.section_options
---@return hinge.section
function section.general(options) end

---@class hinge.section_options
---@field area number m^2
---@field Ix number m^4; bends about x, deflection along y
---@field Iy number m^4; bends about y, deflection along x
---@field J number torsion constant, m^4
---@field shear_area_x? number m^2, default 5/6 of the area
---@field shear_area_y? number m^2, default 5/6 of the area
---@field mass_Ix? number m^4, of the rotary inertia; default Ix
---@field mass_Iy? number m^4, default Iy
---@field N0? number fully plastic resultants of eq 14, N and N m, whatever the material; one left out is taken from
---@field Mx0? number `plastic`, and without that never limits
---@field My0? number
---@field Mz0? number
---m^2, m^3; multiplied by the yield stress, Zz by yield stress / sqrt 3
---@field plastic? { A?: number, Zx?: number, Zy?: number, Zz?: number }
---m along x and y, for contact and pictures; without it both are the root of the area
---@field size? { width: number, depth: number }
---@field kind? string a name for messages

---@class hinge.section read-only
---@field kind string
---@field area number m^2
---@field Ix number m^4
---@field Iy number m^4
---@field J number m^4
---@field shear_area_x number m^2
---@field shear_area_y number m^2
---@field plastic_area number m^2; 0: never limits, likewise Zx, Zy and Zz
---@field Zx number plastic moduli, m^3
---@field Zy number m^3
---@field Zz number m^3, of torsion
---@field N0? number N; what was given of it, likewise Mx0, My0 and Mz0
---@field Mx0? number N m
---@field My0? number N m
---@field Mz0? number N m
---@field width number m, along x; 0: the root of the area, likewise depth
---@field depth number m, along y

-- Models -------------------------------------------------------------------------------------------------------------

-- Handles. Two handles to the same thing are the same value, so == compares them and they can be keys of a table.
-- tostring says what one stands for, and of what is gone since when it is. A handle of another model is refused
-- everywhere, and so is one of a model that was closed. Lists are arrays in the order of declaration, made anew by each
-- call: `for _, member in ipairs(group:members()) do ... end`. What a method reads of a run is of the latest run made
-- of the model where none is given; while none has been made, that is an error.

---A joint.
---@class hinge.node
---@field x number as declared, m
---@field y number
---@field z number
---@field index integer from 1, in the order of declaration
---@field fixed string? what is fixed, as model:fix takes it: "all" or such as "x,y,rx"; nil: nothing
local node = {}

---```lua
---local _, _, uz = tip:displacement()
---print(("the tip goes down by %.3f mm"):format(-1000 * uz))
---```
---@param run? hinge.run default: the latest of the model
---@return number ux, number uy, number uz, number rx, number ry, number rz m and rotation vector, rad
function node:displacement(run) end

---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }:finish()
---local _, _, vz = tip:velocity(swing)
---```
---@param run? hinge.run default: the latest of the model
---@return number vx, number vy, number vz, number wx, number wy, number wz m/s and rad/s
function node:velocity(run) end

---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }:finish()
---local _, _, az = tip:acceleration(swing)
---```
---@param run? hinge.run default: the latest of the model
---@return number ax, number ay, number az, number bx, number by, number bz m/s^2 and rad/s^2
function node:acceleration(run) end

---```lua
---local _, _, fz, _, my = wall:reaction()
---print(("the wall carries %.0f N and %.0f N m"):format(fz, my))
---```
---@param run? hinge.run default: the latest of the model
---@return number fx, number fy, number fz, number mx, number my, number mz
---  what the support exerts on the node, N and N m
function node:reaction(run) end

---```lua
---local x, y, z = tip:position()
---```
---@param run? hinge.run default: the latest of the model
---@return number x, number y, number z where it is now, m
function node:position(run) end

---A bar between two joints.
---@class hinge.member
---@field a hinge.node
---@field b hinge.node
---@field length number as declared, m
---@field mass number kg
---@field group string? name of its first group, which colours it; nil: none
---@field section hinge.section
---@field material hinge.material
---@field up vec3 direction of the section's y axis, as given
---@field elements integer|"auto" how many it is divided into; "auto" until the first run decides
---@field index integer from 1, in the order of declaration
local member = {}

---```lua
---for _, joint in ipairs(beam:nodes()) do print(joint.index, joint.x) end
---```
---@return hinge.node[] a_and_b
function member:nodes() end

---```lua
---for _, group in ipairs(beam:groups()) do print(group.name) end
---```
---@return hinge.group[]
function member:groups() end

---Section resultants at its two ends; all zero once the element there is broken.
---```lua
---local at_a, at_b = beam:forces()
---print(at_a.Mx, at_b.Qy, at_a.f_y) -- N m, N, 1 where fully plastic
---```
---@param run? hinge.run default: the latest of the model
---@return hinge.resultants at_a, hinge.resultants at_b
function member:forces(run) end

---What has become of it. A member is broken once one of its elements is.
---```lua
---local state, f_y = beam:state()
---print(state, f_y) -- elastic, and how near the most stressed section is to fully plastic
---```
---@param run? hinge.run default: the latest of the model
---@return "elastic"|"yielded"|"broken" state, number f_y, number? time, integer? element f_y: the largest now; of a
---  broken member, when its first element broke (s; nil: before this run began) and which of its elements it was
function member:state(run) end

---Members that were given the same name. `#group` is their number.
---@class hinge.group
---@field name string
---@field size integer its members, as #group
---@field length number of all its members, m
---@field mass number kg
local group = {}

---```lua
---for _, member in ipairs(model:group("arm"):members()) do print(member.length, member:state()) end
---```
---@return hinge.member[]
function group:members() end

---```lua
---model:velocity("arm", { 0, 0, -2 })
---for _, joint in ipairs(model:group("arm"):nodes()) do print(joint.x, joint.fixed) end
---```
---@return hinge.node[] nodes the joints of its members, each once
function group:nodes() end

---@alias hinge.group_like hinge.group|string

---A load on a node.
---@class hinge.load
---@field node hinge.node
---@field force vec3 N
---@field moment vec3 N m
---@field case? string name of its load case; nil: it belongs to none
local load = {}

---Takes it off the model. Runs that are over keep it, and one under way may not step on (run:step); any later use of
---the handle is an error that says where it was removed.
---```lua
---local prop = model:load { node = tip, force = { 0, 0, 500 } }
---local held = model:static():finish()
---prop:remove()
---local fall = model:dynamic { from = held, dt = 1e-4, duration = 0.01 }:finish()
---```
function load:remove() end

---A load case, made by model:case.
---@class hinge.case
---@field name string
local case = {}

---As model:load; the load belongs to this case.
---```lua
---local snow = model:case "snow"
---snow:load { member = beam, q = { 0, 0, -2e3 } }
---local under_snow = model:static { loads = { snow = 1 } }:finish()
---```
---@param options hinge.load_options
---@return hinge.load? load
function case:load(options) end

---As model:gravity; gravity belongs to this case.
---```lua
---local dead = model:case "dead"
---dead:gravity { 0, 0, -9.80665 }
---local design = model:static { loads = { dead = 1.35 } }:finish()
---```
---@param acceleration vec3 m/s^2
function case:gravity(acceleration) end

---@class hinge.model
local model = {}

---```lua
---for _, node in ipairs(model:nodes()) do print(node.index, node.x, node.y, node.z, node.fixed) end
---```
---@return hinge.node[]
function model:nodes() end

---```lua
---local longest = 0
---for _, member in ipairs(model:members()) do longest = math.max(longest, member.length) end
---```
---@return hinge.member[]
function model:members() end

---```lua
---for _, group in ipairs(model:groups()) do print(group.name, #group, group.mass) end
---```
---@return hinge.group[]
function model:groups() end

---```lua
---for _, load in ipairs(model:loads()) do print(load.node, load.force[3], load.case) end
---```
---@return hinge.load[] loads those that were not removed
function model:loads() end

---```lua
---model:case "dead"
---for _, case in ipairs(model:cases()) do print(case.name) end
---```
---@return hinge.case[]
function model:cases() end

---Frees the model and its runs at once, whatever handles there are; any later use of one is an error
---that says where the model was closed. Models that nobody refers to are freed without it. An error
---inside a step of one of its own runs.
---```lua
---for storeys = 1, 3 do
---  local tower = hinge.model()
---  tower:node { 0, 0, 3 * storeys }
---  tower:close()
---end
---```
function model:close() end

---Adds a joint.
---```lua
---local top = model:node { 0, 0, 3 } -- x, y, z; z is up by custom
---```
---@param position vec3 m
---@return hinge.node
function model:node(position) end

---Fixes degrees of freedom of one node or of a list of nodes, beside those that are fixed.
---```lua
---model:fix(wall) -- all six
---model:fix({ wall, tip }, "y,rx,rz") -- bends in the plane of x and z alone
---```
---@param node hinge.node|hinge.node[]
---@param what? string "all" (default), or letters: "xyz" displacements, "rx", "ry", "rz" rotations, as in "x,y,rx"
function model:fix(node, what) end

---Adds a member between two joints, to which it is rigidly connected.
---```lua
---local column = model:member { wall, model:node { 0, 0, 3 }, section = square, material = steel,
---  up = { 1, 0, 0 }, group = "columns", elements = 4 }
---```
---@param options hinge.member_options
---@return hinge.member
function model:member(options) end

---@class hinge.member_options
---@field [1] hinge.node
---@field [2] hinge.node
---@field section hinge.section
---@field material hinge.material
---direction of the section's y axis, any vector across the member, default upwards (along
---space x for an upright member)
---@field up? vec3
---@field group? string|hinge.group|(string|hinge.group)[] the first one colours it
---@field elements? integer|"auto" default as the model's elements_per_member, which tells what "auto" does

---Adds a load on a node. Three numbers are fixed in direction; a function is called once a step with the time at its
---end (s) and the run as it is at its beginning (dynamics only). It returns three numbers, or a table of three. In the
---first step of a run it is also called with the time at which the run begins.
---
---Or a load on a member, or on each member that a group has by now: `q` and `moment` over its whole length, linear
---between `a` and `b`, its two ends, or with `at` a force and moment at that point. The member's end nodes get the
---fixed-end forces of the whole Timoshenko member, so that end forces in linear statics are exact for any number of
---elements, and joint displacements are those of the stiffness (closed form with asi-gauss). run:forces includes the
---load, and yield and a fracture rule's forces go by the same: plastic limit loads under uniform load are exact with
---two elements in pinned and clamped members. Hinges stand at nodes: a propped member, whose hinge belongs 0.414 of the
---length from the prop, carries 12 M_p / L^2 with two or four elements and 11.73 with eight, where 11.66 is right. A
---fracture rule's strains and limits are those of the elements' own deformation. With large displacement, forces in
---space keep their direction, those in local axes rotate with each element, and the fixed-end moments are those in the
---member's present axes, by its elastic stiffness. An element that breaks loses its part of the load. Such a load gives
---no handle; it can be left out, but not removed.
---
---A static run takes no load with a history, on nodes or on members, for it has no time; where `loads` of the run names
---its load case, it takes the numbers in full, whatever the history. It is an error if all loads have one. A dynamic
---run that goes on from another goes on in its time: a history that begins with the second run begins at that time.
---Points that are over by then, that change less than 5 % before the run's end, or that act for less than two steps,
---are warned of.
---```lua
---model:load { node = tip, force = { 0, 0, -1000 } } -- N
---model:load { member = beam, q = { 0, 0, -200 } } -- N/m
---model:load { node = tip, force = { 5e3, 0, 0 }, history = { { 0, 1 }, { 0.01, 0 } } } -- a blast of 10 ms
---```
---@param options hinge.load_options
---@return hinge.load? load of a load on a node
function model:load(options) end

---@class hinge.load_options
---@field node? hinge.node
---@field member? hinge.member in the place of node
---@field group? hinge.group_like in the place of node: each of its members
---@field q? vec3|table N/m, or { a = vec3, b = vec3 } at the member's two ends, where one left out is zero
---@field force? vec3|fun(time: number, run: hinge.run): number N, in space; of a member at the point `at`
---N m, in space; of a member N m/m, as `q`, or N m at the point `at`; numbers alone
---@field moment? vec3|fun(time: number, run: hinge.run): number
---@field at? number of a member, the part of its length from its first end, 0 to 1
---of a member: "global" (default) in space, per length of the member; "projected" in space, per length of its
---projection on the plane across the load at the start, as snow (`q` alone); "local" in its x, y, z axes
---@field axes? "global"|"projected"|"local"
---factor of the numbers over time (s), a function or points { { time, factor }, ... }, default 1. Two points at one
---time are a jump: the first holds up to there, the second from there on. At a jump where
---a step ends, that step ends with the value before and the next begins with the one after. Where points jump, or have
---a slope shorter than 20 steps, a step with a jump or a kink in it acts with their mean over it: no impulse is lost.
---Times are those of the run, which go on where `from` is a dynamic run. Of a
---function only the values at the ends of steps are known
---@field history? fun(time: number): number|number[][]
---@field case? hinge.case|string the load case that it belongs to, see model:case; default: none, it acts in every run

---Declares a load case: loads belong to it that are declared with case = it, or by case:load and case:gravity. A run
---says in `loads` which cases it takes and with which factors. Loads, and gravity, that belong to no case act in every
---run.
---Called again with the same name it returns the same case.
---```lua
---local live = model:case "live"
---model:load { node = tip, force = { 0, 0, -500 }, case = live }
---local half = model:static { loads = { live = 0.5 } }:finish()
---```
---@param name string
---@return hinge.case
function model:case(name) end

---A sum of load cases by name, for `loads` of runs: model:combination("uls", { dead = 1.35, live = 1.5 }). Combinations
---that were declared before may be in it.
---```lua
---model:case("dead"):gravity { 0, 0, -9.80665 }
---model:case("live"):load { node = tip, force = { 0, 0, -500 } }
---model:combination("uls", { dead = 1.35, live = 1.5 })
---local design = model:static { loads = "uls" }:finish()
---```
---@param name string that no case and no other combination has
---@param factors table<string, number>
function model:combination(name, factors) end

---Attaches a point mass to a node: it has inertia, has weight where the model has gravity, and rotates with the node.
---Several on one node add up. In steps it is a rigid offset mass, as broken members are (paper, fig 5): momentum,
---energy and weight are in the same accounts as those of members. A node that loses its last member by fracture flies
---on with its mass; if it then has no rotary inertia, it stops rotating. A mass that is declared after a run takes
---part in runs that go on from that one. It is an error if the node has no member when a run begins. `hinge check`
---includes it in masses and natural periods.
---```lua
---model:mass { node = tip, mass = 20, inertia = 0.1 } -- kg, kg m^2
---```
---@param options hinge.mass_options
function model:mass(options) end

---@class hinge.mass_options
---@field node hinge.node it may be fixed: then the support carries it
---@field mass number kg, above 0
---kg m^2, 0 or above, about axes through the mass: about every axis, or { Jx, Jy, Jz } about the x, y and z of space as
---they are before anything has moved; default 0
---@field inertia? number|vec3
---@field offset? vec3 m, from the node to the mass, before anything has moved; default { 0, 0, 0 }

---Moves supports: fixes these degrees of freedom, and in a dynamic run takes them along a path, counted from where the
---run begins. Velocity and acceleration follow by differences over the last steps. Before the run a support moved as in
---the state that the run begins from, or stood still. A path may start and stop at once, which is an impact. The work
---of the supports is in the energy balance. In statics they stand still.
---```lua
---model:move { node = wall, z = { { 0, 0 }, { 0.1, 0.01 }, { 0.2, 0 } } } -- up by 10 mm and down again
---local shaken = model:dynamic { dt = 1e-3, duration = 0.2 }:finish()
---```
---@param options hinge.move_options
function model:move(options) end

---@class hinge.move_options
---@field node hinge.node|hinge.node[]
---displacement, m, over time, s: a function, or points { { time, displacement }, ... }
---@field x? fun(time: number): number|number[][]
---@field y? fun(time: number): number|number[][] likewise
---@field z? fun(time: number): number|number[][] likewise

---Gravity on every member's mass and on point masses. The weight of members acts along them, as `weight` of hinge.model
---says, and a clamped member of two elements has end moments of w L^2 / 12 and w L^2 / 24 in the middle. Yield goes by
---these, as with loads `q` (model:load). Called again, the last call counts, for runs made after it; it is an error to
---call it for another load case.
---```lua
---model:gravity { 0, 0, -9.80665 }
---local rest = model:static():finish()
---```
---@param acceleration vec3 m/s^2, such as { 0, 0, -9.80665 }
---@param load_case? hinge.case|string the load case that it belongs to; default: none
function model:gravity(acceleration, load_case) end

---Initial velocity of a node, a member or a group as a rigid body; of a node the last call counts. Statics keeps
---velocities as they are. A run that goes on from another (`from`) has that one's velocities, but for targets that got
---one since that run was made: these begin with it, as a rigid body where they are then. So a velocity may be given
---before or after statics. What supports hold stays at rest; it is an error if that is all.
---```lua
---model:velocity(tip, { 0, 0, -3 }) -- m/s
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }:finish()
---```
---@param target hinge.node|hinge.member|hinge.group_like of a group, the joints that it has by now
---@param linear vec3 m/s, of the mean of the target's joints
---@param angular? vec3 rad/s about that point
function model:velocity(target, linear, angular) end

---Lets members break where a limit is reached (section 2.3, eq 16). The paper's critical curvature 0.0004 can only be
---per millimetre, so 0.4 here. Or where a function returns true. Of several rules the last one that applies to a
---member's groups counts. An error in a function undoes the step and is raised where the script asked for the step.
---```lua
---model:fracture { curvature_x = 0.4, curvature_y = 0.4, axial_strain = 0.3 }
---model:fracture(function(section) return section.plastic_work > 500 end) -- J
---```
---@param rule hinge.fracture_rule|fun(section: hinge.section_view): boolean?
function model:fracture(rule) end

---@class hinge.fracture_rule
---@field curvature_x? number 1/m, either sign
---@field curvature_y? number 1/m, either sign
---@field axial_strain? number -, either sign unless tension_only
---@field tension_only? boolean default false
---asked of a section, where no limit is reached; true: it breaks. The section is the same object at every call and can
---be read while the function runs
---@field rule? fun(section: hinge.section_view): boolean?
---sections that `rule` is asked of. plastic (default): those fully plastic in this step, and those that were before
---when a curvature or the axial strain of their element is larger than ever: nothing is missed by a rule that looks at
---such strains; yielded: all that were ever fully plastic; all. Those of members that cannot yield are always asked
---@field where? "plastic"|"yielded"|"all"
---names of numbers that the rule keeps of each section, such as { "damage" }: fields of the section that can be set, 0
---at the start; they belong to the run's state
---@field keep? string[]
---in the place of `rule`: asked once a step of all elements of the members; returns a
---list of places of those that break
---@field batch? fun(elements: hinge.element_list): integer[]?
---@field group? hinge.group_like only its members, default all

---A section as a fracture rule sees it where the step has ended. Strains are the element's: elastic and plastic, only
---plastic, and their change over the step divided by dt.
---@class hinge.section_view
---@field time number s
---@field dt number s
---@field step integer from 1
---@field member integer
---@field element integer
---@field end integer 1 or 2 of the element; written section["end"], end being a word of Lua
---@field node integer? index of the joint that it is at; nil: it is inside its member
---@field group string? name of the member's first group
---@field plastic boolean fully plastic in this step
---@field curvature_x number 1/m
---@field curvature_y number 1/m
---@field axial_strain number
---@field twist number 1/m, turns counted
---@field plastic_curvature_x number 1/m
---@field plastic_curvature_y number 1/m
---@field plastic_axial_strain number
---@field plastic_twist number 1/m
---@field curvature_rate_x number 1/(m s)
---@field curvature_rate_y number 1/(m s)
---@field axial_strain_rate number 1/s
---@field twist_rate number 1/(m s)
---@field Mx number N m
---@field My number N m
---@field N number N
---@field Mz number N m
---@field f_y number eq 14
---@field plastic_work number J, of the element so far
---@field broken number 0

---All elements of a fracture rule's members, always in the same order: `count` of them (also `#elements`), and for
---every field of a section an array with one number each; Mx, My, f_y, node and plastic have one for each end (Mx1,
---Mx2, ...; node 0 inside a member, plastic 1 or 0). Broken elements stay in their places, with broken = 1 and zeros.
---An array is the same table at every step, filled when it is asked for.
---@class hinge.element_list
---@field count integer
---@field time number s
---@field dt number s
---@field step integer

---Lets members collide. surface (the default): bars, round with half the smaller side of their section as radius, press
---on each other where their axes come closest, k g^2 / 2 for a penetration g; nothing is lost but by friction. gap
---(section 2.4, eqs 17-19): four gap elements bind two elements for a while, and what they hold when the bars part
---springs back. Members that share a joint, or overlap when first seen, do not meet until they have parted. Called
---again it adds a rule: of several, the last one that fits both members' groups counts.
---```lua
---local bar = model:member { model:node { 0.5, -0.5, 0.06 }, model:node { 0.5, 0.5, 0.06 }, section = square,
---  material = steel, group = "bar" }
---model:velocity("bar", { 0, 0, -5 })
---model:contact { between = { "bar", "arm" }, friction = 0.3 }
---local hit = model:dynamic { dt = "auto", duration = 4e-3 }:finish()
---print(hit.contacts.bound, bar:state())
---```
---@param rule? hinge.contact_rule
function model:contact(rule) end

---@class hinge.contact_rule
---@field rule? "surface"|"gap" default surface
---@field groups? hinge.group_like[] only members of these, default all
---@field between? hinge.group_like[] two groups: one member of each, in the place of groups
---asked once of two members when they come near: nil or true: this rule's numbers; false: they never meet; a table:
---other numbers (rule, stiffness, friction, binding_time, release, contact_length, coplanarity_tolerance)
---@field pairs? fun(a: hinge.member, b: hinge.member): boolean|hinge.contact_rule|nil
---called at the end of a step in which two elements were bound or began to press on each other
---@field on_contact? fun(event: hinge.contact_event)
---@field on_release? fun(event: hinge.contact_event) likewise, when they were released or parted
---surface: k, N/m; default EA / L, EA the harmonic mean of the two members', L the mean length of their elements
---@field stiffness? number
---@field friction? number surface: Coulomb's coefficient, default 0; its heat is in contact_released of run.energy
---@field binding_time? number gap: default 0.5e-3 s
---gap: parting (default): held from the binding time on until the bars part and little is stored, and that is given
---back as an impulse; time: cut at the binding time, as in the paper, and what is stored is lost
---@field release? "parting"|"time"
---@field contact_length? number gap: C_l of eq 18, default 1.8
---@field coplanarity_tolerance? number gap: alpha of eq 19, default 3e-4 m^3
---default true: a pair is looked at only when the two could have met; false: every pair at every step, the same bits at
---several times the cost
---@field sleep? boolean
---gap: eqs 17-19 as printed, looked at only where a step begins, which lets fast members pass through each other;
---release is then "time"
---@field as_printed? boolean

---@class hinge.contact_event
---@field time number s
---@field a hinge.member
---@field b hinge.member
---@field element_a integer
---@field element_b integer

---Springs, dashpots, curves and laws between two nodes, { a, b, ... }, or between a node and the ground where the node
---is declared, { node, ground = true, ... }: along and about three axes. What is given for a direction adds up. A
---direction without anything is free. Node a carries the connector on a rigid arm that reaches to b: the deformation
---is the displacement of b from the end of that arm, along the axes (m), and the rotation vector of b relative to a
---(rad). Both are zero as the model is declared. In large displacement the axes rotate with a; those of the ground
---stay. A force pulls b back and a along with it, with its moment on a: momentum is kept. In statics dashpots have no
---force. Explicit steps must be shorter than 2 / (d + sqrt(d^2 + w^2)). Here w^2 (1/s^2) and d (1/s) are upper bounds
---of k/m and c/m, summed over all connectors at a node, with the lumped masses of the nodes and the highest frequency
---of the members there. dt = "auto" keeps this limit; Newmark's steps are at most 0.9 / w, with w of the springs alone.
---Laws of a script are not in these limits. Energy: run.energy.connector_stored and connector_dissipated. It is an
---error if nothing is given that acts, or if a run is made with a node that belongs to no member or with too long an
---explicit step.
---```lua
---model:connector { tip, ground = true, stiffness = { z = 1e5 }, damping = { z = 200 } } -- N/m, N s/m
---local other = model:node { 1, 0, -1 }
---model:fix(other)
---local rope = model:connector { tip, other, stiffness = { z = 1e6 }, capacity = { z = 5e3 } } -- parts at 5 kN
---```
---@param options hinge.connector_options
---@return hinge.connector
function model:connector(options) end

---@class hinge.connector_options
---@field [1] hinge.node a
---@field [2]? hinge.node b; left out with ground = true
---@field ground? boolean the other end is the ground, default false
---@field axes? { x: vec3, y: vec3 } default global; y is taken square to x, z square to both
---N/m along x y z, N m/rad about them: not negative
---@field stiffness? { x?: number, y?: number, z?: number, rx?: number, ry?: number, rz?: number }
---N s/m along x y z, N m s/rad about them: not negative
---@field damping? { x?: number, y?: number, z?: number, rx?: number, ry?: number, rz?: number }
---of a direction, points { { deformation, force }, ... } (m, N; rad, N m), elastic and linear between them, going on as
---straight as it ends: from { 0, 0 } on for both signs, or from below 0 to above
---@field curve? { x?: number[][], y?: number[][], z?: number[][], rx?: number[][], ry?: number[][], rz?: number[][] }
---of a direction, a function of deformation (m, rad), its rate (1/s of it), state and dt (s, 0 where nothing passes)
---that returns the force (N, N m), and the new state if it keeps one: a table of numbers by name, empty at first, the
---same where none is returned. The state belongs to the run's: it is undone with a step and kept in checkpoints. The
---function is called several times a step, each time with the state that the last step left. All of its work counts as
---dissipated. An error undoes the step and is raised where the script asked for the step
---@field law? { x?: function, y?: function, z?: function, rx?: function, ry?: function, rz?: function }
---N, N m: where a step ends with this force or more in one direction, either sign, the whole connector is gone, and
---what it stored with it; default: it never breaks. run.wakings lists it
---@field capacity? { x?: number, y?: number, z?: number, rx?: number, ry?: number, rz?: number }

---A connector that model:connector declared. What it reads is of the run that is given, or the latest of its model.
---@class hinge.connector
local connector = {}

---The deformation of the connector, m and rad; of a broken one, that at which it broke.
---```lua
---local spring = model:connector { tip, ground = true, stiffness = { z = 1e5 } }
---model:static():finish()
---local _, _, z = spring:deformation()
---```
---@param run? hinge.run
---@return number x, number y, number z, number rx, number ry, number rz
function connector:deformation(run) end

---The force that pulls b back, N and N m, along the axes; 0 once it is broken.
---```lua
---local spring = model:connector { tip, ground = true, stiffness = { z = 1e5 } }
---model:static():finish()
---local _, _, fz = spring:force()
---```
---@param run? hinge.run
---@return number x, number y, number z, number rx, number ry, number rz
function connector:force(run) end

---The time at which it broke, s, or false.
---```lua
---local hook = model:connector { tip, ground = true, stiffness = { z = 1e5 }, capacity = { z = 100 } }
---model:dynamic { dt = 1e-4, duration = 0.02 }:finish()
---print(hook:broken()) -- s, or false
---```
---@param run? hinge.run
---@return number|false
function connector:broken(run) end

---Rayleigh damping in dynamics, C = alpha M + beta K of each element (Rayleigh 1877, section 81): by its coefficients,
---or by ratios of critical damping at two periods, between which there is less and outside of which more. alpha damps
---the velocity in space, flying and rotating as a whole too; beta the rates of the element's own deformation, so no
---rigid motion, and keeps the elastic stiffness where an element yields. A point mass (model:mass), its rotary inertia
---and its offset with it, has the alpha of the members at its node; where they differ, as by groups, their mean. A
---broken element is damped no more, nor is the mass left of it, and it no longer counts in that mean: a point mass
---whose members have all broken off flies undamped. Of several calls the last one that applies to a member's groups
---counts, so that alpha = 0 with a group leaves it undamped. The energy that it dissipates is in run.energy.damping.
---With explicit steps beta shortens the longest stable step (dt = "auto" includes this); Newmark's method takes
---predictor "displacement" where damping is as strong as that. It does not act in statics.
---```lua
---local alpha, beta = model:damping { ratio = 0.02, periods = { 0.2, 0.02 } } -- 2 % of critical at both
---```
---@param options hinge.damping_options
---@return number alpha 1/s
---@return number beta s
function model:damping(options) end

---@class hinge.damping_options
---0 or above and below 1, of critical damping: at both periods, or one each. Those that ask for a negative coefficient
---are refused
---@field ratio? number|number[]
---@field periods? number[] with ratio: two, s, such as those of the first mode and of the highest that counts
---@field alpha? number 1/s, in the place of ratio and periods: of M, 0 or above, default 0
---@field beta? number s, likewise: of K, 0 or above, default 0
---@field group? hinge.group_like only its members, default all

---A rigid ground that members fall on: the half space behind a plane, stiff, without pull. What touches are nodes,
---those inside members too, and the free ends of broken members, round with half the smaller side of the section as
---radius: k o^2 / 2 for an overlap o. Each call adds a plane. Nodes that are held do not touch; what touches where the
---run begins is at rest there; nodes that begin with their axis below the plane are left out until they have left the
---ground. It acts in statics too, which needs supports. run.energy then has ground, the sum of ground_stored (above
---that at the start) and ground_dissipated (by friction and restitution), J.
---```lua
---model:ground { point = { 0, 0, -0.05 }, friction = 0.5, restitution = 0.2 }
---```
---@param plane? hinge.ground_plane
function model:ground(plane) end

---@class hinge.ground_plane
---@field point? vec3 m, on the plane; default {0, 0, 0}
---@field normal? vec3 out of the ground, of any length but 0; default {0, 0, 1}
---Coulomb's coefficient, 0 or above, default 0; acts where the surface touches. What sticks hangs on a spring along the
---plane, 0.4 k: where the pressure falls below what the spring needs it slips by the difference, so that under shaking
---it creeps a little
---@field friction? number
---k of each point, N/m, above 0; default 0.4 EA / L of each element that meets there, with which explicit steps stay
---stable: a fall at v penetrates by about v / (0.9 c) L, c the speed of sound. One that is given is part of the limit
---of explicit steps and of dt = "auto", as those of connectors are, but for free ends of members that break in the run
---@field stiffness? number
---0..1, the part of the normal velocity that a point has left when it comes out of the ground, by Newton's law as an
---impulse of no length; default what the springs alone give, which lose nothing, but vibration takes its part
---@field restitution? number
---@field group? hinge.group_like whose members meet it; default all

---A group that members were put into by name.
---```lua
---local arm = model:group "arm"
---print(#arm, arm.length, arm.mass)
---```
---@param name string
---@return hinge.group
function model:group(name) end

---A member with elements = "auto" counts as two elements until the first run decides.
---```lua
---local counts = model:counts()
---print(counts.members, counts.elements, counts.free_dofs)
---```
---@return { members: integer, elements: integer, nodes: integer, free_dofs: integer }
function model:counts() end

---A static run: loads and gravity are brought to equilibrium in steps. In large displacement it tells where it comes
---past a limit point or a branching point: run.instability. That is the buckling of the elements that there are: two
---asi-gauss elements see a pinned member buckle at 1.000 times Euler's load; with p_delta = "chord" at 2.27 times, four
---at 1.10, eight at 1.024, sixteen at 1.005. A member of two elements that is pressed beyond Euler's load between
---clamped ends cannot bend out; it counts as unstable. Under load control an elastic step that took many iterations is
---taken back as a trial. One that does not lead back has leapt over a snap, and the run ends before it; take several
---steps all the same, for no trial finds every leap. In large displacement a plateau of plastic hinges, after which the
---structure carries more again, is stopped at or passed over as the steps fall: run.warnings says where one may have
---been passed. displacement = "small" gives a plastic limit load whatever the steps. Beams turn over sideways, too.
---They resist it by bending and torsion (G J) alone: not by warping, and nothing but what the model has, such as a
---floor, holds them.
---```lua
---local rest = model:static():finish()
---local pushed = model:static { control = { node = tip, "uz", to = -0.1 }, steps = 20 }:finish() -- down by 0.1 m
---print(pushed.verdict, pushed.factor) -- the load that takes, as a factor of those of the model
---```
---@param options? hinge.static_options
---@return hinge.run
function model:static(options) end

---@class hinge.static_options
---default 10; of arc length at most so many, and run.reason says where they do not come to its load factor. A step that
---finds no equilibrium is halved, down to 1e-5 of the whole way, and is still one step to run:steps(), run.index and
---history.csv; a limit load may cut the last one short. A try in which Newton's method no longer gets anywhere is given
---up before its last iteration
---@field steps? integer
---equal steps of load (default), arc length, or one degree of freedom driven to a value (m, rad): to the displacement
---that run:displacement gives, which goes on from that of `from`; an error where it has it already. Driven, a step that
---leads to an equilibrium that cannot be held there is halved: it would have leapt to another branch. Where no step is
---short enough, the path itself has come past a branching point: the run goes on, and run.reason says so
---@field control? "load"|"arc"|{ node?: hinge.node, [1]: hinge.component|"arc", to: number }
---load control where the structure has become unstable (large displacement). fail (default): the run ends, with the
---last equilibrium that can be held as its state. continue: it goes on; run.instability tells where it has gone on
---from, run.reason whether its state at the end can be held, run.warnings where it may have leapt to another branch.
---Which branch it comes to is a matter of its steps. A step that leaps over a whole snap at once, at many times the
---limit load, may still go unnoticed: take short ones
---@field unstable? "fail"|"continue"
---load control up to the limit load: a run that ends where no further equilibrium is found, or where the structure
---becomes unstable, then has the verdict "completed" and run.limit = true; run.factor is that of the limit load.
---Default false
---@field to_limit? boolean
---@field hold? hinge.group_like a group held in place during this run
---goes on from another run's state; one that is under way must be finished or stopped first. In a model with load
---cases, what acted where that run ended is held, and this one's factor from 0 to 1 brings on the difference to `loads`
---(so a push-over under dead load is two runs). In one without, all loads come on anew from 0
---@field from? hinge.run
---the load cases that act, as { dead = 1.35, live = 1.5 }, or the name of a combination or a case; needed where the
---model has cases. A case that is not named has the factor that it had in `from`, else 0
---@field loads? table<string|hinge.case, number>|string|hinge.case
---@field iterations? integer at most so many a step before it is halved, default 30
---@field tolerance? number force out of balance, of the forces at work; default 1e-9
---@field record? integer|false steps between rows of history.csv, default 1; false: no history.csv of this run

---A dynamic run, without damping but for what model:damping and rho_infinity ask for: by Newmark's beta method (eq 15),
---or explicit, by central differences with lumped masses (half of each element on each of its nodes, the rotary inertia
---the section's polar one). Explicit steps solve no system of equations, so these options are errors with them:
---precision, beta, rho_infinity, iterations, tolerance, predictor, geometric, rebuild_angle and those of the solver.
---
---Or by the energy-momentum method, for what rotates far in long steps (Simo and Tarnow 1992, Simo and Wong 1991,
---Gonzalez 1996): with displacements x, momenta p, mean forces f and F of a step, (p' - p)/dt + f = F, x' - x = dt (v
---+ v')/2. The mean forces of the elements do exactly the work that their strain energy takes in and their hinges
---dissipate, (p + p')/2 of dd_p, and they are in balance where the step has its middle: so energy and both momenta
---stay, to the tolerance of the iterations, however long the steps. Forces of effects, and loads, are the mean of a
---step's two ends; so connectors keep the energy to second order only. With masses off their node it is kept to some
---1e-3. It is of second order and takes some 5 to 10 iterations a step. The rotary inertia of the sections turns with
---the nodes; accelerations and reactions are the means of the last step. A step that does not converge is taken back
---and halved (step_control, here 0.01 by itself). It does not go with contact, fracture, ground, supports that move,
---displacement = "small" and shift = "whole"; these options are errors with it: beta, rho_infinity, predictor,
---precision.
---```lua
---model:velocity(tip, { 0, 0, -3 })
---local swing = model:dynamic { from = run, dt = 1e-4, duration = 0.02 }:finish()
---print(swing.verdict, swing.energy_error)
---```
---@param options hinge.dynamic_options
---@return hinge.run
function model:dynamic(options) end

---@class hinge.dynamic_options
---s. auto, newmark: twelve steps for an axial wave to cross the shortest element, and steps of eight times that
---while nothing yields, breaks or touches and the accelerations hardly change, with step_control = 0.01;
---explicit: 0.9 of what stability allows, 0.7 with contact by surfaces, 0.22 with gaps (a number above what it
---allows is an error that names the element). Stiff connectors, and a ground's own stiffness, shorten both
---@field dt number|"auto"
---@field duration number s; to the nearest whole step where dt is a number
---@field integrator? "newmark"|"energy-momentum"|"explicit" default newmark
---starts from another run's state, such as gravity at rest. A static run must be finished or stopped first, and any
---must have done a step; of one that failed it is the last good state
---@field from? hinge.run
---the load cases that act, as in static_options. Without it, those of `from` go on with the factors that they had come
---to; a case declared since must be named
---@field loads? table<string|hinge.case, number>|string|hinge.case
---default 0.02; 0.1 with explicit steps, and where forces begin or end at once (contact, ground, fracture, connectors
---that break, loads that are functions of the state); 0 with shift = "whole", whose energy balance cannot close. The
---run ends by itself, with verdict
---"failed", when the energy error is a larger part of the largest energy, which is the largest value that any account
---of run.energy has had so far. The error is checked every 100 steps, or 20 times in a short run, and at the end. The
---state is then that of the last check at which the balance closed (models of up to 200 000 elements). 0: never
---@field energy_tolerance? number
---0..1, the part of the largest energy (see energy_tolerance) that the energy error of the run may reach. A step is
---taken back if its error is more than its share of this, if it would rotate a node by more than 0.5 rad, or if it
---cannot be solved. It is tried again half as long, down to dt / 1024, below which the run fails; the script never sees
---a step that was taken back. After steps with small errors the step grows again, up to dt. Costs a quarter of a step.
---Default 0.01 with dt = "auto" of Newmark's method and with the energy-momentum method, else 0: every step is kept.
---Not with shift = "whole", whose energy balance cannot close
---@field step_control? number
---@field rest? boolean bodies in equilibrium that do not move are left alone until something reaches them; default true
---@field threads? integer how many share a step's work, default 1, the same bits for any number
---@field beta? number Newmark's, default 0.25; the paper takes 0.4 with contact
---0..1, what a step leaves of the amplitude of the highest frequencies; below 1 Newmark's method with alpha of
---Wood, Bossak and Zienkiewicz (1980), alpha = (rho - 1)/(rho + 1), which sets beta = 1/(1 + rho)^2 and
---gamma = 1/2 - alpha. Of second order; the energy that it takes out of slow motion is of third order, and is counted
---in run.energy.numerical, which costs a third of a step. Over millions of steps 0.99 keeps rounding from growing in
---vibrations too fast for the step. Default 1: nothing
---@field rho_infinity? number
---1 is the paper's one solve a step; more is Newton's method until the correction is below tolerance of the step's
---first; 0 (default) is one solve, or Newton's method where hinges form, or displacements are large, in steps longer
---than the fastest vibration allows for one
---@field iterations? integer
---@field tolerance? number see iterations; default 1e-10, energy-momentum 1e-8
---where a step is solved from: the acceleration held, or the displacement (eq 15 as printed); auto (default): the
---first while dt is shorter than an axial wave needs for the shortest element
---@field predictor? "auto"|"acceleration"|"displacement"
---@field geometric? boolean initial stress in the effective stiffness, default true
---rad: an element's stiffness is rebuilt when it has rotated by this, default 0.01, energy-momentum 0.002
---@field rebuild_angle? number
---number format of the effective stiffness. single (default): half the memory; it changes the energy in Case I by
---2e-10. Double is used all the same where steps are longer than the fastest waves need
---@field precision? "single"|"double"
---@field solver? "cg"|"direct" conjugate gradients (default) as in the paper, or factors
---@field solver_tolerance? number of the residual, default 1e-8
---@field solver_iterations? integer at most so many, default 500
---steps between rows of history.csv, default a 500th of all; false: no history.csv of this run
---@field record? integer|false
---where the run is kept as it goes: at its beginning, then every so many seconds of wall time (default 60), when Ctrl-C
---or SIGTERM ends the program `hinge run`, and at its end. A name without a folder is in the output folder; each run of
---a script has its own. `hinge run SCRIPT --resume` goes on from there. One that cannot be written later is no error:
---the one before stays, and a line says so. keep: a table of the script's own whose values (booleans, numbers, strings,
---tables of them) are kept too and are back in it when the run goes on
---@field checkpoint? string|{ file: string, every?: number, keep?: table }

-- Runs ---------------------------------------------------------------------------------------------------------------

---@class hinge.run
---@field kind "static"|"dynamic"
---@field time number s
---@field factor number in statics: the load factor reached
---@field index integer steps done
---@field planned_steps integer
---@field verdict "running"|"completed"|"stopped"|"failed"
---why it failed, with the culprit's name; where statics has completed, the limit load or branching point on its way,
---with unstable = "continue" whether the state at the end can be held, and that arc length has not come to its factor.
---Plain Lua tells of a failed run on stderr when the script has ended, where it has read neither verdict nor reason
---@field reason string
---what the run cannot show, or may have passed over, each once: a member of two elements that is compressed beyond
---Euler's load between clamped ends (dynamics; in statics that is an instability), or moments of loads along it that
---are more than 5 % too small for its compression (p_delta = "member"), which four elements show; a step of static load
---that moves the structure more than 30 times as far as such a load did at first. Dynamics looks every 100 steps, or 20
---times in a short run, and at the end. `hinge run` tells them; they are in summary.json
---@field warnings string[]
---@field energy hinge.energy
---@field dt number s, of the next step; nil in statics
---in statics: whether the run has ended at a limit load, see to_limit; nil in dynamics
---@field limit? boolean
---@field instability? hinge.instability in statics: where the structure became unstable; nil where it did not
---@field worst_remainder number J, the largest absolute value of energy.remainder so far
---energy.remainder as a part of the largest energy, which is the largest value that any account of the energy balance
---has had so far (energy_tolerance of model:dynamic is held against the same); at the last row of history.csv
---@field energy_error number
---@field contacts { bound: integer, released: integer } pairs of elements: ties made or contacts begun; released
---@field stages { name: string, seconds: number }[] what the steps took, stage by stage
---@field effects hinge.effect[] all that there are, in the step or not
---@field wall_seconds number
---@field fastest { speed: number, node: string, time: number } the fastest node so far, m/s and s; nil in statics
---@field hash string of the whole state, to the bit
---@field counts hinge.work_counts
---@field probes hinge.probe[] those asked for so far
---@field loads table<string, number> the load cases of the model by name, with their factors in this run
---effects that became active or inactive while the run went on; the first thousand
---@field wakings { time: number, effect: string, awake: boolean, why: string }[]
local run = {}

---@class hinge.effect
---@field name string
---@field active boolean it is in the step
---@field because string why it is or is not
---@field seconds number what it took
---@field asked_at string the script's line that asks for it, "" where none does

---Where a static run came past a limit point or a branching point. Beyond it the tangent stiffness has more negative
---eigenvalues than where the run began: under constant load the structure would not stay there.
---@class hinge.instability
---@field factor number load factor of the last equilibrium before it
---@field beyond number load factor of the first equilibrium after it
---@field count integer ways of moving that are no longer resisted, the most so far
---@field node string with the largest motion in the first of these ways (rotations times the mean length of an element)
---@field component hinge.component that motion: ux uy uz rx ry rz
---what drives it: compression of members that bend, or bending, as of a beam that turns over sideways; nil where
---neither does
---@field by? "compression"|"bending"
---@field member? hinge.member that this drives on most; nil where nothing does
---@field members hinge.member[] it and others of at least half its part, at most three

---The work that a run has done.
---@class hinge.work_counts
---@field element_updates integer elements whose forces were recovered
---@field element_builds integer elements whose stiffness was built
---@field solves integer systems solved
---@field cg_iterations integer
---@field factorisations integer
---@field pair_tests integer pairs of members looked at closely
---@field pair_lists integer lists of near pairs made
---@field rejected_steps integer steps that step control took back; in statics tries that were halved
---@field substeps integer in statics equilibria found, several in a step that was halved; in dynamics steps

---The energy balance, J: eq 20 and what it leaves out.
---@class hinge.energy
---@field initial number kinetic and elastic at the start
---@field kinetic number
---@field gravity number potential, zero at the start
---@field elastic number
---@field plastic number dissipated in hinges
---@field fracture number released by fracture: fracture_elastic + fracture_kinetic
---@field fracture_elastic number strain energy of broken elements
---@field fracture_kinetic number lost as broken elements become rigid offset masses
---@field contact number contact_stored + contact_released
---@field contact_stored number in contacts now
---@field contact_released number released with ties, or heat of friction
---@field damping? number dissipated by Rayleigh damping, where model:damping is declared
---@field connectors number connector_stored + connector_dissipated; these three where the model has connectors
---@field connector_stored number in their springs and curves now
---@field connector_dissipated number by dashpots and laws, and released by breaks
---@field numerical number taken out by a dissipative integrator (rho_infinity)
---@field work number done by loads
---@field remainder number the energy error: initial + work - all other accounts (without their parts)

---Steps one by one: `for step in run:steps() do ... end`. The table is the same one at every step, filled anew.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---for step in swing:steps() do
---  local _, _, uz = tip:displacement(swing)
---  if step.index % 20 == 0 then print(step.time, uz) end
---end
---```
---@return fun(): { index: integer, time: number, factor: number }?
function run:steps() end

---One step. The run knows what was declared when it was made: if its model has been changed since, it is an error, as
---it is in run:steps and run:finish.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---while swing:step() do
---  if select(3, swing:displacement(tip)) < -1e-3 then swing:stop() end
---end
---```
---@return boolean done false when there is none left
function run:step() end

---Steps to the end.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }:finish()
---print(swing.verdict, swing.time)
---```
---@return hinge.run
function run:finish() end

---Writes all that the run needs to go on with the same bits into a file: its state, probes, history.csv and list of
---frames. It is written under another name and then renamed: the file is either the old one or the new one. Changes
---nothing in the run. Call it between steps or in run:on_step; dynamic runs only. The script's own variables are not
---in it, nor are those that its functions refer to. The table named by `keep` is in it, and so is what a fracture
---rule keeps of each section.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---for step in swing:steps() do
---  if step.index % 50 == 0 then swing:checkpoint "swing.checkpoint" end
---end
---```
---@param file string a name without a folder is in the output folder
---@return hinge.run
function run:checkpoint(file) end

---Before the first step: goes on from a checkpoint of the same run, made by the same model, settings and probes; any
---number of threads. One that is damaged, of another run (the message says in what) or of another hinge is refused, and
---nothing has changed.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---swing:step()
---swing:checkpoint "swing.checkpoint"
---local again = model:dynamic { dt = 1e-4, duration = 0.01 }:resume "swing.checkpoint"
---print(again.index) -- 1
---```
---@param file string
---@return hinge.run
function run:resume(file) end

---Ends the run here; its verdict is then "stopped". One that is over stays as it is.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---for step in swing:steps() do
---  if step.time > 5e-3 then swing:stop() end
---end
---```
function run:stop() end

---Has a function called with the run after each step, whoever asks for the steps. It may read and
---stop the run, but not step it.
---```lua
---local lowest = 0
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---swing:on_step(function(now) lowest = math.min(lowest, select(3, now:displacement(tip))) end)
---swing:finish()
---```
---@param callback fun(run: hinge.run)
---@return hinge.run
function run:on_step(callback) end

---Records one quantity of a node at every step, and in history.csv. Ask before the first step. The first value is that
---where the run begins. A reaction there: what holds the supports under the loads of that moment, with their part of
---the mass of what accelerates at once; where statics begins, under a load factor of 0.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---local sag = swing:probe { node = tip, "uz", name = "sag" }
---swing:finish()
---print(sag.min, sag.last, #sag.value)
---```
---@param options { node: hinge.node, [1]: string, name?: string } ux uy uz rx ry rz (displacement), vx .. vrz
---  (velocity), ax .. arz (acceleration), fx fy fz mx my mz (reaction)
---@return hinge.probe
function run:probe(options) end

---@class hinge.probe
---@field time number[] s; in statics the load factor
---@field value number[]
---@field last number
---@field max number
---@field min number
---@field name string its column in history.csv

---```lua
---local _, _, uz = run:displacement(tip)
---```
---@param node hinge.node
---@return number ux, number uy, number uz, number rx, number ry, number rz m and rotation vector, rad
function run:displacement(node) end

---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }:finish()
---local _, _, vz = swing:velocity(tip)
---```
---@param node hinge.node
---@return number vx, number vy, number vz, number wx, number wy, number wz m/s and rad/s
function run:velocity(node) end

---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }:finish()
---local _, _, az = swing:acceleration(tip)
---```
---@param node hinge.node
---@return number ax, number ay, number az, number bx, number by, number bz m/s^2 and rad/s^2
function run:acceleration(node) end

---```lua
---local _, _, fz = run:reaction(wall)
---```
---@param node hinge.node
---@return number fx, number fy, number fz, number mx, number my, number mz
---  what the support exerts on the node, N and N m
function run:reaction(node) end

---```lua
---local x, y, z = run:position(tip)
---```
---@param node hinge.node
---@return number x, number y, number z where it is now, m
function run:position(node) end

---N and N m in the section's axes; f_y of eq 14
---@alias hinge.resultants { N: number, Mx: number, My: number, Mz: number, Qx: number, Qy: number, f_y: number }

---As member:forces.
---```lua
---local at_a, at_b = run:forces(beam)
---print(at_a.Mx, at_b.Mx)
---```
---@param member hinge.member
---@return hinge.resultants at_a, hinge.resultants at_b at its two ends
function run:forces(member) end

---As member:state.
---```lua
---local state, f_y = run:state(beam)
---```
---@param member hinge.member
---@return "elastic"|"yielded"|"broken" state, number f_y, number? time, integer? element
function run:state(member) end

---@alias hinge.end_a "N_a"|"Mx_a"|"My_a"|"Mz_a"|"Qx_a"|"Qy_a"|"f_y_a"
---@alias hinge.end_b "N_b"|"Mx_b"|"My_b"|"Mz_b"|"Qx_b"|"Qy_b"|"f_y_b"
---@alias hinge.member_value "f_y"|"N"|"broken"|"yielded"|"touched"|"plastic_work"|"member"|"x"|"y"|"z"
---@alias hinge.member_quantity hinge.member_value|hinge.end_a|hinge.end_b

---@alias hinge.rate "vx"|"vy"|"vz"|"vrx"|"vry"|"vrz"|"ax"|"ay"|"az"|"arx"|"ary"|"arz" velocity, acceleration
---@alias hinge.reaction "reaction_fx"|"reaction_fy"|"reaction_fz"|"reaction_mx"|"reaction_my"|"reaction_mz"
---@alias hinge.node_quantity hinge.component|hinge.rate|hinge.reaction|"node"|"node_x"|"node_y"|"node_z"

---Bulk reading: one number a member or a joint of the group, in the order they were declared; "member" and "node" say
---which. Of members, f_y: the largest in the member now; N: its mean axial force, N, 0 once broken; broken, yielded,
---touched: 1 or 0; plastic_work J; member: its index; x, y, z: its middle now, m; with _a and _b: the resultants at its
---ends, as member:forces. Of nodes: what run:probe takes, reactions as reaction_fx to reaction_mz; node: its index;
---node_x, node_y, node_z: where it is now, m.
---```lua
---local f_y, place = run:read("f_y", "arm"), run:read("x", "arm")
---for i, value in ipairs(f_y) do print(place[i], value) end
---local reactions = run:read "reaction_fz" -- of every joint
---```
---@param quantity hinge.member_quantity|hinge.node_quantity
---@param group? hinge.group_like default: all; of nodes, the joints of the group's members
---@return number[]
function run:read(quantity, group) end

---```lua
---local momentum = run:momentum()
---print(momentum.mass, momentum.linear[1], momentum.angular[3])
---```
---@return { mass: number, linear: vec3, angular: vec3 } kg, kg m/s, kg m^2/s about the origin
function run:momentum() end

---Members of a group in a state. A member is broken if one of its elements is, else yielded if one has ever been fully
---plastic (eq 14), else elastic; touched, whatever else it is, if it has ever been in contact.
---```lua
---print(run:count { group = "arm", state = "yielded" }, run:count { state = "broken" })
---```
---@param options { group?: hinge.group_like, state: "elastic"|"yielded"|"broken"|"touched" } group default: all members
---@return integer
function run:count(options) end

---The structure as it is now, for pictures.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---local first = swing:snapshot()
---swing:finish()
---hinge.strip({ { first }, { swing } }, 2, "before_and_after.png")
---```
---@return hinge.snapshot
function run:snapshot() end

---@class hinge.snapshot

-- Ground motion -------------------------------------------------------------------------------------------------------

---The displacement of the ground, m, as a function of time, s, from a record of its acceleration: linear between the
---record's values, integrated twice exactly; zero before its start, straight on after its end. For model:move.
---```lua
---local quake = hinge.ground { dt = 0.02, acceleration = { 0, 1.2, -0.8, 0.3, 0 }, scale = 0.5 } -- m/s^2
---model:move { node = wall, y = quake }
---```
---@param options { dt: number, acceleration: number[], scale?: number }
---  dt s; acceleration m/s^2, the first at t = 0; scale default 1
---@return fun(time: number): number
function hinge.ground(options) end

-- Scenarios ----------------------------------------------------------------------------------------------------------

---A script's parameters, cases and what it runs: a script returns one to the program. A script may also be plain
---statements; it then gets what was written as key=value in a table, `...`, and its return value is its results. A
---setting that such a script does not read is an error: before it runs, where its text tells (local p = ..., then
---p.speed), else at its end. Under plain Lua nobody runs a scenario that a script returns: that is an error, which says
---how to run it.
---```lua
---return hinge.scenario {
---  parameters = { force = 1000 }, -- N; hinge run SCRIPT force=2000
---  cases = { heavy = { force = 3000 } }, -- hinge run SCRIPT --case heavy
---  run = function(p, job)
---    model:load { node = tip, force = { 0, 0, -p.force } }
---    local pushed = model:static():finish()
---    job:picture(pushed, { title = "pushed" }, "pushed.png")
---    return { tip_mm = 1000 * select(3, tip:displacement(pushed)) }
---  end,
---}
---```
---@param options hinge.scenario_options
---@return hinge.scenario
function hinge.scenario(options) end

---@class hinge.scenario_options
---names and defaults (numbers, strings, booleans, lists of numbers), changed by `key=value`, where a
---number may be a sum such as 440/3.6
---@field parameters? table<string, any>
---@field cases? table<string, table> named sets of changes for --case
---settings that trade accuracy for time, each a list whose first item is the default
---@field accuracy? table<string, any[]>
---named functions for `hinge study --propose NAME`: each gets the cases that have ended and returns the parameters of
---the next, as `propose` of hinge.study
---@field proposals? table<string, fun(cases: hinge.study_case[]): table|nil>
---@field run fun(p: table, job: hinge.job): any returns the results kept in summary.json

---@class hinge.scenario

-- Pictures, plots and frames without a job ----------------------------------------------------------------------------

---What job:frame, job:picture, job:strip, job:plot and job:note do, for scripts of plain statements and for any Lua
---5.4: into the output folder of the program's run, else into the folder where Lua was started.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---for step in swing:steps() do
---  if step.index % 50 == 0 then hinge.frame(swing) end
---end
---```
---@param run hinge.run
function hinge.frame(run) end

---```lua
---hinge.picture(run, { title = "under 1 kN", width = 800, height = 600 }, "cantilever.png")
---```
---@param run hinge.run see job:picture
---@param view? hinge.view
---@param filename string plain name ending in .png
function hinge.picture(run, view, filename) end

---```lua
---hinge.strip({ { run, { title = "all" } }, { run, { groups = { "arm" } } } }, 2, "side_by_side.png")
---```
---@param snapshots { [1]: hinge.run|hinge.snapshot, [2]?: hinge.view }[] see job:strip
---@param columns integer snapshots in a row
---@param filename string plain name ending in .png
function hinge.strip(snapshots, columns, filename) end

---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---local sag = swing:probe { node = tip, "uz" }
---swing:finish()
---hinge.plot({ series = { { x = sag.time, y = sag.value } }, x_label = "s", y_label = "m" }, "sag.png")
---```
---@param plot hinge.plot see job:plot
---@param filename string plain name ending in .png
function hinge.plot(plot, filename) end

---```lua
---hinge.note(("the tip is at z = %.4f m"):format(select(3, tip:position())))
---```
---@param text string printed, and kept in summary.json
function hinge.note(text) end

-- Studies ------------------------------------------------------------------------------------------------------------

---Runs a scenario with many values of its parameters. Each case runs in a process of its own, `jobs` at a time. A
---crash, a hang or too much memory costs one case. `hinge study SCRIPT` does the same from the command line. Cases are
---the product of all values, the first name in alphabetical order varying slowest; draws are the same for each
---combination of the others. Writes results.csv, times.csv, summary.json, pictures, and a folder a case into `out`.
---Linux only.
---```lua
---local pushed = hinge.scenario { parameters = { force = 1000 }, run = function(p)
---  model:load { node = tip, force = { 0, 0, -p.force } }
---  local run = model:static():finish()
---  return { tip_mm = 1000 * select(3, tip:displacement(run)) }
---end }
---local study = hinge.study(pushed, { vary = { force = { 1000, 2000, 3000 } }, pictures = false, restart = true })
---for _, case in ipairs(study.cases) do print(case.parameters.force, case.results.tip_mm) end
---```
---@param scenario hinge.scenario
---@param options? hinge.study_options
---@return hinge.study_result
function hinge.study(scenario, options) end

---@class hinge.study_options
---what varies, by name: a list of values; { from =, to =, by = }; or a distribution as text: "normal(mean,deviation)",
---"lognormal(median,deviation of the logarithm)", "uniform(lowest,highest)", "triangular(lowest,likeliest,highest)",
---"weibull(scale,shape)". A single value holds for all cases
---@field vary? table<string, any>
---@field cases? string[] names of the scenario's cases, each with all values
---@field case? string the one case of the scenario that all cases of the study start from
---@field table? string CSV file with names in its first line, and a combination of values a row
---@field samples? integer how many draws, default 100
---"lhs" (default): a Latin hypercube; "sobol": Sobol's sequence with a random digital shift, up to 21 parameters;
---"plain": independent draws
---@field method? "lhs"|"sobol"|"plain"
---@field seed? integer the same one gives the same draws on every machine; default 1
---proposes what runs next: gets the cases that have ended, in order; returns a table of parameters, a list of such
---tables, or nil at the end. It is asked when all that it proposed before has ended
---@field propose? fun(cases: hinge.study_case[]): table|nil
---@field jobs? integer cases at a time; default: the cores that there are
---@field timeout? number s, the most that a case may take
---@field memory? number bytes, the most that a case may take beyond what the script has when the study begins
---@field out? string folder, default out/study
---@field resume? boolean keep finished cases whose script, modules, data files and engine are the same; default false
---@field restart? boolean run all again, also what the folder holds; default false: an error where it holds cases
---@field progress? boolean a line on stderr, default false
---@field pictures? boolean default true

---@class hinge.study_case
---@field number integer its place in the study, from 1
---@field case? string the scenario's case
---@field parameters table<string, any> those that the study set
---"completed", "stopped" by the script, "failed", "wrong" (an error of the script or of its input), "crashed",
---"timed out", "out of memory"
---@field verdict string
---@field reason? string
---@field results table<string, number|string|boolean> what the scenario returned, names in tables joined by dots
---@field energy_error? number of the last run, as a part of its largest energy
---@field steps? integer of the last run
---@field seconds number from start to end
---@field memory number bytes, the most that its process held
---@field folder string its folder, within the study's

---The chance that a result is true, as a normal distribution of a parameter, or of its logarithm where all its values
---are positive; by maximum likelihood.
---@class hinge.fragility
---@field quantity string
---@field parameter string
---@field median number half of the cases are true there
---@field dispersion number standard deviation of the parameter, or of its logarithm
---@field of_logarithm boolean

---@class hinge.study_result
---@field cases hinge.study_case[] in order
---@field varied string[] names that vary, as in results.csv
---@field folder string
---@field pictures string[] their file names in the folder
---@field fragility? hinge.fragility[] curves of true and false results, as far as the cases tell
---@field correlations? { quantity: string, parameter: string, correlation: number, cases: integer }[]
---@field notes? string[]
---@field interrupted boolean

-- What accuracy costs -------------------------------------------------------------------------------------------------

---Runs a scenario over its accuracy settings, in this process and with models of its own each, and compares each with a
---reference that is finer than all of them and is tested by another one: where the two differ by more than half of
---`within`, or an answer scatters that much under slight changes, it gets no error. Answers are the numbers that the
---scenario returns, lists of numbers, and the probes of its runs (as histories). Nothing is printed or drawn by the
---scenario meanwhile. `hinge cost SCRIPT` prints it. With effects = true the settings are not varied: the scenario runs
---as its parameters have it, and once more without each effect that its models declare (gravity, large displacement,
---plasticity, fracture, contact, friction). `hinge cost SCRIPT --effects` prints that.
---```lua
---local scenario = hinge.scenario {
---  accuracy = { dt = { 2e-4, 4e-4 } },
---  run = function(p)
---    local swing = model:dynamic { dt = p.dt, duration = 0.01 }:finish()
---    return { sag = select(3, swing:displacement(tip)) }
---  end,
---}
---local cost = hinge.cost(scenario, { within = 0.01, repeats = 1 })
---for _, setting in ipairs(cost.settings) do print(setting.label, setting.seconds, setting.error) end
---```
---@param scenario hinge.scenario
---@param options? hinge.cost_options
---@return hinge.cost_result|hinge.effects_result
function hinge.cost(scenario, options) end

---@class hinge.cost_options
---@field within? number the largest error accepted, as a part; default 0.01
---@field quantity? string the answer by which settings are compared; default: the worst of all that can be trusted
---@field case? string
---@field parameters? table<string, any> changes of the scenario's; an accuracy setting among them is held
---s; cheap settings come first, and no setting is begun that does not fit together with its references. The plot
---takes about a second more. Default: no limit
---@field budget? number
---how often each setting is timed, in alternating order; default 3. More than 1: short ones more often, up to 21 times
---or 0.1 s
---@field repeats? integer
---folder for cost.csv, cost.png, summary.json, and finished.lua, from which a second call goes on: measurements by the
---script's content, the settings and hinge's version; default: nothing is written
---@field out? string
---in the place of the scenario's own; where neither is given, those of its parameters that are called dt,
---elements_per_member, formulation and the like
---@field accuracy? table<string, any[]>
---"smaller" or "larger" is finer, of numbers with names of your own; others are varied, but
---the reference has their default
---@field finer? table<string, string>
---the order of convergence that theory has for a number; of dt and elements 2, of tolerances and steps 1
---@field orders? table<string, number>
---by which part of itself every number that is not whole is changed to look for chaos, default 1e-9
---@field perturbation? number
---@field progress? boolean lines on stderr, default false
---leave out effects instead, default false: `accuracy` is then only refined, to say how large the setting's own error
---is, and `out` gets effects.csv in the place of cost.csv and cost.png
---@field effects? boolean

---@class hinge.cost_result
---@field settings hinge.cost_setting[] those with an answer, the cheapest first
---@field front hinge.cost_setting[] the Pareto front: nothing is both cheaper and better
---@field cheapest? hinge.cost_setting that is within `within`
---@field quantities table<string, hinge.cost_quantity> by answer
---@field orders table<string, hinge.cost_order> by number: the order of convergence
---by setting without a finer side (formulation, integrator, ...): what its values take at equal error, the
---largest error first: `within`, that of the cheapest, and the least that all values reach, as far as they
---differ and are more than rounding
---@field equal table<string, { error: number, methods: hinge.cost_method[] }[]>
---the coarser and the finer one; nil: `notes` says why
---@field references? { values: table, label: string, seconds: number, answers: table }[]
---@field failed hinge.cost_setting[] with `failed`, why they have no answer
---by the budget; s that each would take, and its references
---@field left_out { label: string, values: table, estimate: number, rest: number }[]
---@field complete boolean nothing is left out
---@field notes string[]
---@field knobs table[] what is varied: name, values, and of numbers their side
---@field elapsed number s
---@field within number
---@field perturbation number
---@field quantity? string
---@field case? string

---@class hinge.cost_quantity
---"sound"; "chaotic", it scatters; "unsettled", the references differ; "moving", it differs from run to run; "unknown",
---there is no reference
---@field state string
---@field kind string "number" or "history"
---@field value? number of the references
---@field agreement? number of the references
---@field scatter? number parts of the value, or of the largest of a history

---@class hinge.cost_order
---@field observed? number the median over the answers; math.huge: exact
---@field theory? number
---@field why? string
---@field note? string
---@field quantities table<string, number> by answer

---@class hinge.cost_method
---@field value any of the setting
---with the best there is of all other settings; between two settings by the straight line on logarithmic axes
---@field seconds number
---@field ratio number over the shortest of those that reach the error
---@field settings hinge.cost_setting[] the one that has at most this error, or the two between which it lies
---@field more? boolean not even its best setting reaches the error: seconds are that one's

---@class hinge.effects_result
---@field effects hinge.effect_cost[] those in the scene that can be left out
---@field absent string[] those that can be left out and are not in the scene
---@field left_out string[] by the budget
---of those that are the same from run to run: how far each scatters when every number changes slightly, and how far
---it is from that of a setting twice as fine
---@field answers table<string, { scatter?: number, error?: number }>
---@field finer? string that setting; nil: `notes` says why
---@field seconds number with all effects: in the steps of all runs, the median of `times`
---@field times number[]
---@field remainder number the energy error, as of a hinge.cost_setting
---@field notes string[]
---@field complete boolean nothing is left out by the budget
---@field elapsed number s
---@field within number
---@field perturbation number
---@field quantity? string
---@field case? string

---@class hinge.effect_cost
---@field name string
---of the answer that changes most without it, a part of its value or of the largest of a history; of those that change
---by more than they scatter, else of all
---@field change? number
---@field worst? string that answer's name
---@field changes table<string, number> by answer; math.huge where there is none without the effect
---@field same boolean the effect is idle: states and answers are the same bits without it
---@field lost boolean it changes, but by no more than that answer scatters
---part of the time that it takes, the median over the rounds; negative where the scene takes longer without it
---@field saves? number
---@field spread? number of `saves`: half the width of the middle half of the rounds
---@field seconds? number without it, the median of `times`
---@field times? number[]
---@field remainder? number the energy error without it
---@field answers? table<string, number|{ x: number[], y: number[] }> without it
---@field failed? string why the scenario has no answer without it: the error's first line

---@class hinge.cost_setting
---@field values table<string, any>
---@field label string
---of the answer that is worst, a part; not below what the references differ by. nil where no answer can be trusted
---@field error? number
---@field worst? string the answer's name
---@field below? boolean its error is below what the references differ by
---by answer; of histories the root mean square difference over the largest value of the reference
---@field errors table<string, number>
---@field answers table<string, number|{ x: number[], y: number[] }>
---@field seconds number in the steps of all its runs, the median of `times`; of a scenario without runs, in all of it
---@field times number[]
---@field ratio number over the cheapest setting's
---@field outside number s in the rest: models, what the script does itself
---@field stages table<string, number> s by stage of a step, of the shortest time
---@field memory? number bytes, the most that it held
---@field remainder number the largest energy error of its runs over the energy at the start and the work at the end
---@field front boolean
---@field meets boolean
---@field failed? string

return hinge

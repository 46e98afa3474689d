---@meta
-- Models: nodes, members, groups, cases -------------------------------------------------------------------------------

---@class hinge
local hinge = {}

---Makes an empty model.
---```lua
---local frame = hinge.model { elements_per_member = 4 }
---local linear = hinge.model { displacement = "small", plasticity = false }
---```
---@param options? hinge.model_options
---@return hinge.model
function hinge.model(options) end

---@class hinge.model_options
---position of the one integration point of an element (section 2). asi-gauss (default): the elements of a member work
---in pairs. While a pair is elastic, its points are the two Gauss points of the pair. When a hinge forms, the point
---moves opposite the hinge. This needs an even number of elements in each member. asi: in the middle while elastic.
---conventional: always in the middle
---@field formulation? "asi-gauss"|"asi"|"conventional"
---large (default): the geometry follows the motion (updated Lagrangian, the paper's ULF). Rotations and twist may be of
---any number of turns. small: the geometry stays as declared (total Lagrangian, TLF)
---@field displacement? "large"|"small"
---what moves when a hinge forms. plastic (default): only the integration point of the plastic strain moves. The pair of
---elements keeps its exact elastic stiffness, and the energy balance closes. elastic_and_plastic: as the paper prints
---it (eqs 6, 10). The elastic point moves to the hinge too, and the point of the other element of the pair moves to the
---middle. Forces stay continuous, but the elastic energy jumps. The energy error shows this jump
---@field shift? "plastic"|"elastic_and_plastic"
---where the axial force of an element acts in large displacement. member (default): on the element's chord, and on the
---bending of each pair of elements between its ends, by the stability functions of the exact beam-column
---(src/beam/beam_column.h). Elastic columns buckle at Euler's load to 0.1 % with two elements. One that is clamped at
---both ends and cannot sway needs four to bend out; statics counts that load with two, too, dynamics warns of it.
---Moments between the ends are those of the beam-column, under end moments, loads and weight, up to 0.6 of the load at
---which the member buckles between clamped ends; beyond that a run warns. `member:along`, yield and utilisation use
---them. A hinge between the ends is in the middle, and forms when the largest moment of the span reaches the plastic
---one (src/beam/pair_bow.h). chord: on the chord alone, as in the paper. Two elements a member then carry too much in
---compression: a pinned column 2.27 times Euler's load, a clamped one whose head sways 1.22 times; four elements 1.10
---times each. A run warns where that misses more than 10 % of a moment. member needs formulation
---asi-gauss, displacement large and shift plastic; without them the default is chord
---@field p_delta? "chord"|"member"
---interaction of N, Mx and My for sections that do not say theirs (hinge.section.general). exact (default): that of
---the section's shape; sections whose shape is not known have eq 14. exact with shear: the same, and shear forces take
---strength from it. paper: eq 14, which is unsafe beside an axial force
---@field interaction? "paper"|"exact"|"exact with shear"
---how the weight of members acts. members (default): along them. It acts at the nodes of their elements, and a member's
---two end nodes get what that misses of the end moments of a load along it; `member:forces` has the part between the
---nodes, too. End forces and displacements of joints are then those of a load `q` of the same size: exact in elastic
---members with two elements in small displacement. nodes: at the nodes alone, as in the paper. The end moments of a
---clamped member of two elements are then 0.63 of w L^2 / 12, with four 0.91, and the shear forces at its ends 1/2 and
---3/4 of w L / 2. Beside compression the moments in the span are too small, by some 15, 30, 44 % at 0.3, 0.6, 0.9 of
---Euler's load; a run warns of it. With mass cubic the nodes' weights give the end moments by themselves. In dynamics
---weight acts along the members of bodies that are carried: a support holds one of the body's nodes in a direction in
---which gravity acts, or a connector (broken or not) joins it to the ground or to such a body. What falls, and what
---lies on others or on model:ground, has weight at nodes alone: there inertia bends a member as little as weight does.
---So has a member with a broken element, and in dynamics one whose weight is beyond its plastic limit load between
---clamped ends,
---16 M_p / L^2
---@field weight? "members"|"nodes"
---linear (default): the paper's consistent mass of linear shape functions (after eq 15). cubic: the mass of a pair of
---asi-gauss elements, for the cubic shape that belongs to its stiffness. It is not in the paper, and it is equally
---fast. With two elements a member, sway frequencies of slender frames are within 0.2 % with cubic; linear has an error
---of 1 to 4 %. With stocky members cubic is less exact. The vibration of a pinned member between its ends is 5 % off
---with two elements, and 0.2 % with four. cubic works with Newmark's method and statics only, and without fracture
---@field mass? "linear"|"cubic"
---@field plasticity? boolean default true; false: nothing yields, whatever the materials are
---default 2, as in the paper. "auto": 2, and 4, 8 or 16 in members that are compressed, or that yield between their
---ends. The first run decides this once, for all runs of the model. It uses what is declared at that time. It solves
---one linear static system with all loads and gravity in full: every load case has the factor 1. Loads with a history
---have their value at time 0, or the full value if that is 0. Compression counts by its effect on the bending
---stiffness. With p_delta = "member", the default, two elements include this effect exactly; members at Euler's load or
---above get four. Four are also given to a member where moments between its ends reach the fully plastic moment, and to
---a member with its own loads that yields anywhere. The decision does not include impacts, motions of supports,
---`fixed_group` of a static run, and loads that are functions of the run. Bodies that model:fix does not hold keep two.
---The solver is a direct one: it takes 0.5 s for a cubic frame of 3400 members, and 6 s for 11,000. `hinge plan` and
---summary.json list how many members got how many elements, and why. "auto" works with asi-gauss only
---@field elements_per_member? integer|"auto"
---for elements = "auto": the error that is allowed in the bending stiffness of a compressed member, as a part of the
---stiffness without compression. Near Euler's load it is the error of the load at which the member buckles. Default
---0.01
---@field elements_accuracy? number

-- Handles. Two handles to the same thing are the same value, so == compares them and they can be keys of a table.
-- tostring says what a handle stands for, and if that was removed, when. A handle of another model, or of a closed
-- model, is an error everywhere. Lists are arrays in the order of declaration. Each call makes a new one:
-- `for _, member in ipairs(group:members()) do ... end`. A method that reads results takes the run as an argument. By
-- default it is the latest run of the model; if there is none yet, that is an error.

---A joint.
---@class hinge.node
---@field x number as declared, m
---@field y number
---@field z number
---@field index integer from 1, in the order of declaration
---@field fixed string? what is fixed, as in model:fix: "all", or for example "x,y,rx"; nil: nothing
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
---@field length number between its ends as declared, m
---@field mass number kg
---@field group string? name of its first group, which sets its colour; nil: none
---@field section hinge.section
---@field material hinge.material
---@field backbone hinge.backbone? nil: none
---@field law string? nil: none; "a function"
---@field up vec3 direction of the section's y axis, as given
---@field elements integer|"auto" the number of its elements; "auto" until the first run decides
---@field carries "both"|"tension"|"compression" as given
---@field ends table<"a"|"b", hinge.joint>? joints of its ends; nil: none
---@field offset table<"a"|"b", vec3>? what leads from its nodes to its ends, m; nil: they are at the nodes
---@field index integer from 1, in the order of declaration
local member = {}

---```lua
---for _, joint in ipairs(beam:nodes()) do print(joint.index, joint.x) end
---```
---@return hinge.node[] a_and_b
function member:nodes() end

---The node that the member has after so many of its elements, as a node of the script: loads, connectors and panels may
---be there. The member must have a number of elements, and keeps its straight or bowed shape.
---```lua
---local middle = beam:node(1) -- of two elements
---```
---@param after integer the number of elements before it, 1 to elements - 1
---@return hinge.node
function member:node(after) end

---```lua
---for _, group in ipairs(beam:groups()) do print(group.name) end
---```
---@return hinge.group[]
function member:groups() end

---The section resultants at the two ends of the member. All are zero when the element at that end is broken.
---```lua
---local at_a, at_b = beam:forces()
---print(at_a.Mx, at_b.Qy, at_a.f_y) -- N m, N, 1 where fully plastic
---```
---@param run? hinge.run default: the latest of the model
---@return hinge.resultants at_a, hinge.resultants at_b
function member:forces(run) end

---The resultants along the member, with the loads between its nodes: a list of rows from its first end (x = 0) to its
---second. Rows stand at `parts` equal parts of its length, at its elements' ends, where a moment has an extreme value,
---and on both sides of a point load. Signs as in member:forces: dMx/dx = Qy, dMy/dx = -Qx where no moment acts along
---it. Exact in small displacement under point loads and loads that are linear along it, weight included. In large
---displacement with p_delta member the moments are those of the beam-column: the axial force acts on the bow of the
---member, which adds to dMx/dx; shear forces are across the chord of each element. In dynamics
---inertia counts as a load that is uniform along each element. A broken element has no rows.
---```lua
---for _, row in ipairs(beam:along(run, 4)) do print(row.x, row.Mx, row.Qy) end
---```
---@param run? hinge.run default: the latest of the model
---@param parts? integer default 8
---@return hinge.resultants_at[]
function member:along(run, parts) end

---@class hinge.resultants_at
---@field x number m, from the first end along the member as declared
---@field N number N, positive in tension
---@field Mx number N m
---@field My number N m
---@field Mz number N m
---@field Qx number N
---@field Qy number N

---The state of the member. A member is broken if one of its elements is broken.
---```lua
---local state, f_y = beam:state()
---print(state, f_y) -- elastic, and how near the most stressed section is to fully plastic
---```
---@param run? hinge.run default: the latest of the model
---@return "elastic"|"yielded"|"broken" state, number f_y, number? time, integer? element f_y: the largest value now.
---  time and element are of a broken member: when its first element broke (s; nil: before this run began), and which of
---  its elements it was
function member:state(run) end

---What a joint at an end of the member carries: moments that it puts on the node, about the section's axes (N m), its
---rotations (rad), tension and shear force (N), and the time at which it broke (s), false while it is whole. nil: the
---end has no joint.
---```lua
---local stub = model:node { 1, 0, 0.5 }
---model:fix(stub)
---local hanger = model:member { stub, tip, section = square, material = steel, release = { b = "Mx" } }
---model:static():finish()
---print(hanger:joint("b").rotation_x)
---```
---@param end_of_member "a"|"b"
---@param run? hinge.run default: the latest of the model
---@return hinge.joint_now?
function member:joint(end_of_member, run) end

---@class hinge.joint_now
---@field Mx number N m
---@field My number N m
---@field Mz number N m
---@field rotation_x number rad, of the end relative to the node; of a broken joint, where it broke
---@field rotation_y number rad
---@field rotation_z number rad
---@field tension number N
---@field shear number N
---@field broken number|false s

---The members that have the same group name. `#group` is their number.
---@class hinge.group
---@field name string
---@field size integer number of its members, as #group
---@field length number sum over its members, m
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

---Removes the load from the model. Runs that have ended keep it. A run that has not ended may not go on (run:step). Any
---later use of the handle is an error, which says where the load was removed.
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

---As model:load. The load belongs to this case.
---```lua
---local snow = model:case "snow"
---snow:load { member = beam, q = { 0, 0, -2e3 } }
---local under_snow = model:static { loads = { snow = 1 } }:finish()
---```
---@param options hinge.load_options
---@return hinge.load? load
function case:load(options) end

---As model:gravity. Gravity belongs to this case.
---```lua
---local dead = model:case "dead"
---dead:gravity { 0, 0, -9.80665 }
---local design = model:static { loads = { dead = 1.35 } }:finish()
---```
---@param acceleration vec3 m/s^2
function case:gravity(acceleration) end

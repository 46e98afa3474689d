---@meta
-- Loads, masses and imposed motions -----------------------------------------------------------------------------------

---@class hinge.model
local model = {}

---Adds a load on a node. Three numbers give a force of fixed direction. A function is called once a step with two
---arguments: the time at the end of the step (s), and the run as it is at the beginning of the step (dynamics only). It
---returns three numbers, or a table of three. In the first step of a run it is also called with the time at which the
---run begins.
---
---Or a load on a member, or on each member of a group, also on those that come to it later: `q` and `moment` over its
---whole length, or between `from` and `to`, linear between `a` and `b`, where the load begins and ends; or with `at` a
---force and moment at that point. The member's
---end nodes get the fixed-end forces of the whole Timoshenko member, so that end forces in linear statics are exact for
---any number of elements, and joint displacements are those of the stiffness (closed form with asi-gauss). run:forces
---includes the load, and yield and a fracture rule's forces go by the same: plastic limit loads under uniform load are
---exact with two elements in pinned and clamped members. Hinges stand at nodes: a propped member, whose hinge belongs
---0.414 of the length from the prop, carries 12 M_p / L^2 with two or four elements and 11.73 with eight, where 11.66
---is right. A fracture rule's strains and limits are those of the elements' own deformation. With large displacement,
---forces in space keep their direction, those in local axes rotate with each element, and the fixed-end moments are
---those in the member's present axes, by its elastic stiffness. An element that breaks loses its part of the load. Such
---a load gives no handle; it can be left out, but not removed.
---
---A static run leaves out loads with a history, on nodes and on members, since statics has no time. If `loads` of the
---run names the load case of such a load, the run takes its numbers in full, whatever the history. It is an error if
---all loads have a history. A dynamic run that continues another run also continues its time. A history that begins
---with the second run therefore begins at that time. Warnings name points of a history that are past when the run
---begins, that change less than 5 % before the end of the run, or that act for less than two steps.
---```lua
---model:load { node = tip, force = { 0, 0, -1000 } } -- N
---model:load { member = beam, q = { 0, 0, -200 } } -- N/m
---model:load { member = beam, q = { a = { 0, 0, 0 }, b = { 0, 0, -300 } }, from = 0.5, to = 1 } -- a triangle
---model:load { node = tip, force = { 5e3, 0, 0 }, history = { { 0, 1 }, { 0.01, 0 } } } -- a blast of 10 ms
---```
---@param options hinge.load_options
---@return hinge.load? load of a load on a node
function model:load(options) end

---@class hinge.load_options
---@field node? hinge.node
---@field member? hinge.member in place of node
---@field group? hinge.group_like in place of node: each member of the group
---@field q? vec3|table N/m, or { a = vec3, b = vec3 } where the load begins and ends; one left out is zero
---@field force? vec3|fun(time: number, run: hinge.run): number N, in space; on a member at the point `at`
---N m, in space. On a member: N m/m, given as `q`, or N m at the point `at`; numbers only, no function
---@field moment? vec3|fun(time: number, run: hinge.run): number
---@field at? number on a member: the distance from its first end as a part of its length, 0 to 1
---@field from? number where `q` and `moment` begin, as a part of the member's length, 0 to 1; default 0
---@field to? number where they end, more than `from`, up to 1; default 1
---axes of a load on a member. "global" (default): in space, per length of the member. "projected": in space, per length
---of the member's projection on the plane normal to the load at the start, as for snow (`q` only). "local": in the
---member's x, y, z axes
---@field axes? "global"|"projected"|"local"
---factor of the numbers over time (s): a function, or points { { time, factor }, ... }. Default 1. Two points at the
---same time are a jump: the first value holds up to that time, the second from then on. If a step ends at a jump, that
---step ends with the value before the jump, and the next step begins with the value after it. If the points have a
---jump, or a slope shorter than 20 steps, then each step with a jump or a kink in it uses the mean of the factor over
---the step, so no impulse is lost. Times are those of the run, which go on if `from` is a dynamic run. Of a function,
---only the values at the ends of steps are known
---@field history? fun(time: number): number|number[][]
---@field case? hinge.case|string the load case of the load, see model:case; default: none, it acts in every run

---Declares a load case. A load belongs to it if it is declared with this case as `case`, or by case:load or
---case:gravity. The option `loads` of a run says which cases act, and with which factors. Loads and gravity that belong
---to no case act in every run. A second call with the same name returns the same case.
---```lua
---local live = model:case "live"
---model:load { node = tip, force = { 0, 0, -500 }, case = live }
---local half = model:static { loads = { live = 0.5 } }:finish()
---```
---@param name string
---@return hinge.case
function model:case(name) end

---Declares a combination: a sum of load cases with factors, which `loads` of a run can name. The factors may also name
---combinations that were declared before.
---```lua
---model:case("dead"):gravity { 0, 0, -9.80665 }
---model:case("live"):load { node = tip, force = { 0, 0, -500 } }
---model:combination("uls", { dead = 1.35, live = 1.5 })
---local design = model:static { loads = "uls" }:finish()
---```
---@param name string a name that no case and no other combination has
---@param factors table<string, number>
function model:combination(name, factors) end

---Attaches a mass to a node, or along members.
---
---At a node it is a point mass. The mass has inertia, it has weight if the model has gravity, and it rotates with
---the node. Several masses on one node add up. In a step the mass is a rigid offset mass, like what is left of broken
---members (paper, fig 5). Its momentum, energy and weight are counted together with those of members. If fracture takes
---the last member of a node, the node flies on with its mass; if the mass has no rotary inertia, it stops rotating. A
---mass that is declared after a run is part of the runs that continue from that run. It is an error if the node has no
---member when a run begins. `hinge check` includes the mass in masses and natural periods. Members between point masses
---may have density 0. In Newmark's method the nodes without mass, and rotations of masses without `inertia`, are in
---balance at the end of each step, as in the statically condensed structure: forces that set in at once move them at
---once, and what that loses of the work is in run.energy.numerical. Such members go neither with the other integrators
---nor with contact and ground, and they cannot break; model:remove takes them out.
---
---Along a member, or all members of a group, it is a mass per length, such as cladding or a floor. Members that join
---the group later have it, too. Masses on one member add up. Its inertia is that of an even mass with the same sum over
---the whole member, without rotary inertia. Its weight acts where the mass is, as a load that is linear along its part
---of the member. What is not even acts as long as the member is whole and carried; what falls has an even weight.
---```lua
---model:mass { node = tip, mass = 20, inertia = 0.1 } -- kg, kg m^2
---model:mass { member = beam, per_length = 300 } -- kg/m
---model:mass { member = beam, per_length = { b = 150 }, from = 0.5 } -- rises from 0 in the middle to 150 kg/m at end b
---```
---@param options hinge.mass_options|hinge.line_mass_options
function model:mass(options) end

---Puts the loads and the masses of floors on the members around them, by tributary areas. The members must close
---panels: they lie in a plane along all edges of each panel and are joined at its corners. Members inside of `corners`
---divide the floor into panels. The floor lies on the members that are there by now. A panel may have any number of
---straight sides, each of several members, and no corner that points inward. A load acts as trapezoids along the
---members, a mass as by model:mass, and both have the exact sum over the floor. The floor has no stiffness, unless
---`slab` says what it is made of; model:diaphragm makes it rigid in its plane. Pictures show floors (option `floors`).
---A wrong floor is an error and changes nothing.
---```lua
---local house = hinge.model()
---local lines = hinge.grid { model = house, x = { 0, 6, 12 }, y = { 0, 5 }, z = { 0, 3, 6 } }
---lines:defaults { section = square, material = steel }
---lines:beams { along = "x", group = "beams" }
---lines:beams { along = "y", group = "beams" }
---house:case "live"
---local floor = house:floor { group = "beams", mass = 450, load = { live = 3e3 } } -- all storeys; kg/m^2, Pa
---print(floor) -- 4 panels, 120 m^2, 360 kN, 54000 kg on 14 members
---house:floor { corners = { { 0, 0, 3 }, { 12, 0, 3 }, { 12, 5, 3 }, { 0, 5, 3 } }, load = 500, case = "live",
---  span = { 1, 0, 0 }, openings = { { { 1, 1, 3 }, { 3, 1, 3 }, { 3, 2, 3 }, { 1, 2, 3 } } } }
---```
---@param options hinge.floor_options
---@return hinge.floor
function model:floor(options) end

---@class hinge.floor_options
---m, points or nodes of one plane, in their order around the floor. Without it, all panels that the given members close
---in horizontal planes are floors
---@field corners? (vec3|hinge.node)[]
---the members that may carry it; give them to leave out members that lie in the floor and do not, such as bracing. With
---`corners` the default is all members of the model
---@field members? hinge.member[]
---@field group? hinge.group|string in the place of `members`
---Pa, on the area of the floor in its plane, along `direction`; or a table with one for each load case. It has no mass
---@field load? number|table<string, number>
---kg/m^2, 0 or above. It has its weight from model:gravity
---@field mass? number
---"two way": each point of a panel belongs to the nearest side. "one way": half of each strip across the shorter sides
---of a panel with four sides goes to either end of it. A direction { x, y, z } in the plane: one way along it. Default
---"two way"
---@field span? "two way"|"one way"|vec3
---polygons of points or nodes in the floor, with `corners` alone. They carry nothing, and must not overlap. What is
---around them goes to the members to which it would go without them. They do not go with `slab`
---@field openings? (vec3|hinge.node)[][]
---what the floor is made of, as in model:panel, without nodes: then plates with stiffness and strength lie between the
---members, bonded to the nodes of their elements, and carry `load` and `mass` at their nodes. Each part must have four
---sides, with as many elements on a side as on the one across. The sheet's x axis is `span` where that is a direction,
---else the global x axis. `mass` is that of the whole floor; default: of the slab
---@field slab? hinge.floor_slab
---@field direction? vec3 of `load`, of any length; default { 0, 0, -1 }
---@field case? hinge.case|string of a `load` that is a number; without it the load acts in every run
---@field history? fun(time: number): number|number[][] of `load`, as in model:load

---@class hinge.floor_slab : hinge.panel_options
---without them the slab is bonded to the nodes of the beams' elements, at the beams' axes
---@field studs? hinge.studs

---Studs along all beams around the parts of a floor. The slab has nodes of its own, and at each node of the beams'
---elements a connector stands for the studs on its part of the length. Beam and slab then carry as a composite section
---with partial interaction; how wide a strip of the slab takes part follows from the slab.
---@class hinge.studs
---@field spacing number m, above 0, along the beams
---@field stiffness number N/m of one stud, above 0, in the plane of the slab; the same holds it to the beam across it
---N of one stud, in any direction of the plane: it flows at this force. Default: elastic
---@field capacity? number
---m, with `capacity`: the plastic slip at which the studs break. Default: never
---@field slip? number
---@field height? number m, of the slab's middle above the beams' axes, upward; default 0

---@class hinge.floor
---@field area number m^2, without openings
---@field load number N, of all cases together
---@field mass number kg
---@field panels hinge.floor_panel[]
---@field slab hinge.panel[]? its plates; nil: none
---@field parts hinge.floor_part[] of each member that carries something
---@field idle hinge.member[] level members among those given by `members` or `group` that carry nothing
local floor = {}

---A table of what each member carries.
---```lua
---local frame, ring = hinge.model(), {}
---for i, p in ipairs { { 0, 0 }, { 6, 0 }, { 6, 4 }, { 0, 4 } } do ring[i] = frame:node { p[1], p[2], 3 } end
---frame:line { ring[1], ring[2], ring[3], ring[4], ring[1], section = square, material = steel, group = "beams" }
---print(frame:floor({ group = "beams", load = 3e3 }):text())
---```
---@return string
function floor:text() end

---@class hinge.floor_panel
---@field nodes hinge.node[] at its corners
---@field area number m^2, without openings

---@class hinge.floor_part
---@field member hinge.member
---@field area number m^2
---@field load number N, of all cases together
---@field mass number kg

---Makes node `to` move with node `from` as a rigid body, however far both rotate. The link has no mass. It does no
---work: what acts on `to` acts on `from`, with its moment about `from`. Several links may begin at one node, and a node
---follows one other node. The link keeps the nodes as they are where a run begins. In dynamics `to` begins with the
---velocity that follows from `from`. Supports may hold `to` where they hold all of `from` that moves it, as in a plane
---frame that is held out of its plane. It is an error, when a run is made, if `to` is held and `from` could move it
---there, and if a node has no member. Rigid ends of a member are simpler with its `offset`. If fracture takes the last
---member of a node, the link keeps the others together. These do not go with it yet, and are errors: integrator =
---"energy-momentum", a support that moves at one of the nodes, and several links, one with dofs = "xyz", from a node
---whose members can break.
---```lua
---local face = model:node { 0.2, 0, 3 } -- of a column, 0.2 m from its axis
---local axis = model:node { 0, 0, 3 }
---model:rigid_link { from = axis, to = face } -- both nodes have members, too
---```
---@param options hinge.rigid_link_options
function model:rigid_link(options) end

---@class hinge.rigid_link_options
---@field from hinge.node the node that the other one follows; it may be supported
---@field to hinge.node
---"all": displacements and rotations of `to` follow. "xyz": its displacements alone, as if the link ended in a ball
---joint. Default "all"
---@field dofs? "all"|"xyz"

---Makes nodes of a floor move as one rigid body in their plane: their displacements in the plane, and the rotation
---about its normal. Out of the plane they are free. The diaphragm has no mass and does no work. A node belongs to one
---diaphragm, and the rest is as with model:rigid_link. Where floors tilt, the plane stays the one across x, y or z.
---```lua
---local corners = { model:node { 0, 0, 3 }, model:node { 4, 0, 3 }, model:node { 4, 4, 3 }, model:node { 0, 4, 3 } }
---model:diaphragm { nodes = corners } -- a floor, rigid in x and y; the corners are heads of columns
---```
---@param options hinge.diaphragm_options
function model:diaphragm(options) end

---@class hinge.diaphragm_options
---@field nodes hinge.node[] at least two
---across which axis of space the plane lies. Default "z"
---@field normal? "x"|"y"|"z"
---the node that the others follow. Another node may be supported in the plane only where this one is, too. Default the
---first of `nodes`
---@field master? hinge.node

---@class hinge.line_mass_options
---@field member? hinge.member
---@field group? hinge.group|string in the place of `member`
---kg/m, 0 or above; or { a =, b = } where it begins and where it ends, linear between, of which one may be left out
---@field per_length number|{ a: number?, b: number? }
---@field from? number where it begins, as a part of the member's length from its first end; default 0
---@field to? number where it ends; default 1

---@class hinge.mass_options
---@field node hinge.node it may be fixed: then the support carries it
---@field mass number kg, above 0
---kg m^2, 0 or above, about axes through the mass. A number is for every axis. { Jx, Jy, Jz } is for the x, y and z
---axes of space, in the undeformed position. Default 0
---@field inertia? number|vec3
---@field offset? vec3 m, from the node to the mass, in the undeformed position; default { 0, 0, 0 }

---Moves supports. The call fixes the given degrees of freedom. In a dynamic run they follow a path, as a displacement
---or a rotation from the position at the start of the run. Rotations are about the axes of space: their rates are those
---of the node about these axes, so that a rotation about one axis may be of any size. Velocity and acceleration follow
---from differences over the last steps. Before the run, the support is taken to move as in the state from which the run
---begins; without such a state it stands still. A path may start and stop suddenly, which is an impact. The work of the
---supports is in the energy balance. In statics the supports stand still; model:settle moves them there.
---```lua
---model:move { node = wall, z = { { 0, 0 }, { 0.1, 0.01 }, { 0.2, 0 } } } -- up by 10 mm and down again
---local shaken = model:dynamic { dt = 1e-3, duration = 0.2 }:finish()
---```
---@param options hinge.move_options
function model:move(options) end

---Makes the structure crooked, without stress: it changes the declared places of nodes, and calls add up. Declare
---nodes, members, joints and supports first: it does not see later ones. No run goes on from one that was made before
---it. Give one of three. sway: the frame is out of plumb, each node by sway times its height above `base`, along
---`direction`. bow: columns are bowed by half a sine wave, `bow` times their length in the middle, along the section's
---axis x or y. Members in line are one column up to a node that is held across the bow: by another member, a support,
---a link; or to a joint that is free about the axis of bending. By default columns in line bow to opposite sides (sign
---= "mode"), as they do where they buckle between such nodes: storeys that bow to the same side hold each other, and
---carry up to half as much again. Columns need eight elements or more; the growth of the moment under compression is
---then 5 % too small, with sixteen 1.3 %: (pi / n)^2 / 3 with n elements, since the two elements of a pair are in
---line. mode: the shape of a mode of run:modes or run:buckling of this model, its largest displacement `largest`;
---members that bend in it need eight elements. sway and bow take numbers, or those of EN 1993-1-1:2005 5.3.2: phi of
---(5.5) for the height from `base` to the highest node and for `columns` in a row; e0 / L of table 5.1 for a buckling
---curve.
---```lua
---local tower = hinge.model {}
---local foot, head = tower:node { 0, 0, 0 }, tower:node { 0, 0, 6 }
---tower:member { foot, head, section = square, material = steel, elements = 8 }
---tower:imperfection { sway = { standard = "EN 1993-1-1", columns = 3 }, direction = { 1, 0, 0 } }
---tower:imperfection { bow = { curve = "a", analysis = "plastic" }, axis = "x" }
---print(head.x) -- 6 m * 1/200 * 2/sqrt(6) * sqrt(0.5 (1 + 1/3)) = 0.0200 m
---```
---@param options hinge.imperfection_options
function model:imperfection(options) end

---@class hinge.imperfection_options
---horizontal over vertical, between -0.2 and 0.2; columns: default 1
---@field sway? number|{ standard?: "EN 1993-1-1", columns?: integer }
---@field direction? vec3 of the sway, horizontal; default { 1, 0, 0 }
---@field base? number m, the height z that stays; default that of the lowest node
---part of the member's length, between -0.1 and 0.1; curve: "a0", "a", "b", "c", "d"; analysis: default "plastic"
---@field bow? number|{ curve: string, analysis?: "plastic"|"elastic" }
---@field axis? "x"|"y" of the bow; default "x"
---"mode" (default): columns in line bow to opposite sides, the lowest one of a line along the axis of its lowest
---member; "same": all bow along the axis of their sections. How columns beside each other bow is not in it: each line
---begins along its axis; for another pattern give the shape of a buckling mode
---@field sign? "mode"|"same"
---@field member? hinge.member of the bow; default: all members, or those of `group`
---@field group? hinge.group_like
---@field mode? hinge.mode
---@field largest? number m, of a mode: its largest displacement; below 0: the other way

---Displaces supports in statics: a settlement, an error of fit, or an end that is rotated. The call fixes the given
---degrees of freedom. A static run moves them in proportion to its load factor, from where it finds them to the given
---displacement at factor 1, whatever `control` it has. A run that goes on from one that has settled moves nothing. The
---work of the supports is in the account `work`. In dynamics the supports stay where they are. It is an error if the
---node belongs to a rigid link, a diaphragm or a joint, and if one of its degrees of freedom has a displacement
---already.
---```lua
---model:settle { node = wall, z = -0.02 } -- m, down
---local settled = model:static { steps = 4 }:finish()
---```
---@param options hinge.settle_options
function model:settle(options) end

---@class hinge.settle_options
---@field node hinge.node|hinge.node[]
---@field x? number m, along x, from the declared position; y and z likewise
---@field y? number
---@field z? number
---rad, component of the rotation vector along x, from the declared position; ry and rz likewise
---@field rx? number
---@field ry? number
---@field rz? number

---@class hinge.move_options
---@field node hinge.node|hinge.node[]
---displacement along x, m, over time, s: a function, or points { { time, displacement }, ... }
---@field x? fun(time: number): number|number[][]
---@field y? fun(time: number): number|number[][] the same along y
---@field z? fun(time: number): number|number[][] the same along z
---@field rx? fun(time: number): number|number[][] rotation about x, rad, over time
---@field ry? fun(time: number): number|number[][] the same about y
---@field rz? fun(time: number): number|number[][] the same about z

---Gravity on every member's mass and on point masses. The weight of members acts along them, as `weight` of hinge.model
---says, and a clamped member of two elements has end moments of w L^2 / 12 and w L^2 / 24 in the middle. Yield goes by
---these, as with loads `q` (model:load). Called again, the last call counts, for runs made after it; it is an error to
---call it for another load case. A dynamic run that goes on from a run without this gravity warns: the weight acts at
---once there.
---```lua
---model:gravity { 0, 0, -9.80665 }
---local rest = model:static():finish()
---```
---@param acceleration vec3 m/s^2, such as { 0, 0, -9.80665 }
---@param load_case? hinge.case|string the load case that it belongs to; default: none
function model:gravity(acceleration, load_case) end

---Gives an initial velocity to a node alone, or to a member or a group as a rigid body. A member between two joints
---that were given a velocity, by one call or by several, moves with them over its whole length, in proportion between
---the two. The inner nodes of a member with a velocity at one end alone begin at rest. The kinetic energy of a node
---alone is that of its point masses and of the part of the elements that is at the node (density * area * length of an
---element / 3, for each one): it becomes smaller with shorter elements. So give a node that is struck the mass that
---strikes it (model:mass), or give the velocity to a member. `hinge plan` and `hinge check` print the kinetic energy
---that a run begins with, and warn of such a node. If several calls give a velocity to a node, the last one counts.
---Statics does not change velocities. A run that continues another run (`from`) begins with the velocities at the end
---of that run. The exceptions are targets whose velocity was declared after that run was made: they begin with it, as
---a rigid body in their present position. So a velocity may be given before or after statics. Fixed degrees of freedom
---stay at rest. It is an error if the target has no others.
---Members that come to a group later bring it their joints, which get its velocity too, unless a later call gave them
---another one. With `angular` they would move the point about which the group turns: then that member is an error.
---```lua
---model:velocity(tip, { 0, 0, -3 }) -- m/s
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }:finish()
---```
---@param target hinge.node|hinge.member|hinge.group_like of a group: its joints
---@param linear vec3 m/s, at the mean position of the target's joints
---@param angular? vec3 rad/s, about that point
function model:velocity(target, linear, angular) end

---@meta
-- Probes, states, modes and hinges of runs ----------------------------------------------------------------------------

---@class hinge.run
local run = {}

---Records one quantity of a node at every step, and in history.csv. Call it before the first step. The first value is
---that at the start of the run. A reaction at the start is the force that holds the supports under the loads at that
---time, together with the inertia of masses that accelerate at once. In statics it is the reaction at a load factor of
---0.
---
---With relative_to the probe is the difference to another node: a displacement against a floor, or the velocity of two
---bodies against each other. The difference is taken along the global axes; rx ry rz are the rotation vector of the one
---node against the other. drift_x and drift_y are the difference of ux or uy over the height between the two nodes at
---the start, along z, or over `height`.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---local sag = swing:probe { node = tip, "uz", name = "sag" }
---swing:finish()
---print(sag.min, sag.last, #sag.value)
---
---local push = model:static { steps = 4 }
---local bending = push:probe { node = tip, relative_to = wall, "uz" }
---local drift = push:probe { node = tip, relative_to = wall, "drift_x", height = 3 }
---push:finish()
---print(bending.last, drift.max)
---```
---@param options hinge.probe_options
---@return hinge.probe
function run:probe(options) end

---@class hinge.probe_options
---@field node hinge.node
---ux uy uz rx ry rz (displacement), vx .. vrz (velocity), ax .. arz (acceleration), fx fy fz mx my mz (reaction),
---drift_x drift_y
---@field [1] string
---@field relative_to? hinge.node the node whose value is taken off; not for reactions
---@field height? number m, of a drift; default: the difference of z of the two nodes at the start
---@field name? string its column in history.csv; default such as node12_ux, node12_ux_to_node3

---time and value are lists of what was recorded up to the moment when they are read.
---@class hinge.probe
---@field time number[] s; in statics the load factor
---@field value number[]
---@field last number
---@field max number
---@field min number
---@field name string its column in history.csv
---@field unit string of the values: m, rad, m/s, rad/s, m/s^2, rad/s^2, N or N m; "" of a drift

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

---N and N m in the section's axes. f_y: yield function of the section's law (eq 14 or exact), with the hardening so far
---and without the strain rate; 1 where the section is fully plastic
---@alias hinge.resultants { N: number, Mx: number, My: number, Mz: number, Qx: number, Qy: number, f_y: number }

---As member:forces.
---```lua
---local at_a, at_b = run:forces(beam)
---print(at_a.Mx, at_b.Mx)
---```
---@param member hinge.member
---@return hinge.resultants at_a, hinge.resultants at_b at its two ends
function run:forces(member) end

---The resultants along a member, as member:along.
---```lua
---print(#run:along(beam))
---```
---@param member hinge.member
---@param parts? integer default 8
---@return hinge.resultants_at[]
function run:along(member, parts) end

---As member:state.
---```lua
---local state, f_y = run:state(beam)
---```
---@param member hinge.member
---@return "elastic"|"yielded"|"broken" state, number f_y, number? time, integer? element
function run:state(member) end

---@alias hinge.end_a "N_a"|"Mx_a"|"My_a"|"Mz_a"|"Qx_a"|"Qy_a"|"f_y_a"
---@alias hinge.end_b "N_b"|"Mx_b"|"My_b"|"Mz_b"|"Qx_b"|"Qy_b"|"f_y_b"
---@alias hinge.member_value "f_y"|"N"|"broken"|"yielded"|"touched"|"plastic_work"|"temperature"|"member"|"x"|"y"|"z"
---@alias hinge.member_quantity hinge.member_value|hinge.end_a|hinge.end_b

---@alias hinge.rate "vx"|"vy"|"vz"|"vrx"|"vry"|"vrz"|"ax"|"ay"|"az"|"arx"|"ary"|"arz" velocity, acceleration
---@alias hinge.reaction "reaction_fx"|"reaction_fy"|"reaction_fz"|"reaction_mx"|"reaction_my"|"reaction_mz"
---@alias hinge.node_quantity hinge.component|hinge.rate|hinge.reaction|"node"|"node_x"|"node_y"|"node_z"

---Reads one number for each member or each joint of the group, in the order of declaration. "member" and "node" give
---their indices. For members: f_y is the largest value in the member now. N is its mean axial force, N, 0 once it is
---broken. broken, yielded and touched are 1 or 0. plastic_work is in J. temperature is that
---in the middle of its section, degrees Celsius. member is the index. x, y, z are the middle of
---the member now, m. Names with _a and _b are the resultants at its ends, as in member:forces. For nodes: the
---quantities of run:probe; reactions are reaction_fx to reaction_mz. node is the index. node_x, node_y, node_z are the
---position now, m.
---```lua
---local f_y, place = run:read("f_y", "arm"), run:read("x", "arm")
---for i, value in ipairs(f_y) do print(place[i], value) end
---local reactions = run:read "reaction_fz" -- of every joint
---```
---@param quantity hinge.member_quantity|hinge.node_quantity
---@param group? hinge.group_like default: all; for quantities of nodes, the joints of the group's members
---@return number[]
function run:read(quantity, group) end

---The natural modes of small vibrations about the state of the run, the lowest first: unloaded, under its loads, or
---damaged. Members are elastic, also where they have yielded; what is broken is left out; connectors, joints, masses,
---rigid links and diaphragms count. Joints that have yielded have the stiffness with which they unload, the elastic
---one; joints = "slide": those at their strength (to a millionth of it) have none, as long as the motion turns them
---further. Axial forces change the stiffness as in the run. Bodies that nothing holds have modes of frequency 0. What
---has no mass (members without density, nodes with masses that have no rotary inertia) is condensed statically: there
---are as many modes as there are directions with mass.
---Moments, and loads that turn with their member, make the stiffness unsymmetric; where that changes the square of a
---frequency by a thousandth, it counts. It is an error if there are then more than 2000 degrees of freedom, and if one
---of the modes asked for flutters: its vibrations grow, which no real frequency says (ask for more modes to see
---whether a higher one does). It is an error if a frequency is lost in rounding, beside parts that are some 1e14 times
---as stiff. So is a run that has done no step, if rigid links or diaphragms carry forces that it took from another
---run.
---```lua
---for _, mode in ipairs(run:modes { n = 3 }) do print(mode.frequency, mode.period, mode.share.z) end
---```
---@param options? { n?: integer, joints?: "unload"|"slide" } how many, default 6
---@return hinge.mode[]
function run:modes(options) end

---Load factors at which the structure buckles, the lowest first, in the structure's declared place. Run a static run
---under the loads first, or under a part of them; the factor times its loads is Euler's load of the whole. The
---internal forces at the end of the run are multiplied; where it has come to another load factor than 1, the result is
---times that factor, so that it is on the declared loads. A run that has failed, or ended at its limit load, gives a
---warning. A run that began with the loads of another one (`from`) has its factors on the internal forces. What bends
---before it buckles has a limit load that is lower: the factor is an upper bound, which statics with an imperfection
---shows. Joints that have yielded have the stiffness with which they unload, or with joints = "slide" none, as in
---run:modes. The second result is the factor at which a pair of elements would buckle between clamped ends, which its
---two elements do not show: more elements a member show it; nil: there is none. It needs displacement = "large". It is
---an error where moments of fixed axis, or loads that turn with their member, change the factor by a thousandth: such
---a structure may flutter and need not buckle, and the symmetric part of its stiffness has a factor that it does not
---have.
---```lua
---local column = model:node { 1, 0, 2 }
---model:member { tip, column, section = square, material = steel }
---model:load { node = column, force = { 0, 0, -1000 } }
---local modes = model:static():finish():buckling { n = 2 }
---print(modes[1].factor)
---```
---how many, default 1; factors above `most` are not looked for. A model with panels is an error
---@param options? { n?: integer, most?: number, joints?: "unload"|"slide" }
---@return hinge.mode[] modes, number? hidden
function run:buckling(options) end

---A shape in which a structure vibrates or buckles. job:picture(mode, view) draws it: any view of a run.
---@class hinge.mode
---@field frequency number? Hz; 0 where the state is unstable: see omega_squared. This and the next five: natural modes
---@field period number? s
---@field omega_squared number? square of the circular frequency, 1/s^2; negative where the state is unstable
---shape . M r for a unit displacement r of the whole along an axis; the shape has a modal mass of 1 kg
---@field participation { x: number, y: number, z: number }?
---@field mass { x: number, y: number, z: number }? effective masses, kg
---@field share { x: number, y: number, z: number }? effective masses over the mass of the whole, supports included
---@field factor number? of buckling modes
local mode = {}

---Displacement (m) and rotation (rad) of a node in the shape. A natural mode has a modal mass of 1 kg; the largest
---displacement of a buckling mode is 1 m.
---```lua
---local ux, uy, uz, rx, ry, rz = run:modes()[1]:displacement(tip)
---```
---@param node hinge.node
---@return number ux, number uy, number uz, number rx, number ry, number rz
function mode:displacement(node) end

---The state of the run with the shape on top of it, for pictures and films.
---```lua
---hinge.strip({ { run:modes()[1]:snapshot(0.1), { title = "first mode" } } }, 1, "mode.png")
---```
---@param amplitude? number its largest displacement, m; default: a twentieth of the structure's size
---s; the shape is then amplitude sin(2 pi time / period), with a period of 1 s for buckling modes, and pictures show
---the time. Default: the amplitude itself
---@param time? number
---@return hinge.snapshot
function mode:snapshot(amplitude, time) end

---The plastic hinges, and the joints. Hinges are all sections that have ever been fully plastic, in this run and in
---the runs before (`from`). Of a joint (hinge.joint, model:joint) each axis that is a spring has a row, and each
---force at which it breaks; pins and rigid axes have none. A connector (model:connector) has a row for each direction
---with a capacity. They come by storey, member and place in the member. Where two elements of a member meet there is
---one hinge: the rotation is that of both. The list keeps the values of now; it does not follow the run. limit
---compares the largest rotation so far of each hinge (demand) with a limit in rad. It is a number, or the levels { IO
---=, LS =, CP = } (immediate occupancy, life safety, collapse prevention; one or more, rising). It may be a table of
---these by group: a member's first group in it counts. It may be a function of the hinge that returns one of these,
---or nil for no limit. The limit is that of rotation alone: a brace that yields by its axial force has no rotation,
---and an elongation. The rotation of a joint is the whole of it, with the elastic part. Its own limits (`capacity`,
---`tension`, `shear` of hinge.joint) are compared too, with `limit` or without: the one that it has come nearest to
---gives its ratio.
---```lua
---local pushed = model:static { steps = 5 }:finish()
---local found = pushed:hinges { group = "arm", limit = { IO = 0.01, LS = 0.03, CP = 0.04 } }
---print(found) -- how many, the worst, and a table of the 20 largest
---for _, h in ipairs(found) do print(h.member.index, h.at, h.largest, h.first_yield, h.ratio) end
---found:write() -- hinges.csv
---```
---@param options? { group?: hinge.group_like, limit?: hinge.hinge_limit } group default: all members
---@return hinge.hinge_list
function run:hinges(options) end

---@alias hinge.hinge_levels number|{ IO?: number, LS?: number, CP?: number } rad
---by group, or by hinge
---@alias hinge.hinge_limits table<string, hinge.hinge_levels>|fun(h: hinge.plastic_hinge): hinge.hinge_levels?
---@alias hinge.hinge_limit hinge.hinge_levels|hinge.hinge_limits

---A list of hinges. print shows it as a table.
---@class hinge.hinge_list
---@field [integer] hinge.plastic_hinge
---the hinge with the largest ratio; without limits the one with the largest demand; nil in an empty list
---@field worst? hinge.plastic_hinge
---how many are beyond their limit; nil where no limit is given, and no joint breaks at one of its own
---@field beyond? integer
---@field without_limit? integer how many have none; nil in the same case
---@field statics boolean of a static run
local hinges = {}

---Writes the list as a CSV file into the output folder. A program's last run leaves hinges.csv by itself, without
---limits, unless the script has written it. `hinge report` shows it.
---```lua
---model:static { steps = 5 }:finish():hinges { limit = 0.03 }:write()
---```
---@param filename? string plain name ending in .csv, default hinges.csv
---@return hinge.hinge_list
function hinges:write(filename) end

---A plastic hinge, or an axis or a force of a joint. In the file hinges.csv member and node are numbers; before,
---broken, yielded and failed are 1 or 0.
---@class hinge.plastic_hinge
---@field member hinge.member of a joint between nodes the first member at the second of them
---@field group? string name of the member's first group
---storey from 1 at the ground, with z upwards: floors are the heights of level members that hang together with a
---support; nil: none
---@field storey? integer
---@field element integer from 1, counted over the whole model
---@field end integer end of the element, 1 or 2; 0: the middle of a conventional element; written h["end"]
---@field at number its place in the member: 0 at a, 1 at b
---@field node? hinge.node the joint at this section; nil: it is inside the member
---@field x number m, at the start
---@field y number m
---@field z number m
---rad, plastic, now, about the section's x axis; positive like curvature_x. Of a joint: of the end relative to the
---node, about the axes that are springs
---@field rotation_x number
---@field rotation_y number rad
---@field rotation_z? number rad; of joints
---@field rotation number rad, of x and y together; of a joint's z axis that about z
---@field largest number rad, the largest value that rotation has had; of a joint that about its own axis alone
---rad, what a limit is compared with: largest; where two members meet in a joint, and no third, the sum of both,
---because they may share the rotation of one hinge. Of a joint's x and y axes: the largest of both together
---@field demand number
---@field elongation number m, plastic, now: its part of the member's
---@field work number J, dissipated in it
---@field f_y? number yield function of the section's law, now; nil of joints
---the square root of f_y, which grows with the forces; 1 where fully plastic. Of a joint moment or force over what it
---holds now; nil without a strength
---@field utilisation? number
---when it first yielded: s, in statics the load factor; nil of a joint that has not
---@field first_yield? number
---@field first_kind? "static"|"dynamic" the kind of run in which it did
---@field before? boolean true: in a run before this one
---@field broken boolean an element at this section is broken; the joint is
---@field yielded boolean false: a joint that has kept to the elastic part of its curve
---rad; of levels the largest; of a joint its capacity where that gives the ratio; nil where a force does
---@field limit? number
---@field ratio? number demand over limit; of a joint largest over capacity, or largest_force over strength
---the level that its demand keeps to: "IO", "LS", "CP", "beyond CP" or "beyond capacity"; nil without levels
---@field level? string
---"joint at end a of member 3", "joint between nodes 4 and 9", "connector 2 between nodes 4 and 9"; nil: a hinge. This
---and what follows: of joints, and of connectors with a capacity
---@field joint? string
---of the section; or the force at which the joint breaks; of a connector "force_x" to "moment_z", along and about its
---own axes, each that has a capacity
---@field axis? "x"|"y"|"z"|"tension"|"shear"|string
---@field connector? integer its number, in the order of declaration; nil: it is no connector
---@field between_nodes? boolean made by model:joint or model:connector
---@field moment? number N m, now, about the axis, on the node
---@field largest_moment? number N m, of either sign
---@field force? number N, now: tension or shear; of connectors without a sign, N or N m; 0 where it has broken
---@field largest_force? number N; of a connector N or N m, of either sign
---@field stiffness? number N m/rad, elastic
---@field strength? number N m, the largest moment of its curve; N, at which it breaks; nil: elastic
---@field capacity? number rad, at which it breaks
---@field interaction? "linear" tension weakens its moments
---@field failed? boolean it broke by one of its own limits; in statics: it is beyond one

---Momentum and kinetic energy of all members or of a group: what a blow has given to one body and taken from the other.
---Point masses and broken elements belong to the node that carries them. They count where no member outside the group
---meets that node.
---```lua
---local momentum = run:momentum()
---print(momentum.mass, momentum.linear[1], momentum.angular[3], run:momentum("arm").kinetic)
---```
---@param group? hinge.group_like default: all members
---@return { mass: number, linear: vec3, angular: vec3, kinetic: number } kg, kg m/s, kg m^2/s about the origin, J
function run:momentum(group) end

---Returns how many members of a group are in a state. A member is broken if one of its elements is broken. Else it is
---yielded if one of them has ever been fully plastic, else elastic. It is touched, in addition to its other
---state, if it has ever been in contact.
---```lua
---print(run:count { group = "arm", state = "yielded" }, run:count { state = "broken" })
---```
---@param options { group?: hinge.group_like, state: "elastic"|"yielded"|"broken"|"touched" } group default: all members
---@return integer
function run:count(options) end

---Keeps the structure as it is now, for pictures.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---local first = swing:snapshot()
---swing:finish()
---hinge.strip({ { first }, { swing } }, 2, "before_and_after.png")
---```
---@return hinge.snapshot
function run:snapshot() end

---@class hinge.snapshot

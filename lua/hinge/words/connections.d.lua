---@meta
-- Connectors, joints, damping and ground ------------------------------------------------------------------------------

---@class hinge.model
local model = {}

---Adds a connector: springs, dashpots, curves and laws along three axes and about them. It connects two nodes, { a, b,
---... }, or a node and the ground at the declared position of the node, { node, ground = true, ... }. Several parts in
---one direction add up. A direction without any part is free. Node a carries the connector at the end of a rigid arm
---that reaches to b. The deformation is the displacement of b from the end of that arm, along the axes (m), and the
---rotation vector of b relative to a (rad). Both are zero in the declared position. In large displacement the axes
---rotate with a; those of the ground do not rotate. The force pulls b back and pulls a along. It also gives its moment
---to a, so momentum is kept. In statics dashpots have no force. Explicit steps must be shorter than 2 / (d + sqrt(d^2 +
---w^2)). Here w^2 (1/s^2) and d (1/s) are upper bounds of k/m and c/m. They are summed over all connectors at a node,
---with the lumped masses of the nodes and the highest frequency of the members there. dt = "auto" keeps this limit.
---Newmark's steps are then at most 0.9 / w, with w of the springs alone. Laws of a script are not in these limits. The
---energy is in run.energy.connector_stored and connector_dissipated. It is an error if the connector has no part that
---acts. It is also an error to make a run with such a node that belongs to no member, or with too long an explicit
---step.
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
---@field ground? boolean true: the other end is the ground; default false
---@field axes? { x: vec3, y: vec3 } default: global; y is made normal to x, z is normal to both
---N/m along x y z, N m/rad about them; 0 or above
---@field stiffness? { x?: number, y?: number, z?: number, rx?: number, ry?: number, rz?: number }
---N s/m along x y z, N m s/rad about them; 0 or above
---@field damping? { x?: number, y?: number, z?: number, rx?: number, ry?: number, rz?: number }
---for a direction, points { { deformation, force }, ... } (m, N; rad, N m). The curve is elastic and linear between the
---points, and goes on in a straight line beyond the last one. Points from { 0, 0 } on hold for both signs; else they go
---from below 0 to above 0
---@field curve? { x?: number[][], y?: number[][], z?: number[][], rx?: number[][], ry?: number[][], rz?: number[][] }
---for a direction, a function of four arguments: deformation (m, rad), its rate (m/s, rad/s), state, and dt (s; 0 where
---no time passes). It returns the force (N, N m), and if it keeps a state, the new state. The state is a table of
---numbers by name. It is empty at first. If the function returns no state, the state does not change. The state belongs
---to the run: it is undone with a step and is kept in checkpoints. The function is called several times a step, each
---time with the state at the end of the last step. All of its work counts as dissipated. An error undoes the step, and
---is raised at the line of the script that asked for the step
---@field law? { x?: function, y?: function, z?: function, rx?: function, ry?: function, rz?: function }
---N, N m. If the force in one direction, of either sign, has reached this value at the end of a step, the whole
---connector breaks. The energy that it stored is lost. run.state_changes and events.csv list the break, and run:hinges
---rates the largest force so far by it. Default: it never breaks
---@field capacity? { x?: number, y?: number, z?: number, rx?: number, ry?: number, rz?: number }
---N, N m: the force at which the spring of `stiffness` in a direction flows, perfectly plastic; xy: the size of the
---forces along x and y, which then need the same stiffness. Its work is in connector_dissipated. Default: elastic
---@field yield? { x?: number, y?: number, z?: number, rx?: number, ry?: number, rz?: number, xy?: number }
---m, rad: the plastic deformation, from the declared position, at which the connector breaks; xy: the size of the two.
---Default: it never breaks by it
---@field ultimate? { x?: number, y?: number, z?: number, rx?: number, ry?: number, rz?: number, xy?: number }

---A connector, made by model:connector. Its methods read the given run, or by default the latest run of its model.
---@class hinge.connector
local connector = {}

---The deformation of the connector, m and rad. For a broken one it is the deformation at which it broke.
---```lua
---local spring = model:connector { tip, ground = true, stiffness = { z = 1e5 } }
---model:static():finish()
---local _, _, z = spring:deformation()
---```
---@param run? hinge.run
---@return number x, number y, number z, number rx, number ry, number rz
function connector:deformation(run) end

---The force that pulls b back, N and N m, along the axes. It is 0 once the connector is broken.
---```lua
---local spring = model:connector { tip, ground = true, stiffness = { z = 1e5 } }
---model:static():finish()
---local _, _, fz = spring:force()
---```
---@param run? hinge.run
---@return number x, number y, number z, number rx, number ry, number rz
function connector:force(run) end

---The time at which the connector broke, s; false while it is not broken.
---```lua
---local hook = model:connector { tip, ground = true, stiffness = { z = 1e5 }, capacity = { z = 100 } }
---model:dynamic { dt = 1e-4, duration = 0.02 }:finish()
---print(hook:broken()) -- s, or false
---```
---@param run? hinge.run
---@return number|false
function connector:broken(run) end

---Joins node b to node a at the same place: b stays where a is, and moments resist its rotation relative to a. So a
---panel zone stands between the columns at one node and the beams at another, or a hinge that several members share.
---The moments are about the axes, which rotate with a. Of the joint the moments and their capacities count; one with
---`tension` or `shear` is an error. When it breaks, b is free to move. Both nodes need a member. b follows no other
---node: it is no follower of a rigid link or of a diaphragm; a may be. Rigid axes are springs, as in hinge.joint, of
---the stiffest member at the two nodes. It does not go with the energy-momentum method.
---```lua
---local columns_at, beams_at = model:node { 1, 0, 0 }, model:node { 1, 0, 0 }
---local post, girder = model:node { 1, 0, -3 }, model:node { 5, 0, 0 }
---model:fix { post, girder }
---model:member { post, columns_at, section = square, material = steel }
---model:member { beams_at, girder, section = square, material = steel }
---local panel = model:joint { columns_at, beams_at, joint = hinge.joint { Mx = { stiffness = 1e8, strength = 2e5 } },
---  axes = { x = { 0, 1, 0 }, y = { 0, 0, 1 } } } -- x: across the frame
---model:static():finish()
---print(panel:state().Mx, panel:state().rotation_x)
---```
---@param options hinge.node_joint_options
---@return hinge.node_joint
function model:joint(options) end

---@class hinge.node_joint_options
---@field [1] hinge.node a
---@field [2] hinge.node b, at the same place
---@field joint hinge.joint
---@field axes? { x: vec3, y: vec3 } default: global; y is made normal to x, z is normal to both

---A joint between two nodes, made by model:joint.
---@class hinge.node_joint
local node_joint = {}

---What the joint is where the run stands, or the latest run of the model.
---```lua
---local here, there = model:node { 1, 0, 0 }, model:node { 1, 0, 0 }
---local foot, far = model:node { 1, 0, -3 }, model:node { 5, 0, 0 }
---model:fix { foot, far }
---model:member { foot, here, section = square, material = steel }
---model:member { there, far, section = square, material = steel }
---local spring = model:joint { here, there, joint = hinge.joint { Mx = { stiffness = 1e6 } } }
---model:static():finish()
---print(spring:state().Mx, spring:state().broken)
---```
---@param run? hinge.run
---@return hinge.node_joint_now
function node_joint:state(run) end

---@class hinge.node_joint_now
---@field Mx number N m, that the joint puts on a
---@field My number N m
---@field Mz number N m
---@field rotation_x number rad, of b relative to a; of a broken joint, where it broke
---@field rotation_y number rad
---@field rotation_z number rad
---@field broken number|false s

---Rayleigh damping in dynamics, C = alpha M + beta K of each element (Rayleigh 1877, section 81): by its coefficients,
---or by ratios of critical damping at two periods, between which there is less and outside of which more. alpha damps
---the velocity relative to the supports: along x, y and z each relative to the mean velocity of those supports of the
---same body that are held in that direction (whole elements and connectors join a body; a support that does not move
---counts with zero). So a structure that moves with its ground is not damped. Where supports move differently that
---mean is a simplification: the rest of their motion is damped. The work of the moving supports on alpha is part of
---run.energy.work. A body without supports, also one that has broken off, is damped by its velocity in space, in
---flight and rotation as a whole too. `hinge check` and `hinge run` warn of bodies that are free from the start,
---unless alpha is given with a group of such bodies only; give alpha with a group, or beta alone, where parts may
---break off and fly. beta damps the elastic rates of the element's own deformation, beta k (d' - d_p') with the elastic
---stiffness k. So it damps no rigid motion, and no rotation of a plastic hinge, with any number of elements. Yield is
---decided by the elastic forces alone. Semi-rigid joints, panel zones (hinge.joint, model:joint) and the springs and
---curves of connectors, those to the ground too, take part with beta k of their own; the slip of a joint that yields is
---free, and rigid axes have no damping. A joint at a member's end has the beta of the member; a joint between nodes and
---a connector have the mean of the members' elements at their nodes. joints = false leaves them out. The moments and
---forces that a script reads of joints and connectors, and their capacities, are without that damping. A point mass
---(model:mass), its rotary inertia and its offset with it, has the alpha of the members at its node; where they differ,
---as by groups, their mean. A broken element is damped no more, nor is the mass left of it, and it no longer counts in
---that mean: a point mass whose members have all broken off flies undamped. Of several calls the last one that applies
---to a member's groups counts, so that alpha = 0 with a group leaves it undamped. The energy that it dissipates is in
---run.energy.damping. With explicit steps beta shortens the longest stable step (dt = "auto" includes this). It does
---not act in statics.
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
---@field joints? boolean false: beta does not damp the joints and connectors at these members; default true

---Adds a ground on which members can fall: the half space behind a plane. It pushes and never pulls. There are two
---laws.
---
---The default is a layer of springs and dashpots per area, which takes the energy of what lands. It presses with
---layer_stiffness o + layer_damping o' (N/m^2) on the area that a member touches it with, o (m) the overlap and o' its
---rate: the smaller side of the section times the length that touches, and at an end of a member the area of the
---section. Of the first counts the part sin^2, of the second cos of the angle between the axis and the normal. What
---lands is stopped in the same way with any number of elements.
---
---With `stiffness` or `restitution` the ground is points on elastic springs instead. The points are the nodes, also
---those inside members, and the free ends of broken members. An overlap o stores k o^2 / 2.
---
---Nodes of panels meet the planes without `group` as points on springs. Of a layer they have its stiffness times the
---area of the panels there, and a restitution, 0.2 or more, that stands for its damping.
---
---In both, members are round, with half the smaller side of the section as radius. Each call adds a plane. Nodes whose
---displacements are fixed do not touch. What touches when the run begins is at rest there. What has its axis below the
---plane when the run begins is left out until it has left the ground. The ground acts in statics too, with the springs
---alone; statics needs supports. run.energy then has ground, the sum of ground_stored (now) and ground_dissipated (by
---the dashpots, friction and restitution, and what was stored where an end breaks off), J.
---```lua
---model:ground { point = { 0, 0, -0.05 }, friction = 0.5 }
---```
---@param plane? hinge.ground_plane
function model:ground(plane) end

---@class hinge.ground_plane
---@field point? vec3 m, on the plane; default {0, 0, 0}
---@field normal? vec3 direction out of the ground, of any length above 0; default {0, 0, 1}
---Coulomb's coefficient, 0 or above, default 0. It acts where the surface touches. What sticks is held by a spring
---along the plane: of points 0.4 k, of the layer 100 times what it presses with on half an element or on an end face.
---If the pressure becomes too small for the force of this spring, the surface slips by the difference. Under shaking it
---therefore creeps a little
---@field friction? number
---N/m^3, above 0; default 1e8, the modulus of subgrade reaction of dense sand (64 to 128 MN/m^3: Bowles, Foundation
---Analysis and Design, 1996, table 9-1). A steel bar of 0.1 m that lies flat settles by 0.08 mm, a column of 3 m that
---stands on its end by 2.3 mm. Not with `stiffness` or `restitution`
---@field layer_stiffness? number
---N s/m^3, 0 or above; default 2e6. This value is chosen, not measured: a steel column of 3 m that lands on its end
---then keeps about a quarter of its speed (damping 0.65 of critical), and what lands flat keeps none. Waves into dense
---sand take a third of it (Lysmer: density times wave speed); the rest stands for soil and rubble that are crushed.
---Both are part of the limit of explicit steps and of dt = "auto"; light members shorten them by up to a half. Not with
---`stiffness` or `restitution`
---@field layer_damping? number
---asks for points: k of each point, N/m, above 0. Default: 0.4 EA / L of each element that meets there, which keeps
---explicit steps stable. A fall at speed v then penetrates by about v / (0.9 c) L, where c is the speed of sound. A
---given value is part of the limit of explicit steps and of dt = "auto", like the stiffness of connectors. This does
---not include free ends of members that break in the run
---@field stiffness? number
---asks for points: 0..1, the part of the normal velocity that a point keeps when it comes out of the ground, by
---Newton's law of impact, as a sudden impulse. Points of one body that come out at nearly the same time get their
---impulses together. Default with `stiffness`: 1, the springs alone, which dissipate nothing; vibration of the member
---still takes its part. It is the velocity of the points: a bar that lands flat comes back with this part of its speed,
---but an elastic bar that lands on its end comes back with 0.8 to 1 of it whatever this is, and the more so the more
---elements it has, because one of its nodes alone touches the ground. Where restitution below 1 comes with friction,
---explicit steps as long as dt = "auto" takes miss several percent of the energy, and a run may end for that; 0.4 of
---that step misses 0.3 % in the mean
---@field restitution? number
---@field group? hinge.group_like only members of this group; default: all

---Returns the group with this name, to which members were added.
---```lua
---local arm = model:group "arm"
---print(#arm, arm.length, arm.mass)
---```
---@param name string
---@return hinge.group
function model:group(name) end

---Returns the size of the model. A member with elements = "auto" counts as two elements until the first run decides.
---```lua
---local counts = model:counts()
---print(counts.members, counts.elements, counts.free_dofs)
---```
---@return { members: integer, elements: integer, nodes: integer, free_dofs: integer }
function model:counts() end

---A plate between three or four nodes of one plane, such as a piece of a floor: it resists in its plane, wherever its
---nodes go, and bends across it. It consists of layers that share its strain: a solid plate of metal, concrete that
---carries compression alone, bars and ribs along its x or y axis. Layers yield, crush and tear. Panels bend about the
---sides that they share; triangles do not bend.
---What it weighs is at its nodes, and stays there where it tears. A node may belong to panels alone: it has no rotation
---then, and takes forces, masses, supports and connectors along x, y and z.
---Bodies touch panels by model:panel_contact. model:damping acts on the masses of nodes that panels alone join, by
---alpha of the whole model, and not on the stiffness of panels.
---In statics a flat plate without bending is an error, since nothing holds it across its plane. A row of supports is an
---axis about which plates turn freely. Sides of panels that bend must go on in line at the nodes inside, to 25 degrees.
---```lua
---local corner = {}
---for i, p in ipairs { { 5, 0, 0 }, { 6, 0, 0 }, { 6, 1, 0 }, { 5, 1, 0 } } do corner[i] = model:node(p) end
---model:fix({ corner[1], corner[2] }, "xyz")
---model:fix({ corner[3], corner[4] }, "z")
---local plate = model:panel { corner[1], corner[2], corner[3], corner[4], thickness = 0.01, material = steel }
---model:load { node = corner[3], force = { 0, 1e4, 0 } }
---model:static { steps = 1 }:finish()
---print(plate:force()) -- N/m
---```
---@param options hinge.panel_options
---@return hinge.panel
function model:panel(options) end

---Lets points press on panels: the nodes of other panels and of members, and points between these where they are
---farther apart than the smallest panel is wide. One call holds for all panels of the model. A point that comes closer
---to the middle of a panel than the half thicknesses of both together is pushed back along the panel's normal, on the
---side from which it came:
---```
---f = k g (1 + a r / v)      g: depth, m; r: its rate, m/s; v: the largest rate since the point touched, m/s
---```
---`a` follows from `restitution` (Hunt and Crossley 1975). Force and counterforce keep linear and angular momentum.
---Points that overlap a panel when the run begins are at rest there until they rise. A panel that has a node of the
---point's own members or panels, or of their neighbours, does not meet it. Acts in dynamics, by Newmark's method and in
---explicit steps. run.energy has panel_contact, the sum of panel_contact_stored and panel_contact_lost, J. Members meet
---members by model:contact; panels and the ground meet by model:ground.
---```lua
---local corners = {}
---for i, p in ipairs { { 5, 0, 1 }, { 6, 0, 1 }, { 6, 1, 1 }, { 5, 1, 1 } } do corners[i] = model:node(p) end
---local plate = model:panel { corners[1], corners[2], corners[3], corners[4], thickness = 0.01, material = steel }
---local contact = model:panel_contact { restitution = 0.3, friction = 0.5 }
---local fall = model:dynamic { dt = 1e-3, duration = 0.01 }:finish()
---print(contact:pressing(fall))
---```
---@param options? hinge.panel_contact_options
---@return hinge.panel_contact
function model:panel_contact(options) end

---@class hinge.panel_contact_options
---part of its speed with which a point goes back from a panel, 0.2 to 1; default 1
---@field restitution? number
---@field friction? number Coulomb's coefficient; default 0
---N/m, k of each point. Default: that of the lighter one of the masses at the point's and the panel's nodes, times (400
---rad/s)^2. A contact then takes 8 ms; what lies on a panel sinks in by 0.06 mm, and what comes at v goes v / 400 deep.
---Give more for what is fast, and shorter steps
---@field stiffness? number
---@field members? boolean points of members meet panels too; default true

---Contact of panels, made by model:panel_contact.
---@class hinge.panel_contact
local panel_contact = {}

---The number of points that press on panels now, the sum of their forces in N, and the deepest in m.
---```lua
---local contact = model:panel_contact {}
---model:dynamic { dt = 1e-3, duration = 1e-3 }:finish()
---print(("%d points press with %.3g N"):format(contact:pressing()))
---```
---@param run? hinge.run default: the latest run of the model
---@return integer points
---@return number force
---@return number depth
function panel_contact:pressing(run) end

---What a plate is made of is at least one of `thickness` with `material`, `concrete`, `reinforcement` and `deck`.
---@class hinge.panel_options
---@field [1]? hinge.node three or four nodes, in their order around the panel. No corner may point inward
---@field [2]? hinge.node
---@field [3]? hinge.node
---@field [4]? hinge.node
---@field thickness? number m, of a solid plate of `material`
---of the plate: E, G, density and yield_stress, by von Mises' criterion in plane stress
---@field material? hinge.material
---@field hardening? number Pa, of the plate: stress over plastic strain, isotropic; default 0
---@field ultimate_strain? number of the plate: equivalent plastic strain at which it tears; default: never
---concrete without tension, and with a constant compressive strength in the directions of principal strain
---@field concrete? hinge.panel_concrete
---bars along the sheet's axes, one mesh or a list of several. Their mass is that of the concrete in their place
---@field reinforcement? hinge.panel_bars|hinge.panel_bars[]
---ribs of a steel deck, which carry along one axis
---@field deck? hinge.panel_deck
---bending across the plate. Default: that of the solid plate; without one, none. false: none. "layers": the layers at
---their heights z give it, six levels of concrete and of a plate among them, so that cracks, moments beside membrane
---forces and plastic moments of either direction and sign follow from what the panel is made of. That takes several
---times the time of a moment given by hand. See the guide's page on slabs
---@field bending? hinge.panel_bending|"layers"|false
---@field along? vec3 the sheet's x axis, projected into the panel; default: from the first node to the second one
---kg/m^2; default: density times thickness of the plate and of concrete, and 7850 kg/m^3 times the area of a deck
---@field mass? number

---@class hinge.panel_concrete
---@field thickness number m
---@field E number Pa
---@field strength? number Pa, in compression; default: elastic
---@field density? number kg/m^3, default 2500
---@field z? number m, of its middle above that of the panel, to where its normal points; with bending = "layers"

---Moments per width. Sagging pulls on the side that the panel's normal points away from. The normal points to where the
---nodes of the panel run counter-clockwise. Where panels around a node point to both sides, the first one's counts.
---@class hinge.panel_bending
---@field stiffness number N m: E I per width, of a plate E t^3 / 12 (1 - poisson^2)
---@field poisson? number default 0
---@field sagging? number N m/m, plastic moment; default: elastic
---@field hogging? number N m/m

---@class hinge.panel_bars
---@field x? number m^2/m, area per width of the bars along x
---@field y? number m^2/m
---@field E? number Pa, default 200e9
---@field yield_stress? number Pa, default: elastic
---@field hardening? number Pa, of stress over plastic strain; default 0
---@field ultimate_strain? number their stretch at which they break; default: never
---m, above the middle of the panel, to where its normal points (up, in model:floor); with bending = "layers"; default 0
---@field z? number

---@class hinge.panel_deck
---@field area number m^2/m, per width
---@field along? "x"|"y" default "x"
---@field z? number m, as of bars; the ribs of a deck may hang below the concrete
---@field E? number Pa, default 200e9
---@field yield_stress? number Pa, default: elastic
---@field hardening? number Pa, default 0
---@field ultimate_strain? number default: never

---A panel, made by model:panel. Its methods read the given run, or by default the latest run of its model.
---@class hinge.panel
---@field index integer from 1, in the order of declaration
---@field nodes hinge.node[]
---@field area number m^2
---@field mass number kg
---@field shares number[] of its area that belongs to each node, m^2
local panel = {}

---Its mean membrane forces per width in the sheet's axes, N/m; tension is positive. Zero where it has torn.
---```lua
---local a, b, c = model:node { 5, 0, 0 }, model:node { 6, 0, 0 }, model:node { 6, 1, 0 }
---model:fix({ a, b, c }, "xyz")
---local plate = model:panel { a, b, c, thickness = 0.01, material = steel }
---model:static({ steps = 1 }):finish()
---local n11, n22, n12 = plate:force()
---```
---@param run? hinge.run
---@return number n11
---@return number n22
---@return number n12
function panel:force(run) end

---When the last of its layers tore: s, in statics the load factor. false: it has not torn. Concrete is torn with the
---last of the steel in it.
---```lua
---local a, b, c = model:node { 5, 0, 0 }, model:node { 6, 0, 0 }, model:node { 6, 1, 0 }
---model:fix({ a, b, c }, "xyz")
---local plate = model:panel { a, b, c, thickness = 0.01, material = steel, ultimate_strain = 0.1 }
---model:static({ steps = 1 }):finish()
---print(plate:torn())
---```
---@param run? hinge.run
---@return number|false
function panel:torn(run) end

---The largest part of its ultimate strain that a layer has reached so far.
---```lua
---local a, b, c = model:node { 5, 0, 0 }, model:node { 6, 0, 0 }, model:node { 6, 1, 0 }
---model:fix({ a, b, c }, "xyz")
---local plate = model:panel { a, b, c, thickness = 0.01, material = steel, ultimate_strain = 0.1 }
---model:static({ steps = 1 }):finish()
---print(plate:used()) -- 0: nothing strains it
---```
---@param run? hinge.run
---@return number
function panel:used(run) end

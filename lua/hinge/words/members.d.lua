---@meta
-- Members of a model --------------------------------------------------------------------------------------------------

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

---Frees the memory of the model and of its runs at once, even if handles still exist. Any later use of such a handle is
---an error, which says where the model was closed. A model without any handle is freed automatically. It is an error to
---call close inside a step of a run of the same model.
---```lua
---for storeys = 1, 3 do
---  local tower = hinge.model()
---  tower:node { 0, 0, 3 * storeys }
---  tower:close()
---end
---```
function model:close() end

---Adds a joint to the model.
---```lua
---local top = model:node { 0, 0, 3 } -- x, y, z; z is up by custom
---```
---@param position vec3 m
---@return hinge.node
function model:node(position) end

---Fixes degrees of freedom of one node or of a list of nodes, in addition to those that are already fixed.
---```lua
---model:fix(wall) -- all six
---model:fix({ wall, tip }, "y,rx,rz") -- bends in the plane of x and z alone
---```
---@param node hinge.node|hinge.node[]
---@param what? string "all" (default), or letters: "xyz" displacements, "rx", "ry", "rz" rotations, as in "x,y,rx"
function model:fix(node, what) end

---Adds a member between two joints. The member is rigidly connected to both.
---```lua
---local column = model:member { wall, model:node { 0, 0, 3 }, section = square, material = steel,
---  up = { 1, 0, 0 }, group = "columns", elements = 4 }
---model:member { wall, tip, section = hinge.section.round { diameter = 0.02 }, material = steel, carries = "tension" }
---```
---@param options hinge.member_options
---@return hinge.member
function model:member(options) end

---@class hinge.member_options
---@field [1] hinge.node
---@field [2] hinge.node
---@field section hinge.section
---@field material hinge.material
---direction of the section's y axis: any vector that is not along the member. Default: upwards; along the x of space
---for an upright member
---@field up? vec3
---@field group? string|hinge.group|(string|hinge.group)[] the first one sets its colour
---@field elements? integer|"auto" default: elements_per_member of the model; "auto" is described there
---strength of its ends over their plastic rotation; default: constant. Not with the conventional element. For a
---function of your own take law
---@field backbone? hinge.backbone
---what the flow of its sections does to their strength, as a function of yours. It is asked for each end of an element
---that flows, some hundred times a step, and must depend on its arguments alone. Hardening and rate of the material,
---and a backbone, act beside it. A run with such a function has one thread. A function alone has no history variables
---@field law? hinge.section_law|fun(flow: hinge.section_flow, history: number[]): number, number[]?, number[]?
---which axial forces it carries. both (default). tension: a cable or slender brace. It shortens without force, and
---carries again at the length where it lost its force. compression: a prop or a bearing, the same the other way. No
---energy is dissipated by that. With a yield stress the member yields at N0 in the sense that it carries; its bending
---and torsion stay elastic, and a material with hardening or rate is refused. The axial force acts on the chords of
---its elements (as p_delta = "chord"): a compression member that may buckle takes eight elements. N in the middle of an
---element says whether it is slack. The nodes of an element take half each of a load along it, slack or not. So where
---the member is slack between two held ends, half of the load of an element presses on the end there: N is -q l / 2 in
---the place of 0 (l: length of an element), and at the other end (1 - 1/(2 n)) q L in the place of q L with n elements:
---0.75 of it with two, 0.94 with eight. A run warns where that is more than 5 % of the largest axial force (in
---dynamics where the member is at rest), and says how many elements it takes
---@field carries? "both"|"tension"|"compression"
---joints of its ends, made by hinge.joint; a is the end at the first node. Default: rigid
---@field ends? { a?: hinge.joint, b?: hinge.joint }
---moments that an end does not pass on: "Mx", "My" (bending about the section's axes) or "Mz" (torsion), or a list of
---them. A short form of ends with hinge.joint { Mx = "free" }. Mz can be free at one end alone
---@field release? { a?: string|string[], b?: string|string[] }
---m, what leads from a node to the member's end, in space, as declared: rigid ends, or another line than that between
---the nodes (insertion points). It rotates with its node, has neither mass nor strain, and does no work. The member,
---its length, its loads, joints and results are those between these ends. It needs no further node. A node may follow a
---diaphragm or a rigid link, and the ends of its members follow with it. Not with integrator = "energy-momentum" and
---not at a node that model:move moves. Default: the ends are at the nodes
---@field offset? { a?: vec3, b?: vec3 }

---Members through several nodes, one after the other, with the options of model:member. Where one of them is refused,
---none is added.
---```lua
---local mid = model:node { 0.5, 0, 0 }
---model:line { wall, mid, tip, section = square, material = steel, group = "arm" }
---```
---@param options hinge.grid_members with two nodes or more
---@return hinge.member[]
function model:line(options) end

---What members have that do not say otherwise: any options of model:member but the nodes. With `group`, for members of
---which that is the first group; without it, for all members. An option of the member itself counts first, then that of
---its group, then that of all. It holds for members that are made after it, by model:member, model:line and hinge.grid.
---A later call for the same group takes the place of the former one.
---```lua
---model:defaults { section = square, material = steel }
---model:defaults { group = "columns", section = hinge.section.named "HEB 200", elements = 4 }
---local post = model:member { wall, model:node { 0, 0, 3 }, group = "columns" }
---print(post.section.kind, post.elements) -- HEB 200, 4
---```
---@param options hinge.grid_members
function model:defaults(options) end

---@class hinge.section_law
---@field variables? integer history variables of each section that can yield, 0 (default) to 32; they are 0 at first
---returns the strength at the end of the step over the fully plastic one, 0.01 or more, which counts for N, Mx, My and
---Mz alike; then the middle of the yield surface, Mx, My (N m), N (N), Mz (N m), nil: 0; then the history variables at
---the end of the step, nil: as they were. `history`: those at its start
---@field step? fun(flow: hinge.section_flow, history: number[]): number, number[]?, number[]?
---in the place of step: it is asked for several flows of one section at once, which all begin with `history`. Each
---field of flows is an array with `count` items. It returns an array of strengths, then nil or an array of middles,
---then nil or an array of history variables, with an item for each flow
---@field batch? fun(flows: hinge.section_flows, history: number[]): number[], number[][]?, number[][]?

---plastic flows of a section
---@class hinge.section_flows
---@field count integer
---@field x number[] as in hinge.section_flow
---@field y number[]
---@field N number[]
---@field z number[]
---@field strain number[]
---@field at_end boolean of all of them

---plastic flow of a section in a step
---@class hinge.section_flow
---@field x number plastic rotation about the section's x axis, rad; the sign is that of Mx
---@field y number about y, rad
---@field N number plastic elongation, m
---@field z number plastic twist, rad
---growth of the mean plastic strain of the part of the element that yields with the section (half of its length; with
---the conventional formulation all of it): plastic work at the full strength over N0 times that length
---@field strain number
---@field at_end boolean true at the two ends of the member; false within it, where two of its elements meet

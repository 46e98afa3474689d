---@meta
-- Grids ---------------------------------------------------------------------------------------------------------------

---@class hinge
local hinge = {}

---A frame by the lines of its plan and by its storeys. It makes a node where the lines meet at each level. Column lines
---are called A, B, ... along x and 1, 2, ... along y, and level 0 is the base: "B2, storey 1", "B2, base". A node that
---the model has at such a place already is used.
---```lua
---local grid = hinge.grid { model = hinge.model(), x = { 0, 6, 12 }, y = { 0, 5 }, z = { 0, 4, 7.5 } }
---grid:fix "all"
---grid:defaults { section = square, material = steel }
---grid:columns { group = "columns" }
---grid:beams { along = "x", group = "beams" }
---print(grid:node("B2", 1).z) -- 4
---```
---@param options hinge.grid_options
---@return hinge.grid
function hinge.grid(options) end

---@class hinge.grid_options
---@field model hinge.model
---m, positions that rise; or { count = spaces, spacing = m, from = m (default 0) }
---@field x number[]|hinge.grid_spacing
---@field y? number[]|hinge.grid_spacing default: { 0 }, a plane frame
---@field z number[]|hinge.grid_spacing m, levels: the base and the storeys

---@class hinge.grid_spacing
---@field count integer
---@field spacing number m
---@field from? number m, default 0

---@class hinge.grid
---@field model hinge.model
---@field storeys integer number of storeys
local grid = {}

---The node at a place: "B2, storey 1", "B2, base", or a line and a storey.
---```lua
---print(plan:node "A1, base" == plan:node("A1", 0)) -- true
---```
---@param place string
---@param storey? integer 0: the base
---@return hinge.node
function grid:node(place, storey) end

---The name of a node of the grid.
---```lua
---print(plan:name(plan:node("B1", 1))) -- B1, storey 1
---```
---@param node hinge.node
---@return string
function grid:name(node) end

---The names of the column lines.
---```lua
---print(#plan:lines()) -- 2
---```
---@return string[]
function grid:lines() end

---Fixes all nodes of a level, as model:fix does.
---```lua
---plan:fix "all"
---plan:fix("y", 1)
---```
---@param what string
---@param storey? integer default 0: the base
---@return hinge.grid self
function grid:fix(what, storey) end

---What members of the grid have where the call that makes them does not give it. With `group`: members whose first
---group it is; these go before those without.
---```lua
---plan:defaults { material = steel, elements = 4 }
---plan:defaults { group = "columns", section = square, up = { 1, 0, 0 } }
---```
---@param options hinge.grid_members
---@return hinge.grid self
function grid:defaults(options) end

---Fields of model:member, each of them optional here.
---@class hinge.grid_members
---@field section? hinge.section
---@field material? hinge.material
---@field up? vec3
---@field group? string|hinge.group|(string|hinge.group)[]
---@field elements? integer|"auto"
---@field backbone? hinge.backbone|fun(largest: number, x: number, y: number, work: number): number
---@field law? hinge.section_law|fun(flow: hinge.section_flow, history: number[]): number, number[]?, number[]?
---@field carries? "both"|"tension"|"compression"
---@field ends? { a?: hinge.joint, b?: hinge.joint }
---@field release? { a?: string|string[], b?: string|string[] }
---@field offset? { a?: vec3, b?: vec3 }

---Columns between the levels, storey by storey.
---```lua
---plan:columns { section = square, material = steel, at = { "A1" }, storeys = { 1 } }
---```
---@param options hinge.grid_columns
---@return hinge.member[]
function grid:columns(options) end

---@class hinge.grid_columns
---@field at? string[] column lines; default: all
---@field storeys? integer[] default: all
---@field section? hinge.section
---@field material? hinge.material
---@field up? vec3
---@field group? string|hinge.group|(string|hinge.group)[]
---@field elements? integer|"auto"
---@field backbone? hinge.backbone|fun(largest: number, x: number, y: number, work: number): number
---@field law? hinge.section_law|fun(flow: hinge.section_flow, history: number[]): number, number[]?, number[]?
---@field carries? "both"|"tension"|"compression"
---@field ends? { a?: hinge.joint, b?: hinge.joint }
---@field release? { a?: string|string[], b?: string|string[] }
---@field offset? { a?: vec3, b?: vec3 }

---Beams between neighbouring columns at the top of storeys.
---```lua
---plan:beams { along = "x", section = square, material = steel, at = { "1" } }
---```
---@param options hinge.grid_beams
---@return hinge.member[]
function grid:beams(options) end

---@class hinge.grid_beams
---@field along "x"|"y"
---lines of the plan: "1", "2", ... for beams along x, "A", "B", ... for those along y; default: all
---@field at? string[]
---@field storeys? integer[] default: all
---@field section? hinge.section
---@field material? hinge.material
---@field up? vec3
---@field group? string|hinge.group|(string|hinge.group)[]
---@field elements? integer|"auto"
---@field backbone? hinge.backbone|fun(largest: number, x: number, y: number, work: number): number
---@field law? hinge.section_law|fun(flow: hinge.section_flow, history: number[]): number, number[]?, number[]?
---@field carries? "both"|"tension"|"compression"
---@field ends? { a?: hinge.joint, b?: hinge.joint }
---@field release? { a?: string|string[], b?: string|string[] }
---@field offset? { a?: vec3, b?: vec3 }

---Braces between two column lines, in each storey: "/" from the foot of the first line to the head of the second, "\\"
---the other way, "X" both, which do not meet.
---```lua
---plan:braces { from = "A1", to = "B1", shape = "X", section = square, material = steel, carries = "tension" }
---```
---@param options hinge.grid_braces
---@return hinge.member[]
function grid:braces(options) end

---@class hinge.grid_braces
---@field from string a column line
---@field to string another one
---@field shape? "/"|"\\"|"X" default "/"
---@field storeys? integer[] default: all
---@field section? hinge.section
---@field material? hinge.material
---@field up? vec3
---@field group? string|hinge.group|(string|hinge.group)[]
---@field elements? integer|"auto"
---@field backbone? hinge.backbone|fun(largest: number, x: number, y: number, work: number): number
---@field law? hinge.section_law|fun(flow: hinge.section_flow, history: number[]): number, number[]?, number[]?
---@field carries? "both"|"tension"|"compression"
---@field ends? { a?: hinge.joint, b?: hinge.joint }
---@field release? { a?: string|string[], b?: string|string[] }
---@field offset? { a?: vec3, b?: vec3 }

---Floors in the plan of storeys, as model:floor.
---```lua
---local lines = hinge.grid { model = hinge.model(), x = { 0, 6, 12 }, y = { 0, 5 }, z = { 0, 3, 6 } }
---lines:defaults { section = square, material = steel }
---lines:beams { along = "x" }
---lines:beams { along = "y" }
---lines:floor { mass = 450, storeys = { 1 }, cells = { "A1-B2" } }
---```
---@param options hinge.grid_floor
---@return hinge.floor
function grid:floor(options) end

---@class hinge.grid_floor
---@field load? number|table<string, number> Pa; see hinge.floor_options, as for the fields below
---@field mass? number kg/m^2
---@field span? "two way"|"one way"|vec3
---@field direction? vec3
---@field case? hinge.case|string
---@field history? fun(time: number): number|number[][]
---@field members? hinge.member[]
---@field group? hinge.group|string
---@field storeys? integer[] default all
---each by two opposite corners, such as "A1-C2"; default the whole plan
---@field cells? string[]

---Members through several nodes, one after the other: nodes, or names of places, and what the members have.
---```lua
---plan:line { "A1, base", "A1, storey 1", "B1, storey 1", section = square, material = steel }
---```
---@param options hinge.grid_members
---@return hinge.member[]
function grid:line(options) end

---Copies members to another place, or as in a mirror. Nodes that are there are used; new ones are fixed as theirs are.
---The copy has their section, material, groups, elements, backbone and direction, where it is not given another.
---```lua
---local bay = plan:columns { section = square, material = steel }
---plan:copy { members = bay, by = { 0, 5, 0 } }
---plan:copy { members = bay, mirror = { x = 20 }, group = "other half" }
---```
---@param options hinge.grid_copy
---@return hinge.member[]
function grid:copy(options) end

---@class hinge.grid_copy
---@field members hinge.member[]
---@field by? vec3 m; one of by and mirror
---@field mirror? { x?: number, y?: number, z?: number } m, the plane of the mirror: one of the three
---@field section? hinge.section
---@field material? hinge.material
---@field up? vec3
---@field group? string|hinge.group|(string|hinge.group)[]
---@field elements? integer|"auto"
---@field backbone? hinge.backbone|fun(largest: number, x: number, y: number, work: number): number
---@field law? hinge.section_law|fun(flow: hinge.section_flow, history: number[]): number, number[]?, number[]?
---@field carries? "both"|"tension"|"compression"
---@field ends? { a?: hinge.joint, b?: hinge.joint }
---@field release? { a?: string|string[], b?: string|string[] }
---@field offset? { a?: vec3, b?: vec3 }

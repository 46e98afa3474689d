-- Wrong calls, message by message: each raises at the script's own line, says what is wrong and what is allowed, and
-- leaves the model as it was.
--
-- Run: lua5.4 tests/script/model/errors_test.lua, with the module on LUA_CPATH;
--      or hinge run tests/script/model/errors_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local support = require "support"
local checks = support.checks "errors"
local case = checks.case

local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
local nan = 0 / 0

-- A cantilever with a load at its tip; `twin` is a node where the tip is, `far` one beside them.
local function cantilever()
  local model = hinge.model { displacement = "small" }
  local wall, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:fix(wall, "all")
  local member = model:member { wall, tip, section = bar, material = steel, up = { 0, 0, 1 }, group = "arms" }
  model:load { node = tip, force = { 0, 0, -1000 } }
  return { model = model, wall = wall, tip = tip, member = member, twin = model:node { 1, 0, 0 },
    far = model:node { 2, 0, 0 } }
end
local function solved(s) return s.model:static { steps = 1 }:finish().hash end
local reference = solved(cantilever())

local function same(a, b)
  for k, v in pairs(a) do if b[k] ~= v then return false end end
  return true
end

-- One wrong call. `message`: what stands after "file:line: ", with "..." for anything. `prepare(s)` changes the scene
-- before; it returns what makes the model solvable if it is not.
local function wrong(message, call, prepare)
  local s = cantilever()
  local ready, mend = pcall(prepare or function() end, s)
  if not checks.expect(ready, "%s for: %s", tostring(mend), message) then return end
  local before = s.model:counts()
  local ok, failure = pcall(call, s)
  if not checks.expect(not ok, "no complaint; wanted: %s", message) then return end
  local line, text = tostring(failure):match "errors_test%.lua:(%d+): (.*)$"
  local f = debug.getinfo(call, "S")
  line = math.tointeger(line)
  checks.expect(line and line >= f.linedefined and line <= f.lastlinedefined, "not at the script's line: %s",
    tostring(failure))
  checks.expect(support.says(text or "", message), "\n    says   %s\n    wanted %s", text or tostring(failure), message)
  checks.expect(same(before, s.model:counts()), "the model has changed after: %s", message)
  if mend then mend() end
  local solved_again, hash = pcall(solved, s)
  checks.expect(solved_again and (prepare or hash == reference),
    "the model cannot be used after: %s (%s)", message, tostring(hash))
end

local function line_of(text)
  local n = 0
  for line in io.lines(debug.getinfo(1, "S").source:sub(2)) do
    n = n + 1
    if line:find(text .. "$") then return n end
  end
end

case("wrong options of hinge.model are refused", function()
  wrong("hinge.model: field 'formulation' is 'asi_gaus'; ... (did you mean 'asi-gauss'?)",
    function() hinge.model { formulation = "asi_gaus" } end)
  wrong("hinge.model: field 'formulation' is 3; must be a string", function() hinge.model { formulation = 3 } end)
  wrong("hinge.model: field 'mass' is 'cubick'; ... (did you mean 'cubic'?)",
    function() hinge.model { mass = "cubick" } end)
  wrong("hinge.model: field 'mass' is 'cubic'; belongs to formulation 'asi-gauss', ... 'asi' ...",
    function() hinge.model { mass = "cubic", formulation = "asi" } end)
  wrong("model:fracture: a model with mass = 'cubic' cannot break, ... declare it with mass = 'linear'",
    function() hinge.model { mass = "cubic" }:fracture { curvature_x = 0.4 } end)
  wrong("model:dynamic: integrator = 'explicit' lumps masses on the nodes; a model with mass = 'cubic' takes 'newmark'",
    function()
      local model = hinge.model { mass = "cubic" }
      model:member { model:node { 0, 0, 0 }, model:node { 1, 0, 0 },
        section = hinge.section.solid { width = 0.1, depth = 0.1 }, material = hinge.material { E = 1, density = 1 } }
      model:dynamic { integrator = "explicit", dt = "auto", duration = 1 }
    end)
  wrong("hinge.model: field 'displacement' is 'lagre'; ... (did you mean 'large'?)",
    function() hinge.model { displacement = "lagre" } end)
  wrong("hinge.model: field 'shift' is 'hole'; must be one of 'plastic', 'elastic_and_plastic'",
    function() hinge.model { shift = "hole" } end)
  wrong("hinge.model: field 'elements_per_member' is 3; formulation 'asi-gauss' ... needs an even ...",
    function() hinge.model { elements_per_member = 3 } end)
  wrong("hinge.model: field 'elements_per_member' is 2.5; must be a whole number, 1 or above",
    function() hinge.model { elements_per_member = 2.5 } end)
  wrong("hinge.model: field 'elements_per_member' is 0; must be a whole number, 1 or above",
    function() hinge.model { elements_per_member = 0, formulation = "asi" } end)
  wrong("hinge.model: field 'elements_per_member' is not a number (nan); must be a finite number",
    function() hinge.model { elements_per_member = nan } end)
  wrong("hinge.model: field 'plasticity' is 'yes'; must be true or false",
    function() hinge.model { plasticity = "yes" } end)
  wrong("hinge.model: unknown field 'formulaton' (did you mean 'formulation'?)...",
    function() hinge.model { formulaton = "asi" } end)
  wrong("hinge.model: takes a table of options, got 'asi'", function() hinge.model "asi" end)
  wrong("hinge: unknown field 'modle' (did you mean 'model'?)...", function() hinge.modle {} end)
  wrong("model has no field or method 'nod' (did you mean 'node'?)...", function(s) s.model:nod { 0, 0,
    0 } end)
  wrong("model:node: called on a table; write object:method(...) on a hinge.model",
    function(s) s.model.node { 0, 0, 0 } end)
end)

case("wrong nodes and supports are refused", function()
  wrong("model:node: position: component y is not a number (nan); must be finite",
    function(s) s.model:node { 0, nan, 0 } end)
  wrong("model:node: position: component x is inf; must be finite", function(s) s.model:node { 1 / 0, 0, 0 } end)
  wrong("model:node: position: component x is '0'; must be a number in m", function(s) s.model:node { "0", 0, 0 } end)
  wrong("model:node: position: component z is nil; must be a number in m", function(s) s.model:node { 0, 0 } end)
  wrong("model:node: position has 4 items; must be {x, y, z} in m", function(s) s.model:node { 0, 0, 0, 0 } end)
  wrong("model:node: takes one argument, got also 0; several numbers go into one table, { x, y, z }",
    function(s) s.model:node(0, 0, 0) end)
  wrong("model:node: position is 0; must be a table {x, y, z} in m", function(s) s.model:node(0) end)
  wrong("node has no field or method 'posx'...; it has x, y, z, index, fixed, ...", function(s) return s.tip.posx end)
  wrong("model:fix: node is 'wall'; must be a node made by model:node{x, y, z}", function(s) s.model:fix "wall" end)
  wrong("model:fix: node is node 2 of another model; use one of this model",
    function(s) s.model:fix(cantilever().tip) end)
  wrong("model:fix: item 2 is 5; must be a node made by model:node{x, y, z}", function(s) s.model:fix { s.tip, 5 } end)
  wrong("model:fix: what to fix is 'xw'; give \"all\", or letters of \"xyz\" for ...",
    function(s) s.model:fix(s.tip, "xw") end)
  wrong("model:fix: what to fix is 3; give a string such as \"all\" or \"xyz\"", function(s) s.model:fix(s.tip, 3) end)
  wrong("model:fix: what to fix is 'xyx': 'x' is there twice; rotations are \"rx\", \"ry\" and \"rz\"",
    function(s) s.model:fix(s.tip, "xyx") end)
  wrong("model:fix: what to fix is empty; give \"all\", \"xyz\" or the like", function(s) s.model:fix(s.tip, "") end)
end)

case("wrong materials and sections are refused", function()
  wrong("hinge.material: field 'E' is missing; give a number in Pa", function() hinge.material { density = 7850 } end)
  wrong("hinge.material: field 'E' is -2.06e+11 Pa; must be above 0 Pa", function() hinge.material { E = -206e9 } end)
  wrong("hinge.material: field 'E' is not a number (nan); must be a finite number in Pa",
    function() hinge.material { E = nan } end)
  wrong("hinge.material: field 'E' is '206e9'; must be a number in Pa", function() hinge.material { E = "206e9" } end)
  wrong("hinge.material: field 'nu' is 0.7; Poisson's ratio must be above -1 and at most 0.5",
    function() hinge.material { E = 1, nu = 0.7 } end)
  wrong("hinge.material: field 'density' is -1 kg/m^3; must be 0 kg/m^3 or above",
    function() hinge.material { E = 1, density = -1 } end)
  wrong("hinge.material: field 'yield_stress' is 0 Pa; must be above 0 Pa",
    function() hinge.material { E = 1, yield_stress = 0 } end)
  wrong("hinge.material: unknown field 'yeild_stress' (did you mean 'yield_stress'?)...",
    function() hinge.material { E = 1, yeild_stress = 1 } end)
  wrong("material has no field 'yield'...", function() return steel.yield end)
  wrong("hinge.section.general: field 'Ix' is -1 m^4; must be above 0 m^4",
    function() hinge.section.general { area = 1, Ix = -1 } end)
  wrong("hinge.section.general: field 'Iy' is missing; give a number in m^4",
    function() hinge.section.general { area = 1, Ix = 1, J = 1 } end)
  wrong("hinge.section.general: unknown field 'area_' (did you mean 'area'?)...",
    function() hinge.section.general { area_ = 1, Ix = 1, Iy = 1, J = 1 } end)
  wrong("hinge.section.box: field 'width' is -1 m; must be a number above 0 m",
    function() hinge.section.box { width = -1, depth = 1, thickness = 0.1 } end)
  wrong("hinge.section: unknown field 'bxo' (did you mean 'box'?)...", function() hinge.section.bxo {} end)
end)

case("wrong sections of concrete are refused", function()
  local function concrete(change)
    local options = { width = 0.4, depth = 0.4, concrete = 30e6, steel = 500e6,
      bars = { { 0.15, 0.15, diameter = 0.02 }, { -0.15, -0.15, diameter = 0.02 } } }
    for k, v in pairs(change) do options[k] = v end
    return function() hinge.section.concrete(options) end
  end
  wrong("hinge.section.concrete: field 'concrete' is 'C31/37'; must be a number of at least 100000 Pa or ...",
    concrete { concrete = "C31/37" })
  wrong("hinge.section.concrete: field 'steel' is -1 Pa; must be a number of at least 100000 Pa or ...",
    concrete { steel = -1 })
  wrong("hinge.section.concrete: field 'effectiveness' is 1.1; must be a number above 0 and of at most 1",
    concrete { effectiveness = 1.1 })
  wrong("hinge.section.concrete: field 'stiffness' is 'craked'; must be a number above 0 and of at most 2 or ...",
    concrete { stiffness = "craked" })
  wrong("hinge.section.concrete: it has no bars; give 'bars' = { {x, y, diameter = d}, ... } or ...",
    concrete { bars = {} })
  wrong("hinge.section.concrete, bar 1 is {0.1}; must be {x, y, diameter = d}, two numbers in m ...",
    concrete { bars = { { 0.1 } } })
  wrong("hinge.section.concrete, bar 1: give either 'diameter' (m) or 'area' (m^2)", concrete { bars = { { 0, 0 } } })
  wrong("hinge.section.concrete, bar 1: give either 'diameter' (m) or 'area' (m^2); both are given",
    concrete { bars = { { 0, 0, diameter = 0.02, area = 1e-4 } } })
  wrong("hinge.section.concrete, bar 1: unknown field 'diametre' (did you mean 'diameter'?)...",
    concrete { bars = { { 0, 0, diametre = 0.02 } } })
  wrong("hinge.section.concrete, reinforcement, bar 2 at {0.195, 0} m is not within the outline; its radius is 0.01 "
    .. "m, and all of the bar must ...",
    concrete { bars = { { 0, 0, diameter = 0.02 }, { 0.195, 0, diameter = 0.02 } } })
  wrong("hinge.section.concrete, reinforcement, bar 2 at {0.01, 0} m overlaps bar 1; two bars must be apart by the sum "
    .. "of their radii", concrete { bars = { { 0, 0, diameter = 0.02 }, { 0.01, 0, diameter = 0.02 } } })
  wrong("hinge.section.concrete, reinforcement, bar 1: field 'compression' is 20000000 Pa; a bar must be as strong "
    .. "as the concrete it ...", concrete { bar_compression = 20e6 })
  wrong("hinge.section.concrete: field 'reinforcement' is too little; the bars leave less than 0.001 of the "
    .. "strength ...",
    concrete { bars = { { 0, 0, diameter = 0.001 } } })
  wrong("hinge.section.concrete: field 'cover' is missing; give the concrete between the surface and the ...",
    concrete { layers = { { y = "top", count = 2, diameter = 0.02 } } })
  wrong("hinge.section.concrete: field 'cover' is 0.3 m; with bars of 0.02 m it must be below half of ...",
    concrete { cover = 0.3, layers = { { y = "top", count = 2, diameter = 0.02 } } })
  wrong("hinge.section.concrete, layer 1: field 'count' is 1.5; must be a whole number of at least 1",
    concrete { cover = 0.03, layers = { { y = "top", count = 1.5, diameter = 0.02 } } })
  local square = { { corners = { { 0, 0 }, { 0.1, 0 }, { 0.1, 0.1 }, { 0, 0.1 } } } }
  local function general(change)
    local options = { area = 0.01, Ix = 1e-5, Iy = 1e-5, J = 1e-5, outline = square,
      reinforcement = { concrete = 30e6, bars = { { 0.05, 0.05, area = 3e-4, tension = 500e6 } } } }
    for k, v in pairs(change) do options[k] = v or nil end
    return function() hinge.section.general(options) end
  end
  wrong("hinge.section.general: field 'N0' is given beside reinforcement; from which it follows; give one of the two",
    general { N0 = 1 })
  wrong("hinge.section.general: field 'reinforcement' is given; needs the section's shape: give 'outline' as ...",
    general { outline = false })
  wrong("hinge.section.general, reinforcement: field 'bars' is empty; must be a list of bars: { { x, y, area =, ...",
    general { reinforcement = { concrete = 30e6, bars = {} } })
  wrong("model:member: member has a section of concrete, which has its own strengths, and a material with a ...",
    function(s)
    s.model:member { s.wall, s.tip, section = hinge.section.concrete { width = 0.1, depth = 0.1, concrete = 30e6,
      steel = 500e6, bars = { { 0, 0, diameter = 0.01 } } }, material = hinge.material { E = 1, yield_stress = 1 } }
  end)
  wrong("section:plastic_moments: N is 1e+99; must be a number from ...", function()
    hinge.section.concrete { width = 0.1, depth = 0.1, concrete = 30e6, steel = 500e6,
      bars = { { 0, 0, diameter = 0.01 } } }:plastic_moments(1e99)
  end)
end)

case("wrong members are refused", function()
  wrong("model:member: member has length 0 m: nodes 2 and 3 are both at {1, 0, 0} m; a member needs a length above 0 m",
    function(s) s.model:member { s.tip, s.twin, section = bar, material = steel } end)
  wrong("model:member: member joins node 2 to itself; its two nodes must differ",
    function(s) s.model:member { s.tip, s.tip, section = bar, material = steel } end)
  wrong("model:member: node [2] is nil; must be a node made by model:node{x, y, z}",
    function(s) s.model:member { s.tip, section = bar, material = steel } end)
  wrong("model:member: node [2] is a table; must be a node made by model:node{x, y, z}",
    function(s) s.model:member { s.tip, { 1, 1, 1 }, section = bar, material = steel } end)
  wrong("model:member: node [1] is node 2 of another model; use one of this model",
    function(s) s.model:member { cantilever().tip, s.tip, section = bar, material = steel } end)
  wrong("model:member: field 'section' is missing; give hinge.section.named 'HEB 300' or the like, ...",
    function(s) s.model:member { s.tip, s.far, material = steel } end)
  wrong("model:member: unknown field 'sectoin' (did you mean 'section'?)...",
    function(s) s.model:member { s.tip, s.far, sectoin = bar, material = steel, group = "new" } end)
  wrong("model:member: field 'section' is a hinge.material; give hinge.section.named...",
    function(s) s.model:member { s.tip, s.far, section = steel, material = bar } end)
  wrong("model:member: field 'material' is missing; give hinge.material.steel 'S355' or the like, ...",
    function(s) s.model:member { s.tip, s.far, section = bar } end)
  wrong("model:member: up is {2, 0, 0}, parallel to the member ({1, 0, 0} m); ... must point across the member",
    function(s) s.model:member { s.tip, s.far, section = bar, material = steel, up = { 2, 0, 0 } } end)
  wrong("model:member: field 'up': component z is not a number (nan); must be finite",
    function(s) s.model:member { s.tip, s.far, section = bar, material = steel, up = { 0, 0, nan } } end)
  wrong("model:member: elements per member is 3; formulation 'asi-gauss' ... needs an even ...",
    function(s) s.model:member { s.tip, s.far, section = bar, material = steel, elements = 3, group = "new" } end)
  wrong("model:member: field 'elements' is -1; must be a whole number, 1 or above",
    function(s) s.model:member { s.tip, s.far, section = bar, material = steel, elements = -1 } end)
  wrong("model:member: field 'group' is 5; must be a name, or a table of names",
    function(s) s.model:member { s.tip, s.far, section = bar, material = steel, group = { "new", 5 } } end)
  wrong("model:member: field 'carries' is 'tensile'; ... (did you mean 'tension'?)",
    function(s) s.model:member { s.tip, s.far, section = bar, material = steel, carries = "tensile" } end)
  wrong("model:member: carries is 'tension', and its material has hardening; a member that carries axial force of "
    .. "one sign ...",
    function(s)
      local hardens = hinge.material { E = 2e11, yield_stress = 2e8, hardening = { modulus = 1e9 } }
      s.model:member { s.tip, s.far, section = bar, material = hardens, carries = "tension", group = "new" }
    end)
  wrong("model:member: item [3] is not expected", function(s)
    s.model:member { s.tip, s.far, s.wall, section = bar, material = steel }
  end)
  -- none of the above made it
  wrong("model:group: name: no group 'new'; the model has 'arms'", function(s) s.model:group "new" end)
  wrong("member has no field or method 'lenght' (did you mean 'length'?)...", function(s) return s.member.lenght end)
end)

case("wrong loads, velocities and rules are refused", function()
  wrong("model:load: field 'node' is node 2 of another model; use one of this model",
    function(s) s.model:load { node = cantilever().tip, force = { 1, 0, 0 } } end)
  wrong("model:load: field 'node' is 'tip'; must be a node made by model:node{x, y, z}",
    function(s) s.model:load { node = "tip", force = { 1, 0, 0 } } end)
  wrong("model:load: field 'force': component x is not a number (nan); must be finite",
    function(s) s.model:load { node = s.tip, force = { nan, 0, 0 } } end)
  wrong("model:load: field 'moment' is 5; must be a table {x, y, z} in N m",
    function(s) s.model:load { node = s.tip, moment = 5 } end)
  wrong("model:load: neither 'force' (N) nor 'moment' (N m) is given; give {x, y, z}, or a function of time and the "
    .. "...",
    function(s) s.model:load { node = s.tip } end)
  wrong("model:load: unknown field 'forces' (did you mean 'force'?)...",
    function(s) s.model:load { node = s.tip, forces = { 1, 0, 0 } } end)
  wrong("model:load: field 'history' is 5; must be a function of time (s) or a table of ...",
    function(s) s.model:load { node = s.tip, force = { 1, 0, 0 }, history = 5 } end)
  wrong("model:load: field 'history' is out of order at point 2 (time 0.5 s); times must rise, "
    .. "or be equal where it jumps",
    function(s) s.model:load { node = s.tip, force = { 1, 0, 0 }, history = { { 1, 0 }, { 0.5, 1 } } } end)
  wrong("model:load: field 'history' is wrong at point 1; each point must be {time in s, factor}",
    function(s) s.model:load { node = s.tip, force = { 1, 0, 0 }, history = { { 2 } } } end)
  wrong("model:gravity: acceleration is -9.81; must be a table {x, y, z} in m/s^2",
    function(s) s.model:gravity(-9.81) end)
  wrong("model:velocity: target: no group 'amrs' (did you mean 'arms'?)...",
    function(s) s.model:velocity("amrs", { 1, 0, 0 }) end)
  wrong("model:velocity: target is member 1 of another model; use one of this model",
    function(s) s.model:velocity(cantilever().member, { 1, 0, 0 }) end)
  wrong("model:velocity: velocity is nil; must be a table {x, y, z} in m/s", function(s) s.model:velocity(s.tip) end)
  wrong("model:fracture: no limit is given; give hinge_rotation_x, hinge_rotation_y (rad), ...",
    function(s) s.model:fracture {} end)
  wrong("model:fracture: field 'curvature_x' is -0.4 1/m; must be above 0 1/m",
    function(s) s.model:fracture { curvature_x = -0.4 } end)
  wrong("model:mass: field 'mass' is 0 kg; must be above 0 kg", function(s) s.model:mass { node = s.tip, mass = 0 } end)
  wrong("model:mass: field 'inertia': component y is -2 kg m^2; must be 0 kg m^2 or above",
    function(s) s.model:mass { node = s.tip, mass = 1, inertia = { 1, -2, 3 } } end)
  wrong("model:fracture: unknown field 'curvature' (did you mean 'curvature_x'?)...",
    function(s) s.model:fracture { curvature = 0.4 } end)
  wrong("model:fracture: field 'group': no group 'legs'; the model has 'arms'",
    function(s) s.model:fracture { axial_strain = 0.3, group = "legs" } end)
  wrong("model:fracture: takes a table of limits or a function, got 0.4", function(s) s.model:fracture(0.4) end)
  wrong("model:contact: field 'rule' is 'gaps'; ... (did you mean 'gap'?)",
    function(s) s.model:contact { rule = "gaps" } end)
  wrong("model:contact: field 'binding_time' is -1 s; must be above 0 s",
    function(s) s.model:contact { rule = "gap", binding_time = -1 } end)
  wrong("model:contact: field 'friction' is -0.1; must be 0 or above",
    function(s) s.model:contact { friction = -0.1 } end)
  wrong("model:contact: field 'friction' is given; belongs to rule 'surface'; rule is 'gap'",
    function(s) s.model:contact { rule = "gap", friction = 0.3 } end)
  wrong("model:contact: field 'binding_time' is given; belongs to rule 'gap'; rule is 'surface', the ...",
    function(s) s.model:contact { binding_time = 1e-3 } end)
  wrong("model:contact: unknown field 'bindingtime' (did you mean 'binding_time'?)...",
    function(s) s.model:contact { bindingtime = 1 } end)
  wrong("model:contact: field 'groups', item 1: no group 'legs'; the model has 'arms'",
    function(s) s.model:contact { groups = { "legs" } } end)
end)

-- Statics -------------------------------------------------------------------------------------------------------------

local function without_supports(s)
  s.model = hinge.model()
  local a, b = s.model:node { 0, 0, 0 }, s.model:node { 1, 0, 0 }
  s.model:member { a, b, section = bar, material = steel }
  return function() s.model:fix(a) end
end
local function loose_part(s)
  local a, b = s.model:node { 0, 5, 0 }, s.model:node { 1, 5, 0 }
  s.model:member { a, b, section = bar, material = steel }
  return function() s.model:fix(b) end
end
local function free_to_roll(s)
  s.model = hinge.model()
  local a, b = s.model:node { 0, 0, 0 }, s.model:node { 1, 0, 0 }
  s.model:fix(a, "xyz")
  s.model:fix(b, "yz")
  s.model:member { a, b, section = bar, material = steel }
  return function() s.model:fix(b, "rx") end
end
case("wrong statics is refused, and a model that can move freely", function()
  wrong("model:static: ... can ... without resistance: the model has no supports, so it can move as a rigid body; "
    .. "statics needs supports that stop every ...",
    function(s) s.model:static {} end, without_supports)
  wrong("model:static: ... m can ... without resistance: the structure, or a part of it, "
    .. "is a mechanism or not supported against it; ...",
    function(s) s.model:static {} end, loose_part)
  wrong("model:static: a mechanism: what is supported at node 1 at {0, 0, 0} m and 1 more node can rotate about x "
    .. "through that node without resistance; ...", function(s) s.model:static {} end, free_to_roll)
  wrong("model:static: the model has no members; add at least one with model:member",
    function() hinge.model():static {} end)
  wrong("model:static: a load acts on node 4 at {2, 0, 0} m, which belongs to no member; put the load on the node ...",
    function(s) s.model:static {} end, function(s)
      s.model:load { node = s.far, force = { 1, 0, 0 } }
      return function() s.model:member { s.tip, s.far, section = bar, material = steel } end
    end)
  wrong("model:static: field 'steps' is 0; must be a whole number, 1 or above",
    function(s) s.model:static { steps = 0 } end)
  wrong("model:static: unknown field 'stpes' (did you mean 'steps'?)...", function(s) s.model:static { stpes = 1 } end)
  wrong("model:static: field 'control' is 'ark'; ... (did you mean 'arc'?)",
    function(s) s.model:static { control = "ark" } end)
  wrong("model:static, control: component is 'up'; must be one of 'ux', 'uy', 'uz', 'rx', 'ry', ...",
    function(s) s.model:static { control = { node = s.tip, "up", to = 1 } } end)
  wrong("model:static, control: field 'to' is missing; give a number in m",
    function(s) s.model:static { control = { node = s.tip, "uz" } } end)
  wrong("model:static, control: field 'to' is 0; must differ from 0",
    function(s) s.model:static { control = { node = s.tip, "uz", to = 0 } } end)
  wrong("model:static, control: 'uz' of node 1 is fixed by a support and cannot be driven",
    function(s) s.model:static { control = { node = s.wall, "uz", to = 1 } } end)
  wrong("model:static: field 'fixed_group': no group 'amrs' (did you mean 'arms'?)...",
    function(s) s.model:static { fixed_group = "amrs" } end)
  wrong("model:static: field 'from' is a hinge.model; must be a run, whose state this one goes on from",
    function(s) s.model:static { from = s.model } end)
end)

case("wrong dynamics is refused", function()
  wrong("model:dynamic: field 'dt' is missing; give a number in s", function(s) s.model:dynamic { duration = 1 } end)
  wrong("model:dynamic: field 'dt' is -1e-05 s; must be above 0 s",
    function(s) s.model:dynamic { dt = -1e-5, duration = 1 } end)
  wrong("model:dynamic: field 'dt' is not a number (nan); must be a finite number in s",
    function(s) s.model:dynamic { dt = nan, duration = 1 } end)
  wrong("model:dynamic: field 'duration' is 1e-05 s; must be at least one step, dt = 0.001 s",
    function(s) s.model:dynamic { dt = 1e-3, duration = 1e-5 } end)
  wrong("model:dynamic: unknown field 'durration' (did you mean 'duration'?)...",
    function(s) s.model:dynamic { dt = 1e-3, durration = 1 } end)
  wrong("model:dynamic: field 'beta' is 2; Newmark's beta must be between 0 and 1 ...",
    function(s) s.model:dynamic { dt = 1e-3, duration = 1, beta = 2 } end)
  local explicit = "integrator = 'explicit', which solves nothing; leave it out"
  wrong("model:dynamic: field 'dt' is 0.001 s; explicit steps stay stable up to ...",
    function(s) s.model:dynamic { integrator = "explicit", dt = 1e-3, duration = 1 } end)
  wrong("model:dynamic: field 'dt' is missing; give a number in s", function(s)
    s.model:dynamic { integrator = "explicit", duration = 1 }
  end)
  wrong("model:dynamic: field 'dt' is 'atuo'; ... (did you mean 'auto'?)",
    function(s) s.model:dynamic { dt = "atuo", duration = 1 } end)
  wrong("model:dynamic: field 'beta' has no meaning with " .. explicit,
    function(s) s.model:dynamic { integrator = "explicit", dt = "auto", duration = 1, beta = 0.25 } end)
  wrong("model:dynamic: field 'solver' has no meaning with " .. explicit,
    function(s) s.model:dynamic { integrator = "explicit", dt = "auto", duration = 1, solver = "direct" } end)
  wrong("model:dynamic: field 'precision' has no meaning with " .. explicit,
    function(s) s.model:dynamic { integrator = "explicit", dt = "auto", duration = 1, precision = "double" } end)
  wrong("model:dynamic: field 'integrator' is 'explict'; ... (did you mean 'explicit'?)",
    function(s) s.model:dynamic { integrator = "explict", dt = 1e-5, duration = 1 } end)
  wrong("model:dynamic: field 'rho_infinity' is 1.5; must be between 0 and 1: what a step leaves of ...",
    function(s) s.model:dynamic { dt = 1e-5, duration = 1, rho_infinity = 1.5 } end)
  wrong("model:dynamic: beta and rho_infinity are both given; rho_infinity sets beta = 0.3086419753: leave ...",
    function(s) s.model:dynamic { dt = 1e-5, duration = 1, rho_infinity = 0.8, beta = 0.4 } end)
  wrong(
    "model:dynamic: field 'rho_infinity' has no meaning with integrator = 'explicit', which solves nothing; leave it "
    .. "out",
    function(s) s.model:dynamic { integrator = "explicit", dt = "auto", duration = 1, rho_infinity = 0.8 } end)
  wrong("model:dynamic: field 'step_control' is 1; must be below 1: the part of the largest energy ...",
    function(s) s.model:dynamic { dt = 1e-5, duration = 1, step_control = 1 } end)
  wrong("model:dynamic: field 'step_control' needs an energy balance that closes, "
    .. "and that of a model with shift = 'elastic_and_plastic' cannot; leave it out",
    function()
      local model = hinge.model { shift = "elastic_and_plastic" }
      model:member { model:node { 0, 0, 0 }, model:node { 1, 0, 0 },
        section = hinge.section.solid { width = 0.1, depth = 0.1 }, material = hinge.material { E = 1, density = 1 } }
      model:dynamic { dt = 1e-3, duration = 1, step_control = 0.01 }
    end)
  wrong("model:dynamic: field 'step_control' is -1; must be 0 or above", function(s)
    s.model:dynamic { dt = 1e-5, duration = 1, step_control = -1 }
  end)
  wrong("model:dynamic: field 'beta' is 0; must be above 0", function(s)
    s.model:dynamic { dt = 1e-5, duration = 1, beta = 0 }
  end)
  wrong("model:dynamic: field 'threads' is 0; must be a whole number, 1 or above",
    function(s) s.model:dynamic { dt = 1e-5, duration = 1, threads = 0 } end)
  wrong("model:dynamic: field 'threads' is 1000; must be at most 256", function(s)
    s.model:dynamic { dt = 1e-5, duration = 1, threads = 1000 }
  end)
  wrong("model:dynamic: field 'precision' is 'singel'; ... (did you mean 'single'?)",
    function(s) s.model:dynamic { dt = 1e-5, duration = 1, precision = "singel" } end)
  wrong("model:dynamic: field 'solver' is 'lu'; must be one of 'cg', 'direct'...",
    function(s) s.model:dynamic { dt = 1e-3, duration = 1, solver = "lu" } end)
  wrong("model:dynamic: field 'internals': field 'predictor' is 'acceleraton'; ... (did you mean 'acceleration'?)",
    function(s) s.model:dynamic { dt = 1e-3, duration = 1, internals = { predictor = "acceleraton" } } end)
  wrong("model:dynamic: member 2 has density 0 kg/m^3; integrator = 'explicit' needs a mass at each ...",
    function(s) s.model:dynamic { dt = 1e-3, duration = 1, integrator = "explicit" } end,
    function(s) s.model:member { s.tip, s.far, section = bar, material = hinge.material { E = 206e9 } } end)
  wrong("model:dynamic: field 'from' is a run of a structure with 5 nodes and 2 elements; this model has 6 and 4; "
    .. "add nothing between the ...",
    function(s) s.model:dynamic { dt = 1e-3, duration = 1, from = s.run } end,
    function(s) s.run = s.model:static {}:finish() s.model:member { s.tip, s.far, section = bar, material = steel } end)
  wrong("model:dynamic: field 'from' is a run of another model; must be a run of this one",
    function(s) s.model:dynamic { dt = 1e-3, duration = 1, from = cantilever().model:static {} } end)
  -- the tip breaks off under its load
  wrong("model:dynamic: a load acts on node 2 at {1, 0, 0} m, which has no element left",
    function(s) s.model:dynamic { dt = 1e-5, duration = 1e-3, from = s.run } end,
    function(s)
      s.model:fracture(function(section) return section.element == 2 and section["end"] == 2 end)
      s.run = s.model:dynamic { dt = 1e-5, duration = 5e-5 }:finish()
      checks.equal(s.run:count { state = "broken" }, 1, "members broken by a script's rule")
    end)
end)

-- Runs ----------------------------------------------------------------------------------------------------------------

local function with_run(s) s.run = s.model:static { steps = 1 } end
case("wrong calls of a run are refused", function()
  wrong("run:displacement: node is node 2 of another model; use one of this model",
    function(s) s.run:displacement(cantilever().tip) end, with_run)
  wrong("run:velocity: node is node 5, declared after this run was made", function(s) s.run:velocity(s.late) end,
    function(s) with_run(s) s.late = s.model:node { 5, 5, 5 } end)
  wrong("run:probe: quantity is 'uq'; must be one of ux uy uz rx ry rz ...",
    function(s) s.run:probe { node = s.tip, "uq" } end, with_run)
  wrong("run:probe: field 'name' is 'a,b'; it heads a column of history.csv and may not ...",
    function(s) s.run:probe { node = s.tip, "ux", name = "a,b" } end, with_run)
  wrong("run:probe: the run has begun (step 1); ask for probes before its first step",
    function(s) s.run:probe { node = s.tip, "ux" } end, function(s) with_run(s) s.run:finish() end)
  wrong("probe has no field or method 'lsat' (did you mean 'last'?)...", function(s) return s.probe.lsat end,
    function(s) with_run(s) s.probe = s.run:probe { node = s.tip, "ux" } end)
  wrong("run:count: field 'state' is missing; must be one of 'broken', 'yielded', 'elastic', ...",
    function(s) s.run:count {} end, with_run)
  wrong("run:count: field 'state' is 'borken'; ... (did you mean 'broken'?)",
    function(s) s.run:count { state = "borken" } end, with_run)
  wrong("run:count: field 'group': no group 'amrs' (did you mean 'arms'?)...",
    function(s) s.run:count { state = "broken", group = "amrs" } end, with_run)
  wrong("run:forces: member is 5; must be a member made by model:member{a, b, ...}",
    function(s) s.run:forces(5) end, with_run)
  wrong("run:forces: member is member 1 of another model; use one of this model",
    function(s) s.run:forces(cantilever().member) end, with_run)
  wrong("run:forces: member is member 2, declared after this run was made", function(s) s.run:forces(s.late) end,
    function(s) with_run(s) s.late = s.model:member { s.tip, s.far, section = bar, material = steel } end)
  wrong("run:read: quantity is 'fy'; ... (did you mean 'f_y'?)",
    function(s) s.run:read "fy" end, with_run)
  wrong("run has no field or method 'vrdict' (did you mean 'verdict'?)...",
    function(s) return s.run.vrdict end, with_run)
  wrong("run:finish: called on nil; write object:method(...) on a hinge.run", function(s) s.run.finish() end, with_run)
end)

-- Handles -------------------------------------------------------------------------------------------------------------

case("handles of another model are refused by every call that takes one", function()
  -- Of another model: refused by everything that takes one.
  local other = cantilever()
  other.group, other.run = other.model:group "arms", other.model:static {}
  wrong("model:fix: item 1 is node 2 of another model; use one of this model", function(s) s.model:fix {
    other.tip } end)
  wrong("model:member: field 'group' is group 'arms' of another model; use one of this model",
    function(s) s.model:member { s.tip, s.far, section = bar, material = steel, group = { "arms", other.group } } end)
  wrong("model:velocity: target is group 'arms' of another model; use one of this model",
    function(s) s.model:velocity(other.group, { 1, 0, 0 }) end)
  wrong("model:fracture: field 'group' is group 'arms' of another model; use one of this model",
    function(s) s.model:fracture { curvature_x = 1, group = other.group } end)
  wrong("model:contact: field 'groups', item 1 is group 'arms' of another model; use one of this model",
    function(s) s.model:contact { groups = { other.group } } end)
  wrong("model:group: name is group 'arms' of another model; use one of this model",
    function(s) s.model:group(other.group) end)
  wrong("model:static: field 'fixed_group' is group 'arms' of another model; use one of this model",
    function(s) s.model:static { fixed_group = other.group } end)
  wrong("model:static, control: field 'node' is node 2 of another model; use one of this model",
    function(s) s.model:static { control = { node = other.tip, "uz", to = 1 } } end)
  wrong("run:probe: field 'node' is node 2 of another model; use one of this model",
    function(s) s.run:probe { node = other.tip, "ux" } end, with_run)
  wrong("run:count: field 'group' is group 'arms' of another model; use one of this model",
    function(s) s.run:count { state = "broken", group = other.group } end, with_run)
  wrong("run:read: group is group 'arms' of another model; use one of this model",
    function(s) s.run:read("N", other.group) end, with_run)
  wrong("run:state: member is member 1 of another model; use one of this model",
    function(s) s.run:state(other.member) end, with_run)
  wrong("node:displacement: run is the run made at ...errors_test.lua:..., of another model; use one of this model",
    function(s) s.tip:displacement(other.run) end, with_run)
  wrong("member:forces: run is the run made at ...errors_test.lua:..., of another model; use one of this model",
    function(s) s.member:forces(other.run) end, with_run)
end)

case("handles are refused where there is nothing to read", function()
  -- What they are read for.
  wrong("node:displacement: no run has been made of this model yet; make one with model:static{} or model:dynamic{}",
    function(s) s.tip:displacement() end)
  wrong("node:reaction: no run has been made of this model yet; ...", function(s) s.wall:reaction() end)
  wrong("member:state: no run has been made of this model yet; ...", function(s) s.member:state() end)
  wrong("node:velocity: run is 3; must be one that model:static{} or ...",
    function(s) s.tip:velocity(3) end, with_run)
  wrong("node:position: this is node 5, declared after this run was made", function(s) s.late:position() end,
    function(s) with_run(s) s.late = s.model:node { 5, 5, 5 } end)
  wrong("member:forces: this is member 2, declared after this run was made", function(s) s.late:forces() end,
    function(s) with_run(s) s.late = s.model:member { s.tip, s.far, section = bar, material = steel } end)
  wrong("member:state: called on nil; write object:method(...) on a hinge.member",
    function(s) s.member.state() end, with_run)
  wrong("node has no field or method 'displacment' (did you mean 'displacement'?)...",
    function(s) s.tip:displacment() end)
  wrong("group has no field or method 'member' (did you mean 'members'?)...",
    function(s) s.model:group "arms":member() end)
  wrong("load has no field or method 'forces' (did you mean 'force'?)...",
    function(s) return s.model:loads()[1].forces end)
  wrong("run:read: quantity is 'Nx_a'; ... (did you mean 'N_a'?)",
    function(s) s.run:read "Nx_a" end, with_run)
  wrong("run:read: group: no group 'amrs' (did you mean 'arms'?)...",
    function(s) s.run:read("ux", "amrs") end, with_run)
end)

case("a load that was removed is refused, with the line that removed it", function()
  -- Of what is gone.
  local function with_removed(s)
    s.load = s.model:load { node = s.far, force = { 1, 0, 0 } }
    s.load:remove() -- removed here
  end
  wrong("load:remove: this is the load on node 4, which was removed at ...errors_test.lua:"
    .. line_of "%-%- removed here", function(s) s.load:remove() end, with_removed)
  wrong("load.force: this is the load on node 4, which was removed at ...errors_test.lua:"
    .. line_of "%-%- removed here",
    function(s) return s.load.force end, with_removed)
end)

case("handles of a model that was closed are refused, with the line that closed it", function()
  local closed = cantilever()
  closed.group, closed.load, closed.early = closed.model:group "arms", closed.model:loads()[1], closed.model:static {}
  closed.run = closed.model:dynamic { dt = 1e-5, duration = 1e-4 }
  closed.probe, closed.steps = closed.run:probe { node = closed.tip, "uz" }, closed.run:steps()
  closed.model:close() -- closed here
  local closed_at = "...errors_test.lua:" .. line_of "%-%- closed here"
  local since = " of a model that was closed at " .. closed_at
  wrong("model:node: this is a model that was closed at " .. closed_at, function() closed.model:node { 0, 0, 0 } end)
  wrong("model:close: this is a model that was closed at " .. closed_at, function() closed.model:close() end)
  wrong("node.x: this is node 2" .. since, function() return closed.tip.x end)
  wrong("node:displacement: this is node 2" .. since, function() closed.tip:displacement() end)
  wrong("member:forces: this is member 1" .. since, function() closed.member:forces() end)
  wrong("group:members: this is group 'arms'" .. since, function() closed.group:members() end)
  wrong("#group: this is group 'arms'" .. since, function() return #closed.group end)
  wrong("load:remove: this is the load on node 2" .. since, function() closed.load:remove() end)
  wrong("run.time: this is the run made at ...errors_test.lua:..." .. since, function() return closed.run.time end)
  wrong("run:finish: this is the run made at ...errors_test.lua:..." .. since, function() closed.early:finish() end)
  wrong("run:steps: the run is the run made at ...errors_test.lua:..." .. since, function() closed.steps() end)
  wrong("model:fix: node is node 2" .. since, function(s) s.model:fix(closed.tip) end)
  wrong("model:dynamic: field 'from' is the run made at ...errors_test.lua:..." .. since,
    function(s) s.model:dynamic { dt = 1, duration = 1, from = closed.early } end)
  for handle, text in pairs {
    model = "a model that was closed at " .. closed_at, run = "the run made at ..." .. since, tip = "node 2" .. since,
    member = "member 1" .. since, group = "group 'arms'" .. since, load = "the load on node 2" .. since,
  } do
    checks.expect(support.says(tostring(closed[handle]), text), "tostring of a %s: %s", handle,
      tostring(closed[handle]))
  end
  checks.equal(#closed.probe.value, 1, "values of a probe, after its model was closed")
end)

case("a step is not closed or stepped on from within", function()
  -- From inside a step.
  local function inside(s, call)
    s.model:fracture(call)
    s.run = s.model:dynamic { dt = 1e-5, duration = 1e-4 }
    s.run:finish()
  end
  wrong("model:close: a run of this model is in a step; close it when the step is done (fracture rule ...",
    function(s) inside(s, function() s.model:close() end) end, function() end)
  wrong("run:step: called from a function of this very run, in the middle of a step; it steps on when that is done "
    .. "(fracture rule of ...",
    function(s) inside(s, function() s.run:step() end) end, function() end)
end)

case("wrong scenarios and wrong options of the library's models are refused", function()
  wrong("hinge.scenario: field 'run' is missing; give a function", function() hinge.scenario {} end)
  wrong("hinge.scenario: unknown field 'case' (did you mean 'cases'?)...",
    function() hinge.scenario { case = {}, run = print } end)
  wrong("ten_storey.add: field 'storey' is 0 m; must be a number above 0 m", function(s)
    require "hinge.models.ten_storey".add(s.model, { storey = 0 })
  end)
  wrong("aircraft.add: unknown field 'sizes' (did you mean 'size'?)...",
    function(s) require "hinge.models.aircraft".add(s.model, { sizes = 9 }) end)
end)

-- A script's own function fails in a step: its message arrives with its line, the step is
-- undone, and the run can go on.
local function shaken(fail_at)
  local s, calls = cantilever(), 0
  s.model:load { node = s.tip, force = { 0, 1e5, 0 }, history = function(t) return math.sin(3e4 * t) end }
  s.model:fracture(function(section)
    calls = calls + 1
    if calls == fail_at then return section.nothing.at_all end -- the line that fails
    return math.abs(section.curvature_y) > 0.005
  end)
  s.run = s.model:dynamic { dt = 1e-5, duration = 1e-3 }
  return s
end
case("an error in a script's function takes the step back, and the run can go on from there", function()
  local steady, shaky = shaken(), shaken(50)
  local ok, failure = pcall(shaky.run.finish, shaky.run)
  local said = ("...errors_test.lua:%d: section has no field 'nothing' (fracture rule of ...errors_test.lua:..., "
    .. "element 1 of member 1 (arms), nodes 1-2, end 1) at step 13, t = 0.00013 s; the step was taken back to "
    .. "t = 0.00012 s")
    :format(line_of "%-%- the line that fails")
  checks.expect(not ok and support.says(failure, said), "a hook's error: %s", failure)
  local step = shaky.run.index
  for _ = 1, step do steady.run:step() end
  checks.expect(step > 0 and step < 100 and shaky.run.verdict == "running",
    "the run stands at its last good step, %d", step)
  checks.equal(shaky.run.hash, steady.run.hash, "the state of the last good step")
  shaky.run:finish()
  steady.run:finish()
  checks.equal(shaky.run.hash, steady.run.hash, "the state at the end, after the failed step was repeated")
  checks.equal(shaky.run.energy.work, steady.run.energy.work, "the work, after the failed step was repeated")
  checks.expect(steady.run:count { state = "broken" } == 1, "the rule itself works")
end)

case("a history function that returns no number, or raises no text, is named with its line", function()
  for what, row in pairs {
    ["a history function returned nil"] = { function() end,
      "model:load: the function in field 'history' returned nil at t = 0 s; it must return a finite number" },
    ["raises a table"] = { function() error {} end, "the function raised a value that is not a string" },
  } do
    local s = cantilever()
    s.model:load { node = s.tip, force = { 1, 0, 0 }, history = row[1] }
    local fine, message = pcall(s.model.dynamic, s.model, { dt = 1e-5, duration = 1e-4 })
    local place = "errors_test.lua:" .. debug.getinfo(row[1], "S").linedefined
    checks.expect(not fine and message:find(place .. ": " .. row[2], 1, true), "%s: %s", what, message)
  end
end)

checks.done()

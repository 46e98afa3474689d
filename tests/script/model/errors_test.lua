-- Wrong calls, message by message: each raises at the script's own line, says what is wrong and what is allowed, and
-- leaves the model as it was. That calls refuse fields that they do not know: documents/reference_test.lua.
--
-- Run: lua5.4 tests/script/model/errors_test.lua, with the module on LUA_CPATH;
--      or hinge run tests/script/model/errors_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local support = require "support"
local scenes = require "scenes"
local checks = support.checks "errors"
local case, with = checks.case, scenes.with

local steel, bar = scenes.elastic, scenes.square
local nan = 0 / 0

-- A cantilever with a load at its tip; `twin` is a node where the tip is, `far` one beside them.
local function cantilever()
  local model, tip, member, wall = scenes.cantilever { model = { displacement = "small" },
    member = { up = { 0, 0, 1 }, group = "arms" }, force = { 0, 0, -1000 } }
  return { model = model, wall = wall, tip = tip, member = member, twin = model:node { 1, 0, 0 },
    far = model:node { 2, 0, 0 } }
end
local function solved(s) return s.model:static { steps = 1 }:finish().hash end
local reference = solved(cantilever())
-- Of model:member, which makes a member from the tip to `far`.
local function member(s, options) return with({ s.tip, s.far, section = bar, material = steel }, options) end

local function same(a, b)
  for k, v in pairs(a) do if b[k] ~= v then return false end end
  return true
end

-- Wrong calls: rows of the argument and what the message says of it after `prefix`, and further words of it. Without
-- `call` each row has its own in the place of the argument. The cantilever `s` is left as it was, and can be solved.
local function refused(s, prefix, call, rows)
  local before = s.model:counts()
  for _, row in ipairs(rows) do
    checks.refused({ prefix .. row[2], table.unpack(row, 3) }, call or row[1], call and row[1])
    checks.expect(same(before, s.model:counts()), "the model has changed after: %s", row[2])
  end
  checks.equal(solved(s), reference, "the model after wrong calls")
end

case("wrong options of hinge.model are refused", function()
  local s = cantilever()
  local function light(options)
    local model = hinge.model(options)
    model:member { model:node { 0, 0, 0 }, model:node { 1, 0, 0 }, section = bar,
      material = hinge.material { E = 1, density = 1 } }
    return model
  end
  refused(s, "hinge.model: ", function(options) hinge.model(options) end, {
    { { formulation = "asi_gaus" }, "field 'formulation' is 'asi_gaus'", "did you mean 'asi-gauss'?" },
    { { formulation = 3 }, "field 'formulation' is 3; must be a string" },
    { { mass = "cubick" }, "field 'mass' is 'cubick'", "did you mean 'cubic'?" },
    { { mass = "cubic", formulation = "asi" }, "field 'mass' is 'cubic'; belongs to formulation 'asi-gauss'", "'asi'" },
    { { displacement = "lagre" }, "field 'displacement' is 'lagre'", "did you mean 'large'?" },
    { { shift = "hole" }, "field 'shift' is 'hole'; must be one of 'plastic', 'elastic_and_plastic'" },
    { { elements_per_member = 3 }, "field 'elements_per_member' is 3", "'asi-gauss'", "needs an even" },
    { { elements_per_member = 2.5 }, "field 'elements_per_member' is 2.5; must be a whole number, 1 or above" },
    { { elements_per_member = 0, formulation = "asi" }, "field 'elements_per_member' is 0; must be a whole number" },
    { { elements_per_member = nan }, "field 'elements_per_member' is not a number (nan); must be a finite number" },
    { { plasticity = "yes" }, "field 'plasticity' is 'yes'; must be true or false" },
    { { formulaton = "asi" }, "unknown field 'formulaton' (did you mean 'formulation'?)" },
    { "asi", "takes a table of options, got 'asi'" },
  })
  refused(s, "", nil, {
    { function() hinge.model { mass = "cubic" }:fracture { curvature_x = 0.4 } end,
      "model:fracture: a model with mass = 'cubic' cannot break", "mass = 'linear'" },
    { function() light { mass = "cubic" }:dynamic { integrator = "explicit", dt = "auto", duration = 1 } end,
      "model:dynamic: integrator = 'explicit' lumps masses", "mass = 'cubic' takes 'newmark'" },
    { function() light { shift = "elastic_and_plastic" }:dynamic { dt = 1e-3, duration = 1, step_control = 0.01 } end,
      "model:dynamic: field 'step_control' needs an energy balance", "shift = 'elastic_and_plastic'" },
    { function() hinge.modle {} end, "hinge: unknown field 'modle' (did you mean 'model'?)" },
    { function() s.model:nod { 0, 0, 0 } end, "model has no field or method 'nod' (did you mean 'node'?)" },
    { function() s.model.node { 0, 0, 0 } end, "model:node: called on a table; write object:method(...)" },
  })
end)

case("wrong nodes and supports are refused", function()
  local s = cantilever()
  refused(s, "model:node: ", function(place) s.model:node(place) end, {
    { { 0, nan, 0 }, "position: component y is not a number (nan); must be finite" },
    { { 1 / 0, 0, 0 }, "position: component x is inf; must be finite" },
    { { "0", 0, 0 }, "position: component x is '0'; must be a number in m" },
    { { 0, 0 }, "position: component z is nil; must be a number in m" },
    { { 0, 0, 0, 0 }, "position has 4 items; must be {x, y, z} in m" },
    { 0, "position is 0; must be a table {x, y, z} in m" },
  })
  refused(s, "", nil, {
    { function() s.model:node(0, 0, 0) end, "model:node: takes one argument, got also 0", "{ x, y, z }" },
    { function() return s.tip.posx end, "node has no field or method 'posx'", "it has x, y, z, index, fixed, " },
  })
  refused(s, "model:fix: ", function(a) s.model:fix(table.unpack(a)) end, {
    { { "wall" }, "node is 'wall'; must be a node made by model:node" },
    { { cantilever().tip }, "node is node 2 of another model" },
    { { { s.tip, 5 } }, "item 2 is 5; must be a node made by model:node" },
    { { s.tip, "xw" }, "what to fix is 'xw'; give \"all\", or letters of \"xyz\"" },
    { { s.tip, 3 }, "what to fix is 3; give a string such as \"all\" or \"xyz\"" },
    { { s.tip, "xyx" }, "what to fix is 'xyx': 'x' is there twice", "\"rx\"" },
    { { s.tip, "" }, "what to fix is empty; give \"all\", \"xyz\"" },
  })
end)

case("wrong materials and sections are refused", function()
  local s = cantilever()
  refused(s, "hinge.material: ", function(options) hinge.material(options) end, {
    { { density = 7850 }, "field 'E' is missing; give a number in Pa" },
    { { E = -206e9 }, "field 'E' is -2.06e+11 Pa; must be above 0 Pa" },
    { { E = nan }, "field 'E' is not a number (nan); must be a finite number in Pa" },
    { { E = "206e9" }, "field 'E' is '206e9'; must be a number in Pa" },
    { { E = 1, nu = 0.7 }, "field 'nu' is 0.7; Poisson's ratio must be above -1 and at most 0.5" },
    { { E = 1, density = -1 }, "field 'density' is -1 kg/m^3; must be 0 kg/m^3 or above" },
    { { E = 1, yield_stress = 0 }, "field 'yield_stress' is 0 Pa; must be above 0 Pa" },
  })
  refused(s, "hinge.section.general: ", function(options) hinge.section.general(options) end, {
    { { area = 1, Ix = -1 }, "field 'Ix' is -1 m^4; must be above 0 m^4" },
    { { area = 1, Ix = 1, J = 1 }, "field 'Iy' is missing; give a number in m^4" },
  })
  refused(s, "", nil, {
    { function() return steel.yield end, "material has no field 'yield'" },
    { function() hinge.section.box { width = -1, depth = 1, thickness = 0.1 } end,
      "hinge.section.box: field 'width' is -1 m; must be a number above 0 m" },
    { function() hinge.section.bxo {} end, "hinge.section: unknown field 'bxo' (did you mean 'box'?)" },
  })
end)

case("wrong sections of concrete are refused", function()
  local s = cantilever()
  local middle = { 0, 0, diameter = 0.02 }
  local function top(count) return { { y = "top", count = count, diameter = 0.02 } } end
  refused(s, "hinge.section.concrete", function(change)
    hinge.section.concrete(with({ width = 0.4, depth = 0.4, concrete = 30e6, steel = 500e6,
      bars = { { 0.15, 0.15, diameter = 0.02 }, { -0.15, -0.15, diameter = 0.02 } } }, change))
  end, {
    { { concrete = "C31/37" }, ": field 'concrete' is 'C31/37'; must be a number of at least 100000 Pa or " },
    { { steel = -1 }, ": field 'steel' is -1 Pa; must be a number of at least 100000 Pa or " },
    { { effectiveness = 1.1 }, ": field 'effectiveness' is 1.1; must be a number above 0 and of at most 1" },
    { { stiffness = "craked" }, ": field 'stiffness' is 'craked'; must be a number above 0 and of at most 2 or " },
    { { bars = {} }, ": it has no bars; give 'bars' = { {x, y, diameter = d}, ... }" },
    { { bars = { { 0.1 } } }, ", bar 1 is {0.1}; must be {x, y, diameter = d}, two numbers in m" },
    { { bars = { { 0, 0 } } }, ", bar 1: give either 'diameter' (m) or 'area' (m^2)" },
    { { bars = { { 0, 0, diameter = 0.02, area = 1e-4 } } }, ", bar 1: give either 'diameter'", "both are given" },
    { { bars = { { 0, 0, diametre = 0.02 } } }, ", bar 1: unknown field 'diametre' (did you mean 'diameter'?)" },
    { { bars = { middle, { 0.195, 0, diameter = 0.02 } } },
      ", reinforcement, bar 2 at {0.195, 0} m is not within the outline; its radius is 0.01 m" },
    { { bars = { middle, { 0.01, 0, diameter = 0.02 } } },
      ", reinforcement, bar 2 at {0.01, 0} m overlaps bar 1; two bars must be apart by the sum of their radii" },
    { { bar_compression = 20e6 }, ", reinforcement, bar 1: field 'compression' is 20000000 Pa", "as strong as" },
    { { bars = { { 0, 0, diameter = 0.001 } } }, ": field 'reinforcement' is too little", "less than 0.001" },
    { { layers = top(2) }, ": field 'cover' is missing; give the concrete between the surface and the" },
    { { cover = 0.3, layers = top(2) }, ": field 'cover' is 0.3 m; with bars of 0.02 m it must be below half of" },
    { { cover = 0.03, layers = top(1.5) }, ", layer 1: field 'count' is 1.5; must be a whole number of at least 1" },
  })
  refused(s, "hinge.section.general", function(change)
    local options = with({ area = 0.01, Ix = 1e-5, Iy = 1e-5, J = 1e-5,
      outline = { { corners = { { 0, 0 }, { 0.1, 0 }, { 0.1, 0.1 }, { 0, 0.1 } } } },
      reinforcement = { concrete = 30e6, bars = { { 0.05, 0.05, area = 3e-4, tension = 500e6 } } } }, change)
    options.outline = options.outline or nil
    hinge.section.general(options)
  end, {
    { { N0 = 1 }, ": field 'N0' is given beside reinforcement", "give one of the two" },
    { { outline = false }, ": field 'reinforcement' is given; needs the section's shape: give 'outline'" },
    { { reinforcement = { concrete = 30e6, bars = {} } }, ", reinforcement: field 'bars' is empty; must be a list" },
  })
  local concrete = hinge.section.concrete { width = 0.1, depth = 0.1, concrete = 30e6, steel = 500e6,
    bars = { { 0, 0, diameter = 0.01 } } }
  refused(s, "", nil, {
    { function() s.model:member(member(s, { section = concrete, material = scenes.steel })) end,
      "model:member: member has a section of concrete, which has its own strengths" },
    { function() concrete:plastic_moments(1e99) end, "section:plastic_moments: N is 1e+99; must be a number from " },
  })
end)

case("wrong members are refused", function()
  local s = cantilever()
  refused(s, "model:member: ", function(options) s.model:member(member(s, options)) end, {
    { { s.tip, s.twin }, "member has length 0 m: nodes 2 and 3 are both at {1, 0, 0} m", "above 0 m" },
    { { s.tip, s.tip }, "member joins node 2 to itself; its two nodes must differ" },
    { { s.tip, { 1, 1, 1 } }, "node [2] is a table; must be a node made by model:node" },
    { { cantilever().tip, s.tip }, "node [1] is node 2 of another model; use one of this model" },
    { { [3] = s.wall }, "item [3] is not expected" },
    { { sectoin = bar, group = "new" }, "unknown field 'sectoin' (did you mean 'section'?)" },
    { { section = steel, material = bar }, "field 'section' is a hinge.material; give hinge.section.named" },
    { { up = { 2, 0, 0 } }, "up is {2, 0, 0}, parallel to the member ({1, 0, 0} m)", "must point across the member" },
    { { up = { 0, 0, nan } }, "field 'up': component z is not a number (nan); must be finite" },
    { { elements = 3, group = "new" }, "elements per member is 3; formulation 'asi-gauss'", "needs an even" },
    { { elements = -1 }, "field 'elements' is -1; must be a whole number, 1 or above" },
    { { group = { "new", 5 } }, "field 'group' is 5; must be a name, or a table of names" },
  })
  refused(s, "", nil, {
    { function() s.model:member { s.tip, section = bar, material = steel } end,
      "model:member: node [2] is nil; must be a node made by model:node" },
    { function() s.model:member { s.tip, s.far, material = steel } end,
      "model:member: field 'section' is missing; give hinge.section.named" },
    { function() s.model:member { s.tip, s.far, section = bar } end,
      "model:member: field 'material' is missing; give hinge.material.steel" },
    -- none of the above made it
    { function() s.model:group "new" end, "model:group: name: no group 'new'; the model has 'arms'" },
    { function() return s.member.lenght end, "member has no field or method 'lenght' (did you mean 'length'?)" },
  })
end)

case("wrong loads, velocities and rules are refused", function()
  local s = cantilever()
  refused(s, "model:load: ", function(change)
    s.model:load(with({ node = s.tip, force = { 1, 0, 0 } }, change))
  end, {
    { { node = cantilever().tip }, "field 'node' is node 2 of another model; use one of this model" },
    { { node = "tip" }, "field 'node' is 'tip'; must be a node made by model:node" },
    { { force = { nan, 0, 0 } }, "field 'force': component x is not a number (nan); must be finite" },
    { { moment = 5 }, "field 'moment' is 5; must be a table {x, y, z} in N m" },
    { { history = { { 1, 0 }, { 0.5, 1 } } }, "field 'history' is out of order at point 2 (time 0.5 s); times must "
      .. "rise, or be equal where it jumps" },
    { { history = { { 2 } } }, "field 'history' is wrong at point 1; each point must be {time in s, factor}" },
  })
  refused(s, "model:velocity: ", function(a) s.model:velocity(table.unpack(a)) end, {
    { { "amrs", { 1, 0, 0 } }, "target: no group 'amrs' (did you mean 'arms'?)" },
    { { cantilever().member, { 1, 0, 0 } }, "target is member 1 of another model; use one of this model" },
    { { s.tip }, "velocity is nil; must be a table {x, y, z} in m/s" },
  })
  refused(s, "model:fracture: ", function(options) s.model:fracture(options) end, {
    { {}, "no limit is given; give hinge_rotation_x, hinge_rotation_y (rad)" },
    { { curvature_x = -0.4 }, "field 'curvature_x' is -0.4 1/m; must be above 0 1/m" },
    { { axial_strain = 0.3, group = "legs" }, "field 'group': no group 'legs'; the model has 'arms'" },
    { 0.4, "takes a table of limits or a function, got 0.4" },
  })
  refused(s, "model:contact: ", function(options) s.model:contact(options) end, {
    { { rule = "gaps" }, "field 'rule' is 'gaps'", "did you mean 'gap'?" },
    { { rule = "gap", binding_time = -1 }, "field 'binding_time' is -1 s; must be above 0 s" },
    { { friction = -0.1 }, "field 'friction' is -0.1; must be 0 or above" },
    { { rule = "gap", friction = 0.3 }, "field 'friction' is given; belongs to rule 'surface'; rule is 'gap'" },
    { { binding_time = 1e-3 }, "field 'binding_time' is given; belongs to rule 'gap'; rule is 'surface'" },
    { { groups = { "legs" } }, "field 'groups', item 1: no group 'legs'; the model has 'arms'" },
  })
  refused(s, "model:", nil, {
    { function() s.model:load { node = s.tip } end, "load: neither 'force' (N) nor 'moment' (N m) is given" },
    { function() s.model:gravity(-9.81) end, "gravity: acceleration is -9.81; must be a table {x, y, z} in m/s^2" },
    { function() s.model:mass { node = s.tip, mass = 1, inertia = { 1, -2, 3 } } end,
      "mass: field 'inertia': component y is -2 kg m^2; must be 0 kg m^2 or above" },
  })
end)

-- Statics -------------------------------------------------------------------------------------------------------------

case("a model that can move freely, or has nothing to load, is refused by statics until it is mended", function()
  local function refused_until(mend, s, ...)
    checks.refused({ "model:static: ", ... }, function() s.model:static {} end)
    mend()
    checks.expect(pcall(solved, s), "the model can be used when it is mended: %s", ...)
  end
  local function two_nodes()
    local model = hinge.model()
    local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
    model:member { a, b, section = bar, material = steel }
    return { model = model }, a, b
  end
  local s, a = two_nodes()
  refused_until(function() s.model:fix(a) end, s, "without resistance: the model has no supports, so it can move "
    .. "as a rigid body; statics needs supports")
  local b
  s, a, b = two_nodes()
  s.model:fix(a, "xyz")
  s.model:fix(b, "yz")
  refused_until(function() s.model:fix(b, "rx") end, s, "a mechanism: what is supported at node 1 at {0, 0, 0} m and 1 "
    .. "more node can rotate about x through that node without resistance")
  s = cantilever()
  a, b = s.model:node { 0, 5, 0 }, s.model:node { 1, 5, 0 }
  s.model:member { a, b, section = bar, material = steel }
  refused_until(function() s.model:fix(b) end, s, "without resistance: the structure, or a part of it, is a "
    .. "mechanism or not supported against it")
  s = cantilever()
  s.model:load { node = s.far, force = { 1, 0, 0 } }
  refused_until(function() s.model:member(member(s)) end, s, "a load acts on node 4 at {2, 0, 0} m, which belongs to "
    .. "no member")
end)

case("wrong statics is refused", function()
  local s = cantilever()
  refused(s, "model:static", function(options) s.model:static(options) end, {
    { { steps = 0 }, ": field 'steps' is 0; must be a whole number, 1 or above" },
    { { control = "ark" }, ": field 'control' is 'ark'", "did you mean 'arc'?" },
    { { control = { node = s.tip, "up", to = 1 } }, ", control: component is 'up'; must be one of 'ux', 'uy', 'uz', " },
    { { control = { node = s.tip, "uz" } }, ", control: field 'to' is missing; give a number in m" },
    { { control = { node = s.tip, "uz", to = 0 } }, ", control: field 'to' is 0; must differ from 0" },
    { { control = { node = s.wall, "uz", to = 1 } }, ", control: 'uz' of node 1 is fixed by a support" },
    { { fixed_group = "amrs" }, ": field 'fixed_group': no group 'amrs' (did you mean 'arms'?)" },
    { { from = s.model }, ": field 'from' is a hinge.model; must be a run, whose state this one goes on from" },
  })
  checks.refused("the model has no members; add at least one", function() hinge.model():static {} end)
end)

case("wrong dynamics is refused", function()
  local s = cantilever()
  local explicit = " has no meaning with integrator = 'explicit', which solves nothing; leave it out"
  refused(s, "model:dynamic: ", function(options) s.model:dynamic(options) end, {
    { { duration = 1 }, "field 'dt' is missing; give a number in s" },
    { { integrator = "explicit", duration = 1 }, "field 'dt' is missing; give a number in s" },
  })
  refused(s, "model:dynamic: field ", function(options)
    s.model:dynamic(with({ dt = options.integrator == "explicit" and "auto" or 1e-3, duration = 1 }, options))
  end, {
    { { dt = -1e-5 }, "'dt' is -1e-05 s; must be above 0 s" },
    { { dt = nan }, "'dt' is not a number (nan); must be a finite number in s" },
    { { dt = "atuo" }, "'dt' is 'atuo'", "did you mean 'auto'?" },
    { { dt = 1e-3, integrator = "explicit" }, "'dt' is 0.001 s; explicit steps stay stable up to" },
    { { duration = 1e-5 }, "'duration' is 1e-05 s; must be at least one step, dt = 0.001 s" },
    { { integrator = "explict" }, "'integrator' is 'explict'", "did you mean 'explicit'?" },
    { { integrator = "explicit", beta = 0.25 }, "'beta'" .. explicit },
    { { integrator = "explicit", solver = "direct" }, "'solver'" .. explicit },
    { { integrator = "explicit", precision = "double" }, "'precision'" .. explicit },
    { { integrator = "explicit", rho_infinity = 0.8 }, "'rho_infinity'" .. explicit },
    { { beta = 2 }, "'beta' is 2; Newmark's beta must be between 0 and 1" },
    { { beta = 0 }, "'beta' is 0; must be above 0" },
    { { rho_infinity = 1.5 }, "'rho_infinity' is 1.5; must be between 0 and 1" },
    { { step_control = 1 }, "'step_control' is 1; must be below 1: the part of the largest energy" },
    { { step_control = -1 }, "'step_control' is -1; must be 0 or above" },
    { { threads = 0 }, "'threads' is 0; must be a whole number, 1 or above" },
    { { threads = 1000 }, "'threads' is 1000; must be at most 256" },
    { { threads = "all" }, "'threads' is 'all'; must be a whole number, 1 or above, or 'auto'" },
    { { precision = "singel" }, "'precision' is 'singel'", "did you mean 'single'?" },
    { { solver = "lu" }, "'solver' is 'lu'; must be one of 'cg', 'direct'" },
    { { internals = { predictor = "acceleraton" } }, "'internals': field 'predictor' is 'acceleraton'",
      "did you mean 'acceleration'?" },
    { { from = cantilever().model:static {} }, "'from' is a run of another model; must be a run of this one" },
  })
  checks.refused("beta and rho_infinity are both given; rho_infinity sets beta = 0.3086419753",
    function() s.model:dynamic { dt = 1e-5, duration = 1, rho_infinity = 0.8, beta = 0.4 } end)

  s.model:member(member(s, { material = hinge.material { E = 206e9 } }))
  checks.refused("member 2 has density 0 kg/m^3; integrator = 'explicit' needs a mass at each",
    function() s.model:dynamic { dt = 1e-3, duration = 1, integrator = "explicit" } end)
  s = cantilever()
  s.run = s.model:static {}:finish()
  s.model:member(member(s))
  checks.refused("field 'from' is a run of a structure with 5 nodes and 2 elements; this model has 6 and 4",
    function() s.model:dynamic { dt = 1e-3, duration = 1, from = s.run } end)
  s = cantilever() -- whose tip breaks off under its load
  s.model:fracture(function(section) return section.element == 2 and section["end"] == 2 end)
  s.run = s.model:dynamic { dt = 1e-5, duration = 5e-5 }:finish()
  checks.equal(s.run:count { state = "broken" }, 1, "members broken by a script's rule")
  checks.refused("a load acts on node 2 at {1, 0, 0} m, which has no element left",
    function() s.model:dynamic { dt = 1e-5, duration = 1e-3, from = s.run } end)
end)

-- Runs ----------------------------------------------------------------------------------------------------------------

case("wrong calls of a run are refused", function()
  local s = cantilever()
  s.run = s.model:static { steps = 1 }
  s.probe = s.run:probe { node = s.tip, "ux" }
  refused(s, "", nil, {
    { function() s.run:displacement(cantilever().tip) end, "run:displacement: node is node 2 of another model" },
    { function() s.run:probe { node = s.tip, "uq" } end, "run:probe: quantity is 'uq'; must be one of ux uy uz rx ry" },
    { function() s.run:probe { node = s.tip, "ux", name = "a,b" } end,
      "run:probe: field 'name' is 'a,b'; it heads a column of history.csv and may not" },
    { function() return s.probe.lsat end, "probe has no field or method 'lsat' (did you mean 'last'?)" },
    { function() s.run:count {} end, "run:count: field 'state' is missing; must be one of 'broken', 'yielded'" },
    { function() s.run:count { state = "borken" } end, "run:count: field 'state' is 'borken'", "mean 'broken'?" },
    { function() s.run:count { state = "broken", group = "amrs" } end, "run:count: field 'group': no group 'amrs'" },
    { function() s.run:forces(5) end, "run:forces: member is 5; must be a member made by model:member" },
    { function() s.run:forces(cantilever().member) end, "run:forces: member is member 1 of another model" },
    { function() s.run:read "fy" end, "run:read: quantity is 'fy'", "did you mean 'f_y'?" },
    { function() return s.run.vrdict end, "run has no field or method 'vrdict' (did you mean 'verdict'?)" },
    { function() s.run.finish() end, "run:finish: called on nil; write object:method(...) on a hinge.run" },
  })
  s.run:finish()
  checks.refused("run:probe: the run has begun (step 1); ask for probes before its first step",
    function() s.run:probe { node = s.tip, "ux" } end)
end)

case("a step is not closed or stepped on from within", function()
  for words, call in pairs {
    ["model:close: a run of this model is in a step; close it when the step is done (fracture rule "] =
      function(s) s.model:close() end,
    ["run:step: called from a function of this very run, in the middle of a step; it steps on when that is done "
      .. "(fracture rule of "] = function(s) s.run:step() end,
  } do
    local s = cantilever()
    s.model:fracture(function() call(s) end)
    s.run = s.model:dynamic { dt = 1e-5, duration = 1e-4 }
    local good, message = pcall(s.run.finish, s.run)
    checks.expect(not good and support.has(message, words), "says %s", message)
    checks.expect(tonumber(message:match "errors_test%.lua:(%d+): ") == debug.getinfo(call, "S").linedefined,
      "at the line of the call: %s", message)
    checks.expect(pcall(solved, s), "the model can be used afterwards")
  end
end)

case("wrong scenarios and wrong options of the library's models are refused", function()
  local s = cantilever()
  refused(s, "", nil, {
    { function() hinge.scenario {} end, "hinge.scenario: field 'run' is missing; give a function" },
    { function() require "hinge.models.ten_storey".add(s.model, { storey = 0 }) end,
      "ten_storey.add: field 'storey' is 0 m; must be a number above 0 m" },
  })
end)

-- Its message: hooks_test.lua.
case("a fracture rule that fails takes the step back to the bit, and the run can go on from there", function()
  local function shaken(fail_at)
    local s, calls = cantilever(), 0
    s.model:load { node = s.tip, force = { 0, 1e5, 0 }, history = function(t) return math.sin(3e4 * t) end }
    s.model:fracture(function(section)
      calls = calls + 1
      if calls == fail_at then return section.nothing.at_all end
      return math.abs(section.curvature_y) > 0.005
    end)
    return s.model:dynamic { dt = 1e-5, duration = 1e-3 }
  end
  local steady, shaky = shaken(), shaken(50)
  checks.refused({ "section has no field 'nothing' (fracture rule of ", "element 1 of member 1 (arms), nodes 1-2, end",
    "at step 13, t = 0.00013 s; the step was taken back to t = 0.00012 s" }, shaky.finish, shaky)
  checks.equal(shaky.verdict .. " " .. shaky.index, "running 12", "the run at its last good step")
  for _ = 1, 12 do steady:step() end
  checks.equal(shaky.hash, steady.hash, "the state of the last good step")
  checks.equal(shaky:finish().hash, steady:finish().hash, "the state at the end, after the failed step was repeated")
  checks.equal(shaky.energy.work, steady.energy.work, "the work, after the failed step was repeated")
  checks.equal(steady:count { state = "broken" }, 1, "members broken by the rule")
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

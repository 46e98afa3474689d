-- A checkpoint is refused where any quantity of the script has changed. The changes are generated: each number, word
-- and truth value of the declarations below, one at a time. The list is held against the fields of lua/hinge/words,
-- so that a field that is new there must come here.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "fingerprint"
local case, expect = checks.case, checks.expect
local merged = scenes.with

local file = support.temporary_folder() .. "/a.checkpoint"

-- The scene: a post on the ground, a beam at its head, a second post beside it; more where a declaration needs it.
local function bar() return hinge.section.general { area = 0.01, Ix = 8e-6, Iy = 8e-6, J = 1e-5,
  plastic = { A = 0.01, Zx = 2e-4, Zy = 2e-4, Zz = 2e-4 }, size = { width = 0.1, depth = 0.1 } } end
local function concrete() return hinge.material { E = 30e9, density = 2500 } end
local function steel() return hinge.material { E = 210e9, density = 7850, yield_stress = 355e6 } end

local function scene(o)
  o = o or {}
  local model = hinge.model(o.model or {})
  local n = { model:node { 0, 0, 0 }, model:node { 0, 0, 3 }, model:node { 2, 0, 3 }, model:node { 2, 0, 0 } }
  model:fix { n[1], n[4] }
  local members = {}
  for i = 1, 3 do
    members[i] = model:member(merged({ n[i], n[i + 1], section = o.section or bar(), material = o.material or steel(),
      group = i == 2 and "beam" or "posts" }, i == 1 and o.member))
  end
  return model, n, members
end

-- Options as one of them becomes another word, which has no place for others: without these.
local function without(o, names)
  local rest = {}
  for key, value in pairs(o) do rest[key] = not names:find(key, 1, true) and value or nil end
  return rest
end

-- Subjects: `of`: classes of lua/hinge/words whose fields it has; options: what is changed; build(options) returns the
-- model; other: what a word or a number becomes, by its path, where it is not the usual change. with: options of
-- model:dynamic beside dt and duration.
local subjects = {}
local function subject(name, one)
  one.name = name
  subjects[#subjects + 1] = one
end
local function on_scene(declare)
  return function(o)
    local model, n, members = scene()
    declare(model, o, n, members)
    return model
  end
end
-- A call of the model with the options; with their `of`, "member" or "node", by its number.
local function declared(call, of)
  return on_scene(function(model, o, n, m)
    model[call](model, of and merged(o, { [of] = (of == "node" and n or m)[o[of]] }) or o)
  end)
end

subject("model", { of = { "model_options" },
  options = { p_delta = "member", interaction = "exact", weight = "members", mass = "linear", plasticity = true,
    elements_per_member = 2 },
  other = { p_delta = "chord", interaction = "paper", weight = "nodes", mass = "cubic", elements_per_member = 4 },
  build = function(o) return (scene { model = o }) end })
subject("model without p_delta", { of = { "model_options" },
  options = { formulation = "asi-gauss", displacement = "large", shift = "plastic" },
  other = { formulation = "asi", displacement = "small", shift = "elastic_and_plastic" },
  build = function(o) return (scene { model = merged(o, { p_delta = "chord" }) }) end })
subject("model with shear", { of = { "model_options" }, options = { interaction = "exact" },
  other = { interaction = "exact with shear" },
  build = function(o) return (scene { model = o, section = hinge.section.box { width = 0.2, depth = 0.1,
    thickness = 0.01 } }) end })

subject("nodes", { of = {},
  options = { at = { 5.0, 0.1, 0.2 }, fix = "xyz,rz", linear = { 1.0, 2.0, 3.0 }, angular = { 1.0, 2.0, 3.0 },
    gravity = { 0.1, 0.2, -9.81 } }, other = { fix = "xyz,ry" },
  build = on_scene(function(model, o, n, members)
    local far = model:node(o.at)
    model:fix(far, o.fix)
    model:member { n[3], far, section = bar(), material = steel() }
    model:velocity(members[2], o.linear, o.angular)
    model:gravity(o.gravity)
  end) })

local function of_material(more)
  return function(o) return (scene { material = hinge.material(merged({ E = 210e9 }, more, o)) }) end
end
subject("material", { of = { "material_options", "hardening", "rate" },
  options = { E = 210e9, nu = 0.3, density = 7850.0, yield_stress = 355e6, rate = { D = 40.4, q = 5.0 },
    hardening = { tangent = 2e9, kinematic = 0.5, saturation = 1e8 } }, build = of_material {} })
subject("material by G", { of = { "material_options", "hardening", "rate" },
  options = { G = 80e9, hardening = { modulus = 2e9 }, rate = { C = 0.01, reference = 1e-3 } },
  build = of_material { yield_stress = 355e6, density = 7850 } })
subject("hot material", { of = { "material_options" }, options = { hot_curve = hinge.heat.curve() },
  other = { ["hot_curve.1.3"] = 0.9, ["hot_curve.2.3"] = 0.9 }, -- it is no more than the yield stress
  build = of_material { yield_stress = 355e6, density = 7850 } })

subject("section", { of = { "section_options" },
  options = { area = 0.01, Ix = 8e-6, Iy = 9e-6, J = 1e-5, shear_area_x = 8e-3, shear_area_y = 8e-3, mass_Ix = 8e-6,
    mass_Iy = 9e-6, plastic = { A = 0.01, Zx = 2e-4, Zy = 2e-4, Zz = 2e-4 }, size = { width = 0.1, depth = 0.12 } },
  build = function(o) return (scene { section = hinge.section.general(o) }) end })
subject("section by resultants", { of = { "section_options" },
  options = { N0 = 1e6, Mx0 = 1e5, My0 = 1e5, Mz0 = 1e5 },
  build = function(o)
    return (scene { section = hinge.section.general(merged({ area = 0.01, Ix = 8e-6, Iy = 9e-6, J = 1e-5 }, o)) })
  end })
local square = { { -0.05, -0.05 }, { 0.05, -0.05 }, { 0.05, 0.05 }, { -0.05, 0.05 } }
subject("section by outline", { of = { "section_options" },
  options = { interaction = "exact with shear", shape = "solid", outline = { { corners = square },
      { diameter = 0.01, centre = { 0.01, 0.02 }, hole = true } },
    shear_walls = { x = { { -0.05, 0.05, -0.05, 0.05 } }, y = { { -0.05, 0.05, -0.05, 0.05 } } } },
  other = { interaction = "exact", shape = "box", ["outline.2.hole"] = "keep",
    ["shear_walls.x.1.1"] = -0.04, ["shear_walls.x.1.2"] = 0.04, ["shear_walls.x.1.3"] = -0.04,
    ["shear_walls.x.1.4"] = 0.04, ["shear_walls.y.1.1"] = -0.04, ["shear_walls.y.1.2"] = 0.04,
    ["shear_walls.y.1.3"] = -0.04, ["shear_walls.y.1.4"] = 0.04 },
  build = function(o)
    return (scene { section = hinge.section.general(merged({ area = 0.01 - math.pi * 0.01 ^ 2 / 4, Ix = 8.3e-6,
      Iy = 8.3e-6, J = 1e-5, plastic = { A = 0.01, Zx = 2.5e-4, Zy = 2.5e-4, Zz = 2e-4 },
      size = { width = 0.1, depth = 0.1 } }, o)) })
  end })
subject("reinforced section", { of = { "section_options", "bar", "concrete_strains" },
  options = { reinforcement = { concrete = 30e6, strains = { peak = 0.002, ultimate = 0.0035, exponent = 2.0,
    bars = 200e9 }, bars = { { 0.0, -0.03, area = 1e-4, tension = 500e6, compression = 400e6 },
    { 0.0, 0.03, area = 1e-4, tension = 500e6, compression = 400e6 } } } },
  build = function(o)
    return (scene { material = concrete(), section = hinge.section.general(merged({ area = 0.01, Ix = 8.3e-6,
      Iy = 8.3e-6, J = 1e-5, outline = { { corners = square } }, size = { width = 0.1, depth = 0.1 } }, o)) })
  end })
subject("block of concrete", { of = { "concrete_strains" },
  options = { peak = 0.003, ultimate = 0.003, block = 0.0006 }, other = { peak = 0.0029, ultimate = 0.0031 },
  build = function(o)
    return (scene { material = concrete(), section = hinge.section.general { area = 0.01, Ix = 8.3e-6,
      Iy = 8.3e-6, J = 1e-5, outline = { { corners = square } }, size = { width = 0.1, depth = 0.1 },
      reinforcement = { concrete = 30e6, strains = o, bars = { { 0, 0.03, area = 1e-4, tension = 500e6 } } } } })
  end })

local function of_backbone(o) return (scene { member = { backbone = hinge.backbone(o) } }) end
subject("backbone", { of = { "backbone_options" },
  options = { yield = 1.0, cap_rotation = 0.02, cap_strength = 1.2, post_cap_rotation = 0.2, residual = 0.2,
    ultimate_rotation = 0.3, wear = 10.0, stiffness_wear = true }, build = of_backbone })
subject("backbone by points", { of = { "backbone_options" },
  options = { points = { { 0.0, 1.0 }, { 0.02, 1.2 }, { 0.1, 0.4 } } },
  other = { ["points.1.1"] = "keep" }, build = of_backbone })

subject("member", { of = { "member_options" },
  options = { up = { 1.0, 0.1, 0.0 }, group = "posts", elements = 2, carries = "both", release = { a = "Mx" },
    ends = { b = 1e6 }, offset = { b = { 0.1, 0.2, 0.3 } }, [1] = 1, [2] = 3 },
  other = { group = "others", elements = 4, carries = "tension", ["release.a"] = "My", ["[1]"] = 2 },
  build = on_scene(function(model, o, n)
    model:member { n[o[1]], n[o[2]], section = bar(), material = steel(), up = o.up, group = o.group,
      elements = o.elements, carries = o.carries, release = o.release, offset = o.offset,
      ends = o.ends and { b = hinge.joint { Mx = { stiffness = o.ends.b } } } }
  end) })
subject("joint", { of = { "joint_options", "joint_axis" },
  options = { Mx = { stiffness = 1e7, strength = 1e4, capacity = 0.05 }, My = { points = { { 0.01, 1e3 },
    { 0.03, 2e3 } }, capacity = 0.1 }, Mz = "rigid", tension = 1e5, shear = 1e5, interaction = "none" },
  other = { Mz = "free", interaction = "linear" },
  build = function(o) return (scene { member = { ends = { b = hinge.joint(o) } } }) end })
subject("joint between nodes", { of = { "node_joint_options" },
  options = { joint = 1e6, axes = { x = { 0.0, 1.0, 0.0 }, y = { 0.0, 0.1, 1.0 } }, [1] = 2, [2] = 5 },
  other = { ["[1]"] = "keep", ["[2]"] = "keep", ["axes.x.2"] = "keep", ["axes.x.1"] = 0.1, ["axes.x.3"] = 0.1,
    -- y is made normal to x: only its direction in that plane counts
    ["axes.y.1"] = 0.1, ["axes.y.2"] = "keep", ["axes.y.3"] = "keep" },
  build = on_scene(function(model, o, n)
    n[5] = model:node { 0, 0, 3 }
    local far = model:node { 0, 2, 3 }
    model:fix(far)
    model:member { n[5], far, section = bar(), material = steel() }
    model:joint { n[o[1]], n[o[2]], axes = o.axes, joint = hinge.joint { Mx = { stiffness = o.joint } } }
  end) })

local points = { { 0.0, 0.1 }, { 0.01, 0.5 }, { 0.02, 1.0 } }
subject("load on a node", { of = { "load_options" },
  options = { node = 2, force = { 1.0, 2.0, 3.0 }, moment = { 1.0, 2.0, 3.0 }, history = points },
  build = declared("load", "node") })
subject("load along a member", { of = { "load_options" },
  options = { member = 1, q = { a = { 1.0, 2.0, 3.0 }, b = { 1.0, 2.0, 4.0 } }, axes = "global", history = points },
  other = { axes = "local" }, build = declared("load", "member") })
subject("load along a part of a member", { of = { "load_options" },
  options = { member = 1, q = { 1.0, 2.0, 3.0 }, from = 0.1, to = 0.6 }, build = declared("load", "member") })
subject("load at a place of a member", { of = { "load_options" },
  options = { member = 1, force = { 1.0, 2.0, 3.0 }, moment = { 1.0, 2.0, 3.0 }, at = 0.3, history = points },
  build = declared("load", "member") })
subject("load on a group", { of = { "load_options" }, options = { group = "beam", q = { 1.0, 2.0, 3.0 },
    axes = "projected" }, other = { group = "posts", axes = "local" }, build = declared "load" })
subject("load of a case", { of = {}, options = { factor = 1.35, force = { 1.0, 2.0, 3.0 } },
  build = on_scene(function(model, o, n) model:load { node = n[2], force = o.force, case = model:case "live" } end),
  with = function(o) return { loads = { live = o.factor } } end })
subject("heat of a case", { of = {}, options = { heat = 1.1, prestress = 1.2, gravity = 1.3 },
  build = on_scene(function(model)
    model:heat { group = "beam", temperature = 100, case = model:case "heat" }
    model:prestress { group = "beam", strain = 1e-5, case = model:case "prestress" }
    model:gravity({ 0, 0, -9.81 }, model:case "gravity")
  end), with = function(o) return { loads = o } end })

subject("mass", { of = { "mass_options" }, options = { node = 2, mass = 10.0, inertia = { 0.1, 0.2, 0.3 },
    offset = { 0.1, 0.2, 0.3 } }, build = declared("mass", "node") })
subject("rigid link", { of = { "rigid_link_options" }, options = { from = 2, to = 5, dofs = "all" },
  other = { dofs = "xyz", from = 3, to = 6 },
  build = on_scene(function(model, o, n)
    n[5], n[6] = model:node { 0.2, 0, 3 }, model:node { 0.2, 1, 3 }
    model:member { n[5], n[6], section = bar(), material = steel() }
    model:rigid_link { from = n[o.from], to = n[o.to], dofs = o.dofs }
  end) })
subject("diaphragm", { of = { "diaphragm_options" }, options = { nodes = { 2, 3 }, normal = "z", master = 2 },
  other = { normal = "y", ["nodes.1"] = 5, ["nodes.2"] = 5, master = 3 },
  build = on_scene(function(model, o, n)
    n[5] = model:node { 0, 2, 3 }
    model:member { n[2], n[5], section = bar(), material = steel() }
    model:member { n[3], n[5], section = bar(), material = steel() }
    local nodes = {}
    for i, at in ipairs(o.nodes) do nodes[i] = n[at] end
    local master = o.nodes[1] == 2 and o.nodes[2] == 3 and n[o.master] or nil -- one of its nodes
    model:diaphragm { nodes = nodes, normal = o.normal, master = master }
  end) })
subject("moving support", { of = { "move_options" },
  options = { node = 1, x = { { 0.0, 0.0 }, { 0.01, 1e-4 } }, y = { { 0.0, 0.0 }, { 0.01, 1e-4 } },
    z = { { 0.0, 0.0 }, { 0.01, 1e-4 } }, rx = { { 0.0, 0.0 }, { 0.01, 1e-4 } }, ry = { { 0.0, 0.0 }, { 0.01, 1e-4 } },
    rz = { { 0.0, 0.0 }, { 0.01, 1e-4 } } }, other = { node = 4, ["x.1.2"] = "keep", ["y.1.2"] = "keep",
    ["z.1.2"] = "keep", ["rx.1.2"] = "keep", ["ry.1.2"] = "keep", ["rz.1.2"] = "keep" },
  build = declared("move", "node") })
subject("fracture", { of = { "fracture_rule" },
  options = { group = "beam", hinge_rotation_x = 0.1, hinge_rotation_y = 0.1, elongation = 0.1, curvature_x = 1.0,
    curvature_y = 1.0, axial_strain = 0.1, shear_strain = 0.1, tension_only = true, strain_measure = "element",
    plastic_only = true },
  other = { group = "posts", strain_measure = "section" }, build = declared "fracture" })
subject("rule of fracture", { of = { "fracture_rule" }, options = { where = "all", keep = { "damage" } },
  other = { where = "yielded", ["keep.1"] = "worst" },
  build = on_scene(function(model, o) model:fracture(merged(o, { rule = function() return false end })) end) })
subject("removal", { of = { "removal_options" }, options = { member = 1, at = 0.05, over = 0.01 },
  build = declared("remove", "member") })
subject("removal of a group", { of = { "removal_options" }, options = { group = "beam", at = 0.05 },
  other = { group = "posts" }, build = declared "remove" })
local curve = { { 20.0, 1.0 }, { 1000.0, 0.5 } }
subject("heat", { of = { "heat_options", "heat_properties" },
  options = { member = 1, temperature = { { 0.0, 30.0 }, { 0.1, 100.0 } }, across_x = { { 0.0, 1.0 }, { 0.1, 10.0 } },
    across_y = { { 0.0, 1.0 }, { 0.1, 10.0 } }, properties = { stiffness = curve, strength = curve,
    elongation = { { 20.0, 0.0 }, { 1000.0, 0.01 } } } },
  other = { ["properties.stiffness.1.1"] = 10.0, ["properties.strength.1.1"] = 10.0,
    ["properties.elongation.1.1"] = 10.0 }, build = declared("heat", "member") })
subject("heat that stays", { of = { "heat_options" },
  options = { group = "beam", temperature = 100.0, across_x = 10.0, across_y = 10.0 }, other = { group = "posts" },
  build = declared "heat" })
subject("prestress", { of = { "prestress_options" }, options = { group = "beam", force = 100.0 },
  other = { group = "posts" }, build = declared "prestress" })
subject("prestress of a member", { of = { "prestress_options" }, options = { member = 1, strain = 1e-4 },
  build = declared("prestress", "member") })
subject("contact", { of = { "contact_rule" },
  options = { rule = "surface", groups = { "beam" }, stiffness = 1e8, friction = 0.3, sleep = true },
  other = { rule = "gap", ["groups.1"] = "posts" },
  build = on_scene(function(model, o)
    model:contact(o.rule == "gap" and { rule = "gap", groups = o.groups } or o)
  end) })
subject("contact of gaps", { of = { "contact_rule" },
  options = { rule = "gap", between = { "beam", "posts" }, binding_time = 1e-3, release = "time",
    contact_length = 1.8, coplanarity_tolerance = 3e-4, sleep = true, as_printed = true, sign_of_f = "absolute" },
  other = { rule = "keep", release = "parting", sign_of_f = "as printed", ["between.1"] = "posts",
    ["between.2"] = "beam" }, build = declared "contact" })
local six = { x = 1e4, y = 1e4, z = 1e4, rx = 1e4, ry = 1e4, rz = 1e4 }
local six_curves, keep_first = {}, {}
for _, axis in ipairs { "x", "y", "z", "rx", "ry", "rz" } do
  six_curves[axis] = { { 0, 0 }, { 0.01, 10.0 }, { 0.1, 20.0 } }
  keep_first["curve." .. axis .. ".1.1"], keep_first["curve." .. axis .. ".1.2"] = "keep", "keep" -- {0, 0}
end
subject("connector", { of = { "connector_options" },
  options = { [1] = 2, [2] = 4, axes = { x = { 1.0, 0.1, 0.0 }, y = { 0.0, 1.0, 0.0 } }, stiffness = six,
    damping = six, capacity = six, yield = six, ultimate = six },
  other = { ["[1]"] = 3, ["[2]"] = 3, ["axes.x.1"] = 2.0, ["axes.x.3"] = 0.1, ["axes.y.1"] = "keep",
    ["axes.y.2"] = "keep", ["axes.y.3"] = 0.1 },
  build = on_scene(function(model, o, n) model:connector(merged(o, { n[o[1]], n[o[2]] })) end) })
subject("connector by curves", { of = { "connector_options" },
  options = { [1] = 2, ground = true, curve = six_curves }, other = keep_first,
  build = on_scene(function(model, o, n)
    local other = not o.ground and n[4] or nil
    model:connector { n[o[1]], other, ground = o.ground, curve = o.curve }
  end) })
subject("damping", { of = { "damping_options" },
  options = { ratio = { 0.02, 0.03 }, periods = { 0.2, 0.02 }, group = "beam", joints = true },
  other = { group = "posts" }, build = declared "damping" })
subject("damping by factors", { of = { "damping_options" }, options = { alpha = 1.0, beta = 1e-4 },
  build = declared "damping" })
subject("ground", { of = { "ground_plane" },
  options = { point = { 0.1, 0.2, -1.0 }, normal = { 0.1, 0.2, 1.0 }, friction = 0.3, layer_stiffness = 1e8,
    layer_damping = 2e6, group = "beam" }, other = { group = "posts" }, build = declared "ground" })
subject("ground of springs", { of = { "ground_plane" },
  options = { point = { 0.0, 0.0, -1.0 }, stiffness = 1e7, restitution = 0.5 }, build = declared "ground" })
subject("sway and bow", { of = { "imperfection_options" },
  options = { sway = { sway = 0.005, direction = { 1.0, 0.1, 0.0 }, base = -0.5 },
    bow = { bow = 0.01, axis = "x", sign = "mode", group = "posts" } },
  other = { ["bow.axis"] = "y", ["bow.sign"] = "keep", ["bow.group"] = "beam", -- the mode bows to the same side
    ["sway.direction.3"] = "keep" }, -- it is horizontal
  build = function(o)
    local model = scene { model = { elements_per_member = 8 } }
    model:imperfection(o.sway)
    model:imperfection(o.bow)
    return model
  end })

-- Runs
local function plain() return (scene()) end
subject("run", { of = { "dynamic_options" }, build = plain, with = function(o)
    return o.solver == "direct" and without(o, "internals") or o
  end,
  options = { dt = 1e-4, duration = 0.01, integrator = "newmark", energy_tolerance = 0.01, step_control = 0.001,
    rest = true, beta = 0.3, iterations = 3, tolerance = 1e-9, precision = "single", solver = "cg",
    internals = { predictor = "acceleration", geometric = true, rebuild_angle = 0.02, solver_tolerance = 1e-8,
      solver_iterations = 500 } },
  other = { integrator = "keep", ["internals.predictor"] = "displacement", precision = "double", solver = "direct",
    duration = 0.02 } })
subject("run with dissipation", { of = { "dynamic_options" }, build = plain, with = function(o)
    return o.integrator == "energy-momentum" and without(o, "rho_infinity") or o
  end,
  options = { dt = 1e-4, integrator = "newmark", rho_infinity = 0.8 },
  other = { dt = "auto", integrator = "energy-momentum" } })
subject("explicit run", { of = { "dynamic_options" }, build = plain,
  with = function(o) return { dt = o.integrator == "explicit" and "auto" or 1e-5, integrator = o.integrator } end,
  options = { integrator = "explicit" }, other = { integrator = "newmark" } })

-- Fields that no change of a number can be seen in, or that change no bit, and why.
local function words(text)
  local set = {}
  for word in text:gmatch "%S+" do set[word] = true end
  return set
end
local left_out = {
  backbone_options = words "interaction", -- it refuses members, and changes nothing
  model_options = words "elements_accuracy", -- it decides the number of elements, which counts
  section_options = words "kind", -- a name
  member_options = words "section material backbone law", -- subjects of their own; a function
  load_options = words "case", -- below: its factor counts
  heat_options = words "case",
  prestress_options = words "case",
  imperfection_options = words "member mode largest", -- moved nodes, as of the others
  fracture_rule = words "rule", -- a function, of which only its presence is known
  contact_rule = words "pairs on_contact on_release",
  connector_options = words "law",
  -- where it begins is part of its state; what does not change bits; the file itself
  dynamic_options = words "from allow_failed loads threads record checkpoint",
}

-- What a value becomes; nil: it stays.
local function changed(value, other)
  if other == "keep" then return nil end
  if other ~= nil then return other end
  if type(value) == "boolean" then return not value end
  if math.type(value) == "integer" then return value + 1 end
  if type(value) == "number" then return value == 0 and 0.001 or value * 1.01 end
  error("a word needs another one: " .. tostring(value))
end

-- A deep copy with one value changed.
local function with_change(options, path, to)
  if #path == 0 then return to end
  local copy = {}
  for key, value in pairs(options) do copy[key] = value end
  copy[path[1]] = with_change(options[path[1]], { table.unpack(path, 2) }, to)
  return copy
end

-- Calls do(path) for each number, word and truth value, in the order of their names.
local function each_value(options, path, visit)
  local keys = {}
  for key in pairs(options) do keys[#keys + 1] = key end
  table.sort(keys, function(a, b) return tostring(a) < tostring(b) end)
  for _, key in ipairs(keys) do
    local here = { table.unpack(path) }
    here[#here + 1] = key
    if type(options[key]) == "table" then each_value(options[key], here, visit) else visit(here, options[key]) end
  end
end

local function name_of(path)
  local parts = {}
  for i, key in ipairs(path) do parts[i] = #path == 1 and math.type(key) and ("[%d]"):format(key) or tostring(key) end
  return table.concat(parts, ".")
end

local function run_of(one, options)
  local model = one.build(options)
  return model:dynamic(merged({ dt = 1e-4, duration = 0.01 }, one.with and one.with(options)))
end

local classes = {} -- class: the fields that a subject has
for _, one in ipairs(subjects) do
  case("a checkpoint is refused after any change of: " .. one.name, function()
    local first = run_of(one, one.options)
    first:step()
    first:checkpoint(file)
    local same = run_of(one, one.options)
    same:resume(file)
    expect(same.hash == first.hash, "the same script goes on")
    each_value(one.options, {}, function(path, value)
      local name = name_of(path)
      local to = changed(value, (one.other or {})[name])
      if to == nil then return end
      local ok, message = pcall(function()
        local other = run_of(one, with_change(one.options, path, to))
        return other:resume(file)
      end)
      expect(not ok and tostring(message):find("is of another run, which differs in", 1, true),
        "%s, %s becomes %s: %s", name, value, to, ok and "accepted" or tostring(message))
    end)
  end)
  for _, class in ipairs(one.of) do classes[class] = classes[class] or {} end
  local function note(options)
    for key, value in pairs(options) do
      for _, class in ipairs(one.of) do classes[class][tostring(key)] = true end
      if type(value) == "table" then note(value) end
    end
  end
  note(one.options)
end

case("every field of the declarations is changed here, or left out with a reason", function()
  for _, e in ipairs(require "hinge.program.reference".read()) do
    local class = e.kind == "class" and e.name:match "^hinge%.([%w_]+)$"
    for _, f in ipairs(classes[class] and e.fields or {}) do
      local field = f.name:match "[%w_]+"
      expect(classes[class][field] or (left_out[class] or {})[field], "hinge.%s has the field %s", class, field)
    end
  end
end)

checks.done()

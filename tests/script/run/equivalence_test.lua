-- The same structure told in other words: other axes, another order, other units, another solver. The answer is the
-- same to rounding. A dynamic run that goes on from another one of which nothing but the duration has changed is the
-- whole to the bit; its energies count from its own start, and what has changed since is taken up.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "equivalence"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near
local largest_of = support.largest_of

-- A scene: a frame that is pushed until it yields while a bar falls on it. `told`: how places, directions, members and
-- units are given.
local plain = {
  place = function(x) return x end, direction = function(v) return v end, -- m
  order = function(list) return list end, length = 1, mass = 1,           -- units of the script in m and kg; s in any
  options = {}, declare = function() end, interrupted = false,
}

local function told(changed) return setmetatable(changed, { __index = plain }) end

local function simulate(way)
  local m, kg = 1 / way.length, 1 / way.mass -- numbers for a metre, a kilogram
  local newton, pascal = kg * m, kg / m
  local function place(x, y, z) local p = way.place { x, y, z } return { p[1] * m, p[2] * m, p[3] * m } end
  local function vector(x, y, z, unit)
    local v = way.direction { x, y, z }
    return { v[1] * unit, v[2] * unit, v[3] * unit }
  end
  local model = hinge.model {}
  local steel = hinge.material { E = 206e9 * pascal, nu = 0.3, density = 7850 * kg / m ^ 3,
    yield_stress = 245e6 * pascal }
  local section = hinge.section.solid { width = 0.1 * m, depth = 0.14 * m }
  local joints = {}
  for s = 0, 2 do
    for b = 0, 1 do joints[2 * s + b + 1] = model:node(place(3 * b, 0.2 * s, 3 * s)) end
  end
  local falling = { model:node(place(1.4, -0.8, 6.7)), model:node(place(1.6, 0.9, 6.8)) }
  local list = {}
  for i, k in ipairs { { 1, 3 }, { 2, 4 }, { 3, 4 }, { 3, 5 }, { 4, 6 }, { 5, 6 } } do
    list[i] = { a = joints[k[1]], b = joints[k[2]], group = "frame" }
  end
  list[#list + 1] = { a = falling[1], b = falling[2], group = "bar" }
  for _, k in ipairs(way.order(list)) do
    model:member { k.a, k.b, section = section, material = steel, up = vector(0.1, 1, 0.2, 1), group = k.group }
  end
  model:fix { joints[1], joints[2] }
  model:gravity(vector(0, 0, -9.80665, m))
  model:load { node = joints[6], force = vector(9e4, 2e4, 0, newton),
    history = function(t) return math.min(1, t / 0.01) end }
  model:velocity("bar", vector(0, 0, -30, m), vector(1, 2, 0, 1))
  model:contact { stiffness = 2e8 * newton / m }
  way.declare(model, joints)
  local options = scenes.with({ dt = 2e-5, duration = 0.03, precision = "double", record = false,
    internals = { solver_tolerance = 1e-12 } }, way.options)
  if options.solver == "direct" then options.internals = nil end
  local run = model:dynamic(options)
  if way.interrupted then
    local file = os.tmpname()
    for _ = 1, run.planned_steps // 2 do run:step() end
    run:checkpoint(file)
    run = model:dynamic(options):resume(file)
    os.remove(file)
  end
  run:finish()
  assert(run.verdict == "completed", run.reason)
  local answer = {}
  for i, node in ipairs { joints[4], joints[6], falling[1], falling[2] } do
    local u = { run:displacement(node) }
    answer[i] = { u[1] / m, u[2] / m, u[3] / m }
  end
  return answer, run.energy.plastic / (newton * m), run.contacts.bound
end

local reference, plastic, touched = simulate(plain)
case("the scene yields and has contact", function()
  expect(plastic > 1, "the scene yields: %.3g J", plastic)
  expect(touched > 0, "the scene has contact")
end)

local function same(what, way, limit, back)
  local answer, work = simulate(told(way))
  local worst, size = 0, 0
  for i, u in ipairs(answer) do
    local there = (back or function(v) return v end)(u)
    for c = 1, 3 do
      worst, size = largest_of(worst, math.abs(there[c] - reference[i][c])), largest_of(size, math.abs(reference[i][c]))
    end
  end
  expect(worst / size <= limit,
    "%s: displacements off by %.2g of the largest, at most %.0e", what, worst / size, limit)
  expect(math.abs(work / plastic - 1) <= 100 * limit, "%s: plastic work off by %.2g", what, work / plastic - 1)
  if os.getenv "HINGE_FIGURES" then print(what, worst / size) end
end

case("a scene moved, turned, renumbered, in other units or with idle effects gives the same numbers", function()
  -- rotated by 1.1 rad about a skew axis (Rodrigues), and back
  local axis = { 1 / 3, 2 / 3, -2 / 3 }
  local function turned(angle)
    return function(v)
      local c, s = math.cos(angle), math.sin(angle)
      local dot = axis[1] * v[1] + axis[2] * v[2] + axis[3] * v[3]
      local cross = { axis[2] * v[3] - axis[3] * v[2], axis[3] * v[1] - axis[1] * v[3],
        axis[1] * v[2] - axis[2] * v[1] }
      local out = {}
      for i = 1, 3 do out[i] = c * v[i] + s * cross[i] + (1 - c) * dot * axis[i] end
      return out
    end
  end

  same("moved by 100 m", { place = function(x) return { x[1] + 100, x[2] - 50, x[3] + 20 } end }, 1e-10)
  same("rotated about a skew axis", { place = turned(1.1), direction = turned(1.1) }, 1e-10, turned(-1.1))
  same("members in the opposite order", { order = function(list)
    local other = {}
    for i, k in ipairs(list) do other[#list + 1 - i] = k end
    return other
  end }, 1e-10)
  same("ends of members exchanged, up with them", { order = function(list)
    for _, k in ipairs(list) do k.a, k.b = k.b, k.a end
    return list
  end }, 1e-10)
  same("in mm, t and s", { length = 1e-3, mass = 1e3 }, 1e-10)
  same("in inches and pounds", { length = 0.0254, mass = 0.45359237 }, 1e-10)
  same("direct solver", { options = { solver = "direct" } }, 1e-10)
  same("two threads", { options = { threads = 2 } }, 0)
  same("kept halfway and gone on with", { interrupted = true }, 0)
  same("limits of fracture that nothing reaches", { declare = function(model)
    model:fracture { curvature_x = 1e3, curvature_y = 1e3, axial_strain = 10 }
  end }, 0)
  same("a function of fracture that says no", { declare = function(model)
    model:fracture { rule = function() return false end }
  end }, 0)
  same("a load of nothing", { declare = function(model, joints)
    model:load { node = joints[3], force = { 0, 0, 0 } }
  end }, 0)
  same("a support that is moved by nothing", { declare = function(model, joints)
    model:move { node = joints[1], x = function() return 0 end }
  end }, 1e-10)
  same("bodies never left alone", { options = { rest = false } }, 0)
  same("step control that keeps every step", { options = { step_control = 0.5 } }, 1e-10)
  same("single precision in the operator",
    { options = { precision = "single", internals = { solver_tolerance = 1e-8 } } }, 1e-8)
end)

-- Two runs ------------------------------------------------------------------------------------------------------------

local square = hinge.section.solid { width = 0.1, depth = 0.1 }

-- A storey that is thrown sideways, with what a scene asks for; its runs follow each other.
local function storey(scene, settings, durations, between)
  local material = scene.yields and scenes.steel or scenes.elastic
  local joint = scene.joint and { a = hinge.joint { Mx = { stiffness = 2e6 } } } or nil
  local model, nodes = scenes.portal { model = { displacement = scene.displacement },
    column = { section = square, material = material }, beam = { section = square, material = material, ends = joint } }
  local b, c = nodes[2], nodes[3]
  if scene.link then model:rigid_link { from = b, to = c } end
  if scene.damping then model:damping { alpha = 1, beta = 1e-5 } end
  if scene.gravity then model:gravity { 0, 0, -9.81 } end
  if scene.load then
    model:load { node = b, force = { 2e3, 500, 0 }, history = { { 0, 0 }, { 0.02, 1 }, { 0.1, 0 } } }
  end
  for _, node in ipairs { b, c } do model:velocity(node, { scene.speed or 2, 0.2, 0 }) end
  if scene.contact then
    local bar = model:member { model:node { 2, -1, 3.2 }, model:node { 2.1, 1, 3.2 }, section = square,
      material = material }
    model:velocity(bar, { 0, 0, -3 })
    model:contact { rule = "surface", friction = 0.3 }
  end
  local run, first, steps = nil, nil, 0
  for i, duration in ipairs(durations) do
    local o = scenes.with({ from = run, duration = duration, record = false }, settings)
    if i == 2 and between then between(model, b, o) end
    run = model:dynamic(o):finish()
    first, steps = first or run, steps + run.index
  end
  return run, first, steps
end

case("a dynamic run cut in two is the whole to the bit, with energies of its own", function()
  local newmark, explicit = { dt = 2e-4 }, { dt = 5e-6, integrator = "explicit" }
  local conserving = { dt = 2e-4, integrator = "energy-momentum" }
  for name, scene in pairs {
    elastic = {}, ["damped, with its weight"] = { damping = true, gravity = true }, link = { link = true },
    small = { displacement = "small" }, ["a load over time"] = { load = true, rho = true }, joint = { joint = true },
    yields = { yields = true, speed = 6, uncontrolled = true }, contact = { contact = true },
  } do
    for _, settings in ipairs { newmark, explicit, conserving } do
      if settings ~= conserving or not (scene.displacement or scene.contact or scene.link or scene.joint) then
        settings.step_control = settings == newmark and scene.uncontrolled and 0 or nil
        settings.rho_infinity = settings == newmark and scene.rho and 0.9 or nil
        settings.dt = scene.uncontrolled and settings == newmark and 5e-5 or settings == explicit and 5e-6 or 2e-4
        local T = settings == explicit and 0.01 or 0.1
        local whole, _, steps = storey(scene, settings, { T })
        equal(whole.verdict, "completed", name .. ": " .. whole.reason)
        for _, parts in ipairs { { 0.3 * T, 0.7 * T }, { 0.5 * T, 0.1 * T, 0.4 * T } } do
          local what = ("%s, %s, %d parts"):format(name, settings.integrator or "newmark", #parts)
          local run, first, together = storey(scene, settings, parts)
          equal(run.verdict, "completed", what .. ": " .. run.reason)
          equal(run.hash, whole.hash, what .. ": the state")
          equal(together, steps, what .. ": steps")
          near(run.energy_error, 0, settings == explicit and 2e-3 or 5e-3, what .. ": energy error")
          local e = first.energy
          if #parts == 2 then
            local left = e.kinetic + e.elastic + (e.contact_stored or 0) + (e.joint_stored or 0)
            near(run.energy.initial / left, 1, 1e-9, what .. ": it begins with what the first part has left")
            local of_both = (e.gravity or 0) + (run.energy.gravity or 0)
            near(of_both, whole.energy.gravity or 0, 1e-9 * e.initial, what .. ": gravity, part by part")
          end
        end
      end
    end
  end
end)

case("a dynamic run that goes on with something changed takes it up", function()
  for what, between in pairs {
    ["a load"] = function(model, node) model:load { node = node, force = { 5e4, 0, 0 } } end,
    ["a velocity"] = function(model, node) model:velocity(node, { -3, 0, 0 }) end,
    ["gravity"] = function(model) model:gravity { 0, 0, -9.81 } end,
    ["dt"] = function(_, _, o) o.dt = 1e-4 end,
    ["damping"] = function(model) model:damping { alpha = 20 } end,
    ["beta"] = function(_, _, o) o.rho_infinity = 0.5 end,
  } do
    local whole = storey({}, { dt = 2e-4 }, { 0.1 })
    local run = storey({}, { dt = 2e-4 }, { 0.05, 0.05 }, between)
    equal(run.verdict, "completed", what .. ": " .. run.reason)
    expect(run.hash ~= whole.hash, "%s makes no difference", what)
    near(run.energy_error, 0, 1e-3, what .. ": energy error")
  end
end)

checks.done()

-- The same structure told in other words: other axes, another order, other units, another solver. The
-- answer is the same to rounding.
--
-- Run: lua5.4 tests/script/run/equivalence_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "equivalence"
local case = checks.case
local largest_of = support.largest_of

-- A scene: a frame that is pushed until it yields while a bar falls on it. `told`: how places,
-- directions, members and units are given.
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
  local members = {
    { 1, 3, "frame" }, { 2, 4, "frame" }, { 3, 4, "frame" }, { 3, 5, "frame" }, { 4, 6, "frame" }, { 5, 6, "frame" },
  }
  local list = {}
  for i, k in ipairs(members) do list[i] = { a = joints[k[1]], b = joints[k[2]], group = k[3] } end
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
  local options = { dt = 2e-5, duration = 0.03, precision = "double", record = false,
    internals = { solver_tolerance = 1e-12 } }
  for k, v in pairs(way.options) do options[k] = v end
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
  checks.expect(plastic > 1, "the scene yields: %.3g J", plastic)
  checks.expect(touched > 0, "the scene has contact")
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
  checks.expect(worst / size <= limit,
    "%s: displacements off by %.2g of the largest, at most %.0e", what, worst / size, limit)
  checks.expect(math.abs(work / plastic - 1) <= 100 * limit, "%s: plastic work off by %.2g", what, work / plastic - 1)
  if os.getenv "HINGE_FIGURES" then print(what, worst / size) end
end

case("a scene moved, turned, renumbered, in other units or with idle effects gives the same numbers", function()
  -- rotated by 1.1 rad about a skew axis (Rodrigues), and back
  local axis = { 1 / 3, 2 / 3, -2 / 3 }
  local function turned(angle)
    return function(v)
      local c, s = math.cos(angle), math.sin(angle)
      local dot = axis[1] * v[1] + axis[2] * v[2] + axis[3] * v[3]
      local cross = { axis[2] * v[3] - axis[3] * v[2], axis[3] * v[1] - axis[1] * v[3], axis[1] * v[2] - axis[2]
        * v[1] }
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

checks.done()

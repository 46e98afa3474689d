-- Studs: connectors that yield and part by their plastic deformation; slabs on studs as composite beams against the
-- closed solution of partial interaction, equilibrium of stud forces, weights; wrong options are refused.
--
-- Run: lua5.4 tests/script/effects/studs_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "studs"
local case = checks.case
local function near(what, value, wanted, tolerance) checks.near(value, wanted, tolerance, what) end
local function equal(what, value, wanted) checks.equal(value, wanted, what) end

local steel = hinge.material { E = 210e9, G = 1e14, density = 7850 } -- no deformation by shear
local plain = hinge.material { E = 210e9, G = 81e9, density = 7850 }
local section = hinge.section.h { depth = 0.3, width = 0.15, web = 0.008, flange = 0.012 }

-- Connectors that yield -----------------------------------------------------------------------------------------------

-- A member's node on a spring of 1 MN/m that yields at 10 kN, whose other end is moved.
local function pushed(to, options, turn)
  local model = hinge.model { displacement = "small" }
  local a, b, foot = model:node { 0, 0, 0 }, model:node { 0, 0, 3 }, model:node { 0.1, 0, 0 }
  local far = model:node { 0.1, 0, 3 }
  model:member { a, b, section = section, material = steel }
  model:member { foot, far, section = section, material = steel }
  for _, n in ipairs { a, b, foot, far } do model:fix(n) end
  local c, s = math.cos(turn or 0), math.sin(turn or 0)
  local o = { a, foot, axes = { x = { c, s, 0 }, y = { -s, c, 0 } }, stiffness = { x = 1e6, y = 1e6 } }
  for key, value in pairs(options) do o[key] = value end
  local spring = model:connector(o)
  model:settle { node = foot, x = to[1], y = to[2] }
  return spring, model:static { steps = 20 }:finish()
end

case("a spring that yields keeps its force, in any axes where x and y yield together", function()
  local spring, run = pushed({ 0.03, 0.04 }, { yield = { xy = 10e3 } })
  local fx, fy = spring:force(run)
  near("fx", math.abs(fx), 6e3, 1)
  near("fy", math.abs(fy), 8e3, 1)
  near("stored", run.energy.connector_stored, 10e3 ^ 2 / 2 / 1e6, 0.1)
  near("dissipated", run.energy.connector_dissipated, 10e3 * (0.05 - 0.01), 0.1)
  local turned, again = pushed({ 0.03, 0.04 }, { yield = { xy = 10e3 } }, 0.7)
  local gx, gy = turned:force(again)
  near("size in turned axes", math.sqrt(gx ^ 2 + gy ^ 2), 10e3, 1)
  local each, third = pushed({ 0.03, 0.04 }, { yield = { x = 10e3, y = 5e3 } })
  local hx, hy = each:force(third)
  near("x alone", math.abs(hx), 10e3, 1)
  near("y alone", math.abs(hy), 5e3, 1)
end)

-- A mass on a spring that yields: it oscillates with the energy that is left.
local function thrown(integrator, ultimate)
  local model = hinge.model { displacement = "small" }
  local a, b, tip = model:node { 0, 0, -1 }, model:node { 0, 0, 0 }, model:node { 0, 0, 1 }
  model:fix { a, b }
  model:member { a, b, section = section, material = plain }
  local top = model:node { 0, 0, 2 }
  model:member { tip, top, section = section, material = plain }
  model:fix(tip, "zxrxryrz")
  model:fix(top, "zxrxryrz")
  model:velocity(tip, { 0, 4, 0 })
  model:velocity(top, { 0, 4, 0 })
  local spring = model:connector { b, tip, stiffness = { x = 1e5, y = 1e5 }, yield = { xy = 500 }, ultimate = ultimate }
  local run = model:dynamic { integrator = integrator, dt = 2e-5, duration = 0.3 }:finish()
  return run, spring
end

case("both methods of steps dissipate the same; what has slipped too far parts, and energies close", function()
  local by = {}
  for _, integrator in ipairs { "newmark", "explicit" } do
    local run, spring = thrown(integrator)
    by[integrator] = run.energy.connector_dissipated
    near(integrator .. ": energy error", run.energy_error, 0, 1e-5)
    equal(integrator .. ": whole", spring:broken(run), false)
    local parted, gone = thrown(integrator, { xy = 0.05 })
    near(integrator .. ": energy error, parted", parted.energy_error, 0, 1e-4)
    equal(integrator .. ": parted", type(gone:broken(parted)), "number")
    near(integrator .. ": work until it parts", parted.energy.connector_dissipated, 500 * 0.05 + 500 ^ 2 / 2 / 1e5, 0.3)
  end
  near("the same", by.newmark, by.explicit, 1e-3 * by.explicit)
end)

case("wrong limits of connectors are refused", function()
  local model = hinge.model()
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  local function refused(word, options)
    options[1], options[2] = a, b
    checks.refused({ "model:connector", word }, function() model:connector(options) end)
  end
  refused("no stiffness in that direction", { stiffness = { x = 1 }, yield = { y = 1 } })
  refused("same stiffness along x and y", { stiffness = { x = 1, y = 2 }, yield = { xy = 1 } })
  refused("does not yield", { stiffness = { x = 1 }, yield = { x = 1 }, ultimate = { y = 1 } })
  refused("beside x or y", { stiffness = { x = 1, y = 1 }, yield = { x = 1, xy = 1 } })
end)

-- Composite beams -----------------------------------------------------------------------------------------------------

local L, width, thick, elements = 8, 0.25, 0.12, 16
local height = 0.15 + thick / 2 -- of the slab's middle above the axis of the beam
local concrete = hinge.material { E = 30e9, G = 15e9, density = 2500 }

-- Two beams on four supports with a slab between them. stud: N/m of one, at 0.2 m.
local function bridge(stud, options)
  local o = options or {}
  local model = hinge.model { displacement = o.displacement or "small" }
  local n = { model:node { 0, 0, 0 }, model:node { L, 0, 0 }, model:node { L, width, 0 }, model:node { 0, width, 0 } }
  for i = 1, 4 do
    model:fix(n[i], (i == 1 or i == 4) and "xyz" or "yz")
    local along = i % 2 == 1
    model:member { n[i], n[i % 4 + 1], section = section, material = o.plain and plain or steel,
      elements = along and elements or 2,
      up = { 0, 0, 1 }, group = along and "main" or "ends" }
  end
  local slab = { thickness = thick, material = concrete }
  if stud then slab.studs = { spacing = 0.2, stiffness = stud, height = height, capacity = o.capacity,
    slip = o.slip } end
  model:gravity { 0, 0, o.gravity or 0 }
  local floor = model:floor { slab = slab, load = o.load or 4e3, corners = n }
  return model, floor, model:members()[1]:node(elements / 2)
end

-- The sag of one beam with half of the slab, and the force in the slab, by Newmark, Siess and Viest (Proc. SESA 9(1),
-- 1951): N'' - a^2 N = -k r M / EI0. The studs of the end beams hold the slab's ends by `ends` m of the beam's studs.
local function theory(stud, load)
  local w, k, ends = load * width / 2, stud / 0.2, width / 2
  local slab = 30e9 * thick * width / 2
  local EI0 = 210e9 * section.Ix + slab * thick ^ 2 / 12
  local EA = 210e9 * section.area * slab / (210e9 * section.area + slab)
  local whole = EI0 + EA * height ^ 2
  local a = math.sqrt(k / EA * whole / EI0)
  local tanh = (1 - math.exp(-a * L)) / (1 + math.exp(-a * L))
  local B = (ends * L / 2 + 1 / a ^ 2) / (1 / a ^ 2 + ends * tanh / a)
  local function N(x)
    local fall = (math.exp(-a * x) + math.exp(-a * (L - x))) / (1 + math.exp(-a * L))
    return height * EA / whole * (w * x * (L - x) / 2 - w / a ^ 2 * (1 - B * fall))
  end
  local sag, count = 0, 2000
  for i = 1, count do
    local x = (i - 0.5) / count * L / 2
    sag = sag + (w * x * (L - x) / 2 - N(x) * height) / EI0 * x * L / 2 / count
  end
  return sag, N(L / 2)
end

case("a slab on studs is a composite beam with partial interaction (Newmark, Siess and Viest)", function()
  for _, stud in ipairs { 1e9, 1e7, 1e6, 1e5 } do
    local model, floor, middle = bridge(stud)
    local run = model:static { steps = 1 }:finish()
    local sag, force = theory(stud, 4e3)
    near(("sag, studs of %g MN/m"):format(stud / 1e6), -select(3, middle:displacement(run)), sag, 0.015 * sag)
    local most = 0
    for _, panel in ipairs(floor.slab) do most = support.smallest_of(most, (panel:force(run))) end
    near(("force, studs of %g MN/m"):format(stud / 1e6), -most * width / 2, force, 0.02 * force)
  end
end)

case("studs change no weight; those that yield let the beam sag more", function()
  local sums = {}
  for i, stud in ipairs { false, 1e7 } do
    local model, floor = bridge(stud or nil, { gravity = -9.80665 })
    local run = model:static { steps = 1 }:finish()
    local sum = 0
    for _, node in ipairs(model:nodes()) do sum = sum + select(3, run:reaction(node)) end
    sums[i] = { sum, floor.mass, floor.load }
  end
  for k = 1, 3 do near("sum " .. k, sums[2][k], sums[1][k], 1e-9 * sums[1][k]) end
  local sag = {}
  for _, capacity in ipairs { 0, 4e3 } do
    local model, _, middle = bridge(1e7, { load = 60e3, capacity = capacity > 0 and capacity or nil })
    local run = model:static { steps = 10 }:finish()
    sag[#sag + 1] = -select(3, middle:displacement(run))
    if capacity > 0 then equal("work of studs", run.energy.connector_dissipated > 10, true) end
  end
  equal("more sag", sag[2] > 1.05 * sag[1], true)
end)

case("studs that slip too far break, and a connector to a slab's node has the place of its beam's node", function()
  local model, floor, middle = bridge(1e7, { load = 60e3, capacity = 4e3, slip = 1e-4, plain = true })
  local over
  for _, panel in ipairs(floor.slab) do
    for _, node in ipairs(panel.nodes) do
      if math.abs(node.x - middle.x) + math.abs(node.y - middle.y) < 1e-9 then over = node end
    end
  end
  model:connector { middle, over, stiffness = { x = 1e6, z = 1e6 }, capacity = { z = 1 } }
  local run = model:dynamic { integrator = "explicit", dt = 1e-5, duration = 0.05 }:finish()
  local broken = 0
  for _, change in ipairs(run.state_changes) do
    if change.why:find "broke" then broken = broken + 1 end
  end
  equal("verdict", run.verdict, "completed")
  equal("some broke", broken > 1, true)
  local hinges = run:hinges()
  equal("rated", #hinges, 1)
  equal("at a member", hinges[1].member and hinges[1].member.index, 1)
  near("energy error", run.energy_error, 0, 1e-4)
end)

case("wrong studs are refused, and lay nothing", function()
  local function refused(word, given)
    checks.refused({ "studs", word }, function()
      local model = hinge.model()
      local n = { model:node { 0, 0, 0 }, model:node { 4, 0, 0 }, model:node { 4, 4, 0 }, model:node { 0, 4, 0 } }
      for i = 1, 4 do model:member { n[i], n[i % 4 + 1], section = section, material = steel, elements = 2 } end
      model:floor { corners = n, slab = { thickness = thick, material = concrete, studs = given } }
    end)
  end
  refused("spacing", { stiffness = 1e6 })
  refused("capacity", { spacing = 0.2, stiffness = 1e6, slip = 5e-3 })
  refused("must be a table", true)
end)

checks.done()

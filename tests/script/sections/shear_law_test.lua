-- Sections that shear forces weaken: interaction = "exact with shear", EN 1993-1-1 6.2.6 to 6.2.8, by closed forms.
--
-- Run: lua5.4 tests/script/sections/shear_law_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local scenes = require "scenes"
local checks = support.checks "shear_law"
local case, expect, near = checks.case, checks.expect, checks.near

local fy = 300e6
local steel = hinge.material { E = 210e9, density = 7850, yield_stress = fy }
local law = { interaction = "exact with shear" }

--- The moment at which a cantilever yields, M = (Z - rho Z_walls) fy, and its shear force V = M / L: both at once, by
--- bisection for V. V0 = A_v fy / sqrt(3).
local function by_hand(Z, walls, area, L)
  local V0, low, high = area * fy / math.sqrt(3), 0, Z * fy / L
  local function rho(V) return V > V0 / 2 and support.smallest_of(1, (2 * V / V0 - 1) ^ 2) or 0 end
  for _ = 1, 100 do
    local V = (low + high) / 2
    if (Z - rho(V) * walls) * fy / L > V then low = V else high = V end
  end
  return low, low / V0, rho(low)
end

--- The force across the tip at which a cantilever yields. towards: "uy" bends about z of space, "uz" about y; the
--- section's y is along z. more: axial force and torque at the tip; steps of one displacement.
local function pushed(section, L, towards, more, options)
  more, options = more or {}, options or {}
  local model, tip = scenes.cantilever { length = L, member = { section = section, material = steel, up = { 0, 0, 1 } },
    model = { displacement = "small", formulation = options.formulation, interaction = options.law } }
  local held, push = model:case "held", model:case "push"
  local start
  if more.N or more.Mx then
    held:load { node = tip, force = { more.N or 0, 0, 0 }, moment = { more.Mx or 0, 0, 0 } }
    start = model:static { loads = "held", steps = 4, record = false }:finish()
  end
  push:load { node = tip, force = towards == "uy" and { 0, 1e3, 0 } or { 0, 0, 1e3 } }
  local run = model:static { from = start, loads = { push = 1 }, steps = options.steps or 60, record = false,
    control = { node = tip, towards, to = 0.06 * L } }:finish()
  return 1e3 * run.factor, run
end

local h = hinge.section.h { depth = 0.3, width = 0.15, web = 0.0071, flange = 0.0107, interaction = law.interaction }
local clear = 0.3 - 2 * 0.0107

case("an H about its strong axis: the web has less", function()
  local least = 1
  for _, L in ipairs { 0.42, 0.5, 0.7 } do
    local V, v, rho = by_hand(h.Zx, 0.0071 * clear ^ 2 / 4, 0.0071 * clear, L)
    near(pushed(h, L, "uz"), V, 1e-4 * V, ("L %g, V / V0 %.3f, rho %.3f"):format(L, v, rho))
    least = support.smallest_of(least, 1 - rho)
  end
  expect(least < 0.5, "one of them loses more than half of its web, not %g", least)
end)

-- Cantilevers that shear weakens yield where the sums by hand have it. A row: what, section, L, towards, plastic
-- modulus, that of the walls which carry the shear, A_v; tolerance (1e-4), steps.
local function yield_by_hand(rows)
  for _, row in ipairs(rows) do
    local what, section, L, towards, Z, walls, area = table.unpack(row)
    local V, v, rho = by_hand(Z, walls, area, L)
    expect(rho > 0.05, "%s: rho is %g at V / V0 %g", what, rho, v)
    near(pushed(section, L, towards, nil, { steps = row.steps }), V, (row.tolerance or 1e-4) * V, what)
  end
end

case("an H about its weak axis: the flanges have less, the web nothing", function()
  yield_by_hand { { "weak axis", h, 0.1, "uy", h.Zy, 2 * 0.0107 * 0.15 ^ 2 / 4, 2 * 0.0107 * 0.15 } }
end)

case("a box, solid and round sections, a pipe", function()
  local t = 0.008
  local box = hinge.section.box { width = 0.1, depth = 0.2, thickness = t, interaction = law.interaction }
  local solid = hinge.section.solid { width = 0.1, depth = 0.2, interaction = law.interaction }
  local pipe = hinge.section.pipe { diameter = 0.2, thickness = 0.01, interaction = law.interaction }
  yield_by_hand {
    { "box, strong axis", box, 0.22, "uz", box.Zx, 2 * t * (0.2 - 2 * t) ^ 2 / 4, box.area * 2 / 3 },
    { "box, weak axis", box, 0.3, "uy", box.Zy, 2 * t * (0.1 - 2 * t) ^ 2 / 4, box.area / 3 },
    { "solid", solid, 0.12, "uz", solid.Zx, solid.Zx, 0.02 },
    { "pipe", pipe, 0.25, "uz", pipe.Zx, pipe.Zx, 2 * pipe.area / math.pi },
  }
end)

-- A_v of a rolled H: A - 2 b tf + (tw + 2 r) tf. The web of a channel has what lies between the flanges. Both legs of
-- an angle carry the shear, and the moment.
case("named sections, by A_v of rolled ones; channels", function()
  local heb, pipe = hinge.section.named("HEB 300", law), hinge.section.named("CHS 168.3x8", law)
  local rolled = heb.area - 2 * 0.3 * 0.019 + (0.011 + 2 * 0.027) * 0.019
  local channel = hinge.section.channel { depth = 0.2, width = 0.08, web = 0.007, flange = 0.012,
    interaction = law.interaction }
  local angle = hinge.section.named("L 100x100x10", law)
  yield_by_hand {
    { "HEB 300", heb, 0.8, "uz", heb.Zx, 0.011 * 0.262 ^ 2 / 4, rolled, tolerance = 2e-4 },
    { "CHS 168.3x8", pipe, 0.2, "uz", pipe.Zx, pipe.Zx, 2 * pipe.area / math.pi },
    { "channel", channel, 0.35, "uz", channel.Zx, 0.007 * 0.176 ^ 2 / 4, channel.shear_area_y },
    { "angle, strong axis", angle, 0.13, "uz", angle.Zx, angle.Zx, angle.shear_area_y, steps = 300 },
    { "angle, weak axis", angle, 0.07, "uy", angle.Zy, angle.Zy, angle.shear_area_x, steps = 300 },
  }
  local tube = hinge.section.named("RHS 200x100x8", law) -- A_v along x is A b / (b + d), in spite of its radii
  local beyond, run = pushed(tube, 0.14, "uy")
  local told = ("V / V0 = %.1f along x"):format(beyond / (tube.area / 3 * fy / math.sqrt(3)))
  expect(told == "V / V0 = 1.2 along x" and support.has(run.warnings[1] or "", told), "RHS: %s in %s", told,
    run.warnings[1])
  for _, wrong in ipairs { { x = { { 0, 0, 0, 1 } } }, { y = { { 0, 1, 0 } } }, { z = {} } } do
    checks.refused("walls", hinge.section.general, { area = 1, Ix = 1, Iy = 1, J = 1, shear_walls = wrong })
  end
end)

case("no shear force to speak of: the exact interaction", function()
  local exact = hinge.section.h { depth = 0.3, width = 0.15, web = 0.0071, flange = 0.0107, interaction = "exact" }
  local with = pushed(h, 3, "uz", { N = -4e5 })
  near(with, pushed(exact, 3, "uz", { N = -4e5 }), 1e-9 * with, "a slender cantilever")
end)

-- The moment of the H beside N where its web has (1 - rho) fy: what is within `axis` of the middle carries N, the rest
-- the moment.
local function beside(N, rho)
  local web, half, inner = 0.0071 * (1 - rho), 0.15, clear / 2
  local axis = N / fy / (2 * web)
  if axis <= inner then return fy * (0.15 * (half ^ 2 - inner ^ 2) + web * (inner ^ 2 - axis ^ 2)) end
  axis = inner + (N / fy - 2 * web * inner) / (2 * 0.15) -- in the flanges
  return fy * 0.15 * (half ^ 2 - axis ^ 2)
end

case("an axial force beside the shear force: by stress blocks", function()
  local L, N = 0.4, 0.25 * fy * h.area
  local V0 = 0.0071 * clear * fy / math.sqrt(3)
  local low, high = 0, V0
  for _ = 1, 40 do
    local V = (low + high) / 2
    local rho = V > V0 / 2 and (2 * V / V0 - 1) ^ 2 or 0
    if beside(N, rho) / L > V then low = V else high = V end
  end
  near(pushed(h, L, "uz", { N = N }), low, 1e-3 * low, "0.25 N0")
end)

case("torsion takes from V0, by 6.2.7(9), and from the section", function()
  local box = hinge.section.box { width = 0.15, depth = 0.15, thickness = 0.008, interaction = law.interaction }
  local L, t = 0.25, 0.3
  local walls, V0 = 2 * 0.008 * 0.134 ^ 2 / 4, box.area / 2 * fy / math.sqrt(3) * (1 - t)
  local low, high = 0, V0
  for _ = 1, 100 do
    local V = (low + high) / 2
    local rho = V > V0 / 2 and (2 * V / V0 - 1) ^ 2 or 0
    if math.sqrt(1 - t * t) * (box.Zx - rho * walls) * fy / L > V then low = V else high = V end
  end
  local member = { Mx = t * box.Zz * fy / math.sqrt(3) }
  near(pushed(box, L, "uz", member), low, 2e-3 * low, "0.3 Mz0")
end)

case("the model's option, and conventional elements", function()
  local plain = hinge.section.h { depth = 0.3, width = 0.15, web = 0.0071, flange = 0.0107 }
  local V = by_hand(h.Zx, 0.0071 * clear ^ 2 / 4, 0.0071 * clear, 0.5)
  near(pushed(plain, 0.5, "uz", nil, { law = "exact with shear" }), V, 1e-4 * V, "asked of the model")
  local found = pushed(h, 0.5, "uz", nil, { formulation = "conventional" })
  expect(found > V and found < 2 * V, "a conventional element yields in its middle, at %g of %g N", found, V)
end)

case("no warning of a moment that shear does not leave; one of a shear force beyond V0", function()
  local function said(run)
    for _, w in ipairs(run.warnings) do
      local text = type(w) == "table" and w.text or w
      if text:find("V / V0", 1, true) then return text end
    end
  end
  local _, run = pushed(h, 0.5, "uz")
  expect(not said(run), "a warning: %s", said(run))
  _, run = pushed(h, 0.12, "uz")
  local text = said(run)
  expect(text and text:find "more than its plastic shear strength", "no warning of V > V0 but %s", text)
end)

-- A short cantilever with a mass at its tip that moves fast.
local function hit(options)
  local model, tip = scenes.cantilever { length = 0.6, member = { section = h, material = steel, up = { 0, 0, 1 } } }
  model:mass { node = tip, mass = 1000 }
  model:velocity(tip, { 0, 0, 4 })
  options.duration = 0.02
  local run = model:dynamic(options)
  local last, least = 0, 0
  run:on_step(function()
    least = support.smallest_of(least, run.energy.plastic - last)
    last = run.energy.plastic
  end)
  run:finish()
  return run, least
end

case("dynamics: energy closes, and no step gives plastic work back", function()
  local works = {}
  for _, options in ipairs { { dt = "auto" }, { dt = 1e-4 }, { dt = "auto", integrator = "explicit" },
    { dt = 1e-4, integrator = "energy-momentum" } } do
    local run, least = hit(options)
    expect(run.verdict == "completed", "%s", run.verdict)
    near(run.energy_error, 0, 2e-3, "energy error")
    expect(least >= -1e-9 * 8000, "a step gives back %g J", least)
    works[#works + 1] = run.energy.plastic
  end
  for i = 2, #works do near(works[i], works[1], 0.02 * works[1], "plastic work, by another way of stepping") end
  expect(works[1] > 5000, "most of the energy is dissipated: %g J", works[1])
end)

case("a moment below M0 that shear does not leave: the section flows, though nothing has before", function()
  for name, flows in pairs { exact = false, ["exact with shear"] = true } do
    local model, tip = scenes.cantilever { length = 0.5, model = { interaction = name }, member = { material = steel,
      section = hinge.section.h { depth = 0.3, width = 0.15, web = 0.0071, flange = 0.0107 }, up = { 0, 0, 1 } } }
    model:mass { node = tip, mass = 100 }
    model:load { node = tip, force = function(t) return { 0, 0, -330e3 * support.smallest_of(1, t / 0.05) } end }
    local run = model:dynamic { dt = 1e-4, duration = 0.06, record = false }:finish()
    expect((run.energy.plastic > 0) == flows, "%s: plastic work %g J", name, run.energy.plastic)
    near(run.energy_error, 0, 2e-3, name)
  end
end)

checks.done()

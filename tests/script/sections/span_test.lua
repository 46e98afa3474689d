-- Moments and limit loads in the span of members under axial force, with two elements a member, against the closed
-- form of the beam-column: M'' + k^2 M = -r q, k^2 = r P / EI (in tension with hyperbolic functions). Shear makes the
-- bow softer (Engesser 1891): r = 1 / (1 - P / GA).
--
-- Run: lua5.4 tests/script/sections/span_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local scenes = require "scenes"
local checks = support.checks "span"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local E, L, side, f_y = 210e9, 5, 0.1, 235e6
local section = hinge.section.solid { width = side, depth = side }
local steel = hinge.material { E = E, nu = 0.3, density = 7850 }
local yielding = hinge.material { E = E, nu = 0.3, density = 7850, yield_stress = f_y }
local EI, GA = E * section.Ix, 5 / 6 * E / 2.6 * side ^ 2
local P_E = math.pi ^ 2 * EI / L ^ 2

local function sinh(x) return (math.exp(x) - math.exp(-x)) / 2 end
local function cosh(x) return (math.exp(x) + math.exp(-x)) / 2 end

--- Moments of a pinned beam-column at x: under an even load q, under a force W at c, under end moments a and b.
local function exact(P)
  local r = 1 / (1 - P / GA)
  local k = math.sqrt(r * math.abs(P) / EI)
  local sin, cos = P > 0 and math.sin or sinh, P > 0 and math.cos or cosh
  local sign = P > 0 and 1 or -1
  return {
    even = function(q, x) return sign * r * q / k ^ 2 * (cos(k * (x - L / 2)) / cos(k * L / 2) - 1) end,
    force = function(W, c, x)
      local low, high = x < c and x or c, x < c and c or x
      return r * W * sin(k * low) * sin(k * (L - high)) / (k * sin(k * L))
    end,
    ends = function(a, b, x) return (a * sin(k * (L - x)) + b * sin(k * x)) / sin(k * L) end,
    u = k * L / 2,
  }
end

-- A member of `o` along x from a pin to a roller (or what o.slide holds). Returns the member and its far end.
local function simple(model, o)
  local a, b = model:node { 0, 0, 0 }, model:node { o.length or L, 0, 0 }
  model:fix(a, "xyz rx")
  model:fix(b, o.slide or "yz")
  return model:member { a, b, section = o.section or section, material = o.material or steel, up = { 0, 0, 1 } }, b
end

-- Small loads: the bow is so small that the closed form, which is linear in it, is right to 1e-3 at 0.9 P_E.
local q = 4e-4 * P_E / L

--- A member from the origin along `along`, pressed by `part` of Euler's load, and what acts across it along `across`.
local function pressed(o)
  local model = hinge.model { elements_per_member = o.elements or 2 }
  local axial, lateral = model:case "axial", model:case "lateral"
  local t, n = o.along or { 1, 0, 0 }, o.across or { 0, 0, -1 }
  local s = { t[2] * n[3] - t[3] * n[2], t[3] * n[1] - t[1] * n[3], t[1] * n[2] - t[2] * n[1] } -- the axis of bending
  local function times(f, v) return { f * v[1], f * v[2], f * v[3] } end
  local a, b = model:node { 0, 0, 0 }, model:node(times(L, t))
  local ends = { a, b }
  if o.ends == "clamped" then
    model:fix(a)
    model:fix(b, o.slide .. " rx ry rz")
  else
    model:fix(a, "xyz " .. (o.twist or "rx"))
    model:fix(b, o.slide or "yz")
  end
  local member = model:member { a, b, section = section, material = o.material or steel, up = n }
  for _, load in ipairs(o.loads) do
    if load.couple then lateral:load { node = ends[load.at], moment = times(load.couple, s) }
    elseif load.force then lateral:load { member = member, at = load.at, force = times(load.force, n) }
    else lateral:load { member = member, q = times(load.q, n) } end
  end
  axial:load { node = b, force = times(-o.part * P_E, t) }
  return model, member
end

local function largest(member, run, parts)
  local found
  for _, row in ipairs(member:along(run, parts or 16)) do
    if not found or not (math.abs(row.Mx) <= math.abs(found)) then found = row.Mx end
  end
  return found
end

case("the largest moment of the span is that of the beam-column, in compression and tension", function()
  for _, part in ipairs { 0.1, 0.3, 0.6, 0.9, -1 } do
    local of = exact(part * P_E)
    local function most(f)
      local M = 0
      for i = 0, 2000 do
        local now = f(i / 2000 * L)
        if math.abs(now) > math.abs(M) then M = now end
      end
      return M
    end
    local W, m = q * L, q * L ^ 2 / 8
    local cases = {
      { "even load", { { q = q } }, function(x) return of.even(q, x) end },
      { "force in a quarter", { { at = 0.25, force = W } }, function(x) return of.force(W, L / 4, x) end },
      { "force near an end", { { at = 0.9, force = W } }, function(x) return of.force(W, 0.9 * L, x) end },
      { "two forces", { { at = 0.35, force = W }, { at = 0.7, force = 0.5 * W } },
        function(x) return of.force(W, 0.35 * L, x) + of.force(0.5 * W, 0.7 * L, x) end },
      { "moments at the ends", { { at = 1, couple = m }, { at = 2, couple = -0.4 * m } },
        function(x) return of.ends(m, 0.4 * m, x) end },
    }
    for _, scene in ipairs(cases) do
      local want = most(scene[3])
      for _, elements in ipairs { 2, 4 } do
        local model, member = pressed { part = part, loads = scene[2], elements = elements }
        local run = model:static { loads = { axial = 1, lateral = 1 }, steps = 2 }:finish()
        equal(run.verdict, "completed", scene[1])
        local M = largest(member, run)
        near(math.abs(M), math.abs(want), 0.006 * math.abs(want),
          ("%s, %g P_E, %d elements"):format(scene[1], part, elements))
      end
    end
  end
end)

case("shear takes its part of Euler's load: rolled sections about both axes", function()
  for _, name in ipairs { "HEB 200", "IPE 300" } do
    local of = hinge.section.named(name)
    for axis, plane in pairs { x = { of.Ix, of.shear_area_y }, y = { of.Iy, of.shear_area_x } } do
      local I, A = E * plane[1], E / 2.6 * plane[2]
      local length = 40 * math.sqrt(plane[1] / of.area) -- short: the part of shear is 0.2 to 1.4 % of Euler's load
      local euler = math.pi ^ 2 * I / length ^ 2
      -- firm along the axis and in the other plane, as the closed form is
      local firm = hinge.section.general { area = 1e3, Ix = plane[1], Iy = 100 * plane[1], J = of.J,
        shear_area_x = plane[2], shear_area_y = plane[2] }
      for _, part in ipairs { 0.3, 0.6, 0.9 } do
        local P, small = part * euler / (1 + euler / A), 1e-6 * euler / length
        local k = math.sqrt(P / I / (1 - P / A))
        local want = small * I / P * (1 / math.cos(k * length / 2) - 1)
        for _, elements in ipairs { 2, 4 } do
          local model = hinge.model { elements_per_member = elements }
          local member, b = simple(model, { length = length, section = firm })
          model:load { node = b, force = { -P, 0, 0 } }
          model:load { member = member, q = { 0, 0, -small } }
          local M = largest(member, model:static { steps = 2 }:finish())
          near(math.abs(M), want, 0.003 * want, ("%s about %s, %g, %d elements"):format(name, axis, part, elements))
        end
      end
    end
  end
end)

case("between clamped ends it holds beyond Euler's load, too", function()
  for _, part in ipairs { 0.9, 1.8, 2.2 } do
    local u = exact(part * P_E).u
    local model, member = pressed { part = part, loads = { { q = q } }, ends = "clamped", slide = "yz" }
    local run = model:static { loads = { axial = 1, lateral = 1 }, steps = 2 }:finish()
    local middle, want
    for _, row in ipairs(member:along(run, 2)) do if math.abs(row.x - L / 2) < 1e-6 then middle = row.Mx end end
    want = q * L ^ 2 / 4 * (u / math.sin(u) - 1) / u ^ 2
    near(math.abs(middle), want, 0.01 * want, ("clamped, %g P_E, in the middle"):format(part))
  end
end)

case("the same in every direction", function()
  local turned = {}
  local r = math.sqrt(0.5)
  for i, way in ipairs {
    { along = { 1, 0, 0 }, across = { 0, 0, -1 }, slide = "yz", twist = "rx" },
    { along = { 0, 1, 0 }, across = { 1, 0, 0 }, slide = "xz", twist = "ry" },
    { along = { 0, 0, 1 }, across = { 0, -1, 0 }, slide = "xy", twist = "rz" },
    { along = { 0, 0, 1 }, across = { r, r, 0 }, slide = "xy", twist = "rz" },
  } do
    way.part, way.loads = 0.6, { { q = q }, { at = 0.3, force = q * L } }
    local model, member = pressed(way)
    turned[i] = math.abs(largest(member, model:static { loads = { axial = 1, lateral = 1 }, steps = 2 }:finish()))
    near(turned[i], turned[1], 1e-6 * turned[1], "direction " .. i)
  end
end)

--- Limit load of a pinned member under an even load: the moment in the middle is the plastic one of a rectangle with N.
local function limit_of(part)
  local P, u = part * P_E, exact(part * P_E).u
  local N = P / (section.area * f_y)
  return section.Zx * f_y * (1 - N ^ 2) * P / EI / (1 / math.cos(u) - 1)
end

-- The factor of the loads across at the limit, beside the whole of the axial force.
local function limit(model, steps)
  local first = model:static { loads = { axial = 1 }, steps = 2 }:finish()
  local run = model:static { from = first, loads = { axial = 1, lateral = 1 }, steps = steps, to_limit = true }
  return run:finish().factor
end

case("a pinned member under an even load fails at the load of the beam-column", function()
  for _, part in ipairs { 0.1, 0.3, 0.6, 0.8 } do
    for _, elements in ipairs { 2, 4 } do
      local want = limit_of(part)
      local model = pressed { part = part, loads = { { q = 1.5 * want } }, material = yielding, elements = elements }
      -- the closed form has no shear and a bow that stays small
      near(1.5 * limit(model, 15), 1, 0.015, ("%g P_E, %d elements: over the closed form"):format(part, elements))
    end
  end
end)

case("hinges off the middle: the largest moment of the span makes them", function()
  -- One end moment half of the other, and a force in a quarter: against sixteen elements, whose hinge is within L / 16.
  for _, loads in ipairs { { { at = 1, couple = 1 }, { at = 2, couple = -0.5 } }, { { at = 0.25, force = 5 / L } } } do
    for _, part in ipairs { 0.3, 0.6, 0.8 } do
      local found = {}
      for _, elements in ipairs { 2, 4, 16 } do
        local scaled = {}
        for i, l in ipairs(loads) do
          local M = section.Zx * f_y
          scaled[i] = { at = l.at, couple = l.couple and M * l.couple, force = l.force and M * l.force }
        end
        local model = pressed { part = part, loads = scaled, material = yielding, elements = elements }
        found[elements] = limit(model, 30)
      end
      for _, elements in ipairs { 2, 4 } do
        near(found[elements], found[16], 0.02 * found[16],
          ("%s, %g P_E, %d elements"):format(loads[1].couple and "end moments" or "force", part, elements))
      end
    end
  end
end)

case("a load that comes slowly makes the hinge at the same load in dynamics", function()
  for _, integrator in ipairs { "newmark", "energy-momentum" } do
    local part = 0.6
    local want = limit_of(part)
    local model = hinge.model {}
    local member, b = simple(model, { material = yielding })
    model:load { member = member, q = { 0, 0, -1.2 * want }, history = { { 0, 0 }, { 2, 1 }, { 3, 1 } } }
    model:load { node = b, force = { -part * P_E, 0, 0 }, history = { { 0, 0 }, { 0.5, 1 }, { 3, 1 } } }
    model:damping { alpha = 20 }
    local run = model:dynamic { dt = 2e-3, duration = 2, integrator = integrator }
    local yields
    while run:step() do
      if run.energy.plastic > 0 then yields = run.time break end
    end
    if expect(yields, integrator .. ": it yields") then
      near(1.2 * yields / 2, 1, 0.03, integrator .. ": load at first yield over the limit load")
    end
  end
end)

case("what yields in the span closes the energy balance", function()
  local part = 0.6
  local want = limit_of(part)
  for _, integrator in ipairs { "newmark", "energy-momentum", "explicit" } do
    local model, member = pressed { part = part, loads = { { q = 0.3 * want } }, material = yielding }
    local start = model:static { loads = { axial = 1, lateral = 1 }, steps = 4 }:finish()
    model:load { member = member, q = { 0, 0, -2 * want }, history = { { 0, 0 }, { 0.01, 1 }, { 0.05, 0 } } }
    local run = model:dynamic { from = start, dt = integrator == "explicit" and "auto" or 1e-4, duration = 0.06,
      integrator = integrator }:finish()
    expect(run.energy.plastic > 0, "%s: it yields", integrator)
    near(run.energy_error, 0, 2e-3, integrator .. ": energy error")
  end
end)

case("without axial force nothing is added: chord and member agree", function()
  local found = {}
  for i, p_delta in ipairs { "chord", "member" } do
    local model = hinge.model { p_delta = p_delta }
    local member = simple(model, {})
    model:load { member = member, q = { 0, 0, -q } }
    found[i] = largest(member, model:static { steps = 1 }:finish())
  end
  near(math.abs(found[1]), q * L ^ 2 / 8, 1e-6 * q * L ^ 2, "q L^2 / 8")
  near(found[2], found[1], 1e-6 * math.abs(found[1]), "member against chord")
end)

case("weight at the nodes beside compression is warned of", function()
  local model = hinge.model { weight = "nodes" }
  local axial, own = model:case "axial", model:case "own"
  local _, b = simple(model, {})
  own:gravity { 0, 0, -9.81 }
  axial:load { node = b, force = { -0.6 * P_E, 0, 0 } }
  local run = model:static { loads = { axial = 1, own = 1 }, steps = 2 }:finish()
  expect(#run.warnings == 1 and run.warnings[1]:find("too small", 1, true), "told: %s", tostring(run.warnings[1]))
end)

case("a held beam whose sag would pull it is warned of with two elements, and not with eight", function()
  for _, ends in ipairs { { 8, 0, 6 }, { 0, 10, 0 } } do
    local N, told = {}, {}
    for _, elements in ipairs { 2, 8 } do
      local model = hinge.model { elements_per_member = elements }
      local a, b = model:node { 0, 0, 0 }, model:node(ends)
      model:fix { a, b }
      local member = model:member { a, b, section = scenes.square, material = steel, up = { 1, 1, 1 } }
      model:gravity { 0, 0, -9.80665 }
      local run = model:static { steps = 4 }:finish()
      N[elements], told[elements] = member:forces(run).N, table.concat(run.warnings, "; ")
    end
    expect(N[2] < 0.5 * N[8], "the scene: %g and %g N", N[2], N[8])
    expect(told[2]:find("sags under the loads", 1, true), "two elements: told '%s'", told[2])
    equal(told[8], "", "eight elements")
  end
end)

case("dynamics warns of it, too, and neither does where an end is free or the beam is struck", function()
  local function told(o)
    local model = hinge.model { elements_per_member = 2 }
    local member = simple(model, { length = 10, slide = o.free and "yz" or "xyz", section = scenes.square })
    local down = -1e3 * (o.blow and 30 or 1)
    model:case("down"):load { member = member, q = { 0, 0, down },
      history = o.blow and { { 0, 1 }, { 0.02, 0 } } or { { 0, 0 }, { 2, 1 } } }
    model:damping { alpha = 10 }
    local run = model:dynamic { dt = o.blow and 1e-3 or 5e-3, duration = o.blow and 0.02 or 3, record = false,
      loads = { down = 1 },
      energy_tolerance = 0.1 }:finish()
    equal(run.verdict, "completed", run.reason)
    local static = model:static { loads = { down = 1 }, steps = 4 }:finish()
    return table.concat(run.warnings, "; "):find("sags under the loads", 1, true) ~= nil,
      table.concat(static.warnings, "; "):find("sags under the loads", 1, true) ~= nil
  end
  local dynamic, static = told {}
  expect(dynamic and static, "held: dynamics %s, statics %s", dynamic, static)
  dynamic, static = told { free = true }
  expect(not dynamic and not static, "a free end: dynamics %s, statics %s", dynamic, static)
  dynamic = told { blow = true }
  expect(not dynamic, "a blow")
end)

checks.done()

-- Lumped masses of explicit steps: bodies spin, topple and swing as the continuous bar does, with any number of
-- elements; what is left of a pair that breaks has its mass, centre and moment of inertia.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local scenes = require "scenes"
local support = require "support"
local checks = support.checks "explicit mass"
local case, expect, near = checks.case, checks.expect, checks.near
local steel = hinge.material { E = 206e9, density = 7850 }
local tube = hinge.section.box { width = 0.1, depth = 0.1, thickness = 0.01 }
local rod = hinge.section.solid { width = 0.02, depth = 0.02 }
local g = 9.80665

local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end
local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end
local function times(k, a) return { k * a[1], k * a[2], k * a[3] } end
local function plus(a, b) return { a[1] + b[1], a[2] + b[2], a[3] + b[3] } end

-- A run of explicit steps that keeps no frames.
local function explicit(model, duration, more)
  return model:dynamic(scenes.with({ dt = "auto", duration = duration, integrator = "explicit", record = false }, more))
end

-- When a coordinate of a node comes down to 0, between two steps; nil where it does not.
local function falls_to_zero(run, coordinate)
  local before, last = coordinate(), 0
  for _ in run:steps() do
    local now = coordinate()
    if now <= 0 then return run.time - (run.time - last) * now / (now - before) end
    before, last = now, run.time
  end
end

-- A free bar of length L along `axis` (of length 1), with a couple of forces `across` at its ends for 0.05 s. Returns
-- the mean spin that remains over M t / (m L^2 / 12 + rho I L).
local function spin(elements, axis, across, options)
  local L, T, F = 3, 0.05, 100
  local model, b, _, a = scenes.cantilever { length = L, along = axis, foot = false,
    model = scenes.with({ elements_per_member = elements, plasticity = false }, options),
    member = { section = tube, material = steel, up = math.abs(axis[3]) > 0.9 and { 1, 0, 0 } or { 0, 0, 1 } } }
  local pulse = { { 0, 1 }, { T, 1 }, { T, 0 }, { 1, 0 } }
  model:load { node = a, force = times(-F, across), history = pulse }
  model:load { node = b, force = times(F, across), history = pulse }
  local mass = tube.area * 7850
  local inertia = mass * L ^ 3 / 12 + 7850 * tube.Ix * L
  local run = explicit(model, 0.1)
  local sum, count = 0, 0
  for _ in run:steps() do
    if run.time > 0.06 then
      local va, vb = { a:velocity(run) }, { b:velocity(run) }
      sum, count = sum + dot(plus(vb, times(-1, va)), across) / L, count + 1
    end
  end
  expect(run.verdict == "completed", "%s: %s", run.verdict, tostring(run.reason))
  return sum / count / (F * L * T / inertia)
end

case("a free bar takes the spin of m L^2 / 12 with 2, 4 and 8 elements", function()
  -- the section's rotary inertia is the polar one, twice rho I L, which is 0.2 % more; the bar's own bending, which is
  -- not over, adds as much. Halves of elements would give 0.66 with two
  for _, n in ipairs { 2, 4, 8 } do
    near(spin(n, { 1, 0, 0 }, { 0, 0, 1 }), 1, 0.006, "spin, " .. n .. " elements")
  end
end)

case("so it does in any direction, with an odd number of elements and in other formulations", function()
  local s = math.sqrt(1 / 3)
  local oblique, across = { s, s, s }, times(math.sqrt(0.5), { 1, -1, 0 })
  near(spin(2, oblique, across), 1, 0.006, "inclined")
  near(spin(2, { 0, 0, 1 }, { 1, 0, 0 }), 1, 0.006, "upright")
  near(spin(4, { 0, 1, 0 }, { 1, 0, 0 }), 1, 0.006, "about the other axis")
  near(spin(3, { 1, 0, 0 }, { 0, 0, 1 }, { formulation = "asi" }), 1, 0.006, "three elements")
  near(spin(5, { 1, 0, 0 }, { 0, 1, 0 }, { formulation = "conventional" }), 1, 0.006, "five elements")
  near(spin(2, { 1, 0, 0 }, { 0, 0, 1 }, { displacement = "small" }), 1, 0.006, "small displacement")
end)

case("a bar topples from 10 degrees in its time", function()
  -- sqrt(J / (m g L)) times the integral of d th / sqrt(cos th0 - cos th), J = m L^2 / 3; th = th0 + (90 - th0) u^2
  local L, th0 = 3, math.rad(10)
  local mass = tube.area * L * 7850
  local range, wanted, parts = math.pi / 2 - th0, 0, 20000
  for i = 1, parts do
    local u = (i - 0.5) / parts
    wanted = wanted + 2 * u * range / parts / math.sqrt(math.cos(th0) - math.cos(th0 + range * u * u))
  end
  wanted = wanted * math.sqrt((mass * L ^ 2 / 3 + 7850 * tube.Ix * L) / (mass * g * L))
  for _, n in ipairs { 2, 8 } do
    local model, top = scenes.cantilever { model = { elements_per_member = n, plasticity = false }, length = L,
      along = { math.sin(th0), 0, math.cos(th0) }, foot = "xyz rx rz", member = { section = tube, material = steel } }
    model:gravity { 0, 0, -g }
    local run = explicit(model, 1.3 * wanted)
    local landed = falls_to_zero(run, function() return top.z + select(3, top:displacement(run)) end)
    near(landed or 0 / 0, wanted, 0.002 * wanted, "time, " .. n .. " elements") -- 0.1 % by the bar's bending
  end
end)

case("a rod that hangs from a pin swings as 2 pi sqrt(2 L / 3 g)", function()
  local L, amplitude = 2, 0.1
  for _, n in ipairs { 2, 3, 6 } do
    local model, low = scenes.cantilever { length = L, along = { math.sin(amplitude), 0, -math.cos(amplitude) },
      model = { elements_per_member = n, plasticity = false, formulation = n == 3 and "asi" or nil },
      foot = "xyz rx rz", member = { section = rod, material = steel } }
    model:gravity { 0, 0, -g }
    local wanted = 2 * math.pi * math.sqrt(2 * L / (3 * g)) * (1 + amplitude ^ 2 / 16)
    local run = explicit(model, 0.8 * wanted)
    local down = falls_to_zero(run, function() return low.x + (low:displacement(run)) end)
    -- a quarter of the period; the rod is so slender that it bends by 0.1 % on its way. Halves would give 6 % more
    near(4 * (down or 0 / 0), wanted, 0.003 * wanted, n .. " elements")
  end
end)

-- A free bar along `axis` that spins about `about`; the element breaks at that end after 1 ms. Returns its end nodes,
-- the run at its end, the bar's length, its spin and the time since the break.
local function break_in_flight(axis, about, element, side, elements, velocity)
  local L, w, at = 2, 20, 1e-3
  local model = hinge.model { elements_per_member = elements or 2, plasticity = false }
  local a, b = model:node(times(-L / 2, axis)), model:node(times(L / 2, axis))
  local up = math.abs(axis[3]) > 0.9 and { 1, 0, 0 } or { 0, 0, 1 }
  model:member { a, b, section = tube, material = steel, up = up }
  for sign, node in pairs { [-1] = a, [1] = b } do
    local v = plus(velocity or { 0, 0, 0 }, times(sign * L / 2, cross(times(w, about), axis)))
    model:velocity(node, v, times(w, about))
  end
  model:fracture(function(s) return s.time > at and s.element == element and s["end"] == side end)
  local run = explicit(model, 0.021):finish()
  expect(run.verdict == "completed", "%s: %s", run.verdict, tostring(run.reason))
  return a, b, run, L, w, at
end

-- Where the end of a rigid bar is at time t that turns by w about its centre, which moves with v.
local function place(centre, v, half, axis, about, w, t)
  local turned = plus(times(math.cos(w * t), axis), times(math.sin(w * t), cross(about, axis)))
  return plus(plus(centre, times(t, v)), times(half, turned))
end
local function distance(node, run, wanted)
  local ux, uy, uz = node:displacement(run)
  local d = plus({ node.x + ux, node.y + uy, node.z + uz }, times(-1, wanted))
  return math.sqrt(dot(d, d))
end

case("a bar that spins and parts in the middle flies on as two halves with the momentum of each", function()
  local s = math.sqrt(1 / 3)
  local oblique, across = { s, s, s }, times(math.sqrt(0.5), { 1, -1, 0 })
  for _, way in ipairs { { { 1, 0, 0 }, { 0, 0, 1 } }, { { 0, 0, 1 }, { 0, 1, 0 } }, { oblique, across } } do
    for _, which in ipairs { { 1, 2 }, { 2, 1 } } do
      local axis, about = way[1], way[2]
      local a, b, run, L, w, at = break_in_flight(axis, about, which[1], which[2])
      -- where and how the halves are at the break
      local turned = place({ 0, 0, 0 }, { 0, 0, 0 }, 1, axis, about, w, at)
      local speed = times(w * L / 4, cross(about, turned))
      local t = run.time - at
      local of_b = place(times(L / 4, turned), speed, L / 4, turned, about, w, t)
      -- the ends have gone 0.5 m; a bar that spins is longer by 1e-4, and the step after `at` is the one that breaks.
      -- With the lumps of single elements it is 0.06 m
      near(distance(b, run, of_b), 0, 0.004, "the end of one half")
      near(distance(a, run, times(-1, of_b)), 0, 0.004, "and of the other")
      local e = run.energy
      expect(e.fracture_kinetic > -1e-9 * e.initial and e.fracture_kinetic < 1e-3 * e.initial, "%g J of %g J",
        e.fracture_kinetic, e.initial)
      near(run.energy_error, 0, 1e-4, "energy error")
    end
  end
end)

case("a bar of which an element breaks at the bar's end spins and flies on as it did", function()
  for _, elements in ipairs { 2, 4 } do
    local v = { 5, -3, 8 }
    local _, b, run, L, w = break_in_flight({ 1, 0, 0 }, { 0, 1, 0 }, 1, 1, elements, v)
    local wanted = place({ 0, 0, 0 }, v, L / 2, { 1, 0, 0 }, { 0, 1, 0 }, w, run.time)
    near(distance(b, run, wanted), 0, 0.002, elements .. " elements")
  end
end)

case("what is left of a cantilever that breaks in the middle weighs on its foot as a bar of that length", function()
  local L = 2
  local model, tip, _, foot = scenes.cantilever { model = { plasticity = false }, length = L,
    member = { section = tube, material = steel } }
  model:gravity { 0, 0, -g }
  model:fracture(function(s) return s.time > 1e-3 and s.element == 1 and s["end"] == 2 end)
  local run = explicit(model, 0.2):finish()
  local weight = tube.area * L / 2 * 7850 * g
  local force, moment = select(3, foot:reaction(run)), select(5, foot:reaction(run))
  near(force, weight, 1e-9 * weight, "force")
  near(moment, -weight * L / 4, 1e-9 * weight, "moment")
  -- the other half falls freely, its centre as a point does: it turns little
  near(select(3, tip:displacement(run)), -g * run.time ^ 2 / 2, 0.05 * g * run.time ^ 2 / 2, "fall")
  near(run.energy_error, 0, 1e-3, "energy error")
end)

case("a run goes on from statics under weight at rest, and what flies falls without bending", function()
  for _, weight in ipairs { "members", "nodes" } do
    for _, n in ipairs { 2, 3, 4 } do
      local of = { section = tube, material = steel }
      local model = scenes.portal { width = 6, column = of, beam = of, model = { elements_per_member = n,
        weight = weight, formulation = n == 3 and "asi" or nil, plasticity = false } }
      model:gravity { 0, 0, -g }
      local run = explicit(model, 0.02, { from = model:static {}:finish(), rest = false }):finish()
      local mass = 12 * tube.area * 7850
      -- statics ends at 1e-9 of the forces: 1e-9 g for a quarter of a swing of 0.1 s
      near(run.energy.kinetic, 0, mass * (1e-8 * g * 0.1) ^ 2, weight .. ", " .. n .. " elements")
    end
  end
  local model, b = scenes.cantilever { length = 4, foot = false, member = { section = tube, material = steel } }
  model:gravity { 0, 0, -g }
  local run = explicit(model, 0.2):finish()
  near(select(3, b:displacement(run)), -g * run.time ^ 2 / 2, 1e-11, "fall")
  near(run.energy.elastic, 0, 1e-12, "energy of bending")
end)

case("what falls flat on a layer stops and comes back without bending", function()
  -- its lumps are pressed by areas that are as they are; with halves of elements its middle would go on by itself
  for _, n in ipairs { 2, 4 } do
    local model = hinge.model { elements_per_member = n, plasticity = false }
    local a, b = model:node { 0, 0, 0.06 }, model:node { 3, 0, 0.06 }
    model:member { a, b, section = tube, material = steel, group = "bar" }
    model:velocity("bar", { 0, 0, -3 })
    model:ground { restitution = 1 }
    local run = explicit(model, 0.01)
    local bent = 0
    for _ in run:steps() do bent = support.largest_of(bent, run.energy.elastic) end
    near(bent / run.energy.initial, 0, 1e-6, n .. " elements: energy of bending")
    near(select(3, a:velocity(run)), 3, 0.03, n .. " elements: it comes back")
  end
end)

case("a run that goes on by another method has the same mass, which falls and swings as before", function()
  for _, order in ipairs { { "explicit", "newmark" }, { "newmark", "explicit" } } do
    local model, b, bar = scenes.cantilever { model = { plasticity = false }, length = 2, foot = false,
      member = { section = tube, material = steel } }
    model:fracture(function(s) return s.time > 1e-3 and s.element == 1 and s["end"] == 2 end)
    model:velocity(bar, { 0, 0, 10 })
    local first = explicit(model, 0.003, { integrator = order[1] }):finish()
    local next = explicit(model, 0.003, { integrator = order[2], from = first }):finish()
    local kinetic = 0.5 * tube.area * 2 * 7850 * 100
    near(next.energy.initial, kinetic, 1e-9 * kinetic, order[1] .. ", then " .. order[2])
    near(select(3, b:displacement(next)), 0.06, 1e-9, "way")
  end
end)
checks.done()

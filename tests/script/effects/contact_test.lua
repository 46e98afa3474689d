-- Contact of members (rule surface): one contact of two members is one spring, wherever their elements end; what slides
-- past a node keeps its force, its friction and its energy; one event for one contact.
--
-- Run: lua5.4 tests/script/effects/contact_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "contact"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near
local pi, largest_of = math.pi, support.largest_of

-- Equally deep pairs of elements share one spring with a private part of 4 % (contact/shared_spring.h): any number of
-- them is at most 4.2 % stiffer than one pair, so a blow lasts up to 2.1 % shorter.
local shorter, step = 0.021, 0.003

local side, steel = 0.1, hinge.material { E = 206e9, density = 7850 }
local square = hinge.section.solid { width = side, depth = side }

--- A bar from a to b. at: declared nodes between, as parts of its length, which make it several members.
local function bar(model, a, b, o)
  local nodes, parts = { model:node(a) }, { 0 }
  for _, part in ipairs(o.at or {}) do parts[#parts + 1] = part end
  parts[#parts + 1] = 1
  for i = 2, #parts do
    local x = {}
    for d = 1, 3 do x[d] = a[d] + parts[i] * (b[d] - a[d]) end
    nodes[i] = model:node(x)
    model:member { nodes[i - 1], nodes[i], section = square, material = steel, group = o.group, elements = o.elements,
      up = { 0, 0, 1 } }
  end
  return nodes
end

--- A bar of 1 m comes down on one of 1.4 m at 0.1 m/s. Both are free, and so soft is the spring that they stay rigid.
--- Returns how long they are in touch over pi sqrt(m / k), the numbers of events, the energy error, and the part of
--- momentum that is lost.
local soft, v = 1e5, 0.1
local function blow(lower, upper, o)
  o = o or {}
  local model = hinge.model { displacement = "large" }
  local up = side + 1e-6
  local angle = o.angle or pi / 2
  local function lie()
    bar(model, { -0.7, 0, 0 }, { 0.7, 0, 0 }, { at = lower.at, elements = lower.elements, group = "lower" })
  end
  local function fall()
    local c, s = math.cos(angle) / 2, math.sin(angle) / 2
    bar(model, { -c, -s, up }, { c, s, up }, { at = upper.at, elements = upper.elements, group = "upper" })
  end
  if o.upper_first then fall() lie() else lie() fall() end
  model:velocity("upper", { 0, 0, -v })
  local from, to, begun, ended = nil, nil, 0, 0
  model:contact { between = { "lower", "upper" }, stiffness = soft,
    on_contact = function(e) begun, from = begun + 1, from or e.time end,
    on_release = function(e) ended, to = ended + 1, e.time end }
  local m1, m2 = steel.density * side ^ 2 * 1.4, steel.density * side ^ 2
  local whole = pi * math.sqrt(m1 * m2 / (m1 + m2) / soft)
  local run = model:dynamic { integrator = o.integrator, dt = o.dt or 2e-5, duration = 1.3 * whole, record = false }
  local before = run:momentum().linear[3]
  run:finish()
  expect(run.verdict == "completed", run.reason)
  return (to or math.huge) / whole - (from or 0) / whole, begun, ended, math.abs(run.energy_error),
    math.abs(run:momentum().linear[3] / before - 1)
end

local places = { -- where the crossing is in the elements of a bar
  { "at a node inside a member", { elements = 2 } }, { "inside an element", { elements = 2, at = { 0.4 } } },
  { "at a node of two members", { elements = 2, at = { 0.5 } } },
  { "at a node, many elements", { elements = 8 } },
}

case("a blow lasts as long wherever the elements of both bars end", function()
  for _, lower in ipairs(places) do
    for _, upper in ipairs(places) do
      for _, angle in ipairs { pi / 2, 0.5 } do
        local lasts, begun, ended, energy, lost = blow(lower[2], upper[2], { angle = angle })
        local what = ("lower %s, upper %s, %.2g rad"):format(lower[1], upper[1], angle)
        expect(lasts > 1 - shorter - step and lasts < 1 + step, ("%s: %.4f of pi sqrt(m / k)"):format(what, lasts))
        expect(begun == 1 and ended == 1, ("%s: %d and %d events"):format(what, begun, ended))
        expect(energy < 1e-4, ("%s: energy error %g"):format(what, energy))
        expect(lost < 1e-9, ("%s: momentum %g"):format(what, lost))
      end
    end
  end
end)

case("a blow lasts as long in any order of declaration, and with explicit steps", function()
  for _, place in ipairs(places) do
    local straight = blow(place[2], place[2])
    local swapped, begun = blow(place[2], place[2], { upper_first = true })
    expect(math.abs(swapped - straight) < 1e-3, ("%s: %g and %g"):format(place[1], straight, swapped))
    equal(begun, 1, place[1])
    local explicit = blow(place[2], place[2], { integrator = "explicit", dt = "auto" })
    expect(math.abs(explicit - straight) < step, ("%s: %g and %g"):format(place[1], straight, explicit))
  end
end)

case("parallel bars have one spring over their length, with any number of elements", function()
  for _, lower in ipairs { 2, 4, 8 } do
    for _, upper in ipairs { 2, 6, 8 } do
      local lasts, _, _, energy = blow({ elements = lower }, { elements = upper }, { angle = 0 })
      local what = ("%d on %d elements"):format(upper, lower)
      expect(lasts > 1 - shorter - step and lasts < 1 + step, ("%s: %.4f of pi sqrt(m / k)"):format(what, lasts))
      expect(energy < 1e-3, ("%s: energy error %g"):format(what, energy))
    end
  end
end)

--- A bar slides across the nodes of a rail with friction. Returns its way, lowest place, events, run.
local mu, g = 0.3, 9.80665
local function slide(o)
  local model = hinge.model {}
  local nodes = {}
  for i = 0, 4 do nodes[i] = model:node { 0.1 * i, 0, 0 } end
  for i = 0, 4 do
    model:fix(nodes[i], "all")
    if i > 0 then
      model:member { nodes[i - 1], nodes[i], section = square, material = steel, elements = 2, group = "rail" }
    end
  end
  local a, b = model:node { 0.12, -0.5, side + 1e-7 }, model:node { 0.12, 0.5, side + 1e-7 }
  model:member { a, b, section = square, material = steel, group = "slider", elements = o.elements }
  model:fix({ a, b }, "rx ry rz") -- it does not roll
  model:fix(a, "y")
  model:velocity("slider", { 1, 0, 0 })
  model:gravity { 0, 0, -g }
  local begun, ended = 0, 0
  model:contact { between = { "rail", "slider" }, friction = mu, stiffness = 1e7,
    on_contact = function() begun = begun + 1 end, on_release = function() ended = ended + 1 end }
  local run = model:dynamic { dt = o.dt, duration = 0.4, integrator = o.integrator, record = false }
  local height = run:probe { node = a, "uz" }
  run:finish()
  return a:displacement(), height.min, begun - ended, run
end

case("a bar that slides past nodes keeps its force, its friction and its energy", function()
  local weight = steel.density * side ^ 2 * g
  for _, o in ipairs { { elements = 2, dt = 2e-5 }, { elements = 4, dt = 1e-5 },
    { elements = 2, dt = "auto", integrator = "explicit" } } do
    local way, lowest, open, run = slide(o)
    local what = ("%s, %d elements"):format(o.integrator or "newmark", o.elements)
    -- friction acts after the first half of the first step with contact
    checks.near(way / (1 / (2 * mu * g)), 1, 1e-3, what .. ": way")
    -- it begins to touch at rest: sinks by twice its weight over k, never less deep than one spring; 1e-7 is the gap
    checks.near(-lowest / (2 * weight / 1e7), 1, shorter * 2 + 0.02, what .. ": deepest")
    expect(math.abs(run.energy_error) < 1e-8, what .. ": energy error " .. run.energy_error)
    checks.near(run.energy.contact_released / (steel.density * side ^ 2 / 2), 1, 1e-3, what .. ": heat")
    expect(open == 0 or open == 1, what .. ": every contact that ended had begun")
  end
end)

-- A mass that falls on the middle of a pinned beam through a spring k, against the modal series of the beam ----------
local E, rho, h, L, fall = 210e9, 7850, 0.04, 2, 2 -- Pa, kg/m^3, m, m, m/s
local EI, A = E * h ^ 4 / 12, h * h

--- Parts of the mass' energy and momentum that are gone as it leaves the beam: 40 modes by central differences.
local function series(M, k)
  local modes, w, q, p = 40, {}, {}, {}
  for i = 1, modes do
    w[i] = ((2 * i - 1) * pi / L) ^ 2 * math.sqrt(EI / (rho * A))
    q[i], p[i] = 0, 0
  end
  local dt, y, s, touched, t = 0.02 / w[modes], 0, fall, false, 0
  while t < 0.02 do
    t, y = t + dt, y + dt * s
    local u = 0
    for i = 1, modes do
      q[i] = q[i] + dt * p[i]
      u = u + q[i] * (i % 2 == 1 and 1 or -1)
    end
    local f = k * largest_of(0, y - u)
    if f == 0 and touched then break end
    touched, s = touched or f > 0, s - dt * f / M
    for i = 1, modes do
      p[i] = p[i] + dt * (f * (i % 2 == 1 and 1 or -1) / (rho * A * L / 2) - w[i] ^ 2 * q[i])
    end
  end
  return 1 - (s / fall) ^ 2, 1 - s / fall
end

--- Whether a run warns of elements that are too few, and why: "bending wave" or "between the nodes".
local function too_few(run)
  local text = table.concat(run.warnings, "\n")
  return text:match "bending wave" or text:match "struck (between the nodes)"
end

--- The same by elements; third, whether the run warns of too few.
local function by_elements(M, k, n)
  local model, r = hinge.model { mass = "cubic" }, 0.02
  local a, b = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(a, "xyz rx")
  model:fix(b, "y,z")
  model:member { a, b, section = hinge.section.solid { width = h, depth = h }, elements = n, group = "beam",
    material = hinge.material { E = E, nu = 0.3, density = rho } }
  local up = h / 2 + r + 1e-6
  local p, q = model:node { L / 2, -0.1, up }, model:node { L / 2, 0.1, up }
  model:member { p, q, section = hinge.section.solid { width = 2 * r, depth = 2 * r }, group = "mass", up = { 0, 0, 1 },
    material = hinge.material { E = 2e12, nu = 0.3, density = M / (0.2 * 4 * r * r) } }
  model:velocity("mass", { 0, 0, -fall })
  local over
  model:contact { between = { "beam", "mass" }, stiffness = k, on_release = function() over = true end }
  local run = model:dynamic { dt = 5e-6, duration = 0.02, record = false }
  while not over and run.time < 0.02 - 1e-9 do run:step() end
  local _, _, v1 = p:velocity()
  local _, _, v2 = q:velocity()
  local left = -(v1 + v2) / 2 / fall
  return 1 - left ^ 2, 1 - left, too_few(run) == "bending wave"
end

case("a blow passes energy and momentum of the modal series, or the run says that elements are too few", function()
  -- by theory a quarter of the wave is 0.36, 0.25 and 0.14 m long
  for _, row in ipairs { { 5, 5e6, 8 }, { 1, 5e6, 16 }, { 1, 5e7, 16 } } do
    local M, k, enough = table.unpack(row)
    local energy, momentum = series(M, k)
    for _, n in ipairs { enough // 4, enough } do
      local e, m, few = by_elements(M, k, n)
      local what = ("%g kg, k = %g, %d elements"):format(M, k, n)
      equal(few, n < enough, what .. ": warns")
      -- shear flexibility and the mass' own stiffness are not in the series: 2 %
      local off = largest_of(math.abs(e / energy - 1), math.abs(m / momentum - 1))
      expect(n < enough and off > 0.1 or n >= enough and off < 0.02, ("%s: off by %.1f %%"):format(what, 100 * off))
    end
  end
end)

-- What a blow gives to a member, with twice the elements ----------

local yields = hinge.material { E = 206e9, density = 7850, yield_stress = 275e6 }

--- A beam falls at 15 m/s across one that is clamped; returns the parts of its momentum and energy that are gone.
local function beams(n)
  local section, model = hinge.section.named "HEB 200", hinge.model { elements_per_member = n }
  local a, b = model:node { -2, 0, 0 }, model:node { 2, 0, 0 }
  model:fix({ a, b }, "all")
  model:member { a, b, section = section, material = yields, group = "below", up = { 0, 0, 1 } }
  model:member { model:node { 0.1, -2, 0.201 }, model:node { 0.1, 2, 0.201 }, section = section, material = yields,
    group = "above", up = { 0, 0, 1 } }
  model:velocity("above", { 0, 0, -15 })
  model:contact { between = { "below", "above" } }
  local run = model:dynamic { dt = "auto", duration = 0.03, record = false }
  local before = run:momentum "above"
  run:finish()
  expect(run.verdict == "completed" and math.abs(run.energy_error) < 1e-3, "%d elements: %s %s", n, run.verdict,
    run.reason)
  local after = run:momentum "above"
  return 1 - after.linear[3] / before.linear[3], 1 - after.kinetic / before.kinetic, too_few(run)
end

case("two beams that collide and yield: 4 and 8 elements pass the same to 5 %, and 4 warn of their waves", function()
  local momentum, energy, why = beams(4)
  equal(why, "bending wave", "4 elements warn")
  local momentum_8, energy_8, why_8 = beams(8)
  equal(why_8, nil, "8 elements warn")
  near(momentum / momentum_8, 1, 0.05, "momentum")
  near(energy / energy_8, 1, 0.05, "energy")
end)

--- A mass on a stiff bar comes slowly against a column of 4 m, `height` above its foot, with a node there or not.
local function rammed(o)
  local model = hinge.model {}
  local foot, head = model:node { 0, 0, 0 }, model:node { 0, 0, 4 }
  model:fix(foot, "all")
  model:fix(head, "x,y,rz")
  local ends = { foot, head }
  if o.node then table.insert(ends, 2, model:node { 0, 0, o.height }) end
  for i = 2, #ends do
    model:member { ends[i - 1], ends[i], section = hinge.section.named "HEB 300", material = yields, up = { 1, 0, 0 },
      elements = o.elements, group = "column" }
  end
  local p, q = model:node { -0.26, -0.3, o.height }, model:node { -0.26, 0.3, o.height }
  model:member { p, q, section = hinge.section.solid { width = 0.2, depth = 0.2 }, group = "ram",
    material = hinge.material { E = 2e12, density = 5000 / (0.6 * 0.2 ^ 2) } }
  model:velocity("ram", { 2, 0, 0 })
  model:contact { between = { "column", "ram" }, stiffness = 2e7 }
  local run = model:dynamic { dt = "auto", duration = 0.02, record = false } -- not yet back
  local before = run:momentum "ram"
  run:finish()
  return 1 - run:momentum "ram".linear[1] / before.linear[1], too_few(run), run
end

case("a slow blow inside a long element misses what it bends there, and the run says so", function()
  local right = rammed { height = 1, elements = 8, node = true }
  local off = rammed { height = 1, elements = 2 }
  expect(math.abs(off / right - 1) > 0.05, "2 elements: momentum off by %.3f", off / right - 1)
  for _, o in ipairs { { 2, 1, false, "between the nodes" }, { 2, 2.6, false, "between the nodes" },
    { 2, 2, false }, { 4, 1, false }, { 2, 1, true }, { 2, 2.6, true } } do
    local elements, height, node, why = table.unpack(o)
    local what = ("%d elements, struck at %g m%s"):format(elements, height, node and ", where a node is" or "")
    local passed, found = rammed { height = height, elements = elements, node = node }
    equal(found, why, what .. ": warns")
    if height == 1 and not why then near(passed / right, 1, 0.05, what .. ": momentum, of that with 8 elements") end
  end
end)

case("momentum and energy of groups add up to those of the run, and a group's mass is by hand", function()
  local _, _, run = rammed { height = 1, elements = 2 }
  local all, column, ram = run:momentum(), run:momentum "column", run:momentum "ram"
  near(ram.mass, 5000, 1e-9, "mass of the ram")
  for _, of in ipairs { "mass", "kinetic" } do
    near((column[of] + ram[of]) / all[of], 1, 1e-12, of)
  end
  near(all.kinetic / run.energy.kinetic, 1, 1e-12, "kinetic energy, of the energy balance's")
  for d = 1, 3 do
    for _, of in ipairs { "linear", "angular" } do
      near(column[of][d] + ram[of][d], all[of][d], 1e-9 * 1e4, ("%s momentum, %d"):format(of, d))
    end
  end
end)

case("a point mass counts in the group of all members at its node, and in none where groups meet", function()
  local model = hinge.model {}
  local nodes = {}
  for i = 0, 2 do nodes[i] = model:node { i, 0, 0 } end
  for i = 1, 2 do
    model:member { nodes[i - 1], nodes[i], section = square, material = steel, group = i == 1 and "left" or "right",
      ends = i == 2 and { a = hinge.joint { Mx = { stiffness = 1e5 } } } or nil }
  end
  model:mass { node = nodes[0], mass = 10 }
  model:mass { node = nodes[1], mass = 100 }
  model:velocity("left", { 0, 1, 0 })
  model:velocity("right", { 0, 1, 0 })
  local run = model:dynamic { dt = 1e-4, duration = 1e-3, record = false }
  local own = steel.density * side ^ 2
  for group, mass in pairs { left = own + 10, right = own } do
    local of = run:momentum(group)
    near(of.mass, mass, 1e-9, group .. ": mass")
    near(of.linear[2], mass, 1e-9, group .. ": momentum")
    near(of.kinetic, mass / 2, 1e-9, group .. ": energy")
  end
  near(run:momentum().mass, 2 * own + 110, 1e-9, "mass of all")
end)

checks.done()

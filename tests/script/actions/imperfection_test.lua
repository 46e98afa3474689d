-- model:imperfection: structures out of plumb, bowed members and shapes of modes, against closed forms of second order.
-- The imperfection is free of stress, and what does not fit is refused.
--
-- Run: lua5.4 tests/script/actions/imperfection_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "imperfection"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local E, L = 210e9, 5
local pipe = hinge.section.pipe { diameter = 0.1683, thickness = 0.008 }
local steel = hinge.material { E = E, density = 7850 }
local euler = math.pi ^ 2 * E * pipe.Ix / L ^ 2

-- A pinned column along z of n elements, with a load N at its head.
local function column(n, N, options, material)
  local model = hinge.model(options or {})
  local foot, head = model:node { 0, 0, 0 }, model:node { 0, 0, L }
  local member = model:member { foot, head, section = pipe, material = material or steel, elements = n,
    up = { 0, 1, 0 } }
  model:fix(foot, "x,y,z,rz")
  model:fix(head, "x,y")
  if N then model:load { node = head, force = { 0, 0, -N } } end
  return model, member, foot, head
end

-- The largest moment of a member, about x and about y.
local function largest_moments(member, run, parts)
  local Mx, My = 0, 0
  for _, row in ipairs(member:along(run, parts)) do
    Mx, My = support.largest_of(Mx, math.abs(row.Mx)), support.largest_of(My, math.abs(row.My))
  end
  return Mx, My
end

-- The moment in the middle of a member.
local function middle(member, run, n)
  local at = member:along(run, 2 * n)
  local largest = 0
  for _, row in ipairs(at) do largest = support.largest_of(largest, math.sqrt(row.Mx ^ 2 + row.My ^ 2)) end
  return largest
end

case("a bow is free of stress, and lies along the axis that is asked for", function()
  for _, axis in ipairs { "x", "y" } do
    local model = column(8)
    model:imperfection { bow = 1 / 100, axis = axis }
    near(model:static { steps = 1 }:finish().energy.elastic, 0, 1e-12, "elastic energy, J")
    local pressed, member = column(8, 1e3)
    pressed:imperfection { bow = 1 / 100, axis = axis }
    local straight, bent = largest_moments(member, pressed:static { steps = 1 }:finish())
    if axis == "y" then bent, straight = straight, bent end
    near(bent, 1e3 * L / 100, 0.005 * 1e3 * L / 100, axis .. ": N e0, N m")
    near(straight, 0, 1e-6, axis .. ": across it, N m")
  end
end)

case("a bowed column: the moment grows by 1 / (1 - N / N_E)", function()
  local n = 16
  for _, part in ipairs { 0.2, 0.5, 0.8 } do
    local N, e0 = part * euler, L / 1000
    local model, member = column(n, N)
    model:imperfection { bow = 1 / 1000 }
    local run = model:static { steps = 8 }:finish()
    equal(run.verdict, "completed", "the run")
    -- a sine bow stays one: M = N e0 / (1 - N / N_E); shear strain lowers N_E by N_E / (G A_s). The polygon of n / 2
    -- chords has (pi / n)^2 / 3 less of the growth
    local shear = 1 + euler / (steel.G * pipe.shear_area_y)
    local exact = N * e0 / (1 - part * shear)
    local lost = (math.pi / n) ^ 2 / 3 * (exact - N * e0)
    -- Euler's load of the model is right to 0.1 %
    near(middle(member, run, n), exact - lost, (0.002 + 0.001 * part / (1 - part)) * exact, part .. " N_E, N m")
  end
end)

case("a frame out of plumb: N phi h at the foot, and more by the second order", function()
  local h, phi, N = 4, 1 / 200, 200e3
  local model, head, member, foot = scenes.cantilever { length = h, along = { 0, 0, 1 }, force = { 0, 0, -N },
    member = { section = pipe, material = steel, elements = 8 } }
  model:imperfection { sway = phi, direction = { 0, 2, 0 } }
  near(head.y, phi * h, 1e-12, "the head, m")
  near(foot.y, 0, 1e-12, "the foot, m")
  local run = model:static { steps = 4 }:finish()
  local k = math.sqrt(N / (E * pipe.Ix))
  -- a leaning cantilever under a vertical load: M = N phi tan(k h) / k
  local wanted = N * phi * math.tan(k * h) / k
  local at_foot = member:forces(run)
  local first = support.largest_of(math.abs(at_foot.Mx), math.abs(at_foot.My))
  near(first, wanted, 0.01 * wanted, "the moment at the foot, N m")
end)

case("the sways and bows of EN 1993-1-1", function()
  local function lean(height, columns)
    local model = hinge.model {}
    model:node { 0, 0, 0 }
    local top = model:node { 0, 0, height }
    model:imperfection { sway = { standard = "EN 1993-1-1", columns = columns } }
    return top.x / height
  end
  near(lean(3, 1), 1 / 200, 1e-15, "low")
  near(lean(6.25, 1), 0.8 / 200, 1e-15, "2 / sqrt(h)")
  near(lean(25, 3), 2 / 3 * math.sqrt(0.5 * (1 + 1 / 3)) / 200, 1e-15, "high, three columns")
  for curve, parts in pairs { a0 = { 300, 350 }, b = { 200, 250 }, d = { 100, 150 } } do
    for i, analysis in ipairs { "plastic", "elastic" } do
      local model, _, _, head = column(8, 1e3)
      model:imperfection { bow = { curve = curve, analysis = analysis } }
      local run = model:static { steps = 1 }:finish()
      local M = support.largest_of(largest_moments(model:members()[1], run))
      near(M, 1e3 * L / parts[i], 0.01 * 1e3 * L / parts[i], curve .. ", " .. analysis)
      equal(head.x, 0, "the ends stay")
    end
  end
end)

case("the shape of a mode: its largest displacement is as given, and the column follows it", function()
  local n = 16
  local model, member = column(n, 0.5 * euler)
  local mode = model:static { steps = 4 }:finish():buckling { n = 1 }[1]
  model:imperfection { mode = mode, largest = L / 250 }
  local run = model:static { steps = 8 }:finish()
  local N = 0.5 * euler
  local shear = 1 + euler / (steel.G * pipe.shear_area_y)
  local wanted = N * L / 250 / (1 - 0.5 * shear)
  near(middle(member, run, n), wanted, 0.01 * wanted, "the moment in the middle, N m")

  -- of a frame that sways: nodes move too
  local of_all = { section = pipe, material = steel, up = { 0, 1, 0 } }
  local frame, nodes = scenes.portal { column = of_all, beam = of_all, heads = "y" }
  local b, c = nodes[2], nodes[3]
  for _, node in ipairs { b, c } do frame:load { node = node, force = { 0, 0, -1e5 } } end
  local sway = frame:static { steps = 2 }:finish():buckling { n = 1 }[1]
  local u = { sway:displacement(b) }
  frame:imperfection { mode = sway, largest = 0.02 }
  near(math.abs(b.x), 0.02, 2e-4, "the corner moves by what was given, m")
  expect(b.x * u[1] > 0, "in the direction of the mode: %g and %g", b.x, u[1])
  local pushed = frame:static { steps = 2 }:finish()
  expect((b:displacement(pushed)) * b.x > 0, "under load it leans farther")
end)

-- The limit load over N0 of a pinned HEB 200 of 5 m, bowed by curve c, of so many members in line.
local function in_line(parts, options)
  local heb = hinge.section.named "HEB 200"
  local hard = hinge.material { E = E, nu = 0.3, density = 7850, yield_stress = 355e6 }
  local model, nodes, to = hinge.model {}, {}, options.along or { 0, 0, 5 }
  for i = 0, parts do nodes[i] = model:node { to[1] * i / parts, to[2] * i / parts, to[3] * i / parts } end
  for _, i in ipairs(options.order or { 1, 2, 3 }) do
    if i <= parts then
      local a, b = nodes[i - 1], nodes[i]
      if options.reversed == i then a, b = b, a end
      model:member { a, b, section = heb, material = hard, elements = 24 // parts, up = options.up }
    end
  end
  local r = { "rx", "ry", "rz" } -- no twist
  model:fix(nodes[0], "x,y,z," .. (to[3] > 0 and r[3] or to[1] > 0 and r[1] or r[2]))
  model:fix(nodes[parts], to[3] > 0 and "x,y" or to[1] > 0 and "y,z" or "x,z")
  local N0 = -heb.area * 355e6 / 5
  model:load { node = nodes[parts], force = { N0 * to[1], N0 * to[2], N0 * to[3] } }
  if options.sway then model:imperfection { sway = 1 / 1000 } end
  model:imperfection { bow = { curve = "c" }, axis = "x" }
  return model:static({ steps = 20, to_limit = true }):finish().factor
end

case("members in line are one column, in any order and direction", function()
  local one = in_line(1, {})
  -- curve c of EN 1993-1-1: 0.392
  near(one, 0.392, 0.02 * 0.392, "one member, over N0")
  for parts = 2, 3 do
    for _, options in ipairs { {}, { order = { 3, 1, 2 } }, { reversed = 2 }, { along = { 5, 0, 0 }, up = { 0, 1, 0 } },
      { along = { 0, 5, 0 } } } do
      -- the same nodes; a member that is reversed turns its pairs round
      near(in_line(parts, options), one, 1e-3 * one, parts .. " members, over N0")
    end
  end
  near(in_line(2, { sway = true }), in_line(1, { sway = true }), 1e-3 * one, "out of plumb, over N0")
end)

case("a second bow of members in line follows the straight column, not the first bow", function()
  local model = hinge.model {}
  local n = { model:node { 0, 0, 0 }, model:node { 0, 0, 2 }, model:node { 0, 0, 5 } }
  for i = 1, 2 do model:member { n[i], n[i + 1], section = pipe, material = steel, elements = 8, up = { 0, 1, 0 } } end
  model:imperfection { bow = 1 / 50, axis = "x" }
  model:imperfection { bow = 1 / 100, axis = "y" }
  near(math.abs(n[2].x), 5 / 50 * math.sin(0.4 * math.pi), 1e-12, "along x, m")
  near(math.abs(n[2].y), 5 / 100 * math.sin(0.4 * math.pi), 1e-12, "along y, m")
end)

-- A column of storeys of 4 m, held at the floors, of an HEB 160 about its weak axis; the limit load over N0.
local function storeys(count, options)
  local heb = hinge.section.named "HEB 160"
  local hard = hinge.material { E = E, nu = 0.3, density = 7850, yield_stress = 355e6 }
  local model, nodes = hinge.model {}, {}
  for i = 0, count do nodes[i] = model:node { 0, 0, 4 * i } end
  for k = 1, count do
    local i = options.downwards and count + 1 - k or k
    local a, b = nodes[i - 1], nodes[i]
    if options.reversed == i then a, b = b, a end
    model:member { a, b, section = heb, material = hard, elements = 8, up = { 0, 1, 0 }, group = "columns",
      release = options.pinned and i == 2 and { a = "My" } or nil }
  end
  model:fix(nodes[0], "xyz rz")
  for i = 1, count do model:fix(nodes[i], i < count and options.beams and "y" or "x,y") end
  if options.beams then -- the floors are held by members
    for i = 1, count - 1 do
      local far = model:node { 6, 0, 4 * i }
      model:fix(far)
      model:member { nodes[i], far, section = pipe, material = steel, release = { a = { "Mx", "My" } } }
    end
  end
  model:load { node = nodes[count], force = { 0, 0, -heb.area * 355e6 } }
  model:imperfection { bow = { curve = "c" }, axis = "x", sign = options.sign,
    group = "columns" }
  return model:static({ steps = 20, to_limit = true }):finish().factor
end

case("storeys bow to opposite sides, as they buckle: the load of one storey", function()
  -- curve c at a slenderness of 1.29: 0.392
  local one = storeys(1, {})
  near(one, 0.392, 0.02 * 0.392, "one storey, over N0")
  for count = 2, 3 do
    for _, options in ipairs { {}, { downwards = true }, { reversed = 2 }, { beams = true } } do
      near(storeys(count, options), one, 0.005 * one, count .. " storeys, over N0")
    end
  end
  near(storeys(2, { pinned = true }), one, 0.005 * one, "a joint that is free at the floor, over N0")
  expect(storeys(2, { sign = "same" }) > 1.4 * one, "to the same side they hold each other")
end)

case("imperfections add up", function()
  local model, _, _, head = column(2)
  model:imperfection { sway = 1 / 100 }
  model:imperfection { sway = 1 / 200, direction = { 0, 1, 0 } }
  model:imperfection { sway = 1 / 100 }
  near(head.x, 0.02 * L, 1e-12, "along x, m")
  near(head.y, 0.005 * L, 1e-12, "along y, m")
end)

case("a bowed column fails at the load at which its middle is fully plastic by eq 14", function()
  local hard = hinge.material { E = E, density = 7850, yield_stress = 235e6 }
  local model = column(16, pipe.area * 235e6, { interaction = "paper" }, hard)
  model:imperfection { bow = 1 / 300 }
  local run = model:static { steps = 40, to_limit = true }:finish()
  local N0, M0 = pipe.area * 235e6, pipe.Zx * 235e6
  local low, high = 0, 1
  for _ = 1, 60 do
    local n = (low + high) / 2
    local M = n * N0 * L / 300 / (1 - n * N0 / euler)
    if n * N0 < euler and n ^ 2 + (M / M0) ^ 2 < 1 then low = n else high = n end
  end
  near(run.factor, low, 0.02 * low, "the limit load over N0")
end)

case("what does not fit is refused, and changes nothing", function()
  local model, _, _, head = column(2, 1e3)
  local one = hinge.model { formulation = "conventional" }
  one:member { one:node { 0, 0, 0 }, one:node { 1, 0, 0 }, section = pipe, material = steel, elements = 1 }
  local function refused(m, options, words)
    checks.refused(words, m.imperfection, m, options)
  end
  refused(model, {}, "none of 'sway', 'bow' and 'mode' is given")
  refused(model, { sway = 0.01, bow = 0.01 }, "give one of 'sway', 'bow' and 'mode', and call it again")
  refused(model, { sway = 0.01, axis = "x" }, "field 'axis' is given beside sway; belongs to 'bow'")
  refused(model, { sway = 0.01, direction = { 1, 0, 1 } }, "must be horizontal")
  refused(model, { sway = { standard = "EN 1993-1-1" }, base = L }, "must be below the highest node")
  refused(hinge.model {}, { sway = 0.01 }, "has no nodes yet")
  refused(hinge.model {}, { bow = 0.01 }, "there is no such member yet")
  refused(model, { sway = { standard = "EN 1993" } }, "'EN 1993'")
  refused(model, { bow = 0.5 }, "part of the member's length")
  refused(model, { bow = { curve = "e" } }, "'e'")
  refused(model, { bow = { analysis = "plastic" } }, "'curve' is missing")
  refused(model, { bow = 0.01, sign = "both" }, "'both'")
  refused(model, { sway = 0.01, sign = "same" }, "field 'sign' is given beside sway; belongs to 'bow'")
  refused(one, { bow = 0.01 }, "needs 8 elements or more in each member")
  local auto = hinge.model { elements_per_member = "auto" }
  auto:member { auto:node { 0, 0, 0 }, auto:node { 1, 0, 0 }, section = pipe, material = steel }
  refused(auto, { bow = 0.01 }, "member 1 has 'auto'")
  refused(model, { mode = 3, largest = 1 }, "must be a mode of run:modes")
  refused(model, { sway = 0 / 0 }, "sway")
  equal(head.x, 0, "nothing has moved")
  local run = model:static { steps = 1 }:finish()
  local mode = run:buckling { n = 1 }[1]
  refused(one, { mode = mode, largest = 0.01 }, "of another model")
  refused(model, { mode = mode }, "'largest' is missing")
  refused(model, { mode = mode, largest = 0.01 }, "needs 8 elements or more in that member; it has 2")
  model:imperfection { sway = 0.01 }
  checks.refused("moved nodes since", model.static, model, { from = run })
end)

checks.done()

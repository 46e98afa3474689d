-- Moving loads: a force on a simple beam against the modal sum of its closed form, on and after the beam, one and two
-- axles, one member and several; the impulse on a beam that nothing holds; influence lines of a simple and of a
-- continuous beam in closed form; wrong input is refused.
--
-- Run: lua5.4 tests/script/actions/moving_load_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local moving_load = require "hinge.actions.moving_load"
local checks = support.checks "moving load"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

-- Almost without shear strain, as in the closed forms.
local profile = hinge.section.named "HEB 300"
local section = hinge.section.general { area = profile.area, Ix = profile.Ix, Iy = profile.Iy, J = profile.J,
  shear_area_x = 10, shear_area_y = 10 }
local steel = hinge.material { E = 210e9, density = 7850 }
local L, F = 20, 50e3
local EI, mass = steel.E * section.Ix, 7850 * section.area -- N m^2, kg/m

-- A beam of n members along x, held at its supports ({ number of the node } = true, 0 to n) for bending in x and z.
local function beam(n, options, supports, turned)
  local model = hinge.model(options.model or { displacement = "small", mass = "cubic" })
  local nodes, members = {}, {}
  for i = 0, n do nodes[i] = model:node { L * i / n, 0, 0 } end
  for i = 1, n do
    local swap = turned and i % 2 == 0
    members[i] = model:member { nodes[swap and i or i - 1], nodes[swap and i - 1 or i], section = section,
      material = steel, up = { 0, 0, 1 }, elements = options.elements, group = "deck" }
  end
  for i = 0, supports and n or -1 do
    model:fix(nodes[i], supports[i] and (i == 0 and "x,y,z,rx,rz" or "y,z,rx,rz") or "y,rx,rz")
  end
  return model, nodes, members
end

-- Displacement downwards at x of a simple beam at rest over which axles pass: modes j with the frequency w and the
-- forced frequency W = j pi v / L; after an axle has left, its modes go on vibrating. Each mode is the solution of
-- q'' + w^2 q = 2 F / (mass L) sin(W t) with q = q' = 0 at the start. The same sum for one force is in L. Fryba,
-- Vibration of Solids and Structures under Moving Loads (the book was not at hand).
local function closed_form(x, t, speed, axles)
  local sum = 0
  for j = 1, 30 do
    local w, W = (j * math.pi / L) ^ 2 * math.sqrt(EI / mass), j * math.pi * speed / L
    for _, axle in ipairs(axles) do
      local since, crossing = t - axle.distance / speed, L / speed
      local c = 2 * axle.force / (mass * L * (w ^ 2 - W ^ 2))
      local s = since < crossing and since or crossing
      local q = c * (math.sin(W * s) - W / w * math.sin(w * s))
      if since > crossing then
        local rate = c * W * (math.cos(W * s) - math.cos(w * s))
        q = q * math.cos(w * (since - s)) + rate / w * math.sin(w * (since - s))
      end
      if since > 0 then sum = sum + q * math.sin(j * math.pi * x / L) end
    end
  end
  return sum
end

local one, two = { { force = F, distance = 0 } }, { { force = F, distance = 0 }, { force = 0.6 * F, distance = 4.3 } }

case("a force on a simple beam, against the closed form", function()
  local tried = {
    { n = 4, axles = one, speed = 30 }, { n = 4, axles = one, speed = 15 }, { n = 4, axles = two, speed = 30 },
    { n = 2, elements = 4, axles = one, speed = 30, parts = 20 }, { n = 4, axles = two, speed = 60, turned = true },
    { n = 8, elements = 4, axles = one, speed = 30, model = { displacement = "small" } },
  }
  for number, o in ipairs(tried) do
    local model, nodes, members = beam(o.n, o, { [0] = true, [o.n] = true }, o.turned)
    local traffic = moving_load { model = model, members = members, axles = o.axles, speed = o.speed, parts = o.parts }
    local length = L + (o.axles[2] and 4.3 or 0)
    near(traffic.leaves, length / o.speed, 1e-12, "time at which the last axle leaves")
    local run = model:dynamic { dt = 1e-3, duration = 1.3 * traffic.leaves, record = false }
    local probe = run:probe { node = nodes[o.n // 2], "uz" }
    run:finish()
    equal(run.verdict, "completed", run.reason)
    local errors, largest = 0, 0
    for i, t in ipairs(probe.time) do
      local wanted = closed_form(L / 2, t, o.speed, o.axles)
      errors = support.largest_of(errors, math.abs(-probe.value[i] - wanted))
      largest = support.largest_of(largest, math.abs(wanted))
    end
    expect(largest > 1e-3, "case %d: the beam bends", number)
    expect(errors < 0.01 * largest, "case %d: differs by %.2g %% of the largest value", number, 100 * errors / largest)
  end
end)

case("the impulse on a beam that nothing holds is force times crossing time", function()
  for _, o in ipairs { { axles = one, total = F }, { axles = two, total = 1.6 * F } } do
    local model, _, members = beam(3, { model = { displacement = "small" } }, nil, true)
    local traffic = moving_load { model = model, members = members, axles = o.axles, speed = 40, start = 0.05,
      direction = { -1, 2, 2 } }
    local run = model:dynamic { dt = 1e-3, duration = traffic.leaves + 0.05, record = false }:finish()
    local wanted = o.total * L / 40
    for i, part in ipairs { -1 / 3, 2 / 3, 2 / 3 } do
      near(run:momentum().linear[i], part * wanted, 1e-6 * wanted, "momentum, part " .. i)
    end
    equal(traffic:positions(0.05)[1], 0, "at the beginning of the line")
    equal(traffic:positions(0.05 - 1e-9)[1], false, "just before it")
    near(traffic:positions(traffic.leaves)[#o.axles] or -1, L, 1e-9, "the last one at its end")
    local at_half = traffic:positions(0.05 + 10 / 40)
    near(at_half[1], 10, 1e-9, "position of the first axle")
    if at_half[2] then near(at_half[2], 5.7, 1e-9, "position of the second axle") end
    equal(traffic:positions(0.04)[1], false, "before it comes")
  end
end)

case("places, and what is printed", function()
  local model = beam(2, {}, { [0] = true, [2] = true })
  local traffic = moving_load { model = model, group = "deck", axles = two, speed = 5, parts = 1 }
  equal(traffic.places, 3, "the nodes, with parts = 1")
  equal(#model:loads(), 3, "loads of nodes")
  equal(tostring(traffic), "2 axles along 20 m at 5 m/s, from 0 s to 4.86 s", "printed")
end)

case("influence lines of a simple beam", function()
  local model, nodes, members = beam(4, {}, { [0] = true, [4] = true })
  local lines = moving_load.influence { model = model, members = members, force = 1e3, read = function(run)
    return { left = select(3, nodes[0]:reaction(run)), moment = select(2, members[2]:forces(run)).Mx,
      sag = -1e6 * select(3, nodes[2]:displacement(run)) }
  end, parts = 4 }
  equal(#lines.positions, 17, "positions")
  equal(lines.left.name, "left", "name of a line")
  local sign = lines.moment.y[9] < 0 and -1 or 1
  for i, x in ipairs(lines.moment.x) do
    near(x, L * (i - 1) / 16, 1e-12, "position")
    local y = x < L / 2 and x or L - x
    near(lines.left.y[i], 1 - x / L, 1e-8, "reaction")
    near(sign * lines.moment.y[i], y / 2, 1e-8, "moment in the middle")
    near(lines.sag.y[i], 1e6 * y * (3 * L ^ 2 - 4 * y ^ 2) / (48 * EI), 1e-3 * 1e6 * L ^ 3 / (48 * EI),
      "sag in the middle")
  end
end)

case("the influence line of a middle support, beside other loads", function()
  local model, nodes = beam(4, {}, { [0] = true, [2] = true, [4] = true })
  model:case("dead"):load { group = "deck", q = { 0, 0, -20e3 } }
  model:load { node = nodes[1], force = { 0, 0, -5e3 } } -- acts in every run
  local function middle(run) return select(3, nodes[2]:reaction(run)) end
  local positions = { 0, 2.5, 5, 8, 10, 17.3, 20 }
  local lines = moving_load.influence { model = model, group = "deck", read = middle, positions = positions,
    loads = { dead = 1 }, from = nodes[0] }
  for i, s in ipairs(positions) do
    local x = (s <= 10 and s or 20 - s) / 10
    near(lines.value.y[i], x * (3 - x ^ 2) / 2, 2e-3, "force on the middle support at " .. s)
  end
  local again = moving_load.influence { model = model, group = "deck", read = middle, positions = { 5, 10 },
    loads = { dead = 0 } }
  near(again.value.y[1], 11 / 16, 2e-3, "a second call: P 11/16")
  equal(#model:cases(), 1 + 7 + 2, "load cases")
end)

case("wrong input is refused, and nothing is loaded", function()
  local model, nodes, members = beam(3, {}, { [0] = true, [3] = true })
  local function with(more)
    return scenes.with({ model = model, members = members, axles = one, speed = 10 }, more)
  end
  for words, options in pairs {
    ["takes a table of options, got 1"] = 1,
    ["field 'speed' is missing"] = { model = model, members = members, axles = one },
    ["field 'model' is missing"] = { members = members, axles = one, speed = 1 },
    ["give either 'members' or 'group'"] = { model = model, axles = one, speed = 1 },
    ["field 'speed' is 0 m/s; must be a number above 0 m/s"] = with { speed = 0 },
    ["field 'axles' is empty"] = with { axles = {} },
    ["axles[2]: field 'distance' is missing"] = with { axles = { { force = 1 }, { force = 1 } } },
    ["axles[1]: field 'force' is missing"] = with { axles = { { distance = 1 } } },
    ["axles[1]: field 'distance' is -1 m"] = with { axles = { { force = 1, distance = -1 } } },
    ["field 'case' is not there"] = with { case = "traffic" },
    ["field 'parts' is 0; must be a whole number of at least 1"] = with { parts = 0 },
    ["field 'direction' is {0, 0, 0}"] = with { direction = { 0, 0, 0 } },
    ["members 1 and 3, which are neighbours in the line, have no node in common"] = with {
      members = { members[1], members[3] } },
    ["field 'from' is node 4"] = with { from = nodes[3] },
  } do
    checks.refused(words, function() moving_load(options) end)
  end
  for words, more in pairs {
    ["field 'read' is missing"] = {},
    ["in field 'read' returned nil"] = { read = function() end },
    ["in field 'read' returned 'up' = true"] = { read = function() return { up = true } end },
    ["give either 'parts' or 'positions'"] = { read = function() return 1 end, parts = 2, positions = { 0, 1 } },
    ["field 'positions' is {0, 21}; must be two or more numbers"] = { read = function() return 1 end,
      positions = { 0, 21 } },
    ["field 'positions' is out of order at number 2"] = { read = function() return 1 end, positions = { 2, 1 } },
    ["no load case 'dead'"] = { read = function() return 1 end, loads = { dead = 1 }, parts = 1 },
  } do
    checks.refused(words, moving_load.influence, scenes.with({ model = model, members = members }, more))
  end
  expect(not pcall(function() return moving_load.influense end), "an unknown call")
  local loaded = false
  for _, load in ipairs(model:loads()) do loaded = loaded or load.case == nil end
  expect(not loaded, "nothing was loaded")
end)

checks.done()

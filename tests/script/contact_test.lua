-- Contact of members (rule surface): one contact of two members is one spring, wherever their elements end; what slides
-- past a node keeps its force, its friction and its energy; one event for one contact.
--
-- Run: lua5.4 tests/script/contact_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "contact"
local case, expect, equal = checks.case, checks.expect, checks.equal
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
  local function lie() bar(model, { -0.7, 0, 0 }, { 0.7, 0, 0 }, { at = lower.at, elements = lower.elements, group = "lower" }) end
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

checks.done()

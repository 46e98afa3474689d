-- Fracture by the rotation of a hinge and by the elongation of a member: the same motion breaks a member, however many
-- elements it has.
--
-- Run: lua5.4 tests/script/effects/hinge_limits_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "hinge limits"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local E, fy = 206e9, 235e6
local G = E / 2.6
local bar = hinge.section.solid { width = 0.03, depth = 0.02 }
local steel = hinge.material { E = E, nu = 0.3, density = 7850, yield_stress = fy }
local L, theta = 1, 0.05 -- m, rad

-- Turns a vector of the bar's axes (along, up, sideways) into space.
local function turned(v, axes)
  if not axes then return { v[1], v[3], v[2] } end
  local r = { 0, 0, 0 }
  for i, axis in ipairs(axes) do
    for c = 1, 3 do r[c] = r[c] + v[i] * axis[c] end
  end
  return r
end

-- A bar from 0 to `length`, driven slowly by its end or its middle. o: elements, clamped ("ab": both ends), at (part of
-- the length that is moved), direction (2 up, 3 sideways, 1 along), split (a node of the script at `at`), axes, ...
-- Returns the way (m) at which it breaks, the run and the members; nil where it holds.
local function driven(rule, o)
  local model = hinge.model { displacement = o.displacement or "small", elements_per_member = o.elements,
    formulation = o.formulation, interaction = o.interaction, p_delta = o.p_delta }
  local length, at, most = o.length or L, o.at or 1, o.most or 0.12
  local function node(x) return model:node(turned({ x, 0, 0 }, o.axes)) end
  local a, b = node(0), node(length)
  local up = turned({ 0, 1, 0 }, o.axes)
  local middle = at < 1 and node(at * length)
  local members = {}
  local function member(p, q)
    members[#members + 1] = model:member { p, q, section = o.section or bar, material = o.material or steel, up = up }
  end
  if middle then
    member(a, middle)
    if o.reversed then member(b, middle) else member(middle, b) end
  else
    member(a, b)
  end
  model:fix(a)
  if o.clamped == "ab" then model:fix(b) end
  local way = { 0, 0, 0 }
  for i, part in pairs(o.direction or { [2] = 1 }) do way[i] = part end
  local v = turned(way, o.axes)
  local speed = o.speed or 0.2 -- m/s
  local function path(part) return function(t) return part * speed * t end end
  model:move { node = middle or b, x = v[1] ~= 0 and path(v[1]) or nil, y = v[2] ~= 0 and path(v[2]) or nil,
    z = v[3] ~= 0 and path(v[3]) or nil }
  if rule then model:fracture(rule) end
  local run = model:dynamic { dt = o.dt or 1e-3, duration = most / speed, record = false, integrator = o.integrator }
  for _ in run:steps() do
    if run:count { state = "broken" } > 0 then return run.time * speed, run, members end
  end
  expect(run.verdict == "completed", "%s", run.reason or "")
  return nil, run, members
end

local counts = { 2, 4, 8, 16 }
local Z, I, As = { bar.Zx, bar.Zy }, { bar.Ix, bar.Iy }, { bar.shear_area_y, bar.shear_area_x }

-- Tip of a cantilever when its foot has turned by theta: elastic by P = M_p / L, and theta L.
local function tip(plane)
  local P = fy * Z[plane] / L
  return P * L ^ 3 / (3 * E * I[plane]) + P * L / (G * As[plane]) + theta * L
end

case("a cantilever breaks at the same way of its tip with 2 to 16 elements, about x and about y", function()
  for plane, name in ipairs { "hinge_rotation_x", "hinge_rotation_y" } do
    for _, n in ipairs(counts) do
      local broke = driven({ [name] = theta }, { elements = n, direction = { [plane + 1] = 1 } })
      near(broke or 0, tip(plane), 0.01 * tip(plane), ("%s, %d elements"):format(name, n))
    end
    local other = plane == 1 and "hinge_rotation_y" or "hinge_rotation_x"
    equal(driven({ [other] = 1e-3 }, { elements = 4, direction = { [plane + 1] = 1 } }), nil,
      "a limit of the other axis holds")
  end
end)

-- How many elements have broken.
local function broken_elements(run)
  local count = 0
  for _, e in ipairs(run:read "broken") do count = count + (e == true and 1 or e or 0) end
  return count
end

case("a clamped beam breaks by the whole rotation of its middle hinge, which two members share", function()
  -- Three hinges. The middle one turns by 2 v / (L / 2), twice as far as those at the ends: it breaks first. Elastic:
  -- each half bends like an S by a shear of 2 M_p / (L / 2).
  local half = L / 2
  local Q = 2 * fy * Z[1] / half
  local wanted = Q * half ^ 3 / (12 * E * I[1]) + Q * half / (G * As[1]) + theta * half / 2
  for _, o in ipairs { { elements = 2 }, { elements = 4 }, { elements = 8 }, { elements = 4, reversed = true },
      { elements = 2, displacement = "large", p_delta = "chord" } } do
    o.clamped, o.at, o.most, o.dt = "ab", 0.5, 0.04, 5e-4
    local name = ("two members of %d elements%s%s"):format(o.elements, o.reversed and ", one reversed" or "",
      o.displacement and ", large displacement" or "")
    local broke, run = driven({ hinge_rotation_x = theta }, o)
    near(broke or 0, wanted, (o.displacement and 0.1 or 0.01) * wanted, name) -- large: the beam is pulled as well
    if run then equal(broken_elements(run), 1, name .. ": elements that break") end
  end
end)

case("a beam that fails under a load in its middle breaks at the same time: its hinge is inside", function()
  -- Pinned ends, half as much load again as it carries. Both halves turn about the hinge.
  local at = {}
  for _, n in ipairs { 2, 4, 8 } do
    local model = hinge.model { elements_per_member = n, displacement = "small" }
    local a, b = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
    model:fix(a, "xyz rx rz")
    model:fix(b, "yz rx rz")
    local beam = model:member { a, b, section = bar, material = steel, up = { 0, 0, 1 } }
    model:load { member = beam, force = { 0, 0, -1.5 * 4 * fy * Z[1] / L }, at = 0.5 }
    model:fracture { hinge_rotation_x = 4 * theta }
    local run = model:dynamic { dt = 2e-5, duration = 0.1, record = false }
    for _ in run:steps() do
      if broken_elements(run) > 0 then break end
    end
    at[#at + 1] = run.time
    equal(broken_elements(run), 1, n .. " elements: those that break")
  end
  near(at[1], at[3], 0.1 * at[3], "2 and 8 elements: the inertia of two halves, which bend otherwise before they turn")
  near(at[2], at[3], 0.01 * at[3], "4 and 8 elements")
end)

case("a bar in tension breaks at the same elongation with 1 to 16 elements", function()
  local limit = 0.02
  for _, o in ipairs { { elements = 1, formulation = "asi" }, { elements = 2 }, { elements = 4 }, { elements = 16 },
      { elements = 4, displacement = "large" }, { elements = 4, integrator = "explicit", dt = 5e-6, speed = 5 },
      { elements = 3, formulation = "conventional" } } do
    o.direction, o.most = { 1 }, 0.05
    local broke, run = driven({ elongation = limit }, o)
    local wanted = limit + fy / E * L
    near(broke or 0, wanted, 0.01 * wanted, o.elements .. " elements, " .. (o.integrator or o.formulation or "newmark"))
    if run then equal(broken_elements(run), 1, o.elements .. " elements: those that break") end
  end
  equal(driven({ elongation = limit }, { elements = 4, direction = { -1 }, most = 0.05 }), nil,
    "a bar that is pressed has no elongation")
end)

case("a rotation limit holds in any direction of space, in statics, explicit steps and other elements", function()
  local c, q = math.cos(0.4), math.sin(0.4)
  local axes = { { c * 0.8, q, c * 0.6 }, { -q * 0.8, c, -q * 0.6 }, { -0.6, 0, 0.8 } }
  local wanted = tip(1)
  for name, o in pairs { ["turned in space"] = { elements = 4, axes = axes },
      ["downwards"] = { elements = 4, direction = { [2] = -1 } },
      ["large displacement"] = { elements = 4, displacement = "large" },
      ["explicit"] = { elements = 2, integrator = "explicit", dt = 4e-6, speed = 1 },
      ["asi"] = { elements = 8, formulation = "asi" },
      ["exact"] = { elements = 4, interaction = "exact" } } do
    local broke = driven({ hinge_rotation_x = theta }, o)
    near(broke or 0, wanted, (name == "explicit" and 0.03 or 0.01) * wanted, name)
  end
  local last
  for _, n in ipairs { 4, 8, 16 } do -- its hinge is in the middle of the first element
    last = driven({ hinge_rotation_x = theta }, { elements = n, formulation = "conventional" })
  end
  near(last or 0, wanted, 0.03 * wanted, "conventional, 16 elements")
end)

case("biaxial bending breaks where one of the rotations reaches its limit", function()
  local at = {}
  for _, n in ipairs { 2, 8 } do
    local read = {}
    local broke = driven({ hinge_rotation_x = theta, hinge_rotation_y = 0.03,
      where = "all", rule = function(s) if s.node == 1 then read = { s.hinge_rotation_x, s.hinge_rotation_y } end end },
      { elements = n, direction = { [2] = 1, [3] = 0.8 }, displacement = "small" })
    at[#at + 1] = broke
    expect(broke and (math.abs(read[1]) > 0.99 * theta or math.abs(read[2]) > 0.99 * 0.03),
      "%d elements: breaks at %s with %s, %s rad", n, broke, read[1], read[2])
  end
  near(at[1] or 0, at[2] or 1, 0.01 * at[2], "2 and 8 elements")
end)

case("a support between two members leaves each side a hinge of its own", function()
  -- Two spans, whose far ends rise alike: on a pin the beam goes on, and its hinge turns by 2 u / L. Clamped, each side
  -- turns by u / L, and both break.
  local function rises(fixed)
    local model = hinge.model { displacement = "small", elements_per_member = 2 }
    local a, b, c = model:node { -L, 0, 0 }, model:node { 0, 0, 0 }, model:node { L, 0, 0 }
    model:fix(b, fixed)
    for _, ends in ipairs { { a, b }, { b, c } } do
      model:member { ends[1], ends[2], section = bar, material = steel, up = { 0, 0, 1 } }
    end
    for _, far in ipairs { a, c } do
      model:fix(far, "y rx rz")
      model:move { node = far, z = function(t) return 0.1 * t end }
    end
    model:fracture { hinge_rotation_x = theta }
    local run = model:dynamic { dt = 1e-3, duration = 1.2, record = false }
    for _ in run:steps() do
      if broken_elements(run) > 0 then break end
    end
    return 0.1 * run.time, broken_elements(run)
  end
  local elastic = tip(1) - theta * L
  local whole, one = rises "xyz rx rz"
  near(whole, elastic + theta / 2 * L, 0.01 * whole, "on a pin: one hinge of both sides")
  equal(one, 1, "on a pin: elements that break")
  local each, both = rises "all"
  near(each, elastic + theta * L, 0.01 * each, "clamped: a hinge a side")
  equal(both, 2, "clamped: elements that break")
end)

-- A cantilever with a blow at its tip: yields at its foot and swings.
local function struck(rule, o)
  o = o or {}
  local model, tip_node, member = scenes.cantilever { length = L,
    model = { elements_per_member = o.elements or 2, p_delta = o.p_delta },
    member = { section = bar, material = o.material or steel, up = { 0, 0, 1 }, group = "bar" } }
  model:mass { node = tip_node, mass = 20 }
  model:velocity(tip_node, { 0, 0.3, -(o.speed or 3) })
  if rule then model:fracture(rule) end
  local run = model:dynamic { dt = o.dt or 2e-4, duration = o.duration or 0.1, record = false,
    integrator = o.integrator }
  return run, member, model
end

case("limits that are never reached change no bit", function()
  for _, o in ipairs { {}, { integrator = "explicit" }, { elements = 4, p_delta = "chord" } } do
    if o.integrator then o.duration, o.dt = 0.02, 5e-6 end
    local without = struck({ curvature_x = 1e9 }, o):finish()
    local far = struck({ curvature_x = 1e9, hinge_rotation_x = 1e9, hinge_rotation_y = 1e9, elongation = 1e9 }, o)
    far:finish()
    local alone = struck({ hinge_rotation_x = 1e9 }, o):finish()
    equal(far.hash, without.hash, "with curvature beside it")
    equal(alone.hash, without.hash, "alone")
    expect(without.energy.plastic > 0, "the bar yields")
  end
end)

case("a function that reads the rotation breaks the same element at the same step as the limit", function()
  for _, n in ipairs { 2, 4 } do
    local run = struck({ hinge_rotation_x = 0.04 }, { elements = n }):finish()
    local by_rule = struck({ rule = function(s) return math.abs(s.hinge_rotation_x) >= 0.04 end },
      { elements = n }):finish()
    equal(run:count { state = "broken" }, 1, "it breaks")
    equal(by_rule.hash, run.hash, n .. " elements: rule")
  end
end)

case("other options go with the limits", function()
  local function broken(rule, o) return struck(rule, o):finish():count { state = "broken" } end
  equal(broken { hinge_rotation_x = 0.04, plastic_only = true }, 1, "plastic_only")
  equal(broken { hinge_rotation_x = 0.04, tension_only = true, strain_measure = "section" }, 1, "tension_only, section")
  equal(broken { hinge_rotation_x = 10, curvature_x = 0.05 }, 1, "beside a curvature")
  equal(broken { hinge_rotation_x = 0.04, curvature_x = 1e6 }, 1, "beside a curvature far away")
  equal(broken { hinge_rotation_x = 10, rule = function(s) return math.abs(s.hinge_rotation_x) > 0.04 end }, 1,
    "beside a function")
  equal(broken { hinge_rotation_x = 0.04, rule = function() return false end }, 1, "beside a function that says no")
  equal(broken { hinge_rotation_x = 0.04, group = "bar" }, 1, "of a group")
  local weak = hinge.material { E = E, nu = 0.3, density = 7850 }
  equal(broken({ hinge_rotation_x = 1e-6 }, { material = weak }), 0, "a bar that cannot yield has no hinge")
  local hard = hinge.material { E = E, nu = 0.3, density = 7850, yield_stress = fy, hardening = { tangent = 2e9 } }
  equal(broken({ hinge_rotation_x = 0.03 }, { material = hard }), 1, "with hardening")
  for _, bad in ipairs { "hinge_rotation_x", "hinge_rotation_y", "elongation" } do
    checks.refused(bad, struck, { [bad] = 0 })
  end
end)

case("a hinge that has turned too far in statics breaks in the first step of dynamics", function()
  local model, end_node = scenes.cantilever { length = L, model = { elements_per_member = 4 },
    member = { section = bar, material = steel, up = { 0, 0, 1 } }, force = { 0, 0, -100 } }
  model:fracture { hinge_rotation_x = theta }
  local rest = model:static { steps = 40, control = { node = end_node, "uz", to = -0.15 } }:finish()
  equal(rest.verdict, "completed", "statics: " .. tostring(rest.reason))
  equal(rest:count { state = "broken" }, 0, "statics breaks nothing")
  local run = model:dynamic { from = rest, dt = 1e-5, duration = 1e-5, record = false }:finish()
  equal(run:count { state = "broken" }, 1, "it breaks")
end)

case("a run from a checkpoint breaks at the same step", function()
  local path = os.tmpname()
  local limits = { hinge_rotation_x = 0.04, hinge_rotation_y = 0.04, elongation = 1 }
  local whole = struck(limits):finish()
  local half = struck(limits)
  while half.energy.plastic < 0.5 * whole.energy.plastic do half:step() end
  equal(half:count { state = "broken" }, 0, "the checkpoint is between yield and break")
  half:checkpoint(path)
  local resumed = struck(limits):resume(path):finish()
  equal(resumed.hash, whole.hash, "from the checkpoint")
  equal(resumed:count { state = "broken" }, 1, "it breaks")
  os.remove(path)
end)

case("a limit of curvature says which rotation it means, once, and only where hinges have formed", function()
  local function said(rule, o)
    local run = struck(rule, o):finish()
    local found = {}
    for _, w in ipairs(run.warnings) do
      if w:find("hinge rotation of", 1, true) then found[#found + 1] = w end
    end
    return found
  end
  local once = said { curvature_x = 0.5, curvature_y = 0.5 }
  equal(#once, 1, "said once")
  expect((once[1] or ""):find("curvature_x = 0.5 1/m is a hinge rotation of 0.25 rad over an element of 0.5 m; it "
    .. "follows the elements' length", 1, true), "%s", once[1])
  expect((said({ curvature_x = 0.5 }, { elements = 4 })[1] or ""):find("0.125 rad over an element of 0.25 m", 1, true),
    "with four elements")
  equal(#said({ curvature_x = 0.5 }, { speed = 0.01 }), 0, "nothing yields: a curvature is M / (E I)")
  equal(#said { hinge_rotation_x = 0.5 }, 0, "limits of rotation")
end)

checks.done()

-- What a run completes with and no engineer meant: sections stronger than they can be, rules of fracture that nothing
-- comes to, shear that takes bending strength, perfect structures that nothing but rounding lets buckle. Each is named
-- by run.warnings, or is an error at its line; beside it a scene that has nothing.
-- (tests/script/program/check_test.lua has what is seen before a run.)
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "slips"
local case, expect, equal, near, refused = checks.case, checks.expect, checks.equal, checks.near, checks.refused

local steel, elastic = scenes.steel, scenes.elastic
local fy = steel.yield_stress

-- The warnings of a run that have each of these texts, one a line; and how many they are.
local function warned(run, ...)
  local lines = {}
  for _, warning in ipairs(run.warnings) do
    local has = true
    for _, text in ipairs { ... } do has = has and support.has(warning, text) end
    if has then lines[#lines + 1] = warning end
  end
  return table.concat(lines, "\n"), #lines
end

-- Eq 14 beside an axial force ---------------------------------------------------------------------------------------

-- A cantilever under N at its tip and a moment that takes it to the surface of eq 14, by statics and then a step of
-- dynamics. In small displacement its section forces are those, all along.
local function pressed(section, n, axis, dynamic, below)
  local m = (below or 1) * math.sqrt(1 - n ^ 2) * section["Z" .. axis] * fy
  local model = scenes.cantilever { model = { displacement = "small", interaction = "paper" }, length = 2,
    along = { 0, 0, 1 }, member = { section = section, material = steel, up = { 0, 1, 0 }, group = "columns" },
    force = { 0, 0, -n * section.plastic_area * fy },
    moment = { axis == "x" and m or 0, axis == "y" and m or 0, 0 } }
  local run = model:static { steps = 3, to_limit = true }:finish()
  if dynamic then run = model:dynamic { from = run, dt = 1e-4, duration = 2e-3 }:finish() end
  return run
end

local heb, ipe = { depth = 0.3, width = 0.3, web = 0.011, flange = 0.019 },
  { depth = 0.3, width = 0.15, web = 0.0071, flange = 0.0107 }
local rhs, pipe = { depth = 0.2, width = 0.1, thickness = 0.008 }, { diameter = 0.2, thickness = 0.005 }
case("sections for which eq 14 is unsafe are warned of, with by how much", function()
  -- Per cent by which the moment of eq 14 is more than the exact one at N / N0 = 0.2, 0.3 and 0.6.
  local known = { { "h", heb, "x", 9, 21, 73 }, { "h", ipe, "x", 5, 11, 58 }, { "box", rhs, "y", 6, 14, 62 },
    { "pipe", pipe, "x", 3, 7, 36 } }
  for _, row in ipairs(known) do
    local kind, axis = row[1], row[3]
    local section = hinge.section[kind](row[2])
    for i, n in ipairs { 0.2, 0.3, 0.6 } do
      local about_x, about_y = section:reduced_moments(n)
      local excess = 100 * (math.sqrt(1 - n ^ 2) / (axis == "x" and about_x or about_y) - 1)
      near(excess, row[3 + i], 0.5, ("%s about %s, N / N0 = %g"):format(kind, axis, n)) -- known to a whole per cent
      local warnings = pressed(section, n, axis, false, 0.9999).warnings
      local said = warnings[1] and tonumber(warnings[1]:match "(%d+) %% more than its exact plastic moment")
      if excess > 10.1 then
        near(said or 0, excess, 0.6, ("what the run says of %s about %s, N / N0 = %g"):format(kind, axis, n))
        expect(warnings[1]:find "^member 1 %(columns%), section " and warnings[1]:find("N / N0 = " .. n .. " ", 1, true)
          and warnings[1]:find(" of M" .. axis .. "0 at load factor 1:", 1, true) and #warnings == 1, "the words: %s",
          table.concat(warnings, "\n"))
      elseif excess < 9.9 then
        equal(#warnings, 0, ("warnings of %s about %s, N / N0 = %g"):format(kind, axis, n))
      end
    end
  end
  local h = hinge.section.h(heb)
  expect((pressed(h, 0.6, "x", true, 0.9999).warnings[1] or ""):find "at t = 0%.0%d+ s: 7%d %% more", "in dynamics: %s",
    pressed(h, 0.6, "x", true).warnings[1])
  equal(#pressed(h, 0.6, "x", false, 0.55).warnings, 0, "warnings below the exact moment")
  equal(#pressed(h, 0.2, "y").warnings, 0, "warnings about the weak axis, which eq 14 is safe for")
  local bare = hinge.section.general { area = h.area, Ix = h.Ix, Iy = h.Iy, J = h.J,
    plastic = { A = h.plastic_area, Zx = h.Zx, Zy = h.Zy, Zz = h.Zz }, size = { width = 0.3, depth = 0.3 } }
  equal(#pressed(bare, 0.6, "x").warnings, 0, "warnings of a section whose shape nobody knows")
  equal(bare:reduced_moments(0.3), nil, "its reduced moments")
  for _, wrong in ipairs { 1.5, -1.1, 0 / 0, "much" } do
    refused("section:reduced_moments: N / N0 is ", h.reduced_moments, h, wrong)
  end
end)

-- Rules of fracture --------------------------------------------------------------------------------------------------

-- A portal whose first column is to go, with what is declared of fracture.
local function portal(declare, pull)
  local model, bar = hinge.model(), hinge.section.solid { width = 0.1, depth = 0.1 }
  local a, b, c, d = model:node { 0, 0, 0 }, model:node { 0, 0, 3 }, model:node { 4, 0, 3 }, model:node { 4, 0, 0 }
  model:fix { a, d }
  model:member { a, b, section = bar, material = steel, group = { "lost", "columns" } }
  model:member { b, c, section = bar, material = steel, group = "beams" }
  model:member { c, d, section = bar, material = steel, group = { "columns", "right" } }
  if pull then model:load { node = b, force = { 0, 0, pull }, history = { { 0, 0 }, { 1e-3, 1 } } } end
  declare(model)
  return model:dynamic { dt = 1e-4, duration = 5e-3 }:finish()
end
local function remove(model) model:fracture { group = "lost", where = "all", rule = function() return true end } end
local function limits(model) model:fracture { curvature_x = 4, curvature_y = 4, axial_strain = 0.5 } end

case("a portal whose first column is to go has no warning of its rules", function()
  for _, order in ipairs { { remove, limits }, { limits, remove } } do
    local run = portal(function(model) for _, declare in ipairs(order) do declare(model) end end)
    equal(run:count { group = "lost", state = "broken" }, 1, "the column is lost, whatever the order of the rules")
    equal(run:count { state = "broken" }, 1, "and no other")
    equal(#run.warnings, 0, "nothing to warn of")
  end
end)

case("general fracture limits hold for the members of no group's rule", function()
  local function weak(model)
    model:fracture { group = "beams", axial_strain = 0.5 }
    model:fracture { axial_strain = 1e-5 }
  end
  equal(portal(weak):count { state = "broken" }, 0, "weak limits, and nothing that strains")
  local torn = portal(weak, 1e5)
  expect(torn:count { group = "columns", state = "broken" } > 0
    and torn:count { group = "beams", state = "broken" } == 0, "the general limits are the columns', not the beam's")
  refused({ "model:fracture: group 'columns' has all members of group 'lost', so this would replace the rule of ",
    "slips_test.lua:", " for all of them; declare the rule for group 'lost' after this one" }, function()
      portal(function(model)
        remove(model)
        model:fracture { group = "columns", axial_strain = 0.5 }
      end)
    end)
  refused({ "model:fracture: this would replace the function of ", "slips_test.lua:", "for the members of group 'lost'",
    "; where both are meant to hold, give the limits and the function in one call" }, function()
      portal(function(model)
        remove(model)
        model:fracture { group = "lost", axial_strain = 0.5 }
      end)
    end)
end)

case("rules that take each other's place are warned of", function()
  -- a narrower rule after a wider one, a rule given anew, and a function in the place of limits are as meant
  local run = portal(function(model)
    model:fracture { group = "columns", axial_strain = 0.5 }
    limits(model)
    limits(model)
    model:fracture { where = "all", rule = function() return false end }
    remove(model)
  end)
  equal(run:count { state = "broken" }, 1, "a rule for a part of a group")

  local function idle(says, declare, pull)
    local text, count = warned(portal(declare, pull), "model:fracture")
    expect(says and count == 1 and support.says(text, says) or count == 0 and not says,
      "warnings of an idle rule:\n    says   %s\n    wanted %s", text, says or "none")
  end
  local function asks(where)
    return function(model) model:fracture { group = "lost", where = where, rule = function() return false end } end
  end
  idle("the function of model:fracture at ...slips_test.lua:... was called 0 times: it is asked of sections that are "
    .. "fully plastic, and none was; where = 'all'? With it the function is called for every section at every step",
    asks())
  idle("...was called 0 times: it is asked of sections that have ever been fully plastic, and none was...",
    asks "yielded")
  idle(nil, asks "all")
  idle(nil, asks(), 4e6) -- pulled until it yields
  idle("the function of model:fracture at ... was called 0 times, for it holds for no member of group 'columns'; ...",
    function(model)
      model:fracture { group = "columns", where = "all", rule = function() end }
      remove(model)
      model:fracture { group = "right", where = "all", rule = function() return false end }
    end)
end)

-- Shear forces that take bending strength from sections, by EN 1993-1-1 6.2.6 and 6.2.8 ------------------------------

--- A cantilever pushed across its end until it bends without limit, at v V0 where M0 is reached: the warning, or nil.
--- `along`: the section's axis.
local function pushed(section, M0, V0, v, along, formulation)
  local length = M0 / (v * V0)
  local force = 1.5 * v * V0
  local model = scenes.cantilever { model = { displacement = "small", formulation = formulation }, length = length,
    member = { section = section, material = steel, up = { 0, 0, 1 } },
    force = { 0, along == "x" and force or 0, along == "y" and force or 0 } }
  local text = warned(model:static { to_limit = true, steps = 30, record = false }:finish(), "V / V0")
  return text ~= "" and text or nil
end

--- V / V0, the moment, and what is left of it, as the warning says; the first two to two digits.
local function numbers(text)
  local v, m = text:match "V / V0 = ([%d.]+) along %a and ([%d.]+) of"
  return tonumber(v), tonumber(m), tonumber(text:match "leaves ([%d.]+) of" or "nan")
end

local h = hinge.section.h(ipe)
local clear = 0.3 - 2 * 0.0107
local M0, V0 = fy * h.Zx, fy / math.sqrt(3) * 0.0071 * clear

case("the moment that shear leaves to an H: its web's part of the plastic modulus", function()
  local share = 0.0071 * clear ^ 2 / 4 / h.Zx
  local least, most = math.huge, 0
  for _, v in ipairs { 0.85, 0.95, 1.05 } do
    local text = pushed(h, M0, V0, v, "y")
    expect(text, "no warning at V / V0 = %g", v)
    local found, m, left = numbers(text)
    near(found, v, 0.6 * 10 ^ -(v > 1 and 1 or 2), "V / V0, two digits")
    near(m, 1, 0.006, "the plastic moment is reached")
    near(left, 1 - share * math.min(1, 2 * v - 1) ^ 2, 0.006, "what EN 1993-1-1 6.2.8(3) leaves")
    least, most = support.smallest_of(least, left), support.largest_of(most, left)
  end
  expect(least < most, "shear takes more as it grows")
end)

case("no warning where shear takes less than a tenth, and none of a beam of usual length", function()
  for _, v in ipairs { 0.1, 0.45, 0.6 } do
    local text = pushed(h, M0, V0, v, "y")
    expect(not text, "a warning at V / V0 = %g: %s", v, text)
  end
end)

case("no warning where the end of an element has more than M0 because its hinge is in the middle", function()
  local text = pushed(h, M0, V0, 0.5, "y", "conventional")
  expect(not text, "%s", text)
end)

case("more than the shear strength is said, also where the shape is not known", function()
  local general = hinge.section.general { area = h.area, Ix = h.Ix, Iy = h.Iy, J = h.J, shear_area_x = h.shear_area_x,
    shear_area_y = h.shear_area_y, plastic = { A = h.area, Zx = h.Zx, Zy = h.Zy, Zz = h.Zz } }
  local text = pushed(general, M0, V0, 1.3, "y")
  expect(text and text:find("more than its plastic shear strength", 1, true), "%s", text)
  expect(not pushed(general, M0, V0, 0.95, "y"), "a warning at V / V0 = 0.95")
end)

case("areas by EN 1993-1-1 6.2.6(3): all of a solid section, 2 A / pi of a pipe; an H's flanges along x", function()
  local solid = hinge.section.solid { width = 0.1, depth = 0.2 }
  local tube = hinge.section.pipe { diameter = 0.3, thickness = 0.01 }
  for _, of in ipairs {
    { solid, solid.Zx, solid.area, "y", "solid" },
    { tube, tube.Zx, 2 * tube.area / math.pi, "y", "pipe" },
    { h, h.Zy, 2 * 0.15 * 0.0107, "x", "flanges" },
  } do
    local section, Z, area, along, name = table.unpack(of)
    local text = pushed(section, fy * Z, fy / math.sqrt(3) * area, 0.8, along)
    expect(text, "%s: no warning at V / V0 = 0.8", name)
    local v, _, left = numbers(text)
    near(v, 0.8, 0.006, name .. ": V / V0")
    near(left, 1 - 0.6 ^ 2, 0.006, name .. ": what is left of the moment")
  end
end)

-- Perfect structures that can buckle in dynamics, while nothing but rounding starts it --------------------------------

local box = hinge.section.box { width = 0.1, depth = 0.2, thickness = 0.01 }
local ramp = { { 0, 0 }, { 0.5, 1 } }

local function told(run) return (select(2, warned(run, "nothing but rounding starts it", "imperfection"))) end

-- A straight cantilever or a pinned column under `part` of its Euler load, which grows for 0.5 s. `along`: its axis.
local function column(options)
  local model = hinge.model {}
  local along = options.along or { 0, 0, 1 }
  local function at(s) return { s * along[1], s * along[2], s * along[3] + 7 } end
  local foot, head = model:node(at(0)), model:node(at(4))
  model:fix(foot, options.pinned and "x,y,z,rz" or nil)
  if options.pinned then model:fix(head, "x,y") end
  model:member { foot, head, section = options.section or box, material = elastic, elements = options.elements or 4 }
  local I = math.min((options.section or box).Ix, (options.section or box).Iy)
  local load = -options.part * math.pi ^ 2 * elastic.E * I / (options.pinned and 4 or 8) ^ 2
  local across = (options.across or 0) * load
  model:load { node = head, history = ramp,
    force = { load * along[1] + across, load * along[2] + across, load * along[3] } }
  if options.push then model:load { node = head, force = { options.push, 0, 0 } } end
  if options.bow then model:imperfection { bow = options.bow, axis = "x" } end
  return model
end
local function run_of(model, settings)
  return model:dynamic(scenes.with({ dt = 1e-3, duration = 1, record = false }, settings)):finish()
end

case("a straight column beyond Euler's load is told, once, along any axis, by all integrators", function()
  for name, options in pairs {
    cantilever = {}, pinned = { pinned = true }, ["2 elements"] = { elements = 2 }, ["8 elements"] = { elements = 8 },
    ["along x"] = { along = { 1, 0, 0 } }, ["along y"] = { along = { 0, 1, 0 } },
    round = { section = hinge.section.round { diameter = 0.1 } },
    slender = { section = hinge.section.round { diameter = 0.03 } },
  } do
    for _, settings in ipairs { {}, { dt = "auto" }, { integrator = "explicit", dt = "auto" },
      { integrator = "energy-momentum" } } do
      options.part = 1.5
      local run = run_of(column(options), settings)
      equal(told(run), 1, ("%s, %s, dt = %s: %s %s"):format(name, settings.integrator, settings.dt, run.verdict,
        table.concat(run.warnings, "; ")))
    end
  end
end)

case("a column below Euler's load, in tension, or that is pushed or bowed has no such warning", function()
  for name, options in pairs {
    below = { part = 0.5 }, near = { part = 0.9 }, tension = { part = -3 },
    pushed = { part = 1.5, across = 1e-4 },
    ["round, pushed one way"] = { part = 1.5, push = 1, section = hinge.section.round { diameter = 0.1 } },
    bowed = { part = 1.5, elements = 8, bow = 1 / 500,
      section = hinge.section.round { diameter = 0.1 }, across = 1e-5 },
  } do
    local run = run_of(column(options))
    equal(told(run), 0, name .. ": " .. table.concat(run.warnings, "; "))
  end
  local small = scenes.cantilever { model = { displacement = "small" }, length = 4, along = { 0, 0, 1 },
    member = { section = box }, force = { 0, 0, -1e6 } }
  equal(told(run_of(small)), 0, "small displacement")
end)

-- A parabolic arch with pinned ends, in its plane, under a load at its crown; `aside` of that along x.
local function arch(load, aside)
  local model, nodes, n = hinge.model {}, {}, 16
  for i = 0, n do
    local x = -1 + 2 * i / n
    nodes[i] = model:node { 5 * x, 0, 1 - x * x }
    model:fix(nodes[i], (i == 0 or i == n) and "x,y,z,rx,rz" or "y,rx,rz")
    if i > 0 then
      model:member { nodes[i - 1], nodes[i], section = hinge.section.solid { width = 0.1, depth = 0.1 },
        material = elastic }
    end
  end
  model:load { node = nodes[n // 2], force = { aside * load, 0, -load }, history = ramp }
  return model
end

case("a symmetric arch that could sway is told, and one that is pushed aside is not", function()
  for what, of in pairs { free = { 4e5, 0, 0.55, 1 }, pushed = { 4e5, 1e-3, 0.55, 0 }, ["small load"] = { 1e5, 0, 1, 0 }
  } do
    local run = run_of(arch(of[1], of[2]), { duration = of[3] })
    equal(told(run), of[4], what .. ": " .. table.concat(run.warnings, "; "))
  end
end)

case("two bars under a load in their plane may sway out of it, and the run says so unless they are held", function()
  for _, held in ipairs { false, true } do
    local model = hinge.model {}
    local a, b, top = model:node { -1, 0, 0 }, model:node { 1, 0, 0 }, model:node { 0, 0, 2 }
    model:fix { a, b }
    if held then model:fix(top, "y,rx,rz") end
    for _, foot in ipairs { a, b } do
      model:member { foot, top, section = hinge.section.box { width = 0.05, depth = 0.05, thickness = 0.005 },
        material = elastic }
    end
    model:load { node = top, force = { 0, 0, -1e5 }, history = ramp }
    local run = run_of(model)
    expect(told(run) == (held and 0 or 1), "held %s: %s %s %s", held, run.verdict, run.reason,
      table.concat(run.warnings, "; "))
    equal(run.verdict, "completed", run.reason)
  end
end)

checks.done()

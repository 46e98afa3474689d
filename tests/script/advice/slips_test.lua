-- What a run completes with and no engineer meant: sections stronger than they can be, and rules of fracture that
-- nothing comes to. Each is named by run.warnings, or is an error at its line; beside it a scene that has nothing.
-- (tests/script/program/check_test.lua has what is seen before a run.)
--
-- Run: lua5.4 tests/script/advice/slips_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "slips"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }

-- Eq 14 beside an axial force ---------------------------------------------------------------------------------------

-- A cantilever under N at its tip and a moment that takes it to the surface of eq 14, by statics and then a step of
-- dynamics. In small displacement its section forces are those, all along.
local function pressed(section, n, axis, dynamic, below)
  local model = hinge.model { displacement = "small", interaction = "paper" }
  local foot, tip = model:node { 0, 0, 0 }, model:node { 0, 0, 2 }
  model:fix(foot)
  model:member { foot, tip, section = section, material = steel, up = { 0, 1, 0 }, group = "columns" }
  local N0, M0 = section.plastic_area * steel.yield_stress, section["Z" .. axis] * steel.yield_stress
  local m = (below or 1) * math.sqrt(1 - n ^ 2) * M0
  model:load { node = tip, force = { 0, 0, -n * N0 }, moment = { axis == "x" and m or 0, axis == "y" and m or 0, 0 } }
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
    local ok, message = pcall(h.reduced_moments, h, wrong)
    expect(not ok and message:find "section:reduced_moments: N / N0 is ", "%s: %s", wrong, message)
  end
end)

-- Rules of fracture --------------------------------------------------------------------------------------------------

-- A portal whose first column is to go, with what is declared of fracture.
local function portal(declare, pull)
  local model = hinge.model()
  local bar = hinge.section.solid { width = 0.1, depth = 0.1 }
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
  -- the general limits hold for the members of no group's rule
  local run = portal(function(model)
    model:fracture { group = "beams", axial_strain = 0.5 }
    model:fracture { axial_strain = 1e-5 }
  end)
  equal(run:count { group = "columns", state = "broken" } .. " " .. run:count { group = "beams", state = "broken" },
    "0 0", "weak limits, and nothing that strains")
  local torn = portal(function(model)
    model:fracture { group = "beams", axial_strain = 0.5 }
    model:fracture { axial_strain = 1e-5 }
  end, 1e5)
  expect(torn:count { group = "columns", state = "broken" } > 0 and torn:count { group = "beams", state = "broken" }
    == 0,
    "the general limits are the columns', not the beam's")

  local function refused(says, declare)
    local ok, message = pcall(portal, declare)
    expect(not ok and support.says(message, says), "refused:\n    says   %s\n    wanted %s", message, says)
  end
  refused("...model:fracture: group 'columns' has all members of group 'lost', so this would replace the rule of ..."
    .. "slips_test.lua:... for all of them; declare the rule for group 'lost' after this one", function(model)
      remove(model)
      model:fracture { group = "columns", axial_strain = 0.5 }
    end)
  refused("...model:fracture: this would replace the function of ...slips_test.lua:... for the members of group "
    .. "'lost'; "
    .. "where both are meant to hold, give the limits and the function in one call", function(model)
      remove(model)
      model:fracture { group = "lost", axial_strain = 0.5 }
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
    local warnings = {}
    for _, warning in ipairs(portal(declare, pull).warnings) do
      if warning:find "model:fracture" then warnings[#warnings + 1] = warning end
    end
    expect(says and #warnings == 1 and support.says(warnings[1], says) or not says and #warnings == 0,
      "warnings of an idle rule:\n    says   %s\n    wanted %s", table.concat(warnings, "\n           "), says
      or "none")
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

checks.done()

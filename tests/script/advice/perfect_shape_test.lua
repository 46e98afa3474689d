-- Perfect structures that can buckle in dynamics, while nothing but rounding starts it: the run warns of them and of no
-- others.
--
-- Run: lua5.4 tests/script/advice/perfect_shape_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "perfect shape"
local case, expect, equal = checks.case, checks.expect, checks.equal

local E = 210e9
local elastic = hinge.material { E = E, density = 7850 }
local box = hinge.section.box { width = 0.1, depth = 0.2, thickness = 0.01 }
local ramp = { { 0, 0 }, { 0.5, 1 } }

local function told(run)
  local times = 0
  for _, warning in ipairs(run.warnings) do
    if support.has(warning, "nothing but rounding starts it") and support.has(warning, "imperfection") then
      times = times + 1
    end
  end
  return times
end

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
  local load = -options.part * math.pi ^ 2 * E * I / (options.pinned and 4 or 8) ^ 2
  local across = (options.across or 0) * load
  model:load { node = head, history = ramp,
    force = { load * along[1] + across, load * along[2] + across, load * along[3] } }
  if options.push then model:load { node = head, force = { options.push, 0, 0 } } end
  if options.bow then model:imperfection { bow = options.bow, axis = "x" } end
  return model
end
local function run_of(model, settings)
  local all = { dt = 1e-3, duration = 1, record = false }
  for name, value in pairs(settings or {}) do all[name] = value end
  return model:dynamic(all):finish()
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
  local small = hinge.model { displacement = "small" }
  local foot, head = small:node { 0, 0, 0 }, small:node { 0, 0, 4 }
  small:fix(foot)
  small:member { foot, head, section = box, material = elastic }
  small:load { node = head, force = { 0, 0, -1e6 } }
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
  local run = run_of(arch(4e5, 0), { duration = 0.55 })
  equal(told(run), 1, table.concat(run.warnings, "; "))
  run = run_of(arch(4e5, 1e-3), { duration = 0.55 })
  equal(told(run), 0, "pushed: " .. table.concat(run.warnings, "; "))
  run = run_of(arch(1e5, 0))
  equal(told(run), 0, "small load: " .. table.concat(run.warnings, "; "))
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

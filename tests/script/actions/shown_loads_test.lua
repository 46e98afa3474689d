-- What pictures show of loads is what the supports hold: forces, and moments about the origin; in statics as much of a
-- load as acts, in dynamics by its history, and right after a checkpoint as before it.
--
-- Run: lua5.4 tests/script/actions/shown_loads_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "shown_loads"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local L = 2
local steel = hinge.material { E = 200e9, nu = 0.3, density = 7850 }
local section = hinge.section.box { width = 0.15, depth = 0.2, thickness = 0.01 }

-- Joints at `points`, one member between each and the next; fixed: by joint.
local function beam(points, fixed)
  local model = hinge.model()
  local s = { model = model, node = {}, member = {} }
  for i, p in ipairs(points) do s.node[i] = model:node(p) end
  for i, what in pairs(fixed) do model:fix(s.node[i], what) end
  for i = 1, #points - 1 do
    s.member[i] = model:member { s.node[i], s.node[i + 1], section = section, material = steel, up = { 0, 0, 1 } }
  end
  return s
end

local function shown(run)
  local pieces, sum = require "hinge.core".pieces(run), { 0, 0, 0, 0, 0, 0 }
  local function add(x, v, part, moment)
    for c = 1, 3 do
      local d, e = c % 3 + 1, (c + 1) % 3 + 1
      if moment then sum[3 + c] = sum[3 + c] + part * v[c]
      else sum[c], sum[3 + c] = sum[c] + part * v[c], sum[3 + c] + part * (x[d] * v[e] - x[e] * v[d]) end
    end
  end
  for _, load in ipairs(pieces.loads) do
    local bar, v = pieces.bars[load.bar], load.value
    local function at(n) return { pieces.nodes[n].x, pieces.nodes[n].y, pieces.nodes[n].z } end
    local a, b = at(bar and bar.a or load.node), bar and at(bar.b)
    local function between(p, q, t)
      return { p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2]), p[3] + t * (q[3] - p[3]) }
    end
    if not bar then add(a, v, 1, load.moment)
    elseif load.at >= 0 then add(between(a, b, load.at), v, 1, load.moment)
    else -- Simpson's rule is exact for what is linear times linear
      local long = math.sqrt((b[1] - a[1]) ^ 2 + (b[2] - a[2]) ^ 2 + (b[3] - a[3]) ^ 2)
      for t, part in pairs { [0] = 1 / 6, [0.5] = 4 / 6, [1] = 1 / 6 } do
        add(between(a, b, t), between(v, { v[4], v[5], v[6] }, t), part * long, load.moment)
      end
    end
  end
  return sum, #pieces.loads
end
case("the loads of a frame are those declared", function()
  local points = { { 1, 0, 0 }, { 1.5, 0.5, 2 }, { 3, 0.2, 2.4 } }
  local function same(declare, what, size_wanted)
    local s = beam(points, { "all", nil, "all" })
    declare(s)
    local run, held = s.model:static { steps = 1 }:finish(), { 0, 0, 0, 0, 0, 0 }
    for _, i in ipairs { 1, 3 } do
      local r, x = { run:reaction(s.node[i]) }, points[i]
      for c = 1, 3 do
        local d, e = c % 3 + 1, (c + 1) % 3 + 1
        held[c], held[3 + c] = held[c] + r[c], held[3 + c] + r[3 + c] + x[d] * r[e] - x[e] * r[d]
      end
    end
    local sum, count = shown(run)
    expect(count > 0, "%s: no load is shown", what)
    local size = math.sqrt(sum[1] ^ 2 + sum[2] ^ 2 + sum[3] ^ 2) + math.sqrt(sum[4] ^ 2 + sum[5] ^ 2 + sum[6] ^ 2)
    for c = 1, 6 do near(-held[c], sum[c], 1e-5 * size, ("%s is shown, component %d"):format(what, c)) end
    if size_wanted then near(math.abs(sum[3]), size_wanted, 1e-9, what .. ": its size") end
  end
  same(function(s) s.model:load { node = s.node[2], force = { 3, -4, -10 }, moment = { 1, 2, 3 } } end, "a node's load")
  same(function(s) s.model:load { member = s.member[1], q = { 1, 2, -30 } } end, "a spread load")
  same(function(s) s.model:load { member = s.member[1], q = { a = { 0, 0, -3 }, b = { 0, 0, -30 } },
    axes = "projected" } end, "a trapezoid per plan length")
  same(function(s) s.model:load { member = s.member[2], q = { a = { 3, -20, 1 } }, axes = "local" } end, "local axes")
  same(function(s) s.model:load { member = s.member[2], q = { 0, 0, -1 }, moment = { 5, 2, 1 } } end,
    "moments per length")
  same(function(s) s.model:load { member = s.member[2], at = 0.7, force = { 1, 2, -30 }, moment = { 1, 0, 2 } } end,
    "a load at a point")
  same(function(s) s.model:load { member = s.member[2], at = 1, force = { 0, 0, -30 } } end, "a load at an end", 30)
end)

case("in statics as much of a load is shown as acts", function()
  -- in statics as much of it as acts
  local s = beam({ { 0, 0, 0 }, { L, 0, 0 } }, { "all" })
  s.model:load { node = s.node[2], force = { 0, 0, -40 } }
  s.model:load { member = s.member[1], q = { 0, 0, -6 } }
  local run, seen = s.model:static { steps = 4 }, 0
  for step in run:steps() do
    near(shown(run)[3], -step.index / 4 * (40 + 6 * L), 1e-6, "shown of step " .. step.index)
    seen = seen + 1
  end
  equal(seen, 4, "steps")
end)

case("in dynamics a load is shown by its history", function()
  -- in dynamics by its history
  local s = beam({ { 0, 0, 0 }, { L, 0, 0 } }, { "all" })
  s.model:load { member = s.member[1], q = { 0, 0, -10 }, history = { { 0, 1 }, { 1e-3, 0.5 } } }
  s.model:load { node = s.node[2], force = { 0, 0, -8 }, history = { { 0, 0 }, { 2e-3, 1 } } }
  local run = s.model:dynamic { dt = 1e-4, duration = 1e-3 }
  run:finish()
  near(shown(run)[3], -0.5 * 10 * L - 0.5 * 8, 1e-6, "shown by the history")
end)

case("a run that goes on from a checkpoint shows its loads before its first step", function()
  -- where a run goes on from a checkpoint, before its first step: forces with their part of the load, and the loads
  local file = os.tmpname()
  local function swaying()
    local s = beam({ { 0, 0, 0 }, { L, 0, 0 } }, { "all" })
    s.model:load { member = s.member[1], q = { 0, 0, -1e3 }, history = { { 0, 0 }, { 1e-3, 1 } } }
    s.model:load { node = s.node[2], force = { 0, 0, -800 }, history = { { 0, 0 }, { 2e-3, 1 } } }
    s.model:gravity { 0, 0, -9.81 }
    return s.model:dynamic { dt = 1e-4, duration = 1e-3 }, s.member[1]
  end
  local before, its_member = swaying()
  for step in before:steps() do if step.index == 6 then break end end
  before:checkpoint(file)
  local after, other_member = swaying()
  after:resume(file)
  os.remove(file)
  equal(after.index, 6, "the step of the checkpoint")
  for _, side in ipairs { "a", "b" } do
    local x, y = its_member:forces(before), other_member:forces(after)
    for name, force in pairs(x[side] or x) do
      if type(force) == "number" then equal((y[side] or y)[name], force, ("%s at end %s"):format(name, side)) end
    end
  end
  expect(math.abs(its_member:forces(before).Mx) > 100, "there is a moment: %g", its_member:forces(before).Mx)
  local x, y = shown(before), shown(after)
  near(x[3], -0.6 * 1e3 * L - 0.3 * 800, 1e-6, "shown in step 6")
  for c = 1, 6 do equal(y[c], x[c], "shown right after a checkpoint, component " .. c) end
end)

checks.done()

-- What pictures show of loads is what the supports hold: forces, and moments about the origin; in statics as much of a
-- load as acts, in dynamics by its history, and right after a checkpoint as before it.
--
-- Run: lua5.4 tests/script/actions/shown_loads_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local vectors = require "hinge.library.vectors"
local checks = support.checks "shown_loads"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local L = 2
local steel = hinge.material { E = 200e9, nu = 0.3, density = 7850 }
local box = { section = hinge.section.box { width = 0.15, depth = 0.2, thickness = 0.01 }, material = steel,
  up = { 0, 0, 1 } }

local function cantilever() return scenes.cantilever { length = L, member = box } end

-- Adds a force v at x, or a moment v, to the sum of forces and of moments about the origin.
local function add(sum, x, v, part, moment)
  local arm = vectors.cross(x, v)
  for c = 1, 3 do
    if moment then sum[3 + c] = sum[3 + c] + part * v[c]
    else sum[c], sum[3 + c] = sum[c] + part * v[c], sum[3 + c] + part * arm[c] end
  end
end
local function shown(run)
  local pieces, sum = require "hinge.core".pieces(run), { 0, 0, 0, 0, 0, 0 }
  for _, load in ipairs(pieces.loads) do
    local bar, v = pieces.bars[load.bar], load.value
    local function at(n) return vectors.of_node(pieces.nodes[n]) end
    local a, b = at(bar and bar.a or load.node), bar and at(bar.b)
    if not bar then add(sum, a, v, 1, load.moment)
    elseif load.at >= 0 then add(sum, vectors.between(a, b, load.at), v, 1, load.moment)
    else -- Simpson's rule is exact for what is linear times linear
      local long = vectors.length(vectors.minus(b, a))
      for t, part in pairs { [0] = 1 / 6, [0.5] = 4 / 6, [1] = 1 / 6 } do
        local there = vectors.between(v, { v[4], v[5], v[6] }, t)
        add(sum, vectors.between(a, b, t), there, part * long, load.moment)
      end
    end
  end
  return sum, #pieces.loads
end
case("the loads of a frame are those declared", function()
  local points = { { 1, 0, 0 }, { 1.5, 0.5, 2 }, { 3, 0.2, 2.4 } }
  local function same(declare, what, size_wanted)
    local model = hinge.model()
    local n, m = {}, {}
    for i, point in ipairs(points) do n[i] = model:node(point) end
    for i = 1, 2 do m[i] = model:member(scenes.with(box, { n[i], n[i + 1] })) end
    model:fix { n[1], n[3] }
    declare(model, n[2], m)
    local run, held = model:static { steps = 1 }:finish(), { 0, 0, 0, 0, 0, 0 }
    for _, i in ipairs { 1, 3 } do
      local fx, fy, fz, mx, my, mz = run:reaction(n[i])
      add(held, points[i], { fx, fy, fz }, 1)
      add(held, points[i], { mx, my, mz }, 1, true)
    end
    local sum, count = shown(run)
    expect(count > 0, "%s: no load is shown", what)
    local size = math.sqrt(sum[1] ^ 2 + sum[2] ^ 2 + sum[3] ^ 2) + math.sqrt(sum[4] ^ 2 + sum[5] ^ 2 + sum[6] ^ 2)
    for c = 1, 6 do near(-held[c], sum[c], 1e-5 * size, ("%s is shown, component %d"):format(what, c)) end
    if size_wanted then near(math.abs(sum[3]), size_wanted, 1e-9, what .. ": its size") end
  end
  same(function(model, middle) model:load { node = middle, force = { 3, -4, -10 }, moment = { 1, 2, 3 } } end,
    "a node's load")
  for what, of in pairs {
    ["a spread load"] = { 1, { q = { 1, 2, -30 } } },
    ["a trapezoid per plan length"] = { 1, { q = { a = { 0, 0, -3 }, b = { 0, 0, -30 } }, axes = "projected" } },
    ["local axes"] = { 2, { q = { a = { 3, -20, 1 } }, axes = "local" } },
    ["moments per length"] = { 2, { q = { 0, 0, -1 }, moment = { 5, 2, 1 } } },
    ["a load at a point"] = { 2, { at = 0.7, force = { 1, 2, -30 }, moment = { 1, 0, 2 } } },
    ["a load at an end"] = { 2, { at = 1, force = { 0, 0, -30 } }, 30 },
  } do
    same(function(model, _, m) model:load(scenes.with(of[2], { member = m[of[1]] })) end, what, of[3])
  end
end)

case("in statics as much of a load is shown as acts", function()
  local model, tip, member = cantilever()
  model:load { node = tip, force = { 0, 0, -40 } }
  model:load { member = member, q = { 0, 0, -6 } }
  local run, seen = model:static { steps = 4 }, 0
  for step in run:steps() do
    near(shown(run)[3], -step.index / 4 * (40 + 6 * L), 1e-6, "shown of step " .. step.index)
    seen = seen + 1
  end
  equal(seen, 4, "steps")
end)

case("in dynamics a load is shown by its history", function()
  local model, tip, member = cantilever()
  model:load { member = member, q = { 0, 0, -10 }, history = { { 0, 1 }, { 1e-3, 0.5 } } }
  model:load { node = tip, force = { 0, 0, -8 }, history = { { 0, 0 }, { 2e-3, 1 } } }
  local run = model:dynamic { dt = 1e-4, duration = 1e-3 }:finish()
  near(shown(run)[3], -0.5 * 10 * L - 0.5 * 8, 1e-6, "shown by the history")
end)

case("a run that goes on from a checkpoint shows its loads before its first step", function()
  -- forces with their part of the load, and the loads
  local file = os.tmpname()
  local function swaying()
    local model, tip, member = cantilever()
    model:load { member = member, q = { 0, 0, -1e3 }, history = { { 0, 0 }, { 1e-3, 1 } } }
    model:load { node = tip, force = { 0, 0, -800 }, history = { { 0, 0 }, { 2e-3, 1 } } }
    model:gravity { 0, 0, -9.81 }
    return model:dynamic { dt = 1e-4, duration = 1e-3 }, member
  end
  local before, its_member = swaying()
  for _ = 1, 6 do before:step() end
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

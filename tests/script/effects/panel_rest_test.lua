-- Bodies with panels come to rest, on the ground, on held panels and on each other; what wakes them; what is followed.
--
-- Run: lua5.4 tests/script/effects/panel_rest_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local panel_cells = require "panel_cells"
local with = require "scenes".with
local hinge = require "hinge"
local checks = support.checks "panel rest"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local g = 9.80665 -- m/s^2
local concrete = hinge.material { E = 30e9, nu = 0.2, density = 2400 }
local thickness = 0.1
local methods = { { name = "newmark", dt = 1e-3, momentum = 1e-6 },
  { name = "explicit", integrator = "explicit", dt = 5e-5, momentum = 1e-9 } }
local function options(method, more)
  return with({ dt = method.dt, integrator = method.integrator, record = false }, more)
end

-- A plate of 2 by 2 panels, 1 m wide; its nodes as a list.
local function plate(model, x, y, z, o)
  o = o or {}
  local side, n = o.side or 1, o.cells or 2
  local rows = panel_cells.lay(model, n, n, function(i, j)
    return { x + side * i / n, y + side * j / n, z + (o.rise or 0) * i / n }
  end, { thickness = thickness, material = concrete })
  local nodes = {}
  for i = 0, n do
    for j = 0, n do nodes[#nodes + 1] = rows[i][j] end
  end
  if o.velocity then
    for _, node in ipairs(nodes) do model:velocity(node, o.velocity) end
  end
  if o.fixed then model:fix(nodes, "xyz") end
  return nodes
end
-- Plates above each other, the lowest `low` above where it lies, each `gap` above the one below.
local function pile(model, count, o)
  o = o or {}
  local list = {}
  for k = 1, count do
    list[k] = plate(model, (o.x or 0) + 0.02 * (k % 2), (o.y or 0) + 0.03 * (k % 3),
      0.5 * thickness + (k - 1) * thickness + k * (o.gap or 0.02), o)
  end
  return list
end
local function scene(contact, ground)
  local model = hinge.model()
  model:gravity { 0, 0, -g }
  if ground ~= false then model:ground(ground or { friction = 0.5 }) end
  model:panel_contact(contact or { friction = 0.5, restitution = 0.3 })
  return model
end

local function moves(run, nodes)
  for _, node in ipairs(nodes) do
    local x, y, z = run:velocity(node)
    if x ~= 0 or y ~= 0 or z ~= 0 then return true end
  end
  return false
end
-- When bodies came to rest, and when they took part again.
local function changes(run)
  local rests, wakes = {}, {}
  for _, change in ipairs(run.state_changes) do
    if change.effect:find "bod" then
      local list = change.awake and wakes or rests
      list[#list + 1] = change.time
    end
  end
  return rests, wakes
end
local function momentum_along(run, lists, mass)
  local sum = { 0, 0 }
  for _, nodes in ipairs(lists) do
    for i, node in ipairs(nodes) do
      local at = (i - 1) // 3 % 2 + (i - 1) % 3 % 2 -- corners have a quarter of the middle's mass, edges a half
      local m = mass / 16 * (at == 2 and 4 or at == 1 and 2 or 1)
      local x, y = run:velocity(node)
      sum[1], sum[2] = sum[1] + m * x, sum[2] + m * y
    end
  end
  return sum
end

for _, method in ipairs(methods) do
  case("plates on the ground and on each other rest where they would lie, and the energy closes: " .. method.name,
    function()
      local model = scene()
      local plates = pile(model, 3)
      local alone = plate(model, 3, 0, 0.08)
      local run, jump, last = model:dynamic(options(method, { duration = 2.2 })), 0, nil
      for _ in run:steps() do
        local rests, error_now = #changes(run), run.energy.energy_error
        if last and rests > last.rests then jump = support.largest_of(jump, math.abs(error_now - last.error)) end
        last = { rests = rests, error = error_now }
      end
      local rests, wakes = changes(run)
      equal(run.verdict, "completed", run.reason)
      expect(#rests >= 1 and rests[#rests] < 2, "came to rest %d times, last at %s s", #rests, rests[#rests])
      equal(#wakes, 0, "how often something woke")
      for k = 1, 3 do
        equal(moves(run, plates[k]), false, ("plate %d moves"):format(k))
        local _, _, z = plates[k][5]:position(run)
        near(z, (k - 0.5) * thickness, 1e-3, ("plate %d: height"):format(k))
      end
      equal(moves(run, alone), false, "the plate alone moves")
      near(jump / run.energy.ground, 0, 1e-6, "energy error as they came to rest")
      local other = scene()
      local others = pile(other, 3)
      plate(other, 3, 0, 0.08)
      local followed = other:dynamic(options(method, { duration = 2.2, rest = false })):finish()
      equal(#changes(followed), 0, "with rest = false")
      near(run.energy_error, method.integrator and 0 or followed.energy_error, 1e-4, "energy error")
      for k = 1, 3 do
        for i, node in ipairs(plates[k]) do
          local x, y, z = node:position(run)
          local ox, oy, oz = others[k][i]:position(followed)
          near(math.abs(x - ox) + math.abs(y - oy) + math.abs(z - oz), 0, 2e-2 * thickness, "place")
        end
      end
    end)
end

case("piles of plates come to rest, each pile by itself, and then a step takes a small part of the time", function()
  local model, all = scene(), {}
  for k = 0, 3 do
    local plates = pile(model, 3, { x = 1.4 * (k % 2), y = 1.4 * (k // 2), gap = 0.01 + 0.01 * k })
    table.move(plates, 1, 3, #all + 1, all)
  end
  local run = model:dynamic(options(methods[2], { duration = 2.2 }))
  local function seconds_until(time)
    local from, steps = os.clock(), run.counts.substeps
    while run.time < time and run:step() do end
    return (os.clock() - from) / (run.counts.substeps - steps)
  end
  local before = seconds_until(0.3)
  seconds_until(2)
  local after = seconds_until(2.2)
  equal(run.verdict, "completed", run.reason)
  for k, nodes in ipairs(all) do equal(moves(run, nodes), false, ("plate %d of 12 moves"):format(k)) end
  expect(#changes(run) >= 2, "came to rest %d times", #changes(run))
  expect(after < 0.3 * before, "a step takes %.3f ms, at rest %.3f ms", 1e3 * before, 1e3 * after)
  near(run.energy_error, 0, 1e-4, "energy error")
end)

for _, method in ipairs(methods) do
  case("plates at rest that are struck take part again, with the momentum of the blow: " .. method.name, function()
    local model = scene({ friction = 0.5, restitution = 0.3 }, {}) -- the ground has no friction
    local plates = pile(model, 2, { gap = 1e-3 })
    local high = 1.3 -- time to fall 1.2 s
    plates[3] = plate(model, -0.2, 0.1, 2.5 * thickness + 0.5 * g * high ^ 2, { velocity = { 0.2, 0.05, 0 } })
    local mass = thickness * 2400
    local run = model:dynamic(options(method, { duration = 1.6 }))
    local rested, woken
    for _ in run:steps() do
      local moving = moves(run, plates[1]) or moves(run, plates[2])
      if not moving and run.time > 0.2 then rested = rested or run.time end
      if rested and moving then woken = woken or run.time end
    end
    expect(rested and rested < high, "at rest from %s s on", rested)
    near(woken or 0, high, 0.03, "time at which they are struck, s")
    local sum = momentum_along(run, plates, mass)
    near(sum[1], 0.2 * mass, method.momentum * mass, "momentum along x")
    near(sum[2], 0.05 * mass, method.momentum * mass, "momentum along y")
    equal(moves(run, plates[1]) and moves(run, plates[2]), true, "both are struck")
    if method.integrator then near(run.energy_error, 0, 1e-4, "energy error") end
  end)
end

case("checkpoints go on with the same bits before, at and after rest", function()
  for _, method in ipairs(methods) do
    local function new()
      local model = scene()
      pile(model, 1, { gap = 1e-3 })
      plate(model, 0.1, -0.1, 1.5 * thickness + 0.5 * g * 1.3 ^ 2)
      return model:dynamic(options(method, { duration = 1.4 }))
    end
    local whole = new():finish()
    local rests, wakes = changes(whole)
    expect(#rests > 0 and #wakes > 0, "%s: %d times at rest, %d times awake", method.name, #rests, #wakes)
    for _, cut in ipairs { 0.3, 0.5 * (rests[1] + wakes[1]), 1.35 } do
      local first = new()
      while first.time < cut do first:step() end
      local file = os.tmpname()
      first:checkpoint(file)
      local second = new():resume(file):finish()
      os.remove(file)
      equal(second.hash, whole.hash, ("%s: from a checkpoint at %g s"):format(method.name, cut))
    end
  end
end)

case("on held panels, without a ground, plates rest too; what they lose goes to contact of panels", function()
  local model = scene(nil, false)
  plate(model, -0.5, -0.5, 0, { side = 2.5, fixed = true })
  local plates = pile(model, 2, { gap = 0.6 * thickness })
  local run = model:dynamic(options(methods[2], { duration = 2.5 })):finish()
  equal(moves(run, plates[1]) or moves(run, plates[2]), false, "they move")
  near(run.energy_error, 0, 1e-4, "energy error")
end)

case("a plate that lies on bars takes part again when one of them breaks", function()
  local model = scene()
  local section = hinge.section.box { width = 0.1, depth = 0.1, thickness = 0.01 }
  local steel = hinge.material { E = 206e9, density = 7850 }
  local bars = {}
  for i = 1, 2 do
    bars[i] = model:member { model:node { 0.9 * i - 0.8, -0.2, 0.05 }, model:node { 0.9 * i - 0.8, 1.2, 0.05 },
      section = section, material = steel, elements = 4 }
  end
  local above = plate(model, 0, 0, 0.1 + 0.5 * thickness)
  model:remove { member = bars[2], at = 1.6 }
  local run = model:dynamic(options(methods[2], { duration = 1.7, dt = "auto" }))
  while run.time < 1.59 do run:step() end
  equal(moves(run, above), false, "it moves before")
  run:finish()
  local _, wakes = changes(run)
  equal(#wakes, 1, "how often something woke")
  near(wakes[1], 1.6, 1e-4, "when, s")
  equal(moves(run, above), true, "it moves afterwards")
  near(run.energy_error, 0, 1e-4, "energy error")
end)

-- What is not at rest -------------------------------------------------------------------------------------------------

case("a plate that slides slowly, one that swings, and one that tips over an edge are followed", function()
  local slow = scene({ restitution = 0.3 }, {})
  local slides = plate(slow, 0, 0, 0.5 * thickness, { velocity = { 0.01, 0, 0 } })
  local run = slow:dynamic(options(methods[2], { duration = 3 })):finish()
  near(slides[1]:position(run), 0.03, 1e-4, "way of the one that slides, m")

  local swing = scene()
  local hangs = plate(swing, 0, 0, 3)
  swing:fix({ hangs[1], hangs[2], hangs[3] }, "xyz") -- the edge at x = 0
  run = swing:dynamic(options(methods[2], { duration = 2 }))
  local lowest = 3
  for _ in run:steps() do lowest = support.smallest_of(lowest, (select(3, hangs[9]:position(run)))) end
  expect(lowest < 2.05 and moves(run, hangs), "the one that swings: down to z = %.3f m", lowest)

  local edge = scene()
  local low = plate(edge, 0, 0, 0.5 * thickness)
  local high = plate(edge, 0.502, 0, 1.5 * thickness) -- its middle is 2 mm beyond the edge of the lower one
  run = edge:dynamic(options(methods[2], { duration = 4 })):finish()
  local _, _, z = high[8]:position(run)
  expect(z < 0.8 * thickness, "the one that tips: its end is at z = %.3f m", z)
  equal(moves(run, low), false, "all lie still in the end")
end)

checks.done()

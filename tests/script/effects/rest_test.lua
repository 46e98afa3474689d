-- Bodies that come to rest on the ground: when they do, what it changes, and what wakes them.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local with = require "scenes".with
local hinge = require "hinge"
local checks = support.checks "rest"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near
local g, side, length = 9.80665, 0.1, 1.5
local section = hinge.section.box { width = side, depth = side, thickness = 0.005 }
local steel = hinge.material { E = 206e9, density = 7850 }

-- Bars above the ground: { height of its axis, rise of its far end, angle about the vertical, place along y }.
local function scattered(bars, o)
  o = o or {}
  local model, nodes = hinge.model(o.model), {}
  for i, bar in ipairs(bars) do
    local z, rise, angle, y = table.unpack(bar)
    local a = model:node { 0, y or 2 * i, z }
    local b = model:node { length * math.cos(angle or 0), (y or 2 * i) + length * math.sin(angle or 0), z + rise }
    model:member { a, b, section = section, material = steel, group = "bar " .. i }
    nodes[i] = { a, b }
  end
  model:gravity { 0, 0, -g }
  model:ground(o.ground or {})
  if o.contact then model:contact { rule = "surface" } end
  return model, nodes
end

local function came_to_rest(run)
  local times = {}
  for _, change in ipairs(run.state_changes) do
    if not change.awake and change.time > 0 and change.effect:find "bod" then times[#times + 1] = change.time end
  end
  return times
end

-- The nodes of all bars are where those of the other run are, within `most`, m.
local function same_places(nodes, run, others, other, most)
  for i, pair in ipairs(nodes) do
    for j, node in ipairs(pair) do
      local x, y, z = node:position(run)
      local ox, oy, oz = others[i][j]:position(other)
      near(math.abs(x - ox) + math.abs(y - oy) + math.abs(z - oz), 0, most, ("bar %d, node %d: place"):format(i, j))
    end
  end
end

local methods = { { name = "newmark", dt = 1e-3 }, { name = "explicit", integrator = "explicit", dt = "auto" } }
local function options(method, more)
  return with({ dt = method.dt, integrator = method.integrator, record = false }, more)
end

for _, method in ipairs(methods) do
  case("bars that fell lie still, where they would lie if they were followed: " .. method.name, function()
    local bars = { { 0.3, 0, 0 }, { 0.5, 0.2, 0.3 }, { 0.4, 0.1, 0 } }
    local model, nodes = scattered(bars)
    local run = model:dynamic(options(method, { duration = 2.4 })):finish()
    local other, others = scattered(bars)
    local followed = other:dynamic(options(method, { duration = 2.4, rest = false })):finish()
    equal(run.verdict, "completed", run.reason)
    local times = came_to_rest(run)
    expect(#times >= 1 and times[#times] > 1.2, "came to rest %d times, last at %s s", #times, times[#times])
    equal(#came_to_rest(followed), 0, "with rest = false")
    same_places(nodes, run, others, followed, 2e-3 * side)
    for i, pair in ipairs(nodes) do
      for j, node in ipairs(pair) do
        local vx, vy, vz = node:velocity(run)
        equal(math.abs(vx) + math.abs(vy) + math.abs(vz), 0, ("bar %d, node %d: velocity"):format(i, j))
      end
    end
    -- what they have lost is what they would have lost, within what they could still have had: 1e-3 m g r
    local scale = run.energy.gravity and math.abs(run.energy.gravity) or 1
    near(run.energy.ground / followed.energy.ground, 1, 1e-3, "energy taken by the ground")
    near(run.energy.energy_error / scale, followed.energy.energy_error / scale, 1e-4, "energy balance")
  end)
end

-- The range of the last `count` numbers, and the largest change from one to the next. The energy error of explicit
-- steps swings for as long as anything vibrates.
local function range_of(numbers, count)
  local least, most, change = math.huge, -math.huge, 0
  for i = #numbers - count + 1, #numbers do
    least, most = support.smallest_of(least, numbers[i]), support.largest_of(most, numbers[i])
    change = support.largest_of(change, math.abs(numbers[i] - numbers[i - 1]))
  end
  return { least, most }, change
end

-- A bar that breaks in two as it lands, and what is left of the elements that broke.
case("pieces of a bar that broke come to rest, and the energy balance does not see it", function()
  for _, method in ipairs(methods) do
    local model, nodes = scattered({ { 2, 0.8, 0 } },
      { model = { elements_per_member = 4 }, ground = { friction = 0.4 } })
    model:velocity("bar 1", { 0, 0, -6 })
    model:fracture { curvature_x = 0.01, curvature_y = 0.01, axial_strain = 0.3 }
    local run, errors, jump, rests = model:dynamic(options(method, { duration = 3.5, dt = "auto" })), {}, 0, 0
    for _ in run:steps() do
      local now, error_now = #came_to_rest(run), run.energy.energy_error / run.energy.initial
      if now > rests then
        rests = now
        local range, swing = range_of(errors, 100)
        jump = support.largest_of(jump, support.largest_of(range[1] - error_now, error_now - range[2]) - swing)
      end
      errors[#errors + 1] = error_now
    end
    equal(run.verdict, "completed", run.reason)
    expect(run:count { state = "broken" } == 1 and rests > 0, "%s: %d broken, %d came to rest", method.name,
      run:count { state = "broken" }, rests)
    -- what the energy error leaves its range by; 1e-8: of rounding, as by Newmark's method between any two steps
    expect(jump < 1e-8, "%s: energy error as they came to rest: %g beyond its swing", method.name, jump)
    near(run.energy_error, 0, 5e-3, method.name .. ": energy error")
    local _, _, z = nodes[1][1]:position(run)
    expect(z < side, "%s: its end is at z = %.3f m", method.name, z)
  end
end)

-- The same scene with gravity along another axis, with small displacement, with elements of another number and size.
case("bars come to rest across any axis, with any elements, in small displacement too", function()
  for name, o in pairs { ["along x"] = { up = function(x, y, z) return { -z, x, y } end },
    ["along y, at another height"] = { up = function(x, y, z) return { y, z - 7, x } end },
    ["small displacement"] = { model = { displacement = "small" } },
    ["8 elements"] = { model = { elements_per_member = 8 } } } do
    local up = o.up or function(x, y, z) return { x, y, z } end
    local model = hinge.model(o.model)
    model:member { model:node(up(0, 0, 0.3)), model:node(up(length, 0, 0.3)), section = section, material = steel }
    local zero, down = up(0, 0, 0), up(0, 0, -g)
    model:gravity { down[1] - zero[1], down[2] - zero[2], down[3] - zero[3] }
    model:ground { point = zero, normal = { zero[1] - down[1], zero[2] - down[2], zero[3] - down[3] } }
    local run = model:dynamic { dt = "auto", integrator = "explicit", duration = 2, record = false }:finish()
    equal(run.verdict, "completed", name .. ": " .. run.reason)
    local times = came_to_rest(run)
    equal(#times, 1, name .. ": how often something came to rest")
    -- it lies there after 0.226 s, and for 1.01 s at least
    expect(times[1] and times[1] > 1.23 and times[1] < 1.6, "%s: came to rest at %s s", name, times[1])
  end
end)

case("a bar at rest that another one falls on takes part again", function()
  local model, nodes = scattered({ { side / 2 + 1e-4, 0, 0, 0 }, { 12, 0, math.pi / 2, -0.7 } }, { contact = true })
  local run = model:dynamic { dt = "auto", integrator = "explicit", duration = 1.75, record = false }
  local rested, woken
  for _ in run:steps() do
    local _, _, vz = nodes[1][1]:velocity(run)
    if vz == 0 and run.time > 0.1 and not woken then rested = rested or run.time end
    if rested and vz ~= 0 then woken = woken or run.time end
  end
  equal(run.verdict, "completed", run.reason)
  expect(rested and rested > 0.9 and rested < 1.4, "at rest from %s s on", rested)
  near(woken, math.sqrt(2 * (12 - 1.5 * side) / g), 0.02, "time at which it is struck, s")
  local wakes = 0
  for _, change in ipairs(run.state_changes) do
    if change.awake and change.effect == "body" then wakes = wakes + 1 end
  end
  equal(wakes, 1, "how often a body woke")
  local other, others = scattered({ { side / 2 + 1e-4, 0, 0, 0 }, { 12, 0, math.pi / 2, -0.7 } }, { contact = true })
  local followed = other:dynamic { dt = "auto", integrator = "explicit", duration = 1.75, rest = false, record = false }
  same_places(nodes, run, others, followed:finish(), 1e-3 * side)
end)

case("a bar that topples slowly does not stop on its way", function()
  -- upright, and half a degree beyond the edge on which it stands
  local model, lean = hinge.model {}, math.rad(0.5) + math.atan(side / length)
  local a = model:node { 0, 0, side / 2 }
  local b = model:node { length * math.sin(lean), 0, side / 2 + length * math.cos(lean) }
  model:member { a, b, section = section, material = steel }
  model:gravity { 0, 0, -g }
  model:ground { friction = 0.6 }
  local run = model:dynamic { dt = "auto", integrator = "explicit", duration = 4, record = false }:finish()
  equal(run.verdict, "completed", run.reason)
  local _, _, z = b:position(run)
  expect(z < 1.5 * side, "its upper end is at z = %.3f m", z)
end)

case("what hangs or stands on a support is followed", function()
  local model = hinge.model {}
  local a, b = model:node { 0, 0, 3 }, model:node { length, 0, 3 }
  model:member { a, b, section = section, material = steel }
  model:fix(a)
  model:gravity { 0, 0, -g }
  model:ground {}
  model:damping { alpha = 50 }
  local run = model:dynamic { dt = 1e-3, duration = 3, record = false }:finish()
  equal(#came_to_rest(run), 0, "bodies that came to rest")
end)

case("checkpoints and a run that goes on keep what lies still", function()
  local bars = { { 0.3, 0, 0 }, { 0.5, 0.2, 0.3 } }
  for _, method in ipairs(methods) do
    local whole = scattered(bars):dynamic(options(method, { duration = 2.4 })):finish()
    expect(#came_to_rest(whole) > 0, "%s: comes to rest", method.name)
    for _, cut in ipairs { 0.6, 1.4, 2.3 } do
      local first = scattered(bars):dynamic(options(method, { duration = 2.4 }))
      while first.time < cut do first:step() end
      local file = os.tmpname()
      first:checkpoint(file)
      local second = scattered(bars):dynamic(options(method, { duration = 2.4 })):resume(file):finish()
      os.remove(file)
      equal(second.hash, whole.hash, ("%s: from a checkpoint at %g s"):format(method.name, cut))
    end
  end
end)

checks.done()

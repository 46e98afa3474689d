-- Bars that are dropped on the ground, with and without bodies that come to rest there: what rest changes.
--
-- Run     lua5.4 tests/hard/rest.lua [name=value ...], with the module on LUA_CPATH
--         count=2000 first=1   so many seeds, from the first
--         jobs=2               processes at a time
--         out=FILE.csv         a line for each seed is added; seeds that it already has are not run again
-- Shows   of explicit and of Newmark's steps: scenes in which something came to rest, verdicts, how far nodes are from
--         where they are with rest = false, energy errors, processor time
-- Expect  the same verdicts; no node of a bar at rest further than a tenth of its half depth from where it is followed:
--         vibrations that nothing damps make a bar creep along itself on friction; else the status is 1
--
-- A scene: one to five bars of 0.8 to 3.8 m and 0.05 to 0.25 m depth, tilted, 0.1 to 2.1 m above a plane across any of
-- the axes, elastic or yielding, with friction or without; a fifth of them spin and fly. The runs take 4.5 s.
local folder = arg[0]:match "^(.*)[/\\]" or "."
package.path = folder .. "/../script/?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local core = require "hinge.core"
local options = { count = 2000, first = 1, jobs = 2, out = "rest.csv" }
for _, word in ipairs(arg) do
  local name, value = word:match "^(%w+)=(.+)$"
  assert(options[name], "unknown word: " .. word)
  options[name] = tonumber(value) or value
end

local function drawn(seed)
  math.randomseed(seed)
  local u = math.random
  local s = { explicit = u() < 0.6, axis = u(1, 3), sign = u() < 0.5 and 1 or -1, level = 10 * (u() - 0.5),
    friction = u() < 0.8 and 0.1 + 0.6 * u() or 0, strength = u() < 0.5 and 235e6 or nil,
    elements = u() < 0.7 and 2 or 4, flies = u() < 0.2, bars = {} }
  for i = 1, u(1, 5) do
    s.bars[i] = { height = 0.1 + 2 * u(), rise = 0.6 * (u() - 0.5), angle = 2 * math.pi * u(), length = 0.8 + 3 * u(),
      side = 0.05 + 0.2 * u(), spin = s.flies and 3 * (u() - 0.5) or 0, speed = s.flies and 3 * (u() - 0.5) or 0 }
  end
  return s
end

-- A vector along the plane, across it and upwards from it, in the axes of the model.
local function turned(s, x, y, up)
  local v, k = {}, s.axis
  v[k % 3 + 1], v[(k + 1) % 3 + 1], v[k] = x, y, s.sign * up
  return v
end

local function run_of(s, rest)
  local model, nodes = hinge.model { elements_per_member = s.elements }, {}
  local steel = hinge.material { E = 206e9, density = 7850, yield_stress = s.strength }
  for i, bar in ipairs(s.bars) do
    local section = hinge.section.box { width = bar.side, depth = bar.side, thickness = bar.side / 12 }
    local base = s.sign * s.level + bar.height + bar.side + math.abs(bar.rise) * bar.length
    local function node(part)
      local x, y = part * bar.length * math.cos(bar.angle), 8 * i + part * bar.length * math.sin(bar.angle)
      nodes[#nodes + 1] = model:node(turned(s, x, y, base + part * bar.rise * bar.length))
      return nodes[#nodes]
    end
    model:member { node(0), node(1), section = section, material = steel, group = "bar " .. i }
    model:velocity("bar " .. i, turned(s, bar.speed, 0, 0), turned(s, 0, bar.spin, 0))
  end
  model:gravity(turned(s, 0, 0, -9.80665))
  model:ground { point = turned(s, 0, 0, s.sign * s.level), normal = turned(s, 0, 0, 1), friction = s.friction }
  local begun = os.clock()
  local run = model:dynamic { dt = s.explicit and "auto" or 5e-4, integrator = s.explicit and "explicit" or nil,
    duration = 4.5, rest = rest, record = false }:finish()
  return run, nodes, os.clock() - begun
end

local function came_to_rest(run)
  local times = 0
  for _, change in ipairs(run.state_changes) do
    if change.effect:find "bod" and not change.awake and change.time > 0 then times = times + 1 end
  end
  return times
end

local function compare(seed)
  local s, most = drawn(seed), 0
  local run, nodes, time = run_of(s, true)
  local followed, others, time_followed = run_of(s, false)
  for i, node in ipairs(nodes) do
    local x, y, z = node:position(run)
    local fx, fy, fz = others[i]:position(followed)
    local off = math.sqrt((x - fx) ^ 2 + (y - fy) ^ 2 + (z - fz) ^ 2)
    local vx, vy, vz = node:velocity(run)
    if vx == 0 and vy == 0 and vz == 0 then most = support.largest_of(most, off / (s.bars[(i + 1) // 2].side / 2)) end
  end
  return ("%d,%s,%d,%s,%s,%.3e,%.3e,%.3e,%.3f,%.3f\n"):format(seed, s.explicit and "explicit" or "newmark",
    came_to_rest(run), run.verdict, followed.verdict, most, math.abs(run.energy_error), math.abs(followed.energy_error),
    time, time_followed)
end

local known = {}
local kept = io.open(options.out)
for line in kept and kept:lines() or function() end do known[tonumber(line:match "^%d+")] = true end
if kept then kept:close() end
for job = 1, options.jobs do
  core.start(function()
    for seed = options.first + job - 1, options.first + options.count - 1, options.jobs do
      local file = not known[seed] and assert(io.open(options.out, "a"))
      if file then
        file:write(compare(seed))
        file:close()
        collectgarbage()
      end
    end
    return 0
  end, os.tmpname(), 0, false, options.jobs)
end
for _ = 1, options.jobs do
  while not core.wait(10) do end
end

local sums, bad = {}, 0
for line in io.lines(options.out) do
  local f = {}
  for word in line:gmatch "[^,]+" do f[#f + 1] = tonumber(word) or word end
  local sum = sums[f[2]] or { scenes = 0, rest = 0, alike = 0, off = {}, error = 0, error_followed = 0, time = 0,
    time_followed = 0 }
  sums[f[2]] = sum
  sum.scenes, sum.alike = sum.scenes + 1, sum.alike + (f[4] == f[5] and 1 or 0)
  if f[3] > 0 then sum.rest, sum.off[#sum.off + 1] = sum.rest + 1, f[6] end
  sum.error, sum.error_followed = support.largest_of(sum.error, f[7]), support.largest_of(sum.error_followed, f[8])
  sum.time, sum.time_followed = sum.time + f[9], sum.time_followed + f[10]
  if f[4] ~= f[5] or not (f[6] <= 0.1) then
    bad = bad + 1
    print("seed " .. f[1] .. ": " .. line)
  end
end
for name, sum in pairs(sums) do
  table.sort(sum.off)
  local function part(p) return sum.off[math.ceil(p * #sum.off)] or 0 end
  print(("%s: %d scenes, in %d something came to rest, %d verdicts alike; nodes off by %.1e, %.1e, %.1e of "
    .. "the half depth (median, 99 %%, most); energy error at most %.1e, followed %.1e; %.0f s, followed %.0f s")
    :format(name, sum.scenes, sum.rest, sum.alike, part(0.5), part(0.99), part(1), sum.error, sum.error_followed,
      sum.time, sum.time_followed))
end
os.exit(bad == 0)

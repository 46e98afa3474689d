-- Loads over a part of a member: model:load with from and to.
--
-- Run: lua5.4 tests/script/model/member_parts_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local vectors = require "hinge.library.vectors"
local checks = support.checks "loads over a part of a member"
local runs = require "runs"(checks)
local case, expect, near = checks.case, checks.expect, checks.near

local E, G = 200e9, 77e9
local steel = hinge.material { E = E, G = G, density = 7850 }
local bar = hinge.section.solid { width = 0.05, depth = 0.1 }
local L = 3

-- A beam to (3, 0, slope), clamped at both ends. options: of the model, and elements.
local function clamped(options, elements, slope)
  local m, b, beam = scenes.cantilever { model = options, length = L, along = { 1, 0, (slope or 0) / L },
    member = { section = bar, material = steel, elements = elements } }
  m:fix(b)
  return m, beam, b
end

-- Fixed-end moment at the first end, N m, of a load q(x) per length on a clamped Timoshenko beam: Gauss's rule on its
-- influence line, exact for a q that is straight.
local function end_moment(q, from, to)
  local phi, sum = 12 * E * bar.Ix / (G * bar.shear_area_y * L ^ 2), 0
  for _, g in ipairs { { 0.5 - math.sqrt(0.15), 5 / 18 }, { 0.5, 8 / 18 }, { 0.5 + math.sqrt(0.15), 5 / 18 } } do
    local x = from + (to - from) * g[1]
    local t = x / L
    sum = sum + (to - from) * g[2] * q(x) * L * t * (1 - t) * (1 - t + 0.5 * phi) / (1 + phi)
  end
  return sum
end

for _, displacement in ipairs { "small", "large" } do
  case("end moments and moments in the span are exact: displacement " .. displacement, function()
    for _, elements in ipairs { 2, 4, 6 } do
      local from, to, q1, q2 = 0.23, 0.81, 2, 5 -- N/m: second-order effects are 1e-9
      local m, beam = clamped({ displacement = displacement }, elements)
      m:load { member = beam, q = { a = { 0, 0, -q1 }, b = { 0, 0, -q2 } }, from = from, to = to }
      local run = m:static { steps = 1 }:finish()
      local x1, x2 = from * L, to * L
      local function q(x) return q1 + (q2 - q1) * (x - x1) / (x2 - x1) end
      local left = end_moment(q, x1, x2)
      local right = end_moment(function(x) return q(L - x) end, L - x2, L - x1)
      -- the load up to x2, and its moment about x up to there
      local D, slope = x2 - x1, (q2 - q1) / (x2 - x1)
      local whole = q1 * D + slope * D ^ 2 / 2
      local function about(x)
        local d = support.smallest_of(support.largest_of(x - x1, 0), D)
        return q1 * d ^ 2 / 2 + slope * d ^ 3 / 6 + whole * support.largest_of(x - x2, 0)
      end
      local Q = (about(L) + left - right) / L
      local function moment(x) return -left + Q * x - about(x) end
      local sign = beam:along(run, 1)[1].Mx < 0 and 1 or -1
      for _, row in ipairs(beam:along(run, 7)) do
        near(sign * row.Mx, moment(row.x), 1e-6 * left, ("%d elements, Mx at %g m"):format(elements, row.x))
      end
      local first = beam:along(run, 1)[1]
      near(sign * first.Mx, -left, 1e-7 * left, elements .. " elements: first end")
      near(math.abs(first.Qy), Q, 1e-7 * Q, elements .. " elements: shear force")
    end
  end)
end

-- What two runs have along their member, and how their nodes move.
local function compare(one, two, within, what)
  local a, b = one.beam:along(one.run, 4), two.beam:along(two.run, 4)
  for _, quantity in ipairs { "N", "Mx", "My", "Mz", "Qx", "Qy" } do
    local size = 1e-12
    for _, row in ipairs(b) do size = support.largest_of(size, math.abs(row[quantity])) end
    for x = 0, 4 do
      local function at(rows)
        for _, row in ipairs(rows) do
          if math.abs(row.x - x * one.beam.length / 4) < 1e-6 then return row[quantity] end
        end
      end
      local rounding = 3e-7 -- beside an axial force of 5e5 N
      near(at(a), at(b), within * size + rounding, ("%s: %s at %d quarters"):format(what, quantity, x))
    end
  end
end

case("parts that make up a whole load act as it does: axes, moments, trapezoids, compression", function()
  local kinds = {
    { q = { 300, -200, -500 } },
    { q = { 300, -200, -500 }, axes = "local" },
    { q = { 0, 0, -500 }, axes = "projected" },
    { moment = { 20, 30, 10 } },
    { q = { a = { 100, 0, -500 }, b = { 0, 50, 300 } } },
  }
  for i, kind in ipairs(kinds) do
    for _, options in ipairs { { displacement = "small" }, {}, { p_delta = "chord" } } do
      local built = {}
      for k, cuts in ipairs { { 0, 1 }, { 0, 0.37, 0.75, 1 } } do
        local m, beam = clamped(options, 4, 1)
        if options.displacement ~= "small" then -- pressed to 0.6 of its buckling load between clamped ends
          m = hinge.model(options)
          local one, two = m:node { 0, 0, 0 }, m:node { L, 0, 1 }
          m:fix(one)
          m:fix(two, "y,z,rx,ry,rz")
          beam = m:member { one, two, section = bar, material = steel, elements = 4 }
          m:load { node = two, force = { -0.6 * 4 * math.pi ^ 2 * E * bar.Iy / (L ^ 2 + 1), 0, 0 } }
        end
        for j = 1, #cuts - 1 do
          local load = { member = beam, axes = kind.axes }
          if k > 1 then load.from, load.to = cuts[j], cuts[j + 1] end
          for field in pairs { q = 1, moment = 1 } do
            local v = kind[field]
            if v and v.a then
              load[field] = { a = vectors.between(v.a, v.b, cuts[j]), b = vectors.between(v.a, v.b, cuts[j + 1]) }
            else
              load[field] = v
            end
          end
          m:load(load)
        end
        built[k] = { run = runs.completed(m:static { steps = 2 }), beam = beam }
      end
      -- with compression the integrals are by Gauss's rule
      compare(built[2], built[1], options.displacement == "small" and 1e-9 or 1e-5,
        ("kind %d, %s"):format(i, options.displacement or options.p_delta or "large"))
    end
  end
end)

case("in dynamics a part presses as much as in statics, and its history counts", function()
  for _, displacement in ipairs { "small", "large" } do
    for _, integrator in ipairs { "newmark", "explicit" } do
      local m, beam = clamped({ displacement = displacement }, 4)
      m:load { member = beam, q = { 0, 0, -1000 }, from = 0.1, to = 0.3 }
      m:load { member = beam, q = { 0, 0, -400 }, from = 0.5, history = { { 0, 1 }, { 1, 1 } } }
      local rest = m:static { steps = 1, loads = nil }:finish()
      local before = beam:forces(rest)
      local run = m:dynamic { dt = 2e-5, duration = 4e-4, integrator = integrator, from = rest }:finish()
      -- the load with a history sets off: the first end feels it when the wave has come
      expect(math.abs(beam:forces(run).Mx - before.Mx) < math.abs(before.Mx), "%s: Mx from %g to %g", integrator,
        before.Mx, beam:forces(run).Mx)
      runs.balanced(run, 1e-2, "work", integrator) -- explicit steps: their kinetic energy swings
    end
  end
end)

case("load cases, groups, reactions and snapshots have it", function()
  local m, _, _, a = scenes.cantilever { model = { displacement = "small" }, length = L,
    member = { section = bar, material = steel, group = "beams" } }
  local snow = m:case "snow"
  snow:load { group = "beams", q = { 0, 0, -100 }, from = 0.5 }
  local run = m:static { steps = 1, loads = { snow = 2 } }:finish()
  local _, _, z, _, moment = run:reaction(a)
  near(z, 2 * 100 * L / 2, 1e-9, "reaction")
  near(math.abs(moment), 2 * 100 * L / 2 * 0.75 * L, 1e-9, "moment at the wall")
end)

case("wrong parts are refused at their line", function()
  local m, beam = clamped({ displacement = "small" }, 2)
  local function refused(load, words) checks.refused(words, m.load, m, scenes.with(load, { member = beam })) end
  refused({ q = { 0, 0, 1 }, from = 0.5, to = 0.5 }, "'from' must be less than 'to'")
  refused({ q = { 0, 0, 1 }, from = 1 }, "'from' must be less than 'to'")
  refused({ q = { 0, 0, 1 }, to = 1.5 }, "must be from 0, the member's first end, to 1")
  refused({ q = { 0, 0, 1 }, from = -0.1 }, "from")
  refused({ force = { 0, 0, 1 }, at = 0.5, from = 0.1 }, "given beside 'at'")
end)

checks.done()

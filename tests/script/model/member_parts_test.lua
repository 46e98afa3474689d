-- Loads over a part of a member: model:load with from and to.
--
-- Run: lua5.4 tests/script/model/member_parts_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "loads over a part of a member"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local E, G = 200e9, 77e9
local steel = hinge.material { E = E, G = G, density = 7850 }
local bar = hinge.section.solid { width = 0.05, depth = 0.1 }
local L = 3

-- A beam along (3, 0, 1) times something, clamped at both ends. options: of the model, and elements.
local function clamped(options, elements, slope)
  local m = hinge.model(options)
  local a, b = m:node { 0, 0, 0 }, m:node { L, 0, slope or 0 }
  m:fix { a, b }
  return m, m:member { a, b, section = bar, material = steel, elements = elements }, a, b
end

-- Fixed-end moment at the first end, N m, of a load q(x) per length on a clamped Timoshenko beam, by Simpson's rule in
-- 2000 pieces of its influence line.
local function end_moment(q, from, to)
  local phi = 12 * E * bar.Ix / (G * bar.shear_area_y * L ^ 2)
  local n, sum = 2000, 0
  local function value(x)
    local t = x / L
    return q(x) * L * t * (1 - t) * (1 - t + 0.5 * phi) / (1 + phi)
  end
  local h = (to - from) / n
  for i = 0, n - 1 do
    local x = from + i * h
    sum = sum + h / 6 * (value(x) + 4 * value(x + h / 2) + value(x + h))
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
      -- by moments about the first end
      local whole, about = 0, 0
      for i = 1, 2000 do
        local x = x1 + (i - 0.5) * (x2 - x1) / 2000
        whole, about = whole + q(x) * (x2 - x1) / 2000, about + q(x) * x * (x2 - x1) / 2000
      end
      local Q = whole - (about - left + right) / L
      local function moment(x)
        local sum = -left + Q * x
        for i = 1, 2000 do
          local at = x1 + (i - 0.5) * (x2 - x1) / 2000
          if at < x then sum = sum - q(at) * (x2 - x1) / 2000 * (x - at) end
        end
        return sum
      end
      local sign = beam:along(run, 1)[1].Mx < 0 and 1 or -1
      for _, row in ipairs(beam:along(run, 7)) do
        near(sign * row.Mx, moment(row.x), 2e-4 * left, ("%d elements, Mx at %g m"):format(elements, row.x))
      end
      local first = beam:along(run, 1)[1]
      near(sign * first.Mx, -left, 1e-7 * left, elements .. " elements: first end")
      near(math.abs(first.Qy), Q, 2e-6 * Q, elements .. " elements: shear force") -- by the rectangles above
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
      near(at(a), at(b), within * size + 1e-7, ("%s: %s at %d quarters"):format(what, quantity, x))
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
        local m, beam, _, b = clamped(options, 4, 1)
        if options.displacement ~= "small" then -- pressed to 0.6 of its buckling load between clamped ends
          m = hinge.model(options)
          local one, two = m:node { 0, 0, 0 }, m:node { L, 0, 1 }
          m:fix(one)
          m:fix(two, "y,z,rx,ry,rz")
          beam = m:member { one, two, section = bar, material = steel, elements = 4 }
          m:load { node = two, force = { -0.6 * 4 * math.pi ^ 2 * E * bar.Iy / (L ^ 2 + 1), 0, 0 } }
          b = two
        end
        for j = 1, #cuts - 1 do
          local load = { member = beam, axes = kind.axes }
          if k > 1 then load.from, load.to = cuts[j], cuts[j + 1] end
          for field in pairs { q = 1, moment = 1 } do
            local v = kind[field]
            if v and v.a then
              local function at(s)
                local between = {}
                for c = 1, 3 do between[c] = v.a[c] + s * (v.b[c] - v.a[c]) end
                return between
              end
              load[field] = { a = at(cuts[j]), b = at(cuts[j + 1]) }
            else
              load[field] = v
            end
          end
          m:load(load)
        end
        local run = m:static { steps = 2 }:finish()
        equal(run.verdict, "completed", run.reason)
        built[k] = { run = run, beam = beam, node = b }
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
      local run = m:dynamic { dt = 2e-5, duration = 4e-4, integrator = integrator, from = rest }
      run:finish()
      -- the load with a history sets off: the first end feels it when the wave has come
      expect(math.abs(beam:forces(run).Mx - before.Mx) < math.abs(before.Mx), "%s: Mx from %g to %g", integrator,
        before.Mx, beam:forces(run).Mx)
      -- explicit steps: their kinetic energy swings
      expect(math.abs(run.energy.energy_error) < 1e-2 * math.abs(run.energy.work), "energy error %g of %g J",
        run.energy.energy_error, run.energy.work)
    end
  end
end)

case("load cases, groups, reactions and snapshots have it", function()
  local m = hinge.model { displacement = "small" }
  local a, b = m:node { 0, 0, 0 }, m:node { L, 0, 0 }
  m:fix(a)
  m:member { a, b, section = bar, material = steel, group = "beams" }
  local snow = m:case "snow"
  snow:load { group = "beams", q = { 0, 0, -100 }, from = 0.5 }
  local run = m:static { steps = 1, loads = { snow = 2 } }:finish()
  local _, _, z, _, moment = run:reaction(a)
  near(z, 2 * 100 * L / 2, 1e-9, "reaction")
  near(math.abs(moment), 2 * 100 * L / 2 * 0.75 * L, 1e-9, "moment at the wall")
end)

case("wrong parts are refused at their line", function()
  local m, beam = clamped({ displacement = "small" }, 2)
  local function refused(load, words)
    load.member = beam
    local ok, message = pcall(m.load, m, load)
    expect(not ok and support.has(tostring(message), words), "'%s' for: %s", message, words)
  end
  refused({ q = { 0, 0, 1 }, from = 0.5, to = 0.5 }, "'from' must be less than 'to'")
  refused({ q = { 0, 0, 1 }, from = 1 }, "'from' must be less than 'to'")
  refused({ q = { 0, 0, 1 }, to = 1.5 }, "must be from 0, the member's first end, to 1")
  refused({ q = { 0, 0, 1 }, from = -0.1 }, "from")
  refused({ force = { 0, 0, 1 }, at = 0.5, from = 0.1 }, "given beside 'at'")
end)

checks.done()

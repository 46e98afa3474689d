-- Yield of members that carry loads between their nodes, by q and by weight along them: it goes by the moments of the
-- section, so that first yield and plastic limit loads are those of closed forms with two elements and more; f_y told
-- is that which yield goes by; and what hinges dissipate is their rotation times the fully plastic moment.
--
-- Run: lua5.4 tests/script/sections/member_yield_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local scenes = require "scenes"
local checks = support.checks "member yield"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local width, sigma, L, rho = 0.05, 245e6, 2, 7850
local Mp = width ^ 3 / 4 * sigma
local unit = Mp / L ^ 2 -- N/m
local steel = hinge.material { E = 206e9, density = rho, yield_stress = sigma }
local section = hinge.section.solid { width = width, depth = width }
local strong = hinge.section.solid { width = 2 * width, depth = 2 * width }

local function close(value, wanted, what, part) near(value, wanted, (part or 1e-9) * math.abs(wanted), what) end
local merged = scenes.with

local pinned = { "xyz,rx,rz", "yz,rx,rz" }
local clamped = { "all", "yz,rx,ry,rz" }
local propped = { "all", "yz,rx,rz" }
-- What acts down along a member, N/m: a load in the axes of space or in its own (down: along -y), or its weight.
local function presses(model, member, kind, load, own)
  if kind == "q" then model:load { member = member, q = { 0, 0, -load } }
  elseif kind == "local" then model:load { member = member, q = own or { 0, -load, 0 }, axes = "local" }
  else model:gravity { 0, 0, -load / (rho * width ^ 2) } end
end

-- A straight member with `load` per length, N/m, down.
local function beam(ends, kind, load, options)
  local model = hinge.model(merged({ displacement = "small" }, options))
  local a, b = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  local member = model:member { a, b, section = section, material = steel }
  model:fix(a, ends[1])
  model:fix(b, ends[2])
  presses(model, member, kind, load)
  return { model = model, a = a, b = b, member = member }
end
local function limit(model, options)
  local run = model:static(merged({ steps = 20, to_limit = true }, options)):finish()
  equal(run.verdict, "completed", "limit run")
  expect(run.reason:find "limit load" ~= nil, "ends at a limit load")
  return run
end

case("hinges stand at nodes, and the collapse load does not depend on where they are", function()
  -- Hinges stand at nodes. In a propped beam the best place is 0.414 L from the prop, so that the limit is that of the
  -- node with the least: 2 (1/x + 2/(L - x)) Mp/L, x from the prop.
  local function propped_limit(n)
    local least = math.huge
    for i = 1, n - 1 do least = support.smallest_of(least, 2 * (n / i + 2 * n / (n - i))) end
    return least
  end

  for _, kind in ipairs { "q", "local", "weight" } do
    for _, n in ipairs { 2, 4, 8 } do
      local options = { elements_per_member = n }
      local what = ("%s, %d elements: "):format(kind, n)
      for name, row in pairs {
        pinned = { pinned, 8 }, clamped = { clamped, 16 }, propped = { propped, propped_limit(n) },
      } do
        -- Load beyond the limit, so that the limit stops it.
        local s = beam(row[1], kind, 1.5 * row[2] * unit, options)
        close(1.5 * limit(s.model).factor, 1, what .. name .. ", limit load", 1e-4)
      end
      -- First yield: of a clamped beam at its ends with w L^2/12. A pinned one has its limit there.
      for _, row in ipairs { { pinned, 8, 0.999 }, { clamped, 12, 0.999 }, { clamped, 12, 1.001 } } do
        local s = beam(row[1], kind, row[3] * row[2] * unit, options)
        local run = s.model:static { steps = 4 }:finish()
        local state, f_y = s.member:state(run)
        local at = ("first yield, %g of %g: "):format(row[3], row[2])
        equal(state, row[3] < 1 and "elastic" or "yielded", what .. at .. "state")
        close(f_y, math.min(1, row[3] ^ 2), what .. at .. "f_y", 1e-9)
        local ends_f_y = support.largest_of(run:read("f_y_a")[1], run:read("f_y_b")[1])
        if row[2] == 12 then close(ends_f_y, f_y, what .. at .. "f_y at the ends", 1e-9) end
      end
    end
  end
end)

case("a portal whose beam carries q between strong columns falls with its beam mechanism", function()
  -- A portal whose beam carries q between strong columns: its own mechanism, but for what N takes of Mp.
  for _, n in ipairs { 2, 4, 8 } do
    for _, kind in ipairs { "q", "weight" } do
      local light = hinge.material { E = 206e9, density = 1e-6, yield_stress = sigma }
      local model, _, member = scenes.portal { model = { displacement = "small", elements_per_member = n }, height = 2,
        column = { section = strong, material = light, up = { 0, 1, 0 } }, heads = "y,rx,rz",
        beam = { section = section, material = steel } }
      presses(model, member[2], kind, 1.5 * 16 * Mp / 4 ^ 2)
      close(1.5 * limit(model).factor, 1, ("portal, %s, %d elements: limit load"):format(kind, n), 1e-3)
    end
  end
end)

case("a hanging bar yields under its own weight at its top", function()
  -- A hanging bar: N at its support is the whole of the load along it.
  for _, kind in ipairs { "q", "local", "weight" } do
    for _, n in ipairs { 2, 4 } do
      local model, _, bar = scenes.cantilever { model = { displacement = "small", elements_per_member = n }, length = L,
        along = { 0, 0, -1 }, member = { section = section, material = steel } }
      local load = 1.5 * sigma * width ^ 2 / L
      presses(model, bar, kind, load, { 0, 0, load })
      local run = limit(model)
      local what = ("hanging, %s, %d elements: "):format(kind, n)
      close(1.5 * run.factor, 1, what .. "limit load", 1e-4)
      near(select(2, bar:state(run)), 1, 1e-3, what .. "f_y")
      expect(select(2, bar:state(run)) <= 1 + 1e-9, what .. "f_y on the surface")
    end
  end
end)

case("hinges dissipate what the loads do beyond the elastic energy", function()
  -- What hinges dissipate: Mp times their rotation, and the balance closes. Driven by the rotation of an end beyond the
  -- limit, the pinned beam bends in the middle alone, by twice that rotation; of two members with a joint in the
  -- middle, clamped, hinges rotate by 4 u / (L/2) in all. `by_member`: bending that follows N, with no N here to speak
  -- of.
  local settings = {
    { "small", { displacement = "small" } }, { "chord", { displacement = "large", p_delta = "chord" } },
    { "by member", { displacement = "large", p_delta = "member" } },
  }
  for _, setting in ipairs(settings) do
    for _, kind in ipairs { "q", "weight" } do
      local what = ("%s, %s: "):format(kind, setting[1])
      local s = beam(pinned, kind, 1.05 * 8 * unit, setting[2]) -- 8 itself: rounding decides whether it yields at all
      for _, control in ipairs { "displacement", setting[1] == "small" and "arc" or nil } do
        local run = control == "displacement"
            and s.model:static { steps = 20, control = { node = s.a, "ry", to = 0.06 } }
          or s.model:static { steps = 25, control = "arc" }
        local first
        while run:step() do
          local _, f_y = s.member:state(run)
          if f_y > 1 - 1e-6 and not first then
            first = { math.abs(select(5, run:displacement(s.a))), run.energy.plastic, run.energy.energy_error }
          end
        end
        expect(run.verdict ~= "failed", what .. control .. ": " .. run.reason)
        local turned = 2 * (math.abs(select(5, run:displacement(s.a))) - first[1])
        local e = run.energy
        if expect(turned > 0.01, what .. control .. ", has a mechanism: " .. turned) then
          close(e.plastic - first[2], Mp * turned, what .. control .. ", plastic", setting[1] == "small" and 1e-6
            or 3e-3)
          -- before it, in the step in which it begins to yield, the means of statics miss the kink
          local part = setting[1] == "small" and 1e-9 or 1e-4
          near(e.energy_error, first[3], part * e.plastic, what .. control .. ", balance")
          close(run:read("plastic_work")[1], e.plastic, what .. control .. ", of the member", 1e-12)
          close(1.05 * run.factor, 1, what .. control .. ", factor", setting[1] == "small" and 1e-6 or 5e-3)
        end
      end
    end
  end
end)

case("a fracture rule reads the forces that member:forces gives", function()
  for _, kind in ipairs { "q", "weight" } do
    local what = ("rule, %s: "):format(kind)
    local s = beam(clamped, kind, 6 * unit)
    local told = {}
    s.model:fracture { group = s.group, where = "all", rule = function(v)
      if v.element ~= v["end"] then return end
      told[v.element] = { Mx = v.Mx, My = v.My, N = v.N, Mz = v.Mz, f_y = v.f_y }
    end }
    local run = s.model:dynamic { dt = 1e-5, duration = 1e-3 }:finish()
    local forces = { s.member:forces(run) }
    for e = 1, 2 do
      for name, value in pairs(told[e] or { f_y = 0 / 0 }) do
        near(value, forces[e][name], 1e-6 * (name == "f_y" and 1 or Mp), what .. name .. " at end " .. e)
      end
    end
    expect(math.abs(forces[1].Mx) > 0.01 * Mp, what .. "has moments")
  end
end)

case("slow dynamics follows statics", function()
  -- Slow dynamics: a pinned beam carries half its limit load, by weight or q, from statics, and the rest and 2 % more
  -- is let on slowly. It yields where the whole is 8 Mp / L^2, within what vibration adds; f_y told stays on the
  -- surface; and what its hinge dissipates is Mp times the rotation of its ends beyond the elastic one.
  local slowly = 1 -- s, 30 periods
  for _, how in ipairs {
    { "newmark", { dt = 5e-4 } },
    { "explicit", { dt = "auto", integrator = "explicit" } },
    { "energy-momentum", { dt = 5e-4, integrator = "energy-momentum" }, { displacement = "large" } },
  } do
    for _, kind in ipairs { "q", "weight" } do
      for _, n in ipairs { 2, 4 } do
        local what = ("%s, %s, %d elements, slowly: "):format(how[1], kind, n)
        local s = beam(pinned, kind, 4 * unit, merged({ elements_per_member = n, p_delta = how[3] and "chord" },
          how[3]))
        local still = s.model:static { steps = 1 }:finish()
        s.model:load { member = s.member, q = { 0, 0, -4.08 * unit },
          history = function(t) return t < slowly and (t / slowly) ^ 2 * (3 - 2 * t / slowly) or 1 end }
        local run = s.model:dynamic(merged({ from = still, duration = slowly, energy_tolerance = 1 }, how[2]))
        local yields, most, slope
        while run:step() do
          local state, f_y = s.member:state(run)
          most = support.largest_of(most or f_y, f_y)
          if state == "yielded" and not yields then
            local t = run.time / slowly
            yields, slope = 4 + 4.08 * t ^ 2 * (3 - 2 * t), math.abs(select(5, run:displacement(s.a)))
          end
        end
        expect(yields, what .. "yields")
        if yields then
          close(yields, 8, what .. "load at first yield", 5e-3)
          near(most, 1, 1e-6, what .. "largest f_y")
          local e, turned = run.energy, 2 * (math.abs(select(5, run:displacement(s.a))) - slope)
          expect(turned > 1e-2, what .. "turns by %g", turned)
          close(e.plastic, Mp * turned, what .. "plastic", 2e-2)
          near(e.energy_error, 0, 1e-4 * e.plastic, what .. "balance")
        end
      end
    end
  end
end)

-- A clamped bar, whose loads between its nodes are several times what its sections can carry at fixed ends.
local function struck_bar(elements, load)
  local model, far, bar = scenes.cantilever { length = 4, member = { elements = elements,
    section = hinge.section.round { diameter = 0.03 },
    material = hinge.material { E = 206e9, density = rho, yield_stress = 355e6 } } }
  model:fix(far)
  model:load(scenes.with(load, { member = bar }))
  return model
end
local function fails_by_loads(run)
  return run.verdict == "failed" and support.has(run.reason, "yields by the loads between its nodes alone")
    and support.has(run.reason, "more elements") and support.has(run.reason, "history")
end

case("where loads between nodes act at once and make an element yield by themselves, the failure names that", function()
  local jump = { { 0, 0 }, { 1e-3, 0 }, { 1e-3, 1 } }
  for _, load in ipairs {
    { elements = 2, at = 0.6, force = { 0, 0, -2e5 } },
    { elements = 2, at = 0.6, force = { 0, 2e5, 0 } },
    { elements = 4, at = 0.6, force = { 0, 0, -2e4 } },
    { elements = 8, at = 0.6, force = { 0, 0, -2e5 } },
    { elements = 2, q = { 0, 0, -5e4 } },
    { elements = 2, q = { 0, 0, -5e4 }, history = jump },
  } do
    for _, settings in ipairs { { dt = 1e-4 }, { dt = "auto" }, { dt = "auto", integrator = "explicit" } } do
      local what = ("%d elements, at %s, dt = %s, %s"):format(load.elements, load.at, settings.dt,
        settings.integrator)
      local given = { at = load.at, force = load.force, q = load.q, history = load.history }
      local run = struck_bar(load.elements, given):dynamic(merged({ duration = 2e-3, record = false }, settings))
      run:finish()
      expect(fails_by_loads(run), "%s: %s, %s", what, run.verdict, run.reason)
    end
  end
end)

-- Of the clamped bar: an even load or a force at `at`, as a part of that at first yield. Fixed-end moments are
-- q l^2 / 12 and P a b^2 / l^2.
local carries = 355e6 * 0.03 ^ 3 / 6 -- N m
local function beyond_first_yield(part, at, history)
  if not at then return { q = { 0, 0, -part * carries * 12 / 4 ^ 2 }, history = history } end
  local near_end, far_end = 4 * support.smallest_of(at, 1 - at), 4 * support.largest_of(at, 1 - at)
  return { at = at, force = { 0, 0, -part * carries * 4 ^ 2 / (near_end * far_end ^ 2) }, history = history }
end

case("loads between nodes that act at once are named by little more than what sections carry", function()
  for _, of in ipairs { { 1.6, 0.8 }, { 1.6, 0.2 }, { 2, 0.8 }, { 3, 0.6 }, { 3 } } do
    local what = ("%g times first yield, at %s: "):format(of[1], of[2])
    local run = struck_bar(2, beyond_first_yield(of[1], of[2])):dynamic { dt = 1e-4, duration = 2e-3, record = false }
    run:finish()
    expect(fails_by_loads(run), what .. "%s, %s", run.verdict, run.reason)
    equal(run.failure.cause, "energy_lost_in_step", what .. "cause")
    local times = tonumber(run.reason:match "forces are (%S+) times")
    expect(times > 1 and times < 1.4, what .. "fixed-end forces are %s times", times)
  end
end)

case("loads between nodes that grew slowly are not named where a run fails for another reason", function()
  -- A pendulum in steps that are too long, beside the clamped bar. Its load is there after 2 s, and beyond what it
  -- carries without its tension: the fixed-end forces are 1.1 and 3 times what a section carries.
  local failed = 0 -- whether it does hangs on rounding: the pendulum is chaotic in such steps
  for _, part in ipairs { 2, 2.5, 3.5, 4.4, 5 } do
    local model = struck_bar(2, beyond_first_yield(part, nil, { { 0, 0 }, { 2, 1 } }))
    local pin, free = model:node { 0, 5, 0 }, model:node { 2, 5, 0 }
    model:fix(pin, "xyz rx rz")
    local bar = model:member { pin, free, section = hinge.section.solid { width = 0.02, depth = 0.02 },
      material = hinge.material { E = 210e9, density = rho } }
    model:load { member = bar, q = { 0, 0, -9.81 * rho * 4e-4 } }
    local run = model:dynamic { dt = 5e-3, duration = 8, step_control = 0, record = false }:finish()
    if run.verdict == "failed" then
      failed = failed + 1
      expect(not support.has(run.reason, "between its nodes"), "%g: %s", part, run.reason)
      expect(support.has(run.reason, "step_control = 0.01 holds"), "%g: %s", part, run.reason)
    end
  end
  expect(failed > 1, "only %d of 5 fail", failed)
end)

case("the remedies that such a failure names hold: elements, a node at the load, a load that grows", function()
  local grows = { { 0, 0 }, { 2e-3, 1 } }
  for _, load in ipairs {
    { elements = 10, at = 0.6, force = { 0, 0, -2e5 } },
    { elements = 10, at = 0.6, force = { 0, 0, -2e4 } },
    { elements = 8, at = 0.6, force = { 0, 0, -2e5 }, history = grows },
    { elements = 4, at = 0.6, force = { 0, 0, -2e4 }, history = grows },
    { elements = 16, q = { 0, 0, -5e4 } },
    { elements = 2, q = { 0, 0, -5e4 }, history = grows },
  } do
    local given = { at = load.at, force = load.force, q = load.q, history = load.history }
    local run = struck_bar(load.elements, given):dynamic { dt = 1e-4, duration = 4e-3, record = false }:finish()
    local what = ("%d elements, at %s, history %s: "):format(load.elements, load.at, load.history ~= nil)
    equal(run.verdict, "completed", what .. run.reason)
    near(run.energy_error, 0, 0.01, what .. "energy error")
  end
end)

checks.done()

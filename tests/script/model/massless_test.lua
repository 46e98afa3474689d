-- Members without mass between point masses: modes and dynamics are those of the statically condensed structure.
--
-- Run: lua5.4 tests/script/model/massless_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "members without mass"
local runs = require "runs"(checks)
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local E, G = 200e9, 77e9
local function steel(density, yield) return hinge.material { E = E, G = G, density = density, yield_stress = yield } end
local weightless = hinge.material { E = E, G = G }
local bar = hinge.section.solid { width = 0.1, depth = 0.2 }
local L, mass = 3, 500

-- A cantilever of one member with a mass on its tip, in a direction of space.
local function cantilever(options, along, given)
  local m, tip, arm = scenes.cantilever { model = options, length = L, along = along, member = { section = bar,
    material = weightless, elements = given and given.elements, up = along[3] == 1 and { 1, 0, 0 } or { 0, 0, 1 } } }
  m:mass { node = tip, mass = mass, inertia = given and given.inertia }
  return m, tip, arm
end

local function flexibility(I, shear_area) return L ^ 3 / (3 * E * I) + L / (G * shear_area) end
local stiff = 1 / flexibility(bar.Ix, bar.shear_area_y)

for name, along in pairs { x = { 1, 0, 0 }, y = { 0, 1, 0 }, z = { 0, 0, 1 }, diagonal = { 0.6, 0, 0.8 } } do
  case("frequencies of a cantilever with a tip mass by hand: along " .. name, function()
    for _, displacement in ipairs { "small", "large" } do
      for _, elements in ipairs { 2, 6 } do
        local m = cantilever({ displacement = displacement }, along, { elements = elements })
        local modes = m:static { steps = 1 }:finish():modes { n = 6 }
        equal(#modes, 3, "modes: as many as the mass has directions")
        local by_hand = { flexibility(bar.Iy, bar.shear_area_x), flexibility(bar.Ix, bar.shear_area_y),
          L / (E * bar.area) }
        for i, f in ipairs(by_hand) do
          near(modes[i].frequency * 2 * math.pi * math.sqrt(mass * f), 1, 1e-9,
            ("%d elements, mode %d"):format(elements, i))
        end
      end
    end
  end)
end

case("rotary inertia of the mass counts: two frequencies of bending in a plane by hand", function()
  local J = 200
  local m = cantilever({ displacement = "small" }, { 1, 0, 0 }, { inertia = { 0, J, 0 } })
  local modes = m:static { steps = 1 }:finish():modes { n = 6 }
  equal(#modes, 4, "modes")
  -- flexibility of the tip: displacement w and rotation t by force and moment
  local ww, wt, tt = flexibility(bar.Ix, bar.shear_area_y), L ^ 2 / (2 * E * bar.Ix), L / (E * bar.Ix)
  local p, q = mass * ww + J * tt, mass * J * (ww * tt - wt ^ 2)
  local first, second = (p + math.sqrt(p ^ 2 - 4 * q)) / 2, (p - math.sqrt(p ^ 2 - 4 * q)) / 2
  local function has(inverse)
    local wanted, best = 1 / math.sqrt(inverse) / (2 * math.pi), math.huge
    for _, mode in ipairs(modes) do best = support.smallest_of(best, math.abs(mode.frequency / wanted - 1)) end
    expect(best < 1e-9, "%g Hz is off by %g", wanted, best)
  end
  has(first)
  has(second)
end)

-- Two storeys in the plane of x and z with masses on the floors; hold: what supports hold of each head.
local function frame(material, options, more)
  local m = hinge.model(options or { displacement = "small" })
  local nodes = { [0] = {}, {}, {} }
  for k = 0, 2 do
    for i = 0, 1 do
      nodes[k][i] = m:node { 5 * i, 0, 3 * k }
      m:fix(nodes[k][i], k == 0 and "all" or "y,rx,rz")
      if k > 0 then
        m:member { nodes[k - 1][i], nodes[k][i], section = bar, material = material, up = { 1, 0, 0 } }
        m:mass { node = nodes[k][i], mass = 1000 * k }
      end
    end
    if k > 0 then
      m:member { nodes[k][0], nodes[k][1], section = bar, material = material, release = more and more.release }
    end
    if k > 0 and more and more.diaphragm then m:diaphragm { nodes = { nodes[k][0], nodes[k][1] } } end
  end
  return m, nodes
end

case("frequencies of a frame by its flexibility, with releases and a rigid floor", function()
  local kinds = { plain = {}, floor = { diaphragm = true }, released = { release = { a = { "Mx", "My" } } } }
  for name, more in pairs(kinds) do
    -- flexibility of sway with rigid floors needs two unknowns alone
    local m = frame(weightless, nil, more)
    local modes = m:static { steps = 1 }:finish():modes { n = 2 }
    local F, masses = {}, { 2000, 4000 }
    for k = 1, 2 do
      local unit, nodes = frame(weightless, nil, more)
      for i = 0, 1 do unit:load { node = nodes[k][i], force = { 0.5, 0, 0 } } end
      local run = unit:static { steps = 1 }:finish()
      F[k] = {}
      for j = 1, 2 do
        local a, b = nodes[j][0]:displacement(run), nodes[j][1]:displacement(run)
        F[k][j] = (a + b) / 2
      end
    end
    local a, b, c, d = F[1][1] * masses[1], F[1][2] * masses[2], F[2][1] * masses[1], F[2][2] * masses[2]
    local half = (a + d) / 2
    local largest = half + math.sqrt(half ^ 2 - a * d + b * c)
    -- the masses move upwards a little, and without a rigid floor apart
    near(modes[1].frequency * 2 * math.pi * math.sqrt(largest), 1, name == "floor" and 1e-5 or 1e-3, name)
  end
end)

case("more nodes than a dense solution takes: Lanczos' method gives the same as a tiny density", function()
  local function chain(density)
    local m = hinge.model { displacement = "small" }
    local last = m:node { 0, 0, 0 }
    m:fix(last)
    for i = 1, 40 do
      local node = m:node { i, 0, 0.1 * (i % 3) }
      m:member { last, node, section = bar, material = density and steel(density) or weightless }
      m:mass { node = node, mass = 100 + i, inertia = { 1, 2, 3 } }
      last = node
    end
    return m:static { steps = 1 }:finish():modes { n = 5 }
  end
  local without, tiny = chain(), chain(1e-3)
  for i = 1, 5 do near(without[i].frequency / tiny[i].frequency, 1, 1e-5, "mode " .. i) end
end)

for _, displacement in ipairs { "small", "large" } do
  case("what rests where statics ends stays there: " .. displacement, function()
    local m, tip = cantilever({ displacement = displacement }, { 1, 0, 0 }, { elements = 4 })
    m:load { node = tip, force = { 0, 0, -1e3 } }
    local rest = m:static { steps = 1 }:finish()
    local _, _, sag = tip:displacement(rest)
    local period = 2 * math.pi * math.sqrt(mass / stiff)
    local run = m:dynamic { dt = period / 400, duration = 1.5 * period, from = rest }
    local worst = 0
    while run:step() do
      local _, _, z = tip:displacement(run)
      worst = support.largest_of(worst, math.abs(z - sag))
    end
    expect(worst < 1e-6 * math.abs(sag), "it moves by %g m of %g", worst, sag)
  end)
end

case("free vibration of a tip mass: displacement, period and energy by hand", function()
  for _, elements in ipairs { 2, 4 } do
    local m, tip, arm = cantilever({ displacement = "small" }, { 1, 0, 0 }, { elements = elements })
    local omega = math.sqrt(stiff / mass)
    local period, v = 2 * math.pi / omega, 0.5
    m:velocity(tip, { 0, 0, v })
    local dt = period / 1000
    local run = runs.completed(m:dynamic { dt = dt, duration = 2.25 * period })
    -- the method's own frequency is lower by (w dt)^2 / 12
    local own = omega * (1 - (omega * dt) ^ 2 / 12)
    local _, _, z = tip:displacement(run)
    near(z, v / omega * math.sin(own * run.time), 1e-5 * v / omega, elements .. " elements: displacement")
    near(run.energy.elastic + run.energy.kinetic, 0.5 * mass * v ^ 2, 1e-6 * mass * v ^ 2,
      elements .. " elements: energy")
    near(math.abs(arm:forces(run).Mx), math.abs(stiff * z * L), 2e-3 * math.abs(stiff * z * L) + 1e-6,
      elements .. " elements: moment at the foot")
  end
end)

case("a force that sets in at once on a node without mass moves it as statics does, without ringing", function()
  local m = hinge.model { displacement = "small" }
  local a, b, c = m:node { 0, 0, 0 }, m:node { 2, 0, 0 }, m:node { 4, 0, 0 }
  m:fix { a, c }
  m:member { a, b, section = bar, material = weightless }
  m:member { b, c, section = bar, material = weightless }
  local side = m:node { 2, 3, 0 }
  m:member { b, side, section = bar, material = weightless }
  m:mass { node = side, mass = 1e9 } -- it hardly moves
  m:load { node = b, force = { 0, 0, -1e4 } }
  local run = m:dynamic { dt = 1e-4, duration = 2e-3 }
  local first
  while run:step() do
    local _, _, z = b:displacement(run)
    first = first or z
    near(z, first, 1e-6 * math.abs(first), "displacement at " .. run.time)
  end
  expect(first < -1e-6, "it moves by %g m", first)
  local _, _, v = run:velocity(b)
  expect(math.abs(v) < 1e-3 * math.abs(first) / 1e-4, "its velocity is %g m/s", v)
end)

case("damping by beta acts as on the condensed structure", function()
  local m, tip = cantilever({ displacement = "small" }, { 1, 0, 0 }, { elements = 4 })
  local omega = math.sqrt(stiff / mass)
  local part = 0.05
  m:damping { beta = 2 * part / omega }
  local v = 0.5
  m:velocity(tip, { 0, 0, v })
  local damped = omega * math.sqrt(1 - part ^ 2)
  local run = runs.completed(m:dynamic { dt = 2 * math.pi / omega / 500, duration = 1.75 * 2 * math.pi / damped })
  local _, _, z = tip:displacement(run)
  near(z, v / damped * math.exp(-part * omega * run.time) * math.sin(damped * run.time), 1e-3 * v / omega,
    "displacement")
end)

case("hinges form as in statics, and as with a tiny density", function()
  local function pushed(material)
    local m, nodes = frame(material, {}, { diaphragm = true })
    m:load { node = nodes[2][0], force = { 3e5, 0, 0 }, history = { { 0, 0 }, { 0.1, 1 }, { 0.2, 0 } } }
    local run = runs.completed(m:dynamic { dt = 5e-4, duration = 0.4 })
    runs.balanced(run, 0.01, "work", "pushed")
    return nodes[2][0]:displacement(run), run.energy.plastic
  end
  local u, work = pushed(hinge.material { E = E, G = G, yield_stress = 235e6 })
  local u_tiny, work_tiny = pushed(steel(1e-2, 235e6))
  expect(work > 100, "plastic work is %g J", work)
  near(u / u_tiny, 1, 0.01, "displacement that stays")
  near(work / work_tiny, 1, 0.01, "plastic work")
end)

case("a column without mass is removed", function()
  local m, nodes = frame(weightless, {})
  m:gravity { 0, 0, -9.81 }
  local rest = m:static { steps = 1 }:finish()
  m:remove { member = m:members()[1], at = rest.time + 0.01, over = 0.005 }
  local run = runs.completed(m:dynamic { dt = 1e-3, duration = 0.1, from = rest })
  local _, _, z = nodes[1][0]:displacement(run)
  expect(z < -1e-3, "the joint above falls by %g m", z)
end)

case("what needs a mass is refused, and says how much", function()
  local function refused(words, m, options)
    checks.refused(words, m.dynamic, m, scenes.with({ dt = 1e-3, duration = 0.1 }, options))
  end
  local m = cantilever({}, { 1, 0, 0 })
  for _, integrator in ipairs { "explicit", "energy-momentum" } do
    refused("needs a mass at each node", m, { integrator = integrator })
  end
  refused("follows waves along members", m, { dt = "auto" })
  local none = scenes.cantilever { member = { material = weightless } }
  refused("nothing has mass", none)
  checks.refused("has mass", function() none:static { steps = 1 }:finish():modes() end)
  local breaks, meets = cantilever({}, { 1, 0, 0 }), cantilever({}, { 1, 0, 0 })
  breaks:fracture { axial_strain = 0.1 }
  refused("can break", breaks)
  meets:contact {}
  refused("is stopped by its mass", meets)
end)

case("a run that goes on from a checkpoint is the same", function()
  runs.resumes(function()
    local m, tip = cantilever({}, { 1, 0, 0 }, { elements = 4 })
    m:velocity(tip, { 0, 0, 1 })
    return m:dynamic { dt = 1e-3, duration = 0.1 }
  end, 0.05, "swinging")
end)

checks.done()

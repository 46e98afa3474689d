-- Slabs of floors: nodes inside members, weights and loads, what a slab holds where a column or beams go, rest; floors
-- that do not fit are refused and lay nothing.
--
-- Run: lua5.4 tests/script/effects/slabs_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "slabs"
local case = checks.case
local function near(what, value, wanted, tolerance) checks.near(value, wanted, tolerance, what) end
local function equal(what, value, wanted) checks.equal(value, wanted, what) end

local g = 9.80665 -- m/s^2
local function z_of(run, node) return (select(3, run:displacement(node))) end
local steel = hinge.material { E = 200e9, G = 80e9, density = 7850, yield_stress = 300e6 }
local beam = hinge.section.h { depth = 0.3, width = 0.15, web = 0.008, flange = 0.012 }
local column = hinge.section.box { width = 0.3, depth = 0.3, thickness = 0.012 }

local function house(slab, options)
  local model = hinge.model { elements_per_member = 4 }
  local n = {}
  for i = 0, 2 do
    n[i] = {}
    for j = 0, 2 do
      local foot = model:node { 6 * i, 5 * j, 0 }
      model:fix(foot)
      n[i][j] = model:node { 6 * i, 5 * j, 4 }
      model:member { foot, n[i][j], section = column, material = steel,
        group = i == 1 and j == 1 and "lost" or "columns" }
    end
  end
  for i = 0, 2 do
    for j = 0, 2 do
      for _, to in ipairs { i < 2 and n[i + 1][j] or false, j < 2 and n[i][j + 1] or false } do
        if to then model:member { n[i][j], to, section = beam, material = steel, group = "beams" } end
      end
    end
  end
  model:gravity { 0, 0, -g }
  local o = { group = "beams", mass = 350, load = 2e3, slab = slab }
  for key, value in pairs(options or {}) do o[key] = value end
  return model, model:floor(o), n
end
local function concrete_slab()
  return { concrete = { thickness = 0.12, strength = 30e6, E = 30e9 },
    reinforcement = { x = 4e-4, y = 4e-4, yield_stress = 500e6, hardening = 1e9, ultimate_strain = 0.05 },
    bending = { stiffness = 1e6, sagging = 17e3, hogging = 17e3 } }
end

case("a node inside a member is the one that it has there, for loads and panels", function()
  local model = hinge.model { displacement = "small", elements_per_member = 4 }
  local a, b = model:node { 0, 0, 0 }, model:node { 4, 0, 0 }
  model:fix { a, b }
  local member = model:member { a, b, section = beam, material = steel }
  local middle = member:node(2)
  equal("place", middle.x, 2)
  equal("once", member:node(2).index, middle.index)
  model:load { node = middle, force = { 0, 0, -1e4 } }
  local run = model:static { steps = 1 }
  equal("known", member:node(2).index, middle.index) -- does not outdate the run
  run:finish()
  local halves = hinge.model { displacement = "small" }
  local ends = { halves:node { 0, 0, 0 }, halves:node { 2, 0, 0 }, halves:node { 4, 0, 0 } }
  halves:fix { ends[1], ends[3] }
  for i = 1, 2 do halves:member { ends[i], ends[i + 1], section = beam, material = steel, elements = 2 } end
  halves:load { node = ends[2], force = { 0, 0, -1e4 } }
  local both = halves:static { steps = 1 }:finish()
  near("as a node between members", z_of(run, middle), z_of(both, ends[2]), 1e-12)
  for _, wrong in ipairs { 0, 4, 1.5, "1" } do
    equal("refused", pcall(member.node, member, wrong), wrong == "1")
  end
end)

case("a floor with a slab has the same weight and load as without, and holds what has lost its column", function()
  local sag = {}
  for _, slab in ipairs { false, true } do
    local model, floor, n = house(slab and concrete_slab() or nil)
    near("mass", floor.mass, 350 * 120, 1e-9 * 350 * 120)
    near("load", floor.load, 2e3 * 120, 1e-9 * 2e3 * 120)
    local static = model:static { steps = 2 }:finish()
    local sum, own = 0, 0
    for _, node in ipairs(model:nodes()) do
      if node.fixed then sum = sum + select(3, static:reaction(node)) end
    end
    for _, member in ipairs(model:members()) do own = own + member.length * member.section.area * 7850 end
    near("reactions", sum, (350 * 120 + own) * g + 2e3 * 120, 1e-6 * sum)
    model:remove { group = "lost", at = 0 }
    local run = model:dynamic { from = static, duration = 0.4, dt = 1e-3 }:finish()
    near("energy error", run.energy_error, 0, 1e-3)
    sag[#sag + 1] = z_of(run, n[1][1])
  end
  equal(("the slab helps: %g and %g m"):format(sag[1], sag[2]), sag[2] > 0.9 * sag[1] and sag[2] < 0, true)
end)

case("a slab at rest from statics stays at rest", function()
  local model, _, n = house(concrete_slab())
  local static = model:static { steps = 2, tolerance = 1e-12 }:finish()
  for _, integrator in ipairs { "newmark", "explicit" } do
    local run = model:dynamic { from = static, duration = 0.01, dt = integrator == "explicit" and 1e-5 or 1e-3,
      integrator = integrator }:finish()
    near(integrator, z_of(run, n[1][1]), z_of(static, n[1][1]), 1e-8)
  end
end)

case("beams that break under a slab go, and the slab goes on", function()
  for _, integrator in ipairs { "newmark", "explicit" } do
    local model, floor = house(concrete_slab())
    local beams = model:group("beams"):members()
    model:remove { member = beams[1], at = 2e-3 }
    model:remove { member = beams[4], at = 2e-3 }
    local run = model:dynamic { duration = 0.01, dt = integrator == "explicit" and 1e-5 or 5e-4,
      integrator = integrator }:finish()
    equal(integrator, run.verdict, "completed")
    near("energy error", run.energy_error, 0, 1e-3)
    for _, panel in ipairs(floor.slab) do equal("torn", panel:torn(run), false) end
  end
end)

case("a floor whose sides do not fit is refused", function()
  local model = hinge.model()
  local ring = {}
  for i, q in ipairs { { 0, 0 }, { 6, 0 }, { 6, 4 }, { 0, 4 } } do ring[i] = model:node { q[1], q[2], 3 } end
  for i = 1, 4 do
    model:member { ring[i], ring[i % 4 + 1], section = beam, material = steel, elements = i == 1 and 4 or 2 }
  end
  local good, why = pcall(model.floor, model, { members = model:members(), slab = concrete_slab() })
  equal("refused", good, false)
  equal("why", why:find("have 4, 2, 2, 2 elements", 1, true) ~= nil, true)
end)

case("a floor whose slab is refused lays nothing: neither panels nor nodes", function()
  local model = hinge.model { elements_per_member = 2 }
  local at = {}
  for i, x in ipairs { 0, 4, 8 } do
    for j, y in ipairs { 0, 4 } do at[2 * i + j - 2] = model:node { x, y, 0 } end
  end
  local function join(a, b, n)
    model:member { at[a], at[b], section = beam, material = steel, elements = n }
  end
  for _, ends in ipairs { { 1, 3 }, { 2, 4 }, { 1, 2 }, { 3, 4 }, { 3, 5 }, { 4, 6, 4 }, { 5, 6 } } do
    join(ends[1], ends[2], ends[3]) -- the second bay does not fit
  end
  local nodes = #model:nodes()
  for _, slab in ipairs { concrete_slab(), { concrete = { thickness = 0.1, E = 3e10, colour = 1 } } } do
    equal("refused", pcall(model.floor, model, { members = model:members(), slab = slab }), false)
    equal("nodes", #model:nodes(), nodes)
  end
end)

checks.done()

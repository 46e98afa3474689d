-- Panels that bend by their layers: elastic plates, cracked and yielding concrete against sections by hand, moments
-- beside membrane forces, slabs against yield lines; energies, the same from every side; wrong input is refused.
--
-- Run: lua5.4 tests/script/effects/panel_layers_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local panel_cells = require "panel_cells"
local hinge = require "hinge"
local checks = support.checks "panel layers"
local case = checks.case
local function near(what, value, wanted, tolerance) checks.near(value, wanted, tolerance, what) end
local function equal(what, value, wanted) checks.equal(value, wanted, what) end

local function z_of(run, node) return (select(3, run:displacement(node))) end

-- A strip of one row of panels along x, from a hinge to a roller. `turn`: rotation of everything about z, rad.
local function strip(o)
  local n, length, width, turn = o.panels or 8, 4, 1, o.turn or 0
  local model = hinge.model { displacement = o.displacement or "small" }
  local c, s = math.cos(turn), math.sin(turn)
  local rows = {}
  for i = 0, n do
    rows[i] = {}
    for j = 0, 1 do
      local x, y = length * i / n, width * j
      rows[i][j] = model:node { c * x - s * y, s * x + c * y, 0 }
    end
  end
  for j = 0, 1 do
    model:fix(rows[0][j], "xyz")
    model:fix(rows[n][j], "z")
    if turn == 0 then model:fix(rows[n][j], "y") end
  end
  for i = 1, n do
    local corners = { rows[i - 1][0], rows[i][0], rows[i][1], rows[i - 1][1] }
    if o.upside_down then corners[2], corners[4] = corners[4], corners[2] end
    local sheet = { corners[1], corners[2], corners[3], corners[4], along = { c, s, 0 } }
    for key, value in pairs(o.sheet) do sheet[key] = value end
    model:panel(sheet)
  end
  for j = 0, 1 do
    for i = 1, n - 1 do
      model:load { node = rows[i][j], force = { 0, 0, -o.q * length / n * width / 2 }, history = o.history }
    end
    if o.pull then model:load { node = rows[n][j], force = { o.pull / 2, 0, 0 } } end
  end
  return model, rows, rows[n // 2][0], n
end

local h, strength, E, area, yield = 0.12, 30e6, 30e9, 393e-6, 500e6
local function concrete(z, options)
  local sheet = { concrete = { thickness = h, strength = strength, E = E }, bending = "layers",
    reinforcement = { x = area, y = area, z = z, yield_stress = yield } }
  for key, value in pairs(options or {}) do sheet[key] = value end
  return sheet
end
-- The plastic moment per width of bars at the distance z below the middle, beside a force that pulls, by hand.
local function plastic_moment(z, pull)
  local block = (area * yield - (pull or 0)) / strength
  return area * yield * z + block * strength * (h - block) / 2
end

case("an elastic plate is that of its thickness, to rounding", function()
  local steel, at = hinge.material { E = 200e9, G = 80e9 }, {}
  for i, bending in ipairs { "layers", false } do
    local model = hinge.model { displacement = "small" }
    local nodes = panel_cells.lay(model, 4, 4, function(a, b) return { a, 0.8 * b, 0 } end,
      { thickness = 0.02, material = steel, bending = bending or nil }, true)
    for a = 0, 4 do
      for b = 0, 4 do
        if panel_cells.on_edge(a, b, 4) then model:fix(nodes[a][b], "xyz") end
      end
    end
    model:load { node = nodes[1][2], force = { 0, 0, -1e3 } }
    local run = model:static { steps = 1 }:finish()
    at[i] = { z_of(run, nodes[1][2]), z_of(run, nodes[2][2]), z_of(run, nodes[3][1]) }
  end
  for k = 1, 3 do near("deflection " .. k, at[1][k], at[2][k], 1e-9 * math.abs(at[2][k])) end
end)

case("cracked concrete has the stiffness of its section in state II", function()
  local n, d = 200e9 / E * area, h / 2 + 0.03
  local x = -n + math.sqrt(n * n + 2 * n * d)
  local stiffness = E * x ^ 3 / 3 + 200e9 * area * (d - x) ^ 2
  local model, _, middle = strip { panels = 16, q = 1e3, sheet = concrete(-0.03) }
  local run = model:static { steps = 1 }:finish()
  near("deflection", -z_of(run, middle), 5 * 1e3 * 4 ^ 4 / 384 / stiffness, 0.01 * 0.0072) -- six levels: 0.7 %
end)

-- The largest part of a load that statics reaches.
local function limit(o)
  local model = strip(o)
  local run = model:static { steps = 40 }:finish()
  return run.factor, run
end

case("a strip carries its plastic moment, sagging and hogging, in as many panels as one likes", function()
  local q = 8 * plastic_moment(0.03) / 4 ^ 2
  for _, panels in ipairs { 4, 8, 16 } do
    near(panels .. " panels", 1.2 * limit { panels = panels, q = 1.2 * q, sheet = concrete(-0.03) }, 1, 0.015)
  end
  near("hogging", 1.2 * limit { q = -1.2 * q, sheet = concrete(0.03) }, 1, 0.015)
  near("upside down", 1.2 * limit { q = 1.2 * q, sheet = concrete(0.03), upside_down = true }, 1, 0.015)
  near("turned by 40 degrees", 1.2 * limit { q = 1.2 * q, sheet = concrete(-0.03), turn = 0.7 }, 1, 0.015)
  near("bars at 45 degrees", 1.2 * limit { q = 1.2 * q, sheet = concrete(-0.03, { along = { 1, 1, 0 } }) }, 1, 0.015)
  local two = { { x = area, z = -0.03, yield_stress = yield }, { y = 4 * area, z = -0.03, yield_stress = yield } }
  near("bars across it do not count", 1.2 * limit { q = 1.2 * q, sheet = concrete(0, { reinforcement = two }) }, 1,
    0.015)
end)

case("the ribs of a deck hang below the concrete, and pull there", function()
  local sheet = { concrete = { thickness = h, strength = strength, E = E }, bending = "layers",
    deck = { area = area, z = -0.09, yield_stress = yield } }
  local q = 8 * plastic_moment(0.09) / 4 ^ 2
  near("moment", 1.2 * limit { q = 1.2 * q, sheet = sheet }, 1, 0.015)
end)

case("a force along the strip takes from its plastic moment or adds to it", function()
  for _, pull in ipairs { 120e3, -150e3 } do
    local q = 8 * plastic_moment(0.03, pull) / 4 ^ 2
    local factor = 1.2 * limit { q = 1.2 * q, pull = 1.2 * pull, sheet = concrete(-0.03) }
    near(("%g kN/m"):format(pull / 1e3), factor * q * 4 ^ 2 / 8, plastic_moment(0.03, factor * pull),
      0.025 * plastic_moment(0.03, factor * pull)) -- the block of compression acts at one of six levels
  end
end)

-- A square slab on four edges without a force along them. Its load grows to twice that of yield lines in a second.
-- Returns the model, its middle and the panels.
local function slab(n, sheet)
  local model = hinge.model()
  local nodes, panels = panel_cells.lay(model, n, n, panel_cells.square(4, n), sheet)
  for i = 0, n do
    for j = 0, n do
      local held = panel_cells.on_edge(i, j, n) and "z" or ""
      if i == n // 2 and (j == 0 or j == n) then held = held .. "x" end
      if j == n // 2 and (i == 0 or i == n) then held = held .. "y" end
      if held ~= "" then model:fix(nodes[i][j], held) end
    end
  end
  local q = 24 * plastic_moment(0.03) / 4 ^ 2
  for i = 1, n - 1 do
    for j = 1, n - 1 do
      model:load { node = nodes[i][j], force = { 0, 0, -q * (4 / n) ^ 2 }, history = function(t) return 2 * t end }
    end
  end
  return model, nodes[n // 2][n // 2], panels
end

case("a slab hangs in its bars beyond its yield lines; both methods agree, and their energies close", function()
  local sheet = concrete(-0.03)
  sheet.reinforcement.hardening = 1e9
  local sag = {}
  for _, integrator in ipairs { "explicit", "newmark" } do
    local model, middle = slab(4, sheet)
    model:damping { alpha = 20 }
    local run = model:dynamic { integrator = integrator, dt = 2e-4, duration = 1 }
    run:finish()
    sag[integrator] = -z_of(run, middle)
    near(integrator .. ": energy error", run.energy_error, 0, 1e-3)
    equal(integrator .. ": bars yield", run.energy.panel_dissipated > 1e3, true)
  end
  -- twice the load of yield lines (Johansen 1943), which bending alone does not carry, at 2.6 thicknesses
  near("Newmark as explicit", sag.newmark, sag.explicit, 1e-3 * sag.explicit)
  near("sag at twice the load", sag.explicit, 0.309, 0.003)
end)

case("a run goes on from a checkpoint with the same bits; bars that break release their energy", function()
  local function run_of()
    local sheet = concrete(-0.03)
    sheet.reinforcement.ultimate_strain = 0.01
    local model, _, panels = slab(4, sheet)
    model:damping { alpha = 20 }
    return model:dynamic { integrator = "explicit", dt = 2e-4, duration = 0.9 }, panels
  end
  local run, panels = run_of()
  local path, most = os.tmpname(), 0
  for step in run:steps() do
    if step.index == 2000 then run:checkpoint(path) end
  end
  for _, panel in ipairs(panels) do most = support.largest_of(most, panel:used(run)) end
  equal("bars broke", most >= 1, true)
  local again = run_of():resume(path):finish()
  equal("hash", again.hash, run.hash)
  os.remove(path)
  near("energy error", run.energy_error, 0, 1e-3)
end)

case("wrong layers are refused, and lay nothing", function()
  local model = hinge.model()
  local n = { model:node { 0, 0, 0 }, model:node { 1, 0, 0 }, model:node { 1, 1, 0 }, model:node { 0, 1, 0 } }
  local function refused(_, word, options)
    for i = 1, 4 do options[i] = n[i] end
    checks.refused({ "model:panel", word }, function() model:panel(options) end)
  end
  refused("a height without layers", "bending", { reinforcement = { x = area, z = 0.03 } })
  refused("bars in one plane", "bending", { reinforcement = { x = area }, bending = "layers" })
  refused("another word", "bending", { reinforcement = { x = area }, bending = "layer" })
  refused("a mesh that is no table", "reinforcement[2]", { reinforcement = { { x = area }, 3 }, bending = "layers" })
  refused("bars outside of the concrete", "z", concrete(0.2))
  refused("bars outside of the concrete over a deck", "z", concrete(0.2, { deck = { area = area, z = -0.09 } }))
  local many = {}
  for i = 1, 4 do many[i] = { x = area, y = area, z = 0.01 * i } end
  refused("more layers than a panel has", "9 layers", concrete(0, { reinforcement = many }))
  refused("a list with other fields", "reinforcement", concrete(0, { reinforcement = { { x = area }, y = area } }))
  n[4] = nil
  refused("a triangle", "triangles do not bend", concrete(-0.03))
end)

checks.done()

-- A square slab of reinforced concrete on four edges that do not hold it along itself: the load at which yield lines
-- form, and what membranes add to it as it sags.
--
-- Run     hinge run scripts/benchmarks/slab_yield_lines.lua
-- Shows   panels that bend by their layers: plastic moments beside membrane forces, nothing given but the concrete and
--         its bars
-- Expect  the plastic moment of a strip within 1 %, the load of yield lines within 1 %. Beyond it, Hayes' method is
--         rigid and plastic, so the sag of the elastic slab, 0.06 m, is added to its own. It is 5 % below the slab of
--         layers at a sag of one thickness and 10 % above it at two
local hinge = require "hinge"
local value_at = require "hinge.library.numeric".value_at

local L, h, depth = 4, 0.12, 0.09 -- m
local strength, bars, yield = 30e6, 393e-6, 500e6 -- Pa, m^2/m, Pa
local tension = bars * yield
local moment = tension * (depth - tension / strength / 2) -- N m/m, by hand
local johansen = 24 * moment / L ^ 2 -- Pa: isotropic, corners held down

local function sheet(hardening)
  return { concrete = { thickness = h, strength = strength, E = 30e9 }, bending = "layers", along = { 1, 0, 0 },
    reinforcement = { x = bars, y = bars, z = h / 2 - depth, yield_stress = yield, hardening = hardening } }
end

local function lay(model, n, m, options)
  local nodes = {}
  for i = 0, n do
    nodes[i] = {}
    for j = 0, m do nodes[i][j] = model:node { L * i / n, L * j / n, 0 } end
  end
  for i = 1, n do
    for j = 1, m do
      local o = { nodes[i - 1][j - 1], nodes[i][j - 1], nodes[i][j], nodes[i - 1][j] }
      for key, value in pairs(options) do o[key] = value end
      model:panel(o)
    end
  end
  return nodes
end

-- The plastic moment of a strip of one row of panels on two edges, from the load that statics reaches.
local function strip(n)
  local model = hinge.model { displacement = "small" }
  local nodes = lay(model, n, 1, sheet())
  local q = 9.6 * moment / L ^ 2
  for j = 0, 1 do
    model:fix(nodes[0][j], "xyz")
    model:fix(nodes[n][j], "yz")
    for i = 1, n - 1 do model:load { node = nodes[i][j], force = { 0, 0, -q * (L / n) ^ 2 / 2 } } end
  end
  local run = model:static { steps = 40 }:finish()
  assert(run.verdict == "failed", "the strip carries more than it should")
  return run.factor * q * L ^ 2 / 8
end

-- Load over that of yield lines, over the sag in the middle, up to a sag: in statics with small displacement; with
-- large displacement in dynamics, slowly.
local function slab(displacement, n, up_to, most, hardening)
  local model = hinge.model { displacement = displacement }
  local nodes = lay(model, n, n, sheet(hardening))
  local duration = 2
  for i = 0, n do
    for j = 0, n do
      if i == 0 or j == 0 or i == n or j == n then model:fix(nodes[i][j], "z")
      else
        model:load { node = nodes[i][j], force = { 0, 0, -up_to * johansen * (L / n) ^ 2 },
          history = displacement == "large" and function(t) return t / duration end or nil }
      end
    end
  end
  local half = n // 2
  for _, j in ipairs { 0, n } do
    model:fix(nodes[half][j], "x")
    model:fix(nodes[j][half], "y")
  end
  model:damping { alpha = 20 }
  local run = displacement == "small" and model:static { steps = 52 }
    or model:dynamic { integrator = "explicit", dt = 1e-4, duration = duration }
  local every = run.kind == "static" and 1 or 20
  local curve = { x = { 0 }, y = { 0 } }
  for step in run:steps() do
    local sag = -select(3, nodes[half][half]:displacement(run))
    if step.index % every == 0 and sag > curve.x[#curve.x] then
      table.insert(curve.x, sag)
      table.insert(curve.y, up_to * (every == 1 and run.factor or step.time / duration))
    end
    if sag > most then break end
  end
  return curve
end

-- Hayes 1968, as Bailey uses it for square isotropic slabs: n = 1/2, k = 1, b = 1.5; sag in m, without the elastic one.
local function hayes(sag)
  local g = 4 * moment / (tension * depth) - 3
  local alongside = 4 * 1.5 / (3 + g) * 0.375 * sag / depth
  return 1 - (1 - g) / (3 + g) * 1.5 ^ 2 / 3 + alongside
end

return hinge.benchmark {
  title = "Yield lines and membranes of a square slab", kind = "inelastic",
  source = "Johansen 1943 (yield lines); Hayes, Magazine of Concrete Research 20(65), 1968, with b of Bailey, "
    .. "Engineering Structures 26, 2004, without his factor 1.1",
  missing = "Hayes' slab is rigid and plastic; the elastic sag at the load of yield lines is added to his",
  run = function(b, job)
    local row = b:rows_with { unit = "kN m/m", elements = 8, steps = 40 }
    for _, n in ipairs { 4, 8 } do
      row(("strip of %d panels"):format(n), strip(n) / 1e3, moment / 1e3, nil, 0.015)
    end
    row = b:rows_with { unit = "of Johansen's", elements = 8, steps = 20000 }
    local small, large = slab("small", 8, 1.3, 0.2), slab("large", 8, 3, 0.3, 1e9)
    row("yield lines, small displacement, at 0.15 m", value_at(small, 0.15), 1, nil, 0.05)
    local elastic = value_at({ x = large.y, y = large.x }, 0.8) / 0.8
    local theory = { x = {}, y = {}, name = "Hayes" }
    for i = 0, 20 do
      theory.x[i + 1], theory.y[i + 1] = elastic + 0.0125 * i, hayes(0.0125 * i)
    end
    for _, sag in ipairs { 0.12, 0.18, 0.24 } do
      row(("sag of %.2f m"):format(sag), value_at(large, sag), hayes(sag - elastic), nil, 0.12)
    end
    small.name, large.name = "small displacement", "large displacement"
    job:plot({ x_label = "sag in the middle (m)", y_label = "load over that of yield lines", y_range = { 0, 3 },
      series = { small, large, theory }, title = "A square slab beyond its yield lines" }, "slab_yield_lines.png")
  end,
}

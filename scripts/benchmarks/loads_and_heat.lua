-- Beams under loads along them and under heat, to first order: end moments and deflections.
--
-- Run     hinge run scripts/benchmarks/loads_and_heat.lua
-- Shows   loads that vary along a member, a load at a point, a couple, heat of the whole section and across it
-- Expect  a beam clamped at both ends that does not shear: q L^2 / 20 and q L^2 / 30 under a load from 0 to q,
--         P a b^2 / L^2 under a load at a; a cantilever whose upper side is hotter by T: alpha T L^2 / (2 h) at the
--         tip, with alpha 12e-6; clamped at both ends: E I alpha T / h, and E A alpha T under T in the whole section;
--         clamped and propped: 3/2 E I alpha T / h
local hinge = require "hinge"

local E, L, q, P, at, T, alpha = 206e9, 5, 20e3, 50e3, 0.3, 40, 12e-6
local h = 0.3
local section = hinge.section.general { area = 6e-3, Ix = 8e-5, Iy = 6e-6, J = 2e-7, shear_area_y = 1,
  size = { width = 0.15, depth = h } }
local steel = hinge.material { E = E, G = 1e15 } -- so stiff in shear that bending is alone
-- elongation alpha T, and no loss of stiffness
local simple = { stiffness = { { -60, 1 }, { 200, 1 } }, strength = { { -60, 1 }, { 200, 1 } },
  elongation = { { -60, -80 * alpha }, { 200, 180 * alpha } } }

-- A beam clamped at its left end; `held`: its right end. Returns the forces at both ends, and the deflection there.
local function beam(held, load)
  local model = hinge.model { displacement = "small" }
  local left, right = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(left)
  if held then model:fix(right, held) end
  load(model, model:member { left, right, section = section, material = steel })
  local run = model:static { steps = 1 }:finish()
  local a, b = model:members()[1]:forces(run)
  return a, b, select(3, right:displacement(run))
end

return hinge.benchmark {
  title = "Loads along beams, and heat", kind = "elastic", fast = true, source = "closed form, Bernoulli beam",
  run = function(b)
    local EI, EA = E * section.Ix, E * section.area
    local function row(what, computed, reference, unit)
      b:row { what, computed = math.abs(computed), reference = reference, unit = unit, elements = 2,
        tolerance = 1e-6 }
    end
    local low, high = beam("all", function(model, member)
      model:load { member = member, q = { b = { 0, 0, -q } } }
    end)
    row("0 to q: moment at the lower end", low.Mx / 1e3, q * L ^ 2 / 30 / 1e3, "kN m")
    row("0 to q: moment at the higher end", high.Mx / 1e3, q * L ^ 2 / 20 / 1e3, "kN m")
    local near = beam("all", function(model, member)
      model:load { member = member, at = at, force = { 0, 0, -P } }
    end)
    row("P at 0.3 L: moment at the near end", near.Mx / 1e3, P * at * (1 - at) ^ 2 * L / 1e3, "kN m")
    local function across(model, member)
      model:heat { member = member, temperature = 20, across_y = T, properties = simple }
    end
    local _, _, uz = beam(nil, across)
    row("heat across, cantilever: deflection", 1e3 * uz, 1e3 * alpha * T * L ^ 2 / (2 * h), "mm")
    row("heat across, clamped: moment", beam("all", across).Mx / 1e3, EI * alpha * T / h / 1e3, "kN m")
    row("heat across, propped: moment", beam("y,z", across).Mx / 1e3, 1.5 * EI * alpha * T / h / 1e3, "kN m")
    row("heat, clamped: axial force", beam("all", function(model, member)
      model:heat { member = member, temperature = 20 + T, properties = simple }
    end).N / 1e3, EA * alpha * T / 1e3, "kN")
  end,
}

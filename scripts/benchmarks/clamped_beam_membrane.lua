-- A clamped beam gets a velocity over its length and stops by bending and by tension.
--
-- Run     hinge run scripts/benchmarks/clamped_beam_membrane.lua
-- Shows   plastic hinges with axial force in dynamics; membrane.png compares deflections with both bounds
-- Expect  a deflection between the bounds: the reference is their middle, and the tolerance half of their distance
--
-- The rigid-plastic estimate is W / H = 1/2 (sqrt(1 + 3 l / 4) - 1), with l = 4 density V^2 h^2 / (stress H^2), the
-- depth H and half of the span h. It follows from energies: the triangular mode nearest to the initial velocity V has
-- 3/4 of its energy m V^2 h; three hinges with the moment M0 and the force N0 = 4 M0 / H dissipate
-- 4 M0 (W + W^2 / H) / h. They yield by a square locus here, which lies outside of the true one; 0.618 of it lies
-- inside. These are not strict bounds, as the shape is assumed. E is ten times that of steel: with that of steel the
-- beam springs back by 0.8 of its depth for l = 64, and by 1.9 of it, nearly all of its way, for l = 16.
local hinge = require "hinge"

local E, density, yield, h, H, elements = 206e9, 7850, 245e6, 0.5, 0.01, 8

local function estimate(l) return (math.sqrt(1 + 3 * l / 4) - 1) / 2 end

-- Half of the beam. Returns the mean deflection of midspan after it has stopped, over the depth.
local function stopped(l)
  local model = hinge.model { elements_per_member = elements }
  local steel = hinge.material { E = 10 * E, density = density, yield_stress = yield }
  local support, middle = model:node { 0, 0, 0 }, model:node { h, 0, 0 }
  model:fix(support)
  model:fix(middle, "x,y,rx,ry,rz")
  model:member { support, middle, material = steel, group = "beam",
    section = hinge.section.solid { width = H, depth = H, interaction = "exact" } }
  model:velocity("beam", { 0, 0, -math.sqrt(l * yield * H ^ 2 / (4 * density * h ^ 2)) })
  local run = model:dynamic { dt = 1e-5, duration = 0.008, record = false }
  local down, sum, count = run:probe { node = middle, "uz" }, 0, 0
  run:finish()
  for i, t in ipairs(down.time) do
    if t > 0.006 then sum, count = sum - down.value[i] / H, count + 1 end
  end
  return sum / count, run.index
end

return hinge.benchmark {
  title = "Clamped beam with membrane force", kind = "dynamics",
  source = "rigid-plastic estimate between two yield loci (Jones, Structural Impact); derived in the file",
  run = function(b, job)
    local found = { x = {}, y = {}, name = "computed", style = "points" }
    for i, l in ipairs { 16, 64 } do
      local computed, steps = stopped(l)
      local low, high = estimate(l), estimate(l / 0.618)
      b:row { ("W / H, l = %d, middle of the bounds"):format(l), computed = computed, reference = (low + high) / 2,
        tolerance = (high - low) / (high + low), elements = elements, steps = steps }
      found.x[i], found.y[i] = l, computed
    end
    local l, low, high = {}, {}, {}
    for i = 1, 100 do l[i], low[i], high[i] = i, estimate(i), estimate(i / 0.618) end
    job:plot({ series = { { x = l, y = low, name = "square locus" },
      { x = l, y = high, name = "0.618 of it" }, found }, x_label = "l = 4 density V^2 h^2 / (stress H^2)",
      y_label = "W / H",
      title = "clamped beam under an impulse", y_range = { 0, 6 } }, "membrane.png")
  end,
}

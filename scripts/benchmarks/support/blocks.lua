-- Plastic stress blocks beside an axial force, and the limit load of a cantilever in hinge: the common part of the
-- comparisons about the strong and the weak axis.
local hinge = require "hinge"

local blocks = {}

local fy, L = 235e6, 1
local steel = hinge.material { E = 210e9, yield_stress = fy }

--- How far the edge of a round corner of radius r is from the square one, at the distance t from its tangent point.
function blocks.corner(r, t) return t > 0 and r - math.sqrt(math.max(r ^ 2 - t ^ 2, 0)) or 0 end

--- Width at the distance s from the middle, of a rectangle with round corners; of what is hollow.
function blocks.of_rectangle(h, b, r)
  return function(s) return s < h / 2 and b - 2 * blocks.corner(r, s - (h / 2 - r)) or 0 end
end
function blocks.hollow(outer, inner) return function(s) return outer(s) - inner(s) end end

-- The moment beside n = N / N0 of a section with these widths, and N0. ends: where the widths have a step or a kink, up
-- to half of the depth; each part is cut into strips of its own.
local function by_blocks(ends, width, n)
  local strips, total, from = {}, 0, 0
  for _, upto in ipairs(ends) do
    local t = (upto - from) / 1000
    for i = 1, 1000 do
      local s = from + (i - 0.5) * t
      strips[#strips + 1] = { s = s, t = t, area = 2 * t * width(s) }
      total = total + strips[#strips].area
    end
    from = upto
  end
  local left, M = n * total, 0
  for _, strip in ipairs(strips) do
    local part = math.min(strip.area, left) -- of this strip, that carries N: the inner part of it
    left = left - part
    M = M + (strip.area - part) * (strip.s + 0.5 * strip.t * part / strip.area)
  end
  return fy * M, fy * total
end

-- The moment at the root of a cantilever along x at its limit load, beside a compression N, which is held.
local function pushed(section, modulus, up, N)
  local model = hinge.model { displacement = "small" }
  local root, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(root)
  model:member { root, tip, section = section, material = steel, up = up }
  local F = 1.2 * fy * modulus / L
  model:case "axial":load { node = tip, force = { -N, 0, 0 } }
  model:case "push":load { node = tip, force = { 0, 0, F } }
  local held = model:static { loads = { axial = 1 }, steps = 4 }:finish()
  local run = model:static { from = held, loads = { push = 1 }, steps = 20, to_limit = true }:finish()
  assert(run.limit, run.reason)
  return run.factor * F * L
end

--- Compares N / N0 = 0.2, 0.4, 0.6, 0.8 of each of `sections`, { name, section, ends, width }: a row for the one with
--- the largest error. `axis`: "strong" or "weak".
function blocks.compare(b, job, axis, sections)
  local series = {}
  for _, case in ipairs(sections) do
    local name, section, ends, width = table.unpack(case)
    local modulus, up = section.Zx, { 0, 0, 1 }
    if axis == "weak" then modulus, up = section.Zy, { 0, 1, 0 } end
    local Mp, N0 = by_blocks(ends, width, 0)
    local worst = { error = -1 }
    local drawn, line = { x = {}, y = {}, style = "points", name = name }, { x = {}, y = {} }
    for _, n in ipairs { 0.2, 0.4, 0.6, 0.8 } do
      local computed, reference = pushed(section, modulus, up, n * N0), by_blocks(ends, width, n)
      local error = math.abs(computed / reference - 1)
      if error ~= error or error > worst.error then
        worst = { error = error, n = n, computed = computed, by_hand = reference }
      end
      drawn.x[#drawn.x + 1], drawn.y[#drawn.y + 1] = computed / Mp, n
    end
    b:row { ("%s: M beside %.1f N0"):format(name, worst.n), computed = worst.computed, reference = worst.by_hand,
      unit = "N m", tolerance = 8e-5, elements = 2, steps = 20 }
    for i = 0, 20 do line.x[i + 1], line.y[i + 1] = by_blocks(ends, width, i / 20) / Mp, i / 20 end
    series[#series + 1], series[#series + 2] = line, drawn
  end
  local colours = { "blue", "red", "green", "purple", "orange" }
  for i, s in ipairs(series) do s.colour = colours[(i + 1) // 2] end
  job:plot({ series = series, x_label = "M / Mp", y_label = "N / N0",
    title = ("About the %s axis: runs (points), stress blocks (lines)"):format(axis) },
    ("interaction_%s_axis.png"):format(axis))
end

return blocks

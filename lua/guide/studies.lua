-- The load at which crooked columns of many lengths collapse, beside a formula: see studies.md.
local hinge = require "hinge"

local pipe = hinge.section.pipe { diameter = 0.2, thickness = 0.01 }

-- A pinned column of two members, whose middle stands off the line by L / 500. Returns the load at which it collapses.
local function collapse_load(L, p)
  local steel = hinge.material { E = 206e9, density = 7850, yield_stress = p.yield_stress }
  local model = hinge.model { elements_per_member = p.elements_per_member }
  local foot, middle, head = model:node { 0, 0, 0 }, model:node { L / 500, 0, L / 2 }, model:node { 0, 0, L }
  for _, ends in ipairs { { foot, middle }, { middle, head } } do
    model:member { ends[1], ends[2], section = pipe, material = steel }
  end
  model:fix(foot, "xyz,rz")
  model:fix(head, "x,y,rz")
  local squash = pipe.area * p.yield_stress
  model:load { node = head, force = { 0, 0, -1.1 * squash } }
  local run = model:static { steps = p.steps, to_limit = true }:finish()
  return run.factor * 1.1 * squash
end

-- The same by hand: N and M = N e0 tan(u) / u in the middle, the exact moment of a crooked elastic column with
-- u = pi / 2 sqrt(N / Euler), make the pipe fully plastic: M / Mp = cos(pi / 2 N / squash). Halving finds N.
local function by_hand(L, p)
  local squash, plastic = pipe.area * p.yield_stress, pipe.Zx * p.yield_stress
  local euler = math.pi ^ 2 * 206e9 * pipe.Ix / L ^ 2
  local low, high = 0, math.min(squash, euler)
  for _ = 1, 50 do
    local N = (low + high) / 2
    local u = math.pi / 2 * math.sqrt(N / euler)
    local M = N * L / 500 * math.tan(u) / u
    if M < plastic * math.cos(math.pi / 2 * N / squash) then low = N else high = N end
  end
  return low
end

return hinge.scenario {
  parameters = { yield_stress = 235e6 },
  cases = { mild = { yield_stress = 235e6 }, high = { yield_stress = 460e6 } },
  accuracy = { elements_per_member = { 2, 4 }, steps = { 40, 20, 80 } },
  run = function(p, job)
    local length, computed, formula = {}, {}, {}
    print "length m   hinge kN   by hand kN"
    for L = 2, 14, 2 do
      local i = #length + 1
      length[i], computed[i], formula[i] = L, collapse_load(L, p) / 1e3, by_hand(L, p) / 1e3
      print(("%8.0f %10.1f %12.1f"):format(L, computed[i], formula[i]))
    end
    job:plot({ title = "collapse load of a crooked column", x_label = "length, m", y_label = "load, kN", width = 1000,
      height = 600, series = { { name = "by hand", x = length, y = formula },
        { name = "hinge", x = length, y = computed, style = "points" } } }, "studies.png")
    return { load_kN = computed }
  end,
}

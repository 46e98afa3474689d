-- A pinned column with an initial bow: first yield, limit load and the falling branch beyond.
--
-- Run     hinge run scripts/benchmarks/bowed_column.lua
-- Shows   second order effects and the exact interaction of N and M in one member that collapses
-- Expect  bow e in the shape of a sine, P_E Euler's load: the middle stands e / (1 - P / P_E) off the axis, exactly.
--         Ayrton and Perry: the first fibre yields at P / A + P e / (1 - P / P_E) / W = fy. A hinge forms in the middle
--         where P e / (1 - P / P_E) = Mp (1 - (P / N0)^2): the limit load. Beyond it statics alone gives the load from
--         the offset w of the middle, P w = Mp (1 - (P / N0)^2). A real column yields along a length and lies between
--         the first two. The load shortens the column by 0.08 %, which the closed forms leave out: 0.12 % of the load.
local hinge = require "hinge"
local root = require "hinge.library.numeric".root

local E, fy, L, side, bow = 210e9, 355e6, 3, 0.1, 0.006
local A, W, Mp, N0 = side ^ 2, side ^ 3 / 6, fy * side ^ 3 / 4, fy * side ^ 2
local euler = math.pi ^ 2 * E * side ^ 4 / 12 / L ^ 2

-- Offset of the middle and load of a column of `parts` members on a sine, at each step; N / A + M / W in the middle.
local function pressed(parts, steps)
  local model, node, members = hinge.model { interaction = "exact" }, {}, {}
  local steel = hinge.material { E = E, G = 1e15, yield_stress = fy } -- G: a column that does not shear
  local square = hinge.section.solid { width = side, depth = side }
  for i = 0, parts do
    node[i] = model:node { bow * math.sin(math.pi * i / parts), 0, L * i / parts }
    model:fix(node[i], i == 0 and "x,y,z,rx,rz" or i == parts and "x,y,rx,rz" or "y,rx,rz")
    if i > 0 then
      members[i] = model:member { node[i - 1], node[i], section = square, material = steel, up = { 1, 0, 0 } }
    end
  end
  local middle = node[parts // 2]
  model:load { node = node[parts], force = { 0, 0, -N0 } }
  local w, P, stress = { bow }, { 0 }, { 0 }
  local run = model:static { steps = steps, control = { node = middle, "ux", to = 0.06 } }
  while run:step() do
    local _, at = members[parts // 2]:forces(run)
    w[#w + 1], P[#P + 1] = bow + middle:displacement(run), run.factor * N0
    stress[#stress + 1] = math.abs(at.N) / A + math.abs(at.Mx) / W
  end
  assert(run.verdict == "completed", run.reason)
  return w, P, stress
end

return hinge.benchmark {
  title = "Column with an initial bow", kind = "inelastic", fast = true,
  source = "closed forms: Ayrton and Perry; hinge in the middle",
  run = function(b, job)
    local function offset(P) return bow / (1 - P / euler) end
    local function by_statics(w)
      local c = N0 * w / Mp
      return N0 * (math.sqrt(c ^ 2 + 4) - c) / 2
    end
    local first = root(function(P) return P / A + P * offset(P) / W - fy end, 0, 0.999 * euler)
    local limit = root(function(P) return P * offset(P) - Mp * (1 - (P / N0) ^ 2) end, 0, 0.999 * euler)
    local steps, parts = 300, 16
    local w, P, stress = pressed(parts, steps)
    local row = b:rows_with { unit = "N", tolerance = 2.5e-3, elements = 2 * parts, steps = steps }
    local i = 1
    while stress[i] < fy do i = i + 1 end
    local part = (fy - stress[i - 1]) / (stress[i] - stress[i - 1])
    row("load at first yield of a fibre", P[i - 1] + part * (P[i] - P[i - 1]), first)
    local peak = 0
    for _, load in ipairs(P) do peak = load == load and math.max(peak, load) or load end
    row("limit load", peak, limit)
    row("load beyond it, at an offset of 60 mm", P[271], by_statics(w[271]))
    local series = { { x = {}, y = {}, name = "hinge", style = "points" },
      { x = {}, y = {}, name = "elastic, by hand" }, { x = {}, y = {}, name = "hinge in the middle, by hand" } }
    for k = 1, #w do
      local i1, i3 = #series[1].x + 1, #series[3].x + 1
      if k % 10 == 1 then series[1].x[i1], series[1].y[i1] = 1e3 * w[k], P[k] / 1e3 end
      series[2].x[k], series[2].y[k] = 1e3 * w[k], euler * (1 - bow / w[k]) / 1e3
      if w[k] > 0.03 then series[3].x[i3], series[3].y[i3] = 1e3 * w[k], by_statics(w[k]) / 1e3 end
    end
    job:plot({ series = series, x_label = "offset of the middle (mm)", y_label = "load (kN)",
      title = "A column with an initial bow" }, "bowed_column.png")
  end,
}

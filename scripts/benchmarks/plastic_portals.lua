-- Portal frames, height and span 1 m, up to their plastic limit load.
--
-- Run     hinge run scripts/benchmarks/plastic_portals.lua
-- Shows   sway, combined and beam mechanisms, first order, and what the axial force takes off (eq 14)
-- Expect  fixed feet: H = 4 Mp / h alone, and beside V = H; 3 Mp / h beside V = 2 H; pinned feet with V = H: 2 Mp / h.
--         With H = V on fixed feet two mechanisms form at one load, which is hard on the solver. With H alone a column
--         carries N = 2 M / L, so that eq 14 takes Mp sqrt(1 - (N / N0)^2) = M. The members do not stretch where
--         bending is alone: their area is 0.1 m^2. The displacement at the mechanism under H alone follows from a
--         linear analysis with the hinges before it.
local hinge = require "hinge"

local E, side, fy = 206e9, 0.05, 245e6
local Mp, N0, EI = fy * side ^ 3 / 4, fy * side ^ 2, E * side ^ 4 / 12
local steel = hinge.material { E = E, G = 1e15, yield_stress = fy } -- so stiff in shear that bending is alone
local square = hinge.section.solid { width = side, depth = side }
local rigid = hinge.section.general { area = 0.1, Ix = EI / E, Iy = EI / E, J = EI / E, Mx0 = Mp, My0 = Mp }

-- The load factor of the limit under a horizontal load H at a corner and a vertical load V at midspan, N, and ux of the
-- corner at each step of a run that drives it.
local function frame(H, V, options)
  local model = hinge.model { displacement = "small", interaction = "paper" }
  local node = {}
  for i, at in ipairs { { 0, 0 }, { 0, 1 }, { 0.5, 1 }, { 1, 1 }, { 1, 0 } } do
    node[i] = model:node { at[1], 0, at[2] }
    model:fix(node[i], (i == 1 or i == 5) and (options.feet or "all") or "y,rx,rz")
  end
  for i = 1, 4 do
    model:member { node[i], node[i + 1], section = options.section or rigid, material = steel,
      up = (i == 2 or i == 3) and { 0, 0, 1 } or { 1, 0, 0 } }
  end
  model:load { node = node[2], force = { H, 0, 0 } }
  model:load { node = node[3], force = { 0, 0, -V } }
  local run = model:static { steps = 40, control = { node = node[2], "ux", to = options.to or 0.2 } }
  local u, factor = { 0 }, { 0 }
  while run:step() do u[#u + 1], factor[#factor + 1] = node[2]:displacement(), run.factor end
  return factor[#factor], u, factor
end

-- Where the last slope of a curve with load meets the plateau.
local function onset(u, factor)
  local limit, last = factor[#factor], 2
  while factor[last + 1] < limit * (1 - 1e-6) do last = last + 1 end
  local slope = (factor[last] - factor[last - 1]) / (u[last] - u[last - 1])
  return u[last] + (limit - factor[last]) / slope
end

return hinge.benchmark {
  title = "Plastic portals", kind = "inelastic", fast = true,
  source = "closed forms: mechanisms by virtual work, eq 14 for N",
  run = function(b)
    local row = b:rows_with { elements = 8, steps = 40 }
    local limit, u, factor = frame(1, 0, { to = 0.04 })
    row("fixed feet, H alone: limit load", limit, 4 * Mp, "N", 1e-6)
    -- Mp at all four ends of the columns: their bending, Mp h^2 / 6 EI, and the beam's end rotation times h
    row("the same: sway at the mechanism", onset(u, factor), Mp / (3 * EI), "m", 1e-4)
    row("fixed feet, V = H", frame(1, 1, {}), 4 * Mp, "N", 1e-6)
    row("fixed feet, V = 2 H", frame(1, 2, {}), 3 * Mp, "N", 1e-6)
    row("pinned feet, V = H", frame(1, 1, { feet = "x,y,z,rx,rz" }), 2 * Mp, "N", 1e-6)
    -- M = Mp sqrt(1 - (2 M / N0)^2)
    row("fixed feet, H alone, eq 14", frame(1, 0, { section = square }), 4 / math.sqrt(1 / Mp ^ 2 + 4 / N0 ^ 2), "N",
      1e-5)
  end,
}

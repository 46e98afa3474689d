-- Columns and a beam of reinforced concrete: their moments beside N by the ultimate strains of EN 1992-1-1 and by ideal
-- plasticity, against an integration over the section. See concrete.md.
local hinge = require "hinge"

local material, L = hinge.material.concrete "C30/37", 1.5
local fc, fy, Es = 30e6, 500e6, 200e9 -- C30/37, B500B

-- A section of b x h with layers of bars, { y, count, diameter }, m.
local function section(name, b, h, layers)
  local s = { name = name, b = b, h = h, layers = layers }
  local list = {}
  for i, layer in ipairs(layers) do list[i] = { y = layer[1], count = layer[2], diameter = layer[3] } end
  for _, strains in ipairs { "EN 1992-1-1", "plastic" } do
    s[strains] = hinge.section.concrete { width = b, depth = h, concrete = "C30/37", steel = "B500B", cover = 0.04,
      layers = list, stiffness = "cracked", strains = strains }
  end
  s.of = s["EN 1992-1-1"] -- the default
  return s
end
local column = section("column, 8 bars of 20 mm", 0.4, 0.4,
  { { 0.15, 3, 0.02 }, { 0, 2, 0.02 }, { -0.15, 3, 0.02 } })
local sections = { column, section("column, 4 bars of 20 mm", 0.4, 0.4, { { 0.15, 2, 0.02 }, { -0.15, 2, 0.02 } }),
  section("column, 16 bars of 25 mm", 0.5, 0.5, { { 0.19, 5, 0.025 }, { 0.1, 2, 0.025 }, { 0, 2, 0.025 },
    { -0.1, 2, 0.025 }, { -0.19, 5, 0.025 } }),
  section("beam, 4 and 2 bars of 20 mm", 0.3, 0.5, { { 0.2, 2, 0.02 }, { -0.2, 4, 0.02 } }) }

-- Own integration. N and M by the ultimate strains of EN 1992-1-1: parabola and rectangle, 0.0035 at the edge and 0.002
-- where all is pressed; bars elastic, then plastic. x: depth of the neutral axis below the upper edge.
local function ultimate(s, x)
  local at_edge = x <= s.h and 0.0035 or 0.002 * x / (x - s.h * 3 / 7)
  local function stress(y)
    local strain = at_edge * (x - (s.h / 2 - y)) / x
    local part = math.min(1, math.max(0, strain) / 0.002)
    return strain, fc * (1 - (1 - part) ^ 2)
  end
  local N, M, strips = 0, 0, 400
  for i = 1, strips do
    local y = s.h * ((i - 0.5) / strips - 0.5)
    local _, of = stress(y)
    N, M = N - of * s.b * s.h / strips, M + of * s.b * s.h / strips * y
  end
  for _, layer in ipairs(s.layers) do
    local y, area = layer[1], layer[2] * math.pi / 4 * layer[3] ^ 2
    local strain, displaced = stress(y)
    local F = area * (math.max(-fy, math.min(fy, Es * strain)) - displaced)
    N, M = N - F, M + F * y
  end
  return N, M
end
local function ultimate_moment(s, N) -- by halving
  local low, high = 1e-6, 1000
  for _ = 1, 100 do
    local x = math.sqrt(low * high)
    if ultimate(s, x) > N then low = x else high = x end
  end
  return select(2, ultimate(s, low))
end

-- Of hinge: the upper edge is pressed by a curvature about -x.
local function moment(of, N) return -of:plastic_moments(N, math.pi) end

-- The moment at the foot of a column at its limit load, its head carries N.
local function carried(s, N)
  local model = hinge.model { displacement = "small" }
  local foot, head = model:node { 0, 0, 0 }, model:node { 0, 0, L }
  model:member { foot, head, section = s.of, material = material, up = { 0, 1, 0 } }
  model:fix(foot, "all")
  model:case "weight":load { node = head, force = { 0, 0, N } }
  model:case "push":load { node = head, force = { 0, s.of.Mx0 / L, 0 } }
  local loaded
  if N < 0 then loaded = model:static { loads = { weight = 1 } }:finish() end
  local run = model:static { from = loaded, loads = { push = 3 }, steps = 30, to_limit = true }
  run:finish()
  return 3 * run.factor * s.of.Mx0
end

local N0 = -ultimate(column, 1e6) -- all is pressed
print "                M (kN m)                             over the own integration"
print "N (kN)    a run    surface    own integration    surface    plastic"
local at = {}
for i = 0, 9 do
  local N = -i / 10 * N0
  local M, Mu, Mp = moment(column.of, N), ultimate_moment(column, N), moment(column.plastic, N)
  at[i] = M / Mu
  print(("%6.0f %8.1f %10.1f %18.1f %10.3f %10.3f"):format(N / 1e3, carried(column, N) / 1e3, M / 1e3, Mu / 1e3,
    M / Mu, Mp / Mu))
end

-- By how much a surface lies beyond an ultimate state, along the line from no force to it.
local function beyond(of, N, M)
  local low, high = 0, 2
  for _ = 1, 50 do
    local t = (low + high) / 2
    local known, most = pcall(moment, of, t * N)
    if known and most > t * M then low = t else high = t end
  end
  return low - 1
end

print "\nbeyond ultimate states, along N and M together        most         least"
local most, least = { ["EN 1992-1-1"] = {}, plastic = {} }, { ["EN 1992-1-1"] = {}, plastic = {} }
for _, s in ipairs(sections) do
  for _, strains in ipairs { "EN 1992-1-1", "plastic" } do
    local high, low = -1, 1
    for i = 1, 80 do
      local x = i <= 50 and s.h * i / 50 or s.h * (1 + ((i - 50) / 12) ^ 2)
      local N, M = ultimate(s, x)
      if N <= 0 then
        local off = beyond(s[strains], N, M)
        high, low = math.max(high, off), math.min(low, off)
      end
    end
    most[strains][s.name], least[strains][s.name] = 100 * high, 100 * low
    print(("%-32s %-15s %+10.1f %% %+10.1f %%"):format(s.name, strains, 100 * high, 100 * low))
  end
end

local curves = { { name = "ultimate strains", x = {}, y = {} }, { name = "plastic", x = {}, y = {} },
  { name = "own integration", x = {}, y = {}, dashed = true } }
local n_most = 8 * math.pi / 4 * 0.02 ^ 2 * fy
for k, of in ipairs { column.of, column.plastic } do
  for i = 0, 200 do
    local N = n_most - i / 200 * (n_most + of.N0)
    table.insert(curves[k].x, moment(of, N) / 1e3)
    table.insert(curves[k].y, -N / 1e3)
  end
end
for i = 1, 160 do
  local x = 0.4 * (i <= 100 and i / 100 or 1 + ((i - 100) / 15) ^ 2)
  local N, M = ultimate(column, x)
  table.insert(curves[3].x, M / 1e3)
  table.insert(curves[3].y, -N / 1e3)
end
hinge.plot({ series = curves, title = "0.4 x 0.4 m, C30/37, 8 bars of 20 mm", x_label = "M (kN m)",
  y_label = "N in compression (kN)", width = 1000, height = 700 }, "concrete.png")
return { most = most["EN 1992-1-1"], least = least["EN 1992-1-1"], surface_over_own = at, N0 = column.of.N0,
  own_N0 = N0 }

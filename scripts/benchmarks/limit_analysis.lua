-- A frame of three storeys and two bays: plastic limit load against a linear programme.
--
-- Run     hinge run scripts/benchmarks/limit_analysis.lua
-- Shows   limit loads of a frame with 36 critical sections, first order, bending alone
-- Expect  the load factor of the static theorem: the largest one with moments in equilibrium with the loads and within
--         Mp at all sections. The programme below finds it by the simplex method; nothing in it comes from the engine.
--         Three ratios of horizontal to vertical load give three mechanisms.
local hinge = require "hinge"

local bays, h, E, EI = { 6, 4.5 }, 3.5, 206e9, 40e6 -- m, Pa, N m^2
local Mp_columns, Mp_beams = { 180e3, 150e3, 110e3 }, { 220e3, 190e3, 130e3 } -- N m, by storey

-- The equations of equilibrium: of joints, of beams (M sagging), of storeys. Rows { [section] = factor, load = }, and
-- Mp of each section. End moments of columns act clockwise on them.
local function equations(H, V)
  local Mp, rows, at = {}, {}, {}
  local function section(name, strength)
    Mp[#Mp + 1] = strength
    at[name] = #Mp
    return #Mp
  end
  for storey = 1, 3 do
    local sway = { load = (4 - storey) * H * h }
    for line = 1, 3 do
      for _, place in ipairs { "foot", "head" } do
        sway[section(place .. line .. storey, Mp_columns[storey])] = -1
      end
    end
    rows[#rows + 1] = sway
    for bay, span in ipairs(bays) do
      local beam = { load = V * span / 4 }
      for place, factor in pairs { left = -0.5, mid = 1, right = -0.5 } do
        beam[section(place .. bay .. storey, Mp_beams[storey])] = factor
      end
      rows[#rows + 1] = beam
    end
  end
  for storey = 1, 3 do
    for line = 1, 3 do
      local joint = { load = 0 }
      for name, factor in pairs { ["head" .. line .. storey] = 1, ["foot" .. line .. storey + 1] = 1,
        ["left" .. line .. storey] = 1, ["right" .. line - 1 .. storey] = -1 } do
        if at[name] then joint[at[name]] = factor end
      end
      rows[#rows + 1] = joint
    end
  end
  return rows, Mp
end

-- Takes the column `column` out of all rows but one.
local function pivot(rows, row, column)
  local by = rows[row][column]
  for j, value in pairs(rows[row]) do rows[row][j] = value / by end
  for i, other in pairs(rows) do
    local times = i ~= row and other[column] or 0
    if times ~= 0 then
      for j, value in pairs(rows[row]) do other[j] = (other[j] or 0) - times * value end
    end
  end
end

-- The largest load factor. Unknowns: the moments that the equations leave open, and the factor.
local function programme(H, V)
  local rows, Mp = equations(H, V)
  local bound = {}
  for i = 1, #rows do -- Gauss: each equation gives one moment by the others
    local best = 0
    for j = 1, #Mp do
      if math.abs(rows[i][j] or 0) > math.abs(rows[i][best] or 0) then best = j end
    end
    pivot(rows, i, best)
    bound[best] = i
  end
  -- M = load * factor - sum of open moments; tableau of M <= Mp and -M <= Mp, open moments as x - y with x, y >= 0
  local table_of, basis = { [0] = { load = -1 } }, {}
  for j = 1, #Mp do
    for sign = -1, 1, 2 do
      local row = { right = Mp[j] }
      local of = bound[j] and rows[bound[j]] or { [j] = -1 }
      for k, value in pairs(of) do
        if k == "load" then row.load = sign * value
        elseif k ~= j or not bound[j] then row["x" .. k], row["y" .. k] = -sign * value, sign * value end
      end
      row["slack" .. j .. sign] = 1
      table_of[#table_of + 1], basis[#basis + 1] = row, "slack" .. j .. sign
    end
  end
  while true do
    local enter
    for j, value in pairs(table_of[0]) do
      if j ~= "right" and value < -1e-9 and (not enter or value < table_of[0][enter]) then enter = j end
    end
    if not enter then return table_of[0].right end
    local leave, least
    for i, row in ipairs(table_of) do
      local ratio = (row[enter] or 0) > 1e-9 and row.right / row[enter]
      if ratio and (not leave or ratio < least or ratio == least and basis[i] < basis[leave]) then
        leave, least = i, ratio
      end
    end
    pivot(table_of, leave, enter)
    basis[leave] = enter
  end
end

-- The same frame in hinge: its load factor at the limit.
local function run_of(H, V, times)
  local model = hinge.model { displacement = "small" }
  local steel = hinge.material { E = E, G = 1e15 }
  local function section(Mp)
    return hinge.section.general { area = 0.05, Ix = EI / E, Iy = EI / E, J = EI / E, Mx0 = Mp }
  end
  local joint, x = { {}, {}, {}, [0] = {} }, { 0, bays[1], bays[1] + bays[2] }
  for storey = 0, 3 do
    for line = 1, 3 do
      joint[storey][line] = model:node { x[line], 0, storey * h }
      model:fix(joint[storey][line], storey == 0 and "all" or "y,rx,rz")
      if storey > 0 then
        model:member { joint[storey - 1][line], joint[storey][line], section = section(Mp_columns[storey]),
          material = steel, up = { 1, 0, 0 } }
      end
    end
    for bay = 1, storey > 0 and 2 or 0 do
      local middle = model:node { (x[bay] + x[bay + 1]) / 2, 0, storey * h }
      model:fix(middle, "y,rx,rz")
      model:load { node = middle, force = { 0, 0, -times * V } }
      for _, ends in ipairs { { joint[storey][bay], middle }, { middle, joint[storey][bay + 1] } } do
        model:member { ends[1], ends[2], section = section(Mp_beams[storey]), material = steel }
      end
    end
    if storey > 0 then model:load { node = joint[storey][1], force = { times * H, 0, 0 } } end
  end
  local run = model:static { steps = 20, to_limit = true, iterations = 8 }:finish()
  assert(run.limit, run.reason)
  return times * run.factor
end

return hinge.benchmark {
  title = "Limit load of a frame, three storeys, two bays", kind = "inelastic", fast = false,
  source = "static theorem, linear programme in this file",
  run = function(b)
    for _, case in ipairs { { "H alone", 50e3, 0 }, { "H = 0.7 V", 49e3, 70e3 }, { "H = V / 10", 20e3, 200e3 } } do
      local reference = programme(case[2], case[3])
      b:row { case[1] .. ": load factor", computed = run_of(case[2], case[3], 1.5 * reference), reference = reference,
        tolerance = 2e-5, elements = 42, steps = 20 }
    end
  end,
}

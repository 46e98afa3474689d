-- hinge.joint.end_plate: a bolted end plate between a beam and the flange of a column, both H, by the component method
-- of EN 1993-1-8:2005, 6.2 and 6.3. Lengths in m, forces in N.
local core = require "hinge.core"
local check = require "hinge.library.check"
local parts = require "hinge.standards.en_1993_1_8.parts"

local where = "hinge.joint.end_plate"
local pi, root_2 = math.pi, math.sqrt(2)

-- Options -------------------------------------------------------------------------------------------------------------

local rows_rule = { "table" }
local rules = {
  beam = { "table" }, column = { "table" }, plate = { "table" }, bolts = { "table" }, welds = { "table" },
  beta = { "number", at_least = 0, at_most = 2, default = 1 }, capacity = { "number", unit = "rad", above = 0,
    optional = true },
  interaction = { "string", one_of = { "linear", "none" }, default = "linear" },
  gamma_M0 = parts.factor, gamma_M1 = parts.factor, gamma_M2 = parts.factor,
}
local member_rules = { section = { "section" }, yield_stress = parts.stress }
local column_rules = { section = { "section" }, yield_stress = parts.stress,
  weld = parts.some_length, end_distance = parts.some_length,
  stress = { "number", unit = "Pa", at_least = 0, default = 0 } }
local plate_rules = { width = parts.length, thickness = parts.length, yield_stress = parts.stress,
  below = parts.with(parts.no_length, { default = 0 }) }
local bolt_rules = { diameter = parts.bolt_rules.diameter, grade = parts.bolt_rules.grade, rows = rows_rule,
  gauge = parts.length, edge = parts.some_length, head = parts.some_length, length = parts.some_length,
  shear_rows = { "number", whole = true, at_least = 0, default = 0 }, shank = { "boolean", default = false } }
local weld_rules = { flange = parts.no_length, web = parts.no_length }

-- Distances of the rows from the middle of the compression flange, from the top down.
local function sorted(rows, least)
  local list = {}
  for i, h in ipairs(rows) do
    check.value(where .. ": field 'bolts'", ("rows[%d]"):format(i), h, { "number", unit = "m", above = 0 })
    list[i] = h
  end
  if #list == 0 then
    check.fail("%s: field 'bolts': field 'rows' is empty; give the distance of each row in tension from the middle of "
      .. "the compression flange, in m", where)
  end
  table.sort(list, function(a, b) return a > b end)
  for i = 2, #list do
    if list[i - 1] - list[i] < least - 1e-9 then
      check.fail("%s: field 'bolts': rows at %s and %s m are %s m apart; must be 2.2 hole diameters, %s m, or more",
        where, check.show(list[i - 1]), check.show(list[i]), check.show(list[i - 1] - list[i]), check.show(least))
    end
  end
  return list
end

local function no_less(what, value, limit, of)
  if not (value >= limit - 1e-9) then
    check.fail("%s: %s is %s; the rules of EN 1993-1-8 are for %s or more%s", where, what, check.show(value),
      check.show(limit), of or "")
  end
end

-- The column: r is what the lever arms of the bolts end at, and s what spreads the compression.
local function column_of(o)
  local c = parts.h(where, o, "column")
  check.value(where .. ": field 'column'", "stress", o.column.stress,
    { "number", unit = "Pa", at_least = 0, at_most = c.fy })
  if c.r == 0 then
    if not o.column.weld then
      check.fail("%s: field 'column': field 'weld' is missing; a section without fillets is taken as welded: give the "
        .. "throat of its welds, in m", where)
    end
    c.r = root_2 * o.column.weld
    c.Av = c.hw * c.tw -- EN 1993-1-1, 6.2.6 (3)
  else
    c.Av = math.max(c.A - 2 * c.b * c.tf + (c.tw + 2 * c.r) * c.tf, c.hw * c.tw)
  end
  c.d = c.hw - 2 * c.r
  no_less("69 epsilon t_w / d of the column's web", 69 * parts.epsilon(c.fy) * c.tw / c.d, 1,
    ": a more slender web in shear is not theirs (6.2.6.1)")
  return c
end

-- The beam: its flange and web in compression, 6.2.6.7, as classes 1 and 2.
local function beam_of(o)
  local b, eps = parts.h(where, o, "beam"), parts.epsilon(o.beam.yield_stress)
  no_less("10 epsilon t_f / c of the beam's flange", 10 * eps * b.tf / ((b.b - b.tw) / 2 - b.r), 1,
    ": classes 1 and 2")
  no_less("83 epsilon t_w / c of the beam's web", 83 * eps * b.tw / (b.hw - 2 * b.r), 1, ": classes 1 and 2")
  return b
end

-- alpha of figure 6.11, by equations of its curves, lambda_1 over lambda_2 for each alpha, solved for alpha. They are
-- those of a public program (metku), and were not compared with the figure itself.
local function alpha(m, e, m2)
  local one, two = m / (m + e), m2 / (m + e)
  local function beyond(a) -- lambda_1 of the curve a, less the one here
    local limit = 1.25 / (a - 2.75)
    local knee = a * limit / 2
    return limit + (two < knee and (1 - limit) * ((knee - two) / knee) ^ (0.185 * a ^ 1.785) or 0) - one
  end
  local low, high = 4.45, 8
  if beyond(low) <= 0 then return low end
  if beyond(high) >= 0 then return high end
  for _ = 1, 60 do
    local a = (low + high) / 2
    if beyond(a) > 0 then low = a else high = a end
  end
  return low
end

-- Where the rows are relative to the tension flange, and room for all bolts.
local function set_by_flange(g, o, least, to_weld)
  local flange = g.beam.h - g.beam.tf -- its middle, over that of the compression flange
  g.first = g.rows[1] > flange and 2 or 1 -- the first row below the flange
  if g.first == 2 then
    g.ex = check.value(where .. ": field 'bolts'", "edge", o.bolts.edge, parts.with(parts.length, {}))
    no_less("the distance of the outer row from the plate's end, m,", g.ex, least, ": 1.2 hole diameters")
    g.mx = g.rows[1] - flange - g.beam.tf / 2 - to_weld
  end
  if g.rows[g.first] then g.m2 = flange - g.beam.tf / 2 - g.rows[g.first] - to_weld end
  if g.first == 2 and g.m2 and g.m2 < 0 then
    check.fail("%s: field 'bolts': rows at %s and %s m are both outside of the beam's flange, or in it; EN 1993-1-8 "
      .. "has one row outside", where, check.show(g.rows[1]), check.show(g.rows[2]))
  end
  for name, m in pairs { ["column's web"] = g.m_column, ["beam's web"] = g.m_plate, ["beam's flange"] = g.mx or 1,
    ["inner side of the beam's flange"] = g.m2 or 1 } do
    if m <= 0 then check.fail("%s: no room between a bolt and the weld or fillet at the %s", where, name) end
  end
  if g.m2 then g.alpha = alpha(g.m_plate, g.e_plate, g.m2) end
  if g.m2 and g.alpha * g.m_plate < 2 * g.m_plate + 0.625 * g.e_plate then
    check.fail("%s: the plate is too wide for its bolts: %s m from the bolts to its edge, and %s m to the beam's web; "
      .. "figure 6.11 does not go so far", where, check.show(g.e_plate), check.show(g.m_plate))
  end
end

-- All that the formulas need.
local function geometry(options)
  local o = check.options(where, options, rules)
  o.beam, o.column = parts.options(where, o, "beam", member_rules), parts.options(where, o, "column", column_rules)
  o.plate, o.bolts = parts.options(where, o, "plate", plate_rules), parts.options(where, o, "bolts", bolt_rules)
  o.welds = parts.options(where, o, "welds", weld_rules)
  local g = { o = o, beam = beam_of(o), column = column_of(o), bolt = parts.bolt(where, o.bolts, o.gamma_M2),
    w = o.bolts.gauge, tp = o.plate.thickness, bp = o.plate.width, head = o.bolts.head }
  g.rows = sorted(o.bolts.rows, 2.2 * g.bolt.d0)
  local to_weld_of_web, to_weld = 0.8 * root_2 * o.welds.web, 0.8 * root_2 * o.welds.flange
  g.e_column, g.e_plate = (g.column.b - g.w) / 2, (g.bp - g.w) / 2
  local least = 1.2 * g.bolt.d0
  no_less("the distance of the bolts from the column's edge, m,", g.e_column, least, ": 1.2 hole diameters")
  no_less("the distance of the bolts from the plate's edge, m,", g.e_plate, least, ": 1.2 hole diameters")
  g.e = math.min(g.e_column, g.e_plate)
  g.m_column = (g.w - g.column.tw) / 2 - 0.8 * g.column.r
  g.m_plate = (g.w - g.beam.tw) / 2 - to_weld_of_web
  set_by_flange(g, o, least, to_weld)
  return g
end

-- Effective lengths ---------------------------------------------------------------------------------------------------

-- Distances of row r to its neighbours in the group of rows i to k; nil: it has none there.
local function neighbours(g, r, i, k)
  return r > i and g.rows[r - 1] - g.rows[r] or nil, r < k and g.rows[r] - g.rows[r + 1] or nil
end

-- What row r gives to the effective lengths of rows i to k: circular patterns, and others. Column flange without
-- stiffeners: table 6.4. The first row is an end row where the column's end is near.
local function column_part(g, r, i, k)
  local m, side = g.m_column, 2 * g.m_column + 0.625 * g.e_column
  local to_end = r == 1 and g.o.column.end_distance or math.huge
  local up, down = neighbours(g, r, i, k)
  if not (up or down) then return math.min(2 * pi * m, pi * m + 2 * to_end), math.min(2 * side, side + to_end) end
  if up and down then return up + down, (up + down) / 2 end
  local p = up or down
  return math.min(pi * m + p, 2 * to_end + p), math.min(side + p / 2, to_end + p / 2)
end

-- The same of the end plate, table 6.6. Rows i to k are below the flange, or are one row outside of it.
local function plate_part(g, r, i, k)
  if r < g.first then return parts.outside(g.mx, g.ex, g.e_plate, g.w, g.bp) end
  local m, side = g.m_plate, 2 * g.m_plate + 0.625 * g.e_plate
  local by_flange = r == g.first and g.alpha * m
  local up, down = neighbours(g, r, i, k)
  if not (up or down) then return 2 * pi * m, by_flange or 2 * side end
  if up and down then return up + down, (up + down) / 2 end
  local p = up or down
  return pi * m + p, p / 2 + (by_flange and by_flange - side or side)
end

local function lengths(part, g, i, k)
  local circular, other = 0, 0
  for r = i, k do
    local c, o = part(g, r, i, k)
    circular, other = circular + c, other + o
  end
  return parts.effective(circular, other)
end

-- Resistances ---------------------------------------------------------------------------------------------------------

-- Table 6.3: what the shear in the column's web takes from its transverse resistance over the width b.
local function omega(g, b)
  local beta, x = g.o.beta, (b * g.column.tw / g.column.Av) ^ 2
  local one, two = 1 / math.sqrt(1 + 1.3 * x), 1 / math.sqrt(1 + 5.2 * x)
  if beta <= 0.5 then return 1 end
  if beta <= 1 then return one + 2 * (1 - beta) * (1 - one) end
  return one + (beta - 1) * (two - one)
end

-- Components of rows i to k in tension; a group that the beam's flange parts has none of the plate.
local function tension(g, i, k)
  local o, c = g.o, g.column
  local bolts = 2 * (k - i + 1) * g.bolt.tension
  local t = { column_flange = parts.tee({ m = g.m_column, n = math.min(g.e, 1.25 * g.m_column), thickness = c.tf,
    yield_stress = c.fy }, lengths(column_part, g, i, k), bolts, g.head, o.gamma_M0) }
  local width = t.column_flange.lengths.mode_1
  t.column_web = { width = width, omega = omega(g, width),
    resistance = omega(g, width) * width * c.tw * c.fy / o.gamma_M0 } -- 6.2.6.3
  if i >= g.first or i == k then
    local outside = i < g.first
    local m = outside and g.mx or g.m_plate
    t.end_plate = parts.tee({ m = m, n = math.min(outside and g.ex or g.e, 1.25 * m), thickness = g.tp,
      yield_stress = o.plate.yield_stress }, lengths(plate_part, g, i, k), bolts, g.head, o.gamma_M0)
    if not outside then
      local beff = t.end_plate.lengths.mode_1
      t.beam_web = { width = beff, resistance = beff * g.beam.tw * g.beam.fy / o.gamma_M0 } -- 6.2.6.8
    end
  end
  return t
end

local names = { column_flange = "column flange in bending", column_web = "column web in tension",
  end_plate = "end plate in bending", beam_web = "beam web in tension" }

-- The least of components, and its name; bolts where mode 3 governs.
local function least(components)
  local F, name, mode = math.huge, nil, nil
  for _, key in ipairs { "end_plate", "column_flange", "column_web", "beam_web" } do
    local c = components[key]
    if c and c.resistance < F then F, name, mode = c.resistance, names[key], c.mode end
  end
  return F, mode == 3 and "bolts in tension" or name
end

-- Compression and shear: 6.2.6.1, 6.2.6.2, 6.2.6.7.
local function compression(g)
  local o, c, b = g.o, g.column, g.beam
  local spread = g.tp + math.min(g.tp, math.max(0, o.plate.below - root_2 * o.welds.flange))
  local width = b.tf + 2 * root_2 * o.welds.flange + 5 * (c.tf + c.r) + spread
  local slenderness = 0.932 * math.sqrt(width * c.d * c.fy / (parts.E * c.tw ^ 2))
  local rho = slenderness <= 0.72 and 1 or (slenderness - 0.2) / slenderness ^ 2
  local k = o.column.stress <= 0.7 * c.fy and 1 or 1.7 - o.column.stress / c.fy
  local web = omega(g, width) * k * width * c.tw * c.fy
  local panel = 0.9 * c.fy * c.Av / (math.sqrt(3) * o.gamma_M0)
  return { width = width, omega = omega(g, width), rho = rho, k_wc = k, slenderness = slenderness,
    column_web = math.min(web / o.gamma_M0, rho * web / o.gamma_M1),
    beam_flange = b.W * b.fy / o.gamma_M0 / (b.h - b.tf), panel = panel,
    column_shear = o.beta > 0 and panel / o.beta or math.huge }
end

-- The forces of the rows: 6.2.7.2. Each row has the least of its own components, and of the groups that end at it less
-- what the rows above take; then compression and shear, and the bolts' ductility, limit it.
local function share(g, limit, limited_by)
  local list, groups, sum, limited = {}, {}, 0, false
  for r, h in ipairs(g.rows) do
    local row = { distance = h, components = tension(g, r, r) }
    row.potential, row.governs = least(row.components)
    row.force = row.potential
    local above = 0
    for i = r - 1, 1, -1 do
      above = above + list[i].force
      local group = { from = i, to = r, components = tension(g, i, r) }
      group.resistance, group.governs = least(group.components)
      groups[#groups + 1] = group
      if group.resistance - above < row.force then
        row.force, row.governs = group.resistance - above, group.governs .. (", rows %d to %d"):format(i, r)
      end
    end
    for i = 1, r - 1 do -- 6.2.7.2 (9)
      local most = list[i].force * h / list[i].distance
      if list[i].force > 1.9 * g.bolt.tension and most < row.force then
        row.force, row.governs = most, ("rotation about the compression flange, row %d"):format(i)
      end
    end
    row.force = math.max(row.force, 0)
    if limit - sum < row.force then row.force, row.governs, limited = limit - sum, limited_by, true end
    sum, list[r] = sum + row.force, row
  end
  return list, groups, limited
end

-- Stiffness -----------------------------------------------------------------------------------------------------------

-- The smallest effective length of row r, alone or as a part of a group of the rows from `first` on.
local function smallest(part, g, r, first)
  local b = math.huge
  for i = first, r do
    for k = r, #g.rows do
      local circular, other = part(g, r, i, k)
      b = math.min(b, circular, other)
    end
  end
  return b
end

-- Coefficients of table 6.11, in m, and the stiffness of 6.3.1 and 6.3.3.
local function stiffen(g, list, pressed)
  local c, o = g.column, g.o
  -- the plates, a washer, and half of head and nut: L_b of table 6.11
  local length = o.bolts.length or g.tp + c.tf + g.bolt.washer + (g.bolt.head + g.bolt.nut) / 2
  local first, second = 0, 0
  for r, row in ipairs(list) do
    local outside = r < g.first
    local b = smallest(column_part, g, r, 1)
    local plate = outside and math.min(plate_part(g, r, r, r)) or smallest(plate_part, g, r, g.first)
    row.k3 = 0.7 * b * c.tw / c.d
    row.k4 = 0.9 * b * c.tf ^ 3 / g.m_column ^ 3
    row.k5 = 0.9 * plate * g.tp ^ 3 / (outside and g.mx or g.m_plate) ^ 3
    row.k10 = 1.6 * g.bolt.As / length
    row.k_eff = 1 / (1 / row.k3 + 1 / row.k4 + 1 / row.k5 + 1 / row.k10)
    first, second = first + row.k_eff * row.distance, second + row.k_eff * row.distance ^ 2
  end
  local z = second / first
  local k = { k1 = o.beta > 0 and 0.38 * c.Av / (o.beta * z) or math.huge, k2 = 0.7 * pressed.width * c.tw / c.d,
    k_eq = first / z, bolt_length = length }
  return parts.E * z ^ 2 / (1 / k.k1 + 1 / k.k2 + 1 / k.k_eq), z, k
end

-- Rotation capacity ---------------------------------------------------------------------------------------------------

-- The row with the largest part of the moment governs it.
local function governing(list)
  local worst = list[1]
  for _, row in ipairs(list) do
    if row.force * row.distance > worst.force * worst.distance then worst = row end
  end
  return worst
end

-- Whether 6.4.2 says that the joint turns enough for a plastic analysis, and why.
local function ductility(g, governs)
  if governs == "column web in shear" then return true, "6.4.2 (1): the column's web in shear governs" end
  local plate = governs:find "^end plate"
  if not (plate or governs:find "^column flange") then return false, "6.4.2: " .. governs .. " governs" end
  local t, fy = g.column.tf, g.column.fy
  if plate then t, fy = g.tp, g.o.plate.yield_stress end
  local most = 0.36 * g.bolt.d * math.sqrt(g.bolt.fub / fy)
  return t <= most, ("6.4.2 (2): %s governs; its thickness is %.4g m, and 0.36 d sqrt(f_ub / f_y) is %.4g m"):format(
    governs, t, most)
end

-- The joint -----------------------------------------------------------------------------------------------------------

-- Tension: all rows without compression. Shear, 6.2.2 (2): bolts in tension keep 0.4 / 1.4 of theirs.
local function capacities(g)
  local tension_of_all = 0
  for _, row in ipairs((share(g, math.huge))) do tension_of_all = tension_of_all + row.force end
  return tension_of_all, 2 * g.bolt.shear * (g.o.bolts.shear_rows + 0.4 / 1.4 * #g.rows) -- a row has two bolts
end

--- hinge.joint.end_plate
return function(options, ...)
  check.no_more(where, ...)
  local g = geometry(options)
  local pressed = compression(g)
  local limit, limited_by = pressed.column_web, "column web in compression"
  if pressed.beam_flange < limit then limit, limited_by = pressed.beam_flange, "beam flange in compression" end
  if pressed.column_shear < limit then limit, limited_by = pressed.column_shear, "column web in shear" end
  local list, groups, limited = share(g, limit, limited_by)
  local M = 0
  for _, row in ipairs(list) do M = M + row.force * row.distance end
  local S, z, k = stiffen(g, list, pressed)
  local governs = limited and limited_by or governing(list).governs
  local ductile, why = ductility(g, governs)
  if not ductile and not g.o.capacity then
    check.fail("%s: field 'capacity' is missing; EN 1993-1-8 has no rotation capacity for this joint (%s): give the "
      .. "rotation at which it breaks, in rad", where, why)
  end
  local numbers = { moment = M, stiffness = S, lever_arm = z, governs = governs, ductile = ductile, ductility = why,
    rows = list, groups = groups, compression = pressed, coefficients = k, points = parts.curve(M, S),
    capacity = g.o.capacity, bolt = g.bolt, alpha = g.alpha }
  numbers.tension, numbers.shear = capacities(g)
  return core.joint { Mx = { points = numbers.points, capacity = g.o.capacity }, tension = numbers.tension,
    shear = numbers.shear, interaction = g.o.interaction }, numbers
end

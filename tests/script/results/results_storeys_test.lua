-- hinge.results.storeys and .base: every field of the rows against closed forms of a cantilever and against states that
-- are read one by one, the cut at any place of a member, what is printed, drawn and said.
--
-- Run: lua5.4 tests/script/results/results_storeys_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local results = require "hinge.results"
local checks = support.checks "storeys and base"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect
local joined = support.joined

local E, nu = 210e9, 0.3
local steel = hinge.material { E = E, nu = nu, density = 7850 }
local heb = hinge.section.named "HEB 200"
local of_heb = { section = heb, material = steel }

-- What a table draws.
local function drawing(table_, options)
  local drawn, name
  table_:plot({ plot = function(_, plot, filename) drawn, name = plot, filename end }, "a.svg", options)
  equal(name, "a.svg", "the file")
  return drawn
end

-- Storeys -------------------------------------------------------------------------------------------------------------

-- A cantilever of two storeys of 3 and 4 m, in one piece or in two, from foot to head or the other way round.
local function mast(how)
  local model = hinge.model { displacement = "small" }
  local foot, low, head = model:node { 1, 2, 0 }, model:node { 1, 2, 3 }, model:node { 1, 2, 7 }
  model:fix(foot)
  local parts, members = how.whole and { { foot, head } } or { { foot, low }, { low, head } }, {}
  if how.whole then -- the node at the floor stands on a rod of its own, beside the mast
    local other = model:node { 1.5, 2, 0 }
    model:fix(other)
    model:member { other, low, section = hinge.section.round { diameter = 1e-3 }, material = steel }
  end
  for i, ends in ipairs(parts) do
    local a, b = ends[1], ends[2]
    if how.down then a, b = b, a end
    members[i] = model:member { a, b, section = heb, material = steel, up = { 1, 0, 0 } }
  end
  return model, head, members
end

case("drifts and shear forces of a cantilever are those of F (H z^2 / 2 - z^3 / 6) / E I + F z / G A", function()
  for _, F in ipairs { { 8e3, 0 }, { 0, -6e3 }, { -8e3, 5e3 } } do
    local model, head = mast {}
    model:case("wind"):load { node = head, force = { F[1], F[2], -1e3 } }
    local run = model:static { steps = 1, loads = { wind = 2 } }:finish()
    local found = results.storeys(run, { model = model, levels = { 0, 3, 7 } })
    local G = E / (2 * (1 + nu))
    local of = { { heb.Ix, heb.shear_area_y }, { heb.Iy, heb.shear_area_x } }
    for i, axis in ipairs { "x", "y" } do
      local function u(z)
        return 2 * F[i] * ((7 * z ^ 2 / 2 - z ^ 3 / 6) / (E * of[i][1]) + z / (G * of[i][2]))
      end
      for k, z in ipairs { { 0, 3 }, { 3, 7 } } do
        local row = found.rows[k]
        local drift = (u(z[2]) - u(z[1])) / (z[2] - z[1])
        for _, which in ipairs { "", "_min", "_max", "_last" } do
          near(row["drift_" .. axis .. which], drift, 1e-6 * math.abs(drift) + 1e-15, "drift " .. axis .. which)
          near(row["shear_" .. axis .. which], 2 * F[i], 1e-6 * math.abs(2 * F[i]) + 1e-4, "shear " .. axis .. which)
        end
        equal(row["drift_" .. axis .. "_when"], "2 wind", "the state")
        equal(row["shear_" .. axis .. "_when"], "2 wind", "the state")
        equal(row["line_" .. axis].z, z[2], "the upper node of the line")
        equal(joined { row.storey, row.from, row.to, row.height, #row.pairs, #row.cut },
          joined { k, z[1], z[2], z[2] - z[1], 1, 1 }, "the storey")
      end
    end
  end
end)

case("a cut at any place of a member has the shear force there, and its height counts from either end", function()
  for _, down in ipairs { false, true } do
    local model, head, members = mast { whole = true, down = down }
    model:load { member = members[1], q = { 500, -300, 0 } }
    model:load { node = head, force = { 2e3, 1e3, -50e3 } }
    local run = model:static { steps = 1 }:finish()
    local rows = results.storeys(run, { model = model, levels = { 0, 3, 7 } }).rows
    for k, z in ipairs { 1.5, 5 } do
      near(rows[k].shear_x, 2e3 + 500 * (7 - z), 0.1, "shear x, N")
      near(rows[k].shear_y, 1e3 - 300 * (7 - z), 0.1, "shear y, N")
    end
  end
end)

case("in large displacement a cut has the force at the head of a column that bends, leans and twists", function()
  local soft = hinge.section.solid { width = 0.04, depth = 0.06 }
  local across = { 0.3, 1, 0.2 }
  for _, r in ipairs { { { 0, 0 }, 0, across }, { { 0.8, -0.5 }, 60, across }, { { -0.4, 1.1 }, -80, across },
    { { 0.8, -0.5 }, 0, { 1, 0, 0 } } } do
    local model, head = scenes.cantilever { model = { elements_per_member = 6 }, -- the cut is within an element
      along = { r[1][1], r[1][2], 4 }, member = { section = soft, material = steel, up = r[3] },
      force = { 600, -400, -1500 }, moment = { 0, 0, r[2] } }
    local run = model:static { steps = 10 }:finish()
    expect(math.abs((run:displacement(head))) > 0.1, "it bends far")
    local row = results.storeys(run, { model = model, levels = { 0, 3 } }).rows[1]
    -- moments of a bent element are linear from end to end, and its shear force their slope: of second order
    near(row.shear_x, 600, 2e-3 * 600, "x, N")
    near(row.shear_y, -400, 2e-3 * 600, "y, N")
  end
end)

case("a column that broke has no part in the shear force of its storey", function()
  local model = hinge.model { displacement = "small" }
  local heads, columns = {}, {}
  for i = 1, 2 do
    local foot = model:node { 4 * i, 0, 0 }
    heads[i] = model:node { 4 * i, 0, 3 }
    model:fix(foot)
    columns[i] = model:member { foot, heads[i], section = heb, material = steel }
  end
  model:member { heads[1], heads[2], section = heb, material = steel }
  model:case("push"):load { node = heads[1], force = { 5e3, 0, 0 } }
  model:remove { member = columns[2], at = 0 }
  local gone = model:dynamic { dt = 1e-6, duration = 1e-6, loads = {}, step_control = 0, energy_tolerance = 0 }:finish()
  local run = model:static { from = gone, steps = 1, loads = { push = 1 } }:finish()
  local row = results.storeys(run, { model = model }).rows[1]
  near(row.shear_x, 5e3, 1e-3, "the other column has all of it, N")
end)

case("levels are those of level members and the lowest node; drifts are over the height", function()
  local model = hinge.model { displacement = "small" }
  local at = {}
  for i = 0, 1 do
    for k, z in ipairs { -1.5, 2, 5 } do
      at[i * 3 + k] = model:node { 6 * i, 0, z }
      if k == 1 then model:fix(at[i * 3 + k]) else
        model:member { at[i * 3 + k - 1], at[i * 3 + k], section = heb, material = steel }
      end
    end
  end
  for k = 2, 3 do model:member { at[k], at[3 + k], section = heb, material = steel } end
  -- a member that rises by 0.9 % of its length is level, and one by 1.1 % is a ramp
  local ramp = model:node { 12, 0, 2 + 6 * 0.011 }
  model:member { at[5], ramp, section = heb, material = steel }
  model:load { node = at[2], force = { 30e3, 0, 0 } }
  model:load { node = at[3], force = { 20e3, 10e3, 0 } }
  local run = model:static { steps = 1 }:finish()
  local rows = results.storeys(run, { model = model }).rows
  equal(#rows, 2, "storeys")
  near(rows[1].from, -1.5, 1e-9, "from")
  near(rows[1].to, 2, 1e-9, "to")
  near(rows[2].to, 5, 1e-9, "the last")
  near(rows[1].shear_x, 50e3, 1, "shear force x, N")
  near(rows[2].shear_x, 20e3, 1, "above")
  near(rows[1].shear_y, 10e3, 1, "y")
  local function drift(k, line, axis)
    local function u(node) return (select(axis, run:displacement(node))) end
    return (u(at[3 * line + k + 1]) - u(at[3 * line + k])) / (k == 1 and 3.5 or 3)
  end
  for axis, name in ipairs { "drift_x", "drift_y" } do
    for k = 1, 2 do
      local first, second = drift(k, 0, axis), drift(k, 1, axis)
      near(rows[k][name], math.abs(first) >= math.abs(second) and first or second, 1e-12, name .. " of storey " .. k)
    end
  end
  for rise, level in pairs { [0.009] = true, [0.011] = false } do
    local frame, q = scenes.cantilever { length = 3, along = { 0, 0, 1 }, member = of_heb, force = { 1, 0, 0 } }
    frame:member { q, frame:node { 5, 0, 3 + 5 * rise }, section = heb, material = steel }
    local good, floors = pcall(results.storeys, frame:static { steps = 1 }:finish(), { model = frame })
    equal(good, level, "a rise of " .. rise)
    if good then near(floors.rows[1].to, 3 + 2.5 * rise, 1e-9, "the floor is at the middle of its beam") end
  end
end)

-- A frame of two storeys and two columns on ground that moves in x and y, and masses.
local function shaken()
  local model = hinge.model { displacement = "small", mass = "cubic" }
  local at = {}
  for i = 0, 1 do
    for k = 0, 2 do
      at[3 * i + k + 1] = model:node { 5 * i, 0, 3 * k }
      if k > 0 then
        model:member { at[3 * i + k], at[3 * i + k + 1], section = heb, material = steel }
        model:mass { node = at[3 * i + k + 1], mass = 4e3 + 3e3 * i }
      end
    end
  end
  for k = 2, 3 do model:member { at[k], at[3 + k], section = heb, material = steel } end
  model:fix { at[1], at[4] }
  model:move { node = { at[1], at[4] }, x = function(t) return 0.02 * math.sin(30 * t) ^ 2 end,
    y = function(t) return 0.01 * math.sin(20 * t) ^ 2 end }
  return model, at
end

case("peaks, their times and lines, and the last values are those of all states read one by one", function()
  local model, at = shaken()
  local run = model:dynamic { dt = 4e-3, duration = 0.4 }
  local found = results.storeys(run, { model = model })
  local fifth = results.storeys(run, { model = model, every = 5 })
  local own, states, of_fifth = {}, 0, 0
  local function look()
    local now = results.storeys({}, { model = model })
    now:add(run)
    states = states + 1
    if run.index % 5 == 0 then of_fifth = support.largest_of(of_fifth, math.abs(now.rows[2].shear_y)) end
    for k, row in ipairs(now.rows) do
      own[k] = own[k] or {}
      for _, key in ipairs { "drift_x", "drift_y", "shear_x", "shear_y" } do
        local all, value, line = own[k][key] or { min = math.huge, max = -math.huge, most = 0 }, row[key], nil
        own[k][key] = all
        if key:find "drift" then
          value = 0
          for i = 0, 1 do
            local low, high = { run:displacement(at[3 * i + k]) }, { run:displacement(at[3 * i + k + 1]) }
            local axis = key == "drift_x" and 1 or 2
            local drift = (high[axis] - low[axis]) / 3
            if math.abs(drift) >= math.abs(value) then value, line = drift, at[3 * i + k + 1] end
          end
          equal(row[key], value, "the drift of a state")
        end
        all.min, all.max = support.smallest_of(all.min, value), support.largest_of(all.max, value)
        if math.abs(value) > all.most then
          all.most, all.value, all.when, all.line = math.abs(value), value, run.time, line
        end
        all.last = value
      end
    end
  end
  look()
  while run:step() do look() end
  equal(found.states, states, "states")
  equal(fifth.states, 21, "every fifth of 100, and the start")
  near(math.abs(fifth.rows[2].shear_y), of_fifth, 1e-9, "the largest of these")
  for k, row in ipairs(found.rows) do
    for key, all in pairs(own[k]) do
      equal(joined { row[key], row[key .. "_min"], row[key .. "_max"], row[key .. "_last"], row[key .. "_when"] },
        joined { all.value, all.min, all.max, all.last, all.when }, ("storey %d, %s"):format(k, key))
      expect(all.min < 0 and all.max > 0 and all.last ~= all.value, "it goes both ways")
      if all.line then equal(row["line_" .. key:sub(-1)], all.line, "the line of the largest drift") end
    end
  end
  -- the plot: sizes at the largest and at the end, in both directions, over the height
  local rows = found.rows
  for quantity, factor in pairs { drift = 100, shear = 1e-3 } do
    local plot = drawing(found, { quantity = quantity, title = "T" })
    local largest, k = 0, 0
    for _, axis in ipairs { "x", "y" } do
      for _, which in ipairs { "", "_last" } do
        k = k + 1
        local s, key = plot.series[k], quantity .. "_" .. axis .. which
        local a, b = math.abs(rows[1][key]) * factor, math.abs(rows[2][key]) * factor
        equal(joined(s.x), joined { a, a, b, b }, key)
        equal(joined(s.y), "0 3 3 6", "z, m")
        equal(s.name, (which == "" and "largest, " or "at the end, ") .. axis, "name")
        equal(s.dashed, which == "_last" or nil, "dashed at the end")
        largest = support.largest_of(largest, a, b)
      end
    end
    equal(#plot.series, 4, "lines")
    near(plot.x_range[2], 1.15 * largest, 1e-9 * largest, "range")
    equal(plot.x_range[1], 0, "from 0")
    equal(plot.title .. plot.y_label .. plot.x_label, "Tz, m" .. (quantity == "drift" and "drift of the storey, %"
      or "shear force of the storey, kN"), "labels")
  end
  equal(joined(drawing(found, { units = "N, mm" }).series[1].y), "0 3000 3000 6000", "other units")
end)

-- Columns of a table that stand in its text.
local function shown(table_)
  local list = {}
  for _, column in ipairs(table_:all_columns()) do
    if not column.minor then list[#list + 1] = column.key end
  end
  return table.concat(list, " ")
end

case("the table of storeys has heights, drifts, shear forces and states; of dynamics also the end", function()
  local model, head = mast {}
  model:case("wind"):load { node = head, force = { 8e3, 0, 0 } }
  local run = model:static { steps = 1, loads = { wind = 1 } }:finish()
  local found = results.storeys(run, { model = model, levels = { 0, 3, 7 } })
  local u = {}
  for _, row in ipairs(found.rows) do u[#u + 1] = ("%.5f"):format(row.drift_x) end
  equal(found:text(), ([[
  storey  up to z, m          drift x    shear x, kN
       1       3.000  %s, 1 wind  8.000, 1 wind
       2       7.000  %s, 1 wind  8.000, 1 wind]]):format(u[1], u[2]), "as text")
  equal(found:text { columns = { "to", "height" }, units = "N, mm" }, [[
  up to z, mm  height, mm
         3000        3000
         7000        4000]], "in other units, of levels that are whole numbers")
  equal(shown(found), "storey to drift_x shear_x", "statics")
  for _, r in ipairs { { { 0, 8e3 }, "drift_y shear_y", "largest, y" },
    { { 8e3, -2e3 }, "drift_x shear_x drift_y shear_y", "largest, x; largest, y" } } do
    local frame, top = mast {}
    frame:load { node = top, force = { r[1][1], r[1][2], 0 } }
    local both = results.storeys(frame:static { steps = 1 }:finish(), { model = frame, levels = { 0, 3, 7 } })
    equal(shown(both), "storey to " .. r[2], "the directions in which something happens")
    local names = {}
    for i, series in ipairs(drawing(both, { quantity = "shear" }).series) do names[i] = series.name end
    equal(table.concat(names, "; "), r[3], "and in the plot")
  end
  local dynamic = results.storeys({}, { model = model, levels = { 0, 7 } })
  local moving = model:dynamic { dt = 1e-3, duration = 0.01, loads = { wind = 1 } }
  while moving:step() do end
  dynamic:add(moving, "now")
  equal(shown(dynamic), "storey to drift_x drift_x_last shear_x", "dynamics")
  equal(dynamic.rows[1].drift_x_when, "now", "a name that is given")
  local keys, heads = {}, {}
  for i, column in ipairs(found:all_columns()) do
    keys[i], heads[i] = column.key, ("%s|%s|%s|%s"):format(column.head, column.kind, column.when or "",
      column.decimals or "")
  end
  equal(table.concat(keys, " "), "storey to height drift_x drift_x_last shear_x shear_x_last drift_y drift_y_last "
    .. "shear_y shear_y_last remark", "all columns")
  equal(table.concat(heads, "; "), "storey|whole||; up to z|length||; height|length||; "
    .. "drift x|number|drift_x_when|5; at the end|number||5; shear x|force|shear_x_when|; at the end|force||; "
    .. "drift y|number|drift_y_when|5; at the end|number||5; shear y|force|shear_y_when|; at the end|force||; "
    .. "remark|text||", "their heads")
  local few = scenes.cantilever { along = { 3, 0, 4 }, member = of_heb, force = { 1, 0, 0 } }
  local leaning = results.storeys(few:static { steps = 1 }:finish(), { model = few, levels = { 0, 4 } })
  equal(shown(leaning), "storey to shear_x remark", "without a line of nodes")
  checks.refused("no member is cut at half the height of storey 2, z = 4.5 m;", results.storeys,
    few:static { steps = 1 }:finish(), { model = few, levels = { 0, 4, 5 } })
end)

-- Base ----------------------------------------------------------------------------------------------------------------

case("moments of trapezoidal loads, of a force on a member and of weight are those of integrals by hand", function()
  local a, b = { 1, 2, 0.5 }, { 4, 3, 3.5 }
  local length = math.sqrt(9 + 1 + 9)
  local model = hinge.model { displacement = "small", elements_per_member = 2 }
  local first, last, idle = model:node(a), model:node(b), model:node { 9, 9, 9 }
  model:fix { first }
  model:fix(idle, "z")
  local arm = model:member { first, last, section = heb, material = steel }
  model:member { last, idle, section = hinge.section.round { diameter = 1e-5 }, material = hinge.material { E = 1 } }
  local qa, qb = { 1e3, -2e3, -8e3 }, { -3e3, 500, -1e3 }
  local F, M, g = { 3e3, 4e3, -20e3 }, { 100, 200, -300 }, { 1, -2, -9 }
  model:load { member = arm, q = { a = qa, b = qb } }
  model:load { member = arm, force = F, at = 0.3 }
  model:load { node = last, moment = M }
  model:mass { node = last, mass = 500 }
  model:gravity(g)
  local run = model:static { steps = 1 }:finish()
  local about = { -1, 4, 2 }
  -- Simpson is exact for r x q, of which both are linear
  local sums = { loads = { 0, 0, 0, M[1], M[2], M[3] }, weight = { 0, 0, 0, 0, 0, 0 } }
  local function add(sum, t, f)
    local r = {}
    for i = 1, 3 do r[i] = a[i] + t * (b[i] - a[i]) - about[i] end
    local m = { r[2] * f[3] - r[3] * f[2], r[3] * f[1] - r[1] * f[3], r[1] * f[2] - r[2] * f[1] }
    for i = 1, 3 do sum[i], sum[3 + i] = sum[i] + f[i], sum[3 + i] + m[i] end
  end
  local own = heb.area * 7850
  for t, part in pairs { [0] = 1 / 6, [0.5] = 4 / 6, [1] = 1 / 6 } do
    local q, w = {}, {}
    for i = 1, 3 do
      q[i] = part * length * ((1 - t) * qa[i] + t * qb[i])
      w[i] = part * length * own * g[i]
    end
    add(sums.loads, t, q)
    add(sums.weight, t, w)
  end
  add(sums.loads, 0.3, F)
  add(sums.weight, 1, { 500 * g[1], 500 * g[2], 500 * g[3] })
  local found = results.base(run, { model = model, gravity = g, about = about, units = "N, m" })
  near(found.mass, own * length + 500, 1e-6 * found.mass, "mass, kg")
  for name, sum in pairs(sums) do
    for i, key in ipairs { "Fx", "Fy", "Fz", "Mx", "My", "Mz" } do
      near(found.rows[name][key], sum[i], 1e-6 * 60e3, ("%s of %s"):format(key, name))
      near(found.rows.sum[key], -sums.loads[i] - sums.weight[i], 0.05, key .. " of the reactions")
      near(found.rows.rest[key], 0, 0.05, key .. " of the rest")
    end
  end
  local row = found.rows[1]
  equal(joined { row.name, row.x, row.y, row.z, row.node.index }, "node 1 1 2 0.5 1", "the support")
  local reaction = { run:reaction(first) }
  for i, key in ipairs { "Fx", "Fy", "Fz", "Mx", "My", "Mz" } do equal(row[key], reaction[i], key .. " of its own") end
  equal(#found.rows, 5, "one support, its sum, loads, weight and rest: the other one carries nothing")
  equal(table.concat(found.notes, "\n"), "in balance: the rest is below 1e-06 of the forces\n"
    .. "moments of sums are about { -1, 4, 2 } m\n1 supported node without a reaction", "what is said")
  local names, keys = {}, {}
  for i, r in ipairs(found.rows) do names[i] = r.name end
  for i, c in ipairs(found:all_columns()) do keys[i] = c.key .. " " .. c.kind .. (c.minor and " minor" or "") end
  equal(table.concat(names, ", "), "node 1, sum of reactions, loads, weight, rest", "rows")
  equal(table.concat(keys, ", "), "name text, x length minor, y length minor, z length minor, Fx force, Fy force, "
    .. "Fz force, Mx moment, My moment, Mz moment", "columns")
  local without = results.base(run, { model = model })
  equal(without.rows.weight, nil, "no row of the weight without gravity")
  equal(without.balanced, false, "and no balance")
  equal(without.notes[2], "moments of sums are about { 0, 0, 0 } m", "about the origin")
end)

case("in large displacement forces act where nodes are now, supports that have moved, too", function()
  local model = hinge.model { elements_per_member = 4 }
  local foot, head = model:node { 1, 0, 0 }, model:node { 1, 0, 4 }
  model:fix(foot)
  model:member { foot, head, section = hinge.section.solid { width = 0.06, depth = 0.06 }, material = steel }
  model:load { node = head, force = { 400, 300, -2e3 } }
  model:settle { node = foot, x = 0.3, y = -0.2, z = 0.1 }
  local run = model:static { steps = 10 }:finish()
  local found = results.base(run, { model = model })
  local x, y, z = run:position(head)
  near(found.rows.loads.My, z * 400 + x * 2e3, 1e-6, "My of the load, N m")
  near(found.rows.loads.Mx, -y * 2e3 - z * 300, 1e-6, "Mx")
  near(found.rows.loads.Mz, x * 300 - y * 400, 1e-6, "Mz")
  for _, key in ipairs { "Fx", "Fy", "Fz", "Mx", "My", "Mz" } do near(found.rows.rest[key], 0, 0.05, "rest " .. key) end
  equal(joined { found.rows[1].x, found.rows[1].y, found.rows[1].z }, "1 0 0", "the support by its place as declared")
end)

case("what is not in balance says by how much, and what may hold the model", function()
  local function loaded(on_step)
    local model, head = scenes.cantilever { model = { displacement = "small" }, length = 4, along = { 0, 0, 1 },
      member = of_heb, force = { 10e3, 0, -20e3 } }
    if on_step then model:mass { node = head, mass = 1e3 } end
    return model, head
  end
  local model, head = loaded(true)
  local run = model:dynamic { dt = 1e-3, duration = 5e-3 }:finish()
  local found = results.base(run, { model = model })
  equal(found.notes[1], "the rest is what inertia, damping, contact and connectors to the ground have", "dynamics")
  equal(found.balanced, false, "dynamics is not in balance")
  local mass, u = 1e3 + heb.area * 4 * 7850, run:displacement(head)
  expect(math.abs(found.rows.rest.Fx) > 1e3 and u > 0, "inertia: %g N", found.rows.rest.Fx)
  near(found.mass, mass, 1e-6 * mass, "mass, kg")
  local static = loaded()
  static:gravity { 0, 0, -5 }
  local rest = static:static { steps = 1 }:finish()
  local unknown = results.base(rest, { model = static })
  equal(unknown.notes[1], "not in balance: the rest is 5 m/s^2 times the mass; give field 'gravity' if the model has "
    .. "it", "gravity that is not given")
  local wrong = results.base(rest, { model = static, gravity = { 0, 0, -10 } })
  local own = heb.area * 4 * 7850
  -- reactions and loads of 10 and 20 kN, the weight by halves in the reactions
  local size = 2 * 30e3 + 5 * own + 10 * own
  equal(wrong.notes[1], ("not in balance: the rest is %.2g of the forces; what else holds the model, such as "
    .. "connectors to the ground, is not in this table"):format(5 * own / size), "another gravity")
  near(wrong.rows.rest.Fz, -5 * own, 1e-3, "the rest, N")
end)

checks.done()

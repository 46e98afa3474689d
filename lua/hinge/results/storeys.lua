-- hinge.results.storeys: drifts and shear forces of storeys, with their peaks over a run.
local core = require "hinge.core"
local check = require "hinge.library.check"
local vectors = require "hinge.library.vectors"
local source = require "hinge.results.source"
local Table = require "hinge.results.table"

local storeys = {}
local Storeys = Table.class "hinge.results_storeys"

local rules = { every = { "number", whole = true, at_least = 1, default = 1 },
  levels = { "numbers", unit = "m", optional = true }, units = source.rules.units }
local axes = { "x", "y" }

-- Levels --------------------------------------------------------------------------------------------------------------

-- Heights that differ by less than `near` are one.
local function distinct(heights, near)
  table.sort(heights)
  local list = {}
  for _, z in ipairs(heights) do
    if #list == 0 or z - list[#list] > near then list[#list + 1] = z end
  end
  return list
end

-- The lowest height of all members, and those of level members.
local function found_levels(where, members)
  local low, high, heights = math.huge, -math.huge, {}
  for _, m in ipairs(members) do
    low, high = math.min(low, m.a.z, m.b.z), math.max(high, m.a.z, m.b.z)
    if math.abs(m.b.z - m.a.z) <= 0.01 * m.length then heights[#heights + 1] = (m.a.z + m.b.z) / 2 end
  end
  heights[#heights + 1] = low
  local list = distinct(heights, 1e-3 * (high - low))
  if #list < 2 then
    check.fail("%s: no storey was found, since no level member is above the lowest node; give field 'levels', the "
      .. "heights of the base and of the floors in m", where)
  end
  return list
end

local function given_levels(where, levels)
  for i = 2, #levels do
    if levels[i] <= levels[i - 1] then
      check.fail("%s: levels[%d] is %s m, which is not above levels[%d], %s m", where, i, check.show(levels[i]), i - 1,
        check.show(levels[i - 1]))
    end
  end
  return levels
end

-- Pairs of nodes of which one stands above the other at two levels: { { below, above }, ... }.
local function pairs_of(nodes, low, high)
  local near, of, list = 1e-3 * (high - low), {}, {}
  local function key(x, y) return ("%d %d"):format(math.floor(x / near + 0.5), math.floor(y / near + 0.5)) end
  for _, node in ipairs(nodes) do
    if math.abs(node.z - low) <= near then of[key(node.x, node.y)] = node end
  end
  for _, node in ipairs(nodes) do
    local below = math.abs(node.z - high) <= near and of[key(node.x, node.y)]
    if below then list[#list + 1] = { below, node } end
  end
  return list
end

-- The members that a level cut at half the height of a storey meets, and where it meets them.
local function cut_of(members, z)
  local list = {}
  for _, m in ipairs(members) do
    local a, b = m.a.z, m.b.z
    if (a - z) * (b - z) < 0 then list[#list + 1] = { member = m, t = (z - a) / (b - a), side = b > a and 1 or -1 } end
  end
  return list
end

-- Forces in space -----------------------------------------------------------------------------------------------------

local cross, dot, unit = vectors.cross, vectors.dot, vectors.unit

-- A vector turned by the shortest rotation that takes the unit vector `from` to `to`.
local function turned(v, from, to)
  local w, c = cross(from, to), dot(from, to)
  if c < -0.999 then return v end
  local wv = cross(w, v)
  local wwv = cross(w, wv)
  return { v[1] + wv[1] + wwv[1] / (1 + c), v[2] + wv[2] + wwv[2] / (1 + c), v[3] + wv[3] + wwv[3] / (1 + c) }
end

-- The section's axes x, y and z now, of a member whose element runs along the unit vector `now` and is twisted by an
-- angle about it.
local function axes_now(member, now, twist)
  local a, b = member.a, member.b
  local z = unit { b.x - a.x, b.y - a.y, b.z - a.z }
  local up = member.up
  local along = dot(up, z)
  local y = unit { up[1] - along * z[1], up[2] - along * z[2], up[3] - along * z[3] }
  y = turned(y, z, now)
  local x, c, s = cross(y, now), math.cos(twist), math.sin(twist)
  for i = 1, 3 do x[i], y[i] = c * x[i] + s * y[i], c * y[i] - s * x[i] end
  return x, y, now
end

-- The resultants at a place, linear between the rows beside it.
local function at_place(rows, x)
  for i = 2, #rows do
    local r, s = rows[i - 1], rows[i]
    if x <= s.x then
      local t, at = s.x > r.x and (x - r.x) / (s.x - r.x) or 0, {}
      for _, name in ipairs(source.names) do at[name] = r[name] + t * (s[name] - r[name]) end
      return at
    end
  end
end

-- Bars of a picture by member: where elements are now.
local function bars_of(pieces)
  local of = {}
  for _, bar in ipairs(pieces.bars) do
    if bar.member and bar.member > 0 then
      of[bar.member] = of[bar.member] or {}
      table.insert(of[bar.member], bar)
    end
  end
  return of
end

-- The vector along a bar: now, or as declared in small displacement.
local function along_bar(member, bar, pieces, large)
  if not large then return { member.b.x - member.a.x, member.b.y - member.a.y, member.b.z - member.a.z } end
  local a, b = pieces.nodes[bar.a], pieces.nodes[bar.b]
  return { b.x - a.x, b.y - a.y, b.z - a.z }
end

-- The twist of a member at a part t of its length, from the rotations of its ends, rad.
local function twist_of(run, member, t, along)
  local _, _, _, ax, ay, az = run:displacement(member.a)
  local _, _, _, bx, by, bz = run:displacement(member.b)
  return (1 - t) * dot({ ax, ay, az }, along) + t * dot({ bx, by, bz }, along)
end

-- What balances the moments at the ends of a twisted element, about which its resultants are half of the way with the
-- ends: the shear forces are their slopes without it. turn: the twist from end to end, rad.
local function of_twist(rows, from, to, turn)
  local a, b = at_place(rows, from + 1e-6 * (to - from)), at_place(rows, to - 1e-6 * (to - from))
  local factor = -turn / (4 * (to - from))
  return factor * (a.Mx + b.Mx), factor * (a.My + b.My)
end

-- The force by which what is above a cut acts on the member below it, in space. Shear forces are moments over the
-- length that a bar had at first; over the length that it has now they are in balance.
local function force_of(run, c, own, pieces, large)
  local t = c.t - 1e-6 -- beside the joint of two elements, not on it
  local place = math.min(#own, math.floor(t * #own) + 1)
  local bar = own[place]
  if not bar or bar.rigid then return { 0, 0, 0 } end
  local rows, part = run:along(c.member, 8), c.member.length / #own
  local at = at_place(rows, t * c.member.length)
  if not at then return { 0, 0, 0 } end
  local along = along_bar(c.member, bar, pieces, large)
  local N, Qx, Qy, twist = at.N, at.Qx, at.Qy, 0
  if large then
    local z = unit(along)
    local low, high = twist_of(run, c.member, (place - 1) / #own, z), twist_of(run, c.member, place / #own, z)
    local by_x, by_y = of_twist(rows, (place - 1) * part, place * part, high - low)
    local stretch = vectors.length(along) / part
    Qx, Qy, twist = (Qx + by_x) / stretch, (Qy + by_y) / stretch, (low + high) / 2
  end
  local x, y, z = axes_now(c.member, unit(along), twist)
  local force = {}
  for i = 1, 3 do force[i] = c.side * (N * z[i] + Qx * x[i] + Qy * y[i]) end
  return force
end

-- The horizontal force by which what is above a cut acts on what is below, x and y.
local function shear_of(run, cut, pieces, bars, large)
  local sum = { 0, 0 }
  for _, c in ipairs(cut) do
    local force = force_of(run, c, bars[c.member.index] or {}, pieces, large)
    sum[1], sum[2] = sum[1] + force[1], sum[2] + force[2]
  end
  return sum
end

-- States --------------------------------------------------------------------------------------------------------------

local function keep_largest(row, key, value, when)
  if row[key] == nil or math.abs(value) > math.abs(row[key]) then row[key], row[key .. "_when"] = value, when end
  row[key .. "_min"] = math.min(row[key .. "_min"] or value, value)
  row[key .. "_max"] = math.max(row[key .. "_max"] or value, value)
  row[key .. "_last"] = value
end

-- The drift of a storey now: the largest of its pairs of nodes, in x and y.
local function drift_of(run, list, height)
  local largest, line = { 0, 0 }, {}
  for _, pair in ipairs(list) do
    local below, above = { run:displacement(pair[1]) }, { run:displacement(pair[2]) }
    for i = 1, 2 do
      local drift = (above[i] - below[i]) / height
      if math.abs(drift) >= math.abs(largest[i]) then largest[i], line[i] = drift, pair[2] end
    end
  end
  return largest, line
end

-- Reads the model when the first run is added.
local function open(self, run)
  local model = source.model(self.where, run, self.o)
  local members, nodes = model:members(), model:nodes()
  local levels = self.o.levels and given_levels(self.where, self.o.levels) or found_levels(self.where, members)
  for k = 2, #levels do
    local low, high = levels[k - 1], levels[k]
    local row = { storey = k - 1, from = low, to = high, height = high - low, pairs = pairs_of(nodes, low, high),
      cut = cut_of(members, (low + high) / 2) }
    if #row.pairs == 0 then row.remark = "no node stands above another one" end
    if #row.cut == 0 then
      check.fail("%s: no member is cut at half the height of storey %d, z = %s m; give other levels", self.where, k - 1,
        check.show((low + high) / 2))
    end
    self.rows[k - 1] = row
  end
  self.levels = levels
end

--- Adds the state that a run has now. name: what the state is called; default: its time, or its loads.
function Storeys:add(run, name, ...)
  local when = source.begin("storeys:add", run, name, ...)
  if not self.levels then open(self, run) end
  local pieces = core.pieces(run)
  local bars, large = bars_of(pieces), source.is_large(run)
  for _, row in ipairs(self.rows) do
    local drift, line = drift_of(run, row.pairs, row.height)
    local shear = shear_of(run, row.cut, pieces, bars, large)
    for i, axis in ipairs(axes) do
      if #row.pairs > 0 then
        local before = row["drift_" .. axis]
        keep_largest(row, "drift_" .. axis, drift[i], when)
        if row["drift_" .. axis] ~= before then row["line_" .. axis] = line[i] end
      end
      keep_largest(row, "shear_" .. axis, shear[i], when)
    end
  end
  self.moves = self.moves or run.kind == "dynamic"
  return source.ended(self, run, name)
end

-- Columns: a direction in which next to nothing happens is minor.
function Storeys:all_columns()
  local size = { drift = {}, shear = {} }
  for _, row in ipairs(self.rows) do
    for what, of in pairs(size) do
      for _, axis in ipairs(axes) do
        of[axis] = math.max(of[axis] or 0, math.abs(row[what .. "_" .. axis] or 0))
      end
    end
  end
  local list = { { key = "storey", head = "storey", kind = "whole" }, { key = "to", head = "up to z", kind = "length" },
    { key = "height", head = "height", kind = "length", minor = true } }
  for _, axis in ipairs(axes) do
    local other = axis == "x" and "y" or "x"
    local function minor(what) return (size[what][axis] or 0) <= 1e-6 * (size[what][other] or 0) end
    local drift, shear = "drift_" .. axis, "shear_" .. axis
    list[#list + 1] = { key = drift, head = "drift " .. axis, kind = "number", when = drift .. "_when", decimals = 5,
      minor = minor "drift" }
    list[#list + 1] = { key = drift .. "_last", head = "at the end", kind = "number", decimals = 5,
      minor = not self.moves or minor "drift" }
    list[#list + 1] = { key = shear, head = "shear " .. axis, kind = "force", when = shear .. "_when",
      minor = minor "shear" }
    list[#list + 1] = { key = shear .. "_last", head = "at the end", kind = "force", minor = true }
  end
  list[#list + 1] = Table.remarks(self.rows)
  return list
end

-- A profile over the height: each storey is an upright line.
local function profile(rows, key, name, length, dashed)
  local s = { x = {}, y = {}, name = name, dashed = dashed }
  for _, row in ipairs(rows) do
    for _, z in ipairs { row.from, row.to } do
      s.x[#s.x + 1], s.y[#s.y + 1] = row[key] and math.abs(row[key]) or 0 / 0, z * length
    end
  end
  return s
end

--- Draws the largest drift, or shear force, of each storey over the height, and that at the end.
-- storeys:plot(filename, options) or storeys:plot(job, filename, options)
function Storeys:plot(...)
  local where = "storeys:plot"
  local job, filename, options = Table.plot_arguments(where, ...)
  local o = check.options(where, options, { quantity = { "string", one_of = { "drift", "shear" }, default = "drift" },
    units = { "string", optional = true }, title = { "string", optional = true } })
  if self.states == 0 then check.fail("%s: there is no state yet", where) end
  local set = require "hinge.results.units".read(where, o.units or self.units)
  local series, shown = {}, {}
  for _, column in ipairs(self:all_columns()) do shown[column.key] = not column.minor end
  for _, axis in ipairs(axes) do
    local key = o.quantity .. "_" .. axis
    if shown[key] then
      series[#series + 1] = profile(self.rows, key, ("largest, %s"):format(axis), set.length.factor)
      if self.moves then
        series[#series + 1] = profile(self.rows, key .. "_last", ("at the end, %s"):format(axis), set.length.factor,
          true)
      end
    end
  end
  local factor, largest = o.quantity == "drift" and 100 or set.force.factor, 0
  for _, s in ipairs(series) do
    for i, v in ipairs(s.x) do
      s.x[i] = factor * v
      if v == v then largest = math.max(largest, s.x[i]) end
    end
  end
  Table.draw(where, { series = series, title = o.title, y_label = "z, " .. set.length.name,
    x_range = largest > 0 and { 0, 1.15 * largest } or nil,
    x_label = o.quantity == "drift" and "drift of the storey, %" or "shear force of the storey, " .. set.force.name },
    job, filename)
  return self
end

--- hinge.results.storeys(run or list of runs, { model =, levels =, every =, names =, units = })
function storeys.new(runs, options, ...)
  local where = "hinge.results.storeys"
  check.no_more(where, ...)
  if type(runs) ~= "table" then runs = { source.must_be_run(where, runs) } end
  local o = source.options(where, options, rules, { "model", "names" })
  local self = Table.new(Storeys, { where = where, o = o, states = 0, units = o.units })
  return source.collect(where, self, runs, o.names, o.every)
end

return storeys

-- hinge.results.utilisation: the checks of EN 1993-1-1 or AISC 360-16 for members of steel, over one or more runs, and
-- joints against their own strength.
local check = require "hinge.library.check"
local aisc = require "hinge.standards.aisc_360.members"
local Envelope = require "hinge.results.envelope".class
local eurocode = require "hinge.standards.en_1993_1_1.members"
local joints = require "hinge.results.joints"
local lengths = require "hinge.results.lengths"
local profile = require "hinge.results.profile"
local source = require "hinge.results.source"
local Table = require "hinge.results.table"

local utilisation = {}
local Utilisation = Table.class "hinge.results_utilisation"

local standards = { "EN 1993-1-1", "AISC 360" }
local factor = { "number", above = 0, default = 1 }
local rules = {
  standard = { "string", one_of = standards }, every = { "number", whole = true, at_least = 1, default = 1 },
  gamma_M0 = factor, gamma_M1 = factor, curve_LT = { "string", one_of = eurocode.curves, optional = true },
  interaction = { "string", one_of = { "standard", "linear", "exact" }, default = "standard" },
  parts = source.rules.parts, units = source.rules.units,
}
local free = { "model", "group", "members", "names", "lengths", "curves", "Cm" }
local of_eurocode = { "gamma_M0", "gamma_M1", "curve_LT", "interaction", "curves", "Cm" }

-- Options -------------------------------------------------------------------------------------------------------------

local function read_curves(where, curves)
  if curves == nil then return nil end
  if type(curves) == "string" then curves = { x = curves, y = curves } end
  if type(curves) ~= "table" then
    check.fail("%s: field 'curves' is %s; must be a curve, such as 'b', or { x = 'a', y = 'b' }", where,
      check.show(curves))
  end
  local rule = { "string", one_of = eurocode.curves, optional = true }
  return check.options(where .. ": field 'curves'", curves, { x = rule, y = rule })
end

-- Factors of equivalent moments: a number for all, { x =, y =, LT = }, or "B.3" for those of table B.3.
local function read_Cm(where, Cm)
  if Cm == nil then return { x = 1, y = 1, LT = 1 } end
  if Cm == "B.3" then return Cm end
  if type(Cm) == "number" then Cm = { x = Cm, y = Cm, LT = Cm } end
  if type(Cm) ~= "table" then
    check.fail("%s: field 'Cm' is %s; must be a number, { x =, y =, LT = } or 'B.3'", where, check.show(Cm))
  end
  local rule = { "number", at_least = 0.4, at_most = 1, default = 1 }
  return check.options(where .. ": field 'Cm'", Cm, { x = rule, y = rule, LT = rule })
end

local function read_options(where, options)
  local o = source.options(where, options, rules, free)
  o.eurocode = o.standard == "EN 1993-1-1"
  if not o.eurocode then
    for _, name in ipairs(of_eurocode) do
      if options[name] ~= nil then check.fail("%s: field '%s' is for EN 1993-1-1 alone", where, name) end
    end
  end
  o.curves, o.Cm = read_curves(where, o.curves), read_Cm(where, o.Cm)
  return o
end

-- Members -------------------------------------------------------------------------------------------------------------

-- Why a member is not checked, whatever its forces are.
local function not_checked(material, plates, why, L)
  local fy, E = material.yield_stress, material.E
  if not plates then return why end
  if L.Lb and (plates.shape == "rectangle" or plates.shape == "box") and plates.b > plates.d then
    return "Lb is given, and its section is wider than deep: lateral torsional buckling is checked for bending about x"
  end
  if fy == math.huge then return "its material has no yield stress" end
  if E < 185e9 or E > 215e9 then return ("its E is %.4g GPa, which is not that of steel"):format(E / 1e9) end
  if fy > 700e6 then return ("its yield stress is %.4g MPa; the formulas hold up to 700 MPa"):format(fy / 1e6) end
end

-- The row of a member with what does not change: plates, lengths, strengths.
local function new_row(self, member)
  local s, material = member.section, member.material
  local plates, why = profile.of(s)
  local row = { member = member, index = member.index, group = member.group, checks = {}, section = s,
    material = material, plates = plates, lengths = lengths.of(self.where, self.o.lengths, member) }
  row.refused = not_checked(material, plates, why, row.lengths)
  if not row.refused and not self.o.eurocode then row.strengths = aisc.strengths(s, plates, material, row.lengths) end
  return row
end

-- Extremes of what acts along a member.
local function demand_of(along)
  local d = { compression = 0, tension = 0, Mx = 0, My = 0 }
  for _, at in ipairs(along) do
    d.compression, d.tension = math.max(d.compression, -at.N), math.max(d.tension, at.N)
    d.Mx, d.My = math.max(d.Mx, math.abs(at.Mx)), math.max(d.My, math.abs(at.My))
  end
  return d
end

-- Table B.3 for a moment that is linear from end to end; 1 for others, which is on the safe side.
local function by_ends(along, name)
  local a, b = along[1][name], along[#along][name]
  local length, size = along[#along].x - along[1].x, math.max(math.abs(a), math.abs(b))
  for _, at in ipairs(along) do
    local linear = a + (b - a) * (at.x - along[1].x) / length
    if not (math.abs(at[name] - linear) <= 0.02 * size) then return 1 end
  end
  if size == 0 then return 1 end
  local psi = math.abs(a) >= math.abs(b) and b / a or a / b
  return math.max(0.4, 0.6 + 0.4 * psi)
end

local function Cm_of(o, along)
  if o.Cm ~= "B.3" then return o.Cm end
  local x, y = by_ends(along, "Mx"), by_ends(along, "My")
  return { x = x, y = y, LT = x }
end

-- Keeps the largest value of each check of a row, and the largest of all.
local function keep(row, checks, x, when)
  for name, value in pairs(checks) do
    local known = row.checks[name]
    if not known or value > known.value then
      row.checks[name] = { value = value, x = x, when = when }
      row[name] = value
    end
    local first = row.utilisation == nil or value > row.utilisation
      or value == row.utilisation and x == row.x and name < row.check
    if first then row.utilisation, row.check, row.x, row.when = value, name, x, when end
  end
end

local function refuse(row, why, when)
  for name in pairs(row.checks) do row[name] = nil end
  row.checks, row.utilisation, row.check, row.x, row.when = {}, nil, nil, nil, when
  row.refused = why
end

-- One state of a member: its rows of resultants.
local function check_state(self, row, along, when)
  local o, s, p, material = self.o, row.section, row.plates, row.material
  local d = demand_of(along)
  local code = o.eurocode and eurocode or aisc
  local why, slenderness = code.refused(p, material.yield_stress, d, material.E)
  row.slenderness = math.max(row.slenderness or 0, slenderness)
  if why then return refuse(row, why, when) end
  for _, at in ipairs(along) do
    if o.eurocode then keep(row, (eurocode.section(s, p, material.yield_stress, at, o)), at.x, when)
    else keep(row, aisc.section(s, p, at, row.strengths), at.x, when) end
  end
  if o.eurocode then
    local checks, detail = eurocode.member(s, p, material, d, row.lengths, Cm_of(o, along), o)
    keep(row, checks, nil, when)
    row.detail = detail
  else keep(row, aisc.member(d, row.strengths), nil, when) end
end

local function set_remark(row)
  row.remark = row.refused and "not checked: " .. row.refused or row.broken and "broken" or nil
end

local function row_of(self, member)
  local row = self.of[member.index]
  if not row then
    row = new_row(self, member)
    self.of[member.index], self.rows[#self.rows + 1] = row, row
  end
  return row
end

-- Joints of one state, or their extremes: a row each.
local function check_joints(self, list, when)
  for _, joint in ipairs(list) do
    local row = self.of[joint.name]
    if not row then
      row = { joint = joint.name, member = joint.member, index = joint.member.index, group = joint.group, checks = {} }
      self.of[joint.name], self.rows[#self.rows + 1] = row, row
    end
    local checks, without = joints.checks(joint)
    keep(row, checks, joint.x, when)
    row.broken = row.broken or joint.broken
    row.refused = not next(checks) and without or nil
    set_remark(row)
    row.remark = row.remark or without
  end
end

--- Adds the state that a run has now. name: what the state is called; default: its time, or its loads.
function Utilisation:add(run, name, ...)
  local when = source.begin("utilisation:add", run, name, ...)
  self.list = self.list or source.members(self.where, run, self.o)
  for _, member in ipairs(self.list) do
    local row = row_of(self, member)
    local state, f_y = run:state(member)
    row.law = math.max(row.law or 0, math.sqrt(math.max(0, f_y)))
    row.broken = row.broken or state == "broken"
    local along = not row.refused and run:along(member, self.o.parts) or {}
    if #along > 0 then check_state(self, row, along, when) end
    set_remark(row)
  end
  check_joints(self, joints.read(run, self.where, source.by_index(self.list)), when)
  return source.ended(self, run, name)
end

local others = { "Mx", "My", "Mz", "Qx", "Qy" }

-- The resultants of stations as rows: N on one side (1: smallest, 2: largest), and the largest sizes of the rest.
local function sizes_at(stations, side)
  local along = {}
  for _, station in ipairs(stations) do
    if station.N then
      local at = { x = station.x, N = station.N[side] }
      for _, name in ipairs(others) do at[name] = math.max(math.abs(station[name][1]), math.abs(station[name][2])) end
      along[#along + 1] = at
    end
  end
  return along
end

-- The row between two others with the extremes of both.
local function row_between(x, r, s, side)
  local at = { x = x, N = (side == 1 and math.min or math.max)(r.N, s.N) }
  for _, other in ipairs(others) do at[other] = math.max(r[other], s[other]) end
  return at
end

-- Adds a row where a resultant has an extreme value between two stations, with the extremes of the two for the rest.
local function add_peaks(along, extremes, side)
  local count = #along
  local function add(name, end_of_range)
    local x, value = extremes[name .. end_of_range .. "_x"], extremes[name .. end_of_range]
    for i = 2, count do
      if x > along[i - 1].x and x < along[i].x then
        local at = row_between(x, along[i - 1], along[i], side)
        at[name] = name == "N" and value or math.max(at[name], math.abs(value))
        along[#along + 1] = at
      end
    end
  end
  add("N", side == 1 and "_min" or "_max")
  for _, name in ipairs(others) do
    for _, end_of_range in ipairs { "_min", "_max" } do add(name, end_of_range) end
  end
end

-- Extremes of an envelope along each member, taken together: tension and compression each with the largest of the rest.
local function from_envelope(self, envelope)
  if envelope.states == 0 then check.fail("%s: the envelope has no state yet", self.where) end
  if self.o.Cm == "B.3" then
    check.fail("%s: field 'Cm' is 'B.3', which needs the moments of one state; give runs in place of the envelope, or "
      .. "a number", self.where)
  end
  for _, extremes in ipairs(envelope.rows) do
    local row = row_of(self, extremes.member)
    for _, side in ipairs { 1, 2 } do
      local along = sizes_at(extremes.stations, side)
      add_peaks(along, extremes, side)
      if #along > 0 and not row.refused then check_state(self, row, along, "extremes") end
    end
    set_remark(row)
  end
  check_joints(self, envelope.joints, "extremes")
  self.states = envelope.states
  table.insert(self.notes, "the extremes of different times or cases are taken together, which is on the safe side")
end

-- What is shown -------------------------------------------------------------------------------------------------------

-- The names of all checks that rows have.
local function names_of(rows)
  local seen, list = {}, {}
  for _, row in ipairs(rows) do
    for name in pairs(row.checks) do
      if not seen[name] then seen[name], list[#list + 1] = true, name end
    end
  end
  table.sort(list)
  return list
end

function Utilisation:all_columns()
  local columns = {
    { key = "index", head = "member", kind = "whole" }, { key = "group", head = "group", kind = "text" },
    { key = "joint", head = "joint", kind = "text", minor = true },
    { key = "utilisation", head = "utilisation", kind = "number", decimals = 3 },
    { key = "check", head = "check", kind = "text" }, { key = "x", head = "at x", kind = "length" },
    { key = "when", head = "when", kind = "text" }, { key = "law", head = "√f_y", kind = "number", decimals = 3 },
    { key = "slenderness", head = "plates", kind = "number", decimals = 3 },
    Table.remarks(self.rows),
  }
  for _, row in ipairs(self.rows) do
    if row.joint then columns[3].minor = false end
  end
  for _, name in ipairs(names_of(self.rows)) do
    columns[#columns + 1] = { key = name, head = name, kind = "number", decimals = 3, minor = true }
  end
  return columns
end

--- Draws the utilisations as bars, the largest first. options: top (default 20), title.
-- utilisation:plot(filename, options) or utilisation:plot(job, filename, options)
function Utilisation:plot(...)
  local where = "utilisation:plot"
  local job, filename, options = Table.plot_arguments(where, ...)
  local o = check.options(where, options, { top = { "number", whole = true, above = 0, default = 20 },
    title = { "string", optional = true } })
  local rows = {}
  for _, row in ipairs(self.rows) do
    if row.utilisation then rows[#rows + 1] = row end
  end
  if #rows == 0 then check.fail("%s: no member and no joint has been checked", where) end
  table.sort(rows, function(a, b)
    return a.utilisation > b.utilisation or a.utilisation == b.utilisation and a.index < b.index
  end)
  local bars = { x = {}, y = {}, style = "bars", labels = {} }
  for i = 1, math.min(o.top, #rows) do
    local row = rows[i]
    table.insert(bars.x, row.utilisation)
    table.insert(bars.y, row.joint
      or ("member %d%s"):format(row.index, row.group and " (" .. row.group .. ")" or ""))
    table.insert(bars.labels, ("%.2f, %s"):format(row.utilisation, row.check))
  end
  Table.draw(where, { series = { bars }, title = o.title, x_label = "utilisation, " .. self.o.standard,
    lines = { { x = 1, name = "" } }, x_range = { 0, 1.25 * math.max(1, rows[1].utilisation) } }, job, filename)
  return self
end

local function remarks(o)
  local list = { o.eurocode and "EN 1993-1-1:2005, classes 1 and 2, annex B, of the resultants of the run"
    or "AISC 360-16, LRFD, of the resultants of the run" }
  list[2] = lengths.remark(o.lengths)
  return list
end

--- hinge.results.utilisation(run, list of runs or envelope, { standard =, lengths =, ... })
function utilisation.new(runs, options, ...)
  local where = "hinge.results.utilisation"
  check.no_more(where, ...)
  local o = read_options(where, options)
  local self = Table.new(Utilisation, { where = where, o = o, of = {}, states = 0, units = o.units,
    order = "utilisation", notes = remarks(o) })
  if Table.is(runs, Envelope) then
    from_envelope(self, runs)
    return self
  end
  if type(runs) ~= "table" then runs = { source.must_be_run(where, runs) } end
  return source.collect(where, self, runs, o.names, o.every)
end

return utilisation

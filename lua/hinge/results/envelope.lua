-- hinge.results.envelope: the smallest and largest resultants of each member over the steps of a dynamic run, or over
-- several runs.
local check = require "hinge.library.check"
local joints = require "hinge.results.joints"
local members = require "hinge.results.members"
local source = require "hinge.results.source"
local Table = require "hinge.results.table"

local Envelope = Table.class "hinge.results_envelope"
local envelope = { class = Envelope }

local rules = { every = { "number", whole = true, at_least = 1, default = 1 } }
for name, rule in pairs(source.rules) do rules[name] = rule end
local free = { "names", table.unpack(source.free) }

function Envelope:all_columns() return members.columns(self.rows, true) end

-- The smallest and largest values at the stations x = k / parts of a member; on both sides of a jump.
local function widen_stations(stations, rows, length, parts)
  local near = 1e-6 * length
  local k = 0
  for _, at in ipairs(rows) do
    while k < parts and at.x > k * length / parts + near do k = k + 1 end
    if math.abs(at.x - k * length / parts) <= near then
      local station = stations[k + 1]
      for _, name in ipairs(source.names) do
        local own = station[name]
        if not own then station[name] = { at[name], at[name] }
        else own[1], own[2] = math.min(own[1], at[name]), math.max(own[2], at[name]) end
      end
    end
  end
end

-- The row of a member, made when it is first met.
local function row_of(self, member)
  local row = self.of[member.index]
  if row then return row end
  row = members.row(member)
  row.stations = {}
  for k = 0, self.parts do row.stations[k + 1] = { x = k * member.length / self.parts } end
  self.of[member.index] = row
  self.rows[#self.rows + 1] = row
  return row
end

--- Adds the state that a run has now. name: what the state is called; default: its time, or its loads.
function Envelope:add(run, name, ...)
  local when = source.begin("envelope:add", run, name, ...)
  self.list = self.list or source.members(self.where, run, self.o)
  for _, member in ipairs(self.list) do
    local row, along = row_of(self, member), run:along(member, self.parts)
    members.widen(row, along, when)
    widen_stations(row.stations, along, member.length, self.parts)
    if #along == 0 then row.remark = "broken" end
  end
  joints.widen(self.joints, joints.read(run, self.where, source.by_index(self.list)))
  return source.ended(self, run, name)
end

-- Plot ----------------------------------------------------------------------------------------------------------------

-- Members one after the other along one axis of length: edges of the band, and where members begin.
local function line_of(rows, name, set)
  local band = { x = {}, low = {}, high = {}, style = "band", name = name }
  local lines, from = {}, 0
  local value, length = set[source.kind[name]].factor, set.length.factor
  local function add(x, own) -- without values: a gap
    band.x[#band.x + 1] = x * length
    band.low[#band.low + 1] = own and own[1] * value or 0 / 0
    band.high[#band.high + 1] = own and own[2] * value or 0 / 0
  end
  for i, row in ipairs(rows) do
    if i > 1 then
      lines[#lines + 1] = { x = from * length, name = "", dashed = true }
      add(from, nil)
    end
    for _, station in ipairs(row.stations) do add(from + station.x, station[name]) end
    from = from + row.length
  end
  lines[#lines + 1] = { y = 0, name = "", dashed = false }
  return band, lines
end

-- The rows of the members that are to be drawn, in the order that is given.
local function rows_of(self, where, list)
  if list == nil then return self.rows end
  local rows = {}
  for i, member in ipairs(list) do
    rows[i] = check.kind_of(member) == "member" and self.of[member.index]
      or check.fail("%s: members[%d] is %s; must be a member of this envelope", where, i, check.show(member))
  end
  return rows
end

--- Draws the band between smallest and largest values along members that follow each other.
-- envelope:plot(filename, options) or envelope:plot(job, filename, options)
function Envelope:plot(...)
  local where = "envelope:plot"
  local job, filename, options = Table.plot_arguments(where, ...)
  local text = { "string", optional = true }
  local o = check.options(where, options, { quantity = { "string", one_of = source.names, default = "Mx" },
    members = { "table", optional = true }, units = text, title = text })
  local set = require "hinge.results.units".read(where, o.units or self.units)
  local rows = rows_of(self, where, o.members)
  if #rows == 0 then check.fail("%s: the envelope has no state yet", where) end
  local band, lines = line_of(rows, o.quantity, set)
  local edges = {}
  for i, side in ipairs { "low", "high" } do edges[i] = { x = band.x, y = band[side], colour = "blue" } end
  Table.draw(where, { series = { band, edges[1], edges[2] }, lines = lines, title = o.title,
    x_label = "x, " .. set.length.name, y_label = ("%s, %s"):format(o.quantity, set[source.kind[o.quantity]].name) },
    job, filename)
  return self
end

--- hinge.results.envelope { run, run ..., model =, group =, members =, parts =, every =, names =, units = }
function envelope.new(options, ...)
  local where = "hinge.results.envelope"
  check.no_more(where, ...)
  if source.is_run(options) then options = { options } end
  if type(options) ~= "table" then
    check.fail("%s: takes a table with runs and options, got %s", where, check.show(options))
  end
  local runs, plain = {}, {}
  for key, value in pairs(options) do
    if math.type(key) == "integer" then runs[key] = value else plain[key] = value end
  end
  local o = source.options(where, plain, rules, free)
  local self = Table.new(Envelope, { where = where, o = o, parts = o.parts, of = {}, joints = {}, states = 0,
    units = o.units, sort_keys = members.sort_keys() })
  return source.collect(where, self, runs, o.names, o.every)
end

return envelope

-- hinge.moving_load: forces that move along a line of members, as functions of time; and influence lines.
--
-- The line has fixed places, `parts` on each member. A force between two places is divided between both by the lever
-- rule, so each place has a history with straight flanks for each axle. A place between the nodes of a member is a
-- point load on it, with its exact end forces (model:load with `at`). The forces have no mass and no springs.
local core = require "hinge.core"
local check = require "hinge.library.check"
local vectors = require "hinge.library.vectors"
local faces = require "hinge.actions.faces"
local chosen = require "hinge.model.chosen_members"

local near = 1e-9 -- of the length of the line: places that differ by less are the same
local most_places = 20000

-- The line ------------------------------------------------------------------------------------------------------------

local function shared_node(a, b)
  for _, node in ipairs { a.a, a.b } do
    if node == b.a or node == b.b then return node end
  end
end

-- The node at which the line begins.
local function first_node(where, members, from)
  local first = members[1]
  if #members > 1 then
    local joint = shared_node(first, members[2])
    if not joint then
      check.fail("%s: members %d and %d, which are neighbours in the line, have no node in common; give the members in "
        .. "their order along the line", where, first.index, members[2].index)
    end
    local start = first.a == joint and first.b or first.a
    if from ~= nil and from ~= start then
      check.fail("%s: field 'from' is %s; the line of these members begins at %s; turn the list around to begin at its "
        .. "other end", where, check.show(from), tostring(start))
    end
    return start
  end
  if from ~= nil and from ~= first.a and from ~= first.b then
    check.fail("%s: field 'from' is %s; must be an end of member %d", where, check.show(from), first.index)
  end
  return from or first.a
end

-- The members of the model as { member =, from =, length = (m), turned = whether the line runs from b to a }, and the
-- length.
local function read_line(where, o)
  chosen.model(where, o.model)
  local members = chosen.members(where, o.model, o.members, o.group)
  local at, length, line = first_node(where, members, o.from), 0, {}
  line.first = at
  for i, member in ipairs(members) do
    if member.a ~= at and member.b ~= at then
      check.fail("%s: member %d does not begin where member %d ends, at %s; give the members in their order along the "
        .. "line", where, member.index, members[i - 1].index, tostring(at))
    end
    local turned = member.a ~= at
    line[i] = { member = member, from = length, length = member.length, turned = turned }
    length, at = length + member.length, turned and member.a or member.b
    line[i].last = at
  end
  line.length = length
  return line
end

-- Where s (m from the beginning) is: a node, or a member and the part of its length from a.
local function spot_of(line, s)
  if s <= near * line.length then return { node = line.first } end
  for _, piece in ipairs(line) do
    local rest = s - piece.from
    if math.abs(rest - piece.length) <= near * line.length then return { node = piece.last } end
    if rest < piece.length then
      local part = rest / piece.length
      return { member = piece.member, at = piece.turned and 1 - part or part }
    end
  end
end

-- The places of the line, m: `parts` on each member.
local function places_of(line, parts)
  local list = { 0 }
  for _, piece in ipairs(line) do
    for i = 1, parts do list[#list + 1] = piece.from + piece.length * i / parts end
  end
  return list
end

-- With the fields of the line.
local function rules_with(rules)
  for _, name in ipairs { "model", "members", "group", "from" } do rules[name] = faces.any end
  return rules
end
local parts_rule = { "number", whole = true, at_least = 1, at_most = 1000 }

-- Histories -----------------------------------------------------------------------------------------------------------

-- The force of an axle at a place: 0 at `rises`, all at `full`, 0 at `falls` (s). Without `rises` or `falls` it begins
-- or ends by a jump at `full`, at an end of the line. `left`: the value before a jump.
local function share(h, t, left)
  if t < h.full or t == h.full and left then
    return h.rises and t > h.rises and (t - h.rises) / (h.full - h.rises) or 0
  end
  return h.falls and t < h.falls and (h.falls - t) / (h.falls - h.full) or 0
end

-- The sum of the axles at a place as points { time, force }.
local function history_of(hats)
  local times, seen = {}, {}
  for _, h in ipairs(hats) do
    for _, t in pairs { h.rises or h.full, h.full, h.falls or h.full } do
      if not seen[t] then
        seen[t] = true
        times[#times + 1] = t
      end
    end
  end
  table.sort(times)
  local points = {}
  for _, t in ipairs(times) do
    local before, after = 0, 0
    for _, h in ipairs(hats) do
      before, after = before + h.force * share(h, t, true), after + h.force * share(h, t, false)
    end
    points[#points + 1] = { t, before }
    if after ~= before then points[#points + 1] = { t, after } end
  end
  return points
end

local function read_axles(where, given)
  check.value(where, "axles", given, { "table" })
  if #given == 0 then
    check.fail("%s: field 'axles' is empty; must be a list of axles { force = N, distance = m behind the first one }",
      where)
  end
  local axles = {}
  for i, axle in ipairs(given) do
    axles[i] = check.options(("%s: axles[%d]"):format(where, i), axle, { force = { "number", unit = "N" },
      distance = { "number", unit = "m", at_least = 0, default = i == 1 and 0 or nil } })
  end
  return axles
end

-- The load of a place, at s[i] of the places: its force is 1 N, and its history is in N. So a call that adds up loads
-- without their histories does not find each axle at every place.
local function load_of(line, s, i, axles, o, direction)
  local hats = {}
  for k, axle in ipairs(axles) do
    local function time(place) return o.start + (place + axle.distance) / o.speed end
    hats[k] = { force = axle.force, full = time(s[i]), rises = s[i - 1] and time(s[i - 1]),
      falls = s[i + 1] and time(s[i + 1]) }
  end
  local load = spot_of(line, s[i])
  load.force, load.history = direction, history_of(hats)
  return load
end

-- The object ----------------------------------------------------------------------------------------------------------

local moving = {}
local methods = {}
local Moving = { __name = "hinge.moving_load", __index = methods }

function Moving.__tostring(self)
  return ("%s along %.6g m at %.6g m/s, from %.6g s to %.6g s"):format(check.count(#self.axles, "axle"), self.length,
    self.speed, self.start, self.leaves)
end

--- moving:positions(time): where each axle is on the line, m, or false.
function methods.positions(self, time, ...)
  local where = "moving:positions"
  check.no_more(where, ...)
  check.value(where, "time", time, { "number", unit = "s" })
  local list = {}
  for i, axle in ipairs(self.axles) do
    local s = (time - self.start) * self.speed - axle.distance
    list[i] = s >= 0 and s <= self.length and s
  end
  return list
end

-- hinge.moving_load { ... }
local function new(_, options, ...)
  local where = "hinge.moving_load"
  check.no_more(where, ...)
  if type(options) == "table" and options.case ~= nil then
    check.fail("%s: field 'case' is not there: a static run that names the load case would put the forces at all "
      .. "places at once; the forces act in every dynamic run", where)
  end
  local o = check.options(where, options, rules_with { axles = { "table" },
    speed = { "number", unit = "m/s", above = 0 }, start = { "number", unit = "s", default = 0 },
    parts = { "number", whole = true, at_least = 1, at_most = 1000, default = 10 },
    direction = { "table", default = { 0, 0, -1 } } })
  local line = read_line(where, o)
  local direction, axles = faces.direction(where, "direction", o.direction), read_axles(where, o.axles)
  local s, loads = places_of(line, o.parts), {}
  if #s > most_places then
    check.fail("%s: the line has %d places; the most are %d; give fewer 'parts'", where, #s, most_places)
  end
  for i = 1, #s do loads[i] = load_of(line, s, i, axles, o, direction) end
  for _, load in ipairs(loads) do o.model:load(load) end
  local last = 0
  for _, axle in ipairs(axles) do last = math.max(last, axle.distance) end
  return setmetatable({ axles = axles, length = line.length, speed = o.speed, start = o.start, places = #s,
    leaves = o.start + (line.length + last) / o.speed }, Moving)
end

-- Influence lines -----------------------------------------------------------------------------------------------------

-- What `read` returns, as a table of numbers by name; one number has the name "value".
local function values_of(where, o, run)
  local given = o.read(run)
  if type(given) == "number" then given = { value = given } end
  if type(given) ~= "table" or next(given) == nil then
    check.fail("%s: the function in field 'read' returned %s; must return a number, or a table of numbers by name",
      where, check.show(given))
  end
  for name, value in pairs(given) do
    if type(name) ~= "string" or type(value) ~= "number" or value ~= value then
      check.fail("%s: the function in field 'read' returned %s = %s; must return a number, or a table of numbers by "
        .. "name", where, check.show(name), check.show(value))
    end
  end
  return given
end

local function run_with(where, o, factors, what)
  local run = o.model:static { steps = o.steps, loads = factors, record = false }:finish()
  if run.verdict ~= "completed" and not core.planning() then
    check.fail("%s: the static run %s has the verdict '%s': %s", where, what, run.verdict, run.reason)
  end
  return values_of(where, o, run)
end

-- The positions that are asked for, m, in rising order.
local function read_positions(where, o, line)
  if o.positions == nil then return places_of(line, o.parts or 10) end
  if o.parts ~= nil then check.fail("%s: give either 'parts' or 'positions'; both are given", where) end
  check.value(where, "positions", o.positions, { "numbers", unit = "m", at_least = 0,
    at_most = line.length * (1 + near) })
  for i = 2, #o.positions do
    if o.positions[i] <= o.positions[i - 1] then
      check.fail("%s: field 'positions' is out of order at number %d (%g m); must rise", where, i, o.positions[i])
    end
  end
  return o.positions
end

-- A load case for each position, whose name is not taken.
local function new_cases(o, line, positions, direction)
  local taken, cases = {}, {}
  for _, case in ipairs(o.model:cases()) do taken[case.name] = true end
  local number = 1
  while taken[("influence line %d, 1"):format(number)] do number = number + 1 end
  for i, s in ipairs(positions) do
    local load = spot_of(line, s)
    load.force = vectors.times(o.force, direction)
    load.case = o.model:case(("influence line %d, %d"):format(number, i))
    o.model:load(load)
    cases[i] = load.case
  end
  return cases
end

local function with(loads, case, factor)
  local all = {}
  for name, value in pairs(loads) do all[name] = value end
  all[case] = factor
  return all
end

--- hinge.moving_load.influence { ... }
function moving.influence(options, ...)
  local where = "hinge.moving_load.influence"
  check.no_more(where, ...)
  local o = check.options(where, options, rules_with { read = { "function" },
    force = { "number", unit = "N", above = 0, default = 1 }, direction = { "table", default = { 0, 0, -1 } },
    parts = faces.any, positions = faces.any, loads = { "table", default = {} },
    steps = { "number", whole = true, at_least = 1, at_most = 1000, default = 1 } })
  if o.parts ~= nil then check.value(where, "parts", o.parts, parts_rule) end
  local line = read_line(where, o)
  local positions, direction = read_positions(where, o, line), faces.direction(where, "direction", o.direction)
  local cases = new_cases(o, line, positions, direction)
  local rest = run_with(where, o, with(o.loads, cases[1], 0), "without the force")
  local lines = { positions = positions }
  for name in pairs(rest) do lines[name] = { name = name, x = {}, y = {} } end
  for i, case in ipairs(cases) do
    local values = run_with(where, o, with(o.loads, case, 1), ("with the force at %g m"):format(positions[i]))
    for name, value in pairs(rest) do
      if values[name] == nil then
        check.fail("%s: the function in field 'read' did not return '%s' with the force at %g m", where, name,
          positions[i])
      end
      lines[name].x[i], lines[name].y[i] = positions[i], (values[name] - value) / o.force
    end
  end
  return lines
end

return setmetatable(moving, {
  __call = new,
  __index = function(t, key) check.unknown("hinge.moving_load", "field", key, check.keys(t)) end,
  __name = "hinge.moving_load",
})

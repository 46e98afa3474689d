-- Plots of what a run recorded: the energy balance and probes over time; in statics the load over the displacement.
local core = require "hinge.core"
local check = require "hinge.library.check"
local values = require "hinge.library.values"

local history = {}

local kinds = { m = "displacement", rad = "rotation", ["m/s"] = "velocity", ["rad/s"] = "angular velocity",
  ["m/s^2"] = "acceleration", ["rad/s^2"] = "angular acceleration", N = "reaction", ["N m"] = "moment", J = "energy" }

-- Units in which numbers are shown: from this size on, in the unit itself.
local scales = {
  m = { { 1, 1, "m" }, { 1e-4, 1e3, "mm" }, { 0, 1e6, "µm" } },
  s = { { 0.2, 1, "s" }, { 2e-4, 1e3, "ms" }, { 0, 1e6, "µs" } },
  J = { { 1e9, 1e-9, "GJ" }, { 1e6, 1e-6, "MJ" }, { 1e3, 1e-3, "kJ" }, { 0, 1, "J" } },
  N = { { 1e6, 1e-6, "MN" }, { 1e3, 1e-3, "kN" }, { 0, 1, "N" } },
  ["N m"] = { { 1e6, 1e-6, "MN m" }, { 1e3, 1e-3, "kN m" }, { 0, 1, "N m" } },
  ["m/s^2"] = { { 0, 1, "m/s²" } },
  ["rad/s^2"] = { { 0, 1, "rad/s²" } },
}

local function largest_of(lists)
  local most = 0
  for _, list in ipairs(lists) do
    for _, v in ipairs(list) do
      if math.abs(v) < math.huge then most = math.max(most, math.abs(v)) end
    end
  end
  return most
end

-- Factor and name of the unit in which lists of numbers read best.
local function scale_of(unit, lists)
  local most = largest_of(lists)
  for _, scale in ipairs(scales[unit] or {}) do
    if most >= scale[1] and (most > 0 or scale[2] == 1) then return scale[2], scale[3] end
  end
  return 1, unit
end

local function scaled(list, factor)
  if factor == 1 then return list end
  local result = {}
  for i, v in ipairs(list) do result[i] = factor * v end
  return result
end

local function with_unit(name, unit) return unit == "" and name or name .. ", " .. unit end

-- ---- what there is: { name =, unit =, energy =, x =, y = } ----------------------------------------------------------

-- { curves by name, their names in order, energies drawn unless others are asked for, static =, label = }
local function source_of_run(where, run)
  local rows = core.run_history(run, where)
  local static = run.kind == "static"
  local source = { curves = {}, names = {}, static = static, steps = run.index }
  local part = {}
  for _, name in ipairs(rows.parts) do part[name] = true end
  local function add(curve)
    source.curves[curve.name] = curve
    source.names[#source.names + 1] = curve.name
  end
  for i = 3, #rows.columns do
    local name = rows.columns[i]
    add { name = name, unit = "J", energy = true, part = part[name], x = static and rows.factor or rows.time,
      y = rows[name] }
  end
  for _, probe in ipairs(run.probes) do
    add { name = probe.name, unit = probe.unit, x = probe.time, y = probe.value }
  end
  return source
end

local units_of_default = { u = "m", r = "rad", v = "m/s", a = "m/s^2", f = "N", m = "N m", vr = "rad/s",
  ar = "rad/s^2" }

-- The unit of a column of history.csv by the name that a probe without one gets, node12_uz; "" where it has another.
-- For runs of versions that wrote no probes.json.
local function unit_of(name) return units_of_default[name:match "^node%d+_(%a+)[xyz]$" or ""] or "" end

-- Units of probes by name, as probes.json beside the history has them.
local function units_in(folder)
  local text, units = core.read_text(folder .. "/probes.json"), {}
  local probes = text and core.from_json(text)
  for _, probe in ipairs(type(probes) == "table" and probes or {}) do
    if type(probe) == "table" and type(probe.name) == "string" and kinds[probe.unit] then
      units[probe.name] = probe.unit
    end
  end
  return units
end

local function source_of_folder(where, folder)
  if core.sandboxed() then
    check.fail("%s: what is %s; must be a plot or a run: a script in the sandbox reads no files", where,
      check.show(folder))
  end
  local path = folder .. "/history.csv"
  local file = io.open(path)
  if not file then
    check.fail("%s: there is no %s; give a run, or the folder of one that has ended", where, check.show(path))
  end
  local lines = file:lines()
  local columns, lists = values.csv_fields(lines() or ""), {}
  for i in ipairs(columns) do lists[i] = {} end
  for line in lines do
    for i, field in ipairs(values.csv_fields(line)) do
      if lists[i] then table.insert(lists[i], tonumber(field) or 0 / 0) end
    end
  end
  file:close()
  if columns[1] ~= "time" or columns[2] ~= "factor" then
    check.fail("%s: %s is no history of a run; its first columns are %s", where, check.show(path),
      check.show(table.concat(columns, ",", 1, math.min(2, #columns))))
  end
  local static = largest_of { lists[1] } == 0
  local source = { curves = {}, names = {}, static = static, steps = #lists[1] }
  local energy, units = true, units_in(folder)
  for i = 3, #columns do
    local curve = { name = columns[i], energy = energy,
      unit = energy and "J" or units[columns[i]] or unit_of(columns[i]), x = lists[static and 2 or 1], y = lists[i] }
    source.curves[curve.name] = curve
    source.names[#source.names + 1] = curve.name
    energy = energy and columns[i] ~= "energy_error"
  end
  return source
end

-- ---- what is asked for ----------------------------------------------------------------------------------------------

local rules = {
  title = { "string", optional = true },
  width = { "number", unit = "pixels", whole = true, above = 0, optional = true },
  height = { "number", unit = "pixels", whole = true, above = 0, optional = true },
  columns = { "number", whole = true, above = 0, optional = true },
}

-- A curve by name or probe.
local function curve_of(where, field, source, what)
  local name = what
  if check.kind_of(what) == "probe" then name = what.name end
  local curve = type(name) == "string" and source.curves[name]
  if curve then return curve end
  if type(name) == "string" then check.unknown(where, field, name, source.names) end
  check.fail("%s: %s is %s; must be a probe of the run or one of %s", where, field, check.show(what),
    table.concat(source.names, ", "))
end

-- Accounts of the energy balance that are not zero throughout, then all probes; a static run with probes shows these.
local function usual(source)
  local list, probes = {}, {}
  for _, name in ipairs(source.names) do
    local curve = source.curves[name]
    if not curve.energy then probes[#probes + 1] = curve
    elseif not curve.part and largest_of { curve.y } > 0 then list[#list + 1] = curve end
  end
  if source.static and #probes > 0 then return probes end
  return table.move(probes, 1, #probes, #list + 1, list)
end

local function asked(where, source, what)
  local list, options = {}, {}
  for key, value in pairs(what) do
    if math.type(key) == "integer" and key >= 1 and key <= #what then
      list[key] = curve_of(where, "item " .. key, source, value)
    elseif key ~= "x" then
      if not rules[key] then check.unknown(where, "field", key, { "columns", "height", "title", "width", "x" }) end
      options[key] = value
    end
  end
  options = check.options(where, options, rules)
  if what.x ~= nil then options.over = curve_of(where, "field 'x'", source, what.x) end
  return #list > 0 and list or usual(source), options
end

-- ---- panels ---------------------------------------------------------------------------------------------------------

-- Curves of one unit share a panel, in the order in which the units come; a curve without a unit has its own.
local function by_unit(curves)
  local groups, of = {}, {}
  for _, curve in ipairs(curves) do
    local group = curve.unit ~= "" and of[curve.unit]
    if not group then
      group = {}
      groups[#groups + 1], of[curve.unit] = group, group
    end
    group[#group + 1] = curve
  end
  return groups
end

-- Groups whose curves can be told apart: energies below a fiftieth of the largest one would lie on the axis, and get a
-- panel of their own with its own unit. At most `most_panels` of a group.
local flat, most_panels = 1 / 50, 3
local function apart(groups)
  local list = {}
  for _, group in ipairs(groups) do
    for panel = 1, most_panels do
      local largest, seen, rest = 0, {}, {}
      for _, curve in ipairs(group) do largest = math.max(largest, largest_of { curve.y }) end
      for _, curve in ipairs(group) do
        local low = panel < most_panels and curve.energy and largest_of { curve.y } < flat * largest
        table.insert(low and rest or seen, curve)
      end
      seen.small = panel > 1
      list[#list + 1], group = seen, rest
      if #rest == 0 then break end
    end
  end
  return list
end

local function lists_of(group, field)
  local lists = {}
  for i, curve in ipairs(group) do lists[i] = curve[field] end
  return lists
end

-- One name stands at the axis, several in the legend.
local function label_of(group, unit)
  local one = #group == 1 and not group.small
  return with_unit(one and (group[1].energy and group[1].name .. " energy" or group[1].name)
    or (kinds[group[1].unit] or "") .. (group.small and ", small" or ""), unit)
end

-- The curves of a unit over time, or over the load factor.
local function over_time(source, group, time_factor, x_label)
  local factor, unit = scale_of(group[1].unit, lists_of(group, "y"))
  local series = {}
  for i, curve in ipairs(group) do
    local error = curve.name == "energy_error"
    series[i] = { name = (#group > 1 or group.small) and curve.name or nil, y = scaled(curve.y, factor),
      x = source.static and curve.x or scaled(curve.x, time_factor), dashed = error, colour = error and "black" or nil }
  end
  return { x_label = x_label, y_label = label_of(group, unit), series = series }
end

-- The load factor over the curves of a unit: the load-displacement curve.
local function load_over(group)
  local factor, unit = scale_of(group[1].unit, lists_of(group, "y"))
  local series = {}
  for i, curve in ipairs(group) do
    series[i] = { name = (#group > 1 or group.small) and curve.name or nil, x = scaled(curve.y, factor), y = curve.x }
  end
  return { x_label = label_of(group, unit), y_label = "load factor", series = series }
end

-- The curves of a unit over another curve.
local function over_curve(where, group, other)
  local factor, unit = scale_of(group[1].unit, lists_of(group, "y"))
  local x_factor, x_unit = scale_of(other.unit, { other.y })
  local series = {}
  for i, curve in ipairs(group) do
    if #curve.y ~= #other.y then
      check.fail("%s: field 'x' is '%s' with %d values, and '%s' has %d; energies are plotted over time or load "
        .. "factor, probes over probes", where, other.name, #other.y, curve.name, #curve.y)
    end
    series[i] = { name = #group > 1 and curve.name or nil, x = scaled(other.y, x_factor), y = scaled(curve.y, factor) }
  end
  return { x_label = with_unit(other.name, x_unit), y_label = label_of(group, unit), series = series }
end

--- Whether a plot's first argument is something that was recorded: a run, or the folder of one.
function history.is_source(what) return type(what) == "userdata" or type(what) == "string" end

--- The plot of what a run recorded; `what`: names and probes, x, title, width, height, columns; nil: the usual.
function history.plot(where, run, what)
  local source
  if type(run) == "string" then source = source_of_folder(where, run)
  else
    if core.planning() then return { series = {} } end
    source = source_of_run(where, run)
  end
  if what ~= nil then check.value(where, "choice", what, { "table" }) end
  local curves, options = asked(where, source, what or {})
  local chosen = what ~= nil and #what > 0
  if source.steps == 0 then check.fail("%s: the run has taken no step yet; plot it after run:finish()", where) end
  if #curves == 0 or #curves[1].y == 0 then
    check.fail("%s: nothing was recorded%s", where, #curves > 0 and " of '" .. curves[1].name
      .. "' (record = false keeps no energies)" or "; ask for probes before the first step (run:probe)")
  end
  local time_factor, time_unit = scale_of("s", lists_of(curves, "x"))
  local x_label = source.static and "load factor" or "time, " .. time_unit
  local panels, shared = {}, true
  local groups = by_unit(curves)
  if not chosen and not options.over then groups = apart(groups) end -- what is asked for stays together
  for i, group in ipairs(groups) do
    if options.over then panels[i] = over_curve(where, group, options.over)
    elseif source.static and not group[1].energy then
      panels[i], shared = load_over(group), false
    else panels[i] = over_time(source, group, time_factor, x_label) end
  end
  return { title = options.title, width = options.width, height = options.height, columns = options.columns,
    share_x = shared, panels = panels }
end

return history

-- The plastic hinges and the joints of a run, by storey and member: run:hinges, the text that print gives of them, and
-- hinges.csv.
local core = require "hinge.core"
local check = require "hinge.library.check"
local output = require "hinge.library.output"

local hinges = {}
local levels = { "IO", "LS", "CP" } -- immediate occupancy, life safety, collapse prevention
local is_level = { IO = true, LS = true, CP = true }
local listed = 20 -- hinges that print shows

-- `axis` of what is no rotation, of joints and of connectors: unit and words.
local forces = { tension = { "N", "tension" }, shear = { "N", "shear" } }
for _, axis in ipairs { "x", "y", "z" } do
  forces["force_" .. axis] = { "N", "force along " .. axis }
  forces["moment_" .. axis] = { "N m", "moment about " .. axis }
end

local List = {}
local class = check.class(List, "hinge.hinge_list")

-- Limits --------------------------------------------------------------------------------------------------------------

local function rotation(where, what, value)
  return check.value(where, what, value, { "number", unit = "rad", above = 0 })
end

-- One limit or several levels as a list: { { name =, value = }, ... }, rising.
local function read_levels(where, what, value)
  if type(value) ~= "table" then return { { value = rotation(where, what, value) } } end
  local list = {}
  for name in pairs(value) do
    if not is_level[name] then check.unknown(where, what .. ": level", name, levels) end
  end
  for _, name in ipairs(levels) do
    if value[name] ~= nil then
      list[#list + 1] = { name = name, value = rotation(where, what .. "." .. name, value[name]) }
    end
  end
  if #list == 0 then
    check.fail("%s: field '%s' is an empty table; must be a number in rad, { IO =, LS =, CP = }, or one of these by "
      .. "group", where, what)
  end
  for i = 2, #list do
    if list[i].value <= list[i - 1].value then
      check.fail("%s: field '%s': %s is %s rad, which is not above %s, %s rad", where, what, list[i].name,
        check.show(list[i].value), list[i - 1].name, check.show(list[i - 1].value))
    end
  end
  return list
end

-- A table whose keys are names of groups.
local function limits_by_group(where, run, given)
  local of = {}
  for name, value in pairs(given) do
    if is_level[name] then
      check.fail("%s: field 'limit' has both levels (%s) and groups; give each group its levels", where, name)
    end
    of[name] = read_levels(where, "limit." .. tostring(name), value)
    core.hinges_of(run, where, name) -- refuses what is no group of the model
  end
  local known = {} -- by member
  return function(hinge)
    local index = hinge.member.index
    if known[index] == nil then
      known[index] = false
      for _, group in ipairs(hinge.member:groups()) do
        known[index] = known[index] or of[group.name] or false
      end
    end
    return known[index] or nil
  end
end

-- A function of a hinge: its levels as read_levels has them, or nil.
local function limits(where, run, given)
  if given == nil then return function() end end
  if type(given) == "function" then
    return function(hinge)
      local value = given(hinge)
      return value ~= nil and read_levels(where, "limit(hinge)", value) or nil
    end
  end
  local has_group = false
  if type(given) == "table" then
    for name in pairs(given) do has_group = has_group or type(name) == "string" and not is_level[name] end
  end
  if has_group then return limits_by_group(where, run, given) end
  local all = read_levels(where, "limit", given)
  return function() return all end
end

-- Adds limit, ratio and level to a hinge.
local function compare(hinge, list)
  local last = list[#list]
  hinge.limit, hinge.ratio = last.value, hinge.demand / last.value
  if not last.name then return end
  hinge.level = "beyond " .. last.name
  for i = #list, 1, -1 do
    if hinge.demand <= list[i].value then hinge.level = list[i].name end
  end
end

-- The limits that a joint has of its own: the rotation and the forces at which it breaks. The one that it has come
-- nearest to counts, as one of the script's does.
local function compare_joint(hinge)
  local limit, value = hinge.capacity, hinge.largest
  if forces[hinge.axis] then limit, value = hinge.strength, hinge.largest_force end
  if not limit then return end
  local ratio = value / limit
  if hinge.ratio and not (ratio > hinge.ratio) then return end
  hinge.ratio, hinge.limit = ratio, hinge.capacity
  if hinge.level and not (ratio <= 1) then hinge.level = "beyond capacity" end
end

-- Whether something is beyond its limit. A joint that has broken by a limit of its own is, whatever rounding says.
local function is_beyond(hinge) return hinge.ratio ~= nil and not (hinge.ratio <= 1) or hinge.failed == true end

-- Compares all with their limits, and counts.
local function rate(list, limit_of, limited)
  local worst, over, without = nil, 0, 0
  local function size(hinge) return limited and (hinge.ratio or -1) or hinge.demand end
  for _, hinge in ipairs(list) do
    local own = not forces[hinge.axis] and limit_of(hinge)
    if own then compare(hinge, own) end
    if hinge.joint then compare_joint(hinge) end
    if not hinge.ratio then without = without + 1 end
    if is_beyond(hinge) then over = over + 1 end
    if not worst or not (size(hinge) <= size(worst)) then worst = hinge end
  end
  list.worst = worst
  list.beyond, list.without_limit = limited and over or nil, limited and without or nil
end

-- Whether a joint of the list breaks at some rotation or force.
local function any_own_limit(list)
  for _, hinge in ipairs(list) do
    if hinge.capacity or forces[hinge.axis] then return true end
  end
  return false
end

--- run:hinges { group =, limit = }
local function of_run(run, options, ...)
  local where = "run:hinges"
  check.no_more(where, ...)
  if type(run) ~= "userdata" then check.fail("%s: called on %s; write run:hinges{...}", where, check.show(run)) end
  options = options == nil and {} or options
  if type(options) ~= "table" then
    check.fail("%s: takes a table of options, got %s", where, check.show(options))
  end
  for field in pairs(options) do
    if field ~= "group" and field ~= "limit" then check.unknown(where, "field", field, { "group", "limit" }) end
  end
  local list = core.hinges_of(run, where, options.group)
  rate(list, limits(where, run, options.limit), options.limit ~= nil or any_own_limit(list))
  list.statics = run.kind == "static"
  return setmetatable(list, class)
end

-- As text -------------------------------------------------------------------------------------------------------------

local function place_text(hinge)
  if hinge["end"] ~= 0 and hinge.at == 0 then return "a" end
  if hinge["end"] ~= 0 and hinge.at > 1 - 1e-9 then return "b" end
  return ("%.3g"):format(hinge.at)
end

local function name_of(hinge)
  if hinge.joint then
    return hinge.joint .. ", " .. (forces[hinge.axis] and forces[hinge.axis][2] or "about " .. hinge.axis)
  end
  local group, storey = hinge.group and " (" .. hinge.group .. ")" or "", hinge.storey
  local at = place_text(hinge)
  return ("member %d%s%s, %s"):format(hinge.member.index, group, storey and ", storey " .. storey or "",
    (at == "a" or at == "b") and "end " .. at or "at " .. at .. " of its length")
end

local function first_text(hinge)
  if not hinge.first_yield then return "-" end
  return (hinge.first_kind == "static" and "factor %.4g" or "%.4g s"):format(hinge.first_yield)
    .. (hinge.before and ", before" or "")
end

-- How many plastic hinges, joints and connectors: a joint has a row for each axis and force.
local function counts(list)
  local found, names = { hinge = 0, joint = 0, connector = 0 }, {}
  for _, hinge in ipairs(list) do
    local kind = hinge.connector and "connector" or hinge.joint and "joint" or "hinge"
    if not names[hinge.joint] then found[kind] = found[kind] + 1 end
    if hinge.joint then names[hinge.joint] = true end
  end
  local parts = { check.count(found.hinge, "plastic hinge") }
  for _, kind in ipairs { "joint", "connector" } do
    if found[kind] > 0 then parts[#parts + 1] = check.count(found[kind], kind) end
  end
  return #parts < 3 and table.concat(parts, " and ") or ("%s, %s and %s"):format(table.unpack(parts))
end

local function worst_text(worst)
  if forces[worst.axis] then
    local unit = forces[worst.axis][1]
    return ("%s, %.4g %s, %.3g of its limit %.4g %s"):format(name_of(worst), worst.largest_force, unit, worst.ratio,
      worst.strength, unit)
  end
  local value = worst.limit and worst.limit == worst.capacity and worst.largest or worst.demand
  local text = ("%s, %.4g rad"):format(name_of(worst), value)
  return worst.ratio and text .. (", %.3g of its limit %.4g rad"):format(worst.ratio, worst.limit) or text
end

-- "12 hinges, 3 beyond their limit; the worst: ..."
local function summary(list)
  local text = counts(list)
  if #list == 0 then return text end
  if list.beyond then text = text .. (", %d beyond the limit"):format(list.beyond) end
  if (list.without_limit or 0) > 0 then text = text .. (", %d without a limit"):format(list.without_limit) end
  local worst = list.worst
  text = text .. ("; the %s: %s"):format(list.beyond and "worst" or "largest", worst_text(worst))
  return worst.level and text .. " (" .. worst.level .. ")" or text
end

-- Behind the row of a joint: what it carries.
local function joint_text(hinge)
  if not hinge.joint then return "" end
  local force = forces[hinge.axis]
  local text = force
    and ("  %s, %s: %.4g"):format(hinge.connector and "connector" or "joint", force[2], hinge.force)
    or ("  joint, about %s: %.4g"):format(hinge.axis, hinge.moment)
  return text .. (hinge.strength and (" of %.4g"):format(hinge.strength) or "") .. " " .. (force and force[1] or "N m")
end

function class.__tostring(self)
  local lines = { summary(self) }
  if #self == 0 then return lines[1] end
  local chosen, order = table.move(self, 1, #self, 1, {}), {}
  for i, hinge in ipairs(self) do order[hinge] = i end
  table.sort(chosen, function(a, b)
    local x, y = a.ratio or -1, b.ratio or -1
    if x ~= y then return x > y end
    if a.demand ~= b.demand then return a.demand > b.demand end
    if a.element ~= b.element then return a.element < b.element end
    return a["end"] < b["end"] or a["end"] == b["end"] and order[a] < order[b]
  end)
  local row = "%6s %7s  %-12s %6s %9s %9s %9s %11s %6s  %-20s"
  local head = row:format("storey", "member", "group", "at", "rad now", "largest", "demand", "work, J", "  √f_y",
    "first yield")
  lines[2] = head:gsub(" +$", "") .. (self.beyond and "  of limit" or "")
  for i, h in ipairs(chosen) do
    if i > listed then
      lines[#lines + 1] = ("  and %s more; write() puts all into hinges.csv"):format(check.count(#self - listed,
        "hinge"))
      break
    end
    local text = row:format(h.storey or "-", h.member.index, (h.group or "-"):sub(1, 12), place_text(h),
      ("%.4f"):format(h.rotation), ("%.4f"):format(h.largest), ("%.4f"):format(h.demand),
      ("%.4g"):format(h.work),
      h.utilisation and ("%.3f"):format(h.utilisation) or "-", first_text(h))
    local of_limit = self.beyond and ("  %8s"):format(h.ratio and ("%.3f"):format(h.ratio) or "-")
      .. (h.level and "  " .. h.level or "") or ""
    lines[#lines + 1] = (text .. of_limit .. joint_text(h) .. (h.broken and "  broken" or "")):gsub(" +$", "")
  end
  return table.concat(lines, "\n")
end

-- hinges.csv ----------------------------------------------------------------------------------------------------------

local columns = { "storey", "member", "group", "element", "end", "at", "node", "x", "y", "z", "rotation_x",
  "rotation_y", "rotation", "largest", "demand", "elongation", "work", "f_y", "utilisation", "first_yield",
  "first_kind", "before", "broken", "limit", "ratio", "level", "joint", "axis", "rotation_z", "moment",
  "largest_moment", "force", "largest_force", "stiffness", "strength", "capacity", "yielded", "failed" }

local written = {} -- paths that scripts have written lists to

--- Writes the list into the output folder; the default name is that which the page of hinge report looks for.
function List:write(filename, ...)
  local where = "hinges:write"
  check.no_more(where, ...)
  local path = output.path(output.name(where, filename == nil and "hinges.csv" or filename, "csv"))
  if core.planning() then return self end
  written[path] = true
  core.write_text(path, output.csv(columns, self))
  return self
end

local function is_there(path)
  local file = io.open(path)
  if file then file:close() end
  return file ~= nil
end

--- At the end of a program's run: the hinges of the last run go to hinges.csv, unless the script has written that.
function hinges.leave()
  local path = output.path "hinges.csv"
  if written[path] and is_there(path) then return end
  local run = core.last_run()
  local list = run and of_run(run) or {}
  if #list > 0 then core.write_text(path, output.csv(columns, list)) elseif is_there(path) then os.remove(path) end
end

-- Pictures ------------------------------------------------------------------------------------------------------------

--- Whether a value is what run:hinges gives, with limits to draw.
function hinges.can_be_drawn(value)
  return type(value) == "table" and getmetatable(value) == class and value.beyond ~= nil
end

--- What a picture takes of a list: { { element =, end =, ratio =, joint = }, ... }. Where a hinge and joints are at one
--- end of an element, the one that is nearest to its limit is drawn.
function hinges.marks(list)
  local marks, at = {}, {}
  for _, hinge in ipairs(list) do
    if hinge.ratio then
      local place = 3 * hinge.element + hinge["end"]
      local mark = at[place]
      if not mark then
        mark = { element = hinge.element, ["end"] = hinge["end"], ratio = hinge.ratio, joint = false }
        at[place], marks[#marks + 1] = mark, mark
      end
      if not (hinge.ratio <= mark.ratio) then mark.ratio = hinge.ratio end
      mark.joint = mark.joint or hinge.joint ~= nil
    end
  end
  return marks
end

core.add_run_method("hinges", of_run)

return hinges

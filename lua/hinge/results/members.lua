-- hinge.results.members: the extreme resultants of each member, and where they are.
local check = require "hinge.library.check"
local source = require "hinge.results.source"
local Table = require "hinge.results.table"

local members = {}

-- A resultant counts as none where it is below this part of the largest force or moment of all.
local none = 1e-6
local tie = 1e-9 -- a value is more extreme than another one by this part of it: the first of equal ones keeps its place

local Members = Table.class "hinge.results_members"

--- A row for a member, without values yet.
function members.row(member)
  return { member = member, index = member.index, group = member.group, length = member.length }
end

--- Widens a row by the resultants along its member. `when`: the time or name of the state, nil for none.
function members.widen(row, rows, when)
  for _, name in ipairs(source.names) do
    local low, high = name .. "_min", name .. "_max"
    for _, at in ipairs(rows) do
      local v = at[name]
      if not row[low] or v < row[low] - tie * math.abs(v) then
        row[low], row[low .. "_x"], row[low .. "_when"] = v, at.x, when
      end
      if not row[high] or v > row[high] + tie * math.abs(v) then
        row[high], row[high .. "_x"], row[high .. "_when"] = v, at.x, when
      end
    end
    local side = row[low] and (-row[low] > row[high] and low or high)
    if side then
      row[name], row[name .. "_x"], row[name .. "_when"] = row[side], row[side .. "_x"], row[side .. "_when"]
    end
  end
end

-- The largest force and moment of all rows.
local function sizes(rows)
  local size = { force = 0, moment = 0 }
  for _, row in ipairs(rows) do
    for name, kind in pairs(source.kind) do
      if row[name] then size[kind] = math.max(size[kind], math.abs(row[name])) end
    end
  end
  return size
end

-- A table of its own each time: scripts get it.
local function sort_keys()
  local keys = {}
  for _, name in ipairs(source.names) do keys[name] = true end
  return keys
end

--- The columns of rows: member, group, and two for each resultant. Those that are zero throughout are minor.
function members.columns(rows, with_time)
  local size = sizes(rows)
  local columns = { { key = "index", head = "member", kind = "whole" },
    { key = "group", head = "group", kind = "text" } }
  for _, name in ipairs(source.names) do
    local kind, largest = source.kind[name], 0
    for _, row in ipairs(rows) do largest = math.max(largest, math.abs(row[name] or 0)) end
    for _, side in ipairs { "min", "max" } do
      local key = name .. "_" .. side
      columns[#columns + 1] = { key = key, head = name .. " " .. side, kind = kind, place = key .. "_x",
        when = with_time and key .. "_when" or nil, minor = largest <= none * size[kind] }
    end
  end
  columns[#columns + 1] = Table.remarks(rows)
  return columns
end

members.sort_keys = sort_keys

function Members:all_columns() return members.columns(self.rows) end

--- hinge.results.members(run, { model =, group =, members =, parts =, units = })
function members.of_run(run, options, ...)
  local where = "hinge.results.members"
  check.no_more(where, ...)
  source.must_be_run(where, run)
  local o = source.options(where, options, source.rules, source.free)
  local rows = {}
  for i, member in ipairs(source.members(where, run, o)) do
    local row, along = members.row(member), run:along(member, o.parts)
    members.widen(row, along)
    if run:state(member) == "broken" then row.remark = #along > 0 and "broken in part" or "broken" end
    rows[i] = row
  end
  return Table.new(Members, { rows = rows, units = o.units, sort_keys = sort_keys(), notes = { source.failed(run) } })
end

return members

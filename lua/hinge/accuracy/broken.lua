-- Who broke: members that are broken at the end of all, some or none of several runs.
local check = require "hinge.library.check"
local core = require "hinge.core"
local text = require "hinge.cost.text"

local broken = {}

-- Members that a record's last run has broken, by number, with their first group.
local function of_record(record)
  local last = record.runs[#record.runs]
  local members = {}
  for _, number in ipairs(last and last.broken or {}) do members[number] = (last.groups or {})[number] or "" end
  return members
end

-- Each record once, without runs that failed: they have not come to their end.
local function counted(records)
  local list, seen = {}, {}
  for _, record in ipairs(records) do
    if not seen[record] and not record.failed then list[#list + 1] = record end
    seen[record] = true
  end
  return list
end

--- records: of runs of one structure; those that failed do not count. Returns { runs = how many, members = how many
-- the structure has, list = { { member = number, group =, broken = in how many runs }, ... } by number, in_all =,
-- in_some =, in_none = how many }.
function broken.of(records)
  local counts, groups, members = {}, {}, 0
  records = counted(records)
  for _, record in ipairs(records) do
    local last = record.runs[#record.runs]
    members = math.max(members, last and last.members or 0)
    for number, group in pairs(of_record(record)) do
      counts[number], groups[number] = (counts[number] or 0) + 1, group
    end
  end
  local result = { runs = #records, members = members, list = {}, in_all = 0, in_some = 0 }
  local order = {}
  for number in pairs(counts) do order[#order + 1] = number end
  table.sort(order)
  for _, number in ipairs(order) do
    local all = counts[number] == #records
    result.list[#result.list + 1] = { member = number, group = groups[number], broken = counts[number] }
    if all then result.in_all = result.in_all + 1 else result.in_some = result.in_some + 1 end
  end
  result.in_none = members - #result.list
  return result
end

--- The same as summary.json has it. of_runs: what differs between the runs.
function broken.summary(of, of_runs)
  return { runs = of.runs, of_runs = of_runs, members = of.members, in_all = of.in_all, in_some = of.in_some,
    in_none = of.in_none, list = #of.list > 0 and of.list or nil }
end

--- What a picture with colours by these numbers takes of the summary.json of an output folder: { runs =, members =,
-- count = { [member] = in how many runs it broke, ... } }.
function broken.of_folder(option, folder)
  local summary = core.read_text(folder .. "/summary.json")
  summary = summary and core.from_json(summary)
  local of = type(summary) == "table" and type(summary.accuracy) == "table" and summary.accuracy.broken
  local function whole(value, most) return math.type(value) == "integer" and value >= 1 and value <= most end
  if type(of) ~= "table" or not whole(of.runs, 1e9) or not whole(of.members, 1e9) then
    check.fail("%s: %s/summary.json does not say who broke in several runs; hinge run SCRIPT --within 5%% writes that",
      option, folder)
  end
  local result = { runs = of.runs, members = of.members, count = {} }
  for _, one in ipairs(type(of.list) == "table" and of.list or {}) do
    if whole(one.member, of.members) and whole(one.broken, of.runs) then result.count[one.member] = one.broken end
  end
  if of.runs < 2 or not next(result.count) then
    check.fail("%s: %s", option, of.runs < 2 and "there is one run alone, and nothing to compare it with"
      or ("no member broke in any of the %d runs"):format(of.runs))
  end
  return result
end

--- The same as text of a CSV file.
function broken.csv(of)
  local lines = { "member,group,broken,runs" }
  for _, one in ipairs(of.list) do
    lines[#lines + 1] = text.csv_line { one.member, one.group, one.broken, of.runs }
  end
  return table.concat(lines, "\n") .. "\n"
end

-- "3, 4, 7-9".
local function numbers(list, wanted)
  local parts, at = {}, nil
  for _, one in ipairs(list) do
    if wanted(one) then
      if at and one.member == at.last + 1 then at.last = one.member
      else
        at = { first = one.member, last = one.member }
        parts[#parts + 1] = at
      end
    end
  end
  for i, p in ipairs(parts) do
    parts[i] = p.first == p.last and tostring(p.first)
      or ("%d%s%d"):format(p.first, p.last == p.first + 1 and ", " or "-", p.last)
  end
  if #parts > 12 then return table.concat(parts, ", ", 1, 12) .. ", ..." end
  return table.concat(parts, ", ")
end

--- Lines for people; none where nothing broke.
function broken.lines(of)
  if #of.list == 0 then return {} end
  local lines = {}
  if of.in_all > 0 then
    lines[#lines + 1] = ("%s: %s %s"):format(of.runs == 1 and "broken"
      or ("broken in %d of %d runs"):format(of.runs, of.runs), of.in_all == 1 and "member" or "members",
      numbers(of.list, function(one) return one.broken == of.runs end))
  end
  if of.in_some > 0 then
    lines[#lines + 1] = ("broken in some of %d runs: %s %s (broken.csv)"):format(of.runs,
      of.in_some == 1 and "member" or "members", numbers(of.list, function(one) return one.broken < of.runs end))
  end
  return lines
end

return broken

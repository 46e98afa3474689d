-- Settings that are one and the same run: where a number changes no bit, as dt does where a script's explicit steps
-- find their own length, one setting stands for all values of that number.
local check = require "hinge.library.check"
local compare = require "hinge.cost.compare"
local ladder = require "hinge.cost.ladder"
local words = require "hinge.cost.words"

local alike = {}

--- Whether the runs of two records ended in the same states, to the bit.
function alike.same_states(a, b)
  local same = #a.hashes == #b.hashes
  for i, hash in ipairs(a.hashes) do same = same and hash == b.hashes[i] end
  return same
end

local function same_run(a, b)
  local same = #a.hashes > 0 and alike.same_states(a, b)
  for name, answer in pairs(a.answers) do same = same and compare.error(b.answers[name], answer) == 0 end
  return same
end

-- Lists of the settings that differ in one number alone.
local function families(inputs, input, settings)
  local lists, of = {}, {}
  for _, s in ipairs(settings) do
    local parts = {}
    for i, other in ipairs(inputs) do parts[i] = other == input and "" or ladder.text(s.values[other.name]) end
    local key = table.concat(parts, "\0")
    if not of[key] then
      of[key] = {}
      lists[#lists + 1] = of[key]
    end
    table.insert(of[key], s)
  end
  return lists
end

-- A family that is one run: its first setting stands for it, and the others are added to `dropped`.
local function merge(family, name, dropped)
  local first = family[1]
  for _, s in ipairs(family) do
    if not same_run(first.record, s.record) then return nil end
    if s.place < first.place then first = s end
  end
  first.any = first.any or {}
  first.any[name] = true
  for _, s in ipairs(family) do dropped[s] = s ~= first or dropped[s] end
  return first
end

--- Settings without those that are the run of another one; the others have the names of the numbers that change nothing
--- in `any`. Second, notes that say so.
function alike.merged(inputs, settings)
  local dropped, notes, kept = {}, {}, {}
  for _, input in ipairs(inputs) do
    local methods, found = {}, false
    for _, family in ipairs(input.side and families(inputs, input, settings) or {}) do
      local first = #family > 1 and merge(family, input.name, dropped)
      if first then found, methods[words.method(inputs, first.values)] = true, true end
    end
    methods[""] = nil
    notes[#notes + 1] = found and ("%s changes nothing%s"):format(input.name,
      next(methods) and " with " .. words.list(check.keys(methods)) or "") or nil
  end
  for _, s in ipairs(settings) do
    if not dropped[s] then kept[#kept + 1] = s end
    if s.any then s.label = ladder.label(inputs, alike.values(s)) end
  end
  return kept, notes
end

--- The values of a setting without those that change nothing.
function alike.values(s)
  local values = {}
  for name, value in pairs(s.values) do
    if not (s.any and s.any[name]) then values[name] = value end
  end
  return values
end

return alike

-- The answers that count, and differences of them that do not matter: answers = { "peak_mm", plastic_kJ = 0.1 }.
local check = require "hinge.library.check"
local values = require "hinge.library.values"

local answers = {}
local own_error = "energy_error" -- in the name of a number: a measure of the run, and no answer

--- Refuses what is not of this form; where: what the message names.
function answers.check(where, wanted)
  for key, value in pairs(wanted) do
    if math.type(key) == "integer" and type(value) ~= "string" then
      check.fail("%s: item %d is %s; must be the name of a number that run returns, or of a probe", where, key,
        check.show(value))
    elseif type(key) == "string" and not (type(value) == "number" and value > 0 and value < math.huge) then
      check.fail("%s: %s is %s; must be a difference that does not matter, a number above 0 in the answer's own unit",
        where, key, check.show(value))
    end
  end
end

--- The same from the text of an option: "peak_mm,plastic_kJ:0.1"; nil for nil.
function answers.read(option, text)
  local names = values.names(option, text)
  if not names then return nil end
  local wanted = {}
  for _, word in ipairs(names) do
    local name, least = word:match "^(.-):([^:]*)$"
    if name and not tonumber(least) then
      check.fail("%s %s: %s must be NAME or NAME:DIFFERENCE, such as plastic_kJ:0.1", option, text, word)
    end
    if name then wanted[name] = tonumber(least) else wanted[#wanted + 1] = word end
  end
  answers.check(option .. " " .. text, wanted)
  return wanted
end

--- Names of the answers of a record that count: those that are wanted; else the numbers that the script returns;
--- without these, histories.
function answers.names(where, record, wanted)
  local numbers, histories = {}, {}
  for _, name in ipairs(check.keys(record.answers)) do
    local list = type(record.answers[name]) == "number" and numbers or histories
    if not name:find(own_error) then list[#list + 1] = name end
  end
  if not wanted or next(wanted) == nil then return #numbers > 0 and numbers or histories end
  local names = {}
  for key, value in pairs(wanted) do names[#names + 1] = type(key) == "string" and key or value end
  table.sort(names)
  for _, name in ipairs(names) do
    if record.answers[name] == nil then
      check.unknown(where .. ": answers", "answer", name, check.keys(record.answers))
    end
  end
  return names
end

--- Whether a number is an error itself, which no run makes smaller.
function answers.is_error(name) return name:find(own_error) ~= nil end

--- Differences that do not matter, by name, in the answers' units.
function answers.least(wanted)
  local least = {}
  for key, value in pairs(wanted or {}) do
    if type(key) == "string" then least[key] = value end
  end
  return least
end

return answers

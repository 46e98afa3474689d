-- Tables at the end of a run: the damage of the members, the energy balance, and the wall time by stage.
local check = require "hinge.library.check"

local report = {}
local states = { "elastic", "yielded", "broken", "touched" }

--- Members of each group by state: { group = { members =, elastic =, yielded =, broken =, touched = } }.
-- The first three add up to `members`; `touched` counts those that have been in contact, whatever their state.
function report.damage(run, groups)
  local damage = {}
  for _, group in ipairs(groups) do
    local row = {}
    for _, state in ipairs(states) do row[state] = run:count { group = group, state = state } end
    row.members = row.elastic + row.yielded + row.broken
    damage[group] = row
  end
  return damage
end

local function damage_table(damage, groups)
  local lines = { ("%-16s%9s%9s%9s%11s%12s"):format("", "members", "elastic", "yielded", "fractured", "in contact") }
  for _, group in ipairs(groups) do
    local r = damage[group]
    lines[#lines + 1] = ("%-16s%9d%9d%9d%11d%12d"):format(group, r.members, r.elastic, r.yielded, r.broken, r.touched)
  end
  return table.concat(lines, "\n")
end

-- The accounts of which the balance consists (hinge.energy), without their parts.
local accounts = { "initial", "work", "kinetic", "gravity", "elastic", "plastic", "fracture", "contact", "panels",
  "panel_contact", "ground", "connectors", "joints", "damping", "heat", "numerical", "energy_error" }
local shown_if_any = { heat = true, numerical = true }

local function energy_table(run)
  local energy = run.energy
  local lines = { "energy, kJ" }
  for _, name in ipairs(accounts) do
    local joules = energy[name]
    if joules and (joules ~= 0 or not shown_if_any[name]) then
      local part = name == "energy_error"
        and ("   %.2g %% of the largest energy"):format(100 * run.energy_error) or ""
      lines[#lines + 1] = ("%-16s%14.3f%s"):format(name, joules / 1e3, part)
    end
  end
  return table.concat(lines, "\n")
end

local function seconds_table(stages)
  local total, lines = 0, { "seconds by stage" }
  for _, stage in ipairs(stages) do total = total + stage.seconds end
  for _, stage in ipairs(stages) do
    lines[#lines + 1] = ("%-16s%14.3f%7.1f %%")
      :format(stage.name, stage.seconds, total > 0 and 100 * stage.seconds / total or 0)
  end
  lines[#lines + 1] = ("%-16s%14.3f"):format("together", total)
  return table.concat(lines, "\n")
end

--- Prints the three tables for a list of group names, and returns the first as data.
function report.show(run, groups)
  if run == nil or type(groups) ~= "table" then
    check.fail("report.show: takes a run and a list of group names, got %s and %s", check.show(run), check.show(groups))
  end
  local damage = report.damage(run, groups)
  local head = ("%s at %.6g s"):format(run.verdict, run.time)
  if run.reason and run.reason ~= "" then head = head .. ": " .. run.reason end
  local contacts = ("contacts: %s of elements bound, %d released")
    :format(check.count(run.contacts.bound, "pair"), run.contacts.released)
  local fastest = run.fastest
  if fastest then
    contacts = contacts
      .. ("\nfastest node: %.4g m/s at t = %.4g s (%s)"):format(fastest.speed, fastest.time, fastest.node)
  end
  local parts = { head, damage_table(damage, groups), contacts, energy_table(run), seconds_table(run.stages) }
  print(table.concat(parts, "\n\n"))
  return damage
end

return report

-- Buckling lengths of members: one table for all, one for each group, or a function of the member.
local check = require "hinge.library.check"

local lengths = {}

local factor = { "number", above = 0, optional = true }
local length = { "number", unit = "m", above = 0, optional = true }
-- kx, ky: buckling lengths over the member's own length; Lx, Ly: buckling lengths. x: bending about the section's x.
-- Lb: between lateral supports; C1 (EN 1993-1-1) and Cb (AISC 360): by the shape of the moments between them.
local rules = { kx = factor, ky = factor, Lx = length, Ly = length, Lb = length,
  C1 = { "number", at_least = 1, at_most = 4, default = 1 }, Cb = { "number", at_least = 1, at_most = 3, default = 1 } }

local function is_plain(given)
  for key in pairs(given) do
    if rules[key] then return true end
  end
  return next(given) == nil
end

local function by_group(where, given, member)
  for name, value in pairs(given) do
    if type(name) ~= "string" or type(value) ~= "table" then
      check.fail("%s: has %s = %s; must be { kx =, ky =, Lx =, Ly =, Lb =, C1 =, Cb = }, or such tables by the names "
        .. "of groups", where, tostring(name), check.show(value))
    end
  end
  for _, group in ipairs(member:groups()) do
    if given[group.name] then return given[group.name], ("%s.%s"):format(where, group.name) end
  end
  return {}, where
end

--- The lengths of a member: { Lx =, Ly =, Lb = or nil, C1 =, Cb = }, m.
function lengths.of(where, given, member)
  local at, own = where .. ": field 'lengths'", given or {}
  if type(own) == "function" then
    own = own(member)
    if own == nil then own = {} end
    at = ("%s(member %d)"):format(at, member.index)
  end
  if type(own) ~= "table" then
    check.fail("%s: is %s; must be a table such as { kx = 0.7, ky = 1 }, tables by group, or a function of the member "
      .. "that returns one", at, check.show(own))
  end
  if not is_plain(own) then own, at = by_group(at, own, member) end
  local o = check.options(at, own, rules)
  for _, axis in ipairs { "x", "y" } do
    if o["k" .. axis] and o["L" .. axis] then
      check.fail("%s: fields 'k%s' and 'L%s' are both given; give one of the two", at, axis, axis)
    end
  end
  return { Lx = o.Lx or (o.kx or 1) * member.length, Ly = o.Ly or (o.ky or 1) * member.length, Lb = o.Lb, C1 = o.C1,
    Cb = o.Cb }
end

local function any_lateral(given)
  if type(given) ~= "table" then return type(given) == "function" end
  for key, value in pairs(given) do
    if key == "Lb" or type(value) == "table" and value.Lb then return true end
  end
  return false
end

--- What is to be said about lengths that were not given.
function lengths.remark(given)
  local text = given == nil and "buckling lengths are those of the members; " or ""
  return text .. (any_lateral(given) and "lateral torsional buckling where Lb is given" or "no lateral torsional "
    .. "buckling, since no Lb is given")
end

return lengths

-- The units of a script of OpenSees, which the script does not say: each by its name, checked by its kind.
local check = require "hinge.library.check"
local known = require "hinge.library.units"

local units = {}

local kinds = { length = "m mm cm km inch ft", force = "N kN MN lbf kip kgf tonf", mass = "kg t lb",
  time = "s ms min h", stress = "Pa kPa MPa GPa psi ksi psf", energy = "J kJ MJ", angle = "rad mrad deg" }
local kind_of = {}
for kind, names in pairs(kinds) do
  for name in names:gmatch "%S+" do kind_of[name] = kind end
end

-- Other spellings, which mean one unit.
local spellings = { ["in"] = "inch", inches = "inch", kips = "kip", Kip = "kip", Kips = "kip", KN = "kN", KIP = "kip",
  tonne = "t", sec = "s" }
-- The force that a mass may be meant for.
local force_of = { kg = "kgf", t = "tonf", lb = "lbf" }
local order = { "force", "length", "mass", "time" }

local function names_of(kind) return (kinds[kind]:gsub(" ", ", ")) end

-- The kind of a unit by its name, or an error.
local function kind(where, name)
  local found = kind_of[spellings[name] or name]
  if not found then
    check.fail("%s: unknown unit '%s'; force: %s; length: %s; mass: %s; time: %s", where, name, names_of "force",
      names_of "length", names_of "mass", names_of "time")
  end
  if not (found == "force" or found == "length" or found == "mass" or found == "time") then
    check.fail("%s: '%s' is a unit of %s; give those of force and length, such as kN,m", where, name, found)
  end
  return found
end

-- Why there is no unit of force: one of mass was given in its place.
local function without_force(where, of)
  local mass = spellings[of.mass] or of.mass
  local hint = force_of[mass] and ("'%s' is a mass; as a force it is %s"):format(of.mass, force_of[mass])
    or "a script of OpenSees needs one, such as kN,m"
  check.fail("%s: there is no unit of force: %s", where, hint)
end

--- The units of a text such as "kN,m", "m,kN" or "kip,inch,lb", in any order. Numbers are sizes in SI, in the order
--- force, length, mass, time of those that no name is there for.
function units.of_text(where, text)
  local of, sizes = {}, {}
  where = ("%s is '%s'"):format(where, text)
  for word in text:gmatch "[^,%s]+" do
    local size = tonumber(word)
    local what = not size and kind(where, word)
    if size then
      sizes[#sizes + 1] = size
    elseif of[what] then
      check.fail("%s: '%s' and '%s' are both units of %s", where, of[what], word, what)
    else
      of[what] = word
    end
  end
  for _, what in ipairs(order) do
    if not of[what] and #sizes > 0 then of[what] = table.remove(sizes, 1) end
  end
  if #sizes > 0 then check.fail("%s: these are more units than force, length, mass and time", where) end
  if not of.force then without_force(where, of) end
  if not of.length then check.fail("%s: there is no unit of length, such as m in kN,m", where) end
  return of
end

-- The size of one unit in SI: its name in hinge.units, or a number.
local function size_of(where, what, value)
  if type(value) == "number" and value > 0 and value < math.huge then return value end
  local name = type(value) == "string" and (spellings[value] or value)
  if name and kind_of[name] == what then return known[name] end
  local hint = what == "force" and force_of[name] and (": '%s' is a mass, as a force it is %s"):format(value,
    force_of[name]) or ""
  check.fail("%s: units.%s is %s; must be one of %s, or its size in SI%s", where, what,
    value == nil and "missing" or check.show(value), names_of(what), hint)
end

--- Sizes in SI of a table { length =, force =, mass =, time = } of names and numbers; and the mass that fits them.
function units.sizes(where, given)
  if type(given) ~= "table" then
    check.fail("%s: field 'units' is %s; the file does not say its units: give units = { length = 'm', force = 'kN' }",
      where, given == nil and "missing" or check.show(given))
  end
  for key in pairs(given) do
    if kinds[key] == nil or key == "stress" or key == "energy" or key == "angle" then
      check.unknown(where .. ": units", "field", key, { "force", "length", "mass", "time" })
    end
  end
  local size = { length = size_of(where, "length", given.length), force = size_of(where, "force", given.force) }
  size.time = given.time and size_of(where, "time", given.time) or 1
  local fitting = size.force * size.time ^ 2 / size.length
  size.mass = given.mass and size_of(where, "mass", given.mass) or fitting
  return size, fitting
end

return units

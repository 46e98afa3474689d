-- The units of a table of results: "kN, m, mm" names those of forces, lengths and displacements. Moments have the units
-- of force times length.
local check = require "hinge.library.check"
local si = require "hinge.library.units"

local units = {}

local kind_of = { N = "force", kN = "force", MN = "force", lbf = "force", kip = "force", m = "length", mm = "length",
  cm = "length", km = "length", inch = "length", ft = "length", s = "time", ms = "time", min = "time", h = "time" }
local default = "kN, m, mm"

--- A text such as "kN, m, mm" as factors and names by kind. The first length is that of positions, the second that of
--- displacements.
function units.read(where, text)
  text = text == nil and default or check.value(where, "units", text, { "string" })
  local set = { force = "kN", length = "m", displacement = "mm", time = "s" }
  local seen = {}
  for name in text:gmatch "[^,]+" do
    name = name:match "^%s*(.-)%s*$"
    local kind = kind_of[name]
    if not kind then check.unknown(where .. ": field 'units'", "unit", name, check.keys(kind_of)) end
    if kind == "length" and seen.length then kind = "displacement" end
    if seen[kind] then check.fail("%s: field 'units' is '%s'; it has two units of %s", where, text, kind) end
    set[kind], seen[kind] = name, true
  end
  if not next(seen) then
    check.fail("%s: field 'units' is '%s'; must name units, such as '%s'", where, text, default)
  end
  local function unit(name) return { factor = 1 / si[name], name = name } end
  return { force = unit(set.force), length = unit(set.length), displacement = unit(set.displacement),
    time = unit(set.time), moment = { factor = 1 / (si[set.force] * si[set.length]), name = set.force .. " "
    .. set.length } }
end

return units

-- Load patterns and loads of a text file of ETABS. These are methods of the reader in import/e2k.lua.
local lines = require "hinge.import.etabs.lines"
local notes = require "hinge.import.notes"

local where = "hinge.import.e2k"

local Loads = {}

-- What the masses are made of, and the loads that the program makes by itself.
function Loads:read_mass_source()
  for _, line in ipairs(self:lines("MASS SOURCE", "MASSSOURCE")) do
    local given = lines.pairs_after(line, 3)
    self:row("MASS SOURCE", "MASS SOURCE", line, { Elements = given.INCLUDEELEMENTS, Loads = given.INCLUDELOADS })
  end
  self:lines("MASS SOURCE", "MASSSOURCELOAD")
  for _, word in ipairs { "SEISMIC", "WIND" } do
    for _, line in ipairs(self:lines("LOAD PATTERNS", word)) do
      self:remark(line, "loads of earthquake and wind that the program makes are not read", false, "automatic loads")
    end
  end
end

function Loads:read_patterns()
  for _, from in ipairs { { "LOAD PATTERNS", "LOADPATTERN" }, { "STATIC LOADS", "LOADCASE" } } do
    for _, line in ipairs(self:lines(from[1], from[2])) do
      local given = lines.pairs_after(line, 3)
      self:row("LOAD PATTERN DEFINITIONS", from[1], line, { LoadPat = line.words[2], SelfWtMult = given.SELFWEIGHT })
    end
  end
end

function Loads:read_point_loads()
  local section = "POINT OBJECT LOADS"
  for _, line in ipairs(self:lines(section, "POINTLOAD")) do
    local storey, given = self:storey_of(line, line.words[3]), lines.pairs_after(line, 4)
    if (given.TYPE or ""):upper() ~= "FORCE" then
      self:remark(line, "forces alone are read")
    else
      lines.must_be_numbers(line, given, "FX FY FZ MX MY MZ")
      self:row("JOINT LOADS - FORCE", section, line, { Joint = self:joint(line, line.words[2], storey),
        LoadPat = given.LC, F1 = given.FX, F2 = given.FY, F3 = given.FZ, M1 = given.MX, M2 = given.MY, M3 = given.MZ })
      self:note_keys(line, given, lines.set "TYPE LC FX FY FZ MX MY MZ")
    end
  end
end

local directions = { GRAV = "Gravity", GRAVITY = "Gravity", X = "X", Y = "Y", Z = "Z", ["1"] = "1", ["2"] = "2",
  ["3"] = "3", GRAVPROJ = "Grav Proj", XPROJ = "X Proj", YPROJ = "Y Proj", ZPROJ = "Z Proj" }

function Loads:read_line_load(section, line)
  local storey, given = self:storey_of(line, line.words[3]), lines.pairs_after(line, 4)
  local kind, to = (given.TYPE or ""):upper(), directions[(given.DIR or ""):upper()]
  local frame = tostring(line.words[2]) .. "@" .. storey.name
  if not self.frames[frame] then
    notes.fail(where, line.place, "line %s has no LINEASSIGN on storey %s", tostring(line.words[2]), storey.name)
  end
  local point = kind == "POINTF" or kind == "POINTM"
  if not point and kind ~= "UNIFF" and kind ~= "TRAPF" then
    return self:remark(line, "loads of this TYPE are not read")
  end
  if not to then return self:remark(line, "its direction is not read") end
  lines.must_be_numbers(line, given, "FVAL FSTART FEND RDSTART RDEND RDIST RD")
  if point then
    local at = given.RDIST or given.RD
    if not at then return self:remark(line, "a load at a point without RDIST is not read") end
    local force = kind == "POINTF"
    self:row("FRAME LOADS - POINT", section, line, { Frame = frame, LoadPat = given.LC, Dir = to,
      CoordSys = to:find "^%d$" and "Local" or "GLOBAL", Type = force and "Force" or "Moment",
      [force and "Force" or "Moment"] = given.FVAL, RelDist = at })
    return self:note_keys(line, given, lines.set "TYPE DIR LC FVAL RDIST RD")
  end
  local a, b = given.FVAL or given.FSTART, given.FVAL or given.FEND
  self:row("FRAME LOADS - DISTRIBUTED", section, line, { Frame = frame, LoadPat = given.LC, Dir = to,
    CoordSys = to:find "^%d$" and "Local" or "GLOBAL", FOverLA = a, FOverLB = b, RelDistA = given.RDSTART,
    RelDistB = given.RDEND })
  self:note_keys(line, given, lines.set "TYPE DIR LC FVAL FSTART FEND RDSTART RDEND")
end

function Loads:read_line_loads()
  for _, section in ipairs { "LINE OBJECT LOADS", "FRAME OBJECT LOADS" } do
    for _, line in ipairs(self:lines(section, "LINELOAD")) do self:read_line_load(section, line) end
  end
end

return Loads

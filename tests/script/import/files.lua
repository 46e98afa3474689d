-- Small files of SAP2000 and ETABS that tests of import begin with, and how their notes are compared.
local support = require "support"
local files = {}

--- The tables of a file of SAP2000: a frame from joint 1, which is fixed, to joint 2. `options`: program, units, at =
--- where joint 2 is, name, section = the name and fields of its section, weight = the factor of self weight in the
--- pattern DEAD, more = further tables.
function files.sap(options)
  local o = options or {}
  return ([[
TABLE:  "PROGRAM CONTROL"
   ProgramName=%s   CurrUnits="%s"
TABLE:  "JOINT COORDINATES"
   Joint=1   CoordSys=GLOBAL   CoordType=Cartesian   XorR=0   Y=0   Z=0
   Joint=2   CoordSys=GLOBAL   CoordType=Cartesian   %s
TABLE:  "CONNECTIVITY - FRAME"
   Frame=1   JointI=1   JointJ=2   IsCurved=No
TABLE:  "JOINT RESTRAINT ASSIGNMENTS"
   Joint=1   U1=Yes   U2=Yes   U3=Yes   R1=Yes   R2=Yes   R3=Yes
TABLE:  "MATERIAL PROPERTIES 02 - BASIC MECHANICAL PROPERTIES"
   Material=S   UnitWeight=76.9822025   UnitMass=7.85   E1=210000000   U12=0.3
TABLE:  "FRAME SECTION PROPERTIES 01 - GENERAL"
   SectionName=%s   Material=S   %s
TABLE:  "FRAME SECTION ASSIGNMENTS"
   Frame=1   AnalSect=%s   MatProp=Default
TABLE:  "LOAD PATTERN DEFINITIONS"
   LoadPat=DEAD   DesignType=Dead   SelfWtMult=%s
%s]]):format(o.program or "SAP2000", o.units or "KN, m, C", o.at or "XorR=0   Y=0   Z=3", o.name or "A", o.section
    or "Shape=General   Area=0.01   TorsConst=1e-6   I33=2e-4   I22=5e-5   AS2=0   AS3=0", o.name or "A",
      o.weight or "0", o.more or "")
end
files.sap_head = 17 -- lines before `more`

--- Its pattern DEAD pushes joint 2 by this force along X, kN.
function files.push(force)
  return ('TABLE:  "JOINT LOADS - FORCE"\n   Joint=2   LoadPat=DEAD   CoordSys=GLOBAL   F1=%g   F2=0   F3=0\n')
    :format(force)
end

--- A text file of ETABS: a frame of two storeys of 3 m over points 1 (0, 0) and 2 (4, 0). more: further lines;
--- `options`: units, shape = of the section "A".
function files.etabs(more, options)
  local o = options or {}
  return ([[
$ CONTROLS
  UNITS  %s
$ STORIES - IN SEQUENCE FROM TOP
  STORY "S2"  HEIGHT 3
  STORY "S1"  HEIGHT 3
  STORY "Base"  ELEV 1
$ MATERIAL PROPERTIES
  MATERIAL "S"  TYPE "Steel"  WEIGHTPERVOLUME 76.9822025
  MATERIAL "S"  SYMTYPE "Isotropic"  E 210000000  U 0.3
  MATERIAL "S"  FY 355000  FU 510000
$ FRAME SECTIONS
  FRAMESECTION "A"  MATERIAL "S"  SHAPE %s
$ POINT COORDINATES
  POINT "1"  0 0
  POINT "2"  4 0
  POINT "3"  4 3 0.5
$ LINE CONNECTIVITIES
  LINE "C1"  COLUMN "1" "1" 1
  LINE "B1"  BEAM "1" "2" 0
  LINE "D1"  BRACE "1" "2" 2
  LINE "B2"  BEAM "2" "3" 0
$ LOAD PATTERNS
  LOADPATTERN "DEAD"  TYPE "Dead"  SELFWEIGHT 1
%s]]):format(o.units or '"KN" "M" "C"', o.shape or '"Steel I/Wide Flange"  D 0.4 B 0.2 TF 0.012 TW 0.008', more or "")
end
files.etabs_head = 23 -- lines before `more`

-- Notes ---------------------------------------------------------------------------------------------------------------

--- The entry of a list of notes at a line, or nil.
function files.at_line(list, line)
  for _, entry in ipairs(list) do
    if entry.line == line then return entry end
  end
end

-- The lines of an entry, each once: one, or those of all that are alike.
local function lines_of(entry)
  local lines, seen = {}, {}
  for _, line in ipairs(entry.lines or { entry.line }) do
    if not seen[line] then lines[#lines + 1], seen[line] = line, true end
  end
  return lines, seen
end

--- Checks that each line of `unread` (its number behind `first`) has as many entries in the notes as it has reasons,
--- and that no other line has one.
function files.notes_are(expect, what, notes, first, unread)
  local count, told = 0, 0
  for _, entry in ipairs(notes) do
    local wanted = 0 -- of lines that are alike, one or all are wanted
    for _, line in ipairs(lines_of(entry)) do wanted = wanted + (unread[line - first] and 1 or 0) end
    told = told + (wanted > 0 and wanted or 1)
  end
  for line, reasons in pairs(unread) do
    for _, reason in ipairs(type(reasons) == "table" and reasons or { reasons }) do
      count = count + 1
      local found = false
      for _, entry in ipairs(notes) do
        local _, seen = lines_of(entry)
        found = found or seen[first + line] and entry.text ~= "" and support.has(entry.reason, reason)
      end
      expect(found, "%s, line %d: there is no '%s'", what, first + line, reason)
    end
  end
  expect(told == count, "%s: %d entries, wanted %d:\n%s", what, told, count, tostring(notes))
end

return files

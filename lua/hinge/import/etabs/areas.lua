-- Areas of ETABS as rows of SAP2000's tables: floors and walls on each storey with their corners, thickness and loads,
-- for sap2000/areas.lua. Points of a floor that is a rigid diaphragm are tied.
local check = require "hinge.library.check"
local vectors = require "hinge.library.vectors"

local Areas = {}
Areas.__index = Areas

-- AREA "F1" FLOOR 4 "60" "54" "77" "76" 0 0 0 0: points, and how many storeys below each lies.
function Areas:read_connectivities()
  self.corners = {}
  for _, line in ipairs(self.reader:lines("AREA CONNECTIVITIES", "AREA")) do
    local w, list = line.words, {}
    local count = tonumber(w[4]) or 0
    for i = 1, count do list[i] = { point = w[4 + i], down = tonumber(w[4 + count + i]) or 0 } end
    if w[2] then self.corners[w[2]] = list end
  end
end

-- The corners of an area on a storey, { x, y, z } in lengths of the file; nil where one is not there.
function Areas:points(name, storey)
  local list, reader = {}, self.reader
  for i, corner in ipairs(self.corners[name] or {}) do
    local p, below = reader.point[corner.point], reader.storeys[storey.index + corner.down]
    if not p or not below then return nil end
    list[i] = { p.x, p.y, below.z - p.below }
  end
  return #list >= 3 and list or nil
end

-- Whether a point in plan lies in a polygon or on its edge.
local function is_inside(points, x, y, near)
  local inside = false
  local j = #points
  for i = 1, #points do
    local a, b = points[i], points[j]
    local dx, dy = b[1] - a[1], b[2] - a[2]
    local length = math.sqrt(dx * dx + dy * dy)
    if length > 0 then
      local along = ((x - a[1]) * dx + (y - a[2]) * dy) / length
      local off = math.abs((x - a[1]) * dy - (y - a[2]) * dx) / length
      if off <= near and along >= -near and along <= length + near then return true end
    end
    if (a[2] > y) ~= (b[2] > y) and x < (b[1] - a[1]) * (y - a[2]) / (b[2] - a[2]) + a[1] then inside = not inside end
    j = i
  end
  return inside
end

-- The points of a storey that have lines and lie in a floor.
function Areas:tie(line, storey, points, diaphragm)
  local reader = self.reader
  for _, name in ipairs(check.keys(reader.point)) do
    local p = reader.point[name]
    if p.below == 0 and reader.joints[name .. "@" .. storey.name]
        and is_inside(points, p.x, p.y, 1e-3 / reader.metre) then
      reader:read_diaphragm(line, name, storey, diaphragm)
    end
  end
end

function Areas:read_properties()
  for _, kind in ipairs { "SLAB", "WALL", "DECK", "WALL/SLAB/DECK" } do
    local section = kind .. " PROPERTIES"
    for _, line in ipairs(self.reader:lines(section, "SHELLPROP")) do
      local given = self.reader.pairs_after(line, 3)
      local thickness = given.SLABTHICKNESS or given.WALLTHICKNESS or given.TM or given.T
      local made = self.made[line.words[2]]
      if made then made.M11Mod, made.M22Mod = given.M11MOD or made.M11Mod, given.M22MOD or made.M22Mod end
      if thickness and not self.thick[line.words[2]] and tonumber(thickness) then
        self.thick[line.words[2]] = true
        local fields = { Section = line.words[2], Material = given.MATERIAL, Thickness = thickness,
          M11Mod = given.M11MOD, M22Mod = given.M22MOD }
        self.made[line.words[2]] = fields
        self.reader:row("AREA SECTION PROPERTIES", section, line, fields)
      end
    end
  end
end

function Areas:read_assigns()
  local reader = self.reader
  for _, line in ipairs(reader:lines("AREA ASSIGNS", "AREAASSIGN")) do
    local name, storey, given = line.words[2], reader:storey_of(line, line.words[3]), reader.pairs_after(line, 4)
    local points, key = self:points(name, storey), tostring(name) .. "@" .. storey.name
    local open = (given.SECTION or ""):upper() == "NONE" or (given.OPENING or "NO"):upper() == "YES"
    if points and not open and not self.assigned[key] then
      self.assigned[key] = true
      local corners = {}
      for i, p in ipairs(points) do corners[i] = ("%.17g %.17g %.17g"):format(p[1], p[2], p[3]) end
      reader:row("CONNECTIVITY - AREA", "AREA ASSIGNS", line, { Area = key, AreaArea = tostring(vectors.area(points)),
        Corners = table.concat(corners, ";") })
      reader:row("AREA SECTION ASSIGNMENTS", "AREA ASSIGNS", line, { Area = key, Section = given.SECTION })
    end
    local diaphragm = given.DIAPH or given.DIAPHRAGM
    if points and diaphragm then self:tie(line, storey, points, diaphragm) end
  end
end

function Areas:read_loads()
  local reader = self.reader
  for _, section in ipairs { "SHELL OBJECT LOADS", "AREA OBJECT LOADS" } do
    for _, line in ipairs(reader:lines(section, "AREALOAD")) do
      local given = reader.pairs_after(line, 4)
      if (given.TYPE or ""):upper():find "^UNIF" and tonumber(given.FVAL) then
        reader:row("AREA LOADS - UNIFORM", section, line, { Area = tostring(line.words[2]) .. "@"
          .. tostring(line.words[3]), LoadPat = given.LC, UnifLoad = given.FVAL, Dir = given.DIR or "GRAV" })
      else
        reader:remark(line, "loads of this TYPE on areas are not read")
      end
    end
  end
end

return function(reader)
  local self = setmetatable({ reader = reader, thick = {}, made = {}, assigned = {} }, Areas)
  self:read_connectivities()
  self:read_properties()
  self:read_assigns()
  self:read_loads()
  local found = reader.sections["AREA CONNECTIVITIES"]
  if found and next(self.corners) and not next(self.assigned) then
    reader:remark(found.lines[1], "areas that are assigned to no storey are not read")
  end
end

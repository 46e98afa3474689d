-- Floors and walls of SAP2000 and ETABS. What lies on a horizontal area goes to the members around it, by tributary
-- areas; of the other areas there is one note with their number, size, and loads by pattern. With the option `slabs` of
-- the readers, areas become slabs of the frame (slabs.lua).
local check = require "hinge.library.check"
local frame_module = require "hinge.import.frame"
local notes = require "hinge.import.notes"
local slabs = require "hinge.import.sap2000.slabs"
local strips = require "hinge.model.floor_strips"
local units = require "hinge.library.units"
local vectors = require "hinge.library.vectors"

local near = 1e-3 -- m: heights and places that differ by less are the same

-- Corners as ETABS gives them to these tables, "x y z; x y z", m.
local function corners_in(text, length)
  local points = {}
  for x, y, z in (text or ""):gmatch "([^%s;]+) ([^%s;]+) ([^%s;]+)" do
    points[#points + 1] = vectors.times(length, { tonumber(x), tonumber(y), tonumber(z) })
  end
  return points
end

-- The areas by name and in the order of the file: { name =, points =, size = (m^2), loads = { { pattern =, value = (Pa,
-- down; nil: in another direction or way), size = (Pa) } }, weight = (Pa), row = }.
local function areas_of(reader)
  local list, by_name = {}, {}
  for _, row in ipairs(reader:rows "CONNECTIVITY - AREA") do
    local name = row:text "Area" or "?"
    local area = by_name[name]
    if not area then
      area = { name = name, points = corners_in(row:text "Corners", reader.length), size = 0, loads = {}, weight = 0,
        row = row }
      list[#list + 1], by_name[name] = area, area
    end
    for i = 1, 64 do -- an area of many joints goes on in further rows
      local joint = row:text("Joint" .. i)
      local node = joint and reader.node[joint]
      if node then area.points[#area.points + 1] = vectors.of_node(node) end
    end
    for _, key in ipairs { "NumJoints", "Perimeter", "AreaArea", "GUID", "CentroidX", "CentroidY", "CentroidZ" } do
      row:text(key)
    end
    area.given = area.given or row:text "AreaArea" and row:number "AreaArea" * reader.length ^ 2
  end
  for _, area in ipairs(list) do
    area.size = #area.points >= 3 and vectors.area(area.points) or area.given or 0
  end
  return list, by_name
end

local function is_level(points)
  for _, p in ipairs(points) do
    if math.abs(p[3] - points[1][3]) > near then return false end
  end
  return #points >= 3
end

-- The weight of the areas by their thickness and material.
local function read_weights(reader, by_name)
  local per_area = {}
  for _, row in ipairs(reader:rows "AREA SECTION PROPERTIES") do
    local material = reader.material[row:text "Material" or ""]
    local weight = material and (material.unit_weight or (material.density or 0) * units.gravity) or 0
    per_area[row:need "Section"] = weight * row:number("Thickness", 0) * reader.length * row:number("WMod", 1)
  end
  for _, row in ipairs(reader:rows "AREA SECTION ASSIGNMENTS") do
    local area = by_name[row:text "Area" or ""]
    if area then
      area.section = row:text "Section"
      area.weight = area.weight + (per_area[area.section or ""] or 0)
    end
  end
  for _, row in ipairs(reader.slabs and reader:rows "AREA LOCAL AXES ASSIGNMENTS 1 - TYPICAL" or {}) do
    local area = by_name[row:text "Area" or ""]
    if area and is_level(area.points) then area.angle = row:number("Angle", 0) end
  end
end

local downward = { GRAVITY = 1, GRAV = 1, Z = -1 } -- directions, and which way is down

local function read_loads(reader, by_name)
  for _, name in ipairs { "AREA LOADS - UNIFORM", "AREA LOADS - UNIFORM TO FRAME" } do
    for _, row in ipairs(reader:rows(name)) do
      local area = by_name[row:text "Area" or ""]
      local size = row:number("UnifLoad", 0) * reader.force / reader.length ^ 2
      local sign = downward[(row:text "Dir" or ""):upper()]
      local system, way = (row:text "CoordSys" or "GLOBAL"):upper(), (row:text "DistType" or "Two way"):upper()
      local down = sign and system == "GLOBAL" and way ~= "ONE WAY"
      if area then
        table.insert(area.loads, { pattern = row:text "LoadPat" or row:text "LoadCase" or "?", size = math.abs(size),
          value = down and sign * size or nil })
      end
    end
  end
end

-- What goes to members ------------------------------------------------------------------------------------------------

-- The members in a form that floor_strips takes.
local function members_of(reader)
  local nodes, list = {}, {}
  for i, node in ipairs(reader.frame.nodes) do nodes[node.name] = { index = i, x = node.x, y = node.y, z = node.z } end
  local by_name = frame_module.by_name(reader.frame.nodes)
  for i, row in ipairs(reader.frame.members) do
    local _, length = frame_module.direction(frame_module.ends(row, by_name))
    list[i] = { index = i, name = row.name, a = nodes[row.a], b = nodes[row.b], length = length }
  end
  return list
end

-- Those that lie in the box around an area.
local function members_near(members, points)
  local low, high = { table.unpack(points[1]) }, { table.unpack(points[1]) }
  for _, p in ipairs(points) do
    for i = 1, 3 do low[i], high[i] = math.min(low[i], p[i] - near), math.max(high[i], p[i] + near) end
  end
  local function is_in(n)
    return n.x >= low[1] and n.x <= high[1] and n.y >= low[2] and n.y <= high[2] and n.z >= low[3] and n.z <= high[3]
  end
  local list = {}
  for _, member in ipairs(members) do
    if is_in(member.a) and is_in(member.b) then list[#list + 1] = member end
  end
  return list
end

-- Puts a pressure (Pa, down) on the members that carry an area.
local function put(reader, area, carriers, case, pressure)
  for _, carrier in ipairs(carriers) do
    for _, s in ipairs(carrier) do
      local whole = s.from == 0 and s.to == 1
      local load = { member = carrier.member.name, from = not whole and s.from or nil, to = not whole and s.to or nil,
        q = { a = { 0, 0, -pressure * s.a }, b = { 0, 0, -pressure * s.b } } }
      reader.places[load] = { file = reader.file, line = area.row.place.line, text = area.row.line }
      table.insert(case.loads, load)
    end
  end
end

-- Whether the members around an area have taken all that lies on it.
local function carry(reader, area, members)
  for _, load in ipairs(area.loads) do
    if not load.value or not reader.case[load.pattern] then return false end
  end
  if not is_level(area.points) then return false end
  local good, carriers = pcall(function()
    local plane = strips.plane_of(area.points)
    plane.openings = {}
    return (select(2, strips.of({ plane }, members_near(members, area.points), "two way")))
  end)
  if not good then return false end
  for _, load in ipairs(area.loads) do
    if load.value ~= 0 then put(reader, area, carriers, reader.case[load.pattern], load.value) end
  end
  for _, case in ipairs(reader.frame.cases) do
    local weight = (case.self_weight or 0) * area.weight
    if weight ~= 0 then put(reader, area, carriers, case, weight) end
  end
  return true
end

-- Notes ---------------------------------------------------------------------------------------------------------------

local tables = { "AREA SECTION PROPERTIES", "AREA SECTION PROPERTY", "AREA SECTION ASSIGNMENTS", "AREA LOADS - UNIFORM",
  "AREA AUTO MESH", "AREA STIFFNESS", "AREA LOCAL AXES", "AREA OVERWRITES", "AREA EDGE", "AREA OFFSET",
  "SOLID PROPERTY" }

local function sum_of(list, value)
  local sum = 0
  for _, area in ipairs(list) do sum = sum + value(area) end
  return sum
end

local function size_of(area) return area.size end

-- "12 areas of 180 m^2 in all"
local function count_text(list)
  return ("%s of %.4g m^2 in all"):format(check.count(#list, "area"), sum_of(list, size_of))
end

local function note_lost(reader, list)
  if #list == 0 then return end
  local order, sums, parts = {}, {}, {}
  for _, area in ipairs(list) do
    for _, load in ipairs(area.loads) do
      if not sums[load.pattern] then order[#order + 1] = load.pattern end
      sums[load.pattern] = (sums[load.pattern] or 0) + load.size * area.size
    end
  end
  for i, key in ipairs(order) do parts[i] = ("%s %.4g kN"):format(key, sums[key] / 1e3) end
  local weight = sum_of(list, function(area) return area.weight * area.size end)
  if weight > 0 then parts[#parts + 1] = ("their own weight %.4g kN"):format(weight / 1e3) end
  local what = #parts > 0 and "go the loads " .. table.concat(parts, ", ") or "goes no load"
  notes.add(reader.notes, list[1].row.place, list[1].row.line, ("%s (floors and walls) %s not read; with %s %s"):format(
    count_text(list), #list == 1 and "is" or "are", #list == 1 and "it" or "them", what))
end

--- Adds the loads and the notes, where there are areas; their tables have no note of their own.
return function(reader)
  local list, by_name = areas_of(reader)
  for _, found in ipairs(reader.tables) do
    if notes.begins_with(found.name, tables) and not found.name:find "TO FRAME$" then
      found.read, found.silent = true, true
    end
  end
  if #list == 0 then return end
  read_weights(reader, by_name)
  read_loads(reader, by_name)
  local members, laid, carried, lost = members_of(reader), {}, {}, {}
  if reader.slabs then laid = slabs(reader, list, function(points) return members_near(members, points) end) end
  for _, area in ipairs(list) do
    if not laid[area] then table.insert(carry(reader, area, members) and carried or lost, area) end
  end
  if #carried > 0 then
    local first = carried[1].row
    notes.add(reader.notes.assumed, first.place, first.line, ("%s: loads and weight lie on the members around, two "
      .. "ways by tributary areas; floors have no stiffness and no mass"):format(count_text(carried)))
  end
  note_lost(reader, lost)
end

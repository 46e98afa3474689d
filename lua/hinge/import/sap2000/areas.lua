-- Floors and walls of SAP2000 and ETABS, which are not read: one note with their number, area, and loads by pattern.
local check = require "hinge.library.check"
local notes = require "hinge.import.notes"
local units = require "hinge.library.units"
local vectors = require "hinge.library.vectors"

-- The areas by name, m^2, in the order of the file.
local function areas_of(reader)
  local list, by_name = {}, {}
  for _, row in ipairs(reader:rows "CONNECTIVITY - AREA") do
    local points = {}
    for i = 1, 64 do
      local joint = row:text("Joint" .. i)
      local node = joint and reader.node[joint]
      if node then points[#points + 1] = vectors.of_node(node) end
    end
    for _, key in ipairs { "NumJoints", "Perimeter", "AreaArea", "GUID", "CentroidX", "CentroidY", "CentroidZ" } do
      row:text(key)
    end
    local name = row:text "Area" or "?"
    local given = row:text "AreaArea" and row:number "AreaArea" * reader.length ^ 2
    local size = #points >= 3 and vectors.area(points) or given or 0
    if not by_name[name] then list[#list + 1] = { name = name, size = size, row = row } end
    by_name[name] = (by_name[name] or 0) + size -- an area of many joints goes on in further rows
  end
  return list, by_name
end

-- The weight of the areas by their thickness and material, N.
local function weight_of(reader, by_name)
  local per_area, sum = {}, 0
  for _, row in ipairs(reader:rows "AREA SECTION PROPERTIES") do
    local material = reader.material[row:text "Material" or ""]
    local weight = material and (material.unit_weight or (material.density or 0) * units.gravity) or 0
    per_area[row:need "Section"] = weight * row:number("Thickness", 0) * reader.length * row:number("WMod", 1)
  end
  for _, row in ipairs(reader:rows "AREA SECTION ASSIGNMENTS") do
    sum = sum + (per_area[row:text "Section" or ""] or 0) * (by_name[row:text "Area" or ""] or 0)
  end
  return sum
end

-- Loads on areas by pattern and direction, N; patterns in the order of the file.
local function loads_of(reader, by_name)
  local order, sums = {}, {}
  for _, name in ipairs { "AREA LOADS - UNIFORM", "AREA LOADS - UNIFORM TO FRAME" } do
    for _, row in ipairs(reader:rows(name)) do
      local key = (row:text "LoadPat" or row:text "LoadCase" or "?")
      local load = row:number("UnifLoad", 0) * reader.force / reader.length ^ 2 * (by_name[row:text "Area" or ""] or 0)
      if not sums[key] then order[#order + 1] = key end
      sums[key] = (sums[key] or 0) + math.abs(load)
      for _, field in ipairs { "CoordSys", "Dir", "DistType" } do row:text(field) end
    end
  end
  return order, sums
end

local tables = { "AREA SECTION PROPERTIES", "AREA SECTION PROPERTY", "AREA SECTION ASSIGNMENTS", "AREA LOADS - UNIFORM",
  "AREA AUTO MESH", "AREA STIFFNESS", "AREA LOCAL AXES", "AREA OVERWRITES", "AREA EDGE", "AREA OFFSET",
  "SOLID PROPERTY" }

--- Adds the note, where there are areas; their tables have no note of their own.
return function(reader)
  local list, by_name = areas_of(reader)
  for _, found in ipairs(reader.tables) do
    if notes.begins_with(found.name, tables) and not found.name:find "TO FRAME$" then
      found.read, found.silent = true, true
    end
  end
  if #list == 0 then return end
  local total = 0
  for _, size in pairs(by_name) do total = total + size end
  local order, sums = loads_of(reader, by_name)
  local parts = {}
  for i, key in ipairs(order) do parts[i] = ("%s %.4g kN"):format(key, sums[key] / 1e3) end
  local weight = weight_of(reader, by_name)
  if weight > 0 then parts[#parts + 1] = ("their own weight %.4g kN"):format(weight / 1e3) end
  local what = #parts > 0 and "go the loads " .. table.concat(parts, ", ") or "goes no load"
  notes.add(reader.notes, list[1].row.place, list[1].row.line, ("%s of %.4g m^2 in all (floors and walls) %s not read; "
    .. "with %s %s"):format(check.count(#list, "area"), total, #list == 1 and "is" or "are",
    #list == 1 and "it" or "them", what))
end

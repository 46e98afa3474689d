-- Members of SAP2000 whose section varies along them: pieces of equal properties, each with those in its middle.
--
-- A row of FRAME SECTION PROPERTIES 05 - NONPRISMATIC is a segment from StartSect to EndSect: of an absolute length, or
-- of a share of what these leave. E I varies linearly, or its square root (Parabolic) or cube root (Cubic) does; area,
-- shear areas and torsion constant vary linearly.
local frame_module = require "hinge.import.frame"
local notes = require "hinge.import.notes"

local pieces_of_taper = 12 -- the deflection of a cantilever of I from 1 to 8 is right to 0.3 %
local near = 1e-3 -- m, of joints that are one

local nonprismatic = {}

--- The segments of each nonprismatic section of the file, by its name.
function nonprismatic.segments(reader)
  local of = {}
  for _, row in ipairs(reader:rows "FRAME SECTION PROPERTIES 05 - NONPRISMATIC") do
    local name = row:need "SectionName"
    of[name] = of[name] or {}
    for _, key in ipairs { "NumSegments", "SegmentNum" } do row:text(key) end
    table.insert(of[name], { row = row, from = row:need "StartSect", to = row:need "EndSect",
      absolute = (row:text "LengthType" or "Variable"):lower() == "absolute",
      length = row:text "AbsLength" and row:number "AbsLength" * reader.length or nil,
      share = row:number("VarLength", 1),
      Ix = (row:text "EI33Var" or "Linear"):lower(), Iy = (row:text "EI22Var" or "Linear"):lower() })
  end
  return of
end

local powers = { linear = 1, parabolic = 2, cubic = 3 }

local function between(a, b, t, power)
  if not a or not b then return nil end
  local p = 1 / (power or 1)
  return (a ^ p + (b ^ p - a ^ p) * t) ^ (power or 1)
end

-- The section at t (0 to 1) of a segment, with this name.
local function section_at(segment, a, b, t, name)
  local made = { name = name, Ix = between(a.Ix, b.Ix, t, powers[segment.Ix]),
    Iy = between(a.Iy, b.Iy, t, powers[segment.Iy]) }
  for _, field in ipairs { "area", "J", "shear_area_x", "shear_area_y" } do
    made[field] = between(a[field], b[field], t)
  end
  for _, part in ipairs { "plastic", "size" } do
    if a[part] and b[part] then
      made[part] = {}
      for key, value in pairs(a[part]) do made[part][key] = between(value, b[part][key], t) end
      if not next(made[part]) then made[part] = nil end
    end
  end
  if made.size and not (made.size.width and made.size.depth) then made.size = nil end
  return made
end

-- Where the segments begin and end along a member, m; nil where they do not fit.
local function places_of(segments, length)
  local absolute, shares = 0, 0
  for _, s in ipairs(segments) do
    if s.absolute then absolute = absolute + (s.length or 0) else shares = shares + s.share end
  end
  if absolute > length + near or shares == 0 and math.abs(absolute - length) > near then return nil end
  local list, at = {}, 0
  for i, s in ipairs(segments) do
    local own = s.absolute and (s.length or 0) or (length - absolute) * s.share / shares
    list[i] = { from = at, to = math.min(at + own, length) }
    at = at + own
  end
  return list
end

-- The sections that a frame has by now, by name.
local function known(reader)
  local by_name = {}
  for _, s in ipairs(reader.frame.sections) do by_name[s.name] = frame_module.properties(s) end
  return by_name
end

--- The pieces of a member, { from =, to = (m), section = name }, in its direction; nil and the reason where its section
--- cannot be read.
function nonprismatic.pieces(reader, member, length)
  local segments = reader.nonprismatic[member.section]
  local places, sections = places_of(segments, length), known(reader)
  if not places then return nil, "the segments of its section are longer than the frame, or shorter" end
  local list = {}
  for i, s in ipairs(segments) do
    local a, b = sections[s.from], sections[s.to]
    if not a or not b then return nil, ("section %s of its section was not read"):format(a and s.to or s.from) end
    local count = s.from == s.to and 1 or pieces_of_taper
    local p = places[i]
    for k = 1, p.to - p.from > near and count or 0 do
      local name = count == 1 and s.from or ("%s %d.%d"):format(member.section, i, k)
      if count > 1 and not sections[name] then
        sections[name] = section_at(s, a, b, (k - 0.5) / count, name)
        table.insert(reader.frame.sections, sections[name])
      end
      list[#list + 1] = { from = p.from + (p.to - p.from) * (k - 1) / count, to = p.from + (p.to - p.from) * k / count,
        section = name }
    end
  end
  return list
end

--- Adds the nodes between the pieces of a member; returns the names of all nodes on it and of joints (names), in order,
--- and a function that gives the section at a distance from its first node, m.
function nonprismatic.cut(reader, member, pieces, names)
  local a, b = reader.node[member.a], reader.node[member.b]
  local d, length = frame_module.direction(a, b)
  local list = {}
  for i, name in ipairs(names) do
    local _, along = frame_module.direction(a, reader.node[name])
    list[i] = { name = name, along = along }
  end
  for _, piece in ipairs(pieces) do
    local there = piece.to > length - near
    for _, other in ipairs(list) do there = there or math.abs(other.along - piece.to) <= near end
    if not there then
      local node = { name = ("%s at %.6g m"):format(member.name, piece.to), x = a.x + piece.to * d[1],
        y = a.y + piece.to * d[2], z = a.z + piece.to * d[3], fix = reader:inactive_fix() }
      table.insert(reader.frame.nodes, node)
      reader.node[node.name], reader.places[node] = node, reader.places[member]
      list[#list + 1] = { name = node.name, along = piece.to }
    end
  end
  table.sort(list, function(p, q) return p.along < q.along end)
  local all = {}
  for i, n in ipairs(list) do all[i] = n.name end
  local place = reader.places[member]
  notes.once(reader.notes.assumed, place, place.text, ("its section varies along it: %d pieces of equal "
    .. "properties"):format(#pieces), "nonprismatic")
  return all, function(along)
    for _, piece in ipairs(pieces) do
      if along < piece.to then return piece.section end
    end
    return pieces[#pieces].section
  end
end

return nonprismatic

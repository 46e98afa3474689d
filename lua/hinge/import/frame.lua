-- The description of a frame that the readers give and that import.build and import.write take: a plain table, in SI.
-- This module checks it and sums it up. Rows:
--
-- frame.nodes      { name =, x =, y =, z =, fix = }
-- frame.materials  { name =, E =, G = or nu =, density =, yield_stress =, unit_weight = }
-- frame.sections   { name =, named = } or { name =, and what hinge.section.general takes }
-- frame.members    { name =, a =, b =, section =, material =, up =, group =, release = { a =, b = },
--                    offset = { a =, b = }, elements = }
-- frame.cases      { name =, self_weight =, loads = { { node = or member =, and what case:load takes } } }
-- frame.masses     { node =, mass =, inertia =, offset =, weight = (N: what of it is in the file's self weight) }
-- and those of ties.lua: links, diaphragms, connectors, joints, motions, damping, model; of slabs.lua: sheets, slabs.
--
-- An offset { x, y, z } (m, in the axes of the frame) leads from a node to the member's end, and is rigid and has no
-- mass: rigid ends, insertion points. The member, its length, loads and releases are those between these ends.
-- A load on a member has q = { x, y, z }, or { a =, b = } where it varies linearly from a value to another one. It is
-- spread from `from` to `to` (0 to 1 of the member's length; without them over all of it), and a and b are its values
-- there.
-- A material may have `hardening`, a member `ends` = { a = { Mx = ... }, b = } as hinge.joint takes them, and a case
-- `history`, points { time, factor } of all its loads, and `held` = true: it acts before the others and while they do.
local check = require "hinge.library.check"
local vectors = require "hinge.library.vectors"
local named = require "hinge.sections.named"
local notes = require "hinge.import.notes"
local slabs = require "hinge.import.slabs"
local ties = require "hinge.import.ties"

local frame_module = {}

local upright = 1e-3 -- part of a member's length: one that is less beside the vertical counts as upright

--- The directions in which a node may be held.
frame_module.letters = { "x", "y", "z", "rx", "ry", "rz" }

--- Those in a plane, by the axis across it.
frame_module.in_plane = { x = { "y", "z", "rx" }, y = { "x", "z", "ry" }, z = { "x", "y", "rz" } }

--- What a node is held in, as a row has it, of a set of letters; nil: nothing.
function frame_module.fix_of(set)
  local fixed = {}
  for _, letter in ipairs(frame_module.letters) do
    if set[letter] then fixed[#fixed + 1] = letter end
  end
  return #fixed == 6 and "all" or #fixed > 0 and table.concat(fixed, ",") or nil
end

--- Rows of a list by their names.
function frame_module.by_name(list)
  local found = {}
  for _, row in ipairs(list) do found[row.name] = row end
  return found
end

--- The ends of members at each node, { { member, "a" or "b" }, ... }, by its name.
function frame_module.ends_at(members)
  local ends = {}
  for _, m in ipairs(members) do
    for _, at in ipairs { "a", "b" } do
      ends[m[at]] = ends[m[at]] or {}
      table.insert(ends[m[at]], { m, at })
    end
  end
  return ends
end

--- The two ends of a member, { x =, y =, z = }: its nodes, or where its offsets lead from them. node: all, by name.
function frame_module.ends(member, node)
  local ends = {}
  for i, at in ipairs { "a", "b" } do
    local n, by = node[member[at]], member.offset and member.offset[at]
    ends[i] = by and { x = n.x + by[1], y = n.y + by[2], z = n.z + by[3] } or n
  end
  return ends[1], ends[2]
end

-- Checks --------------------------------------------------------------------------------------------------------------

local text, optional = { "string" }, ties.optional
local metres = { "number", unit = "m" }
local function vector(unit) return optional("numbers", { count = 3, unit = unit }) end
local rules = {
  nodes = { name = text, x = metres, y = metres, z = metres, fix = optional "string" },
  materials = { name = text, E = { "number", unit = "Pa", above = 0 }, nu = optional "number",
    G = optional("number", { unit = "Pa", above = 0 }), yield_stress = optional("number", { unit = "Pa", above = 0 }),
    density = optional("number", { unit = "kg/m^3", at_least = 0 }),
    unit_weight = optional("number", { unit = "N/m^3" }), hardening = optional "table" },
  members = { name = text, a = text, b = text, section = text, material = text, up = vector(),
    group = optional "string", release = optional "table", offset = optional "table", ends = optional "table",
    elements = optional("number", { whole = true, at_least = 1 }) },
  cases = { name = text, self_weight = { "number", default = 0 }, loads = { "table", default = {} },
    history = optional "table", held = optional "boolean" },
  masses = { node = text, mass = { "number", unit = "kg", above = 0 }, inertia = vector "kg m^2", offset = vector "m",
    weight = optional("number", { unit = "N", at_least = 0 }) },
}
for part, rule in pairs(ties.rules) do rules[part] = rule end
for part, rule in pairs(slabs.rules) do rules[part] = rule end
local general = { name = text, named = optional "string" }
for _, field in ipairs { "area", "Ix", "Iy", "J", "shear_area_x", "shear_area_y", "mass_Ix", "mass_Iy", "N0", "Mx0",
  "My0", "Mz0" } do general[field] = optional "number" end
for _, field in ipairs { "plastic", "size", "outline", "reinforcement" } do general[field] = optional "table" end
general.kind, general.interaction = optional "string", optional "string"
rules.sections = general
local part_of_length = optional("number", { at_least = 0, at_most = 1 })
local load_rules = { node = optional "string", member = optional "string", force = vector "N", moment = vector "N m",
  q = optional "table", at = part_of_length, from = part_of_length, to = part_of_length,
  axes = { "string", one_of = { "global", "projected", "local" }, optional = true } }

-- A group is a name or a list of names, which check.options has no kind for.
local function take_group(where, row)
  local group = row.group
  if type(group) ~= "table" then return row, nil end
  local copy = check.copy(row)
  copy.group = nil
  for i, name in ipairs(group) do check.value(where, ("group[%d]"):format(i), name, text) end
  return copy, table.move(group, 1, #group, 1, {})
end

-- The rows of one part of the frame, checked and copied, and by their names.
local function rows_of(where, frame, part)
  local list = frame[part]
  if list == nil then list = {} end
  if type(list) ~= "table" then check.fail("%s: frame.%s is %s; must be a list", where, part, check.show(list)) end
  local rows, by_name = {}, {}
  for i, given in ipairs(list) do
    local here = ("%s: frame.%s[%d]"):format(where, part, i)
    if type(given) ~= "table" then check.fail("%s is %s; must be a table", here, check.show(given)) end
    local row, group = take_group(here, given)
    row = check.options(here, row, rules[part])
    row.group = group or row.group
    rows[i] = row
    if row.name then
      if by_name[row.name] then check.fail("%s: the name '%s' is there twice", here, row.name) end
      by_name[row.name] = row
    end
  end
  return rows, by_name
end

local function known(where, what, name, by_name)
  if not by_name[name] then check.unknown(where, what, name, check.keys(by_name)) end
end

local function check_release(where, release)
  for at, letters in pairs(release) do
    if at ~= "a" and at ~= "b" then check.unknown(where .. ": release", "end", at, { "a", "b" }) end
    local rest = type(letters) == "string" and letters:gsub("r[xyz]", ""):gsub("[%s,]", "")
    if rest ~= "" then
      check.fail("%s: release.%s is %s; must be rotations about the section's axes, such as 'rx,ry': rx and ry are "
        .. "bending about x and y, rz is torsion", where, at, check.show(letters))
    end
  end
end

-- What is given by the two ends of a member, as { a = {x, y, z}, b = {x, y, z} } or one of the two.
local function check_ends(where, field, given, unit)
  for at, value in pairs(given) do
    if at ~= "a" and at ~= "b" then check.unknown(where .. ": " .. field, "end", at, { "a", "b" }) end
    check.value(where, field .. "." .. at, value, vector(unit))
  end
end

local function check_members(where, parts)
  for i, m in ipairs(parts.members) do
    local here = ("%s: frame.members[%d], '%s'"):format(where, i, m.name)
    known(here .. ": field 'a'", "node", m.a, parts.node)
    known(here .. ": field 'b'", "node", m.b, parts.node)
    known(here, "section", m.section, parts.section)
    known(here, "material", m.material, parts.material)
    if m.a == m.b then check.fail("%s: both ends are node '%s'", here, m.a) end
    if m.release then check_release(here, m.release) end
    if m.offset then check_ends(here, "offset", m.offset, "m") end
    local a, b = frame_module.ends(m, parts.node)
    if a.x == b.x and a.y == b.y and a.z == b.z then check.fail("%s: its two ends are at one place", here) end
  end
end

local function check_spread(where, load)
  if load.q then
    if load.q.a or load.q.b then check_ends(where, "q", load.q, "N/m")
    else check.value(where, "q", load.q, vector "N/m") end
  end
  if not load.from and not load.to then return end
  if not load.q then check.fail("%s: 'from' and 'to' are for 'q', N/m", where) end
  if not ((load.from or 0) < (load.to or 1)) then
    check.fail("%s: 'from' is %g and 'to' is %g; the load needs a length between them", where, load.from or 0,
      load.to or 1)
  end
end

local function check_loads(where, parts)
  for i, case in ipairs(parts.cases) do
    for k, given in ipairs(case.loads) do
      local here = ("%s: frame.cases[%d].loads[%d]"):format(where, i, k)
      local load = check.options(here, given, load_rules)
      if (load.node == nil) == (load.member == nil) then
        check.fail("%s: give either 'node' or 'member'", here)
      end
      if load.node then known(here, "node", load.node, parts.node) end
      if load.member then known(here, "member", load.member, parts.member) end
      check_spread(here, load)
    end
  end
  for i, mass in ipairs(parts.masses) do
    known(("%s: frame.masses[%d]"):format(where, i), "node", mass.node, parts.node)
  end
end

-- A node that no member joins cannot be a part of a run.
local function check_lonely(where, parts)
  local ends = frame_module.ends_at(parts.members)
  for _, node in ipairs(parts.nodes) do
    if not ends[node.name] then
      check.fail("%s: node '%s' belongs to no member; join it, or leave it out", where, node.name)
    end
  end
end

--- The parts of a frame, checked: nodes, materials, sections, members, cases, masses as lists; node, material, section
--- and member by name.
function frame_module.check(where, frame)
  if type(frame) ~= "table" then
    check.fail("%s: the frame is %s; give what a reader such as import.s2k returned", where,
      frame == nil and "missing" or check.show(frame))
  end
  for key in pairs(frame) do
    if not rules[key] and not ties.options[key] and key ~= "source" then
      local all = check.keys(rules)
      table.insert(all, "source")
      check.unknown(where .. ": frame", "field", key, all)
    end
  end
  local parts = { source = frame.source }
  parts.nodes, parts.node = rows_of(where, frame, "nodes")
  parts.materials, parts.material = rows_of(where, frame, "materials")
  parts.sections, parts.section = rows_of(where, frame, "sections")
  parts.members, parts.member = rows_of(where, frame, "members")
  parts.cases = rows_of(where, frame, "cases")
  parts.masses = rows_of(where, frame, "masses")
  for part in pairs(ties.rules) do parts[part] = rows_of(where, frame, part) end
  for part in pairs(slabs.rules) do parts[part] = rows_of(where, frame, part) end
  parts.damping, parts.model = frame.damping, frame.model
  if #parts.members == 0 then check.fail("%s: the frame has no member", where) end
  check_members(where, parts)
  check_loads(where, parts)
  check_lonely(where, parts)
  ties.check(where, parts, known)
  slabs.check(where, parts, known)
  return parts
end

-- Geometry ------------------------------------------------------------------------------------------------------------

--- The direction of a member from end a to end b, and its length, m.
function frame_module.direction(a, b)
  return vectors.unit { b.x - a.x, b.y - a.y, b.z - a.z }
end

--- The section's axes x and y of a member along z. Without `up`, y is as near to upwards as it can be; of an upright
--- member it is the x of space. Nil where `up` is along the member.
function frame_module.axes(z, up)
  up = up or (math.sqrt(z[1] ^ 2 + z[2] ^ 2) > upright and { 0, 0, 1 } or { 1, 0, 0 })
  local along = vectors.dot(up, z)
  local y = { up[1] - along * z[1], up[2] - along * z[2], up[3] - along * z[3] }
  local size = vectors.length(y)
  if not (size > 1e-9 * vectors.length(up)) then return nil end
  y = { y[1] / size, y[2] / size, y[3] / size }
  return vectors.cross(y, z), y
end

-- What a reader begins and ends with ----------------------------------------------------------------------------------

--- A frame without rows.
function frame_module.new(source)
  local frame = { source = source, nodes = {}, materials = {}, sections = {}, members = {}, cases = {}, masses = {} }
  for part in pairs(ties.rules) do frame[part] = {} end
  return frame
end

--- The properties of a row of frame.sections.
function frame_module.properties(section)
  return section.named and named.properties(section.named) or section
end

--- What a frame consists of: counts, the length of all members (m), and masses (kg).
function frame_module.summary(frame)
  local node, material, area = frame_module.by_name(frame.nodes), frame_module.by_name(frame.materials), {}
  for _, s in ipairs(frame.sections) do area[s.name] = frame_module.properties(s).area end
  local s = { nodes = #frame.nodes, members = #frame.members, sections = #frame.sections,
    materials = #frame.materials, cases = #frame.cases, loads = 0, masses = #frame.masses, length = 0,
    mass_of_members = 0, mass_of_nodes = 0 }
  for _, m in ipairs(frame.members) do
    local _, length = frame_module.direction(frame_module.ends(m, node))
    s.length = s.length + length
    s.mass_of_members = s.mass_of_members + length * area[m.section] * (material[m.material].density or 0)
  end
  for _, case in ipairs(frame.cases) do
    s.loads = s.loads + #case.loads + ((case.self_weight or 0) ~= 0 and 1 or 0)
  end
  for _, m in ipairs(frame.masses) do s.mass_of_nodes = s.mass_of_nodes + m.mass end
  if frame.slabs then s.area_of_slabs, s.mass_of_slabs, s.slabs = slabs.sum(frame) end
  return s
end

--- Takes out the nodes that no member joins, with their masses and loads. tell(what, row, name) is called for each row
--- that goes: "node", "mass" or "load", and its node.
function frame_module.drop_lonely(frame, tell)
  local ends = frame_module.ends_at(frame.members)
  local function keep(list, what)
    local kept = {}
    for _, row in ipairs(list) do
      local name = what == "node" and row.name or row.node
      if name == nil or ends[name] then kept[#kept + 1] = row else tell(what, row, name) end
    end
    return kept
  end
  frame.nodes, frame.masses = keep(frame.nodes, "node"), keep(frame.masses, "mass")
  for _, case in ipairs(frame.cases) do case.loads = keep(case.loads, "load") end
end

--- Takes out the nodes that no member joins, with their loads and masses; notes say so. Then the summary.
-- places: where the file has a node, a load or a mass, by its table: { file =, line =, text = }.
function frame_module.finish(frame, list, places)
  frame_module.drop_lonely(frame, function(what, row, name)
    local place = places[row]
    notes.once(list, place, place.text, what == "node" and "no member that was read ends at this node"
      or ("no member that was read ends at its node %s"):format(name), "no member: " .. what)
  end)
  list.summary = frame_module.summary(frame)
  list.summary.file = frame.source
  notes.sort(list)
  return frame, list
end

return frame_module

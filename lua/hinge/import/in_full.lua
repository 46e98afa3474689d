-- A frame in full, as import.build and import.write take it: ends that are released or at an offset become nodes,
-- links and springs, and self weight becomes gravity or loads.
local check = require "hinge.check"
local frame_module = require "hinge.import.frame"

local stiff = 1000 -- what is not released is held by so many times the member's own stiffness

-- Releases ------------------------------------------------------------------------------------------------------------

-- The rotations that are released at an end of a member, as a set; nil: none.
local function released(member, at)
  local letters = member.release and member.release[at] or ""
  local set, any = {}, false
  for letter in letters:gmatch "r[xyz]" do set[letter], any = true, true end
  return any and set or nil
end

-- How many ends are fixed to each node, and which are released there.
local function ends_at_nodes(parts)
  local rigid, free = {}, {}
  for _, m in ipairs(parts.members) do
    for _, at in ipairs { "a", "b" } do
      local name = m[at]
      local set = released(m, at)
      if set then
        free[name] = free[name] or {}
        table.insert(free[name], { member = m, at = at, set = set })
      else
        rigid[name] = (rigid[name] or 0) + 1
      end
    end
  end
  return rigid, free
end

local function fixes_rotations(fix)
  return fix == "all" or fix and fix:find "rx" and fix:find "ry" and fix:find "rz"
end

local function without_rotations(fix)
  local kept = {}
  for letter in (fix == "all" and "xyz" or fix:gsub("r[xyz]", "")):gmatch "[xyz]" do kept[#kept + 1] = letter end
  return table.concat(kept, ",")
end

-- Springs for the rotations of an end that are not released, N m/rad: as stiff as `stiff` times the member.
local function springs_of(parts, member, set, length)
  local m, s = parts.material[member.material], parts.section[member.section]
  local p = frame_module.properties(s)
  local G = m.G or m.E / (2 * (1 + (m.nu or 0.3)))
  local full = { rx = 4 * m.E * p.Ix / length, ry = 4 * m.E * p.Iy / length, rz = G * p.J / length }
  local springs = {}
  for letter, stiffness in pairs(full) do
    if not set[letter] then springs[letter] = stiff * stiffness end
  end
  return next(springs) and springs or nil
end

-- The end of the only member at a support: the support holds no rotation, and springs to the ground do.
local function free_support(parts, joint, spring)
  joint.fix = without_rotations(joint.fix)
  if spring then
    spring.a = joint.name
    table.insert(parts.springs, spring)
  end
end

-- An end at a joint: a node of its own, which follows the joint. dofs: "xyz", or "all" where it is not released.
local function add_own_node(parts, member, at, joint, dofs, spring)
  local name = member.name .. "." .. at
  while parts.node[name] do name = name .. "'" end
  local ends = { frame_module.ends(member, parts.node) }
  local place = ends[at == "a" and 1 or 2]
  parts.node[name] = { name = name, x = place.x, y = place.y, z = place.z }
  table.insert(parts.nodes, parts.node[name])
  table.insert(parts.links, { from = joint.name, to = name, dofs = dofs })
  if spring then
    spring.a, spring.b = joint.name, name
    table.insert(parts.springs, spring)
  end
  return name
end

-- The releases at one joint. rigid: how many ends are fixed to it.
local function release_at(where, parts, joint, ends, rigid)
  if rigid == 0 and (#ends > 1 or not fixes_rotations(joint.fix)) then
    check.fail("%s: all members that end at node '%s' are released there, so that nothing holds its rotation; take "
      .. "out the release of one of them: frame.members[...].release", where, joint.name)
  end
  for _, one in ipairs(ends) do
    local m = one.member
    local z, length = frame_module.direction(frame_module.ends(m, parts.node))
    local x, y = frame_module.axes(z, m.up)
    if not x then check.fail("%s: member '%s': 'up' is along the member", where, m.name) end
    local stiffness = springs_of(parts, m, one.set, length)
    local spring = stiffness and { x = x, y = y, stiffness = stiffness }
    if rigid == 0 and not (m.offset and m.offset[one.at]) then
      free_support(parts, joint, spring)
    else
      one.own = add_own_node(parts, m, one.at, joint, "xyz", spring)
    end
  end
end

-- Ends that are not released, at an offset from their nodes.
local function offset_ends(parts)
  local own = {}
  for _, m in ipairs(parts.members) do
    for _, at in ipairs { "a", "b" } do
      if m.offset and m.offset[at] and not released(m, at) then
        own[#own + 1] = { member = m, at = at, own = add_own_node(parts, m, at, parts.node[m[at]], "all") }
      end
    end
  end
  return own
end

local function expand_ends(where, parts)
  local rigid, free = ends_at_nodes(parts)
  local declared = #parts.nodes -- own nodes are added behind these
  local at_offsets = offset_ends(parts)
  for i = 1, declared do
    local joint = parts.nodes[i]
    if free[joint.name] then release_at(where, parts, joint, free[joint.name], rigid[joint.name] or 0) end
  end
  for _, ends in pairs(free) do
    for _, one in ipairs(ends) do one.member[one.at] = one.own or one.member[one.at] end
  end
  for _, one in ipairs(at_offsets) do one.member[one.at] = one.own end
  for _, m in ipairs(parts.members) do m.release, m.offset = nil, nil end
end

-- Self weight ---------------------------------------------------------------------------------------------------------

local weight_words = "self_weight = 'gravity' (the weight of members and of point masses) or 'loads' (that of members "
  .. "alone, along them, as in the file)"

-- Why the weight by gravity is not that of the file, or nil; then whether it cannot be asked for.
local function not_by_gravity(parts, g)
  local cases = 0
  for _, case in ipairs(parts.cases) do cases = cases + (case.self_weight ~= 0 and 1 or 0) end
  if cases > 1 then return ("%d load cases have self weight, and gravity belongs to one"):format(cases), true end
  local bare = 0
  for _, m in ipairs(parts.masses) do bare = bare + (m.weight and 0 or 1) end
  if bare > 0 then return "the self weight of the file leaves out the point masses, and gravity does not" end
  for _, m in ipairs(parts.members) do
    local material = parts.material[m.material]
    local by_mass = (material.density or 0) * g
    if math.abs((material.unit_weight or by_mass) - by_mass) > 1e-3 * math.abs(by_mass) then
      return ("material '%s' has a weight of %.6g N/m^3, and its density times gravity is %.6g N/m^3"):format(
        material.name, material.unit_weight, by_mass)
    end
  end
end

local function weight_as_loads(parts, case, g)
  for _, m in ipairs(parts.members) do
    local material = parts.material[m.material]
    local area = frame_module.properties(parts.section[m.section]).area
    local weight = (material.unit_weight or (material.density or 0) * g) * area
    table.insert(case.loads, { member = m.name, q = { 0, 0, -case.self_weight * weight } })
  end
end

-- The weight of point masses that is in the file's self weight: that of rigid ends.
local function weight_of_masses(parts, case)
  for _, m in ipairs(parts.masses) do
    if m.weight and m.weight > 0 then
      local weight, o = -case.self_weight * m.weight, m.offset or { 0, 0, 0 }
      table.insert(case.loads, { node = m.node, force = { 0, 0, weight },
        moment = { o[2] * weight, -o[1] * weight, 0 } })
    end
  end
end

local function expand_weight(where, parts, options)
  local any, g = false, options.gravity
  for _, case in ipairs(parts.cases) do any = any or case.self_weight ~= 0 end
  if not any then return end
  local way = options.self_weight
  if way ~= "loads" then
    local reason, never = not_by_gravity(parts, g)
    if way == "either" then
      way, parts.not_by_gravity = reason and "loads" or "gravity", reason
    elseif reason and (never or not way) then
      check.fail("%s: %s; choose %s", where, reason, never and "self_weight = 'loads'" or weight_words)
    end
  end
  for _, case in ipairs(parts.cases) do
    if case.self_weight ~= 0 then
      if way == "loads" then
        weight_as_loads(parts, case, g)
        weight_of_masses(parts, case)
      else case.gravity = -case.self_weight * g end
    end
  end
end

--- The parts of frame_module.check, in which no member has a release or an offset and no case a self weight (but
--- `gravity`, m/s^2 along z; not_by_gravity: why self_weight = "either" took loads), with links = { { from =, to =, dofs = } } and
--- springs = { { a =, b = (nil: the ground), x =, y =, stiffness = } }.
return function(where, frame, options)
  local o = check.options(where, options, {
    model = { "table", default = {} }, self_weight = { "string", one_of = { "gravity", "loads", "either" },
      optional = true },
    gravity = { "number", unit = "m/s^2", above = 0, default = 9.80665 },
    scenario = { "boolean", default = false },
  })
  local parts = frame_module.check(where, frame)
  for _, case in ipairs(parts.cases) do case.loads = table.move(case.loads, 1, #case.loads, 1, {}) end
  parts.ties, parts.options = parts.links, {} -- `links` become those of released ends
  for _, of in ipairs { parts.model or {}, o.model } do
    for key, value in pairs(of) do parts.options[key] = value end
  end
  parts.links, parts.springs, parts.scenario = {}, {}, o.scenario
  expand_ends(where, parts)
  expand_weight(where, parts, o)
  return parts
end

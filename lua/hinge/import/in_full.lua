-- A frame in full, as import.build and import.write take it: releases are those of model:member, and self weight
-- becomes gravity or loads.
local check = require "hinge.library.check"
local frame_module = require "hinge.import.frame"
local slabs = require "hinge.import.slabs"

-- Releases ------------------------------------------------------------------------------------------------------------

local moments = { rx = "Mx", ry = "My", rz = "Mz" }

-- What is released at the ends, as model:member has it.
local function expand_releases(parts)
  for _, m in ipairs(parts.members) do
    local release = {}
    for at, letters in pairs(m.release or {}) do
      local list = {}
      for letter in letters:gmatch "r[xyz]" do list[#list + 1] = moments[letter] end
      release[at] = #list > 0 and list or nil
    end
    m.release = next(release) and release or nil
  end
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
  return slabs.not_by_gravity(parts, g)
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
        slabs.weight_as_loads(parts, case)
      else
        case.gravity = -case.self_weight * g
      end
    end
  end
end

--- The parts of frame_module.check, in which releases are those of model:member and no case has a self weight (but
--- `gravity`, m/s^2 along z). not_by_gravity: why self_weight = "either" took loads.
return function(where, frame, options)
  local o = check.options(where, options, {
    model = { "table", default = {} }, self_weight = { "string", one_of = { "gravity", "loads", "either" },
      optional = true },
    gravity = { "number", unit = "m/s^2", above = 0, default = 9.80665 },
    scenario = { "boolean", default = false },
  })
  local parts = frame_module.check(where, frame)
  for _, case in ipairs(parts.cases) do case.loads = table.move(case.loads, 1, #case.loads, 1, {}) end
  parts.options, parts.scenario = {}, o.scenario
  for _, of in ipairs { parts.model or {}, o.model } do
    for key, value in pairs(of) do parts.options[key] = value end
  end
  expand_releases(parts)
  expand_weight(where, parts, o)
  return parts
end

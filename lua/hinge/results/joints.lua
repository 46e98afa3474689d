-- Joints and connectors in hinge.results.utilisation: what they carry over their own strength.
local core = require "hinge.core"

local joints = {}

local axes = { x = true, y = true, z = true }

-- The larger of two numbers; one that is no number stays.
local function larger(a, b) return a and not (b > a) and b == b and a or b end

local function new_joint(h)
  return { name = h.joint, member = h.member, group = h.group, interaction = h.interaction ~= nil, axes = {},
    x = not h.between_nodes and h.at * h.member.length or nil, forces = {},
    kind = h.connector and "connector" or "joint" }
end

-- Adds an axis or a force of a joint. One that has failed has no force now, so its largest ones count.
local function add(joint, h)
  joint.broken = joint.broken or h.broken
  if axes[h.axis] then
    joint.axes[h.axis] = { moment = h.failed and h.largest_moment or math.abs(h.moment), strength = h.strength,
      rotation = h.failed and h.largest or math.abs(h["rotation_" .. h.axis]), capacity = h.capacity }
  else
    joint.forces[h.axis] = { force = h.failed and h.largest_force or math.max(h.force, 0), strength = h.strength }
  end
end

--- The joints and connectors of a run as they are now, in the order of run:hinges. members: the members that count, by
--- index.
function joints.read(run, where, members)
  local list, of = {}, {}
  for _, h in ipairs(core.hinges_of(run, where, nil, true)) do
    if members[h.member.index] then
      if not of[h.joint] then
        of[h.joint] = new_joint(h)
        list[#list + 1] = of[h.joint]
      end
      add(of[h.joint], h)
    end
  end
  return list
end

--- Takes the joints of another state into the extremes so far: a list that has them by name, too.
function joints.widen(kept, list)
  for _, joint in ipairs(list) do
    local known = kept[joint.name]
    if not known then
      kept[joint.name], kept[#kept + 1] = joint, joint
    else
      known.broken = known.broken or joint.broken
      for axis, now in pairs(joint.axes) do
        local so_far = known.axes[axis]
        so_far.moment, so_far.rotation = larger(so_far.moment, now.moment), larger(so_far.rotation, now.rotation)
      end
      for name, now in pairs(joint.forces) do
        known.forces[name].force = larger(known.forces[name].force, now.force)
      end
    end
  end
end

-- The checks of an axis. Where tension weakens the joint, EN 1993-1-8, 6.2.7.1 (3): the shares add up.
local function check_axis(joint, name, axis, checks)
  local tension = joint.interaction and name ~= "z" and joint.forces.tension
  if axis.strength and tension then
    checks["joint M" .. name .. " + tension"] = axis.moment / axis.strength + tension.force / tension.strength
  elseif axis.strength then
    checks["joint M" .. name] = axis.moment / axis.strength
  end
  if axis.capacity then checks["joint rotation " .. name] = axis.rotation / axis.capacity end
end

--- The checks of a joint, ratios by name, and a remark about axes without a strength, or nil.
function joints.checks(joint)
  local checks, without = {}, {}
  for _, name in ipairs { "x", "y", "z" } do
    local axis = joint.axes[name]
    if axis then check_axis(joint, name, axis, checks) end
    if axis and not axis.strength then without[#without + 1] = name end
  end
  for name, of in pairs(joint.forces) do
    checks[joint.kind .. " " .. name:gsub("_", " ")] = of.force / of.strength
  end
  if #without == 0 then return checks end
  return checks, "no strength about " .. table.concat(without, ", ")
end

return joints

-- Frames with concentrated hinges: members that end at nodes of their own, each of which follows a joint but for its
-- rotation, which a spring of no length ties to it (equalDOF and zeroLength, as rotSpring2D makes them). The spring
-- becomes a joint of hinge at the member's end, and the member ends at the joint.
local constraints = require "hinge.import.opensees.constraints"
local frame_module = require "hinge.import.frame"
local springs = require "hinge.import.opensees.springs"

-- How many rows of ties and springs name each node.
local function count_uses(self)
  local uses = {}
  local function use(name) uses[name] = (uses[name] or 0) + 1 end
  for _, list in ipairs { self.ties, self.springs } do
    for _, row in ipairs(list) do
      for _, name in ipairs(row.nodes or {}) do use(name) end
      for _, name in ipairs { row.a or row.from, row.b or row.to } do use(name) end
    end
  end
  return uses
end

local function rotation_alone(parts)
  return parts.rz and next(parts, next(parts)) == nil
end

-- Whether moments or supports act on a node, which a member's end cannot have.
local function has_own(self, node)
  if node.fixed.x or node.fixed.z or node.fixed.ry then return true end
  local mass = self.mass_of[node.name]
  if mass and mass.inertia then return true end
  for _, case in ipairs(self.frame.cases) do
    for _, l in ipairs(case.loads) do
      if l.node == node.name and l.moment then return true end
    end
  end
end

local next_to_nothing = 1e-9 -- of a member's bending stiffness: such a spring is there for the solver's sake

-- The joint of a spring at the end of a member.
local function joint_of(self, row, m)
  local axis = springs.joint_axis(self, row.parts.rz)
  local EI = frame_module.by_name(self.frame.sections)[m.section].Ix
    * frame_module.by_name(self.frame.materials)[m.material].E
  local _, length = frame_module.direction(self.node[m.a], self.node[m.b])
  if axis.stiffness and not axis.strength and axis.stiffness < next_to_nothing * EI / length then
    return { Mx = "free", My = "rigid", Mz = "rigid" }
  end
  return { Mx = axis, My = "rigid", Mz = "rigid" }
end

-- Whether a node is the end of one member and nothing else, so that it can go: { member, "a" or "b" }. uses: of nodes
-- by ties and springs; ends: of members at nodes.
local function only_end(self, own, joint, uses, ends)
  local at = ends[own.name]
  return uses[own.name] == 2 and at and #at == 1 and not self.bars[at[1][1]] and constraints.same_place(own, joint)
    and not has_own(self, own) and at[1] or nil
end

-- The springs that can be joints at ends: { row =, tie =, own =, joint =, at = }.
local function find_ends(self, uses, ends)
  local found = {}
  for _, row in ipairs(self.springs) do
    local tie = rotation_alone(row.parts) and springs.tied(self, row.a, row.b)
    if tie and not tie.letters.ry then
      local own, joint = self.node[tie.to], self.node[tie.from]
      local at = only_end(self, own, joint, uses, ends)
      if not at then
        own, joint = joint, own
        at = only_end(self, own, joint, uses, ends)
      end
      if at then found[#found + 1] = { row = row, tie = tie, own = own, joint = joint, at = at } end
    end
  end
  return found
end

-- Something at a joint must hold its rotation that is no joint itself: a support, or a member's end.
local function held_at_joint(found, ends)
  local kept = {}
  for _, one in ipairs(found) do
    if one.joint.fixed.ry or ends[one.joint.name] then kept[#kept + 1] = one end
  end
  return kept
end

--- Makes springs of a plane frame joints at the ends of members where they are. Comes before all that asks where
--- members end.
local function finish(self)
  if self.ndm ~= 2 then return end
  local ends, gone, kept = frame_module.ends_at(self.frame.members), {}, {}
  for _, one in ipairs(held_at_joint(find_ends(self, count_uses(self), ends), ends)) do
    local m, at = one.at[1], one.at[2]
    self.place, gone[one.row], one.tie.used = one.row.place, true, true
    m.ends = m.ends or {}
    m.ends[at] = joint_of(self, one.row, m)
    m[at] = one.joint.name
    constraints.move_to(self, one.own, one.joint)
  end
  for _, row in ipairs(self.springs) do
    if not gone[row] then kept[#kept + 1] = row end
  end
  self.springs = kept
end

return { finish = finish }

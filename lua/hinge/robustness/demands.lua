-- Demand over capacity, and the limits of rotation that hinge.robustness holds the factors of UFC 4-023-03 and of GSA's
-- guidelines against (standards/ufc_4_023_03/factors.lua).
local check = require "hinge.library.check"
local geometry = require "hinge.robustness.geometry"
local ufc = require "hinge.standards.ufc_4_023_03.factors"

local demands = {}

-- Limits of rotation ----------------------------------------------------------------------------------------------

-- The largest of levels, which is what run:hinges compares with; a number is itself.
local function largest(value)
  if type(value) ~= "table" then return value end
  return value.CP or value.LS or value.IO
end

local function of_groups(limit, member)
  for _, group in ipairs(member:groups()) do
    if limit[group.name] ~= nil then return largest(limit[group.name]) end
  end
end

-- A hinge at the end of a member that has not yielded, for limits that are functions.
local function sound_hinge(member, node, at)
  return { member = member, group = member.group, element = 1, ["end"] = at + 1, at = at, node = node, x = node.x,
    y = node.y, z = node.z, rotation_x = 0, rotation_y = 0, rotation = 0, largest = 0, demand = 0, elongation = 0,
    work = 0, f_y = 0, utilisation = 0, before = false, broken = false }
end

--- The rotation that a member may have, rad, or nil: `limit` as run:hinges takes it.
function demands.limit_of(limit, member)
  if type(limit) == "function" then
    local a = largest(limit(sound_hinge(member, member.a, 0)))
    local b = largest(limit(sound_hinge(member, member.b, 1)))
    return a and b and math.min(a, b) or a or b
  end
  if type(limit) ~= "table" then return limit end
  return largest(limit) or of_groups(limit, member)
end

-- Sections --------------------------------------------------------------------------------------------------------

local function plastic(given, modulus, stress)
  if given then return given end
  if modulus > 0 and stress < math.huge then return modulus * stress end
end

--- N0, Mx0 and My0 of a member; nil where it never yields.
function demands.capacity(member)
  local s, fy = member.section, member.material.yield_stress
  return plastic(s.N0, s.plastic_area, fy), plastic(s.Mx0, s.Zx, fy), plastic(s.My0, s.Zy, fy)
end

local function is_concrete(member) return member.section.kind == "concrete" end

-- Mp and I of a level member for bending in the vertical plane.
local function upright_bending(member)
  local up = member.up
  local _, Mx, My = demands.capacity(member)
  if math.abs(up[3]) >= 0.7 * math.sqrt(up[1] ^ 2 + up[2] ^ 2 + up[3] ^ 2) then return Mx, member.section.Ix end
  return My, member.section.Iy
end

-- Rotation at yield, ASCE 41: Mp L / (6 E I), with the length from column to column.
local function yield_rotation(member, length)
  local M, I = upright_bending(member)
  return M and M * length / (6 * member.material.E * I)
end

--- Raises an error where the factors of steel are asked for a structure of concrete.
function demands.must_be_steel(where, model, field)
  for _, m in ipairs(model:members()) do
    if is_concrete(m) then
      check.fail("%s: member %d is of concrete; the formulas of the factors are for steel; give field '%s'", where,
        m.index, field)
    end
  end
end

--- The smallest ratio of allowed rotation to rotation at yield of the beams in the bays next to a removal; nil: none
--- of them has both. A joint's own capacity counts where it is smaller; `capacity`: by index of the member.
function demands.smallest_ratio(model, geo, case, limit, capacity)
  local least
  for _, m in ipairs(model:members()) do
    local own = geo.members[m.index]
    local a, b = own.a, own.b
    if own.kind == "beam" and not case.removed[m.index]
      and geometry.is_near(case, (a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2) then
      local allowed, at_yield = demands.limit_of(limit, m), yield_rotation(m, geo.beam_length[m.index])
      if capacity[m.index] then allowed = math.min(allowed or math.huge, capacity[m.index]) end
      if allowed and at_yield then least = math.min(least or math.huge, allowed / at_yield) end
    end
  end
  return least
end

-- Demand over capacity --------------------------------------------------------------------------------------------

local function part(force, capacity) return capacity and math.abs(force) / capacity or 0 end

-- N / N0 and the DCR of one end by the form of AISC 360, H1, with plastic capacities.
local function end_ratio(f, times, N0, Mx0, My0)
  local n = times * part(f.N, N0)
  local m = times * (part(f.Mx, Mx0) + part(f.My, My0))
  return n, n >= 0.2 and n + 8 / 9 * m or n / 2 + m
end

local function larger(found, ratio, member, n)
  if found and found.ratio >= ratio then return found end
  return { ratio = ratio, member = member.index, axial = n }
end

--- The largest DCR of all members from an elastic run: that of actions controlled by deformation (loads times `linear`)
--- and that of columns controlled by force (loads times `force`). `linear` and `force` are lists { run, times }.
function demands.demands(model, geo, case, linear, force)
  local by_deformation, by_force
  for i, m in ipairs(model:members()) do
    local N0, Mx0, My0 = demands.capacity(m)
    if not case.removed[i] and (N0 or Mx0 or My0) then
      local ends, of_force = { linear[1](i) }, { force[1](i) }
      for k = 1, 2 do
        local n, ratio = end_ratio(ends[k], linear[2], N0, Mx0, My0)
        local n_force, ratio_force = end_ratio(of_force[k], force[2], N0, Mx0, My0)
        if geo.members[i].kind == "column" and n_force > ufc.force_controlled then
          by_force = larger(by_force, ratio_force, m, n_force)
        else
          by_deformation = larger(by_deformation, ratio, m, n)
        end
      end
    end
  end
  return by_deformation, by_force
end

return demands

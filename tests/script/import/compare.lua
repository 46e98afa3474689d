-- What import.tcl reads of a script of OpenSees, against the small solver by another route: the commands as tclsh or
-- python3 gives them (record.tcl, record.py), assembled by commands_solver.lua. See import_values_test.lua.
local here = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$"
local by_commands = dofile(here .. "commands_solver.lua")
local compare = {}

local aside = {} -- commands that are no part of a frame's elastic statics
for name in ("algorithm analysis analyze constraints database defaultUnits display eigen eleForce eleResponse fill "
  .. "getTime groundMotion imposedMotion initialize integrator loadConst logFile modalDamping nDMaterial nodeCoord "
  .. "nodeDisp nodeReaction numberer parameter plane port print projection prp puts rayleigh reactions record recorder "
  .. "region setTime system test viewWindow vpn vrp vup wipeAnalysis"):gmatch "%S+" do aside[name] = true end

--- The commands of a script up to its end or to an error: a list of lists of texts.
function compare.record(path)
  local program = path:find "%.py$" and "python3" or "tclsh"
  local quoted = "'" .. path:gsub("'", "'\\''") .. "'"
  local pipe = assert(io.popen(("timeout 60 %s %srecord.%s %s 2>/dev/null"):format(program, here,
    path:match "%a+$", quoted)))
  local list = {}
  for line in pipe:lines() do
    local words = {}
    for word in (line .. "\31"):gmatch "(.-)\31" do words[#words + 1] = word end
    list[#list + 1] = words
  end
  pipe:close()
  return list
end

--- The model of a script in the small solver. other: a set of more names of commands that make no part of it.
function compare.model(path, other)
  return by_commands.read(compare.record(path), other or aside)
end

-- Largest difference of rows of three over the largest number in them, and where.
local function largest_difference(rows)
  local largest, worst, at = 0, 0, "all are zero"
  for _, row in pairs(rows) do
    for i = 1, 3 do
      if not (math.abs(row[1][i]) <= largest) then largest = math.abs(row[1][i]) end
    end
  end
  for name, row in pairs(rows) do
    for i = 1, 3 do
      local difference = math.abs(row[1][i] - row[2][i]) / largest
      if largest > 0 and not (difference <= worst) then
        worst, at = difference, ("node %s, %s: %.7g by the solver, %.7g by hinge"):format(name,
          ("xyz"):sub(i, i), row[1][i], row[2][i])
      end
    end
  end
  return worst, at
end

--- The largest difference of natural frequencies over the solver's, of the lowest `count` at most.
function compare.modes(m, built, count)
  local omega = m:frame():modes(count)
  local run = built[1]:static { steps = 1, loads = next(m.patterns) and {} or nil }:finish()
  local worst, at = 0, ""
  for i, mode in ipairs(run:modes { n = #omega }) do
    local difference = math.abs(2 * math.pi * mode.frequency / omega[i] - 1)
    if not (difference <= worst) then
      worst, at = difference, ("mode %d: %.6g Hz by the solver, %.6g by hinge"):format(i, omega[i] / 2 / math.pi,
        mode.frequency)
    end
  end
  return worst, at
end

--- The largest difference of displacements, over the largest one, and that of the forces of supports, between hinge and
--- the solver, each with its place, for the loads of one pattern. built: { model, nodes } of import.build with small
--- displacements; part: of the load, so that nothing yields.
function compare.pattern(m, built, pattern, part)
  local r = m:frame(pattern):solve()
  local run = built[1]:static { steps = 1, loads = { ["pattern " .. pattern.name] = part } }:finish()
  local ways, forces = {}, {}
  local function in_hinge(v) return m.dim == 2 and { v.x or 0, 0, v.y or 0 } or { v.x or 0, v.y or 0, v.z or 0 } end
  local function scaled(x, y, z) return { x / part, y / part, z / part } end
  for name, u in pairs(r.u) do
    local node = built[2][name]
    if node then
      ways[name] = { in_hinge(u), scaled(node:displacement(run)) }
      if next(r.reaction[name]) then forces[name] = { in_hinge(r.reaction[name]), scaled(node:reaction(run)) } end
    end
  end
  local by_way, where = largest_difference(ways)
  local by_force, at = largest_difference(forces)
  return by_way, where, by_force, at
end

return compare

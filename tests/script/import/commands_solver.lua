-- Commands of OpenSees, as a list of { name, argument, ... } of texts, in the small solver (solver.lua): the second
-- route for what import.tcl reads. Elastic, with the stiffness that materials and sections begin with; loads at the
-- factor that their series has at time 1. Nothing of hinge is used. A command or element that is not here is an error,
-- so that nothing is compared that was not built.
local here = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$"
local solver = dofile(here .. "solver.lua")

local part = dofile(here .. "commands_sections.lua")
local numbers, option, after, positional, key = part.numbers, part.option, part.after, part.positional, part.key
local unknown, section_of, stiffness_of = part.unknown, part.section_of, part.stiffness_of
local Model, commands, elements = {}, part.commands, {}
Model.__index = Model

-- Degrees of freedom by dimensions and number.
local letters = { [2] = { [2] = { "x", "y" }, [3] = { "x", "y", "rz" } },
  [3] = { [3] = { "x", "y", "z" }, [6] = { "x", "y", "z", "rx", "ry", "rz" } } }
local all_letters = letters[3][6]

-- Nodes and what ties them --------------------------------------------------------------------------------------------

function commands.model(m, args)
  local d, f = after(args, "-ndm"), after(args, "-ndf")
  m.dim = math.tointeger(d[1])
  local ndf = f and math.tointeger(f[1]) or m.dim == 2 and 3 or 6
  m.freedoms = letters[m.dim][ndf]
  if not m.freedoms then unknown("-ndf %d", ndf) end
end

function commands.wipe(m) m:clear() end

-- Adds something that is done to the frame when it is built.
local function later(m, f) table.insert(m.steps, f) end

function commands.node(m, args)
  local at = numbers(args, 2)
  m.at[key(args[1])], m.of_node[key(args[1])] = at, m.freedoms
  later(m, function(s) s:node(key(args[1]), at[1], at[2], at[3]) end)
  local mass = after(args, "-mass")
  if mass then commands.mass(m, { args[1], table.unpack(mass) }) end
end

function commands.fix(m, args)
  local which = {}
  for i, letter in ipairs(m.of_node[key(args[1])]) do
    if tonumber(args[1 + i]) ~= 0 then which[#which + 1] = letter end
  end
  later(m, function(s) s:fix(key(args[1]), table.concat(which, " ")) end)
end

for axis, letter in ipairs { "X", "Y", "Z" } do
  commands["fix" .. letter] = function(m, args)
    local within = (after(args, "-tol") or { 1e-10 })[1]
    for name, at in pairs(m.at) do
      if math.abs(at[axis] - tonumber(args[1])) <= within then
        commands.fix(m, { name, table.unpack(args, 2, 1 + #m.of_node[name]) })
      end
    end
  end
end

local function values(m, args, from)
  local list = {}
  for i, letter in ipairs(m.of_node[key(args[1])]) do list[letter] = tonumber(args[from + i - 1]) or 0 end
  return list
end

function commands.mass(m, args)
  local mass = values(m, args, 2)
  later(m, function(s) s:mass(key(args[1]), mass) end)
end

function commands.equalDOF(m, args)
  local which = {}
  for i = 3, #args do which[#which + 1] = m.of_node[key(args[1])][tonumber(args[i])] end
  later(m, function(s) s:equal(key(args[1]), key(args[2]), table.concat(which, " ")) end)
end

local floors = { "y z rx", "x z ry", "x y rz" }
function commands.rigidDiaphragm(m, args)
  for i = 3, #args do
    later(m, function(s) s:rigid(key(args[2]), key(args[i]), floors[tonumber(args[1])]) end)
  end
end

function commands.rigidLink(m, args)
  later(m, function(s)
    if args[1] == "bar" or args[1] == "rod" then return s:equal(key(args[2]), key(args[3]), "x y z") end
    s:rigid(key(args[2]), key(args[3]), "x y z rx ry rz")
  end)
end

-- Elements ------------------------------------------------------------------------------------------------------------

function commands.geomTransf(m, args)
  local t = { kind = args[1] }
  if m.dim == 3 then t.vecxz = numbers(args, 3) end
  local arms = after(args, "-jntOffset")
  if arms then
    t.arm_i, t.arm_j = { table.unpack(arms, 1, m.dim) }, { table.unpack(arms, m.dim + 1, 2 * m.dim) }
    if m.dim == 2 then t.arm_i[3], t.arm_j[3] = 0, 0 end
  end
  m.transf[key(args[2])] = t
end

local function beam(m, args, p, transf)
  local t = m.transf[key(transf)]
  if not t then unknown("transformation %s is not there", transf) end
  p[1], p[2], p[3] = key(args[1]), key(args[2]), key(args[3])
  p.vecxz, p.arm_i, p.arm_j = t.vecxz, t.arm_i, t.arm_j
  local mass = after(args, "-mass")
  p.mass, p.consistent = mass and mass[1], option(args, "-cMass") ~= nil
  for name, letter in pairs { ["-release"] = "rz", ["-releasez"] = "rz", ["-releasey"] = "ry" } do
    local code = after(args, name)
    code = code and code[1] or 0
    if code == 1 or code == 3 then p.release_i = (p.release_i or "") .. " " .. letter end
    if code == 2 or code == 3 then p.release_j = (p.release_j or "") .. " " .. letter end
  end
  later(m, function(s) s:beam(p) end)
end

-- A section's stiffness as that of a beam of E = G = 1.
local function of_section(m, name, shear)
  local s = section_of(m, name)
  return { E = 1, G = 1, A = s.EA, Iz = s.EIz, Iy = s.EIy or 0, J = s.GJ, Avy = shear and s.GAy or nil,
    Avz = shear and s.GAz or nil }
end

function elements.elasticBeamColumn(m, args)
  local n = positional(args)
  local v = numbers(args, 4)
  if n == 5 then return beam(m, args, of_section(m, args[4], false), args[5]) end
  if m.dim == 2 then return beam(m, args, { A = v[1], E = v[2], Iz = v[3] }, args[n]) end
  beam(m, args, { A = v[1], E = v[2], G = v[3], J = v[4], Iy = v[5], Iz = v[6] }, args[n])
end

function elements.ElasticTimoshenkoBeam(m, args)
  local v, n = numbers(args, 4), positional(args)
  if m.dim == 2 then return beam(m, args, { E = v[1], G = v[2], A = v[3], Iz = v[4], Avy = v[5] }, args[n]) end
  beam(m, args, { E = v[1], G = v[2], A = v[3], J = v[4], Iy = v[5], Iz = v[6], Avy = v[7], Avz = v[8] }, args[n])
end

-- tag i j points section transf | tag i j transf integration | tag i j transf Lobatto section points
local function with_points(shear)
  return function(m, args)
    local words = {}
    for i = 1, positional(args) do
      for word in args[i]:gmatch "%S+" do words[#words + 1] = word end
    end
    local section, transf = words[5], words[4]
    if words[6] and tonumber(words[5]) then
      transf = words[6]
    elseif words[6] then
      section = words[6]
    else
      local known = m.integration[key(words[5])]
      if not known then unknown("integration %s is not there", words[5]) end
      section = known[3]
      if known[1]:find "Hinge" then unknown("integration %s", known[1]) end
    end
    if words[5] and words[5]:find "Hinge" then unknown("integration %s", words[5]) end
    beam(m, args, of_section(m, section, shear), transf)
  end
end
elements.forceBeamColumn, elements.nonlinearBeamColumn = with_points(true), with_points(true)
elements.dispBeamColumn = with_points(false)

function commands.beamIntegration(m, args) m.integration[key(args[2])] = args end

local function truss(m, args)
  local p = { key(args[1]), key(args[2]), key(args[3]), E = 1 }
  if positional(args) == 4 then
    p.A = section_of(m, args[4]).EA
  else
    p.A = tonumber(args[4]) * stiffness_of(m, args[5])
  end
  local mass = after(args, "-rho")
  p.mass = mass and mass[1]
  later(m, function(s) s:beam(p) end)
end
for _, name in ipairs { "truss", "Truss", "corotTruss", "CorotTruss" } do elements[name] = truss end

local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end
local function unit(a)
  local size = math.sqrt(a[1] ^ 2 + a[2] ^ 2 + a[3] ^ 2)
  return size > 0 and { a[1] / size, a[2] / size, a[3] / size } or nil
end
local function axes_of(x, yp)
  x = unit(x)
  local z = unit(cross(x, yp))
  return { x, cross(z, x), z }
end

-- The stiffness along local axes of -mat and -dir, x to rz.
local function along(m, args, p)
  local mats, dirs = after(args, "-mat"), after(args, "-dir", "-doRayleigh")
  for i, dir in ipairs(dirs) do
    if m.dim == 2 and dir == 3 then dir = 6 end
    local letter = all_letters[math.tointeger(dir)]
    p[letter] = (p[letter] or 0) + stiffness_of(m, mats[i])
  end
  return p
end

function elements.zeroLength(m, args)
  local o = after(args, "-orient")
  local p = along(m, args, { key(args[1]), key(args[2]), key(args[3]) })
  p.axes = axes_of(o and { o[1], o[2], o[3] } or { 1, 0, 0 }, o and o[4] and { o[4], o[5], o[6] } or { 0, 1, 0 })
  later(m, function(s) s:spring(p) end)
end

function elements.twoNodeLink(m, args)
  local a, b = m.at[key(args[2])], m.at[key(args[3])]
  local d = { b[1] - a[1], b[2] - a[2], (b[3] or 0) - (a[3] or 0) }
  local o, share = after(args, "-orient") or {}, (after(args, "-shearDist") or { 0.5 })[1]
  if option(args, "-pDelta") then unknown "-pDelta" end
  local x, yp = d, { o[1], o[2], o[3] }
  if #o == 6 then x, yp = { o[1], o[2], o[3] }, { o[4], o[5], o[6] } end
  if #yp < 3 then yp = { -x[2], x[1], 0 } end
  local p = along(m, args, { key(args[1]), key(args[2]), key(args[3]), axes = axes_of(x, yp) })
  p.arm_i = { share * d[1], share * d[2], share * d[3] }
  p.arm_j = { p.arm_i[1] - d[1], p.arm_i[2] - d[2], p.arm_i[3] - d[3] }
  later(m, function(s) s:spring(p) end)
end

function commands.element(m, args)
  local kind = args[1]
  if not elements[kind] then unknown("element %s", kind) end
  elements[kind](m, { table.unpack(args, 2) })
end

-- Loads ---------------------------------------------------------------------------------------------------------------

local function factor_of(args, from)
  local f = after(args, "-factor", "-fact")
  if args[from] ~= "Linear" and args[from] ~= "Constant" then unknown("series %s", tostring(args[from])) end
  return f and f[1] or 1
end

function commands.timeSeries(m, args)
  local good, factor = pcall(factor_of, args, 1)
  m.series[key(args[2])] = good and factor or false
end

function commands.pattern(m, args)
  local name = key(args[2])
  if args[1] ~= "Plain" then
    m.current = nil
    return
  end
  local factor
  if tonumber(args[3]) then
    local f = after(args, "-fact", "-factor")
    factor = m.series[key(args[3])] and m.series[key(args[3])] * (f and f[1] or 1)
  else
    local good, f = pcall(factor_of, args, 3)
    factor = good and f
  end
  m.current = { name = name, factor = factor, steps = {} }
  table.insert(m.patterns, m.current)
end

function commands.load(m, args)
  if not m.current then return end
  local load, factor = values(m, args, 2), m.current.factor or 0
  for letter, value in pairs(load) do load[letter] = value * factor end
  table.insert(m.current.steps, function(s) s:load(key(args[1]), load) end)
end

function commands.eleLoad(m, args)
  if not m.current then return end
  local names, range = after(args, "-ele", "-eleTag"), after(args, "-range")
  if range then
    names = {}
    for i = range[1], range[2] do names[#names + 1] = i end
  end
  local u, p, f = after(args, "-beamUniform"), after(args, "-beamPoint"), m.current.factor or 0
  if not u and not p then unknown "a load on an element" end
  local load = {}
  local v = u or p
  local across = m.dim == 2 and { v[1], 0 } or { v[1], v[2] }
  local rest = { table.unpack(v, m.dim) }
  if u then
    if #rest > 1 then unknown "a load on a part of an element" end
    load.q = { (rest[1] or 0) * f, across[1] * f, across[2] * f }
  else
    load.force, load.at = { (rest[2] or 0) * f, across[1] * f, across[2] * f }, rest[1]
  end
  for _, name in ipairs(names) do
    table.insert(m.current.steps, function(s) s:beam_load(key(name), load) end)
  end
end

function commands.sp(m, args)
  if not m.current then return end
  local value = tonumber(args[3]) * (m.current.factor or 0)
  table.insert(m.current.steps, function(s) s:fix(key(args[1]), m.of_node[key(args[1])][tonumber(args[2])], value) end)
end

function commands.remove(_, args)
  if args[1] ~= "recorder" and args[1] ~= "recorders" then unknown("remove %s", args[1]) end
end

-- Everything ----------------------------------------------------------------------------------------------------------

function Model:clear()
  for _, name in ipairs { "at", "of_node", "steps", "material", "section", "transf", "integration", "series",
    "patterns" } do self[name] = {} end
  self.current, self.open = nil, nil
end

--- The frame for the solver, with the loads of one pattern, or of none.
function Model:frame(pattern)
  local s = solver.new(self.dim == 2 and "plane" or "space")
  for _, step in ipairs(self.steps) do step(s) end
  for _, step in ipairs(pattern and pattern.steps or {}) do step(s) end
  return s
end

local by_commands = {}

--- The model that stands at the end of a list of commands. Names that are neither here nor in the set `aside` are
--- errors.
function by_commands.read(list, aside)
  local m = setmetatable({}, Model)
  m:clear()
  for _, c in ipairs(list) do
    local f = commands[c[1]]
    if f then
      f(m, { table.unpack(c, 2) })
    elseif not aside[c[1]] then
      unknown("command %s", c[1])
    end
  end
  return m
end

return by_commands

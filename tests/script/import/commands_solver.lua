-- Commands of OpenSees, as a list of { name, argument, ... } of texts, in the small solver (solver.lua): the second
-- route for what import.tcl reads. Elastic, with the stiffness that materials and sections begin with; loads at the
-- factor that their series has at time 1. Nothing of hinge is used. A command or element that is not here is an error,
-- so that nothing is compared that was not built.
local solver = dofile(debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "solver.lua")

local Model, commands, elements, sections, materials = {}, {}, {}, {}, {}
Model.__index = Model

local function unknown(...) error(("the small solver has no " .. ...):format(select(2, ...)), 0) end

-- Degrees of freedom by dimensions and number.
local letters = { [2] = { [2] = { "x", "y" }, [3] = { "x", "y", "rz" } },
  [3] = { [3] = { "x", "y", "z" }, [6] = { "x", "y", "z", "rx", "ry", "rz" } } }
local all_letters = letters[3][6]

-- Texts from an index on as numbers, up to the first that is none.
local function numbers(args, from)
  local list = {}
  for i = from, #args do
    local x = tonumber(args[i])
    if not x then break end
    list[#list + 1] = x
  end
  return list
end

local function option(args, name)
  for i, text in ipairs(args) do
    if text == name then return i end
  end
end

-- The numbers after an option, or nil.
local function after(args, name)
  local i = option(args, name)
  return i and numbers(args, i + 1)
end

-- How many arguments stand before the first option.
local function positional(args)
  for i, text in ipairs(args) do
    if text:find "^%-%a" then return i - 1 end
  end
  return #args
end

-- What a tag stands for among those of one kind.
local function find(m, kind, tag) return m[kind][tag] or unknown("%s %s", kind, tag) end

-- Nodes and what ties them --------------------------------------------------------------------------------------------

function commands.model(m, args)
  m.dim = math.tointeger(after(args, "-ndm")[1])
  m.freedoms = letters[m.dim][math.tointeger(after(args, "-ndf")[1])] or unknown "such degrees of freedom"
end

-- Adds something that is done to the frame when it is built.
local function later(m, f) table.insert(m.steps, f) end

function commands.node(m, args)
  local at = numbers(args, 2)
  m.at[args[1]], m.of_node[args[1]] = at, m.freedoms
  later(m, function(s) s:node(args[1], at[1], at[2], at[3]) end)
end

function commands.fix(m, args)
  local which = {}
  for i, letter in ipairs(m.of_node[args[1]]) do
    if tonumber(args[1 + i]) ~= 0 then which[#which + 1] = letter end
  end
  later(m, function(s) s:fix(args[1], table.concat(which, " ")) end)
end

function commands.equalDOF(m, args)
  local which = {}
  for i = 3, #args do which[#which + 1] = m.of_node[args[1]][tonumber(args[i])] end
  later(m, function(s) s:equal(args[1], args[2], table.concat(which, " ")) end)
end

local floors = { "y z rx", "x z ry", "x y rz" }
function commands.rigidDiaphragm(m, args)
  for i = 3, #args do
    later(m, function(s) s:rigid(args[2], args[i], floors[tonumber(args[1])]) end)
  end
end

function commands.rigidLink(m, args)
  later(m, function(s)
    if args[1] == "bar" then return s:equal(args[2], args[3], "x y z") end
    s:rigid(args[2], args[3], "x y z rx ry rz")
  end)
end

-- Materials and sections: the stiffness that they begin with ----------------------------------------------------------

function materials.Elastic(v) return v[1] end
function materials.Steel01(v) return v[2] end

function commands.uniaxialMaterial(m, args)
  m.material[args[2]] = (materials[args[1]] or unknown("material %s", args[1]))(numbers(args, 3))
end

-- section Elastic tag E A Iz <G alphaY>, in space E A Iz Iy G J <alphaY alphaZ>
function sections.Elastic(m, args)
  local v = numbers(args, 3)
  if m.dim == 2 then return { EA = v[1] * v[2], EIz = v[1] * v[3], GAy = v[5] and v[4] * v[2] * v[5] } end
  return { EA = v[1] * v[2], EIz = v[1] * v[3], EIy = v[1] * v[4], GJ = v[5] * v[6],
    GAy = v[7] and v[5] * v[2] * v[7], GAz = v[8] and v[5] * v[2] * v[8] }
end

-- The fibres follow as patches.
function sections.Fiber() return { EA = 0, EIz = 0, EIy = 0 } end

local directions = { P = "EA", Mz = "EIz", My = "EIy", T = "GJ", Vy = "GAy", Vz = "GAz" }
function sections.Aggregator(m, args)
  local s, i = {}, option(args, "-section")
  for name, value in pairs(i and find(m, "section", args[i + 1]) or {}) do s[name] = value end
  for k = 3, (i or #args + 1) - 2, 2 do s[directions[args[k + 1]]] = find(m, "material", args[k]) end
  return s
end

function sections.Uniaxial(m, args) return { [directions[args[4]]] = find(m, "material", args[3]) } end

function commands.section(m, args)
  m.open = (sections[args[1]] or unknown("section %s", args[1]))(m, args)
  m.section[args[2]] = m.open
end

-- patch rect material ny nz y0 z0 y1 z1, with its middle at 0: each fibre at its own middle.
function commands.patch(m, args)
  if args[1] ~= "rect" then unknown("patch %s", args[1]) end
  local v = numbers(args, 3)
  local ny, nz, dy, dz = v[1], v[2], (v[5] - v[3]) / v[1], (v[6] - v[4]) / v[2]
  for i = 1, ny do
    for k = 1, nz do
      local EA = find(m, "material", args[2]) * dy * dz
      m.open.EA, m.open.EIz = m.open.EA + EA, m.open.EIz + EA * (v[3] + (i - 0.5) * dy) ^ 2
      m.open.EIy = m.open.EIy + EA * (v[4] + (k - 0.5) * dz) ^ 2
    end
  end
end

-- Elements ------------------------------------------------------------------------------------------------------------

function commands.geomTransf(m, args)
  local t = {}
  if m.dim == 3 then t.vecxz = numbers(args, 3) end
  local arms = after(args, "-jntOffset")
  if arms then
    t.arm_i, t.arm_j = { table.unpack(arms, 1, m.dim) }, { table.unpack(arms, m.dim + 1, 2 * m.dim) }
    if m.dim == 2 then t.arm_i[3], t.arm_j[3] = 0, 0 end
  end
  m.transf[args[2]] = t
end

local function beam(m, args, p, transf)
  local t = find(m, "transf", transf)
  p[1], p[2], p[3] = args[1], args[2], args[3]
  p.vecxz, p.arm_i, p.arm_j = t.vecxz, t.arm_i, t.arm_j
  for name, letter in pairs { ["-release"] = "rz", ["-releasez"] = "rz", ["-releasey"] = "ry" } do
    local code = (after(args, name) or { 0 })[1]
    if code == 1 or code == 3 then p.release_i = (p.release_i or "") .. " " .. letter end
    if code == 2 or code == 3 then p.release_j = (p.release_j or "") .. " " .. letter end
  end
  later(m, function(s) s:beam(p) end)
end

-- A section's stiffness as that of a beam of E = G = 1.
local function of_section(m, name, shear)
  local s = find(m, "section", name)
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
    local section, transf = args[5], args[4]
    if args[6] and tonumber(args[5]) then
      transf = args[6]
    elseif args[6] then
      section = args[6]
    else
      section = find(m, "integration", args[5])[3]
    end
    beam(m, args, of_section(m, section, shear), transf)
  end
end
elements.forceBeamColumn, elements.nonlinearBeamColumn = with_points(true), with_points(true)
elements.dispBeamColumn = with_points(false)

function commands.beamIntegration(m, args) m.integration[args[2]] = args end

-- tag i j A material | tag i j section
function elements.truss(m, args)
  local EA = args[5] and tonumber(args[4]) * find(m, "material", args[5]) or find(m, "section", args[4]).EA
  later(m, function(s) s:beam { args[1], args[2], args[3], E = 1, A = EA } end)
end
elements.corotTruss = elements.truss

local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end
local function unit(a)
  local size = math.sqrt(a[1] ^ 2 + a[2] ^ 2 + a[3] ^ 2)
  return { a[1] / size, a[2] / size, a[3] / size }
end
local function axes_of(x, yp)
  x = unit(x)
  local z = unit(cross(x, yp))
  return { x, cross(z, x), z }
end

-- A spring with the stiffness along its axes that -mat and -dir give, x to rz.
local function spring(m, args, more)
  local p, mats = { args[1], args[2], args[3], axes = more.axes, arm_i = more.arm_i, arm_j = more.arm_j }, {}
  for i = option(args, "-mat") + 1, option(args, "-dir") - 1 do mats[#mats + 1] = args[i] end
  for i, dir in ipairs(after(args, "-dir")) do
    local letter = all_letters[m.dim == 2 and dir == 3 and 6 or math.tointeger(dir)]
    p[letter] = (p[letter] or 0) + find(m, "material", mats[i])
  end
  later(m, function(s) s:spring(p) end)
end

function elements.zeroLength(m, args)
  local o = after(args, "-orient") or { 1, 0, 0, 0, 1, 0 }
  spring(m, args, { axes = axes_of({ o[1], o[2], o[3] }, { o[4], o[5], o[6] }) })
end

-- Its spring is in its middle.
function elements.twoNodeLink(m, args)
  local a, b = m.at[args[2]], m.at[args[3]]
  local d, o = { b[1] - a[1], b[2] - a[2], (b[3] or 0) - (a[3] or 0) }, after(args, "-orient")
  local axes = o and axes_of({ o[1], o[2], o[3] }, { o[4], o[5], o[6] }) or axes_of(d, { -d[2], d[1], 0 })
  spring(m, args, { axes = axes, arm_i = { d[1] / 2, d[2] / 2, d[3] / 2 },
    arm_j = { -d[1] / 2, -d[2] / 2, -d[3] / 2 } })
end

function commands.element(m, args)
  (elements[args[1]] or unknown("element %s", args[1]))(m, { table.unpack(args, 2) })
end

-- Loads ---------------------------------------------------------------------------------------------------------------

local function factor_of(args, from)
  if args[from] ~= "Linear" and args[from] ~= "Constant" then unknown("series %s", args[from]) end
  return (after(args, "-factor") or { 1 })[1]
end

function commands.timeSeries(m, args) m.series[args[2]] = factor_of(args, 1) end

function commands.pattern(m, args)
  if args[1] ~= "Plain" then unknown("pattern %s", args[1]) end
  local factor = tonumber(args[3]) and find(m, "series", args[3]) * (after(args, "-fact") or { 1 })[1]
  m.current = { name = args[2], factor = factor or factor_of(args, 3), steps = {} }
  table.insert(m.patterns, m.current)
end

function commands.load(m, args)
  local load = {}
  for i, letter in ipairs(m.of_node[args[1]]) do load[letter] = tonumber(args[1 + i]) * m.current.factor end
  table.insert(m.current.steps, function(s) s:load(args[1], load) end)
end

function commands.eleLoad(m, args)
  local names, range = after(args, "-ele"), after(args, "-range")
  if range then
    names = {}
    for i = range[1], range[2] do names[#names + 1] = i end
  end
  local u, p, f = after(args, "-beamUniform"), after(args, "-beamPoint"), m.current.factor
  local v, load = u or p or unknown "such load on an element", {}
  local across = m.dim == 2 and { v[1], 0 } or { v[1], v[2] }
  local rest = { table.unpack(v, m.dim) }
  if u then
    load.q = { (rest[1] or 0) * f, across[1] * f, across[2] * f }
  else
    load.force, load.at = { (rest[2] or 0) * f, across[1] * f, across[2] * f }, rest[1]
  end
  for _, name in ipairs(names) do
    table.insert(m.current.steps, function(s) s:beam_load(("%d"):format(name), load) end)
  end
end

-- Everything ----------------------------------------------------------------------------------------------------------

--- The frame for the solver, with the loads of one pattern.
function Model:frame(pattern)
  local s = solver.new(self.dim == 2 and "plane" or "space")
  for _, step in ipairs(self.steps) do step(s) end
  for _, step in ipairs(pattern.steps) do step(s) end
  return s
end

local by_commands = {}

--- The model of a list of commands.
function by_commands.read(list)
  local m = setmetatable({ at = {}, of_node = {}, steps = {}, material = {}, section = {}, transf = {},
    integration = {}, series = {}, patterns = {} }, Model)
  for _, c in ipairs(list) do (commands[c[1]] or unknown("command %s", c[1]))(m, { table.unpack(c, 2) }) end
  return m
end

return by_commands

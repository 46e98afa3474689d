-- Materials and sections of OpenSees, for commands_solver.lua: the stiffness that they begin with.
local part = { commands = {} }
local commands, materials, sections = part.commands, {}, {}

--- Ends the comparison of a script: it has something that is not here.
function part.unknown(...) error({ unknown = (...):format(select(2, ...)) }, 0) end
local unknown = part.unknown

-- Texts from an index on as numbers, up to the first that is none.
function part.numbers(args, from)
  local list = {}
  for i = from, #args do
    local x = tonumber(args[i])
    if not x then break end
    list[#list + 1] = x
  end
  return list
end

function part.option(args, ...)
  for _, name in ipairs { ... } do
    for i, text in ipairs(args) do
      if text == name then return i end
    end
  end
end

-- The numbers after an option, or nil.
function part.after(args, ...)
  local i = part.option(args, ...)
  return i and part.numbers(args, i + 1)
end

-- How many arguments stand before the first option.
function part.positional(args)
  for i, text in ipairs(args) do
    if text:find "^%-%a" then return i - 1 end
  end
  return #args
end

function part.key(text) return ("%.0f"):format(assert(tonumber(text), "a tag")) end

local numbers, option, after, key = part.numbers, part.option, part.after, part.key

-- Materials ----------------------------------------------------------------------------------------------

local function concrete(v) return 2 * math.abs(v[1]) / math.abs(v[2]) end -- signs are taken as negative

-- The stiffness that a material begins with.
for name, f in pairs {
  Elastic = function(v) return v[1] end, ElasticPP = function(v) return v[1] end, ENT = function(v) return v[1] end,
  Steel01 = function(v) return v[2] end, Steel02 = function(v) return v[2] end,
  ReinforcingSteel = function(v) return v[3] end,
  Concrete01 = concrete, Concrete02 = concrete,
  Concrete04 = function(v) return v[4] end, Hardening = function(v) return v[1] end,
  Hysteretic = function(v) return v[1] / v[2] end, Bilin = function(v) return v[1] end,
  ModIMKPeakOriented = function(v) return v[1] end, ModIMKPinching = function(v) return v[1] end,
  IMKBilin = function(v) return v[1] end, IMKPeakOriented = function(v) return v[1] end,
  UVCuniaxial = function(v) return v[1] end, Viscous = function() return 0 end } do materials[name] = f end

function materials.MinMax(_, m, args) return m.material[key(args[3])] end
function materials.Parallel(v, m)
  local sum = 0
  for _, x in ipairs(v) do sum = sum + m.material[key(x)] end
  return sum
end

function commands.uniaxialMaterial(m, args)
  local f = materials[args[1]]
  local v = numbers(args, 3)
  m.material[key(args[2])] = f and f(v, m, args) or function() unknown("material %s", args[1]) end
end

local function stiffness_of(m, name)
  local E = m.material[key(name)]
  if not E then unknown("material %s is not there", name) end
  return type(E) == "function" and E() or E
end

-- section Elastic tag E A Iz <G alphaY>, in space E A Iz Iy G J <alphaY alphaZ>
function sections.Elastic(m, args)
  local v = numbers(args, 3)
  if m.dim == 2 then return { EA = v[1] * v[2], EIz = v[1] * v[3], GAy = v[5] and v[4] * v[2] * v[5] } end
  return { EA = v[1] * v[2], EIz = v[1] * v[3], EIy = v[1] * v[4], GJ = v[5] * v[6],
    GAy = v[7] and v[5] * v[2] * v[7], GAz = v[8] and v[5] * v[2] * v[8] }
end

-- The fibres follow as commands of their own.
function sections.Fiber(m, args)
  local torsion = after(args, "-GJ")
  local i = option(args, "-torsion")
  return { fibres = {}, GJ = torsion and torsion[1] or i and stiffness_of(m, args[i + 1]) }
end
sections.fiberSec = sections.Fiber

local directions = { P = "EA", Mz = "EIz", My = "EIy", T = "GJ", Vy = "GAy", Vz = "GAz" }
function sections.Aggregator(m, args)
  local s, i = {}, option(args, "-section")
  for name, value in pairs(i and m.section[key(args[i + 1])] or {}) do s[name] = value end
  for k = 3, (i or #args + 1) - 2, 2 do s[directions[args[k + 1]]] = stiffness_of(m, args[k]) end
  return s
end

function sections.Uniaxial(m, args) return { [directions[args[4]]] = stiffness_of(m, args[3]) } end

function commands.section(m, args)
  if not sections[args[1]] then
    m.section[key(args[2])] = { unknown = args[1] }
    return
  end
  m.section[key(args[2])] = sections[args[1]](m, args)
  m.open = m.section[key(args[2])].fibres
end

local function add_fibre(m, y, z, A, material)
  table.insert(m.open, { y = y, z = z, A = A, E = stiffness_of(m, material) })
end

function commands.fiber(m, args) add_fibre(m, tonumber(args[1]), tonumber(args[2]), tonumber(args[3]), args[4]) end

local patches = {}

-- A quadrilateral cut by lines between its sides: each piece at its centroid, with its area.
function patches.quad(m, args)
  local ni, nj, v = tonumber(args[3]), tonumber(args[4]), numbers(args, 5)
  local function at(a, b)
    local w = { (1 - a) * (1 - b), a * (1 - b), a * b, (1 - a) * b }
    local y, z = 0, 0
    for i = 1, 4 do y, z = y + w[i] * v[2 * i - 1], z + w[i] * v[2 * i] end
    return { y, z }
  end
  for i = 0, ni - 1 do
    for j = 0, nj - 1 do
      local a, b, c_, d_ = i / ni, (i + 1) / ni, j / nj, (j + 1) / nj
      local c = { at(a, c_), at(b, c_), at(b, d_), at(a, d_) }
      local A, y, z = 0, 0, 0
      for k = 1, 4 do
        local p, q = c[k], c[k % 4 + 1]
        local d = p[1] * q[2] - q[1] * p[2]
        A, y, z = A + d / 2, y + (p[1] + q[1]) * d / 6, z + (p[2] + q[2]) * d / 6
      end
      if A ~= 0 then add_fibre(m, y / A, z / A, math.abs(A), args[2]) end
    end
  end
end
patches.quadr = patches.quad

function patches.rect(m, args)
  local v = numbers(args, 5)
  patches.quad(m, { "quad", args[2], args[3], args[4], v[1], v[2], v[3], v[2], v[3], v[4], v[1], v[4] })
end

function patches.circ(m, args)
  local nc, nr, v = tonumber(args[3]), tonumber(args[4]), numbers(args, 5)
  local from, to = math.rad(v[5] or 0), math.rad(v[6] or 360)
  local turn = (to - from) / nc
  for r = 0, nr - 1 do
    local r0, r1 = v[3] + (v[4] - v[3]) * r / nr, v[3] + (v[4] - v[3]) * (r + 1) / nr
    local A = turn / 2 * (r1 ^ 2 - r0 ^ 2)
    local centre = 2 / 3 * (r1 ^ 3 - r0 ^ 3) / (r1 ^ 2 - r0 ^ 2) * math.sin(turn / 2) / (turn / 2)
    for i = 0, nc - 1 do
      local angle = from + (i + 0.5) * turn
      add_fibre(m, v[1] + centre * math.cos(angle), v[2] + centre * math.sin(angle), A, args[2])
    end
  end
end

function commands.patch(m, args) (patches[args[1]] or function() unknown("patch %s", args[1]) end)(m, args) end

function commands.layer(m, args)
  local n, A, v = tonumber(args[3]), tonumber(args[4]), numbers(args, 5)
  for i = 0, n - 1 do
    if args[1] == "straight" then
      local t = n > 1 and i / (n - 1) or 0.5
      add_fibre(m, v[1] + t * (v[3] - v[1]), v[2] + t * (v[4] - v[2]), A, args[2])
    elseif args[1] == "circ" then
      local from, to = math.rad(v[4] or 0), math.rad(v[5] or 360 - 360 / n)
      local angle = from + (n > 1 and i / (n - 1) or 0) * (to - from)
      add_fibre(m, v[1] + v[3] * math.cos(angle), v[2] + v[3] * math.sin(angle), A, args[2])
    else
      unknown("layer %s", args[1])
    end
  end
end

-- Stiffness of a section; that of fibres about their centroid.
function part.section_of(m, name)
  local s = m.section[key(name)]
  if not s then unknown("section %s is not there", name) end
  if s.unknown then unknown("section %s", s.unknown) end
  if s.fibres and not s.EA then
    local A, y, z = 0, 0, 0
    for _, f in ipairs(s.fibres) do A, y, z = A + f.A, y + f.A * f.y, z + f.A * f.z end
    s.EA, s.EIz, s.EIy = 0, 0, 0
    for _, f in ipairs(s.fibres) do
      s.EA, s.EIz = s.EA + f.E * f.A, s.EIz + f.E * f.A * (f.y - y / A) ^ 2
      s.EIy = s.EIy + f.E * f.A * (f.z - z / A) ^ 2
    end
  end
  return s
end

part.stiffness_of = stiffness_of
return part

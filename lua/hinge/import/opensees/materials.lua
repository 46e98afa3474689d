-- uniaxialMaterial of OpenSees: its first stiffness, its yield stress, how it hardens, and for joints its backbone.
-- Numbers are in the units of the script.
local arguments = require "hinge.import.opensees.arguments"
local check = require "hinge.library.check"

local tag, give_up = arguments.tag, arguments.give_up

-- For each kind a function of its numbers v after the tag: { E =, fy =, b = (slope beyond yield over E), points = { {
-- deformation, force }, ... } of its backbone, said = what of it is not modelled }.
local makers = {}

function makers.Elastic(v)
  if v[3] and v[3] ~= v[1] then give_up "an elastic material with another stiffness in compression is not read" end
  return { E = v[1] }
end

function makers.ElasticPP(v)
  if v[3] and math.abs(math.abs(v[3]) - v[2]) > 1e-9 * v[2] then
    give_up "other strains of yielding in compression are not read"
  end
  return { E = v[1], fy = v[1] * v[2], b = 0 }
end

function makers.Steel01(v)
  local isotropic = v[4] and v[4] ~= 0 and "isotropic hardening of Steel01 is left out" or nil
  return { E = v[2], fy = v[1], b = v[3], said = isotropic }
end

function makers.Steel02(v)
  return { E = v[2], fy = v[1], b = v[3], said = "Steel02 is bilinear with kinematic hardening: no curve between its "
    .. "branches, no isotropic hardening" }
end

-- Hardening tag E fy Hiso Hkin
function makers.Hardening(v)
  local H = v[3] + v[4]
  return { E = v[1], fy = v[2], b = H / (v[1] + H), kinematic = H > 0 and v[4] / H or nil }
end

-- Points of a backbone with positive deformations, up to the greatest force, and what comes after it.
local function rising(points)
  local kept = {}
  for _, p in ipairs(points) do
    local before = kept[#kept]
    if before and p[2] <= before[2] then break end
    kept[#kept + 1] = p
  end
  return kept
end

-- Hysteretic tag s1 e1 s2 e2 <s3 e3> -s1 -e1 ...
function makers.Hysteretic(v)
  local count = #v >= 12 and 3 or 2
  local points = {}
  for i = 1, count do points[i] = { v[2 * i], v[2 * i - 1] } end
  for i = 1, count do
    local e, s = v[2 * (count + i)], v[2 * (count + i) - 1]
    local turn, force = points[i][1], points[i][2]
    if not e or math.abs(e + turn) > 1e-6 * turn or math.abs(s + force) > 1e-6 * force then
      give_up "a backbone that differs in compression is not read"
    end
  end
  return { E = points[1][2] / points[1][1], fy = points[1][2], b = 0, points = rising(points),
    said = "Hysteretic keeps its backbone up to the greatest force, without pinching and damage" }
end

-- An Ibarra-Medina-Krawinkler spring: its stiffness, strength, greatest moment, and plastic rotation there.
local function imk(K, My, cap, capped_at)
  return { E = K, fy = My, b = 0, points = { { My / K, My }, { My / K + capped_at, cap } }, imk = true }
end

-- Both signs must be alike: a joint of hinge has one backbone.
local function alike(plus, minus)
  if math.abs(math.abs(minus) - math.abs(plus)) > 1e-3 * math.abs(plus) then
    give_up "a backbone that differs between its two signs is not read"
  end
end

-- Bilin tag K as+ as- My+ My- LS LK LA LD cS cK cA cD thp+ thp- thpc+ thpc- Res+ Res- thu+ thu- D+ D- <n>
function makers.Bilin(v)
  if #v < 21 then give_up "Bilin has too few numbers" end
  alike(v[4], v[5])
  alike(v[14], v[15])
  return imk(v[1], v[4], v[4] + v[2] * v[1] * v[14], v[14])
end
makers.ModIMKPeakOriented = makers.Bilin

-- IMKBilin tag K thp+ thpc+ thu+ My+ Mmax/My+ Res+ thp- thpc- thu- My- Mmax/My- Res- LS LC LK cS cC cK D+ D-
function makers.IMKBilin(v)
  if #v < 14 then give_up "IMKBilin has too few numbers" end
  alike(v[5], v[11])
  alike(v[2], v[8])
  return imk(v[1], v[5], v[5] * v[6], v[2])
end
makers.IMKPeakOriented = makers.IMKBilin

-- Concrete01 tag fpc epsc0 fpcu epsu; Concrete02 alike: E is that at the start, 2 fpc / epsc0.
local function concrete(v)
  local fc, e0 = math.abs(v[1]), math.abs(v[2])
  if fc == 0 or e0 == 0 then give_up "the strength or its strain is 0" end
  return { E = 2 * fc / e0, concrete = true }
end
makers.Concrete01, makers.Concrete02 = concrete, concrete

-- Concrete04 tag fc ec ecu Ec
function makers.Concrete04(v) return { E = v[4], concrete = true } end

-- Reinforcing steel: ReinforcingSteel tag fy fu Es Esh esh eult
function makers.ReinforcingSteel(v)
  return { E = v[3], fy = v[1], b = 0, said = "ReinforcingSteel has no hardening" }
end

-- Materials around another one: its tag is the first number.
local wraps = { MinMax = "the limits of MinMax", Fatigue = "Fatigue" }

local commands = {}

-- Materials in parallel that are elastic add up.
local function parallel(self, args)
  local sum = { E = 0 }
  for i = 3, arguments.positional(args) do
    local one = arguments.find(self, "uniaxialMaterial", tag(self, args[i], "the material"))
    if one.fy or one.concrete then give_up "materials in parallel are read where all are elastic" end
    sum.E = sum.E + one.E
  end
  return sum
end

function commands.uniaxialMaterial(self, args)
  local kind, name = args[1] or "", tag(self, args[2], "the tag")
  self.uniaxialMaterial[name] = { unread = self.place }
  local made
  if kind == "Parallel" then
    made = parallel(self, args)
  elseif wraps[kind] then
    made = check.copy(arguments.find(self, "uniaxialMaterial", tag(self, args[3], "the material")))
    made.said = wraps[kind] .. " is left out: nothing breaks by it"
  elseif makers[kind] then
    local v = arguments.numbers(self, args, 3, arguments.positional(args), "number")
    if #v == 0 then self:fail("uniaxialMaterial %s has no numbers", kind) end
    local good, result = pcall(makers[kind], v)
    if not good then
      if type(result) == "table" then error(result, 0) end
      self:fail("uniaxialMaterial %s %s has too few numbers", kind, name)
    end
    made = result
  else
    give_up("uniaxialMaterial %s is not read", kind)
  end
  if not (made.E and made.E > 0) then give_up("the stiffness is %s; it must be above 0", tostring(made.E)) end
  made.name = "material " .. name
  made.kind = kind
  self.uniaxialMaterial[name] = made
end

local materials = { commands = commands }

--- A material by its tag; what of it is not modelled is said.
function materials.of(self, text)
  local found = arguments.find(self, "uniaxialMaterial", tag(self, text, "the material"))
  if found.said then arguments.assume(self, found.said) end
  return found
end

return materials

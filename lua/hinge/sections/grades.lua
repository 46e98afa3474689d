-- Materials by their names in standards: steel, aluminium, timber, concrete and reinforcing bars.
--
-- A row: name, then numbers in MPa, kg/m^3 and mm. Yield stresses are the characteristic or nominal ones, without
-- partial factors. What was not confirmed in a second source is said beside the table.
local check = require "hinge.library.check"
local core = require "hinge.core"

local grades = {}

-- Steel ---------------------------------------------------------------------------------------------------------------
-- Yield stress up to the thicknesses of the table, mm. E: 210 GPa in EN, 200 in AISC, 205 in Japan.
--
-- EN 10025-2 as the public program XC (xcfem/xc) has it. EN 10025-4 (S420M, S460M): from memory. EN 1993-1-1, table
-- 3.1, as XC, themis (alezen9/themis) and metku (kuisidu/metku) have it. ASTM: XC; A500 by grade: from memory. Ry:
-- expected over nominal yield stress, AISC 341; that of A500 C is from memory. JIS G 3136 and BCR295: tables of
-- makers; BCP325 from memory. All are least values.
local steels = {
  ["EN 10025"] = {
    E = 210e9, up_to = { 16, 40, 63, 80, 100, 150 },
    S235 = { 235, 225, 215, 215, 215, 195 }, S275 = { 275, 265, 255, 245, 235, 225 },
    S355 = { 355, 345, 335, 325, 315, 295 }, S450 = { 450, 430, 410, 390, 380, 380 },
    S420M = { 420, 400, 390, 380, 370 }, S460M = { 460, 440, 430, 410, 400 },
  },
  ["EN 1993-1-1"] = {
    E = 210e9, up_to = { 40, 80 },
    S235 = { 235, 215 }, S275 = { 275, 255 }, S355 = { 355, 335 }, S420N = { 420, 390 }, S460N = { 460, 430 },
  },
  ASTM = {
    E = 200e9, up_to = { math.huge },
    A36 = { 250, Ry = 1.5 }, ["A572-50"] = { 345, Ry = 1.1 }, A992 = { 345, Ry = 1.1 },
    ["A500-B"] = { 315, Ry = 1.4 }, ["A500-C"] = { 345, Ry = 1.3 },
    ["A500-B round"] = { 290, Ry = 1.4 }, ["A500-C round"] = { 315, Ry = 1.3 },
  },
  JIS = {
    E = 205e9, up_to = { 40 },
    SN400A = { 235 }, SN400B = { 235 }, SN490B = { 325 }, SN490 = { 325 }, BCR295 = { 295 }, BCP325 = { 325 },
  },
}
local standards = { "EN 10025", "EN 1993-1-1", "ASTM", "JIS" }

-- Aluminium -----------------------------------------------------------------------------------------------------------
-- 0.2 % proof stress of extruded profiles up to the thickness, mm: EN 1999-1-1, table 3.2b, as dnaop.com shows it;
-- 6082-T6 from memory. E = 70 GPa, 2700 kg/m^3.
local aluminium = {
  ["5083-O"] = { { 200, 110 } }, ["6060-T6"] = { { 15, 140 } }, ["6061-T6"] = { { 20, 240 } },
  ["6063-T5"] = { { 3, 130 }, { 25, 110 } }, ["6063-T6"] = { { 25, 160 } }, ["6063-T66"] = { { 10, 200 }, { 25, 180 } },
  ["6005A-T6"] = { { 5, 225 }, { 10, 215 }, { 25, 200 } }, ["6082-T6"] = { { 5, 250 }, { 15, 260 } },
}

-- Timber --------------------------------------------------------------------------------------------------------------
-- Bending strength, mean E along the grain and mean G, MPa; mean density. EN 338 and, for glued laminated timber,
-- EN 14080: from memory.
local timber = {
  C16 = { 16, 8000, 500, 370 }, C18 = { 18, 9000, 560, 380 }, C24 = { 24, 11000, 690, 420 },
  C27 = { 27, 11500, 720, 430 }, C30 = { 30, 12000, 750, 460 }, C35 = { 35, 13000, 810, 470 },
  C40 = { 40, 14000, 880, 480 }, D30 = { 30, 11000, 690, 640 }, D40 = { 40, 13000, 810, 660 },
  GL24h = { 24, 11500, 650, 420 }, GL28h = { 28, 12600, 650, 460 }, GL30h = { 30, 13600, 650, 480 },
  GL32h = { 32, 14200, 650, 490 },
}

-- Concrete ------------------------------------------------------------------------------------------------------------
-- Characteristic strengths of cylinders, MPa: EN 206. E = 22 GPa (f_cm / 10)^0.3 with f_cm = f_ck + 8, EN 1992-1-1,
-- table 3.1; nu = 0.2; 2500 kg/m^3 with reinforcement.
local concrete = {}
for name, f_ck in ("C12/15 C16/20 C20/25 C25/30 C30/37 C35/45 C40/50 C45/55 C50/60 C55/67 C60/75 C70/85 C80/95 C90/105")
  :gmatch "(C(%d+)/%d+)" do concrete[name] = tonumber(f_ck) end

-- Reinforcing bars ----------------------------------------------------------------------------------------------------
-- Yield stress and E, MPa: EN 1992-1-1, annex C; ASTM A615; JIS G 3112. From memory.
local bars = {
  B500A = { 500, 200e3 }, B500B = { 500, 200e3 }, B500C = { 500, 200e3 }, B450C = { 450, 200e3 },
  ["Grade 40"] = { 280, 200e3 }, ["Grade 60"] = { 420, 200e3 }, ["Grade 75"] = { 520, 200e3 },
  SD295 = { 295, 205e3 }, SD345 = { 345, 205e3 }, SD390 = { 390, 205e3 }, SD490 = { 490, 205e3 },
}

-- Names ---------------------------------------------------------------------------------------------------------------

local function plain(name) return (name:upper():gsub("[%s%-_]", "")) end

local function find(where, name, list)
  if type(name) ~= "string" then
    check.fail("%s: the name is %s; must be a string such as '%s'", where,
      name == nil and "missing" or check.show(name), list[1])
  end
  for _, known in ipairs(list) do
    if plain(known) == plain(name) then return known end
  end
  check.fail("%s: unknown grade '%s'%s; there are %s", where, name, core.did_you_mean(name, list),
    table.concat(list, ", "))
end

local function keys(...)
  local seen, list = {}, {}
  for _, rows in ipairs { ... } do
    for key in pairs(rows) do
      if type(key) == "string" and key ~= "E" and key ~= "up_to" and not seen[key] then
        seen[key] = true
        list[#list + 1] = key
      end
    end
  end
  table.sort(list, function(a, b)
    local x, y = a:match "^%a+", b:match "^%a+"
    if (x or "") ~= (y or "") then return (x or "") < (y or "") end
    local m, n = tonumber(a:match "%d+"), tonumber(b:match "%d+")
    if m ~= n then return m < n end
    return a < b
  end)
  return list
end

local kinds = { steel = keys(steels["EN 10025"], steels["EN 1993-1-1"], steels.ASTM, steels.JIS),
  aluminium = keys(aluminium), timber = keys(timber), concrete = keys(concrete), bars = keys(bars) }

local density = { "number", unit = "kg/m^3", at_least = 0, optional = true }
local thickness = { "number", unit = "m", above = 0, at_most = 1, optional = true }
local law = { "table", optional = true } -- of hinge.material, which checks what is in it

-- The value of a band of thicknesses, m; without a thickness the first.
local function by_thickness(where, name, t, limits, values)
  if not t then return values[1] end
  for i, limit in ipairs(limits) do
    if not values[i] then break end
    if 1e3 * t <= limit * (1 + 1e-9) then return values[i] end
  end
  check.fail("%s: field 'thickness' is %s m; %s is known up to %s m", where, check.show(t), name,
    check.show(limits[#values] / 1e3))
end

--- Each function returns what core.material takes.
function grades.steel(name, options)
  local where = "hinge.material.steel"
  local o = check.options(where, options, { thickness = thickness, density = density,
    hardening = law, rate = law, hot_curve = law, standard = { "string", one_of = standards, optional = true },
    expected = { "boolean", default = false } })
  name = find(where, name, o.standard and keys(steels[o.standard]) or kinds.steel)
  local standard = o.standard
  for _, s in ipairs(standards) do standard = standard or steels[s][name] and s end
  local rows = steels[standard]
  local fy = by_thickness(where, name, o.thickness, rows.up_to, rows[name])
  if o.expected and not rows[name].Ry then
    check.fail("%s: field 'expected' is true; AISC 341 has a factor for %s alone, not for %s", where,
      table.concat(keys(steels.ASTM), ", "), name)
  end
  return { E = rows.E, nu = 0.3, density = o.density or 7850, hardening = o.hardening, rate = o.rate,
    hot_curve = o.hot_curve, yield_stress = 1e6 * fy * (o.expected and rows[name].Ry or 1) }
end

function grades.aluminium(name, options)
  local where = "hinge.material.aluminium"
  local o = check.options(where, options, { thickness = thickness, density = density })
  name = find(where, name, kinds.aluminium)
  local limits, values = {}, {}
  for i, band in ipairs(aluminium[name]) do limits[i], values[i] = band[1], band[2] end
  return { E = 70e9, nu = 0.3, density = o.density or 2700,
    yield_stress = 1e6 * by_thickness(where, name, o.thickness, limits, values) }
end

function grades.timber(name, options)
  local where = "hinge.material.timber"
  local o = check.options(where, options, { density = density })
  local row = timber[find(where, name, kinds.timber)]
  return { E = 1e6 * row[2], G = 1e6 * row[3], density = o.density or row[4], yield_stress = 1e6 * row[1] }
end

function grades.concrete(name, options)
  local where = "hinge.material.concrete"
  local o = check.options(where, options, { density = density })
  local f_ck = concrete[find(where, name, kinds.concrete)]
  return { E = 22e9 * ((f_ck + 8) / 10) ^ 0.3, nu = 0.2, density = o.density or 2500 }
end

function grades.bars(name, options)
  local where = "hinge.material.bars"
  local o = check.options(where, options, { density = density })
  local row = bars[find(where, name, kinds.bars)]
  return { E = 1e6 * row[2], nu = 0.3, density = o.density or 7850, yield_stress = 1e6 * row[1] }
end

--- Strength of a grade by its own name: f_ck of concrete, yield stress of bars. Pa.
function grades.strength(kind, name)
  return 1e6 * (kind == "concrete" and concrete[name] or bars[name][1])
end

--- The names of all grades of a kind.
function grades.names(kind)
  local names = type(kind) == "string" and kinds[kind]
  if not names then
    check.fail("hinge.material.names: the kind is %s%s; must be one of %s",
      kind == nil and "missing" or check.show(kind), core.did_you_mean(tostring(kind), check.keys(kinds)),
      table.concat(check.keys(kinds), ", "))
  end
  return table.move(names, 1, #names, 1, {})
end

return grades

-- A rectangle of reinforced concrete, from its sizes, its bars and its strengths.
--
-- It yields by the ultimate states of its strains (src/section/ultimate_states.h): EN 1992-1-1, table 3.1, 3.1.7 and
-- 3.2.7 (parabola and rectangle, bars without a limit of strain), or the block of ACI 318.
--
-- strains = "plastic": by the plastic interaction of concrete and bars (src/section/plastic_domain.h). Two numbers
-- bring that near the ultimate states of EN: bars carry at most Es 0.002 = 400 MPa in compression, their stress where
-- the whole section is at that strain; and the concrete carries `effectiveness` of its strength, 0.95.
-- lua/guide/concrete.md has the errors.
--
-- Stiffness: ASCE 41-17, table 10-5: 0.3 Ec Ig for beams and for columns with N up to 0.1 Ag f'c, 0.7 for columns with
-- 0.5 Ag f'c and more, between them by interpolation. The table's factors for N and for shear are those of no cracks.
local check = require "hinge.library.check"
local grades = require "hinge.sections.grades"
local shapes = require "hinge.sections.shapes"

local concrete = {}
local where = "hinge.section.concrete"

local Es = 200e9 -- Pa, of bars
local largest_compression = 0.002 * Es
local plastic_effectiveness = 0.95
local cracked = 0.3
local length = { "number", unit = "m", above = 0 }
local optional_length = { "number", unit = "m", above = 0, optional = true }

-- 1e5 Pa: a number below that is one in MPa.
local function strength(kind) return { "number", unit = "Pa", at_least = 1e5, also = grades.names(kind) } end

local options = {
  width = length, depth = length, concrete = strength "concrete", steel = strength "bars",
  strains = { "string", one_of = { "EN 1992-1-1", "ACI 318", "plastic" }, optional = true },
  bar_compression = { "number", unit = "Pa", above = 0, optional = true },
  effectiveness = { "number", above = 0, at_most = 1, optional = true },
  bars = { "table", optional = true }, layers = { "table", optional = true }, cover = optional_length,
  stiffness = { "number", above = 0, at_most = 2, also = { "gross", "cracked" }, default = "gross" },
}

-- The area of a bar by its diameter or its area.
local function area_of(at, bar)
  local diameter, area = bar.diameter, bar.area
  if (diameter == nil) == (area == nil) then
    check.fail("%s: give either 'diameter' (m) or 'area' (m^2)%s", at, diameter and "; both are given" or "")
  end
  if diameter then return math.pi / 4 * check.value(at, "diameter", diameter, length) ^ 2 end
  return check.value(at, "area", area, { "number", unit = "m^2", above = 0 })
end

local function only(at, given, fields)
  for field in pairs(given) do
    if type(field) == "string" and not fields[field] then check.unknown(at, "field", field, check.keys(fields)) end
  end
end

local function add_bars(o, list)
  for i, bar in ipairs(o.bars or {}) do
    local at = ("%s, bar %d"):format(where, i)
    if type(bar) ~= "table" or #bar ~= 2 then
      check.fail("%s is %s; must be {x, y, diameter = d}, two numbers in m and a diameter or an area", at,
        check.show(bar))
    end
    only(at, bar, { diameter = true, area = true })
    list[#list + 1] = { check.value(at, "x", bar[1], { "number", unit = "m" }),
      check.value(at, "y", bar[2], { "number", unit = "m" }), area = area_of(at, bar) }
  end
end

-- Bars of a layer: at one y, evenly from side to side between the covers.
local function add_layers(o, list)
  for i, layer in ipairs(o.layers or {}) do
    local at = ("%s, layer %d"):format(where, i)
    if type(layer) ~= "table" then check.fail("%s is %s; must be a table", at, check.show(layer)) end
    only(at, layer, { y = true, count = true, diameter = true })
    if not o.cover then
      check.fail("%s: field 'cover' is missing; give the concrete between the surface and the bars of layers, a number "
        .. "above 0 m", where)
    end
    local count = check.value(at, "count", layer.count, { "number", whole = true, at_least = 1 })
    local d = check.value(at, "diameter", layer.diameter, length)
    local y = check.value(at, "y", layer.y, { "number", unit = "m", also = { "top", "bottom" } })
    local x_most, y_most = o.width / 2 - o.cover - d / 2, o.depth / 2 - o.cover - d / 2
    if math.min(x_most, y_most) <= 0 then
      check.fail("%s: field 'cover' is %s m; with bars of %s m it must be below half of the smaller side, %s m", where,
        check.show(o.cover), check.show(d), check.show(math.min(o.width, o.depth) / 2 - d / 2))
    end
    if y == "top" then y = y_most elseif y == "bottom" then y = -y_most end
    for k = 1, count do
      local x = count > 1 and x_most * (2 * (k - 1) / (count - 1) - 1) or 0
      list[#list + 1] = { x, y, area = math.pi / 4 * d ^ 2 }
    end
  end
end

-- Strains of EN 1992-1-1, table 3.1, for a strength of cylinders, Pa; those of 90 MPa beyond it.
local function strains_of_en(fc)
  local f = math.min(fc / 1e6, 90)
  if f <= 50 then return { peak = 0.002, ultimate = 0.0035, exponent = 2, bars = Es } end
  local rest = ((90 - f) / 100) ^ 4
  local ultimate = 0.0026 + 0.035 * rest
  return { peak = math.min(0.002 + 0.085e-3 * (f - 50) ^ 0.53, ultimate), ultimate = ultimate,
    exponent = 1.4 + 23.4 * rest, bars = Es }
end

-- The block of ACI 318-19, 22.2.2: 0.003 at the edge, and beta_1 of the depth of the neutral axis.
local function strains_of_aci(fc)
  local beta_1 = math.max(0.65, math.min(0.85, 0.85 - 0.05 * (fc / 1e6 - 28) / 7))
  return { peak = 0.003, ultimate = 0.003, block = (1 - beta_1) * 0.003, bars = Es }
end

-- The strength of the concrete in the section, Pa, that of bars in compression, and the strains; nil: plastic.
local function strengths(o, fc, fy)
  local given = o.effectiveness and "effectiveness" or o.bar_compression and "bar_compression"
  local kind = o.strains or given and "plastic" or "EN 1992-1-1"
  if given and kind ~= "plastic" then
    check.fail("%s: field '%s' is for strains = 'plastic' alone; strains is '%s', where ultimate strains take its "
      .. "place", where, given, kind)
  end
  if kind == "EN 1992-1-1" then return fc, fy, strains_of_en(fc) end
  if kind == "ACI 318" then return 0.85 * fc, fy, strains_of_aci(fc) end
  return (o.effectiveness or plastic_effectiveness) * fc, o.bar_compression or math.min(fy, largest_compression)
end

--- What core.section takes.
function concrete.properties(given)
  local o = check.options(where, given, options)
  local fc = type(o.concrete) == "string" and grades.strength("concrete", o.concrete) or o.concrete
  local fy = type(o.steel) == "string" and grades.strength("bars", o.steel) or o.steel
  local bars = {}
  add_bars(o, bars)
  add_layers(o, bars)
  if #bars == 0 then
    check.fail("%s: it has no bars; give 'bars' = { {x, y, diameter = d}, ... } or 'layers' = { { y =, count =, "
      .. "diameter = }, ... } with 'cover', m; without bars there is no strength in tension", where)
  end
  local carried, bar_compression, strains = strengths(o, fc, fy)
  for _, bar in ipairs(bars) do bar.tension, bar.compression = fy, bar_compression end
  local s = shapes.solid { width = o.width, depth = o.depth }
  local factor = o.stiffness == "gross" and 1 or o.stiffness == "cracked" and cracked or o.stiffness
  return {
    kind = "concrete", outline = s.outline, size = s.size, area = s.area,
    Ix = factor * s.Ix, Iy = factor * s.Iy, mass_Ix = s.Ix, mass_Iy = s.Iy, J = s.J,
    shear_area_x = s.shear_area_x, shear_area_y = s.shear_area_y,
    reinforcement = { concrete = carried, bars = bars, strains = strains },
  }
end

return concrete

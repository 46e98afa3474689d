-- hinge.heat: what heat makes of steel, fire curves, and how hot steel becomes in them. EN 1993-1-2:2005, 3.2, 3.4 and
-- 4.2.5; EN 1991-1-2, 3.2.1.
local check = require "hinge.library.check"

local heat = {}

local room = 20 -- degrees Celsius
local coldest = -60 -- degrees Celsius; below 20 with 1.2e-5 1/K, as EN 1993-1-1, 3.2.6

-- Steel ---------------------------------------------------------------------------------------------------------------

-- Table 3.1: degrees Celsius, k_y (stress at a strain of 2 %), k_p (proportional limit), k_E.
local factors = {
  { coldest, 1, 1, 1 }, { 100, 1, 1, 1 }, { 200, 1, 0.807, 0.9 }, { 300, 1, 0.613, 0.8 }, { 400, 1, 0.42, 0.7 },
  { 500, 0.78, 0.36, 0.6 }, { 600, 0.47, 0.18, 0.31 }, { 700, 0.23, 0.075, 0.13 }, { 800, 0.11, 0.05, 0.09 },
  { 900, 0.06, 0.0375, 0.0675 }, { 1000, 0.04, 0.025, 0.045 }, { 1100, 0.02, 0.0125, 0.0225 },
}
local columns = { yield = 2, proportional = 3 }

-- 3.4.1.1 (1)
local function elongation_of_steel(t)
  if t < 750 then return 1.2e-5 * t + 0.4e-8 * t * t - 2.416e-4 end
  if t <= 860 then return 1.1e-2 end
  return 2e-5 * t - 6.2e-3
end

function heat.steel(options, ...)
  check.no_more("hinge.heat.steel", ...)
  local o = check.options("hinge.heat.steel", options or {}, {
    strength = { "string", default = "yield", one_of = { "yield", "proportional" } },
  })
  local out = { stiffness = {}, strength = {}, elongation = { { coldest, 1.2e-5 * (coldest - room) } } }
  for i, f in ipairs(factors) do
    out.stiffness[i] = { f[1], f[4] }
    out.strength[i] = { f[1], f[columns[o.strength]] }
  end
  for t = room, 1100, 5 do -- straight between two: right to 3e-8
    out.elongation[#out.elongation + 1] = { t, elongation_of_steel(t) }
  end
  return out
end

function heat.curve(...)
  check.no_more("hinge.heat.curve", ...)
  local out = {}
  for i, f in ipairs(factors) do out[i] = { f[1], f[2], f[3], f[4] } end
  return out
end

-- Fires ---------------------------------------------------------------------------------------------------------------

function heat.iso834(t, ...)
  check.no_more("hinge.heat.iso834", ...)
  check.value("hinge.heat.iso834", "time", t, { "number", unit = "s" })
  return t <= 0 and room or room + 345 * math.log(8 * t / 60 + 1, 10)
end

-- 3.4.1.2, J/(kg K). The peak at 735 degrees is that of the phase change.
local function specific_heat(t)
  if t < 600 then return 425 + 0.773 * t - 1.69e-3 * t ^ 2 + 2.22e-6 * t ^ 3 end
  if t < 735 then return 666 + 13002 / (738 - t) end
  if t < 900 then return 545 + 17820 / (t - 731) end
  return 650
end

local longest_step = 5 -- s: 4.2.5.1 (4)
local least_factor = 10 -- 1/m: 4.2.5.1 (5)
local steel_density = 7850 -- kg/m^3
local stefan_boltzmann = 5.67e-8 -- W/(m^2 K^4)

-- 4.2.5.1, eq 4.25: unprotected steel of uniform temperature.
function heat.unprotected(options, ...)
  check.no_more("hinge.heat.unprotected", ...)
  local o = check.options("hinge.heat.unprotected", options, {
    section_factor = { "number", unit = "1/m", at_least = least_factor },
    duration = { "number", unit = "s", above = 0 },
    fire = { "function", default = heat.iso834 },
    shadow = { "number", above = 0, at_most = 1, default = 1 },
    convection = { "number", unit = "W/(m^2 K)", at_least = 0, default = 25 },
    emissivity = { "number", at_least = 0, at_most = 1, default = 0.7 },
    every = { "number", unit = "s", above = 0, default = 60 },
  })
  local per_kelvin = o.shadow * o.section_factor / steel_density
  local steel, points = room, { { 0, room } }
  local steps = math.ceil(o.duration / longest_step)
  local dt, last = o.duration / steps, 0
  for i = 1, steps do
    local t = i * dt
    local gas = o.fire(t - dt / 2)
    if type(gas) ~= "number" or gas ~= gas then
      check.fail("hinge.heat.unprotected: the function in field 'fire' returned %s at t = %g s; it must return the "
        .. "temperature of the gas in degrees Celsius", check.show(gas), t - dt / 2)
    end
    local net = o.convection * (gas - steel)
      + o.emissivity * stefan_boltzmann * ((gas + 273) ^ 4 - (steel + 273) ^ 4)
    steel = steel + per_kelvin / specific_heat(steel) * net * dt
    if t - last >= o.every * (1 - 1e-9) or i == steps then
      points[#points + 1], last = { t, steel }, t
    end
  end
  return points
end

return check.strict(heat, "hinge.heat")

---@meta
-- Heat ----------------------------------------------------------------------------------------------------------------

---What heat makes of steel, fire curves, and how hot steel becomes in them.
---@class hinge.heats
local heat = {}

---Properties of a material over its temperature, for model:heat: points { degrees Celsius, value }, straight between.
---@class hinge.heat_properties
---@field stiffness number[][] E over that of the declared material, 0.001 or more; G changes alike
---@field strength number[][] the same of the yield stress, 0.001 or more; hardening and backbone change alike
---@field elongation number[][] strain without stress

---Carbon steel by EN 1993-1-2:2005, table 3.1 and 3.4.1.1, from -60 to 1100 degrees Celsius. strength: "yield", k_y,
---the stress at a strain of 2 %, the default; or "proportional", k_p, where hot steel begins to yield.
---```lua
---local safe = hinge.heat.steel { strength = "proportional" }
---print(safe.strength[6][1], safe.strength[6][2]) -- 500 degrees Celsius, 0.36
---```
---@param options? { strength?: "yield"|"proportional" }
---@return hinge.heat_properties
function heat.steel(options) end

---The factors of carbon steel in EN 1993-1-2:2005, table 3.1, for `hot_curve` of a material: points { degrees Celsius,
---k_y, k_p, k_E }, straight between. With them a heated section begins to yield at the proportional limit k_p f_y. Its
---strength grows along the ellipse of figure 3.1, up to k_y f_y at a strain of 2 %, with the mean plastic strain of the
---part of the element that yields with it. In tension that is exact. The strength of model:heat must be k_y, as it is
---by default; below 100 degrees nothing changes. Raises an error where E is too small beside the yield stress for an
---ellipse up to 2 %.
---```lua
---local steel = hinge.material.steel("S355", { hot_curve = hinge.heat.curve() })
---print(steel.laws) -- curve of EN 1993-1-2
---```
---@return number[][]
function heat.curve() end

---Temperature of the gas in the standard fire ISO 834 (EN 1991-1-2, 3.2.1): 20 + 345 log10(8 t / 60 s + 1).
---```lua
---print(hinge.heat.iso834(1800)) -- 841.8 degrees Celsius after half an hour
---```
---@param time number s
---@return number temperature degrees Celsius
function heat.iso834(time) end

---Temperature of unprotected steel in a fire over time, in steps of 5 s (EN 1993-1-2, 4.2.5.1, eq 4.25). What it
---returns is for the field temperature of model:heat.
---```lua
---local points = hinge.heat.unprotected { section_factor = 140, duration = 1800 }
---print(points[#points][1], points[#points][2]) -- s, degrees Celsius
---```
---@param options hinge.unprotected_options
---@return number[][] points { time in s, degrees Celsius }
function heat.unprotected(options) end

---@class hinge.unprotected_options
---@field section_factor number 1/m, surface over volume of the steel, A_m/V; 10 or more
---@field duration number s
---@field fire? fun(time: number): number temperature of the gas, degrees Celsius; default: hinge.heat.iso834
---@field shadow? number k_sh, factor on the heat that comes in, above 0 to 1; default 1
---@field convection? number W/(m^2 K), default 25
---@field emissivity? number of steel and fire together, 0 to 1; default 0.7
---@field every? number s between two points, default 60

---@meta hinge
-- Every call that a script can make, for editors that read LuaLS annotations. Nothing in this file runs.
--
-- All units are SI: m, kg, s, N, Pa, rad. Wrong input raises an error at the line of the script. The message names the
-- function, the field, the value, its unit and the allowed values. A failure of the physics or of the numerics is a
-- result, never an error: see run.verdict. "eq" and "section" refer to Lynn and Isobe's paper on the ASI-Gauss
-- technique. What the calls take and return is in the files of words, one for each part.
--
-- program/reference.lua makes the page of `hinge reference` from them. The description of a class, an alias, a function
-- or a field stands in the lines above it; a short description of a field stands after it on the same line. The
-- description of a parameter or a result stands after it, and goes on in lines below that begin with `---` and two
-- blanks. The Lua code above a function is its example. It runs after the lines at the top of that page, and a test
-- runs every example.

---@class hinge
---@field version string
---@field section hinge.sections ready shapes, and any other section by its properties
---@field record hinge.records ground motion from files
---@field import hinge.imports frames from files of other programs
---@field heat hinge.heats properties of steel in fire, fire curves, temperatures
---@field results hinge.results tables for a report: forces of members, envelopes, utilisation, storeys, reactions
---units as numbers of SI: 4 * hinge.units.kN / hinge.units.m is 4000. m, mm, cm, km, inch, ft; kg, t, lb; s, ms, min,
---h, Hz, kmh; N, kN, MN, lbf, kip, kgf, tonf (of the metric ton); Pa, kPa, MPa, GPa, psi, ksi, psf; J, kJ, MJ; rad,
---mrad, deg; gravity
---@field units table<string, number>
local hinge = {}

---@alias vec3 number[] three numbers { x, y, z }
---@alias hinge.component "ux"|"uy"|"uz"|"rx"|"ry"|"rz" displacement (m) or rotation vector (rad), in space

return hinge

-- Units as numbers of SI: 4 * kN / m is 4000 N/m. hinge computes in m, kg, s, N, Pa and rad.
--
-- There is no g, for it would be gram and gravity. Exact by definition: the inch (0.0254 m), the pound (0.45359237 kg),
-- standard gravity (9.80665 m/s^2). tonf is the force of the metric ton.
local check = require "hinge.library.check"

local inch, pound, gravity = 0.0254, 0.45359237, 9.80665
local lbf = pound * gravity

return check.strict({
  m = 1, mm = 1e-3, cm = 1e-2, km = 1e3, inch = inch, ft = 12 * inch,
  kg = 1, t = 1e3, lb = pound,
  s = 1, ms = 1e-3, min = 60, h = 3600, Hz = 1, kmh = 1 / 3.6,
  N = 1, kN = 1e3, MN = 1e6, lbf = lbf, kip = 1e3 * lbf, kgf = gravity, tonf = 1e3 * gravity,
  Pa = 1, kPa = 1e3, MPa = 1e6, GPa = 1e9, psi = lbf / inch ^ 2, ksi = 1e3 * lbf / inch ^ 2,
  psf = lbf / (12 * inch) ^ 2,
  J = 1, kJ = 1e3, MJ = 1e6,
  rad = 1, mrad = 1e-3, deg = math.pi / 180,
  gravity = gravity,
}, "hinge.units")

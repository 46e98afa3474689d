-- Ground motion: a record of accelerations as the path of a support.
local check = require "hinge.library.check"

-- Acceleration linear between the record's values, so velocity and displacement are exact
-- polynomials from value to value.
return function(options, ...)
  check.no_more("hinge.ground", ...)
  local o = check.options("hinge.ground", options, {
    dt = { "number", unit = "s", above = 0 },
    acceleration = { "numbers", unit = "m/s^2" },
    scale = { "number", default = 1 },
  })
  local dt, a = o.dt, o.acceleration
  local v, u = { 0 }, { 0 }
  for i = 1, #a - 1 do
    v[i + 1] = v[i] + (a[i] + a[i + 1]) * dt / 2
    u[i + 1] = u[i] + v[i] * dt + (2 * a[i] + a[i + 1]) * dt ^ 2 / 6
  end
  local n = #a
  return function(t)
    if t <= 0 then return 0 end
    local i = math.min(n, math.floor(t / dt) + 1)
    local s = t - (i - 1) * dt
    if i == n then return o.scale * (u[n] + v[n] * s) end
    return o.scale * (u[i] + v[i] * s + a[i] * s ^ 2 / 2 + (a[i + 1] - a[i]) / dt * s ^ 3 / 6)
  end
end

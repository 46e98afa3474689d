-- Williams' toggle: two shallow beams, clamped at their feet and joined rigidly at the top, with two rises.
--
-- Run     hinge run scripts/benchmarks/williams_toggle.lua
-- Shows   snap-through with bending; the higher toggle has a limit load, the lower one softens and hardens again
-- Expect  rise 0.386 in: limit 33.87 lb at 0.2322 in, least load 31.28 lb at 0.3916 in; rise 0.32 in: no limit load
local hinge = require "hinge"
local turn = require "hinge.library.numeric".turn

local inch, lb, psi = hinge.units.inch, hinge.units.lbf, hinge.units.psi
local span = 12.943 -- half of it, in

-- EA (lb), EI (lb in^2); the reference does not shear: the shear areas are 1000 times the area.
local function toggle(rise, EA, EI, elements)
  local E = 1.03e7
  local A, I = EA / E * inch ^ 2, EI / E * inch ^ 4
  local section = hinge.section.general { area = A, Ix = I, Iy = 100 * I, J = I, shear_area_x = 1000 * A,
    shear_area_y = 1000 * A }
  local steel = hinge.material { E = E * psi }
  local model = hinge.model { plasticity = false, elements_per_member = elements }
  local left, right = model:node { -span * inch, 0, 0 }, model:node { span * inch, 0, 0 }
  local top = model:node { 0, 0, rise * inch }
  model:fix { left, right }
  model:fix(top, "x,y,rx,ry,rz")
  model:member { left, top, section = section, material = steel }
  model:member { top, right, section = section, material = steel }
  model:load { node = top, force = { 0, 0, -lb } }
  return model, top
end

-- The turns of the load on the way down to 0.7 in: { { w, P }, ... }, and the path.
local function follow(model, top)
  local path, turns = { { x = 0, y = 0 } }, {}
  local run = model:static { steps = 140, control = { node = top, "uz", to = -0.7 * inch } }
  for _ in run:steps() do
    path[#path + 1] = { x = -select(3, run:displacement(top)) / inch, y = run.factor }
    local p, q, r = path[#path - 2], path[#path - 1], path[#path]
    if p and (q.y - p.y) * (r.y - q.y) < 0 then turns[#turns + 1] = { turn(p, q, r) } end
  end
  return turns, path
end

-- The load at the deflection w, in.
local function at(model, top, w)
  return model:static { steps = 5, control = { node = top, "uz", to = -w * inch } }:finish().factor
end

return hinge.benchmark {
  title = "Williams' toggle", kind = "stability",
  source = "F. W. Williams, Q. J. Mech. Appl. Math. 17 (1964); values computed apart, without shear",
  run = function(b, job)
    local elements, count = 8, 16
    local high, top = toggle(0.386, 1.03e7 * 0.753 * 0.243, 1.03e7 * 0.753 * 0.243 ^ 3 / 12, elements)
    local turns, path = follow(high, top)
    for i, o in ipairs { { "limit load", 33.870, 0.2322 }, { "least load", 31.282, 0.3916 } } do
      b:row { "rise .386: " .. o[1], computed = turns[i][2], reference = o[2], unit = "lb", tolerance = 2e-5,
        elements = count, steps = 140 }
      b:row { ("rise .386: w at the %s"):format(o[1]), computed = turns[i][1], reference = o[3], unit = "in",
        tolerance = 2e-4, elements = count, steps = 140 }
    end
    b:row { "rise .386: P at w = .7", computed = at(high, top, 0.7), reference = 88.184, unit = "lb",
      tolerance = 2e-5, elements = count, steps = 5 }
    local low, crown = toggle(0.32, 1.885e6, 9270, elements)
    local values = { { 0.1, 19.222 }, { 0.2, 25.823 }, { 0.3, 27.655 }, { 0.5, 46.720 } }
    for _, o in ipairs(values) do
      b:row { ("rise .32: P at w = %g"):format(o[1]), computed = at(low, crown, o[1]), reference = o[2], unit = "lb",
        tolerance = 4e-5, elements = count, steps = 5 }
    end
    local none, second = follow(low, crown)
    b:row { "rise .32: number of limit loads", computed = #none, reference = 0, scale = 1, tolerance = 1e-6,
      elements = count, steps = 140 }

    local function curve(of, name)
      local made = { x = {}, y = {}, name = name }
      for i, p in ipairs(of) do made.x[i], made.y[i] = p.x, p.y end
      return made
    end
    local points = { x = { 0.2322, 0.3916, 0.5, 0.7 }, y = { 33.870, 31.282, 36.097, 88.184 }, name = "reference",
      style = "points" }
    for _, o in ipairs(values) do points.x[#points.x + 1], points.y[#points.y + 1] = o[1], o[2] end
    job:plot({ series = { curve(path, "rise 0.386 in"), curve(second, "rise 0.32 in"), points },
      x_label = "deflection of the top, in", y_label = "load, lb", title = "Williams' toggle" }, "williams_toggle.png")
  end,
}

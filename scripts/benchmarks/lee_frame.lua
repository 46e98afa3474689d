-- Lee's frame: two legs of 120, hinged at both feet, loaded on the beam 24 from the corner; it snaps through and back.
--
-- Run     hinge run scripts/benchmarks/lee_frame.lua
-- Shows   arc length along a path on which the load and both displacements turn, and control by a displacement
-- Expect  largest load 1.8557, least load -0.9414; u is to the side and v down, both at the load. The reference comes
--         from shooting: x' = e cos t, z' = e sin t, t' = M / EI with e = 1 + N / EA, Runge-Kutta with 600 steps, and
--         Newton's method for both reactions, the rotation of the foot and P. It does not shear. Without the strain
--         N / EA P at v = 10 is 0.96440; with curvature per length of the strained axis it is 0.96364
local hinge = require "hinge"
local turn = require "hinge.library.numeric".turn

local elements = 4 -- on 24 units of length
local function frame(load)
  local model = hinge.model { plasticity = false, elements_per_member = elements }
  -- A = 6, I = 2; the reference does not shear: the shear areas are 1000 times the area.
  local section = hinge.section.general { area = 6, Ix = 2, Iy = 20, J = 2, shear_area_x = 6000, shear_area_y = 6000 }
  local steel = hinge.material { E = 720 }
  local n = {}
  for i, at in ipairs { { 0, 0 }, { 0, 120 }, { 24, 120 }, { 120, 120 } } do
    n[i] = model:node { at[1], 0, at[2] }
    model:fix(n[i], (i == 1 or i == 4) and "x,y,z,rx,rz" or "y,rx,rz")
  end
  for i, count in ipairs { 5 * elements, elements, 4 * elements } do
    model:member { n[i], n[i + 1], section = section, material = steel, elements = count }
  end
  model:load { node = n[3], force = { 0, 0, -load } }
  return model, n[3]
end

-- The first point after `from` at which `name` turns: the value there, and what `by` is there.
local function turns(path, name, by, from)
  for i = from + 1, #path - 1 do
    local p, q, r = path[i - 1], path[i], path[i + 1]
    if (q[name] - p[name]) * (r[name] - q[name]) < 0 then
      local x, y = turn({ x = p[by], y = p[name] }, { x = q[by], y = q[name] }, { x = r[by], y = r[name] })
      return y, x, i
    end
  end
end

local reference = { { 10, 0.963551 }, { 20, 1.345791 }, { 30, 1.595295 }, { 40, 1.780782 } } -- v and P

return hinge.benchmark {
  title = "Lee's frame", kind = "stability",
  source = "frame: S.-L. Lee, F. S. Manuel, E. C. Rossow 1968; values by shooting (see the head of the file)",
  run = function(b, job)
    local count = 10 * elements
    local model, loaded = frame(1)
    for _, point in ipairs(reference) do
      local run = model:static { steps = 5, control = { node = loaded, "uz", to = -point[1] } }:finish()
      b:row { ("P at v = %d"):format(point[1]), computed = run.factor, reference = point[2], tolerance = 3e-5,
        elements = count, steps = 5 }
    end
    local path = { { u = 0, v = 0, P = 0 } }
    local arc = model:static { control = { "arc", to = 3 }, steps = 400 }
    for _ in arc:steps() do
      local u, _, w = arc:displacement(loaded)
      path[#path + 1] = { u = u, v = -w, P = arc.factor }
    end
    local row = b:rows_with { elements = count, steps = arc.index }
    local most, u, at = turns(path, "P", "u", 2)
    row("largest P", most, 1.855673, nil, 4e-5)
    row("u at the largest P", u, 26.8808, nil, 1.5e-4)
    local v_most, _, there = turns(path, "v", "u", at)
    row("v turns back at", v_most, 61.00298, nil, 1e-5)
    local v_least = turns(path, "v", "u", there + 1)
    row("v turns forth at", v_least, 50.74683, nil, 1e-5)
    local least, u_least = turns(path, "P", "u", at + 1)
    row("least P", least, -0.941443, nil, 2e-4)
    row("u at the least P", u_least, 90.1951, nil, 5e-5)

    local found = { x = {}, y = {}, name = "hinge, arc length" }
    for i, p in ipairs(path) do found.x[i], found.y[i] = p.v, p.P end
    local points = { x = { 48.735, 58.216 }, y = { 1.855673, -0.941443 }, name = "shooting", style = "points" }
    for _, point in ipairs(reference) do
      points.x[#points.x + 1], points.y[#points.y + 1] = point[1], point[2]
    end
    job:plot({ series = { found, points }, x_label = "deflection v under the load", y_label = "load P",
      title = "Lee's frame", y_range = { -2, 3 }, lines = { { x = 61.003, name = "v turns" }, { x = 50.747 } } },
      "lee_frame.png")
  end,
}

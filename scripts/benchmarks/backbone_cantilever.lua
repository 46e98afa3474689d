-- A cantilever whose root follows a backbone with a fall, and one that is driven to and fro.
--
-- Run     hinge run scripts/benchmarks/backbone_cantilever.lua
-- Shows   that the hinge of a backbone is the same with two, four and eight elements, and the work of its cycles
-- Expect  the moment at the root over its plastic rotation as the backbone gives it: straight from the yield to the
--         cap, down to the residual strength. The plastic rotation is that of the tip less the elastic one. The work is
--         the area of the backbone. A hinge of constant strength that is driven to +-a takes 4 F (a - F / k) in a
--         closed cycle, F = Mp / L, k the stiffness of the cantilever.
local hinge = require "hinge"

local E, fy, L = 200e9, 345e6, 3
local steel = hinge.material { E = E, yield_stress = fy }
local section = hinge.section.h { depth = 0.4, width = 0.2, web = 0.01, flange = 0.015 }
local Mp = fy * section.Zx
local F, k = Mp / L, 1 / (L ^ 3 / (3 * E * section.Ix) + L / (steel.G * section.shear_area_y))
local backbone = hinge.backbone { yield = 1.1, cap_rotation = 0.025, cap_strength = 1.2, post_cap_rotation = 0.16,
  residual = 0.4 }

-- The same by hand: strength over Mp.
local function strength(rotation)
  if rotation <= 0.025 then return 1.1 + 0.1 * rotation / 0.025 end
  local falling = 1.2 * (1 - (rotation - 0.025) / 0.16)
  return falling > 0.44 and falling or 0.44
end

-- Drives the tip to one displacement after the other: plastic rotation, M / Mp at each step; the work of each part.
local function driven(elements, law, turns, steps)
  local model = hinge.model { displacement = "small" }
  local root, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(root)
  model:member { root, tip, section = section, material = steel, up = { 0, 0, 1 }, elements = elements,
    backbone = law }
  model:load { node = tip, force = { 0, 0, F } }
  local rotation, M, work, run = {}, {}, {}, nil
  for i, to in ipairs(turns) do
    run = model:static { from = run, steps = steps, control = { node = tip, "uz", to = to } }
    while run:step() do
      rotation[#rotation + 1] = (select(3, tip:displacement(run)) - run.factor * F / k) / L
      M[#M + 1] = run.factor
    end
    assert(run.verdict == "completed", run.reason)
    work[i] = run.energy.plastic
  end
  return rotation, M, work
end

return hinge.benchmark {
  title = "Cantilever with a backbone", kind = "inelastic", fast = true,
  source = "closed forms: the backbone, its area",
  run = function(b, job)
    local series = {}
    for _, elements in ipairs { 2, 4, 8 } do
      local rotation, M, work = driven(elements, backbone, { 0.19 * L }, 40)
      local worst = { off = -1 }
      for i = 1, #M do
        local off = rotation[i] > 1e-9 and math.abs(M[i] / strength(rotation[i]) - 1) or 0
        if off ~= off or off > worst.off then worst = { off = off, M = M[i], by_hand = strength(rotation[i]) } end
      end
      b:row { ("M / Mp, worst of all steps, %d elements"):format(elements), computed = worst.M,
        reference = worst.by_hand, tolerance = 1e-6, elements = elements, steps = 40 }
      if elements == 8 then
        local residual = 0.025 + 0.16 * (1 - 0.44 / 1.2)
        local area = 0.025 * 1.15 + (residual - 0.025) * (1.2 + 0.44) / 2 + (rotation[#M] - residual) * 0.44
        b:row { "work of the push", computed = work[1], reference = area * Mp, unit = "J", tolerance = 1e-6,
          elements = 8, steps = 40 }
      end
      series[#series + 1] = { x = rotation, y = M, name = elements .. " elements", style = "points" }
    end
    local a = 3 * F / k
    local _, _, work = driven(2, nil, { a, -a, a }, 20)
    b:row { "work of a closed cycle, no fall", computed = work[2] + work[3], reference = 4 * F * (a - F / k),
      unit = "J", tolerance = 1e-6, elements = 2, steps = 60 }
    local line = { x = {}, y = {}, name = "by hand" }
    for i = 0, 180 do line.x[i + 1], line.y[i + 1] = i / 1000, strength(i / 1000) end
    series[#series + 1] = line
    job:plot({ series = series, x_label = "plastic rotation (rad)", y_label = "M / Mp",
      title = "A backbone with a fall" }, "backbone_cantilever.png")
  end,
}

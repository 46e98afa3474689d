-- What joints, floors, damping and idle effects cost in a step: a frame of 168 elements that loses a corner column.
--
-- Run     hinge run tests/bench/ties.lua joints=yes floors=yes        each of them "no" by default
-- Shows   processor time of a step of 1 ms, ms, and where the joint above the lost column is at the end, m
local hinge = require "hinge"

local function at(i, j, k) return ("%d %d %d"):format(i, j, k) end

return hinge.scenario {
  parameters = { joints = "no", floors = "no", damping = "no", ground = "no", contact = "no", bays = 2, storeys = 4,
    steps = 500 },
  run = function(p)
    local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 325e6 }
    local column = hinge.section.box { width = 0.35, depth = 0.35, thickness = 0.016 }
    local beam = hinge.section.box { width = 0.2, depth = 0.45, thickness = 0.012 }
    local joint = hinge.joint { Mx = { stiffness = 5e7 } }
    local ends = p.joints == "yes" and { a = joint, b = joint } or nil
    local model, node = hinge.model(), {}
    for i = 0, p.bays do
      for j = 0, p.bays do
        for k = 0, p.storeys do node[at(i, j, k)] = model:node { 6 * i, 6 * j, 3.5 * k } end
      end
    end
    local function member(a, b, section, group)
      model:member { node[a], node[b], section = section, material = steel, group = group,
        ends = section == beam and ends or nil }
    end
    for k = 1, p.storeys do
      local floor = {}
      for i = 0, p.bays do
        for j = 0, p.bays do
          if k == 1 then model:fix(node[at(i, j, 0)]) end
          member(at(i, j, k - 1), at(i, j, k), column, i + j == 0 and k == 1 and "lost" or "frame")
          if i > 0 then member(at(i - 1, j, k), at(i, j, k), beam, "frame") end
          if j > 0 then member(at(i, j - 1, k), at(i, j, k), beam, "frame") end
          model:mass { node = node[at(i, j, k)], mass = 5000 }
          floor[#floor + 1] = node[at(i, j, k)]
        end
      end
      if p.floors == "yes" then model:diaphragm { nodes = floor, normal = "z" } end
    end
    model:gravity { 0, 0, -9.81 }
    if p.damping == "yes" then model:damping { alpha = 0.1, beta = 1e-3 } end
    if p.ground == "yes" then model:ground {} end
    if p.contact == "yes" then model:contact {} end
    local rest = model:static { steps = 1 }:finish()
    model:fracture { group = "lost", where = "all", rule = function() return true end }
    local begun = os.clock()
    local run = model:dynamic { from = rest, dt = 1e-3, duration = 1e-3 * p.steps }:finish()
    local ms = 1e3 * (os.clock() - begun) / p.steps
    local _, _, uz = node[at(0, 0, 1)]:displacement(run)
    print(("%.3f ms a step, uz %.12f m, energy error %.1e"):format(ms, uz, run.energy_error))
    return { ms = ms, uz = uz }
  end,
}

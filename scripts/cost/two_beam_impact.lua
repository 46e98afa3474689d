-- What time steps cost in an impact: the paper's two beams (figure 13), during contact and shortly after it.
--
-- Run     hinge cost scripts/cost/two_beam_impact.lua --within 1%   (any parameter: elements_per_member=4 speed=20)
-- Shows   a free beam falls on a clamped one at 50 m/s, with surface contact of a given stiffness; Newmark's beta 1/4
--         and the paper's 0.4
-- Expect  second order in dt with both. beta 1/4 has a fraction of the error at the same step. elements_per_member is
--         no accuracy setting here: an element that is hit vibrates at its own frequency, so the momentum at a given
--         time does not converge
local hinge = require "hinge"

return hinge.scenario {
  -- m, m/s, N/m, *reconstructed*
  parameters = { length = 1.0, thickness = 0.05, gap = 0.06, speed = 50.0, stiffness = 2e9,
    duration = 2e-3, elements_per_member = 2 }, -- s
  accuracy = { dt = { 2.5e-6, 5e-6, 1e-5, 2e-5 }, beta = { 0.25, 0.4 } },
  run = function(p)
    local model = hinge.model { elements_per_member = p.elements_per_member, p_delta = "chord",
      interaction = "paper" } -- as in the paper
    local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850 }
    local square = hinge.section.solid { width = p.thickness, depth = p.thickness }
    local half = p.length / 2
    local function beam(group, a, b, c)
      local ends = { model:node(a), model:node(b), model:node(c) }
      model:member { ends[1], ends[2], section = square, material = steel, group = group }
      model:member { ends[2], ends[3], section = square, material = steel, group = group }
      return ends
    end
    local fixed = beam("clamped", { -half, 0, 0 }, { 0.05, 0, 0 }, { half, 0, 0 })
    local free = beam("free", { 0, -half, p.gap }, { 0, 0.05, p.gap }, { 0, half, p.gap })
    model:fix { fixed[1], fixed[3] }
    model:velocity("free", { 0, 0, -p.speed })
    model:contact { rule = "surface", stiffness = p.stiffness }
    local run = model:dynamic { dt = p.dt, duration = p.duration, beta = p.beta }
    run:probe { node = free[2], "uz", name = "free middle" }
    run:probe { node = fixed[2], "uz", name = "clamped middle" }
    run:finish()
    return { momentum = run:momentum().linear[3], kinetic = run.energy.kinetic, touched = run.contacts.bound }
  end,
}

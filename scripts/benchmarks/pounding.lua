-- Pounding: two masses on springs, side by side, that knock against each other.
--
-- Run     hinge run scripts/benchmarks/pounding.lua
-- Shows   what contact gives from one vibrating body to the other
-- Expect  the velocities of an elastic impact: 1/3 of its amplitude stays with a mass that strikes one half as large
--
-- Both masses have the same frequency and just touch at rest. The first one was pulled away by 50 mm and let
-- go. It arrives at the place of rest with its greatest speed v. Afterwards their amplitudes are v1 / w and v2 / w with
-- v1 = v (m1 - m2) / (m1 + m2), v2 = v 2 m1 / (m1 + m2). The contact is softer than the bars, and much stiffer than the
-- springs. Amplitudes here are parts of the first one. While they touch, the masses move on by 0.007 of it.
local hinge = require "hinge"

local side, L, m1, omega, pulled = 0.1, 0.2, 200, 20, 0.05 -- m, m, kg, rad/s, m
local T = 2 * math.pi / omega
local section = hinge.section.solid { width = side, depth = side }

-- Sends the first mass off with the speed v. Returns the amplitudes of both masses after the impact, and the run.
local function knock(m2)
  local model = hinge.model { plasticity = false }
  local ends = {}
  for i, mass in ipairs { m1, m2 } do
    local x, group = (i - 1) * (L + side), "body " .. i
    local a, b = model:node { x, 0, 0 }, model:node { x + L, 0, 0 }
    model:fix({ a, b }, "y,z,rx,ry,rz")
    model:member { a, b, section = section, material = hinge.material { E = 206e9, density = mass / (side ^ 2 * L) },
      group = group }
    model:connector { a, ground = true, stiffness = { x = mass * omega ^ 2 } }
    ends[i] = { a, b }
  end
  model:contact { between = { "body 1", "body 2" }, stiffness = 2e9 }
  model:velocity("body 1", { pulled * omega, 0, 0 })
  local run = model:dynamic { dt = 1e-5, duration = 0.45 * T, record = false }
  local one, two = run:probe { node = ends[1][1], "ux" }, run:probe { node = ends[2][1], "ux" }
  run:finish()
  local early = 0.3 * T -- both have turned by then; they meet again at T / 2
  local first, second = 0, 0
  for i, t in ipairs(one.time) do
    if t < early then
      first = math.abs(one.value[i]) > math.abs(first) and one.value[i] or first
      second = math.abs(two.value[i]) > math.abs(second) and two.value[i] or second
    end
  end
  return first, second, run
end

return hinge.benchmark {
  title = "Pounding of two oscillators", kind = "dynamics", fast = true, source = "closed form: elastic impact",
  run = function(b)
    for _, case in ipairs { { 1, 0, 1, 0.012 }, { 0.5, 1 / 3, 4 / 3, 1e-3 }, { 2, -1 / 3, 2 / 3, 1e-3 } } do
      local ratio, first, second, tolerance = table.unpack(case)
      local one, two, run = knock(ratio * m1)
      local function row(what, computed, reference)
        b:row { what, computed = computed / pulled, reference = reference, tolerance = tolerance, scale = 1,
          elements = 4, steps = run.index }
      end
      row(("m2 = %g m1: amplitude of m1"):format(ratio), one, first)
      row(("m2 = %g m1: amplitude of m2"):format(ratio), two, second)
    end
  end,
}

-- Frame 5 of Ziemian and Ziemian, linear: two bays, the left one two storeys high without a beam at half height.
--
-- Run     hinge run scripts/benchmarks/ziemian_5.lua
-- Shows   linear analysis of an unsymmetrical frame on pinned feet, plumb, with the full E of 29,000 ksi
-- Expect  sway and reactions that were published with the tests of another program, within 0.003 %
local hinge = require "hinge"

local inch, kip, ksi = hinge.units.inch, hinge.units.kip, hinge.units.ksi
local steel = hinge.material { E = 29000 * ksi }
-- The members of the reference have no shear deformation: the shear areas are 1000 times the area.
local function section(A, I)
  A, I = A * inch ^ 2, I * inch ^ 4
  return hinge.section.general { area = A, Ix = I, Iy = I, J = I, shear_area_x = 1000 * A, shear_area_y = 1000 * A }
end
local outer, middle = section(11.7, 146), section(17.1, 228)
local lower, upper = section(8.85, 291), section(14.7, 800)

local model = hinge.model { displacement = "small", plasticity = false }
local at = {}
local function node(x, z)
  local made = model:node { x * inch, 0, z * inch }
  model:fix(made, z == 0 and "x,y,z,rx,rz" or "y,rx,rz")
  at[x .. "," .. z] = made
  return made
end

-- A line of members from one node to the next.
local function line(section_of_it, nodes)
  for i = 2, #nodes do model:member { nodes[i - 1], nodes[i], section = section_of_it, material = steel } end
end

local function load(joint, H, V) model:load { node = joint, force = { H * kip, 0, -V * kip } } end

local function build()
  local feet = { node(0, 0), node(288, 0), node(504, 0) }
  local left = { node(0, 240), node(72, 240), node(144, 240), node(216, 240), node(288, 240) }
  local right = { node(288, 144), node(342, 144), node(396, 144), node(450, 144), node(504, 144) }
  local half = node(0, 144)
  line(outer, { feet[1], half, left[1] })
  line(middle, { feet[2], right[1], left[5] })
  line(outer, { feet[3], right[5] })
  line(upper, left)
  line(lower, right)
  for i = 1, 5 do
    local ends = (i == 1 or i == 5) and 0.5 or 1
    load(left[i], i == 5 and -2.3362 or 0, 39.394 * ends)
    load(right[i], i == 1 and -2.3362 or i == 5 and -3.5042 or 0, 29.546 * ends)
  end
end

return hinge.benchmark {
  title = "Ziemian and Ziemian 2021, frame 5, linear", kind = "stability", fast = true,
  source = "frame: C. W. Ziemian, R. D. Ziemian 2021; values: tests of Hephaestus.jl (A. Akchurin)",
  run = function(b)
    build()
    model:static { steps = 1 }:finish()
    local row = b:rows_with { tolerance = 5e-5, elements = 26 }
    row("u at the left corner", at["0,240"]:displacement() / inch, -1.1384, "in")
    row("u of the left column at 12 ft", at["0,144"]:displacement() / inch, -1.5903, "in")
    row("u of the right corner", at["504,144"]:displacement() / inch, -0.65758, "in")
    row("mid upper beam, v", select(3, at["144,240"]:displacement()) / inch, -1.5327, "in")
    row("H of the middle foot", at["288,0"]:reaction() / kip, 7.8139, "kip")
    row("V of the middle foot", select(3, at["288,0"]:reaction()) / kip, 146.73, "kip")
  end,
}

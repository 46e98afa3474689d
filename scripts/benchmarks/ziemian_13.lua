-- Frame 13 of Ziemian and Ziemian: three bays of 20 ft, ten storeys of 9.5 ft, fixed feet, second order under wind.
--
-- Run     hinge run scripts/benchmarks/ziemian_13.lua
-- Shows   sway of a tall slender frame out of plumb by 1/500, with 0.8 E, and its buckling factor
-- Expect  values that were computed apart, since no published ones were at hand: corotational elements of a beam with
--         bowing, six a member, and their eigenvalue
--
-- The combination of loads is not confirmed. Here it is 1.2 D + L + W with half the load L on the roof. The walls stand
-- on the outer columns.
local hinge = require "hinge"

local inch, kip, ksi, ft = hinge.units.inch, hinge.units.kip, hinge.units.ksi, hinge.units.ft
local steel = hinge.material { E = 0.8 * 29000 * ksi }
-- A (in^2), I (in^4). The members of the reference have no shear deformation: the shear areas are 1000 times the area.
local function section(A, I)
  A, I = A * inch ^ 2, I * inch ^ 4
  return hinge.section.general { area = A, Ix = I, Iy = 10 * I, J = I, shear_area_x = 1000 * A,
    shear_area_y = 1000 * A }
end

-- W8x67, 58, 48, 35, 24 outside and W10x68, W8x58, 48, 31, 18 inside, two storeys each.
local outer = { section(19.7, 272), section(17.1, 228), section(14.1, 184), section(10.3, 127), section(7.08, 82.7) }
local inner = { section(19.9, 394), section(17.1, 228), section(14.1, 184), section(9.13, 110), section(5.26, 61.9) }
local W16, W14x30, W14x26 = section(9.13, 375), section(8.85, 291), section(7.69, 245)
local W14x22, W12 = section(6.49, 199), section(6.48, 156)
local beams = { W16, W16, W14x30, W14x30, W14x26, W14x26, W14x22, W14x22, W14x22, W12 }

-- Under `times` the loads. Returns the model and the joints of the left column.
local function build(displacement, times)
  local model = hinge.model { displacement = displacement, plasticity = false, elements_per_member = 4 }
  local joint = {}
  for storey = 0, 10 do
    local z, roof = 9.5 * storey, storey == 10
    joint[storey] = {}
    for i = 1, 4 do
      local here = model:node { (20 * (i - 1) + z / 500) * ft, 0, z * ft }
      joint[storey][i] = here
      model:fix(here, storey == 0 and "all" or "y,rx,rz")
      if storey > 0 then
        local pair, outside = (storey + 1) // 2, i == 1 or i == 4
        model:member { joint[storey - 1][i], here, section = (outside and outer or inner)[pair], material = steel }
        if outside and not roof then model:load { node = here, force = { 0, 0, -times * 1.2 * 9.234 * kip } } end
      end
    end
    if storey > 0 then
      local wind = roof and 3.189 or 6.379
      model:load { node = joint[storey][1], force = { times * wind * kip, 0, 0 } }
      local q = roof and 1.2 * 1.034 + 0.5 * 0.778 or 1.2 * 1.069 + 0.778
      for i = 1, 3 do
        local beam = model:member { joint[storey][i], joint[storey][i + 1], section = beams[storey], material = steel }
        model:load { member = beam, q = { 0, 0, -times * q * kip / ft } }
      end
    end
  end
  return model, joint
end

return hinge.benchmark {
  title = "Ziemian and Ziemian 2021, frame 13", kind = "stability", fast = true,
  source = "frame: C. W. Ziemian, R. D. Ziemian, J. Constr. Steel Res. 186 (2021); values computed apart",
  run = function(b)
    for _, c in ipairs { { "1st order", "small", 1, { 0.508177, 3.79724, 6.37725 } },
      { "2nd order", "large", 10, { 0.579707, 4.50267, 7.46139 } } } do
      local model, joint = build(c[2], 1)
      local run = model:static { steps = c[3] }:finish()
      for i, storey in ipairs { 1, 5, 10 } do
        b:row { ("%s, floor %d"):format(c[1], storey), computed = joint[storey][1]:displacement(run) / inch,
          reference = c[4][i], unit = "in", tolerance = 2e-4, elements = 280, steps = c[3] }
      end
    end
    local small = 1e-3 -- of the loads: they bend the frame by little
    local run = build("large", small):static { steps = 1 }:finish()
    b:row { "buckling factor", computed = small * run:buckling { n = 1 }[1].factor, reference = 6.20678,
      tolerance = 2e-4, elements = 280 }
  end,
}

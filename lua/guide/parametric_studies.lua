-- A post with a heavy head that gets a blow, studied with many values: see parametric_studies.md.
local hinge = require "hinge"

local height, tilt = 2, 0.3 -- m; rad, beyond which the post is lost
local pipe = hinge.section.pipe { diameter = 0.1, thickness = 0.005 }

-- The next speed to look at: the middle of where the post still stands and where it is lost.
local function halving(cases)
  local stands, lost = 2, 12
  for _, c in ipairs(cases) do
    if c.results.lost then lost = c.parameters.speed else stands = c.parameters.speed end
  end
  if lost - stands > 0.1 then return { speed = (stands + lost) / 2 } end
end

local scenario = hinge.scenario {
  parameters = { speed = 6, mass = 200, yield_stress = 300e6, elements = 2 }, -- m/s, kg, Pa
  cases = { light = { mass = 100 }, heavy = { mass = 400 } },
  proposals = { halving = halving },
  run = function(p)
    local steel = hinge.material { E = 206e9, density = 7850, yield_stress = p.yield_stress }
    local model = hinge.model { elements_per_member = p.elements }
    local foot, head = model:node { 0, 0, 0 }, model:node { 0, 0, height }
    model:member { foot, head, section = pipe, material = steel }
    model:fix(foot, "all")
    model:mass { node = head, mass = p.mass }
    model:velocity(head, { p.speed, 0, 0 })
    local run = model:dynamic { dt = "auto", integrator = "explicit", duration = 0.4, record = false }
    local sway = run:probe { node = head, "ux" }
    run:finish()
    return { sway = sway.max, lost = sway.max > tilt * height }
  end,
}
return scenario

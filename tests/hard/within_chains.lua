-- Chaotic scenes for tests/hard/within.lua: chains of plastic bars that swing by large angles. A change of 1e-9 becomes
-- as large as the motion in some seconds.
local hinge = require "hinge"
local random = require "random_scenes"
local support = require "support"
local chains = {}

local g = 9.80665
local least = { peak_mm = 0.05, end_mm = 0.05, kinetic_J = 0.01 }

local function draw(seed)
  local d = random.draws(seed, 7)
  local chain = { bars = {}, dt = d.pick { 1e-3, 2e-3 }, periods = d.number(10, 20) }
  for i = 1, 2 do
    chain.bars[i] = { length = d.number(0.2, 0.4), angle = d.number(0.2, 1.5), thick = d.number(0.02, 0.04) }
  end
  return chain
end

local function model_of(chain)
  local plastic = hinge.material { E = 2e9, density = 1200 }
  local model, x, z, all = hinge.model { elements_per_member = 2 }, 0, 0, 0
  local tip
  for i, bar in ipairs(chain.bars) do
    local from = model:node { x, 0, z }
    if i == 1 then model:fix(from, "x,y,z,rx,rz")
    else
      model:fix(from, "y,rx,rz")
      model:connector { tip, from, stiffness = { x = 1e6, z = 1e6 } } -- N/m
    end
    x, z, all = x + bar.length * math.cos(bar.angle), z + bar.length * math.sin(bar.angle), all + bar.length
    tip = model:node { x, 0, z }
    model:fix(tip, "y,rx,rz")
    model:member { from, tip, section = hinge.section.round { diameter = bar.thick }, material = plastic }
  end
  model:gravity { 0, 0, -g }
  return model, tip, all
end

--- The chain of a seed, as a scene of within_scenes.lua.
function chains.scene(seed)
  local chain = draw(seed)
  local words = { ("%d bars, dt %g, %.3g periods"):format(#chain.bars, chain.dt, chain.periods) }
  local function swing()
    local model, tip, all = model_of(chain)
    local run = model:dynamic { dt = chain.dt, record = false,
      duration = chain.periods * 2 * math.pi * math.sqrt(all / g) }
    local peak = 0
    run:on_step(function(r) peak = support.largest_of(peak, math.abs(tip:displacement(r))) end)
    run:finish()
    return { peak_mm = 1e3 * peak, end_mm = 1e3 * tip:displacement(run), kinetic_J = run.energy.kinetic }
  end
  return { seed = seed, class = "chain", words = words, least = least,
    scenario = hinge.scenario { run = swing, answers = least } }
end

return chains

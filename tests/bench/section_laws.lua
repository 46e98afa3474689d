-- What the law of its sections costs a moving plastic frame: eight storeys and four bays on a base that shakes.
--
-- Run     build/hinge run tests/bench/section_laws.lua            (a minute; turns=5: more of them)
-- Shows   seconds of each law, the median of runs by turns, over those of eq 14; the energy error beside them
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../script/?.lua;" .. package.path
local hinge = require "hinge"
local scenes = require "scenes"
local with = scenes.with

local bays, storeys, bay, height = 4, 8, 6, 3.5 -- m
local floor_density = 60000 -- kg/m^3: the beams carry floors

-- Linear hardening as a function of the script: of one flow, and of several at once.
local H, fy = 2.1e9, 275e6
local function hardens(flow, history)
  local strain = history[1] + flow.strain
  return 1 + H / fy * strain, nil, { strain }
end
local function harden(flows, history)
  local strengths, backs, histories, strains = {}, {}, {}, flows.strain
  for i = 1, flows.count do
    local strain = history[1] + strains[i]
    strengths[i], backs[i], histories[i] = 1 + H / fy * strain, { 0, 0, 0, 0 }, { strain }
  end
  return strengths, backs, histories
end

local laws = {
  { "eq 14", interaction = "paper" },
  { "exact" },
  { "exact with shear", interaction = "exact with shear" },
  { "exact, kinematic hardening", material = { hardening = { tangent = 2.1e9 } } },
  { "exact, both kinds of hardening", material = { hardening = { tangent = 2.1e9, kinematic = 0.5 } } },
  { "exact, strain rate", material = { rate = { D = 40.4, q = 5 } } },
  { "exact, backbone", backbone = hinge.backbone { points = { { 0, 1 }, { 0.03, 1.1 }, { 0.1, 0.4 } } } },
  { "the same, with wear", backbone = hinge.backbone { points = { { 0, 1 }, { 0.03, 1.1 }, { 0.1, 0.4 } }, wear = 1 } },
  { "and with wear of stiffness", backbone = hinge.backbone { points = { { 0, 1 }, { 0.03, 1.1 }, { 0.1, 0.4 } },
    wear = 1, stiffness_wear = true } },
  { "exact, hardening in Lua", law = { variables = 1, step = hardens } },
  { "the same, several flows at once", law = { variables = 1, batch = harden } },
}

-- Seconds of two seconds of motion, and the run.
local function shaken(law)
  local model = hinge.model { interaction = law.interaction or "exact", elements_per_member = 4 }
  local steel = with({ E = 210e9, density = 7850, yield_stress = 275e6 }, law.material)
  local columns, beams = hinge.material(steel), hinge.material(with(steel, { density = floor_density }))
  local column, beam, laws_of = hinge.section.named "HEB 300", hinge.section.named "IPE 400",
    { backbone = law.backbone, law = law.law }
  local at = scenes.plane_frame(model, { bays = bays, storeys = storeys, bay = bay, height = height,
    column = with({ section = column, material = columns }, laws_of),
    beam = with({ section = beam, material = beams }, laws_of) })
  model:gravity { 0, 0, -9.81 }
  local rest = model:static { steps = 2, record = false }:finish()
  model:damping { ratio = 0.03, periods = { 1.5, 0.2 } }
  for i = 0, bays do
    model:move { node = at[i][0], x = function(t)
      return 0.35 * math.sin(2 * math.pi * t / 1.2) * math.min(1, t)
    end }
  end
  local run = model:dynamic { from = rest, dt = 2e-3, duration = 2, record = false }
  local began = os.clock()
  run:finish()
  return os.clock() - began, run
end

return hinge.scenario {
  parameters = { turns = 3 },
  run = function(p)
    local seconds, last = {}, {}
    for _ = 1, p.turns do
      for i, law in ipairs(laws) do
        local time, run = shaken(law)
        seconds[i] = seconds[i] or {}
        table.insert(seconds[i], time)
        last[i] = run
      end
    end
    print(("%-32s %8s %16s %10s %12s"):format("law", "s", "over eq 14's", "plastic MJ", "energy error"))
    local of_eq14
    for i, law in ipairs(laws) do
      table.sort(seconds[i])
      local median = seconds[i][(#seconds[i] + 1) // 2]
      of_eq14 = of_eq14 or median
      print(("%-32s %8.2f %16.3f %10.3f %11.1e %%"):format(law[1], median, median / of_eq14,
        last[i].energy.plastic / 1e6, 100 * last[i].energy_error))
      assert(last[i].verdict == "completed", last[i].reason)
    end
  end,
}

-- What effects cost that are declared and never act: a frame of 960 elements that sways, with each of them in turn.
--
-- Run     hinge run -q tests/bench/idle_effects.lua integrator=explicit        Newmark's method by default
-- Shows   the processor time of a step without effects, and over it that with each of them. The runs go on by turns in
--         one process, so that all have the same noise; of each the shortest tenth of its rounds counts
-- Expect  at most 1.02 each
local hinge = require "hinge"

local function at(i, j, k) return ("%d %d %d"):format(i, j, k) end

local declare = {
  contact = function(model) model:contact {} end,
  ground = function(model) model:ground { point = { 0, 0, -1 } } end,
  fracture = function(model) model:fracture { hinge_rotation_x = 0.5, hinge_rotation_y = 0.5 } end,
}
local turns = { {}, { "contact" }, { "ground" }, { "fracture" }, { "contact", "ground", "fracture" } }

-- A run of the frame with these effects: it carries its weight, and is pushed to and fro at its top.
local function swaying(p, effects)
  local steel = hinge.material { E = 206e9, density = 7850, yield_stress = p.yield == "yes" and 325e6 or nil }
  local column = hinge.section.box { width = 0.35, depth = 0.35, thickness = 0.016 }
  local beam = hinge.section.box { width = 0.2, depth = 0.45, thickness = 0.012 }
  local model, node = hinge.model { elements_per_member = 2 }, {}
  for i = 0, p.bays do
    for j = 0, p.bays do
      for k = 0, p.storeys do node[at(i, j, k)] = model:node { 6 * i, 6 * j, 3.5 * k } end
    end
  end
  local function member(a, b, section) model:member { node[a], node[b], section = section, material = steel } end
  for k = 1, p.storeys do
    for i = 0, p.bays do
      for j = 0, p.bays do
        if k == 1 then model:fix(node[at(i, j, 0)]) end
        member(at(i, j, k - 1), at(i, j, k), column)
        if i > 0 then member(at(i - 1, j, k), at(i, j, k), beam) end
        if j > 0 then member(at(i, j - 1, k), at(i, j, k), beam) end
        if p.masses == "yes" then model:mass { node = node[at(i, j, k)], mass = 5000 } end
        if k == p.storeys then
          local function to_and_fro(t) return 2e4 * math.sin(6 * t) end
          model:load { node = node[at(i, j, k)], force = { 1, 0.3, 0 }, history = to_and_fro }
        end
      end
    end
  end
  model:gravity { 0, 0, -9.81 }
  for _, effect in ipairs(effects) do declare[effect](model) end
  local rest, explicit = model:static { steps = 1, record = false }:finish(), p.integrator == "explicit"
  return model:dynamic { from = rest, integrator = explicit and "explicit" or nil, dt = explicit and 2e-5 or 1e-3,
    duration = (explicit and 2e-5 or 1e-3) * p.steps * (p.rounds + 1), record = false }
end

-- What a tenth of them do not reach: blocks of steps in which other programs had little of the processor.
local function short(list)
  table.sort(list)
  return list[math.max(1, #list // 10)]
end

return hinge.scenario {
  parameters = { integrator = "newmark", yield = "no", masses = "no", bays = 3, storeys = 12, rounds = 40, steps = 50 },
  run = function(p)
    local runs, results = {}, {}
    for i, effects in ipairs(turns) do
      runs[i] = { name = table.concat(effects, ", "), next = swaying(p, effects):steps(), seconds = {} }
    end
    for round = 0, p.rounds do
      for _, run in ipairs(runs) do
        local begun = os.clock()
        for _ = 1, p.steps do run.next() end
        if round > 0 then run.seconds[round] = os.clock() - begun end
      end
    end
    local own = short(runs[1].seconds)
    print(("%-28s %.4f ms a step"):format("no effect", 1e3 * own / p.steps))
    for i = 2, #runs do
      results[runs[i].name] = short(runs[i].seconds) / own
      print(("%-28s %.3f times that"):format(runs[i].name, results[runs[i].name]))
    end
    return results
  end,
}

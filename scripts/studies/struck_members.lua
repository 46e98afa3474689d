-- What a blow gives to a member, by its elements: a falling weight, a beam across a beam, a lorry and a column.
--
-- Run     hinge run scripts/studies/struck_members.lua           (half a minute on two cores)
--         hinge run scripts/studies/struck_members.lua scenes=lorry elements=4,8 height=1
--         hinge run scripts/studies/struck_members.lua integrator=explicit
-- Shows   the table of lua/guide/impact.md: what the striker has lost of its momentum and of its kinetic energy with 2,
--         4, 8 and 16 elements a member, the order that three of these show, the scatter of a run whose striker is
--         heavier by 1e-9, which runs warn of too few elements, and the processor time
-- Expect  where a run does not warn, twice as many elements change momentum and energy by less than 5 %. Where a beam
--         bounces on another and touches it several times (speed = 5 m/s) the energy of the last blow differs by more
local hinge = require "hinge"

local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 275e6 }
local scenes = {}

--- A rigid weight of 200 kg falls at 3 m/s on the middle of an elastic beam of 4 m, pinned, through a spring.
function scenes.weight(n, mass, p)
  local model = hinge.model { mass = p.integrator ~= "explicit" and "cubic" or nil, plasticity = false }
  local a, b = model:node { 0, 0, 0 }, model:node { 4, 0, 0 }
  model:fix(a, "xyz rx")
  model:fix(b, "yz")
  model:member { a, b, section = hinge.section.named "HEB 120", material = steel, elements = n, group = "struck",
    up = { 0, 0, 1 } }
  local side, up = 0.2, 0.06 + 0.1 + 1e-6
  local c, d = model:node { 2, -0.2, up }, model:node { 2, 0.2, up }
  model:member { c, d, section = hinge.section.solid { width = side, depth = side }, group = "striker",
    material = hinge.material { E = 2e12, density = 200 * mass / (0.4 * side ^ 2) }, up = { 0, 0, 1 } }
  model:contact { between = { "struck", "striker" }, stiffness = 5e6 }
  return model, { 0, 0, -3 }, 0.03
end

--- A beam of 4 m falls across another one of 4 m that is clamped, 0.1 m from its middle; both yield.
function scenes.beams(n, mass, p)
  local section = hinge.section.named "HEB 200"
  local model = hinge.model { elements_per_member = n }
  local heavy = hinge.material { E = 206e9, density = 7850 * mass, yield_stress = 275e6 }
  local a, b = model:node { -2, 0, 0 }, model:node { 2, 0, 0 }
  model:fix({ a, b }, "all")
  model:member { a, b, section = section, material = steel, group = "struck", up = { 0, 0, 1 } }
  local c, d = model:node { 0.1, -2, 0.201 }, model:node { 0.1, 2, 0.201 }
  model:member { c, d, section = section, material = heavy, group = "striker", up = { 0, 0, 1 } }
  model:contact { between = { "struck", "striker" } }
  return model, { 0, 0, -p.speed }, 0.03
end

--- A lorry of 12 t at 14 m/s against a column of 4 m: a bumper on two rails that fold, and the rest as masses.
function scenes.lorry(n, mass, p)
  local model = hinge.model { interaction = "exact with shear" }
  local foot, head = model:node { 0, 0, 0 }, model:node { 0, 0, 4 }
  model:fix(foot, "all")
  model:fix(head, "x,y,rz")
  model:member { foot, head, section = hinge.section.named "HEB 300", material = steel, up = { 1, 0, 0 }, elements = n,
    group = "struck" }
  local rail = hinge.section.box { width = 0.12, depth = 0.12, thickness = 0.006 }
  local stiff = hinge.section.box { width = 0.25, depth = 0.25, thickness = 0.02 }
  local nose, front, back = -0.15 - 0.06 - 0.02, {}, {}
  for i, y in ipairs { -0.6, 0, 0.6 } do
    front[i], back[i] = model:node { nose, y, p.height }, model:node { nose - 1, y, p.height }
    model:mass { node = back[i], mass = 4000 * mass }
  end
  for _, m in ipairs { { front[1], front[2], rail }, { front[2], front[3], rail }, { front[1], back[1], rail },
    { front[3], back[3], rail }, { back[1], back[2], stiff }, { back[2], back[3], stiff } } do
    model:member { m[1], m[2], section = m[3], material = steel, group = "striker", elements = 4 }
  end
  model:contact { between = { "struck", "striker" } }
  return model, { 14, 0, 0 }, 0.08
end

--- One run: the parts of the striker's momentum along its way, and of its kinetic energy, that are gone at the end.
local function one(name, n, mass, p)
  local model, velocity, duration = scenes[name](n, mass, p)
  model:velocity("striker", velocity)
  local begun = os.clock()
  local run = model:dynamic { dt = "auto", duration = duration, integrator = p.integrator, record = false }
  local before, axis = run:momentum "striker", velocity[1] ~= 0 and 1 or 3
  run:finish()
  local after, few = run:momentum "striker", false
  for _, warning in ipairs(run.warnings) do few = few or warning:find("momentum and energy passed", 1, true) ~= nil end
  return { momentum = 1 - after.linear[axis] / before.linear[axis], energy = 1 - after.kinetic / before.kinetic,
    few = few, error = math.abs(run.energy_error), verdict = run.verdict, seconds = os.clock() - begun }
end

--- The order at which values with n, 2 n, 4 n elements converge, or "-" where they do not come closer.
local function order(a, b, c)
  local ratio = (a - b) / (b - c)
  return ratio > 1 and ("%.1f"):format(math.log(ratio, 2)) or "-"
end

return hinge.scenario {
  -- m/s, of the falling beam; m, of the lorry's bumper
  parameters = { scenes = "weight,beams,lorry", elements = "2,4,8,16", speed = 15, height = 1.2,
    integrator = "newmark" },
  run = function(p)
    local results = {}
    print(("%-8s %-8s %-31s %-6s %-8s %s"):format("scene", "passed", p.elements, "order", "scatter", "warns"))
    for name in p.scenes:gmatch "%a+" do
      local all, warns = {}, {}
      for n in tostring(p.elements):gmatch "%d+" do
        local r = one(name, math.tointeger(n), 1, p)
        if r.verdict ~= "completed" then error(("%s, %s elements: %s"):format(name, n, r.verdict)) end
        all[#all + 1], results[name .. n] = r, r.momentum
        if r.few then warns[#warns + 1] = n end
      end
      local last = #all > 2 and #all - 2 or nil
      local other = one(name, math.tointeger(tostring(p.elements):match "%d+"), 1 + 1e-9, p)
      for _, what in ipairs { "momentum", "energy" } do
        local values = {}
        for _, r in ipairs(all) do values[#values + 1] = ("%.4f"):format(r[what]) end
        print(("%-8s %-8s %-31s %-6s %-8.0e %s"):format(name, what, table.concat(values, ", "),
          last and order(all[last][what], all[last + 1][what], all[last + 2][what]) or "",
          math.abs(other[what] - all[1][what]), table.concat(warns, ", ")))
      end
      local times = {}
      for _, r in ipairs(all) do times[#times + 1] = ("%.3g"):format(r.seconds) end
      print(("%-8s %-8s %s"):format(name, "time, s", table.concat(times, ", ")))
    end
    return results
  end,
}

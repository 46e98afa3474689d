-- Laws of sections as functions of the script: model:member { law = }. The same law in C++ and in Lua; closed forms.
--
-- Run: lua5.4 tests/script/sections/own_law_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local scenes = require "scenes"
local checks = support.checks "own_law"
local case, expect, near = checks.case, checks.expect, checks.near

local H, fy, L = 2.1e9, 235e6, 1
local bar = hinge.section.solid { width = 0.05, depth = 0.06 }
local zone = L / 4 -- half of an element yields with its end

local function steel(hardening)
  return hinge.material { E = 210e9, density = 7850, yield_stress = fy, hardening = hardening }
end

-- Linear hardening as section/laws/hardening.cpp has it, by its two kinds.
local isotropic = { variables = 1, step = function(flow, history)
  local strain = history[1] + flow.strain
  return 1 + H / fy * strain, nil, { strain }
end }
local kinematic = { variables = 4, step = function(flow, x)
  local back = { x[1] + H * bar.Ix / zone * flow.x, x[2] + H * bar.Iy / zone * flow.y,
    x[3] + H * bar.area / zone * flow.N, x[4] + H * bar.J / 3 / zone * flow.z }
  return 1, back, back
end }

-- The same two, asked for several flows at once.
local function in_batches(law)
  return { variables = law.variables, batch = function(flows, history)
    local strengths, backs, histories = {}, {}, {}
    for i = 1, flows.count do
      local flow = { x = flows.x[i], y = flows.y[i], N = flows.N[i], z = flows.z[i], strain = flows.strain[i],
        at_end = flows.at_end }
      local back
      strengths[i], back, histories[i] = law.step(flow, history)
      backs[i] = back or { 0, 0, 0, 0 }
    end
    return strengths, backs, histories
  end }
end

local function cantilever(law, hardening, interaction)
  return scenes.cantilever { model = { interaction = interaction }, length = L,
    member = { section = bar, material = steel(hardening), law = law } }
end

-- Cycles of a force that bends about both axes, pulls and turns.
local function cycled(law, hardening, interaction)
  local model, tip = cantilever(law, hardening, interaction)
  model:load { node = tip, force = { 2e3, 1e3, 400 }, moment = { 100, 0, 0 } }
  local run
  for _, u in ipairs { 0.06, -0.06, 0.09 } do
    run = model:static { from = run, steps = 15, tolerance = 1e-13, record = false,
      control = { node = tip, "uy", to = u } }:finish()
    expect(run.verdict == "completed", "%s", run.reason)
  end
  return { run.factor, run.energy.plastic, tip:displacement(run) }
end

case("the same law in C++ and in Lua: statics, two laws of sections", function()
  for _, interaction in ipairs { "paper", "exact" } do
    for name, pair in pairs { isotropic = { isotropic, { modulus = H, kinematic = 0 } },
      kinematic = { kinematic, { modulus = H } } } do
      local by_lua, by_cpp = cycled(pair[1], nil, interaction), cycled(nil, pair[2], interaction)
      local plain = cycled(nil, nil, interaction)
      for i = 1, #by_cpp do
        near(by_lua[i], by_cpp[i], 1e-9 * math.abs(by_cpp[i]), ("%s, %s, %d"):format(interaction, name, i))
      end
      local batches = cycled(in_batches(pair[1]), nil, interaction)
      for i = 1, #by_lua do
        near(batches[i], by_lua[i], 0, ("%s, %s, %d: in batches"):format(interaction, name, i))
      end
      expect(math.abs(by_cpp[1] - plain[1]) > 0.03 * plain[1], "the law is to be seen: %g and %g", by_cpp[1], plain[1])
    end
  end
end)

case("the same in dynamics, implicit and explicit", function()
  -- Explicit steps find the flow of a pair within 1e-4 of its elastic deformation, and the two laws look for it on
  -- different ways. The others find it within 1e-9.
  for _, c in ipairs { { { dt = 1e-4, iterations = 10 }, 1e-6 }, { { dt = "auto", integrator = "explicit" }, 1e-4 },
    { { dt = 1e-4, integrator = "energy-momentum" }, 1e-6 } } do
    local options, tolerance = c[1], c[2]
    options.duration, options.record = 0.01, false
    local found = {}
    for i, pair in ipairs { { isotropic }, { nil, { modulus = H, kinematic = 0 } } } do
      local model, tip = cantilever(pair[1], pair[2])
      model:mass { node = tip, mass = 50 }
      model:velocity(tip, { 0, 10, 3 })
      local run = model:dynamic(options):finish()
      found[i] = { tip:displacement(run) }
      found[i][7] = run.energy.plastic
      near(run.energy_error, 0, 2e-3, "energy error")
    end
    for k = 1, 7 do near(found[1][k], found[2][k], tolerance * math.abs(found[2][k]), "number " .. k) end
  end
end)

-- A bar that is pulled: the force beyond yield is what the function says.
local function pulled(law, to)
  local model, tip = scenes.cantilever { model = { displacement = "small" }, length = L, force = { 1e3, 0, 0 },
    member = { section = bar, material = steel(), law = law } }
  local run = model:static { steps = 50, record = false, control = { node = tip, "ux", to = to } }:finish()
  return 1e3 * run.factor / (bar.area * fy), run
end

case("a bar that softens: the strength over the plastic strain, by hand", function()
  local function strength(strain) return 0.3 + 0.7 * math.exp(-strain / 0.02) end
  local law = { variables = 1, step = function(flow, h)
    local strain = h[1] + flow.strain
    return strength(strain), nil, { strain }
  end }
  local found, run = pulled(law, 0.03 * L)
  -- one section of the four has weakened first, or all alike: the force is that of what flowed
  local low, high = 0, 0.03
  for _ = 1, 100 do
    local strain = (low + high) / 2
    if strain + strength(strain) * fy / 210e9 > 0.03 then high = strain else low = strain end
  end
  expect(run.verdict == "completed", "%s", run.reason)
  expect(found <= strength(low) * (1 + 1e-6), "%g; all parts alike have %g", found, strength(low))
  expect(found >= 0.3 * (1 - 1e-9), "no less than the rest: %g", found)
  near(run.energy_error, 0, 0.02, "energy error")
end)

case("a plain function, with a strength that stays", function()
  near(pulled(function() return 0.5 end, 0.01), 0.5, 1e-9, "half of the strength")
  near(pulled(function() return 1.5 end, 0.01), 1.5, 1e-9, "half as much again")
end)

case("a run goes on from a checkpoint in the middle of a cycle", function()
  local folder = support.temporary_folder()
  local function run_of()
    local model, tip = cantilever(kinematic)
    model:mass { node = tip, mass = 50 }
    model:velocity(tip, { 0, 10, 3 })
    return model:dynamic { dt = 1e-4, duration = 0.01, record = false }
  end
  local whole = run_of()
  for step in whole:steps() do
    if step.index == 50 then whole:checkpoint(folder .. "/half.checkpoint") end
  end
  local again = run_of()
  again:resume(folder .. "/half.checkpoint")
  again:finish()
  checks.equal(again.hash, whole.hash, "the states' hash")
end)

case("what is wrong is named at the script's line", function()
  local function wrong(words, law, material)
    local ok, complaint = pcall(function()
      local model = hinge.model {}
      local a, b = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
      model:fix(a)
      model:member { a, b, section = bar, material = material or steel(), law = law }
      model:load { node = b, force = { 1e6, 0, 0 } }
      model:static { steps = 2, record = false, control = { node = b, "ux", to = 0.01 } }:finish()
    end)
    expect(not ok and tostring(complaint):find(words, 1, true), "wanted '%s', not: %s", words, tostring(complaint))
    expect(tostring(complaint):find "own_law_test.lua:%d+", "no line: %s", tostring(complaint))
  end
  wrong("returned nil", function() end)
  wrong("must return a number of 0.01 or more", function() return 0 end)
  wrong("nan at a growth", function() return 0 / 0 end)
  wrong("the back resultants that it returned is", function() return 1, { 1, 2 } end)
  wrong("list of 2 finite numbers", { variables = 2, step = function() return 1, nil, { 1 } end })
  wrong("returned nil as strengths; it must be an array with an item for each flow", { batch = function() end })
  wrong("returned nil at a growth", { batch = function() return { 1 } end })
  wrong("returned 1 as back resultants", { batch = function() return { 1, 1, 1 }, 1 end })
  wrong("list of 2 finite numbers", { variables = 2, batch = function(f)
    expect(f.count == #f.x and f.count == #f.strain, "count %d, %d, %d", f.count, #f.x, #f.strain)
    return { 1, 1, 1 }, nil, { { 1 }, { 1 }, { 1 } }
  end })
  wrong("given beside step", { step = function() return 1 end, batch = function() return { 1, 1, 1 } end })
  wrong("must be a function(flows, history)", { batch = 1 })
  wrong("too late", function() error "too late" end)
  wrong("field 'law' is 3", 3)
  wrong("must be a function(flow, history)", { variables = 1 })
  wrong("variables", { variables = -1, step = function() return 1 end })
  wrong("must be from 0 to 32", { variables = 33, step = function() return 1 end })
  wrong("needs a material with yield_stress", function() return 1 end, hinge.material { E = 210e9, density = 7850 })
end)

checks.done()

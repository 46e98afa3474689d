-- model:settle: supports that are displaced in statics, against closed forms, displacement control and the energy
-- balance.
--
-- Run: lua5.4 tests/script/actions/settlement_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "settlement"
local runs = require "runs"(checks)
local case, expect, near = checks.case, checks.expect, checks.near

local E, nu, fy, L = 210e9, 0.3, 235e6, 3
local square = hinge.section.solid { width = 0.1, depth = 0.1 }
local EI, GA = E * square.Ix, E / (2 * (1 + nu)) * square.shear_area_y
local elastic = hinge.material { E = E, nu = nu, density = 7850 }
local steel = hinge.material { E = E, nu = nu, density = 7850, yield_stress = fy }

--- Members in a row along x, each L long, in the plane of x and z.
local function row(spans, options, material)
  local model = hinge.model(options)
  local nodes = {}
  for i = 0, spans do
    nodes[i] = model:node { i * L, 0, 0 }
    model:fix(nodes[i], "y,rx,rz")
    if i > 0 then model:member { nodes[i - 1], nodes[i], section = square, material = material, up = { 0, 0, 1 } } end
  end
  return model, nodes
end

local function finish(model, options)
  return runs.completed(model:static(scenes.with({ record = false }, options)))
end

case("the middle support of two spans settles: a beam under a load in its middle", function()
  local model, nodes = row(2, { displacement = "small" }, elastic)
  for i, what in pairs { [0] = "x,z", [2] = "z" } do model:fix(nodes[i], what) end
  model:settle { node = nodes[1], z = -0.01 }
  local run = finish(model)
  local P = 0.01 / ((2 * L) ^ 3 / (48 * EI) + 2 * L / (4 * GA))
  near((select(3, run:reaction(nodes[1]))), -P, 1e-9 * P, "the force at the support")
  near((select(3, run:reaction(nodes[0]))), P / 2, 1e-9 * P, "the force at an end")
  near((select(3, run:displacement(nodes[1]))), -0.01, 1e-15, "the displacement given")
  near(run.energy.elastic, P * 0.01 / 2, 1e-9 * P * 0.01, "strain energy")
  near(run.energy.work, P * 0.01 / 2, 1e-9 * P * 0.01, "work of the support")
end)

case("a clamped end rotates, and one sinks", function()
  local phi = 12 * EI / (GA * L ^ 2)
  for _, of in ipairs { { field = "ry", size = 1e-3, M = (4 + phi) / (1 + phi) * EI / L * 1e-3 },
    { field = "z", size = 1e-3, M = 6 * EI / L ^ 2 / (1 + phi) * 1e-3 } } do
    local model, nodes = row(1, { displacement = "small" }, elastic)
    for i = 0, 1 do model:fix(nodes[i]) end
    model:settle { node = nodes[1], [of.field] = of.size }
    local run = finish(model)
    near(math.abs((select(5, run:reaction(nodes[1])))), of.M, 1e-9 * of.M, of.field .. ": the moment there")
  end
end)

case("beyond yield the moment stays, and the work is what is dissipated and stored", function()
  local model, nodes = row(1, { displacement = "small" }, steel)
  model:fix(nodes[0])
  model:fix(nodes[1], "x,z")
  model:settle { node = nodes[1], z = -0.2 }
  local run = finish(model, { steps = 40 })
  local M0, sum = fy * square.Zx, run.energy.elastic + run.energy.plastic
  near(math.abs((select(5, run:reaction(nodes[0])))), M0, 1e-6 * M0, "the plastic moment at the wall")
  near((select(3, run:reaction(nodes[1]))), -M0 / L, 1e-6 * M0 / L, "what it takes to push the end down")
  near(run.energy.work, sum, 1e-3 * sum, "the energy balance")
  expect(run.energy.plastic > run.energy.elastic, "more is dissipated than stored")
end)

-- A shallow arch of two members, pushed through: the support that settles is what displacement control drives.
local function arch()
  local model = hinge.model {}
  local a, b, c = model:node { -L, 0, 0 }, model:node { 0, 0, 0.15 }, model:node { L, 0, 0 }
  model:fix(a) model:fix(c) model:fix(b, "y,rx,ry,rz")
  model:member { a, b, section = square, material = elastic, up = { 0, 1, 0 } }
  model:member { b, c, section = square, material = elastic, up = { 0, 1, 0 } }
  return model, b
end

case("a support that pushes an arch through gives the load of displacement control", function()
  for _, down in ipairs { 0.05, 0.15, 0.25 } do
    local driven, crown = arch()
    driven:load { node = crown, force = { 0, 0, -1e3 } }
    local by = finish(driven, { steps = 30, control = { node = crown, "uz", to = -down } })
    local model, node = arch()
    model:settle { node = node, z = -down }
    local run = finish(model, { steps = 30 })
    local P = 1e3 * by.factor
    near((select(3, run:reaction(node))), -P, 1e-6 * math.abs(P), ("%g m: the force"):format(down))
    near(run.energy.work, run.energy.elastic, 2e-2 * run.energy.elastic, ("%g m: work, by 30 steps"):format(down))
  end
end)

case("arc length moves it, too", function()
  local model, node = arch()
  model:settle { node = node, z = -0.02 }
  local run = finish(model, { control = "arc", steps = 40 })
  near((select(3, run:displacement(node))), -0.02 * run.factor, 1e-12, "in proportion to the load factor")
end)

case("a run that goes on keeps the settlement, in statics and in dynamics", function()
  local model, nodes = row(2, {}, elastic)
  model:fix(nodes[0]) model:fix(nodes[2])
  model:settle { node = nodes[1], z = -0.01 }
  local first = finish(model)
  local P = (select(3, first:reaction(nodes[1])))
  local again = finish(model, { from = first })
  near((select(3, again:displacement(nodes[1]))), -0.01, 1e-15, "it moves no farther")
  near((select(3, again:reaction(nodes[1]))), P, 1e-7 * math.abs(P), "with the same force")
  local moving = model:dynamic { from = again, dt = 1e-3, duration = 0.02, record = false }:finish()
  near((select(3, moving:displacement(nodes[1]))), -0.01, 1e-15, "dynamics leaves the support where it is")
  near((select(3, moving:reaction(nodes[1]))), P, 1e-6 * math.abs(P), "at rest")
end)

case("a run that goes on keeps a rotation of a support, small and large, about each axis", function()
  for _, displacement in ipairs { "small", "large" } do
    for component, field in ipairs { "rx", "ry", "rz" } do
      for _, theta in ipairs { 2e-3, -0.3 } do
        local model = hinge.model { displacement = displacement, plasticity = false }
        local a, b = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
        model:member { a, b, section = square, material = elastic, up = { 0, 0, 1 } }
        model:fix({ a, b })
        model:settle { node = b, [field] = theta }
        local what = ("%s, %s = %g"):format(displacement, field, theta)
        local first = finish(model, { steps = 4 })
        local M = (select(3 + component, first:reaction(b)))
        local again = finish(model, { steps = 3, from = first })
        near((select(3 + component, again:displacement(b))), theta, 1e-9, what .. ": it turns no farther")
        near((select(3 + component, again:reaction(b))), M, 1e-6 * math.abs(M), what .. ": with the same moment")
        local third = finish(model, { steps = 1, from = again })
        near((select(3 + component, third:reaction(b))), M, 1e-6 * math.abs(M), what .. ": nor in a third run")
        if displacement == "small" then
          local phi = 12 * EI / (GA * L ^ 2)
          local stiffness = field == "rx" and elastic.G * square.J / L or (4 + phi) / (1 + phi) * EI / L
          near(M, stiffness * theta, 1e-6 * math.abs(M), what .. ": the moment by hand")
        end
      end
    end
  end
end)

case("a support that joints alone join to members is refused, and not left where it is", function()
  local model = hinge.model()
  local a, b = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:member { a, b, section = square, material = elastic, ends = { a = hinge.joint { Mx = { stiffness = 1e5 } } } }
  model:fix { a, b }
  model:settle { node = a, z = -0.01 }
  checks.refused("does not go yet with model:member, ends at its node", function() model:static() end)
end)

case("wrong input is refused and changes nothing", function()
  local model, nodes = row(2, {}, elastic)
  model:fix(nodes[0])
  local function refused(words, options) checks.refused(words, model.settle, model, options) end
  refused("none of 'x', 'y', 'z'", { node = nodes[1] })
  refused("field 'z' is 'down'", { node = nodes[1], z = "down" })
  refused("an empty list", { node = {}, z = 1 })
  model:settle { node = nodes[1], z = -0.01 }
  refused("has a displacement 'z' already", { node = { nodes[2], nodes[1] }, z = -0.01 })
  expect(#model:nodes() == 3, "the nodes are still there")
  local near_by, far = model:node { L, 0.2, 0 }, model:node { L, 0.2, 1 }
  model:member { near_by, far, section = square, material = elastic, up = { 0, 1, 0 } }
  model:rigid_link { from = nodes[1], to = near_by }
  checks.refused("does not go yet with model:rigid_link", finish, model)
end)

checks.done()

-- Nodes at which the ends of all members are released: pinned trusses, and supports that hold the node itself.
--
-- Run: lua5.4 tests/script/model/released_nodes_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local vectors = require "hinge.library.vectors"
local checks = support.checks "nodes with joints alone"
local runs = require "runs"(checks)
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local E = 200e9
local steel = hinge.material { E = E, nu = 0.3, density = 7850 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
local pins = { a = { "Mx", "My" }, b = { "Mx", "My" } }

-- A bar along x and a tie to the wall above, which carry a load at their common node. fix: of that node.
local function bracket(options, fix, order)
  local m = hinge.model(options)
  local wall, node, above = m:node { 0, 0, 0 }, m:node { 4, 0, 0 }, m:node { 0, 0, 3 }
  m:fix({ wall, above }, "all")
  if fix and order == "before" then m:fix(node, fix) end
  local strut = m:member { wall, node, section = bar, material = steel, release = pins }
  local tie = m:member { above, node, section = bar, material = steel, release = pins }
  if fix and order ~= "before" then m:fix(node, fix) end
  return m, node, strut, tie
end

for _, displacement in ipairs { "small", "large" } do
  for _, fix in ipairs { "none", "rx,ry,rz", "y,rx,ry,rz", "y", "y,ry", "x,y,rx,ry,rz" } do
    case(("forces of a bracket by hand: %s displacement, node holds %s"):format(displacement, fix), function()
      for _, order in ipairs { "before", "after" } do
        local m, node, strut, tie = bracket({ displacement = displacement }, fix ~= "none" and fix or "y", order)
        local P = 10
        m:load { node = node, force = { 0, 0, -P } }
        local run = runs.completed(m:static { steps = 1 })
        -- 1e-6: second-order effects of 10 N are of the order of the strain, 1e-8
        near(tie:forces(run).N, P * 5 / 3, 1e-6 * P, order .. ": tie")
        near(strut:forces(run).N, fix:find "^x" and 0 or -P * 4 / 3, 1e-6 * P, order .. ": strut")
      end
    end)
  end
end

-- A tripod: no support holds the rotations of its head.
local function tripod(options, rigid_leg)
  local m = hinge.model(options)
  local head, legs = m:node { 0.2, 0.1, 2 }, {}
  for i, foot in ipairs { { 1, 0, 0 }, { -0.6, 0.9, 0 }, { -0.5, -1, 0 } } do
    local at = m:node(foot)
    m:fix(at)
    legs[i] = m:member { at, head, section = bar, material = steel,
      release = { a = { "Mx", "My" }, b = i ~= rigid_leg and { "Mx", "My", "Mz" } or nil } }
  end
  return m, head, legs
end

case("a tripod of pinned legs: forces by the balance of its head", function()
  local m, head, legs = tripod { displacement = "small" }
  local load = { 3, -2, -7 }
  m:load { node = head, force = load }
  local run = m:static { steps = 1 }:finish()
  local along = {}
  for i, leg in ipairs(legs) do
    along[i] = vectors.unit(vectors.minus(vectors.of_node(leg.a), vectors.of_node(head)))
  end
  -- N1 d1 + N2 d2 + N3 d3 + load = 0: across two legs the third one alone resists
  for i, leg in ipairs(legs) do
    local across = vectors.cross(along[i % 3 + 1], along[(i + 1) % 3 + 1])
    near(leg:forces(run).N, -vectors.dot(load, across) / vectors.dot(along[i], across), 1e-7, "leg " .. i)
  end
end)

case("modes are those of the truss whose node rotates with one of its members", function()
  local one, two = tripod {}, tripod({}, 1)
  local a, b = one:static({ steps = 1 }):finish(), two:static({ steps = 1 }):finish()
  local of_a, of_b = a:modes { n = 6 }, b:modes { n = 6 }
  equal(#of_a, #of_b, "number of modes")
  for i = 1, 6 do near(of_a[i].frequency / of_b[i].frequency, 1, 1e-5, "mode " .. i) end
end)

for _, integrator in ipairs { "newmark", "explicit" } do
  case("it vibrates as the truss whose node rotates with one of its members: " .. integrator, function()
    local last = {}
    for i, leg in ipairs { 0, 1 } do
      local m, head = tripod({}, leg > 0 and leg or nil)
      m:load { node = head, force = { 3e4, -2e4, -7e4 } }
      local run = runs.completed(m:dynamic { dt = 5e-6, duration = 4e-3, integrator = integrator })
      runs.balanced(run, 2e-3, "work", integrator)
      last[i] = { head:displacement(run) }
    end
    for c = 1, 3 do near(last[1][c], last[2][c], 2e-4 * math.abs(last[2][3]), "displacement " .. c) end
  end)
end

case("a mechanism is still one: bars in a line, pinned at each end", function()
  local m = hinge.model { displacement = "small" }
  local nodes = {}
  for i = 0, 3 do nodes[i] = m:node { i, 0, 0 } end
  m:fix({ nodes[0], nodes[3] }, "all")
  for i = 1, 3 do m:member { nodes[i - 1], nodes[i], section = bar, material = steel, release = pins } end
  m:load { node = nodes[1], force = { 1, 0, 0 } }
  checks.refused("without resistance", m.static, m, { steps = 1 })
end)

case("a moment that no member resists is refused; one that torsion resists is not", function()
  local m, node = bracket({ displacement = "small" }, "y")
  m:load { node = node, moment = { 0, 5, 0 } }
  checks.refused("nothing resists it", m.static, m, { steps = 1 })
  local twisted, end_, strut = bracket({ displacement = "small" }, "y")
  twisted:load { node = end_, moment = { 5, 0, 0 } }
  local run = twisted:static { steps = 1 }:finish()
  -- the tie goes off at an angle, and torsion of both has a part along x
  expect(math.abs(strut:forces(run).Mz) > 1, "torsion of the strut is %g N m", strut:forces(run).Mz)
end)

case("a load on a support whose members are all released goes into its reaction", function()
  local m, _, _, tie = bracket({ displacement = "small" }, "all")
  local at = tie.b
  m:load { node = at, force = { 0, 0, -100 } }
  local run = m:static { steps = 1 }:finish()
  local _, _, z = run:reaction(at)
  near(z, 100, 1e-9, "reaction")
  near(tie:forces(run).N, 0, 1e-9, "tie")
end)

case("supports with released members alone carry a mass, and lead and follow in a rigid floor", function()
  local m = hinge.model { displacement = "small" }
  local feet, heads = {}, {}
  for i = 1, 3 do
    feet[i], heads[i] = m:node { 2 * i, 0, 0 }, m:node { 2 * i, 0, 3 }
    m:fix(feet[i])
    m:fix(heads[i], "x,y,rx,ry,rz")
    m:member { feet[i], heads[i], section = bar, material = steel, release = { a = { "Mx", "My" } } }
  end
  m:diaphragm { nodes = feet }
  m:mass { node = feet[1], mass = 100 }
  m:gravity { 0, 0, -10 }
  local run = m:static { steps = 1 }:finish()
  local _, _, z = run:reaction(feet[1])
  near(z, 1000 + 7850 * 0.05 ^ 2 * 3 * 10, 1e-6, "the reaction has the weight of the mass")
  runs.completed(m:dynamic { dt = 1e-4, duration = 1e-3 }, "dynamics")
end)

case("a member of a pinned truss is removed, and a node that has none left is gone", function()
  local m = hinge.model { displacement = "small" }
  local base, top, tip = {}, m:node { 0, 0, 2 }, m:node { 2, 0, 2 }
  for i = 1, 3 do
    base[i] = m:node { math.cos(2 * i), math.sin(2 * i), 0 }
    m:fix(base[i])
    m:member { base[i], top, section = bar, material = steel, release = pins }
  end
  m:fix(tip, "x,y,z,rx,rz")
  local arm = m:member { top, tip, section = bar, material = steel, release = pins }
  m:load { node = top, force = { 0, 0, -1e4 } }
  m:remove { member = arm, at = 1e-3, over = 1e-4 }
  runs.completed(m:dynamic { dt = 1e-5, duration = 2e-3 })
end)

checks.done()

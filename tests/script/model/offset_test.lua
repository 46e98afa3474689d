-- Ends of members at an offset from their nodes: rigid ends and insertion points.
--
-- Run: lua5.4 tests/script/model/offset_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "offsets of members"
local runs = require "runs"(checks)
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local E, G = 200e9, 77e9
local steel = hinge.material { E = E, G = G, density = 7850 }
local column, beam = hinge.section.named "W14X145", hinge.section.named "W18X50"
local rigid = hinge.section.general { area = 1, Ix = 10, Iy = 10, J = 10, shear_area_x = 100, shear_area_y = 100 }
local W, H = 7.32, 3.66

-- A portal whose beam stands off its nodes by a and b: by `offset`, by rigid links ("links") or by stiff members.
local function portal(options, a, b, by, more)
  more = more or {}
  local m = hinge.model(options)
  local heads = {}
  for i = 0, 1 do
    local foot = m:node { W * i, 0, 0 }
    heads[i] = m:node { W * i, 0.1 * i, H }
    m:fix(foot)
    m:member { foot, heads[i], section = column, material = steel, up = { 1, 0, 0 } }
  end
  local girder
  if by ~= "offset" then
    local ends = { m:node { a[1], a[2], H + a[3] }, m:node { W + b[1], 0.1 + b[2], H + b[3] } }
    girder = m:member { ends[1], ends[2], section = beam, material = steel, group = "girder" }
    for i = 0, 1 do
      local released = i == 0 and more.released and "xyz" or nil
      if by == "links" then m:rigid_link { from = heads[i], to = ends[i + 1], dofs = released }
      else m:member { heads[i], ends[i + 1], section = rigid, material = hinge.material { E = E, G = G } } end
    end
  else
    girder = m:member { heads[0], heads[1], section = beam, material = steel, group = "girder",
      offset = { a = a, b = b },
      ends = more.released and { a = hinge.joint { Mx = "free", My = "free", Mz = "free" } } or nil }
  end
  m:load { node = heads[0], force = { 1e5, 2e4, 0 } }
  m:load { member = girder, q = { 0, 0, -2e4 } }
  if more.floor then m:diaphragm { nodes = { heads[0], heads[1] } } end
  return m, heads, girder
end

local offsets = {
  ["rigid ends"] = { { 0.19, 0, 0 }, { -0.19, 0, 0 } },
  hung = { { 0, 0, -0.23 }, { 0, 0, -0.23 } },
  ["to all sides"] = { { 0.19, 0.1, -0.23 }, { -0.3, 0.2, 0.1 } },
}

for _, displacement in ipairs { "small", "large" } do
  for name, by in pairs(offsets) do
    case(("statics as by rigid links: %s, displacement %s"):format(name, displacement), function()
      for _, more in ipairs { {}, { released = true } } do
        local u, f = {}, {}
        for i, how in ipairs { "offset", "links" } do
          local m, heads, girder = portal({ displacement = displacement }, by[1], by[2], how, more)
          local run = runs.completed(m:static { steps = 2 })
          u[i], f[i] = { heads[0]:displacement(run) }, (girder:forces(run))
        end
        for c = 1, 6 do near(u[1][c], u[2][c], 1e-7 * math.abs(u[2][1]), "displacement " .. c) end
        for _, q in ipairs { "N", "Mx", "My", "Qx", "Qy" } do
          near(f[1][q], f[2][q], 1e-6 * (math.abs(f[2].N) + math.abs(f[2].Mx)), q)
        end
      end
    end)
    case(("vibration as by rigid links: %s, displacement %s"):format(name, displacement), function()
      for _, integrator in ipairs { "newmark", "explicit" } do
        local u = {}
        for i, how in ipairs { "offset", "links" } do
          local m, heads = portal({ displacement = displacement }, by[1], by[2], how)
          local run = runs.completed(m:dynamic { dt = 1e-5, duration = 0.01, integrator = integrator }, integrator)
          runs.balanced(run, 1e-3, "work", integrator)
          u[i] = { heads[0]:displacement(run) }
        end
        -- a link's group turns about its centre of mass, an offset end about its node: second order in the step
        for c = 1, 3 do near(u[1][c], u[2][c], 1e-5 * math.abs(u[2][1]), integrator .. ": displacement " .. c) end
      end
    end)
  end
end

case("modes as by rigid links", function()
  local f = {}
  for i, how in ipairs { "offset", "links" } do
    local by = offsets["to all sides"]
    local m = portal({}, by[1], by[2], how)
    f[i] = m:static { steps = 1 }:finish():modes { n = 5 }
  end
  for i = 1, 5 do near(f[1][i].frequency / f[2][i].frequency, 1, 1e-7, "mode " .. i) end
end)

case("a cantilever whose wall is at an offset: moments by hand, and the length between the ends", function()
  local m, _, arm, wall = scenes.cantilever { model = { displacement = "small" }, length = 3, force = { 0, 0, -100 },
    member = { section = beam, material = steel, offset = { a = { 0.5, 0, 0.2 } } } }
  near(arm.length, math.sqrt(2.5 ^ 2 + 0.2 ^ 2), 1e-12, "length")
  near(arm.offset.a[1], 0.5, 0, "field offset")
  equal(arm.offset.b, nil, "field offset of the other end")
  local run = m:static { steps = 1 }:finish()
  near(math.abs(arm:forces(run).Mx), 100 * 2.5, 1e-6, "moment at the member's end")
  local _, _, z, _, moment = run:reaction(wall)
  near(z, 100, 1e-7, "reaction")
  near(math.abs(moment), 300, 1e-6, "moment of the support")
  near(run:read("x")[1], 1.75, 1e-3, "middle of the member, x")
  near(run:read("z")[1], 0.1, 1e-3, "middle of the member, z")
end)

-- The section's default direction goes by the line between the ends, not by that between the nodes.
case("a raker between nodes above each other, and a post between nodes that are not, need no `up`", function()
  for _, by in ipairs { { node = { 0, 0, 3 }, a = { 0.5, 0, 0 } }, { node = { 0.5, 0, 3 }, a = { 0.5, 0, 0 } } } do
    local u = {}
    for i, how in ipairs { "offset", "nodes" } do
      local m = hinge.model { displacement = "small" }
      local foot, head = m:node(how == "offset" and { 0, 0, 0 } or by.a), m:node(by.node)
      m:fix(foot)
      m:member { foot, head, section = beam, material = steel, offset = how == "offset" and { a = by.a } or nil }
      m:load { node = head, force = { 1e3, 2e3, 0 } }
      u[i] = { head:displacement(m:static { steps = 1 }:finish()) }
    end
    for k = 1, 6 do near(u[1][k], u[2][k], 1e-7 * math.abs(u[2][2]), "displacement " .. k) end
  end
end)

case("a node with offset ends alone carries loads, masses and a floor", function()
  local u = {}
  for i, how in ipairs { "offset", "direct" } do
    local m, nodes = hinge.model {}, {}
    local up = how == "offset" and { 0, 0, 0.2 } or nil
    for k = 0, 2 do nodes[k] = m:node { 3 * k, 0, up and 0 or 0.2 } end
    m:fix { nodes[0], nodes[2] }
    for k = 1, 2 do
      m:member { nodes[k - 1], nodes[k], section = beam, material = steel, offset = up and { a = up, b = up } }
    end
    -- a force at the node has an arm to the members
    m:load { node = nodes[1], force = { 0, 0, -1e4 } }
    m:mass { node = nodes[1], mass = 200 }
    u[i] = { nodes[1]:displacement(runs.completed(m:dynamic { dt = 1e-4, duration = 0.02 })) }
  end
  near(u[1][3], u[2][3], 1e-6 * math.abs(u[2][3]), "deflection")
end)

case("members at an offset hang on a rigid floor", function()
  local u = {}
  for i, how in ipairs { "offset", "stiff" } do
    local m, heads = portal({ displacement = "small" }, { 0.19, 0, -0.1 }, { -0.19, 0, -0.1 }, how, { floor = true })
    u[i] = { heads[0]:displacement(m:static { steps = 1 }:finish()) }
  end
  for c = 1, 3 do near(u[1][c], u[2][c], 1e-4 * math.abs(u[2][1]), "displacement " .. c) end
end)

case("it turns with its node: a free body in flight spins on, and keeps its momentum", function()
  local m = hinge.model {}
  local a, b, c = m:node { 0, 0, 0 }, m:node { 2, 0, 0 }, m:node { 4, 0, 0 }
  m:member { a, b, section = beam, material = steel, offset = { b = { 0, 0, 0.5 } } }
  m:member { b, c, section = beam, material = steel, offset = { a = { 0, 0, 0.5 } } }
  local omega = 3
  for _, n in ipairs { a, b, c } do m:velocity(n, { 0, 0, -omega * (n.x - 2) }, { 0, omega, 0 }) end
  local run = m:dynamic { dt = 1e-3, duration = 0.5 }
  local before = run:momentum()
  runs.completed(run)
  local after = run:momentum()
  for k = 1, 3 do
    near(after.linear[k], before.linear[k], 2e-3 * before.mass * omega, "linear momentum " .. k)
    near(after.angular[k], before.angular[k], 2e-3 * math.abs(before.angular[2]), "angular momentum " .. k)
  end
end)

case("a member at offsets is removed, and one that breaks leaves its node", function()
  for _, how in ipairs { "remove", "break" } do
    local by = offsets["to all sides"]
    local m, heads, girder = portal({}, by[1], by[2], "offset")
    if how == "remove" then m:remove { member = girder, at = 2e-3, over = 0 }
    else m:fracture { group = "girder", curvature_x = 1e-6, axial_strain = 1e-6 } end
    local run = runs.completed(m:dynamic { dt = 1e-5, duration = 6e-3 }, how)
    expect(run:count { state = "broken" } > 0, "%s: nothing broke", how)
    expect(math.abs(run.energy_error) < 1e-3, "%s: energy error %g of the largest energy", how, run.energy_error)
    local ux = heads[0]:displacement(run)
    expect(ux > -0.1 and ux < 0.1, "%s: the head has moved by %g m", how, ux)
  end
end)

case("a run with offset ends and no joint goes on from its checkpoint with the same bits", function()
  local by = offsets["to all sides"]
  local m = portal({}, by[1], by[2], "offset")
  runs.resumes(function() return m:dynamic { dt = 1e-5, duration = 2e-3 } end, 1e-3, "offsets")
end)

case("wrong offsets are refused at their line", function()
  local m = hinge.model()
  local a, b = m:node { 0, 0, 0 }, m:node { 1, 0, 0 }
  local function refused(offset, words, up)
    checks.refused(words, m.member, m, { a, b, section = beam, material = steel, offset = offset, up = up })
  end
  refused({ 0, 0, 1 }, "offset")
  refused({ c = { 0, 0, 1 } }, "unknown field 'c'")
  refused({ a = { 0, 0 } }, "offset")
  refused({ a = { 1, 0, 0 } }, "one place")
  refused({ a = { 1, 0, -1 } }, "must point across", { 0, 0, 1 })
end)

checks.done()

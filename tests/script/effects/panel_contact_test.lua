-- Contact of panels: momentum, energy, restitution, friction, rest; seams, rims and members across panels; panels on
-- the ground; what is wrong is refused.
--
-- Run: lua5.4 tests/script/effects/panel_contact_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local panel_cells = require "panel_cells"
local hinge = require "hinge"
local checks = support.checks "panel contact"
local case = checks.case
local function near(what, value, wanted, tolerance) checks.near(value, wanted, tolerance, what) end
local function equal(what, value, wanted) checks.equal(value, wanted, what) end

local g = 9.80665 -- m/s^2
local steel = hinge.material { E = 200e9, nu = 0.25, density = 8000 }
local plate = { thickness = 0.02, material = steel } -- 160 kg/m^2

local function cells(model, n, m, place, options, mixed)
  return panel_cells.lay(model, n, m, place, options or plate, mixed)
end
local function each(nodes, f)
  for i = 0, #nodes do
    for j = 0, #nodes[i] do f(nodes[i][j], i, j) end
  end
end
local function fix(model, nodes) each(nodes, function(node) model:fix(node, "xyz") end) end
local function set_going(model, nodes, v) each(nodes, function(node) model:velocity(node, v) end) end
local function z_of(run, node) return node.z + select(3, run:displacement(node)) end

-- Momentum and energy -------------------------------------------------------------------------------------------------

-- A plate flies at another, both free, askew to each other; `axes`: where x, y, z of the scene point.
local function flight(o)
  local ax = o.axes or { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }
  local function turned(p)
    local q = {}
    for k = 1, 3 do q[k] = p[1] * ax[1][k] + p[2] * ax[2][k] + p[3] * ax[3][k] end
    return q
  end
  local model = hinge.model()
  local low = cells(model, 3, 3, function(i, j) return turned { i, j, 0 } end)
  local high = cells(model, 3, 3, function(i, j) return turned { i + 0.31, j * 0.9 + 0.17, 0.1 + 0.02 * i } end)
  set_going(model, high, turned { 2, 0, -3 })
  local contact = model:panel_contact { friction = o.friction, restitution = o.restitution }
  local run = model:dynamic { dt = o.dt, duration = o.duration or 0.1, integrator = o.integrator, record = false }
  return run, model, low, high, contact
end

case("two plates that meet keep their momentum and energy, in both methods, at any place in space", function()
  local c, q = math.cos(0.7), math.sin(0.7)
  local skew = { { c, q, 0 }, { -q * c, c * c, q }, { q * q, -q * c, c } }
  local found = {}
  for _, o in ipairs { { integrator = "newmark", dt = 1e-4 }, { integrator = "explicit", dt = 1e-5 },
    { integrator = "newmark", dt = 1e-4, axes = skew } } do
    o.friction, o.restitution = 0.4, 0.5
    local run, _, _, high, contact = flight(o)
    local before, most = run:momentum(), 0
    for _ in run:steps() do most = support.largest_of(most, (contact:pressing(run))) end
    local after = run:momentum()
    equal("points that pressed", most > 5, true)
    equal("none presses at the end", contact:pressing(run), 0)
    local size = 3 * before.mass
    for k = 1, 3 do
      near("linear momentum", after.linear[k], before.linear[k], 1e-9 * size)
      near("angular momentum", after.angular[k], before.angular[k], 1e-5 * size)
    end
    near("energy error", run.energy_error, 0, 1e-4)
    equal("friction and restitution take energy", run.energy.panel_contact_lost > 0.05 * run.energy.kinetic, true)
    local v = { run:velocity(high[1][1]) }
    found[#found + 1] = { run.energy.panel_contact_lost, run.energy.kinetic, math.sqrt(v[1] ^ 2 + v[2] ^ 2 + v[3] ^ 2) }
  end
  near("lost, explicit", found[2][1], found[1][1], 0.02 * found[1][1])
  near("kinetic, explicit", found[2][2], found[1][2], 0.02 * found[1][2])
  near("lost, rotated", found[3][1], found[1][1], 1e-3 * found[1][1])
  near("a velocity, rotated", found[3][3], found[1][3], 1e-3 * found[1][3])
end)

case("what is turned round, or declared in another order, meets as before", function()
  local function falls(o)
    local model = hinge.model()
    local function lay(nodes)
      local p = {}
      for k = 1, 4 do p[k] = nodes[(k + o.first - 2) % 4 + 1] end
      if o.back then p[2], p[4] = p[4], p[2] end
      for key, value in pairs(plate) do p[key] = value end
      return model:panel(p)
    end
    local function square(z, x, size)
      local list = {}
      for i, p in ipairs { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } do
        list[i] = model:node { x + size * p[1], size * p[2] + x / 2, z }
      end
      return list
    end
    local low, high
    if o.high_first then high, low = square(0.1, 0.2, 0.5), square(0, 0, 1)
    else low, high = square(0, 0, 1), square(0.1, 0.2, 0.5) end
    if o.high_first then lay(high) end
    lay(low)
    if not o.high_first then lay(high) end
    model:fix(low, "xyz")
    model:gravity { 0, 0, -g }
    model:panel_contact { friction = 0.2, restitution = 0.5 }
    local run = model:dynamic { dt = 2e-5, duration = 0.4, integrator = "explicit" }:finish()
    return z_of(run, high[1]), run.energy.panel_contact_lost
  end
  local z, lost = falls { first = 1 }
  equal("it bounces", z > 0.01 and lost > 0, true)
  for _, o in ipairs { { first = 3 }, { first = 1, back = true }, { first = 2, high_first = true } } do
    local again, lost_again = falls(o)
    near("place", again, z, 1e-9)
    near("energy lost", lost_again, lost, 1e-6 * lost)
  end
end)

-- Restitution, friction, rest -----------------------------------------------------------------------------------------

-- A fixed panel of 4 by 4 m that leans by an angle about y, and a small plate that lies `gap` above its surface.
local function on_slope(o)
  local c, s = math.cos(o.angle or 0), math.sin(o.angle or 0)
  local function place(x, y, z) return { c * x + s * z, y, -s * x + c * z } end
  local model = hinge.model()
  local low = cells(model, o.cells or 1, o.cells or 1,
    function(i, j) return place(4 * i / (o.cells or 1) - 2, 4 * j / (o.cells or 1) - 2, 0) end, plate, o.mixed)
  fix(model, low)
  local high = cells(model, 1, 1, function(i, j)
    return place(i * 0.5 + (o.x or 0), j * 0.5 - 0.25, 0.02 + (o.gap or 0))
  end)
  model:gravity { 0, 0, -g }
  local contact = model:panel_contact { friction = o.friction, restitution = o.restitution, stiffness = o.stiffness }
  if o.v then set_going(model, high, place(o.v, 0, 0)) end
  local run = model:dynamic { dt = o.dt or 2e-4, duration = o.duration or 0.3, integrator = o.integrator }
  return run, high, contact
end

case("a plate that falls flat comes back with the restitution's part of its speed, whatever the method", function()
  for _, integrator in ipairs { "newmark", "explicit" } do
    for _, restitution in ipairs { 1, 0.6, 0.2 } do
      local run, high = on_slope { gap = 0.2, restitution = restitution, integrator = integrator,
        dt = integrator == "explicit" and 2e-5 or nil, duration = 0.25 }
      run:finish()
      local v = math.sqrt(2 * g * 0.2)
      local since = 0.25 - v / g - math.pi / 2 / 400 * (1 + restitution) -- what the contact takes
      near(integrator .. " velocity", (select(3, run:velocity(high[0][0]))), restitution * v - g * since, 0.02 * v)
      near("energy error", run.energy_error, 0, 1e-4)
    end
  end
end)

case("what comes at v goes v / 400 deep, and sinks in by its weight: its mass times (400 rad/s)^2", function()
  local run, _, contact = on_slope { gap = 0.2, duration = 0.25 }
  local deepest = 0
  for _ in run:steps() do deepest = support.largest_of(deepest, (select(3, contact:pressing(run)))) end
  near("deepest", deepest, math.sqrt(2 * g * 0.2) / 400, 0.02 * deepest)
  local still, _, under = on_slope { restitution = 0.2, duration = 0.3 }
  local _, force, depth = under:pressing(still:finish())
  near("weight", force, 40 * g, 0.01 * 40 * g)
  near("sinks in", depth, g / 400 ^ 2, 0.01 * depth)
end)

case("an oblique blow loses mu (1 + e) v of its speed along the surface, on panels and on the ground", function()
  local v, mu = 3, 0.2
  for _, what in ipairs { "panel", "layer", "points" } do
    for _, integrator in ipairs { "newmark", "explicit" } do
      for _, e in ipairs(what == "layer" and { 0.2 } or { 1, 0.3 }) do
        local model = hinge.model()
        if what == "panel" then
          fix(model, (cells(model, 1, 1, function(i, j) return { 20 * i - 10, 20 * j - 10, 0 } end)))
          model:panel_contact { friction = mu, restitution = e }
        else
          model:ground { friction = mu, restitution = what == "points" and e or nil }
        end
        local high = cells(model, 1, 1, function(i, j) return { 0.5 * i, 0.5 * j, 0.05 } end)
        set_going(model, high, { 6, 0, -v })
        local run = model:dynamic { dt = 2e-5, duration = 0.06, integrator = integrator }:finish()
        local vx, _, vz = run:velocity(high[0][0])
        local name = ("%s, %s, e = %g"):format(what, integrator, e)
        near(name .. ": out", vz, e * v, 0.03 * v)
        near(name .. ": along", vx, 6 - mu * (1 + e) * v, 0.03 * mu * (1 + e) * v)
        near("energy error", run.energy_error, 0, 1e-4)
      end
    end
  end
end)

case("friction lets a plate slide as Coulomb says, and holds one on a gentle slope", function()
  local angle, mu = 0.5, 0.3
  local run, high = on_slope { angle = angle, friction = mu, duration = 0.4, x = -1.5 }
  run:finish()
  local a = g * (math.sin(angle) - mu * math.cos(angle))
  local ux, _, uz = run:displacement(high[0][0])
  near("way down", ux * math.cos(angle) - uz * math.sin(angle), 0.5 * a * 0.4 ^ 2, 0.01 * 0.5 * a * 0.4 ^ 2)
  near("energy error", run.energy_error, 0, 1e-4)
  local held, there = on_slope { angle = 0.2, friction = mu, duration = 0.4 }
  held:finish()
  ux, _, uz = held:displacement(there[0][0])
  near("held", math.sqrt(ux ^ 2 + uz ^ 2), 0, 3e-3) -- it has no weight to be held by before it sinks in
end)

case("a frictionless plate slides over the seams of panels as if there were none, and falls off the rim", function()
  for _, mixed in ipairs { false, true } do
    local run, high = on_slope { cells = 5, v = 2, x = -1.7, duration = 0.95, mixed = mixed }
    for _ in run:steps() do
      near("height", z_of(run, high[0][0]), 0.02, 2e-4)
      near("speed", (run:velocity(high[0][0])), 2, 1e-3)
    end
    near("energy error", run.energy_error, 0, 1e-4)
  end
  local off, plate_off = on_slope { cells = 5, v = 2, x = 1.2, duration = 1 }
  off:finish()
  equal("off the rim", z_of(off, plate_off[1][1]) < -1, true)
  near("energy error", off.energy_error, 0, 1e-3)
end)

case("a plate that slides into a valley of panels gains no energy at the seam", function()
  local angle = 0.5
  local model = hinge.model()
  local low = cells(model, 2, 1, function(i, j)
    return { 2 * (i - 1) * math.cos(angle), 4 * j - 2, 2 * math.abs(i - 1) * math.sin(angle) }
  end, { thickness = 0.02, material = steel, bending = false })
  fix(model, low)
  local c, s = math.cos(angle), math.sin(angle)
  cells(model, 1, 1, function(i, j)
    local x, z = -1.5 + 0.4 * i, 0.021
    return { x * c + z * s, 0.4 * j - 0.2, -x * s + z * c }
  end)
  model:gravity { 0, 0, -g }
  model:panel_contact {}
  local run = model:dynamic { dt = 1e-4, duration = 0.8 }:finish()
  near("energy error", run.energy_error, 0, 2e-3)
  equal("no less than nothing is lost", run.energy.panel_contact_lost > -1e-9, true)
end)

case("a pile of plates comes to rest, and each carries what lies on it", function()
  local model, plates = hinge.model(), {}
  for k = 0, 5 do
    plates[k] = cells(model, 1, 1, function(i, j) return { i + 0.03 * (k % 2), j, 0.1 * k } end)
  end
  fix(model, plates[0])
  model:gravity { 0, 0, -g }
  local contact = model:panel_contact { friction = 0.5, restitution = 0.2 }
  local run = model:dynamic { dt = 1e-3, duration = 2 }:finish()
  for k = 1, 5 do
    near("height", z_of(run, plates[k][0][0]), 0.02 * k, 2e-3)
    near("speed", (select(3, run:velocity(plates[k][1][1]))), 0, 0.02)
  end
  local points, force, depth = contact:pressing(run)
  equal("points press", points >= 15, true)
  near("forces", force, (5 + 4 + 3 + 2 + 1) * 160 * g, 0.1 * 15 * 160 * g)
  equal("depth", depth < 1e-3, true)
end)

case("however deep a point goes it comes back, also on panels that have no thickness", function()
  for _, o in ipairs { { panel = { thickness = 0.002, material = steel }, v = 3 },
    { panel = { reinforcement = { x = 1e-3, y = 1e-3 }, mass = 160 }, v = 1 } } do
    for _, integrator in ipairs { "newmark", "explicit" } do
      local model = hinge.model()
      fix(model, (cells(model, 1, 1, function(i, j) return { i, j, 0 } end, o.panel)))
      local high = cells(model, 1, 1, function(i, j) return { 0.3 + 0.4 * i, 0.3 + 0.4 * j, 0.03 } end, o.panel)
      set_going(model, high, { 0, 0, -o.v })
      model:panel_contact {}
      local run = model:dynamic { dt = 2e-5, duration = 0.05, integrator = integrator }:finish()
      near(integrator, (select(3, run:velocity(high[0][0]))), o.v, 1e-3 * o.v)
      near("energy error", run.energy_error, 0, 1e-4)
    end
  end
end)

-- Members and panels --------------------------------------------------------------------------------------------------

case("a bar that falls across a panel, its ends beyond, is stopped; so is one that a panel falls on", function()
  for _, which in ipairs { "bar", "panel" } do
    local model = hinge.model()
    local low = cells(model, 1, 1, function(i, j) return { i, j, which == "bar" and 0 or 0.3 } end)
    local section = hinge.section.solid { width = 0.05, depth = 0.05 }
    local a, b = model:node { -2, 0.5, which == "bar" and 0.3 or 0 }, model:node { 3, 0.5, which == "bar" and 0.3 or 0 }
    local middle = model:member { a, b, section = section, material = steel, elements = 2 }:node(1)
    if which == "bar" then fix(model, low)
    else
      model:fix(a)
      model:fix(b)
    end
    model:gravity { 0, 0, -g }
    model:panel_contact { restitution = 0.3 }
    local run = model:dynamic { dt = 2e-4, duration = 0.5 }
    local lowest = 1
    for _ in run:steps() do
      local of_bar = z_of(run, middle)
      lowest = support.smallest_of(lowest, which == "bar" and of_bar or z_of(run, low[0][0]) - of_bar)
    end
    near(which, lowest, 0.035, 0.03)
    near("energy error", run.energy_error, 0, 1e-3)
  end
  local model = hinge.model() -- without members
  local low = cells(model, 1, 1, function(i, j) return { i, j, 0 } end)
  fix(model, low)
  local a, b = model:node { -2, 0.5, 0.3 }, model:node { 3, 0.5, 0.3 }
  model:member { a, b, section = hinge.section.solid { width = 0.05, depth = 0.05 }, material = steel }
  model:gravity { 0, 0, -g }
  model:panel_contact { members = false }
  near("falls", z_of(model:dynamic { dt = 1e-3, duration = 0.5 }:finish(), a), 0.3 - 0.5 * g * 0.25, 0.01)
end)

case("a panel that tears under what has fallen on it lets it go, and the energy closes", function()
  local model = hinge.model()
  local weak = { reinforcement = { x = 2e-5, y = 2e-5, yield_stress = 400e6, ultimate_strain = 0.02 }, mass = 20 }
  local low, panels = cells(model, 2, 2, function(i, j) return { i, j, 0 } end, weak)
  each(low, function(node, i, j) if i ~= 1 or j ~= 1 then model:fix(node, "xyz") end end)
  local high = cells(model, 1, 1, function(i, j) return { 0.7 + 0.6 * i, 0.75 + 0.6 * j, 0.5 } end,
    { thickness = 0.2, material = steel })
  set_going(model, high, { 0, 0, -25 })
  model:panel_contact { restitution = 0.5 }
  local run = model:dynamic { dt = 1e-4, duration = 0.2 }:finish()
  local torn = 0
  for _, panel in ipairs(panels) do torn = torn + (panel:torn(run) and 1 or 0) end
  equal("torn", torn > 0, true)
  equal("through", z_of(run, high[0][0]) < -0.3, true)
  near("energy error", run.energy_error, 0, 1e-3)
end)

case("panels fall on the ground and lie there", function()
  for _, ground in ipairs { {}, { stiffness = 1e6 }, { restitution = 0.5, friction = 0.3 } } do
    local model = hinge.model()
    local nodes = cells(model, 2, 2, function(i, j) return { i, j, 0.5 } end)
    model:gravity { 0, 0, -g }
    model:ground(ground)
    local run = model:dynamic { dt = 2e-4, duration = 1.5 }:finish()
    local z = z_of(run, nodes[1][1])
    local bounce = ground.restitution and 0.03 or ground.stiffness and 0.6 or 0.005
    near("height", z, 0.01, bounce)
    near("energy error", run.energy_error, 0, 1e-3)
  end
  for _, integrator in ipairs { "newmark", "explicit" } do -- down a slope of 20 degrees, from where it touches
    local angle, mu, model = math.rad(20), 0.2, hinge.model()
    local nodes = cells(model, 1, 1, function(i, j) return { 0.5 * i, 0.5 * j, 0.01 } end)
    model:gravity { g * math.sin(angle), 0, -g * math.cos(angle) }
    model:ground { friction = mu }
    local dt = integrator == "explicit" and "auto" or 1e-4
    local run = model:dynamic { dt = dt, duration = 0.5, integrator = integrator }:finish()
    local way = 0.5 * g * (math.sin(angle) - mu * math.cos(angle)) * 0.5 ^ 2
    near(integrator, (run:displacement(nodes[0][0])), way, 0.01 * way)
    near("energy error", run.energy_error, 0, 1e-3)
  end
end)

case("a basement under the ground is left out, as members are", function()
  local model = hinge.model()
  local low = cells(model, 1, 1, function(i, j) return { i, j, -3 } end)
  model:gravity { 0, 0, -g }
  model:ground {}
  local run = model:dynamic { dt = 1e-3, duration = 0.4 }:finish()
  near("falls", z_of(run, low[0][0]), -3 - 0.5 * g * 0.4 ^ 2, 1e-3)
end)

-- Runs ----------------------------------------------------------------------------------------------------------------

case("a checkpoint while plates press on each other goes on with the same bits", function()
  local folder = support.temporary_folder()
  local function new() return flight { dt = 1e-4, friction = 0.4, restitution = 0.5, integrator = "newmark" } end
  local whole = new():finish()
  local part, _, _, _, contact = new()
  local pressed = false
  for _ in part:steps() do
    pressed = contact:pressing(part) > 2
    if pressed then break end
  end
  equal("pressed", pressed, true)
  part:checkpoint(folder .. "/plates")
  local rest = new()
  rest:resume(folder .. "/plates")
  equal("hash", rest:finish().hash, whole.hash)
end)

case("in a floor at rest, whose beams have joints, nothing presses: contact of panels changes no bit", function()
  local hash = {}
  for _, with in ipairs { false, true } do
    local model = hinge.model { elements_per_member = 4 }
    local section, at = hinge.section.named "IPE 240", {}
    for i, p in ipairs { { 0, 0 }, { 5, 0 }, { 5, 4 }, { 0, 4 } } do
      at[i] = model:node { p[1], p[2], 3 }
      local foot = model:node { p[1], p[2], 0 }
      model:fix(foot)
      model:member { foot, at[i], section = section, material = steel }
    end
    local pin = hinge.joint { Mx = { stiffness = 1e5 } }
    for i = 1, 4 do
      model:member { at[i], at[i % 4 + 1], section = section, material = steel, group = "beams",
        ends = { a = pin, b = pin } }
    end
    model:floor { group = "beams", mass = 300, slab = { thickness = 0.1, material = steel } }
    model:gravity { 0, 0, -g }
    local contact = with and model:panel_contact { friction = 0.5 }
    local run = model:dynamic { from = model:static { steps = 1 }:finish(), dt = 1e-3, duration = 0.05 }:finish()
    if with then equal("presses", contact:pressing(run), 0) end
    hash[#hash + 1] = run.hash
  end
  equal("hash", hash[2], hash[1])
end)

case("a run that goes on from one with fewer panels has contact with all", function()
  local model, nodes = hinge.model(), {}
  for i = 0, 2 do
    for j = 0, 1 do
      nodes[2 * i + j] = model:node { i, j, 0 }
      model:fix(nodes[2 * i + j], "xyz")
    end
  end
  local function lay(k)
    model:panel { nodes[k], nodes[k + 2], nodes[k + 3], nodes[k + 1], thickness = 0.02, material = steel }
  end
  lay(0)
  local high = cells(model, 1, 1, function(i, j) return { 0.2 + 0.5 * i, 0.2 + 0.5 * j, 0.021 } end)
  model:gravity { 0, 0, -g }
  set_going(model, high, { 2, 0, 0 })
  model:panel_contact { restitution = 0.3 }
  local first = model:dynamic { dt = 1e-3, duration = 0.1 }:finish()
  lay(2)
  local run = model:dynamic { from = first, dt = 1e-3, duration = 0.5 }:finish() -- it slides onto the new one
  equal("over the new one", run:displacement(high[0][0]) > 0.9, true)
  near("height", z_of(run, high[0][0]), 0.02, 2e-3)
  near("energy error", run.energy_error, 0, 1e-4)
end)

case("panels that pass through each other without contact are warned of, and contact left out is as not declared",
  function()
    local model = hinge.model()
    fix(model, (cells(model, 1, 1, function(i, j) return { i, j, 0 } end)))
    cells(model, 1, 1, function(i, j) return { 0.2 + 0.5 * i, 0.2 + 0.5 * j, 0.3 } end)
    model:gravity { 0, 0, -g }
    local run = model:dynamic { dt = 1e-3, duration = 0.5 }:finish()
    local said = table.concat(run.warnings, "\n")
    equal(said, said:find("points passed through panels, first one through panel", 1, true) ~= nil
      and said:find("declare model:panel_contact {}", 1, true) ~= nil, true)
    model:panel_contact {}
    local held = model:dynamic { dt = 1e-3, duration = 0.5 }:finish()
    said = table.concat(held.warnings, "\n")
    equal(said, said:find("passed through", 1, true), nil)
    equal("another run", held.hash ~= run.hash, true)
  end)

case("wrong input is refused and changes nothing", function()
  local model = hinge.model()
  local function refused(options, words)
    local good, why = pcall(model.panel_contact, model, options)
    equal(tostring(why), not good and why:find(words, 1, true) ~= nil, true)
  end
  refused({ restitution = 0.1 }, "must be 0.2 to 1")
  refused({ restitution = 1.1 }, "must be 0.2 to 1")
  refused({ friction = -1 }, "friction")
  refused({ stiffness = 0 }, "stiffness")
  refused({ stiffness = 1e300 }, "must be at most")
  refused({ groups = {} }, "groups")
  refused({ members = 1 }, "members")
  local contact = model:panel_contact {}
  refused({}, "it is declared already")
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:member { a, b, section = hinge.section.named "IPE 200", material = steel }
  model:fix(a)
  local run = model:dynamic { dt = 1e-3, duration = 1e-2 }:finish() -- no panels: nothing to press on
  equal("nothing presses", contact:pressing(run), 0)
end)

checks.done()

-- Floors: loads and masses of areas on the members around them, against closed forms and against each other; masses
-- along members; openings, slopes, levels; wrong input is refused and changes nothing.
--
-- Run: lua5.4 tests/script/actions/floor_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "floors"
local case, near, equal = checks.case, checks.near, checks.equal
local largest_of = support.largest_of

local steel = hinge.material { E = 210e9, density = 7850 }
local section = hinge.section.named "IPE 300"
local g = 9.80665 -- m/s^2

-- Beams around a polygon of nodes, clamped at all corners where `fixed`.
local function ring(points, options)
  local model, nodes, members = hinge.model(options or { displacement = "small" }), {}, {}
  for i, p in ipairs(points) do nodes[i] = model:node(p) end
  for i, node in ipairs(nodes) do
    members[i] = model:member { node, nodes[i % #nodes + 1], section = section, material = steel, up = { 0, 0, 1 },
      group = "beams" }
  end
  return model, nodes, members
end

local function fixed(points, options)
  local model, nodes, members = ring(points, options)
  model:fix(nodes)
  return model, nodes, members
end

local function rectangle(a, b, z) return { { 0, 0, z or 3 }, { a, 0, z or 3 }, { a, b, z or 3 }, { 0, b, z or 3 } } end

-- All section forces at five places of all members, in one list.
local function forces(run, members)
  local list = {}
  for _, member in ipairs(members) do
    local rows, place = member:along(run, 4), 0
    for _, row in ipairs(rows) do
      local at = 4 * row.x / rows[#rows].x
      local is_next = math.abs(at - place) < 1e-9
      if is_next then place = place + 1 end
      for _, name in ipairs { "N", "Mx", "My", "Mz", "Qx", "Qy" } do
        if is_next then list[#list + 1] = row[name] end
      end
    end
    assert(place == 5, "five places")
  end
  return list
end

-- The largest difference between two lists over the largest of the first.
local function difference(one, two)
  local most, size = 0, 0
  for i, x in ipairs(one) do
    most, size = largest_of(most, math.abs(x - two[i])), largest_of(size, math.abs(x))
  end
  return #one == #two and most / size or 0 / 0
end

local function forces_of(points, floor, options)
  local model, _, members = fixed(points, options)
  model:gravity { 0, 0, -g }
  floor(model)
  return forces(model:static { steps = 1 }:finish(), members)
end

case("two ways: triangles and trapezoids", function()
  local p, a, b = 3e3, 6, 4
  local model, _, members = fixed(rectangle(a, b))
  local floor = model:floor { group = "beams", load = p }
  near(floor.area, 24, 1e-12, "area")
  near(floor.load, p * a * b, 1e-9, "load")
  equal(tostring(floor), "1 panel, 24 m^2, 72 kN on 4 members", "printed")
  local run, q, c = model:static { steps = 1 }:finish(), p * b / 2, b / (2 * a)
  -- clamped beams: a trapezoid with flanks of b/2 has q L^2/12 (1 - 2 c^2 + c^3), c = b / (2 L); a triangle 5 q L^2/96
  for i, member in ipairs(members) do
    local exact = i % 2 == 1 and q * a ^ 2 / 12 * (1 - 2 * c ^ 2 + c ^ 3) or 5 * q * b ^ 2 / 96
    local at_a = member:forces(run)
    near(largest_of(math.abs(at_a.Mx), math.abs(at_a.My)), exact, 1e-6 * exact, "end moment of member " .. i)
  end
end)

case("one way: across the shorter side, or as asked", function()
  for _, span in ipairs { "one way", { 0, 1, 0 }, { 0, -2, 0 } } do
    local floor = fixed(rectangle(6, 4)):floor { group = "beams", load = 1e3, span = span }
    for _, part in ipairs(floor.parts) do
      near(part.area, part.member.length == 6 and 12 or 0, 1e-12, "area of member " .. part.member.index)
    end
  end
  checks.refused("is as long as it is wide", function()
    fixed(rectangle(4, 4)):floor { group = "beams", load = 1e3, span = "one way" }
  end)
end)

-- The middle of mass of a polygon, and its area.
local function middle_of(points)
  local area, x, y, a = 0, 0, 0, points[1]
  for i = 2, #points - 1 do
    local b, c = points[i], points[i + 1]
    local part = ((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])) / 2
    area, x, y = area + part, x + part * (a[1] + b[1] + c[1]) / 3, y + part * (a[2] + b[2] + c[2]) / 3
  end
  return x / area, y / area, area
end

case("the resultant is that of the area: of two ways too, since the distance to the edge is 0 on it", function()
  for _, points in ipairs { rectangle(6, 4), { { 0, 0, 3 }, { 6, 1, 3 }, { 5, 5, 3 }, { 1, 4, 3 } },
    { { 0, 0, 3 }, { 6, 0, 3 }, { 0, 4, 3 } },
    { { 0, 0, 3 }, { 4, -1, 3 }, { 6, 2, 3 }, { 3, 5, 3 }, { -1, 3, 3 } } } do
    local x, y, area = middle_of(points)
    for _, span in ipairs { "two way", { 0, 1, 0 }, { 0.6, 0.8, 0 } } do
      local model, nodes = fixed(points)
      model:floor { group = "beams", load = 1e3, span = span }
      local run, F, Mx, My = model:static { steps = 1 }:finish(), 0, 0, 0
      for _, node in ipairs(nodes) do
        local _, _, z, mx, my = node:reaction(run)
        F, Mx, My = F + z, Mx + mx + node.y * z, My + my - node.x * z
      end
      near(F, 1e3 * area, 1e-9 * F, "sum")
      near(-My / F, x, 1e-11, "place along x")
      near(Mx / F, y, 1e-11, "place along y")
    end
  end
end)

-- A plan of crooked cells in a plane that is turned and slopes; some are divided by a diagonal, some sides by a node.
-- Returns the model, the corners around it, its area and a direction in it.
local function random_plan(seed)
  math.randomseed(seed)
  local function number(low, high) return low + (high - low) * math.random() end
  local nx, ny, turn, slope = math.random(1, 4), math.random(1, 4), number(0, 6), number(0, 0.6)
  local model, at, node = hinge.model { displacement = "small" }, {}, {}
  local function place(p)
    local u, v = math.cos(turn) * p[1] - math.sin(turn) * p[2], math.sin(turn) * p[1] + math.cos(turn) * p[2]
    return { u, v * math.cos(slope), v * math.sin(slope) }
  end
  local function add(a, b)
    if math.random() < 0.5 then a, b = b, a end
    model:member { a, b, section = section, material = steel, up = { 0.1, 0.2, 1 }, group = "beams" }
  end
  local function join(i, j)
    if math.random() < 0.6 then return add(node[i], node[j]) end
    local t = number(0.2, 0.8)
    local between = model:node(place { at[i][1] + t * (at[j][1] - at[i][1]), at[i][2] + t * (at[j][2] - at[i][2]) })
    add(node[i], between)
    add(between, node[j])
  end
  for i = 0, nx do
    for j = 0, ny do
      local k = 9 * i + j
      at[k] = { 6 * i + number(-1, 1), 4 * j + number(-0.7, 0.7) }
      node[k] = model:node(place(at[k]))
      if i > 0 then join(k - 9, k) end
      if j > 0 then join(k - 1, k) end
      if i > 0 and j > 0 and math.random() < 0.3 then join(k - 10, k) end
    end
  end
  local around = {}
  for i = 0, nx do around[#around + 1] = 9 * i end
  for j = 1, ny do around[#around + 1] = 9 * nx + j end
  for i = nx - 1, 0, -1 do around[#around + 1] = 9 * i + ny end
  for j = ny - 1, 1, -1 do around[#around + 1] = j end
  local flat, corners = {}, {}
  for i, k in ipairs(around) do flat[i], corners[i] = at[k], node[k] end
  local _, _, area = middle_of(flat)
  return model, corners, area, place { 1, 0 }
end

case("random plans: the sum is that of the area", function()
  for seed = 1, 60 do
    local model, corners, area, along = random_plan(seed)
    for _, span in ipairs { "two way", along } do
      local floor, sum = model:floor { corners = corners, load = 1e3, span = span }, 0
      for _, part in ipairs(floor.parts) do sum = sum + part.load end
      near(sum / (1e3 * area), 1, 1e-12, "sum of seed " .. seed)
    end
    model:close()
  end
end)

case("a mass weighs what a load of its weight does, on every member", function()
  local slanted = { { 0, 0, 3 }, { 6, 1, 3 }, { 5, 5, 3 }, { 1, 4, 3 } }
  for _, points in ipairs { rectangle(6, 4), slanted } do
    for _, options in ipairs { { displacement = "small" }, { displacement = "large" } } do
      local by_mass = forces_of(points, function(m) m:floor { group = "beams", mass = 400 } end, options)
      local by_load = forces_of(points, function(m) m:floor { group = "beams", load = 400 * g } end, options)
      near(difference(by_load, by_mass), 0, 1e-9, "section forces, " .. options.displacement)
      local declared_last = forces_of(points, function(m)
        m:floor { group = "beams", mass = 100 }
        m:floor { members = m:group("beams"):members(), mass = 300 }
      end, options)
      near(difference(by_mass, declared_last), 0, 1e-9, "in two parts")
    end
  end
  local none = forces_of(slanted, function() end)
  near(difference(none, forces_of(slanted, function(m) m:floor { group = "beams", mass = 0, load = 0 } end)), 0, 0,
    "nothing")
end)

case("masses along members", function()
  local model, nodes, members = fixed(rectangle(6, 4))
  local own = members[1].mass
  model:mass { member = members[1], per_length = 100 }
  model:mass { member = members[1], per_length = { b = 60 }, from = 0.5 }
  near(members[1].mass, own + 600 + 90, 1e-9, "mass of the member")
  model:mass { group = "beams", per_length = 10 }
  near(model:group("beams").mass, 20 * (section.area * 7850 + 10) + 690, 1e-9, "mass of the group")
  local later = model:node { 3, 2, 3 }
  local more = model:member { nodes[1], later, section = section, material = steel, up = { 0, 0, 1 },
    group = "beams" }
  near(more.mass, more.length * (section.area * 7850 + 10), 1e-9, "a member that joins the group later")
end)

case("natural frequencies fall by the mass", function()
  local box = hinge.section.box { width = 0.2, depth = 0.1, thickness = 0.008 }
  local function frequency(more)
    local model = hinge.model { displacement = "small" }
    local a, b = model:node { 0, 0, 0 }, model:node { 5, 0, 0 }
    local beam = model:member { a, b, section = box, material = steel, up = { 0, 0, 1 } }
    model:fix({ a, b }, "all")
    if more > 0 then model:mass { member = beam, per_length = more } end
    return model:dynamic { dt = 1e-3, duration = 1e-3 }:modes { n = 1 }[1].frequency
  end
  local own = box.area * 7850
  near(frequency(3 * own) / frequency(0), 0.5, 1e-3, "four times the mass") -- but for the section's rotary inertia
end)

case("at rest from statics, by each integrator", function()
  for _, integrator in ipairs { "newmark", "explicit", "energy-momentum" } do
    local model, nodes, members = ring({ { 0, 0, 3 }, { 6, 1, 3 }, { 5, 5, 3 }, { 1, 4, 3 } }, {})
    for i, node in ipairs(nodes) do
      local foot = model:node { node.x, node.y, 0 }
      model:fix(foot)
      model:member { foot, node, section = section, material = steel, up = { i, 1, 0 } }
    end
    model:gravity { 0, 0, -g }
    model:floor { group = "beams", mass = 400, load = 500 }
    local rest = model:static { steps = 3 }:finish()
    local before = forces(rest, members)
    local run = model:dynamic { from = rest, integrator = integrator, duration = 0.02,
      dt = integrator == "explicit" and "auto" or 1e-3 }:finish()
    near(difference(before, forces(run, members)), 0, 1e-8, integrator .. ": section forces after 20 ms")
    near(run.energy_error, 0, 1e-7, integrator .. ": energy error")
  end
end)

case("what falls freely does not turn", function()
  local model, nodes, members = ring { { 0, 0, 30 }, { 6, 1, 30 }, { 5, 5, 30 }, { 1, 4, 30 } }
  model:gravity { 0, 0, -g }
  model:floor { group = "beams", mass = 400 }
  local run = model:dynamic { dt = 1e-3, duration = 0.1 }:finish()
  for i, node in ipairs(nodes) do
    local _, _, uz = node:displacement(run)
    near(uz, -g * 0.1 ^ 2 / 2, 1e-4 * g * 0.1 ^ 2 / 2, "fall of node " .. i)
  end
  local most = 0
  for _, x in ipairs(forces(run, members)) do most = largest_of(most, math.abs(x)) end
  near(most / (400 * 19 * g), 0, 1e-6, "section forces over the weight")
end)

case("loads by case, and statics that goes on", function()
  local model, _, members = fixed(rectangle(6, 4))
  model:case "live"
  model:case("dead"):gravity { 0, 0, -g }
  model:floor { group = "beams", mass = 400, load = { dead = 500, live = 2000 } }
  local all = forces(model:static { steps = 1, loads = { dead = 1.2, live = 1.5 } }:finish(), members)
  local first = model:static { steps = 1, loads = { dead = 1.2 } }:finish()
  local second = forces(model:static { steps = 2, from = first, loads = { dead = 1.2, live = 1.5 } }:finish(), members)
  near(difference(all, second), 0, 1e-9, "in two runs")
  local by_load = forces_of(rectangle(6, 4), function(m)
    m:gravity { 0, 0, -1.2 * g }
    m:floor { group = "beams", load = 1.2 * (400 * g + 500) + 1.5 * 2000 }
  end)
  near(difference(all, by_load), 0, 1e-9, "against one load")
end)

case("levels, corners, slopes", function()
  local model = hinge.model()
  local grid = hinge.grid { model = model, x = { 0, 6, 12 }, y = { 0, 4, 9 }, z = { 0, 3, 6 } }
  grid:defaults { section = section, material = steel, elements = 2 }
  grid:columns { group = "columns" }
  for _, along in ipairs { "x", "y" } do grid:beams { along = along, group = "beams" } end
  local all = model:floor { group = "beams", load = 1 }
  equal(#all.panels, 8, "panels of two storeys")
  near(all.area, 2 * 12 * 9, 1e-9, "area")
  local part = model:floor { load = 1, corners = { grid:node("A1", 2), grid:node("B1", 2), grid:node("B3", 2),
    grid:node("A3", 2) } }
  equal(#part.panels, 2, "panels between corners")
  near(part.area, 6 * 9, 1e-9, "area between corners")
  -- a roof of 30 degrees: the same load on the sloped area
  local c, s = math.cos(math.pi / 6), math.sin(math.pi / 6)
  local roof, nodes = fixed { { 0, 0, 0 }, { 6, 0, 0 }, { 6, 4 * c, 4 * s }, { 0, 4 * c, 4 * s } }
  local sloped = roof:floor { corners = nodes, load = 1e3 }
  near(sloped.load, 24e3, 1e-8, "load of a slope")
end)

case("openings", function()
  local model = fixed(rectangle(6, 4))
  local opening = { { 1, 1, 3 }, { 3, 1, 3 }, { 3, 2, 3 }, { 1, 2, 3 } }
  local floor = model:floor { corners = rectangle(6, 4), load = 1e3, openings = { opening } }
  near(floor.area, 22, 1e-9, "area")
  near(floor.load, 22e3, 1e-6, "load")
  local function refused(words, openings)
    checks.refused(words, function()
      model:floor { corners = rectangle(6, 4), load = 1e3, openings = openings }
    end)
  end
  refused({ "must lie in it whole" }, { { { 5, 1, 3 }, { 8, 1, 3 }, { 8, 2, 3 } } })
  refused({ "openings[2]", "overlaps openings[1]" }, { opening, opening })
  refused({ "off the plane" }, { { { 1, 1, 3 }, { 2, 1, 3 }, { 2, 2, 2 } } })
end)

case("wrong input is refused and changes nothing", function()
  local model, nodes, members = fixed(rectangle(6, 4))
  model:case "dead"
  local function refused(what, words, options)
    local loads = #model:loads()
    checks.refused(words, function() model:floor(options) end)
    equal(#model:loads(), loads, what .. ": loads")
    near(members[1].mass, section.area * 7850 * 6, 1e-9, what .. ": mass")
  end
  refused("nothing given", { "neither 'load' (Pa) nor 'mass'" }, { group = "beams" })
  refused("nowhere", { "give 'corners', 'members' or 'group'" }, { load = 1 })
  refused("a word", { "field 'load' is 'much'" }, { group = "beams", load = "much" })
  refused("negative mass", { "field 'mass' is -1" }, { group = "beams", mass = -1 })
  refused("not closed", { "close no panel" }, { members = { members[1], members[2], members[3] }, load = 1 })
  refused("half a floor", { "no members lie along the whole edge", "{9, 0, 3} m" },
    { corners = rectangle(9, 4), load = 1 })
  refused("a triangle without a diagonal", { "no members lie along the whole edge" },
    { corners = { nodes[1], nodes[2], nodes[3] }, load = 1 })
  refused("two corners exchanged", { "are not in their order" },
    { corners = { nodes[1], nodes[3], nodes[2], nodes[4] }, load = 1 })
  refused("edges that cross", { "the edges from point 1 to 2 and from point 3 to 4 cross" },
    { corners = { { 0, 0, 3 }, { 6, 4, 3 }, { 6, 0, 3 }, { 1, 5, 3 } }, load = 1 })
  refused("a list of loads", { "'load' is a list" }, { group = "beams", load = { 1e3 } })
  refused("no such case", { "unknown load case 'lve'" }, { group = "beams", mass = 5, load = { dead = 1, lve = 2 } })
  local inside = model:node { 3, 2, 3 }
  local island = { model:node { 3.5, 2, 3 }, model:node { 3, 2.5, 3 } }
  for i, pair in ipairs { { inside, island[1] }, { island[1], island[2] }, { island[2], inside } } do
    model:member { pair[1], pair[2], section = section, material = steel, up = { 0, 0, 1 },
      group = i < 4 and "island" }
  end
  refused("an island", { "lies inside a panel" }, { corners = nodes, load = 1 })
  local bent = fixed { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 2, 1, 0 } }
  checks.refused({ "points inward", "{2, 1, 0}" }, function()
    bent:floor { group = "beams", load = 1 }
  end)
end)

case("a floor goes to the bay that it is in, or to none", function()
  local model = hinge.model()
  local grid = hinge.grid { model = model, x = { 0, 6, 12 }, y = { 0, 5 }, z = { 0, 3 } }
  grid:defaults { section = section, material = steel }
  for _, along in ipairs { "x", "y" } do grid:beams { along = along, group = "beams" } end
  -- as large as a bay, and between two of them
  checks.refused("no members lie along the whole edge of the floor from {9, 0, 3} m to {9, 5, 3} m", function()
    model:floor { corners = { { 3, 0, 3 }, { 9, 0, 3 }, { 9, 5, 3 }, { 3, 5, 3 } }, mass = 100 }
  end)
  local second = grid:floor { cells = { "B1-C2" }, mass = 100 }
  equal(#second.panels, 1, "panels")
  for _, node in ipairs(second.panels[1].nodes) do checks.expect(node.x >= 6, "a corner at x = %g m", node.x) end
  checks.refused({ "in two of the floors" }, function()
    grid:floor { cells = { "A1-B2", "A1-C2" }, mass = 100 }
  end)
  checks.refused({ "field 'cells': 'A1-D2'", "unknown line 'D2'" }, function()
    grid:floor { cells = { "A1-D2" }, mass = 100 }
  end)
  -- a beam between main beams that have no node there; and one of the group that has no panel
  local a, b = model:node { 3, 0, 3 }, model:node { 3, 5, 3 }
  local lost = model:member { a, b, section = section, material = steel, group = "secondary" }
  checks.refused({ ("member %d"):format(lost.index), "carries nothing; join it" }, function()
    grid:floor { mass = 100 }
  end)
  model:member { grid:node("C1", 1), model:node { 15, 0, 3 }, section = section, material = steel, group = "beams" }
  local floor = model:floor { group = "beams", load = 1 }
  equal(#floor.idle, 1, "members that carry nothing")
  checks.expect(tostring(floor):find("; 1 member of those given carries nothing", 1, true), "%s", tostring(floor))
end)

case("reactions and loads over parts of members are in balance", function()
  local model = fixed(rectangle(6, 4))
  model:floor { group = "beams", load = 1e3 }
  local base = hinge.results.base(model:static { steps = 1 }:finish(), { model = model })
  near(base.rows.loads.Fz, -24e3, 1e-6, "loads")
  checks.expect(tostring(base):find("in balance: the rest", 1, true), "%s", tostring(base))
end)

case("masses along members are refused where they make no sense", function()
  local model, nodes, members = fixed(rectangle(6, 4))
  local function refused(words, options)
    checks.refused(words, function() model:mass(options) end)
  end
  refused({ "'per_length' is -1 kg/m" }, { member = members[1], per_length = -1 })
  refused({ "'b' is -2 kg/m" }, { member = members[1], per_length = { b = -2 } })
  model:mass { member = members[1], per_length = 0 }
  near(members[1].mass, section.area * 7850 * 6, 1e-12, "a mass of zero")
  refused({ "given without 'member' or 'group'" }, { node = nodes[1], mass = 1, per_length = 3 })
  refused({ "must be less than 'to'" }, { member = members[1], per_length = 1, from = 0.5, to = 0.4 })
  refused({ "given beside a member" }, { member = members[1], node = nodes[1], per_length = 1 })
end)

checks.done()

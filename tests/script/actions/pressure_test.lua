-- Pressure on areas: total force, shares of the members, end moments of trapezoids and triangles and support moments
-- against closed forms; areas across space, chains of members, areas that end within members; values that differ from
-- place to place; faces; histories; wrong input is refused.
--
-- Run: lua5.4 tests/script/actions/pressure_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local pressure = require "hinge.actions.pressure"
local checks = support.checks "pressure"
local case, near, equal = checks.case, checks.near, checks.equal

local steel = hinge.material { E = 210e9, density = 7850 }
local section = hinge.section.named "IPE 300"
local down = { 0, 0, -1 }

-- Four beams around a bay of a by b metres, clamped at all corners or free, 3 m up.
local function bay(a, b, free)
  local model, nodes, members = hinge.model { displacement = free and "large" or "small" }, {}, {}
  for i, p in ipairs { { 0, 0 }, { a, 0 }, { a, b }, { 0, b } } do nodes[i] = model:node { p[1], p[2], 3 } end
  if not free then model:fix(nodes) end
  for i = 1, 4 do
    members[i] = model:member { nodes[i], nodes[i % 4 + 1], section = section, material = steel, up = { 0, 0, 1 },
      group = "beams" }
  end
  return model, nodes, members, { { 0, 0, 3 }, { a, 0, 3 }, { a, b, 3 }, { 0, b, 3 } }
end

-- Sum of the reactions, and of their moments about the origin.
local function reactions(run, nodes)
  local f, m = { 0, 0, 0 }, { 0, 0, 0 }
  for _, node in ipairs(nodes) do
    local x, y, z, mx, my, mz = node:reaction(run)
    f[1], f[2], f[3] = f[1] + x, f[2] + y, f[3] + z
    m[1] = m[1] + mx + node.y * z - node.z * y
    m[2] = m[2] + my + node.z * x - node.x * z
    m[3] = m[3] + mz + node.x * y - node.y * x
  end
  return f, m
end

local p, a, b = 3e3, 6, 4 -- Pa, m

case("two way: triangles and trapezoids", function()
  local model, _, members, corners = bay(a, b)
  local result = pressure { model = model, group = "beams", on = corners, value = p, direction = down,
    spread = "two way" }
  near(result.total, p * a * b, 1e-12 * p * a * b, "total")
  near(result.force[3], -p * a * b, 1e-12 * p * a * b, "force downwards")
  equal(result.area, 24, "area")
  equal(tostring(result), "24 m^2 and 72 kN on 4 members", "printed")
  for _, part in ipairs(result.parts) do
    near(part.area, part.member.length == 4 and 4 or 8, 1e-12, "area of member " .. part.member.index)
    near(part.force, p * part.area, 1e-9, "force of member " .. part.member.index)
  end
  local run = model:static { steps = 1 }:finish()
  local q = p * b / 2
  -- clamped beams: a trapezoid with flanks of b/2 has q L^2/12 (1 - 2 c^2 + c^3), c = b / (2 L); a triangle 5 q L^2/96
  local c = b / (2 * a)
  local trapezoid, triangle = q * a ^ 2 / 12 * (1 - 2 * c ^ 2 + c ^ 3), 5 / 96 * q * b ^ 2
  for i, wanted in ipairs { trapezoid, triangle, trapezoid, triangle } do
    local at_a, at_b = members[i]:forces(run)
    near(math.abs(at_a.Mx), wanted, 1e-9 * wanted, "moment at a of beam " .. i)
    near(math.abs(at_b.Mx), wanted, 1e-9 * wanted, "moment at b of beam " .. i)
    near(math.abs(at_a.Qy), q * (i % 2 == 1 and a - b / 2 or b / 2) / 2, 1e-6, "shear of beam " .. i)
  end
  -- in the middle of the triangle: R L/2 - the moment of half of the load about the middle - the end moment
  local half = q * b / 4
  local middle = half * b / 2 - half * b / 6 - triangle
  for _, row in ipairs(members[2]:along(run, 2)) do
    if math.abs(row.x - b / 2) < 1e-9 then
      near(math.abs(row.Mx), middle, 0.005 * middle, "moment in the middle of the triangle")
    end
  end
  local square, _, _, on = bay(5, 5)
  for _, part in ipairs(pressure { model = square, group = "beams", on = on, value = p, direction = down,
    spread = "two way" }.parts) do
    near(part.area, 6.25, 1e-12, "a square: a quarter for each")
  end
end)

case("one way: half to each beam across the span", function()
  for k, span in ipairs { { 0, 1, 0 }, { -2, 0, 0 } } do
    local model, nodes, members, corners = bay(a, b)
    local result = pressure { model = model, members = members, on = corners, value = p, direction = down,
      spread = "one way", span = span }
    equal(#result.parts, 2, "members that carry")
    local run = model:static { steps = 1 }:finish()
    local L, q = k == 1 and a or b, p * (k == 1 and b or a) / 2
    for i = 1, 4 do
      local wanted = i % 2 == k % 2 and q * L ^ 2 / 12 or 0
      near(math.abs(members[i]:forces(run).Mx), wanted, 1e-6, ("span %d, moment of beam %d"):format(k, i))
    end
    local f, m = reactions(run, nodes)
    near(f[3], p * a * b, 1e-6, "reactions")
    near(m[1], p * a * b * b / 2, 1e-6, "their moment about x")
    near(m[2], -p * a * b * a / 2, 1e-6, "their moment about y")
  end
end)

-- A floor of three lines of three beams each and of end beams, turned by 0.7 rad and inclined; local places u, v.
local c, s = math.cos(0.7), math.sin(0.7)
local function inclined(u, v) return { 1.3 + c * u - 0.8 * s * v, s * u + 0.8 * c * v, 3 + 0.6 * v } end
local us, vs = { 0, 2.1, 5.55, 7.7 }, { 0, 1.7, 4.3 }
local function floor()
  local model, at = hinge.model { displacement = "small" }, {}
  for j, v in ipairs(vs) do
    at[j] = {}
    for i, u in ipairs(us) do at[j][i] = model:node(inclined(u, v)) end
  end
  local function beam(from, to, group)
    return model:member { from, to, section = section, material = steel, group = group }
  end
  for j = 1, 3 do
    for i = 1, 3 do
      local turned = (i + j) % 2 == 0
      beam(at[j][turned and i + 1 or i], at[j][turned and i or i + 1], "beams")
    end
    for i = 1, 4, 3 do
      if j < 3 then beam(at[j][i], at[j + 1][i], "ends") end
      if j ~= 2 then model:fix(at[j][i]) end
    end
  end
  return model, at
end
local function corners_of(u1, u2, v1, v2) return { inclined(u1, v1), inclined(u2, v1), inclined(u2, v2),
  inclined(u1, v2) } end
local whole = corners_of(0, 7.7, 0, 4.3)

case("an area across space, with chains of beams and one between its edges", function()
  local model, at = floor()
  local result = pressure { model = model, group = "beams", on = whole, value = -1234.5, direction = { 0, 0, 2 },
    spread = "one way" }
  near(result.total, -1234.5 * 7.7 * 4.3, 1e-12 * 1234.5 * 7.7 * 4.3, "total")
  local of_line = { [0] = 0.85, [1.7] = 2.15, [4.3] = 1.3 }
  equal(#result.parts, 9, "members that carry")
  for _, part in ipairs(result.parts) do
    local v = (part.member.a.z - 3) / 0.6
    for line, width in pairs(of_line) do
      if math.abs(v - line) < 1e-9 then near(part.area, width * part.member.length, 1e-9, "area by line " .. line) end
    end
  end
  local run = model:static { steps = 1 }:finish()
  near(reactions(run, { at[1][1], at[1][4], at[3][1], at[3][4] })[3], 1234.5 * 7.7 * 4.3, 1e-3, "reactions")
  -- the end beams carry where the area spans along u
  local other = floor()
  equal(#pressure { model = other, members = other:members(), on = whole, value = 1, direction = down,
    spread = "one way", span = { c, s, 0 } }.parts, 4, "the end beams")
end)

case("an area that ends within members loads them in part", function()
  local L, from, to, depth = 6, 1.5, 3.7, 2
  local model = hinge.model { displacement = "small" }
  local nodes, members = {}, {}
  for i, y in ipairs { 0, depth } do
    local left, right = model:node { 0, y, 0 }, model:node { L, y, 0 }
    nodes[2 * i - 1], nodes[2 * i] = left, right
    members[i] = model:member { i == 1 and left or right, i == 1 and right or left, section = section,
      material = steel, up = { 0, 0, 1 } }
  end
  model:fix(nodes)
  local result = pressure { model = model, members = members, on = { { from, 0, 0 }, { to, 0, 0 },
    { to, depth, 0 }, { from, depth, 0 } }, value = p, direction = down, spread = "one way" }
  near(result.total, p * (to - from) * depth, 1e-9, "total")
  local run = model:static { steps = 1 }:finish()
  -- clamped beam with shear strain: a force at x gives x (L - x) (L - x + f L / 2) / (L^2 (1 + f)) at the left, where f
  -- is 12 E I / (k G A L^2); here integrated over the loaded part
  local f = 12 * steel.E * section.Ix / (steel.G * section.shear_area_y * L ^ 2)
  local function primitive(x)
    local bending = L ^ 2 * x ^ 2 / 2 - 2 * L * x ^ 3 / 3 + x ^ 4 / 4
    return (bending + f * L / 2 * (L * x ^ 2 / 2 - x ^ 3 / 3)) / (L ^ 2 * (1 + f))
  end
  local wanted = p * depth / 2 * (primitive(to) - primitive(from))
  for i = 1, 2 do
    near(math.abs(select(5, nodes[2 * i - 1]:reaction(run))), wanted, 1e-9 * wanted, "moment at the left, beam " .. i)
  end
end)

case("a value that differs from place to place", function()
  for _, spread in ipairs { "one way", "two way" } do
    local model, nodes, members, corners = bay(a, b)
    local result = pressure { model = model, members = members, on = corners, value = function(x, y, z)
      return 100 * x * y ^ 2 * z / 3
    end, direction = down, spread = spread, span = spread == "one way" and { 0, 1, 0 } or nil }
    local wanted = 100 * a ^ 2 / 2 * b ^ 3 / 3
    near(result.total, wanted, 1e-12 * wanted, spread .. ": total")
    local f = reactions(model:static { steps = 1 }:finish(), nodes)
    near(f[3], wanted, 1e-9 * wanted, spread .. ": reactions")
  end
end)

case("wind on a face, by the width of each column", function()
  local model, _, column, foot = scenes.cantilever { model = { displacement = "small" }, length = 5,
    along = { 0, 0, 1 }, member = { section = section, material = steel, group = "front" } }
  local result = pressure { model = model, group = "front", on = { -3, 0, 0 }, value = function(_, _, z)
    return 500 + 100 * z
  end, width = function(member) return member.index == column.index and 4 end }
  near(result.total, 4 * (500 * 5 + 100 * 12.5), 1e-9, "total")
  equal(result.area, 20, "area")
  local fx, _, _, _, my = foot:reaction(model:static { steps = 1 }:finish())
  near(fx, -result.total, 1e-6, "the wind presses against the face")
  near(my, -4 * (500 * 12.5 + 100 * 125 / 3), 1e-6, "moment at the foot")
  local suction = pressure { model = model, group = "front", on = { 1, 0, 0 }, value = -300, width = 4,
    case = model:case "rear" }
  equal(suction.force[1], 300 * 20, "suction pulls along the normal")
  near(foot:reaction(model:static { steps = 1, loads = "rear" }:finish()) + result.total, -6000, 1e-6, "its case")
end)

case("a history: the impulse of the area goes into the members", function()
  for _, spread in ipairs { "one way", "two way" } do
    local model, _, _, corners = bay(a, b, true)
    pressure { model = model, group = "beams", on = corners, value = 2e3, direction = { 0, 0, 1 }, spread = spread,
      span = spread == "one way" and { 1, 0, 0 } or nil, history = { { 0, 1 }, { 0.02, 0 } } }
    local run = model:dynamic { dt = 5e-4, duration = 0.03 }:finish()
    near(run:momentum().linear[3], 2e3 * a * b * 0.01, 1e-6 * 480, spread .. ": momentum")
  end
end)

case("wrong input is refused, and nothing is loaded", function()
  local model, nodes, members, corners = bay(a, b)
  local inner = model:node { 2, 1, 3 }
  local oblique = model:member { inner, nodes[4], section = section, material = steel, group = "oblique" }
  -- a good call, with changes; false: left out
  local function with(more)
    local o = scenes.with({ model = model, members = members, on = corners, value = p, direction = down,
      spread = "two way" }, more)
    for name, value in pairs(o) do o[name] = value or nil end
    return o
  end
  local half = { { 0, 0, 3 }, { a, 0, 3 }, { a, b / 2, 3 }, { 0, b / 2, 3 } }
  for words, options in pairs {
    ["takes a table of options, got 1"] = 1,
    ["field 'model' is missing"] = {},
    ["give either 'members' or 'group'"] = with { members = false },
    ["give either 'members' or 'group'; both are given"] = with { group = "beams" },
    ["field 'members[2]' is 5; must be a member of this model"] = with { members = { members[1], 5 } },
    ["unknown group 'bems' (did you mean 'beams'?)"] = with { members = false, group = "bems" },
    ["field 'on' is 4; must be the 4 corners"] = with { on = 4 },
    ["field 'on' has 3 corner points"] = with { on = { { 0, 0, 3 }, { a, 0, 3 }, { a, b, 3 } } },
    ["are not the corners of a rectangle"] = with { on = { { 0, 0, 3 }, { a, 0, 3 }, { a, b, 3 }, { 1, b, 3 } } },
    ["field 'on[2]' is"] = with { on = { { 0, 0, 3 }, { a, 0 }, { a, b, 3 }, { 0, b, 3 } } },
    ["field 'value' is not a number (nan)"] = with { value = 0 / 0 },
    ["in field 'value' returned 'strong'"] = with { value = function() return "strong" end },
    ["field 'direction' is missing"] = with { direction = false },
    ["field 'direction' is {0, 0, 0}"] = with { direction = { 0, 0, 0 } },
    ["field 'spread' is 'both'; must be one of one way, two way"] = with { spread = "both" },
    ["give 'span', the direction"] = with { spread = "one way" },
    ["field 'span' is {1, 1, 0}; must be parallel"] = with { spread = "one way", span = { 1, 1, 0 } },
    ["field 'span' is for spread"] = with { span = { 1, 0, 0 } },
    ["openings in the area are not known"] = with { openings = { { 1, 1, 3 } } },
    ["no member lies along the edge of the area from {0, 2, 3} m to {6, 2, 3} m"] = with { on = half },
    ["no member carries the area from {6, 0, 3} m to {7, 0, 3} m"] = with { on = { { 0, 0, 3 }, { 7, 0, 3 },
      { 7, b, 3 }, { 0, b, 3 } }, spread = "one way", span = { 0, 1, 0 } },
    ["none of the 4 members lies in the area"] = with { on = { { 0, 0, 4 }, { a, 0, 4 }, { a, b, 4 }, { 0, b, 4 } } },
    ["lies in the area, parallel to none of its edges"] = with { members = { members[1], oblique } },
    ["field 'width' is for a face"] = with { width = 2 },
    ["field 'spread' is for an area"] = with { on = { 0, 0, 1 }, width = 2 },
    ["field 'width' is missing; give a number above 0 m"] = with { on = { 0, 0, 1 }, spread = false },
    ["field 'on' is 0 degrees from the axis of member 1; must be 84 to 90 degrees"] = with { on = { 1, 0, 0 },
      width = 1, spread = false },
    ["no load case 'snow'"] = with { case = "snow" },
    ["field 'history' is out of order"] = with { history = { { 1, 0 }, { 0, 1 } } },
  } do
    checks.refused(words, pressure, options)
  end
  local twice, its_nodes, its_members = bay(a, b)
  its_members[5] = twice:member { its_nodes[1], its_nodes[2], section = section, material = steel }
  checks.refused("lies where another one of 'members' lies", pressure,
    with { model = twice, members = its_members })
  model:load { node = inner, force = { 0, 0, -1 } }
  near(reactions(model:static { steps = 1 }:finish(), nodes)[3], 1, 1e-9, "nothing else was loaded")
end)

checks.done()

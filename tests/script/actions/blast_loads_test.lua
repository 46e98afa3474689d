-- Loads of blasts on members against forces and momentum in closed form; a mass on a cantilever under a triangular
-- pulse against its closed form; wrong input is refused. The pressures themselves: blast_test.lua.
--
-- Run: lua5.4 tests/script/actions/blast_loads_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local blast = require "hinge.actions.blast"
local checks = support.checks "blast loads"
local runs = require "runs"(checks)
local case, near, equal, expect, refused = checks.case, checks.near, checks.equal, checks.expect, checks.refused

local function close(value, wanted, part, what) near(value, wanted, part * math.abs(wanted), what) end

local bomb = blast { charge = 500, at = { 0, 0, 0 } } -- kg of TNT

-- Peak and impulse on a face by hand; c: cosine of the angle of incidence.
local function on_face(p, c)
  local r, i = c ^ 2, 1 + c - 2 * c ^ 2
  return r * p.reflected_pressure + i * p.incident_pressure, r * p.reflected_impulse + i * p.incident_impulse
end

local steel = hinge.material { E = 210e9, density = 7850 }
local square = hinge.section.solid { width = 0.2, depth = 0.2 }

-- What the supports at these nodes hold, as a sum.
local function held_by(run, nodes)
  local sum = { 0, 0, 0 }
  for _, node in ipairs(nodes) do
    local r = { node:reaction(run) }
    for k = 1, 3 do sum[k] = sum[k] + r[k] end
  end
  return sum
end

-- Two columns, one above the other, and a beam along y; the columns are the group "front".
local function facade()
  local model = hinge.model()
  local n = { model:node { 20, 0, 0 }, model:node { 20, 0, 2 }, model:node { 20, 0, 4 }, model:node { 20, 2, 4 } }
  local m = {}
  for i = 1, 3 do
    m[i] = model:member { n[i], n[i + 1], section = square, material = steel, group = i < 3 and "front" or "head" }
  end
  return model, m, n
end

case("a load on members: forces of the pressure in their middles, against the reactions of supports", function()
  local model, m, n = facade()
  local pressed = model:case "pressed"
  local force, impulse, parts = bomb:load(model, { group = model:group "front", normal = { -2, 0, 0 }, case = pressed,
    width = function(member) return member.index end })
  local wanted, wanted_impulse = 0, 0
  for i = 1, 2 do
    local z = 2 * i - 1
    local p = bomb:parameters { 20, 0, z }
    local peak, per_area = on_face(p, 20 / math.sqrt(400 + z ^ 2))
    local area = 2 * i
    close(parts[i].pressure, peak, 1e-9, "pressure")
    close(parts[i].impulse, per_area * area, 1e-9, "impulse of a member")
    close(parts[i].arrival, p.arrival, 1e-12, "arrival")
    equal(parts[i].member, m[i], "member")
    equal(parts[i].width, i, "width")
    wanted, wanted_impulse = wanted + parts[i].pressure * area, wanted_impulse + parts[i].impulse
  end
  close(force, wanted, 1e-12, "force")
  close(impulse, wanted_impulse, 1e-12, "impulse")
  equal(#parts, 2, "members")
  model:fix(n)
  -- statics takes the numbers of a case that it names in full
  local sum = held_by(model:static { loads = { pressed = 1 } }:finish(), n)
  close(sum[1], -force, 1e-9, "reaction against the pressure, which pushes away from the charge")
  near(sum[2], 0, 1e-9 * force, "aside")
  near(sum[3], 0, 1e-9 * force, "upwards")
end)

case("a roof member has the incident pressure of its middle, downwards", function()
  -- a beam of a roof along y, 25 m from the charge and 6 m up; the roof faces the sky, so nothing is reflected
  local function roof()
    local model = hinge.model()
    local nodes = { model:node { 25, -2, 6 }, model:node { 25, 2, 6 } }
    return model, nodes, model:member { nodes[1], nodes[2], section = square, material = steel, group = "roof" }
  end
  local model, nodes, beam = roof()
  local distance = math.sqrt(25 ^ 2 + 6 ^ 2)
  local p = bomb:parameters(distance)
  local pressed = model:case "pressed"
  local force, impulse, parts = bomb:load(model, { group = "roof", normal = { 0, 0, 1 }, width = 3, case = pressed })
  close(parts[1].distance, distance, 1e-12, "slant distance of its middle, m")
  close(parts[1].pressure, p.incident_pressure, 1e-12, "incident pressure, Pa")
  close(force, p.incident_pressure * 12, 1e-12, "force on 4 m by 3 m, N")
  close(impulse, p.incident_impulse * 12, 1e-12, "impulse, N s")
  model:fix(nodes)
  local run = model:static { loads = { pressed = 1 } }:finish()
  local sum = held_by(run, nodes)
  close(sum[3], force, 1e-9, "the supports push upwards, N")
  near(sum[1], 0, 1e-9 * force, "nothing away from the charge")
  expect(beam:forces(run).Mx ~= 0, "it bends")
  -- a roof that leans towards the charge by 30 degrees reflects with the cosine of its own angle
  local normal = { -math.sin(math.rad(30)), 0, math.cos(math.rad(30)) }
  local c = (25 * math.sin(math.rad(30)) - 6 * math.cos(math.rad(30))) / distance
  local leaning = roof()
  local _, _, of = bomb:load(leaning, { group = "roof", normal = normal, width = 3 })
  close(of[1].pressure, (on_face(p, c)), 1e-12, "leaning, Pa")
  -- a face whose normal lies along the member is no face of it
  refused("degrees from the axis", function()
    bomb:load(leaning, { group = "roof", normal = { 0, 1, 0 }, width = 3 })
  end)
end)

case("the impulse goes into the momentum of a free body, by either shape and integrator", function()
  for _, shape in ipairs { "friedlander", "triangle" } do
    for _, integrator in ipairs { "newmark", "explicit" } do
      local model, m = facade()
      local one = blast { charge = 500, at = { 0, 0, 0 }, shape = shape }
      local _, impulse = one:load(model, { members = { m[1], m[2] }, normal = { -1, 0, 0 }, width = 0.2 })
      local run = model:dynamic { dt = integrator == "newmark" and 2e-4 or "auto", duration = 0.045,
        integrator = integrator }
      local what = shape .. ", " .. integrator .. ": "
      runs.completed(run, what)
      close(run:momentum().linear[1], impulse, 1e-6, what .. "momentum, N s")
      local p = bomb:parameters(20)
      -- both middles are 20 m away to 1 %, and the impulse is the same for both shapes
      close(impulse, 0.2 * 4 * p.reflected_impulse, 0.03, what .. "impulse")
    end
  end
end)

-- Undamped, from rest, under F (1 - t / td): u / u_static = 1 - cos wt + sin wt / (w td) - t / td up to td. With a =
-- w td it is largest at wt = 2 atan a, where it is 2 - 2 atan(a) / a, if that is before td; else the amplitude of the
-- free vibration after td counts (Biggs, Introduction to Structural Dynamics, 1964, has this as a chart).
local function load_factor(a)
  if 2 * math.atan(a) <= a then return 2 - 2 * math.atan(a) / a end
  local u, v = math.sin(a) / a - math.cos(a), math.sin(a) + (math.cos(a) - 1) / a
  return math.sqrt(u ^ 2 + v ^ 2)
end

case("a mass on a cantilever under a triangular pulse has the dynamic load factor of theory", function()
  near(load_factor(1e3), 2, 4e-3, "a sudden load that stays")
  close(load_factor(1e-2), 1e-2 / 2, 1e-3, "an impulse: F td / 2 over m w")
  local mass, F = 2000, 1000
  local bar = scenes.square
  local light = hinge.material { E = 210e9, nu = 0.3, density = 100 }
  local flexibility = 1 / (3 * light.E * bar.Ix) + 1 / (light.G * bar.shear_area_y)
  local w = math.sqrt(1 / (flexibility * (mass + 33 / 140 * 100 * bar.area)))
  for _, part in ipairs { 0.1, 0.3, 0.4, 1, 3 } do -- of the period
    local duration = part * 2 * math.pi / w
    local model, tip = scenes.cantilever { model = { displacement = "small" }, member = { material = light } }
    model:mass { node = tip, mass = mass }
    model:load { node = tip, force = { 0, 0, F }, history = blast.triangle { peak = 1, duration = duration } }
    local period = 2 * math.pi / w
    local run = model:dynamic { dt = period / 200, duration = (part > 0.5 and 0.6 or 0.8) * period + 0.5 * duration }
    local path = run:probe { node = tip, "uz" }
    runs.completed(run)
    local largest = support.largest_of(table.unpack(path.value))
    close(largest / (F * flexibility), load_factor(w * duration), 0.01, ("td = %g T"):format(part))
  end
end)

case("a member along which the pressure changes much is refused, or taken as it is in the middle", function()
  local function column(count) -- of so many members
    local model = hinge.model()
    local from = model:node { 5, 0, 0 }
    for i = 1, count do
      local to = model:node { 5, 0, 6 * i / count }
      model:member { from, to, section = square, material = steel, group = "column" }
      from = to
    end
    return model
  end
  local model, given = column(1), { group = "column", normal = { -1, 0, 0 }, width = 1 }
  local message = refused("explosion:load: the largest pressure on member 1 is ", bomb.load, bomb, model, given)
  equal(#model:loads(), 0, "nothing was loaded")
  local n = math.tointeger(message:match "use (%d+) members in its place")
  expect(n and n > 2 and n < 20, "%s members in: %s", n, message)
  local _, _, parts = bomb:load(model, scenes.with(given, { uneven = true }))
  close(parts[1].pressure, bomb:pressure({ 5, 0, 3 }, { -1, 0, 0 }, parts[1].arrival + 1e-12), 1e-6, "in the middle")
  -- that many are accepted, and one less is not
  for _, count in ipairs { n, n - 1 } do
    local accepted = pcall(bomb.load, bomb, column(count), given)
    equal(accepted, count == n, ("%d members"):format(count))
  end
  -- a beam whose ends have the same pressure, and its middle more
  local wide = hinge.model()
  wide:member { wide:node { 8, -6, 0 }, wide:node { 8, 6, 0 }, section = square, material = steel, group = "beam" }
  refused("20 %", bomb.load, bomb, wide, { group = "beam", normal = { -1, 0, 0 }, width = 1 })
end)

case("wrong input of a load is refused, and changes nothing", function()
  local model, m = facade()
  local other, theirs = facade()
  for words, options in pairs {
    ["give either 'members' or 'group'"] = { group = false },
    ["'members' or 'group'; both are given"] = { members = m },
    ["group 'fronts' (did you mean 'front'?)"] = { group = "fronts" },
    ["field 'group' is 3; must be a group of this model or its name"] = { group = 3 },
    ["field 'group' is group"] = { group = other:group "front" },
    ["field 'members' is empty"] = { group = false, members = {} },
    ["field 'members[2]' is 5; must be a member of this model"] = { group = false, members = { m[1], 5 } },
    ["field 'members[1]' is member 1"] = { group = false, members = { theirs[1] } },
    ["which is in the list twice"] = { group = false, members = { m[1], m[1] } },
    ["field 'normal' is missing"] = { normal = false }, ["'normal' is {0, 0, 0}"] = { normal = { 0, 0, 0 } },
    ["field 'normal' is 0 degrees from the axis of member 1; must be 84 to 90 degrees"] = { normal = { 0, 0, 1 } },
    ["'normal' is 45 degrees from the axis of member 1"] = { normal = { -1, 0, 1 } },
    ["field 'width' is missing; must be a number above 0 m, or a function"] = { width = false },
    ["field 'width' is 0; must be"] = { width = 0 }, ["field 'width' is not a number (nan)"] = { width = 0 / 0 },
    ["field 'width(member 2)' is -1 m; must be a number above 0 m"] = {
      width = function(member) return member.index == 2 and -1 or 1 end },
    ["field 'uneven' is 1"] = { uneven = 1 }, ["no load case 'wind'"] = { case = "wind" },
  } do
    local given = scenes.with({ group = "front", normal = { -1, 0, 0 }, width = 1 }, options)
    for name, value in pairs(given) do given[name] = value or nil end
    refused(words, function() bomb:load(model, given) end)
  end
  local good = { group = "front", normal = { -1, 0, 0 }, width = 1, uneven = true }
  refused("the model is a table", function() bomb:load { group = "front" } end)
  refused("no further argument", function() bomb:load(model, good, 1) end)
  refused("must be from 0.06 to 198.5 m/kg^(1/3), here 0.006 to 19.85 m",
    function() blast { charge = 1e-3, at = { 0, 0, 0 } }:load(model, good) end)
  equal(#other:members(), 3, "the other model is there")
  local run = model:dynamic { dt = 1e-3, duration = 0.05 }:finish()
  near(run:momentum().linear[1], 0, 1e-12, "nothing was loaded")
end)

checks.done()

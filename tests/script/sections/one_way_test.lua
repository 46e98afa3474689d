-- Members that carry tension alone or compression alone: a braced frame and a mass on a cable by hand, the energy
-- balance of all integrators, the same bytes after a checkpoint in the slack, what hinges, fracture and the plan say of
-- slack; wrong input is refused.
--
-- Run: lua5.4 tests/script/sections/one_way_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local scenes = require "scenes"
local law_scenes = require "sections.law_scenes"
local checks = support.checks "one way"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local E, g = 206e9, 9.80665
local steel = hinge.material { E = E, density = 7850 }
local function yielding(stress, options)
  return hinge.material(scenes.with({ E = E, density = 7850, yield_stress = stress }, options))
end
-- A section without bending stiffness to speak of, so that sums by hand have the axial force alone.
local function wire(area) return hinge.section.general { area = area, Ix = 1e-12, Iy = 1e-12, J = 1e-12 } end

-- A column whose head slides along x, between two braces.
local function braced(carries, options, material)
  local model = hinge.model(options)
  local head, foot = model:node { 0, 0, 3 }, model:node { 0, 0, 0 }
  local left, right = model:node { -4, 0, 0 }, model:node { 4, 0, 0 }
  for _, node in ipairs { foot, left, right } do model:fix(node, "all") end
  model:fix(head, "y,z,rx,ry,rz")
  local column = hinge.section.general { area = 1e-2, Ix = 2e-5, Iy = 2e-5, J = 1e-5 }
  local stiff_in_shear = hinge.material { E = E, G = 1e6 * E, density = 7850 } -- so that 12 E I / h^3 is right
  model:member { foot, head, section = column, material = stiff_in_shear, up = { 0, 1, 0 } }
  local braces = {}
  for i, node in ipairs { left, right } do
    braces[i] = model:member { node, head, section = wire(2e-4), material = material or steel, carries = carries,
      up = { 0, 1, 0 }, group = "braces" }
  end
  return model, head, braces
end

case("a braced frame follows the sums by hand over cycles, in either direction", function()
  local column, brace = 12 * E * 2e-5 / 3 ^ 3, E * 2e-4 / 5 * 0.8 ^ 2
  for carries, acting in pairs { tension = 1, compression = 1, both = 2 } do
    for _, formulation in ipairs { "asi-gauss", "conventional" } do
      local model, head, braces = braced(carries, { displacement = "small", formulation = formulation,
        elements_per_member = formulation == "conventional" and 1 or 2 })
      model:load { node = head, force = { 1e5, 0, 0 } }
      local run
      for _, u in ipairs { 0.02, -0.03, 0.01, -0.01, 0.03 } do
        run = model:static { from = run, steps = 4, control = { node = head, "ux", to = u } }:finish()
        local what = ("%s, %s, at %g m"):format(carries, formulation, u)
        equal(run.verdict, "completed", what .. ": " .. tostring(run.reason))
        -- the conventional element is too flexible in bending: by 3/4 for one that is clamped and guided
        local bending = formulation == "conventional" and 1 or column
        if formulation ~= "conventional" then
          near(1e5 * run.factor, (bending + acting * brace) * u, 1e-6 * brace * 0.03, what .. ": force")
        end
        for i = 1, 2 do
          local stretch = (i == 1 and 1 or -1) * u * 0.8
          local N = E * 2e-4 / 5 * stretch
          if (carries == "tension" and N < 0) or (carries == "compression" and N > 0) then N = 0 end
          near(braces[i]:forces(run).N, N, 1e-6 * E * 2e-4 / 5 * 0.03, what .. ": brace " .. i)
        end
      end
      equal(run:count { state = "yielded" }, 0, "none yields")
    end
  end
end)

-- A mass that hangs on a cable and is thrown up flies free, and the cable catches it at the height where it left. Then
-- its kinetic energy and m g x become k x^2 / 2. 2e-3: the mass of the cable is left out, and the step is 1/60 of the
-- vibration's period.
case("a mass that is thrown up is caught by its cable", function()
  local m, area, L, v = 100, 1e-5, 2, 1
  local k = E * area / L
  local largest = m * g + math.sqrt((m * g) ^ 2 + k * m * v ^ 2)
  for _, integrator in ipairs { "newmark", "energy-momentum" } do
    local model = hinge.model {}
    local top, bottom = model:node { 0, 0, L }, model:node { 0, 0, 0 }
    local cable = model:member { top, bottom, section = wire(area), material = steel:with { density = 50 },
      carries = "tension", up = { 0, 1, 0 } }
    model:fix(top, "all")
    model:fix(bottom, "x,y,rx,ry,rz")
    model:mass { node = bottom, mass = m }
    model:velocity(bottom, { 0, 0, v })
    model:gravity { 0, 0, -g }
    local run = model:dynamic { integrator = integrator, dt = 1e-4,
      duration = 2 * v / g + 0.03 }
    local N, least, caught = 0, 0, nil
    while run:step() do
      local now = cable:forces(run).N
      N, least = support.largest_of(N, now), support.smallest_of(least, now)
      if run.time > 0.01 and now > 0.01 * largest then caught = caught or run.time end
    end
    equal(run.verdict, "completed", integrator .. ": " .. tostring(run.reason))
    near(N / largest, 1, 2e-3, integrator .. ": largest force")
    near(least, 0, 0.01, integrator .. ": least force") -- but for half the weight of an element
    near(caught / (2 * v / g), 1, 0.01, integrator .. ": when it is caught")
    near(run.energy_error, 0, 1e-3, integrator .. ": energy error")
    equal(run.energy.plastic, 0, integrator .. ": nothing is dissipated")
    equal(#run:hinges(), 0, integrator .. ": hinges")
  end
end)

-- A frame of one storey with crossed braces that swings, in large displacement.
local function swinging(yield_stress, carries)
  local model = hinge.model {}
  local n = { model:node { 0, 0, 0 }, model:node { 5, 0, 0 }, model:node { 0, 0, 3.5 }, model:node { 5, 0, 3.5 } }
  local column, beam = hinge.section.named "HEB 160", hinge.section.named "IPE 240"
  for i = 1, 2 do
    model:fix(n[i], "all")
    model:fix(n[i + 2], "y,rx,rz")
    model:member { n[i], n[i + 2], section = column, material = steel, up = { 0, 1, 0 } }
    model:member { n[i], n[5 - i], section = hinge.section.round { diameter = 0.024 },
      material = yield_stress and yielding(yield_stress) or steel, carries = carries or "tension", up = { 0, 1, 0 },
      group = "braces" }
    model:mass { node = n[i + 2], mass = 15000 }
    model:velocity(n[i + 2], { yield_stress and 1 or 0.4, 0, 0 })
  end
  model:member { n[3], n[4], section = beam, material = steel, up = { 0, 0, 1 } }
  return model, n[3]
end

local methods = { newmark = { dt = 5e-4 }, explicit = { integrator = "explicit", dt = "auto" },
  conserving = { integrator = "energy-momentum", dt = 5e-4 } }

case("in a braced frame that swings the energy balance closes, whatever the method", function()
  for name, fy in pairs { elastic = false, yields = 300e6 } do
    local work, moved = {}, {}
    for method, options in pairs(methods) do
      options.duration = method == "explicit" and 0.05 or 0.3 -- 20 000 explicit steps
      local model, head = swinging(fy or nil)
      local run = model:dynamic(options)
      local most = 0
      while run:step() do
        local ux = head:displacement(run)
        most = support.largest_of(most, math.abs(ux))
      end
      local what = name .. ", " .. method
      equal(run.verdict, "completed", what .. ": " .. tostring(run.reason))
      near(run.energy_error, 0, 1e-3, what .. ": energy error")
      work[method], moved[method] = run.energy.plastic, most
      if fy and method ~= "explicit" then
        expect(work[method] > 100, "%s: dissipates %g J", what, work[method])
      elseif not fy then
        equal(work[method], 0, what .. ": plastic work")
        equal(#run:hinges(), 0, what .. ": hinges")
      end
    end
    near(moved.conserving / moved.newmark, 1, 0.01, name .. ": displacement")
    if fy then near(work.conserving / work.newmark, 1, 0.02, name .. ": plastic work") end
  end
end)

case("a run that was saved while a brace was slack goes on to the same bytes", function()
  law_scenes.resumes(checks, function() return (swinging(300e6)) end, { dt = 5e-4, steps = 250, duration = 0.3,
    others = { [function() return (swinging(300e6, "both")) end] = "members" } })
end)

case("slack is no strain for fracture, and no hinge", function()
  for limit, breaks in pairs { [0.01] = false, [1e-4] = true } do
    local model, b = scenes.cantilever { member = { section = wire(1e-4), material = yielding(400e6),
      carries = "tension", group = "cable" } }
    model:fix(b)
    model:fracture { axial_strain = limit, curvature_x = 1e9, curvature_y = 1e9 }
    -- 10 % shorter, and 1 mm longer: a strain of 0.001
    model:move { node = b, x = { { 0, 0 }, { 0.1, -0.1 }, { 0.2, 0.001 }, { 0.3, -0.1 } } }
    local run = model:dynamic { dt = 1e-4, duration = 0.29 }:finish()
    equal(run.verdict, "completed", run.reason)
    equal(run:count { state = "broken" } > 0, breaks, "breaks at a limit of " .. limit)
    equal(#run:hinges(), 0, "hinges")
    equal(run:count { state = "yielded" }, 0, "yielded")
  end
end)

case("a rod that hangs from one of its two supports: N at its ends, and how many elements it takes", function()
  local L, q = 4, 100
  -- A rod from `top` on along a direction, between two fixed ends; the load along it pulls at its top.
  local function hung(o)
    local model = hinge.model { displacement = o.displacement }
    local a = model:node { 1, 2, 3 }
    local b = model:node { 1 + L * o.way[1], 2 + L * o.way[2], 3 + L * o.way[3] }
    model:fix({ a, b }, "all")
    local pulls = o.carries == "tension" and 1 or -1
    local rod = model:member { a, b, section = hinge.section.round { diameter = 0.02 }, material = steel,
      carries = o.carries, elements = o.elements }
    model:load { member = rod, q = { pulls * q * o.way[1], pulls * q * o.way[2], pulls * q * o.way[3] } }
    if o.other then -- a member with a larger force
      local c, d = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
      model:fix(c, "all")
      model:member { c, d, section = hinge.section.round { diameter = 0.02 }, material = steel }
      model:load { node = d, force = { o.other, 0, 0 } }
    end
    local run = model:static { steps = 2 }:finish()
    equal(run.verdict, "completed", run.reason)
    local points, sum = rod:along(run, 2), 0
    for _, node in ipairs { a, b } do
      local r = { node:reaction(run) }
      for c = 1, 3 do sum = sum + pulls * r[c] * o.way[c] end
    end
    near(sum, -q * L, 1e-8 * q * L, "sum of the reactions")
    return pulls * points[1].N / (q * L), pulls * points[#points].N / (q * L), run
  end
  for _, o in ipairs { { way = { 0, 0, -1 } }, { way = { 0.6, 0, -0.8 } },
    { way = { 0, 1, 0 }, displacement = "small" } } do
    for _, carries in ipairs { "tension", "compression" } do
      for _, n in ipairs { 2, 4, 8 } do
        o.carries, o.elements = carries, n
        local what = ("%s, along %g %g %g, %d elements"):format(carries, o.way[1], o.way[2], o.way[3], n)
        local top, foot, run = hung(o)
        near(top, 1 - 1 / (2 * n), 1e-6, what .. ": N at the top") -- 1: hangs whole; half an element's load is missing
        near(foot, -1 / (2 * n), 1e-6, what .. ": N at the foot") -- 0
        local found = table.concat(run.warnings, " ")
        expect(found:find(carries .. " alone, and where it is slack half", 1, true), "%s: warns: %s", what, found)
        o.elements = tonumber(found:match "elements = (%d+)")
        top, foot, run = hung(o)
        near(top, 1, 0.05, what .. ": N at the top with the elements that the warning names")
        near(foot, 0, 0.05, what .. ": at the foot")
        equal(#run.warnings, 0, what .. ": warnings with them")
        o.elements, o.other = n, 20 * q * L
        equal(#select(3, hung(o)).warnings, 0, what .. ": warnings beside a large force")
        o.other = nil
      end
    end
  end
end)

-- In dynamics as in statics, as long as the rod is still: what falls carries a part of its load by its inertia.
case("a rod that hangs at rest in dynamics warns as in statics, one that falls does not", function()
  for _, of in ipairs { { still = true }, { still = true, integrator = "explicit" }, { still = false } } do
    local model, foot, rod = scenes.cantilever { along = { 0, 0, -1 }, length = 3, member = { material = steel,
      section = hinge.section.round { diameter = 0.02 }, carries = of.still and "tension" or "compression" } }
    model:fix(foot, of.still and "all" or "x,y,rx,ry,rz")
    model:gravity { 0, 0, -9.80665 }
    local from = of.still and model:static { steps = 2 }:finish() or nil
    local run = model:dynamic { from = from, integrator = of.integrator, dt = of.integrator and "auto" or 1e-4,
      duration = 0.01, record = false }:finish()
    local found = table.concat(run.warnings, " ")
    local warns = found:find("tension alone, and where it is slack half", 1, true) ~= nil
      or found:find("compression alone, and where it is slack half", 1, true) ~= nil
    local what = ("%s, %s"):format(of.still and "at rest" or "falls", of.integrator or "newmark")
    equal(warns, of.still, what .. ": warns of N")
    if of.still then -- as in statics: a quarter of the weight is missing at the top with two elements
      local weight = run:momentum().mass * 9.80665
      near(rod:along(run, 2)[1].N / weight, 0.75, 1e-3, what .. ": N at the top")
    end
  end
end)

-- Frames with crossed rods in all panels, pushed sideways. Rods that sag under their weight are slack in one iteration
-- and taut in the next.
case("crossed rods with their own weight: statics finds the sway of rods without weight", function()
  local function sway(bays, storeys, density)
    local model = hinge.model()
    local s355 = hinge.material.steel "S355"
    local grid = hinge.grid { model = model, x = { count = bays, spacing = 6 }, z = { count = storeys, spacing = 4 } }
    grid:fix "all"
    grid:defaults { material = s355 }
    grid:columns { section = hinge.section.named "HEB 200", up = { 1, 0, 0 } }
    grid:beams { along = "x", section = hinge.section.named "IPE 300" }
    for i = 1, bays do
      grid:braces { from = string.char(64 + i) .. 1, to = string.char(65 + i) .. 1, shape = "X", carries = "tension",
        section = hinge.section.round { diameter = 0.03 }, material = s355:with { density = density } }
    end
    for _, node in ipairs(model:nodes()) do model:fix(node, "y") end
    model:gravity { 0, 0, -g }
    local corner = grid:node("A1", storeys)
    model:load { node = corner, force = { 20e3, 0, 0 } }
    local run = model:static { steps = 4 }:finish()
    equal(run.verdict, "completed", ("%d x %d, %g kg/m^3: %s"):format(bays, storeys, density, run.reason))
    near(run.energy_error, 0, 1e-4, "energy error")
    return corner:displacement(run)
  end
  for _, of in ipairs { { 1, 1 }, { 2, 1 }, { 1, 2 }, { 3, 3 } } do
    local without = sway(of[1], of[2], 1)
    near(sway(of[1], of[2], 7850), without, 0.02 * without, ("%d x %d: sway"):format(of[1], of[2]))
  end
end)

--- A pinned bay of 6 by 4 m with crossed rods, in the plane of x or of y, under P on each column. Returns the model and
--- the top of a column.
local function bay(o)
  local P = o.P
  local column, beam, rod = hinge.section.named "HEB 160", hinge.section.named "IPE 300",
    hinge.section.round { diameter = 0.024 }
  local material = yielding(355e6)
  local model, y = hinge.model(), o.along == "y"
  local function node(along, z) return model:node { y and 0 or along, y and along or 0, z } end
  local a, b, c, d = node(0, 0), node(6, 0), node(0, 4), node(6, 4)
  model:fix({ a, b }, "xyz rz")
  model:fix({ c, d }, y and "x ry rz" or "y rx rz")
  for _, ends in ipairs { { a, c }, { b, d } } do
    model:member { ends[1], ends[2], section = column, material = material, elements = o.elements or 8,
      up = y and { 0, 1, 0 } or { 1, 0, 0 } }
    model:load { node = ends[2], force = { y and 0 or o.wind or 0, y and o.wind or 0, -P } }
  end
  model:member { c, d, section = beam, material = material, release = { a = "Mx", b = "Mx" } }
  for _, ends in ipairs { { a, d }, { b, c } } do
    model:member { ends[1], ends[2], section = rod, material = material, carries = "tension" }
  end
  return model, c
end

case("rods that go slack under vertical load are no limit: the bay leans until one is taut", function()
  -- The columns shorten by s. A rod is taut again at a sway of s h / b, and holds the sway moment of the loads.
  local P, h, b = 1000e3, 4, 6
  local s = P * h / (E * hinge.section.named("HEB 160").area)
  local k = E * math.pi * 0.012 ^ 2 * b ^ 2 / (b ^ 2 + h ^ 2) ^ 1.5
  local sway = s * h / b / (1 - 2 * P / (h * k))
  for _, o in ipairs { {}, { along = "y" }, { steps = 1 }, { steps = 100, elements = 4 }, { wind = 1 } } do
    o.P = P
    local model, top = bay(o)
    local run = model:static { steps = o.steps or 20, to_limit = true, record = false }:finish()
    local what = ("along %s, %d steps, wind %s"):format(o.along or "x", o.steps or 20, o.wind)
    expect(run.verdict == "completed" and not run.limit and not run.instability, "%s: %s at %g", what, run.reason,
      run.factor)
    local u, v = top:displacement(run)
    near(o.along == "y" and v or u, sway, 0.005 * sway, what .. ": sway") -- to the first order in the sway
    equal(#run.warnings, o.wind and 0 or 1, what .. ": warnings")
    expect(o.wind or run.warnings[1]:find("leans over until member", 1, true), "%s: %s", what, run.warnings[1])
  end
end)

case("a bay with slack rods has the limit load of one that a small wind has leant", function()
  local found = {}
  for i, wind in ipairs { 0, 1 } do
    local run = bay({ P = 3000e3, wind = wind }):static { steps = 20, to_limit = true, record = false }:finish()
    expect(run.limit, "wind %g: %s", wind, run.reason)
    found[i] = run.factor
  end
  near(found[1], found[2], 1e-3 * found[2], "limit load") -- the bracket of an instability
end)

-- y = a cosh(x / a): 1 %, for its bending and its stretching take 0.2 %. It is laid out as a parabola, too short or too
-- long in places: some of its members are slack at first.
case("a cable under its own weight hangs as a catenary", function()
  local span, pieces = 8, 20
  local heavy, rope = hinge.material { E = E, density = 9e5 }, hinge.section.round { diameter = 0.012 }
  for _, how in ipairs { "statics", "dynamics" } do
    local model, node, length = hinge.model {}, {}, 0
    for i = 0, pieces do
      local x = span * (i / pieces - 0.5)
      node[i] = model:node { x, 0, 2.4 * ((2 * x / span) ^ 2 - 1) }
      model:fix(node[i], i % pieces == 0 and "x,y,z,rx,rz" or "y,rx,rz")
    end
    for i = 1, pieces do
      local piece = model:member { node[i - 1], node[i], section = rope, material = heavy, up = { 0, 1, 0 },
        carries = "tension" }
      length = length + piece.length
    end
    model:gravity { 0, 0, -g }
    if how == "dynamics" then model:damping { alpha = 3 } end
    local run = how == "statics" and model:static { steps = 10 } or model:dynamic { dt = 2e-3, duration = 6 }
    run:finish()
    equal(run.verdict, "completed", run.reason)
    local function sinh(x) return (math.exp(x) - math.exp(-x)) / 2 end
    local low, high = 1, 100
    for _ = 1, 60 do
      local a = (low + high) / 2
      if 2 * a * sinh(span / 2 / a) > length then low = a else high = a end
    end
    local sag = low * (math.sqrt(1 + sinh(span / 2 / low) ^ 2) - 1)
    local _, _, uz = node[pieces // 2]:displacement(run)
    near((2.4 - uz) / sag, 1, 0.01, how .. ": sag")
  end
end)

case("the plan and the member say which forces it carries", function()
  local because
  for _, line in ipairs(swinging():dynamic({ dt = 1e-3, duration = 1e-3 }).effects) do
    if line.name == "plasticity" then because = line.because end
  end
  expect(because and because:find "tension only", "plan: %s", because)
  local _, _, braces = braced "compression"
  equal(braces[1].carries, "compression", "member.carries")
  local _, _, plain = braced()
  equal(plain[1].carries, "both", "member.carries of others")
end)

case("wrong input", function()
  checks.refused("field 'carries' is 'tensile'", braced, "tensile")
  checks.refused("carries is 'tension', and its material has hardening", braced, "tension", nil,
    yielding(235e6, { hardening = { tangent = 2e9 } }))
  checks.refused("carries is 'compression', and its material has strain rate", braced, "compression", nil,
    yielding(235e6, { rate = { D = 40.4, q = 5 } }))
end)

checks.done()

-- What a run shows to be missing: run.warnings says it at the end, where there is something to say and only there.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "findings"
local case, expect, equal, refused = checks.case, checks.expect, checks.equal, checks.refused

local steel = hinge.material { E = 210e9, density = 7850, yield_stress = 355e6 }
local elastic = hinge.material { E = 210e9, density = 7850 }
local bar = hinge.section.solid { width = 0.1, depth = 0.1 }

-- The warnings of a run that have this text.
local function warned(run, text)
  local list = {}
  for _, warning in ipairs(run.warnings) do
    if warning:find(text, 1, true) then list[#list + 1] = warning end
  end
  return list
end
local function one(run, text, what)
  local list = warned(run, text)
  return expect(#list == 1, "%s: %d warnings of '%s'; all: %s", what, #list, text, table.concat(run.warnings, " | ")),
    list[1] or ""
end
local function none(run, text, what)
  expect(#warned(run, text) == 0, "%s: %s", what, table.concat(run.warnings, " | "))
end

-- Passed through ------------------------------------------------------------------------------------------------------
local through = "passed through each other"

-- A bar that flies at another one, along an axis; o: axis (1 to 3), run (options), contact (rule), beam and car
-- (groups), material, elements, speed, angle (between the two, rad), aside, above (m), duration, begins (no step yet).
local function flight(o)
  local model = hinge.model(scenes.with({ elements_per_member = o.elements }, o.model))
  local function turned(x, y, z)
    local p = { x, y, z }
    return { p[(0 - o.axis + 1) % 3 + 1], p[(1 - o.axis + 1) % 3 + 1], p[(2 - o.axis + 1) % 3 + 1] }
  end
  local angle = o.angle or math.pi / 2
  local a, b = model:node(turned(0, 0, 0)), model:node(turned(0, 0, 3))
  model:fix { a, b }
  model:member { a, b, section = bar, material = o.material or steel, group = o.beam or "beam" }
  local y, z = math.sin(angle), math.cos(angle)
  local x, height = -1 + (o.aside or 0), 1.5 + (o.above or 0)
  local c, d = model:node(turned(x, -y, height - z)), model:node(turned(x, y, height + z))
  model:member { c, d, section = bar, material = o.material or steel, group = o.car or "car" }
  if o.contact then model:contact(o.contact) end
  model:velocity(o.car == o.beam and o.car and c or "car", turned(o.speed or 20, 0, 0))
  if o.car == o.beam and o.car then model:velocity(d, turned(o.speed or 20, 0, 0)) end
  local run = model:dynamic(scenes.with({ dt = 1e-4, duration = o.duration or 0.1, record = false }, o.run))
  return o.begins and run or run:finish()
end

case("members of two bodies that pass through each other are told, along any axis, by any integrator", function()
  for axis = 1, 3 do
    for name, options in pairs { newmark = {}, ["dt = auto"] = { dt = "auto" },
      explicit = { integrator = "explicit", dt = "auto" }, ["energy-momentum"] = { integrator = "energy-momentum" } } do
      for _, elements in ipairs { 2, 8 } do
        local what = ("axis %d, %s, %d elements"):format(axis, name, elements)
        local run = flight { axis = axis, run = options, elements = elements }
        equal(run.verdict, "completed", what)
        local _, text = one(run, through, what)
        expect(text:find("member 1 (beam) and member 2 (car)", 1, true)
          and text:find("the model has no contact", 1, true)
          and text:find("model:contact { between = { 'beam', 'car' } }", 1, true), "%s: %s", what, text)
        -- it comes to the beam after 0.95 to 1 m, and is looked at every 16 steps and 0.125 m
        local time = tonumber(text:match "by t = ([%d.e-]+) s")
        expect(time and time >= 0.04 and time <= 0.07, "%s: at t = %s", what, time)
      end
    end
  end
end)

case("bars at any angle that pass through each other are told, parallel ones too, fast and slow", function()
  for _, angle in ipairs { 0, 1e-9, 0.01, 1, 1.5 } do
    one(flight { axis = 1, angle = angle }, through, ("angle %g"):format(angle))
  end
  one(flight { axis = 1, speed = 400, duration = 0.005 }, through, "fast")
  one(flight { axis = 1, speed = 400, duration = 0.005, run = { dt = 1e-3 } }, through, "fast, in long steps")
  one(flight { axis = 1, speed = 1, duration = 2, run = { dt = 1e-3 } }, through, "slow")
end)

case("a rule for another pair is no rule, and one for the pair or for all is", function()
  local _, text = one(flight { axis = 1, contact = { between = { "car", "car" } } }, through, "rule within the car")
  expect(text:find("no rule of model:contact is for them", 1, true), "text: %s", text)
  one(flight { axis = 1, contact = { groups = { "beam" } } }, through, "rule within the beam")
  none(flight { axis = 1, contact = { between = { "beam", "car" } } }, through, "between")
  none(flight { axis = 1, contact = { groups = { "beam", "car" } } }, through, "groups")
  none(flight { axis = 1, contact = {} }, through, "all")
  none(flight { axis = 1, contact = { rule = "gap" } }, through, "gap")
  local _, same = one(flight { axis = 1, beam = "all", car = "all" }, through, "two bodies of one group")
  expect(same:find("model:contact { groups = { 'all' } }", 1, true), "text: %s", same)
end)

case("members that pass through each other are told in small displacement, and in statics with any rule", function()
  for _, elements in ipairs { 2, 8 } do
    one(flight { axis = 1, elements = elements, model = { displacement = "small" } }, through, "small displacement")
  end
  none(flight { axis = 1, contact = {}, model = { displacement = "small" } }, through, "small, with contact")
  -- an arm whose end is lowered through a beam below it, and one that is lowered beside it
  local function lowered(o)
    local model = scenes.cantilever { length = 4, head = "all", member = { section = bar, material = steel } }
    local c, d = model:node { o.x or 2, o.y or -0.5, 1 }, model:node { o.x or 2, 3, 1 }
    model:fix(d)
    model:member { c, d, section = bar, material = elastic, elements = 8 }
    model:load { node = c, force = { 0, 0, -1 } }
    if o.contact then model:contact {} end
    return model:static { steps = o.steps or 20, control = { node = c, "uz", to = o.to or -1.5 } }:finish()
  end
  for _, steps in ipairs { 8, 40 } do
    local _, text = one(lowered { steps = steps }, through, "statics")
    expect(text:find("by load factor", 1, true) and text:find("contact acts in dynamics alone", 1, true), "%s", text)
  end
  one(lowered { contact = true }, through, "statics with a rule, which has no effect there")
  none(lowered { x = 4.5 }, through, "beside the beam")
  none(lowered { to = -0.8 }, through, "not there yet")
end)

case("bars that pass beside each other, or have not met yet, are not told", function()
  none(flight { axis = 1, aside = -3 }, through, "too far to come there")
  none(flight { axis = 1, duration = 0.04 }, through, "not there yet")
  one(flight { axis = 1, duration = 0.0485 }, through, "just there, between two looks")
  none(flight { axis = 1, above = 1.65 }, through, "0.15 m beside the end")
end)

case("members that share a node, are linked or overlap from the start are not told, however far they move", function()
  -- a swing of three bars in a row, with a brace that crosses one of them without a node
  local model = hinge.model {}
  local n = {}
  for i = 0, 3 do n[i] = model:node { i, 0, 0 } end
  model:fix(n[0], "xyz rx rz")
  for i = 1, 3 do model:member { n[i - 1], n[i], section = bar, material = elastic,
    release = i > 1 and { a = "Mx" } or nil } end
  local low, high = model:node { 1.2, 0, -0.5 }, model:node { 1.8, 0, 0.5 }
  model:member { n[1], low, section = bar, material = elastic }
  model:member { low, high, section = bar, material = elastic }
  model:gravity { 0, 0, -9.81 }
  local run = model:dynamic { dt = 1e-3, duration = 1.5, record = false }:finish()
  expect(math.abs(select(3, n[3]:displacement(run))) > 1, "it swings: %g", select(3, n[3]:displacement(run)))
  none(run, through, "a chain with a brace across it")
end)

case("a floor that falls through another one is told, where contact is for the car alone", function()
  local model = hinge.model {}
  local g = hinge.grid { model = model, x = { 0, 6, 12 }, y = { 0, 6 }, z = { 0, 3, 6 } }
  local section = hinge.section.named "HEB 160"
  g:fix "all"
  g:columns { storeys = { 1 }, section = section, material = steel, group = "building" }
  g:columns { storeys = { 2 }, section = section, material = steel, group = { "building", "lost" } }
  g:beams { along = "x", section = section, material = steel, group = "building" }
  g:beams { along = "y", section = section, material = steel, group = "building" }
  local c, d = model:node { -1, -1, 1.5 }, model:node { -1, 1, 1.5 }
  model:member { c, d, section = bar, material = steel, group = "car" }
  model:contact { between = { "building", "car" } }
  model:gravity { 0, 0, -9.81 }
  model:remove { group = "lost", at = 0.01 }
  local rest = model:static { steps = 1, fixed_group = "car" }:finish()
  local run = model:dynamic { from = rest, dt = 1e-3, duration = 1.4, record = false }:finish()
  local _, text = one(run, through, "pancake")
  expect(text:find("no rule of model:contact is for them", 1, true) and text:find "and %d+ more pairs of members later",
    "text: %s", text)
  local _, fell = one(run, "fell below the lowest support", "pancake")
  -- the roof from 6 m, and the car from 1.5 m, in 1.39 and 1.4 s: 9.47 and 9.61 m
  local depth = tonumber(fell:match "by ([%d.]+) m")
  expect(fell:find("2 bodies fell", 1, true) and math.abs(depth - (9.61 - 1.5)) < 0.05, "depth: %s", fell)
end)

-- Fallen --------------------------------------------------------------------------------------------------------------
local fallen = "below the lowest support"
local function drop(o)
  local model = hinge.model {}
  local function place(x, z) return o.down == "y" and { x, z, 0 } or { x, 0, z } end
  local a, b = model:node(place(0, 0)), model:node(place(0, 1))
  if o.springs then
    model:connector { a, ground = true, stiffness = { x = 1e7, y = 1e7, z = 1e7, rx = 1e7, ry = 1e7, rz = 1e7 } }
  elseif not o.free then
    model:fix(a)
  end
  model:member { a, b, section = bar, material = steel, group = "posts" }
  local c, d = model:node(place(2, o.from or 2)), model:node(place(3, o.from or 2))
  model:member { c, d, section = bar, material = steel, group = "debris" }
  if o.plane then model:fix({ a, b, c, d }, o.down == "y" and "z,rx,ry" or "y,rx,rz") end
  if o.hung then model:connector { c, ground = true, stiffness = { z = 1e3 } } end
  if o.gravity ~= false then model:gravity(place(0, -9.81)) end
  if o.ground then model:ground(o.ground) end
  model:velocity("debris", place(0, o.speed or 0))
  return model:dynamic(scenes.with({ dt = 1e-3, duration = 1, record = false }, o.run)):finish()
end

case("a body that fell below the lowest support is told where no ground is for it", function()
  for _, down in ipairs { "z", "y" } do
    one(drop { down = down, plane = true }, fallen, "in a plane, down along " .. down)
    local _, text = one(drop { down = down }, fallen, "down along " .. down)
    expect(text:find("that of member 2 (debris) by 2.9 m at the end, and no ground is declared", 1, true), -- 4.905 - 2
      "text: %s", text)
  end
  local _, text = one(drop { ground = { point = { 0, 0, -0.05 }, group = "posts" } }, fallen, "ground of another group")
  expect(text:find("no ground is for them", 1, true), "text: %s", text)
end)
case("a body that fell is told where the supports are springs to the ground, too, and by explicit steps", function()
  local _, text = one(drop { springs = true }, fallen, "springs")
  expect(text:find("by 2.9", 1, true), "text: %s", text) -- 4.905 - 2
  none(drop { springs = true, ground = { point = { 0, 0, -0.05 } } }, fallen, "springs and a ground")
  one(drop { run = { dt = "auto", integrator = "explicit" } }, fallen, "explicit")
end)
case("a column that falls over to below its support is told, along any axis; one that stops above is not", function()
  local over = "fell over, to"
  for _, o in ipairs { {}, { along = "y" }, { flipped = true }, { elements = 8 }, { group = "debris", told = false },
    { duration = 0.5, told = false }, { lean = 2, told = false }, { ground = {}, told = false } } do
    local model = hinge.model { elements_per_member = o.elements }
    local foot, head = model:node { 0, 0, 0 }, model:node(o.lean and { 3, 0, 3 / o.lean } or { 0, 0, 3 })
    model:fix(foot, o.along == "y" and "xyz ry rz" or "xyz rx rz")
    local nodes = o.flipped and { head, foot } or { foot, head }
    local mast = model:member { nodes[1], nodes[2], section = bar, material = steel, group = o.group or "mast" }
    model:gravity { 0, 0, -9.81 }
    if o.group then model:ground { point = { 0, 0, -0.051 }, group = o.group } end
    if o.ground then model:ground { point = { 0, 0, -0.051 } } end
    local spin = o.along == "y" and { 0.3, 0, 0 } or { 0, 0.3, 0 }
    model:velocity(mast, { 1.5 * spin[2], -1.5 * spin[1], 0 }, spin)
    local run = model:dynamic { dt = 1e-3, duration = o.duration or 1.6, record = false }:finish()
    local what = ("along %s, %s elements, ground of %s"):format(o.along, o.elements, o.group)
    local depth = -3 - select(3, head:displacement(run))
    if o.told == false then
      none(run, over, what)
    else
      expect(depth > 0.1, "%s: it is below its support: %g", what, depth)
      local _, text = one(run, over, what)
      expect(math.abs(tonumber(text:match "to ([%d.]+) m below the support") - depth) < 0.005 * depth, "%s: %s", what,
        text)
    end
  end
end)
case("what lies on members that sag below their supports has not fallen", function()
  local model = scenes.cantilever { length = 8, head = "all",
    member = { section = bar, material = elastic, elements = 8, group = "floor" } }
  local c, d = model:node { 4, -0.5, 0.101 }, model:node { 4, 0.5, 0.101 }
  model:member { c, d, section = bar, material = steel, up = { 0, 0, 1 } }
  model:mass { node = c, mass = 9000 }
  model:mass { node = d, mass = 9000 }
  model:gravity { 0, 0, -9.81 }
  model:contact {}
  model:damping { alpha = 10 }
  local run = model:dynamic { dt = 1e-3, duration = 1, record = false }:finish()
  expect(select(3, c:displacement(run)) < -0.12, "it has sunk: %g", select(3, c:displacement(run)))
  none(run, fallen, "on a floor that sags")
end)
case("no body is told that is held, has not fallen so far, has a ground, or began below", function()
  none(drop { ground = { point = { 0, 0, -0.05 } } }, fallen, "ground")
  none(drop { ground = { point = { 0, 0, -0.05 }, group = "debris" } }, fallen, "ground of its group")
  none(drop { from = 6 }, fallen, "still above")
  none(drop { from = -1 }, fallen, "began below")
  none(drop { hung = true }, fallen, "hangs on a spring")
  none(drop { gravity = false, speed = -5 }, fallen, "no gravity")
  none(drop { free = true }, fallen, "no support")
end)

-- Strains -------------------------------------------------------------------------------------------------------------
local stress = "declares no yield stress"

case("an elastic stress that no material bears is told where no yield stress is declared", function()
  local function pull(strain, material, o)
    local model = scenes.cantilever { model = o and o.model, length = 3, along = { 0, 0, 1 }, head = "xy rx ry rz",
      member = { section = bar, material = material, carries = o and o.carries },
      force = { 0, 0, strain * material.E * bar.area } }
    return model:static { steps = 2 }:finish()
  end
  local _, text = one(pull(0.05, elastic), stress, "5 %")
  expect(text:find("an elastic stress of 10 GPa, a strain of 5 %", 1, true) or text:find("11 GPa", 1, true)
    and text:find("at load factor 1", 1, true), "text: %s", text)
  one(pull(-0.02, elastic, { model = { displacement = "small" } }), stress, "compressed by 2 %")
  one(pull(0.05, elastic, { carries = "tension" }), stress, "a cable")
  none(pull(0.009, elastic), stress, "0.9 %")
  none(pull(0.001, steel), stress, "with a yield stress")
  none(pull(0.05, hinge.material { E = 210e9, density = 7850, yield_stress = 1e12 }), stress, "with a high one")
  none(pull(0.2, hinge.material { E = 1e7, density = 1000 }), stress, "rubber")
  none(pull(0.02, hinge.material { E = 12e9, density = 500 }), stress, "timber at 2 %")
  one(pull(0.04, hinge.material { E = 12e9, density = 500 }), stress, "timber at 4 %")
end)

case("an elastic stress in torsion that no material bears is told", function()
  local sections = { bar, hinge.section.pipe { diameter = 0.2, thickness = 0.01 }, hinge.section.named "HEB 200" }
  for i, section in ipairs(sections) do
    for part, told in pairs { [0.8] = false, [1.2] = true } do
      -- largest shear stress over Mz / J: that of a square is Mz / (0.208 a^3), J is 0.1406 a^4; the radius of a pipe,
      -- the thickness of the flanges of an H
      local arm = ({ 0.1406 / 0.208 * 0.1, 0.1, 0.015 })[i]
      local model = scenes.cantilever { length = 3, along = { 0, 0, 1 }, head = "xyz rx ry",
        member = { section = section, material = elastic },
        moment = { 0, 0, part * 0.01 * 210e9 / math.sqrt(3) * section.J / arm } }
      local says = told and one or none
      says(model:static { steps = 8 }:finish(), stress, section.kind)
    end
  end
end)

case("a blow on an elastic frame is told by its stress, in dynamics by both methods", function()
  for _, options in ipairs { { dt = 2e-5 }, { dt = "auto", integrator = "explicit" } } do
    local run = flight { axis = 1, material = elastic, aside = 0.7, speed = 40, contact = {}, run = options,
      duration = 0.03 }
    local _, text = one(run, stress, options.integrator or "newmark")
    expect(text:find "at t = 0%.0%d+ s", "text: %s", text)
  end
end)

case("a member that is stretched to more than 1.6 times its length is told", function()
  for stretch, told in pairs { [0.55] = false, [0.65] = true } do
    local model, b = scenes.cantilever { along = { 0, 0, 1 }, head = "xyz rx ry rz",
      member = { section = bar, material = steel } }
    model:move { node = b, z = { { 0, 0 }, { 0.1, stretch } } }
    local run = model:dynamic { dt = 1e-4, duration = 0.1, record = false }:finish()
    local says = told and one or none
    says(run, "times its length", ("by %g"):format(stretch))
  end
end)

-- Struck --------------------------------------------------------------------------------------------------------------
case("a member of few elements that is struck between its joints and yields is told", function()
  local few = "was struck between its joints and yielded"
  local function blow(elements, o)
    local model = scenes.cantilever { length = 6, head = "all", member = { section = hinge.section.named "HEB 200",
      material = o.material or steel, group = "beam", elements = elements } }
    local x = o.at or 2
    local c, d = model:node { x, -0.2, 0.151 }, model:node { x, 0.2, 0.151 }
    model:member { c, d, section = bar, material = elastic, group = "mass" }
    model:mass { node = c, mass = 1000 }
    model:mass { node = d, mass = 1000 }
    model:velocity("mass", { 0, 0, -(o.speed or 6) })
    model:contact { between = { "beam", "mass" }, stiffness = 2e6 }
    return model:dynamic { dt = 1e-4, duration = 0.08, record = false }:finish()
  end
  for elements, told in pairs { [2] = true, [4] = true, [8] = false } do
    local run = blow(elements, {})
    expect(run.energy.plastic > 0, "it yields")
    if told then
      local _, text = one(run, few, elements .. " elements")
      expect(text:find("with " .. elements .. " elements", 1, true) and text:find("far off", 1, true)
        and text:find("elements = 8", 1, true), "text: %s", text)
    else
      none(run, few, elements .. " elements")
    end
  end
  none(blow(2, { material = elastic }), few, "an elastic beam")
  none(blow(2, { at = 0.1 }), few, "at a joint")
end)

-- Nothing to say ------------------------------------------------------------------------------------------------------
case("warnings change no bit, and a run goes on from a checkpoint with them", function()
  local file = support.temporary_folder() .. "/a.checkpoint"
  local function make() return flight { axis = 1, material = elastic, begins = true } end
  local whole = make():finish()
  local asked = make()
  for step in asked:steps() do
    local _ = step.index % 10 == 0 and asked.warnings
    if step.index == 700 then asked:checkpoint(file) end
  end
  equal(asked.hash, whole.hash, "with warnings read on the way")
  local resumed = make():resume(file)
  one(resumed, through, "where the checkpoint is")
  resumed:finish()
  equal(resumed.hash, whole.hash, "resumed")
  equal(table.concat(resumed.warnings, "|"), table.concat(whole.warnings, "|"), "warnings of the resumed run")
end)

case("a study tells how many of its cases have warnings of their run, and the first of them", function()
  local hinge_on, folder = support.scenes(arg[1])
  local scene = [[
local hinge = require "hinge"
return hinge.scenario { parameters = { speed = 20 }, run = function(p)
  local steel = hinge.material { E = 210e9, density = 7850, yield_stress = 355e6 }
  local bar = hinge.section.solid { width = 0.1, depth = 0.1 }
  local model = hinge.model {}
  local a, b = model:node { 0, 0, 0 }, model:node { 0, 0, 3 }
  model:fix { a, b }
  model:member { a, b, section = bar, material = steel }
  local c, d = model:node { -1, -1, 1.5 }, model:node { -1, 1, 1.5 }
  model:velocity(model:member { c, d, section = bar, material = steel }, { p.speed, 0, 0 })
  local run = model:dynamic { dt = 1e-4, duration = 0.1 }:finish()
  return { x = c:displacement(run) }
end }
]]
  local status, printed, complaint = hinge_on("study -q", scene, "speed=1,20,30 --out all")
  equal(status, 0, complaint)
  expect(printed:find("2 cases with warnings of their run, the first is case 2: member 1 and member 2 passed through "
    .. "each other", 1, true), "prints: %s", printed)
  local told = support.json(support.read(folder .. "/all/summary.json") or "{}").warned or {}
  equal(("%s %s"):format(told.cases, told.first), "2 2", "in summary.json")
  local _, quiet = hinge_on("study -q", scene, "speed=1,2 --out none")
  expect(not quiet:find("warnings", 1, true), "where no case has any: %s", quiet)
end)

-- Groups that grow ----------------------------------------------------------------------------------------------------
local function grows(declare, first, o)
  local model, n = hinge.model {}, {}
  for i = 0, 4 do n[i] = model:node { 3 * i, 0, 0 } end
  model:fix { n[0], n[2], n[4] }
  local section = hinge.section.named "IPE 200"
  local function add(i) model:member { n[i], n[i + 1], section = section, material = steel, group = "beam" } end
  add(0) add(1)
  if first then declare(model, n) end
  add(2) add(3)
  if not first then declare(model, n) end
  local run = o == "static" and model:static { steps = 1 } or model:dynamic { dt = 1e-4, duration = 0.02 }
  run:finish()
  return { n[1]:displacement(run) }, { n[3]:displacement(run) }
end
case("a load and a velocity of a group hold for members that come to it later", function()
  for name, one_of in pairs {
    load = { function(m) m:load { group = "beam", q = { 0, 0, -5e3 } } end, "static" },
    ["load at a point"] = { function(m) m:load { group = "beam", at = 0.5, force = { 0, 1e3, -5e3 } } end, "static" },
    velocity = { function(m) m:velocity("beam", { 0, 0, -2 }) end, "dynamic" },
    ["velocity of the group object"] = { function(m) m:velocity(m:group "beam", { 0, 0, -2 }) end, "dynamic" },
    ["velocity of a group, then of a node"] = {
      function(m, n) m:velocity("beam", { 0, 0, -2 }) m:velocity(n[3], { 0, 0, -1 }) end, "dynamic" } } do
    local a1, a3 = grows(one_of[1], true, one_of[2])
    local b1, b3 = grows(one_of[1], false, one_of[2])
    for c = 1, 6 do
      equal(a1[c], b1[c], ("%s, first members, %d"):format(name, c))
      equal(a3[c], b3[c], ("%s, later members, %d"):format(name, c))
    end
    expect(math.abs(a3[3]) > 1e-5, "%s: it moves", name)
  end
end)
case("a member that would move the point about which its group turns is refused, and changes nothing", function()
  local model, n = hinge.model {}, {}
  for i = 0, 3 do n[i] = model:node { i, 0, 0 } end
  model:member { n[0], n[1], section = bar, material = steel, group = "rod" }
  model:member { n[1], n[2], section = bar, material = steel, group = "rod" }
  model:velocity("rod", { 0, 0, 1 }, { 0, 3, 0 })
  refused("group 'rod' has an angular velocity, given at", model.member, model,
    { n[2], n[3], section = bar, material = steel, group = "rod" })
  equal(#model:members(), 2, "members")
  model:member { n[0], n[2], section = bar, material = steel, group = "rod" } -- brings no joint
  model:member { n[2], n[3], section = bar, material = steel, group = "other" }
end)

checks.done()

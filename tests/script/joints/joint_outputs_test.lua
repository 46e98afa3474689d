-- Joints, panel zones and connectors in all that a run leaves: events.csv, hinges.csv, summary.json, utilisation,
-- frames, checkpoints. run:hinges itself, and robustness, are in joint_ratings_test.lua.
--
-- Run: lua5.4 tests/script/joints/joint_outputs_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local scenes = require "scenes"
local values = require "hinge.library.values"
local checks = support.checks "joints in all outputs"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local hinge_on, folder = support.scenes(arg[1])
local elastic = hinge.material { E = 210e9, density = 7850 }
local square = hinge.section.solid { width = 0.1, depth = 0.1 }
local small = { displacement = "small" }

-- Rows of events.csv as tables by column.
local function events(name)
  local rows, columns = {}, nil
  for line in (support.read(("%s/%s/events.csv"):format(folder, name)) or ""):gmatch "[^\n]+" do
    local cells = values.csv_fields(line)
    if not columns then
      columns = cells
    else
      local row = {}
      for i, column in ipairs(columns) do row[column] = cells[i] end
      rows[#rows + 1] = row
    end
  end
  return rows, columns or {}
end

local function run(script, name, arguments)
  local status, _, complaint = hinge_on("run -q", script, ("--out %s %s"):format(name, arguments or ""))
  equal(status, 0, name .. ": " .. tostring(complaint))
  return events(name)
end

-- A joint with a curve at the wall of a cantilever, under a moment at its tip.
local cantilever = [[
local hinge = require "hinge"
local p = ... or {}
local model = hinge.model { displacement = "small" }
local wall, tip = model:node { 0, 0, 0 }, model:node { 2, 0, 0 }
model:fix(wall)
model:member { wall, tip, section = hinge.section.solid { width = 0.1, depth = 0.1 }, group = "arm",
  material = hinge.material { E = 210e9, density = 7850 }, ends = { a = hinge.joint {
    Mx = { points = { { 0.02, 2e3 }, { 0.12, 4e3 } }, capacity = 0.05 },
    My = { points = { { 0.01, 1e3 }, { 0.11, 2e3 } } } } } }
]]

-- Events --------------------------------------------------------------------------------------------------------------

case("first yield of a joint and the limit that it reaches in statics are in events.csv", function()
  local rows, columns = run(cantilever .. [[
model:load { node = tip, moment = { 0, 3e3, 0 } }
model:static { steps = 300 }:finish()
]], "statics")
  equal(table.concat(columns, ","), "factor,event,element,member,end,group,limit,strain,of,rule,joint", "columns")
  equal(#rows, 2, "events")
  local yield, limit = rows[1] or {}, rows[2] or {}
  for what, row in pairs { yield = yield, limit = limit } do
    equal(("%s %s %s %s"):format(row.element, row.member, row["end"], row.group), "1 1 1 arm", what)
    equal(row.joint, "joint at end a of member 1", what)
  end
  equal(yield.event .. " " .. yield.limit, "joint_yield moment_x", "first yield")
  -- to a step: 2 kN m of 3 in 300 steps
  near(tonumber(yield.factor), 2 / 3, 1 / 300 + 1e-9, "factor")
  near(math.abs(tonumber(yield.strain)), 2e3, 11, "moment then") -- a step of 10 N m
  equal(tonumber(yield.of), 2e3, "end of the elastic part")
  equal(limit.event .. " " .. limit.limit, "joint_limit rotation_x", "limit")
  -- 0.05 rad at 2 kN m + 0.3 of 2 kN m
  near(tonumber(limit.factor), 2.6 / 3, 1 / 300 + 1e-9, "factor of the capacity")
  near(math.abs(tonumber(limit.strain)), 0.05, 0.0006, "rotation then") -- a step of 0.0005 rad
  equal(tonumber(limit.of), 0.05, "capacity")
end)

case("an axis that yields after the other has an event of its own, and none comes twice", function()
  local rows = run(cantilever .. [[
local both = model:case "both"
both:load { node = tip, moment = { 0, 2.2e3, 1.5e3 } }
local first = model:static { steps = 22, loads = { both = 0.95 } }:finish()
local back = model:static { from = first, steps = 4, loads = { both = 0 } }:finish()
model:static { from = back, steps = 40, loads = { both = 0.97 } }:finish()
]], "axes")
  equal(#rows, 0, "the last run has none: all have yielded before")
  rows = events "axes"
  local first = support.read(folder .. "/axes/events-1.csv") or ""
  local _, yields = first:gsub("joint_yield", "")
  equal(yields, 2, "of the first run: " .. first)
  expect(first:find "moment_y,[^\n]+,1000," and first:find "moment_x,[^\n]+,2000,", "each axis: %s", first)
  equal(#rows, 0, "and none in the last one")
end)

case("a joint and a connector that break are in events.csv, with what broke them", function()
  local rows = run(cantilever .. [[
model:load { node = tip, force = { 0, 0, -2.5e3 } }
model:dynamic { dt = 1e-4, duration = 0.12 }:finish()
]], "breaks")
  local of = {}
  for _, row in ipairs(rows) do of[row.event] = row end
  expect(of.joint_yield and of.joint_break and #rows == 2, "%d events", #rows)
  local broke = of.joint_break or {}
  equal(broke.limit, "rotation_x", "by its rotation")
  expect(math.abs(tonumber(broke.strain)) >= 0.05 and math.abs(tonumber(broke.strain)) < 0.052, "at %s", broke.strain)
  equal(tonumber(broke.of), 0.05, "its limit")
  local summary = support.json(support.read(folder .. "/breaks/summary.json") or "{}")
  local told
  for _, change in ipairs(summary.state_changes or {}) do told = change.effect == "joints" and change or told end
  near(tonumber(broke.time), told and told.time or -1, 1e-4, "when the summary says so, to a step")
end)

local hanger = [[
local hinge = require "hinge"
local p = ... or {}
local model = hinge.model { displacement = "small" }
local a, b = model:node { 0, 0, 0 }, model:node { 2, 0, 0 }
model:fix(a, p.fix or "xyz rx ry rz")
model:member { a, b, section = hinge.section.solid { width = 0.1, depth = 0.1 }, group = "beam",
  material = hinge.material { E = 210e9, density = 7850 } }
model:connector { b, ground = true, stiffness = { z = 1e8 }, capacity = { z = 2e3 } }
model:load { node = b, force = { 0, 0, -(p.force or 2.2e3) } }
]]

-- The cantilever and the spring share the load: 3 E I / L^3 beside 1e8 N/m.
local I = 0.1 ^ 4 / 12
local share = 1e8 / (1e8 + 3 * 210e9 * I / 2 ^ 3)

case("a connector that breaks is in events.csv, run:hinges, hinges.csv and summary.json", function()
  local rows = run(hanger .. [[
local run = model:static { steps = 100 }:finish()
for _, h in ipairs(run:hinges()) do
  print(h.joint, h.axis, h.connector, h.force, h.largest_force, h.strength, h.broken, h.failed, h.ratio)
end
print(run:hinges())
]], "connector")
  equal(#rows, 1, "events")
  local broke = rows[1] or {}
  equal(("%s %s %s %s"):format(broke.event, broke.limit, broke.member, broke["end"]), "connector_break force_z 1 2",
    "event")
  equal(broke.joint, "connector 1 between the ground and node 2", "its name")
  near(tonumber(broke.factor), 2e3 / (2.2e3 * share), 0.01 + 1e-9, "at the load that it can carry, to a step")
  expect(math.abs(tonumber(broke.strain)) >= 2e3, "force %s", broke.strain)
  local text = support.read(folder .. "/connector/hinges.csv") or ""
  expect(text:find('"connector 1 between the ground and node 2","force_z"', 1, true), "hinges.csv: %s", text)
  local of = support.json(support.read(folder .. "/connector/summary.json") or "{}").connectors or {}
  equal(of.count, 1, "connectors in the summary")
  equal(of.broken, 1, "broken")
  equal(of.largest and of.largest[1] and of.largest[1].axis, "force_z", "which force")
end)

case("a connector that holds is rated by the largest force over its capacity", function()
  local function rated(force)
    local model, b = scenes.cantilever { model = small, length = 2, member = { section = square, material = elastic } }
    model:connector { b, ground = true, stiffness = { z = 1e8 }, capacity = { z = 2e3 } }
    model:case("push"):load { node = b, force = { 0, 0, force } }
    local up = model:static { steps = 4, loads = { push = 1 } }:finish()
    return up, model:static { from = up, steps = 4, loads = { push = 0 } }:finish()
  end
  for _, sign in ipairs { 1, -1 } do
    local up, back = rated(sign * 1.1e3)
    for _, of in ipairs { { up, 1.1e3 * share }, { back, 0 } } do
      local list = of[1]:hinges()
      equal(#list, 1, "rows")
      -- the cantilever bends in shear as well: 1e-5 of the force
      near(list[1].force, of[2], 2e-5 * 1.1e3, "force now")
      near(list[1].ratio, 0.55 * share, 2e-5, "of its capacity, the largest so far")
      equal(list.beyond, 0, "it holds")
    end
  end
  local list = rated(3e3):hinges()
  equal(list.beyond, 1, "one that has broken is beyond it")
  equal(list[1].force, 0, "and carries nothing")
  expect(tostring(list):find("0 plastic hinges and 1 connector, 1 beyond the limit; the worst: connector 1 between the "
    .. "ground and node 2, force along z", 1, true), "as text: %s", tostring(list))
end)

case("events of joints before a checkpoint are told once by the run that goes on", function()
  local script = hanger .. [[
local run = model:dynamic { dt = 1e-5, duration = 0.02, checkpoint = "c" }
if p.stop then
  while run.time < 0.01 and run:step() do end
  run:checkpoint "half"
else
  if p.resume then run:resume "half" end
  run:finish()
end
]]
  run(script, "halves", "stop=yes")
  local whole = run(script, "whole")
  equal(#whole, 1, "the connector breaks")
  support.run(("cd %s && mkdir -p goes_on && cp halves/half goes_on/half"):format(support.quote(folder)))
  run(script, "goes_on", "resume=yes")
  equal(support.read(folder .. "/goes_on/events.csv"), support.read(folder .. "/whole/events.csv"), "events")
end)

-- Utilisation ---------------------------------------------------------------------------------------------------------

local steel = hinge.material.steel "S355"
local girder = hinge.section.named "IPE 360"

-- A cantilever whose joint at the wall carries M, N and V. how: joint, force, moment, along, up, flipped.
local function loaded(how)
  local model, tip, beam = scenes.cantilever { model = small, length = 2, along = how.along, flipped = how.flipped,
    member = { section = girder, material = how.material or steel, up = how.up or { 0, 0, 1 }, group = "arm",
      ends = { [how.flipped and "b" or "a"] = how.joint } } }
  model:case("push"):load { node = tip, force = how.force, moment = how.moment }
  return model:static { steps = 10, loads = { push = 1 } }, model, beam
end

local function rows_of(used)
  local joints = {}
  for _, row in ipairs(used.rows) do
    if row.joint then joints[#joints + 1] = row end
  end
  return joints
end

-- The row of the joint of such a cantilever.
local function used_joint(how)
  local run_, model = loaded(how)
  return rows_of(hinge.results.utilisation(run_:finish(), { model = model, standard = "EN 1993-1-1" }))[1]
end

case("hinge.results.utilisation has a joint that is weaker than its member, by either standard", function()
  for _, standard in ipairs { "EN 1993-1-1", "AISC 360" } do
    for _, flipped in ipairs { false, true } do
      local run_, model = loaded { joint = hinge.joint { Mx = { stiffness = 60e6, strength = 150e3 } },
        flipped = flipped, moment = { 0, 90e3, 0 } }
      local used = hinge.results.utilisation(run_:finish(), { model = model, standard = standard })
      local list = rows_of(used)
      equal(#list, 1, "rows of joints")
      local row = list[1] or {}
      near(row.utilisation, 0.6, 1e-6, standard)
      equal(row.check, "joint Mx", "check")
      equal(row.joint, ("joint at end %s of member 1"):format(flipped and "b" or "a"), "name")
      near(row.x, flipped and 2 or 0, 1e-9, "place")
      expect(row.utilisation > used.rows[1].utilisation, "the member has less: %g", used.rows[1].utilisation)
      expect(tostring(used):find("joint at end", 1, true) and tostring(used):find("0.600", 1, true), "table: %s",
        tostring(used))
    end
  end
end)

case("each axis counts by itself, tension is added where it weakens the joint, and forces have their limits", function()
  local function checks_of(joint, how)
    how.joint = hinge.joint(joint)
    local row = used_joint(how)
    local found = {}
    for name, of in pairs(row.checks) do found[name] = of.value end
    return found, row
  end
  local Mx, My = { stiffness = 60e6, strength = 100e3 }, { stiffness = 10e6, strength = 20e3, capacity = 0.01 }
  local all = checks_of({ Mx = Mx, My = My, tension = 200e3, shear = 80e3 }, { moment = { 0, 30e3, 5e3 },
    force = { 40e3, 0, -10e3 } })
  near(all["joint Mx"], (30e3 + 20e3) / 100e3, 1e-4, "Mx: 30 kN m and 10 kN over 2 m")
  near(all["joint My"], 0.25, 1e-5, "My")
  near(all["joint rotation y"], 5e3 / 10e6 / 0.01, 1e-5, "rotation about y")
  near(all["joint tension"], 0.2, 1e-4, "tension")
  near(all["joint shear"], 0.125, 1e-4, "shear")
  equal(all["joint Mx + tension"], nil, "no interaction")
  local weak = checks_of({ Mx = Mx, My = My, tension = 200e3, interaction = "linear" }, { moment = { 0, 30e3, 5e3 },
    force = { 40e3, 0, 0 } })
  near(weak["joint Mx + tension"], 0.3 + 0.2, 1e-4, "Mx and tension")
  near(weak["joint My + tension"], 0.25 + 0.2, 1e-4, "My and tension")
  equal(weak["joint Mx"], nil, "the sum takes its place")
  local pressed = checks_of({ Mx = Mx, tension = 200e3, interaction = "linear" }, { moment = { 0, 30e3, 0 },
    force = { -40e3, 0, 0 } })
  near(pressed["joint Mx + tension"], 0.3, 1e-4, "compression takes nothing")
  local _, without = checks_of({ Mx = { stiffness = 60e6 } }, { moment = { 0, 30e3, 0 } })
  equal(without.utilisation, nil, "an elastic joint has no strength")
  equal(without.remark, "not checked: no strength about x", "and it says so")
end)

case("a joint has the same utilisation at a member in any direction", function()
  local r = math.sqrt(0.5)
  for name, how in pairs {
    x = { along = { 1, 0, 0 }, moment = { 0, 60e3, 0 } }, y = { along = { 0, 1, 0 }, moment = { 60e3, 0, 0 } },
    inclined = { along = { r, 0, r }, moment = { 0, 60e3, 0 } },
    upright = { along = { 0, 0, 1 }, moment = { 0, 60e3, 0 }, up = { 1, 0, 0 } },
    ["rotated to its weak axis"] = { along = { 1, 0, 0 }, moment = { 0, 60e3, 0 }, up = { 0, 1, 0 }, axis = "My" } } do
    how.joint = hinge.joint { [how.axis or "Mx"] = { stiffness = 60e6, strength = 150e3 } }
    how.material = elastic -- the weak axis of the section would yield
    local row = used_joint(how)
    near(row.utilisation, 0.4, 1e-6, name)
    equal(row.check, "joint " .. (how.axis or "Mx"), name)
  end
end)

case("utilisation over a run, over runs and of an envelope has the largest value of a joint, with its state", function()
  local function make()
    return loaded { joint = hinge.joint { Mx = { stiffness = 60e6, strength = 150e3 } }, moment = { 0, 90e3, 0 } }
  end
  local going, model = make()
  local used = hinge.results.utilisation({}, { model = model, standard = "EN 1993-1-1" })
  going:on_step(function(now) if now.index % 5 == 0 then used:add(now, "step " .. now.index) end end)
  going:finish()
  local back = model:static { from = going, loads = { push = 0 }, steps = 2 }:finish()
  used:add(back, "back")
  equal(rows_of(used)[1].when, "step 10", "when")
  near(rows_of(used)[1].utilisation, 0.6, 1e-6, "largest")
  local swinging, other = make()
  local envelope = hinge.results.envelope { swinging, model = other }
  swinging:finish()
  envelope:add(other:static { from = swinging, loads = { push = 0 }, steps = 2 }:finish(), "back")
  local of_envelope = rows_of(hinge.results.utilisation(envelope, { model = other, standard = "EN 1993-1-1" }))[1]
  near(of_envelope.utilisation, 0.6, 1e-6, "of the envelope")
  local one = hinge.results.utilisation(going, { model = model, standard = "EN 1993-1-1", group = "arm" })
  equal(#rows_of(one), 1, "by group")
end)

case("panel zones and connectors have rows of utilisation, and one that broke has what broke it", function()
  local model = hinge.model { displacement = "small" }
  local wall, here, there, tip = model:node { 0, 0, 0 }, model:node { 2, 0, 0 }, model:node { 2, 0, 0 },
    model:node { 4, 0, 0 }
  model:fix(wall)
  model:member { wall, here, section = girder, material = elastic }
  model:member { there, tip, section = girder, material = elastic }
  model:joint { here, there, joint = hinge.joint { My = { stiffness = 10e6, strength = 50e3 } } }
  model:connector { tip, ground = true, stiffness = { rx = 1 }, capacity = { rx = 1e-3 } }
  model:connector { tip, ground = true, stiffness = { x = 1e7 }, capacity = { x = 1e3 } }
  model:load { node = tip, moment = { 0, 30e3, 0 }, force = { 1e6, 0, 0 } }
  local run_ = model:static { steps = 10 }:finish()
  local list = rows_of(hinge.results.utilisation(run_, { model = model, standard = "AISC 360" }))
  equal(#list, 3, "rows")
  local of = {}
  for _, row in ipairs(list) do of[row.joint] = row end
  local panel = of["joint between nodes 2 and 3"] or {}
  near(panel.utilisation or -1, 0.6, 1e-6, "panel zone")
  equal(panel.x, nil, "it is between members")
  equal(panel.index, 2, "with the member of its second node")
  local whole = of["connector 1 between the ground and node 4"] or {}
  near(whole.utilisation or -1, 0, 1e-6, "a connector without force")
  local broke = of["connector 2 between the ground and node 4"] or {}
  equal(broke.remark, "broken", "remark")
  expect((broke.utilisation or 0) > 1 and broke.check == "connector force x", "%s of %s", broke.utilisation,
    broke.check)
end)

-- Pictures ------------------------------------------------------------------------------------------------------------

case("the legend of a picture says whether its dots are joints, hinges or both; frames keep it", function()
  if not support.is_there(arg[1] .. "/libhinge_output.so") then return end
  local function picture(yield, joint)
    local status, _, complaint = hinge_on("run -q", ([[
local hinge = require "hinge"
local model = hinge.model { displacement = "small" }
local wall, tip = model:node { 0, 0, 0 }, model:node { 2, 0, 0 }
model:fix(wall)
model:member { wall, tip, section = hinge.section.solid { width = 0.1, depth = 0.1 },
  material = hinge.material { E = 210e9, density = 7850%s },
  ends = { a = hinge.joint { Mx = { %s } } } }
model:load { node = tip, moment = { 0, 3e3, 0 } }
local run = model:static { steps = 3 }:finish()
hinge.frame(run)
hinge.picture(run, { show = "group", view = "front", width = 400, height = 300 }, "at_once.png")
]]):format(yield, joint), "--out frames")
    equal(status, 0, complaint)
    local frame = support.read(folder .. "/frames/frames/frame_00001.vtp") or ""
    return support.read(folder .. "/frames/at_once.png"), frame:find("joints that can yield", 1, true) ~= nil
  end
  local curve = "points = { { 0.02, 2e3 }, { 0.12, 4e3 } }"
  -- the dot is the same, and nothing is coloured by f_y: only the words differ
  local joints, kept = picture("", curve)
  local both = picture(", yield_stress = 1e9", curve)
  expect(joints and both and joints ~= both, "rotation of joints, and of hinges and joints")
  equal(joints, (picture("", curve)), "the same picture twice")
  equal(kept, true, "a frame says that there are joints that can yield")
  equal(select(2, picture("", "stiffness = 1e5")), false, "an elastic joint cannot")
end)

return checks.done()

-- Joints are listed and rated as plastic hinges are: by run:hinges, in hinges.csv, summary.json, pictures, and by
-- hinge.robustness.
--
-- Run: lua5.4 tests/script/joints/joint_ratings_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local scenes = require "scenes"
local with = scenes.with
local checks = support.checks "joints that are rated"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local elastic = hinge.material { E = 210e9, density = 7850 }
local square = hinge.section.solid { width = 0.1, depth = 0.1 }
local bar = { section = square, material = elastic }
local L, k, strength = 2, 1e5, 2e3 -- m, N m/rad, N m

-- A cantilever along a direction with a joint at the wall, whose tip is turned by a load until the joint has yielded.
-- how: axis ("Mx"), joint (of that axis), elements, flipped (the joint is at the member's end b), along.
local function pushed(how)
  local joint, last = hinge.joint { [how.axis] = how.joint }, how.flipped and "b" or "a"
  local model, tip, arm, wall = scenes.cantilever { model = { displacement = "small" }, length = L, along = how.along,
    flipped = how.flipped, member = with(bar, { up = how.up or { 0, 0, 1 }, group = "arms", elements = how.elements,
      ends = { [last] = joint } }) }
  -- a moment at the tip is that of the joint; about x, y and z of a section with z along the member and y = up
  local moment = { Mx = { 0, 1, 0 }, My = { 0, 0, 1 }, Mz = { 1, 0, 0 } }
  local m = how.moment or moment[how.axis]
  model:case("push"):load { node = tip, moment = { how.M * m[1], how.M * m[2], how.M * m[3] } }
  local run = model:static { steps = how.steps or 10, loads = { push = 1 } }:finish()
  return run, arm, last, model, wall
end

local axis_of = { Mx = "x", My = "y", Mz = "z" }

case("a joint has the moment and the rotation of its spring, about x, y and z, at either end, with any elements",
  function()
    for axis, name in pairs(axis_of) do
      for _, elements in ipairs { 1, 2, 4, 8 } do
        for _, flipped in ipairs { false, true } do
          local M = 0.7 * strength
          local run, arm, last, _, wall = pushed { axis = axis, joint = { stiffness = k, strength = strength },
            elements = elements > 1 and elements or nil, flipped = flipped, M = M }
          local what = ("%s, %d elements, end %s"):format(axis, elements, last)
          local list = run:hinges { limit = 2 * M / k }
          equal(#list, 1, "rows; " .. what)
          local h = list[1]
          equal(h.axis, name, "axis; " .. what)
          equal(h.joint, ("joint at end %s of member 1"):format(last), "name; " .. what)
          equal(h.member, arm, "member; " .. what)
          equal(h.node, wall, "node; " .. what)
          equal(h.at, flipped and 1 or 0, "place; " .. what)
          -- rounding of the solution, with rigid axes of 1e5 times the member's stiffness beside the joint
          near(math.abs(h.moment), M, 1e-6 * M, "moment; " .. what)
          near(h.largest, M / k, 1e-6 * M / k, "rotation; " .. what)
          near(h.ratio, 0.5, 1e-6, "of the limit; " .. what)
          near(h.utilisation, 0.7, 1e-6, "of the strength; " .. what)
          equal(h.strength, strength, "strength; " .. what)
          equal(h.yielded, false, "it has not yielded; " .. what)
          equal(list.beyond, 0, "none is beyond; " .. what)
          equal(run:hinges { limit = 0.9 * M / k }.beyond, 1, "one is beyond; " .. what)
        end
      end
    end
  end)

case("a joint that has yielded keeps its largest rotation, its work and when it yielded", function()
  -- a curve that hardens has an equilibrium beyond yield under a given moment
  local curve = { points = { { 0.02, strength }, { 0.12, 2 * strength } } }
  local M, turned = 1.5 * strength, 0.02 + 0.05
  local run, _, _, model = pushed { axis = "Mx", joint = curve, M = M, steps = 30 }
  local h = run:hinges()[1]
  near(h.largest, turned, 1e-6, "rotation")
  equal(h.yielded, true, "it has yielded")
  near(h.first_yield, 1 / 1.5, 1 / 30 + 1e-9, "at the load factor of its strength, to a step")
  equal(h.first_kind, "static", "in statics")
  -- below the curve, less what is stored: two parts in series with sliders
  local slope, k1 = strength / 0.1, strength / 0.02
  local stored = 0.5 * (k1 - slope) * 0.02 ^ 2 + 0.5 * slope * turned ^ 2
  local below = 0.5 * strength * 0.02 + 0.5 * (strength + M) * (turned - 0.02)
  near(h.work, below - stored, 2e-2 * (below - stored), "work") -- steps of the slider: of first order
  near(h.work, run.energy.joint_dissipated, 1e-9 * h.work, "and it is the account's")
  local back = model:static { from = run, loads = {}, steps = 10 }:finish()
  expect(back.verdict ~= "failed", "goes on: %s", back.reason)
  local later = back:hinges()[1]
  equal(later.largest, h.largest, "the largest rotation stays")
  equal(later.before, true, "it yielded in the run before")
  equal(later.first_yield, h.first_yield, "at the same time")
end)

case("what a joint has gone through goes on over runs of dynamics", function()
  local function swinging()
    return (scenes.cantilever { model = { displacement = "small" }, length = L, force = { 0, 0, -1.1 * strength / L },
      member = with(bar, { ends = { a = hinge.joint { Mx = { stiffness = 1e6, strength = strength } } } }) })
  end
  local function run_of(model, duration, from)
    return model:dynamic { dt = 1e-4, duration = duration, from = from, record = false }:finish()
  end
  local whole = run_of(swinging(), 0.04):hinges()[1]
  expect(whole.yielded and whole.first_kind == "dynamic" and not whole.before, "it yields")
  local model = swinging()
  local first = run_of(model, 0.03)
  local rest = run_of(model, 0.01, first):hinges()[1]
  expect(whole.first_yield < 0.03, "in the first run: %g s", whole.first_yield)
  for _, name in ipairs { "largest", "largest_moment", "work", "first_yield", "rotation" } do
    equal(rest[name], whole[name], name .. ": as in one run")
  end
  equal(rest.before, true, "it yielded in a run before")
  local before = swinging()
  local early = run_of(before, 0.5 * whole.first_yield)
  equal(early:hinges()[1].yielded, false, "not yet")
  equal(run_of(before, 0.04, early):hinges()[1].before, false, "it yields in the second run")
end)

case("joints of steel frames are listed beside the hinges of members, and by their groups", function()
  local model = hinge.model()
  local steel = hinge.material.steel "S235"
  local a, b, c = model:node { 0, 0, 0 }, model:node { 0, 0, 3 }, model:node { 4, 0, 3 }
  model:fix(a)
  model:fix(b, "y,rx,rz")
  model:fix(c, "y,rx,rz")
  model:member { a, b, section = square, material = steel, group = "posts", up = { 1, 0, 0 } }
  model:member { b, c, section = square, material = steel, group = "beams", up = { 0, 0, 1 },
    ends = { a = hinge.joint { Mx = { stiffness = 1e6, strength = 3e4 } } } }
  model:case("push"):load { node = c, force = { 0, 0, -1 } }
  local run = model:static { steps = 40, loads = { push = 1 }, control = { node = c, "uz", to = -0.6 } }:finish()
  local joints = 0
  for _, h in ipairs(run:hinges()) do
    if h.joint then joints = joints + 1 end
    equal(h.group, h.joint and "beams" or "posts", "group")
    expect(h.yielded, "yielded")
  end
  equal(joints, 1, "joints")
  equal(#run:hinges { group = "beams" }, 1, "of the beams")
  equal(#run:hinges { group = "posts" }, #run:hinges() - 1, "of the posts")
  equal(run:hinges { limit = { posts = 0.01 } }.without_limit, 1, "the joint of a beam has no limit of posts")
  local by_group = run:hinges { limit = { beams = 1e-4 } }
  equal(by_group.worst.joint, "joint at end a of member 2", "the worst by group")
  expect(by_group.worst.ratio > 1, "beyond it: %g", by_group.worst.ratio)
end)

case("a limit of the joint's own counts without one of the script, and the smaller one counts", function()
  local function list(capacity, limit)
    local run = pushed { axis = "Mx", joint = { stiffness = k, capacity = capacity }, M = 1e3 } -- 0.01 rad
    return run:hinges { limit = limit }
  end
  local own = list(0.0125)
  equal(own.beyond, 0, "below its capacity")
  near(own.worst.ratio, 0.8, 1e-6, "of its capacity")
  equal(own.worst.utilisation, nil, "an elastic joint has no strength")
  near(list(0.0125, 0.02).worst.ratio, 0.8, 1e-6, "of the smaller limit, its own")
  near(list(0.0125, 0.01).worst.ratio, 1, 1e-6, "of the smaller limit, the script's")
  local beyond = list(0.008)
  equal(beyond.beyond, 1, "beyond its capacity")
  equal(beyond.worst.failed, true, "it would break")
  expect(tostring(beyond):find("1 joint, 1 beyond the limit; the worst: joint at end a of member 1, about x, 0.01 rad, "
    .. "1.25 of its limit 0.008 rad", 1, true), "as text: %s", tostring(beyond))
  equal(list(0.008, { IO = 0.011, CP = 0.02 }).worst.level, "beyond capacity", "level")
  equal(list(nil, { IO = 0.009, CP = 0.02 }).worst.level, "CP", "level of a joint without a capacity")
end)

case("joints that break by tension or shear are rated by the force, and a broken one is beyond its limit", function()
  for _, by in ipairs { "tension", "shear" } do
    for _, part in ipairs { 0.5, 1.5 } do
      local P = part * 1e3
      local model = scenes.cantilever { length = L, force = by == "tension" and { P, 0, 0 } or { 0, 0, P },
        member = with(bar, { ends = { a = hinge.joint { [by] = 1e3, Mx = { stiffness = 1e7 } } } }) }
      local rest = model:static { steps = 4 }:finish()
      local row
      for _, h in ipairs(rest:hinges()) do row = h.axis == by and h or row end
      local what = ("%s, %g"):format(by, part)
      near(row.ratio, part, 1e-3 * part, "ratio in statics; " .. what) -- the tip's displacement turns the force
      near(row.largest_force, P, 1e-3 * P, "force; " .. what)
      equal(rest:hinges().beyond, part > 1 and #rest:hinges() or 0, "beyond in statics; " .. what)
      local run = model:dynamic { from = rest, dt = 1e-4, duration = 2e-3 }:finish()
      equal(run:hinges()[1].broken, part > 1, "broken; " .. what)
      equal(run:hinges().beyond > 0, part > 1, "beyond in dynamics; " .. what)
    end
  end
end)

case("a joint between nodes is rated with the members at its second node", function()
  local model = hinge.model { displacement = "small" }
  local wall, here, there, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }, model:node { L, 0, 0 },
    model:node { 2 * L, 0, 0 }
  model:fix(wall)
  model:member { wall, here, section = square, material = elastic, group = "posts" }
  local beam = model:member { there, tip, section = square, material = elastic, group = "beams" }
  model:joint { here, there, joint = hinge.joint { My = { stiffness = k, strength = strength } } }
  model:load { node = tip, moment = { 0, 0.5 * strength, 0 } }
  local run = model:static { steps = 2 }:finish()
  local list = run:hinges { limit = { beams = 0.008, posts = 1 } }
  equal(#list, 1, "rows")
  equal(list[1].member, beam, "its member")
  equal(list[1].node, there, "its node")
  equal(list[1].joint, "joint between nodes 2 and 3", "its name")
  equal(list[1].axis, "y", "its axis")
  near(list[1].ratio, 0.5 * strength / k / 0.008, 1e-6, "of the limit of the beam")
end)

case("pins have no row, and a limit of the script may be a function of a joint", function()
  local model = hinge.model { displacement = "small" }
  local a, b = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix { a, b }
  model:member { a, b, section = square, material = elastic, release = { a = "Mx" },
    ends = { b = hinge.joint { Mx = { stiffness = k }, My = { stiffness = k } } } }
  model:load { member = model:members()[1], q = { 0, 0, -1e3 } }
  local run = model:static():finish()
  local seen = {}
  local list = run:hinges { limit = function(h)
    seen[#seen + 1] = h.joint .. " " .. h.axis
    return h.axis == "x" and 0.1 or nil
  end }
  equal(table.concat(seen, ", "), "joint at end b of member 1 x, joint at end b of member 1 y", "what it is asked of")
  equal(list.without_limit, 1, "the other axis has none")
end)

case("hinges.csv, summary.json and pictures have the joints", function()
  local hinge_on, folder = support.scenes(arg[1])
  local drawn = support.is_there(arg[1] .. "/libhinge_output.so")
  local status, _, complaint = hinge_on("run -q", [=[
local hinge = require "hinge"
local model = hinge.model { displacement = "small" }
local wall, tip = model:node { 0, 0, 0 }, model:node { 2, 0, 0 }
model:fix(wall)
model:member { wall, tip, section = hinge.section.solid { width = 0.1, depth = 0.1 },
  material = hinge.material { E = 210e9, density = 7850 }, ends = { a = hinge.joint { tension = 1e6,
    Mx = { points = { { 0.02, 2e3 }, { 0.12, 4e3 } }, capacity = 0.1 } } } }
model:load { node = tip, moment = { 0, 3e3, 0 } }
local run = model:static { steps = 4 }:finish()
for name, drawn in pairs { with = true, without = false, near = run:hinges { limit = 0.05 }, far = run:hinges() } do
  hinge.picture(run, { view = "front", width = 320, height = 240, hinges = drawn }, name .. ".png")
end
]=], "--out one")
  expect(status == 0 or not drawn, "runs: %s", complaint)
  local lines = {}
  for line in (support.read(folder .. "/one/hinges.csv") or ""):gmatch "[^\n]+" do lines[#lines + 1] = line end
  equal(#lines, 3, "lines of hinges.csv: two rows")
  expect((lines[2] or ""):find('"joint at end a of member 1","x"', 1, true), "row: %s", lines[2])
  expect((lines[3] or ""):find('"joint at end a of member 1","tension"', 1, true), "row: %s", lines[3])
  local joints = support.json(support.read(folder .. "/one/summary.json") or "{}").joints or {}
  equal(joints.count, 1, "joints in the summary")
  equal(joints.yielded, 1, "yielded")
  equal(joints.beyond_own_limit, 0, "none is beyond its capacity")
  local first = joints.largest and joints.largest[1] or {}
  equal(first.joint, "joint at end a of member 1", "the one that has come furthest")
  near(first.largest_rotation or 0, 0.07, 1e-6, "its rotation")
  near(first.ratio or 0, 0.7, 1e-5, "of its capacity")
  local picture = {}
  for _, name in ipairs { "with", "without", "near", "far" } do
    picture[name] = drawn and support.read(("%s/one/%s.png"):format(folder, name)) or name
  end
  for one, other in pairs { with = "without", near = "far", without = "near" } do
    expect(picture[one] ~= picture[other], "the pictures %s and %s are alike", one, other)
  end
end)

-- hinge.robustness ----------------------------------------------------------------------------------------------------

local steel = hinge.material.steel "S355"
local post, girder = hinge.section.named "HEB 240", hinge.section.named "IPE 360"
local span, height, g = 6, 3.5, 9.80665

-- A portal of two bays whose beams have joints; its middle column, member 2, may be removed. how: joint, q (N/m),
-- up, elements, panel (joints between nodes, in the place of the members'), release, extra (of the model, at its end).
local function portal(how, scale)
  local model, heads, beams = hinge.model {}, {}, {}
  for i = 1, 3 do
    local foot = model:node { span * (i - 1), 0, 0 }
    heads[i] = model:node { span * (i - 1), 0, height }
    model:fix(foot)
    model:fix(heads[i], "y,rx,rz")
    model:member { foot, heads[i], section = post, material = steel, up = { 1, 0, 0 }, group = "columns" }
  end
  local floor = steel:with { density = how.q * (scale and scale(span, 0, height) or 1) / g / girder.area }
  for i = 1, 2 do
    local a, b = heads[i], heads[i + 1]
    local ends = how.joint and { a = how.joint, b = how.joint } or nil
    if how.panel and i == 1 then
      a = model:node { 0, 0, height }
      model:joint { heads[1], a, joint = how.panel }
    elseif how.panel then
      b = model:node { 2 * span, 0, height }
      model:joint { heads[3], b, joint = how.panel }
    end
    beams[i] = model:member { a, b, section = girder, material = floor, up = how.up or { 0, 0, 1 }, group = "beams",
      elements = how.elements, ends = ends, release = how.release }
  end
  if how.extra then how.extra(model, heads) end
  model:gravity { 0, 0, -g }
  return model, beams
end

local function loss(how, options)
  return hinge.robustness(with({ build = function(o) return (portal(how, o.scale)) end, remove = { 2 }, m = 2,
    quiet = true, procedures = { "nonlinear dynamic" }, dt = 1e-3, allow_failed = true }, options)).rows
end

local all_three = { "nonlinear dynamic", "nonlinear static", "linear static" }
local semi_rigid = hinge.joint { Mx = { stiffness = 60e6, strength = 150e3 } }

case("a frame does not hold where a joint turns beyond the limit, whatever the joint is", function()
  local kinds = {
    { "strength", { joint = semi_rigid, q = 12e3 } },
    { "four elements a member", { joint = semi_rigid, q = 12e3, elements = 4 } },
    { "elastic", { joint = hinge.joint { Mx = { stiffness = 5e6 } }, q = 2e3 } },
    { "curve", { joint = hinge.joint { Mx = { points = { { 2e-3, 1e5 }, { 0.04, 2e5 } } } }, q = 12e3 } },
    { "weak axis", { joint = hinge.joint { My = { stiffness = 5e6, strength = 20e3 } }, q = 1.5e3, up = { 0, 1, 0 } } },
    { "between nodes", { panel = hinge.joint { My = { stiffness = 20e6, strength = 80e3 } }, q = 9e3 } },
  }
  for _, kind in ipairs(kinds) do
    local name, how = kind[1], kind[2]
    local row = loss(how, { limit = 1 })[1]
    equal(row.verdict, "holds", name .. ": " .. row.reason)
    expect(row.joint_rotation > 1e-3, "%s: joints turn by %g rad", name, row.joint_rotation)
    equal(row.beam_rotation, row.joint_rotation, name .. ": they count with the beams")
    local function verdict(part) return loss(how, { limit = part * row.joint_rotation })[1] end
    local beyond, below = verdict(0.99), verdict(1.01)
    equal(beyond.verdict, "exceeds the limit of rotation", name)
    near(beyond.ratio, 1 / 0.99, 1e-9, name .. ": of the limit")
    expect(beyond.reason:find "^the joint " ~= nil, "%s: says %s", name, beyond.reason)
    equal(below.verdict, "holds", name .. ", below the limit")
    local none = loss(how, { limit = { columns = 1 } })[1]
    equal(none.verdict, "not rated", name .. ", without a limit")
    expect(none.joints_unrated > 0, "%s: %d joints are not rated", name, none.joints_unrated)
  end
end)

case("the rotation of joints in a row is that of a run by hand", function()
  local how = { joint = semi_rigid, q = 12e3 }
  local row = loss(how, { limit = 1 })[1]
  local model, beams = portal(how)
  local rest = model:static { steps = 10 }:finish()
  model:remove { member = model:members()[2], at = 0 }
  local run, largest = model:dynamic { from = rest, dt = 1e-3, duration = 3 }, 0
  while run.time < row.followed - 1e-9 and run:step() do
    for _, beam in ipairs(beams) do
      for _, side in ipairs { "a", "b" } do
        largest = support.largest_of(largest, math.abs(beam:joint(side, run).rotation_x))
      end
    end
  end
  near(row.joint_rotation, largest, 1e-12, "rotation, rad")
  near(run:hinges().worst.demand, largest, 1e-12, "and that of run:hinges")
end)

case("joints that break are no frame that holds, and each row has the warnings of its own runs alone", function()
  -- a second pair of beams, whose outer ends break; they stand on as cantilevers
  local function extra(model, heads)
    local high = model:node { 0, 0, height + 1 }
    model:fix(high, "y,rx,rz")
    model:member { heads[1], high, section = post, material = steel, up = { 1, 0, 0 } }
    model:member { high, heads[2], section = girder, material = steel, up = { 0, 0, 1 },
      ends = { a = hinge.joint { Mx = { stiffness = 50e6, capacity = 5e-4 } } } }
  end
  local rows = loss({ q = 12e3, extra = extra }, { limit = 1, procedures = all_three })
  equal(rows[1].verdict, "loses joints", rows[1].reason)
  equal(rows[1].joints_broken, 1, "joints that broke")
  expect(support.has(rows[1].reason, "1 joint breaks, the joint at end a of member 7"), "says %s", rows[1].reason)
  expect(rows[2].verdict ~= "holds", "statics breaks none, and it is beyond its capacity: %s", rows[2].verdict)
  equal(rows[3].verdict, "exceeds the limit of rotation", "linear statics: " .. rows[3].reason)
  local function says(row) return support.has(table.concat(row.warnings, "\n"), "statics breaks no joint") end
  expect(not says(rows[1]), "a run of statics warns in the row of dynamics: %s", table.concat(rows[1].warnings, "; "))
  expect(says(rows[2]), "the push warns in its own row: %s", table.concat(rows[2].warnings, "; "))
end)

case("a frame that a connector holds is not said to hold where the connector breaks", function()
  local function rows(capacity)
    local function hanger(model, heads) -- above the column that goes
      model:connector { heads[2], ground = true, stiffness = { z = 2e7 }, capacity = { z = capacity } }
    end
    return loss({ q = 10e3, extra = hanger }, { limit = 0.05, damping = 0.02, omega_n = 1.2, procedures = all_three })
  end
  for _, row in ipairs(rows(1e9)) do
    equal(row.verdict, "holds", row.procedure .. " with a strong hanger: " .. row.reason)
  end
  local weak = rows(40e3) -- half of two beams' weight is 60 kN
  for i, wanted in ipairs { { "loses joints", "connector 1 between the ground and node 4" },
    { "exceeds the capacity", "force along z at which it breaks" }, { "exceeds the capacity", "" } } do
    local row = weak[i]
    equal(row.verdict, wanted[1], row.procedure .. ": " .. row.reason)
    expect(row.reason:find(wanted[2], 1, true), "reason: %s", row.reason)
  end
end)

case("linear statics compares a joint's moment with its strength, and an elastic joint by its rotation", function()
  local row = loss({ joint = semi_rigid, q = 12e3 }, { limit = 1, procedures = { "linear static" } })[1]
  equal(row.loads_scaled, "next to the removal", "loads")
  local model, beams = portal({ joint = semi_rigid, q = 12e3 }, function() return row.omega end)
  model:remove { member = model:members()[2], at = 0 }
  local gone = model:dynamic { dt = 1e-6, duration = 1e-6, step_control = 0, energy_tolerance = 0 }:finish()
  local run = model:static { from = gone, steps = 10000 }
  run:step()
  local M = 0
  for _, beam in ipairs(beams) do
    for _, side in ipairs { "a", "b" } do M = support.largest_of(M, math.abs(beam:joint(side, run).Mx)) end
  end
  run:stop()
  near(row.dcr, M / run.factor / 150e3, 1e-9, "DCR") -- the same steps
  equal(row.joint_dcr, row.dcr, "it is that of the joint")
  equal(row.verdict, "exceeds the capacity", row.reason)
  expect(row.reason:find "^the joint at end %a of member %d has a DCR of", "says %s", row.reason)

  local elastic_joint = hinge.joint { Mx = { stiffness = 5e6 } }
  local function linear(limit)
    return loss({ joint = elastic_joint, q = 2e3 }, { limit = limit, procedures = { "linear static" } })[1]
  end
  local free = linear(1)
  equal(free.verdict, "holds", free.reason)
  equal(linear(0.99 * free.joint_ratio).verdict, "exceeds the limit of rotation", "beyond the limit")
  equal(linear(1.01 * free.joint_ratio).verdict, "holds", "below the limit")
  equal(linear { columns = 1 }.verdict, "not rated", "without a limit")
end)

case("pins of a frame that holds are told, for no limit is theirs", function()
  local row = loss({ q = 1e3, release = { a = "Mx" } }, { limit = 1 })[1]
  equal(row.verdict, "holds", row.reason)
  expect(support.has(row.reason, "2 pins, which turn by up to"), "says %s", row.reason)
end)

return checks.done()

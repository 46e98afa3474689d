-- hinge.robustness: the loss of a column against runs that this file makes by hand, a two-beam mechanism against closed
-- forms of statics and dynamics, verdicts of runs that fail, criteria of one's own, files, and wrong input.
--
-- Run: lua5.4 tests/script/robustness/robustness_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local robustness = require "hinge.robustness"
local checks = support.checks "robustness"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local frames, with = require "robustness.frames", require "scenes".with
local g, fy, E, L, box, post, Mp = frames.g, frames.fy, frames.E, frames.L, frames.box, frames.post, frames.Mp
local flexibility, R = frames.flexibility, frames.R

-- The row of a case and a procedure.
local function row_of(result, number, procedure)
  for _, row in ipairs(result.rows) do
    if row.case == number and row.procedure == procedure then return row end
  end
  error(("no row of case %d, %s"):format(number, procedure))
end

-- A plane frame -------------------------------------------------------------------------------------------------------

local span, height, spans = 6, 4, 2
-- Two storeys on three columns, with w N/m on the beams as mass; the columns weigh as good as nothing.
local function frame(w, without_middle)
  local model = hinge.model {}
  local floor = hinge.material { E = E, density = w / g / box.area, yield_stress = fy }
  local light, at = frames.light(), {}
  for i = 0, spans do
    at[i] = {}
    for level = 0, 2 do
      local lost = i == 1 and level == 1
      if not (without_middle and i == 1 and level == 0) then
        at[i][level] = model:node { i * span, 0, level * height }
        model:fix(at[i][level], level == 0 and "all" or "y,rx,rz")
      end
      if level > 0 and not (lost and without_middle) then
        model:member { at[i][level - 1], at[i][level], section = post, material = light, up = { 1, 0, 0 },
          group = lost and "lost" or "posts" }
      end
      if level > 0 and i > 0 then
        model:member { at[i - 1][level], at[i][level], section = box, material = floor, up = { 0, 0, 1 },
          group = "beams" }
      end
    end
  end
  model:gravity { 0, 0, -g }
  return model, at[1][1]
end

local function z(node, run) return (select(3, node:displacement(run))) end

-- The loss of the middle column as a user would write it, for as long as the study has followed it.
local function by_hand(w, row)
  local model, above = frame(w)
  local rest = model:static { steps = 10 }:finish()
  model:remove { group = "lost", at = 0 }
  local run = model:dynamic { from = rest, dt = 2e-3, duration = 2 }
  local deepest = 0
  while run.time < row.followed - 1e-9 and run:step() do
    deepest = support.largest_of(deepest, z(above, rest) - z(above, run))
  end
  local beam, column = 0, 0
  for _, h in ipairs(run:hinges()) do
    if h.group == "beams" then beam = support.largest_of(beam, h.demand) end
    if h.group == "posts" then column = support.largest_of(column, h.demand) end
  end
  return { deepest = deepest, beam = beam, column = column, rest = z(above, rest) }
end

local function study(w, options)
  return robustness(with({ build = function() return frame(w) end, remove = { "lost" }, limit = 0.04, dt = 2e-3,
    quiet = true }, options))
end

case("the loss of a column that the frame holds has the numbers of a run by hand", function()
  local w = 20e3
  local result = study(w, { procedures = { "nonlinear dynamic", "nonlinear static" } })
  local row = row_of(result, 1, "nonlinear dynamic")
  local hand = by_hand(w, row)
  equal(row.verdict, "holds", row.reason)
  near(row.deflection, hand.deepest, 1e-12, "deflection, m")
  near(row.beam_rotation, hand.beam, 1e-12, "rotation of beams, rad")
  equal(row.column_rotation, hand.column, "rotation of columns")
  expect(hand.beam > 1e-3, "beams yield: %g rad", hand.beam)
  near(row.ratio, hand.beam / 0.04, 1e-9, "of the limit")
  expect(row.followed > row.time + 0.99 * row.period, "followed to %g s, deepest at %g s", row.followed, row.time)
  equal(row.run_verdict, "stopped", "the run's own verdict: it is stopped when the joint has turned")
  expect(row.energy_error ~= 0 and math.abs(row.energy_error) < 1e-3, "energy error %g", row.energy_error)
  -- a frame that never had the column
  local bare, above = frame(w, true)
  local sag = -z(above, bare:static { steps = 10, to_limit = true }:finish())
  near(row.static_deflection, sag + hand.rest, 1e-6, "static deflection, m") -- a light column
  near(row.increase, row.deflection / row.static_deflection, 1e-12, "increase")
  equal(row.broken, 0, "no other member breaks")
  -- statics up to Omega_N times the loads, by hand on the bare frame
  local pushed = row_of(result, 1, "nonlinear static")
  local heavy, joint = frame(w * pushed.omega, true)
  local at_load = heavy:static { steps = 40, to_limit = true }:finish()
  equal(at_load.limit, false, "the frame carries Omega_N times the loads")
  near(pushed.deflection, -z(joint, at_load), 0.01 * pushed.deflection, "deflection under them, m") -- between steps
  local worst = at_load:hinges { limit = 0.04 }.worst
  near(pushed.ratio, worst.ratio, 0.02, "rotation under them, of its limit")
  equal(pushed.verdict, "holds", pushed.reason)
  equal(pushed.loads_scaled, "all", "build did not use scale")
end)

case("the loss of a column that the frame does not hold is a collapse in dynamics and statics", function()
  local w = 35e3
  local result = study(w, { procedures = { "nonlinear dynamic", "nonlinear static" } })
  local row = row_of(result, 1, "nonlinear dynamic")
  equal(row.verdict, "collapses", row.reason)
  near(row.deflection, by_hand(w, row).deepest, 1e-12, "it has fallen by, m")
  near(row.fall, 0.6, 1e-12, "a tenth of the span, m")
  expect(row.deflection > 0.6, "fall %g m", row.deflection)
  equal(row.increase, nil, "no factor")
  local run = frame(w, true):static { steps = 40, to_limit = true }:finish()
  equal(run.limit, true, "statics by hand has a limit load")
  near(row.static_limit, run.factor, 1e-4, "limit load factor") -- bisection by hand
  local pushed = row_of(result, 1, "nonlinear static")
  near(pushed.load_factor, run.factor, 1e-4, "limit load factor of nonlinear statics")
  equal(pushed.verdict, "collapses", pushed.reason)
  equal(result.counts["nonlinear static"].collapses, 1, "counted")
end)

case("a limit that is exceeded is told, with the member", function()
  local row = study(20e3, { limit = { beams = { LS = 0.002, CP = 0.01 } },
    procedures = { "nonlinear dynamic" } }).rows[1]
  equal(row.verdict, "exceeds the limit of rotation", row.reason)
  equal(row.limit, 0.01, "the largest level counts")
  expect(row.ratio > 1 and row.reason:find("^member %d+ has [%d.]+ of its limit 0.01 rad$"), "says: %s", row.reason)
end)

-- Two beams and a column ----------------------------------------------------------------------------------------------

local P = 150e3
local function mechanism(how, scale)
  return (frames.mechanism(with({ P = P, mass = true, posts = true }, how), scale))
end

local function of_mechanism(options, how)
  return (robustness(with({ build = function(o) return mechanism(how, o.scale) end, remove = { 3 }, limit = 0.06,
    quiet = true, fall = 0.8 }, options)))
end

case("statics of a two-beam mechanism: limit load 4 M_p / L, Omega_N, DCR of P L / 4", function()
  local omega = 1.08 + 0.76 / (0.06 * 6 * E * box.Ix / (Mp * L) + 0.83)
  for _, scaled in ipairs { false, true } do
    local result = of_mechanism({ procedures = { "nonlinear static", "linear static" }, m = 3 }, { scaled = scaled })
    local row = row_of(result, 1, "nonlinear static")
    near(row.omega, omega, 1e-12, "Omega_N")
    near(row.load_factor, R / P, 1e-5, "limit load")
    equal(row.loads_scaled, scaled and "next to the removal" or "all", "which loads")
    local linear = row_of(result, 1, "linear static")
    near(linear.omega, 3.8, 1e-12, "Omega_LD")
    near(linear.dcr, 3.8 * P * L / 4 / Mp, 1e-4, "DCR")
    near(linear.deflection, 3.8 * P * flexibility, 1e-4 * linear.deflection, "elastic deflection, m")
    equal(linear.verdict, "holds", linear.reason)
  end
end)

case("dynamics of a two-beam mechanism that yields: u_y / 2 (1 - P / R)", function()
  local row = of_mechanism { procedures = { "nonlinear dynamic" } }.rows[1]
  local u_y = R * flexibility
  local u = u_y / (2 * (1 - P / R))
  expect(P > R / 2 and P < R, "it yields and holds: P = %g R", P / R)
  near(row.deflection, u, 0.005 * u, "deflection, m")
  near(row.beam_rotation, (u - u_y) / L, 0.01 * (u - u_y) / L, "plastic rotation, rad")
  equal(row.verdict, "holds", row.reason)
end)

case("the factors of `loads` act on load cases", function()
  local row = of_mechanism({ loads = { dead = 1.2 }, procedures = { "nonlinear static" } }, { mass = false }).rows[1]
  near(1.2 * row.load_factor, R / P, 1e-5, "limit load over P")
end)

case("an irregular structure, and more than ten storeys by GSA: linear statics is not allowed", function()
  local row = of_mechanism { procedures = { "linear static" }, m = 3, irregular = true }.rows[1]
  expect(row.dcr > 2, "DCR %g", row.dcr)
  equal(row.verdict, "not allowed", row.reason)
  local function tower()
    local model = mechanism()
    local at, light = model:node { 3 * L, 0, 0 }, frames.light()
    model:fix(at, "all")
    for i = 1, 11 do
      local up, beside = model:node { 3 * L, 0, 3 * i }, model:node { 3 * L + 1, 0, 3 * i }
      model:member { at, up, section = post, material = light }
      model:member { up, beside, section = box, material = light }
      at = up
    end
    return model
  end
  for criterion, wanted in pairs { GSA = "not allowed", ["UFC 4-023-03"] = "holds" } do
    local result = robustness { build = tower, remove = { 3 }, procedures = { "linear static" }, m = 3, quiet = true,
      criterion = criterion }
    equal(result.rows[1].verdict, wanted, criterion .. ": " .. result.rows[1].reason)
  end
end)

-- Verdicts ------------------------------------------------------------------------------------------------------------

case("a run that fails is never one that holds, and a criterion is not asked of it", function()
  local asked = 0
  local function criterion(row)
    asked = asked + 1
    return row.verdict == "holds" and "fine" or "bad", "for a reason"
  end
  local own = { procedures = { "nonlinear dynamic" }, criterion = criterion, allow_failed = true }
  local short = of_mechanism(with(own, { duration = 0.05 })).rows[1]
  equal(short.verdict, "failed", "too short a run: " .. short.reason)
  expect(short.reason:find("give a longer duration", 1, true), "says: %s", short.reason)
  equal(asked, 0, "not asked of a failed run")
  checks.refused("1 of 1 rows failed", of_mechanism, { procedures = { "nonlinear dynamic" }, duration = 0.05 })
  -- the intact frame cannot carry its loads
  local heavy = study(200e3, own).rows[1]
  equal(heavy.verdict, "failed", "statics fails before the removal: " .. heavy.reason)
  expect(#(heavy.reason:match "^statics before the removal: (.*)$" or "") > #"failed", "with the reason of the run: %s",
    heavy.reason)
  -- a step that is too long to follow the joint: without the refusal it would seem not to move
  local coarse = study(20e3, with(own, { dt = 0.1 })).rows[1]
  equal(coarse.verdict, "failed", "a long step: " .. coarse.reason)
  expect(coarse.reason:find("dt = 0.1 s is too long; the period of the joint is about 0.5", 1, true), "says: %s",
    coarse.reason)
  -- the engine gives up: the balance of energy does not close once beams without density to speak of break
  local torn = study(20e3, with(own, { build = function()
    local model, above = frame(20e3)
    model:fracture { group = "beams", curvature_x = 0.01 }
    return model, above
  end })).rows[1]
  equal(torn.run_verdict, "failed", "the run's own verdict")
  equal(torn.verdict, "failed", "the verdict")
  expect(torn.reason:find("^step %d+, t = "), "the reason is the run's: %s", torn.reason)
  asked = 0
  local held = of_mechanism(own).rows[1]
  equal(held.verdict, "fine", "its verdict")
  equal(held.reason, "for a reason", "its reason")
  equal(asked, 1, "asked once")
end)

case("members that break on the way are told", function()
  local function build()
    local model = mechanism()
    local top = model:node { L, 0, 5 }
    model:fix(top, "all")
    model:member { model:nodes()[2], top, section = hinge.section.round { diameter = 0.01 }, group = "hanger",
      material = hinge.material { E = E, density = 7850, yield_stress = fy } }
    model:fracture { group = "hanger", axial_strain = 0.005 }
    return model
  end
  local row = robustness { build = build, remove = { 3 }, limit = 0.1, fall = 0.8, quiet = true,
    procedures = { "nonlinear dynamic" } }.rows[1]
  equal(row.broken, 1, "broken")
  equal(row.verdict, "loses members", row.reason)
  equal(row.reason, "1 further member breaks", "says")
end)

-- Files and text ------------------------------------------------------------------------------------------------------

case("table, markdown, csv, picture, report and progress", function()
  local folder = support.temporary_folder()
  support.write(folder .. "/scene.lua", [[
    local hinge, robustness = require "hinge", require "hinge.robustness"
    local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 325e6 }
    local box = hinge.section.box { width = 0.15, depth = 0.3, thickness = 0.01 }
    local result = robustness { folder = "loss", limit = 0.04, m = 2, build = function()
      local model = hinge.model { displacement = "small" }
      local foot, head = {}, {}
      for i = 1, 3 do
        foot[i], head[i] = model:node { 4 * i, 0, 0 }, model:node { 4 * i, 0, 3 }
        model:fix(foot[i])
        model:fix(head[i], "y,rx,rz")
        model:member { foot[i], head[i], section = box, material = steel }
        if i > 1 then model:member { head[i - 1], head[i], section = box, material = steel } end
      end
      model:gravity { 0, 0, -9.81 }
      return model
    end }
    print(result:table())
    result:csv "own.csv"
    result:picture "own.svg"
  ]])
  local status, printed, told = support.run(("cd %s && lua5.4 scene.lua"):format(support.quote(folder)))
  equal(status, 0, told)
  expect(printed:find "\ncase 2, x = 8 m, y = 0 m, z = 0 to 3 m\n  nonlinear dynamic +%d", "the table:\n%s", printed)
  expect(told:find("hinge.robustness: case 1 of 3, x = 4 m, y = 0 m, z = 0 to 3 m: holds, holds, holds; ", 1, true)
    and told:find " left\n", "progress: %s", told)
  local report = support.read(folder .. "/loss/report.md") or ""
  for _, text in ipairs { "- nonlinear dynamic: holds: 3\n",
    "| 2 | x = 8 m, y = 0 m, z = 0 to 3 m | nonlinear static |", "Omega_LD = 2.9;", "![Verdicts](robustness.png)" } do
    expect(report:find(text, 1, true), "'%s' in the report:\n%s", text, report)
  end
  for _, name in ipairs { "loss/robustness.csv", "loss/own.csv" } do
    local lines = 0
    for _ in (support.read(folder .. "/" .. name) or ""):gmatch "\n" do lines = lines + 1 end
    equal(lines, 10, name .. ": lines")
  end
  for _, name in ipairs { "loss/robustness.png", "loss/own.svg" } do
    expect(#(support.read(folder .. "/" .. name) or "") > 2000, "%s is drawn", name)
  end
end)

-- Wrong input ---------------------------------------------------------------------------------------------------------

case("wrong input is refused at the line of the script", function()
  local function build() return mechanism() end
  for _, r in ipairs {
    { {}, "field 'build' is missing; give a function" },
    { { build = 3 }, "field 'build' is 3; must be a function" },
    { { build = build, limits = 0.1 }, "unknown field 'limits'" },
    { { build = build }, "field 'limit' is missing; give the plastic rotation that is allowed, in rad" },
    { { build = build, criterion = function() return "x" end }, "Omega_N of nonlinear statics follows from it" },
    { { build = build, limit = 0 }, "field 'limit' is 0 rad; must be a number above 0 rad" },
    { { build = build, limit = "beams" }, "field 'limit' is 'beams'; must be a number in rad" },
    { { build = build, limit = { IO = 0.02, CP = 0.01 } }, "which is not above IO" },
    { { build = build, limit = { beam = 0.02 } }, "no group 'beam'" },
    { { build = build, limit = 0.1, criterion = "EN" }, "'criterion' is 'EN'; must be one of UFC 4-023-03, GSA" },
    { { build = build, limit = 0.1, procedures = {} }, "field 'procedures' is a table; must be a list" },
    { { build = build, limit = 0.1, procedures = { "static" } }, "field 'procedures[1]' is 'static'" },
    { { build = build, limit = 0.1, procedures = { "linear static", "linear static" } }, "twice" },
    { { build = build, limit = 0.1, remove = "beams" }, "must be 'columns' or a list of groups and members, such as" },
    { { build = build, limit = 0.1, remove = {} }, "field 'remove' is a table; must be" },
    { { build = build, limit = 0.1, remove = { {} } }, "has an empty list" },
    { { build = build, limit = 0.1, remove = { "beam" } }, "unknown group 'beam'" },
    { { build = build, limit = 0.1, remove = { 9 } }, "has member 9; the model that build returned has 5 members" },
    { { build = build, limit = 0.1, remove = { true } }, "field 'remove' has true" },
    { { build = build, limit = 0.1, storeys = "first" }, "field 'storeys' is 'first'" },
    { { build = build, limit = 0.1, m = 0.5 }, "field 'm' is 0.5; must be a number of at least 1" },
    { { build = build, limit = 0.1, damping = 1 }, "field 'damping' is 1" },
    { { build = build, limit = 0.1, dt = -1 }, "field 'dt' is -1 s" },
    { { build = build, limit = 0.1, folder = "a/b" }, "folder is 'a/b'; must be a plain name" },
    { { build = build, limit = 0.1, loads = { dead = 1 } }, "has no load case" },
    { { build = build, limit = 0.1, loads = 3 }, "field 'loads' is 3" },
    { { build = function() return mechanism { mass = false } end, limit = 0.1 }, "field 'loads' is missing" },
    { { build = function() return 3 end, limit = 0.1 }, "build returned 3; must return the model" },
    { { build = function() return hinge.model { plasticity = false } end, limit = 0.1 }, "has no column" },
    { { build = build, criterion = function() end, procedures = { "linear static" }, remove = { 3 } },
      "the function in field 'criterion' returned nil for case 1" },
  } do
    checks.refused(r[2], function() robustness(with(r[1], { quiet = true })) end)
  end
  checks.refused("options.scale takes x, y and z", function()
    robustness { build = function(o) o.scale(1, 2) end, limit = 0.1 }
  end)
  local calls = 0
  checks.refused("another structure than at its first call", robustness, { limit = 0.1, quiet = true,
    build = function()
      calls = calls + 1
      return calls == 1 and frame(1e3) or mechanism()
    end })
  checks.refused("no further argument", robustness, {}, 1)
  local result = of_mechanism { procedures = { "linear static" } }
  checks.refused("a plain name ending in .csv", result.csv, result, "a/b.csv")
  checks.refused("a plain name ending in .csv", result.csv, result, "b.txt")
  checks.refused("a plain name ending in .pdf", result.picture, result, "b.gif")
  checks.refused("no further argument", result.table, result, 1)
end)

checks.done()

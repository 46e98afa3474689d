-- hinge report: the page of a run, of several, of one without frames; what it holds, that names from a model are text
-- in it, and, in a headless Chromium where one and Node.js are installed, how it works (tests/viewer/page_test.js).
--
-- Run: lua5.4 tests/script/report/report_test.lua BUILD [PICTURE]      PICTURE: where a picture of the page goes
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "report"
local case, ended = checks.case, checks.ended
local quote, expect, equal, near = support.quote, checks.expect, checks.equal, checks.near
local hinge_on, folder, hinge = support.scenes(arg[1])

-- The bar breaks, by limits or by a rule of the script's own.
local scene = require "report.storeys" .. [=[
if how.rule == "own" then
  model:fracture(function(s) return math.abs(s.curvature_y) > 0.3 end)
else
  model:fracture { curvature_x = 0.3, curvature_y = 0.3 }
end
local run = model:dynamic { dt = 2e-5, duration = 0.04 }
run:probe { node = node[1][2], "ux", name = "sway" }
if how.goes_on == "yes" then run:resume "./half.checkpoint" end
for step in run:steps() do
  if step.index % 100 == 0 and how.frames ~= "none" then hinge.frame(run) end
  if step.index == 60 then run:checkpoint "./half.checkpoint" end
end
return { note = "</script><script>window.hurt = 1</script>" }
]=]

local function page(path) return support.read(folder .. "/" .. path) or "" end
local function data_of(text)
  local data = text:match '<script type="application/json" id="data">(.-)</script>'
  return support.json((data:gsub("\\u003c", "<")))
end

assert(hinge_on("run -q", scene, "--out one") == 0, "the scene")
local _, said = hinge "report one"
case("hinge report writes one page and says how large it is", function()
  expect(said:find "^one/report.html: 1 run, 20 frames, %d+%.%d MB\n$", "it says %s", said)
end)

local text = page "one/report.html"
case("the page asks for no other file and nothing from a model ends its data", function()
  expect(#text > 100000 and #text < 1.5e6, "the page has %d bytes", #text)

  -- Nothing from a model ends the element that holds the data, and nothing comes from elsewhere.
  local _, scripts = text:gsub("<script", "")
  local _, ends = text:gsub("</script", "")
  equal(scripts, 2, "script elements")
  equal(ends, 2, "ends of script elements")
  local head = text:match "^(.-)<script type=\"application/json\"" or ""
  expect(not head:find "src=" and not head:find "href=", "the page asks for other files")
  expect(head:find("default-src 'none'", 1, true), "the page does not forbid the network")
  expect(text:find("three.js authors", 1, true), "the licence of three.js is not in the page")
end)

-- The data: what the folder has.
local run = data_of(text).runs[1]
case("the page holds summary, frames, groups and history of the run", function()
  equal(run.name, "one", "name of the run")
  equal(run.summary.verdict, "completed", "verdict in the page")
  equal(run.frames.frames, 20, "frames in the page")
  equal(run.frames.bars, 14, "elements in the page")
  equal(run.frames.groups[2], "<script>window.hurt = 1</script>", "a group")
  equal(run.history.columns[1], "time", "first column of the history")
  equal(run.history.columns[#run.history.columns], "sway", "last column of the history")
  near(run.history.values[1][#run.history.values[1]], 0.04, 1e-9, "end of the history")
end)

case("units of probes stand beside the history, in the summary and in a plot", function()
  for what, list in pairs { ["in the page"] = run.probes, ["in summary.json"] = run.summary.probes,
    ["in probes.json"] = support.json(page "one/probes.json") } do
    equal(#list, 1, "probes " .. what)
    local p = list[1] or {}
    equal(("%s %s %s %s"):format(p.name, p.node, p.quantity, p.unit), "sway 6 ux m", "a probe " .. what)
  end
  ended(0, "", hinge "-e 'hinge.plot(\"one\", \"sway.svg\")'")
  expect(page "sway.svg":find(">sway, mm<", 1, true), "the plot of a folder")
  near(run.summary.model.mass, 7850 * (20 * (0.15 ^ 2 - 0.138 ^ 2) + 0.6 * 0.1 ^ 2), 1e-6, "total mass, kg")
end)

case("events.csv is in order, and each break has its cause", function()
  local columns = table.concat(run.events.columns, ",")
  equal(columns, "time,event,element,member,end,group,limit,strain,of,rule,joint", "columns of events.csv")
  local first, last, broke = {}, -math.huge, nil
  for _, row in ipairs(run.events.rows) do
    local time = tonumber(row[1])
    expect(time >= last, "events.csv is not in order: %s after %s", row[1], last)
    last = time
    first[row[2]] = first[row[2]] or row
    if row[2] == "fracture" then broke = row end
  end
  expect(first.contact and first.yield and broke, "contact, yield and fracture are not all told of")
  equal(first.contact[4], "1", "the member that is first in contact")
  equal(broke[4], "7", "the member that breaks")
  equal(broke[6], '<img src=x onerror=window.hurt=1>, "quoted"', "its group")
  expect(broke[7] == "curvature_x" or broke[7] == "curvature_y", "it breaks by %s", broke[7])
  expect(math.abs(tonumber(broke[8])) >= 0.3 and math.abs(tonumber(broke[8])) < 1, "at a curvature of %s", broke[8])
  near(tonumber(broke[9]), 0.3, 1e-12, "its limit")
  equal(broke[10], "scene.lua:27", "the rule's line")
  local projectiles = run.summary.damage[3]
  equal(projectiles.members, 1, "members of the third group")
  equal(projectiles.broken, 1, "broken ones of the third group")
  equal(projectiles.touched, 1, "ones of the third group that were in contact")
end)

case("a run that goes on from a checkpoint tells the events before it too", function()
  -- A run that goes on from a checkpoint tells of what happened before it, too; a rule of the script's own is named.
  equal(hinge_on("run -q", scene, "goes_on=yes --out second_half"), 0, "the second half")
  expect(page "one/events.csv" ~= "", "events.csv is empty")
  equal(page "second_half/events.csv", page "one/events.csv", "events of the run that went on")
  equal(hinge_on("run -q", scene, "rule=own --out own"), 0, "a rule of its own")
  expect(page "own/events.csv":find('fracture,13,7,2,[^\n]*,rule,,,"scene.lua:25",\n'), "a rule of its own: %s",
    page "own/events.csv")
end)

case("contact, yield and fracture of one step are told in this order", function()
  -- What happens in one step is told in the order in which it comes about: contact, then yield, then fracture.
  equal(hinge_on("run -q", [[
local hinge = require "hinge"
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
local model = hinge.model { interaction = "paper" }
local held = { model:node { 0, 0, 0 }, model:node { 1, 0, 0 } }
model:fix(held)
model:member { held[1], held[2], section = bar, material = steel }
model:member { model:node { 0.5, -0.5, 0.06 }, model:node { 0.5, 0.5, 0.06 }, section = bar, material = steel,
  group = "flying" }
model:velocity("flying", { 0, 0, -70 })
model:contact {}
model:fracture { curvature_x = 0.01, curvature_y = 0.01 }
model:dynamic { dt = 1e-3, duration = 1e-3, step_control = 0, energy_tolerance = 1e9 }:finish()
]], "--out at_once"), 0, "all in one step")
  local order = {}
  for time, what in page "at_once/events.csv":gmatch "\n([%d.e-]+),(%l+)," do
    equal(tonumber(time), 1e-3, "time of " .. what)
    if order[#order] ~= what then order[#order + 1] = what end
  end
  equal(table.concat(order, ", "), "contact, yield, fracture", "the order in one step")
end)

case("several runs go on one page, with frames or without", function()
  ended(0, "", hinge_on("run -q", scene, "frames=none --out two"))
  ended(0, "both.html: 2 runs, 20 frames", hinge "report one two/ --out both.html")
  local both = data_of(page "both.html").runs
  equal(both[2].name, "two", "name of the second run")
  equal(both[2].frames, nil, "frames of the second run")
  equal(both[2].summary.damage[1].yielded, both[1].summary.damage[1].yielded, "damage without frames")
  ended(0, "no frames, so nothing to look at in 3D", hinge "report two")
  ended(2, "no run was written to nowhere", hinge "report nowhere")
end)

case("of a long history the page has at most 1500 rows and the last one", function()
  -- rows that are alike far apart, and the last one, whether it is among them or not
  for rows, kept in pairs { [1500] = 1500, [1501] = 751, [4000] = 1334, [4001] = 1335 } do
    local lines = { "time [s],kinetic [J]" }
    for i = 1, rows do lines[i + 1] = ("%d,%d"):format(i, 10 * i) end
    support.write(folder .. "/two/history.csv", table.concat(lines, "\n") .. "\n")
    equal(hinge "report two --out long.html", 0, rows .. " rows")
    local time, kinetic = table.unpack(data_of(page "long.html").runs[1].history.values)
    equal(#time, kept, "rows in the page of " .. rows)
    equal(time[1], 1, "the first of " .. rows)
    equal(time[2] - time[1], time[kept - 1] - time[kept - 2], "apart, of " .. rows)
    equal(time[kept], rows, "the last of " .. rows)
    equal(kinetic[kept], 10 * rows, "the last value of " .. rows)
  end
end)

case("frames that cannot be read are named and left out", function()
  os.execute(("cd %s && cp -r one damaged"):format(quote(folder)))
  local files = {}
  for file in page "damaged/frames.pvd":gmatch 'file="([^"]*)"' do files[#files + 1] = file end
  local function cut(file) support.write(folder .. "/damaged/" .. file, page("damaged/" .. file):sub(1, 900)) end
  cut(files[3])
  os.remove(folder .. "/damaged/" .. files[5])
  support.write(folder .. "/damaged/history.csv", (page "one/history.csv":match "^[^\n]*\n[^\n]*\n")) -- one row
  local printed, complaint = ended(1, "", hinge "report damaged")
  expect(printed:find "^damaged/report.html: 1 run, 18 frames", "a page without some frames: %s", printed)
  for _, i in ipairs { 3, 5 } do
    expect(complaint:find("hinge: not in the page: [^\n]*damaged/" .. files[i]:gsub("%p", "%%%0")),
      "%s is not named: %s",
      files[i], complaint)
  end
  equal(select(2, complaint:gsub("\n", "\n")), 2, "lines about damaged frames: " .. complaint)
  local damaged = data_of(page "damaged/report.html").runs[1]
  equal(damaged.frames.frames, 18, "frames that are whole")
  equal(#damaged.damaged, 2, "frames that are damaged")
  equal(damaged.damaged[1].file, "damaged/" .. files[3], "the first that is damaged")
  for _, file in ipairs(files) do cut(file) end
  printed = ended(1, "hinge: not in the page: 12 more frames\n", hinge "report damaged --out none.html")
  expect(printed:find "^none.html: 1 run, 0 frames" and not printed:find "a script asks for them",
    "no frame that is whole: %s", printed)
  equal(data_of(page "none.html").runs[1].frames, nil, "frames where all are damaged")
end)

-- A frame of two storeys of which a column is lost before the first frame; beams of the second bay are held by
-- connectors. A node that no member uses makes a warning.
local storeys = [=[
local hinge = require "hinge"
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local tube = hinge.section.box { width = 0.15, depth = 0.15, thickness = 0.006 }
local model = hinge.model { interaction = "paper" }
local node = {}
local function member(a, b, group) model:member { a, b, section = tube, material = steel, group = group } end
for i = 0, 2 do
  node[i] = {}
  for k = 0, 2 do node[i][k] = model:node { 4 * i, 0, 3 * k } end
  model:fix(node[i][0])
  for k = 1, 2 do
    member(node[i][k - 1], node[i][k], i == 1 and k == 1 and "lost" or "columns")
    if i == 1 then member(node[0][k], node[1][k], "beams") end
    if i == 2 then
      local a, b = model:node { 4, 0, 3 * k }, model:node { 8, 0, 3 * k }
      member(a, b, "beams")
      for _, ends in ipairs { { node[1][k], a }, { node[2][k], b } } do
        model:connector { ends[1], ends[2], stiffness = { x = 1e9, y = 1e9, z = 1e9, rx = 1e7, rz = 1e7 } }
      end
    end
  end
end
model:node { 9, 9, 9 }
model:gravity { 0, 0, -9.81 }
model:fracture { group = "lost", where = "all", rule = function(section) return section.time >= 1e-4 end }
local run = model:dynamic { dt = 1e-4, duration = 2e-3 }
for step in run:steps() do
  if step.index % 5 == 0 then hinge.frame(run) end
end
]=]
assert(hinge_on("run -q", storeys, "--out storeys") == 0, "the frame that loses a column")
-- What hinge run --within adds to the summary of a run.
local function add_accuracy(to, members)
  local summary = page(to .. "/summary.json"):gsub("}%s*$", ([[, "accuracy": { "conclusion": "within 10 %%: dt 20 us",
    "line": "asked 10 %%, estimated 6 %%, cost 4 s", "effort": "7 runs", "reached": true, "notes": ["sway is chaotic"],
    "answers": { "sway": { "chaotic": true, "value": 11, "mean": 12.3456, "scatter": 1.5, "runs": 5, "error": 0.06,
      "error_text": "6 %%", "basis": "5 runs, mean 12.35, scatter 1.5" } },
    "broken": { "runs": 5, "of_runs": "with small changes", "members": MEMBERS, "in_all": 1, "in_some": 2, "in_none": 4,
      "list": [{ "member": 1, "group": "columns", "broken": 1 }, { "member": 4, "group": "columns", "broken": 3 },
        { "member": 7, "group": "<b>", "broken": 5 }] } } }]]):gsub("%%%%", "%%%%"):gsub("MEMBERS", members))
  support.write(("%s/%s/summary.json"):format(folder, to), summary)
end

case("the picture of hinge run --within is in the page, and not that of an earlier call", function()
  os.execute(("cd %s && cp -r one accurate"):format(quote(folder)))
  support.write(folder .. "/accurate/accuracy.png", "\x89PNG\0")
  ended(0, "1 run, 20 frames", hinge "report accurate")
  equal(data_of(page "accurate/report.html").runs[1].accuracy_picture, nil, "picture of a run without accuracy")
  add_accuracy("accurate", 7)
  ended(0, "1 run, 20 frames", hinge "report accurate")
  equal(data_of(page "accurate/report.html").runs[1].accuracy_picture, "data:image/png;base64,iVBORwA=", "picture")
end)

case("a column that is lost before the first frame is broken in the summary of the page", function()
  add_accuracy("storeys", 99) -- of another model
  ended(0, "1 run, 4 frames", hinge "report storeys")
  local lost = data_of(page "storeys/report.html").runs[1]
  equal(lost.summary.damage[2].broken, 1, "broken ones of the group that is lost")
end)

case("the page shows diagrams, lost columns and pictures in a browser", function()
  -- Beams clamped at one end and pinned at the other, one under a spread load, one under a load at a point.
  local diagrams = [=[
local hinge = require "hinge"
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local h = hinge.section.h { depth = 0.3, width = 0.15, web = 0.007, flange = 0.01 }
local model = hinge.model { interaction = "paper" }
local function beam(y, load)
  local a, b = model:node { 0, y, 0 }, model:node { 6, y, 0 }
  model:fix(a)
  model:fix(b, "xyz,rx,rz")
  load.member = model:member { a, b, section = h, material = steel }
  model:load(load)
  return b
end
beam(0, { q = { 0, 0, -10e3 } })
beam(3, { force = { 0, 0, -1e3 }, at = 0.2 })
model:load { node = beam(6, { q = { 0, 0, -10e3 } }), moment = { 0, 20e3, 0 } }
local run = model:static { steps = 2 }
for _ in run:steps() do hinge.frame(run) end
]=]
  ended(0, "", hinge_on("run -q", diagrams, "--out diagrams"))
  ended(0, "1 run, 2 frames", hinge "report diagrams")
  -- A panel that is pulled, one that is pressed, a triangle.
  local panels = [=[
local hinge = require "hinge"
local model = hinge.model { displacement = "small" }
local steel = hinge.material { E = 2e11, nu = 0.3, density = 7850 }
local function pulled(y, force, o, corners)
  local at = {}
  for i, c in ipairs { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 0, 1 } } do
    if i <= corners then at[i] = model:node { c[1], y + c[2], 0 } end
  end
  for i, node in ipairs(at) do o[i] = node end
  model:panel(o)
  for i, node in ipairs(at) do
    model:fix(node, (i == 1 or i == 4) and "xyz" or "yz")
    if i == 2 or i == 3 then model:load { node = node, force = { force, 0, 0 } } end
  end
end
pulled(0, 1e5, { thickness = 0.01, material = steel, bending = false }, 4)
pulled(2, -4e5, { thickness = 0.01, material = steel, bending = false }, 4)
pulled(4, 1e3, { thickness = 0.01, material = steel }, 3)
local run = model:static { steps = 2 }
hinge.frame(run)
for _ in run:steps() do hinge.frame(run) end
]=]
  ended(0, "", hinge_on("run -q", panels, "--out panels"))
  ended(0, "1 run, 3 frames", hinge "report panels")
  local look = support.browser "report"
  local function shows(least, test, ...)
    local seen = ended(0, "checked", look(test, ...))
    expect((tonumber(seen:match "(%d+) checked") or 0) > least, "%s: %s", test, seen)
  end
  if look then
    local function of(name) return folder .. "/" .. name .. "/report.html" end
    shows(40, "page_test.js", of "one", of "damaged", arg[2])
    shows(20, "words_test.js", of "one", of "storeys", of "diagrams", of "accurate")
    shows(55, "player_test.js", of "one", of "diagrams", of "panels")
  end
end)

case("the table at the end of a run has all accounts of the balance", function()
  local scene_text = [[
local hinge = require "hinge"
local steel = hinge.material { E = 2e11, density = 7850, yield_stress = 235e6 }
local model, bar = hinge.model(), hinge.section.solid { width = 0.1, depth = 0.1 }
local a, b, c = model:node { 0, 0, 1.5 }, model:node { 1.5, 0, 1.5 }, model:node { 3, 0, 1.5 }
model:fix(a)
model:member { a, b, section = bar, material = steel, group = "bars" }
model:member { b, c, section = bar, material = steel, group = "bars",
  ends = { a = hinge.joint { Mx = { stiffness = 1e6, strength = 5e3 } } } }
model:mass { node = c, mass = 2000 }
local function plate(z) -- one falls on the other
  local at = {}
  for i, p in ipairs { { 0, 5 }, { 1, 5 }, { 1, 6 }, { 0, 6 } } do at[i] = model:node { p[1], p[2], z } end
  return model:panel { at[1], at[2], at[3], at[4], thickness = 0.05, material = steel }
end
model:fix(plate(2).nodes, "xyz")
plate(2.5)
model:panel_contact { restitution = 0.3 }
model:ground {}
model:gravity { 0, 0, -9.81 }
local run = model:dynamic { dt = 2e-4, duration = 1 }:finish()
require "hinge.report".show(run, { "bars" })
]]
  local _, printed = hinge_on("run", scene_text, "--out table")
  local sum, rows, wrong = 0, 0, nil
  local of = { initial = 1, work = 1 }
  for name, kJ in (printed:match "energy, kJ\n(.-)\n\n" or ""):gmatch "(%l[%l_]*) +(%-?[%d.]+)" do
    if name == "energy_error" then wrong = tonumber(kJ) else sum, rows = sum + (of[name] or -1) * kJ, rows + 1 end
    if name == "ground" or name == "joints" or name == "panel_contact" then
      expect(tonumber(kJ) > 1, "%s: %s kJ", name, kJ)
    end
  end
  expect(rows == 12 and wrong, "%d accounts in\n%s", rows, printed)
  near(sum, wrong or 0 / 0, 0.0055, "what the accounts leave, kJ: each has three digits after the point")
end)

checks.done()

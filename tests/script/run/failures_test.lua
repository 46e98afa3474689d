-- Outcomes are values: what a run, a study or a page does never depends on the text of a failure or of a warning, in
-- which the names of groups stand. run.failure has the cause as a word.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "failures"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

-- Words that messages of hinge have, and marks at which a text might be cut or a quote end.
local hostile = { "the load on", "arms; upper", "; ", "a \"quoted\" 'name'", "two\nlines", "\r\n; x", "Euler's load",
  "solver = 'direct', more iterations", "rotate about x", "is not finite", "cannot write out: x", "%s %d %1",
  "not enough memory", "the energy balance no longer closes", "limit load", "(a), free", "[[x]] -- y", "ü; ä" }

local bar = hinge.section.general { area = 1e-3, Ix = 1e-6, Iy = 1e-6, J = 1e-6, Mx0 = 5e3, My0 = 5e3 }

-- A bar whose end turns at 200 rad/s, so that it folds back against itself: 0.0155 s turn it by 3.1 rad.
local function folding(group)
  local model, b = scenes.cantilever { length = 2, member = { section = bar, material = scenes.steel, group = group } }
  model:mass { node = b, mass = 5, inertia = { 5, 5, 5 } }
  model:velocity(b, { 0, 0, 0 }, { 0, 200, 0 })
  return model
end
local function fold(group, options, model)
  return (model or folding(group)):dynamic(scenes.with({ dt = 0.0155, duration = 0.31, record = false,
    internals = { predictor = "acceleration" } }, options)):finish()
end

-- The text with another name of the group in it.
local function renamed(text, from, to)
  return (text:gsub("%(" .. from .. "%)", function() return "(" .. to .. ")" end))
end

-- All of run.failure but its texts.
local function values(failure)
  local parts = {}
  for _, name in ipairs { "cause", "step", "time", "node", "component", "value", "limit", "count" } do
    parts[#parts + 1] = ("%s=%s"):format(name, tostring(failure[name]))
  end
  parts[#parts + 1] = "member=" .. (failure.member and failure.member.index or "none")
  return table.concat(parts, " ")
end

case("the name of a group changes neither the result of a run that fails nor the reason around it", function()
  for _, options in ipairs { {}, { step_control = 0 } } do
    local function run_of(group) return fold(group, { step_control = options.step_control }) end
    local plain = run_of "arm"
    equal(plain.verdict, "failed", "verdict")
    if options.step_control then
      expect(plain.reason:find("(arm)", 1, true), "the reason names the group: %s", plain.reason)
    end
    -- with step control a trial of other settings takes a second, and the names that have changed results will do
    for _, name in ipairs(options.step_control and hostile or { "the load on", "arms; upper" }) do
      local run = run_of(name)
      local what = ("group %q"):format(name)
      equal(run.index, plain.index, what .. ": steps")
      equal(run.hash, plain.hash, what .. ": state")
      equal(values(run.failure), values(plain.failure), what .. ": failure")
      equal(run.reason, renamed(plain.reason, "arm", name), what .. ": reason")
      equal(run.failure.text, renamed(plain.failure.text, "arm", name), what .. ": failure.text")
      equal(#run.state_changes, #plain.state_changes, what .. ": changes of state")
    end
  end
end)

case("a failure says its cause, element and member", function()
  local run = fold("arm", { step_control = 0 })
  local f = run.failure
  equal(f.cause, "element_folded", "cause")
  equal(f.step, 1, "step")
  near(f.time, 0.0155, 1e-15, "time")
  equal(f.member.index, 1, "member")
  expect(f.element:find("of member 1 (arm)", 1, true), "element: %s", f.element)
  expect(run.reason:sub(1, #f.text) == f.text and #run.reason > #f.text, "text without advice: %s", f.text)
  equal(fold("arm", { step_control = 0 }):snapshot() ~= nil, true, "the run can still be read")
end)

case("the reason of a run that goes on from a failed one is not cut at a group's name", function()
  local function chain(group)
    local model = folding(group)
    local one = fold(group, { step_control = 0 }, model)
    local two = model:dynamic { from = one, dt = 1e-5, duration = 1e-4, record = false }:finish()
    return one, two
  end
  local function reason(run) return (run.reason:gsub("dynamic run %d+", "dynamic run 1")) end
  local _, plain = chain "arm"
  expect(plain.reason:find("by 177 degrees or more", 1, true), "all of the sentence: %s", plain.reason)
  expect(not plain.reason:find("may help", 1, true), "without its advice: %s", plain.reason)
  for _, name in ipairs(hostile) do
    local one, two = chain(name)
    equal(reason(two), renamed(reason(plain), "arm", name), ("group %q"):format(name))
    equal(two.failure.cause, "from_failed_run", "cause")
    expect(two.failure.text:find(one.failure.text, 1, true), "text: %s", two.failure.text)
  end
end)

-- Causes --------------------------------------------------------------------------------------------------------------

case("statics: an overload has no equilibrium, a compressed column is unstable", function()
  local carries = 235e6 * 0.05 ^ 3 / 4 -- N at the tip
  local model = scenes.cantilever { model = { displacement = "small" }, member = { material = scenes.steel },
    force = { 0, 0, -2 * carries } }
  local over = model:static { steps = 4 }:finish()
  equal(over.failure.cause, "no_equilibrium", "overload")
  near(over.failure.value, 0.5, 0.01, "load factor") -- halved steps come that near
  equal(over.failure.value, over.factor, "it is the factor reached")
  equal(over.failure.node, nil, "node")
  equal(model:static { steps = 4, to_limit = true }:finish().failure, nil, "a limit load that was asked for")

  local euler = math.pi ^ 2 * 206e9 * 0.05 ^ 4 / 12 / 16 -- clamped at the foot, free at the head: l_k = 2 l
  local run = scenes.cantilever { length = 2, along = { 0, 0, 1 }, force = { 0, 0, -2 * euler } }
    :static { steps = 10 }:finish()
  equal(run.failure.cause, "unstable", "column")
  near(run.failure.value, 0.5, 0.01, "load factor before it") -- two elements have Euler's load to 0.1 %
  equal(run.failure.node, run.instability.node, "node")
  equal(run.failure.component, run.instability.component, "component")
end)

case("dynamics: the energy balance, a load that is no number, the run before", function()
  local pendulum = scenes.cantilever { length = 2, foot = "xyz rx rz",
    member = { section = hinge.section.solid { width = 0.02, depth = 0.02 }, group = "not finite" } }
  pendulum:gravity { 0, 0, -9.81 }
  local swing = pendulum:dynamic { dt = 5e-3, duration = 20, record = false }:finish()
  equal(swing.failure.cause, "energy_error", "pendulum in long steps")
  equal(swing.failure.limit, 0.01, "energy_tolerance")
  near(swing.failure.value, swing.energy_error, 1e-12, "value is the energy error")
  local next_run = pendulum:dynamic { from = swing, dt = 1e-3, duration = 2e-3, record = false }:finish()
  equal(next_run.failure.cause, "from_failed_run", "the run after it")
  local accepted = pendulum:dynamic { from = swing, dt = 1e-3, duration = 2e-3, record = false, allow_failed = true }
  equal(accepted:finish().failure, nil, "a run after it that accepts that")

  local model, tip = scenes.cantilever { length = 2, along = { 0, 0, 1 }, member = { material = scenes.steel } }
  model:load { node = tip, force = { 1e308, 0, 0 }, history = { { 0, 0 }, { 1e-3, 10 } } } -- beyond 1.8e308 at 0.18 ms
  for _, control in ipairs { false, 0.01 } do
    local run = model:dynamic { dt = 1e-4, duration = 1e-2, record = false, step_control = control or nil }:finish()
    equal(run.verdict, "failed", "a load without bound")
    expect(run.failure.cause:find "finite" or run.failure.cause:find "unbounded" or run.failure.cause:find "rotation"
      or run.failure.cause:find "energy", "cause: %s", run.failure.cause)
  end
end)

-- Programs ------------------------------------------------------------------------------------------------------------

local hinge_does, folder = support.scenes(arg[1])
local cantilever = [[
local hinge = require "hinge"
local function cantilever(times)
  local model = hinge.model { displacement = "small" }
  local wall, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:fix(wall)
  model:member { wall, tip, section = hinge.section.solid { width = 0.05, depth = 0.05 }, material = hinge.material {
    E = 206e9, nu = 0.3, density = 7850, yield_stress = 235e6 }, group = "not enough memory; hinge: x" }
  model:load { node = tip, force = { 0, 0, -times * 235e6 * 0.05 ^ 3 / 4 } }
  return model, tip
end
]]
local overload = cantilever .. "local model, tip = cantilever(3)\n"

case("summary.json has the cause of the verdict", function()
  local status = hinge_does("run", overload .. "model:static { steps = 4 }:finish()\n", "--out out")
  equal(status, 1, "status")
  local summary = support.json(support.read(folder .. "/out/summary.json"))
  equal(summary.cause, "no_equilibrium", "cause")
  status = hinge_does("run", overload .. "model:static { steps = 4, to_limit = true }:finish()\n", "--out out")
  equal(status, 0, "status of a limit load that was asked for")
  equal(support.json(support.read(folder .. "/out/summary.json")).cause, nil, "no cause where nothing failed")
end)

case("a script that reads run.failure has asked how the run went", function()
  local one = overload .. "local run = model:static { steps = 4 }:finish()\nlocal _ = run.%s\n"
    .. "model:load { node = tip, force = { 0, 0, 1e5 } }\nmodel:static { steps = 1, loads = nil }\n"
  for field, status in pairs { failure = 0, verdict = 0, index = 1 } do
    local text = one:format(field) .. "cantilever(0):static { steps = 1 }:finish()\n"
    equal((hinge_does("run", text, "--out out")), status, field .. ": status")
  end
end)

case("a study has the cause of a failed case, and what a case prints does not change its verdict", function()
  local text = cantilever .. [[
local scenario = hinge.scenario {
  parameters = { times = 0.5 },
  run = function(p)
    print "there is not enough memory left of those days"
    local model = cantilever(p.times)
    if p.times > 3 then error "hinge: two lines\nof a message" end
    return { factor = model:static { steps = 4 }:finish().factor }
  end,
}
local study = hinge.study(scenario, { vary = { times = { 0.5, 3, 4 } }, out = "study", pictures = false })
for i, c in ipairs(study.cases) do print(("case %d|%s|%s|%s|"):format(i, c.verdict, c.cause, c.reason)) end
]]
  local _, printed, complaint = hinge_does("run", text, "--out out")
  local row = {}
  for i, verdict, cause, reason in printed:gmatch "case (%d)|([^|]*)|([^|]*)|([^|]*)|" do
    row[tonumber(i)] = { verdict = verdict, cause = cause, reason = reason }
  end
  equal(#row, 3, "cases; " .. printed .. complaint)
  equal(row[1].verdict, "completed", "a case that prints words of an error")
  equal(row[2].verdict .. " " .. row[2].cause, "failed no_equilibrium", "a case that fails")
  equal(row[3].verdict .. " " .. row[3].cause, "wrong nil", "a case with an error of its own")
  expect(row[3].reason:find("hinge: two lines\nof a message", 1, true), "its message is whole: %s", row[3].reason)
end)

case("the paper's list of failed runs is not cut at a group's name", function()
  local paper = require "hinge.paper"
  for _, name in ipairs { "arm", "arms; upper" } do
    local run = fold(name, { step_control = 0 })
    local said, say = {}, print
    print = function(text) said[#said + 1] = text end -- luacheck: ignore
    paper.show_ended({ note = function() end }, { paper.ended(run, "first") }, 1)
    print = say -- luacheck: ignore
    equal(said[#said], "  first: " .. run.failure.text, ("group %q"):format(name))
    expect(run.failure.text:find("by 177 degrees or more", 1, true), "all of it: %s", run.failure.text)
  end
end)

-- Sources -------------------------------------------------------------------------------------------------------------

-- Names that texts of failures and warnings have in the sources.
local texts = { "reason", "failure", "failed", "problem", "why", "%w+%.what", "warning", "warned", "advice",
  "complaint", "message", "remedy", "said", "error", "text_of[%w_]*", "reason_of", "weak" }

-- What of a text is looked at all the same, with the reason: { file, part of the line, why }.
local allowed = {
  { "lua/hinge/program/prompt.lua", 'problem:find "<eof>$"', "Lua's own mark of a chunk that is not complete" },
  { "lua/hinge/render/init.lua", 'problem:gsub("%S+%.%a%a%a%f[%W]", "")', "lines with other file names, printed once" },
  { "lua/hinge/render/init.lua", "problem:find(frame.file, 1, true)", "prints a file's name that is not there yet" },
  { "lua/hinge/report/page.lua", "frame.problem:find(frame.file, 1, true)", "the same" },
  { "lua/hinge/benchmark/tables.lua", 'name:find("observed order", 1, true)', "name of a benchmark's row" },
  { "src/command_line.cpp", 'rfind("--live", 0)', "an option of the program" },
  { "src/live/live.cpp", 'query.find("page")', "key of a map" },
  { "src/live/live.cpp", 'query.find("program")', "key of a map" },
  { "lua/hinge/standards/en_1993_1_8/end_plate.lua",
    'governs:find "^end plate"', "name of a component, of the file's own table" },
  { "lua/hinge/standards/en_1993_1_8/end_plate.lua",
    'governs:find "^column flange"', "the same" },
}

local function is_allowed(file, line)
  for _, one in ipairs(allowed) do
    if one[1] == file and line:find(one[2], 1, true) then
      one.met = true
      return true
    end
  end
end

local searches = { cpp = { "find", "rfind", "substr", "starts_with", "ends_with", "contains", "compare",
  "find_first_of", "find_last_of" }, lua = { "find", "match", "gmatch", "gsub", "sub" } }

-- Whether a line of code searches such a text.
local function searches_in(line, kind)
  for _, call in ipairs(searches[kind]) do
    for _, name in ipairs(line:find(call, 1, true) and texts or {}) do
      local pattern = kind == "cpp" and "%f[%w_]" .. name .. "_?%f[^%w_][%w_%(%)%[%]%*]*[%.%->]+" .. call .. "%("
        or "%f[%w_]" .. name .. "%f[^%w_][%]%)]*:" .. call .. "%f[^%w_]"
      if line:find(pattern) then return true end
      if kind == "lua" and line:find("string%." .. call .. "%(%s*[%w_%.]*" .. name .. "%f[^%w_]") then return true end
    end
  end
  -- a sentence or a word of one, whatever the text is called
  return line:find(kind == "cpp" and '[%.>]r?find%("[^"]-%l%l%l%l[^"]-"'
    or ':[fm][ia][nt][dc]h?%f[^%w_]%(?%s*["\'][^"\']-%l%l+ %l%l+')
end

-- Lines that look into such a text, "file:line: text".
local function searched(file, text, kind)
  local found, number = {}, 0
  for line in (text .. "\n"):gmatch "([^\n]*)\n" do
    number = number + 1
    local code = line:gsub(kind == "cpp" and "//.*$" or "%-%-.*$", "")
    if searches_in(code, kind) and not is_allowed(file, line) then
      found[#found + 1] = ("%s:%d: %s"):format(file, number, line)
    end
  end
  return found
end

case("the search for code that reads texts of failures finds it", function()
  for kind, lines in pairs {
    cpp = { 'return failure.find("the load on") != std::string::npos;', 'r.run->reason().substr(0, 3)',
      'w.what.find("Euler")', 'of_solver.find("direct") != npos', 'if (reason_.starts_with("x"))' },
    lua = { 'e.reason:match "^[^;]*"', 's.record.failed:match "x"', 'said:find("not enough memory", 1, true)',
      'frame.problem:match "x"', 'text:find "^cannot write"', 'string.find(run.reason, "x")' },
  } do
    for _, line in ipairs(lines) do equal(#searched("x", line, kind), 1, line) end
  end
  for kind, lines in pairs { cpp = { 'const auto known = pair_rules_.find({a, b});', '// failure.find("x")' },
    lua = { 'text:find "x"', 'if failure.cause == "energy_error" then' } } do
    for _, line in ipairs(lines) do equal(#searched("x", line, kind), 0, line) end
  end
end)

case("no code in src or lua/hinge searches the text of a failure or of a warning", function()
  local list = support.output(("cd %s && find src lua/hinge -name '*.cpp' -o -name '*.h' -o -name '*.lua' | sort")
    :format(support.quote(support.root)))
  local found, files = {}, 0
  for file in list:gmatch "[^\n]+" do
    if not file:find "%.d%.lua$" and not file:find "^lua/hinge/import/" and not file:find "^src/output/xvfb" then
      files = files + 1
      local kind = file:find "%.lua$" and "lua" or "cpp"
      for _, line in ipairs(searched(file, support.read(support.root .. file), kind)) do found[#found + 1] = line end
    end
  end
  expect(files > 300, "only %d files were read", files)
  equal(table.concat(found, "\n"), "", "code that reads a text back")
  for _, one in ipairs(allowed) do expect(one.met, "%s has no %s any more: take it out of the list", one[1], one[2]) end
end)

checks.done()

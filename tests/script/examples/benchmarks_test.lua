-- hinge.benchmark and scripts/benchmarks/all.lua: the fast benchmarks are right; a wrong row, one that is not a number,
-- a script that raises an error and a process that dies make the verdict "failed" with the reason; filter, fast and the
-- table in README.md; wrong input.
--
-- Run: lua5.4 tests/script/examples/benchmarks_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "benchmarks"
local case, ended, equal, expect = checks.case, checks.ended, checks.equal, checks.expect
local with = require "scenes".with
local quote = support.quote
local program = quote(arg[1] .. "/hinge")
local root = support.output("realpath " .. quote(support.root)):gsub("\n$", "")

-- all.lua with these settings, in a folder of its own. Returns what support.run does, and the folder of its output.
local function run_all(settings)
  local folder = support.temporary_folder()
  local status, printed, told = support.run(("cd %s && %s run %s/scripts/benchmarks/all.lua %s --out out"):format(
    quote(folder), program, quote(root), settings))
  return status, printed, told, folder .. "/out"
end

local head = 'local hinge = require "hinge"\nreturn hinge.benchmark { title = "%s", kind = "%s", source = "none", '
local body = "run = function(b) %s end }\n"
local function benchmark(title, kind, statements, more)
  return head:format(title, kind) .. (more or "") .. body:format(statements)
end
local right = "b:row { 'right', computed = 1.001, reference = 1, tolerance = 0.002, elements = 2, unit = 'm' } "
local order = "b:rows_with { elements = 2, unit = 'm', tolerance = 0.2 }('observed order, 2 to 4', 2.2, 2, '', nil, "
  .. "{ elements = 4 }) "

-- A folder of benchmarks: by name, what is in them.
local function folder_of(texts)
  local folder = support.temporary_folder()
  for name, text in pairs(texts) do support.write(("%s/%s.lua"):format(folder, name), text) end
  return folder
end

-- The lines of results.csv after its head.
local function lines_of(out)
  local lines = {}
  for line in (support.read(out .. "/results.csv") or ""):gmatch "[^\n]+" do lines[#lines + 1] = line end
  table.remove(lines, 1)
  return lines
end

case("the fast benchmarks are right, each row of them", function()
  local status, printed, told, out = run_all "fast=true"
  ended(0, "", status, printed, told)
  local rows, kinds = 0, {}
  local summary = support.json(support.read(out .. "/summary.json") or "{}")
  equal(summary.verdict, "completed", "verdict: " .. tostring(summary.reason))
  for kind, of in pairs(summary.results.by_kind) do
    rows, kinds[kind] = rows + of.rows, true
    equal(of.wrong, 0, kind .. ": wrong rows")
  end
  equal(summary.results.rows, rows, "rows by kind")
  expect(kinds.elastic and kinds.stability and kinds.inelastic and kinds.dynamics, "kinds: %s", printed)
  local problems = summary.results.benchmarks
  expect(rows > 60 and problems > 15, "%d rows of %d benchmarks", rows, problems)
  local lines = lines_of(out)
  equal(#lines, rows, "lines of results.csv")
  for _, line in ipairs(lines) do expect(line:find(",true,%d+,%d+,"), "is right: %s", line) end
  expect(not printed:find "not as they should be", "no complaint: %s", printed)
  expect(#(support.read(out .. "/how_right.png") or "") > 5000, "how_right.png is drawn")
end)

case("a row outside its tolerance makes the verdict failed, and names it", function()
  local folder = folder_of { good = benchmark("Good", "elastic", right .. order), off = benchmark("Off", "dynamics",
    right .. "b:row { 'wrong', computed = 1.003, reference = 1, tolerance = 0.002, elements = 2, steps = 7 }") }
  local status, printed, told, out = run_all("folder=" .. quote(folder))
  ended(1, "the run failed: off", status, printed, told)
  expect(printed:find "not as they should be:\n  off: wrong: error %+0.3 %%, allowed 0.2 %%\n", "says: %s", printed)
  expect(printed:find "dynamics  off +wrong +1.003 +1 +%+0.3 %% ! +2 +7 ", "its row: %s", printed)
  expect(printed:find "dynamics +2 +0.2 %% +0.3 %% +1  off: wrong\n", "by kind: %s", printed)
  expect(printed:find "elastic +2 +0.1 %% +0.1 %% +0  good: right\n", "by kind, without the order: %s", printed)
  equal(#lines_of(out), 4, "rows")
  for name, alone in pairs { off = 1, good = 0 } do
    ended(alone, "", support.run(("cd %s && %s run %s.lua"):format(quote(folder), program, name)))
  end
end)

case("what is not a number, or has no end, is a wrong row, and the others stay", function()
  for text, shown in pairs { ["0 / 0"] = "not a number", ["1 / 0"] = "%+inf %%" } do
    local folder = folder_of { nan = benchmark("NaN", "test", right .. ("b:row { 'none', computed = %s, reference = 2, "
      .. "tolerance = 1e9, elements = 1 } "):format(text) .. right) }
    local status, printed, told, out = run_all("folder=" .. quote(folder))
    ended(1, "", status, printed, told)
    expect(printed:find("nan +none +%-?%l+ +2 +" .. shown .. " !"), "%s: its row: %s", text, printed)
    ended(1, "", support.run(("cd %s && %s run nan.lua"):format(quote(folder), program)))
    local lines = lines_of(out)
    equal(#lines, 3, text .. ": rows")
    expect(lines[2] and lines[2]:find(",false,", 1, true), "%s: is not right: %s", text, tostring(lines[2]))
    expect(#(support.read(out .. "/how_right.png") or "") > 5000, "%s: the picture has the others", text)
  end
end)

case("right rows do not hide a run that failed", function()
  local model = [[
    local model = hinge.model {}
    local foot, head = model:node { 0, 0, 0 }, model:node { 0, 0, 4 }
    model:fix(foot)
    model:member { foot, head, section = hinge.section.solid { width = 0.05, depth = 0.05 },
      material = hinge.material { E = 206e9 } }
    model:load { node = head, force = { 0, 0, -1e6 } }
    model:static { steps = 20 }:finish()
  ]]
  local folder = folder_of { hidden = benchmark("Hidden", "stability", model .. right),
    known = benchmark("Known", "stability", model .. right):gsub("function%(b%)",
      "function(b, job) job:verdict 'completed'") }
  local printed = ended(1, "the run failed: hidden\n", run_all("folder=" .. quote(folder)))
  expect(printed:find "\n  hidden failed: [^\n]*unstable", "with the run's reason: %s", printed)
end)

case("an error, a dead process, no benchmark: a failed row with the reason", function()
  local folder = folder_of { good = benchmark("Good", "elastic", right),
    raises = benchmark("Raises", "elastic", right .. "error 'the frame is gone'"),
    input = benchmark("Input", "stability", "hinge.model { nonsense = 1 }"),
    killed = benchmark("Killed", "stability", "os.execute 'kill -9 $PPID' while true do end"),
    leaves = benchmark("Leaves", "stability", "os.exit(0)"), empty = benchmark("Empty", "elastic", ""),
    slow = benchmark("Slow", "elastic", "local t = os.time() + 60 while os.time() < t do end"),
    plain = "return 3\n", broken = "return hinge.benchmark {\n" }
  local status, printed, told, out = run_all("timeout=3 jobs=2 folder=" .. quote(folder))
  ended(1, "the run failed: empty, raises, slow, input, killed, leaves, broken, plain", status, printed, told)
  for name, reason in pairs { raises = "wrong: [^\n]*raises.lua:2: the frame is gone",
    input = "wrong: [^\n]*input.lua:2: hinge.model: unknown field 'nonsense'", killed = "crashed: ended by signal 9",
    leaves = "wrong", empty = "the benchmark has no row; run must call b:row", slow = "timed out: stopped after 3 s",
    plain = "[^\n]*plain.lua returns no benchmark", broken = "wrong: [^\n]*broken.lua:" } do
    expect(printed:find("\n  " .. name .. " failed: " .. reason), "%s: %s", name, printed)
  end
  expect(printed:find "elastic +raises +failed +%-", "a row in the table: %s", printed)
  local lines = lines_of(out)
  equal(#lines, 9, "a line each")
  expect(lines[1]:find '^elastic,empty,Empty,,,,,,,false,,,,none,"the benchmark has no row', "the reason: %s",
    lines[1])
end)

case("filter goes by name, kind and title; fast by what the file says", function()
  local folder = folder_of { alpha = benchmark("First", "elastic", right, "fast = true, "),
    beta = benchmark("Second alpha", "inelastic", right), gamma = benchmark("Third", "dynamics", right) }
  for setting, names in pairs { ["filter=ALPHA"] = "alpha beta", ["filter=elastic"] = "alpha",
    ["filter=third"] = "gamma", ["filter=elas"] = "alpha beta", ["fast=true"] = "alpha",
    ["filter=dynamics"] = "gamma" } do
    local printed = ended(0, "", run_all(("folder=%s %s"):format(quote(folder), setting)))
    local found = {}
    for _, name in ipairs { "alpha", "beta", "gamma" } do
      if printed:find("\n%l+ +" .. name .. " +right") then found[#found + 1] = name end
    end
    equal(table.concat(found, " "), names, setting)
  end
  ended(2, { "no benchmark has this in its name, its kind or its title", "alpha, beta, gamma" },
    run_all("folder=" .. quote(folder) .. " filter=delta"))
  ended(2, "it holds no benchmark", run_all("folder=" .. quote(folder_of {})))
end)

case("rows whose reference is not confirmed are marked, and count in no median, largest error and picture", function()
  local of = [[
    local hinge = require "hinge"
    return hinge.benchmark { title = "%s", kind = "test", source = "a book", unconfirmed = %s, run = function(b)
      b:row { "load", computed = 1 + %g, reference = 1, tolerance = 1, elements = 1 }
    end }
  ]]
  local folder = folder_of { sure = of:format("Sure", "false", 0.01), quoted = of:format("Quoted", "true", 0.25) }
  ended(0, "load (reference not confirmed)", run_all("write=true folder=" .. quote(folder)))
  local text = support.read(folder .. "/README.md") or ""
  for _, wanted in ipairs { "| [Quoted](quoted.lua) | load (reference not confirmed) | 1.25 | 1 | +25",
    "| [Sure](sure.lua) | load | 1.01 | 1 | +1", "| test | 2 | 1 % | 1 % | sure: load |" } do
    expect(text:find(wanted, 1, true), "'%s' in\n%s", wanted, text)
  end
end)

case("write=true writes the table between its marks, and copies pictures", function()
  local folder = folder_of { drawn = [[
    local hinge = require "hinge"
    return hinge.benchmark { title = "Drawn | twice", kind = "elastic", source = "a book", missing = "the wind",
      run = function(b, job)
        ]] .. right .. [[
        job:plot({ series = { { x = { 0, 1 }, y = { 0, 1 } } } }, "drawn.png")
        job:plot({ series = { { x = { 0, 1 }, y = { 0, 1 } } } }, "other.png")
      end }
  ]] }
  ended(0, "", run_all("write=true folder=" .. quote(folder)))
  local text = support.read(folder .. "/README.md") or ""
  for _, wanted in ipairs { "### Elastic\n", "| [Drawn \\| twice](drawn.lua) | right | 1.001 m | 1 | +0.1 % | 2 | 1 |",
    "- [Drawn | twice](drawn.lua): a book. Not in the model: the wind. [picture](pictures/drawn.png), "
      .. "[picture 2](pictures/drawn_other.png)", "| elastic | 1 | 0.1 % | 0.1 % | drawn: right |" } do
    expect(text:find(wanted, 1, true), "'%s' in\n%s", wanted, text)
  end
  for _, name in ipairs { "drawn", "drawn_other", "how_right" } do
    expect(#(support.read(("%s/pictures/%s.png"):format(folder, name)) or "") > 2000, "%s.png is there", name)
  end
  support.write(folder .. "/README.md", "Before.\n" .. text:gsub("| right |", "| old |") .. "After.\n")
  ended(0, "", run_all("write=true folder=" .. quote(folder)))
  local second = support.read(folder .. "/README.md")
  expect(second:find "^Before.\n" and second:find "After.\n$" and not second:find("| old |", 1, true)
    and second:find("| right |", 1, true), "the table alone is new: %s", second)
  ended(2, "leave out filter and fast", run_all("write=true fast=true folder=" .. quote(folder)))
  support.write(folder .. "/README.md", "No marks.\n")
  ended(2, "has not the two lines between which the table goes", run_all("write=true folder=" .. quote(folder)))
  equal(support.read(folder .. "/README.md"), "No marks.\n", "and changes nothing")
end)

case("wrong input of a benchmark and of a row is refused", function()
  local given = { title = "t", kind = "elastic", source = "s", run = function() end }
  for field, what in pairs { title = "a string", kind = "one of elastic, stability, inelastic, dynamics, test",
    source = "a string", run = "a function" } do
    local o = with(given)
    o[field] = nil
    checks.refused(("hinge.benchmark: field '%s' is missing; give %s"):format(field, what),
      function() hinge.benchmark(o) end)
  end
  checks.refused("field 'kind' is 'plastic'; must be one of",
    function() hinge.benchmark(with(given, { kind = "plastic" })) end)
  local right_row = { "q", computed = 1, reference = 1, tolerance = 1, elements = 1 }
  local function without(field)
    local row = with(right_row)
    row[field] = nil
    return row
  end
  local refused = {
    { with(right_row, { reference = 0 }), "the reference of 'q' is 0; scale must say" },
    { without "tolerance", "field 'tolerance' is missing; give a number above 0" },
    { with(right_row, { tolerance = 0 }), "field 'tolerance' is 0" },
    { with(right_row, { reference = 0 / 0 }), "field 'reference' is not a number" },
    { without "computed", "field 'computed' is missing; give a number" },
    { with(right_row, { computed = "1" }), "field 'computed' is '1'; must be a" },
    { without "elements", "field 'elements' is missing" },
    { with(right_row, { elements = 1.5 }), "field 'elements' is 1.5" },
    { without(1), "'options[1], the quantity' is missing" },
    { with(right_row, { error = 1 }), "unknown field 'error'" },
    { 3, "field 'options' is 3; must be a table" },
  }
  local made = hinge.benchmark { title = "t", kind = "elastic", source = "s", run = function(b)
    for _, one in ipairs(refused) do
      checks.refused({ "benchmark:row: ", one[2] }, function() b:row(one[1]) end)
    end
    local row = b:row { "by scale", computed = 0.1, reference = 0, scale = 2, tolerance = 0.06, elements = 1 }
    equal(row.error, 0.05, "the error is a part of the scale")
    equal(row.right, true, "it is right")
    row = b:row { "below 0", computed = -1.1, reference = -1, tolerance = 0.2, elements = 1 }
    checks.near(row.error, -0.1, 1e-12, "the error has the sign of the difference")
  end }
  local say, verdict = print, nil
  print = function() end -- luacheck: ignore
  made.run({}, { verdict = function(_, what) verdict = what end })
  print = say -- luacheck: ignore
  equal(verdict, nil, "no verdict of its own: that of the runs stands")
end)

checks.done()

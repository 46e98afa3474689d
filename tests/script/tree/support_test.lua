-- What the tests rest on: a number that is not one is missed by every limit, and no test collects its errors so that it
-- is dropped. Printed text is compared with numbers as numbers. ctest runs every test file in Lua.
--
-- Run: lua5.4 tests/script/tree/support_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "support"
local case, expect, equal = checks.case, checks.expect, checks.equal
local largest_of, smallest_of = support.largest_of, support.smallest_of

-- The helpers --------------------------------------------------------------------------------------------------------

local nan = 0 / 0
case("the largest and the smallest of numbers are not a number if one of them is not", function()
  equal(largest_of(2, 3, 1), 3, "the largest")
  equal(largest_of(-2, -3, -1), -1, "the largest of negative numbers")
  equal(smallest_of(2, 3, 1), 1, "the smallest")
  equal(largest_of(7), 7, "the largest of one")
  equal(largest_of(-math.huge, 4), 4, "the largest from below")
  equal(largest_of(4, math.huge), math.huge, "the largest may be infinite")
  for at = 1, 3 do -- first, in the middle, last
    local x = { 1e-16, 3e-16, 2e-16 }
    x[at] = nan
    local worst, least = 0, 1 -- as a loop collects it
    for i = 1, 3 do worst, least = largest_of(worst, x[i]), smallest_of(least, x[i]) end
    for what, value in pairs { ["the largest"] = largest_of(x[1], x[2], x[3]), ["a loop's largest"] = worst,
      ["the smallest"] = smallest_of(x[1], x[2], x[3]), ["a loop's smallest"] = least } do
      expect(value ~= value, "%s of numbers of which number %d is none: is %g", what, at, value)
    end
    expect(not (worst <= 1e-13) and not (worst > 1e-3), "no limit is met")
  end
  expect(largest_of(nan, math.huge) ~= math.huge and largest_of(math.huge, nan) ~= math.huge, "beside what is infinite")
end)

case("a value that is not a number, and files that differ, fail their check", function()
  local printed = {}
  local inner = support.checks("inner", { print = function(text) printed[#printed + 1] = text end, exit = print })
  inner.case("all", function()
    inner.near(nan, 1, 0.1, "a value")
    inner.near(1, nan, 0.1, "what was wanted")
    inner.near(1, 1, nan, "a limit")
    inner.near(1, 1.05, 0.1, "what is near")
    inner.same_files("none", "none", "files that are not there")
    inner.same_files(arg[0], "none", "a file that is not there")
    inner.same_files(arg[0], support.folder .. "support.lua", "files that differ")
    inner.same_files(arg[0], arg[0], "a file")
  end)
  equal(#printed, 7, "the case and what fails in it: " .. table.concat(printed, "\n"))
end)

case("a call that is not refused as wanted fails its check", function()
  local printed = {}
  local inner = support.checks("inner", { print = function(text) printed[#printed + 1] = text end, exit = print })
  local function elsewhere() error "width is -0.10 m; it must be > 0" end
  inner.case("all", function()
    inner.refused({ "width", "-0.1", "> 0" }, function() error "width is -0.10 m; it must be > 0" end) -- as wanted
    inner.refused("no number", error, "'a' is no number")
    inner.refused("width", function() end)
    inner.refused({ "width", "depth" }, function() error "width is -0.10 m; it must be > 0" end)
    inner.refused("width", function() elsewhere() end)
    inner.refused("width", function() error("width", 0) end)
  end)
  equal(#printed, 5, "the case and what fails in it: " .. table.concat(printed, "\n"))
end)

case("a command that ends otherwise or says something else fails its check", function()
  local printed = {}
  local inner = support.checks("inner", { print = function(text) printed[#printed + 1] = text end, exit = print })
  inner.case("all", function()
    inner.ended(0, { "two", "-0.0 m" }, support.run "echo two of 0.0 m") -- as wanted
    inner.ended(3, "two", support.run "echo two >&2; exit 3")
    inner.ended(0, "two", support.run "echo two; exit 3")
    inner.ended(3, "two", support.run "echo two; exit 3")
    inner.ended(0, { "one", "two" }, support.run "echo one")
  end)
  equal(#printed, 4, "the case and what fails in it: " .. table.concat(printed, "\n"))
end)

-- Printed text: words as words, numbers as numbers -------------------------------------------------------------------

case("printed text is compared word by word, its numbers within their last digit", function()
  for _, row in ipairs {
    -- printed, shown, whether they are the same
    { "a  0.0  0\n", "a -0.0 -0\n", true }, { "x=-0.0,y", "x=0.0,y", true }, { "-0.0 m", "0.0 m", true },
    { "a\n-0.0 m", "a\n 0.0 m", true }, { "a\t-0\tb", "a\t0\tb", true }, { "-0.01\n", " 0.01\n", false },
    { "12.5 m", "-12.5 m", false },
    -- one unit of the last of three digits, whichever side; more is another number
    { "x 1.234 y", "x 1.235 y", true }, { "x 1.234 y", "x 1.236 y", false }, { "1.412e+05 N", "1.413e+05 N", true },
    { "1.412e+05 N", "1.414e+05 N", false }, { "1.412e+05 N", "1.412e+06 N", false }, { "9.99 m", "10.00 m", true },
    { "0.3", "0.4", false }, { "0.3", "0.2999", true }, { "1", "0.9999999", true }, { "1", "0.999", true },
    -- one part in a million of many digits
    { "3.1128541 mm", "3.1128555 mm", true }, { "3.1128541 mm", "3.1128591 mm", false },
    -- counts
    { "246 steps", "247 steps", false }, { "2024-11-24", "2024-11-25", false },
    -- words, versions, names and hashes with digits in them; what is not a number
    { "case_1.50", "case_1.51", false }, { "0.2.100", "0.2.101", false }, { "3e100f", "3e101f", false },
    { "x nan", "x 0.0", false }, { "x 0.0", "x nan", false }, { "x -nan", "x nan", false }, { "x inf", "x 1e308",
    false },
    { "a 0.0 b", "a 0.0 c", false }, { "a 0.0b", "a 0.0 b", false }, { "a b", "a  b", false }, { "", "", true },
    -- "…" within a line and as a line, for anything and for nothing else
    { "a 1\nx\ny\nb\n", "a …\n…\nb\n", true }, { "a\nb\n", "a\n…\nb\n", true }, { "a 1\nx\nb\n", "a …\nb\n", false },
    { "a\nx\ny\n", "a\n…\n", true }, { "a\nx\nb\ny\nc\n", "a\n…\n…\nc\n", true }, { "x\na\n", "…\na\n", true },
    { "t 12 s, 3.0 m", "t … s, -3.0 m", false }, { "t 12 s, -0.0 m", "t … s, 0.0 m", true }, { "a 2\n", "a 1\n",
    false },
  } do
    local printed, shown, same = table.unpack(row)
    equal(support.prints(printed, shown), same, ("'%s' as '%s'"):format(printed, shown))
  end
end)

case("... in a message stands for anything", function()
  for _, row in ipairs {
    { "step 12, t = -0.0 s: no", "step ..., t = 0.0 s: no", true }, { "a\nb", "...b", true }, { "", "...", true },
    { "step 12: no", "step ...: yes", false }, { "E is -2 Pa", "E is 2 Pa", false }, { "abc", "ab", false },
  } do
    equal(support.says(row[1], row[2]), row[3], ("'%s' says '%s'"):format(row[1], row[2]))
  end
end)

case("a piece is found in a text, its numbers compared as numbers", function()
  for _, row in ipairs {
    { "moved by -0.0 m along x", "by 0.0 m", true }, { "3 m and 4.001 m", "4.002 m", true }, { "12.5 m", "2.5 m",
      false },
    { "a 0.1 m", "0.2 m", false }, { "nothing", "anything", false }, { "x", "", true },
  } do
    equal(support.has(row[1], row[2]), row[3], ("'%s' has '%s'"):format(row[1], row[2]))
  end
end)

-- How tests collect numbers ------------------------------------------------------------------------------------------

-- if (x > worst) worst = x, and its like in Lua.
local kept_by_if = ("if%s*%(?%s*NAME%s*[<>]=?%s*NAME%s*%)?%s*[then{]*%s*NAME%s*=%s*NAME")
  :gsub("NAME", "([%%w_.%%[%%]]+)")

-- Why a line of a test may drop a number that is not one, or nil. math.max(1, n), with a whole number first, is a lower
-- bound of a count; so is std::max<int>.
local function drops(line)
  local code = line:gsub("%s*//.*", ""):gsub("%s*%-%-.*", "")
  for call in code:gmatch "math%.max%s*(%b())" do
    if not call:find "^%(%d+,%s" then return "math.max: use support.largest_of" end
  end
  for call in code:gmatch "std::f?max%s*(%b())" do
    if not call:find "^%(%d+L?,%s" then return "std::max: use largest_of" end
  end
  if code:find "std::f?max%s*%([^()]*$" or code:find "std::max_element" then return "std::max: use largest_of" end
  local name = code:match "([%w_.%[%]]+)%s*=%s*math%.min%s*%("
  if name and code:find("math.min(" .. name, 1, true) then return "math.min: use support.smallest_of" end
  name = code:match "([%w_.%[%]]+)%s*=%s*std::min%s*%("
  if name and code:find("std::min(" .. name, 1, true) then return "std::min: use smallest_of" end
  if code:find "maxCoeff%(%)" or code:find "minCoeff%(%)" or code:find "lpNorm<Eigen::Infinity>" then
    return "Eigen's maxCoeff may drop what is not a number: use largest_entry"
  end
  local first, second, set, to = code:match(kept_by_if)
  if first and set == second and to == first then return "if (x > worst) worst = x: use largest_of, or smallest_of" end
end

case("a line that drops a number that is not one is found", function()
  for line, bad in pairs {
    ["worst = std::max(worst, x);"] = true, ["worst = math.max(worst, x)"] = true,
    ["    worst = std::max({worst, a,"] = true,
    ["return std::max(a, b);"] = true, ["worst = std::max("] = true, ["worst = std::fmax(worst, x);"] = true,
    ["a, worst = 1, math.max( worst, math.abs(x - y))"] = true, ["CHECK(m.cwiseAbs().maxCoeff() < 1e-9);"] = true,
    ["least = std::min(least, x);"] = true, ["t.least = math.min(t.least, x)"] = true,
    ["if (x > worst) worst = x;"] = true,
    ["if x > worst then worst = x end"] = true, ["if (x < least) least = x;"] = true,
    ["if (error >= worst[i]) worst[i] = error;"] = true,
    ["worst = largest_of(worst, x);"] = false, ["math.max(1, run.planned_steps // 200)"] = false,
    ["std::max(1L, steps / 10)"] = false, ["n = std::max<int>(n, m);"] = false,
    ["m.maxCoeff<Eigen::PropagateNaN>()"] = false, ["// std::max(worst, x) drops it"] = false,
    ["-- math.max(worst, x)"] = false, ["return math.min(1, t / 0.01)"] = false, ["if (x > 1) y = x;"] = false,
    ["if (a > b) c = a;"] = false,
  } do
    expect((drops(line) ~= nil) == bad, "'%s' is %s", line, drops(line) or "let through")
  end
end)

case("no line of the tests drops a number that is not one", function()
  local files, lines = 0, 0
  local found = support.output(("cd %s && find tests -name '*.cpp' -o -name '*.h' -o -name '*.lua'"):format(
    support.quote(support.root)))
  for path in found:gmatch "[^\n]+" do
    files = files + 1
    local number = 0
    for line in (support.read(support.root .. path) .. "\n"):gmatch "([^\n]*)\n" do
      number, lines = number + 1, lines + 1
      local why = not path:find "support_test%.lua$" and drops(line)
      expect(not why, "%s:%d: %s", path, number, why)
    end
  end
  expect(files > 50 and lines > 8000, "%d files of %d lines were looked at", files, lines)
end)

-- That every test runs ------------------------------------------------------------------------------------------------

-- The files, below tests/script, that lines of tests/CMakeLists.txt give to add_script_test.
local function registered(text)
  local files = {}
  for line in ("\n" .. text):gmatch "\n%s*add_script_test%(([^\n]*)" do
    local file = line:match "^%S+ %${HINGE_LUA} %${scripts}/([%w_/]+_test%.lua)%f[%s)]"
    if file then files[file] = true end
  end
  return files
end

case("a line that adds no test is not taken for one", function()
  local line = "add_script_test(a ${HINGE_LUA} ${scripts}/run/a_test.lua"
  for text, found in pairs {
    [line .. ")"] = true, ["  " .. line .. " ${CMAKE_BINARY_DIR} 0.02)"] = true,
    ["# " .. line .. ")"] = false, [line .. "x)"] = false, ["# ${scripts}/run/a_test.lua"] = false,
    ["add_script_test(a ${HINGE_LUA} ${scripts}/effects/a_test.lua)"] = false,
  } do
    expect((registered(text)["run/a_test.lua"] or false) == found, "'%s': adds a test: must be %s", text, found)
  end
end)

case("every Lua test has its line add_script_test in tests/CMakeLists.txt", function()
  local added, count = registered(support.read(support.root .. "tests/CMakeLists.txt")), 0
  local there = support.output(("cd %stests/script && find . -name '*_test.lua'"):format(support.quote(support.root)))
  for path in there:gmatch "%./([^\n]+)" do
    count = count + 1
    expect(added[path], "tests/script/%s never runs: give tests/CMakeLists.txt a line add_script_test(%s ${HINGE_LUA} "
      .. "${scripts}/%s), with what it is called with behind it", path, path:match "([%w_]+)_test%.lua$", path)
  end
  expect(count > 100, "%d tests were looked at", count)
end)

checks.done()

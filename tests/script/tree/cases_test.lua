-- The cases of test files: a case that fails is reported by its name and line, the others run on, one runs alone, and a
-- test that cannot fail is refused.
--
-- Run: lua5.4 tests/script/tree/cases_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "cases"
local case, expect, equal = checks.case, checks.expect, checks.equal
local quote = support.quote
local folder = support.temporary_folder()

-- Runs a test file of these cases; the first of them stands on line 5.
local function run(text, arguments, environment)
  support.write(folder .. "/inner_test.lua", ([[
package.path = %q .. "?.lua;" .. package.path
local checks = require "support".checks "inner"
local case, expect, near = checks.case, checks.expect, checks.near
local function positive(x) expect(x > 0, "x is %%g", x) end
]]):format(support.folder) .. text)
  return support.run(("env %s lua5.4 %s %s"):format(environment or "-u HINGE_CASE",
    quote(folder .. "/inner_test.lua"), arguments or ""))
end
local three = [[
case("a beam sags", function() expect(true, "sag") end)
case("a column buckles", function()
  positive(1)
  expect(1 > 2, "the load is %d N", 3)
  positive(-2)
end)
case("a frame sways", function() near(1, 1, 0, "sway") end)
checks.done()
]]

case("a failing case is reported with its lines, and the others run", function()
  local status, printed, complaint = run(three)
  equal(status, 1, "status")
  equal(printed, "ok      a beam sags\nFAILED  a column buckles\n        inner_test.lua:8: the load is 3 N\n"
    .. "        inner_test.lua:9 > 4: x is -2\nok      a frame sways\n", "printed")
  equal(complaint, "inner: 1 of 3 cases failed:\n  a column buckles\n", "on stderr")
end)

case("a file whose cases all pass ends with status 0 and counts them", function()
  local status, printed = run((three:gsub("1 > 2", "2 > 1"):gsub("%-2", "2")))
  equal(status, 0, "status")
  expect(printed:find("\ninner: 3 cases, 5 checks passed\n", 1, true), "printed: %s", printed)
end)

case("an error in a case fails it alone, with its message and line", function()
  local status, printed, complaint = run [[
case("no such call", function() local s = {} s.call() end)
case("after it", function() expect(true, "x") end)
checks.done()
]]
  equal(status, 1, "status")
  expect(printed:find("FAILED  no such call\n +inner_test.lua:5: attempt to call")
    or printed:find("FAILED  no such call\n[^\n]*inner_test.lua:5: attempt to call"), "printed: %s", printed)
  expect(printed:find("\nok      after it\n", 1, true), "the case after it: %s", printed)
  equal(complaint, "inner: 1 of 2 cases failed:\n  no such call\n", "on stderr")
end)

case("a value that is not a number fails its case", function()
  for _, check in ipairs { "near(0 / 0, 1, 0.1, 'x')", "near(1, 0 / 0, 0.1, 'x')", "near(1, 1, 0 / 0, 'x')",
    "expect(0 / 0 > 0, 'x')", "checks.equal(0 / 0, 0 / 0, 'x')" } do
    local status, printed = run(("case('NaN', function() %s end)\nchecks.done()\n"):format(check))
    equal(status, 1, check)
    expect(printed:find("FAILED  NaN\n", 1, true), "%s: %s", check, printed)
  end
end)

case("case=TEXT runs the cases with that text in their name, and hides the argument from the test", function()
  local status, printed = run(three, "build case=SAG other")
  equal(status, 0, "one that passes alone")
  equal(printed, "ok      a beam sags\ninner: 1 case, 1 checks passed\n", "printed")
  equal(run(three, "case=column"), 1, "one that fails alone")
  status, printed = run([[case('arguments', function() checks.equal(table.concat(arg, ' '), 'build other', 'arg') end)
checks.done()
]], "build case=arg other")
  equal(status, 0, printed)
end)

case("HINGE_CASE chooses as case=TEXT does", function()
  local status, printed = run(three, "build", "HINGE_CASE=sways")
  equal(status, 0, "status")
  expect(printed:find("^ok      a frame sways\ninner: 1 case,"), "printed: %s", printed)
end)

case("case=list names the cases and runs none", function()
  local status, printed = run(three, "case=list")
  equal(status, 0, "status")
  equal(printed, "a beam sags\na column buckles\na frame sways\n", "printed")
end)

case("a text that is in no name is an error that lists the names", function()
  local status, _, complaint = run(three, "case=arch")
  equal(status, 1, "status")
  equal(complaint, "inner: no case has 'arch' in its name; the cases are:\n  a beam sags\n  a column buckles\n"
    .. "  a frame sways\n", "on stderr")
end)

case("a test that cannot fail is an error", function()
  for text, wanted in pairs {
    ["checks.done()"] = "inner: the file has no case",
    ["case('a', function() end)\nchecks.done()"] = "inner: 1 of 1 cases failed:\n  a",
    ["case('a', function() expect(true, '') end)"] = "inner: the file ended before checks.done()",
    ["case('a', function() expect(true, '') end)\nexpect(true, 'b')\nchecks.done()"] = "a check outside of a case: b",
    ["case('a', function() expect(true, '') end)\ncase('a', print)"] = "two cases have this name: a",
    ["case('a', function() case('b', print) end)\nchecks.done()"] = "inner: 1 of 1 cases failed:\n  a",
    ["case('', print)"] = "case(name, function)",
  } do
    local status, printed, complaint = run(text .. "\n")
    equal(status, 1, text)
    expect(complaint:find(wanted, 1, true), "%s: says %s", text, printed .. complaint)
  end
end)

case("a test that cannot run here is skipped with status 77", function()
  local status, printed = run "checks.skip 'no browser'\n"
  equal(status, 77, "status")
  equal(printed, "inner: skipped: no browser\n", "printed")
end)

checks.done()

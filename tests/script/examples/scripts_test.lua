-- Every script that a newcomer learns from gives the numbers that its head states, under
-- the program and under plain Lua.
--
-- A head says `name = number within number`, with % behind it for a part of the number, or `name = number exactly`, of
-- each number that the script returns and of no other.
--
-- Run: lua5.4 tests/script/examples/scripts_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "scripts"
local case = checks.case
local quote, expect, equal = support.quote, checks.expect, checks.equal
local program, lua = quote(arg[1] .. "/hinge"), ("LUA_CPATH=%s lua5.4"):format(quote(arg[1] .. "/?.so"))

-- { name = { value, tolerance } } of a head; tolerance nil: exactly.
local function stated(head)
  local all = {}
  for name, value, rest in head:gmatch "([%a_][%w_]*) = (%-?[%d.]+) ([^\n]*)" do
    local within, part = rest:match "^within ([%d.]+) ?(%%?)"
    value, within = tonumber(value), tonumber(within)
    if within then all[name] = { value, part == "%" and within / 100 * math.abs(value) or within }
    elseif rest:find "^exactly" then all[name] = { value, 0 } end
  end
  return all
end

local function as_stated(results, head)
  for name, wanted in pairs(stated(head)) do
    local value = results[name]
    if type(value) ~= "number" then
      return false, ("%s is stated, the script returns %s"):format(name, tostring(value))
    end
    if not (math.abs(value - wanted[1]) <= wanted[2]) then
      return false, ("%s is %.8g, the head says %.8g within %.3g"):format(name, value, wanted[1], wanted[2])
    end
  end
  for name in pairs(results) do
    if not stated(head)[name] then return false, name .. " is returned, the head does not say what to expect" end
  end
  return next(results) ~= nil, "no number is stated"
end

case("every scene prints, returns and plans what its head says, in the program and in plain Lua", function()
  local listed = assert(support.read(support.root .. "scripts/README.md"))
  -- plain Lua draws where it is started
  local out, plain_folder = support.temporary_folder(), support.temporary_folder()
  local root = support.output("realpath " .. quote(support.root)):gsub("\n$", "/")
  local paths = support.output(("cd %s && ls scripts/[0-9]*.lua scripts/rules/*.lua"):format(quote(root)))
  local count = 0
  for path in paths:gmatch "[^\n]+" do
    count = count + 1
    local head = support.read(support.root .. path):match "^(.-)\nlocal "
    local here = "cd " .. quote(root) .. " && "
    local status, printed, complaint = support.run(("%s%s run %s --out %s"):format(here, program, path, out))
    if equal(status, 0, path .. ": exit status; " .. complaint) then
      local summary = support.json(support.read(out .. "/summary.json"))
      expect(as_stated(summary.results, head))
      -- What the head states is what is compared: every number in it, changed, is noticed.
      for name, wanted in pairs(stated(head)) do
        local changed = wanted[1] + 2.5 * wanted[2] + (wanted[2] == 0 and 1 or 0)
        local off = {}
        for key, value in pairs(summary.results) do off[key] = key == name and value + changed - wanted[1] or value end
        expect(not as_stated(off, head), "%s: %s may be another number", path, name)
      end
      local plain_status, plain = support.run(("cd %s && %s %s"):format(plain_folder, lua, quote(root .. path)))
      equal(plain_status, 0, path .. ": exit status under lua5.4")
      equal(plain, (printed:gsub("written to [^\n]*\n", "")), path .. ": what it prints under lua5.4")
    end
    local planned, plan = support.run(("%s%s plan %s"):format(here, program, path))
    expect(planned == 0 and not plan:find "needs results, so it", "%s: hinge plan says: %s", path,
      plan:match "[^\n]*\n$")
    expect(head:find("hinge run " .. path, 1, true), "%s: the head does not say how to run it", path)
    local _, lines = support.read(support.root .. path):gsub("\n", "")
    expect(lines <= 70, "%s has %d lines", path, lines)
    expect(listed:find(("](%s)"):format(path:match "^scripts/(.*)"), 1, true), "scripts/README.md does not list %s",
      path)
  end
  expect(count > 15, "ran %d scripts", count)
  expect(support.is_there(plain_folder .. "/lost_column.png") or not support.is_there(arg[1] .. "/libhinge_output.so"),
    "plain Lua draws no picture where it is started")
end)

checks.done()

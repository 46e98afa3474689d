-- hinge study --resume and a second hinge cost after a file has changed that the script reads, wherever it reads it.
--
-- Run: lua5.4 tests/script/study/read_files_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "read files"
local case, expect, equal = checks.case, checks.expect, checks.equal
local quote = support.quote
local program = quote(arg[1] .. "/hinge")

local folder = support.temporary_folder()
local function path(name) return folder .. "/" .. name end
local function run(words, before)
  return support.run(("cd %s && %s %s %s"):format(quote(folder), before or "", program, words))
end

-- What reads a value: the code, and the files with the value k in them.
local function data(k) return { ["data.txt"] = k .. "\n" } end
local ways = {
  ["io.open"] = { 'local f = io.open "data.txt" local v = tonumber(f:read "a") f:close() return v', data },
  ["io.open for binary data"] = { 'local f = io.open("data.txt", "rb") local v = f:read "n" f:close() return v', data },
  ["io.lines"] = { 'for l in io.lines "data.txt" do return tonumber(l) end', data },
  ["io.input"] = { 'io.input "data.txt" local v = io.read "n" io.close(io.input()) return v', data },
  ["hinge.record"] = {
    'return hinge.record.read { file = "data.txt", unit = "m/s^2", dt = 1 }.peak',
    function(k) return { ["data.txt"] = ("0\n%d\n0\n"):format(k) } end },
  ["dofile"] = { 'return dofile "data.lua"', function(k) return { ["data.lua"] = "return " .. k } end },
  ["loadfile"] = { 'return loadfile "data.lua" ()', function(k) return { ["data.lua"] = "return " .. k } end },
  ["require"] = { 'return require "data"', function(k) return { ["data.lua"] = "return " .. k } end },
  ["a module of a module"] = { 'return require "first"', function(k)
    return { ["first.lua"] = 'return require "second"', ["second.lua"] = "return " .. k } end },
  ["a file that is not always there"] = {
    'local f = io.open "more.txt" local v = f and f:read "n" or 1 if f then f:close() end return v',
    function(k) return k > 1 and { ["more.txt"] = tostring(k) } or {} end },
}
local names = {}
for name in pairs(ways) do names[#names + 1] = name end
table.sort(names)

local function write(files)
  for name, text in pairs(files) do support.write(path(name), text) end
end
local function answers(out)
  local list, column = {}, nil
  for line in (support.read(path(out .. "/results.csv")) or ""):gmatch "[^\n]+" do
    local items = {}
    for item in (line .. ","):gmatch "([^,]*)," do items[#items + 1] = item end
    for i, item in ipairs(not column and items or {}) do column = item == "y" and i or column end
    list[#list + 1] = items[column or 1]
  end
  return table.concat(list, " ", 2)
end

local scenario = [[
package.path = "./?.lua;" .. package.path
local hinge = require "hinge"
local function read() %s end
local value = %s
return hinge.scenario { parameters = { a = 1 }, accuracy = { dt = { 1e-4, 2e-4 } }, run = function(p)
  return { y = p.a * (value or read()) }
end }
]]
for i, name in ipairs(names) do
  local code, files = ways[name][1], ways[name][2]
  case("study --resume after a change of what is read by " .. name .. ", at the top or in a case", function()
    for at, value in pairs { top = "read()", inside = "nil" } do
      local out, script = ("s%d%s"):format(i, at), ("s%d%s.lua"):format(i, at)
      for _, file in ipairs { "data.txt", "data.lua", "more.txt" } do os.remove(path(file)) end
      write(files(1))
      support.write(path(script), scenario:format(code, value))
      equal(run(("study %s a=1,2 -j 1 --out %s"):format(script, out)), 0, "status")
      equal(answers(out), "1 2", at .. ": the answers")
      local _, _, said = run(("study %s a=1,2,3 -j 1 --out %s --resume"):format(script, out))
      expect(not said:find "has changed", "%s: nothing has changed: %s", at, said)
      equal(answers(out), "1 2 3", at .. ": the answers with one more")
      write(files(100))
      local status
      status, _, said = run(("study %s a=1,2,3 -j 1 --out %s --resume"):format(script, out))
      equal(status, 0, "status")
      expect(said:find "has changed: 3 cases run again", "%s: what it says: %s", at, said)
      equal(answers(out), "100 200 300", at .. ": the answers after the change")
    end
  end)
end

case("hinge.study in a script sees a change of what the script reads at its top", function()
  for _, how in ipairs { program .. " run -q", "LUA_CPATH=" .. quote(arg[1] .. "/?.so") .. " LUA_PATH="
    .. quote(support.root .. "lua/?.lua;" .. support.root .. "lua/?/init.lua;;") .. " lua5.4" } do
    write(data(1))
    support.write(path "own.lua", [[
local hinge = require "hinge"
local f = io.open "data.txt" local value = f:read "n" f:close()
local s = hinge.scenario { parameters = { a = 1 }, run = function(p) return { y = p.a * value } end }
local of = hinge.study(s, { vary = { a = { 1, 2 } }, out = "own", jobs = 1, resume = true })
print(of.cases[1].results.y, of.cases[2].results.y)
]])
    support.output("rm -rf " .. quote(path "own"))
    local function go() return select(2, support.run(("cd %s && %s own.lua"):format(quote(folder), how))) end
    expect(go():find "1%s2\n", "before the change")
    write(data(100))
    local printed = go()
    expect(printed:find "100%s200\n", "after the change: %s", printed)
  end
end)

case("what the script writes itself, and the table of the cases, make no case run again", function()
  support.write(path "w.lua", [[
local hinge = require "hinge"
local f = io.open("scratch.txt", "a") f:write "x" f:close()
f = io.open "scratch.txt" local n = #f:read "a" f:close()
return hinge.scenario { parameters = { a = 1 }, run = function(p) return { y = p.a } end }
]])
  support.write(path "rows.csv", "a\n1\n2\n")
  equal(run "study w.lua --table rows.csv -j 1 --out w", 0, "status")
  support.write(path "rows.csv", "a\n1\n2\n3\n")
  local status, _, said = run "study w.lua --table rows.csv -j 1 --out w --resume"
  expect(status == 0 and not said:find "run again", "status %s: %s", status, said)
  equal(answers "w", "1 2 3", "the answers")
end)

case("a second hinge cost after a change of what the script reads measures anew", function()
  local script = [[
package.path = "./?.lua;" .. package.path
local hinge = require "hinge"
local function read() %s end
local value = %s
return hinge.scenario { parameters = { dt = 1e-3 }, accuracy = { dt = { 1e-3, 2e-3 } }, run = function(p)
  local model = hinge.model {}
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:fix(a)
  model:member { a, b, section = hinge.section.solid { width = 0.1, depth = 0.1 },
    material = hinge.material { E = 210e9, density = 7850 } }
  model:load { node = b, force = { 0, 0, -1e3 * (value or read()) } }
  local run = model:dynamic { dt = p.dt, duration = 0.02 }:finish()
  return { uz = select(3, b:displacement(run)) }
end }
]]
  for _, name in ipairs { "io.open", "require" } do
    for at, value in pairs { top = "read()", inside = "nil" } do
      local code, files = ways[name][1], ways[name][2]
      local out = "cost_" .. name:gsub("%W", "") .. at
      for _, file in ipairs { "data.txt", "data.lua" } do os.remove(path(file)) end
      write(files(1))
      support.write(path "c.lua", script:format(code, value))
      local function largest()
        local _, _, said = run(("cost c.lua --out %s"):format(out))
        local most = 0
        for number in (support.read(path(out .. "/finished.lua")) or ""):gmatch '%["uz"%]=(%-?[%d.e+-]+)' do
          if not (math.abs(tonumber(number)) <= most) then most = math.abs(tonumber(number)) end
        end
        return most, said
      end
      local first = largest()
      local again, said = largest()
      expect(again == first and not said:find "has changed", "%s, %s: nothing has changed: %s", name, at, said)
      write(files(100))
      again, said = largest()
      expect(said:find "has changed: %d+ measurements are made again", "%s, %s: what it says: %s", name, at, said)
      expect(math.abs(again / first - 100) < 1, "%s, %s: %g, then %g", name, at, first, again)
    end
  end
end)

case("a comma without a value is refused, and names what it is in", function()
  support.write(path "v.lua", scenario:format("", "1"))
  for _, words in ipairs { "a=,1", "a=1,", "a=1,,2", "a=1, ,2", "'a={1,,2}'" } do
    local status, _, said = run(("study v.lua %s --out v"):format(words))
    equal(status, 2, "status of " .. words)
    expect(said:find "a=", "message: %s", said)
  end
  local status, _, said = run "study v.lua --cases x,,y --out v"
  expect(status == 2 and said:find("--cases x,,y", 1, true), "cases: %s", said)
end)

checks.done()

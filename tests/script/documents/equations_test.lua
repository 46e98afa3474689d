-- The table of the paper's equations in src/README.md: every equation has a row, and where a row points to, the file
-- has that function, with the equation's number in a comment. In src/theory.md a heading names every equation, and the
-- functions that it names are there. What src/README.md says of the folders and of where else to look is so.
--
-- Run: lua5.4 tests/script/documents/equations_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "equations"
local case, expect = checks.case, checks.expect

local paper = "1, 2, 3, 4, 5, 6a-b, 7a-c, 8a-b, 9a-b, 10a-c, 11a-b, 12a-c, 13a-b, 14, 15, 16, 17, 18, 19, 20a-c"

-- "6a-b, 14" -> { "6a", "6b", "14" }
local function numbers(text)
  local list = {}
  for number, first, last in text:gmatch "(%d+)(%l?)%-?(%l?)" do
    if first == "" then list[#list + 1] = number end
    for letter = first:byte() or 1, (last ~= "" and last or first):byte() or 0 do
      list[#list + 1] = number .. string.char(letter)
    end
  end
  return list
end

-- Whether a text has the number after "eq", or in a list after "eqs": "eqs 7b, 10b and 12b", "eqs 11a-b and 12a".
local function cites(text, wanted)
  text = text:gsub("%s*\n%s*///?%s*", " ") -- a comment of several lines
  for list in text:gmatch "%f[%a][Ee]qs?%s+([%dabc,%- and]+)" do
    for _, number in ipairs(numbers(list)) do
      if number == wanted then return true end
    end
  end
end

-- The comments at and in what a file says of a function or a constant: above each line that has its name, and up to
-- the end of a body that begins there. Nil: the name is only in comments.
local function comments_of(lines, name)
  local found
  for i, line in ipairs(lines) do
    local code = line:gsub("//.*", "")
    if code:find("%f[%w_]" .. name .. "%f[^%w_]") then
      found = found or {}
      local first, last = i, i
      while (lines[first - 1] or ""):find "^%s*//" or (lines[first - 1] or ""):find "^%s*template" do
        first = first - 1
      end
      while lines[last + 1] and not lines[last]:gsub("%s*//.*", ""):find "[;{}]$" do last = last + 1 end
      if lines[last]:gsub("%s*//.*", ""):find "{$" then
        local closing = "^" .. line:match "^%s*" .. "}"
        while lines[last + 1] and not lines[last]:find(closing) do last = last + 1 end
      end
      for at = first, last do found[#found + 1] = lines[at]:match "//.*" end
    end
  end
  return found and table.concat(found, "\n")
end

local function lines_of(text)
  local lines = {}
  for line in text:gmatch "([^\n]*)\n" do lines[#lines + 1] = line end
  return lines
end

-- Comments at `function` (`file`), which a text names; nil and a complaint where it is not there. `who` names it.
local function comments_at(name, path, who)
  local text = support.read(support.root .. "src/" .. path)
  if not expect(text, "src/%s is not there; %s points to it", path, who) then return end
  local comments = comments_of(lines_of(text), name:match "[%w_]+$")
  return expect(comments, "src/%s has no %s; %s points to it", path, name, who) and comments
end

local place = "`([%w_:]+)` %(`([%w_/]+%.%l+)`%)"
local readme = assert(support.read(support.root .. "src/README.md"))
case("functions that a text names in a file are there", function()
  local rows = assert(readme:match "\n| eq | what | where |\n[|%-]+\n(.-)\n\n",
    "src/README.md has no table of equations")
  local listed = {}
  for row in rows:gmatch "[^\n]+" do
    local equations, where = row:match "^| ([^|]+) | [^|]+ | (.+) |$"
    assert(equations, "this row of the table has not three columns: " .. row)
    local places = 0
    for name, path in where:gmatch(place) do
      places = places + 1
      local comments = comments_at(name, path, "eq " .. equations)
      for _, number in ipairs(comments and numbers(equations) or {}) do
        expect(cites(comments, number), "src/%s: no comment at %s has eq %s", path, name, number)
      end
    end
    expect(places > 0, "eq %s points to no `function` (`file`)", equations)
    for _, number in ipairs(numbers(equations)) do listed[number] = true end
  end
  for _, number in ipairs(numbers(paper)) do expect(listed[number], "eq %s has no row", number) end
end)

case("the files that src/README.md points to are there", function()
  -- Where else to look: the files are there, and no two rows name the same ones.
  local seen = {}
  for what, where in readme:match "\n## Where else to look\n(.*)$":gmatch "\n| ([^\n]-) | ([^\n]-) |%f[\n\0]" do
    local files = {}
    for path in where:gmatch "`([%w_]+[/%.][%w_/%.]+)`" do
      local from = support.is_there(support.root .. path) and "" or "src/"
      local named_alone = not path:find "/" -- in the folder of the file before it
      expect(named_alone or support.is_there(support.root .. from .. path), "'%s': %s is not there", what, path)
      files[#files + 1] = path
    end
    local first = table.concat(files, ", ", 1, math.min(2, #files))
    expect(#files < 2 or not seen[first], "'%s' and '%s' name the same files", what, seen[first])
    seen[first] = what
  end
end)

case("src/theory.md has a heading for every equation, and its functions are there", function()
  local theory = assert(support.read(support.root .. "src/theory.md"))
  local headed, section = {}, nil
  for heading in theory:gmatch "\n### (Eqs? [^\n]*)" do headed[#headed + 1] = heading end
  headed = table.concat(headed, "; ")
  for _, number in ipairs(numbers(paper)) do expect(cites(headed, number), "theory.md: no heading has eq %s",
    number) end
  -- `a`, `b` (`file`): both are there; a line may end between any two
  theory = theory:gsub("(`[%w_:]+`),%s+(`[%w_:]+`)%s+(%(`[%w_/]+%.%l+`%))", "%1 %3, %2 %3"):gsub("`\n%(`", "` (`")
  local places = 0
  for _, line in ipairs(lines_of(theory)) do
    section = line:match "^##+ (.*)" or section
    for name, path in line:gmatch(place) do
      places = places + 1
      comments_at(name, path, "theory.md, " .. section)
    end
  end
  expect(places > 50, "theory.md points to %d functions", places)
  for path in theory:gmatch "`(tests/[%w_/]+%.%l+)`" do
    expect(support.is_there(support.root .. path), "theory.md points to %s, which is not there", path)
  end
end)

checks.done()

-- Words that the tree no longer uses, since structural engineers have others for the same things. No text of src, lua,
-- tests, scripts or README holds one of them, be it in prose, a message or a name.
--
-- Run: lua5.4 tests/script/words_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
local support = require "support"
local checks = support.checks "words"

-- Dropped words, and what to write in their place. Each may stand in an identifier too, between underscores.
local dropped = {
  ["ledger ledgers"] = "energy balance",
  ["remainder remainders"] = "energy error",
  ["booked unbooked"] = "counted",
  ["stub stubs"] = "rigid offset mass, or what is left of a broken element",
  ["hung"] = "attached",
  ["bond bonds bonded"] = "tie",
  ["let-go lets-go letting-go"] = "release",
  ["kick kicks kicked"] = "impulse",
  ["heed heeds heeded"] = "check, take up",
  ["judge judges judged judging"] = "compare, check",
  ["pace paces"] = "speed, step size",
  ["freedom freedoms"] = "degree of freedom",
  ["to-the-letter"] = "as printed",
  ["by-turns"] = "alternately",
  ["energy-turned-over"] = "the largest energy",
  ["end-by-itself ends-by-itself ended-by-itself end-by-themselves ended-by-themselves"] = "fail",
  ["unaccounted"] = "energy error",
  ["heap-of-sand heaps-of-sand"] = "sand-heap analogy",
  ["hands-in handed-in"] = "give, pass",
  ["askew"] = "inclined",
  ["amidships"] = "in the middle of the fuselage",
  ["laborious"] = "slow",
  ["stands-without-a-name"] = "has no name",
}

-- Legitimate uses: where, a pattern of the path; the word; what stands before it, a pattern, or any; why.
local allowed = {
  { "", "freedom", before = "[Dd]egrees?[%s/*_-]+of[%s/*_-]+$", why = "the engineers' term" },
  { "", "freedom", before = '"? of $', why = "the same, where singular and plural are chosen by a program" },
  { "", "remainder", before = '[.,"`_]$', why = "key of summary.json, history.csv and run.energy" },
  { "^lua/hinge/hinge%.d%.lua$", "remainder", before = "@field $", why = "the same key" },
  { "^lua/hinge/library%.d%.lua$", "remainder", before = "contact, $", why = "the same key, of impact.result" },
  { "^src/viewer/src/", "remainder", why = "the same key, in history.csv" },
  { "^lua/hinge/cost/", "remainder", why = "the same key, in cost.csv, effects.csv and the results" },
}
local skipped = { -- files that are not looked at
  ["tests/script/words_test.lua"] = "it lists the words",
  ["lua/hinge/viewer.js"] = "made from src/viewer, which is looked at, and three.js",
  ["lua/hinge/reference.md"] = "made from hinge.d.lua and library.d.lua",
}

local function is_allowed(path, word, before)
  for _, a in ipairs(allowed) do
    if a[2] == word and path:find(a[1]) and (not a.before or before:find(a.before)) then return true end
  end
  return false
end

-- Line of a place in a text.
local function line_at(text, at)
  local _, breaks = text:sub(1, at):gsub("\n", "")
  return breaks + 1
end

-- Adds "path:line: word: what to write" for each place of a word in a text; its parts may stand on two lines.
local function look_for(word, instead, path, text, lower, found)
  local first, rest = word:match "^(%a+)(.*)$"
  local pattern = "^" .. first .. rest:gsub("%-(%a+)", "[%%s/*_-]+%1") .. "%f[%A]"
  local at = 0
  while true do
    at = lower:find(first, at + 1, true)
    if not at then return end
    local bounded = at == 1 or not lower:find("^%a", at - 1)
    if bounded and lower:find(pattern, at) and not is_allowed(path, word, text:sub(math.max(1, at - 40), at - 1)) then
      found[#found + 1] = ("%s:%d: '%s': write %s"):format(path, line_at(text, at), (word:gsub("-", " ")), instead)
    end
  end
end

local function look_at(path, text)
  local found, lower = {}, text:lower()
  for words, instead in pairs(dropped) do
    for word in words:gmatch "%S+" do look_for(word, instead, path, text, lower, found) end
  end
  table.sort(found)
  return found
end

-- The files that git tracks, and new ones; without a repository, all that are there.
local function files()
  local list, here = {}, "cd " .. support.quote(support.root) .. " && "
  local status, listed = support.run(here .. "git ls-files --cached --others --exclude-standard -- src lua tests "
    .. "scripts README.md")
  if status ~= 0 or listed == "" then
    listed = support.output(here .. "find src lua tests scripts README.md -type f")
  end
  for path in listed:gmatch "[^\n]+" do
    if not path:find "%.png$" and not skipped[path] then list[#list + 1] = path end
  end
  return list
end

-- It finds them: in any case, in names, over two lines; not inside other words, nor where they are allowed.
local planted = "The Ledger\nno pledger, stubborn\nplastic_stub\nthey let\n// go of it, six degrees of freedom, free "
  .. "freedoms\nenergy.remainder is the remainder\n"
local says = table.concat(look_at("src/a.cpp", planted), "\n")
checks.equal(says, table.concat({ "src/a.cpp:1: 'ledger': write energy balance",
  "src/a.cpp:3: 'stub': write rigid offset mass, or what is left of a broken element",
  "src/a.cpp:4: 'let go': write release", "src/a.cpp:5: 'freedoms': write degree of freedom",
  "src/a.cpp:6: 'remainder': write energy error" }, "\n"), "planted words")

local counts = { src = 0, lua = 0, tests = 0, scripts = 0, ["README.md"] = 0 } -- by what stands at the top
for _, path in ipairs(files()) do
  local text = support.read(support.root .. path)
  if text then -- a file that is deleted, but not yet in git
    local top = path:match "^[^/]*"
    counts[top] = counts[top] + 1
    for _, found in ipairs(look_at(path, text)) do checks.expect(false, "%s", found) end
  end
end
for top, least in pairs { src = 100, lua = 50, tests = 100, scripts = 30, ["README.md"] = 1 } do
  checks.expect(counts[top] >= least, "looked at %d files of %s", counts[top], top)
end
checks.done()

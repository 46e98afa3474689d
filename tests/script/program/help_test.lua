-- hinge reference NAME and -s WORD, and help at the prompt: what they print of a call, a class, a field, a value and a
-- word, what they say of names that nothing has, and with which exit status.
--
-- Run: lua5.4 tests/script/program/help_test.lua BUILD_FOLDER, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
require "hinge"
local reference, overview = require "hinge.program.reference", require "hinge.program.help".overview
local checks = support.checks "help"
local case, ended = checks.case, checks.ended
local quote, run, expect, equal = support.quote, support.run, checks.expect, checks.equal
local program = quote(arg[1] .. "/hinge")

-- hinge reference -----------------------------------------------------------------------------------------------------

local function asks(arguments) return run(program .. " reference " .. arguments) end
local function headings(text)
  local list = {}
  for heading in text:gmatch "%f[^\n%z]#+ `([^`]*)`" do list[#list + 1] = heading end
  return table.concat(list, " ")
end

case("hinge reference NAME prints the declaration, the guide page and near names", function()
  equal(ended(0, "", asks "model:fix"), [[
#### `model:fix(node, what?)`

Fixes degrees of freedom of one node or of a list of nodes, in addition to those that are already fixed.

- `node`: `hinge.node|hinge.node[]`
- `what?`: `string` — "all" (default), or letters: "xyz" displacements, "rx", "ry", "rz" rotations, as in "x,y,rx"

```lua
model:fix(wall) -- all six
model:fix({ wall, tip }, "y,rx,rz") -- bends in the plane of x and z alone
```
]], "model:fix")
  for name, wanted in pairs {
    ["damping"] = "model:damping(options) hinge.damping_options",
    ["model.damping"] = "model:damping(options) hinge.damping_options",
    ["MODEL:GRAVITY"] = "model:gravity(acceleration, load_case?)",
    ["section.box"] = "hinge.section.box(options) hinge.box_options",
    ["hinge.section.box"] = "hinge.section.box(options) hinge.box_options",
    ["box"] = "hinge.section.box(options) hinge.box_options",
    ["hinge.energy"] = "hinge.energy",
    ["node"] = "hinge.node member:node(after) model:node(position) grid:node(place, storey?)",
    ["run.energy"] = "hinge.energy",
    ["vec3"] = "vec3",
    ["aircraft.add"] = "aircraft.add(model, options?) aircraft.options",
  } do
    equal(headings(ended(0, "", asks(name))), wanted, "headings of " .. name)
  end
  ended(0, "- `node:reaction(run?)`", asks "hinge.node") -- a class lists its functions
  ended(0, "`hinge.contact_rule`\n\n- `friction?`: `number` — surface: Coulomb", asks "friction") -- a field its class
  ended(0, "Fields with this name: `hinge.run.verdict`, `hinge.study_case.verdict`, `hinge.robustness_row.verdict`",
    asks "verdict")
  equal(select(2, asks "examples"), "Every example runs as it stands after these lines.\n\n```lua\n"
    .. reference.preamble .. "\n```\n", "what examples start from")

  for name, message in pairs {
    ["dampng"] = "hinge: nothing is called 'dampng' (did you mean 'damping'?); `hinge reference` prints everything, "
      .. "`hinge reference -s WORD` searches it\n",
    ["corotational"] = "hinge: nothing is called 'corotational' (did you mean 'rotation_x'?); `hinge reference -s "
      .. "corotational` finds 1 mention of it\n",
    ["-s nowhereatall"] = "hinge: the reference does not mention 'nowhereatall'\n",
    ["-s dampng"] = "hinge: the reference does not mention 'dampng' (did you mean 'damping'?)\n",
  } do
    local said, complaint = ended(2, "", asks(name))
    equal(said .. complaint, message, name)
  end
  ended(2, "", asks "node -s word")
  equal(ended(0, "", asks "--search Rayleigh"), [[
model:damping(options)
    Rayleigh damping in dynamics, C = alpha M + beta K of each element (Rayleigh 1877, section 81): by ...
hinge.energy.damping
    dissipated by Rayleigh damping, where model:damping is declared
]], "what a search prints")
end)

case("hinge reference finds a call by words that the reference does not use", function()
  for words, wanted in pairs {
    ["-s drift"] = "'drift': see results.storeys, node:displacement (hinge.results.storeys has the drift and the shear "
      .. "force of each storey)",
    ["-s diaphragms"] = "'diaphragms': see model:rigid_link, model:diaphragm (...)",
    ["-s inter-storey-drift"] = "...",
    ["-s storey-drift"] = "'storey-drift': see results.storeys, node:displacement (...",
    ["-s earthquake"] = "'earthquake': see hinge.ground, model:move, hinge.record.read (...)",
    ["-s supports"] = "'supports': see model:fix, model:move (supports are fixed degrees of freedom of a node)\n\n...",
  } do
    local status_of, said = asks(words)
    equal(status_of, wanted == "..." and 2 or 0, "status of " .. words)
    expect(wanted == "..." or support.says((said:gsub("(%S)\n(%S)", "%1 %2")), wanted .. "..."), "%s: %s", words, said)
  end
end)

case("hinge reference of several words finds their page", function()
  equal(ended(2, "nothing is called 'soil'; 'soil' is not available; see model:ground, ", asks "soil"),
    "", "the name of what there is not")
end)

case("what the reference has is not denied", function()
  -- other words for what there is, and the call that they must lead to
  local words = require "hinge.program.other_words"
  for word, name in pairs { ["code check"] = "results.utilisation", ["design check"] = "results.utilisation",
    utilisation = "results.utilisation", eurocode = "results.utilisation", drift = "results.storeys",
    ["storey drift"] = "results.storeys", ["interstorey drift"] = "results.storeys", slab = "model:floor",
    floor = "model:floor", ["base shear"] = "results.base", envelope = "results.envelope",
    ["panel zone"] = "joint.panel_zone", connection = "hinge.joint", damper = "model:connector",
    ["column removal"] = "hinge.robustness", ["p delta"] = "hinge.model_options", wind = "hinge.pressure",
    ["effective length"] = "results.utilisation", isolator = "model:connector",
    ["natural period"] = "run:modes", ["load combination"] = "model:combination", fire = "model:heat" } do
    local known = words[word]
    expect(known and not known.missing and known.see[1] == name, "'%s' leads to %s", word, name)
    local status_of, said, complaint = asks("'" .. word .. "'")
    expect(not complaint:find("is not available", 1, true), "'%s': %d %s%s", word, status_of, said, complaint)
  end
  -- a word that is said to be missing is in no first sentence and no name of the reference
  for _, e in ipairs(reference.read()) do
    local text = ((e.name or "") .. " " .. (e.doc or ""):match "^[^.]*"):lower():gsub("wall time", "time")
    for word, known in pairs(words) do
      if known.missing then
        expect(not (" " .. text .. " "):find("[^%w]" .. word .. "s?[^%w]"), "'%s' is said to be missing; %s: %s", word,
          e.line, text)
      end
    end
  end
end)

local help, count = require "hinge.program.help", 0
case("hinge reference of an unknown name suggests near ones", function()
  for word, known in pairs(require "hinge.program.other_words") do
    count = count + 1
    for _, name in ipairs(known.see) do expect(help.text(name), "'%s': there is no %s to see", word, name) end
    expect(known.how ~= "" and #known.see > 0 and word == word:lower(), "'%s' tells nothing", word)
    for _, name in ipairs(known.missing and { word, word .. "s", (word:gsub(" ", "_")) } or {}) do
      expect(not help.text(name), "'%s' is said not to be available, and the reference has %s", word, name)
    end
  end
  expect(count > 40, "%d words", count)

  expect(select(2, asks "-s 'a blast of'"):find("model:load(options)\n    ... ", 1, true), "a search finds examples")
  for line in select(2, asks "-s element"):gmatch "[^\n]+" do
    expect(utf8.len(line) <= 120, "a line of %d columns: %s", utf8.len(line), line)
  end
end)

-- help at the prompt --------------------------------------------------------------------------------------------------

local function types(lines) return run(("printf %%s %s | %s -i"):format(quote(lines), program)) end
case("the overview of help names calls that the reference has, in 24 lines", function()
  local calls, lines, known = {}, 0, {}
  for _, e in ipairs(reference.read()) do
    if e.kind == "function" then known[reference.signature(e):match "^[^(]*"] = true end
  end
  local kind
  for line in overview:gmatch "[^\n]*\n" do
    lines = lines + 1
    expect(utf8.len(line) <= 121, "the overview is too wide: %s", line)
    for word in (line:match "^  (.*)" or ""):gmatch "[%w_]*[.:][%w_.:]+" do
      if word:find "^%." then word = kind .. word end
      kind = word:match "^(.*)[.:]"
      calls[#calls + 1] = word
      expect(known[word], "the overview names %s, which there is not", word)
    end
  end
  expect(lines <= 24 and #calls > 40, "the overview has %d lines and %d calls", lines, #calls)
end)

case("help at the prompt prints what is known of a name, and of values of the session", function()
  for _, typed in ipairs { "help", "help()" } do
    local said, complaint = ended(0, "", types(typed))
    expect(said == overview and complaint == "", "%s: %s%s", typed, said, complaint)
  end
  local beam = "m = hinge.model() a, b = m:node { 0, 0, 0 }, m:node { 1, 0, 0 } "
  for typed, wanted in pairs {
    ['help("damping")'] = "model:damping(options) hinge.damping_options",
    ["help(hinge.model().member)"] = "model:member(options) hinge.member_options",
    ["help(hinge.section.box)"] = "hinge.section.box(options) hinge.box_options",
    ["help(hinge.section)"] = "hinge.sections",
    ["help(hinge)"] = "hinge",
    ["help(hinge.note)"] = "hinge.note(text)",
    ["help(hinge.model())"] = "hinge.model",
    [beam .. "help(a)"] = "hinge.node",
    [beam .. "help(a.displacement)"] = "node:displacement(run?)",
    ['help(require "hinge.models.aircraft".add)'] = "aircraft.add(model, options?) aircraft.options",
    ['help "no such word at all"'] = "", ['help ""'] = "", ["help(3)"] = "", ["help(print)"] = "", ["help(nil)"] = "",
  } do
    local said, complaint = ended(0, "", types(typed))
    equal(headings(said), wanted, typed)
    equal(complaint == "", wanted ~= "", typed .. " says " .. complaint)
  end
  expect(select(3, types 'help "dampng"'):find("'dampng' (did you mean 'damping'?)", 1, true), "did you mean")
  expect(support.says(select(2, types 'help "Masing"'), "Nothing is called 'Masing' (did you mean 'missing'?). The "
    .. "reference mentions it here:\n\nhinge.joint(options)\n    ..."), "a word in the texts")
  equal(select(2, run(program .. " -e 'help \"hinge.note\"'")):match "^[^\n]*", "#### `hinge.note(text)`", "hinge -e")
end)

case("the guide's page on the prompt shows what the prompt prints", function()
  local guide = support.read(support.root .. "lua/guide/prompt.md")
  local session = guide:match "\n```\n%$ hinge %-i\n(.-)```\n"
  local keys, shown = {}, {}
  for line in session:gmatch "[^\n]+\n" do table.insert(line:find "^> " and keys or shown, (line:gsub("^> ", ""))) end
  expect(#keys == 4 and support.says(select(2, types(table.concat(keys))), table.concat(shown)),
    "the session in lua/guide/prompt.md: %s", select(2, types(table.concat(keys))))
  for command in guide:gmatch "\n| `hinge (reference[^`]*)` |" do
    ended(0, "", run(program .. " " .. command))
  end
  local one_liner = guide:match "`hinge (%-e '[^`]*')`"
  expect(select(2, run(program .. " " .. one_liner)):find "^[%d.e-]+\n$", "lua/guide/prompt.md: " .. one_liner)

  local script = support.temporary_folder() .. "/own.lua"
  support.write(script, "function help() return 'mine' end\n")
  local printed = select(2, run(("echo 'help()' | %s -i %s"):format(program, quote(script))))
  equal(printed, "mine\n", "a script's own help stays")
end)

checks.done()

-- Texts of others inside languages that hinge writes: each function of hinge.quote gets names made to break out, and a
-- reader of the language gives back what was meant, as one value. tests/README.md lists where they are used.
--
-- Run: lua5.4 tests/script/library/quoting_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "quoting"
local case, expect, equal = checks.case, checks.expect, checks.equal
local _ = require "hinge"
local core = require "hinge.core"
local quote = require "hinge.library.quote"
local program = support.quote((support.output("realpath " .. support.quote(arg[1] .. "/hinge")):gsub("%s+$", "")))
local folder = support.temporary_folder()

-- Pieces of which the names are made: quotes, ends of lines, of comments, of brackets, of elements; what starts
-- programs; formulas; control characters; marks that turn the direction of writing; bytes that are no UTF-8.
local pieces = { "'", '"', "''", '""', "`", "\n", "\r", "\r\n", "--", "]]", "[[", "]=]", "--[[", "!",
  "!touch x", "=1+1", "+1", "-1", "@SUM(A1)", "=", "\t=1", "|", "<", ">", "<!--", "-->", "</script>", "&",
  "&amp;", "]]>", "#", "#SBATCH", "$x", "$(touch x)", "${x}", "\\", "\\n", "\\\\", "%", "%d", "%%", ";", ",",
  "{", "}", "(", ")", " ", "  ", "\0", "\1", "\27[2J", "\127", "\u{202E}", "\u{2066}", "\u{200F}", "\u{061C}",
  "\u{2028}", "\u{FF1D}1", "é", "\xff", "\xe2\x80", "\xd8", "name", "a", "1", ".5", "~", "^", "_", "*", "?" }

-- All pieces alone and in pairs, and 3000 mixtures, the same each time.
local texts = {}
for _, piece in ipairs(pieces) do
  texts[#texts + 1] = piece
  texts[#texts + 1] = "a" .. piece .. "b"
  texts[#texts + 1] = piece .. piece
end
math.randomseed(20261128)
for _ = 1, 3000 do
  local parts = {}
  for i = 1, math.random(1, 6) do parts[i] = pieces[math.random(#pieces)] end
  texts[#texts + 1] = table.concat(parts)
end

local function spaced(text) return (text:gsub("%c", " ")) end -- one space for each control character
local turning = {}
for _, code in ipairs { 0x061C, 0x200E, 0x200F, 0x202A, 0x202B, 0x202C, 0x202D, 0x202E, 0x2066, 0x2067, 0x2068,
  0x2069 } do
  turning[#turning + 1] = utf8.char(code)
end
local function turns(text)
  for _, mark in ipairs(turning) do if text:find(mark, 1, true) then return true end end
  return false
end

-- Counts what is wrong, and shows the first.
local function all(f)
  local wrong = 0
  for _, text in ipairs(texts) do
    local good, why = f(text)
    if not good then
      wrong = wrong + 1
      if wrong < 4 then expect(false, "%q: %s", text, tostring(why)) end
    end
  end
  equal(wrong, 0, "texts that came out otherwise")
end

case("Lua: a literal is the text, on one line, with no marks that turn it", function()
  all(function(text)
    local literal = quote.lua(text)
    local f, problem = load("return " .. literal)
    return f and f() == text and not literal:find "%c" and not turns(literal), problem or literal
  end)
end)

case("comments: nothing of a text is code, in Lua, a shell or gnuplot", function()
  all(function(text)
    local comment = quote.comment(text)
    local f, problem = load("-- of " .. comment .. "\nreturn 1")
    return f and f() == 1 and not comment:find "[%c\\]" and not turns(comment), problem or comment
  end)
end)

case("gnuplot: what it prints is the text, and it starts nothing", function()
  local lines = {}
  for i, text in ipairs(texts) do
    lines[i] = ("# %s\nprint %s"):format(quote.comment(text), quote.gnuplot(text))
  end
  support.write(folder .. "/a.gp", table.concat(lines, "\n") .. "\n")
  local _, printed = checks.ended(0, "", support.run(("cd %s && gnuplot -d a.gp"):format(support.quote(folder))))
  local i = 0
  for line in printed:gmatch "([^\n]*)\n" do
    i = i + 1
    local wanted = spaced(texts[i])
    if not utf8.len(wanted) then wanted = wanted:gsub("[\x80-\xff]", "?") end
    if line ~= wanted then expect(false, "%q is printed as %q", texts[i], line) break end
  end
  equal(i, #texts, "lines")
  all(function(text) return quote.gnuplot_file(text):find "^['\"][%w_.]" ~= nil end)
  -- what stands at an axis is a format
  local last = "it's 50 % of %d"
  for k = 1, #texts + 300, 300 do
    core.draw_plot(folder .. "/b.svg", ("set terminal svg\nset output 'b.svg'\nset xtics (%s 1) noenhanced\n"
      .. "plot [0:2] x\n"):format(quote.gnuplot_label(texts[k] or last)), "")
  end
  expect((support.read(folder .. "/b.svg") or ""):find(last, 1, true), "the label of an axis")
  expect(not support.is_there(folder .. "/x"), "a program was started")
end)

case("shells: a text is one word", function()
  local plain, words = {}, {}
  for _, text in ipairs(texts) do
    if not text:find "\0" then plain[#plain + 1], words[#words + 1] = text, quote.shell(text) end
  end
  support.write(folder .. "/a.sh", "set -f\nprintf '%s\\0' " .. table.concat(words, " ") .. "\n")
  local printed = checks.ended(0, "", support.run(("cd %s && sh a.sh"):format(support.quote(folder))))
  local i = 0
  for word in printed:gmatch "([^\0]*)\0" do
    i = i + 1
    if word ~= plain[i] then expect(false, "%q is the word %q", plain[i], word) break end
  end
  equal(i, #plain, "words")
  equal(quote.shell "", "''", "an empty word")
end)

-- The fields of a line as RFC 4180 has them, or nil.
local function fields_of(line)
  local fields, at = {}, 1
  while true do
    local field, after
    if line:sub(at, at) == '"' then
      local parts = {}
      repeat
        local part, stop = line:match('^"([^"]*)"()', at)
        if not part then return nil end
        parts[#parts + 1], at = part, stop
      until line:sub(at, at) ~= '"'
      field, after = table.concat(parts, '"'), at
    else
      field, after = line:match('^([^,"]*)()', at)
    end
    fields[#fields + 1] = field
    if after > #line then return fields end
    if line:sub(after, after) ~= "," then return nil end
    at = after + 1
  end
end

case("CSV: a text is one field, on one line, and no formula", function()
  for _, plain in ipairs { true, false } do
    all(function(text)
      local field = quote.csv(text, plain)
      local got = fields_of("a," .. field .. ",b")
      if not got or #got ~= 3 or field:find "%c" then return false, field end
      local value, wanted = got[2], spaced(text)
      local formula = wanted:find "^[=+@-]." or wanted:find "^\u{FF1D}." or wanted:find "^\u{FF0B}."
      if formula and not wanted:find "^[+-]%d*%.?%d+$" then wanted = "'" .. wanted end
      return value == wanted and (plain or field:find '^"' ~= nil), field
    end)
  end
  for text, wanted in pairs { ["-1.5e3"] = "-1.5e3", ["=1+1"] = "'=1+1", ["-"] = "-", ["+a"] = "'+a",
    ["-1 a"] = "'-1 a",
    ["a;=1"] = '"a;=1"', ["-inf"] = "-inf", [""] = "" } do
    equal(quote.csv(text, true), wanted, text)
  end
end)

-- As sbatch reads the words of a line: a backslash keeps the next character, inside quotes or not; # begins a comment.
local function words_of_sbatch(line)
  local words, at, quoted = {}, 1, nil
  while at <= #line do
    while line:sub(at, at):find "%s" do at = at + 1 end
    local word = {}
    while at <= #line do
      local c = line:sub(at, at)
      if c == "\\" then
        at = at + 1
        word[#word + 1] = line:sub(at, at)
      elseif quoted then
        if c == quoted then quoted = nil else word[#word + 1] = c end
      elseif c:find "['\"]" then quoted = c
      elseif c == "#" then return words
      elseif c:find "%s" then break
      else word[#word + 1] = c end
      at = at + 1
    end
    words[#words + 1] = table.concat(word)
  end
  return not quoted and words or {}
end

case("#SBATCH: a text is part of one word, or refused", function()
  all(function(text)
    local good, value = pcall(quote.sbatch, "--out", text)
    if text:find "%c" then return not good, "not refused" end
    local words = words_of_sbatch("--output=" .. value .. "/x")
    return #words == 1 and words[1] == "--output=" .. text .. "/x", value
  end)
end)

case("JSON, and JSON in HTML: the text comes back, and no element begins", function()
  all(function(text)
    if not utf8.len(text) then return true end -- what is no text of Unicode is replaced
    local json = core.to_json { text }
    local inside = quote.json_in_html(json)
    local got = core.from_json(json)
    return got and got[1] == text and core.from_json(inside)[1] == text and not json:find "[\0-\31]"
      and not inside:find("<", 1, true) and not inside:find("\u{2028}", 1, true), inside
  end)
  expect(core.from_json(core.to_json { "\xff" }), "what is no Unicode still gives JSON")
end)

case("Markdown: a text is one cell of a table", function()
  all(function(text)
    local cell = quote.markdown(text)
    local bare = cell:gsub("\\[\\|`%[%]]", "")
    return not bare:find "[|<`%[%]%c]", cell
  end)
end)

case("LaTeX: no command, comment or end of a cell", function()
  all(function(text)
    local bare = quote.latex(text):gsub("\\textbackslash{}", ""):gsub("\\textasciitilde{}", "")
      :gsub("\\textasciicircum{}", ""):gsub("%$%-[%d.]+%$", ""):gsub("\\[&%%$#_{}]", "")
    return not bare:find "[\\&%%$#_{}~^\n]", bare
  end)
end)

case("whole files: names of groups and probes in CSV, frames and plots", function()
  local names, seen = {}, {}
  for i = 1, #texts, 41 do
    local name = texts[i]
    if utf8.len(name) and not name:find "\0" and not seen[name] then
      seen[name], names[#names + 1] = true, name
    end
  end
  local list = {}
  for i, name in ipairs(names) do list[i] = quote.lua(name) end
  support.write(folder .. "/s.lua", ([[
local hinge = require "hinge"
local names = { %s }
local model = hinge.model {}
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 1e6 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
local taken = {}
for i, name in ipairs(names) do
  local foot, tip = model:node { i, 0, 0 }, model:node { i, 0, 1 }
  model:fix(foot)
  local good = pcall(model.member, model, { foot, tip, section = bar, material = steel, group = name })
  if good then taken[#taken + 1] = name else model:member { foot, tip, section = bar, material = steel } end
  model:load { node = tip, force = { 1e4, 0, 0 } }
end
local run = model:dynamic { dt = 1e-4, duration = 5e-3 }:finish()
hinge.frame(run)
run:hinges { limit = 1e-6 }:write "h.csv"
hinge.plot({ series = { { name = names[1], x = { 1, 2 }, y = { 1, 2 } },
  { name = names[3], x = { 1, 2 }, y = { 2, 1 } } },
  title = names[2] }, "x.svg")
return { taken = #taken }
]]):format(table.concat(list, ", ")))
  checks.ended(0, "", support.run(("cd %s && %s run -q s.lua --out out"):format(support.quote(folder), program)))
  local known = {}
  for _, name in ipairs(names) do
    local wanted = spaced(name)
    known[wanted], known["'" .. wanted] = true, true
  end
  local count = 0
  for _, file in ipairs { "events.csv", "h.csv" } do
    local text = support.read(folder .. "/out/" .. file) or ""
    local head
    for line in text:gmatch "([^\n]*)\n" do
      local fields = fields_of(line)
      head = head or fields
      expect(fields and #fields == #head, "%s: %s", file, line)
      for i, name in ipairs(head) do
        if name == "group" and fields and line ~= table.concat(head, ",") and fields[i] ~= "" then
          expect(known[fields[i]], "%s: group %q", file, fields[i])
          expect(not fields[i]:find "^[=+@]." , "%s: a formula %q", file, fields[i])
          count = count + 1
        end
      end
    end
  end
  expect(count > 20, "%d names in the files", count)
  local box = core.frame_box(folder .. "/out/frames/frame_00001.vtp", {})
  local taken = core.from_json(support.read(folder .. "/out/summary.json")).results.taken
  equal(#box.groups, taken, "groups of the frame")
  for _, name in ipairs(box.groups) do
    local found = false
    for _, wanted in ipairs(names) do found = found or wanted == name end
    expect(found, "a group of the frame: %q", name)
  end
end)

checks.done()

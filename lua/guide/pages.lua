-- What make.lua and tests/script/documents/guide_test.lua share: the pages of the guide as blocks, and their scripts
-- run.
--
-- Of the fenced blocks of a page NAME.md
-- * the first one marked lua is the page's script, NAME.lua, whole; the build writes it into its folder guide/;
-- * those marked console are commands (after "$ ") and what they print, run in order in one folder that holds the
--   page's scripts; "…" stands for anything within a line, and a line "…" for any number of lines;
-- * every other block marked lua runs too: by itself where it requires hinge, else after the script, whose local
--   variables it sees;
-- * a block marked lua in an HTML comment is not shown to readers. It goes on where the block of Lua above it ends, and
--   compares numbers of the page with computed ones (claim.lua);
-- * those marked python are one program, which runs after the commands in their folder; a block marked text right below
--   one is what it prints. NAME.ipynb holds them as a notebook;
-- * all other blocks (sh, text) are only shown.
-- A picture pictures/FILE.png is one that the page's commands leave in a folder under out/.
local pages = { folder = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" }

package.path = pages.folder .. "../../tests/script/?.lua;" .. package.path
local support = require "support"
local quote = support.quote
pages.read, pages.write = support.read, support.write

--- The names of all pages, in the order of README.md.
function pages.names()
  local names = {}
  for name in pages.read(pages.folder .. "README.md"):gmatch "%]%(([%w_]+)%.md%)" do names[#names + 1] = name end
  return names
end

--- The fenced blocks of a text: { language =, text =, from =, to =, hidden = }, with the places of the text between the
--- fences, and whether it is in an HTML comment.
function pages.blocks(text)
  local blocks, at = {}, 1
  while true do
    local _, fence, language = text:find("%f[^\n%z]```(%w+)\n", at)
    if not fence then return blocks end
    local stop = assert(text:find("%f[^\n%z]```\n", fence + 1), "a block without an end: " .. language)
    local hidden = text:sub(fence - #language - 8, fence - #language - 4) == "<!--\n"
    blocks[#blocks + 1] = { language = language, text = text:sub(fence + 1, stop - 1), from = fence + 1, to = stop - 1,
      hidden = hidden }
    at = stop + 4
  end
end

--- A console block as { { command =, output = }, ... }.
function pages.commands(block)
  local list = {}
  for line in block:gmatch "([^\n]*)\n" do
    local command = line:match "^%$ (.*)$"
    if command then list[#list + 1] = { command = command, output = "" }
    elseif #list > 0 then list[#list].output = list[#list].output .. line .. "\n" end
  end
  return list
end

--- The script of a page, or nil where its first block of Lua is none.
function pages.script(name)
  local text = assert(pages.read(pages.folder .. name .. ".md"), "there is no " .. name .. ".md")
  for _, block in ipairs(pages.blocks(text)) do
    if block.language == "lua" then return block.text:find 'require "hinge"' and block.text or nil end
  end
end

--- Writes the scripts of all pages into a folder.
function pages.write_scripts(folder)
  for _, name in ipairs(pages.names()) do
    local script = pages.script(name)
    if script then pages.write(("%s/%s.lua"):format(folder, name), script) end
  end
end

--- A folder in which a page's commands run: the guide's scripts, and `hinge` of a build folder. Returns run(command),
--- which gives the exit status, what was printed, and what stderr had.
function pages.workplace(build)
  local pipe = assert(io.popen "mktemp -d")
  local folder = pipe:read "l"
  pipe:close()
  pages.write_scripts(folder)
  os.execute(("cp %sclaim.lua %s"):format(quote(pages.folder), folder))
  local start = ("cd %s; export LUA_CPATH=%s PATH=%s:\"$PATH\" NO_COLOR=1; "):format(folder, quote(build .. "/?.so"),
    quote(build))
  local function run(command)
    local _, kind, status = os.execute(("( %s%s\n) >%s/.stdout 2>%s/.stderr </dev/null"):format(start, command, folder,
      folder))
    return kind == "exit" and status or kind .. " " .. status, pages.read(folder .. "/.stdout"),
      pages.read(folder .. "/.stderr")
  end
  return folder, run, function() os.execute("rm -rf " .. quote(folder)) end
end

-- The part of a page's script that its other blocks go on from: all of it, or what stands above a line that the page
-- names in a comment, where the rest takes long: <!-- blocks follow the script up to: LINE -->
local function before_blocks(script, text)
  local line = text:match "<!%-%- blocks follow the script up to: ([^\n]-) %-%->"
  local at = line and assert(script:find("\n" .. line, 1, true), "the script has no line " .. line)
  return at and script:sub(1, at) or script
end

--- The Lua blocks after the first as one program or several.
function pages.snippets(text)
  local script, alone, after, last = nil, {}, {}, nil
  local printed = {}
  for _, block in ipairs(pages.blocks(text)) do
    if block.language == "console" then
      printed[#printed + 1] = block.text
    elseif block.language == "lua" then
      if not script then
        script = before_blocks(("\n" .. block.text):gsub("\nreturn .*$", "\n"):sub(2), text)
      elseif block.hidden and last then
        last[#last] = last[#last] .. block.text
      else
        last = block.text:find 'require "hinge"' and alone or after
        last[#last + 1] = block.text
      end
    end
  end
  if #after > 0 then table.insert(alone, 1, script .. "do\n" .. table.concat(after, "end\ndo\n") .. "end\n") end
  local preamble = ("local claim, shown = require 'claim' (%q, %q)\n"):format(pages.seen(text), table.concat(printed))
  for i, program in ipairs(alone) do alone[i] = preamble .. program end
  return alone
end

--- The blocks of Python, each with the block of text that follows it, or nil: { code =, output = (a block) }.
function pages.python(text)
  local list, last = {}, nil
  for _, block in ipairs(pages.blocks(text)) do
    if block.language == "python" then
      last = { code = block.text }
      list[#list + 1] = last
    else
      if block.language == "text" and last then last.output = block end
      last = nil
    end
  end
  return list
end

--- A Python that has pandas and VTK, or nil.
function pages.python_there()
  for _, name in ipairs { "/usr/bin/python3", "python3" } do
    if os.execute(name .. " -c 'import pandas, vtkmodules' >/dev/null 2>&1") then return name end
  end
end

--- Runs the blocks of Python; `run` as pages.workplace gives it. Returns what each printed, or nil and the complaint.
function pages.run_python(list, folder, run, python)
  local program, mark = {}, "\30"
  for i, block in ipairs(list) do program[i] = block.code .. 'print("\\x1e", end="")\n' end
  pages.write(folder .. "/page.py", table.concat(program))
  local status, printed, complaint = run(python .. " page.py")
  if status ~= 0 then return nil, complaint end
  local outputs = {}
  for part in printed:gmatch("([^" .. mark .. "]*)" .. mark) do outputs[#outputs + 1] = part end
  return outputs
end

local function json_text(text)
  return '"' .. text:gsub('[\\"]', "\\%0"):gsub("\n", "\\n"):gsub("\t", "\\t") .. '"'
end

-- A cell of a notebook: its text as a list of lines.
local function cell_of(kind, text)
  local lines = {}
  for line in text:gsub("\n$", ""):gmatch "[^\n]*\n?" do
    if line ~= "" then lines[#lines + 1] = "    " .. json_text(line) end
  end
  local more = kind == "code" and '   "execution_count": null,\n   "outputs": [],\n' or ""
  return ('  {\n   "cell_type": "%s",\n   "metadata": {},\n%s   "source": [\n%s\n   ]\n  }'):format(kind, more,
    table.concat(lines, ",\n"))
end

--- The page's Python as a notebook of Jupyter (nbformat 4): each block under the heading and the prose above it.
function pages.notebook(text, name)
  local cells, at = {}, 1
  for _, block in ipairs(pages.blocks(text)) do
    if block.language == "python" then
      local prose = text:sub(at, block.from - 1):match "\n(## .-)\n*```python\n$" or ""
      if prose ~= "" then cells[#cells + 1] = cell_of("markdown", prose) end
      cells[#cells + 1] = cell_of("code", block.text)
    end
    at = block.to + 4
  end
  local head = "# %s\n\nThe page %s.md of hinge's guide says what must run before."
  table.insert(cells, 1, cell_of("markdown", head:format(text:match "^# ([^\n]*)", name)))
  return ('{\n "cells": [\n%s\n ],\n "metadata": {},\n "nbformat": 4,\n "nbformat_minor": 2\n}\n'):format(
    table.concat(cells, ",\n"))
end

--- A page without its HTML comments: what readers see.
function pages.seen(text) return (text:gsub("<!%-%-.-%-%->\n?", "")) end

--- The PNG pictures that a page shows, by file name.
function pages.pictures(text)
  local list = {}
  for name in text:gmatch "!%[[^%]]*%]%(pictures/([%w_.-]+%.png)%)" do list[#list + 1] = name end
  return list
end

return pages

-- A page of the guide: its script is the one beside it, every command prints what the page shows, every other block of
-- Lua runs, every picture is drawn by its commands, and every link leads somewhere. See lua/guide/pages.lua.
--
-- Run: lua5.4 tests/script/guide_test.lua BUILD_FOLDER [NAME]        without a name: the list of pages, and links
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
local support = require "support"
package.path = support.root .. "lua/guide/?.lua;" .. package.path
local pages = require "pages"
local name = arg[2]
local checks = support.checks("guide " .. (name or ""))
local expect, equal = checks.expect, checks.equal

local function check_links(page, text)
  for link in text:gmatch "%]%(([^)%s]+)%)" do
    local file = link:gsub("#.*$", "")
    if file ~= "" and not link:find "^https?:" then
      expect(support.is_there(pages.folder .. file), "%s points to %s, which is not there", page, link)
    end
  end
end

local function check_page(text)
  local folder, run, clean = pages.workplace(arg[1])
  local script, commands = nil, 0
  for _, block in ipairs(pages.blocks(text)) do
    if block.language == "lua" and not script then
      script = block.text
      equal(script, pages.read(pages.folder .. name .. ".lua") or "none", "the script on the page")
    elseif block.language == "console" then
      for _, c in ipairs(pages.commands(block.text)) do
        commands = commands + 1
        local status, printed, complaint = run(c.command)
        expect(status == 0 or c.command:find ";", "%s: status %s\n%s", c.command, status, complaint)
        checks.prints(printed, c.output, c.command)
      end
    end
  end
  expect(script, "the page has no script")
  expect(commands > 0, "the page has no command")
  for i, text_of in ipairs(pages.snippets(text)) do
    support.write(folder .. "/snippet.lua", text_of)
    local status, _, complaint = run "lua5.4 snippet.lua"
    equal(status, 0, ("block of Lua, program %d: %s"):format(i, complaint))
  end
  local pictures = pages.pictures(text)
  for _, picture in ipairs(pictures) do
    local found = support.output(("find %s/out -name '%s' | head -1"):format(folder, picture)):gsub("\n", "")
    local drawn = found ~= "" and support.read(found) or ""
    expect(drawn:find "^\137PNG" and #drawn > 2000, "no command draws %s", picture)
  end
  expect(#pictures > 0 or text:find "pictures/[%w_]+%.svg", "the page has no picture")
  clean()
end

if name then
  local text = assert(support.read(pages.folder .. name .. ".md"))
  check_links(name .. ".md", text)
  check_page(text)
else
  check_links("README.md", support.read(pages.folder .. "README.md"))
  local listed, count = {}, 0
  for _, page in ipairs(pages.names()) do
    listed[page] = true
    count = count + 1
    if not support.is_there(pages.folder .. page .. ".lua") then -- a page without a script of its own
      check_links(page .. ".md", support.read(pages.folder .. page .. ".md") or "")
    end
  end
  for page in support.output("ls " .. pages.folder):gmatch "([%w_]+)%.md\n" do
    expect(listed[page] or page == "README", "README.md of the guide does not list %s.md", page)
  end
  expect(count > 10, "README.md of the guide lists %d pages", count)
end
checks.done()

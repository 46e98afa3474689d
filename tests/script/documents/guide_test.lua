-- A page of the guide: every command prints what the page shows, every other block of Lua runs, also those in HTML
-- comments that compare the page's figures with computed ones, its commands draw every picture, and every link leads
-- somewhere. See lua/guide/pages.lua.
--
-- Run: lua5.4 tests/script/documents/guide_test.lua BUILD_FOLDER [NAME]    without a name: the list of pages, and links
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
package.path = support.root .. "lua/guide/?.lua;" .. package.path
local pages = require "pages"
local name = arg[2]
local checks = support.checks("guide " .. (name or ""))
local case, expect, equal = checks.case, checks.expect, checks.equal

local function check_links(page, text)
  for link in text:gmatch "%]%(([^)%s]+)%)" do
    local file = link:gsub("#.*$", "")
    if file ~= "" and not link:find "^https?:" then
      expect(support.is_there(pages.folder .. file), "%s points to %s, which is not there", page, link)
    end
  end
end

-- The commands of a page run in their order, in one folder; each has a case of its own.
local function check_page(text)
  local folder, run, clean = pages.workplace(arg[1])
  local commands = 0
  for _, block in ipairs(pages.blocks(text)) do
    if block.language == "console" then
      for _, c in ipairs(pages.commands(block.text)) do
        commands = commands + 1
        local status, printed, complaint = run(c.command)
        case(("command %d prints what the page shows: %s"):format(commands, c.command), function()
          expect(status == 0 or c.command:find ";", "status %s\n%s", status, complaint)
          checks.prints(printed, c.output, c.command)
        end)
      end
    end
  end
  case("the page has a command", function() expect(commands > 0, "the page has no command") end)
  for i, text_of in ipairs(pages.snippets(text)) do
    case(("program %d of its blocks of Lua runs"):format(i), function()
      support.write(folder .. "/snippet.lua", text_of)
      local status, _, complaint = run "lua5.4 snippet.lua"
      equal(status, 0, (complaint:gsub("^lua5.4: snippet.lua:%d+: ", "")))
    end)
  end
  case("the page's commands draw its pictures", function()
    local pictures = pages.pictures(text)
    for _, picture in ipairs(pictures) do
      local found = support.output(("find %s/out -name '%s' | head -1"):format(folder, picture)):gsub("\n", "")
      local drawn = found ~= "" and support.read(found) or ""
      expect(drawn:find "^\137PNG" and #drawn > 2000, "no command draws %s", picture)
    end
    expect(#pictures > 0 or text:find "pictures/[%w_]+%.svg", "the page has no picture")
  end)
  clean()
end

if name then
  local text = assert(support.read(pages.folder .. name .. ".md"))
  case("the links of the page lead somewhere", function()
    expect(text:find "^# ", "the page has no title")
    check_links(name .. ".md", text)
  end)
  check_page(text)
else
  case("the links of the list of pages, and of pages without a script, lead somewhere", function()
    check_links("README.md", support.read(pages.folder .. "README.md"))
    local count = 0
    for _, page in ipairs(pages.names()) do
      count = count + 1
      if not pages.script(page) then check_links(page .. ".md", support.read(pages.folder .. page .. ".md")) end
    end
    expect(count > 10, "README.md of the guide lists %d pages", count)
  end)
  case("README.md of the guide lists every page", function()
    local listed = {}
    for _, page in ipairs(pages.names()) do listed[page] = true end
    for page in support.output("ls " .. pages.folder):gmatch "([%w_]+)%.md\n" do
      expect(listed[page] or page == "README", "README.md of the guide does not list %s.md", page)
    end
  end)
  case("claim compares the numbers of a page with values, to the digits that it has", function()
    local claim, shown = require "claim"("It is −1.97 mm and\n165 mm in 1,025,000 steps of eq14, 2-4 times 3.5e-05.",
      "sway 3.5 mm, then -0.2 mm\n")
    claim("−1.97 mm and 165 mm in 1,025,000 steps of eq14, 2-4 times 3.5e-05.", -1.9749, 165.4999, 1025000.4, 2, 4,
      3.549e-5)
    claim("−1.97 mm and 165", "-1.98", "165")
    for what, call in pairs {
      ["two units of a printed number"] = function() claim("−1.97 mm", "-1.99") end,
      ["another printed count"] = function() claim("165 mm", "166") end,
      ["half a unit of the last digit"] = function() claim("165 mm", 165.51) end,
      ["a digit after the point"] = function() claim("−1.97 mm", -1.976) end,
      ["a digit after the point, with an exponent"] = function() claim("3.5e-05", 3.551e-5) end,
      ["the sign"] = function() claim("−1.97 mm", 1.97) end,
      ["no number"] = function() claim("165 mm", 0 / 0) end,
      ["words that are not on the page"] = function() claim("165 cm", 165) end,
      ["a number without a value"] = function() claim("−1.97 mm and 165 mm", -1.97) end,
      ["a value without a number"] = function() claim("165 mm", 165, 1) end,
      ["a pattern that nothing printed fits"] = function() shown "sag (%S+)" end,
      ["a word in the place of a number"] = function() shown "(%a+) 3.5" end,
    } do
      expect(not pcall(call), "claim passes over %s", what)
    end
    local first, second = shown "sway (%S+) mm, then (%S+) mm"
    equal(first, 3.5, "shown")
    equal(second, -0.2, "shown, second capture")
  end)
  case("a block in an HTML comment goes on where the block above it ends, and is not seen", function()
    local text = "```lua\nlocal a = 1\n```\n\n```lua\nlocal b = a\n```\nb is 1\n\n"
      .. "<!--\n```lua\nclaim(\"b is 1\", b)\n```\n-->\n"
    local programs = pages.snippets(text)
    equal(#programs, 1, "programs")
    expect(programs[1]:find("do\nlocal b = a\nclaim(", 1, true), "the program is\n%s", programs[1])
    expect(not pages.seen(text):find "claim", "what readers see is\n%s", pages.seen(text))
  end)
end
checks.done()

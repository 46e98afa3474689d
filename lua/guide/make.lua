-- Writes into the guide's pages what their scripts print and draw: what the commands of console blocks and Python print
-- (but for blocks with "…"), the notebook and the pictures. The scripts and the text around them stay.
--
-- Run: lua5.4 lua/guide/make.lua BUILD_FOLDER [NAME ...]        all pages where no name is given
--      lua5.4 lua/guide/make.lua figures [NAME ...]             runs nothing: lists the numbers with a unit in the text
--                                                               of pages that none of their blocks has
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
local pages = require "pages"
local build = assert(arg[1], "usage: lua5.4 lua/guide/make.lua BUILD_FOLDER [NAME ...], or figures [NAME ...]")
if not build:find "^/" then build = os.getenv "PWD" .. "/" .. build end

-- Prints the numbers with a unit in a page's text that no block has, in this unit or another decade of it: 20 kN, 20e3.
local units = {}
for unit in ("m mm cm s ms µs N kN J kJ kg t Pa MPa Hz rad % degrees times"):gmatch "%S+" do units[unit] = true end
local function list_figures(name)
  local text = assert(pages.read(pages.folder .. name .. ".md"), "there is no " .. name .. ".md")
  local held, line_of, at = {}, 1, 1
  for _, block in ipairs(pages.blocks(text)) do
    for number in block.text:gsub("(%d),(%d%d%d)", "%1%2"):gmatch "%d+%.?%d*e?%-?%d*" do
      held[#held + 1] = tonumber(number) or tonumber(number:match "%d+")
    end
  end
  local function is_held(value)
    for _, number in ipairs(held) do
      for _, power in ipairs { -6, -3, -2, 0, 2, 3, 6, 9 } do
        if math.abs(number * 10.0 ^ power - value) <= 1e-9 * math.abs(value) then return true end
      end
    end
  end
  for _, block in ipairs(pages.blocks(text .. "\n```text\n```\n")) do
    local prose = text:sub(at, block.from - 1)
    for line in prose:gmatch "([^\n]*)\n" do
      for number, unit in line:gsub("(%d),(%d%d%d)", "%1%2"):gmatch "%f[%w.](%d+%.?%d*) ([%a%%µ]+)" do
        if units[unit] and not is_held(tonumber(number)) then
          print(("%s.md:%d: %s %s"):format(name, line_of, number, unit))
        end
      end
      line_of = line_of + 1
    end
    line_of = line_of + select(2, block.text:gsub("\n", ""))
    at = block.to + 1
  end
end

-- What the page's Python prints goes below it; the notebook is written beside the page.
local function with_python(name, text, folder, run)
  local list = pages.python(text)
  if #list == 0 then return text end
  local python = assert(pages.python_there(), "no Python with pandas and VTK")
  local outputs = assert(pages.run_python(list, folder, run, python))
  for i = #list, 1, -1 do
    local block = list[i].output
    if block then text = text:sub(1, block.from - 1) .. outputs[i] .. text:sub(block.to + 1) end
  end
  pages.write(pages.folder .. name .. ".ipynb", pages.notebook(text, name))
  return text
end

local function make(name)
  local path = pages.folder .. name .. ".md"
  local text = assert(pages.read(path), "there is no " .. path)
  local folder, run, clean = pages.workplace(build)
  local parts, at = {}, 1
  for _, block in ipairs(pages.blocks(text)) do
    local new = block.text
    if block.language == "console" then
      local lines = {}
      for _, c in ipairs(pages.commands(block.text)) do
        local status, printed, complaint = run(c.command)
        if status ~= 0 then io.stderr:write(("%s: %s: status %s\n%s\n"):format(name, c.command, status, complaint)) end
        lines[#lines + 1] = "$ " .. c.command .. "\n" .. printed
      end
      if not new:find "…" then new = table.concat(lines) end
    end
    parts[#parts + 1] = text:sub(at, block.from - 1) .. new
    at = block.to + 1
  end
  text = table.concat(parts) .. text:sub(at)
  text = with_python(name, text, folder, run)
  pages.write(path, text)
  for _, picture in ipairs(pages.pictures(text)) do
    if not os.execute(("cp \"$(find %s/out -name '%s' | head -1)\" '%spictures/%s'"):format(folder, picture,
        pages.folder, picture)) then
      io.stderr:write(("%s: no command draws %s\n"):format(name, picture))
    end
  end
  clean()
end

local one = arg[1] == "figures" and list_figures or make
for _, name in ipairs(#arg > 1 and table.move(arg, 2, #arg, 1, {}) or pages.names()) do
  if #arg > 1 or one == list_figures or pages.script(name) then -- some pages have no script
    if one == make then print(name) end
    one(name)
  end
end

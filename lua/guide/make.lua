-- Writes into the guide's pages what their scripts are, print and draw: the first block of Lua, what the commands of
-- console blocks print (but for blocks with "…"), and the pictures. What the pages say around it is left alone.
--
-- Run: lua5.4 lua/guide/make.lua BUILD_FOLDER [NAME ...]        all pages where no name is given
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
local pages = require "pages"
local build = assert(arg[1], "usage: lua5.4 lua/guide/make.lua BUILD_FOLDER [NAME ...]")
if not build:find "^/" then build = os.getenv "PWD" .. "/" .. build end

local function make(name)
  local path = pages.folder .. name .. ".md"
  local text = assert(pages.read(path), "there is no " .. path)
  local folder, run, clean = pages.workplace(build)
  local parts, at, has_script = {}, 1, false
  for _, block in ipairs(pages.blocks(text)) do
    local new = block.text
    if block.language == "lua" and not has_script then
      new, has_script = assert(pages.read(pages.folder .. name .. ".lua"), "there is no " .. name .. ".lua"), true
    elseif block.language == "console" then
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
  pages.write(path, table.concat(parts) .. text:sub(at))
  for _, picture in ipairs(pages.pictures(text)) do
    if not os.execute(("cp \"$(find %s/out -name '%s' | head -1)\" '%spictures/%s'"):format(folder, picture,
        pages.folder, picture)) then
      io.stderr:write(("%s: no command draws %s\n"):format(name, picture))
    end
  end
  clean()
end

for _, name in ipairs(#arg > 1 and table.move(arg, 2, #arg, 1, {}) or pages.names()) do
  if #arg > 1 or pages.read(pages.folder .. name .. ".lua") then -- some pages have no script
    print(name)
    make(name)
  end
end

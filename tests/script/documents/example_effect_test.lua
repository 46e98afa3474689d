-- The effect that src/README.md shows as an example compiles against the engine as it is.
--
-- Run: lua5.4 tests/script/documents/example_effect_test.lua COMPILER INCLUDE_FLAGS...
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "example effect"
local case = checks.case
local quote = support.quote

local folder = support.temporary_folder()
case("the effect in src/README.md compiles against the engine", function()
  local text = assert(support.read(support.root .. "src/README.md"))
  local files = {}
  for code in text:gmatch "\n```cpp\n(.-)```" do
    local path = code:match "^// (src/[%w_/]+%.%a+)\n"
    if checks.expect(path, "a block does not begin with its file's name: %s", code:sub(1, 60)) then
      files[#files + 1] = path
      support.run(("mkdir -p %s/%s"):format(folder, path:match "^(.*)/"))
      support.write(folder .. "/" .. path, code)
    end
  end
  checks.equal(#files, 3, "files of the example")
  for _, path in ipairs(files) do
    if path:find "%.cpp$" then
      local flags = "-std=c++20 -fsyntax-only -Wall -Wextra -Werror"
      local status, _, complaint = support.run(("%s %s -I%s/src -I%ssrc %s %s/%s")
        :format(quote(arg[1]), flags, folder, quote(support.root), table.concat(arg, " ", 2), folder, path))
      checks.equal(status, 0, path .. ": " .. complaint)
    end
  end
end)

checks.done()

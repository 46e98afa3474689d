-- Every C++ file is as clang-format has it, every Lua file passes luacheck, and no line of either
-- has more than 120 columns. Rules: .clang-format and .luacheckrc.
--
-- Run: lua5.4 tests/script/tree/format_test.lua CLANG_FORMAT LUACHECK
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "format"
local case = checks.case
local quote, expect, equal = support.quote, checks.expect, checks.equal
local clang_format = quote(arg[1])
-- it runs in a Lua of its own, with modules of that one
local luacheck = "env -u LUA_PATH -u LUA_CPATH " .. quote(arg[2])
local most_columns = 120

local function is_in(path, beginnings)
  for _, beginning in ipairs(beginnings) do
    if path:sub(1, #beginning) == beginning then return true end
  end
  return false
end

-- The files of a folder with these endings, whose paths begin so, sorted: those of its git repository, new ones too;
-- without one, all that are there.
local function files_of(folder, endings, beginnings)
  local patterns = {}
  for i, ending in ipairs(endings) do patterns[i] = quote("*." .. ending) end
  local in_folder = ("cd %s && "):format(quote(folder))
  local status, listed = support.run(("%sgit ls-files --cached --others --exclude-standard -- %s")
    :format(in_folder, table.concat(patterns, " ")))
  if status ~= 0 or listed == "" then
    local names = table.concat(patterns, " -o -name ")
    listed = support.output(("%sfind %s -name %s"):format(in_folder, table.concat(beginnings, " "), names))
  end
  local files = {}
  for path in listed:gmatch "[^\n]+" do
    if is_in(path, beginnings) and support.is_there(folder .. "/" .. path) then files[#files + 1] = path end
  end
  table.sort(files)
  return files
end

local function arguments(files)
  local quoted = {}
  for i, path in ipairs(files) do quoted[i] = quote(path) end
  return table.concat(quoted, " ")
end

-- What is wrong with files of a folder: a list of "path:line: what".
local function too_long(folder, files)
  local wrong = {}
  for _, path in ipairs(files) do
    local number = 0
    for line in io.lines(folder .. "/" .. path) do
      number = number + 1
      local columns = utf8.len(line) or #line
      if columns > most_columns then
        wrong[#wrong + 1] = ("%s:%d: %d columns; at most %d"):format(path, number, columns, most_columns)
      end
    end
  end
  return wrong
end

local function badly_formatted(folder, files)
  local status, _, complaint = support.run(("cd %s && %s --dry-run --Werror %s")
    :format(quote(folder), clang_format, arguments(files)))
  local wrong, last = {}, nil
  for place in complaint:gmatch "([^\n]-:%d+):%d+: error: code should be clang%-formatted" do
    if place ~= last then wrong[#wrong + 1] = place .. ": not as clang-format has it" end
    last = place
  end
  if status ~= 0 and #wrong == 0 then wrong[1] = ("clang-format: status %s: %s"):format(status, complaint) end
  return wrong
end

local function badly_written(folder, files)
  local status, printed, complaint = support.run(("cd %s && %s --no-color --codes --formatter plain %s")
    :format(quote(folder), luacheck, arguments(files)))
  local wrong = {}
  for line in printed:gmatch "[^\n]+" do wrong[#wrong + 1] = line end
  if status ~= 0 and #wrong == 0 then wrong[1] = ("luacheck: status %s: %s"):format(status, complaint) end
  return wrong
end

case("the tools notice what they are asked for", function()
  local version = support.output(clang_format .. " --version")
  expect(version:find "version 14%.", "files are as clang-format 14 of Debian 12 has them; this is %s", version)
  local bad = support.temporary_folder()
  for _, name in ipairs { ".clang-format", ".luacheckrc" } do
    support.write(bad .. "/" .. name, assert(support.read(support.root .. name)))
  end
  support.write(bad .. "/bad.cpp", "int a;\nint  b;\n// " .. ("x"):rep(118) .. "\n")
  support.write(bad .. "/bad.lua", "local a = 1\nb = 2\nprint(" .. ("x"):rep(120) .. ")\n")
  equal(table.concat(badly_formatted(bad, { "bad.cpp" }), "\n"), "bad.cpp:2: not as clang-format has it", "bad.cpp")
  equal(table.concat(too_long(bad, { "bad.cpp" }), "\n"), "bad.cpp:3: 121 columns; at most 120", "bad.cpp")
  local said = table.concat(badly_written(bad, { "bad.lua" }), "\n")
  for _, what in ipairs { "bad.lua:1:7: (W211)", "bad.lua:2:1: (W111)", "bad.lua:3:7: (W113)",
    "bad.lua:3:121: (W631)" } do
    expect(said:find(what, 1, true), "luacheck does not say %s: %s", what, said)
  end
end)

case("the scripts on the guide's pages pass luacheck", function()
  package.path = support.root .. "lua/guide/?.lua;" .. package.path
  local pages, folder = require "pages", support.temporary_folder()
  support.write(folder .. "/.luacheckrc", assert(support.read(support.root .. ".luacheckrc")))
  pages.write_scripts(folder)
  local scripts = files_of(folder, { "lua" }, { "" })
  expect(#scripts > 30, "%d scripts", #scripts)
  for _, what in ipairs(badly_written(folder, scripts)) do expect(false, "lua/guide: %s", what) end
end)

case("every file is formatted, passes luacheck and has lines of at most 120 columns", function()
  local cpp = files_of(support.root, { "cpp", "h" }, { "src/", "tests/", "scripts/" })
  local lua = files_of(support.root, { "lua", "rockspec" }, { "lua/", "tests/", "scripts/" })
  local long = too_long(support.root, table.move(cpp, 1, #cpp, 2, { ".luacheckrc" }))
  for _, wrong in ipairs { badly_formatted(support.root, cpp), badly_written(support.root, lua), long } do
    for _, what in ipairs(wrong) do expect(false, "%s", what) end
  end
  expect(#cpp > 100 and #lua > 90, "looked at %d C++ and %d Lua files", #cpp, #lua)
end)

checks.done()

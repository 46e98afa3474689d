-- The table of all benchmarks in the README.md of their folder, and the pictures that they drew.
local core = require "hinge.core"
local check = require "hinge.library.check"
local files = require "hinge.study.files"
local set = require "hinge.benchmark.set"
local tables = require "hinge.benchmark.tables"

local readme = {}
local first = "<!-- The table, made by: hinge run scripts/benchmarks/all.lua write=true -->"
local last = "<!-- End of the table -->"

-- What stands before and after the table in a README.md; of one that is not there, what it should be.
local function around(folder)
  local text = files.text(folder .. "/README.md")
  if not text then return "# Benchmarks\n\n![How right the numbers are](pictures/how_right.png)\n\n", "\n" end
  local at, stop = text:find(first, 1, true)
  local from, upto = text:find(last, stop or 1, true)
  if not at or not from then
    check.fail("write=true: %s/README.md has not the two lines between which the table goes, '%s' and '%s'", folder,
      first, last)
  end
  return text:sub(1, at - 1), text:sub(upto + 1)
end

--- Raises an error where the table could not be written, before the benchmarks run.
function readme.check(folder, p)
  if p.filter ~= "" or p.fast then
    check.fail("write=true writes the table of all benchmarks; leave out filter and fast")
  end
  around(folder)
end

-- The name that a benchmark's picture has in the folder of pictures.
local function name_of(one, drawn)
  return drawn:sub(1, #one.name) == one.name and drawn or one.name .. "_" .. drawn
end

--- Writes the table, and copies the pictures of the benchmarks and how_right.png from the output folder `out`.
function readme.write(folder, out, list, rows)
  local pictures, to = {}, folder .. "/pictures/"
  core.make_folder(to)
  for _, one in ipairs(list) do
    pictures[one.name] = {}
    for _, drawn in ipairs(set.names(one.folder, ".png")) do
      local name = name_of(one, drawn .. ".png")
      set.copy(("%s/%s.png"):format(one.folder, drawn), to .. name)
      table.insert(pictures[one.name], name)
    end
  end
  if files.text(out .. "/how_right.png") then set.copy(out .. "/how_right.png", to .. "how_right.png") end
  local before, after = around(folder)
  core.write_text(folder .. "/README.md", ("%s%s\n\n%s\n\n%s%s"):format(before, first,
    tables.markdown(list, rows, pictures), last, after))
end

return readme

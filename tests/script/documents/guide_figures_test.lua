-- Tables of the guide whose rows no command of the page prints: each row is run, and gives what the page says.
--
-- Run: lua5.4 tests/script/documents/guide_figures_test.lua BUILD_FOLDER [all]
-- all: also the rows of more than 5000 steps or of 8 elements a member, which `everything` runs
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "guide figures"
local case, expect, equal = checks.case, checks.expect, checks.equal
local guide = support.root .. "lua/guide/"
local hinge_on = support.scenes(arg[1])
local all = arg[2] == "all"

-- The rows of the tables of a page whose first cell begins so: lists of cells.
local function rows_of(page, beginning)
  local rows = {}
  for line in support.read(guide .. page):gmatch "[^\n]+" do
    local cells = {}
    for cell in line:gmatch "| ([^|]*) %f[|]" do cells[#cells + 1] = cell:match "^%s*(.-)%s*$" end
    if (cells[1] or ""):find(beginning) then rows[#rows + 1] = cells end
  end
  return rows
end

-- The script of impact.md with another piece of text in the place of one that it has, and with options of the model.
-- Returns its steps, the energy error, %, and the plastic work of frame and body, kJ, as printed.
local script = support.read(guide .. "impact.md"):match "\n```lua\n(.-)```\n"
local function impact(piece, other, options)
  local from, to = script:find(piece, 1, true)
  local text = script:sub(1, from - 1) .. other .. script:sub(to + 1)
  if options then text = text:gsub("hinge%.model {}", "hinge.model { " .. options .. " }") end
  text = text:gsub("\nhinge%.strip[^\n]*\n", "\n"):gsub("energy error %%%.2f", "energy error %%.3f")
  local status, printed, complaint = hinge_on("run -q", text .. "\nprint('steps', run.index)\n")
  equal(status, 0, other .. ": " .. complaint)
  local frame, body = printed:match "plastic work: frame ([%d.]+) kJ, body ([%d.]+) kJ"
  return printed:match "steps%s+(%d+)", printed:match "energy error ([%d.]+) %%", frame, body
end

-- Printed figures agree to one unit of the last digit that the page has.
local function as_written(value, written, what)
  local digits = (written:match "%.(%d+)" or ""):len()
  expect(value and math.abs(tonumber(value) - tonumber(written)) <= 1.001 * 10.0 ^ -digits, "%s: %s, the page has %s",
    what, value, written)
end

case("impact.md: steps, energy error and plastic work by time step", function()
  local rows = rows_of("impact.md", "^%d+ µs$")
  table.insert(rows, rows_of("impact.md", '^`"auto"`$')[1])
  for _, cells in ipairs(rows) do
    local dt, steps = cells[1]:match "%d+", tonumber(cells[2])
    if not all and steps > 5000 then goto continue end
    local n, percent, frame, body = impact("dt = 2e-5", dt and "dt = " .. dt .. "e-6" or 'dt = "auto"')
    expect(math.abs(tonumber(n) / steps - 1) < 0.02, "%s: %s steps, the page has %d", cells[1], n, steps)
    as_written(percent, cells[3]:match "[%d.]+", cells[1] .. ": energy error, %")
    as_written(frame, cells[4]:match "[%d.]+", cells[1] .. ": plastic work of the frame, kJ")
    as_written(body, cells[5]:match "[%d.]+", cells[1] .. ": plastic work of the body, kJ")
    ::continue::
  end
  equal(#rows, 7, "rows of the table")
end)

case("impact.md: plastic work by the number of elements", function()
  local rows = rows_of("impact.md", "^[248]$")
  for _, cells in ipairs(rows) do
    for i, integrator in ipairs(not all and cells[1] == "8" and {} or { "newmark", "explicit" }) do
      local _, _, frame, body = impact("dt = 2e-5", ('dt = "auto", integrator = "%s"'):format(integrator),
        ("elements_per_member = %s"):format(cells[1]))
      local name = ("%s elements, %s: plastic work of the "):format(cells[1], integrator)
      as_written(frame, cells[2 * i]:match "[%d.]+", name .. "frame, kJ")
      as_written(body, cells[2 * i + 1]:match "[%d.]+", name .. "body, kJ")
    end
  end
  equal(#rows, 3, "rows of the table")
end)

case("impact.md: plastic work of the frame by gap elements", function()
  local written = support.read(guide .. "impact.md"):match 'With `rule = "gap"` the frame has some (%d+) kJ'
  local _, _, frame = impact('model:contact { between', 'model:contact { rule = "gap", between')
  as_written(frame, written or "0", "plastic work of the frame, kJ")
end)

checks.done()

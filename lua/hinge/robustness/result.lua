-- What hinge.robustness returns: the rows as text, Markdown, CSV, a picture, and a page about all.
local core = require "hinge.core"
local check = require "hinge.library.check"
local columns = require "hinge.library.columns"
local job = require "hinge.program.job"
local output = require "hinge.library.output"
local quote = require "hinge.library.quote"
local ufc = require "hinge.standards.ufc_4_023_03.factors"

local Result = {}
local class = check.class(Result, "hinge.robustness_result")

-- Words -----------------------------------------------------------------------------------------------------------

local function number(value, format, times)
  return value and (format):format((times or 1) * value) or "-"
end

-- What a procedure says beside the deflection: the numbers that its verdict comes from.
local function answer(row)
  if row.procedure == "linear static" then
    return row.dcr and ("DCR %.3f of %.3g"):format(row.dcr, row.dcr_limit) or "-"
  elseif row.procedure == "nonlinear static" then
    return row.load_factor and ("loads %.2f of %.2f"):format(row.load_factor, row.omega) or "-"
  end
  return row.increase and ("%.2f times statics"):format(row.increase) or "-"
end

local function rotation_of(row)
  if not row.beam_rotation then return nil end
  return math.max(row.beam_rotation, row.column_rotation)
end

local heads = { "case", "what is removed", "procedure", "deflection, mm", "rotation, rad", "of limit", "answer",
  "verdict" }

local function cells(row)
  local rotation = row.procedure ~= "linear static" and rotation_of(row) or nil
  return { tostring(row.case), row.name, row.procedure, number(row.deflection, "%.1f", 1e3),
    number(rotation, "%.4f"), number(rotation and row.ratio, "%.2f"), answer(row), row.verdict }
end

-- Lines under a table: why a row has no answer, or a bad one.
local function reasons(rows)
  local lines = {}
  for _, row in ipairs(rows) do
    if row.reason ~= "" then
      lines[#lines + 1] = ("case %d, %s: %s: %s"):format(row.case, row.procedure, row.verdict, row.reason)
    end
  end
  return lines
end

--- The rows as text, by case; what is to be said of a row stands below.
function Result:table(...)
  check.no_more("result:table", ...)
  local all = { table.move(heads, 3, #heads, 1, {}) }
  for i, row in ipairs(self.rows) do all[i + 1] = table.move(cells(row), 3, #heads, 1, {}) end
  local lines = columns.lines(all, "all", "  ")
  local list = { lines[1] }
  for i, row in ipairs(self.rows) do
    local before = self.rows[i - 1]
    if not before or before.case ~= row.case then list[#list + 1] = ("case %d, %s"):format(row.case, row.name) end
    list[#list + 1] = lines[i + 1]
  end
  local said = reasons(self.rows)
  return table.concat(table.move(said, 1, #said, #list + 1, list), "\n")
end

class.__tostring = Result.table

local function markdown_row(list)
  local safe = {}
  for i, text in ipairs(list) do safe[i] = quote.markdown(text) end
  return "| " .. table.concat(safe, " | ") .. " |"
end

--- The rows as a table of Markdown.
function Result:markdown(...)
  check.no_more("result:markdown", ...)
  local lines = { markdown_row(heads), "|" .. ("---|"):rep(#heads) }
  for _, row in ipairs(self.rows) do lines[#lines + 1] = markdown_row(cells(row)) end
  return table.concat(lines, "\n") .. "\n"
end

-- Files -----------------------------------------------------------------------------------------------------------

local function folder_of(result)
  local out = core.out_dir()
  return result.folder and output.path(result.folder, out) or out == "." and "" or out
end

local fields = { "case", "name", "group", "x", "y", "z_low", "z_high", "procedure", "verdict", "reason", "span",
  "fall", "period", "deflection", "static_deflection", "increase", "beam_rotation", "column_rotation", "beam_ratio",
  "column_ratio", "ratio", "worst", "limit", "hinges", "without_limit", "omega", "smallest_ratio", "load_factor",
  "static_limit", "limit_reached", "loads_scaled", "dcr", "dcr_limit", "force_dcr", "broken", "time", "followed", "dt",
  "run_verdict", "energy_error", "seconds", "joint_rotation", "joint_ratio", "joint_dcr", "joints_broken",
  "joints_unrated", "pins", "pin_rotation", "worst_joint" }

--- Writes the rows with all their numbers into the study's folder.
function Result:csv(filename, ...)
  check.no_more("result:csv", ...)
  filename = output.name("result:csv", filename == nil and "robustness.csv" or filename, "csv")
  if not core.planning() then
    core.write_text(output.path(filename, folder_of(self)), output.csv(fields, self.rows))
  end
  return self
end

-- The picture -----------------------------------------------------------------------------------------------------

local colours = { holds = "green", ["exceeds the limit of rotation"] = "orange", ["exceeds the capacity"] = "orange",
  ["loses members"] = "purple", ["loses joints"] = "purple", collapses = "red", failed = "black",
  ["not allowed"] = "grey", ["not rated"] = "grey" }

-- From where to where the structure reaches along an axis.
local function extent(outline, axis)
  local low, high = math.huge, -math.huge
  for _, line in ipairs(outline) do
    for _, node in ipairs(line) do low, high = math.min(low, node[axis]), math.max(high, node[axis]) end
  end
  return low, high
end

-- Horizontal and vertical axis of the picture: a plan, or the elevation of a plane frame.
local function axes_of(outline)
  local size = {}
  for _, axis in ipairs { "x", "y" } do
    local low, high = extent(outline, axis)
    size[axis] = high - low
  end
  if size.y <= 1e-3 * size.x then return "x", "z" end
  if size.x <= 1e-3 * size.y then return "y", "z" end
  return "x", "y"
end

-- The frame in grey, each member once.
local function frame_series(outline, h, v)
  local series, seen = { x = {}, y = {}, colour = "grey", faint = true }, {}
  for _, line in ipairs(outline) do
    local a, b = line[1], line[2]
    local key = ("%.3f %.3f %.3f %.3f"):format(a[h], a[v], b[h], b[v])
    if not seen[key] and (math.abs(a[h] - b[h]) > 1e-6 or math.abs(a[v] - b[v]) > 1e-6) then
      seen[key] = true
      for _, node in ipairs { a, b } do
        series.x[#series.x + 1], series.y[#series.y + 1] = node[h], node[v]
      end
      series.x[#series.x + 1], series.y[#series.y + 1] = 0 / 0, 0 / 0 -- a gap
    end
  end
  return series
end

-- The number that stands beside a mark.
local function label(row)
  if row.procedure == "linear static" then return number(row.dcr, "%.2f") end
  if row.procedure == "nonlinear static" then return number(row.load_factor, "%.2f") end
  return number(row.deflection, "%.0f mm", 1e3)
end

local captions = { ["nonlinear dynamic"] = "nonlinear dynamic: deflection",
  ["nonlinear static"] = "nonlinear static: largest load factor", ["linear static"] = "linear static: DCR" }

-- A filled rectangle with its edge, in the two series of a verdict: the column itself in an elevation, a square in a
-- plan.
local function add_mark(series, row, view)
  local x, half = row[view.h], view.mark / 2
  local low, high = row.z_low, row.z_high
  if view.v ~= "z" then low, high = row[view.v] - half, row[view.v] + half end
  local left, right, gap = x - half, x + half, 0 / 0
  for _, point in ipairs { { left, low, high }, { right, low, high }, { gap, gap, gap } } do
    table.insert(series.fill.x, point[1])
    table.insert(series.fill.low, point[2])
    table.insert(series.fill.high, point[3])
  end
  for _, point in ipairs { { left, low }, { right, low }, { right, high }, { left, high }, { left, low }, { gap, gap } }
  do
    table.insert(series.edge.x, point[1])
    table.insert(series.edge.y, point[2])
  end
end

-- One panel: the marks of a procedure, coloured by verdict, and their numbers.
local function panel(result, procedure, low, view)
  local title = captions[procedure] .. (low and (", from z = %.4g m"):format(low) or "")
  local of, list = {}, { frame_series(result.outline, view.h, view.v) }
  for _, verdict in ipairs(view.verdicts) do
    local colour = colours[verdict] or "blue"
    of[verdict] = { fill = { x = {}, low = {}, high = {}, name = verdict, style = "band", colour = colour },
      edge = { x = {}, y = {}, colour = colour } }
    table.insert(list, of[verdict].fill)
    table.insert(list, of[verdict].edge)
  end
  local texts = { x = {}, y = {}, labels = {}, style = "points", colour = "black" }
  for _, row in ipairs(result.rows) do
    if row.procedure == procedure and (not low or row.z_low == low) then
      add_mark(of[row.verdict], row, view)
      table.insert(texts.x, row[view.h])
      table.insert(texts.y, view.v == "z" and (row.z_low + row.z_high) / 2 or row[view.v])
      table.insert(texts.labels, label(row))
    end
  end
  list[#list + 1] = texts
  return { title = title, series = list, x_label = view.h .. ", m", y_label = view.v .. ", m", x_range = view.x_range,
    y_range = view.y_range }
end

-- What all panels share: axes, their ranges with a margin, the size of a mark, and the verdicts.
local function view_of(result)
  local h, v = axes_of(result.outline)
  local view, seen = { h = h, v = v, verdicts = {} }, {}
  for name, axis in pairs { x_range = h, y_range = v } do
    local low, high = extent(result.outline, axis)
    local margin = math.max(0.12 * (high - low), 0.5)
    view[name] = { low - margin, high + margin }
  end
  view.mark = 0.03 * (view.x_range[2] - view.x_range[1])
  for _, row in ipairs(result.rows) do
    if not seen[row.verdict] then view.verdicts[#view.verdicts + 1], seen[row.verdict] = row.verdict, true end
  end
  return view
end

-- The heights at which removed columns begin, where a plan must tell them apart.
local function levels(result, v)
  local list, seen = {}, {}
  for _, row in ipairs(result.rows) do
    if not seen[row.z_low] then list[#list + 1], seen[row.z_low] = row.z_low, true end
  end
  table.sort(list)
  return v ~= "z" and #list > 1 and list or { false }
end

local function draw(result, drawer, filename)
  local view, panels = view_of(result), {}
  for _, low in ipairs(levels(result, view.v)) do
    for _, procedure in ipairs(result.procedures) do
      panels[#panels + 1] = panel(result, procedure, low or nil, view)
    end
  end
  local side = view.v == "z" and 1 or #result.procedures -- elevations stand below each other, plans side by side
  local width, height = side == 1 and 1000 or 800, view.v == "z" and 340 or 480
  drawer:plot({ panels = panels, columns = side, title = "Loss of columns, " .. result.criterion, width = side * width,
    height = math.min(8192, 60 + height * (#panels // side)) }, filename)
end

--- Draws the plan, or the elevation of a plane frame: a mark by verdict for each column, a panel for each procedure.
function Result:picture(filename, ...)
  check.no_more("result:picture", ...)
  filename = output.name("result:picture", filename == nil and "robustness.png" or filename, "pdf", "png", "svg")
  draw(self, job.new(folder_of(self)), filename)
  return self
end

-- The page --------------------------------------------------------------------------------------------------------

local function counts_text(result)
  local lines = {}
  for _, procedure in ipairs(result.procedures) do
    local parts, of = {}, result.counts[procedure]
    for _, verdict in ipairs(check.keys(of)) do parts[#parts + 1] = ("%s: %d"):format(verdict, of[verdict]) end
    lines[#lines + 1] = ("- %s: %s"):format(procedure, table.concat(parts, ", "))
  end
  return table.concat(lines, "\n")
end

local function method_text(result)
  local lines = { "| procedure | loads | what it is held against |", "|---|---|---|" }
  local limit = result.has_limit and "the limit of rotation" or "the limits of joints alone: no other was given"
  local by = { ["nonlinear dynamic"] = { "as given; the column goes at once", limit .. ", and a fall of the joints" },
    ["nonlinear static"] = { "times Omega_N = 1.08 + 0.76 / (allowed rotation / rotation at yield + 0.83), or as "
      .. "given", "equilibrium under these loads, and " .. limit },
    ["linear static"] = { ("times Omega_LD = %.4g; columns with more than half of N0: %g"):format(result.omega_ld or 0,
      ufc.force), ("a DCR of m = %.4g; such columns: 1"):format(result.m or 0) } }
  for _, procedure in ipairs(result.procedures) do
    lines[#lines + 1] = ("| %s | %s | %s |"):format(procedure, by[procedure][1], by[procedure][2])
  end
  return table.concat(lines, "\n")
end

local function warnings_text(result)
  local lines, seen = {}, {}
  for _, row in ipairs(result.rows) do
    for _, text in ipairs(row.warnings) do
      if not seen[text] then lines[#lines + 1] = ("- case %d, %s: %s"):format(row.case, row.procedure, text) end
      seen[text] = true
    end
  end
  return #lines > 0 and "\n## Warnings of the runs\n\n" .. table.concat(lines, "\n") .. "\n" or ""
end

local sources = [[
The factors are those of UFC 4-023-03 and of GSA's guidelines of 2016 for steel, from digitised tables; the originals
were not at hand. That a column must go within a tenth of the period of the vertical vibration is recalled and was not
confirmed. Here it goes in one step.
]]

--- Writes report.md into the study's folder, with robustness.csv and robustness.png beside it.
function Result:report(...)
  check.no_more("result:report", ...)
  self:csv()
  self:picture()
  local lines = reasons(self.rows)
  for i, text in ipairs(lines) do lines[i] = "- " .. text end
  local text = table.concat({ "# Loss of columns", "", ("Criterion: %s. %s, %s in %.0f s."):format(self.criterion,
    check.count(self.cases, "case"), check.count(#self.rows, "row"), self.seconds), "", counts_text(self), "",
    method_text(self), "", self:markdown(), table.concat(lines, "\n"), "", "![Verdicts](robustness.png)", "", sources },
    "\n") .. warnings_text(self)
  if not core.planning() then core.write_text(output.path("report.md", folder_of(self)), text) end
  return self
end

return class

-- Functions for the scripts of scripts/paper: error measures, tables, and the structure as in figures 4 and 5.
-- words/paper.d.lua describes the calls.
local core = require "hinge.core"
local check = require "hinge.library.check"
local columns = require "hinge.library.columns"

local paper = {
  methods = { "conventional", "asi", "asi-gauss" },
  drawn = { 1, 2, 4, 8, 16 }, -- elements a member in the figures' legends
}

local captions = {
  conventional = "(a) Conventional method", asi = "(b) ASI technique", ["asi-gauss"] = "(c) ASI-Gauss technique",
}

--- Root of the mean square difference of two histories over the largest value of the second.
function paper.error(history, reference)
  if #history ~= #reference then
    check.fail("paper.error: the history has %d values, the reference %d; both must have the same number", #history,
      #reference)
  end
  local sum, peak = 0, 0
  for i, wanted in ipairs(reference) do
    sum, peak = sum + (history[i] - wanted) ^ 2, math.max(peak, math.abs(wanted))
  end
  return math.sqrt(sum / #reference) / peak
end

--- The curve y over x at `count` equal parts of the way to `last`, straight between its points; x rises.
function paper.sampled(x, y, last, count)
  local result, k = {}, 1
  for i = 0, count do
    local at = last * i / count
    while k < #x - 1 and x[k + 1] < at do k = k + 1 end
    result[i + 1] = y[k] + (y[k + 1] - y[k]) * (at - x[k]) / (x[k + 1] - x[k])
  end
  return result
end

function paper.scaled(values, factor)
  local result = {}
  for i, v in ipairs(values) do result[i] = factor * v end
  return result
end

--- The fewest elements from which on the error stays within a limit; "> most" if not even the most do.
function paper.needed(errors, limit)
  local sizes = {}
  for n in pairs(errors) do sizes[#sizes + 1] = n end
  table.sort(sizes)
  local fewest
  for i = #sizes, 1, -1 do
    if not (errors[sizes[i]] <= limit) then break end
    fewest = sizes[i]
  end
  return fewest or "> " .. sizes[#sizes]
end

--- An error as text for a table; rounding errors are 0.
function paper.percent(error) return error < 1e-8 and "0" or ("%.3g"):format(100 * error) end

--- One picture of a figure: a method's curves by number of elements, { x =, y = }, and the converged one, dashed.
function paper.figure(job, number, method, labels, curves, converged)
  local series = {}
  for i, n in ipairs(paper.drawn) do
    local curve = curves[n] or { x = {}, y = {} } -- an empty one keeps the colours of the others
    series[i] = { name = curves[n] and ("%d element%s"):format(n, n > 1 and "s" or ""), x = curve.x, y = curve.y }
  end
  series[#series + 1] = { name = "converged", x = converged.x, y = converged.y, dashed = true }
  job:plot({ title = ("Fig. %d%s, %s"):format(number, captions[method], labels.title), x_label = labels.x,
    y_label = labels.y, series = series, width = 1500, height = 950 },
    ("fig%d_%s.png"):format(number, method:gsub("-", "_")))
end

--- Prints a table. Cells are numbers or texts; the first column is set to the left, the others to the right.
paper.table = columns.print

--- Name, time and reason of a run that failed, { run = name, time =, reason =, text = }; text: the reason without
-- advice. nil for any other run.
function paper.ended(run, name)
  if run.verdict ~= "failed" then return nil end
  return { run = name, time = run.time, reason = run.reason, text = run.failure.text }
end

--- Prints how many of `of` runs failed, and the name and reason of each. If there are any, the job notes it.
function paper.show_ended(job, ended, of)
  if #ended == 0 then return print(("\nNone of %d runs failed"):format(of)) end
  print ""
  job:note(("%d of %d runs failed, marked * in the tables"):format(#ended, of))
  for _, e in ipairs(ended) do print(("  %s: %s"):format(e.run, e.text)) end
end

--- The structure as pictures show it: fractured elements as rigid bars that end in virtual nodes (figure 4), and the
-- mass on every node (figure 5).
paper.pieces = core.pieces

return paper

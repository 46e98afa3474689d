-- All benchmarks of this folder, as one table: what hinge computes beside what is published or has a closed form.
--
-- Run     hinge run scripts/benchmarks/all.lua                (fast=true: only those of under a second each)
--         hinge run scripts/benchmarks/all.lua filter=buckl   (a part of a file's name, of a kind or of a title)
--         hinge run scripts/benchmarks/all.lua folder=mine    (benchmarks of your own)
-- Shows   kind, problem, quantity, computed, reference, error, elements, steps, seconds; the errors by kind; what lies
--         outside its tolerance. A benchmark that raises an error or whose process dies is a row, too, which failed
-- Expect  the verdict "completed": every row within its tolerance. results.csv has a line for each row, how_right.png
--         shows them all. jobs=0: as many at once as there are processors. write=true writes the table into README.md
--         of the folder, between its two marks, and the pictures into its folder "pictures"
local core = require "hinge.core"
local check = require "hinge.library.check"
local hinge = require "hinge"
local picture = require "hinge.benchmark.picture"
local readme = require "hinge.benchmark.readme"
local set = require "hinge.benchmark.set"
local tables = require "hinge.benchmark.tables"

local own_folder = (debug.getinfo(1, "S").source:match "^@(.*)/[^/]*$" or ".")

local function print_all(rows)
  print(tables.text(rows))
  print ""
  print(tables.summary_text(rows))
  local complaints = tables.complaints(rows)
  if #complaints > 0 then print("\nnot as they should be:\n  " .. table.concat(complaints, "\n  ")) end
end

-- The names of the benchmarks that are not as they should be.
local function failed_ones(list)
  local names = {}
  for _, one in ipairs(list) do
    if not set.is_right(one) then names[#names + 1] = one.name end
  end
  return names
end

-- Numbers for summary.json.
local function results_of(list, rows, seconds)
  local results = { benchmarks = #list, rows = #rows, seconds = seconds, by_kind = {}, failed = failed_ones(list) }
  for _, of in ipairs(tables.by_kind(rows)) do
    results.by_kind[of.kind] = { rows = of.rows, wrong = of.wrong, median = of.median, largest = of.largest }
  end
  return results
end

return hinge.scenario {
  parameters = { folder = "", filter = "", fast = false, jobs = 0, write = false, timeout = 600 },
  run = function(p, job)
    if core.planning() then return {} end
    local folder, began = p.folder == "" and own_folder or p.folder:gsub("(.)/+$", "%1"), core.clock()
    if p.write then readme.check(folder, p) end
    local list, whole = set.run { folder = folder, out = job.out == "" and "." or job.out, filter = p.filter,
      fast = p.fast, jobs = p.jobs > 0 and p.jobs or core.cores(), timeout = p.timeout, without = { all = true } }
    local rows = tables.rows(list)
    print_all(rows)
    local seconds = core.clock() - began
    print(("\n%s of %s in %.0f s"):format(check.count(#rows, "row"), check.count(#list, "benchmark"), seconds))
    core.write_text(job.out .. "/results.csv", tables.csv(rows))
    local plot = picture(rows)
    if plot then job:plot(plot, "how_right.png") end
    local failed = failed_ones(list)
    if not whole then job:verdict("failed", "interrupted; not all benchmarks have run")
    elseif #failed > 0 then job:verdict("failed", table.concat(failed, ", "))
    else job:verdict "completed" end
    if p.write and whole then readme.write(folder, job.out, list, rows) end
    return results_of(list, rows, seconds)
  end,
}

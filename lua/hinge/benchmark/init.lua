-- A benchmark: a problem whose answer is published or has a closed form. It compares computed values with it.
local check = require "hinge.library.check"
local scenario = require "hinge.program.scenario"

local benchmark = {}

benchmark.kinds = { "elastic", "stability", "inelastic", "dynamics", "test" }

local form = {
  title = { "string" }, kind = { "string", one_of = benchmark.kinds }, source = { "string" },
  fast = { "boolean", default = false }, missing = { "string", optional = true },
  unconfirmed = { "boolean", default = false }, run = { "function" },
}

local row_form = {
  computed = { "number" }, reference = { "number" }, unit = { "string", default = "" },
  tolerance = { "number", above = 0 }, scale = { "number", above = 0, optional = true },
  elements = { "number", whole = true, at_least = 1 }, steps = { "number", whole = true, at_least = 1, default = 1 },
}

local Benchmark = {}
local class = check.class(Benchmark, "hinge.benchmark")

--- Adds a row: what was computed beside its reference.
function Benchmark:row(options, ...)
  local where = "benchmark:row"
  check.no_more(where, ...)
  check.value(where, "options", options, { "table" })
  local what = options[1]
  check.value(where, "options[1], the quantity", what, { "string" })
  local given, computed = {}, options.computed
  for name, value in pairs(options) do given[name] = name ~= 1 and value or nil end
  -- What is not a number, or has no end, is a result, and a wrong one; it does not end the benchmark.
  if computed ~= computed or computed == math.huge or computed == -math.huge then given.computed = 0 end
  local row = check.options(where, given, row_form)
  row.computed = computed
  if row.reference == 0 and not row.scale then
    check.fail("%s: the reference of '%s' is 0; scale must say what the error is a part of", where, what)
  end
  local now = os.clock() -- of the processor: other work on the machine does not count
  row.quantity, row.seconds, self.began = what, now - self.began, now
  row.error = (row.computed - row.reference) / (row.scale or math.abs(row.reference))
  row.right = math.abs(row.error) <= row.tolerance -- false where the error is not a number
  self.rows[#self.rows + 1] = row
  print(("  %-38s %12.6g %12.6g %-8s %+9.4f %% %5d %6d %7.2f s%s"):format(what, row.computed, row.reference, row.unit,
    100 * row.error, row.elements, row.steps, row.seconds, row.right and "" or "  outside its tolerance"))
  return row
end

--- A function that adds rows which have fields in common: see words/benchmark.d.lua.
function Benchmark:rows_with(shared, ...)
  local where = "benchmark:rows_with"
  check.no_more(where, ...)
  check.value(where, "options", shared, { "table" })
  return function(what, computed, reference, unit, tolerance, more)
    local row = { what, computed = computed, reference = reference, unit = unit, tolerance = tolerance }
    for _, from in ipairs { more or {}, shared } do
      for name, value in pairs(from) do
        if row[name] == nil then row[name] = value end
      end
    end
    return self:row(row)
  end
end

-- These fields of a table.
local function part_of(of, names)
  local part = {}
  for _, name in ipairs(names) do part[name] = of[name] end
  return part
end

local of_row = { "quantity", "computed", "reference", "unit", "error", "tolerance", "right", "elements", "steps",
  "seconds" }
--- What a benchmark says of itself.
benchmark.said = { "title", "kind", "source", "missing", "unconfirmed", "fast" }

-- The rows that a benchmark has found, as results of a scenario.
local function results_of(self, o)
  local results = part_of(o, benchmark.said)
  results.fast, results.rows = nil, {}
  for i, row in ipairs(self.rows) do results.rows[i] = part_of(row, of_row) end
  return results
end

-- Says which rows are wrong. Where none is, the verdict is that of the runs: right numbers hide no run that failed.
local function verdict_of(self, job)
  local wrong = {}
  for _, row in ipairs(self.rows) do
    if not row.right then
      wrong[#wrong + 1] = ("%s: error %.3g %%, allowed %.3g %%"):format(row.quantity, 100 * row.error,
        100 * row.tolerance)
    end
  end
  if #self.rows == 0 then job:verdict("failed", "the benchmark has no row; run must call b:row { ... }")
  elseif #wrong > 0 then job:verdict("failed", table.concat(wrong, "; ")) end
end

--- hinge.benchmark: see words/benchmark.d.lua.
function benchmark.new(options, ...)
  check.no_more("hinge.benchmark", ...)
  local o = check.options("hinge.benchmark", options, form)
  local made = scenario.new {
    run = function(_, job)
      local self = setmetatable({ rows = {}, began = os.clock() }, class)
      print(("%s (%s)\nreference%s: %s"):format(o.title, o.kind, o.unconfirmed and ", not confirmed" or "", o.source))
      print(("  %-38s %12s %12s %-8s %11s %5s %6s %9s"):format("", "computed", "reference", "unit", "error", "elem.",
        "steps", "time"))
      o.run(self, job)
      if o.missing then print("not in the model: " .. o.missing) end
      verdict_of(self, job)
      return results_of(self, o)
    end,
  }
  made.benchmark = part_of(o, benchmark.said)
  return made
end

return benchmark

-- How right all rows are, as one picture: computed over reference, and the error on a logarithmic axis.
local tables = require "hinge.benchmark.tables"

local floor, reach = 1e-9, 0.25 -- smaller errors, and ratios further from 1, are drawn at these

-- Computed over reference. Where the reference is 0, the error is a part of something else.
local function ratio_of(row)
  if row.reference == 0 then return 1 + row.error end
  return 1 + (row.reference > 0 and row.error or -row.error)
end

-- The rows of a kind that have a finite error, the smallest first.
local function sorted(rows, kind)
  local list = {}
  for _, row in ipairs(rows) do
    if row.of.kind == kind and not row.failure and tables.counts(row) and math.abs(row.error) < math.huge then
      list[#list + 1] = row
    end
  end
  table.sort(list, function(a, b)
    local x, y = math.abs(a.error), math.abs(b.error)
    if x ~= y then return x < y end
    return a.of.name .. a.quantity < b.of.name .. b.quantity
  end)
  return list
end

-- Two series of a kind, ratio and error, that begin after `n` other rows. The kind's name stands at its ratios, the
-- problem's name at the largest error.
local function series_of(rows, kind, n)
  local ratios = { x = {}, y = {}, labels = {}, style = "points" }
  local errors = { x = {}, y = {}, labels = {}, style = "points" }
  for i, row in ipairs(rows) do
    local ratio = math.min(1 + reach, math.max(1 - reach, ratio_of(row)))
    ratios.x[i], ratios.y[i], ratios.labels[i] = n + i, ratio, i == (#rows + 2) // 3 and kind or ""
    errors.x[i], errors.y[i] = n + i, math.max(floor, 100 * math.abs(row.error))
    errors.labels[i] = i == #rows and row.of.name or ""
  end
  return ratios, errors
end

--- What job:plot takes.
return function(rows)
  local ratios, errors, n, bounds = {}, {}, 0, {}
  for _, of in ipairs(tables.by_kind(rows)) do
    local list = sorted(rows, of.kind)
    if #list > 0 then
      ratios[#ratios + 1], errors[#errors + 1] = series_of(list, of.kind, n)
      n = n + #list
      bounds[#bounds + 1] = { x = n + 0.5 }
    end
  end
  if n == 0 then return nil end
  -- The last name stands left of its point, and is left out where it would reach into the kind before.
  local last = errors[#errors]
  if 0.01 * n * #last.labels[#last.x] > #last.x then last.labels = {} end
  table.remove(bounds)
  local upper, lower = { { y = 1, dashed = false, colour = "black" } }, {}
  for _, percent in ipairs { 0.01, 1 } do lower[#lower + 1] = { y = percent, name = percent .. " %" } end
  for _, line in ipairs(bounds) do upper[#upper + 1], lower[#lower + 1] = line, line end
  return {
    title = ("%d numbers computed by hinge, against what is published or exact"):format(n),
    share_x = true, width = 1500, height = 1000,
    panels = {
      { series = ratios, lines = upper, y_label = "computed / reference", y_range = { 1 - 1.05 * reach,
        1 + 1.05 * reach }, x_range = { 0, 1.02 * n + 1 } },
      { series = errors, lines = lower, y_label = "|error|, %", log_y = true,
        x_label = "rows of the table, by kind, the smallest error first", y_range = { floor / 2, 1000 } },
    },
  }
end

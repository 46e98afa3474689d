-- Methods at equal error: the time that each value of a word (formulation, integrator, ...) takes to reach the same
-- error.
local compare = require "hinge.cost.compare"

local methods = {}
local exact = 1e-10 -- errors below it are rounding, and no point to draw a line through

--- The settings that count among some: the front of their own, as { { time =, error =, setting = }, ... }.
function methods.front(settings)
  local items = {}
  for i, s in ipairs(settings) do
    items[i] = { time = s.seconds, error = s.high and not s.above and compare.larger(s.high, exact) or nil,
      setting = s }
  end
  return compare.front(items)
end

--- The time of a front for an error: { seconds =, settings = { one, or the two around it } }. Between two of its points
--- it
-- is straight on logarithmic axes. If even its best setting is worse, `more` is true and seconds are those of the best
-- setting. nil for an empty front.
function methods.time_at(front, error)
  for i, item in ipairs(front) do
    if item.error <= error then
      local before = front[i - 1]
      if not before or item.error <= exact then return { seconds = item.time, settings = { item.setting } } end
      local way = math.log(before.error / error) / math.log(before.error / item.error)
      if way > 1 - 1e-9 then return { seconds = item.time, settings = { item.setting } } end
      return { seconds = before.time * (item.time / before.time) ^ way, settings = { before.setting, item.setting } }
    end
  end
  local last = front[#front]
  return last and { seconds = last.time, settings = { last.setting }, more = true }
end

-- The errors at which the values of a input are compared: the wanted error, that of the cheapest setting within it, and
-- the smallest that all values reach. Rounding errors are left out, and errors that differ from an earlier one by less
-- than a hundredth.
local function levels(fronts, within, best)
  local common, wanted, found = 0, { within, best and best.high }, {}
  for _, front in ipairs(fronts) do common = compare.larger(common, #front > 0 and front[#front].error or 0) end
  wanted[#wanted + 1] = common
  for _, error in ipairs(wanted) do
    local new = error > exact
    for _, other in ipairs(found) do new = new and math.abs(error / other - 1) > 0.01 end
    if new then found[#found + 1] = error end
  end
  table.sort(found, function(a, b) return a > b end)
  return found
end

--- For each input without a finer side: { name = { { error =, methods = { { value =, seconds =, ratio = over the
-- shortest, settings =, more = }, ... } }, ... } }, the errors from the largest on; each value with the best that
-- there is of all other inputs.
function methods.compare(inputs, compared, within, best)
  local result = {}
  for _, input in ipairs(inputs) do
    if not input.side then
      local fronts, rows = {}, {}
      for i, value in ipairs(input.values) do
        local own = {}
        for _, s in ipairs(compared) do
          if s.values[input.name] == value then own[#own + 1] = s end
        end
        fronts[i] = methods.front(own)
      end
      for _, error in ipairs(levels(fronts, within, best)) do
        local row, least = { error = error, methods = {} }, math.huge
        for i, value in ipairs(input.values) do
          local found = methods.time_at(fronts[i], error)
          if found then
            found.value = value
            row.methods[#row.methods + 1] = found
            if not found.more then least = math.min(least, found.seconds) end
          end
        end
        for _, found in ipairs(row.methods) do found.ratio = found.seconds / least end
        if least < math.huge then rows[#rows + 1] = row end
      end
      if #rows > 0 then result[input.name] = rows end
    end
  end
  return result
end

return methods

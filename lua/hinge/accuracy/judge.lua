-- How large the errors at a chosen setting are. Settings on a line to it, of which each is a level finer in all knobs,
-- tell the error of all knobs together. Where there are no three of them, the ladders' errors add up, and a check shows
-- whether they hold.
local compare = require "hinge.cost.compare"
local estimate = require "hinge.accuracy.estimate"
local statistics = require "hinge.accuracy.statistics"
local Ladders = require "hinge.accuracy.ladders"
local with = Ladders.with

local judge = {}

local rest, careful = estimate.rest_of_second_order, estimate.careful
local irregular = 1.5 -- times what the line's largest change says, where it shows no order
-- Times the work of the chosen run: where a check would make the search cost more, its first knob is coarser. Runs take
-- more than their steps; asking then costs about four times the chosen run.
local dearest = 3.5
local dear_check = 2 -- times the work of the chosen run: a check that takes more with any step is left out
local on_line = 3    -- settings on a line, with the chosen one

-- Whether a knob changes no answer at all.
local function is_idle(search, knob)
  for _, name in ipairs(search.names) do
    if search.ladders:along(knob, name).by ~= "exact" then return false end
  end
  return true
end

--- The settings on the line to a chosen one, the coarsest first, of which each is a level finer in all knobs that
-- change something. Three are run where they have not been; one before them counts where it has. nil where there are
-- fewer than three.
function judge.line(search, chosen)
  local points, moving = {}, {}
  for _, knob in ipairs(search.knobs) do
    if not is_idle(search, knob) then moving[#moving + 1] = knob end
  end
  if #moving == 0 then return nil end
  for k = on_line, 0, -1 do
    local point, is_there = chosen, true
    for _, knob in ipairs(moving) do
      point = with(point, knob.name, chosen[knob.name] - k)
      is_there = is_there and point[knob.name] >= search.ladders.corner[knob.name]
    end
    if k < on_line and not is_there then return nil end
    if k < on_line or is_there and search.ladders:at(point) then points[#points + 1] = point end
  end
  for _, point in ipairs(points) do
    if not search.ladders:at(point) and not search:run(point) then return nil end
  end
  return points
end

-- What a ladder that shows no order still says of the error at a finer setting: its last change, less the more all
-- knobs are finer, by the first order. Settings on a line may agree by chance.
local function lurking(search, chosen, e)
  local most = 0
  for _, knob in ipairs(search.knobs) do
    local found = e.found[knob.name]
    local n = found.answers and #found.answers or 0
    if n >= 2 and found.by ~= "order" and found.by ~= "exact" and found.by ~= "scatter" then
      local change = compare.distance(found.answers[n - 1], found.answers[n])
      local place = with(search.ladders:place(knob), knob.name, found.levels[n])
      for _, other in ipairs(search.knobs) do
        local finer = chosen[other.name] - place[other.name]
        change = change / (finer > 0 and other.ratio ^ finer or 1)
      end
      most = compare.larger(most, change)
    end
  end
  return most
end

-- Mean and band of a chaotic answer at the chosen setting, into its errors.
local function add_scatter(search, chosen, name, e)
  local mean, deviation, runs = statistics.mean(search.ladders:values(chosen, name))
  if not mean then
    e.total = math.huge
    return
  end
  e.mean, e.deviation, e.runs = mean, deviation, runs
  e.band = statistics.band(deviation, runs)
  e.band_part = Ladders.part_of(e.band, search.ladders:size(name, { mean }))
  e.total = e.total + e.band_part
end

-- What the check shows of an answer's error: its change where all knobs but the first are finer, without what the first
-- knob explains, with the rest of the series in theory. Where that is more than the ladders expect (`expected_part`),
-- the series is not that of the theory: the change has the factor of safety of two values.
local function shown_by(search, checked, chosen, name, expected_part)
  local ladders, first = search.ladders, search.knobs[1]
  local own, other = ladders:answer(chosen, name), ladders:answer(checked, name)
  if own == nil or other == nil then return math.huge end
  local expected = own
  if first and checked[first.name] ~= chosen[first.name] then
    local place = ladders:place(first)
    local there = ladders:answer(with(place, first.name, checked[first.name]), name)
    local here = ladders:answer(with(place, first.name, chosen[first.name]), name)
    if there ~= nil and here ~= nil then
      expected = compare.combined(function(a, b, c) return c + a - b end, there, here, own) or own
    end
  end
  local change = Ladders.part_of(compare.distance(other, expected), ladders:size(name, { own }))
  return change * (rest * change <= expected_part and rest or careful)
end

-- The error that the ladders tell, with what the knobs do to each other and what the check shows.
local function add_ladders(search, chosen, checked, name, e)
  local first, chaotic = search.knobs[1], search.ladders.chaotic[name]
  e.interplay = chaotic and 0 or search.ladders:interplay(chosen, name)
  e.total = e.total + e.interplay
  if not checked or chaotic then return end
  local other = first and checked[first.name] ~= chosen[first.name] and e.parts[first.name] or 0
  e.shown = shown_by(search, checked, chosen, name, e.total - other)
  if other + e.shown > e.total then e.total, e.by_check = other + e.shown, true end
end

--- Errors at the chosen setting by answer: as Ladders:errors, with total = the part that is told; line = what the
-- settings on the line say; shown = what the check shows; of chaotic answers mean, deviation, runs, band.
function judge.errors(search, chosen, checked, line)
  local errors = search.ladders:errors(chosen, search.names)
  for name, e in pairs(errors) do
    if line then
      e.line = search.ladders:along_line(line, name)
      local error = e.line.error * (e.line.by == "change" and not e.line.whole and irregular or 1)
      e.line_part = Ladders.part_of(compare.larger(error, lurking(search, chosen, e)), e.line.size)
      e.total = e.line_part
    else add_ladders(search, chosen, checked, name, e) end
    if search.ladders.chaotic[name] then add_scatter(search, chosen, name, e)
    else e.total = e.total + 2 * (search.sensitive[name] or 0) end
  end
  return errors
end

-- The check of a setting: all knobs but the first a level finer, and the first one that many levels coarser. With one
-- knob alone it is a level finer. nil where no knob can be finer.
local function check_of(search, chosen, coarser)
  local checked, finer = {}, false
  for i, knob in ipairs(search.knobs) do
    local level = chosen[knob.name]
    if i == 1 and #search.knobs > 1 then
      checked[knob.name] = math.max(search.ladders.corner[knob.name], level - coarser)
    else checked[knob.name], finer = math.min(knob.most, level + 1), finer or level < knob.most end
  end
  return finer and checked or nil
end

--- Makes the check of a setting, with the first knob as fine as its cost allows, by steps and elements: the same on
-- every machine. Returns its levels, nil where there is none.
function judge.check(search, chosen, own)
  local work, first = own.work or own.seconds, search.knobs[1]
  local coarsest = #search.knobs > 1 and math.max(1, chosen[first.name] - search.ladders.coarse[first.name]) or 1
  local checked
  for coarser = 1, coarsest do
    checked = check_of(search, chosen, coarser)
    if not checked then return nil end
    local more = work
    for _, knob in ipairs(search.knobs) do
      more = more * knob.ratio ^ ((knob.work or 1) * (checked[knob.name] - chosen[knob.name]))
    end
    if search.ladders:at(checked) or search.work + more <= dearest * work then break end
    if coarser == coarsest and more > dear_check * work then return nil end
  end
  return search:run(checked) and checked or nil
end

return judge

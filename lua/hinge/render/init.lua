-- hinge render: draws the frames that a run has written, each as a PNG beside it, or all as a film.
local core = require "hinge.core"
local check = require "hinge.library.check"
local film = require "hinge.render.film"
local render_options = require "hinge.render.options"
local runner = require "hinge.program.runner"
local workers = require "hinge.render.workers"

local render = {}

-- Whether a name leads out of the folder that it is in, or holds what no name of hinge's own does.
local function is_strange(file)
  return file == "" or file:find "^/" or file:find "%c" or ("/" .. file .. "/"):find("/../", 1, true)
end

--- The frames that frames.pvd in this folder lists: { { time = text, file = path }, ... }.
function render.frames(folder)
  local path = folder .. "/frames.pvd"
  local text, problem = core.read_text(path)
  if not text then
    check.fail("no frames to draw: %s; a script asks for them with job:frame(run) or hinge.frame(run)", problem)
  end
  local frames = {}
  for time, file in text:gmatch '<DataSet timestep="([^"]*)"[^>]- file="([^"]*)"' do
    if is_strange(file) then
      check.fail("%s lists the frame '%s', which is not inside %s: a picture beside it would be written elsewhere; run "
        .. "the script again, or give the folder that has the frames", path, file:gsub("%c", "?"), folder)
    end
    frames[#frames + 1] = { time = time, file = folder .. "/" .. file }
  end
  return frames
end

-- What the frames say of their pictures, see core.frame_box. Frames that cannot be read get their `problem`. Returns
-- nil where a signal came.
local function read_frames(frames, what)
  local results = workers.run { what = "frames read", count = #frames, jobs = what.jobs,
    work = function(i) return core.frame_box(frames[i].file, what.view) end }
  local found = results and {}
  local empty -- what is wrong with the plane, where no member lies in it
  for i, frame in ipairs(results and frames or {}) do
    frame.problem = results[i].problem
    found[#found + 1] = results[i].result
    if results[i].field == "plane" then empty = empty or results[i].why end
  end
  if empty and #found == 0 then check.fail("--plane: %s", empty) end
  return found
end

local much = 2 -- how much larger than that of one frame the box of all may be before it is told

local function size_of(box) -- m
  return math.sqrt((box[2] - box[1]) ^ 2 + (box[4] - box[3]) ^ 2 + (box[6] - box[5]) ^ 2)
end

-- Tells that the structure is small in all pictures, since something comes from far away or flies there.
local function tell_small(found, all)
  local least
  for _, f in ipairs(found) do
    if f.box and size_of(f.box) > 0 and (not least or size_of(f.box) < size_of(least)) then least = f.box end
  end
  if not least or size_of(all) <= much * size_of(least) then return end
  io.stderr:write(("hinge: all pictures show %.3g x %.3g x %.3g m, so that nothing leaves them, and one of them "
    .. "would do with %.3g x %.3g x %.3g m; --groups NAMES draws those that matter larger\n"):format(all[2] - all[1],
    all[4] - all[3], all[6] - all[5], least[2] - least[1], least[4] - least[3], least[6] - least[5]))
end

-- One view for all frames: the box that holds what each of them shows, one scale of displacements and one of diagrams.
-- Whether the frames are of statics is noted. Returns false where a signal came.
local function look_at(frames, what)
  local found = read_frames(frames, what)
  if found and what.view.scale == "auto" then -- that of the frame with the largest displacements
    local scale = math.huge
    for _, f in ipairs(found) do scale = math.min(scale, f.scale) end
    what.view.scale = scale < math.huge and scale or nil
    found = read_frames(frames, what)
  end
  if not found then return false end
  local all, known, largest = nil, {}, 0
  for _, f in ipairs(found) do
    what.statics = what.statics or f.statics
    for _, name in ipairs(f.groups) do known[name] = true end
    all, largest = all or f.box and table.move(f.box, 1, 6, 1, {}), math.max(largest, f.largest)
    for c = 1, f.box and 6 or 0 do all[c] = (c % 2 == 1 and math.min or math.max)(all[c], f.box[c]) end
  end
  local some = next(known) ~= nil
  for _, name in ipairs(some and what.view.groups or {}) do
    if not known[name] then check.unknown("--groups", "group", name, check.keys(known)) end
  end
  if all then tell_small(found, all) end
  what.view.box, what.view.largest = all, largest > 0 and largest or nil
  return true
end

-- Draws those of the frames that are in the list and have no problem, each into its `picture`.
local function draw(frames, list, what)
  local chosen = {}
  for _, i in ipairs(list) do
    if not frames[i].problem then chosen[#chosen + 1] = frames[i] end
  end
  if #chosen == 0 then return true end
  local results = workers.run { what = "pictures drawn", count = #chosen, jobs = what.jobs,
    work = function(i) core.render_file(chosen[i].file, chosen[i].picture, what.view) end,
    killed = function(process)
      for _, frame in ipairs(chosen) do os.remove(("%s.%d.part"):format(frame.picture, process)) end
    end }
  if not results then return false end
  for i, frame in ipairs(chosen) do
    frame.problem, frame.unwritten, frame.why = results[i].problem, results[i].unwritten, results[i].why
  end
  return true
end

-- Names the frames that could not be drawn, on stderr: the first one of each reason with it. Returns how many.
local function tell_problems(frames)
  local count, reasons, alike = 0, {}, {}
  for _, frame in ipairs(frames) do
    local problem = frame.problem
    if problem then
      count = count + 1
      local reason = problem:gsub("%S+%.%a%a%a%f[%W]", "")
      if not alike[reason] then
        reasons[#reasons + 1] = reason
        if not problem:find(frame.file, 1, true) then problem = ("%s: %s"):format(frame.file, problem) end
        alike[reason] = { first = problem }
      else
        table.insert(alike[reason], frame.file:match "[^/]*$")
      end
    end
  end
  for _, reason in ipairs(reasons) do
    local others = alike[reason]
    io.stderr:write(("hinge: not drawn: %s\n"):format(others.first))
    if #others > 0 then
      io.stderr:write(("hinge: not drawn for the same reason: %s%s\n"):format(table.concat(others, ", ", 1,
        math.min(8, #others)), #others > 8 and (" and %d more"):format(#others - 8) or ""))
    end
  end
  return count
end

local function numbers_to(n)
  local list = {}
  for i = 1, n do list[i] = i end
  return list
end

-- Every frame as a PNG beside it.
local function make_pictures(frames, what)
  for _, frame in ipairs(frames) do
    local to = core.leads_out(what.folder, frame.file)
    if to then
      check.fail("%s: a link leads to %s, outside %s, and pictures are written beside the frames; hinge render DIR "
        .. "--film draws them without that", frame.file, to, what.folder)
    end
  end
  for _, frame in ipairs(frames) do frame.picture = frame.file:gsub("%.vtp$", "") .. ".png" end
  local list = numbers_to(#frames)
  if not draw(frames, list, what) then return nil end
  local failed = tell_problems(frames)
  print(("%s in %s"):format(check.count(#frames - failed, "picture"), what.folder))
  return failed > 0 and 1 or 0
end

-- The schedule's entries with the pictures to show: where one was not drawn, the one before it stays, at the beginning
-- the first one that was.
local function seen(schedule, frames)
  local list, early = {}, 0
  for _, entry in ipairs(schedule) do
    local frame, last = frames[entry.frame], list[#list]
    if not frame.problem then
      list[#list + 1] = { file = frame.picture, pictures = entry.pictures + early }
      early = 0
    elseif last then last.pictures = last.pictures + entry.pictures
    else early = early + entry.pictures end
  end
  return list
end

local function cannot_write(what, problem)
  io.stderr:write(("hinge: cannot write %s: %s\n"):format(what.file, problem))
  return 1
end

-- Writes the film aside and gives it its name when it is whole. Returns true, false where a signal came; or false and
-- what went wrong.
local function write_film(list, what, folder)
  local aside, steps = folder .. "/film." .. what.format, core.shared_number()
  local results = workers.run { what = what.format == "gif" and "steps of the GIF" or "pictures encoded", count = 1,
    jobs = 1, steps = steps, total = film.steps(what.format, list),
    work = function() film.write(what.format, aside, list, what.fps, folder, steps) end }
  if not results then return false end
  if not results[1].ok then
    return false, film.complaint(folder) or results[1].why or results[1].problem
  end
  core.rename(aside, what.file)
  return true
end

local function size_text(path)
  local file = assert(io.open(path, "rb"))
  local size = file:seek "end"
  file:close()
  return size < 1e6 and ("%.0f kB"):format(size / 1e3) or ("%.1f MB"):format(size / 1e6)
end

local function make_film(frames, what, folder)
  local times, list = {}, {}
  for i, frame in ipairs(frames) do
    times[i] = tonumber(frame.time) or 0 / 0
    frame.picture = ("%s/%06d.png"):format(folder, i)
  end
  local schedule, length, span = film.schedule(times, what.fps, what.seconds, what.statics)
  for i, entry in ipairs(schedule) do list[i] = entry.frame end
  if not draw(frames, list, what) then return nil end
  for _, frame in ipairs(frames) do -- a full disk: the film would not find room either
    if frame.unwritten then return cannot_write(what, frame.why) end
  end
  local pictures, failed = seen(schedule, frames), tell_problems(frames)
  if #pictures == 0 then
    io.stderr:write(("hinge: no film: none of %s could be drawn\n"):format(check.count(#frames, "frame")))
    return 1
  end
  local written, problem = write_film(pictures, what, folder)
  if problem then return cannot_write(what, problem) end
  if not written then return nil end
  print(("%s: %s; %s of %d x %d, %s"):format(what.file,
    film.speed_text(length, span), check.count(#pictures, "picture"),
    what.view.width, what.view.height, size_text(what.file)))
  return failed > 0 and 1 or 0
end

-- A film, by way of a folder beside it that is gone afterwards.
local function make_film_aside(frames, what)
  local beside = what.file:match "^(.*)/[^/]*$" or "."
  local folder = ("%s/.hinge-render-%d"):format(beside, core.process())
  core.make_folder(folder)
  local ok, status = pcall(make_film, frames, what, folder)
  core.remove_folder(folder)
  if not ok then error(status, 0) end
  return status
end

--- options: see hinge.render.options. Returns the program's exit status: 0; 1 where a frame could not be drawn or a
-- film not be written; 2 for options that are wrong; 130 or 143 after Ctrl-C or SIGTERM.
function render.main(options)
  return runner.guard(function()
    local what = render_options.read(options)
    local frames = render.frames(what.folder)
    if what.note then io.stderr:write(("hinge: %s\n"):format(what.note)) end
    if #frames == 0 and what.format then check.fail("no frames to draw: %s/frames.pvd lists none", what.folder) end
    what.jobs = math.max(1, math.min(what.jobs, #frames))
    if #frames > 0 then core.share_display(math.max(1, core.cores() // what.jobs)) end
    local status = look_at(frames, what) and (what.format and make_film_aside or make_pictures)(frames, what)
    if status then return status end
    io.stderr:write(what.format and "hinge: interrupted; there is no film\n" or "hinge: interrupted\n")
    return 128 + core.signal()
  end)
end

return render

-- hinge render: draws the frames that a run has written, each as a PNG beside it, or all as a film.
local core = require "hinge.core"
local check = require "hinge.check"
local film = require "hinge.render.film"
local render_options = require "hinge.render.options"
local runner = require "hinge.runner"
local workers = require "hinge.render.workers"

local render = {}

--- The frames that frames.pvd in this folder lists: { { time = text, file = path }, ... }.
function render.frames(folder)
  local path = folder .. "/frames.pvd"
  local collection, problem = io.open(path)
  if not collection then
    check.fail("no frames to draw: %s; a script asks for them with job:frame(run) or hinge.frame(run)", problem)
  end
  local text = collection:read "a"
  collection:close()
  local frames = {}
  for time, file in text:gmatch '<DataSet timestep="([^"]*)"[^>]- file="([^"]*)"' do
    frames[#frames + 1] = { time = time, file = folder .. "/" .. file }
  end
  return frames
end

-- One camera for all frames: adds the box that holds what each of them shows to the view. Frames that cannot be read get
-- their `problem`; those of statics are noted.
local function look_at(frames, what, folder)
  local results = workers.run { what = "frames read", count = #frames, jobs = what.jobs, folder = folder,
    work = function(i)
      local box, groups, of_statics = core.frame_box(frames[i].file, what.view)
      return { box = box, groups = groups, statics = of_statics }
    end }
  if not results then return false end
  local all, known, statics = nil, {}, false
  for i, frame in ipairs(frames) do
    local found = results[i].result
    if not found then
      frame.problem = results[i].problem
    else
      statics = statics or found.statics
      for _, name in ipairs(found.groups) do known[name] = true end
      local box = found.box
      all = all or box
      for c = 1, box and 6 or 0 do all[c] = (c % 2 == 1 and math.min or math.max)(all[c], box[c]) end
    end
  end
  local some = next(known) ~= nil
  for _, name in ipairs(some and what.view.groups or {}) do
    if not known[name] then check.unknown("--groups", "group", name, check.keys(known)) end
  end
  what.view.box, what.statics = all, statics
  return true
end

-- Draws those of the frames that are in the list and have no problem, each into its `picture`.
local function draw(frames, list, what, folder)
  local chosen = {}
  for _, i in ipairs(list) do
    if not frames[i].problem then chosen[#chosen + 1] = frames[i] end
  end
  if #chosen == 0 then return true end
  local results = workers.run { what = "pictures drawn", count = #chosen, jobs = what.jobs, folder = folder,
    work = function(i) core.render_file(chosen[i].file, chosen[i].picture, what.view) end,
    killed = function(process)
      for _, frame in ipairs(chosen) do os.remove(("%s.%d.part"):format(frame.picture, process)) end
    end }
  if not results then return false end
  for i, frame in ipairs(chosen) do frame.problem = results[i].problem end
  return true
end

-- Names the frames that could not be drawn, on stderr. Returns how many there are.
local function tell_problems(frames, list)
  local most, count = 10, 0
  for _, i in ipairs(list) do
    local frame = frames[i]
    if frame.problem then
      count = count + 1
      local text = frame.problem
      if not text:find(frame.file, 1, true) then text = ("%s: %s"):format(frame.file, text) end
      if count <= most then io.stderr:write(("hinge: not drawn: %s\n"):format(text)) end
    end
  end
  if count > most then io.stderr:write(("hinge: not drawn: %d more\n"):format(count - most)) end
  return count
end

local function numbers_to(n)
  local list = {}
  for i = 1, n do list[i] = i end
  return list
end

-- Every frame as a PNG beside it.
local function make_pictures(frames, what, folder)
  for _, frame in ipairs(frames) do frame.picture = frame.file:gsub("%.vtp$", "") .. ".png" end
  local list = numbers_to(#frames)
  if not draw(frames, list, what, folder) then return nil end
  local failed = tell_problems(frames, list)
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

-- Writes the film aside and gives it its name when it is whole. Returns true, false where a signal came.
local function write_film(list, what, folder)
  local aside, steps = folder .. "/film." .. what.format, core.shared_number()
  local results = workers.run { what = what.format == "gif" and "steps of the GIF" or "pictures encoded", count = 1,
    jobs = 1, folder = folder, steps = steps, total = film.steps(what.format, list),
    work = function() film.write(what.format, aside, list, what.fps, folder, steps) end }
  if not results then return false end
  if not results[1].ok then
    check.fail("cannot write %s: %s", what.file, film.complaint(folder) or results[1].problem)
  end
  core.rename(aside, what.file)
  return true
end

local function megabytes(path)
  local file = assert(io.open(path, "rb"))
  local size = file:seek "end"
  file:close()
  return size / 1e6
end

local function make_film(frames, what, folder)
  local good, times = {}, {}
  for i, frame in ipairs(frames) do
    if not frame.problem then
      good[#good + 1] = i
      times[#times + 1] = tonumber(frame.time) or 0 / 0
    end
    frame.picture = ("%s/%06d.png"):format(folder, i)
  end
  local schedule, length, slower = film.schedule(times, what.fps, what.seconds, what.statics)
  local list = {}
  for i, entry in ipairs(schedule) do
    entry.frame = good[entry.frame]
    list[i] = entry.frame
  end
  if not draw(frames, list, what, folder) then return nil end
  local pictures = seen(schedule, frames)
  local failed = tell_problems(frames, numbers_to(#frames))
  if #pictures == 0 then
    io.stderr:write(("hinge: no film: none of %s could be drawn\n"):format(check.count(#frames, "frame")))
    return 1
  end
  if not write_film(pictures, what, folder) then return nil end
  print(("%s: %s; %s of %d x %d, %.1f MB"):format(what.file,
    film.speed_text(length, slower and times[#times] - times[1], slower), check.count(#pictures, "picture"),
    what.view.width, what.view.height, megabytes(what.file)))
  return failed > 0 and 1 or 0
end

-- The pictures or the film. Returns the exit status, nil where a signal came.
local function make(frames, what, folder)
  core.share_display(math.max(1, core.cores() // what.jobs))
  if not look_at(frames, what, folder) then return nil end
  return (what.format and make_film or make_pictures)(frames, what, folder)
end

--- options: see hinge.render.options. Returns the program's exit status: 0; 1 where a frame could not be drawn or a film
-- not be written; 2 for options that are wrong; 130 or 143 after Ctrl-C or SIGTERM.
function render.main(options)
  return runner.guard(function()
    local what = render_options.read(options)
    local frames = render.frames(what.folder)
    if what.note then io.stderr:write(("hinge: %s\n"):format(what.note)) end
    if #frames == 0 then
      if what.format then check.fail("no frames to draw: %s/frames.pvd lists none", what.folder) end
      print(("%s in %s"):format(check.count(0, "picture"), what.folder))
      return 0
    end
    what.jobs = math.min(what.jobs, #frames)
    local beside = what.format and (what.file:match "^(.*)/[^/]*$" or ".") or what.folder
    local folder = ("%s/.hinge-render-%d"):format(beside == "" and "/" or beside, core.process())
    core.make_folder(folder)
    local ok, status = pcall(make, frames, what, folder)
    core.remove_folder(folder)
    if not ok then error(status, 0) end
    return status or 128 + core.signal()
  end)
end

return render

-- A job: the pictures, frames and notes of one run of a script.
local core = require "hinge.core"
local check = require "hinge.library.check"
local hinges = require "hinge.results.hinges"
local view_rules = require "hinge.render.view".rules

local Job = {}
local class = check.class(Job, "hinge.job")

-- What a call is named in messages: job:picture, or hinge.picture where a script has no job.
local function named(job, what) return (job.prefix or "job:") .. what end

local function new(out, case)
  return setmetatable({ out = out, case = case, notes = {} }, class)
end

-- A view as the picture module takes it, and what it shows of hinges: a list of run:hinges, or false.
local function view_of(where, view)
  view = check.options(where, view, view_rules)
  if not hinges.can_be_drawn(view.hinges) then return view, false end
  local list = view.hinges
  view.hinges = true
  return view, hinges.marks(list)
end

local function must_be_run(where, run)
  local what = "; give what model:static or model:dynamic returned"
  if run == nil then check.fail("%s: the run is missing%s", where, what) end
  if type(run) ~= "userdata" then check.fail("%s: the run is %s%s", where, check.show(run), what) end
end

-- The output folder's file of that name, which must be a plain one; `plot`: .svg and .pdf will do as well as .png.
local function picture_path(where, job, filename, plot)
  check.value(where, "filename", filename, { "string" })
  local ending = filename:match "^[%w._ -]+%.(%l+)$"
  if not (ending == "png" or plot and (ending == "svg" or ending == "pdf")) then
    check.fail("%s: filename is '%s'; must be a plain name ending in .png%s (it goes into the output folder)",
      where, filename, plot and ", .svg or .pdf" or "")
  end
  return job.out == "" and filename or job.out .. "/" .. filename
end

-- A picture that cannot be drawn (no display) or written (a full disk) is noted; it does not cost the run its results.
-- What could not be written is missed in the folder, so the job as a whole has failed (core.lose).
local function try(job, what, f, ...)
  if core.planning() then return true end
  local ok, failure = pcall(f, ...)
  if ok then return true end
  if core.error_kind(failure) ~= "outside" then error(failure, 0) end
  local text = tostring(failure)
  if core.unwritten(failure) then core.lose(("%s: %s"):format(what, text)) end
  job:note(("%s not drawn: %s"):format(what, text))
  return false
end

--- Adds the structure as it is now to frames.pvd, for ParaView.
function Job:frame(run, ...)
  local where = named(self, "frame")
  check.no_more(where, ...)
  must_be_run(where, run)
  if self.frames_failed then return end
  self.frames_failed = not try(self, "frames", core.write_frame, run:snapshot())
end

local animation_rules = {
  frames = { "number", whole = true, at_least = 4, at_most = 1000, default = 24 },
  amplitude = { "number", unit = "m", optional = true },
}

--- Adds one vibration of a mode to frames.pvd, for ParaView and hinge render.
function Job:animate(mode, options, ...)
  local where = named(self, "animate")
  check.no_more(where, ...)
  if check.kind_of(mode) ~= "mode" then
    check.fail("%s: the mode is %s; give one of run:modes or run:buckling", where, check.show(mode))
  end
  local o = check.options(where, options, animation_rules)
  local period = mode.period or 1
  if period == math.huge then period = 1 end
  for k = 0, o.frames - 1 do
    if self.frames_failed then return end
    self.frames_failed = not try(self, "frames", core.write_frame, mode:snapshot(o.amplitude, period * k / o.frames))
  end
end

--- Draws the structure as it is now into a PNG picture in the output folder; without a name picture.png, picture-2.png.
function Job:picture(run, view, filename, ...)
  local where = named(self, "picture")
  check.no_more(where, ...)
  must_be_run(where, run)
  local shown, marks = view_of(where, view)
  if filename == nil then
    self.unnamed = (self.unnamed or 0) + 1
    filename = self.unnamed == 1 and "picture.png" or ("picture-%d.png"):format(self.unnamed)
  end
  try(self, filename, core.write_picture, run:snapshot(), shown, picture_path(where, self, filename), marks)
end

--- Draws snapshots side by side into one PNG picture: { { run or snapshot, view }, ... }, `columns` in a row.
function Job:strip(snapshots, columns, filename, ...)
  local where = named(self, "strip")
  check.no_more(where, ...)
  check.value(where, "snapshots", snapshots, { "table" })
  check.value(where, "columns", columns, { "number", whole = true, above = 0 })
  local pictures, views, marks = {}, {}, {}
  for i, item in ipairs(snapshots) do
    must_be_run(where, item[1])
    pictures[i] = item[1].snapshot and item[1]:snapshot() or item[1]
    views[i], marks[i] = view_of(where, item[2])
  end
  if #pictures == 0 then check.fail("%s: snapshots is empty; must be { { run:snapshot(), view }, ... }", where) end
  try(self, filename, core.write_strip, pictures, views, columns, picture_path(where, self, filename), marks)
end

--- Draws curves into a PNG, SVG or PDF picture in the output folder: a plot, or what a run recorded.
-- job:plot(plot, filename), job:plot(run, filename), job:plot(run, what, filename)
function Job:plot(plot, ...)
  local where = named(self, "plot")
  local filename, more = ..., 2
  local history = require "hinge.plot.history"
  if history.is_source(plot) then
    local what
    if type(filename) ~= "string" then
      what, filename, more = filename, select(2, ...), 3
    end
    plot = history.plot(where, plot, what)
  end
  check.no_more(where, select(more, ...))
  check.value(where, "what", plot, { "table" })
  try(self, filename, require "hinge.plot.draw", plot, picture_path(where, self, filename, true), where)
end

--- Prints a text and keeps it in summary.json.
function Job:note(text, ...)
  check.no_more(named(self, "note"), ...)
  text = tostring(text)
  self.notes[#self.notes + 1] = text
  if not core.event("note", { text = text }) then print("note: " .. text) end
end

--- Says how a job of several runs went as a whole; without it, the last run's verdict stands.
function Job:verdict(verdict, reason, ...)
  local where = named(self, "verdict")
  check.no_more(where, ...)
  check.value(where, "verdict", verdict, { "string" })
  if verdict ~= "completed" and verdict ~= "failed" then
    check.fail("%s: verdict is '%s'; must be 'completed' or 'failed'", where, verdict)
  end
  if verdict == "failed" then check.value(where, "reason", reason, { "string" }) end
  self.whole = { verdict = verdict, reason = verdict == "failed" and reason or nil }
end

-- A job for runs that are only measured. It draws nothing and prints nothing.
local function quiet(case)
  local job = new("", case)
  for _, name in ipairs { "frame", "picture", "strip", "plot", "note", "verdict" } do job[name] = function() end end
  return job
end

local current -- the job of hinge.picture and similar calls

--- Sets the job of hinge.picture and similar calls; returns the one before.
local function use(job)
  local before = current
  current = job
  return before
end

--- hinge.picture(run, view, filename) and the like, for scripts that get no job: plain statements, any Lua.
local free = {}
for _, name in ipairs { "frame", "animate", "picture", "strip", "plot", "note" } do
  free[name] = function(...)
    if not current then current = new(core.out_dir() == "." and "" or core.out_dir()) end
    local job = current
    local before = job.prefix
    job.prefix = "hinge."
    local results = table.pack(pcall(job[name], job, ...))
    job.prefix = before
    if not results[1] then error(results[2], 0) end
  end
end

local output -- folder and owner, as own_output had them last

--- core.own_output, and what it was given is kept, so that a study within a run can give the run its folder back.
local function own_output(folder, owner, given)
  folder = core.own_output(folder, owner, given)
  output = { folder, owner }
  return folder
end

--- Where this program's run writes now, for restore_output.
local function current_output()
  return output or { core.out_dir() == "." and "" or core.out_dir(), {} }
end

local function restore_output(before) own_output(before[1], before[2], true) end

return { new = new, quiet = quiet, use = use, free = free, own_output = own_output, current_output = current_output,
  restore_output = restore_output }

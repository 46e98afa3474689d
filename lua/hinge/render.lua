-- hinge render: draws every frame that a run has written, each as a PNG beside it.
local core = require "hinge.core"
local check = require "hinge.check"
local runner = require "hinge.runner"

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

--- options: out (a run's output folder). Returns the program's exit status.
function render.main(options)
  return runner.guard(function()
    local frames = render.frames(options.out)
    for _, frame in ipairs(frames) do
      core.render_file(frame.file, (frame.file:gsub("%.vtp$", "") .. ".png"), "f_y (eq 14)")
    end
    print(("%s in %s"):format(check.count(#frames, "picture"), options.out))
    return 0
  end)
end

return render

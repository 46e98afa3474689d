-- What a study of small models costs: a plane frame of 40 elements on a base that shakes, one process at a time.
--
-- Run     hinge run tests/bench/studies.lua                  (jobs=2: two processes; cases=20 of each length)
-- Shows   ms of a case by the length of its motion: of the whole study, in the model and its statics, in steps; and
--         whether eight frames in one model take less time each than one alone
-- Expect  what a case pays before its first step is a small part of a motion of 10 s
-- Writes  studies.csv in its output folder
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../script/?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local core = require "hinge.core"
local hinge = require "hinge"

local bays, storeys = 2, 2

local function ms(since) return 1e3 * (os.clock() - since) end

-- Frames of 40 elements beside each other in one model. Returns ms of the model with its statics, and of the steps.
local function shaken(amplitude, seconds, frames)
  local begun = os.clock()
  local model = hinge.model { elements_per_member = 4 }
  local columns = hinge.material { E = 210e9, density = 7850, yield_stress = 275e6 }
  local beams = hinge.material { E = 210e9, density = 60000, yield_stress = 275e6 } -- they carry floors
  local column, beam = hinge.section.named "HEB 300", hinge.section.named "IPE 400"
  local at, feet = nil, {}
  for frame = 1, frames do
    at = scenes.plane_frame(model, { bays = bays, storeys = storeys, bay = 6, height = 3.5, y = 10 * frame,
      column = { section = column, material = columns }, beam = { section = beam, material = beams } })
    for i = 0, bays do feet[#feet + 1] = at[i][0] end
  end
  model:gravity { 0, 0, -9.81 }
  local rest = model:static { steps = 2, record = false }:finish()
  model:damping { ratio = 0.03, periods = { 1, 0.1 } }
  for _, foot in ipairs(feet) do
    model:move { node = foot, x = function(t) return amplitude * math.sin(8 * t) * math.min(1, t / 2) end }
  end
  local run = model:dynamic { from = rest, dt = 0.005, duration = seconds, record = false, threads = 1 }
  local before = ms(begun)
  begun = os.clock()
  run:finish()
  return before, ms(begun), at[0][storeys]:displacement(run)
end

return hinge.scenario {
  parameters = { cases = 20, jobs = 1, amplitude = 0.05 },
  run = function(p, job)
    local rows = { "seconds of motion,ms a case,ms of model and statics,ms of steps" }
    print "motion, s   ms a case   model and statics   steps   the rest: its process and files"
    local scenario = hinge.scenario { parameters = { amplitude = p.amplitude, seconds = 1 }, run = function(q)
      local model, steps, top = shaken(q.amplitude, q.seconds, 1)
      return { model_ms = model, steps_ms = steps, top = top }
    end }
    for _, seconds in ipairs { 0.01, 1, 10 } do
      local amplitudes = {}
      for i = 1, p.cases do amplitudes[i] = p.amplitude * (1 + i / p.cases) end
      local begun = core.clock()
      local study = hinge.study(scenario, { vary = { amplitude = amplitudes, seconds = { seconds } }, jobs = p.jobs,
        out = job.out .. "/study", restart = true, pictures = false })
      local each = 1e3 * (core.clock() - begun) / p.cases
      local model, steps = math.huge, math.huge
      for _, case in ipairs(study.cases) do
        model = support.smallest_of(model, case.results.model_ms)
        steps = support.smallest_of(steps, case.results.steps_ms)
      end
      print(("%9g %11.1f %19.1f %7.1f %10.1f"):format(seconds, each, model, steps, p.jobs * each - model - steps))
      rows[#rows + 1] = ("%g,%g,%g,%g"):format(seconds, each, model, steps)
    end
    for _, frames in ipairs { 1, 2, 4, 8 } do
      local least = math.huge
      for _ = 1, 3 do
        local _, steps = shaken(p.amplitude, 2, frames)
        least = support.smallest_of(least, steps)
      end
      print(("%d frames in one model: %.1f ms each for 2 s of motion"):format(frames, least / frames))
    end
    support.write(job.out .. "/studies.csv", table.concat(rows, "\n") .. "\n")
  end,
}

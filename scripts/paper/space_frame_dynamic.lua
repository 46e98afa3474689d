-- How accurate is a response with two elements a member? The paper's section 3.2, figures 11 and 12.
--
-- Run     hinge run scripts/paper/space_frame_dynamic.lua             (quick=true: fewer elements, a coarser reference)
-- Shows   the cube of space_frame_static.lua under a sudden load: 8 kN elastic, 12 kN elasto-plastic, 100 steps of
--         0.05 ms, beta 1/4. The error is the RMS difference of the whole history from a run with 32 elements and 16
--         times the steps, over the peak of that run
-- Expect  error with two elements            elastic    elasto-plastic
--         asi-gauss                          1.55 %     0.73 %
--           its part from the linear mass    1.47 %     0.52 %     (two elements with the exact stiffness)
--           its part from the element        0.31 %     0.29 %
--           its part from the time step      0.12 %     0.02 %
--         asi-gauss with the cubic mass      0.33 %     0.27 %     (this mass is not in the paper)
--         asi                                22.8 %     5.5 %
--         conventional                       22.8 %     44 %
--         asi needs 8 elements to reach asi-gauss with two; the conventional method needs 8, elasto-plastic 128.
--         fig11_*.png and fig12_*.png: displacement over time
--
-- The paper's figure 8 is lost. Dimensions and material are *reconstructed*; they are parameters.
local hinge       = require "hinge"
local space_frame = require "hinge.models.space_frame"
local paper       = require "hinge.paper"

-- The corner's displacement over time under a sudden load. `parts`: the number of steps in one step of the paper. If
-- hinges form and unload too fast for equilibrium within a step, all steps are halved, and the table says so. `exact`:
-- the elements get the exact stiffness and keep their linear mass. `mass`: the option of hinge.model. If no step is
-- short enough, `ended` says why.
local function respond_to_load(p, method, elements, plastic, parts, exact, mass)
  local model = hinge.model {
    formulation = method, elements_per_member = elements, displacement = "small", plasticity = plastic, mass = mass,
    interaction = "paper",
  }
  local steel = hinge.material { E = p.E, nu = p.nu, density = p.density, yield_stress = p.yield_stress }
  local frame = space_frame.add(model,
    { side = p.side, thickness = p.thickness, material = steel, exact_elements = exact and elements or nil })
  model:load { node = frame.loaded, force = { plastic and p.plastic_load or p.elastic_load, 0, 0 } }
  local run = model:dynamic { dt = p.dt / parts, duration = p.steps * p.dt, beta = p.beta,
    solver = "direct", record = false }
  local ux = run:probe { node = frame.loaded, "ux", name = "ux" }
  run:finish()
  if run.verdict ~= "completed" then
    if parts >= 256 then
      return { x = {}, y = {}, parts = parts, ended = paper.ended(run, ("%s, %d elements"):format(method, elements)) }
    end
    return respond_to_load(p, method, elements, plastic, 2 * parts, exact, mass)
  end
  local mm = paper.sampled(ux.time, paper.scaled(ux.value, 1e3), run.time, p.steps) -- at the ends of the paper's steps
  local ms = {}
  for i = 0, p.steps do ms[i + 1] = 1e3 * p.dt * i end
  return { x = ms, y = mm, parts = parts }
end

-- The error of a response. A run that failed has no error, and stays within no limit.
local function error_of(response, reference)
  return (response.ended or reference.ended) and math.huge or paper.error(response.y, reference.y)
end

local function percent(error) return error < math.huge and ("%.2f"):format(100 * error) or "failed" end

-- One load case: the table and pictures of a figure, and the parts of the error of two asi-gauss elements.
-- count(response): called with each.
local function study(p, job, number, title, plastic, count)
  local function respond(...) return count(respond_to_load(p, ...)) end
  local largest = paper.drawn[#paper.drawn]
  local finest, most = p.quick and largest or 2 * largest, p.quick and largest or p.most
  local converged = respond("asi-gauss", finest, plastic, p.quick and 4 or 16)
  if converged.ended then return { ended = converged.ended } end -- nothing to compare with
  local peak = math.max(table.unpack(converged.y))
  local labels = { title = title, x = "time, ms", y = "displacement of the loaded corner, mm" }
  local pair = respond("asi-gauss", 2, plastic, 1)
  local aim = error_of(pair, converged)
  local result, rows, errors = { peak_mm = peak, errors = {}, needed = {} }, {}, {}

  for _, method in ipairs(paper.methods) do
    local curves, by_n = {}, {}
    local n = method == "asi-gauss" and 2 or 1
    while n <= largest or n <= most and by_n[n // 2] > aim do
      local c = respond(method, n, plastic, 1)
      curves[n], by_n[n] = c, error_of(c, converged)
      result.errors[#result.errors + 1] =
        { method = method, elements = n, error = not c.ended and by_n[n] or nil, dt = p.dt / c.parts, ended = c.ended }
      rows[#rows + 1] = { method, c.ended and n .. "*" or n, percent(by_n[n]),
        c.ended and "-" or ("%.2f"):format(math.max(table.unpack(c.y))), c.parts }
      n = 2 * n
    end
    errors[method] = by_n
    paper.figure(job, number, method, labels, curves, converged)
  end
  paper.table(("Fig. %d: %s response; converged peak %.3f mm"):format(number, title, peak),
    { "method", "elements", "error, %", "peak, mm", "steps a dt" }, rows)

  for _, method in ipairs(paper.methods) do result.needed[method] = paper.needed(errors[method], aim) end
  paper.table(("Elements for the %s %% of two of asi-gauss"):format(percent(aim)), paper.methods,
    { { result.needed.conventional, result.needed.asi, 2 } })

  local exact = respond("asi", 2, plastic, 1, true)
  local fine = respond("asi-gauss", finest, plastic, 1)
  local parts = {
    all = aim, element = error_of(pair, exact), mass = error_of(exact, fine), time = error_of(fine, converged),
    cubic = error_of(respond("asi-gauss", 2, plastic, 1, false, "cubic"), converged),
  }
  result.parts = parts
  paper.table("What the error of two elements of asi-gauss is made of", { "part", "error, %" }, {
    { "all", percent(parts.all) },
    { "element: against two with the exact stiffness", percent(parts.element) },
    { ("mass: these against %d elements"):format(finest), percent(parts.mass) },
    { "time step: these against the converged run", percent(parts.time) },
    { "all, with the cubic mass instead", percent(parts.cubic) },
  })
  return result
end

return hinge.scenario {
  parameters = {
    side = 0.25, thickness = 0.02,                                       -- m, *reconstructed*
    E = 206e9, nu = 0.3, density = 7850, yield_stress = 245e6,           -- Pa, kg/m^3, *reconstructed*
    elastic_load = 8000, plastic_load = 12000,                           -- N
    dt = 5e-5, steps = 100, beta = 0.25,                                 -- s
    most = 128,                                                          -- elements a member in the search
    quick = false,
  },
  run = function(p, job)
    local ended, all = {}, 0
    local function count(response)
      ended[#ended + 1], all = response.ended, all + 1
      return response
    end
    local elastic = study(p, job, 11, "elastic", false, count)
    local plastic = study(p, job, 12, "elasto-plastic", true, count)
    paper.show_ended(job, ended, all)
    job:verdict(#ended == 0 and "completed" or "failed", #ended .. " runs failed") -- all converge
    return { elastic = elastic, plastic = plastic, ended = ended, run_count = all }
  end,
}

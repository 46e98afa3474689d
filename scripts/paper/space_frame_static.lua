-- How many elements does a member need? The paper's section 3.1, figures 8, 9 and 10.
--
-- Run     hinge run scripts/paper/space_frame_static.lua              (quick=true: coarser steps, fewer elements)
-- Shows   a cube of eight members pushed sideways at an upper corner, by the conventional method, asi
--         and asi-gauss, with 1 to 16 elements a member (asi-gauss: 2 and more), small displacement;
--         elastic, then up to the limit load
-- Expect  elements                                     2           4           8           16
--         elastic at 8 kN: asi-gauss (exact)           2.143364 mm with any number of elements
--                          asi, conventional           1.654190    2.022626    2.113271    2.135846 mm
--         limit load:      asi-gauss, asi              12.69 kN (exact: 12.6882)
--                          conventional                24.2                                13.4 kN
--         For 1 % (0.1 %) of the elastic displacement asi needs 16 (32) elements, asi-gauss 2 (2).
--         fig9_*.png and fig10_*.png: load against displacement; error.png: error against elements
--
-- The paper's figure 8 is lost. Dimensions, material and the largest displacement of the corner are *reconstructed*;
-- they are parameters.
local hinge       = require "hinge"
local space_frame = require "hinge.models.space_frame"
local paper       = require "hinge.paper"

-- The curve of load over displacement, and if the run failed, why.
local function push_over(p, method, elements, plastic, steps)
  local model = hinge.model {
    formulation = method, elements_per_member = elements, displacement = "small", plasticity = plastic,
    interaction = "paper",
  }
  local steel = hinge.material { E = p.E, nu = p.nu, yield_stress = p.yield_stress }
  local frame = space_frame.add(model, { side = p.side, thickness = p.thickness, material = steel })
  model:load { node = frame.loaded, force = { p.load, 0, 0 } }
  local run = plastic
    and model:static { steps = steps, control = { node = frame.loaded, "ux", to = p.reach }, record = false }
    or model:static { steps = 20, record = false }
  local ux = run:probe { node = frame.loaded, "ux", name = "ux" }
  run:finish()
  local name = ("%s, %d elements, %s"):format(method, elements, plastic and "elasto-plastic" or "elastic")
  return { -- mm, kN
    x = paper.scaled(ux.value, 1e3), y = paper.scaled(ux.time, p.load / 1e3), ended = paper.ended(run, name),
  }
end

local function percent(error) return error < math.huge and paper.percent(error) or "-" end

-- Where a stiff curve would stretch the axes, it is drawn no higher than `top` kN.
local function below(curve, top)
  local cut = { x = {}, y = {} }
  for i, load in ipairs(curve.y) do
    if load > top then break end
    cut.x[i], cut.y[i] = curve.x[i], load
  end
  return cut
end

local measures = { "elastic displacement", "limit load", "whole curve" }

-- The curves and errors of a method by number of elements. The number is doubled until all three errors are below 0.1
-- %, or until `most`. A run that failed has no error, and stays within no limit.
local function converge(push, p, method, steps, most, exact, limit)
  local function loads(curve) return paper.sampled(curve.x, curve.y, 1e3 * p.reach, 1000) end -- at equal displacements
  local found = { sizes = {}, elastic = {}, plastic = {}, errors = { {}, {}, {} } }
  local wanted, n, worst = loads(limit), method == "asi-gauss" and 2 or 1, 1
  while n <= paper.drawn[#paper.drawn] or n <= most and worst > 1e-3 do
    local elastic, plastic = push(method, n, false), push(method, n, true, steps)
    local errors = {
      math.abs(elastic.x[#elastic.x] / exact.x[#exact.x] - 1), math.abs(plastic.y[#plastic.y] / limit.y[#limit.y] - 1),
      not plastic.ended and paper.error(loads(plastic), wanted) or math.huge,
    }
    if elastic.ended then errors[1] = math.huge end
    if plastic.ended then errors[2] = math.huge end
    found.sizes[#found.sizes + 1], found.elastic[n], found.plastic[n] = n, elastic, plastic
    for i, error in ipairs(errors) do found.errors[i][n] = error end
    n, worst = 2 * n, math.max(table.unpack(errors))
  end
  return found
end

return hinge.scenario {
  parameters = {
    side = 0.25, thickness = 0.02,                        -- m, *reconstructed*
    E = 206e9, nu = 0.3, yield_stress = 245e6,            -- Pa, *reconstructed*
    load = 8000,                                          -- N, elastic; the paper names it for its dynamic analysis
    reach = 0.02, steps = 400,                            -- m to which the corner is pushed, *reconstructed*
    most = 64,                                            -- elements a member in the search for 1 % and 0.1 %
    quick = false,
  },

  run = function(p, job)
    local largest = paper.drawn[#paper.drawn]
    local most, steps = p.quick and largest or p.most, p.quick and 100 or p.steps
    local ended, all = {}, 0
    local function push(...)
      local curve = push_over(p, ...)
      ended[#ended + 1], all = curve.ended, all + 1
      return curve
    end
    local exact = push("asi-gauss", largest, false)
    local limit = push("asi-gauss", largest, true, p.quick and steps or 4 * steps)
    if #ended > 0 then -- nothing to compare with
      paper.show_ended(job, ended, all)
      job:verdict("failed", "the reference failed: " .. ended[1].reason)
      return { ended = ended }
    end
    local u, F = exact.x[#exact.x], limit.y[#limit.y]

    local results = { converged = { ux_mm = u, limit_kN = F }, runs = {}, needed = {} }
    local elastic_rows, plastic_rows, needed_rows, error_curves = {}, {}, {}, {}
    local function add_errors(name, found, which)
      local curve = { name = name, x = found.sizes, y = {}, dashed = which == 1 }
      for i, n in ipairs(found.sizes) do curve.y[i] = 100 * found.errors[which][n] end
      error_curves[#error_curves + 1] = curve
    end

    for _, method in ipairs(paper.methods) do
      local found, drawn = converge(push, p, method, steps, most, exact, limit), {}
      for _, n in ipairs(found.sizes) do
        local elastic, plastic = found.elastic[n], found.plastic[n]
        local ux, top = elastic.x[#elastic.x], plastic.y[#plastic.y]
        local by_u, by_limit, by_curve = found.errors[1][n], found.errors[2][n], found.errors[3][n]
        results.runs[#results.runs + 1] = { method = method, elements = n, ux_mm = ux, ux_error = by_u, limit_kN = top,
          limit_error = by_limit, curve_error = by_curve }
        elastic_rows[#elastic_rows + 1] =
          { method, elastic.ended and n .. "*" or n, ("%.6f"):format(ux), percent(by_u) }
        plastic_rows[#plastic_rows + 1] =
          { method, plastic.ended and n .. "*" or n, ("%.4f"):format(top), percent(by_limit), percent(by_curve) }
        drawn[n] = below(plastic, 2 * F)
      end
      local x, y = "displacement of the loaded corner, mm", "load, kN"
      paper.figure(job, 9, method, { title = "elastic", x = x, y = y }, found.elastic, exact)
      paper.figure(job, 10, method, { title = "elasto-plastic", x = x, y = y }, drawn, limit)
      for i, measure in ipairs(measures) do
        local one, tenth = paper.needed(found.errors[i], 1e-2), paper.needed(found.errors[i], 1e-3)
        needed_rows[#needed_rows + 1] = { method, measure, one, tenth }
        results.needed[#results.needed + 1] = {
          method = method, of = measure, one_percent = one, tenth_percent = tenth,
        }
      end
      add_errors(method .. ", whole curve", found, 3)
      if method == "asi" then add_errors("conventional and asi, elastic", found, 1) end
    end

    paper.table(("Fig. 9: elastic, %g kN; converged %.6f mm"):format(p.load / 1e3, u),
      { "method", "elements", "u_x, mm", "error, %" }, elastic_rows)
    paper.table(("Fig. 10: elasto-plastic, pushed to %g mm; converged %.4f kN"):format(1e3 * p.reach, F),
      { "method", "elements", "load there, kN", "error, %", "of the curve, %" }, plastic_rows)
    paper.table("Elements a member needed", { "method", "for", "1 %", "0.1 %" }, needed_rows)
    job:plot({ title = "Error against the converged solution", x_label = "elements a member", y_label = "error, %",
      log_x = true, log_y = true, width = 1500, height = 950, series = error_curves }, "error.png")
    paper.show_ended(job, ended, all)
    job:verdict(#ended == 0 and "completed" or "failed", #ended .. " runs failed")
    results.ended, results.run_count = ended, all
    return results
  end,
}

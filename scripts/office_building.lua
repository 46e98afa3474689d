-- An office building of steel: under gravity, in an earthquake, in an explosion, and without one of its columns.
--
-- Run     hinge run scripts/office_building.lua part=earthquake, static, blast or robustness; --case small: in seconds
-- Shows   6 x 4 bays, 8 storeys. Main beams (along x) have end plates that break at 0.03 rad, chosen for the example.
--         Beams along y are pinned. Columns are lost from a frame held sideways; its DCR knows of no end plates
local hinge = require "hinge"
local named, results, folder = hinge.section.named, hinge.results, debug.getinfo(1, "S").source:match "^@(.*/)" or ""
local g, bay, height, dead, live, pin = 9.80665, 6, 4, 400, 300, { "Mx", "My" } -- m/s^2, m, m, kg/m^2, kg/m^2
local steel, post, girder, joist = hinge.material.steel "S355", named "HEB 300", named "IPE 400", named "HEA 240"
local plate = hinge.joint.end_plate { capacity = 0.03, beam = { section = girder, yield_stress = 355e6 },
  column = { section = post, yield_stress = 355e6 }, welds = { flange = 8e-3, web = 5e-3 }, -- m, Pa
  plate = { width = 0.2, thickness = 0.015, yield_stress = 355e6, below = 0.08 }, -- rows of bolts at both flanges
  bolts = { diameter = 0.024, grade = "8.8", rows = { 0.4365, 0.3365 }, gauge = 0.11, edge = 0.04, shear_rows = 2 } }

-- The frame with `floor` kg/m^2 on its floors, times scale(x, y, z) of hinge.robustness.
local function frame(p, floor, scale)
  local model, nx, ny = hinge.model {}, p.bays_x, p.bays_y
  local grid = hinge.grid { model = model, x = { count = nx, spacing = bay }, y = { count = ny, spacing = bay },
    z = { count = p.storeys, spacing = height } }
  local function line(i, j) return string.char(64 + i) .. j end
  model:case("dead"):gravity { 0, 0, -g }
  grid:fix("all"):defaults { material = steel, section = girder }
  grid:defaults { group = "braces", section = hinge.section.round { diameter = 0.07 }, carries = "tension" }
  grid:columns { section = post, up = { 1, 0, 0 }, group = "columns", elements = scale and 2 or 4 }
  for storey = 1, p.storeys do
    local nodes = {}
    for k = 0, 2 * nx do -- even: at columns; odd: at the middles of main beams
      local odd, width = k % 2 == 1, bay / (k % (2 * nx) == 0 and 4 or 2)
      for j = 1, ny + 1 do
        local x, y, z, left = k * bay / 2, (j - 1) * bay, storey * height, nodes[#nodes - ny]
        local node = odd and model:node { x, y, z } or grid:node(line(k // 2 + 1, j), storey)
        if left then grid:line { odd and left or node, odd and node or left, group = "beams", ends = { a = plate } } end
        if j > 1 then
          local mass = floor * width * (scale and scale(x, y - bay / 2, z) or 1) -- kg/m
          local beams = grid:line { nodes[#nodes], node, section = joist, group = "joists",
            material = steel:with { density = 7850 + mass / joist.area }, release = { a = pin, b = pin } }
          model:case("live"):load { member = beams[1], q = { 0, 0, -live * g * width } }
        end
        table.insert(nodes, node)
      end
    end
    if scale then model:fix(nodes, "x,y,rz") else model:diaphragm { nodes = nodes } end
  end
  if scale then return model end
  for j = 1, ny + 1, ny do grid:braces { from = line(1, j), to = line(2, j), shape = "X", group = "braces" } end
  for i = 1, nx + 1, nx do grid:braces { from = line(i, 1), to = line(i, 2), shape = "X", group = "braces" } end
  model:prestress { group = "braces", force = 150e3, case = "dead" } -- N
  return model, grid
end
local function at_rest(p, longest) -- under 0.3 of the live load; returns what a dynamic run takes as well
  local model, grid = frame(p, dead + 0.3 * live)
  local rest = model:static { steps = 2, loads = "dead" }:finish()
  local T, duration = rest:modes { n = 1 }[1].period, math.min(p.duration, longest or p.duration) -- s
  model:damping { ratio = 0.02, periods = { T, T / 5 } }
  model:ground {} -- on which debris falls
  return model, { from = rest, dt = p.dt, duration = duration, solver = "direct" }, grid, T
end
return hinge.scenario { parameters = { part = "all", bays_x = 6, bays_y = 4, storeys = 8, dt = 5e-3, duration = 3, -- s
  charge = 6000, procedure = "linear static" }, cases = { small = { bays_x = 2, bays_y = 1, storeys = 2, dt = 2e-3,
    duration = 0.3, charge = 500 } }, run = function(p, job) -- charge: kg of TNT
    local out, all = {}, p.part == "all"
    if all or p.part == "static" then
      local model = frame(p, dead)
      local list = hinge.combinations { model = model, standard = "EN 1990", kind = "ULS", omit = false,
        cases = { dead = "G", live = { "Q", category = "B" } } }
      local run = model:static { steps = 2, loads = list[1].name }:finish()
      job:picture(run, { plane = { y = 0 }, show = "Mx" }, "office_moments.png")
      print(results.utilisation(run, { model = model, standard = "EN 1993-1-1" }):text { top = 3 })
      out.base = results.base(run, { model = model }).rows.sum.Fz -- N
    end
    if all or p.part == "earthquake" then
      local model, options, grid, T = at_rest(p)
      local quake = hinge.record.read { file = folder .. "records/office.csv", unit = "m/s^2", scale = 3 }
      for _, at in ipairs(grid:lines()) do model:move { node = grid:node(at, 0), x = quake.displacement } end
      local run = model:dynamic(options)
      local floors = results.storeys(run, { model = model })
      print(("first period %.2f s, %s"):format(T, run:finish().verdict), floors:plot(job, "office_drifts.png"))
      out.period, out.drift = T, floors.rows[1].drift_x -- s
    end
    if all or p.part == "blast" then
      local model, options = at_rest(p, 2)
      local face, width = {}, function(m) return m.a.y % (p.bays_y * bay) == 0 and bay / 2 or bay end
      for _, m in ipairs(model:group("columns"):members()) do table.insert(face, m.a.x == 0 and m or nil) end
      hinge.blast { charge = p.charge, at = { -20, p.bays_y * bay / 2, 0 } }:load(model, { members = face,
        normal = { -1, 0, 0 }, width = width, uneven = true }) -- the pressure at the middle of a column
      local run, broken = model:dynamic(options):finish(), 0
      for _, m in ipairs(model:group("beams"):members()) do broken = broken + (m:joint("a").broken and 1 or 0) end
      job:picture(run, { title = "after the blast" }, "office_blast.png")
      print(run.verdict, broken .. " end plates broke", run:count { state = "yielded" } .. " members yielded")
      out.broken = broken
    end
    if all or p.part == "robustness" then
      local loss = hinge.robustness { loads = "dead", procedures = { p.procedure }, limit = 0.03, dt = p.dt,
        build = function(o) return (frame(p, 1.2 * dead + 0.5 * live, o.scale)) end }
      print(loss)
      out.cases = #loss.rows
    end
    return out
  end }

-- Which end moments come from snow on the rafter of a gable frame, and from a crane on a floor beam?
--
-- Run     hinge run scripts/09_member_loads.lua
-- Shows   loads per length of a member or of its plan, and a load at a point of a member
-- Expect  wall_kNm = 30 within 0.00001 %          q l^2 / 12, 10 kN/m of snow per metre of plan on a clamped rafter
--         crane_kNm = 43.68903 within 0.00001 %   P a b / l^2 (b + f l / 2) / (1 + f), f = 12 E I / (k G A l^2); 50 kN
--         sag_mm = 24.27027 within 0.00001 %      5 q l^4 / (384 E I) + q l^2 / (8 k G A), 20 kN/m on a simple beam
local hinge = require "hinge"

local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850 }
local h = hinge.section.h { depth = 0.3, width = 0.15, web = 0.0065, flange = 0.009 }

-- A beam of 6 m in plan. Its far end is higher by `rise`. `fix` is for model:fix at its two ends.
local function beam(rise, fix, load)
  local model = hinge.model { displacement = "small" }
  local a, mid, b = model:node { 0, 0, 0 }, model:node { 3, 0, rise / 2 }, model:node { 6, 0, rise }
  model:fix(a, fix[1])
  model:fix(b, fix[2])
  local members
  if load.member then
    members = { model:member { a, b, section = h, material = steel, group = "beam" } }
    load.member = members[1]
  else
    members = { model:member { a, mid, section = h, material = steel, group = "beam" },
      model:member { mid, b, section = h, material = steel, group = "beam" } }
    load.group = "beam"
  end
  model:load(load)
  local run = model:static { steps = 1 }
  run:finish()
  return run, members[1], mid
end

local run, rafter = beam(2, { "all", "all" }, { member = true, q = { 0, 0, -10e3 }, axes = "projected" })
local wall = math.abs(rafter:forces(run).Mx)
local floor
run, floor = beam(0, { "all", "all" }, { member = true, at = 0.3, force = { 0, 0, -50e3 } })
local crane = math.abs(floor:forces(run).Mx)
local simple, _, mid = beam(0, { "x,y,z,rx", "y,z,rx" }, { q = { 0, 0, -20e3 } })
local _, _, uz = simple:displacement(mid)
print(("moment at the wall under snow %.3f kN m, under a crane %.3f kN m; sag of a simple beam %.3f mm")
  :format(wall / 1e3, crane / 1e3, -1e3 * uz))
return { wall_kNm = wall / 1e3, crane_kNm = crane / 1e3, sag_mm = -1e3 * uz }

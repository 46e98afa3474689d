-- What comes down after the impact, and does the frame stand? Case I followed for longer than the paper's 0.25 s.
--
-- Run     hinge run scripts/paper/after_impact.lua     (--case II, III, IV; quick=true: 50 ms)
-- Shows   the impact by explicit steps, with a ground under it: how far the roof comes down, what breaks and when,
--         where the aircraft's pieces are, the energy balance
-- Expect  after_impact.png, energy.png and the tables of README.md in this folder, within two minutes
--
-- Contact is by surfaces here: pieces come to lie on each other, and gap elements would release them. The members
-- have two elements, and there are no slabs. This shows how such a frame comes down, not where real debris lies.
local hinge  = require "hinge"
local impact = require "hinge.models.ten_storey_impact"
local paper  = require "hinge.paper"

-- Drop of the roof's joints, m: the least, the mean and the most.
local function drops(run, roof)
  local least, most, total = math.huge, -math.huge, 0
  for _, node in ipairs(roof) do
    local _, _, uz = run:displacement(node)
    least, most, total = math.min(least, -uz), math.max(most, -uz), total - uz / #roof
  end
  return least, total, most
end

-- Part of the aircraft's members that lie on the ground, fly above it, or are still inside the building's outline.
local function whereabouts(run, frame)
  local x, y, z = run:read("x", "aircraft"), run:read("y", "aircraft"), run:read("z", "aircraft")
  local down, inside = 0, 0
  for i = 1, #x do
    if z[i] < 1 then
      down = down + 1
    elseif x[i] > 0 and x[i] < frame.size[1] and y[i] > 0 and y[i] < frame.size[2] then
      inside = inside + 1
    end
  end
  return down, inside, #x - down - inside
end

return hinge.scenario {
  parameters = impact.parameters { contact = "surface", duration = 3, looks = 6, threads = 2, quick = false },
  cases = impact.cases,
  run = function(p, job)
    if p.quick then p = impact.with(p, { duration = 0.05 }) end
    local model = hinge.model { p_delta = "chord", interaction = "paper", weight = "nodes" } -- as in the paper
    local frame, plane = impact.add(model, p)
    -- just below the feet, which stay fixed; elastic points, which the figures of README.md are of
    model:ground { point = { 0, 0, -0.2 }, friction = 0.4, restitution = 1 }
    local roof = {}
    for i = 0, 4 do for j = 0, 4 do roof[#roof + 1] = frame.node(i, j, 10) end end
    local rest = model:static { fixed_group = plane }:finish()
    local run = model:dynamic { from = rest, dt = "auto", integrator = "explicit", duration = p.duration,
      threads = p.threads }

    local at_rest, rows, pictures, energies = select(2, drops(rest, roof)), {}, {}, {}
    local names = { "kinetic", "gravity", "plastic", "fracture", "contact", "ground" }
    for k, name in ipairs(names) do energies[k] = { name = name, x = {}, y = {} } end
    local function look()
      local least, mean, most = drops(run, roof)
      local down, inside, flying = whereabouts(run, frame)
      rows[#rows + 1] = { ("%.2f"):format(run.time), ("%.2f"):format(least - at_rest), ("%.2f"):format(mean - at_rest),
        ("%.2f"):format(most - at_rest), run:count { group = "inner columns", state = "broken" },
        run:count { group = "outer columns", state = "broken" }, run:count { group = "beams", state = "broken" }, down,
        inside, flying }
      pictures[#pictures + 1] = { run:snapshot(), { title = ("%.1f s"):format(run.time), width = 800, height = 700,
        box = { -15, 60, -10, 36, 0, 40 } } }
    end
    local every, often = run.planned_steps // p.looks, math.max(1, run.planned_steps // 400)
    for step in run:steps() do
      if step.index % often == 0 then
        for k, name in ipairs(names) do
          local s = energies[k]
          s.x[#s.x + 1], s.y[#s.y + 1] = run.time, (run.energy[name] or 0) / 1e6
        end
      end
      if step.index % every == 0 then look() end
    end
    paper.table("The roof's joints: drop since rest, m; members broken; members of the aircraft", { "time, s", "least",
      "mean", "most", "inner columns", "outer", "beams", "on the ground", "in the building", "elsewhere" }, rows)
    job:strip(pictures, 3, "after_impact.png")
    job:plot({ title = "Energies", x_label = "time, s", y_label = "MJ", series = energies }, "energy.png")
    local lower = 0
    for level = 1, 5 do lower = lower + run:count { group = frame.storey_groups[level], state = "broken" } end
    print(("\nmembers broken in storeys 1 to 5: %d; energy error %.3f %% of the largest energy; %.0f s"):format(lower,
      100 * run.energy_error, run.wall_seconds))
    return { damage = impact.damage(run, frame), lower_broken = lower, verdict = run.verdict }
  end,
}

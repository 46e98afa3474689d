-- A column under a constant axial force whose head goes to and fro: the common part of the comparisons with tests.
local hinge = require "hinge"

local column = {}

-- The rotations of the chord (rad) at which a test turns round: `cycles` at each of the `sizes`, to + first.
function column.turns(sizes)
  local turns = {}
  for _, step in ipairs(sizes) do
    for _ = 1, step[2] do
      turns[#turns + 1] = step[1]
      turns[#turns + 1] = -step[1]
    end
  end
  return turns
end

-- Moment at the foot (kN m) over the rotation of the chord (rad). `peaks` (kN m) and `energies` (kN m, the work of that
-- moment so far) have a value for each turn. Options: section; material; L: length, m; P: axial force, N; clamped: true
-- where the head does not rotate; backbone; turns: rotations of the chord, rad; steps: between two turns; elements;
-- interaction, default "exact"; stop_at: part of the greatest moment at which the run is over, default none.
function column.bent(o)
  local model = hinge.model { interaction = o.interaction or "exact" }
  local foot, head = model:node { 0, 0, 0 }, model:node { 0, 0, o.L }
  local member = model:member { foot, head, section = o.section, material = o.material, up = { 1, 0, 0 },
    elements = o.elements, backbone = o.backbone }
  model:fix(foot)
  model:fix(head, o.clamped and "y,rx,ry,rz" or "y,rx,rz")
  model:case("axial"):load { node = head, force = { 0, 0, -o.P - 1 } } -- 1 N: a case needs a load
  model:case("sway"):load { node = head, force = { 1, 0, 0 } }
  local run = model:static { loads = { axial = 1 }, steps = 1, record = false }:finish()
  local curve, energy = { x = { 0 }, y = { 0 }, peaks = {}, energies = {} }, 0
  for _, turn in ipairs(o.turns) do
    run = model:static { from = run, loads = { axial = 1, sway = 1 }, steps = o.steps, record = false,
      control = { node = head, "ux", to = turn * o.L } }
    local peak = 0
    while run:step() do
      local x, y, n = head:displacement(run) / o.L, -member:forces(run).Mx / 1e3, #curve.x
      energy = energy + (x - curve.x[n]) * (y + curve.y[n]) / 2
      curve.x[n + 1], curve.y[n + 1] = x, y
      peak = math.max(peak, math.abs(y))
      if o.stop_at and math.abs(y) < o.stop_at * peak then
        run:stop()
        return curve
      end
    end
    if run.verdict ~= "completed" then
      curve.stopped = run.reason
      break
    end
    curve.peaks[#curve.peaks + 1], curve.energies[#curve.energies + 1] = peak, energy
  end
  return curve
end

-- The greatest moment of a curve.
function column.most(curve)
  local most = 0
  for _, y in ipairs(curve.y) do most = math.max(most, math.abs(y)) end
  return most
end

-- The rotation at which a curve that was pushed one way has fallen to `part` of its greatest moment; nil: it has not.
function column.fallen_to(curve, part)
  local most, at = 0, 1
  for i, y in ipairs(curve.y) do
    if y > most then most, at = y, i end
  end
  for i = at + 1, #curve.y do
    local before, y = curve.y[i - 1], curve.y[i]
    if y <= part * most then
      return curve.x[i - 1] + (before - part * most) / (before - y) * (curve.x[i] - curve.x[i - 1])
    end
  end
end

return column

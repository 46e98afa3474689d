-- Frames that the tests of hinge.robustness take columns from, and their closed forms. Lengths in m, forces in N.
local hinge = require "hinge"
local scenes = require "scenes"
local g, fy, E, L = 9.80665, 325e6, 206e9, 5
local box = hinge.section.box { width = 0.15, depth = 0.3, thickness = 0.01 }
local post = hinge.section.box { width = 0.25, depth = 0.25, thickness = 0.012 }
local stub = hinge.section.solid { width = 0.6, depth = 0.6 } -- shortens by 6e-6 m
local Mp = box.Zx * fy
local frames = { g = g, fy = fy, E = E, L = L, box = box, post = post, Mp = Mp }

--- Steel that weighs next to nothing.
function frames.light(yield_stress)
  return hinge.material { E = E, density = 0.05, yield_stress = yield_stress or fy }
end

--- Of the mechanism: its limit load, and the sag of the head under 1 N: each beam has a clamped end and one that goes
--- down without a turn, with its shear.
frames.R = 4 * Mp / L
frames.flexibility = (L ^ 3 / (12 * E * box.Ix) + L / (E / 2.6 * box.shear_area_y)) / 2

--- Two beams between walls, nodes 1, 2, 3, on a column in the middle, member 3, with P at its head.
--- how: P, mass (P as weight of a mass; otherwise a load of the case "dead"), elastic, backbone, ends, posts (beside
--- it, so that there is a span), scaled (P by the function `scale` of hinge.robustness), extra(model, head).
function frames.mechanism(how, scale)
  local model, light = hinge.model { displacement = "small" }, frames.light(how.elastic and 2e10)
  local left, head, right = model:node { 0, 0, 3 }, model:node { L, 0, 3 }, model:node { 2 * L, 0, 3 }
  local foot = model:node { L, 0, 0 }
  model:fix({ left, right, foot }, "all")
  model:fix(head, "y,rx,rz")
  for _, ends in ipairs { { left, head }, { head, right } } do
    model:member { ends[1], ends[2], section = box, material = light, up = { 0, 0, 1 }, group = "beams",
      backbone = how.backbone, ends = how.ends }
  end
  model:member { foot, head, section = stub, material = light, up = { 1, 0, 0 } }
  for _, top in ipairs(how.posts and { left, right } or {}) do
    local low = model:node { top.x, 0, 0 }
    model:fix(low, "all")
    model:member { low, top, section = post, material = light, up = { 1, 0, 0 } }
  end
  local P = how.P * (scale and how.scaled and scale(L, 0, 3) or 1)
  if how.mass then
    model:mass { node = head, mass = P / g }
    model:gravity { 0, 0, -g }
  else model:case("dead"):load { node = head, force = { 0, 0, -P } } end
  if how.extra then how.extra(model, head) end
  return model, head
end

--- Spans of 5 m on posts, with P (of the case "dead") on each inner joint. options: spans (2), side (of the members at
--- both ends), mass (of the inner joints, as a part of P), without (elastic, and the inner posts are not there).
--- Returns the model and the joints, from 0.
function frames.bridge(P, options)
  local o = options or {}
  local model, light = hinge.model { displacement = "small", plasticity = not o.without }, frames.light()
  local top, spans = {}, o.spans or 2
  for i = 0, spans do
    local outer = i == 0 or i == spans
    top[i] = model:node { L * i, 0, 3 }
    model:fix(top[i], "y,rx,rz")
    if outer or not o.without then
      local foot = model:node { L * i, 0, 0 }
      model:fix(foot)
      model:member(scenes.with({ section = post, material = light, up = { 1, 0, 0 } }, outer and o.side,
        { foot, top[i] }))
    end
  end
  for i = 1, spans do
    model:member { top[i - 1], top[i], section = box, material = light, up = { 0, 0, 1 }, group = "beams" }
  end
  for i = 1, spans - 1 do
    if o.mass then model:mass { node = top[i], mass = o.mass * P / g } end
    model:case("dead"):load { node = top[i], force = { 0, 0, -P } }
  end
  return model, top
end

return frames

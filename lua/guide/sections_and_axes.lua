-- The signs of section forces, and how an H section is turned: see sections_and_axes.md.
local hinge = require "hinge"

local steel = hinge.material { E = 210e9, nu = 0.3, density = 7850 }
local h = hinge.section.h { depth = 0.19, width = 0.2, web = 0.0065, flange = 0.01 }

-- A cantilever along global X. Its local y is global Z, so its local x is global Y and its local z is global X.
local L = 2
local model = hinge.model { displacement = "small" }
local a, b = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
model:fix(a, "all")
local beam = model:member { a, b, section = h, material = steel, up = { 0, 0, 1 } }

-- At the free end: a force and a moment, named by the local axes that they follow.
local Fz, Fx, Fy, Tz = 2000, 300, 1000, 50
model:load { node = b, force = { Fz, Fx, Fy }, moment = { Tz, 0, 0 } }
local run = model:static { steps = 1 }:finish()

local at_a, at_b = beam:forces(run)
local hand = { N = Fz, Qx = Fx, Qy = Fy, Mx = -Fy * L, My = Fx * L, Mz = Tz }
print "          at a      at b   by hand at a"
for _, name in ipairs { "N", "Qx", "Qy", "Mx", "My", "Mz" } do
  print(("%-3s %10.1f%10.1f%15.1f"):format(name, at_a[name], at_b[name] + 0.0, hand[name]))
end

-- An upright column, pushed along global X at its free head, with its section turned by `up`.
local function sway(up)
  local frame = hinge.model { displacement = "small" }
  local foot, head = frame:node { 0, 0, 0 }, frame:node { 0, 0, 3 }
  frame:fix(foot, "all")
  frame:member { foot, head, section = h, material = steel, up = up }
  frame:load { node = head, force = { 1000, 0, 0 } }
  return 1000 * head:displacement(frame:static { steps = 1 }:finish())
end
local strong, weak = sway { 1, 0, 0 }, sway { 0, 1, 0 }
print(("web along the push %.3f mm, web across it %.3f mm"):format(strong, weak))
print(("Ix = %.0f cm4, Iy = %.0f cm4, their ratio %.2f"):format(1e8 * h.Ix, 1e8 * h.Iy, h.Ix / h.Iy))

return { ratio = weak / strong }

-- A steel moment frame of two storeys with hinges that lose strength, pushed over to a drift of 10 %.
--
-- Run     hinge run scripts/benchmarks/opensees_two_storeys.lua
-- Shows   hinge.backbone, gravity, a leaning column and P-Delta in a published push-over problem
-- Expect  periods and base shear by a run of the published input of OpenSees (MRF_Pushover, concentrated hinges), made
--         apart from hinge, with linear P-Delta. The source has the periods, too: 0.83 and 0.22 s. It has springs of n
--         = 10 times the stiffness of the member, so that a member with its springs has the stiffness EI again where
--         both end moments are alike; where they are not it is stiffer, which makes its periods 0.4 % shorter. A
--         backbone has plastic rotations: the elastic part M / K of a spring's rotations is taken off here.
local hinge = require "hinge"

local inch, kip, ksi = hinge.units.inch, hinge.units.kip, hinge.units.ksi
local n, E = 10, 29000 * ksi
local steel = hinge.material { E = E, G = 1e15, yield_stress = 50 * ksi } -- G: members that do not shear
local height = { [0] = 0, 180 * inch, 324 * inch }
local weight, joint_load, leaning_load = { 535, 525 }, { 68.49, 66.845 }, { 398.02, 391.31 } -- kip
local push = { 16.255, 31.636 } -- kip, on each joint

local function section(A, I, My)
  return hinge.section.general { area = A * inch ^ 2, Ix = I * inch ^ 4, Iy = I * inch ^ 4, J = I * inch ^ 4,
    Mx0 = My and My * kip * inch }
end

-- The backbone of a hinge of a member of the length L (inch): My kip inch; theta_p and theta_pc of its spring, rad.
local function backbone(I, My, L, theta_p, theta_pc)
  local K = n * 6 * 29000 * 1.1 * I / L -- kip inch / rad
  return hinge.backbone { cap_strength = 1.05, cap_rotation = theta_p - 0.05 * My / K,
    post_cap_rotation = theta_pc + 1.05 * My / K, residual = 0.4, ultimate_rotation = 0.4 }
end

-- The frame with its load cases gravity, push, and a unit force at each floor; its nodes by storey.
local function frame(options)
  local model, left, right = hinge.model(options), {}, {}
  local column, beam = section(38.5, 4020, 20350), section(30, 3620, 10938)
  local strut = section(1000, 1e5)
  for storey = 0, 2 do
    left[storey] = model:node { 0, 0, height[storey] }
    right[storey] = model:node { 360 * inch, 0, height[storey] }
    model:fix({ left[storey], right[storey] }, storey == 0 and "all" or "rx")
    if storey > 0 then model:fix(left[storey], "y,rz") end
  end
  local gravity, pushed = model:case "gravity", model:case "push"
  local foot = model:node { 720 * inch, 0, 0 }
  model:fix(foot, "x,y,z,rx,rz")
  for storey = 1, 2 do
    local L = (height[storey] - height[storey - 1]) / inch
    for _, line in ipairs { left, right } do
      model:member { line[storey - 1], line[storey], section = column, material = steel, up = { 1, 0, 0 },
        backbone = backbone(4020, 20350, L, 0.025, 0.3) }
      gravity:load { node = line[storey], force = { 0, 0, -joint_load[storey] * kip } }
      pushed:load { node = line[storey], force = { push[storey] * kip, 0, 0 } }
    end
    model:case("unit" .. storey):load { node = left[storey], force = { 1e3, 0, 0 } }
    model:member { left[storey], right[storey], section = beam, material = steel,
      backbone = backbone(3620, 10938, 360, 0.02, 0.16) }
    -- the leaning column: pinned at each floor, and held to it along x; its upper part stands on the lower one
    local head = model:node { 720 * inch, 0, height[storey] }
    model:fix(head, "rx")
    model:member { foot, head, section = strut, material = hinge.material { E = E, G = 1e15 }, up = { 1, 0, 0 } }
    gravity:load { node = head, force = { 0, 0, -leaning_load[storey] * kip } }
    local floor = { left[storey], right[storey], head }
    if storey == 1 then
      foot = model:node { 720 * inch, 0, height[1] }
      model:fix(foot, "rx")
      floor[4] = foot
      model:connector { head, foot, stiffness = { z = 1e12 } }
    end
    model:diaphragm { nodes = floor }
  end
  return model, left
end

-- The periods of two masses, from the flexibility of the frame in statics.
local function periods()
  local model, left = frame { displacement = "small", plasticity = false }
  local f = {}
  for i = 1, 2 do
    local run = model:static { loads = { ["unit" .. i] = 1 }, steps = 1 }:finish()
    f[i] = { left[1]:displacement(run) / 1e3, left[2]:displacement(run) / 1e3 }
  end
  local m1, m2 = weight[1] * kip / (386.2 * inch), weight[2] * kip / (386.2 * inch)
  local a, d = f[1][1] * m1 + f[2][2] * m2, (f[1][1] * f[2][2] - f[1][2] * f[2][1]) * m1 * m2
  local root = math.sqrt(a ^ 2 / 4 - d)
  return 2 * math.pi * math.sqrt(a / 2 + root), 2 * math.pi * math.sqrt(a / 2 - root)
end

-- Base shear over weight by the drift of the roof in %.
local function push_over(steps)
  local model, left = frame {}
  local rest = model:static { loads = { gravity = 1 }, steps = 2 }:finish()
  local run = model:static { from = rest, loads = { push = 1 }, steps = steps,
    control = { node = left[2], "ux", to = 32.4 * inch } }
  local drift, V = { 0 }, { 0 }
  while run:step() do
    drift[#drift + 1] = 100 * left[2]:displacement(run) / height[2]
    V[#V + 1] = run.factor * 2 * (push[1] + push[2]) / (weight[1] + weight[2])
  end
  assert(run.verdict == "completed", run.reason)
  return drift, V
end

return hinge.benchmark {
  title = "OpenSees moment frame of two storeys, push-over", kind = "inelastic", fast = true,
  source = "run of OpenSees's input (opensees-gallery, MRF_Pushover, concentrated hinges)",
  run = function(b, job)
    local T1, T2 = periods()
    local row = b:rows_with { elements = 18, steps = 200 }
    row("first period", T1, 0.8236, "s", 8e-3, { steps = 1 })
    row("second period", T2, 0.2118, "s", 4e-3, { steps = 1 })
    local drift, V = push_over(200)
    local x = { 0.25, 0.49, 0.74, 0.99, 1.48, 2.01, 2.5, 2.99, 4.01, 5, 7, 10 }
    local y = { 0.0893, 0.1787, 0.2499, 0.2819, 0.2806, 0.2792, 0.2779, 0.2736, 0.2520, 0.2278, 0.1786, 0.1053 }
    local peak = 0
    for _, value in ipairs(V) do peak = value == value and math.max(peak, value) or value end
    row("largest V / W", peak, 0.2819, "", 5e-4)
    for _, i in ipairs { 9, 11, 12 } do
      row(("V / W at a drift of %g %%"):format(x[i]), V[math.floor(x[i] * 20 + 1.5)], y[i], "", 5e-3)
    end
    job:plot({ series = { { x = drift, y = V, name = "hinge" }, { x = x, y = y, name = "OpenSees", style = "points" } },
      x_label = "drift of the roof (%)", y_label = "base shear / weight", title = "Two storeys pushed over" },
      "opensees_two_storeys.png")
  end,
}

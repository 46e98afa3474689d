-- Rigid floors (model:diaphragm) against closed forms: statics, vibration, checkpoints, supports that hold what is
-- joined, also by rigid links, and what is refused.
--
-- Run: lua5.4 tests/script/model/diaphragm_test.lua [BUILD], with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "diaphragms"
local runs = require "runs"(checks)
local case, expect, near = checks.case, checks.expect, checks.near
local done, balanced = runs.completed, runs.balanced

local build = arg[1] or "build"
local E, G = 206e9, 206e9 / 2.6
local bar = hinge.section.solid { width = 0.05, depth = 0.08 }
local function steel(density) return hinge.material { E = E, nu = 0.3, density = density or 7850 } end
-- By integrator: options of a run whose implicit steps are dt.
local function methods(dt)
  return { newmark = { integrator = "newmark", dt = dt }, explicit = { integrator = "explicit", dt = "auto" } }
end

-- Four columns of next to no mass, clamped at their feet, carry a floor that is rigid in its plane.
local height, half_x, half_y, corner = 3, 2, 1.5, 500
local k_x = 1 / (height ^ 3 / (3 * E * bar.Ix) + height / (G * bar.shear_area_y)) -- `up` is x
local k_y = 1 / (height ^ 3 / (3 * E * bar.Iy) + height / (G * bar.shear_area_x))
local k_turn = 4 * (k_x * half_y ^ 2 + k_y * half_x ^ 2 + G * bar.J / height)
local corners = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } }
local function storey(options, density)
  local model = hinge.model(options or { displacement = "small" })
  local heads, feet = {}, {}
  for i, at in ipairs(corners) do
    feet[i] = model:node { at[1] * half_x, at[2] * half_y, 0 }
    heads[i] = model:node { at[1] * half_x, at[2] * half_y, height }
    model:fix(feet[i])
    model:member { feet[i], heads[i], section = bar, material = steel(density or 1e-3), up = { 1, 0, 0 } }
    model:mass { node = heads[i], mass = corner }
  end
  model:diaphragm { nodes = heads }
  return model, heads, feet
end

case("a force beside the centre of a diaphragm shifts and turns the floor", function()
  local model, heads, feet = storey()
  local F = 1000
  model:load { node = heads[2], force = { 0, F, 0 } } -- at x = half_x
  local run = done(model:static { steps = 1 }, "off centre")
  local shift, turn, sum = F / (4 * k_y), F * half_x / k_turn, { 0, 0, 0 }
  for i, at in ipairs(corners) do
    local ux, uy, _, _, _, rz = run:displacement(heads[i])
    near(ux / (-turn * at[2] * half_y), 1, 1e-7, "ux of corner " .. i)
    near(uy / (shift + turn * at[1] * half_x), 1, 1e-7, "uy of corner " .. i)
    near(rz / turn, 1, 1e-7, "rotation of corner " .. i)
    local fx, fy, _, _, _, mz = run:reaction(feet[i])
    sum[1], sum[2] = sum[1] + fx, sum[2] + fy
    sum[3] = sum[3] + mz + at[1] * half_x * fy - at[2] * half_y * fx
  end
  near(sum[1], 0, 1e-6, "reactions along x, N")
  near(sum[2], -F, 1e-6, "reactions along y, N")
  near(sum[3], -F * half_x, 1e-6, "their torque, N m")
  balanced(run, 1e-9, nil, "off centre")
end)

case("a storey with a diaphragm has the three periods worked out by hand", function()
  local turning_mass = 4 * corner * (half_x ^ 2 + half_y ^ 2)
  local wanted = {
    2 * math.pi * math.sqrt(corner / k_x), 2 * math.pi * math.sqrt(corner / k_y),
    2 * math.pi * math.sqrt(turning_mass / k_turn),
  }
  table.sort(wanted, function(one, two) return one > two end)
  local text = ([[
local hinge = require "hinge"
local bar = hinge.section.solid { width = 0.05, depth = 0.08 }
local steel = hinge.material { E = 206e9, nu = 0.3, density = 1e-3 }
local model, heads = hinge.model { displacement = "small" }, {}
for i, at in ipairs { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } } do
  local foot = model:node { at[1] * %g, at[2] * %g, 0 }
  heads[i] = model:node { foot.x, foot.y, %g }
  model:fix(foot)
  model:member { foot, heads[i], section = bar, material = steel, up = { 1, 0, 0 } }
  model:mass { node = heads[i], mass = %g }
end
model:diaphragm { nodes = heads }
model:dynamic { dt = 1e-3, duration = 1e-3 }
]]):format(half_x, half_y, height, corner)
  local _, printed = support.scenes(build)("check", text)
  local found, list = {}, printed:match "natural periods ([^\n]*) s" or ""
  for number in list:gmatch "[%d.e-]+" do found[#found + 1] = tonumber(number) end
  for i, period in ipairs(wanted) do near((found[i] or 0) / period, 1, 1e-3, "period " .. i .. " of hinge check") end
end)

for _, integrator in ipairs { "newmark", "explicit" } do
  case("a floor that is let go sways at its period: " .. integrator, function()
    local w = math.sqrt(k_y / corner)
    for _, displacement in ipairs { "small", "large" } do
      local explicit = integrator == "explicit"
      local model, heads = storey({ displacement = displacement }, explicit and 200 or nil)
      for _, n in ipairs(heads) do model:velocity(n, { 0, 0.01 * w, 0 }) end
      local mass = corner + (explicit and 200 * bar.area * height / 2 or 0)
      local period = 2 * math.pi * math.sqrt(mass / k_y)
      local run = model:dynamic(scenes.with(methods(period / 400)[integrator], { duration = 0.8 * period }))
      local before, crossed = 0, nil
      for step in run:steps() do
        local _, uy = run:displacement(heads[3])
        if before > 0 and uy <= 0 and not crossed then crossed = step.time end
        before = uy
      end
      near((crossed or 0) / (period / 2), 1, explicit and 2e-2 or 5e-3, displacement .. ": half a period")
      balanced(run, 1e-3, nil, displacement)
    end
  end)
end

case("a run that goes on from a checkpoint has the same bits", function()
  for integrator, options in pairs(methods(2e-3)) do
    runs.resumes(function()
      local model, heads = storey({}, 500)
      model:velocity(heads[1], { 0, 1, 0 }, { 0, 0, 0.2 })
      model:gravity { 0, 0, -9.81 }
      local n = { model:node { 9, 0, 0 }, model:node { 9, 0, 1 }, model:node { 9.5, 0, 1 }, model:node { 9.5, 1, 2 } }
      model:member { n[1], n[2], section = bar, material = steel() }
      model:member { n[3], n[4], section = bar, material = steel() }
      model:rigid_link { from = n[2], to = n[3] }
      model:velocity(n[2], { 0, 0, 1 }, { 3, 2, 1 })
      return model:dynamic(scenes.with(options, { duration = 0.06 }))
    end, 0.03, integrator)
  end
end)

case("the plan has a line of links and one of diaphragms", function()
  local model = storey()
  local run = model:static { steps = 1 }
  local line
  for _, effect in ipairs(run.effects) do
    if effect.name == "diaphragms" then line = effect end
  end
  expect(line and line.active and line.because == "1 diaphragm of 4 nodes", "it says: %s", line and line.because)
end)

-- A portal in the plane of x and z, held out of it at all nodes. join(model, heads, feet) declares what joins them.
local function plane_portal(displacement, join, hold)
  local model = hinge.model { displacement = displacement }
  local feet, heads = {}, {}
  for i = 1, 2 do
    feet[i], heads[i] = model:node { 4 * i, 0, 0 }, model:node { 4 * i, 0, 3 + 0.2 * i }
    model:fix(feet[i])
    local held = hold and hold[i] or "y,rx,rz"
    if held ~= "" then model:fix(heads[i], held) end
    model:member { feet[i], heads[i], section = bar, material = steel(), up = { 1, 0, 0 } }
  end
  join(model, heads, feet)
  model:load { node = heads[1], force = { 20, 0, 0 } }
  return model, heads
end

for _, displacement in ipairs { "small", "large" } do
  case("supports that hold both nodes agree with what joins them: displacement " .. displacement, function()
    local joins = {
      diaphragm = function(m, h) m:diaphragm { nodes = h } end,
      ["diaphragm from the other node"] = function(m, h) m:diaphragm { nodes = { h[2], h[1] } } end,
      ["link of places"] = function(m, h) m:rigid_link { from = h[1], to = h[2], dofs = "xyz" } end,
      ["rigid link"] = function(m, h) m:rigid_link { from = h[2], to = h[1] } end,
    }
    -- by hand: what supports hold of the dependent node is left to the constraint
    local by_hand = { diaphragm = { "y,rx,rz", "rx" }, ["diaphragm from the other node"] = { "rx", "y,rx,rz" },
      ["link of places"] = { "y,rx,rz", "rx,rz" }, ["rigid link"] = { "", "y,rx,rz" } }
    for name, join in pairs(joins) do
      for _, kind in ipairs { "static", "newmark", "explicit" } do
        local u = {}
        for i, hold in ipairs { { "y,rx,rz", "y,rx,rz" }, by_hand[name] } do
          local model, heads = plane_portal(displacement, join, hold)
          local run = kind == "static" and model:static { steps = 1 }
            or model:dynamic { dt = 1e-5, duration = 2e-3, integrator = kind }
          done(run, name .. ", " .. kind)
          u[i] = { heads[1]:displacement(run) }
        end
        -- rounding, and where the centre of mass is the reference, the integrator's own error
        local within = kind == "static" and 1e-9 or 1e-4
        for c = 1, 3 do near(u[1][c], u[2][c], within * math.abs(u[2][1]), ("%s, %s, %d"):format(name, kind, c)) end
        expect(math.abs(u[1][1]) > 1e-7, "%s: it moves by %g m", name, u[1][1])
      end
    end
  end)
end

case("feet that are held join a rigid floor, whatever comes first", function()
  local model, heads, feet = storey()
  model:diaphragm { nodes = feet }
  model:load { node = heads[1], force = { 1, 0, 0 } }
  done(model:static { steps = 1 }, "feet in a diaphragm")
end)

case("a support that holds a dependent node alone is refused", function()
  for _, hold in ipairs { { "y,rx,rz", "x,y,rx,rz" }, { "rx", "y,rx,rz" } } do
    local model = plane_portal("small", function(m, h) m:diaphragm { nodes = h } end, hold)
    checks.refused("is held by a support, while that node is free to move it",
      function() model:static { steps = 1 } end)
  end
  local model = plane_portal("small", function(m, h)
    m:diaphragm { nodes = h }
    m:settle { node = h[1], y = 0.01 }
  end)
  checks.refused("is held by a support", function() model:static { steps = 1 } end)
end)

case("wrong diaphragms are refused at their line", function()
  local model, heads, feet = storey()
  for words, options in pairs {
    ["field 'nodes'"] = {}, ["must have two at least"] = { nodes = { feet[1] } },
    ["listed twice"] = { nodes = { feet[1], feet[1] } }, ["field 'normal' is 'w'"] = { nodes = feet, normal = "w" },
    ["must be one of 'nodes'"] = { nodes = feet, master = heads[1] }, ["already"] = { nodes = heads },
  } do
    checks.refused(words, function() model:diaphragm(options) end)
  end
end)

checks.done()

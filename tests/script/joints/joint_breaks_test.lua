-- The force at which joints break: one in all integrators, and a warning where their order hangs on little.
--
-- Run: LUA_CPATH="build/?.so" lua5.4 tests/script/joints/joint_breaks_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "breaks of joints"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local steel = hinge.material { E = 210e9, density = 7850 }
local square = hinge.section.solid { width = 0.1, depth = 0.1 }

case("the tension of a joint has the inertia of the member's end, in explicit steps and in Newmark's", function()
  for _, integrator in ipairs { "newmark", "explicit" } do
    for _, side in ipairs { "a", "b" } do
      local model = hinge.model { formulation = "asi", elements_per_member = 1 }
      local a, b, c = model:node { 0, 0, 0 }, model:node { 3, 0, 0 }, model:node { 6, 0, 0 }
      model:fix(a)
      model:member { a, b, section = square, material = steel }
      local far = model:member { side == "a" and b or c, side == "a" and c or b, section = square, material = steel,
        ends = { [side] = hinge.joint { Mx = { stiffness = 1e7 } } } }
      local P, impulse, before = 1e5, 0, 0
      model:load { node = c, force = { P, 0, 0 } }
      local run = model:dynamic { integrator = integrator, dt = "auto", duration = 4e-3, record = false }
      while run:step() do
        local tension = far:joint(side, run).tension
        impulse, before = impulse + (before + tension) / 2 * run.dt, tension
      end
      -- what pulls the bar, less the joint's impulse, is its momentum
      local momentum = 7850 * 0.01 * 3 * ((b:velocity(run)) + (c:velocity(run))) / 2
      near(impulse / (P * run.time - momentum), 1, integrator == "explicit" and 1e-9 or 1e-3,
        integrator .. ", end " .. side)
    end
  end
end)

case("a run warns where the order in which joints break hangs on little", function()
  -- Two bars hang from brittle joints and are let go; one joint is stronger than the other.
  local function hung(stronger)
    local model = hinge.model {}
    for i, strength in ipairs { 4e4, 4e4 * stronger } do
      local top, low = model:node { i, 0, 3 }, model:node { i, 0, 0 }
      model:fix(top)
      model:member { top, low, section = square, material = steel,
        ends = { a = hinge.joint { Mx = { stiffness = 1e7 }, tension = strength } } }
      model:load { node = low, force = { 0, 0, -3e4 } }
    end
    local run = model:dynamic { dt = "auto", duration = 5e-3, record = false }:finish()
    local told
    for _, warning in ipairs(run.warnings) do
      if support.has(warning, "which of them breaks first may hang on dt") then told = warning end
    end
    return told, run
  end
  local told, run = hung(1.03)
  expect(told and support.has(told, "the joint at end a of member 1 broke at t = "), "3 %% stronger: %s, broken: %s",
    told, run.reason)
  expect(told and support.has(told, "when the joint at end a of member 2 had "), "3 %% stronger: %s", told)
  equal(hung(1.5), nil, "half as strong again")
  equal(hung(1), nil, "alike: in one step")
end)

case("the forces of a joint in statics are those of the load factor, with loads of a run before in full", function()
  for _, by in ipairs { "weight", "load", "weight held" } do
    local model = hinge.model { displacement = "small" }
    local a, b = model:node { 0, 0, 0 }, model:node { 3, 0, 4 }
    model:fix { a, b }
    local bar = model:member { a, b, section = square, material = steel,
      ends = { a = hinge.joint { Mx = { stiffness = 1e7 } }, b = hinge.joint { Mx = { stiffness = 1e6 } } } }
    local dead = model:case "dead"
    if by == "load" then dead:load { member = bar, q = { 0, 0, -800 } } else dead:gravity { 0, 0, -9.80665 } end
    model:case("tip"):load { member = bar, at = 0.3, force = { 0, 0, -100 } }
    local before = by == "weight held" and model:static { loads = { dead = 1 } }:finish() or nil
    local run = model:static { steps = 4, from = before, loads = before and { tip = 1 } or { dead = 1 } }
    while run:step() do
      local f_a, f_b = bar:forces(run)
      for side, f in pairs { a = f_a, b = f_b } do
        local joint, what = bar:joint(side, run), ("%s, end %s, factor %g"):format(by, side, run.factor)
        near(joint.tension, f.N, 1e-6 * math.abs(f.N), "tension; " .. what) -- the iteration ends at 1e-8
        near(joint.shear, math.abs(f.Qy) + math.abs(f.Qx), 1e-6 * math.abs(f.Qy), "shear; " .. what)
      end
    end
  end
end)

checks.done()

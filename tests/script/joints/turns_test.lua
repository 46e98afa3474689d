-- Joints and connectors that turn by more than a turn: the rotation is counted, the moment follows from it, and the
-- axes that are held stay held.
--
-- Run: lua5.4 tests/script/joints/turns_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "turns"
local case, near, expect = checks.case, checks.near, checks.expect
local square = require "scenes".square

case("a pin turns round any number of times, and its other axes stay rigid", function()
  for _, released in ipairs { "Mx", "My" } do
    for _, integrator in ipairs { "explicit", "newmark" } do
      local what = ("%s, %s: "):format(released, integrator)
      local model = hinge.model()
      local wall, tip = model:node { 0, 0, 0 }, model:node { 0, 0, 1 }
      model:fix(wall)
      local rod = model:member { wall, tip, section = square, material = hinge.material { E = 2e9, density = 1200 },
        release = { a = released } }
      if released == "My" then model:velocity(rod, { 0, 6, 0 }, { -12, 0, 0 })
      else model:velocity(rod, { 6, 0, 0 }, { 0, 12, 0 }) end
      local run = model:dynamic { dt = integrator == "explicit" and "auto" or 2e-4, integrator = integrator,
        rho_infinity = integrator == "newmark" and 0.9 or nil, duration = 3, record = false }
      local turns, last = 0, 0
      run:on_step(function(r)
        local x, y, z = tip:displacement(r)
        local angle = math.atan(released == "My" and y or x, 1 + z)
        if angle < last - 1 then turns = turns + 1 end
        last = angle
      end)
      run:finish()
      expect(run.verdict == "completed" and turns >= 3, "%sturns: %d, %s", what, turns, run.reason)
      near(run.energy_error, 0, 1e-3, what .. "energy error")
      near(rod:forces(run)[released], 0, 1e-2, what .. "moment about the pin")
      local x, y = tip:displacement(run)
      near(released == "My" and x or y, 0, 1e-6, what .. "out of the plane")
    end
  end
end)

-- A rod along an axis is wound up against a spring about it by a moment at its end: the angle is the moment over the
-- stiffness. Supports hold its axis.
case("a spring that is wound up by several turns has the moment of all of them, about each axis", function()
  local axes = { x = { 1, 0, 0 }, y = { 0, 1, 0 }, z = { 0, 0, 1 } }
  for name, axis in pairs(axes) do
    local model = hinge.model()
    local a = model:node { 0, 0, 0 }
    local b = model:node { axis[1], axis[2], axis[3] }
    model:fix(a, "x,y,z")
    model:fix(b, (("x,y,z"):gsub(name, ""):gsub(",,", ","):gsub("^,", ""):gsub(",$", "")))
    model:member { a, b, section = square, material = hinge.material { E = 2e9, density = 1200 } }
    local spring = model:connector { a, ground = true, stiffness = { ["r" .. name] = 50 } } -- N m/rad
    local M = 50 * 15 -- 2.4 turns
    model:load { node = a, moment = { M * axis[1], M * axis[2], M * axis[3] } }
    local run = model:static { steps = 20 }:finish()
    expect(run.verdict == "completed", "%s: %s", name, run.reason)
    local all = { spring:deformation(run) } -- x, y, z, rx, ry, rz
    local wound = all[name == "x" and 4 or name == "y" and 5 or 6]
    near(wound, 15, 1e-6, name .. ": angle, rad")
  end
end)

checks.done()

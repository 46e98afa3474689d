-- Eq 16 at its limits, each strain alone and in either direction: bars strained as a closed form says, and rules a
-- little above and below.
--
-- Run: lua5.4 tests/script/effects/fracture_limits_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "fracture limits"
local case, expect, equal = checks.case, checks.expect, checks.equal

-- A cantilever along x, its section's y axis upwards: a moment about the space's y axis bends it about the section's x,
-- one about z about the section's y. Moments and a pull at the tip strain it alike all along: M / (E I) and N / (E A).
local E, area, Ix, Iy = 206e9, 0.004, 3e-5, 8e-6
local M_x, M_y, N = 2e4, 5e3, 3e5
local strain = { curvature_x = M_x / (E * Ix), curvature_y = M_y / (E * Iy), axial_strain = N / (E * area) }
local acting = {
  curvature_x = { moment = { 0, M_x, 0 } }, curvature_y = { moment = { 0, 0, M_y } },
  axial_strain = { force = { N, 0, 0 } },
}

case("a bar breaks at the strain of each limit and not just below it", function()
  -- Takes the bar to its strain by statics and from there through one step; returns whether it broke. `strong`: by how
  -- much its fully plastic resultants are above what acts; without it the bar is elastic.
  local function breaks(load, sign, rule, strong)
    local s = strong or 1
    local section = hinge.section.general { area = area, Ix = Ix, Iy = Iy, J = 1e-5, shear_area_x = 0.003,
      shear_area_y = 0.003, N0 = strong and s * N, Mx0 = strong and s * M_x, My0 = strong and s * M_y,
      Mz0 = strong and 1e6 }
    local signed = {}
    for name, v in pairs(acting[load]) do signed[name] = { sign * v[1], sign * v[2], sign * v[3] } end
    local model = scenes.cantilever(scenes.with(signed, { model = { displacement = "small" },
      member = { section = section, up = { 0, 0, 1 } } }))
    model:fracture(rule)
    local start = model:static({ steps = 1 }):finish()
    equal(start.verdict, "completed", "statics under " .. load)
    local run = model:dynamic({ from = start, dt = 1e-6, duration = 1e-6, rest = false, record = false }):finish()
    equal(run.verdict, "completed", "the step under " .. load)
    return run:count { state = "broken" } == 1
  end

  local near = 1e-6
  for load, there in pairs(strain) do
    local read = {}
    for _, sign in ipairs { 1, -1 } do
      for _, strong in ipairs { false, 1.5 } do
        strong = strong or nil
        local what = ("%s, sign %d%s"):format(load, sign, strong and ", a bar that could yield" or "")
        expect(breaks(load, sign, { [load] = (1 - near) * there }, strong), "%s: holds above its limit", what)
        expect(not breaks(load, sign, { [load] = (1 + near) * there }, strong), "%s: breaks below its limit", what)
        -- the limits of the other strains, however low, are not met
        local others = {}
        for name, value in pairs(strain) do
          if name ~= load then others[name] = 1e-3 * value end
        end
        expect(not breaks(load, sign, others, strong), "%s: breaks by another strain's limit", what)
        -- tension_only spares what is pressed, and nothing else
        local spared = load == "axial_strain" and sign < 0
        equal(breaks(load, sign, { [load] = (1 - near) * there, tension_only = true }, strong), not spared,
          what .. ", tension_only")
      end
      -- what a script's own rule reads is the same strain
      local seen = {}
      breaks(load, sign, { where = "all", rule = function(section)
        for name in pairs(strain) do seen[name] = section[name] end
        return false
      end })
      for name, value in pairs(strain) do
        local wanted = name == load and value or 0
        expect(seen[name] and math.abs(math.abs(seen[name]) - wanted) <= near * value,
          "%s, sign %d: a rule reads %s = %s, wanted %g in size", load, sign, name, seen[name], wanted)
      end
      read[sign] = seen[load]
    end
    expect(read[1] * read[-1] < 0, "%s: a rule reads %g and %g, of one sign, for both directions", load, read[1],
      read[-1])
  end
end)

checks.done()

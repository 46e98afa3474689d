-- hinge.results: sums of reactions and loads with their moments, storeys of bent and leaning columns, what is taken for
-- a storey, and plates of sections of every kind.
--
-- Run: lua5.4 tests/script/results/results_sums_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local results = require "hinge.results"
local profile = require "hinge.results.profile"
local support = require "support"
local checks = support.checks "sums of results"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local folder = support.temporary_folder()
require "hinge.core".own_output(folder, {}, true)
local steel = hinge.material { E = 210e9, nu = 0.3, density = 7850 }
local heb = hinge.section.named "HEB 200"
local soft = hinge.section.solid { width = 0.04, depth = 0.06 }

-- Sums ----------------------------------------------------------------------------------------------------------------

case("sums of reactions and of loads have the moments of forces in space", function()
  local model = hinge.model { displacement = "small" }
  local a, b = model:node { 1, 2, 0 }, model:node { 1, 2, 3 }
  local c, d = model:node { 4, 3, 0 }, model:node { 4, 3, 3 }
  model:fix({ a, c })
  for _, ends in ipairs { { a, b }, { c, d }, { b, d } } do
    model:member { ends[1], ends[2], section = heb, material = steel }
  end
  local F, G, M = { 10e3, -20e3, 30e3 }, { -4e3, 7e3, -50e3 }, { 1e3, 2e3, -3e3 }
  model:load { node = b, force = F, moment = M }
  model:load { node = d, force = G }
  local run = model:static { steps = 1 }:finish()
  local function about(p)
    local sum = { M[1], M[2], M[3] }
    for _, r in ipairs { { { 1, 2, 3 }, F }, { { 4, 3, 3 }, G } } do
      local x, y, z = r[1][1] - p[1], r[1][2] - p[2], r[1][3] - p[3]
      local f = r[2]
      sum[1] = sum[1] + y * f[3] - z * f[2]
      sum[2] = sum[2] + z * f[1] - x * f[3]
      sum[3] = sum[3] + x * f[2] - y * f[1]
    end
    return sum
  end
  for _, point in ipairs { { 0, 0, 0 }, { 2, -1, 5 } } do
    local table_ = results.base(run, { model = model, about = point })
    local loads, sum = table_.rows.loads, table_.rows.sum
    local wanted = about(point)
    for i, name in ipairs { "Fx", "Fy", "Fz" } do
      near(loads[name], F[i] + G[i], 1e-6, name .. " of the loads, N")
      near(sum[name], -F[i] - G[i], 1e-3, name .. " of the reactions, N")
    end
    for i, name in ipairs { "Mx", "My", "Mz" } do
      near(loads[name], wanted[i], 1e-6, name .. " of the loads, N m")
      -- in small displacement forces act where nodes are declared
      near(sum[name], -wanted[i], 1, name .. " of the reactions, N m")
      near(table_.rows.rest[name], 0, 1, name .. ": the rest")
    end
    expect(table_.balanced, "%s", table_.notes[1])
  end
end)

case("loads on members and weight have their moments in small and in large displacement", function()
  for _, displacement in ipairs { "small", "large" } do
    local model = hinge.model { displacement = displacement, elements_per_member = 4 }
    local a, b, c = model:node { 0, 0, 0 }, model:node { 0.5, 0, 3 }, model:node { 4, 1, 3 }
    model:fix(a)
    model:member { a, b, section = heb, material = steel }
    local beam = model:member { b, c, section = heb, material = steel }
    model:load { member = beam, q = { 1e3, -2e3, -8e3 } }
    model:load { member = beam, force = { 3e3, 4e3, -20e3 }, at = 0.3 }
    model:gravity { 0, 0, -10 }
    local run = model:static { steps = 3 }:finish()
    local table_ = results.base(run, { model = model, gravity = { 0, 0, -10 } })
    expect(table_.balanced, "%s", table_.notes[1])
    for _, name in ipairs { "Fx", "Fy", "Fz" } do near(table_.rows.rest[name], 0, 1, displacement .. ": " .. name) end
    -- in large displacement a load within an element acts on its straight line, some mm from the curve
    for _, name in ipairs { "Mx", "My", "Mz" } do
      near(table_.rows.rest[name], 0, displacement == "small" and 1 or 200, displacement .. ": " .. name)
    end
  end
end)

-- Storeys -------------------------------------------------------------------------------------------------------------

case("the shear force of a leaning column that bends far is the force at its head", function()
  for _, lean in ipairs { { 0, 0 }, { 0.8, -0.5 }, { -0.4, 1.1 } } do
    for _, up in ipairs { { 1, 0, 0 }, { 0.3, 1, 0.2 } } do
      for _, F in ipairs { { 900, 0, 0 }, { 0, -700, 0 }, { 600, 800, -2000 } } do
        local model = hinge.model { elements_per_member = 8 }
        local foot, head = model:node { 0, 0, 0 }, model:node { lean[1], lean[2], 4 }
        model:fix(foot)
        model:member { foot, head, section = soft, material = steel, up = up }
        model:load { node = head, force = F }
        local run = model:static { steps = 10 }:finish()
        local row = results.storeys(run, { model = model, levels = { 0, 4 } }).rows[1]
        local moved = { run:displacement(head) }
        expect(math.abs(moved[1]) + math.abs(moved[2]) > 0.1, "it bends far: %g, %g m", moved[1], moved[2])
        -- a place between the nodes of 8 elements, whose axes turn by 0.02 rad from one to the next
        near(row.shear_x, F[1], 0.02 * 900, "x, N")
        near(row.shear_y, F[2], 0.02 * 900, "y, N")
      end
    end
  end
end)

case("levels are those of level members and the lowest node; drifts are over the height", function()
  local model = hinge.model { displacement = "small" }
  local at = {}
  for i = 0, 1 do
    for k, z in ipairs { -1.5, 2, 5 } do
      at[i * 3 + k] = model:node { 6 * i, 0, z }
      if k == 1 then model:fix(at[i * 3 + k]) else
        model:member { at[i * 3 + k - 1], at[i * 3 + k], section = heb, material = steel }
      end
    end
  end
  for k = 2, 3 do model:member { at[k], at[3 + k], section = heb, material = steel } end
  -- a member that rises by 0.9 % of its length is level, and one by 1.1 % is a ramp
  local ramp = model:node { 12, 0, 2 + 6 * 0.011 }
  model:member { at[5], ramp, section = heb, material = steel }
  model:load { node = at[2], force = { 30e3, 0, 0 } }
  model:load { node = at[3], force = { 20e3, 10e3, 0 } }
  local run = model:static { steps = 1 }:finish()
  local rows = results.storeys(run, { model = model }).rows
  equal(#rows, 2, "storeys")
  near(rows[1].from, -1.5, 1e-9, "from")
  near(rows[1].to, 2, 1e-9, "to")
  near(rows[2].to, 5, 1e-9, "the last")
  near(rows[1].shear_x, 50e3, 1, "shear force x, N")
  near(rows[2].shear_x, 20e3, 1, "above")
  near(rows[1].shear_y, 10e3, 1, "y")
  local function drift(k, line, axis)
    local function u(node) return (select(axis, run:displacement(node))) end
    return (u(at[3 * line + k + 1]) - u(at[3 * line + k])) / (k == 1 and 3.5 or 3)
  end
  for axis, name in ipairs { "drift_x", "drift_y" } do
    for k = 1, 2 do
      local first, second = drift(k, 0, axis), drift(k, 1, axis)
      near(rows[k][name], math.abs(first) >= math.abs(second) and first or second, 1e-12, name .. " of storey " .. k)
    end
  end
  for rise, level in pairs { [0.009] = true, [0.011] = false } do
    local frame = hinge.model()
    local p, q = frame:node { 0, 0, 0 }, frame:node { 0, 0, 3 }
    frame:fix(p)
    frame:member { p, q, section = heb, material = steel }
    frame:member { q, frame:node { 5, 0, 3 + 5 * rise }, section = heb, material = steel }
    frame:load { node = q, force = { 1, 0, 0 } }
    local good, floors = pcall(results.storeys, frame:static { steps = 1 }:finish(), { model = frame })
    equal(good, level, "a rise of " .. rise)
    if good then near(floors.rows[1].to, 3 + 2.5 * rise, 1e-9, "the floor is at the middle of its beam") end
  end
end)

case("the table and the plot of storeys have the directions in which something happens", function()
  local function storeys(F)
    local model = hinge.model { displacement = "small" }
    local foot, low, top = model:node { 0, 0, 0 }, model:node { 0, 0, 3 }, model:node { 0, 0, 7 }
    model:fix(foot)
    model:member { foot, low, section = heb, material = steel, up = { 1, 0, 0 } }
    model:member { low, top, section = heb, material = steel, up = { 1, 0, 0 } }
    model:load { node = top, force = F }
    return results.storeys(model:static { steps = 1 }:finish(), { model = model, levels = { 0, 3, 7 } })
  end
  for _, r in ipairs { { { 8e3, 0, 0 }, true, false }, { { 0, 8e3, 0 }, false, true },
    { { 8e3, -2e3, 0 }, true, true } } do
    local found = storeys(r[1])
    local text = found:text()
    equal(text:find("shear x", 1, true) ~= nil, r[2], "x in the table: " .. text)
    equal(text:find("shear y", 1, true) ~= nil, r[3], "y in the table")
    found:plot("shear.svg", { quantity = "shear" })
    local data, commands = support.read(folder .. "/shear.dat"), support.read(folder .. "/shear.gp")
    equal(data:find("largest, x", 1, true) ~= nil, r[2], "x in the plot")
    equal(data:find("largest, y", 1, true) ~= nil, r[3], "y in the plot")
    expect(support.has(commands, "set xrange [0:9.2]"), "1.15 times 8 kN: %s", commands:match "set xrange[^\n]*")
    if r[2] then expect(data:find "8 0\n8 3\n8 3\n8 7\n", "an upright line for each storey: %s", data) end
    found:plot "drift.svg"
    local largest = 0
    for _, row in ipairs(found.rows) do
      largest = support.largest_of(largest, math.abs(row.drift_x), math.abs(row.drift_y))
    end
    local to = tonumber(support.read(folder .. "/drift.gp"):match "set xrange %[0:([%d.e-]+)%]")
    near(to, 115 * largest, 1e-6 * to, "drift in per cent")
  end
end)

-- Plates of sections --------------------------------------------------------------------------------------------------

case("plates, corners and the way of making, of hollow sections of every kind", function()
  -- name, wall mm, outer and inner radius over the wall, made
  for name, r in pairs { ["SHS 150x150x6.3"] = { 6.3, 1.5, 1, "hot" }, ["RHS 200x100x8"] = { 8, 1.5, 1, "hot" },
    ["CFSHS 100x100x4"] = { 4, 2, 1, "cold" }, ["CFRHS 200x100x8"] = { 8, 2.5, 1.5, "cold" },
    ["CFSHS 200x200x12.5"] = { 12.5, 3, 2, "cold" }, ["HSS8X4X1/2"] = { 0.465 * 25.4, nil, nil, "cold" } } do
    local s = hinge.section.named(name)
    local p = assert(profile.of(s))
    equal(p.made, r[4], name .. ": how it is made")
    near(p.tw, r[1] / 1e3, 1e-8, name .. ": web")
    near(p.tf, r[1] / 1e3, 1e-8, name .. ": flange")
    near(p.hw, s.depth - 2 * p.tf, 1e-8, name .. ": h_w")
    near(p.c_web, s.depth - 3 * p.tw, 1e-8, name .. ": c of the web, h - 3 t")
    near(p.c_flange, s.width - 3 * p.tw, 1e-8, name .. ": c of the flange, b - 3 t")
    if r[2] then
      near(p.r, r[2] * r[1] / 1e3, 1e-8, name .. ": outer radius")
      near(p.r_inner, r[3] * r[1] / 1e3, 1e-8, name .. ": inner radius")
    end
  end
  for i, ratio in ipairs { { 2.5, 1.5 }, { 3.5, 2.5 } } do -- BCR and BCP
    local name = i == 1 and "BCR 300x300x12" or "BCP 400x400x19"
    local good, s = pcall(hinge.section.named, name)
    if good then
      local p = assert(profile.of(s))
      equal(p.made, "cold", name)
      near(p.r / p.tw, ratio[1], 1e-6, name .. ": outer radius")
      near(p.r_inner / p.tw, ratio[2], 1e-6, name .. ": inner radius")
    else expect(false, "%s: %s", name, s) end
  end
  local box = profile.of(hinge.section.box { width = 0.2, depth = 0.3, web = 0.01, flange = 0.02 })
  near(box.c_web, 0.26, 1e-9, "a welded box: c of the web")
  near(box.c_flange, 0.18, 1e-9, "c of the flange")
  equal(box.made, "welded", "a welded box")
  equal(box.r, 0, "no radius")
  local tube = profile.of(hinge.section.pipe { diameter = 0.2, thickness = 0.008 })
  near(tube.tw, 0.008, 1e-9, "a pipe: wall")
  equal(tube.made, "cold", "a pipe without a name")
  equal(profile.of(hinge.section.named "CHS 244.5x10").made, "hot", "CHS")
end)

case("plates of H sections and bars", function()
  local h = profile.of(hinge.section.named "IPE 400")
  near(h.c_web, 0.4 - 0.027 - 0.042, 1e-6, "h - 2 tf - 2 r")
  near(h.c_flange, (0.18 - 0.0086 - 0.042) / 2, 1e-6, "(b - tw - 2 r) / 2")
  near(h.r, 0.021, 1e-6, "r")
  near(h.warping, hinge.section.named "IPE 400".Iy * 0.3865 ^ 2 / 4, 1e-12, "I_w")
  local welded = profile.of(hinge.section.h { depth = 0.4, width = 0.2, web = 0.01, flange = 0.02 })
  equal(welded.made .. " " .. welded.r, "welded 0", "an H without fillets")
  near(welded.c_flange, 0.095, 1e-9, "(b - tw) / 2")
  local bar, round = profile.of(hinge.section.solid { width = 0.02, depth = 0.1 }),
    profile.of(hinge.section.round { diameter = 0.08 })
  equal(("%s %g %g"):format(bar.shape, bar.b, bar.d), "rectangle 0.02 0.1", "a bar")
  equal(("%s %g %g"):format(round.shape, round.b, round.d), "round 0.08 0.08", "a round bar")
  for _, name in ipairs { "UPN 200", "L 100x100x10" } do
    local good, s = pcall(hinge.section.named, name)
    expect(good and not profile.of(s), "%s has no plates that are known", name)
  end
end)

checks.done()

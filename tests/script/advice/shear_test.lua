-- Warnings of shear forces that take bending strength from sections, by EN 1993-1-1 6.2.6 and 6.2.8.
--
-- Run: lua5.4 tests/script/advice/shear_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "shear"
local case, expect, near = checks.case, checks.expect, checks.near

local fy = 300e6

local function text_of(run)
  for _, w in ipairs(run.warnings) do
    local text = type(w) == "table" and w.text or w
    if text:find("V / V0", 1, true) then return text end
  end
end

--- A cantilever that is pushed across its end until it bends without limit: V0 and M0 are those of the section.
--- `towards` 2: along the section's y.
local function pushed(section, moment, length, towards, formulation)
  local steel = hinge.material { E = 210e9, density = 7850, yield_stress = fy }
  local model = hinge.model { displacement = "small", formulation = formulation }
  local foot, tip = model:node { 0, 0, 0 }, model:node { length, 0, 0 }
  model:fix(foot)
  model:member { foot, tip, section = section, material = steel, up = { 0, 0, 1 } }
  local force = { 0, 0, 0 }
  force[towards == 2 and 3 or 2] = 1.5 * moment / length
  model:load { node = tip, force = force }
  local run = model:static { to_limit = true, steps = 30, record = false }
  run:finish()
  return run
end

--- V / V0, the moment, and what is left of it, as the warning says; the first two to two digits.
local function numbers(text)
  local v, m = text:match "V / V0 = ([%d.]+) along %a and ([%d.]+) of"
  return tonumber(v), tonumber(m), tonumber(text:match "leaves ([%d.]+) of" or "nan")
end

local h = hinge.section.h { depth = 0.3, width = 0.15, web = 0.0071, flange = 0.0107 }
local clear = 0.3 - 2 * 0.0107

case("the moment that shear leaves to an H: its web's part of the plastic modulus", function()
  local M0, V0 = fy * h.Zx, fy / math.sqrt(3) * 0.0071 * clear
  local share = 0.0071 * clear ^ 2 / 4 / h.Zx
  local least, most = math.huge, 0
  for _, v in ipairs { 0.85, 0.95, 1.05 } do
    local text = text_of(pushed(h, M0, M0 / (v * V0), 2))
    expect(text, "no warning at V / V0 = %g", v)
    local found, m, left = numbers(text)
    near(found, v, 0.6 * 10 ^ -(v > 1 and 1 or 2), "V / V0, two digits")
    near(m, 1, 0.006, "the plastic moment is reached")
    near(left, 1 - share * math.min(1, 2 * v - 1) ^ 2, 0.006, "what EN 1993-1-1 6.2.8(3) leaves")
    least, most = math.min(least, left), support.largest_of(most, left)
  end
  expect(least < most, "shear takes more as it grows")
end)

case("no warning where shear takes less than a tenth, and none of a beam of usual length", function()
  local M0, V0 = fy * h.Zx, fy / math.sqrt(3) * 0.0071 * clear
  for _, v in ipairs { 0.1, 0.45, 0.6 } do
    local text = text_of(pushed(h, M0, M0 / (v * V0), 2))
    expect(not text, "a warning at V / V0 = %g: %s", v, text)
  end
end)

case("no warning where the end of an element has more than M0 because its hinge is in the middle", function()
  local M0, V0 = fy * h.Zx, fy / math.sqrt(3) * 0.0071 * clear
  local text = text_of(pushed(h, M0, M0 / (0.5 * V0), 2, "conventional"))
  expect(not text, "%s", text)
end)

case("more than the shear strength is said, also where the shape is not known", function()
  local general = hinge.section.general { area = h.area, Ix = h.Ix, Iy = h.Iy, J = h.J, shear_area_x = h.shear_area_x,
    shear_area_y = h.shear_area_y, plastic = { A = h.area, Zx = h.Zx, Zy = h.Zy, Zz = h.Zz } }
  local M0, V0 = fy * h.Zx, fy / math.sqrt(3) * 0.0071 * clear
  local text = text_of(pushed(general, M0, M0 / (1.3 * V0), 2))
  expect(text and text:find("more than its plastic shear strength", 1, true), "%s", text)
  expect(not text_of(pushed(general, M0, M0 / (0.95 * V0), 2)), "a warning at V / V0 = 0.95")
end)

case("areas by EN 1993-1-1 6.2.6(3): all of a solid section, 2 A / pi of a pipe; an H's flanges along x", function()
  local solid = hinge.section.solid { width = 0.1, depth = 0.2 }
  local pipe = hinge.section.pipe { diameter = 0.3, thickness = 0.01 }
  local all = {
    { solid, solid.Zx, solid.area, 2, "solid" },
    { pipe, pipe.Zx, 2 * pipe.area / math.pi, 2, "pipe" },
    { h, h.Zy, 2 * 0.15 * 0.0107, 1, "flanges" },
  }
  for _, of in ipairs(all) do
    local section, Z, area, towards, name = table.unpack(of)
    local M0, V0 = fy * Z, fy / math.sqrt(3) * area
    local text = text_of(pushed(section, M0, M0 / (0.8 * V0), towards))
    expect(text, "%s: no warning at V / V0 = 0.8", name)
    local v, _, left = numbers(text)
    near(v, 0.8, 0.006, name .. ": V / V0")
    near(left, 1 - 0.6 ^ 2, 0.006, name .. ": what is left of the moment")
  end
end)

checks.done()

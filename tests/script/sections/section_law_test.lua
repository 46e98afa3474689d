-- Laws of sections: with the exact interaction of N, Mx and My members carry what closed forms give, in statics and in
-- all integrators; the energy balance closes; a run resumes to the same bytes; wrong input is refused.
--
-- Run: lua5.4 tests/script/sections/section_law_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local core = require "hinge.core"
local scenes = require "scenes"
local law_scenes = require "sections.law_scenes"
local checks = support.checks "section law"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local fy, L = 235e6, 3
local steel = hinge.material { E = 210e9, density = 7850, yield_stress = fy }
local shapes = {
  HEB = { hinge.section.h, { depth = 0.3, width = 0.3, web = 0.011, flange = 0.019 } },
  ["rolled HEB"] = { hinge.section.h, { depth = 0.3, width = 0.3, web = 0.011, flange = 0.019, r = 0.027 } },
  RHS = { hinge.section.box, { depth = 0.2, width = 0.1, thickness = 0.008 } },
  pipe = { hinge.section.pipe, { diameter = 0.2, thickness = 0.005 } },
  solid = { hinge.section.solid, { width = 0.1, depth = 0.15 } },
}
local function section(name, law)
  return (shapes[name][1](scenes.with({ interaction = law }, shapes[name][2])))
end

-- n: the axial force over its plastic one.
local function cantilever(of, n, push, options)
  return law_scenes.pressed({ model = options, member = { section = of, material = steel } }, n * of.plastic_area * fy,
    push)
end
local function limit(scene) return law_scenes.limit(checks, scene) end

case("the moment beside N is that of closed forms, about both axes, in tension and compression", function()
  for name in pairs(shapes) do
    for axis = 1, 2 do
      for _, n in ipairs { 0.15, -0.5, 0.9 } do
        for _, law in ipairs { "exact", "paper" } do
          local of = section(name, law)
          local Mp = fy * (axis == 1 and of.Zx or of.Zy)
          local push = axis == 1 and { 0, 1.2 * Mp / L } or { 1.2 * Mp / L, 0 }
          local wanted = law == "exact" and select(axis, of:reduced_moments(n)) or math.sqrt(1 - n ^ 2)
          local factor, run = limit(cantilever(of, n, push))
          near(1.2 * factor, wanted, 2e-5, ("%s, axis %d, n %g, %s"):format(name, axis, n, law))
          local told = false
          for _, w in ipairs(run.warnings) do
            told = told or tostring(w):find 'eq 14, interaction = "paper", is unsafe' ~= nil
          end
          if law == "exact" then equal(told, false, "a warning of eq 14") end
        end
      end
    end
  end
end)

case("without the option a section has the exact interaction, and one of unknown shape eq 14", function()
  local of = section("rolled HEB", nil)
  local push = { 0, 1.2 * fy * of.Zx / L }
  near(1.2 * limit(cantilever(of, -0.5, push)), of:reduced_moments(0.5), 2e-5, "by default")
  near(1.2 * limit(cantilever(of, -0.5, push, { interaction = "paper" })), math.sqrt(0.75), 2e-5, "eq 14 of the model")
  local unknown = hinge.section.general { area = of.area, Ix = of.Ix, Iy = of.Iy, J = of.J,
    plastic = { A = of.area, Zx = of.Zx, Zy = of.Zy } }
  near(1.2 * limit(cantilever(unknown, -0.5, push)), math.sqrt(0.75), 2e-5, "a section without an outline")
end)

-- A rectangle whose neutral axis goes through the sides: my = 2 t / 3, mx = 1 - t^2 / 3, 0 <= t <= 1.
case("in biaxial bending a rectangle carries what its neutral axis gives", function()
  for _, t in ipairs { 0.2, 0.6, 1 } do
    local of = section("solid", "exact")
    local mx, my = 1 - t ^ 2 / 3, 2 * t / 3
    local c = cantilever(of, 0, { 1.3 * my * fy * of.Zy / L, 1.3 * mx * fy * of.Zx / L })
    local factor, run = limit(c)
    near(1.3 * factor, 1, 2e-5, ("t %g"):format(t))
    local at_wall = c.member:forces(run)
    near(at_wall.f_y, 1, 5e-5, "f_y of a section that flows")
  end
end)

-- What of the member's first end is read, drawn and listed: sqrt(f_y).
local function utilisations(c, run)
  local piece = core.pieces(run).bars[1]
  local of = { forces = c.member:forces(run).f_y, state = select(2, c.member:state(run)), read = run:read("f_y")[1],
    picture = piece.f_y, ["picture, first end"] = (piece.f_y_along or {})[1],
    hinges = run:hinges()[1] and run:hinges()[1].f_y }
  for name, f_y in pairs(of) do of[name] = math.sqrt(f_y) end
  return of, core.pieces(run)
end

case("utilisation is that of the section's law, not of eq 14: beside N / N0 = 0.5", function()
  local of = section("rolled HEB", "exact")
  local m = of:reduced_moments(0.5)
  local c = cantilever(of, -0.5, { 0, 1.2 * fy * of.Zx / L })
  local factor, run = limit(c)
  near(1.2 * factor, m, 2e-5, "the exact plastic moment beside N")
  local values, pieces = utilisations(c, run)
  for _, name in ipairs { "forces", "state", "read", "picture", "picture, first end" } do -- nothing has flowed yet
    near(values[name] or math.huge, 1, 5e-5, name .. ": utilisation at the surface")
  end
  -- the middle of the first of two elements has 3/4 of the moment: all of its forces over their utilisation are on the
  -- surface
  local low, high = 0.5, 1
  for _ = 1, 40 do
    local u = (low + high) / 2
    if 0.75 * m / u > of:reduced_moments(0.5 / u) then low = u else high = u end
  end
  near(math.sqrt(pieces.bars[1].f_y_along[2]), low, 5e-5, "utilisation in the middle of the first element")
  equal(table.concat(pieces.laws, "; "), "exact", "the law that pictures name")
  -- the same forces by eq 14
  local other = cantilever(section("rolled HEB", "paper"), -0.5, { 0, m * fy * of.Zx / L })
  local held = other.model:static { loads = { axial = 1 } }:finish()
  run = other.model:static { from = held, loads = { push = 1 } }:finish()
  values, pieces = utilisations(other, run)
  near(values.forces, math.sqrt(0.25 + m ^ 2), 1e-5, "by eq 14")
  expect(values.forces < 0.8, "clearly below 1: %g", values.forces)
  equal(values["picture, first end"], nil, "pictures have what follows from the forces")
  equal(#pieces.laws, 0, "and name no law")
end)

-- Bent beyond yield and back: the surface has moved, and at its border eq 14 has another value.
case("utilisation counts hardening: a section that flows has 1", function()
  for _, law in ipairs { "exact", "paper" } do
    local of = section("rolled HEB", law)
    local hard = hinge.material { E = 210e9, density = 7850, yield_stress = fy, hardening = { tangent = 10e9 } }
    local model, tip, member = scenes.cantilever { model = { displacement = "small" }, length = L,
      force = { 0, 0, fy * of.Zx / L }, member = { section = of, material = hard, up = { 0, 0, 1 } } }
    local run
    for _, to in ipairs { 0.2, 0.1 } do
      run = model:static { from = run, steps = 20, control = { node = tip, "uz", to = to } }:finish()
      local values, pieces = utilisations({ member = member }, run)
      local of_eq14 = math.abs(member:forces(run).Mx) / (fy * of.Zx)
      expect(math.abs(of_eq14 - 1) > 0.1, "%s: eq 14 would have %g", law, of_eq14)
      for _, name in ipairs { "forces", "state", "read", "picture", "picture, first end", "hinges" } do
        near(values[name] or math.huge, 1, 1e-4, ("%s, %s at %g m"):format(law, name, to))
      end
      equal(table.concat(pieces.laws, "; "), (law == "exact" and "exact" or "eq 14") .. ", hardening", "laws")
    end
  end
end)

-- Its one history is that of the middle, and holds at its ends too.
case("a conventional element with hardening counts it at both ends", function()
  local of = section("HEB", "exact")
  local Mp = fy * of.Zx
  local hard = hinge.material { E = 210e9, density = 7850, yield_stress = fy, hardening = { tangent = 10e9 } }
  local model = hinge.model { displacement = "small", formulation = "conventional" }
  local n = { model:node { 0, 0, 0 }, model:node { 1, 0, 0 }, model:node { 3, 0, 0 } }
  local root = model:member { n[1], n[2], section = of, material = hard, up = { 0, 0, 1 }, elements = 1 }
  model:member { n[2], n[3], section = of, material = hard, up = { 0, 0, 1 }, elements = 1 }
  model:fix(n[1], "all")
  model:load { node = n[3], force = { 0, 0, Mp } }
  local run = model:static { steps = 20, control = { node = n[3], "uz", to = 0.2 } }:finish()
  local at = { root:forces(run) }
  local middle = math.abs(at[1].Mx + at[2].Mx) / 2
  expect(middle > 1.05 * Mp, "the middle has hardened: %g", middle / Mp)
  for i, side in ipairs(at) do
    near(side.f_y, (1 + (math.abs(side.Mx) - middle) / Mp) ^ 2, 1e-4, "end " .. i)
  end
end)

case("the model's option holds for the sections that do not say theirs", function()
  local general = hinge.section.general { area = 0.01, Ix = 1e-4, Iy = 1e-4, J = 1e-5,
    plastic = { A = 0.01, Zx = 5e-4, Zy = 5e-4 } }
  local function factor(of, law)
    return (limit(cantilever(of, 0.6, { 0, 1.2 * fy * of.Zx / L }, { interaction = law })))
  end
  local exact = section("HEB"):reduced_moments(0.6)
  near(1.2 * factor(section "HEB", "exact"), exact, 1e-5, "by the model")
  near(1.2 * factor(section("HEB", "paper"), "exact"), 0.8, 1e-5, "the section's own word")
  near(1.2 * factor(section("HEB", "exact"), "paper"), exact, 1e-5, "the section's own word, exact")
  near(1.2 * factor(general, "exact"), 0.8, 1e-5, "a section whose shape is not known has eq 14")
  equal(section("HEB", "exact").interaction, "exact", "section.interaction")
  equal(section("HEB").interaction, nil, "section.interaction where none is given")
end)

case("an outline of one's own: an angle about its centroid", function()
  local corners = { { 0, 0 }, { 0.1, 0 }, { 0.1, 0.01 }, { 0.01, 0.01 }, { 0.01, 0.1 }, { 0, 0.1 } }
  local of = hinge.section.general { area = 0.0019, Ix = 1.8e-6, Iy = 1.8e-6, J = 6e-8,
    outline = { { corners = corners } }, plastic = { A = 0.0019, Zx = 3.2e-5, Zy = 3.2e-5 }, interaction = "exact" }
  local factor = limit(cantilever(of, 0, { 0, 1.5 * fy * of.Zx / L }))
  expect(factor > 0.3 and factor < 1.01 / 1.5, "carries %g of Mx0", 1.5 * factor)
end)

-- Its neutral axis halves the area, and is not the one through the centroid.
case("a channel carries Zy fy about its weak axis, either way", function()
  local of = hinge.section.channel { depth = 0.2, width = 0.075, web = 0.0085, flange = 0.0115, interaction = "exact" }
  for _, side in ipairs { 1, -1 } do
    local factor = limit(cantilever(of, 0, { side * 1.2 * fy * of.Zy / L, 0 }))
    near(1.2 * factor, 1, 2e-5, ("side %d"):format(side))
  end
end)

-- A portal with a blow at its corners that makes hinges.
local function portal(law)
  return law_scenes.struck({ model = { interaction = law }, column = { section = section "HEB", material = steel },
    beam = { section = section "RHS", material = steel } }, { 6, 1.5, -2 })
end

case("in dynamics the energy balance closes, and three integrators dissipate the same", function()
  law_scenes.balances(checks, function() return portal "exact" end, { duration = 0.15, error = 1e-3, explicit = 0.01 })
end)

case("a run that was saved while hinges turn goes on to the same bytes", function()
  law_scenes.resumes(checks, function() return portal "exact" end, { steps = 300, duration = 0.12,
    others = { [function() return portal "paper" end] = "options of the model" } })
end)

case("wrong input", function()
  checks.refused("one of paper, exact", section, "HEB", "exakt")
  checks.refused("'paper', 'exact'", hinge.model, { interaction = "best" })
  for words, more in pairs {
    ["needs the section's shape"] = { interaction = "exact" },
    ["three or more"] = { outline = { { corners = { { 0, 0 }, { 1, 1 } } } } },
    ["must be {x, y}"] = { outline = { { corners = { { 0, 0 }, { 1, 1 }, { 1, "a" } } } } },
    ["on one line"] = { outline = { { corners = { { 0, 0 }, { 1, 1 }, { 2, 2 } } } } },
    ["either 'corners'"] = { outline = { {} } },
    ["area must be above 0"] = { outline = { { diameter = 0.1 }, { diameter = 0.2, hole = true } } },
    ["may differ by 2 %"] = { outline = { { diameter = 0.1 } } },
  } do
    checks.refused(words, hinge.section.general, scenes.with({ area = 0.01, Ix = 1e-4, Iy = 1e-4, J = 1e-5 }, more))
  end
end)

checks.done()

-- Sections of reinforced concrete: columns carry the moment beside N that closed forms give; strengths and stiffness
-- follow from the options; the energy balance closes in all integrators; a run resumes to the same bytes.
--
-- Run: lua5.4 tests/script/sections/concrete_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local scenes = require "scenes"
local law_scenes = require "sections.law_scenes"
local checks = support.checks "concrete"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local L = 3
local material = hinge.material.concrete "C30/37"
local b, d, edge, As = 0.4, 0.5, 0.05, math.pi / 4 * 0.02 ^ 2
local fc, fy, fyc = 30e6, 500e6, 400e6

local with = scenes.with

-- Bars: `top` and `bottom` of them in two layers.
local function section(top, bottom, more)
  local bars = {}
  for side, count in pairs { [1] = top, [-1] = bottom } do
    for i = 1, count do
      bars[#bars + 1] = { (b - 2 * edge) * ((i - 1) / (count - 1) - 0.5), side * (d / 2 - edge), diameter = 0.02 }
    end
  end
  local options = with({ width = b, depth = d, concrete = fc, steel = fy, bars = bars, effectiveness = 1 }, more)
  if more and more.strains then options.effectiveness = more.effectiveness end
  return (hinge.section.concrete(options)) -- no tail call: a refusal names this line
end

-- By hand, where both layers yield: a, depth of the block that is pressed, from the side `side` (1: the top). N, M.
local function by_hand(a, side, top, bottom)
  local pressed, pulled = side == 1 and top or bottom, side == 1 and bottom or top
  local arm = d / 2 - edge
  return -fc * b * a - (fyc - fc) * pressed * As + fy * pulled * As,
    fc * b * a * (d - a) / 2 + (fyc - fc) * pressed * As * arm + fy * pulled * As * arm
end

local function cantilever(of, N, push)
  return law_scenes.pressed({ member = { section = of, material = material } }, N, push)
end
local function limit(scene) return law_scenes.limit(checks, scene) end

case("a column carries M(N) / L, of closed forms, with the top pressed and with the bottom pressed", function()
  local of = section(2, 4)
  for _, side in ipairs { 1, -1 } do
    for _, a in ipairs { 0.09, 0.2, 0.32, 0.4 } do
      local N, M = by_hand(a, side, 2, 4)
      local Mx = of:plastic_moments(N, side == 1 and math.pi or 0)
      near(math.abs(Mx) / M, 1, 1e-9, ("plastic_moments, side %d, a %g"):format(side, a))
      -- a push upwards presses the top at the wall
      local factor, run = limit(cantilever(of, N, { 0, side * 1.2 * M / L }))
      near(1.2 * factor, 1, 1e-3, ("a run, side %d, a %g"):format(side, a))
      near(run.energy_error, 0, 1e-3, "energy error")
    end
  end
end)

case("about the weak axis, in tension and in biaxial bending a run ends on the surface", function()
  local of = section(3, 3)
  for _, c in ipairs { { -1.5e6, 0.5 }, { 2e5, 0.5 }, { 0, 0.25 }, { -2e6, 0.15 } } do
    local N, angle = c[1], c[2] * math.pi
    local Mx, My = of:plastic_moments(N, angle)
    local scene = cantilever(of, N, { 1.2 * My / L, -1.2 * Mx / L })
    local factor, run = limit(scene)
    near(1.2 * factor, 1, 1e-3, ("N %g, angle %g"):format(N, angle))
    near(scene.member:forces(run).f_y, 1, 1e-3, "f_y")
  end
end)

case("of all moments beside N those of a curvature do the most work on it", function()
  local of = section(2, 4)
  for _, N in ipairs { 3e5, -1e6, -4e6 } do
    for _, angle in ipairs { 0.3, 1, 2.5, 4 } do
      local x, y = of:plastic_moments(N, angle)
      for i = 1, 24 do
        local X, Y = of:plastic_moments(N, angle + i * math.pi / 12.5)
        local less = math.cos(angle) * (x - X) + math.sin(angle) * (y - Y)
        expect(less > -1e-6 * of.Mx0, "N %g, angle %g: another point has %g N m more", N, angle, -less)
      end
    end
  end
end)

case("N0 and the moments beside no axial force", function()
  local of = section(2, 4)
  near(of.N0 / (fc * (b * d - 6 * As) + fyc * 6 * As), 1, 1e-9, "N0, in compression")
  near(of.Mx0, support.largest_of(math.abs((of:plastic_moments(0, 0))),
    math.abs((of:plastic_moments(0, math.pi)))), 1e-3, "Mx0")
  near(select(2, of:plastic_moments(0, math.pi / 2)) / of.My0, 1, 1e-9, "My0")
  equal(of:reduced_moments(0.3), nil, "reduced_moments")
  equal(hinge.section.solid({ width = 1, depth = 1 }):plastic_moments(0), nil, "plastic_moments of steel")
  local pulled = of:plastic_moments(6 * As * fy)
  near(math.abs(pulled) / (2 * As * fy * (d / 2 - edge)), 1, 1e-6, "moment beside pure tension, of two more bars")
end)

case("grades by their names; the effectiveness; the bars in compression", function()
  local by_name = section(3, 3, { concrete = "C30/37", steel = "B500B" })
  equal(by_name.N0, section(3, 3).N0, "C30/37 and B500B")
  local less = section(3, 3, { effectiveness = 0.9 })
  near(section(3, 3).N0 - less.N0, 0.1 * fc * (b * d - 6 * As), 1, "effectiveness 0.9")
  near(section(3, 3, { bar_compression = 500e6 }).N0 - section(3, 3).N0, 100e6 * 6 * As, 1, "bars of 500 MPa")
  local plastic = hinge.section.concrete { width = b, depth = d, concrete = fc, steel = fy, strains = "plastic",
    bars = { { 0, 0, area = 6 * As } } }
  near(plastic.N0 / (0.95 * fc * (b * d - 6 * As) + fyc * 6 * As), 1, 1e-9, "the defaults of strains = 'plastic'")
end)

-- A section whose ultimate states are known by hand: `top` and `bottom` bars in two layers. Strains of table 3.1.
local function ultimate(grade, strains)
  local bars = {}
  for _, side in ipairs { 1, -1 } do
    for i = -1, 1 do bars[#bars + 1] = { 0.15 * i, side * (d / 2 - edge), diameter = 0.02 } end
  end
  return hinge.section.concrete { width = b, depth = d, concrete = grade, steel = fy, strains = strains, bars = bars }
end

-- N and M of the neutral axis at the depth x, by 4000 strips.
local function state(f, x, peak, last, n)
  local N, M = 0, 0
  local function strain(down)
    if x <= d then return last * (x - down) / x end
    return peak * (x - down) / (x - (1 - peak / last) * d)
  end
  local function stress(e) return e <= 0 and 0 or e >= peak and f or f * (1 - (1 - e / peak) ^ n) end
  for i = 1, 4000 do
    local down = (i - 0.5) / 4000 * d
    local force = stress(strain(down)) * b * d / 4000
    N, M = N - force, M + force * (d / 2 - down)
  end
  for _, down in ipairs { edge, d - edge } do
    local e = strain(down)
    local bar = 200e9 * e
    bar = bar > fy and fy or bar < -fy and -fy or bar
    local force = 3 * As * (bar - stress(e))
    N, M = N - force, M + force * (d / 2 - down)
  end
  return N, M
end

case("ultimate strains of EN 1992-1-1, up to C90/105: moments beside N", function()
  for _, c in ipairs { { "C30/37", 30e6, 0.002, 0.0035, 2 }, { "C50/60", 50e6, 0.002, 0.0035, 2 },
    { "C70/85", 70e6, 0.002 + 0.085e-3 * 20 ^ 0.53, 0.0026 + 0.035 * 0.2 ^ 4, 1.4 + 23.4 * 0.2 ^ 4 },
    { "C90/105", 90e6, 0.0026, 0.0026, 1.4 } } do
    local of = ultimate(c[1])
    for _, x in ipairs { 0.07, 0.12, 0.2, 0.3, 0.4, 0.5, 0.7 } do
      local N, M = state(c[2], x, c[3], c[4], c[5])
      -- along N and M together, from the middle of N
      local middle = (3 * 2 * As * fy - of.N0) / 2
      local low, high = 0.8, 1.2
      for _ = 1, 30 do
        local t = (low + high) / 2
        local ok, Mx = pcall(of.plastic_moments, of, middle + t * (N - middle), math.pi)
        if ok and -Mx > t * M then low = t else high = t end
      end
      near(low, 1, 0.02, ("%s, x %g m"):format(c[1], x))
    end
    local N = state(c[2], 1e6, c[3], c[4], c[5])
    near(of.N0 / -N, 1, 1e-6, c[1] .. ": N0")
  end
end)

case("ACI 318-19, 22.2.2: moments beside N by the block of beta_1 times the neutral axis, by hand", function()
  -- f'c of 24, 30 and 60 MPa: 22.2.2.4.3
  for fc_, beta_1 in pairs { [24e6] = 0.85, [30e6] = 0.85 - 0.05 * 2 / 7, [60e6] = 0.65 } do
    local of = ultimate(fc_, "ACI 318")
    for _, x in ipairs { 0.1, 0.2, 0.3, 0.4, 0.55 } do
      local a = support.smallest_of(beta_1 * x, d)
      local force = 0.85 * fc_ * b * a
      local N, M = -force, force * (d - a) / 2
      for _, down in ipairs { edge, d - edge } do
        local bar = 200e9 * 0.003 * (x - down) / x
        bar = bar > fy and fy or bar < -fy and -fy or bar
        local own = 3 * As * (bar - (down < a and 0.85 * fc_ or 0))
        N, M = N - own, M + own * (d / 2 - down)
      end
      near(-of:plastic_moments(N, math.pi) / M, 1, 0.02, ("f'c %g Pa, x %g m"):format(fc_, x)) -- as those of EN
    end
  end
end)

case("ultimate strains by runs, and by the block of ACI 318", function()
  for _, of in ipairs { ultimate "C30/37", ultimate("C90/105"), ultimate(30e6, "ACI 318") } do
    for _, N in ipairs { 2e5, -5e5, -2e6 } do
      local Mx = of:plastic_moments(N, math.pi)
      local factor, run = limit(cantilever(of, N, { 0, -1.2 * Mx / L }))
      near(1.2 * factor, 1, 1e-3, ("a run beside %g N"):format(N))
      near(run.energy_error, 0, 1e-3, "energy error")
    end
  end
  -- ACI 318-19, 22.2 and 22.4: N0 is 0.85 f'c of the concrete and the yield stress of the bars
  near(ultimate(30e6, "ACI 318").N0 / (0.85 * 30e6 * (b * d - 6 * As) + fy * 6 * As), 1, 1e-9, "N0 of ACI 318")
end)

case("strains: what does not go together", function()
  local both = "bar 1: give either 'diameter' (m) or 'area' (m^2); both are given"
  for words, more in pairs { ["strains = 'plastic' alone"] = { strains = "EN 1992-1-1", effectiveness = 0.9 },
    ["must be one of"] = { strains = "EN" }, [both] = { bars = { { 0, 0, diameter = 0.02, area = 3e-4 } } } } do
    checks.refused(words, section, 2, 2, more)
  end
  local none = checks.refused("bar 1: give either 'diameter' (m) or 'area' (m^2)", section, 2, 2,
    { bars = { { 0, 0 } } })
  expect(not none:find "both are given", "none is given: %s", none)
  for field, value in pairs { count = 0, diameter = -1, y = "middle" } do
    checks.refused({ "layer 1", field, " is " }, hinge.section.concrete, { width = b, depth = d, concrete = fc,
      steel = fy, cover = 0.03, layers = { with({ y = "top", count = 2, diameter = 0.02 }, { [field] = value }) } })
  end
  local function general(strength, more)
    local reinforcement = with({ concrete = strength, bars = { { 0.1, 0.1, area = 1e-3, tension = 500e6 } } }, more)
    hinge.section.general { area = 0.2, Ix = 1e-3, Iy = 1e-3, J = 1e-3, reinforcement = reinforcement,
      outline = { { corners = { { 0, 0 }, { 0.4, 0 }, { 0.4, 0.5 }, { 0, 0.5 } } } } }
  end
  checks.refused("1 MPa is 1e6", general, 30)
  checks.refused("E of the bars", general, 30e6, { strains = { peak = 0.002, ultimate = 0.0035, bars = 200e3 } })
  checks.refused("at least `peak`", general, 30e6, { strains = { peak = 0.004, ultimate = 0.003 } })
end)

case("layers stand behind their cover", function()
  local layered = hinge.section.concrete { width = b, depth = d, concrete = fc, steel = fy, effectiveness = 1,
    cover = edge - 0.01, layers = { { y = "top", count = 2, diameter = 0.02 }, { y = "bottom", count = 4,
      diameter = 0.02 } } }
  for _, N in ipairs { 3e5, 0, -1e6, -4e6 } do
    for _, angle in ipairs { 0, 0.7, 2, 4 } do
      local x, y = layered:plastic_moments(N, angle)
      local X, Y = section(2, 4):plastic_moments(N, angle)
      near(math.abs(x - X) + math.abs(y - Y), 0, 1, ("N %g, angle %g"):format(N, angle))
    end
  end
end)

case("stiffness is a factor on E I, and not on N or the mass", function()
  local gross = section(3, 3)
  for given, factor in pairs { gross = 1, cracked = 0.3, [0.5] = 0.5 } do
    local of = section(3, 3, { stiffness = given })
    local c = cantilever(of, 0, { 0, 1e3 })
    local run = c.model:static { loads = { push = 1 } }:finish()
    local _, _, uz = c.tip:displacement(run)
    local G = material.E / 2.4
    local wanted = 1e3 * L ^ 3 / (3 * material.E * factor * b * d ^ 3 / 12) + 1e3 * L / (G * of.shear_area_y)
    near(uz / wanted, 1, 1e-9, "deflection, stiffness " .. tostring(given))
    equal(of.area, gross.area, "area")
    near(of.Ix, factor * b * d ^ 3 / 12, 1e-12, "I_x")
    near(of.Iy, factor * d * b ^ 3 / 12, 1e-12, "I_y")
    equal(of.J, gross.J, "J")
    equal(of.shear_area_x .. " " .. of.shear_area_y, gross.shear_area_x .. " " .. gross.shear_area_y, "shear areas")
  end
end)

-- A portal with a blow at its corners that makes hinges.
local function portal(strains, bars)
  return law_scenes.struck({
    column = { section = section(3, bars or 3, { stiffness = 0.5, strains = strains }), material = material },
    beam = { section = section(2, 4, { stiffness = "cracked", strains = strains }), material = material } },
    { 3, 0.7, -1 })
end

case("in dynamics the energy balance closes, and three integrators dissipate the same", function()
  for _, strains in ipairs { "plastic", "EN 1992-1-1" } do
    law_scenes.balances(checks, function() return portal(strains) end, { duration = 0.1, error = 2e-3, what = strains,
      explicit = 0.02 })
  end
end)

case("a run that was saved while hinges turn goes on to the same bytes, and not with other bars", function()
  law_scenes.resumes(checks, function() return portal "EN 1992-1-1" end, { steps = 150, duration = 0.06, others = {
    [function() return portal("EN 1992-1-1", 4) end] = "sections",
    [function() return portal "ACI 318" end] = "sections" } })
end)

checks.done()

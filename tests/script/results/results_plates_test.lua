-- The plates that hinge.results finds in a section: named ones of every kind, hollow sections whose area and I are
-- integrals by strips, and what is nearly a known section.
--
-- Run: lua5.4 tests/script/results/results_plates_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local profile = require "hinge.results.profile"
local checks = support.checks "plates of sections"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect
local joined = support.joined

-- Area, I about x and about y of a box with rounded corners, by strips.
local function strips(b, d, t, ro, ri)
  local function width(h, w, r, y) -- of a rounded rectangle at a height from its middle
    local beyond = math.abs(y) - (h / 2 - r)
    if beyond <= 0 or r == 0 then return w end
    return w - 2 * (r - math.sqrt(support.largest_of(r * r - beyond * beyond, 0)))
  end
  local function both(h, w)
    local n, A, I = 40000, 0, 0
    for i = 1, n do
      local y = h * ((i - 0.5) / n - 0.5)
      local c = width(h, w, ro, y)
      if math.abs(y) < h / 2 - t then c = c - width(h - 2 * t, w - 2 * t, ri, y) end
      A, I = A + c * h / n, I + c * y * y * h / n
    end
    return A, I
  end
  local A, Ix = both(d, b)
  local _, Iy = both(b, d)
  return A, Ix, Iy
end

case("walls, radii and the way of making of boxes whose area and I are those of strips", function()
  for _, r in ipairs { { "RHS 1", 1.5, 1, "hot" }, { "RHS 1", 2, 1, "cold" }, { "CFRHS", 2.5, 1.5, "cold" },
    { "x", 3, 2, "cold" }, { "BCP", 3.5, 2.5, "cold" }, { "CFSHS", 1.5, 1, "cold" }, { "HSS", 1.5, 1, "cold" } } do
    local b, d, t = 0.2, 0.3, 0.012
    -- integrals by strips are within 1e-5; those of a formula of the corners are compared at 1e-6
    local A, Ix, Iy = strips(b, d, t, r[2] * t, r[3] * t)
    local corner = (4 - math.pi) * ((r[2] * t) ^ 2 - (r[3] * t) ^ 2)
    local exact = 2 * t * (b + d - 2 * t) - corner
    near(A, exact, 2e-5 * A, "area by strips")
    local s = { kind = r[1], width = b, depth = d, web = 0, flange = 0, area = exact, Ix = Ix, Iy = Iy }
    local p = profile.of(s)
    expect(p, "known: %s %g", r[1], r[2])
    if p then
      equal(joined { p.shape, p.made, p.b, p.d }, joined { "box", r[4], b, d }, "shape")
      for key, wanted in pairs { tw = t, tf = t, r = r[2] * t, r_inner = r[3] * t, hw = d - 2 * t, c_web = d - 3 * t,
        c_flange = b - 3 * t } do near(p[key], wanted, 1e-6, key) end
    end
  end
end)

case("what is nearly a known section is none, with the reason", function()
  local function of(base, more)
    local s = { kind = "x", web = 0, flange = 0 }
    for _, own in ipairs { base, more or {} } do
      for key, value in pairs(own) do s[key] = value end
    end
    return profile.of(s)
  end
  local b, d, pi = 0.1, 0.3, math.pi
  local bar = { width = b, depth = d, area = b * d, Ix = b * d ^ 3 / 12, Iy = d * b ^ 3 / 12 }
  local round = { width = d, depth = d, area = pi * d ^ 2 / 4, Ix = pi * d ^ 4 / 64, Iy = pi * d ^ 4 / 64 }
  local D, inner = 0.2, 0.18
  local I = pi / 64 * (D ^ 4 - inner ^ 4)
  local pipe = { width = D, depth = D, area = pi / 4 * (D ^ 2 - inner ^ 2), Ix = I, Iy = I }
  local welded = { width = 0.2, depth = 0.4, area = 2 * 0.2 * 0.02 + 2 * 0.36 * 0.01,
    Ix = (0.2 * 0.4 ^ 3 - 0.18 * 0.36 ^ 3) / 12, Iy = (0.4 * 0.2 ^ 3 - 0.36 * 0.18 ^ 3) / 12 }
  local p = of(pipe)
  equal(joined { p.shape, p.made, p.b, p.d }, "pipe cold 0.2 0.2", "a pipe")
  near(p.tw, 0.01, 1e-9, "its wall")
  near(p.tf, 0.01, 1e-9, "its wall")
  equal(of(pipe, { kind = "CHS 200x10" }).made, "hot", "a CHS")
  p = of(welded)
  equal(joined { p.shape, p.made, p.r, p.r_inner }, "box welded 0 0", "a welded box")
  for key, wanted in pairs { tw = 0.01, tf = 0.02, hw = 0.36, c_web = 0.36, c_flange = 0.18, b = 0.2, d = 0.4 } do
    near(p[key], wanted, 1e-7, key)
  end
  equal(of(bar).shape, "rectangle", "a bar")
  equal(of(round).shape, "round", "a round bar")
  local unknown = "its plates are not known: only H, box, pipe, rectangle and round bar are"
  for name, s in pairs { bar = bar, round = round, pipe = pipe, welded = welded } do
    for _, key in ipairs { "Ix", "area", name == "pipe" and "Iy" or name == "welded" and "Iy" or "Ix" } do
      local found, why = of(s, { [key] = s[key] * (1 + 3e-6) })
      equal(found, nil, ("%s with another %s"):format(name, key))
      equal(why, unknown, "says")
      expect(of(s, { [key] = s[key] * (1 + 3e-7) }), "%s with nearly the same %s", name, key)
    end
  end
  equal(select(2, of(bar, { width = 0 })), "it has no size", "no width")
  equal(select(2, of(bar, { depth = 0 })), "it has no size", "no depth")
  equal(select(2, of(bar, { kind = "concrete" })), "it is of concrete", "concrete")
  -- an H by its plates; its fillets are what its area has beyond them
  local h = { width = 0.2, depth = 0.4, web = 0.01, flange = 0.02, Iy = 3e-5 }
  local plates = 2 * 0.2 * 0.02 + 0.36 * 0.01
  p = of(h, { area = plates + (4 - pi) * 0.015 ^ 2 })
  equal(joined { p.shape, p.made }, "h rolled", "an H with fillets")
  for key, wanted in pairs { r = 0.015, hw = 0.36, c_web = 0.33, c_flange = 0.08, warping = 3e-5 * 0.38 ^ 2 / 4,
    b = 0.2, d = 0.4, tw = 0.01, tf = 0.02 } do near(p[key], wanted, 1e-9, key) end
  equal(joined { of(h, { area = plates * (1 + 5e-7) }).made, of(h, { area = plates * (1 + 2e-6) }).made },
    "welded rolled", "fillets of a millionth are none")
  equal(select(2, of(h, { area = plates * (1 - 2e-4) })), "its area is less than that of its plates", "too small")
  expect(of(h, { area = plates * (1 - 5e-5) }), "by less it is rounding")
end)

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

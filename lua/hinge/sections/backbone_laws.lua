-- Backbones of steel hinges from published laws: what the formulas of sections/lignos.lua and of the standards NIST,
-- ASCE 41 and UFC 4-023-03 share.
--
-- A power law is factor * (h / tw)^web * (bf / 2 tf)^flange * (Lb / ry)^unbraced * (L / d)^span
-- * (d / depth_unit)^depth * (Fy / stress_unit)^stress * (1 - g)^axial, at most `most`. h: clear depth of the web; tw,
-- bf, tf, d: of the section; Lb: unbraced length; L: shear span; g: axial force over area times yield stress.
local core = require "hinge.core"
local check = require "hinge.library.check"

local shared = {}

local inch = 0.0254
local drop = 0.001 -- rad: the rotation over which the last strength is lost, as in hinge.backbone
local close = 0.003 -- of the moment: how far a column's moment may be off the published line between two points

shared.inch = inch
shared.depth_unit = 0.533 -- m; 21 in, in which NIST counts, is 0.5334 m
shared.stress_unit = 355e6 -- Pa
shared.least = 0.01 -- of Mp: the strength that is always left
local least = shared.least

--- Rules of the options that the formulas share.
shared.rules = {
  section = { "section" }, material = { "material" }, length = { "number", unit = "m", above = 0 },
  no_length = { "number", unit = "m", at_least = 0, optional = true },
  some_length = { "number", unit = "m", above = 0, optional = true },
  axial = { "number", at_least = 0, below = 1, default = 0 }, no = { "boolean", default = false },
  interaction = { "string", one_of = { "paper", "exact" }, optional = true },
}

-- Sections ------------------------------------------------------------------------------------------------------------

-- Sizes (m), slendernesses and properties of an H. The root radius is that which makes up for the area of the plates.
function shared.measures(where, s)
  local tw, tf = s.web, s.flange
  if not (type(tw) == "number" and type(tf) == "number" and tw > 0 and tf > 0) then
    check.fail("%s: field 'section' is %s; must be an H, as hinge.section.h{...} or hinge.section.named 'W24X76' gives",
      where, check.show(s.kind))
  end
  local b, d = s.width, s.depth
  local fillets = s.area - 2 * b * tf - (d - 2 * tf) * tw
  local r = fillets > 1e-9 * s.area and math.sqrt(fillets / (4 - math.pi)) or 0
  return { kind = s.kind, b = b, d = d, tf = tf, h_tw = (d - 2 * tf - 2 * r) / tw, bf_2tf = b / (2 * tf), d_tw = d / tw,
    ry = math.sqrt(s.Iy / s.area), Ix = s.Ix, Zx = s.Zx, area = s.area }
end

function shared.yield_of(where, m)
  local fy = m.yield_stress
  if type(fy) ~= "number" or fy == math.huge then
    check.fail("%s: field 'material' has no yield_stress (Pa); it is needed for the moment at yield", where)
  end
  return fy
end

-- Part of the plastic modulus that is left where both flanges are cut by `cut` (m) at either side: a reduced section.
function shared.left_by_cut(where, o, m, reduced)
  if not reduced then
    if o.cut then check.fail("%s: field 'cut' is for reduced beam sections (RBS) alone", where) end
    return 1
  end
  if not o.cut then
    check.fail("%s: field 'cut' is missing; give the depth of the cut at either side of the flanges, in m; 0 where the "
      .. "section of the member is the reduced one", where)
  end
  local most = m.b / 4
  local cut = o.cut <= most * (1 + 1e-9) and math.min(o.cut, most) or o.cut -- a quarter may be rounded up
  check.value(where, "cut", cut, { "number", unit = "m", at_least = 0, at_most = most })
  return 1 - 2 * cut * m.tf * (m.d - m.tf) / m.Zx
end

-- Columns under an axial force ----------------------------------------------------------------------------------------

-- The strengths of a backbone multiply all fully plastic resultants, the axial one too: with the factor f the section
-- carries the moment f m(g / f) Mp under the axial force g times area times yield stress, where m(n) is its moment over
-- Mp under n of its axial strength. Published moments hold under the axial force. f follows from them.

-- The interaction that a section yields by in a model with its defaults.
local function interaction_of(s, asked)
  return asked or s.interaction or s:reduced_moments(0) and "exact" or "paper"
end

-- m(n) about the strong axis, by the interaction that the section yields by.
local function reduced_moment(where, s, asked)
  if asked and s.interaction and s.interaction:match "^%a+" ~= asked then
    check.fail("%s: field 'interaction' is '%s', but the section '%s' has interaction = '%s', by which it yields in a "
      .. "run; leave the field out", where, asked, s.kind, s.interaction)
  end
  if not interaction_of(s, asked):find "^exact" then return function(n) return math.sqrt(math.max(1 - n * n, 0)) end end
  if not s:reduced_moments(0) then
    check.fail("%s: field 'interaction' is 'exact'; the section '%s' has no outline for that; take hinge.section.h or "
      .. "hinge.section.named", where, s.kind)
  end
  return function(n) return (s:reduced_moments(n)) end
end

-- Under the axial force g, moment: that over Mp which a factor gives; factor: that which a moment over Mp needs. nil
-- where g is 0: then both are equal.
function shared.under_force(where, o, g, fy)
  local s = o.section
  local m = reduced_moment(where, s, o.interaction)
  if g == 0 then return nil end
  for field, pair in pairs { N0 = { s.N0 or fy * s.plastic_area, fy * s.area, "N, area times yield stress" },
    Mx0 = { s.Mx0 or fy * s.Zx, fy * s.Zx, "N m, Zx times yield stress" } } do
    if math.abs(pair[1] / pair[2] - 1) > 0.01 then
      check.fail("%s: the section '%s' has %s = %s; with axial_ratio above 0 it must be %s %s", where, s.kind, field,
        check.show(pair[1]), check.show(pair[2]), pair[3])
    end
  end
  local function moment(f) return f * m(g / f) end
  local function factor(M)
    local low, high = g, g + M -- m(n) is at least 1 - n
    while high - low > 1e-12 do
      local middle = (low + high) / 2
      if moment(middle) < M then low = middle else high = middle end
    end
    return high
  end
  -- by how much of itself the moment falls where a hundredth of the factor is lost, over that hundredth
  local function sensitivity(f)
    local by = 1e-4 * f
    return (moment(f + by) - moment(f - by)) / (2 * by) * f / moment(f)
  end
  return { moment = moment, factor = factor, sensitivity = sensitivity,
    interaction = interaction_of(s, o.interaction) }
end

-- Adds points between a and b, { rotation, moment over Mp, factor }, until a straight line between two factors gives
-- the straight line between their moments.
local function add_between(to, a, b, force, depth)
  local M = (a[2] + b[2]) / 2
  if depth == 0 or math.abs(force.moment((a[3] + b[3]) / 2) - M) <= close * M then return end
  local c = { (a[1] + b[1]) / 2, M, force.factor(M) }
  add_between(to, a, c, force, depth - 1)
  to[#to + 1] = { c[1], c[3] }
  add_between(to, c, b, force, depth - 1)
end

-- The backbone through points { plastic rotation, moment over Mp }, with all strength lost after the last of them.
-- residual: moment over Mp that wear leaves; force: of under_force, or nil; stiffness_wear: wear takes stiffness, too.
-- Wear lowers the factor, by which the moment falls faster: for it to fall as published, wear is the larger by as much.
local function through(points, wear, residual, force, stiffness_wear)
  local to, before = {}, nil
  for i, p in ipairs(points) do
    local here = { p[1], p[2], force and force.factor(p[2]) or p[2] }
    if before and force then add_between(to, before, here, force, 8) end
    to[#to + 1], before = { here[1], here[3] }, here
    if i == #points and here[3] > least then to[#to + 1] = { here[1] + drop, least } end
  end
  local function factor(M) return force and force.factor(M) or M end
  return core.backbone { points = to, wear = wear and force and wear * force.sensitivity(to[1][2]) or wear,
    residual = wear and residual > least and factor(residual) / to[1][2] or nil,
    stiffness_wear = wear and stiffness_wear or nil,
    interaction = force and force.interaction }
end

-- Formulas ------------------------------------------------------------------------------------------------------------

local ratios = { "web", "flange", "unbraced", "span", "depth", "stress", "axial" }

-- A published law of the ratios x: a number; a power law; or { constant, times the depth in inches }.
function shared.value(law, x)
  if type(law) == "number" then return law end
  if not law.factor then return law[1] + law[2] * x.inches end
  local product = law.factor
  for _, name in ipairs(ratios) do
    if law[name] then product = product * x[name] ^ law[name] end
  end
  return math.min(product, law.most or math.huge)
end

-- Of rotations of the chord and moments (N m), as published, the plastic rotation, which is what is left without M / K,
-- and the strength over Mp. All strength is lost at the chord's rotation `ultimate`.
local function from_chord(where, chord, ultimate, K, Mp, wear, residual, force, stiffness_wear)
  local cut = {}
  for i, p in ipairs(chord) do
    local before = chord[i - 1]
    if p[1] >= ultimate then
      local part = (ultimate - before[1]) / (p[1] - before[1])
      p = { ultimate, before[2] + part * (p[2] - before[2]) }
    end
    cut[i] = p
    if p[1] == ultimate then break end
  end
  if cut[#cut][1] < ultimate then cut[#cut + 1] = { ultimate, cut[#cut][2] } end
  local points = {}
  for i, p in ipairs(cut) do
    points[i] = { i == 1 and 0 or p[1] - p[2] / K, math.max(p[2] / Mp, least) }
    if i > 1 and points[i][1] <= points[i - 1][1] then
      check.fail("%s: the rotation of the chord from yield to the cap is %s rad, of which %s rad are elastic; no "
        .. "plastic rotation is left", where, check.show(p[1] - cut[1][1]), check.show((p[2] - cut[1][2]) / K))
    end
  end
  return through(points, wear, residual, force, stiffness_wear)
end

-- What Lignos, and NIST, publish of a hinge: `row` has its laws. My: moment at yield, N m; K: of the chord, N m / rad.
-- force: of under_force, or nil.
function shared.trilinear(where, row, x, My, K, Mp, wear, force, stiffness_wear)
  local Mc = My * math.max(shared.value(row.cap, x), row.least_cap or 0)
  local Mr = math.min(My * row.residual, Mc)
  local at_yield = My / K
  local at_cap = at_yield + shared.value(row.cap_rotation, x)
  local fall = shared.value(row.post_cap, x)
  if not (at_cap > at_yield and fall > 0) then
    check.fail("%s: the formulas give %s rad up to the cap and %s rad beyond it for a depth of %s m; must be above 0",
      where, check.show(at_cap - at_yield), check.show(fall), check.show(x.inches * inch))
  end
  local chord = { { at_yield, My }, { at_cap, Mc }, { at_cap + fall * (1 - Mr / Mc), Mr } }
  return from_chord(where, chord, row.ultimate, K, Mp, wear, Mr / Mp, force, stiffness_wear)
end

-- a, b, c of ASCE 41. at_a: strength at a over that at yield; yield: over Mp. From a the strength falls straight over a
-- tenth of b - a, and 0.001 rad at least. force: of under_force, or nil.
function shared.from_abc(a, b, c, at_a, yield, force)
  local rest = math.max(c * yield, least)
  local down = a + math.max((b - a) / 10, drop)
  local points = { { 0, yield }, { a, at_a * yield }, { down, rest } }
  if b > down then points[4] = { b, rest } end
  return through(points, nil, 0, force)
end

function shared.ratios_of(m, o, fy)
  return { web = m.h_tw, flange = m.bf_2tf, unbraced = o.unbraced_length and o.unbraced_length / m.ry,
    span = o.shear_span and o.shear_span / m.d, depth = m.d / shared.depth_unit, inches = m.d / inch,
    stress = fy / shared.stress_unit, axial = 1 - (o.axial_ratio or 0) }
end

function shared.only_for(where, o, field, kinds)
  for _, kind in ipairs(kinds) do
    if o.kind == kind then
      if o[field] == nil then
        check.fail("%s: field '%s' is missing; kind = '%s' needs it, in m", where, field, kind)
      end
      return
    end
  end
end

function shared.needs_wear(where, o, wears)
  if o.stiffness_wear and not wears then
    check.fail("%s: stiffness_wear = true needs the wear of cycles: leave `wear` and `monotonic` at their defaults",
      where)
  end
end

-- The moment that an axial force leaves: AISC 342-22, C3-5 and C3-6. tau: of the stiffness, ASCE 41-17, 9-5.
function shared.under_axial_force(g)
  return g <= 0.2 and 1 - g / 2 or 9 / 8 * (1 - g), g > 0.5 and 4 * g * (1 - g) or 1
end

-- 0 up to the first limit, 1 from the second on. Those of a column's web meet where g is about 0.9.
function shared.between(slenderness, limits, root)
  if limits[2] <= limits[1] then return slenderness / root <= limits[2] and 0 or 1 end
  return math.min(math.max((slenderness / root - limits[1]) / (limits[2] - limits[1]), 0), 1)
end

-- The value of slender sections where flange or web is one, else the lower one of those by flange and by web.
function shared.blend(compact, slender, flange, web)
  if flange >= 1 or web >= 1 then return slender end
  return math.min(compact + (slender - compact) * flange, compact + (slender - compact) * web)
end

-- a and b of a connection, rad, by its depth, m.
function shared.rotations(where, row, depth, what)
  local a, b = shared.value(row.a, { inches = depth / inch }), shared.value(row.b, { inches = depth / inch })
  if not (a > 0 and b > a) then
    check.fail("%s: the table gives a = %s rad and b = %s rad for %s of %s m; it is for 0 < a < b", where,
      check.show(a), check.show(b), what, check.show(depth))
  end
  return a, b
end

return shared

-- hinge.backbone: a function that makes a backbone, and a table of those that make one by published formulas, whose
-- numbers are in backbones.lua.
local core = require "hinge.core"
local check = require "hinge.library.check"
local published = require "hinge.sections.backbones"

local inch = 0.0254
local drop = 0.001 -- rad: the rotation over which the last strength is lost, as in hinge.backbone
local least = 0.01 -- of Mp: the strength that is always left
local close = 0.003 -- of the moment: how far a column's moment may be off the published line between two points

local section = { "section" }
local material = { "material" }
local length = { "number", unit = "m", above = 0 }
local no_length = { "number", unit = "m", at_least = 0, optional = true }
local some_length = { "number", unit = "m", above = 0, optional = true }
local axial = { "number", at_least = 0, below = 1, default = 0 }
local no = { "boolean", default = false }
local interaction = { "string", one_of = { "paper", "exact" }, optional = true }

-- Sections ------------------------------------------------------------------------------------------------------------

-- Sizes (m), slendernesses and properties of an H. The root radius is that which makes up for the area of the plates.
local function measures(where, s)
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

local function yield_of(where, m)
  local fy = m.yield_stress
  if type(fy) ~= "number" or fy == math.huge then
    check.fail("%s: field 'material' has no yield_stress (Pa); it is needed for the moment at yield", where)
  end
  return fy
end

-- Part of the plastic modulus that is left where both flanges are cut by `cut` (m) at either side: a reduced section.
local function left_by_cut(where, o, m, reduced)
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
local function under_force(where, o, g, fy)
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
local function value(law, x)
  if type(law) == "number" then return law end
  if not law.factor then return law[1] + law[2] * x.inches end
  local product = law.factor
  for _, name in ipairs(ratios) do
    if law[name] then product = product * x[name] ^ law[name] end
  end
  return math.min(product, law.most or math.huge)
end

-- The law of ASCE 41-17 for columns, or a power law.
local function of_column(law, x)
  if law.power then return value(law, x) end
  local below = law.unbraced * x.unbraced + law.web * x.web + (law.flange or 0) * x.flange
  return law.factor * x.axial ^ law.axial / below - law.offset
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
local function trilinear(where, row, x, My, K, Mp, wear, force, stiffness_wear)
  local Mc = My * math.max(value(row.cap, x), row.least_cap or 0)
  local Mr = math.min(My * row.residual, Mc)
  local at_yield = My / K
  local at_cap = at_yield + value(row.cap_rotation, x)
  local fall = value(row.post_cap, x)
  if not (at_cap > at_yield and fall > 0) then
    check.fail("%s: the formulas give %s rad up to the cap and %s rad beyond it for a depth of %s m; must be above 0",
      where, check.show(at_cap - at_yield), check.show(fall), check.show(x.inches * inch))
  end
  local chord = { { at_yield, My }, { at_cap, Mc }, { at_cap + fall * (1 - Mr / Mc), Mr } }
  return from_chord(where, chord, row.ultimate, K, Mp, wear, Mr / Mp, force, stiffness_wear)
end

-- a, b, c of ASCE 41. at_a: strength at a over that at yield; yield: over Mp. From a the strength falls straight over a
-- tenth of b - a, and 0.001 rad at least. force: of under_force, or nil.
local function from_abc(a, b, c, at_a, yield, force)
  local rest = math.max(c * yield, least)
  local down = a + math.max((b - a) / 10, drop)
  local points = { { 0, yield }, { a, at_a * yield }, { down, rest } }
  if b > down then points[4] = { b, rest } end
  return through(points, nil, 0, force)
end

local function ratios_of(m, o, fy)
  return { web = m.h_tw, flange = m.bf_2tf, unbraced = o.unbraced_length and o.unbraced_length / m.ry,
    span = o.shear_span and o.shear_span / m.d, depth = m.d / published.depth_unit, inches = m.d / inch,
    stress = fy / published.stress_unit, axial = 1 - (o.axial_ratio or 0) }
end

-- Lignos and Krawinkler -----------------------------------------------------------------------------------------------

local backbone = {}

local function within_tests(where, o, m, x, fy)
  local at = { d_tw = m.d_tw, Lb_ry = x.unbraced, bf_2tf = m.bf_2tf, L_d = x.span, depth = m.d, yield_stress = fy }
  local words = { d_tw = "depth / web", Lb_ry = "unbraced_length / radius of gyration about y",
    bf_2tf = "width / (2 flange)", L_d = "shear_span / depth", depth = "the depth", yield_stress = "the yield stress" }
  for _, range in ipairs(published.lignos.tested) do
    local name, from, to, unit = table.unpack(range)
    unit = unit and " " .. unit or ""
    if not (at[name] >= from and at[name] <= to) and not o.beyond_tests then
      check.fail("%s: %s of '%s' is %s%s; the tests behind the formulas have %s to %s%s. beyond_tests = true takes "
        .. "them nevertheless", where, words[name], m.kind, check.show(at[name]), unit, check.show(from),
        check.show(to), unit)
    end
  end
end

local function needs_wear(where, o, wears)
  if o.stiffness_wear and not wears then
    check.fail("%s: stiffness_wear = true needs the wear of cycles: leave `wear` and `monotonic` at their defaults",
      where)
  end
end

local function lignos_row(m, reduced)
  return published.lignos[reduced and "reduced" or m.d < published.depth_unit and "shallow" or "deep"]
end

--- hinge.backbone.lignos
function backbone.lignos(options, ...)
  local where = "hinge.backbone.lignos"
  check.no_more(where, ...)
  local o = check.options(where, options, { section = section, material = material, shear_span = length,
    unbraced_length = length, reduced = { "boolean", default = false }, cut = no_length,
    wear = { "boolean", default = true }, stiffness_wear = no, beyond_tests = { "boolean", default = false } })
  local m, fy = measures(where, o.section), yield_of(where, o.material)
  local x = ratios_of(m, o, fy)
  within_tests(where, o, m, x, fy)
  local row, Mp = lignos_row(m, o.reduced), fy * m.Zx
  local My = row.yield * left_by_cut(where, o, m, o.reduced) * Mp
  local K = 3 * o.material.E * m.Ix / o.shear_span
  needs_wear(where, o, o.wear)
  return trilinear(where, row, x, My, K, Mp, o.wear and value(row.wear, x) or nil, nil, o.stiffness_wear)
end

-- NIST ----------------------------------------------------------------------------------------------------------------

-- The moment that an axial force leaves: AISC 342-22, C3-5 and C3-6. tau: of the stiffness, ASCE 41-17, 9-5.
local function under_axial_force(g)
  return g <= 0.2 and 1 - g / 2 or 9 / 8 * (1 - g), g > 0.5 and 4 * g * (1 - g) or 1
end

local function only_for(where, o, field, kinds)
  for _, kind in ipairs(kinds) do
    if o.kind == kind then
      if o[field] == nil then
        check.fail("%s: field '%s' is missing; kind = '%s' needs it, in m", where, field, kind)
      end
      return
    end
  end
end

--- hinge.backbone.nist
function backbone.nist(options, ...)
  local where = "hinge.backbone.nist"
  check.no_more(where, ...)
  local o = check.options(where, options, {
    kind = { "string", one_of = { "beam", "RBS", "column", "pre-Northridge" } }, section = section, material = material,
    monotonic = { "boolean", default = true }, shear_span = length, unbraced_length = some_length, axial_ratio = axial,
    interaction = interaction, cut = no_length, wear = { "boolean", optional = true }, stiffness_wear = no })
  if o.wear and not o.monotonic then
    check.fail("%s: wear = true does not go with monotonic = false: the envelope of cycles has their wear in it", where)
  end
  local row = published.nist[o.monotonic and "monotonic" or "cyclic"][o.kind]
  if not row then
    check.fail("%s: kind = 'pre-Northridge' has the envelope of the first cycles alone; give monotonic = false", where)
  end
  only_for(where, o, "unbraced_length", { "beam", "RBS", "column" })
  local g = o.axial_ratio
  if o.kind ~= "column" and (g > 0 or o.interaction) then
    local field = g > 0 and "axial_ratio" or "interaction"
    check.fail("%s: field '%s' is %s; it is for kind = 'column' alone", where, field, check.show(o[field]))
  end
  local m, fy = measures(where, o.section), yield_of(where, o.material)
  local x = ratios_of(m, o, fy)
  local Mp = fy * m.Zx
  local moment, tau = under_axial_force(g)
  local K = 3 * tau * o.material.E * m.Ix / o.shear_span
  local laws = {}
  for name, law in pairs(row) do laws[name] = law end
  if row.deep and x.inches >= row.deep_from then
    for name, law in pairs(row.deep) do laws[name] = law end
  end
  local wears = o.monotonic and o.wear ~= false
  needs_wear(where, o, wears)
  if o.kind == "column" then
    laws.residual, laws.ultimate = row.residual[1] + row.residual[2] * g, row.ultimate[1] + row.ultimate[2] * g
    wears = wears and (g > row.wear_changes_at and row.wear_above or row.wear)
  elseif wears then
    wears = lignos_row(m, o.kind == "RBS").wear
  end
  local My = row.yield * left_by_cut(where, o, m, o.kind == "RBS") * moment * Mp
  return trilinear(where, laws, x, My, K, Mp, wears and value(wears, x) or nil, under_force(where, o, g, fy),
    o.stiffness_wear)
end

-- ASCE 41 -------------------------------------------------------------------------------------------------------------

-- 0 up to the first limit, 1 from the second on. Those of a column's web meet where g is about 0.9.
local function between(slenderness, limits, root)
  if limits[2] <= limits[1] then return slenderness / root <= limits[2] and 0 or 1 end
  return math.min(math.max((slenderness / root - limits[1]) / (limits[2] - limits[1]), 0), 1)
end

-- The value of slender sections where flange or web is one, else the lower one of those by flange and by web.
local function blend(compact, slender, flange, web)
  if flange >= 1 or web >= 1 then return slender end
  return math.min(compact + (slender - compact) * flange, compact + (slender - compact) * web)
end

local function asce_beam(o, m, fy)
  local rows, E = published.beam, o.material.E
  local root = math.sqrt(E / fy)
  local flange, web = between(m.bf_2tf, rows.flange, root), between(m.h_tw, rows.web, root)
  local theta = fy * m.Zx * o.length / (6 * E * m.Ix)
  local row = {}
  for name, compact in pairs(rows.compact) do
    row[name] = blend(compact, rows.slender[name], flange, web) * (name == "c" and 1 or theta)
  end
  return from_abc(row.a, row.b, row.c, 1 + published.hardening[1] * row.a / theta, 1),
    { IO = row.IO, LS = row.LS, CP = row.CP }
end

-- Limits of the web's slenderness of a column over sqrt(E / fy), which fall with the axial force.
local function web_limits(rows, g)
  local limits = {}
  for i, pair in ipairs(rows) do
    local low, high = pair[1], pair[2]
    limits[i] = g <= rows.changes_at and low[1] * (1 - low[2] * g) or high[1] * (high[2] - g)
  end
  return limits
end

local function asce_column(where, o, m, fy)
  local rows, E, g = published.column[o.edition], o.material.E, o.axial_ratio
  local x, root = ratios_of(m, o, fy), math.sqrt(E / fy)
  local flange = between(m.bf_2tf, published.column.flange, root)
  local web = between(m.h_tw, web_limits(rows.web, g), root)
  local row = {}
  for _, name in ipairs { "a", "b" } do
    row[name] = blend(of_column(rows.compact[name], x), of_column(rows.slender[name], x), flange, web)
    if not (row[name] > 0) then
      check.fail("%s: the formula gives %s = %s rad for '%s' at axial_ratio = %s; such a column has no plastic "
        .. "rotation: it is controlled by force", where, name, check.show(row[name]), m.kind, check.show(g))
    end
  end
  local c = blend(rows.compact.c[1] + rows.compact.c[2] * g, rows.slender.c[1] + rows.slender.c[2] * g, flange, web)
  local moment, tau = under_axial_force(g)
  local theta = moment * fy * m.Zx * o.length / (6 * tau * E * m.Ix)
  local slope = published.hardening
  local at_a = 1 + (g > slope.changes_at and slope.above or slope[1]) * row.a / theta
  local made = from_abc(row.a, row.b, c, at_a, moment, under_force(where, o, g, fy))
  if not rows.limits then return made end
  local limits = {}
  for level, of in pairs(rows.limits) do limits[level] = row[of[1]] * of[2] end
  return made, limits
end

-- a and b of a connection, rad, by its depth, m.
local function rotations(where, row, depth, what)
  local a, b = value(row.a, { inches = depth / inch }), value(row.b, { inches = depth / inch })
  if not (a > 0 and b > a) then
    check.fail("%s: the table gives a = %s rad and b = %s rad for %s of %s m; it is for 0 < a < b", where,
      check.show(a), check.show(b), what, check.show(depth))
  end
  return a, b
end

local function asce_joint(where, o, m, fy)
  local all, E = published.joints, o.material.E
  local a, b = rotations(where, all[o.kind], m.d, "a depth")
  local root, factor = math.sqrt(E / fy), 1
  if not o.continuity_plates then factor = factor * all.without_plates end
  local zone = o.panel_zone
  if zone and (zone < all.panel_band[1] or zone > all.panel_band[2]) then factor = factor * all.panel_zone end
  local span = o.length / m.d
  if span < all.short_span then factor = factor * 0.5 ^ ((all.short_span - span) / 3) end
  factor = factor * blend(1, all.slender_factor, between(m.bf_2tf, all.flange, root), between(m.h_tw, all.web, root))
  local left = left_by_cut(where, o, m, o.kind == "RBS")
  local theta = left * fy * m.Zx * o.length / (6 * E * m.Ix)
  a, b = factor * a, factor * b
  return from_abc(a, b, all[o.kind].c, 1 + published.hardening[1] * a / theta, left)
end

--- hinge.backbone.asce41
function backbone.asce41(options, ...)
  local where = "hinge.backbone.asce41"
  check.no_more(where, ...)
  local o = check.options(where, options, {
    kind = { "string", one_of = { "beam", "column", "RBS", "free flange", "WUF" } }, section = section,
    material = material, length = length, unbraced_length = some_length,
    axial_ratio = { "number", at_least = 0, below = 1, optional = true }, interaction = interaction,
    edition = { "string", one_of = { "2017", "2023" }, optional = true }, cut = no_length,
    continuity_plates = { "boolean", optional = true }, panel_zone = { "number", above = 0, optional = true } })
  local joint = o.kind ~= "beam" and o.kind ~= "column"
  for field, fits in pairs { unbraced_length = o.kind == "column", axial_ratio = o.kind == "column",
    interaction = o.kind == "column", edition = o.kind == "column", cut = o.kind == "RBS", continuity_plates = joint,
    panel_zone = joint } do
    if o[field] ~= nil and not fits then
      check.fail("%s: field '%s' does not go with kind = '%s'", where, field, o.kind)
    end
  end
  local m, fy = measures(where, o.section), yield_of(where, o.material)
  if o.kind == "beam" then return asce_beam(o, m, fy) end
  if joint then
    if o.continuity_plates == nil then o.continuity_plates = true end
    return asce_joint(where, o, m, fy)
  end
  only_for(where, o, "unbraced_length", { "column" })
  o.axial_ratio, o.edition = o.axial_ratio or 0, o.edition or "2023"
  return asce_column(where, o, m, fy)
end

-- UFC 4-023-03 --------------------------------------------------------------------------------------------------------

--- hinge.backbone.ufc
function backbone.ufc(options, ...)
  local where = "hinge.backbone.ufc"
  check.no_more(where, ...)
  local o = check.options(where, options, {
    kind = { "string", one_of = { "RBS", "WUF", "improved WUF", "SidePlate", "shear tab" } }, depth = length,
    strength = { "number", at_least = least, optional = true }, role = { "string", one_of = { "primary", "secondary" },
      default = "primary" }, yield_rotation = { "number", unit = "rad", above = 0, optional = true } })
  local strength = o.strength
  if not strength then
    if o.kind == "RBS" or o.kind == "shear tab" then
      check.fail("%s: field 'strength' is missing; kind = '%s' needs the moment at which it yields, over Mp of the "
        .. "member", where, o.kind)
    end
    strength = 1
  end
  local row = published.ufc[o.kind]
  local a, b = rotations(where, row, o.depth, o.kind == "shear tab" and "a bolt group" or "a depth")
  local at_a = o.yield_rotation and 1 + published.hardening[1] * a / o.yield_rotation or 1
  return from_abc(a, b, row.c, at_a, strength), o.role == "primary" and a or b
end

return setmetatable(backbone, {
  __call = function(_, ...) return core.backbone(...) end,
  __index = function(t, key) check.unknown("hinge.backbone", "field", key, check.keys(t)) end,
  __name = "hinge.backbone",
})

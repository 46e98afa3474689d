-- hinge.backbone.asce41: ASCE 41-17, and AISC 342-22, to which ASCE 41-23 refers. None of them was at hand; each table
-- names the public programs whose numbers agree with it.
--
-- Plastic rotations a (the strength drops) and b (it is lost): constant, and times the depth in inches; residual
-- strength c over that at yield.
local check = require "hinge.library.check"
local shared = require "hinge.sections.backbone_laws"

local rules = shared.rules

local tables = {}

-- ASCE 41-17, connections: Galvis's generator.
tables.joints = {
  RBS = { a = { 0.05, -0.0003 }, b = { 0.07, -0.0003 }, c = 0.2 },
  ["free flange"] = { a = { 0.067, -0.0012 }, b = { 0.094, -0.0016 }, c = 0.2 },
  WUF = { a = { 0.051, -0.0013 }, b = { 0.043, -0.0006 }, c = 0.2 },
  -- factors on a and b: no continuity plates where they are needed; panel zone outside the band of Vpz / Vy; clear span
  -- below 8 d, 0.5^((8 - L / d) / 3); slender flanges or webs, straight between the limits of `slender`
  without_plates = 0.8, panel_zone = 0.8, panel_band = { 0.6, 0.9 }, short_span = 8, slender_factor = 0.5,
  flange = { 0.30, 0.38 }, web = { 2.45, 3.76 }, -- times sqrt(E / Fy)
}

-- Beams: AISC 342-22, table C2.2, to which ASCE 41-23 refers; its first row is that of ASCE 41-06 and FEMA 356. The
-- tests of the public program steltic have the printed numbers. All but c in yield rotations. The second row is for a
-- slender flange or web; between the rows straight by the slenderness of each, the lower value of both. flange, web:
-- limits times sqrt(E / Fy), AISC 341-22, table D1.1b; steltic has 2.5 and 5.4 for the webs of moment frames.
tables.beam = {
  flange = { 0.30, 0.38 }, web = { 2.45, 3.76 },
  compact = { a = 9, b = 11, c = 0.6, IO = 2.25, LS = 9, CP = 11 },
  slender = { a = 4, b = 6, c = 0.2, IO = 1, LS = 3, CP = 4 },
}

-- Columns. ["2023"]: AISC 342-22, table C3.6, limits IO = 0.5 a, LS = 0.75 b, CP = b (Galvis's generator; steltic).
-- ["2017"]: ASCE 41-17, table 9-7.1 (Galvis's generator); its limits were not confirmed. Both have the row of slender
-- sections in common.
-- offset: the law is factor * (1 - g)^axial / (unbraced Lb/ry + web h/tw + flange bf/2tf) - offset.
local slender = {
  a = { factor = 1.2, axial = 1.2, unbraced = 1.4, web = 0.1, flange = 0.9, offset = 0.0023 },
  b = { factor = 2.5, axial = 1.8, unbraced = 0.1, web = 0.2, flange = 2.7, offset = 0.0097 },
  c = { 0.5, -0.5 },
}
tables.column = {
  ["2017"] = {
    compact = {
      a = { factor = 0.8, axial = 2.2, unbraced = 0.1, web = 0.8, offset = 0.0035 },
      b = { factor = 7.4, axial = 2.3, unbraced = 0.5, web = 2.9, offset = 0.006 },
      c = { 0.9, -0.9 },
    },
    slender = slender,
    -- limits of the web's slenderness over sqrt(E / Fy): { factor, slope } is factor (1 - slope g) up to `changes_at`,
    -- then { factor, from } is factor (from - g)
    web = { changes_at = 0.2, { { 2.45, 0.71 }, { 0.77, 2.93 } }, { { 3.76, 1.83 }, { 1.12, 2.33 } } },
  },
  ["2023"] = {
    compact = {
      a = { power = true, factor = 5.5, web = -0.95, unbraced = -0.5, axial = 2.4, most = 0.07 },
      b = { power = true, factor = 20, web = -0.9, unbraced = -0.5, axial = 3.4, most = 0.07 },
      c = { 0.4, -0.4 },
    },
    slender = slender, limits = { IO = { "a", 0.5 }, LS = { "b", 0.75 }, CP = { "b", 1 } },
    web = { changes_at = 0.114, { { 2.57, 1.04 }, { 0.88, 2.68 } }, { { 3.96, 3.04 }, { 1.29, 2.12 } } },
  },
  flange = { 0.30, 0.38 },
}

-- Slope from yield to a, over the elastic one: beams and connections; columns up to g = 0.2, and above.
tables.hardening = { 0.03, above = 0.01, changes_at = 0.2 }

-- The law of ASCE 41-17 for columns, or a power law.
local function of_column(law, x)
  if law.power then return shared.value(law, x) end
  local below = law.unbraced * x.unbraced + law.web * x.web + (law.flange or 0) * x.flange
  return law.factor * x.axial ^ law.axial / below - law.offset
end

local function asce_beam(o, m, fy)
  local rows, E = tables.beam, o.material.E
  local root = math.sqrt(E / fy)
  local flange, web = shared.between(m.bf_2tf, rows.flange, root), shared.between(m.h_tw, rows.web, root)
  local theta = fy * m.Zx * o.length / (6 * E * m.Ix)
  local row = {}
  for name, compact in pairs(rows.compact) do
    row[name] = shared.blend(compact, rows.slender[name], flange, web) * (name == "c" and 1 or theta)
  end
  return shared.from_abc(row.a, row.b, row.c, 1 + tables.hardening[1] * row.a / theta, 1),
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
  local rows, E, g = tables.column[o.edition], o.material.E, o.axial_ratio
  local x, root = shared.ratios_of(m, o, fy), math.sqrt(E / fy)
  local flange = shared.between(m.bf_2tf, tables.column.flange, root)
  local web = shared.between(m.h_tw, web_limits(rows.web, g), root)
  local row = {}
  for _, name in ipairs { "a", "b" } do
    row[name] = shared.blend(of_column(rows.compact[name], x), of_column(rows.slender[name], x), flange, web)
    if not (row[name] > 0) then
      check.fail("%s: the formula gives %s = %s rad for '%s' at axial_ratio = %s; such a column has no plastic "
        .. "rotation: it is controlled by force", where, name, check.show(row[name]), m.kind, check.show(g))
    end
  end
  local compact, slender_c = rows.compact.c, rows.slender.c
  local c = shared.blend(compact[1] + compact[2] * g, slender_c[1] + slender_c[2] * g, flange, web)
  local moment, tau = shared.under_axial_force(g)
  local theta = moment * fy * m.Zx * o.length / (6 * tau * E * m.Ix)
  local slope = tables.hardening
  local at_a = 1 + (g > slope.changes_at and slope.above or slope[1]) * row.a / theta
  local made = shared.from_abc(row.a, row.b, c, at_a, moment, shared.under_force(where, o, g, fy))
  if not rows.limits then return made end
  local limits = {}
  for level, of in pairs(rows.limits) do limits[level] = row[of[1]] * of[2] end
  return made, limits
end

local function asce_joint(where, o, m, fy)
  local all, E = tables.joints, o.material.E
  local a, b = shared.rotations(where, all[o.kind], m.d, "a depth")
  local root, factor = math.sqrt(E / fy), 1
  if not o.continuity_plates then factor = factor * all.without_plates end
  local zone = o.panel_zone
  if zone and (zone < all.panel_band[1] or zone > all.panel_band[2]) then factor = factor * all.panel_zone end
  local span = o.length / m.d
  if span < all.short_span then factor = factor * 0.5 ^ ((all.short_span - span) / 3) end
  factor = factor * shared.blend(1, all.slender_factor, shared.between(m.bf_2tf, all.flange, root),
    shared.between(m.h_tw, all.web, root))
  local left = shared.left_by_cut(where, o, m, o.kind == "RBS")
  local theta = left * fy * m.Zx * o.length / (6 * E * m.Ix)
  a, b = factor * a, factor * b
  return shared.from_abc(a, b, all[o.kind].c, 1 + tables.hardening[1] * a / theta, left)
end

--- hinge.backbone.asce41
function tables.backbone(options, ...)
  local where = "hinge.backbone.asce41"
  check.no_more(where, ...)
  local o = check.options(where, options, {
    kind = { "string", one_of = { "beam", "column", "RBS", "free flange", "WUF" } }, section = rules.section,
    material = rules.material, length = rules.length, unbraced_length = rules.some_length,
    axial_ratio = { "number", at_least = 0, below = 1, optional = true }, interaction = rules.interaction,
    edition = { "string", one_of = { "2017", "2023" }, optional = true }, cut = rules.no_length,
    continuity_plates = { "boolean", optional = true }, panel_zone = { "number", above = 0, optional = true } })
  local joint = o.kind ~= "beam" and o.kind ~= "column"
  for field, fits in pairs { unbraced_length = o.kind == "column", axial_ratio = o.kind == "column",
    interaction = o.kind == "column", edition = o.kind == "column", cut = o.kind == "RBS", continuity_plates = joint,
    panel_zone = joint } do
    if o[field] ~= nil and not fits then
      check.fail("%s: field '%s' does not go with kind = '%s'", where, field, o.kind)
    end
  end
  local m, fy = shared.measures(where, o.section), shared.yield_of(where, o.material)
  if o.kind == "beam" then return asce_beam(o, m, fy) end
  if joint then
    if o.continuity_plates == nil then o.continuity_plates = true end
    return asce_joint(where, o, m, fy)
  end
  shared.only_for(where, o, "unbraced_length", { "column" })
  o.axial_ratio, o.edition = o.axial_ratio or 0, o.edition or "2023"
  return asce_column(where, o, m, fy)
end

return tables

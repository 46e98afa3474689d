-- hinge.backbone.nist: NIST GCR 17-917-46, 2017, which was not at hand. Program: the generator of
-- OpenSees models by F. Galvis (steelBeamHinge.m, steelColumnHinge.m); columns also FM-2D, after Lignos et al., J.
-- Struct. Eng. 145(9), 2019. yield and cap of beams are those of the program, which puts the overstrength at yield into
-- the cap. The wear of beams is that of Lignos and Krawinkler.
local check = require "hinge.library.check"
local shared = require "hinge.sections.backbone_laws"
local lignos = require "hinge.sections.lignos"

local rules = shared.rules

local published = {
  monotonic = {
    beam = {
      yield = 1, cap = 1.2, residual = 0.4, ultimate = 0.2,
      cap_rotation = { factor = 0.07, web = -0.3, flange = -0.1, span = 0.3, depth = -0.7 },
      post_cap = { factor = 4.6, web = -0.5, flange = -0.8, depth = -0.3 },
    },
    RBS = {
      yield = 1, cap = 1.2, residual = 0.4, ultimate = 0.2,
      cap_rotation = { factor = 0.09, web = -0.3, flange = -0.1, span = 0.1, depth = -0.8 },
      post_cap = { factor = 6.5, web = -0.5, flange = -0.9 },
    },
    column = {
      yield = 1.15, least_cap = 1, residual = { 0.5, -0.4 }, ultimate = { 0.15, 0 }, -- constant, and times g
      cap = { factor = 12.5, web = -0.2, unbraced = -0.4, axial = 0.4, most = 1.3 },
      cap_rotation = { factor = 294, web = -1.7, unbraced = -0.7, axial = 1.6, most = 0.2 },
      post_cap = { factor = 90, web = -0.8, unbraced = -0.8, axial = 2.5, most = 0.3 },
      -- up to g = 0.35, and above. FM-2D has 25500 for the first; one program -1.13 for `unbraced` of the second
      wear = { factor = 25000, web = -2.14, unbraced = -0.53, axial = 4.92, most = 3 },
      wear_above = { factor = 268000, web = -2.3, unbraced = -1.3, axial = 1.19, most = 3 },
      wear_changes_at = 0.35,
    },
  },
  cyclic = { -- envelope of the first cycles
    -- pairs: constant, and times the depth in inches
    ["pre-Northridge"] = {
      yield = 1, cap = 1.1, residual = 0.2, ultimate = 0.05,
      cap_rotation = { 0.046, -0.0013 }, post_cap = { -0.003, 0.0007 },
      deep_from = 24, -- in
      deep = { ultimate = 0.035, cap_rotation = { 0.008, 0 }, post_cap = { 0.035, -0.0006 } },
    },
    beam = {
      yield = 1, cap = 1.2, residual = 0.3, ultimate = 0.08,
      cap_rotation = { factor = 0.3, web = -0.3, flange = -1.7, unbraced = -0.2, span = 1.1, most = 0.07 },
      post_cap = { factor = 24, web = -0.9, flange = -0.2, unbraced = -0.5 },
    },
    RBS = {
      yield = 1, cap = 1.15, residual = 0.3, ultimate = 0.08,
      cap_rotation = { factor = 0.55, web = -0.5, flange = -0.7, unbraced = -0.5, span = 0.8, most = 0.07 },
      post_cap = { factor = 20, web = -0.8, flange = -0.1, unbraced = -0.6 },
    },
    column = {
      yield = 1.15, least_cap = 1, residual = { 0.4, -0.4 }, ultimate = { 0.08, -0.048 },
      cap = { factor = 9.5, web = -0.4, unbraced = -0.16, axial = 0.2, most = 1.3 },
      cap_rotation = { factor = 15, web = -1.6, unbraced = -0.3, axial = 2.3, most = 0.1 },
      post_cap = { factor = 14, web = -0.8, unbraced = -0.5, axial = 3.2, most = 0.1 },
    },
  },
}

--- hinge.backbone.nist
return function(options, ...)
  local where = "hinge.backbone.nist"
  check.no_more(where, ...)
  local o = check.options(where, options, {
    kind = { "string", one_of = { "beam", "RBS", "column", "pre-Northridge" } }, section = rules.section,
    material = rules.material, monotonic = { "boolean", default = true }, shear_span = rules.length,
    unbraced_length = rules.some_length, axial_ratio = rules.axial, interaction = rules.interaction,
    cut = rules.no_length, wear = { "boolean", optional = true }, stiffness_wear = rules.no })
  if o.wear and not o.monotonic then
    check.fail("%s: wear = true does not go with monotonic = false: the envelope of cycles has their wear in it", where)
  end
  local row = published[o.monotonic and "monotonic" or "cyclic"][o.kind]
  if not row then
    check.fail("%s: kind = 'pre-Northridge' has the envelope of the first cycles alone; give monotonic = false", where)
  end
  shared.only_for(where, o, "unbraced_length", { "beam", "RBS", "column" })
  local g = o.axial_ratio
  if o.kind ~= "column" and (g > 0 or o.interaction) then
    local field = g > 0 and "axial_ratio" or "interaction"
    check.fail("%s: field '%s' is %s; it is for kind = 'column' alone", where, field, check.show(o[field]))
  end
  local m, fy = shared.measures(where, o.section), shared.yield_of(where, o.material)
  local x = shared.ratios_of(m, o, fy)
  local Mp = fy * m.Zx
  local moment, tau = shared.under_axial_force(g)
  local K = 3 * tau * o.material.E * m.Ix / o.shear_span
  local laws = {}
  for name, law in pairs(row) do laws[name] = law end
  if row.deep and x.inches >= row.deep_from then
    for name, law in pairs(row.deep) do laws[name] = law end
  end
  local wears = o.monotonic and o.wear ~= false
  shared.needs_wear(where, o, wears)
  if o.kind == "column" then
    laws.residual, laws.ultimate = row.residual[1] + row.residual[2] * g, row.ultimate[1] + row.ultimate[2] * g
    wears = wears and (g > row.wear_changes_at and row.wear_above or row.wear)
  elseif wears then
    wears = lignos.row(m, o.kind == "RBS").wear
  end
  local My = row.yield * shared.left_by_cut(where, o, m, o.kind == "RBS") * moment * Mp
  return shared.trilinear(where, laws, x, My, K, Mp, wears and shared.value(wears, x) or nil,
    shared.under_force(where, o, g, fy), o.stiffness_wear)
end


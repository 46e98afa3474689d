-- hinge.backbone.lignos: Lignos and Krawinkler, J. Struct. Eng. 137(11), 2011. The paper was not at hand.
--
-- Programs: amaelkady/FM-2D (Spring_IMK.tcl), ioannis-vm/OpenSees_Model_Generator. FM-2D has -0.36 for the web in the
-- first law; two other programs -0.365. One program has -0.1185 for `unbraced` in cap_rotation of RBS, where three have
-- -0.185.
-- yield: over Mp; cap: over the moment at yield; residual: over it too.
local check = require "hinge.library.check"
local shared = require "hinge.sections.backbone_laws"

local rules = shared.rules

local lignos = {}

local laws = {
  shallow = { -- d < 533 mm
    yield = 1.17, cap = 1.11, residual = 0.4, ultimate = 0.2,
    cap_rotation = { factor = 0.0865, web = -0.365, flange = -0.14, span = 0.34, depth = -0.721, stress = -0.23 },
    post_cap = { factor = 5.63, web = -0.565, flange = -0.8, depth = -0.28, stress = -0.43 },
    wear = { factor = 495, web = -1.34, flange = -0.595, stress = -0.36 },
  },
  deep = {
    yield = 1.17, cap = 1.11, residual = 0.4, ultimate = 0.2,
    cap_rotation = { factor = 0.318, web = -0.55, flange = -0.345, unbraced = -0.023, span = 0.09, depth = -0.33,
      stress = -0.13 },
    post_cap = { factor = 7.5, web = -0.61, flange = -0.71, unbraced = -0.11, depth = -0.161, stress = -0.32 },
    wear = { factor = 536, web = -1.26, flange = -0.525, unbraced = -0.13, stress = -0.291 },
  },
  reduced = { -- reduced beam section, RBS
    yield = 1.06, cap = 1.09, residual = 0.4, ultimate = 0.2,
    cap_rotation = { factor = 0.19, web = -0.314, flange = -0.1, unbraced = -0.185, span = 0.113, depth = -0.76,
      stress = -0.07 },
    post_cap = { factor = 9.52, web = -0.513, flange = -0.863, unbraced = -0.108, stress = -0.36 },
    wear = { factor = 585, web = -1.14, flange = -0.632, unbraced = -0.205, stress = -0.391 },
  },
  -- what the tests cover; depth in m, stress in Pa
  tested = {
    { "d_tw", 20, 55 }, { "Lb_ry", 20, 80 }, { "bf_2tf", 4, 8 }, { "L_d", 2.5, 7 }, { "depth", 0.102, 0.914, "m" },
    { "yield_stress", 240e6, 450e6, "Pa" },
  },
}

local function within_tests(where, o, m, x, fy)
  local at = { d_tw = m.d_tw, Lb_ry = x.unbraced, bf_2tf = m.bf_2tf, L_d = x.span, depth = m.d, yield_stress = fy }
  local words = { d_tw = "depth / web", Lb_ry = "unbraced_length / radius of gyration about y",
    bf_2tf = "width / (2 flange)", L_d = "shear_span / depth", depth = "the depth", yield_stress = "the yield stress" }
  for _, range in ipairs(laws.tested) do
    local name, from, to, unit = table.unpack(range)
    unit = unit and " " .. unit or ""
    if not (at[name] >= from and at[name] <= to) and not o.beyond_tests then
      check.fail("%s: %s of '%s' is %s%s; the tests behind the formulas have %s to %s%s. beyond_tests = true takes "
        .. "them nevertheless", where, words[name], m.kind, check.show(at[name]), unit, check.show(from),
        check.show(to), unit)
    end
  end
end

--- The laws for a section.
function lignos.row(m, reduced)
  return laws[reduced and "reduced" or m.d < shared.depth_unit and "shallow" or "deep"]
end

--- hinge.backbone.lignos
function lignos.backbone(options, ...)
  local where = "hinge.backbone.lignos"
  check.no_more(where, ...)
  local o = check.options(where, options, { section = rules.section, material = rules.material,
    shear_span = rules.length, unbraced_length = rules.length, reduced = { "boolean", default = false },
    cut = rules.no_length, wear = { "boolean", default = true }, stiffness_wear = rules.no,
    beyond_tests = { "boolean", default = false } })
  local m, fy = shared.measures(where, o.section), shared.yield_of(where, o.material)
  local x = shared.ratios_of(m, o, fy)
  within_tests(where, o, m, x, fy)
  local row, Mp = lignos.row(m, o.reduced), fy * m.Zx
  local My = row.yield * shared.left_by_cut(where, o, m, o.reduced) * Mp
  local K = 3 * o.material.E * m.Ix / o.shear_span
  shared.needs_wear(where, o, o.wear)
  return shared.trilinear(where, row, x, My, K, Mp, o.wear and shared.value(row.wear, x) or nil, nil, o.stiffness_wear)
end

return lignos

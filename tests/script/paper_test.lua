-- The paper's figures, quick: what the scripts of scripts/paper print and keep, against reference values.
--
-- Run: lua5.4 tests/script/paper_test.lua BUILD_FOLDER SCRIPT [...]      (names in scripts/paper)
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
local support = require "support"
local checks = support.checks "paper"
local quote, expect, equal = support.quote, checks.expect, checks.equal
local folder = support.temporary_folder()

local function near(value, wanted, by, what)
  expect(type(value) == "number" and math.abs(value - wanted) <= by, "%s: is %s, wanted %s within %s", what, value, wanted, by)
end
local function below(value, limit, what)
  expect(type(value) == "number" and value <= limit, "%s: is %s, wanted at most %s", what, value, limit)
end
local function pick(list, wanted)
  for _, item in ipairs(list) do
    local fits = true
    for key, value in pairs(wanted) do fits = fits and item[key] == value end
    if fits then return item end
  end
  return {}
end

local look = {}

function look.space_frame_static(r)
  -- benchmarks of SF-1, computed apart from this project: displacement at 8 kN, exact and by midpoint integration; limit load
  near(r.converged.ux_mm, 2.143364, 1e-6, "converged displacement")
  for n, ux in pairs { [2] = 1.654190, [4] = 2.022626, [8] = 2.113271, [16] = 2.135846 } do
    for _, method in ipairs { "conventional", "asi" } do
      near(pick(r.runs, { method = method, elements = n }).ux_mm, ux, 1e-6, method .. ", " .. n)
    end
  end
  near(pick(r.runs, { method = "asi-gauss", elements = 2 }).ux_mm, 2.143364, 1e-6, "two of asi-gauss")
  for _, method in ipairs { "asi", "asi-gauss" } do
    near(pick(r.runs, { method = method, elements = 2 }).limit_kN, 12.6882, 0.005 * 12.6882, "limit load, two of " .. method)
  end
  local last = math.huge
  for _, n in ipairs { 2, 4, 8, 16 } do
    local limit = pick(r.runs, { method = "conventional", elements = n }).limit_kN
    expect(limit > 12.6882 and limit < last, "the conventional limit load falls from above: %s elements %s", n, limit)
    last = limit
  end
end

function look.space_frame_dynamic(r)
  below(pick(r.elastic.errors, { method = "asi-gauss", elements = 2 }).error, 0.02, "elastic error of two of asi-gauss")
  below(pick(r.plastic.errors, { method = "asi-gauss", elements = 2 }).error, 0.05, "elasto-plastic error of two of asi-gauss")
  expect(r.elastic.parts.mass > 2 * r.elastic.parts.element, "the mass matrix's part is the larger one")
  expect(r.elastic.parts.cubic < r.elastic.parts.all / 4 and r.plastic.parts.cubic < r.plastic.parts.all / 2, "the cubic mass leaves a quarter, and a half")
end

function look.fracture_figures(r)
  for _, name in ipairs { "mass", "linear", "angular" } do
    near(r.after[name] / r.before[name], 1, 1e-9, name .. " through the fracture")
  end
  local virtual, rigid = 0, 0
  for _, node in ipairs(r.after.nodes) do virtual = virtual + (node.virtual and 1 or 0) end
  for _, bar in ipairs(r.after.bars) do rigid = rigid + (bar.rigid and 1 or 0) end
  expect(virtual > 0 and virtual == rigid, "%d virtual nodes, %d rigid bars", virtual, rigid)
end

function look.two_beam_impact(r)
  below(r.rules.surface.worst, 0.005, "remainder by surfaces")
  equal(r.rules.surface.let_go, 0, "let go by surfaces")
  below(r.rules.gap.worst, 0.01, "remainder by gaps")
  below(math.abs(r.rules.gap.let_go), 0.02, "let go by gaps")
  near(r.rules.letter.let_go, 0.12, 0.02, "let go by the letter")
  equal(#r.sweep, 27, "crossings of the sweep")
end

function look.ten_storey_cases(r)
  for _, case in ipairs { "I", "II", "III", "IV" } do
    local c = r.cases[case]
    below(math.abs(c.remainder), 0.02 * c.own_kinetic, "remainder of Case " .. case)
    expect(c.work > 0 and c.broken_aircraft > 0, "Case %s: plastic work %s, %s members of the aircraft broken", case, c.work, c.broken_aircraft)
  end
  near(r.cases.II.own_kinetic, 59.3e6, 0.1e6, "kinetic energy of Case II")
  equal(#r.findings, 8, "findings")
  local first
  for _, t in ipairs(r.cases.I.felt) do first = t >= 0 and math.min(first or t, t) or first end
  below(first, 1e-3, "first storey to feel the impact, s")
end

for i = 2, #arg do
  local name = arg[i]
  local status, _, complaint = support.run(("%s run %s quick=true --out %s"):format(quote(arg[1] .. "/hinge"),
    quote(support.root .. "scripts/paper/" .. name .. ".lua"), quote(folder .. "/" .. name)))
  equal(status, 0, name .. ": " .. complaint)
  local summary = support.json(support.read(folder .. "/" .. name .. "/summary.json") or "{}")
  equal(summary.verdict, "completed", name)
  if summary.results then look[name](summary.results) end
end
checks.done()

-- What must hold between runs of one scene, or within one run: the relations of tests/hard/relations.lua.
--
-- A relation: name, why its tolerance is what it is, fits(scene), and check(hinge, scene), which returns the largest
-- deviation over its tolerance (above 1: it does not hold) and what deviates, or nil and why it could not be asked.
-- acts(scene): the scene without what the relation leaves out.
local scenes = require "relation_scenes"
local built = require "relation_model"
local runs = require "relation_runs"
local has, compare, answer_of, unless_chaotic = runs.has, runs.compare, runs.answer_of, runs.unless_chaotic
local told_tolerance, zero, chance = runs.told_tolerance, runs.zero, runs.chance
local list = {}

local function same_when_told(hinge, s, changes)
  local a, limit = answer_of(hinge, s), told_tolerance(s)
  return unless_chaotic(hinge, s, a, limit, compare(a, answer_of(hinge, s, changes), limit))
end

list[#list + 1] = { name = "rotated", why = "rounding and iterations times the structure's sensitivity",
  fits = function() return true end,
  check = function(hinge, s)
    local d = chance(s, 101)
    -- a diaphragm lies across z, a sway goes with the height
    local axis = has(s, "diaphragm", "sway") and { 0, 0, 1 } or d.direction()
    return same_when_told(hinge, s, { turn = built.rotation(axis, d.number(0.1, 6.2)) })
  end }

list[#list + 1] = { name = "units", why = "as rotated",
  fits = function(s) return not has(s, "concrete") end, -- whose strengths are in Pa
  check = function(hinge, s)
    local d = chance(s, 102)
    return same_when_told(hinge, s, d.pick { { length = 1e-3, mass = 1e3 }, { length = 0.0254, mass = 0.45359237 },
      { length = 1, mass = 1e6 } })
  end }

list[#list + 1] = { name = "order", why = "as rotated",
  fits = function() return true end,
  check = function(hinge, s)
    local d = chance(s, 103)
    return same_when_told(hinge, s, { reverse = d.chance(0.5), order = function(order)
      for i = #order, 2, -1 do
        local j = d.whole(1, i)
        order[i], order[j] = order[j], order[i]
      end
    end })
  end }

-- Neutral values ----------------------------------------------------------------------------------------------------

-- Of each kind: the part at its neutral value, or nil where the scene has no place for it.
local neutral = {}
function neutral.gravity() return { kind = "gravity", g = zero } end
function neutral.load(s) return { kind = "load", node = s.free, force = zero } end
function neutral.q() return { kind = "q", member = 1, a = zero, b = zero, axes = "global" } end
function neutral.line_mass()
  return { kind = "line_mass", member = 1, a = 0, b = 0, from = 0.2, to = 1 }
end
function neutral.point() return { kind = "point", member = 1, at = 0.3, force = zero } end
function neutral.sway(s) return s.held and { kind = "sway", value = 0, direction = { 1, 0, 0 } } end
function neutral.settle(s) return s.mode == "static" and { kind = "settle", node = 1, by = zero } end
function neutral.move(s) return s.mode == "dynamic" and s.held and { kind = "move", node = 1, by = zero } end
function neutral.panel(s) return s.spot and { kind = "panel", nodes = s.spot, bars = 1e-30 } end
function neutral.heat(s) return s.held and { kind = "heat", member = 1, temperature = 20 } end
function neutral.prestress() return { kind = "prestress", member = 1, strain = 0 } end
function neutral.one_way(s) return not s.yields and { kind = "one_way", member = 1, carries = "both" } end
function neutral.backbone(s) return s.yields and { kind = "backbone", member = 1, points = { { 0, 1 } } } end
function neutral.law(s) return s.yields and { kind = "law", member = 1, slope = 0 } end
function neutral.rate(s) return s.mode == "dynamic" and s.yields and { kind = "rate", D = 1e80, q = 4 } end
function neutral.damping(s) return s.mode == "dynamic" and { kind = "damping", alpha = 0, beta = 0 } end
function neutral.remove(s) return s.mode == "dynamic" and { kind = "remove", member = 1, at = 1e6 } end
function neutral.fracture(s) return s.mode == "dynamic" and { kind = "fracture", rotation = 1e3 } end
function neutral.contact(s) return s.mode == "dynamic" and s.class ~= "collision" and { kind = "contact" } end
function neutral.ground(s) return s.mode == "dynamic" and not s.held and { kind = "ground", depth = 1e3 } end
function neutral.velocity(s)
  return s.mode == "dynamic" and s.held and { kind = "velocity", node = s.free, v = zero, w = zero }
end

-- These let a run control its steps by their energy: it may shorten some, and has another error then.
local controls = { remove = true, fracture = true, contact = true, ground = true }
local names = {}
for name in pairs(neutral) do names[#names + 1] = name end
table.sort(names)
list[#list + 1] = { name = "neutral", why = "bits, or another path of the same equations: 1e-7",
  fits = function() return true end,
  check = function(hinge, s)
    local d = chance(s, 104)
    local kind, part
    repeat
      kind = d.pick(names)
      part = neutral[kind](s)
    until part
    local without = scenes.copy(s, function(p) return p.kind == kind end)
    if controls[kind] then without.step_control = 0 end
    local with = scenes.copy(without)
    with.parts[#with.parts + 1] = part
    local a, limit = answer_of(hinge, without), s.yields and 1e-6 or 1e-7
    local off, what = unless_chaotic(hinge, without, a, limit, compare(a, answer_of(hinge, with), limit))
    return off, kind .. ": " .. (what or "")
  end }

for _, name in ipairs { "relation_balance", "relation_routes" } do
  for _, relation in ipairs(require(name)) do list[#list + 1] = relation end
end
return list

-- A mast that is pushed to and fro until its foot is worn out: see own_rules.md.
local hinge = require "hinge"

local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 325e6 }
local post = hinge.section.box { width = 0.15, depth = 0.15, thickness = 0.008 }
local push, limit = 6e3, 20e3 -- N; J of plastic work that a joint stands

local model = hinge.model {}
local foot, top = model:node { 0, 0, 0 }, model:node { 0, 0, 4 }
model:fix(foot, "all")
local mast = model:member { foot, top, section = post, material = steel, group = "mast" }
model:mass { node = top, mass = 500 }

-- A bar beside the mast.
local bar = { model:node { 1, -1, 3 }, model:node { 1, 1, 3 } }
model:fix(bar, "all")
model:member { bar[1], bar[2], section = post, material = steel, group = "bar" }

model:gravity { 0, 0, -9.80665 }
local rest = model:static { steps = 1 }:finish()

-- A load that depends on the state: it pushes in the direction of motion, while the mast stands.
model:load {
  node = top,
  force = function(_, run)
    if mast:state(run) == "broken" then return 0, 0, 0 end
    return top:velocity(run) >= 0 and push or -push, 0, 0
  end,
}

-- A fracture rule with a memory: plastic work adds up to damage.
local damage = { x = {}, y = {}, name = "damage at the foot" }
model:fracture {
  group = "mast", keep = { "seen", "damage" },
  rule = function(section)
    if section.node ~= foot.index then return false end
    section.damage = section.damage + (section.plastic_work - section.seen) / limit
    section.seen = section.plastic_work
    damage.x[#damage.x + 1], damage.y[#damage.y + 1] = section.time, section.damage
    return section.damage >= 1
  end,
}

-- A function that is called at contacts.
local first
model:contact { between = { "mast", "bar" }, on_contact = function(event) first = first or event end }

local run = model:dynamic { from = rest, dt = 1e-4, duration = 4 }
local sway = run:probe { node = top, "ux" }
local broken_at, worn
run:on_step(function(r)
  local state, _, time = mast:state(r)
  if state == "broken" and not broken_at then broken_at, worn = time, r.energy.plastic end
  if first then r:stop() end
end)
run:finish()

print(("the foot breaks at %.2f s, after %.0f J of plastic work; the limit is %.0f J"):format(broken_at, worn, limit))
print(("at %.2f s %s meets %s"):format(first.time, first.a.group, first.b.group))
print(("the run was %s, energy error %.3f %%"):format(run.verdict, 100 * math.abs(run.energy_error)))
hinge.plot({ series = { damage, { x = sway.time, y = sway.value, name = "sway of the top, m" } }, x_label = "time, s",
  y_label = "damage, sway", width = 1000, height = 600 }, "own_rules.png")

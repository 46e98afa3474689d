-- Random buildings with slabs that lose columns, whose top floor falls, or that something strikes from above: the class
-- "floors" of random_scenes.lua, which draws it with as=floors alone.
--
-- Run     lua5.4 tests/hard/random.lua as=floors count=1000 seconds=60 jobs=2
local vectors = require "hinge.library.vectors"

-- tools: member, note, damping, fracture, contact, ground, at_rest, section, material_of of random_scenes.lua.
return function(s, tools)
  local d, hinge, model, note = s.d, s.hinge, s.model, tools.note
  local nx, ny, storeys = d.whole(1, 2), d.whole(1, 2), d.whole(1, 3)
  local span_x, span_y, height = d.number(3, 8), d.number(3, 8), d.number(3, 4.5)
  local numbers = tools.material_of(d)
  numbers.yield_stress = numbers.yield_stress or 355e6
  local steel = hinge.material(numbers)
  local column = tools.section(hinge, d, height, d.log(20, 70), d.pick { "h", "box" })
  local beam = tools.section(hinge, d, span_x > span_y and span_x or span_y, d.log(25, 80), d.pick { "h", "box" })
  local at = {}
  for k = 0, storeys do
    for i = 0, nx do
      for j = 0, ny do
        local node = model:node { span_x * i, span_y * j, height * k }
        at[i .. " " .. j .. " " .. k] = node
        if k == 0 then model:fix(node) end
      end
    end
  end
  local function node(i, j, k) return at[i .. " " .. j .. " " .. k] end
  local columns = {}
  for k = 1, storeys do
    for i = 0, nx do
      for j = 0, ny do
        local group = "columns " .. i .. " " .. j .. " " .. k
        columns[#columns + 1] = { group = group, storey = k }
        s.members[#s.members + 1] = tools.member(s, node(i, j, k - 1), node(i, j, k), { section = column,
          material = steel, group = { "frame", group }, up = { 1, 0, 0 } })
      end
    end
  end
  -- What a slab is made of: concrete with a mesh, sheets of steel, or both.
  local kind = d.weighted { { 5, "concrete" }, { 3, "plate" }, { 2, "deck" } }
  local t, mesh = d.number(0.08, 0.2), d.log(1e-4, 1e-3)
  local bars = { x = mesh, y = d.chance(0.7) and mesh or mesh / 2, yield_stress = 500e6, hardening = 1e9,
    ultimate_strain = d.chance(0.7) and d.log(0.01, 0.1) or nil }
  local moment = mesh * 500e6 * 0.7 * t -- N m/m
  local bends = { stiffness = d.number(0.2, 0.5) * 3e10 * t ^ 3 / 12, sagging = moment, hogging = moment }
  local slab = kind == "plate" and { thickness = d.number(0.006, 0.02), material = steel,
      ultimate_strain = d.chance(0.5) and d.log(0.02, 0.2) or nil }
    or { concrete = { thickness = t, E = 3e10, strength = d.number(20e6, 50e6) }, reinforcement = bars, bending = bends,
      deck = kind == "deck" and { area = d.log(5e-4, 2e-3), yield_stress = 320e6 } or nil }
  -- Chosen by later digits of what is drawn already, so that what follows is drawn as without them.
  local function digits(x) return x * 1e5 % 1 end
  local layers, on_studs = digits(t) < 0.2, digits(1e3 * mesh) < 0.3
  if layers then
    slab.bending = "layers"
    if slab.reinforcement then slab.reinforcement.z = (0.5 - digits(moment)) * 0.7 * t end
    if slab.deck then slab.deck.z = -t / 2 end
  end
  if on_studs then
    local slip = digits(span_x)
    slab.studs = { spacing = 0.1 + 0.3 * digits(span_y), stiffness = 50e6, capacity = slip > 0.3 and 60e3 or nil,
      slip = slip > 0.6 and 5e-3 or nil, height = digits(height) < 0.5 and 0.3 or 0 }
  end
  local mass = d.number(150, 700)
  for k = 1, storeys do
    local beams = {}
    local function join(a, b)
      beams[#beams + 1] = tools.member(s, a, b, { section = beam, material = steel, group = { "frame", "beams" } })
    end
    for i = 0, nx do
      for j = 0, ny do
        if i < nx then join(node(i, j, k), node(i + 1, j, k)) end
        if j < ny then join(node(i, j, k), node(i, j + 1, k)) end
      end
    end
    model:floor { members = beams, mass = mass, slab = slab }
  end
  note(s, "building of %d x %d bays of %.1f x %.1f m, %d storeys of %.1f m, slab of %s%s%s, %.0f kg/m2", nx, ny, span_x,
    span_y, storeys, height, kind, layers and " that bends by its layers" or "", on_studs and " on studs" or "", mass)
  tools.damping(s)
  tools.at_rest(s, 1)
  local event = d.weighted { { 4, "lost column" }, { 3, "falling floor" }, { 3, "struck" } }
  local falls = event ~= "lost column" or d.chance(0.5)
  if falls and s.changed.contact ~= "none" then
    model:panel_contact { friction = d.chance(0.6) and d.number(0.1, 0.6) or nil,
      restitution = d.chance(0.7) and d.number(0.2, 1) or nil }
    note(s, "contact of panels")
  end
  if event == "lost column" then
    local lost = d.pick(columns).group
    model:remove { group = lost, at = 0 }
    note(s, "%s is lost", lost)
  elseif event == "falling floor" then
    for _, one in ipairs(columns) do
      if one.storey == storeys then model:remove { group = one.group, at = 0 } end
    end
    note(s, "the top floor falls")
  else
    local x, y = d.number(0.1, 0.9) * span_x * nx, d.number(0.1, 0.9) * span_y * ny
    local side, speed, z = d.number(0.15, 0.4), d.log(3, 40), height * storeys + 0.5
    local length, v = d.number(1, 4), d.direction()
    if v[3] < 0 then v = vectors.times(-1, v) end
    local b = { x + length * v[1], y + length * v[2], z + length * v[3] }
    s.members[#s.members + 1] = tools.member(s, model:node { x, y, z }, model:node(b), { material = steel,
      section = hinge.section.solid { width = side, depth = side }, group = "missile" })
    model:velocity("missile", { 0, 0, -speed })
    s.speed, s.held = speed, "missile"
    note(s, "a bar of %.2f x %.1f m strikes at %.3g m/s", side, length, speed)
  end
  if d.chance(0.6) then tools.fracture(s, "frame") end
  if d.chance(0.4) then tools.contact(s) end
  if d.chance(0.7) then tools.ground(s, { friction = d.chance(0.5) and d.number(0, 0.6) or nil }) end
  s.wanted = d.log(0.2, 1.2)
end

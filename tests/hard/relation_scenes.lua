-- Scenes for tests/hard/relations.lua: small structures as plain tables, drawn by seed, and the model made of one.
--
-- A scene: seed, class, mode ("static" or "dynamic"), options (of the model), nodes { x, y, z, fixed = }, members
-- { a, b, up =, section = }, parts. Every effect is a part, { kind =, ... }, so that a scene can lose it, have it at
-- its neutral value, or be shrunk part by part. All numbers are in SI units; relation_model.lua says in which axes,
-- units and order they are declared.
local folder = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$"
package.path = folder .. "?.lua;" .. package.path
local vectors = require "hinge.library.vectors"
local draws = require("random_scenes").draws
local scenes = {}

-- Sections and materials --------------------------------------------------------------------------------------------

local steel = { E = 206e9, nu = 0.3, density = 7850 }
local lengths = { "width", "depth", "thickness", "web", "flange", "diameter", "cover" }

-- Numbers of a section of a length and a slenderness.
local function section_numbers(d, length)
  local r, shape = length / d.log(25, 90), d.pick { "box", "h", "solid", "pipe" }
  if shape == "box" then return { shape = shape, width = r / 0.4, depth = r / 0.4 * d.number(1, 1.5),
    thickness = r / 0.4 / d.number(10, 25) } end
  if shape == "h" then return { shape = shape, width = r / 0.24, depth = r / 0.24 * d.number(1, 2), web = r / 4.8,
    flange = r / 3 } end
  if shape == "pipe" then return { shape = shape, diameter = r / 0.34, thickness = r / 0.34 / d.number(12, 30) } end
  return { shape = shape, width = r / 0.2887, depth = r / 0.2887 * d.number(1, 1.4) }
end

local function make_section(hinge, of, unit)
  local o = {}
  for _, name in ipairs(lengths) do if of[name] then o[name] = of[name] * unit.m end end
  if of.shape == "concrete" then
    o.concrete, o.steel, o.stiffness = 30e6 * unit.Pa, 500e6 * unit.Pa, 0.5
    o.layers = { { y = "top", count = 3, diameter = of.bar * unit.m }, { y = "bottom", count = 3,
      diameter = of.bar * unit.m } }
  end
  return hinge.section[of.shape](o)
end

-- Structures --------------------------------------------------------------------------------------------------------

local function add_node(s, x, y, z, fixed)
  s.nodes[#s.nodes + 1] = { x, y, z, fixed = fixed }
  return #s.nodes
end
local function add_member(s, a, b, section)
  local t, up = vectors.minus(s.nodes[b], s.nodes[a]), s.d.direction()
  local l = vectors.length(t)
  while math.abs(vectors.dot(t, up)) > 0.7 * l do up = s.d.direction() end
  s.members[#s.members + 1] = { a, b, up = up, section = section or section_numbers(s.d, l), length = l }
  return #s.members
end

local classes = {}
function classes.cantilever(s)
  local d = s.d
  local t, l = d.pick { { 1, 0, 0 }, { 0, 0, 1 }, d.direction() }, d.number(1, 4)
  local last = add_node(s, 0, 0, 0, "all")
  for i = 1, d.whole(1, 3) do
    local node = add_node(s, t[1] * l * i, t[2] * l * i, t[3] * l * i)
    add_member(s, last, node, s.members[1] and s.members[1].section)
    last = node
  end
end
function classes.beam(s)
  classes.cantilever(s)
  s.nodes[#s.nodes].fixed = "all"
  if #s.nodes == 2 then -- a node in the middle
    local far = s.nodes[2]
    s.nodes[2] = { 0.4 * far[1], 0.4 * far[2], 0.4 * far[3] }
    s.nodes[3] = far
    local section = s.members[1].section
    s.members = {}
    add_member(s, 1, 2, section)
    add_member(s, 2, 3, section)
  end
end
local function storeys(s, count, braced)
  local d = s.d
  local bay, height = d.number(2, 6), d.number(2.5, 4)
  local left, right = add_node(s, 0, 0, 0, "all"), add_node(s, bay, 0, 0, "all")
  local column, beam
  for k = 1, count do
    local a, b = add_node(s, 0, 0, k * height), add_node(s, bay, 0, k * height)
    column = column or section_numbers(d, height)
    beam = beam or section_numbers(d, bay)
    add_member(s, left, a, column)
    add_member(s, right, b, column)
    s.beams[#s.beams + 1] = add_member(s, a, b, beam)
    if braced then
      local rod = { shape = "round", diameter = d.number(0.02, 0.04) }
      s.braces[#s.braces + 1] = add_member(s, left, b, rod)
      s.braces[#s.braces + 1] = add_member(s, right, a, rod)
    end
    left, right = a, b
  end
end
function classes.portal(s) storeys(s, 1) end
function classes.tower(s) storeys(s, 2, s.d.chance(0.7)) end
function classes.space(s)
  local d = s.d
  local x, y, z = d.number(2, 5), d.number(2, 5), d.number(2.5, 4)
  local column, beam, heads = section_numbers(d, z), section_numbers(d, x), {}
  for i, at in ipairs { { 0, 0 }, { x, 0 }, { x, y }, { 0, y } } do
    local foot = add_node(s, at[1], at[2], 0, "all")
    heads[i] = add_node(s, at[1], at[2], z)
    add_member(s, foot, heads[i], column)
  end
  for i = 1, 4 do s.beams[#s.beams + 1] = add_member(s, heads[i], heads[i % 4 + 1], beam) end
  s.heads = heads
end
function classes.free(s)
  local d = s.d
  local last = add_node(s, d.number(-1, 1), d.number(-1, 1), d.number(-1, 1))
  for _ = 1, d.whole(1, 4) do
    local p, t, l = s.nodes[last], d.direction(), d.number(0.8, 2)
    local node = add_node(s, p[1] + l * t[1], p[2] + l * t[2], p[3] + l * t[3])
    add_member(s, last, node)
    if d.chance(0.7) then last = node end
  end
  s.parts[#s.parts + 1] = { kind = "velocity", v = { d.number(-5, 5), d.number(-5, 5), d.number(-5, 5) },
    w = { d.number(-3, 3), d.number(-3, 3), d.number(-3, 3) } }
end
function classes.collision(s) -- two bars that cross, and meet
  local d = s.d
  local section = section_numbers(d, 1)
  local size = 0.5 * math.min(section.width or section.diameter, section.depth or section.diameter)
  add_member(s, add_node(s, -1, d.number(-0.2, 0.2), 0), add_node(s, 1, 0, d.number(-0.1, 0.1)), section)
  local y = d.number(-0.3, 0.3)
  add_member(s, add_node(s, d.number(-0.3, 0.3), y - 1, 2.2 * size + 0.12), add_node(s, d.number(-0.3, 0.3), y + 1,
    2.2 * size + 0.12), section)
  s.parts[#s.parts + 1] = { kind = "velocity", member = 2, v = { 0, 0, -d.number(5, 20) }, w = { 0, 0, 0 } }
  s.parts[#s.parts + 1] = { kind = "contact", friction = d.chance(0.5) and 0.3 or nil, stiffness = d.log(1e7, 1e8) }
end

-- Effects -----------------------------------------------------------------------------------------------------------

local function free_nodes(s)
  local list = {}
  for i, n in ipairs(s.nodes) do if not n.fixed then list[#list + 1] = i end end
  return list
end
local function scaled(v, by) return vectors.times(by, v) end

local function add_loads(s, add, mp, size)
  local d = s.d
  local own = d.chance(s.yields and 0.6 or 0) and d.number(0.4, 0.9) or d.number(0.05, 0.3)
  local force = own * mp / size
  local function path()
    if s.mode == "static" or d.chance(0.4) then return nil end
    return d.pick { { { 0, 0 }, { 0.02, 1 } }, { { 0, 1 }, { 0.03, -0.5 } }, { { 0, 0 }, { 0.01, 1 }, { 0.02, 0 } } }
  end
  for _ = 1, d.whole(1, 2) do
    add { kind = "load", node = d.pick(free_nodes(s)), force = scaled(d.direction(), force),
      moment = d.chance(0.3) and scaled(d.direction(), 0.3 * force * size) or nil, history = path() }
  end
  if d.chance(0.4) then
    local q = scaled(d.direction(), force / size)
    add { kind = "q", member = d.whole(1, #s.members), a = q, b = d.chance(0.5) and q or scaled(d.direction(),
      force / size), axes = d.pick { "global", "global", "local" }, history = path() }
  end
  if d.chance(0.3) then
    add { kind = "point", member = d.whole(1, #s.members), at = d.number(0.15, 0.85), force = scaled(d.direction(),
      0.5 * force), moment = d.chance(0.4) and scaled(d.direction(), 0.1 * force * size) or nil, history = path() }
  end
end

local function add_joints(s, add, stiffness, mp)
  local d = s.d
  if d.chance(0.3) then
    local function axis()
      return d.chance(0.4) and "rigid" or { stiffness = stiffness * d.log(0.3, 30),
        strength = s.yields and mp * d.number(0.4, 1.2) or nil }
    end
    local Mx, My = axis(), axis()
    if Mx == "rigid" and My == "rigid" then My = { stiffness = stiffness } end
    add { kind = "joint", member = d.whole(1, #s.members), at_end = d.pick { "a", "b" }, Mx = Mx, My = My }
  end
  if #s.beams > 0 and d.chance(0.2) then
    add { kind = "release", member = d.pick(s.beams), at_end = d.pick { "a", "b" }, what = d.pick { "Mx", "My" } }
  end
  if d.chance(0.25) then
    local i = d.pick(free_nodes(s))
    add { kind = "link", from = i, by = scaled(d.direction(), 0.3), dofs = d.pick { "all", "all", "xyz" },
      force = scaled(d.direction(), 0.05 * mp) }
  end
  local linked = s.parts[#s.parts] and s.parts[#s.parts].kind == "link"
  if s.heads and d.chance(0.6) and not linked then add { kind = "diaphragm", nodes = s.heads } end
  if d.chance(0.3) then
    local k = 10 * stiffness
    add { kind = "connector", node = d.pick(free_nodes(s)), x = d.direction(),
      k = { x = k, y = k * d.number(), z = k / 2, rx = stiffness },
      c = s.mode == "dynamic" and d.chance(0.4) and { x = 0.01 * k } or nil,
      curve = d.chance(0.2) and { { 0, 0 }, { 1e-3, 1e-3 * k }, { 1, 0.1 * k } } or nil }
  end
end

local function add_strength(s, add)
  local d = s.d
  if not s.yields then return end
  add { kind = "yield", stress = d.pick { 235e6, 355e6 } }
  if d.chance(0.5) then add { kind = "hardening", tangent = d.log(5e8, 8e9), kinematic = d.pick { 1, 0, 0.5 } } end
  if d.chance(0.2) then add { kind = "hardening", modulus = 5e9, saturation = 6e7 } end
  if s.mode == "dynamic" and d.chance(0.2) then add { kind = "rate", D = 40.4, q = 5 } end
  for _, part in ipairs(s.parts) do s.law = s.law or part.kind == "hardening" or part.kind == "rate" end
  if d.chance(0.25) then
    add { kind = "backbone", member = d.whole(1, #s.members), points = d.pick { { { 0, 1.1 }, { 0.03, 1.2 } },
      { { 0, 1 }, { 0.02, 1.1 }, { 0.1, 0.4 } } } }
  elseif d.chance(0.2) then
    add { kind = "law", member = d.whole(1, #s.members), slope = d.number(0, 5) }
  end
  if d.chance(0.2) then s.options.interaction = d.pick { "exact with shear", "paper" } end
end

local function add_strains(s, add)
  local d = s.d
  if d.chance(0.25) then add { kind = "heat", member = d.whole(1, #s.members), temperature = d.number(30, 90),
    across = d.chance(0.4) and d.number(-20, 20) or nil } end
  if d.chance(0.2) then
    add { kind = "prestress", member = d.whole(1, #s.members), strain = d.number(-2e-4, 2e-4) }
  end
  if s.mode == "static" and d.chance(0.25) then
    add { kind = "settle", node = 1, by = scaled(d.direction(), d.number(1e-3, 8e-3)) }
  end
  if d.chance(0.15) and s.class ~= "cantilever" and s.class ~= "beam" then
    add { kind = "sway", value = d.number(0.002, 0.01), direction = { math.cos(d.number(0, 6)),
      math.sin(d.number(0, 6)), 0 } }
  end
  for _, i in ipairs(s.braces) do
    local law = s.law
    for _, part in ipairs(s.parts) do
      law = law or part.member == i and (part.kind == "law" or part.kind == "backbone" or part.kind == "joint")
    end
    if d.chance(0.6) and not law then add { kind = "one_way", member = i, carries = "tension" } end
  end
end

local function add_motion(s, add)
  local d = s.d
  if s.mode ~= "dynamic" then return end
  if s.held and d.chance(0.2) then add { kind = "move", node = 1, by = scaled(d.direction(), d.number(1e-3, 1e-2)) } end
  if d.chance(0.4) then add { kind = "damping", alpha = s.held and d.number(0, 3) or 0, beta = d.log(1e-5, 1e-3) } end
  if s.class ~= "collision" and #s.members > 1 and d.chance(0.15) then
    add { kind = "remove", member = d.whole(1, #s.members), at = 0.005, over = d.chance(0.4) and 0.01 or nil }
  end
  if s.yields and d.chance(0.2) then add { kind = "fracture", rotation = d.log(0.005, 0.05) } end
  if not s.held and s.class ~= "collision" and d.chance(0.25) then
    add { kind = "ground", depth = d.number(0.02, 0.2), friction = d.chance(0.5) and 0.4 or nil }
  end
  if s.held and d.chance(0.15) then add { kind = "velocity", v = scaled(d.direction(), d.number(0.1, 1)),
    w = { 0, 0, 0 }, node = d.pick(free_nodes(s)) } end
end

--- The scene of a seed.
function scenes.draw(hinge, seed)
  local d = draws(seed, 57)
  local class = d.weighted { { 3, "cantilever" }, { 3, "beam" }, { 4, "portal" }, { 3, "tower" }, { 3, "space" },
    { 3, "free" }, { 1, "collision" } }
  local s = { seed = seed, class = class, d = d, nodes = {}, members = {}, parts = {}, options = {}, beams = {},
    braces = {}, held = class ~= "free" and class ~= "collision" }
  s.mode = s.held and d.chance(0.55) and "static" or "dynamic"
  s.yields = d.chance(0.45)
  if s.held and d.chance(0.35) then s.options.displacement = "small" end
  classes[class](s)
  local unit = { m = 1, Pa = 1 }
  local section = make_section(hinge, s.members[1].section, unit)
  local length = s.members[1].length
  local mp, stiffness = 235e6 * section.Zx, 4 * steel.E * section.Ix / length
  local function add(part) s.parts[#s.parts + 1] = part end
  if s.held or d.chance(0.3) then
    if d.chance(0.5) then add { kind = "gravity", g = s.held and d.chance(0.3) and scaled(d.direction(), 9.80665)
      or { 0, 0, -9.80665 } } end
  end
  if s.held then add_loads(s, add, mp, length) end
  if d.chance(0.3) then add { kind = "mass", node = d.pick(free_nodes(s)), mass = section.area * 7850 * length
    * d.log(0.1, 5), inertia = d.chance(0.5) and 5 or 0,
    offset = d.chance(0.3) and scaled(d.direction(), 0.2) or nil } end
  if s.class ~= "collision" then add_joints(s, add, stiffness, mp) end
  add_strength(s, add)
  if s.held then add_strains(s, add) end
  add_motion(s, add)
  if s.yields and d.chance(0.1) then
    add { kind = "concrete", member = d.whole(1, #s.members), section = { shape = "concrete", width = 0.3, depth = 0.4,
      cover = 0.04, bar = 0.02 } }
  end
  local e = draws(seed, 58) -- so that all else is drawn as before
  if e.chance(0.25) then
    local function per_length() return section.area * 7850 * e.log(0.1, 5) end
    local even, part = e.chance(0.3) and per_length(), e.chance(0.3)
    add { kind = "line_mass", member = e.whole(1, #s.members), a = even or per_length(),
      b = even or e.chance(0.7) and per_length() or 0, from = part and e.number(0, 0.4) or 0,
      to = part and e.number(0.5, 1) or 1 }
  end
  -- four nodes in a plane, for a plate between them: a wall of a frame, a floor on four columns
  s.spot = ({ portal = { 1, 2, 4, 3 }, tower = { 3, 4, 6, 5 }, space = s.heads })[class]
  e = draws(seed, 59)
  if s.spot and e.chance(0.4) then
    local nodes = table.move(s.spot, 1, e.chance(0.3) and 3 or 4, 1, {})
    add { kind = "panel", nodes = nodes, thickness = e.log(2e-4, 5e-3), stress = s.yields and e.pick { 50e6, 235e6 },
      bars = e.chance(0.3) and e.log(1e-4, 1e-3) or nil }
  end
  s.d, s.free = nil, free_nodes(s)[1]
  return s
end

--- The kinds of its parts, with those that are options of the model.
function scenes.kinds(s)
  local found = { [s.options.displacement == "small" and "small displacement" or "large displacement"] = true }
  for _, part in ipairs(s.parts) do
    found[part.kind] = true
    if part.history then found.history = true end
  end
  if s.options.interaction then found[s.options.interaction] = true end
  return found
end

--- A copy; `drop`: without parts of which it returns true.
function scenes.copy(s, drop)
  local out = {}
  for k, v in pairs(s) do out[k] = v end
  out.options, out.parts = {}, {}
  for k, v in pairs(s.options) do out.options[k] = v end
  for _, part in ipairs(s.parts) do if not (drop and drop(part)) then out.parts[#out.parts + 1] = part end end
  return out
end

scenes.steel, scenes.make_section = steel, make_section
return scenes

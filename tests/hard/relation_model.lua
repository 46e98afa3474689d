-- The model of a scene of relation_scenes.lua, told in given axes, units and order, and what a run of it answers.
local scenes = require "relation_scenes"
local vectors = require "hinge.library.vectors"
local with = require "scenes".with
local built = {}

--- How a scene is told. turn: a rotation about the origin, a 3 x 3 matrix; length and mass: the script's units in m
--- and kg; order: a function that rearranges a list in place; reverse: members from their second node to their first;
--- stiffer: a factor on E.
function built.way(changes)
  return with({ turn = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, length = 1, mass = 1, order = function() end,
    reverse = false, options = {}, run = {} }, changes)
end

local function turned(R, v) return { vectors.dot(R[1], v), vectors.dot(R[2], v), vectors.dot(R[3], v) } end
local function back(R, x, y, z)
  return R[1][1] * x + R[2][1] * y + R[3][1] * z, R[1][2] * x + R[2][2] * y + R[3][2] * z,
    R[1][3] * x + R[2][3] * y + R[3][3] * z
end

--- Rotation by an angle about an axis of unit length (Rodrigues).
function built.rotation(axis, angle)
  local c, s = math.cos(angle), math.sin(angle)
  local x, y, z = axis[1], axis[2], axis[3]
  return { { c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s },
    { x * y * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s },
    { x * z * (1 - c) - y * s, y * z * (1 - c) + x * s, c + z * z * (1 - c) } }
end

-- Parts that members have as options: of each, options[member index].
local function member_options(hinge, s, unit, way)
  local options, material = {}, { hardening = nil }
  local function of(i)
    options[i] = options[i] or { ends = {}, release = {} }
    return options[i]
  end
  local function end_of(name) return way.reverse and (name == "a" and "b" or "a") or name end
  for _, part in ipairs(s.parts) do
    local kind = part.kind
    if kind == "joint" then
      local function axis(a)
        if type(a) ~= "table" then return a end
        return { stiffness = a.stiffness * unit.Nm, strength = a.strength and a.strength * unit.Nm }
      end
      of(part.member).ends[end_of(part.at_end)] = hinge.joint { Mx = axis(part.Mx), My = axis(part.My) }
    elseif kind == "release" then of(part.member).release[end_of(part.at_end)] = part.what
    elseif kind == "one_way" then of(part.member).carries = part.carries
    elseif kind == "backbone" then of(part.member).backbone = hinge.backbone { points = part.points }
    elseif kind == "law" then
      local slope = part.slope
      of(part.member).law = { variables = 1, step = function(flow, history)
        local all = history[1] + flow.strain
        return 1 + slope * all, nil, { all }
      end }
    elseif kind == "concrete" then of(part.member).section = scenes.make_section(hinge, part.section, unit)
    elseif kind == "yield" then material.yield_stress = part.stress * unit.Pa
    elseif kind == "hardening" then
      material.hardening = { tangent = part.tangent and part.tangent * unit.Pa, kinematic = part.kinematic,
        modulus = part.modulus and part.modulus * unit.Pa, saturation = part.saturation and part.saturation * unit.Pa }
    elseif kind == "rate" then material.rate = { D = part.D, q = part.q }
    end
  end
  if not material.yield_stress then material.hardening, material.rate = nil, nil end
  return options, material
end

-- What each kind of part declares. `b`: the model in the making.
local declare = {}
function declare.load(b, p)
  b.model:load { node = b.nodes[p.node], force = b.vector(p.force, b.unit.N), history = p.history,
    moment = p.moment and b.vector(p.moment, b.unit.Nm) }
end
function declare.q(b, p)
  local per = b.unit.N / b.unit.m
  local function q(v)
    if p.axes ~= "local" then return b.vector(v, per) end
    local sign = b.way.reverse and -1 or 1 -- x and z of the member turn round, y is `up`
    return { sign * v[1] * per, v[2] * per, sign * v[3] * per }
  end
  local first, second = p.a, p.b
  if b.way.reverse then first, second = second, first end
  b.model:load { member = b.members[p.member], q = { a = q(first), b = q(second) }, axes = p.axes, history = p.history }
end
function declare.point(b, p)
  b.model:load { member = b.members[p.member], at = b.way.reverse and 1 - p.at or p.at, history = p.history,
    force = b.vector(p.force, b.unit.N), moment = p.moment and b.vector(p.moment, b.unit.Nm) }
end
function declare.gravity(b, p) b.model:gravity(b.vector(p.g, b.unit.m)) end
function declare.mass(b, p)
  b.model:mass { node = b.nodes[p.node], mass = p.mass * b.unit.kg, inertia = p.inertia * b.unit.kg * b.unit.m ^ 2,
    offset = p.offset and b.vector(p.offset, b.unit.m) }
end
function declare.line_mass(b, p)
  local per = b.unit.kg / b.unit.m
  local o = { member = b.members[p.member], from = p.from, to = p.to, per_length = { a = p.a * per, b = p.b * per } }
  if b.way.reverse then
    o.from, o.to, o.per_length = 1 - p.to, 1 - p.from, { a = p.b * per, b = p.a * per }
  end
  b.model:mass(o)
end
function declare.link(b, p)
  local n = b.s.nodes[p.from]
  local to = b.model:node(b.place(vectors.plus(n, 1, p.by)))
  b.model:rigid_link { from = b.nodes[p.from], to = to, dofs = p.dofs }
  -- a short member, so that the node has one
  local tip = b.model:node(b.place(vectors.plus(n, 2, p.by)))
  if p.dofs == "all" then b.model:load { node = tip, force = b.vector(p.force, b.unit.N) }
  else b.model:fix(tip) end -- a strut between the ball joint and a support
  b.model:member { to, tip, section = b.section(b.s.members[1].section), material = b.material, up = b.across(p.by) }
  b.extra[#b.extra + 1] = tip
end
function declare.diaphragm(b, p)
  local list = {}
  for i, n in ipairs(p.nodes) do list[i] = b.nodes[n] end
  b.model:diaphragm { nodes = list }
end
function declare.connector(b, p)
  local u = b.unit
  local function units(of, rate) -- per m, or N m a radian
    if not of then return nil end
    local out = {}
    for name, value in pairs(of) do out[name] = value * (#name == 1 and u.N / u.m or u.Nm) * (rate or 1) end
    return out
  end
  local curve
  if p.curve then
    curve = { z = {} }
    for i, q in ipairs(p.curve) do curve.z[i] = { q[1] * u.m, q[2] * u.N } end
  end
  local x = p.x
  b.connectors[#b.connectors + 1] = { at = p.node, x = x, y = b.across_of(x), handle = b.model:connector {
    b.nodes[p.node], ground = true, stiffness = units(p.k), damping = units(p.c), curve = curve,
    axes = { x = b.vector(x, 1), y = b.vector(b.across_of(x), 1) } } }
end
function declare.panel(b, p)
  local o, n = { along = b.vector({ 0.6, 0.5, 0.3 }, 1), thickness = p.thickness and p.thickness * b.unit.m }, #p.nodes
  for i, node in ipairs(p.nodes) do o[b.way.reverse and n + 1 - i or i] = b.nodes[node] end
  if p.thickness then
    o.material = p.stress and b.hinge.material(with(b.elastic, { yield_stress = p.stress * b.unit.Pa })) or b.material
  end
  if p.bars then
    o.reinforcement = { x = p.bars * b.unit.m, y = p.bars * b.unit.m / 2, E = b.elastic.E,
      yield_stress = p.stress and 2 * p.stress * b.unit.Pa }
  end
  b.panels[#b.panels + 1] = b.model:panel(o)
end
function declare.sway(b, p) b.model:imperfection { sway = p.value, direction = b.vector(p.direction, 1) } end
function declare.settle(b, p)
  local v = b.vector(p.by, b.unit.m)
  b.model:settle { node = b.nodes[p.node], x = v[1], y = v[2], z = v[3] }
end
function declare.move(b, p)
  local v, over, path = b.vector(p.by, b.unit.m), p.over or 0.02, {}
  for i, axis in ipairs { "x", "y", "z" } do path[axis] = { { 0, 0 }, { over, v[i] } } end
  path.node = b.nodes[p.node]
  b.model:move(path)
end
function declare.heat(b, p)
  b.model:heat { member = b.members[p.member], temperature = p.temperature, across_y = p.across }
end
function declare.prestress(b, p) b.model:prestress { member = b.members[p.member], strain = p.strain } end
function declare.damping(b, p)
  b.model:damping { alpha = p.alpha, beta = p.beta, ratio = p.ratio, periods = p.periods }
end
function declare.remove(b, p) b.model:remove { member = b.members[p.member], at = p.at, over = p.over } end
function declare.fracture(b, p)
  b.model:fracture { hinge_rotation_x = p.rotation, hinge_rotation_y = p.rotation, elongation = p.rotation * b.unit.m }
end
function declare.contact(b, p)
  b.model:contact { friction = p.friction, stiffness = p.stiffness and p.stiffness * b.unit.N / b.unit.m }
end
function declare.ground(b, p)
  local low = 0
  for i, n in ipairs(b.s.nodes) do if i == 1 or n[3] < low then low = n[3] end end
  local per = b.unit.N / b.unit.m ^ 3
  b.model:ground { point = b.place { 0, 0, low - p.depth - 0.3 }, normal = b.vector({ 0, 0, 1 }, 1),
    friction = p.friction, layer_stiffness = 1e8 * per, layer_damping = 2e6 * per }
end
function declare.velocity(b, p)
  local target = p.node and b.nodes[p.node] or p.member and b.members[p.member] or "all of it"
  b.model:velocity(target, b.vector(p.v, b.unit.m), b.vector(p.w, 1))
end

--- Some vector across v.
function built.across(v)
  return vectors.cross(v, math.abs(v[1]) < math.abs(v[3]) and { 1, 0, 0 } or { 0, 0, 1 })
end

--- The model of a scene. Fields: model, nodes, members (as in the scene), extra (nodes that parts add), connectors.
function built.make(hinge, s, way)
  local m, kg = 1 / way.length, 1 / way.mass
  local unit = { m = m, kg = kg, N = kg * m, Nm = kg * m * m, Pa = kg / m }
  local b = { s = s, way = way, unit = unit, model = hinge.model(with(s.options, way.options)), nodes = {},
    members = {}, extra = {}, connectors = {}, panels = {} }
  function b.vector(v, size)
    return vectors.times(size, turned(way.turn, v))
  end
  function b.place(p) return b.vector(p, m) end
  b.across_of = built.across
  function b.across(v) return b.vector(built.across(v), 1) end
  function b.section(of) return scenes.make_section(hinge, of, unit) end
  local of_members, law = member_options(hinge, s, unit, way)
  local material = { E = scenes.steel.E * unit.Pa * (way.stiffer or 1), nu = scenes.steel.nu,
    density = scenes.steel.density * kg / m ^ 3 }
  b.hinge, b.elastic, b.material = hinge, material, hinge.material(material)
  local full = hinge.material(with(material, law))
  if s.d then error "the scene is not complete" end

  local function each(list, act)
    local order = {}
    for i = 1, #list do order[i] = i end
    way.order(order)
    for _, i in ipairs(order) do act(i, list[i]) end
  end
  each(s.nodes, function(i, n)
    b.nodes[i] = b.model:node(b.place(n))
    if n.fixed then b.model:fix(b.nodes[i], n.fixed) end
  end)
  each(s.members, function(i, of)
    local o = of_members[i] or {}
    local one, other = b.nodes[of[1]], b.nodes[of[2]]
    if way.reverse then one, other = other, one end
    b.members[i] = b.model:member { one, other, section = o.section or b.section(of.section),
      material = o.section and b.material or full,
      up = b.vector(of.up, 1), group = "all of it", ends = o.ends and next(o.ends) and o.ends,
      release = o.release and next(o.release) and o.release or nil, carries = o.carries, backbone = o.backbone,
      law = o.law }
  end)
  local late = {}
  each(s.parts, function(_, part)
    local act = declare[part.kind]
    if part.kind == "sway" then late[#late + 1] = part -- it moves what was declared
    elseif act then act(b, part) end
  end)
  for _, part in ipairs(late) do declare[part.kind](b, part) end
  return b
end

--- What a run of b is: in SI units and in the scene's own axes. u: displacements and rotations of the nodes; f: of the
--- members' ends N, size of the bending moment, Mz and shear; r: reactions.
function built.answer(b, run)
  local R, u = b.way.turn, b.unit
  local out = { u = {}, rotation = {}, force = {}, moment = {}, reaction = {}, verdict = run.verdict,
    reason = run.reason or "", steps = run.index }
  for _, node in ipairs(b.nodes) do
    local x, y, z, rx, ry, rz = node:displacement(run)
    x, y, z = back(R, x, y, z)
    rx, ry, rz = back(R, rx, ry, rz)
    for _, v in ipairs { x, y, z } do out.u[#out.u + 1] = v / u.m end
    for _, v in ipairs { rx, ry, rz } do out.rotation[#out.rotation + 1] = v end
  end
  for i, member in ipairs(b.members) do
    local first, second = member:forces(run)
    if b.way.reverse then first, second = second, first end
    for _, f in ipairs { first, second } do
      out.force[#out.force + 1] = f.N / u.N
      out.force[#out.force + 1] = math.sqrt(f.Qx ^ 2 + f.Qy ^ 2) / u.N
      out.moment[#out.moment + 1] = math.sqrt(f.Mx ^ 2 + f.My ^ 2) / u.Nm
      out.moment[#out.moment + 1] = f.Mz / u.Nm
    end
    out.floor = 1e-6 * scenes.steel.E * member.section.area / u.m ^ 2
    out.size = out.size and out.size < b.s.members[i].length and out.size or b.s.members[i].length
  end
  for i, node in ipairs(b.nodes) do
    if b.s.nodes[i].fixed then
      local fx, fy, fz = back(R, node:reaction(run))
      for _, v in ipairs { fx, fy, fz } do out.reaction[#out.reaction + 1] = v / u.N end
    end
  end
  return out
end

built.back = back
return built

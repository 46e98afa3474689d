-- Random scenes: scene(seed) draws one. Its class, settings and structure are a function of the seed alone, because all
-- draws come from a generator of its own in integer arithmetic.
--
-- A scene: class, setting ("auto", "explicit", "fine dt", "coarse dt"), budget (element steps), words (a list that
-- describes it, complete after make), make(hinge, changed), which returns the model and the options of its dynamic run.
-- `changed` replaces options of the model (p_delta, interaction, elements_per_member, plasticity) and of the run (dt,
-- integrator, ...); part = 0.4 takes that part of the budget. To find causes: dt_times, a factor of its own step, auto
-- steps too; contact = "none", fracture = "none" or "hinges" (limits of rotation and elongation). ground = "points":
-- elastic points (restitution = 1) in place of the layer that is the default. For tests/hard/within.lua: ends, a
-- function of a member's nodes and options that returns its joints; plan, a function of what was made that returns the
-- options of the run in place of the scene's own.
local vectors = require "hinge.library.vectors"
local scenes = {}

local unit, cross = vectors.unit, vectors.cross
local g = 9.80665

-- Draws --------------------------------------------------------------------------------------------------------------

-- Generator xorshift64* (Vigna 2016). Its first state is the seed, mixed by splitmix64.
local function draws(seed, stream)
  local x = seed * 0x9E3779B97F4A7C15 + stream * 0x632BE59BD9B4E019
  x = (x ~ (x >> 30)) * 0xBF58476D1CE4E5B9
  x = (x ~ (x >> 27)) * 0x94D049BB133111EB
  x = x ~ (x >> 31)
  if x == 0 then x = 1 end
  local d = {}
  --- A number from a to b; default: 0 to 1.
  function d.number(a, b)
    x = x ~ (x >> 12)
    x = x ~ (x << 25)
    x = x ~ (x >> 27)
    local u = ((x * 0x2545F4914F6CDD1D) >> 11) * 2.0 ^ -53
    return a and a + (b - a) * u or u
  end
  --- A number from a to b whose logarithm is uniform.
  function d.log(a, b) return a * (b / a) ^ d.number() end
  function d.whole(a, b) return a + math.floor(d.number() * (b - a + 1)) end
  function d.chance(p) return d.number() < p end
  function d.pick(list) return list[d.whole(1, #list)] end
  --- One of { { weight, value }, ... }.
  function d.weighted(list)
    local all = 0
    for _, item in ipairs(list) do all = all + item[1] end
    local u = d.number(0, all)
    for _, item in ipairs(list) do
      u = u - item[1]
      if u < 0 then return item[2] end
    end
    return list[#list][2]
  end
  --- A direction in space, uniform.
  function d.direction()
    while true do
      local v = { d.number(-1, 1), d.number(-1, 1), d.number(-1, 1) }
      local direction, size = unit(v)
      if size > 0.1 and size < 1 then return direction end
    end
  end
  return d
end

scenes.draws = draws -- for tests/hard/relation_scenes.lua

-- Sections and materials ---------------------------------------------------------------------------------------------

-- Section of a shape whose smallest radius of gyration is about length / slenderness.
local function section(hinge, d, length, slenderness, shape)
  local r = length / slenderness
  shape = shape or d.pick { "box", "h", "h", "pipe", "solid", "round" }
  if shape == "box" then
    local b = r / 0.4
    return hinge.section.box { width = b, depth = b * d.number(1, 1.6), thickness = b / d.number(10, 35) }
  elseif shape == "h" then
    local b = r / 0.24
    local depth = b * d.number(1, 2.2)
    return hinge.section.h { width = b, depth = depth, web = b / d.number(15, 25), flange = b / d.number(10, 16) }
  elseif shape == "pipe" then
    local diameter = r / 0.34
    return hinge.section.pipe { diameter = diameter, thickness = diameter / d.number(12, 40) }
  elseif shape == "solid" then
    local b = r / 0.2887
    return hinge.section.solid { width = b, depth = b * d.number(1, 1.5) }
  end
  return hinge.section.round { diameter = 4 * r }
end

local function slenderness(d) return d.chance(0.55) and d.log(15, 100) or d.log(100, 300) end

-- Numbers of a material: E, density, yield stress.
local function material_of(d)
  if d.chance(0.1) then return { E = 70.6e9, nu = 0.33, density = 2790, yield_stress = 275e6 } end
  return { E = 206e9, nu = 0.3, density = 7850, yield_stress = d.weighted { { 1, false }, { 2, 235e6 }, { 2, 295e6 },
    { 2, 325e6 }, { 2, 355e6 }, { 1, 440e6 } } or nil }
end

local function yield_of(numbers) return numbers.yield_stress and numbers.yield_stress / 1e6 or "none" end

local function with(base, changes)
  local o = {}
  for _, from in ipairs { base, changes or {} } do
    for k, v in pairs(from) do o[k] = v end
  end
  return o
end

-- Length over the smaller radius of gyration.
local function slenderness_of(of, length) return length / math.sqrt(math.min(of.Ix, of.Iy) / of.area) end

-- Scenes in the making -----------------------------------------------------------------------------------------------

-- What is made of one seed: s.d draws, s.model, s.words, s.elements (their number), s.wave (shortest time of an axial
-- wave in an element, s), and the members and joints by purpose.
local function note(s, text, ...) s.words[#s.words + 1] = select("#", ...) > 0 and text:format(...) or text end

-- A member; keeps count of elements and of the shortest wave time.
local function member(s, a, b, o)
  local m = s.model:member { a, b, section = o.section, material = o.material, group = o.group, up = o.up,
    ends = s.changed.ends and s.changed.ends(a, b, o) }
  local count = s.per_member
  s.elements = s.elements + count
  local wave = m.length / count / math.sqrt(o.material.E / o.material.density)
  if not (s.wave and s.wave <= wave) then s.wave = wave end
  return m
end

local function upright(a, b)
  return math.abs(a.x - b.x) < 1e-6 and math.abs(a.y - b.y) < 1e-6 and { 1, 0, 0 } or nil
end

-- Smaller of squash load and Euler's load of a pinned member, N.
local function strength(m, yield_stress)
  local i = math.min(m.section.Ix, m.section.Iy)
  return math.min(m.section.area * (yield_stress or 300e6), math.pi ^ 2 * m.material.E * i / m.length ^ 2)
end

-- Floors that load the columns by at most a part of their strength, and the beams by a part of their plastic load.
-- Returns the load per length of a beam, N/m.
local function floor_load(s, beam, column, span, storeys, lines, yield_stress)
  local part = s.d.log(0.03, 0.35)
  local mp = beam.section.Zx * (yield_stress or 300e6)
  local by_beam = part * 16 * mp / span ^ 2
  local by_column = 0.5 * part * strength(column, yield_stress) / (span * storeys * lines)
  return math.min(by_beam, by_column)
end

-- A frame on fixed or pinned feet: columns, beams and floors. o: plane, smallest and largest number of members.
local function frame(s, o)
  local d, hinge = s.d, s.hinge
  local bays, across, storeys, count
  repeat
    bays, storeys, across = d.whole(1, 6), d.whole(1, 6), o.plane and 0 or d.whole(1, 3)
    count = storeys * ((bays + 1) * (across + 1) + bays * (across + 1) + across * (bays + 1))
  until count >= o.least and count <= o.most
  local bay, height = d.number(2.5, 9), d.number(2.6, 5.5)
  local numbers = material_of(d)
  local fy = numbers.yield_stress
  local steel = hinge.material(numbers)
  local column_section = section(hinge, d, height, slenderness(d))
  local beam_section = section(hinge, d, bay, d.log(30, 180), d.pick { "h", "h", "box", "solid" })
  note(s, "%s frame %d x %d x %d, column %s L/r %.0f, beam %s L/r %.0f, fy %s", o.plane and "plane" or "space", bays,
    across, storeys, column_section.kind,
    slenderness_of(column_section, height), beam_section.kind, slenderness_of(beam_section, bay), yield_of(numbers))

  -- The floors' weight is known before the members that carry it as density: trial members of a model that is dropped.
  local trial = hinge.model {}
  local beam = trial:member { trial:node { 0, 0, 0 }, trial:node { bay, 0, 0 }, section = beam_section,
    material = steel }
  local column = trial:member { trial:node { 0, 0, 0 }, trial:node { 0, 0, height }, section = column_section,
    material = steel, up = { 1, 0, 0 } }
  local q = floor_load(s, beam, column, bay, storeys, o.plane and 1 or 2, fy)
  trial:close()
  local floors = o.gravity and d.weighted { { 4, "density" }, { 3, "load" }, { 3, "mass" }, { 1, "none" } } or "none"
  local floor_steel = steel
  if floors == "density" then
    floor_steel = hinge.material(with(numbers, { density = numbers.density + q / g / beam_section.area }))
  end
  if floors ~= "none" then note(s, "floors as %s %.3g N/m", floors, q) end

  local of_beam = { section = beam_section, material = floor_steel, group = { "beams", "frame" } }
  local model, joints, columns, beams = s.model, {}, {}, {}
  local imperfect = d.chance(0.3) and height / d.number(200, 1000) or 0
  for k = 0, storeys do
    joints[k] = {}
    for i = 0, bays do
      joints[k][i] = {}
      for j = 0, across do
        local lean = k * imperfect
        local node = model:node { bay * i + lean, bay * j, height * k }
        joints[k][i][j] = node
        s.joints[#s.joints + 1] = node
        if k == 0 then
          s.feet[#s.feet + 1] = node
        else
          if o.plane then model:fix(node, "y,rx,rz") end
          local name = ("column %d"):format(#columns + 1)
          columns[#columns + 1] = member(s, joints[k - 1][i][j], node, { section = column_section, material = steel,
            up = { 1, 0, 0 }, group = { name, "columns", "frame" } })
          s.names[columns[#columns]] = name
        end
      end
    end
    for i = 0, bays do
      for j = 0, across do
        if k > 0 and i > 0 then
          beams[#beams + 1] = member(s, joints[k][i - 1][j], joints[k][i][j], of_beam)
        end
        if k > 0 and j > 0 then
          beams[#beams + 1] = member(s, joints[k][i][j - 1], joints[k][i][j], of_beam)
        end
      end
    end
  end
  local pinned = d.chance(0.15)
  model:fix(s.feet, pinned and (o.plane and "xyz,rx,rz" or "xyz,rz") or "all")
  if pinned then note(s, "pinned feet") end
  if floors == "load" then model:load { group = "beams", q = { 0, 0, -q } } end
  if floors == "mass" then
    for k = 1, storeys do
      for i = 0, bays do
        for j = 0, across do model:mass { node = joints[k][i][j], mass = q * bay / g } end
      end
    end
  end
  s.columns = columns
  s.members = table.move(beams, 1, #beams, #columns + 1, table.move(columns, 1, #columns, 1, {}))
end

-- A lattice tower of four legs with horizontals and diagonals.
local function tower(s, o)
  local d, hinge, model = s.d, s.hinge, s.model
  local panels, side, height = d.whole(o.least or 2, o.most or 7), d.number(0.8, 4), d.number(0.8, 4)
  local taper = d.chance(0.5) and d.number(0.4, 0.95) or 1
  local numbers = material_of(d)
  local steel = hinge.material(numbers)
  local leg, brace = section(hinge, d, height, slenderness(d)), section(hinge, d, side * 1.2, slenderness(d))
  local both = d.chance(0.4)
  note(s, "tower of %d panels %.1f x %.1f m, leg %s L/r %.0f, braces %s L/r %.0f%s", panels, side, height, leg.kind,
    slenderness_of(leg, height), brace.kind, slenderness_of(brace, 1.2 * side), both and ", crossed" or "")
  local of_brace = { section = brace, material = steel, group = { "beams", "frame" } }
  local corners, legs, braces, before = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } }, {}, {}, nil
  for k = 0, panels do
    local half = side / 2 * (1 - (1 - taper) * k / panels)
    local ring = {}
    for c, corner in ipairs(corners) do
      ring[c] = model:node { half * corner[1], half * corner[2], height * k }
      s.joints[#s.joints + 1] = ring[c]
      if k == 0 then s.feet[#s.feet + 1] = ring[c] end
    end
    for c = 1, k > 0 and 4 or 0 do
      local name = ("column %d"):format(#legs + 1)
      legs[#legs + 1] = member(s, before[c], ring[c], { section = leg, material = steel, up = { 1, 0, 0.01 },
        group = { name, "columns", "frame" } })
      s.names[legs[#legs]] = name
      local next = c % 4 + 1
      braces[#braces + 1] = member(s, ring[c], ring[next], of_brace)
      braces[#braces + 1] = member(s, before[c], ring[next], of_brace)
      if both then
        braces[#braces + 1] = member(s, before[next], ring[c], of_brace)
      end
    end
    before = ring
  end
  model:fix(s.feet)
  if o.gravity then -- a tank or an antenna at the top
    local part = d.log(0.03, 0.35)
    local mass = part * strength(legs[1], numbers.yield_stress) / g
    note(s, "%.3g t at the top", 4 * mass / 1000)
    for c = 1, 4 do model:mass { node = before[c], mass = mass } end
  end
  s.columns = legs
  s.members = table.move(braces, 1, #braces, #legs + 1, table.move(legs, 1, #legs, 1, {}))
end

-- A truss girder between two supports, plane or of two planes side by side.
local function truss(s, o)
  local d, hinge, model = s.d, s.hinge, s.model
  local panels, length, depth = d.whole(3, 9), d.number(1, 4), d.number(0.8, 4)
  local planes, width = d.whole(1, 2), d.number(1, 4)
  local numbers = material_of(d)
  local steel = hinge.material(numbers)
  local chord, web = section(hinge, d, length, slenderness(d)), section(hinge, d, depth, slenderness(d))
  note(s, "truss of %d panels in %d planes, chord %s L/r %.0f, web %s L/r %.0f", panels, planes, chord.kind,
    slenderness_of(chord, length), web.kind, slenderness_of(web, depth))
  local chords, webs, rows = {}, {}, {}
  local function add(list, a, b, of)
    local name = ("column %d"):format(#s.members + 1)
    list[#list + 1] = member(s, a, b, { section = of, material = steel, up = upright(a, b),
      group = { name, list == chords and "columns" or "beams", "frame" } })
    s.members[#s.members + 1] = list[#list]
    s.names[list[#list]] = name
  end
  for p = 1, planes do
    local low, high = {}, {}
    for i = 0, panels do
      low[i] = model:node { length * i, width * (p - 1), 5 }
      high[i] = model:node { length * i, width * (p - 1), 5 + depth }
      table.move({ low[i], high[i] }, 1, 2, #s.joints + 1, s.joints)
      if planes == 1 then model:fix({ low[i], high[i] }, "y,rx,rz") end
      add(webs, low[i], high[i], web)
      if i > 0 then
        add(chords, low[i - 1], low[i], chord)
        add(chords, high[i - 1], high[i], chord)
        add(webs, i <= panels / 2 and high[i - 1] or low[i - 1], i <= panels / 2 and low[i] or high[i], web)
      end
    end
    rows[p] = { low = low, high = high }
    s.feet[#s.feet + 1], s.feet[#s.feet + 2] = low[0], low[panels]
    model:fix(low[0], "xyz")
    model:fix(low[panels], "yz")
  end
  for i = 0, planes == 2 and panels or -1 do
    add(webs, rows[1].low[i], rows[2].low[i], web)
    add(webs, rows[1].high[i], rows[2].high[i], web)
    if i > 0 then
      add(webs, rows[1].high[i - 1], rows[2].high[i], web)
      add(webs, rows[1].low[i - 1], rows[2].low[i], web)
    end
  end
  if o.gravity then
    local part = d.log(0.03, 0.3)
    local least = math.min(strength(chords[1], numbers.yield_stress), strength(webs[1], numbers.yield_stress))
    local each = part * least * depth / length / panels * 2 / panels
    local as_load = d.chance(0.4)
    note(s, "%.3g N a joint as %s", each, as_load and "load" or "mass")
    for _, row in ipairs(rows) do
      for i = 1, panels - 1 do
        if as_load then model:load { node = row.low[i], force = { 0, 0, -each } }
        else model:mass { node = row.low[i], mass = each / g } end
      end
    end
  end
  s.columns = chords
end

-- What acts on them --------------------------------------------------------------------------------------------------

local function fracture(s, group)
  local d = s.d
  local kind = d.weighted { { 4, "strain" }, { 3, "limits" }, { 3, "work" }, { 2, "rotation" }, { 1, "all" } }
  local rule = { group = group }
  if kind == "limits" then
    rule.curvature_x, rule.curvature_y, rule.axial_strain = d.log(0.02, 0.4), d.log(0.02, 0.4), d.log(0.01, 0.3)
    if d.chance(0.3) then rule.strain_measure = "section" end
  elseif kind == "strain" then
    rule.axial_strain, rule.tension_only = d.log(0.005, 0.2), d.chance(0.5)
    if d.chance(0.3) then rule.plastic_only = true end
  elseif kind == "work" then
    local joules = d.log(50, 5e4)
    function rule.rule(section_now) return section_now.plastic_work > joules end
  elseif kind == "rotation" then
    local most = d.log(0.01, 0.2)
    rule.keep = { "damage" }
    function rule.rule(now)
      local damage = math.sqrt(now.hinge_rotation_x ^ 2 + now.hinge_rotation_y ^ 2) / most
      if not (damage <= now.damage) then now.damage = damage end
      return now.damage >= 1
    end
  else
    local most = d.log(0.005, 0.1)
    rule.where = "all"
    function rule.rule(now) return math.abs(now.axial_strain) > most end
  end
  if s.changed.fracture == "hinges" then -- limits of sections in place of what was drawn: 0.01 to 0.2 rad and m
    kind = "hinges"
    local most = 0.01 * 20 ^ (s.seed * 0.6180339887 % 1)
    rule = { group = group, hinge_rotation_x = most, hinge_rotation_y = most, elongation = most }
  end
  note(s, "fracture by %s", kind)
  if s.changed.fracture ~= "none" then s.model:fracture(rule) end
end

-- A contact rule that is drawn; between: two groups, or nil.
local function contact(s, between)
  local d = s.d
  local rule = { rule = d.chance(0.4) and "gap" or "surface", between = between }
  if rule.rule == "surface" and d.chance(0.5) then rule.friction = d.number(0.1, 0.6) end
  note(s, "contact %s%s", rule.rule, rule.friction and (" friction %.2f"):format(rule.friction) or "")
  if rule.rule == "surface" and not rule.friction and d.chance(0.5) then rule.rule = nil end -- as a user writes it
  s.contact = rule.rule or "surface"
  if s.changed.contact ~= "none" then s.model:contact(rule) end
end

local function damping(s)
  local d = s.d
  if not d.chance(0.35) then return end
  local t = d.number(0.2, 2)
  if d.chance(0.5) then
    local ratio = d.number(0.005, 0.05)
    s.model:damping { ratio = ratio, periods = { t, t / 10 } }
    note(s, "damping %.1f %% at %.2g s", 100 * ratio, t)
  else
    s.model:damping { alpha = d.number(0.05, 1) }
    note(s, "damping alpha")
  end
end

-- Connectors and point masses that a user may add to a structure.
local function extras(s)
  local d, model = s.d, s.model
  if d.chance(0.15) and #s.members > 3 then
    local m = d.pick(s.members)
    local c = d.pick(s.members)
    local k = m.material.E * m.section.area / m.length
    local o = { m.b, c.a, stiffness = { x = k * d.log(1e-3, 1), z = k * d.log(1e-3, 1) } }
    if d.chance(0.5) then o.damping = { x = d.log(1e2, 1e5) } end
    if d.chance(0.4) then o.capacity = { x = d.log(1e3, 1e6) } end
    if m.b ~= c.a then
      note(s, "connector%s%s", o.damping and " with dashpot" or "", o.capacity and " with capacity" or "")
      model:connector(o)
    end
  end
  if d.chance(0.2) then
    local count = d.whole(1, 4)
    for _ = 1, count do
      local m = d.pick(s.members)
      local o = { node = m.b, mass = m.mass * d.log(0.1, 20) }
      if d.chance(0.5) then o.inertia = o.mass * d.number(0.001, 0.1) end
      if d.chance(0.3) then o.offset = { d.number(-0.3, 0.3), 0, d.number(-0.3, 0.3) } end
      model:mass(o)
    end
    note(s, "%d point masses", count)
  end
end

-- A bar that flies at a member: close to it, with a speed. Across the member, or end on.
local function striker(s, target, o)
  local d, hinge, model = s.d, s.hinge, s.model
  local axis = unit(vectors.minus(vectors.of_node(target.b), vectors.of_node(target.a)))
  local towards = o.towards
  if not towards then -- any direction more or less across the member
    local v = d.direction()
    towards = unit(vectors.plus(v, -0.9 * vectors.dot(v, axis), axis))
  end
  local speed = o.speed or d.log(1, 300)
  local at, length = d.number(0.1, 0.9), d.number(0.8, 4)
  local across = cross(axis, towards)
  if vectors.length(across) < 0.1 then across = cross({ 0.6, 0.8, 0 }, towards) end
  across = unit(across)
  local end_on = d.chance(0.35)
  local direction = end_on and towards or across
  local numbers = { E = 206e9, nu = 0.3, yield_stress = d.chance(0.5) and 295e6 or nil,
    density = 7850 * (d.chance(0.5) and 1 or d.log(1, 20)) }
  local of = section(hinge, d, length, d.log(15, 120), d.pick { "pipe", "box", "solid" })
  local radius = (math.min(of.width, of.depth) + math.min(target.section.width, target.section.depth)) / 2
  local back = radius * 1.02 + math.min(0.05, speed * 1e-4) + (end_on and length or 0)
  local half = end_on and 0 or length * d.number(0.3, 0.7)
  local p = {}
  for c, x in ipairs { "x", "y", "z" } do
    p[c] = target.a[x] + at * (target.b[x] - target.a[x]) - towards[c] * back - direction[c] * half
  end
  local a = model:node(p)
  local b = model:node(vectors.plus(p, length, direction))
  local up = math.abs(direction[3]) > 0.9 and { 1, 0, 0 } or nil
  local m = member(s, a, b, { section = of, material = hinge.material(numbers), up = up, group = "bar" })
  model:velocity("bar", { speed * towards[1], speed * towards[2], speed * towards[3] })
  note(s, "bar of %.3g kg at %.3g m/s %s", m.mass, speed, end_on and "end on" or "across")
  s.speed = speed
end

local function ground(s, plane)
  if s.changed.ground == "points" and not plane.restitution then plane.restitution = 1 end
  s.model:ground(plane)
end

-- A record of ground acceleration: sines of falling strength and noise, m/s^2.
local function record(s, duration)
  local d = s.d
  local dt, strength_now, a = d.pick { 0.005, 0.01, 0.02 }, d.log(0.5, 15), {}
  local w, phase = {}, {}
  for i = 1, 4 do w[i], phase[i] = 2 * math.pi * d.log(0.4, 12), d.number(0, 6.28) end
  for i = 0, math.ceil(duration / dt) do
    local t, sum = i * dt, d.number(-0.3, 0.3)
    for k = 1, 4 do sum = sum + math.sin(w[k] * t + phase[k]) / 2 end
    a[i + 1] = i == 0 and 0 or strength_now * sum
  end
  note(s, "shaken by %.2g m/s^2", strength_now)
  return s.hinge.ground { dt = dt, acceleration = a }
end

-- Rest under gravity; a run to begin from, or nil.
local function at_rest(s, chance)
  s.model:gravity { 0, 0, -g }
  if s.d.chance(chance or 0.8) then
    note(s, "from rest")
    s.rest = s.d.pick { {}, { steps = 4 }, { steps = 2 } }
  else
    note(s, "gravity at once")
  end
end

-- Classes ------------------------------------------------------------------------------------------------------------

local make = {}

make["struck frame"] = function(s)
  local d = s.d
  s.gravity = d.chance(0.4)
  frame(s, { plane = d.chance(0.5), least = 20, most = 100, gravity = s.gravity })
  extras(s)
  damping(s)
  local target = d.pick(s.members)
  striker(s, target, {})
  if d.chance(0.45) then fracture(s, "frame") end
  contact(s, d.chance(0.5) and { "bar", "frame" } or nil)
  if s.gravity then at_rest(s) s.held = "bar" end
  s.wanted = d.log(0.02, 0.3)
end

make["lost column"] = function(s)
  local d = s.d
  local plane = d.chance(0.6)
  frame(s, { plane = plane, least = 3, most = d.chance(0.5) and 30 or 100, gravity = true })
  extras(s)
  damping(s)
  if d.chance(0.5) then fracture(s, "frame") end
  if d.chance(0.25) then contact(s) end
  if d.chance(0.2) then
    ground(s, { friction = d.number(0, 0.6), point = { 0, 0, -1e-3 } })
    note(s, "ground")
  end
  at_rest(s, 0.9)
  local lost, when = {}, d.chance(0.5) and 0 or d.number(0, 0.05)
  for i = 1, d.whole(1, math.max(1, math.min(3, #s.columns // 3))) do
    lost[i] = d.pick(s.columns)
    s.later[#s.later + 1] = { group = s.names[lost[i]], where = "all", rule = function(now) return now.time > when end }
  end
  note(s, "loses %d columns", #lost)
  s.wanted = d.log(0.1, 1.5)
end

make["shaken frame"] = function(s)
  local d = s.d
  frame(s, { plane = d.chance(0.6), least = 3, most = d.chance(0.6) and 30 or 80, gravity = true })
  extras(s)
  damping(s)
  if d.chance(0.4) then fracture(s, "frame") end
  s.wanted = d.log(0.3, 4)
  local path = record(s, s.wanted)
  s.model:move { node = s.feet, x = path, z = d.chance(0.3) and record(s, s.wanted) or nil }
  at_rest(s)
end

make.tower = function(s)
  local d = s.d
  s.gravity = d.chance(0.8)
  tower(s, { gravity = s.gravity })
  extras(s)
  damping(s)
  if d.chance(0.5) then fracture(s, "frame") end
  local what = d.pick { "leg", "struck", "shaken" }
  if what == "struck" then
    striker(s, d.pick(s.members), {})
    contact(s, d.chance(0.6) and { "bar", "frame" } or nil)
    s.wanted, s.held = d.log(0.02, 0.3), "bar"
  elseif what == "shaken" then
    s.wanted = d.log(0.2, 3)
    s.model:move { node = s.feet, x = record(s, s.wanted) }
  else
    s.later[1] = { group = s.names[d.pick(s.columns)], where = "all", rule = function() return true end }
    note(s, "loses a leg")
    if d.chance(0.3) then contact(s) end
    s.wanted = d.log(0.1, 1.5)
  end
  if s.gravity then at_rest(s) end
end

make.truss = function(s)
  local d = s.d
  s.gravity = d.chance(0.75)
  truss(s, { gravity = s.gravity })
  extras(s)
  damping(s)
  if d.chance(0.5) then fracture(s, "frame") end
  if d.chance(0.5) then
    striker(s, d.pick(s.members), {})
    contact(s, d.chance(0.6) and { "bar", "frame" } or nil)
    s.wanted, s.held = d.log(0.02, 0.3), "bar"
  else
    s.later[1] = { group = s.names[d.pick(s.members)], where = "all", rule = function() return true end }
    note(s, "loses a member")
    if d.chance(0.2) then contact(s) end
    s.wanted = d.log(0.1, 1.5)
    s.gravity = true
  end
  if s.gravity then at_rest(s) end
end

-- Single columns and portals of a few members that a heavy body presses, as the issue's own one.
make["pressed column"] = function(s)
  local d, hinge, model = s.d, s.hinge, s.model
  local numbers = material_of(d)
  local steel = hinge.material(numbers)
  local count, length = d.whole(1, 4), d.number(2, 8)
  local of = section(hinge, d, length, slenderness(d))
  local before = model:node { 0, 0, 0 }
  s.feet[1] = before
  local support = d.pick { "all", "xyz,rz" }
  model:fix(before, support)
  for i = 1, count do
    local lean = d.number(-0.01, 0.01) * length
    local next = model:node { lean, d.number(-0.01, 0.01) * length, length * i }
    s.members[i] = member(s, before, next, { section = of, material = steel, up = { 1, 0, 0 },
      group = { "frame", "column " .. i } })
    s.joints[i] = next
    before = next
  end
  if d.chance(0.5) then model:fix(before, d.pick { "x,y", "x,y,rx,ry,rz", "y" }) end
  local speed, mass = d.log(0.5, 30), s.members[1].mass * d.log(1, 100)
  note(s, "%d columns of %s L/r %.0f, fy %s, foot %s, head %s; %.3g kg on it at %.3g m/s", count, of.kind,
    slenderness_of(of, length), yield_of(numbers), support, before.fixed or "free", mass, speed)
  model:mass { node = before, mass = mass, inertia = d.chance(0.3) and mass * 0.01 or nil }
  local turn = d.chance(0.6) and { d.number(-1, 1), d.number(-1, 1), 0 } or { 0, 0, 0 }
  model:velocity(before, { d.number(-0.1, 0.1) * speed, 0, -speed }, turn)
  s.speed = speed
  if d.chance(0.3) then fracture(s, "frame") end
  damping(s)
  if d.chance(0.5) then at_rest(s, 0) end
  if d.chance(0.15) then contact(s) end
  s.wanted = d.log(0.05, 0.6)
end

-- Bars that fall into a bin of fixed rails, or on ground between rails.
make.bin = function(s)
  local d, hinge, model = s.d, s.hinge, s.model
  local numbers = material_of(d)
  local steel = hinge.material(numbers)
  local on_ground = d.chance(0.4)
  local half, side = d.number(0.4, 1), 0.05
  local rail = hinge.section.solid { width = side, depth = side }
  local function fixed(a, b)
    local from, to = model:node(a), model:node(b)
    model:fix({ from, to })
    member(s, from, to, { section = rail, material = hinge.material { E = 206e9, density = 7850 }, group = "bin" })
  end
  for i = -2, on_ground and -3 or 2 do fixed({ -half, i * half / 2, 0 }, { half, i * half / 2, 0 }) end
  for k = 1, 2 do
    for _, y in ipairs { -half, half } do
      fixed({ -half, y, 0.25 * k }, { half, y, 0.25 * k })
      fixed({ y, -half, 0.25 * k }, { y, half, 0.25 * k })
    end
  end
  if on_ground then
    ground(s, { point = { 0, 0, -0.05 }, friction = d.number(0, 0.6),
      restitution = d.chance(0.5) and d.number(0, 0.9) or nil })
  end
  local bars = d.whole(3, 16)
  local bar_side = d.number(0.02, 0.08)
  for i = 1, bars do
    local length, z = half * d.number(0.6, 1.5), 0.1 + 0.02 + 0.17 * i
    local turn, tilt = d.number(0, math.pi), d.number(-0.03, 0.03)
    local x, y = length / 2 * math.cos(turn), length / 2 * math.sin(turn)
    local cx, cy = d.number(-0.2, 0.2) * half, d.number(-0.2, 0.2) * half
    local of = d.chance(0.7) and hinge.section.solid { width = bar_side, depth = bar_side }
      or hinge.section.pipe { diameter = bar_side, thickness = bar_side / 12 }
    s.members[i] = member(s, model:node { cx - x, cy - y, z - tilt }, model:node { cx + x, cy + y, z + tilt },
      { section = of, material = steel, group = { "frame", "bar " .. i } })
  end
  local speed = d.log(0.5, 30)
  model:velocity("frame", { d.number(-0.2, 0.2) * speed, d.number(-0.2, 0.2) * speed, -speed })
  s.speed = speed
  note(s, "%d bars fall into a bin%s at %.3g m/s", bars, on_ground and " on ground" or "", speed)
  if d.chance(0.3) then fracture(s, "frame") end
  damping(s)
  contact(s)
  at_rest(s, 0)
  s.wanted = d.log(0.05, 0.4)
end

-- A frame, a truss or a bar that falls on the ground.
make.fall = function(s)
  local d, hinge, model = s.d, s.hinge, s.model
  local what = d.weighted { { 3, "bar" }, { 3, "frame" }, { 2, "tower" } }
  local numbers = material_of(d)
  local steel = hinge.material(numbers)
  local size, low = d.number(1, 4), math.huge
  local axis, turned = d.direction(), d.number(0, 3.1)
  local x1, x2, x3 = axis[1], axis[2], axis[3]
  local cos, sin = math.cos(turned), math.sin(turned)
  local flat = d.chance(0.3)
  -- Rodrigues' rotation of every joint; the body then stands just above the ground.
  local function rotated(p)
    if flat then return p end
    local dot = (x1 * p[1] + x2 * p[2] + x3 * p[3]) * (1 - cos)
    local c = cross(axis, p)
    local out = {}
    for i = 1, 3 do out[i] = p[i] * cos + c[i] * sin + axis[i] * dot end
    return out
  end
  local of = section(hinge, d, size, slenderness(d))
  local points, pairs_of = {}, {}
  if what == "bar" then
    local count = d.whole(1, 3)
    for i = 0, count do points[i + 1] = { size * i, 0, flat and 0 or 0.3 * i * (i % 2) } end
    for i = 1, count do pairs_of[i] = { i, i + 1 } end
  else
    local floors = what == "frame" and d.whole(1, 2) or d.whole(2, 4)
    for k = 0, floors do
      for c, at in ipairs { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } do
        points[#points + 1] = { size * at[1], size * at[2], size * k }
        if k > 0 then
          local now, under = 4 * k + c, 4 * (k - 1) + c
          pairs_of[#pairs_of + 1] = { under, now }
          pairs_of[#pairs_of + 1] = { now, 4 * k + c % 4 + 1 }
          if what == "tower" then pairs_of[#pairs_of + 1] = { under, 4 * k + c % 4 + 1 } end
        end
      end
    end
  end
  local radius = math.min(of.width, of.depth) / 2
  for i, p in ipairs(points) do
    points[i] = rotated(p)
    if not (points[i][3] >= low) then low = points[i][3] end
  end
  for i, p in ipairs(points) do points[i] = model:node { p[1], p[2], p[3] - low + radius * 1.02 + 0.005 } end
  for i, pair in ipairs(pairs_of) do
    local a, b = points[pair[1]], points[pair[2]]
    s.members[i] = member(s, a, b, { section = of, material = steel, group = { "frame", "column " .. i },
      up = upright(a, b) })
  end
  local speed = d.log(0.5, 40)
  model:velocity("frame", { d.number(-0.3, 0.3) * speed, d.number(-0.3, 0.3) * speed, -speed },
    d.chance(0.5) and { d.number(-2, 2), d.number(-2, 2), d.number(-2, 2) } or { 0, 0, 0 })
  local plane = { friction = d.chance(0.7) and d.number(0, 0.7) or nil,
    restitution = d.chance(0.5) and d.pick { 0, 0.2, 0.5, 0.9, 1 } or nil }
  ground(s, plane)
  note(s, "%s of %d members of %s L/r %.0f, fy %s, falls%s at %.3g m/s; friction %s, restitution %s", what, #pairs_of,
    of.kind, slenderness_of(of, size), yield_of(numbers), flat and " flat" or "", speed,
    plane.friction and ("%.2f"):format(plane.friction) or "none", plane.restitution or "none")
  s.speed = speed
  if d.chance(0.5) then fracture(s, "frame") end
  if d.chance(0.4) then contact(s) end
  extras(s)
  damping(s)
  at_rest(s, 0)
  s.wanted = d.log(0.05, 0.6)
end

-- The issue's table: frames hit by a bar, nothing else.
make["hit frame"] = function(s)
  local d = s.d
  frame(s, { plane = d.chance(0.5), least = 20, most = 100, gravity = false })
  striker(s, d.pick(s.members), { speed = d.log(5, 150) })
  s.model:contact {}
  s.wanted = 0.04
end

-- The issue's one member: 20 t at 2 m/s along its axis, while its ends turn about the weak axis.
make["struck column"] = function(s)
  local hinge, model = s.hinge, s.model
  local of = hinge.section.h { depth = 0.25, width = 0.125, web = 0.006, flange = 0.009 }
  local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = 325e6 }
  local a, b = model:node { 0, 0, 0 }, model:node { 0, 0, 5.8 }
  s.members[1] = member(s, a, b, { section = of, material = steel, up = { 1, 0, 0 }, group = "frame" })
  -- The web lies along x, so the weak axis is x, and the column bends out along y.
  model:fix(a, "x,y,z,ry,rz")
  model:fix(b, "x,y,ry,rz")
  model:mass { node = a, mass = 1, inertia = 1e4 } -- keeps the end turning
  model:mass { node = b, mass = 20e3, inertia = 1e4 }
  model:velocity(a, { 0, 0, 0 }, { 0.5, 0, 0 })
  model:velocity(b, { 0, 0, -2 }, { -0.5, 0, 0 })
  note(s, "H 250 x 125 of 5.8 m, 20 t at 2 m/s along its axis, ends turn by 0.5 rad/s")
  s.wanted = 0.3
end

make.floors = function(s)
  require "random_floors"(s, { member = member, note = note, damping = damping, fracture = fracture, contact = contact,
    ground = ground, at_rest = at_rest, section = section, material_of = material_of })
end

local weights = { { 20, "struck frame" }, { 20, "lost column" }, { 12, "shaken frame" }, { 11, "tower" },
  { 9, "truss" }, { 9, "pressed column" }, { 8, "bin" }, { 11, "fall" } }

-- Steps of plain numbers that users write, s: for short strokes and for collapse.
local fine, coarse = { 2e-6, 5e-6, 1e-5, 2e-5 }, { 5e-5, 1e-4, 2e-4, 5e-4, 1e-3 }

local of_model = { p_delta = true, interaction = true, elements_per_member = true, plasticity = true }
local not_of_run = { part = true, dt_times = true, contact = true, fracture = true, ground = true }

--- The scene of a seed. class: that class in place of the drawn one.
function scenes.scene(seed, class)
  local d = draws(seed, 1)
  local drawn = d.weighted(weights)
  local scene = { seed = seed, class = class or drawn, words = {} }
  scene.setting = d.weighted { { 40, "auto" }, { 20, "explicit" }, { 20, "fine dt" }, { 20, "coarse dt" } }
  local run = {}
  if scene.setting == "auto" or scene.setting == "explicit" then run.dt = "auto" end
  if scene.setting == "explicit" then run.integrator = "explicit" end
  if scene.setting == "fine dt" then run.dt = d.pick(fine) end
  if scene.setting == "coarse dt" then
    run.dt = d.pick(coarse)
    -- An impact at 100 m/s in steps of 1 ms is no step that anybody chooses.
    scene.slow_only = true
  end
  if type(run.dt) == "number" then d.chance(0.1) end -- nothing uses this draw any more; without it all seeds change
  local elements = d.weighted { { 80, false }, { 12, 4 }, { 8, "auto" } } or nil
  local budget = d.log(6e4, 6e5) -- element steps
  if class == "hit frame" or class == "struck column" then
    scene.setting, run, elements, scene.slow_only = "fine dt", { dt = 2e-5 }, nil, nil
    budget = math.huge
  end
  if class == "floors" then elements = seed % 4 == 0 and 4 or 2 end -- a slab asks for a number
  scene.budget = budget

  function scene.make(hinge, changed)
    changed = changed or {}
    local options = { elements_per_member = elements }
    for name in pairs(of_model) do if changed[name] ~= nil then options[name] = changed[name] end end
    local s = { hinge = hinge, seed = seed, d = draws(seed, 2), model = hinge.model(options), words = scene.words,
      elements = 0,
      per_member = math.tointeger(options.elements_per_member) or 2,
      joints = {}, feet = {}, members = {}, names = {}, later = {}, speed = 1, changed = changed }
    note(s, "elements %s", options.elements_per_member or "default")
    make[scene.class](s)
    local more = with(run)
    if scene.slow_only then -- a step in which nothing flies farther than 2 cm
      while more.dt > 1e-5 and s.speed * more.dt > 0.02 do more.dt = more.dt / 2 end
    end
    if s.rest then
      local rest = s.model:static(with({ record = false, fixed_group = s.held }, s.rest)):finish()
      if rest.verdict == "completed" then
        more.from = rest
      else -- statics has answered, and the collapse follows in time
        note(s, "cannot stand, so gravity at once")
      end
    end
    for _, rule in ipairs(s.later) do s.model:fracture(rule) end
    if changed.plan then return s.model, with(changed.plan(s), { from = more.from, record = false }) end
    -- So long that it is worth looking at, within the budget of the scene's own settings (not of changed ones). Auto
    -- steps are up to eight times longer while nothing happens.
    local step = more.dt
    if run.integrator == "explicit" then
      local planned = s.model:dynamic(with(more, { duration = s.wanted, record = false })).planned_steps
      step = s.wanted / planned
    elseif step == "auto" then
      step = s.wave / (s.contact and 12 or 4)
    end
    more.duration = math.min(s.wanted, math.max(20, (changed.part or 1) * budget / math.max(20, s.elements)) * step)
    for k, v in pairs(changed) do
      if not (of_model[k] or not_of_run[k]) then more[k] = v end
    end
    if changed.dt_times then
      more.dt = changed.dt_times * (run.dt == "auto" and not run.integrator and s.wave / 12 or step)
    end
    if type(more.dt) == "number" then more.duration = math.max(20, math.floor(more.duration / more.dt)) * more.dt end
    more.record = false
    note(s, "dt %s%s%s for %.3g s", more.dt, more.integrator and " " .. more.integrator or "",
      more.step_control and (" step_control %g"):format(more.step_control) or "", more.duration)
    return s.model, more
  end
  return scene
end

return scenes

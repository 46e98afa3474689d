-- Relations within one run: forces and moments in equilibrium, momentum that follows the forces, and momentum kept.
local built = require "relation_model"
local runs = require "relation_runs"
local vectors = require "hinge.library.vectors"
local has, worse, static, dynamic, zero = runs.has, runs.worse, runs.static, runs.dynamic, runs.zero
local list = {}

-- Balance -----------------------------------------------------------------------------------------------------------

-- Force of all that is not a support, at a time (nil: statics) in space, by hand: loads and weights; N.
local function history_at(points, time)
  if not points or not time then return 1 end
  if time <= points[1][1] then return points[1][2] end
  for i = 2, #points do
    local p, q = points[i - 1], points[i]
    if time <= q[1] then return p[2] + (q[2] - p[2]) * (time - p[1]) / (q[1] - p[1]) end
  end
  return points[#points][2]
end
local function add(sum, v, by) for i = 1, 3 do sum[i] = sum[i] + by * v[i] end end
-- Local axes of a member: z along it, y the part of `up` across it.
local function in_space(s, i, v)
  local m = s.members[i]
  local z = vectors.unit(vectors.minus(s.nodes[m[2]], s.nodes[m[1]]))
  local y = vectors.unit(vectors.plus(m.up, -vectors.dot(m.up, z), z))
  local x = vectors.cross(y, z)
  local out = {}
  for c = 1, 3 do out[c] = v[1] * x[c] + v[2] * y[c] + v[3] * z[c] end
  return out
end
-- Applied forces, and how large they are.
local function applied(s, run, time)
  local sum, size = { 0, 0, 0 }, 0
  local function take(v, by)
    add(sum, v, by)
    size = size + math.abs(by) * vectors.length(v)
  end
  local g
  for _, p in ipairs(s.parts) do
    local now = history_at(p.history, time)
    if time == nil and p.history then now = 0 end
    if p.kind == "load" or p.kind == "point" then take(p.force, now)
    elseif p.kind == "link" and p.dofs == "all" then take(p.force, 1)
    elseif p.kind == "q" then
      for _, v in ipairs { p.a, p.b } do
        take(p.axes == "local" and in_space(s, p.member, v) or v, 0.5 * now * s.members[p.member].length)
      end
    elseif p.kind == "gravity" then g = p.g
    end
  end
  if g then take(g, run:momentum().mass) end
  return sum, size
end
-- What holds the structure, on it: reactions, and connectors to the ground.
local function held_by(b, run)
  local sum, size = { 0, 0, 0 }, 0
  for _, nodes in ipairs { b.nodes, b.extra } do
    for _, node in ipairs(nodes) do
      if node.fixed then
        local force = { node:reaction(run) }
        add(sum, force, 1)
        size = size + vectors.length(force)
      end
    end
  end
  return sum, size
end

local function has_local(s)
  for _, part in ipairs(s.parts) do if part.axes == "local" then return true end end
  return false
end

list[#list + 1] = { name = "reactions", why = "equilibrium to 1e-11 of the forces; its sum over the nodes: 1e-7",
  fits = function(s) -- the force of a connector to the ground is in its own axes, and turns none with it
    return s.mode == "static" and not has(s, "connector") and
      not (has_local(s) and s.options.displacement ~= "small") and not (has(s, "q") and has(s, "sway"))
  end,
  check = function(hinge, s)
    local b, run = static(hinge, s, built.way())
    if run.verdict ~= "completed" then return nil, "the run fails: " .. run.reason:sub(1, 160) end
    local loads, size = applied(s, run, nil)
    local held, held_size = held_by(b, run)
    local off = 0
    for i = 1, 3 do off = worse(off, math.abs(loads[i] + held[i])) end
    b.model:close()
    return off / (1e-7 * (size + held_size)), ("loads %.9g %.9g %.9g, reactions %.9g %.9g %.9g"):format(loads[1],
      loads[2], loads[3], held[1], held[2], held[3])
  end }
-- Moments about the origin, in small displacement: places as declared.
list[#list + 1] = { name = "moments", why = "as reactions",
  fits = function(s)
    return s.mode == "static" and s.options.displacement == "small" and
      not has(s, "connector", "sway", "link")
  end,
  check = function(hinge, s)
    local b, run = static(hinge, s, built.way())
    if run.verdict ~= "completed" then return nil, "the run fails: " .. run.reason:sub(1, 160) end
    local sum, size = { 0, 0, 0 }, 0
    local function take(at, f, moment)
      local m = vectors.cross(at, f)
      if moment then add(m, moment, 1) end
      add(sum, m, 1)
      size = size + vectors.length(m)
    end
    local function on(member, part)
      return vectors.between(s.nodes[s.members[member][1]], s.nodes[s.members[member][2]], part)
    end
    local g = zero
    for _, p in ipairs(s.parts) do if p.kind == "gravity" then g = p.g end end
    local function weighs(at, mass) take(at, vectors.times(mass, g)) end
    for i, member in ipairs(b.members) do weighs(on(i, 0.5), member.mass) end
    for _, panel in ipairs(b.panels) do
      for i, n in ipairs(panel.nodes) do weighs({ n.x, n.y, n.z }, panel.mass * panel.shares[i] / panel.area) end
    end
    for _, p in ipairs(s.parts) do
      if p.kind == "load" then take(s.nodes[p.node], p.force, p.moment)
      elseif p.kind == "point" then take(on(p.member, p.at), p.force, p.moment)
      elseif p.kind == "mass" then
        weighs(vectors.plus(s.nodes[p.node], 1, p.offset or zero), p.mass)
      elseif p.kind == "line_mass" and p.a + p.b > 0 then -- above, it counts in the middle of its member
        local mass = (p.a + p.b) / 2 * (p.to - p.from) * s.members[p.member].length
        weighs(on(p.member, p.from + (p.to - p.from) * (p.a + 2 * p.b) / (3 * (p.a + p.b))), mass)
        weighs(on(p.member, 0.5), -mass)
      elseif p.kind == "q" then -- two triangles
        for i, v in ipairs { p.a, p.b } do
          local f = p.axes == "local" and in_space(s, p.member, v) or v
          take(on(p.member, i / 3), vectors.times(0.5 * s.members[p.member].length, f))
        end
      end
    end
    for i, node in ipairs(b.nodes) do
      if node.fixed then
        local fx, fy, fz, mx, my, mz = node:reaction(run)
        take(s.nodes[i], { fx, fy, fz }, { mx, my, mz })
      end
    end
    b.model:close()
    local off = worse(worse(math.abs(sum[1]), math.abs(sum[2])), math.abs(sum[3]))
    return off / (1e-7 * (size + 1)), ("moments left over %.9g %.9g %.9g of %.9g N m"):format(sum[1], sum[2], sum[3],
      size)
  end }

list[#list + 1] = { name = "momentum", why = "the step's own rule: P' - P = dt (F + F') / 2",
  fits = function(s) -- alpha is a force on the mass; a broken member's mass changes hands within a step
    return s.mode == "dynamic" and s.held and
      not has(s, "connector", "damping", "remove", "fracture", "move", "ground") and
      not (s.options.displacement ~= "small" and has_local(s))
  end,
  check = function(hinge, s)
    local b, run = dynamic(hinge, s, built.way(), { iterations = 30, step_control = 0 })
    local before, last, off, size = nil, nil, 0, 0
    local what = ""
    while run:step() do
      local force, of = applied(s, run, run.time)
      local held, held_size = held_by(b, run)
      add(force, held, 1)
      local p = run:momentum().linear
      size = worse(size, of + held_size)
      if before then
        for i = 1, 3 do
          local left = p[i] - last.p[i] - 0.5 * (run.time - last.t) * (force[i] + before[i])
          last.sum[i] = last.sum[i] + left
          local all = math.abs(last.sum[i]) / (run.time - last.start)
          if not (all <= off) then
            off, what = worse(off, all), ("axis %d at %.4g s: %.6g N on the mean of %.6g"):format(i, run.time,
              last.sum[i] / (run.time - last.start), size)
          end
        end
        last.p, last.t = p, run.time
      else last = { p = p, t = run.time, start = run.time, sum = { 0, 0, 0 } }
      end
      before = force
    end
    local verdict = run.verdict
    b.model:close()
    if verdict ~= "completed" then return nil, "the run fails" end
    -- an offset mass that turns: of second order in the step
    for _, p in ipairs(s.parts) do if p.offset then off = 0.1 * off end end
    return off / (1e-4 * size), what
  end }

list[#list + 1] = { name = "free momentum", why = "linear: rounding; angular: of second order in the step",
  fits = function(s) -- with `over` the forces of a member that is gone act from outside
    for _, p in ipairs(s.parts) do if p.over or p.dofs == "xyz" then return false end end
    return not s.held and not has(s, "connector", "ground", "damping")
  end,
  check = function(hinge, s)
    -- what the default of 1e-6 leaves of a solution adds up to 1e-6 of the momentum where a heavy rest spins
    local b, run = dynamic(hinge, s, built.way(), { iterations = 30, tolerance = 1e-11 })
    run:step()
    local g = zero
    for _, p in ipairs(s.parts) do if p.kind == "gravity" then g = p.g end end
    local first, start, off, what = run:momentum(), run.time, 0, ""
    local speed = 0
    for i = 1, 3 do speed = worse(speed, math.abs(first.linear[i])) end
    speed = worse(speed, first.mass * 1)
    local f = { 0, 0, 0 } -- of link's load
    for _, p in ipairs(s.parts) do if p.kind == "link" and p.dofs == "all" then add(f, p.force, 1) end end
    while run:step() do
      local now, t = run:momentum(), run.time - start
      for i = 1, 3 do
        local wanted = first.linear[i] + t * (first.mass * g[i] + f[i])
        local by = math.abs(now.linear[i] - wanted) / (1e-7 * speed)
        if not (by <= off) then
          off, what = worse(off, by), ("linear %d: %.9g for %.9g"):format(i, now.linear[i], wanted)
        end
        if g == zero and not has(s, "link") then
          by = math.abs(now.angular[i] - first.angular[i]) / (1e-3 * speed * 1)
          if not (by <= off) then
            off, what = worse(off, by), ("angular %d: %.9g for %.9g"):format(i, now.angular[i], first.angular[i])
          end
        end
      end
    end
    local verdict, reason = run.verdict, run.reason
    b.model:close()
    if verdict ~= "completed" then return nil, "the run fails: " .. (reason or ""):sub(1, 160) end
    return off, what
  end }

return list

-- The same frame by hinge and by OpenSees, in one run: what a second of motion takes, and how far the answers agree.
--
-- Run     build/hinge run tests/bench/beside.lua opensees=PATH
--         PATH: your program OpenSees with Tcl; without it hinge alone. storeys=20 bays=5: a larger frame; turns=3:
--         the least time of three
-- Shows   a space frame of steel boxes that carries its floors and is pushed at its top for half a second: elastic,
--         plastic, and elastic in explicit steps. Seconds for a second of motion, the largest displacement of a top
--         corner and the last one, m
-- Expect  exit status 0: the largest displacements of both programs differ by less than 0.5 % (elastic), 5 % (plastic:
--         hinges at points against fibres along the member) and 5 % (explicit: P-delta against large displacement)
-- Writes  the scripts for OpenSees, and what it prints, in the output folder: elastic.tcl, elastic.log and so on
local hinge = require "hinge"
local quote = require "hinge.library.quote"

local E, nu, density, yield_stress, g = 206e9, 0.3, 7850, 325e6, 9.81
local boxes = { column = { 0.4, 0.016 }, beam = { 0.3, 0.012 } } -- width and thickness, m
local bay, height, floor_mass = 6, 3.5, 8000 -- m; kg at each joint
local pushed = 0.5 -- s: the push rises until half of it, and falls to zero
local implicit_step = 5e-3 -- s
local no_shear = 1000 -- times the area; explicit steps would be as much shorter

-- Nodes with their places, elements between them, and the corner that is watched: the frame, for either program.
-- `parts`: elements of a member, between nodes of their own.
local function frame_of(p, parts)
  local nodes, elements, at = {}, {}, {}
  for k = 0, p.storeys do
    for i = 0, p.bays do
      for j = 0, p.bays do
        nodes[#nodes + 1] = { bay * i, bay * j, height * k, base = k == 0, top = k == p.storeys,
          floor = k > 0 and floor_mass or 0 }
        at[i .. "," .. j .. "," .. k] = #nodes
      end
    end
  end
  local function member(kind, i, j, k, to)
    local from = at[i .. "," .. j .. "," .. k]
    local a, b = nodes[from], nodes[to]
    for part = 1, parts - 1 do
      local s = part / parts
      nodes[#nodes + 1] = { a[1] + s * (b[1] - a[1]), a[2] + s * (b[2] - a[2]), a[3] + s * (b[3] - a[3]), floor = 0 }
      elements[#elements + 1] = { from, #nodes, kind = kind }
      from = #nodes
    end
    elements[#elements + 1] = { from, to, kind = kind }
  end
  for k = 1, p.storeys do
    for i = 0, p.bays do
      for j = 0, p.bays do
        local here = at[i .. "," .. j .. "," .. k]
        member("column", i, j, k - 1, here)
        if i > 0 then member("beam", i - 1, j, k, here) end
        if j > 0 then member("beam", i, j - 1, k, here) end
      end
    end
  end
  return nodes, elements, at[p.bays .. "," .. p.bays .. "," .. p.storeys]
end

local function length_of(nodes, e)
  local a, b, sum = nodes[e[1]], nodes[e[2]], 0
  for c = 1, 3 do sum = sum + (b[c] - a[c]) ^ 2 end
  return math.sqrt(sum)
end

-- By hinge: seconds, the largest and the last displacement of the corner, m, and the step, s.
local function by_hinge(p, job)
  local nodes, elements, corner = frame_of(p, 1)
  local steel = hinge.material { E = E, nu = nu, density = density, yield_stress = job.plastic and yield_stress or nil }
  local section = {}
  for kind, size in pairs(boxes) do
    local box = hinge.section.box { width = size[1], depth = size[1], thickness = size[2] }
    section[kind] = job.shear and box or hinge.section.general { area = box.area, Ix = box.Ix, Iy = box.Iy, J = box.J,
      shear_area_x = no_shear * box.area, shear_area_y = no_shear * box.area }
  end
  local model, node = hinge.model(), {}
  for i, n in ipairs(nodes) do
    node[i] = model:node { n[1], n[2], n[3] }
    if n.base then model:fix(node[i]) end
    if n.floor > 0 then
      model:mass { node = node[i], mass = n.floor }
      model:load { node = node[i], force = { 0, 0, -g * n.floor } }
    end
  end
  for _, e in ipairs(elements) do
    model:member { node[e[1]], node[e[2]], section = section[e.kind], material = steel }
  end
  local rest = model:static { steps = 1, record = false }:finish()
  for i, n in ipairs(nodes) do
    if n.top then
      model:load { node = node[i], force = { job.push, 0, 0 },
        history = { { 0, 0 }, { pushed / 2, 1 }, { pushed, 0 }, { 1e9, 0 } } }
    end
  end
  local run = model:dynamic { from = rest, duration = p.duration, dt = job.explicit and "auto" or implicit_step,
    integrator = job.explicit and "explicit" or "newmark", threads = 1, record = false }
  local largest, last = 0, 0
  local began = os.clock()
  for _ in run:steps() do
    last = node[corner]:displacement(run)
    if math.abs(last) > largest then largest = math.abs(last) end
  end
  assert(run.verdict == "completed", run.reason)
  return { seconds = os.clock() - began, largest = largest, last = last, dt = run.time / run.index }
end

-- The script for OpenSees. Elastic: corotational beams without shear strain; plastic: force-based beams with five
-- sections of fibres, elastic shear and torsion; explicit: beams with shear, for which it has P-delta alone. All nodes
-- have the masses of their elements' halves.
local function tcl_of(p, job, dt)
  local nodes, elements, corner = frame_of(p, job.explicit and 2 or 1)
  local out = { "model BasicBuilder -ndm 3 -ndf 6" }
  local function line(format, ...) out[#out + 1] = format:format(...) end
  local mass, rotary = {}, {}
  for i, n in ipairs(nodes) do mass[i], rotary[i] = n.floor, 0 end
  local properties = {}
  for kind, size in pairs(boxes) do
    local s = hinge.section.box { width = size[1], depth = size[1], thickness = size[2] }
    properties[kind] = { A = s.area, I = s.Ix, J = s.J, shear = s.shear_area_x, width = size[1], t = size[2] }
  end
  for _, e in ipairs(elements) do
    local L, A = length_of(nodes, e), properties[e.kind].A
    for _, i in ipairs { e[1], e[2] } do
      mass[i] = mass[i] + density * A * L / 2
      rotary[i] = rotary[i] + density * A * L ^ 3 / 24 -- of half an element about its end
    end
  end
  for i, n in ipairs(nodes) do
    line("node %d %.17g %.17g %.17g", i, n[1], n[2], n[3])
    if n.base then line("fix %d 1 1 1 1 1 1", i) end
    local turns = job.explicit and rotary[i] or 0
    line("mass %d %.17g %.17g %.17g %.17g %.17g %.17g", i, mass[i], mass[i], mass[i], turns, turns, turns)
  end
  local transformation = job.explicit and "PDelta" or "Corotational"
  line("geomTransf %s 1 1 0 0", transformation)
  line("geomTransf %s 2 0 0 1", transformation)
  local G = E / (2 * (1 + nu))
  for tag, kind in ipairs { "column", "beam" } do
    local s = properties[kind]
    if job.plastic then
      local o, i = s.width / 2, s.width / 2 - s.t
      line("uniaxialMaterial Steel01 %d %g %g 1e-6", tag, yield_stress, E)
      for c, stiffness in ipairs { G * s.J, G * s.shear, G * s.shear } do
        line("uniaxialMaterial Elastic %d %.17g", 10 * tag + c, stiffness)
      end
      line("section Fiber %d -GJ %.17g {", 10 * tag, G * s.J)
      for _, wall in ipairs { { -o, -o, o, -i, 10, 1 }, { -o, i, o, o, 10, 1 }, { -o, -i, -i, i, 1, 10 },
        { i, -i, o, i, 1, 10 } } do
        line("patch rect %d %d %d %.17g %.17g %.17g %.17g", tag, wall[5], wall[6], wall[1], wall[2], wall[3], wall[4])
      end
      line("}")
      line("section Aggregator %d %d Vy %d Vz -section %d", tag, 10 * tag + 2, 10 * tag + 3, 10 * tag)
      line("beamIntegration Lobatto %d %d 5", tag, tag)
    end
  end
  for i, e in ipairs(elements) do
    local tag = e.kind == "column" and 1 or 2
    local s = properties[e.kind]
    if job.plastic then
      line("element forceBeamColumn %d %d %d %d %d", i, e[1], e[2], tag, tag)
    elseif job.shear then
      line("element ElasticTimoshenkoBeam %d %d %d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %d", i, e[1], e[2],
        E, G, s.A, s.J, s.I, s.I, s.shear, s.shear, tag)
    else
      line("element elasticBeamColumn %d %d %d %.17g %.17g %.17g %.17g %.17g %.17g %d", i, e[1], e[2], s.A, E, G, s.J,
        s.I, s.I, tag)
    end
  end
  line("timeSeries Linear 1\npattern Plain 1 1 {")
  for i, n in ipairs(nodes) do
    if n.floor > 0 then line("load %d 0 0 %.17g 0 0 0", i, -g * n.floor) end
  end
  line("}\nconstraints Plain\nnumberer RCM\nsystem UmfPack\ntest NormDispIncr 1e-8 30\nalgorithm Newton")
  line("integrator LoadControl 1\nanalysis Static\nif {[analyze 1] != 0} { exit 1 }\nloadConst -time 0\nwipeAnalysis")
  line("timeSeries Path 2 -time {0 %g %g 1e9} -values {0 1 0 0}\npattern Plain 2 2 {", pushed / 2, pushed)
  for i, n in ipairs(nodes) do
    if n.top then line("load %d %.17g 0 0 0 0 0", i, job.push) end
  end
  line("}\nconstraints Plain")
  if job.explicit then
    line("numberer Plain\nsystem Diagonal\ntest NormDispIncr 1e-8 1\nalgorithm Linear\nintegrator CentralDifference")
  else
    line("numberer RCM\nsystem UmfPack\ntest NormDispIncr 1e-8 30\nalgorithm Newton\nintegrator Newmark 0.5 0.25")
  end
  line("analysis Transient\nset largest 0\nset before [clock microseconds]")
  line("for {set i 0} {$i < %d} {incr i} {", math.ceil(p.duration / dt - 1e-9))
  line("  if {[analyze 1 %.17g] != 0} { exit 1 }", dt)
  line("  set u [nodeDisp %d 1]\n  if {abs($u) > $largest} { set largest [expr {abs($u)}] }\n}", corner)
  line('puts "answer [version] [expr {([clock microseconds] - $before) * 1e-6}] $largest $u"')
  return table.concat(out, "\n") .. "\n"
end

-- By OpenSees.
local function by_opensees(p, job, dt, folder)
  local script, log = ("%s/%s.tcl"):format(folder, job.name), ("%s/%s.log"):format(folder, job.name)
  local file = assert(io.open(script, "w"))
  file:write(tcl_of(p, job, dt))
  file:close()
  if p.opensees == "" then return nil end
  os.execute(("%s %s > %s 2>&1"):format(quote.shell(p.opensees), quote.shell(script), quote.shell(log)))
  file = assert(io.open(log))
  local version, seconds, largest, last = file:read("a"):match "answer%s+(%S+)%s+(%S+)%s+(%S+)%s+(%S+)"
  file:close()
  if not version then error(("OpenSees did not end: see %s"):format(log), 0) end
  return { version = version, seconds = tonumber(seconds), largest = tonumber(largest), last = tonumber(last) }
end

local allowed = { elastic = 0.005, plastic = 0.05, explicit = 0.05 } -- of the largest displacement
local jobs = {
  { name = "elastic", push = 20e3 },
  { name = "plastic", push = 400e3, plastic = true, shear = true },
  { name = "explicit", push = 20e3, explicit = true, shear = true },
}

return hinge.scenario {
  parameters = { opensees = "", storeys = 10, bays = 3, duration = 2, turns = 1 },
  run = function(p, job)
    assert(os.execute("mkdir -p " .. quote.shell(job.out)))
    local version, out = nil, {}
    print(("%-9s %-9s %9s %10s %11s %11s"):format("frame", "by", "dt, us", "s", "largest, m", "last, m"))
    for _, what in ipairs(jobs) do
      local ours, theirs
      for _ = 1, p.turns do
        local now = by_hinge(p, what)
        ours = (not ours or now.seconds < ours.seconds) and now or ours
        now = by_opensees(p, what, what.explicit and ours.dt or implicit_step, job.out)
        theirs = (now and (not theirs or now.seconds < theirs.seconds)) and now or theirs
      end
      local function row(by, r)
        print(("%-9s %-9s %9.4g %10.3f %11.5f %11.5f"):format(what.name, by, 1e6 * ours.dt, r.seconds / p.duration,
          r.largest, r.last))
      end
      row("hinge", ours)
      out[what.name] = { hinge = ours.seconds, largest = ours.largest }
      if theirs then
        row("OpenSees", theirs)
        version, out[what.name].opensees = theirs.version, theirs.seconds
        local off = math.abs(theirs.largest / ours.largest - 1)
        assert(off <= allowed[what.name],
          ("%s: the largest displacements differ by %.2g %%"):format(what.name, 100 * off))
      end
    end
    print(version and ("OpenSees %s, hinge %s; one core"):format(version, hinge.version) or
      "no OpenSees: give opensees=PATH")
    return out
  end,
}

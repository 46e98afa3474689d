-- import.build: a model of hinge from the description of a frame (frame.lua).
local core = require "hinge.core"
local check = require "hinge.library.check"
local in_full = require "hinge.import.in_full"
local named = require "hinge.sections.named"
local slabs = require "hinge.import.slabs"
local ties = require "hinge.import.ties"

local where = "hinge.import.build"

-- A section of the frame as an object.
local function section_of(s)
  if s.named then return core.section(named.properties(s.named)) end
  local given = check.copy(s)
  given.name, given.kind = nil, s.kind or s.name
  return core.section(given)
end

local function material_of(m)
  return core.material { E = m.E, G = m.G, nu = m.nu, density = m.density, yield_stress = m.yield_stress,
    hardening = m.hardening }
end

-- Joints of a member's ends.
local function ends_of(m)
  if not m.ends then return nil end
  local ends = {}
  for at, options in pairs(m.ends) do ends[at] = core.joint(options) end
  return ends
end

local function add_loads(model, full, nodes, members)
  for _, c in ipairs(full.cases) do
    local case = model:case(c.name)
    if c.gravity then case:gravity { 0, 0, c.gravity } end
    for _, l in ipairs(c.loads) do
      case:load { node = l.node and nodes[l.node], member = l.member and members[l.member], force = l.force,
        moment = l.moment, q = l.q, at = l.at, from = l.from, to = l.to, axes = l.axes, history = c.history }
    end
  end
end

return function(frame, options, ...)
  check.no_more(where, ...)
  local full = in_full(where, frame, options)
  local model = core.model(full.options)
  local nodes, members, sections, materials = {}, {}, {}, {}
  for _, n in ipairs(full.nodes) do nodes[n.name] = model:node { n.x, n.y, n.z } end
  for _, n in ipairs(full.nodes) do
    if n.fix and n.fix ~= "" then model:fix(nodes[n.name], n.fix) end
  end
  for _, s in ipairs(full.sections) do sections[s.name] = section_of(s) end
  for _, m in ipairs(full.materials) do materials[m.name] = material_of(m) end
  for _, m in ipairs(full.members) do
    members[m.name] = model:member { nodes[m.a], nodes[m.b], section = sections[m.section],
      material = materials[m.material], up = m.up, group = m.group, ends = ends_of(m), release = m.release,
      offset = m.offset, elements = m.elements }
  end
  for _, m in ipairs(full.masses) do
    model:mass { node = nodes[m.node], mass = m.mass, inertia = m.inertia, offset = m.offset }
  end
  ties.build(core, model, full, nodes)
  add_loads(model, full, nodes, members)
  slabs.build(model, full, members, materials)
  return model, nodes, members
end

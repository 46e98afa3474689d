-- The ten-storey steel frame of the paper's section 4, with any number of bays and storeys.
--
-- Reconstructed, because the paper's figure 16 is lost: bays, storeys, sections and yield stress, in two designs. Every
-- one is an option. `light` is the default. The study scripts/paper/lost_inputs.lua chose it: the findings of the paper
-- hold there. `heavy` is a frame that the aircraft does not cut. From the paper: ten storeys, steel, fixed at its feet,
-- and a floor weight of twenty times the own weight of the whole structure, put into the density of the beams.
--
-- The paper has no floors. `floor = "weight"` gives their weight to the beams around each panel by area, in place of
-- all beams alike. `floor = "slab"` lays floors of the same mass: C30/37 with a mesh of B500 in its middle, as
-- thick as 2500 kg/m^3 fit into the floor weight. E and strengths are those of EN 1992-1-1; bending is that of the
-- cracked slab, a quarter of E I and As f_y (t / 2 - As f_y / 2 f_c) each way.
local hinge = require "hinge"
local check = require "hinge.library.check"
local materials = require "hinge.models.materials"

local ten_storey = {}
local where = "ten_storey.add"

-- t: thickness, m; mesh: area of its bars each way, m^2/m.
local function slab_of(t, mesh)
  local E, strength, yield_stress = 33e9, 30e6, 500e6
  local moment = mesh * yield_stress * (t / 2 - mesh * yield_stress / (2 * strength))
  return {
    concrete = { thickness = t, E = E, strength = strength },
    reinforcement = { x = mesh, y = mesh, yield_stress = yield_stress, hardening = 1e9, ultimate_strain = 0.05 },
    bending = { stiffness = 0.25 * E * t ^ 3 / 12, sagging = moment, hogging = moment },
  }
end

ten_storey.designs = {
  light = {
    bay = 5.8, storey = 3.5, column = hinge.section.box { width = 0.18, depth = 0.18, thickness = 0.006 },
    beam = hinge.section.h { depth = 0.2, width = 0.1, web = 0.0055, flange = 0.008 }, yield_stress = 295e6,
    slab = slab_of(0.12, 393e-6), -- 300 of 320 kg/m^2
  },
  heavy = {
    bay = 8, storey = 4, column = hinge.section.box { width = 0.4, depth = 0.4, thickness = 0.022 },
    beam = hinge.section.h { depth = 0.4, width = 0.2, web = 0.008, flange = 0.013 }, yield_stress = 325e6,
    slab = slab_of(0.25, 785e-6), -- of 900 kg/m^2
  },
}

local rules = {
  design = { "string", default = "light" },
  bays = { "numbers", count = 2, whole = true, at_least = 1, default = { 4, 4 } },
  storeys = { "number", whole = true, at_least = 1, default = 10 },
  bay = { "number", unit = "m", above = 0, optional = true }, -- these five: of the design
  storey = { "number", unit = "m", above = 0, optional = true },
  column = { "section", optional = true },
  beam = { "section", optional = true },
  material = { "material", optional = true },
  floor_weight = { "number", at_least = 0, default = 20 },
  floor = { "string", default = "none", one_of = { "none", "weight", "slab" } },
  slab = { "table", optional = true }, -- of the design
  origin = { "numbers", count = 3, unit = "m", default = { 0, 0, 0 } },
}

-- Density of the beams. It includes the weight of the beams and, without floors, `floor_weight` times the weight of the
-- whole frame.
local function masses(o)
  local nx, ny = o.bays[1], o.bays[2]
  local column_length = (nx + 1) * (ny + 1) * o.storeys * o.storey
  local beam_length = (nx * (ny + 1) + ny * (nx + 1)) * o.storeys * o.bay
  local own = o.material.density * (column_length * o.column.area + beam_length * o.beam.area)
  local floors = o.floor_weight * own
  return {
    own_mass = own, floor_mass = floors, mass = own + floors,
    floor_load = floors / (o.storeys * nx * ny * o.bay ^ 2),
    beam_density = o.material.density + (o.floor == "none" and floors / (beam_length * o.beam.area) or 0),
  }
end

--- Adds the frame to a model. Options and what the returned frame holds: see words/models.d.lua.
function ten_storey.add(model, options)
  check.model(where, model)
  local given = check.options(where, options, rules)
  if given.slab and given.floor ~= "slab" then
    check.fail("%s: field 'slab' is given without floor = \"slab\"", where)
  end
  local o = check.design(where, given, ten_storey.designs)
  o.material = o.material
    or hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = o.yield_stress }
  local frame = masses(o)
  local loaded = materials.with_density(o.material, frame.beam_density)
  local nx, ny = o.bays[1], o.bays[2]

  local nodes = {}
  for level = 0, o.storeys do
    nodes[level] = {}
    for i = 0, nx do
      nodes[level][i] = {}
      for j = 0, ny do
        local node = model:node { o.origin[1] + i * o.bay, o.origin[2] + j * o.bay, o.origin[3] + level * o.storey }
        nodes[level][i][j] = node
        if level == 0 then model:fix(node, "all") end
      end
    end
  end

  local function add_column(level, i, j)
    local inside = i > 0 and i < nx and j > 0 and j < ny
    model:member { nodes[level - 1][i][j], nodes[level][i][j],
      section = o.column, material = o.material, up = { 1, 0, 0 },
      group = { "columns", inside and "inner columns" or "outer columns", "storey " .. level, "building" } }
  end

  local beams = {}
  local function add_beam(level, i, j, to_i, to_j)
    beams[#beams + 1] = model:member { nodes[level][i][j], nodes[level][to_i][to_j],
      section = o.beam, material = loaded, up = { 0, 0, 1 },
      group = { "beams", "storey " .. level, "building" } }
  end

  frame.storey_groups = {}
  for level = 1, o.storeys do
    frame.storey_groups[level] = "storey " .. level
    for i = 0, nx do
      for j = 0, ny do
        add_column(level, i, j)
        if i < nx then add_beam(level, i, j, i + 1, j) end
        if j < ny then add_beam(level, i, j, i, j + 1) end
      end
    end
  end

  if o.floor ~= "none" then
    frame.floor = model:floor { members = beams, mass = frame.floor_load, slab = o.floor == "slab" and o.slab or nil }
  end
  frame.group = model:group("building")
  frame.origin = o.origin
  frame.size = { nx * o.bay, ny * o.bay, o.storeys * o.storey }
  --- The joint in column line i (along x) and j (along y), both from 0, at the top of storey `level`; 0 is the ground.
  function frame.node(i, j, level)
    local plane = nodes[level]
    local line = plane and plane[i]
    return line and line[j]
      or check.fail("frame.node: there is no joint %s, %s at level %s; lines 0 to %d and 0 to %d, levels 0 to %d",
        tostring(i), tostring(j), tostring(level), nx, ny, o.storeys)
  end
  return frame
end

return ten_storey

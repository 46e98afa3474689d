-- The ten-storey steel frame of the paper's section 4, with any number of bays and storeys.
--
-- Reconstructed, because the paper's figure 16 is lost: bays, storeys, sections and yield stress, in two designs. Every
-- one is an option. `light` is the default. The study scripts/paper/lost_inputs.lua chose it: the findings of the paper
-- hold there. `heavy` is a frame that the aircraft does not cut. From the paper: ten storeys, steel, fixed at its feet,
-- and a floor weight of twenty times the own weight of the whole structure, put into the density of the beams.
local hinge = require "hinge"
local check = require "hinge.library.check"
local materials = require "hinge.models.materials"

local ten_storey = {}
local where = "ten_storey.add"

ten_storey.designs = {
  light = {
    bay = 5.8, storey = 3.5, column = hinge.section.box { width = 0.18, depth = 0.18, thickness = 0.006 },
    beam = hinge.section.h { depth = 0.2, width = 0.1, web = 0.0055, flange = 0.008 }, yield_stress = 295e6,
  },
  heavy = {
    bay = 8, storey = 4, column = hinge.section.box { width = 0.4, depth = 0.4, thickness = 0.022 },
    beam = hinge.section.h { depth = 0.4, width = 0.2, web = 0.008, flange = 0.013 }, yield_stress = 325e6,
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
  origin = { "numbers", count = 3, unit = "m", default = { 0, 0, 0 } },
}

-- Density of the beams. It includes the weight of the beams and `floor_weight` times the weight of the whole frame.
local function masses(o)
  local nx, ny = o.bays[1], o.bays[2]
  local column_length = (nx + 1) * (ny + 1) * o.storeys * o.storey
  local beam_length = (nx * (ny + 1) + ny * (nx + 1)) * o.storeys * o.bay
  local own = o.material.density * (column_length * o.column.area + beam_length * o.beam.area)
  local floors = o.floor_weight * own
  return {
    own_mass = own, floor_mass = floors, mass = own + floors,
    floor_load = floors / (o.storeys * nx * ny * o.bay ^ 2),
    beam_density = o.material.density + floors / (beam_length * o.beam.area),
  }
end

--- Adds the frame to a model. Options and what the returned frame holds: see words/models.d.lua.
function ten_storey.add(model, options)
  check.model(where, model)
  local o = check.design(where, check.options(where, options, rules), ten_storey.designs)
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

  local function add_beam(level, i, j, to_i, to_j)
    model:member { nodes[level][i][j], nodes[level][to_i][to_j], section = o.beam, material = loaded, up = { 0, 0, 1 },
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

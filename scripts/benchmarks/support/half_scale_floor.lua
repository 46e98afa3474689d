-- The half-scale composite floor of three by three bays tested at Illinois, without one of its columns, under a load
-- that grows: the common part of the benchmark and of the study that varies its inputs. All lengths are half-scale.
local hinge = require "hinge"

local floor = {}

local bay, bays, thirds = 4.572, 3, 3 -- m: half of 30 ft; beams at the third points of the girders
local cover, rib = 0.0413, 0.0254 -- m: half of 3 1/4 in of concrete over half of 2 in of deck
local own_load, own_mass = 1.4e3, 130 -- Pa, of slab and steel; kg/m^2, of the slab
local post = hinge.section.named "W6X15" -- half of a W12 of 53 lb/ft
local steel = hinge.material { E = 200e9, density = 7850, yield_stress = 380e6 } -- A992, 1.1 times 345 MPa

--- Inputs. None of these numbers is public; see the head of illinois_floor.lua for the rules they follow.
floor.inputs = {
  panels = 3, -- along a side of a bay: 3 or 6
  beam = "W8X10", girder = "W10X12",
  concrete = 28e6, -- Pa
  mesh = 29.6e-6, mesh_yield = 485e6, crack = 4e-3, -- m^2/m each way, Pa, m: opening at which its wires break
  deck = "sheets", -- "none", "sheets" of one bay, joined over the columns' lines, or "continuous"
  deck_area = 518e-6, deck_yield = 300e6, -- m^2/m, Pa
  deck_joint = 25e3, deck_opening = 6e-3, -- N/m, m: what fasteners hold where sheets end
  stud = 20e3, stud_stiffness = 50e6, spacing = 0.1524, slip = 0, -- N, N/m, m, m (0: no end)
  bolt = 29e3, pitch = 0.0381, beam_rows = 3, girder_rows = 4, -- N, m: 3/8 in, A325
  stretch = 6e-3, turn = 0.09, -- m, rad: plastic deformations at which a shear tab breaks
  dead = 3.35e3, live = 3.83e3, -- Pa: 70 and 80 psf, of the prototype
  rate = 4e3, alpha = 10, dt = 5.5e-5, -- Pa/s, 1/s, s
  to = 0.6, -- m of sag
}

--- The columns that were lost, by the lines of columns from 0 on.
floor.columns = { corner = { 0, 3 }, girders = { 1, 0 }, beams = { 0, 1 }, interior = { 1, 1 } }

-- What a panel of the width d consists of. at_joint: sheets of the deck end at one of its sides.
local function sheet(o, d, at_joint)
  local deck
  if o.deck ~= "none" then
    local joined = o.deck == "sheets" and at_joint
    deck = { area = o.deck_area, along = "x", z = -(cover + rib) / 2,
      yield_stress = joined and o.deck_joint / o.deck_area or o.deck_yield,
      ultimate_strain = joined and o.deck_opening / d or 0.1 }
  end
  return { concrete = { thickness = cover, strength = o.concrete, E = 25e9 }, deck = deck, bending = "layers",
    along = { 1, 0, 0 }, mass = own_mass, reinforcement = { x = o.mesh, y = o.mesh, yield_stress = o.mesh_yield,
      ultimate_strain = o.crack / d } }
end

-- A floor that is being laid: the model, the nodes of the slab by their place in its grid, what joins them.
local Laying = {}
Laying.__index = Laying

function Laying:node(i, j, z) return self.model:node { self.d * i, self.d * j, z or 0 } end

function Laying:over(i, j) return self.slab[i][j] end

-- A plate with one line of bolts between the web of a beam and what carries it, which stretches and turns.
function Laying:tab(carrier, beam, rows, along)
  local o, moment = self.o, 0
  for k = 1, rows do moment = moment + o.bolt * math.abs(k - (rows + 1) / 2) * o.pitch end
  local pull = rows * o.bolt
  self.tabs[#self.tabs + 1] = self.model:connector { carrier, beam,
    axes = { x = along, y = { -along[2], along[1], 0 } },
    stiffness = { x = pull / 1e-3, y = pull / 1e-3, z = pull / 1e-3, rx = 20e3, ry = moment / 0.01, rz = 20e3 },
    yield = { x = pull, ry = moment }, ultimate = { x = o.stretch, ry = o.turn }, capacity = { z = pull } }
end

function Laying:stud(node, i, j, length)
  local o = self.o
  local count = length / o.spacing
  local k = count * o.stud_stiffness
  self.model:connector { node, self:over(i, j), stiffness = { x = k, y = k, z = k }, yield = { xy = count * o.stud },
    ultimate = o.slip > 0 and { xy = o.slip } or nil }
end

-- A beam or a girder over one bay, on whose nodes the slab stands. place: of its k-th node in the slab's grid.
function Laying:beam(section, place)
  local nodes, n, p = {}, self.o.panels, self.o.panels // thirds
  for k = 0, n, p do nodes[k] = self:node(place(k)) end
  for k = p, n, p do
    local member = self.model:member { nodes[k - p], nodes[k], section = hinge.section.named(section), material = steel,
      up = { 0, 0, 1 }, elements = 2, group = "beams" }
    if p == 2 then nodes[k - 1] = member:node(1) end
  end
  for k = 0, n do
    local i, j = place(k)
    self:stud(nodes[k], i, j, (k == 0 or k == n) and self.d / 2 or self.d)
  end
  return nodes
end

function Laying:columns(lost)
  for a = 0, bays do
    self.heads[a] = {}
    for b = 0, bays do
      local i, j = a * self.o.panels, b * self.o.panels
      local head, foot = self:node(i, j), self:node(i, j, -2)
      self.heads[a][b] = head
      if a ~= lost[1] or b ~= lost[2] then self.model:fix(foot) end -- the lost one hangs from the floor
      self.model:member { foot, head, section = post, material = steel, up = { 1, 0, 0 }, group = "columns" }
    end
  end
end

-- Girders along x on the lines of columns, beams along y on these and between them.
function Laying:frame()
  local n, carriers = self.o.panels, {}
  for a = 0, bays do
    for b = 0, bays do carriers[("%d %d"):format(a * n, b * n)] = self.heads[a][b] end
  end
  for b = 0, bays do
    for a = 0, bays - 1 do
      local nodes = self:beam(self.o.girder, function(k) return a * n + k, b * n end)
      for k = n // thirds, n - 1, n // thirds do carriers[("%d %d"):format(a * n + k, b * n)] = nodes[k] end
      self:tab(self.heads[a][b], nodes[0], self.o.girder_rows, { 1, 0, 0 })
      self:tab(self.heads[a + 1][b], nodes[n], self.o.girder_rows, { 1, 0, 0 })
    end
  end
  for i = 0, bays * n, n // thirds do
    for b = 0, bays - 1 do
      local nodes = self:beam(self.o.beam, function(k) return i, b * n + k end)
      for e = 0, 1 do
        self:tab(carriers[("%d %d"):format(i, (b + e) * n)], nodes[e * n], self.o.beam_rows, { 0, 1, 0 })
      end
    end
  end
end

-- The slab. The load grows in the bays around the lost column; elsewhere the floor carries itself.
function Laying:lay(lost)
  local o, n, total = self.o, self.o.panels, bays * self.o.panels
  local others, order = {}, {}
  local function beside(i, line) return i // n == line or i // n == line - 1 end
  for i = 0, total - 1 do
    for j = 0, total - 1 do
      local at_joint = (i % n == 0 or i % n == n - 1) and i > 0 and i < total - 1
      local options = sheet(o, self.d, at_joint)
      for k, c in ipairs { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } do options[k] = self:over(i + c[1], j + c[2]) end
      local panel = self.model:panel(options)
      self.panels[#self.panels + 1] = panel
      local shares = beside(i, lost[1]) and beside(j, lost[2]) and self.shares or others
      for k, node in ipairs(panel.nodes) do
        if not self.shares[node] and not others[node] then order[#order + 1] = node end
        shares[node] = (shares[node] or 0) + panel.shares[k]
      end
    end
  end
  for _, node in ipairs(order) do
    for _, part in ipairs { { self.shares[node] or false, math.huge }, { others[node] or false, own_load } } do
      if part[1] then
        self.model:load { node = node, force = { 0, 0, -part[1] },
          history = function(t) return math.min(o.rate * t, part[2]) end }
      end
    end
  end
end

--- The floor without a column: a table with the model, its `lost` head, `shares` of the loaded area by nodes, `tabs`
--- and `panels`.
function floor.build(o, lost)
  local self = setmetatable({ o = o, d = bay / o.panels, model = hinge.model {}, heads = {}, slab = {}, tabs = {},
    panels = {}, shares = {} }, Laying)
  local height = hinge.section.named(o.beam).depth / 2 + rib + cover / 2
  for i = 0, bays * o.panels do
    self.slab[i] = {}
    for j = 0, bays * o.panels do self.slab[i][j] = self:node(i, j, height) end
  end
  self:columns(lost)
  self:frame()
  self:lay(lost)
  self.lost = self.heads[lost[1]][lost[2]]
  self.model:damping { alpha = o.alpha }
  return self
end

-- Where the floor is: its load, the volume through which the load has moved, what is not held by forces of the floor.
local function now_of(self, run, time)
  local energy, volume = run.energy, 0
  for node, area in pairs(self.shares) do volume = volume - area * select(3, node:displacement(run)) end
  return { load = self.o.rate * time, volume = volume, free = energy.kinetic + energy.damping,
    sag = -select(3, self.lost:displacement(run)) }
end

local function broken(list, run)
  local count = 0
  for _, tab in ipairs(list) do count = count + (tab:broken(run) and 1 or 0) end
  return count
end

--- Loads the floor until the lost column has sagged by `to`. The load that the floor holds is the one that acts, less
--- what goes into motion and damping: q - d(K + D) / dV, over 20 mm of sag each. Returns a table with the curve, its
--- peak and the sag there, and the run.
function floor.test(changes, column)
  local o = setmetatable(changes or {}, { __index = floor.inputs })
  local self = floor.build(o, floor.columns[column])
  local run = self.model:dynamic { integrator = "explicit", dt = o.dt, duration = 12e3 / o.rate }
  local found = { x = {}, y = {}, peak = 0, sag = 0 }
  local every, before, past = math.floor(0.01 / o.dt), { load = 0, volume = 0, free = 0, sag = 0 }, 0
  for step in run:steps() do
    if step.index % every == 0 then
      local now = now_of(self, run, step.time)
      if now.sag >= before.sag + 0.02 then
        local held = (now.load + before.load) / 2 - (now.free - before.free) / (now.volume - before.volume)
        local sag, tabs = (now.sag + before.sag) / 2, broken(self.tabs, run)
        table.insert(found.x, sag)
        table.insert(found.y, held / 1e3)
        if held > found.peak then found.peak, found.sag, found.tabs_at_peak = held, sag, past end
        if o.tell then
          print(("    %4.0f mm  %5.2f kPa  %d of %d tabs broken"):format(1e3 * sag, held / 1e3, tabs, #self.tabs))
        end
        before, past = now, tabs
      end
      if now.sag > o.to then break end
    end
  end
  found.tabs, found.steps, found.error = broken(self.tabs, run), run.index, run.energy_error
  found.largest = run.energy.work
  return found, run
end

return floor

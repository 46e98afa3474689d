-- The commands of OpenSees that describe a frame, as a frame of hinge. recorded.lua has the script run by its
-- interpreter, and calls run(name, arguments, place) for each command, with arguments as a list of texts. Those of one
-- kind of commands are in a file of the folder opensees.
--
-- Commands: the wiki of OpenSees and the documentation of OpenSeesPy. A plane frame in x and y becomes one in x and z
-- of hinge: y of OpenSees is z of hinge, and rotations about z of OpenSees are those about -y.
local beside = require "hinge.import.opensees.beside"
local check = require "hinge.library.check"
local command_names = require "hinge.import.opensees_names"
local constraints = require "hinge.import.opensees.constraints"
local ends = require "hinge.import.opensees.ends"
local frame_module = require "hinge.import.frame"
local models = require "hinge.import.opensees.models"
local notes = require "hinge.import.notes"
local springs = require "hinge.import.opensees.springs"
local units = require "hinge.import.opensees.units"

local Reader = {}
Reader.__index = Reader

local commands = {}
for _, part in ipairs { require "hinge.import.opensees.nodes", models.commands, constraints.commands,
  require("hinge.import.opensees.materials").commands, require("hinge.import.opensees.sections").commands,
  require("hinge.import.opensees.elements").commands, require("hinge.import.opensees.loads").commands } do
  for name, run in pairs(part) do commands[name] = run end
end

-- Commands that are not read and make nothing that others refer to.
local alone = {}
for name in ("nDMaterial equalDOF_Mixed damping sp frictionModel hystereticBackbone imposedMotion groundMotion "
  .. "modalDamping"):gmatch "%S+" do alone[name] = true end

function Reader:fail(...) notes.fail(self.where, self.place, ...) end

--- Notes that the command that runs now is not read.
function Reader:not_read(reason) notes.add(self.notes, self.place, self.place.text, reason) end

--- The same, with one note for all commands of one reason.
function Reader:not_read_once(reason) notes.once(self.notes, self.place, self.place.text, reason) end

-- What a model of the script consists of. wipe makes all of it anew.
local function fresh(file)
  return function()
    return { frame = frame_module.new(file), notes = notes.new(), places = {}, node = {}, section = {},
      geomTransf = {}, beamIntegration = {}, uniaxialMaterial = {}, element = {}, timeSeries = {}, pattern = {},
      shared = { sections = {}, materials = {} }, mass_of = {}, more_masses = {}, ties = {}, springs = {}, motions = {},
      transformation_of = {}, elements_lost = false, bars = {}, damping = {} }
  end
end

--- Begins a new model.
function Reader:begin()
  for key, value in pairs(self.fresh()) do self[key] = value end
  self.ndm, self.ndf, self.case, self.section_now, self.analysed = nil, nil, nil, nil, false
end

--- Notes that a command says nothing about the frame: one line in total.
function Reader:computed(place)
  notes.once(self.notes.skipped, place, place.text, "commands of the analysis and its results")
end

--- Runs a command of OpenSees, or of another kind, which is noted. args: a list of texts; place: { file =, line =, text
--- = }.
function Reader:run(name, args, place)
  self.place, self.command = place, name
  for _, text in ipairs(args) do
    if text == command_names.unknown and not beside[name] then
      if name == "pattern" then self.case = { unread = place } end
      if not alone[name] then self.incomplete = self.incomplete + 1 end
      return self:not_read "it hangs on a result of the analysis, which hinge does not compute here"
    end
  end
  if beside[name] then
    self:computed(place)
    if not commands[name] then return end
  end
  if commands[name] then
    local good, problem = pcall(commands[name], self, args)
    if good then return end
    if type(problem) ~= "table" or not problem.not_read then error(problem, 0) end
    if not problem.follows then return self:not_read(problem.not_read) end
    self:not_read_once(problem.not_read) -- what follows from a line that was not read
  else
    self:not_read(("the command %s is not read"):format(name))
    if not alone[name] then self.incomplete = self.incomplete + 1 end
  end
end

--- Notes a line that is not followed. What comes after may lack what it makes.
function Reader:lost(place, reason)
  self.place, self.incomplete = place, self.incomplete + 1
  self:not_read(reason)
end

-- The end -------------------------------------------------------------------------------------------------------------

-- At a node where bars alone end, one of them is not released: then the node turns with it, and no bar bends. In space
-- a weak spring keeps the node from turning about that bar.
local function hold_bars(self)
  local rigid, first = {}, {}
  for name, list in pairs(frame_module.ends_at(self.frame.members)) do
    for _, one in ipairs(list) do
      local m, at = one[1], one[2]
      if self.bars[m] then
        first[name] = first[name] or one
      elseif not (m.ends and m.ends[at]) then
        rigid[name] = true
      end
    end
  end
  for _, node in ipairs(self.frame.nodes) do
    local bar = not rigid[node.name] and first[node.name]
    if bar then
      local m, at = bar[1], bar[2]
      for _, letter in ipairs { "rx", "ry", "rz" } do node.fixed[letter] = self.ndm == 2 and letter ~= "ry" or nil end
      m.release[at] = nil
      if self.ndm == 3 then self.spins[#self.spins + 1] = { node = node.name, member = m } end
    end
  end
end

-- Weak springs against the spin of nodes at which bars alone end: 1e-9 of a bar's stiffness times its length.
local function add_spins(self)
  if #self.spins == 0 then return end
  local material, section = frame_module.by_name(self.frame.materials), frame_module.by_name(self.frame.sections)
  for _, spin in ipairs(self.spins) do
    local m = spin.member
    local _, length = frame_module.direction(self.node[m.a], self.node[m.b])
    local k = 1e-9 * material[m.material].E * section[m.section].area * length
    table.insert(self.frame.connectors, { a = spin.node, x = { 1, 0, 0 }, y = { 0, 1, 0 },
      stiffness = { rx = k, ry = k, rz = k } })
  end
end

-- displacement = "small" where all transformations are Linear; else the default of hinge.model, large.
local function choose_displacement(self)
  local linear, other = {}, {}
  for _, m in ipairs(self.frame.members) do
    local t = self.transformation_of[m]
    if t.kind then table.insert(t.kind == "Linear" and linear or other, t) end
  end
  if #other == 0 then self.frame.model = { displacement = "small" } end
  local t = other[1] or linear[1]
  if not t or not t.place then return end
  notes.add(self.notes.assumed, t.place, t.place.text, #other == 0 and "displacement = 'small' of hinge.model"
    or #linear == 0 and "displacement is large, the default of hinge.model"
    or ("displacement is large for all members: %s Linear, %d PDelta or Corotational"):format(
      #linear == 1 and "1 is" or #linear .. " are", #other))
end

local function add_masses(self)
  for _, node in ipairs(self.frame.nodes) do
    table.insert(self.frame.masses, self.mass_of[node.name])
  end
  for _, row in ipairs(self.more_masses) do table.insert(self.frame.masses, row) end
end

-- Nodes of springs and ties at which no member ends have done what they are for; of the others one note says how many
-- there are. Where elements are not read, these have a note already.
local function drop_lonely(self)
  local reasons = { node = not self.elements_lost and "no member that was read ends at this node" or nil,
    mass = "no member that was read ends at the node of this mass",
    load = "no member that was read ends at the node of this load" }
  frame_module.drop_lonely(self.frame, function(what, row, name)
    local place = self.places[row]
    if place and not self.used[name] and reasons[what] then notes.once(self.notes, place, place.text, reasons[what]) end
  end)
end

-- What hinge takes of supports.
local function write_supports(self)
  for _, node in ipairs(self.frame.nodes) do
    node.fix = frame_module.fix_of(node.fixed)
    node.fixed, node.freedoms = nil, nil
  end
end

-- Motion of the supports, and damping.
local function add_motions(self)
  for _, row in ipairs(self.motions) do
    local any = false
    for _, node in ipairs(self.frame.nodes) do any = any or node.fixed[row.axis] end
    self.place = row.place
    if any then
      table.insert(self.frame.motions, { axis = row.axis, dt = row.dt, acceleration = row.values, scale = row.scale })
    else
      self:not_read "no node is held along the motion of the ground"
    end
  end
  local d = self.damping
  if d.alpha and (d.alpha > 0 or d.beta > 0) then self.frame.damping = { alpha = d.alpha, beta = d.beta } end
end

-- Cases of ground motion alone have no loads.
local function drop_empty_cases(self)
  for i = #self.frame.cases, 1, -1 do
    if #self.frame.cases[i].loads == 0 then table.remove(self.frame.cases, i) end
  end
end

--- Ends the reading: frame, notes.
function Reader:finish()
  models.choose(self)
  if #self.frame.nodes == 0 then
    local why = #self.notes > 0 and "; the first line that was not read: " .. self.notes[1].text
      or not self.command and "; it calls no command of OpenSees: if its functions do, give the file that calls them"
    check.fail("%s: %s has no node that was read%s", self.where, self.frame.source, why or "")
  end
  self.used = {} -- nodes without a member that a spring or a tie has read
  ends.finish(self)
  local joined = frame_module.ends_at(self.frame.members)
  springs.finish(self, joined)
  constraints.finish(self, joined)
  self.spins = {}
  hold_bars(self)
  add_spins(self)
  choose_displacement(self)
  if math.abs(self.mass / self.fitting_mass - 1) > 0.01 then
    notes.add(self.notes.assumed, { file = self.frame.source }, ("units.mass is %.6g kg"):format(self.mass),
      ("the mass that fits the units of force and length is %.6g kg"):format(self.fitting_mass))
  end
  add_masses(self)
  drop_lonely(self)
  add_motions(self)
  drop_empty_cases(self)
  write_supports(self)
  return frame_module.finish(self.frame, self.notes, self.places)
end

local opensees = {}

--- A reader for one script. given: { length =, force =, mass =, time = }, of which mass follows from the others and
--- time is s; wanted: the number of the model in the file, nil: the one at its end.
function opensees.new(where, file, given, wanted)
  local size, fitting = units.sizes(where, given)
  local self = setmetatable({ where = where, length = size.length, force = size.force,
    mass = size.mass, time = size.time, stress = size.force / size.length ^ 2, wanted = wanted, models = 0,
    incomplete = 0, fresh = fresh(file) }, Reader)
  self.fitting_mass = fitting
  self:begin()
  return self
end

return opensees

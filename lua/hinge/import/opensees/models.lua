-- Which model of a script is read: commands of OpenSees that begin a new one (wipe) or take something out of it
-- (remove). What stands at the end is the model. What stands at a wipe, or at an analysis after which something is
-- removed, is another one, which has a number.
local arguments = require "hinge.import.opensees.arguments"
local check = require "hinge.library.check"
local notes = require "hinge.import.notes"

local tag, find = arguments.tag, arguments.find
local commands, removers = {}, {}
local models = {}

-- A copy of tables within tables, each of them once.
local function copy_of(value, done)
  if type(value) ~= "table" then return value end
  if done[value] then return done[value] end
  local copy = setmetatable({}, getmetatable(value))
  done[value] = copy
  for key, item in pairs(value) do copy[copy_of(key, done)] = copy_of(item, done) end
  return copy
end

local function stands(self) return #self.frame.nodes > 0 end

-- The state of the model as it is now.
local function state_of(self)
  local state = { ndm = self.ndm, ndf = self.ndf }
  for key in pairs(self.fresh()) do state[key] = self[key] end
  return state
end

-- wipe: the next command begins a new model. One at the beginning of a file does nothing.
function commands.wipe(self)
  if not stands(self) then return end
  self.models = self.models + 1
  if self.models == self.wanted then
    self.chosen = state_of(self)
  elseif not self.wanted and next(self.element) then
    self.last, self.last_number = state_of(self), self.models
  end
  self:begin()
end

-- What stands at an analysis is a model of its own, if something of it goes afterwards.
local function before_removal(self)
  if not self.analysed then return end
  self.analysed = false
  self.models = self.models + 1
  if self.models == self.wanted then self.chosen = copy_of(state_of(self), {}) end
end

local function drop(list, unwanted)
  for i = #list, 1, -1 do
    if unwanted(list[i]) then table.remove(list, i) end
  end
end

function removers.element(self, name)
  local element = self.element[name]
  self.element[name] = nil
  local function is_it(row) return row == element end
  drop(self.frame.members, is_it)
  drop(self.springs, is_it)
  for _, case in ipairs(self.frame.cases) do drop(case.loads, function(l) return l.member == name end) end
end

function removers.node(self, name)
  local node = self.node[name]
  self.node[name], self.mass_of[name] = nil, nil
  drop(self.frame.nodes, function(row) return row == node end)
  for _, case in ipairs(self.frame.cases) do drop(case.loads, function(l) return l.node == name end) end
end

function removers.loadPattern(self, name)
  local case = self.pattern[name]
  self.pattern[name] = nil
  drop(self.frame.cases, function(row) return row == case end)
  drop(self.motions, function(row) return row.pattern == name end)
  if self.case == case then self.case = nil end
end

-- remove sp node dof <pattern>, or by a tag that OpenSees has given.
function removers.sp(self, name, args)
  if not args[3] then arguments.give_up "a support is known by its node and degree of freedom alone" end
  local node = find(self, "node", name)
  local letter = node.freedoms[tonumber(args[3])]
  if not letter then self:fail("degree of freedom %s of node %s is not there", args[3], name) end
  node.fixed[letter] = nil
end

function removers.mp(self, name)
  local had = #self.ties
  drop(self.ties, function(row) return row.to == name end)
  if #self.ties == had then arguments.give_up("no constraint of node %s was read", name) end
end

function removers.timeSeries(self, name) self.timeSeries[name] = nil end

local aside = { recorder = true, recorders = true, parameter = true, uniaxialMaterial = true, section = true }

-- remove element|node|loadPattern|sp|mp|timeSeries tag
function commands.remove(self, args)
  local what = args[1]
  if aside[what] then return end
  if not removers[what] then return self:not_read(("what is removed as '%s' stays"):format(tostring(what))) end
  local name = tag(self, args[2], "the tag")
  -- what is not there may be removed: OpenSees warns, and a script may `catch` it
  local there = ({ element = self.element, node = self.node, loadPattern = self.pattern })[what]
  if there and not there[name] then return end
  before_removal(self)
  removers[what](self, name, args)
end

-- loadConst <-time t>: what acts by now is held while later patterns act.
function commands.loadConst(self)
  local any = false
  for _, case in ipairs(self.frame.cases) do
    any, case.held = true, true
  end
  if any then
    arguments.assume(self, "loads before loadConst are held at their factor 1 while those of later patterns act")
  end
end

function commands.analyze(self) self.analysed = true end

models.commands = commands

--- Chooses among the models of the file: the state of the reader becomes that of the one that was asked for.
function models.choose(self)
  local at_end = stands(self) and (next(self.element) ~= nil or not self.last)
  if at_end then self.models = self.models + 1 end
  if self.wanted and self.wanted > self.models then
    check.fail("%s: field 'model' is %d; %s has %s", self.where, self.wanted, self.frame.source,
      check.count(self.models, "model"))
  end
  local state, number = self.chosen, self.wanted or self.models
  if not self.wanted and not at_end then state, number = self.last, self.last_number end
  for key, value in pairs(state or {}) do self[key] = value end
  if self.models > 1 then
    notes.add(self.notes.assumed, { file = self.frame.source }, ("%d models, one after the other"):format(self.models),
      ("this is number %d%s; --model N, or the field 'model', gives another one"):format(number,
        number == self.models and ", which stands at the end" or ""))
  end
end

return models

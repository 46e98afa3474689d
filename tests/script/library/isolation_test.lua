-- The module keeps to itself: no globals, models that do not touch each other, and no
-- memory kept of models that are gone.
--
-- Run: lua5.4 tests/script/library/isolation_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "isolation"
local case = checks.case

local function keys(t)
  local list = {}
  for k in pairs(t) do list[#list + 1] = tostring(k) end
  table.sort(list)
  return table.concat(list, " ")
end
local function strings(t)
  local copy = {}
  for k, v in pairs(t) do copy[k] = v end
  return copy
end

local globals, library, loaded = keys(_G), keys(string) .. keys(table) .. keys(math), strings(package.loaded)
local hinge = require "hinge"
case("the module sets no global and changes no library of Lua", function()
  for _, name in ipairs { "models.ten_storey", "models.aircraft", "report", "program.job", "program.runner",
    "render" } do
    require("hinge." .. name)
  end
  checks.equal(keys(_G), globals, "globals after require")
  checks.equal(keys(string) .. keys(table) .. keys(math), library, "Lua's own libraries after require")
  for name in pairs(package.loaded) do
    checks.expect(loaded[name] or name == "hinge" or name:find "^hinge%.", "require loaded %s", name)
  end
  checks.expect(require "hinge" == hinge, "required twice, one module")
end)

-- Models side by side -------------------------------------------------------------------------------------------------

local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 245e6 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
local function chain(members, force)
  local model, nodes = hinge.model(), {}
  for i = 0, members do nodes[i] = model:node { i, 0, 0 } end
  model:fix(nodes[0])
  for i = 1, members do model:member { nodes[i - 1], nodes[i], section = bar, material = steel, group = "chain" } end
  model:load { node = nodes[members], force = { 0, 0, force }, history = function(t) return math.cos(1e3 * t) end }
  model:fracture { curvature_x = 0.03 }
  return model
end
local function dynamic(model) return model:dynamic { dt = 1e-5, duration = 3e-3 } end

local alone = { dynamic(chain(3, -6e4)):finish(), dynamic(chain(5, 4e4)):finish() }
case("runs stepped in turn have the bits of each alone", function()
  local beside = { dynamic(chain(3, -6e4)), dynamic(chain(5, 4e4)) }
  while beside[1]:step() do
    beside[2]:step()
    collectgarbage "step"
  end
  for i = 1, 2 do
    checks.expect(alone[i]:count { state = "yielded" } + alone[i]:count { state = "broken" } > 0,
      "something happens in run %d", i)
    checks.equal(beside[i]:finish().hash, alone[i].hash, "run " .. i .. " beside another")
  end
end)

case("a run does not see members declared after it, and objects that were collected are refused", function()
  local model = chain(2, 1)
  local run, before = dynamic(model), chain(2, 1):counts().members
  model:member { model:node { 9, 0, 0 }, model:node { 9, 1, 0 }, section = bar, material = steel }
  checks.equal(run:count { state = "elastic" }, before, "members of a run, after the model grew")

  -- An object collected by hand, and more than once, is one that nothing takes any more.
  local steps = run:steps()
  for name, object in pairs { run = run, model = model, section = hinge.section.solid { width = 1, depth = 1 } } do
    local collect = debug.getmetatable(object).__gc
    for _ = 1, 3 do collect(object) end
    checks.equal(select(2, pcall(function() return object.x end)):match "index a userdata", "index a userdata",
      "a collected " .. name)
  end
  checks.equal(select(2, pcall(steps)):match "run:steps: .*", "run:steps: the run was collected", "its steps")
end)

-- Memory --------------------------------------------------------------------------------------------------------------

local function resident() -- kB
  return tonumber(support.read "/proc/self/statm":match "%d+ (%d+)") * 4
end

--- A model whose rule and load refer to the model itself, to a run of it and to what it holds.
local function entangled(members, elements, force)
  local m, nodes, made = hinge.model { elements_per_member = elements }, {}, nil
  for i = 0, members do nodes[i] = m:node { i, 0, 0 } end
  m:fix(nodes[0])
  local last
  for i = 1, members do last = m:member { nodes[i - 1], nodes[i], section = bar, material = steel, group = "chain" } end
  local called = 0
  m:load { node = nodes[members], force = { 0, 0, force }, history = function()
    called = called + 1
    return made and nodes[members].index == members + 1 and made.index >= 0 and 1 or 0
  end }
  m:fracture(function()
    called = called + 1
    return m:counts().members ~= last.index
  end)
  made = m:dynamic { dt = 1e-5, duration = 1e-3 }
  made:step()
  return m, made, nodes[1], last, m:group "chain", function() return called end
end

local function collect()
  collectgarbage()
  collectgarbage()
end

case("memory is bounded by what is declared, not by how often", function()
  local names = { "model", "run", "node", "member", "group" }
  local weak = setmetatable({ entangled(2, 2, -6e4) }, { __mode = "v" })
  collect()
  for i, name in ipairs(names) do
    checks.expect(weak[i] == nil, "a %s that only its own model's functions refer to is collected", name)
  end

  -- whatever is held keeps the functions that it may call
  local function one_of(all, i) return all[i], all[6] end
  for i, name in ipairs(names) do
    local kept, called = one_of({ entangled(2, 2, -6e4) }, i)
    collect()
    local calls = called()
    checks.expect(calls > 0, "the functions of a model are called")
    if name == "run" then
      kept:finish()
      checks.expect(called() > calls, "a run alone keeps its model's functions")
    elseif name == "model" then
      kept:dynamic { dt = 1e-5, duration = 1e-4 }:finish()
      checks.expect(called() > calls, "a model alone keeps its functions")
    end
    checks.expect(tostring(kept):find(name, 1, true), "a %s outlives the others: %s", name, tostring(kept))
  end

  -- a function goes with the rule that a call in error did not make
  local m = hinge.model()
  local function count_kept()
    local kept = setmetatable({}, { __mode = "k" })
    for _ = 1, 100 do
      local history = function() return 1 end
      kept[history] = true
      pcall(m.load, m, { node = m:node { 0, 0, 0 }, force = { 1, 0, 0 }, history = history, wrong = true })
    end
    collect()
    local n = 0
    for _ in pairs(kept) do n = n + 1 end
    return n
  end
  checks.equal(count_kept(), 0, "functions kept of loads that were refused")
end)

case("a thousand models, each run for a step and dropped, leave no memory behind", function()
  -- A thousand models, each run for a step and dropped. Lua may keep 10 kB in all once everything is collected, the
  -- process 16 MB, as much as may lie about uncollected meanwhile (a thousand are 80 to 160 MB).
  -- And while nobody asks Lua to collect, models of 10 MB each, of which Lua sees a kilobyte, may
  -- take 150 MB at a time, not 1 GB.
  local function make(n, what)
    for _ = 1, n do what() end
    collect()
    return collectgarbage "count", resident()
  end
  for what, one in pairs {
    ["limits"] = function()
      local m = chain(20, 1)
      m:load { node = m:nodes()[21], force = { 0, 0, 1 } }
      m:static { steps = 1 }:finish()
      m:dynamic { dt = 1e-5, duration = 1e-4 }:step()
    end,
    ["functions that refer to their model and run"] = function() entangled(20, 2, -6e4) end,
  } do
    make(200, one)
    local count, size = make(100, one)
    local count_after, size_after = make(1000, one)
    print(("1000 models with %s: Lua %+.1f kB, process %+d kB"):format(what, count_after - count, size_after - size))
    checks.expect(count_after - count < 10, "Lua keeps %.1f kB of 1000 models with %s", count_after - count, what)
    checks.expect(size_after - size < 16e3, "the process keeps %d kB of 1000 models with %s", size_after - size, what)
  end
end)

case("a hundred large models one after the other take the memory of one", function()
  collect()
  local size, most = resident(), 0
  for _ = 1, 100 do
    entangled(1, 4000, 1)
    most = support.largest_of(most, resident() - size)
  end
  print(("100 models of 4000 elements: at most %d kB at a time"):format(most))
  checks.expect(most < 150e3, "100 models of 4000 elements take %d kB at a time", most)
end)

checks.done()

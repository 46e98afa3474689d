-- The module keeps to itself: no globals, models that do not touch each other, and no memory kept of models that are gone.
--
-- Run: lua5.4 tests/script/isolation_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
local support = require "support"
local checks = support.checks "isolation"

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
for _, name in ipairs { "models.ten_storey", "models.aircraft", "report", "job", "runner", "render" } do require("hinge." .. name) end
checks.equal(keys(_G), globals, "globals after require")
checks.equal(keys(string) .. keys(table) .. keys(math), library, "Lua's own libraries after require")
for name in pairs(package.loaded) do
  checks.expect(loaded[name] or name == "hinge" or name:find "^hinge%.", "require loaded %s", name)
end
checks.expect(require "hinge" == hinge, "required twice, one module")

-- Models side by side -------------------------------------------------------------------------------------------------

local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 245e6 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
local function chain(members, force, rule)
  local model, nodes = hinge.model(), {}
  for i = 0, members do nodes[i] = model:node { i, 0, 0 } end
  model:fix(nodes[0])
  for i = 1, members do model:member { nodes[i - 1], nodes[i], section = bar, material = steel, group = "chain" } end
  model:load { node = nodes[members], force = { 0, 0, force }, history = function(t) return math.cos(1e3 * t) end }
  model:fracture(rule and rule(model) or { curvature_x = 0.03 })
  return model
end
local function dynamic(model) return model:dynamic { dt = 1e-5, duration = 3e-3 } end

local alone = { dynamic(chain(3, -6e4)):finish(), dynamic(chain(5, 4e4)):finish() }
local beside = { dynamic(chain(3, -6e4)), dynamic(chain(5, 4e4)) }
while beside[1]:step() do
  beside[2]:step()
  collectgarbage "step"
end
for i = 1, 2 do
  checks.expect(alone[i]:count { state = "yielded" } + alone[i]:count { state = "broken" } > 0, "something happens in run %d", i)
  checks.equal(beside[i]:finish().hash, alone[i].hash, "run " .. i .. " beside another")
end
local model = chain(2, 1)
local run, before = dynamic(model), chain(2, 1):counts().members
model:member { model:node { 9, 0, 0 }, model:node { 9, 1, 0 }, section = bar, material = steel }
checks.equal(run:count { state = "elastic" }, before, "members of a run, after the model grew")

-- Memory --------------------------------------------------------------------------------------------------------------

local function resident() -- kB
  return tonumber(support.read "/proc/self/statm":match "%d+ (%d+)") * 4
end
local rules = {
  limits = false,
  ["a function"] = function() return function() return false end end,
}
for what, rule in pairs(rules) do
  local function make(n)
    for _ = 1, n do
      local m = chain(20, 1, rule)
      m:static { steps = 1 }:finish()
      m:dynamic { dt = 1e-5, duration = 1e-4 }:step()
    end
    collectgarbage()
    collectgarbage()
    return collectgarbage "count", resident()
  end
  make(200)
  local count, size = make(100)
  local count_after, size_after = make(1000)
  print(("1000 models, fracture by %s: Lua %+.1f kB, process %+d kB"):format(what, count_after - count, size_after - size))
  checks.expect(count_after - count < 10, "Lua keeps %.1f kB of 1000 models (%s)", count_after - count, what)
  checks.expect(size_after - size < 3000, "the process keeps %d kB of 1000 models (%s)", size_after - size, what)
end

checks.done()

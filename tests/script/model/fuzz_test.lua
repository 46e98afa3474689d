-- Random calls with random arguments: every one returns or raises an error that is a text;
-- nothing crashes, hangs or leaks.
--
-- Run: lua5.4 tests/script/model/fuzz_test.lua [calls] [seed], with the module on LUA_CPATH; the last call is in
-- HINGE_FUZZ_LOG, if that is set
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "fuzz"
local case = checks.case

local calls, seed = tonumber(arg[1]) or 30000, math.tointeger(tonumber(arg[2]) or 1)
math.randomseed(seed)
local log = os.getenv "HINGE_FUZZ_LOG"
local random = math.random
local function pick(list) return list[random(#list)] end

-- What has been made so far, to be used again as arguments and receivers.
local made = {}
local function keep(...)
  for _, v in ipairs { ... } do
    if type(v) == "userdata" then
      if #made < 60 then made[#made + 1] = v else made[random(60)] = v end
    end
  end
end

local numbers = { 0, 1, -1, 2, 3, 4, 0.5, 1e-3, 0.3, 10, 1e3, -0.0, 0 / 0, math.huge, -math.huge, 1e308, 1e-308, 2 ^ 53,
  math.mininteger, math.maxinteger, 206e9, 7850 }
local words = { "", "all", "xyz", "ux", "rz", "frame", "asi-gauss", "asi", "cubic", "auto", "explicit", "newmark",
  "surface", "gap", "time", "plastic", "arc", "load", "nonsense", ("x"):rep(300), "\0", "N", "f_y", "node_x", "broken",
  "elastic", "large", "small", "direct", "cg", "single" }
local fields = { "node", "force", "moment", "history", "group", "groups", "between", "section", "material", "up",
  "elements", "E", "nu", "G", "density", "yield_stress", "width", "depth", "diameter", "thickness", "dt", "duration",
  "from", "steps", "control", "fixed_group", "rule", "where", "keep", "pairs", "on_contact", "stiffness", "friction",
  "curvature_x", "axial_strain", "formulation", "displacement", "mass", "elements_per_member", "record", "integrator",
  "beta", "iterations", "threads", "solver", "to", "x", "z", "state", "name", "energy_tolerance", "precision", "rest",
  "tolerance", "as_printed", "area", "Ix", "Iy", "J", "shear_area_x", "shear_area_y" }
local functions = { function() end, function() return 1, 2, 3 end, function() return true end, function() return {} end,
  function() error "mine" end, function(v) return v and v.nonsense end, function() coroutine.yield() end,
  function() return 0 / 0 end }

local value
local function table_of(depth)
  local t = {}
  for _ = 1, random(0, 4) do t[#t + 1] = value(depth - 1) end
  for _ = 1, random(0, 5) do t[pick(fields)] = value(depth - 1) end
  return t
end
function value(depth)
  local kind = random(12)
  if kind <= 3 then return pick(numbers)
  elseif kind == 4 then return pick(words)
  elseif kind == 5 then return { pick(numbers), pick(numbers), pick(numbers) }
  elseif kind == 6 then return random() < 0.5
  elseif kind == 7 then return pick(functions)
  elseif kind == 8 then return nil
  elseif kind <= 10 and #made > 0 then return pick(made)
  elseif depth > 0 then return table_of(depth)
  end
  return pick(words)
end

case("random calls return or raise a text, and nothing crashes", function()
  -- Now and then something that is right, so that calls get beyond the first complaint.
  local steel, square = hinge.material { E = 206e9, density = 7850, yield_stress = 245e6 },
    hinge.section.solid { width = 0.05, depth = 0.05 }
  local function scene()
    local model = hinge.model { elements_per_member = 2, formulation = pick { "asi-gauss", "asi", "conventional" } }
    local a, b, c = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }, model:node { 1, 0.2, 1 }
    local m = model:member { a, b, section = square, material = steel, group = "frame" }
    model:member { b, c, section = square, material = steel, up = { 1, 0, 0 } }
    model:fix(a)
    if random() < 0.5 then model:load { node = c, force = { 1e4 * random(), 1e3, -1e4 } } end
    if random() < 0.3 then model:contact {} end
    if random() < 0.3 then model:fracture(pick(functions)) end
    local run = random() < 0.5 and model:dynamic { dt = 1e-4, duration = 1e-2, record = false }
      or model:static { steps = 3, record = false }
    keep(model, a, b, c, m, model:group "frame", run, steel, square)
  end

  local methods = {}
  local function add(receiver, list) for name in list:gmatch "%S+" do methods[#methods + 1] = { receiver, name } end end
  add("hinge", "model material")
  add("section", "box h pipe solid round general")
  add("any", "node member fix load move gravity velocity fracture contact group counts static dynamic nodes members "
    .. "groups loads close step stop on_step probe displacement velocity acceleration reaction position forces state "
    .. "read momentum remove count hash energy time verdict fastest stages reason contacts probes state_changes "
    .. "nonsense __gc __index __eq __tostring __len __pairs")

  local before, ran, failed = collectgarbage "count", 0, 0
  for i = 1, calls do
    if i % 40 == 1 then scene() end
    if i % 5000 == 0 then made = {} collectgarbage() end
    local what, arguments = pick(methods), {}
    local count = random(0, 3)
    for k = 1, count do arguments[k] = value(3) end
    if random() < 0.3 then arguments[1], count = table_of(3), math.max(1, count) end
    if log then
      local f = assert(io.open(log, "w"))
      f:write(("seed %d call %d: %s %s %s\n"):format(seed, i, what[1], what[2], tostring(arguments[1])))
      f:close()
    end
    local ok, problem
    if what[1] == "any" then
      local receiver = pick(made)
      if random() < 0.1 then ok, problem = pcall(tostring, receiver)
      elseif random() < 0.05 then ok, problem = pcall(function() receiver[pick(fields)] = value(1) end)
      else
        ok, problem = pcall(function()
          local method = receiver[what[2]]
          if type(method) == "function" then
            keep(method(random() < 0.9 and receiver or value(1), table.unpack(arguments, 1, count)))
          end
        end)
      end
    else
      local holder = what[1] == "hinge" and hinge or hinge.section
      ok, problem = pcall(function() keep(holder[what[2]](table.unpack(arguments, 1, count))) end)
    end
    ran = ran + 1
    if not ok then
      failed = failed + 1
      local text = type(problem) == "string" and problem or problem ~= nil and tostring(problem)
      checks.expect(text and #text > 0 and #text < 5000, "call %d, %s: the error is %s", i, what[2], tostring(problem))
    end
  end
  made = {}
  collectgarbage() collectgarbage()
  checks.expect(failed > 0.2 * ran and failed < ran, "%d of %d calls were refused", failed, ran)
  checks.expect(collectgarbage "count" < before + 2000,
    "memory of Lua grew from %.0f to %.0f kB", before, collectgarbage "count")
end)

checks.done()

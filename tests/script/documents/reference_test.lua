-- The declarations in lua/hinge/words say what there is, no more and no less: functions, methods, fields and options,
-- both ways; and `hinge reference` prints them.
--
-- Run: lua5.4 tests/script/documents/reference_test.lua BUILD_FOLDER, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local reference = require "hinge.program.reference"
local with = require "scenes".with
local checks = support.checks "reference"
local case, expect, equal = checks.case, checks.expect, checks.equal

local classes, functions, modules, own = {}, {}, {}, {}
do
  local module, file = nil, nil
  for _, e in ipairs(reference.read()) do
    local here = e.line:match "^[^:]*"
    if here ~= file then module, file = "hinge", here end
    if e.kind == "heading" then module = e.module or module end
    if e.kind == "class" then classes[e.name], e.fields.of = e, e end
    if e.kind == "function" then
      functions[#functions + 1] = e
      own[e.object] = own[e.object] or {}
      own[e.object][e.name] = e
      if e.separator == "." and module and module ~= "hinge" then modules[module] = e.object end
    end
  end
end

local function set(list)
  local names = {}
  for _, name in ipairs(list) do names[name] = true end
  return names
end
local function sorted(names)
  local list = {}
  for name in pairs(names) do list[#list + 1] = name end
  table.sort(list)
  return list
end
-- `declared` and `there` have the same names. Each that has not says what to write where.
local function same(declared, there, missing, extra)
  for _, name in ipairs(sorted(there)) do expect(declared[name], missing, name) end
  for _, name in ipairs(sorted(declared)) do expect(there[name], extra, name) end
end
local function file_of(class)
  return "lua/hinge/" .. (classes[class] and classes[class].line:match "^[^:]*" or "hinge.d.lua")
end

-- Modules: tables of functions and other values -----------------------------------------------------------------------

local function fields_of(class)
  local names = {}
  for _, field in ipairs(classes[class].fields) do names[field.name] = field end
  return names
end
local function agrees_with_table(class, value, name)
  local declared = fields_of(class)
  for called in pairs(own[class] or {}) do declared[called] = true end
  local there = {}
  for key in pairs(value) do there[key] = true end
  local missing = ("%s.%%s is not declared: add `---@field <name> <type> ...` to `---@class %s`, "
    .. "or `function %s.<name>(...) end`, in %s"):format(name, class, name:match "[%w_]*$", file_of(class))
  local extra = ("%s declares %s.%%s, which there is not: take it out, or export it"):format(file_of(class), name)
  same(declared, there, missing, extra)
end
case("every module of the library is declared", function()
  agrees_with_table("hinge", hinge, "hinge")
  agrees_with_table("hinge.sections", hinge.section, "hinge.section")
  local count = 0
  for module, class in pairs(modules) do
    count = count + 1
    agrees_with_table(class, require(module), module)
  end
  equal(count, 6, "modules with functions of their own in lua/hinge/words")
end)

-- Objects: methods and fields -----------------------------------------------------------------------------------------

local function scene()
  local s = { model = hinge.model { displacement = "small" } }
  s.steel = hinge.material { E = 206e9, density = 7850, yield_stress = 245e6 }
  s.bar = hinge.section.solid { width = 0.05, depth = 0.05 }
  s.backbone = hinge.backbone { points = { { 0, 1 }, { 0.1, 0.5 } }, wear = 1 }
  s.wall, s.tip = s.model:node { 0, 0, 0 }, s.model:node { 1, 0, 0 }
  s.model:fix(s.wall)
  s.member = s.model:member { s.wall, s.tip, section = s.bar, material = s.steel, group = "arm",
    backbone = s.backbone, release = { a = "Mx" } }
  s.joint = hinge.joint { Mx = "free" }
  s.group = s.model:group "arm"
  s.load = s.model:load { node = s.tip, force = { 0, 0, -1 } }
  s.case = s.model:case "live"
  s.connector = s.model:connector { s.tip, ground = true, stiffness = { x = 1 } }
  local post, here, there = s.model:node { 0, 0, 5 }, s.model:node { 1, 0, 5 }, s.model:node { 1, 0, 5 }
  s.model:fix(post)
  s.model:member { post, here, section = s.bar, material = s.steel }
  s.model:member { there, s.model:node { 2, 0, 5 }, section = s.bar, material = s.steel }
  s.node_joint = s.model:joint { here, there, joint = hinge.joint { Mx = { stiffness = 1e6 } } }
  local edge = { s.model:node { 5, 0, 0 }, s.model:node { 6, 0, 0 }, s.model:node { 6, 1, 0 } }
  s.model:fix(edge, "xyz")
  s.panel = s.model:panel { edge[1], edge[2], edge[3], thickness = 0.01, material = s.steel }
  s.panel_contact = s.model:panel_contact {}
  s.edge = edge
  s.model:damping { alpha = 1 }
  s.model:ground { point = { 0, 0, -9 } }
  s.model:prestress { member = s.member, strain = 1e-6 }
  s.run = s.model:dynamic { dt = 1e-4, duration = 1e-3, loads = {} }
  s.probe = s.run:probe { node = s.tip, "uz" }
  s.snapshot = s.run:snapshot()
  s.grid = hinge.grid { model = hinge.model(), x = { 0, 1 }, z = { 0, 1 } }
  return s
end
local s = scene()
s.run:finish()
s.mode = s.run:modes({ n = 1 })[1]
s.table = hinge.results.members(s.run)
do -- a benchmark's object, without what it prints
  local say = print
  rawset(_G, "print", function() end)
  hinge.benchmark({ title = "t", kind = "elastic", source = "s", run = function(b) s.benchmark = b end })
    .run({}, { verdict = function() end })
  rawset(_G, "print", say)
end
local objects = { ["hinge.material"] = s.steel, ["hinge.section"] = s.bar, ["hinge.backbone"] = s.backbone,
  ["hinge.joint"] = s.joint, ["hinge.mode"] = s.mode,
  ["hinge.model"] = s.model,
  ["hinge.node"] = s.wall, ["hinge.member"] = s.member, ["hinge.group"] = s.group, ["hinge.run"] = s.run,
  ["hinge.probe"] = s.probe, ["hinge.load"] = s.load, ["hinge.case"] = s.case, ["hinge.snapshot"] = s.snapshot,
  ["hinge.connector"] = s.connector, ["hinge.node_joint"] = s.node_joint, ["hinge.grid"] = s.grid,
  ["hinge.panel"] = s.panel, ["hinge.panel_contact"] = s.panel_contact }

case("every object has the fields and methods that its declared type names", function()
  -- A value has the fields that its declared type names; { ... }[] and lists of a class are
  -- looked at by their first item.
  local function agrees(value, kind, what)
    if kind:find "%[%]$" then value, kind = type(value) == "table" and value[1], kind:sub(1, -3) end
    local declared = reference.fields(kind)
    if not declared and classes[kind] and type(value) == "table" then declared = classes[kind].fields end
    if not declared or type(value) ~= "table" then return end
    local names, there = {}, {}
    for _, field in ipairs(declared) do names[field.name] = true end
    for key in pairs(value) do there[key] = true end
    same(names, there, what .. " has '%s', which its type does not name",
      what .. " is declared with '%s', which it has not")
  end

  for name, meta in pairs(debug.getregistry()) do
    if type(name) == "string" and name:find "^hinge%." and type(meta) == "table" and meta.methods then
      local object = objects[name]
      if expect(classes[name], "%s is not declared: add `---@class %s` to lua/hinge/words", name, name)
        and expect(object, "this test has no %s to look at: add one to `objects`", name) then
        local short = name:match "%w+$"
        local there = {}
        for method in pairs(meta.methods) do there[method] = true end
        local missing = ("%s:%%s is not declared: add `function %s:...(...) end` with its `---@param` lines under "
          .. "`---@class %s` in %s"):format(short, short, name, file_of(name))
        same(own[name] or {}, there, missing, ("%s declares %s:%%s, which there is not"):format(file_of(name), short))
        local declared = fields_of(name)
        missing = ("%s.%%s is not declared: add `---@field <name> <type> ...` to `---@class %s` in %s")
          :format(short, name, file_of(name))
        local extra = ("%s declares %s.%%s, which name_fields in src/script/bind/bind_*.cpp does not name")
          :format(file_of(name), short)
        same(declared, set(meta.fields or {}), missing, extra)
        for field, about in pairs(declared) do
          local ok, value = pcall(function() return object[field] end)
          if expect(ok, "%s.%s: %s", short, field, tostring(value)) and ok then
            expect(value ~= nil or about.optional, "%s.%s is nil: declare it as `---@field %s? ...`", short, field,
              field)
            agrees(value, about.type, short .. "." .. field)
          end
        end
        if meta.fields then
          local ok, message = pcall(function() return object["no such field"] end)
          expect(not ok and message:find "no such field", "%s gives a field that there is not", short)
        end
      end
    end
  end
  for name, value in pairs { ["hinge.model counts"] = s.model:counts(), ["hinge.run momentum"] = s.run:momentum() } do
    local f = own[name:match "%S+"][name:match "%a+$"]
    if f then agrees(value, f.returns[1]:match "^{.-}", reference.signature(f)) end
  end
end)

-- The job is a Lua object.
local job = require "hinge.program.job".new("", "II")
case("the job has the methods that are declared", function()
  local methods = {}
  local all = getmetatable(job).__index -- a script in the sandbox cannot reach it
  for method in pairs(all) do
    if not method:find "^__" then methods[method] = true end
  end
  same(own["hinge.job"], methods, "job:%s is not declared: add `function job:...(...) end` to "
    .. "lua/hinge/words/scenarios.d.lua", "words/scenarios.d.lua declares job:%s, which there is not")
  same(fields_of "hinge.job", set { "out", "case", "notes" },
    "job.%s is not declared: add `---@field` to `---@class hinge.job`",
    "words/scenarios.d.lua declares job.%s, which there is not")
end)

-- Options -------------------------------------------------------------------------------------------------------------

local building, aircraft = require "hinge.models.ten_storey", require "hinge.models.aircraft"
local space_frame = require "hinge.models.space_frame"
-- How a call with a table of options is made, whole and with the fields of `x`, where it takes more than that table
-- (call_of). A table within is `call.field`.
local square = { width = 0.1, depth = 0.1 }
local record_file = os.tmpname()
support.write(record_file, "0 0\n0.1 1\n0.2 0\n")
local calls = {
  ["hinge.material"] = function(x) hinge.material(with({ E = 1 }, x)) end,
  ["grid:line"] = function(x) s.grid:line(with({ "A1, base", "A1, storey 1" }, x)) end,
  ["run:probe"] = function(x) s.run:probe(with({ node = s.tip, "uz" }, x)) end,
  ["run:count"] = function(x) s.run:count(with({ state = "broken" }, x)) end,
  ["any_material:with"] = function(x) hinge.material({ E = 1 }):with(x) end,
  ["hinge.material.hardening"] = function(x) hinge.material { E = 1, yield_stress = 1, hardening = x } end,
  ["hinge.material.rate"] = function(x) hinge.material { E = 1, yield_stress = 1, rate = x } end,
  ["model:joint.axes"] = function(x) s.model:joint { s.wall, s.model:node { s.wall.x, s.wall.y, s.wall.z },
    joint = s.joint, axes = x } end,
  ["benchmark:row"] = function(x) s.benchmark:row(with({ "sag" }, x)) end,
  ["any_table:csv"] = function(x) s.table:csv("none.csv", x) end,
  ["hinge.section.box"] = function(x) hinge.section.box(with({ thickness = 0.01 }, with(x, square))) end,
  ["hinge.section.named"] = function(x) hinge.section.named("HEB 300", x) end,
  ["hinge.section.concrete"] = function(x) hinge.section.concrete(with(x, square)) end,
  ["hinge.section.general.reinforcement"] = function(x)
    hinge.section.general { area = 0.01, Ix = 1, Iy = 1, J = 1, reinforcement = x,
      outline = { { corners = { { 0, 0 }, { 0.1, 0 }, { 0.1, 0.1 }, { 0, 0.1 } } } } }
  end,
  ["hinge.section.general.plastic"] = function(x)
    hinge.section.general { area = 1, Ix = 1, Iy = 1, J = 1, plastic = x }
  end,
  ["hinge.section.general.size"] = function(x)
    hinge.section.general { area = 1, Ix = 1, Iy = 1, J = 1, size = with(x, square) }
  end,
  ["hinge.study"] = function(x) hinge.study(hinge.scenario { parameters = { dt = 1 }, run = function() end }, x) end,
  ["hinge.cost"] = function(x) hinge.cost(hinge.scenario { parameters = { dt = 1 }, run = function() end }, x) end,
  ["explosion:load"] = function(x)
    local explosion = hinge.blast { charge = 100, at = { -10, 0, 0 } }
    explosion:load(s.model, with({ members = { s.member }, normal = { 0, -1, 0 }, width = 1 }, x))
  end,
  ["model:defaults"] = function(x) hinge.model():defaults(x) end,
  ["model:static.control"] = function(x)
    s.model:static { control = with({ node = s.tip, "ux", to = 1 }, x), loads = {} }
  end,
  ["job:strip"] = function(x) job:strip({ { s.run, x } }, 1, "x.png") end,
  ["ten_storey.add"] = function(x) building.add(hinge.model(), x) end,
  ["aircraft.add"] = function(x) aircraft.add(hinge.model(), x) end,
  ["aircraft.add.shape"] = function(x) aircraft.add(hinge.model(), { shape = x }) end,
  ["space_frame.add"] = function(x) space_frame.add(hinge.model(), x) end,
}
for name, of in pairs { steel = "S355", aluminium = "6082-T6", timber = "C24", concrete = "C30/37", bars = "B500B" } do
  calls["hinge.material." .. name] = function(x) hinge.material[name](of, x) end
end
for _, name in ipairs { "utilisation", "members", "storeys", "base" } do
  calls["hinge.results." .. name] = function(x) hinge.results[name](s.run, x) end
end
for _, field in ipairs { "axes", "stiffness", "damping", "curve", "law", "capacity" } do
  calls["model:connector." .. field] = function(x) s.model:connector { s.tip, ground = true, [field] = x } end
end
for _, field in ipairs { "concrete", "reinforcement", "deck" } do
  calls["model:panel." .. field] = function(x)
    s.model:panel { s.edge[1], s.edge[2], s.edge[3], [field] = x }
  end
end
for name, args in pairs { picture = { s.run, "x.png" }, plot = { s.run, "x.png" }, animate = { s.mode } } do
  calls["job:" .. name] = function(x) job[name](job, args[1], x, args[2]) end
  calls["hinge." .. name] = function(x) hinge[name](args[1], x, args[2]) end
end
-- The call that a name says: hinge.section.box(x), s.model:load(x).
local function call_of(what)
  if calls[what] then return calls[what] end
  local path, separator, name = what:match "^(.*)([.:])([%w_]+)$"
  local owner = path:find "^hinge" and hinge or s[path:match "%w+$"]
  for part in path:gmatch "%.([%w_]+)" do owner = owner and owner[part] end
  if not owner then return nil end
  return function(x) if separator == ":" then owner[name](owner, x) else owner[name](x) end end
end
-- Functions whose tables are data, or may hold any field.
local free = set { "hinge.combinations", -- which takes some fields with one standard alone
  "hinge.import.build", "hinge.import.write",
  "envelope:plot", "used:plot", "floors:plot", -- after a job and a file's name
  "impact.parameters", "impact.with", "impact.add", "impact.damage", "impact.simulate",
  "impact.side_by_side", "paper.figure" }

-- The fields that a complaint about the field "zzz" names.
local function taken(call)
  local ok, message = pcall(call, { zzz = 1 })
  local list = not ok and tostring(message):match "unknown field 'zzz'.-; it takes ([^\n]*)"
    or not ok and tostring(message):match "unknown field 'zzz'.-; there are ([^\n]*)"
  if not list then return nil, ok and "it takes any field" or tostring(message) end
  local names = {}
  for name in list:gmatch "[%w_]+" do names[name] = true end
  return names
end
local function looks_like_options(kind)
  return reference.fields(kind) or classes[kind] and #classes[kind].fields > 0 and not objects[kind]
    and kind ~= "hinge.job" and classes[kind].fields
end
local used = {}
local function compare(what, fields, line)
  local call = call_of(what)
  if not expect(call, "%s takes options (%s): add how it is called to `calls` of this test", what, line) then return end
  used[what] = true
  local there, why = taken(call)
  if not expect(there, "%s: does not name its fields: %s", what, tostring(why)) then return end
  there.internals = nil -- of model:dynamic, for tests: tests/README.md
  local declared, base = {}, classes[fields.of and fields.of.base]
  for _, field in ipairs(base and base.fields or {}) do
    if not field.name:find "^%[" then declared[field.name] = true end
  end
  for _, field in ipairs(fields) do
    if not field.name:find "^%[" then declared[field.name] = true end
    local inner = looks_like_options(field.type:match "|({.*})$" or field.type:match "^([%w_.]+)|[%w_.]+%[%]$"
      or field.type)
    if inner and calls[what .. "." .. field.name] then compare(what .. "." .. field.name, inner, line) end
  end
  same(declared, there, ("%s takes '%%s', which is not declared: add it in lua/hinge/%s"):format(what, line),
    ("lua/hinge/%s declares '%%s' of %s, which it does not take"):format(line, what))
end
case("every call takes the options that are declared, and no others", function()
  for _, f in ipairs(functions) do
    local what = reference.signature(f):match "^[^(]*"
    for _, param in ipairs(f.params) do
      local fields = looks_like_options(param.type:match "^(%b{})|fun" or param.type:match "^([%w_.]+)|fun"
        or param.type)
      if fields and not free[what] then compare(what, fields, param.line) end
    end
  end
  used["job:strip"] = true
  -- A plot is one of several kinds of table.
  local plots = {
    ["hinge.plot"] = function(x) hinge.plot(with({ series = {} }, x), "x.png") end,
    ["hinge.panels"] = function(x) hinge.plot(with({ panels = {} }, x), "x.png") end,
    ["hinge.series"] = function(x) hinge.plot({ series = { x } }, "x.png") end,
    ["hinge.plot_line"] = function(x) hinge.plot({ series = {}, lines = { x } }, "x.png") end,
  }
  for class, call in pairs(plots) do
    calls["table " .. class] = call
    if expect(classes[class], "no class %s", class) then
      compare("table " .. class, classes[class].fields, classes[class].line)
    end
  end
  for what in pairs(calls) do expect(used[what], "`calls` of this test has %s, which declares no options", what) end
end)

-- The page ------------------------------------------------------------------------------------------------------------

case("hinge reference prints the declarations as a page", function()
  local page = reference.page()
  local program = support.quote(arg[1] .. "/hinge")
  local status, printed = support.run(program .. " reference")
  expect(status == 0 and printed == page, "hinge reference prints the page: status %s", status)
end)

checks.done()

-- The declarations in lua/hinge/words say what there is, no more and no less: functions, methods, fields and options,
-- both ways; and `hinge reference` prints them.
--
-- Run: lua5.4 tests/script/documents/reference_test.lua BUILD_FOLDER, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local reference = require "hinge.program.reference"
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
  s.model:damping { alpha = 1 }
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
  ["hinge.connector"] = s.connector, ["hinge.node_joint"] = s.node_joint, ["hinge.grid"] = s.grid }

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
local function with(options, more)
  for k, v in pairs(more) do options[k] = v end
  return options
end
-- How each call with a table of options is made: whole, and with the fields of `x`. A table within is `call.field`.
local square = { width = 0.1, depth = 0.1 }
local record_file = os.tmpname()
support.write(record_file, "0 0\n0.1 1\n0.2 0\n")
local calls = {
  ["hinge.model"] = function(x) hinge.model(x) end,
  ["hinge.material"] = function(x) hinge.material(with({ E = 1 }, x)) end,
  ["any_material:with"] = function(x) hinge.material({ E = 1 }):with(x) end,
  ["hinge.material.hardening"] = function(x) hinge.material { E = 1, yield_stress = 1, hardening = x } end,
  ["hinge.material.rate"] = function(x) hinge.material { E = 1, yield_stress = 1, rate = x } end,
  ["hinge.backbone"] = function(x) hinge.backbone(x) end,
  ["hinge.joint"] = function(x) hinge.joint(x) end,
  ["hinge.pressure"] = function(x) hinge.pressure(x) end,
  ["hinge.moving_load"] = function(x) hinge.moving_load(x) end,
  ["hinge.moving_load.influence"] = function(x) hinge.moving_load.influence(x) end,
  ["hinge.joint.end_plate"] = function(x) hinge.joint.end_plate(x) end,
  ["hinge.joint.fin_plate"] = function(x) hinge.joint.fin_plate(x) end,
  ["hinge.joint.web_cleats"] = function(x) hinge.joint.web_cleats(x) end,
  ["hinge.joint.panel_zone"] = function(x) hinge.joint.panel_zone(x) end,
  ["model:joint"] = function(x) s.model:joint(with({ s.wall, s.tip }, x)) end,
  ["model:joint.axes"] = function(x) s.model:joint { s.wall, s.model:node { s.wall.x, s.wall.y, s.wall.z },
    joint = s.joint, axes = x } end,
  ["hinge.joint.base_plate"] = function(x) hinge.joint.base_plate(x) end,
  ["hinge.benchmark"] = function(x) hinge.benchmark(x) end,
  ["benchmark:row"] = function(x) s.benchmark:row(with({ "sag" }, x)) end,
  ["hinge.results.envelope"] = function(x) hinge.results.envelope(with({ s.run }, x)) end,
  ["hinge.results.utilisation"] = function(x) hinge.results.utilisation(s.run, x) end,
  ["hinge.results.members"] = function(x) hinge.results.members(s.run, x) end,
  ["hinge.results.storeys"] = function(x) hinge.results.storeys(s.run, x) end,
  ["hinge.results.base"] = function(x) hinge.results.base(s.run, x) end,
  ["any_table:text"] = function(x) s.table:text(x) end,
  ["any_table:markdown"] = function(x) s.table:markdown(x) end,
  ["any_table:latex"] = function(x) s.table:latex(x) end,
  ["any_table:csv"] = function(x) s.table:csv("none.csv", x) end,
  ["run:modes"] = function(x) s.run:modes(x) end,
  ["run:buckling"] = function(x) s.run:buckling(x) end,
  ["hinge.backbone.lignos"] = function(x) hinge.backbone.lignos(x) end,
  ["hinge.backbone.nist"] = function(x) hinge.backbone.nist(x) end,
  ["hinge.backbone.asce41"] = function(x) hinge.backbone.asce41(x) end,
  ["hinge.backbone.ufc"] = function(x) hinge.backbone.ufc(x) end,
  ["hinge.section.box"] = function(x) hinge.section.box(with({ thickness = 0.01 }, with(x, square))) end,
  ["hinge.section.h"] = function(x) hinge.section.h(x) end,
  ["hinge.material.steel"] = function(x) hinge.material.steel("S355", x) end,
  ["hinge.material.aluminium"] = function(x) hinge.material.aluminium("6082-T6", x) end,
  ["hinge.material.timber"] = function(x) hinge.material.timber("C24", x) end,
  ["hinge.material.concrete"] = function(x) hinge.material.concrete("C30/37", x) end,
  ["hinge.material.bars"] = function(x) hinge.material.bars("B500B", x) end,
  ["hinge.section.named"] = function(x) hinge.section.named("HEB 300", x) end,
  ["hinge.section.channel"] = function(x) hinge.section.channel(x) end,
  ["hinge.section.angle"] = function(x) hinge.section.angle(x) end,
  ["hinge.section.pipe"] = function(x) hinge.section.pipe(x) end,
  ["hinge.section.solid"] = function(x) hinge.section.solid(x) end,
  ["hinge.section.round"] = function(x) hinge.section.round(x) end,
  ["hinge.section.concrete"] = function(x) hinge.section.concrete(with(x, square)) end,
  ["hinge.section.general"] = function(x) hinge.section.general(x) end,
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
  ["hinge.ground"] = function(x) hinge.ground(with({ dt = 1, acceleration = { 0, 0 } }, x)) end,
  ["hinge.scenario"] = function(x) hinge.scenario(x) end,
  ["hinge.study"] = function(x) hinge.study(hinge.scenario { parameters = { dt = 1 }, run = function() end }, x) end,
  ["hinge.cost"] = function(x) hinge.cost(hinge.scenario { parameters = { dt = 1 }, run = function() end }, x) end,
  ["model:member"] = function(x) s.model:member(x) end,
  ["model:load"] = function(x) s.model:load(x) end,
  ["case:load"] = function(x) s.case:load(x) end,
  ["model:mass"] = function(x) s.model:mass(with({ node = s.tip, mass = 1 }, x)) end,
  ["model:remove"] = function(x) s.model:remove(with({ member = s.member, at = 1 }, x)) end,
  ["model:heat"] = function(x) s.model:heat(with({ member = s.member, temperature = 100 }, x)) end,
  ["model:prestress"] = function(x) s.model:prestress(x) end,
  ["model:imperfection"] = function(x) s.model:imperfection(with({ sway = 0 }, x)) end,
  ["hinge.heat.steel"] = function(x) hinge.heat.steel(x) end,
  ["hinge.heat.unprotected"] = function(x) hinge.heat.unprotected(with({ section_factor = 100, duration = 60 }, x)) end,
  ["hinge.robustness"] = function(x) hinge.robustness(with({ build = function() end, limit = 0.1 }, x)) end,
  ["hinge.import.s2k"] = function(x) hinge.import.s2k(with({ file = record_file }, x)) end,
  ["hinge.import.e2k"] = function(x) hinge.import.e2k(with({ file = record_file }, x)) end,
  ["hinge.import.tcl"] = function(x)
    hinge.import.tcl(with({ file = record_file, units = { length = "m", force = "N" } }, x))
  end,
  ["hinge.import.csv"] = function(x) hinge.import.csv(with({ nodes = record_file, members = record_file }, x)) end,
  ["hinge.record.read"] = function(x) hinge.record.read(with({ file = record_file, unit = "g" }, x)) end,
  ["hinge.spectrum"] = function(x) hinge.spectrum(with({ dt = 0.1, acceleration = { 0, 1, 0 } }, x)) end,
  ["hinge.blast"] = function(x) hinge.blast(with({ charge = 100, at = { 0, 0, 0 } }, x)) end,
  ["hinge.blast.triangle"] = function(x) hinge.blast.triangle(with({ peak = 1, duration = 1 }, x)) end,
  ["hinge.blast.friedlander"] = function(x)
    hinge.blast.friedlander(with({ peak = 1, duration = 1, decay = 1 }, x))
  end,
  ["explosion:load"] = function(x)
    local explosion = hinge.blast { charge = 100, at = { -10, 0, 0 } }
    explosion:load(s.model, with({ members = { s.member }, normal = { 0, -1, 0 }, width = 1 }, x))
  end,
  ["hinge.grid"] = function(x) hinge.grid(with({ model = hinge.model(), x = { 0, 1 }, z = { 0, 1 } }, x)) end,
  ["model:defaults"] = function(x) hinge.model():defaults(x) end,
  ["model:line"] = function(x) s.model:line(with({ s.wall, s.tip }, x)) end,
  ["grid:defaults"] = function(x) s.grid:defaults(x) end,
  ["grid:columns"] = function(x) s.grid:columns(x) end,
  ["grid:beams"] = function(x) s.grid:beams(with({ along = "x" }, x)) end,
  ["grid:braces"] = function(x) s.grid:braces(with({ from = "A1", to = "B1" }, x)) end,
  ["grid:line"] = function(x) s.grid:line(with({ "A1, base", "A1, storey 1" }, x)) end,
  ["grid:copy"] = function(x) s.grid:copy(with({ members = {}, by = { 1, 0, 0 } }, x)) end,
  ["run:hinges"] = function(x) s.run:hinges(x) end,
  ["model:move"] = function(x) s.model:move(with({ node = s.tip, x = math.sin }, x)) end,
  ["model:settle"] = function(x) s.model:settle(with({ node = s.tip, x = 0.01 }, x)) end,
  ["model:fracture"] = function(x) s.model:fracture(x) end,
  ["model:damping"] = function(x) s.model:damping(x) end,
  ["model:contact"] = function(x) s.model:contact(x) end,
  ["model:connector"] = function(x) s.model:connector(with({ s.tip, ground = true }, x)) end,
  ["model:rigid_link"] = function(x) s.model:rigid_link(with({ from = s.tip, to = s.tip }, x)) end,
  ["model:diaphragm"] = function(x) s.model:diaphragm(with({ nodes = {} }, x)) end,
  ["model:connector.axes"] = function(x) s.model:connector { s.tip, ground = true, axes = x } end,
  ["model:connector.stiffness"] = function(x) s.model:connector { s.tip, ground = true, stiffness = x } end,
  ["model:connector.damping"] = function(x) s.model:connector { s.tip, ground = true, damping = x } end,
  ["model:connector.curve"] = function(x) s.model:connector { s.tip, ground = true, curve = x } end,
  ["model:connector.law"] = function(x) s.model:connector { s.tip, ground = true, law = x } end,
  ["model:connector.capacity"] = function(x) s.model:connector { s.tip, ground = true, capacity = x } end,
  ["model:ground"] = function(x) s.model:ground(x) end,
  ["model:static"] = function(x) s.model:static(x) end,
  ["model:static.control"] = function(x)
    s.model:static { control = with({ node = s.tip, "ux", to = 1 }, x), loads = {} }
  end,
  ["model:dynamic"] = function(x) s.model:dynamic(x) end,
  ["run:probe"] = function(x) s.run:probe(with({ node = s.tip, "uz" }, x)) end,
  ["run:count"] = function(x) s.run:count(with({ state = "broken" }, x)) end,
  ["job:picture"] = function(x) job:picture(s.run, x, "x.png") end,
  ["hinge.picture"] = function(x) hinge.picture(s.run, x, "x.png") end,
  ["hinge.plot"] = function(x) hinge.plot(s.run, x, "x.png") end,
  ["job:animate"] = function(x) job:animate(s.run:modes({ n = 1 })[1], with({ frames = 4 }, x)) end,
  ["hinge.animate"] = function(x) hinge.animate(s.run:modes({ n = 1 })[1], with({ frames = 4 }, x)) end,
  ["job:strip"] = function(x) job:strip({ { s.run, x } }, 1, "x.png") end,
  ["job:plot"] = function(x) job:plot(s.run, x, "x.png") end,
  ["ten_storey.add"] = function(x) building.add(hinge.model(), x) end,
  ["aircraft.add"] = function(x) aircraft.add(hinge.model(), x) end,
  ["aircraft.add.shape"] = function(x) aircraft.add(hinge.model(), { shape = x }) end,
  ["space_frame.add"] = function(x) space_frame.add(hinge.model(), x) end,
}
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
  local call = calls[what]
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
    local inner = looks_like_options(field.type:match "|({.*})$" or field.type)
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

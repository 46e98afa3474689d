-- import.write: a frame as a script of hinge in tables of nodes and members, one line each.
local check = require "hinge.library.check"
local core = require "hinge.core"
local in_full = require "hinge.import.in_full"
local quote = require "hinge.library.quote"
local slabs = require "hinge.import.slabs"
local ties = require "hinge.import.ties"

local where = "hinge.import.write"
local widest = 118 -- columns of a line

-- Values as text ------------------------------------------------------------------------------------------------------

-- The shortest text that gives the same number again: 2.1e11, 0.0149, 2.517e-4.
local function number(x)
  if x == 0 then return "0" end
  local digits = 1
  while digits < 17 and tonumber(("%%.%dg"):format(digits):format(x)) ~= x do digits = digits + 1 end
  local mantissa, sign, power = ("%%.%de"):format(digits - 1):format(x):match "^(.*)e([+-])0*(%d+)$"
  local short = mantissa .. "e" .. (sign == "-" and "-" or "") .. power
  local plain = x == math.floor(x) and ("%.0f"):format(x) or ("%%.%dg"):format(digits):format(x)
  return (plain:find "e" or #short < #plain) and short or plain
end

local literal

local keywords = {}
for word in ("and break do else elseif end false for function goto if in local nil not or repeat return then true "
  .. "until while"):gmatch "%S+" do keywords[word] = true end
local function is_name(key) return type(key) == "string" and key:find "^[%a_][%w_]*$" and not keywords[key] end

-- A table on one line: lists first, then the fields in order.
local function table_text(value)
  local parts = {}
  for i, item in ipairs(value) do parts[i] = literal(item) end
  for _, key in ipairs(check.keys(value)) do
    if not math.tointeger(tonumber(key)) then
      parts[#parts + 1] = ("%s = %s"):format(is_name(key) and key or "[" .. quote.lua(key) .. "]", literal(value[key]))
    end
  end
  return "{ " .. table.concat(parts, ", ") .. " }"
end

function literal(value)
  if type(value) == "number" then return number(value) end
  if type(value) == "string" then return quote.lua(value) end
  if type(value) == "table" then return table_text(value) end
  return tostring(value)
end

-- The last place after ", " within the widest line, but none inside a text in quotes.
local function last_break(text)
  local at, i, inside = nil, 1, false
  while i <= widest do
    local c = text:sub(i, i)
    if inside and c == "\\" then i = i + 1
    elseif c == '"' then inside = not inside
    elseif not inside and text:sub(i, i + 1) == ", " and i + 1 <= widest then at = i + 2 end
    i = i + 1
  end
  return at
end

-- A line that is broken at blanks after commas where it is too long.
local function add_line(lines, text, indent)
  while #text > widest do
    local at = last_break(text)
    if not at or at <= #indent + 1 then break end
    lines[#lines + 1] = text:sub(1, at - 2)
    text = indent .. "  " .. text:sub(at)
  end
  lines[#lines + 1] = text
end

-- "name = value" of the fields that are there, in this order.
local function fields(row, names)
  local parts = {}
  for _, name in ipairs(names) do
    if row[name] ~= nil then parts[#parts + 1] = ("%s = %s"):format(name, literal(row[name])) end
  end
  return table.concat(parts, ", ")
end

-- Parts of the script -------------------------------------------------------------------------------------------------

local section_fields = { "area", "Ix", "Iy", "J", "shear_area_x", "shear_area_y", "mass_Ix", "mass_Iy", "N0", "Mx0",
  "My0", "Mz0", "plastic", "size", "interaction", "outline", "reinforcement" }

local function add_materials(lines, full)
  lines[#lines + 1] = "-- Pa, kg/m^3"
  lines[#lines + 1] = "local materials = {"
  for _, m in ipairs(full.materials) do
    add_line(lines, ("  [%s] = hinge.material { %s },"):format(quote.lua(m.name),
      fields(m, { "E", "G", "nu", "density", "yield_stress", "hardening" })), "  ")
  end
  lines[#lines + 1] = "}\n\n-- m^2, m^3, m^4; x and y are the section's axes, and Ix bends about x\nlocal sections = {"
  for _, s in ipairs(full.sections) do
    local call = s.named and ("hinge.section.named %s"):format(quote.lua(s.named))
      or ("hinge.section.general { kind = %s, %s }"):format(quote.lua(s.kind or s.name), fields(s, section_fields))
    add_line(lines, ("  [%s] = %s,"):format(quote.lua(s.name), call), "  ")
  end
  lines[#lines + 1] = "}\n"
end

local function add_nodes(lines, full)
  lines[#lines + 1] = "-- Nodes: name; x, y, z in m; what is fixed\nlocal nodes = {}\nfor _, n in ipairs {"
  for _, n in ipairs(full.nodes) do
    local fix = n.fix and n.fix ~= "" and ", " .. quote.lua(n.fix) or ""
    lines[#lines + 1] = ("  { %s, %s, %s, %s%s },"):format(quote.lua(n.name), number(n.x), number(n.y),
      number(n.z), fix)
  end
  lines[#lines + 1] = "} do\n  nodes[n[1]] = model:node { n[2], n[3], n[4] }\n  if n[5] then model:fix(nodes[n[1]], "
    .. "n[5]) end\nend\n"
end

local function add_members(lines, full)
  local has = {}
  for _, m in ipairs(full.members) do
    for _, field in ipairs { "ends", "release", "offset", "elements" } do has[field] = has[field] or m[field] ~= nil end
  end
  lines[#lines + 1] = ("-- Members: name; first and second node; section; material; direction of the section's y axis; "
    .. "group%s%s%s\nlocal members = {}\nfor _, m in ipairs {"):format(
    has.release and ";\n-- moments that are released at its ends" or "",
    has.offset and ";\n-- what leads from its nodes to its ends, m" or "",
    has.elements and ";\n-- elements, as many as there are panels of slabs along it" or "")
  for _, m in ipairs(full.members) do
    local more = fields(m, { "up", "group", "ends", "release", "offset", "elements" })
    add_line(lines, ("  { %s, %s, %s, %s, %s%s },"):format(quote.lua(m.name), quote.lua(m.a), quote.lua(m.b),
      quote.lua(m.section), quote.lua(m.material), more ~= "" and ", " .. more or ""), "  ")
  end
  lines[#lines + 1] = "} do"
  if has.ends then
    lines[#lines + 1] = "  local ends = m.ends and {} -- joints: rad, N m\n"
      .. "  for at, options in pairs(m.ends or {}) do ends[at] = hinge.joint(options) end"
  end
  lines[#lines + 1] = ([=[
  members[m[1]] = model:member { nodes[m[2]], nodes[m[3]], section = sections[m[4]], material = materials[m[5]],
    up = m.up, group = m.group%s%s%s%s }
end
]=]):format(has.ends and ", ends = ends" or "", has.release and ", release = m.release" or "",
    has.offset and ", offset = m.offset" or "", has.elements and ",\n    elements = m.elements" or "")
end

local function add_masses(lines, full)
  if #full.masses == 0 then return end
  local offset = false
  lines[#lines + 1] = "-- Point masses: node; kg; inertia in kg m^2\nfor _, m in ipairs {"
  for _, m in ipairs(full.masses) do
    local more = fields(m, { "inertia", "offset" })
    lines[#lines + 1] = ("  { %s, %s%s },"):format(quote.lua(m.node), number(m.mass), more ~= "" and ", " .. more or "")
    offset = offset or m.offset ~= nil
  end
  lines[#lines + 1] = ("} do\n  model:mass { node = nodes[m[1]], mass = m[2], inertia = m.inertia%s }\nend\n"):format(
    offset and ", offset = m.offset" or "")
end

-- The loads of a case on nodes, or those on members.
local function add_loads(lines, case, what)
  local rows = {}
  for _, l in ipairs(case.loads) do
    if l[what] then
      rows[#rows + 1] = ("    { %s, %s },"):format(quote.lua(l[what]),
        fields(l, { "force", "moment", "q", "at", "from", "to", "axes" }))
    end
  end
  if #rows == 0 then return end
  lines[#lines + 1] = "  for _, l in ipairs {"
  for _, row in ipairs(rows) do add_line(lines, row, "    ") end
  lines[#lines + 1] = "  } do"
  lines[#lines + 1] = ("    case:load { %s = %ss[l[1]], force = l.force, moment = l.moment%s%s }"):format(what, what,
    what == "member" and ", q = l.q, at = l.at,\n      from = l.from, to = l.to, axes = l.axes" or "",
    case.history and ",\n      history = history" or "")
  lines[#lines + 1] = "  end"
end

local function add_case(lines, case)
  lines[#lines + 1] = "do"
  lines[#lines + 1] = ("  local case = model:case %s"):format(quote.lua(case.name))
  if case.gravity then
    lines[#lines + 1] = ("  case:gravity { 0, 0, %s } -- self weight, m/s^2"):format(number(case.gravity))
  end
  if case.history then
    lines[#lines + 1] = "  -- factor over time (s) in dynamics; statics takes the loads in full"
    add_line(lines, "  local history = " .. literal(case.history), "  ")
  end
  for _, what in ipairs { "node", "member" } do add_loads(lines, case, what) end
  lines[#lines + 1] = "end\n"
end

local function add_cases(lines, full)
  if #full.cases > 0 then lines[#lines + 1] = "-- Loads by case: N, N m, N/m, N m/m" end
  for _, case in ipairs(full.cases) do add_case(lines, case) end
end

-- A scenario that solves each case by itself and draws it.
local scenario = [=[
return hinge.scenario {
  run = function(_, job)
    for i, name in ipairs { %s } do
      local run = model:static { steps = 1, loads = { [name] = 1 } }:finish()
      job:picture(run, { title = name, scale = "auto", ghost = true, loads = true }, ("case_%%d.png"):format(i))
    end
  end,
}]=]

-- The same where some cases are held while the others act.
local scenario_of_held = [=[
return hinge.scenario {
  run = function(_, job)
    local held = model:static { steps = 1, loads = %s }:finish()
    job:picture(held, { title = "held", scale = "auto", ghost = true, loads = true }, "held.png")
    for i, name in ipairs { %s } do
      local loads = %s
      loads[name] = 1
      local run = model:static { steps = 1, from = held, loads = loads }:finish()
      job:picture(run, { title = name, scale = "auto", ghost = true, loads = true }, ("case_%%d.png"):format(i))
    end
  end,
}]=]

local unloaded = [=[
-- The file has no load that was read: add a case, and run it as below.
return hinge.scenario {
  run = function(_, job)
    local run = model:static { steps = 1 }:finish()
    job:picture(run, { title = "without load" }, "frame.png")
  end,
}]=]

local function write_scenario(lines, full)
  local names, held = {}, {}
  for _, case in ipairs(full.cases) do
    if case.held then held[case.name] = 1 else names[#names + 1] = quote.lua(case.name) end
  end
  if #full.cases == 0 then
    lines[#lines + 1] = unloaded
  elseif #names == 0 or not next(held) then
    for i, case in ipairs(full.cases) do names[i] = quote.lua(case.name) end
    lines[#lines + 1] = scenario:format(table.concat(names, ", "))
  else
    local given = literal(held)
    lines[#lines + 1] = scenario_of_held:format(given, table.concat(names, ", "), given)
  end
end

-- How a script goes on: as a scenario, or a static run of the first case.
local function add_end(lines, full)
  if full.scenario then return write_scenario(lines, full) end
  local first = full.cases[1]
  local loads = first and (", loads = %s"):format(literal { [first.name] = 1 }) or ""
  lines[#lines + 1] = ("-- To go on: local run = model:static { steps = 1%s }:finish()"):format(loads)
  lines[#lines + 1] = "return model, nodes, members"
end

-- The place of a file: one without a folder goes into the output folder.
local function path_of(file)
  local folder = core.out_dir()
  return (file:find "/" or folder == ".") and file or folder .. "/" .. file
end

local mark = "written by hinge.import."

-- A file that something else has written is not written over.
local function must_be_own(path)
  local file = io.open(path)
  local first = file and (file:read "l" or "")
  if file then file:close() end
  if first and first ~= "" and not first:find(mark, 1, true) then
    check.fail("%s: the file '%s' is there, and it is no script of import.write; give another name", where, path)
  end
end

return function(frame, file, options, ...)
  check.no_more(where, ...)
  check.value(where, "file", file, { "string" })
  if not file:find "%.lua$" then
    check.fail("%s: the file is '%s'; its name must end in .lua", where, file)
  end
  local full = in_full(where, frame, options)
  -- in a comment, which a line break would end
  local source = frame.source and " of " .. quote.comment(tostring(frame.source):match "[^/]*$") or ""
  local lines = { ("-- The frame%s, %s Units are SI: m, kg, s, N, Pa, rad."):format(source, mark),
    'local hinge = require "hinge"\n', ("local model = hinge.model %s\n"):format(
      next(full.options) and literal(full.options) or "{}") }
  add_materials(lines, full)
  add_nodes(lines, full)
  add_members(lines, full)
  add_masses(lines, full)
  local writer = { line = function(text) add_line(lines, text, "") end, literal = literal, quote = quote.lua }
  ties.write(writer, full)
  add_cases(lines, full)
  slabs.write(writer, full)
  add_end(lines, full)
  local path = path_of(file)
  must_be_own(path)
  if not core.planning() then core.write_text(path, table.concat(lines, "\n") .. "\n") end
  return path, full.not_by_gravity
end

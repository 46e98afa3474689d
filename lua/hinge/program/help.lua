-- hinge reference, and help at the prompt: the text of a call, the places that mention a word, the calls used most.
local core = require "hinge.core"
local check = require "hinge.library.check"
local reference = require "hinge.program.reference"
local other_words = require "hinge.program.other_words"

local help = {}

help.overview = [[
The calls used most. help "damping" or help(model.damping) tells about one; help "buckling" finds a word in all texts.

  materials, sections   hinge.material  hinge.section.box  .h  .pipe  .solid  .round  .general
  by their names        hinge.material.steel  .timber  .names  hinge.section.named  .names
  a structure           hinge.model  model:node  model:fix  model:member  model:mass  model:connector  model:panel
  loads                 model:gravity  model:load  model:floor  model:case  model:combination
  motion                model:velocity  model:move  hinge.ground
  what may happen       model:fracture  model:contact  model:ground  model:damping
  statics, limit loads  model:static  run:finish
  dynamics, impacts     model:dynamic  run:steps  run:on_step  run:checkpoint
  results at a joint    node:displacement  node:reaction  run:probe
  results of members    member:forces  member:state  run:read  run:count
  pictures, plots       hinge.picture  hinge.strip  hinge.plot  hinge.frame
  a whole script        hinge.scenario  hinge.note  hinge.cost

Fields of a run, such as verdict, energy, instability: help "hinge.run". What examples start from: help "examples".
Units as numbers, so that 4 * kN / m is 4000: help "hinge.units".
Ready structures: help "ten_storey.add", "aircraft.add", "space_frame.add". All of it: hinge reference | less
]]

local function examples_text()
  return "Every example runs as it stands after these lines.\n\n```lua\n" .. reference.preamble .. "\n```\n"
end

local function call_of(e) return e.kind == "function" and reference.signature(e):match "^[^(]*" or e.name end

-- A text's first sentence.
local function sentence(text) return text:match "^(.-[^%.]%.)%s+%u" or text end

-- The class of options that a parameter takes, or nil.
local function options_of(param, classes)
  local class = classes[param.type:match "^[%w_.]+" or ""]
  return class and #class.fields > 0 and not class.methods and class or nil
end

-- All entries, and classes by name with their `methods`.
local function read()
  local entries, classes = reference.read(), {}
  for _, e in ipairs(entries) do
    if e.kind == "class" then classes[e.name] = e end
    local class = e.kind == "function" and classes[e.object]
    if class then
      class.methods = class.methods or {}
      table.insert(class.methods, e)
    end
  end
  return entries, classes
end

-- A class with its fields, and a line for each of its functions.
local function class_text(class)
  local lines = { reference.text(class) }
  for _, method in ipairs(class.methods or {}) do
    local about = method.doc ~= "" and " — " .. sentence(method.doc) or ""
    lines[#lines + 1] = reference.wrapped(("- `%s`%s"):format(reference.signature(method), about)) .. "\n"
  end
  return lines[1] .. (#lines > 1 and "\n" or "") .. table.concat(lines, "", 2)
end

-- Names are compared without case; a dot is as good as a colon.
local function plain(name) return (name:lower():gsub(":", ".")) end

-- The texts of what is called so: functions with their options, classes with their methods, aliases; fields of classes
-- where nothing else has that name, else what they are fields of.
local function texts_on(name, object)
  local entries, classes = read()
  local wanted, texts, told, also = plain(name), {}, {}, {}
  local function tell(e)
    if told[e] then return end
    told[e] = true
    texts[#texts + 1] = e.kind == "class" and class_text(e) or reference.text(e)
  end
  for _, e in ipairs(entries) do
    local call = not object and e.kind == "function" and plain(call_of(e))
    if call and (call == wanted or call == "hinge." .. wanted or plain(e.name) == wanted) then
      tell(e)
      for _, param in ipairs(e.params) do
        local options = options_of(param, classes)
        if options then tell(options) end
      end
    elseif e.kind == "class" or e.kind == "alias" then
      if plain(e.name) == wanted or plain(e.name) == "hinge." .. wanted then tell(e) end
    end
  end
  local owners = {}
  for _, e in ipairs(entries) do
    for _, field in ipairs(e.fields or {}) do
      local whole = plain(e.name .. "." .. field.name)
      if whole == wanted or whole == "hinge." .. wanted or #texts == 0 and plain(field.name) == wanted then
        owners[#owners + 1] = ("`%s`\n\n%s\n"):format(e.name, reference.field(field))
        if classes[field.type] then owners[#owners + 1] = class_text(classes[field.type]) end
      elseif plain(field.name) == wanted then
        also[#also + 1] = ("`%s.%s`"):format(e.name, field.name)
      end
    end
  end
  table.move(owners, 1, #owners, #texts + 1, texts)
  if #also > 0 then
    texts[#texts + 1] = reference.wrapped("Fields with this name: " .. table.concat(also, ", ")) .. "\n"
  end
  return texts
end

--- The text on a name such as "material", "model:member", "hinge.run", "verdict"; nil where nothing is called so.
-- object: it is the class of one.
function help.text(name, object)
  if plain(name) == "examples" then return examples_text() end
  local texts = texts_on(name, object)
  return #texts > 0 and table.concat(texts, "\n") or nil
end

--- " (did you mean 'x'?)", or "".
function help.suggestion(name)
  local names = {}
  for _, e in ipairs((read())) do
    if e.name then names[#names + 1], names[#names + 2] = e.name, call_of(e) end
    for _, field in ipairs(e.fields or {}) do names[#names + 1] = field.name end
  end
  return core.did_you_mean(name, names)
end

-- The part of a text around a place, in whole words, some `width` columns.
local width = 100
local function around(text, from, to)
  local first = math.max(1, from - (width - (to - from)) // 2)
  local last = math.min(#text, first + width)
  if first > 1 then first = math.min(from, text:find("%s", first) + 1) end
  if last < #text then last = math.max(to, #text:sub(1, last):match "^(.*)%s") end
  return (first > 1 and "... " or "") .. text:sub(first, last) .. (last < #text and " ..." or "")
end

-- The texts on an entry, the most telling first: of a function its example is the last, line by line.
local function texts_of(e)
  local texts = { e.doc }
  for _, p in ipairs(e.params or {}) do texts[#texts + 1] = p.name .. ": " .. p.doc end
  for _, text in ipairs(e.returns or {}) do texts[#texts + 1] = "returns " .. text end
  for line in (e.example or ""):gmatch "[^\n]+" do texts[#texts + 1] = line:match "%S.*" end
  return texts
end

--- Where the texts mention a word, in upper or lower case: a list of { title =, line = }. It has the first place of
-- each call, class and field.
function help.search(word)
  local wanted, found = word:lower(), {}
  local function look(title, texts)
    local line
    for _, text in ipairs(texts) do
      local from, to = text:lower():find(wanted, 1, true)
      line = line or from and around(text, from, to)
    end
    if not line and title:lower():find(wanted, 1, true) then line = around(texts[1], 1, 1) end
    if line then found[#found + 1] = { title = title, line = line } end
  end
  for _, e in ipairs((read())) do
    if e.kind ~= "heading" then look(e.kind == "function" and reference.signature(e) or e.name, texts_of(e)) end
    for _, field in ipairs(e.fields or {}) do look(e.name .. "." .. field.name, { field.doc }) end
  end
  return found
end

--- What to read of a word that the reference does not use (other_words.lua), a line; nil where that is not known.
function help.see(word)
  local plain_word = word:lower():gsub("[-_%s]+", " ")
  local known = other_words[plain_word] or other_words[plain_word:match "^(.*)s$" or ""]
  if not known then return nil end
  return ("'%s'%s see %s (%s)"):format(word, known.missing and " is not available;" or ":",
    table.concat(known.see, ", "), known.how)
end

local function listed(found)
  local lines = {}
  for _, place in ipairs(found) do
    lines[#lines + 1] = place.title
    if place.line ~= "" then lines[#lines + 1] = "    " .. place.line end
  end
  return table.concat(lines, "\n") .. "\n"
end

-- The name under which the reference has a value: a function of the library, a method, an object; or nil.
local function name_of(value)
  local module
  for _, e in ipairs((read())) do
    if e.kind == "heading" then module = e.module or module end
    if e.kind == "function" and type(value) == "function" then
      local of_library = reference.tables[e.object]
      local owner = e.object == "hinge" and require "hinge" or of_library and require "hinge"[of_library]
        or e.object == "hinge.job" and getmetatable(require "hinge.program.job".new(""))
        or e.separator == "." and module and package.loaded[module]
        or (debug.getregistry()[e.object] or {}).methods
      if type(owner) == "table" and rawget(owner, e.name) == value then return call_of(e) end
    end
  end
  if type(value) == "function" then return nil end
  if rawequal(value, require "hinge") then return "hinge" end
  if rawequal(value, require "hinge".section) then return "hinge.sections" end
  local meta = debug.getmetatable(value)
  return type(meta) == "table" and type(meta.__name) == "string" and meta.__name or nil
end

-- help: help() and help alone list the calls used most, help(what) prints what is known of a name or a value.
local function tell(_, ...)
  if select("#", ...) == 0 then
    io.write(help.overview)
    return
  end
  local what = ...
  local name = type(what) == "string" and what or name_of(what)
  local call = type(what) == "string" or type(what) == "function" or rawequal(what, require "hinge".material)
    or rawequal(what, require "hinge".backbone)
  local text = name and help.text(name, not call)
  if text then
    io.write(text)
    return
  elseif type(what) ~= "string" then
    check.fail("help: %s does not belong to hinge; give a call such as model.member, or a name or word as text",
      check.show(what))
  end
  local found = name ~= "" and help.search(name) or {}
  local see = help.see(what)
  if see then
    io.write(reference.wrapped(see), "\n")
    if #found > 0 then io.write("\nThe reference mentions it here:\n\n", listed(found)) end
    return
  end
  if #found == 0 then
    check.fail("help: nothing is called '%s'%s; help lists the calls", name, help.suggestion(name))
  end
  io.write(("Nothing is called '%s'%s. The reference mentions it here:\n\n%s"):format(name, help.suggestion(name),
    listed(found)))
end
help.at_prompt = setmetatable({}, {
  __call = tell, __tostring = function() return (help.overview:gsub("\n$", "")) end, __name = "help",
})

local function not_found(text, ...)
  io.stderr:write(("hinge: " .. text .. "\n"):format(...))
  return 2
end

--- Prints the page; options.code: only what is called so; options.search: the places that mention a word. Returns the
-- exit status, 2 where there is nothing.
function help.main(options)
  local name, word = options.code, options.search
  if word then
    local found, see = help.search(word), help.see(word)
    if see then io.write(reference.wrapped(see), "\n") end
    if #found == 0 and not see then
      return not_found("the reference does not mention '%s'%s", word, help.suggestion(word))
    end
    if #found > 0 then io.write(see and "\n" or "", listed(found)) end
    return 0
  end
  local text = not name and reference.page() or help.text(name)
  if text then
    io.write(text)
    return 0
  end
  local places, see = #help.search(name), help.see(name)
  if see then return not_found("nothing is called '%s'; %s", name, see) end
  local more = places > 0 and ("`hinge reference -s %s` finds %s of it"):format(name, check.count(places, "mention"))
    or "`hinge reference` prints everything, `hinge reference -s WORD` searches it"
  return not_found("nothing is called '%s'%s; %s", name, help.suggestion(name), more)
end

return help

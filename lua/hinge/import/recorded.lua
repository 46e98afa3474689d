-- import.tcl: a frame from a script of OpenSees, in Tcl or in Python. The script is run by its own interpreter, tclsh
-- or python3, behind walls of the kernel; recorder.tcl and recorder.py write down the commands of OpenSees that it
-- gives, which go to the reader of opensees.lua.
--
-- The script runs twice, with different results of the analysis, which are made up: what differs hangs on them.
local check = require "hinge.library.check"
local core = require "hinge.core"
local names = require "hinge.import.opensees_names"
local notes = require "hinge.import.notes"
local opensees = require "hinge.import.opensees"

local where = "hinge.import.tcl"
local _, own_path = ...
local own_folder = own_path:match "^(.*/)" or ""
local most_commands = 5000000 -- of Tcl

local languages = {
  tcl = { program = "tclsh", package = "tcl", script = "recorder.tcl", words = {} },
  -- -s, and the surroundings that core.interpret gives: nothing of the user's own modules and settings, as with -I,
  -- under which sets would have another order in each run
  python = { program = "python3", package = "python3", script = "recorder.py", words = { "-s", "-B" } },
}

local computed = {} -- commands that change no model
for _, list in ipairs { names.results, names.quiet } do
  for name in list:gmatch "%S+" do computed[name] = true end
end

-- Records -------------------------------------------------------------------------------------------------------------

-- The records of a recorder: { kind, file, line, text, ... }, see recorder.tcl.
local function records_of(text)
  local list = {}
  for record in text:gmatch "(.-)\31\30" do
    local fields = {}
    for field in (record .. "\31"):gmatch "([^\31]*)\31" do fields[#fields + 1] = field end
    list[#list + 1] = fields
  end
  return list
end

local of_memory = { "out of memory", "unable to alloc", "unable to realloc", "failed to map segment", "MemoryError",
  "cannot allocate memory", "bad_alloc" }

local function of_too_much_memory(text)
  for _, words in ipairs(of_memory) do
    if text:find(words, 1, true) then
      return ("it takes more than %g MB of memory; does a value in it grow without bound?"):format(notes.most_memory)
    end
  end
end

-- Why an interpreter ended before it came to the end of the script.
local function reason_of(program, result)
  local says = check.plain(check.one_line(result.err)):sub(1, 200)
  local memory = of_too_much_memory(result.err)
  if memory then return memory end
  if result.ended == "time" or result.ended == "signal" and result.number == 24 then -- SIGXCPU
    return ("it takes more than %g s; does a loop in it have no end?"):format(notes.most_seconds)
  elseif result.ended == "signal" and result.number == 11 then
    return ("%s ended; is something nested too deeply?"):format(program)
  end
  return ("%s ended by %s %d%s"):format(program, result.ended == "exit" and "status" or "signal", result.number,
    says ~= "" and ": " .. says or "")
end

-- Runs the script once. Returns its records, of which the last one tells how it ended, and the seconds it took.
local function run(o, language, turn, seconds)
  local result = core.interpret { program = language.program, words = language.words, file = o.file,
    script = own_folder .. language.script, seconds = seconds, memory = notes.most_memory * 1e6,
    more = { ("%d"):format(turn), ("%.15g"):format(seconds), ("%d"):format(most_commands), names.results,
      names.quiet, names.model } }
  if not result then
    check.fail("%s: '%s' is run by %s, which is not installed: apt-get install %s", where, o.file, language.program,
      language.package)
  end
  if result.ended == "interrupted" then check.fail("%s: interrupted while '%s' was read", where, o.file) end
  local list = records_of(result.out)
  local last = list[#list]
  if not last or not ("xl."):find(last[1], 1, true) then
    list[#list + 1] = { "d", last and last[2], last and last[3], reason_of(language.program, result) }
  end
  return list, result.seconds
end

-- The place of a record: { file =, line =, text = }. Its file is seen from the folder of the script, "" the script.
local function place_of(o, record)
  local seen = record[2] or ""
  local file = seen == "" and o.file or (o.file:match "^(.*/)" or "") .. seen
  return { file = file, line = math.tointeger(tonumber(record[3])) or 1, text = record[4] }
end

-- Two records ---------------------------------------------------------------------------------------------------------

local function is_model(record) return record[1] == "e" or record[1] == "c" and not computed[record[5]] end

-- The place where two turns part, at the one of two commands that stands earlier; either may be missing.
local function part(record, twin)
  local earlier = twin and (record[1] == "." or twin[2] == record[2]
    and (tonumber(twin[3]) or 0) < (tonumber(record[3]) or 0))
  return { parts = true, table.unpack(earlier and twin or record) }
end

-- Marks what differs between the records of two turns: arguments that are names.unknown from here on, and a record
-- (`parts`) from which on the commands are others.
local function compare(first, second)
  local other = {}
  for _, record in ipairs(second) do
    if is_model(record) then other[#other + 1] = record end
  end
  local at = 0
  for i, record in ipairs(first) do
    local is_end = i == #first
    if is_model(record) or is_end then
      at = at + 1
      local twin = other[at]
      local same = twin and twin[1] == record[1] and twin[2] == record[2] and twin[3] == record[3]
        and twin[5] == record[5]
      if not same and (twin or not is_end) then return table.insert(first, i, part(record, twin)) end
      for k = 6, same and math.max(#record, #twin) or 0 do
        if record[k] ~= twin[k] then record[k] = names.unknown end
      end
    end
  end
end

-- Reading -------------------------------------------------------------------------------------------------------------

-- Whether nothing but commands that compute or print stands in the script from a line on.
local function only_computes(o, from)
  for number, line in notes.lines(notes.read(where, o.file)) do
    local word = line:match "^[%s}]*([^%s;]*)"
    if number >= from and word ~= "" and not computed[word] and not word:find "^#" then return false end
  end
  return true
end

-- Whether the model of a script is complete although the script does not come to its end: an analysis ran, or nothing
-- of a model follows.
local function is_complete(o, list)
  local elements, analysed = false, false
  for _, record in ipairs(list) do
    local name = record[1] == "c" and record[5]
    if name == "wipe" then elements, analysed = false, false end
    elements = elements or name == "element"
    analysed = analysed or elements and (name == "analyze" or name == "eigen")
  end
  local last = list[#list]
  return last[1] == "." or analysed or last[1] == "x" and last[2] == "" and only_computes(o, tonumber(last[3]))
end

-- An error for what ends a script whose model is not complete.
local function stopped(o, record)
  local place, message = record[2] and place_of(o, record), of_too_much_memory(record[4]) or check.plain(record[4])
  if not place then check.fail("%s: %s: %s", where, o.file, message) end
  notes.fail(where, place, "%s%s", record[1] == "d" and "behind this command: " or "", message)
end

-- Gives the records to the reader.
local function feed(o, reader, list)
  for _, record in ipairs(list) do
    local kind, name = record[1], record[5]
    local place = place_of(o, record)
    if record.parts then
      return reader:lost(place, "whether this runs hangs on a result of the analysis; from here on nothing is read")
    elseif kind == "c" then
      reader:run(name, table.move(record, 6, #record, 1, {}), place)
    elseif kind == "e" then
      reader.case = nil -- loads behind the braces belong to no pattern
    elseif kind == "s" then
      reader:computed(place)
    elseif kind == "u" then
      reader:lost(place, name)
    elseif kind ~= "." then
      notes.add(reader.notes, place, check.plain(record[4]),
        "the script ends here; what it would compute from here on is not read")
    end
  end
end

-- A Python file is a program: it runs only where the user says so, and behind walls that this kernel has.
local function allow_python(o)
  if not o.run_python then
    check.fail("%s: '%s' is a program in Python, and reading it is running it. If you want that, say so: "
      .. "hinge export --run-python, or run_python = true. It then reads its own folder and Python's library alone, "
      .. "writes no file, starts no program, reaches no network, and ends after %g s or %d MB", where, o.file,
      notes.most_seconds, notes.most_memory)
  end
  local lacks = core.lacking_walls()
  if lacks ~= "" then
    check.fail("%s: this kernel lacks %s: nothing would keep '%s' from your files; take Linux 5.13 or later", where,
      lacks, o.file)
  end
end

return function(options, ...)
  check.no_more(where, ...)
  local o = check.options(where, options, { file = { "string" }, units = { "table", optional = true },
    model = { "number", whole = true, at_least = 1, optional = true },
    language = { "string", one_of = { "tcl", "python" }, optional = true },
    run_python = { "boolean", optional = true } })
  local reader = opensees.new(where, o.file, o.units, o.model)
  notes.text_of(where, o.file) -- refuses the sandbox, pipes, devices and very large files
  local python = o.language == "python" or not o.language and o.file:lower():find "%.py$" ~= nil
  if python then allow_python(o) end
  local language = languages[python and "python" or "tcl"]
  local first, seconds = run(o, language, 1, notes.most_seconds)
  if not is_complete(o, first) then stopped(o, first[#first]) end
  -- a loop whose number of turns is a result may be long in the second turn
  compare(first, (run(o, language, 2, math.min(notes.most_seconds, 3 + 5 * seconds))))
  feed(o, reader, first)
  return reader:finish()
end

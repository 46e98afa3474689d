-- hinge export: a frame of another program as a script of hinge.
local check = require "hinge.library.check"
local import = require "hinge.import"
local notes_module = require "hinge.import.notes"

local export = {}

local tables = { "nodes", "members", "sections", "materials", "supports", "loads", "masses" }
local by_ending = { s2k = "s2k", ["$2k"] = "s2k", e2k = "e2k", ["$et"] = "e2k", tcl = "tcl", py = "tcl" }
local known = ".s2k and .$2k of SAP2000, .e2k and .$et of ETABS, .tcl and .py of OpenSees, or a folder with nodes.csv "
  .. "and members.csv"

local function is_file(path)
  local file = io.open(path)
  local good = file and file:read(0) ~= nil or false
  if file then file:close() end
  return good
end

-- The tables of a folder, or nil where it has none.
local function csv_of(folder)
  local found = {}
  for _, name in ipairs(tables) do
    local path = folder .. "/" .. name .. ".csv"
    if is_file(path) then found[name] = path end
  end
  return next(found) and found or nil
end

-- "kN,m" or "kN,m,t", in any order, as the units of import.tcl.
local function units_of(text)
  if not text then
    check.fail("a script of OpenSees does not say its units; give --units FORCE,LENGTH, such as --units kN,m or "
      .. "--units kip,inch, and a third one where masses are in another unit than force s^2 / length")
  end
  return require("hinge.import.opensees.units").of_text("--units", text)
end

-- The number of --model.
local function model_of(text)
  local number = text and math.tointeger(tonumber(text))
  if text and not (number and number > 0) then
    check.fail("--model is '%s'; must be a whole number from 1", text)
  end
  return number
end

-- Names of sections in a file and in hinge: the lines NAME,NAME of a file in CSV. One line may be name,named.
local function sections_of(path)
  local of = {}
  for number, line in notes_module.lines(notes_module.read("hinge export", path)) do
    local name, other = line:match "^%s*\"?([^,;\t\"]-)\"?%s*[,;\t]%s*\"?([^,;\t\"]-)\"?%s*$"
    if name and name ~= "" and other ~= "" then
      if not (number == 1 and name:lower() == "name") then of[name] = other end
    elseif line:find "%S" and not line:find "^%s*#" then
      check.fail("--sections: %s:%d: '%s' is not of the form NAME,NAME, such as W14X999,W14X873", path, number, line)
    end
  end
  return of
end

-- "393e-6,500e6", or "file", as the option `slabs` of import.s2k.
local function slabs_of(text)
  if text == "file" then return true end
  local area, yield = text:match "^%s*([^,%s]+)%s*,%s*([^,%s]+)%s*$"
  area, yield = tonumber(area), tonumber(yield)
  if not (area and yield and area > 0 and yield > 0) then
    check.fail("--slabs is '%s'; must be the area of the bars each way, m^2/m, and their yield stress, Pa, such as "
      .. "393e-6,500e6, or 'file' where the file has them", text)
  end
  return { reinforcement = { x = area, y = area, yield_stress = yield } }
end

--- Reads the frame of a file, or of a folder with tables in CSV. Returns its description and the notes. o.units and
--- o.model: texts for a script of OpenSees; o.run_python: a script in Python is run; o.sections: path of a table of
--- sections for a file of SAP2000 or ETABS; o.slabs: text for floors that have stiffness.
function export.read(source, o)
  local units = o.units
  local tables_there = csv_of(source)
  local reader = by_ending[(source:match "%.([^./]*)$" or ""):lower()]
  if units and reader ~= "tcl" then check.fail("--units is for scripts of OpenSees; %s has its own", source) end
  if o.model and reader ~= "tcl" then check.fail("--model is for scripts of OpenSees; %s has one model", source) end
  for _, name in ipairs { "sections", "slabs" } do
    if o[name] and reader ~= "s2k" and reader ~= "e2k" then
      check.fail("--%s is for files of SAP2000 and ETABS", name)
    end
  end
  if tables_there then return import.csv(tables_there) end
  if source:find "%.lua$" then check.fail("%s is a script of hinge already; export reads %s", source, known) end
  if not reader then check.fail("%s is of no kind that export reads: %s", source, known) end
  if reader == "tcl" then
    return import.tcl { file = source, units = units_of(units), model = model_of(o.model),
      run_python = o.run_python and true }
  end
  return import[reader] { file = source, sections = o.sections and sections_of(o.sections),
    slabs = o.slabs and slabs_of(o.slabs) }
end

-- frame.lua beside where the command was typed, from models/frame.s2k or models/frame/.
local function name_of(source)
  local stem = source:gsub("/+$", ""):match "[^/]*$":gsub("%.[^.]*$", "")
  return (stem == "" and "frame" or stem) .. ".lua"
end

-- Writes the script. Self weight that gravity cannot be is loads along the members, as the file has it.
local function write(frame, file)
  local path, reason = import.write(frame, file, { scenario = true, self_weight = "either" })
  if reason then print("self weight: loads along the members, as in the file, for " .. reason) end
  return path
end

--- The program: source, units, model, sections, run_python and file as the command line has them. Returns the exit
--- status.
function export.main(options)
  local frame, notes = export.read(options.script, options)
  print(notes)
  local path = write(frame, options.file or name_of(options.script))
  local count = notes_module.count(notes)
  local lost = count > 0 and (" without the %s above that %s not read"):format(
    check.count(count, "thing"), count == 1 and "was" or "were") or ""
  print(("written to %s%s; hinge check %s looks it over, hinge run %s solves and draws its load cases"):format(path,
    lost, path, path))
  return 0
end

return export

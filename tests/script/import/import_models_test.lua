-- Models of other programs that are at hand, below a folder: how each of them is read. No file may crash a reader or
-- take longer than its limit; what is not read has a reason. A table says how many are read, partly read and refused,
-- and why. The tree has no such files: their authors have the rights to them.
--
-- Run: HINGE_MODELS=folder lua5.4 tests/script/import/import_models_test.lua [table.csv], with the module on LUA_CPATH.
-- In the place of a folder it may be a text file, with a file or a folder on each line.
-- HINGE_MODELS_PYTHON=yes runs the Python files too, as hinge export --run-python does.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
require "hinge"
local columns = require "hinge.library.columns"
local checks = support.checks "models at hand"
local case, expect = checks.case, checks.expect

local folder = os.getenv "HINGE_MODELS"
if not folder then checks.skip "HINGE_MODELS is not set: give it a folder with .tcl, .py, .s2k, .e2k files" end
local most_seconds, most_memory = 60, 4e6 -- of one file; kB
local endings = { tcl = "Tcl", py = "Python", s2k = "SAP2000", ["$2k"] = "SAP2000", e2k = "ETABS", ["$et"] = "ETABS" }

-- Files ---------------------------------------------------------------------------------------------------------------

local function ending_of(path) return endings[path:lower():match "%.([^./]*)$" or ""] end

-- The files below a folder, or those that a text file names.
local function files_of(where)
  local folders, files, known = { where }, {}, {}
  if support.run(("test -d %s"):format(support.quote(where))) ~= 0 then
    folders = {}
    for line in io.lines(where) do folders[#folders + 1] = line end
  end
  for _, name in ipairs(folders) do
    for path in support.output(("find -L %s -type f"):format(support.quote(name))):gmatch "[^\n]+" do
      if ending_of(path) and not known[path] then files[#files + 1], known[path] = path, true end
    end
  end
  table.sort(files)
  return files
end

-- Whether a text has a frame by itself: a model, nodes and elements that are beams or bars. Files that only take part
-- in a model, such as a procedure, or that are no model at all, are counted apart.
local function has_frame(text, program)
  if program == "SAP2000" then return text:find 'TABLE:%s*"CONNECTIVITY %- FRAME"' ~= nil end
  if program == "ETABS" then return text:find "$ LINE CONNECTIVITIES" ~= nil end
  text = "\n" .. text
  local begins = program == "Tcl" and text:find "[\n;{]%s*model%s+%a" or text:find "%f[%a]model%s*%(%s*['\"]"
  return begins and text:find "%f[%a]node%f[%A]" and (text:find "[bB]eam[cC]olumn" or text:find "TimoshenkoBeam"
    or text:find "%f[%a]truss%f[%A]" or text:find "%f[%a][cC]orotTruss%f[%A]" or text:find "%f[%a]Truss%f[%A]") ~= nil
end

-- Reads a file in another process: status, members, nodes, notes, kinds, seconds.
local function read(path)
  local command = ("ulimit -v %d; timeout -k 5 %d lua5.4 %s %s %s"):format(most_memory, most_seconds,
    support.quote(support.folder .. "import/read_one.lua"), support.quote(path),
    os.getenv "HINGE_MODELS_PYTHON" == "yes" and "run_python" or "")
  local began = os.time()
  local file = assert(io.popen(command .. " 2>/dev/null"))
  local line = file:read "a"
  local _, _, status = file:close()
  local row = { path = path, seconds = os.time() - began, kinds = {} }
  if status ~= 0 then
    row.status = status == 124 and "too long" or "crashed"
    row.kinds = { { 1, ("the process ends with %d"):format(status) } }
    row.members, row.nodes, row.notes = 0, 0, 1
    return row
  end
  local fields = {}
  for field in (line:match "[^\n]*" .. "\t"):gmatch "(.-)\t" do fields[#fields + 1] = field end
  row.status, row.members, row.nodes, row.notes = fields[1], tonumber(fields[2]), tonumber(fields[3]),
    tonumber(fields[4])
  for i = 5, #fields do
    local count, kind = fields[i]:match "^(%d+)|(.*)$"
    row.kinds[#row.kinds + 1] = { tonumber(count), kind }
  end
  return row
end

-- Table ---------------------------------------------------------------------------------------------------------------

local order = { "whole", "partly", "unbuilt", "empty", "refused", "refused*", "too long", "crashed", "all" }
local meaning = { whole = "read whole", partly = "read in part, with notes", unbuilt = "read, but no model",
  empty = "without a member that is read", refused = "refused, with a line", ["refused*"] = "refused, without a line",
  ["too long"] = ("longer than %d s"):format(most_seconds), crashed = "crashed", all = "all" }

local function print_counts(rows, title, keep)
  local count, programs, lines = {}, { "Tcl", "Python", "SAP2000", "ETABS" }, {}
  local function add(what, program) count[what .. program] = (count[what .. program] or 0) + 1 end
  for _, row in ipairs(rows) do
    if keep(row) then
      add(row.status, row.program)
      add("all", row.program)
    end
  end
  for i, status in ipairs(order) do
    lines[i] = { meaning[status] }
    for k, program in ipairs(programs) do lines[i][k + 1] = count[status .. program] or 0 end
  end
  columns.print(title, { "", table.unpack(programs) }, lines)
end

-- Reasons by kind: in how many files, and how often.
local function print_kinds(rows, title, keep)
  local files, times, names = {}, {}, {}
  for _, row in ipairs(rows) do
    for _, k in ipairs(keep(row) and row.kinds or {}) do
      if not files[k[2]] then names[#names + 1] = k[2] end
      files[k[2]], times[k[2]] = (files[k[2]] or 0) + 1, (times[k[2]] or 0) + k[1]
    end
  end
  table.sort(names, function(a, b) return files[a] > files[b] or files[a] == files[b] and a < b end)
  print(("\n%s: files, times, reason"):format(title))
  for i = 1, math.min(#names, 60) do print(("%5d %7d  %s"):format(files[names[i]], times[names[i]], names[i])) end
  if #names > 60 then print(("and %d more kinds"):format(#names - 60)) end
end

local function write_csv(path, rows)
  local lines = { "file,program,frame,status,members,nodes,notes,seconds,first reason" }
  for _, row in ipairs(rows) do
    lines[#lines + 1] = ('"%s",%s,%s,%s,%d,%d,%d,%d,"%s"'):format(row.path:gsub('"', '""'), row.program,
      row.frame and "yes" or "no", row.status, row.members, row.nodes, row.notes, row.seconds,
      (row.kinds[1] and row.kinds[1][2] or ""):gsub('"', '""'))
  end
  support.write(path, table.concat(lines, "\n") .. "\n")
end

case("no file crashes a reader or takes longer than its limit", function()
  local rows, seen = {}, {}
  for _, path in ipairs(files_of(folder)) do
    local text = support.read(path) or ""
    if not seen[text] then -- repositories have copies of others
      seen[text] = true
      local row = read(path)
      row.program, row.frame = ending_of(path), has_frame(text, ending_of(path)) and true or row.members > 0
      rows[#rows + 1] = row
      expect(row.status ~= "crashed" and row.status ~= "too long", "%s: %s", path, meaning[row.status])
      io.stderr:write(("\r%d files"):format(#rows))
    end
  end
  io.stderr:write "\n"
  if arg[1] then write_csv(arg[1], rows) end
  print_counts(rows, "files with a frame", function(row) return row.frame end)
  print_counts(rows, "other files", function(row) return not row.frame end)
  for _, status in ipairs { "refused", "refused*", "unbuilt", "empty", "partly" } do
    print_kinds(rows, "frames: " .. meaning[status], function(row) return row.frame and row.status == status end)
  end
  expect(#rows > 0, "there is no file to read below %s", folder)
end)

checks.done()

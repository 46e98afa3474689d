-- Reads one file of another program and prints one line on it, for import_models_test.lua, which starts this in a
-- process of its own: a file that crashes or does not end takes no other with it.
--
-- Run: lua5.4 read_one.lua FILE [run_python], with the module on LUA_CPATH. The line: whole, partly, empty or refused;
-- members; nodes; notes; then each kind of reason as COUNT "|" TEXT, all between tabs.
require "hinge"
local export = require "hinge.import.export"
local import = require "hinge.import"

local path, run_python = arg[1], arg[2] == "run_python"

-- A reason without what differs between files of one kind: names in quotes, paths, numbers.
local function kind_of(reason)
  local at, to = reason:find(path, 1, true)
  if at then reason = reason:sub(1, at - 1) .. "FILE" .. reason:sub(to + 1) end
  reason = reason:gsub("^.-hinge%.import%.[%w_]+: ", ""):gsub("[\t\n]", " "):gsub("; the first line.*", "")
  reason = reason:gsub("'[^']*'", "'...'"):gsub("%S*/%S*:", "FILE:"):gsub("%S*/%S+", "FILE")
  return (reason:gsub("[+-]?%d+%.?%d*[eE][+-]?%d+", "N"):gsub("([^%w_])[+-]?%d+%.?%d*", "%1N"):gsub("FILE:N", "FILE:N")
    :sub(1, 160))
end

local function read()
  local of_opensees = path:lower():find "%.tcl$" or path:lower():find "%.py$"
  return export.read(path, { units = of_opensees and "m,N" or nil, run_python = run_python })
end

local function finish(status, members, nodes, count, kinds)
  local list = {}
  for kind, n in pairs(kinds) do list[#list + 1] = { kind, n } end
  table.sort(list, function(a, b) return a[2] > b[2] or a[2] == b[2] and a[1] < b[1] end)
  local line = { status, members, nodes, count }
  for _, k in ipairs(list) do line[#line + 1] = ("%d|%s"):format(k[2], k[1]) end
  print(table.concat(line, "\t"))
  os.exit(0, true)
end

local good, frame, notes = pcall(read)
if not good then
  local message = tostring(frame)
  local named = message:find "[^%s:]:%d+:?%s" or message:find "line %d+"
  finish(named and "refused" or "refused*", 0, 0, 1, { [kind_of(message)] = 1 })
end
local kinds = {}
for _, note in ipairs(notes) do
  local kind = kind_of(note.reason or note.text)
  kinds[kind] = (kinds[kind] or 0) + (note.count or 1)
end
if #frame.members == 0 then finish("empty", 0, #frame.nodes, #notes, kinds) end
-- what is read must make a model
local built, problem = pcall(import.build, frame, { self_weight = "loads" })
if not built then finish("unbuilt", #frame.members, #frame.nodes, #notes + 1, { [kind_of(tostring(problem))] = 1 }) end
finish(#notes == 0 and "whole" or "partly", #frame.members, #frame.nodes, #notes, kinds)

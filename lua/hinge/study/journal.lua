-- What a study has finished, as it goes: a line of JSON a case, added when the case has ended, so that a kill at any
-- moment loses the cases in flight and no others. Tasks of a cluster have journals of their own in the same folder.
local core = require "hinge.core"
local files = require "hinge.study.files"
local finished = require "hinge.study.case".finished
local quote = require "hinge.library.quote"

local journal = {}

-- The journals of a folder: cases.jsonl, and those of tasks.
local function names_in(folder)
  local names = {}
  local pipe = io.popen(("ls -1 %s 2>/dev/null"):format(quote.shell(folder)))
  for name in pipe:lines() do
    if name:find "^cases[%w-]*%.jsonl$" then names[#names + 1] = name end
  end
  pipe:close()
  return names
end

--- All cases of a folder that have ended, by their identity; of several entries the last one with an answer counts. A
-- line that was cut off is left out.
function journal.read(folder)
  local found = {}
  for _, name in ipairs(names_in(folder)) do
    for line in (files.text(folder .. "/" .. name) or ""):gmatch "([^\n]*)\n" do
      local entry = core.from_json(line)
      if type(entry) == "table" and entry.id then
        local before = found[entry.id]
        if not before or finished(entry.verdict) or not finished(before.verdict) then found[entry.id] = entry end
      end
    end
  end
  return found
end

--- Forgets all of it.
function journal.remove(folder)
  for _, name in ipairs(names_in(folder)) do os.remove(folder .. "/" .. name) end
end

--- Adds a finished case.
function journal.add(folder, name, entry)
  core.append(folder .. "/" .. name, core.to_json(entry) .. "\n")
end

--- Writes the journal anew, in the order of the cases.
function journal.write(folder, name, entries)
  local lines = {}
  for i, entry in ipairs(entries) do lines[i] = core.to_json(entry) .. "\n" end
  core.write_text(folder .. "/" .. name, table.concat(lines))
end

return journal

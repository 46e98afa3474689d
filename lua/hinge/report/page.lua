-- hinge report: one page of HTML about one run or several, which needs no network. It holds what the runs left in their
-- output folders, and the viewer (viewer.js, made from src/viewer by its build.sh), which draws it.
local core = require "hinge.core"
local check = require "hinge.library.check"
local render = require "hinge.render"
local runner = require "hinge.program.runner"
local values = require "hinge.library.values"
local quote = require "hinge.library.quote"

local page = {}
local library = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$"
local most_frames, most_rows, most_events = 400, 1500, 20000 -- of each run in the page; the rest is told of
local most_hinges = 5000

local function read(path) return (core.read_text(path)) end

local function json_number(text)
  local value = tonumber(text)
  return value and value == value and math.abs(value) < math.huge and text or "null"
end

-- The lines of a text but the first, which is given first: every n-th, so that they are not too many, and the last.
local function thinned(text, most)
  local lines = {}
  for line in text:gmatch "[^\r\n]+" do lines[#lines + 1] = line end
  local header = table.remove(lines, 1)
  local every, kept = math.max(1, math.ceil(#lines / most)), {}
  for i = 1, #lines, every do kept[#kept + 1] = lines[i] end
  if #lines > 0 and kept[#kept] ~= lines[#lines] then kept[#kept + 1] = lines[#lines] end
  return header, kept
end

-- history.csv: { "columns": [names], "values": [[of the first], ...] }
local function history_json(folder)
  local text = read(folder .. "/history.csv")
  local header, lines = thinned(text or "", most_rows)
  if not header then return "null" end
  local names, columns = values.csv_fields(header), {}
  for c = 1, #names do columns[c] = {} end
  for _, line in ipairs(lines) do
    local fields = values.csv_fields(line)
    for c = 1, #names do columns[c][#columns[c] + 1] = json_number(fields[c] or "") end
  end
  for c, column in ipairs(columns) do columns[c] = "[" .. table.concat(column, ",") .. "]" end
  return ('{"columns":%s,"values":[%s]}'):format(core.to_json(names), table.concat(columns, ","))
end

-- A CSV file: a list of rows, each a list as the header names them, and how many were left out.
local function rows_json(path, most)
  local text = read(path)
  if not text then return "null" end
  local rows, all, header = {}, 0, nil
  for line in text:gmatch "[^\r\n]+" do
    local fields = values.csv_fields(line)
    if not header then
      header = core.to_json(fields)
    else
      all = all + 1
      if all <= most then rows[all] = core.to_json(fields) end
    end
  end
  return ('{"columns":%s,"rows":[%s],"left_out":%d}'):format(header or "[]", table.concat(rows, ","), all - #rows)
end

-- At most so many frames, the last one among them.
local function chosen(frames)
  if #frames <= most_frames then return frames end
  local list = {}
  for i = 1, most_frames do list[i] = frames[math.floor(i * #frames / most_frames)] end
  return list
end

-- What the page takes of the frames. Returns JSON, how many frames, and those that cannot be read: { { file =,
-- problem = }, ... }.
local function frames_json(folder)
  if not read(folder .. "/frames.pvd") then return "null", 0, {} end
  local all = render.frames(folder)
  local files, damaged = {}, {}
  for i, frame in ipairs(chosen(all)) do files[i] = frame.file end
  local frames, count, problems = core.pack_frames(files, #all - #files)
  for i, file in ipairs(files) do
    if problems[i] then damaged[#damaged + 1] = { file = file, problem = problems[i] } end
  end
  return frames or "null", count, damaged
end

-- Names the frames that are not in the page, on stderr.
local function tell_damaged(damaged)
  for i, frame in ipairs(damaged) do
    if i > 8 then
      io.stderr:write(("hinge: not in the page: %s\n"):format(check.count(#damaged - 8, "more frame")))
      break
    end
    local named = frame.problem:find(frame.file, 1, true) and frame.problem or frame.file .. ": " .. frame.problem
    io.stderr:write(("hinge: not in the page: %s\n"):format(named))
  end
end

-- The units of probes, as the run left them beside its history; "null" for a run of an older version.
local function probes_json(folder)
  local text = read(folder .. "/probes.json")
  return text and type(core.from_json(text)) == "table" and text or "null"
end

-- The picture that hinge run --within has drawn, as the page embeds it; "null" where this run has none.
local function picture_json(path, summary)
  local told = summary and core.from_json(summary)
  local bytes = type(told) == "table" and told.accuracy and read(path)
  return bytes and ('"data:image/png;base64,%s"'):format(core.base64(bytes)) or "null"
end

local function name_of(folder) return folder:match "([^/]+)/*$" or folder end

-- The names of the folders: their last part, where that tells them apart.
local function names(folders)
  local list, seen = {}, {}
  for i, folder in ipairs(folders) do
    list[i] = name_of(folder)
    if seen[list[i]] then return folders end
    seen[list[i]] = true
  end
  return list
end

local function run_json(folder, name)
  local summary, owner = read(folder .. "/summary.json"), read(folder .. "/run.json")
  local has_frames = read(folder .. "/frames.pvd") ~= nil
  if not summary and not has_frames and not read(folder .. "/history.csv") then
    check.fail("no run was written to %s: it has neither summary.json nor frames.pvd nor history.csv; hinge run SCRIPT "
      .. "--out DIR makes one", folder)
  end
  if summary and type(core.from_json(summary)) ~= "table" then
    check.fail("%s/summary.json is not whole; run the script again", folder)
  end
  if owner and type(core.from_json(owner)) ~= "table" then owner = nil end
  local frames, count, damaged = frames_json(folder)
  local fields = { { "name", core.to_json(name) }, { "summary", summary or "null" },
    { "owner", not summary and owner or "null" }, { "history", history_json(folder) },
    { "probes", probes_json(folder) }, { "events", rows_json(folder .. "/events.csv", most_events) },
    { "hinges", rows_json(folder .. "/hinges.csv", most_hinges) }, { "frames", frames },
    { "accuracy_picture", picture_json(folder .. "/accuracy.png", summary) },
    { "damaged", #damaged > 0 and core.to_json(damaged) or "[]" } }
  for i, field in ipairs(fields) do fields[i] = ('"%s":%s'):format(field[1], field[2]) end
  return "{" .. table.concat(fields, ",") .. "}", count, damaged
end

local template = [[
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy"
  content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:%s">
%s<title>hinge report</title>
</head>
<body>
<noscript>This page draws what a run of hinge has left. It needs JavaScript, and no network.</noscript>
<main id="report"></main>
<script type="application/json" id="data">%s</script>
<script>
%s</script>
</body>
</html>
]]

local function with_data(data, may_ask)
  local viewer = read(library .. "viewer.js") or check.fail("%sviewer.js is not there; src/viewer/build.sh makes it",
    library)
  local icon = '<link rel="icon" href="data:,">\n' -- or a browser asks for one
  return template:format(may_ask and "; connect-src 'self'" or "", may_ask and icon or "", quote.json_in_html(data),
    viewer)
end

--- The page of hinge run --live, which asks the program that serves it for all it shows. `id`: the program's own.
function page.live(id) return with_data(('{"live":%s}'):format(core.to_json(id)), true) end

--- The page about the runs in these folders, as text; how many frames it has, and those that cannot be read.
function page.text(folders)
  local runs, frames, all_damaged = {}, 0, {}
  local called = names(folders)
  for i, folder in ipairs(folders) do
    local count, damaged
    runs[i], count, damaged = run_json(folder, called[i])
    frames = frames + count
    table.move(damaged, 1, #damaged, #all_damaged + 1, all_damaged)
  end
  return with_data(('{"runs":[%s]}'):format(table.concat(runs, ","))), frames, all_damaged
end

--- options: folders (output folders), out (a file, or nil for report.html in the first folder). Returns the program's
-- exit status: 1 where the page is made, and frames are not in it because they cannot be read.
function page.main(options)
  return runner.guard(function()
    local folders = {}
    for i, folder in ipairs(options.folders) do folders[i] = #folder > 1 and folder:gsub("/+$", "") or folder end
    local text, frames, damaged = page.text(folders)
    local out = options.out or folders[1] .. "/report.html"
    core.write_text(out, text)
    print(("%s: %s, %s, %.1f MB"):format(out, check.count(#folders, "run"), check.count(frames, "frame"), #text / 1e6))
    tell_damaged(damaged)
    if frames == 0 and #damaged == 0 then
      print("no frames, so nothing to look at in 3D; a script asks for them with job:frame(run) or hinge.frame(run)")
    end
    return #damaged > 0 and 1 or 0
  end)
end

return page

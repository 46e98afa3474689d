-- The options of hinge render, read from the command line's text and checked before anything is drawn.
local broken = require "hinge.accuracy.broken"
local core = require "hinge.core"
local check = require "hinge.library.check"
local film = require "hinge.render.film"
local values = require "hinge.library.values"
local view = require "hinge.render.view"

local options = {}

-- What members of frames may show: what those of a run's own pictures may, and what several runs have told.
local shows = table.move(view.shows, 1, #view.shows, 1, {})
table.insert(shows, 3, "broken")

local smallest, largest = 64, 8192 -- pixels, as the pictures' own limits
local formats = { "gif", "mp4", "webm" }
local fastest_gif = 50             -- viewers slow down a GIF that is faster

local function one_of(option, text, names)
  if not text then return nil end
  for _, name in ipairs(names) do
    if text == name then return text end
  end
  check.fail("%s %s: must be one of %s%s", option, text, table.concat(names, ", "), core.did_you_mean(text, names))
end

-- A number above 0, at most `most`.
local function number(option, text, unit, most)
  local value = text and values.number(text)
  if text and (not value or value <= 0 or value > most) then
    check.fail("%s %s: must be a number above 0 and at most %g%s", option, text, most, unit)
  end
  return value
end

local function size(text)
  if not text then return nil end
  local width, height = text:match "^(%d+)[xX](%d+)$"
  width, height = math.tointeger(tonumber(width)), math.tointeger(tonumber(height))
  local function good(side) return side and side >= smallest and side <= largest end
  if not good(width) or not good(height) then
    check.fail("--size %s: must be width and height in pixels, such as 1920x1080, each from %d to %d", text, smallest,
      largest)
  end
  return { width, height }
end

-- "1,-2,0.5" as a direction.
local function direction(text)
  if not text then return nil end
  local list, not_zero = {}, false
  for item in (text .. ","):gmatch "([^,]*)," do
    list[#list + 1] = values.number(item)
    if not list[#list] then break end
    not_zero = not_zero or list[#list] ~= 0
  end
  if #list ~= 3 or select(2, text:gsub(",", "")) ~= 2 or not not_zero then
    check.fail("--from %s: must be a direction from the scene to the eye: three numbers such as -1,-1.4,0.55, not "
      .. "all 0", text)
  end
  return list
end

-- "y=0" as { y = 0 }; several planes are separated by commas.
local function planes(text)
  if not text then return nil end
  local found = {}
  for item in (text .. ","):gmatch "([^,]*)," do
    local axis, at = item:match "^%s*([xyz])%s*=(.*)$"
    at = at and values.number(at)
    if not at or found[axis] then
      check.fail("--plane %s: must be x, y or z with a number of metres, such as y=0%s", text,
        at and "; " .. axis .. " is given twice" or "")
    end
    found[axis] = at
  end
  return found
end

local function group_list(text)
  if not text then return nil end
  local list = {}
  for name in text:gmatch "[^,]+" do list[#list + 1] = name end
  if #list == 0 then check.fail("--groups %s: must be names of groups, such as columns,beams", text) end
  return list
end

-- The film's format: what an option asks for, else what its file's name ends with; nil for no film.
local function format_of(given)
  local asked
  for _, format in ipairs(formats) do
    if given[format] and asked then check.fail("--%s: one film at a time; --%s is asked for, too", format, asked) end
    if given[format] then asked = format end
  end
  if given.film and asked then given.film = nil end
  local ending = given.film_file and given.film_file:lower():match "%.(%w+)$"
  local named = ending and film.formats[ending] and ending
  if given.film_file and not named then
    check.fail("--out %s: must end in .mp4, .webm or .gif", given.film_file)
  end
  if asked and named and asked ~= named then
    check.fail("--out %s: the name of a film made by --%s ends in .%s", given.film_file, asked, asked)
  end
  return asked or named
end

-- The format, or another one where --film leaves the choice; and a note about that.
local function possible_format(given)
  local format = format_of(given)
  if format then
    local lack = film.lacks(format)
    if lack then
      check.fail("--%s: %s; a GIF needs no other program: --gif", format, lack)
    end
    return format
  end
  if not given.film then return nil end
  local lack = film.lacks "mp4"
  return lack and "gif" or "mp4", lack and ("a GIF, for an MP4 cannot be written: " .. lack)
end

--- given: texts by name, as src/main.cpp collects them. Returns { folder, view, format (nil for pictures alone), file,
-- fps, seconds, jobs, note }.
function options.read(given)
  if given.view and given.from then check.fail "--from: --view is given, too; one of them says where the eye is" end
  local what = { folder = given.out, fps = number("--fps", given.fps, " pictures a second", 240),
    seconds = number("--seconds", given.seconds, " s", 86400),
    jobs = values.whole("-j", given.jobs, 1) or core.cores() }
  local pixels = size(given.size)
  what.view = { view = one_of("--view", given.view, view.names), from = direction(given.from),
    scale = given.scale == "auto" and "auto" or number("--scale", given.scale, ", or auto", 1e9),
    ghost = given.ghost and true or nil, loads = given.loads and true or nil, labels = given.labels and true or nil,
    show = one_of("--show", given.show, shows), groups = group_list(given.groups), plane = planes(given.plane),
    title = given.title or not given.show and "yield function f_y" or nil }
  if what.view.show == "broken" then
    what.view.broken_in = broken.of_folder("--show broken", what.folder)
    what.view.title = given.title or ("who broke, in %d runs"):format(what.view.broken_in.runs)
  end
  what.format, what.note = possible_format(given)
  if not what.format then
    for _, name in ipairs { "fps", "seconds" } do
      if given[name] then check.fail("--%s %s: is for films; add --film, --mp4, --webm or --gif", name, given[name]) end
    end
  end
  what.fps = what.fps or 25
  if what.format == "gif" and what.fps > fastest_gif then
    check.fail("--fps %s: a GIF shows at most %d pictures a second", given.fps, fastest_gif)
  end
  pixels = pixels or what.format == "gif" and { 960, 540 } or what.format and { 1920, 1080 } or { 1600, 1200 }
  if what.format and what.format ~= "gif" and (pixels[1] % 2 == 1 or pixels[2] % 2 == 1) then
    check.fail("--size %s: %s takes even numbers", given.size, film.formats[what.format].name)
  end
  what.view.width, what.view.height = pixels[1], pixels[2]
  what.file = what.format and (given.film_file or what.folder:gsub("/*$", "") .. "/film." .. what.format)
  return what
end

return options

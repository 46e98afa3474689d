-- Films: which frame is seen when, and what writes MP4, WebM and GIF.
local core = require "hinge.core"
local check = require "hinge.library.check"
local quote = require "hinge.library.quote"

local film = {}

--- What can be written: the encoder of the program ffmpeg and its options; GIF needs neither.
film.formats = {
  mp4 = { name = "MP4", encoder = "libx264",
    options = "-c:v libx264 -preset medium -crf 18 -pix_fmt yuv420p -movflags +faststart -f mp4" },
  webm = { name = "WebM", encoder = "libvpx-vp9",
    options = "-c:v libvpx-vp9 -crf 24 -b:v 0 -deadline good -cpu-used 5 -row-mt 1 -tile-columns 2 -pix_fmt yuv420p "
      .. "-f webm" },
  gif = { name = "GIF" },
}

-- The encoders that ffmpeg has, as text; nil where there is no ffmpeg.
local function encoders()
  local pipe = io.popen "{ ffmpeg -hide_banner -encoders ; } 2>/dev/null </dev/null"
  local text = pipe and pipe:read "a" or ""
  if pipe then pipe:close() end
  return text ~= "" and text or nil
end

--- Nil where this format can be written here, else why not and what to do.
function film.lacks(format)
  local encoder = film.formats[format].encoder
  if not encoder then return nil end
  local list = encoders()
  if list and list:find(" " .. encoder .. " ", 1, true) then return nil end
  return list and ("the ffmpeg that is installed has no encoder %s"):format(encoder)
    or "the program ffmpeg is not installed (apt-get install ffmpeg)"
end

--- Which frame is seen how long. times: of the frames, s; fps: pictures a second; seconds: how long the film is, nil
-- for as many pictures as frames. Time in the film is proportional to time in the run, so a frame is seen while it is
-- the nearest; the first and the last one stand for half a mean interval beyond, too. Frames whose times do not go
-- forward are seen equally long, and those of statics (even = true). Returns a list of { frame = its number, pictures =
-- how many }; how long the film is, s; and how long what it shows took, s, or nil for frames without times.
function film.schedule(times, fps, seconds, even)
  local n = #times
  local goes_forward = n > 1 and not even and times[n] > times[1]
  for i = 2, n do goes_forward = goes_forward and times[i] >= times[i - 1] end
  local pictures = seconds and math.max(1, math.floor(seconds * fps + 0.5)) or n
  local span = goes_forward and (times[n] - times[1]) * n / (n - 1) or nil
  local list, at = {}, 1
  for k = 0, pictures - 1 do
    if span then
      local t = times[1] + span * ((k + 0.5) / pictures - 0.5 / n)
      while at < n and math.abs(times[at + 1] - t) <= math.abs(times[at] - t) do at = at + 1 end
    else
      at = 1 + k * n // pictures
    end
    local last = list[#list]
    if last and last.frame == at then last.pictures = last.pictures + 1
    else list[#list + 1] = { frame = at, pictures = 1 } end
  end
  return list, pictures / fps, span
end

--- How long a film is and how slow, in words. Both times as film.schedule gives them.
function film.speed_text(length, span)
  local text = ("%.3g s"):format(length)
  if not span then return text end
  local slower = length / span
  local how = slower >= 1.05 and ("%.3g times slower"):format(slower)
    or slower <= 0.95 and ("%.3g times faster"):format(1 / slower) or "as fast as it was"
  return ("%s for %.3g s: %s"):format(text, span, how)
end

--- Writes the film `path` of pictures (PNG files, in order, each with `pictures`, how many there are of it), and counts
-- on the shared number `steps`, to film.steps(...). Called in a process of its own.
function film.write(format, path, list, fps, folder, steps)
  if format == "gif" then
    local files, hundredths, seen, told = {}, {}, 0, 0
    for i, one in ipairs(list) do
      seen = seen + one.pictures
      files[i], hundredths[i] = one.file, math.floor(100 * seen / fps + 0.5) - told
      told = told + hundredths[i]
    end
    core.write_gif(path, files, hundredths, steps)
    return
  end
  local command = ("exec ffmpeg -nostdin -hide_banner -loglevel error -y -f image2pipe -c:v png -framerate %.10g -i - "
    .. "-an -vf scale=out_color_matrix=bt709:out_range=tv -colorspace bt709 -color_primaries bt709 -color_trc bt709 %s "
    .. "%s 2>%s"):format(fps, film.formats[format].options, quote.shell("file:" .. path),
    quote.shell(folder .. "/encoder.txt"))
  local pipe = assert(io.popen(command, "w"))
  for _, one in ipairs(list) do
    local bytes = assert(core.read_text(one.file))
    for _ = 1, one.pictures do
      pipe:write(bytes)
      steps:next()
    end
  end
  local _, how, code = pipe:close()
  if how ~= "exit" or code ~= 0 then check.fail("ffmpeg ended with %s %s", how, code) end
end

--- How far film.write counts.
function film.steps(format, list)
  if format == "gif" then return 2 * #list end
  local sum = 0
  for _, one in ipairs(list) do sum = sum + one.pictures end
  return sum
end

--- What ffmpeg complained of last, or nil.
function film.complaint(folder)
  return (core.read_text(folder .. "/encoder.txt") or ""):match "([^\n]+)%s*$"
end

return film

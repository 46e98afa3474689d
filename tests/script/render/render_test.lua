-- hinge render: films and pictures of a run's frames; how long each frame is seen, what a GIF holds, what MP4 and WebM
-- are where ffmpeg is installed, options that are wrong, frames that are broken, Ctrl-C, a full disk, the same bytes
-- for any number of processes.
--
-- Run: lua5.4 tests/script/render/render_test.lua BUILD
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local gif = require "render.gif"
local checks = support.checks "render"
local case, ended = checks.case, checks.ended
local quote, expect, equal, near = support.quote, checks.expect, checks.equal, checks.near
local hinge_on, folder = support.scenes(arg[1])
local hinge = quote(arg[1] .. "/hinge")
require "hinge"
local film = require "hinge.render.film"

-- How long each frame is seen --------------------------------------------------------------------------------------

local function seen(...)
  local list, length, span = film.schedule(...)
  local parts = {}
  for i, one in ipairs(list) do parts[i] = ("%d*%d"):format(one.frame, one.pictures) end
  return table.concat(parts, " "), length, span
end
case("a frame of a film is seen as long as it is the nearest in time", function()
  local order, length, span = seen({ 0.1, 0.2, 0.3, 0.4 }, 25)
  equal(order, "1*1 2*1 3*1 4*1", "even frames")
  near(length, 0.16, 1e-12, "length of four pictures at 25 a second")
  near(span, 0.4, 1e-12, "how long what it shows took")
  equal(seen({ 0.0025000000000000057, 0.0049999999999999645, 0.0075, 0.0100000000001, 0.0125 }, 25),
    "1*1 2*1 3*1 4*1 5*1", "even frames, rounded")
  equal(seen({ 0, 1, 2, 10 }, 10, 1.1), "1*2 2*1 3*3 4*5", "a frame stays until the next one is nearer")
  equal(seen({ 0, 0.1, 0.2, 5, 10 }, 10, 0.3), "3*1 4*1 5*1", "frames that are too close for the film")
  equal(seen({ 0, 1 }, 25, 0.2), "1*2 2*3", "two frames")
  equal(seen({ 3 }, 25), "1*1", "one frame")
  order, length, span = seen({ 0, 1, 0, 1 }, 25, 8 / 25)
  equal(order, "1*2 2*2 3*2 4*2", "times that go back")
  near(length, 8 / 25, 1e-12, "its length")
  equal(span, nil, "it shows no span of time")
  equal(seen({ 0, 1, 5 }, 25, nil, true), "1*1 2*1 3*1", "of statics")
  equal(film.speed_text(12, 0.6), "12 s for 0.6 s: 20 times slower", "in words")
  equal(film.speed_text(2, 20), "2 s for 20 s: 10 times faster", "in words, faster")
  equal(film.speed_text(2, 2), "2 s for 2 s: as fast as it was", "in words, as fast")
  equal(film.speed_text(2, nil), "2 s", "in words, without times")
end)

-- A column that stands, and a bar that falls beside it and far down.
local scene = [=[
local hinge = require "hinge"
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local bar = hinge.section.solid { width = 0.2, depth = 0.2 }
local model = hinge.model()
local foot = model:node { 0, 0, 0 }
model:fix(foot)
model:member { foot, model:node { 0, 0, 3 }, section = bar, material = steel, group = "column" }
model:member { model:node { 1, 0, 3 }, model:node { 3, 0, 3 }, section = bar, material = steel, group = "falling" }
model:gravity { 0, 0, -9.81 }
local run = model:dynamic { dt = 1e-2, duration = 0.6 }
for step in run:steps() do
  if step.index % 10 == 0 then hinge.frame(run) end
end
]=]
assert(hinge_on("run -q", scene, "--out one") == 0, "the scene")

-- Runs a command in that folder, hinge render there, and gives what that prints and complains of; it ends with `status`
-- and these words.
local function there(command) return support.run(("cd %s && %s"):format(quote(folder), command)) end
local function render(status, words, arguments, before)
  return ended(status, words, there(("%s %s render %s"):format(before or "", hinge, arguments)))
end
local function read(path) return support.read(folder .. "/" .. path) end
local function left_over()
  return select(2, there "find . -name '.hinge-render*' -o -name '*.part'")
end

-- A GIF ------------------------------------------------------------------------------------------------------------

local small = " --size 160x120 "
case("hinge render --gif writes a film and says how fast it is", function()
  local printed, complaint = render(0, "", "one --gif -j 1" .. small)
  equal(complaint, "", "on stderr, which is no terminal")
  expect(printed:find "^one/film%.gif: 0%.24 s for 0%.6 s: 2%.5 times faster; 6 pictures of 160 x 120, %d+ kB\n$",
    "it says %s", printed)
end)

local function gif_of(path) return gif.read(assert(read(path), path)) end
local movie = gif_of "one/film.gif"
case("the GIF has the size, the length and the pictures that it should", function()
  equal(movie.width, 160, "width of the GIF")
  equal(movie.height, 120, "height of the GIF")
  equal(movie.loops, 0, "it repeats for ever")
  equal(#movie.frames, 6, "its pictures")
  local hundredths, smaller = 0, 0
  for i, frame in ipairs(movie.frames) do
    hundredths = hundredths + frame.delay
    if i > 1 and frame.width * frame.height < 0.7 * 160 * 120 then smaller = smaller + 1 end
  end
  equal(hundredths, 24, "its length, 1/100 s")
  equal(movie.frames[1].width * movie.frames[1].height, 160 * 120, "pixels of its first picture")
  equal(smaller, 5, "pictures that hold only what changed")
end)

case("a film shows the column where it stands and the bar as it falls", function()
  local function blue_in(frame, from_x, to_x)
    local count, highest = 0, nil
    for y = 20, 95 do -- between title and legend
      for x = from_x, to_x do
        local r, g, b = table.unpack(frame.pixel(x, y))
        if b > r + 40 and b > g + 10 then count, highest = count + 1, highest or y end
      end
    end
    return count, highest or math.huge
  end
  local function columns_of(frame) -- the pixels' columns in which there is blue
    local list = {}
    for x = 0, 159 do
      if blue_in(frame, x, x) > 0 then list[#list + 1] = x end
    end
    return list
  end
  if #movie.frames == 6 then
    local first, last = movie.frames[1], movie.frames[6]
    equal(table.concat(first.pixel(2, 60), " "), "255 255 255", "paper")
    local left = columns_of(first)[1] or 0
    local all, top = blue_in(first, left, left + 8)
    expect(all > 30, "the column has %d pixels", all)
    for i, frame in ipairs(movie.frames) do
      local now, at = blue_in(frame, left, left + 8)
      expect(now == all and at == top, "picture %d: the column has %d pixels from row %s on, not %d from row %s", i,
        now,
        at, all, top)
    end
    local _, high = blue_in(first, left + 12, 159)
    local count, low = blue_in(last, left + 12, 159)
    expect(count > 5 and low > high + 15, "the bar falls from row %s to row %s", high, low)
  end
end)

case("one process and two draw the same bytes, as a film and as single pictures", function()
  render(0, "", "one --gif -j 2 --out two.gif" .. small)
  checks.same_files(folder .. "/one/film.gif", folder .. "/two.gif", "by two processes")
  render(0, "", "one --gif --fps 50 --seconds 0.5 --out slow.gif --groups column --title Column --from 0,-1,0" .. small)
  local slow = gif_of "slow.gif"
  equal(#slow.frames, 6, "pictures of a film of half a second")
  local hundredths = 0
  for _, frame in ipairs(slow.frames) do hundredths = hundredths + frame.delay end
  equal(hundredths, 50, "its length, 1/100 s")
  for i, frame in ipairs(slow.frames) do -- nothing moves but the time in the corner
    expect(i == 1 or frame.top + frame.height < 20, "--groups: something moves in row %d", frame.top + frame.height)
  end
  equal(render(0, "", "one -j 1" .. small), "6 pictures in one\n", "pictures alone")
  there "cd one && mkdir alone && mv frames/*.png alone"
  render(0, "", "one -j 2" .. small)
  for i = 1, 6 do
    local name = ("/frame_%05d.png"):format(i)
    checks.same_files(folder .. "/one/alone" .. name, folder .. "/one/frames" .. name, "by two processes")
  end
  expect((read "one/frames/frame_00001.png" or ""):sub(1, 24) == "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\xa0\0\0\0\x78",
    "a picture of 160 x 120")
  equal(left_over(), "", "what is left over")
end)

-- What lay in a plane at the start: the column alone, or the bar alone although it falls; seen across the plane.
local function drawn(options)
  equal(render(0, "", "one -j 1 --title x " .. options .. small), "6 pictures in one\n", options)
  return read "one/frames/frame_00005.png"
end
case("--plane draws what lay in the plane at the start", function()
  for plane, view in pairs { ["x=0"] = "--groups column --view right", ["z = 1+2"] = "--groups falling --view top",
      ["x=0,y=0' --view 'iso"] = "--groups column --view iso" } do
    equal(drawn(("--plane '%s'"):format(plane)) == drawn(view), true, ("--plane %s is as %s"):format(plane, view))
  end
end)

-- What is shown: the same in all frames, of a cantilever under a load that grows.
local loaded = [=[
local hinge = require "hinge"
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local model = hinge.model()
local foot, tip = model:node { 0, 0, 0 }, model:node { 4, 0, 0 }
model:fix(foot)
model:member { foot, tip, section = hinge.section.solid { width = 0.1, depth = 0.2 }, material = steel }
model:load { node = tip, force = { 0, 0, -4e3 } }
local run = model:static { steps = 4 }
for step in run:steps() do hinge.frame(run) end
]=]
assert(hinge_on("run -q", loaded, "--out loaded") == 0, "a cantilever")
local core = require "hinge.core"
local function frame_of(i) return ("%s/loaded/frames/frame_%05d.vtp"):format(folder, i) end
local function picture_of(i) return read(("loaded/frames/frame_%05d.png"):format(i)) end
local function view_of_all(view) -- the box and the largest values of all frames
  for i = 1, 4 do
    local one, box = core.frame_box(frame_of(i), view), view.box
    for c = 1, 6 do one.box[c] = box and (c % 2 == 1 and math.min or math.max)(box[c], one.box[c]) or one.box[c] end
    view.box, view.largest = one.box, one.largest > 0 and one.largest or nil
  end
  view.width, view.height = 160, 120
  return view
end
local scale = {}
case("a picture has one scale for all frames and shows what its options say", function()
  for i = 1, 4 do scale[i] = core.frame_box(frame_of(i), { scale = "auto" }).scale end
  expect(scale[1] > 2 * scale[4] and scale[4] > 1, "the scale is %g of the first frame, %g of the last", scale[1],
    scale[4])
  local plain = {}
  for option, view in pairs { [""] = {}, ["--view front"] = { view = "front" }, ["--scale auto"] = { scale = scale[4] },
      ["--ghost --scale 30"] = { ghost = true, scale = 30 }, ["--show Mx"] = { show = "Mx" },
      ["--show N"] = { show = "N" }, ["--show none"] = { show = "none" },
      ["--loads --labels"] = { loads = true, labels = true }, ["--from 0,-1,0"] = { from = { 0, -1, 0 } } } do
    equal(render(0, "", "loaded -j 1 --title x " .. option .. small), "4 pictures in loaded\n", option)
    view.title = "x"
    view_of_all(view)
    for i = 1, 4, 3 do
      core.render_file(frame_of(i), folder .. "/expected.png", view)
      expect(picture_of(i) == read "expected.png", "%s: picture %d is not what the view shows", option, i)
      for other, bytes in pairs(plain) do expect(bytes ~= picture_of(i), "%s looks like %s", option, other) end
    end
    plain[option] = picture_of(4)
  end
end)

-- What hinge run --within tells of the scene's two members, the column and the bar that falls.
local function tell_broken(broken)
  local path = folder .. "/told/summary.json"
  local summary = core.from_json(support.read(path))
  summary.accuracy = { broken = broken }
  core.write_json(path, summary)
end
case("--show broken colours members by the runs in which they broke", function()
  there "cp -r one told"
  local is = {
    grey = function(r, g, b) return r < 235 and g >= r and b >= g and b < r + 30 and r > 100 end,
    orange = function(r, g, b) return r > g + 40 and g > b + 40 end,
    red = function(r, g, b) return r > 2.5 * g and r > 2.5 * b and r > 90 end,
    black = function(r, g, b) return r + g + b < 120 end,
  }
  for counts, colours in pairs { [{ 5, 2 }] = "black orange", [{ 3 }] = "red grey" } do
    local list = {}
    for member, count in ipairs(counts) do list[member] = { member = member, broken = count } end
    tell_broken { runs = 5, members = 2, list = list }
    render(0, "", "told --show broken --gif -j 1 --from 0,-1,0" .. small)
    local first = gif_of("told/film.gif").frames[1]
    local function most(from_x, to_x) -- the colour of most pixels, between title and supports
      local count, found = {}, nil
      for x = from_x, to_x do
        for y = 18, 80 do
          for name, test in pairs(is) do
            if test(table.unpack(first.pixel(x, y))) then
              count[name] = (count[name] or 0) + 1
              if not found or count[name] > count[found] then found = name end
            end
          end
        end
      end
      return found
    end
    equal(("%s %s"):format(most(30, 58), most(62, 159)), colours, "column and bar")
  end
  tell_broken { runs = 5, members = 3, list = { { member = 3, broken = 5 } } }
  render(1, "is of a structure of 3 members, and this frame has 2", "told --show broken" .. small)
  tell_broken { runs = 5, members = 2 }
  render(2, "hinge: --show broken: no member broke in any of the 5 runs", "told --show broken")
  tell_broken { runs = 1, members = 2, list = { { member = 1, broken = 1 } } }
  render(2, "hinge: --show broken: there is one run alone", "told --show broken")
  there "rm -r told"
end)

case("pictures in which the structure is small say so, and what draws it larger", function()
  local far = scene:gsub("duration = 0%.6", "duration = 2"):gsub("%% 10 ==", "%% 100 ==")
  equal(hinge_on("run -q", far, "--out far"), 0, "the scene")
  local _, complaint = render(0, "", "far -j 1" .. small)
  -- the bar falls by 19.6 m beside a column of 3 m
  local x, z = complaint:match "^hinge: all pictures show ([%d.]+) x [%d.e-]+ x ([%d.]+) m, so that nothing leaves them"
  near(tonumber(x) or 0 / 0, 3, 0.2, "the width that all pictures show, m: " .. complaint)
  near(tonumber(z) or 0 / 0, 20, 3, "and the height")
  expect(complaint:find("--groups NAMES", 1, true), "what to do: %s", complaint)
  equal(select(2, render(0, "", "far -j 1 --groups column" .. small)), "", "the column alone")
end)

-- Other formats, where there is ffmpeg.
local function installed(program) return support.run("command -v " .. program) == 0 end
local encoders = installed "ffmpeg" and support.output "ffmpeg -hide_banner -encoders 2>/dev/null" or ""
local function stream(path)
  return select(2, there("ffprobe -v error -count_frames -select_streams v -show_entries "
    .. "stream=codec_name,width,height,pix_fmt,nb_read_frames,r_frame_rate -of csv=p=0 " .. path .. " 2>&1"))
end
if encoders:find " libx264 " and installed "ffprobe" then
  case("an MP4 of H.264 is written by ffmpeg", function()
    render(0, "", "one --film" .. small)
    equal(stream "one/film.mp4", "h264,160,120,yuv420p,25/1,6\n", "an MP4")
    local bytes = read "one/film.mp4" or ""
    expect((bytes:find("moov", 1, true) or math.huge) < (bytes:find("mdat", 1, true) or 0),
      "an MP4 that begins before all of it is there")
    render(0, "", "one --mp4 -j 2 --seconds 2 --out 'a film.mp4'" .. small)
    equal(stream "'a film.mp4'", "h264,160,120,yuv420p,25/1,50\n", "an MP4 of two seconds")
  end)
else
  print "render: MP4 is not tested: no ffmpeg with libx264, or no ffprobe"
end
if encoders:find " libvpx%-vp9 " and installed "ffprobe" then
  case("a WebM of VP9 is written by ffmpeg", function()
    render(0, "", "one --out one/film.webm" .. small)
    equal(stream "one/film.webm", "vp9,160,120,yuv420p,25/1,6\n", "a WebM")
  end)
else
  print "render: WebM is not tested: no ffmpeg with libvpx-vp9, or no ffprobe"
end

there "mkdir bin && cd bin && for t in sh Xvfb; do ln -s $(command -v $t) $t; done" -- all but ffmpeg
case("without ffmpeg --mp4 is refused and --film writes a GIF", function()
  local without = ("PATH=%s/bin"):format(quote(folder))
  local printed = render(2, { "hinge: --mp4: the program ffmpeg is not installed (apt-get install ffmpeg)", "--gif" },
    "one --mp4" .. small, without)
  equal(printed, "", "it prints nothing")
  os.remove(folder .. "/one/film.gif")
  local said, complaint = render(0, "one/film.gif: ", "one --film" .. small, without)
  expect(said:find "^one/film%.gif: " and complaint:find("hinge: a GIF, for an MP4 cannot be written: the program "
    .. "ffmpeg is not installed", 1, true), "--film without ffmpeg: %s%s", said, complaint)
  equal(#gif_of "one/film.gif".frames, 6, "its pictures")
end)

case("wrong options of hinge render are named and nothing is drawn", function()
  local _, there_before = there "find . | sort"
  for arguments, text in pairs {
    ["--gif --mp4"] = "--mp4: one film at a time; --gif is asked for, too",
    ["--view frnt"] = "--view frnt: must be one of front, back, left, right, top, iso, perspective "
      .. "(did you mean 'front'?)",
    ["--view top --from 1,0,0"] = "--from: --view is given, too",
    ["--from 1,2"] = "--from 1,2: must be a direction", ["--from 0,0,0"] = "--from 0,0,0: must be a direction",
    ["--from 1,2,3,"] = "--from 1,2,3,: must be a direction", ["--from a,b,c"] = "--from a,b,c: must be a direction",
    ["--scale=-1"] = "--scale -1: must be a number above 0", ["--scale nan"] = "--scale nan: must be a number above 0",
    ["--show M"] = "--show M: must be one of f_y, group, broken, none, N, Qx,",
    ["--show broken"] = "--show broken: one/summary.json does not say who broke in several runs; "
      .. "hinge run SCRIPT --within 5% writes that",
    ["--size 160"] = "--size 160: must be width and height",
    ["--size 160x9000"] = "--size 160x9000: must be width and height",
    ["--size 161x120 --out a.webm"] = encoders:find " libvpx%-vp9 " and "--size 161x120: WebM takes even numbers"
      or "--webm: ",
    ["--gif --fps 0"] = "--fps 0: must be a number above 0", ["--gif --fps 60"] = "--fps 60: a GIF shows at most 50",
    ["--fps 20"] = "--fps 20: is for films", ["--gif --seconds inf"] = "--seconds inf: must be a number above 0",
    ["--gif --seconds 86401"] = "--seconds 86401: must be a number above 0 and at most 86400 s",
    ["-j 0"] = "-j 0: must be a whole number of at least 1", ["-j 1.5"] = "-j 1.5: must be a whole number",
    ["--out a.avi"] = "--out a.avi: must end in .mp4, .webm or .gif",
    ["--out a.mp4 --gif"] = "--out a.mp4: the name of a film made by --gif ends in .gif",
    ["--groups colum"] = "--groups: unknown group 'colum' (did you mean 'column'?); there are column, falling",
    ["--plane y=2"] = "--plane: y = 2 m, where no member lies; must be a plane of members: y = 0 m",
    ["--plane y"] = "--plane y: must be x, y or z with a number of metres, such as y=0",
    ["--plane w=0"] = "--plane w=0: must be x, y or z with", ["--plane y=2m"] = "--plane y=2m: must be x, y or z with",
    ["--plane y=0,y=1"] = "--plane y=0,y=1: must be x, y or z with a number of metres, such as y=0; y is given twice",
    ["--plane y=0,"] = "--plane y=0,: must be x, y or z with",
    ["--plane y=inf"] = "--plane y=inf: must be x, y or z with",
    ["--groups ,"] = "--groups ,: must be names of groups",
  } do
    equal(render(2, "hinge: " .. text, "one " .. arguments), "", arguments .. " prints")
  end
  equal(render(2, "--colour", "one --colour red"), "", "an unknown option prints")
  equal(select(2, there "find . | sort"), there_before, "files after wrong options")
end)

case("frames that cannot be read are named and the others drawn", function()
  there("cp -r one broken && cd broken/frames && rm *.png frame_00002.vtp && "
    .. "head -c 900 frame_00005.vtp >x && mv x frame_00005.vtp")
  equal(render(1, { "hinge: not drawn: cannot read broken/frames/frame_00002.vtp: No such file or directory",
    "hinge: not drawn: cannot read broken/frames/frame_00005.vtp: it is damaged" }, "broken" .. small),
    "4 pictures in broken\n", "broken frames: printed")
  for i = 1, 6 do
    equal(read(("broken/frames/frame_%05d.png"):format(i)) ~= nil, i ~= 2 and i ~= 5,
      ("a picture of frame %d"):format(i))
  end
  local printed = render(1, "frame_00005.vtp", "broken --gif" .. small)
  expect(printed:find "^broken/film%.gif: 0%.24 s .* 4 pictures", "a film of broken frames: %s", printed)
  local held = {}
  for i, frame in ipairs(gif_of "broken/film.gif".frames) do held[i] = frame.delay end
  equal(table.concat(held, " "), "8 4 8 4", "the frame before a broken one stays")
  there "rm broken/frames/*.vtp broken/film.gif"
  printed = render(1, { "hinge: no film: none of 6 frames could be drawn", "frame_00001.vtp: No such file",
    "hinge: not drawn for the same reason: frame_00002.vtp, frame_00003.vtp, " }, "broken --gif" .. small)
  expect(printed == "" and read "broken/film.gif" == nil, "without any frame: %s", printed)
end)

local function in_time(words) return there(("timeout 20 %s %s"):format(hinge, words)) end
case("a pipe in the place of a frame is named and not waited for", function()
  there "cp -r one strange && cd strange/frames && rm *.png frame_00002.vtp && mkfifo frame_00002.vtp"
  equal(ended(1, "hinge: not drawn: cannot read strange/frames/frame_00002.vtp: it is a pipe",
    in_time("render strange" .. small)), "5 pictures in strange\n", "with a pipe")
  there "cd strange && rm history.csv && mkfifo history.csv"
  local printed = ended(1, "", in_time "report strange")
  expect(printed:find "^strange/report.html: 1 run, 5 frames", "a report with pipes: %s", printed)
end)

case("frames outside the folder are refused", function()
  -- a picture would be written beside them; so is a link that leads out of it
  there "cp -r one elsewhere && rm elsewhere/frames/*.png"
  local _, elsewhere = there "ls elsewhere/frames"
  local whole = support.output("readlink -f " .. quote(folder)):gsub("%s+$", "")
  for _, frame in ipairs { "../elsewhere/frames/frame_00001.vtp", whole .. "/elsewhere/frames/frame_00001.vtp",
    "frames/../../elsewhere/frames/frame_00001.vtp", ".." } do
    support.write(folder .. "/strange/frames.pvd", ('<DataSet timestep="1" group="" part="0" '
      .. 'file="%s"/>'):format(frame))
    for _, words in ipairs { "render strange" .. small, "report strange" } do
      ended(2, ("strange/frames.pvd lists the frame '%s', which is not inside strange"):format(frame), in_time(words))
    end
  end
  there "cd strange && rm -r frames && ln -s ../elsewhere/frames frames"
  support.write(folder .. "/strange/frames.pvd", read "one/frames.pvd")
  ended(2, "a link leads to " .. whole .. "/elsewhere/frames, outside strange", in_time("render strange" .. small))
  equal(select(2, there "ls elsewhere/frames"), elsewhere, "files outside the folder")
end)

-- Ctrl-C leaves no film, no folder and no Xvfb.
there "cp -r one long && rm long/film.*"
local lines = {}
for i = 1, 2000 do
  lines[i] = ('    <DataSet timestep="%d" group="" part="0" file="frames/frame_%05d.vtp"/>'):format(i, i % 6 + 1)
end
-- Waits until the third picture is there, or the program $p has ended. sleep is all that it starts: under ASan each
-- program takes long to start.
local third_frame = "until [ -e long/.hinge-render-$p/000003.png ] || ! kill -0 $p 2>/dev/null; do sleep 0.02; done"
case("Ctrl-C leaves no film, no folder and no Xvfb", function()
  support.write(folder .. "/long/frames.pvd", table.concat(lines, "\n"))
  os.remove(folder .. "/bin/Xvfb")
  support.write(folder .. "/bin/Xvfb", ("#!/bin/sh\necho $$ >>%s/servers\nexec %s \"$@\"\n"):format(quote(folder),
    support.output "command -v Xvfb":gsub("%s+$", "")))
  there "chmod +x bin/Xvfb"
  for signal, wanted in pairs { INT = 130, TERM = 143 } do
    os.remove(folder .. "/servers")
    local printed, complaint = ended(wanted, "", there(("{ env -u DISPLAY PATH=%s/bin:\"$PATH\" %s render long --gif%s "
      .. "& } && p=$! && %s; kill -%s $p; wait $p"):format(quote(folder), hinge, small, third_frame, signal)))
    equal(printed .. complaint, "hinge: interrupted; there is no film\n", "after SIG" .. signal)
    equal(left_over(), "", "left over after SIG" .. signal)
    expect(not read "long/film.gif", "a film is left after SIG%s", signal)
    local servers = 0
    for process in (read "servers" or ""):gmatch "%d+" do
      servers = servers + 1
      local gone = support.run(("for i in $(seq 100); do kill -0 %s 2>/dev/null || exit 0; "
        .. "grep -q 'State:.Z' /proc/%s/status 2>/dev/null && exit 0; sleep 0.05; done; exit 1"):format(process,
        process))
      equal(gone, 0, "an Xvfb is left after SIG" .. signal)
    end
    equal(servers, 1, "Xvfb that all processes share")
  end
end)

case("a process that is killed loses its frame alone", function()
  -- A process that is killed loses the frame that it was at; another one takes its place. pgrep does not end with the
  -- sanitizer in it.
  support.write(folder .. "/long/frames.pvd", table.concat(lines, "\n", 1, 100))
  local printed, complaint = ended(1, "", there(("{ %s render long --gif -j 1%s & } && p=$! && "
    .. "%s; kill -KILL $(LD_PRELOAD= pgrep -P $p -x hinge); wait $p"):format(hinge, small, third_frame)))
  expect(printed:find "^long/film%.gif: .* 99 pictures", "after a process was killed: %s", printed)
  local _, named = complaint:gsub("hinge: not drawn: [^\n]*: the process that worked on it ended by signal 9\n", "")
  equal(named, 1, "the frame that is named: " .. complaint)
  equal(#gif_of "long/film.gif".frames, 99, "pictures of the film")
  equal(left_over(), "", "left over after a process was killed")
end)

case("a full disk ends a film with a message", function()
  local tiny = folder .. "/tiny"
  support.run("mkdir " .. quote(tiny))
  local mounted = ("unshare -rm sh -c 'mount -t tmpfs -o size=16k tmpfs %s && cd %s && %%s'"):format(tiny, folder)
  if support.run(mounted:format "true") == 0 then
    local printed, complaint = ended(1, "", support.run(mounted:format(("%s render one --gif --out tiny/film.gif%s; "
      .. "s=$?; ls -A tiny; exit $s"):format(arg[1] .. "/hinge", small))))
    equal(printed, "", "on a full disk there is")
    expect(complaint:find "^hinge: cannot write tiny/film%.gif: No space left on device; [^\n]*\n$", "a full disk: %s",
      complaint)
  else
    print "render: a full disk is not tested: no file system can be mounted here"
  end
end)

checks.done()

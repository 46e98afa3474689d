-- A plot as commands and data for gnuplot: NAME.gp and NAME.dat.
local layout = require "hinge.plot.layout"
local read = require "hinge.plot.read"
local quote = require "hinge.library.quote"

local ink, faint_ink = 0x1f2328, 0x6e747c

local Writer = {}
Writer.__index = Writer

local function hex(colour) return ("rgb '#%06x'"):format(colour) end

-- The font of titles. In an SVG the reader's browser chooses it, and gnuplot 5 makes none bold there.
function Writer:bold(larger)
  return ("'%s,%.3g'"):format(self.kind == "svg" and "" or "DejaVu Sans:Bold", larger * self.size)
end

function Writer:out(format, ...) self.commands[#self.commands + 1] = format:format(...) end

-- The formats of pictures: what gnuplot calls them, how large they are, and the size of letters.
function Writer:terminal(plot)
  local kind, width, height, size = self.kind, plot.width, plot.height, self.size
  if kind == "png" then self:out("set terminal pngcairo size %d,%d font 'DejaVu Sans,%.3g'", width, height, size)
  elseif kind == "svg" then self:out("set terminal svg size %d,%d font 'sans-serif,%.3g'", width, height, size)
  else self:out("set terminal pdfcairo size %.4gin,%.4gin fontscale 1 font 'DejaVu Sans,%.3g'", width / 96, height / 96,
    size) end
end

function Writer:head(plot, stem, kind)
  local plain = quote.comment(stem)
  self:out("# Draws %s.%s from %s.dat:  gnuplot %s.gp", plain, kind, plain, plain)
  self:out("# For a paper, in place of the next two lines, for example:")
  self:out("#   set terminal pdfcairo size 9cm,6cm fontscale 1 font 'Times,8'; set output '%s.pdf'", plain)
  self:terminal(plot)
  self:out("set output %s", quote.gnuplot_file(stem .. "." .. kind))
  self:out "set encoding utf8"
  self:out "set minussign"
  self:out("data = %s", quote.gnuplot_file(stem .. ".dat"))
end

-- What all panels have in common.
function Writer:style()
  self:out("set border 3 lc %s", hex(ink))
  self:out("set tics nomirror out scale 0.7 textcolor %s", hex(ink))
  self:out("set grid back lt 1 lw 1 lc rgb '#e2e5e9'")
  self:out "set style fill solid noborder"
  self:out "set clip two"
end

-- Frames of a column have one left and right edge, those of a row one foot and head.
function Writer:margins(plot, panels)
  local em, left, right, top, bottom = self.em, {}, {}, {}, {}
  for i, panel in ipairs(panels) do
    local c, r = (i - 1) % plot.columns + 1, (i - 1) // plot.columns + 1
    local numbers = 0.62 * layout.letters(panel.y_ends, panel.log_y) * em
    if panel.lies then
      for _, name in ipairs(panel.categories_y) do numbers = math.max(numbers, layout.width_of(name, em)) end
      numbers = math.min(numbers, 0.45 * plot.width / plot.columns)
    end
    left[c] = math.max(left[c] or 0, numbers + (panel.y_label ~= "" and 3.4 or 1.8) * em)
    right[c] = math.max(right[c] or 0, 1.6 * em)
    top[r] = math.max(top[r] or 0, (panel.title ~= "" and 2.4 or 1) * em)
    panel.named_below = not plot.share_x or i + plot.columns > #panels
    bottom[r] = math.max(bottom[r] or 0, (not panel.named_below and 1 or panel.x_label ~= "" and 4 or 2.4) * em)
  end
  local head = plot.title ~= "" and 2.2 * em or 0
  local around = head
  for r = 1, plot.rows do around = around + top[r] + bottom[r] end
  local high, cell, y = math.max(em, (plot.height - around) / plot.rows), plot.width / plot.columns, plot.height - head
  for r = 1, plot.rows do
    for c = 1, plot.columns do
      local panel = panels[(r - 1) * plot.columns + c]
      if panel then
        panel.frame = { left = cell * (c - 1) + left[c], right = cell * c - right[c], top = y - top[r],
          bottom = y - top[r] - high }
        panel.ground = layout.ground(panel, panel.frame.right - panel.frame.left, high, em)
      end
    end
    y = y - top[r] - high - bottom[r]
  end
end

function Writer:frame(plot, panel)
  local f = panel.frame
  self:out("set lmargin at screen %.4f; set rmargin at screen %.4f", f.left / plot.width, f.right / plot.width)
  self:out("set bmargin at screen %.4f; set tmargin at screen %.4f", f.bottom / plot.height, f.top / plot.height)
end

-- The marks 1, 2, 5 of a logarithmic axis that is shorter than two decades, and marks without a number between. All
-- have a number where the axis is so short that it could have one of 1, 2, 5 alone.
local function log_marks(range)
  local list, all = {}, range[2] / range[1] < 5
  for power = math.floor(math.log(range[1], 10)), math.ceil(math.log(range[2], 10)) do
    for digit = 1, 9 do
      local v = digit * 10.0 ^ power
      if v >= range[1] and v <= range[2] then
        list[#list + 1] = ((all or digit == 1 or digit == 2 or digit == 5) and "%.6g" or "'' %.6g 1"):format(v)
      end
    end
  end
  return table.concat(list, ", ")
end

function Writer:axis(panel, axis, ends)
  local log, names = panel["log_" .. axis], panel["categories_" .. axis]
  self:out("set %srange [%.9g:%.9g]", axis, ends[1], ends[2])
  if log then self:out("set logscale %s", axis) end
  if names then
    local list, longest = {}, 0
    for i, name in ipairs(names) do
      list[i] = ("%s %d"):format(quote.gnuplot_label(name), i)
      longest = math.max(longest, layout.width_of(name, self.em))
    end
    local turned = axis == "x" and longest > panel.ground.width / #names - 0.5 * self.em
    self:out("set %stics (%s) noenhanced%s", axis, table.concat(list, ", "), turned and " rotate by 90 right" or "")
    self:out("set grid no%stics", axis)
  elseif log and ends[2] / ends[1] < 100 then
    self:out("set %stics (%s); set format %s '%%h'", axis, log_marks(ends), axis)
  elseif log then
    self:out("set format %s '%s'; set m%stics 10", axis, layout.plain_powers(ends) and "%h" or "10^{%L}", axis)
  else
    self:out("set format %s '%%h'", axis)
    local step = axis == "x" and layout.step_of(ends, panel.ground.width, self.em)
    if step then self:out("set xtics %.9g", step) end
  end
  if axis == "x" and not panel.named_below then self:out "set format x ''" end
end

function Writer:words(panel)
  self:out("set title %s font %s noenhanced offset 0,-0.3", quote.gnuplot(panel.title), self:bold(1.15))
  self:out("set xlabel %s noenhanced", quote.gnuplot(panel.named_below and panel.x_label or ""))
  self:out("set ylabel %s noenhanced", quote.gnuplot(panel.y_label))
end

-- A level or upright line; its name stands at the end where it hides less.
function Writer:reference_line(panel, line)
  local colour = hex(line.colour or faint_ink)
  local ground, em, size = panel.ground, self.em, 0.85 * self.em
  local x, y = ground:pixel(line.at, line.at)
  local at = line.upright and x or y
  if at < 0 or at > (line.upright and ground.width or ground.height) then return end
  local ends = line.upright and "%.9g,graph 0 to %.9g,graph 1" or "graph 0,first %.9g to graph 1,first %.9g"
  self:out("set arrow from " .. ends .. " nohead lw %.3g%s lc %s back", line.at, line.at, math.max(1, em / 14),
    line.dashed and " dt (20,12)" or "", colour)
  local function take() -- legends and labels keep away from it
    if line.upright then ground:line(at, 0, at, ground.height) else ground:line(0, at, ground.width, at) end
  end
  if line.name == "" then return take() end
  local long, box = layout.width_of(line.name, size) + 0.4 * em, {}
  for i, far in ipairs { true, false } do
    if line.upright then
      box[i] = { at - (at < 1.5 * em and 0 or 1.1 * size), far and ground.height - long or 0.4 * em, 1.1 * size, long }
    else box[i] = { far and ground.width - long or 0.4 * em, at, long, 1.1 * size } end
  end
  local far = ground:hidden(table.unpack(box[1])) <= ground:hidden(table.unpack(box[2]))
  ground:box(table.unpack(box[far and 1 or 2]))
  take()
  local place = line.upright and ("%.9g,graph %s rotate by 90"):format(line.at, far and "0.98" or "0.02")
    or ("graph %s,first %.9g"):format(far and "0.99" or "0.01", line.at)
  local offset = line.upright and (at < 1.5 * em and "0.8,0" or "-0.8,0") or "0,0.5"
  self:out("set label %s at %s %s offset %s font ',%.3g' textcolor %s noenhanced", quote.gnuplot(line.name), place,
    far and "right" or "left", offset, 0.85 * self.size, colour)
end

local function number(v) return v and ("%.9g"):format(v) or "NaN" end

-- Rows of a series in the data file; an empty line is a gap. Returns where it stands.
function Writer:rows(panel, s, kept)
  local data = self.data
  self.index = self.index + 1
  data[#data + 1] = ("# index %d: %s"):format(self.index, quote.comment(s.name))
  for k = 1, kept and #kept or #s.x do
    local i = kept and kept[k] or k
    if layout.shown(panel, s, i) then
      data[#data + 1] = number(s.x[i]) .. " " .. number(s.y[i]) .. (s.high and " " .. number(s.high[i]) or "")
        .. (s.bar_low and (" %s %s"):format(number(s.bar_low[i]), number(s.bar_high[i])) or "")
    elseif data[#data] ~= "" then data[#data + 1] = "" end
  end
  data[#data + 1] = "\n"
  return ("data index %d"):format(self.index)
end

-- Values of a line that have no neighbour, which no line shows.
local function lone(panel, s)
  local list = {}
  for i = 1, s.style == "line" and #s.x or 0 do
    if layout.shown(panel, s, i) and not (i > 1 and layout.shown(panel, s, i - 1))
      and not (i < #s.x and layout.shown(panel, s, i + 1)) then list[#list + 1] = i end
  end
  return #list > 0 and list or nil
end

function Writer:bar_label(panel, s, i, off)
  local value, text = panel.lies and s.x[i] or s.y[i], s.labels[i]
  if not text or text == "" or not layout.shown(panel, s, i) then return end
  local back = value < 0
  local place = panel.lies
    and ("%.9g,%.9g %s offset %s,0"):format(s.x[i], s.y[i] + off, back and "right" or "left", back and -0.7 or 0.7)
    or ("%.9g,%.9g center offset 0,%s"):format(s.x[i] + off, s.y[i], back and -0.7 or 0.6)
  self:out("set label %s at %s font ',%.3g' noenhanced", quote.gnuplot(text), place, 0.8 * self.size)
end

-- Bars of the series that is number `at` among those with bars.
function Writer:bars(panel, s, at)
  local width = layout.bars_share * panel.spacing / panel.bars
  local off = width * (at - panel.bars / 2 - 0.5)
  for i = 1, #s.labels do self:bar_label(panel, s, i, off) end
  if panel.lies then
    local foot = panel.log_x and panel.x_ends[1] or 0
    return ("using (%.9g):2:(%.9g):1:($2%+.9g):($2%+.9g) with boxxyerror"):format(foot, foot, off - 0.47 * width,
      off + 0.47 * width)
  end
  return ("using ($1%+.9g):2:(%.9g) with boxes"):format(off, 0.94 * width)
end

-- Marks of gnuplot, with sizes that look alike; larger than plain points, since a reader tells series by them.
local plain, marks = { 7, 1 }, { { 7, 1.35 }, { 5, 1.25 }, { 9, 1.75 }, { 13, 1.75 }, { 6, 1.35 }, { 4, 1.25 },
  { 8, 1.75 }, { 12, 1.75 } }

local function colour_of(s)
  local colour = s.colour or read.colours[(s.place - 1) % #read.colours + 1]
  if not s.faint then return colour end
  local mixed = 0
  for shift = 16, 0, -8 do mixed = mixed * 256 + math.floor(0.42 * (colour >> shift & 255) + 0.58 * 255 + 0.5) end
  return mixed
end

-- One part of the plot command: how a series is drawn.
function Writer:part(panel, s, bar)
  local colour, thick = hex(colour_of(s)), math.max(1.5, self.em / 9)
  local data = self:rows(panel, s, layout.thin(panel, s, 2 * math.ceil(panel.ground.width)))
  local title = s.name ~= "" and "title " .. quote.gnuplot(s.name) or "notitle"
  -- after the eight colours of the series come dashes
  local dashed = s.dashed ~= (not s.colour and (s.place - 1) // #read.colours % 2 == 1)
  local line = ("lw %.3g%s lc %s"):format(thick, dashed and " dt (24,14)" or "", colour)
  local mark = s.mark and marks[s.mark] or plain
  local dots = ("pt %d ps %.3g"):format(mark[1], mark[2] * self.em / (s.style == "points" and 18 or 20))
  if s.style == "bars" then return ("%s %s lc %s %s"):format(data, self:bars(panel, s, bar), colour, title) end
  if s.style == "band" then
    local foot = panel.log_y and ("1:($2 > 0 ? $2 : %.9g):3"):format(panel.y_ends[1]) or "1:2:3"
    return ("%s using %s with filledcurves fs transparent solid 0.28 lc %s %s"):format(data, foot, colour, title)
  end
  if s.bar_low then -- a foot that is not above 0 ends at the axis
    data = ("%s using 1:2:%s:4 with yerrorbars pt -1 ps 0 lw %.3g lc %s notitle, \\\n     %s using 1:2"):format(data,
      panel.log_y and ("($3 > 0 ? $3 : %.9g)"):format(panel.y_ends[1]) or "3", 0.7 * thick, colour, data)
  end
  if #s.x == 1 and not layout.shown(panel, s, 1) then data = "NaN" end -- a line of the legend alone
  if s.style == "points" then return ("%s with points %s lc %s %s"):format(data, dots, colour, title) end
  if s.style == "line and points" then return ("%s with linespoints %s %s %s"):format(data, dots, line, title) end
  local alone = lone(panel, s)
  local also = alone and (", \\\n     %s with points %s lc %s notitle"):format(self:rows(panel, s, alone), dots, colour)
  return ("%s with lines %s %s%s"):format(data, line, title, also or "")
end

function Writer:legend(panel)
  local em, longest, n = self.em, 0, 0
  for _, s in ipairs(panel.series) do
    if s.name ~= "" and #s.x > 0 then longest, n = math.max(longest, layout.width_of(s.name, em)), n + 1 end
  end
  if n == 0 then return self:out "unset key" end
  local look = ("noenhanced Left reverse samplen 2.5 spacing 1.25 width 1 textcolor %s"):format(hex(ink))
  local place = panel.ground:legend(longest + 5 * em, (1.5 * n + 0.6) * em)
  if place then return self:out("set key %s opaque box lc rgb '#ffffff' %s", place, look) end
  -- Nowhere inside: beside the frame, which becomes narrower.
  panel.frame.right = math.max(panel.frame.left + em, panel.frame.right - longest - 4.5 * em)
  self:out("set key at graph 1.01,graph 1 left top vertical %s", look)
  return panel.frame
end

function Writer:point_labels(panel)
  for _, s in ipairs(panel.series) do
    for i, text in ipairs(s.style ~= "bars" and s.labels or {}) do
      if text ~= "" and layout.shown(panel, s, i) then
        local way, across, up = panel.ground:label(s.x[i], s.y[i], text, 0.8 * self.em, s.faint)
        if way then
          -- an offset is in widths of a letter and heights of a line
          self:out("set label %s at %.9g,%.9g %s offset %.3g,%.3g font ',%.3g' noenhanced", quote.gnuplot(text), s.x[i],
            s.y[i], way, across / 0.6, up / 1.16, 0.8 * self.size)
        end
      end
    end
  end
end

function Writer:panel(plot, panel)
  self:style()
  self:axis(panel, "x", panel.x_ends)
  self:axis(panel, "y", panel.y_ends)
  self:words(panel)
  for _, line in ipairs(panel.lines) do self:reference_line(panel, line) end
  self:legend(panel)
  self:frame(plot, panel)
  self:point_labels(panel)
  if panel.bars > 0 then
    if panel.lies then self:out("set arrow from 0,graph 0 to 0,graph 1 nohead lc %s", hex(ink))
    elseif not panel.log_y then self:out("set xzeroaxis lt 1 lc %s", hex(ink)) end
  end
  local parts, bar = {}, 0
  for _, areas in ipairs { true, false } do -- areas beneath, so that they hide no curve
    for _, s in ipairs(panel.series) do
      if (s.style == "bars" or s.style == "band") == areas then
        if s.style == "bars" then bar = bar + 1 end
        if #s.x > 0 then parts[#parts + 1] = self:part(panel, s, bar) end
      end
    end
  end
  if not panel.any then
    self:out("set label 'nothing to draw' at graph 0.5,0.5 center textcolor %s", hex(faint_ink))
    parts = { "NaN notitle" }
  end
  self:out("plot %s", table.concat(parts, ", \\\n     "))
end

--- The texts of NAME.gp and NAME.dat. plot: of read.plot; stem: NAME; kind: "png", "svg" or "pdf".
return function(plot, stem, kind)
  local em = math.max(7, math.min(60, plot.height / plot.rows / (plot.rows > 1 and 20 or 32),
    plot.width / plot.columns / 40))
  local w = setmetatable({ commands = {}, data = {}, index = -1, em = em, kind = kind,
    size = kind == "svg" and em or 0.75 * em }, Writer)
  for _, panel in ipairs(plot.panels) do layout.measure(panel) end
  layout.ranges(plot)
  w:margins(plot, plot.panels)
  w:head(plot, stem, kind)
  local several = #plot.panels > 1
  if several then
    w:out("set multiplot%s", plot.title ~= ""
      and (" title %s font %s noenhanced offset 0,0.3"):format(quote.gnuplot(plot.title), w:bold(1.2)) or "")
  end
  for i, panel in ipairs(plot.panels) do
    if several then
      w:out ""
      w:out("# panel %d", i)
      if i > 1 then w:out "reset" end
    end
    w:panel(plot, panel)
  end
  if several then w:out "unset multiplot" end
  return table.concat(w.commands, "\n") .. "\n", table.concat(w.data, "\n") .. "\n"
end

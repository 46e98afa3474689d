-- Draws a plot by the program gnuplot: NAME.gp and NAME.dat stand beside the picture.
local core = require "hinge.core"
local commands = require "hinge.plot.commands"
local layout = require "hinge.plot.layout"
local read = require "hinge.plot.read"

--- plot: as job:plot takes it; path: ends in .png, .svg or .pdf; where: who is named in messages.
return function(given, path, where)
  if type(path) ~= "string" then core.input_error(where .. " the picture's name is no text") end
  local plot = read.plot(where, given)
  local any, log = false, false
  for _, panel in ipairs(plot.panels) do
    layout.measure(panel)
    any, log = any or panel.any, log or panel.log_x or panel.log_y
  end
  local stem, kind = path:match "([^/]*)%.(%w+)$"
  local gp, data = "", ""
  if any then gp, data = commands(plot, stem, kind) end
  core.draw_plot(path, gp, data, not any and "nothing to draw; give at least one finite point"
    .. (log and ", positive on a logarithmic axis" or "") or nil)
end

-- The files of a plot: NAME.gp, NAME.dat and the picture that gnuplot draws of them.
local core = require "hinge.core"
local commands = require "hinge.plot.commands"
local layout = require "hinge.plot.layout"
local data = require "hinge.plot.data"

local files = {}

--- plot: of hinge.plot.read; path: ends in .png, .svg or .pdf.
function files.draw(plot, path)
  local any, log = false, false
  for _, panel in ipairs(plot.panels) do
    layout.measure(panel)
    any, log = any or panel.any, log or panel.log_x or panel.log_y
  end
  local stem, kind = path:match "([^/]*)%.(%w+)$"
  local gp, rows = "", ""
  if any then gp, rows = commands(plot, stem, kind) end
  core.draw_plot(path, gp, rows, not any and "nothing to draw; give at least one finite point"
    .. (log and ", positive on a logarithmic axis" or "") or nil)
end

--- The same of the bytes that another process sent.
function files.draw_packed(bytes, path) files.draw(data.unpack(bytes), path) end

return files

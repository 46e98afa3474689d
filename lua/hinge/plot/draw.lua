-- Draws a plot by the program gnuplot: NAME.gp and NAME.dat stand beside the picture. For a script in the sandbox
-- another process does it, which gets the plot as data.
local core = require "hinge.core"
local files = require "hinge.plot.files"
local data = require "hinge.plot.data"
local read = require "hinge.plot.read"

--- plot: as job:plot takes it; path: ends in .png, .svg or .pdf; where: who is named in messages.
return function(given, path, where)
  if type(path) ~= "string" then core.input_error(where .. " the picture's name is no text") end
  local plot = read.plot(where, given)
  if core.drawn_elsewhere() then core.draw_packed(path, data.pack(plot)) else files.draw(plot, path) end
end

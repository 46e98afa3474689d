-- The line on a terminal that says how far something is, renewed in its place.
local core = require "hinge.core"

local status_line = {}

--- A time in words: "12 s", "3 min", "1.5 h".
function status_line.time(seconds)
  if seconds < 100 then return ("%.0f s"):format(math.max(1, seconds)) end
  if seconds < 6000 then return ("%.0f min"):format(seconds / 60) end
  return ("%.1f h"):format(seconds / 3600)
end

--- { show(text), clear() }; nil where stderr is no terminal.
function status_line.new()
  local width = core.width()
  if not width then return nil end
  return {
    show = function(text) io.stderr:write("\r\27[K" .. text:sub(1, width - 1)) end,
    clear = function() io.stderr:write "\r\27[K" end,
  }
end

return status_line

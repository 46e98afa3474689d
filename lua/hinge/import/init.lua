-- hinge.import: frames of other programs. Readers give a description of the frame (import/frame.lua) and notes on what
-- they could not read; build makes a model of it, and write a script. Each is loaded when it is first called.
local check = require "hinge.library.check"

local import = {}
for name, file in pairs { s2k = "s2k", e2k = "e2k", tcl = "recorded", csv = "csv", build = "build",
  write = "write" } do
  import[name] = function(...) return require("hinge.import." .. file)(...) end
end

return check.strict(import, "hinge.import")

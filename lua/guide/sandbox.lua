-- A script from somebody else, which also tries what it should not: see sandbox.md.
local hinge = require "hinge"
local settings = ... or {}

local steel = hinge.material { E = 206e9, density = 7850 }
local pipe = hinge.section.pipe { diameter = 0.1, thickness = 0.005 }

-- A tripod of 4 m with 10 kN across its head.
local model = hinge.model { displacement = "small" }
local head = model:node { 0, 0, 4 }
for i = 0, 2 do
  local angle = 2 * math.pi * i / 3
  local foot = model:node { 1.5 * math.cos(angle), 1.5 * math.sin(angle), 0 }
  model:fix(foot, "xyz")
  model:member { foot, head, section = pipe, material = steel }
end
model:load { node = head, force = { 10e3, 0, 0 } }
local run = model:static { steps = 1 }:finish()
print(("the head moves by %.3f mm"):format(1000 * head:displacement(run)))
hinge.picture(run, { width = 1000, height = 600, title = "a tripod" }, "sandbox.png")

-- What the sandbox is for: sandbox.lua attempt=file and so on.
local attempts = {
  file = function() return io.open "/etc/passwd" end,
  process = function() return os.execute "ls" end,
  module = function() return require "socket" end,
  bytecode = function() return string.dump(print) end,
  forever = function() while true do end end,
  memory = function()
    local list = {}
    while true do list[#list + 1] = ("x"):rep(1e6) .. #list end
  end,
}
if settings.attempt then print(attempts[settings.attempt]()) end

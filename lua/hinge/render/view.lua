-- What a picture shows: the fields of a view and what they may be.
local view = {}

view.names = { "front", "back", "left", "right", "top", "iso", "perspective" }
view.shows = { "f_y", "group", "none", "N", "Qx", "Qy", "Mx", "My", "Mz" }

view.rules = {
  width = { "number", unit = "pixels", whole = true, at_least = 64, at_most = 8192, optional = true },
  height = { "number", unit = "pixels", whole = true, at_least = 64, at_most = 8192, optional = true },
  view = { "string", one_of = view.names, optional = true },
  from = { "numbers", count = 3, optional = true },
  up = { "numbers", count = 3, optional = true },
  scale = { "number", above = 0, also = { "auto" }, optional = true },
  show = { "string", one_of = view.shows, optional = true },
  largest = { "number", unit = "N or N m", above = 0, optional = true },
  ghost = { "boolean", optional = true },
  supports = { "boolean", optional = true },
  ground = { "boolean", optional = true },
  floors = { "boolean", optional = true },
  hinges = { "hinges", optional = true, words = "true, false or a list of run:hinges that was given a limit",
    good = function(v) return type(v) == "boolean" or require "hinge.results.hinges".can_be_drawn(v) end },
  loads = { "boolean", optional = true },
  labels = { "boolean", also = { "nodes", "members" }, optional = true },
  leave_out_broken = { "boolean", optional = true },
  above = { "number", unit = "m", optional = true },
  groups = { "table", optional = true },
  plane = { "table", optional = true },
  title = { "string", optional = true },
  box = { "numbers", count = 6, unit = "m", optional = true },
}

return view

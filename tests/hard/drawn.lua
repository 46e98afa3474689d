-- Scenes drawn by seed (random_scenes.lua) that have failed or made energy, one for each cause. Each runs with the
-- options and the time step that were drawn with it. `changed`: options in the place of some of them.
local scenes = require "random_scenes"

local function drawn(seed, name, more)
  local scene = { ("seed %d: %s"):format(seed, name), energy_error = 1e-2, dt = 1, steps = 1, drawn = true,
    make = function(hinge) return scenes.scene(seed).make(hinge, more and more.changed) end }
  for field, value in pairs(more or {}) do scene[field] = value end
  return scene
end

return {
  -- the return of a pair to its yield surface, where its law is not convex
  drawn(44, "struck strut yields far beyond Euler's load"),
  drawn(392, "pressed column between clamped ends yields"),
  drawn(58, "falling frame lands on its columns and yields"),
  -- one of the two elements of a pair breaks, and the law of the other is another one then
  drawn(325, "strut under high compression breaks", { slow = true }),
  -- damping by elastic rates that drives hinges whose flow turns from step to step
  drawn(1138, "frame with a large beta is struck at 210 m/s"),
  -- ends that turn fast against their element, with rotary inertia
  drawn(46, "elastic columns fold", { slow = true }),
  drawn(459, "bodies bounce and spin", { slow = true }),
  -- an end that breaks off while it presses on the ground
  drawn(137, "frame breaks as it lands"),
  -- steps too long for contact and for landing, for hinges under shaking
  drawn(250, "bars fall into a bin, steps of 0.2 ms"),
  drawn(648, "frame is struck, steps of 1 ms"),
  drawn(229, "frame falls on the ground, steps of 1 ms"),
  drawn(298, "shaken frame yields, steps of 0.5 ms"),
  -- an error of 1.3 % on the way and 0.5 % at the end: the run warns of it
  drawn(7377, "frame is struck, large error on the way, steps of 0.1 ms",
    { slow = true, energy_error = 2e-2, warns = "the energy error at t = " }),
  -- struts that are pressed to many times their buckling load, by explicit steps
  drawn(1266, "frame is struck at 255 m/s, explicit steps",
    { says = "the energy balance no longer closes", changed = { interaction = "paper" } }),
  -- explicit steps: errors of 3.9 % for a few steps, between two looks of the guard; the run warns of it
  drawn(9219, "bar falls flat at 35 m/s, explicit steps", { energy_error = 5e-2, warns = "the energy error at t = " }),
  -- explicit steps with contact, the longest that dt = "auto" takes
  drawn(219, "frame is struck, explicit steps"),
  -- hinges that turn an end by more than half a turn
  drawn(85, "column is struck at 293 m/s and folds"),
  drawn(1963, "slender frame is struck at 227 m/s and folds"),
  -- steps of which Newton's method has not converged, and losses that seem to go with time
  drawn(836, "shaken frame at its yield point, steps of 1 ms"),
  drawn(342, "slender frame yields under shaking, steps of 0.5 ms", { slow = true }),
  -- a pair of a section alike in both planes, pressed far beyond Euler's load: which way it flows is worth no energy
  drawn(1883, "tower falls, its braces yield under compression", { slow = true }),
  -- friction of a long step in contact, and damping of one, made energy
  drawn(1879, "truss loses a member, its bars touch with friction"),
  drawn(2379, "truss is struck end on, damped, steps of 1 ms"),
  -- impulses of a step: what damping does after them, and where they lead bars that nobody foresaw
  drawn(666, "bars fall into a bin, with damping by stiffness"),
  drawn(439, "bars fall into a bin, and are led into each other"),
  -- an element that is pressed flat has no length that steps could be short against
  drawn(23, "hit frame of eight elements a member", { says = "is pressed to", make = function(hinge)
    return scenes.scene(23, "hit frame").make(hinge, { elements_per_member = 8 })
  end }),
}

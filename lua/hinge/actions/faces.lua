-- What loads in a direction, and on faces beside members, have in common.
local check = require "hinge.library.check"
local vectors = require "hinge.library.vectors"

local faces = {}

local least_angle = 84 -- degrees, between the normal of a face and the axis of its member
local length = { "number", unit = "m", above = 0 }

--- The rule of a field that may have any value, which is looked at later.
faces.any = { "any", optional = true, good = function() return true end }

--- The direction of a field as a vector of length 1. what: "a direction", unless it is another one.
function faces.direction(where, field, given, what)
  check.value(where, field, given, { "numbers", count = 3 })
  local unit, size = vectors.unit(given)
  if size == 0 then
    check.fail("%s: field '%s' is {0, 0, 0}; must be %s, of any length above 0", where, field, what or "a direction")
  end
  return unit
end

--- Refuses a face that is not beside its member; normal: of length 1, from `field`.
function faces.refuse_along(where, field, member, normal)
  local axis = vectors.minus(vectors.of_node(member.b), vectors.of_node(member.a))
  local cosine = math.abs(vectors.dot(axis, normal)) / vectors.length(axis)
  local angle = math.deg(math.acos(math.min(1, cosine)))
  if angle < least_angle then
    check.fail("%s: field '%s' is %.3g degrees from the axis of member %d; must be %g to 90 degrees from it", where,
      field, angle, member.index, least_angle)
  end
end

--- The width that a member carries, m: the field `width`, or what it returns of the member.
function faces.width(where, given, member)
  if type(given) ~= "function" then return check.value(where, "width", given, length) end
  return check.value(where, ("width(member %d)"):format(member.index), given(member), length)
end

return faces

-- Vectors of space as lists of three numbers.
local vectors = {}

function vectors.dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end

function vectors.cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end

function vectors.minus(a, b) return { a[1] - b[1], a[2] - b[2], a[3] - b[3] } end

function vectors.times(factor, a) return { factor * a[1], factor * a[2], factor * a[3] } end

--- a + factor b.
function vectors.plus(a, factor, b) return { a[1] + factor * b[1], a[2] + factor * b[2], a[3] + factor * b[3] } end

--- The place at the part t of the way from a to b.
function vectors.between(a, b, t)
  return { a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]), a[3] + t * (b[3] - a[3]) }
end

--- The place of a node where the model has it.
function vectors.of_node(node) return { node.x, node.y, node.z } end

--- The area of a polygon in space, from its corners.
function vectors.area(corners)
  local sum, o = { 0, 0, 0 }, corners[1]
  for i = 2, #corners - 1 do
    local a, b = vectors.minus(corners[i], o), vectors.minus(corners[i + 1], o)
    sum = vectors.plus(sum, 1, vectors.cross(a, b))
  end
  return vectors.length(sum) / 2
end

function vectors.length(a) return math.sqrt(vectors.dot(a, a)) end

--- The vector of length 1 in the same direction, and the length.
function vectors.unit(a)
  local length = vectors.length(a)
  return { a[1] / length, a[2] / length, a[3] / length }, length
end

return vectors

-- Motions of the ground that tests write and read.
local motions = {}

--- Values of a function of time every dt.
function motions.sampled(f, dt, n)
  local list = {}
  for i = 1, n do list[i] = f((i - 1) * dt) end
  return list
end

--- A Ricker pulse about `middle` with 1 / `width` Hz at its peak: it leaves no velocity behind.
function motions.ricker(width, middle)
  return function(t)
    local x = (math.pi * (t - middle) / width) ^ 2
    return (1 - 2 * x) * math.exp(-x)
  end
end

return motions

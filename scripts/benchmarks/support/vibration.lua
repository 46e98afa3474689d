-- The frequency of a vibration that a probe has recorded: for benchmarks of dynamics.
local vibration = {}

--- Angular frequency (rad/s) of the largest harmonic part of a signal near `guess`, whose values are dt (s) apart. The
--- window of Blackman and Harris keeps other frequencies out. The maximum of the transform is found by the golden
--- section, within 7 % of the guess.
function vibration.frequency(probe, dt, guess)
  local u, n, cut = probe.value, #probe.value, {}
  for i = 1, n do
    local x = 2 * math.pi * (i - 1) / (n - 1)
    cut[i] = u[i] * (0.35875 - 0.48829 * math.cos(x) + 0.14128 * math.cos(2 * x) - 0.01168 * math.cos(3 * x))
  end
  local function size(w)
    local re, im = 0, 0
    for i = 1, n do
      local a = w * dt * (i - 1)
      re, im = re + cut[i] * math.cos(a), im + cut[i] * math.sin(a)
    end
    return re * re + im * im
  end
  local ratio = (math.sqrt(5) - 1) / 2
  local low, high = 0.93 * guess, 1.07 * guess
  for _ = 1, 32 do
    local a, b = high - ratio * (high - low), low + ratio * (high - low)
    if size(a) > size(b) then high = b else low = a end
  end
  return (low + high) / 2
end

return vibration

-- Reads a GIF: what render_test.lua looks at.
local gif = {}

-- The indices of a picture of so many pixels, from LZW codes.
local function indices(data, least, pixels)
  local clear, stop = 1 << least, (1 << least) + 1
  local size, at, bits, have = least + 1, 1, 0, 0
  local words, next_code, before = {}, 0, nil
  local out = {}
  local function restart()
    words, size, before = {}, least + 1, nil
    for i = 0, clear - 1 do words[i] = string.char(i) end
    next_code = stop + 1
  end
  restart()
  while true do
    while have < size do
      bits = bits | (data:byte(at) or error "the GIF's data end early") << have
      at, have = at + 1, have + 8
    end
    local code = bits & (1 << size) - 1
    bits, have = bits >> size, have - size
    if code == stop then break end
    if code == clear then
      restart()
    else
      local word = words[code] or before and code == next_code and before .. before:sub(1, 1) or error "a wrong code"
      out[#out + 1] = word
      if before and next_code < 4096 then
        words[next_code] = before .. word:sub(1, 1)
        next_code = next_code + 1
      end
      if next_code == 1 << size and size < 12 then size = size + 1 end
      before = word
    end
  end
  local all = table.concat(out)
  assert(#all == pixels, ("%d pixels of %d"):format(#all, pixels))
  return all
end

--- { width =, height =, loops = (0: for ever), frames = { { left =, top =, width =, height =, delay = (1/100 s),
--- pixel = function(x, y) -> { r, g, b }, as it is seen then }, ... } }. Raises an error where it is no GIF.
function gif.read(bytes)
  assert(bytes:sub(1, 6) == "GIF89a", "no GIF")
  local width, height, flags, at = string.unpack("<I2I2Bxx", bytes, 7)
  local movie = { width = width, height = height, frames = {} }
  local palette = {}
  for i = 0, (2 << (flags & 7)) - 1 do
    local r, g, b
    r, g, b, at = string.unpack("BBB", bytes, at)
    palette[i] = { r, g, b }
  end
  local function blocks()
    local parts = {}
    repeat
      local part
      part, at = string.unpack("s1", bytes, at)
      parts[#parts + 1] = part
    until part == ""
    return table.concat(parts)
  end
  local canvas, delay, transparent = {}, 0, nil
  while true do
    local kind = bytes:byte(at)
    at = at + 1
    if kind == 0x3b then return movie end
    if kind == 0x21 then
      local label = bytes:byte(at)
      at = at + 1
      local content = blocks()
      if label == 0xf9 then
        local how, through
        how, delay, through = string.unpack("<BI2B", content)
        transparent = how & 1 == 1 and through or nil
      elseif content:sub(1, 11) == "NETSCAPE2.0" then
        movie.loops = string.unpack("<I2", content, 13)
      end
    elseif kind == 0x2c then
      local frame = { delay = delay }
      local local_flags, least
      frame.left, frame.top, frame.width, frame.height, local_flags, least, at = string.unpack("<I2I2I2I2BB", bytes, at)
      assert(local_flags == 0, "a palette of its own, or rows out of order")
      local new = indices(blocks(), least, frame.width * frame.height)
      local own = table.move(canvas, 1, width * height, 1, {})
      for i = 0, #new - 1 do
        local index = new:byte(i + 1)
        if index ~= transparent then
          own[(frame.top + i // frame.width) * width + frame.left + i % frame.width + 1] = palette[index]
        end
      end
      canvas = own
      function frame.pixel(x, y) return own[y * width + x + 1] end
      movie.frames[#movie.frames + 1] = frame
    else
      error(("a block of kind %s"):format(kind))
    end
  end
end

return gif

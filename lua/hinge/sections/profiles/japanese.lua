-- Japanese H shapes (JIS G 3192).
--
-- A row: name, dimensions in mm, and behind the bar area, Ix, Iy and Zx in cm^2, cm^4 and cm^3. Catalogues give areas
-- and moments that agree with these to 0.5 %; the root radii are from memory and were not confirmed.
return {
  {
    family = "H", prefix = "H ", shape = "h", unit = "mm",
    columns = "depth width web flange r", published = "area Ix Iy Zx",
    rows = [[
100x100x6x8: 100 100 6 8 8 | 21.59 377.9 133.6 86.39
200x200x8x12: 200 200 8 12 13 | 63.53 4716 1602 525.5
250x250x9x14: 250 250 9 14 13 | 91.43 10750 3648 952.6
300x150x6.5x9: 300 150 6.5 9 13 | 46.78 7209 507.5 542.1
300x300x10x15: 300 300 10 15 13 | 118.5 20190 6753 1484
350x175x7x11: 350 175 7 11 13 | 62.91 13500 984.2 864.2
350x350x12x19: 350 350 12 19 13 | 171.9 39850 13580 2515
400x200x8x13: 400 200 8 13 13 | 83.37 23460 1736 1313
400x400x13x21: 400 400 13 21 22 | 218.7 66620 22410 3672
488x300x11x18: 488 300 11 18 13 | 159.2 68860 8106 3132
500x200x10x16: 500 200 10 16 13 | 112.3 46810 2138 2130
600x200x11x17: 600 200 11 17 13 | 131.7 75560 2274 2904
700x300x13x24: 700 300 13 24 18 | 231.5 197500 10820 6338
900x300x16x28: 900 300 16 28 18 | 305.8 404500 12630 10290
]],
  },
}

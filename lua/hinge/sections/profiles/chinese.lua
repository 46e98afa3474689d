-- Chinese H shapes HW, HM and HN by nominal depth and width (GB/T 11263), with the plates that the name stands for.
--
-- A row: name, dimensions in mm, and behind the bar the area as tables have it, in cm^2.
return {
  {
    family = "HW", prefix = "HW ", shape = "h", unit = "mm",
    columns = "depth width web flange r", published = "area",
    rows = [[
100x100: 100 100 6 8 8 | 21.58
125x125: 125 125 6.5 9 8 | 30
150x150: 150 150 7 10 8 | 39.64
175x175: 175 175 7.5 11 13 | 51.42
200x200: 200 200 8 12 13 | 63.53
250x250: 250 250 9 14 13 | 91.43
300x300: 300 300 10 15 13 | 118.5
350x350: 350 350 12 19 13 | 171.9
400x400: 400 400 13 21 22 | 218.7
]],
  },
  {
    family = "HM", prefix = "HM ", shape = "h", unit = "mm",
    columns = "depth width web flange r", published = "area",
    rows = [[
150x100: 148 100 6 9 8 | 26.34
200x150: 194 150 6 9 8 | 38.1
250x175: 244 175 7 11 13 | 55.49
300x200: 294 200 8 12 13 | 71.05
350x250: 340 250 9 14 13 | 99.53
400x300: 390 300 10 16 13 | 133.3
450x300: 440 300 11 18 13 | 153.9
500x300: 488 300 11 18 13 | 159.2
600x300: 588 300 12 20 13 | 187.2
]],
  },
  {
    family = "HN", prefix = "HN ", shape = "h", unit = "mm",
    columns = "depth width web flange r", published = "area",
    rows = [[
100x50: 100 50 5 7 8 | 11.84
125x60: 125 60 6 8 8 | 16.68
150x75: 150 75 5 7 8 | 17.84
175x90: 175 90 5 8 8 | 22.89
200x100: 200 100 5.5 8 8 | 26.66
250x125: 250 125 6 9 8 | 36.96
300x150: 300 150 6.5 9 13 | 46.78
350x175: 350 175 7 11 13 | 62.91
400x200: 400 200 8 13 13 | 83.37
450x200: 450 200 9 14 13 | 95.43
500x200: 500 200 10 16 13 | 112.2
600x200: 600 200 11 17 13 | 131.7
700x300: 700 300 13 24 18 | 231.5
800x300: 800 300 14 26 18 | 263.5
900x300: 900 300 16 28 18 | 305.8
]],
  },
}

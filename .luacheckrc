-- Lua code is checked by `ctest -R format`; by hand: `luacheck lua scripts tests` at the top level.
std = "lua54" -- no globals of ours: the library gives scripts none
max_line_length = 120

-- not (a <= b) is not a > b where a number may be NaN: tests and limits are written so that NaN fails them.
ignore = { "581" }

-- Definitions for editors have no bodies, so no argument is used; their variables only carry the methods of a class.
files["lua/hinge/**/*.d.lua"] = { ignore = { "212", "241", "431" } }

-- These silence what a script prints while it runs only to be planned or timed.
files["lua/hinge/program/runner.lua"] = { globals = { "print" } }
files["lua/hinge/cost/measure.lua"] = { globals = { "print" } }

-- This notes what a script opens.
files["lua/hinge/study/files.lua"] = { globals = { "io" } }

-- This catches what a test that fails prints, and keeps it from ending the program.
files["tests/script/tree/support_test.lua"] = { globals = { "print", "io", "os" } }

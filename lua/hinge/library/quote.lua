-- Texts of others inside languages that hinge writes: one function for each language, and no other way. C++ has the
-- functions of CSV and shells (src/core/quoting.h), of XML and JSON. tests/README.md lists the places.
local check = require "hinge.library.check"
local core = require "hinge.core"

local quote = {}

-- Characters that turn the direction of what stands beside them: code would look other than it is.
local turning = {}
for _, code in ipairs { 0x061C, 0x200E, 0x200F, 0x202A, 0x202B, 0x202C, 0x202D, 0x202E, 0x2066, 0x2067, 0x2068,
  0x2069 } do
  turning[utf8.char(code)] = true
end

-- Each character that turns directions as f(character).
local function each_turning(text, f)
  return (text:gsub("[\xD8\xE2][\x80-\xBF][\x80-\xBF]?", function(bytes)
    if turning[bytes] then return f(bytes) end
    if turning[bytes:sub(1, 2)] then return f(bytes:sub(1, 2)) .. bytes:sub(3) end
  end))
end

--- A text as a literal of Lua, on one line.
function quote.lua(text)
  local literal = ("%q"):format(text):gsub("\\\n", "\\n")
  return each_turning(literal, function(mark) return ("\\u{%04X}"):format(utf8.codepoint(mark)) end)
end

--- A text in a comment up to the end of a line, of any language: none of them goes on after it.
function quote.comment(text)
  return each_turning(text:gsub("%c", " "), function() return "?" end):gsub("\\", "/") .. ""
end

--- A text of gnuplot, in which it expands nothing. Single quotes are doubled inside single quotes, but gnuplot 5.4
--- reads no two of them on end, nor one at the beginning. So a text that has one stands in double quotes, where nothing
--- but these four characters has a meaning.
function quote.gnuplot(text)
  text = tostring(text):gsub("%c", " ")
  if not utf8.len(text) then text = text:gsub("[\x80-\xff]", "?") end
  if not text:find("'", 1, true) then return "'" .. text .. "'" end
  return '"' .. text:gsub("[\"\\`@]", { ['"'] = '\\"', ["\\"] = "\\\\", ["`"] = "\\140", ["@"] = "\\100" }) .. '"'
end

--- The same of a label at an axis, which gnuplot reads as a format of numbers.
function quote.gnuplot_label(text) return quote.gnuplot((tostring(text):gsub("%%", "%%%%"))) end

--- The name of a file for gnuplot, which starts a program for a name that begins with < or |.
function quote.gnuplot_file(name) return quote.gnuplot(name:find "^[%w_]" and name or "./" .. name) end

--- JSON inside <script> of a page: no text in it ends the element or begins a comment. Texts of others stand in HTML in
--- no other way; the page sets them as texts.
function quote.json_in_html(json)
  return (json:gsub("<", "\\u003c"):gsub("\u{2028}", "\\u2028"):gsub("\u{2029}", "\\u2029"))
end

--- A text as a field of a CSV file, in quotes; plain: without them where none are needed.
function quote.csv(text, plain) return core.csv_text(text, plain) end

--- A text as one word of a shell.
function quote.shell(text) return core.shell_text(text) end

--- A value of an option of sbatch, which reads its options from lines of the script: there is no way to write a line
--- break, so that one is refused. A backslash keeps any other character as it is, inside quotes or not.
function quote.sbatch(option, text)
  if text:find "%c" then
    check.fail("%s %q: must not hold a line break or another control character with --slurm, as sbatch takes its "
      .. "options from lines of the script; choose another name", option, text)
  end
  return (text:gsub("[^%w_./:=,+%%@-]", "\\%0"))
end

--- A text as a cell of a table in Markdown: no cell, line, picture, link or element of HTML begins in it.
function quote.markdown(text)
  return (text:gsub("%c", " "):gsub("[\\|<`%[%]]", { ["\\"] = "\\\\", ["|"] = "\\|", ["<"] = "&lt;", ["`"] = "\\`",
    ["["] = "\\[", ["]"] = "\\]" }))
end

local special = { ["\\"] = "\\textbackslash{}", ["~"] = "\\textasciitilde{}", ["^"] = "\\textasciicircum{}" }
for c in ("&%$#_{}"):gmatch "." do special[c] = "\\" .. c end

--- A text of LaTeX.
function quote.latex(text)
  text = text:gsub("%c", " "):gsub("[\\&%%$#_{}~^]", special):gsub("√", "$\\surd$")
  return (text:gsub("%f[^%s%z(]%-(%d[%d.]*)", "$-%1$"))
end

return quote

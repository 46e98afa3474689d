-- The architecture of src/, read from its files: which folder includes which, where Lua and VTK are known, and how long
-- files, classes and functions are. What is beyond a rule today is in the lists of exceptions. An exception that is no
-- longer needed fails as well: take its line out.
--
-- Run: lua5.4 tests/script/tree/architecture_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "architecture"
local case, expect, equal = checks.case, checks.expect, checks.equal

local most_lines, most_members, most_function_lines = 450, 25, 60

-- Exceptions ----------------------------------------------------------------------------------------------------------

local exceptions = {
  arrows = {},
  lua = {},
  lines = {
    "algebra/condensed.cpp",
  },
  members = {
    "algebra/effective_stiffness.h EffectiveStiffness", "contact/member_contacts.h Contact",
    "contact/surface_contact.h SurfaceContact", "model/structure.h Structure",
    "run/integrator.h Integrator", "run/run.h Run", "run/step_size.h StepSize",
    "section/section_law.h SectionLaw",
  },
  functions = {},
}

-- Reading -------------------------------------------------------------------------------------------------------------

local src = support.root .. "src/"
local paths, text_of = {}, {}
for path in support.output("cd " .. support.quote(src) .. " && find . -name '*.cpp' -o -name '*.h' -o -name '*.inc'")
  :gmatch "%./([^\n]+)" do
  if not path:find "^viewer/" then
    paths[#paths + 1] = path
    text_of[path] = assert(support.read(src .. path))
  end
end
table.sort(paths)

-- The text with blanks in the place of comments, texts and lines of the preprocessor. Lines stay where they are.
local function code_of(text)
  local function blank(s) return (s:gsub("[^\n]", " ")) end
  text = ("\n" .. text):gsub('R"%(.-%)"', blank)
  local parts, at = {}, 1
  while true do -- the first of: a comment, a text, a character
    local from = text:find("[/\"']", at)
    if not from then break end
    local kind, to = text:sub(from, from + 1), nil
    if kind == "//" then to = (text:find("\n", from, true) or #text + 1) - 1
    elseif kind == "/*" then to = select(2, text:find("*/", from + 2, true)) or #text
    elseif kind:sub(1, 1) ~= "/" and not text:find("^%w'", from - 1) then -- not 1'000
      local quote = text:sub(from, from)
      to = from + 1
      while to <= #text and text:sub(to, to) ~= quote do to = to + (text:sub(to, to) == "\\" and 2 or 1) end
    end
    parts[#parts + 1] = text:sub(at, to and from - 1 or from)
    if to then parts[#parts + 1] = blank(text:sub(from, to)) end
    at = (to or from) + 1
  end
  parts[#parts + 1] = text:sub(at)
  return (table.concat(parts):gsub("\n[ \t]*#[^\n]*", blank)):sub(2)
end

-- What opens a brace, by the text before it since the last `;`, `{` or `}`.
local function kind_of_block(head)
  head = head:gsub("%[%[.-%]%]", ""):gsub("template%s*%b<>", "")
  if head:find "%f[%w]namespace[%s%w_:]*$" or head:find "%f[%w]extern%s*$" then return "namespace" end
  if head:find "^[%s%w_:]*%f[%w]enum%f[%W]" and not head:find "%(" then return "enum" end
  local name = head:match "^%s*[%w_%s:]-%f[%w]class%s+([%w_:]+)" or head:match "^%s*[%w_%s:]-%f[%w]struct%s+([%w_:]+)"
  if name and not head:find "^[^:]*%)" then return "class", name end
  if head:find "%b()" and not head:find "=%s*$" and not head:find "^%s*[%w_:<>,%s&*]+=%s*%[" then return "function" end
  return "value"
end

-- Calls found(kind, name, from, to, has) for each class and function. Of a class `has` counts its data members (fields)
-- and its own public functions (calls), not those that it overrides; what nested types have is theirs.
local function each_block(code, found)
  local stack, head, line, at = { { kind = "namespace", fields = 0, calls = 0 } }, 1, 1, 1
  local function read_access(words)
    for access in words:gmatch "%f[%w](%l+)%s*:%f[^:]" do
      if access == "public" or access == "private" or access == "protected" then stack[#stack].access = access end
    end
  end
  local function declaration(to)
    local top = stack[#stack]
    if top.kind ~= "class" then return end
    local words = code:sub(head, to)
    read_access(words)
    words = words:gsub("%f[%w]%l+%s*:%f[^:]", ""):gsub("%[%[.-%]%]", ""):gsub("template%s*%b<>", "")
    local first = words:match "^%s*([%w_]+)"
    if not first or (" using typedef friend static_assert "):find(" " .. first .. " ", 1, true) then return end
    words = words:gsub("%b<>", ""):gsub("%f[%w]operator%f[%W][^(]*", "operator"):gsub("%b{}", "")
    if words:gsub("=.*", ""):find("(", 1, true) then
      local is_own = top.access == "public" and not words:find "%f[%w]override%f[%W]"
      if is_own then top.calls = top.calls + 1 end
    else
      top.fields = top.fields + 1 + select(2, words:gsub("%b()", ""):gsub(",", ""))
    end
  end
  while true do
    local from = code:find("[;{}\n]", at)
    if not from then break end
    local c, top = code:sub(from, from), stack[#stack]
    at = from + 1
    if c == "\n" then line = line + 1
    elseif c == "{" then
      local kind, name = "inside", nil
      local is_block = code:find("^%s", from - 1) -- else an initializer, x_{1}
      local before = code:sub(head, from - 1)
      if top.kind == "class" then
        read_access(before)
        before = before:gsub("%f[%w]public%s*:%f[^:]", ""):gsub("%f[%w]private%s*:%f[^:]", "")
          :gsub("%f[%w]protected%s*:%f[^:]", "")
      end
      if is_block and (top.kind == "namespace" or top.kind == "class") then kind, name = kind_of_block(before) end
      local blank_lines = select(2, before:match "^%s*":gsub("\n", ""))
      local first = line - select(2, before:gsub("\n", "")) + blank_lines
      stack[#stack + 1] = { kind = kind, name = name or before:gsub("%b<>", ""):match "([%w_:~]+)%s*%(", from = first,
        head = head, fields = 0, calls = 0, access = before:find "%f[%w]class%f[%W]" and "private" or "public" }
      if kind ~= "value" and kind ~= "inside" then head = at end
    elseif c == "}" then
      if #stack > 1 then table.remove(stack) end
      if top.kind == "class" or top.kind == "function" then
        found(top.kind, top.name or "?", top.from, line, top)
      end
      if top.kind == "function" then
        head = top.head
        declaration(at - 1)
      end
      if top.kind ~= "value" and top.kind ~= "inside" then head = at end
    elseif c == ";" and (top.kind == "namespace" or top.kind == "class") then
      declaration(from)
      head = at
    end
  end
end

-- Each thing beyond a rule is in its list of exceptions, and each exception is beyond its rule.
local function hold(list, beyond, rule)
  local needed = {}
  for _, name in ipairs(list) do needed[name] = false end
  local new = {}
  for name, what in pairs(beyond) do
    if needed[name] == nil then new[#new + 1] = ("%s (%s)"):format(name, what) else needed[name] = true end
  end
  table.sort(new)
  expect(#new == 0, "%s:\n  %s", rule, table.concat(new, "\n  "))
  local idle = {}
  for name, is_needed in pairs(needed) do if not is_needed then idle[#idle + 1] = name end end
  table.sort(idle)
  expect(#idle == 0, "no longer needed, take them out of the exceptions: %s", table.concat(idle, ", "))
end

local function each_include(visit)
  for _, path in ipairs(paths) do
    for quote, header in text_of[path]:gmatch '\n?#%s*include%s+(["<])([^">]+)[">]' do visit(path, header, quote) end
  end
end

-- Rules ---------------------------------------------------------------------------------------------------------------

case("a folder includes headers of those below it alone", function()
  local readme = assert(support.read(src .. "README.md"))
  local order = assert(readme:match "Dependencies point one way.-\n`([^`]* <%- [^`]*)`",
    "src/README.md does not order the folders")
  local floor, floors = {}, 0
  for folders in (order:gsub("%s+", "") .. "<-"):gmatch "(.-)<%-" do
    floors = floors + 1
    for folder in folders:gmatch "[%l/]+" do floor[folder] = floors end
  end
  local function folder_of(path) -- script/lua and script/bind are folders of their own
    local two = path:match "^(%l+/%l+)/"
    return two and floor[two] and two or path:match "^(%l+)/" or "main"
  end
  expect(floors >= 13 and floor.main == floors, "%d floors: %s", floors, order)
  local beyond, includes = {}, 0
  each_include(function(path, header, quote)
    if quote ~= '"' then return end
    local from, to = folder_of(path), folder_of(header)
    if to == "main" and not text_of[header] then return end -- made by the build
    includes = includes + 1
    local known = expect(floor[from] and floor[to], "src/%s includes %s: a folder that src/README.md does not order",
      path, header)
    if known and from ~= to and floor[to] >= floor[from] then
      beyond[path .. " -> " .. header] = from .. " -> " .. to
    end
  end)
  expect(includes > 1000, "%d lines that include a header", includes)
  hold(exceptions.arrows, beyond, "arrows up, against " .. order)
end)

case("Lua is known in script/ and in the program alone, VTK in output/ alone", function()
  local lua, vtk = {}, {}
  each_include(function(path, header)
    local folder = path:match "^(%l+)/"
    if header:find "^lua" and header:find "%.h" and folder and folder ~= "script" then lua[path] = header end
    if header:find "^vtk" and folder ~= "output" then vtk[path] = header end
  end)
  hold(exceptions.lua, lua, "Lua outside of script/")
  hold({}, vtk, "VTK outside of output/")
end)

case(("no file has more than %d lines"):format(most_lines), function()
  local beyond = {}
  for _, path in ipairs(paths) do
    local lines = select(2, text_of[path]:gsub("\n", ""))
    if lines > most_lines then beyond[path] = lines .. " lines" end
  end
  hold(exceptions.lines, beyond, "files that are too long")
end)

local classes, functions, count = {}, {}, { class = 0, ["function"] = 0 }
for _, path in ipairs(paths) do
  each_block(code_of(text_of[path]), function(kind, name, from, to, has)
    count[kind] = count[kind] + 1
    local lines = to - from + 1
    if has.fields > most_members or has.calls > most_members then
      classes[path .. " " .. name] = ("%d data members, %d public functions"):format(has.fields, has.calls)
    end
    if kind == "function" and lines > most_function_lines then functions[path .. " " .. name] = lines .. " lines" end
  end)
end

case(("no class has more than %d data members or public functions"):format(most_members), function()
  expect(count.class > 500, "%d classes were found", count.class)
  hold(exceptions.members, classes, "classes that are too large")
end)

case(("no function has more than %d lines"):format(most_function_lines), function()
  expect(count["function"] > 3000, "%d functions were found", count["function"])
  hold(exceptions.functions, functions, "functions that are too long")
end)

-- The reading itself --------------------------------------------------------------------------------------------------

case("classes and functions are read as a compiler reads them", function()
  local found = {}
  each_block(code_of [[
namespace a {
/// A class { of
class One : public Two {
public:
    One(int x) : x_(x), y_{x} {}
    virtual int get() const { return "}"[0]; }  // }
    int far() const override { return 0; }
    using Name = int;
    enum class Kind { first, second };
    struct Inner {
        int a, b;
    };
    template <class T>
    T plus(T t) {
        const auto f = [&](T u) { return u + t; };
        return f(t);
    }

private:
    int x_ = 1'000;
    std::vector<int> y_{1, 2};
};
const int table[] = {1, 2};
int far(int b) {
    if (b) {
        return 1;
    }
    return 0;
}
}  // namespace a
]], function(kind, name, from, to, has)
    found[#found + 1] = ("%s %s %d-%d%s"):format(kind, name, from, to,
      kind == "class" and (" %d, %d"):format(has.fields, has.calls) or "")
  end)
  equal(table.concat(found, "; "), "function One 5-5; function get 6-6; function far 7-7; class Inner 10-12 2, 0; "
    .. "function plus 13-17; class One 3-22 2, 3; function far 24-29", "what is found")
end)

checks.done()

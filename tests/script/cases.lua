-- The cases of a test file: each has a name, is reported by it, and can be run alone. A file looks like this:
--
--   local checks = support.checks "statics"
--   local case, expect = checks.case, checks.expect
--   case("gravity acts in statics", function() expect(sag > 0, "the sag is %g m", sag) end)
--   checks.done()
--
-- case=TEXT among the arguments runs the cases that have this text in their name, in any case of letters; case=list
-- names all. The environment variable HINGE_CASE does the same, for ctest.
local cases = {}

-- The text that chooses cases, or nil. It is taken out of the arguments, which are the test's own.
local function chosen_text()
  local arguments = rawget(_G, "arg") or {}
  for i = #arguments, 1, -1 do
    local text = arguments[i]:match "^case=(.*)$"
    if text then
      table.remove(arguments, i)
      return text
    end
  end
  return os.getenv "HINGE_CASE"
end
local chosen = chosen_text()
--- The argument that chooses these cases in another process that runs the same test, or "case=".
cases.argument = "case=" .. (chosen or "")

-- "file.lua:12: ", with the lines that led to a check: the one in the case first, those of the test's own functions
-- after it.
local function place_of_check(file, body)
  local lines, level = {}, 3
  while true do
    local info = debug.getinfo(level, "Slf")
    if not info then break end
    if info.source == file and info.currentline > 0 then table.insert(lines, 1, info.currentline) end
    if info.func == body then break end
    level = level + 1
  end
  return ("%s:%s: "):format(file:match "[^/]*$", table.concat(lines, " > "))
end

--- A list of named cases with checks in them: case(name, body), expect(ok, what, ...), equal(value, wanted, what),
--- near(value, wanted, within, what); done() at the end of the file, or skip(why). `test` is for the test of this list:
--- { case =, print =, exit = } in the place of the argument, of print and of os.exit.
function cases.new(title, test)
  local text = chosen
  if test then text = test.case end
  local print_, exit = test and test.print or print, test and test.exit or os.exit
  local list = {}
  local names, failed, ran, count = {}, {}, 0, 0
  local current -- { name =, body =, file =, failures =, checks = } of the case that runs

  function list.case(name, body)
    assert(type(name) == "string" and name:find "%S" and type(body) == "function", "case(name, function)")
    assert(not current, "a case within a case")
    assert(not names[name], "two cases have this name: " .. name)
    names[#names + 1], names[name] = name, true
    if text == "list" then return print_(name) end
    if text and not name:lower():find(text:lower(), 1, true) then return end
    current = { name = name, body = body, file = debug.getinfo(body, "S").source, failures = {}, checks = 0 }
    local ok, message = xpcall(body, function(problem) return debug.traceback(tostring(problem), 2) end)
    local failures = current.failures
    if not ok then failures[#failures + 1] = message:gsub("\n%s*%[C%]: in function 'xpcall'.*$", "") end
    if ok and current.checks == 0 then failures[1] = "the case checks nothing" end
    ran, count = ran + 1, count + current.checks
    current = nil
    if #failures == 0 then return print_("ok      " .. name) end
    failed[#failed + 1] = name
    print_("FAILED  " .. name)
    for _, what in ipairs(failures) do print_("        " .. what:gsub("\n", "\n        ")) end
  end

  function list.expect(ok, what, ...)
    if not current then error("a check outside of a case: " .. what, 2) end
    current.checks = current.checks + 1
    if not ok then list.fail(what, ...) end
    return ok
  end
  function list.fail(what, ...)
    if select("#", ...) > 0 then what = what:format(...) end
    table.insert(current.failures, place_of_check(current.file, current.body) .. what)
  end
  function list.equal(value, wanted, what)
    return list.expect(value == wanted, "%s: is %s, wanted %s", what, tostring(value), tostring(wanted))
  end
  function list.near(value, wanted, within, what)
    return list.expect(math.abs(value - wanted) <= within, "%s: is %.10g, wanted %.10g within %.3g",
      what, value, wanted, within)
  end

  -- What is wrong with the file as a whole, or nil.
  local function problem()
    if text == "list" then return nil end
    if #names > 0 and ran == 0 then
      return ("no case has '%s' in its name; the cases are:\n  %s"):format(text, table.concat(names, "\n  "))
    end
    if #names == 0 then return "the file has no case" end
    if #failed > 0 then
      return ("%d of %d cases failed:\n  %s"):format(#failed, ran, table.concat(failed, "\n  "))
    end
  end
  local ended = false
  function list.done()
    ended = true
    local what = problem()
    if what then
      io.stdout:flush()
      io.stderr:write(("%s: %s\n"):format(title, what))
      return exit(1, true) -- true: what is to be closed is closed
    end
    if text ~= "list" then
      print_(("%s: %d case%s, %d checks passed"):format(title, ran, ran == 1 and "" or "s", count))
    end
  end
  --- Ends a test that cannot run here.
  function list.skip(why)
    ended = true
    print_(("%s: skipped: %s"):format(title, why))
    return exit(77, true)
  end
  -- A file without done() would pass whatever its cases say.
  list.guard = setmetatable({}, { __gc = function()
    if not ended and not test then
      io.stderr:write(("%s: the file ended before checks.done()\n"):format(title))
      exit(1)
    end
  end })
  return list
end

return cases

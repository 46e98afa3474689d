-- hinge run --live: the page and the newest frame over plain sockets, whom it refuses, that it changes no bit, that it
-- ends with the run, and, in a headless Chromium where one and Node.js are installed, the page
-- (tests/viewer/live_test.js).
--
-- Run: lua5.4 tests/script/report/live_test.lua BUILD [PICTURE]      PICTURE: where a picture of the page goes
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "live"
local case = checks.case
local quote, run, expect, equal = support.quote, support.run, checks.expect, checks.equal
local folder = support.temporary_folder()
local hinge = quote(arg[1] .. "/hinge")
local function path(name) return folder .. "/" .. name end
local function text_of(name) return support.read(path(name)) or "" end

-- The frame stands under its weight, and the bar breaks. The run goes on until there is a file STOP, or to its end.
-- wait: s that it waits after every tenth step.
support.write(path "scene.lua", require "report.storeys" .. [=[
model:fracture { curvature_x = 0.3, curvature_y = 0.3 }
local loaded = model:static { fixed_group = evil, steps = 4 }
loaded:finish()
local record = tonumber(how.record)
if how.record == "no" then record = false end
local run = model:dynamic { from = loaded, dt = 2e-5, duration = tonumber(how.duration), record = record }
run:probe { node = node[1][2], "ux", name = "sway" }
for step in run:steps() do
  local clock = os.clock() -- and not a command that sleeps: the signal would go there
  if how.wait and step.index % 10 == 0 then repeat until os.clock() > clock + how.wait end
  if how.stop and step.index % 20 == 0 then
    local file = io.open(how.stop)
    if file then file:close() run:stop() end
  end
end
return { text = "a result" }
]=])

-- Starts a run in the background, in that folder; returns its process and address.
local function start(name, arguments, verb)
  local err = path(name .. ".err")
  os.remove(err)
  local pid = support.output(("cd %s && { %s %s scene.lua %s --out live_%s >%s 2>%s </dev/null & echo $!; }"):format(
    quote(folder), hinge, verb or "run -q --live", arguments, name, quote(path(name .. ".out")), quote(err)))
  local address
  for _ = 1, 500 do
    address = (support.read(err) or ""):match "live until the program ends: (http://127%.0%.0%.1:%d+/)\n"
    if address then break end
    os.execute "sleep 0.02"
  end
  expect(address, "%s: no address: %s", name, support.read(err))
  return pid:match "%d+", address or "http://127.0.0.1:1/"
end
-- A program that has ended stays in the list of processes until its parent takes note, for seconds in some containers.
local function alive(pid)
  local status = support.read(("/proc/%s/stat"):format(pid))
  return status ~= nil and not status:find "%) Z "
end
local function ends(pid, what, seconds)
  for _ = 1, (seconds or 20) * 50 do
    if not alive(pid) then return true end
    os.execute "sleep 0.02"
  end
  os.execute("kill -9 " .. pid)
  return expect(false, "%s: the program does not end", what)
end

-- What the server answers, by bash's own sockets; "" where there is none.
local function ask(address, request)
  local port = address:match ":(%d+)/"
  local script = ("exec 3<>/dev/tcp/127.0.0.1/%s && printf %%b %s >&3 && timeout 30 cat <&3")
    :format(port, quote(request))
  return support.output("bash -c " .. quote(script) .. " 2>/dev/null")
end
local function get(address, target, host)
  local answer = ask(address, ("GET %s HTTP/1.1\\r\\nHost: %s\\r\\n\\r\\n"):format(target, host or "127.0.0.1"))
  return answer:match "^(.-)\r\n", answer:match "\r\n\r\n(.*)$" or ""
end
local function state(address, query)
  local status, body = get(address, "/state?" .. query)
  expect(status == "HTTP/1.1 200 OK", "/state?%s: %s", query, status)
  return support.json(body == "" and "{}" or body)
end

-- The first state of the dynamic run, the second one of the script.
local function second_run(address, query)
  local now = { version = 0 }
  for _ = 1, 50 do
    now = state(address, ("after=%d&%s"):format(now.version or 0, query or ""))
    if now.run == 2 then return now end
  end
  error "the second run never comes"
end

case("the page has each new state of the run, other requests are refused, and no client holds the run up", function()
  local one, at_one = start("one", "duration=10 wait=0.01 stop=stop_one")
  local two, at_two = start("two", "duration=10 wait=0.01 stop=stop_two record=no")
  expect(at_one ~= at_two, "two programs at once have one address: %s", at_one)
  local status, page = get(at_one, "/")
  equal(status, "HTTP/1.1 200 OK", "the page")
  local id = page:match '<script type="application/json" id="data">{"live":"(%x+)"}</script>'
  expect(id and #id == 16, "the page has no id")
  expect(page:find("connect-src 'self'", 1, true) and page:find("default-src 'none'", 1, true),
    "what the page may ask for")
  local first = second_run(at_one, "page=a&program=" .. tostring(id))
  equal(first.program, "running", "the program")
  equal(first.run, 2, "number of the run")
  equal(first.runs, 2, "runs so far")
  equal(first.made_at, "scene.lua:29", "where it was made")
  checks.near(first.planned, 500000, 100, "steps planned") -- and a few that were halved
  equal(first.summary.verdict, "running", "verdict")
  equal(first.summary.kind, "dynamic", "kind")
  equal(first.summary.model.elements, 14, "elements")
  equal(first.frame.bars, 14, "elements in the frame")
  expect(first.frame.declared and first.frame.positions, "the frame has no model, or no positions")
  equal(first.frame.groups[2], "<script>window.hurt = 1</script>", "a group")
  equal(first.frame.times[1], first.summary.time, "time of the frame")
  equal(first.history.columns[#first.history.columns], "sway", "last column of the history")
  local function last_row(s) return s.history.rows[#s.history.rows] end
  expect(math.abs(last_row(first)[1] - first.summary.time) < 1e-9, "the history ends at %s, and the frame is of %s",
    last_row(first)[1], first.summary.time)
  equal(first.history.rows[1][1], 0, "the history begins")
  local second = state(at_one, ("after=%d&run=2&events=%d"):format(first.version, first.events.from
    + #first.events.rows))
  expect(second.version > first.version and second.summary.time > first.summary.time, "no newer state: %s at %s",
    second.version, second.summary.time)
  expect(second.frame.positions and not second.frame.declared, "the model comes twice")
  equal(second.events.from, #first.events.rows, "events that are known come again")
  equal(state(at_one, "after=0&program=0000").program, "another", "a page of an earlier program")
  local unrecorded = state(at_two, "after=" .. second_run(at_two).version)
  expect(#unrecorded.history.rows >= 2 and math.abs(last_row(unrecorded)[1] - unrecorded.summary.time) < 1e-9,
    "without record the history has %d rows", #unrecorded.history.rows)

  equal(get(at_one, "/state", "evil.example"), "HTTP/1.1 403 Forbidden", "another host")
  equal(get(at_one, "/", "evil.example:80"), "HTTP/1.1 403 Forbidden", "another host")
  equal(get(at_one, "/summary.json"), "HTTP/1.1 404 Not Found", "another path")
  equal(ask(at_one, "what is this\\r\\n\\r\\n"):match "^(.-)\r\n", "HTTP/1.1 400 Bad Request", "no request")
  equal(ask(at_one, "POST / HTTP/1.1\\r\\nHost: localhost\\r\\n\\r\\n"):match "^(.-)\r\n",
    "HTTP/1.1 405 Method Not Allowed", "another method")
  local port = at_one:match ":(%d+)/"
  checks.ended(2, { "hinge: --live: cannot listen on 127.0.0.1 at port " .. port .. ": Address already in use",
    "give another one, or --live alone" },
    run(("cd %s && %s run --live=%s scene.lua duration=0.001 --out live_three"):format(quote(folder), hinge, port)))
  local interfaces = support.output "cat /proc/net/tcp"
  expect(interfaces:find((" 0100007F:%04X 00000000:0000 0A"):format(port)), "it does not listen on 127.0.0.1")
  expect(not interfaces:find((" 00000000:%04X "):format(port)), "it listens on all interfaces")

  -- A client that asks and never reads does not hold the run up, nor its end; Ctrl-C ends it, and who waits is told.
  local mute = io.popen(("bash -c 'for i in 1 2 3; do exec {f}<>/dev/tcp/127.0.0.1/%s; "
    .. "printf \"GET / HTTP/1.1\\r\\nHost: localhost\\r\\n\\r\\n\" >&$f; done; echo there; until [ -e %s ]; "
    .. "do sleep 0.1; done'"):format(port, path "stop_mute"))
  mute:read "l"
  local before = state(at_one, "after=0&run=2")
  local after = state(at_one, "after=" .. before.version .. "&run=2")
  expect(after.summary.steps > before.summary.steps, "the run stands still")
  local waits = io.popen(("bash -c 'exec 3<>/dev/tcp/127.0.0.1/%s; "
    .. "printf \"GET /state?after=1000000&page=w HTTP/1.1\\r\\n"
    .. "Host: localhost\\r\\n\\r\\n\" >&3; echo there; cat <&3'"):format(port))
  waits:read "l"
  os.execute "sleep 0.3"
  local took = os.time()
  os.execute("kill -INT " .. one)
  ends(one, "Ctrl-C", 5)
  expect(os.time() - took <= 3, "Ctrl-C takes %d s", os.time() - took)
  expect(text_of "one.err":find("interrupted by Ctrl-C after step", 1, true), "Ctrl-C: %s", text_of "one.err")
  equal(ask(at_one, "GET / HTTP/1.1\\r\\nHost: localhost\\r\\n\\r\\n"), "", "the server after Ctrl-C")
  waits:close()
  support.write(path "stop_mute", "")
  mute:close()
  support.write(path "stop_two", "")
  ends(two, "run:stop")
  equal(support.json(text_of "live_two/summary.json").verdict, "stopped", "verdict of the run that was stopped")
end)

case("a client that waits at the end gets the summary", function()
  -- Who waits at the end hears of it, with the summary, and the program does not wait for who does not.
  local three, at_three = start("three", "duration=10 wait=0.01 stop=stop_three")
  second_run(at_three)
  local last, answers = second_run(at_three, "page=w"), 0
  os.execute(("{ sleep 0.5; touch %s; } &"):format(quote(path "stop_three"))) -- while the next request waits
  for _ = 1, 50 do
    local _, body = get(at_three, ("/state?after=%d&run=2&page=w"):format(last.version))
    if body == "" then break end
    last, answers = support.json(body), answers + 1
    if last.program == "ended" then break end
  end
  equal(last.program, "ended", ("the last of %d answers"):format(answers))
  equal(last.status, 0, "exit status, at the end")
  equal(last.folder, "live_three", "folder, at the end")
  equal((last.summary or {}).verdict, "stopped", "verdict, at the end")
  equal(((last.summary or {}).results or {}).text, "a result", "results, at the end")
  ends(three, "who waits", 10)
end)

-- Not one bit is another, whether somebody looks or not.
local function plain(name, verb)
  return run(("cd %s && %s %s scene.lua duration=0.03 --out live_%s"):format(quote(folder), hinge, verb, name))
end
case("no bit of a run changes where somebody looks at it", function()
  equal(plain("alone", "run -q"), 0, "a run without --live")
  local looked, at_looked = start("looked", "duration=0.03 wait=0.01")
  local states = 0
  while alive(looked) do
    local _, body = get(at_looked, "/state?after=" .. states .. "&page=b")
    if body ~= "" then states = states + 1 end
  end
  expect(states > 2, "it was looked at %d times", states)
  local _, told = checks.ended(0, "", plain("unseen", "run -q --live"))
  expect(support.says(told, "live until the program ends: http://127.0.0.1:.../\n"), "nobody looks: %s", told)
  local alone = support.json(text_of "live_alone/summary.json")
  for _, name in ipairs { "looked", "unseen" } do
    local summary = support.json(text_of("live_" .. name .. "/summary.json"))
    equal(summary.state_hash, alone.state_hash, name .. ": state")
    equal(summary.energy_error, alone.energy_error, name .. ": energy error")
    for _, file in ipairs { "history.csv", "history-1.csv", "events.csv" } do
      checks.same_files(path("live_" .. name .. "/" .. file), path("live_alone/" .. file), name)
    end
  end
end)

case("--live is an event with --json, goes in the sandbox, and is refused by other verbs", function()
  local _, events = plain("json", "run --json --live")
  local event = support.json(events:match "^[^\n]*")
  expect(event.event == "live" and event.address:find "^http://127%.0%.0%.1:%d+/$", "--json: %s", events:sub(1, 200))
  if not os.getenv "HINGE_SANITIZED" then -- ASan needs more address space than the sandbox gives
    local _, told_there = checks.ended(0, "", plain("boxed", "--live --sandbox"))
    expect(told_there:find("live until the program ends: http", 1, true), "--sandbox: %s", told_there)
  end
  for _, words in ipairs { "study --live", "cost --live", "plan --live", "check --live", "run --live=abc",
    "run --live=65536", "run --live=-1" } do equal(plain("other", words), 2, words) end
end)

local look = support.browser "live"
if look then
  case("in a browser the page shows the run", function()
    os.remove(path "stop_one")
    local shown, at_shown = start("one", "duration=10 wait=0.02 stop=stop_one record=10")
    local said = checks.ended(0, "", look("live_test.js", at_shown, path "stop_one", arg[2]))
    expect((tonumber(said:match "(%d+) checked") or 0) > 25, "in a browser: %s", said)
    ends(shown, "the program that was looked at")
  end)
end
checks.done()

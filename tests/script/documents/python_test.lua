-- The page of the guide on results in Python: its blocks run one after the other and print what the page shows, and the
-- notebook beside it has the same code. Without pandas the notebook alone is compared.
--
-- Run: lua5.4 tests/script/documents/python_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
package.path = support.root .. "lua/guide/?.lua;" .. package.path
local pages = require "pages"
local checks = support.checks "python"
local case, equal, expect = checks.case, checks.equal, checks.expect

local name = "results_in_python"
local text = assert(pages.read(pages.folder .. name .. ".md"))
local blocks = pages.python(text)

case("the notebook has the page's code", function()
  expect(#blocks >= 5, "the page has %d blocks of Python", #blocks)
  equal(pages.read(pages.folder .. name .. ".ipynb"), pages.notebook(text, name), "the notebook")
end)

local python = pages.python_there()
if python then
  case("the blocks run, and print what stands below them", function()
    local folder, run, clean = pages.workplace(arg[1])
    for _, block in ipairs(pages.blocks(text)) do
      for _, c in ipairs(block.language == "console" and pages.commands(block.text) or {}) do
        local status, _, complaint = run(c.command)
        equal(status, 0, c.command .. ": " .. complaint)
      end
    end
    local outputs, complaint = pages.run_python(blocks, folder, run, python)
    clean()
    expect(outputs, "the Python of the page fails: %s", complaint)
    for i, block in ipairs(blocks) do
      expect(block.output, "block %d has no text below it", i)
      if outputs and block.output then checks.prints(outputs[i], block.output.text, "block " .. i) end
    end
  end)
  case("the notebook is JSON with a cell for each block", function()
    local counted = support.output(("%s -c 'import json, sys; cells = json.load(open(sys.argv[1]))[\"cells\"]; "
      .. "print(sum(c[\"cell_type\"] == \"code\" for c in cells))' %s"):format(python,
        support.quote(pages.folder .. name .. ".ipynb")))
    equal(tonumber(counted), #blocks, "cells of code")
  end)
else
  print "pandas is not installed: the Python of the page does not run"
end

checks.done()

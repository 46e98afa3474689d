-- Words that engineers look for and that the reference does not use, or uses for something else. hinge reference and
-- help answer with the calls to read instead.
--
-- see: names of the reference, the nearest first. missing: hinge has no such thing. how: what these calls do for it.
local function there(see, how) return { see = see, how = how } end
local function missing(see, how) return { see = see, how = how, missing = true } end

local floors = there({ "model:floor", "model:diaphragm", "hinge.pressure" },
  "the load and the mass of a floor act on the members around it; it may be rigid in its plane, and does not bend")
local plates = there({ "model:panel", "model:floor" },
  "plates between three or four nodes, in their plane and in bending; bodies do not touch them")
local drift = there({ "results.storeys", "node:displacement" },
  "hinge.results.storeys has the drift and the shear force of each storey")
local modes = there({ "run:modes", "mode:displacement" }, "hinge check SCRIPT prints the natural periods, too")
local no_law = missing({ "section.concrete", "hinge.model_options", "hinge.backbone" },
  "a hinge has one law of N, Mx and My: that of the section's shape, of concrete with its bars")
local falls = there({ "hinge.backbone", "model:member" }, "the strength of a member's ends over their plastic rotation")
local standard = there(
  { "hinge.backbone.asce41", "hinge.backbone.ufc", "hinge.backbone.nist", "hinge.backbone.lignos" },
  "backbones of beams, columns and connections by published formulas, and the limits that go with them")
local hardens = there({ "hinge.material" }, "the options hardening = { tangent = } and rate = { D =, q = }")
local one_way = there({ "model:member" }, "the option carries = \"tension\" or \"compression\"")
local temperature = there({ "model:heat", "heat.steel" }, "members lengthen and lose stiffness and strength with heat")
local support = there({ "model:fix", "model:move" }, "supports are fixed degrees of freedom of a node")
local released = there({ "model:member", "hinge.joint" },
  "the options release = { a = { \"Mx\", \"My\" } } for a pin and ends = { a = hinge.joint {...} } of a member")
local rigid = there({ "model:rigid_link", "model:diaphragm" }, "a node moves with another one as a rigid body")
local shaken = there({ "hinge.ground", "model:move", "hinge.record.read" },
  "hinge.ground turns accelerations into displacements, and model:move applies them to supports")
local joints = there({ "hinge.joint", "model:joint", "run:hinges" },
  "ends = { a = hinge.joint {...} } of a member, or model:joint between two nodes; run:hinges rates them")
local zone = there({ "joint.panel_zone", "model:joint" }, "the web of a column between the beams that meet there")
local dampers = there({ "model:connector" }, "curves, dashpots and functions of a connector act between two nodes")
local robust = there({ "hinge.robustness", "model:remove" }, "frames that lose columns, by three procedures")
local push = there({ "model:static" }, "control = { node = n, \"ux\", to = 0.3 } drives one displacement")
local pressure = there({ "hinge.pressure", "model:load" }, "a pressure on an area or a face becomes loads of members")
local lengths = there({ "results.utilisation", "model:imperfection" },
  "the option lengths of hinge.results.utilisation; a run of second order needs none")
local used = there({ "results.utilisation", "run:read" },
  "hinge.results.utilisation checks members of steel by EN 1993-1-1 or AISC 360; f_y is 1 where fully plastic")
local base = there({ "results.base", "node:reaction" }, "reactions, loads, weight and what is left of them")
local extremes = there({ "results.envelope", "results.members" }, "extreme forces of members, with place and time")
local named = there({ "section.named", "section.names" }, "a section by its name in tables, such as HEB 300 or W14X90")
local grade = there({ "material.steel", "material.names" }, "a material by its name in standards, such as S355 or A992")

return {
  ["acceleration record"] = shaken, accelerogram = shaken, ["ground motion"] = shaken, earthquake = shaken,
  ["time history"] = shaken, seismic = shaken,
  ["response spectrum"] = there({ "hinge.spectrum" }, "the largest responses of oscillators to a record"),
  explosion = there({ "hinge.blast", "explosion:load" }, "pressure of an explosion on the ground, and loads from it"),
  drift = drift, ["storey drift"] = drift, ["interstorey drift"] = drift,
  diaphragm = rigid,
  ["storey shear"] = drift, ["story drift"] = drift,
  slab = floors, floor = floors, shell = plates, wall = plates, membrane = plates,
  ["own weight"] = there({ "model:gravity" }, "gravity acts on the density of members and on point masses"),
  ["dead load"] = there({ "model:case", "model:load", "model:gravity" }, "a load case holds loads under a name"),
  ["load combination"] = there({ "model:combination", "model:case" }, "factors of load cases under a name"),
  pushover = push, ["capacity curve"] = push, ["displacement control"] = push,
  wind = pressure, snow = pressure,
  connection = joints, ["semi rigid"] = joints, ["joint rotation"] = joints, ["moment rotation"] = joints,
  ["partial strength"] = joints, ["panel zone"] = zone, ["end plate"] = there({ "joint.end_plate" }, joints.how),
  ["base plate"] = there({ "joint.base_plate" }, joints.how),
  ["plastic hinge"] = there({ "run:hinges" }, "rotation, work and first yield of each hinge and joint, against limits"),
  ["progressive collapse"] = robust, ["column removal"] = robust, ["alternate path"] = robust,
  ["demand capacity ratio"] = robust, dcr = robust,
  ["incremental dynamic analysis"] = there({ "hinge.study" }, "a scenario with many values of a parameter"),
  ["p delta"] = there({ "hinge.model_options" }, "displacement = \"large\", the default, has it; option p_delta"),
  ["buckling length"] = lengths, ["effective length"] = lengths,
  reinforcement = there({ "section.concrete" }, "concrete with bars"),
  rebar = there({ "section.concrete" }, "concrete with bars"),
  mode = modes, ["modal analysis"] = modes, eigenvalue = modes,
  ["natural period"] = modes, ["natural frequency"] = modes,
  hardening = hardens, ["kinematic hardening"] = hardens, ["strain rate"] = hardens,
  rbs = standard, ["reduced beam section"] = standard, wuf = standard, ["moment connection"] = standard,
  ["asce 41"] = standard, ["fema 356"] = standard, ["aisc 342"] = standard, ["ufc 4 023 03"] = standard, gsa = standard,
  nist = standard, ["lignos krawinkler"] = standard, ["acceptance criteria"] = standard, ["shear tab"] = standard,
  softening = falls, degradation = falls, ["hinge property"] = falls,
  fibre = no_law, fiber = no_law,
  temperature = temperature, fire = temperature, creep = temperature,
  support = support, restraint = support, ["boundary condition"] = support,
  ["moment release"] = released, pin = released, pinned = released,
  diagram = there({ "hinge.picture", "member:forces" }, "show = \"Mx\" of a view draws moments along the members"),
  ["rigid link"] = rigid, ["rigid body"] = rigid, ["rigid offset"] = rigid,
  truss = there({ "model:connector", "model:fix" }, released.how),
  cable = one_way, ["tension only"] = one_way, ["compression only"] = one_way, strut = one_way,
  prestressing = there({ "model:prestress" }, "members that were made too short, or their force between fixed ends"),
  utilisation = used, utilization = used, ["code check"] = used, ["design check"] = used, ["unity check"] = used,
  ["member check"] = used, eurocode = used, ["eurocode 3"] = used, aisc = used, ["lateral torsional buckling"] = used,
  ["base shear"] = base, ["base reaction"] = base, envelope = extremes, ["extreme forces"] = extremes,
  isolator = dampers, ["base isolation"] = dampers, damper = dampers,
  link = there({ "model:connector" }, "springs, dashpots, curves and functions between two nodes"),
  restart = there({ "run:checkpoint", "run:resume", "hinge.resume" }, "a run goes on from its checkpoint, bit by bit"),
  ipe = named, hea = named, heb = named, hem = named, upn = named, hss = named, chs = named, rhs = named, shs = named,
  ub = named, uc = named, ["section library"] = named, profile = named, catalogue = named, ["rolled section"] = named,
  ["steel grade"] = grade, grade = grade, s235 = grade, s355 = grade, a992 = grade,
  unit = there({ "hinge.units" }, "4 * hinge.units.kN / hinge.units.m is 4000 N/m"),
  convergence = there({ "hinge.cost", "hinge.static_options" }, "hinge cost SCRIPT compares settings"),
  soil = missing({ "model:ground", "model:connector" }, "the ground presses on what falls; springs hold a foundation"),
}

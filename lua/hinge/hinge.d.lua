---@meta hinge
-- Every call that a script can make, for editors that read LuaLS annotations. Nothing in this file runs.
--
-- All units are SI: m, kg, s, N, Pa, rad. Wrong input raises an error at the line of the script. The message names the
-- function, the field, the value, its unit and the allowed values. A failure of the physics or of the numerics is a
-- result, never an error: see run.verdict. "eq" and "section" refer to Lynn and Isobe's paper on the ASI-Gauss
-- technique. Jobs, models and the report are in library.d.lua.
--
-- reference.lua makes reference.md from this file. The description of a class, an alias, a function or a field stands
-- in the lines above it; a short description of a field stands after it on the same line. The description of a
-- parameter or a result stands after it, and goes on in lines below that begin with `---` and two blanks. The Lua code
-- above a function is its example. It runs after the lines at the top of reference.md, and a test runs every example.

---@class hinge
---@field version string
---@field section hinge.sections ready shapes, and any other section by its properties
---@field record hinge.records ground motion from files
---@field import hinge.imports frames from files of other programs
---@field heat hinge.heats properties of steel in fire, fire curves, temperatures
---@field results hinge.results tables for a report: forces of members, envelopes, utilisation, storeys, reactions
---units as numbers of SI: 4 * hinge.units.kN / hinge.units.m is 4000. m, mm, cm, km, inch, ft; kg, t, lb; s, ms, min,
---h, Hz, kmh; N, kN, MN, lbf, kip, kgf, tonf (of the metric ton); Pa, kPa, MPa, GPa, psi, ksi, psf; J, kJ, MJ; rad,
---mrad, deg; gravity
---@field units table<string, number>
local hinge = {}

---@alias vec3 number[] three numbers { x, y, z }
---@alias hinge.component "ux"|"uy"|"uz"|"rx"|"ry"|"rz" displacement (m) or rotation vector (rad), in space

---Continues a run from a checkpoint. It is the same as run:resume(file).
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---swing:step()
---swing:checkpoint "swing.checkpoint"
---local again = model:dynamic { dt = 1e-4, duration = 0.01 }
---hinge.resume(again, "swing.checkpoint"):finish()
---```
---@param run hinge.run
---@param file string
---@return hinge.run
function hinge.resume(run, file) end

---Makes an empty model.
---```lua
---local frame = hinge.model { elements_per_member = 4 }
---local linear = hinge.model { displacement = "small", plasticity = false }
---```
---@param options? hinge.model_options
---@return hinge.model
function hinge.model(options) end

---@class hinge.model_options
---position of the one integration point of an element (section 2). asi-gauss (default): the elements of a member work
---in pairs. While a pair is elastic, its points are the two Gauss points of the pair. When a hinge forms, the point
---moves opposite the hinge. This needs an even number of elements in each member. asi: in the middle while elastic.
---conventional: always in the middle
---@field formulation? "asi-gauss"|"asi"|"conventional"
---large (default): the geometry follows the motion (updated Lagrangian, the paper's ULF). Rotations and twist may be of
---any number of turns. small: the geometry stays as declared (total Lagrangian, TLF)
---@field displacement? "large"|"small"
---what moves when a hinge forms. plastic (default): only the integration point of the plastic strain moves. The pair of
---elements keeps its exact elastic stiffness, and the energy balance closes. elastic_and_plastic: as the paper prints
---it (eqs 6, 10). The elastic point moves to the hinge too, and the point of the other element of the pair moves to the
---middle. Forces stay continuous, but the elastic energy jumps. The energy error shows this jump
---@field shift? "plastic"|"elastic_and_plastic"
---where the axial force of an element acts in large displacement. member (default): on the element's chord, and on the
---bending of each pair of elements between its ends, by the stability functions of the exact beam-column
---(src/beam/beam_column.h). Elastic columns buckle at Euler's load to 0.1 % with two elements. One that is clamped at
---both ends and cannot sway needs four to bend out; statics counts that load with two, too, dynamics warns of it.
---Moments between the ends are those of the beam-column, under end moments, loads and weight, up to 0.6 of the load at
---which the member buckles between clamped ends; beyond that a run warns. `member:along`, yield and utilisation use
---them. A hinge between the ends is in the middle, and forms when the largest moment of the span reaches the plastic
---one (src/beam/pair_bow.h). chord: on the chord alone, as in the paper. Two elements a member then carry too much in
---compression: a pinned column 2.27 times Euler's load, a clamped one whose head sways 1.22 times; four elements 1.10
---times each. A run warns where that misses more than 10 % of a moment. member needs formulation
---asi-gauss, displacement large and shift plastic; without them the default is chord
---@field p_delta? "chord"|"member"
---interaction of N, Mx and My for sections that do not say theirs (hinge.section.general). exact (default): that of
---the section's shape; sections whose shape is not known have eq 14. exact with shear: the same, and shear forces take
---strength from it. paper: eq 14, which is unsafe beside an axial force
---@field interaction? "paper"|"exact"|"exact with shear"
---how the weight of members acts. members (default): along them. It acts at the nodes of their elements, and a member's
---two end nodes get what that misses of the end moments of a load along it; `member:forces` has the part between the
---nodes, too. End forces and displacements of joints are then those of a load `q` of the same size: exact in elastic
---members with two elements in small displacement. nodes: at the nodes alone, as in the paper. The end moments of a
---clamped member of two elements are then 0.63 of w L^2 / 12, with four 0.91, and the shear forces at its ends 1/2 and
---3/4 of w L / 2. Beside compression the moments in the span are too small, by some 15, 30, 44 % at 0.3, 0.6, 0.9 of
---Euler's load; a run warns of it. With mass cubic the nodes' weights give the end moments by themselves. In dynamics
---weight acts along the members of bodies that are carried: a support holds one of the body's nodes in a direction in
---which gravity acts, or a connector (broken or not) joins it to the ground or to such a body. What falls, and what
---lies on others or on model:ground, has weight at nodes alone: there inertia bends a member as little as weight does.
---So has a member with a broken element, and in dynamics one whose weight is beyond its plastic limit load between
---clamped ends,
---16 M_p / L^2
---@field weight? "members"|"nodes"
---linear (default): the paper's consistent mass of linear shape functions (after eq 15). cubic: the mass of a pair of
---asi-gauss elements, for the cubic shape that belongs to its stiffness. It is not in the paper, and it is equally
---fast. With two elements a member, sway frequencies of slender frames are within 0.2 % with cubic; linear has an error
---of 1 to 4 %. With stocky members cubic is less exact. The vibration of a pinned member between its ends is 5 % off
---with two elements, and 0.2 % with four. cubic works with Newmark's method and statics only, and without fracture
---@field mass? "linear"|"cubic"
---@field plasticity? boolean default true; false: nothing yields, whatever the materials are
---default 2, as in the paper. "auto": 2, and 4, 8 or 16 in members that are compressed, or that yield between their
---ends. The first run decides this once, for all runs of the model. It uses what is declared at that time. It solves
---one linear static system with all loads and gravity in full: every load case has the factor 1. Loads with a history
---have their value at time 0, or the full value if that is 0. Compression counts by its effect on the bending
---stiffness. With p_delta = "member", the default, two elements include this effect exactly; members at Euler's load or
---above get four. Four are also given to a member where moments between its ends reach the fully plastic moment, and to
---a member with its own loads that yields anywhere. The decision does not include impacts, motions of supports,
---`fixed_group` of a static run, and loads that are functions of the run. Bodies that model:fix does not hold keep two.
---The solver is a direct one: it takes 0.5 s for a cubic frame of 3400 members, and 6 s for 11,000. `hinge plan` and
---summary.json list how many members got how many elements, and why. "auto" works with asi-gauss only
---@field elements_per_member? integer|"auto"
---for elements = "auto": the error that is allowed in the bending stiffness of a compressed member, as a part of the
---stiffness without compression. Near Euler's load it is the error of the load at which the member buckles. Default
---0.01
---@field elements_accuracy? number

---Makes a material: linear elastic, and perfectly plastic unless `hardening`, `rate` or `hot_curve` says more.
---```lua
---local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = 325e6 }
---local hardens = hinge.material { E = 206e9, density = 7850, yield_stress = 325e6, hardening = { tangent = 2e9 } }
---local mild = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6, rate = { D = 40.4, q = 5 } }
---```
---@param options hinge.material_options
---@return hinge.material
function hinge.material(options) end

---@class hinge.material_options
---@field E number Pa
---@field nu? number Poisson's ratio, default 0.3
---@field G? number Pa, in place of nu: default E / (2 (1 + nu))
---@field density? number kg/m^3: default 0; dynamics needs it
---@field yield_stress? number Pa: without it the material never yields
---@field hardening? hinge.hardening default none: perfectly plastic
---@field rate? hinge.rate default none
---the curved part of the stress of hot steel over its strain: what hinge.heat.curve returns. Default none: a member
---that is heated (model:heat) is elastic up to its yield stress
---@field hot_curve? number[][]

---How the stress grows beyond yield. Give `tangent` or `modulus`. Each end of an element stands for half of its length:
---with more elements a member, the plastic zone spreads as it does in the member.
---@class hinge.hardening
---slope of the stress over the strain, Pa, less than E; E / 100 is usual for steel
---@field tangent? number
---slope of the stress over the plastic strain, Pa: tangent / (1 - tangent / E)
---@field modulus? number
---part of the hardening that moves the yield surface, 0 to 1; the rest widens it. Default 1: a member that was
---stretched yields earlier when it is pressed, by as much (Bauschinger's effect)
---@field kinematic? number
---back stress that kinematic hardening comes to, Pa, along an exponential curve (Armstrong and Frederick). The curve is
---exact for steps of any length in which the flow keeps its direction. Where it turns (bending beside an axial force),
---the error goes with the length of the step, as that of all plastic flow does. Default: none, the back stress grows
---without end
---@field saturation? number

---Factor on the yield stress by the rate of the mean plastic strain of a section: Cowper and Symonds,
---1 + (rate / D)^(1/q), or Johnson and Cook, 1 + C ln(rate / reference), where ln(x) is ln(1 + x^2) / 2. Static runs
---have no rate.
---@class hinge.rate
---@field D? number 1/s; mild steel: 40.4
---@field q? number mild steel: 5
---@field C? number
---@field reference? number 1/s

---Makes a backbone: the strength of the ends of a member over their plastic rotation, as tests of beams and columns
---give it. Strengths are factors on the fully plastic resultants of the section: a moment is the factor times Mp, and
---the axial force and the torque that a section carries fall with it. The largest plastic rotation so far counts, in
---any direction: cycles within it keep the strength, unless `wear` is given. Between its ends the member has the
---greatest strength of the backbone, without a fall. So the hinge is the same with any number of elements.
---```lua
---local hinge_of_test = hinge.backbone { yield = 1.1, cap_rotation = 0.025, cap_strength = 1.2, -- over Mp, rad
---  post_cap_rotation = 0.3, residual = 0.4, ultimate_rotation = 0.4, wear = 1.2 }
---model:member { wall, tip, section = square, material = steel, backbone = hinge_of_test }
---```
---@param options hinge.backbone_options
---@return hinge.backbone
function hinge.backbone(options) end

---Either `points`, or the numbers by which models of hinges are published (Ibarra, Medina and Krawinkler 2005, as
---modified by Lignos and Krawinkler 2011).
---@class hinge.backbone_options
---pairs { plastic rotation (rad), strength }: the first at 0 rad, where the end yields; straight between two, constant
---beyond the last. Strengths of 0.01 and more
---@field points? number[][]
---@field yield? number strength at yield, over Mp: default 1
---@field cap_rotation? number plastic rotation at the greatest strength, rad
---@field cap_strength? number greatest strength, over Mp: default that at yield
---plastic rotation from the cap to where a straight fall would come to 0, rad; default: no fall
---@field post_cap_rotation? number
---where the fall ends, over the strength at yield: default 0, of which 0.01 Mp is kept. Beside `points`: the least that
---wear leaves
---@field residual? number
---plastic rotation at which the strength drops to 0.01 Mp, within 0.001 rad; default none
---@field ultimate_rotation? number
---plastic work over the moment at yield, rad, that takes all strength from an end. An excursion takes strength in its
---own direction, so that it falls by the factor sqrt(1 - E / (wear My)) with the plastic work E of all cycles, down to
---the residual strength.
---It is what is published as the reference cumulative rotation, with the exponent 1 (Lignos and Krawinkler 2011);
---default: none
---@field wear? number
---true: cycles take stiffness in unloading, too, by the same `wear`. An end of the member comes to the part
---1 - E / (wear My) of 6 EI / L, its stiffness in double curvature, where L is the member's length. That part stays
---where the strength has come to the residual one, and at 0.1. `wear` must be 5 times the rotation at which the end
---yields about its weaker axis, or more; default false: unloading is elastic
---@field stiffness_wear? boolean
---interaction of N and M of the sections that the strengths are made for: a member with another one is refused. "any"
---(default): they hold without axial force
---@field interaction? "any"|"paper"|"exact"

---@class hinge.backbone read-only
---@field points number[][] pairs { plastic rotation (rad), strength over Mp }
---@field wear number? rad
---@field stiffness_wear boolean
---@field residual number? as given, over the strength at yield
---@field interaction "any"|"paper"|"exact"

---@class hinge.material read-only
---@field E number Pa
---@field G number Pa
---@field density number kg/m^3
---@field yield_stress number Pa; infinite: never yields
---@field laws string what hardening and rate the material has, in words; "" for none
local any_material = {}

---A material that differs in its density alone: for example to spread the mass of a floor over its beams.
---```lua
---local heavy = hinge.material.steel("S355"):with { density = 12000 }
---print(heavy.density)
---```
---@param options { density: number } kg/m^3
---@return hinge.material
function any_material:with(options) end

-- Materials by their names in standards -------------------------------------------------------------------------------

---Materials by their names in standards. Upper and lower case, blanks and hyphens do not count. Yield stresses are
---characteristic or nominal values, without partial factors. lua/hinge/sections/grades.lua names the source of each
---table, and what was not confirmed. An unknown name is an error that names the nearest.
---@class hinge.materials
local material = {}

---A structural steel: S235 to S460M (EN 10025, EN 1993-1-1), A36, A572-50, A992, A500-B, A500-C (ASTM), SN400B, SN490B,
---BCR295, BCP325 (Japan), and others of hinge.material.names "steel". E is 210 GPa in EN, 200 GPa in ASTM and 205 GPa
---in Japan. Hardening and rate are those of hinge.material; default none.
---```lua
---local column = hinge.material.steel("S355", { thickness = 0.025 }) -- 345 MPa
---local beam = hinge.material.steel("A992", { expected = true }) -- 1.1 times 345 MPa
---```
---@param name string
---@param options? hinge.steel_options
---@return hinge.material
function material.steel(name, options) end

---@class hinge.steel_options
---@field hardening? hinge.hardening
---@field rate? hinge.rate
---@field hot_curve? number[][] what hinge.heat.curve returns
---thickness of the part, m: the yield stress falls with it; default: that of the thinnest parts
---@field thickness? number
---table of the yield stress: "EN 10025", "EN 1993-1-1", "ASTM" or "JIS"; default: the first of these that has the name.
---S355 has 355 MPa up to 16 mm in EN 10025, and up to 40 mm in EN 1993-1-1
---@field standard? string
---@field expected? boolean default false; true: the expected yield stress of AISC 341, Ry fy; ASTM grades alone
---@field density? number kg/m^3; default 7850

---An aluminium alloy with its temper, by EN 1999-1-1: 6082-T6, 6061-T6 and others. yield_stress is the 0.2 % proof
---stress of extruded profiles, away from welds.
---```lua
---local alloy = hinge.material.aluminium("6082-T6", { thickness = 0.004 })
---```
---@param name string
---@param options? { thickness?: number, density?: number } m, kg/m^3; default: the thinnest parts, 2700
---@return hinge.material
function material.aluminium(name, options) end

---A strength class of timber: C16 to C40, D30, D40 (EN 338), GL24h to GL32h (EN 14080). E is the mean one along the
---grain. yield_stress is the bending strength. Timber breaks in tension without yielding: give it a fracture limit.
---```lua
---local timber = hinge.material.timber "GL24h"
---```
---@param name string
---@param options? { density?: number } kg/m^3; default: the mean density of the class
---@return hinge.material
function material.timber(name, options) end

---A concrete class, C12/15 to C90/105: E by EN 1992-1-1, nu 0.2. It is elastic: cracks and crushing are not modelled.
---```lua
---local concrete = hinge.material.concrete "C30/37"
---```
---@param name string
---@param options? { density?: number } kg/m^3; default 2500
---@return hinge.material
function material.concrete(name, options) end

---Steel of reinforcing bars: B500B, Grade 60, SD345 and others.
---```lua
---local bar = hinge.material.bars "B500B"
---```
---@param name string
---@param options? { density?: number } kg/m^3; default 7850
---@return hinge.material
function material.bars(name, options) end

---The names of all grades of a kind.
---```lua
---print(table.concat(hinge.material.names "timber", ", "))
---```
---@param kind "steel"|"aluminium"|"timber"|"concrete"|"bars"
---@return string[]
function material.names(kind) end

-- Backbones by published formulas ------------------------------------------------------------------------------------

---Backbones of steel hinges by published formulas. The section is an H; its root radius, and with it h / tw, follows
---from its area. `material` is that of the member: its yield_stress is the expected one, and gives Mp, and its E gives
---the yield rotation. lua/hinge/sections/backbones.lua has the numbers, names the source of each table and says what
---was not confirmed: no standard was at hand. The formulas of a rule hold for bending about the strong axis.
---@class hinge.backbones
local backbone = {}

---Beams with reduced and with other sections, by Lignos and Krawinkler (2011): monotonic, with wear. The published
---rotations are those of the chord of a beam in double curvature, 2 shear_span long. The plastic rotation at the cap is
---less than published by the elastic one from yield to the cap, and that of the fall is more by the elastic one at the
---cap. An error names what is outside of the tests: depth / web 20 to 55, unbraced_length / ry 20 to 80,
---width / (2 flange) 4 to 8, shear_span / depth 2.5 to 7, depth 0.102 to 0.914 m, yield stress 240 to 450 MPa.
---```lua
---local w24 = hinge.section.named "W24X76"
---local a992 = hinge.material.steel("A992", { expected = true })
---local test = hinge.backbone.lignos { section = w24, material = a992, shear_span = 3.6, unbraced_length = 2.5 }
---print(test.points[2][1], test.points[2][2]) -- the cap: rad, over Mp
---```
---@param options hinge.lignos_options
---@return hinge.backbone
function backbone.lignos(options) end

---@class hinge.lignos_options
---@field section hinge.section
---@field material hinge.material
---@field shear_span number from the hinge to the point of no moment, m: half the clear span in double curvature
---@field unbraced_length number between lateral braces, m
---@field reduced? boolean true: reduced beam section (RBS); default false
---of an RBS, which must give it: depth of the cut at either side of the flanges, m, at most a quarter of the width. The
---strengths are less by the plastic modulus that is cut. 0: the member's section is the reduced one
---@field cut? number
---false: without the wear of cycles, for loads that go one way: wear takes strength from the first push on; default
---true
---@field wear? boolean
---@field stiffness_wear? boolean as of hinge.backbone_options. The published model has it; default false
---@field beyond_tests? boolean true: outside of the tests too; default false

---Beams and columns by NIST GCR 17-917-46 (2017). monotonic = true has the wear of cycles apart: that of Lignos for
---beams. monotonic = false is the envelope of the first cycles, without wear, for an analysis that counts none.
---Rotations are those of the chord, as of hinge.backbone.lignos.
---
---The moments of a column are published for its axial force. A strength f of a backbone multiplies all fully plastic
---resultants, so that a section carries the moment f m(n / f) Mp under n times its axial strength, where m is its
---interaction. The strengths returned give the published moments where n = axial_ratio: within 0.4 % between the
---published points, where points are added. Under less axial force than that the moment is greater than this one, but
---not the one published for that axial force. Under more it is less, and the column gives way where n reaches f. All
---strength, that of the axial force too, is lost at the ultimate rotation. Wear lowers f, and with it the axial
---strength. So `wear` is made larger, and the moment falls as published at first.
---```lua
---local w14 = hinge.section.named "W14X193"
---local a992 = hinge.material.steel("A992", { expected = true })
---local foot = hinge.backbone.nist { kind = "column", section = w14, material = a992, shear_span = 2,
---  unbraced_length = 4, axial_ratio = 0.3 }
---print(foot)
---```
---@param options hinge.nist_options
---@return hinge.backbone
function backbone.nist(options) end

---@class hinge.nist_options
---"beam": other than reduced sections; "RBS"; "column": an H about its strong axis; "pre-Northridge": beams whose welds
---are those before 1994, the envelope alone
---@field kind "beam"|"RBS"|"column"|"pre-Northridge"
---@field section hinge.section
---@field material hinge.material
---@field monotonic? boolean default true; false: the envelope of the first cycles
---@field shear_span number m, as of hinge.lignos_options
---@field unbraced_length? number m; only "pre-Northridge" goes without
---of a column: axial force under gravity over area times yield stress, 0 to 1; default 0
---@field axial_ratio? number
---of a column: the interaction of N and Mx by which it yields in the run; default: that of the section, else "exact"
---where its shape is known. Give "paper" where the model has interaction = "paper" and the section says none
---@field interaction? "paper"|"exact"
---@field cut? number m; of an RBS, as of hinge.lignos_options
---@field wear? boolean false: without the wear of cycles; default true where monotonic
---@field stiffness_wear? boolean as of hinge.lignos_options

---Members and connections by ASCE 41: strength falls at the plastic rotation a to the residual one, and all of it is
---lost at b. "beam": AISC 342-22, table C2.2, to which ASCE 41-23 refers. "column": table C3.6, or table 9-7.1 of ASCE
---41-17. Connections: ASCE 41-17. Up to a the slope is 3 % of the elastic one of a member in double curvature; of a
---column with more than 0.2 of its axial strength 1 %. At a the strength falls straight over a tenth of b - a, at least
---0.001 rad; at b over 0.001 rad. The backbone of a column holds at its axial_ratio, as that of hinge.backbone.nist.
---
---The second result are the limits that go with it, for run:hinges. Those of the connections and of the columns of 2017
---were not confirmed, and are nil.
---```lua
---local w24 = hinge.section.named "W24X76"
---local a992 = hinge.material.steel("A992", { expected = true })
---local ends, limits = hinge.backbone.asce41 { kind = "beam", section = w24, material = a992, length = 7.2 }
---print(ends, limits.IO, limits.LS, limits.CP) -- rad
---print(run:hinges { limit = limits })
---```
---@param options hinge.asce41_options
---@return hinge.backbone ends
---@return { IO: number, LS: number, CP: number }? limits rad
function backbone.asce41(options) end

---@class hinge.asce41_options
---@field kind "beam"|"column"|"RBS"|"free flange"|"WUF" WUF: welded unreinforced flanges before 1994
---@field section hinge.section
---@field material hinge.material
---@field length number clear length of the member, m: for the yield rotation Mp length / (6 E Ix), and length / depth
---@field unbraced_length? number m; of a column, which must give it
---@field axial_ratio? number of a column: axial force under gravity over area times yield stress; default 0
---@field interaction? "paper"|"exact" of a column, as of hinge.nist_options
---@field edition? "2017"|"2023" of a column; default "2023"
---@field cut? number m; of an RBS, as of hinge.lignos_options
---of a connection: false where continuity plates are needed and missing, 0.8 of a and b; default true. None are needed
---with a column flange of 1 / 5.2 of the beam's width and more
---@field continuity_plates? boolean
---of a connection: shear of the panel zone at yield of the beams over its strength; 0.8 of a and b outside of 0.6 to
---0.9; default: within
---@field panel_zone? number

---Connections by UFC 4-023-03, table 5-2, for the removal of a column: a and b by the depth of the beam; GSA's
---guidelines of 2016 have the same. The second result is the rotation allowed, for run:hinges: a for primary members,
---b for secondary ones. The falls at a and b are those of hinge.backbone.asce41.
---```lua
---local joint, limit = hinge.backbone.ufc { kind = "improved WUF", depth = 0.6 }
---print(joint, limit) -- rad
---```
---@param options hinge.ufc_options
---@return hinge.backbone joint
---@return number limit rad
function backbone.ufc(options) end

---@class hinge.ufc_options
---WUF: welded unreinforced flanges before 1994; "improved WUF": those since, with a bolted web
---@field kind "RBS"|"WUF"|"improved WUF"|"SidePlate"|"shear tab"
---@field depth number of the beam, m; of a shear tab that of its group of bolts
---moment at which it yields, over Mp of the member; default 1. RBS (the plastic modulus that is left) and shear tab
---must give it
---@field strength? number
---rotation at which the member yields, rad: Mp length / (6 E Ix); then the slope up to a is 3 % of the elastic one.
---Default: no slope
---@field yield_rotation? number
---@field role? "primary"|"secondary" which rotation is allowed; default "primary"

-- Grids --------------------------------------------------------------------------------------------------------------

---Makes a joint between the end of a member and its node: pinned, semi-rigid, of partial strength, or one that breaks.
---The end stays at the node until the joint breaks. Its rotation relative to the node is resisted by a moment about
---each axis of the section: x and y bend, z twists. The axes rotate with the node. Each of Mx, My and Mz is "rigid"
---(the default), "free", or a curve. Unloading is elastic, and a cycle follows Masing's rule: a branch is the curve at
---twice its scale. A joint that reaches a capacity breaks at the end of the step, in dynamics: the member's end is free
---from then on, and the energy that the joint stored is lost. Statics breaks no joint; the run warns instead. A rigid
---axis beside a free or soft one is a spring of 1e5 times 4 E I / L (bending) or G J / L (torsion) of the member in
---statics, 1000 times in dynamics, 100 times in explicit steps: a cantilever with such a joint bends about a rigid
---axis by 7.5e-6 more than without, in dynamics by 7.5e-4, in explicit steps by 7.5e-3. All members at a node may have
---joints there, as in a pinned truss. What no joint and no support holds of the node's rotation follows one of the
---members, without a moment; in explicit steps the node keeps its rotation, with the rotary inertia of half an element.
---A moment on the node about such an axis is an error. A joint needs no further element; two elements a member are as
---exact as without it. It does not go with the energy-momentum method. The energy is in run.energy.joint_stored and
---joint_dissipated. run:hinges and hinge.robustness compare the rotations and forces of joints with limits.
---```lua
---local end_plate = hinge.joint { Mx = { points = { { 0.004, 80e3 }, { 0.02, 110e3 } }, capacity = 0.04 }, -- rad, N m
---  My = "free", tension = 250e3, shear = 180e3 } -- N
---local post = model:node { 1, 0, -1 }
---model:fix(post)
---model:member { tip, post, section = square, material = steel, ends = { a = end_plate } }
---```
---@param options hinge.joint_options
---@return hinge.joint
function hinge.joint(options) end

---@class hinge.joint_options
---@field Mx? "rigid"|"free"|hinge.joint_axis moment about the section's x axis: strong-axis bending of a beam
---@field My? "rigid"|"free"|hinge.joint_axis
---@field Mz? "rigid"|"free"|hinge.joint_axis torsion
---N: it breaks at this tension along the member; default: never. The force is that of the member's end, with the
---inertia of what moves with the node
---@field tension? number
---@field shear? number N: it breaks at this force across the member; default: never
---linear: a tension T leaves the part 1 - T / tension of the strengths of Mx and My (EN 1993-1-8, 6.2.7.1 (3)). In
---dynamics T follows the force of the member with the delay of an axial wave through it, in statics with that of a
---step; compression takes nothing. It needs `tension`, and a strength of Mx or My. Default none
---@field interaction? "none"|"linear"

---Moment over the rotation of the member's end relative to the node: `stiffness`, with `strength` or without, or
---`points`.
---@class hinge.joint_axis
---@field stiffness? number N m/rad
---@field strength? number N m: elastic up to it, then plastic; default: elastic without end
---{ rotation (rad), moment (N m) } from { 0, 0 } on, which is not given. The moment rises, each part less steeply than
---the one before; beyond the last point it stays. The first point ends the elastic part
---@field points? number[][]
---@field capacity? number rad: the joint breaks at this rotation, of either sign; default: never

---@class hinge.joint

-- Joints by EN 1993-1-8 ----------------------------------------------------------------------------------------------

---Joints of steel members by EN 1993-1-8:2005, from their sizes. The sections are H; a root radius follows from the
---area. Each function returns the joint and a table of the numbers behind it. Partial factors are 1 unless they are
---given, so that strengths are characteristic ones, or expected ones with expected stresses. Welds are taken as
---stronger than what they join. In the joint of an end plate moment and tension interact; otherwise moment, tension and
---shear do not know of each other. The standard was not at hand: its formulas were confirmed by public programs, and
---results compared with published examples as said below.
---@class hinge.joints
local joint = {}

---A bolted end plate between a beam and the flange of a column without stiffeners, by the component method (6.2, 6.3,
---6.4.2). Two bolts a row; one row at most outside of the tension flange. The moment resistance has the column's flange
---and the end plate in bending (T-stubs, modes 1 to 3, tables 6.4 and 6.6), the column's web in tension, compression
---and shear, the beam's flange in compression and its web in tension, and the bolts. The stiffness is E z^2 / sum(1 /
---k) by table 6.11. The curve is elastic up to 2/3 of the resistance, and then follows 6.3.1 (6) with psi = 2.7. Prying
---is assumed, as table 6.2 allows. alpha of figure 6.11 is from equations of its curves that public programs
---have. Punching is not checked.
---Tension is that of the rows without compression; shear that of the bolts (6.2.2). The curve holds for both signs of
---the moment: it is right for that which pulls at the rows, and for both where the plate has such rows at both flanges.
---Compared with SCI P398, example C.1: rows within 0.2 %, moment 0.5 %. The stiffness is not compared with a published
---example. Errors: a web beyond d / t_w = 69 epsilon, a beam of class 3 or 4, rows or edges closer than table 3.3 has
---them.
---```lua
---local ipe, heb = hinge.section.named "IPE 360", hinge.section.named "HEB 240"
---local moment_joint, numbers = hinge.joint.end_plate {
---  beam = { section = ipe, yield_stress = 235e6 }, column = { section = heb, yield_stress = 235e6 },
---  plate = { width = 0.2, thickness = 0.012, yield_stress = 235e6, below = 0.08 },
---  bolts = { diameter = 0.02, grade = "8.8", rows = { 0.399, 0.296 }, gauge = 0.11, edge = 0.035, shear_rows = 2 },
---  welds = { flange = 0.007, web = 0.004 }, capacity = 0.035,
---}
---print(moment_joint, numbers.moment, numbers.stiffness, numbers.governs) -- N m, N m/rad
---```
---@param options hinge.end_plate_options
---@return hinge.joint joint
---@return hinge.end_plate_numbers numbers
function joint.end_plate(options) end

---@class hinge.end_plate_options
---@field beam { section: hinge.section, yield_stress: number } Pa
---weld: throat between web and flanges, m, of a section without fillets, which is taken as welded. end_distance: from
---the first row to the end of the column, m; default: far. stress: compression in its web by axial force and moment,
---Pa, which lowers the resistance from 0.7 of the yield stress on; default 0
---@field column { section: hinge.section, yield_stress: number, weld?: number, end_distance?: number, stress?: number }
---m, Pa. below: length of the plate beyond the outer face of the compression flange, which spreads compression; default
---0
---@field plate { width: number, thickness: number, yield_stress: number, below?: number }
---@field bolts hinge.end_plate_bolts
---@field welds { flange: number, web: number } throats of the fillet welds between beam and plate, m
---shear in the column's web, table 5.4: 1 (default) for a beam on one side, 0 for equal moments on both, 2 for opposite
---@field beta? number
---rad: the joint breaks at this rotation. It must be given where 6.4.2 does not say that the joint turns enough for a
---plastic analysis. Default: it does not break by rotation
---@field capacity? number
---@field interaction? "linear"|"none" of moment and tension, as in hinge.joint; default linear
---@field gamma_M0? number default 1
---@field gamma_M1? number default 1
---@field gamma_M2? number default 1

---@class hinge.end_plate_bolts
---@field diameter number m: M12, M16, M20, M22, M24, M27, M30 or M36
---@field grade "4.6"|"4.8"|"5.6"|"5.8"|"6.8"|"8.8"|"10.9"
---distances of the rows in tension from the middle of the compression flange, m
---@field rows number[]
---@field gauge number m, between the two bolts of a row
---@field edge? number m, from a row outside of the tension flange to the plate's end; such a row must give it
---@field head? number m: width of head or washer; then mode 1 is by the alternative of table 6.2
---@field length? number m: elongation length; default: the plates, a washer, half of head and nut
---@field shear_rows? integer rows that carry shear alone; default 0. Bolts in tension keep 0.4 / 1.4 of their shear
---@field shank? boolean true: no thread in the shear plane; default false

---@class hinge.end_plate_numbers
---@field moment number N m, resistance
---@field stiffness number N m/rad, S_j,ini
---@field lever_arm number m, z of the stiffness
---@field governs string component that limits the moment
---@field ductile boolean whether 6.4.2 says that it turns enough for a plastic analysis
---@field ductility string why
---each row from the top: distance (m), potential (N, alone), force (N, in the joint), governs, components
---(column_flange, column_web, end_plate, beam_web: resistance, and m, n, lengths, modes, mode or width), k3, k4, k5,
---k10, k_eff (m)
---@field rows table[]
---@field groups table[] from, to, resistance (N), governs, components
---column_web, beam_flange, panel, column_shear (N), width (m), omega, rho, k_wc, slenderness
---@field compression table
---@field coefficients { k1: number, k2: number, k_eq: number, bolt_length: number } m
---@field alpha number? of figure 6.11
---@field points number[][] of the curve: rad, N m
---@field tension number N
---@field shear number N
---@field capacity number? rad
---@field bolt table d, d0 (m), As (m^2), fub, fyb (Pa), tension and shear of one (N), head, nut, washer (m)

---A plate on the column, bolted to the web of a beam with its full section: nearly a pin. Shear is the least of bolts,
---bearing, the plate's gross and net shear, its bending and sideways buckling, and the beam's web, with blocks (EN
---1993-1-8, tables 3.3 and 3.4, 3.10.2); tension the least of those in tying, with ultimate stresses. The group of
---bolts, a long plate and tying are as in Steel buildings in Europe, part 5 (2009), and SCI P358 (2011). The end
---breaks, unless `capacity` says otherwise, at the rotation at which a flange of the beam meets the column. My is free.
---Neither weld nor column is checked. Compared with example 3.4 of Steel buildings in Europe, part 5: 1 % (the block of
---the web is 3 % less: holes are taken off to the middle of the last one), and with two blocks of Wald (Brussels 2014).
---```lua
---local ipe = hinge.section.named "IPE 360"
---local pin, numbers = hinge.joint.fin_plate {
---  beam = { section = ipe, yield_stress = 235e6, ultimate_stress = 360e6, edge = 0.04, top = 0.11 },
---  plate = { depth = 0.22, thickness = 0.01, yield_stress = 235e6, ultimate_stress = 360e6, edge = 0.05 },
---  bolts = { diameter = 0.02, grade = "8.8", rows = 3, pitch = 0.07 }, gap = 0.01,
---}
---print(pin, numbers.shear, numbers.governs_shear, numbers.tension, numbers.contact) -- N, N, rad
---```
---@param options hinge.fin_plate_options
---@return hinge.joint joint
---@return hinge.fin_plate_numbers numbers
function joint.fin_plate(options) end

---@class hinge.fin_plate_options
---edge: from the nearest line of bolts to the end of the beam, m; top: from the first bolt to the beam's top, m
---@field beam { section: hinge.section, yield_stress: number, ultimate_stress: number, edge: number, top: number }
---edge: from the farthest line of bolts to the free side of the plate, m. The bolts are in the middle of its depth
---@field plate { depth: number, thickness: number, yield_stress: number, ultimate_stress: number, edge: number }
---@field bolts hinge.fin_plate_bolts
---@field gap number m, from the end of the beam to the column
---@field stiffness? number N m/rad about the strong axis; default 1000
---@field capacity? number rad; default: the rotation at which a flange meets the column
---@field gamma_M0? number default 1
---@field gamma_M1? number default 1
---@field gamma_M2? number default 1
---@field gamma_Mu? number of tying; default 1

---@class hinge.fin_plate_bolts
---@field diameter number m: M12, M16, M20, M22, M24, M27, M30 or M36
---@field grade "4.6"|"4.8"|"5.6"|"5.8"|"6.8"|"8.8"|"10.9"
---@field rows integer bolts above each other
---@field lines? 1|2 default 1
---@field pitch? number m, between rows
---@field gauge? number m, between lines
---@field shank? boolean true: no thread in the shear plane; default false

---@class hinge.fin_plate_numbers
---@field shear number N
---@field governs_shear string
---@field shear_of table<string, number> N, by what could fail
---@field tension number N
---@field governs_tension string
---@field tension_of table<string, number> N
---@field contact number? rad: a flange of the beam meets the column
---@field capacity number rad
---@field lever_arm number m, from the column to the middle of the bolts
---@field buckling_stress number? Pa, of a long plate: lever_arm beyond thickness / 0.15
---@field bolt table as of hinge.end_plate_numbers

---Two angles, bolted to the web of a beam with its full section and to a column: nearly a pin. Each row has one bolt in
---each leg at the column, at the height of its bolts in the beam's web. Shear is the least of the bolts at the web (in
---double shear) and at the column (in single shear, less a fifth since they are pulled too), bearing, the angles' gross
---and net shear, their bending and blocks, and the beam's web. Tension is the least of those in tying, with ultimate
---stresses; the legs at the column bend like T-stubs (table 6.2). As in Steel buildings in Europe, part 5 (2009). The
---end breaks, unless `capacity` says otherwise, at the rotation at which a flange of the beam meets the column. My is
---free. The column is not checked. Compared with example 4.4 of that publication: 1 %.
---```lua
---local ipe = hinge.section.named "IPE 360"
---local pin, numbers = hinge.joint.web_cleats {
---  beam = { section = ipe, yield_stress = 235e6, ultimate_stress = 360e6, edge = 0.04, top = 0.11 },
---  cleats = { depth = 0.22, thickness = 0.01, r = 0.011, yield_stress = 235e6, ultimate_stress = 360e6, edge = 0.04,
---    column_edge = 0.04, column_gauge = 0.11 },
---  bolts = { diameter = 0.02, grade = "8.8", rows = 3, pitch = 0.07 }, gap = 0.01,
---}
---print(pin, numbers.shear, numbers.governs_shear, numbers.tension, numbers.contact) -- N, N, rad
---```
---@param options hinge.web_cleats_options
---@return hinge.joint joint
---@return hinge.web_cleats_numbers numbers
function joint.web_cleats(options) end

---@class hinge.web_cleats_options
---edge: from the nearest line of bolts to the end of the beam, m; top: from the first bolt to the beam's top, m
---@field beam { section: hinge.section, yield_stress: number, ultimate_stress: number, edge: number, top: number }
---@field cleats hinge.web_cleats_angles
---@field bolts hinge.web_cleats_bolts
---@field gap number m, from the end of the beam to the column
---@field stiffness? number N m/rad about the strong axis; default 1000
---@field capacity? number rad; default: the rotation at which a flange meets the column
---@field gamma_M0? number default 1
---@field gamma_M2? number default 1
---@field gamma_Mu? number of tying; default 1

---@class hinge.web_cleats_angles
---@field depth number m, along the beam's depth. The bolts are in its middle
---@field thickness number m
---@field r number m, root radius
---@field yield_stress number Pa
---@field ultimate_stress number Pa
---@field edge number m, from the farthest line of bolts in the beam's web to the free side of that leg
---@field column_edge number m, from the bolts at the column to the free side of that leg
---@field column_gauge number m, between the bolts at the column, across the web

---@class hinge.web_cleats_bolts
---@field diameter number m: M12, M16, M20, M22, M24, M27, M30 or M36
---@field grade "4.6"|"4.8"|"5.6"|"5.8"|"6.8"|"8.8"|"10.9"
---@field rows integer bolts above each other
---@field lines? 1|2 default 1
---@field pitch? number m, between rows
---@field gauge? number m, between lines
---@field shank? boolean true: no thread in the shear plane; default false
---@field head? number m: width of head or washer; then mode 1 of the legs is by the alternative of table 6.2

---@class hinge.web_cleats_numbers
---@field shear number N
---@field governs_shear string
---@field shear_of table<string, number> N, by what could fail
---@field tension number N
---@field governs_tension string
---@field tension_of table<string, number> N
---@field legs table those at the column, as T-stubs: m, n (m), lengths, modes (N), mode, resistance (N)
---@field contact number? rad: a flange of the beam meets the column
---@field capacity number rad
---@field lever_arm number m, from the column to the middle of the bolts in the beam's web
---@field bolt table as of hinge.end_plate_numbers

---The base of an H column with a row of two anchor bolts outside of each flange, bent about its strong axis under a
---given compression: 6.2.5, 6.2.8 and 6.3.4. The concrete bears under the flanges; the plate and the bolts pull as
---T-stubs, with prying or without it by table 6.2. Moment and stiffness are those at `axial`, and stay where the axial
---force of the run is another one. Shear is that of friction, 0.2 `axial`, and four bolts (6.2.2). Compared with Wald's
---example (Brussels 2014): bearing stress, width and axial resistance within 0.3 %. Moment and stiffness are not
---compared with a published example.
---```lua
---local heb = hinge.section.named "HEB 240"
---local base, numbers = hinge.joint.base_plate {
---  column = { section = heb, yield_stress = 235e6 },
---  plate = { length = 0.44, width = 0.34, thickness = 0.03, yield_stress = 235e6 },
---  bolts = { diameter = 0.024, grade = "8.8", outside = 0.05, gauge = 0.2 },
---  concrete = { strength = 25e6, spread = 1.5, grout = 0.03 }, weld = 5e-3, axial = 400e3, capacity = 0.05,
---}
---print(base, numbers.moment, numbers.stiffness, numbers.governs) -- N m, N m/rad
---```
---@param options hinge.base_plate_options
---@return hinge.joint joint
---@return hinge.base_plate_numbers numbers
function joint.base_plate(options) end

---@class hinge.base_plate_options
---@field column { section: hinge.section, yield_stress: number }
---length: along the column's depth; m, Pa
---@field plate { length: number, width: number, thickness: number, yield_stress: number }
---outside: from a row to the outer face of the column's flange, m. length: elongation length, m; default 8 diameters,
---the grout, the plate, a washer and half of the nut. anchorage: N that the concrete holds of one bolt; default: more
---than the bolt
---@field bolts { diameter: number, grade: string, outside: number, gauge: number, length?: number, anchorage?: number }
---strength: f_ck, Pa; spread: alpha, 1 (default) to 3; joint_factor: beta_j, default 2/3; grout: its thickness, m,
---default 0; E: Pa, default that of EN 1992-1-1
---@field concrete { strength: number, spread?: number, joint_factor?: number, grout?: number, E?: number }
---@field weld number throat at the flanges, m
---@field axial number N, compression of 0 or more
---@field capacity number rad: it breaks at this rotation; EN 1993-1-8 says nothing of it
---@field gamma_M0? number default 1
---@field gamma_M2? number default 1
---@field gamma_c? number default 1

---@class hinge.base_plate_numbers
---@field moment number N m
---@field stiffness number N m/rad, S_j,ini
---@field governs string
---@field lever_arm number m
---@field axial number N that the concrete holds in compression alone
---@field compression table bearing_stress (Pa), reach, width, length (m), area (m^2), concrete, flange, resistance (N)
---@field tension_row table resistance (N), m, n, lengths, modes, mode, prying, k15, k16, bolt_length (m)
---@field k13 number m
---@field points number[][] of the curve: rad, N m
---@field tension number N
---@field shear number N
---@field capacity number rad
---@field bolt table as of hinge.end_plate_numbers

---The panel zone of a column, in shear between the flanges of beams: for model:joint, between a node of the columns and
---one of the beams. Three straight lines, by Krawinkler (1978): V_y = 0.55 f_y d_c t at the distortion V_y / (0.95 d_c
---t G); up to four times that distortion the column's flanges bend as well, with 0.95 G b_c t_cf^2 / d_b; then the
---shear stays, or hardens (Gupta and Krawinkler 1999 take 0.03). The moment is that of the beams at the middle of the
---joint, V d_b / (1 - d_b / H), where a storey height H is given; without it the shear of the column is not taken off.
---AISC 360, J10-11, has the same form with 0.6 in the place of 0.55. The axial force of the column counts for nothing;
---beyond 0.75 of its yield force AISC 360 reduces the strength. The distortion is not in the size of the node: members
---reach its middle.
---```lua
---local heb = hinge.section.named "HEB 300"
---local panel, numbers = hinge.joint.panel_zone { column = { section = heb, yield_stress = 235e6 }, beam_depth = 0.45 }
---print(panel, numbers.moment, numbers.stiffness) -- N m, N m/rad
---```
---@param options hinge.panel_zone_options
---@return hinge.joint joint its Mx is the panel's moment
---@return hinge.panel_zone_numbers numbers
function joint.panel_zone(options) end

---@class hinge.panel_zone_options
---@field column { section: hinge.section, yield_stress: number } an H; Pa
---@field beam_depth number m, of the deeper beam
---@field doubler? number m, thickness of plates on the web; default 0
---@field storey_height? number m, between the points where columns have no moment; default: far
---@field hardening? number slope beyond the last point over that of the elastic part; default 0
---@field capacity? number rad: it breaks at this distortion; default: never

---@class hinge.panel_zone_numbers
---@field thickness number m
---@field shear number N, at yield
---@field distortion number rad, at yield
---@field flanges number N that the column's flanges add, up to four times that distortion
---@field full_shear number N, both
---@field lever_arm number m: moment over shear
---@field stiffness number N m/rad
---@field moment number N m, with the flanges
---@field points number[][] of the curve: rad, N m
---@field capacity number? rad

---A frame by the lines of its plan and by its storeys. It makes a node where the lines meet at each level. Column lines
---are called A, B, ... along x and 1, 2, ... along y, and level 0 is the base: "B2, storey 1", "B2, base". A node that
---the model has at such a place already is used.
---```lua
---local grid = hinge.grid { model = hinge.model(), x = { 0, 6, 12 }, y = { 0, 5 }, z = { 0, 4, 7.5 } }
---grid:fix "all"
---grid:defaults { section = square, material = steel }
---grid:columns { group = "columns" }
---grid:beams { along = "x", group = "beams" }
---print(grid:node("B2", 1).z) -- 4
---```
---@param options hinge.grid_options
---@return hinge.grid
function hinge.grid(options) end

---@class hinge.grid_options
---@field model hinge.model
---m, positions that rise; or { count = spaces, spacing = m, from = m (default 0) }
---@field x number[]|hinge.grid_spacing
---@field y? number[]|hinge.grid_spacing default: { 0 }, a plane frame
---@field z number[]|hinge.grid_spacing m, levels: the base and the storeys

---@class hinge.grid_spacing
---@field count integer
---@field spacing number m
---@field from? number m, default 0

---@class hinge.grid
---@field model hinge.model
---@field storeys integer number of storeys
local grid = {}

---The node at a place: "B2, storey 1", "B2, base", or a line and a storey.
---```lua
---print(plan:node "A1, base" == plan:node("A1", 0)) -- true
---```
---@param place string
---@param storey? integer 0: the base
---@return hinge.node
function grid:node(place, storey) end

---The name of a node of the grid.
---```lua
---print(plan:name(plan:node("B1", 1))) -- B1, storey 1
---```
---@param node hinge.node
---@return string
function grid:name(node) end

---The names of the column lines.
---```lua
---print(#plan:lines()) -- 2
---```
---@return string[]
function grid:lines() end

---Fixes all nodes of a level, as model:fix does.
---```lua
---plan:fix "all"
---plan:fix("y", 1)
---```
---@param what string
---@param storey? integer default 0: the base
---@return hinge.grid self
function grid:fix(what, storey) end

---What members of the grid have where the call that makes them does not give it. With `group`: members whose first
---group it is; these go before those without.
---```lua
---plan:defaults { material = steel, elements = 4 }
---plan:defaults { group = "columns", section = square, up = { 1, 0, 0 } }
---```
---@param options hinge.grid_members
---@return hinge.grid self
function grid:defaults(options) end

---Fields of model:member, each of them optional here.
---@class hinge.grid_members
---@field section? hinge.section
---@field material? hinge.material
---@field up? vec3
---@field group? string|hinge.group|(string|hinge.group)[]
---@field elements? integer|"auto"
---@field backbone? hinge.backbone|fun(largest: number, x: number, y: number, work: number): number
---@field law? hinge.section_law|fun(flow: hinge.section_flow, history: number[]): number, number[]?, number[]?
---@field carries? "both"|"tension"|"compression"
---@field ends? { a?: hinge.joint, b?: hinge.joint }
---@field release? { a?: string|string[], b?: string|string[] }
---@field offset? { a?: vec3, b?: vec3 }

---Columns between the levels, storey by storey.
---```lua
---plan:columns { section = square, material = steel, at = { "A1" }, storeys = { 1 } }
---```
---@param options hinge.grid_columns
---@return hinge.member[]
function grid:columns(options) end

---@class hinge.grid_columns
---@field at? string[] column lines; default: all
---@field storeys? integer[] default: all
---@field section? hinge.section
---@field material? hinge.material
---@field up? vec3
---@field group? string|hinge.group|(string|hinge.group)[]
---@field elements? integer|"auto"
---@field backbone? hinge.backbone|fun(largest: number, x: number, y: number, work: number): number
---@field law? hinge.section_law|fun(flow: hinge.section_flow, history: number[]): number, number[]?, number[]?
---@field carries? "both"|"tension"|"compression"
---@field ends? { a?: hinge.joint, b?: hinge.joint }
---@field release? { a?: string|string[], b?: string|string[] }
---@field offset? { a?: vec3, b?: vec3 }

---Beams between neighbouring columns at the top of storeys.
---```lua
---plan:beams { along = "x", section = square, material = steel, at = { "1" } }
---```
---@param options hinge.grid_beams
---@return hinge.member[]
function grid:beams(options) end

---@class hinge.grid_beams
---@field along "x"|"y"
---lines of the plan: "1", "2", ... for beams along x, "A", "B", ... for those along y; default: all
---@field at? string[]
---@field storeys? integer[] default: all
---@field section? hinge.section
---@field material? hinge.material
---@field up? vec3
---@field group? string|hinge.group|(string|hinge.group)[]
---@field elements? integer|"auto"
---@field backbone? hinge.backbone|fun(largest: number, x: number, y: number, work: number): number
---@field law? hinge.section_law|fun(flow: hinge.section_flow, history: number[]): number, number[]?, number[]?
---@field carries? "both"|"tension"|"compression"
---@field ends? { a?: hinge.joint, b?: hinge.joint }
---@field release? { a?: string|string[], b?: string|string[] }
---@field offset? { a?: vec3, b?: vec3 }

---Braces between two column lines, in each storey: "/" from the foot of the first line to the head of the second, "\\"
---the other way, "X" both, which do not meet.
---```lua
---plan:braces { from = "A1", to = "B1", shape = "X", section = square, material = steel, carries = "tension" }
---```
---@param options hinge.grid_braces
---@return hinge.member[]
function grid:braces(options) end

---@class hinge.grid_braces
---@field from string a column line
---@field to string another one
---@field shape? "/"|"\\"|"X" default "/"
---@field storeys? integer[] default: all
---@field section? hinge.section
---@field material? hinge.material
---@field up? vec3
---@field group? string|hinge.group|(string|hinge.group)[]
---@field elements? integer|"auto"
---@field backbone? hinge.backbone|fun(largest: number, x: number, y: number, work: number): number
---@field law? hinge.section_law|fun(flow: hinge.section_flow, history: number[]): number, number[]?, number[]?
---@field carries? "both"|"tension"|"compression"
---@field ends? { a?: hinge.joint, b?: hinge.joint }
---@field release? { a?: string|string[], b?: string|string[] }
---@field offset? { a?: vec3, b?: vec3 }

---Members through several nodes, one after the other: nodes, or names of places, and what the members have.
---```lua
---plan:line { "A1, base", "A1, storey 1", "B1, storey 1", section = square, material = steel }
---```
---@param options hinge.grid_members
---@return hinge.member[]
function grid:line(options) end

---Copies members to another place, or as in a mirror. Nodes that are there are used; new ones are fixed as theirs are.
---The copy has their section, material, groups, elements, backbone and direction, where it is not given another.
---```lua
---local bay = plan:columns { section = square, material = steel }
---plan:copy { members = bay, by = { 0, 5, 0 } }
---plan:copy { members = bay, mirror = { x = 20 }, group = "other half" }
---```
---@param options hinge.grid_copy
---@return hinge.member[]
function grid:copy(options) end

---@class hinge.grid_copy
---@field members hinge.member[]
---@field by? vec3 m; one of by and mirror
---@field mirror? { x?: number, y?: number, z?: number } m, the plane of the mirror: one of the three
---@field section? hinge.section
---@field material? hinge.material
---@field up? vec3
---@field group? string|hinge.group|(string|hinge.group)[]
---@field elements? integer|"auto"
---@field backbone? hinge.backbone|fun(largest: number, x: number, y: number, work: number): number
---@field law? hinge.section_law|fun(flow: hinge.section_flow, history: number[]): number, number[]?, number[]?
---@field carries? "both"|"tension"|"compression"
---@field ends? { a?: hinge.joint, b?: hinge.joint }
---@field release? { a?: string|string[], b?: string|string[] }
---@field offset? { a?: vec3, b?: vec3 }

-- Blast --------------------------------------------------------------------------------------------------------------

---Makes the load combinations of a standard from load cases, and declares them by model:combination. Each variable
---action leads in turn, and the others accompany it. A load that helps is absent: every set of variable actions is
---there, and permanent ones have both of their factors. Combinations with the same factors are declared once, also over
---several calls. `loads` of a run takes them by name, such as "ULS 1.35 dead + 1.5 office". In a name, permanent cases
---that have one factor are written as G, or D in ASCE 7. Loads and gravity that belong to no case act in every run with
---the factor 1. No standard was at hand: lua/hinge/actions/combinations.lua names the source of each table, and what
---was not confirmed. Wrong input is an error, and nothing is declared.
---```lua
---local house = hinge.model()
---for _, name in ipairs { "dead", "office", "snow", "wind" } do house:case(name) end
---local list = hinge.combinations { model = house, standard = "EN 1990", kind = "ULS", cases = { dead = "G",
---  office = { "Q", category = "B" }, snow = { "S", altitude = 500 }, wind = "W" } }
---print(list) -- a table with the factors
---for _, one in ipairs(list) do print(one.name, one.rule, one.factors.office) end
---```
---@param options hinge.combinations_options
---@return hinge.combination_list
function hinge.combinations(options) end

---@class hinge.combinations_options
---@field model hinge.model
---@field standard "EN 1990"|"ASCE 7-16"|"ASCE 7-22"
---EN 1990: "ULS" (6.10), "SLS characteristic" (6.14b), "SLS frequent" (6.15b), "SLS quasi-permanent" (6.16b),
---"accidental" (6.11b), "seismic" (6.12b). ASCE 7: "LRFD" (2.3.1), "ASD" (2.4.1), "seismic LRFD" (2.3.6), "seismic ASD"
---(2.4.5), and in 7-16 "extraordinary" (2.5.2.1), "residual capacity" (2.5.2.2, after the event)
---@field kind string
---the load cases by name, each as a type, or { type, more = fields }, see hinge.combination_case
---@field cases table<string, string|hinge.combination_case>
---true (default): with all sets in which loads are absent. false: without combinations that are a part of another one
---with the same factors
---@field omit? boolean
---@field expression? "6.10"|"6.10a/b" of "ULS"; default "6.10"
---@field gamma_G? number of "ULS": unfavourable permanent actions, default 1.35
---@field gamma_G_inf? number of "ULS": favourable permanent actions, default 1
---@field gamma_Q? number of "ULS": default 1.5
---@field xi? number of "ULS", in 6.10b: default 0.85
---@field K_FI? number of "ULS": factor of the consequence class on unfavourable actions, default 1
---@field leading? "psi_1"|"psi_2" of "accidental": the factor of the leading action; default "psi_1"
---@field live? number of "LRFD" and "seismic LRFD": the factor 1 of L, which may be 0.5 for most uses; default 1
---seismic kinds: each earthquake acts with this part of the others, such as 0.3; default: each acts by itself
---@field orthogonal? number
---@field S_DS? number g, needed for seismic kinds of ASCE 7: 0.2 S_DS D is the vertical part
---@field rho? number 1 to 1.3, needed for seismic kinds of ASCE 7: redundancy factor

---@class hinge.combination_case
---EN 1990: G permanent, Q imposed, S snow, W wind, T temperature, A accidental, E seismic. ASCE 7: D, L, Lr, S, R, W,
---A, E
---@field [1] string
---@field category? "A"|"B"|"C"|"D"|"E"|"F"|"G"|"H" of Q, needed without psi: its row in table A1.1
---of S, m, needed without psi and region: above 1000 m psi is larger
---@field altitude? number
---@field region? "north"|"other" of S: "north" is Finland, Iceland, Norway and Sweden; default "other"
---@field psi? number[] of Q, S, W and T: psi_0, psi_1 and psi_2, in place of table A1.1
---of Q, S, W and T: cases with the same name are parts of one action, which lead together. Default: one action for each
---type, and for each category of Q
---@field action? string
---@field source? string of G: cases of one source have one factor; default: all are of one source
---cases with the same name never act together. Default: those of each type S, W, T, R and A exclude each other; false:
---they do not
---@field alternative? string|false
---@field both_signs? boolean of E: also with the factor -1; default true

---A list of combinations. print shows it as a table.
---@class hinge.combination_list
---@field [integer] hinge.combination_row
---@field standard string
---@field kind string
---@field cases string[] names of the cases that are in them
---@field left_out string[] names of the load cases of the model that are in none of them
local combination_list = {}

---@class hinge.combination_row
---@field name string
---@field factors table<string, number>
---@field rule string such as "EN 1990 (6.10)"

---The list as a table of text: a line for each combination, a column for each case.
---```lua
---model:case "dead"
---local list = hinge.combinations { model = model, standard = "ASCE 7-22", kind = "LRFD", cases = { dead = "D" } }
---print(list:table())
---```
---@return string
function combination_list:table() end

---Puts a pressure on a rectangular area between members, or on a face of them, as loads on the members. One way: beams
---across the span carry half of the distance to the next beam on each side. Two way: the beams on all four edges carry
---what is nearest to them, triangles and trapezoids with slopes of 45 degrees. A member may be longer than the area,
---and an edge may be a chain of members. On a face each member carries its width. A load that is linear along a whole
---member is one load `q`. Others are three point loads for each eighth of it: end forces are exact, moments between the
---ends are off by up to 0.5 % of the end moment of a clamped beam. The total is area times pressure to 1e-12. Openings
---are refused. Wrong input is an error, and nothing is loaded.
---```lua
---local floor, n = hinge.model(), {}
---for i, at in ipairs { { 0, 0 }, { 6, 0 }, { 6, 4 }, { 0, 4 } } do n[i] = floor:node { at[1], at[2], 3 } end
---floor:fix(n)
---for i = 1, 4 do floor:member { n[i], n[i % 4 + 1], section = square, material = steel, group = "beams" } end
---local result = hinge.pressure { model = floor, group = "beams", value = 3e3, direction = { 0, 0, -1 },
---  spread = "two way", on = { { 0, 0, 3 }, { 6, 0, 3 }, { 6, 4, 3 }, { 0, 4, 3 } } }
---print(result, result.parts[1].area) -- 24 m^2 and 72 kN on 4 members, 8 m^2
---hinge.pressure { model = model, members = { beam }, on = { 0, 0, 1 }, value = 700, width = 0.05 } -- a face
---```
---@param options hinge.pressure_options
---@return hinge.pressure_result
function hinge.pressure(options) end

---@class hinge.pressure_options
---@field model hinge.model
---the members that may carry the area, or that carry the face; give either members or group. Members that do not lie on
---the area are passed over
---@field members? hinge.member[]
---@field group? hinge.group_like
---the four corners of a rectangle in their order (m), or the direction out of a face, of any length above 0, 84 to 90
---degrees from the axis of each member
---@field on vec3[]|vec3
---@field value number|fun(x: number, y: number, z: number): number Pa, per area of the surface itself
---where the pressure pushes, of any length above 0; needed for an area. Default on a face: against its normal
---@field direction? vec3
---@field spread? "one way"|"two way" needed for an area
---one way: the direction in which the area spans from beam to beam, parallel to an edge. Needed if members lie along
---both directions
---@field span? vec3
---@field width? number|fun(member: hinge.member): number m, needed for a face
---@field case? hinge.case|string the load case, see model:case; default: none
---@field history? fun(time: number): number|number[][] factor over time, as in model:load; default 1

---print shows it as a line.
---@class hinge.pressure_result
---@field area number m^2
---@field total number N, along `direction`
---@field force vec3 N
---@field parts { member: hinge.member, area: number, force: number }[] m^2 and N of each member

---Lets axles move along a line of members at a constant speed, in dynamic runs. Each member has `parts` places. A force
---between two places is divided between both by the lever rule; a place within a member is a point load with its exact
---end forces. Before and after the line an axle does not act. The forces have no mass and no springs: the vehicle must
---be light beside the structure. They act in every dynamic run; static runs leave them out. On a simple beam of four
---members the sag is within 0.2 % of the closed form with mass = "cubic". An axle should take several steps from place
---to place. Wrong input is an error, and nothing is loaded.
---```lua
---local lorry = hinge.moving_load { model = model, members = { beam }, from = wall, speed = 20,
---  axles = { { force = 300 }, { force = 500, distance = 0.4 } } }
---local crossing = model:dynamic { dt = 1e-4, duration = lorry.leaves }:finish()
---print(lorry, lorry:positions(0.03)[1], crossing.verdict) -- the first axle at 0.6 m
---```
---@param options hinge.moving_load_options
---@return hinge.moving_load
function hinge.moving_load(options) end

---@class hinge.moving_load_options
---@field model hinge.model
---the members in their order along the line, each beginning where the one before ends; give either members or group
---@field members? hinge.member[]
---@field group? hinge.group_like its members in the order in which they were declared
---where the line begins; needed only for a single member that is crossed from its second end
---@field from? hinge.node
---@field axles { force: number, distance?: number }[] N, and m behind the first axle
---@field speed number m/s
---@field start? number s, time of the run at which the first axle comes onto the line; default 0
---@field direction? vec3 of the forces, of any length above 0; default { 0, 0, -1 }
---@field parts? integer places on each member; default 10

---@class hinge.moving_load read-only
---@field axles { force: number, distance: number }[]
---@field length number m, of the line
---@field speed number m/s
---@field start number s
---@field leaves number s, when the last axle leaves the line
---@field places integer
local any_moving = {}

---Where the axles are.
---```lua
---local lorry = hinge.moving_load { model = model, members = { beam }, speed = 20, axles = { { force = 300 } } }
---print(lorry:positions(0.02)[1]) -- 0.4 m
---```
---@param time number s, of the run
---@return (number|false)[] positions m from the beginning of the line; false: not on it
function any_moving:positions(time) end

---@class hinge.moving_loads
local moving_load = {}

---Influence lines: a static run for each position of a force on a line of members. A value of a line is the change of
---what `read` returns, by 1 N. For linear models: small displacement, and nothing yields. Each position becomes a load
---case of the model, "influence line 1, 1" and so on, so that later runs of this model must say in `loads` what acts.
---```lua
---local small = hinge.model { displacement = "small" }
---local left, right = small:node { 0, 0, 0 }, small:node { 6, 0, 0 }
---small:fix(left, "x,y,z,rx,rz")
---small:fix(right, "y,z,rx,rz")
---local span = small:member { left, right, section = square, material = steel, up = { 0, 0, 1 } }
---local line = hinge.moving_load.influence { model = small, members = { span }, parts = 6, read = function(state)
---  return select(3, left:reaction(state))
---end }.value
---for i, x in ipairs(line.x) do print(x, line.y[i]) end -- 1 at 0 m, 0 at 6 m
---```
---@param options hinge.influence_options
---@return hinge.influence_lines
function moving_load.influence(options) end

---@class hinge.influence_options
---@field model hinge.model
---@field members? hinge.member[] as in hinge.moving_load_options
---@field group? hinge.group_like
---@field from? hinge.node
---@field read fun(run: hinge.run): number|table<string, number> one value, or several by name
---@field parts? integer places on each member; default 10
---@field positions? number[] m from the beginning of the line, rising, in place of parts
---@field force? number N, of the force that moves; default 1
---@field direction? vec3 of the force; default { 0, 0, -1 }
---@field loads? table<string|hinge.case, number> load cases that act beside it; default {}
---@field steps? integer steps of each static run; default 1

---Lines by the names that `read` gives; a single value is the line "value". Each is a curve for hinge.plot.
---@class hinge.influence_lines
---@field positions number[] m
---@field [string] { name: string, x: number[], y: number[] }

---An explosion on the ground: the pressure that it puts on faces, and loads on members. The values are those of
---Kingery and Bulmash (1984) for hemispherical charges of TNT on the ground, by the fits of Swisdak (1994, ADA526744).
---The fits depend on the scaled distance Z = R / W^(1/3): R is the distance from the charge in m, W the charge in kg.
---Each value has its own range of Z, see hinge.blast_parameters; outside of it the value is an error. Not included are
---clearing, the negative phase, reflection between buildings, fragments, and charges above the ground.
---```lua
---local explosion = hinge.blast { charge = 10000, at = { 0, 0, 0 } }
---local there = explosion:parameters(500)
---print(there.arrival, there.incident_pressure, there.reflected_pressure) -- 1.276 s, 5055 Pa, 10245 Pa
---```
---@param options hinge.blast_options
---@return hinge.explosion
function hinge.blast(options) end

---@class hinge.blast_options
---@field charge number kg of TNT, above 0
---@field at vec3 m, the point on the ground where the charge is
---"surface": a hemispherical charge on the ground. Other kinds are refused. Default "surface"
---@field kind? "surface"
---the pressure over time. friedlander (default): P (1 - t/d) exp(-b t/d), with the b that gives the impulse. triangle:
---the same peak P and the same impulse i, along a straight line that ends after 2 i / P
---@field shape? "friedlander"|"triangle"
---@field start? number s, the time of the explosion in the run; default 0
---@field negative? boolean the negative phase; only false is there. Default false

---What hinge.blast returns.
---@class hinge.explosion
---@field charge number kg of TNT
---@field at vec3 m
---@field kind "surface"
---@field shape "friedlander"|"triangle"
---@field start number s
---@field negative boolean false
local explosion = {}

---Values of the blast wave at a distance from the charge, or at a point. A value whose range of Z does not reach there
---is an error when it is read. It is an error at once where no value is known: below 0.06 and above 198.5 m/kg^(1/3).
---```lua
---local explosion = hinge.blast { charge = 500, at = { -20, 0, 0 } }
---local there = explosion:parameters { 0, 0, 3 }
---print(there.Z, there.duration, there.reflected_impulse) -- m/kg^(1/3), s, Pa s
---print(explosion:parameters(400).incident_pressure) -- Pa, at Z = 50; reflected_pressure would be an error there
---```
---@param place number|vec3 distance in m, above 0, or a point in m
---@return hinge.blast_parameters
function explosion:parameters(place) end

---Overpressures, and impulses of the positive phase. The ranges of Z are in m/kg^(1/3).
---@class hinge.blast_parameters
---@field distance number m, from the charge
---@field Z number m/kg^(1/3), the scaled distance
---@field arrival number s, from the explosion to the arrival of the wave; Z from 0.06 to 40
---@field incident_pressure number Pa, peak on a face that the wave passes along; Z from 0.2 to 198.5
---@field reflected_pressure number Pa, peak on a face that the wave meets head-on; Z from 0.06 to 40
---@field duration number s, of the positive phase; Z from 0.2 to 40
---@field incident_impulse number Pa s; Z from 0.2 to 158.7
---@field reflected_impulse number Pa s; Z from 0.06 to 40
---@field incident_decay number b of Friedlander's pulse with the incident peak and impulse; Z from 0.2 to 40
---@field reflected_decay number the same of the reflected ones; Z from 0.2 to 40

---Pressure on a small face. Up to an angle of 90 degrees between its normal and the line to the charge it is
---p_reflected c^2 + p_incident (1 + c - 2 c^2), where c is the cosine of the angle. Two programs have ConWep's formula
---in this form; its report (Randers-Pehrson and Bannister 1997) was not at hand. A face that is turned away has the
---incident pressure. Z from 0.2 to 40 m/kg^(1/3).
---```lua
---local explosion = hinge.blast { charge = 500, at = { -20, 0, 0 } }
---for t = 0.015, 0.045, 0.005 do
---  print(t, explosion:pressure({ 0, 0, 2 }, { -1, 0, 0 }, t)) -- s, Pa: on a wall that looks to the charge
---end
---```
---@param point vec3 m, on the face
---@param normal vec3 direction out of the face, of any length above 0
---@param time number s, of the run
---@return number pressure Pa; 0 before the arrival and after the duration
function explosion:pressure(point, normal, time) end

---Puts the pressure on members, as model:load with `q` and a history. Each member is loaded over its whole length by
---the pressure in its middle times its width, against the normal. The direction stays as it is when the member moves.
---The history begins with a jump at the arrival and has the impulse exactly. A member is refused if the largest
---pressures at its ends and in its middle differ by more than 20 % of the one in the middle; the message says how many
---members are enough. If one member is refused, none is loaded.
---```lua
---local explosion = hinge.blast { charge = 100, at = { 0.5, -15, 0 } }
---local force, impulse, parts = explosion:load(model, { group = "arm", normal = { 0, -1, 0 }, width = 0.05 })
---print(force, impulse, parts[1].pressure) -- N, N s, Pa
---local swing = model:dynamic { from = run, dt = 1e-4, duration = 0.05 }:finish()
---```
---@param model hinge.model
---@param options hinge.blast_load_options
---@return number force N, the sum of the largest forces of the members; they come at different times
---@return number impulse N s, the sum of their impulses
---@return hinge.blast_part[] parts one for each member
function explosion:load(model, options) end

---@class hinge.blast_load_options
---@field members? hinge.member[] the members that are loaded; give either members or group
---@field group? hinge.group_like all members of a group
---@field normal vec3 direction out of the face, of any length above 0, 84 to 90 degrees from the axis of each member
---m, above 0: how much of the face a member carries, across its length
---@field width number|fun(member: hinge.member): number
---true: members along which the pressure differs by more than 20 % are loaded by the pressure in their middle. Default
---false
---@field uneven? boolean
---@field case? hinge.case|string the load case of the loads, see model:case; default: none, they act in every run

---@class hinge.blast_part
---@field member hinge.member
---@field distance number m, from the charge to the middle of the member
---@field arrival number s, in time of the run
---@field duration number s
---@field pressure number Pa, the peak
---@field width number m
---@field force number N, the peak on the member
---@field impulse number N s, on the member

---Pulses as histories for model:load.
---@class hinge.blasts
local blast = {}

---A triangular pulse: the peak at once at the arrival, then along a straight line to 0.
---```lua
---model:load { node = tip, force = { 0, 0, -2000 }, history = hinge.blast.triangle { peak = 1, duration = 0.01 } }
---local swing = model:dynamic { from = run, dt = 1e-4, duration = 0.03 }:finish()
---```
---@param options hinge.triangle_options
---@return number[][] points { time in s, factor }, three of them
function blast.triangle(options) end

---@class hinge.triangle_options
---@field peak number the largest factor, above 0
---@field duration number s, above 0
---@field arrival? number s, in time of the run; default 0

---Friedlander's pulse: peak (1 - t/duration) exp(-decay t/duration), t from the arrival on. The points are denser where
---it falls fast, and have its impulse exactly.
---```lua
---local pulse = hinge.blast.friedlander { peak = 1, duration = 0.02, decay = 1.5, arrival = 0.005 }
---model:load { node = tip, force = { 0, 0, -2000 }, history = pulse }
---local swing = model:dynamic { from = run, dt = 1e-4, duration = 0.03 }:finish()
---```
---@param options hinge.friedlander_options
---@return number[][] points { time in s, factor }
function blast.friedlander(options) end

---@class hinge.friedlander_options
---@field peak number the largest factor, above 0
---@field duration number s, above 0
---@field decay number b, 0 to 50; 0 is a triangle
---@field arrival? number s, in time of the run; default 0

-- Frames of other programs -------------------------------------------------------------------------------------------

---Frames from files of other programs. A reader returns the frame as a plain table, in SI, and notes on what it could
---not read. import.build makes a model of it, import.write a script.
---@class hinge.imports
local import = {}

---Reads text tables of SAP2000 (.s2k): TABLE: "NAME", then rows of Key=Value. ETABS writes such tables too; its frames
---get the local axes of SAP2000. For its files .e2k there is import.e2k. Read are PROGRAM CONTROL (units), ACTIVE
---DEGREES OF FREEDOM, JOINT COORDINATES, JOINT RESTRAINT ASSIGNMENTS, CONNECTIVITY - FRAME, FRAME SECTION PROPERTIES 01
---- GENERAL, FRAME SECTION ASSIGNMENTS, FRAME LOCAL AXES 1 - TYPICAL (angle), FRAME RELEASE ASSIGNMENTS 1 - GENERAL
---(M2, M3, T), FRAME INSERTION POINT ASSIGNMENTS, FRAME OFFSET ALONG LENGTH ASSIGNMENTS (rigid ends; where they are
---automatic, to the face of the columns or beams at the joint), FRAME RELEASE ASSIGNMENTS 2 - PARTIAL FIXITY (M2, M3,
---T), FRAME AUTO MESH (at joints), JOINT CONSTRAINT ASSIGNMENTS with CONSTRAINT DEFINITIONS - DIAPHRAGM, - BODY and -
---EQUAL (where a support holds one of the joints), JOINT SPRING ASSIGNMENTS 1 - UNCOUPLED, JOINT and FRAME ADDED MASS
---ASSIGNMENTS, MATERIAL PROPERTIES 02 - BASIC MECHANICAL PROPERTIES, 03A - STEEL DATA (Fy), GROUPS 2 - ASSIGNMENTS,
---LOAD PATTERN DEFINITIONS, JOINT LOADS - FORCE, FRAME LOADS - POINT, FRAME LOADS - DISTRIBUTED (forces).
---Sections have the properties that the file states, and the size, the outline and what is left out of
---their shape: I/Wide Flange, Box/Tube, Pipe, Rectangular or Circle. Where AS2 or AS3 is 0 the shear area becomes 1000
---times the area. Areas are one note with their size, loads and weight. A file that contradicts itself is an error with
---its line.
---```lua
---local import = hinge.import
---local name = os.tmpname()
---local file = assert(io.open(name, "w"))
---file:write [[
---TABLE:  "PROGRAM CONTROL"
---   ProgramName=SAP2000   CurrUnits="Kip, in, F"
---TABLE:  "JOINT COORDINATES"
---   Joint=1   CoordSys=GLOBAL   CoordType=Cartesian   XorR=0   Y=0   Z=0
---   Joint=2   CoordSys=GLOBAL   CoordType=Cartesian   XorR=0   Y=0   Z=144
---TABLE:  "JOINT RESTRAINT ASSIGNMENTS"
---   Joint=1   U1=Yes   U2=Yes   U3=Yes   R1=Yes   R2=Yes   R3=Yes
---TABLE:  "CONNECTIVITY - FRAME"
---   Frame=1   JointI=1   JointJ=2
---TABLE:  "FRAME SECTION ASSIGNMENTS"
---   Frame=1   AnalSect=PIPE8
---TABLE:  "FRAME SECTION PROPERTIES 01 - GENERAL"
---   SectionName=PIPE8   Material=A53   Shape=Pipe   t3=8.625   tw=0.322
---TABLE:  "MATERIAL PROPERTIES 02 - BASIC MECHANICAL PROPERTIES"
---   Material=A53   UnitWeight=2.836E-04   UnitMass=7.345E-07   E1=29000   U12=0.3
---]]
---file:close()
---local frame, notes = import.s2k { file = name }
---os.remove(name)
---print(#notes, frame.nodes[2].z, frame.sections[1].area) -- 0, 3.6576 m, 0.0054 m^2
---```
---@param options hinge.import_s2k_options
---@return hinge.import_frame frame
---@return hinge.import_notes notes
function import.s2k(options) end

---@class hinge.import_s2k_options
---@field file string path of the file
---names of hinge.section.named for sections of the file, by their names there, such as { ["W14X999"] = "W14X873" }
---@field sections? table<string, string>

---Reads a text file of ETABS (.e2k, .$et), of versions 9 to 22: sections that begin with "$ NAME". Read are CONTROLS
---(UNITS), STORIES, POINT COORDINATES, LINE CONNECTIVITIES, LINE ASSIGNS (SECTION, ANG, RELEASE, CARDINALPT, OFFSETXI
---to OFFSETZJ, RIGIDZONE with LENGTHOFFI and LENGTHOFFJ), POINT ASSIGNS (RESTRAINT, DIAPH, SPRINGPROP), MATERIAL
---PROPERTIES (E, U, weight, FY), FRAME SECTIONS with their modifiers, LOAD PATTERNS or STATIC LOADS, POINT OBJECT
---LOADS, and FRAME OBJECT LOADS or LINE OBJECT LOADS. A joint is a point on a storey,
---"3@Storey 2", a member a line on a storey, "C1@Storey 2"; its group is columns, beams or braces. Local axes,
---releases, shapes and the division at joints are as those of import.s2k. A shape may also be a name of
---hinge.section.named. Insertion points and offsets count where TRANSFORMSTIFF or TRANSSTIFF is "Yes". Of areas the
---rigid diaphragm alone is read; a note has their size, loads and weight.
---```lua
---local import = hinge.import
---local name = os.tmpname()
---local file = assert(io.open(name, "w"))
---file:write [[
---$ CONTROLS
---  UNITS "KN" "M" "C"
---$ STORIES - IN SEQUENCE FROM TOP
---  STORY "Storey 1" HEIGHT 3.5
---  STORY "Base" ELEV 0
---$ MATERIAL PROPERTIES
---  MATERIAL "S355" TYPE "Steel" WEIGHTPERVOLUME 76.98
---  MATERIAL "S355" SYMTYPE "Isotropic" E 210000000 U 0.3
---  MATERIAL "S355" FY 355000
---$ FRAME SECTIONS
---  FRAMESECTION "Column" MATERIAL "S355" SHAPE "Steel I/Wide Flange" D 0.2 B 0.2 TF 0.015 TW 0.009
---$ POINT COORDINATES
---  POINT "1" 0 0
---$ LINE CONNECTIVITIES
---  LINE "C1" COLUMN "1" "1" 1
---$ POINT ASSIGNS
---  POINTASSIGN "1" "Base" RESTRAINT "UX UY UZ RX RY RZ"
---$ LINE ASSIGNS
---  LINEASSIGN "C1" "Storey 1" SECTION "Column"
---]]
---file:close()
---local frame, notes = import.e2k { file = name }
---os.remove(name)
---print(#notes, frame.members[1].name, frame.nodes[2].name, frame.nodes[2].z) -- 0, C1@Storey 1, 1@Storey 1, 3.5 m
---```
---@param options hinge.import_e2k_options
---@return hinge.import_frame frame
---@return hinge.import_notes notes
function import.e2k(options) end

---@class hinge.import_e2k_options
---@field file string path of the file
---names of hinge.section.named for sections of the file, by their names there, such as { ["W14X999"] = "W14X873" }
---@field sections? table<string, string>

---Reads a script of OpenSees, in Tcl or in Python (OpenSeesPy). What stands at its end is the model; `model` chooses
---among several, which wipe or remove separate. Read are nodes, supports and masses, the elements of beams and bars,
---zeroLength and twoNodeLink, sections Elastic, Fiber and Aggregator, equalDOF, rigidLink, rigidDiaphragm, patterns
---with load and eleLoad, ground motion and damping. A table in the guide (import.md) lists what of each. The script is
---run: Tcl by tclsh (Debian's package tcl), in a safe interpreter; Python by python3, and only with run_python, since a
---Python file is a program. Both are behind walls of the kernel: they read the folder of the script and their own
---library, write nothing, start no program, reach no network, and end after 60 s or 1000 MB. Results of the analysis
---(nodeDisp, eigen) are made up: where a number of the model hangs on one, notes name the line, and it is not read.
---What is not read is in the notes, with its line. Load cases are "pattern 1" and so on. A plane frame in x and y
---becomes one in x and z, held against moving out of that plane. Elements without shear strain get shear areas of 1000
---times the area. Where all transformations are Linear, the frame has model = { displacement = "small" }; where one is
---PDelta or Corotational, displacements are large.
---```lua
---local import = hinge.import
---local name = os.tmpname()
---local file = assert(io.open(name, "w"))
---file:write [[
---model BasicBuilder -ndm 2 -ndf 3
---foreach {tag y} {1 0 2 144} { node $tag 0 $y }
---fix 1 1 1 1
---geomTransf Linear 1
---element elasticBeamColumn 1 1 2 20.0 29000.0 [expr 2*675.0] 1
---pattern Plain 1 Linear { load 2 10.0 0 0 }
---]]
---file:close()
---local frame, notes = import.tcl { file = name, units = { length = "inch", force = "kip" } }
---os.remove(name)
---local model, nodes = import.build(frame)
---local pushed = model:static { loads = { ["pattern 1"] = 1 } }:finish()
---print(#notes, nodes["2"]:displacement(pushed)) -- 0, 0.0065 m
---```
---@param options hinge.import_tcl_options
---@return hinge.import_frame frame
---@return hinge.import_notes notes
function import.tcl(options) end

---@class hinge.import_tcl_options
---@field file string path of the script
---units of the numbers in the script, each by its name in hinge.units, or as a number in SI (m, N, kg, s). mass:
---default force time^2 / length, which OpenSees needs; time: default s. A unit of another kind is an error: the force
---of lb, kg and t is lbf, kgf and tonf
---@field units { length: string|number, force: string|number, mass?: string|number, time?: string|number }
---which model of the script, from 1: one ends at each wipe, at an analysis after which something is removed, and at the
---end of the script. Default: the one at the end; if nothing stands there, the last one with elements
---@field model? integer
---@field language? "tcl"|"python" default: python for a name that ends in .py, else tcl
---@field run_python? boolean run a script in Python; default false: it is refused

---Reads tables in CSV, in SI. The first line of each file has the names of its columns, in any order. Cells are
---separated by commas, semicolons or tabs. With semicolons a comma may be the decimal point. Cells in double quotes may
---hold anything. Empty lines, and lines that begin with #, are passed over. A column of another name is in the notes.
---```lua
---local import = hinge.import
---local files = { nodes = "name,x,y,z\nfoot,0,0,0\nhead,0,0,3\n", supports = "node,fix\nfoot,all\n",
---  members = "name,a,b,section,material\ncolumn,foot,head,HEB 300,S355\n",
---  loads = "case,node,fx\nwind,head,5e3\n" }
---for table, text in pairs(files) do
---  files[table] = os.tmpname()
---  local file = assert(io.open(files[table], "w"))
---  file:write(text)
---  file:close()
---end
---local frame, notes = import.csv(files)
---for _, name in pairs(files) do os.remove(name) end
---print(notes.summary.members, frame.cases[1].name) -- 1, wind
---```
---@param options hinge.import_csv_options
---@return hinge.import_frame frame
---@return hinge.import_notes notes
function import.csv(options) end

---@class hinge.import_csv_options
---@field nodes string path of a file with the columns name, x, y, z (m)
---path of a file with the columns name, a, b (nodes), section, material; further ones: up_x, up_y, up_z (direction of
---the section's y axis; default as in model:member), group, release_a, release_b (such as rx ry, about the section's
---axes)
---@field members string
---path of a file with the columns name, and named (a name of hinge.section.named) or area, Ix, Iy, J (m^2, m^4);
---further ones: shear_area_x, shear_area_y (m^2, default 5/6 of the area), Zx, Zy, Zz (m^3), width, depth (m). A
---section that is not in the file is one of hinge.section.named
---@field sections? string
---path of a file with the columns name, E (Pa); further ones: G (Pa) or nu, density (kg/m^3), yield_stress (Pa), with
---the defaults of hinge.material. A material that is not in the file is one of hinge.material.steel
---@field materials? string
---path of a file with the columns node, and fix (all, or letters as in model:fix) or x, y, z, rx, ry, rz (1: fixed)
---@field supports? string
---path of a file with the columns node, fx, fy, fz (N), mx, my, mz (N m), or member, qx, qy, qz (N/m), axes (global,
---local or projected, as in model:load); further one: case, default "loads"
---@field loads? string
---@field masses? string path of a file with the columns node, mass (kg)

---Makes a model of a frame. Names are those of the file. Releases and offsets of members are those of
---model:member.
---```lua
---local import = hinge.import
---local frame = {
---  nodes = { { name = "foot", x = 0, y = 0, z = 0, fix = "all" }, { name = "head", x = 0, y = 0, z = 3 } },
---  materials = { { name = "S355", E = 210e9, density = 7850 } },
---  sections = { { name = "HEB 300", named = "HEB 300" } },
---  members = { { name = "1", a = "foot", b = "head", section = "HEB 300", material = "S355" } },
---  cases = { { name = "dead", self_weight = 1, loads = { { node = "head", force = { 0, 0, -200e3 } } } } },
---}
---local column, nodes, members = import.build(frame, { model = { displacement = "small" } })
---local rest = column:static { loads = "dead" }:finish()
---print(nodes.head:displacement(rest), members["1"]:forces(rest).N)
---```
---@param frame hinge.import_frame
---@param options? hinge.import_build_options
---@return hinge.model model
---@return table<string, hinge.node> nodes by their names
---@return table<string, hinge.member> members by their names
function import.build(frame, options) end

---@class hinge.import_build_options
---@field model? hinge.model_options options of hinge.model, default {}
---how the self weight of cases acts. gravity: by case:gravity, on members and on point masses, for one case; it stays
---with members that break and fall. loads: as loads along the members, of the unit weight of the file; they are lost
---where a member breaks. Default: gravity where both are the same; else it is an error that asks for one of them
---@field self_weight? "gravity"|"loads"
---@field gravity? number m/s^2, for the self weight; default 9.80665

---Writes a frame as a script of hinge that builds the same model as import.build: tables with one line for each node,
---member and load, by their names. The script ends with `return model, nodes, members`, or in a scenario. Returns the
---path of the file. A file that is there is written over only if import.write has written it. `hinge export FILE` does
---the same for a file of another program.
---```lua
---local import = hinge.import
---local frame = { nodes = { { name = "a", x = 0, y = 0, z = 0, fix = "all" }, { name = "b", x = 2, y = 0, z = 0 } },
---  materials = { { name = "steel", E = 210e9, density = 7850 } },
---  sections = { { name = "IPE 200", named = "IPE 200" } },
---  members = { { name = "beam", a = "a", b = "b", section = "IPE 200", material = "steel" } } }
---local script = import.write(frame, "cantilever.lua", { model = { displacement = "small" } })
---local again, nodes = dofile(script)
---print(again:counts().members, nodes.b.x)
---```
---@param frame hinge.import_frame
---@param file string ends in .lua; a name without a folder is in the output folder
---@param options? hinge.import_write_options
---@return string path
function import.write(frame, file, options) end

---@class hinge.import_write_options: hinge.import_build_options
---true: the script ends in a scenario that solves each load case by itself in statics and draws it, so that hinge run,
---check and plan take it. Default false
---@field scenario? boolean

---What a reader could not read, by file and line. The list itself has what is not read. print shows everything.
---@class hinge.import_notes
---@field [integer] hinge.import_note what is not read
---@field assumed hinge.import_note[] what the file says otherwise or not at all, and what was taken
---@field skipped hinge.import_note[] what is no part of a frame: commands of an analysis, tables of design
---@field summary hinge.import_summary

---@class hinge.import_note
---@field file string
---@field line? integer nil: of no single line
---@field text string the line, without blanks that are not needed, cut after 90 characters
---@field reason? string
---@field count? integer how often, if more than once: for lines of one kind, and for lines in a loop
---@field lines? integer[] all of these lines, the first of them again

---@class hinge.import_summary
---@field file string
---@field nodes integer
---@field members integer
---@field sections integer
---@field materials integer
---@field cases integer
---@field loads integer with a self weight counted as one
---@field masses integer
---@field length number m, of all members
---@field mass_of_members number kg
---@field mass_of_nodes number kg

---A frame in SI. Names are texts; each part has each name once.
---@class hinge.import_frame
---@field source? string the file that it comes from
---@field nodes hinge.import_node[]
---@field materials hinge.import_material[]
---@field sections hinge.import_section[]
---@field members hinge.import_member[]
---@field cases? hinge.import_case[] default: none
---@field masses? hinge.import_mass[] default: none
---@field links? hinge.import_link[] rigid links; default: none
---@field diaphragms? hinge.import_diaphragm[] default: none
---@field connectors? hinge.import_connector[] springs; default: none
---@field joints? hinge.import_joint[] joints between nodes; default: none
---@field motions? hinge.import_motion[] of the ground, in dynamics; default: none
---@field damping? { alpha: number, beta: number } as in model:damping; default: none
---@field model? hinge.model_options what the file says of them; the option `model` of import.build goes first

---@class hinge.import_link
---@field from string name of a node, as in model:rigid_link
---@field to string
---@field dofs? "all"|"xyz" default "all"

---@class hinge.import_diaphragm
---@field nodes string[] as in model:diaphragm
---@field normal? "x"|"y"|"z" default "z"
---@field master? string default: the first of `nodes`

---@class hinge.import_connector
---@field a string name of a node
---@field b? string nil: the ground
---@field x vec3 axes, as in model:connector
---@field y vec3
---@field stiffness { x?: number, y?: number, z?: number, rx?: number, ry?: number, rz?: number } N/m, N m/rad

---@class hinge.import_joint
---@field a string name of a node
---@field b string name of a node at the same place, as in model:joint
---@field x vec3 axes
---@field y vec3
---@field Mx? "rigid"|"free"|hinge.joint_axis as in hinge.joint
---@field My? "rigid"|"free"|hinge.joint_axis
---@field Mz? "rigid"|"free"|hinge.joint_axis

---Motion of all nodes that are fixed along an axis, as hinge.ground makes it.
---@class hinge.import_motion
---@field axis "x"|"y"|"z"
---@field dt number s
---@field acceleration number[] times scale: m/s^2
---@field scale? number default 1

---@class hinge.import_node
---@field name string
---@field x number m
---@field y number m
---@field z number m
---@field fix? string what is fixed, as in model:fix; default: nothing

---@class hinge.import_material
---@field name string
---@field E number Pa
---@field G? number Pa, in place of nu: default E / (2 (1 + nu))
---@field nu? number default 0.3
---@field density? number kg/m^3, default 0
---@field yield_stress? number Pa; default: it never yields
---@field unit_weight? number N/m^3, of the self weight; default: density times gravity
---@field hardening? hinge.hardening default: none

---And the fields of hinge.section_options, in place of `named`.
---@class hinge.import_section
---@field name string
---@field named? string a name of hinge.section.named

---@class hinge.import_member
---@field name string
---@field a string name of its first node
---@field b string name of its second node
---@field section string
---@field material string
---@field up? vec3 direction of the section's y axis; default as in model:member
---@field group? string|string[] default: none
---rotations about the section's axes that are released at its ends, such as "rx,ry": rx and ry are bending about x and
---y, rz is torsion; default: none
---@field release? { a?: string, b?: string }
---m, from a node to the member's end, in the axes of the frame; rigid and without mass; default: none
---@field offset? { a?: vec3, b?: vec3 }
---@field ends? { a?: hinge.joint_options, b?: hinge.joint_options } joints of its ends, as hinge.joint takes them

---@class hinge.import_case
---@field name string
---@field self_weight? number factor on the weight of all members; default 0
---@field loads? hinge.import_load[] default: none
---@field history? number[][] points { time (s), factor } of all its loads in dynamics; default: constant
---@field held? boolean true: a scenario of import.write lets it act first, and while the others act; default false

---@class hinge.import_load
---@field node? string
---@field member? string in place of node
---@field force? vec3 N, in space; on a member at the point `at`
---@field moment? vec3 N m, or N m/m along a member
---@field q? vec3|{ a?: vec3, b?: vec3 } N/m, along a member; { a =, b = }: at `from` and at `to`, linear between
---@field at? number 0 to 1, the place of `force` or `moment` on a member
---@field from? number 0 to 1, where `q` begins on a member; default 0
---@field to? number 0 to 1, where it ends; default 1
---@field axes? "global"|"projected"|"local" of a load on a member; default "global"

---@class hinge.import_mass
---@field node string
---@field mass number kg
---@field inertia? vec3 kg m^2, about the x, y and z axes of space, as in model:mass; default 0
---@field weight? number N, what of it is in the self weight of the file; default: it is in none
---@field offset? vec3 m, from the node to the mass; default { 0, 0, 0 }

-- Robustness ---------------------------------------------------------------------------------------------------------

---What a frame does when it loses a column, one column after the other. It has the three procedures of the alternate
---path method of UFC 4-023-03, which are those of GSA's guidelines of 2016 too. Each case begins with a model that
---`build` makes anew. nonlinear dynamic: statics of the whole frame, then the column goes in one step, and the run goes
---on until the joint above has been no deeper for a period, or something has fallen. nonlinear static: the frame
---without the column; the joint above is pushed down until the loads, times Omega_N, are carried or have had their
---largest value. linear static: elastic moments of the frame without the column under the loads times Omega_LD, over
---the plastic moments. The column leaves a model at rest by `model:remove` within a step of 1e-6 s, and statics goes on
---from there; `build` does not have to leave it out. Half of its weight stays at its head. Vertical is z. The factors
---are for steel and come from digitised tables of both documents; the originals were not at hand. That a column must go
---within a tenth of the period of the vertical vibration is recalled and was not confirmed. Wrong input is an error.
---What goes wrong in a run is the verdict "failed" of its row, which is never "holds", and an error at the end (see
---allow_failed). Joints (hinge.joint, model:joint) are rated beside the hinges: by `limit` and by their own limits, in
---linear statics by their strength. One that turns and has no limit makes a row "not rated" that would hold.
---```lua
---local function build(options)
---  local portal, heads = hinge.model(), {}
---  for i = 1, 3 do
---    local foot = portal:node { 4 * i, 0, 0 }
---    heads[i] = portal:node { 4 * i, 0, 3 }
---    portal:fix(foot)
---    portal:fix(heads[i], "y,rx,rz")
---    portal:member { foot, heads[i], section = square, material = steel, group = "columns" }
---    if i > 1 then
---      local floor = steel:with { density = 10e3 * options.scale(4 * i - 2, 0, 3) } -- kg/m^3
---      portal:member { heads[i - 1], heads[i], section = square, material = floor, group = "beams" }
---    end
---  end
---  portal:gravity { 0, 0, -9.80665 }
---  return portal
---end
---local loss = hinge.robustness { build = build, limit = 0.03, m = 2, quiet = true } -- rad
---print(loss:table())
---for _, row in ipairs(loss.rows) do print(row.name, row.procedure, row.deflection, row.verdict) end
---```
---@param options hinge.robustness_options
---@return hinge.robustness_result
function hinge.robustness(options) end

---@class hinge.robustness_options
---makes the model with its supports and loads. It is called several times for each case, and must make the same nodes
---and members each time
---@field build fun(options: hinge.robustness_build): hinge.model
---"columns" (default): each column, found by geometry: members within 15 degrees of the vertical, from one joint with
---other members or a support to the next. Or a list with an item for each case: the name of a group, a member or its
---index, or a list of these that go together
---@field remove? "columns"|(string|integer|hinge.group|hinge.member|table)[]
---of "columns": "lowest" (default) are those whose foot is held in z or stands at the lowest height
---@field storeys? "lowest"|"all"
---"nonlinear dynamic", "nonlinear static", "linear static", in the order in which they are wanted; default: all three
---@field procedures? string[]
---plastic rotation that is allowed, rad, or what run:hinges takes as limit; of levels the largest counts. Of joints the
---whole rotation is compared, with its elastic part; their own capacity counts where it is smaller. Without it the
---nonlinear procedures need a function as criterion, and nonlinear static needs omega_n. UFC 4-023-03 takes CP of
---ASCE 41 for beams and LS for the rest, GSA CP for all (digitised tables). For Omega_N a function is also called for
---the ends of beams that have not yielded, with zeros
---@field limit? hinge.hinge_limit
---"UFC 4-023-03" (default) or "GSA": the same factors; GSA allows linear statics up to ten storeys. A function gets
---each row whose run has not failed, with the verdict by the rules above in it, and returns a verdict of its own (a
---text that is not empty) and, if it likes, a reason
---@field criterion? "UFC 4-023-03"|"GSA"|fun(row: hinge.robustness_row): string, string?
---load cases with factors, as in static_options, such as { dead = 1.2, live = 0.5 }; needed if the model has cases, and
---all loads and gravity must then belong to cases. Combination of both standards: 1.2 D + (0.5 L or 0.2 S)
---@field loads? table<string|hinge.case, number>|string|hinge.case
---s; the longest that a dynamic run may follow; default: ten periods. The period is that of a mass on a spring with the
---sag of linear statics, 2 pi sqrt(sag / g). A run that has not turned by then is "failed"
---@field duration? number
---@field dt? number s, of dynamics, at most a fiftieth of the period; default: a thousandth
---s, in which the forces of what is removed fall to nothing in nonlinear dynamic, as `over` of model:remove; default 0:
---at once. Both standards ask for a tenth of the period or less
---@field over? number
---how long the run goes on after the joint has been deepest, in periods, or in times of the way down where that is
---longer; default 1. Undamped frames with several slow vibrations may come deeper later: more shows that
---@field follow? number
---ratio of critical damping at the period and a tenth of it, in the place of what the model declares; default: as the
---model declares it
---@field damping? number
---@field fall? number m; a fall of a joint beyond it is a collapse; default: a tenth of the distance to the next column
---@field steps? integer of the push of nonlinear static over `fall`, 10 to 1000; default 40
---factor on the loads of nonlinear static; default: Omega_N = 1.08 + 0.76 / (r + 0.83), with r the smallest allowed
---rotation over the rotation at yield, Mp L / (6 E I), of the beams in the bays next to the removal and above. The
---capacity of a joint at an end of the beam is the allowed rotation where it is smaller. L goes from column to column,
---also where a beam is made of several members
---@field omega_n? number
---m-factor of linear static: what the DCR is compared with. The smallest of the beams next to the removal. Default 1,
---which is on the safe side: no end may come to its plastic moment
---@field m? number
---@field omega_ld? number factor on the loads of linear static; default: Omega_LD = 0.9 m + 1.1
---default false; true: linear static is "not allowed" where a DCR is above 2
---@field irregular? boolean
---a plain name: report.md, robustness.csv and robustness.png are written into this folder of the output folder.
---Default: nothing is written
---@field folder? string
---a result with failed rows is returned; default false: it is an error, after the report is written
---@field allow_failed? boolean
---@field quiet? boolean default false; true: no line on stderr for each case (its verdicts, seconds, and what is left)

---@class hinge.robustness_build what `build` gets
---"geometry", "nonlinear dynamic", "nonlinear static" or "linear static"
---@field procedure string
---@field case? integer number of the case; nil at the first call, which reads the structure
---@field name? string of the case
---the factor on a load at the point x, y, z (m): Omega of the static procedures in the bays next to the removal, at its
---level and above, else 1. A `build` that multiplies its loads with it (or the masses that make them) has them where
---the standards put them. If build never calls it, the static procedures increase all loads by the factor, which is on
---the safe side, but for loads elsewhere that hold against those next to the removal. A bay reaches to the next column
---on the same line, or as far as the structure goes; loads on its edges count as in it
---@field scale fun(x: number, y: number, z: number): number

---@class hinge.robustness_result
---@field rows hinge.robustness_row[] a row for each case and procedure
---@field counts table<string, table<string, integer>> by procedure and verdict: how many
---@field cases integer
---@field criterion string
---@field procedures string[]
---@field seconds number wall time
---The rows as text, by case. What is to be said of a row stands below. print(result) gives the same.
---@field table fun(self: hinge.robustness_result): string
---The rows as a table of Markdown.
---@field markdown fun(self: hinge.robustness_result): string
---Writes the rows with all their numbers, into the folder that the option `folder` names, else into the output folder.
---@field csv fun(self: hinge.robustness_result, filename?: string): hinge.robustness_result
---Draws a plan of the frame, or the elevation of a plane one, into the same folder, by hinge.plot. What was removed is
---coloured by its verdict: green holds, orange exceeds, purple loses members or joints, red collapses, black failed,
---grey not allowed or not rated, blue a verdict of your own. There is a panel for each procedure, and in a plan for
---each height at which removed columns begin.
---@field picture fun(self: hinge.robustness_result, filename?: string): hinge.robustness_result
---Writes report.md, robustness.csv and robustness.png into the same folder: counts, method, table, reasons, picture,
---sources, warnings of the runs.
---@field report fun(self: hinge.robustness_result): hinge.robustness_result

---A row: one procedure of one case. Numbers that a procedure does not have are nil.
---@class hinge.robustness_row
---@field case integer from 1
---@field name string place of a column, such as "x = 6 m, y = 0 m, z = 0 to 4 m", or the items with their place
---@field group? string first group of its first member
---@field members integer[] indices of the members that go
---@field x number m, of the joint above; y likewise
---@field y number
---@field z_low number m, of what is removed; z_high likewise
---@field z_high number
---@field storey? integer of a column: how many stand below it in its line, and 1
---@field procedure string
---"holds", "exceeds the limit of rotation", "exceeds the capacity" (statics: by the force at which a joint breaks),
---"loses members" (others break), "loses joints", "collapses"; of linear static "holds", "exceeds the capacity",
---"exceeds the limit of rotation" (of joints) or "not allowed"; "not rated": nothing is beyond a limit, and joints turn
---that have none (without a strength, or beyond yield); "failed": there is no result; or what the function `criterion`
---returned
---@field verdict string
---@field reason string what to know of the verdict; "" if nothing
---@field span? number m, to the next column at the level of the joint above
---@field fall? number m, beyond which it is a collapse
---@field period? number s, estimated as said at `duration`
---m, of the joint above: dynamics from rest on all columns, statics from the frame without loads. nonlinear static:
---under the loads times Omega_N, between two steps of the push on a straight line, as are the rotations
---@field deflection? number
---m, nonlinear dynamic: the same by statics without the column, from rest as well; nil where statics has no equilibrium
---@field static_deflection? number
---@field increase? number deflection over static_deflection
---@field static_limit? number nonlinear dynamic: load factor that statics without the column comes to
---rad, the largest plastic rotation of members that are no columns, or rotation of their joints
---@field beam_rotation? number
---@field column_rotation? number rad, of columns
---@field beam_ratio? number over the limit, of those that have one
---@field column_ratio? number
---@field ratio? number the larger one; of linear static the DCR over what is allowed
---@field worst? integer index of the member with it
---@field worst_joint? string the joint with it, as run:hinges names it; nil: it is no joint
---@field joint_rotation? number rad, the largest rotation of a joint
---rotation of a joint over its limit, or force over that at which it breaks; of linear static the rotation
---@field joint_ratio? number
---linear static: moment of a joint over its strength, the sum of its axes (and of tension, where it weakens the joint)
---@field joint_dcr? number
---@field joints_broken? integer joints that broke by a limit of their own; in statics: that are beyond one
---@field joints_unrated? integer joints that turn and have no limit
---@field pins? integer axes that are free
---@field pin_rotation? number rad, the largest about one of them at the end of the run
---@field limit? number rad, its limit
---@field hinges? integer plastic hinges and axes of joints that have yielded; without_limit of them have no limit
---@field without_limit? integer
---@field omega? number factor on the loads of a static procedure
---@field smallest_ratio? number r of Omega_N
---@field loads_scaled? "next to the removal"|"all" which loads have the factor
---nonlinear static: the largest load over the given one, in the bays next to the removal; omega is needed
---@field load_factor? number
---@field limit_reached? boolean true: the load has had its largest value; false: it still grew when the push ended
---linear static: the largest demand over capacity of joints (joint_dcr) and of member ends, by the form of AISC 360,
---H1: n / 2 + m below n = 0.2, else n + 8 m / 9; n is N / N0 and m the sum of both moments over Mx0 and My0.
---Instability is not in it
---@field dcr? number
---@field dcr_limit? number m
---of columns with more than half of N0, which are controlled by force: the same under the loads times Omega_LF = 2,
---with a DCR of 1 allowed; nil: there are none
---@field force_dcr? number
---@field broken? integer other members that broke
---@field time? number s, when the joint was deepest
---@field followed? number s, until when the run was followed
---@field dt? number s
---of the run itself; "stopped" where the joint had turned or something had fallen, which is as it should be
---@field run_verdict? string
---@field energy_error? number of the run at its end, as a part of the largest account of the energy balance
---@field seconds number wall time
---of its own runs alone (not of those that find the period or the static deflection), and of loads that have no mass
---and so no inertia
---@field warnings string[]

-- Heat ---------------------------------------------------------------------------------------------------------------

---What heat makes of steel, fire curves, and how hot steel becomes in them.
---@class hinge.heats
local heat = {}

---Properties of a material over its temperature, for model:heat: points { degrees Celsius, value }, straight between.
---@class hinge.heat_properties
---@field stiffness number[][] E over that of the declared material, 0.001 or more; G changes alike
---@field strength number[][] the same of the yield stress, 0.001 or more; hardening and backbone change alike
---@field elongation number[][] strain without stress

---Carbon steel by EN 1993-1-2:2005, table 3.1 and 3.4.1.1, from -60 to 1100 degrees Celsius. strength: "yield", k_y,
---the stress at a strain of 2 %, the default; or "proportional", k_p, where hot steel begins to yield.
---```lua
---local safe = hinge.heat.steel { strength = "proportional" }
---print(safe.strength[6][1], safe.strength[6][2]) -- 500 degrees Celsius, 0.36
---```
---@param options? { strength?: "yield"|"proportional" }
---@return hinge.heat_properties
function heat.steel(options) end

---The factors of carbon steel in EN 1993-1-2:2005, table 3.1, for `hot_curve` of a material: points { degrees Celsius,
---k_y, k_p, k_E }, straight between. With them a heated section begins to yield at the proportional limit k_p f_y. Its
---strength grows along the ellipse of figure 3.1, up to k_y f_y at a strain of 2 %, with the mean plastic strain of the
---part of the element that yields with it. In tension that is exact. The strength of model:heat must be k_y, as it is
---by default; below 100 degrees nothing changes. Raises an error where E is too small beside the yield stress for an
---ellipse up to 2 %.
---```lua
---local steel = hinge.material.steel("S355", { hot_curve = hinge.heat.curve() })
---print(steel.laws) -- curve of EN 1993-1-2
---```
---@return number[][]
function heat.curve() end

---Temperature of the gas in the standard fire ISO 834 (EN 1991-1-2, 3.2.1): 20 + 345 log10(8 t / 60 s + 1).
---```lua
---print(hinge.heat.iso834(1800)) -- 841.8 degrees Celsius after half an hour
---```
---@param time number s
---@return number temperature degrees Celsius
function heat.iso834(time) end

---Temperature of unprotected steel in a fire over time, in steps of 5 s (EN 1993-1-2, 4.2.5.1, eq 4.25). What it
---returns is for the field temperature of model:heat.
---```lua
---local points = hinge.heat.unprotected { section_factor = 140, duration = 1800 }
---print(points[#points][1], points[#points][2]) -- s, degrees Celsius
---```
---@param options hinge.unprotected_options
---@return number[][] points { time in s, degrees Celsius }
function heat.unprotected(options) end

---@class hinge.unprotected_options
---@field section_factor number 1/m, surface over volume of the steel, A_m/V; 10 or more
---@field duration number s
---@field fire? fun(time: number): number temperature of the gas, degrees Celsius; default: hinge.heat.iso834
---@field shadow? number k_sh, factor on the heat that comes in, above 0 to 1; default 1
---@field convection? number W/(m^2 K), default 25
---@field emissivity? number of steel and fire together, 0 to 1; default 0.7
---@field every? number s between two points, default 60

-- Sections -----------------------------------------------------------------------------------------------------------

---Cross-sections. The local z axis runs along the member. The local y axis is the direction of the member's `up`. The
---local x axis completes them. Width is measured along x, depth along y. Plastic resultants of eq 14: N0 = A fy, Mx0 =
---Zx fy, My0 = Zy fy, Mz0 = Zz fy / sqrt 3, with exact plastic moduli. Shear areas are from Cowper (1966) with
---Poisson's ratio 0, which is 5/6 for a rectangle.
---@class hinge.sections
local section = {}

---A closed box. J and Mz0 are from Bredt's theory: 4 Am^2 / sum(length / t), and 2 Am t with the thinnest wall. With
---rounded corners J also has the walls' own sum(length t^3) / 3, as in annex B of EN 10210-2.
---```lua
---local column = hinge.section.box { width = 0.4, depth = 0.4, thickness = 0.022 }
---local cold_formed = hinge.section.box { width = 0.1, depth = 0.2, thickness = 0.006, r = 0.012 }
---```
---@param options hinge.box_options
---@return hinge.section
function section.box(options) end

---@class hinge.box_options
---@field width number m, along x, outside to outside
---@field depth number m, along y
---@field thickness? number of all walls, m; or, in its place, web and flange
---@field web? number of the walls along y, m
---@field flange? number of the walls along x, m
---@field r? number outer radius of the corners, m; default 0
---inner radius of the corners, m; default: r less the thicker wall, at least 0. Hot finished sections of EN 10210 have
---r = 1.5 and r_inner = 1.0 times the thickness
---@field r_inner? number
---@field interaction? "paper"|"exact"|"exact with shear" as for hinge.section.general, here and below

---An H section (I, wide flange) with its web along y, so Ix is of the strong axis. J = sum b t^3 / 3; with fillets it
---is that of El Darwish and Johnston (1965), which published tables have. Mz0 is from the sand-heap analogy for each
---plate. Mz0 and the shear areas leave the fillets out.
---```lua
---local girder = hinge.section.h { depth = 0.4, width = 0.2, web = 0.008, flange = 0.013 }
---local heb300 = hinge.section.h { depth = 0.3, width = 0.3, web = 0.011, flange = 0.019, r = 0.027 }
---```
---@param options { depth: number, width: number, web: number, flange: number, r?: number, interaction?: string }
---  outer sizes and thicknesses, m. r: root radius of a rolled section, between web and flanges, default 0
---@return hinge.section
function section.h(options) end

---A channel: the web along y, both flanges towards +x. Zy is that of the neutral axis that halves the area, as tables
---have it. J is that of El Darwish and Johnston. Shear areas are those of the walls' middle lines. Forces act at the
---centroid. A channel's shear centre is behind its web: the twist by forces through the centroid is not modelled.
---```lua
---local pfc = hinge.section.channel { depth = 0.2, width = 0.09, web = 0.007, flange = 0.014, r = 0.012 }
---```
---@param options hinge.channel_options
---@return hinge.section
function section.channel(options) end

---@class hinge.channel_options
---@field depth number m, along the web, outside to outside
---@field width number m, of the flanges, from the back
---@field web number thickness, m
---@field flange number thickness, m
---@field r? number root radius, m; default 0
---@field r_toe? number radius of the inner edge at the toes, m; default 0
---@field slope? number of the inner faces of tapered flanges: 0.08 is 8 %; default 0
---@field flange_at? number m from the back, where tapered flanges have the thickness `flange`; default half the width
---@field interaction? "paper"|"exact"

---An angle of two legs. x and y are its principal axes: Ix is I about u-u of tables, and Iy that about v-v. The legs
---meet on the side of -x. Legs of equal length make 45 degrees with x; `up` is square to the line that halves the angle
---between them. J is that of El Darwish and Johnston. Shear areas are those of the legs' middle lines. Forces act at
---the centroid. The shear centre is where the legs meet: the twist that follows is not modelled. Pictures show the
---rectangle around it.
---```lua
---local brace = hinge.section.angle { depth = 0.1, width = 0.1, thickness = 0.01, r = 0.012, r_toe = 0.006 }
---```
---@param options { depth: number, width: number, thickness: number, r?: number, r_toe?: number, interaction?: string }
---  lengths of the legs, m. r, r_toe: radii where the legs meet and at the toes, default 0
---@return hinge.section
function section.angle(options) end

---A round tube. All values are exact.
---```lua
---local brace = hinge.section.pipe { diameter = 0.1143, thickness = 0.0045 }
---```
---@param options { diameter: number, thickness: number, interaction?: string } outer diameter and wall, m
---@return hinge.section
function section.pipe(options) end

---A solid rectangle. J is the series of the stress function (0.140577 b^4 for a square). Mz0 is from b^2 (3 d - b) / 6
---with b <= d.
---```lua
---local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
---```
---@param options { width: number, depth: number, interaction?: string } m
---@return hinge.section
function section.solid(options) end

---A solid circle.
---```lua
---local rod = hinge.section.round { diameter = 0.03 }
---```
---@param options { diameter: number, interaction?: string } m
---@return hinge.section
function section.round(options) end

---A rectangle of reinforced concrete. It yields where N, Mx and My come to an ultimate state of its strains: concrete
---crushes at its edge, or all bars yield; concrete carries nothing in tension. The surface is a smooth and convex one
---through these states, up to 1.8 % beyond them in 95 of 100 sections, 4.4 % in the worst of 202 (ACI 318: 6.2 % and
---9.6 %). A moment that is small beside the others may be up to 7 % less than that of the states. Its strengths are
---its own, so that its material has none: hinge.material.concrete. Shear, torsion, bond, and the loss of strength by
---crushing are not in it.
---```lua
---local column = hinge.section.concrete { width = 0.4, depth = 0.4, concrete = "C30/37", steel = "B500B", cover = 0.04,
---  layers = { { y = "top", count = 3, diameter = 0.02 }, { y = 0, count = 2, diameter = 0.02 },
---    { y = "bottom", count = 3, diameter = 0.02 } }, stiffness = 0.5 }
---local beam = hinge.section.concrete { width = 0.3, depth = 0.5, concrete = 25e6, steel = 500e6,
---  bars = { { -0.1, -0.2, diameter = 0.02 }, { 0.1, -0.2, diameter = 0.02 }, { 0, 0.2, area = 314e-6 } },
---  stiffness = "cracked" }
---```
---@param options hinge.concrete_options
---@return hinge.section
function section.concrete(options) end

---@class hinge.concrete_options
---@field width number m, along x
---@field depth number m, along y
---@field concrete number|string compressive strength, Pa, or a grade (hinge.material.names "concrete"): its f_ck
---@field steel number|string yield stress of the bars, Pa, or a grade (hinge.material.names "bars")
---ultimate strains. "EN 1992-1-1" (default): parabola and rectangle with those of table 3.1, for the strength as f_ck;
---bars of 200 GPa without a limit of strain. "ACI 318": 0.003 at the edge, a block of 0.85 of the strength. "plastic":
---none; each part carries its strength. The default where one of the next two is given
---@field strains? "EN 1992-1-1"|"ACI 318"|"plastic"
---of "plastic". Pa, of the bars in compression; default: that of `steel`, but at most 400 MPa, which is 200 GPa times
---the strain 0.002 of concrete under N alone
---@field bar_compression? number
---of "plastic". Part of its strength that concrete carries, above 0 and at most 1, default 0.95: the stress block of
---ideal plasticity is larger than that of EN 1992-1-1. 0.8 for columns that are bent about both axes
---@field effectiveness? number
---bars: {x, y} from the middle, m, with diameter (m) or area (m^2). A bar is a disc of its area
---@field bars? { diameter?: number, area?: number }[]
---bars at one y (m, or "top" or "bottom"), evenly from side to side
---@field layers? { y: number|string, count: integer, diameter: number }[]
---@field cover? number m, between the surface and the bars of layers
---factor on Ix and Iy of the concrete without bars and cracks, above 0 and at most 2; gross (default): 1; cracked: 0.3,
---of beams, and of columns with N up to 0.1 of area times strength (ASCE 41-17, table 10-5; 0.7 from 0.5 on)
---@field stiffness? number|"gross"|"cracked"

---A section by its name in tables: HEB 300, IPE 300, HEA, HEM, HD, UPN; UB, UC; L; W14X90, S, HP, M, C, MC, HSS; SHS,
---RHS, CFSHS, CFRHS, CHS; H, BCR and BCP of Japan; HW, HM and HN of China. Also American angles (L4X4X1/2) and pairs of
---them (2L4X4X1/2X3/8, LLBB or SLBB), tees (WT8X50 is half of W16X100), pipes (Pipe6STD), and metric names of American
---sections (W360X79 is W14X53). Properties and outline are computed from the published dimensions, with fillets and
---rounded corners; `kind` is the name. Case, blanks and zeros at the end do not count: "HE 300 B" is HEB 300, "SHS
---100x5" is SHS 100x100x5. SHS and RHS are hot finished, CFSHS and CFRHS cold formed. HSS have the design thickness,
---0.93 of the nominal one. An unknown name is an error that names the nearest. hinge.section.channel and
---hinge.section.angle say how UPN and L lie, and what of them is not modelled.
---```lua
---local column = hinge.section.named "HEB 300"
---local brace = hinge.section.named("CHS 168.3x8", { interaction = "exact with shear" })
---```
---@param name string
---@param options? { interaction?: string }
---@return hinge.section
function section.named(name, options) end

---The names of the sections of a family, such as "HEB"; without a family, those of the families. BCR and BCP have no
---list: they are made for any size, "BCR 400x16".
---```lua
---print(table.concat(hinge.section.names "HEM", ", "))
---```
---@param family? string
---@return string[]
function section.names(family) end

---Makes any section from its properties.
---```lua
---local hea200 = hinge.section.general { area = 53.8e-4, Ix = 36.9e-6, Iy = 13.4e-6, J = 0.21e-6,
---  plastic = { A = 53.8e-4, Zx = 429e-6, Zy = 204e-6 }, size = { width = 0.2, depth = 0.19 } }
---```
---@param options hinge.section_options
---@return hinge.section
function section.general(options) end

---@class hinge.section_options
---@field area number m^2
---@field Ix number m^4; bending about x, deflection along y
---@field Iy number m^4; bending about y, deflection along x
---@field J number torsion constant, m^4
---@field shear_area_x? number m^2, default 5/6 of the area
---@field shear_area_y? number m^2, default 5/6 of the area
---@field mass_Ix? number m^4, for the rotary inertia; default Ix
---@field mass_Iy? number m^4, default Iy
---@field N0? number N; fully plastic axial force of eq 14, whatever the material; default: from `plastic`
---@field Mx0? number N m, of bending about x; default: from `plastic`, and without that no limit; so for the others
---@field My0? number N m, of bending about y
---@field Mz0? number N m, of torsion
---m^2, m^3. A, Zx and Zy are multiplied by the yield stress, Zz by the yield stress / sqrt 3
---@field plastic? { A?: number, Zx?: number, Zy?: number, Zz?: number }
---m, along x and y, for contact and pictures; default: both are the square root of the area. With the thickness of a
---web and of the flanges pictures show an H
---@field size? { width: number, depth: number, web?: number, flange?: number }
---@field kind? string a name for messages
---what carries shear forces, from the sizes: "h", "box", "pipe", "solid" or "round". Default: `kind`, where it is one
---of them
---@field shape? string
---walls that carry shear forces along x and along y, rectangles { x0, x1, y0, y1 } within the outline, m from the
---centroid; for interaction "exact with shear". Default: by `shape`
---@field shear_walls? { x?: number[][], y?: number[][] }
---the shape, m: its parts, each a polygon or a circle; hole = true takes it away. Its centroid becomes the origin, and
---its area may differ from `area` by 2 % at most. It is needed for interaction "exact"
---@field outline? { corners?: number[][], diameter?: number, centre?: number[], hole?: boolean }[]
---how N, Mx and My interact where the section yields; default: as the model's option says, "exact". paper: eq 14, the
---sum of the squares of the resultants over their fully plastic values. exact: that of the outline, from its stress
---distribution at full yield: all of it in tension on one side of the neutral axis, in compression on the other. Mz
---takes from all of them alike: g^2 + (Mz / Mz0)^2 = 1, g: utilisation by N, Mx and My. Shear does not count.
---exact with shear: shear forces count by EN 1993-1-1 6.2.8. What carries a shear force V has the yield stress
---(1 - rho) fy, rho = (2 V / V0 - 1)^2 beyond V0 / 2 and at most 0.98: of an H or a channel the web between the flanges
---or the flanges, of a box its walls without the corners, of pipes, angles and solid sections all. V0 is fy / sqrt(3)
---times A_v of 6.2.6(3) with eta = 1; of shapes that are not there the shear area of the section. Torsion takes from V0
---by 6.2.7(9). V is that at the end of the step before: shorter steps follow it more closely. Other shapes are as with
---"exact". A run warns where V is beyond V0
---@field interaction? "paper"|"exact"|"exact with shear"
---of a section of reinforced concrete with this `outline`: strength of the concrete in compression, Pa, and bars {x, y}
---in the outline's coordinates, m, with area, m^2, and strengths, Pa (compression: default as tension). Concrete
---carries nothing in tension, nor where bars displace it. N0, Mx0 and My0 follow. hinge.section.concrete makes this
---table. Without `strains` each part carries its strength, whatever its strain
---@field reinforcement? { concrete: number, bars: hinge.bar[], strains?: hinge.concrete_strains }

---@class hinge.bar
---@field area number m^2
---@field tension number yield stress, Pa
---@field compression? number yield stress in compression, Pa: default as tension

---The stress of concrete rises to its strength at the strain `peak`, as 1 - (1 - strain / peak)^exponent, and stays
---there. The section is at its ultimate state with the strain `ultimate` at the pressed edge; where all of it is
---pressed, with `peak` at the part 1 - peak / ultimate of the depth (EN 1992-1-1, 3.1.7 and figure 6.1).
---@class hinge.concrete_strains
---@field peak number
---@field ultimate number at least peak, below 0.1
---@field exponent? number 1 or more: default 2
---@field block? number instead: the stress is the strength from this strain on, and 0 below; below peak
---@field bars? number E of the bars, Pa: default 200e9

---@class hinge.section read-only
---@field kind string
---@field area number m^2
---@field Ix number m^4
---@field Iy number m^4
---@field J number m^4
---@field shear_area_x number m^2
---@field shear_area_y number m^2
---@field plastic_area number m^2; 0: no limit; the same holds for Zx, Zy and Zz
---@field Zx number plastic moduli, m^3
---@field Zy number m^3
---@field Zz number m^3, of torsion
---N; only if it was given; the same holds for Mx0, My0 and Mz0. Of concrete: the larger one, mostly that in
---compression, and the larger of both moments beside N = 0
---@field N0? number
---@field Mx0? number N m
---@field My0? number N m
---@field Mz0? number N m
---@field width number m, along x; 0: the square root of the area; the same holds for depth
---@field depth number m, along y
---@field web number m, thickness of the web of an H; 0: other sections; the same holds for flange
---@field flange number m
---@field interaction? "paper"|"exact"|"exact with shear" nil: as the model's option says
local any_section = {}

---The exact plastic moments beside an axial force, as parts of those without it: about x over Mx0, and about y over
---My0. Eq 14 has sqrt(1 - n^2) in their place, which is more for most shapes. A run and `hinge check` warn where a
---member has more than 1.10 times the exact moment.
---```lua
---local heb300 = hinge.section.h { depth = 0.3, width = 0.3, web = 0.011, flange = 0.019 }
---local about_x, about_y = heb300:reduced_moments(0.3)
---print(about_x, about_y) -- 0.791 and 0.976
---```
---@param n number N / N0, from -1 to 1
---@return number? about_x, number? about_y 1 at n = 0, 0 at n = 1; nil for a section whose shape is not known, or has
---  no two axes of symmetry
function any_section:reduced_moments(n) end

---The moments Mx and My at which a section of concrete yields beside the axial force N: of all of its yield surface
---those that do the most work on a curvature in the direction `angle`. That is not the direction of the neutral axis of
---an ultimate state, unless it is one of symmetry.
---```lua
---local column = hinge.section.concrete { width = 0.4, depth = 0.4, concrete = 30e6, steel = 500e6, cover = 0.04,
---  layers = { { y = "top", count = 3, diameter = 0.02 }, { y = "bottom", count = 3, diameter = 0.02 } } }
---local Mx, My = column:plastic_moments(-1e6) -- beside a compression of 1 MN
---```
---@param N number N, tension positive
---@param angle? number rad, of the plastic curvature: 0 (default) about x, pi / 2 about y
---@return number? Mx, number? My N m; nil for a section of another kind
function any_section:plastic_moments(N, angle) end

-- Models -------------------------------------------------------------------------------------------------------------

-- Handles. Two handles to the same thing are the same value, so == compares them and they can be keys of a table.
-- tostring says what a handle stands for, and if that was removed, when. A handle of another model, or of a closed
-- model, is an error everywhere. Lists are arrays in the order of declaration. Each call makes a new one:
-- `for _, member in ipairs(group:members()) do ... end`. A method that reads results takes the run as an argument. By
-- default it is the latest run of the model; if there is none yet, that is an error.

---A joint.
---@class hinge.node
---@field x number as declared, m
---@field y number
---@field z number
---@field index integer from 1, in the order of declaration
---@field fixed string? what is fixed, as in model:fix: "all", or for example "x,y,rx"; nil: nothing
local node = {}

---```lua
---local _, _, uz = tip:displacement()
---print(("the tip goes down by %.3f mm"):format(-1000 * uz))
---```
---@param run? hinge.run default: the latest of the model
---@return number ux, number uy, number uz, number rx, number ry, number rz m and rotation vector, rad
function node:displacement(run) end

---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }:finish()
---local _, _, vz = tip:velocity(swing)
---```
---@param run? hinge.run default: the latest of the model
---@return number vx, number vy, number vz, number wx, number wy, number wz m/s and rad/s
function node:velocity(run) end

---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }:finish()
---local _, _, az = tip:acceleration(swing)
---```
---@param run? hinge.run default: the latest of the model
---@return number ax, number ay, number az, number bx, number by, number bz m/s^2 and rad/s^2
function node:acceleration(run) end

---```lua
---local _, _, fz, _, my = wall:reaction()
---print(("the wall carries %.0f N and %.0f N m"):format(fz, my))
---```
---@param run? hinge.run default: the latest of the model
---@return number fx, number fy, number fz, number mx, number my, number mz
---  what the support exerts on the node, N and N m
function node:reaction(run) end

---```lua
---local x, y, z = tip:position()
---```
---@param run? hinge.run default: the latest of the model
---@return number x, number y, number z where it is now, m
function node:position(run) end

---A bar between two joints.
---@class hinge.member
---@field a hinge.node
---@field b hinge.node
---@field length number between its ends as declared, m
---@field mass number kg
---@field group string? name of its first group, which sets its colour; nil: none
---@field section hinge.section
---@field material hinge.material
---@field backbone hinge.backbone|string? nil: none; "a function"
---@field law string? nil: none; "a function"
---@field up vec3 direction of the section's y axis, as given
---@field elements integer|"auto" the number of its elements; "auto" until the first run decides
---@field carries "both"|"tension"|"compression" as given
---@field ends table<"a"|"b", hinge.joint>? joints of its ends; nil: none
---@field offset table<"a"|"b", vec3>? what leads from its nodes to its ends, m; nil: they are at the nodes
---@field index integer from 1, in the order of declaration
local member = {}

---```lua
---for _, joint in ipairs(beam:nodes()) do print(joint.index, joint.x) end
---```
---@return hinge.node[] a_and_b
function member:nodes() end

---```lua
---for _, group in ipairs(beam:groups()) do print(group.name) end
---```
---@return hinge.group[]
function member:groups() end

---The section resultants at the two ends of the member. All are zero when the element at that end is broken.
---```lua
---local at_a, at_b = beam:forces()
---print(at_a.Mx, at_b.Qy, at_a.f_y) -- N m, N, 1 where fully plastic
---```
---@param run? hinge.run default: the latest of the model
---@return hinge.resultants at_a, hinge.resultants at_b
function member:forces(run) end

---The resultants along the member, with the loads between its nodes: a list of rows from its first end (x = 0) to its
---second. Rows stand at `parts` equal parts of its length, at its elements' ends, where a moment has an extreme value,
---and on both sides of a point load. Signs as in member:forces: dMx/dx = Qy, dMy/dx = -Qx where no moment acts along
---it. Exact in small displacement under point loads and loads that are linear along it, weight included. In large
---displacement with p_delta member the moments are those of the beam-column: the axial force acts on the bow of the
---member, which adds to dMx/dx; shear forces are across the chord of each element. In dynamics
---inertia counts as a load that is uniform along each element. A broken element has no rows.
---```lua
---for _, row in ipairs(beam:along(run, 4)) do print(row.x, row.Mx, row.Qy) end
---```
---@param run? hinge.run default: the latest of the model
---@param parts? integer default 8
---@return hinge.resultants_at[]
function member:along(run, parts) end

---@class hinge.resultants_at
---@field x number m, from the first end along the member as declared
---@field N number N, positive in tension
---@field Mx number N m
---@field My number N m
---@field Mz number N m
---@field Qx number N
---@field Qy number N

---The state of the member. A member is broken if one of its elements is broken.
---```lua
---local state, f_y = beam:state()
---print(state, f_y) -- elastic, and how near the most stressed section is to fully plastic
---```
---@param run? hinge.run default: the latest of the model
---@return "elastic"|"yielded"|"broken" state, number f_y, number? time, integer? element f_y: the largest value now.
---  time and element are of a broken member: when its first element broke (s; nil: before this run began), and which of
---  its elements it was
function member:state(run) end

---What a joint at an end of the member carries: moments that it puts on the node, about the section's axes (N m), its
---rotations (rad), tension and shear force (N), and the time at which it broke (s), false while it is whole. nil: the
---end has no joint.
---```lua
---local stub = model:node { 1, 0, 0.5 }
---model:fix(stub)
---local hanger = model:member { stub, tip, section = square, material = steel, release = { b = "Mx" } }
---model:static():finish()
---print(hanger:joint("b").rotation_x)
---```
---@param end_of_member "a"|"b"
---@param run? hinge.run default: the latest of the model
---@return hinge.joint_now?
function member:joint(end_of_member, run) end

---@class hinge.joint_now
---@field Mx number N m
---@field My number N m
---@field Mz number N m
---@field rotation_x number rad, of the end relative to the node; of a broken joint, where it broke
---@field rotation_y number rad
---@field rotation_z number rad
---@field tension number N
---@field shear number N
---@field broken number|false s

---The members that have the same group name. `#group` is their number.
---@class hinge.group
---@field name string
---@field size integer number of its members, as #group
---@field length number sum over its members, m
---@field mass number kg
local group = {}

---```lua
---for _, member in ipairs(model:group("arm"):members()) do print(member.length, member:state()) end
---```
---@return hinge.member[]
function group:members() end

---```lua
---model:velocity("arm", { 0, 0, -2 })
---for _, joint in ipairs(model:group("arm"):nodes()) do print(joint.x, joint.fixed) end
---```
---@return hinge.node[] nodes the joints of its members, each once
function group:nodes() end

---@alias hinge.group_like hinge.group|string

---A load on a node.
---@class hinge.load
---@field node hinge.node
---@field force vec3 N
---@field moment vec3 N m
---@field case? string name of its load case; nil: it belongs to none
local load = {}

---Removes the load from the model. Runs that have ended keep it. A run that has not ended may not go on (run:step). Any
---later use of the handle is an error, which says where the load was removed.
---```lua
---local prop = model:load { node = tip, force = { 0, 0, 500 } }
---local held = model:static():finish()
---prop:remove()
---local fall = model:dynamic { from = held, dt = 1e-4, duration = 0.01 }:finish()
---```
function load:remove() end

---A load case, made by model:case.
---@class hinge.case
---@field name string
local case = {}

---As model:load. The load belongs to this case.
---```lua
---local snow = model:case "snow"
---snow:load { member = beam, q = { 0, 0, -2e3 } }
---local under_snow = model:static { loads = { snow = 1 } }:finish()
---```
---@param options hinge.load_options
---@return hinge.load? load
function case:load(options) end

---As model:gravity. Gravity belongs to this case.
---```lua
---local dead = model:case "dead"
---dead:gravity { 0, 0, -9.80665 }
---local design = model:static { loads = { dead = 1.35 } }:finish()
---```
---@param acceleration vec3 m/s^2
function case:gravity(acceleration) end

---@class hinge.model
local model = {}

---```lua
---for _, node in ipairs(model:nodes()) do print(node.index, node.x, node.y, node.z, node.fixed) end
---```
---@return hinge.node[]
function model:nodes() end

---```lua
---local longest = 0
---for _, member in ipairs(model:members()) do longest = math.max(longest, member.length) end
---```
---@return hinge.member[]
function model:members() end

---```lua
---for _, group in ipairs(model:groups()) do print(group.name, #group, group.mass) end
---```
---@return hinge.group[]
function model:groups() end

---```lua
---for _, load in ipairs(model:loads()) do print(load.node, load.force[3], load.case) end
---```
---@return hinge.load[] loads those that were not removed
function model:loads() end

---```lua
---model:case "dead"
---for _, case in ipairs(model:cases()) do print(case.name) end
---```
---@return hinge.case[]
function model:cases() end

---Frees the memory of the model and of its runs at once, even if handles still exist. Any later use of such a handle is
---an error, which says where the model was closed. A model without any handle is freed automatically. It is an error to
---call close inside a step of a run of the same model.
---```lua
---for storeys = 1, 3 do
---  local tower = hinge.model()
---  tower:node { 0, 0, 3 * storeys }
---  tower:close()
---end
---```
function model:close() end

---Adds a joint to the model.
---```lua
---local top = model:node { 0, 0, 3 } -- x, y, z; z is up by custom
---```
---@param position vec3 m
---@return hinge.node
function model:node(position) end

---Fixes degrees of freedom of one node or of a list of nodes, in addition to those that are already fixed.
---```lua
---model:fix(wall) -- all six
---model:fix({ wall, tip }, "y,rx,rz") -- bends in the plane of x and z alone
---```
---@param node hinge.node|hinge.node[]
---@param what? string "all" (default), or letters: "xyz" displacements, "rx", "ry", "rz" rotations, as in "x,y,rx"
function model:fix(node, what) end

---Adds a member between two joints. The member is rigidly connected to both.
---```lua
---local column = model:member { wall, model:node { 0, 0, 3 }, section = square, material = steel,
---  up = { 1, 0, 0 }, group = "columns", elements = 4 }
---model:member { wall, tip, section = hinge.section.round { diameter = 0.02 }, material = steel, carries = "tension" }
---```
---@param options hinge.member_options
---@return hinge.member
function model:member(options) end

---@class hinge.member_options
---@field [1] hinge.node
---@field [2] hinge.node
---@field section hinge.section
---@field material hinge.material
---direction of the section's y axis: any vector that is not along the member. Default: upwards; along the x of space
---for an upright member
---@field up? vec3
---@field group? string|hinge.group|(string|hinge.group)[] the first one sets its colour
---@field elements? integer|"auto" default: elements_per_member of the model; "auto" is described there
---strength of its ends over their plastic rotation; default: constant. Not with the conventional element. A function
---gets the largest plastic rotation of the end so far (rad), its plastic rotations about x and y (rad) and its plastic
---work at the full strength (J), as they are where a step may end, and returns the strength over the fully plastic one,
---0.01 or more. It is called often, in every step in which the end flows, and must depend on these four alone. A run
---with such a function has one thread
---@field backbone? hinge.backbone|fun(largest: number, x: number, y: number, work: number): number
---what the flow of its sections does to their strength, as a function of yours. It is asked for each end of an element
---that flows, some hundred times a step, and must depend on its arguments alone. Hardening and rate of the material,
---and a backbone, act beside it. A run with such a function has one thread. A function alone has no history variables
---@field law? hinge.section_law|fun(flow: hinge.section_flow, history: number[]): number, number[]?, number[]?
---which axial forces it carries. both (default). tension: a cable or slender brace. It shortens without force, and
---carries again at the length where it lost its force. compression: a prop or a bearing, the same the other way. No
---energy is dissipated by that. With a yield stress the member yields at N0 in the sense that it carries; its bending
---and torsion stay elastic, and a material with hardening or rate is refused. The axial force acts on the chords of
---its elements (as p_delta = "chord"): a compression member that may buckle takes eight elements. N in the middle of an
---element says whether it is slack. The nodes of an element take half each of a load along it, slack or not. So where
---the member is slack between two held ends, half of the load of an element presses on the end there: N is -q l / 2 in
---the place of 0 (l: length of an element), and at the other end (1 - 1/(2 n)) q L in the place of q L with n elements:
---0.75 of it with two, 0.94 with eight. A run warns where that is more than 5 % of the largest axial force (in
---dynamics where the member is at rest), and says how many elements it takes
---@field carries? "both"|"tension"|"compression"
---joints of its ends, made by hinge.joint; a is the end at the first node. Default: rigid
---@field ends? { a?: hinge.joint, b?: hinge.joint }
---moments that an end does not pass on: "Mx", "My" (bending about the section's axes) or "Mz" (torsion), or a list of
---them. A short form of ends with hinge.joint { Mx = "free" }. Mz can be free at one end alone
---@field release? { a?: string|string[], b?: string|string[] }
---m, what leads from a node to the member's end, in space, as declared: rigid ends, or another line than that between
---the nodes (insertion points). It rotates with its node, has neither mass nor strain, and does no work. The member,
---its length, its loads, joints and results are those between these ends. It needs no further node. A node may follow a
---diaphragm or a rigid link, and the ends of its members follow with it. Not with integrator = "energy-momentum" and
---not at a node that model:move moves. Default: the ends are at the nodes
---@field offset? { a?: vec3, b?: vec3 }

---Members through several nodes, one after the other, with the options of model:member. Where one of them is refused,
---none is added.
---```lua
---local mid = model:node { 0.5, 0, 0 }
---model:line { wall, mid, tip, section = square, material = steel, group = "arm" }
---```
---@param options hinge.grid_members with two nodes or more
---@return hinge.member[]
function model:line(options) end

---What members have that do not say otherwise: any options of model:member but the nodes. With `group`, for members of
---which that is the first group; without it, for all members. An option of the member itself counts first, then that of
---its group, then that of all. It holds for members that are made after it, by model:member, model:line and hinge.grid.
---A later call for the same group takes the place of the former one.
---```lua
---model:defaults { section = square, material = steel }
---model:defaults { group = "columns", section = hinge.section.named "HEB 200", elements = 4 }
---local post = model:member { wall, model:node { 0, 0, 3 }, group = "columns" }
---print(post.section.kind, post.elements) -- HEB 200, 4
---```
---@param options hinge.grid_members
function model:defaults(options) end

---@class hinge.section_law
---@field variables? integer history variables of each section that can yield, 0 (default) to 32; they are 0 at first
---returns the strength at the end of the step over the fully plastic one, 0.01 or more, which counts for N, Mx, My and
---Mz alike; then the middle of the yield surface, Mx, My (N m), N (N), Mz (N m), nil: 0; then the history variables at
---the end of the step, nil: as they were. `history`: those at its start
---@field step? fun(flow: hinge.section_flow, history: number[]): number, number[]?, number[]?
---in the place of step: it is asked for several flows of one section at once, which all begin with `history`. Each
---field of flows is an array with `count` items. It returns an array of strengths, then nil or an array of middles,
---then nil or an array of history variables, with an item for each flow
---@field batch? fun(flows: hinge.section_flows, history: number[]): number[], number[][]?, number[][]?

---plastic flows of a section
---@class hinge.section_flows
---@field count integer
---@field x number[] as in hinge.section_flow
---@field y number[]
---@field N number[]
---@field z number[]
---@field strain number[]

---plastic flow of a section in a step
---@class hinge.section_flow
---@field x number plastic rotation about the section's x axis, rad; the sign is that of Mx
---@field y number about y, rad
---@field N number plastic elongation, m
---@field z number plastic twist, rad
---growth of the mean plastic strain of the part of the element that yields with the section (half of its length; with
---the conventional formulation all of it): plastic work at the full strength over N0 times that length
---@field strain number

---Adds a load on a node. Three numbers give a force of fixed direction. A function is called once a step with two
---arguments: the time at the end of the step (s), and the run as it is at the beginning of the step (dynamics only). It
---returns three numbers, or a table of three. In the first step of a run it is also called with the time at which the
---run begins.
---
---Or a load on a member, or on each member of a group, also on those that come to it later: `q` and `moment` over its
---whole length, or between `from` and `to`, linear between `a` and `b`, where the load begins and ends; or with `at` a
---force and moment at that point. The member's
---end nodes get the fixed-end forces of the whole Timoshenko member, so that end forces in linear statics are exact for
---any number of elements, and joint displacements are those of the stiffness (closed form with asi-gauss). run:forces
---includes the load, and yield and a fracture rule's forces go by the same: plastic limit loads under uniform load are
---exact with two elements in pinned and clamped members. Hinges stand at nodes: a propped member, whose hinge belongs
---0.414 of the length from the prop, carries 12 M_p / L^2 with two or four elements and 11.73 with eight, where 11.66
---is right. A fracture rule's strains and limits are those of the elements' own deformation. With large displacement,
---forces in space keep their direction, those in local axes rotate with each element, and the fixed-end moments are
---those in the member's present axes, by its elastic stiffness. An element that breaks loses its part of the load. Such
---a load gives no handle; it can be left out, but not removed.
---
---A static run leaves out loads with a history, on nodes and on members, since statics has no time. If `loads` of the
---run names the load case of such a load, the run takes its numbers in full, whatever the history. It is an error if
---all loads have a history. A dynamic run that continues another run also continues its time. A history that begins
---with the second run therefore begins at that time. Warnings name points of a history that are past when the run
---begins, that change less than 5 % before the end of the run, or that act for less than two steps.
---```lua
---model:load { node = tip, force = { 0, 0, -1000 } } -- N
---model:load { member = beam, q = { 0, 0, -200 } } -- N/m
---model:load { member = beam, q = { a = { 0, 0, 0 }, b = { 0, 0, -300 } }, from = 0.5, to = 1 } -- a triangle
---model:load { node = tip, force = { 5e3, 0, 0 }, history = { { 0, 1 }, { 0.01, 0 } } } -- a blast of 10 ms
---```
---@param options hinge.load_options
---@return hinge.load? load of a load on a node
function model:load(options) end

---@class hinge.load_options
---@field node? hinge.node
---@field member? hinge.member in place of node
---@field group? hinge.group_like in place of node: each member of the group
---@field q? vec3|table N/m, or { a = vec3, b = vec3 } where the load begins and ends; one left out is zero
---@field force? vec3|fun(time: number, run: hinge.run): number N, in space; on a member at the point `at`
---N m, in space. On a member: N m/m, given as `q`, or N m at the point `at`; numbers only, no function
---@field moment? vec3|fun(time: number, run: hinge.run): number
---@field at? number on a member: the distance from its first end as a part of its length, 0 to 1
---@field from? number where `q` and `moment` begin, as a part of the member's length, 0 to 1; default 0
---@field to? number where they end, more than `from`, up to 1; default 1
---axes of a load on a member. "global" (default): in space, per length of the member. "projected": in space, per length
---of the member's projection on the plane normal to the load at the start, as for snow (`q` only). "local": in the
---member's x, y, z axes
---@field axes? "global"|"projected"|"local"
---factor of the numbers over time (s): a function, or points { { time, factor }, ... }. Default 1. Two points at the
---same time are a jump: the first value holds up to that time, the second from then on. If a step ends at a jump, that
---step ends with the value before the jump, and the next step begins with the value after it. If the points have a
---jump, or a slope shorter than 20 steps, then each step with a jump or a kink in it uses the mean of the factor over
---the step, so no impulse is lost. Times are those of the run, which go on if `from` is a dynamic run. Of a function,
---only the values at the ends of steps are known
---@field history? fun(time: number): number|number[][]
---@field case? hinge.case|string the load case of the load, see model:case; default: none, it acts in every run

---Declares a load case. A load belongs to it if it is declared with this case as `case`, or by case:load or
---case:gravity. The option `loads` of a run says which cases act, and with which factors. Loads and gravity that belong
---to no case act in every run. A second call with the same name returns the same case.
---```lua
---local live = model:case "live"
---model:load { node = tip, force = { 0, 0, -500 }, case = live }
---local half = model:static { loads = { live = 0.5 } }:finish()
---```
---@param name string
---@return hinge.case
function model:case(name) end

---Declares a combination: a sum of load cases with factors, which `loads` of a run can name. The factors may also name
---combinations that were declared before.
---```lua
---model:case("dead"):gravity { 0, 0, -9.80665 }
---model:case("live"):load { node = tip, force = { 0, 0, -500 } }
---model:combination("uls", { dead = 1.35, live = 1.5 })
---local design = model:static { loads = "uls" }:finish()
---```
---@param name string a name that no case and no other combination has
---@param factors table<string, number>
function model:combination(name, factors) end

---Attaches a point mass to a node. The mass has inertia, it has weight if the model has gravity, and it rotates with
---the node. Several masses on one node add up. In a step the mass is a rigid offset mass, like what is left of broken
---members (paper, fig 5). Its momentum, energy and weight are counted together with those of members. If fracture takes
---the last member of a node, the node flies on with its mass; if the mass has no rotary inertia, it stops rotating. A
---mass that is declared after a run is part of the runs that continue from that run. It is an error if the node has no
---member when a run begins. `hinge check` includes the mass in masses and natural periods. Members between point masses
---may have density 0. In Newmark's method the nodes without mass, and rotations of masses without `inertia`, are in
---balance at the end of each step, as in the statically condensed structure: forces that set in at once move them at
---once, and what that loses of the work is in run.energy.numerical. Such members go neither with the other integrators
---nor with contact and ground, and they cannot break; model:remove takes them out.
---```lua
---model:mass { node = tip, mass = 20, inertia = 0.1 } -- kg, kg m^2
---```
---@param options hinge.mass_options
function model:mass(options) end

---Makes node `to` move with node `from` as a rigid body, however far both rotate. The link has no mass. It does no
---work: what acts on `to` acts on `from`, with its moment about `from`. Several links may begin at one node, and a node
---follows one other node. The link keeps the nodes as they are where a run begins. In dynamics `to` begins with the
---velocity that follows from `from`. Supports may hold `to` where they hold all of `from` that moves it, as in a plane
---frame that is held out of its plane. It is an error, when a run is made, if `to` is held and `from` could move it
---there, and if a node has no member. Rigid ends of a member are simpler with its `offset`. If fracture takes the last
---member of a node, the link keeps the others together. These do not go with it yet, and are errors: integrator =
---"energy-momentum", a support that moves at one of the nodes, and several links, one with dofs = "xyz", from a node
---whose members can break.
---```lua
---local face = model:node { 0.2, 0, 3 } -- of a column, 0.2 m from its axis
---local axis = model:node { 0, 0, 3 }
---model:rigid_link { from = axis, to = face } -- both nodes have members, too
---```
---@param options hinge.rigid_link_options
function model:rigid_link(options) end

---@class hinge.rigid_link_options
---@field from hinge.node the node that the other one follows; it may be supported
---@field to hinge.node
---"all": displacements and rotations of `to` follow. "xyz": its displacements alone, as if the link ended in a ball
---joint. Default "all"
---@field dofs? "all"|"xyz"

---Makes nodes of a floor move as one rigid body in their plane: their displacements in the plane, and the rotation
---about its normal. Out of the plane they are free. The diaphragm has no mass and does no work. A node belongs to one
---diaphragm, and the rest is as with model:rigid_link. Where floors tilt, the plane stays the one across x, y or z.
---```lua
---local corners = { model:node { 0, 0, 3 }, model:node { 4, 0, 3 }, model:node { 4, 4, 3 }, model:node { 0, 4, 3 } }
---model:diaphragm { nodes = corners } -- a floor, rigid in x and y; the corners are heads of columns
---```
---@param options hinge.diaphragm_options
function model:diaphragm(options) end

---@class hinge.diaphragm_options
---@field nodes hinge.node[] at least two
---across which axis of space the plane lies. Default "z"
---@field normal? "x"|"y"|"z"
---the node that the others follow. Another node may be supported in the plane only where this one is, too. Default the
---first of `nodes`
---@field master? hinge.node

---@class hinge.mass_options
---@field node hinge.node it may be fixed: then the support carries it
---@field mass number kg, above 0
---kg m^2, 0 or above, about axes through the mass. A number is for every axis. { Jx, Jy, Jz } is for the x, y and z
---axes of space, in the undeformed position. Default 0
---@field inertia? number|vec3
---@field offset? vec3 m, from the node to the mass, in the undeformed position; default { 0, 0, 0 }

---Moves supports. The call fixes the given degrees of freedom. In a dynamic run they follow a path, as a displacement
---or a rotation from the position at the start of the run. Rotations are about the axes of space: their rates are those
---of the node about these axes, so that a rotation about one axis may be of any size. Velocity and acceleration follow
---from differences over the last steps. Before the run, the support is taken to move as in the state from which the run
---begins; without such a state it stands still. A path may start and stop suddenly, which is an impact. The work of the
---supports is in the energy balance. In statics the supports stand still; model:settle moves them there.
---```lua
---model:move { node = wall, z = { { 0, 0 }, { 0.1, 0.01 }, { 0.2, 0 } } } -- up by 10 mm and down again
---local shaken = model:dynamic { dt = 1e-3, duration = 0.2 }:finish()
---```
---@param options hinge.move_options
function model:move(options) end

---Makes the structure crooked, without stress: it changes the declared places of nodes, and calls add up. Declare
---nodes, members, joints and supports first: it does not see later ones. No run goes on from one that was made before
---it. Give one of three. sway: the frame is out of plumb, each node by sway times its height above `base`, along
---`direction`. bow: columns are bowed by half a sine wave, `bow` times their length in the middle, along the section's
---axis x or y. Members in line are one column up to a node that is held across the bow: by another member, a support,
---a link; or to a joint that is free about the axis of bending. By default columns in line bow to opposite sides (sign
---= "mode"), as they do where they buckle between such nodes: storeys that bow to the same side hold each other, and
---carry up to half as much again. Columns need eight elements or more; the growth of the moment under compression is
---then 5 % too small, with sixteen 1.3 %: (pi / n)^2 / 3 with n elements, since the two elements of a pair are in
---line. mode: the shape of a mode of run:modes or run:buckling of this model, its largest displacement `largest`;
---members that bend in it need eight elements. sway and bow take numbers, or those of EN 1993-1-1:2005 5.3.2: phi of
---(5.5) for the height from `base` to the highest node and for `columns` in a row; e0 / L of table 5.1 for a buckling
---curve.
---```lua
---local tower = hinge.model {}
---local foot, head = tower:node { 0, 0, 0 }, tower:node { 0, 0, 6 }
---tower:member { foot, head, section = square, material = steel, elements = 8 }
---tower:imperfection { sway = { standard = "EN 1993-1-1", columns = 3 }, direction = { 1, 0, 0 } }
---tower:imperfection { bow = { curve = "a", analysis = "plastic" }, axis = "x" }
---print(head.x) -- 6 m * 1/200 * 2/sqrt(6) * sqrt(0.5 (1 + 1/3)) = 0.0200 m
---```
---@param options hinge.imperfection_options
function model:imperfection(options) end

---@class hinge.imperfection_options
---horizontal over vertical, between -0.2 and 0.2; columns: default 1
---@field sway? number|{ standard?: "EN 1993-1-1", columns?: integer }
---@field direction? vec3 of the sway, horizontal; default { 1, 0, 0 }
---@field base? number m, the height z that stays; default that of the lowest node
---part of the member's length, between -0.1 and 0.1; curve: "a0", "a", "b", "c", "d"; analysis: default "plastic"
---@field bow? number|{ curve: string, analysis?: "plastic"|"elastic" }
---@field axis? "x"|"y" of the bow; default "x"
---"mode" (default): columns in line bow to opposite sides, the lowest one of a line along the axis of its lowest
---member; "same": all bow along the axis of their sections. How columns beside each other bow is not in it: each line
---begins along its axis; for another pattern give the shape of a buckling mode
---@field sign? "mode"|"same"
---@field member? hinge.member of the bow; default: all members, or those of `group`
---@field group? hinge.group_like
---@field mode? hinge.mode
---@field largest? number m, of a mode: its largest displacement; below 0: the other way

---Displaces supports in statics: a settlement, an error of fit, or an end that is rotated. The call fixes the given
---degrees of freedom. A static run moves them in proportion to its load factor, from where it finds them to the given
---displacement at factor 1, whatever `control` it has. A run that goes on from one that has settled moves nothing. The
---work of the supports is in the account `work`. In dynamics the supports stay where they are. It is an error if the
---node belongs to a rigid link, a diaphragm or a joint, and if one of its degrees of freedom has a displacement
---already.
---```lua
---model:settle { node = wall, z = -0.02 } -- m, down
---local settled = model:static { steps = 4 }:finish()
---```
---@param options hinge.settle_options
function model:settle(options) end

---@class hinge.settle_options
---@field node hinge.node|hinge.node[]
---@field x? number m, along x, from the declared position; y and z likewise
---@field y? number
---@field z? number
---rad, component of the rotation vector along x, from the declared position; ry and rz likewise
---@field rx? number
---@field ry? number
---@field rz? number

---@class hinge.move_options
---@field node hinge.node|hinge.node[]
---displacement along x, m, over time, s: a function, or points { { time, displacement }, ... }
---@field x? fun(time: number): number|number[][]
---@field y? fun(time: number): number|number[][] the same along y
---@field z? fun(time: number): number|number[][] the same along z
---@field rx? fun(time: number): number|number[][] rotation about x, rad, over time
---@field ry? fun(time: number): number|number[][] the same about y
---@field rz? fun(time: number): number|number[][] the same about z

---Gravity on every member's mass and on point masses. The weight of members acts along them, as `weight` of hinge.model
---says, and a clamped member of two elements has end moments of w L^2 / 12 and w L^2 / 24 in the middle. Yield goes by
---these, as with loads `q` (model:load). Called again, the last call counts, for runs made after it; it is an error to
---call it for another load case. A dynamic run that goes on from a run without this gravity warns: the weight acts at
---once there.
---```lua
---model:gravity { 0, 0, -9.80665 }
---local rest = model:static():finish()
---```
---@param acceleration vec3 m/s^2, such as { 0, 0, -9.80665 }
---@param load_case? hinge.case|string the load case that it belongs to; default: none
function model:gravity(acceleration, load_case) end

---Gives an initial velocity to a node alone, or to a member or a group as a rigid body. A member between two joints
---that were given a velocity, by one call or by several, moves with them over its whole length, in proportion between
---the two. The inner nodes of a member with a velocity at one end alone begin at rest. The kinetic energy of a node
---alone is that of its point masses and of the part of the elements that is at the node (density * area * length of an
---element / 3, for each one): it becomes smaller with shorter elements. So give a node that is struck the mass that
---strikes it (model:mass), or give the velocity to a member. `hinge plan` and `hinge check` print the kinetic energy
---that a run begins with, and warn of such a node. If several calls give a velocity to a node, the last one counts.
---Statics does not change velocities. A run that continues another run (`from`) begins with the velocities at the end
---of that run. The exceptions are targets whose velocity was declared after that run was made: they begin with it, as
---a rigid body in their present position. So a velocity may be given before or after statics. Fixed degrees of freedom
---stay at rest. It is an error if the target has no others.
---Members that come to a group later bring it their joints, which get its velocity too, unless a later call gave them
---another one. With `angular` they would move the point about which the group turns: then that member is an error.
---```lua
---model:velocity(tip, { 0, 0, -3 }) -- m/s
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }:finish()
---```
---@param target hinge.node|hinge.member|hinge.group_like of a group: its joints
---@param linear vec3 m/s, at the mean position of the target's joints
---@param angular? vec3 rad/s, about that point
function model:velocity(target, linear, angular) end

---Declares when members break: when a limit is reached, or when a function returns true. Limits of the rotation of
---hinges and of the elongation of a member do not depend on the number of elements. Those of strains are the paper's
---(section 2.3, eq 16). The paper gives a critical curvature of 0.0004 without a unit: 0.4 here if it is per
---millimetre, 0.04 if it is per centimetre. Once hinges form, a curvature is the rotation of a hinge over the length of
---its element. So run.warnings says at the end which rotation a limit of curvature means. A rule for a group holds for
---its members, and one without a group for all others, whatever their order. If several rules apply to the groups of a
---member, the last one counts. It is an error if a rule would take the place of another one for all of its members:
---limits that of a function, or a group that of a group within it. A rule that holds for no member, and a function that
---a run never called, is named in run.warnings at the end. An error in a function undoes the step, and is raised at the
---line of the script that asked for the step.
---```lua
---model:fracture { hinge_rotation_x = 0.07, hinge_rotation_y = 0.07, elongation = 0.2 } -- rad, m
---model:fracture(function(section) return section.plastic_work > 500 end) -- J
---```
---@param rule hinge.fracture_rule|fun(section: hinge.section_view): boolean?
function model:fracture(rule) end

---@class hinge.fracture_rule
---rad, plastic, either sign: rotation of a hinge about the section's x axis, the present one, without any elastic part.
---In a section where two elements meet (inside a member, and at a node that joins two members of the same strength and
---the same rule, and nothing else) it is the sum of both. The conventional element has one hinge, in its middle. What
---breaks is the element with the larger part in the rotation. run:hinges lists such rotations
---@field hinge_rotation_x? number
---@field hinge_rotation_y? number rad, about the section's y axis, alike
---m, plastic, tension only: elongation of a member, the sum over its elements; slack does not count. Hinges that bend
---and are pulled elongate as well. A bar that yields over its whole length breaks by it at the same length, however
---many elements it has. It breaks where the largest part is. What is left of a member with a broken element counts by
---itself
---@field elongation? number
---@field curvature_x? number 1/m, either sign
---@field curvature_y? number 1/m, either sign
---@field axial_strain? number no unit; either sign unless tension_only
---no unit, either sign and direction: Q / (G A), mean over the element. It is elastic, because eq 14 has no shear; in
---members that yield it stays below 2 M_p / (L G A), with L of the element. Not in the paper
---@field shear_strain? number
---@field tension_only? boolean default false; true: the axial strain counts in tension only
---which curvature the limits mean. element (default): that of the whole element, eq 16. Rotations of the hinges at its
---two ends cancel where the element bends like an S. section: that at each end. It is the elastic curvature of the
---element, plus the rotation of the hinge at this end over the element's length. The other strains are the element's in
---both. The conventional element has one hinge in its middle, so both mean the same
---@field strain_measure? "element"|"section"
---true: the limits count only where the section is fully plastic in the step. Members that cannot yield then never
---break by limits. Default false
---@field plastic_only? boolean
---a function that is called for a section where no limit is reached. If it returns true, the element breaks. The
---argument is the same object at every call; it can be read only while the function runs
---@field rule? fun(section: hinge.section_view): boolean?
---the sections for which `rule` is called. plastic (default): those that are fully plastic in this step, and those that
---were fully plastic before, when a curvature or the axial strain of their element is larger than ever before. A rule
---that uses such strains therefore misses nothing. yielded: all that were ever fully plastic. all: all sections.
---Sections of members that cannot yield are always included
---@field where? "plastic"|"yielded"|"all"
---names of numbers that are kept for each section, such as { "damage" }. They are fields of the section that the rule
---can set, 0 at the start. They belong to the state of the run
---@field keep? string[]
---in place of `rule`: a function that is called once a step with all elements of the members. It returns a list with
---the positions of those that break. It has no memory: `keep` and `where` beside it are an error, since they belong to
---single sections
---@field batch? fun(elements: hinge.element_list): integer[]?
---@field group? hinge.group_like only its members, default all

---The section that a fracture rule gets, with the values at the end of the step. Strains are those of the element: the
---sum of elastic and plastic, the plastic part, and the change over the step divided by dt. The rotation of a hinge is
---that of the section.
---@class hinge.section_view
---@field time number s
---@field dt number s
---@field step integer from 1
---@field member integer from 1, as member.index
---@field element integer from 1, counted over the whole model; messages and member:state count within the member
---@field end integer end of the element, 1 or 2; written section["end"], since end is a keyword of Lua
---@field node integer? index of the joint at this section; nil: it is inside the member
---@field group string? name of the member's first group
---@field plastic boolean fully plastic in this step
---@field curvature_x number 1/m
---@field curvature_y number 1/m
---@field axial_strain number
---@field twist number 1/m, including full turns
---@field plastic_curvature_x number 1/m
---@field plastic_curvature_y number 1/m
---@field plastic_axial_strain number
---@field plastic_twist number 1/m
---@field curvature_rate_x number 1/(m s)
---@field curvature_rate_y number 1/(m s)
---@field axial_strain_rate number 1/s
---@field twist_rate number 1/(m s)
---@field Mx number N m
---@field My number N m
---@field N number N
---@field Mz number N m
---@field f_y number yield function of the section's law, 1 where it is fully plastic
---@field plastic_work number J, of the element up to now
---@field shear_x number elastic: Q / (G A), mean over the element; Q = dM_y/dz
---@field shear_y number Q = dM_x/dz
---rad, plastic; positive like curvature_x. What the limit of this name is compared with: the sum of both sides where
---two elements meet in the section
---@field hinge_rotation_x number
---@field hinge_rotation_y number rad
---@field broken number 0

---All elements of the members of a fracture rule, always in the same order. `count` is their number (also `#elements`).
---Every field of a section has an array with one number for each element. Mx, My, f_y, hinge_rotation_x,
---hinge_rotation_y, node and plastic have one array for each end (Mx1, Mx2, ...); node is 0 inside a member, plastic is
---1 or 0. Loads along a member change N and Mz along it; the arrays have those of end 1. Broken elements keep their
---positions, with broken = 1 and zeros. An array is the same table at every step; it is filled when the function reads
---it.
---@class hinge.element_list
---@field count integer
---@field time number s
---@field dt number s
---@field step integer

---Takes a member, or all members of a group, out of the structure at a time of the run: the sudden loss of a column.
---All elements of it break at the end of the first step that reaches the time, as by a fracture rule, whatever their
---strains and with the same energy balance (run.energy.fracture). What is left are two halves without strength, which
---keep their mass and move with the joints at the member's ends; with four elements or more the part between falls by
---itself. It goes beside fracture rules. events.csv has it as a fracture with the limit "removed". A group means the
---members that it has in the run. It acts in dynamics; statics keeps the member. A run that goes on from one in which
---the time was reached has the member removed already. If the time was reached before the run begins, the member goes
---at the end of the first step. With `over` the forces that the member had put on the joints that keep other members
---stay there at first, and fall to nothing in a straight line over that time; their work is in run.energy.work.
---```lua
---model:remove { member = beam, at = 0.005 } -- s
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }:finish()
---print(beam:state(swing)) -- broken
---```
---@param options hinge.removal_options
function model:remove(options) end

---@class hinge.removal_options
---@field member? hinge.member one of member and group
---@field group? hinge.group_like
---@field at number s
---@field over? number s, in which its forces fall to nothing; default 0: it is gone at once

---Heats members. Their temperature is given. A heated member gets longer by the strain of `properties` at this
---temperature, and its stiffness and its strength are those parts of the declared ones. What is free to lengthen takes
---no force; what is held is pressed. Of several declarations for one member the last one counts. Statics heats from
---where the run begins, 20 degrees Celsius at first, to the temperature, as the load factor goes from 0 to 1; as a
---load, heat may belong to a load case. A temperature over time acts in dynamics; statics keeps what it is at the time
---of the run. In dynamics a number is there from the start: what it presses beyond yield begins on the yield surface,
---with its plastic work, and the run warns. The energy balance has the account `heat`; what heat has done before the
---first step of dynamics is in `initial`. It does not go with integrator = "energy-momentum". Source: EN
---1993-1-2:2005, 3.2 and 3.4.
---```lua
---local hot = hinge.model()
---local left, right = hot:node { 0, 0, 0 }, hot:node { 4, 0, 0 }
---local beam = hot:member { left, right, section = square, material = steel }
---hot:fix(left, "all")
---hot:fix(right, "all")
---hot:heat { member = beam, temperature = 50 } -- degrees Celsius
---print(beam:forces(hot:static {}:finish()).N) -- below 0: it is pressed
---```
---@param options hinge.heat_options
function model:heat(options) end

---@class hinge.heat_options
---one of member and group; neither: all members
---@field member? hinge.member
---@field group? hinge.group_like
---degrees Celsius, in the middle of the section: a number, points { { time in s, temperature }, ... } between which it
---is linear, or a function of the time
---@field temperature number|number[][]|fun(time: number): number
---K, how much hotter the side of the section at +y (`up`) is than that at -y. A member that is free bends to the other
---side. Default 0
---@field across_y? number|number[][]|fun(time: number): number
---@field across_x? number|number[][]|fun(time: number): number K, the side at +x and that at -x; default 0
---@field properties? hinge.heat_properties default: hinge.heat.steel()
---@field case? hinge.case_like load case that it belongs to; default: none. For a temperature that is a number

---Makes members too short or too long: prestress. Several declarations for one member add up. It grows with the load
---factor of statics, and in dynamics it is there from the start, as heat is. Its work is in the account `heat` of the
---energy balance.
---```lua
---local tight = hinge.model()
---local left, right = tight:node { 0, 0, 0 }, tight:node { 4, 0, 0 }
---local tie = tight:member { left, right, section = square, material = steel }
---tight:fix(left, "all")
---tight:fix(right, "all")
---tight:prestress { member = tie, force = 1e4 } -- N
---print(tie:forces(tight:static {}:finish()).N) -- 10000.0
---```
---@param options hinge.prestress_options
function model:prestress(options) end

---@class hinge.prestress_options
---@field member? hinge.member one of member and group
---@field group? hinge.group_like
---without force the member is longer by this part of its length; below 0: shorter, so that it pulls. -0.1 to 0.1. One
---of strain and force
---@field strain? number
---@field force? number N, above 0 tension: what the member would have between ends that do not move
---@field case? hinge.case_like load case that it belongs to; default: none

---Declares which members can touch each other, and how. surface (the default): bars press on each other where their
---axes come closest. Each bar is round; its radius is half the smaller side of its section. A penetration g stores the
---energy k g^2 / 2. Only friction dissipates energy. gap (section 2.4, eqs 17-19): four gap elements tie two elements
---together for a while. The energy that they store is given back when the bars part. Members that share a joint, or
---that overlap when they are first checked, have no contact until they have parted. A run warns of members of different
---bodies that overlap where it begins. Each call adds a rule. A rule with groups or between holds for its pairs,
---wherever a rule for all members is declared. If several such rules fit the groups of both members, the last one
---counts.
---```lua
---local bar = model:member { model:node { 0.5, -0.5, 0.06 }, model:node { 0.5, 0.5, 0.06 }, section = square,
---  material = steel, group = "bar" }
---model:velocity("bar", { 0, 0, -5 })
---model:contact { between = { "bar", "arm" }, friction = 0.3 }
---local hit = model:dynamic { dt = "auto", duration = 4e-3 }:finish()
---print(hit.contacts.bound, bar:state())
---```
---@param rule? hinge.contact_rule
function model:contact(rule) end

---@class hinge.contact_rule
---@field rule? "surface"|"gap" default surface
---@field groups? hinge.group_like[] only members of these groups; default: all
---@field between? hinge.group_like[] in place of groups: two groups, one for each member of a pair
---a function that is called once for two members, when they come near each other. nil or true: the numbers of this
---rule. false: they never have contact. A table: other numbers (rule, stiffness, friction, binding_time, release,
---contact_length, coplanarity_tolerance)
---@field pairs? fun(a: hinge.member, b: hinge.member): boolean|hinge.contact_rule|nil
---a function that is called at the end of a step in which two elements were tied (gap), or two members began to press
---on each other (surface: once for each contact, with the elements that were deepest in each other)
---@field on_contact? fun(event: hinge.contact_event)
---@field on_release? fun(event: hinge.contact_event) the same, when they were released or parted
---surface: k of one contact of two members, N/m, wherever their elements end. Default EA / L: EA is the harmonic mean
---of the two members, L is their mean length, or the sum of their half depths where that is more
---@field stiffness? number
---@field friction? number surface: Coulomb's coefficient, default 0; contact_released of run.energy has its heat
---@field binding_time? number gap: default 0.5e-3 s
---gap: when a tie is released. parting (default): after the binding time, as soon as the bars part and little energy is
---stored; this energy is given back as an impulse. time: at the binding time, as in the paper; the stored energy is
---lost
---@field release? "parting"|"time"
---@field contact_length? number gap: C_l of eq 18, default 1.8
---@field coplanarity_tolerance? number gap: alpha of eq 19, default 3e-4 m^3
---default true: a pair is checked only when it could have come into contact. false: every pair is checked at every
---step; the results are the same to the bit, at several times the cost
---@field sleep? boolean
---gap: eqs 17-19 as printed, default false. They are checked only at the beginning of a step, so fast members can pass
---through each other. release is then "time"
---@field as_printed? boolean
---with as_printed: how eq 19 takes f of eq 17. absolute (default): |f| <= alpha. as printed: f <= alpha. f is negative
---on one side of an element, so that eq 19 holds there at any distance. Which side it is depends on the order of the
---elements and of their ends
---@field sign_of_f? "absolute"|"as printed"

---@class hinge.contact_event
---@field time number s
---@field a hinge.member
---@field b hinge.member
---@field element_a integer
---@field element_b integer

---Adds a connector: springs, dashpots, curves and laws along three axes and about them. It connects two nodes, { a, b,
---... }, or a node and the ground at the declared position of the node, { node, ground = true, ... }. Several parts in
---one direction add up. A direction without any part is free. Node a carries the connector at the end of a rigid arm
---that reaches to b. The deformation is the displacement of b from the end of that arm, along the axes (m), and the
---rotation vector of b relative to a (rad). Both are zero in the declared position. In large displacement the axes
---rotate with a; those of the ground do not rotate. The force pulls b back and pulls a along. It also gives its moment
---to a, so momentum is kept. In statics dashpots have no force. Explicit steps must be shorter than 2 / (d + sqrt(d^2 +
---w^2)). Here w^2 (1/s^2) and d (1/s) are upper bounds of k/m and c/m. They are summed over all connectors at a node,
---with the lumped masses of the nodes and the highest frequency of the members there. dt = "auto" keeps this limit.
---Newmark's steps are then at most 0.9 / w, with w of the springs alone. Laws of a script are not in these limits. The
---energy is in run.energy.connector_stored and connector_dissipated. It is an error if the connector has no part that
---acts. It is also an error to make a run with such a node that belongs to no member, or with too long an explicit
---step.
---```lua
---model:connector { tip, ground = true, stiffness = { z = 1e5 }, damping = { z = 200 } } -- N/m, N s/m
---local other = model:node { 1, 0, -1 }
---model:fix(other)
---local rope = model:connector { tip, other, stiffness = { z = 1e6 }, capacity = { z = 5e3 } } -- parts at 5 kN
---```
---@param options hinge.connector_options
---@return hinge.connector
function model:connector(options) end

---@class hinge.connector_options
---@field [1] hinge.node a
---@field [2]? hinge.node b; left out with ground = true
---@field ground? boolean true: the other end is the ground; default false
---@field axes? { x: vec3, y: vec3 } default: global; y is made normal to x, z is normal to both
---N/m along x y z, N m/rad about them; 0 or above
---@field stiffness? { x?: number, y?: number, z?: number, rx?: number, ry?: number, rz?: number }
---N s/m along x y z, N m s/rad about them; 0 or above
---@field damping? { x?: number, y?: number, z?: number, rx?: number, ry?: number, rz?: number }
---for a direction, points { { deformation, force }, ... } (m, N; rad, N m). The curve is elastic and linear between the
---points, and goes on in a straight line beyond the last one. Points from { 0, 0 } on hold for both signs; else they go
---from below 0 to above 0
---@field curve? { x?: number[][], y?: number[][], z?: number[][], rx?: number[][], ry?: number[][], rz?: number[][] }
---for a direction, a function of four arguments: deformation (m, rad), its rate (m/s, rad/s), state, and dt (s; 0 where
---no time passes). It returns the force (N, N m), and if it keeps a state, the new state. The state is a table of
---numbers by name. It is empty at first. If the function returns no state, the state does not change. The state belongs
---to the run: it is undone with a step and is kept in checkpoints. The function is called several times a step, each
---time with the state at the end of the last step. All of its work counts as dissipated. An error undoes the step, and
---is raised at the line of the script that asked for the step
---@field law? { x?: function, y?: function, z?: function, rx?: function, ry?: function, rz?: function }
---N, N m. If the force in one direction, of either sign, has reached this value at the end of a step, the whole
---connector breaks. The energy that it stored is lost. run.state_changes and events.csv list the break, and run:hinges
---rates the largest force so far by it. Default: it never breaks
---@field capacity? { x?: number, y?: number, z?: number, rx?: number, ry?: number, rz?: number }

---A connector, made by model:connector. Its methods read the given run, or by default the latest run of its model.
---@class hinge.connector
local connector = {}

---The deformation of the connector, m and rad. For a broken one it is the deformation at which it broke.
---```lua
---local spring = model:connector { tip, ground = true, stiffness = { z = 1e5 } }
---model:static():finish()
---local _, _, z = spring:deformation()
---```
---@param run? hinge.run
---@return number x, number y, number z, number rx, number ry, number rz
function connector:deformation(run) end

---The force that pulls b back, N and N m, along the axes. It is 0 once the connector is broken.
---```lua
---local spring = model:connector { tip, ground = true, stiffness = { z = 1e5 } }
---model:static():finish()
---local _, _, fz = spring:force()
---```
---@param run? hinge.run
---@return number x, number y, number z, number rx, number ry, number rz
function connector:force(run) end

---The time at which the connector broke, s; false while it is not broken.
---```lua
---local hook = model:connector { tip, ground = true, stiffness = { z = 1e5 }, capacity = { z = 100 } }
---model:dynamic { dt = 1e-4, duration = 0.02 }:finish()
---print(hook:broken()) -- s, or false
---```
---@param run? hinge.run
---@return number|false
function connector:broken(run) end

---Joins node b to node a at the same place: b stays where a is, and moments resist its rotation relative to a. So a
---panel zone stands between the columns at one node and the beams at another, or a hinge that several members share.
---The moments are about the axes, which rotate with a. Of the joint the moments and their capacities count; one with
---`tension` or `shear` is an error. When it breaks, b is free to move. Both nodes need a member. b follows no other
---node: it is no follower of a rigid link or of a diaphragm; a may be. Rigid axes are springs, as in hinge.joint, of
---the stiffest member at the two nodes. It does not go with the energy-momentum method.
---```lua
---local columns_at, beams_at = model:node { 1, 0, 0 }, model:node { 1, 0, 0 }
---local post, girder = model:node { 1, 0, -3 }, model:node { 5, 0, 0 }
---model:fix { post, girder }
---model:member { post, columns_at, section = square, material = steel }
---model:member { beams_at, girder, section = square, material = steel }
---local panel = model:joint { columns_at, beams_at, joint = hinge.joint { Mx = { stiffness = 1e8, strength = 2e5 } },
---  axes = { x = { 0, 1, 0 }, y = { 0, 0, 1 } } } -- x: across the frame
---model:static():finish()
---print(panel:state().Mx, panel:state().rotation_x)
---```
---@param options hinge.node_joint_options
---@return hinge.node_joint
function model:joint(options) end

---@class hinge.node_joint_options
---@field [1] hinge.node a
---@field [2] hinge.node b, at the same place
---@field joint hinge.joint
---@field axes? { x: vec3, y: vec3 } default: global; y is made normal to x, z is normal to both

---A joint between two nodes, made by model:joint.
---@class hinge.node_joint
local node_joint = {}

---What the joint is where the run stands, or the latest run of the model.
---```lua
---local here, there = model:node { 1, 0, 0 }, model:node { 1, 0, 0 }
---local foot, far = model:node { 1, 0, -3 }, model:node { 5, 0, 0 }
---model:fix { foot, far }
---model:member { foot, here, section = square, material = steel }
---model:member { there, far, section = square, material = steel }
---local spring = model:joint { here, there, joint = hinge.joint { Mx = { stiffness = 1e6 } } }
---model:static():finish()
---print(spring:state().Mx, spring:state().broken)
---```
---@param run? hinge.run
---@return hinge.node_joint_now
function node_joint:state(run) end

---@class hinge.node_joint_now
---@field Mx number N m, that the joint puts on a
---@field My number N m
---@field Mz number N m
---@field rotation_x number rad, of b relative to a; of a broken joint, where it broke
---@field rotation_y number rad
---@field rotation_z number rad
---@field broken number|false s

---Rayleigh damping in dynamics, C = alpha M + beta K of each element (Rayleigh 1877, section 81): by its coefficients,
---or by ratios of critical damping at two periods, between which there is less and outside of which more. alpha damps
---the velocity relative to the supports: along x, y and z each relative to the mean velocity of those supports of the
---same body that are held in that direction (whole elements and connectors join a body; a support that does not move
---counts with zero). So a structure that moves with its ground is not damped. Where supports move differently that
---mean is a simplification: the rest of their motion is damped. The work of the moving supports on alpha is part of
---run.energy.work. A body without supports, also one that has broken off, is damped by its velocity in space, in
---flight and rotation as a whole too. `hinge check` and `hinge run` warn of bodies that are free from the start,
---unless alpha is given with a group of such bodies only; give alpha with a group, or beta alone, where parts may
---break off and fly. beta damps the elastic rates of the element's own deformation, beta k (d' - d_p') with the elastic
---stiffness k. So it damps no rigid motion, and no rotation of a plastic hinge, with any number of elements. Yield is
---decided by the elastic forces alone. Semi-rigid joints, panel zones (hinge.joint, model:joint) and the springs and
---curves of connectors, those to the ground too, take part with beta k of their own; the slip of a joint that yields is
---free, and rigid axes have no damping. A joint at a member's end has the beta of the member; a joint between nodes and
---a connector have the mean of the members' elements at their nodes. joints = false leaves them out. The moments and
---forces that a script reads of joints and connectors, and their capacities, are without that damping. A point mass
---(model:mass), its rotary inertia and its offset with it, has the alpha of the members at its node; where they differ,
---as by groups, their mean. A broken element is damped no more, nor is the mass left of it, and it no longer counts in
---that mean: a point mass whose members have all broken off flies undamped. Of several calls the last one that applies
---to a member's groups counts, so that alpha = 0 with a group leaves it undamped. The energy that it dissipates is in
---run.energy.damping. With explicit steps beta shortens the longest stable step (dt = "auto" includes this); Newmark's
---method takes predictor "displacement" where damping is as strong as that. It does not act in statics.
---```lua
---local alpha, beta = model:damping { ratio = 0.02, periods = { 0.2, 0.02 } } -- 2 % of critical at both
---```
---@param options hinge.damping_options
---@return number alpha 1/s
---@return number beta s
function model:damping(options) end

---@class hinge.damping_options
---0 or above and below 1, of critical damping: at both periods, or one each. Those that ask for a negative coefficient
---are refused
---@field ratio? number|number[]
---@field periods? number[] with ratio: two, s, such as those of the first mode and of the highest that counts
---@field alpha? number 1/s, in the place of ratio and periods: of M, 0 or above, default 0
---@field beta? number s, likewise: of K, 0 or above, default 0
---@field group? hinge.group_like only its members, default all
---@field joints? boolean false: beta does not damp the joints and connectors at these members; default true

---Adds a ground on which members can fall: the half space behind a plane. It pushes and never pulls. There are two
---laws.
---
---The default is a layer of springs and dashpots per area, which takes the energy of what lands. It presses with
---layer_stiffness o + layer_damping o' (N/m^2) on the area that a member touches it with, o (m) the overlap and o' its
---rate: the smaller side of the section times the length that touches, and at an end of a member the area of the
---section. Of the first counts the part sin^2, of the second cos of the angle between the axis and the normal. What
---lands is stopped in the same way with any number of elements.
---
---With `stiffness` or `restitution` the ground is points on elastic springs instead. The points are the nodes, also
---those inside members, and the free ends of broken members. An overlap o stores k o^2 / 2.
---
---In both, members are round, with half the smaller side of the section as radius. Each call adds a plane. Nodes whose
---displacements are fixed do not touch. What touches when the run begins is at rest there. What has its axis below the
---plane when the run begins is left out until it has left the ground. The ground acts in statics too, with the springs
---alone; statics needs supports. run.energy then has ground, the sum of ground_stored (now) and ground_dissipated (by
---the dashpots, friction and restitution, and what was stored where an end breaks off), J.
---```lua
---model:ground { point = { 0, 0, -0.05 }, friction = 0.5 }
---```
---@param plane? hinge.ground_plane
function model:ground(plane) end

---@class hinge.ground_plane
---@field point? vec3 m, on the plane; default {0, 0, 0}
---@field normal? vec3 direction out of the ground, of any length above 0; default {0, 0, 1}
---Coulomb's coefficient, 0 or above, default 0. It acts where the surface touches. What sticks is held by a spring
---along the plane: of points 0.4 k, of the layer 100 times what it presses with on half an element or on an end face.
---If the pressure becomes too small for the force of this spring, the surface slips by the difference. Under shaking it
---therefore creeps a little
---@field friction? number
---N/m^3, above 0; default 1e8, the modulus of subgrade reaction of dense sand (64 to 128 MN/m^3: Bowles, Foundation
---Analysis and Design, 1996, table 9-1). A steel bar of 0.1 m that lies flat settles by 0.08 mm, a column of 3 m that
---stands on its end by 2.3 mm. Not with `stiffness` or `restitution`
---@field layer_stiffness? number
---N s/m^3, 0 or above; default 2e6. This value is chosen, not measured: a steel column of 3 m that lands on its end
---then keeps about a quarter of its speed (damping 0.65 of critical), and what lands flat keeps none. Waves into dense
---sand take a third of it (Lysmer: density times wave speed); the rest stands for soil and rubble that are crushed.
---Both are part of the limit of explicit steps and of dt = "auto"; light members shorten them by up to a half. Not with
---`stiffness` or `restitution`
---@field layer_damping? number
---asks for points: k of each point, N/m, above 0. Default: 0.4 EA / L of each element that meets there, which keeps
---explicit steps stable. A fall at speed v then penetrates by about v / (0.9 c) L, where c is the speed of sound. A
---given value is part of the limit of explicit steps and of dt = "auto", like the stiffness of connectors. This does
---not include free ends of members that break in the run
---@field stiffness? number
---asks for points: 0..1, the part of the normal velocity that a point keeps when it comes out of the ground, by
---Newton's law of impact, as a sudden impulse. Points of one body that come out at nearly the same time get their
---impulses together. Default with `stiffness`: 1, the springs alone, which dissipate nothing; vibration of the member
---still takes its part. It is the velocity of the points: a bar that lands flat comes back with this part of its speed,
---but an elastic bar that lands on its end comes back with 0.8 to 1 of it whatever this is, and the more so the more
---elements it has, because one of its nodes alone touches the ground. Where restitution below 1 comes with friction,
---explicit steps as long as dt = "auto" takes miss several percent of the energy, and a run may end for that; 0.4 of
---that step misses 0.3 % in the mean
---@field restitution? number
---@field group? hinge.group_like only members of this group; default: all

---Returns the group with this name, to which members were added.
---```lua
---local arm = model:group "arm"
---print(#arm, arm.length, arm.mass)
---```
---@param name string
---@return hinge.group
function model:group(name) end

---Returns the size of the model. A member with elements = "auto" counts as two elements until the first run decides.
---```lua
---local counts = model:counts()
---print(counts.members, counts.elements, counts.free_dofs)
---```
---@return { members: integer, elements: integer, nodes: integer, free_dofs: integer }
function model:counts() end

---Makes a static run. Loads and gravity are brought to equilibrium in steps. In large displacement the run reports
---where it passes a limit point or a branching point: run.instability. This is the buckling of the model with its
---elements. Two asi-gauss elements show that a pinned member buckles at 1.000 times Euler's load. With p_delta =
---"chord", two do so at 2.27 times, four at 1.10, eight at 1.024, sixteen at 1.005. A member of two elements that is
---compressed beyond Euler's load between clamped ends cannot bend out; it counts as unstable. Under load control, an
---elastic step that took many iterations is reversed as a trial. If the trial does not lead back to the start, the step
---has jumped over a snap-through, and the run ends before it. Take several steps all the same, since no trial finds
---every jump. In large displacement a structure may have a plateau of plastic hinges, after which it carries more load
---again. The size of the steps decides whether the run stops at the plateau or passes over it. run.warnings says where
---one may have been passed. displacement = "small" gives a plastic limit load for any steps. Lateral-torsional
---instability of beams is included. Beams resist it by bending and torsion (G J) only, and not by warping. A floor
---holds them only if the model has one.
---```lua
---local rest = model:static():finish()
---local pushed = model:static { control = { node = tip, "uz", to = -0.1 }, steps = 20 }:finish() -- down by 0.1 m
---print(pushed.verdict, pushed.factor) -- the load that takes, as a factor of those of the model
---```
---@param options? hinge.static_options
---@return hinge.run
function model:static(options) end

---@class hinge.static_options
---number of steps, default 10. For arc length it is the largest number; run.reason says if that is too few to reach the
---load factor. A step without equilibrium is halved, down to 1e-5 of the whole way. It is still one step for
---run:steps(), run.index and history.csv. A limit load may make the last step shorter. A try is given up before its
---last iteration if Newton's method makes no more progress
---@field steps? integer
---equal steps of load (default), arc length, or one degree of freedom driven to a value (m, rad): to the displacement
---that run:displacement gives, which goes on from that of `from`; an error where it has it already. Driven, a step that
---leads to an equilibrium that cannot be held there is halved: it would have leapt to another branch. Where no step is
---short enough, the path itself has come past a branching point: the run goes on, and run.reason says so. Heat,
---prestress and settlements follow the load factor as loads do, and may be all that acts
---@field control? "load"|"arc"|{ node?: hinge.node, [1]: hinge.component|"arc", to: number }
---load control after the structure has become unstable (large displacement). fail (default): the run ends. Its state is
---the last stable equilibrium. A step that ends on another branch of equilibria is no instability: it is shortened,
---down to 1e-3 of the load factor and further, and the run goes on. continue: the run goes on past the instability.
---run.instability says where it was unstable, run.reason says
---whether the state at the end is stable, and run.warnings says where it may have jumped to another branch. The steps
---decide to which branch it comes. A step that jumps over a whole snap-through at once, at many times the limit load,
---may still go unnoticed: use short steps
---@field unstable? "fail"|"continue"
---the shape of a mode, as run:buckling or run:modes gives it: the first step sets off along it, to the side of `to`,
---and so onto the branch that a perfect structure has beside its straight path. It goes with control = { node =, ... },
---which drives a displacement that is large in the shape, and is best from a state near the branching point. Default:
---none
---@field branch? hinge.mode
---true: load control up to the limit load. If the run finds no further equilibrium, or if the structure becomes
---unstable, the verdict is "completed" and run.limit = true. run.factor is then the factor of the limit load. Default
---false
---@field to_limit? boolean
---@field fixed_group? hinge.group_like a group that does not move during this run
---the run whose state this run begins from. A run that has not ended must be finished or stopped first. In a model with
---load cases, the loads at the end of that run stay; the factor of this run, from 0 to 1, adds the difference to
---`loads`. So a push-over under dead load is two runs. In a model without load cases, all loads are applied again from
---0
---@field from? hinge.run
---true: this run may complete although `from` failed, or ended at a limit load or before its load factor. Default
---false: a run that goes on from such a state counts as failed when it has ended, and run.reason says from which run
---@field allow_failed? boolean
---the load cases that act, as { dead = 1.35, live = 1.5 }, or the name of a combination or a case. It is needed if the
---model has cases. A case that is not named has its factor in `from`, else 0
---@field loads? table<string|hinge.case, number>|string|hinge.case
---@field iterations? integer the most iterations of a step before it is halved; default 30
---@field tolerance? number largest unbalanced force, as a part of the acting forces; default 1e-9
---@field record? integer|false steps between rows of history.csv; default 1; false: this run writes no history.csv

---Makes a dynamic run. Damping comes only from model:damping and rho_infinity. The default is Newmark's beta method (eq
---15). The explicit method uses central differences with lumped masses: a pair of elements has 1/6, 4/6 and 1/6 of its
---mass on its three nodes, so that every member has its mass, its centre and its moment of inertia m L^2 / 12. The
---members of an odd number of elements, three or more, have them too; a member of one element has half of its mass on
---each node, and m L^2 / 4. The rotary inertia is the section's polar one. Explicit steps solve no system of equations.
---These options are therefore errors with them: precision, beta, rho_infinity, iterations, tolerance, predictor,
---geometric, rebuild_angle and those of the solver.
---
---The energy-momentum method (Simo and Tarnow 1992, Simo and Wong 1991, Gonzalez 1996) is for structures that rotate
---far in long steps. With displacements x, momenta p, mean forces f and F of a step: (p' - p)/dt + f = F, x' - x = dt
---(v + v')/2. The work of the mean forces of the elements is exactly the change of their strain energy and the
---dissipation in their hinges, (p + p')/2 of dd_p. These forces are in balance at the middle of the step. So energy and
---both momenta are kept, to the tolerance of the iterations, for steps of any length. Forces of effects, and loads, are
---the mean of the two ends of a step. Connectors therefore keep the energy to second order only. With rigid offset
---masses it is kept to some 1e-3. The method is of second order, and takes some 5 to 10 iterations a step. The rotary
---inertia of the sections rotates with the nodes. Accelerations and reactions are the means of the last step. A step
---that does not converge is undone and halved (step_control, here 0.01 by default). The method does not work with
---contact, fracture, ground, moving supports, displacement = "small" and shift = "elastic_and_plastic". These options
---are errors with it: beta, rho_infinity, predictor, precision.
---```lua
---model:velocity(tip, { 0, 0, -3 })
---local swing = model:dynamic { from = run, dt = 1e-4, duration = 0.02 }:finish()
---print(swing.verdict, swing.energy_error)
---```
---@param options hinge.dynamic_options
---@return hinge.run
function model:dynamic(options) end

---@class hinge.dynamic_options
---s. "auto" with newmark: twelve steps in the time that an axial wave needs to cross the shortest element; where
---members can yield up to four times as many, if the shear vibration of an element needs them (with more, Newton's
---method takes their place). The steps are eight times longer while nothing yields, breaks or touches and the
---accelerations hardly change. "auto" with explicit: 0.9 of the stability limit, 0.45 if members can yield, 0.35 with
---surface contact, 0.2 with gap contact. A number above the limit is an error, which names the element. Stiff
---connectors, and a given stiffness of a ground, shorten both
---@field dt number|"auto"
---@field duration number s; rounded to whole steps if dt is a number
---@field integrator? "newmark"|"energy-momentum"|"explicit" default newmark
---the run whose state this run begins from, such as rest under gravity. A static run must be finished or stopped first.
---Every such run must have done at least one step. If it failed, its last good state is used (see allow_failed).
---From a dynamic run of which nothing but the duration has changed (model, loads, dt, integrator, settings; no new
---velocity) this run goes on to the bit as that one would have. Its energies, warnings and hinges count from its own
---start. Two things hang on the duration and may tell a run from its halves: dt = "auto", and step control once it has
---undone a step (each step has its share of the duration). Where something has changed, the acceleration and the
---stiffness are found anew: the motion differs by 1e-12 to 1e-5 of itself, and where members yield or touch by what a
---hinge or a contact makes of that
---@field from? hinge.run
---true: this run may complete although `from` failed, or ended at a limit load or before its load factor. Default
---false: a run that goes on from such a state counts as failed when it has ended, and run.reason says from which run
---@field allow_failed? boolean
---the load cases that act, as in static_options. Default: those of `from`, with the factors at its end. A case that was
---declared after that run must be named
---@field loads? table<string|hinge.case, number>|string|hinge.case
---the largest energy error, as a part of the largest energy (see run.energy_error). Beyond it the run ends with the
---verdict "failed". It also ends if the error grows between two checks by more than half of energy_tolerance (1 % where
---that is more). Default 0.01; 0.1 with explicit steps, whose energy swings with the fastest vibrations; 0 with shift =
---"elastic_and_plastic", whose energy balance cannot close. 0: no check. A run that completes with more than 0.01, at
---its end or at an earlier check, says so in run.warnings, whatever energy_tolerance is. The error is checked every 100
---steps, or 20 times in a short run, and at the end. With explicit steps it is also checked, for the warning alone, at
---every step in which the fastest vibrations may make it large. The state of a failed run is that of the last check at
---which the balance closed (models of up to 200 000 elements); run.energy_error and the last row of history.csv are
---those of the check that failed. run.reason ends with a setting that held from that state to 20 steps beyond the
---failure, in a short trial that calls no function of the script and recovers the forces of at most 1.5 million
---elements, some 1 to 3 s. If the model has such functions, it names a setting that was not tried
---@field energy_tolerance? number
---0..1, the energy error that the whole run may have, as a part of the largest energy (see energy_tolerance). A step is
---undone if its error is more than its share of this, if it would rotate a node by more than 0.5 rad, or if it cannot
---be solved. It is tried again with half the length, down to dt / 1024; below this the run fails. The script never sees
---a step that was undone. After steps with small errors the step becomes longer again, up to dt. A number checks the
---energy balance every step, which takes half to three quarters of the time of a step more. It is an error with shift =
---"elastic_and_plastic", whose energy balance cannot close. 0: every step is kept, and a step that cannot be solved
---ends the run. Default with newmark, if dt = "auto", if members can yield or if forces can begin or end suddenly
---(contact, ground, fracture, connectors that break, loads that are functions of the state): 0.001, in a milder form.
---The balance is checked when the motion changes abruptly, else every 1 to 32 steps. Half of the 0.001 may be lost at
---any time. Shorter steps may lose more (dt / 8: 0.002, dt / 64: 0.005). While the energy of the run still comes in,
---the error may come to 0.005. What dt / 64 still loses is kept, up to an energy error of 0.01; beyond that the run
---fails, whatever energy_tolerance is. While no step is undone, no bit changes. Default with energy-momentum: 0.01,
---every step
---@field step_control? number
---@field rest? boolean true (default): a body at rest in equilibrium is not computed until something acts on it
---threads that share the work of a step; default 1; results are the same to the bit for any number
---@field threads? integer
---@field beta? number Newmark's, default 0.25; the paper takes 0.4 with contact
---0..1, the part of the amplitude of the highest frequencies that a step keeps. Below 1 it is Newmark's method with
---alpha of Wood, Bossak and Zienkiewicz (1980): alpha = (rho - 1)/(rho + 1), beta = 1/(1 + rho)^2 and gamma = 1/2 -
---alpha. The method is of second order. The energy that it takes out of slow motion is of third order.
---run.energy.numerical counts this energy, which costs a third of a step. Over millions of steps, 0.99 keeps rounding
---errors from growing in vibrations that are too fast for the step. Default 1: no dissipation
---@field rho_infinity? number
---1: one solution a step, as in the paper. More than 1: Newton's method, until the correction is below tolerance of the
---first one of the step. 0 (default): one solution a step. Newton's method is used if hinges form or displacements are
---large, in steps that are too long for one solution; the fastest vibration decides which steps are too long
---@field iterations? integer
---@field tolerance? number see iterations; default 1e-10, energy-momentum 1e-8
---the start of the solution of a step: the last acceleration, or the last displacement (eq 15 as printed). auto
---(default): "acceleration" if dt is shorter than an axial wave needs to cross the shortest element, else
---"displacement"
---@field predictor? "auto"|"acceleration"|"displacement"
---@field geometric? boolean include initial stress in the effective stiffness; default true
---rad; an element's stiffness is computed anew after a rotation by this angle; default 0.01, energy-momentum 0.002
---@field rebuild_angle? number
---number format of the effective stiffness. single (default): half the memory; it changes the energy in Case I by
---2e-10. Double is used in any case if steps are longer than the fastest waves need
---@field precision? "single"|"double"
---@field solver? "cg"|"direct" conjugate gradients (default) as in the paper, or a direct solver
---@field solver_tolerance? number of the residual; default 1e-8
---@field solver_iterations? integer the most iterations of a solution; default 500
---steps between rows of history.csv; default: a 500th of all steps; false: this run writes no history.csv
---@field record? integer|false
---file in which the state of the run is saved: at its beginning, then at intervals of `every` seconds of wall time
---(default 60), when Ctrl-C or SIGTERM ends the program `hinge run`, and at its end. A name without a folder is in the
---output folder. Each run of a script has its own file. `hinge run SCRIPT --resume` continues from there. If a later
---checkpoint cannot be written, this is no error: the last one stays, and hinge prints a line about it. keep: a table
---of the script. Its values (booleans, numbers, strings, tables of them) are saved too. They are back in it when the
---run continues
---@field checkpoint? string|{ file: string, every?: number, keep?: table }

-- Runs ---------------------------------------------------------------------------------------------------------------

---@class hinge.run
---@field kind "static"|"dynamic"
---@field model hinge.model of which the run was made
---@field time number s
---@field factor number in statics: the load factor reached
---@field index integer number of steps done
---@field planned_steps integer
---a run is as good as the run that it goes on from: it is "failed" at its end if that one failed, or ended at a limit
---load or before the load factor of its arc length, unless allow_failed = true
---@field verdict "running"|"completed"|"stopped"|"failed"
---why the run failed, with the node or element that caused it, or with the run before it that failed. For statics
---with the verdict "completed": a limit load or branching point on the way, with unstable = "continue" whether the
---state at the end is stable, and whether arc length stopped short of its load factor. Under plain Lua, a failed run
---is reported on stderr when the script has ended, unless the script has read verdict, reason or failure. The text is
---for people and may change from version to version; a script decides by failure
---@field reason string
---@field failure? hinge.run_failure why the run failed, as values; nil where it has not
---what the model cannot show, or what the run may have missed, each once. That the run goes on from one that failed. A
---member of two elements that is compressed beyond Euler's load between clamped ends (dynamics; in statics that is an
---instability). Moments of loads along such a member that are more than 5 % too small for its compression (p_delta =
---"member"): beyond 0.6 of that load, and with weight = "nodes" also below. Four elements show both. A free body that
---spins so fast for the steps of Newmark's method that its angle is lost: integrator = "energy-momentum" keeps it. A
---step of static load that moves the structure more than 30 times as far as the same load did at first. Dynamics checks
---this every 100 steps, or 20 times in a short run, and at the end. A perfect structure that can buckle while only
---rounding starts it (a straight column, a symmetric arch or truss): dynamics of up to 500 nodes looks for that up to
---40 times in a run, from 5 % of Euler's load in a member or 1 % of the size in displacement on. Members that passed
---through each other without a contact rule for them, in statics with large displacement whatever the rules (not those
---that share a node or overlapped at the start). Bodies that fell below the lowest support, and columns that fell over
---to below their own, where no ground is for them. An elastic stress that no material bears where no yield stress is
---declared: a strain of 1 % from E = 50 GPa, 3 % from 5 GPa, 30 % from 0.5 GPa; members stretched to more than 1.6
---times their length. Members of less than eight elements that were struck between their joints and yielded.
---`hinge run` prints the warnings; they are in summary.json
---@field warnings string[]
---@field energy hinge.energy
---@field dt number s, of the next step; nil in statics
---@field limit? boolean in statics: true if the run has ended at a limit load, see to_limit; nil in dynamics
---@field instability? hinge.instability in statics: where the structure became unstable; nil where it did not
---@field worst_energy_error number J, the largest absolute value of energy.energy_error so far
---energy.energy_error as a part of the largest energy, at the last row of history.csv. The largest energy is the
---largest value that any account of the energy balance has had so far. An account counts only up to what the other side
---of the balance explains (what is held or dissipated: up to the initial energy, the work supplied and what gravity and
---connectors gave), so that energy from an error does not count. energy_tolerance of model:dynamic limits the same
---error.
---If the balance did not close, this is the error when that was seen, not that of the earlier state to which the run
---went back
---@field energy_error number
---the same of the state that the run has now; differs from energy_error only after the balance did not close
---@field energy_error_of_state number
---pairs of elements; bound: ties made or contacts begun; released: those ended
---@field contacts { bound: integer, released: integer }
---@field stages { name: string, seconds: number }[] wall time of the steps by stage
---@field effects hinge.effect[] all effects of hinge, used in the step or not
---@field wall_seconds number
---@field fastest { speed: number, node: string, time: number } the fastest node so far, m/s and s; nil in statics
---@field hash string checksum of the whole state, to the bit
---@field counts hinge.work_counts
---@field probes hinge.probe[] all probes up to now
---@field loads table<string, number> the load cases of the model by name, with their factors in this run
---effects that became active or inactive during the run; the first thousand
---@field state_changes { time: number, effect: string, awake: boolean, why: string }[]
local run = {}

---@class hinge.effect
---@field name string
---@field active boolean true: the effect is part of the step
---@field because string why it is active, or why not
---@field seconds number wall time of the effect
---@field asked_at string line of the script that declares the effect; "" if none does

---A word of the list at hinge.run_failure
---@alias hinge.failure_cause string

---Why a run failed. A field that says nothing of the cause is nil. summary.json has the cause of the verdict as
---"cause", also "not_written" where a file could not be written. The causes: "load_not_finite": a load on `node` is
---not a finite number; "force_not_finite": nor are the forces of `element`, or at `node`; "forces_unbounded": the
---forces at `node` grow without bound. "element_folded": an end of `element` has folded back against the element.
---"flow_not_found": its plastic flow has no solution within a step. "not_factorised", "not_positive_definite",
---"solution_not_finite", "solver_not_converged", "mass_not_solved": the linear equations of a step have no solution.
---"not_positive_definite" has the `node` and, where one is known, the `element`; `value`: the compression in it, N.
---"solver_not_converged": after `count` iterations. "newton_not_converged": after `count` iterations; `value`: the
---last correction as a part of the first. "rotation_too_large": step control; `node` would rotate by `value` in a
---step, `limit` is allowed, rad. "energy_lost_in_step", "energy_not_finite": step control; `value` would be lost,
---`limit` is allowed, as parts of the largest energy. "energy_error": the energy balance does not close; its error is
---`value`, `limit` the energy_tolerance. "energy_error_grown": it has grown by `value` since the check at step
---`count`, `limit` is allowed; all as parts of the largest energy. "no_equilibrium": statics; none is found beyond
---load factor `value`; `limit`: the part of the step that was tried last. "unstable": statics under load control,
---between load factors `value` and `limit`; `node` and `component` give way, see run.instability. "from_failed_run":
---the run that this one goes on from did not reach its end
---@class hinge.run_failure
---@field cause hinge.failure_cause
---@field text string run.reason without advice and without what was seen beside the failure
---@field step? integer step that was tried, or at which the energy balance was checked
---@field time? number s, at its end
---@field node? string its name, as in run.instability
---@field element? string its name, with that of its member and group
---@field member? hinge.member the member of the element
---@field component? hinge.component direction in which the node gives way
---@field value? number see the cause; nil for 0
---@field limit? number what is allowed, see there; nil for 0
---@field count? integer see there
---what had failed before that, and was seen at the same time: an energy balance that no longer closed
---@field before? hinge.run_failure

---A limit point or a branching point that a static run has passed. Beyond it the tangent stiffness has more negative
---eigenvalues than at the start of the run. Under constant load the structure would not stay there.
---@class hinge.instability
---@field factor number load factor of the last equilibrium before it
---@field beyond number load factor of the first equilibrium after it
---@field count integer number of motions that have lost their resistance, the most so far
---with the largest part in the first such motion; rotations count times the mean length of an element
---@field node string
---@field component hinge.component its direction: ux uy uz rx ry rz
---the cause: "compression" of members that bend, or "bending", as of a beam that turns over sideways; nil: neither of
---them
---@field by? "compression"|"bending"
---@field member? hinge.member the member with the largest part in this; nil: none
---@field members hinge.member[] this member and others with at least half its part, at most three

---Counts of the work that a run has done.
---@class hinge.work_counts
---@field element_updates integer elements whose forces were recovered
---@field element_builds integer elements whose stiffness was built
---@field solves integer systems solved
---@field cg_iterations integer
---@field factorisations integer
---@field pair_tests integer pairs of members that were checked for contact
---@field pair_lists integer lists of near pairs that were made
---@field rejected_steps integer steps that step control has undone; in statics tries that were halved
---@field substeps integer in statics equilibria found: a step that was halved has several; in dynamics steps

---The energy balance, J: eq 20, and the terms that eq 20 leaves out.
---@class hinge.energy
---kinetic energy at the start, and all that is stored then: in the elements, contacts, connectors, joints, ground
---@field initial number
---@field kinetic number
---@field gravity number potential energy, of each body from where it was at the start
---@field elastic number
---@field plastic number dissipated in hinges
---@field fracture number released by fracture: fracture_elastic + fracture_kinetic
---@field fracture_elastic number strain energy of broken elements
---@field fracture_kinetic number kinetic energy lost when broken elements become rigid offset masses
---@field contact number contact_stored + contact_released
---@field contact_stored number stored in contacts now
---@field contact_released number lost when ties are released, or heat of friction
---@field damping? number dissipated by Rayleigh damping, where model:damping is declared
---@field connectors number connector_stored + connector_dissipated; these three only if the model has connectors
---@field connector_stored number stored in springs and curves now
---@field connector_dissipated number dissipated by dashpots and laws, and lost when connectors break
---@field joints number joint_stored + joint_dissipated; these three only if members' ends have joints
---@field joint_stored number stored in the springs of joints now
---@field joint_dissipated number plastic work of joints, and what was lost when they broke
---@field numerical number dissipated by the integrator (rho_infinity)
---@field work number work of the loads
---@field energy_error number the energy error: initial + work - all other accounts (without their parts)
---@field remainder number the same; the name up to version 0.2

---Does the steps one by one: `for step in run:steps() do ... end`. The table is the same one at every step, with new
---values.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---for step in swing:steps() do
---  local _, _, uz = tip:displacement(swing)
---  if step.index % 20 == 0 then print(step.time, uz) end
---end
---```
---@return fun(): { index: integer, time: number, factor: number }?
function run:steps() end

---Does one step. The run uses the model as it was when the run was made. If the model was changed after that, the call
---is an error; so are run:steps and run:finish.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---while swing:step() do
---  if select(3, swing:displacement(tip)) < -1e-3 then swing:stop() end
---end
---```
---@return boolean done false if no step is left
function run:step() end

---Does all steps to the end.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }:finish()
---print(swing.verdict, swing.time)
---```
---@return hinge.run
function run:finish() end

---Writes a checkpoint into a file: the state of the run, its probes, history.csv and list of frames. With it the run
---can continue with the same bits. The file is first written under another name and then renamed, so it is always
---complete: the old one or the new one. The call changes nothing in the run. Call it between steps or in run:on_step;
---for dynamic runs only. The variables of the script are not saved, nor are those that its functions use. The table
---given as `keep` is saved, and so are the numbers that a fracture rule keeps for each section.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---for step in swing:steps() do
---  if step.index % 50 == 0 then swing:checkpoint "swing.checkpoint" end
---end
---```
---@param file string a name without a folder is in the output folder
---@return hinge.run
function run:checkpoint(file) end

---Continues the run from a checkpoint. Call it before the first step. The checkpoint must be of the same run: the same
---model, settings and probes; the number of threads may differ. A damaged checkpoint, one of another run (the message
---names the difference) or one of another version of hinge is an error. The run is then unchanged.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---swing:step()
---swing:checkpoint "swing.checkpoint"
---local again = model:dynamic { dt = 1e-4, duration = 0.01 }:resume "swing.checkpoint"
---print(again.index) -- 1
---```
---@param file string
---@return hinge.run
function run:resume(file) end

---Ends the run here. Its verdict is then "stopped". A run that has already ended does not change.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---for step in swing:steps() do
---  if step.time > 5e-3 then swing:stop() end
---end
---```
function run:stop() end

---Sets a function that is called with the run after each step, also for steps of run:finish. The function may read the
---run and stop it, but may not step it.
---```lua
---local lowest = 0
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---swing:on_step(function(now) lowest = math.min(lowest, select(3, now:displacement(tip))) end)
---swing:finish()
---```
---@param callback fun(run: hinge.run)
---@return hinge.run
function run:on_step(callback) end

---Records one quantity of a node at every step, and in history.csv. Call it before the first step. The first value is
---that at the start of the run. A reaction at the start is the force that holds the supports under the loads at that
---time, together with the inertia of masses that accelerate at once. In statics it is the reaction at a load factor of
---0.
---
---With relative_to the probe is the difference to another node: a displacement against a floor, or the velocity of two
---bodies against each other. The difference is taken along the global axes; rx ry rz are the rotation vector of the one
---node against the other. drift_x and drift_y are the difference of ux or uy over the height between the two nodes at
---the start, along z, or over `height`.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---local sag = swing:probe { node = tip, "uz", name = "sag" }
---swing:finish()
---print(sag.min, sag.last, #sag.value)
---
---local push = model:static { steps = 4 }
---local bending = push:probe { node = tip, relative_to = wall, "uz" }
---local drift = push:probe { node = tip, relative_to = wall, "drift_x", height = 3 }
---push:finish()
---print(bending.last, drift.max)
---```
---@param options hinge.probe_options
---@return hinge.probe
function run:probe(options) end

---@class hinge.probe_options
---@field node hinge.node
---ux uy uz rx ry rz (displacement), vx .. vrz (velocity), ax .. arz (acceleration), fx fy fz mx my mz (reaction),
---drift_x drift_y
---@field [1] string
---@field relative_to? hinge.node the node whose value is taken off; not for reactions
---@field height? number m, of a drift; default: the difference of z of the two nodes at the start
---@field name? string its column in history.csv; default such as node12_ux, node12_ux_to_node3

---time and value are lists of what was recorded up to the moment when they are read.
---@class hinge.probe
---@field time number[] s; in statics the load factor
---@field value number[]
---@field last number
---@field max number
---@field min number
---@field name string its column in history.csv
---@field unit string of the values: m, rad, m/s, rad/s, m/s^2, rad/s^2, N or N m; "" of a drift

---```lua
---local _, _, uz = run:displacement(tip)
---```
---@param node hinge.node
---@return number ux, number uy, number uz, number rx, number ry, number rz m and rotation vector, rad
function run:displacement(node) end

---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }:finish()
---local _, _, vz = swing:velocity(tip)
---```
---@param node hinge.node
---@return number vx, number vy, number vz, number wx, number wy, number wz m/s and rad/s
function run:velocity(node) end

---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }:finish()
---local _, _, az = swing:acceleration(tip)
---```
---@param node hinge.node
---@return number ax, number ay, number az, number bx, number by, number bz m/s^2 and rad/s^2
function run:acceleration(node) end

---```lua
---local _, _, fz = run:reaction(wall)
---```
---@param node hinge.node
---@return number fx, number fy, number fz, number mx, number my, number mz
---  what the support exerts on the node, N and N m
function run:reaction(node) end

---```lua
---local x, y, z = run:position(tip)
---```
---@param node hinge.node
---@return number x, number y, number z where it is now, m
function run:position(node) end

---N and N m in the section's axes. f_y: yield function of the section's law (eq 14 or exact), with the hardening so far
---and without the strain rate; 1 where the section is fully plastic
---@alias hinge.resultants { N: number, Mx: number, My: number, Mz: number, Qx: number, Qy: number, f_y: number }

---As member:forces.
---```lua
---local at_a, at_b = run:forces(beam)
---print(at_a.Mx, at_b.Mx)
---```
---@param member hinge.member
---@return hinge.resultants at_a, hinge.resultants at_b at its two ends
function run:forces(member) end

---The resultants along a member, as member:along.
---```lua
---print(#run:along(beam))
---```
---@param member hinge.member
---@param parts? integer default 8
---@return hinge.resultants_at[]
function run:along(member, parts) end

---As member:state.
---```lua
---local state, f_y = run:state(beam)
---```
---@param member hinge.member
---@return "elastic"|"yielded"|"broken" state, number f_y, number? time, integer? element
function run:state(member) end

---@alias hinge.end_a "N_a"|"Mx_a"|"My_a"|"Mz_a"|"Qx_a"|"Qy_a"|"f_y_a"
---@alias hinge.end_b "N_b"|"Mx_b"|"My_b"|"Mz_b"|"Qx_b"|"Qy_b"|"f_y_b"
---@alias hinge.member_value "f_y"|"N"|"broken"|"yielded"|"touched"|"plastic_work"|"temperature"|"member"|"x"|"y"|"z"
---@alias hinge.member_quantity hinge.member_value|hinge.end_a|hinge.end_b

---@alias hinge.rate "vx"|"vy"|"vz"|"vrx"|"vry"|"vrz"|"ax"|"ay"|"az"|"arx"|"ary"|"arz" velocity, acceleration
---@alias hinge.reaction "reaction_fx"|"reaction_fy"|"reaction_fz"|"reaction_mx"|"reaction_my"|"reaction_mz"
---@alias hinge.node_quantity hinge.component|hinge.rate|hinge.reaction|"node"|"node_x"|"node_y"|"node_z"

---Reads one number for each member or each joint of the group, in the order of declaration. "member" and "node" give
---their indices. For members: f_y is the largest value in the member now. N is its mean axial force, N, 0 once it is
---broken. broken, yielded and touched are 1 or 0. plastic_work is in J. temperature is that
---in the middle of its section, degrees Celsius. member is the index. x, y, z are the middle of
---the member now, m. Names with _a and _b are the resultants at its ends, as in member:forces. For nodes: the
---quantities of run:probe; reactions are reaction_fx to reaction_mz. node is the index. node_x, node_y, node_z are the
---position now, m.
---```lua
---local f_y, place = run:read("f_y", "arm"), run:read("x", "arm")
---for i, value in ipairs(f_y) do print(place[i], value) end
---local reactions = run:read "reaction_fz" -- of every joint
---```
---@param quantity hinge.member_quantity|hinge.node_quantity
---@param group? hinge.group_like default: all; for quantities of nodes, the joints of the group's members
---@return number[]
function run:read(quantity, group) end

---The natural modes of small vibrations about the state of the run, the lowest first: unloaded, under its loads, or
---damaged. Members are elastic, also where they have yielded; what is broken is left out; connectors, joints, masses,
---rigid links and diaphragms count. Joints that have yielded have the stiffness with which they unload, the elastic
---one; joints = "slide": those at their strength (to a millionth of it) have none, as long as the motion turns them
---further. Axial forces change the stiffness as in the run. Bodies that nothing holds have modes of frequency 0. What
---has no mass (members without density, nodes with masses that have no rotary inertia) is condensed statically: there
---are as many modes as there are directions with mass.
---Moments, and loads that turn with their member, make the stiffness unsymmetric; where that changes the square of a
---frequency by a thousandth, it counts. It is an error if there are then more than 2000 degrees of freedom, and if one
---of the modes asked for flutters: its vibrations grow, which no real frequency says (ask for more modes to see
---whether a higher one does). It is an error if a frequency is lost in rounding, beside parts that are some 1e14 times
---as stiff. So is a run that has done no step, if rigid links or diaphragms carry forces that it took from another
---run.
---```lua
---for _, mode in ipairs(run:modes { n = 3 }) do print(mode.frequency, mode.period, mode.share.z) end
---```
---@param options? { n?: integer, joints?: "unload"|"slide" } how many, default 6
---@return hinge.mode[]
function run:modes(options) end

---Load factors at which the structure buckles, the lowest first, in the structure's declared place. Run a static run
---under the loads first, or under a part of them; the factor times its loads is Euler's load of the whole. The
---internal forces at the end of the run are multiplied; where it has come to another load factor than 1, the result is
---times that factor, so that it is on the declared loads. A run that has failed, or ended at its limit load, gives a
---warning. A run that began with the loads of another one (`from`) has its factors on the internal forces. What bends
---before it buckles has a limit load that is lower: the factor is an upper bound, which statics with an imperfection
---shows. Joints that have yielded have the stiffness with which they unload, or with joints = "slide" none, as in
---run:modes. The second result is the factor at which a pair of elements would buckle between clamped ends, which its
---two elements do not show: more elements a member show it; nil: there is none. It needs displacement = "large". It is
---an error where moments of fixed axis, or loads that turn with their member, change the factor by a thousandth: such
---a structure may flutter and need not buckle, and the symmetric part of its stiffness has a factor that it does not
---have.
---```lua
---local column = model:node { 1, 0, 2 }
---model:member { tip, column, section = square, material = steel }
---model:load { node = column, force = { 0, 0, -1000 } }
---local modes = model:static():finish():buckling { n = 2 }
---print(modes[1].factor)
---```
---how many, default 1; factors above `most` are not looked for
---@param options? { n?: integer, most?: number, joints?: "unload"|"slide" }
---@return hinge.mode[] modes, number? hidden
function run:buckling(options) end

---A shape in which a structure vibrates or buckles. job:picture(mode, view) draws it: any view of a run.
---@class hinge.mode
---@field frequency number? Hz; 0 where the state is unstable: see omega_squared. This and the next five: natural modes
---@field period number? s
---@field omega_squared number? square of the circular frequency, 1/s^2; negative where the state is unstable
---shape . M r for a unit displacement r of the whole along an axis; the shape has a modal mass of 1 kg
---@field participation { x: number, y: number, z: number }?
---@field mass { x: number, y: number, z: number }? effective masses, kg
---@field share { x: number, y: number, z: number }? effective masses over the mass of the whole, supports included
---@field factor number? of buckling modes
local mode = {}

---Displacement (m) and rotation (rad) of a node in the shape. A natural mode has a modal mass of 1 kg; the largest
---displacement of a buckling mode is 1 m.
---```lua
---local ux, uy, uz, rx, ry, rz = run:modes()[1]:displacement(tip)
---```
---@param node hinge.node
---@return number ux, number uy, number uz, number rx, number ry, number rz
function mode:displacement(node) end

---The state of the run with the shape on top of it, for pictures and films.
---```lua
---hinge.strip({ { run:modes()[1]:snapshot(0.1), { title = "first mode" } } }, 1, "mode.png")
---```
---@param amplitude? number its largest displacement, m; default: a twentieth of the structure's size
---s; the shape is then amplitude sin(2 pi time / period), with a period of 1 s for buckling modes, and pictures show
---the time. Default: the amplitude itself
---@param time? number
---@return hinge.snapshot
function mode:snapshot(amplitude, time) end

---The plastic hinges, and the joints. Hinges are all sections that have ever been fully plastic, in this run and in
---the runs before (`from`). Of a joint (hinge.joint, model:joint) each axis that is a spring has a row, and each
---force at which it breaks; pins and rigid axes have none. A connector (model:connector) has a row for each direction
---with a capacity. They come by storey, member and place in the member. Where two elements of a member meet there is
---one hinge: the rotation is that of both. The list keeps the values of now; it does not follow the run. limit
---compares the largest rotation so far of each hinge (demand) with a limit in rad. It is a number, or the levels { IO
---=, LS =, CP = } (immediate occupancy, life safety, collapse prevention; one or more, rising). It may be a table of
---these by group: a member's first group in it counts. It may be a function of the hinge that returns one of these,
---or nil for no limit. The limit is that of rotation alone: a brace that yields by its axial force has no rotation,
---and an elongation. The rotation of a joint is the whole of it, with the elastic part. Its own limits (`capacity`,
---`tension`, `shear` of hinge.joint) are compared too, with `limit` or without: the one that it has come nearest to
---gives its ratio.
---```lua
---local pushed = model:static { steps = 5 }:finish()
---local found = pushed:hinges { group = "arm", limit = { IO = 0.01, LS = 0.03, CP = 0.04 } }
---print(found) -- how many, the worst, and a table of the 20 largest
---for _, h in ipairs(found) do print(h.member.index, h.at, h.largest, h.first_yield, h.ratio) end
---found:write() -- hinges.csv
---```
---@param options? { group?: hinge.group_like, limit?: hinge.hinge_limit } group default: all members
---@return hinge.hinge_list
function run:hinges(options) end

---@alias hinge.hinge_levels number|{ IO?: number, LS?: number, CP?: number } rad
---by group, or by hinge
---@alias hinge.hinge_limits table<string, hinge.hinge_levels>|fun(h: hinge.plastic_hinge): hinge.hinge_levels?
---@alias hinge.hinge_limit hinge.hinge_levels|hinge.hinge_limits

---A list of hinges. print shows it as a table.
---@class hinge.hinge_list
---@field [integer] hinge.plastic_hinge
---the hinge with the largest ratio; without limits the one with the largest demand; nil in an empty list
---@field worst? hinge.plastic_hinge
---how many are beyond their limit; nil where no limit is given, and no joint breaks at one of its own
---@field beyond? integer
---@field without_limit? integer how many have none; nil in the same case
---@field statics boolean of a static run
local hinges = {}

---Writes the list as a CSV file into the output folder. A program's last run leaves hinges.csv by itself, without
---limits, unless the script has written it. `hinge report` shows it.
---```lua
---model:static { steps = 5 }:finish():hinges { limit = 0.03 }:write()
---```
---@param filename? string plain name ending in .csv, default hinges.csv
---@return hinge.hinge_list
function hinges:write(filename) end

---A plastic hinge, or an axis or a force of a joint. In the file hinges.csv member and node are numbers; before,
---broken, yielded and failed are 1 or 0.
---@class hinge.plastic_hinge
---@field member hinge.member of a joint between nodes the first member at the second of them
---@field group? string name of the member's first group
---storey from 1 at the ground, with z upwards: floors are the heights of level members that hang together with a
---support; nil: none
---@field storey? integer
---@field element integer from 1, counted over the whole model
---@field end integer end of the element, 1 or 2; 0: the middle of a conventional element; written h["end"]
---@field at number its place in the member: 0 at a, 1 at b
---@field node? hinge.node the joint at this section; nil: it is inside the member
---@field x number m, at the start
---@field y number m
---@field z number m
---rad, plastic, now, about the section's x axis; positive like curvature_x. Of a joint: of the end relative to the
---node, about the axes that are springs
---@field rotation_x number
---@field rotation_y number rad
---@field rotation_z? number rad; of joints
---@field rotation number rad, of x and y together; of a joint's z axis that about z
---@field largest number rad, the largest value that rotation has had; of a joint that about its own axis alone
---rad, what a limit is compared with: largest; where two members meet in a joint, and no third, the sum of both,
---because they may share the rotation of one hinge. Of a joint's x and y axes: the largest of both together
---@field demand number
---@field elongation number m, plastic, now: its part of the member's
---@field work number J, dissipated in it
---@field f_y? number yield function of the section's law, now; nil of joints
---the square root of f_y, which grows with the forces; 1 where fully plastic. Of a joint moment or force over what it
---holds now; nil without a strength
---@field utilisation? number
---when it first yielded: s, in statics the load factor; nil of a joint that has not
---@field first_yield? number
---@field first_kind? "static"|"dynamic" the kind of run in which it did
---@field before? boolean true: in a run before this one
---@field broken boolean an element at this section is broken; the joint is
---@field yielded boolean false: a joint that has kept to the elastic part of its curve
---rad; of levels the largest; of a joint its capacity where that gives the ratio; nil where a force does
---@field limit? number
---@field ratio? number demand over limit; of a joint largest over capacity, or largest_force over strength
---the level that its demand keeps to: "IO", "LS", "CP", "beyond CP" or "beyond capacity"; nil without levels
---@field level? string
---"joint at end a of member 3", "joint between nodes 4 and 9", "connector 2 between nodes 4 and 9"; nil: a hinge. This
---and what follows: of joints, and of connectors with a capacity
---@field joint? string
---of the section; or the force at which the joint breaks; of a connector "force_x" to "moment_z", along and about its
---own axes, each that has a capacity
---@field axis? "x"|"y"|"z"|"tension"|"shear"|string
---@field connector? integer its number, in the order of declaration; nil: it is no connector
---@field between_nodes? boolean made by model:joint or model:connector
---@field moment? number N m, now, about the axis, on the node
---@field largest_moment? number N m, of either sign
---@field force? number N, now: tension or shear; of connectors without a sign, N or N m; 0 where it has broken
---@field largest_force? number N; of a connector N or N m, of either sign
---@field stiffness? number N m/rad, elastic
---@field strength? number N m, the largest moment of its curve; N, at which it breaks; nil: elastic
---@field capacity? number rad, at which it breaks
---@field interaction? "linear" tension weakens its moments
---@field failed? boolean it broke by one of its own limits; in statics: it is beyond one

---Momentum and kinetic energy of all members or of a group: what a blow has given to one body and taken from the other.
---Point masses and broken elements belong to the node that carries them. They count where no member outside the group
---meets that node.
---```lua
---local momentum = run:momentum()
---print(momentum.mass, momentum.linear[1], momentum.angular[3], run:momentum("arm").kinetic)
---```
---@param group? hinge.group_like default: all members
---@return { mass: number, linear: vec3, angular: vec3, kinetic: number } kg, kg m/s, kg m^2/s about the origin, J
function run:momentum(group) end

---Returns how many members of a group are in a state. A member is broken if one of its elements is broken. Else it is
---yielded if one of them has ever been fully plastic, else elastic. It is touched, in addition to its other
---state, if it has ever been in contact.
---```lua
---print(run:count { group = "arm", state = "yielded" }, run:count { state = "broken" })
---```
---@param options { group?: hinge.group_like, state: "elastic"|"yielded"|"broken"|"touched" } group default: all members
---@return integer
function run:count(options) end

---Keeps the structure as it is now, for pictures.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---local first = swing:snapshot()
---swing:finish()
---hinge.strip({ { first }, { swing } }, 2, "before_and_after.png")
---```
---@return hinge.snapshot
function run:snapshot() end

---@class hinge.snapshot

-- Ground motion -------------------------------------------------------------------------------------------------------

---Returns the displacement of the ground, m, as a function of time, s, from a record of its acceleration. The
---acceleration is linear between the values of the record, and is integrated twice exactly. The displacement is zero
---before the record starts. After its end it goes on with constant velocity. The function is for model:move.
---```lua
---local quake = hinge.ground { dt = 0.02, acceleration = { 0, 1.2, -0.8, 0.3, 0 }, scale = 0.5 } -- m/s^2
---model:move { node = wall, y = quake }
---```
---@param options { dt: number, acceleration: number[], scale?: number }
---  dt s; acceleration m/s^2, the first at t = 0; scale default 1
---@return fun(time: number): number
function hinge.ground(options) end

---Ground motion from files.
---@class hinge.records
local record = {}

---Reads one component of ground motion from a file of PEER, ESM, K-NET or KiK-net, or from columns of numbers. The
---values become m/s^2. Then they are cut (`from`, `to`), the baseline is taken off, and they are scaled, in this order.
---An error names the line of the file that is wrong: a word among the numbers, a value that is not finite, another
---unit, a number of values that differs from the header's.
---```lua
---local path = os.tmpname()
---local file = assert(io.open(path, "w"))
---file:write "# time s, acceleration g\n0.00 0\n0.02 0.1\n0.04 -0.15\n0.06 0.05\n0.08 0\n"
---file:close()
---local quake = hinge.record.read { file = path, unit = "g", peak = 2.5, baseline = "constant" } -- m/s^2
---os.remove(path)
---print(quake.name, quake.dt, quake.duration, quake.peak)
---model:move { node = wall, y = quake.displacement }
---```
---@param options hinge.record_options
---@return hinge.ground_record
function record.read(options) end

---@class hinge.record_options
---@field file string path, from the folder where the program was started
---"PEER AT2": in g, taken as 9.80665 m/s^2; the fourth line is `NPTS=  n, DT= dt SEC` or `n dt NPTS, DT`. "ESM": header
---of lines `KEY: value`, then cm/s^2. "K-NET", also for KiK-net: counts, with the factor to gal in the header; the mean
---of the file is taken off. "columns": one column of accelerations, or two of times and accelerations, with blanks,
---commas or tabs between; lines that begin with # are left out, and so are lines that begin with a letter before the
---first number. Default: found out from the text; columns if it is none of the others and `unit` is given
---@field format? "PEER AT2"|"ESM"|"K-NET"|"columns"
---unit of columns, which must have it; the other formats say theirs themselves
---@field unit? "m/s^2"|"g"|"cm/s^2"
---@field dt? number s, time step; for one column, which must have it. Two columns must have times at equal steps
---s, after the first value: where the cut begins. Default 0
---@field from? number
---s, after the first value: where the cut ends. Default: the last value
---@field to? number
---polynomial of the time that is taken off the acceleration: of degree 0, 1 or 2. Its coefficients make the velocity at
---the end 0, and with that the sum of the squares of the velocities at all values as small as it can be. The one
---coefficient of "constant" does the first alone. The velocity begins at 0, and the acceleration is straight between
---its values. Default "none"
---@field baseline? "none"|"constant"|"linear"|"quadratic"
---@field scale? number factor; default 1
---@field peak? number m/s^2, above 0: largest absolute value that the record is scaled to; in place of `scale`

---One component of ground motion, after the cut, the baseline and the factor.
---@class hinge.ground_record
---@field dt number s, time step
---@field acceleration number[] m/s^2, the first at t = 0
---displacement of the ground, m, at a time, s, as hinge.ground makes it: for model:move
---@field displacement fun(time: number): number
---@field peak number m/s^2, largest absolute value
---@field duration number s, from the first value to the last
---@field end_velocity number m/s, at the end of the record; the ground goes on with it
---@field end_displacement number m, at the end of the record
---@field name string of PEER the second line; of ESM event, station and stream; else station or file
---@field format "PEER AT2"|"ESM"|"K-NET"|"columns" what the file was read as

---Returns an elastic response spectrum: the largest responses of oscillators of one mass on ground with this
---acceleration. The acceleration is straight between its values, and the oscillators are integrated exactly (Nigam and
---Jennings 1969), with peaks between steps to 1e-5. They begin at rest. After the last value the ground is not
---accelerated, and one period of free vibration counts as well. The accelerations may be those of a run's probe, for
---what stands on a floor; the probe must be without relative_to. Periods of less than two time steps are beyond what
---the values know: the straight lines decide there.
---```lua
---local s = hinge.spectrum { dt = 0.02, acceleration = { 0, 1.2, -0.8, 0.3, 0 }, periods = { 0.1, 0.5, 1 } } -- m/s^2
---print(s.periods[2], s.displacement[2], s.acceleration[2]) -- s, m, m/s^2
---
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---local az = swing:probe { node = tip, "az" }
---swing:finish()
---local on_tip = hinge.spectrum { time = az.time, acceleration = az.value, damping = 0.02 }
---hinge.plot({ series = { { x = on_tip.periods, y = on_tip.acceleration } }, log_x = true, x_label = "s",
---  y_label = "m/s^2" }, "spectrum.png")
---```
---@param options hinge.spectrum_options
---@return hinge.response_spectrum
function hinge.spectrum(options) end

---@class hinge.spectrum_options
---@field acceleration number[] m/s^2, two or more
---@field dt? number s, time step; one of dt and time
---@field time? number[] s, as many as accelerations, ascending; the steps need not be equal
---s, at least 1/1000 of the longest time step. Default: 100 from 0.02 to 4 s, at equal steps of the logarithm
---@field periods? number[]
---@field damping? number part of critical damping, 0 or above and below 1; default 0.05

---Lists of as many values as periods.
---@class hinge.response_spectrum
---@field periods number[] s
---@field displacement number[] m, largest displacement against the ground
---@field velocity number[] m/s, pseudo velocity: 2 pi / period * displacement
---@field acceleration number[] m/s^2, pseudo acceleration: (2 pi / period)^2 * displacement
---@field absolute_acceleration number[] m/s^2, largest acceleration in space
---@field damping number part of critical damping

-- Scenarios ----------------------------------------------------------------------------------------------------------

---Tables for a report, of what runs have computed: forces of members, envelopes, utilisation by standards, storeys,
---reactions. Every call needs the model of the run, or members or groups of it.
---@class hinge.results
local results = {}

---Options that all calls of hinge.results share.
---@class hinge.results_source
---@field model? hinge.model the model of the run, which is also the default
---@field group? hinge.group_like|hinge.group_like[] members of these groups alone
---@field members? hinge.member[] these members alone
---stations along a member are at this number of equal parts; ends and extreme moments are always read; default 8
---@field parts? integer
---units of force, length and displacement in which tables are shown; default "kN, m, mm"
---@field units? string

---The smallest and largest resultants of each member now, with their places. A row has N_min, N_min_x, N_max, N_max_x,
---the same for Mx, My, Mz, Qx and Qy, and N, Mx, ... as the one of the larger size, in SI units.
---```lua
---local forces = hinge.results.members(run, { model = model })
---print(forces)
---print(forces.rows[1].Mx_min, forces.rows[1].Mx_min_x) -- N m, m
---```
---@param run hinge.run
---@param options? hinge.results_source
---@return hinge.results_table
function results.members(run, options) end

---The smallest and largest resultants of each member over the steps of a dynamic run, or over several runs, with the
---time (s), or the name, of the state in which each occurred. A run that has not ended is read after each of its steps;
---a dynamic one also at its start. A static run that has ended is read once. A dynamic run that has ended is an error:
---only its last state is left. A static state is called by its load cases, "1.35 dead + 1.5 live", or by `names`.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---local peaks = hinge.results.envelope { swing, model = model, every = 10 }
---swing:finish()
---print(peaks.rows[1].Mx_min, peaks.rows[1].Mx_min_when) -- N m, s
---print(hinge.results.envelope { run, model = model, names = { "at rest" } })
---```
---@param options hinge.envelope_options
---@return hinge.results_envelope
function results.envelope(options) end

---@class hinge.envelope_options: hinge.results_source
---@field [integer] hinge.run runs; none, if states are added by envelope:add
---@field every? integer steps between two readings of a run; default 1. The last planned step is always read
---@field names? string[] names of the runs, in their order

---A table of an envelope. `states` is the number of states read. A row has `stations`, a list of { x =, N = { smallest,
---largest }, Mx = ... } at equal parts of the member.
---@class hinge.results_envelope: hinge.results_table
---@field states integer
local envelope = {}

---Adds the state that a run has now.
---```lua
---local peaks = hinge.results.envelope { model = model }
---local push = model:static { steps = 4 }
---for step in push:steps() do peaks:add(push, ("step %d"):format(step.index)) end
---```
---@param run hinge.run
---@param name? string what the state is called; default: its time, or its loads
---@return hinge.results_envelope self
function envelope:add(run, name) end

---Draws the band between the smallest and largest values of a resultant along members, one after the other.
---```lua
---hinge.results.envelope({ run, model = model }):plot("moments.png", { quantity = "Mx", members = { beam } })
---```
---@param job? hinge.job may be left out: plot(filename, options)
---@param filename string plain name ending in .png, .svg or .pdf
---@param options? { quantity?: string, members?: hinge.member[], units?: string, title?: string } default: Mx, all
---@return hinge.results_envelope self
function envelope:plot(job, filename, options) end

---The largest utilisation of each member by a standard, over one or several runs that are read as by
---hinge.results.envelope. A utilisation is a ratio that may be at most 1. The checks are of the resultants of the run:
---after yielding, and with effects of second order in large displacement. Nothing is added to them.
---
---EN 1993-1-1:2005, classes 1 and 2: 6.2.3 to 6.2.9, 6.3.1, 6.3.2.2 where Lb is given (H and upright rectangles),
---6.3.3 with annex B. AISC 360-16, LRFD: D2(a), E3, F2, F3, F6, F7, F8, F11, G2, G4 to G6, H1.1, H3. Sections: H, box,
---pipe, rectangle, round bar, of steel. Other members, and those whose plates are too slender, have a remark "not
---checked: ..." and no utilisation. The formulas were compared with published examples. Rupture at holes, torsional
---buckling of compressed H sections and warping are not checked. An envelope in place of runs takes extremes of
---different times together.
---
---Joints have rows of their own, whatever the standard: the moment about each axis over its strength ("joint Mx"); with
---interaction = "linear" the share of tension is added ("joint Mx + tension", EN 1993-1-8, 6.2.7.1 (3)); the rotation
---over the capacity ("joint rotation x"), and the forces at which the joint or a connector breaks ("joint tension",
---"joint shear", "connector force z"). One that has broken by a limit of its own has its largest values. A joint
---without a strength about an axis has a remark.
---```lua
---local used = hinge.results.utilisation(run, { model = model, standard = "EN 1993-1-1",
---  lengths = { kx = 2, ky = 2 } })
---print(used)
---for _, row in ipairs(used.rows) do print(row.index, row.utilisation, row.check, row.remark) end
---```
---@param runs hinge.run|hinge.run[]|hinge.results_envelope
---@param options hinge.utilisation_options
---@return hinge.results_utilisation
function results.utilisation(runs, options) end

---@class hinge.utilisation_options: hinge.results_source
---@field standard "EN 1993-1-1"|"AISC 360"
---@field lengths? hinge.buckling_lengths|hinge.lengths_by_group one for all members, or by group or function
---@field every? integer as of hinge.envelope_options
---@field names? string[]
---@field gamma_M0? number EN 1993-1-1: default 1; the same holds for gamma_M1
---@field gamma_M1? number
---buckling curves "a0", "a", "b", "c" or "d" about x and y, of EN 1993-1-1; default: table 6.2. A section with fillets
---counts as rolled, without as welded; CHS, SHS and RHS as hot finished; pipes and boxes with radii of another name as
---cold formed. A welded box has curve b; with thick welds and b / tf below 30 the table has c, which is to be given
---@field curves? string|{ x?: string, y?: string }
---@field curve_LT? string of lateral torsional buckling; default: table 6.4
---factors of equivalent moments of annex B; default 1, which is on the safe side. "B.3": table B.3 where a moment is
---straight from end to end, else 1. It is for members whose ends do not sway: table B.3 has 0.9 for the others
---@field Cm? number|{ x?: number, y?: number, LT?: number }|"B.3"
---moments beside an axial force in 6.2.9: "standard" (default); "linear": 1 - N / N_pl; "exact": those of the section's
---shape, section:reduced_moments
---@field interaction? "standard"|"linear"|"exact"

---@alias hinge.lengths_by_group table<string, hinge.buckling_lengths>|fun(m: hinge.member): hinge.buckling_lengths

---Buckling lengths of a member. x: bending about the section's x axis.
---@class hinge.buckling_lengths
---@field kx? number buckling length over the member's length; default 1
---@field ky? number
---@field Lx? number m, in place of kx
---@field Ly? number m
---@field Lb? number m, between lateral supports; default: no lateral torsional buckling
---@field C1? number EN 1993-1-1: by the shape of the moments between lateral supports; default 1
---@field Cb? number AISC 360: the same

---A table of utilisations, the largest first. A row of a joint has joint (its name, as in run:hinges) and the member
---that it is at. A row has utilisation, check (the clause or equation that governs), x (m;
---nil: the member as a whole), when (s, or a name), law (the largest √f_y of the section's own law), slenderness (of
---plates, over their limit), remark, checks ({ [name] = { value =, x =, when = } }) and each check by its name.
---@class hinge.results_utilisation: hinge.results_table
---@field states integer
local used = {}

---Adds the state that a run has now.
---```lua
---local used = hinge.results.utilisation({}, { model = model, standard = "AISC 360" })
---used:add(run, "at rest")
---```
---@param run hinge.run
---@param name? string
---@return hinge.results_utilisation self
function used:add(run, name) end

---Draws the utilisations as bars, the largest above.
---```lua
---hinge.results.utilisation(run, { model = model, standard = "AISC 360" }):plot "utilisation.png"
---```
---@param job? hinge.job may be left out: plot(filename, options)
---@param filename string plain name ending in .png, .svg or .pdf
---@param options? { top?: integer, title?: string } default: 20 members
---@return hinge.results_utilisation self
function used:plot(job, filename, options) end

---Drift and shear force of each storey in x and y, with their largest values over runs that are read as by
---hinge.results.envelope. Drift is that of the column line with the largest one: the difference of the displacements of
---two nodes, one above the other, over the height. The shear force is the sum of the horizontal forces, in space, of
---all members at half the height of the storey: by what is above on what is below. A row has storey, from, to, drift_x,
---drift_x_when, drift_x_min, drift_x_max, drift_x_last, line_x (the upper node of the line), shear_x, ... and the same
---for y.
---```lua
---local frame = hinge.model()
---local low, high = frame:node { 0, 0, 0 }, frame:node { 0, 0, 3 }
---frame:fix(low)
---frame:member { low, high, section = square, material = steel }
---frame:load { node = high, force = { 100, 0, 0 } }
---local pushed = frame:static():finish()
---local floors = hinge.results.storeys(pushed, { model = frame, levels = { 0, 3 } })
---print(floors.rows[1].drift_x, floors.rows[1].shear_x) -- and 100 N
---```
---@param runs hinge.run|hinge.run[]
---@param options? hinge.storeys_options
---@return hinge.results_storeys
function results.storeys(runs, options) end

---@class hinge.storeys_options
---@field model? hinge.model
---@field levels? number[] m, heights of the base and of the floors; default: those of level members
---@field every? integer as of hinge.envelope_options
---@field names? string[]
---@field units? string

---@class hinge.results_storeys: hinge.results_table
---@field levels number[] m
---@field states integer
local floors = {}

---Adds the state that a run has now.
---```lua
---local mast = hinge.model()
---local low, high = mast:node { 0, 0, 0 }, mast:node { 0, 0, 3 }
---mast:fix(low)
---mast:member { low, high, section = square, material = steel }
---mast:load { node = high, force = { 100, 0, 0 } }
---local floors = hinge.results.storeys({}, { model = mast, levels = { 0, 3 } })
---local push = mast:static { steps = 4 }
---for step in push:steps() do floors:add(push, ("step %d"):format(step.index)) end
---```
---@param run hinge.run
---@param name? string
---@return hinge.results_storeys self
function floors:add(run, name) end

---Draws the largest drift, or shear force, of each storey over the height.
---```lua
---local mast = hinge.model()
---local low, high = mast:node { 0, 0, 0 }, mast:node { 0, 0, 3 }
---mast:fix(low)
---mast:member { low, high, section = square, material = steel }
---mast:load { node = high, force = { 100, 0, 0 } }
---hinge.results.storeys(mast:static():finish(), { model = mast, levels = { 0, 3 } }):plot "drifts.png"
---```
---@param job? hinge.job may be left out: plot(filename, options)
---@param filename string plain name ending in .png, .svg or .pdf
---@param options? { quantity?: "drift"|"shear", units?: string, title?: string } default: drift
---@return hinge.results_storeys self
function floors:plot(job, filename, options) end

---Reactions of supports, their sum, the loads that act, the weight, and what is left. Its remark says whether they are
---in balance. In dynamics the rest is what inertia and damping have. rows.sum, rows.loads and rows.rest are those rows.
---```lua
---local feet = hinge.results.base(run, { model = model })
---print(feet, feet.balanced, feet.rows.sum.Fz) -- N
---```
---@param run hinge.run
---@param options? hinge.base_options
---@return hinge.results_base
function results.base(run, options) end

---@class hinge.base_options
---@field model? hinge.model
---@field gravity? vec3 m/s^2, with the factor of its load case: for the weight; default: none
---@field about? vec3 m: moments of sums are about this point; default the origin
---@field units? string

---@class hinge.results_base: hinge.results_table
---@field balanced boolean
---@field mass number kg

---The calls of hinge.results for one model, which then need not be given.
---```lua
---local out = hinge.results.of(model)
---print(out.members(run), out.base(run))
---```
---@param model hinge.model
---@return hinge.results
function results.of(model) end

---A table of results. print shows it as text. Rows are in SI units, and stay in the order of declaration.
---@class hinge.results_table
---@field rows table[]
---@field notes string[] remarks below the table
local any_table = {}

---How a table is shown.
---@class hinge.table_view
---@field columns? string[] fields of rows, in their order; default: those that are not zero throughout
---field by which rows are sorted: the largest size first, texts by the alphabet; default: the order of rows
---@field sort? string
---@field top? integer the first rows alone
---@field units? string as of hinge.results_source

---The table as aligned text.
---```lua
---local forces = hinge.results.members(run, { model = model })
---print(forces:text { columns = { "index", "Mx_min" }, sort = "Mx", top = 10, units = "kN, m" })
---```
---@param options? hinge.table_view
---@return string
function any_table:text(options) end

---The table in Markdown.
---```lua
---print(hinge.results.members(run, { model = model }):markdown())
---```
---@param options? hinge.table_view
---@return string
function any_table:markdown(options) end

---The table as a tabular of LaTeX.
---```lua
---print(hinge.results.members(run, { model = model }):latex())
---```
---@param options? hinge.table_view
---@return string
function any_table:latex(options) end

---Writes the table as a CSV file into the output folder, with all columns. Places and times have columns of their own.
---```lua
---hinge.results.members(run, { model = model }):csv "members.csv"
---```
---@param filename string plain name ending in .csv
---@param options? hinge.table_view
---@return hinge.results_table self
function any_table:csv(filename, options) end

---A benchmark: a problem whose answer is published or has a closed form. It is a scenario: a script returns it, and
---`hinge run` runs it, prints its rows, and ends with status 1 if a row lies outside its tolerance. A folder of them
---runs as one table by scripts/benchmarks/all.lua, with `folder=` for one of your own: each in a process of its own,
---several at once. What has failed is a row as well. Right rows do not hide a run that failed: where that is meant, the
---function calls job:verdict "completed". results.csv has all rows. scripts/benchmarks/README.md explains
---the columns.
---```lua
---local sag = hinge.benchmark { title = "Cantilever", kind = "elastic", source = "closed form", fast = true,
---  run = function(b)
---    local _, _, uz = tip:displacement(model:static { steps = 1 }:finish())
---    local bending, shear = 1 / (3 * steel.E * square.Ix), 1 / (steel.G * square.shear_area_y)
---    b:row { "deflection", computed = -1e3 * uz, reference = 1e3 * 1000 * (bending + shear), unit = "mm",
---      tolerance = 1e-4, elements = 2 }
---  end }
---print(sag.benchmark.title)
---```
---@param options hinge.benchmark_options
---@return hinge.scenario
function hinge.benchmark(options) end

---@class hinge.benchmark_options
---@field title string
---elastic: statics without yield. stability: buckling and limit points. inelastic: plastic hinges, limit loads.
---dynamics: vibration and impact. test: a structure that was measured
---@field kind "elastic"|"stability"|"inelastic"|"dynamics"|"test"
---@field source string where the references come from
---@field fast? boolean true: it takes under a second; all.lua with fast=true runs these. Default false
---@field missing? string what the model leaves out; it is printed, and stands in the table of the README
---true: its references were not found in a public text. Its rows are marked so, and are not in the medians, the largest
---errors and the picture. Default false
---@field unconfirmed? boolean
---computes, and calls b:row for each number. The second argument is that of a scenario's run, for pictures and notes
---@field run fun(b: hinge.benchmark, job: hinge.job)

---@class hinge.benchmark what the function `run` of a benchmark gets
local benchmark = {}

---Adds a row: what was computed beside its reference. It prints it. A computed value that is not a number, or has no
---end, makes a row that is not right; it is no error. A benchmark without a row has failed.
---```lua
---local turned = hinge.benchmark { title = "Slope", kind = "elastic", source = "closed form", run = function(b)
---  local _, _, _, _, ry = tip:displacement(model:static { steps = 1 }:finish())
---  b:row { "slope of the tip", computed = ry, reference = 1000 / (2 * steel.E * square.Ix), unit = "rad",
---    tolerance = 1e-4, elements = 2 }
---end }
---```
---@param options hinge.benchmark_row
---@return hinge.benchmark_result row
function benchmark:row(options) end

---@class hinge.benchmark_row
---the quantity, in a few words. With "observed order" in it, or "order" at its beginning, it is an order of
---convergence, which all.lua leaves out of the median and the largest error
---@field [1] string
---@field computed number
---@field reference number never computed by hinge itself
---@field unit? string of both; default "", a number without one
---largest |error| of a row that is right, as a part of the reference (or of scale). Take 1.5 to 2 times the error that
---was found, 1e-6 at least, so that a change shows
---@field tolerance number
---@field scale? number what the error is a part of, above 0; needed if the reference is 0. Default |reference|
---@field elements integer elements in the member or structure, 1 or more
---@field steps? integer of the run; default 1

---@class hinge.benchmark_result a row as it was found, with the fields that it was given
---@field quantity string
---@field error number (computed - reference) / scale
---@field right boolean whether |error| is within the tolerance; false where the error is not a number
---@field seconds number s of the processor, since the row before or the beginning

---Makes a scenario: parameters, cases and a function to run. A script returns it to the program. A script may also be
---plain statements. It then gets the settings key=value of the command line in a table, `...`, and its return value is
---its results. A setting that such a script does not read is an error. The error comes before the script runs if its
---text shows it (local p = ..., then p.speed), else at its end. Plain Lua does not run a scenario that a script
---returns. This is an error there, which says how to run it.
---```lua
---return hinge.scenario {
---  parameters = { force = 1000 }, -- N; hinge run SCRIPT force=2000
---  cases = { heavy = { force = 3000 } }, -- hinge run SCRIPT --case heavy
---  run = function(p, job)
---    model:load { node = tip, force = { 0, 0, -p.force } }
---    local pushed = model:static():finish()
---    job:picture(pushed, { title = "pushed" }, "pushed.png")
---    return { tip_mm = 1000 * select(3, tip:displacement(pushed)) }
---  end,
---}
---```
---@param options hinge.scenario_options
---@return hinge.scenario
function hinge.scenario(options) end

---@class hinge.scenario_options
---names and defaults (numbers, strings, booleans, lists of numbers). `key=value` changes them; a number may be a sum
---such as 440/3.6
---@field parameters? table<string, any>
---@field cases? table<string, table> named sets of changes for --case
---settings of accuracy against computing time: each is a list whose first item is the default
---@field accuracy? table<string, any[]>
---named functions for `hinge study --propose NAME`: each gets the cases that have ended and returns the parameters of
---the next, as `propose` of hinge.study
---@field proposals? table<string, fun(cases: hinge.study_case[]): table|nil>
---what a study of the scenario varies, as `vary` of hinge.study. `hinge study SCRIPT` and hinge.study take it for the
---names for which they get nothing else; with proposals it has no effect
---@field vary? table<string, any>
---@field run fun(p: table, job: hinge.job): any returns the results kept in summary.json

---@class hinge.scenario

-- Pictures, plots and frames without a job ----------------------------------------------------------------------------

---hinge.frame, hinge.animate, hinge.picture, hinge.strip, hinge.plot and hinge.note do the same as job:frame,
---job:animate, job:picture, job:strip, job:plot and job:note. They are for scripts of plain statements and for any Lua
---5.4. The output folder is that of `hinge run`, else the folder where Lua was started.
---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---for step in swing:steps() do
---  if step.index % 50 == 0 then hinge.frame(swing) end
---end
---```
---@param run hinge.run
function hinge.frame(run) end

---See job:animate.
---```lua
---hinge.animate(model:static():finish():modes { n = 1 }[1], { frames = 8 })
---```
---@param mode hinge.mode
---@param options? { frames?: integer, amplitude?: number }
function hinge.animate(mode, options) end

---```lua
---hinge.picture(run, { title = "under 1 kN", width = 800, height = 600 }, "cantilever.png")
---hinge.picture(run, { scale = 50, ghost = true, supports = true, loads = true, show = "Mx", view = "front",
---  labels = true }) -- picture.png
---```
---@param run hinge.run see job:picture
---@param view? hinge.view
---@param filename? string plain name ending in .png; default picture.png, then picture-2.png and so on
function hinge.picture(run, view, filename) end

---```lua
---hinge.strip({ { run, { title = "all" } }, { run, { groups = { "arm" } } } }, 2, "side_by_side.png")
---```
---@param snapshots { [1]: hinge.run|hinge.snapshot, [2]?: hinge.view }[] see job:strip
---@param columns integer snapshots in a row
---@param filename string plain name ending in .png
function hinge.strip(snapshots, columns, filename) end

---```lua
---local swing = model:dynamic { dt = 1e-4, duration = 0.01 }
---local sag = swing:probe { node = tip, "uz" }
---swing:finish()
---hinge.plot(swing, "swing.png") -- its energies and the sag over time
---hinge.plot(swing, { "kinetic", "elastic", sag, title = "swing" }, "swing.svg")
---hinge.plot({ series = { { x = sag.time, y = sag.value } }, x_label = "s", y_label = "m" }, "sag.png")
---```
---@overload fun(what: hinge.plot|hinge.panels|hinge.run|string, filename: string)
---@param what hinge.plot|hinge.panels|hinge.run|string see job:plot
---@param choice? hinge.history only with a run or its folder: what of it
---@param filename string plain name ending in .png, .svg or .pdf
function hinge.plot(what, choice, filename) end

---```lua
---hinge.note(("the tip is at z = %.4f m"):format(select(3, tip:position())))
---```
---@param text string it is printed, and kept in summary.json
function hinge.note(text) end

-- Studies ------------------------------------------------------------------------------------------------------------

---Runs a scenario with many values of its parameters. Each case runs in a process of its own, `jobs` at a time. A
---crash, a hang or too much memory costs one case. `hinge study SCRIPT` does the same from the command line. Cases are
---the product of all values, the first name in alphabetical order varying slowest; draws are the same for each
---combination of the others. Writes results.csv, times.csv, summary.json, pictures, and a folder a case into `out`.
---Linux only.
---```lua
---local pushed = hinge.scenario { parameters = { force = 1000 }, run = function(p)
---  model:load { node = tip, force = { 0, 0, -p.force } }
---  local run = model:static():finish()
---  return { tip_mm = 1000 * select(3, tip:displacement(run)) }
---end }
---local study = hinge.study(pushed, { vary = { force = { 1000, 2000, 3000 } }, pictures = false, restart = true })
---for _, case in ipairs(study.cases) do print(case.parameters.force, case.results.tip_mm) end
---```
---@param scenario hinge.scenario
---@param options? hinge.study_options
---@return hinge.study_result
function hinge.study(scenario, options) end

---@class hinge.study_options
---what varies, by name: a list of values; { from =, to =, by = }; or a distribution as text: "normal(mean,deviation)",
---"lognormal(median,deviation of the logarithm)", "uniform(lowest,highest)", "triangular(lowest,likeliest,highest)",
---"weibull(scale,shape)", "choice(a,b,...)" of texts or numbers. A single value holds for all cases
---@field vary? table<string, any>
---@field cases? string[] names of the scenario's cases, each with all values
---@field case? string the one case of the scenario that all cases of the study start from
---@field table? string CSV file with names in its first line, and a combination of values a row
---@field samples? integer how many draws, default 100
---"lhs" (default): a Latin hypercube; "sobol": Sobol's sequence with a random digital shift, up to 21 parameters;
---"plain": independent draws
---@field method? "lhs"|"sobol"|"plain"
---@field seed? integer the same one gives the same draws on every machine; default 1
---proposes what runs next: gets the cases that have ended, in order; returns a table of parameters, a list of such
---tables, or nil at the end. It is asked when all that it proposed before has ended. Single values of vary hold for all
---cases then; several values of one name, cases, table, samples, method and seed are errors
---@field propose? fun(cases: hinge.study_case[]): table|nil
---@field jobs? integer cases at a time; default: the cores that there are
---@field timeout? number s, the most that a case may take
---@field memory? number bytes, the most that a case may take beyond what the script has when the study begins
---folder, default out/study. An error if another process writes to it
---@field out? string
---@field resume? boolean keep finished cases whose script, modules, data files and engine are the same; default false
---@field restart? boolean run all again, also what the folder holds; default false: an error where it holds cases
---@field progress? boolean a line on stderr, default false
---@field pictures? boolean default true

---@class hinge.study_case
---@field number integer its place in the study, from 1
---@field case? string the scenario's case
---@field parameters table<string, any> those that the study set
---"completed", "stopped" by the script, "failed", "wrong" (an error of the script or of its input), "crashed",
---"timed out", "out of memory"
---@field verdict string
---@field reason? string
---of a case with the verdict "failed": run.failure.cause of the run that failed
---@field cause? hinge.failure_cause|"not_written"
---what the scenario returned, names in tables joined by dots. The names of columns that results.csv has of its own are
---errors: number, case, verdict, reason, steps, energy_error. So is that of a parameter that varies, if the value is
---another
---@field results table<string, number|string|boolean>
---@field energy_error? number of the last run, as a part of its largest energy
---@field steps? integer of the last run
---@field warnings? string[] run.warnings of its last run; nil: none. `hinge study` prints the first of all
---@field seconds number from start to end
---@field memory number bytes, the most that its process held
---@field folder string its folder, within the study's

---The chance that a result is true, as a normal distribution of a parameter, or of its logarithm where all its values
---are positive; by maximum likelihood. It takes three values of the parameter and eight cases whose outcomes overlap
---and show a trend beyond chance (95 %); else `notes` say why there is none.
---@class hinge.fragility
---@field quantity string
---@field parameter string
---@field median number half of the cases are true there
---@field dispersion number standard deviation of the parameter, or of its logarithm
---@field of_logarithm boolean

---@class hinge.study_result
---@field cases hinge.study_case[] in order
---@field varied string[] names that vary, as in results.csv
---@field folder string
---@field pictures string[] their file names in the folder
---@field fragility? hinge.fragility[] curves of true and false results, as far as the cases tell
---@field correlations? { quantity: string, parameter: string, correlation: number, cases: integer }[]
---@field notes? string[]
---@field interrupted boolean

-- What accuracy costs -------------------------------------------------------------------------------------------------

---Runs a scenario with each of its accuracy settings, and compares the answers with a reference. The runs are in
---this process, each with its own models. The reference is finer than all settings, and a second reference tests it.
---The error of an answer has a band: from the order of convergence if that is clear (Richardson), else from the
---scatter of the finest runs. An answer is chaotic if it changes by more than half of `within` under relative
---changes of 1e-9, or if the two references differ by no more than runs of one setting do. Such runs have their time
---step, if it is varied, shorter by one to four thousandths, and all other numbers that are not whole changed by
---1e-9. A chaotic answer has mean and scatter in place of an error. Answers are the numbers and lists of numbers
---that the scenario returns, and the probes of its runs (as histories). The scenario prints and draws nothing
---meanwhile. `hinge cost SCRIPT` prints the result. With effects = true the settings do not change. The scenario
---runs with its parameters, and once more without each effect that its models declare (gravity, large displacement,
---plasticity, fracture, contact, friction). Where sections can yield it runs with other laws of sections too: the exact
---interaction in the place of eq 14 or the other way round, without hardening, without the strain rate. `hinge cost
---SCRIPT --effects` prints this result.
---```lua
---local scenario = hinge.scenario {
---  accuracy = { dt = { 2e-4, 4e-4 } },
---  run = function(p)
---    local swing = model:dynamic { dt = p.dt, duration = 0.01 }:finish()
---    return { sag = select(3, swing:displacement(tip)) }
---  end,
---}
---local cost = hinge.cost(scenario, { within = 0.01, repeats = 1 })
---for _, setting in ipairs(cost.settings) do print(setting.label, setting.seconds, setting.error) end
---```
---@param scenario hinge.scenario
---@param options? hinge.cost_options
---@return hinge.cost_result|hinge.effects_result
function hinge.cost(scenario, options) end

---@class hinge.cost_options
---@field within? number the largest accepted error, as a part of the value; default 0.01
---@field quantity? string the answer that is compared; default: the one with the largest error, of those that have one
---@field case? string
---changes of the scenario's parameters; an accuracy setting among them stays fixed
---@field parameters? table<string, any>
---s, limit of the time. Cheap settings come first. A setting is not begun if the time, by what finished runs took,
---is too short for it and its references; `left_out` has it. If there is no time for references, the error comes
---from the settings themselves. The plot takes about a second more. Default: no limit
---@field budget? number
---how often each setting is timed, in alternating order; default 3. If it is more than 1, short settings are timed more
---often, up to 21 times or 0.1 s
---@field repeats? integer
---folder for cost.csv, cost.png, summary.json and finished.lua. A second call continues from finished.lua. It has the
---measurements, by the content of the script and of the files that it has read, the settings and the version of hinge.
---Default: nothing is written
---@field out? string
---in place of the scenario's own. If there is neither, the parameters with names such as dt, elements_per_member and
---formulation are used
---@field accuracy? table<string, any[]>
---for numbers with other names: which side is finer, "smaller" or "larger". A number without this is varied too, but
---the reference has its default
---@field finer? table<string, string>
---for numbers: the order of convergence from theory. Default: 2 for dt and elements, 1 for tolerances and steps
---@field orders? table<string, number>
---relative change of every number that is not whole, to look for chaotic answers; default 1e-9
---@field perturbation? number
---@field progress? boolean prints lines on stderr; default false
---true: leave out effects instead; default false. `accuracy` then serves only for one finer run, to show the error of
---the setting itself. `out` gets effects.csv and laws.csv in place of cost.csv and cost.png
---@field effects? boolean

---@class hinge.cost_result
---@field settings hinge.cost_setting[] settings with an answer, the cheapest first
---@field front hinge.cost_setting[] the Pareto front: no other setting is both cheaper and better
---@field cheapest? hinge.cost_setting whose error, with its band, is up to `within`
---the answers that count for the error of a setting: all that are sound; if none is, all that have a band
---@field compared_by string[]
---@field finest string label of the finest run: a reference or, if no reference was run, a setting
---a setting that would be within `within` by the observed order, where none that was run is; seconds: an estimate
---@field beyond? { values: table, label: string, seconds: number }
---references that were run, up to two
---@field finer { values: table, label: string, seconds: number, answers: table, high?: number }[]
---@field quantities table<string, hinge.cost_quantity> by answer
---@field orders table<string, hinge.cost_order> by name of the number: the order of convergence
---for each setting without a finer side (formulation, integrator, ...): the time of its values at equal error, the
---largest error first. The errors are `within`, that of the cheapest setting, and the smallest one that all values
---reach, if these differ and are more than rounding
---@field equal table<string, { error: number, methods: hinge.cost_method[] }[]>
---the two references, the coarser one first; nil: `notes` says why
---@field references? { values: table, label: string, seconds: number, answers: table }[]
---@field failed hinge.cost_setting[] settings without an answer; `failed` says why
---settings left out by the budget; s for each, and s for its references
---@field left_out { label: string, values: table, estimate: number, rest: number }[]
---@field complete boolean nothing is left out
---@field notes string[]
---@field inputs table[] what is varied: name, values, and for numbers the finer side
---@field elapsed number s
---@field within number
---@field perturbation number
---@field quantity? string
---@field case? string

---@class hinge.cost_quantity
---"sound"; "chaotic": it changes much under small changes of the input; "unsettled": the references differ by more
---than half of `within`; "moving": it differs from run to run; "unknown": there are no two references
---@field state string
---@field kind string "number" or "history"
---@field value? number of the finest run
---@field agreement? number difference between the two references
---@field scatter? number as a part of the value, or of the largest value of a history
---where the band of the errors comes from. "order": the observed order of convergence (Richardson); "theory": two
---values, the order in theory and a safety factor of 3; "scatter": of the finest three runs, and of runs that are
---changed slightly; "grows": refinements change it in one direction by no less each time, errors are lower bounds;
---"open": there is one run alone, errors are lower bounds; "exact". nil: it is moving
---@field by? string
---@field half? number by so much the best known value may be off, as a part of it; half the width of the bands
---@field order? number observed, if by = "order"; of all numbers together, in terms of halved steps
---@field extrapolated? number the value without error by the observed order, if by = "order"
---@field standard? string if chaotic: label of the finest setting with changed runs
---@field alike? string[] if chaotic: labels of the settings whose means cannot be told apart from that of `standard`

---@class hinge.cost_order
---@field observed? number the median over the answers; math.huge: exact
---@field theory? number
---@field why? string
---@field note? string
---@field quantities table<string, number> by answer

---@class hinge.cost_method
---@field value any the value of the setting
---with the best values of all other settings; between two settings by a straight line on logarithmic axes
---@field seconds number
---@field ratio number time over the shortest time of those that reach the error
---@field settings hinge.cost_setting[] the setting with at most this error, or the two settings around it
---@field more? boolean true: even its best setting does not reach the error; seconds are of that setting

---@class hinge.effects_result
---@field effects hinge.effect_cost[] effects of the scenario that can be left out
---@field laws hinge.law_cost[] other laws of its sections; empty if none can yield
---@field values table<string, number|{ x: number[], y: number[] }> the answers of the scenario as it is
---@field absent string[] effects that can be left out, and that the scenario does not have
---@field left_out string[] effects and laws that were not tried, because of the budget
---for answers that are the same from run to run. scatter: its change when every number changes slightly. error: its
---difference from the answer of a setting twice as fine
---@field answers table<string, { scatter?: number, error?: number }>
---@field finer? string the setting twice as fine; nil: `notes` says why
---@field seconds number with all effects: time of the steps of all runs, the median of `times`
---@field times number[]
---@field energy_error number the energy error, as in hinge.cost_setting
---@field notes string[]
---@field complete boolean nothing is left out by the budget
---@field elapsed number s
---@field within number
---@field perturbation number
---@field quantity? string
---@field case? string

---@class hinge.effect_cost
---@field name string
---change of the answer that changes most without the effect, as a part of its value or of the largest value of a
---history. The answers that change by more than their scatter come first, else all count
---@field change? number
---@field worst? string that answer's name
---@field changes table<string, number> by answer; math.huge: there is no answer without the effect
---@field same boolean the effect has no influence: states and answers are the same to the bit without it
---@field lost boolean the answer changes, but not by more than its scatter
---part of the time that the effect takes, the median over the rounds; negative: the scenario takes longer without it
---@field saves? number
---@field spread? number half the width of the middle half of the rounds, for `saves`
---@field seconds? number without it, the median of `times`
---@field times? number[]
---@field energy_error? number the energy error without it
---@field answers? table<string, number|{ x: number[], y: number[] }> without it
---@field failed? string why the scenario has no answer without it: the error's first line

---As hinge.effect_cost, with the change of the law in the place of the effect that is left out.
---@class hinge.law_cost
---"exact in the place of eq 14", "eq 14 in the place of exact", "without hardening", "without strain rate"
---@field name string
---@field law "eq 14"|"exact"|"hardening"|"strain rate" the law that is left out
---@field change? number
---@field worst? string
---@field changes table<string, number>
---@field same boolean
---@field lost boolean
---@field slower? number time over that of the scenario as it is, less 1; negative: it is faster
---@field spread? number half the width of the middle half of the rounds, for `slower`
---@field seconds? number
---@field times? number[]
---@field energy_error? number
---@field answers? table<string, number|{ x: number[], y: number[] }>
---@field failed? string

---@class hinge.cost_setting
---@field values table<string, any>
---@field label string
---estimated error of the answer with the largest one, as a part of its value. nil: no answer has an error
---@field error? number
---@field low? number lower end of the band of that error
---@field high? number upper end of the bands of all answers that count; math.huge: not known
---@field worst? string the answer's name
---@field below? boolean the error may be 0; `error` is the upper end of the band
---@field above? boolean only a lower bound is known, which is `error`
---by answer: the difference from the finest run, as a part of its value; for histories, the root mean square
---difference over the largest value
---@field errors table<string, number>
---by answer: the difference again, the estimated error and its band, as parts of the best known value
---@field estimates table<string, { difference: number, error: number, low: number, high: number }>
---@field warnings string[] of all its runs
---by chaotic answer. runs: how many; scatter: standard deviation as a part of the mean; difference: of the mean from
---that of the finest setting, as a part of it; apart: the scatter does not explain the difference (Welch's test, 95
---%)
---@field means? table<string, { mean?: number, runs: integer, scatter: number, difference: number, apart: boolean }>
---@field answers table<string, number|{ x: number[], y: number[] }>
---@field seconds number time of the steps of all runs, the median of `times`; for a scenario without runs, of all
---@field times number[]
---@field ratio number seconds over those of the cheapest setting
---@field outside number s outside the steps: making models, and the code of the script
---@field stages table<string, number> s by stage of a step, of the fastest run
---@field memory? number bytes, the most memory that it used
---@field energy_error number the largest energy error of its runs over the energy at the start and the work at the end
---@field front boolean
---@field meets boolean
---@field failed? string

return hinge

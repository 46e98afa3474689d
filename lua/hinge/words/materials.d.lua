---@meta
-- Materials and backbones ---------------------------------------------------------------------------------------------

---@class hinge
local hinge = {}

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
---the yield rotation. lua/hinge/sections/lignos.lua and the files backbones.lua of lua/hinge/standards have the
---numbers, name the source of each table and say what was not confirmed: no standard was at hand. The formulas of a
---rule hold for bending about the strong axis.
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

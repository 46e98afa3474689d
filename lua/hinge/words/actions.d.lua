---@meta
-- Combinations, pressure, moving loads, blast -------------------------------------------------------------------------

---@class hinge
local hinge = {}

---Makes the load combinations of a standard from load cases, and declares them by model:combination. Each variable
---action leads in turn, and the others accompany it. A load that helps is absent: every set of variable actions is
---there, and permanent ones have both of their factors. Combinations with the same factors are declared once, also over
---several calls. `loads` of a run takes them by name, such as "ULS 1.35 dead + 1.5 office". In a name, permanent cases
---that have one factor are written as G, or D in ASCE 7. Loads and gravity that belong to no case act in every run with
---the factor 1. No standard was at hand: the files combinations.lua of lua/hinge/standards name the source of each
---table, and what was not confirmed. Wrong input is an error, and nothing is declared.
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

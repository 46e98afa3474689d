---@meta
-- Sections ------------------------------------------------------------------------------------------------------------

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

// What members are coloured by: a colour for each element of a frame, or bands along it, and a legend.
import { bands_of, band_colours, class_of } from "./bands.js";
import { force, largest_force, law_text, state, state_of, touched_of, broken } from "./run_data.js";

const rgb = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
const steps = band_colours.map(rgb);
// black: a broken element, as in pictures
const black = rgb("#0a0a0c"), grey = rgb("#a9bccf"), orange = rgb("#e07b30"), purple = rgb("#7b3294");
// Of members by the part of the runs in which they broke, as in pictures (src/output/colours.h): none, fewer than half,
// half or more, all.
const shares = ["#c4cad0", "#e6842c", "#c2302c", "#0a0a0c"].map(rgb);
const share_class = (count, runs) => (count <= 0 ? 0 : count >= runs ? 3 : 2 * count < runs ? 1 : 2);

// The numbers of runs that are in a class, as text; null where none is.
function share_text(share, runs) {
  const all = Array.from({ length: runs + 1 }, (_, n) => n).filter((n) => share_class(n, runs) === share);
  if (all.length === 0) return null;
  const last = all[all.length - 1];
  return `broken in ${all.length === 1 ? last : `${all[0]}${all.length === 2 ? " or " : "–"}${last}`} of ${runs}`;
}

export const group_colours = ["#1f77b4", "#e0862d", "#3f9b4f", "#b23a48", "#7b5ea7", "#8c6d4f", "#d076ab", "#7f8790",
  "#a6a832", "#2aa6b5"];
const hex = (c) => `rgb(${c.join(",")})`;

function mixed(from, to, share) {
  const s = Math.min(1, Math.max(0, share));
  return from.map((v, i) => Math.round(v + s * (to[i] - v)));
}
const tension = rgb("#1f5fa8"), compression = rgb("#b2182b"), none = rgb("#c9d1d8");

// Broken elements are black, the others have bands.
const banded = (frames, frame) => (b) => (state_of(state(frames, frame, b)) === broken ? black : null);

/// Each: name, and of(frames, frame, scene) gives a function of an element's number, to its colour or to null where it
/// has the bands of bands(frames, frame); legend(frames, scene, frames of all runs): [colour, text] pairs; offered(frames):
/// whether they have what it shows; of_all_runs: of more than this run, whose hinges would be read as its colours.
export const colourings = {
  f_y: {
    name: "f_y, yield function",
    of: banded,
    bands: bands_of.f_y,
    legend: () => [...steps.map((c, i) => [hex(c), i < 5 ? `${(i / 5).toFixed(1)}–${((i + 1) / 5).toFixed(1)}` : "1.0"]),
      [hex(black), "broken"]],
  },
  state: {
    name: "damage",
    of: (frames, frame) => (b) => {
      const s = state(frames, frame, b);
      return state_of(s) === broken ? black : state_of(s) === 1 ? orange : touched_of(s) ? purple : grey;
    },
    legend: () => [[hex(grey), "elastic"], [hex(purple), "elastic, was in contact"], [hex(orange), "has yielded"],
      [hex(black), "broken"]],
  },
  axial: {
    name: "axial force N / N0",
    of: (frames, frame) => (b) => {
      if (state_of(state(frames, frame, b)) === broken) return black;
      const n = force(frames, frame, b, 0) / (frames.limits[4 * b] || frames.largest_force || 1);
      return mixed(none, n > 0 ? tension : compression, 1.6 * Math.abs(n));
    },
    legend: () => [[hex(compression), "compression"], [hex(none), "0"], [hex(tension), "tension"], [hex(black), "broken"]],
  },
  bending: {
    name: "bending M / M0",
    of: banded,
    bands: bands_of.bending,
    legend: () => [[hex(steps[0]), "0"], [hex(steps[2]), "0.5"], [hex(steps[5]), "1 or more"], [hex(black), "broken"]],
  },
  displacement: {
    name: "displacement",
    of: (frames, frame, scene) => {
      const { ends, declared, positions, nodes } = frames, most = scene.largest_displacement || 1;
      return (b) => {
        const node = ends[2 * b];
        if (node === 0xffffffff) return grey;
        const u = Math.hypot(...[0, 1, 2].map((c) => positions[3 * (nodes * frame + node) + c] - declared[3 * node + c]));
        return steps[class_of(u / most)];
      };
    },
    legend: (frames, scene) => {
      const most = scene.largest_displacement || 0;
      return [0, 2, 5].map((i) => [hex(steps[i]), `${Number((most * i / 5).toPrecision(2))} m`]);
    },
  },
  broken_in: {
    name: "broken in runs",
    of_all_runs: true,
    offered: (frames) => Boolean(frames.broken_in),
    of: ({ broken_in: { runs, count }, member }) => (b) => shares[share_class(count.get(member[b]) ?? 0, runs)],
    legend: ({ broken_in: { runs } }, _scene, all) => (all.every((f) => f.broken_in.runs === runs) ?
      shares.map((c, k) => [hex(c), share_text(k, runs)]).filter(([, text]) => text) :
      ["broken in no run", "in fewer than half", "in half or more", "in all"].map((text, k) => [hex(shares[k]), text])),
  },
  group: {
    name: "group",
    of: (frames) => {
      const colour = group_colours.map(rgb);
      return (b) => {
        const g = frames.members.get(frames.member[b]).groups;
        return g.length ? colour[g[g.length - 1] % colour.length] : grey;
      };
    },
    legend: (frames) => {
      const used = new Set([...frames.members.values()].map((m) => m.groups[m.groups.length - 1]));
      return [...used].filter((g) => g !== undefined).slice(0, 12).map((g) => [group_colours[g % group_colours.length],
        frames.groups[g]]);
    },
  },
};

/// The names of those that all of these runs have.
export const offered = (runs) => Object.keys(colourings).filter((k) => runs.every(({ frames }) =>
  colourings[k].offered?.(frames) ?? true));

/// The name of a colouring of these runs.
export function name_of(colouring, runs) {
  const laws = [...new Set(runs.flatMap(({ frames }) => (frames.laws.length ? frames.laws : ["eq 14"])))];
  return colourings[colouring].name + (colouring === "f_y" ? ` (${law_text(laws)})` : "");
}

/// What scales colours where a section has no limit, and the largest displacement of what is attached to supports.
/// first: the frames before it have been measured.
export function measure(frames, scene, first = 0) {
  let n = 0, m = 0, u = first > 0 ? scene.largest_displacement : 0;
  for (let b = 0; b < frames.bars; ++b) {
    n = Math.max(n, largest_force(frames, b, 0));
    for (const c of [1, 2, 3, 4]) m = Math.max(m, largest_force(frames, b, c));
    const node = frames.ends[2 * b];
    if (!frames.attached[b] || node === 0xffffffff) continue;
    for (let f = first; f < frames.count; ++f) {
      const o = 3 * (frames.nodes * f + node), d = 3 * node;
      u = Math.max(u, Math.hypot(frames.positions[o] - frames.declared[d], frames.positions[o + 1] - frames.declared[d + 1],
        frames.positions[o + 2] - frames.declared[d + 2]));
    }
  }
  frames.largest_force = n, frames.largest_moment = m, scene.largest_displacement = u;
}

// The frames of a run as core.pack_frames (src/script/bind/bind_frames.cpp) has packed them: typed arrays, and what follows
// from them: members, storeys, what is attached to a support.

const no_node = 0xffffffff;

function from_base64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const raw = atob(text), bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return bytes;
}

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Words of `size` bytes, as many in each of so many frames: planes of bytes, changes since the frame before.
async function unpacked(text, size, frames) {
  const bytes = await inflated(from_base64(text)), a_frame = bytes.length / size / frames;
  const words = new (size === 4 ? Uint32Array : size === 2 ? Uint16Array : Uint8Array)(bytes.length / size);
  for (let from = 0; from < words.length; from += a_frame)
    for (let i = 0; i < a_frame; ++i) {
      let change = 0;
      for (let b = 0; b < size; ++b) change |= bytes[from * size + b * a_frame + i] << (8 * b);
      words[from + i] = (from > 0 ? words[from - a_frame + i] : 0) + change;
    }
  return words;
}

const whole = async (text, size) => {
  const bytes = await inflated(from_base64(text));
  const n = bytes.length / size, words = new (size === 4 ? Uint32Array : Uint8Array)(n);
  for (let i = 0; i < n; ++i) for (let b = 0; b < size; ++b) words[i] |= bytes[b * n + i] << (8 * b);
  return words;
};
const floats = (words) => new Float32Array(words.buffer);

export const list = (value) => (Array.isArray(value) ? value : []);

/// What of a member or an element is drawn or listed in a frame.
export const broken = 2;
export const state_of = (byte) => byte & 3;
export const hinges_of = (byte) => (byte >> 2) & 7;
export const touched_of = (byte) => byte >> 5;

/// What differs from frame to frame.
export async function read_changes(packed) {
  const n = packed.frames;
  const [positions, count, which, loose, f_y, state, forces, scale] = await Promise.all([
    unpacked(packed.positions, 4, n), whole(packed.loose_count, 4), whole(packed.loose_end, 4),
    whole(packed.loose_at, 4), unpacked(packed.f_y, 2, n), unpacked(packed.state, 1, n),
    unpacked(packed.forces, 2, n), whole(packed.force_scale, 4)]);
  const f_y_along = packed.f_y_along ? await unpacked(packed.f_y_along, 2, n) : null;
  const [sags, sag_scale, pointed] = await Promise.all(packed.sags ? [unpacked(packed.sags, 2, n),
    whole(packed.sag_scale, 4), whole(packed.pointed, 4)] : [null, null, []]);
  const plate_forces = packed.plate_forces && new Int16Array((await unpacked(packed.plate_forces, 2, n)).buffer);
  const loose_from = [0];
  for (const c of count) loose_from.push(loose_from[loose_from.length - 1] + c);
  return {
    count: packed.frames, times: list(packed.times), factors: packed.factors ? list(packed.factors) : null,
    positions: floats(positions), loose_from, loose_end: which, loose_at: floats(loose),
    f_y, f_y_along, f_y_unit: packed.f_y_unit, state, forces: new Int16Array(forces.buffer), scale: floats(scale),
    plate_forces, plate_scale: packed.plate_scale || 0,
    sags: sags && new Int16Array(sags.buffer), sag_scale: sag_scale && floats(sag_scale), pointed: new Set(pointed),
  };
}

export async function read_frames(packed) {
  if (!packed) return null;
  const [declared, held, ends, member, width, limits, up, memberships, connected, changes] = await Promise.all([
    whole(packed.declared, 4), whole(packed.held, 1), whole(packed.ends, 4), whole(packed.member, 4),
    whole(packed.width, 4), whole(packed.limits, 4), whole(packed.up, 1), whole(packed.memberships, 4),
    whole(packed.connected, 4), read_changes(packed)]);
  const frames = {
    nodes: packed.nodes, bars: packed.bars, groups: list(packed.groups), laws: list(packed.laws || []),
    declared_nodes: packed.declared_nodes || packed.nodes, not_shown: packed.not_shown || 0, of_other_models: packed.of_other_models || 0,
    declared: floats(declared), held, ends, member, connected, width: floats(width), limits: floats(limits), up: new Int8Array(up.buffer),
    plates: packed.plates ? await whole(packed.plates, 4) : [], ...changes,
  };
  frames.abscissa = frames.factors || frames.times;
  measure_bars(frames);
  list_members(frames, memberships);
  find_storeys(frames);
  return frames;
}

// The declared length of each element, m, 0 where it is not known; and the section's y axis where a frame has none.
function measure_bars(frames) {
  const { bars, up } = frames;
  frames.long = new Float32Array(bars);
  for (let b = 0; b < bars; ++b) {
    const p = declared_at(frames, b, 0), q = declared_at(frames, b, 1);
    const along = p && q ? [0, 1, 2].map((c) => q[c] - p[c]) : [1, 0, 0];
    if (p && q) frames.long[b] = Math.hypot(...along);
    if (!up[3 * b] && !up[3 * b + 1] && !up[3 * b + 2])
      up.set(Math.abs(along[2]) < 0.9 * frames.long[b] ? [0, 0, 127] : [0, 127, 0], 3 * b);
  }
}

// members: number -> { bars, groups }; bars of members in the order of their numbers
function list_members(frames, memberships) {
  frames.members = new Map();
  for (let b = 0; b < frames.bars; ++b) {
    const m = frames.member[b];
    if (!frames.members.has(m)) frames.members.set(m, { number: m, bars: [], groups: [], storey: -1 });
    frames.members.get(m).bars.push(b);
  }
  for (let i = 0; i + 1 < memberships.length; i += 2)
    frames.members.get(memberships[i])?.groups.push(memberships[i + 1]);
}

// Where an end of an element was declared; null where it is not known.
export function declared_at(frames, bar, side) {
  const node = frames.ends[2 * bar + side];
  return node === no_node ? null : frames.declared.subarray(3 * node, 3 * node + 3);
}

// Floors are the heights of level members that hang together with a support, by members and connectors; a storey reaches from one to the next.
function find_storeys(frames) {
  const { bars, ends, held, nodes, declared, connected } = frames;
  const body = new Int32Array(nodes).map((_, i) => i);
  const root = (i) => {
    while (body[i] !== i) i = body[i] = body[body[i]];
    return i;
  };
  for (let b = 0; b < bars; ++b)
    if (ends[2 * b] !== no_node && ends[2 * b + 1] !== no_node) body[root(ends[2 * b])] = root(ends[2 * b + 1]);
  for (let i = 0; i + 1 < connected.length; i += 2) body[root(connected[i])] = root(connected[i + 1]);
  const supported = new Set();
  let base = Infinity;
  for (let i = 0; i < nodes; ++i)
    if (held[i] & 4) { // uz
      supported.add(root(i));
      base = Math.min(base, declared[3 * i + 2]);
    }
  frames.attached = new Uint8Array(bars);
  const heights = [];
  for (let b = 0; b < bars; ++b) {
    const p = declared_at(frames, b, 0), q = declared_at(frames, b, 1);
    if (!p || !q) continue;
    frames.attached[b] = supported.has(root(ends[2 * b])) ? 1 : 0;
    const run = Math.hypot(q[0] - p[0], q[1] - p[1]), rise = Math.abs(q[2] - p[2]);
    if (frames.attached[b] && rise < 0.02 * run) heights.push((p[2] + q[2]) / 2);
  }
  heights.sort((a, b) => a - b);
  const floors = [];
  for (const z of heights) if (z > base + 0.5 && (floors.length === 0 || z > floors[floors.length - 1] + 0.5)) floors.push(z);
  frames.base = Number.isFinite(base) ? base : 0;
  frames.floors = floors;
  frames.storey = new Int16Array(bars).fill(-1); // of each element, from 0
  if (floors.length === 0 || floors.length > 200) return;
  for (const m of frames.members.values()) {
    if (!frames.attached[m.bars[0]]) continue;
    let low = Infinity, high = -Infinity;
    for (const b of m.bars)
      for (const side of [0, 1]) {
        const at = declared_at(frames, b, side);
        if (at) low = Math.min(low, at[2]), high = Math.max(high, at[2]);
      }
    const middle = (low + high) / 2, k = floors.findIndex((z) => middle <= z + 0.05);
    m.storey = k < 0 ? floors.length - 1 : k;
    for (const b of m.bars) frames.storey[b] = m.storey;
  }
}

// Which of the six a plane model holds at all its nodes: one displacement and the two rotations that go with it, and
// rotations that no node has. The ends of a single beam are no such plane, though all may be held upwards.
function held_everywhere(held, nodes) {
  let all = nodes > 0 ? 63 : 0;
  for (let i = 0; i < nodes; ++i) all &= held[i];
  if (all === 63) return 0;
  const out_of_plane = [1 | 16 | 32, 2 | 8 | 32, 4 | 8 | 16].filter((plane) => (all & plane) === plane);
  return (all & 56) | (out_of_plane.length === 1 ? out_of_plane[0] & 7 : 0);
}

/// Supports as pictures show them (src/output/symbols.cpp): { node, kind, held }. kind: "plate" where all is held, "pin"
/// where the rotations are free, "roller" where some displacements are, "turns" where rotations alone are held. What all
/// nodes of a plane model hold does not count.
export function supports_of(frames) {
  const { held } = frames, nodes = Math.min(frames.declared_nodes, held.length), out = [];
  const everywhere = held_everywhere(held, nodes), moves = 7 & ~everywhere;
  const turns = 56 & ~everywhere;
  for (let i = 0; i < nodes; ++i) {
    const own = held[i] & ~everywhere;
    if (!own) continue;
    const stays = (own & moves) === moves;
    out.push({ node: i, held: own, free: moves & ~own, kind: stays ? ((own & turns) === turns ? "plate" : "pin") :
      own & moves ? "roller" : "turns" });
  }
  return out;
}

/// The largest displacement in the last frame, m, and where; of what is attached to supports, if anything is. `all`: of
/// all nodes. null where there is none.
export function largest_displacement(frames) {
  const { bars, ends, attached, declared, positions, nodes } = frames, from = 3 * nodes * (frames.count - 1);
  const any = attached.includes(1);
  let value = -1, at = -1, of = 0;
  for (let e = 0; e < 2 * bars; ++e) {
    const i = ends[e];
    if (i === no_node || (any && !attached[e >> 1])) continue;
    const u = Math.hypot(...[0, 1, 2].map((c) => positions[from + 3 * i + c] - declared[3 * i + c]));
    if (u > value) value = u, at = i, of = frames.member[e >> 1];
  }
  if (at < 0) return null;
  return { value, all: !any || !attached.includes(0),
    where: at < frames.declared_nodes ? `node ${at + 1}` : `a node inside member ${of}` };
}

/// In how many runs of hinge run --within each member broke, { runs, count: number -> how many }; null where that is not
/// known, where one run alone tells it, where none broke, or where the frames are of another model.
export function broken_in(summary, frames) {
  const of = summary?.accuracy?.broken, all = list(of?.list);
  if (!frames || all.length === 0 || !(of.runs > 1) || of.members !== frames.members.size) return null;
  return { runs: of.runs, count: new Map(all.map((m) => [m.member, m.broken])) };
}

/// The last frame at or before an abscissa (time or load factor); the first one before all.
export function frame_at(frames, at) {
  const x = frames.abscissa, slack = 1e-9 * Math.abs(x[x.length - 1] || 1);
  let low = 0, high = x.length - 1;
  if (Math.abs(at - x[high]) <= slack) return high; // also where a load factor has fallen
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (x[middle] <= at + slack) low = middle; else high = middle - 1;
  }
  return low;
}

/// Both ends of every element in a frame, magnified: 6 numbers each, into `out`. `part`: how far towards the next frame.
export function place_bars(frames, frame, magnify, out, part = 0) {
  const { nodes, bars, ends, declared, positions } = frames;
  const next = part > 0 && frame + 1 < frames.count ? 3 * nodes : 0, from = 3 * nodes * frame;
  for (let e = 0; e < 2 * bars; ++e) {
    const node = ends[e];
    if (node === no_node) continue;
    for (let c = 0; c < 3; ++c) {
      const i = 3 * node + c;
      let x = positions[from + i];
      if (next) x += part * (positions[from + next + i] - x);
      out[3 * e + c] = declared[i] + magnify * (x - declared[i]);
    }
  }
  for (let i = frames.loose_from[frame]; i < frames.loose_from[frame + 1]; ++i) {
    const e = frames.loose_end[i], node = ends[e];
    for (let c = 0; c < 3; ++c) {
      const x = frames.loose_at[3 * i + c], was = node === no_node ? x : declared[3 * node + c];
      out[3 * e + c] = was + magnify * (x - was);
    }
  }
  return out;
}

export const force_names = ["N", "Mx 1", "Mx 2", "My 1", "My 2", "Mz"];
/// N, then Mx and My at both ends, Mz: force(frames, frame, bar, 0 to 5), in N and N m
export const force = (frames, frame, bar, c) =>
  frames.forces[(6 * frame + c) * frames.bars + bar] * frames.scale[6 * bar + c];
/// The largest magnitude of that in any frame.
export const largest_force = (frames, bar, c) => (frames.largest ? frames.largest[6 * bar + c] : 32767 * frames.scale[6 * bar + c]);
/// What loads between an element's ends add to the straight line of a moment (src/record/frame_pack.cpp), N m. c: 0 and 1
/// of Mx, 2 and 3 of My: at the middle, and by how much the sum of the slopes at both ends differs.
export const sag = (frames, frame, bar, c) => (frames.sags ? frames.sags[(4 * frame + c) * frames.bars + bar]
  * frames.sag_scale[4 * bar + c] : 0);
export const largest_sag = (frames, bar, c) => (!frames.sags ? 0 : frames.largest_sag ? frames.largest_sag[4 * bar + c] :
  32767 * frames.sag_scale[4 * bar + c]);
export const f_y = (frames, frame, bar) => frames.f_y[frame * frames.bars + bar] * frames.f_y_unit;
/// f_y at the ends and in the middle of an element whose law is not eq 14; null where it is.
export function along(frames, frame, bar) {
  const { f_y_along, f_y_unit, bars } = frames, from = 3 * (frame * bars + bar);
  if (!f_y_along || f_y_along[from] === 65535) return null;
  return [0, 1, 2].map((i) => f_y_along[from + i] * f_y_unit);
}
/// The law that f_y is of, in words; `laws`: those of all sections, empty where all have eq 14.
export const law_text = (laws) => (laws.length === 0 ? "eq 14" : laws.length === 1 ? laws[0] :
  `each section's own law: ${laws.join("; ")}`);
export const state = (frames, frame, bar) => frames.state[frame * frames.bars + bar];

/// Worst state of a member: 0 elastic, 1 yielded, 2 broken; and whether it has been in contact.
export function member_state(frames, frame, member) {
  let worst = 0, touched = 0;
  for (const b of member.bars) {
    const s = state(frames, frame, b);
    worst = Math.max(worst, state_of(s));
    touched |= touched_of(s);
  }
  return { worst, touched };
}

/// The larger principal force of a plate in a frame, N/m, tension positive; null where it has torn.
export function plate_force(frames, frame, plate) {
  const part = frames.plate_forces[frame * (frames.plates.length / 4) + plate];
  return part === -32768 ? null : part * (frames.plate_scales ? frames.plate_scales[frame] : frames.plate_scale);
}

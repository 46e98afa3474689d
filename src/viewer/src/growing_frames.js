// Frames of a run that goes on: arrays with room for more, of which every other frame is left out when it is used up.
import { read_changes } from "./run_data.js";

const most_frames = 240, most_bytes = 200e6;

/// read: frames as read_frames gives them. They grow from now on.
export function make_growing(read) {
  const bytes = 12 * read.nodes + 27 * read.bars, room = Math.round(Math.min(most_frames, Math.max(8, most_bytes / bytes)));
  const frames = { ...read, room, count: 0, times: [], factors: read.factors ? [] : null,
    positions: new Float32Array(room * 3 * read.nodes), f_y: new Uint16Array(room * read.bars),
    f_y_along: read.f_y_along ? new Uint16Array(room * 3 * read.bars) : null,
    state: new Uint8Array(room * read.bars), forces: new Float32Array(room * 6 * read.bars),
    scale: new Float32Array(6 * read.bars).fill(1), largest: new Float32Array(6 * read.bars), loose: [],
    sags: null, pointed: new Set(), plate_scales: [],
    plate_forces: read.plate_forces ? new Int16Array(room * read.plates.length / 4) : null };
  frames.abscissa = frames.factors || frames.times;
  put(frames, read);
  return frames;
}

/// Adds the one frame that is packed there.
export async function add_frame(frames, packed) {
  const read = await read_changes(packed), x = frames.factors ? read.factors[0] : read.times[0];
  if (frames.abscissa[frames.count - 1] === x) --frames.count; // the same step again: the last of a run
  frames.times.length = frames.loose.length = frames.count;
  if (frames.factors) frames.factors.length = frames.count;
  if (frames.count === frames.room) thin_out(frames);
  put(frames, read);
}

// The arrays that have so many numbers a frame.
const arrays = (frames) => [[frames.positions, 3 * frames.nodes], [frames.f_y, frames.bars], [frames.state, frames.bars],
  [frames.forces, 6 * frames.bars], ...(frames.f_y_along ? [[frames.f_y_along, 3 * frames.bars]] : []),
  ...(frames.sags ? [[frames.sags, 4 * frames.bars]] : []),
  ...(frames.plate_forces ? [[frames.plate_forces, frames.plates.length / 4]] : [])];

function put(frames, read) {
  const at = frames.count, { bars, largest } = frames;
  frames.positions.set(read.positions.subarray(0, 3 * frames.nodes), at * 3 * frames.nodes);
  frames.f_y.set(read.f_y.subarray(0, bars), at * bars);
  if (frames.f_y_along && read.f_y_along) frames.f_y_along.set(read.f_y_along.subarray(0, 3 * bars), at * 3 * bars);
  frames.state.set(read.state.subarray(0, bars), at * bars);
  for (let c = 0; c < 6; ++c)
    for (let b = 0; b < bars; ++b) {
      const force = read.forces[c * bars + b] * read.scale[6 * b + c];
      frames.forces[(6 * at + c) * bars + b] = force;
      largest[6 * b + c] = Math.max(largest[6 * b + c], Math.abs(force));
    }
  put_sags(frames, read, at);
  if (frames.plate_forces && read.plate_forces) {
    const plates = frames.plates.length / 4;
    frames.plate_forces.set(read.plate_forces.subarray(0, plates), at * plates);
  }
  frames.plate_scales[at] = read.plate_scale;
  frames.times.push(read.times[0]);
  if (frames.factors) frames.factors.push(read.factors[0]);
  frames.loose.push({ end: read.loose_end, at: read.loose_at });
  ++frames.count;
  join_loose(frames);
}

// There is room for them when the first frame has some; those before it have none.
function put_sags(frames, read, at) {
  const { bars } = frames, n = 4 * bars;
  if (read.sags && !frames.sags) {
    frames.sags = new Float32Array(frames.room * n);
    frames.sag_scale = new Float32Array(n).fill(1), frames.largest_sag = new Float32Array(n);
  }
  if (!frames.sags) return;
  frames.sags.fill(0, at * n, (at + 1) * n);
  for (const bar of read.pointed) frames.pointed.add(bar);
  for (let c = 0; read.sags && c < 4; ++c)
    for (let b = 0; b < bars; ++b) {
      const sag = read.sags[c * bars + b] * read.sag_scale[4 * b + c];
      frames.sags[(4 * at + c) * bars + b] = sag;
      frames.largest_sag[4 * b + c] = Math.max(frames.largest_sag[4 * b + c], Math.abs(sag));
    }
}

// The first frame stays, and the last.
function thin_out(frames) {
  const kept = [];
  for (let f = 0; f < frames.count; ++f) if (f % 2 === 0 || f === frames.count - 1) kept.push(f);
  for (const [array, size] of arrays(frames))
    kept.forEach((f, i) => { if (f !== i) array.copyWithin(i * size, f * size, (f + 1) * size); });
  for (const list of [frames.times, frames.factors, frames.loose, frames.plate_scales]) {
    if (!list) continue;
    kept.forEach((f, i) => { list[i] = list[f]; });
    list.length = kept.length;
  }
  frames.count = kept.length;
}

// Loose ends of all frames one after the other, as place_bars takes them.
function join_loose(frames) {
  const all = frames.loose.reduce((n, l) => n + l.end.length, 0);
  frames.loose_from = [0], frames.loose_end = new Uint32Array(all), frames.loose_at = new Float32Array(3 * all);
  for (const { end, at } of frames.loose) {
    const from = frames.loose_from[frames.loose_from.length - 1];
    frames.loose_end.set(end, from), frames.loose_at.set(at, 3 * from);
    frames.loose_from.push(from + end.length);
  }
}

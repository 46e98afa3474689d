// The signs of supports as lines: a plate across the member that ends there, a pyramid, a pyramid on lines along which
// it is free to roll, a small cube where rotations alone are held.
import { declared_at } from "./run_data.js";

const add = (p, q, k = 1) => p.map((v, c) => v + k * q[c]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((v) => v / (Math.hypot(...a) || 1));

// Two directions at right angles to one.
function across(out) {
  const x = unit(cross(out, Math.abs(out[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]));
  return [x, cross(out, x)];
}

const square = (middle, x, y, half) => [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) =>
  add(add(middle, x, a * half), y, b * half));
const round = (corners) => corners.flatMap((c, k) => [...c, ...corners[(k + 1) % 4]]);

// From one square to another of the same size: a flat plate, or a cube.
function box(first, second) {
  return [...round(first), ...round(second), ...first.flatMap((c, k) => [...c, ...second[k]])];
}

function plate(p, out, s) {
  const [x, y] = across(out), back = add(p, out, 0.35 * s), near = square(p, x, y, 1.2 * s);
  return [...box(near, square(back, x, y, 1.2 * s)), ...near[0], ...near[2], ...near[1], ...near[3]];
}

function pyramid(p, to, s) {
  const [x, y] = across(to), corners = square(add(p, to, 1.5 * s), x, y, s);
  return [...corners.flatMap((c) => [...p, ...c]), ...round(corners)];
}

const axis = (c, sign = 1) => [0, 1, 2].map((k) => (k === c ? sign : 0));

// It stands on what is held: downwards if that is, else along the last axis that is.
function roller(p, held, free, s) {
  const c = [2, 1, 0].find((k) => held & (1 << k)), to = axis(c, -1), points = pyramid(p, to, 0.8 * s);
  const foot = add(p, to, 1.65 * s);
  for (const k of [0, 1, 2])
    if (free & (1 << k)) points.push(...add(foot, axis(k), -1.5 * s), ...add(foot, axis(k), 1.5 * s));
  return points;
}

/// Ends of the lines, three numbers each. supports: as supports_of gives them; s: half of what a sign is wide, m.
export function support_lines(frames, supports, s) {
  const outward = new Map(); // of each node, away from a member that ends there
  for (let b = 0; b < frames.bars; ++b) {
    const p = declared_at(frames, b, 0), q = declared_at(frames, b, 1);
    if (!p || !q) continue;
    outward.set(frames.ends[2 * b], unit([...p].map((v, c) => v - q[c])));
    outward.set(frames.ends[2 * b + 1], unit([...q].map((v, c) => v - p[c])));
  }
  return supports.flatMap(({ node, kind, held, free }) => {
    const p = [...frames.declared.subarray(3 * node, 3 * node + 3)], out = outward.get(node);
    if (!out) return []; // nothing is held there
    if (kind === "plate") return plate(p, out, s);
    if (kind === "pin") return pyramid(p, [0, 0, -1], s);
    if (kind === "roller") return roller(p, held, free, s);
    return box(square(add(p, [0, 0, -0.4 * s]), [1, 0, 0], [0, 1, 0], 0.4 * s), square(add(p, [0, 0, 0.4 * s]), [1, 0, 0],
      [0, 1, 0], 0.4 * s));
  });
}

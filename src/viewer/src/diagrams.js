// Diagrams of N, Mx and My beside the members, as pictures show them (src/output/diagram.cpp): moments on the side that
// they put in tension. Over the members, which would hide them.
import { BufferAttribute, BufferGeometry, DoubleSide, DynamicDrawUsage, LineSegments, Mesh, ShaderMaterial } from "three";
import { broken, force, largest_force, largest_sag, sag, state, state_of } from "./run_data.js";

const of_scene = 0.1, of_member = 1; // the largest value's height: of the scene's size, and of the longest element's length
const pieces = 8; // of an element with a load between its ends

// As in src/output/colours.h: above zero, and below.
export const diagram_colours = { plus: "#9ec8ec", minus: "#fac496" };

const vertex = `
attribute float value; varying float vValue;
void main() { vValue = value; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`;
const fill_fragment = `
varying float vValue;
void main() { gl_FragColor = vec4(vValue > 0.0 ? vec3(0.620, 0.784, 0.925) : vec3(0.980, 0.769, 0.588), 0.8); }`;
const line_fragment = `
varying float vValue;
void main() { gl_FragColor = vec4(vValue > 0.0 ? vec3(0.0, 0.353, 0.627) : vec3(0.745, 0.282, 0.0), 1.0); }`;

/// Of each: its unit; which forces of run_data.js are those at its ends, and which sags are its own; the section's axis
/// along which positive values lie, and with which sign.
export const diagrams = {
  N: { name: "N, tension positive", unit: "N", ends: [0, 0], side: [1, 1] },
  Mx: { name: "Mx, on the side in tension", unit: "N m", ends: [1, 2], sags: 0, side: [1, 1] },
  My: { name: "My, on the side in tension", unit: "N m", ends: [3, 4], sags: 2, side: [0, -1] },
};

/// Whether the course of moments between the element's ends is known: point loads between them are not in the data.
const is_known = (frames, bar, kind) => diagrams[kind].sags === undefined || !frames.pointed.has(bar);

/// The value at a share t of the length: a straight line between the ends and what loads between them add (add_sags of
/// src/record/frame_pack.cpp).
export function value_at(frames, frame, bar, kind, t) {
  const { ends, sags } = diagrams[kind], a = force(frames, frame, bar, ends[0]), b = force(frames, frame, bar, ends[1]);
  const straight = a + t * (b - a);
  if (sags === undefined) return straight;
  return straight + t * (1 - t) * (4 * sag(frames, frame, bar, sags) + 0.5 * (1 - 2 * t) * sag(frames, frame, bar, sags + 1));
}

const curved = (frames, frame, bar, { sags }) => sags !== undefined
  && (sag(frames, frame, bar, sags) !== 0 || sag(frames, frame, bar, sags + 1) !== 0);

// Where along an element the diagram is computed: evenly, and where it is largest, which is where its slope is zero:
// chord + p - 2 (p + c) t + 3 c t^2.
function stations(frames, frame, bar, kind) {
  const of = diagrams[kind];
  if (!curved(frames, frame, bar, of)) return [0, 1];
  const at = Array.from({ length: pieces + 1 }, (_, i) => i / pieces);
  const chord = force(frames, frame, bar, of.ends[1]) - force(frames, frame, bar, of.ends[0]);
  const c = sag(frames, frame, bar, of.sags + 1), p = 4 * sag(frames, frame, bar, of.sags) + 0.5 * c, b = -2 * (p + c);
  const q = -0.5 * (b + Math.sign(b || 1) * Math.sqrt(b * b - 12 * c * (chord + p)));
  for (const t of [q / (3 * c), (chord + p) / q]) if (t > 0 && t < 1) at.push(t);
  return at.sort((s, t) => s - t);
}

export class DiagramDrawing {
  constructor(scene) {
    this.scene = scene;
    const stations = pieces + 3, { bars } = scene.frames, most = 2 * stations * bars;
    this.at = new Float32Array(3 * most), this.values = new Float32Array(most);
    this.index = new Uint32Array(6 * stations * bars), this.edges = new Uint32Array((2 * stations + 4) * bars);
    const moving = (array, size) => new BufferAttribute(array, size).setUsage(DynamicDrawUsage);
    const position = moving(this.at, 3), value = moving(this.values, 1);
    const made = (Kind, fragment, index, transparent, order) => {
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", position), geometry.setAttribute("value", value);
      geometry.setIndex(moving(index, 1));
      const drawn = new Kind(geometry, new ShaderMaterial({ vertexShader: vertex, fragmentShader: fragment, transparent,
        side: DoubleSide, depthTest: false, depthWrite: false }));
      drawn.frustumCulled = false, drawn.visible = false, drawn.renderOrder = order;
      scene.root.add(drawn);
      return drawn;
    };
    this.fill = made(Mesh, fill_fragment, this.index, true, 1);
    this.lines = made(LineSegments, line_fragment, this.edges, true, 2);
  }

  /// Draws a frame's diagram of this kind, "" for none. Returns { largest: { value, bar }, left_out: elements whose course
  /// is not known }.
  place(frame, kind) {
    const { scene: { frames, ends, shown, size } } = this;
    this.fill.visible = this.lines.visible = Boolean(kind);
    if (!kind) return null;
    let vertices = 0, corners = 0, edges = 0, left_out = 0;
    const largest = { value: 0, bar: -1 }, metres = this.#metres(kind, size), e = [0, 0, 0], side = [0, 0, 0], y = [0, 0, 0];
    const vertex = (b, t, value, out) => {
      for (let c = 0; c < 3; ++c)
        this.at[3 * vertices + c] = ends[6 * b + c] + t * (ends[6 * b + 3 + c] - ends[6 * b + c]) + out * value * metres * side[c];
      this.values[vertices] = value;
      return vertices++;
    };
    for (let b = 0; b < frames.bars; ++b) {
      if (!shown[b] || state_of(state(frames, frame, b)) === broken) continue;
      if (!is_known(frames, b, kind)) { ++left_out; continue; }
      let length = 0;
      for (let c = 0; c < 3; ++c) e[c] = ends[6 * b + 3 + c] - ends[6 * b + c], length += e[c] * e[c];
      length = Math.sqrt(length);
      if (!(length > 0)) continue;
      this.#axes(b, e, length, y, side, diagrams[kind].side);
      let before = null;
      for (const t of stations(frames, frame, b, kind)) {
        const value = value_at(frames, frame, b, kind, t);
        if (Math.abs(value) > Math.abs(largest.value)) largest.value = value, largest.bar = b;
        const now = [vertex(b, t, value, 0), vertex(b, t, value, 1)];
        if (t === 0 || t === 1) this.edges[edges++] = now[0], this.edges[edges++] = now[1];
        if (before) {
          for (const v of [before[0], now[0], now[1], before[0], now[1], before[1]]) this.index[corners++] = v;
          this.edges[edges++] = before[1], this.edges[edges++] = now[1];
        }
        before = now;
      }
    }
    this.fill.geometry.setDrawRange(0, corners), this.lines.geometry.setDrawRange(0, edges);
    for (const drawn of [this.fill, this.lines]) drawn.geometry.index.needsUpdate = true;
    for (const name of ["position", "value"]) this.fill.geometry.attributes[name].needsUpdate = true;
    return { largest, left_out };
  }

  // The section's axes now: its y axis as it was declared, across the element as it lies.
  #axes(b, e, length, y, side, [axis, sign]) {
    const { up } = this.scene.frames;
    let along = 0, size = 0;
    for (let c = 0; c < 3; ++c) along += up[3 * b + c] * e[c] / length;
    for (let c = 0; c < 3; ++c) y[c] = up[3 * b + c] - along * e[c] / length, size += y[c] * y[c];
    size = Math.sqrt(size) || 1;
    for (let c = 0; c < 3; ++c) y[c] /= size;
    for (let c = 0; c < 3; ++c) {
      const i = (c + 1) % 3, k = (c + 2) % 3; // x = y cross z
      side[c] = sign * (axis === 1 ? y[c] : (y[i] * e[k] - y[k] * e[i]) / length);
    }
  }

  // Drawn per N or N m: the same in all frames, by the largest value at an end of an element in any of them.
  #metres(kind, size) {
    const { frames } = this.scene;
    let most = 0, longest = 0;
    for (let b = 0; b < frames.bars; ++b) {
      if (!this.scene.shown[b]) continue;
      for (const c of diagrams[kind].ends) most = Math.max(most, largest_force(frames, b, c));
      if (diagrams[kind].sags !== undefined) most = Math.max(most, largest_sag(frames, b, diagrams[kind].sags));
      longest = Math.max(longest, frames.long[b]);
    }
    return most > 0 ? Math.min(of_scene * size, of_member * longest) / most : 0;
  }
}

// A run in three.js: members as strips of one mesh, drawn in one call, with hinges, supports, the ground's grid
// and the undeformed shape.
import {
  BufferAttribute, BufferGeometry, Color, DoubleSide, DynamicDrawUsage, Group,  LineBasicMaterial, LineSegments, Mesh, Points, Scene, ShaderMaterial, Vector2, Vector3,
} from "three";
import { place_bars, declared_at, hinges_of, state, state_of, broken, supports_of } from "./run_data.js";
import { support_lines } from "./supports.js";
import { band_colours } from "./bands.js";
import { DiagramDrawing } from "./diagrams.js";
import { PlateDrawing } from "./plates.js";

// A bar is a strip of two triangles that faces the eye, shaded as a tube, and half a width longer at either end: four
// corners each, so that a renderer without a graphics card keeps up with thousands. (One draws instances one by one.)
// It has one colour, that of paint, or bands: at t, from 0 at its first end to 1, the class of the value
// course.x + course.y t + course.z t^2, or of course.w where that is less. With course.w < 0 it has one colour.
const bar_vertex = `
attribute vec2 corner; attribute vec3 a; attribute vec3 b; attribute float breadth; attribute vec4 paint;
attribute vec4 course;
uniform vec2 pixels; uniform float slope; uniform float thicker;
flat varying vec3 vColour; flat varying vec4 vCourse; varying vec4 vLight; varying float vEdge;
void main() {
  if (paint.a < 0.1) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  vec3 p = (modelViewMatrix * vec4(a, 1.0)).xyz, q = (modelViewMatrix * vec4(b, 1.0)).xyz;
  vec3 middle = mix(p, q, corner.y), axis = q - p, eye = -normalize(middle);
  float pixel = 2.0 * slope * max(0.0, -middle.z) / pixels.y;
  bool chosen = paint.a < 0.9;
  float w = max(breadth * thicker, (chosen ? 5.0 : 2.4) * pixel) * (chosen ? 1.25 : 1.0);
  vec3 along = axis / max(length(axis), 1e-9), across = cross(along, eye);
  float sine = length(across);
  across = sine > 1e-4 ? across / sine : vec3(1.0, 0.0, 0.0);
  float longer = (corner.y - 0.5) * min(w, 0.5 * length(axis));
  middle += across * 0.5 * corner.x * w + along * longer;
  gl_Position = projectionMatrix * vec4(middle, 1.0);
  vec3 towards = cross(across, along), sun = normalize((viewMatrix * vec4(-0.35, -0.45, 0.8, 0.0)).xyz);
  vLight = vec4(corner.x, dot(across, sun), dot(towards, sun), corner.y + longer / max(length(axis), 1e-9));
  vEdge = 1.0 - min(0.35, 2.0 * pixel / w);
  vColour = paint.rgb;
  vCourse = course;
}`;
// A class is counted, and one colour looked up: where the processor draws, a choice of colours in a loop took longer.
const bar_fragment = `
uniform float band_from[5]; uniform vec3 band_colours[6];
flat varying vec3 vColour; flat varying vec4 vCourse; varying vec4 vLight; varying float vEdge;
void main() {
  vec3 colour = vColour;
  if (vCourse.w >= 0.0) {
    float t = clamp(vLight.w, 0.0, 1.0), value = min(vCourse.x + t * (vCourse.y + t * vCourse.z), vCourse.w);
    colour = band_colours[int(value >= band_from[0]) + int(value >= band_from[1]) + int(value >= band_from[2])
      + int(value >= band_from[3]) + int(value >= band_from[4])];
  }
  float x = clamp(vLight.x, -1.0, 1.0);
  float light = x * vLight.y + sqrt(1.0 - x * x) * vLight.z;
  // Yellow and light blue stand out from the background by a dark edge of a pixel.
  float edge = abs(x) > vEdge && dot(colour, vec3(0.299, 0.587, 0.114)) > 0.65 ? 0.55 : 1.0;
  gl_FragColor = vec4(edge * colour * (0.78 + 0.27 * light), 1.0);
}`;
// Of the dots where an element is or has been fully plastic. They have one size: the data hold no plastic rotation.
export const hinge_colour = band_colours[5];
const dot_paint = [1, 3, 5].map((i) => parseInt(hinge_colour.slice(i, i + 2), 16));
const dot_vertex = `
attribute vec3 paint; uniform float size; varying vec3 vColour;
void main() { vColour = paint; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_Position.z -= 0.0008 * gl_Position.w; gl_PointSize = size; }`;
const dot_fragment = `
varying vec3 vColour;
void main() { float r = length(gl_PointCoord - 0.5); if (r > 0.5) discard;
  gl_FragColor = vec4(r > 0.4 ? vec3(1.0) : vColour, 1.0); }`;

function lines(points, colour) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
  const drawn = new LineSegments(geometry, new LineBasicMaterial({ color: new Color(colour) }));
  drawn.frustumCulled = false;
  return drawn;
}

export class RunScene {
  constructor(frames) {
    this.frames = frames;
    this.scene = new Scene();
    this.root = new Group();
    this.scene.add(this.root);
    this.ends = new Float32Array(6 * frames.bars);
    this.shown = new Uint8Array(frames.bars).fill(1);
    this.#measure();
    this.#add_bars();
    this.#add_dots();
    this.#add_ground();
    this.#add_ghost();
    this.diagram = new DiagramDrawing(this);
    this.plates = new PlateDrawing(frames, this.root);
  }

  // Where the camera looks at first: what is attached to supports, and all of it where nothing is.
  #measure() {
    const { frames } = this, low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    const any = frames.attached.includes(1);
    for (let b = 0; b < frames.bars; ++b)
      for (const side of [0, 1]) {
        const at = declared_at(frames, b, side);
        if (at && (frames.attached[b] || !any))
          for (let c = 0; c < 3; ++c) low[c] = Math.min(low[c], at[c]), high[c] = Math.max(high[c], at[c]);
      }
    if (low[0] > high[0]) low.fill(-1), high.fill(1);
    this.middle = new Vector3(...low.map((v, c) => (v + high[c]) / 2));
    this.size = Math.max(1e-3, Math.hypot(...low.map((v, c) => high[c] - v)));
    this.low = low, this.high = high;
  }

  #add_bars() {
    const { bars, width } = this.frames, geometry = new BufferGeometry();
    const corner = new Int8Array(8 * bars), breadth = new Float32Array(4 * bars), index = new Uint32Array(6 * bars);
    for (let b = 0; b < bars; ++b) {
      corner.set([-1, 0, 1, 0, 1, 1, -1, 1], 8 * b);
      breadth.fill(width[b], 4 * b, 4 * b + 4);
      index.set([0, 1, 2, 0, 2, 3].map((i) => 4 * b + i), 6 * b);
    }
    const moving = (array, size, share) => new BufferAttribute(array, size, share).setUsage(DynamicDrawUsage);
    this.a = moving(new Float32Array(12 * bars), 3), this.b = moving(new Float32Array(12 * bars), 3);
    this.paint = new Uint32Array(4 * bars); // four bytes a corner
    this.colour = moving(new Uint8Array(this.paint.buffer), 4, true);
    this.course = moving(new Float32Array(16 * bars), 4);
    geometry.setAttribute("corner", new BufferAttribute(corner, 2));
    geometry.setAttribute("a", this.a);
    geometry.setAttribute("b", this.b);
    geometry.setAttribute("breadth", new BufferAttribute(breadth, 1));
    geometry.setAttribute("paint", this.colour);
    geometry.setAttribute("course", this.course);
    geometry.setIndex(new BufferAttribute(index, 1));
    this.material = new ShaderMaterial({ vertexShader: bar_vertex, fragmentShader: bar_fragment,
      side: DoubleSide, uniforms: { pixels: { value: new Vector2(1, 1) }, slope: { value: 1 }, thicker: { value: 1 },
        band_from: { value: new Array(5).fill(0) }, band_colours: { value: band_colours.map((c) => new Color(c)) } } });
    const mesh = new Mesh(geometry, this.material);
    mesh.frustumCulled = false;
    this.root.add(mesh);
  }

  #add_dots() {
    const geometry = new BufferGeometry();
    this.dots = { at: new Float32Array(6 * this.frames.bars), paint: new Uint8Array(6 * this.frames.bars) };
    geometry.setAttribute("position", new BufferAttribute(this.dots.at, 3).setUsage(DynamicDrawUsage));
    geometry.setAttribute("paint", new BufferAttribute(this.dots.paint, 3, true).setUsage(DynamicDrawUsage));
    this.dots.geometry = geometry;
    this.dots.material = new ShaderMaterial({ vertexShader: dot_vertex, fragmentShader: dot_fragment,
      uniforms: { size: { value: 7 } } });
    this.dots.drawn = new Points(geometry, this.dots.material);
    this.dots.drawn.frustumCulled = false;
    this.root.add(this.dots.drawn);
  }

  // A grid on the lowest support, its lines a round number of metres apart, and a sign at each support.
  #add_ground() {
    const { low, high, frames } = this, span = Math.max(high[0] - low[0], high[1] - low[1], 0.3 * this.size);
    const power = 10 ** Math.floor(Math.log10(span / 4)), step = [1, 2, 5, 10].map((k) => k * power).find((s) => s >= span / 6);
    this.grid_step = step;
    const from = [0, 1].map((c) => Math.floor((low[c] - 0.6 * span) / step) * step);
    const to = [0, 1].map((c) => Math.ceil((high[c] + 0.6 * span) / step) * step), z = frames.base, points = [];
    for (let x = from[0]; x <= to[0] + 0.01 * step; x += step) points.push(x, from[1], z, x, to[1], z);
    for (let y = from[1]; y <= to[1] + 0.01 * step; y += step) points.push(from[0], y, z, to[0], y, z);
    this.ground = new Group();
    this.ground.add(lines(points, "#d5dbe1"));
    this.supports = supports_of(frames);
    this.support_signs = lines(support_lines(frames, this.supports, 0.018 * this.size), "#4a5560");
    this.ground.add(this.support_signs);
    this.root.add(this.ground);
  }

  #add_ghost() {
    const points = [];
    for (let b = 0; b < this.frames.bars; ++b) {
      const p = declared_at(this.frames, b, 0), q = declared_at(this.frames, b, 1);
      if (p && q) points.push(...p, ...q);
    }
    this.ghost = lines(points, "#b9c2cb");
    this.ghost.visible = false;
    this.root.add(this.ghost);
  }

  /// Puts everything where it is in a frame.
  place(frame, magnify, part) {
    const { ends, frames } = this;
    place_bars(frames, frame, magnify, ends, part);
    const a = this.a.array, b = this.b.array;
    for (let bar = 0; bar < frames.bars; ++bar)
      for (let c = 0; c < 3; ++c)
        for (let corner = 4 * bar; corner < 4 * bar + 4; ++corner)
          a[3 * corner + c] = ends[6 * bar + c], b[3 * corner + c] = ends[6 * bar + 3 + c];
    this.a.needsUpdate = this.b.needsUpdate = true;
    this.#place_dots(frame);
    this.plates.place(frame, magnify, part);
  }

  /// Nodes of elements that are shown, with their places in a frame: [node, [x, y, z]].
  * node_places(frame, magnify, part) {
    const { frames, shown } = this, { nodes, positions, declared, ends } = frames, seen = new Uint8Array(nodes);
    const from = 3 * nodes * frame, next = part > 0 && frame + 1 < frames.count ? 3 * nodes : 0;
    for (let e = 0; e < 2 * frames.bars; ++e) {
      const node = ends[e];
      if (node === 0xffffffff || seen[node] || !shown[e >> 1]) continue;
      seen[node] = 1;
      yield [node, [0, 1, 2].map((c) => {
        const i = 3 * node + c, x = positions[from + i], now = next ? x + part * (positions[from + next + i] - x) : x;
        return declared[i] + magnify * (now - declared[i]);
      })];
    }
  }

  #place_dots(frame) {
    const { dots, ends, frames } = this;
    let n = 0;
    const put = (x, y, z) => {
      dots.at.set([x, y, z], 3 * n), dots.paint.set(dot_paint, 3 * n);
      ++n;
    };
    if (dots.drawn.visible)
      for (let b = 0; b < frames.bars; ++b) {
        const s = state(frames, frame, b), at = hinges_of(s);
        if (!at || !this.shown[b] || state_of(s) === broken) continue;
        const o = 6 * b, inward = 0.06;
        const between = (r) => put(...[0, 1, 2].map((c) => ends[o + c] + r * (ends[o + 3 + c] - ends[o + c])));
        if (at & 1) between(inward);
        if (at & 2) between(1 - inward);
        if (at & 4) between(0.5);
      }
    dots.geometry.setDrawRange(0, n);
    for (const name of ["position", "paint"]) dots.geometry.attributes[name].needsUpdate = true;
  }

  /// colour_of(bar) gives [r, g, b] of 0 to 255, or null where bands are drawn; `chosen`: the number of the member
  /// picked, or 0. bands: { from: the least values of classes 1 to 5, course(bar, out): puts four numbers into out }.
  paint_bars(colour_of, chosen, bands = null) {
    const { paint, frames, shown } = this, course = this.course.array, of_bar = [0, 0, 0, 0];
    if (bands) this.material.uniforms.band_from.value = bands.from;
    for (let b = 0; b < frames.bars; ++b) {
      const is_chosen = frames.member[b] === chosen, colour = is_chosen ? [214, 39, 196] : colour_of(b);
      const [r, g, bl] = colour ?? [0, 0, 0], alpha = shown[b] ? (is_chosen ? 200 : 255) : 0;
      paint.fill(((alpha << 24) | (bl << 16) | (g << 8) | r) >>> 0, 4 * b, 4 * b + 4);
      if (colour) of_bar[3] = -1; else bands.course(b, of_bar);
      for (let i = 0; i < 16; ++i) course[16 * b + i] = of_bar[i & 3];
    }
    this.colour.needsUpdate = this.course.needsUpdate = true;
  }

  /// The element nearest to a pixel of a view of `width` by `height`, -1: none within reach.
  pick(camera, x, y, width, height) {
    const { ends, frames, shown } = this, p = new Vector3(), q = new Vector3(), shift = this.root.position;
    camera.updateMatrixWorld();
    let best = -1, best_rank = Infinity;
    for (let b = 0; b < frames.bars; ++b) {
      if (!shown[b]) continue;
      p.fromArray(ends, 6 * b).add(shift).applyMatrix4(camera.matrixWorldInverse);
      q.fromArray(ends, 6 * b + 3).add(shift).applyMatrix4(camera.matrixWorldInverse);
      if (p.z > -camera.near && q.z > -camera.near) continue;
      const near = Math.min(-p.z, -q.z), focal = camera.projectionMatrix.elements[5] * height / 2;
      const half = frames.width[b] / 2 / Math.max(near, camera.near) * focal;
      p.applyMatrix4(camera.projectionMatrix), q.applyMatrix4(camera.projectionMatrix);
      const px = (p.x + 1) / 2 * width, py = (1 - p.y) / 2 * height;
      const dx = (q.x + 1) / 2 * width - px, dy = (1 - q.y) / 2 * height - py;
      const t = Math.min(1, Math.max(0, ((x - px) * dx + (y - py) * dy) / (dx * dx + dy * dy || 1)));
      const away = Math.max(0, Math.hypot(x - px - t * dx, y - py - t * dy) - half);
      if (away > 8) continue;
      const rank = away * 0.02 + p.z + t * (q.z - p.z); // depth first, then how near
      if (rank < best_rank) best_rank = rank, best = b;
    }
    return best;
  }
}

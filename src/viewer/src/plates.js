// Panels: transparent plates, coloured by their larger principal force, with their edges. Torn ones are not drawn.
import { BufferAttribute, BufferGeometry, Color, DoubleSide, DynamicDrawUsage, LineBasicMaterial, LineSegments, Mesh,
  MeshBasicMaterial } from "three";
import { plate_force } from "./run_data.js";

const no_node = 0xffffffff;
export const plate_colours = { tension: "#1f5fa8", none: "#f2f4f6", compression: "#e07b20" };
const rgb = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);
const ends = { pulled: rgb(plate_colours.tension), idle: rgb(plate_colours.none), pressed: rgb(plate_colours.compression) };

export class PlateDrawing {
  constructor(frames, root) {
    this.frames = frames, this.count = frames.plate_forces ? frames.plates.length / 4 : 0;
    if (this.count === 0) return;
    const moving = (array) => new BufferAttribute(array, 3).setUsage(DynamicDrawUsage);
    this.at = moving(new Float32Array(12 * this.count)), this.colour = moving(new Float32Array(12 * this.count));
    const faces = new BufferGeometry(), edges = new BufferGeometry(), triangles = [], sides = [];
    for (let p = 0; p < this.count; ++p) {
      const n = frames.plates[4 * p + 3] === no_node ? 3 : 4;
      for (let k = 2; k < n; ++k) triangles.push(4 * p, 4 * p + k - 1, 4 * p + k);
      for (let k = 0; k < n; ++k) sides.push(4 * p + k, 4 * p + (k + 1) % n);
    }
    for (const geometry of [faces, edges]) geometry.setAttribute("position", this.at);
    faces.setAttribute("color", this.colour);
    faces.setIndex(triangles), edges.setIndex(sides);
    const face = new Mesh(faces, new MeshBasicMaterial({ vertexColors: true, side: DoubleSide, transparent: true,
      opacity: 0.75, depthWrite: false }));
    const edge = new LineSegments(edges, new LineBasicMaterial({ color: new Color("#8d99a5") }));
    this.drawn = [face, edge];
    for (const drawn of this.drawn) drawn.frustumCulled = false, root.add(drawn);
  }

  get visible() { return this.count > 0 && this.drawn[0].visible; }
  show(on) { for (const drawn of this.drawn ?? []) drawn.visible = on; }

  /// Puts them where they are in a frame, `part` of the way to the next one.
  place(frame, magnify, part) {
    const { frames, at, colour } = this, { nodes, positions, declared, plates } = frames;
    if (this.count === 0) return;
    const from = 3 * nodes * frame, next = part > 0 && frame + 1 < frames.count ? 3 * nodes : 0;
    const forces = Array.from({ length: this.count }, (_, p) => plate_force(frames, frame, p));
    const most = forces.reduce((m, f) => Math.max(m, Math.abs(f ?? 0)), 0);
    for (let p = 0; p < this.count; ++p) {
      const force = forces[p], to = force >= 0 ? ends.pulled : ends.pressed;
      const share = most > 0 ? Math.sqrt(Math.abs(force) / most) : 0;
      for (let k = 0; k < 4; ++k) {
        const node = plates[4 * p + k], torn = force === null || node === no_node;
        for (let c = 0; c < 3; ++c) {
          const i = 3 * node + c, o = 12 * p + 3 * k + c;
          const x = torn ? 0 : positions[from + i], now = next && !torn ? x + part * (positions[from + next + i] - x) : x;
          at.array[o] = torn ? at.array[12 * p + c] : declared[i] + magnify * (now - declared[i]); // torn: a point
          colour.array[o] = ends.idle[c] + share * (to[c] - ends.idle[c]);
        }
      }
    }
    at.needsUpdate = colour.needsUpdate = true;
  }
}

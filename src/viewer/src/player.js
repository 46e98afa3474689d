// The player: one canvas with a view of each run, one camera and one time for all of them.
import { ColorManagement, PerspectiveCamera, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { make, number } from "./page.js";
import { frame_at } from "./run_data.js";
import { RunScene } from "./scene.js";
import { colourings, measure } from "./colouring.js";
import { make_numbers, make_triad, picture_of } from "./overlay.js";
import { controls_of } from "./controls.js";

// Degrees, from the lower to the upper edge. With so small an angle lines that are parallel differ by less than a pixel.
const angle = { perspective: 32, parallel: 0.2 };

ColorManagement.enabled = false; // colours are as they are given

// Software renderers draw on the processor: no smoothing of edges there, which would cost four times as much.
function draws_on_processor() {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return null;
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

export class Player {
  /// runs: those with frames; changed(player) is called when the time or the member picked is another. grows: frames
  /// will be added (grew).
  constructor(runs, changed, grows = false) {
    this.runs = runs;
    this.changed = changed;
    this.grows = grows;
    this.chosen = { run: 0, member: 0 };
    this.options = { colouring: "f_y", magnify: 1, thicker: 1, smooth: true, hidden: new Set(), low: -Infinity,
      high: Infinity, follow: false, speed: 1, parallel: false, loop: false, numbers: false, diagram: "" };
    this.#find_ends();
    this.time = this.end;
    this.playing = false;
    this.frames_drawn = 0;
    this.views = runs.map((r) => {
      const scene = new RunScene(r.frames);
      measure(r.frames, scene);
      return { run: r, scene, frame: -1, part: 0, offset: new Vector3() };
    });
    this.#make_canvas();
    this.element = make("div", { class: "player" }, this.stage, controls_of(this));
    this.repaint();
    this.seek(this.end);
  }

  #make_canvas() {
    const slow = draws_on_processor();
    if (slow === null) throw new Error("this browser has no WebGL");
    this.canvas = make("canvas", { tabindex: 0, role: "img", "aria-label":
      "the structure in 3D; arrow keys rotate, + and - zoom, space plays, comma and full stop step, [ and ] pick" });
    this.names = this.views.map((v) => make("div", { class: "view-name" }, this.views.length > 1 ? v.run.name : ""));
    this.triad = make_triad();
    this.numbers = this.views.map(() => make_numbers());
    this.clock = make("div", { class: "clock" });
    this.stage = make("div", { class: "stage" }, this.canvas, this.names, this.numbers, this.triad, this.clock);
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: !slow, powerPreference: "high-performance" });
    this.renderer.setPixelRatio(slow ? 1 : Math.min(2, window.devicePixelRatio || 1));
    this.renderer.setClearColor("#f3f6f8");
    this.renderer.outputColorSpace = "srgb-linear";
    this.renderer.autoClear = false;
    this.renderer.setScissorTest(true);
    this.camera = new PerspectiveCamera(angle.perspective, 1, 0.1, 1000);
    this.camera.up.set(0, 0, 1);
    this.orbit = new OrbitControls(this.camera, this.canvas);
    this.orbit.enableDamping = false;
    this.orbit.zoomToCursor = false;
    this.orbit.addEventListener("change", () => this.redraw());
    this.canvas.addEventListener("pointerdown", (e) => { this.pressed = [e.clientX, e.clientY]; });
    this.canvas.addEventListener("pointerup", (e) => {
      if (this.pressed && Math.hypot(e.clientX - this.pressed[0], e.clientY - this.pressed[1]) < 4) this.#pick(e);
      this.pressed = null;
    });
    this.canvas.addEventListener("keydown", (e) => this.#key(e));
    this.sizes = new ResizeObserver(() => this.#resize());
    this.sizes.observe(this.stage);
    this.look("corner");
  }

  // ---- camera ----

  look(from) {
    const ways = { corner: [-1, -1.5, 0.55], front: [0, -1, 0.0001], side: [-1, 0, 0.0001], back: [0, 1, 0.0001],
      top: [0, -0.0001, 1] };
    const way = new Vector3(...ways[from]).normalize(), scenes = this.views.map((v) => v.scene);
    const size = Math.max(...scenes.map((s) => s.size));
    this.orbit.target.copy(scenes[0].middle);
    const aspect = this.camera.aspect || 1, slope = Math.tan(this.camera.fov * Math.PI / 360);
    const away = 0.56 * size / slope / Math.min(1, aspect);
    this.camera.position.copy(scenes[0].middle).addScaledVector(way, away);
    this.orbit.update();
    this.redraw();
  }

  /// Without perspective, from where it looks, with what is in the middle as large as before; and back.
  set_parallel(on) {
    this.options.parallel = on;
    const slope = () => Math.tan(this.camera.fov * Math.PI / 360), before = slope();
    this.camera.fov = on ? angle.parallel : angle.perspective;
    this.zoom(before / slope());
  }

  // What is drawn of the depth: all of it, with as much precision as there can be.
  #set_depth() {
    const size = Math.max(...this.views.map((v) => v.scene.size)), away = this.camera.position.distanceTo(this.orbit.target);
    this.camera.near = Math.max(size / 200, away - 60 * size), this.camera.far = away + 60 * size;
    this.camera.updateProjectionMatrix();
  }

  turn(around, up) {
    const arm = this.camera.position.clone().sub(this.orbit.target), length = arm.length();
    const azimuth = Math.atan2(arm.y, arm.x) + around;
    const height = Math.min(1.55, Math.max(-1.55, Math.asin(arm.z / length) + up));
    arm.set(Math.cos(height) * Math.cos(azimuth), Math.cos(height) * Math.sin(azimuth), Math.sin(height));
    this.camera.position.copy(this.orbit.target).addScaledVector(arm, length);
    this.orbit.update();
    this.redraw();
  }

  zoom(factor) {
    const arm = this.camera.position.clone().sub(this.orbit.target).multiplyScalar(factor);
    this.camera.position.copy(this.orbit.target).add(arm);
    this.orbit.update();
    this.redraw();
  }

  #resize() {
    const width = this.stage.clientWidth, height = this.stage.clientHeight;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    const first = !this.laid_out, n = this.views.length, columns = width / height > 1.1 ? Math.min(n, n > 3 ? 2 : n) :
      Math.ceil(n / Math.ceil(Math.sqrt(n * height / width)));
    const rows = Math.ceil(n / columns), w = Math.floor(width / columns), h = Math.floor(height / rows);
    this.views.forEach((v, i) => {
      v.box = { x: (i % columns) * w, y: Math.floor(i / columns) * h, w, h };
      this.names[i].style.transform = `translate(${v.box.x + 10}px, ${v.box.y + 8}px)`;
    });
    this.camera.aspect = w / h;
    this.camera.updateProjectionMatrix();
    this.height = height, this.laid_out = true;
    if (first) this.look("corner");
    this.redraw();
  }

  // ---- time ----

  #find_ends() {
    const xs = this.runs.map((r) => r.frames.abscissa);
    this.begin = Math.min(...xs.map((x) => x[0]));
    this.end = Math.max(...xs.map((x) => x[x.length - 1]));
  }
  at_end() { return !this.playing && this.time === this.end; }
  /// Frames were added to the runs, and others may have been left out: who was at the end is there again.
  grew() {
    const follows = this.at_end();
    this.#find_ends();
    for (const v of this.views) {
      v.frame = -1;
      measure(v.run.frames, v.scene, v.run.frames.count - 1);
    }
    this.show_legend();
    this.seek(follows ? this.end : this.time);
    this.changed(this, "frames");
  }
  close() {
    this.playing = false, this.laid_out = false;
    this.sizes.disconnect();
    this.renderer.dispose(), this.renderer.forceContextLoss();
  }
  seek(time) {
    this.time = Math.min(this.end, Math.max(this.begin, time));
    this.#place();
    this.changed(this, "time");
  }
  step(frames) {
    const x = this.views[this.chosen.run].run.frames.abscissa, at = frame_at({ abscissa: x }, this.time);
    this.play(false);
    this.seek(x[Math.min(x.length - 1, Math.max(0, at + frames))]);
  }
  play(on = !this.playing) {
    if (on && !this.playing && this.time >= this.end) this.time = this.begin;
    this.playing = on;
    this.last = performance.now();
    if (!on) this.#place();
    this.redraw();
    this.changed(this, "playing");
  }

  #place(force = false) {
    for (const v of this.views) {
      const frames = v.run.frames, frame = frame_at(frames, this.time), x = frames.abscissa;
      const part = this.playing && this.options.smooth && frame + 1 < frames.count ?
        Math.max(0, Math.min(1, (this.time - x[frame]) / (x[frame + 1] - x[frame] || 1))) : 0;
      const another = frame !== v.frame;
      if (!another && part === v.part && !force) continue;
      v.frame = frame, v.part = part, v.magnify = this.options.magnify;
      v.scene.place(frame, this.options.magnify, part);
      v.diagram = v.scene.diagram.place(frame, this.options.diagram);
      const { of, bands } = colourings[this.options.colouring];
      if (another || force) v.scene.paint_bars(of(frames, frame, v.scene), this.chosen.member, bands?.(frames, frame));
    }
    this.show_diagram?.();
    this.#follow();
    this.redraw();
  }

  // Moves each run so that the middle of the member picked stays where it was.
  #follow() {
    for (const v of this.views) {
      const bar = v.run.frames.members.get(this.chosen.member)?.bars[0];
      const at = () => {
        const e = v.scene.ends, o = 6 * bar;
        return new Vector3((e[o] + e[o + 3]) / 2, (e[o + 1] + e[o + 4]) / 2, (e[o + 2] + e[o + 5]) / 2);
      };
      if (!this.options.follow || bar === undefined) v.from = null, v.scene.root.position.set(0, 0, 0);
      else v.from ??= at(), v.scene.root.position.copy(v.from).sub(at());
    }
  }

  // ---- what is shown ----

  /// After an option has changed.
  repaint() {
    const { hidden, low, high, thicker } = this.options;
    for (const v of this.views) {
      const { frames } = v.run, { shown } = v.scene;
      const off = new Set(frames.groups.map((g, i) => (hidden.has(g) ? i : -1)).filter((i) => i >= 0));
      for (const m of frames.members.values()) {
        let show = !m.groups.some((g) => off.has(g));
        if (show && m.storey >= 0) show = m.storey >= low && m.storey <= high;
        for (const b of m.bars) shown[b] = show ? 1 : 0;
      }
      v.scene.material.uniforms.thicker.value = thicker;
    }
    this.#place(true);
  }

  choose(run, member) {
    this.chosen = { run, member };
    for (const v of this.views) v.from = null;
    this.#place(true);
    this.changed(this, "member");
  }

  #pick(event) {
    const box = this.canvas.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
    const i = this.views.findIndex((v) => x >= v.box.x && x < v.box.x + v.box.w && y >= v.box.y && y < v.box.y + v.box.h);
    if (i < 0) return;
    const v = this.views[i], bar = v.scene.pick(this.camera, x - v.box.x, y - v.box.y, v.box.w, v.box.h);
    this.choose(i, bar < 0 ? 0 : v.run.frames.member[bar]);
  }

  next_member(by) {
    const numbers = [...this.views[this.chosen.run].run.frames.members.keys()].sort((a, b) => a - b);
    const at = numbers.indexOf(this.chosen.member);
    this.choose(this.chosen.run, numbers[(at + by + numbers.length) % numbers.length] ?? numbers[0]);
  }

  #key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const keys = {
      ArrowLeft: () => this.turn(-0.08, 0), ArrowRight: () => this.turn(0.08, 0), ArrowUp: () => this.turn(0, 0.08),
      ArrowDown: () => this.turn(0, -0.08), "+": () => this.zoom(0.9), "=": () => this.zoom(0.9),
      "-": () => this.zoom(1 / 0.9), " ": () => this.play(), ",": () => this.step(-1), ".": () => this.step(1),
      Home: () => this.seek(this.begin), End: () => this.seek(this.end), "]": () => this.next_member(1),
      "[": () => this.next_member(-1), r: () => this.look("corner"),
      f: () => { this.options.follow = !this.options.follow, this.repaint(), this.changed(this, "options"); },
      Escape: () => this.choose(this.chosen.run, 0),
    };
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  }

  // ---- drawing ----

  redraw() {
    if (this.waiting || !this.renderer) return;
    this.waiting = true;
    requestAnimationFrame((now) => this.#draw(now));
  }

  #draw(now) {
    this.waiting = false;
    if (!this.laid_out) return;
    if (this.playing) {
      const all = this.end - this.begin || 1;
      this.time += Math.min(0.25, (now - this.last) / 1000) * all / 12 * this.options.speed;
      this.last = now;
      if (this.time >= this.end) {
        if (this.options.loop) this.time = this.begin;
        else this.time = this.end, this.playing = false, this.changed(this, "playing");
      }
      this.#place();
      this.changed(this, "time");
    }
    this.draw_now();
    ++this.frames_drawn;
    if (this.playing) this.redraw();
  }

  /// At once, so that the canvas can be read.
  draw_now() {
    const slope = Math.tan(this.camera.fov * Math.PI / 360);
    this.#set_depth();
    this.camera.updateMatrixWorld();
    this.triad.turn(this.camera);
    this.views.forEach((v, i) => {
      const { x, y, w, h } = v.box, up = this.height - y - h;
      this.renderer.setViewport(x, up, w, h);
      this.renderer.setScissor(x, up, w, h);
      v.scene.material.uniforms.pixels.value.set(w, h);
      v.scene.material.uniforms.slope.value = slope;
      this.renderer.clear();
      v.scene.dots.material.uniforms.size.value = (v.run.frames.bars > 500 ?
        Math.max(2, Math.min(4, h / 170)) : 8) * this.renderer.getPixelRatio();
      this.renderer.render(v.scene.scene, this.camera);
      if (this.options.numbers) this.numbers[i].place(v, this.camera); else this.numbers[i].hide();
    });
    const by = this.views[0].run.frames.factors ? `load factor ${number(this.time)}` : `t = ${number(this.time)} s`;
    this.clock.textContent = `${by} · grid ${number(this.views[0].scene.grid_step)} m`
      + (this.options.magnify !== 1 ? ` · displacements × ${number(this.options.magnify)}` : "");
  }

  /// What is seen as a PNG, with time and legend.
  picture() { return picture_of(this, this.legend()); }
}

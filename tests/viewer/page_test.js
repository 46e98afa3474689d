// What a person does with the page of hinge report, in a headless Chromium: it opens without errors and without a
// network, draws, scrubs, plays, picks, hides, is used by keyboard and on a narrow screen.
//
// Run: node tests/viewer/page_test.js CHROMIUM REPORT DAMAGED [PICTURE]   ends with a line for each thing that is wrong
// The report is of the scene of tests/script/report/report_test.lua; DAMAGED of the same without two of its frames, and with one
// row of its history.
"use strict";
const { Browser, checks, drawing } = require("./browser.js");

const { expect, run } = checks();
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
const pause = (ms) => new Promise((r) => setTimeout(r, ms));

// Where the middle of a member is on the screen.
const place = (member) => `(() => {
  const p = hinge_report.player, v = p.views[0], f = v.run.frames, box = p.canvas.getBoundingClientRect();
  p.camera.updateMatrixWorld();
  const bar = f.members.get(${member}).bars[0], e = v.scene.ends, at = p.camera.position.clone();
  at.set(...[0, 1, 2].map((c) => (e[6 * bar + c] + e[6 * bar + 3 + c]) / 2)).project(p.camera);
  return [box.left + (at.x + 1) / 2 * box.width, box.top + (1 - at.y) / 2 * box.height];
})()`;

const colours = "[...hinge_report.player.views[0].scene.paint].join()";

// What was packed is unpacked: f_y follows from the forces (eq 14), and a probe's last value from the positions.
const unpacked = `(() => {
  const { frames, history } = hinge_report.runs[0], c = (f, b, i) => frames.forces[(6 * f + i) * frames.bars + b]
    * frames.scale[6 * b + i], part = (f, b, i, limit) => (c(f, b, i) / frames.limits[4 * b + limit]) ** 2;
  let most_wrong = 0, largest = 0, broken = 0;
  for (let f = 0; f < frames.count; ++f)
    for (let b = 0; b < frames.bars; ++b) {
      const same = part(f, b, 0, 0) + part(f, b, 5, 3);
      const f_y = same + Math.max(part(f, b, 1, 1) + part(f, b, 3, 2), part(f, b, 2, 1) + part(f, b, 4, 2));
      const said = frames.f_y[f * frames.bars + b] * frames.f_y_unit;
      most_wrong = Math.max(most_wrong, Math.abs(f_y - said)), largest = Math.max(largest, said);
      if (f === frames.count - 1 && (frames.state[f * frames.bars + b] & 3) === 2) ++broken;
    }
  const at = 3 * 5, last = 3 * frames.nodes * (frames.count - 1) + at; // the node of the probe is the sixth
  const sway = history.values[history.values.length - 1];
  return { most_wrong, largest, broken, sway: sway[sway.length - 1], ux: frames.positions[last] - frames.declared[at] };
})()`;

async function on_a_wide_screen(b, report, picture) {
  await b.size(1280, 720);
  await b.open(report);
  await b.until("document.documentElement.dataset.ready === 'yes'");
  await pause(200);
  const last = await b.value(drawing);
  expect(last.drawn > 500, `the canvas is blank: ${last.drawn} pixels are drawn`);
  if (picture) await b.picture(picture);
  const data = await b.value(unpacked);
  expect(data.most_wrong < 2e-3, `f_y differs from what the forces give by ${data.most_wrong}`);
  expect(data.largest > 0.9 && data.largest < 1.01, `the largest f_y is ${data.largest}`);
  expect(data.broken === 2, `${data.broken} elements are broken at the end, instead of 2`);
  expect(Math.abs(data.sway) > 1e-4 && Math.abs(data.ux - data.sway) < 1e-6,
    `the probe ends at ${data.sway}, and its node in the last frame at ${data.ux}`);

  await b.value("hinge_report.player.seek(hinge_report.player.begin)");
  const first = await b.value(drawing);
  expect(first.hash !== last.hash, "the first frame looks like the last");
  const range = await b.value("(() => { const slider = document.querySelector('.timeline input');"
    + " slider.scrollIntoView({ block: 'center' }); const r = slider.getBoundingClientRect();"
    + " return [r.left, r.top + r.height / 2, r.width]; })()");
  await b.click(range[0] + 0.6 * range[2], range[1]);
  await b.value("window.scrollTo(0, 0)");
  const share = await b.value("(hinge_report.player.time - hinge_report.player.begin) / (hinge_report.player.end"
    + " - hinge_report.player.begin)");
  expect(Math.abs(share - 0.6) < 0.05, `a click at 60 % of the slider leads to ${share}`);
  expect((await b.value(drawing)).hash !== first.hash, "scrubbing does not change the drawing");

  await b.value("hinge_report.player.seek(0), hinge_report.player.play(true)");
  await b.until("hinge_report.player.time > 0.2 * hinge_report.player.end", 10);
  await b.value("hinge_report.player.play(false)");

  // picking: members in plain sight, by the mouse
  await b.value("hinge_report.player.look('front'), hinge_report.player.seek(0)");
  for (const member of [1, 4, 6]) {
    const [x, y] = await b.value(place(member));
    await b.click(x, y);
    const chosen = await b.value("hinge_report.player.chosen.member");
    expect(chosen === member, `a click on member ${member} picks ${chosen}`);
    const said = await b.value("document.querySelector('.picked h3').textContent");
    expect(said.startsWith(`member ${member} `), `the panel of member ${member} says ${said}`);
    const hints = await b.value("document.querySelector('.picked').textContent");
    expect(hints.includes("at each of the 20 frames, 2\u202fms apart on average"), `the panel's hint on frames: ${hints}`);
  }
  expect(await b.value("document.querySelectorAll('.picked svg').length") === 4, "the history of a member has 4 plots");
  await b.click(...await b.value("(() => { const r = hinge_report.player.canvas.getBoundingClientRect();"
    + " return [r.left + 5, r.top + 5]; })()"));
  expect(await b.value("hinge_report.player.chosen.member") === 0, "a click beside the structure picks nothing");

  // dragging rotates, and does not pick
  const before = await b.value("hinge_report.player.camera.position.toArray().join()");
  const middle = await b.value(place(4));
  await b.drag(middle, [middle[0] + 120, middle[1] + 30]);
  expect(await b.value("hinge_report.player.camera.position.toArray().join()") !== before, "dragging does not rotate");
  expect(await b.value("hinge_report.player.chosen.member") === 0, "dragging picks a member");

  await the_colours(b);

  // colouring, groups, storeys, magnification
  const painted = await b.value(colours);
  await b.value("(() => { const s = [...document.querySelectorAll('.controls select')].find((s) => [...s.options]"
    + ".some((o) => o.value === 'group')); s.value = 'group'; s.dispatchEvent(new Event('change')); })()");
  expect(await b.value(colours) !== painted, "another colouring does not change the colours");
  const shown = "[...hinge_report.player.views[0].scene.shown].reduce((a, b) => a + b)";
  const all = await b.value(shown);
  await b.value("(() => { document.querySelector('details').open = true; document.querySelector('.groups input').click();"
    + " })()");
  expect(await b.value(shown) < all, "hiding a group hides nothing");
  await b.value("document.querySelector('.groups input').click()");
  await b.value("(() => { const s = document.querySelectorAll('.storeys input')[1]; s.value = 1;"
    + " s.dispatchEvent(new Event('input')); })()");
  const cut = await b.value(shown);
  expect(cut > 0 && cut < all, `cut above the first storey ${cut} of ${all} elements are left`);
  await b.value("(() => { const s = document.querySelectorAll('.storeys input')[1]; s.value = 9;"
    + " s.dispatchEvent(new Event('input')); })()");
  await b.value("hinge_report.player.seek(0.004)");
  const plain = await b.value(drawing);
  await b.value("(() => { const s = document.querySelector('input[aria-label^=magnification]'); s.value = 2;"
    + " s.dispatchEvent(new Event('input')); })()");
  expect((await b.value(drawing)).hash !== plain.hash, "magnified displacements look the same");

  // names are text
  expect(await b.value("window.hurt") === undefined, "a name from the model was run as a script");
  expect(await b.value("document.querySelectorAll('main script, main img').length") === 0, "a name has become markup");
  expect((await b.value("document.querySelector('.groups').textContent")).includes("<script>window.hurt = 1</script>"),
    "the group named like markup is not shown as it is named");
  const story = await b.value("document.querySelector('.story').textContent");
  for (const what of ["first hinge", "first contact", "breaks at end", "has reached its limit", "storey 1", "end: completed"])
    expect(story.includes(what), `what happened does not tell of: ${what}`);
  await the_words(b);
  await the_load_paths(b);
  await the_supports(b);
}

// What the page says, in plain words and with units.
async function the_words(b) {
  const all = (what) => b.value(`[...document.querySelectorAll(${JSON.stringify(what)})].map((e) => e.textContent)`);
  const times = await all(".story .at"), story = (await all(".story")).join();
  expect(times.length > 5 && times.every((t) => /^[\d.e-]+\u202fs$/.test(t)), `times of events: ${times.join(", ")}`);
  expect(story.includes("have been in contact: "), "the end does not say what has been in contact");
  expect((await all("th")).includes("has been in contact"), "the tables do not say that something has been in contact");
  expect((await all("h3")).includes("Probes: displacement"), `the probes' quantity is not told: ${await all("h3")}`);
  const units = await b.value(`[...document.querySelector('svg[aria-label="probes over time, displacement"]')
    .querySelectorAll("text")].map((e) => e.textContent)`);
  expect(units.includes("mm"), `the probes' unit is not told: ${units}`);
  const rows = new Map(await b.value(`[...document.querySelectorAll("tr")].map((r) => [...r.cells].map((c) =>
    c.textContent))`));
  const mass = 7850 * (20 * (0.15 ** 2 - 0.138 ** 2) + 0.6 * 0.1 ** 2);
  expect(Math.abs(parseFloat(rows.get("total mass")) - mass) < 0.1 && rows.get("total mass").endsWith("kg"),
    `the total mass is ${rows.get("total mass")} instead of ${mass} kg`);
  const far = rows.get("largest displacement in the last frame, of what stands on supports");
  const [most, node] = await b.value(`(() => {
    const f = hinge_report.runs[0].frames, last = 3 * f.nodes * (f.count - 1), u = (i) => Math.hypot(...[0, 1, 2].map((c) =>
      f.positions[last + 3 * i + c] - f.declared[3 * i + c]));
    const of = [0, 1, 2, 3, 4, 5, ...[...f.ends].filter((i, e) => i < f.nodes && f.member[e >> 1] < 7)];
    return of.map((i) => [u(i), i]).reduce((a, b) => (b[0] > a[0] ? b : a));
  })()`);
  expect(far?.startsWith(`${Number((1000 * most).toPrecision(4))}\u202fmm: `) && (node < 8 ? far.endsWith(`node ${node + 1}`) :
    /a node inside member [1-6]$/.test(far)), `the largest displacement is ${far}, not ${most} m of node ${node + 1}`);
}

// The load that a column leaves to another: which members, and over which time.
async function the_load_paths(b) {
  const text = await b.value(`(() => {
    const { frames, events } = hinge_report.runs[0], was = [frames.forces.slice(), frames.scale.slice()], last = frames.count - 1;
    frames.forces.fill(0), frames.scale.fill(1);
    const put = (f, m, n) => { for (const b of frames.members.get(m).bars) frames.forces[6 * f * frames.bars + b] = n; };
    put(0, 1, -20000), put(0, 3, -5000), put(1, 3, -15000);
    const row = events.rows.find((r) => r[1] === "fracture").slice();
    row[0] = frames.times[1], row[3] = "1", events.rows.push(row);
    const said = hinge_report.story(hinge_report.runs[0]).find((e) => e.kind === "load");
    events.rows.pop(), frames.forces.set(was[0]), frames.scale.set(was[1]);
    return said && said.text;
  })()`);
  expect(text === "load finds another way: member 1, a column of storey 1, carried 20\u202fkN of compression in the frame "
    + "before it broke. Of the storey's other columns, member 3 takes up most: its compression grows from 5\u202fkN at "
    + "0.002\u202fs to 15\u202fkN at 0.004\u202fs", `a load path: ${text}`);
}

// Signs of supports: all are held here; in data that are changed, other kinds, and a plane model.
async function the_supports(b) {
  const signs = (change) => b.value(`(() => {
    const { scene, run: { frames } } = hinge_report.player.views[0], held = frames.held.slice();
    const at = new scene.constructor({ ...frames, held: ((held) => { ${change}; return held; })(held) });
    const points = [...at.support_signs.geometry.attributes.position.array];
    return { kinds: at.supports.map((s) => s.kind).join(), n: points.length / 3, flat: Math.max(...points.filter((v, i) =>
      i % 3 === 2)) - Math.min(...points.filter((v, i) => i % 3 === 2)), size: at.size };
  })()`);
  const as_is = await signs("");
  expect(as_is.kinds === "plate,plate", `clamped supports are ${as_is.kinds}`);
  expect(as_is.flat < 0.01 * as_is.size, `the plates are ${as_is.flat} m high`);
  const shown = await b.value("hinge_report.player.views[0].scene.supports.map((s) => s.kind).join()");
  expect(shown === "plate,plate", `the scene has ${shown}`);
  const pin = await signs("held[0] = 7");
  expect(pin.kinds === "pin,plate" && pin.flat > 0.02 * pin.size && pin.n !== as_is.n, `a pin is ${JSON.stringify(pin)}`);
  const roller = await signs("held[0] = 4, held[3] = 6");
  expect(roller.kinds === "roller,roller" && roller.n === 2 * 16 + 4 + 2, `rollers are ${JSON.stringify(roller)}`);
  expect((await signs("held[0] = 56")).kinds === "turns,plate", "rotations alone have no sign of their own");
  const plane = await signs("held.fill(2 + 8 + 32, 0, 8), held[0] = 63, held[3] = 2 + 8 + 32 + 4");
  const beam = await signs("held.fill(4, 0, 8), held[0] = 7"); // its ends, and those of the bar
  expect(beam.kinds === `pin${",roller".repeat(7)}`, `supports of which all hold uz are ${beam.kinds}`);
  expect(plane.kinds === "plate,roller", `the supports of a plane model are ${plane.kinds}`);
}

async function without_some_frames(b, report) {
  await b.size(1280, 720);
  await b.open(report);
  await b.until("document.documentElement.dataset.ready === 'yes'");
  expect(await b.value("hinge_report.runs[0].frames.count") === 18, "frames of the page without two of them");
  const said = (await b.value("document.querySelector('main').textContent")).match(
    /2 frames could not be read and are not in this page: \S+0003\.vtp, \S+0005\.vtp/);
  expect(said, "the page does not name the frames that could not be read");
  const curve = await b.value(`[...document.querySelectorAll('svg[aria-label="energies over time"] path')].map((p) =>
    [p.getAttribute("d"), p.getAttribute("stroke-linecap")])`);
  expect(curve.length > 0 && curve.every(([d, cap]) => /^M[-\d.]+ [-\d.]+h0$/.test(d) && cap === "round"),
    `a curve of one point is drawn as ${JSON.stringify(curve)}`);
}

// In the page: of each element of a frame, drawn alone, { seen: [t, pixel] along it, slack: what 1.5 pixels are of its
// length }, and what the data say of it.
const along_elements = (frame, colouring) => `(async () => {
  const p = hinge_report.player, v = p.views[0], { scene } = v, f = v.run.frames, out = [];
  p.options.colouring = "${colouring}", p.chosen.member = 0;
  scene.dots.drawn.visible = scene.ground.visible = false;
  p.seek(f.abscissa[${frame}]), p.repaint();
  const gl = p.renderer.getContext(), [w, h] = [p.canvas.width, p.canvas.height], at = p.camera.position.clone();
  const all = scene.paint.slice(), pixels = new Uint8Array(4 * w * h);
  for (let b = 0; b < f.bars; ++b) {
    scene.paint.fill(0).set(all.subarray(4 * b, 4 * b + 4), 4 * b), scene.colour.needsUpdate = true;
    p.renderer.clear(), p.renderer.render(scene.scene, p.camera);
    gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const e = scene.ends.subarray(6 * b, 6 * b + 6), place = (t) => {
      at.set(...[0, 1, 2].map((c) => e[c] + t * (e[c + 3] - e[c]))).project(p.camera);
      return [(at.x + 1) / 2 * w, (at.y + 1) / 2 * h];
    };
    const [from, to] = [place(0), place(1)], long = Math.hypot(to[0] - from[0], to[1] - from[1]), seen = [];
    for (let i = 0; i <= 40; ++i) {
      const [x, y] = place(i / 40).map(Math.floor), o = 4 * (w * y + x);
      if (x >= 0 && x < w && y >= 0 && y < h) seen.push([i / 40, [...pixels.subarray(o, o + 3)]]);
    }
    const k = ${frame} * f.bars + b;
    out.push({ member: f.member[b], seen, slack: 1.5 / long, state: f.state[k] & 3, f_y: f.f_y[k] * f.f_y_unit,
      limits: [...f.limits.subarray(4 * b, 4 * b + 4)], forces: [0, 1, 2, 3, 4, 5].map((c) =>
        f.forces[(6 * ${frame} + c) * f.bars + b] * f.scale[6 * b + c]) });
  }
  scene.dots.drawn.visible = scene.ground.visible = true;
  p.options.colouring = "f_y", p.repaint();
  return out;
})()`;

// Which of the colours a pixel has; the light makes it darker, or a little brighter. -1: none of them.
function class_seen(pixel, classes) {
  const away = classes.map((c) => {
    const dot = (a) => a.reduce((s, v, i) => s + v * c[i], 0);
    const light = Math.min(1.06, Math.max(0.5, dot(pixel) / dot(c)));
    return Math.max(...c.map((v, i) => Math.abs(Math.min(255, light * v) - pixel[i])));
  });
  const least = Math.min(...away);
  return least < 3 ? away.indexOf(least) : -1;
}

// The class of f_y (eq 14), or of M / M0, at a place of an element: moments in a straight line between its ends.
function class_wanted(e, colouring, t) {
  if (e.state === 2) return 6;
  const [n, x1, x2, y1, y2, z] = e.forces, [n0, x0, y0, z0] = e.limits;
  const m = Math.hypot(((1 - t) * x1 + t * x2) / x0, ((1 - t) * y1 + t * y2) / y0);
  const value = colouring === "bending" ? m : n0 ? Math.min((n / n0) ** 2 + m ** 2 + (z / z0) ** 2, e.f_y) : e.f_y;
  return value >= 0.999 ? 5 : Math.floor(5 * value);
}

// The colours of pictures: along each element the class of f_y in fifths, f_y = 1, or all black where it is broken.
async function the_colours(b) {
  const header = require("fs").readFileSync(require("path").join(__dirname, "../../src/output/colours.h"), "utf8");
  const classes = [...header.match(/class_colours = \{\s*\{(.*?)\}\};/s)[1].matchAll(/\{([\d, ]+)\}/g)]
    .map((m) => m[1].split(",").map(Number));
  expect(classes.length === 7, "src/output/colours.h has no seven colours of f_y");
  const legend = (kind) => b.value(`[...document.querySelectorAll('.controls .legend .swatch${kind}')].map((s) =>
    getComputedStyle(s).backgroundColor.match(/\\d+/g).map(Number))`);
  expect(same(await legend(":not(.dot)"), classes), "the legend's colours are not those of pictures");
  expect(same(await legend(".dot"), [classes[5]]), "the legend does not have the dots' colour");
  const tick = "[...document.querySelectorAll('.tick')].find((e) => e.textContent === 'hinges').click()";
  const said = "document.querySelector('.controls .legend').textContent.includes('plastic hinge')";
  expect(await b.value(said) && !await b.value(`${tick}, ${said}`) && await b.value(`${tick}, ${said}`),
    "the legend does not say what the dots are, or says it where there are none");

  await b.value("hinge_report.player.look('corner')");
  const count = await b.value("hinge_report.player.runs[0].frames.count"), kinds = new Set(), bands = new Set();
  const look_at = async (frame, colouring) => {
    let places = 0;
    const bad = [], elements = await b.value(along_elements(frame, colouring));
    elements.forEach((e, i) => {
      const of_element = new Set();
      for (const [t, pixel] of e.seen) {
        const seen = class_seen(pixel, classes), within = [-e.slack, 0, e.slack].map((s) => class_wanted(e, colouring,
          Math.min(1, Math.max(0, t + s))));
        if (!within.includes(seen)) bad.push(`element ${i + 1} at t = ${t} has the class ${seen} instead of ${within}`);
        kinds.add(seen), of_element.add(seen), ++places;
      }
      if (of_element.size > 2) bands.add(i);
    });
    expect(bad.length === 0, `frame ${frame + 1}, ${colouring}: ${bad.length} of ${places} places, first: ${bad[0]}`);
    expect(places > 41 * 8, `frame ${frame + 1}: no more than ${places} places are seen`);
    return elements;
  };
  for (const frame of [0, 1, 2, 4, 7, Math.floor(count / 2), count - 2, count - 1]) await look_at(frame, "f_y");
  expect(kinds.size === 7, `no more than the classes ${[...kinds].sort()} are seen`);
  expect(bands.size > 3, `no more than ${bands.size} elements have three bands and more`);
  for (const frame of [1, count - 1]) await look_at(frame, "bending");

  // What this plane frame does not have, in data that are changed: f_y beneath what the forces give, which is the most;
  // Mz in all elements; elements without limits, which have the one colour of their f_y.
  const changed = async (change, what) => {
    await b.value(`(() => {
      const f = hinge_report.runs[0].frames;
      window.data = ["f_y", "forces", "scale", "limits"].map((name) => [f[name], f[name].slice()]);
      ${change}
    })()`);
    const elements = await look_at(1, "f_y");
    expect(elements.every(what), `the data are not changed by ${change}`);
    await b.value("for (const [array, was] of window.data) array.set(was); hinge_report.player.repaint()");
  };
  await changed("f.f_y.forEach((v, i) => { f.f_y[i] = v / 2; });", (e) => e.f_y < 0.51);
  await changed(`f.f_y.fill(65535); for (let b = 0; b < f.bars; ++b) {
    f.scale[6 * b + 5] = 0.7 * f.limits[4 * b + 3] / 1000, f.forces[(6 + 5) * f.bars + b] = 1000;
  }`, (e) => e.f_y > 3 && Math.abs(e.forces[5] / e.limits[3] - 0.7) < 1e-3);
  await changed("f.limits.fill(0);", (e) => !e.limits.some((v) => v));

  // The member picked is magenta all along, the others keep their bands; hidden ones are not drawn.
  await b.value("hinge_report.player.choose(0, 4)");
  const chosen = await b.value(`(() => {
    const { scene, run: { frames: f } } = hinge_report.player.views[0], of = (i) => [scene.paint[4 * i] & 0xffffff,
      scene.course.array[16 * i + 3] < 0];
    return [...f.member].map((m, i) => [m, ...of(i)]);
  })()`);
  for (const [member, paint, plain_one] of chosen)
    expect((member === 4) === (plain_one && paint === (214 | 39 << 8 | 196 << 16)), `member ${member} has ${paint}`);
  await b.value("hinge_report.player.choose(0, 0)");
}

async function by_keyboard(b) {
  await b.value("hinge_report.player.choose(0, 0), hinge_report.player.canvas.focus()");
  const camera = "hinge_report.player.camera.position.toArray().map((x) => x.toFixed(6)).join()";
  for (const [key, text] of [["ArrowLeft"], ["ArrowUp"], ["+", "+"], ["-", "-"]]) {
    const before = await b.value(camera);
    await b.key(key, text);
    expect(await b.value(camera) !== before, `the key ${key} does not move the camera`);
  }
  await b.key("Home");
  const start = await b.value("hinge_report.player.time");
  await b.key(".", ".");
  expect(await b.value("hinge_report.player.time") > start, "full stop does not step on");
  await b.key("]", "]");
  expect(await b.value("hinge_report.player.chosen.member") === 1, "] does not pick the first member");
  await b.key(" ", " ");
  expect(await b.value("hinge_report.player.playing"), "space does not play");
  await b.key(" ", " ");
  expect(!await b.value("hinge_report.player.playing"), "space does not stop");
}

async function on_a_narrow_screen(b, report) {
  await b.size(390, 800, true);
  await b.open(report);
  await b.until("document.documentElement.dataset.ready === 'yes'");
  await pause(200);
  const width = await b.value("document.documentElement.scrollWidth");
  expect(width <= 390, `on a screen of 390 pixels the page is ${width} wide`);
  expect((await b.value(drawing)).drawn > 200, "the canvas is blank on a narrow screen");
  const reached = new Set();
  for (let i = 0; i < 30; ++i) {
    await b.key("Tab");
    reached.add(await b.value("document.activeElement.tagName"));
  }
  for (const tag of ["CANVAS", "BUTTON", "INPUT", "SELECT"]) expect(reached.has(tag), `Tab does not reach ${tag}`);
}

run(async () => {
  const [program, report, damaged, picture] = process.argv.slice(2);
  const b = await Browser.start(program);
  try {
    for (const part of [() => on_a_wide_screen(b, report, picture), () => by_keyboard(b), () =>
      on_a_narrow_screen(b, report), () => without_some_frames(b, damaged)]) {
      await part();
      for (const problem of b.problems) expect(false, `the page complains: ${problem}`);
      const others = b.requests.filter((u) => !u.startsWith("file://") && !u.startsWith("data:") && !u.startsWith("blob:"));
      expect(others.length === 0, `the page asks for ${others.join(" ")}`);
    }
  } finally {
    await b.stop();
  }
});

// What the player of hinge report shows besides members: diagrams, numbers of nodes, the view without perspective, the
// picture that is saved, the list of members, the directions of the axes on a narrow screen, edges of light colours.
//
// Run: node tests/viewer/player_test.js CHROMIUM REPORT DIAGRAMS PANELS      ends with a line for each thing that is wrong
// They are of the first scene of tests/script/report/report_test.lua, and of the two before its player is looked at.
"use strict";
const { Browser, checks } = require("./browser.js");

const { expect, run } = checks();
const player = "hinge_report.player", view = `${player}.views[0]`;
const near = (a, b, tolerance) => Math.abs(a - b) <= tolerance;

async function open(b, report, width, height, mobile = false) {
  await b.size(width, height, mobile);
  await b.open(report);
  await b.until(`document.documentElement.dataset.ready === 'yes' && ${player}.frames_drawn > 0`);
}
const choose = (value) => `(() => { const s = [...document.querySelectorAll('.controls select')].find((s) => [...s.options]
  .some((o) => o.value === '${value}' || o.text === '${value}')); s.value = '${value}' === 'none' ? '' : '${value}';
  s.dispatchEvent(new Event('change')); })()`;
const tick = (label) => `[...document.querySelectorAll('.tick')].find((e) => e.textContent === '${label}').click()`;

// A beam clamped at x = 0 and pinned at x = L under q downwards: M = -q L^2 / 8 + 5 q L x / 8 - q x^2 / 2, sagging positive.
async function the_diagrams(b, report) {
  const q = 10e3, L = 6, sagging = (x) => -q * L * L / 8 + 5 * q * L * x / 8 - q * x * x / 2;
  await open(b, report, 1280, 720);
  expect(await b.value(`!${view}.scene.diagram.fill.visible && document.querySelector('.legend.diagram').textContent === ''`),
    "there is a diagram before one is asked for");
  // [x along the beam, how far above the axis, Mx] of each corner of the diagram of the beam at y.
  await b.value(choose("Mx"));
  const corners_at = (y) => b.value(`(() => {
    const { fill, at, values } = ${view}.scene.diagram, used = new Set(), out = [];
    const index = fill.geometry.index.array, n = fill.geometry.drawRange.count;
    for (let i = 0; i < n; ++i) used.add(index[i]);
    for (const v of used) if (Math.abs(at[3 * v + 1] - ${y}) < 1e-6) out.push([at[3 * v], at[3 * v + 2], values[v]]);
    return out;
  })()`);
  const corners = await corners_at(0);
  expect(corners.length > 30, `the diagram has ${corners.length} corners`);
  const most = q * L * L / 8; // of the figures below 1 % is more than shear deformation and four elements make
  for (const [x, z, M] of corners)
    expect(near(-M, sagging(x), 0.01 * most), `at x = ${x} Mx is ${M}, and the beam has ${-sagging(x)}`);
  const outer = corners.filter(([, z]) => Math.abs(z) > 1e-3);
  expect(outer.length > 10 && outer.every(([, z, M]) => z * M > 0), "the moments are not on the side in tension");
  // The same with a moment at the pinned end: the peak follows from the moments at both ends, M0 + R^2 / 2q with
  // R = (q L^2 / 2 + ML - M0) / L, and lies between two stations.
  const third = await corners_at(6), end = (x) => third.filter((c) => Math.abs(c[0] - x) < 1e-6)[0][2];
  const [M0, ML] = [-end(0), -end(L)], R = (q * L * L / 2 + ML - M0) / L;
  const top = Math.max(...third.map(([, , M]) => -M)), wanted = M0 + R * R / (2 * q);
  expect(Math.abs(ML) > 19e3 && near(top, wanted, 1e-4 * most), `the peak of the span is ${top}, not ${wanted}`);
  const said = await b.value("document.querySelector('.legend.diagram').textContent");
  expect(/largest in this frame: \d\d(\.\d+)?\u202fkN m in member [13]/.test(said), `the legend says ${said}`);
  expect(said.includes("1 element with loads at points left out"), `a point load between ends is not told: ${said}`);
  const of_two = (await corners_at(3)).filter(([x]) => x < 2.99).length;
  expect(of_two === 0, `of an element with a point load ${of_two} corners are drawn`);
  // N has one value all along, whatever acts between the ends.
  expect(await b.value(`(${choose("N")}, ${view}.diagram.left_out)`) === 0, "N is left out for point loads");
  expect(await b.value(`(${choose("none")}, ${view}.scene.diagram.fill.visible)`) === false, "the diagram stays");
}

async function numbers_and_parallel(b, report) {
  await open(b, report, 1280, 720);
  const off = await b.value(`(() => {
    ${tick("node numbers")};
    ${player}.look('front'), ${player}.seek(${player}.begin), ${player}.draw_now();
    const { scene, box, run: { frames } } = ${view}, at = ${player}.camera.position.clone(), wrong = [];
    const spans = [...document.querySelectorAll('.numbers span')].filter((s) => !s.hidden);
    for (const s of spans) {
      const node = Number(s.textContent) - 1;
      at.fromArray(frames.positions, 3 * node).project(${player}.camera);
      const [x, y] = s.style.transform.match(/-?[\\d.]+/g).map(Number);
      const away = Math.hypot(x - (at.x + 1) / 2 * box.w, y - (1 - at.y) / 2 * box.h);
      if (!(away < 20)) wrong.push(node + 1 + " is " + away + " pixels away");
    }
    return { numbers: spans.map((s) => Number(s.textContent)).sort((a, b) => a - b), wrong };
  })()`);
  expect(off.wrong.length === 0, `numbers of nodes: ${off.wrong}`);
  expect(off.numbers.length >= 6 && off.numbers[0] === 1 && off.numbers.every((n) => n <= 8), `numbers: ${off.numbers}`);
  expect(await b.value(`(() => { ${tick("node numbers")}; ${player}.draw_now();
    return [...document.querySelectorAll('.numbers span')].every((s) => s.hidden); })()`), "the numbers stay");

  // Two columns, one 4 m behind the other: how long they are drawn.
  const lengths = `(() => {
    ${player}.draw_now();
    const { run: { frames } } = ${view}, end = (node) => ${player}.camera.position.clone().fromArray(frames.declared, 3 * node)
      .project(${player}.camera);
    return [0, 3].map((foot) => Math.abs(end(foot + 1).y - end(foot).y));
  })()`;
  const [near_one, far_one] = await b.value(`(${player}.look('side'), ${lengths})`);
  expect(near_one > 1.05 * far_one, `with perspective the columns are ${near_one} and ${far_one} long`);
  const [first, second] = await b.value(`(${tick("parallel")}, ${lengths})`);
  expect(near(first / second, 1, 3e-3), `without perspective the columns are ${first} and ${second} long`);
  expect(first > far_one && first < near_one, `without perspective they are ${first}, before ${near_one} and ${far_one}`);
  // Picking goes by what is seen in this view, too.
  const picked = await b.value(`(() => {
    ${player}.look('front'), ${player}.draw_now();
    const { scene, box, run: { frames } } = ${view}, e = scene.ends, bar = frames.members.get(3).bars[0], o = 6 * bar;
    const p = ${player}.camera.position.clone().set(...[0, 1, 2].map((c) => (e[o + c] + e[o + 3 + c]) / 2)).project(${player}.camera);
    return frames.member[scene.pick(${player}.camera, (p.x + 1) / 2 * box.w, (1 - p.y) / 2 * box.h, box.w, box.h)];
  })()`);
  expect(picked === 3, `without perspective a click on member 3 picks ${picked}`);
}

async function the_picture(b) {
  const saved = await b.value(`(() => {
    let file = null;
    HTMLAnchorElement.prototype.click = function () { file = { name: this.download, start: this.href.slice(0, 22) }; };
    [...document.querySelectorAll('.controls button')].find((b) => b.textContent === 'save picture').click();
    delete HTMLAnchorElement.prototype.click;
    const made = ${player}.picture(), draw = made.getContext('2d'), count = (from, high) => {
      const bytes = draw.getImageData(0, from, made.width, high).data, seen = new Set();
      let other = 0;
      for (let i = 0; i < bytes.length; i += 4) if (bytes[i] !== bytes[0] || bytes[i + 1] !== bytes[1]) ++other;
      return other;
    };
    const { width, height } = ${player}.canvas;
    return { file, wide: made.width - width, high: made.height - height, drawn: count(0, height), legend:
      count(height, made.height - height) };
  })()`);
  expect(saved.file?.name === "hinge.png" && saved.file.start === "data:image/png;base64,", `saved: ${JSON.stringify(saved)}`);
  expect(saved.wide === 0 && saved.high > 20 && saved.drawn > 500 && saved.legend > 200, `the picture: ${JSON.stringify(saved)}`);
}

async function the_list(b, report) {
  await open(b, report, 1280, 720);
  const listed = (at) => b.value(`(() => {
    ${player}.seek(${at});
    const f = hinge_report.runs[0].frames, k = ${view}.frame, most = (m) => Math.max(...m.bars.map((b) => ((f.state[k * f.bars + b]
      & 3) === 2 ? 0 : f.f_y[k * f.bars + b] * f.f_y_unit)));
    const best = [...f.members.values()].filter((m) => m.bars.every((b) => (f.state[k * f.bars + b] & 3) !== 2)).sort((a, b) =>
      most(b) - most(a))[0];
    const rows = [...document.querySelectorAll('.picked tbody tr')].map((r) => [...r.cells].map((c) => c.textContent));
    return { rows, best: best.number, f_y: most(best), facts: document.querySelector('.picked p').textContent };
  })()`);
  const last = await listed(`${player}.end`), first = await listed(`${player}.begin`);
  for (const seen of [first, last]) {
    expect(seen.rows.length > 4 && near(Number(seen.rows[0][3]), seen.f_y, 0.0051 * seen.f_y), `the most strained is member ${
      seen.best} with ${seen.f_y}, the list has ${seen.rows[0]}`);
  }
  expect(last.rows.join() !== first.rows.join(), "the list is the same at another time");
  expect(/^7 members: \d elastic, \d yielded, 1 broken; \d have been in contact$/.test(last.facts), `it says ${last.facts}`);
  const chosen = await b.value(`(document.querySelector('.picked .member-link').click(), ${player}.chosen.member)`);
  expect(chosen > 0 && (await b.value("document.querySelector('.picked h3').textContent")).startsWith(`member ${chosen} `),
    `a click on the list picks ${chosen}`);
}

async function on_a_phone(b, report) {
  await open(b, report, 390, 800, true);
  for (const from of ["corner", "front", "top"]) {
    const names = await b.value(`(() => {
      ${player}.look('${from}'), ${player}.draw_now();
      const box = document.querySelector('.stage').getBoundingClientRect();
      return [...document.querySelectorAll('.triad text')].filter((t) => t.style.visibility !== 'hidden').map((t) => {
        const r = t.getBoundingClientRect();
        return [t.textContent, r.width > 0 && r.left >= box.left && r.right <= box.right && r.top >= box.top && r.bottom <=
          box.bottom && r.right <= innerWidth];
      });
    })()`);
    expect(names.length === (from === "corner" ? 3 : 2) && names.every(([, whole]) => whole), `axes from ${from}: ${names}`);
  }
}

// Across a wide bar of each colour: how much darker its edge is than its middle.
async function the_edges(b) {
  const ratio = (colour) => b.value(`(() => {
    ${player}.look('front'), ${player}.zoom(0.3), ${player}.seek(${player}.begin);
    const { scene, run: { frames } } = ${view}, gl = ${player}.renderer.getContext(), [w, h] = [${player}.canvas.width,
      ${player}.canvas.height], bar = frames.members.get(1).bars[0], e = scene.ends, o = 6 * bar;
    ${player}.orbit.target.set(...[0, 1, 2].map((c) => (e[o + c] + e[o + 3 + c]) / 2));
    ${player}.camera.position.copy(${player}.orbit.target).y -= 2;
    ${player}.orbit.update();
    scene.shown.fill(0), scene.shown[bar] = 1, scene.dots.drawn.visible = scene.ground.visible = false;
    scene.paint_bars(() => [${colour}], 0);
    ${player}.draw_now();
    const row = new Uint8Array(4 * w);
    gl.readPixels(0, Math.floor(h / 2), w, 1, gl.RGBA, gl.UNSIGNED_BYTE, row);
    const red = (i) => row[4 * i], back = red(0), inside = [...Array(w).keys()].filter((i) => Math.abs(row[4 * i + 2]
      - row[2]) > 8 || Math.abs(red(i) - back) > 8);
    const from = inside[0], to = inside[inside.length - 1], middle = (from + to) >> 1;
    return { wide: to - from, ratio: red(from) / red(middle) };
  })()`);
  for (const light of ["250, 214, 80", "150, 212, 226"]) {
    const seen = await ratio(light);
    expect(seen.wide > 20 && seen.ratio < 0.6, `a bar of rgb(${light}) has an edge of ${JSON.stringify(seen)}`);
  }
  const dark = await ratio("236, 126, 44");
  expect(dark.ratio > 0.7, `a bar of a darker colour has an edge of ${JSON.stringify(dark)}`);
}

// A panel that is pulled, one that is pressed, each by a force per width that is known, and a triangle.
async function the_panels(b, report) {
  await open(b, report, 1280, 720);
  const forces = await b.value(`(() => { const { frames } = ${view}.run, last = frames.count - 1;
    return [0, 1, 2].map((p) => frames.plate_forces[3 * last + p] * frames.plate_scale); })()`);
  expect(near(forces[0], 2e5, 2e3) && near(forces[1], -8e5, 8e3), `the panels have ${forces} N/m`);
  const { colour, at } = await b.value(`(${player}.seek(${player}.end), { colour: [...${view}.scene.plates.colour.array],
    at: [...${view}.scene.plates.at.array] })`);
  expect(colour[2] > colour[0] && colour[12] > colour[14], `colours of tension and compression: ${colour.slice(0, 15)}`);
  expect(near(at[3], 2, 0.01) && near(at[12 + 7], 3, 0.01), `corners are at ${at.slice(0, 24)}`);
  const text = () => b.value("document.querySelector('.legend').textContent");
  expect((await text()).includes("panel in tension"), "the legend does not name panels");
  await b.value(tick("panels"));
  expect(!(await text()).includes("panel in tension") && await b.value(`!${view}.scene.plates.visible`),
    "panels stay when they are not wanted");
}

run(async () => {
  const [program, report, diagrams, panels] = process.argv.slice(2);
  const b = await Browser.start(program);
  try {
    for (const part of [() => the_diagrams(b, diagrams), () => numbers_and_parallel(b, report), () => the_picture(b), () =>
      the_list(b, report), () => the_edges(b), () => the_panels(b, panels),
      () => on_a_phone(b, report)]) {
      await part();
      for (const problem of b.problems) expect(false, `the page complains: ${problem}`);
    }
  } finally {
    await b.stop();
  }
});

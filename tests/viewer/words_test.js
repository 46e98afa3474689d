// What the page of hinge report says is so: numbers at the cursor, damage by storey, warnings, accuracy and who broke.
//
// Run: node tests/viewer/words_test.js CHROMIUM REPORT STOREYS CALM ACCURATE
// It ends with a line for each thing that is wrong. REPORT, STOREYS and CALM are of the first three scenes of
// tests/script/report/report_test.lua; CALM has no warning. ACCURATE is REPORT as hinge run --within leaves it; what
// STOREYS has of that is of another model.
"use strict";
const { Browser, checks } = require("./browser.js");

const { expect, run } = checks();
const ready = "document.documentElement.dataset.ready === 'yes'";

// Beside each curve of the plots with this label, at a time: { name, said, value }, with the value in the curve's unit.
const beside = (label, time) => `(() => {
  const prefix = { G: 1e9, M: 1e6, k: 1e3, m: 1e-3, "µ": 1e-6 }, p = hinge_report.player;
  p.seek(${time});
  const figure = document.querySelector('svg[aria-label="${label}"]').closest("figure");
  const unit = [...figure.querySelectorAll("text")].pop().textContent;
  return [...figure.querySelectorAll(".legend button")].map((b) => ({ name: b.childNodes[1].textContent,
    said: b.querySelector("small").textContent.trim(), unit: prefix[unit[0]] && unit.length > 1 && !/^m\\/s/.test(unit) ?
    prefix[unit[0]] : 1 })).map((c) => ({ ...c, value: c.said === "–" ? null : Number(c.said) * c.unit }));
})()`;

// Three digits are said: half of the last one is 0.5 % at most.
const close = (a, b) => Math.abs(a - b) <= 0.0051 * Math.abs(b) + 1e-12;

async function at_the_cursor(b, report) {
  await b.open(report);
  await b.until(ready);
  await b.value("hinge_report.player.choose(0, 3)");
  const frames = "hinge_report.runs[0].frames", times = await b.value(`[...${frames}.times]`), seen = new Set();
  for (const f of [0, 3, 8, times.length - 1]) {
    const curves = await b.value(beside("axial force over time", times[f] + 0.2 * (times[1] - times[0])));
    // The panel's element is the one with the largest f_y of all frames.
    const { N, head } = await b.value(`(() => {
      const f = ${frames}, y = (k, b) => f.f_y[k * f.bars + b], bars = f.members.get(3).bars;
      const most = (b) => Math.max(...Array.from({ length: f.count }, (_, k) => y(k, b)));
      const bar = bars.reduce((a, b) => (most(b) > most(a) ? b : a));
      return { N: f.forces[6 * ${f} * f.bars + bar] * f.scale[6 * bar], head: document.querySelector(
        ".picked p").textContent };
    })()`);
    expect(curves.length === 1 && close(curves[0].value, N), `in frame ${f + 1}, with N = ${N} N, beside the curve: ${
      JSON.stringify(curves)}`);
    expect(close(parseFloat(head.match(/ N (\S+)/)[1]) * (head.endsWith("kN") ? 1e3 : head.endsWith("MN") ? 1e6 : 1), N),
      `in frame ${f + 1}, with N = ${N} N, the head says ${head}`);
    seen.add(curves[0].said);
  }
  expect(seen.size > 2, `the number beside the curve is always one of ${[...seen]}`);
  // Curves of the history are straight between its rows.
  for (const share of [0.3, 0.55, 1]) {
    const at = share * times[times.length - 1];
    const [curves, rows] = [await b.value(beside("energies over time", at)), await b.value("hinge_report.runs[0].history")];
    const x = rows.values[0], i = Math.min(x.length - 2, x.findIndex((t) => t > at) - 1 < 0 ? x.length - 2 :
      x.findIndex((t) => t > at) - 1);
    const part = Math.min(1, (at - x[i]) / (x[i + 1] - x[i]));
    for (const name of ["kinetic", "elastic"]) {
      const column = rows.values[rows.columns.indexOf(name)], wanted = column[i] + part * (column[i + 1] - column[i]);
      const said = curves.find((c) => c.name === name);
      expect(said && close(said.value, wanted), `${name} energy at ${at} s is ${wanted} J, beside the curve: ${
        JSON.stringify(said)}`);
    }
  }
}

async function storeys_and_warnings(b, without, report) {
  const card = "(t) => [...document.querySelectorAll('.card')].find((c) => c.querySelector('h2')?.textContent === t)";
  const first = "document.querySelector('main').children[1]?.querySelector('h2')?.textContent";
  const colour = "getComputedStyle(document.querySelector('.verdict strong')).backgroundColor";
  await b.open(without);
  await b.until(ready);
  const green = await b.value(colour);
  expect(await b.value(`(${card})("Warnings") === undefined`), "a run without warnings has a card of them");
  await b.open(report);
  await b.until(ready);
  expect(await b.value(first) === "Warnings", `below the heading stands ${await b.value(first)}`);
  const said = await b.value("document.querySelector('.verdict').textContent");
  expect(said.startsWith("completed · 1 warning"), `the verdict is ${said}`);
  expect(await b.value(colour) !== green, "a run with warnings has the colour of one without");
  expect((await b.value(`(${card})("Warnings").textContent`)).includes("belongs to no member"), "the warning is not told");

  // Three columns and two beams in each storey. A column is lost before the first frame, a beam in each storey is held by
  // connectors.
  for (const [what, at] of [["first", "begin"], ["last", "end"]]) {
    const rows = await b.value(`(hinge_report.player.seek(hinge_report.player.${at}), [...(${card})("Damage by storey")
      .querySelectorAll("tbody tr")].map((r) => [...r.cells].map((c) => c.textContent)))`);
    const of = (name) => rows.find((r) => r[0] === name) ?? [];
    expect(of("storey 1")[1] === "5" && of("storey 1")[4] === "1", `in the ${what} frame storey 1 is ${of("storey 1")}`);
    expect(of("storey 2")[1] === "5" && of("storey 2")[4] === "0", `in the ${what} frame storey 2 is ${of("storey 2")}`);
  }
}

const offered = "[...document.querySelectorAll('.controls option')].some((o) => o.value === 'broken_in')";

// Errors in a table, and members coloured by the runs in which they broke: 7 in all five, 4 in three, 1 in one.
async function accuracy_and_who_broke(b, report) {
  await b.open(report);
  await b.until(ready);
  const card = "[...document.querySelectorAll('.card')].find((c) => c.querySelector('h2')?.textContent.startsWith('Accuracy'))";
  const text = await b.value(`${card}.textContent`);
  for (const what of ["within 10 %: dt 20 us", "asked 10 %, estimated 6 %, cost 4 s; 7 runs", "sway is chaotic",
    "in 5 runs with small changes", "1 of 7 members broke in all 5 runs, 2 in some of them, 4 in none"])
    expect(text.includes(what), `accuracy does not tell '${what}': ${text}`);
  const rows = await b.value(`[...${card}.querySelectorAll("tbody tr")].map((r) => [...r.cells].map((c) => c.textContent).join("|"))`);
  expect(rows.join("; ") === "sway (chaotic, mean)|12.35|6 %|1.5|5 runs, mean 12.35, scatter 1.5; member 7|<b>|5 of 5; "
    + "member 4|columns|3 of 5; member 1|columns|1 of 5", `its tables: ${rows.join("; ")}`);
  expect((await b.value(`${card}.querySelector("img").src`)).startsWith("data:image/png;base64,iVBOR"), "its picture");

  await b.value(`[...${card}.querySelectorAll("button")].find((e) => e.textContent === "member 4").click()`);
  const panel = await b.value("document.querySelector('.picked').textContent");
  expect(panel.includes("broken in 3 of 5 runs"), `the panel of member 4: ${panel.slice(0, 300)}`);
  await b.value("hinge_report.player.choose(0, 2)");
  expect((await b.value("document.querySelector('.picked').textContent")).includes("broken in 0 of 5 runs"), "member 2");

  await b.value(`hinge_report.player.choose(0, 0), (() => { const s = [...document.querySelectorAll(".controls select")].find((s) =>
    [...s.options].some((o) => o.value === "broken_in")); s.value = "broken_in"; s.dispatchEvent(new Event("change")); })()`);
  const header = require("fs").readFileSync(require("path").join(__dirname, "../../src/output/colours.h"), "utf8");
  const shares = [...header.match(/share_colours = \{\s*\{(.*?)class_colours/s)[1].matchAll(/\{([\d, ]+)\}/g)]
    .map((m) => m[1].split(",").map(Number)).concat([[10, 10, 12]]);
  const seen = await b.value(`(() => {
    const { scene, run: { frames: f } } = hinge_report.player.views[0];
    return [...f.member].map((m, i) => [m, [0, 8, 16].map((s) => scene.paint[4 * i] >> s & 255)]);
  })()`);
  for (const [member, colour] of seen) {
    const wanted = shares[{ 7: 3, 4: 2, 1: 1 }[member] ?? 0];
    expect(colour.join() === wanted.join(), `member ${member} has the colour ${colour} instead of ${wanted}`);
  }
  const legend = await b.value("[...document.querySelectorAll('.controls .legend:not(.diagram) > span')].map((e) => e.textContent)");
  expect(legend.join() === "broken in 0 of 5,broken in 1 or 2 of 5,broken in 3 or 4 of 5,broken in 5 of 5",
    `the legend is ${legend.join()}`);
  expect(!await b.value("hinge_report.player.views[0].scene.dots.drawn.visible"), "dots of hinges stand over the colours");
}

run(async () => {
  const [program, report, storeys, without, accurate] = process.argv.slice(2);
  const b = await Browser.start(program);
  try {
    await b.size(1280, 720);
    for (const part of [() => at_the_cursor(b, report), () => storeys_and_warnings(b, without, storeys)]) {
      await part();
      expect(!await b.value(offered), "who broke is offered as a colour where it is not known");
      for (const problem of b.problems) expect(false, `the page complains: ${problem}`);
    }
    await accuracy_and_who_broke(b, accurate);
  } finally {
    await b.stop();
  }
});

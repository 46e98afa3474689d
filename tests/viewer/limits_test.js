// The limits of the page of hinge report: its size, how long it takes to open, and how many frames a second the player
// draws while it plays, in a headless Chromium that draws on the processor. A part of tests/everything.lua, with Case I
// of the ten-storey frame and 100 frames.
//
// Run: node tests/viewer/limits_test.js CHROMIUM REPORT [FRAMES]      prints what it measured, what is beyond limits
// FRAMES: how many the run must have, 100 unless told. Of three openings the best counts: other programs may run, too.
"use strict";
const fs = require("fs");
const { Browser, drawing } = require("./browser.js");

const most_megabytes = 15, most_seconds = 2, least_rate = 30;

// Plays the run once. Returns the frames drawn, in how many seconds, and where the player stopped.
const played = `(async () => {
  const p = hinge_report.player, before = p.frames_drawn, start = performance.now();
  p.seek(p.begin), p.play(true);
  while (p.playing && performance.now() - start < 60000) await new Promise((r) => setTimeout(r, 20));
  return { drawn: p.frames_drawn - before, seconds: (performance.now() - start) / 1000, whole: p.time === p.end };
})()`;

// A browser of its own, so that nothing is left from an earlier opening.
async function measured(program, report) {
  const b = await Browser.start(program);
  try {
    await b.size(1280, 720);
    const start = Date.now();
    await b.open(report);
    await b.until("hinge_report.player.frames_drawn > 0", 60);
    const { drawn } = await b.value(drawing), open = (Date.now() - start) / 1000;
    if (!(drawn > 500)) throw new Error(`the canvas is blank: ${drawn} pixels are drawn`);
    const { frames, bars, width, height } = await b.value(`(() => {
      const p = hinge_report.player, f = p.runs[0].frames;
      return { frames: f.count, bars: f.bars, width: p.canvas.width, height: p.canvas.height };
    })()`);
    const play = await b.value(played);
    if (!play.whole) throw new Error("the player did not come to the end");
    if (b.problems.length > 0) throw new Error(`the page complains: ${b.problems.join("; ")}`);
    return { open, rate: play.drawn / play.seconds, frames, what: `${bars} elements on ${width} x ${height} pixels` };
  } finally {
    await b.stop();
  }
}

(async () => {
  const [program, report, frames] = process.argv.slice(2), wrong = [], times = [];
  if (!fs.existsSync(program)) throw new Error(`nothing can be measured without Chromium: ${program} is not there`);
  const megabytes = fs.statSync(report).size / 1e6;
  for (let i = 0; i < 3; ++i) {
    times.push(await measured(program, report));
    const { open, rate, what } = times[i];
    console.log(`open after ${open.toFixed(2)} s, ${rate.toFixed(1)} frames a second; ${what}`);
  }
  const open = Math.min(...times.map((t) => t.open)), rate = Math.max(...times.map((t) => t.rate));
  // Written so that what is not a number is beyond its limit.
  if (times[0].frames !== Number(frames ?? 100)) wrong.push(`the run has ${times[0].frames} frames`);
  if (!(megabytes <= most_megabytes)) wrong.push(`it has ${megabytes.toFixed(1)} MB, more than ${most_megabytes}`);
  if (!(open <= most_seconds)) wrong.push(`it opens after ${open.toFixed(2)} s, later than ${most_seconds}`);
  if (!(rate >= least_rate)) wrong.push(`it draws ${rate.toFixed(1)} frames a second, fewer than ${least_rate}`);
  console.log(`note: ${megabytes.toFixed(1)} MB, open after ${open.toFixed(2)} s, ${rate.toFixed(1)} frames a second`);
  for (const what of wrong) console.log(what);
  process.exitCode = wrong.length > 0 ? 1 : 0;
})().catch((error) => {
  console.log(error.message);
  process.exit(1);
});

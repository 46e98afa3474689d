// The page of hinge run --live in a headless Chromium: the newest frame arrives again and again, the player follows it
// unless somebody looks at an earlier one, curves grow, and after the program's end the page says so and keeps what it has.
//
// Run: node tests/viewer/live_test.js CHROMIUM ADDRESS STOP [PICTURE]      ends with a line for each thing that is wrong
// The script served there is that of tests/script/report/live_test.lua; it stops when there is a file STOP.
"use strict";
const fs = require("fs");
const { Browser, checks, drawing } = require("./browser.js");

const { expect, run } = checks();

const frames = "hinge_report.runs[0].frames", last = "hinge_report.player.time";
const banner = "document.querySelector('.live').textContent";

async function while_it_runs(b, picture) {
  await b.until("document.documentElement.dataset.ready === 'yes'");
  await b.until("hinge_report.runs[0]?.number === 2 && hinge_report.player && " + frames + ".count >= 3", 60);
  expect((await b.value(banner)).startsWith("liverun 2"), `the banner says ${await b.value(banner)}`);
  expect(/made at scene\.lua:\d+ · step .* of/.test(await b.value(banner)), `the banner says ${await b.value(banner)}`);
  const first = await b.value(drawing), then = await b.value(last);
  expect(first.drawn > 500, `the canvas is blank: ${first.drawn} pixels are drawn`);
  expect(await b.value(`${last} === ${frames}.times[${frames}.count - 1]`), "the newest frame is not shown");
  await b.until(`${last} > ${then + 0.004}`, 60);
  const second = await b.value(drawing);
  expect(second.hash !== first.hash, "a newer frame looks the same");
  expect((await b.value("document.querySelector('.verdict').textContent")).startsWith("running"), "the verdict is not running");
  const rows = await b.value("hinge_report.runs[0].history.values[0].length");
  const times = "hinge_report.runs[0].history.values[0]";
  expect(rows > 10 && await b.value(`Math.abs(${times}[${times}.length - 1] - ${frames}.times[${frames}.count - 1]) < 1e-6`),
    "the history does not reach to the newest frame");
  const energies = "document.querySelector('svg[aria-label^=energies] path').getAttribute('d')";
  const curve = await b.value(energies);
  await b.until(`${energies} !== ${JSON.stringify(curve)}`, 30);
  if (picture) await b.picture(picture);

  // a curve that is hidden stays so, though the plot is drawn anew
  await b.value("document.querySelector('.plot .legend button').click()");
  const drawn = await b.value("hinge_report.live.drawn");
  await b.until(`hinge_report.live.drawn > ${drawn}`, 30);
  expect(await b.value("document.querySelector('.plot .legend button').getAttribute('aria-pressed')") === "false",
    "a hidden curve is there again");
}

async function looking_back(b) {
  await b.value("hinge_report.player.choose(0, 1), hinge_report.player.seek(hinge_report.player.begin)");
  const now = await b.value(last), states = await b.value("hinge_report.live.states");
  await b.until(`hinge_report.live.states >= ${states + 4}`, 60);
  expect(await b.value(last) === now, "who looks at the first frame is taken away from it");
  expect(await b.value("hinge_report.player.end > hinge_report.player.begin + 0.001"), "the slider does not grow");
  expect((await b.value("document.querySelector('.picked h3').textContent")).startsWith("member 1 "), "no member is picked");
  const newest = "[...document.querySelectorAll('.timeline button')].find((b) => b.textContent === 'newest')";
  expect(await b.value(`${newest}.getAttribute('aria-pressed')`) === "false", "it says that it follows");
  await b.value(`${newest}.click()`);
  await b.until(`${last} > ${now + 0.002} && ${newest}.getAttribute('aria-pressed') === 'true'`, 30);
  const then = await b.value(last);
  await b.until(`${last} > ${then}`, 30);
}

// With room for eight frames: no more, in order, from the first to the newest.
async function with_little_room(b) {
  const first = await b.value(`(${frames}.room = Math.max(8, ${frames}.count), ${frames}.times[0])`);
  const most = await b.value(`${frames}.room`), states = await b.value("hinge_report.live.states");
  await b.until(`hinge_report.live.states >= ${states + 8}`, 60);
  const times = await b.value(`${frames}.times`);
  expect(times.length <= most && times.length >= most / 2, `${times.length} frames in the room of ${most}`);
  expect(times.every((t, i) => i === 0 || t > times[i - 1]), `times of the frames: ${times}`);
  expect(times[0] === first, "the first frame was left out");
  const data = await b.value(`(() => {
    const f = ${frames}, { broken } = { broken: 2 };
    let most_wrong = 0;
    const part = (k, b, c, limit) => (f.forces[(6 * k + c) * f.bars + b] / f.limits[4 * b + limit]) ** 2;
    for (let k = 0; k < f.count; ++k)
      for (let b = 0; b < f.bars; ++b) {
        if ((f.state[k * f.bars + b] & 3) === broken) continue;
        const f_y = part(k, b, 0, 0) + part(k, b, 5, 3) + Math.max(part(k, b, 1, 1) + part(k, b, 3, 2),
          part(k, b, 2, 1) + part(k, b, 4, 2));
        most_wrong = Math.max(most_wrong, Math.abs(f_y - f.f_y[k * f.bars + b] * f.f_y_unit));
      }
    return { most_wrong, count: f.count, loose: f.loose_from.length - 1, at_end: f.loose_from[f.count] - f.loose_from[f.count - 1] };
  })()`);
  expect(data.most_wrong < 2e-3, `f_y differs from what the forces give by ${data.most_wrong}`);
  expect(data.loose === data.count && data.at_end === 2,
    `loose ends: ${data.at_end} in the newest of ${data.count} frames, ${data.loose} counts of them`);
}

async function after_its_end(b, stop) {
  fs.writeFileSync(stop, "");
  await b.until("hinge_report.live.ended", 60);
  const said = await b.value(banner);
  expect(said.startsWith("endedThe program has ended.") && said.includes("hinge report live_one makes one that stays"),
    `after the end the banner says ${said}`);
  expect((await b.value("document.title")).startsWith("ended: "), "the title does not tell of the end");
  expect(await b.value("hinge_report.runs[0].summary.verdict") === "stopped", "the verdict at the end");
  expect((await b.value("document.querySelector('main').textContent")).includes("a result"), "no results of the script");
  const story = await b.value("document.querySelector('.story').textContent");
  for (const what of ["first contact", "first hinge", "breaks at end", "end: stopped"])
    expect(story.includes(what), `what happened does not tell of: ${what}`);
  const newest = await b.value(drawing);
  await b.value("hinge_report.player.seek(hinge_report.player.begin)");
  expect((await b.value(drawing)).hash !== newest.hash, "after the end, the first frame looks like the last");
  expect(await b.value("window.hurt") === undefined, "a name from the model was run as a script");
  expect(await b.value("document.querySelectorAll('main script, main img').length") === 0, "a name has become markup");
}

run(async () => {
  const [program, address, stop, picture] = process.argv.slice(2);
  const b = await Browser.start(program);
  try {
    await b.size(1280, 900);
    await b.open(address);
    for (const part of [() => while_it_runs(b, picture), () => looking_back(b), () => with_little_room(b), () =>
      after_its_end(b, stop)]) await part();
    for (const problem of b.problems) expect(false, `the page complains: ${problem}`);
    const others = b.requests.filter((u) => !u.startsWith(address) && !u.startsWith("data:"));
    expect(others.length === 0, `the page asks for ${others.join(" ")}`);
  } finally {
    fs.writeFileSync(stop, "");
    await b.stop();
  }
});

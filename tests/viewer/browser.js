// A headless Chromium for tests of pages: started here, spoken to over two pipes in the protocol of its developer tools.
"use strict";
const { spawn } = require("child_process");
const fs = require("fs");
const os = require("os");
const path = require("path");

class Browser {
  static async start(program) {
    const b = new Browser();
    b.profile = fs.mkdtempSync(path.join(os.tmpdir(), "hinge-browser-"));
    b.process = spawn(program, ["--headless", "--remote-debugging-pipe", "--no-sandbox", "--disable-gpu",
      "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars", "--no-first-run",
      "--disable-dev-shm-usage", `--user-data-dir=${b.profile}`, "about:blank"],
    { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"], detached: true, env: { ...process.env, HOME: b.profile } });
    b.next = 1, b.answers = new Map(), b.problems = [], b.requests = [], b.rest = "";
    b.process.stdio[4].on("data", (bytes) => b.hear(bytes));
    const { targetInfos } = await b.send("Target.getTargets");
    const page = targetInfos.find((t) => t.type === "page");
    ({ sessionId: b.session } = await b.send("Target.attachToTarget", { targetId: page.targetId, flatten: true }));
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await b.send(`${domain}.enable`);
    return b;
  }

  hear(bytes) {
    this.rest += bytes.toString("utf8");
    for (let end; (end = this.rest.indexOf("\0")) >= 0; this.rest = this.rest.slice(end + 1)) this.take(JSON.parse(
      this.rest.slice(0, end)));
  }
  take(message) {
    if (message.id) {
      const { resolve, reject } = this.answers.get(message.id);
      this.answers.delete(message.id);
      return message.error ? reject(new Error(message.error.message)) : resolve(message.result);
    }
    const p = message.params;
    if (message.method === "Runtime.exceptionThrown")
      this.problems.push(p.exceptionDetails.exception?.description || p.exceptionDetails.text);
    if (message.method === "Runtime.consoleAPICalled" && ["error", "warning"].includes(p.type))
      this.problems.push(p.args.map((a) => a.value || a.description).join(" "));
    if (message.method === "Log.entryAdded" && p.entry.level === "error") this.problems.push(p.entry.text);
    if (message.method === "Network.requestWillBeSent") this.requests.push(p.request.url);
  }
  send(method, params = {}) {
    const id = this.next++;
    const message = { id, method, params };
    if (this.session) message.sessionId = this.session;
    this.process.stdio[3].write(JSON.stringify(message) + "\0");
    return new Promise((resolve, reject) => this.answers.set(id, { resolve, reject }));
  }

  size(width, height, mobile = false) {
    return this.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile });
  }
  async open(file) {
    this.problems.length = this.requests.length = 0;
    await this.send("Page.navigate", { url: /^http:/.test(file) ? file : "file://" + path.resolve(file) });
  }
  /// The value of an expression in the page; promises are waited for.
  async value(expression) {
    const { result, exceptionDetails: wrong } = await this.send("Runtime.evaluate", { expression, awaitPromise: true,
      returnByValue: true });
    if (wrong) throw new Error(`${expression}: ${wrong.exception?.description || wrong.text}`);
    return result.value;
  }
  async until(expression, seconds = 20) {
    for (const end = Date.now() + 1000 * seconds; Date.now() < end;) {
      const value = await this.value(expression).catch(() => false);
      if (value) return value;
      await new Promise((r) => setTimeout(r, 25));
    }
    throw new Error(`not within ${seconds} s: ${expression}`);
  }
  async click(x, y) {
    for (const [type, buttons] of [["mousePressed", 1], ["mouseReleased", 0]])
      await this.send("Input.dispatchMouseEvent", { type, x, y, button: "left", clickCount: 1, buttons });
  }
  async drag(from, to) {
    const mouse = (type, [x, y], buttons) => this.send("Input.dispatchMouseEvent", { type, x, y, button: "left", buttons,
      clickCount: 1 });
    await mouse("mousePressed", from, 1);
    for (let i = 1; i <= 5; ++i) await mouse("mouseMoved", [0, 1].map((c) => from[c] + (to[c] - from[c]) * i / 5), 1);
    await mouse("mouseReleased", to, 0);
  }
  async key(key, text) {
    const code = { " ": "Space" }[key] || key;
    await this.send("Input.dispatchKeyEvent", { type: text ? "keyDown" : "rawKeyDown", key, code, text });
    await this.send("Input.dispatchKeyEvent", { type: "keyUp", key, code });
  }
  async picture(file, whole = false) {
    const { data } = await this.send("Page.captureScreenshot", { format: "png", captureBeyondViewport: whole });
    fs.writeFileSync(file, Buffer.from(data, "base64"));
  }
  async stop() {
    const gone = new Promise((resolve) => this.process.on("exit", resolve));
    this.session = null;
    this.send("Browser.close").catch(() => {});
    await Promise.race([gone, new Promise((r) => setTimeout(r, 1000))]);
    try {
      process.kill(-this.process.pid, "SIGKILL"); // the group that was started here, with what is left of it
    } catch {} // nothing is
    for (const pipe of this.process.stdio) pipe?.destroy();
    fs.rmSync(this.profile, { recursive: true, force: true, maxRetries: 20, retryDelay: 100 });
  }
}

// Numbers that tell one drawing from another: a hash of the canvas, and how many of its pixels are not the background.
const drawing = `(async () => {
  const p = hinge_report.player;
  await new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r)));
  const copy = document.createElement("canvas");
  copy.width = p.canvas.width, copy.height = p.canvas.height;
  const draw = copy.getContext("2d");
  p.redraw();
  await new Promise((r) => requestAnimationFrame(() => { draw.drawImage(p.canvas, 0, 0); r(); }));
  const bytes = draw.getImageData(0, 0, copy.width, copy.height).data;
  let hash = 0, drawn = 0;
  for (let i = 0; i < bytes.length; i += 4) {
    hash = (Math.imul(hash, 31) + bytes[i] + (bytes[i + 1] << 8) + (bytes[i + 2] << 16)) | 0;
    if (bytes[i] !== bytes[0] || bytes[i + 1] !== bytes[1] || bytes[i + 2] !== bytes[2]) ++drawn;
  }
  return { hash, drawn };
})()`;

// Checks of a test: expect(ok, what), and run(main), which ends with a line for each that is wrong.
function checks() {
  const wrong = [];
  let checked = 0;
  function expect(ok, what) {
    ++checked;
    if (!ok) wrong.push(what);
  }
  function run(main) {
    const tell = () => wrong.forEach((what) => console.log(what));
    main().then(() => {
      tell();
      console.log(`${checked} checked, ${wrong.length} wrong`);
      process.exitCode = wrong.length > 0 ? 1 : 0;
    }, (error) => {
      tell();
      console.log(error.stack);
      process.exit(1);
    });
  }
  return { expect, run };
}

module.exports = { Browser, checks, drawing };

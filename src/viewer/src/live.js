// hinge run --live: the page asks the program that serves it for the newest frame, again and again, until that ends.
import { make, number } from "./page.js";
import { list, read_frames } from "./run_data.js";
import { add_frame, make_growing } from "./growing_frames.js";

const between_pages = 1000; // ms between two drawings of what stands below the player
const pause = (ms) => new Promise((r) => setTimeout(r, ms));

const transposed = ({ columns, rows }) => ({ columns, values: columns.map((_, c) => rows.map((row) => row[c] ?? null)) });
const quoted = (text) => (/^[\w./=+,-]+$/.test(text) ? text : `'${text.replace(/'/g, "'\\''")}'`);

/// program: its id; page: what draws the parts of a report.
export async function look_on(program, page) {
  const me = Math.random().toString(36).slice(2), banner = make("div", { class: "live", role: "status" });
  const [top, warned, watch, rest] = [1, 2, 3, 4].map(() => make("div", {}));
  page.report.append(banner, top, warned, watch, rest);
  const shown = { state: null, run: null, player: null, drawn: 0, pressed: false, states: 0, ended: null };
  rest.addEventListener("pointerdown", () => { shown.pressed = true; });
  addEventListener("pointerup", () => { shown.pressed = false; });
  window.hinge_report = { get runs() { return shown.run ? [shown.run] : []; }, get player() { return shown.player; },
    live: shown, ready: true };
  document.documentElement.dataset.ready = "yes";
  tell(banner, "No run has taken a step yet.");

  const ask = (after, run, events) => fetch(`/state?${new URLSearchParams({ program, page: me, after, run, events,
    quiet: document.hidden ? 1 : 0 })}`, { cache: "no-store" });
  for (;;) {
    const state = shown.state = await next_state(ask, shown.known || [-1, 0, 0]);
    if (!state || state.program === "another") return lost(shown, banner, state);
    const events = state.events ? state.events.from + list(state.events.rows).length : 0;
    shown.known = [state.version, state.run ?? 0, events];
    ++shown.states;
    await take(state, shown, { page, top, warned, watch, rest, banner });
    if (state.program === "ended") return;
  }
}

// What the program says next; null where it no longer answers.
async function next_state(ask, known) {
  for (let tried = 0; tried < 5;) {
    try {
      const answer = await ask(...known);
      if (answer.status === 200) return await answer.json();
      if (answer.status !== 204) await pause(1000); // it has too many pages to serve
      tried = 0;
    } catch {
      ++tried;
      await pause(400);
    }
  }
  return null;
}

async function take(state, shown, parts) {
  if (state.frame) await take_frame(state, shown, parts);
  const { run } = shown;
  if (run) {
    run.summary = state.summary;
    if (state.program === "ended" && run.summary.verdict === "running") run.summary.verdict = "stopped";
    if (state.history) run.history = transposed(state.history);
    if (state.events) {
      run.events.columns = state.events.columns, run.events.left_out = state.events_left_out;
      run.events.rows.length = state.events.from;
      for (const row of state.events.rows) run.events.rows.push(row);
    }
    parts.top.replaceChildren(parts.page.heading([run]));
    const warnings = parts.page.warnings([run]);
    if ((warnings?.textContent ?? "") !== parts.warned.textContent) parts.warned.replaceChildren(...[warnings].filter(Boolean));
    document.title = `${state.program === "ended" ? "ended" : "live"}: ${document.title}`;
    draw_rest(shown, parts, state.program === "ended" || run.summary.verdict !== "running");
  }
  if (state.program === "ended") ended(state, shown, parts.banner);
  else if (run) tell(parts.banner, progress(state), share(state));
}

async function take_frame(state, shown, { page, watch }) {
  if (shown.run?.number === state.run) {
    await add_frame(shown.run.frames, state.frame);
    shown.player?.grew();
    return;
  }
  shown.player?.close();
  shown.run = { name: `run ${state.run}`, number: state.run, summary: state.summary,
    events: { columns: [], rows: [], left_out: 0 }, frames: make_growing(await read_frames(state.frame)) };
  const [player, element] = page.make_player([shown.run], true);
  shown.player = player, shown.drawn = 0;
  watch.replaceChildren(element);
  player?.seek(player.end);
}

// The parts below the player. Who holds a curve with the pointer is not disturbed; what has the focus keeps it.
function draw_rest(shown, { page, rest }, at_once) {
  const now = performance.now();
  if (!at_once && (now - shown.drawn < between_pages || shown.pressed)) return;
  shown.drawn = now;
  const able = () => [...rest.querySelectorAll("button, summary, [tabindex]")];
  const focus = able().indexOf(document.activeElement), many = able().length;
  const scrolled = [...rest.querySelectorAll(".story, .wide")].map((e) => [e.scrollTop,
    e.scrollTop > 0 && e.scrollTop + e.clientHeight >= e.scrollHeight - 4]);
  rest.replaceChildren(...page.below([shown.run], shown.player));
  [...rest.querySelectorAll(".story, .wide")].forEach((e, i) => {
    if (scrolled[i]) e.scrollTop = scrolled[i][1] ? e.scrollHeight : scrolled[i][0];
  });
  if (focus >= 0 && able().length === many) able()[focus].focus({ preventScroll: true });
}

function share(state) {
  const { steps } = state.summary;
  return state.planned > 0 ? Math.min(1, steps / state.planned) : 0;
}

function progress(state) {
  const { steps } = state.summary, at = String(state.made_at || "").split("/").pop();
  return [`run ${number(state.run)}${state.runs > state.run ? `, of ${number(state.runs)} so far` : ""}`,
    at ? `made at ${at}` : "", `step ${number(steps)}${state.planned > 0 ? ` of ${number(state.planned)}` : ""}`,
    state.summary.verdict === "running" ? "" : "this run is over, the program goes on"]
    .filter(Boolean).join(" · ");
}

function tell(banner, text, part = null, kind = "live") {
  const label = make("strong", {}, kind), bar = part === null ? null : make("progress", { max: 1, value: part,
    "aria-label": "steps done" });
  banner.className = `live ${kind}`;
  banner.replaceChildren(...[label, make("span", {}, text), bar].filter(Boolean));
}

function ended(state, shown, banner) {
  shown.ended = "ended";
  const how = state.status === 0 ? "" : ` with exit status ${state.status}; it says why where it was started`;
  tell(banner, `The program has ended${how}. This page keeps what it has seen. `
    + (state.folder ? `hinge report ${quoted(state.folder)} makes one that stays.` : ""), null, "ended");
}

function lost(shown, banner, state) {
  shown.ended = state ? "another" : "lost";
  document.title = `ended: ${document.title.replace(/^live: /, "")}`;
  tell(banner, state ? "Another program is served here now: load this page anew to see it." : "The program no longer "
    + "answers: it was ended, or the way to it is cut. This page keeps what it has seen; hinge report, with the folder of "
    + "the run, makes one that stays.", null, "ended");
}

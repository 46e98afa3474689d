// hinge report: the page about one run or several.
import style from "./page.css";
import { abscissa, make, number, table, card, bar, quantity } from "./page.js";
import { plot } from "./plot.js";
import { accuracy_card } from "./accuracy.js";
import { broken_in, frame_at, largest_displacement, list, member_state, read_frames } from "./run_data.js";
import { look_on } from "./live.js";
import { hinges_card } from "./hinges.js";
import { story_of } from "./story.js";
import { member_panel } from "./member.js";
import { Player } from "./player.js";

const report = document.getElementById("report");
const cursors = []; // called with the time shown

function text_of(value) {
  if (typeof value === "number") return value;
  if (value === null || value === undefined) return "–";
  return typeof value === "object" ? JSON.stringify(value) : String(value);
}

// { a: { b: 1 } } as [["a.b", 1]]; a table of a few dozen lines at most
function flat(value, before = "", out = []) {
  for (const [k, v] of Object.entries(value || {})) {
    const name = before ? `${before}.${k}` : k;
    if (v && typeof v === "object" && !Array.isArray(v)) flat(v, name, out); else out.push([name, v]);
  }
  return out;
}

// A row for each name that any run has, a column for each run.
function side_by_side(runs, pairs_of, title, hint) {
  const maps = runs.map((r) => new Map(pairs_of(r))), names = [...new Set(maps.flatMap((m) => [...m.keys()]))];
  if (names.length === 0) return null;
  const rows = names.map((n) => [n, ...maps.map((m) => text_of(m.has(n) ? m.get(n) : null))]);
  const made = table(runs.length > 1 ? ["", ...runs.map((r) => r.name)] : null, rows);
  if (runs.length > 1) [...made.querySelectorAll("tbody tr")].forEach((tr, i) => {
    if (new Set(rows[i].slice(1).map(String)).size > 1) tr.classList.add("differs");
  });
  return card(title, made, hint ? make("p", { class: "hint" }, hint) : null);
}

const each = (runs, title, content) => {
  const parts = runs.map((r) => [r, content(r)]).filter(([, c]) => c);
  if (parts.length === 0) return null;
  const least = parts.length % 3 === 0 ? 320 : 480;
  const style = `grid-template-columns: repeat(auto-fit, minmax(min(100%, ${least}px), 1fr))`;
  return card(title, make("div", { class: "columns", style }, parts.map(([r, c]) => make("div", {}, runs.length > 1 ?
    make("h3", {}, r.name) : null, c))));
};

function heading(runs) {
  const first = runs[0].summary || {}, script = first.script ? String(first.script).split("/").pop() : "";
  const title = runs.length > 1 ? `${script || "runs"}: ${runs.map((r) => r.summary?.case || r.name).join(", ")}` :
    [script || runs[0].name, first.case ? `case ${first.case}` : ""].filter(Boolean).join(", ");
  document.title = `${title} – hinge report`;
  return make("header", {}, make("h1", {}, title), make("div", { class: "verdicts" }, runs.map((r) => {
    const s = r.summary;
    if (!s) return make("p", { class: "verdict" }, `${r.name}: no summary.json, frames alone`);
    if (s.verdict === "unfinished") return make("p", { class: "verdict stopped" }, make("strong", {}, "unfinished"),
      ` · ${runs.length > 1 ? `${r.name}: ` : ""}there is no summary.json, so the program still runs or was ended from `
      + "outside; this is what it has written");
    const where = s.kind === "static" ? `load factor ${number(s.factor)}` : `t = ${number(s.time)} s`;
    const warned = warnings_of(r).length, known = ["completed", "failed", "stopped"].includes(s.verdict);
    return make("p", { class: `verdict ${known ? s.verdict : ""}${warned ? " warned" : ""}` },
      make("strong", {}, runs.length > 1 ? `${r.name}: ${s.verdict}` : s.verdict),
      warned ? ` · ${warned} ${warned === 1 ? "warning" : "warnings"}` : "",
      s.reason ? ` · ${s.reason}` : "", s.steps === undefined ? "" : ` · ${number(s.steps)} steps to ${where} in `
        + `${number(s.wall_seconds, 3)} s · largest energy error ${number(100 * Number(s.energy_error), 2)} %`);
  })));
}

function energies(runs, seek) {
  return each(runs, "Energy balance", (r) => {
    const h = r.history;
    if (!h) return null;
    const is_error = (c) => c === "energy_error" || c === "remainder"; // remainder: its name in files of version 0.2
    const columns = list(h.columns), end = columns.findIndex(is_error);
    if (end < 0) return null;
    const statics = r.summary?.kind === "static", x = list(h.values)[statics ? 1 : 0];
    const series = columns.slice(2, end + 1).map((c, i) => ({ name: is_error(c) ? "energy error" : c.replace(/_/g, " "),
      x, y: list(h.values)[i + 2].map((v) => v ?? NaN), dash: is_error(c) })).filter((s) => s.y.some((v) => v));
    const figure = plot({ label: "energies over time", x_label: statics ? "load factor" : "time, s", unit: "J", series, seek,
      height: 300 });
    cursors.push(figure.cursor);
    const probes = columns.slice(end + 1).map((c, i) => ({ name: c, x, y: list(h.values)[end + 1 + i].map((v) => v ?? NaN) }));
    return make("div", {}, figure, ...probe_plots(r, probes, statics, seek));
  });
}

const kinds = { m: "displacement", rad: "rotation", "m/s": "velocity", "rad/s": "angular velocity", "m/s^2": "acceleration",
  "rad/s^2": "angular acceleration", N: "reaction", "N m": "moment" };

// Probes of one unit in one plot; those of an older run, which says no units, in one without.
function probe_plots(r, probes, statics, seek) {
  const info = list(r.probes ?? r.summary?.probes), unit_of = new Map(info.map((p) => [p.name, p.unit]));
  const groups = new Map();
  for (const p of probes) {
    const unit = kinds[unit_of.get(p.name)] ? unit_of.get(p.name) : "";
    groups.set(unit, [...(groups.get(unit) ?? []), p]);
  }
  return [...groups].flatMap(([unit, series]) => {
    const drawn = plot({ label: `probes over time${unit ? `, ${kinds[unit]}` : ""}`, x_label: statics ? "load factor" :
      "time, s", unit: unit.replace("^2", "²"), series, seek });
    cursors.push(drawn.cursor);
    return [make("h3", {}, unit ? `Probes: ${kinds[unit]}` : "Probes"), drawn];
  });
}

const damage_columns = ["members", "elastic", "yielded", "broken", "has been in contact"];

// Of the frame shown; without frames, as the summary has it. rows_of(run, frame): [name, then the numbers of
// damage_columns], or null.
function damage(runs, title, rows_of) {
  const frame = (r, time) => (r.frames ? frame_at(r.frames, time) : -1), one = runs.length === 1;
  const holder = make("div", {});
  let shown = "";
  const show = (time) => {
    const at = runs.map((r) => frame(r, time)), now = at.join();
    if (now === shown) return;
    shown = now;
    const all = runs.map((r, i) => rows_of(r, at[i]) || []), names = [...new Set(all.flatMap((rows) => rows.map((r) => r[0])))];
    if (one) return holder.replaceChildren(table(["", ...damage_columns], all[0]));
    const of = all.map((rows) => new Map(rows.map((r) => [r[0], r])));
    holder.replaceChildren(table(["", "members", ...runs.map((r) => r.name)], names.map((n) => [n,
      of.find((m) => m.has(n)).get(n)[1], ...of.map((m) => (m.has(n) ? m.get(n).slice(3).join(" / ") : "–"))])));
  };
  if (!runs.some((r) => rows_of(r, r.frames ? 0 : -1))) return null;
  show(Infinity);
  cursors.push(show);
  return card(title, holder, one ? null : make("p", { class: "hint" }, "yielded / broken / has been in contact"));
}

function counted(frames, frame, members) {
  const n = [members.length, 0, 0, 0, 0];
  for (const m of members) {
    const { worst, touched } = member_state(frames, frame, m);
    ++n[1 + worst], n[4] += touched;
  }
  return n;
}

function group_rows(r, frame) {
  if (r.frames) return r.frames.groups.map((g, i) => [g, ...counted(r.frames, frame,
    [...r.frames.members.values()].filter((m) => m.groups.includes(i)))]);
  const rows = list(r.summary?.damage).map((d) => [d.group, d.members, d.elastic, d.yielded, d.broken, d.touched]);
  return rows.length ? rows : null;
}

function storey_rows(r, frame) {
  if (!r.frames || r.frames.floors.length < 2) return null;
  return r.frames.floors.map((z, k) => [`storey ${k + 1}`, ...counted(r.frames, frame,
    [...r.frames.members.values()].filter((m) => m.storey === k))]).reverse();
}

const hidden_kinds = new Set(); // of what happened

function story(runs, player) {
  return each(runs, "What happened, in order", (r) => {
    const slack = player ? 1e-9 * Math.abs(player.end) : 0;
    const statics = r.summary ? r.summary.kind === "static" : Boolean(r.frames?.factors);
    const entries = story_of(r), i = player ? player.views.findIndex((v) => v.run === r) : -1;
    const lines = entries.map((e) => {
      const line = make("li", { class: e.kind }, make("button", { type: "button", class: "at", onclick: () => {
        player?.play(false), player?.seek(e.at);
        if (e.member && i >= 0) player.choose(i, e.member);
      } }, abscissa(e.at, statics)), make("span", {}, e.text));
      return [e.at, line];
    });
    let past = 0; // lines before the time shown
    if (player) cursors.push((time) => {
      while (past < lines.length && lines[past][0] <= time + slack) lines[past++][1].classList.add("past");
      while (past > 0 && lines[past - 1][0] > time + slack) lines[--past][1].classList.remove("past");
    });
    const kinds = [...new Set(entries.map((e) => e.kind))], box = make("ol", { class: "story" }, lines.map(([, li]) => li));
    const filter = kinds.length > 2 ? make("div", { class: "legend" }, kinds.map((k) => make("button", { type: "button",
      "aria-pressed": String(!hidden_kinds.has(k)), onclick: (event) => {
        const on = event.currentTarget.getAttribute("aria-pressed") !== "true";
        event.currentTarget.setAttribute("aria-pressed", on);
        if (on) hidden_kinds.delete(k); else hidden_kinds.add(k);
        for (const li of box.querySelectorAll(`li.${k}`)) li.hidden = !on;
      } }, `${k} (${entries.filter((e) => e.kind === k).length})`))) : null;
    for (const k of hidden_kinds) for (const li of box.querySelectorAll(`li.${k}`)) li.hidden = true;
    const more = r.events?.left_out ? make("p", { class: "hint" }, `${number(r.events.left_out)} further lines of events.csv `
      + "are not in this page") : null;
    const frames_note = [r.frames?.not_shown ? `${r.frames.not_shown} frames are not in this page` : "",
      r.frames?.of_other_models ? `${r.frames.of_other_models} frames are of another model, and left out` : ""]
      .filter(Boolean).join("; ");
    const damaged = list(r.damaged).length ? make("p", { class: "hint" }, damaged_text(list(r.damaged))) : null;
    return make("div", {}, filter, box, more, frames_note ? make("p", { class: "hint" }, frames_note) : null, damaged);
  });
}

function damaged_text(damaged) {
  const names = damaged.slice(0, 8).map((d) => String(d.file).split("/").pop()), more = damaged.length - names.length;
  return `${damaged.length === 1 ? "A frame" : `${damaged.length} frames`} could not be read and ${damaged.length === 1 ?
    "is" : "are"} not in this page: ${names.join(", ")}${more > 0 ? ` and ${more} more` : ""}`;
}

const share = (seconds, all) => bar(seconds / all, `${number(seconds, 3)} s`);

// The effects of the first run that knows each, with the seconds in all of them.
function effects(runs) {
  const lists = runs.map((r) => list(r.summary?.effects)), most = Math.max(1e-9, ...lists.flat().map((e) => e.seconds));
  const all = new Map(lists.flat().reverse().map((e) => [e.name, e])), names = [...new Set(lists.flat().map((e) => e.name))];
  if (names.length === 0) return null;
  const cost = (e) => (e?.active ? share(e.seconds, most) : "not simulated");
  const rows = names.map((n) => [n, all.get(n).because, String(all.get(n).asked_at || "").split("/").pop(),
    ...lists.map((l) => cost(l.find((e) => e.name === n)))]);
  return card("Effects: what was simulated, why, and what it cost", table(["effect", "because", "asked for at",
    ...(runs.length > 1 ? runs.map((r) => r.name) : ["time"])], rows));
}

function stages(runs) {
  const lists = runs.map((r) => list(r.summary?.stages)), names = [...new Set(lists.flat().map((s) => s.name))];
  if (names.length === 0) return null;
  const most = Math.max(1e-9, ...lists.flat().map((s) => s.seconds));
  return card("Seconds by stage of the step", table(runs.length > 1 ? ["stage", ...runs.map((r) => r.name)] : null,
    names.map((n) => [n, ...lists.map((l) => share(l.find((s) => s.name === n)?.seconds ?? 0, most))])));
}

// What a reader of the results has to know first. Notes are for information alone.
const warnings_of = (r) => [...list(r.summary?.warnings), ...list(r.summary?.failed_runs)];

const at_once = 5; // lines

/// A card above the player, or null where no run has a warning.
function warnings(runs) {
  if (!runs.some((r) => warnings_of(r).length)) return null;
  const made = each(runs, "Warnings", (r) => {
    const lines = warnings_of(r).map((w) => make("li", {}, text_of(w))), more = lines.length - at_once;
    if (lines.length === 0) return runs.length > 1 ? make("p", { class: "hint" }, "none") : null;
    return make("div", {}, make("ul", { class: "warnings" }, lines.slice(0, at_once)), more > 0 ? make("details", {},
      make("summary", {}, `${more} more`), make("ul", { class: "warnings" }, lines.slice(at_once))) : null);
  });
  made.classList.add("warned");
  return made;
}

function notes(runs) {
  return each(runs, "Notes", (r) => (list(r.summary?.notes).length ? make("ul", { class: "warnings" },
    list(r.summary.notes).map((w) => make("li", {}, text_of(w)))) : null));
}

function model_numbers(r) {
  const s = r.summary || {}, m = { ...s.model };
  delete m.automatic_elements;
  delete m.mass;
  const extra = { "kind of run": s.kind, steps: s.steps, "wall time, s": s.wall_seconds, "version of hinge": s.hinge };
  if (s.model?.mass > 0) extra["total mass"] = `${number(s.model.mass)}\u202fkg`;
  const far = r.frames && largest_displacement(r.frames);
  if (far) extra[`largest displacement in the last frame${far.all ? "" : ", of what stands on supports"}`]
    = `${quantity(far.value, "m")}: ${far.where}`;
  if (s.fastest_node) extra["fastest node"] = `${s.fastest_node.node}: ${quantity(s.fastest_node.speed, "m/s")}`;
  return [...Object.entries(m).map(([k, v]) => [k.replace(/_/g, " "), v]), ...Object.entries(extra)].filter(([, v]) =>
    v !== undefined);
}

function member_card(runs, player) {
  let holder = null;
  const panel = make("div", { class: "member" }), input = make("input", { type: "number", min: 1, step: 1,
    "aria-label": "number of a member", onchange: (e) => player.choose(player.chosen.run, Number(e.target.value) || 0) });
  let shown = null;
  const show = () => {
    const run = player.views[player.chosen.run].run;
    shown = member_panel(run, player.chosen.member, (t) => { player.play(false), player.seek(t); },
      (number_of) => player.choose(player.chosen.run, number_of));
    if (document.activeElement !== input) input.value = player.chosen.member || "";
    panel.replaceChildren(...shown.parts);
    shown.cursor(player.time);
    holder?.setAttribute("aria-live", player.chosen.member ? "polite" : "off"); // the list changes with each frame
  };
  const head = make("div", { class: "row" }, make("label", {}, "member", input), runs.length > 1 ? make("label", {}, "of",
    make("select", { "aria-label": "run", onchange: (e) => player.choose(Number(e.target.value), player.chosen.member) },
      player.views.map((v, i) => make("option", { value: i }, v.run.name)))) : null);
  holder = make("section", { class: "card picked", "aria-live": "off" }, head, panel);
  let drawn = 0; // ms
  const grew = () => { // frames were added: not under the pointer, and once a second at most
    const now = performance.now();
    if (!player.playing && !panel.matches(":active") && now - drawn > 1000) drawn = now, show();
  };
  return { card: holder, show, grew,
    cursor: (t) => shown?.cursor(t) };
}

function make_player(runs, grows = false) {
  const with_frames = runs.filter((r) => r.frames);
  const lost = runs.flatMap((r) => list(r.damaged));
  if (with_frames.length === 0) return [null, card("The structure", make("p", {}, lost.length ? damaged_text(lost) :
    "No frames were written, so there is nothing to look at in 3D. A script asks for them with job:frame(run) or "
    + "hinge.frame(run)."))];
  let member = null;
  const changed = (p, what) => {
    p.show_time?.();
    if (what === "time") for (const c of cursors) c(p.time);
    if (what === "options") p.show_options();
    if (what === "member") member?.show();
    if (what === "time") member?.cursor(p.time);
    if (what === "frames") member?.grew();
  };
  try {
    const player = new Player(with_frames, changed, grows);
    member = member_card(with_frames, player);
    member.show();
    return [player, make("div", { class: "watch" }, player.element, member.card)];
  } catch (error) {
    return [null, card("The structure", make("p", {}, `It cannot be drawn in 3D here: ${error.message}.`))];
  }
}

// All that stands below the player, anew.
function below(runs, player) {
  cursors.length = 0;
  const seek = player ? (t) => { player.play(false), player.seek(t); } : undefined;
  const pair = (...cards) => (runs.length > 1 ? cards : [make("div", { class: "pair" }, ...cards)]);
  const pick = (r) => {
    const i = player ? player.views.findIndex((v) => v.run === r) : -1;
    return i < 0 ? null : (member) => player.choose(i, member);
  };
  const parts = [accuracy_card(runs, pick), ...pair(story(runs, player), energies(runs, seek)),
    make("div", { class: "pair" }, ...[damage(runs, "Damage by group", group_rows),
      damage(runs, "Damage by storey", storey_rows)].filter(Boolean)),
    hinges_card(runs, pick),
    make("div", { class: "pair" }, ...[side_by_side(runs, (r) => flat(r.summary?.parameters), "Parameters",
      runs.length > 1 ? "lines in bold differ" : null), side_by_side(runs, model_numbers, "The model and the run"),
    side_by_side(runs, (r) => flat(r.summary?.results).slice(0, 60), "Results, as the script returned them")].filter(Boolean)),
    ...pair(effects(runs), stages(runs)), notes(runs),
    make("footer", {}, "Keys in the picture: arrows rotate, + and − zoom, space plays, comma and full stop step by a frame, "
      + "[ and ] pick the member before or after, f follows it, r looks from the corner, Escape picks none. "
      + "Drawn with three.js, © three.js authors, MIT licence.")].filter(Boolean);
  if (player) for (const c of cursors) c(player.time);
  return parts;
}

// A run without a summary: whose it is, and what else its files tell.
function unfinished(r) {
  const statics = list(r.events?.columns)[0] === "factor" || (list(r.history?.values)[0] || []).every((t) => !t);
  return { ...r.owner, verdict: "unfinished", kind: statics ? "static" : "dynamic" };
}

async function main() {
  document.head.append(make("style", {}, style));
  const data = JSON.parse(document.getElementById("data").textContent);
  if (data.live) return look_on(data.live, { report, heading, warnings, below, make_player });
  const runs = await Promise.all(list(data.runs).map(async (r) => ({ ...r, summary: r.summary || (r.history ?
    unfinished(r) : null), frames: await read_frames(r.frames) })));
  for (const r of runs) if (r.frames) r.frames.broken_in = broken_in(r.summary, r.frames);
  const [player, watch] = make_player(runs);
  report.append(...[heading(runs), warnings(runs), watch, ...below(runs, player)].filter(Boolean));
  if (player) player.seek(player.end);
  window.hinge_report = { runs, player, story: story_of, ready: true };
  document.documentElement.dataset.ready = "yes";
}

main().catch((error) => {
  report.append(make("p", { class: "verdict failed" }, `This page cannot be shown: ${error.message}`));
  document.documentElement.dataset.ready = "failed";
  throw error;
});

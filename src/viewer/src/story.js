// What happened, in order: first contact and first hinges, breaks with their causes, storeys reached, loads that went
// elsewhere, floors that came down, what fell asleep or woke, and the end.
import { abscissa, number, quantity } from "./page.js";
import { list, force, state, state_of, broken } from "./run_data.js";

/// Rows of events.csv as { at, event, element, member, end, group, limit, strain, of, rule, joint }.
export function rows_of(events) {
  if (!events) return [];
  const columns = list(events.columns);
  return list(events.rows).map((row) => {
    const r = Object.fromEntries(columns.map((name, i) => [name, row[i] ?? ""]));
    return { at: Number(r.time ?? r.factor), event: r.event, element: Number(r.element), member: Number(r.member),
      end: Number(r.end) || 0, group: r.group || "", limit: r.limit || "", strain: Number(r.strain), of: Number(r.of),
      rule: r.rule || "", joint: r.joint || "" };
  });
}

const limits = { curvature_x: ["curvature about x", "1/m"], curvature_y: ["curvature about y", "1/m"],
  axial_strain: ["axial strain", ""], shear_strain: ["shear strain", ""],
  hinge_rotation_x: ["rotation of the hinge about x", "rad"],
  hinge_rotation_y: ["rotation of the hinge about y", "rad"], elongation: ["elongation of the member", "m"] };

function cause(row) {
  if (row.limit === "removed") return `removed by the script${row.rule ? ` (model:remove at ${row.rule})` : ""}`;
  const where = row.rule ? ` (fracture rule of ${row.rule})` : "";
  if (!limits[row.limit]) return `the script's own rule says so${where}`;
  const [name, unit] = limits[row.limit], with_unit = unit ? ` ${unit}` : "";
  return `${name} ${number(row.strain, 3)} has reached its limit ${number(row.of, 3)}${with_unit}${where}`;
}

// A quantity of a joint or a connector, as "rotation about x" or "tension", and a value of it with its unit.
function quantity_of_joint(row) {
  const [what, axis] = row.limit.split("_");
  return axis ? `${what} ${what === "force" ? "along" : "about"} ${axis}` : what;
}
function value_of_joint(row, value) {
  if (row.limit.startsWith("rotation")) return `${number(value, 3)} rad`;
  return quantity(value, row.limit.startsWith("moment") ? "N m" : "N", 3);
}
const is_limit = (row) => ["joint_limit", "joint_break", "connector_break"].includes(row.event);

function namer(frames) {
  return (row) => {
    const storey = frames?.members.get(row.member)?.storey ?? -1;
    const about = [row.group, storey >= 0 ? `storey ${storey + 1}` : ""].filter(Boolean).join(", ");
    return `member ${row.member}${about ? ` (${about})` : ""}`;
  };
}

// Members of a list of rows by group: "2 of wings, 1 of columns".
function by_group(rows) {
  const count = new Map();
  for (const m of new Map(rows.map((r) => [r.member, r])).values()) count.set(m.group, (count.get(m.group) || 0) + 1);
  return [...count].map(([g, n]) => `${n} of ${g || "no group"}`).join(", ");
}

function first_contact(rows, name) {
  const met = rows.filter((r) => r.event === "contact");
  if (met.length === 0) return [];
  const first = met.filter((r) => r.at === met[0].at), rest = [...new Map(first.map((r) => [r.member, r])).values()];
  return [{ at: first[0].at, kind: "contact", member: first[0].member, text:
    `first contact: ${rest.slice(0, 4).map(name).join(" and ")}${rest.length > 4 ? ` and ${rest.length - 4} more` : ""}` }];
}

// The first hinge of all, the first of what stands on supports, and of each storey the first hinge and break.
function firsts(rows, frames, name) {
  const out = [], seen = new Set();
  const once = (key, row, kind, text) => {
    if (seen.has(key)) return;
    seen.add(key);
    out.push({ at: row.at, kind, member: row.member, text });
  };
  for (const row of rows) {
    const what = row.event === "yield" ? "hinge" : row.event === "fracture" ? "break" : "contact";
    const storey = frames?.members.get(row.member)?.storey ?? -1;
    if (row.event === "yield") once("hinge", row, "hinge", `first hinge: ${name(row)}${row.end ? `, end ${row.end}` : ""}`);
    if (row.joint) {
      if (row.event === "joint_yield") once("joint", row, "hinge", `first joint yields: ${row.joint}, at a ${quantity_of_joint(row)}, ${value_of_joint(row, row.of)}`);
      continue;
    }
    if (storey >= 0 && frames.floors.length > 1) {
      const before = out.length;
      once(`${what} ${storey}`, row, "storey", `storey ${storey + 1}: first ${what}, ${name(row)}`);
      if (out.length > before && what !== "break" && !seen.has(`reached ${storey}`))
        seen.add(`reached ${storey}`), out[out.length - 1].text = `storey ${storey + 1} is reached: first ${what}, ${name(row)}`;
    }
  }
  return out;
}

const breaks = (rows, name) => rows.filter((r) => r.event === "fracture").map((row) => ({ at: row.at, kind: "break",
  member: row.member, text: `${name(row)} breaks${row.end ? ` at end ${row.end} of element ${row.element}` : ""}: ${cause(row)}` }));

// Joints that reach a limit of their own, and joints and connectors that break by it.
const joint_limits = (rows) => rows.filter(is_limit).map((row) => ({ at: row.at, kind: "break", member: row.member,
  text: `${row.joint} ${row.event === "joint_limit" ? "is beyond its capacity" : "breaks"}: ${quantity_of_joint(row)}, `
    + `${value_of_joint(row, row.strain)}, has reached its limit, ${value_of_joint(row, row.of)}` }));

// Columns that break under compression: which other column of the storey has taken up most since the frame before.
function load_paths(rows, frames) {
  if (!frames) return [];
  const out = [], columns = [...frames.members.values()].filter((m) => m.storey >= 0 && upright(frames, m));
  const carried = (frame, m) => Math.min(...m.bars.map((b) => (state_of(state(frames, frame, b)) === broken ? 0 :
    force(frames, frame, b, 0))));
  const x = frames.abscissa, told = new Set();
  for (const row of rows) {
    if (row.event !== "fracture") continue;
    const lost = frames.members.get(row.member);
    const after = x.findIndex((t) => t >= row.at);
    if (!lost || after < 1 || !columns.includes(lost) || told.has(lost)) continue;
    told.add(lost);
    const before = carried(after - 1, lost);
    if (before >= 0) continue;
    let most = 0, taker = null;
    for (const m of columns) {
      if (m === lost || m.storey !== lost.storey) continue;
      const more = carried(after - 1, m) - carried(after, m);
      if (more > most) most = more, taker = m;
    }
    if (taker && most > 0.05 * -before)
      out.push({ at: x[after], kind: "load", member: taker.number, text: `load finds another way: member ${lost.number}, a `
        + `column of storey ${lost.storey + 1}, carried ${quantity(-before, "N", 3)} of compression in the frame before it broke. `
        + `Of the storey's other columns, member ${taker.number} takes up most: its compression grows from `
        + `${quantity(Math.max(0, -carried(after - 1, taker)), "N", 3)} at ${abscissa(x[after - 1], frames.factors)} to `
        + `${quantity(-carried(after, taker), "N", 3)} at ${abscissa(x[after], frames.factors)}` });
  }
  return out;
}

export function upright(frames, member) {
  const node = (b, side) => frames.ends[2 * b + side], z = [], d = frames.declared;
  for (const b of member.bars)
    for (const side of [0, 1]) if (node(b, side) !== 0xffffffff) z.push(d.subarray(3 * node(b, side), 3 * node(b, side) + 3));
  const span = (c) => Math.max(...z.map((p) => p[c])) - Math.min(...z.map((p) => p[c]));
  return z.length > 1 && span(2) > 4 * Math.hypot(span(0), span(1));
}

// A floor has come down when half of its nodes are lower than where the floor beneath it was half way.
function collapses(frames) {
  if (!frames || frames.floors.length === 0) return [];
  const out = [], { floors, declared, positions, nodes } = frames;
  floors.forEach((z, k) => {
    const of = [], height = z - (k > 0 ? floors[k - 1] : frames.base);
    const there = new Set();
    for (let b = 0; b < frames.bars; ++b)
      if (frames.attached[b]) for (const side of [0, 1]) there.add(frames.ends[2 * b + side]);
    for (const i of there) if (i !== 0xffffffff && Math.abs(declared[3 * i + 2] - z) < 0.05) of.push(i);
    for (let f = 0; f < frames.count && of.length > 0; ++f) {
      const down = of.filter((i) => declared[3 * i + 2] - positions[3 * (nodes * f + i) + 2] > height / 2).length;
      if (2 * down <= of.length) continue;
      out.push({ at: frames.abscissa[f], kind: "collapse", member: 0,
        text: `collapse: half of the floor above storey ${k + 1} has come down by more than ${number(height / 2, 2)} m` });
      break;
    }
  });
  return out;
}

// Effects that woke or went to sleep: the first of each kind, and the last time that bodies came to rest.
function wakings(summary) {
  const out = [], count = new Map(), all = list(summary?.state_changes ?? summary?.wakings);
  for (const w of all) {
    const key = `${w.effect} ${w.awake}`, n = count.get(key) || 0;
    count.set(key, n + 1);
    const rest = w.effect === "rest";
    if (n > 0 && !rest) continue;
    out.push({ at: w.time, kind: rest ? "rest" : "effect", member: 0,
      text: rest ? `${w.awake ? "moves again" : "at rest"}: ${w.why}` : `${w.effect} ${w.awake ? "awake" : "asleep"}: ${w.why}` });
  }
  return out;
}

/// All entries in order: { at, kind, text, member }.
export function story_of(run) {
  const { frames, summary } = run, rows = rows_of(run.events), name = namer(frames);
  const entries = [...first_contact(rows, name), ...firsts(rows, frames, name), ...breaks(rows, name),
    ...joint_limits(rows), ...load_paths(rows, frames), ...collapses(frames), ...wakings(summary)].filter((e) => Number.isFinite(e.at));
  const i = summary?.instability;
  if (i && typeof i.factor === "number") entries.push({ at: i.factor, kind: "collapse", member: list(i.members)[0] || 0,
    text: `unstable: no more than this load factor is carried${i.node ? `; ${i.node} gives way` : ""}` });
  const met = rows.filter((r) => r.event === "contact"), bent = rows.filter((r) => r.event === "yield");
  const joints = new Set(rows.filter((r) => r.event === "joint_yield").map((r) => r.joint)).size;
  entries.sort((a, b) => a.at - b.at);
  if (summary && !["running", "unfinished"].includes(summary.verdict)) {
    const counts = [met.length ? `have been in contact: ${by_group(met)}` : "", bent.length ? `have yielded: ${by_group(bent)}` : "",
      joints ? `${joints === 1 ? "1 joint has" : `${number(joints)} joints have`} yielded` : ""]
      .filter(Boolean).join("; ");
    entries.push({ at: summary.kind === "static" ? summary.factor : summary.time, kind: "end", member: 0,
      text: `end: ${summary.verdict}${summary.reason ? `, ${summary.reason}` : ""}${counts ? ` (${counts})` : ""}` });
  }
  return entries;
}

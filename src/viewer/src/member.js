// The member picked: what it is, and its history against the yield surface.
import { make, number, quantity } from "./page.js";
import { plot, surface_plot } from "./plot.js";
import { along, f_y, force, frame_at, law_text, member_state, state, state_of, broken } from "./run_data.js";

const states = ["elastic", "yielded", "broken"];

function history(frames, of) {
  return Array.from({ length: frames.count }, (_, f) => of(f));
}

/// The element of the member with the largest f_y in any frame: its history is shown.
function weakest(frames, member) {
  let bar = member.bars[0], most = -1;
  for (const b of member.bars)
    for (let f = 0; f < frames.count; ++f) if (f_y(frames, f, b) > most) most = f_y(frames, f, b), bar = b;
  return bar;
}

// Between two frames more may happen than the curves have.
function sampling(frames) {
  const x = frames.abscissa, apart = x.length > 1 ? Math.abs(x[x.length - 1] - x[0]) / (x.length - 1) : 0;
  const every = apart === 0 ? "" : frames.factors ? `, ${number(apart, 2)} of the load factor apart on average` :
    `, ${quantity(apart, "s", 2)} apart on average`;
  return `The curves have a value at each of the ${number(x.length)} frames${every}. What comes and goes between two frames `
    + "is not in them: a member that has yielded need not reach f_y = 1 here.";
}

const most_listed = 12;

// Of all members at the time shown: how many are damaged, and which are strained most.
function overview(run, choose) {
  const { frames } = run, all = [...frames.members.values()], facts = make("p", {}), rows = make("tbody", {});
  let shown = -1;
  const list = (f) => {
    const count = [0, 0, 0];
    let met = 0;
    const strained = [];
    for (const m of all) {
      const { worst, touched } = member_state(frames, f, m);
      ++count[worst], met += touched;
      let most = 0;
      for (const b of m.bars) if (state_of(state(frames, f, b)) !== broken) most = Math.max(most, f_y(frames, f, b));
      if (worst < 2 && most > 0) strained.push([most, m, worst]);
    }
    strained.sort((a, b) => b[0] - a[0] || a[1].number - b[1].number);
    facts.textContent = `${all.length} members: ${count.map((n, i) => `${n} ${states[i]}`).join(", ")}${met ?
      `; ${met} have been in contact` : ""}`;
    rows.replaceChildren(...strained.slice(0, most_listed).map(([most, m, worst]) => make("tr", {}, make("th", { scope: "row" },
      make("button", { type: "button", class: "member-link", onclick: () => choose(m.number) }, `member ${m.number}`)),
    make("td", {}, m.groups.map((g) => frames.groups[g]).join(", ")), make("td", { class: "word" }, states[worst]),
    make("td", { class: "number" }, number(most, 3)))));
  };
  return {
    parts: [make("h3", {}, "The members at the time shown"), facts, make("p", { class: "hint" }, "Those with the largest f_y "
      + `(${law_text(frames.laws)}; 1: fully plastic), without broken ones. Pick one here or in the picture, or give its number.`),
    make("div", { class: "wide" }, make("table", {}, make("thead", {}, make("tr", {}, ["", "group", "", "f_y"].map((t) =>
      make("th", { scope: "col" }, t)))), rows))],
    cursor(time) {
      const f = frame_at(frames, time);
      if (f !== shown) shown = f, list(f);
    },
  };
}

/// Elements to put into the panel, and a function that moves their cursors to a time. choose(number) picks a member.
export function member_panel(run, number_of, seek, choose) {
  const { frames } = run, member = frames.members.get(number_of);
  if (!member) return overview(run, choose);
  const bar = weakest(frames, member), x = frames.abscissa, x_label = frames.factors ? "load factor" : "time, s";
  const gone = (f) => state_of(state(frames, f, bar)) === broken;
  const of = (c) => history(frames, (f) => (gone(f) ? NaN : force(frames, f, bar, c)));
  const limit = (c) => frames.limits[4 * bar + c];
  const facts = make("p", {}), all = frames.broken_in;
  const counted = all ? make("p", {}, `broken in ${all.count.get(member.number) ?? 0} of ${all.runs} runs`) : null;
  const plots = [
    plot({ label: "yield function over time", x_label, series: [{ name: "f_y", x, y: history(frames, (f) => (gone(f) ? NaN :
      f_y(frames, f, bar))) }], lines: [1], width: 350, height: 170, seek, least_zero: true, holds: true }),
    plot({ label: "axial force over time", x_label, unit: "N", series: [{ name: "N, tension positive", x, y: of(0) }],
      lines: limit(0) ? [limit(0), -limit(0)].filter((v) => Math.abs(v) < 3 * Math.max(...of(0).filter(Number.isFinite)
        .map(Math.abs), 1)) : [], width: 350, height: 170, seek, least_zero: true, holds: true }),
    plot({ label: "bending moments over time", x_label, unit: "N m", series: ["Mx first end", "Mx second end", "My first end",
      "My second end"].map((name, i) => ({ name, x, y: of(i + 1), dash: i % 2 === 1 })), width: 350, height: 190, seek, least_zero: true, holds: true }),
  ];
  const has_limits = limit(0) > 0 && (limit(1) > 0 || limit(2) > 0);
  const part = (f, c, l) => (limit(l) > 0 ? force(frames, f, bar, c) / limit(l) : 0);
  const last = x.findIndex((_, f) => gone(f)); // it carries nothing from there on
  const surface = has_limits && last !== 0 ? surface_plot(history(frames, (f) => ({ n: part(f, 0, 0),
    m: Math.max(Math.hypot(part(f, 1, 1), part(f, 3, 2)), Math.hypot(part(f, 2, 1), part(f, 4, 2))) }))
    .slice(0, last < 0 ? undefined : last), along(frames, 0, bar) ? "dashed: eq 14, which is not its law" : "") : null;
  const head = [`member ${member.number}`, member.groups.map((g) => frames.groups[g]).join(", "),
    member.storey >= 0 ? `storey ${member.storey + 1}` : "", `${member.bars.length} elements`].filter(Boolean).join(" · ");
  const capacity = has_limits ? `fully plastic: N0 ${quantity(limit(0), "N", 3)}, Mx0 ${quantity(limit(1), "N m", 3)}, `
    + `My0 ${quantity(limit(2), "N m", 3)}` : "without a yield stress";
  return {
    parts: [make("h3", {}, head), facts, counted, make("p", { class: "hint" }, `curves: element ${bar + 1}, the most strained; `
      + capacity), surface, ...plots, make("p", { class: "hint" }, sampling(frames))].filter(Boolean),
    cursor(time) {
      const f = frame_at(frames, time), { worst, touched } = member_state(frames, f, member);
      facts.textContent = `${states[worst]}${touched ? ", has been in contact" : ""} · f_y ${number(f_y(frames, f, bar), 3)} · N `
        + quantity(force(frames, f, bar, 0), "N", 3);
      for (const p of plots) p.cursor(time);
      surface?.cursor(f);
    },
  };
}

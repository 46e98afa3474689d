// What hinge run --within has found of a run: its errors, what they rest on and cost, and who broke in how many runs.
import { card, make, number, table } from "./page.js";
import { list } from "./run_data.js";

const most = 20; // rows
const rounded = (value) => (typeof value === "number" ? Number(value.toPrecision(4)) : value);

// An answer with its error; where it is chaotic, the mean of several runs with its scatter.
function answers(found) {
  const names = Object.keys(found.answers || {}).sort(), any = names.some((n) => found.answers[n].scatter !== undefined);
  return table(["answer", "value", "estimated error", ...(any ? ["scatter"] : []), "what it rests on"], names.map((name) => {
    const a = found.answers[name], value = a.chaotic ? a.mean ?? a.value : a.value;
    return [a.chaotic ? `${name} (chaotic, mean)` : name, rounded(value ?? "history"), a.error_text,
      ...(any ? [rounded(a.scatter ?? "–")] : []), a.basis];
  }));
}

// Who broke, those in most runs first. pick(member): a function, or null.
function who_broke(of, pick) {
  const rows = [...list(of?.list)].sort((a, b) => b.broken - a.broken || a.member - b.member);
  if (rows.length === 0) return null;
  const some = of.in_some > 0 ? `, ${number(of.in_some)} in some of them` : "", left = rows.length - most;
  return make("div", {}, make("h3", {}, `Who broke, in ${of.runs} runs ${of.of_runs}`),
    make("p", {}, `${number(of.in_all)} of ${number(of.members)} members broke in all ${of.runs} runs${some}, ${number(of.in_none)} `
      + `in none.${of.runs > 1 && pick ? " The player shows that by colour: broken in runs." : ""}`),
    table(["member", "group", "broken in"], rows.slice(0, most).map((m) => [pick ? make("button", { type: "button",
      class: "member-link", onclick: () => pick(m.member) }, `member ${m.member}`) : `member ${m.member}`, m.group,
    `${m.broken} of ${of.runs}`])),
    left > 0 ? make("p", { class: "hint" }, `${number(left)} further members are in broken.csv`) : null);
}

function part(run, pick) {
  const found = run.summary?.accuracy;
  if (!found?.conclusion) return null;
  const notes = list(found.notes).map((n) => make("li", {}, n));
  const drawn = run.accuracy_picture ? make("img", { src: run.accuracy_picture, class: "drawn",
    alt: "errors of all settings that were run, over their times" }) : null;
  return make("div", {}, make("p", {}, make("strong", {}, found.conclusion)), answers(found),
    make("p", {}, `${found.line}; ${found.effort}`), notes.length ? make("ul", { class: "warnings" }, notes) : null,
    make("div", { class: "columns" }, drawn, who_broke(found.broken, pick)));
}

/// The card of the runs that hinge run --within has made, null where there is none. pick(run): a function of a member's
/// number, or null.
export function accuracy_card(runs, pick) {
  const parts = runs.map((r) => [r, part(r, pick(r))]).filter(([, p]) => p);
  if (parts.length === 0) return null;
  return card("Accuracy: how far the answers may be off", ...parts.flatMap(([r, p]) => (runs.length > 1 ?
    [make("h3", {}, r.name), p] : [p])));
}

// Plastic hinges and joints, as hinges.csv has them: the largest, against their limits where these are given, and sums
// by storey.
import { card, make, number, quantity, table } from "./page.js";
import { list } from "./run_data.js";

const most = 20; // rows

/// Rows of hinges.csv as objects; numbers are numbers, what is not there is null.
function hinges_of(run) {
  const columns = list(run.hinges?.columns), words = ["group", "first_kind", "level", "joint", "axis",
    "interaction"];
  return list(run.hinges?.rows).map((row) => Object.fromEntries(columns.map((name, i) => {
    const text = row[i] ?? "";
    return [name, text === "" ? null : words.includes(name) ? text : Number(text)];
  })));
}

const place = (h) => (h.end !== 0 && h.at === 0 ? "a" : h.end !== 0 && h.at > 1 - 1e-9 ? "b" : number(h.at, 3));
const first_at = (h) => (h.first_kind === "static" ? `factor ${number(h.first_yield)}` : quantity(h.first_yield, "s"));
const first = (h) => (h.first_yield === null ? "–" : first_at(h)) + (h.before ? ", in a run before" : "");
const size = (h) => h.ratio ?? -1;
const is_joint = (h) => Boolean(h.joint), is_force = (h) => is_joint(h) && !["x", "y", "z"].includes(h.axis);
const is_connector = (h) => is_joint(h) && /^(force|moment)_/.test(h.axis);
const axis_text = (h) => h.axis.replace("_", " about ").replace("force about", "force along");
const beyond_limit = (h) => h.ratio > 1 || h.failed === 1;
const unit = (h) => (is_force(h) && !h.axis.startsWith("moment") ? "N" : "N m");
/// What a joint carries, over what it can.
const carries = (h) => (!is_joint(h) ? "" : `${is_force(h) ? axis_text(h) : `about ${h.axis}`}: `
  + quantity(is_force(h) ? h.force : h.moment, unit(h)) + (h.strength === null ? "" : ` of ${quantity(h.strength, unit(h))}`));

function counts(hinges) {
  const n = hinges.filter((h) => !is_joint(h)).length, parts = [n === 1 ? "1 hinge" : `${number(n)} hinges`];
  for (const [name, is] of [["joint", (h) => is_joint(h) && !is_connector(h)], ["connector", is_connector]]) {
    const count = new Set(hinges.filter(is).map((h) => h.joint)).size;
    if (count > 0) parts.push(count === 1 ? `1 ${name}` : `${number(count)} ${name}s`);
  }
  return parts.length > 2 ? `${parts[0]}, ${parts[1]} and ${parts[2]}` : parts.join(" and ");
}

/// The worst one and its numbers.
function worst_text(worst) {
  const at = ["a", "b"].includes(place(worst)) ? `end ${place(worst)}` : `at ${place(worst)} of its length`;
  const name = is_joint(worst) ? `${worst.joint}, ${is_force(worst) ? axis_text(worst) : `about ${worst.axis}`}`
    : `member ${worst.member}${worst.group ? ` (${worst.group})` : ""}, ${at}`;
  if (is_force(worst)) return `${name}, ${quantity(worst.largest_force, unit(worst))}, ${number(worst.ratio, 3)} of its limit`;
  const value = is_joint(worst) && worst.limit !== null && worst.limit === worst.capacity ? worst.largest : worst.demand;
  return `${name}, ${number(value, 3)} rad${worst.ratio === null ? ""
    : `, ${number(worst.ratio, 3)} of its limit ${number(worst.limit, 3)} rad`}`;
}

function summary(hinges, limited) {
  const beyond = hinges.filter(beyond_limit).length, without = hinges.filter((h) => h.ratio === null).length;
  const worst = hinges[0];
  return `${counts(hinges)}${limited ? `, ${number(beyond)} beyond the limit${without ? `, ${number(without)} without one`
    : ""}` : ""}. The ${limited ? "worst" : "largest"}: ${worst_text(worst)}${worst.level ? ` (${worst.level})` : ""}.`;
}

function by_storey(hinges, limited) {
  const storeys = [...new Set(hinges.map((h) => h.storey))].sort((a, b) => (b ?? 0) - (a ?? 0));
  if (storeys.length < 2 && storeys[0] === null) return null;
  const largest = (all, of) => Math.max(0, ...all.map((h) => of(h) ?? 0));
  const joints = hinges.some(is_joint), names = (all) => new Set(all.filter(is_joint).map((h) => h.joint)).size;
  return table(["", "hinges", ...(joints ? ["joints"] : []), "largest demand, rad", "work, J",
    ...(limited ? ["largest part of the limit"] : [])],
    storeys.map((k) => {
      const all = hinges.filter((h) => h.storey === k);
      return [k === null ? "no storey" : `storey ${k}`, all.filter((h) => !is_joint(h)).length,
        ...(joints ? [names(all)] : []), Number(largest(all, (h) => h.demand).toPrecision(4)),
        Number(all.reduce((sum, h) => sum + h.work, 0).toPrecision(4)),
        ...(limited ? [Number(largest(all, (h) => h.ratio).toPrecision(3))] : [])];
    }));
}

function part(run, pick) {
  const hinges = hinges_of(run);
  if (hinges.length === 0) return null;
  const limited = hinges.some((h) => h.ratio !== null), levels = hinges.some((h) => h.level !== null);
  const joints = hinges.some(is_joint);
  hinges.sort((p, q) => size(q) - size(p) || q.demand - p.demand);
  const rows = hinges.slice(0, most).map((h) => [pick ? make("button", { type: "button", class: "at",
    onclick: () => pick(h.member) }, `member ${h.member}`) : `member ${h.member}`, h.group ?? "", h.storey ?? "–", place(h),
  Number(h.demand.toPrecision(4)), Number(h.largest.toPrecision(4)), Number(h.rotation.toPrecision(4)), Number(h.work.toPrecision(4)),
  h.utilisation === null ? "–" : Number(h.utilisation.toPrecision(3)), first(h), ...(joints ? [carries(h)] : []),
  ...(limited ? [h.ratio === null ? "–" : Number(h.ratio.toPrecision(3))] : []),
  ...(levels ? [h.level ?? ""] : [])]);
  const left = hinges.length - rows.length + (run.hinges.left_out || 0);
  const storeys = by_storey(hinges, limited), heading = rows.length < hinges.length ? `The ${most} largest` : "Each of them";
  return make("div", {}, make("p", {}, summary(hinges, limited)), storeys, storeys ? make("h3", {}, heading) : null,
    table(["member", "group", "storey", "at", "demand, rad", "largest, rad", "rotation now, rad", "work, J", "√f_y now", "first yield",
      ...(joints ? ["joint"] : []), ...(limited ? ["part of the limit"] : []), ...(levels ? ["level"] : [])], rows),
    left > 0 ? make("p", { class: "hint" }, `${number(left)} further hinges are in hinges.csv`) : null);
}

/// The card of the hinges of all runs, null where no run has any. pick(run): a function of a member's number, or null.
export function hinges_card(runs, pick) {
  const parts = runs.map((r) => [r, part(r, pick(r))]).filter(([, p]) => p);
  if (parts.length === 0) return null;
  const any = parts.some(([r]) => hinges_of(r).some(is_joint));
  return card(any ? "Plastic hinges and joints" : "Plastic hinges",
    ...parts.flatMap(([r, p]) => (runs.length > 1 ? [make("h3", {}, r.name), p] : [p])));
}

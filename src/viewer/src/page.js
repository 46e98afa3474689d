// Small helpers of the page: elements with text in them, and numbers as people read them. Text is never markup: all that
// comes from a model or a script goes through textContent.

export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  fill(element, attributes, children);
  return element;
}
export function svg(tag, attributes = {}, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  fill(element, attributes, children);
  return element;
}
function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  for (const child of children.flat()) {
    if (child === null || child === undefined) continue;
    element.append(child instanceof Node ? child : document.createTextNode(String(child)));
  }
}

export function number(value, digits = 4) {
  if (typeof value !== "number") return value === null || value === undefined ? "–" : String(value);
  if (!Number.isFinite(value)) return String(value);
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (Number.isInteger(value) && size < 1e9) return value.toLocaleString("en").replace(/,/g, "\u202f");
  if (size >= 1e6 || size < 1e-3) return value.toExponential(Math.max(0, digits - 1)).replace(/\.?0+e/, "e");
  return String(Number(value.toPrecision(digits)));
}

const prefixes = [[1e12, "T"], [1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"]];
/// A factor and a unit with a prefix in which a value of that size is read easily.
export function scaled(size, unit) {
  if (!unit) return [1, ""];
  for (const [factor, prefix] of prefixes) if (size >= factor) return [factor, prefix + unit];
  return [1, unit];
}
export function quantity(value, unit, digits = 4) {
  const [factor, name] = scaled(Math.abs(value), unit);
  return number(value / factor, digits) + (name ? "\u202f" + name : "");
}

/// A place on the axis of a run: a time, or of statics a load factor.
export const abscissa = (value, statics) => (statics ? `load factor ${number(value)}` : `${number(value)}\u202fs`);

/// A table: names of the columns, rows of cells; a cell is text, a number (to the right) or an element.
export function table(columns, rows, attributes = {}) {
  const cell = (tag, value) => {
    const right = typeof value === "number";
    return make(tag, right ? { class: "number" } : {}, right ? number(value) : value);
  };
  return make("div", { class: "wide" }, make("table", attributes,
    columns ? make("thead", {}, make("tr", {}, columns.map((c) => make("th", { scope: "col" }, c)))) : null,
    make("tbody", {}, rows.map((row) => make("tr", {}, row.map((value, i) => cell(i === 0 ? "th" : "td", value)))))));
}

export function card(title, ...children) {
  return make("section", { class: "card" }, title ? make("h2", {}, title) : null, ...children);
}

/// A share of something as a bar behind its text.
export function bar(share, text) {
  const width = `${(100 * Math.min(1, Math.max(0, share || 0))).toFixed(1)}%`;
  return make("span", { class: "bar" }, make("span", { class: "fill", style: `width:${width}` }), make("span", {}, text));
}

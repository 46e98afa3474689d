// Curves over time as SVG: axes with round numbers, a legend whose entries hide curves, a cursor at the time shown.
import { make, svg, number, scaled } from "./page.js";
import { frame_at } from "./run_data.js";

export const colours = ["#1f5fa8", "#d9822b", "#2e8b57", "#b0357a", "#6b4fa0", "#8a6d1d", "#17828f", "#c0272d",
  "#5b6770", "#9bb82b", "#e07ba8", "#3d3d3d"];

const left = 58, right = 12, top = 10, bottom = 38;

function ticks(low, high, about) {
  const rough = (high - low) / about, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((s) => s >= rough) || 10 * power;
  const marks = [];
  for (let v = Math.ceil(low / step - 1e-9) * step; v <= high + 1e-9 * step; v += step)
    marks.push(Math.abs(v) < 1e-9 * step ? 0 : v);
  return marks;
}

function extent(lists) {
  let low = Infinity, high = -Infinity;
  for (const values of lists)
    for (const v of values) if (Number.isFinite(v)) low = Math.min(low, v), high = Math.max(high, v);
  if (low > high) return [0, 1];
  if (low === high) return low === 0 ? [-1, 1] : [Math.min(0, 2 * low), Math.max(0, 2 * low)];
  return [low, high];
}

function path(x, y, to_x, to_y) {
  let text = "", pen = false;
  for (let i = 0; i < x.length; ++i) {
    const ok = Number.isFinite(x[i]) && Number.isFinite(y[i]);
    if (ok) text += `${pen ? "L" : "M"}${to_x(x[i]).toFixed(1)} ${to_y(y[i]).toFixed(1)}`;
    const lone = ok && !pen && !(i + 1 < x.length && Number.isFinite(x[i + 1]) && Number.isFinite(y[i + 1]));
    if (lone) text += "h0"; // its round ends make a dot
    pen = ok;
  }
  return text;
}

const hidden = new Set(); // curves that were hidden, by their plot's label and their name: a plot may be drawn anew

// The value of a curve at a place of its axis: between two points the straight line that is drawn, or with `holds` the
// value of the point before. NaN where nothing is drawn.
function value_at({ x, y }, at, holds) {
  if (x.length === 0) return NaN;
  const i = frame_at({ abscissa: x }, at), next = i + 1 < x.length ? y[i + 1] : NaN;
  const share = (at - x[i]) / (x[i + 1] - x[i]);
  return holds || !Number.isFinite(next) || !(share > 0 && share < 1) ? y[i] : y[i] + share * (next - y[i]);
}

/// options: width and height, label (what it shows, for screen readers), x_label, unit (of y), series [{ name, x, y, colour, dash }],
/// lines (levels drawn across), seek(x) is called with a click, holds (a value holds until the next: of frames). Returns an
/// element with a method cursor(x). The number beside a curve's name is its value at the cursor.
export function plot({ label, x_label = "time, s", unit = "", series, width = 640, height = 250, lines = [], seek,
  least_zero, holds }) {
  const [x_low, x_high] = extent(series.map((s) => s.x));
  let [y_low, y_high] = extent(series.map((s) => s.y).concat([lines]));
  if (least_zero) y_low = Math.min(0, y_low), y_high = Math.max(0, y_high);
  const [factor, y_unit] = scaled(Math.max(Math.abs(y_low), Math.abs(y_high)), unit);
  const inner_width = width - left - right, inner_height = height - top - bottom;
  const to_x = (x) => left + ((x - x_low) / (x_high - x_low)) * inner_width;
  const to_y = (y) => top + (1 - (y - y_low) / (y_high - y_low)) * inner_height;
  const drawing = svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": label });
  for (const y of ticks(y_low / factor, y_high / factor, 5))
    drawing.append(svg("line", { class: "grid", x1: left, x2: width - right, y1: to_y(y * factor), y2: to_y(y * factor) }),
      svg("text", { x: left - 6, y: to_y(y * factor) + 4, "text-anchor": "end" }, number(y)));
  for (const x of ticks(x_low, x_high, width / 90))
    drawing.append(svg("line", { class: "grid", x1: to_x(x), x2: to_x(x), y1: top, y2: height - bottom }),
      svg("text", { x: to_x(x), y: height - bottom + 16, "text-anchor": "middle" }, number(x)));
  for (const y of lines)
    drawing.append(svg("line", { class: "level", x1: left, x2: width - right, y1: to_y(y), y2: to_y(y) }));
  drawing.append(svg("text", { x: (left + width - right) / 2, y: height - 5, "text-anchor": "middle" }, x_label));
  if (y_unit) drawing.append(svg("text", { x: 4, y: top + 8 }, y_unit));
  const curves = series.map((s, i) => svg("path", { d: path(s.x, s.y, to_x, to_y), fill: "none",
    stroke: s.colour || colours[i % colours.length], "stroke-width": 1.8, "stroke-linecap": "round", "stroke-dasharray": s.dash ? "5 4" : null }));
  const cursor = svg("line", { class: "cursor", x1: left, x2: left, y1: top, y2: height - bottom });
  drawing.append(...curves, cursor);
  if (seek) {
    const at = (event) => {
      const box = drawing.getBoundingClientRect();
      seek(x_low + (((event.clientX - box.left) / box.width) * width - left) / inner_width * (x_high - x_low));
    };
    drawing.addEventListener("pointerdown", (event) => { at(event), drawing.setPointerCapture(event.pointerId); });
    drawing.addEventListener("pointermove", (event) => { if (event.buttons & 1) at(event); });
    drawing.classList.add("seeks");
  }
  const values = series.map(() => (unit ? make("small", {}) : null));
  const legend = make("div", { class: "legend" }, series.length > 1 || series[0]?.name ? series.map((s, i) => {
    const key = `${label} ${s.name}`;
    if (hidden.has(key)) curves[i].style.display = "none";
    return make("button", { type: "button", "aria-pressed": String(!hidden.has(key)), title: "show or hide this curve", onclick: (event) => {
      const shown = event.currentTarget.getAttribute("aria-pressed") !== "true";
      event.currentTarget.setAttribute("aria-pressed", shown);
      curves[i].style.display = shown ? "" : "none";
      if (shown) hidden.delete(key); else hidden.add(key);
    } }, make("span", { class: "swatch", style: `background:${s.colour || colours[i % colours.length]}` }), s.name,
    values[i]);
  }) : []);
  const figure = make("figure", { class: "plot" }, drawing, legend);
  figure.cursor = (x) => {
    const at = to_x(Math.min(x_high, Math.max(x_low, x)));
    cursor.setAttribute("x1", at), cursor.setAttribute("x2", at);
    series.forEach((s, i) => {
      const value = values[i] ? value_at(s, x, holds) : NaN;
      if (values[i]) values[i].textContent = Number.isFinite(value) ? ` ${number(value / factor, 3)}` : " –";
    });
  };
  figure.cursor(Infinity);
  return figure;
}

/// The yield surface of eq 14 in the plane of N/N0 and the bending of both axes: a path in it, and where it is now.
/// points: [{ n, m }], m >= 0. note: if not empty, the surface is dashed, and this is said of it.
export function surface_plot(points, note) {
  const size = 280, tall = 180, middle = size / 2, most = Math.max(1.15, ...points.map((p) => Math.max(Math.abs(p.n), p.m))) * 1.05;
  const to_x = (n) => middle + (n / most) * (middle - 26), to_y = (m) => tall - 36 - (m / most) * (middle - 26);
  const arc = [];
  for (let a = 0; a <= Math.PI + 1e-9; a += Math.PI / 60)
    arc.push(`${arc.length ? "L" : "M"}${to_x(Math.cos(a)).toFixed(1)} ${to_y(Math.sin(a)).toFixed(1)}`);
  const drawing = svg("svg", { viewBox: `0 0 ${size} ${tall}`, role: "img",
    "aria-label": "axial force and bending against the yield surface" },
  svg("line", { class: "grid", x1: 10, x2: size - 10, y1: to_y(0), y2: to_y(0) }),
  svg("line", { class: "grid", x1: middle, x2: middle, y1: 12, y2: to_y(0) }),
  svg("path", { d: arc.join(""), class: "surface", ...(note ? { "stroke-dasharray": "5 4" } : {}) }),
  svg("path", { class: "path", d: points.map((p, i) => `${i ? "L" : "M"}${to_x(p.n).toFixed(1)} ${to_y(p.m).toFixed(1)}`)
    .join("") }),
  svg("text", { x: middle, y: tall - 6, "text-anchor": "middle" }, "N / N0, tension to the right"),
  svg("text", { x: to_x(1), y: to_y(0) + 15, "text-anchor": "middle" }, "1"),
  svg("text", { x: to_x(-1), y: to_y(0) + 15, "text-anchor": "middle" }, "−1"),
  svg("text", { x: middle + 5, y: 20 }, "M / M0"), ...(note ? [svg("text", { x: 12, y: 10 }, note)] : []));
  const dot = svg("circle", { r: 5, class: "now" });
  drawing.append(dot);
  const figure = make("figure", { class: "plot surface-plot" }, drawing);
  figure.cursor = (i) => {
    const p = points[i];
    dot.style.display = p ? "" : "none";
    if (p) dot.setAttribute("cx", to_x(p.n)), dot.setAttribute("cy", to_y(p.m));
  };
  return figure;
}

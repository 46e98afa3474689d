// What is written over the structure: the directions of the axes, and the numbers of nodes. And the view as a picture.
import { Vector3 } from "three";
import { make, svg } from "./page.js";

const reach = 24, middle = 34, least = 0.2; // pixels, pixels, share of the length: a shorter axis points at the reader
const most_numbers = 300;

/// The directions of x, y and z in a corner, where no view is too narrow for them. Returns an element with turn(camera).
export function make_triad() {
  const parts = ["x", "y", "z"].map((name) => ({ line: svg("line", { x1: middle, y1: middle }), name: svg("text",
    { "text-anchor": "middle" }, name) }));
  const drawing = svg("svg", { class: "triad", viewBox: `0 0 ${2 * middle} ${2 * middle}`, role: "img",
    "aria-label": "directions of x, y and z" }, ...parts.flatMap((p) => [p.line, p.name]));
  drawing.ends = () => parts.map((p) => ["x2", "y2"].map((a) => Number(p.line.getAttribute(a)) - middle));
  drawing.turn = (camera) => parts.forEach(({ line, name }, i) => {
    const e = camera.matrixWorldInverse.elements, x = e[4 * i], y = -e[4 * i + 1], long = Math.hypot(x, y);
    line.setAttribute("x2", middle + reach * x), line.setAttribute("y2", middle + reach * y);
    name.style.visibility = long < least ? "hidden" : "visible";
    const out = long < least ? 0 : (reach * long + 7) / long;
    name.setAttribute("x", middle + out * x), name.setAttribute("y", middle + out * y + 4);
  });
  return drawing;
}

/// The numbers of a view's nodes, the nearest to the eye where there is no room for all. Returns an element with
/// place(view, camera), which gives how many are shown, and hide().
export function make_numbers() {
  const holder = make("div", { class: "numbers", "aria-hidden": "true" }), labels = [], p = new Vector3();
  const put = (n, text, x, y) => {
    const label = labels[n] ?? (labels[n] = make("span", {}), holder.append(labels[n]), labels[n]);
    label.textContent = text, label.style.transform = `translate(${x}px, ${y}px)`, label.hidden = false;
  };
  holder.hide = () => { for (const label of labels) label.hidden = true; };
  holder.place = (view, camera) => {
    const { run: { frames }, scene, box } = view, near = [], taken = new Set();
    for (const [node, at] of scene.node_places(view.frame, view.magnify, view.part)) {
      p.fromArray(at).add(scene.root.position).project(camera);
      if (Math.abs(p.x) < 0.98 && Math.abs(p.y) < 0.98 && p.z < 1 && node < frames.declared_nodes)
        near.push([p.z, node, box.x + (p.x + 1) / 2 * box.w, box.y + (1 - p.y) / 2 * box.h]);
    }
    near.sort((a, b) => a[0] - b[0]);
    let shown = 0;
    for (const [, node, x, y] of near) {
      const cells = [0, 1].flatMap((i) => [0, 1].map((k) => `${Math.floor(x / 26) + i} ${Math.floor(y / 14) + k}`));
      if (shown >= most_numbers || cells.some((c) => taken.has(c))) continue;
      taken.add(cells[0]);
      put(shown++, String(node + 1), x + 3, y - 15);
    }
    for (let i = shown; i < labels.length; ++i) labels[i].hidden = true;
    return shown;
  };
  return holder;
}

/// The stage of a player as a PNG: what is drawn, with the words over it and the legend below. Returns a canvas.
export function picture_of(player, legend) {
  const { canvas, stage } = player, scale = canvas.width / stage.clientWidth, line = 22, pad = 10;
  const rows = [[]];
  const made = document.createElement("canvas"), pen = made.getContext("2d"), width = stage.clientWidth;
  pen.font = "13px system-ui, sans-serif";
  let x = pad;
  for (const { colour, text } of legend) {
    const wide = pen.measureText(text).width + (colour ? 36 : 20);
    if (x + wide > width - pad && rows[rows.length - 1].length > 0) rows.push([]), x = pad;
    rows[rows.length - 1].push({ colour, text, x }), x += wide;
  }
  made.width = canvas.width, made.height = canvas.height + Math.round(scale * (line * rows.length + pad));
  pen.fillStyle = "#ffffff", pen.fillRect(0, 0, made.width, made.height);
  player.draw_now();
  pen.drawImage(canvas, 0, 0);
  pen.scale(scale, scale), pen.font = "13px system-ui, sans-serif";
  const box = stage.getBoundingClientRect();
  const write = (text, at_x, at_y, colour) => { pen.fillStyle = colour, pen.fillText(text, at_x, at_y); };
  for (const span of stage.querySelectorAll(".view-name, .clock, .numbers span")) {
    if (span.hidden || !span.textContent) continue;
    const at = span.getBoundingClientRect(), style = getComputedStyle(span);
    pen.font = `${style.fontWeight} ${style.fontSize} system-ui, sans-serif`;
    write(span.textContent, at.left - box.left, at.bottom - box.top - 4, style.color);
  }
  const triad = player.triad, corner = triad.getBoundingClientRect(), part = corner.width / (2 * middle);
  pen.font = "12px system-ui, sans-serif", pen.strokeStyle = "#5b6770", pen.lineWidth = 1.4;
  triad.ends().forEach(([dx, dy], i) => {
    const from = [corner.left - box.left + middle * part, corner.top - box.top + middle * part];
    pen.beginPath(), pen.moveTo(...from), pen.lineTo(from[0] + dx * part, from[1] + dy * part), pen.stroke();
    if (Math.hypot(dx, dy) >= least * reach) write("xyz"[i], from[0] + dx * part * 1.3 - 3, from[1] + dy * part * 1.3 + 4, "#5b6770");
  });
  pen.font = "13px system-ui, sans-serif";
  rows.forEach((row, k) => row.forEach(({ colour, text, x: at }) => {
    const y = stage.clientHeight + pad + line * k;
    if (colour) pen.fillStyle = colour, pen.fillRect(at, y, 14, 12), pen.strokeStyle = "#5b6770", pen.lineWidth = 0.6,
      pen.strokeRect(at, y, 14, 12);
    write(text, at + (colour ? 19 : 0), y + 11, "#1d2731");
  }));
  return made;
}

// The player's buttons, sliders and lists.
import { make, number, quantity } from "./page.js";
import { colourings, name_of, offered } from "./colouring.js";
import { diagrams, diagram_colours } from "./diagrams.js";
import { hinge_colour } from "./scene.js";
import { plate_colours } from "./plates.js";

const choice = (label, options, value, choose) => make("label", {}, label, make("select", { onchange: (e) =>
  choose(e.target.value) }, options.map(([v, text]) => make("option", { value: v, selected: v === value }, text))));
const tick = (label, value, choose) => make("label", { class: "tick" }, make("input", { type: "checkbox", checked: value,
  onchange: (e) => choose(e.target.checked) }), label);

export function controls_of(player) {
  const { options } = player;
  const set = (name) => (value) => { options[name] = value, player.repaint(); };
  const play = make("button", { type: "button", class: "play", onclick: () => player.play() }, "▶ play");
  const range = make("input", { type: "range", min: player.begin, max: player.end, step: "any", value: player.time,
    "aria-label": "time", oninput: (e) => {
      const time = Number(e.target.value); // before the slider is put where the player is
      player.play(false), player.seek(time);
    } });
  const newest = make("button", { type: "button", title: "follow the newest frame", "aria-pressed": "true",
    onclick: () => { player.play(false), player.seek(player.end); } }, "newest");
  player.show_time = () => {
    range.min = player.begin, range.max = player.end;
    range.value = player.time;
    newest.setAttribute("aria-pressed", player.at_end());
    play.textContent = player.playing ? "❚❚ pause" : "▶ play";
  };
  const magnify = make("input", { type: "range", min: 0, max: 3, step: 0.02, value: 0, "aria-label":
    "magnification of displacements", oninput: (e) => {
    options.magnify = Number((10 ** Number(e.target.value)).toPrecision(2));
    magnified.textContent = `× ${number(options.magnify)}`;
    player.repaint();
  } });
  const magnified = make("output", {}, "× 1");
  const legend = make("div", { class: "legend" });
  const entry = (kind) => ([colour, text]) => make("span", {}, make("span", { class: kind,
    style: `background:${colour}` }), text);
  const show_legend = () => {
    const { run: { frames }, scene } = player.views[0];
    const pairs = colourings[options.colouring].legend(frames, scene, player.runs.map((r) => r.frames));
    legend.replaceChildren(...pairs.map(entry("swatch")),
      ...(scene.dots.drawn.visible ? [entry("swatch dot")([hinge_colour, "plastic hinge"])] : []),
      ...(scene.plates.visible ? [entry("swatch")([plate_colours.tension, "panel in tension"]),
        entry("swatch")([plate_colours.compression, "panel in compression"])] : []));
  };
  // Beneath the legend: the diagram's colours, and its largest value of the frame shown.
  const diagram_legend = make("div", { class: "legend diagram", "aria-live": "off" });
  player.show_diagram = () => {
    const found = player.views[player.chosen.run].diagram, { run: { frames } } = player.views[player.chosen.run];
    if (!found) return diagram_legend.replaceChildren();
    const { largest: { value, bar }, left_out } = found, { unit } = diagrams[options.diagram];
    diagram_legend.replaceChildren(entry("swatch")([diagram_colours.plus, `${options.diagram} above 0`]),
      entry("swatch")([diagram_colours.minus, "below 0"]), make("span", {}, bar < 0 ? "zero everywhere" :
        `largest in this frame: ${quantity(value, unit)} in member ${frames.member[bar]}`),
      ...(left_out ? [make("span", {}, `${left_out} ${left_out === 1 ? "element" : "elements"} with loads at points `
        + "left out; a picture (hinge render --show) has them")] : []));
  };
  player.legend = () => [...bar.querySelectorAll(".legend > span")].map((e) => ({ text: e.textContent,
    colour: e.querySelector(".swatch")?.style.background }));
  const save = () => make("a", { download: "hinge.png", href: player.picture().toDataURL("image/png") }).click();
  show_legend();
  player.show_legend = show_legend;
  const follow = tick("follow the member picked", false, set("follow"));
  player.show_options = () => { follow.firstChild.checked = options.follow; };
  let dots = true;
  const show_dots = () => {
    scenes((s) => { s.dots.drawn.visible = dots && !colourings[options.colouring].of_all_runs; })();
    show_legend();
  };
  const scenes = (f) => (value) => { player.views.forEach((v) => f(v.scene, value)), player.repaint(); };
  const bar = make("div", { class: "controls" },
    make("div", { class: "row timeline" }, play,
      make("button", { type: "button", title: "a frame back", "aria-label": "a frame back", onclick: () => player.step(-1) }, "◂"),
      range,
      make("button", { type: "button", title: "a frame on", "aria-label": "a frame on", onclick: () => player.step(1) }, "▸"),
      choice("speed", [[0.25, "¼"], [0.5, "½"], [1, "1"], [2, "2"], [4, "4"]].map(([v, t]) => [String(v), t]), "1",
        (v) => { options.speed = Number(v); }), player.grows ? newest : null),
    make("div", { class: "row" },
      choice("colour", offered(player.runs).map((k) => [k, name_of(k, player.runs)]), "f_y", (v) => {
        options.colouring = v, show_dots();
      }),
      choice("diagram", [["", "none"], ...Object.entries(diagrams).map(([k, d]) => [k, d.name])], "", set("diagram")),
      make("label", {}, "displacements", magnify, magnified),
      make("button", { type: "button", onclick: () => (document.fullscreenElement ? document.exitFullscreen() :
        player.element.requestFullscreen()) }, "full screen"),
      choice("view", [["corner", "corner"], ["front", "front"], ["side", "side"], ["back", "back"], ["top", "top"]], "corner",
        (v) => player.look(v)),
      make("button", { type: "button", onclick: save }, "save picture"),
      legend, diagram_legend),
    make("div", { class: "row" }, follow,
      tick("parallel", false, (on) => player.set_parallel(on)), tick("node numbers", false, set("numbers")),
      tick("undeformed shape", false, scenes((s, on) => { s.ghost.visible = on; })),
      tick("hinges", true, (on) => { dots = on, show_dots(); }),
      player.views.some((v) => v.scene.plates.count > 0) ? tick("panels", true, (on) => {
        scenes((s) => s.plates.show(on))(), show_legend();
      }) : null,
      tick("ground and supports", true, scenes((s, on) => { s.ground.visible = on; })),
      tick("thin members", false, (on) => set("thicker")(on ? 0.25 : 1)),
      tick("smooth", true, (on) => { options.smooth = on; }), tick("again and again", false, (on) => { options.loop = on; })),
    groups_row(player), storeys_row(player));
  return bar;
}

function groups_row(player) {
  const names = [...new Set(player.views.flatMap((v) => v.run.frames.groups))];
  if (names.length < 1) return null;
  const change = (name) => (on) => {
    if (on) player.options.hidden.delete(name); else player.options.hidden.add(name);
    player.repaint();
  };
  return make("details", { class: "row" }, make("summary", {}, `groups (${names.length})`),
    make("div", { class: "groups" }, names.map((name) => tick(name, true, change(name)))));
}

function storeys_row(player) {
  const most = Math.max(...player.views.map((v) => v.run.frames.floors.length));
  if (most < 2) return null;
  const text = make("output", {}, `all ${most}`);
  const slider = (name, label, value) => make("input", { type: "range", min: 1, max: most, step: 1, value,
    "aria-label": label, oninput: (e) => {
      player.options[name] = Number(e.target.value) - 1;
      const low = Math.max(0, player.options.low), high = Math.min(most - 1, player.options.high);
      text.textContent = low > high ? "none" : low === 0 && high === most - 1 ? `all ${most}` : `${low + 1} to ${high + 1}`;
      player.repaint();
    } });
  return make("div", { class: "row storeys" }, make("label", {}, "storeys from", slider("low", "lowest storey shown", 1)),
    make("label", {}, "to", slider("high", "highest storey shown", most)), text);
}

// The picture of the arm, and what is shown in it.

import { annotations, COLORS } from "./annotations.js";
import { corners, drawn, solids } from "./arm.js";
import { chain } from "./chain.js";
import { element, indexed } from "./dom.js";
import { add, cross, distance, dot, length, scaled, subtract, unit } from "./frames.js";
import { handle } from "./handle.js";
import { labels } from "./labels.js";
import { colorOf } from "./plots.js";
import { across, room as makeRoom } from "./scene.js";
import { line } from "./shapes.js";
import { transport } from "./transport.js";

/** Up is against gravity; where there is none, along z of the world. */
function upOf(table) {
  return length(table.gravity) > 1e-9 ? unit(scaled(table.gravity, -1)) : [0, 0, 1];
}

/** The direction of all axes of an arm that moves in an upright plane; null of another one. */
function planeOf(table, up) {
  if (table.floating) return null;
  const { rows } = chain(table, new Array(table.joints).fill(0), null);
  const turning = table.rows.flatMap((row, i) => (row.type === "revolute" && row.joint !== null ? [rows[i].axis] : []));
  if (turning.length === 0) return null;
  const [first] = turning;
  const isPlanar = turning.every((axis) => length(cross(first, axis)) < 1e-6);
  return isPlanar && Math.abs(dot(first, up)) < 1e-6 ? first : null;
}

/** The section with the picture. */
export function stage(model) {
  const { table, state, size } = model;
  const canvas = element("canvas", { tabIndex: 0, role: "img" });
  const layer = element("div", { class: "labels", "aria-hidden": "true" });
  const readout = element("output", { class: "readout" });
  const scale = element("span", { class: "scale" });
  const views = element("div", { class: "views", role: "group", "aria-label": "View" });
  const shown = element("div", { class: "shown", role: "group", "aria-label": "What is shown" });
  const view = element("div", { class: "view" }, canvas, layer, views, readout, scale);
  const section = element("section", { class: "panel stage", "aria-label": "The arm" }, view, shown, transport(model));
  canvas.setAttribute("aria-label", `${table.name} in 3D; drag to turn, arrow keys too, plus and minus to zoom`);

  /** To be called once the section is in the page. */
  function start() {
    const up = upOf(table);
    const room = makeRoom(canvas, up, size);
    if (!room) {
      view.classList.add("missing");
      view.append(element("p", {}, "This browser draws no WebGL: the arm is not shown. All numbers are."));
      return;
    }
    const arm = solids(room, table, size);
    const notes = annotations(room, table, size);
    const marks = labels(room, layer);
    handle(model, room, view);
    const links = drawn(table);
    const trace = line("#f08c00", 2.4);
    trace.visible = false;
    room.scene.add(trace);

    const plane = planeOf(table, up);
    const [first, second] = across(up);
    // From in front, on the right, above; a plane is seen from its side.
    const front = plane ?? scaled(second, -1);
    const right = cross(up, front);
    const iso = plane
      ? add(add(front, scaled(right, 0.22)), scaled(up, 0.16))
      : add(add(scaled(first, 0.75), scaled(second, -0.9)), scaled(up, 0.55));
    const directions = {
      "3D": iso,
      front: add(front, scaled(up, 1e-4)),
      side: add(right, scaled(up, 1e-4)),
      top: add(up, scaled(front, 1e-3)),
    };
    let looked = "3D";
    /** The corners of the robot at a pose and at positions; in a view that follows the base, as if that were at `stand`. */
    function cornersAt(base, q, stand) {
      const at = chain(model.table, q, base);
      const way = isFollowed() ? subtract(stand, at.base.o) : [0, 0, 0];
      return corners(model.table, at, size).map((p) => add(p, way));
    }
    function look(name) {
      looked = name;
      const seen = model.trajectory ?? { q: [], base: [] };
      const every = Math.max(1, Math.floor(seen.q.length / 12));
      const stand = model.frames().base.o;
      const all = seen.q
        .flatMap((q, k) => (k % every === 0 || k === seen.q.length - 1 ? cornersAt(seen.base[k], q, stand) : []))
        .concat(cornersAt(model.start(), state.q, stand))
        // What flies far away is not followed.
        .filter((p) => distance(p, stand) < 1.6 * size);
      followed = stand;
      // The ground is below where a base that moves begins.
      const begin = chain(model.table, state.q, model.start());
      const low = table.floating ? corners(model.table, begin, size) : all;
      lowest = Math.min(...low.map((p) => dot(p, up)), dot(begin.base.o, up) - 0.09 * size);
      ground();
      room.look(directions[name], all.length > 0 ? all : [stand]);
    }
    let lowest = 0;
    /** Where the base was when the view was last moved. */
    let followed = [0, 0, 0];
    const isFollowed = () => table.floating !== null && state.mode === "free" && state.show.isFollowed;
    function follow(base) {
      if (isFollowed()) room.follow(subtract(base, followed));
      followed = base;
    }
    function ground() {
      const { base } = chain(model.table, state.q, model.start());
      const isFalling = table.floating !== null && state.mode === "free";
      const step = room.ground(base.o, lowest, [colorOf("--grid-strong"), colorOf("--grid")], !isFalling);
      scale.textContent = `grid ${step >= 1 ? step : Number(step.toPrecision(3))} m`;
    }
    for (const name of Object.keys(directions)) {
      views.append(element("button", { type: "button", class: "chip", "data-key": `view-${name}`, onclick: () => look(name) }, name));
    }
    canvas.addEventListener("keydown", ({ key }) => {
      const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
      if (turns[key]) room.turn(...turns[key]);
      if (key === "+" || key === "-") room.zoom(key === "+" ? 0.9 : 1 / 0.9);
    });

    /** The rows whose parameters are drawn. */
    function annotated() {
      const { parameters } = state.show;
      if (parameters === "none") return [];
      const all = links.filter(({ row }) => !row.isPlace).map(({ index }) => index);
      return parameters === "all" ? all : all.filter((index) => index === state.selected);
    }

    function put() {
      const at = model.frames();
      follow(at.base.o);
      arm.put(at, model.table);
      const texts = notes.put(at, model.table, annotated(), model.units);
      const name = ({ o }, content) => ({ at: o, content, kind: "frame", color: "var(--ink)" });
      const named = state.show.frames
        ? [
            name(at.base, "0"),
            ...links.map(({ row, index }, k) => name(at.rows[index].link, row.isPlace ? "tip" : String(k + 1))),
            ...(table.tips.length > 1 ? table.tips : []).map((tip, k) => name(at.tips[k], tip.name)),
          ]
        : [];
      const parameters = texts.map(({ at: place, name: parameter, sign, index, text }) => ({
        at: place,
        content: [...indexed(sign, index), text ? ` = ${text}` : ""],
        kind: "parameter",
        color: COLORS[parameter],
      }));
      marks.put([...named, ...parameters]);
      const [x, y, z] = at.tips[state.tip].o.map((value) => (Math.abs(value) < 5e-7 ? 0 : value).toFixed(4));
      readout.textContent = `${model.tip().name}  x ${x}  y ${y}  z ${z} m`;
      traced();
    }

    function retrace() {
      const { trajectory } = model;
      const path = trajectory?.tip ?? [];
      trace.visible = path.length > 1;
      if (!trace.visible) return;
      trace.geometry.dispose();
      trace.geometry = new trace.geometry.constructor();
      trace.geometry.setPositions(path.flat());
      traced();
    }
    /** The trace ends at the present time. */
    function traced() {
      const { trajectory } = model;
      if (!trajectory || trajectory.t.length < 2) {
        trace.visible = false;
        return;
      }
      const done = Math.floor((state.t / trajectory.duration) * (trajectory.t.length - 1) + 1e-9);
      trace.visible = state.show.trace && done > 0;
      trace.geometry.instanceCount = done;
      room.ask();
    }

    function paint() {
      const of = (row) => row.joint ?? row.follows?.joint;
      arm.paint((row) => colorOf(of(row) === undefined ? "--muted" : `--joint-${of(row) % 8}`));
      trace.material.color.set(colorOf("--trace"));
      ground();
    }

    model.on("time fields units selection tip", put);
    model.on("trajectory", retrace);
    model.on("show", () => {
      arm.show(state.show);
      put();
    });
    model.on("theme", paint);
    model.on("mode", () => look(looked));
    arm.show(state.show);
    look("3D");
    paint();
    put();
    retrace();
    // The shape of the canvas is known after the page is laid out.
    requestAnimationFrame(() => look("3D"));
  }

  const parameters = element(
    "select",
    { "data-key": "parameters" },
    Object.entries({ selected: "selected row", all: "all rows", none: "none" }).map(([value, text]) => element("option", { value }, text)),
  );
  parameters.addEventListener("change", () => model.setShown({ parameters: parameters.value }));
  const named = table.isMounted ? "placement" : "D-H parameters";
  shown.append(element("label", { class: "choice" }, element("span", {}, named), parameters));
  if (table.tips.length > 1) {
    const tips = element("select", { "data-key": "tip" }, table.tips.map(({ name }, value) => element("option", { value }, name)));
    tips.addEventListener("change", () => model.setTip(Number(tips.value)));
    shown.append(element("label", { class: "choice" }, element("span", {}, "frame"), tips));
  }
  const checks = { frames: "frames", axes: "axes", masses: "masses", trace: "trace" };
  if (table.floating) checks.isFollowed = "follow the fall";
  for (const [key, text] of Object.entries(checks)) {
    const check = element("input", { type: "checkbox", checked: state.show[key], "data-key": `show-${key}` });
    check.addEventListener("change", () => model.setShown({ [key]: check.checked }));
    shown.append(element("label", { class: "check" }, check, text));
  }
  return { section, start };
}

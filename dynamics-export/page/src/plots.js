// Curves over time, linked: one cursor, one time, one choice of joints.

import uPlot from "uplot";

import { element, indexed } from "./dom.js";
import { plain } from "./format.js";
import { positionOf } from "./moving_base.js";
import { csv } from "./trajectory.js";

const SYNC = "robot-dynamics";

/** A color of the style sheet. */
export const colorOf = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/**
 * The plots: of each title, unit and curves. Curves have values of each sample, the scale of a unit, and `now`, the value of
 * a state that was evaluated.
 */
function plotsOf(model) {
  const { joints, ofBase, units, trajectory } = model;
  const { name: tip } = model.tip();
  const entry = (key, i, factor) => ({
    values: trajectory[key].map((values) => values[i] * factor),
    now: (state) => state[key][i] * factor,
  });
  const ofJoints = (key, title, unit, isAngle) => ({
    key,
    title,
    curves: joints.map((row, i) => ({
      joint: i,
      name: row.name,
      unit: unit(row.type),
      color: `--joint-${i % 8}`,
      isDashed: i >= 8,
      ...entry(key, key === "q" ? i : ofBase + i, isAngle ? units.factor(row.type) : 1),
    })),
  });
  const single = (name, sign, values, unit, color, now) => ({ joint: null, name, sign, values, unit, color, now });
  const axis = (k) => trajectory.tip.map((tip) => tip[k]);
  const plots = [
    ofJoints("q", ["q", "positions"], units.position, true),
    ofJoints("qd", ["q̇", "velocities"], units.velocity, true),
    ofJoints("qdd", ["q̈", "accelerations"], units.acceleration, true),
    ofJoints("tau", ["τ", "torques and forces"], units.force, false),
    {
      key: "energy",
      title: ["E", "energies"],
      curves: [
        single("kinetic", "T", trajectory.kinetic, "J", "--joint-0", ({ kinetic }) => kinetic),
        single("potential", "U", trajectory.potential, "J", "--joint-1", ({ potential }) => potential),
        single("total", "T+U", trajectory.total, "J", "--ink", ({ kinetic, potential }) => kinetic + potential),
      ],
    },
    {
      key: "tip",
      title: ["p", tip],
      curves: [0, 1, 2].map((k) => single("xyz"[k], "xyz"[k], axis(k), "m", `--axis-${"xyz"[k]}`, ({ tip }) => tip[k][3])),
    },
  ];
  return ofBase > 0 ? [...plots.filter(({ curves }) => curves.length > 0), ...plotsOfBase(model, entry, single)] : plots;
}

/** The plots of a base that moves: where it is, and velocities and forces in its axes. */
function plotsOfBase({ freedoms, ofBase, units, trajectory }, entry, single) {
  const of = (key, title, sign, unit, isAngle) => ({
    key: `base-${key}`,
    title,
    curves: freedoms.slice(0, ofBase).map((freedom, k) => ({
      joint: null,
      name: freedom.name,
      sign: sign(freedom),
      unit: unit(freedom.type),
      color: `--axis-${freedom.axis}`,
      isDashed: k >= 3,
      ...entry(key, k, isAngle ? units.factor(freedom.type) : 1),
    })),
  });
  const where = [0, 1, 2].map((k) => {
    const at = ({ base }) => positionOf(base)[k];
    return single("xyz"[k], "xyz"[k], trajectory.base.map((base) => at({ base })), "m", `--axis-${"xyz"[k]}`, at);
  });
  const velocity = ({ velocity: sign, axis }) => `${sign}${axis}`;
  const force = ({ force: sign, axis }) => `${sign}${axis}`;
  return [
    { key: "base", title: ["p", "base"], curves: where },
    of("qd", ["v, ω", "of the base"], velocity, units.velocity, true),
    of("tau", ["f, n", "acting on the base"], force, units.force, false),
  ];
}

/** Room above and below curves; a constant one gets some of its own. */
function padded(low, high) {
  if (low === null || !Number.isFinite(low + high)) return [-1, 1];
  const wide = high - low;
  const size = Math.max(Math.abs(low), Math.abs(high));
  if (wide <= 1e-9 * size || wide < 1e-12) return size < 1e-12 ? [-1, 1] : [low - 0.5 * size, high + 0.5 * size];
  return [low - 0.06 * wide, high + 0.06 * wide];
}

function options(plot, width, height, t) {
  const [ink, lines, muted] = ["--ink", "--line", "--muted"].map(colorOf);
  const all = [...new Set(plot.curves.map(({ unit }) => unit))];
  const font = "11px system-ui, sans-serif";
  const axis = (scale, side, grid) => ({
    scale,
    side,
    stroke: muted,
    font,
    size: 46,
    gap: 3,
    grid: { show: grid, stroke: lines, width: 1 },
    ticks: { show: false },
    values: (_, ticks) => ticks.map((x) => String(Number(x.toPrecision(6)))),
  });
  return {
    width,
    height,
    padding: [8, all.length > 1 ? 0 : 12, 0, 0],
    legend: { show: false },
    cursor: { sync: { key: SYNC }, drag: { x: false, y: false }, points: { size: 6 }, y: false },
    focus: { alpha: 0.3 },
    scales: {
      x: { time: false, range: () => [t[0], t[t.length - 1] || 1] },
      ...Object.fromEntries(all.map((unit) => [unit, { range: (_, low, high) => padded(low, high) }])),
    },
    axes: [
      {
        stroke: muted,
        font,
        size: 26,
        gap: 3,
        grid: { stroke: lines, width: 1 },
        ticks: { show: false },
        values: (_, ticks) => ticks.map((x) => `${Number(x.toPrecision(6))}`),
      },
      ...all.map((unit, k) => axis(unit, k === 0 ? 3 : 1, k === 0)),
    ],
    series: [
      {},
      ...plot.curves.map(({ name, unit, color, isDashed }) => ({
        label: name,
        scale: unit,
        stroke: colorOf(color) || ink,
        width: 1.8,
        dash: isDashed ? [5, 4] : undefined,
        points: { show: false },
      })),
    ],
  };
}

/** The panel of plots. */
export function plots(model) {
  const { joints } = model;
  const hidden = new Set();
  const grid = element("div", { class: "plots" });
  const status = element("p", { class: "status", role: "status", "data-key": "status" });
  let made = [];

  const legend = element(
    "div",
    { class: "legend", role: "group", "aria-label": "Joints in the plots" },
    joints.map((row, i) => {
      const chip = element("button", { type: "button", class: "chip", "aria-pressed": true });
      chip.style.setProperty("--color", `var(--joint-${i % 8})`);
      chip.append(element("span", { class: "dot" }), row.name);
      chip.addEventListener("click", () => {
        if (!hidden.delete(i)) hidden.add(i);
        chip.setAttribute("aria-pressed", !hidden.has(i));
        made.forEach(({ plot, chart, readings }) =>
          plot.curves.forEach(({ joint }, k) => {
            if (joint !== i) return;
            chart.setSeries(k + 1, { show: !hidden.has(i) });
            readings[k].hidden = hidden.has(i);
          }),
        );
      });
      return chip;
    }),
  );

  const save = element("button", { type: "button", class: "quiet", "data-key": "csv" }, "Save as CSV");
  save.addEventListener("click", () => {
    const names = model.freedoms.map((row) => row.name);
    const text = csv(model.trajectory, names);
    const link = element("a", { href: URL.createObjectURL(new Blob([text], { type: "text/csv" })) });
    link.download = `${model.table.name}.csv`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  });

  function build() {
    const { trajectory } = model;
    made.forEach(({ chart }) => chart.destroy());
    made = [];
    grid.replaceChildren();
    section.hidden = trajectory === null;
    if (!trajectory) return;
    tell();
    const hasBegun = trajectory.t.length > 1;
    save.disabled = !hasBegun;
    if (!hasBegun) return;
    for (const plot of plotsOf(model)) {
      const [sign, name] = plot.title;
      const all = [...new Set(plot.curves.map(({ unit }) => unit))];
      const readings = plot.curves.map(({ color, sign: own, joint }) => {
        const reading = element("span", { class: "reading" });
        reading.style.setProperty("--color", `var(${color})`);
        reading.append(...(own ? [element("i", {}, own)] : indexed(sign, joint + 1)), " ", element("data"));
        return reading;
      });
      const canvas = element("div", { class: "chart", role: "img", "aria-label": `${name} over time, ${all.join(" and ")}` });
      const figure = element(
        "figure",
        { "data-plot": plot.key },
        element("figcaption", {}, element("b", {}, element("i", {}, sign)), ` ${name}, ${all.join(" and ")}`),
        element("div", { class: "readings" }, readings),
        canvas,
      );
      grid.append(figure);
      const height = 168;
      const data = [trajectory.t, ...plot.curves.map(({ values }) => values)];
      const chart = new uPlot(options(plot, Math.max(canvas.clientWidth, 120), height, trajectory.t), data, canvas);
      const head = element("div", { class: "playhead" });
      chart.over.append(head);
      scrub(chart);
      plot.curves.forEach(({ joint }, k) => {
        if (joint === null || !hidden.has(joint)) return;
        chart.setSeries(k + 1, { show: false });
        readings[k].hidden = true;
      });
      made.push({ plot, chart, head, readings, canvas });
    }
    observe();
    move();
  }

  /** A pointer on a plot sets the time. */
  function scrub(chart) {
    const set = (event) => {
      const { left } = chart.over.getBoundingClientRect();
      model.play(false);
      model.setTime(chart.posToVal(event.clientX - left, "x"));
    };
    chart.over.addEventListener("pointerdown", (event) => {
      chart.over.setPointerCapture(event.pointerId);
      set(event);
    });
    chart.over.addEventListener("pointermove", (event) => {
      if (chart.over.hasPointerCapture(event.pointerId)) set(event);
    });
  }

  function move() {
    const { trajectory, state } = model;
    if (!trajectory || made.length === 0) return;
    // The readings are those of the numbers beside: of this instant, which may be between two samples.
    const found = model.evaluated();
    for (const { plot, chart, head, readings } of made) {
      head.style.transform = `translateX(${chart.valToPos(state.t, "x")}px)`;
      plot.curves.forEach(({ now }, i) => {
        const data = readings[i].lastChild;
        data.value = String(now(found));
        data.textContent = plain(now(found));
      });
    }
  }

  /** What there is to say of how good the motion is. */
  function tell() {
    const { trajectory, state, table } = model;
    const texts = [];
    const hasBegun = trajectory.t.length > 1;
    if (trajectory.ended) {
      const { t, reason } = trajectory.ended;
      texts.push(hasBegun ? `Ends at ${plain(t)} s: ${reason}.` : `The motion cannot begin: ${reason}.`);
    }
    if (state.mode === "free" && hasBegun) {
      const relative = trajectory.energyScale > 0 ? trajectory.drift / trajectory.energyScale : 0;
      texts.push(
        `Integrated by DOP853. Energy and work balance to ${trajectory.drift.toExponential(1)} J, ` +
          `${relative.toExponential(1)} of what is exchanged.`,
      );
      const passes = joints.filter((row, i) => {
        const { limits } = table.rows.find((other) => other.joint === i);
        return limits && trajectory.q.some((q) => q[i] < limits[0] - 1e-9 || q[i] > limits[1] + 1e-9);
      });
      if (passes.length > 0) {
        texts.push(`Limits are no stops here: ${passes.map((row) => row.name).join(", ")} passed them.`);
      }
    }
    status.textContent = texts.join(" ");
    status.classList.toggle("warning", Boolean(trajectory.ended));
  }

  const observer = new ResizeObserver(() => {
    for (const { chart, canvas } of made) {
      const width = canvas.clientWidth;
      if (width > 0 && width !== chart.width) chart.setSize({ width, height: chart.height });
    }
    move();
  });
  const observe = () => made.forEach(({ canvas }) => observer.observe(canvas));

  const section = element("section", { class: "panel", "aria-label": "Plots" }, element("div", { class: "bar" }, legend, save), status, grid);
  model.on("trajectory units theme", () => section.isConnected && build());
  model.on("time", move);
  return { section, build };
}

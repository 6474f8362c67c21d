// The numbers of the state that is shown.

import { datum, element, indexed, show } from "./dom.js";
import { plain } from "./format.js";
import { rollPitchYaw } from "./frames.js";
import { positionOf } from "./moving_base.js";

/** A table in a box that scrolls by itself. */
export function scrolled(label, table) {
  return element("div", { class: "scroll", role: "region", tabIndex: 0, "aria-label": label }, table);
}

/** A table of numbers below a caption, if there is one: the cells of each line. */
const grid = (caption, lines, kind = "") =>
  element(
    "table",
    { class: `numbers${kind}` },
    caption && element("caption", {}, caption),
    element("tbody", {}, lines.map((cells) => element("tr", {}, cells))),
  );
const head = (...content) => element("th", { scope: "row" }, content);
const sign = (text) => element("i", {}, text);
const unit = (text, kind = "") => element("td", { class: `unit${kind}` }, text);

/** The panel of numbers. */
export function numbers(model) {
  const { joints, freedoms, ofBase, table } = model;
  const hasFriction = table.rows.some((row) => row.viscous || row.coulomb.some(Boolean) || row.stribeck);
  const hasSpring = table.rows.some((row) => row.spring);
  const columns = [
    { key: "q", sign: "q", unit: "position", isAngle: true },
    { key: "qd", sign: "q̇", unit: "velocity", isAngle: true },
    { key: "qdd", sign: "q̈", unit: "acceleration", isAngle: true },
    { key: "tau", sign: "τ", unit: "force" },
    { key: "coriolis", sign: "V", unit: "force" },
    { key: "gravity", sign: "G", unit: "force" },
    ...(hasSpring ? [{ key: "spring", sign: "K", unit: "force" }] : []),
    ...(hasFriction ? [{ key: "friction", sign: "F", unit: "force" }] : []),
  ];
  const data = new Map();
  const cell = (key) => {
    const made = datum(key);
    data.set(key, made);
    return element("td", {}, made);
  };
  const types = [...new Set(freedoms.map((row) => row.type))];
  const unitCells = columns.map(() => element("th", { class: "unit", scope: "col" }));
  const states = element(
    "table",
    { class: "numbers wide" },
    element("caption", {}, "State and forces"),
    element(
      "thead",
      {},
      element("tr", {}, element("th", { scope: "col" }, "joint"), columns.map((column) => element("th", { scope: "col" }, sign(column.sign)))),
      element("tr", {}, element("th", { class: "unit", scope: "col" }, ""), unitCells),
    ),
    element(
      "tbody",
      {},
      freedoms.map((row, i) => {
        const joint = i - ofBase;
        const name = head(element("span", { class: "dot" }), joint < 0 ? ["base ", indexed(row.velocity, row.axis)] : row.name);
        name.style.setProperty("--color", joint < 0 ? `var(--axis-${row.axis})` : `var(--joint-${joint % 8})`);
        // A freedom of the base has no coordinate.
        const cells = columns.map(({ key }) => (key !== "q" ? cell(`${key}-${i}`) : joint < 0 ? element("td") : cell(`q-${joint}`)));
        return element("tr", {}, name, cells);
      }),
    ),
  );

  const isMixed = types.length > 1;
  const massUnit = isMixed ? "kg m², kg m, kg" : types[0] === "revolute" ? "kg m²" : "kg";
  const mass = grid(
    ["Mass matrix ", sign("M"), `, ${massUnit}`],
    freedoms.map((_, i) => freedoms.map((__, j) => cell(`mass-${i}-${j}`))),
    " matrix",
  );

  const tipName = element("span", {}, "Tip");
  const AXES = ["x", "y", "z"];
  /** A frame in the world, as a position and three angles under these keys. */
  const poseTable = (name, position, angle) =>
    grid(
      [name, " in the world"],
      AXES.map((axis, k) => [
        ...[head(sign(axis)), cell(position(k)), unit("m")],
        ...[head(["roll", "pitch", "yaw"][k]), cell(angle(k)), unit(null, " angle")],
      ]),
    );
  const pose = poseTable(tipName, (k) => `tip-${k}-3`, (k) => `rpy-${k}`);
  const basePose = ofBase > 0 ? poseTable("Base", (k) => `base-${k}`, (k) => `baserpy-${k}`) : null;
  const entries = [0, 1, 2, 3].map((i) => [0, 1, 2, 3].map((j) => cell(`T-${i}-${j}`)));
  const rotation = element(
    "details",
    {},
    element("summary", {}, "Transform of the tip, 4 × 4"),
    scrolled("Transform of the tip", grid(null, entries, " matrix")),
  );
  const kinds = Object.entries({ T: "kinetic", U: "potential", "T + U": "total" });
  const energies = grid("Energies, J", kinds.map(([of, key]) => [head(sign(of)), cell(key)]));

  /** Momentum of a robot whose base moves. */
  const momenta = () =>
    grid(
      ["Momentum in the world; ", sign("L"), " about the centre of mass"],
      AXES.map((axis, k) => [
        ...[head(indexed("p", axis)), cell(`linear-${k}`), unit("kg m/s")],
        ...[head(indexed("L", axis)), cell(`angular-${k}`), unit("kg m²/s")],
      ]),
    );

  const put = (key, value, factor = 1) => show(data.get(key), value, plain(value * factor));
  function update() {
    const { units } = model;
    const found = model.evaluated();
    if (table.tips.length > 1) tipName.textContent = model.tip().name;
    columns.forEach(({ key, isAngle }) => {
      const rows = key === "q" ? joints : freedoms;
      rows.forEach((row, i) => put(`${key}-${i}`, found[key][i], isAngle ? units.factor(row.type) : 1));
    });
    const diagonal = found.mass.map((line, i) => Math.abs(line[i]));
    freedoms.forEach((_, i) =>
      freedoms.forEach((__, j) => {
        put(`mass-${i}-${j}`, found.mass[i][j]);
        // How strongly two joints are coupled: |M_ij| / sqrt(M_ii M_jj), at most 1.
        const share = Math.abs(found.mass[i][j]) / Math.sqrt(diagonal[i] * diagonal[j]);
        const shown = data.get(`mass-${i}-${j}`).parentElement;
        shown.style.setProperty("--share", Number.isFinite(share) ? Math.min(share, 1).toFixed(3) : 0);
      }),
    );
    found.tip.forEach((line, i) => line.forEach((value, j) => put(`T-${i}-${j}`, value)));
    [0, 1, 2].forEach((k) => put(`tip-${k}-3`, found.tip[k][3]));
    rollPitchYaw(found.tip).forEach((angle, k) => put(`rpy-${k}`, angle, units.factor("revolute")));
    if (found.base) {
      positionOf(found.base).forEach((x, k) => put(`base-${k}`, x));
      for (const kind of ["linear", "angular"]) found.momentum[kind].forEach((x, k) => put(`${kind}-${k}`, x));
      const rows = [0, 3, 6].map((k) => found.base.slice(k, k + 3));
      rollPitchYaw(rows).forEach((angle, k) => put(`baserpy-${k}`, angle, units.factor("revolute")));
    }
    put("kinetic", found.kinetic);
    put("potential", found.potential);
    put("total", found.kinetic + found.potential);
  }
  function label() {
    columns.forEach(({ unit }, k) => {
      unitCells[k].textContent = types.map((type) => model.units[unit](type)).join(", ");
    });
    blocks.querySelectorAll(".angle").forEach((text) => (text.textContent = model.units.angleUnit));
    update();
  }
  const blocks = element(
    "div",
    { class: "blocks" },
    scrolled("Mass matrix", mass),
    basePose && scrolled("Pose of the base", basePose),
    scrolled("Pose of the tip", pose),
    scrolled("Energies", energies),
    ofBase > 0 ? scrolled("Momentum", momenta()) : null,
  );
  model.on("units", label);
  model.on("time tip", update);
  label();
  return element(
    "section",
    { class: "panel", "aria-label": "Numbers" },
    scrolled("State and forces", states),
    blocks,
    rotation,
  );
}


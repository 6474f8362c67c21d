// The table of the arm: a row for each joint, with its limits and its body.

import { COLORS } from "./annotations.js";
import { drawn } from "./arm.js";
import { element, indexed } from "./dom.js";
import { short } from "./format.js";
import { composed } from "./frames.js";
import { scrolled } from "./numbers.js";

const SIGNS = { theta: "θ", d: "d", a: "a", alpha: "α" };

/** The columns of a convention in the order in which its rows are read. */
const ORDER = { standard: ["theta", "d", "a", "alpha"], modified: ["alpha", "a", "d", "theta"] };

const vector = (values, digits = 4) => values.map((x) => short(x, digits)).join(", ");

/** The table panel. */
export function tablePanel(model) {
  const { table, state } = model;
  const links = drawn(table);
  const columns = table.isMounted ? ["xyz", "rpy", "axis"] : ORDER[table.convention];
  const hasLimits = table.rows.some((row) => row.limits);
  const hasMotors = table.rows.some((row) => row.gearRatio !== 0 && row.motorInertia !== 0);
  const hasForces = table.rows.some((row) => row.viscous || row.coulomb.some(Boolean) || row.stribeck || row.spring);
  const bodies = element("input", { type: "checkbox", "data-key": "bodies" });
  const head = element("thead");
  const body = element("tbody");
  const caption = element("caption");

  function header() {
    const { angleUnit } = model.units;
    const isPrevious = (name) => table.convention === "modified" && (name === "a" || name === "alpha");
    const heads = columns.map((name) => {
      if (table.isMounted) {
        const unit = { xyz: "m", rpy: angleUnit, axis: "" }[name];
        return element("th", { scope: "col" }, name, " ", element("span", { class: "unit" }, unit));
      }
      const swatch = element("span", { class: "swatch" });
      swatch.style.background = COLORS[name];
      const unit = name === "a" || name === "d" ? "m" : angleUnit;
      const sign = indexed(SIGNS[name], isPrevious(name) ? "i−1" : "i");
      return element("th", { scope: "col" }, swatch, sign, " ", element("span", { class: "unit" }, unit));
    });
    if (hasLimits) heads.push(element("th", { scope: "col" }, "limits"));
    heads.push(element("th", { scope: "col" }, "mass ", element("span", { class: "unit" }, "kg")));
    if (bodies.checked) {
      heads.push(element("th", { scope: "col" }, "centre of mass ", element("span", { class: "unit" }, "m")));
      heads.push(element("th", { scope: "col" }, "inertia xx, yy, zz, xy, yz, xz ", element("span", { class: "unit" }, "kg m²")));
      if (hasMotors) heads.push(element("th", { scope: "col" }, "motor"));
      if (hasForces) heads.push(element("th", { scope: "col" }, "friction, spring"));
    }
    head.replaceChildren(element("tr", {}, element("th", { scope: "col" }, "joint"), heads));
  }

  /** The variable of a row: the joint's own, or that of the one it follows. */
  function variable(row) {
    if (row.joint !== null) return indexed("q", row.joint + 1);
    if (!row.follows) return null;
    const { joint, factor, offset } = row.follows;
    const times = factor === 1 ? "" : factor === -1 ? "-" : `${short(factor)} `;
    const plus = offset === 0 ? "" : ` ${offset < 0 ? "-" : "+"} ${short(Math.abs(offset))}`;
    return [times, ...indexed("q", joint + 1), plus];
  }

  function cellOf(row, name) {
    const { cell } = model.units;
    if (table.isMounted) {
      const { places, axis } = row.mount;
      // Fixed joints on the chain are places of their own.
      const place = composed(places);
      const [azimuth, polar] = axis;
      const way = [Math.sin(polar) * Math.cos(azimuth), Math.sin(polar) * Math.sin(azimuth), Math.cos(polar)];
      const texts = { xyz: vector(place.xyz), rpy: place.rpy.map(cell).join(", "), axis: vector(way.map((x) => (Math.abs(x) < 1e-12 ? 0 : x))) };
      return element("td", {}, name === "axis" && row.isPlace ? "" : texts[name]);
    }
    const isAngle = name === "theta" || name === "alpha";
    const value = isAngle ? cell(row[name]) : short(row[name], 6);
    const text = row.text[name];
    const isVariable = name === (row.type === "prismatic" ? "d" : "theta");
    const sign = isVariable ? variable(row) : null;
    const constant = text ? [element("i", {}, text), element("span", { class: "unit" }, ` = ${value}`)] : [value];
    if (sign) return element("td", { class: "variable" }, sign, row[name] === 0 && !text ? null : [" + ", constant]);
    if (isVariable && row.locked !== null && !row.isPlace) {
      const held = row[name] + row.locked;
      return element("td", {}, isAngle ? cell(held) : short(held, 6), " ", element("span", { class: "kind" }, "locked"));
    }
    return element("td", {}, constant);
  }

  function forces(row) {
    const { viscous, coulomb, stribeck, spring } = row;
    const isSame = coulomb[0] === coulomb[1];
    return [
      viscous ? `viscous ${short(viscous)}` : null,
      coulomb.some(Boolean) ? `Coulomb ${isSame ? short(coulomb[0]) : `+${short(coulomb[0])} / -${short(coulomb[1])}`}` : null,
      stribeck ? `static ${short(stribeck.friction)} below ${short(stribeck.velocity)}` : null,
      spring ? `spring ${short(spring.stiffness)} at ${short(spring.rest)}` : null,
    ]
      .filter(Boolean)
      .join(", ");
  }

  const placeText = ({ xyz, rpy }) => `xyz ${vector(xyz)} m, rpy ${rpy.map(model.units.cell).join(", ")} ${model.units.angleUnit}`;
  const carrier = (on) => (on === null ? "the base" : table.rows[on].name);

  /** What a joint is; in a table without joint variables, where it is held and what it follows too. */
  function kind(row, now) {
    if (row.follows) return table.isMounted ? ["follows ", variable(now)] : "follows";
    if (row.locked === null) return row.type;
    if (!table.isMounted) return "locked";
    return `locked at ${short(now.locked * model.units.factor(row.type))} ${model.units.position(row.type)}`;
  }

  function rowOf({ row, index }) {
    const now = model.table.rows[index];
    const { factor, position } = model.units;
    const color = row.joint ?? row.follows?.joint;
    const name = element("th", { scope: "row" });
    if (row.isPlace) name.append("tip");
    else {
      const button = element("button", { type: "button", class: "name", onclick: () => model.select(index) });
      button.append(element("span", { class: "dot" }), row.name || "fixed", " ");
      button.append(element("span", { class: "kind" }, kind(row, now)));
      if ((row.on ?? -1) !== index - 1) button.append(element("span", { class: "kind" }, ` on ${carrier(row.on)}`));
      const steps = table.isMounted ? [] : now.step.map((place) => `, at ${placeText(place)}`);
      button.append(element("span", { class: "kind" }, ...steps));
      name.append(button);
    }
    name.style.setProperty("--color", color === undefined ? "var(--muted)" : `var(--joint-${color % 8})`);
    const cells = columns.map((column) => cellOf(now, column));
    if (hasLimits) {
      const times = factor(row.type);
      const ends = now.limits?.map((x) => short(x * times));
      cells.push(element("td", {}, ends ? `${ends[0]} … ${ends[1]} ${position(row.type)}` : ""));
    }
    cells.push(element("td", {}, now.text.mass ? [element("i", {}, now.text.mass), ` = ${short(now.mass)}`] : short(now.mass)));
    if (bodies.checked) {
      cells.push(element("td", {}, vector(now.com)), element("td", {}, vector(now.inertia)));
      const { motorInertia, gearRatio } = now;
      if (hasMotors) cells.push(element("td", {}, motorInertia ? `${short(motorInertia)} kg m² × ${short(gearRatio)}²` : ""));
      if (hasForces) cells.push(element("td", {}, forces(now)));
    }
    return element("tr", { "data-row": index }, name, cells);
  }

  /** A row of what is fixed before the first joint or behind the last one. */
  function placedRow(name, place, mass) {
    const cells = [element("td", { colSpan: columns.length + (hasLimits ? 1 : 0) }, placeText(place)), element("td", {}, mass)];
    if (bodies.checked) cells.push(element("td", { colSpan: 4 }, place.com ? vector(place.com) : ""));
    return element("tr", { class: "placed" }, element("th", { scope: "row" }, name), cells);
  }

  /** The row of a base that moves, with its body. */
  function movingRow({ mass, com, inertia }) {
    const cells = [element("td", { colSpan: columns.length + (hasLimits ? 1 : 0) }, "moves freely"), element("td", {}, short(mass))];
    if (bodies.checked) cells.push(element("td", {}, vector(com)), element("td", {}, vector(inertia)));
    return element("tr", { class: "placed" }, element("th", { scope: "row" }, "base"), cells);
  }

  function build() {
    const { base, floating, tool } = model.table;
    header();
    const rows = links.map(rowOf);
    if (base) rows.unshift(placedRow("base", base, ""));
    if (floating) rows.unshift(movingRow(floating));
    if (tool) rows.push(placedRow("tool", tool, short(tool.mass)));
    for (const { name, on, places, body: fixed } of model.table.tips.filter((tip) => tip.isFrame && tip.places.length === 1)) {
      rows.push(placedRow(`${name} on ${carrier(on)}`, { ...places[0], com: fixed?.com }, fixed ? short(fixed.mass) : ""));
    }
    body.replaceChildren(...rows);
    caption.textContent = table.isMounted
      ? "Joints as the file places them"
      : `Denavit-Hartenberg table, ${table.convention} convention`;
    mark();
  }
  function mark() {
    for (const row of body.children) row.classList.toggle("selected", Number(row.dataset.row) === state.selected);
  }
  bodies.addEventListener("change", build);
  model.on("fields units", build);
  model.on("selection", mark);
  build();
  return element(
    "section",
    { class: "panel table", "aria-label": "Table" },
    scrolled("Table of the arm", element("table", { class: "cells" }, caption, head, body)),
    element("label", { class: "check" }, bodies, "bodies, motors, friction"),
  );
}

// Where the tip is to be, and all solutions that are found for it.

import { element } from "./dom.js";
import { plain, short } from "./format.js";
import { PLACES } from "./moving_base.js";
import { scrolled } from "./numbers.js";
import { slider } from "./slider.js";

/** Sliders of the target. */
function targetSliders(model) {
  const { state, size } = model;
  return PLACES.slice(0, state.hasRotation ? 6 : 3).map(({ name, type }, k) => {
    const most = type === "revolute" ? Math.PI : 1.2 * size;
    return slider({
      label: name,
      key: `target-${k}`,
      about: `target, ${name}`,
      min: () => -most,
      max: () => most,
      get: () => state.target[k],
      set(value) {
        state.target[k] = value;
        model.seek();
      },
      factor: () => model.units.factor(type),
      unit: () => model.units.position(type),
    });
  });
}

/** The target's sliders, and the table of solutions below them. */
export function reachPanel(model) {
  const { state, joints } = model;
  const sliders = targetSliders(model);
  const check = element("input", { type: "checkbox", checked: state.hasRotation, "data-key": "rotation" });
  check.addEventListener("change", () => {
    state.hasRotation = check.checked;
    model.seek();
    model.tell("mode");
  });
  const head = element(
    "div",
    { class: "head" },
    element("span", { class: "name" }, element("b", {}, "target"), ` of ${model.tip().name}`),
    element("label", { class: "check" }, check, "with its rotation"),
  );
  const said = element("p", { class: "said", "data-key": "reached", role: "status" });
  const table = element("table", { class: "numbers solutions" });

  const button = (text, key, called) => element("button", { type: "button", class: "chip", "data-key": key, onclick: called }, text);
  const row = (q, k) =>
    element(
      "tr",
      { class: k === state.reached.chosen ? "chosen" : "" },
      element("th", { scope: "row" }, String(k + 1)),
      element("td", {}, button("start", `start-${k}`, () => model.choose(k, true)), button("end", `solution-${k}`, () => model.choose(k))),
      q.map((x, i) => element("td", {}, element("data", { value: String(x), title: String(x) }, plain(x * model.units.factor(joints[i].type))))),
    );
  function list() {
    const { found, missing } = state.reached;
    table.hidden = found.length === 0;
    const heads = ["", "of the motion", ...joints.map(({ name, type }) => `${name}, ${model.units.position(type)}`)];
    table.replaceChildren(
      element("thead", {}, element("tr", {}, heads.map((text) => element("th", { scope: "col" }, text)))),
      element("tbody", {}, found.map(row)),
    );
    said.classList.toggle("refused", missing !== null);
    said.textContent = missing ? told(missing) : `${found.length} ${found.length === 1 ? "solution" : "solutions"} found: ${aim()}.`;
  }
  function aim() {
    if (state.reached.chosen >= 0) return "the motion goes to that which is marked";
    return model.trajectory.ended ? "the motion does not come to any" : "the straight line ends at positions that are none of these";
  }
  function told({ way, turn }) {
    const { factor, angleUnit } = model.units;
    const angle = 2 * Math.asin(Math.min(1, turn / 2)) * factor("revolute");
    const turned = state.hasRotation ? ` and ${short(angle, 3)} ${angleUnit}` : "";
    return `No solution found: ${short(way, 3)} m${turned} are missing at the nearest positions, to which the motion goes.`;
  }
  function show() {
    sliders.forEach((one) => one.show());
    list();
  }
  show();
  const group = element("div", { class: "joint base" }, head, sliders.map((one) => one.row), said, scrolled("Solutions", table));
  return { group, show };
}

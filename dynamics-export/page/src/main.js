// The page of a robot. What stands in front of this script has put its functions and its table into
// global variables.

import "uplot/dist/uPlot.min.css";
import "./page.css";

import { controls } from "./controls.js";
import { element } from "./dom.js";
import { short } from "./format.js";
import { createModel } from "./model.js";
import { numbers } from "./numbers.js";
import { plots } from "./plots.js";
import { stage } from "./stage.js";
import { tablePanel } from "./table.js";

const THEMES = ["auto", "light", "dark"];

/** The line below the name. */
function summary({ floating, convention, isMounted, gravity }, joints) {
  const types = joints.map(({ type }) => (type === "revolute" ? "R" : "P")).join("");
  const g = gravity.map((x) => short(x)).join(", ");
  const table = isMounted ? "joints of a URDF file" : `${convention} D-H table`;
  const moving = floating ? ["a base that moves"] : [];
  const count = joints.length === 0 ? [] : [`${joints.length} ${joints.length === 1 ? "joint" : "joints"} (${types})`, table];
  return [...moving, ...count, `gravity (${g}) m/s²`].join(", ");
}

function header(model) {
  const theme = element("button", { type: "button", class: "quiet", "data-key": "theme" });
  let chosen = 0;
  const put = () => {
    document.documentElement.dataset.theme = THEMES[chosen];
    theme.textContent = `Colors: ${THEMES[chosen]}`;
  };
  theme.addEventListener("click", () => {
    chosen = (chosen + 1) % THEMES.length;
    put();
    model.tell("theme");
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => model.tell("theme"));
  put();
  const unit = element("button", { type: "button", class: "quiet", "data-key": "units" });
  const label = () => (unit.textContent = `Angles: ${model.units.inDegrees ? "degrees" : "radians"}`);
  unit.addEventListener("click", () => model.setUnits(!model.units.inDegrees));
  model.on("units", label);
  label();
  return element(
    "header",
    {},
    element("div", {}, element("h1", {}, model.table.name), element("p", { class: "said" }, summary(model.table, model.joints))),
    element("div", { class: "switches" }, unit, theme),
  );
}

const model = createModel(globalThis.robotTable, globalThis.robotEquations, globalThis.robotStart);
const picture = stage(model);
const curves = plots(model);
document.getElementById("page").append(
  header(model),
  element(
    "main",
    {},
    element("div", { class: "column fixed" }, picture.section, tablePanel(model)),
    element("div", { class: "column" }, controls(model), numbers(model), curves.section),
  ),
  element(
    "footer",
    {},
    "M, V, G, τ and the motion are computed in this page by functions that robot-dynamics has proven equal to the textbook Lagrangian. SI units.",
  ),
);
picture.start();
curves.build();
// For tests, and whoever looks at a page with the tools of a browser.
globalThis.robotPage = model;
document.documentElement.dataset.ready = "true";

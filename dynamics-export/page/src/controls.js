// What can be set: kind of motion, sliders of the joints and of the fields.

import { element } from "./dom.js";
import { short } from "./format.js";
import { baseSliders, jointSliders } from "./freedom_sliders.js";
import { lawsOf } from "./laws.js";
import { reachPanel } from "./reach_panel.js";
import { slider } from "./slider.js";

/** The shortest and the longest motion, s, as on the command line. */
const DURATIONS = [1e-3, 1000];

const MODES = { motion: "Motion", reach: "Reach", free: "Free motion", pose: "Pose" };
const SAID = {
  motion: "From start to end, from rest to rest; inverse dynamics gives the torques.",
  reach: "From the start to where the tip is at the target, dragged in the picture or typed: inverse kinematics, then inverse dynamics.",
  free: "From the start under given torques; forward dynamics gives the motion.",
  pose: "One state; inverse dynamics gives the torques that it takes.",
};
const SAID_OF_BASE = {
  motion: "The base is held where it is, and the joints go from start to end, from rest to rest; inverse dynamics gives the torques, and the force and the moment that hold the base.",
  reach: "The base is held where it is. From the start to where the tip is at the target, dragged in the picture or typed: inverse kinematics, then inverse dynamics.",
  free: "Base and joints move freely from the start; forward dynamics gives the motion.",
  pose: "One state; inverse dynamics gives the torques that it takes, and the force and the moment on the base.",
};

/** A slider of a field. */
function fieldSlider(model, { name, value, unit }) {
  const isAngle = unit === "rad";
  const [low, high] = isAngle ? [-Math.PI, Math.PI] : value < 0 ? [3 * value, 0] : [0, 3 * value || 1];
  return slider({
    label: element("i", {}, name),
    key: `field-${name}`,
    about: unit ? `field ${name}` : `field ${name}, without unit`,
    min: () => low,
    max: () => high,
    get: () => model.fields[name],
    set: (x) => model.setFields({ [name]: x }),
    factor: () => (isAngle ? model.units.factor("revolute") : 1),
    unit: () => (isAngle ? model.units.angleUnit : unit),
  });
}

/** A choice among named values. */
function choice({ about, key, options, get, set }) {
  const items = Object.entries(options).map(([value, text]) => element("option", { value }, text));
  const select = element("select", { "data-key": key, onchange: () => set(select.value) }, items);
  select.value = get();
  return element("label", { class: "choice" }, element("span", {}, about), select);
}

/** The heading above a joint with which a branch begins: on which link it stands. */
function branchOf({ rows }, index) {
  const { on } = rows[index];
  const isFork = rows.filter((row) => !row.isPlace && row.on === on).length > 1;
  return isFork || (on ?? -1) !== index - 1 ? `on ${on === null ? "the base" : rows[on].name}` : null;
}

/** The panel of all that can be set. */
export function controls(model) {
  const { state, joints, first } = model;
  const sliders = [];
  const modes = Object.entries(MODES).filter(([mode]) => mode !== "reach" || joints.length > 0);
  const tabs = modes.map(([mode, text]) =>
    element("button", { type: "button", role: "tab", "data-key": `mode-${mode}`, onclick: () => model.setMode(mode) }, text),
  );
  const list = element("div", { class: "tabs", role: "tablist", "aria-label": "Kind of motion" }, tabs);
  list.addEventListener("keydown", ({ key }) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[key];
    if (!step) return;
    const at = tabs.findIndex((tab) => tab.getAttribute("aria-selected") === "true");
    const next = tabs[(at + step + tabs.length) % tabs.length];
    next.focus();
    next.click();
  });
  const said = element("p", { class: "said" });
  const settings = element("div", { class: "settings" });
  const rows = element("div", { class: "joints" });
  const panel = element("div", { role: "tabpanel" }, said, settings, rows);

  const [shortest, longest] = DURATIONS;
  const duration = element("input", { type: "number", min: shortest, max: longest, step: "any", "data-key": "duration" });
  const refusedDuration = element("p", { class: "refused", role: "alert" });
  duration.addEventListener("change", () => {
    const seconds = Number(duration.value);
    const isPossible = seconds >= shortest && seconds <= longest;
    refusedDuration.textContent = isPossible ? "" : `expected a number from ${shortest} to ${longest}`;
    if (isPossible) state.duration = seconds;
    duration.value = state.duration;
    model.changed();
  });

  const profiles = { cycloidal: "cycloidal", quintic: "quintic polynomial", cubic: "cubic polynomial" };
  const paths = { joints: "each joint by itself", line: "straight line of the tip" };
  const laws = lawsOf(model.table);
  const texts = model.table.floating ? SAID_OF_BASE : SAID;
  const hasFriction = model.table.rows.some(
    (row) => row.viscous !== 0 || row.coulomb.some((force) => force !== 0) || row.stribeck,
  );

  let reaching = null;
  function build() {
    tabs.forEach((tab) => {
      const isSelected = tab.dataset.key === `mode-${state.mode}`;
      tab.setAttribute("aria-selected", isSelected);
      tab.tabIndex = isSelected ? 0 : -1;
    });
    said.textContent = texts[state.mode];
    duration.value = state.duration;
    const asked = [];
    if (state.mode !== "pose") {
      asked.push(element("label", { class: "choice" }, element("span", {}, "duration, s"), duration), refusedDuration);
    }
    const ask = (about, key, options) => {
      const set = (value) => {
        state[key] = value;
        // Under other laws there are other sliders.
        if (key === "law") build();
        model.changed();
      };
      asked.push(choice({ about, key, options, get: () => state[key], set }));
    };
    if (state.mode === "motion" || state.mode === "reach") ask("profile", "profile", profiles);
    if (state.mode === "reach") ask("way", "path", paths);
    if (state.mode === "free") {
      ask("torques", "law", laws);
      if (hasFriction) {
        const check = element("input", { type: "checkbox", checked: state.hasFriction, "data-key": "friction" });
        check.addEventListener("change", () => {
          state.hasFriction = check.checked;
          model.changed();
        });
        asked.push(element("label", { class: "check" }, check, "friction"));
      }
    }
    settings.replaceChildren(...asked);
    sliders.length = 0;
    reaching = state.mode === "reach" ? reachPanel(model) : null;
    rows.replaceChildren(
      ...(reaching ? [reaching.group] : []),
      ...(model.table.floating ? [baseGroup()] : []),
      ...joints.flatMap((row, joint) => {
        const made = jointSliders(model, joint).map(slider);
        sliders.push(...made);
        const index = model.table.rows.findIndex((other) => other.joint === joint);
        const name = element("button", { type: "button", class: "name", onclick: () => model.select(index) });
        name.append(element("span", { class: "dot" }), element("b", {}, String(joint + 1)), ` ${row.name}`);
        const kind = element("span", { class: "kind" }, row.type);
        const limits = element("span", { class: "kind limits" });
        const head = element("div", { class: "head" }, name, kind, limits);
        const group = element("div", { class: "joint", "data-joint": joint }, head, made.map((one) => one.row));
        group.addEventListener("focusin", () => model.select(index));
        const branch = branchOf(model.table, index);
        return branch === null ? group : [element("h3", { class: "branch" }, branch), group];
      }),
    );
    mark();
    limited();
  }

  function baseGroup() {
    const made = baseSliders(model).map(slider);
    sliders.push(...made);
    const name = element("span", { class: "name" }, element("b", {}, "base"));
    const kind = element("span", { class: "kind" }, "velocities and forces in its own axes");
    return element("div", { class: "joint base" }, element("div", { class: "head" }, name, kind), made.map((one) => one.row));
  }

  function limited() {
    const { factor, position } = model.units;
    rows.querySelectorAll(".limits").forEach((text, joint) => {
      const { limits, type } = joints[joint];
      const ends = limits?.map((x) => short(x * factor(type), 4));
      text.textContent = ends ? `${ends[0]} to ${ends[1]} ${position(type)}` : "no limits";
    });
  }

  function mark() {
    rows.querySelectorAll("[data-joint]").forEach((group, joint) => {
      const { selected } = state;
      group.classList.toggle("selected", model.table.rows[selected]?.joint === joint);
      group.style.setProperty("--color", `var(--joint-${joint % 8})`);
    });
  }

  const fields = first.fields.map((field) => fieldSlider(model, field));
  const parameters = element("div", { class: "fields" }, element("h3", {}, "Parameters"), fields.map((one) => one.row));
  model.on("mode", build);
  model.on("units", () => {
    [...sliders, ...fields, ...(reaching ? [reaching] : [])].forEach((one) => one.show());
    limited();
  });
  model.on("selection", mark);
  model.on("reached", () => {
    sliders.forEach((one) => one.show());
    reaching?.show();
  });
  model.on("tip", () => state.mode === "reach" && build());
  build();

  const reset = element("button", {
    type: "button",
    class: "quiet",
    onclick() {
      const zero = (name) => state[name].fill(0);
      ["qdd", "torque"].forEach(zero);
      ["pose", "qd"].forEach((name) => initial[name].forEach((x, i) => (state[name][i] = x)));
      const { from, to, duration: seconds } = first;
      initial.q.forEach((q, i) => (state.q[i] = from?.[i] ?? q));
      initial.end.forEach((q, i) => (state.end[i] = to?.[i] ?? q));
      state.duration = seconds;
      model.setFields(Object.fromEntries(first.fields.map(({ name, value }) => [name, value])));
      build();
      fields.forEach((one) => one.show());
      model.changed();
    },
  });
  reset.append("Reset");
  const initial = { q: [...state.q], end: [...state.end], pose: [...state.pose], qd: [...state.qd] };
  return element(
    "section",
    { class: "panel controls", "aria-label": "Settings" },
    element("div", { class: "bar" }, list, reset),
    panel,
    first.fields.length > 0 ? parameters : null,
  );
}

// Settings of a joint, and of a base that moves: where it is, how it moves, and what acts on it.

import { indexed } from "./dom.js";
import { PLACES } from "./moving_base.js";

const DOT = "\u0307";
const between = (most) => ({ min: () => -most, max: () => most });

/** How an entry of the state is read and set. */
const entry = ({ state, changed }, name, i) => ({
  get: () => state[name][i],
  set(value) {
    state[name][i] = value;
    changed();
  },
});

/** A length or an angle. */
const place = ({ units }, type) => ({
  factor: () => units().factor(type),
  unit: () => units().position(type),
});

/** What sliders need of the model; its units are those of the moment. */
const given = (model) => ({ state: model.state, changed: model.changed, units: () => model.units });

/** Velocity of a freedom, and what acts on it or its acceleration where these are given. */
function rates(model, freedom, { signs, name, most }) {
  const { state } = model;
  const { type } = model.freedoms[freedom];
  const of = given(model);
  const velocity = {
    ...between(2 * most.speed),
    ...place(of, type),
    ...entry(of, "qd", freedom),
    unit: () => model.units.velocity(type),
    label: signs.velocity,
    key: `qd-${freedom}`,
    about: `${name}, velocity${state.mode === "pose" ? "" : " at the start"}`,
  };
  if (state.mode === "pose") {
    const acceleration = {
      ...velocity,
      ...between(4 * most.speed),
      ...entry(of, "qdd", freedom),
      unit: () => model.units.acceleration(type),
      label: signs.acceleration,
      key: `qdd-${freedom}`,
      about: `${name}, acceleration`,
    };
    return [velocity, acceleration];
  }
  if (state.law !== "constant") return [velocity];
  const torque = {
    ...between(most.force),
    ...entry(of, "torque", freedom),
    factor: () => 1,
    unit: () => model.units.force(type),
    label: signs.force,
    key: `tau-${freedom}`,
    about: `${name}, ${type === "revolute" ? "torque" : "force"}`,
  };
  return [velocity, torque];
}

/** The settings of one joint for a kind of motion. */
export function jointSliders(model, joint) {
  const { state } = model;
  const row = model.joints[joint];
  const [low, high] = model.ranges[joint];
  const of = given(model);
  const position = { min: () => low, max: () => high, ...place(of, row.type) };
  const start = {
    ...position,
    ...entry(of, "q", joint),
    label: state.mode === "motion" || state.mode === "reach" ? "start" : indexed("q", null),
    key: `q-${joint}`,
    about: `${row.name}, position${state.mode === "pose" ? "" : " at the start"}`,
  };
  if (state.mode === "reach") return [start];
  if (state.mode === "motion") {
    const end = { ...position, ...entry(of, "end", joint), label: "end", key: `end-${joint}`, about: `${row.name}, position at the end` };
    return [start, end];
  }
  const heaviest = Math.max(1, ...model.table.rows.map((body) => body.mass)) * 9.81;
  const signs = { velocity: indexed("q̇", null), acceleration: indexed("q̈", null), force: indexed("τ", null) };
  const most =
    row.type === "revolute" ? { speed: Math.PI, force: heaviest * model.size } : { speed: model.size, force: heaviest };
  return [start, ...rates(model, model.ofBase + joint, { signs, name: row.name, most })];
}

/** The settings of a base that moves. */
export function baseSliders(model) {
  const { state, size } = model;
  const of = given(model);
  const pose = PLACES.map(({ name, type }, k) => ({
    ...between(type === "revolute" ? Math.PI : Math.max(2 * size, 1)),
    ...place(of, type),
    ...entry(of, "pose", k),
    label: name,
    key: `pose-${k}`,
    about: `base, ${name}${state.mode === "free" ? " at the start" : ""}`,
  }));
  if (state.mode === "motion" || state.mode === "reach") return pose;
  const { rows, floating } = model.table;
  const weight = 9.81 * rows.reduce((sum, { mass }) => sum + mass, floating.mass);
  const each = model.freedoms.slice(0, model.ofBase).map(({ name, axis, velocity, force, type }, k) => {
    const signs = { velocity: indexed(velocity, axis), acceleration: indexed(`${velocity}${DOT}`, axis), force: indexed(force, axis) };
    const most = type === "revolute" ? { speed: Math.PI, force: weight * size } : { speed: Math.max(2 * size, 2), force: 2 * weight };
    return rates(model, k, { signs, name, most });
  });
  // All velocities, then all of what comes behind them.
  return [...pose, ...each.map(([first]) => first), ...each.flatMap(([, second]) => second ?? [])];
}

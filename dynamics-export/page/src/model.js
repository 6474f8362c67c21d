// The arm, what is asked of it, and its motion.

import { chain, reach } from "./chain.js";
import { bind, evaluate } from "./equations.js";
import { units } from "./format.js";
import { WORLD, placed, rollPitchYaw } from "./frames.js";
import { lineTrajectory } from "./line_trajectory.js";
import { FREEDOMS, poseOf } from "./moving_base.js";
import { approach, carrying, isSame, nearest, solutions } from "./reach.js";
import { refusal } from "./refusal.js";
import { events } from "./store.js";
import { freeTrajectory, prescribedTrajectory } from "./trajectory.js";

/** The longest time, ms, that a motion may take to be computed with every step of a slider. */
const PROMPT = 30;

/** How far a joint goes: its limits, or else a turn, or as far as the arm is long. */
function rangeOf(row, size) {
  if (row.limits) return row.limits;
  return row.type === "revolute" ? [-Math.PI, Math.PI] : [-size, size];
}

/** Where a joint begins: at zero, or in the middle of limits that zero is not in. */
function startOf([low, high]) {
  return low <= 0 && high >= 0 ? 0 : (low + high) / 2;
}

/** Velocities of a base that moves, so that a free fall is more than a fall: a spin, which does not last about one axis. */
const SPIN = [0, 0, 0, 0.1, 1.5, 0.3];

/** Degrees by which joints go on at first: not all alike, so that curves can be told apart. */
const STEPS = [60, 40, -50, 30, 70, -40];

/** Where a joint goes to: on by some degrees, or by a part of its way, back where its limits ask for it. */
function endOf(from, { type, joint }, [low, high]) {
  const turn = STEPS[joint % STEPS.length];
  const step = type === "revolute" ? (turn * Math.PI) / 180 : ((high - low) * turn) / 240;
  const [on, back] = [from + step, from - step];
  const isWithin = (q) => q >= low && q <= high;
  return isWithin(on) ? on : isWithin(back) ? back : step > 0 ? high : low;
}

/** The model of a page: `make` gives the table for values of the fields. */
export function createModel(make, module, first) {
  const { on, tell } = events();
  const values = Object.fromEntries(first.fields.map(({ name, value }) => [name, value]));
  const table = make(values);
  const isFloating = table.floating !== null;
  const equations = bind(module, values, isFloating);
  const slides = table.rows
    .filter((row) => row.type === "prismatic" && row.joint !== null)
    .reduce((sum, row) => sum + (row.limits ? Math.max(...row.limits.map(Math.abs)) : 0), 0);
  const size = reach(table, slides);
  const joints = table.rows.filter((row) => row.joint !== null);
  const ranges = joints.map((row) => rangeOf(row, size));
  const freedoms = [...(isFloating ? FREEDOMS : []), ...joints];
  const zeros = freedoms.map(() => 0);
  const from = first.from ?? ranges.map(startOf);

  const state = {
    mode: "motion",
    pose: [...(first.pose ?? [0, 0, 0, 0, 0, 0])],
    q: [...from],
    qd: [...(first.velocity ?? (isFloating ? [...SPIN, ...zeros.slice(SPIN.length)] : zeros))],
    qdd: [...zeros],
    end: first.to ?? from.map((q, i) => endOf(q, joints[i], ranges[i])),
    torque: [...zeros],
    /** Where the tip is to be: x, y, z, roll, pitch and yaw; and what is found for it. */
    target: null,
    hasRotation: true,
    path: "joints",
    reached: { found: [], chosen: -1, missing: null },
    isDragged: false,
    profile: "cycloidal",
    law: "none",
    hasFriction: true,
    duration: first.duration,
    t: 0,
    isPlaying: false,
    isRepeated: false,
    speed: 1,
    selected: table.rows.indexOf(joints[0]),
    tip: 0,
    show: { parameters: "selected", frames: false, axes: false, masses: false, trace: true, names: false, isFollowed: true },
  };

  const model = {
    on,
    tell,
    state,
    first,
    fields: values,
    equations,
    table,
    size,
    joints,
    /** What velocities have entries of: the freedoms of a base that moves, then the joints. */
    freedoms,
    ofBase: freedoms.length - joints.length,
    ranges,
    trajectory: null,
    units: units(true),

    /** The state that is shown. */
    now() {
      if (state.mode === "pose") {
        const { q, qd, qdd } = state;
        const base = model.start();
        return { base, q, qd, qdd, tau: equations.inverse_dynamics(base, q, qd, qdd) };
      }
      return model.trajectory.at(state.t);
    },
    /** Where a base that moves is at the start. */
    start: () => (isFloating ? poseOf(state.pose) : null),
    /** The tip, or the frame, whose way is shown. */
    tip: () => table.tips[state.tip],
    evaluated: () => evaluate(equations, model.now(), model.tip()),
    frames() {
      const { base, q } = model.now();
      return chain(model.table, q, base);
    },

    setTime(t) {
      const duration = model.trajectory?.duration ?? 0;
      state.t = Math.min(Math.max(t, 0), duration);
      tell("time");
    },

    play(isPlaying) {
      if (!model.trajectory) return;
      state.isPlaying = isPlaying;
      if (isPlaying && state.t >= model.trajectory.duration) model.setTime(0);
      tell("play");
    },

    /** What inverse kinematics is asked for. */
    problem() {
      const { hasRotation, tip, target } = state;
      const [x, y, z, ...rpy] = target;
      const frame = placed(WORLD, { xyz: [x, y, z], rpy });
      const limits = joints.map((row) => row.limits);
      return { table: model.table, base: model.start(), tip, target: frame, hasRotation, limits, ranges, joints, size };
    },

    /**
     * Solves for the target: all solutions, or while it `isDragged` the nearest one alone. The motion goes to the solution that is
     * nearest to its start, or to the present one where that is to be kept.
     */
    seek(isDragged = false) {
      solve(isDragged, false);
      state.isPlaying = false;
      model.recompute();
      model.setTime(model.trajectory.duration);
      tell("play");
    },

    /** The motion goes to one of the solutions, or begins there, whole turns removed. */
    choose(index, isStart = false) {
      const { found } = state.reached;
      if (isStart) nearest(model.problem(), found[index], ranges.map(startOf)).forEach((x, i) => (state.q[i] = x));
      else state.end = [...found[index]];
      model.changed();
    },

    /** The target becomes where the tip is at the end; its rotation is asked for where six joints carry the tip. */
    placeTarget() {
      const { tips } = chain(model.table, state.end, model.start());
      const { x, y, z, o } = tips[state.tip];
      state.hasRotation = carrying(model.table, state.tip) >= 6;
      state.target = [...o, ...rollPitchYaw([0, 1, 2].map((k) => [x[k], y[k], z[k]]))];
    },

    setMode(mode) {
      state.mode = mode;
      if (mode === "reach") {
        model.placeTarget();
        model.seek();
      }
      state.isPlaying = false;
      state.t = 0;
      if (mode !== "reach") model.recompute();
      tell("mode");
      tell("time");
      tell("play");
    },

    /** A setting of the start or of the motion has changed: time begins anew. */
    changed() {
      state.isPlaying = false;
      state.t = 0;
      tell("play");
      model.ask();
    },

    /** Gives fields other values; why not, where the table would be none of a robot. */
    setFields(changes) {
      const next = make({ ...values, ...changes });
      const reason = refusal(next, table);
      if (reason) return reason;
      Object.assign(values, changes);
      model.table = next;
      tell("fields");
      if (state.mode === "reach") model.seek();
      else model.changed();
      return null;
    },

    setUnits(inDegrees) {
      model.units = units(inDegrees);
      tell("units");
    },

    select(row) {
      state.selected = row;
      tell("selection");
    },

    setTip(tip) {
      state.tip = tip;
      if (state.mode === "reach") {
        model.placeTarget();
        model.seek();
      } else model.recompute();
      tell("tip");
    },

    setShown(changes) {
      Object.assign(state.show, changes);
      tell("show");
    },

    recompute() {
      const begin = performance.now();
      const { q, qd, end, torque, profile, law, hasFriction, duration } = state;
      const { table: current } = model;
      const base = model.start();
      const { key } = model.tip();
      const isReach = state.mode === "reach";
      model.trajectory =
        isReach && state.path === "line" && !state.isDragged
          ? lineTrajectory(equations, model.problem(), { base, from: [...q], duration, profile, key })
          : state.mode === "motion" || isReach
          ? prescribedTrajectory(equations, { base, from: [...q], to: [...end], duration, profile, key })
          : state.mode === "free"
            ? freeTrajectory(equations, {
                ...{ table: current, law, hasFriction, duration, key },
                ...{ base, q: [...q], qd: [...qd], torque: [...torque] },
              })
            : null;
      cost = performance.now() - begin;
      timer = undefined;
      if (isReach) mark();
      tell("trajectory");
      tell("time");
    },

    /** Whether the motion that is shown is still that of former settings. */
    isStale: () => timer !== undefined,

    /** Computes the motion anew, soon. */
    ask() {
      clearTimeout(timer);
      timer = setTimeout(
        () => {
          if (state.mode === "reach") solve(false, true);
          model.recompute();
        },
        cost > PROMPT || state.mode === "reach" ? 160 : 0,
      );
    },
  };

  /** The solutions for the target, by their distance from the start; the end is the first of them, or stays the one that it is. */
  function solve(isDragged, isKept) {
    const problem = model.problem();
    const { q: start, end } = state;
    state.isDragged = isDragged;
    if (isDragged) {
      const { q, isReached, ...missing } = approach(problem, end);
      state.end = nearest(problem, q, start);
      state.reached = { found: isReached ? [state.end] : [], chosen: -1, missing: isReached ? null : missing };
      return;
    }
    const { found, missing } = solutions(problem, start);
    const kept = isKept ? found.find((q) => isSame(problem, q, end)) : undefined;
    state.reached = { found, chosen: -1, missing };
    state.end = [...(kept ?? found[0] ?? missing.q)];
  }

  /** Marks the solution in which the motion ends. */
  function mark() {
    const { ended, q } = model.trajectory;
    const { reached } = state;
    reached.chosen = ended ? -1 : reached.found.findIndex((one) => isSame(model.problem(), one, q[q.length - 1]));
    tell("reached");
  }

  let [cost, timer] = [0, undefined];
  model.recompute();
  return model;
}

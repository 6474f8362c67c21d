// Motion under given torques: forward dynamics, integrated. Joints with dry friction stick and let go; the
// times at which they do are found, and between them the equations are smooth.

import { factor, trial } from "./dop853.js";
import { dryFriction } from "./dry_friction.js";
import { LAWS } from "./laws.js";
import { NotPositiveDefinite, solved } from "./linear.js";
import { Chart } from "./moving_base.js";

/** Evaluations of the forward dynamics after which a motion is given up. */
const MOST_EVALUATIONS = 600_000;

/** Events without a step between them that are chatter. */
const MOST_EVENTS = 200;

/** Why a motion cannot go on where M is singular: its number and name say which joint, behind the freedoms of the base. */
function singular(table, freedom) {
  const joint = freedom - (table.dof - table.joints);
  if (joint < 0) return "the mass matrix is singular at the base: no inertia resists its motion";
  const { name } = table.rows.find((row) => row.joint === joint);
  return `the mass matrix is singular at joint ${joint + 1}, \`${name}\`: no inertia resists its motion`;
}

/** Why a motion ends early. */
class Ended extends Error {}

/**
 * The equations of motion as rates of y: positions, velocities, and the work of torques and friction. Those of a base that
 * moves come first, its position by a chart.
 */
class Motion {
  constructor(equations, table, base, torque, hasFriction) {
    this.chart = base && new Chart(base);
    this.ofBase = table.dof - table.joints;
    this.equations = equations;
    this.torque = torque;
    this.hasFriction = hasFriction;
    this.dry = dryFriction(table);
    this.dof = table.dof;
    this.evaluations = 0;
    /** Of each freedom 1 or -1, the way it slides; 0 where it has no dry friction; null where it sticks. */
    this.contacts = new Array(table.dof).fill(0);
    this.sticks = hasFriction && this.dry.isDry.some(Boolean);
  }

  /** Friction of the joints that slide, by the way they do. */
  friction(qd) {
    if (!this.hasFriction) return qd.map(() => 0);
    return qd.map((speed, i) => {
      const way = this.contacts[i];
      return way === null ? 0 : this.dry.sliding(i, way || Math.sign(speed), speed);
    });
  }

  /** Accelerations, friction, and the forces that hold the joints that stick. */
  solve({ base, q, qd }) {
    if (++this.evaluations > MOST_EVALUATIONS) throw new Ended("it takes too many steps");
    const tau = this.torque(base, q, qd);
    const friction = this.friction(qd);
    if (!this.contacts.includes(null)) {
      const generated = this.equations.friction_vector(qd);
      // The generated function takes its own friction off.
      const applied = tau.map((x, i) => x + (generated[i] - friction[i]));
      return { tau, friction, qdd: this.equations.forward_dynamics(base, q, qd, applied), hold: null };
    }
    const zero = qd.map(() => 0);
    const generated = this.equations.friction_vector(qd);
    const bias = this.equations.inverse_dynamics(base, q, qd, zero).map((x, i) => x - generated[i]);
    const mass = this.equations.mass_matrix(q);
    const free = this.contacts.flatMap((contact, i) => (contact === null ? [] : [i]));
    const right = tau.map((x, i) => x - bias[i] - friction[i]);
    const qdd = zero;
    solved(mass, right, free).forEach((x, k) => (qdd[free[k]] = x));
    const hold = tau.map((x, i) => {
      if (this.contacts[i] !== null) return 0;
      // What friction must be for the joint to stay: tau - M qdd - V - G - K.
      return mass[i].reduce((sum, m, j) => sum - m * qdd[j], x - bias[i]);
    });
    return { tau, friction, qdd, hold };
  }

  rate = (_t, y) => {
    const state = this.state(y);
    const { base, qd } = state;
    const { tau, friction, qdd } = this.solve(state);
    const power = qd.reduce((sum, speed, i) => sum + speed * (tau[i] - friction[i]), 0);
    if (!this.chart) return Float64Array.from([...qd, ...qdd, power]);
    return Float64Array.from([...this.chart.rate(y, base, qd), ...qd.slice(this.ofBase), ...qdd, power]);
  };

  state(y) {
    const n = this.dof;
    const base = this.chart && this.chart.pose(y);
    return { base, q: Array.from(y.subarray(this.ofBase, n)), qd: Array.from(y.subarray(n, 2 * n)) };
  }

  /** How far the state is from the next event: below zero behind one. */
  margins(y) {
    if (!this.sticks) return [Infinity];
    const state = this.state(y);
    const hold = this.contacts.includes(null) ? this.solve(state).hold : null;
    return this.contacts.map((contact, i) => {
      if (contact === null) return this.dry.breakaway(i, Math.sign(hold[i])) - Math.abs(hold[i]);
      return contact === 0 ? Infinity : contact * state.qd[i];
    });
  }

  /** Joints at rest stick; then those that friction holds too little are let go, the worst one first. */
  settle(y) {
    if (!this.sticks) return;
    const state = this.state(y);
    this.contacts = state.qd.map((speed, i) => {
      if (!this.dry.isDry[i]) return 0;
      return speed === 0 ? null : Math.sign(speed);
    });
    while (this.contacts.includes(null)) {
      const { hold } = this.solve(state);
      const excess = this.contacts.map((contact, i) => {
        if (contact !== null || hold[i] === 0) return 0;
        return Math.abs(hold[i]) / this.dry.breakaway(i, Math.sign(hold[i]));
      });
      const worst = excess.indexOf(Math.max(...excess));
      if (!(excess[worst] > 1)) return;
      this.contacts[worst] = Math.sign(hold[worst]);
    }
  }
}

/** The size of a step that ends at the first event in it, which a longer one has passed. */
function untilEvent(motion, t, y, first, h) {
  let [early, late] = [0, h];
  for (let k = 0; k < 60 && late - early > 1e-12 * h; k++) {
    const middle = (early + late) / 2;
    const { end } = trial(motion.rate, t, y, first, middle);
    if (Math.min(...motion.margins(end)) < 0) late = middle;
    else early = middle;
  }
  return late;
}

/** Goes on to a time. */
function advance(motion, from, until) {
  let { t, y, h } = from;
  let events = 0;
  let wasRejected = false;
  while (until - t > 1e-12 * Math.max(1, until)) {
    const first = motion.rate(t, y);
    const size = Math.min(h, until - t);
    const { end, error } = trial(motion.rate, t, y, first, size);
    if (!(error <= 1)) {
      h = size * factor(error, true);
      wasRejected = true;
      if (!(h > 1e-12)) throw new Ended("its steps become too small");
      continue;
    }
    if (Math.min(...motion.margins(end)) < 0) {
      if (++events > MOST_EVENTS) throw new Ended("a joint sticks and lets go without end");
      const part = untilEvent(motion, t, y, first, size);
      y = trial(motion.rate, t, y, first, part).end;
      t += part;
      motion.chart?.recenter(y);
      motion.contacts.forEach((contact, i) => {
        // A velocity that has crossed zero is zero.
        if (contact && contact * y[motion.dof + i] <= 0) y[motion.dof + i] = 0;
      });
      motion.settle(y);
      continue;
    }
    [t, y] = [t + size, end];
    motion.chart?.recenter(y);
    const wish = size * factor(error, wasRejected);
    // A step that was cut short by a sample says little of how long it could be.
    h = size < h && error < 0.1 ? Math.max(h, wish) : wish;
    wasRejected = false;
  }
  return { t: until, y, h };
}

/**
 * The motion from a start, sampled: pose of a base that moves, q, qd, qdd, torques and friction at each time, and the energy that
 * torques have brought and friction has taken. Where it cannot go on, `ended` says why.
 */
export function freeMotion({ equations, table, law, torque, hasFriction, base, q, qd, duration, samples }) {
  const torques = LAWS[law]({ equations, torque, hasFriction });
  const motion = new Motion(equations, table, base, torques, hasFriction);
  const found = { t: [], base: [], q: [], qd: [], qdd: [], tau: [], friction: [], work: [], ended: null };
  let state = { t: 0, y: Float64Array.from([...(motion.chart?.start ?? []), ...q, ...qd, 0]), h: duration / samples };
  try {
    motion.settle(state.y);
    for (let k = 0; k < samples; k++) {
      const t = (duration * k) / (samples - 1);
      state = advance(motion, state, t);
      const at = motion.state(state.y);
      const { qdd, tau, friction, hold } = motion.solve(at);
      found.t.push(t);
      found.base.push(at.base);
      found.q.push(at.q);
      found.qd.push(at.qd);
      found.qdd.push(qdd);
      found.tau.push(tau);
      found.friction.push(friction.map((force, i) => (motion.contacts[i] === null ? hold[i] : force)));
      found.work.push(state.y[2 * motion.dof]);
    }
  } catch (error) {
    const isSingular = error instanceof NotPositiveDefinite || error.name === "SingularMassMatrix";
    if (!(error instanceof Ended) && !isSingular) throw error;
    found.ended = { t: state.t, reason: isSingular ? singular(table, error.joint) : error.message };
  }
  return found;
}

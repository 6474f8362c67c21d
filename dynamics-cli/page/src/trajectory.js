// A motion over time, prescribed or free, as the page plays and plots it.

import { freeMotion } from "./free_motion.js";
import { prescribed } from "./profiles.js";

/** Samples each second, and how many there are at least and at most. */
const RATE = 100;
const [LEAST, MOST] = [201, 2001];

export function samplesOf(duration) {
  return Math.min(Math.max(Math.round(RATE * duration) + 1, LEAST), MOST);
}

/** The torques of a prescribed motion: inverse dynamics. */
export function prescribedTrajectory(equations, given) {
  const samples = samplesOf(given.duration);
  const at = (t) => {
    const state = prescribed(given, t);
    return { ...state, tau: equations.inverse_dynamics(state.q, state.qd, state.qdd) };
  };
  const t = Array.from({ length: samples }, (_, k) => (given.duration * k) / (samples - 1));
  const states = t.map(at);
  const column = (name) => states.map((state) => state[name]);
  const found = { t, q: column("q"), qd: column("qd"), qdd: column("qdd"), tau: column("tau") };
  return measured(equations, { ...found, at, ended: null, duration: given.duration }, given);
}

/** The motion under given torques: forward dynamics. */
export function freeTrajectory(equations, given) {
  const found = freeMotion({ ...given, equations, samples: samplesOf(given.duration) });
  if (found.t.length === 0) stay(found, given);
  const duration = found.t.length > 0 ? found.t[found.t.length - 1] : 0;
  const trajectory = measured(equations, { ...found, duration, at: (t) => between(found, t) }, given);
  // E - E(0) is what torques have brought and friction has taken, but for the errors of the steps.
  const { total, kinetic, potential } = trajectory;
  const drift = total.map((energy, k) => Math.abs(energy - total[0] - found.work[k]));
  const spread = (values) => Math.max(...values) - Math.min(...values);
  trajectory.drift = Math.max(0, ...drift);
  trajectory.energyScale = Math.max(spread(kinetic), spread(potential), spread(found.work), 0);
  return trajectory;
}

/** A motion that cannot begin has its start alone; its accelerations are not known. */
function stay(found, { q, qd }) {
  const unknown = q.map(() => NaN);
  for (const [name, value] of Object.entries({ t: 0, q, qd, qdd: unknown, tau: unknown, work: 0 })) {
    found[name].push(value);
  }
}

/** With energies and the way of the tip that the function `key` places. */
function measured(equations, trajectory, { key }) {
  const { q, qd } = trajectory;
  const kinetic = q.map((at, k) => equations.kinetic_energy(at, qd[k]));
  const potential = q.map((at) => equations.potential_energy(at));
  const total = kinetic.map((energy, k) => energy + potential[k]);
  const tip = q.map((at) => equations[key](at).slice(0, 3).map((row) => row[3]));
  return { ...trajectory, kinetic, potential, total, tip };
}

/** Cubics through positions and velocities, and through velocities and accelerations, of two samples. */
function between(found, t) {
  const { t: times } = found;
  const last = times.length - 1;
  if (last < 1) return { q: found.q[0], qd: found.qd[0], qdd: found.qdd[0], tau: found.tau[0] };
  const h = times[1] - times[0];
  const k = Math.min(Math.max(Math.floor(t / h), 0), last - 1);
  const u = Math.min(Math.max((t - times[k]) / h, 0), 1);
  if (u === 0 || u === 1) {
    const at = k + u;
    return { q: found.q[at], qd: found.qd[at], qdd: found.qdd[at], tau: found.tau[at] };
  }
  const cubic = (values, slopes) =>
    values[k].map((from, i) => {
      const way = values[k + 1][i] - from;
      const [a, b] = [h * slopes[k][i] - way, way - h * slopes[k + 1][i]];
      return from + u * (way + (1 - u) * (a * (1 - u) + b * u));
    });
  const line = (values) => values[k].map((from, i) => from + u * (values[k + 1][i] - from));
  return {
    q: cubic(found.q, found.qd),
    qd: cubic(found.qd, found.qdd),
    qdd: line(found.qdd),
    tau: line(found.tau),
  };
}

/** The samples as text, a row for each, which the command `inverse` reads. */
export function csv(trajectory, names) {
  const vectors = ["q", "qd", "qdd", "tau"];
  const columns = vectors.flatMap((vector) => names.map((name) => `${vector}_${name}`));
  const header = ["t", ...columns, "kinetic", "potential", "x", "y", "z"];
  const rows = trajectory.t.map((t, k) => [
    t,
    ...vectors.flatMap((vector) => trajectory[vector][k]),
    trajectory.kinetic[k],
    trajectory.potential[k],
    ...trajectory.tip[k],
  ]);
  return [header, ...rows].map((row) => row.join(",")).join("\n") + "\n";
}

// A motion over time, prescribed or free, as the page plays and plots it.

import { freeMotion } from "./free_motion.js";
import { cubic, FREEDOMS, poseBetween } from "./moving_base.js";
import { prescribed } from "./profiles.js";

/** Samples each second, and how many there are at least and at most. */
const RATE = 100;
const [LEAST, MOST] = [201, 10_001];

export function samplesOf(duration) {
  return Math.min(Math.max(Math.round(RATE * duration) + 1, LEAST), MOST);
}

/** The torques of a prescribed motion: inverse dynamics. A base that could move is held where it is. */
export function prescribedTrajectory(equations, given) {
  const samples = samplesOf(given.duration);
  const { base } = given;
  const still = base ? FREEDOMS.map(() => 0) : [];
  const at = (t) => {
    const { q, ...rates } = prescribed(given, t);
    const [qd, qdd] = [rates.qd, rates.qdd].map((of) => [...still, ...of]);
    return { base, q, qd, qdd, tau: equations.inverse_dynamics(base, q, qd, qdd) };
  };
  const t = Array.from({ length: samples }, (_, k) => (given.duration * k) / (samples - 1));
  const states = t.map(at);
  const column = (name) => states.map((state) => state[name]);
  const found = { t, base: column("base"), q: column("q"), qd: column("qd"), qdd: column("qdd"), tau: column("tau") };
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
function stay(found, { base, q, qd }) {
  const unknown = qd.map(() => NaN);
  for (const [name, value] of Object.entries({ t: 0, base, q, qd, qdd: unknown, tau: unknown, friction: unknown, work: 0 })) {
    found[name].push(value);
  }
}

/** With energies and the way of the tip that the function `key` places. */
export function measured(equations, trajectory, { key }) {
  const { base, q, qd } = trajectory;
  const kinetic = q.map((at, k) => equations.kinetic_energy(at, qd[k]));
  const potential = q.map((at, k) => equations.potential_energy(base[k], at));
  const total = kinetic.map((energy, k) => energy + potential[k]);
  const tip = q.map((at, k) => equations[key](base[k], at).slice(0, 3).map((row) => row[3]));
  return { ...trajectory, kinetic, potential, total, tip };
}

/** Cubics through positions and velocities, and through velocities and accelerations, of two samples. */
export function between(found, t) {
  const { t: times } = found;
  const last = times.length - 1;
  const sample = (at) => Object.fromEntries(["base", "q", "qd", "qdd", "tau", "friction"].map((name) => [name, found[name]?.[at]]));
  if (last < 1) return sample(0);
  const h = times[1] - times[0];
  const k = Math.min(Math.max(Math.floor(t / h), 0), last - 1);
  const u = Math.min(Math.max((t - times[k]) / h, 0), 1);
  if (u === 0 || u === 1) return sample(k + u);
  const [from, to] = [sample(k), sample(k + 1)];
  const ofBase = from.qd.length - from.q.length;
  // Slopes behind those of the base, where positions are meant.
  const cubics = (values, slopes, behind) =>
    from[values].map((x, i) => x + cubic(to[values][i] - x, h * from[slopes][behind + i], h * to[slopes][behind + i], u));
  const line = (values) => values[k].map((from, i) => from + u * (values[k + 1][i] - from));
  return {
    base: from.base && poseBetween([from.base, to.base], [from.qd, to.qd], h, u),
    q: cubics("q", "qd", ofBase),
    qd: cubics("qd", "qdd", 0),
    qdd: line(found.qdd),
    tau: line(found.tau),
    friction: found.friction && line(found.friction),
  };
}

/**
 * The samples as text, a row for each, which the command `inverse-dynamics` reads. `names` are those of the freedoms, of
 * which the last have positions.
 */
export function csv(trajectory, names) {
  const vectors = ["q", "qd", "qdd", "tau"];
  const [base] = trajectory.base;
  const behind = (vector) => names.slice(names.length - trajectory[vector][0].length);
  const columns = vectors.flatMap((vector) => behind(vector).map((name) => `${vector}_${name}`));
  const rotation = [1, 2, 3].flatMap((i) => [1, 2, 3].map((j) => `r${i}${j}`));
  const pose = [...rotation, "x", "y", "z"].map((name) => `base.${name}`);
  const header = ["t", ...(base ? pose : []), ...columns, "kinetic", "potential", "x", "y", "z"];
  const rows = trajectory.t.map((t, k) => [
    t,
    ...(trajectory.base[k] ?? []),
    ...vectors.flatMap((vector) => trajectory[vector][k]),
    trajectory.kinetic[k],
    trajectory.potential[k],
    ...trajectory.tip[k],
  ]);
  return [header, ...rows].map((row) => row.join(",")).join("\n") + "\n";
}

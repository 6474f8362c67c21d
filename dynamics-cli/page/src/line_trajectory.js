// A motion of the tip along a straight line, turning evenly about one axis: the joints follow.

import { add, length, scaled, subtract, turned, unit } from "./frames.js";
import { solved } from "./linear.js";
import { PROFILES } from "./profiles.js";
import { approach, tipAt, turnBetween } from "./reach.js";
import { between, measured, samplesOf } from "./trajectory.js";

/** From one sample to the next no joint goes farther, rad or as a share of the arm's length. */
const JUMP = 0.3;

/** The joint velocities of least size with a twist of the tip. */
function velocities(problem, q, twist) {
  const { columns } = tipAt(problem, q);
  const rows = problem.hasRotation ? 6 : 3;
  const product = (a, b) => a.slice(0, rows).reduce((sum, x, k) => sum + x * b[k], 0);
  const matrix = columns.map((a, i) => columns.map((b, j) => product(a, b) + (i === j ? 1e-10 : 0)));
  return solved(matrix, columns.map((column) => product(column, twist)), q.map((_, i) => i));
}

/** Differences of samples, which are at rest at both ends: those of the second order at the ends. */
function slopes(values, h) {
  const last = values.length - 1;
  const of = (k, weights) => values[0].map((_, i) => weights.reduce((sum, [at, weight]) => sum + weight * values[k + at][i], 0) / (2 * h));
  return values.map((_, k) => {
    if (k === 0) return of(0, [[0, -3], [1, 4], [2, -1]]);
    if (k === last) return of(last, [[0, 3], [-1, -4], [-2, 1]]);
    return of(k, [[1, 1], [-1, -1]]);
  });
}

/** The motion from positions to the target of `problem`; where the joints cannot follow, it ends with the reason. */
export function lineTrajectory(equations, problem, given) {
  const { from, duration, profile, base } = given;
  const samples = samplesOf(duration);
  const h = duration / (samples - 1);
  const { frame: start } = tipAt(problem, from);
  const way = subtract(problem.target.o, start.o);
  const chord = turnBetween(start, problem.target);
  const angle = problem.hasRotation ? 2 * Math.asin(Math.min(1, length(chord) / 2)) : 0;
  const axis = unit(chord);
  const found = { t: [], base: [], q: [], qd: [], ended: null };
  let q = from;
  for (let k = 0; k < samples; k++) {
    const [s, rate] = PROFILES[profile](k / (samples - 1));
    const turn = (v) => turned(v, axis, angle * s);
    const target = { x: turn(start.x), y: turn(start.y), z: turn(start.z), o: add(start.o, scaled(way, s)) };
    const asked = { ...problem, target };
    const next = approach(asked, q);
    const reason = refused(problem, q, next);
    if (reason && k > 0) {
      found.ended = { t: k * h, reason };
      break;
    }
    q = next.q;
    found.t.push(k * h);
    found.base.push(base);
    found.q.push(q);
    found.qd.push(velocities(problem, q, [...scaled(way, rate / duration), ...scaled(axis, (angle * rate) / duration)]));
  }
  return complete(equations, found, h, given);
}

/** Why the joints cannot follow to the next sample. */
function refused({ size, joints }, q, next) {
  if (!next.isReached) return "the line leaves what the arm reaches within its limits, or meets a singular pose";
  const isFar = q.some((x, i) => Math.abs(next.q[i] - x) > JUMP * (joints[i].type === "revolute" ? 1 : size));
  return isFar ? "the line passes a singular pose, where the joints would have to jump" : null;
}

/** With accelerations, torques and energies. */
function complete(equations, found, h, { base, key }) {
  const still = base ? [0, 0, 0, 0, 0, 0] : [];
  const isLong = found.t.length > 2;
  const qdd = isLong ? slopes(found.qd, h) : found.qd.map((qd) => qd.map(() => 0));
  const behind = (list) => list.map((values) => [...still, ...values]);
  const all = { ...found, qd: behind(found.qd), qdd: behind(qdd) };
  all.tau = all.q.map((q, k) => equations.inverse_dynamics(base, q, all.qd[k], all.qdd[k]));
  const duration = all.t[all.t.length - 1];
  return measured(equations, { ...all, duration, at: (t) => between(all, t) }, { key });
}

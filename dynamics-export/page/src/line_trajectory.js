// A motion of the tip along a straight line, turning evenly about one axis: the joints follow. Positions, velocities and
// accelerations are those of each instant, by the Jacobian; they do not exist where it is singular.

import { add, length, scaled, subtract, turned, unit } from "./frames.js";
import { PROFILES } from "./profiles.js";
import { singularValues, throughInverse } from "./pseudoinverse.js";
import { random, tipAt, TOLERANCE, turnBetween } from "./reach.js";
import { between, measured, samplesOf } from "./trajectory.js";

/** From one sample to the next no joint goes farther, rad or as a share of the arm's length. */
const JUMP = 0.3;
/** A pose is singular if its least singular value is below this share of the greatest one, lengths as shares of the arm's. */
const SINGULAR = 1e-5;
/** Samples of a line at most: between them too its states are computed. */
const MOST_SAMPLES = 1001;
/** Steps to the line, and the change of positions, rad or m, by which the Jacobian's derivative is a difference. */
const [MOST_STEPS, CHANGE] = [20, 1e-5];

const SINGULAR_POSE = "the arm is singular there, and its joints have no finite velocities and accelerations along the line";
const ADVICE = "choose another start or target, or let each joint move by itself";
const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);

/** What is asked of the tip, by rows, lengths as shares of the arm's. */
const weighted = ({ size, hasRotation }, v) => (hasRotation ? v : v.slice(0, 3)).map((x, k) => (k < 3 ? x / size : x));
const jacobian = (problem, q) => tipAt(problem, q).columns.map((column) => weighted(problem, column));

/** The rank of the Jacobian nearly everywhere. */
function rankOf(problem) {
  const next = random(2);
  const ranks = [0, 1, 2].map(() => {
    const triples = singularValues(jacobian(problem, problem.ranges.map(([low, high]) => low + (high - low) * next())));
    return triples.filter(({ value }) => value > 1e-6 * triples[0].value).length;
  });
  return Math.max(...ranks);
}

/** Where the tip is to be at a share of the time, with its velocity and acceleration. */
function lineOf(problem, { from, duration, profile }) {
  const { frame: start } = tipAt(problem, from);
  const way = subtract(problem.target.o, start.o);
  const chord = turnBetween(start, problem.target);
  const angle = problem.hasRotation ? 2 * Math.asin(Math.min(1, length(chord) / 2)) : 0;
  const axis = unit(chord);
  const twist = weighted(problem, [...way, ...scaled(axis, angle)]);
  return {
    isStill: length(way) <= TOLERANCE && angle <= TOLERANCE,
    at(share) {
      const [s, rate, bend] = PROFILES[profile](share);
      const turn = (v) => turned(v, axis, angle * s);
      const target = { x: turn(start.x), y: turn(start.y), z: turn(start.z), o: add(start.o, scaled(way, s)) };
      const times = (factor) => twist.map((x) => x * factor);
      return { s, target, velocity: times(rate / duration), acceleration: times(bend / duration ** 2) };
    },
  };
}

/** Positions on the line by Newton's method, from near ones; null if it does not come there. */
function onLine(problem, rank, target, near) {
  let [q, best] = [near, null];
  for (let k = 0; k < MOST_STEPS; k++) {
    const { frame, columns } = tipAt(problem, q);
    const [way, turn] = [subtract(target.o, frame.o), problem.hasRotation ? turnBetween(frame, target) : [0, 0, 0]];
    const error = Math.max(length(way), length(turn));
    // Steps go on to the last digits: errors of positions are those of the tip over the least singular value.
    if (best && best.error <= TOLERANCE && !(error < best.error / 2)) return best.q;
    if (!best || error < best.error) best = { q, error };
    const triples = singularValues(columns.map((column) => weighted(problem, column))).slice(0, rank);
    if (!(triples[rank - 1].value > 0)) break;
    const step = throughInverse(triples, "u", "v", weighted(problem, [...way, ...turn]));
    q = q.map((x, i) => x + step[i]);
  }
  return best.error <= TOLERANCE ? best.q : null;
}

/**
 * qd = J^+ v, and its derivative (Golub and Pereyra 1973), v in the range of J:
 * qdd = J^+ (a - J' qd) + (1 - J^+ J) J'^T J^+T qd.
 */
function rates(problem, triples, q, { velocity, acceleration }) {
  const qd = throughInverse(triples, "u", "v", velocity);
  const most = Math.max(...qd.map(Math.abs));
  if (most === 0) return { qd, qdd: throughInverse(triples, "u", "v", acceleration) };
  const [before, behind] = [-1, 1].map((way) => jacobian(problem, q.map((x, i) => x + (way * CHANGE * qd[i]) / most)));
  const change = behind.map((column, i) => column.map((x, k) => ((x - before[i][k]) * most) / (2 * CHANGE)));
  const right = acceleration.map((x, k) => x - qd.reduce((sum, speed, i) => sum + speed * change[i][k], 0));
  const behindInverse = throughInverse(triples, "v", "u", qd);
  const bent = change.map((column) => dot(column, behindInverse));
  const own = triples.map(({ v }) => dot(v, bent));
  const free = bent.map((x, i) => x - triples.reduce((sum, { v }, k) => sum + own[k] * v[i], 0));
  return { qd, qdd: throughInverse(triples, "u", "v", right).map((x, i) => x + free[i]) };
}

/** Whether a determinant is below zero, by elimination with pivots. */
function isNegative(rows) {
  const a = rows.map((row) => [...row]);
  let sign = 1;
  for (let k = 0; k < a.length; k++) {
    const pivot = a.slice(k).reduce((best, row, i) => (Math.abs(row[k]) > Math.abs(a[best][k]) ? k + i : best), k);
    if (pivot !== k) [a[k], a[pivot], sign] = [a[pivot], a[k], -sign];
    if (a[k][k] < 0) sign = -sign;
    for (let i = k + 1; i < a.length; i++) a[i] = a[i].map((x, j) => x - (a[i][k] / a[k][k]) * a[k][j]);
  }
  return sign < 0;
}

/** Why the joints cannot be at positions behind those of the sample before; null if they can. */
function refused({ joints, limits, size }, before, { q, triples, columns }, rank) {
  if (triples[rank - 1].value <= SINGULAR * triples[0].value) return SINGULAR_POSE;
  const passed = limits.findIndex((ends, i) => ends && (q[i] < ends[0] - 1e-9 || q[i] > ends[1] + 1e-9));
  if (passed >= 0) return `joint \`${joints[passed].name}\` would pass its limit`;
  if (!before) return null;
  const isFar = q.some((x, i) => Math.abs(before.q[i] - x) > JUMP * (joints[i].type === "revolute" ? 1 : size));
  if (isFar) return "the line passes a singular pose so near that joints would have to jump";
  // U' J V of the sample before is positive there, and changes its sign at a singular pose.
  const moved = before.triples.map(({ v }) => columns[0].map((_, k) => columns.reduce((sum, column, i) => sum + v[i] * column[k], 0)));
  return isNegative(moved.map((column) => before.triples.map(({ u }) => dot(u, column)))) ? SINGULAR_POSE : null;
}

/** The motion from positions to the target of `problem`; where the joints cannot follow, it ends with the reason. */
export function lineTrajectory(equations, problem, given) {
  const { from, duration, base } = given;
  const samples = Math.min(samplesOf(duration), MOST_SAMPLES);
  const h = duration / (samples - 1);
  const rank = rankOf(problem);
  const line = lineOf(problem, given);
  const stateAt = (share, near) => {
    const asked = line.at(share);
    const q = line.isStill ? from : onLine(problem, rank, asked.target, near);
    if (!q) return { s: asked.s, reason: "the line leaves what the arm reaches, or meets a singular pose" };
    const columns = jacobian(problem, q);
    const triples = singularValues(columns).slice(0, rank);
    const still = q.map(() => 0);
    return { s: asked.s, q, columns, triples, ...(line.isStill ? { qd: still, qdd: still } : rates(problem, triples, q, asked)) };
  };
  const found = { t: [], base: [], q: [], qd: [], qdd: [], ended: null };
  let before = null;
  for (let k = 0; k < samples; k++) {
    const near = before ? before.q.map((x, i) => x + h * (before.qd[i] + (h / 2) * before.qdd[i])) : from;
    const state = stateAt(k / (samples - 1), near);
    const reason = state.reason ?? (line.isStill ? null : refused(problem, before, state, rank));
    if (reason) {
      const where = k === 0 ? "at its start" : `at ${Number((100 * state.s).toPrecision(3))} % of the line`;
      found.ended = { t: k * h, reason: `${where} ${reason}; ${ADVICE}` };
      if (k > 0) break;
      const unknown = from.map(() => NaN);
      Object.assign(state, { q: from, qd: unknown.map(() => 0), qdd: unknown });
    }
    found.t.push(k * h);
    found.base.push(base);
    for (const name of ["q", "qd", "qdd"]) found[name].push(state[name]);
    before = state;
    if (reason) break;
  }
  return complete(equations, found, given, (t, near) => stateAt(t / duration, near));
}

/** With torques and energies; between samples too the state is that of the line. */
function complete(equations, found, { base, key }, stateAt) {
  const still = base ? [0, 0, 0, 0, 0, 0] : [];
  const forced = ({ q, qd, qdd }) => {
    const [speeds, bends] = [qd, qdd].map((values) => [...still, ...values]);
    return { base, q, qd: speeds, qdd: bends, tau: equations.inverse_dynamics(base, q, speeds, bends) };
  };
  const states = found.q.map((q, k) => forced({ q, qd: found.qd[k], qdd: found.qdd[k] }));
  const all = { ...found, ...Object.fromEntries(["qd", "qdd", "tau"].map((name) => [name, states.map((one) => one[name])])) };
  const duration = all.t[all.t.length - 1];
  const at = (t) => {
    const near = between(all, t);
    if (all.t.includes(t) || all.t.length < 2) return near;
    const state = stateAt(t, near.q);
    return state.reason ? near : forced(state);
  };
  return measured(equations, { ...all, duration, at }, { key });
}

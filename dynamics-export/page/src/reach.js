// Inverse kinematics by Levenberg and Marquardt's method, as the runtime has it: positions of the joints at which the tip
// is where it is to be. Poses and Jacobians come from the frames of the table.

import { chain } from "./chain.js";
import { add, cross, dot, length, scaled, subtract } from "./frames.js";
import { NotPositiveDefinite, solved } from "./linear.js";

/** How far the tip may be from the target, m and rad. */
export const TOLERANCE = 1e-9;
/** A descent ends where so many steps do not halve the error, or after the most of them. */
const [PERIOD, MOST_STEPS] = [5, 60];
/** Parts of the damping: of the error, and of the greatest diagonal entry. */
const [OF_ERROR, LEAST] = [0.1, 1e-12];
/** A step that gains less, as a share of the error, is not made in the last descent. */
const LEAST_GAIN = 1e-9;
/** Starts of a search for all solutions, and positions that are one solution, rad or m. */
const [STARTS, SAME] = [120, 1e-3];

const AXES = ["x", "y", "z"];

/** 2 sin(angle / 2) along the axis of the turn of one frame into another: twice the vector of its unit quaternion. */
export function turnBetween(from, to) {
  const sines = AXES.map((k) => cross(from[k], to[k])).reduce(add);
  const cosine = 1 + AXES.reduce((sum, k) => sum + dot(from[k], to[k]), 0);
  if (cosine > 1e-6) return scaled(sines, 1 / Math.sqrt(cosine));
  // Half a turn: the rotation and one are twice the axis times its transpose.
  const column = (j) => AXES.reduce((sum, k) => add(sum, scaled(to[k], from[k][j])), [0, 1, 2].map((i) => (i === j ? 1 : 0)));
  const columns = [0, 1, 2].map(column);
  const longest = columns.reduce((a, b) => (length(b) > length(a) ? b : a));
  return scaled(longest, 2 / length(longest));
}

/** How many joints carry a tip. */
export function carrying(table, tip) {
  const joints = new Set();
  for (let i = table.tips[tip].on; i !== null; i = table.rows[i].on) joints.add(table.rows[i].joint ?? table.rows[i].follows?.joint);
  joints.delete(undefined);
  return joints.size;
}

/** The tip's frame, and for each joint its velocity and its turning, for a unit velocity of the joint. */
export function tipAt({ table, base, tip }, q) {
  const { rows, tips } = chain(table, q, base);
  const columns = q.map(() => [0, 0, 0, 0, 0, 0]);
  for (let i = table.tips[tip].on; i !== null; i = table.rows[i].on) {
    const { joint, follows, type } = table.rows[i];
    const { joint: moved, factor } = joint === null ? (follows ?? { joint: null }) : { joint, factor: 1 };
    if (moved === null) continue;
    const { axis, origin } = rows[i];
    const moves = type === "prismatic" ? [...axis, 0, 0, 0] : [...cross(axis, subtract(tips[tip].o, origin)), ...axis];
    columns[moved] = columns[moved].map((x, k) => x + factor * moves[k]);
  }
  return { frame: tips[tip], columns };
}

/** The sum E of half of the squares of what is missing, lengths as shares of the arm's, with J'e and J'J. */
function normal(problem, q) {
  const { target, size, hasRotation } = problem;
  const { frame, columns } = tipAt(problem, q);
  const way = subtract(target.o, frame.o);
  const turn = hasRotation ? turnBetween(frame, target) : [0, 0, 0];
  const weights = [1, 1, 1].map((x) => x / size).concat(hasRotation ? [1, 1, 1] : [0, 0, 0]);
  const missing = [...way, ...turn].map((x, k) => x * weights[k]);
  const weighted = columns.map((column) => column.map((x, k) => x * weights[k]));
  const product = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
  return {
    way: length(way),
    turn: length(turn),
    isReached: length(way) <= TOLERANCE && length(turn) <= TOLERANCE,
    error: product(missing, missing) / 2,
    descent: weighted.map((column) => product(column, missing)),
    matrix: weighted.map((a) => weighted.map((b) => product(a, b))),
  };
}

const greatest = ({ matrix }) => Math.max(0, ...matrix.map((row, i) => row[i]));

/** The step of (J'J + damping) dq = J'e within the limits: joints that would pass one are put on it. Null where none moves the tip. */
function stepped({ limits }, { matrix, descent }, damping, q) {
  const damped = matrix.map((row, i) => row.map((x, j) => (i === j ? x + damping : x)));
  const step = q.map(() => 0);
  let free = q.map((_, i) => i);
  for (let pass = 0; pass < 4 && free.length > 0; pass++) {
    const right = descent.map((x, i) => q.reduce((sum, _, j) => (free.includes(j) ? sum : sum - damped[i][j] * step[j]), x));
    let found;
    try {
      found = solved(damped, right, free);
    } catch (error) {
      if (error instanceof NotPositiveDefinite) return null;
      throw error;
    }
    free.forEach((i, k) => (step[i] = clamped(q[i] + found[k], limits[i]) - q[i]));
    const still = free.filter((i, k) => step[i] === q[i] + found[k] - q[i]);
    if (still.length === free.length) break;
    free = still;
  }
  return q.map((x, i) => clamped(x + step[i], limits[i]));
}

const clamped = (x, limits) => (limits ? Math.min(Math.max(x, limits[0]), limits[1]) : x);

/** From a start to where the target is reached, or to where no joint comes nearer. */
function descend(problem, start) {
  let q = start.map((x, i) => clamped(x, problem.limits[i]));
  let before = Infinity;
  for (let k = 0; ; k++) {
    const at = normal(problem, q);
    const isStuck = k % PERIOD === PERIOD - 1 && !(at.error < before / 2);
    if (at.isReached || isStuck || k === MOST_STEPS) return { q, ...at };
    if (k % PERIOD === PERIOD - 1) before = at.error;
    const most = greatest(at);
    const next = stepped(problem, at, OF_ERROR * Math.min(at.error, most) + LEAST * most, q);
    if (next === null) return { q, ...at };
    q = next;
  }
}

/** To the very bottom near a start: never to a greater error. */
function settle(problem, start) {
  let q = start.map((x, i) => clamped(x, problem.limits[i]));
  let at = normal(problem, q);
  const most = greatest(at);
  let damping = OF_ERROR * most;
  for (let k = 0; k < 200 && !at.isReached && damping < 1e9 * most; k++) {
    const next = stepped(problem, at, damping, q);
    if (next === null) break;
    const there = normal(problem, next);
    if (at.error - there.error < LEAST_GAIN * at.error) damping *= 4;
    else [q, at, damping] = [next, there, Math.max(damping / 4, LEAST * most)];
  }
  return { q, ...at };
}

/** From a start to the target, or to the very bottom near the start: where the arm is singular, short steps come nearer slowly. */
export function approach(problem, start) {
  const end = descend(problem, start);
  return end.isReached ? end : settle(problem, start);
}

/** Numbers from 0 to 1, the same in each run (mulberry32). */
export function random(seed) {
  let a = seed;
  return () => {
    a = (a + 0x6d2b79f5) | 0;
    let t = Math.imul(a ^ (a >>> 15), 1 | a);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** The same place of the arm, by whole turns as near to another as the limits allow. */
export function nearest({ table, limits }, q, start) {
  const leads = (joint) => table.rows.some(({ follows }) => follows?.joint === joint);
  const joints = table.rows.filter(({ joint }) => joint !== null);
  return q.map((x, i) => {
    if (joints[i].type !== "revolute" || leads(i)) return x;
    const turn = 2 * Math.PI;
    const near = x - turn * Math.round((x - start[i]) / turn);
    const candidates = [near, near + turn, near - turn];
    return candidates.find((y) => clamped(y, limits[i]) === y) ?? x;
  });
}

/** Whether two positions are one solution: whole turns of joints that turn do not count. */
export function isSame({ joints }, a, b) {
  const turn = 2 * Math.PI;
  return a.every((x, i) => Math.abs(x - b[i] - (joints[i].type === "revolute" ? turn * Math.round((x - b[i]) / turn) : 0)) < SAME);
}

/** Distinct solutions, the nearest to a start first, at most so many; and what came nearest, where there are none. */
export function solutions(problem, start, most = 16) {
  const next = random(1);
  const anywhere = () => problem.ranges.map(([low, high]) => low + (high - low) * next());
  const found = [];
  let best = null;
  for (let k = 0; k < STARTS && found.length < most; k++) {
    const end = descend(problem, k === 0 ? start : anywhere());
    if (best === null || end.error < best.error) best = end;
    if (!end.isReached) continue;
    const q = nearest(problem, end.q, start);
    if (!found.some((other) => isSame(problem, q, other))) found.push(q);
  }
  const away = (q) => Math.max(...q.map((x, i) => Math.abs(x - start[i])));
  found.sort((a, b) => away(a) - away(b));
  if (found.length > 0) return { found, missing: null };
  const missing = settle(problem, best.q);
  return { found, missing: { ...missing, q: nearest(problem, missing.q, start) } };
}

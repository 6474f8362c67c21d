/**
 * Angles, rad, that are closer than this cannot be told apart; a pose is reached that is missed by less than the second, a last
 * row is 0, 0, 0, 1 to the third, and a rotation one to the fourth.
 */
const [APART, REACHED, LAST_ROW, ROTATION] = [1e-7, 1e-9, 1e-6, 1e-3];

/** Differences of numbers as large as the size may be nothing but rounding below this. */
const roundings = (size) => 16 * Number.EPSILON * size;

/**
 * A joint: sine and cosine of its angle, or its displacement as the sine. An angle is known to rounding * sqrt(size / length),
 * half a turn at most.
 */
const turned = (sine, cosine, isSingular, length = 0, size = 1) => ({ sine, cosine, isSingular, length, size });

/**
 * The turn with this cosine and sine times a length; zero if that vanishes beside size. Of a folded arm the length itself has no
 * digits left, and the cosine and the sine have.
 */
function turn(cosine, sine, _, size) {
  const [length, least] = [Math.sqrt(cosine * cosine + sine * sine), roundings(1)];
  if (length <= least * least * size || length <= 0) return turned(0, 1, true);
  const scale = 1 / length;
  return turned(sine * scale, cosine * scale, length <= APART * APART * size, length, size);
}

const slide = (position) => turned(position, 0, false);

/** No roots, and how far an equation is from having one. */
const none = (miss) => Object.assign([], { miss });

/**
 * a cos q + b sin q = c, where c is a difference of numbers whose squares are as large as size; the discriminant is
 * a^2 + b^2 - c^2. A step d from a root changes the left side by root d + radius d^2 / 2.
 */
function turns(a, b, c, discriminant, size) {
  const [square, least] = [a * a + b * b, roundings(1)];
  // A discriminant that is nothing but rounding is none: later joints then see the same root as this one.
  const noise = 0.25 * least * least * size * square;
  size += square;
  const length = 0.5 * roundings(Math.sqrt(square * size));
  if (square <= least * least * size) {
    return c * c <= least * least * size && Number.isFinite(size) ? [turned(0, 1, true)] : none(-(c * c) / size);
  }
  if (discriminant > least * least * square && discriminant * discriminant > noise) {
    const [root, scale, known] = [Math.sqrt(discriminant), 1 / square, Math.max(discriminant, length)];
    const isSingular = 4 * discriminant <= APART * APART * square || square <= APART * APART * size;
    const one = (root) => turned((b * c + a * root) * scale, (a * c - b * root) * scale, isSingular, known, size);
    return [one(root), one(-root)];
  }
  if (!(discriminant >= -roundings(size) && Number.isFinite(size))) return none(discriminant / size);
  const scale = c < 0 ? -Math.sqrt(square) : Math.sqrt(square);
  return [turned(b / scale, a / scale, true, length, size)];
}

/** b + root and b - root of the discriminant, a difference of numbers as large as size. */
function slides(b, discriminant, size) {
  if (!(discriminant >= -roundings(size) && Number.isFinite(size))) return none(discriminant / size);
  const root = discriminant > 0 ? Math.sqrt(discriminant) : 0;
  const isSingular = 4 * root * root <= APART * APART * size;
  return (root > 0 ? [root, -root] : [0]).map((root) => turned(b + root, 0, isSingular));
}

/** Farther away than any equation is. */
const NO_TRY = -1e30;

/** Roots as they are; if there is none, the least of how far equations are from having one is noted. */
function noted(roots, tries) {
  if (roots.length === 0 && roots.miss > tries.miss) tries.miss = roots.miss;
  return roots;
}

/** Tries on either side, and tries that narrow or halve. */
const [GRID, ROUNDS] = [32, 60];

/**
 * A joint that a pose leaves free, entirely or as far as rounding goes. If the equations of later joints have no solution with
 * what was found, the nearest position is taken with which they have one. Solutions of all tries but the last are taken away.
 */
function* family(found, solutions, tries) {
  const [before, outer] = [solutions.length, tries.miss];
  tries.miss = NO_TRY;
  yield found;
  let best = tries.miss;
  const steep = roundings(8);
  const isNear = best > NO_TRY && best * best * found.length <= steep * steep * found.size;
  if (solutions.length === before && isNear) {
    const attempt = function* (at) {
      [solutions.length, tries.miss] = [before, NO_TRY];
      const [s, c] = [Math.sin(at), Math.cos(at)];
      yield turned(found.sine * c + found.cosine * s, found.cosine * c - found.sine * s, true);
      best = Math.max(best, tries.miss);
      return { miss: tries.miss, isSolved: solutions.length > before };
    };
    const step = Math.min(roundings(Math.sqrt(found.size / found.length)), Math.PI) / GRID;
    const ends = [yield* nearest_solved(attempt, step, 1), yield* nearest_solved(attempt, step, -1)];
    const nearest = Math.abs(ends[1]) < Math.abs(ends[0]) ? ends[1] : ends[0];
    [solutions.length, tries.miss] = [before, NO_TRY];
    if (Number.isFinite(nearest)) yield* attempt(nearest);
  }
  tries.miss = Math.max(best, outer);
}

/** The nearest position on one side that is solved, on a grid and in between: where three tries enclose the one that fails least. */
function* nearest_solved(attempt, step, side) {
  let grid = [];
  for (let number = -1; number <= GRID; ++number) {
    const at = step * number;
    const { miss, isSolved } = yield* attempt(side * at);
    if (isSolved && number > 0) return side * (yield* halved(attempt, side, at - step, at));
    // A solution on the other side of what was found: its own turn comes.
    grid = [...grid.slice(-2), { at, miss: isSolved ? 1 : miss }];
    if (number > 0 && grid[1].miss > grid[0].miss && grid[1].miss >= grid[2].miss) {
      const solved = yield* narrowed(attempt, side, grid);
      if (Number.isFinite(solved)) return side * (yield* halved(attempt, side, Math.max(grid[0].at, 0), solved));
    }
  }
  return Infinity;
}

/** A position that is solved near the maximum that three tries enclose. */
function* narrowed(attempt, side, [before, middle, behind]) {
  for (let rounds = 0; rounds < ROUNDS; ++rounds) {
    const isBefore = middle.at - before.at > behind.at - middle.at;
    const at = 0.5 * (middle.at + (isBefore ? before.at : behind.at));
    const { miss, isSolved } = yield* attempt(side * at);
    if (isSolved) return at;
    const one = { at, miss };
    if (miss >= middle.miss) [before, middle, behind] = isBefore ? [before, one, middle] : [middle, one, behind];
    else if (isBefore) before = one;
    else behind = one;
  }
  return Infinity;
}

/** The first position that is solved between one that is not and one that is. */
function* halved(attempt, side, outside, inside) {
  for (let rounds = 0; rounds < ROUNDS; ++rounds) {
    const at = 0.5 * (outside + inside);
    const { isSolved } = yield* attempt(side * at);
    if (isSolved) inside = at;
    else outside = at;
  }
  return inside;
}

/** The direction of a vector, or of the other one if the first vanishes beside size. */
function direction(x, y, z, u, v, w, size) {
  const [square, least] = [x * x + y * y + z * z, roundings(1)];
  if (!(square > least * least * size)) [x, y, z] = [u, v, w];
  const scale = 1 / Math.sqrt(x * x + y * y + z * z);
  return { x: x * scale, y: y * scale, z: z * scale, isSingular: square <= APART * APART * size };
}

const is_reached = (x, y, z, size) => x * x + y * y + z * z <= REACHED * REACHED * size && Number.isFinite(size);

/** R'R - 1 of rows, and whether it vanishes to a bound. */
const products = (rows) =>
  [0, 1, 2].map((i) => [0, 1, 2].map((j) => rows.slice(0, 3).reduce((sum, row) => sum + row[i] * row[j], i === j ? -1 : 0)));
const vanishes = (misses, bound) => misses.every((row) => row.every((miss) => Math.abs(miss) <= bound));

/**
 * A pose that is one, with the nearest rotation, or null: its position is finite and, where more is read, its last row
 * 0, 0, 0, 1, which a transposed pose has as its last column, and its rotation one to 1e-3. The nearest rotation is the orthogonal
 * part of a polar decomposition, by R <- R (3 - R'R) / 2.
 */
function nearest_pose(pose, readsRotation) {
  if (!pose.slice(0, 3).every((row) => Number.isFinite(row[3]))) return null;
  if (!readsRotation) return pose;
  const [x, y, z] = pose;
  const volume =
    x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) + x[2] * (y[0] * z[1] - y[1] * z[0]);
  const isRow = pose[3].every((entry, i) => Math.abs(entry - (i === 3 ? 1 : 0)) <= LAST_ROW);
  let misses = products(pose);
  if (!(isRow && volume > 0 && vanishes(misses, ROTATION))) return null;
  let at = pose;
  for (let rounds = 0; rounds < 3 && !vanishes(misses, roundings(4)); ++rounds) {
    const part = (row, j) => 0.5 * (row[0] * misses[0][j] + row[1] * misses[1][j] + row[2] * misses[2][j]);
    at = at.map((row, i) => (i < 3 ? row.map((entry, j) => (j < 3 ? entry - part(row, j) : entry)) : row));
    misses = products(at);
  }
  return at;
}

/** Solutions with their number, or with the reason why there is none. */
const counted = (solutions, why) => Object.assign(solutions, { count: solutions.length || why });

/** Adds a solution, unless it is not finite. */
function keep(solutions, joints, turning, isAny) {
  const above = (angle) => (angle <= -Math.PI ? Math.PI : angle);
  const q = joints.map(({ sine, cosine }, i) => (turning[i] ? above(Math.atan2(sine, cosine)) : sine));
  const isSingular = isAny || joints.some((joint) => joint.isSingular);
  if (q.every(Number.isFinite)) solutions.push({ q, isSingular });
}

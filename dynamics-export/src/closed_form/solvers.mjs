/**
 * Angles, rad, that are closer than this cannot be told apart; a pose is reached that is missed by less than the second, a last
 * row is 0, 0, 0, 1 to the third, and a rotation one to the fourth.
 */
const [APART, REACHED, LAST_ROW, ROTATION] = [1e-7, 1e-9, 1e-6, 1e-3];

/** Differences of numbers as large as the size may be nothing but rounding below this. */
const roundings = (size) => 16 * Number.EPSILON * size;

/**
 * Sine and cosine, with the digits of Rust's up to an angle of 1e5: x = n pi/2 + rest - excess, two polynomials, and n quarter
 * turns (Cody and Waite 1980).
 */
function sine_and_cosine(x) {
  if (!(Math.abs(x) <= 1e5)) return [Math.sin(x), Math.cos(x)];
  const turns = x * 0.6366197723675814 + 6755399441055744.0 - 6755399441055744.0;
  const [first, second] = [x - turns * 1.5707963267923333, turns * 2.5633441515839558e-12];
  const rest = first - second;
  const excess = turns * 1.0562999066987428e-23 + (rest - first + second);
  const z = rest * rest;
  const [cube, zz, w] = [rest * z, z * z, 1.0 - 0.5 * z];
  const fifth = z * cube;
  let upper = -2.755731369191555e-6 + z * 2.505075811569819e-8 + zz * -1.5896795713489563e-10;
  let lower = fifth * (-0.008333333333322413 + z * 0.00019841269829807778) + excess * w;
  const s = rest - (cube * 0.16666666666666632 + (lower + zz * fifth * upper));
  const lost = 1.0 - w - 0.5 * z;
  upper = 2.480158728948234e-5 + z * -2.7557314352372173e-7 + zz * (2.0875723278132235e-9 + z * -1.1359648042271599e-11);
  lower = zz * (0.0416666666666666 + z * -0.0013888888888874125) + rest * excess;
  const c = w + (lost + lower + zz * zz * upper);
  return [[s, c], [c, -s], [-s, -c], [-c, s]][((turns % 4) + 4) % 4];
}

/** The angle from -pi to pi with this sine and cosine, up to a common positive factor; 0 where both vanish. */
function angle(sine, cosine) {
  const [s, c] = [Math.abs(sine), Math.abs(cosine)];
  const [small, large] = s > c ? [c, s] : [s, c];
  // tan(x - pi/4) = (tan x - 1) / (tan x + 1)
  const isFar = small > 0.41421356237309504 * large;
  const [over, under] = isFar ? [small - large, small + large] : [small, large];
  const z = over / (under === 0 ? 1 : under);
  // The arc tangent is z + z^3 P(z^2) (FreeBSD's s_atan.c, Sun Microsystems 1993): even and odd powers.
  const square = z * z;
  const fourth = square * square;
  const horner = (sum, coefficient) => sum * fourth + coefficient;
  const even = [-0.036531572744216916, -0.058335701337905735, -0.0769187620504483, -0.11111110405462356, -0.19999999999876483];
  const odd = [0.016285820115365782, 0.049768779946159324, 0.06661073137387531, 0.09090887133436507, 0.14285714272503466];
  const p = horner(odd.reduce(horner), 0.3333333333333293) + even.reduce(horner) * square;
  let x = z - z * (square * p);
  if (isFar) x = Math.PI / 4 + x;
  if (s > c) x = Math.PI / 2 - x;
  if (cosine < 0) x = Math.PI - x;
  return sine < 0 ? -x : x;
}

/**
 * A turn whose sine and cosine are these times a scale: with its position, and known to rounding * sqrt(size / length), half a turn
 * at most. An angle that rounding takes to -pi is half a turn all the same.
 */
function turned(sine, cosine, isSingular, { scale = 1, length = 0, size = 1, isSecond = false } = {}) {
  const q = angle(sine, cosine);
  return {
    sine: sine * scale,
    cosine: cosine * scale,
    q: q <= -Math.PI ? Math.PI : q,
    isSingular,
    isSecond,
    length,
    size,
  };
}

const displaced = (q, isSingular, isSecond) => ({ sine: q, q, isSingular, isSecond });

/**
 * The turn with this cosine and sine times a length; zero if that vanishes beside size. Of a folded arm the length itself has no
 * digits left, and the cosine and the sine have.
 */
function turn(cosine, sine, _, size) {
  const [length, least] = [Math.sqrt(cosine * cosine + sine * sine), roundings(1)];
  if (length <= least * least * size || length <= 0) return turned(0, 1, true);
  return turned(sine, cosine, length <= APART * APART * size, { scale: 1 / length, length, size });
}

const slide = (position) => displaced(position, false, false);

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
  if (square <= least * least * size) {
    return c * c <= least * least * size && Number.isFinite(size) ? [turned(0, 1, true)] : none(-((c * c) / size));
  }
  const double = 0.5 * roundings(Math.sqrt(square * size));
  if (discriminant > least * least * square && discriminant * discriminant > noise) {
    const [root, scale] = [Math.sqrt(discriminant), 1 / square];
    const isSingular = 4 * discriminant <= APART * APART * square || square <= APART * APART * size;
    const length = isSingular && double > discriminant ? double : discriminant;
    const one = (root, isSecond) =>
      turned((b * c + a * root) * scale, (a * c - b * root) * scale, isSingular, { length, size, isSecond });
    return [one(root, false), one(-root, true)];
  }
  if (!(discriminant >= -roundings(size) && Number.isFinite(size))) return none(discriminant / size);
  const scale = c < 0 ? -Math.sqrt(square) : Math.sqrt(square);
  return [turned(b / scale, a / scale, true, { length: double, size })];
}

/**
 * a cos q + b sin q = c of a point, and u cos q + v sin q = w of the direction of a line on which it is: the point that is farther
 * along it by the root of size, where the discriminant is larger, meets their sum.
 */
function turns_of_line(a, b, c, u, v, w, size) {
  const along = a * u + b * v < c * w ? -Math.sqrt(size) : Math.sqrt(size);
  const [x, y, z] = [a + along * u, b + along * v, c + along * w];
  return turns(x, y, z, x * x + y * y - z * z, size);
}

/** b + root and b - root of the discriminant, a difference of numbers as large as size. */
function slides(b, discriminant, size) {
  if (!(discriminant >= -roundings(size) && Number.isFinite(size))) return none(discriminant / size);
  const root = discriminant > 0 ? Math.sqrt(discriminant) : 0;
  const isSingular = 4 * root * root <= APART * APART * size;
  const both = [displaced(b + root, isSingular, false), displaced(b - root, isSingular, true)];
  return both.slice(0, discriminant > 0 ? 2 : 1);
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

/** The nearest position on one side that is solved, on a grid and in between: where three tries enclose the one that fails least. */
function* nearest_solved(attempt, step, side) {
  let grid = [];
  for (let number = -1; number <= GRID; ++number) {
    const at = step * number;
    const { miss, isSolved } = yield* attempt(side * at);
    if (isSolved && number > 0) return side * (yield* halved(attempt, side, grid.at(-1).at, at));
    // A solution on the other side of what was found: its own turn comes.
    grid = [...grid.slice(-2), { at, miss: isSolved ? 1 : miss }];
    if (number > 0 && grid[1].miss > grid[0].miss && grid[1].miss >= grid[2].miss) {
      const solved = yield* narrowed(attempt, side, grid);
      if (Number.isFinite(solved)) return side * (yield* halved(attempt, side, Math.max(grid[0].at, 0), solved));
    }
  }
  return Infinity;
}

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
      const [s, c] = sine_and_cosine(at);
      const { isSecond } = found;
      yield turned(found.sine * c + found.cosine * s, found.cosine * c - found.sine * s, true, { isSecond });
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

/** The direction of a vector, or of the other one if the first vanishes beside size. */
function direction(x, y, z, u, v, w, size) {
  const [square, least] = [x * x + y * y + z * z, roundings(1)];
  if (!(square > least * least * size)) [x, y, z] = [u, v, w];
  const scale = 1 / Math.sqrt(x * x + y * y + z * z);
  return { x: x * scale, y: y * scale, z: z * scale, isSingular: square <= APART * APART * size };
}

const is_reached = (x, y, z, size) => x * x + y * y + z * z <= REACHED * REACHED * size && Number.isFinite(size);

/** R'R - 1 of rows. */
const products = (rows) =>
  [0, 1, 2].map((i) =>
    [0, 1, 2].map((j) => rows[0][i] * rows[0][j] + rows[1][i] * rows[1][j] + rows[2][i] * rows[2][j] - (i === j ? 1 : 0))
  );

/** Whether numbers vanish to a bound. */
const vanish = (numbers, bound) => numbers.every((number) => Math.abs(number) <= bound);

/** The vector product of the first two columns. */
const product = ([x, y, z]) => [y[0] * z[1] - z[0] * y[1], z[0] * x[1] - x[0] * z[1], x[0] * y[1] - y[0] * x[1]];

/** Whether rows are those of a rotation but for rounding. */
function is_exact(rows) {
  const misses = products(rows);
  const others = product(rows).map((entry, i) => entry - rows[i][2]);
  const squares = [misses[0][0], misses[1][1], misses[0][1], ...others].map((miss) => miss * miss);
  return squares.reduce((sum, square) => sum + square, 0) <= roundings(4) * roundings(4);
}

/**
 * A pose that is one, with the nearest rotation, or null: its position is finite and, where more is read, its last row
 * 0, 0, 0, 1, which a transposed pose has as its last column, and its rotation one to 1e-3. The nearest rotation is the orthogonal
 * part of a polar decomposition, by R <- R (3 - R'R) / 2.
 */
function nearest_pose(pose, readsRotation) {
  if (!pose.slice(0, 3).every((row) => Number.isFinite(row[3]))) return null;
  if (!readsRotation) return pose;
  const isRow = vanish(
    pose[3].map((entry, i) => entry - (i === 3 ? 1 : 0)),
    LAST_ROW
  );
  if (isRow && is_exact(pose)) return pose;
  const volume = product(pose).reduce((sum, entry, i) => sum + entry * pose[i][2], 0);
  if (!(isRow && volume > 0 && vanish(products(pose).flat(), ROTATION))) return null;
  let at = pose;
  for (let rounds = 0; rounds < 3; ++rounds) {
    const misses = products(at);
    const part = (row, j) => 0.5 * (row[0] * misses[0][j] + row[1] * misses[1][j] + row[2] * misses[2][j]);
    at = at.map((row, i) => (i < 3 ? row.map((entry, j) => (j < 3 ? entry - part(row, j) : entry)) : row));
  }
  return at;
}

/** Solutions with their number, or with the reason why there is none. */
const counted = (solutions, why) => Object.assign(solutions, { count: solutions.length || why });

/** Adds a solution, unless it is not finite. */
function keep(solutions, joints, isAny, branch) {
  const q = joints.map((joint) => joint.q);
  const isSingular = isAny || joints.some((joint) => joint.isSingular);
  if (q.every(Number.isFinite)) solutions.push({ q, isSingular, branch });
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/**
 * The angle of the elbow about the line from shoulder to wrist, from the half plane that holds the direction of axis 1: that line,
 * the way from it to the elbow, and the direction of axis 4 are in a frame whose z axis is axis 1. Where the line vanishes beside
 * size, or is along axis 1, and where the elbow is on the line, other directions take their place.
 */
function angle_of_elbow(between, elbow, axis, size) {
  const along = (v, other, size) => {
    const { x, y, z } = direction(...v, ...other, size);
    return [x, y, z];
  };
  const line = along(between, [0, 0, 1], size);
  const across = (v) => {
    const by = dot(v, line);
    return v.map((entry, i) => entry - line[i] * by);
  };
  const start = across(along(across([0, 0, 1]), across([1, 0, 0]), 1));
  const way = across(along(across(elbow), cross(axis, line), size));
  return angle(dot(line, cross(start, way)), dot(start, way));
}

/** The multiple of a whole turn that is nearest to an angle, or, upwards, the least that is not below it. */
function whole_turns(angle, isUpwards) {
  const turns = angle / (2 * Math.PI);
  // Of two nearest integers the even one: the sum has no room for other digits.
  const nearest = Math.abs(turns) < 2 ** 50 ? turns + 1.5 * 2 ** 52 - 1.5 * 2 ** 52 : turns;
  return (isUpwards && nearest < turns ? nearest + 1 : nearest) * (2 * Math.PI);
}

/** The position of a joint that is whole turns away and nearest to another one, within its range if it has one. */
function nearest_turn(joint, q, seed, range) {
  if (!TURNING[joint]) return q;
  const near = q + whole_turns(seed - q, false);
  if (range && near < range[0]) return near + whole_turns(range[0] - near, true);
  if (range && near > range[1]) return near - whole_turns(near - range[1], true);
  return near;
}

/** The ways of the joints of a solution from a position. */
const ways = ({ q }, from, limits) => q.map((one, i) => nearest_turn(i, one, from[i], limits?.[i]) - from[i]);

/** The solution with the least sum of squares of the joints' ways, as it stands; null if there is none. */
function nearest_one(solutions, seed) {
  let [nearest, least] = [null, Infinity];
  for (const solution of solutions) {
    const distance = ways(solution, seed, solutions.limits).reduce((sum, way) => sum + way * way, 0);
    if (distance < least) [nearest, least] = [solution, distance];
  }
  return nearest;
}

/**
 * The solutions within limits, with whole turns where these ask for them: an array of [lower, upper], or null, for each joint. The
 * result has the properties that inverse kinematics gives it, and the limits besides.
 */
export function within(solutions, limits) {
  const isWithin = (x, range) => !range || (x >= range[0] && x <= range[1]);
  const all = solutions.map((solution) => ({
    ...solution,
    q: solution.q.map((x, i) => nearest_turn(i, x, x, limits[i])),
  }));
  const some = all.filter(({ q }) => q.every((x, i) => isWithin(x, limits[i])));
  return Object.assign(counted(some, Math.min(solutions.count, 0)), { limits });
}

/**
 * The solution whose joints have the least sum of squares of their ways from a seed, whole turns left out; null if there is none.
 * Behind `within` whole turns are added that bring it nearest to the seed within the limits.
 */
export function nearest(solutions, seed) {
  const solution = nearest_one(solutions, seed);
  const q = solution?.q.map((x, i) => (solutions.limits?.[i] ? nearest_turn(i, x, seed[i], solutions.limits[i]) : x));
  return solution && { ...solution, q };
}

/** The branch that a path was on ends: the joint, from 0, that moves farthest, null if there is no solution, and its way. */
export class BranchEnds extends Error {
  constructor(joint, way, most) {
    const moves = `to the nearest solution joint ${joint + 1} moves by ${way.toFixed(3)}, more than ${most.toFixed(3)}`;
    super(`the branch ends: ${joint === null ? "there is no solution" : moves}`);
    Object.assign(this, { name: "BranchEnds", joint, way, most });
  }
}

/** The nearest solution to the position before it, as it stands. Throws BranchEnds if a joint moves by more than `most`. */
export function follow(solutions, last, most) {
  const solution = nearest_one(solutions, last);
  if (!solution) throw new BranchEnds(null, Infinity, most);
  const sizes = ways(solution, last, solutions.limits).map(Math.abs);
  const way = Math.max(...sizes);
  if (!(way <= most)) throw new BranchEnds(sizes.indexOf(way), way, most);
  return solution;
}

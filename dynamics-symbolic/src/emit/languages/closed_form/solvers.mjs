/**
 * Angles, rad, that are closer than this cannot be told apart; a pose is reached that is missed by less than the second, and a
 * rotation has unit vectors at right angles to the third.
 */
const [APART, REACHED, ROTATION] = [1e-7, 1e-9, 1e-6];

/** Differences of numbers as large as the size may be nothing but rounding below this. */
const roundings = (size) => 16 * Number.EPSILON * size;

/** A joint: sine and cosine of its angle, or its displacement as the sine. */
const turned = (sine, cosine, isSingular) => ({ sine, cosine, isSingular });

/** The turn with this cosine and sine times length; zero if that vanishes beside size. */
function turn(cosine, sine, length, size) {
  const [squares, least] = [cosine * cosine + sine * sine, roundings(1)];
  if (length <= least * least * size || squares <= 0) return turned(0, 1, true);
  const scale = 1 / Math.sqrt(squares);
  return turned(sine * scale, cosine * scale, length <= APART * APART * size);
}

const slide = (position) => turned(position, 0, false);

/**
 * a cos q + b sin q = c, where c is a difference of numbers whose squares are as large as size; the discriminant is
 * a^2 + b^2 - c^2.
 */
function turns(a, b, c, discriminant, size) {
  const [square, least] = [a * a + b * b, roundings(1)];
  size += square;
  if (square <= least * least * size) {
    return c * c <= least * least * size && Number.isFinite(size) ? [turned(0, 1, true)] : [];
  }
  if (discriminant > least * least * square) {
    const [root, scale] = [Math.sqrt(discriminant), 1 / square];
    const isSingular = 4 * discriminant <= APART * APART * square;
    return [root, -root].map((root) => turned((b * c + a * root) * scale, (a * c - b * root) * scale, isSingular));
  }
  if (!(discriminant >= -roundings(size) && Number.isFinite(size))) return [];
  const scale = c < 0 ? -Math.sqrt(square) : Math.sqrt(square);
  return [turned(b / scale, a / scale, true)];
}

/** b + root and b - root of the discriminant, a difference of numbers as large as size. */
function slides(b, discriminant, size) {
  if (!(discriminant >= -roundings(size) && Number.isFinite(size))) return [];
  const root = discriminant > 0 ? Math.sqrt(discriminant) : 0;
  const isSingular = 4 * root * root <= APART * APART * size;
  return (root > 0 ? [root, -root] : [0]).map((root) => turned(b + root, 0, isSingular));
}

/** The direction of a vector, or of the other one if the first vanishes beside size. */
function direction(x, y, z, u, v, w, size) {
  const [square, least] = [x * x + y * y + z * z, roundings(1)];
  if (!(square > least * least * size)) [x, y, z] = [u, v, w];
  const scale = 1 / Math.sqrt(x * x + y * y + z * z);
  return { x: x * scale, y: y * scale, z: z * scale, isSingular: square <= APART * APART * size };
}

const is_reached = (x, y, z, size) => x * x + y * y + z * z <= REACHED * REACHED * size && Number.isFinite(size);

/** Whether a matrix is a pose. Two columns of its rotation have length one and are at right angles, and their vector product
 * is the third. The last row is 0, 0, 0, 1, which a transposed pose has as its last column. */
function is_pose(pose) {
  const [x, y, z] = [0, 1, 2].map((column) => pose.slice(0, 3).map((row) => row[column]));
  const product = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const thirds = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
  const misses = [product(x, x) - 1, product(y, y) - 1, product(x, y), ...thirds.map((third, i) => third - z[i])];
  misses.push(...pose[3].map((x, i) => x - (i === 3 ? 1 : 0)));
  return misses.every((miss) => Math.abs(miss) <= ROTATION);
}

/** Adds a solution, unless it is not finite. */
function keep(solutions, joints, turning, isAny) {
  const above = (angle) => (angle <= -Math.PI ? Math.PI : angle);
  const q = joints.map(({ sine, cosine }, i) => (turning[i] ? above(Math.atan2(sine, cosine)) : sine));
  const isSingular = isAny || joints.some((joint) => joint.isSingular);
  if (q.every(Number.isFinite)) solutions.push({ q, isSingular });
}

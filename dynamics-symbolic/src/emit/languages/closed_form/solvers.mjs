/** Angles, rad, that are closer than this cannot be told apart; a pose is reached that is missed by less than the second. */
const APART = 1e-7;
const REACHED = 1e-9;

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

function byDiscriminant(a, b, c, square, discriminant, size) {
  const radius = Math.sqrt(square);
  if (discriminant > 0) {
    const [root, scale] = [Math.sqrt(discriminant), 1 / square];
    const isSingular = root + root <= APART * radius;
    return [root, -root].map((root) => turned((b * c + a * root) * scale, (a * c - b * root) * scale, isSingular));
  }
  if (!(discriminant >= -roundings(size) && Number.isFinite(size))) return [];
  const scale = c < 0 ? -radius : radius;
  return [turned(b / scale, a / scale, true)];
}

/** a cos q + b sin q = c, where c is a difference of numbers whose squares are as large as size. */
function turns(a, b, c, size) {
  const [square, least, magnitude] = [a * a + b * b, roundings(1), Math.abs(c)];
  const radius = Math.sqrt(square);
  size += square;
  if (square <= least * least * size) {
    return c * c <= least * least * size && Number.isFinite(size) ? [turned(0, 1, true)] : [];
  }
  return byDiscriminant(a, b, c, square, (radius - magnitude) * (radius + magnitude), size);
}

/** |y - Rz(q) x|^2 + rest = found, which is a cos q + b sin q = (known - found) / 2, with a step of Newton's method. */
function turns_at_distance(a, b, known, found, x0, x1, y0, y1, rest) {
  return turns(a, b, (known - found) * 0.5, (known + found) ** 2).map(({ sine: s, cosine: c, isSingular }) => {
    if (isSingular) return turned(s, c, isSingular);
    const [u, v] = [c * x0 - s * x1, s * x0 + c * x1];
    const step = (found - rest - ((u - y0) ** 2 + (v - y1) ** 2)) / (-2 * (u * y1 - v * y0));
    return turned(s + c * step, c - s * step, isSingular);
  });
}

/** The same with a^2 + b^2 - c^2. */
function turns_by(a, b, c, discriminant) {
  const square = a * a + b * b;
  const least = roundings(Math.sqrt(square));
  const isNothing = discriminant <= least * least && discriminant >= -roundings(square);
  return byDiscriminant(a, b, c, square, isNothing ? 0 : discriminant, square);
}

/** The same with (1 - along) (1 + along - twice), where (1 - along) (1 + along) = across. */
const inclined_turns = (a, b, c, along, across, twice) =>
  turns_by(a, b, c, (across / (1 + along)) * (1 + along - twice));

/** b + root and b - root of the discriminant, a difference of numbers as large as size. */
function slides(b, discriminant, size) {
  if (!(discriminant >= -roundings(size) && Number.isFinite(size))) return [];
  const root = discriminant > 0 ? Math.sqrt(discriminant) : 0;
  const isSingular = 4 * root * root <= APART * APART * size;
  return (root > 0 ? [root, -root] : [0]).map((root) => turned(b + root, 0, isSingular));
}

const root = Math.sqrt;

/** The direction of a vector, or of the other one if the first vanishes beside size. */
function direction(x, y, z, u, v, w, size) {
  const [square, least] = [x * x + y * y + z * z, roundings(1)];
  if (!(square > least * least * size)) [x, y, z] = [u, v, w];
  const scale = 1 / Math.sqrt(x * x + y * y + z * z);
  return { x: x * scale, y: y * scale, z: z * scale, isSingular: square <= APART * APART * size };
}

const is_reached = (x, y, z, size) => x * x + y * y + z * z <= REACHED * REACHED * size && Number.isFinite(size);

/** Adds a solution, unless it is not finite. */
function keep(solutions, joints, turning, isAny) {
  const q = joints.map(({ sine, cosine }, i) => (turning[i] ? Math.atan2(sine + 0, cosine) : sine));
  const isSingular = isAny || joints.some((joint) => joint.isSingular);
  if (q.every(Number.isFinite)) solutions.push({ q, isSingular });
}

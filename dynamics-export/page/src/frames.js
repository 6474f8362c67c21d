// Vectors of three numbers, and frames in the world: three axes and an origin.

export const add = (u, v) => [u[0] + v[0], u[1] + v[1], u[2] + v[2]];
export const subtract = (u, v) => [u[0] - v[0], u[1] - v[1], u[2] - v[2]];
export const scaled = (v, s) => [s * v[0], s * v[1], s * v[2]];
export const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
export const length = (v) => Math.hypot(v[0], v[1], v[2]);
export const distance = (u, v) => length(subtract(u, v));

export const cross = (u, v) => [
  u[1] * v[2] - u[2] * v[1],
  u[2] * v[0] - u[0] * v[2],
  u[0] * v[1] - u[1] * v[0],
];

/** The vector of length one; the zero vector is left as it is. */
export const unit = (v) => scaled(v, 1 / (length(v) || 1));

/** The vector turned about an axis of length one. */
export function turned(v, axis, angle) {
  const [s, c] = [Math.sin(angle), Math.cos(angle)];
  const along = scaled(axis, dot(axis, v) * (1 - c));
  return add(add(scaled(v, c), scaled(cross(axis, v), s)), along);
}

export const WORLD = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1], o: [0, 0, 0] };

/** A vector in the axes of a frame, in the world. */
export function direction(frame, v) {
  return add(add(scaled(frame.x, v[0]), scaled(frame.y, v[1])), scaled(frame.z, v[2]));
}

/** A point in a frame, in the world. */
export function point(frame, p) {
  return add(frame.o, direction(frame, p));
}

/** Tz(d) Rz(theta) */
export function screwZ({ x, y, z, o }, d, theta) {
  const [s, c] = [Math.sin(theta), Math.cos(theta)];
  return {
    x: add(scaled(x, c), scaled(y, s)),
    y: subtract(scaled(y, c), scaled(x, s)),
    z,
    o: add(o, scaled(z, d)),
  };
}

/** Tx(a) Rx(alpha) */
export function screwX({ x, y, z, o }, a, alpha) {
  const [s, c] = [Math.sin(alpha), Math.cos(alpha)];
  return {
    x,
    y: add(scaled(y, c), scaled(z, s)),
    z: subtract(scaled(z, c), scaled(y, s)),
    o: add(o, scaled(x, a)),
  };
}

/** T(xyz) Rz(yaw) Ry(pitch) Rx(roll), as in URDF. */
export function placed(frame, { xyz, rpy }) {
  const [sr, sp, sy] = rpy.map(Math.sin);
  const [cr, cp, cy] = rpy.map(Math.cos);
  return {
    x: direction(frame, [cy * cp, sy * cp, -sp]),
    y: direction(frame, [cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr]),
    z: direction(frame, [cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr]),
    o: point(frame, xyz),
  };
}

/** Roll, pitch and yaw of a rotation by rows: R = Rz(yaw) Ry(pitch) Rx(roll). */
export function rollPitchYaw(r) {
  const pitch = Math.atan2(-r[2][0], Math.hypot(r[0][0], r[1][0]));
  // Where x points straight up or down, roll and yaw turn about the same axis: yaw takes all.
  if (Math.hypot(r[0][0], r[1][0]) < 1e-9) return [0, pitch, Math.atan2(-r[0][1], r[1][1])];
  return [Math.atan2(r[2][1], r[2][2]), pitch, Math.atan2(r[1][0], r[0][0])];
}

/** One place for several, each in the one before it. */
export function composed(places) {
  if (places.length === 1) return places[0];
  const { x, y, z, o } = places.reduce(placed, WORLD);
  const rpy = rollPitchYaw([0, 1, 2].map((k) => [x[k], y[k], z[k]]));
  const tidy = (values) => values.map((value) => (Math.abs(value) < 1e-15 ? 0 : value));
  return { xyz: tidy(o), rpy: tidy(rpy) };
}

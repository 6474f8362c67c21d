// Rotations as nine numbers by rows, and their exponential coordinates: phi is the turn by |phi| about phi.

import { add, cross, length, scaled } from "./frames.js";

/** A B. */
export function product(a, b) {
  const entry = (i, j) => a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
  return [0, 1, 2].flatMap((i) => [0, 1, 2].map((j) => entry(i, j)));
}

export const transposed = (r) => [r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]];

/** R v. */
export const rotated = (r, v) => [0, 3, 6].map((k) => r[k] * v[0] + r[k + 1] * v[1] + r[k + 2] * v[2]);

const sinc = (x) => (x === 0 ? 1 : Math.sin(x) / x);

/** exp(phi) = 1 + sin t / t [phi] + (1 - cos t) / t^2 [phi]^2, t = |phi|. */
export function exponential(phi) {
  const angle = length(phi);
  const [s, c] = [sinc(angle), sinc(angle / 2) ** 2 / 2];
  const turned = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => {
    const once = cross(phi, axis);
    return add(add(axis, scaled(once, s)), scaled(cross(phi, once), c));
  });
  return transposed(turned.flat());
}

/** The phi of a turn by less than pi. */
export function logarithm(r) {
  const sine = scaled([r[7] - r[5], r[2] - r[6], r[3] - r[1]], 0.5);
  const angle = Math.atan2(length(sine), (r[0] + r[4] + r[8] - 1) / 2);
  return scaled(sine, 1 / sinc(angle));
}

/** (1 - t/2 cot(t/2)) / t^2. */
function bend(angle) {
  const square = angle * angle;
  if (angle < 1e-2) return 1 / 12 + square * (1 / 720 + square / 30240);
  return (1 - angle / 2 / Math.tan(angle / 2)) / square;
}

/**
 * d phi/dt of R = R0 exp(phi) that turns at w in its own axes: the inverse of the left-trivialised derivative of exp,
 * w + 1/2 phi x w + (1 - t/2 cot(t/2)) / t^2 phi x (phi x w).
 */
export function coordinateRate(phi, w) {
  const once = cross(phi, w);
  return add(add(w, scaled(once, 0.5)), scaled(cross(phi, once), bend(length(phi))));
}

// Momentum of a robot whose base moves.

import { cross, scaled, subtract } from "./frames.js";
import { rotated } from "./rotation.js";

/**
 * Linear momentum, and angular momentum about the centre of mass, in the world. M v begins with both of them in the axes of
 * the base, about its origin; the upper right block of M is -m [c], c the centre of mass.
 */
export function momentum(base, mass, v) {
  const sums = mass.slice(0, 6).map((row) => row.reduce((sum, entry, i) => sum + entry * v[i], 0));
  const [linear, angular] = [sums.slice(0, 3), sums.slice(3)];
  const center = scaled([mass[1][5], mass[2][3], mass[0][4]], 1 / (mass[0][0] || 1));
  return { linear: rotated(base, linear), angular: rotated(base, subtract(angular, cross(center, linear))) };
}

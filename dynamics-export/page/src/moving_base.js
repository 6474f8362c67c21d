// A base that moves. Its pose is twelve numbers, as the generated functions have it: the axes of the base in the world as
// columns of a rotation by rows, then the position.

import { WORLD, add, placed, scaled } from "./frames.js";
import { coordinateRate, exponential, logarithm, product, rotated, transposed } from "./rotation.js";

/**
 * The six freedoms of a base, in its own axes: signs of the velocity and of the force along each, and the type of joint that
 * has the same units.
 */
export const FREEDOMS = [0, 1, 2, 3, 4, 5].map((k) => {
  const axis = "xyz"[k % 3];
  return k < 3
    ? { name: `base.v${axis}`, axis, velocity: "v", force: "f", type: "prismatic" }
    : { name: `base.w${axis}`, axis, velocity: "ω", force: "n", type: "revolute" };
});

/** The six numbers that a person says a pose by. */
export const PLACES = ["x", "y", "z", "roll", "pitch", "yaw"].map((name, k) => ({
  name,
  type: k < 3 ? "prismatic" : "revolute",
}));

export const rotationOf = (base) => base.slice(0, 9);
export const positionOf = (base) => base.slice(9, 12);

/** The pose of x, y, z, roll, pitch and yaw. */
export function poseOf([x, y, z, ...rpy]) {
  const frame = placed(WORLD, { xyz: [x, y, z], rpy });
  return [0, 1, 2].flatMap((k) => [frame.x[k], frame.y[k], frame.z[k]]).concat(frame.o);
}

/** The frame of a pose. */
export function frameOf(base) {
  const [x, y, z] = [0, 1, 2].map((k) => [base[k], base[3 + k], base[6 + k]]);
  return { x, y, z, o: positionOf(base) };
}

/**
 * Coordinates of poses near one: phi of the rotation from there, then the position in the world (Munthe-Kaas 1999).
 * A step begins at phi = 0.
 */
export class Chart {
  constructor(base) {
    this.rotation = rotationOf(base);
    this.start = [0, 0, 0, ...positionOf(base)];
  }

  pose(y) {
    return [...product(this.rotation, exponential(y.subarray(0, 3))), ...y.subarray(3, 6)];
  }

  /** Rates of the coordinates at a pose, of which y are those, for velocities of the base. */
  rate(y, base, v) {
    return [...coordinateRate(y.subarray(0, 3), v.slice(3, 6)), ...rotated(base, v)];
  }

  /** Coordinates near the pose that y are those of now. */
  recenter(y) {
    this.rotation = rotationOf(this.pose(y));
    y.fill(0, 0, 3);
  }
}

/** A cubic from 0 to `way`, with slopes at u = 0 and u = 1. */
export function cubic(way, slope, slopeAtEnd, u) {
  const [a, b] = [slope - way, way - slopeAtEnd];
  return u * (way + (1 - u) * (a * (1 - u) + b * u));
}

/** The pose between two of them that are h apart in time, with the velocities there, at a share u of the way. */
export function poseBetween([from, to], [v, vAtEnd], h, u) {
  const phi = logarithm(product(transposed(from), to));
  const cubics = (way, slope, end) => way.map((x, k) => cubic(x, h * slope[k], h * end[k], u));
  const turn = cubics(phi, v.slice(3, 6), coordinateRate(phi, vAtEnd.slice(3, 6)));
  const way = add(positionOf(to), scaled(positionOf(from), -1));
  const moved = cubics(way, rotated(from, v), rotated(to, vAtEnd));
  return [...product(from, exponential(turn)), ...add(positionOf(from), moved)];
}

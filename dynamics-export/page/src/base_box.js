// The body of a base that moves: the box that has its mass and inertia, of glass, so that what is in it is seen.

import { equivalentBox } from "./equivalent_box.js";
import { add, direction, point, scaled } from "./frames.js";
import { align, box, material } from "./shapes.js";

/** The frame of the box in the world: its centre and its axes. */
function frameOf(base, body) {
  const { x, y, z, half } = equivalentBox(body);
  return { x: direction(base, x), y: direction(base, y), z: direction(base, z), o: point(base, body.com), half };
}

/** The solid. A body that is flat or thin is seen by a little thickness. */
export function baseBox() {
  const glass = material("#5c6673");
  Object.assign(glass, { transparent: true, opacity: 0.5, depthWrite: false });
  const mesh = box(glass);
  return {
    mesh,
    put(base, body) {
      const { half, ...frame } = frameOf(base, body);
      const most = Math.max(...half);
      align(mesh, frame.o, frame, half.map((side) => 2 * Math.max(side, 0.02 * most)));
      mesh.visible = most > 0;
    },
  };
}

/** Its eight corners in the world. */
export function boxCorners(base, body) {
  const { x, y, z, o, half } = frameOf(base, body);
  const sides = [x, y, z].map((axis, k) => scaled(axis, half[k]));
  return [-1, 1].flatMap((a) =>
    [-1, 1].flatMap((b) => [-1, 1].map((c) => add(o, add(add(scaled(sides[0], a), scaled(sides[1], b)), scaled(sides[2], c))))),
  );
}

// The frames of every row of the table, those that are locked or follow others too.

import { equivalentBox } from "./equivalent_box.js";
import { WORLD, add, distance, length, placed, screwX, screwZ } from "./frames.js";
import { frameOf } from "./moving_base.js";

/** Position of every row for positions of the joints that move by themselves. */
export function positions(table, q) {
  return table.rows.map((row) => {
    if (row.joint !== null) return q[row.joint];
    if (row.follows) return row.follows.factor * q[row.follows.joint] + row.follows.offset;
    return row.locked;
  });
}

/**
 * The frames of a robot, whose base is at `pose` if it moves. Of each row `before`, the frame that the row begins in; `middle`, behind the first
 * of its two screws; `frame`, behind both; `link`, the link frame; `origin` and `axis` of the joint.
 */
export function chain(table, q, pose) {
  const base = pose ? frameOf(pose) : table.base ? placed(WORLD, table.base) : WORLD;
  const at = positions(table, q);
  const rows = [];
  table.rows.forEach((row, i) => {
    const carrier = row.on === null ? base : rows[row.on].frame;
    // A row may begin anywhere on the link that carries it: what the cells do not say comes before them.
    const before = row.step.reduce(placed, carrier);
    const isPrismatic = row.type === "prismatic";
    const theta = row.theta + (isPrismatic ? 0 : at[i]);
    const d = row.d + (isPrismatic ? at[i] : 0);
    const placed_ = (middle, frame, joint) => {
      const link = row.mount ? row.mount.frame.reduce(placed, frame) : frame;
      rows.push({ before, middle, frame, link, theta, d, origin: joint.o, axis: joint.z });
    };
    if (table.convention === "standard") {
      const middle = screwZ(before, d, theta);
      placed_(middle, screwX(middle, row.a, row.alpha), before);
      return;
    }
    const middle = screwX(before, row.a, row.alpha);
    placed_(middle, screwZ(middle, d, theta), middle);
  });
  const tips = table.tips.map(({ on, places }) => places.reduce(placed, on === null ? base : rows[on].link));
  return { base, rows, tips };
}

/** The length of the longest branch stretched out, with the way of all prismatic joints. */
export function reach(table, slides) {
  const zero = new Array(table.joints).fill(0);
  const { base, rows, tips } = chain(table, zero, null);
  // The way to the end of every link, and where that is.
  const ends = [];
  const endOf = (on) => (on === null ? { way: 0, at: base.o } : ends[on]);
  const then = ({ way, at }, to) => ({ way: way + distance(at, to), at: to });
  rows.forEach(({ middle, frame, link }, i) => {
    const { on, isPlace } = table.rows[i];
    const points = table.isMounted ? (isPlace ? [] : [link.o]) : [middle.o, frame.o];
    ends.push(points.reduce(then, endOf(on)));
  });
  const ways = table.tips.map(({ on }, k) => then(endOf(on), tips[k].o).way);
  const sum = Math.max(0, ...ends.map(({ way }) => way), ...ways) + slides;
  // The bodies of an arm without lengths are somewhere.
  const bodies = table.rows.map((row) => Math.hypot(...row.com));
  if (table.floating) {
    const { com } = table.floating;
    bodies.push(length(add(com, equivalentBox(table.floating).half)));
  }
  return Math.max(sum, ...bodies) || 1;
}

// The frames of every row of the table, those that are locked or follow others too.

import { WORLD, distance, placed, screwX, screwZ } from "./frames.js";

/** Position of every row for positions of the joints that move by themselves. */
export function positions(table, q) {
  return table.rows.map((row) => {
    if (row.joint !== null) return q[row.joint];
    if (row.follows) return row.follows.factor * q[row.follows.joint] + row.follows.offset;
    return row.locked;
  });
}

/**
 * The frames of an arm. Of each row `before`, the frame that the row begins in; `middle`, behind the first
 * of its two screws; `frame`, behind both; `link`, the link frame; `origin` and `axis` of the joint.
 */
export function chain(table, q) {
  const base = table.base ? placed(WORLD, table.base) : WORLD;
  const at = positions(table, q);
  let before = base;
  const rows = table.rows.map((row, i) => {
    // A file may place a joint anywhere: what the cells do not say comes before them.
    if (row.mount) before = row.mount.step.reduce(placed, before);
    const isPrismatic = row.type === "prismatic";
    const theta = row.theta + (isPrismatic ? 0 : at[i]);
    const d = row.d + (isPrismatic ? at[i] : 0);
    const placed_ = (middle, frame, joint) => {
      const link = row.mount ? row.mount.frame.reduce(placed, frame) : frame;
      const found = { before, middle, frame, link, theta, d, origin: joint.o, axis: joint.z };
      before = frame;
      return found;
    };
    if (table.convention === "standard") {
      const middle = screwZ(before, d, theta);
      return placed_(middle, screwX(middle, row.a, row.alpha), before);
    }
    const middle = screwX(before, row.a, row.alpha);
    return placed_(middle, screwZ(middle, d, theta), middle);
  });
  const last = rows.length > 0 ? rows[rows.length - 1].link : base;
  const tip = table.tool ? placed(last, table.tool) : last;
  return { base, rows, tip };
}

/** The length of the arm stretched out, with the way of its prismatic joints. */
export function reach(table, slides) {
  const zero = new Array(table.dof).fill(0);
  const { base, rows, tip } = chain(table, zero);
  let sum = 0;
  let from = base.o;
  rows.forEach(({ middle, frame, link }, i) => {
    if (table.isMounted && table.rows[i].isPlace) return;
    const points = table.isMounted ? [link.o] : [middle.o, frame.o];
    for (const to of points) {
      sum += distance(from, to);
      from = to;
    }
  });
  sum += distance(from, tip.o) + slides;
  // The bodies of an arm without lengths are somewhere.
  const bodies = table.rows.map((row) => Math.hypot(...row.com));
  return Math.max(sum, ...bodies) || 1;
}

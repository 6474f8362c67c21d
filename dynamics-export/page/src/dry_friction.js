// Dry friction of the joints, with those of the joints that follow them: a joint slides one way, or sticks.

/** Of each joint, and of the freedoms of the base before them, the rows that move with it and by which factor. */
function members(table) {
  const all = Array.from({ length: table.dof }, () => []);
  const ofBase = table.dof - table.joints;
  for (const row of table.rows) {
    if (row.joint !== null) all[ofBase + row.joint].push({ row, factor: 1 });
    else if (row.follows) all[ofBase + row.follows.joint].push({ row, factor: row.follows.factor });
  }
  return all;
}

/** Coulomb friction of a row that slides one way, and static friction that holds it from that way. */
const sliding = (row, way) => (way > 0 ? row.coulomb[0] : row.coulomb[1]);
const holding = (row, way) => (row.stribeck ? row.stribeck.friction : sliding(row, way));

/** The friction of an arm's table. */
export function dryFriction(table) {
  const joints = members(table);
  return {
    /** Whether a joint has dry friction at all. */
    isDry: joints.map((rows) =>
      rows.some(({ row }) => row.coulomb[0] !== 0 || row.coulomb[1] !== 0 || row.stribeck !== null),
    ),

    /** The force or torque that a joint at rest is held by at most, from moving one way. */
    breakaway: (joint, way) =>
      joints[joint].reduce((sum, { row, factor }) => {
        return sum + Math.abs(factor) * holding(row, way * Math.sign(factor));
      }, 0),

    /**
     * F = k (viscous k qd + s (C + (S - C) exp(-(k qd / v)^2))), s the sign of k times the way: friction
     * of a joint that slides one way, whatever the sign of its velocity is.
     */
    sliding: (joint, way, qd) =>
      joints[joint].reduce((sum, { row, factor }) => {
        const speed = factor * qd;
        const sense = Math.sign(factor) * way;
        const coulomb = sliding(row, sense);
        const falls = row.stribeck
          ? (row.stribeck.friction - coulomb) * Math.exp(-((speed / row.stribeck.velocity) ** 2))
          : 0;
        return sum + factor * (row.viscous * speed + sense * (coulomb + falls));
      }, 0),
  };
}

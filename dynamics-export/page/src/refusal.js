// Why the numbers of a table are none of a robot, in the words of the reader of tables.

/** All numbers in a value. */
const numbersOf = (value) =>
  typeof value === "number" ? [value] : value && typeof value === "object" ? Object.values(value).flatMap(numbersOf) : [];

/** Whether every principal minor of the symmetric matrix xx, yy, zz, xy, yz, xz is at least zero, but for rounding. */
function isSemidefinite([a, b, c, f, g, h], size) {
  const minors = [
    [[a, b, c], size],
    [[a * b - f * f, b * c - g * g, a * c - h * h], size ** 2],
    [[a * (b * c - g * g) - f * (f * c - g * h) + h * (f * g - b * h)], size ** 3],
  ];
  return minors.every(([values, scale]) => values.every((x) => x >= -1e-9 * scale));
}

/** Why no body has a tensor: tr(J)/2 1 - J is positive semidefinite (Wensing, Kim and Slotine 2018), and so is J. */
function tensorRefusal([xx, yy, zz, xy, yz, xz]) {
  const size = Math.max(...[xx, yy, zz, xy, yz, xz].map(Math.abs));
  // One moment alone is that about the axis of a planar arm.
  if ([xx, yy, zz].filter((x) => x !== 0).length < 2 && Math.min(xx, yy, zz) >= 0 && xy === 0 && yz === 0 && xz === 0) return null;
  const half = (xx + yy + zz) / 2;
  const isPossible =
    isSemidefinite([xx, yy, zz, xy, yz, xz], size) &&
    isSemidefinite([half - xx, half - yy, half - zz, -xy, -yz, -xz], size);
  return isPossible ? null : "no body has this inertia tensor";
}

/** Why a row or the tool is none. */
function partRefusal(part) {
  if (numbersOf(part).some((x) => !Number.isFinite(x))) return "division by zero, or a number that is too large";
  const negative = [
    [part.mass, "a mass"],
    [part.motorInertia, "a motor's inertia"],
    [part.viscous, "a friction coefficient"],
    [Math.min(...(part.coulomb ?? [])), "a friction torque or force"],
    [part.stribeck?.friction, "a friction torque or force"],
    [part.spring?.stiffness, "a spring's stiffness"],
  ].find(([value]) => value < 0);
  if (negative) return `${negative[1]} cannot be negative`;
  if (part.motorInertia > 0 && part.gearRatio === 0) return "a gear ratio of zero: a motor with inertia turns with its joint";
  if (part.stribeck && !(part.stribeck.velocity > 0)) return "a Stribeck velocity is above zero";
  return tensorRefusal(part.inertia);
}

/** Why a table is none of a robot: null where it is one. What is odd in `first` as well is meant. */
export function refusal(table, first) {
  const parts = ({ rows, tool, base, floating, gravity }) => [...rows, tool, floating, base && { inertia: [0, 0, 0, 0, 0, 0], base }, { inertia: [0, 0, 0, 0, 0, 0], gravity }];
  const known = parts(first);
  for (const [k, part] of parts(table).entries()) {
    const reason = part && partRefusal(part);
    if (reason && reason !== partRefusal(known[k])) return part.name ? `\`${part.name}\`: ${reason}` : reason;
  }
  return null;
}

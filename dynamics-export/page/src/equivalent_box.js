// The box of even density that has the mass and the inertia of a body.

const PAIRS = [[0, 1], [0, 2], [1, 2]];

/** Moments and axes, as columns, of the symmetric matrix xx, yy, zz, xy, yz, xz: Jacobi's rotations. */
function principal([xx, yy, zz, xy, yz, xz]) {
  const a = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
  const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  for (let sweep = 0; sweep < 12; sweep++) {
    for (const [p, q] of PAIRS) {
      if (a[p][q] === 0) continue;
      const angle = Math.atan2(2 * a[p][q], a[q][q] - a[p][p]) / 2;
      const [s, c] = [Math.sin(angle), Math.cos(angle)];
      const turn = (matrix) => matrix.forEach((row) => ([row[p], row[q]] = [c * row[p] - s * row[q], s * row[p] + c * row[q]]));
      turn(a);
      [a[p], a[q]] = [a[p].map((x, k) => c * x - s * a[q][k]), a[p].map((x, k) => s * x + c * a[q][k])];
      turn(axes);
    }
  }
  return { moments: [a[0][0], a[1][1], a[2][2]], axes };
}

/** Half of the box's lengths along its axes: l_x^2 = 6 (I_y + I_z - I_x) / m. A side that no body has is zero. */
export function equivalentBox({ mass, inertia }) {
  const { moments, axes } = principal(inertia);
  const sum = moments[0] + moments[1] + moments[2];
  const half = moments.map((moment) => (mass > 0 ? Math.sqrt(Math.max(0, (6 * (sum - 2 * moment)) / mass)) / 2 : 0));
  const [x, y, z] = [0, 1, 2].map((k) => axes.map((row) => row[k]));
  return { x, y, z, half };
}

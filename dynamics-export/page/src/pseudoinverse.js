// Singular values of small matrices, which are given by their columns, and what solves their equations by least squares.

const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);

/** A = U S V' by one-sided Jacobi rotations (Hestenes 1958): triples of a value, its u and its v, the greatest value first. */
export function singularValues(columns) {
  const a = columns.map((column) => [...column]);
  const v = columns.map((_, i) => columns.map((__, j) => (i === j ? 1 : 0)));
  const turn = (list, i, j, c, s) => {
    const [x, y] = [list[i], list[j]];
    list[i] = x.map((one, k) => c * one - s * y[k]);
    list[j] = x.map((one, k) => s * one + c * y[k]);
  };
  let isDone = false;
  for (let sweep = 0; sweep < 40 && !isDone; sweep++) {
    isDone = true;
    for (let i = 0; i < a.length; i++) {
      for (let j = 0; j < i; j++) {
        const [x, y, mixed] = [dot(a[j], a[j]), dot(a[i], a[i]), dot(a[j], a[i])];
        if (Math.abs(mixed) <= 1e-15 * Math.sqrt(x * y)) continue;
        isDone = false;
        const half = (y - x) / (2 * mixed);
        const tangent = (half < 0 ? -1 : 1) / (Math.abs(half) + Math.hypot(1, half));
        const c = 1 / Math.hypot(1, tangent);
        [a, v].forEach((list) => turn(list, j, i, c, c * tangent));
      }
    }
  }
  const triples = a.map((column, i) => ({ value: Math.sqrt(dot(column, column)), u: column, v: v[i] }));
  triples.forEach((one) => (one.u = one.u.map((x) => x / (one.value || 1))));
  return triples.sort((one, other) => other.value - one.value);
}

/** The sum of the triples' `to`, each times what `from` has of x over the singular value: A^+ x from u to v. */
export const throughInverse = (triples, from, to, x) =>
  triples.reduce((sum, one) => sum.map((y, k) => y + (dot(one[from], x) / one.value) * one[to][k]), triples[0][to].map(() => 0));

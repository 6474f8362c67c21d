// Symmetric positive definite systems of equations.

/** A matrix that is not positive definite: the index of the first row that shows it. */
export class NotPositiveDefinite extends Error {
  constructor(index) {
    super(`not positive definite at index ${index}`);
    this.joint = index;
  }
}

/** x of A x = b by A = L L', rows and columns of `indices` alone. */
export function solved(a, b, indices) {
  const n = indices.length;
  const l = indices.map(() => new Array(n).fill(0));
  const x = indices.map((i) => b[i]);
  for (let i = 0; i < n; i++) {
    for (let j = 0; j <= i; j++) {
      let sum = a[indices[i]][indices[j]];
      for (let k = 0; k < j; k++) sum -= l[i][k] * l[j][k];
      // What is left of a diagonal entry that cancels is rounding.
      if (i === j && !(sum > 1e-14 * Math.abs(a[indices[i]][indices[i]]))) throw new NotPositiveDefinite(indices[i]);
      l[i][j] = i === j ? Math.sqrt(sum) : sum / l[j][j];
    }
    for (let k = 0; k < i; k++) x[i] -= l[i][k] * x[k];
    x[i] /= l[i][i];
  }
  for (let i = n - 1; i >= 0; i--) {
    for (let k = i + 1; k < n; k++) x[i] -= l[k][i] * x[k];
    x[i] /= l[i][i];
  }
  return x;
}

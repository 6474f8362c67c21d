// DOP853 (Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, section II.5) with steps
// that end where they are asked to.

import { FIFTH, STAGES, THIRD, TIMES } from "./dop853_tableau.js";

/** Relative and absolute tolerance of a step. */
const TOLERANCE = 1e-10;

/** y + h times the weighted sum of rates. */
function combined(y, h, weights, rates) {
  const sum = Float64Array.from(y);
  for (const [stage, weight] of weights) {
    const rate = rates[stage];
    for (let i = 0; i < sum.length; i++) sum[i] += h * weight * rate[i];
  }
  return sum;
}

/** A step of size h: where it ends, and its estimated error, 1 at the tolerance. */
export function trial(rate, t, y, first, h) {
  const rates = [first];
  for (let i = 1; i < TIMES.length; i++) {
    rates.push(rate(t + TIMES[i] * h, combined(y, h, STAGES[i], rates)));
  }
  const end = combined(y, h, STAGES[12], rates);
  const zero = new Float64Array(y.length);
  const eighth = combined(zero, 1, STAGES[12], rates);
  const third = combined(zero, 1, THIRD, rates);
  const fifth = combined(zero, 1, FIFTH, rates);
  let [of5, of3] = [0, 0];
  for (let i = 0; i < y.length; i++) {
    const size = TOLERANCE * (1 + Math.max(Math.abs(y[i]), Math.abs(end[i])));
    of5 += (fifth[i] / size) ** 2 / y.length;
    of3 += ((eighth[i] - third[i]) / size) ** 2 / y.length;
  }
  // h e5^2 / sqrt(e5^2 + 0.01 e3^2), section II.10, (10.17).
  const error = of5 === 0 ? 0 : (h * of5) / Math.sqrt(of5 + 0.01 * of3);
  return { end, error };
}

/** The factor of the step size behind an error. */
export function factor(error, wasRejected) {
  if (!Number.isFinite(error)) return 1 / 3;
  const wish = 0.9 * error ** (-1 / 8);
  return Math.min(Math.max(wish, 1 / 3), wasRejected ? 1 : 6);
}

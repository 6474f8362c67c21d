// Motions from rest to rest: the way s from 0 to 1 at u = t / T, and its two derivatives by u.

const TURN = 2 * Math.PI;

export const PROFILES = {
  cycloidal: (u) => [u - Math.sin(TURN * u) / TURN, 1 - Math.cos(TURN * u), TURN * Math.sin(TURN * u)],
  quintic: (u) => [
    u ** 3 * (10 + u * (6 * u - 15)),
    30 * u ** 2 * (1 - u) ** 2,
    60 * u * (1 - u) * (1 - 2 * u),
  ],
  cubic: (u) => [u * u * (3 - 2 * u), 6 * u * (1 - u), 6 - 12 * u],
};

/** Positions, velocities and accelerations at a time. */
export function prescribed({ from, to, duration, profile }, t) {
  const [s, rate, bend] = PROFILES[profile](Math.min(Math.max(t / duration, 0), 1));
  const each = (f) => from.map((start, i) => f(to[i] - start, start));
  return {
    q: each((way, start) => start + way * s),
    qd: each((way) => (way * rate) / duration),
    qdd: each((way) => (way * bend) / duration ** 2),
  };
}

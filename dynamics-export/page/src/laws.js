// Laws of the torques of free motion: forces at the base of a robot whose base moves, and torques of the joints.

import { FREEDOMS } from "./moving_base.js";
import { solved } from "./linear.js";

const BASE = FREEDOMS.map((_, k) => k);

export const LAWS = {
  none: () => (base, q, v) => v.map(() => 0),
  constant: ({ torque }) => () => torque,

  /** G + K: the robot floats. */
  gravity: ({ equations }) => (base, q) => {
    const spring = equations.spring_vector(q);
    return equations.gravity_vector(base, q).map((g, i) => g + spring[i]);
  },

  /** Nothing acts on the base, and torques let no joint accelerate: M_bb a + (V + G)_b = 0. */
  steady: ({ equations, hasFriction }) => (base, q, v) => {
    const bias = equations.inverse_dynamics(base, q, v, v.map(() => 0));
    const mass = equations.mass_matrix(q);
    const a = solved(mass, bias.map((x) => -x), BASE);
    const friction = hasFriction ? null : equations.friction_vector(v);
    return bias.map((x, i) => {
      if (i < BASE.length) return 0;
      return BASE.reduce((sum, k) => sum + mass[i][k] * a[k], x - (friction?.[i] ?? 0));
    });
  },
};

/** The laws that a robot is offered, with what the page calls them. */
export function lawsOf({ floating }) {
  const none = "none: free fall";
  if (!floating) return { none, constant: "constant", gravity: "G + K: the arm floats" };
  return {
    none,
    steady: "of joints: they keep their velocities",
    constant: "constant, on the base too",
    gravity: "G + K, on the base too: the robot floats",
  };
}

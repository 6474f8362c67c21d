// The functions of the generated module for the present values of the fields.

import { momentum } from "./momentum.js";

/** The functions that do not depend on where the base is. */
const WITHOUT_BASE = ["mass_matrix", "coriolis_vector", "kinetic_energy", "friction_vector", "spring_vector"];

/**
 * Each function of the module; where the robot has fields, `fields` is their argument. All but those without it take the
 * pose of the base first, which is left out of calls where `isFloating` is not so.
 */
export function bind(module, fields, isFloating) {
  const names = Object.keys(module).filter((name) => /^[a-z]/.test(name));
  const hasFields = module.FIELD_NAMES !== undefined;
  const bound = (name) => {
    const call = hasFields ? (...given) => module[name](fields, ...given) : module[name];
    return isFloating || WITHOUT_BASE.includes(name) ? call : (_base, ...given) => call(...given);
  };
  return Object.fromEntries(names.map((name) => [name, bound(name)]));
}

/** What the page shows of a state: all terms of M qdd + V + G + K + F = tau, a tip by its function, and the energies. */
export function evaluate(equations, { base, q, qd, qdd, tau, friction: acting }, { key }) {
  const gravity = equations.gravity_vector(base, q);
  const friction = equations.friction_vector(qd);
  const spring = equations.spring_vector(q);
  const mass = equations.mass_matrix(q);
  const still = equations.inverse_dynamics(base, q, qd, qd.map(() => 0));
  return {
    base,
    q,
    qd,
    qdd,
    tau,
    mass,
    momentum: base && momentum(base, mass, qd),
    // V = tau(q, qd, 0) - G - K - F: a function of its own would be longer than all of these.
    coriolis: still.map((sum, i) => sum - gravity[i] - spring[i] - friction[i]),
    gravity,
    // Of a free motion what acts: nothing where friction is left out, and what holds a joint that sticks.
    friction: acting ?? friction,
    spring,
    tip: equations[key](base, q),
    kinetic: equations.kinetic_energy(q, qd),
    potential: equations.potential_energy(base, q),
  };
}

// The functions of the generated module for the present values of the fields.

/** Each function of the module; where the arm has fields, `fields` is their argument. */
export function bind(module, fields) {
  const names = Object.keys(module).filter((name) => /^[a-z]/.test(name));
  const hasFields = module.FIELD_NAMES !== undefined;
  const bound = (name) => (hasFields ? (...given) => module[name](fields, ...given) : module[name]);
  return Object.fromEntries(names.map((name) => [name, bound(name)]));
}

/** What the page shows of a state: all terms of M qdd + V + G + K + F = tau, a tip by its function, and the energies. */
export function evaluate(equations, { q, qd, qdd, tau }, { key }) {
  const gravity = equations.gravity_vector(q);
  const friction = equations.friction_vector(qd);
  const spring = equations.spring_vector(q);
  const still = equations.inverse_dynamics(q, qd, q.map(() => 0));
  return {
    q,
    qd,
    qdd,
    tau,
    mass: equations.mass_matrix(q),
    // V = tau(q, qd, 0) - G - K - F: a function of its own would be longer than all of these.
    coriolis: still.map((sum, i) => sum - gravity[i] - spring[i] - friction[i]),
    gravity,
    friction,
    spring,
    tip: equations[key](q),
    kinetic: equations.kinetic_energy(q, qd),
    potential: equations.potential_energy(q),
  };
}

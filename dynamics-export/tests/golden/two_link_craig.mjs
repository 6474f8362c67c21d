/**
 * Equations of motion of `two_link_craig`, written by robot-dynamics.
 *
 * Each function is proven equal to the textbook Lagrangian. SI units, radians; vectors are arrays,
 * matrices arrays of rows. A value that depends on an input that is not finite is not finite.
 */

/** Number of joints that move. */
export const DOF = 2;

/** Names of the joints that move, from the base outwards. */
export const JOINT_NAMES = ["joint1", "joint2"];

/** The symbolic parameters: properties of the first argument, `arm`, of every function. */
export const FIELD_NAMES = ["m1", "m2", "l1", "l2", "g"];

/** M(q) is not positive definite to working precision, or not finite: the pivot of a joint failed. */
export class SingularMassMatrix extends Error {
  /** @param {number} joint the joint, counted from 0 */
  constructor(joint) {
    super(`the mass matrix is not positive definite at joint ${joint + 1} \`${JOINT_NAMES[joint]}\``);
    this.name = "SingularMassMatrix";
    this.joint = joint;
  }
}

/** Whether a pivot of M is greater than the rounding errors of its diagonal entry. */
function assertPivot(joint, pivot, diagonal) {
  const rounding = diagonal * 2.220446049250313e-16 * 8;
  if (!(pivot - rounding > 0 && pivot + rounding > 0)) throw new SingularMassMatrix(joint);
}

/**
 * Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
 *
 * `q`: joint positions, rad.
 *
 * Operations: 6 multiplications, 4 additions, sine and cosine of one angle.
 *
 * M22 is constant; M11, M12 depend on q2.
 *
 * M11 = l1^2 (m1 + m2) + m2 l2^2 + 2 m2 l1 l2 c2
 * M12 = m2 l2^2 + m2 l1 l2 c2
 * M21 = m2 l2^2 + m2 l1 l2 c2
 * M22 = m2 l2^2
 * with c2 = cos(q2)
 */
export function mass_matrix(arm, q) {
  const p_m1 = arm.m1;
  const p_m2 = arm.m2;
  const p_l1 = arm.l1;
  const p_l2 = arm.l2;
  const c_2 = Math.cos(q[1]);
  const t_1 = p_m2 * p_l2;
  const t_2 = c_2 * t_1;
  const t_3 = p_l1 * t_2;
  const t_4 = p_m1 + p_m2;
  const t_5 = p_l1 * t_4;
  const t_6 = p_l2 * t_1;
  const t_7 = t_6 + t_3;
  const t_8 = p_l1 * t_5 + t_3;
  const t_9 = t_7 + t_8;
  return [[t_9, t_7], [t_7, t_6]];
}

/**
 * Coriolis and centrifugal vector V(q, qd), N m or N: inverse dynamics without gravity, springs, friction and acceleration.
 *
 * `q`: joint positions, rad; `qd`: joint velocities, rad per s.
 *
 * Operations: 7 multiplications, 2 additions, sine and cosine of one angle.
 *
 * V2 depends on q2, qd1; V1 depends on q2, qd1, qd2.
 *
 * V1 = -2 m2 l1 l2 s2 qd1 qd2 - m2 l1 l2 s2 qd2^2
 * V2 = m2 l1 l2 s2 qd1^2
 * with s2 = sin(q2)
 */
export function coriolis_vector(arm, q, qd) {
  const p_m2 = arm.m2;
  const p_l1 = arm.l1;
  const p_l2 = arm.l2;
  const s_2 = Math.sin(q[1]);
  const qd_1 = qd[0];
  const qd_2 = qd[1];
  const t_1 = p_m2 * p_l2;
  const t_2 = p_l1 * s_2;
  const t_3 = t_1 * t_2;
  const t_4 = qd_1 * t_3;
  const t_5 = qd_2 * t_3 + t_4;
  const t_6 = t_4 + t_5;
  const t_7 = qd_2 * t_6;
  const t_8 = qd_1 * t_4;
  return [-t_7, t_8];
}

/**
 * Gravity vector G(q), N m or N: the gradient of the potential energy of gravity, inverse dynamics at rest without springs.
 *
 * `q`: joint positions, rad.
 *
 * Operations: 8 multiplications, 3 additions, sines and cosines of 2 angles.
 *
 * G1, G2 depend on q1, q2.
 *
 * G1 = l1 g (m1 + m2) c1 + m2 l2 g c12
 * G2 = m2 l2 g c12
 * with c1 = cos(q1), c12 = cos(q1 + q2)
 */
export function gravity_vector(arm, q) {
  const p_m1 = arm.m1;
  const p_m2 = arm.m2;
  const p_l1 = arm.l1;
  const p_l2 = arm.l2;
  const p_g = arm.g;
  const c_1 = Math.cos(q[0]);
  const s_1 = Math.sin(q[0]);
  const c_2 = Math.cos(q[1]);
  const s_2 = Math.sin(q[1]);
  const t_1 = p_m1 + p_m2;
  const t_2 = p_l1 * t_1;
  const t_3 = p_m2 * p_l2;
  const t_4 = c_1 * c_2 - s_1 * s_2;
  const t_5 = t_3 * t_4;
  const t_6 = c_1 * t_2 + t_5;
  const t_7 = p_g * t_6;
  const t_8 = p_g * t_5;
  return [t_7, t_8];
}

/**
 * Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd), N m or N, as one program; K is of springs, F of friction.
 *
 * `q`: joint positions, rad; `qd`: joint velocities, rad per s; `qdd`: joint accelerations, rad per s^2.
 *
 * Operations: 18 multiplications, 10 additions, sines and cosines of 2 angles.
 *
 * tau1 depends on q1, q2, qd1, qd2, qdd1, qdd2; tau2 depends on q1, q2, qd1, qdd1, qdd2.
 *
 * tau1 = l1 g (m1 + m2) c1 + m2 l2 g c12 - 2 m2 l1 l2 s2 qd1 qd2 - m2 l1 l2 s2 qd2^2 + (l1^2 (m1 + m2) + m2 l2^2 + 2 m2 l1 l2 c2) qdd1 + (m2 l2^2 + m2 l1 l2 c2) qdd2
 * tau2 = m2 l2 g c12 + m2 l1 l2 s2 qd1^2 + (m2 l2^2 + m2 l1 l2 c2) qdd1 + m2 l2^2 qdd2
 * with c1 = cos(q1), c12 = cos(q1 + q2), c2 = cos(q2), s2 = sin(q2)
 */
export function inverse_dynamics(arm, q, qd, qdd) {
  const p_m1 = arm.m1;
  const p_m2 = arm.m2;
  const p_l1 = arm.l1;
  const p_l2 = arm.l2;
  const p_g = arm.g;
  const c_1 = Math.cos(q[0]);
  const s_1 = Math.sin(q[0]);
  const c_2 = Math.cos(q[1]);
  const s_2 = Math.sin(q[1]);
  const qd_1 = qd[0];
  const qd_2 = qd[1];
  const qdd_1 = qdd[0];
  const qdd_2 = qdd[1];
  const t_1 = p_m2 * p_l2;
  const t_2 = c_2 * t_1;
  const t_3 = qdd_1 + qdd_2;
  const t_4 = s_2 * t_1;
  const t_5 = qd_1 + qd_2;
  const t_6 = t_5 * t_5;
  const t_7 = t_2 * t_3 - t_4 * t_6;
  const t_8 = p_m1 + p_m2;
  const t_9 = p_l1 * t_8;
  const t_10 = p_l1 * qdd_1 + p_g * c_1;
  const t_11 = qd_1 * qd_1;
  const t_12 = p_g * s_1 - p_l1 * t_11;
  const t_13 = p_l2 * t_1;
  const t_14 = t_13 * t_3 + t_2 * t_10;
  const t_15 = t_14 - t_4 * t_12;
  const t_16 = t_9 * t_10 + p_l1 * t_7;
  const t_17 = t_15 + t_16;
  return [t_17, t_15];
}

/**
 * Forward dynamics: the accelerations qdd with M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau, rad/s^2 or m/s^2; K is of springs, F of friction.
 *
 * `q`: joint positions, rad; `qd`: joint velocities, rad per s; `tau`: joint forces and torques, N m.
 *
 * Operations: 23 multiplications, 14 additions, 2 divisions, sines and cosines of 2 angles.
 *
 * Throws `SingularMassMatrix` where M(q) is not positive definite to working precision or not finite.
 */
export function forward_dynamics(arm, q, qd, tau) {
  const p_m1 = arm.m1;
  const p_m2 = arm.m2;
  const p_l1 = arm.l1;
  const p_l2 = arm.l2;
  const p_g = arm.g;
  const c_1 = Math.cos(q[0]);
  const s_1 = Math.sin(q[0]);
  const s_2 = Math.sin(q[1]);
  const c_2 = Math.cos(q[1]);
  const qd_1 = qd[0];
  const qd_2 = qd[1];
  const tau_1 = tau[0];
  const tau_2 = tau[1];
  const t_1 = p_m2 * p_l2;
  const t_2 = s_2 * t_1;
  const t_3 = qd_1 + qd_2;
  const t_4 = t_3 * t_3;
  const t_5 = t_2 * t_4;
  const t_6 = c_2 * t_1;
  const t_7 = p_g * c_1;
  const t_8 = qd_1 * qd_1;
  const t_9 = p_g * s_1 - p_l1 * t_8;
  const t_10 = t_6 * t_7 - t_2 * t_9;
  const t_11 = p_m1 + p_m2;
  const t_12 = p_l1 * t_11;
  const t_13 = t_10 - tau_2;
  const t_14 = p_l2 * t_1;
  const t_15 = p_l1 * t_6;
  const t_16 = t_14 + t_15;
  const t_17 = 1.0 / t_14;
  const t_18 = t_16 * t_17;
  const t_19 = tau_1 - t_12 * t_7;
  const t_20 = p_l1 * t_5 + t_19;
  const t_21 = t_20 - t_10;
  const t_22 = t_13 * t_18 + t_21;
  const t_23 = p_l1 * t_12 + t_15;
  const t_24 = t_16 + t_23;
  const t_25 = t_24 - t_16 * t_18;
  const t_26 = 1.0 / t_25;
  const t_27 = t_22 * t_26;
  const t_28 = t_13 * t_17 + t_18 * t_27;
  assertPivot(1, t_14, t_14);
  assertPivot(0, t_25, t_24);
  return [t_27, -t_28];
}

/**
 * Kinetic energy T(q, qd) = 1/2 qd^T M(q) qd, reflected motor inertias included, J.
 *
 * `q`: joint positions, rad; `qd`: joint velocities, rad per s.
 *
 * Operations: 11 multiplications, 4 additions, sine and cosine of one angle.
 *
 * T = (1/2 l1^2 (m1 + m2) + 1/2 m2 l2^2 + m2 l1 l2 c2) qd1^2 + (m2 l2^2 + m2 l1 l2 c2) qd1 qd2 + 1/2 m2 l2^2 qd2^2
 * with c2 = cos(q2)
 */
export function kinetic_energy(arm, q, qd) {
  const p_m1 = arm.m1;
  const p_m2 = arm.m2;
  const p_l1 = arm.l1;
  const p_l2 = arm.l2;
  const c_2 = Math.cos(q[1]);
  const qd_1 = qd[0];
  const qd_2 = qd[1];
  const t_1 = p_m2 * p_l2;
  const t_2 = p_l1 * qd_1;
  const t_3 = c_2 * t_2;
  const t_4 = qd_1 + qd_2;
  const t_5 = t_3 * t_4;
  const t_6 = p_m1 + p_m2;
  const t_7 = t_6 * t_2;
  const t_8 = p_l2 * t_1;
  const t_9 = t_8 * t_4;
  const t_10 = t_2 * t_7 + t_4 * t_9;
  const t_11 = 0.5 * t_10 + t_1 * t_5;
  return t_11;
}

/**
 * Potential energy U(q) = -sum m g.c, zero at the origin of the base frame, and that of springs, 1/2 stiffness (q - rest)^2, J.
 *
 * `q`: joint positions, rad.
 *
 * Operations: 7 multiplications, 3 additions, sines and cosines of 2 angles.
 *
 * U = l1 g (m1 + m2) s1 + m2 l2 g s12
 * with s1 = sin(q1), s12 = sin(q1 + q2)
 */
export function potential_energy(arm, q) {
  const p_m1 = arm.m1;
  const p_m2 = arm.m2;
  const p_l1 = arm.l1;
  const p_l2 = arm.l2;
  const p_g = arm.g;
  const s_1 = Math.sin(q[0]);
  const c_1 = Math.cos(q[0]);
  const c_2 = Math.cos(q[1]);
  const s_2 = Math.sin(q[1]);
  const t_1 = p_m1 + p_m2;
  const t_2 = p_m2 * p_l2;
  const t_3 = p_l1 * t_1 + c_2 * t_2;
  const t_4 = s_2 * t_2;
  const t_5 = c_1 * t_4 + s_1 * t_3;
  const t_6 = p_g * t_5;
  return t_6;
}

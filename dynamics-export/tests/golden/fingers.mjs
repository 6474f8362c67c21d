/**
 * Equations of motion of `Fingers`, written by robot-dynamics.
 *
 * Each function is proven equal to the textbook Lagrangian. SI units, radians; vectors are arrays,
 * matrices arrays of rows. A value that depends on an input that is not finite is not finite.
 */

/** Number of joints that move. */
export const DOF = 2;

/** Names of the joints that move, from the base outwards. */
export const JOINT_NAMES = ["left", "right"];

/** The symbolic parameters: properties of the first argument, `arm`, of every function. */
export const FIELD_NAMES = ["width", "length"];

/**
 * Forward kinematics: the homogeneous transform of the frame `Right tip` in the base frame, m.
 *
 * `q`: joint positions, rad.
 *
 * Operations: 2 multiplications, 1 addition, sine and cosine of one angle.
 *
 * T13, T23, T31, T32, T34, T41, T42, T43 are zero; T33, T44 are constant; T11, T12, T14, T21, T22, T24 depend on q2.
 *
 * T11 = c2
 * T12 = -s2
 * T13 = 0
 * T14 = width + length c2
 * T21 = s2
 * T22 = c2
 * T23 = 0
 * T24 = length s2
 * T31 = 0
 * T32 = 0
 * T33 = 1
 * T34 = 0
 * T41 = 0
 * T42 = 0
 * T43 = 0
 * T44 = 1
 * with c2 = cos(q2), s2 = sin(q2)
 */
export function forward_kinematics_right_tip(arm, q) {
  const p_width = arm.width;
  const p_length = arm.length;
  const c_2 = Math.cos(q[1]);
  const s_2 = Math.sin(q[1]);
  const t_1 = p_length * c_2 + p_width;
  const t_2 = p_length * s_2;
  return [[c_2, -s_2, 0.0, t_1], [s_2, c_2, 0.0, t_2], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
}

/**
 * Geometric Jacobian of the frame `Left tip`'s origin, 6 x N, rows vx vy vz wx wy wz, in the base frame.
 *
 * `q`: joint positions, rad.
 *
 * Operations: 2 multiplications, 0 additions, sine and cosine of one angle.
 *
 * J12, J22, J31, J32, J41, J42, J51, J52, J62 are zero; J61 is constant; J11, J21 depend on q1.
 *
 * J11 = -length s1
 * J12 = 0
 * J21 = length c1
 * J22 = 0
 * J31 = 0
 * J32 = 0
 * J41 = 0
 * J42 = 0
 * J51 = 0
 * J52 = 0
 * J61 = 1
 * J62 = 0
 * with c1 = cos(q1), s1 = sin(q1)
 */
export function jacobian_left_tip(arm, q) {
  const p_length = arm.length;
  const s_1 = Math.sin(q[0]);
  const c_1 = Math.cos(q[0]);
  const t_1 = p_length * s_1;
  const t_2 = p_length * c_1;
  return [[-t_1, 0.0], [t_2, 0.0], [0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [1.0, 0.0]];
}

/**
 * Joint torques J(q)^T w of a wrench at the frame `Right tip`, N m or N, without J: M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau + J(q)^T w.
 *
 * `q`: joint positions, rad; `wrench`: force (N) on the frame `Right tip` and moment (N m) about its origin, fx fy fz nx ny nz in the axes of `jacobian`, that the surroundings apply.
 *
 * Operations: 3 multiplications, 2 additions, sine and cosine of one angle.
 */
export function wrench_torques_right_tip(arm, q, wrench) {
  const p_length = arm.length;
  const c_2 = Math.cos(q[1]);
  const s_2 = Math.sin(q[1]);
  const wrench_1 = wrench[0];
  const wrench_2 = wrench[1];
  const wrench_6 = wrench[5];
  const t_1 = c_2 * wrench_2 - s_2 * wrench_1;
  const t_2 = p_length * t_1 + wrench_6;
  return [0.0, t_2];
}

/**
 * (`mass_matrix`, `jacobian_left_tip`, `jacobian_right_tip`) at one state, as one program.
 *
 * - `0`: Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
 * - `1`: Geometric Jacobian of the frame `Left tip`'s origin, 6 x N, rows vx vy vz wx wy wz, in the base frame.
 * - `2`: Geometric Jacobian of the frame `Right tip`'s origin, 6 x N, rows vx vy vz wx wy wz, in the base frame.
 *
 * `q`: joint positions, rad.
 *
 * Operations: 5 multiplications, 0 additions, sines and cosines of 2 angles.
 *
 * M11, M12 are zero; M22 is constant.
 *
 * `jacobian_left_tip`: J12, J22, J31, J32, J41, J42, J51, J52, J62 are zero; J61 is constant; J11, J21 depend on q1.
 *
 * `jacobian_right_tip`: J11, J21, J31, J32, J41, J42, J51, J52, J61 are zero; J62 is constant; J12, J22 depend on q2.
 *
 * M11 = 0
 * M12 = 0
 * M21 = 0
 * M22 = length^2
 */
export function pinch(arm, q) {
  const p_length = arm.length;
  const s_1 = Math.sin(q[0]);
  const c_1 = Math.cos(q[0]);
  const s_2 = Math.sin(q[1]);
  const c_2 = Math.cos(q[1]);
  const t_1 = p_length * p_length;
  const t_2 = p_length * s_1;
  const t_3 = p_length * c_1;
  const t_4 = p_length * s_2;
  const t_5 = p_length * c_2;
  return [[[0.0, 0.0], [0.0, t_1]], [[-t_2, 0.0], [t_3, 0.0], [0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [1.0, 0.0]], [[0.0, -t_4], [0.0, t_5], [0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [0.0, 1.0]]];
}
